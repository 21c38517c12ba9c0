"""E7.4: Five robots with something missing, or beside its place."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

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


def five_robots(rng):
    """Each has one cause; which letter has which is drawn, and so are names, stamps and turns."""
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
        "no driver": f"{APART}\n$ ros2 topic info /joint_states\nType: sensor_msgs/msg/JointState\nPublisher count: 0\nSubscription count: 1",
        "paint moved": f'{WHOLE}\n{joint} rpy="0 0 0"/> </joint>\n{visual}\n{echoed((x, 0, z), 0.0)}',
        "degrees": f'{WHOLE}\n{joint} rpy="0 0 {degrees}"/> </joint>\n{echoed((x, 0, z), turned)}',
    }  # fmt: skip
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
    """Return what is said and done of each robot."""
    causes = {letter: cause_of(getattr(g, letter)) for letter in ROBOTS}
    return {**{r: say(cause) for r, cause in causes.items()}, **{f"{r} do": do(cause) for r, cause in causes.items()}}


ARMS = ("other names", "stamp zero", "no driver")
SENSORS = ("paint moved", "degrees")

ALWAYS_A_DRIVER = WrongAnswer(
    "always a driver",
    lambda g: answers(g, lambda cause: "no driver" if cause in ARMS else cause),
    Text(
        en="Not every arm that is missing lacks its driver: two of the three do publish. Read their messages: stamp, then names.",
        ko="팔이 빠졌다고 모두 드라이버가 없는 것은 아닙니다. 셋 중 둘은 발행하고 있습니다. 메시지의 시각과 이름을 차례로 읽어 보십시오.",
    ),
    "M11",
)

STAMP_FOR_NAMES = WrongAnswer(
    "stamp overlooked",
    lambda g: answers(g, lambda cause: "other names" if cause in ARMS[:2] else cause),
    Text(
        en="One of the two drivers that do publish has its names right, letter for letter. What else does its message hold?",
        ko="발행하는 두 드라이버 가운데 하나는 이름이 글자까지 맞습니다. 메시지에 또 무엇이 있습니까?",
    ),
)

RVIZ_FOR_ALL = WrongAnswer(
    "restart RViz",
    lambda g: answers(g, do=lambda cause: "restart RViz"),
    Text(
        en="RViz only draws what it is given. None of these is in RViz, and all come back when it does.",
        ko="RViz는 받은 것을 그릴 뿐입니다. 이 가운데 RViz에 있는 문제는 없고, 다시 켜도 그대로입니다.",
    ),
    "M15",
)

CABLE_FOR_SENSORS = WrongAnswer(
    "cable for sensors",
    lambda g: answers(g, do=lambda cause: "change the cable" if cause in SENSORS else MENDS[cause]),
    Text(
        en="Both lasers measure. What is wrong is where they are said to be, and that stands in a file.",
        ko="두 레이저 모두 측정하고 있습니다. 틀린 것은 어디에 있다고 적혀 있는가이고, 그것은 파일에 있습니다.",
    ),
    "M15",
)

WAIT_FOR_ARMS = WrongAnswer(
    "wait for the arms",
    lambda g: answers(g, do=lambda cause: "wait longer" if cause in ARMS else MENDS[cause]),
    Text(
        en="Waiting brings no joint that nobody publishes, or that is passed over each time.",
        ko="아무도 발행하지 않거나 매번 지나치는 관절은 기다려도 오지 않습니다.",
    ),
    "M10",
)


TASK = Task(
    id="E7.4",
    kind="D",
    points=5,
    title=Text(en="Five robots", ko="다섯 로봇"),
    answer="findings",
    form=Parts(
        {
            **{robot: Choice(CAUSES) for robot in ROBOTS},
            **{f"{robot} do": Choice((*MENDS.values(), *OTHERS)) for robot in ROBOTS},
        }
    ),
    given=five_robots,
    variants=6,
    mistakes=(ALWAYS_A_DRIVER, STAMP_FOR_NAMES, RVIZ_FOR_ALL, CABLE_FOR_SENSORS, WAIT_FOR_ARMS),
    means={
        "other names": Text(
            en="then /joint_states would name joints that the URDF has not got (its own are shoulder_joint, elbow_joint, wrist_joint).",
            ko="그렇다면 /joint_states에 URDF에 없는 관절 이름이 있어야 합니다(URDF의 이름은 shoulder_joint, elbow_joint, wrist_joint입니다).",
        ),
        "stamp zero": Text(
            en="then the header of its joint states would hold sec: 0.",
            ko="그렇다면 관절 메시지의 header가 sec: 0이어야 합니다.",
        ),
        "no driver": Text(
            en="then nobody would publish on /joint_states: a count of 0, and nothing to echo.",
            ko="그렇다면 /joint_states를 아무도 발행하지 않아야 합니다. 발행자 수가 0이고 echo할 것이 없습니다.",
        ),
        "paint moved": Text(
            en="then the turn would stand in a <visual>, and tf2_echo would know nothing of it.",
            ko="그렇다면 회전이 <visual>에 있고, tf2_echo에는 나타나지 않아야 합니다.",
        ),
        "degrees": Text(
            en="then the joint's rpy would hold a number far beyond 3.14, and tf2_echo another turn than was meant.",
            ko="그렇다면 관절의 rpy에 3.14를 훨씬 넘는 숫자가 있고, tf2_echo의 각도는 뜻한 것과 달라야 합니다.",
        ),
        "use the URDF's names": Text(
            en="that is for messages whose names the URDF has not got.",
            ko="메시지의 이름이 URDF에 없을 때 하는 일입니다.",
        ),
        "stamp the message": Text(
            en="that is for joint states that carry no time.", ko="관절 메시지에 시각이 없을 때 하는 일입니다."
        ),
        "start the joint driver": Text(
            en="that helps where nobody publishes.", ko="아무도 발행하지 않을 때 도움이 됩니다."
        ),
        "write it into the joint": Text(
            en="that is for a turn which stands in the <visual>.", ko="회전이 <visual>에 있을 때 하는 일입니다."
        ),
        "write radians": Text(
            en="that is for an rpy that was written in degrees.", ko="rpy를 도(degree)로 썼을 때 하는 일입니다."
        ),
        "restart RViz": Text(
            en="RViz only draws what it is given; started again, it is given the same.",
            ko="RViz는 받은 것을 그릴 뿐입니다. 다시 켜도 받는 것은 똑같습니다.",
        ),
        "change the cable": Text(
            en="no cable is to blame: with a new one the report reads the same.",
            ko="케이블 탓이 아닙니다. 새것으로 바꾸어도 보고는 똑같습니다.",
        ),
        "wait longer": Text(
            en="waiting changes nothing of it; it will look the same in an hour.",
            ko="기다려도 달라지지 않습니다. 한 시간 뒤에도 똑같습니다.",
        ),
    },
    seen={
        "other names": Text(
            en="Here somebody publishes, and with a time; hold the names against the URDF's, letter by letter.",
            ko="여기서는 발행하고 있고 시각도 있습니다. 이름을 URDF의 이름과 한 글자씩 견주어 보십시오.",
        ),
        "stamp zero": Text(
            en="Here somebody publishes, and under the right names; read the line above them.",
            ko="여기서는 발행하고 있고 이름도 맞습니다. 그 윗줄을 읽어 보십시오.",
        ),
        "no driver": Text(
            en="Here it was asked who publishes: read the count.",
            ko="여기서는 누가 발행하는지 물었습니다. 그 수를 읽어 보십시오.",
        ),
        "paint moved": Text(
            en="Here the joint's own rpy is zero, and the turn stands somewhere else.",
            ko="여기서는 관절의 rpy가 0이고, 회전은 다른 곳에 있습니다.",
        ),
        "degrees": Text(
            en="Here the turn stands in the joint, as a number of many whole turns if it were radians.",
            ko="여기서는 회전이 관절에 있는데, 라디안이라면 여러 바퀴가 되는 숫자입니다.",
        ),
        "use the URDF's names": Text(
            en="Here the message is lively and stamped, and the joints that it names move nothing.",
            ko="여기서는 메시지가 오고 시각도 있지만, 메시지에 적힌 관절로는 아무것도 움직이지 않습니다.",
        ),
        "stamp the message": Text(
            en="Here names and positions are right, and each message is passed over for what its header says.",
            ko="여기서는 이름과 위치가 맞지만, header 때문에 메시지가 매번 무시됩니다.",
        ),
        "start the joint driver": Text(
            en="Here nothing is sent that could be wrong.",
            ko="여기서는 틀릴 만한 것조차 아무것도 오지 않습니다.",
        ),
        "write it into the joint": Text(
            en="Here the tree holds no turn at all, though one is drawn.",
            ko="여기서는 회전이 그려져 보이는데도 트리에는 없습니다.",
        ),
        "write radians": Text(
            en="Here the tree holds a turn, of another size than the file's number was meant to be.",
            ko="여기서는 트리에 회전이 있지만, 파일의 숫자로 뜻한 크기가 아닙니다.",
        ),
    },
    hints=(
        Text(
            en="In which trees is the hand without an arm? There, ask who publishes /joint_states, and what.",
            ko="손에 팔이 없는 트리는 어느 것입니까? 거기서는 누가 무엇을 /joint_states로 발행하는지 보십시오.",
        ),
        Text(
            en="A JointState needs the URDF's names, a stamp and positions. Which of the three is missing?",
            ko="JointState에는 URDF의 이름, 시각, 위치가 있어야 합니다. 셋 가운데 무엇이 빠졌습니까?",
        ),
        Text(
            en="Where the tree is whole: is the turn in the joint or in the visual, and is it in radians?",
            ko="트리가 온전하다면 회전이 관절에 있습니까, visual에 있습니까? 단위는 라디안입니까?",
        ),
    ),
    misconceptions=("M10", "M11", "M15"),
)  # fmt: skip
