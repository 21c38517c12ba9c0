"""E1.5: Which coordinates change?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Set, define_task

FRAMES = Choice(("map", "base_link", "laser_frame"), are_frames=True)

TASK = define_task(
    __file__, kind="M", points=3, answer="stays", form=Parts(dict.fromkeys(("ball", "cup", "lamp"), Set(FRAMES)))
)
