"""std_msgs, in process: see tflab.ros.messages.std_msgs."""
