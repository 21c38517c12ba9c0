"""unique_identifier_msgs: which one."""

from .base import message

UUID = message("unique_identifier_msgs/msg/UUID", "uint8[16] uuid")
