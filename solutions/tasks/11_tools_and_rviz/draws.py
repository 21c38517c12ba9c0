"""Draw RViz's display list of a robot with one fault for several tasks of chapter 11."""

from __future__ import annotations

from tflab.core import BufferCore, StampedTransform, Transform, seconds
from tflab.views.rviz_status import Display, LaserScan, MapCells, RobotModel, look_through, statuses_as_text

CHAIN = (("map", "odom"), ("odom", "base_link"))


def make_list(fixed_frame="map", without=(), links=("shoulder", "gripper"), moving=()):
    """Return RViz's list as text, for a robot of which some frames are not published."""
    buffer, parents = BufferCore(), {}
    edges = [*CHAIN, *(("base_link", link) for link in (*links, *moving)), ("base_link", "laser_frame")]
    for parent, child in edges:
        if child in without:
            continue
        parents.setdefault(parent, "")
        parents[child] = parent
        for at_s in (1.0, 9.0):
            buffer.set_transform(StampedTransform(parent, child, seconds(at_s), Transform((0.1, 0.0, 0.0))))

    def ask(target, source, stamp_ns):
        return buffer.lookup_transform(target, source, stamp_ns).transform

    displays = (
        Display("Map", (MapCells("map", seconds(5.0), [(1.0, 1.0)]),), "/map"),
        Display("RobotModel", RobotModel(dict.fromkeys(("base_link", *links, *moving, "laser_frame"), ())), ""),
        Display("LaserScan", (LaserScan("laser_frame", seconds(5.0), (1.0, 2.0), 0.0, 0.1),), "/scan"),
    )
    return statuses_as_text(look_through(fixed_frame, parents, displays, ask))
