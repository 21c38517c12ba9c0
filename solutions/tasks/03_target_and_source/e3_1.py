"""E3.1: Four sentences, four calls."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Sequence, define_task

FRAMES = ("map", "odom", "base_link", "laser_frame", "camera_link", "camera_optical_frame")

SENTENCES = {
    "a": ["map", "laser_frame"],
    "b": ["base_link", "map"],
    "c": ["base_link", "camera_link"],
    "d": ["laser_frame", "base_link"],
}

TASK = define_task(
    __file__, kind="M", points=4, answer="calls", form=Parts({key: Sequence(Choice(FRAMES)) for key in SENTENCES})
)
