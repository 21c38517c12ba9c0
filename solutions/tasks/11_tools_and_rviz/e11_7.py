"""E11.7: Three commands."""

from __future__ import annotations

from tflab.workbook.tasks import Command, Parts, define_task

PAIRS = (
    ("map", "base_link"), ("odom", "base_link"), ("map", "laser_frame"), ("odom", "camera_link"),
    ("map", "base_footprint"), ("odom", "laser_frame"),
)  # fmt: skip


def draw_frames_and_rate(rng):
    first, second = (PAIRS[i] for i in rng.permutation(len(PAIRS))[:2])
    return {
        "echo_of": first[1],
        "echo_in": first[0],
        "echo_hz": int(rng.choice((5, 10, 20, 25))),
        "chain": list(second),
        "topic": str(rng.choice(("/tf", "/tf_static"))),
    }


ECHO = {
    "tf2_ros": "ros2 run tf2_ros tf2_echo",
    "tf2_tools": "ros2 run tf2_tools tf2_echo",
    "topic echo": "ros2 topic echo",
}


def write_lines(given, *, order="in first", rate="given", chain="given", clock="simulated", who="--verbose",
          package="tf2_ros", tool="tf2_monitor"):  # fmt: skip
    """Return the three lines, step by step; other arguments are mistakes."""
    frames = (given.echo_in, given.echo_of) if order == "in first" else (given.echo_of, given.echo_in)
    hz = {
        "given": f" {given.echo_hz}",
        "none": "",
        "option": f" --rate {given.echo_hz}",
        "short option": f" -r {given.echo_hz}",
        "period": f" {1 / given.echo_hz}",
    }[rate]
    other = "/tf" if given.topic == "/tf_static" else "/tf_static"
    ends = given.chain if chain == "given" else [] if chain == "all" else given.chain[::-1]
    sim = {
        "simulated": " --ros-args -p use_sim_time:=true",
        "wall": "",
        "bare": " use_sim_time:=true",
        "off": " --ros-args -p use_sim_time:=false",
        "no --ros-args": " -p use_sim_time:=true",
        "equals": " --ros-args -p use_sim_time=true",
        "one": " --ros-args -p use_sim_time:=1",
        "--clock": " --clock",
    }[clock]
    return {
        "value": f"{ECHO[package]} {' '.join(frames)}{hz if package != 'topic echo' else ''}",
        "late": {
            "tf2_monitor": " ".join(["ros2 run tf2_ros tf2_monitor", *ends]) + sim,
            "tf2_tools": " ".join(["ros2 run tf2_tools tf2_monitor", *ends]) + sim,
            "topic delay": " ".join(["ros2 topic delay", *ends]),
            "view_frames": "ros2 run tf2_tools view_frames",
        }[tool],
        "who": {
            "--verbose": f"ros2 topic info {given.topic} --verbose",
            "counts": f"ros2 topic info {given.topic}",
            "topics": "ros2 topic list",
            "nodes": "ros2 node list",
            "node info": f"ros2 node info {given.topic}",
            "echo": f"ros2 topic echo {given.topic}",
            "hz": f"ros2 topic hz {given.topic}",
            "other topic": f"ros2 topic info {other} --verbose",
        }[who],
    }


TASK = define_task(
    __file__,
    kind="C",
    points=2,
    answer="commands",
    form=Parts({"value": Command(), "late": Command(), "who": Command()}),
    given=draw_frames_and_rate,
    variants=6,
    model=write_lines,
)
