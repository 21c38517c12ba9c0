"""rclpy.node"""

from tflab.ros.node import Node as Node
from tflab.ros.parameter import Parameter as Parameter
