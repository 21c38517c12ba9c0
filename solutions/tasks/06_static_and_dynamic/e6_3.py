"""E6.3: One letter for all mounts."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.ros.messages import builtin_interfaces, geometry_msgs
from tflab.workbook.tasks import Message, Sequence, Task, Text, WrongStep

NAMES = ("camera_left", "camera_right", "laser_frame", "imu_link", "sonar_link", "gps_link")


def lists_of_mounts(rng):
    """One to four mounts, turned about all three axes, of several parents; stamps with a part of a second."""
    return [(_mounts(rng, count), _stamp(rng)) for count in (4, 1, 3, 2, 3)]


def _mounts(rng, count):
    names = [str(name) for name in rng.choice(NAMES, count, replace=False)]
    rows = []
    for place, child in enumerate(names):
        way = [float(rng.choice([-1.0, 1.0])) for _ in range(3)]
        rpy = [round(w * float(rng.uniform(0.3, 1.1)), 2) for w in way]
        xyz = [round(w * float(rng.uniform(0.05, 0.6)), 2) for w in reversed(way)]
        rows.append({"parent": "mast_link" if place == 2 else "base_link", "child": child, "xyz": xyz, "rpy": rpy})
    return rows


def _stamp(rng):
    return builtin_interfaces.Time(sec=int(rng.integers(20, 90)), nanosec=int(rng.integers(1, 999)) * 1_000_000)


def message(mount, stamp, ends, moment, place, order, angle, quaternion):
    t = geometry_msgs.TransformStamped()
    t.header.stamp = builtin_interfaces.Time() if moment == "zero" else stamp
    parent, child = mount["parent"], mount["child"]
    names = {"child first": (child, parent), "base_link": ("base_link", child), "no child": (parent, "")}
    t.header.frame_id, t.child_frame_id = names.get(ends, (parent, child))
    step = t.transform.translation
    step.x, step.y, step.z = (0.0, 0.0, 0.0) if place == "none" else mount["xyz"]
    angles = [math.radians(a) if angle == "degrees" else a for a in mount["rpy"]]
    angles = angles[::-1] if order == "yaw first" else angles
    roll, pitch, yaw = (angles[1], angles[0], angles[2]) if order == "pitch first" else angles
    pitch, yaw = (yaw, pitch) if order == "yaw second" else (pitch, yaw)
    x, y, z, w = Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw).rotation
    only_yaw = (0.0, 0.0, math.sin(angles[2] / 2), math.cos(angles[2] / 2))
    ways = {"xyzw": (x, y, z, w), "w first": (w, x, y, z), "taken for w first": (y, z, w, x), "none": (0.0, 0.0, 0.0, 1.0), "angles": (*angles, 1.0),
            "w left out": (x, y, z, 1.0), "w for z": (x, y, w, 1.0), "z left out": (x, y, 0.0, w), "half angles": (*(math.sin(a / 2) for a in angles), 1.0),
            "yaw alone": only_yaw, "inverse": (-x, -y, -z, w)}  # fmt: skip
    turn = t.transform.rotation
    turn.x, turn.y, turn.z, turn.w = ways[quaternion]
    return t


def letters(mounts, stamp, *, which="all", objects="each its own", ends="parent first", moment="given",
            place="given", order="roll first", angle="radians", quaternion="xyzw"):  # fmt: skip
    """Return the list for one sendTransform, step by step; other steps are the slips."""
    rows = {
        "all": mounts,
        "last": mounts[-1:],
        "first": mounts[:1],
        "reversed": mounts[::-1],
        "by name": sorted(mounts, key=lambda mount: mount["child"]),
    }[which]
    rows = [rows[-1]] * len(rows) if objects == "one" else rows
    moments = ["zero" if moment == "first alone" and number else moment for number in range(len(rows))]
    return [
        message(row, stamp, ends, each, place, order, angle, quaternion)
        for row, each in zip(rows, moments, strict=True)
    ]


ONE_OBJECT = WrongStep(
    "one object",
    {"objects": "one"},
    Text(
        en="All messages of your list are the last one, as when one TransformStamped is appended again and again, and each round writes over it. Make a new one inside the loop.",
        ko="리스트의 메시지가 모두 마지막 것과 같습니다. TransformStamped 하나를 거듭 넣고 매번 덮어쓰면 이렇게 됩니다. 반복문 안에서 새로 만드십시오.",
    ),
)

LAST_ONLY = WrongStep(
    "last only",
    {"which": "last"},
    Text(
        en="Only the last mount is in the letter: the robot of the story, with one camera left. Collect in a list, return it after the loop.",
        ko="마지막 장착 위치만 들어 있습니다. 카메라 한 대만 남은 이야기 속 로봇입니다. 리스트에 모으고 반복문이 끝난 뒤에 반환하십시오.",
    ),
    "M12",
)

FIRST_ONLY = WrongStep(
    "first only",
    {"which": "first"},
    Text(
        en="Only the first mount is in the letter, as when the `return` stands inside the loop. Collect them all, and return the list after it.",
        ko="첫 장착 위치만 들어 있습니다. `return`이 반복문 안에 있으면 이렇게 됩니다. 모두 모은 다음 반복문이 끝나고 반환하십시오.",
    ),
)

REVERSED = WrongStep(
    "reversed",
    {"which": "reversed"},
    Text(
        en="The mounts are all there, in the reverse order; here they are wanted in the order of the rows.",
        ko="모두 들어 있지만 순서가 거꾸로입니다. 여기서는 행의 순서대로 넣으십시오.",
    ),
)

SWAPPED = WrongStep(
    "swapped",
    {"ends": "child first"},
    Text(
        en="Parent and child are swapped: the parent is `header.frame_id`, and the numbers are measured in it.",
        ko="부모와 자식이 바뀌었습니다. 부모는 `header.frame_id`이고 숫자는 부모에서 잽니다.",
    ),
    "M2",
)

ALWAYS_BASE_LINK = WrongStep(
    "always base_link",
    {"ends": "base_link"},
    Text(
        en="Every parent is base_link. Look at the rows: one of them sits on something else.",
        ko="부모가 모두 base_link입니다. 행을 보세요. 다른 것에 달린 것도 있습니다.",
    ),
)

NO_CHILD = WrongStep(
    "no child",
    {"ends": "no child"},
    Text(
        en="`child_frame_id` is empty. It stands beside the header, not in it.",
        ko="`child_frame_id`가 비어 있습니다. header 안이 아니라 header 옆에 있는 필드입니다.",
    ),
)

NOT_MOVED = WrongStep(
    "not moved",
    {"place": "none"},
    Text(
        en="The translations are all zero: `xyz` has not gone in.",
        ko="이동이 모두 0입니다. `xyz`를 넣지 않았습니다.",
    ),
)

NO_STAMP = WrongStep(
    "no stamp",
    {"moment": "zero"},
    Text(
        en="`header.stamp` is still zero. tf2 takes that for a static transform, and whoever reads the message learns nothing of when it was made.",
        ko="`header.stamp`가 0 그대로입니다. 정적 변환이라 tf2는 받아 주지만, 언제 만든 것인지 아무도 알 수 없습니다.",
    ),
)

YAW_FIRST = WrongStep(
    "yaw first",
    {"order": "yaw first"},
    Text(
        en="Roll and yaw have changed places: `rpy` is roll, pitch, yaw in this order.",
        ko="roll과 yaw가 바뀌었습니다. `rpy`는 roll, pitch, yaw 순서입니다.",
    ),
    "M5",
)

CONVERTED_TWICE = WrongStep(
    "converted twice",
    {"angle": "degrees"},
    Text(
        en="The angles are radians already. Multiplied by π/180 once more, as `math.radians` does, they are almost nothing.",
        ko="각도는 이미 라디안입니다. `math.radians`처럼 π/180을 한 번 더 곱하면 거의 0이 됩니다.",
    ),
    "M5",
)

W_FIRST = WrongStep(
    "w first",
    {"quaternion": "w first"},
    Text(
        en="Your quaternion has w first. ROS, and `.rotation`, have (x, y, z, w).",
        ko="쿼터니언에 w를 먼저 썼습니다. ROS와 `.rotation`은 (x, y, z, w) 순서입니다.",
    ),
    "M5",
)

NOT_TURNED = WrongStep(
    "not turned",
    {"quaternion": "none"},
    Text(
        en="Nothing is turned: the rotation is still the one of a new message.",
        ko="아무것도 돌아가지 않았습니다. 회전이 새 메시지의 값 그대로입니다.",
    ),
)

ANGLES_AS_QUATERNION = WrongStep(
    "angles as quaternion",
    {"quaternion": "angles"},
    Text(
        en="Roll, pitch and yaw went into x, y and z themselves. A quaternion holds no angles; `Transform.from_rpy(…).rotation` makes one.",
        ko="roll, pitch, yaw를 x, y, z에 그대로 넣었습니다. 쿼터니언의 성분은 각도가 아닙니다. `Transform.from_rpy(…).rotation`으로 만드십시오.",
    ),
    "M5",
)

YAW_ALONE = WrongStep(
    "yaw alone",
    {"quaternion": "yaw alone"},
    Text(
        en="Only the yaw has gone into the quaternion. These mounts are rolled and pitched as well.",
        ko="쿼터니언에 yaw만 들어갔습니다. 이 장착 위치들은 roll과 pitch도 있습니다.",
    ),
)

INVERSE_TURN = WrongStep(
    "inverse turn",
    {"quaternion": "inverse"},
    Text(
        en="The rotations are turned round: that is the parent as the child sees it.",
        ko="회전이 뒤집혔습니다. 자식에서 본 부모의 방향입니다.",
    ),
    "M3",
)


SORTED_BY_NAME = WrongStep(
    "sorted by name",
    {"which": "by name"},
    Text(
        en="The mounts are all there, sorted by name. Here they are wanted in the order of the rows.",
        ko="장착 위치가 모두 있지만 이름순입니다. 여기서는 주어진 줄의 순서로 필요합니다.",
    ),
)


FIRST_STAMP_ALONE = WrongStep(
    "first stamp alone",
    {"moment": "first alone"},
    Text(
        en="Only the first message has its stamp. Each message has a header of its own: write it inside the loop.",
        ko="첫 메시지에만 시각이 있습니다. 메시지마다 헤더가 따로 있으므로 반복문 안에서 쓰십시오.",
    ),
)


PITCH_FIRST = WrongStep(
    "pitch first",
    {"order": "pitch first"},
    Text(
        en="Roll and pitch have changed places: `rpy` is roll, pitch, yaw in this order.",
        ko="roll과 pitch의 자리가 바뀌었습니다. `rpy`는 roll, pitch, yaw 순서입니다.",
    ),
    "M5",
)


TAKEN_FOR_W_FIRST = WrongStep(
    "taken for w first",
    {"quaternion": "taken for w first"},
    Text(
        en="You wrote `.rotation` to w, x, y, z in this order, and it comes as (x, y, z, w): each number stands one place off.",
        ko="`.rotation`은 (x, y, z, w)로 나오는데 w, x, y, z의 순서로 넣었습니다. 숫자가 모두 한 자리씩 밀렸습니다.",
    ),
    "M5",
)


YAW_SECOND = WrongStep(
    "yaw second",
    {"order": "yaw second"},
    Text(
        en="Pitch and yaw have changed places: `rpy` is roll, pitch, yaw in this order.",
        ko="pitch와 yaw의 자리가 바뀌었습니다. `rpy`는 roll, pitch, yaw 순서입니다.",
    ),
)


W_LEFT_OUT = WrongStep(
    "w left out",
    {"quaternion": "w left out"},
    Text(
        en="x, y and z of the quaternion are there, and w is still the 1 of a new message. All four are needed: `.rotation` ends with w.",
        ko="쿼터니언의 x, y, z는 들어 있는데 w는 새 메시지의 1 그대로입니다. 넷이 모두 필요합니다. `.rotation`의 마지막이 w입니다.",
    ),
    "M5",
)


W_WRITTEN_TO_Z = WrongStep(
    "w written to z",
    {"quaternion": "w for z"},
    Text(
        en="z of the quaternion holds what belongs to w, and w is still 1. Four numbers, four fields: is one of them written twice?",
        ko="쿼터니언의 z에 w의 값이 들어 있고 w는 아직 1입니다. 숫자도 네 개, 항목도 네 개입니다. 한 항목에 두 번 썼습니까?",
    ),
    "M5",
)


Z_LEFT_OUT = WrongStep(
    "z left out",
    {"quaternion": "z left out"},
    Text(
        en="z of the quaternion is still 0. All four numbers of `.rotation` have to be written.",
        ko="쿼터니언의 z가 아직 0입니다. `.rotation`의 숫자 네 개를 모두 써야 합니다.",
    ),
    "M5",
)


TASK = Task(
    id="E6.3",
    kind="F",
    points=4,
    title=Text(en="One letter for all mounts", ko="모든 장착 위치를 쪽지 하나에"),
    answer="letter",
    form=Sequence(
        Message(
            "geometry_msgs/msg/TransformStamped",
            ("header.stamp", "header.frame_id", "child_frame_id", "transform.translation", "transform.rotation"),
        )
    ),
    inputs=lists_of_mounts,
    variants=3,
    model=letters,
    mistakes=(
        ONE_OBJECT,
        LAST_ONLY,
        FIRST_ONLY,
        REVERSED,
        SWAPPED,
        ALWAYS_BASE_LINK,
        NO_CHILD,
        NOT_MOVED,
        NO_STAMP,
        YAW_FIRST,
        CONVERTED_TWICE,
        W_FIRST,
        NOT_TURNED,
        ANGLES_AS_QUATERNION,
        YAW_ALONE,
        INVERSE_TURN,
        SORTED_BY_NAME,
        FIRST_STAMP_ALONE,
        PITCH_FIRST,
        TAKEN_FOR_W_FIRST,
        YAW_SECOND,
        W_LEFT_OUT,
        W_WRITTEN_TO_Z,
        Z_LEFT_OUT,
    ),
    hints=(
        Text(
            en="A list, one TransformStamped for each row: begin with an empty list, append inside the loop, return after it.",
            ko="행마다 TransformStamped 하나씩 담긴 리스트입니다. 빈 리스트로 시작해 반복문 안에서 넣고, 끝난 뒤에 반환하십시오.",
        ),
        Text(
            en="Make the TransformStamped *inside* the loop: what is appended is the object, not a copy of it.",
            ko="TransformStamped를 반복문 *안에서* 만드십시오. append는 복사본이 아니라 그 객체를 넣습니다.",
        ),
        Text(
            en="`roll, pitch, yaw = mount['rpy']`, then `Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw).rotation` is (x, y, z, w).",
            ko="`roll, pitch, yaw = mount['rpy']`로 받아 `Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw).rotation`을 구하면 (x, y, z, w)입니다.",
        ),
    ),
    misconceptions=("M2", "M5", "M12"),
)
