"""E10.3: Five failures."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

LETTERS = "abcde"
CAUSES = (
    "mounts not recorded", "mounts skipped", "nobody publishes /clock", "one node on another clock", "time went back",
    "sensor broken",
)  # fmt: skip
CURES = (
    "record again, with /tf_static", "play from the start", "play with --clock", "set use_sim_time on that node",
    "Buffer(node=self)", "set use_sim_time on all nodes", "raise the timeout", "replace the sensor",
)  # fmt: skip
ALL = {"/scan": 300, "/tf": 900, "/tf_static": 1}
GONE = '"laser_frame" passed to lookupTransform argument source_frame does not exist. '


def draw_failures(rng):
    """Draw the five failures with numbers, in any order."""
    start_s = round(float(rng.uniform(1.70e9, 1.79e9)), 1)
    offset_s = round(float(rng.uniform(0.5, 4.0)), 1)
    asked_s, later_s = round(start_s + float(rng.uniform(3.0, 9.0)), 3), round(float(rng.uniform(2e5, 9e6)), 1)
    scans = int(rng.integers(200, 900))
    counts = {**ALL, "/scan": scans}
    everywhere = {"/detector": True, "/localizer": True, "/rviz2": True}
    failures = [
        ({"/scan": scans, "/tf": 3 * scans}, "ros2 bag play drive --clock", everywhere, GONE),
        (counts, f"ros2 bag play drive --clock --start-offset {offset_s}", everywhere, GONE),
        (counts, "ros2 bag play drive", everywhere, "(nothing: a timer of 1 s has not rung in a minute)"),
        (
            counts, "ros2 bag play drive --clock", {**everywhere, "/localizer": False},
            "Lookup would require extrapolation into the past.  "
            f"Requested time {asked_s:.6f} but the earliest data is at time {start_s + later_s:.6f}, "
            "when looking up transform from frame [laser_frame] to frame [map]",
        ),
        (
            counts, "ros2 bag play drive --clock --loop", everywhere,
            f"TF_OLD_DATA ignoring data from the past for frame odom at time {start_s + 0.4:.6f} "
            "according to authority default_authority",
        ),
    ]  # fmt: skip
    order = rng.permutation(len(failures))
    rows = [failures[i] for i in order]
    return {
        "failures": {
            letter: {"info": info, "play": play, "use_sim_time": nodes, "log": log}
            for letter, (info, play, nodes, log) in zip(LETTERS, rows, strict=True)
        }
    }


def diagnose(
    g,
    gone=("mounts not recorded", "mounts skipped"),
    gone_do=("record again, with /tf_static", "play from the start"),
    silent=("nobody publishes /clock", "play with --clock"),
    apart=("one node on another clock", "set use_sim_time on that node"),
    back=("time went back", "Buffer(node=self)"),
):
    """Return cause and fix of each, step by step; other arguments are mistakes."""
    answers = {}
    for letter, failure in g.failures.items():
        if "/tf_static" not in failure["info"]:
            cause, cure = gone[0], gone_do[0]
        elif "--start-offset" in failure["play"]:
            cause, cure = gone[1], gone_do[1]
        elif "--clock" not in failure["play"]:
            cause, cure = silent
        elif "--loop" in failure["play"]:
            cause, cure = back
        else:
            cause, cure = apart
        answers[f"{letter} cause"], answers[f"{letter} do"] = cause, cure
    return answers


TASK = define_task(
    __file__,
    kind="D",
    points=5,
    answer="findings",
    form=Parts(
        {
            name: choice
            for letter in LETTERS
            for name, choice in ((f"{letter} cause", Choice(CAUSES)), (f"{letter} do", Choice(CURES)))
        }
    ),
    given=draw_failures,
    variants=8,
    model=diagnose,
)
