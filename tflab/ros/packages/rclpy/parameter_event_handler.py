"""rclpy.parameter_event_handler"""

from tflab.ros.parameter_event_handler import (
    ParameterCallbackHandle as ParameterCallbackHandle,
    ParameterEventCallbackHandle as ParameterEventCallbackHandle,
    ParameterEventHandler as ParameterEventHandler,
)
