"""E7.4: Five robots."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Choice, Parts, define_task

ROBOTS = ("a", "b", "c", "d", "e")
CAUSES = ("other names", "stamp zero", "no driver", "paint moved", "degrees")
MENDS = {
    "other names": "use the URDF's names",
    "stamp zero": "stamp the message",
    "no driver": "start the joint driver",
    "paint moved": "write it into the joint",
    "degrees": "write radians",
}
OTHERS = ("restart RViz", "change the cable", "wait longer")
WHOLE = "base_link > shoulder > elbow > wrist > tool0\nbase_link > laser_frame"
APART = "base_link > laser_frame\nwrist > tool0"
NAMES = ("shoulder_joint", "elbow_joint", "wrist_joint")


def joint_states(names, stamp, positions):
    sec, nanosec = stamp
    lines = [f"header: {{stamp: {{sec: {sec}, nanosec: {nanosec}}}}}", f"name: [{', '.join(names)}]"]
    return "\n".join(
        ["$ ros2 topic echo /joint_states --once", *lines, f"position: [{', '.join(map(str, positions))}]"]
    )


def echoed(xyz, yaw_rad):
    turn = math.degrees(yaw_rad)
    return "\n".join((
        "$ ros2 run tf2_ros tf2_echo base_link laser_frame",
        f"- Translation: [{', '.join(f'{each:.3f}' for each in xyz)}]",
        f"- Rotation: in RPY (degree) [0.000, 0.000, {turn:.3f}]",
    ))  # fmt: skip


def draw_robots(rng):
    """Draw one robot for each cause, with names, stamps and angles."""
    short = [name.removesuffix("_joint") for name in NAMES]
    odd = [short, [f"arm_{name}" for name in NAMES], [name.title().replace("_", "") for name in NAMES]][
        int(rng.integers(3))
    ]
    positions = [round(float(each), 2) for each in rng.uniform(-1.0, 1.0, 3)]
    now = (int(rng.integers(100, 900)), int(rng.integers(1, 9)) * 100_000_000)
    degrees = int(rng.choice([45, 90, 135, 180]))
    x, z = int(rng.integers(10, 30)) / 100, int(rng.integers(10, 30)) / 100
    turned = math.remainder(degrees, math.tau)
    joint = f'<joint name="base_to_laser" type="fixed"> ... <origin xyz="{x} 0 {z}"'
    visual = f'<link name="laser_frame"> <visual> <origin rpy="0 0 {math.radians(degrees):.4f}"/> ... </visual> </link>'
    reports = {
        "other names": f"{APART}\n{joint_states(odd, now, positions)}",
        "stamp zero": f"{APART}\n{joint_states(NAMES, (0, 0), positions)}",
        "no driver": f"{APART}\n$ ros2 topic info /joint_states\nType: sensor_msgs/msg/JointState\n"
        "Publisher count: 0\nSubscription count: 1",
        "paint moved": f'{WHOLE}\n{joint} rpy="0 0 0"/> </joint>\n{visual}\n{echoed((x, 0, z), 0.0)}',
        "degrees": f'{WHOLE}\n{joint} rpy="0 0 {degrees}"/> </joint>\n{echoed((x, 0, z), turned)}',
    }
    shuffled = [str(cause) for cause in rng.permutation(list(reports))]
    return {letter: reports[cause] for letter, cause in zip(ROBOTS, shuffled, strict=True)}


def cause_of(report):
    if "Publisher count: 0" in report:
        return "no driver"
    if "<visual>" in report:
        return "paint moved"
    if "<joint" in report:
        return "degrees"
    return "stamp zero" if "sec: 0," in report else "other names"


def answers(g, say=lambda cause: cause, do=MENDS.get):
    """Return the diagnosis and the fix of each robot."""
    causes = {letter: cause_of(getattr(g, letter)) for letter in ROBOTS}
    return {**{r: say(cause) for r, cause in causes.items()}, **{f"{r} do": do(cause) for r, cause in causes.items()}}


ARMS = ("other names", "stamp zero", "no driver")
SENSORS = ("paint moved", "degrees")

ANSWERS = {
    "always a driver": lambda g: answers(g, lambda cause: "no driver" if cause in ARMS else cause),
    "stamp overlooked": lambda g: answers(g, lambda cause: "other names" if cause in ARMS[:2] else cause),
    "restart RViz": lambda g: answers(g, do=lambda cause: "restart RViz"),
    "cable for sensors": lambda g: answers(
        g, do=lambda cause: "change the cable" if cause in SENSORS else MENDS[cause]
    ),
    "wait for the arms": lambda g: answers(g, do=lambda cause: "wait longer" if cause in ARMS else MENDS[cause]),
}

TASK = define_task(
    __file__,
    kind="D",
    points=5,
    answer="findings",
    form=Parts(
        {
            **{robot: Choice(CAUSES) for robot in ROBOTS},
            **{f"{robot} do": Choice((*MENDS.values(), *OTHERS)) for robot in ROBOTS},
        }
    ),
    given=draw_robots,
    variants=6,
    answers=ANSWERS,
)
