"""What is said of a recording that is not as expected?

The same sentences tell what changed between two recordings: what the first shows
is expected of the second.
"""

from __future__ import annotations

from .sentences import ECHO, EDGE_HZ, TOPIC_INFO, VIEW_FRAMES, Sentences

__all__ = ["GATE_TEXTS"]

GATE_TEXTS: dict[str, Sentences] = {
    "expected-edge": Sentences(
        "{edge} is expected and not there",
        "In this recording {instead}.",
        "Its node is not running, publishes other names, or was not recorded.",
        VIEW_FRAMES,
    ),
    "unexpected-edge": Sentences(
        "{edge} is not expected",
        "{count} samples on {topic}.",
        "Somebody new publishes: a node, a link in the robot's description, another robot.",
        TOPIC_INFO,
    ),
    "expected-kind": Sentences(
        "{edge} is {instead}, and should be {expected}",
        "It came on {topic}.",
        "Another node publishes it, or a broadcaster was exchanged for a static one.",
        TOPIC_INFO,
    ),
    "expected-rate": Sentences(
        "{edge} has another rate",
        "Expected {expected}; it is {instead}.",
        "A parameter of its node, a computer that cannot follow, or messages that are lost.",
        EDGE_HZ,
    ),
    "expected-delay": Sentences(
        "{edge} comes later than it should",
        "Expected {expected}; it is {instead}.",
        "A slower node or network, or a clock that has drifted.",
        "ros2 run tf2_ros tf2_monitor {parent} {child}",
    ),
    "expected-silence": Sentences(
        "{edge} was silent for longer than it should",
        "Expected {expected}; it is {instead}.",
        "The publisher was blocked, or messages were lost.",
        EDGE_HZ,
    ),
    "expected-owners": Sentences(
        "{edge} has other owners",
        "Expected {expected}; it is {instead}.",
        "A node was exchanged, or a second one publishes the same.",
        TOPIC_INFO,
    ),
    "expected-mount": Sentences(
        "{edge} is mounted elsewhere",
        "Expected {expected} (x y z, qx qy qz qw); it is {instead}.",
        "A new calibration, another robot description, or the wrong file.",
        ECHO,
    ),
    "expected-topic": Sentences(
        "{topic} is expected and not there",
        "No message with a header came on it.",
        "Its driver is not running, or the topic was not recorded.",
        "ros2 topic list",
    ),
    "expected-frame": Sentences(
        "Messages on {topic} are in another frame",
        "Expected {expected}; it is {instead}.",
        "The driver's parameter frame_id was changed.",
        "ros2 topic echo {topic} --once --field header",
    ),
}
