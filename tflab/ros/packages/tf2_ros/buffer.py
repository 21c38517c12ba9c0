"""tf2_ros.buffer"""

from tflab.ros.tf2.buffer import Buffer as Buffer
