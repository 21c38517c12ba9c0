"""action_msgs, in process: see tflab.ros.messages.action_msgs."""
