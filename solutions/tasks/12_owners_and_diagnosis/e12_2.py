"""E12.2: Five terminals."""

from __future__ import annotations

import re

from tflab.workbook.tasks import Choice, Parts, define_task

from .draws import draw_stored_patient

STATES = ("one owner", "nobody", "two owners", "another edge", "a misspelt parent")
CURES = (
    "leave it as it is",
    "start wheel_odometry",
    "ekf_filter_node: publish_tf false",
    "localization: send map -> odom",
    "wheel_odometry: parent odom",
)
TERMINALS = {
    "one owner": "nothing is wrong",
    "nobody": "odometry not running",
    "two owners": "two owners of one edge",
    "another edge": "localizer owns the base",
    "a misspelt parent": "parent misspelt",
}
CURE_OF = dict(zip(TERMINALS, CURES, strict=True))
PLACES = "abcde"
LINES = 19  # of a reading
# What each terminal shows, the same of all five, or the questions would tell what the answers should.
COUNT = r"^(?:Type|Publisher count|Subscription count): .*"
MOVING = r"(?:odom|base_footprint): \\n(?:  \S+: \S+?\\n)+"


def draw_terminals(rng):
    """Draw five robots, run their tools, and shuffle the outputs."""
    shown = [_shown(draw_stored_patient(rng, cause)) for cause in TERMINALS.values()]
    return {place: shown[int(number)] for place, number in zip(PLACES, rng.permutation(len(shown)), strict=True)}


def _shown(patient):
    def read(check):
        return patient.reading(check)[1]

    echoed = re.sub(
        r"\n- Rotation.*?(?=\nAt time|\nFailure|\n\[|\Z)", "", read("echo odom base_footprint"), flags=re.DOTALL
    )
    echoed = re.sub(r"(?s)\nThe current list of frames is:.*?(?=\nAt time|\nFailure|\Z)", "", echoed)
    readings = {
        "ros2 node list": read("node list"),
        "ros2 topic info /tf": "\n".join(re.findall(COUNT, read("info /tf"), re.MULTILINE)),
        "ros2 run tf2_ros tf2_echo odom base_footprint 20": "\n".join(echoed.splitlines()[:LINES]),
        "ros2 run tf2_tools view_frames   (odom and base_footprint of it)": "\n".join(
            found.replace("\\n", "\n").rstrip() for found in sorted(re.findall(MOVING, read("view_frames")))
        ),
    }
    return "\n".join(f"$ {command}\n{text}" for command, text in readings.items())


def state_of(text):
    """Return the state that a terminal shows."""
    if "Failure at" in text:
        return "another edge"
    if "wheel_odometry" not in text:
        return "nobody"
    if "ekf_filter_node" in text:
        return "two owners"
    return "one owner" if re.search(r"base_footprint: *\n +parent: 'odom'", text) else "a misspelt parent"


def diagnose(given, *, odm="misspelt", calm="one", count="endpoints", another="another edge", nobody="nobody"):
    """Return state and fix of each terminal, step by step; other arguments are mistakes."""
    answers = {}
    for place in PLACES:
        state = seen = state_of(getattr(given, place))
        cure = CURE_OF[state]
        if state == "a misspelt parent" and odm == "node down":
            state, cure = "nobody", "start wheel_odometry"
        if state == "two owners" and calm == "healthy":
            state, cure = "one owner", "leave it as it is"
        if seen == "one owner" and count == "owners":
            state, cure = "two owners", "ekf_filter_node: publish_tf false"
        if state == "another edge" and another == "two owners":
            state = "two owners"
        if seen == "nobody" and nobody == "switch":
            cure = "localization: send map -> odom"
        answers |= {f"{place} state": state, f"{place} cure": cure}
    return answers


TASK = define_task(
    __file__,
    kind="D",
    points=4,
    answer="terminals",
    form=Parts(
        {
            f"{place} {what}": Choice(options)
            for place in PLACES
            for what, options in (("state", STATES), ("cure", CURES))
        }
    ),
    given=draw_terminals,
    variants=3,
    is_costly=True,
    model=diagnose,
)
