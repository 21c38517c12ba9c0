"""Messages of tf2_msgs, in process."""

from tflab.ros.messages.tf2_msgs import (
    TF2Error as TF2Error,
    TFMessage as TFMessage,
)
