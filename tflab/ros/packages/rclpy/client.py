"""rclpy.client"""

from tflab.ros.service import Client as Client
