"""E7.1: Two joints to finish."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Urdf, define_task

from .draws import draw_centimetres

OPTICAL = (-math.pi / 2, 0.0, -math.pi / 2)


def draw_head(rng):
    """Draw a head whose lengths all differ, with no round angle."""
    ahead = draw_centimetres(rng, 8, 25)
    right = draw_centimetres(rng, 4, 15, (ahead,))
    up = draw_centimetres(rng, 30, 60, (ahead, right))
    return {
        "ahead_cm": ahead,
        "to_its_right_cm": right,
        "up_cm": up,
        "turned_to_the_right_deg": int(rng.integers(20, 70)),
        "lens_ahead_cm": draw_centimetres(rng, 1, 4),
    }


def origin(xyz, rpy):
    return f'<origin xyz="{" ".join(map(repr, xyz))}" rpy="{" ".join(map(repr, rpy))}"/>'


def make_joints(
    g,
    *,
    place="joint",
    ends="parent first",
    name="nod_joint",
    kind="revolute",
    length="m",
    side="right",
    order="x y z",
    angle="rad",
    way="right",
    about="its own",
    turns="once",
    hangs="camera_link",
    lens_length="m",
    lens="ahead",
    optical="turned",
):
    """Return the two joints, step by step; other arguments are mistakes."""
    scale = {"m": 0.01, "cm": 1.0, "mm": 10.0}[length]
    ahead, left, up = g.ahead_cm, -g.to_its_right_cm if side == "right" else g.to_its_right_cm, g.up_cm
    xyz = {"x y z": (ahead, left, up), "y first": (left, ahead, up), "z first": (up, left, ahead)}.get(order)
    yaw = g.turned_to_the_right_deg if angle == "deg" else math.radians(g.turned_to_the_right_deg)
    yaw = yaw if way == "left" else -yaw
    if order == "turned":
        xyz = (ahead * math.cos(yaw) - left * math.sin(yaw), ahead * math.sin(yaw) + left * math.cos(yaw), up)
    if lens == "in the head":
        xyz = (xyz[0] + g.lens_ahead_cm, *xyz[1:])
    rpy = {"once": (0.0, 0.0, yaw), "twice": (OPTICAL[0], 0.0, OPTICAL[2] + yaw), "none": (0.0, 0.0, 0.0),
           "roll": (yaw, 0.0, 0.0), "pitch": (0.0, yaw, 0.0), "at the lens": (0.0, 0.0, 0.0)}[turns]  # fmt: skip
    axes = {
        "its own": (0, 1, 0),
        "parent": (-math.sin(yaw), math.cos(yaw), 0),
        "z": (0, 0, 1),
        "x": (1, 0, 0),
        "upwards": (0, -1, 0),
    }
    lens_m = {"m": 0.01, "cm": 1.0, "mm": 10.0}[lens_length] * g.lens_ahead_cm
    lens_xyz = {
        "ahead": (lens_m, 0.0, 0.0),
        "z": (0.0, 0.0, lens_m),
        "y": (0.0, lens_m, 0.0),
        "behind": (-lens_m, 0.0, 0.0),
    }.get(lens, (0.0, 0.0, 0.0))
    turned = {
        "turned": OPTICAL,
        "not": (0.0, 0.0, 0.0),
        "back": (math.pi / 2, -math.pi / 2, 0.0),
        "deg": (-90.0, 0.0, -90.0),
        "plus": (math.pi / 2, 0.0, math.pi / 2),
        "yaw plus": (OPTICAL[0], 0.0, math.pi / 2),
        "roll plus": (math.pi / 2, 0.0, OPTICAL[2]),
        "roll": (OPTICAL[0], 0.0, 0.0),
        "yaw": (0.0, 0.0, OPTICAL[2]),
        "pitch": (0.0, OPTICAL[0], OPTICAL[2]),
        "pitch alone": (0.0, math.pi / 2, 0.0),
        "pitch up alone": (0.0, -math.pi / 2, 0.0),
    }
    quarter = {"to tenths": 1.5, "to tens of degrees": 1.6, "to hundredths": 1.57}.get(optical)
    turn = (-quarter, 0.0, -quarter) if quarter else turned[optical]
    turn = (turn[0], turn[1], turn[2] + yaw) if turns == "at the lens" else turn
    first, second = origin([scale * each for each in xyz], rpy), origin(lens_xyz, turn)
    painted = "" if place == "joint" else "<geometry><sphere radius='0.01'/></geometry>"
    parent, child = ("camera_link", "base_link") if ends == "child first" else ("base_link", "camera_link")
    visual = f'<link name="camera_link"><visual>{first}{painted}</visual></link>' if painted else ""
    return f"""
{visual}
<joint name="{name}" type="{kind}">
  <parent link="{parent}"/> <child link="{child}"/>
  {"" if painted else first}
  <axis xyz="{" ".join(map(repr, axes[about]))}"/>
</joint>
<joint name="optical_joint" type="fixed">
  <parent link="{hangs}"/> <child link="camera_optical_frame"/>
  {second}
</joint>"""


TASK = define_task(
    __file__,
    kind="T",
    points=5,
    answer="joints",
    form=Urdf(
        links=("camera_link", "camera_optical_frame"), joint="nod_joint", settings=(0.0, 0.4), tolerance_rad=5e-4
    ),
    given=draw_head,
    variants=6,
    model=make_joints,
)
