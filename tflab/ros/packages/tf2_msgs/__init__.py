"""tf2_msgs, in process: see tflab.ros.messages.tf2_msgs."""
