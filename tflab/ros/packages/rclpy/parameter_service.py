"""rclpy.parameter_service"""

from tflab.ros.parameter_service import ParameterService

__all__ = [
    "ParameterService",
]
