"""E8.2: Between two samples."""

from __future__ import annotations

import math

from tflab.core import ExtrapolationException
from tflab.workbook.tasks import Angle, Parts, Task, Text, Vector, WrongAnswer, WrongStep


def two_samples(rng):
    """Turns to the left, to the right, both across the back; a moment at each sample, and one outside on either side."""
    rows = []
    for way, share in (
        (1, 0.25),
        (-1, 0.7),
        (0, 0.35),
        (0, 0.85),
        (0, 0.0),
        (0, 1.0),
        (1, -0.3),
        (-1, 1.4),
        (0, -0.001),
        (0, 1.001),
        (2, 0.4),  # more than a quarter turn, to either side
        (-2, 0.3),
    ):
        t0, gap = float(rng.uniform(1.0, 9.0)), float(rng.uniform(0.2, 1.0))
        x0, y0, x1, y1 = rng.uniform(-3.0, 3.0, 4).tolist()
        size = float(rng.uniform(0.4, 1.2))
        across = way * (math.pi - float(rng.uniform(0.3, 0.7)) * size)  # where yaw leaps from pi to -pi
        yaw0 = across if abs(way) == 1 else float(rng.uniform(-1.5, 0.2))
        size = size if abs(way) < 2 else float(rng.uniform(1.8, 2.6)) * way / 2
        yaw0 = -math.copysign(float(rng.uniform(0.2, 0.4)), size) if abs(way) == 2 else yaw0
        yaw1 = math.remainder(yaw0 + (size if abs(way) == 2 else (way or 1) * size), math.tau)
        rows.append((t0 + share * gap, (t0, x0, y0, yaw0), (t0 + gap, x1, y1, yaw1)))
    return rows


ORDERS = {"yaw before y": (0, 1, 3, 2), "yaw before x": (0, 2, 3, 1)}  # in which x, y and yaw stand in what was read


def between(
    stamp_s, before, after, *, early="refused", late="refused", ratio="from the first", position="line", turn="short"
) -> dict:
    """Return what the buffer does, step by step; other steps are the slips."""
    if turn in ORDERS:
        before, after = ([row[place] for place in ORDERS[turn]] for row in (before, after))
    (t0, x0, y0, yaw0), (t1, x1, y1, yaw1) = before, after
    outside = early if 2 * stamp_s < t0 + t1 else late
    if not _is_answered(stamp_s, t0, t1, outside):
        if outside == "None":
            return None
        raise ExtrapolationException("outside")
    at = _share(min(max(stamp_s, t0), t1) if outside == "clamped" else stamp_s, t0, t1, ratio)
    short = math.remainder(yaw1 - yaw0, math.tau)
    return {
        "position": _place(at, (x0, y0), (x1, y1), position, yaw0, short if position == "arc" else 0.0),
        "yaw": {
            "the way": math.atan2(y1 - y0, x1 - x0),
            "of y": y0 + at * math.remainder(y1 - y0, math.tau),
        }.get(turn, _yaw(at, yaw0, yaw1, turn)),
    }


def _is_answered(stamp_s, t0, t1, outside):
    inside = t0 < stamp_s < t1 if outside == "samples, too" else t0 <= stamp_s <= t1
    if outside == "the inside":
        return not inside
    near = abs(stamp_s - (t0 + t1) / 2) <= 0.6 * (t1 - t0)  # a tenth of the gap beyond either sample
    return inside or outside in ("guessed", "clamped") or (outside == "a little" and near)


def _share(asked, t0, t1, ratio):
    """Return how far along the answer is taken from."""
    share = (asked - t0) / (t1 - t0)
    return {
        "from the first": share,
        "from the second": 1.0 - share,
        "back from the second": share - 1.0,
        "away": -share,
        "half": 0.5,
        "all": 1.0,
        "whole": math.floor(share),
        "nearest": 0.0 if share <= 0.5 else 1.0,
        "seconds": asked - t0,
        "of the stamp": asked / t1,
        "of the gap": asked / (t1 - t0),
        "by the second stamp": (asked - t0) / t1,
        "no brackets": asked - t0 / (t1 - t0),
        "squared": share**2,
        "root": math.sqrt(max(share, 0.0)),
        "smooth": share**2 * (3.0 - 2.0 * share),
        "cosine": (1.0 - math.cos(math.pi * share)) / 2.0,
        "per cent": 100.0 * share,
    }.get(ratio, 0.0)


def _place(at, first, second, position, yaw0, turn):
    """Return the position; `turn` is how far the heading has turned at the end."""
    steps = [b - a for a, b in zip(first, second, strict=True)]
    if position in ("arc", "heading first"):
        way, heading = at * math.hypot(*steps), yaw0 + at * turn
        return (first[0] + way * math.cos(heading), first[1] + way * math.sin(heading))
    part = {"kept": 0.0, "later": 1.0, "half": 0.5, "from the other end": 1.0 - at}.get(position, at)
    steps = [abs(step) for step in steps] if position == "upwards" else steps
    steps = second if position in ("second added", "share of the second") else steps
    x0, y0 = {"from zero": (0.0, 0.0), "share of the second": (0.0, 0.0), "on from the second": second}.get(
        position, first
    )
    x = x0 + part * steps[0]
    ys = {
        "x alone": y0,
        "x twice": x,
        "y by x": y0 + part * steps[0],
        "y from the other end": y0 + (1.0 - part) * steps[1],
        "y from x": x0 + part * steps[1],
        "y to x": y0 + part * (second[0] - y0),
        "y less x": y0 + part * (second[1] - x0),
    }
    xs = {
        "x from y": y0 + part * steps[0],
        "x to y": x0 + part * (second[1] - x0),
        "x less y": x0 + part * (second[0] - y0),
        "x by y": x0 + part * steps[1],
    }
    x = xs.get(position, x)
    return (x, ys.get(position, y0 + part * steps[1]))


def _yaw(at, yaw0, yaw1, turn):
    difference, short = yaw1 - yaw0, math.remainder(yaw1 - yaw0, math.tau)
    turns = {
        "short": short,
        "the way": short,
        "of y": short,
        "difference": difference,
        "kept": 0.0,
        "modulo pi": math.remainder(difference, math.pi),
        "to the left": difference % math.tau,
        "size": abs(short),
        "away": -short,
        "left over of pi": math.fmod(difference, math.pi),
        "above alone": difference - math.tau if difference > math.pi else difference,
        "below alone": difference + math.tau if difference < -math.pi else difference,
        "second added": yaw1,
        "too far": difference + math.copysign(math.tau, difference) if abs(difference) > math.pi else difference,
        "left of pi": difference % math.pi,
        "each by itself": yaw1 % math.tau - yaw0 % math.tau,
        "the smallest": min(difference, difference + math.tau, difference - math.tau),
        "asin": math.asin(math.sin(difference)),
        "exchanged": math.atan2(math.cos(difference), math.sin(difference)),
        "half a turn on": (difference + math.pi) % math.tau,
        "half a turn back": difference % math.tau - math.pi,
        "cut off": max(-math.pi, min(math.pi, difference)),
        "the other way": -difference if abs(difference) > math.pi else difference,
        "rest of the turn": math.tau - abs(difference) if abs(difference) > math.pi else difference,
        "half": short / 2,
        "in degrees": math.degrees(short),
    }
    sines, cosines = ((1 - at) * of(yaw0) + at * of(yaw1) for of in (math.sin, math.cos))
    yaws = {
        "from zero": at * short,
        "mean": (yaw0 + yaw1) / 2,
        "in the middle": yaw0 + short / 2,
        "from degrees": math.radians(yaw0) + at * math.radians(difference),
        "on from the second": yaw1 + at * short,
        "later": yaw1,
        "back from the later": yaw1 - at * short,
        "share of the later": at * yaw1,
        "arrows": math.atan2(sines, cosines),
    }
    return yaws[turn] if turn in yaws else yaw0 + at * turns.get(turn, short)


THE_LONG_WAY = WrongStep(
    "the long way",
    {"turn": "difference"},
    Text(
        en="Your yaw goes the long way round when it crosses ±π: between 170° and −170° your robot looks to the front, where the real one turned 20° at the back. It is the *difference* that has to be brought into −π to π, before the ratio. To bring the two yaws or the result there changes nothing, nor does `math.fmod` by 2π, nor 180 or 360: these are radians.",
        ko="±π를 넘을 때 yaw가 먼 길로 돌아갑니다. 170°와 −170° 사이에서 이 함수의 로봇은 정면을 보지만, 진짜 로봇은 뒤쪽에서 20°만 돌았습니다. 비율을 곱하기 전에 두 yaw의 *차이*를 −π에서 π 사이로 옮겨야 합니다. 두 yaw나 결과를 그 사이로 옮겨도, 2π에 대한 `math.fmod`를 써도 달라지지 않습니다. 단위가 라디안이므로 180이나 360도 소용이 없습니다.",
    ),
)


THE_NEAREST_SAMPLE = WrongStep(
    "the nearest sample",
    {"ratio": "nearest"},
    Text(
        en="You return the nearer of the two samples. The buffer goes along the line between them, so that a robot does not hop.",
        ko="두 표본 가운데 가까운 쪽을 반환합니다. 버퍼는 둘을 잇는 선 위로 갑니다. 그래야 로봇이 껑충 뛰지 않습니다.",
    ),
)


GUESSES_OUTSIDE = WrongStep(
    "guesses outside",
    {"early": "guessed", "late": "guessed"},
    Text(
        en="Outside the two samples your function goes on along the line. A buffer never guesses: raise `ExtrapolationException`.",
        ko="두 표본 바깥에서도 선을 따라 계속 갑니다. 버퍼는 결코 짐작하지 않습니다. `ExtrapolationException`을 일으키십시오.",
    ),
)


STOPS_AT_THE_ENDS = WrongStep(
    "stops at the ends",
    {"early": "clamped", "late": "clamped"},
    Text(
        en="Outside the two samples your function answers with the nearest end. That is a guess, too: raise `ExtrapolationException`.",
        ko="두 표본 바깥에서 가까운 끝의 값을 답합니다. 그것도 짐작입니다. `ExtrapolationException`을 일으키십시오.",
    ),
)


ALWAYS_THE_MIDDLE = WrongStep(
    "always the middle",
    {"ratio": "half"},
    Text(
        en="Wherever `stamp_s` lies, you answer with the middle of the two samples. How far along is it? Near the first sample the answer must be near the first.",
        ko="`stamp_s`가 어디에 있든 두 표본의 한가운데를 답합니다. 얼마나 간 곳입니까? 첫 표본 가까이에서는 답도 첫 표본에 가까워야 합니다.",
    ),
)


THE_EARLIER_SAMPLE = WrongStep(
    "the earlier sample",
    {"ratio": "none"},
    Text(
        en="You return the earlier sample as it is. The robot has moved since: go along the line to the second one, as far as `stamp_s` says.",
        ko="앞쪽 표본을 그대로 반환합니다. 그 뒤로 로봇은 움직였습니다. `stamp_s`가 말하는 만큼 둘째 표본 쪽으로 선을 따라가십시오.",
    ),
)


REFUSES_AT_A_SAMPLE = WrongStep(
    "refuses at a sample",
    {"early": "samples, too", "late": "samples, too"},
    Text(
        en="Exactly at a sample you refuse. There the buffer knows the answer best of all: only before the first and after the second is outside.",
        ko="표본의 시각을 그대로 물으면 거절합니다. 버퍼가 가장 잘 아는 순간입니다. 첫 표본 앞과 둘째 표본 뒤만 바깥입니다.",
    ),
)


COUNTED_FROM_THE_WRONG_END = WrongStep(
    "counted from the wrong end",
    {"ratio": "from the second"},
    Text(
        en="Your ratio is counted from the later sample: near the first sample you answer as if near the second.",
        ko="비율을 뒤쪽 표본에서 세었습니다. 첫 표본 가까이에서 둘째 표본 가까이에 있는 것처럼 답합니다.",
    ),
    partly=True,
)


NOTHING_OUTSIDE = WrongStep(
    "nothing outside",
    {"early": "None", "late": "None"},
    Text(
        en="Outside the two samples you return None, and whoever calls you learns nothing. Refuse as the buffer does: raise `ExtrapolationException`.",
        ko="두 표본 바깥에서 None을 반환하므로 호출한 쪽은 아무것도 알지 못합니다. 버퍼처럼 거절하십시오. `ExtrapolationException`을 일으킵니다.",
    ),
    "M11",
)

A_LITTLE_OUTSIDE = WrongStep(
    "a little outside",
    {"early": "a little", "late": "a little"},
    Text(
        en="A little beyond the samples your function still answers. A buffer refuses even a hair outside: only from the first stamp to the second is there an answer.",
        ko="표본을 조금 벗어나도 답합니다. 버퍼는 머리카락만큼만 벗어나도 거절합니다. 첫 측정 시각부터 둘째 측정 시각까지만 답이 있습니다.",
    ),
)

GUESSES_BEFORE = WrongStep(
    "guesses before",
    {"early": "guessed"},
    Text(
        en="Before the first sample your function goes on along the line, backwards. A buffer refuses a time that is too early as it refuses one that is too late: raise `ExtrapolationException`.",
        ko="첫 표본보다 이른 시각에서는 선을 거꾸로 이어서 답합니다. 버퍼는 너무 늦은 시각처럼 너무 이른 시각도 거절합니다. `ExtrapolationException`을 일으키십시오.",
    ),
)

GUESSES_AFTER = WrongStep(
    "guesses after",
    {"late": "guessed"},
    Text(
        en="After the second sample your function goes on along the line. A buffer refuses a time that is too late as it refuses one that is too early: raise `ExtrapolationException`.",
        ko="둘째 표본보다 늦은 시각에서는 선을 이어서 답합니다. 버퍼는 너무 이른 시각처럼 너무 늦은 시각도 거절합니다. `ExtrapolationException`을 일으키십시오.",
    ),
)

STOPS_AT_THE_FIRST = WrongStep(
    "stops at the first",
    {"early": "clamped"},
    Text(
        en="Before the first sample your function answers with the first. That is a guess: raise `ExtrapolationException`.",
        ko="첫 표본보다 이른 시각에는 첫 표본의 값을 답합니다. 그것은 짐작입니다. `ExtrapolationException`을 일으키십시오.",
    ),
)

STOPS_AT_THE_SECOND = WrongStep(
    "stops at the second",
    {"late": "clamped"},
    Text(
        en="After the second sample your function answers with the second. That is a guess: raise `ExtrapolationException`.",
        ko="둘째 표본보다 늦은 시각에는 둘째 표본의 값을 답합니다. 그것은 짐작입니다. `ExtrapolationException`을 일으키십시오.",
    ),
)

REFUSES_AT_THE_FIRST = WrongStep(
    "refuses at the first",
    {"early": "samples, too"},
    Text(
        en="Exactly at the first sample you refuse. There the buffer knows the answer best of all: outside begins before it.",
        ko="첫 표본의 시각을 그대로 물으면 거절합니다. 버퍼가 가장 잘 아는 순간입니다. 그보다 이른 시각부터가 바깥입니다.",
    ),
)

REFUSES_AT_THE_SECOND = WrongStep(
    "refuses at the second",
    {"late": "samples, too"},
    Text(
        en="Exactly at the second sample you refuse. There the buffer knows the answer best of all: outside begins after it.",
        ko="둘째 표본의 시각을 그대로 물으면 거절합니다. 버퍼가 가장 잘 아는 순간입니다. 그보다 늦은 시각부터가 바깥입니다.",
    ),
)

REFUSES_INSIDE = WrongAnswer(
    "refuses inside",
    lambda *given: between(*given, early="the inside", late="the inside"),
    Text(
        en="You refuse between the two samples, and answer outside of them. The condition is the other way round.",
        ko="두 표본 사이에서 거절하고 바깥에서 답합니다. 조건이 거꾸로입니다.",
    ),
)

LONG_WAY_FROM_BELOW = WrongStep(
    "long way from below",
    {"turn": "above alone"},
    Text(
        en="Where yaw1 − yaw0 lies below −π, your yaw goes the long way round: a whole turn has to be added there.",
        ko="yaw1 − yaw0이 −π보다 작은 곳에서 yaw가 먼 길로 돌아갑니다. 거기서는 한 바퀴를 더해야 합니다.",
    ),
)

LONG_WAY_FROM_ABOVE = WrongStep(
    "long way from above",
    {"turn": "below alone"},
    Text(
        en="Where yaw1 − yaw0 lies above π, your yaw goes the long way round: a whole turn has to be taken off there.",
        ko="yaw1 − yaw0이 π보다 큰 곳에서 yaw가 먼 길로 돌아갑니다. 거기서는 한 바퀴를 빼야 합니다.",
    ),
)

YAW_AWAY = WrongStep(
    "yaw away",
    {"turn": "away"},
    Text(
        en="Your yaw turns away from the second sample's. The turn is the second yaw minus the first.",
        ko="yaw가 둘째 표본의 반대쪽으로 돕니다. 회전은 둘째 yaw에서 첫째를 뺀 것입니다.",
    ),
)

SECOND_YAW_ADDED = WrongStep(
    "second yaw added",
    {"turn": "second added"},
    Text(
        en="To the first yaw you add a share of the second yaw itself. What is added is a share of the turn between the two.",
        ko="첫째 yaw에 둘째 yaw 자체를 비율만큼 더합니다. 더할 것은 둘 사이의 회전에 비율을 곱한 값입니다.",
    ),
)

SECOND_POSITION_ADDED = WrongStep(
    "second position added",
    {"position": "second added"},
    Text(
        en="To the first position you add a share of the second position itself. What is added is a share of the way between the two.",
        ko="첫째 위치에 둘째 위치 자체를 비율만큼 더합니다. 더할 것은 둘의 차이에 비율을 곱한 값입니다.",
    ),
)

SHARE_OF_THE_LATER_POSITION = WrongStep(
    "share of the later position",
    {"position": "share of the second"},
    Text(
        en="Your position is a share of the second position alone. The way goes from the first to the second: begin at the first.",
        ko="위치가 둘째 위치에 비율만 곱한 값입니다. 첫째에서 둘째까지 가는 길이므로 첫째에서 시작하십시오.",
    ),
)

YAW_KEPT = WrongStep(
    "yaw kept",
    {"turn": "kept"},
    Text(
        en="Your yaw stays that of the first sample: it turns on between the two, as the position moves on.",
        ko="yaw가 첫 표본의 값 그대로입니다. 위치가 움직이듯 yaw도 두 표본 사이에서 돌아갑니다.",
    ),
)

POSITION_KEPT = WrongStep(
    "position kept",
    {"position": "kept"},
    Text(
        en="Your position stays that of the first sample: it goes on along the straight line between the two.",
        ko="위치가 첫 표본의 값 그대로입니다. 두 표본을 잇는 직선을 따라 움직여야 합니다.",
    ),
)

ALONG_THE_HEADING = WrongStep(
    "along the turning heading",
    {"position": "arc"},
    Text(
        en="Your position goes the length of the way along the heading, as a robot drives that never slides. The buffer knows nothing of robots: it goes along the straight line between the two places, wherever the yaw points.",
        ko="두 곳 사이의 거리만큼 방향을 따라 갑니다. 미끄러지지 않는 로봇이라면 그렇게 달립니다. 버퍼는 로봇을 모릅니다. yaw가 어디를 향하든 두 위치를 잇는 직선 위로 갑니다.",
    ),
)


ALONG_THE_FIRST_HEADING = WrongStep(
    "along the first heading",
    {"position": "heading first"},
    Text(
        en="Your position goes along the heading of the first sample. The buffer does not drive: it goes along the straight line between the two places, wherever the yaw points.",
        ko="첫 표본의 방향을 따라 갑니다. 버퍼는 달리지 않습니다. yaw가 어디를 향하든 두 위치를 잇는 직선 위로 갑니다.",
    ),
)


LEFT_OVER_OF_PI = WrongStep(
    "what is left over of pi",
    {"turn": "left over of pi"},
    Text(
        en="A difference of more than half a turn is brought back by half a turn, π: that is another direction. Only a whole turn, 2π, changes none: take that off or add it, until the difference lies between −π and π. (`math.fmod` by π takes half a turn off, too.)",
        ko="반 바퀴가 넘는 차이에서 반 바퀴, 곧 π를 빼거나 더하면 다른 방향이 됩니다. 방향이 그대로인 것은 한 바퀴, 곧 2π를 더하거나 뺄 때뿐입니다. 그렇게 해서 −π와 π 사이로 만드십시오(π에 대한 `math.fmod`도 반 바퀴를 뺍니다).",
    ),
    "M5",
)

SECONDS_FOR_A_RATIO = WrongStep(
    "seconds for a ratio",
    {"ratio": "seconds"},
    Text(
        en="Your ratio is a number of seconds. Divide it by the time from the first sample to the second: between 0 and 1.",
        ko="비율이 초 단위의 시간입니다. 첫 표본에서 둘째 표본까지의 시간으로 나누면 0과 1 사이가 됩니다.",
    ),
    partly=True,
)

RATIO_OF_THE_STAMP = WrongStep(
    "ratio of the stamp",
    {"ratio": "of the stamp"},
    Text(
        en="Your ratio is counted from time zero. Count from the first sample, and divide by the time between the two.",
        ko="비율을 시각 0에서부터 셌습니다. 첫 표본에서부터 세고, 두 표본 사이의 시간으로 나누십시오.",
    ),
    partly=True,
)

STAMP_BY_THE_GAP = WrongAnswer(
    "stamp by the gap",
    lambda *given: between(*given, ratio="of the gap"),
    Text(
        en="Your ratio is `stamp_s` divided by the time between the two samples. Take the first sample's stamp off it before you divide: at the first sample the ratio is 0.",
        ko="`stamp_s`를 두 표본 사이의 시간으로 나눈 것이 비율이 되었습니다. 나누기 전에 첫 표본의 시각을 빼십시오. 첫 표본에서는 비율이 0입니다.",
    ),
)

BY_THE_SECOND_STAMP = WrongAnswer(
    "by the second stamp",
    lambda *given: between(*given, ratio="by the second stamp"),
    Text(
        en="Your ratio is divided by the second stamp itself. Divide by the time from the first sample to the second: at the second sample the ratio is 1.",
        ko="비율을 둘째 측정 시각 자체로 나누었습니다. 첫 표본에서 둘째 표본까지의 시간으로 나누십시오. 둘째 표본에서는 비율이 1입니다.",
    ),
)

POSITION_IN_THE_MIDDLE = WrongAnswer(
    "position in the middle",
    lambda *given: between(*given, position="half"),
    Text(
        en="Your position is the middle of the two, wherever `stamp_s` lies. It goes along the line with the ratio.",
        ko="`stamp_s`가 어디에 있든 위치가 두 표본의 한가운데입니다. 비율만큼 선을 따라가야 합니다.",
    ),
)

YAW_IN_THE_MIDDLE = WrongAnswer(
    "yaw in the middle",
    lambda *given: between(*given, turn="in the middle"),
    Text(
        en="Your yaw is the middle of the two, wherever `stamp_s` lies. It turns with the ratio.",
        ko="`stamp_s`가 어디에 있든 yaw가 두 표본의 한가운데입니다. 비율만큼 돌아가야 합니다.",
    ),
)

TURNED_TOO_FAR = WrongStep(
    "turned too far",
    {"turn": "too far"},
    Text(
        en="Where the difference of the yaws is more than half a turn, your yaw turns by a whole turn more than that, not less: the sign with which 2π is applied is the wrong one.",
        ko="두 yaw의 차이가 반 바퀴를 넘는 곳에서 yaw가 한 바퀴 덜 도는 것이 아니라 더 돕니다. 2π를 더하고 빼는 부호가 반대입니다.",
    ),
)

LEFT_OF_PI = WrongStep(
    "modulo half a turn, to the left",
    {"turn": "left of pi"},
    Text(
        en="The difference of your yaws lies between 0 and π, as `% π` makes it: half a turn less is another direction, and a turn to the right becomes one to the left. Wrap by 2π, into −π to π.",
        ko="`% π`를 한 것처럼 두 yaw의 차이가 0과 π 사이에 있습니다. 반 바퀴를 빼면 다른 방향이 되고, 오른쪽 회전이 왼쪽 회전으로 바뀝니다. 2π로 감아 −π와 π 사이로 만드십시오.",
    ),
)

A_WHOLE_RATIO = WrongAnswer(
    "a whole ratio",
    lambda *given: between(*given, ratio="whole"),
    Text(
        en="Your ratio is a whole number, 0 up to the second sample and 1 at it, as `//` or `int()` makes it. How far along `stamp_s` lies is a fraction: divide by `/`.",
        ko="비율이 정수입니다. `//`나 `int()`를 쓴 것처럼 둘째 표본 전까지는 0이고 거기서 1이 됩니다. `stamp_s`가 어디쯤인지는 0과 1 사이의 소수입니다. `/`로 나누십시오.",
    ),
)

AWAY_FROM_THE_SECOND = WrongStep(
    "away from the second",
    {"ratio": "away"},
    Text(
        en="You go from the first sample away from the second. The way between them is the second minus the first.",
        ko="첫 표본에서 둘째 표본의 반대쪽으로 갑니다. 둘 사이의 차이는 둘째에서 첫째를 뺀 것입니다.",
    ),
    partly=True,
)

POSITION_FROM_ZERO = WrongStep(
    "position from zero",
    {"position": "from zero"},
    Text(
        en="The position starts at the origin: add the first sample's to the part of the way.",
        ko="위치가 원점에서 시작합니다. 간 만큼에 첫 표본의 위치를 더하십시오.",
    ),
)

YAW_FROM_ZERO = WrongStep(
    "yaw from zero",
    {"turn": "from zero"},
    Text(
        en="The yaw starts at zero: add the first sample's to the part of the turn.",
        ko="yaw가 0에서 시작합니다. 돌아간 만큼에 첫 표본의 yaw를 더하십시오.",
    ),
)

X_ALONE = WrongStep(
    "x alone",
    {"position": "x alone"},
    Text(
        en="x moves on, and y stays at the first sample: both go along the line.",
        ko="x만 움직이고 y는 첫 표본에 머뭅니다. 둘 다 선을 따라갑니다.",
    ),
)

ALWAYS_UPWARDS = WrongStep(
    "always upwards",
    {"position": "upwards"},
    Text(
        en="x and y only ever grow: the sign of the differences is gone, as with abs(), so a robot that drives back is sent on.",
        ko="x와 y가 늘기만 합니다. abs()를 쓴 것처럼 차이의 부호가 없어져서, 되돌아가는 로봇도 앞으로 갑니다.",
    ),
)

MEAN_YAW = WrongStep(
    "mean yaw",
    {"turn": "mean"},
    Text(
        en="Your yaw is the mean of the two, wherever `stamp_s` lies. It turns with the ratio, and the short way round.",
        ko="yaw가 언제나 두 값의 평균입니다. 비율만큼, 짧은 쪽으로 돌아가야 합니다.",
    ),
)


THE_LATER_SAMPLE = WrongStep(
    "the later sample",
    {"ratio": "all"},
    Text(
        en="You return the later sample as it is. The robot is not there yet: go along the line as far as `stamp_s` says.",
        ko="나중 표본을 그대로 돌려줍니다. 로봇은 아직 거기까지 가지 않았습니다. `stamp_s`만큼만 선을 따라가십시오.",
    ),
)


BACK_FROM_THE_SECOND = WrongStep(
    "back from the second",
    {"ratio": "back from the second"},
    Text(
        en="Your share is counted back from the second sample, and then added to the first: it is below zero. Count it from the first.",
        ko="비율을 둘째 표본에서 거꾸로 세어 첫째에 더했으므로 0보다 작습니다. 첫째에서부터 세십시오.",
    ),
    partly=True,
)


YAW_OF_THE_LATER = WrongStep(
    "yaw of the later",
    {"turn": "later"},
    Text(
        en="The position is on its way, and the yaw has arrived already: it goes along with the same share.",
        ko="위치는 가는 중인데 yaw는 이미 도착했습니다. yaw도 같은 비율로 갑니다.",
    ),
)


POSITION_OF_THE_LATER = WrongStep(
    "position of the later",
    {"position": "later"},
    Text(
        en="The yaw is on its way, and the position has arrived already: it goes along with the same share.",
        ko="yaw는 가는 중인데 위치는 이미 도착했습니다. 위치도 같은 비율로 갑니다.",
    ),
)


SHARE_OF_THE_LATER_YAW = WrongStep(
    "share of the later yaw",
    {"turn": "share of the later"},
    Text(
        en="You took a share of the second yaw alone. The way goes from the first yaw to the second: begin at the first.",
        ko="둘째 yaw만 비율로 곱했습니다. 첫째 yaw에서 둘째까지 가는 길이므로 첫째에서 시작하십시오.",
    ),
)


MODULO_HALF_A_TURN = WrongStep(
    "modulo half a turn",
    {"turn": "modulo pi"},
    Text(
        en="You wrapped the turn at half a circle's width, so that it never exceeds a quarter turn. The shortest arc may be up to half a turn: wrap by 2π.",
        ko="회전을 π 간격으로 감아서 1/4 바퀴를 넘지 못합니다. 가장 짧은 호는 반 바퀴까지 됩니다. 2π로 감으십시오.",
    ),
)


ALWAYS_TO_THE_LEFT = WrongStep(
    "always to the left",
    {"turn": "to the left"},
    Text(
        en="Your yaw always turns to the left: the difference lies between 0 and 2π, as `% (2π)` makes it, and is never negative. To the right may be shorter.",
        ko="yaw가 언제나 왼쪽으로 돕니다. `% (2π)`를 한 것처럼 차이가 0과 2π 사이에 있어 음수가 되지 않습니다. 오른쪽이 더 짧을 수 있습니다.",
    ),
)


BETWEEN_TWO_ARROWS = WrongStep(
    "between two arrows",
    {"turn": "arrows"},
    Text(
        en="You went along the straight line between two arrows and took its direction: the ends and the middle fit, and in between the turn is too slow or too quick. The angle itself goes evenly.",
        ko="두 화살표 끝을 잇는 직선을 따라가며 방향을 구했습니다. 양 끝과 가운데는 맞지만 그 사이에서는 너무 느리거나 빠릅니다. 각도가 고르게 변해야 합니다.",
    ),
)


SIZE_OF_THE_TURN = WrongStep(
    "size of the turn",
    {"turn": "size"},
    Text(
        en="You took the size of the turn, without its sign: a robot that turns right turns left in your answer.",
        ko="회전의 부호를 떼고 크기만 썼습니다. 오른쪽으로 도는 로봇이 답에서는 왼쪽으로 돕니다.",
    ),
    part="yaw",
)


Y_OF_X = WrongStep(
    "y of x",
    {"position": "x twice"},
    Text(
        en="y is the same as x: it is computed of `x0` and `x1` throughout. Was the line of x copied?",
        ko="y가 x와 똑같습니다. 줄곧 `x0`과 `x1`로 계산했습니다. x의 줄을 복사한 것 아닙니까?",
    ),
)


Y_BY_X = WrongStep(
    "y by x",
    {"position": "y by x"},
    Text(
        en="y starts where it should, and goes on by the difference of x: it has one of its own, `y1 - y0`.",
        ko="y는 맞는 곳에서 출발하지만 x의 차이만큼 나아갑니다. y에는 y의 차이 `y1 - y0`이 있습니다.",
    ),
)


YAW_BEFORE_Y = WrongAnswer(
    "yaw before y",
    lambda *given: between(*given, turn="yaw before y"),
    Text(
        en="y and yaw are exchanged in both samples: where you read y there is yaw, and the other way round. A sample is `(stamp_s, x, y, yaw)`.",
        ko="두 표본에서 y와 yaw를 바꾸어 읽었습니다. y로 읽은 자리에 yaw가, yaw로 읽은 자리에 y가 있습니다. 표본은 `(stamp_s, x, y, yaw)`입니다.",
    ),
)


ALONG_THE_WAY = WrongStep(
    "yaw along the way",
    {"turn": "the way"},
    Text(
        en="Your yaw is the direction from the first place to the second. A robot may look another way than it goes: its yaw turns from the first sample's to the second's.",
        ko="yaw로 첫 위치에서 둘째 위치로 가는 방향을 답했습니다. 로봇은 가는 쪽과 다른 쪽을 볼 수 있습니다. yaw는 첫 표본의 yaw에서 둘째 표본의 yaw로 돌아갑니다.",
    ),
)


NO_BRACKETS = WrongAnswer(
    "no brackets",
    lambda *given: between(*given, ratio="no brackets"),
    Text(
        en="Your ratio is `stamp_s - t0 / (t1 - t0)`: only t0 is divided. The brackets around `stamp_s - t0` are missing.",
        ko="비율을 `stamp_s - t0 / (t1 - t0)`으로 계산해 t0만 나누었습니다. `stamp_s - t0`을 감싸는 괄호가 빠졌습니다.",
    ),
)


EACH_YAW_BY_ITSELF = WrongStep(
    "each yaw by itself",
    {"turn": "each by itself"},
    Text(
        en="Your yaw goes the long way round where one of the two lies left of straight ahead and the other right of it: each was brought into 0 to 2π by itself. It is their difference that has to be brought into −π to π.",
        ko="한 yaw는 0보다 작고 다른 yaw는 0보다 클 때 먼 쪽으로 돕니다. 두 각을 따로 0에서 2π 사이로 옮겼기 때문입니다. −π에서 π 사이로 옮겨야 하는 것은 두 각의 차입니다.",
    ),
)


SMALLEST_TURN = WrongStep(
    "the smallest turn",
    {"turn": "the smallest"},
    Text(
        en="Of the turns that differ by 2π you take the smallest number, and that is the most negative one. The shortest turn is the one with the smallest size: `key=abs`.",
        ko="2π씩 다른 회전 가운데 가장 작은 수를 골랐는데, 그것은 가장 큰 음수입니다. 가장 짧은 회전은 크기가 가장 작은 것입니다: `key=abs`.",
    ),
)


YAW_BACK_FROM_THE_LATER = WrongStep(
    "yaw back from the later",
    {"turn": "back from the later"},
    Text(
        en="Your yaw starts at the second sample and goes back with the ratio: at the first stamp it is the second yaw already. Start at the first one.",
        ko="yaw가 둘째 표본에서 출발해 비율만큼 되돌아옵니다. 첫 측정 시각에 벌써 둘째 yaw가 됩니다. 첫째에서 출발하십시오.",
    ),
)


Y_FROM_THE_OTHER_END = WrongStep(
    "y from the other end",
    {"position": "y from the other end"},
    Text(
        en="x goes from the first sample to the second, and y the other way round: near the first sample it is near the second one's. Both take the same ratio.",
        ko="x는 첫 표본에서 둘째로 가는데 y는 거꾸로입니다. 첫 표본 가까이에서 y는 둘째 표본에 가깝습니다. 둘에 같은 비율을 쓰십시오.",
    ),
)


YAW_OF_Y = WrongStep(
    "yaw of y",
    {"turn": "of y"},
    Text(
        en="Your yaw is computed of the two y. A sample is `(stamp_s, x, y, yaw)`: yaw is the last of the four.",
        ko="yaw를 두 y로 계산했습니다. 표본은 `(stamp_s, x, y, yaw)`이고 yaw는 넷 가운데 마지막입니다.",
    ),
)


POSITION_FROM_THE_OTHER_END = WrongAnswer(
    "position from the other end",
    lambda *given: between(*given, position="from the other end"),
    Text(
        en="Your position goes from the second sample to the first: near the first sample it is near the second. Its ratio is counted from the wrong end.",
        ko="위치가 둘째 표본에서 첫 표본으로 갑니다. 첫 표본 가까이에서 둘째 표본의 위치에 가깝습니다. 위치의 비율을 반대쪽 끝에서부터 셌습니다.",
    ),
)


RATIO_SQUARED = WrongStep(
    "ratio squared",
    {"ratio": "squared"},
    Text(
        en="Your ratio is squared, or multiplied by itself, as if the robot set off from rest. The buffer knows no acceleration: a third of the time is a third of the way.",
        ko="정지했다가 출발하는 것처럼 비율을 제곱했습니다(비율에 비율을 곱했습니다). 버퍼는 가속을 모릅니다. 시간이 3분의 1 지나면 3분의 1만큼 갑니다.",
    ),
    partly=True,
)


ROOT_OF_THE_RATIO = WrongAnswer(
    "root of the ratio",
    lambda *given: between(*given, ratio="root"),
    Text(
        en="You took the square root of the ratio. The buffer goes evenly: a third of the time is a third of the way.",
        ko="비율에 제곱근을 씌웠습니다. 버퍼에서는 고르게 갑니다. 시간이 3분의 1 지나면 3분의 1만큼 갑니다.",
    ),
    partly=True,
)


SMOOTHED_RATIOS = tuple(
    WrongAnswer(
        f"ratio smoothed: {ratio}",
        lambda *given, ratio=ratio: between(*given, ratio=ratio),
        Text(
            en="Your ratio begins slowly, is quick in the middle and ends slowly, as animations do it. The buffer goes evenly along the line: a third of the time is a third of the way.",
            ko="애니메이션에서처럼 비율이 천천히 시작해 가운데에서 빨라졌다가 천천히 끝납니다. 버퍼는 선을 따라 고르게 갑니다. 시간이 3분의 1 지나면 3분의 1만큼 갑니다.",
        )
        if ratio == "smooth"
        else Text(
            en="Your ratio follows a cosine, slow at both ends. The buffer goes evenly along the line: a third of the time is a third of the way.",
            ko="비율이 코사인을 따라 양 끝에서 느립니다. 버퍼는 선을 따라 고르게 갑니다. 시간이 3분의 1 지나면 3분의 1만큼 갑니다.",
        ),
        partly=True,
    )
    for ratio in ("smooth", "cosine")
)


RATIO_IN_PER_CENT = WrongAnswer(
    "ratio in per cent",
    lambda *given: between(*given, ratio="per cent"),
    Text(
        en="Your ratio is in per cent, up to 100. What a difference is multiplied by goes from 0 to 1.",
        ko="비율이 0에서 100까지인 백분율입니다. 차이에 곱하는 비율은 0에서 1까지입니다.",
    ),
    partly=True,
)


YAW_BEFORE_X = WrongAnswer(
    "yaw before x",
    lambda *given: between(*given, turn="yaw before x"),
    Text(
        en="You read yaw where x stands, x where y stands, and y where yaw stands. A sample is `(stamp_s, x, y, yaw)`: yaw comes last.",
        ko="x 자리의 값을 yaw로, y 자리의 값을 x로, yaw 자리의 값을 y로 읽었습니다. 표본은 `(stamp_s, x, y, yaw)`이고 yaw가 마지막입니다.",
    ),
)


ASIN_OF_THE_SINE = WrongStep(
    "asin of the sine",
    {"turn": "asin"},
    Text(
        en="Your turn is the arc sine of a sine: that never exceeds a quarter turn, and a larger one is folded back. `math.atan2` of sine *and* cosine keeps all of −π to π.",
        ko="사인의 역사인을 회전으로 썼습니다. 그 값은 4분의 1바퀴를 넘지 못하고, 더 큰 회전은 접혀서 작아집니다. 사인과 코사인을 *둘 다* 쓰는 `math.atan2`는 −π에서 π까지 모두 나타냅니다.",
    ),
)


ATAN2_EXCHANGED = WrongStep(
    "atan2 exchanged",
    {"turn": "exchanged"},
    Text(
        en="Your turn is a quarter turn minus the right one, as `math.atan2` gives it with its arguments exchanged: the sine comes first, and then the cosine.",
        ko="회전이 4분의 1바퀴에서 맞는 값을 뺀 것입니다. `math.atan2`의 두 인자를 바꾸면 이렇게 됩니다. 사인이 먼저이고 코사인이 다음입니다.",
    ),
)


HALF_A_TURN_ON = WrongStep(
    "half a turn on",
    {"turn": "half a turn on"},
    Text(
        en="Your difference lies between 0 and 2π, half a turn too far: π was added before `% (2π)`, and has to be taken off again after it.",
        ko="차이가 0에서 2π 사이에 있고 반 바퀴만큼 큽니다. `% (2π)` 앞에서 더한 π를 그다음에 다시 빼야 합니다.",
    ),
)


HALF_A_TURN_BACK = WrongStep(
    "half a turn back",
    {"turn": "half a turn back"},
    Text(
        en="π was taken off after `% (2π)`, and not added before it: your difference is half a turn off, and of two equal yaws it is −π.",
        ko="`% (2π)` 뒤에서 π를 뺐는데 앞에서 더하지 않았습니다. 차이가 반 바퀴 어긋나서, 두 yaw가 같으면 −π가 됩니다.",
    ),
)


CUT_OFF_AT_PI = WrongStep(
    "cut off at pi",
    {"turn": "cut off"},
    Text(
        en="A difference of more than half a turn is cut off at ±π. It is another turn then: take off or add a whole one, 2π, and the direction stays what it is.",
        ko="반 바퀴가 넘는 차이를 ±π에서 잘랐습니다. 그러면 다른 회전이 됩니다. 한 바퀴, 곧 2π를 빼거나 더해야 방향이 그대로입니다.",
    ),
)


TURNED_THE_OTHER_WAY = WrongStep(
    "turned the other way",
    {"turn": "the other way"},
    Text(
        en="Where the difference is more than half a turn you only change its sign: the robot turns the other way round, as far as before, and ends elsewhere. The other way round is shorter: 2π less.",
        ko="차이가 반 바퀴를 넘으면 부호만 바꿉니다. 반대쪽으로 똑같이 많이 돌아서 다른 방향에서 끝납니다. 반대쪽으로는 더 짧게, 2π에서 뺀 만큼 돕니다.",
    ),
)


REST_OF_THE_TURN = WrongStep(
    "rest of the turn",
    {"turn": "rest of the turn"},
    Text(
        en="Where the difference is more than half a turn you take what is left of a whole one, `2π - abs(...)`, and its sign is lost: from more than π the short way goes to the right.",
        ko="차이가 반 바퀴를 넘으면 한 바퀴에서 남은 만큼인 `2π - abs(...)`를 쓰므로 부호가 사라집니다. 차이가 π보다 크면 짧은 길은 오른쪽입니다.",
    ),
)


HALF_THE_TURN = WrongStep(
    "half the turn",
    {"turn": "half"},
    Text(
        en="Your yaw turns only half as far: at the second sample it is in the middle between the two. Half the angle belongs into a quaternion, and this is a yaw.",
        ko="yaw가 절반만 돕니다. 둘째 표본의 시각에 두 yaw의 가운데에 있습니다. 각의 절반을 쓰는 것은 쿼터니언이고, 이것은 yaw입니다.",
    ),
)


TURN_IN_DEGREES = WrongStep(
    "turn in degrees",
    {"turn": "in degrees"},
    Text(
        en="To the first yaw, in radians, you add a share of the turn in degrees. Wrap the difference by 2π, or turn it back into radians before you add.",
        ko="라디안인 첫째 yaw에 도 단위의 회전을 비율만큼 더합니다. 차이를 2π로 감거나, 더하기 전에 라디안으로 되돌리십시오.",
    ),
    "M5",
)


YAW_FROM_DEGREES = WrongStep(
    "yaw from degrees",
    {"turn": "from degrees"},
    Text(
        en="You turn the yaws into radians, and they are in radians already: `math.radians` makes them 57 times smaller.",
        ko="yaw를 라디안으로 바꾸었는데 이미 라디안입니다. `math.radians`를 쓰면 57분의 1로 작아집니다.",
    ),
    "M5",
)


YAW_ON_FROM_THE_SECOND = WrongStep(
    "yaw on from the second",
    {"turn": "on from the second"},
    Text(
        en="Your yaw starts at the second sample's and turns on from there. It starts at the first one's.",
        ko="yaw가 둘째 표본의 값에서 시작해 더 돌아갑니다. 첫 표본의 값에서 시작해야 합니다.",
    ),
)


POSITION_ON_FROM_THE_SECOND = WrongStep(
    "position on from the second",
    {"position": "on from the second"},
    Text(
        en="Your position starts at the second sample and goes on from there. It starts at the first one.",
        ko="위치가 둘째 표본에서 시작해 더 나아갑니다. 첫 표본에서 시작해야 합니다.",
    ),
)


OF_THE_OTHER_AXIS = tuple(
    WrongAnswer(
        name,
        lambda *given, name=name: between(*given, position=name),
        Text(
            en=f"In the line of {one} a number of {other} stands: it {en}. `{one}0` and `{one}1` alone belong there.",
            ko=f"{one}를 구하는 줄에 {other}의 값이 섞여 {ko}. 거기에는 `{one}0`과 `{one}1`만 써야 합니다.",
        ),
    )
    for one, other in ("yx", "xy")
    for name, en, ko in (
        (f"{one} from {other}", f"starts at `{other}0`", f"`{other}0`에서 출발합니다"),
        (f"{one} to {other}", f"goes towards `{other}1`", f"`{other}1` 쪽으로 갑니다"),
        (f"{one} less {other}", f"takes `{other}0` off `{one}1`", f"`{one}1`에서 `{other}0`을 뺍니다"),
    )
)


X_BY_Y = WrongStep(
    "x by y",
    {"position": "x by y"},
    Text(
        en="x starts where it should, and goes on by the difference of y: it has one of its own, `x1 - x0`.",
        ko="x는 맞는 곳에서 출발하지만 y의 차이만큼 나아갑니다. x에는 x의 차이 `x1 - x0`이 있습니다.",
    ),
)


TASK = Task(
    id="E8.2",
    kind="F",
    points=4,
    title=Text(en="Between two samples", ko="두 표본 사이"),
    answer="interpolate",
    form=Parts({"position": Vector(2, unit="m"), "yaw": Angle()}),
    inputs=two_samples,
    variants=4,
    model=between,
    mistakes=(
        LEFT_OVER_OF_PI,
        SIZE_OF_THE_TURN,
        THE_LONG_WAY,
        THE_NEAREST_SAMPLE,
        GUESSES_OUTSIDE,
        STOPS_AT_THE_ENDS,
        COUNTED_FROM_THE_WRONG_END,
        ALWAYS_THE_MIDDLE,
        THE_EARLIER_SAMPLE,
        REFUSES_AT_A_SAMPLE,
        NOTHING_OUTSIDE,
        A_LITTLE_OUTSIDE,
        YAW_KEPT,
        POSITION_KEPT,
        SECONDS_FOR_A_RATIO,
        RATIO_OF_THE_STAMP,
        POSITION_FROM_ZERO,
        YAW_FROM_ZERO,
        X_ALONE,
        ALONG_THE_HEADING,
        ALONG_THE_FIRST_HEADING,
        ALWAYS_UPWARDS,
        MEAN_YAW,
        THE_LATER_SAMPLE,
        BACK_FROM_THE_SECOND,
        YAW_OF_THE_LATER,
        POSITION_OF_THE_LATER,
        SHARE_OF_THE_LATER_YAW,
        MODULO_HALF_A_TURN,
        ALWAYS_TO_THE_LEFT,
        BETWEEN_TWO_ARROWS,
        GUESSES_BEFORE,
        GUESSES_AFTER,
        STOPS_AT_THE_FIRST,
        STOPS_AT_THE_SECOND,
        REFUSES_AT_THE_FIRST,
        REFUSES_AT_THE_SECOND,
        REFUSES_INSIDE,
        LONG_WAY_FROM_BELOW,
        LONG_WAY_FROM_ABOVE,
        STAMP_BY_THE_GAP,
        A_WHOLE_RATIO,
        BY_THE_SECOND_STAMP,
        POSITION_IN_THE_MIDDLE,
        YAW_IN_THE_MIDDLE,
        TURNED_TOO_FAR,
        LEFT_OF_PI,
        AWAY_FROM_THE_SECOND,
        YAW_AWAY,
        SECOND_YAW_ADDED,
        SECOND_POSITION_ADDED,
        SHARE_OF_THE_LATER_POSITION,
        Y_OF_X,
        Y_BY_X,
        YAW_BEFORE_Y,
        ALONG_THE_WAY,
        NO_BRACKETS,
        EACH_YAW_BY_ITSELF,
        SMALLEST_TURN,
        YAW_BACK_FROM_THE_LATER,
        Y_FROM_THE_OTHER_END,
        YAW_OF_Y,
        POSITION_FROM_THE_OTHER_END,
        RATIO_SQUARED,
        ROOT_OF_THE_RATIO,
        *SMOOTHED_RATIOS,
        RATIO_IN_PER_CENT,
        YAW_BEFORE_X,
        ASIN_OF_THE_SINE,
        ATAN2_EXCHANGED,
        HALF_A_TURN_ON,
        HALF_A_TURN_BACK,
        CUT_OFF_AT_PI,
        TURNED_THE_OTHER_WAY,
        REST_OF_THE_TURN,
        HALF_THE_TURN,
        TURN_IN_DEGREES,
        YAW_FROM_DEGREES,
        YAW_ON_FROM_THE_SECOND,
        POSITION_ON_FROM_THE_SECOND,
        *OF_THE_OTHER_AXIS,
        X_BY_Y,
    ),
    hints=(
        Text(
            en="First the refusal, then a ratio between 0 and 1: how far along from the first stamp to the second is `stamp_s`?",
            ko="먼저 거절, 다음에 0과 1 사이의 비율입니다. `stamp_s`는 첫 측정 시각에서 둘째 측정 시각까지의 어디쯤입니까?",
        ),
        Text(
            en="Position: start + ratio × difference. For yaw the difference must be brought into −π to π before it is scaled.",
            ko="위치는 시작 + 비율 × 차이입니다. yaw는 비율을 곱하기 전에 차이를 −π에서 π 사이로 가져와야 합니다.",
        ),
        Text(
            en="`math.remainder(yaw1 - yaw0, math.tau)` is the short way round. Then `yaw0 + ratio * turn`; a full turn more or less does not matter.",
            ko="`math.remainder(yaw1 - yaw0, math.tau)`가 짧은 쪽 회전입니다. 그다음 `yaw0 + ratio * turn`이며, 한 바퀴 차이는 상관없습니다.",
        ),
    ),
)
