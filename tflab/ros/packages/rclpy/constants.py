"""rclpy.constants"""

from tflab.core import NSEC_PER_SEC

S_TO_NS = NSEC_PER_SEC
