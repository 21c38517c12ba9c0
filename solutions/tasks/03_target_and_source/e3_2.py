"""E3.2: A corner seen by a turned laser."""

from __future__ import annotations

import math
from functools import partial

from tflab.core import Transform
from tflab.workbook.tasks import Draws, Parts, Task, Text, Vector, WrongAnswer, WrongStep

from .draws import BY_HAND, by_formula, some_mount, some_yaw_degrees, tells_ways_apart, turned


def added(*points) -> tuple[float, ...]:
    """Return the sum of points, one number after the other."""
    return tuple(map(sum, zip(*points, strict=True)))


def corner_given(rng: Draws) -> dict[str, object]:
    """Draw until both points show how they were rotated."""
    while True:
        given = _corner(rng)
        mount, robot, point = given["base_T_laser"], given["map_T_base"], given["laser_p_corner"]
        if _shows_its_turn(mount, point) and _shows_its_turn(robot, mount.apply(point)):
            return given


def _shows_its_turn(transform: Transform, point) -> bool:
    """Return whether half the rotation, twice the rotation and each wrong formula move the point elsewhere."""
    (x, y, _), yaw = point, transform.rpy()[2]
    half = abs(yaw) / 2.0
    is_half_told = math.hypot(x, y) * (half - math.sin(half)) > 0.008
    return is_half_told and abs(math.sin(3 * half)) > 0.02 and tells_ways_apart(x, y, yaw)


def _corner(rng: Draws) -> dict[str, object]:
    x, y = rng.integers(200, 600, size=2) / 100
    map_T_base = Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(x, y, 0.1))
    point = (rng.integers(150, 400) / 100, rng.choice([-1, 1]) * rng.integers(30, 120) / 100, 0.0)
    return {"map_T_base": map_T_base, "base_T_laser": some_mount(rng), "laser_p_corner": tuple(map(float, point))}


def taken(transform: Transform, point, way: str) -> tuple[float, ...]:
    """Return a point taken from the child to the parent, or what people do instead."""
    if way in BY_HAND:
        return added((*by_formula(*point[:2], transform.rpy()[2], way), point[2]), transform.translation)
    back = tuple(-number for number in transform.translation)
    return {
        "apply": transform.apply(point),
        "inverse": transform.inverse().apply(point),
        "no turn": added(point, transform.translation),
        "step first": turned(transform, added(point, transform.translation)),
        "turn only": turned(transform, point),
        "turn back": added(turned(transform.inverse(), point), transform.translation),
        "step back": added(turned(transform, point), back),
        "origin": transform.translation,
        "no turn, step back": added(point, back),
        "w first": Transform(transform.translation, transform.rotation[3:] + transform.rotation[:3]).apply(point),
        "z for the yaw": Transform.from_rpy(yaw=transform.rotation[2], translation=transform.translation).apply(point),
        "turn back, no step": turned(transform.inverse(), point),
        "twice": transform.apply(transform.apply(point)),
        "half the turn": added(turned(_half(transform), point), transform.translation),
        "turned twice": added(turned(transform, turned(transform, point)), transform.translation),
        "by degrees": _by_yaw(transform, math.degrees(transform.rpy()[2]), point),
        "converted": _by_yaw(transform, math.radians(transform.rpy()[2]), point),
    }[way]


def _by_yaw(transform: Transform, yaw: float, point) -> tuple[float, ...]:
    return Transform.from_rpy(yaw=yaw, translation=transform.translation).apply(point)


def _half(transform: Transform) -> Transform:
    return Transform.from_rpy(yaw=transform.rpy()[2] / 2)


def moved_twice(
    given, *, first="apply", height="kept", then="apply", product="in order", between="as computed"
) -> dict[str, tuple]:
    """Return the corner in both frames, step by step; other steps are the slips."""
    point = given.laser_p_corner
    base_p = taken(given.base_T_laser, point, first)
    if product == "reversed":
        return {"base_link": base_p, "map": (given.base_T_laser @ given.map_T_base).apply(point)}
    if product == "inverted":
        return {"base_link": base_p, "map": (given.map_T_base @ given.base_T_laser).inverse().apply(point)}
    if product == "laser twice":
        return {"base_link": base_p, "map": (given.map_T_base @ given.base_T_laser).apply(base_p)}
    if product == "laser itself":
        return {"base_link": base_p, "map": given.map_T_base.apply(given.base_T_laser.translation)}
    if product in BY_COPYING:
        return {"base_link": base_p, "map": _copied(given, base_p, product)}
    base_p = (*base_p[:2], {"left out": 0.0, "twice": 2 * base_p[2]}.get(height, base_p[2]))
    carried = {"as computed": base_p, "to tenths": tuple(round(number, 1) for number in base_p)}[between]
    return {"base_link": base_p, "map": taken(given.map_T_base, point if product == "skipped" else carried, then)}


BY_COPYING = (
    "mount's turn", "mount's step", "mount again", "mount's step not turned", "mount's turn left out",
    "mount's turn once more", "robot's step once more", "both inverses",
)  # fmt: skip


def _copied(given, base_p, what: str) -> tuple[float, ...]:
    """Return the corner on the map where something of the laser's mount went in as it should not."""
    mount, robot, point = given.base_T_laser, given.map_T_base, given.laser_p_corner
    return {
        "mount's turn": added(turned(mount, base_p), robot.translation),
        "mount's step": added(turned(robot, base_p), mount.translation),
        "mount again": mount.apply(base_p),
        "mount's turn once more": added(turned(robot, turned(mount, base_p)), robot.translation),
        "robot's step once more": added(robot.apply(base_p), robot.translation),
        "both inverses": (robot.inverse() @ mount.inverse()).apply(point),
        "mount's step not turned": added(turned(robot, turned(mount, point)), mount.translation, robot.translation),
        "mount's turn left out": added(turned(robot, point), mount.translation, robot.translation),
    }[what]


def on_the_way(way: str, words: Text, misconception: str = "") -> tuple[WrongAnswer, ...]:
    """Return what was done on the way to `base_link`, on that to `map`, and by one function on both."""
    first, then, both = (
        Text(en=f"{en} {words.en}", ko=f"{ko} {words.ko}")
        for en, ko in (
            ("on the way to `base_link`,", "`base_link`로 갈 때의 계산입니다."),
            ("on the way to `map`,", "`map`으로 갈 때의 계산입니다."),
            ("on both ways,", "두 번의 계산에서 모두 그렇습니다."),
        )
    )
    return (
        WrongAnswer(f"first {way}", partial(moved_twice, first=way), first, misconception, part="base_link"),
        WrongAnswer(f"then {way}", partial(moved_twice, then=way), then, misconception, part="map"),
        WrongAnswer(f"both {way}", partial(moved_twice, first=way, then=way), both, misconception),
    )


SWAPPED = WrongStep(
    "swapped",
    {"first": "inverse", "product": "inverted"},
    Text(
        en="target and source are swapped: you used an inverse. `base_T_laser` already takes laser data to "
        "the base, and a row of dominoes that match needs no inverse either; check it with the laser's own "
        "origin, (0, 0, 0).",
        ko="목표와 원본이 바뀌었습니다. 역변환을 썼습니다. `base_T_laser`가 이미 레이저 데이터를 베이스로 옮기고, "
        "이웃이 맞는 도미노에도 역변환은 필요 없습니다. 레이저의 원점 (0, 0, 0)을 넣어 확인해 보십시오.",
    ),
    "M1",
)


TURN_IGNORED = WrongStep(
    "turn_ignored",
    {"first": "no turn", "then": "no turn"},
    Text(
        en="you added the steps and left out the turns. That is right only for a sensor that looks "
        "straight ahead on a robot that does, too.",
        ko="이동만 더하고 회전을 빠뜨렸습니다. 센서도 로봇도 정면을 볼 때만 맞습니다.",
    ),
    "M3",
)


STEP_BEFORE_TURN = WrongStep(
    "step_before_turn",
    {"first": "step first", "then": "step first"},
    Text(
        en="you added the step first and turned the sum. The step is measured in the parent, so it is not "
        "turned: turn the point, then add the step.",
        ko="이동을 먼저 더하고 그 합을 돌렸습니다. 이동은 부모에서 잰 값이므로 돌리지 않습니다. 점을 돌린 "
        "다음에 이동을 더하십시오.",
    ),
)


PRODUCT_REVERSED = WrongStep(
    "product_reversed",
    {"product": "reversed"},
    Text(
        en="for `map`, the two transforms act in the other order, as in `base_T_laser @ map_T_base`: which halves of the "
        "dominoes touch there?",
        ko="`map`을 구할 때 두 변환의 순서가 `base_T_laser @ map_T_base`처럼 반대입니다. 그 도미노에서 맞닿은 두 칸은 "
        "무엇과 무엇입니까?",
    ),
    part="map",
)


AN_EDGE_SKIPPED = WrongStep(
    "an_edge_skipped",
    {"product": "skipped"},
    Text(
        en="for `map` you applied `map_T_base` to a point that is written in the laser: one domino is missing.",
        ko="`map`을 구할 때는 레이저 기준 점에 `map_T_base`를 적용했습니다. 도미노 하나가 빠졌습니다.",
    ),
    part="map",
)


INVERSE_CARRIED_ON = WrongStep(
    "inverse_carried_on",
    {"first": "inverse"},
    Text(
        en="on the way to `base_link` you took the inverse of "
        "`base_T_laser`. Which frame's points does it take in, as it stands?",
        ko="`base_link`로 갈 때 `base_T_laser`의 역변환을 썼습니다. "
        "`base_T_laser`는 그대로 둘 때 어느 좌표계 기준인 점을 받습니까?",
    ),
    "M1",
    part="base_link",
)


OUT_OF_THE_MAP = WrongStep(
    "out_of_the_map",
    {"then": "inverse"},
    Text(
        en="for `map` you used the inverse of `map_T_base`, which takes points out of "
        "the map; you want the corner in it.",
        ko="`map`을 구할 때는 `map_T_base`의 역변환을 썼는데, 그것은 map 기준인 점을 로봇 기준으로 "
        "옮깁니다. 원하는 것은 map 기준인 모서리입니다.",
    ),
    "M1",
    part="map",
)


BOTH_INVERTED = WrongStep(
    "both_inverted",
    {"first": "inverse", "then": "inverse"},
    Text(
        en="you inverted both transforms, one after the other. As they stand, `base_T_laser` takes laser "
        "data to the base and `map_T_base` takes it on to the map: read each name from right to left.",
        ko="두 변환을 모두 뒤집어 차례로 적용했습니다. 그대로 두면 `base_T_laser`는 레이저 데이터를 베이스로, "
        "`map_T_base`는 그것을 지도로 옮깁니다. 이름을 오른쪽에서 왼쪽으로 읽어 보십시오.",
    ),
    "M1",
)


PRODUCT_INVERTED = WrongStep(
    "product inverted",
    {"product": "inverted"},
    Text(
        en="for `map` you inverted the product: turned round, it takes points of the map to the laser. As it stands it "
        "takes those of the laser to the map.",
        ko="`map`을 구할 때 곱을 뒤집었습니다. 뒤집은 곱은 map 기준 점을 레이저 기준으로 옮깁니다. 그대로 두어야 레이저 기준 "
        "점을 map 기준으로 옮깁니다.",
    ),
    "M1",
    part="map",
)


THE_LASER_ITSELF = WrongStep(
    "the_laser_itself",
    {"first": "origin"},
    Text(
        en="that is where the laser sits; the corner has not come into it yet. Give `laser_p_corner` to `.apply(...)`.",
        ko="그것은 레이저가 달린 자리입니다. 모서리가 아직 들어가지 않았습니다. `.apply(...)`에 `laser_p_corner`를 "
        "넣으십시오.",
    ),
    partly=True,
)


FIRST_NO_TURN = WrongStep(
    "first no turn",
    {"first": "no turn"},
    Text(
        en="on the way to `base_link`, you added the step and left out the turn.",
        ko="`base_link`로 갈 때 이동만 더하고 회전을 빠뜨렸습니다.",
    ),
    "M3",
    part="base_link",
)

FIRST_STEP_FIRST = WrongStep(
    "first step first",
    {"first": "step first"},
    Text(
        en="on the way to `base_link`, you added the step before the turn: turn the point, then add the step.",
        ko="`base_link`로 갈 때 돌리기 전에 이동을 더했습니다. 점을 돌린 다음에 이동을 더하십시오.",
    ),
    "",
    part="base_link",
)

FIRST_TURN_ONLY = WrongStep(
    "first turn only",
    {"first": "turn only"},
    Text(
        en="on the way to `base_link`, you turned the point and left out the step.",
        ko="`base_link`로 갈 때 점을 돌리기만 하고 이동을 빠뜨렸습니다.",
    ),
    "",
    part="base_link",
)

FIRST_TURN_BACK = WrongStep(
    "first turn back",
    {"first": "turn back"},
    Text(
        en="on the way to `base_link`, you turned the point the wrong way round: the turn is taken as it stands.",
        ko="`base_link`로 갈 때 점을 반대로 돌렸습니다. 회전은 그대로 씁니다.",
    ),
    "M1",
    part="base_link",
)

FIRST_STEP_BACK = WrongStep(
    "first step back",
    {"first": "step back"},
    Text(
        en="on the way to `base_link`, you subtracted the step, and it has to be added.",
        ko="`base_link`로 갈 때 이동을 뺐습니다. 더해야 합니다.",
    ),
    "M3",
    part="base_link",
)

THEN_NO_TURN = WrongStep(
    "then no turn",
    {"then": "no turn"},
    Text(
        en="on the way to `map`, you added the step and left out the turn.",
        ko="`map`으로 갈 때 이동만 더하고 회전을 빠뜨렸습니다.",
    ),
    "M3",
    part="map",
)

THEN_STEP_FIRST = WrongStep(
    "then step first",
    {"then": "step first"},
    Text(
        en="on the way to `map`, you added the step before the turn: turn the point, then add the step.",
        ko="`map`으로 갈 때 돌리기 전에 이동을 더했습니다. 점을 돌린 다음에 이동을 더하십시오.",
    ),
    "",
    part="map",
)

THEN_TURN_ONLY = WrongStep(
    "then turn only",
    {"then": "turn only"},
    Text(
        en="on the way to `map`, you turned the point and left out the step.",
        ko="`map`으로 갈 때 점을 돌리기만 하고 이동을 빠뜨렸습니다.",
    ),
    "",
    part="map",
)

THEN_TURN_BACK = WrongStep(
    "then turn back",
    {"then": "turn back"},
    Text(
        en="on the way to `map`, you turned the point the wrong way round: the turn is taken as it stands.",
        ko="`map`으로 갈 때 점을 반대로 돌렸습니다. 회전은 그대로 씁니다.",
    ),
    "M1",
    part="map",
)

THEN_STEP_BACK = WrongStep(
    "then step back",
    {"then": "step back"},
    Text(
        en="on the way to `map`, you subtracted the step, and it has to be added.",
        ko="`map`으로 갈 때 이동을 뺐습니다. 더해야 합니다.",
    ),
    "M3",
    part="map",
)


LASER_TWICE = WrongStep(
    "laser twice",
    {"product": "laser twice"},
    Text(
        en="for `map` the laser's mount is used twice: a point in `base_link` needs only `map_T_base` to get there.",
        ko="`map`을 구할 때 레이저 장착 변환을 두 번 썼습니다. `base_link` 기준의 점에는 `map_T_base`만 있으면 됩니다.",
    ),
    part="map",
)


FIRST_NO_TURN_STEP_BACK = WrongStep(
    "first no turn, step back",
    {"first": "no turn, step back"},
    Text(
        en="on the way to `base_link`, you took the step away and left out the turn: going from child to parent, the point is turned and the step is added.",
        ko="`base_link`로 가는 길에서 이동을 빼고 회전도 빠뜨렸습니다. 자식에서 부모로 갈 때는 점을 돌리고 이동을 더합니다.",
    ),
    "M3",
    part="base_link",
)


THEN_NO_TURN_STEP_BACK = WrongStep(
    "then no turn, step back",
    {"then": "no turn, step back"},
    Text(
        en="on the way to `map`, you took the step away and left out the turn: going from child to parent, the point is turned and the step is added.",
        ko="`map`으로 가는 길에서 이동을 빼고 회전도 빠뜨렸습니다. 자식에서 부모로 갈 때는 점을 돌리고 이동을 더합니다.",
    ),
    "M3",
    part="map",
)


FIRST_W_FIRST = WrongStep(
    "first w first",
    {"first": "w first"},
    Text(
        en="on the way to `base_link`, the rotation went in with w in front: `.rotation` is (x, y, z, w), and Transform takes it like that.",
        ko="`base_link`로 가는 길에서 회전의 w를 앞에 두고 넣었습니다. `.rotation`은 (x, y, z, w)이고 Transform도 그 순서로 받습니다.",
    ),
    "M5",
    part="base_link",
)


THEN_W_FIRST = WrongStep(
    "then w first",
    {"then": "w first"},
    Text(
        en="on the way to `map`, the rotation went in with w in front: `.rotation` is (x, y, z, w), and Transform takes it like that.",
        ko="`map`으로 가는 길에서 회전의 w를 앞에 두고 넣었습니다. `.rotation`은 (x, y, z, w)이고 Transform도 그 순서로 받습니다.",
    ),
    "M5",
    part="map",
)


FIRST_Z_FOR_THE_YAW = WrongStep(
    "first z for the yaw",
    {"first": "z for the yaw"},
    Text(
        en="on the way to `base_link`, you took the quaternion's z for the yaw. It is the sine of half the yaw; `.rpy()` or `.apply` know the angle.",
        ko="`base_link`로 가는 길에서 쿼터니언의 z를 yaw로 썼습니다. z는 yaw 절반의 sin입니다. 각도는 `.rpy()`나 `.apply`에 맡기십시오.",
    ),
    "M5",
    part="base_link",
)


THEN_Z_FOR_THE_YAW = WrongStep(
    "then z for the yaw",
    {"then": "z for the yaw"},
    Text(
        en="on the way to `map`, you took the quaternion's z for the yaw. It is the sine of half the yaw; `.rpy()` or `.apply` know the angle.",
        ko="`map`으로 가는 길에서 쿼터니언의 z를 yaw로 썼습니다. z는 yaw 절반의 sin입니다. 각도는 `.rpy()`나 `.apply`에 맡기십시오.",
    ),
    "M5",
    part="map",
)


FIRST_TURN_BACK_NO_STEP = WrongStep(
    "first turn back, no step",
    {"first": "turn back, no step"},
    Text(
        en="on the way to `base_link`, you turned the point back, and left out the step. As it stands, the transform turns and then adds.",
        ko="`base_link`로 가는 길에서 점을 거꾸로 돌리고 이동을 빠뜨렸습니다. 변환은 그대로 쓰면 돌린 다음 더합니다.",
    ),
    "M1",
    part="base_link",
)


THEN_TURN_BACK_NO_STEP = WrongStep(
    "then turn back, no step",
    {"then": "turn back, no step"},
    Text(
        en="on the way to `map`, you turned the point back, and left out the step. As it stands, the transform turns and then adds.",
        ko="`map`으로 가는 길에서 점을 거꾸로 돌리고 이동을 빠뜨렸습니다. 변환은 그대로 쓰면 돌린 다음 더합니다.",
    ),
    "M1",
    part="map",
)


THE_ROBOT_ITSELF = WrongStep(
    "the robot itself",
    {"then": "origin"},
    Text(
        en="for `map`, that is where the robot stands; the corner has not come into it.",
        ko="`map`에 로봇이 서 있는 곳을 썼습니다. 모서리가 들어가지 않았습니다.",
    ),
    part="map",
)

FIRST_TWICE = WrongStep(
    "mount twice, base",
    {"first": "twice"},
    Text(
        en="base_link: the mount is applied twice. Once, and the point is in base_link.",
        ko="base_link: 장착 변환을 두 번 적용했습니다. 한 번이면 점은 base_link 기준이 됩니다.",
    ),
    part="base_link",
)

THEN_TWICE = WrongStep(
    "robot twice, map",
    {"then": "twice"},
    Text(
        en="map: where the robot stands is applied twice. Once, and the point is in map.",
        ko="map: 로봇의 위치를 두 번 적용했습니다. 한 번이면 점은 map 기준이 됩니다.",
    ),
    part="map",
)

FIRST_HALF = WrongStep(
    "half the mount's turn",
    {"first": "half the turn"},
    Text(
        en="base_link: the point is turned by half of the angle. A quaternion holds the sine and cosine of half of it, and still turns by all of it.",
        ko="base_link: 점을 각도의 절반만 돌렸습니다. 쿼터니언에는 각도 절반의 sin과 cos이 들어 있지만 돌리는 것은 각도 전체입니다.",
    ),
    "M5",
    part="base_link",
)

FIRST_TURNED_TWICE = WrongStep(
    "mount turned twice",
    {"first": "turned twice"},
    Text(
        en="base_link: the point is turned twice, and moved once.",
        ko="base_link: 점을 두 번 돌리고 한 번 옮겼습니다.",
    ),
    part="base_link",
)


ROUNDED_BETWEEN = WrongStep(
    "rounded between",
    {"between": "to tenths"},
    Text(
        en="on the way to `map`, you went on with a rounded `base_link`. Carry a number on as it was computed, and round only what you print.",
        ko="`map`을 구할 때 반올림한 `base_link` 값으로 이어서 계산했습니다. 계산한 값을 그대로 이어 쓰고, 반올림은 출력할 때만 하십시오.",
    ),
    part="map",
)


HEIGHT_LEFT_OUT = WrongStep(
    "height left out",
    {"height": "left out"},
    Text(
        en="on the way to `base_link`, the height was left out: the laser does not sit on the floor, and z counts as well.",
        ko="`base_link`로 옮길 때 높이를 빠뜨렸습니다. 레이저는 바닥에 있지 않으므로 z도 더합니다.",
    ),
    part="base_link",
)


THE_LASER_ON_THE_MAP = WrongStep(
    "the laser on the map",
    {"product": "laser itself"},
    Text(
        en="for `map`, that is where the laser sits; the corner has not come into it yet. Give the product a point: `.apply(laser_p_corner)`.",
        ko="`map`에 쓴 것은 레이저의 위치입니다. 모서리는 아직 들어가지 않았습니다. 곱한 것에 점을 넣으십시오: `.apply(laser_p_corner)`.",
    ),
    part="map",
)


HEIGHT_TWICE = WrongStep(
    "height twice",
    {"height": "twice"},
    Text(
        en="in `base_link`, the height of the mount is in z twice: once is how high the laser sits.",
        ko="`base_link`의 z에 장착 높이를 두 번 더했습니다. 레이저의 높이는 한 번만 더합니다.",
    ),
    part="base_link",
)


def rounded_twice(given) -> dict[str, tuple]:
    """Return both places rounded to tenths, the second computed from the rounded first."""
    rough = moved_twice(given, between="to tenths")
    return {name: tuple(round(number, 1) for number in row) for name, row in rough.items()}


def without_the_robots_height(given) -> dict[str, tuple]:
    """Return both places, the one on the map with the other's z."""
    corner = moved_twice(given)
    return corner | {"map": (*corner["map"][:2], corner["base_link"][2])}


ROUNDED_TWICE = WrongAnswer(
    "rounded twice",
    rounded_twice,
    Text(
        en="both places are rounded to tenths, and `map` was computed from a rounded `base_link`. Carry numbers on as "
        "they were computed.",
        ko="두 위치를 모두 소수 첫째 자리로 반올림했고, `map`은 반올림한 `base_link`에서 구했습니다. 계산한 값을 그대로 "
        "이어 쓰십시오.",
    ),
)


HEIGHT_OF_THE_ROBOT = WrongAnswer(
    "height of the robot left out",
    without_the_robots_height,
    Text(
        en="for `map`, z is still that of `base_link`: base_link does not lie on the map's floor, so its own height is "
        "added, too.",
        ko="`map`의 z가 `base_link`의 값 그대로입니다. base_link는 map의 바닥에 있지 않으므로 그 높이도 더합니다.",
    ),
    part="map",
)


OF_THE_MOUNT = {
    "mount's turn": Text(
        en="for `map`, the point was turned by the laser's mount once more: from `base_link` to `map` it is the robot's "
        "rotation that turns it.",
        ko="`map`을 구할 때 점을 레이저 장착 회전으로 다시 돌렸습니다. `base_link`에서 `map`으로 갈 때는 로봇의 회전으로 "
        "돌립니다.",
    ),
    "mount's step": Text(
        en="for `map`, you added the step of the laser's mount again, and not that of `map_T_base`.",
        ko="`map`을 구할 때 `map_T_base`의 이동이 아니라 레이저 장착 이동을 다시 더했습니다.",
    ),
    "mount again": Text(
        en="for `map`, `base_T_laser` was applied once more, and `map_T_base` has not come in.",
        ko="`map`을 구할 때 `base_T_laser`를 한 번 더 적용했고 `map_T_base`는 들어가지 않았습니다.",
    ),
    "mount's step not turned": Text(
        en="for `map`, the step of the laser's mount was added as it is. It is measured along the robot's axes, and the "
        "robot is turned on the map.",
        ko="`map`을 구할 때 레이저 장착 이동을 그대로 더했습니다. 그 이동은 로봇의 축을 따라 잰 값이고, 로봇은 map에서 "
        "돌아가 있습니다.",
    ),
    "mount's turn once more": Text(
        en="for `map`, a point of `base_link` was turned by the laser's mount once more: it has that turn already.",
        ko="`map`을 구할 때 `base_link` 기준인 점을 레이저 장착 회전으로 한 번 더 돌렸습니다. 그 회전은 이미 들어 있습니다.",
    ),
    "robot's step once more": Text(
        en="for `map`, the step of `map_T_base` was added once more: `.apply` and `@` have added it already.",
        ko="`map`을 구할 때 `map_T_base`의 이동을 한 번 더 더했습니다. `.apply`와 `@`가 이미 더했습니다.",
    ),
    "both inverses": Text(
        en="for `map`, both transforms were inverted and joined in this order. As they stand their neighbours match: "
        "`base_T_laser` takes the point to the base, and `map_T_base` takes it on.",
        ko="`map`을 구할 때 두 변환을 뒤집어 이 순서로 이었습니다. 그대로 두면 이웃이 맞습니다. `base_T_laser`가 점을 "
        "베이스로, `map_T_base`가 그것을 지도로 옮깁니다.",
    ),
    "mount's turn left out": Text(
        en="for `map`, both steps were added as they are, and the point was turned by the robot alone: the mount turns "
        "it as well, and the robot turns the mount's step.",
        ko="`map`을 구할 때 두 이동을 그대로 더하고 점은 로봇의 회전으로만 돌렸습니다. 장착 회전도 점을 돌리고, 로봇의 "
        "회전은 장착 이동도 돌립니다.",
    ),
}
COPIED = tuple(
    WrongAnswer(what, partial(moved_twice, product=what), words, part="map") for what, words in OF_THE_MOUNT.items()
)


LETTERS = Text(en="Here (u, v) is the point, and α is the yaw.", ko="(u, v)는 점이고 α는 yaw입니다.")
HALF_THE_TURN = Text(
    en="the point is turned by half of the angle. A quaternion holds the sine and cosine of half of it, and still turns "
    "by all of it.",
    ko="점을 각도의 절반만 돌렸습니다. 쿼터니언에는 각도 절반의 sin과 cos이 들어 있지만 돌리는 것은 각도 전체입니다.",
)
ANGLES = (
    *on_the_way("half the turn", HALF_THE_TURN, "M5")[1:],
    *on_the_way(
        "by degrees",
        Text(
            en="the angle went into sine and cosine in degrees: they want radians.",
            ko="각도를 도(degree)로 바꿔 sin과 cos에 넣었습니다. sin과 cos은 라디안을 받습니다.",
        ),
        "M5",
    ),
    *on_the_way(
        "converted",
        Text(
            en="the point has hardly turned: the angle was in radians already, and went through `math.radians` once more.",
            ko="점이 거의 돌지 않았습니다. 이미 라디안인 각도를 `math.radians`에 한 번 더 넣었습니다.",
        ),
        "M5",
    ),
)


TASK = Task(
    id="E3.2",
    kind="N",
    points=4,
    title=Text(en="A corner seen by a turned laser", ko="돌려서 장착한 레이저가 본 모서리"),
    answer="corner",
    form=Parts({"base_link": Vector(3, "m", "base_link", 0.005), "map": Vector(3, "m", "map", 0.005)}),
    given=corner_given,
    variants=6,
    model=moved_twice,
    mistakes=(
        SWAPPED,
        BOTH_INVERTED,
        THE_LASER_ITSELF,
        TURN_IGNORED,
        STEP_BEFORE_TURN,
        PRODUCT_REVERSED,
        AN_EDGE_SKIPPED,
        INVERSE_CARRIED_ON,
        OUT_OF_THE_MAP,
        PRODUCT_INVERTED,
        FIRST_NO_TURN,
        FIRST_STEP_FIRST,
        FIRST_TURN_ONLY,
        FIRST_TURN_BACK,
        FIRST_STEP_BACK,
        THEN_NO_TURN,
        THEN_STEP_FIRST,
        THEN_TURN_ONLY,
        THEN_TURN_BACK,
        THEN_STEP_BACK,
        LASER_TWICE,
        FIRST_NO_TURN_STEP_BACK,
        THEN_NO_TURN_STEP_BACK,
        FIRST_W_FIRST,
        FIRST_Z_FOR_THE_YAW,
        THEN_Z_FOR_THE_YAW,
        THEN_W_FIRST,
        FIRST_TURN_BACK_NO_STEP,
        THEN_TURN_BACK_NO_STEP,
        THE_ROBOT_ITSELF,
        FIRST_TWICE,
        THEN_TWICE,
        FIRST_HALF,
        FIRST_TURNED_TWICE,
        ROUNDED_BETWEEN,
        HEIGHT_LEFT_OUT,
        THE_LASER_ON_THE_MAP,
        HEIGHT_TWICE,
        HEIGHT_OF_THE_ROBOT,
        ROUNDED_TWICE,
        *COPIED,
        *ANGLES,
        *(twin for way, words in BY_HAND.items() for twin in on_the_way(way, Text.joined(words, LETTERS))),
    ),
    hints=(
        Text(
            en="Two questions, two sentences: written in laser, wanted in base; written in laser, wanted in map.",
            ko="질문이 두 개이니 문장도 두 개입니다. 레이저 기준을 베이스 기준으로, 레이저 기준을 지도 기준으로.",
        ),
        Text(
            en="A transform `a_T_b` has `.apply(point)` for a point written in b, and `@` joins two that match.",
            ko="변환 `a_T_b`에는 b 기준 점을 받는 `.apply(점)`이 있고, 이웃이 맞는 둘은 `@`로 잇습니다.",
        ),
        Text(
            en="Lay the dominoes: [map|base][base|laser], and the point of the laser at the right end.",
            ko="도미노를 놓아 보십시오. [map|base][base|laser], 그리고 오른쪽 끝에 레이저의 점입니다.",
        ),
    ),
    misconceptions=("M1", "M3"),
)
