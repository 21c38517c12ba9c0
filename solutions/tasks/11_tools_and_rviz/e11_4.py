"""E11.4: Six robots in RViz."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

from .draws import list_of

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


def six_lists(rng):
    """One robot of each kind, in any order; the joints and the name that was typed vary."""
    joints, typed = JOINTS[int(rng.integers(len(JOINTS)))], TYPED[int(rng.integers(len(TYPED)))]
    off = round(float(rng.uniform(0.15, 0.40)), 2)
    healthy = list_of(moving=joints)
    lists = {
        "localiser down": list_of(without=("odom",), moving=joints),
        "Fixed Frame misspelt": list_of(fixed_frame=typed, moving=joints),
        "joint states missing": list_of(without=joints, moving=joints),
        "odometry down": _two_trees(joints),
        "stamps late": f"{healthy}\n\nstanding still the scan lies on the walls; in bends it smears",
        "mount wrong": f"{healthy}\n\nstanding still and in bends the scan lies {off} m beside the walls, "
        "always on the same side of the robot",
    }
    return {f"robot_{name}": lists[SICK[i]] for name, i in zip(NAMES, rng.permutation(len(SICK)), strict=True)}


def _two_trees(joints):
    return list_of(without=("base_link",), moving=joints)


def cause_of(text):
    """Return the cause from what the list says, in the order in which one rules out."""
    if "does not exist" in text.splitlines()[1]:
        return "localiser down" if "map: No transform" not in text else "Fixed Frame misspelt"
    if "not part of the same tree" in text:
        return "odometry down"
    if "RobotModel: Error" in text:
        return "joint states missing"
    return "stamps late" if "smears" in text else "mount wrong"


def answer(given, instead=None, checks=None):
    """Return causes and checks; `instead` and `checks` take some of them for others."""
    instead, checks = instead or {}, {**CHECKS, **(checks or {})}
    row = {}
    for name in NAMES:
        true = cause_of(getattr(given, f"robot_{name}"))
        cause = instead.get(true, true)
        row[name], row[f"{name} check"] = cause, checks.get(cause, FURTHER[cause])
    return row


def always(cause):
    return lambda given: answer(given, dict.fromkeys(SICK, cause))


SENSOR_BROKEN = WrongAnswer(
    "sensor broken",
    always("sensor broken"),
    Text(
        en="Not visible is not broken. In each of the six the sensor's messages came: RViz counts them. What could not be computed, or was computed from something untrue?",
        ko="보이지 않는다고 고장은 아닙니다. 여섯 대 모두 센서의 메시지가 왔고 RViz가 그 수를 셉니다. 무엇을 계산하지 못했습니까? 아니면 사실이 아닌 무엇으로 계산했습니까?",
    ),
    "M15",
)

MAP_IS_OK = WrongAnswer(
    "map is Ok",
    lambda g: answer(g, {"localiser down": "Fixed Frame misspelt"}),
    Text(
        en="Map Ok does not show that the localiser runs: its message is written in map, and map to map needs no TF. Is there a name like the typed one below TF?",
        ko="Map이 Ok라고 위치 추정 노드가 살아 있는 것은 아닙니다. 지도 메시지는 map 기준이라 TF가 필요 없습니다. TF 목록에 입력한 것과 비슷한 이름이 있습니까?",
    ),
    "M11",
)

DOWN_FOR_MISSPELT = WrongAnswer(
    "down for misspelt",
    lambda g: answer(g, {"Fixed Frame misspelt": "localiser down"}),
    Text(
        en="Look into the list below TF of the robot whose Map fails, too: the frame that is missing stands there under another spelling.",
        ko="Map까지 실패한 로봇의 TF 목록을 보세요. 없다는 좌표계가 다른 철자로 있습니다.",
    ),
    "M11",
)

OK_SO_NOTHING = WrongAnswer(
    "Ok, so nothing",
    lambda g: answer(g, {"stamps late": "nothing wrong", "mount wrong": "nothing wrong"}),
    Text(
        en="Ok says that it could be computed. The sentence below the list says that it lies wrong.",
        ko="Ok는 계산할 수 있었다는 뜻입니다. 목록 아래 문장은 틀린 자리에 놓였다고 합니다.",
    ),
    "M15",
    partly=True,
)

STAMPS_FOR_MOUNT = WrongAnswer(
    "stamps for mount",
    lambda g: answer(g, {"mount wrong": "stamps late"}),
    Text(
        en="A late stamp harms only while the robot turns or drives on. What is off by the same at all times is bolted on so.",
        ko="늦은 측정 시각은 로봇이 움직이는 동안에만 문제가 됩니다. 언제나 같은 만큼 벗어나면 그렇게 달려 있다고 적힌 것입니다.",
    ),
    "M9",
)

MOUNT_FOR_STAMPS = WrongAnswer(
    "mount for stamps",
    lambda g: answer(g, {"stamps late": "mount wrong"}),
    Text(
        en="A wrong mount would show standing still, too. What shows only on the move?",
        ko="장착 변환이 틀렸다면 서 있을 때도 보입니다. 움직일 때만 보이는 것은 무엇입니까?",
    ),
    "M9",
)

ONE_FOR_TWO_TREES = WrongAnswer(
    "localiser for two trees",
    lambda g: answer(g, {"odometry down": "localiser down"}),
    Text(
        en="Two trees: map and odom are together, so whoever joins these two is alive. Which edge is missing, and who sends it?",
        ko="트리가 둘입니다. map과 odom은 함께 있으니 그 둘을 잇는 노드는 살아 있습니다. 빠진 연결은 무엇이고 누가 보냅니까?",
    ),
    "M11",
)

JOINTS_FOR_TWO_TREES = WrongAnswer(
    "joints for two trees",
    lambda g: answer(g, {"odometry down": "joint states missing"}),
    Text(
        en="Here every link fails, base_link and laser_frame among them. Joint states carry only what moves.",
        ko="base_link와 laser_frame까지 모든 링크가 실패합니다. 관절 상태는 움직이는 것만 나릅니다.",
    ),
)

ODOMETRY_FOR_JOINTS = WrongAnswer(
    "odometry for joints",
    lambda g: answer(g, {"joint states missing": "odometry down"}),
    Text(
        en="The scan and base_link are in place, so the way from map to base_link stands. Which links fail, and what have they in common?",
        ko="스캔과 base_link가 제자리에 있으니 map에서 base_link까지는 이어져 있습니다. 실패한 링크들의 공통점은 무엇입니까?",
    ),
)

WAIT_LONGER = WrongAnswer(
    "wait longer",
    lambda g: answer(g, checks={"odometry down": "a longer timeout", "localiser down": "a longer timeout"}),
    Text(
        en="What nobody sends does not come later either.",
        ko="아무도 보내지 않는 것은 기다려도 오지 않습니다.",
    ),
    "M10",
    partly=True,
)


TASK = Task(
    id="E11.4",
    kind="D",
    points=4,
    title=Text(en="Six robots in RViz", ko="RViz에 보이는 로봇 여섯 대"),
    answer="findings",
    form=Parts(
        {
            **{name: Choice(CAUSES) for name in NAMES},
            **{f"{name} check": Choice((*dict.fromkeys(CHECKS.values()), *FURTHER_CHECKS)) for name in NAMES},
        }
    ),
    given=six_lists,
    variants=6,
    mistakes=(
        SENSOR_BROKEN,
        MAP_IS_OK,
        DOWN_FOR_MISSPELT,
        OK_SO_NOTHING,
        STAMPS_FOR_MOUNT,
        MOUNT_FOR_STAMPS,
        ONE_FOR_TWO_TREES,
        JOINTS_FOR_TWO_TREES,
        ODOMETRY_FOR_JOINTS,
        WAIT_LONGER,
    ),
    means={
        "localiser down": Text(
            en="with the localiser down nobody speaks of map: TF's list has no such name.",
            ko="위치 추정 노드가 멈추면 map을 발행하는 노드가 없어 TF 목록에 그 이름이 없습니다.",
        ),
        "Fixed Frame misspelt": Text(
            en="with a misspelt Fixed Frame the list below TF holds the name that was meant.",
            ko="Fixed Frame을 잘못 입력했다면 TF 목록에 원래 이름이 있습니다.",
        ),
        "joint states missing": Text(
            en="without joint states only the links behind moving joints are missing.",
            ko="관절 상태가 없으면 움직이는 관절 너머의 링크만 빠집니다.",
        ),
        "odometry down": Text(
            en="without odometry the robot's own frames are a second tree.",
            ko="오도메트리가 없으면 로봇의 좌표계들이 둘째 트리가 됩니다.",
        ),
        "stamps late": Text(
            en="wrong stamps leave the list Ok, and show in bends.",
            ko="측정 시각이 틀리면 목록은 Ok이고 굽은 길에서 드러납니다.",
        ),
        "mount wrong": Text(
            en="a wrong mount leaves the list Ok, and is off by the same at all times.",
            ko="장착 변환이 틀리면 목록은 Ok이고 언제나 같은 만큼 벗어납니다.",
        ),
        "sensor broken": Text(
            en="the sensor's messages came: RViz counts them.", ko="센서의 메시지는 왔습니다. RViz가 그 수를 셉니다."
        ),
        "nothing wrong": Text(
            en="something is: an error, or the sentence below the list.",
            ko="무언가 잘못되었습니다. 오류나 목록 아래 문장을 보십시오.",
        ),
        "ros2 node list": Text(
            en="the list of nodes shows which node is not there. A wrong name, stamp or mount, or a topic on which nothing comes, does not show in it.",
            ko="노드 목록은 어느 노드가 없는지 보여 줍니다. 틀린 이름이나 시각이나 장착, 아무것도 오지 않는 토픽은 거기에 나오지 않습니다.",
        ),
        "the name in RViz": Text(
            en="the typed name is the one that the others use.", ko="입력한 이름은 다른 노드가 쓰는 이름과 같습니다."
        ),
        "ros2 topic hz /joint_states": Text(
            en="joint states move only what has a joint.", ko="관절 상태는 관절이 있는 것만 움직입니다."
        ),
        "ros2 topic delay /scan": Text(
            en="the scan's age explains only what is wrong while the robot moves.",
            ko="스캔의 나이는 로봇이 움직일 때만 틀리는 것을 설명합니다.",
        ),
        "tf2_echo base_link laser_frame": Text(
            en="the mount explains only what is off by the same at all times.",
            ko="장착 변환은 언제나 같은 만큼 벗어나는 것만 설명합니다.",
        ),
        "replace the sensor": Text(
            en="a purchase is no first check: what costs a minute?",
            ko="부품 구입은 첫 점검이 아닙니다. 1분이면 되는 것은 무엇입니까?",
        ),
        "a longer timeout": Text(
            en="waiting shows nothing: what is not sent does not come, and what is sent with a wrong stamp, name or value stays so.",
            ko="기다려서는 아무것도 알 수 없습니다. 보내지 않은 것은 오지 않고, 시각이나 이름, 값이 틀린 것은 틀린 채로 옵니다.",
        ),
        "no check": Text(en="something is wrong here.", ko="여기에는 잘못이 있습니다."),
    },
    hints=(
        Text(
            en="Begin at the top: the global status, then which displays fail, then which links.",
            ko="위에서부터 보세요. Global Status, 실패한 디스플레이, 실패한 링크의 순서입니다.",
        ),
        Text(
            en="Does not exist: is there a name like it below TF? Not part of the same tree: between which two frames is the gap?",
            ko="does not exist라면 TF 목록에 비슷한 이름이 있습니까? not part of the same tree라면 어느 두 좌표계 사이가 끊겼습니까?",
        ),
        Text(
            en="All Ok: off at all times is a place, off in bends is a time.",
            ko="모두 Ok일 때, 언제나 벗어나면 위치의 문제이고 굽은 길에서만 벗어나면 시각의 문제입니다.",
        ),
    ),
    misconceptions=("M9", "M10", "M11", "M15"),
)
