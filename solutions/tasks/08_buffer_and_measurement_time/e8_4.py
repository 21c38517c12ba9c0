"""E8.4: How far off?"""

from __future__ import annotations

import math
from itertools import combinations

from tflab.workbook.tasks import Number, Parts, Task, Text, WrongStep


def motion(rng):
    """Draw until no two mistakes give the same lengths."""
    while True:
        given = _motion(rng)
        delay_s, range_m = given["delay_ms"] / 1000.0, given["range_m"]
        angle = math.radians(abs(given["yaw_rate_degps"])) * delay_s
        ahead, aside = given["speed_mps"] * delay_s, range_m * math.radians(given["yaw_rate_degps"]) * delay_s
        of_the_way, of_the_ray = ahead * angle, range_m * (1.0 - math.cos(angle))
        arcs = (angle, given["speed_mps"] * angle, range_m * angle / math.tau)
        means = ((ahead + aside) / 2.0, math.hypot(ahead, aside) / math.sqrt(2.0))
        is_told_apart = all(abs(one - other) > 0.004 for one, other in (*combinations(arcs, 2), means))
        if of_the_way > 0.008 and abs(of_the_way - of_the_ray) > 0.007 and is_told_apart:
            return given


def _motion(rng):
    way = float(rng.choice([-1.0, 1.0]))
    speed_mps = float(rng.uniform(0.6, 1.8))
    yaw_rate_degps = way * float(rng.uniform(15.0, 40.0))
    range_m = float(rng.uniform(3.0, 8.0))
    if abs(speed_mps - range_m * math.radians(abs(yaw_rate_degps))) < 0.15:  # the two pieces must not look alike
        speed_mps += 0.3
    return {
        "speed_mps": round(speed_mps, 2),
        "yaw_rate_degps": round(yaw_rate_degps, 1),
        "range_m": round(range_m, 1),
        "delay_ms": float(rng.integers(8, 25) * 10),
    }


def late(
    given,
    *,
    delay=1e-3,
    forwards=1.0,
    angle="radians",
    arc="range",
    side=1.0,
    places="kept",
    together="hypot",
    way="speed",
):
    """Return the estimate, step by step; other steps are the slips."""
    delay_s = given.delay_ms * delay if delay else 1.0
    yaw_rate = given.yaw_rate_degps if angle == "degrees" else math.radians(given.yaw_rate_degps)
    yaw_rate = {
        "to degrees": math.degrees(given.yaw_rate_degps),
        "turns": given.yaw_rate_degps / 360.0,
        "twice": 2.0 * yaw_rate,
    }.get(angle, yaw_rate)
    ahead, aside = forwards * given.speed_mps * delay_s, side * yaw_rate * delay_s
    aside *= {"speed": given.speed_mps, "range": given.range_m, "none": 1.0, "forgotten": 0.0}.get(arc, given.range_m)
    aside = {
        "the way": ahead * yaw_rate * delay_s,
        "range left over": (given.range_m - ahead) * side * yaw_rate * delay_s,
        "no delay": given.range_m * side * yaw_rate,
    }.get(arc, aside)
    ahead = {
        "times range": ahead * given.range_m,
        "range minus": given.range_m - ahead,
        "range plus": given.range_m + ahead,
        "no delay": given.speed_mps,
    }.get(way, ahead)
    aside = {
        "speed times range": ahead * given.range_m,
        "sine of degrees": given.range_m * math.sin(given.yaw_rate_degps * delay_s),
        "one minus cosine": given.range_m * (1 - math.cos(aside / given.range_m)),
    }.get(arc, aside)
    ahead, aside = (aside, ahead) if places == "exchanged" else (ahead, aside)
    lengths = {
        "hypot": math.hypot(ahead, aside),
        "added": abs(ahead) + abs(aside),
        "forwards": abs(ahead),
        "left": abs(aside),
        "mean": (ahead + aside) / 2,
        "sizes taken off": abs(ahead) - abs(aside),
        "squares": ahead**2 + aside**2,
        "rms": math.hypot(ahead, aside) / math.sqrt(2.0),
        "direction": math.atan2(aside, ahead),
    }
    return {"forwards_m": ahead, "left_m": aside, "together_m": lengths[together]}


SPEED_ONLY = WrongStep(
    "speed only",
    {"arc": "forgotten"},
    Text(
        en="The turn is left out: it is no zero. The pose of now looks another way, and drags the object along sideways: the more, the farther it is.",
        ko="회전이 빠져 0이 되었습니다. 로봇은 지금 다른 쪽을 보고 있어서, 그 회전이 물체를 옆으로 끌고 갑니다. 멀리 있을수록 더 그렇습니다.",
    ),
    "M9",
    part="left_m",
)


DEGREES = WrongStep(
    "degrees",
    {"angle": "degrees"},
    Text(
        en="The yaw rate went in as degrees per second. Arc = range × angle holds for radians.",
        ko="각속도를 초당 도 단위 그대로 넣었습니다. 호 = 거리 × 각도는 라디안일 때 맞습니다.",
    ),
    "M5",
    part="left_m",
)


WRONG_SIDE = WrongStep(
    "wrong side",
    {"side": -1.0},
    Text(
        en="The wrong side: the sign is turned round, or a minus is lost, as `abs` loses it. Where the robot has turned left meanwhile, its straight ahead points further left, and so does the old sight; a negative yaw rate turns right.",
        ko="반대쪽입니다. 부호를 뒤집었거나 `abs`처럼 음의 부호를 없앴습니다. 그사이 로봇이 왼쪽으로 돌았다면 정면이 더 왼쪽을 가리키고 옛 관측도 왼쪽으로 갑니다. 음의 각속도는 오른쪽으로 도는 것입니다.",
    ),
    part="left_m",
)


ADDED = WrongStep(
    "added",
    {"together": "added"},
    Text(
        en="That is the sum of the two lengths. The two pieces are at right angles: their lengths do not simply add up.",
        ko="두 길이의 합입니다. 두 성분은 서로 직각이므로 길이를 그냥 더하지 않습니다.",
    ),
    part="together_m",
)


MILLISECONDS = WrongStep(
    "milliseconds",
    {"delay": 1.0},
    Text(
        en="Everything is a thousand times too large: milliseconds went in for seconds, or millimetres come out.",
        ko="모두 천 배입니다. 지연을 밀리초 그대로 넣었거나 밀리미터로 답했습니다.",
    ),
)


HUNDREDTHS = WrongStep(
    "hundredths",
    {"delay": 1e-2},
    Text(
        en="Your delay is ten times too long: a millisecond is a thousandth of a second, not a hundredth.",
        ko="지연이 열 배입니다. 1밀리초는 100분의 1초가 아니라 1000분의 1초입니다.",
    ),
)

WITHOUT_THE_RANGE = WrongStep(
    "without the range",
    {"arc": "none"},
    Text(
        en="Yaw rate × delay is the angle only. How long is the arc that it cuts off at the object's distance?",
        ko="각속도 × 지연은 각도일 뿐입니다. 물체까지의 거리에서 그 각도는 얼마나 긴 호가 됩니까?",
    ),
    part="left_m",
)


CROSSWISE = WrongStep(
    "crosswise",
    {"places": "exchanged"},
    Text(
        en="The two pieces have changed places. Driving pushes the point forwards, turning drags it to the side.",
        ko="두 성분이 자리를 바꾸었습니다. 주행은 점을 앞으로 밀고, 회전은 옆으로 끌고 갑니다.",
    ),
)


ROTATION_ONLY = WrongStep(
    "rotation only",
    {"forwards": 0.0},
    Text(
        en="You left out the drive. While the delay lasted the robot went on at `speed_mps`, and the point goes along.",
        ko="주행을 빠뜨렸습니다. 지연되는 동안 로봇은 `speed_mps`로 계속 갔고 점도 함께 옮겨집니다.",
    ),
    "M9",
    part="forwards_m",
)

BACKWARDS = WrongStep(
    "backwards",
    {"forwards": -1.0},
    Text(
        en="The sign of forwards is wrong. The pose of now lies farther ahead, so the old sight lands farther ahead, too.",
        ko="앞뒤 부호가 반대입니다. 지금의 포즈가 더 앞에 있으므로 옛 관측도 더 앞에 놓입니다.",
    ),
    part="forwards_m",
)

SPEED_TIMES_RANGE = WrongStep(
    "speed times range",
    {"way": "times range"},
    Text(
        en="Forwards you multiplied by the range as well. The robot drives speed times delay, however far it sees.",
        ko="앞 방향에도 거리를 곱했습니다. 로봇은 얼마나 멀리 보든 속도 곱하기 지연만큼 달립니다.",
    ),
    part="forwards_m",
)


TO_DEGREES = WrongStep(
    "to degrees",
    {"angle": "to degrees"},
    Text(
        en="The degrees were multiplied by 180/π, as `math.degrees` does, and that turns radians into degrees. An arc is radius times *radians*.",
        ko="`math.degrees`처럼 도에 180/π를 곱했습니다. 그것은 라디안을 도로 바꾸는 계산입니다. 호의 길이는 반지름 곱하기 *라디안*입니다.",
    ),
    "M5",
    part="left_m",
)


SPEED_FOR_THE_RANGE = WrongStep(
    "speed for the range",
    {"arc": "speed"},
    Text(
        en="To the left you have yaw rate, delay and speed: the speed stands where the range belongs. What swings is the ray, as long as the range.",
        ko="왼쪽 오차에 yaw 속도와 지연과 주행 속도를 곱했습니다. 거리가 올 자리에 속도가 왔습니다. 흔들리는 것은 물체까지의 거리만큼 긴 시선입니다.",
    ),
    part="left_m",
)


SPEED_TIMES_RANGE_TO_THE_LEFT = WrongStep(
    "speed times range to the left",
    {"arc": "speed times range"},
    Text(
        en="To the left you have speed, time and range. It is the *turn* that swings the ray: yaw rate, time and range.",
        ko="왼쪽 오차에 속도와 시간과 거리를 곱했습니다. 시선을 흔드는 것은 *회전*입니다. yaw 속도와 시간과 거리입니다.",
    ),
    part="left_m",
)


ONE_MINUS_COSINE = WrongStep(
    "one minus cosine",
    {"arc": "one minus cosine"},
    Text(
        en="That is how much less far ahead the ray's end is, 1 minus the cosine. To the left it is the arc: range times angle.",
        ko="시선 끝이 앞으로 덜 나간 만큼(1 - cos)입니다. 왼쪽은 호의 길이, 거리 곱하기 각도입니다.",
    ),
    part="left_m",
)


SINE_OF_DEGREES = WrongStep(
    "sine of degrees",
    {"arc": "sine of degrees"},
    Text(
        en="To the left you have the range times the sine of an angle in degrees. `math.sin` takes radians, and the product of the page is range × angle.",
        ko="왼쪽 오차가 거리에 도 단위 각도의 sin을 곱한 값입니다. `math.sin`은 라디안을 받고, 본문의 곱은 거리 × 각도입니다.",
    ),
    "M5",
    part="left_m",
)


RANGE_MINUS_THE_WAY = WrongStep(
    "range minus the way",
    {"way": "range minus"},
    Text(
        en="Forwards you have the distance that is left. Asked for is the error: the way driven meanwhile.",
        ko="앞쪽에 남은 거리를 썼습니다. 오차, 곧 그동안 달린 거리가 필요합니다.",
    ),
    part="forwards_m",
)


RANGE_PLUS_THE_WAY = WrongStep(
    "range plus the way",
    {"way": "range plus"},
    Text(
        en="Forwards you added the range. Asked for is how far off the answer is, and not where the object lies.",
        ko="앞쪽에 거리를 더했습니다. 물체가 있는 곳이 아니라 답이 얼마나 빗나가는지가 필요합니다.",
    ),
    part="forwards_m",
)


WAY_FOR_THE_RANGE = WrongStep(
    "way for the range",
    {"arc": "the way"},
    Text(
        en="To the left you multiplied the angle by the way driven. What swings is the ray, as long as the range.",
        ko="왼쪽 오차에서 각도에 달린 거리를 곱했습니다. 흔들리는 것은 물체까지의 거리만큼 긴 시선입니다.",
    ),
    part="left_m",
)


NO_DELAY_IN_THE_ARC = WrongStep(
    "no delay in the arc",
    {"arc": "no delay"},
    Text(
        en="To the left the delay is missing: range × yaw rate is what a whole second swings.",
        ko="왼쪽 오차에 지연이 빠졌습니다. 거리 × 각속도는 1초 내내 흔들린 만큼입니다.",
    ),
    part="left_m",
)


TOGETHER_MEAN = WrongStep(
    "together: mean",
    {"together": "mean"},
    Text(
        en="You took the mean of the two. They stand at right angles: their length together is the hypotenuse.",
        ko="둘의 평균을 구했습니다. 둘은 직각이므로 함께한 길이는 빗변입니다.",
    ),
    part="together_m",
)


TOGETHER_SIZES_TAKEN_OFF = WrongStep(
    "together: sizes taken off",
    {"together": "sizes taken off"},
    Text(
        en="That is the one length less the other; a sum of two numbers with different signs comes to the same. They stand at right angles: take the hypotenuse.",
        ko="한 길이에서 다른 길이를 뺀 값입니다. 부호가 다른 두 수를 더해도 이렇게 됩니다. 둘은 직각이므로 빗변을 구하십시오.",
    ),
    part="together_m",
)


TOGETHER_FORWARDS = WrongStep(
    "together: forwards",
    {"together": "forwards"},
    Text(
        en="Together it is longer than forwards alone: the way to the left counts as well.",
        ko="함께한 길이는 앞쪽만보다 깁니다. 왼쪽도 셉니다.",
    ),
    part="together_m",
)


TOGETHER_LEFT = WrongStep(
    "together: left",
    {"together": "left"},
    Text(
        en="Together it is longer than to the left alone: the way forwards counts as well.",
        ko="함께한 길이는 왼쪽만보다 깁니다. 앞쪽도 셉니다.",
    ),
    part="together_m",
)


TOGETHER_SQUARES = WrongStep(
    "together: squares",
    {"together": "squares"},
    Text(
        en="You added the squares and left out the root.",
        ko="제곱을 더하고 제곱근을 빠뜨렸습니다.",
    ),
    part="together_m",
)


MICROSECONDS = WrongStep(
    "microseconds",
    {"delay": 1e-6},
    Text(
        en="Everything is a thousand times too small: the milliseconds were divided by a million, as microseconds are, or kilometres come out.",
        ko="모든 값이 1000분의 1입니다. 밀리초를 마이크로초처럼 100만으로 나누었거나, 답이 킬로미터 단위입니다.",
    ),
)


TWICE_THE_DELAY = WrongStep(
    "twice the delay",
    {"delay": 2e-3},
    Text(
        en="Everything is twice as much: the delay went in twice, or a 2 that nothing here needs. While it lasts the robot drives and turns once.",
        ko="모두 두 배입니다. 지연이 두 번 들어갔거나, 필요 없는 2를 곱했습니다. 로봇은 지연되는 동안 한 번 달리고 돕니다.",
    ),
)


HALF_THE_DELAY = WrongStep(
    "half the delay",
    {"delay": 5e-4},
    Text(
        en="Everything is half as much: half the delay went in, or a mean of then and now. The error is that of the whole delay, at its end.",
        ko="모두 절반입니다. 지연의 절반만 넣었거나, 그때와 지금의 평균을 썼습니다. 오차는 지연이 다 지난 뒤의 것입니다.",
    ),
)


TIMES_A_THOUSAND = WrongStep(
    "times a thousand",
    {"delay": 1e3},
    Text(
        en="You multiplied the milliseconds by a thousand: a second has a thousand of them, so they are divided.",
        ko="밀리초에 1000을 곱했습니다. 1초가 1000밀리초이므로 1000으로 나누어야 합니다.",
    ),
)


SIXTIETHS = WrongStep(
    "sixtieths",
    {"delay": 1.0 / 60.0},
    Text(
        en="You divided the milliseconds by 60. A thousand of them make a second.",
        ko="밀리초를 60으로 나누었습니다. 1초는 1000밀리초입니다.",
    ),
)


NO_DELAY = WrongStep(
    "no delay",
    {"delay": 0.0},
    Text(
        en="The delay is missing: that is how far off it would be after a whole second.",
        ko="지연이 빠졌습니다. 꼬박 1초가 지났을 때의 오차입니다.",
    ),
)


NO_DELAY_FORWARDS = WrongStep(
    "no delay forwards",
    {"way": "no delay"},
    Text(
        en="Forwards the delay is missing: the speed alone is what the robot drives in a whole second.",
        ko="앞쪽에 지연이 빠졌습니다. 속력만으로는 꼬박 1초 동안 가는 거리입니다.",
    ),
    part="forwards_m",
)


TURNS = WrongStep(
    "turns",
    {"angle": "turns"},
    Text(
        en="The degrees were divided by 360: that makes turns, and an arc is radius times *radians*.",
        ko="도를 360으로 나누었습니다. 그러면 바퀴 수가 됩니다. 호의 길이는 반지름 곱하기 *라디안*입니다.",
    ),
    "M5",
    part="left_m",
)


TWO_PI_OVER_180 = WrongStep(
    "two pi over 180",
    {"angle": "twice"},
    Text(
        en="To the left it is twice too much: half a turn, 180°, is π radians, and 2π belongs to 360°.",
        ko="왼쪽이 두 배입니다. 180°가 π 라디안이고, 2π는 360°입니다.",
    ),
    "M5",
    part="left_m",
)


RANGE_LEFT_OVER = WrongStep(
    "range left over",
    {"arc": "range left over"},
    Text(
        en="To the left you took the range less the way driven. The product of the page takes the range as it was measured.",
        ko="왼쪽에 `range_m`에서 간 거리를 뺀 값을 썼습니다. 본문의 곱에는 잰 거리를 그대로 씁니다.",
    ),
    part="left_m",
)


TOGETHER_RMS = WrongStep(
    "together: root of the mean",
    {"together": "rms"},
    Text(
        en="That is the root of the *mean* of the squares. The hypotenuse is the root of their sum.",
        ko="제곱의 *평균*에 제곱근을 씌웠습니다. 빗변은 제곱의 합에 제곱근을 씌운 것입니다.",
    ),
    part="together_m",
)


TOGETHER_DIRECTION = WrongStep(
    "together: direction",
    {"together": "direction"},
    Text(
        en="That is an angle, as `math.atan2` gives it: to which side the error points. Asked for is its length.",
        ko="`math.atan2`가 주는 각도, 곧 오차가 향하는 방향입니다. 필요한 것은 길이입니다.",
    ),
    part="together_m",
)


TASK = Task(
    id="E8.4",
    kind="N",
    points=3,
    title=Text(en="How far off?", ko="얼마나 빗나갑니까?"),
    answer="late_error",
    form=Parts(
        {name: Number(unit="m", tolerance=0.003) for name in ("forwards_m", "left_m", "together_m")},
    ),
    given=motion,
    variants=6,
    model=late,
    mistakes=(
        SPEED_ONLY,
        DEGREES,
        WRONG_SIDE,
        ADDED,
        MILLISECONDS,
        HUNDREDTHS,
        WITHOUT_THE_RANGE,
        CROSSWISE,
        ROTATION_ONLY,
        BACKWARDS,
        SPEED_TIMES_RANGE,
        TO_DEGREES,
        SPEED_FOR_THE_RANGE,
        SPEED_TIMES_RANGE_TO_THE_LEFT,
        ONE_MINUS_COSINE,
        SINE_OF_DEGREES,
        RANGE_MINUS_THE_WAY,
        RANGE_PLUS_THE_WAY,
        WAY_FOR_THE_RANGE,
        NO_DELAY_IN_THE_ARC,
        TOGETHER_MEAN,
        TOGETHER_SIZES_TAKEN_OFF,
        TOGETHER_FORWARDS,
        TOGETHER_LEFT,
        TOGETHER_SQUARES,
        MICROSECONDS,
        SIXTIETHS,
        TWICE_THE_DELAY,
        HALF_THE_DELAY,
        TIMES_A_THOUSAND,
        NO_DELAY,
        NO_DELAY_FORWARDS,
        TURNS,
        TWO_PI_OVER_180,
        RANGE_LEFT_OVER,
        TOGETHER_RMS,
        TOGETHER_DIRECTION,
    ),
    hints=(
        Text(
            en="First bring everything to seconds, metres and radians.",
            ko="먼저 모두 초, m, rad로 바꾸십시오.",
        ),
        Text(
            en="Forwards comes from driving, left from turning. Positive yaw turns to the left.",
            ko="앞뒤는 주행에서, 좌우는 회전에서 옵니다. 양의 yaw는 왼쪽으로 도는 것입니다.",
        ),
        Text(
            en="speed × delay, range × yaw rate × delay, and `math.hypot` of the two.",
            ko="속도 × 지연, 거리 × 각속도 × 지연, 그리고 둘의 `math.hypot`입니다.",
        ),
    ),
    misconceptions=("M9", "M5"),
)
