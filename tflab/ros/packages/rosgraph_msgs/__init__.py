"""rosgraph_msgs, in process: see tflab.ros.messages.rosgraph_msgs."""
