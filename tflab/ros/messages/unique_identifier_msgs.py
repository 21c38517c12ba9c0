"""Define unique_identifier_msgs."""

from .base import message

UUID = message("unique_identifier_msgs/msg/UUID", "uint8[16] uuid")
