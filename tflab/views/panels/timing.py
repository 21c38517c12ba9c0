"""Panels for time: transform rate, latency, the buffer's timeline, clocks while a bag plays, late joiners."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tflab.core import LATEST, NSEC_PER_SEC, seconds
from tflab.text import Texts, language_of_workbook

from ..clocks import PASSES, ClocksPicture, Play
from ..late_joiner import JoinsPicture, Sender
from ..libraries import ipywidgets as widgets
from ..motion_error import Bend, BendPicture, LatencyPicture, Sight, largest_chord_gap
from ..timeline import Ask, Lane, Timeline, TimelinePicture
from .panel import Panel, say, slider
from .prefetch import Controls

TEXTS = Texts(__file__)

SLOWEST_HZ, FASTEST_RADPS = 1.0, 1.5
STEPS = 400  # of the timeline's slider, from end to end
NODES = ("rviz2", "detector")


def rate_panel(bend: Bend | None = None) -> Panel:
    """Return a panel that shows what TF's straight line misses of a bend, starting from `bend`."""
    start = bend or Bend()
    rate = slider(TEXTS["rate"], start.rate_hz, SLOWEST_HZ, 20.0, 0.5, "Hz")
    speed = slider(TEXTS["speed"], start.speed_mps, 0.0, 2.0, 0.05, "m/s")
    fastest = FASTEST_RADPS
    yaw_rate = slider(TEXTS["yaw rate"], start.yaw_rate_radps, -fastest, fastest, 0.05, "rad/s")
    height = largest_chord_gap(FASTEST_RADPS / SLOWEST_HZ)
    picture = BendPicture(-height, height)

    def move(at: Controls) -> None:
        picture.show(Bend(at(speed), at(yaw_rate), at(rate)))

    title = "The arc that a robot drives and the chord that TF draws"
    return Panel(title, picture, (rate, speed, yaw_rate), move)


def latency_panel(sight: Sight | None = None) -> Panel:
    """Return a panel in which a robot's motion and its delay can be changed, starting from `sight`."""
    start = sight or Sight()
    speed = slider(TEXTS["speed"], start.speed_mps, 0.0, 3.0, 0.05, "m/s")
    yaw_rate = slider(TEXTS["yaw rate"], start.yaw_rate_radps, -1.0, 1.0, 0.05, "rad/s")
    range_ = slider(TEXTS["range"], start.range_m, 1.0, 10.0, 0.1, "m")
    delay = slider(TEXTS["delay"], start.delay_s, 0.0, 0.5, 0.01, "s")
    picture = LatencyPicture()

    def move(at: Controls) -> None:
        picture.show(Sight(at(speed), at(yaw_rate), at(range_), seconds(at(delay))))

    title = "An object drawn with the pose at the stamp and now"
    return Panel(title, picture, (speed, yaw_rate, range_, delay), move)


def timeline_panel(
    target_frame: str,
    source_frame: str,
    lanes: Sequence[Lane],
    ask: Ask,
    stamp_ns: int | None = None,
) -> Panel:
    """Return a panel whose query can be dragged past either end of the buffer.

    Args:
        lanes: the edges between the two frames.
        ask: lookup_transform of the caller's buffer.
        stamp_ns: the query's time at first [ns]; the middle of the common interval if None.
    """
    timeline = Timeline(target_frame, source_frame, tuple(lanes))
    left_ns, right_ns = timeline.shown_ns
    if stamp_ns is None:
        stamp_ns = sum(timeline.common_ns or timeline.shown_ns) // 2
    step_s = max(round((right_ns - left_ns) / STEPS / NSEC_PER_SEC, 2), 0.001)
    left_s, right_s = left_ns / NSEC_PER_SEC, right_ns / NSEC_PER_SEC
    query = slider(TEXTS["query"], stamp_ns / NSEC_PER_SEC, left_s, right_s, step_s, "s")
    query.readout_format = ".3f"
    latest = widgets.Checkbox(description="LATEST", tooltip=say(TEXTS["newest"]), indent=False)
    latest.observe(lambda change: setattr(query, "disabled", change.new), names="value")
    picture = TimelinePicture(timeline, ask)

    def move(at: Controls) -> None:
        picture.show(LATEST if at(latest) else seconds(at(query)))

    title = f"What the buffer knows between {target_frame} and {source_frame}"
    return Panel(title, picture, (query, latest), move, layout=[widgets.HBox([query, latest])])


def clocks_panel(play: Play | None = None, played_s: float = 9.0) -> Panel:
    """Return a panel in which two nodes' clocks, and how the bag is played, can be changed.

    Args:
        play: how the bag is played at first; in a loop if None.
        played_s: the time to begin with [s].
    """
    start = play or Play(loops=True)
    played = slider(TEXTS["played"], played_s, 0.0, PASSES * start.length_s, 0.1, "s")
    rate = slider("--rate", start.rate, 0.5, 3.0, 0.1, "x")
    follows = [_box(f"{name}: use_sim_time", name == NODES[0]) for name in NODES]
    loop, clock = _box("--loop", start.loops), _box("--clock", start.publishes_clock)
    picture = ClocksPicture(NODES)

    def move(at: Controls) -> None:
        how = replace(start, rate=at(rate), loops=at(loop), publishes_clock=at(clock))
        picture.show(dict(zip(NODES, map(at, follows), strict=True)), how, at(played), language_of_workbook())

    title = "What each node's clock shows while a bag is played"
    return Panel(title, picture, (played, rate, *follows, loop, clock), move)


def _box(description: str, value: bool) -> widgets.Checkbox:
    return widgets.Checkbox(
        value=value, description=description, tooltip=description, indent=False, layout={"width": "190px"}
    )


def joins_panel(senders: Sequence[Sender], join_s: float, until_s: float) -> Panel:
    """Return a panel in which a listener can join earlier or later, and request stored messages or not.

    Args:
        senders: who publishes.
        join_s: when the listener joins at first [s].
        until_s: when the picture ends [s].
    """
    join = slider(TEXTS["join"], join_s, 0.0, until_s, 0.05, "s")
    durability = widgets.Dropdown(
        options=[("TRANSIENT_LOCAL", True), ("VOLATILE", False)],
        description="durability",
        tooltip="durability that the listener requests on /tf_static",
        style={"description_width": "110px"},
    )
    picture = JoinsPicture(senders, until_s)

    def move(at: Controls) -> None:
        picture.show(at(join), at(durability))

    return Panel("What a listener knows that joins", picture, (join, durability), move)
