"""rclpy.context"""

from tflab.ros.context import Context as Context
