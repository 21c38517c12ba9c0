"""rclpy.parameter_client"""

from tflab.ros.parameter_client import AsyncParameterClient as AsyncParameterClient
