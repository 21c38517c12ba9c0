"""E8.2: Between two samples."""

from __future__ import annotations

import math

from tflab.core import ExtrapolationException
from tflab.workbook.tasks import Angle, Parts, Slip, Task, Vector, Words


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


def between(
    stamp_s, before, after, *, outside="refused", ratio="from the first", position="line", turn="short"
) -> dict:
    """Return what the buffer does, step by step; other steps are the slips."""
    (t0, x0, y0, yaw0), (t1, x1, y1, yaw1) = before, after
    inside = t0 < stamp_s < t1 if outside == "samples, too" else t0 <= stamp_s <= t1
    near = abs(stamp_s - (t0 + t1) / 2) <= 0.6 * (t1 - t0)  # a tenth of the gap beyond either sample
    if not inside and not (outside == "guessed" or outside == "clamped" or (outside == "a little" and near)):
        if outside == "None":
            return None
        raise ExtrapolationException("outside")
    asked = min(max(stamp_s, t0), t1) if outside == "clamped" else stamp_s
    share = {"from the first": (asked - t0) / (t1 - t0), "from the second": (t1 - asked) / (t1 - t0), "half": 0.5, "all": 1.0,
             "back from the second": (asked - t1) / (t1 - t0),
             "seconds": asked - t0, "of the stamp": asked / t1}  # fmt: skip
    at = share.get(ratio, 0.0)
    if ratio == "nearest":
        at = 0.0 if share["from the first"] <= 0.5 else 1.0
    turns = {"short": math.remainder(yaw1 - yaw0, math.tau), "difference": yaw1 - yaw0, "kept": 0.0}
    turns |= {"modulo pi": math.remainder(yaw1 - yaw0, math.pi), "to the left": (yaw1 - yaw0) % math.tau}
    turns |= {"size": abs(turns["short"]), "left over of pi": math.fmod(yaw1 - yaw0, math.pi)}
    place = {"kept": 0.0, "later": 1.0}.get(position, at)
    steps = (abs(x1 - x0), abs(y1 - y0)) if position == "upwards" else (x1 - x0, y1 - y0)
    from_x, from_y = (0.0, 0.0) if position == "from zero" else (x0, y0)
    along = (from_x + place * steps[0], y0 if position == "x alone" else from_y + place * steps[1])
    if position in ("arc", "heading first"):
        way, heading = place * math.hypot(*steps), yaw0 + (at * turns["short"] if position == "arc" else 0.0)
        along = (x0 + way * math.cos(heading), y0 + way * math.sin(heading))
    yaws = {
        "from zero": at * turns["short"],
        "mean": (yaw0 + yaw1) / 2,
        "later": yaw1,
        "share of the later": at * yaw1,
        "arrows": math.atan2(
            (1 - at) * math.sin(yaw0) + at * math.sin(yaw1), (1 - at) * math.cos(yaw0) + at * math.cos(yaw1)
        ),
    }
    yaw = yaws[turn] if turn in yaws else yaw0 + at * turns[turn]
    return {"position": along, "yaw": yaw}


THE_LONG_WAY = Slip(
    "the long way",
    {"turn": "difference"},
    Words(
        en="Your yaw goes the long way round when it crosses ±π: between 170° and −170° your robot looks to the front, where the real one turned 20° at the back.",
        ko="±π를 넘을 때 yaw가 먼 길로 돌아갑니다. 170°와 −170° 사이에서 이 함수의 로봇은 정면을 보지만, 진짜 로봇은 뒤쪽에서 20°만 돌았습니다.",
    ),
)


THE_NEAREST_SAMPLE = Slip(
    "the nearest sample",
    {"ratio": "nearest"},
    Words(
        en="You return the nearer of the two samples. The buffer goes along the line between them, so that a robot does not hop.",
        ko="두 표본 가운데 가까운 쪽을 반환합니다. 버퍼는 둘을 잇는 선 위로 갑니다. 그래야 로봇이 껑충 뛰지 않습니다.",
    ),
)


GUESSES_OUTSIDE = Slip(
    "guesses outside",
    {"outside": "guessed"},
    Words(
        en="Outside the two samples your function goes on along the line. A buffer never guesses: raise `ExtrapolationException`.",
        ko="두 표본 바깥에서도 선을 따라 계속 갑니다. 버퍼는 결코 짐작하지 않습니다. `ExtrapolationException`을 일으키십시오.",
    ),
)


STOPS_AT_THE_ENDS = Slip(
    "stops at the ends",
    {"outside": "clamped"},
    Words(
        en="Outside the two samples your function answers with the nearest end. That is a guess, too: raise `ExtrapolationException`.",
        ko="두 표본 바깥에서 가까운 끝의 값을 답합니다. 그것도 짐작입니다. `ExtrapolationException`을 일으키십시오.",
    ),
)


ALWAYS_THE_MIDDLE = Slip(
    "always the middle",
    {"ratio": "half"},
    Words(
        en="Wherever `stamp_s` lies, you answer with the middle of the two samples. How far along is it? Near the first sample the answer must be near the first.",
        ko="`stamp_s`가 어디에 있든 두 표본의 한가운데를 답합니다. 얼마나 간 곳입니까? 첫 표본 가까이에서는 답도 첫 표본에 가까워야 합니다.",
    ),
)


THE_EARLIER_SAMPLE = Slip(
    "the earlier sample",
    {"ratio": "none"},
    Words(
        en="You return the earlier sample as it is. The robot has moved since: go along the line to the second one, as far as `stamp_s` says.",
        ko="앞쪽 표본을 그대로 반환합니다. 그 뒤로 로봇은 움직였습니다. `stamp_s`가 말하는 만큼 둘째 표본 쪽으로 선을 따라가십시오.",
    ),
)


REFUSES_AT_A_SAMPLE = Slip(
    "refuses at a sample",
    {"outside": "samples, too"},
    Words(
        en="Exactly at a sample you refuse. There the buffer knows the answer best of all: only before the first and after the second is outside.",
        ko="표본의 시각을 그대로 물으면 거절합니다. 버퍼가 가장 잘 아는 순간입니다. 첫 표본 앞과 둘째 표본 뒤만 바깥입니다.",
    ),
)


COUNTED_FROM_THE_WRONG_END = Slip(
    "counted from the wrong end",
    {"ratio": "from the second"},
    Words(
        en="Your ratio is counted from the later sample: near the first sample you answer as if near the second.",
        ko="비율을 뒤쪽 표본에서 세었습니다. 첫 표본 가까이에서 둘째 표본 가까이에 있는 것처럼 답합니다.",
    ),
)


NOTHING_OUTSIDE = Slip(
    "nothing outside",
    {"outside": "None"},
    Words(
        en="Outside the two samples you return None, and whoever calls you learns nothing. Refuse as the buffer does: raise `ExtrapolationException`.",
        ko="두 표본 바깥에서 None을 반환하므로 호출한 쪽은 아무것도 알지 못합니다. 버퍼처럼 거절하십시오. `ExtrapolationException`을 일으킵니다.",
    ),
    "M11",
)

A_LITTLE_OUTSIDE = Slip(
    "a little outside",
    {"outside": "a little"},
    Words(
        en="A little beyond the samples your function still answers. A buffer refuses even a hair outside: only from the first stamp to the second is there an answer.",
        ko="표본을 조금 벗어나도 답합니다. 버퍼는 머리카락만큼만 벗어나도 거절합니다. 첫 측정 시각부터 둘째 측정 시각까지만 답이 있습니다.",
    ),
)

YAW_KEPT = Slip(
    "yaw kept",
    {"turn": "kept"},
    Words(
        en="Your yaw stays that of the first sample: it turns on between the two, as the position moves on.",
        ko="yaw가 첫 표본의 값 그대로입니다. 위치가 움직이듯 yaw도 두 표본 사이에서 돌아갑니다.",
    ),
)

POSITION_KEPT = Slip(
    "position kept",
    {"position": "kept"},
    Words(
        en="Your position stays that of the first sample: it goes on along the straight line between the two.",
        ko="위치가 첫 표본의 값 그대로입니다. 두 표본을 잇는 직선을 따라 움직여야 합니다.",
    ),
)

ALONG_THE_HEADING = Slip(
    "along the turning heading",
    {"position": "arc"},
    Words(
        en="Your position goes the length of the way along the heading, as a robot drives that never slides. The buffer knows nothing of robots: it goes along the straight line between the two places, wherever the yaw points.",
        ko="두 곳 사이의 거리만큼 방향을 따라 갑니다. 미끄러지지 않는 로봇이라면 그렇게 달립니다. 버퍼는 로봇을 모릅니다. yaw가 어디를 향하든 두 위치를 잇는 직선 위로 갑니다.",
    ),
)


ALONG_THE_FIRST_HEADING = Slip(
    "along the first heading",
    {"position": "heading first"},
    Words(
        en="Your position goes along the heading of the first sample. The buffer does not drive: it goes along the straight line between the two places, wherever the yaw points.",
        ko="첫 표본의 방향을 따라 갑니다. 버퍼는 달리지 않습니다. yaw가 어디를 향하든 두 위치를 잇는 직선 위로 갑니다.",
    ),
)


LEFT_OVER_OF_PI = Slip(
    "what is left over of pi",
    {"turn": "left over of pi"},
    Words(
        en="A turn of more than half is cut down by a wrong amount: `math.fmod` by pi takes a half turn off and keeps the sign of what it divides. A difference of two yaws is wrapped by a whole turn, 2 pi, into -pi .. pi.",
        ko="반 바퀴가 넘는 차이를 엉뚱한 만큼 줄입니다. pi에 대한 `math.fmod`는 반 바퀴를 빼고 나뉘는 수의 부호를 그대로 둡니다. 두 yaw의 차이는 한 바퀴, 곧 2π를 더하거나 빼서 −π와 π 사이로 만듭니다.",
    ),
    "M5",
)

SECONDS_FOR_A_RATIO = Slip(
    "seconds for a ratio",
    {"ratio": "seconds"},
    Words(
        en="Your ratio is a number of seconds. Divide it by the time from the first sample to the second: between 0 and 1.",
        ko="비율이 초 단위의 시간입니다. 첫 표본에서 둘째 표본까지의 시간으로 나누면 0과 1 사이가 됩니다.",
    ),
)

RATIO_OF_THE_STAMP = Slip(
    "ratio of the stamp",
    {"ratio": "of the stamp"},
    Words(
        en="Your ratio is counted from time zero. Count from the first sample, and divide by the time between the two.",
        ko="비율을 시각 0에서부터 셌습니다. 첫 표본에서부터 세고, 두 표본 사이의 시간으로 나누십시오.",
    ),
)

POSITION_FROM_ZERO = Slip(
    "position from zero",
    {"position": "from zero"},
    Words(
        en="The position starts at the origin: add the first sample's to the part of the way.",
        ko="위치가 원점에서 시작합니다. 간 만큼에 첫 표본의 위치를 더하십시오.",
    ),
)

YAW_FROM_ZERO = Slip(
    "yaw from zero",
    {"turn": "from zero"},
    Words(
        en="The yaw starts at zero: add the first sample's to the part of the turn.",
        ko="yaw가 0에서 시작합니다. 돌아간 만큼에 첫 표본의 yaw를 더하십시오.",
    ),
)

X_ALONE = Slip(
    "x alone",
    {"position": "x alone"},
    Words(
        en="x moves on, and y stays at the first sample: both go along the line.",
        ko="x만 움직이고 y는 첫 표본에 머뭅니다. 둘 다 선을 따라갑니다.",
    ),
)

ALWAYS_UPWARDS = Slip(
    "always upwards",
    {"position": "upwards"},
    Words(
        en="abs() takes the sign of the difference away, and then x and y only ever grow.",
        ko="abs()가 차이의 부호를 없애서 x와 y가 늘기만 합니다.",
    ),
)

MEAN_YAW = Slip(
    "mean yaw",
    {"turn": "mean"},
    Words(
        en="Your yaw is the mean of the two, wherever `stamp_s` lies. It turns with the ratio, and the short way round.",
        ko="yaw가 언제나 두 값의 평균입니다. 비율만큼, 짧은 쪽으로 돌아가야 합니다.",
    ),
)


THE_LATER_SAMPLE = Slip(
    "the later sample",
    {"ratio": "all"},
    Words(
        en="You return the later sample as it is. The robot is not there yet: go along the line as far as `stamp_s` says.",
        ko="나중 표본을 그대로 돌려줍니다. 로봇은 아직 거기까지 가지 않았습니다. `stamp_s`만큼만 선을 따라가십시오.",
    ),
)


BACK_FROM_THE_SECOND = Slip(
    "back from the second",
    {"ratio": "back from the second"},
    Words(
        en="Your share is counted back from the second sample, and then added to the first: it is below zero. Count it from the first.",
        ko="비율을 둘째 표본에서 거꾸로 세어 첫째에 더했으므로 0보다 작습니다. 첫째에서부터 세십시오.",
    ),
)


YAW_OF_THE_LATER = Slip(
    "yaw of the later",
    {"turn": "later"},
    Words(
        en="The position is on its way, and the yaw has arrived already: it goes along with the same share.",
        ko="위치는 가는 중인데 yaw는 이미 도착했습니다. yaw도 같은 비율로 갑니다.",
    ),
)


POSITION_OF_THE_LATER = Slip(
    "position of the later",
    {"position": "later"},
    Words(
        en="The yaw is on its way, and the position has arrived already: it goes along with the same share.",
        ko="yaw는 가는 중인데 위치는 이미 도착했습니다. 위치도 같은 비율로 갑니다.",
    ),
)


SHARE_OF_THE_LATER_YAW = Slip(
    "share of the later yaw",
    {"turn": "share of the later"},
    Words(
        en="You took a share of the second yaw alone. The way goes from the first yaw to the second: begin at the first.",
        ko="둘째 yaw만 비율로 곱했습니다. 첫째 yaw에서 둘째까지 가는 길이므로 첫째에서 시작하십시오.",
    ),
)


MODULO_HALF_A_TURN = Slip(
    "modulo half a turn",
    {"turn": "modulo pi"},
    Words(
        en="You wrapped the turn at half a circle's width, so that it never exceeds a quarter turn. The shortest arc may be up to half a turn: wrap by 2π.",
        ko="회전을 π 간격으로 감아서 1/4 바퀴를 넘지 못합니다. 가장 짧은 호는 반 바퀴까지 됩니다. 2π로 감으십시오.",
    ),
)


ALWAYS_TO_THE_LEFT = Slip(
    "always to the left",
    {"turn": "to the left"},
    Words(
        en="You always turn to the left: `% (2π)` has no negative turns. To the right may be shorter.",
        ko="언제나 왼쪽으로 돕니다. `% (2π)`에는 음수가 없습니다. 오른쪽이 더 짧을 수 있습니다.",
    ),
)


BETWEEN_TWO_ARROWS = Slip(
    "between two arrows",
    {"turn": "arrows"},
    Words(
        en="You went along the straight line between two arrows and took its direction: the ends and the middle fit, and in between the turn is too slow or too quick. The angle itself goes evenly.",
        ko="두 화살표 끝을 잇는 직선을 따라가며 방향을 구했습니다. 양 끝과 가운데는 맞지만 그 사이에서는 너무 느리거나 빠릅니다. 각도가 고르게 변해야 합니다.",
    ),
)


SIZE_OF_THE_TURN = Slip(
    "size of the turn",
    {"turn": "size"},
    Words(
        en="you took the size of the turn, without its sign: a robot that turns right turns left in your answer.",
        ko="회전의 부호를 떼고 크기만 썼습니다. 오른쪽으로 도는 로봇이 답에서는 왼쪽으로 돕니다.",
    ),
    part="yaw",
)


TASK = Task(
    id="E8.2",
    kind="F",
    points=4,
    title=Words(en="Between two samples", ko="두 표본 사이"),
    answer="interpolate",
    form=Parts({"position": Vector(2, unit="m"), "yaw": Angle()}),
    inputs=two_samples,
    variants=4,
    model=between,
    twins=(
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
    ),
    hints=(
        Words(
            en="First the refusal, then a ratio between 0 and 1: how far along from the first stamp to the second is `stamp_s`?",
            ko="먼저 거절, 다음에 0과 1 사이의 비율입니다. `stamp_s`는 첫 측정 시각에서 둘째 측정 시각까지의 어디쯤입니까?",
        ),
        Words(
            en="Position: start + ratio × difference. For yaw the difference must be brought into −π to π before it is scaled.",
            ko="위치는 시작 + 비율 × 차이입니다. yaw는 비율을 곱하기 전에 차이를 −π에서 π 사이로 가져와야 합니다.",
        ),
        Words(
            en="`math.remainder(yaw1 - yaw0, math.tau)` is the short way round. Then `yaw0 + ratio * turn`; a full turn more or less does not matter.",
            ko="`math.remainder(yaw1 - yaw0, math.tau)`가 짧은 쪽 회전입니다. 그다음 `yaw0 + ratio * turn`이며, 한 바퀴 차이는 상관없습니다.",
        ),
    ),
)
