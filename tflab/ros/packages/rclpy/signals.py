"""rclpy.signals"""

from tflab.ros.signals import SignalHandlerOptions, install_signal_handlers, uninstall_signal_handlers

__all__ = [
    "SignalHandlerOptions",
    "install_signal_handlers",
    "uninstall_signal_handlers",
]
