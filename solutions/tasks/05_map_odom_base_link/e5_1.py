"""E5.1: What a localiser publishes."""

from __future__ import annotations

from tflab.core import Transform
from tflab.workbook.tasks import Pose, Task, Text, WrongAnswer, WrongStep

from .draws import STEP_NEGATED, by_parts, on_a_slope, on_the_floor, turned_round


def two_poses(rng):
    """Both turned; the wheels without a fault; odom's origin under the robot; a ramp that either knows, or both."""
    same = on_the_floor(rng)
    pairs = [(on_the_floor(rng), on_the_floor(rng)) for _ in range(4)]
    ramps = [(on_a_slope(rng), on_the_floor(rng)), (on_the_floor(rng), on_a_slope(rng))]
    return [*pairs, (same, same), (on_the_floor(rng), Transform()), *ramps, (on_a_slope(rng), on_a_slope(rng))]


def product(map_T_base, odom_T_base, *, poses="as given", found="as given", wheels="turned round",
            order="found first", way="as asked", edge="whole"):  # fmt: skip
    """Return map_T_odom, step by step; other steps are the slips."""
    if poses == "flat":
        map_T_base, odom_T_base = flat(map_T_base), flat(odom_T_base)
    left = map_T_base.inverse() if found == "turned round" else map_T_base
    right = turned_round(odom_T_base, wheels)
    joined = left @ right if order == "found first" else right @ left
    joined = joined.inverse() if way == "turned round" else joined
    return flat(joined) if edge == "flat" else joined


NO_INVERSE = WrongStep(
    "no inverse",
    {"wheels": "as given"},
    Text(
        en="The wheels' pose went in as it is: [map|base][odom|base] do not match. It has to be turned round.",
        ko="바퀴의 포즈를 그대로 이었습니다. [map|base][odom|base]는 이웃이 맞지 않습니다. 뒤집어야 합니다.",
    ),
    "M1",
)

OTHER_ORDER = WrongStep(
    "other order",
    {"order": "wheels first"},
    Text(
        en="The factors stand in the other order. Lay the dominoes: what has to stand first begins with map.",
        ko="곱의 순서가 바뀌었습니다. 도미노를 놓아 보세요. map으로 시작하는 조각이 먼저입니다.",
    ),
    "M1",
)

FOUND_TURNED_ROUND = WrongStep(
    "found turned round",
    {"found": "turned round"},
    Text(
        en="The pose on the map is turned round, and it should stand as it is: it begins with map already.",
        ko="지도 위의 포즈를 뒤집었습니다. 이미 map으로 시작하므로 그대로 두어야 합니다.",
    ),
)

THE_OTHER_WAY = WrongStep(
    "the other way",
    {"way": "turned round"},
    Text(
        en="That is odom_T_map: the same edge, read the other way. Asked for is map_T_odom, map as the parent.",
        ko="odom_T_map입니다. 같은 연결을 거꾸로 읽은 것입니다. map이 부모인 map_T_odom이 필요합니다.",
    ),
    "M1",
)

TURN_BACK_ALONE = WrongAnswer(
    "turn back alone",
    lambda map_T_base, odom_T_base: map_T_base @ Transform(odom_T_base.translation, odom_T_base.inverse().rotation),
    Text(
        en="Of the wheels' pose the rotation is turned round, and the step is still as it was. An inverse has another step, too: `.inverse()` gives both.",
        ko="바퀴 포즈의 회전만 뒤집고 이동은 그대로 두었습니다. 역변환은 이동도 다릅니다. `.inverse()`가 둘 다 구합니다.",
    ),
    "M3",
)

SUBTRACTED = WrongAnswer(
    "subtracted",
    by_parts,
    Text(
        en="You subtracted steps and yaws. That is right only while nobody is turned: the wheels' step is measured along axes that point elsewhere.",
        ko="이동과 yaw를 따로 뺐습니다. 아무것도 돌아 있지 않을 때만 맞습니다. 바퀴의 이동은 다른 방향을 보는 축으로 잰 것입니다.",
    ),
    "M3",
)

WHERE_THE_ROBOT_IS = WrongAnswer(
    "where the robot is",
    lambda map_T_base, odom_T_base: map_T_base,
    Text(
        en="You publish where the robot is. But base hangs below odom already, by the wheels: what is missing is the edge above odom.",
        ko="로봇의 위치를 그대로 발행합니다. 하지만 base는 이미 바퀴에 의해 odom 아래에 있습니다. 필요한 것은 odom 위의 연결입니다.",
    ),
    "M7",
)

WHAT_THE_WHEELS_SAY = WrongAnswer(
    "what the wheels say",
    lambda map_T_base, odom_T_base: odom_T_base,
    Text(
        en="That is what the wheels publish already. The map has no part in it.",
        ko="바퀴가 이미 발행하는 값입니다. 지도에서 찾은 위치가 들어 있지 않습니다.",
    ),
    "M7",
)


def right_edge(map_T_base, odom_T_base):
    return map_T_base @ odom_T_base.inverse()


STEP_ALONE = WrongAnswer(
    "step alone",
    lambda map_T_base, odom_T_base: Transform(right_edge(map_T_base, odom_T_base).translation),
    Text(
        en="The edge has no turn: odom does not only lie elsewhere in map, it is turned as well.",
        ko="연결에 회전이 없습니다. odom은 map 기준으로 자리만 다른 것이 아니라 돌아가 있기도 합니다.",
    ),
)

NO_TURN_AT_ALL = WrongAnswer(
    "steps subtracted, no turn",
    lambda map_T_base, odom_T_base: Transform(
        [a - b for a, b in zip(map_T_base.translation, odom_T_base.translation, strict=True)]
    ),
    Text(
        en="You subtracted the two steps and left the turns out. As soon as anything is turned, poses are joined with `@`.",
        ko="두 이동을 빼고 회전을 빠뜨렸습니다. 무엇이든 돌아 있으면 포즈는 `@`로 잇습니다.",
    ),
    "M3",
)

TURN_OF_THE_ROBOT = WrongAnswer(
    "subtracted, the robot's turn",
    lambda map_T_base, odom_T_base: Transform(
        [a - b for a, b in zip(map_T_base.translation, odom_T_base.translation, strict=True)], map_T_base.rotation
    ),
    Text(
        en="You subtracted the two steps and kept the robot's turn on the map. Both parts of the wheels' pose have to be taken out: join with `@`.",
        ko="두 이동을 빼고 지도 기준 로봇의 회전을 그대로 두었습니다. 바퀴 포즈의 두 부분을 모두 빼내야 합니다. `@`로 이으십시오.",
    ),
    "M3",
)


NO_TURN_ON_THE_FLOOR = WrongAnswer(
    "x and y subtracted, no turn",
    lambda map_T_base, odom_T_base: Transform(
        [*(a - b for a, b in zip(map_T_base.translation[:2], odom_T_base.translation[:2], strict=True)), 0.0]
    ),
    Text(
        en="You subtracted x and y and left out the turns, and the height with them. Whole poses are joined with `@`.",
        ko="x와 y만 빼고 회전과 높이를 빠뜨렸습니다. 포즈는 통째로 `@`로 잇습니다.",
    ),
    "M3",
)


SUBTRACTED_ON_THE_FLOOR = WrongAnswer(
    "x, y and yaw subtracted",
    lambda map_T_base, odom_T_base: by_parts(flat(map_T_base), flat(odom_T_base)),
    Text(
        en="You subtracted x, y and yaw. That is right only on a flat floor, and while nobody is turned: whole poses are joined with `@`.",
        ko="x, y, yaw를 따로 뺐습니다. 바닥이 평평하고 아무것도 돌아 있지 않을 때만 맞습니다. 포즈는 통째로 `@`로 잇습니다.",
    ),
    "M3",
)


SUBTRACTED_THE_OTHER_WAY = WrongAnswer(
    "subtracted the other way",
    lambda map_T_base, odom_T_base: by_parts(odom_T_base, map_T_base),
    Text(
        en="You took the pose on the map off the wheels' pose, number by number: the order is turned round, and poses are joined with `@`, not subtracted.",
        ko="바퀴의 포즈에서 지도의 포즈를 숫자끼리 뺐습니다. 순서가 반대이고, 포즈는 빼지 않고 `@`로 잇습니다.",
    ),
    "M3",
)


THE_ROBOT_S_TURN_KEPT = WrongAnswer(
    "the robot's turn kept",
    lambda map_T_base, odom_T_base: Transform(right_edge(map_T_base, odom_T_base).translation, map_T_base.rotation),
    Text(
        en="The turn is still the robot's own on the map. The wheels know a part of it already.",
        ko="회전이 아직 지도에서 본 로봇의 회전 그대로입니다. 그 일부는 바퀴가 이미 알고 있습니다.",
    ),
)


def flat(pose):
    """Return a pose as a map of the floor has it: x, y and yaw."""
    x, y, _ = pose.translation
    return Transform.from_rpy(yaw=pose.rpy()[2], translation=(x, y, 0.0))


FLATTENED = WrongStep(
    "flattened",
    {"poses": "flat"},
    Text(
        en="You kept x, y and yaw of the two poses and left out height and tilt. A ramp has both: the edge is made of whole poses.",
        ko="두 포즈에서 x, y, yaw만 쓰고 높이와 기울기를 버렸습니다. 경사로에는 둘 다 있습니다. 연결은 포즈 전체로 구합니다.",
    ),
)

EDGE_FLATTENED = WrongStep(
    "edge flattened",
    {"edge": "flat"},
    Text(
        en="Of the edge you kept x, y and yaw. Where the two poses differ in height or tilt, the edge has that difference, too.",
        ko="연결에서 x, y, yaw만 남겼습니다. 두 포즈의 높이나 기울기가 다르면 그 차이도 연결에 들어 있어야 합니다.",
    ),
)


THE_OTHER_ONE_TURNED_ROUND = WrongStep(
    "the other one turned round",
    {"found": "turned round", "wheels": "as given"},
    Text(
        en="You turned the wrong one of the two round: the product begins with base and ends with base. The pose on the map begins with map already; it is the wheels' that has to be turned.",
        ko="둘 가운데 다른 쪽을 뒤집었습니다. 곱이 base로 시작해서 base로 끝납니다. 지도 위의 포즈는 이미 map으로 시작합니다. 뒤집을 것은 바퀴의 포즈입니다.",
    ),
    "M1",
)


ORDER_AND_NO_INVERSE = WrongStep(
    "other order, nothing turned",
    {"wheels": "as given", "order": "wheels first"},
    Text(
        en="Both poses went in as they are, and the wheels' one stands first: [odom|base][map|base] do not match. Begin with map, and turn the wheels' pose round.",
        ko="두 포즈를 그대로 곱했고 바퀴의 포즈가 앞에 있습니다. [odom|base][map|base]는 이웃이 맞지 않습니다. map부터 시작하고 바퀴의 포즈를 뒤집으십시오.",
    ),
    "M1",
)


TURNED_BACK_STEP_NEGATED = WrongStep(
    "turned back, step negated",
    {"wheels": "turned back, step negated"},
    Text(
        en="Of the wheels' pose the rotation is turned back, and the step has only changed its signs. In an inverse the step back is measured along the turned axes: `.inverse()` turns it, too.",
        ko="바퀴 포즈의 회전은 뒤집었지만 이동은 부호만 바꾸었습니다. 역변환에서는 되돌아가는 이동을 돌아간 축을 따라 잽니다. `.inverse()`는 이동도 돌립니다.",
    ),
    "M3",
)


TASK = Task(
    id="E5.1",
    kind="F",
    points=4,
    title=Text(en="What a localiser publishes", ko="위치 추정 노드가 발행하는 것"),
    answer="map_to_odom",
    form=Pose(),
    inputs=two_poses,
    variants=3,
    model=product,
    mistakes=(
        NO_INVERSE,
        OTHER_ORDER,
        THE_OTHER_WAY,
        FOUND_TURNED_ROUND,
        SUBTRACTED,
        WHERE_THE_ROBOT_IS,
        WHAT_THE_WHEELS_SAY,
        STEP_NEGATED,
        TURN_BACK_ALONE,
        STEP_ALONE,
        NO_TURN_AT_ALL,
        TURN_OF_THE_ROBOT,
        NO_TURN_ON_THE_FLOOR,
        SUBTRACTED_ON_THE_FLOOR,
        SUBTRACTED_THE_OTHER_WAY,
        THE_ROBOT_S_TURN_KEPT,
        FLATTENED,
        EDGE_FLATTENED,
        THE_OTHER_ONE_TURNED_ROUND,
        ORDER_AND_NO_INVERSE,
        TURNED_BACK_STEP_NEGATED,
    ),
    hints=(
        Text(
            en="Write the names as dominoes: [map|base] and [odom|base].",
            ko="이름을 도미노로 써 보세요. [map|base]와 [odom|base]입니다.",
        ),
        Text(
            en="One of them has to be turned round, so that base meets base.",
            ko="base와 base가 만나도록 하나를 뒤집어야 합니다.",
        ),
        Text(
            en="`.inverse()` turns a Transform round, and `@` joins two.",
            ko="`.inverse()`는 Transform을 뒤집고 `@`는 둘을 잇습니다.",
        ),
    ),
    misconceptions=("M1", "M3", "M7"),
)
