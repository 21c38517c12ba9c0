"""E7.3: Forward kinematics."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Pose, define_task

from .draws import draw_sign, rotation_about


def joint(name, kind, xyz, rpy, axis):
    return {"name": name, "type": kind, "xyz": list(xyz), "rpy": list(rpy), "axis": axis}


def draw_positions(rng, low=0.1, high=0.6):
    return round(float(draw_sign(rng) * rng.uniform(low, high)), 2)


def draw_joint(rng, name, kind, axis):
    xyz, rpy = [draw_positions(rng) for _ in range(3)], [draw_positions(rng, 0.3, 1.2) for _ in range(3)]
    return joint(name, kind, xyz, rpy, axis)


def draw_chains(rng):
    """Draw arms of one to eight joints of all types and axes; positions in another order, one missing, one too many."""
    cases = []
    for kinds in (
        ("revolute", "fixed", "revolute"),
        ("fixed", "prismatic", "revolute", "fixed"),
        ("revolute", "prismatic", "prismatic"),
        ("revolute", "revolute", "fixed"),
    ):
        names = ["right/joint_d", "left/joint_d", "right/joint_a", "left/joint_c"][: len(kinds)]
        axes = list(rng.permutation(["x", "y", "z", "y"]))
        if kinds.count("prismatic") > 1:  # one slides along x, one along z
            axes = ["y", *rng.permutation(["x", "z"])]
        if kinds[:2] == ("revolute", "revolute"):  # one turns about x
            axes = [*rng.permutation(["x", "z"]), "y"]
        chain = [draw_joint(rng, *each) for each in zip(names, kinds, map(str, axes), strict=False)]
        moving = [each["name"] for each in chain if each["type"] != "fixed"]
        positions = {name: draw_positions(rng, 0.2, 1.1) for name in reversed(moving)}
        cases.append((chain, positions))
    chain, positions = cases[0]
    cases.append((chain, {name: positions[name] for name in list(positions)[:1]}))  # one stands at zero
    cases.append((chain, {name: positions[name] for name in list(positions)[-1:]}))  # and one behind it, at zero
    cases.append((cases[3][0], {}))
    cases.append((chain[:1], {chain[0]["name"]: 0.7, "somebody_else": 1.0}))
    fixed, tip = draw_joint(rng, "weld", "fixed", "z"), draw_joint(rng, "tip", "fixed", "x")
    cases.append(([fixed, *cases[2][0], tip], {**cases[2][1], "weld": 0.5}))  # a fixed joint has no position
    names = [f"arm/joint_{letter}" for letter in "hgfedcba"]
    chain = [draw_joint(rng, name, "revolute", str(rng.choice(["x", "y", "z"]))) for name in names]
    return [*cases, (chain, {name: draw_positions(rng) for name in names[::2]})]


def walk_chain(
    chain,
    positions,
    *,
    names="by name",
    order="origin first",
    product="onwards",
    turn="rad",
    kinds="by type",
    rotation="rpy",
    frames="each in its parent",
    fixed="stays",
    axis="its own",
):
    """Return base_T_tip, joint by joint; other steps are the mistakes."""
    pose, moved = Transform(), 0
    for number, each in enumerate(chain):
        rpy = each["rpy"][::-1] if rotation == "ypr" else (0.0, 0.0, 0.0) if rotation == "none" else each["rpy"]
        origin = Transform.from_rpy(*rpy, translation=tuple(each["xyz"]))
        if rotation == "before xyz":
            origin = Transform(Transform(rotation=origin.rotation).apply(each["xyz"]), origin.rotation)
        at = positions.get(each["name"], 0.0)
        if names == "by order":
            values = list(positions.values())
            at = values[moved] if each["type"] != "fixed" and moved < len(values) else 0.0
            moved += each["type"] != "fixed"
        if names == "by place":
            values = list(positions.values())
            at = values[number] if number < len(values) else 0.0
        if _is_left_out(each, positions, names):
            continue
        if fixed == "left out" and each["type"] == "fixed":
            continue
        if rotation == "replaced" and each["type"] == "revolute":
            origin = Transform(tuple(each["xyz"]))
        if rotation == "xyz left out":
            origin = Transform.from_rpy(*each["rpy"])
        if order == "added to rpy" and each["type"] == "revolute":
            rpy = [
                angle + (at if letter == each["axis"] else 0.0)
                for angle, letter in zip(each["rpy"], "xyz", strict=True)
            ]
            pose = pose @ Transform.from_rpy(*rpy, translation=tuple(each["xyz"]))
            continue
        if order in ("added to xyz", "added to both") and each["type"] != "fixed":
            pose = pose @ _added(each, at, order)
            continue
        movement = _movement(each, at, turn, kinds, fixed, axis)
        step = movement @ origin if order == "movement first" else origin @ movement
        if frames == "in the base":
            steps = [pose.translation, each["xyz"], movement.translation]
            pose = Transform(tuple(map(sum, zip(*steps, strict=True))), (pose @ step).rotation)
            continue
        if frames == "steps added" and number:
            place = tuple(a + b for a, b in zip(pose.translation, step.translation, strict=True))
            pose = Transform(place, (pose @ step).rotation)
        else:
            pose = step @ pose if product == "backwards" else pose @ step
    return pose


def _is_left_out(each, positions, names):
    is_unnamed = each["name"] not in positions
    return is_unnamed and (names == "named alone" or (names == "unnamed left out" and each["type"] != "fixed"))


def _added(each, at, order):
    """Return a joint whose position is added to the numbers of its origin."""
    more = [at if letter == each["axis"] else 0.0 for letter in "xyz"]
    xyz, rpy = each["xyz"], each["rpy"]
    if each["type"] == "prismatic":
        return Transform.from_rpy(*rpy, translation=tuple(a + b for a, b in zip(xyz, more, strict=True)))
    if order == "added to both":
        return Transform.from_rpy(*(a + b for a, b in zip(rpy, more, strict=True)), translation=tuple(xyz))
    return Transform.from_rpy(*rpy, translation=tuple(xyz)) @ rotation_about(each["axis"], at)


def _movement(each, at, turn, kinds, fixed, axis):
    if each["type"] == "fixed" and fixed == "stays":
        return Transform()
    at = -at if turn == "other way" else math.radians(at) if turn == "deg, all" else at
    if turn in ("turns other way", "slides other way"):
        at = -at if (each["type"] == "prismatic") == (turn == "slides other way") else at
    if kinds == "never turns" and each["type"] == "revolute":
        return Transform()
    if kinds == "all slide":
        return Transform(tuple(at if letter == each["axis"] else 0.0 for letter in "xyz"))
    if axis == "turned round" and each["type"] == "revolute":
        return rotation_about({"x": "z", "y": "y", "z": "x"}[each["axis"]], at)
    if each["type"] == "fixed" and fixed == "slides":
        return Transform(tuple(at if letter == each["axis"] else 0.0 for letter in "xyz"))
    about = (
        "z"
        if axis == "always z" or (axis in ("turns about z", "z and x") and each["type"] != "prismatic")
        else each["axis"]
    )
    about = axis[-1] if axis in ("always x", "always y") else about
    about = "x" if axis in ("slides along x", "z and x") and each["type"] == "prismatic" else about
    about = "z" if axis == "slides along z" and each["type"] == "prismatic" else about
    if each["type"] == "prismatic" and kinds in ("by type", "never turns"):
        return Transform(tuple(at if letter == about else 0.0 for letter in "xyz"))
    if kinds == "never slides" and each["type"] == "prismatic":
        return Transform()
    return rotation_about(about, math.radians(at) if turn == "deg" else at)


def add_numbers(chain, positions):
    """Return the sum of all offsets and angles, as if the chain were one joint."""
    place, angles = [0.0] * 3, [0.0] * 3
    for each in chain:
        at = positions.get(each["name"], 0.0)
        for number, letter in enumerate("xyz"):
            moved = at if letter == each["axis"] else 0.0
            place[number] += each["xyz"][number] + (moved if each["type"] == "prismatic" else 0.0)
            angles[number] += each["rpy"][number] + (moved if each["type"] == "revolute" else 0.0)
    return Transform.from_rpy(*angles, translation=tuple(place))


ANSWERS = {
    "not moved": lambda chain, positions: walk_chain(chain, {}),
    "origins left out": lambda chain, positions: walk_chain(
        [{**each, "xyz": [0.0, 0.0, 0.0], "rpy": [0.0, 0.0, 0.0]} for each in chain], positions
    ),
    "last joint": lambda chain, positions: walk_chain(chain[-1:], positions),
    "first joint left out": lambda chain, positions: walk_chain(chain[1:] or chain[:0], positions),
    "first joint alone": lambda chain, positions: walk_chain(chain[:1], positions),
    "last joint dropped": lambda chain, positions: walk_chain(chain[:-1], positions),
    "ends with the positions": lambda chain, positions: walk_chain(
        chain[: len(positions)], positions, names="by place"
    ),
    "last movement left out": lambda chain, positions: walk_chain(
        chain, {name: at for name, at in positions.items() if not chain or name != chain[-1]["name"]}
    ),
    "numbers added": add_numbers,
}

TASK = define_task(
    __file__,
    kind="F",
    points=5,
    answer="fk",
    form=Pose(),
    inputs=draw_chains,
    variants=3,
    model=walk_chain,
    answers=ANSWERS,
)
