"""E1.5: Which coordinates change?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

FRAMES = ("map", "base_link", "laser_frame")
RIGHT = {
    **{f"ball in {frame}": "stays" if frame == "map" else "changes" for frame in FRAMES},
    **{f"cup in {frame}": "changes" if frame == "map" else "stays" for frame in FRAMES},
    **{f"lamp in {frame}": "changes" for frame in FRAMES},
}

TASK = define_task(
    __file__, kind="M", points=3, answer="numbers", form=Parts({name: Choice(("stays", "changes")) for name in RIGHT})
)
