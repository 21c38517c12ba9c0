"""geometry_msgs, in process: see tflab.ros.messages.geometry_msgs."""
