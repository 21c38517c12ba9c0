"""rclpy.wait_for_message"""

from tflab.ros.wait_for_message import wait_for_message as wait_for_message
