"""tf2's MessageFilter passes messages once they can be transformed, or logs why not."""

from types import SimpleNamespace

import pytest

from tflab.core import NSEC_PER_SEC, BufferCore, StampedTransform, Transform, seconds
from tflab.ros import client_library
from tflab.ros.graph import new_graph
from tflab.ros.logging import LoggingSeverity, get_logger, set_logger_level
from tflab.ros.messages.geometry_msgs import PointStamped, TransformStamped
from tflab.ros.node import Node
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.filters import SimpleFilter, Subscriber
from tflab.ros.tf2.message_filter import DropReason, MessageFilter
from tflab.ros.tf2.topics import TransformBroadcaster, TransformListener
from tflab.ros.time import Duration, Time


class NodeWithTimers:
    """A node whose timers a test fires by hand."""

    def __init__(self):
        self.timers = []

    def get_logger(self):
        return get_logger("laser_node")

    def create_timer(self, timer_period_sec, callback):
        timer = SimpleNamespace(period_s=timer_period_sec, fire=callback)
        self.timers.append(timer)
        return timer

    def destroy_timer(self, timer):
        self.timers.remove(timer)
        return True


class Setup:
    """A filter to `map`, its input, its engine, and what has come out [s]."""

    def __init__(self, target_frame="map", queue_size=10, buffer_timeout=None):
        self.engine = BufferCore()
        self.node = NodeWithTimers()
        self.input = SimpleFilter()
        self.passed = []
        buffer = SimpleNamespace(core=self.engine)
        self.filter = MessageFilter(self.input, buffer, target_frame, queue_size, self.node, buffer_timeout)
        self.filter.registerCallback(
            lambda message: self.passed.append(Time.from_msg(message.header.stamp).nanoseconds / NSEC_PER_SEC)
        )

    def message(self, at_s, frame_id="laser"):
        message = PointStamped()
        message.header.frame_id = frame_id
        message.header.stamp = Time(nanoseconds=seconds(at_s)).to_msg()
        self.input.signalMessage(message)

    def transform(self, *at_s, parent="map", child="laser"):
        for stamp_s in at_s:
            self.engine.set_transform(StampedTransform(parent, child, seconds(stamp_s), Transform()))


# What arrives, in order: message(stamp, frame), transform(*stamps, parent, child), or another step.
SEQUENCES = {
    "a message waits for its transform": [
        lambda f: f.message(2.0), lambda f: f.transform(1.0), [], lambda f: f.transform(3.0), [2.0],
    ],
    "a message that can be transformed passes at once": [
        lambda f: f.transform(1.0, 3.0), lambda f: f.message(2.0), [2.0],
    ],
    "messages pass in the order of their transforms": [
        lambda f: f.transform(1.0), lambda f: f.transform(1.0, child="camera"),
        lambda f: f.message(2.0), lambda f: f.message(1.5, "camera"),
        lambda f: f.transform(3.0, child="camera"), lambda f: f.transform(3.0), [1.5, 2.0],
    ],
    "with a tolerance a message waits until that much later is known": [
        lambda f: f.filter.setTolerance(Duration(seconds=0.5)),
        lambda f: f.transform(1.0, 2.4), lambda f: f.message(2.0), [], lambda f: f.transform(2.5), [2.0],
    ],
    "with two targets a message waits for both": [
        lambda f: f.filter.setTargetFrames(["map", "odom"]),
        lambda f: f.transform(1.0, 3.0), lambda f: f.message(2.0), [],
        lambda f: f.transform(1.0, 3.0, child="odom"), [2.0],
    ],
    "without a target no message is accepted": [
        lambda f: f.filter.setTargetFrames([]), lambda f: f.transform(1.0, 3.0), lambda f: f.message(2.0), [],
    ],
    "leading slashes are stripped": [
        lambda f: f.filter.setTargetFrames(["/map"]),
        lambda f: f.transform(1.0, 3.0), lambda f: f.message(2.0, frame_id="/laser"), [2.0],
    ],
}  # fmt: skip


@pytest.mark.parametrize("steps", SEQUENCES.values(), ids=SEQUENCES)
def test_messages_pass_once_they_can_be_transformed(steps):
    setup = Setup()
    for step in steps:
        if isinstance(step, list):
            assert setup.passed == step
        else:
            step(setup)
    assert setup.filter.dropped == {}
    assert setup.filter.successful_transform_count == len(setup.passed)


DROPS = {
    "a full queue drops the oldest even for a message that is ready": (
        1, [lambda f: f.transform(1.0, 3.0), lambda f: f.message(4.0), lambda f: f.message(2.0)],
        [2.0], {DropReason.QUEUE_FULL: 1},
    ),
    "a queue of size zero is unbounded": (
        0, [lambda f: [f.message(2.0 + i) for i in range(50)]], [], {},
    ),
    "a queue can be made smaller": (
        5, [lambda f: f.filter.setQueueSize(1), lambda f: f.message(2.0), lambda f: f.message(3.0)],
        [], {DropReason.QUEUE_FULL: 1},
    ),
    "a waiting message is dropped when it is older than the cache": (
        10, [lambda f: f.transform(5.0), lambda f: f.message(4.0), lambda f: f.transform(14.1)],
        [], {DropReason.OUT_THE_BACK: 1},
    ),
    "a message whose transform disappeared is dropped for an unknown reason": (
        10,
        [
            lambda f: f.filter.setTargetFrames(["map", "odom"]), lambda f: f.transform(1.0, 3.0),
            lambda f: f.message(2.0), lambda f: f.engine.clear(),
            lambda f: f.transform(1.0, 3.0, parent="odom"),  # the laser's only parent is odom now
        ],
        [], {DropReason.UNKNOWN: 1},
    ),
}  # fmt: skip


@pytest.mark.parametrize(("queue_size", "steps", "passed", "dropped"), DROPS.values(), ids=DROPS)
def test_messages_are_dropped_for_tf2s_reasons(queue_size, steps, passed, dropped):
    setup = Setup(queue_size=queue_size)
    for step in steps:
        step(setup)
    assert (setup.passed, setup.filter.dropped) == (passed, dropped)
    assert setup.filter.getQueueSize() == (1 if queue_size == 5 else queue_size)


@pytest.mark.parametrize(
    ("at_s", "frame", "reason", "logged"),
    [
        (12.345, "", DropReason.EMPTY_FRAME_ID, "'the frame id of the message is empty'"),
        (
            10.9,  # the cache reaches back ten seconds, to 11 s
            "laser",
            DropReason.OUT_THE_BACK,
            "'the timestamp on the message is earlier than all the data in the transform cache'",
        ),
    ],
)
def test_a_message_without_a_frame_or_older_than_the_cache_is_dropped_at_once(capsys, at_s, frame, reason, logged):
    setup = Setup()
    setup.transform(20.0, 21.0)
    setup.message(at_s, frame_id=frame)
    assert setup.filter.dropped == {reason: 1}
    line = f"[laser_node]: Message Filter dropping message: frame '{frame}' at time {at_s:.3f} for reason {logged}"
    assert_logged(capsys, "[INFO]", line)


def test_a_full_queue_drops_the_oldest_to_admit_the_new(capsys):
    setup = Setup(queue_size=2)
    for at_s in (2.0, 3.0, 4.0):
        setup.message(at_s)
    assert setup.filter.dropped == {DropReason.QUEUE_FULL: 1}
    assert_logged(
        capsys,
        "Message Filter dropping message: frame 'laser' at time 2.000 "
        "for reason 'discarding message because the queue is full'",
    )
    setup.transform(1.0, 5.0)
    assert sorted(setup.passed) == [3.0, 4.0]


def test_a_message_that_waits_longer_than_the_timeout_is_dropped():
    setup = Setup(buffer_timeout=Duration(seconds=0.2))
    setup.message(2.0)
    (timer,) = setup.node.timers
    assert timer.period_s == pytest.approx(0.2)
    timer.fire()
    assert setup.filter.dropped == {DropReason.OUT_THE_BACK: 1}
    assert setup.node.timers == []
    setup.message(2.0)
    setup.filter.clear()
    setup.transform(1.0, 3.0)
    assert (setup.passed, setup.node.timers) == ([], [])
    setup.message(2.5)
    setup.message(4.0)
    setup.transform(5.0)
    assert setup.passed == [2.5, 4.0]
    assert setup.node.timers == []  # which come out in time


def test_debug_level_logs_each_step(capsys):
    set_logger_level("tf2_ros_message_filter", LoggingSeverity.DEBUG)
    try:
        setup = Setup(queue_size=1)
        setup.message(2.0)
        setup.message(2.5)
        setup.transform(1.0, 3.0)
    finally:
        set_logger_level("tf2_ros_message_filter", LoggingSeverity.UNSET)
    assert_logged(
        capsys,
        "[tf2_ros_message_filter]: MessageFilter [target=map ]: "
        "Added message in frame laser at time 2.000, count now 1",
        "MessageFilter [target=map ]: Removed oldest message because buffer is full, count now 1 "
        "(frame_id=laser, stamp=2.000000)",
        "MessageFilter [target=map ]: Message ready in frame laser at time 2.500, count now 0",
    )


def test_no_scan_is_lost_if_tf_arrives_later_than_the_scans():
    #  odom --(published at 20 Hz, 0.15 s under way)--> base_link      scans at 10 Hz, at once
    graph = new_graph()
    graph.disturb("/tf", delay=0.15)
    transformed = []

    def robot():
        client_library.init()
        node = Node("robot")
        broadcaster = TransformBroadcaster(node)
        scans = node.create_publisher(PointStamped, "scan", 10)

        def publish(message, frame_id):
            message.header.frame_id = frame_id
            message.header.stamp = node.get_clock().now().to_msg()
            return message

        node.create_timer(
            0.05, lambda: broadcaster.sendTransform(publish(TransformStamped(child_frame_id="base_link"), "odom"))
        )
        node.create_timer(0.1, lambda: scans.publish(publish(PointStamped(), "base_link")))
        client_library.spin(node)

    def mapper():
        client_library.init()
        node = Node("mapper")
        buffer = Buffer()
        node.listener = TransformListener(buffer, node)
        scans = MessageFilter(Subscriber(node, PointStamped, "scan"), buffer, "odom", 10, node)

        def on_scan(scan):
            transform = buffer.lookup_transform("odom", "base_link", scan.header.stamp)
            transformed.append(transform.header.stamp == scan.header.stamp)

        scans.registerCallback(on_scan)
        client_library.spin(node)

    graph.start(mapper)
    graph.start(robot)
    graph.run(seconds=2.0)
    graph.stop()
    assert len(transformed) >= 17
    assert all(transformed)


def assert_logged(capsys, *texts):
    printed = capsys.readouterr()
    for text in texts:
        assert text in printed.out + printed.err
