"""Services of tf2_msgs, in process."""

from tflab.ros.messages.tf2_msgs import FrameGraph as FrameGraph
