"""rcl_interfaces, in process: see tflab.ros.messages.rcl_interfaces."""
