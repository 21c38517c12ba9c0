"""unique_identifier_msgs: which one.

Read `action_msgs.py` next.
"""

from .base import message

UUID = message("unique_identifier_msgs/msg/UUID", "uint8[16] uuid")
