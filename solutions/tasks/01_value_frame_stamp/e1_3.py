"""E1.3: A receiver that rejects."""

from __future__ import annotations

from tflab.core import seconds
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, define_task

from .draws import make_point, time_from_ns

OPTIONS = ("use it", "no frame", "no stamp", "too old", "from the future")


def draw_messages(rng):
    """Draw each verdict twice or more: ages across a full second, a nanosec below 0.1 s, both bounds."""
    second = int(rng.integers(20, 90))
    limit = float(rng.choice([1.2, 1.5, 1.8]))
    hair = 200_000
    limit_ns = seconds(limit)

    def row(frame, now_s, age_ns, x=2.0):
        now_ns = seconds(second) + seconds(now_s)
        return make_point(frame, now_ns - age_ns, x), time_from_ns(now_ns), limit

    nothing = make_point("", 0, 2.0)
    return [
        row("laser_frame", 0.35, seconds(0.3)),  # nanosec below 0.1 s: 0.05
        row("camera_link", 0.15, seconds(0.2)),  # across a full second
        # just that old; of floats too, for halves have no last digit to lose
        (*row("laser_frame", 0.5, seconds(1.5))[:2], 1.5),
        row("laser_frame", 0.5, limit_ns - hair),
        row("laser_frame", 0.5, limit_ns + hair),
        row("map", 0.02, limit_ns + seconds(0.4)),
        row("laser_frame", 0.98, limit_ns + seconds(0.15)),  # too old, and too few full seconds
        row("laser_frame", 0.05 + limit + 0.1, limit_ns + seconds(0.1)),  # too old only if 50000000 ns is 0.05 s
        row("laser_frame", 0.5, 0),
        row("laser_frame", 0.5, hair),
        row("laser_frame", 0.25, seconds(0.25)),  # a whole second: nanosec is 0
        row("laser_frame", 0.5, -hair),
        row("laser_frame", 0.5, -1),
        row("camera_link", 0.9, -seconds(limit + 0.4)),
        (*row("laser_frame", 0.5, seconds(1.0))[:2], 1.0),  # a limit of whole seconds, and just that old
        (*row("robot1/gps", 0.5, seconds(2.1))[:2], 2.4),  # too old only for the other limits
        (*row("gps_link", 0.5, seconds(0.6))[:2], 0.5),  # young enough only for them
        (*row("f", 0.5, seconds(1.0))[:2], 0.0),  # a name of one letter, and a limit of nothing
        (make_point("laser_frame", 0, 2.0), time_from_ns(seconds(second)), limit),
        (make_point("base_link", 0, 3.0), time_from_ns(seconds(0.3)), limit),
        (make_point("base_link", 1, 3.0), time_from_ns(seconds(0.3)), limit),  # a nanosecond is a stamp
        (nothing, time_from_ns(seconds(second)), limit),
        row("", 0.4, seconds(0.1)),
        row("", 0.4, limit_ns + seconds(3.0)),
    ]


def age_s(message, now, age):
    """Return the age [s], computed in one of several ways."""
    stamp = message.header.stamp
    right = (now.nanoseconds - Time.from_msg(stamp).nanoseconds) / 1e9
    return {
        "right": right,
        "sec alone": float(now.nanoseconds // 10**9 - stamp.sec),
        "nanosec alone": (now.nanoseconds - stamp.nanosec) / 1e9,
        "digits": now.nanoseconds / 1e9 - float(f"{stamp.sec}.{stamp.nanosec}"),
        "without sign": abs(right),
        "stamp minus now": -right,
        "milliseconds": right * 1e3,
        "nanoseconds": right * 1e9,
        "nanosec by a million": float(now.nanoseconds // 10**9 - stamp.sec)
        + (now.nanoseconds % 10**9 - stamp.nanosec) / 1e6,
        "tenths": round(right, 1),
        "stamp by a million": now.nanoseconds / 1e9 - stamp.sec - stamp.nanosec / 1e6,
        "stamp in nanoseconds": now.nanoseconds / 1e9 - (stamp.sec * 10**9 + stamp.nanosec),
        "now in nanoseconds": now.nanoseconds - (stamp.sec + stamp.nanosec / 1e9),
        "stamp cut": now.nanoseconds / 1e9 - stamp.sec,
        "nanosec as it is": now.nanoseconds // 10**9 + now.nanoseconds % 10**9 - stamp.sec - stamp.nanosec,
        "now cut": now.nanoseconds // 10**9 - (stamp.sec + stamp.nanosec / 1e9),
    }[age]


def judge_age(
    message,
    now,
    max_age_s,
    *,
    looks="frame stamp future old",
    zero="both",
    age="right",
    old_by="right",
    ahead="after now",
    bound="older",
    limit="as given",
):
    """Return the reader's verdict, step by step; other arguments are mistakes."""
    stamp = message.header.stamp
    old_s = age_s(message, now, age)
    apart_s = old_s if old_by == "right" else age_s(message, now, old_by)
    max_age_s = {"as given": max_age_s, "whole": float(int(max_age_s))}[limit]
    early_s = round(apart_s - max_age_s, 10)  # rounding of floats is no mistake
    says = {
        "frame": (not message.header.frame_id, "no frame"),
        "stamp": (
            {
                "both": not (stamp.sec or stamp.nanosec),
                "sec": not stamp.sec,
                "nanosec": not stamp.nanosec,
                "either": not (stamp.sec and stamp.nanosec),
            }[zero],
            "no stamp",
        ),
        "future": ({"after now": old_s < 0, "now, too": old_s <= 0, "a tenth": old_s < -0.1}[ahead], "from the future"),
        "young": (early_s < 0, "too old"),
        "far": (round(abs(old_s) - max_age_s, 10) > 0, "too old"),
        "old": (early_s > 0 if bound == "older" else early_s >= 0, "too old"),
    }
    return next((says[look][1] for look in looks.split() if says[look][0]), "use it")


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="judge",
    form=Choice(OPTIONS),
    inputs=draw_messages,
    variants=3,
    model=judge_age,
)
