"""How long does a panel take to follow its slider?  Milliseconds for each redraw.

    python benchmarks/panels.py

A redraw is everything that happens in Python between a slider's message and the
picture's bytes: the maths, moving the artists, drawing them, and the PNG.  On a
busy machine read the processor time, or the best: the median counts the waiting too.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable

from tflab.core import BufferCore, StampedTransform, Transform, seconds
from tflab.views import panels
from tflab.views.timeline import lane_from_history

TARGET_MS = 45.0
REDRAWS = 60


def main() -> None:
    """Print one line for each panel."""
    print(f"{'panel':<10} {'median':>9} {'best':>9} {'processor':>9}   target {TARGET_MS:.0f} ms")
    for name, (panel, drag) in made_panels().items():
        for step in range(3):
            drag(step / 3)
        walls_ms, processors_ms = zip(*(timed_ms(drag, step / REDRAWS) for step in range(REDRAWS)), strict=True)
        times_ms = (statistics.median(walls_ms), min(walls_ms), statistics.median(processors_ms))
        print(f"{name:<10} {' '.join(f'{time_ms:>6.1f} ms' for time_ms in times_ms)}")
        panel.close()


def timed_ms(drag: Callable[[float], None], part: float) -> tuple[float, float]:
    """Return the time that passed, and the processor's time, of one redraw [ms]."""
    wall_s, processor_s = time.perf_counter(), time.process_time()
    drag(part)
    return (time.perf_counter() - wall_s) * 1e3, (time.process_time() - processor_s) * 1e3


def made_panels() -> dict[str, tuple[panels.Panel, Callable[[float], None]]]:
    """Return each panel, and a function that moves its control to a part, 0 to 1, of its way."""
    buffer = buffer_of_a_robot()
    poses = {name: buffer.lookup_transform("map", name, seconds(3.0)).transform for name in buffer.frame_names()}
    lanes = [lane_from_history(buffer.history(frame)) for frame in ("odom", "base_link", "laser_frame")]
    timeline = panels.timeline_panel("map", "laser_frame", lanes, buffer.lookup_transform)
    sentence = panels.sentence_panel(poses, "map", "laser_frame")
    latency, rotation, cameras = panels.latency_panel(), panels.rotation_panel(), panels.cameras_panel()
    return {
        "latency": (latency, lambda part: move(latency, "yaw rate [rad/s]", part)),
        "timeline": (timeline, lambda part: move(timeline, "query [s]", part)),
        "rotation": (rotation, lambda part: move(rotation, "yaw [rad]", part)),
        "cameras": (cameras, lambda part: move(cameras, "left [m]", part)),
        "sentence": (sentence, lambda part: choose(sentence, part)),
    }


def move(panel: panels.Panel, description: str, part: float) -> None:
    slider = panel.controls[description]
    slider.value = slider.min + (part + 0.001) * (slider.max - slider.min)


def choose(panel: panels.Panel, part: float) -> None:
    menu = panel.controls["Python"]
    menu.index = (menu.index + 1) % len(menu.options)


def buffer_of_a_robot() -> BufferCore:
    """Return a buffer with map -> odom at 1 Hz, odom -> base_link at 20 Hz and a laser bolted on."""
    buffer = BufferCore()
    for i in range(6):
        buffer.set_transform(StampedTransform("map", "odom", seconds(1.0 + i), Transform((0.1 * i, 0.0, 0.0))))
    for i in range(90):
        pose = Transform.from_rpy(yaw=0.02 * i, translation=(0.05 * i, 0.0, 0.0))
        buffer.set_transform(StampedTransform("odom", "base_link", seconds(1.5 + 0.05 * i), pose))
    laser = StampedTransform("base_link", "laser_frame", 0, Transform((0.2, 0.0, 0.15)))
    buffer.set_transform(laser, is_static=True)
    return buffer


if __name__ == "__main__":
    main()
