"""Run `tf2_monitor`: rates and delays of all frames or of one chain.

    stamp -------- delay -------> heard          delay = now - stamp, of every transform
      |                             |            frequency = how many were heard / for how long
    a node said                 tf2_monitor

ROS 2 does not say who published a message, so everybody is one broadcaster,
<no authority available>; `ros2 topic info /tf --verbose` names the nodes.  The net
delay begins at 0 and approaches the truth by a hundredth each half second, so it
reads too low for minutes; a stamp from the future does not show as a maximum.
So it is upstream.

upstream: tf2_ros/src/tf2_monitor.cpp.
"""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field

from tflab.core import LATEST, NSEC_PER_SEC, BufferCore, TransformException
from tflab.ros.node import Node

from .cpp_numbers import general
from .session import abort, cpp_listener, spin_for, tool_node
from .tf2_echo import waiting_text

__all__ = ["Delays", "NetDelay", "broadcaster_line", "frame_lines", "main", "results_heading"]

SAMPLES_KEPT = 1000
AUTHORITY = "<no authority available>"
LOOK_EVERY_S, LOOKS_PER_REPORT = 0.5, 21
LOW_PASS = 0.01


@dataclass(slots=True)
class NetDelay:
    """The delay of a whole chain [s], smoothed, and its largest value."""

    average: float = 0.0
    largest: float = 0.0

    def add(self, delay_s: float) -> None:
        """Take one more measurement in."""
        self.average = LOW_PASS * delay_s + (1 - LOW_PASS) * self.average
        self.largest = max(self.largest, delay_s)


def _kept() -> deque[float]:
    return deque(maxlen=SAMPLES_KEPT)


@dataclass(slots=True)
class Delays:
    """What was heard: of each frame the delays [s], of each message its mean delay and when it came [s]."""

    of_frame: dict[str, deque[float]] = field(default_factory=dict)
    of_message: deque[float] = field(default_factory=_kept)
    heard_at: deque[float] = field(default_factory=_kept)

    def add_message(self, now_s: float, stamps_s: Sequence[tuple[str, float]]) -> None:
        """Take in one message: the child and the stamp [s] of each of its transforms."""
        for child, stamp_s in stamps_s:
            self.of_frame.setdefault(child, _kept()).append(now_s - stamp_s)
        self.of_message.append(sum(now_s - stamp_s for _, stamp_s in stamps_s) / max(1, len(stamps_s)))
        self.heard_at.append(now_s)


def results_heading(chain: Sequence[str] = (), net: NetDelay | None = None) -> str:
    """Return how a report begins, for one chain or for all frames."""
    if net is None:
        return "\n\n\nRESULTS: for all Frames"
    return (
        f"\n\n\nRESULTS: for {chain[0]} to {chain[-1]}\n"
        f"Chain is: {' -> '.join(chain)}\n"
        f"Net delay     avg = {general(net.average)}: max = {general(net.largest)}"
    )


def frame_lines(delays: Delays, chain: Sequence[str] | None = None) -> list[str]:
    """Return a line for each frame that was heard as a child, of `chain` only if given."""
    lines = []
    for frame in sorted(delays.of_frame):
        if chain is None or frame in chain:
            average, largest = _average_and_largest(delays.of_frame[frame])
            lines.append(f"Frame: {frame}, published by {AUTHORITY}, Average Delay: {average}, Max Delay: {largest}")
    return lines


def broadcaster_line(delays: Delays) -> str:
    """Return the line of the one broadcaster that everybody is."""
    average, largest = _average_and_largest(delays.of_message)
    # n / span, not (n - 1) / span, and a hundred million a second for a single message: as upstream reckons.
    rate_hz = len(delays.heard_at) / max(1e-8, delays.heard_at[-1] - delays.heard_at[0])
    return f"Node: {AUTHORITY} {general(rate_hz)} Hz, Average Delay: {average} Max Delay: {largest}"


def _average_and_largest(delays_s: Sequence[float]) -> tuple[str, str]:
    return general(sum(delays_s) / len(delays_s)), general(max(0.0, *delays_s))


def main(arguments: Sequence[str]) -> int:
    """Print a report every 10.5 s until stopped; return the exit code."""
    with tool_node("tf2_monitor_main") as node:
        if len(arguments) not in (0, 2):
            node.get_logger().info("TF_Monitor: usage: tf2_monitor framea frameb")
            return 255
        with cpp_listener(node) as core:
            try:
                _watch(node, core, *arguments)
            except TransformException as fault:  # upstream does not catch it either
                return abort(f"tf2::{type(fault).__name__}", str(fault))
    return 0


def _watch(node: Node, core: BufferCore, frame_a: str = "", frame_b: str = "") -> None:
    chain, net = None, None
    if frame_a:
        while not (answer := core.why_not(frame_a, frame_b, LATEST))[0]:
            node.get_logger().info(waiting_text(frame_a, frame_b, answer[1]), throttle_duration_sec=1.0)
            spin_for(node, LOOK_EVERY_S)
        chain, net = core.chain(frame_b, frame_a), NetDelay()
    node.context.process.began_ns = node.context.process.driver.now_ns()
    delays = _listen(node)
    what = f"{frame_a} -> {frame_b}" if frame_a else "all frames"
    print(f"Gathering data on {what} for 10 seconds...", flush=True)
    while True:
        for _ in range(LOOKS_PER_REPORT):
            if net is not None:
                stamp_ns = core.lookup_transform(frame_a, frame_b, LATEST).stamp_ns
                net.add((node.get_clock().now().nanoseconds - stamp_ns) / NSEC_PER_SEC)
            spin_for(node, LOOK_EVERY_S)
        print(results_heading(chain or (), net), "", "Frames:", *frame_lines(delays, chain), sep="\n", flush=True)
        print("\nAll Broadcasters:", file=sys.stderr, flush=True)
        if delays.heard_at:
            print(broadcaster_line(delays), flush=True)


def _listen(node: Node) -> Delays:
    """Measure every message on /tf and /tf_static from now on."""
    from tflab.ros.messages.tf2_msgs import TFMessage
    from tflab.ros.qos import DurabilityPolicy, QoSProfile

    delays = Delays()

    def on_message(message: TFMessage) -> None:
        now_s = node.get_clock().now().nanoseconds / NSEC_PER_SEC
        headers = [(each.child_frame_id, each.header.stamp) for each in message.transforms]
        delays.add_message(now_s, [(child, stamp.sec + stamp.nanosec / NSEC_PER_SEC) for child, stamp in headers])

    node.create_subscription(TFMessage, "/tf", on_message, QoSProfile(depth=100))
    static = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(TFMessage, "/tf_static", on_message, static)
    return delays
