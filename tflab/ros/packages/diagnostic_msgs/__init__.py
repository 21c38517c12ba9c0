"""diagnostic_msgs, in process: see tflab.ros.messages.diagnostic_msgs."""
