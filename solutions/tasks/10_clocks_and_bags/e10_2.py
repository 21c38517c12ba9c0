"""E10.2: The smallest recording."""

from __future__ import annotations

from tflab.workbook.tasks import Command, Parts, define_task

SENSORS = ("/scan", "/front/scan", "/rear/scan", "/lidar/points", "/depth/points", "/radar/points", "/sonar/range")
ODOMETRY = ("/wheel/odom", "/base/odometry", "/encoders/odom", "/drive/odom")


def draw_robots(rng):
    """Draw a sensor for each robot, and the topic of the third one's odometry."""
    sensors = [SENSORS[i] for i in rng.permutation(len(SENSORS))[:3]]
    return {
        "sensor": dict(zip("abc", sensors, strict=True)),
        "wheels": {"c": ODOMETRY[int(rng.integers(len(ODOMETRY)))]},
    }


def write_lines(
    g, sensor=True, mounts=True, moving="/tf", sim_clock=True, real_clock=False, wheels="message", everything=False,
    map_too=False,
):  # fmt: skip
    """Return the three lines, step by step; other arguments are mistakes."""
    speaks = g.wheels["c"]
    for_c = {"message": [speaks], "none": [], "transform": ["/tf"], "by habit": ["/odom"], "both": [speaks, "/tf"]}[
        wheels
    ]
    topics = {"a": [moving], "b": [moving], "c": for_c}
    answers = {}
    for letter, more in topics.items():
        has_clock = sim_clock if letter == "b" else real_clock
        row = [g.sensor[letter]] * sensor + [topic for topic in more if topic] + ["/tf_static"] * mounts
        row += ["--clock" if has_clock == "option" else "/clock"] * bool(has_clock) + ["/map"] * (
            map_too and letter != "c"
        )
        answers[letter] = "ros2 bag record " + ("-a" if everything else " ".join(row))
    return answers


ANSWERS = {
    "the sensor alone": lambda g: {letter: f"ros2 bag record {sensor}" for letter, sensor in g.sensor.items()},
    "the lecture's line": lambda g: {
        letter: f"ros2 bag record {sensor} /odom /tf /tf_static /clock" for letter, sensor in g.sensor.items()
    },
}

TASK = define_task(
    __file__,
    kind="C",
    points=4,
    answer="recordings",
    form=Parts({letter: Command() for letter in "abc"}),
    given=draw_robots,
    variants=8,
    model=write_lines,
    answers=ANSWERS,
)
