"""How does a message become bytes, and a quality of service an entry in a file?

    our message  <-- rosbags' object of the same fields -->  CDR
    QoSProfile   <-- rosbags' Qos -->  metadata.yaml, or the channel of an .mcap

Definitions and hashes that go into a bag are rosbags' own, those of Jazzy.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from tflab.core import NSEC_PER_SEC
from tflab.ros.messages.packages import type_store
from tflab.ros.messages.values import message_from_object, object_from_message
from tflab.ros.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from tflab.ros.time import Duration

if TYPE_CHECKING:
    from rosbags.interfaces import Qos

    from tflab.ros.messages.base import Message

__all__ = ["bytes_of", "message_of", "profile_of", "qos_of"]


def bytes_of(message: Message) -> bytes:
    """Return a message as CDR."""
    return bytes(type_store().serialize_cdr(object_from_message(message, type_store().types), message.ROS_TYPE))


def message_of(data: bytes, ros_type: str, is_ros1: bool = False) -> Message:
    """Return the message in these bytes.

    Raises:
        KeyError: we have no such type.
    """
    read = _ros1_store().deserialize_ros1 if is_ros1 else type_store().deserialize_cdr
    return message_from_object(ros_type, read(data, ros_type))


def qos_of(profile: QoSProfile) -> Qos:
    """Return a profile as rosbags writes it."""
    from rosbags import interfaces

    return interfaces.Qos(
        interfaces.QosHistory(profile.history),
        profile.depth,
        interfaces.QosReliability(profile.reliability),
        interfaces.QosDurability(profile.durability),
        _qos_time(profile.deadline),
        _qos_time(profile.lifespan),
        interfaces.QosLiveliness(profile.liveliness),
        _qos_time(profile.liveliness_lease_duration),
        profile.avoid_ros_namespace_conventions,
    )


def profile_of(qos: Qos) -> QoSProfile:
    """Return a recorded profile as one that a publisher can be made with."""
    return QoSProfile(
        history=HistoryPolicy.KEEP_LAST if qos.history.value > 2 else HistoryPolicy(qos.history.value),
        depth=qos.depth or 10,
        reliability=ReliabilityPolicy(qos.reliability.value),
        durability=DurabilityPolicy(qos.durability.value),
        deadline=_duration(qos.deadline),
        lifespan=_duration(qos.lifespan),
        liveliness=LivelinessPolicy[qos.liveliness.name]
        if qos.liveliness.name in LivelinessPolicy.__members__
        else LivelinessPolicy.SYSTEM_DEFAULT,
        liveliness_lease_duration=_duration(qos.liveliness_lease_duration),
        avoid_ros_namespace_conventions=qos.avoid_ros_namespace_conventions,
    )


@cache
def _ros1_store():
    """Return rosbags' table of ROS 1; Noetic's lacks tf2_msgs."""
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore

    table = get_typestore(Stores.ROS1_NOETIC)
    table.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms\n", "tf2_msgs/msg/TFMessage"))
    return table


def _qos_time(duration: Duration):
    from rosbags.interfaces import QosTime

    return QosTime(*divmod(duration.nanoseconds, NSEC_PER_SEC))


def _duration(time) -> Duration:
    return Duration(nanoseconds=min(time.sec * NSEC_PER_SEC + time.nsec, 2**63 - 1))
