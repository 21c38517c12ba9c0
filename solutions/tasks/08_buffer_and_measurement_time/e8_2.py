"""E8.2: Between two samples."""

from __future__ import annotations

import math

from tflab.core import ExtrapolationException
from tflab.workbook.tasks import Angle, Parts, Vector, define_task


def draw_samples(rng):
    """Draw left and right rotations, some across ±180 degrees; times at each sample and outside on either side."""
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
        (0, -1e-5),
        (0, 1.00001),
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
    far_s = 40.0 * float(rng.uniform(0.233, 0.237))  # samples so far apart that two digits of the ratio are too few
    return [*rows, (far_s, (0.0, -4.0, 4.0, 0.4), (40.0, 4.0, -4.5, 1.1))]


ORDERS = {"yaw before y": (0, 1, 3, 2), "yaw before x": (0, 2, 3, 1)}  # in which x, y and yaw stand in what was read


def interpolate(
    stamp_s, before, after, *, early="refused", late="refused", ratio="from the first", position="line", turn="short"
) -> dict:
    """Return what the buffer does, step by step; other arguments are mistakes."""
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
    """Return the fraction of the interval at which the answer is interpolated."""
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
    """Return the position; `turn` is the change of the heading at the end."""
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


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="interpolate",
    form=Parts({"position": Vector(2, unit="m"), "yaw": Angle()}),
    inputs=draw_samples,
    variants=4,
    model=interpolate,
)
