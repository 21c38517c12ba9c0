"""E11.4: Six robots in RViz."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

from .draws import make_list

CAUSES = (
    "localiser down", "Fixed Frame misspelt", "joint states missing", "odometry down", "stamps late", "mount wrong",
    "sensor broken", "nothing wrong",
)  # fmt: skip
CHECKS = {
    "localiser down": "ros2 node list",
    "Fixed Frame misspelt": "the name in RViz",
    "joint states missing": "ros2 topic hz /joint_states",
    "odometry down": "ros2 node list",
    "stamps late": "ros2 topic delay /scan",
    "mount wrong": "tf2_echo base_link laser_frame",
}
FURTHER_CHECKS = ("replace the sensor", "a longer timeout", "no check")
FURTHER = {**CHECKS, "sensor broken": "replace the sensor", "nothing wrong": "no check"}
SICK = tuple(CHECKS)
NAMES = "abcdef"
JOINTS = (("shoulder_link", "elbow_link"), ("left_wheel", "right_wheel"), ("pan_link", "tilt_link"), ("lift", "fork"))
TYPED = ("Map", "maps", "/map", "mpa")


def draw_lists(rng):
    """Draw one robot of each kind, in any order, with its joints and a typed name."""
    joints, typed = JOINTS[int(rng.integers(len(JOINTS)))], TYPED[int(rng.integers(len(TYPED)))]
    off = round(float(rng.uniform(0.15, 0.40)), 2)
    healthy = make_list(moving=joints)
    lists = {
        "localiser down": make_list(without=("odom",), moving=joints),
        "Fixed Frame misspelt": make_list(fixed_frame=typed, moving=joints),
        "joint states missing": make_list(without=joints, moving=joints),
        "odometry down": _two_trees(joints),
        "stamps late": f"{healthy}\n\nstanding still the scan lies on the walls; in bends it smears",
        "mount wrong": f"{healthy}\n\nstanding still and in bends the scan lies {off} m beside the walls, "
        "always on the same side of the robot",
    }
    return {f"robot_{name}": lists[SICK[i]] for name, i in zip(NAMES, rng.permutation(len(SICK)), strict=True)}


def _two_trees(joints):
    return make_list(without=("base_link",), moving=joints)


def cause_of(text):
    """Return the cause from the list, in the order in which causes are ruled out."""
    if "does not exist" in text.splitlines()[1]:
        return "localiser down" if "map: No transform" not in text else "Fixed Frame misspelt"
    if "not part of the same tree" in text:
        return "odometry down"
    if "RobotModel: Error" in text:
        return "joint states missing"
    return "stamps late" if "smears" in text else "mount wrong"


def answer(given, instead=None, checks=None):
    """Return causes and checks; `instead` and `checks` replace some of them."""
    instead, checks = instead or {}, {**CHECKS, **(checks or {})}
    row = {}
    for name in NAMES:
        true = cause_of(getattr(given, f"robot_{name}"))
        cause = instead.get(true, true)
        row[name], row[f"{name} check"] = cause, checks.get(cause, FURTHER[cause])
    return row


def always(cause):
    return lambda given: answer(given, dict.fromkeys(SICK, cause))


ANSWERS = {
    "sensor broken": always("sensor broken"),
    "map is Ok": lambda g: answer(g, {"localiser down": "Fixed Frame misspelt"}),
    "down for misspelt": lambda g: answer(g, {"Fixed Frame misspelt": "localiser down"}),
    "Ok, so nothing": lambda g: answer(g, {"stamps late": "nothing wrong", "mount wrong": "nothing wrong"}),
    "stamps for mount": lambda g: answer(g, {"mount wrong": "stamps late"}),
    "mount for stamps": lambda g: answer(g, {"stamps late": "mount wrong"}),
    "localiser for two trees": lambda g: answer(g, {"odometry down": "localiser down"}),
    "joints for two trees": lambda g: answer(g, {"odometry down": "joint states missing"}),
    "odometry for joints": lambda g: answer(g, {"joint states missing": "odometry down"}),
    "wait longer": lambda g: answer(
        g, checks={"odometry down": "a longer timeout", "localiser down": "a longer timeout"}
    ),
}

TASK = define_task(
    __file__,
    kind="D",
    points=4,
    answer="findings",
    form=Parts(
        {
            **{name: Choice(CAUSES) for name in NAMES},
            **{f"{name} check": Choice((*dict.fromkeys(CHECKS.values()), *FURTHER_CHECKS)) for name in NAMES},
        }
    ),
    given=draw_lists,
    variants=6,
    answers=ANSWERS,
)
