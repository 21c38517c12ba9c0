"""E7.2: Where the beam meets the floor."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Number, Parts, Task, Text, WrongStep

BASE_UP_M = 0.10


def a_tilt(rng):
    """The floor is met beyond the wall, so the beam does end on the wall."""
    while True:
        tilt_deg = round(float(rng.uniform(8.0, 14.0)), 1)
        up = int(rng.integers(20, 60)) / 100
        wall = round(float(rng.uniform(0.8, 2.2)), 2)
        left = up + BASE_UP_M - wall * math.tan(math.radians(tilt_deg))
        apart = abs(left - up) > 0.01 and abs(left - (up - BASE_UP_M)) > 0.02  # heights that slips give
        if left > 0.12 and apart and abs(up + BASE_UP_M - 2 * left) > 0.02:
            return {
                "tilt_deg": tilt_deg,
                "laser_above_base_link_m": up,
                "base_link_above_floor_m": BASE_UP_M,
                "wall_m": wall,
            }


def beam(g, *, height="both", angle="rad", way="down", ratio="tan", floor="along the floor", wall="what is left"):
    """Return both, step by step; other steps are the slips."""
    up = {"both": g.laser_above_base_link_m + g.base_link_above_floor_m, "laser": g.laser_above_base_link_m,
          "base": g.base_link_above_floor_m, "minus": g.laser_above_base_link_m - g.base_link_above_floor_m}[height]  # fmt: skip
    turn = g.tilt_deg if angle == "deg" else math.radians(g.tilt_deg)
    slope = {
        "tan": math.tan(turn),
        "cot": 1.0 / math.tan(turn),
        "sin": math.sin(turn),
        "cos": math.cos(turn),
        "angle": turn,
    }[ratio]
    slope = -slope if way == "up" else slope
    floor_m = {"along the floor": up / slope, "along the beam": math.hypot(up / slope, up),
               "from the wall": up / slope - g.wall_m}[floor]  # fmt: skip
    drop = g.wall_m * slope
    wall_m = {
        "what is left": up - drop,
        "drop": drop,
        "level": up,
        "from the laser": -drop,
        "nothing": 0.0,
        "ahead of it": up / slope - g.wall_m,
        "by the sine": up - g.wall_m * math.sin(turn),
        "over the slope": (up / slope - g.wall_m) / slope,
    }[wall]
    return {"floor_m": floor_m, "wall_up_m": wall_m}


SLIPS = (
    WrongStep(
        "base forgotten",
        {"height": "laser"},
        Text(
            en="You counted the laser's height from base_link. base_link itself rides above the floor.",
            ko="레이저의 높이를 base_link에서부터 셌습니다. base_link도 바닥 위에 떠 있습니다.",
        ),
        partly=True,
    ),
    WrongStep(
        "base taken off",
        {"height": "minus"},
        Text(
            en="You took base_link's height off the laser's. Both go up: they add.",
            ko="레이저의 높이에서 base_link의 높이를 뺐습니다. 둘 다 위쪽이므로 더합니다.",
        ),
        partly=True,
    ),
    WrongStep(
        "degrees",
        {"angle": "deg"},
        Text(
            en="Your tangent took degrees for radians: math.radians first.",
            ko="도(degree)를 그대로 넣어 탄젠트를 구했습니다. math.radians로 먼저 바꾸십시오.",
        ),
        "M5",
        partly=True,
    ),
    WrongStep(
        "tilted upwards",
        {"way": "up"},
        Text(
            en="Your beam goes up: it hits the wall above the laser, and the floor never. This laser looks down.",
            ko="빛이 위로 갑니다. 벽에는 레이저보다 높이 닿고 바닥에는 닿지 않습니다. 이 레이저는 아래를 봅니다.",
        ),
        partly=True,
    ),
    WrongStep(
        "turned fraction",
        {"ratio": "cot"},
        Text(
            en="The tangent stands on the wrong side: it is how far the beam sinks over each metre ahead.",
            ko="탄젠트의 위치가 바뀌었습니다. 탄젠트는 1미터 나아갈 때 빛이 내려가는 길이입니다.",
        ),
        partly=True,
    ),
    WrongStep(
        "along the beam",
        {"floor": "along the beam"},
        Text(
            en="That is how long the beam is. Asked is how far ahead, along the floor; the beam is the longer side.",
            ko="빛의 길이입니다. 바닥을 따라 앞으로 얼마인지 물었습니다. 빛의 길이가 더 긴 변입니다.",
        ),
        part="floor_m",
    ),
    WrongStep(
        "drop only",
        {"wall": "drop"},
        Text(
            en="That is by how much the beam sinks up to the wall. Take it off the height in which it starts.",
            ko="벽까지 빛이 내려간 높이입니다. 출발한 높이에서 빼십시오.",
        ),
        part="wall_up_m",
    ),
    WrongStep(
        "from the laser",
        {"wall": "from the laser"},
        Text(
            en="That is counted from the laser, downwards. Asked is the height above the floor.",
            ko="레이저에서 아래로 잰 값입니다. 바닥에서 잰 높이가 필요합니다.",
        ),
        part="wall_up_m",
    ),
    WrongStep(
        "from the wall",
        {"floor": "from the wall"},
        Text(
            en="That is how far behind the wall the floor would be met. Count from the laser, as if there were no wall.",
            ko="벽 뒤로 얼마나 더 간 곳인지입니다. 벽이 없다고 하고 레이저에서부터 세십시오.",
        ),
        part="floor_m",
    ),
    WrongStep(
        "as if level",
        {"wall": "level"},
        Text(
            en="That is the height in which a level laser would see the wall. This one looks down.",
            ko="수평인 레이저가 벽을 보는 높이입니다. 이 레이저는 아래를 봅니다.",
        ),
        part="wall_up_m",
    ),
)


BASE_ALONE = WrongStep(
    "base alone",
    {"height": "base"},
    Text(
        en="You counted from base_link's height alone. The laser sits above it: the two heights add.",
        ko="base_link의 높이만 셌습니다. 레이저는 그 위에 있으므로 두 높이를 더합니다.",
    ),
)


COSINE = WrongStep(
    "cosine",
    {"ratio": "cos"},
    Text(
        en="You took the cosine for how far the beam sinks over each metre: that is the tangent.",
        ko="1미터 앞으로 갈 때 내려가는 양에 cos을 썼습니다. tan입니다.",
    ),
    partly=True,
)


ANGLE_FOR_SLOPE = WrongStep(
    "angle for slope",
    {"ratio": "angle"},
    Text(
        en="You took the angle itself for the slope. For small ones that is close; the tangent is exact.",
        ko="각도를 그대로 기울기로 썼습니다. 작은 각도에서는 비슷하지만, 정확한 것은 tan입니다.",
    ),
    partly=True,
)


SINE = WrongStep(
    "sine",
    {"ratio": "sin"},
    Text(
        en="You took the sine for how far the beam sinks over each metre ahead: that is the tangent. The sine is per metre of beam.",
        ko="앞으로 1미터 갈 때 내려가는 양에 sin을 썼습니다. tan입니다. sin은 빛의 길이 1미터마다입니다.",
    ),
    partly=True,
)


WALL_BY_THE_SINE = WrongStep(
    "wall by the sine",
    {"wall": "by the sine"},
    Text(
        en="At the wall you took the sine: that is how far the beam sinks per metre of beam. The wall's distance is measured along the floor: the tangent.",
        ko="벽에서 sin을 썼습니다. 빛의 길이 1미터마다 내려가는 양입니다. 벽까지의 거리는 바닥을 따라 잰 것이므로 tan입니다.",
    ),
    part="wall_up_m",
)


AHEAD_OF_THE_WALL = WrongStep(
    "ahead of the wall",
    {"wall": "ahead of it"},
    Text(
        en="That is how much farther ahead than the wall the beam would meet the floor. Asked for is a height.",
        ko="빛이 벽보다 얼마나 더 앞에서 바닥에 닿는지입니다. 필요한 것은 높이입니다.",
    ),
    part="wall_up_m",
)


NOTHING_AT_THE_WALL = WrongStep(
    "nothing at the wall",
    {"wall": "nothing"},
    Text(
        en="0 is where the floor is. The wall stands nearer than the place where the beam would meet it: the beam is still up.",
        ko="0은 바닥입니다. 벽은 빛이 바닥에 닿을 곳보다 가까이 있으므로 빛은 아직 위에 있습니다.",
    ),
    part="wall_up_m",
)


OVER_THE_SLOPE = WrongStep(
    "over the slope",
    {"wall": "over the slope"},
    Text(
        en="What is left behind the wall is divided by the tangent, where it has to be multiplied: the tangent is how far the beam sinks over each metre ahead.",
        ko="벽 너머에 남은 길이를 탄젠트로 나누었는데, 곱해야 합니다. 탄젠트는 1미터 나아갈 때 빛이 내려가는 높이입니다.",
    ),
    part="wall_up_m",
)


TASK = Task(
    id="E7.2",
    kind="N",
    points=3,
    title=Text(en="Where the beam meets the floor", ko="빛이 바닥에 닿는 곳"),
    answer="beam",
    form=Parts({"floor_m": Number("m", 0.0006), "wall_up_m": Number("m", 0.0006)}),
    given=a_tilt,
    variants=6,
    model=beam,
    mistakes=(
        *SLIPS,
        BASE_ALONE,
        COSINE,
        ANGLE_FOR_SLOPE,
        SINE,
        WALL_BY_THE_SINE,
        AHEAD_OF_THE_WALL,
        NOTHING_AT_THE_WALL,
        OVER_THE_SLOPE,
    ),
    hints=(
        Text(en="How high is the laser above the floor?", ko="레이저는 바닥에서 얼마나 높이 있습니까?"),
        Text(
            en="A beam that looks down by an angle sinks by tan(angle) over each metre ahead.",
            ko="아래로 기운 빛은 1미터 나아갈 때마다 tan(각도)만큼 내려갑니다.",
        ),
        Text(
            en="floor_m = height / tan; wall_up_m = height - wall_m * tan. Angles in radians.",
            ko="floor_m = 높이 / tan, wall_up_m = 높이 - wall_m * tan입니다. 각도는 라디안입니다.",
        ),
    ),
    misconceptions=("M5",),
)
