"""E3.2: A corner seen by a turned laser."""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.workbook.tasks import Parts, Task, Twin, Vector, Words

from .draws import some_mount, some_yaw_degrees, turned


def added(*points) -> tuple[float, ...]:
    """Return the sum of points, one number after the other."""
    return tuple(map(sum, zip(*points, strict=True)))


def corner_given(rng: np.random.Generator) -> dict[str, object]:
    x, y = rng.integers(200, 600, size=2) / 100
    map_T_base = Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(x, y, 0.1))
    point = (rng.integers(150, 400) / 100, rng.choice([-1, 1]) * rng.integers(30, 120) / 100, 0.0)
    return {"map_T_base": map_T_base, "base_T_laser": some_mount(rng), "laser_p_corner": tuple(map(float, point))}


def corner_swapped(given) -> dict[str, tuple]:
    map_T_laser = given.map_T_base @ given.base_T_laser
    point = given.laser_p_corner
    return {"base_link": given.base_T_laser.inverse().apply(point), "map": map_T_laser.inverse().apply(point)}


SWAPPED = Twin(
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
)


def corner_without_turns(given) -> dict[str, tuple]:
    base_p = added(given.laser_p_corner, given.base_T_laser.translation)
    return {"base_link": base_p, "map": added(base_p, given.map_T_base.translation)}


TURN_IGNORED = Twin(
    "turn_ignored",
    corner_without_turns,
    Words(
        en="you added the steps and left out the turns. That is right only for a sensor that looks "
        "straight ahead on a robot that does, too.",
        ko="이동만 더하고 회전을 빠뜨렸습니다. 센서도 로봇도 정면을 볼 때만 맞습니다.",
    ),
    "M3",
)


def corner_step_first(given) -> dict[str, tuple]:
    mount, robot = given.base_T_laser, given.map_T_base
    base_p = turned(mount, added(given.laser_p_corner, mount.translation))
    return {"base_link": base_p, "map": turned(robot, added(base_p, robot.translation))}


STEP_BEFORE_TURN = Twin(
    "step_before_turn",
    corner_step_first,
    Words(
        en="you added the step first and turned the sum. The step is measured in the parent, so it is not "
        "turned: turn the point, then add the step.",
        ko="이동을 먼저 더하고 그 합을 돌렸습니다. 이동은 부모에서 잰 값이므로 돌리지 않습니다. 점을 돌린 "
        "다음에 이동을 더하십시오.",
    ),
)


def corner_reversed_product(given) -> dict[str, tuple]:
    product = given.base_T_laser @ given.map_T_base
    return {"base_link": given.base_T_laser.apply(given.laser_p_corner), "map": product.apply(given.laser_p_corner)}


PRODUCT_REVERSED = Twin(
    "product_reversed",
    corner_reversed_product,
    Words(
        en="the first is right. In the product for `map`, the dominoes do not match: which halves touch in "
        "`base_T_laser @ map_T_base`?",
        ko="첫째는 맞습니다. `map`을 구한 곱에서는 도미노가 맞지 않습니다. `base_T_laser @ map_T_base`에서 "
        "맞닿은 두 칸은 무엇과 무엇입니까?",
    ),
)


def corner_skips_the_laser(given) -> dict[str, tuple]:
    point = given.laser_p_corner
    return {"base_link": given.base_T_laser.apply(point), "map": given.map_T_base.apply(point)}


AN_EDGE_SKIPPED = Twin(
    "an_edge_skipped",
    corner_skips_the_laser,
    Words(
        en="the first is right. For `map` you applied `map_T_base` to a point that is written in the "
        "laser: one domino is missing.",
        ko="첫째는 맞습니다. `map`을 구할 때는 레이저 기준 점에 `map_T_base`를 적용했습니다. 도미노 하나가 빠졌습니다.",
    ),
)


def corner_inverse_carried_on(given) -> dict[str, tuple]:
    base_p = given.base_T_laser.inverse().apply(given.laser_p_corner)
    return {"base_link": base_p, "map": given.map_T_base.apply(base_p)}


INVERSE_CARRIED_ON = Twin(
    "inverse_carried_on",
    corner_inverse_carried_on,
    Words(
        en="the way on to `map` is right, the way to `base_link` is not: you took the inverse of "
        "`base_T_laser`. Which frame's points does it take in, as it stands?",
        ko="`map`으로 이어 가는 방법은 맞지만 `base_link`로 가는 방법이 틀립니다. `base_T_laser`의 역변환을 썼습니다. "
        "`base_T_laser`는 그대로 둘 때 어느 좌표계 기준인 점을 받습니까?",
    ),
    "M1",
)


def corner_leaves_the_map(given) -> dict[str, tuple]:
    base_p = given.base_T_laser.apply(given.laser_p_corner)
    return {"base_link": base_p, "map": given.map_T_base.inverse().apply(base_p)}


OUT_OF_THE_MAP = Twin(
    "out_of_the_map",
    corner_leaves_the_map,
    Words(
        en="the first is right. For `map` you used the inverse of `map_T_base`, which takes points out of "
        "the map; you want the corner in it.",
        ko="첫째는 맞습니다. `map`을 구할 때는 `map_T_base`의 역변환을 썼는데, 그것은 map 기준인 점을 로봇 기준으로 "
        "옮깁니다. 원하는 것은 map 기준인 모서리입니다.",
    ),
    "M1",
)


def corner_both_inverted(given) -> dict[str, tuple]:
    base_p = given.base_T_laser.inverse().apply(given.laser_p_corner)
    return {"base_link": base_p, "map": given.map_T_base.inverse().apply(base_p)}


BOTH_INVERTED = Twin(
    "both_inverted",
    corner_both_inverted,
    Words(
        en="you inverted both transforms, one after the other. As they stand, `base_T_laser` takes laser "
        "data to the base and `map_T_base` takes it on to the map: read each name from right to left.",
        ko="두 변환을 모두 뒤집어 차례로 적용했습니다. 그대로 두면 `base_T_laser`는 레이저 데이터를 베이스로, "
        "`map_T_base`는 그것을 지도로 옮깁니다. 이름을 오른쪽에서 왼쪽으로 읽어 보십시오.",
    ),
    "M1",
)


def corner_is_the_laser(given) -> dict[str, tuple]:
    map_T_laser = given.map_T_base @ given.base_T_laser
    return {"base_link": given.base_T_laser.translation, "map": map_T_laser.translation}


THE_LASER_ITSELF = Twin(
    "the_laser_itself",
    corner_is_the_laser,
    Words(
        en="that is where the laser sits; the corner has not come into it yet. Give `laser_p_corner` to `.apply(...)`.",
        ko="그것은 레이저가 달린 자리입니다. 모서리가 아직 들어가지 않았습니다. `.apply(...)`에 `laser_p_corner`를 "
        "넣으십시오.",
    ),
)


TASK = Task(
    id="E3.2",
    kind="N",
    points=4,
    title=Words(en="A corner seen by a turned laser", ko="돌려 단 레이저가 본 모서리"),
    answer="corner",
    form=Parts({"base_link": Vector(3, "m", "base_link", 0.005), "map": Vector(3, "m", "map", 0.005)}),
    given=corner_given,
    variants=6,
    twins=(
        SWAPPED,
        BOTH_INVERTED,
        THE_LASER_ITSELF,
        TURN_IGNORED,
        STEP_BEFORE_TURN,
        PRODUCT_REVERSED,
        AN_EDGE_SKIPPED,
        INVERSE_CARRIED_ON,
        OUT_OF_THE_MAP,
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
)
