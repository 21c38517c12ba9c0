"""E8.2: Between two samples."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Angle, Parts, Task, Twin, Vector, Words


def two_samples(rng):
    """Turns to the left, to the right, both across the back; a moment at each sample, and one outside on either side."""
    rows = []
    for way, share in ((1, 0.25), (-1, 0.7), (0, 0.35), (0, 0.85), (0, 0.0), (0, 1.0), (1, -0.3), (-1, 1.4)):
        t0, gap = float(rng.uniform(1.0, 9.0)), float(rng.uniform(0.2, 1.0))
        x0, y0, x1, y1 = rng.uniform(-3.0, 3.0, 4).tolist()
        size = float(rng.uniform(0.4, 1.2))
        across = way * (math.pi - float(rng.uniform(0.3, 0.7)) * size)  # where yaw leaps from pi to -pi
        yaw0 = across if way else float(rng.uniform(-1.5, 0.2))
        yaw1 = math.remainder(yaw0 + (way or 1) * size, math.tau)
        rows.append((t0 + share * gap, (t0, x0, y0, yaw0), (t0 + gap, x1, y1, yaw1)))
    return rows


def _refuse(stamp_s, before, after):
    from tflab.core import ExtrapolationException

    if not before[0] <= stamp_s <= after[0]:
        raise ExtrapolationException("outside")


def _blend(stamp_s, before, after, turn):
    (t0, x0, y0, yaw0), (t1, x1, y1, _) = before, after
    ratio = (stamp_s - t0) / (t1 - t0)
    return {"position": (x0 + ratio * (x1 - x0), y0 + ratio * (y1 - y0)), "yaw": yaw0 + ratio * turn}


def _short(before, after):
    return math.remainder(after[3] - before[3], math.tau)


def long_way(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return _blend(stamp_s, before, after, after[3] - before[3])


THE_LONG_WAY = Twin(
    "the long way",
    long_way,
    Words(
        en="Your yaw goes the long way round when it crosses ±π: between 170° and −170° your robot looks to the front, where the real one turned 20° at the back.",
        ko="±π를 넘을 때 yaw가 먼 길로 돌아갑니다. 170°와 −170° 사이에서 여러분의 로봇은 앞을 보지만, 진짜 로봇은 뒤쪽에서 20°만 돌았습니다.",
    ),
)


def nearest(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    _, x, y, yaw = before if stamp_s - before[0] <= after[0] - stamp_s else after
    return {"position": (x, y), "yaw": yaw}


THE_NEAREST_SAMPLE = Twin(
    "the nearest sample",
    nearest,
    Words(
        en="You return the nearer of the two samples. The buffer goes along the line between them, so that a robot does not hop.",
        ko="두 표본 가운데 가까운 쪽을 반환합니다. 버퍼는 둘을 잇는 선 위로 갑니다. 그래야 로봇이 껑충 뛰지 않습니다.",
    ),
)


def guesses(stamp_s, before, after):
    return _blend(stamp_s, before, after, _short(before, after))


GUESSES_OUTSIDE = Twin(
    "guesses outside",
    guesses,
    Words(
        en="Inside all is well, but outside your function goes on along the line. A buffer never guesses: raise `ExtrapolationException`.",
        ko="안쪽은 모두 맞지만, 바깥에서도 선을 따라 계속 갑니다. 버퍼는 결코 짐작하지 않습니다. `ExtrapolationException`을 일으키십시오.",
    ),
)


def clamps(stamp_s, before, after):
    return guesses(min(max(stamp_s, before[0]), after[0]), before, after)


STOPS_AT_THE_ENDS = Twin(
    "stops at the ends",
    clamps,
    Words(
        en="Inside all is well, but outside your function answers with the nearest end. That is a guess, too: raise `ExtrapolationException`.",
        ko="안쪽은 모두 맞지만, 바깥에서는 가까운 끝의 값을 답합니다. 그것도 짐작입니다. `ExtrapolationException`을 일으키십시오.",
    ),
)


def middle(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return guesses((before[0] + after[0]) / 2, before, after)


ALWAYS_THE_MIDDLE = Twin(
    "always the middle",
    middle,
    Words(
        en="Wherever `stamp_s` lies, you answer with the middle of the two samples. How far along is it? Near the first sample the answer must be near the first.",
        ko="`stamp_s`가 어디에 있든 두 표본의 한가운데를 답합니다. 얼마나 간 곳입니까? 첫 표본 가까이에서는 답도 첫 표본에 가까워야 합니다.",
    ),
)


def earlier(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return {"position": before[1:3], "yaw": before[3]}


THE_EARLIER_SAMPLE = Twin(
    "the earlier sample",
    earlier,
    Words(
        en="You return the earlier sample as it is. The robot has moved since: go along the line to the second one, as far as `stamp_s` says.",
        ko="앞쪽 표본을 그대로 반환합니다. 그 뒤로 로봇은 움직였습니다. `stamp_s`가 말하는 만큼 둘째 표본 쪽으로 선을 따라가십시오.",
    ),
)


def shy(stamp_s, before, after):
    from tflab.core import ExtrapolationException

    if stamp_s in (before[0], after[0]):
        raise ExtrapolationException("at a sample")
    _refuse(stamp_s, before, after)
    return guesses(stamp_s, before, after)


REFUSES_AT_A_SAMPLE = Twin(
    "refuses at a sample",
    shy,
    Words(
        en="Between the samples all is well, but exactly at a sample you refuse. There the buffer knows the answer best of all: only before the first and after the second is outside.",
        ko="표본 사이는 모두 맞지만, 표본의 시각을 그대로 물으면 거절합니다. 버퍼가 가장 잘 아는 순간입니다. 첫 표본 앞과 둘째 표본 뒤만 바깥입니다.",
    ),
)


def backwards(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return guesses(before[0] + after[0] - stamp_s, before, after)


COUNTED_FROM_THE_WRONG_END = Twin(
    "counted from the wrong end",
    backwards,
    Words(
        en="Your ratio is counted from the later sample: near the first sample you answer as if near the second.",
        ko="비율을 뒤쪽 표본에서 세었습니다. 첫 표본 가까이에서 둘째 표본 가까이에 있는 것처럼 답합니다.",
    ),
)


def long_way_and_guesses(stamp_s, before, after):
    return _blend(stamp_s, before, after, after[3] - before[3])


THE_LONG_WAY_AND_GUESSES = Twin(
    "the long way, and guesses",
    long_way_and_guesses,
    Words(
        en="Two things: yaw goes the long way round at ±π, and outside the two samples nothing is refused.",
        ko="두 가지입니다. ±π에서 yaw가 먼 길로 돌고, 두 표본 바깥에서도 거절하지 않습니다.",
    ),
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
    twins=(
        THE_LONG_WAY,
        THE_NEAREST_SAMPLE,
        GUESSES_OUTSIDE,
        STOPS_AT_THE_ENDS,
        COUNTED_FROM_THE_WRONG_END,
        THE_LONG_WAY_AND_GUESSES,
        ALWAYS_THE_MIDDLE,
        THE_EARLIER_SAMPLE,
        REFUSES_AT_A_SAMPLE,
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
