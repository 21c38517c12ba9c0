"""E9.1: Eight lines from a log."""

from __future__ import annotations

from tflab.core import BufferCore, TransformException, seconds
from tflab.workbook.tasks import Choice, Draws, Parts, define_task

from .draws import edge, fill

KINDS = ("lookup", "connectivity", "future", "past", "one sample", "invalid argument", "not a TransformException")

CHECKS = ("spelling and publisher", "roots of the tree", "use_sim_time", "the line of code", "a longer timeout")

EDGES = Choice(("odom", "base_footprint", "base_link", "laser_frame", "arm_link", "tool0"))


def make_buffer_of_lines() -> BufferCore:
    """Return the buffer that gave the eight lines."""
    return fill(
        BufferCore(seconds(20.0)),
        edge("map", "odom", 20.5, 25.3, 30.1),
        edge("odom", "base_footprint", 21.0, 25.7, 30.4),
        edge("base_footprint", "base_link"),
        edge("base_link", "laser_frame"),
        edge("base_link", "arm_link", 29.5),
        edge("arm_link", "tool0"),
        edge("base_lnk", "camera_link"),
    )


def line_of(buffer: BufferCore, target: str, source: str, time_s: float) -> str:
    """Return tf2's message for a lookup that fails."""
    try:
        buffer.lookup_transform(target, source, seconds(time_s))
    except TransformException as error:
        return str(error)
    raise ValueError(f"{target} <- {source} at {time_s} has an answer")


def eight_lines(_rng: Draws) -> dict:
    """Return the lines; they are the same for every learner."""
    buffer = make_buffer_of_lines()
    lines = {
        "a": line_of(buffer, "map", "lazer_frame", 25.0),
        "b": line_of(buffer, "map", "camera_link", 25.0),
        "c": line_of(buffer, "map", "laser_frame", 30.312),
        "d": line_of(buffer, "map", "laser_frame", 20.731),
        "e": line_of(buffer, "base_link", "tool0", 30.0),
        "f": line_of(buffer, "/map", "laser_frame", 25.0),
        "g": "Type <class 'geometry_msgs.msg._point_stamped.PointStamped'> is not loaded or supported",
        "h": line_of(buffer, "map", "laser_frame", 1763690412.3),
    }
    return {"buffer": buffer, "lines": lines}


TASK = define_task(
    __file__,
    kind="M",
    points=4,
    answer="lines",
    form=Parts(
        {
            **{name: Choice(KINDS) for name in "abcdefgh"},
            "c edge": EDGES,
            "d edge": EDGES,
            "h check": Choice(CHECKS),
        }
    ),
    given=eight_lines,
)
