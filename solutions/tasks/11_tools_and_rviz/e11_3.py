"""E11.3: Often enough?"""

from __future__ import annotations

import math
import re

from tflab.tools.tf2_monitor import Delays, NetDelay, broadcaster_line, frame_lines, results_heading
from tflab.workbook.tasks import Choice, Number, Parts, define_task

LOOKS = 21


def draw_report(rng):
    """Draw a report with rates of other nodes, a curve and a limit, which is met or not."""
    others = {"robot_state_publisher": float(rng.choice((15.0, 20.0, 25.0))), "localization": 10.0}
    rate = float(rng.choice((2.0, 2.5, 3.0, 4.0)))
    v = w = 0.0
    while 1000 * v * w**3 / (24 * rate**4) < 0.08:  # until a cosine differs from its first terms, by this [mm]
        v, w = round(float(rng.uniform(0.5, 1.2)), 2), round(float(rng.uniform(0.5, 1.2)), 2)
    chord_mm = 1000 * v / w * (1 - math.cos(w / (2 * rate)))
    share = float(rng.choice((0.6, 1.6)))
    travel_s = round(float(rng.uniform(0.004, 0.020)), 3)
    late_s = round(1 / rate + travel_s + float(rng.uniform(0.02, 0.05)), 3)  # one message came later than its turn
    return {
        "sends_hz": others,
        "hz_of_tf": sum(others.values()) + rate,
        "report": report_of(late_s, travel_s, round(float(rng.uniform(8.0, 30.0)), 1)),
        "speed_mps": v,
        "yaw_rate_radps": w,
        "allowed_mm": max(0.1, round(chord_mm * share, 1)),
        "transform_travels_s": travel_s,
        "scan_travels_s": 0.105,
    }


def report_of(late_s, travel_s, static_s):
    """Return a first report, as tf2_monitor writes it."""
    net, delays = NetDelay(), Delays()
    for _ in range(LOOKS):
        net.add(late_s)
    delays.add_message(static_s, [("laser_frame", 0.0)])
    for number in range(100):
        delays.add_message(static_s + 0.1 * number, [("base_footprint", static_s + 0.1 * number - travel_s)])
        delays.add_message(static_s + 0.1 * number, [("odom", static_s + 0.1 * number - 0.01)])
    chain = ("map", "odom", "base_footprint", "laser_frame")
    rows = [results_heading(chain, net).strip("\n"), "", "Frames:", *frame_lines(delays, chain)]
    return "\n".join([*rows, "", "All Broadcasters:", broadcaster_line(delays)])


def judge_rates(given, *, rate="the rest", late="max", curve="chord", period="whole", travel="with the scan"):
    """Return the five answers, step by step; other arguments are mistakes."""
    f = {
        "the rest": given.hz_of_tf - sum(given.sends_hz.values()),
        "everybody": given.hz_of_tf,
        "shared": given.hz_of_tf / (len(given.sends_hz) + 1),
        "localization's": given.sends_hz["localization"],
        "without localization": given.hz_of_tf - given.sends_hz["robot_state_publisher"],
        "without the state publisher": given.hz_of_tf - given.sends_hz["localization"],
        "the report's": float(re.search(r"([\d.]+) Hz", given.report)[1]),
    }[rate]
    avg, largest = map(float, re.search(r"avg = (\S+): max = (\S+)", given.report).groups())
    static = float(re.search(r"laser_frame,.*Average Delay: (\S+),", given.report)[1])
    of_the_report = {
        "max": largest,
        "avg": avg,
        "static": static,
        "without its way": largest - given.transform_travels_s,
    }
    v, w = given.speed_mps, given.yaw_rate_radps
    gap = {
        "chord": v / w * (1 - math.cos(w / (2 * f))),
        "way": v / f,
        "half way": v / (2 * f),
        "whole angle": v / w * (1 - math.cos(w / f)),
        "angle in degrees": v / w * (1 - math.cos(math.degrees(w / (2 * f)))),
        "straight": 0.0,
        "way while late": v * largest,
        "half the square": v * w / (2 * f**2),
        "product": v * w * (1 - math.cos(w / (2 * f))),
        "radius": v / w,
        "chord itself": 2 * v / w * math.sin(w / (2 * f)),
        "sideways": v / w * math.sin(w / (2 * f)),
    }[curve]
    way = {
        "with the scan": given.transform_travels_s - given.scan_travels_s,
        "without the scan": given.transform_travels_s,
        "scan added": given.transform_travels_s + given.scan_travels_s,
        "the scan's alone": given.scan_travels_s,
        "the other way": given.scan_travels_s - given.transform_travels_s,
        "both taken off": -given.transform_travels_s - given.scan_travels_s,
        "without the transform": -given.scan_travels_s,
    }.get(travel, 0.0)
    if travel == "lateness without the scan":
        way = largest - given.scan_travels_s - 1 / f
    wait = {"whole": 1.0, "half": 0.5, "none": 0.0}[period] / f + way
    return {
        "odometry_hz": f,
        "late_s": of_the_report[late],
        "off_mm": 1000 * gap,
        "wait_s": wait if period == "none" else max(0.0, wait),
        "enough": "yes" if 1000 * gap <= given.allowed_mm else "no",
    }


ANSWERS = {
    "other verdict": lambda g: {**judge_rates(g), "enough": "no" if judge_rates(g)["enough"] == "yes" else "yes"},
}

TASK = define_task(
    __file__,
    kind="N",
    points=4,
    answer="verdict",
    form=Parts(
        {
            "odometry_hz": Number("Hz", tolerance=0.01),
            "late_s": Number("s", tolerance=0.001),
            "off_mm": Number("mm", tolerance=0.05),
            "wait_s": Number("s", tolerance=0.001),
            "enough": Choice(("yes", "no")),
        }
    ),
    given=draw_report,
    variants=6,
    model=judge_rates,
    answers=ANSWERS,
)
