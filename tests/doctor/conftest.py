"""Recordings of the teaching robot, as it is and with one fault, and a way to write others."""

import pytest

from tflab.bags.record import BagWriter
from tflab.robots.faults.inject import inject
from tflab.robots.teaching import TeachingRobot
from tflab.ros.convert import msg_from_stamped
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.qos import DurabilityPolicy, QoSProfile

RECORDS = TeachingRobot().records(until_s=6.0)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def write(path, records):
    """Write transforms into a bag, one a message; return its path."""
    with BagWriter(path) as writer:
        writer.add_topic("/tf", TFMessage.ROS_TYPE, [QoSProfile(depth=100)])
        writer.add_topic("/tf_static", TFMessage.ROS_TYPE, [LATCHED])
        for record in records:
            writer.write(record.topic, TFMessage(transforms=[msg_from_stamped(record.stamped)]), record.receive_ns)
    return str(path)


def of_robot(name, records):
    """Return the records on topics of a robot's own."""
    return [record._replace(topic=f"/{name}{record.topic}") for record in records]


@pytest.fixture(scope="session")
def clean(tmp_path_factory):
    return write(tmp_path_factory.mktemp("bags") / "clean", RECORDS)


@pytest.fixture(scope="session")
def late(tmp_path_factory):
    """A recording with a warning: one edge comes late."""
    return write(tmp_path_factory.mktemp("bags") / "late", inject(RECORDS, "late-stamps", seed=1).records)


@pytest.fixture(scope="session")
def broken(tmp_path_factory):
    """A recording with an error."""
    return write(tmp_path_factory.mktemp("bags") / "broken", inject(RECORDS, "zero-quaternion", seed=1).records)
