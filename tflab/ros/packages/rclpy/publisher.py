"""rclpy.publisher"""

from tflab.ros.publisher import Publisher as Publisher
