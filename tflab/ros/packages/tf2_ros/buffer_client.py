"""tf2_ros.buffer_client"""

from tflab.ros.tf2.client import BufferClient as BufferClient
