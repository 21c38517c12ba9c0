"""Small bags for the tests, written by rosbags itself and by our own recorder."""

from __future__ import annotations

import math
from pathlib import Path

from rosbags.interfaces import Qos, QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

START_NS = 1_000_000_000
PERIOD_NS = 50_000_000
DELAY_NS = 4_000_000

LATCHED = Qos(
    QosHistory.KEEP_LAST, 1, QosReliability.RELIABLE, QosDurability.TRANSIENT_LOCAL, QosTime(0, 0), QosTime(0, 0),
    QosLiveliness.AUTOMATIC, QosTime(0, 0), False,
)  # fmt: skip


def circle(count: int, parent: str = "odom", child: str = "base_link") -> list[tuple]:
    """Return (stamp [ns], parent, child, seven numbers) of a robot on a circle."""
    rows = []
    for i in range(count):
        yaw = 0.02 * i
        pose = (math.cos(yaw), math.sin(yaw), 0.0, 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
        rows.append((START_NS + i * PERIOD_NS, parent, child, pose))
    return rows


LASER = (START_NS, "base_link", "laser_frame", (0.2, 0.0, 0.15, 0.0, 0.0, 0.0, 1.0))


def tf_message(store, rows: list[tuple], has_seq: bool = False):
    """Return rosbags' TFMessage of some (stamp [ns], parent, child, numbers)."""
    types = store.types
    transforms = []
    for stamp_ns, parent, child, (x, y, z, *q) in rows:
        time = types["builtin_interfaces/msg/Time"](*divmod(stamp_ns, 10**9))
        header = types["std_msgs/msg/Header"](*([0] if has_seq else []), time, parent)
        transform = types["geometry_msgs/msg/Transform"](
            types["geometry_msgs/msg/Vector3"](x, y, z), types["geometry_msgs/msg/Quaternion"](*q)
        )
        transforms.append(types["geometry_msgs/msg/TransformStamped"](header, child, transform))
    return types["tf2_msgs/msg/TFMessage"](transforms)


def write_rosbag2(path: Path, rows: list[tuple], statics: list[tuple] = (LASER,), storage: str = "MCAP") -> Path:
    """Write one message for each row on /tf, and one for all statics on /tf_static."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    with Writer2(path, version=9, storage_plugin=StoragePlugin[storage]) as writer:
        tf = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store)
        if statics:
            tf_static = writer.add_connection(
                "/tf_static", "tf2_msgs/msg/TFMessage", typestore=store, offered_qos_profiles=[LATCHED]
            )
            data = store.serialize_cdr(tf_message(store, list(statics)), "tf2_msgs/msg/TFMessage")
            writer.write(tf_static, START_NS, data)
        for row in rows:
            data = store.serialize_cdr(tf_message(store, [row]), "tf2_msgs/msg/TFMessage")
            writer.write(tf, row[0] + DELAY_NS, data)
    return path


def ros1_store():
    """Return rosbags' types of ROS 1 Noetic, with the tf2_msgs that they lack."""
    store = get_typestore(Stores.ROS1_NOETIC)
    store.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms\n", "tf2_msgs/msg/TFMessage"))
    store.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms\n", "tf/msg/tfMessage"))
    return store


def write_rosbag1(path: Path, rows: list[tuple], msgtype: str = "tf2_msgs/msg/TFMessage") -> Path:
    """Write a ROS 1 bag with one message for each row on /tf, from the node /driver."""
    store = ros1_store()
    with Writer1(path) as writer:
        tf = writer.add_connection("/tf", msgtype, typestore=store, callerid="/driver")
        for row in rows:
            data = store.serialize_ros1(tf_message(store, [row], has_seq=True), "tf2_msgs/msg/TFMessage")
            writer.write(tf, row[0] + DELAY_NS, data)
    return path
