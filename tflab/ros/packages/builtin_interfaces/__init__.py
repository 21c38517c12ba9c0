"""builtin_interfaces, in process: see tflab.ros.messages.builtin_interfaces."""
