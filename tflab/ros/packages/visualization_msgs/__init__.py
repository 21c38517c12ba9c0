"""visualization_msgs, in process: see tflab.ros.messages.visualization_msgs."""
