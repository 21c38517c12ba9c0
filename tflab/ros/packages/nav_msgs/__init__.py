"""nav_msgs, in process: see tflab.ros.messages.nav_msgs."""
