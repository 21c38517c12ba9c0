"""E3.4: Two dominoes into one."""

from __future__ import annotations

import numpy as np

from tflab.workbook.tasks import Task, Twin, Words

from .draws import PLANAR, moved, some_planar


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


OTHER_ORDER = Twin(
    "other_order",
    other_order,
    Words(
        en="you put them together in the other order: b_pose_c first, then a_pose_b. Lay the dominoes: [a|b][b|c].",
        ko="순서를 바꿔 이었습니다. b_pose_c가 먼저, a_pose_b가 나중입니다. 도미노를 놓아 보십시오. [a|b][b|c]",
    ),
)


def only_added(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, 0.0)


ONLY_ADDED = Twin(
    "only_added",
    only_added,
    Words(
        en="you added the steps as they are. The second step is measured along b's axes, and b is turned in a.",
        ko="이동을 그대로 더했습니다. 둘째 이동은 b의 축을 따라 잰 값이고, b는 a 안에서 돌아가 있습니다.",
    ),
    "M3",
)


def turned_the_other_way(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, -a_pose_b["yaw"])


TURNED_BACK = Twin(
    "turned_back",
    turned_the_other_way,
    Words(
        en="the second step is turned the wrong way. b data goes to a with b's yaw, as it stands.",
        ko="둘째 이동을 반대로 돌렸습니다. b의 데이터는 b의 yaw 그대로 돌려서 a로 옮깁니다.",
    ),
    "M1",
)


def turned_by_both(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, a_pose_b["yaw"] + b_pose_c["yaw"])


TURNED_BY_BOTH = Twin(
    "turned_by_both",
    turned_by_both,
    Words(
        en="you turned the second step by both yaws. It is measured along b's axes; c's own yaw turns what "
        "comes after c.",
        ko="둘째 이동을 두 yaw의 합만큼 돌렸습니다. 둘째 이동은 b의 축을 따라 잰 값입니다. c의 yaw는 c 다음에 오는 "
        "것을 돌립니다.",
    ),
)


def added_then_turned(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    step = moved(a_pose_b, a_pose_b["x"] + b_pose_c["x"], a_pose_b["y"] + b_pose_c["y"], a_pose_b["yaw"])
    return step | {"yaw": a_pose_b["yaw"] + b_pose_c["yaw"]}


ADDED_THEN_TURNED = Twin(
    "added_then_turned",
    added_then_turned,
    Words(
        en="you added the steps and then turned the sum. The first step is measured in a already, so nobody turns it.",
        ko="이동을 더한 다음 합을 돌렸습니다. 첫째 이동은 이미 a에서 잰 값이므로 돌리지 않습니다.",
    ),
)


def yaws_not_added(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, a_pose_b["yaw"]) | {"yaw": b_pose_c["yaw"]}


YAWS_NOT_ADDED = Twin(
    "yaws_not_added",
    yaws_not_added,
    Words(
        en="`x` and `y` are right. The yaw is that of c in b: in a, b's own turn comes on top.",
        ko="`x`와 `y`는 맞습니다. yaw는 b에서 본 c의 값입니다. a에서 보면 b가 돌아간 만큼 더해집니다.",
    ),
)


def turned_by_the_second(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    return composed(a_pose_b, b_pose_c, b_pose_c["yaw"])


TURNED_BY_THE_SECOND = Twin(
    "turned_by_the_second",
    turned_by_the_second,
    Words(
        en="you turned the second step by its own yaw. It is b that is turned in a: which of the two yaws "
        "says by how much?",
        ko="둘째 이동을 자기 yaw로 돌렸습니다. a 안에서 돌아가 있는 것은 b입니다. 그 각도는 두 yaw 가운데 "
        "어느 것입니까?",
    ),
)


def first_step_lost(a_pose_b: dict, b_pose_c: dict) -> dict[str, float]:
    step = moved(a_pose_b, b_pose_c["x"], b_pose_c["y"], a_pose_b["yaw"])
    return step | {"yaw": a_pose_b["yaw"] + b_pose_c["yaw"]}


FIRST_STEP_LOST = Twin(
    "first_step_lost",
    first_step_lost,
    Words(
        en="you turned the second step rightly and forgot to add the first: b itself does not lie at a's origin.",
        ko="둘째 이동은 바르게 돌렸지만 첫째 이동을 더하지 않았습니다. b는 a의 원점에 있지 않습니다.",
    ),
)


TASK = Task(
    id="E3.4",
    kind="F",
    points=4,
    title=Words(en="Two dominoes into one", ko="도미노 둘을 하나로"),
    answer="compose",
    form=PLANAR,
    inputs=compose_inputs,
    variants=3,
    twins=(
        OTHER_ORDER,
        ONLY_ADDED,
        TURNED_BACK,
        TURNED_BY_THE_SECOND,
        TURNED_BY_BOTH,
        ADDED_THEN_TURNED,
        FIRST_STEP_LOST,
        YAWS_NOT_ADDED,
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
)
