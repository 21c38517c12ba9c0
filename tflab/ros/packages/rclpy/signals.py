"""rclpy.signals"""

from tflab.ros.signals import (
    SignalHandlerOptions as SignalHandlerOptions,
    install_signal_handlers as install_signal_handlers,
    uninstall_signal_handlers as uninstall_signal_handlers,
)
