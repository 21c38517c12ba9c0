"""Services of sensor_msgs, in process."""

from tflab.ros.messages.sensor_msgs import SetCameraInfo as SetCameraInfo
