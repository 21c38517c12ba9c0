"""lifecycle_msgs, in process: see tflab.ros.messages.lifecycle_msgs."""
