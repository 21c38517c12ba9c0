"""trajectory_msgs, in process: see tflab.ros.messages.trajectory_msgs."""
