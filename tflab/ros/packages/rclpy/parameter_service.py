"""rclpy.parameter_service"""

from tflab.ros.parameter_service import ParameterService as ParameterService
