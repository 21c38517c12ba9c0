"""A program is told that the other side's quality of service does not fit."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks, UnsupportedEventTypeError
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node
from tflab.ros.qos import QoSProfile, ReliabilityPolicy
from tflab.ros.qos_compatibility import QoSPolicyKind, qos_policy_name_from_kind

STRICT = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
LOOSE = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)

#   publisher, best effort --x--> subscription, reliable


@pytest.fixture
def node(graph):
    rclpy.init()
    yield Node("ends")
    rclpy.shutdown()


def told(infos):
    return [(info.total_count, info.total_count_change, info.last_policy_kind) for info in infos]


def test_the_executor_tells_both_sides_which_policy_it_was_and_the_log_says_nothing(node, capsys):
    subscription, publisher = [], []
    node.create_subscription(
        String, "t", print, STRICT, event_callbacks=SubscriptionEventCallbacks(incompatible_qos=subscription.append)
    )
    for _ in range(2):
        node.create_publisher(
            String, "t", LOOSE, event_callbacks=PublisherEventCallbacks(incompatible_qos=publisher.append)
        )
    assert (subscription, publisher) == ([], [])
    for _ in range(4):
        rclpy.spin_once(node, timeout_sec=0)
    assert told(subscription) == [(1, 1, QoSPolicyKind.RELIABILITY), (2, 1, QoSPolicyKind.RELIABILITY)]
    assert told(publisher) == [(1, 1, QoSPolicyKind.RELIABILITY)] * 2
    assert qos_policy_name_from_kind(subscription[0].last_policy_kind) == "RELIABILITY"
    assert "incompatible QoS" not in capsys.readouterr().err


def test_without_a_callback_the_log_says_it_unless_that_is_not_wanted(node, capsys):
    node.create_subscription(String, "t", print, STRICT, event_callbacks=SubscriptionEventCallbacks())
    silent = PublisherEventCallbacks(use_default_callbacks=False)
    node.create_publisher(String, "t", LOOSE, event_callbacks=silent)
    logged = capsys.readouterr().err
    assert "New publisher discovered on topic '/t', offering incompatible QoS." in logged
    assert "New subscription discovered" not in logged


@pytest.mark.parametrize(
    ("callbacks", "event"),
    [
        (PublisherEventCallbacks, "deadline"),
        (PublisherEventCallbacks, "matched"),
        (SubscriptionEventCallbacks, "message_lost"),
        (SubscriptionEventCallbacks, "liveliness"),
    ],
)
def test_an_event_that_nobody_would_report_is_refused(callbacks, event):
    with pytest.raises(UnsupportedEventTypeError, match=f"nobody reports the event '{event}'"):
        callbacks(**{event: print})
