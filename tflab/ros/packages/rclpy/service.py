"""rclpy.service"""

from tflab.ros.service import Service as Service
