"""rclpy.subscription"""

from tflab.ros.subscription import Subscription as Subscription
