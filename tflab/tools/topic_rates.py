"""Run `ros2 topic hz` and `ros2 topic delay`.

    hz       time between one message and the next, as heard
    delay    from the stamp in the header to being heard

Both say nothing for the first second, and then report over all that is in the
window.  upstream: ros2cli/ros2topic/verb/hz.py, delay.py.
"""

from __future__ import annotations

import argparse
import math
from collections import deque
from collections.abc import Sequence

from tflab.core import NSEC_PER_SEC, stamp_from_sec_nanosec
from tflab.ros.node import Node

from .discovery import add_discovery_options, topic_class, types_of
from .session import cli_node, spin, spin_for

__all__ = ["Intervals", "add_delay", "add_hz", "statistics_text"]

WINDOW = 10000


def add_hz(verbs: argparse._SubParsersAction) -> None:
    """Add `hz` to `ros2 topic`."""
    what = "Print the average publishing rate to screen"
    verb = verbs.add_parser("hz", help=what, description=what)
    verb.set_defaults(run=hz)
    verb.add_argument("topic_name", help="Name of the ROS topic to listen to (e.g. '/chatter')")
    _add_options(verb)
    verb.add_argument(
        "--wall-time", action="store_true",
        help="calculates rate using wall time which can be helpful when clock is not published during simulation",
    )  # fmt: skip


def add_delay(verbs: argparse._SubParsersAction) -> None:
    """Add `delay` to `ros2 topic`."""
    what = "Display delay of topic from timestamp in header"
    verb = verbs.add_parser("delay", help=what, description=what)
    verb.set_defaults(run=delay)
    verb.add_argument("topic", help="Topic name to calculate the delay for")
    _add_options(verb)


def _add_options(verb: argparse.ArgumentParser) -> None:
    add_discovery_options(verb)
    verb.add_argument(
        "--window", "-w", type=positive_int, default=WINDOW, metavar="WINDOW",
        help=f"window size, in # of messages, for calculating rate (default: {WINDOW})",
    )  # fmt: skip


def positive_int(text: str) -> int:
    """Return the number that `text` stands for, or have argparse say upstream's sentence."""
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError("value must be a positive integer")
    return int(text)


def statistics_text(heading: str, first_figure: float, values_ns: Sequence[int]) -> str:
    """Return the two lines of a report: the figure, then the spread of the intervals or delays."""
    count = len(values_ns)
    mean_ns = sum(values_ns) / count
    deviation_ns = math.sqrt(sum((value - mean_ns) ** 2 for value in values_ns) / count)
    return (
        f"average {heading}: {first_figure:.3f}\n"
        f"\tmin: {min(values_ns) * 1e-9:.3f}s max: {max(values_ns) * 1e-9:.3f}s "
        f"std dev: {deviation_ns * 1e-9:.5f}s window: {count}"
    )


class Intervals:
    """The times between messages [ns], as `hz` keeps them."""

    def __init__(self, window: int = WINDOW) -> None:
        self._values_ns: deque[int] = deque(maxlen=window)
        self._last_ns: int | None = None
        self._reported_ns = 0

    def add_message(self, now_ns: int) -> None:
        """Take in that a message came; after time went back, begin anew."""
        if self._last_ns is None or now_ns < self._last_ns:
            self._values_ns.clear()
        else:
            self._values_ns.append(now_ns - self._last_ns)
        self._last_ns = now_ns

    def report(self) -> str | None:
        """Return the report, if a second has passed since the last one."""
        if not self._values_ns or self._last_ns is None:
            return None
        if self._reported_ns == 0:
            self._reported_ns = self._last_ns
            return None
        if self._last_ns < self._reported_ns + NSEC_PER_SEC:
            return None
        self._reported_ns = self._last_ns
        mean_ns = sum(self._values_ns) / len(self._values_ns)
        return statistics_text("rate", NSEC_PER_SEC / mean_ns if mean_ns else 0.0, self._values_ns)


def hz(options: argparse.Namespace) -> None:
    """Print the rate of a topic once a second, until stopped."""
    from tflab.ros.qos import qos_profile_sensor_data

    with cli_node() as node:
        message_type = _published_type(node, options.topic_name)
        intervals = Intervals(options.window)

        def on_message(_) -> None:
            intervals.add_message(node.get_clock().now().nanoseconds)
            report = intervals.report()
            if report:
                print(report, flush=True)

        node.create_subscription(message_type, options.topic_name, on_message, qos_profile_sensor_data)
        spin(node)


def delay(options: argparse.Namespace) -> str | None:
    """Print how old the messages of a topic are when they are heard, once a second, until stopped."""
    from tflab.ros.qos import qos_profile_sensor_data

    with cli_node() as node:
        message_type = _published_type(node, options.topic)
        if "header" not in message_type.get_fields_and_field_types():
            return "msg does not have header"
        delays_ns: deque[int] = deque(maxlen=options.window)
        heard = [0, 0]  # how many in all, and at the last report

        def on_message(message) -> None:
            stamp = message.header.stamp
            heard[0] += 1
            if heard[0] > 1:  # upstream's first message only starts the clock
                delays_ns.append(node.get_clock().now().nanoseconds - stamp_from_sec_nanosec(stamp.sec, stamp.nanosec))

        def report() -> None:
            if delays_ns and heard[0] == heard[1]:
                print("no new messages", flush=True)
            elif delays_ns:
                mean_s = sum(delays_ns) / len(delays_ns) * 1e-9
                print(statistics_text("delay", mean_s, delays_ns), flush=True)
            heard[1] = heard[0]

        node.create_subscription(message_type, options.topic, on_message, qos_profile_sensor_data)
        node.create_timer(1.0, report)
        spin(node)
    return None


def _published_type(node: Node, topic_name: str) -> type:
    """Return the class of a topic's messages; wait for the topic if need be."""
    message_type = topic_class(node, topic_name)
    while message_type is None:
        spin_for(node, 0.1)
        if types_of(node, node.resolve_topic_name(topic_name)):
            message_type = topic_class(node, topic_name)
    return message_type
