"""tf2_ros.buffer"""

from tflab.ros.tf2_buffer import Buffer

__all__ = [
    "Buffer",
]
