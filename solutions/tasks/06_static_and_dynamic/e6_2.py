"""E6.2: A mount on the command line."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Command, define_task

TOOL = "ros2 run tf2_ros static_transform_publisher"


def draw_mount(rng):
    """Draw a sensor mounted some centimetres ahead, to the right and up, rotated to the left."""
    ahead, right, up = (int(n) for n in rng.choice([7, 12, 15, 18, 22, 26, 31, 35], 3, replace=False))
    child = str(rng.choice(["camera_link", "laser_frame", "lidar_link", "radar_link", "imu_link", "sonar_link"]))
    return {"child": child, "ahead_cm": ahead, "right_cm": right, "up_cm": up,
            "turn_left_deg": int(rng.choice([25, 35, 50, 70, 110, 130]))}  # fmt: skip


def command_line(g, *, ends="parent first", length="m", side="right", places="as given", turn="left", angle="radians",
         about="yaw", style="options"):  # fmt: skip
    """Return the command line, step by step; other arguments are mistakes."""
    names = {"child first": (g.child, "base_link"), "map": ("map", g.child)}
    parent, child = names.get(ends, ("base_link", g.child))
    scale = {"m": 0.01, "cm": 1.0, "mm": 0.001}[length]
    x, y, z = g.ahead_cm * scale, g.right_cm * scale * (1 if side == "left" else -1), g.up_cm * scale
    z = g.up_cm if places == "up in cm" else z
    x = g.ahead_cm if places == "ahead in cm" else x
    y = -g.right_cm if places == "right in cm" else y
    if places == "y ahead":
        x, y = -y, x
    if places == "up second":
        x, y, z = x, z, y
    value = float(g.turn_left_deg) if angle == "degrees" else math.radians(g.turn_left_deg)
    value = {
        "half turns": g.turn_left_deg / 180,
        "tenths": round(math.radians(g.turn_left_deg), 1),
        "doubled": math.tau * g.turn_left_deg / 180,
        "twice": math.degrees(g.turn_left_deg),
    }.get(angle, value)
    value = -value if turn == "right" else value
    if about == "none":
        value, about = 0.0, "yaw"
    about = "qz" if style == "half" else about
    words = f"{TOOL} --x {x} --y {y} --z {z} --{about} {value} --frame-id {parent} --child-frame-id {child}"
    styles = {
        "equals": words.replace("--x ", "--x="),
        "bare": words.removeprefix("ros2 run tf2_ros "),
        "no parent": words.replace(f" --frame-id {parent}", ""),
    }
    return styles.get(style, words)


TASK = define_task(
    __file__, kind="C", points=3, answer="command", form=Command(), given=draw_mount, variants=6, model=command_line
)
