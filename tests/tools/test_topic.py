"""`ros2 topic`: what it lists, measures and echoes, and what it says when something is wrong."""

from pathlib import Path

import pytest
import yaml

from tflab.core import seconds
from tflab.ros import client_library as rclpy
from tflab.ros.messages.geometry_msgs import PointStamped
from tflab.ros.messages.std_msgs import String
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from tflab.ros.time import Duration
from tflab.tools.topic import matching_policy
from tflab.tools.topic_rates import Intervals, statistics_text

from .robot import fixed, moving, spin

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

RELIABLE, BEST_EFFORT = ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT


def talker(make, topic="/chatter", qos=10, name="talker", period_s=0.1):
    """A main function that publishes what `make(node)` returns."""

    def main():
        rclpy.init()
        node = Node(name)
        publisher = node.create_publisher(type(make(node)), topic, qos)
        node.create_timer(period_s, lambda: publisher.publish(make(node)))
        spin(node)

    return main


def hello(node):
    return String(data="hello")


def point(node, age_s=0.25):
    message = PointStamped()
    message.header.frame_id = "laser_frame"
    message.header.stamp = (node.get_clock().now() - Duration(seconds=age_s)).to_msg()
    return message


# -- list, type, find -----------------------------------------------------


def test_topics_are_listed_by_name_with_their_types(terminal):
    terminal.graph.start(moving())
    assert terminal.type("ros2 topic list -t") == (
        "/parameter_events [rcl_interfaces/msg/ParameterEvent]\n"
        "/rosout [rcl_interfaces/msg/Log]\n"
        "/tf [tf2_msgs/msg/TFMessage]\n"
    )
    assert terminal.type("ros2 topic list --count-topics") == "3\n"
    out = terminal.type("ros2 topic list -v")
    assert out.startswith("Published topics:\n * /parameter_events")
    assert " * /tf [tf2_msgs/msg/TFMessage] 1 publisher\n\nSubscribed topics:\n" in out
    assert terminal.type("ros2 topic type /tf") == "tf2_msgs/msg/TFMessage\n"
    assert terminal.type("ros2 topic find tf2_msgs/msg/TFMessage") == "/tf\n"
    assert terminal.type("ros2 topic type /nope") == ""
    assert terminal.exit_code == 1
    assert terminal.type("ros2 topic info /x") == ""
    assert (terminal.error, terminal.exit_code) == ("Unknown topic '/x'\n", 1)


# -- hz and delay ---------------------------------------------------------


def test_hz_of_a_steady_topic(terminal):
    out = terminal.type("ros2 --for 1 topic hz /tf")
    assert out == "WARNING: topic [/tf] does not appear to be published yet\n"
    terminal.graph.start(moving(rate_hz=20.0))
    assert terminal.type("ros2 --for 2.2 topic hz /tf") == (
        "average rate: 20.000\n\tmin: 0.050s max: 0.050s std dev: 0.00000s window: 21\n"
        "average rate: 20.000\n\tmin: 0.050s max: 0.050s std dev: 0.00000s window: 41\n"
    )
    assert "window: 5\n" in terminal.type("ros2 topic hz /tf -w 5")
    terminal.type("ros2 topic hz /tf -w 0")
    assert terminal.error.endswith("ros2 topic hz: error: argument --window/-w: value must be a positive integer\n")
    assert terminal.exit_code == 2


def test_uneven_intervals_show_as_their_spread():
    # 0.1 s and 0.3 s: mean 0.2 s, so 5 Hz; deviation 0.1 s
    assert statistics_text("rate", 5.0, [100_000_000, 300_000_000]) == (
        "average rate: 5.000\n\tmin: 0.100s max: 0.300s std dev: 0.10000s window: 2"
    )


def test_after_time_went_back_hz_begins_anew():
    intervals = Intervals()
    for moment in (10.0, 10.5, 11.5, 3.0, 3.5):
        intervals.add_message(seconds(moment))
    assert list(intervals._values_ns) == [seconds(0.5)]


def test_delay_is_from_the_stamp_to_being_heard(terminal):
    terminal.graph.start(talker(point, "/detected_point"))
    out = terminal.type("ros2 --for 1.05 topic delay /detected_point")
    assert (
        out == "average delay: 0.250\n\tmin: 0.250s max: 0.250s std dev: 0.00000s window: 8\n"
    )  # of nine heard, the first starts the clock
    terminal.graph.start(talker(hello))
    terminal.type("ros2 topic delay /chatter")
    assert terminal.error == "msg does not have header\n"


# -- echo -----------------------------------------------------------------


def test_of_two_latched_messages_once_shows_one(terminal):
    terminal.graph.start(fixed(child="laser_frame", name="one"))
    terminal.graph.start(fixed(child="imu_link", name="two"))
    assert terminal.type("ros2 topic echo /tf_static --once").count("---") == 1


def test_echo_of_a_field(terminal):
    terminal.graph.start(talker(point, "/detected_point"))
    assert terminal.type("ros2 topic echo /detected_point --once --field header.frame_id") == "laser_frame\n---\n"
    assert terminal.type("ros2 topic echo /detected_point --once --field point").startswith("x: 0.0\ny: 0.0")
    terminal.type("ros2 topic echo /detected_point --once --field nope")
    assert terminal.error.startswith("Invalid field 'nope': ")


def test_echo_goes_on_unless_once_and_cuts_long_strings(terminal):
    best_effort = QoSProfile(depth=5, reliability=BEST_EFFORT)  # to which it adapts
    terminal.graph.start(talker(lambda node: String(data="x" * 200), qos=best_effort, period_s=0.5))
    assert terminal.type("ros2 topic echo chatter --once") == f"data: {'x' * 128}...\n---\n"
    assert terminal.type("ros2 --for 1.1 topic echo /chatter -l 3") == "data: xxx...\n---\n" * 2
    assert terminal.type("ros2 topic echo /chatter --once --full-length") == f"data: {'x' * 200}\n---\n"


def test_a_type_can_be_given_and_must_exist(terminal):
    terminal.graph.start(talker(hello))
    assert terminal.type("ros2 topic echo /chatter std_msgs/msg/String --once") == "data: hello\n---\n"
    terminal.type("ros2 topic echo /chatter nope_msgs/msg/Nope --once")
    assert (terminal.error, terminal.exit_code) == ("The message type 'nope_msgs/msg/Nope' is invalid\n", 1)


def test_a_forced_reliability_that_no_publisher_offers_gets_nothing_and_says_why(terminal):
    terminal.graph.start(talker(hello, qos=QoSProfile(depth=5, reliability=BEST_EFFORT)))
    out = terminal.type("ros2 --for 1 topic echo /chatter --qos-reliability reliable")
    assert "data:" not in out
    assert "offering incompatible QoS. No messages will be received from it." in out + terminal.error


def test_when_some_are_latched_it_falls_back_and_says_so(terminal):
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    terminal.graph.start(talker(lambda node: TFMessage(), "/tf_static", latched, name="one"))
    terminal.graph.start(talker(lambda node: TFMessage(), "/tf_static", 1, name="two"))
    assert terminal.type("ros2 topic echo /tf_static --once").splitlines()[0] == (
        "Some, but not all, publishers are offering QoSDurabilityPolicy.TRANSIENT_LOCAL. "
        "Falling back to QoSDurabilityPolicy.VOLATILE as it will connect to all publishers"
    )


@pytest.mark.parametrize(
    ("offers", "policy"),
    [([], BEST_EFFORT), ([RELIABLE], RELIABLE), ([BEST_EFFORT], BEST_EFFORT), ([RELIABLE, BEST_EFFORT], BEST_EFFORT)],
)
def test_the_policy_is_one_that_every_publisher_offers(offers, policy):
    assert matching_policy(offers, RELIABLE, BEST_EFFORT)[0] is policy


@pytest.mark.parametrize("verb", ["echo", "hz", "delay"])
def test_a_malformed_name_is_answered_with_a_caret(terminal, verb):
    terminal.type(f"ros2 topic {verb} 1x")
    assert terminal.error.splitlines()[1:] == ["  '1x'", "   ^"]
    assert terminal.exit_code == 1


def test_a_topic_of_two_types_cannot_be_echoed(terminal):
    terminal.graph.start(talker(hello, name="one"))
    terminal.graph.start(talker(point, name="two"))
    terminal.type("ros2 topic echo /chatter")
    assert terminal.error == (
        "Cannot echo topic '/chatter', as it contains more than one type: "
        "[geometry_msgs/msg/PointStamped, std_msgs/msg/String]\n"
    )


def test_echo_of_a_stream_of_nothing_ends(terminal):
    terminal.graph.start(talker(hello, period_s=1e6))
    out = terminal.type("ros2 topic echo /chatter --once")
    assert "did not end within 60 s of the graph's time, and was stopped." in out


def listener(received):
    def main():
        rclpy.init()
        node = Node("listener")
        node.create_subscription(PointStamped, "/detected_point", received.append, 10)
        rclpy.spin(node)

    return main


def test_pub_once_waits_for_a_listener_and_ends(terminal):
    received = []
    terminal.graph.start(listener(received))
    out = terminal.type(
        "ros2 topic pub --once /detected_point geometry_msgs/msg/PointStamped"
        " '{header: {stamp: now, frame_id: laser_frame}, point: {x: 2}}'"
    )
    message = (
        "geometry_msgs.msg.PointStamped(header=std_msgs.msg.Header(stamp=builtin_interfaces.msg.Time(sec=1, nanosec=0),"
        " frame_id='laser_frame'), point=geometry_msgs.msg.Point(x=2.0, y=0.0, z=0.0))"
    )
    assert out == f"publisher: beginning loop\npublishing #1: {message}\n\n"
    assert terminal.exit_code == 0
    assert [repr(each) for each in received] == [message]


def test_pub_says_that_it_waits_and_goes_on_when_somebody_comes(terminal):
    received = []
    terminal.type("ros2 topic pub -t 2 -r 10 /detected_point geometry_msgs/msg/PointStamped &")
    terminal.graph.run(seconds=1.5)
    terminal.graph.start(listener(received))
    terminal.graph.run(seconds=1)
    assert len(received) == 2
    assert not terminal.graph.participants[0].is_running


def test_pub_sends_at_its_rate_until_it_is_stopped(terminal):
    received = []
    terminal.graph.start(listener(received))
    out = terminal.type(
        "ros2 --for 2 topic pub -r 5 -p 5 /detected_point geometry_msgs/msg/PointStamped '{header: auto}'"
    )
    assert out.count("publishing #") == 2
    assert [each.header.stamp.sec * 10 + each.header.stamp.nanosec // 10**8 for each in received] == [
        10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30,
    ]  # fmt: skip


@pytest.mark.parametrize(("words", "text"), CASES["cannot_be_sent"])
def test_pub_says_what_cannot_be_sent(terminal, words, text):
    terminal.type(f"ros2 topic pub {words}")
    assert terminal.error == f"{text}\n"
    assert terminal.exit_code == 1
    out = terminal.type("ros2 topic pub -1 -w 0 /j sensor_msgs/msg/JointState '{name: [a, b], position: [1, 2.5]}'")
    assert "name=['a', 'b'], position=[1.0, 2.5]" in out
