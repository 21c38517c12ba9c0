"""sensor_msgs, in process: see tflab.ros.messages.sensor_msgs."""
