"""example_interfaces, in process: see tflab.ros.messages.example_interfaces."""
