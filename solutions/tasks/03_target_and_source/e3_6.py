"""E3.6: Bolt the camera on."""

from __future__ import annotations

import math

import numpy as np

from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Message, Task, Twin, Words

from .draws import some_yaw_degrees


def mount_inputs(rng: np.random.Generator) -> list[tuple]:
    cases = [(int(rng.integers(5, 40)) / 100, int(rng.integers(20, 60)) / 100, some_yaw_degrees(rng)) for _ in range(4)]
    return [*cases, (0.10, 0.30, 0), (0.10, 0.30, 90)]


def camera_message(parent: str, child: str, ahead_m: float, up_m: float, xyzw) -> geometry_msgs.TransformStamped:
    t = geometry_msgs.TransformStamped()
    t.header.frame_id, t.child_frame_id = parent, child
    t.transform.translation.x, t.transform.translation.z = float(ahead_m), float(up_m)
    q = t.transform.rotation
    q.x, q.y, q.z, q.w = map(float, xyzw)
    return t


def half_turn(yaw: float) -> tuple[float, float]:
    return math.sin(yaw / 2), math.cos(yaw / 2)


def parent_and_child_swapped(ahead_m, up_m, yaw_deg):
    z, w = half_turn(math.radians(yaw_deg))
    return camera_message("camera_link", "base_link", ahead_m, up_m, (0, 0, z, w))


PARENT_AND_CHILD_SWAPPED = Twin(
    "parent_and_child_swapped",
    parent_and_child_swapped,
    Words(
        en="parent and child are swapped: this says that the robot is bolted onto the camera. The parent "
        "is `header.frame_id`, and the numbers are measured in it.",
        ko="부모와 자식이 바뀌었습니다. 로봇을 카메라에 달았다는 뜻이 됩니다. 부모는 `header.frame_id`이고, "
        "숫자는 부모에서 잽니다.",
    ),
    "M2",
)


def in_degrees(ahead_m, up_m, yaw_deg):
    z, w = half_turn(yaw_deg)
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, w))


DEGREES = Twin(
    "degrees",
    in_degrees,
    Words(
        en="your angle went into sin and cos in degrees. Python and ROS count in radians (REP-103): `math.radians`.",
        ko="각도를 도(degree) 그대로 sin과 cos에 넣었습니다. 파이썬과 ROS는 라디안을 씁니다(REP-103). "
        "`math.radians`를 쓰십시오.",
    ),
    "M5",
)


def without_the_half(ahead_m, up_m, yaw_deg):
    z, w = half_turn(2 * math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, w))


WHOLE_ANGLE = Twin(
    "whole_angle",
    without_the_half,
    Words(
        en="the camera is turned twice as far as asked: a quaternion holds the sine and cosine of half the angle.",
        ko="카메라가 두 배로 돌아갔습니다. 쿼터니언에는 각도의 절반에 대한 sin과 cos을 넣습니다.",
    ),
    "M5",
)


def w_first(ahead_m, up_m, yaw_deg):
    z, w = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (w, 0, 0, z))


W_FIRST = Twin(
    "w_first",
    w_first,
    Words(
        en="your quaternion has w first. ROS writes (x, y, z, w), so this camera lies on its side.",
        ko="쿼터니언에 w를 먼저 썼습니다. ROS는 (x, y, z, w) 순서이므로 이 카메라는 옆으로 누워 버립니다.",
    ),
    "M5",
)


def to_the_right(ahead_m, up_m, yaw_deg):
    z, w = half_turn(-math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, w))


TO_THE_RIGHT = Twin(
    "to_the_right",
    to_the_right,
    Words(
        en="your camera turns to the right. A turn to the left is positive: check the sign of the angle.",
        ko="카메라가 오른쪽으로 돌아갑니다. 왼쪽으로 도는 회전이 양수입니다. 각도의 부호를 확인하십시오.",
    ),
)


def not_turned(ahead_m, up_m, yaw_deg):
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, 0, 1))


NOT_TURNED = Twin(
    "not_turned",
    not_turned,
    Words(
        en="the camera is in its place, but it looks straight ahead: the rotation is still the one that a "
        "new message has.",
        ko="카메라가 제자리에 있지만 똑바로 앞을 봅니다. 회전이 새 메시지의 값 그대로입니다.",
    ),
)


def rolled(ahead_m, up_m, yaw_deg):
    x, w = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (x, 0, 0, w))


ROLLED = Twin(
    "rolled",
    rolled,
    Words(
        en="the camera is rolled onto its side: the sine stands in x. Which axis does a turn to the left go about?",
        ko="카메라가 옆으로 기울었습니다. sin이 x 자리에 있습니다. 왼쪽으로 도는 회전의 축은 무엇입니까?",
    ),
)


def angle_in_z(ahead_m, up_m, yaw_deg):
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, math.radians(yaw_deg), 1))


ANGLE_IN_Z = Twin(
    "angle_in_z",
    angle_in_z,
    Words(
        en="you wrote the angle itself into z. A quaternion holds no angle: z takes the sine of half of it, "
        "w the cosine.",
        ko="z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 "
        "cos을 넣으십시오.",
    ),
    "M5",
)


def w_still_one(ahead_m, up_m, yaw_deg):
    z, _ = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, z, 1))


W_STILL_ONE = Twin(
    "w_still_one",
    w_still_one,
    Words(
        en="z is right, and w is still the 1 of a new message: it takes the cosine of half the angle.",
        ko="z는 맞지만 w가 새 메시지의 값 1 그대로입니다. w에는 각도 절반의 cos을 넣으십시오.",
    ),
    "M5",
)


def ahead_and_up_swapped(ahead_m, up_m, yaw_deg):
    z, w = half_turn(math.radians(yaw_deg))
    return camera_message("base_link", "camera_link", up_m, ahead_m, (0, 0, z, w))


AHEAD_AND_UP_SWAPPED = Twin(
    "ahead_and_up_swapped",
    ahead_and_up_swapped,
    Words(
        en="the two steps have changed places. Which axis of the body points ahead, and which one up?",
        ko="두 이동의 자리가 바뀌었습니다. 본체의 어느 축이 앞을, 어느 축이 위를 향합니까?",
    ),
)


def zero_quaternion(ahead_m, up_m, yaw_deg):
    return camera_message("base_link", "camera_link", ahead_m, up_m, (0, 0, 0, 0))


ZERO_QUATERNION = Twin(
    "zero_quaternion",
    zero_quaternion,
    Words(
        en="the rotation is all zeros. That is no rotation at all: every listener refuses the message, and "
        "camera_link never appears.",
        ko="회전이 모두 0입니다. 이것은 회전이 아니므로 모든 수신기가 메시지를 거절하고, camera_link는 끝내 "
        "나타나지 않습니다.",
    ),
    "M5",
)


TASK = Task(
    id="E3.6",
    kind="C",
    points=4,
    title=Words(en="Bolt the camera on", ko="카메라 달기"),
    answer="camera_mount",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation"),
    ),
    inputs=mount_inputs,
    variants=3,
    twins=(
        PARENT_AND_CHILD_SWAPPED,
        DEGREES,
        WHOLE_ANGLE,
        W_FIRST,
        TO_THE_RIGHT,
        ROLLED,
        ANGLE_IN_Z,
        W_STILL_ONE,
        AHEAD_AND_UP_SWAPPED,
        NOT_TURNED,
        ZERO_QUATERNION,
    ),
    hints=(
        Words(
            en="Which frame holds the numbers? That one is the parent, `header.frame_id`.",
            ko="숫자를 잰 좌표계는 어느 쪽입니까? 그쪽이 부모, `header.frame_id`입니다.",
        ),
        Words(
            en="A turn to the left by an angle is z = sin(half of it), w = cos(half of it), and x = y = 0.",
            ko="왼쪽으로 어떤 각도만큼 돌면 z = sin(그 절반), w = cos(그 절반), x = y = 0입니다.",
        ),
        Words(
            en="ahead is x, up is z. Message fields want floats, so write `float(...)` around what may be an int.",
            ko="앞은 x, 위는 z입니다. 메시지 필드는 float를 받으므로 int일 수 있는 값은 `float(...)`로 감싸십시오.",
        ),
    ),
    cures=("M2", "M5"),
)
