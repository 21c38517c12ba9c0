"""The tasks of chapter 03: which way does a transform work, and how does one turn it round?

Every twin is one sentence that people say: "from A to B", "just flip the sign",
"the order of a product does not matter".
"""

from __future__ import annotations

import math

import numpy as np

from tflab.core import LATEST, StampedTransform, Transform
from tflab.ros.messages import geometry_msgs
from tflab.views.sentence import echo_text
from tflab.workbook.answers.forms import Angle, Choice, Message, Number, Parts, Sequence, Vector
from tflab.workbook.tasks.task import Task, Twin, Words

FRAMES = ("map", "odom", "base_link", "laser_frame", "camera_link", "camera_optical_frame")
PLANAR = Parts({"x": Number("m"), "y": Number("m"), "yaw": Angle()})

# -- what is drawn ------------------------------------------------------------


def some_yaw_degrees(rng: np.random.Generator) -> int:
    """Return a turn that nobody can overlook: 20 to 70 or 110 to 160 degrees, to either side."""
    size = rng.choice([rng.integers(20, 71), rng.integers(110, 161)])
    return int(size * rng.choice([-1, 1]))


def some_mount(rng: np.random.Generator) -> Transform:
    """Return where a sensor is bolted on: ahead, aside, above, and turned."""
    ahead, aside, above = rng.integers(15, 60) / 100, rng.choice([-1, 1]) * rng.integers(8, 30) / 100, 0.15
    return Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(ahead, aside, above))


def some_planar(rng: np.random.Generator) -> dict[str, float]:
    """Return a pose in the plane."""
    x, y = (float(rng.choice([-1, 1]) * rng.integers(50, 400) / 100) for _ in range(2))
    return {"x": x, "y": y, "yaw": round(math.radians(some_yaw_degrees(rng)), 4)}


def added(*points) -> tuple[float, ...]:
    """Return the sum of points, one number after the other."""
    return tuple(map(sum, zip(*points, strict=True)))


# -- E3.1 ---------------------------------------------------------------------

SENTENCES = {
    "a": ["map", "laser_frame"],
    "b": ["base_link", "map"],
    "c": ["base_link", "camera_link"],
    "d": ["laser_frame", "base_link"],
}
PARENT_FIRST = {
    "a": ["map", "laser_frame"],
    "b": ["map", "base_link"],
    "c": ["base_link", "camera_link"],
    "d": ["base_link", "laser_frame"],
}

# -- E3.2 ---------------------------------------------------------------------


def corner_given(rng: np.random.Generator) -> dict[str, object]:
    x, y = rng.integers(200, 600, size=2) / 100
    map_T_base = Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(x, y, 0.1))
    point = (rng.integers(150, 400) / 100, rng.choice([-1, 1]) * rng.integers(30, 120) / 100, 0.0)
    return {"map_T_base": map_T_base, "base_T_laser": some_mount(rng), "laser_p_corner": tuple(map(float, point))}


def corner_swapped(given) -> dict[str, tuple]:
    map_T_laser = given.map_T_base @ given.base_T_laser
    point = given.laser_p_corner
    return {"base_link": given.base_T_laser.inverse().apply(point), "map": map_T_laser.inverse().apply(point)}


def corner_without_turns(given) -> dict[str, tuple]:
    base_p = added(given.laser_p_corner, given.base_T_laser.translation)
    return {"base_link": base_p, "map": added(base_p, given.map_T_base.translation)}


def corner_step_first(given) -> dict[str, tuple]:
    mount, robot = given.base_T_laser, given.map_T_base
    base_p = turned(mount, added(given.laser_p_corner, mount.translation))
    return {"base_link": base_p, "map": turned(robot, added(base_p, robot.translation))}


def corner_reversed_product(given) -> dict[str, tuple]:
    product = given.base_T_laser @ given.map_T_base
    return {"base_link": given.base_T_laser.apply(given.laser_p_corner), "map": product.apply(given.laser_p_corner)}


def corner_skips_the_laser(given) -> dict[str, tuple]:
    point = given.laser_p_corner
    return {"base_link": given.base_T_laser.apply(point), "map": given.map_T_base.apply(point)}


def corner_inverse_carried_on(given) -> dict[str, tuple]:
    base_p = given.base_T_laser.inverse().apply(given.laser_p_corner)
    return {"base_link": base_p, "map": given.map_T_base.apply(base_p)}


def corner_leaves_the_map(given) -> dict[str, tuple]:
    base_p = given.base_T_laser.apply(given.laser_p_corner)
    return {"base_link": base_p, "map": given.map_T_base.inverse().apply(base_p)}


def corner_both_inverted(given) -> dict[str, tuple]:
    base_p = given.base_T_laser.inverse().apply(given.laser_p_corner)
    return {"base_link": base_p, "map": given.map_T_base.inverse().apply(base_p)}


def corner_is_the_laser(given) -> dict[str, tuple]:
    map_T_laser = given.map_T_base @ given.base_T_laser
    return {"base_link": given.base_T_laser.translation, "map": map_T_laser.translation}


def turned(transform: Transform, point) -> tuple[float, ...]:
    """Return a point turned by a transform's rotation alone."""
    return Transform(rotation=transform.rotation).apply(point)


# -- E3.3 and E3.4 ------------------------------------------------------------


def invert_inputs(rng: np.random.Generator) -> list[tuple]:
    straight = {"x": 2.0, "y": 1.0, "yaw": 0.0}
    on_the_spot = {"x": 0.0, "y": 0.0, "yaw": round(float(rng.uniform(0.4, 1.2)), 4)}
    return [(some_planar(rng),), (some_planar(rng),), (some_planar(rng),), (some_planar(rng),), (straight,),
            (on_the_spot,)]  # fmt: skip


def moved(pose: dict, x: float, y: float, yaw: float) -> dict[str, float]:
    """Return where a pose lies after a turn about the origin by its yaw."""
    c, s = math.cos(yaw), math.sin(yaw)
    return {"x": c * x - s * y, "y": s * x + c * y, "yaw": pose["yaw"]}


def sign_only(a_pose_b: dict) -> dict[str, float]:
    return {"x": -a_pose_b["x"], "y": -a_pose_b["y"], "yaw": -a_pose_b["yaw"]}


def sign_and_same_turn(a_pose_b: dict) -> dict[str, float]:
    return {"x": -a_pose_b["x"], "y": -a_pose_b["y"], "yaw": a_pose_b["yaw"]}


def turn_kept(a_pose_b: dict) -> dict[str, float]:
    return moved(a_pose_b, -a_pose_b["x"], -a_pose_b["y"], -a_pose_b["yaw"])


def x_overwritten(a_pose_b: dict) -> dict[str, float]:
    yaw, x, y = -a_pose_b["yaw"], -a_pose_b["x"], -a_pose_b["y"]
    x = math.cos(yaw) * x - math.sin(yaw) * y
    y = math.sin(yaw) * x + math.cos(yaw) * y
    return {"x": x, "y": y, "yaw": yaw}


def radians_twice(a_pose_b: dict) -> dict[str, float]:
    return moved({"yaw": -a_pose_b["yaw"]}, -a_pose_b["x"], -a_pose_b["y"], -math.radians(a_pose_b["yaw"]))


def turned_on(a_pose_b: dict) -> dict[str, float]:
    back = {"yaw": -a_pose_b["yaw"]}
    return moved(back, -a_pose_b["x"], -a_pose_b["y"], a_pose_b["yaw"])


def not_taken_off(a_pose_b: dict) -> dict[str, float]:
    back = {"yaw": -a_pose_b["yaw"]}
    return moved(back, a_pose_b["x"], a_pose_b["y"], -a_pose_b["yaw"])


def compose_inputs(rng: np.random.Generator) -> list[tuple]:
    nothing = {"x": 0.0, "y": 0.0, "yaw": 0.0}
    pairs = [(some_planar(rng), some_planar(rng)) for _ in range(4)]
    return [*pairs, (some_planar(rng), nothing), (nothing, some_planar(rng))]


def composed(outer: dict, inner: dict, turn: float) -> dict[str, float]:
    """Return `outer` and `inner` put together, with the step of `inner` turned by `turn` [rad]."""
    step = moved(outer, inner["x"], inner["y"], turn)
    return {"x": outer["x"] + step["x"], "y": outer["y"] + step["y"], "yaw": outer["yaw"] + inner["yaw"]}


def other_order(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(b_pose_c, a_pose_b, b_pose_c["yaw"])


def only_added(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, 0.0)


def turned_the_other_way(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, -a_pose_b["yaw"])


def turned_by_both(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, a_pose_b["yaw"] + b_pose_c["yaw"])


def added_then_turned(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    step = moved(a_pose_b, a_pose_b["x"] + b_pose_c["x"], a_pose_b["y"] + b_pose_c["y"], a_pose_b["yaw"])
    return step | {"yaw": a_pose_b["yaw"] + b_pose_c["yaw"]}


def yaws_not_added(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, a_pose_b["yaw"]) | {"yaw": b_pose_c["yaw"]}


def turned_by_the_second(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, b_pose_c["yaw"])


def first_step_lost(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    step = moved(a_pose_b, b_pose_c["x"], b_pose_c["y"], a_pose_b["yaw"])
    return step | {"yaw": a_pose_b["yaw"] + b_pose_c["yaw"]}


# -- E3.5 ---------------------------------------------------------------------


def echo_given(rng: np.random.Generator) -> dict[str, str]:
    return {"echo": echo_text(StampedTransform("base_link", "laser_frame", LATEST, some_mount(rng)))}


def echoed(given) -> tuple[Transform, float]:
    """Return the transform that was printed, and its yaw [rad]."""
    rows = [line.split("[")[1].rstrip("]").split(", ") for line in given.echo.splitlines()[1:4]]
    yaw = float(rows[2][2])
    return Transform.from_rpy(yaw=yaw, translation=tuple(map(float, rows[0]))), yaw


def echo_answer(laser_in_base, base_in_laser, yaw_back) -> dict[str, object]:
    return {"laser_in_base": laser_in_base, "base_in_laser": base_in_laser, "yaw_back": yaw_back}


def echo_swapped(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.inverse().translation, mount.translation, yaw)


def echo_sign_only(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, tuple(-value for value in mount.translation), -yaw)


def echo_turned_on(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, turned(mount, tuple(-value for value in mount.translation)), -yaw)


def echo_not_taken_off(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, turned(mount.inverse(), mount.translation), -yaw)


def echo_same_yaw(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, mount.inverse().translation, yaw)


def echo_height_kept(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    back = mount.inverse().translation
    return echo_answer(mount.translation, (back[0], back[1], -back[2]), -yaw)


def echo_yaw_in_degrees(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, mount.inverse().translation, round(math.degrees(-yaw)))


# -- E3.6 ---------------------------------------------------------------------


def mount_inputs(rng: np.random.Generator) -> list[tuple]:
    cases = [(int(rng.integers(5, 40)) / 100, int(rng.integers(20, 60)) / 100, some_yaw_degrees(rng)) for _ in range(4)]
    return [*cases, (0.10, 0.30, 0), (0.10, 0.30, 90)]


def camera_message(parent: str, child: str, ahead_m: float, up_m: float, xyzw) -> geometry_msgs.TransformStamped:
    t = geometry_msgs.TransformStamped()
    t.header.frame_id, t.child_frame_id = parent, child
    t.transform.translation.x, t.transform.translation.z = float(ahead_m), float(up_m)
    q = t.transform.rotation
    q.x, q.y, q.z, q.w = map(float, xyzw)
    return t


def half_turn(yaw: float) -> tuple[float, float]:
    return math.sin(yaw / 2), math.cos(yaw / 2)


def parent_and_child_swapped(ahead_m, up_m, yaw_deg):
    z, w = half_turn(math.radians(yaw_deg))
    return camera_message("camera_link", "base_link", ahead_m, up_m, (0, 0, z, w))


def in_degrees(ahead_m, up_m, yaw_deg):
    z, w = half_turn(yaw_deg)
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, w))


def without_the_half(ahead_m, up_m, yaw_deg):
    z, w = half_turn(2 * math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, w))


def w_first(ahead_m, up_m, yaw_deg):
    z, w = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (w, 0, 0, z))


def to_the_right(ahead_m, up_m, yaw_deg):
    z, w = half_turn(-math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, w))


def not_turned(ahead_m, up_m, yaw_deg):
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, 0, 1))


def rolled(ahead_m, up_m, yaw_deg):
    x, w = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (x, 0, 0, w))


def angle_in_z(ahead_m, up_m, yaw_deg):
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, math.radians(yaw_deg), 1))


def w_still_one(ahead_m, up_m, yaw_deg):
    z, _ = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, 1))


def ahead_and_up_swapped(ahead_m, up_m, yaw_deg):
    z, w = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", up_m, ahead_m, (0, 0, z, w))


def zero_quaternion(ahead_m, up_m, yaw_deg):
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, 0, 0))


# -- E3.7 ---------------------------------------------------------------------

NODES = ("node_a", "node_b", "node_c")
ROBOTS = (
    "stops for the wrong things",
    "drives to another place",
    "is drawn where it is not",
    "stops with an exception",
)
HIDDEN = ("it stands still", "it stands on the map's origin, not turned", "the goal is far away")


def blamed(node: str, robot: str, hidden_while: str = HIDDEN[1]) -> dict[str, str]:
    return {"node": node, "robot": robot, "hidden_while": hidden_while}


# -- all of them --------------------------------------------------------------

TASKS = (
    Task(
        id="E3.1",
        kind="M",
        points=4,
        title=Words(en="Four sentences, four calls", ko="문장 네 개, 호출 네 개"),
        answer="calls",
        form=Parts({key: Sequence(Choice(FRAMES)) for key in SENTENCES}),
        twins=(
            Twin(
                "swapped",
                {key: pair[::-1] for key, pair in SENTENCES.items()},
                Words(
                    en="where it is wrong, you wrote [source, target]. In the call, the frame in which you want the "
                    "data comes first.",
                    ko="틀린 답은 순서가 뒤집혔습니다. [원본, 목표] 순서로 썼습니다. 호출에서는 데이터를 보고 싶은 좌표계가 "
                    "먼저 옵니다.",
                ),
                "M1",
            ),
            Twin(
                "where_is_it",
                SENTENCES | {"c": SENTENCES["c"][::-1]},
                Words(
                    en='only c is the wrong way round. "Where is it?" asks for its own origin, which is written in '
                    "`camera_link`; in which frame do you want it?",
                    ko='c만 순서가 뒤집혔습니다. "어디에 있습니까?"는 그 원점을 묻는 말이고, 원점은 `camera_link` 기준입니다. '
                    "그것을 어느 좌표계 기준으로 보고 싶습니까?",
                ),
                "M1",
            ),
            Twin(
                "parent_first",
                PARENT_FIRST,
                Words(
                    en="where it is wrong, you put the parent first. Target and source have nothing to do with who is whose "
                    "parent: in b and d the data is wanted farther down the tree. Say each sentence aloud.",
                    ko="틀린 곳에서는 부모를 앞에 두었습니다. 목표와 원본은 누가 누구의 부모인지와 상관없습니다. b와 d는 트리 "
                    "아래쪽에서 데이터를 보고 싶은 경우입니다. 문장을 하나씩 소리 내어 읽어 보십시오.",
                ),
                "M2",
            ),
        ),
        hints=(
            Words(
                en='Turn each one into "data written in …, wanted in …".',
                ko='하나씩 "… 기준 데이터를 … 기준으로 보고 싶다"로 바꿔 보십시오.',
            ),
            Words(
                en="`lookup_transform(target, source, time)`: wanted in first, written in second.",
                ko="`lookup_transform(target, source, time)`입니다. 보고 싶은 기준이 먼저, 지금 기준이 다음입니다.",
            ),
            Words(
                en='"Where is X, seen from Y?" asks for X\'s own origin: written in X, wanted in Y.',
                ko='"Y에서 볼 때 X는 어디인가?"는 X의 원점을 묻습니다. X 기준인 점을 Y 기준으로 보고 싶은 것입니다.',
            ),
        ),
        cures=("M1", "M2"),
    ),
    Task(
        id="E3.2",
        kind="N",
        points=4,
        title=Words(en="A corner seen by a turned laser", ko="돌려 단 레이저가 본 모서리"),
        answer="corner",
        form=Parts({"base_link": Vector(3, "m", "base_link", 0.005), "map": Vector(3, "m", "map", 0.005)}),
        given=corner_given,
        variants=6,
        twins=(
            Twin(
                "swapped",
                corner_swapped,
                Words(
                    en="target and source are swapped: you used an inverse. `base_T_laser` already takes laser data to "
                    "the base, and a row of dominoes that match needs no inverse either; check it with the laser's own "
                    "origin, (0, 0, 0).",
                    ko="목표와 원본이 바뀌었습니다. 역변환을 썼습니다. `base_T_laser`가 이미 레이저 데이터를 베이스로 옮기고, "
                    "이웃이 맞는 도미노에도 역변환은 필요 없습니다. 레이저의 원점 (0, 0, 0)을 넣어 확인해 보십시오.",
                ),
                "M1",
            ),
            Twin(
                "both_inverted",
                corner_both_inverted,
                Words(
                    en="you inverted both transforms, one after the other. As they stand, `base_T_laser` takes laser "
                    "data to the base and `map_T_base` takes it on to the map: read each name from right to left.",
                    ko="두 변환을 모두 뒤집어 차례로 적용했습니다. 그대로 두면 `base_T_laser`는 레이저 데이터를 베이스로, "
                    "`map_T_base`는 그것을 지도로 옮깁니다. 이름을 오른쪽에서 왼쪽으로 읽어 보십시오.",
                ),
                "M1",
            ),
            Twin(
                "the_laser_itself",
                corner_is_the_laser,
                Words(
                    en="that is where the laser sits; the corner has not come into it yet. Give `laser_p_corner` to "
                    "`.apply(...)`.",
                    ko="그것은 레이저가 달린 자리입니다. 모서리가 아직 들어가지 않았습니다. `.apply(...)`에 `laser_p_corner`를 "
                    "넣으십시오.",
                ),
            ),
            Twin(
                "turn_ignored",
                corner_without_turns,
                Words(
                    en="you added the steps and left out the turns. That is right only for a sensor that looks "
                    "straight ahead on a robot that does, too.",
                    ko="이동만 더하고 회전을 빠뜨렸습니다. 센서도 로봇도 정면을 볼 때만 맞습니다.",
                ),
                "M3",
            ),
            Twin(
                "step_before_turn",
                corner_step_first,
                Words(
                    en="you added the step first and turned the sum. The step is measured in the parent, so it is not "
                    "turned: turn the point, then add the step.",
                    ko="이동을 먼저 더하고 그 합을 돌렸습니다. 이동은 부모에서 잰 값이므로 돌리지 않습니다. 점을 돌린 "
                    "다음에 이동을 더하십시오.",
                ),
            ),
            Twin(
                "product_reversed",
                corner_reversed_product,
                Words(
                    en="the first is right. In the product for `map`, the dominoes do not match: which halves touch in "
                    "`base_T_laser @ map_T_base`?",
                    ko="첫째는 맞습니다. `map`을 구한 곱에서는 도미노가 맞지 않습니다. `base_T_laser @ map_T_base`에서 "
                    "맞닿은 두 칸은 무엇과 무엇입니까?",
                ),
            ),
            Twin(
                "an_edge_skipped",
                corner_skips_the_laser,
                Words(
                    en="the first is right. For `map` you applied `map_T_base` to a point that is written in the "
                    "laser: one domino is missing.",
                    ko="첫째는 맞습니다. `map`을 구할 때는 레이저 기준 점에 `map_T_base`를 적용했습니다. 도미노 하나가 "
                    "빠졌습니다.",
                ),
            ),
            Twin(
                "inverse_carried_on",
                corner_inverse_carried_on,
                Words(
                    en="the way on to `map` is right, the way to `base_link` is not: you took the inverse of "
                    "`base_T_laser`. Which frame's points does it take in, as it stands?",
                    ko="`map`으로 이어 가는 방법은 맞지만 `base_link`로 가는 방법이 틀립니다. `base_T_laser`의 역변환을 썼습니다. "
                    "`base_T_laser`는 그대로 둘 때 어느 좌표계 기준인 점을 받습니까?",
                ),
                "M1",
            ),
            Twin(
                "out_of_the_map",
                corner_leaves_the_map,
                Words(
                    en="the first is right. For `map` you used the inverse of `map_T_base`, which takes points out of "
                    "the map; you want the corner in it.",
                    ko="첫째는 맞습니다. `map`을 구할 때는 `map_T_base`의 역변환을 썼는데, 그것은 map 기준인 점을 로봇 기준으로 "
                    "옮깁니다. 원하는 것은 map 기준인 모서리입니다.",
                ),
                "M1",
            ),
        ),
        hints=(
            Words(
                en="Two questions, two sentences: written in laser, wanted in base; written in laser, wanted in map.",
                ko="질문이 두 개이니 문장도 두 개입니다. 레이저 기준을 베이스 기준으로, 레이저 기준을 지도 기준으로.",
            ),
            Words(
                en="A transform `a_T_b` has `.apply(point)` for a point written in b, and `@` joins two that match.",
                ko="변환 `a_T_b`에는 b 기준 점을 받는 `.apply(점)`이 있고, 이웃이 맞는 둘은 `@`로 잇습니다.",
            ),
            Words(
                en="Lay the dominoes: [map|base][base|laser], and the point of the laser at the right end.",
                ko="도미노를 놓아 보십시오. [map|base][base|laser], 그리고 오른쪽 끝에 레이저의 점입니다.",
            ),
        ),
        cures=("M1", "M3"),
    ),
    Task(
        id="E3.3",
        kind="F",
        points=4,
        title=Words(en="The way back", ko="돌아가는 길"),
        answer="invert",
        form=PLANAR,
        inputs=invert_inputs,
        variants=3,
        twins=(
            Twin(
                "sign_only",
                sign_only,
                Words(
                    en="the step has only got a minus sign. It is measured along a's axes; you need it along b's, "
                    "which are turned. Without a turn you are right, and only then.",
                    ko="이동에 마이너스만 붙였습니다. 그 이동은 a의 축을 따라 잰 값인데, 필요한 것은 돌아가 있는 b의 축을 "
                    "따라 잰 값입니다. 회전이 없을 때만 맞습니다.",
                ),
                "M3",
            ),
            Twin(
                "same_turn",
                sign_and_same_turn,
                Words(
                    en="the turn has not changed at all: going back, one turns back. And the step needs more than a "
                    "minus sign.",
                    ko="회전이 그대로입니다. 돌아갈 때는 반대로 돌려야 합니다. 이동도 부호만 바꿔서는 모자랍니다.",
                ),
                "M3",
            ),
            Twin(
                "turned_on",
                turned_on,
                Words(
                    en="you turned the step, but the wrong way: by yaw instead of by minus yaw. Try it with a quarter "
                    "turn to the left and stand up.",
                    ko="이동을 돌리기는 했는데 방향이 반대입니다. −yaw가 아니라 yaw로 돌렸습니다. 왼쪽으로 90° 돌린 경우를 "
                    "일어서서 직접 해 보십시오.",
                ),
            ),
            Twin(
                "not_taken_off",
                not_taken_off,
                Words(
                    en="the turn is right, and the step has kept its sign: from b, the origin of a lies on the other "
                    "side.",
                    ko="회전은 맞지만 이동의 부호가 그대로입니다. b에서 보면 a의 원점은 반대쪽에 있습니다.",
                ),
            ),
            Twin(
                "turn_kept",
                turn_kept,
                Words(
                    en="`x` and `y` are right. The yaw has not changed: going back, one turns back.",
                    ko="`x`와 `y`는 맞습니다. yaw가 그대로입니다. 돌아갈 때는 반대로 돌려야 합니다.",
                ),
                "M3",
            ),
            Twin(
                "x_overwritten",
                x_overwritten,
                Words(
                    en="`x` is right. For `y` you used the new `x`, which had just been overwritten; both need the old "
                    "ones. Give the results other names.",
                    ko="`x`는 맞습니다. `y`를 구할 때 방금 덮어쓴 새 `x`를 썼습니다. 둘 다 원래 값으로 계산해야 합니다. 결과에는 "
                    "다른 이름을 붙이십시오.",
                ),
            ),
            Twin(
                "radians_twice",
                radians_twice,
                Words(
                    en="the step has hardly turned: the yaw comes in radians already, and you converted it once more.",
                    ko="이동이 거의 돌지 않았습니다. yaw는 이미 라디안인데 한 번 더 바꾸었습니다.",
                ),
                "M5",
            ),
        ),
        hints=(
            Words(
                en="Going there is: turn by yaw, then step by (x, y). Going back undoes the last thing first.",
                ko="가는 길은 yaw만큼 돌고 (x, y)만큼 옮기는 것입니다. 돌아갈 때는 나중에 한 것부터 되돌립니다.",
            ),
            Words(
                en="(−x, −y) takes the step off, along a's axes. Along b's axes it looks different: b is turned.",
                ko="(−x, −y)는 a의 축을 따라 이동을 되돌립니다. b는 돌아가 있으므로 b의 축을 따르면 값이 달라집니다.",
            ),
            Words(
                en="Turn (−x, −y) by −yaw: in the formula, u is −x, v is −y, and the angle is −yaw.",
                ko="(−x, −y)를 −yaw만큼 돌리십시오. 공식에서 u는 −x, v는 −y, 각도는 −yaw입니다.",
            ),
        ),
        cures=("M3",),
    ),
    Task(
        id="E3.4",
        kind="F",
        points=4,
        title=Words(en="Two dominoes into one", ko="도미노 둘을 하나로"),
        answer="compose",
        form=PLANAR,
        inputs=compose_inputs,
        variants=3,
        twins=(
            Twin(
                "other_order",
                other_order,
                Words(
                    en="you put them together in the other order: b_pose_c first, then a_pose_b. Lay the dominoes: "
                    "[a|b][b|c].",
                    ko="순서를 바꿔 이었습니다. b_pose_c가 먼저, a_pose_b가 나중입니다. 도미노를 놓아 보십시오. [a|b][b|c]",
                ),
            ),
            Twin(
                "only_added",
                only_added,
                Words(
                    en="you added the steps as they are. The second step is measured along b's axes, and b is turned "
                    "in a.",
                    ko="이동을 그대로 더했습니다. 둘째 이동은 b의 축을 따라 잰 값이고, b는 a 안에서 돌아가 있습니다.",
                ),
                "M3",
            ),
            Twin(
                "turned_back",
                turned_the_other_way,
                Words(
                    en="the second step is turned the wrong way. b data goes to a with b's yaw, as it stands.",
                    ko="둘째 이동을 반대로 돌렸습니다. b의 데이터는 b의 yaw 그대로 돌려서 a로 옮깁니다.",
                ),
                "M1",
            ),
            Twin(
                "turned_by_the_second",
                turned_by_the_second,
                Words(
                    en="you turned the second step by its own yaw. It is b that is turned in a: which of the two yaws "
                    "says by how much?",
                    ko="둘째 이동을 자기 yaw로 돌렸습니다. a 안에서 돌아가 있는 것은 b입니다. 그 각도는 두 yaw 가운데 "
                    "어느 것입니까?",
                ),
            ),
            Twin(
                "turned_by_both",
                turned_by_both,
                Words(
                    en="you turned the second step by both yaws. It is measured along b's axes; c's own yaw turns what "
                    "comes after c.",
                    ko="둘째 이동을 두 yaw의 합만큼 돌렸습니다. 둘째 이동은 b의 축을 따라 잰 값입니다. c의 yaw는 c 다음에 오는 "
                    "것을 돌립니다.",
                ),
            ),
            Twin(
                "added_then_turned",
                added_then_turned,
                Words(
                    en="you added the steps and then turned the sum. The first step is measured in a already, so "
                    "nobody turns it.",
                    ko="이동을 더한 다음 합을 돌렸습니다. 첫째 이동은 이미 a에서 잰 값이므로 돌리지 않습니다.",
                ),
            ),
            Twin(
                "first_step_lost",
                first_step_lost,
                Words(
                    en="you turned the second step rightly and forgot to add the first: b itself does not lie at a's "
                    "origin.",
                    ko="둘째 이동은 바르게 돌렸지만 첫째 이동을 더하지 않았습니다. b는 a의 원점에 있지 않습니다.",
                ),
            ),
            Twin(
                "yaws_not_added",
                yaws_not_added,
                Words(
                    en="`x` and `y` are right. The yaw is that of c in b: in a, b's own turn comes on top.",
                    ko="`x`와 `y`는 맞습니다. yaw는 b에서 본 c의 값입니다. a에서 보면 b가 돌아간 만큼 더해집니다.",
                ),
            ),
        ),
        hints=(
            Words(
                en="Where is c's origin in b? Move that point to a, as in E3.2.",
                ko="c의 원점은 b에서 어디입니까? 그 점을 E3.2처럼 a로 옮기십시오.",
            ),
            Words(
                en="The second step is measured along b's axes. Which of the two yaws says how far these are turned in a?",
                ko="둘째 이동은 b의 축을 따라 잰 값입니다. 그 축이 a 안에서 돌아간 각도는 두 yaw 가운데 어느 것입니까?",
            ),
            Words(
                en="Turn the second step by a_pose_b's yaw and add the first step; the yaws add up. "
                "Then compose(p, invert(p)) must be nothing at all: all zeros.",
                ko="둘째 이동을 a_pose_b의 yaw로 돌려 첫째 이동에 더하고, yaw는 서로 더합니다. "
                "그러면 compose(p, invert(p))는 모두 0이어야 합니다.",
            ),
        ),
        cures=("M1", "M3"),
    ),
    Task(
        id="E3.5",
        kind="N",
        points=3,
        title=Words(en="tf2_echo, both ways", ko="tf2_echo 양쪽으로 읽기"),
        answer="both_ways",
        form=Parts(
            {
                "laser_in_base": Vector(3, "m", "base_link", 0.005),
                "base_in_laser": Vector(3, "m", "laser_frame", 0.005),
                "yaw_back": Angle(0.005),
            }
        ),
        given=echo_given,
        variants=6,
        twins=(
            Twin(
                "swapped",
                echo_swapped,
                Words(
                    en="where it is wrong stands the answer to the other question. `tf2_echo base_link laser_frame` "
                    "prints where the second sits in the first, whatever the tool's help calls them.",
                    ko="틀린 값은 서로의 자리에 놓여 있습니다. `tf2_echo base_link laser_frame`은 둘째가 첫째 안 어디에 있는지 "
                    "출력합니다. 도움말이 무엇이라 부르든 그렇습니다.",
                ),
                "M1",
            ),
            Twin(
                "sign_only",
                echo_sign_only,
                Words(
                    en="for the way back you flipped the signs. The mount is turned, so the step has to be turned, "
                    "too. Stand where the laser is and look for the robot's middle.",
                    ko="돌아가는 쪽은 부호만 뒤집었습니다. 센서가 돌아가 있으므로 이동도 돌려야 합니다. 레이저 자리에 서서 "
                    "로봇 중심이 어느 쪽인지 찾아보십시오.",
                ),
                "M3",
            ),
            Twin(
                "turned_on",
                echo_turned_on,
                Words(
                    en="for the way back the step was turned, but by yaw instead of by minus yaw.",
                    ko="돌아가는 쪽의 이동을 돌렸지만, −yaw가 아니라 yaw로 돌렸습니다.",
                ),
            ),
            Twin(
                "not_taken_off",
                echo_not_taken_off,
                Words(
                    en="for the way back you turned the step rightly and kept its sign. From the laser, the robot's "
                    "middle lies on the other side.",
                    ko="돌아가는 쪽의 이동을 바르게 돌렸지만 부호가 그대로입니다. 레이저에서 보면 로봇 중심은 반대쪽에 있습니다.",
                ),
            ),
            Twin(
                "height_kept",
                echo_height_kept,
                Words(
                    en="all but one number is right: from the laser, is the robot's middle above or below?",
                    ko="숫자 하나만 빼고 모두 맞습니다. 레이저에서 보면 로봇 중심은 위에 있습니까, 아래에 있습니까?",
                ),
            ),
            Twin(
                "yaw_in_degrees",
                echo_yaw_in_degrees,
                Words(
                    en="both places are right, and the yaw is in degrees. It is asked for in radians: the tool prints "
                    "both, one line above the other.",
                    ko="두 위치는 맞고, yaw가 도(degree)로 되어 있습니다. 라디안으로 답해야 합니다. 도구는 두 단위를 위아래 "
                    "두 줄로 출력합니다.",
                ),
                "M5",
            ),
            Twin(
                "same_yaw",
                echo_same_yaw,
                Words(
                    en="both places are right. Going back, one also turns back: look at the sign of the yaw.",
                    ko="두 위치는 맞습니다. 돌아갈 때는 회전도 반대입니다. yaw의 부호를 보십시오.",
                ),
            ),
        ),
        hints=(
            Words(
                en="One of the two places stands in the output as it is.",
                ko="두 위치 가운데 하나는 출력에 그대로 적혀 있습니다.",
            ),
            Words(
                en="The output is base_T_laser. The other one is its inverse: E3.3, with z.",
                ko="출력은 base_T_laser입니다. 다른 하나는 그 역변환입니다. E3.3에 z가 더해진 것입니다.",
            ),
            Words(
                en="`Transform.from_rpy(yaw=..., translation=(...)).inverse()` does the arithmetic; z only changes sign.",
                ko="`Transform.from_rpy(yaw=..., translation=(...)).inverse()`로 계산할 수 있습니다. z는 부호만 바뀝니다.",
            ),
        ),
        cures=("M1", "M3"),
    ),
    Task(
        id="E3.6",
        kind="C",
        points=4,
        title=Words(en="Bolt the camera on", ko="카메라 달기"),
        answer="camera_mount",
        form=Message(
            "geometry_msgs/msg/TransformStamped",
            ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation"),
        ),
        inputs=mount_inputs,
        variants=3,
        twins=(
            Twin(
                "parent_and_child_swapped",
                parent_and_child_swapped,
                Words(
                    en="parent and child are swapped: this says that the robot is bolted onto the camera. The parent "
                    "is `header.frame_id`, and the numbers are measured in it.",
                    ko="부모와 자식이 바뀌었습니다. 로봇을 카메라에 달았다는 뜻이 됩니다. 부모는 `header.frame_id`이고, "
                    "숫자는 부모에서 잽니다.",
                ),
                "M2",
            ),
            Twin(
                "degrees",
                in_degrees,
                Words(
                    en="your angle went into sin and cos in degrees. Python and ROS count in radians (REP-103): "
                    "`math.radians`.",
                    ko="각도를 도(degree) 그대로 sin과 cos에 넣었습니다. 파이썬과 ROS는 라디안을 씁니다(REP-103). "
                    "`math.radians`를 쓰십시오.",
                ),
                "M5",
            ),
            Twin(
                "whole_angle",
                without_the_half,
                Words(
                    en="the camera is turned twice as far as asked: a quaternion holds the sine and cosine of half "
                    "the angle.",
                    ko="카메라가 두 배로 돌아갔습니다. 쿼터니언에는 각도의 절반에 대한 sin과 cos을 넣습니다.",
                ),
                "M5",
            ),
            Twin(
                "w_first",
                w_first,
                Words(
                    en="your quaternion has w first. ROS writes (x, y, z, w), so this camera lies on its side.",
                    ko="쿼터니언에 w를 먼저 썼습니다. ROS는 (x, y, z, w) 순서이므로 이 카메라는 옆으로 누워 버립니다.",
                ),
                "M5",
            ),
            Twin(
                "to_the_right",
                to_the_right,
                Words(
                    en="your camera turns to the right. A turn to the left is positive: check the sign of the angle.",
                    ko="카메라가 오른쪽으로 돌아갑니다. 왼쪽으로 도는 회전이 양수입니다. 각도의 부호를 확인하십시오.",
                ),
            ),
            Twin(
                "rolled",
                rolled,
                Words(
                    en="the camera is rolled onto its side: the sine stands in x. Which axis does a turn to the left "
                    "go about?",
                    ko="카메라가 옆으로 기울었습니다. sin이 x 자리에 있습니다. 왼쪽으로 도는 회전의 축은 무엇입니까?",
                ),
            ),
            Twin(
                "angle_in_z",
                angle_in_z,
                Words(
                    en="you wrote the angle itself into z. A quaternion holds no angle: z takes the sine of half of it, "
                    "w the cosine.",
                    ko="z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 "
                    "cos을 넣으십시오.",
                ),
                "M5",
            ),
            Twin(
                "w_still_one",
                w_still_one,
                Words(
                    en="z is right, and w is still the 1 of a new message: it takes the cosine of half the angle.",
                    ko="z는 맞지만 w가 새 메시지의 값 1 그대로입니다. w에는 각도 절반의 cos을 넣으십시오.",
                ),
                "M5",
            ),
            Twin(
                "ahead_and_up_swapped",
                ahead_and_up_swapped,
                Words(
                    en="the two steps have changed places. Which axis of the body points ahead, and which one up?",
                    ko="두 이동의 자리가 바뀌었습니다. 본체의 어느 축이 앞을, 어느 축이 위를 향합니까?",
                ),
            ),
            Twin(
                "not_turned",
                not_turned,
                Words(
                    en="the camera is in its place, but it looks straight ahead: the rotation is still the one that a "
                    "new message has.",
                    ko="카메라가 제자리에 있지만 똑바로 앞을 봅니다. 회전이 새 메시지의 값 그대로입니다.",
                ),
            ),
            Twin(
                "zero_quaternion",
                zero_quaternion,
                Words(
                    en="the rotation is all zeros. That is no rotation at all: every listener refuses the message, and "
                    "camera_link never appears.",
                    ko="회전이 모두 0입니다. 이것은 회전이 아니므로 모든 수신기가 메시지를 거절하고, camera_link는 끝내 "
                    "나타나지 않습니다.",
                ),
                "M5",
            ),
        ),
        hints=(
            Words(
                en="Which frame holds the numbers? That one is the parent, `header.frame_id`.",
                ko="숫자를 잰 좌표계는 어느 쪽입니까? 그쪽이 부모, `header.frame_id`입니다.",
            ),
            Words(
                en="A turn to the left by an angle is z = sin(half of it), w = cos(half of it), and x = y = 0.",
                ko="왼쪽으로 어떤 각도만큼 돌면 z = sin(그 절반), w = cos(그 절반), x = y = 0입니다.",
            ),
            Words(
                en="ahead is x, up is z. Message fields want floats, so write `float(...)` around what may be an int.",
                ko="앞은 x, 위는 z입니다. 메시지 필드는 float를 받으므로 int일 수 있는 값은 `float(...)`로 감싸십시오.",
            ),
        ),
        cures=("M2", "M5"),
    ),
    Task(
        id="E3.7",
        kind="D",
        points=3,
        title=Words(en="Three nodes, one swap", ko="노드 셋, 하나는 거꾸로"),
        answer="verdict",
        form=Parts({"node": Choice(NODES), "robot": Choice(ROBOTS), "hidden_while": Choice(HIDDEN)}),
        twins=(
            Twin(
                "by_its_looks",
                blamed("node_c", ROBOTS[2]),
                Words(
                    en="node_c has the same line as node_b, and it is not the line that is wrong. The robot's own "
                    "origin is written in `base_link`; node_c wants it in `map`. What does node_b hold, and want?",
                    ko="node_c는 node_b와 같은 줄을 썼고, 줄 자체가 틀린 것은 아닙니다. 로봇의 원점은 `base_link` "
                    "기준이고 node_c는 그것을 `map` 기준으로 보고 싶어 합니다. node_b는 무엇을 가졌고, 무엇을 원합니까?",
                ),
                "M2",
            ),
            Twin(
                "against_the_arrow",
                blamed("node_a", ROBOTS[0]),
                Words(
                    en="node_a is right: written in the point's frame, wanted in `base_link`. Parent → child is the "
                    "family; data runs the other way.",
                    ko="node_a는 맞습니다. 점은 자기 헤더의 좌표계 기준이고, 그것을 `base_link` 기준으로 보고 싶습니다. 부모 → 자식은 가족 "
                    "관계이고, 데이터는 그 반대로 흐릅니다.",
                ),
                "M2",
            ),
            Twin(
                "expects_an_exception",
                blamed("node_b", ROBOTS[3]),
                Words(
                    en="the node is right. But a swapped lookup raises nothing: both questions have an answer. What "
                    "does a robot do that believes this one?",
                    ko="노드는 맞습니다. 그러나 바꿔 쓴 조회는 예외를 내지 않습니다. 두 질문 모두 답이 있기 때문입니다. 그 "
                    "답을 믿은 로봇은 무엇을 합니까?",
                ),
                "M1",
            ),
            Twin(
                "still_is_enough",
                blamed("node_b", ROBOTS[1], HIDDEN[0]),
                Words(
                    en="node and robot are right. Standing still does not help: a wrong transform is wrong at rest, "
                    "too. For which transform is the inverse the same?",
                    ko="노드와 로봇은 맞습니다. 서 있다고 해서 맞지는 않습니다. 틀린 변환은 서 있을 때도 틀립니다. 역변환이 "
                    "자기 자신과 같은 변환은 어떤 것입니까?",
                ),
                "M3",
            ),
            Twin(
                "far_away",
                blamed("node_b", ROBOTS[1], HIDDEN[2]),
                Words(
                    en="node and robot are right. A far goal does not help: the farther away it is, the farther off a "
                    "wrong turn throws it. For which transform is the inverse the same?",
                    ko="노드와 로봇은 맞습니다. 목표가 멀어도 드러납니다. 멀수록 틀린 회전 때문에 더 크게 어긋납니다. 역변환이 "
                    "자기 자신과 같은 변환은 어떤 것입니까?",
                ),
                "M3",
            ),
            Twin(
                "node_a_at_rest",
                blamed("node_a", ROBOTS[0], HIDDEN[0]),
                Words(
                    en="node_a asks rightly: its point is written in the point's own frame, and wanted in `base_link`. "
                    "And a wrong transform would be wrong at rest, too. Say the sentences of the other two nodes.",
                    ko="node_a는 바르게 물었습니다. 점은 자기 헤더의 좌표계 기준이고, 그것을 `base_link` 기준으로 보고 싶습니다. 그리고 틀린 변환은 "
                    "서 있을 때도 틀립니다. 나머지 두 노드를 문장으로 말해 보십시오.",
                ),
                "M2",
            ),
            Twin(
                "node_c_at_rest",
                blamed("node_c", ROBOTS[2], HIDDEN[0]),
                Words(
                    en="node_c asks rightly: the robot's origin is written in `base_link`, and wanted in `map`. And a wrong "
                    "transform would be wrong at rest, too. Which node has a goal of the map, and wants it in `base_link`?",
                    ko="node_c는 바르게 물었습니다. 로봇의 원점은 `base_link` 기준이고, 그것을 `map` 기준으로 보고 싶습니다. 그리고 틀린 변환은 "
                    "서 있을 때도 틀립니다. 지도 기준 목표점을 `base_link` 기준으로 보고 싶은 노드는 어느 것입니까?",
                ),
                "M2",
            ),
        ),
        hints=(
            Words(
                en="Each comment says in which frame the data is written. Say the three sentences.",
                ko="주석마다 데이터가 어느 좌표계 기준인지 적혀 있습니다. 문장 세 개로 말해 보십시오.",
            ),
            Words(
                en="The frame that the data is written in must be the second argument.",
                ko="데이터의 기준 좌표계가 둘째 인자여야 합니다.",
            ),
            Words(
                en="Nothing stops: TF2 answers the opposite question. The numbers that come out belong somewhere else.",
                ko="아무것도 멈추지 않습니다. TF2는 반대 질문에 답할 뿐이고, 나온 숫자는 다른 곳을 가리킵니다.",
            ),
        ),
        cures=("M1", "M2"),
    ),
)
