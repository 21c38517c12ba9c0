"""E3.6: Bolt the camera on."""

from __future__ import annotations

import math
from functools import partial

from tflab.core import Transform
from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Draws, Message, Task, Text, WrongAnswer, WrongStep

from .draws import some_yaw_degrees


def mount_inputs(rng: Draws) -> list[tuple]:
    cases = [(int(rng.integers(5, 40)) / 100, int(rng.integers(20, 60)) / 100, some_yaw_degrees(rng)) for _ in range(4)]
    return [*cases, (0.10, 0.30, 0), (0.10, 0.30, 90), (1, 2, 30), (0.25, 0.40, 22.5)]


def camera_message(parent: str, child: str, ahead_m: float, up_m: float, xyzw) -> geometry_msgs.TransformStamped:
    t = geometry_msgs.TransformStamped()
    t.header.frame_id, t.child_frame_id = parent, child
    t.transform.translation.x, t.transform.translation.z = float(ahead_m), float(up_m)
    q = t.transform.rotation
    q.x, q.y, q.z, q.w = map(float, xyzw)
    return t


OPTICAL = Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)


def half_turn(yaw: float) -> tuple[float, float]:
    return math.sin(yaw / 2), math.cos(yaw / 2)


def mounted(ahead_m, up_m, yaw_deg, *, ends="parent first", numbers="as given", axes="x and z", length="m",
            angle="radians", side="left", half="halved", quaternion="sine", stamp="kept"):  # fmt: skip
    """Return the message, step by step; other steps are the slips."""
    parent, child = ("camera_link", "base_link") if ends == "child first" else ("base_link", "camera_link")
    child = "camera_optical_frame" if ends == "optical" else child
    child = {"camera": "camera", "laser": "laser_frame"}.get(ends, child)
    parent = {"map": "map", "odom": "odom", "base": "base", "footprint": "base_footprint",
              "laser below": "laser_frame"}.get(ends, parent)  # fmt: skip
    yaw = {"degrees": yaw_deg, "radians": math.radians(yaw_deg), "to degrees": math.degrees(yaw_deg),
           "whole degrees": math.radians(int(yaw_deg)),
           "half cut off": math.radians(2 * (yaw_deg // 2)), "no pi": yaw_deg / 180,
           "twice": math.radians(math.radians(yaw_deg)),
           "halved": math.radians(yaw_deg) / 2}[angle]  # fmt: skip
    yaw = -yaw if side == "right" else yaw
    z, w = half_turn(2 * yaw if half == "whole" else yaw)
    ways = {"sine": (0, 0, z, w), "w first": (w, 0, 0, z), "none": (0, 0, 0, 1), "roll": (z, 0, 0, w), "pitch": (0, z, 0, w),
            "angle": (0, 0, yaw, 1), "degrees": (0, 0, yaw_deg, 1), "half in z": (0, 0, z, math.cos(yaw)), "half in w": (0, 0, math.sin(yaw), w),
            "w lost": (0, 0, z, 0),  "w one": (0, 0, z, 1), "zero": (0, 0, 0, 0), "exchanged": (0, 0, w, z),
            "optical": (Transform(rotation=(0, 0, z, w)) @ OPTICAL).rotation}  # fmt: skip
    x, y, up = {"x and z": (ahead_m, 0.0, up_m), "exchanged": (up_m, 0.0, ahead_m), "y": (ahead_m, up_m, 0.0),
                "optical": (0.0, -up_m, ahead_m), "minus y": (ahead_m, -up_m, 0.0), "y ahead": (0.0, ahead_m, up_m),
                "y up, z ahead": (0.0, up_m, ahead_m), "ahead twice": (ahead_m, 0.0, ahead_m),
                "up twice": (up_m, 0.0, up_m), "ahead in y too": (ahead_m, ahead_m, up_m),
                "up in y too": (ahead_m, up_m, up_m)}[axes]  # fmt: skip
    if numbers == "inverse":
        back = Transform(rotation=(0, 0, *half_turn(yaw)), translation=(x, y, up)).inverse()
        (x, y, up), ways["sine"] = back.translation, back.rotation
    if numbers == "turned":
        x, y, up = Transform(rotation=(0, 0, *half_turn(yaw))).apply((x, y, up))
    if numbers == "turned back":
        x, y, up = Transform(rotation=(0, 0, *half_turn(-yaw))).apply((x, y, up))
    if numbers == "negative":
        x, y, up = -x, -y, -up
    scale = 1000.0 if length == "mm" else 1.0
    t = camera_message(parent, child, scale * x, scale * up, ways[quaternion])
    t.transform.translation.y = scale * y
    t.header.stamp.sec = 1 if stamp == "set" else 0
    return t


PARENT_AND_CHILD_SWAPPED = WrongStep(
    "parent_and_child_swapped",
    {"ends": "child first"},
    Text(
        en="parent and child are swapped: this says that the robot is bolted onto the camera. The parent "
        "is `header.frame_id`, and the numbers are measured in it.",
        ko="부모와 자식이 바뀌었습니다. 로봇을 카메라에 달았다는 뜻이 됩니다. 부모는 `header.frame_id`이고, "
        "숫자는 부모에서 잽니다.",
    ),
    "M2",
)


OFFSET_TURNED = WrongStep(
    "offset turned along",
    {"numbers": "turned"},
    Text(
        en="you turned the offset along with the camera. It is measured along the axes of `base_link`: however the "
        "camera is turned, it sits in the same place.",
        ko="카메라의 회전만큼 위치까지 돌렸습니다. 위치는 `base_link`의 축을 따라 잰 것이므로, 카메라가 어느 쪽을 보든 "
        "달린 자리는 같습니다.",
    ),
    "M3",
)


DEGREES = WrongStep(
    "degrees",
    {"angle": "degrees"},
    Text(
        en="your angle went into sin and cos in degrees. Python and ROS count in radians (REP-103): `math.radians`.",
        ko="각도를 도(degree) 그대로 sin과 cos에 넣었습니다. 파이썬과 ROS는 라디안을 씁니다(REP-103). "
        "`math.radians`를 쓰십시오.",
    ),
    "M5",
)


WHOLE_ANGLE = WrongStep(
    "whole_angle",
    {"half": "whole"},
    Text(
        en="the camera is turned twice as far as asked: a quaternion holds the sine and cosine of half the angle.",
        ko="카메라가 두 배로 돌아갔습니다. 쿼터니언에는 각도의 절반에 대한 sin과 cos을 넣습니다.",
    ),
    "M5",
)


W_FIRST = WrongStep(
    "w_first",
    {"quaternion": "w first"},
    Text(
        en="your quaternion has w first. ROS writes (x, y, z, w), so this camera rolls about x instead of turning.",
        ko="쿼터니언에 w를 먼저 썼습니다. ROS는 (x, y, z, w) 순서이므로 이 카메라는 왼쪽으로 도는 대신 x축을 중심으로 "
        "기울어집니다.",
    ),
    "M5",
)


TO_THE_RIGHT = WrongStep(
    "to_the_right",
    {"side": "right"},
    Text(
        en="your camera turns to the other side. A turn to the left is positive, and one to the right comes with a minus "
        "already: check the sign of the angle.",
        ko="카메라가 반대쪽으로 돌아갑니다. 왼쪽으로 도는 회전이 양수이고, 오른쪽으로 도는 각도는 이미 음수로 들어옵니다. "
        "각도의 부호를 확인하십시오.",
    ),
)


NOT_TURNED = WrongStep(
    "not_turned",
    {"quaternion": "none"},
    Text(
        en="the camera looks straight ahead: the rotation is still the one that a new message has.",
        ko="카메라가 똑바로 앞을 봅니다. 회전이 새 메시지의 값 그대로입니다.",
    ),
)


ROLLED = WrongStep(
    "rolled",
    {"quaternion": "roll"},
    Text(
        en="the camera is rolled onto its side: the sine stands in x. Which axis does a turn to the left go about?",
        ko="카메라가 옆으로 기울었습니다. sin이 x 자리에 있습니다. 왼쪽으로 도는 회전의 축은 무엇입니까?",
    ),
)


ANGLE_IN_Z = WrongStep(
    "angle_in_z",
    {"quaternion": "angle"},
    Text(
        en="you wrote the angle itself into z. A quaternion holds no angle: z takes the sine of half of it, "
        "w the cosine.",
        ko="z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 "
        "cos을 넣으십시오.",
    ),
    "M5",
)


W_STILL_ONE = WrongStep(
    "w_still_one",
    {"quaternion": "w one"},
    Text(
        en="w is still the 1 of a new message: it takes the cosine of half the angle.",
        ko="w가 새 메시지의 값 1 그대로입니다. w에는 각도 절반의 cos을 넣으십시오.",
    ),
    "M5",
)


AHEAD_AND_UP_SWAPPED = WrongStep(
    "ahead_and_up_swapped",
    {"axes": "exchanged"},
    Text(
        en="the two steps have changed places. Which axis of the body points ahead, and which one up?",
        ko="두 이동의 자리가 바뀌었습니다. 본체의 어느 축이 앞을, 어느 축이 위를 향합니까?",
    ),
)


ZERO_QUATERNION = WrongStep(
    "zero_quaternion",
    {"quaternion": "zero"},
    Text(
        en="the rotation is all zeros. That is no rotation at all: every listener refuses the message, and "
        "camera_link never appears.",
        ko="회전이 모두 0입니다. 이것은 회전이 아니므로 모든 수신기가 메시지를 거절하고, camera_link는 끝내 "
        "나타나지 않습니다.",
    ),
    "M5",
)


OPTICAL_CHILD = WrongStep(
    "optical child",
    {"ends": "optical"},
    Text(
        en="this bolts on camera_optical_frame. The mount is that of camera_link; the optical frame hangs below it, turned.",
        ko="camera_optical_frame을 달았습니다. 장착 변환은 camera_link의 것이고, 광학 좌표계는 그 아래에 돌아간 채 달립니다.",
    ),
    "M4",
)

INVERSE_NUMBERS = WrongStep(
    "inverse numbers",
    {"numbers": "inverse"},
    Text(
        en="these are the numbers of the way back: where base_link sits in camera_link. The header asks for the camera in its parent.",
        ko="돌아가는 쪽, 곧 camera_link에서 본 base_link의 숫자입니다. 필요한 것은 부모를 기준으로 한 카메라입니다.",
    ),
    "M1",
)

NEGATIVE_NUMBERS = WrongStep(
    "negative numbers",
    {"numbers": "negative"},
    Text(
        en="both steps have a minus sign: this camera hangs behind and below. Ahead and up are positive.",
        ko="두 이동에 마이너스가 붙어 있어 카메라가 뒤쪽 아래에 달립니다. 앞과 위가 양수입니다.",
    ),
    "M3",
)

UP_IN_Y = WrongStep(
    "up in y",
    {"axes": "y"},
    Text(
        en="up_m stands in y, which points to the left. Up is z.",
        ko="up_m이 y에 들어 있습니다. y는 왼쪽입니다. 위는 z입니다.",
    ),
)

MILLIMETRES = WrongStep(
    "millimetres",
    {"length": "mm"},
    Text(
        en="the lengths are a thousand times too large: ROS counts in metres.",
        ko="길이가 천 배 큽니다. ROS는 미터를 씁니다.",
    ),
)

PITCHED = WrongStep(
    "pitched",
    {"quaternion": "pitch"},
    Text(
        en="the camera nods: the sine stands in y. Which axis does a turn to the left go about?",
        ko="카메라가 위아래로 기울었습니다. sin이 y 자리에 있습니다. 왼쪽으로 도는 회전의 축은 무엇입니까?",
    ),
)

SINE_IN_W = WrongStep(
    "sine in w",
    {"quaternion": "exchanged"},
    Text(
        en="sine and cosine have changed places: z takes the sine, w the cosine.",
        ko="sin과 cos의 자리가 바뀌었습니다. z에는 sin, w에는 cos입니다.",
    ),
    "M5",
)

STAMPED = WrongStep(
    "stamped",
    {"stamp": "set"},
    Text(
        en="you set the stamp; the task leaves it as it is.", ko="시각(stamp)을 바꾸었습니다. 문제에서는 그대로 둡니다."
    ),
)


TO_DEGREES = WrongStep(
    "to degrees",
    {"angle": "to degrees"},
    Text(
        en="`math.degrees` goes the other way: the angle is in degrees already, and `math.radians` makes radians of it.",
        ko="`math.degrees`는 반대 방향입니다. 각도는 이미 도 단위이고, `math.radians`가 라디안으로 바꿉니다.",
    ),
    "M5",
)


PARENT_MAP = WrongStep(
    "parent map",
    {"ends": "map"},
    Text(
        en="the parent is map: this bolts the camera to the building. It rides along with `base_link`.",
        ko="부모가 map입니다. 카메라를 건물에 단 셈입니다. 카메라는 `base_link`와 함께 움직입니다.",
    ),
    "M2",
)


PARENT_ODOM = WrongStep(
    "parent odom",
    {"ends": "odom"},
    Text(
        en="the parent is odom: this camera stays behind as the robot drives. It rides along with `base_link`.",
        ko="부모가 odom입니다. 로봇이 달려도 카메라는 그 자리에 남습니다. 카메라는 `base_link`와 함께 움직입니다.",
    ),
    "M2",
)


OPTICAL_AXES = WrongStep(
    "optical axes",
    {"axes": "optical"},
    Text(
        en="these are the numbers along the axes of a picture, where z looks ahead and y down. Asked for are those of "
        "`base_link`: x ahead, y to the left, z up.",
        ko="z가 앞, y가 아래인 영상의 축으로 잰 숫자입니다. 필요한 것은 `base_link` 기준이므로 x가 앞, y가 왼쪽, z가 "
        "위입니다.",
    ),
    "M4",
)


UP_IN_MINUS_Y = WrongStep(
    "up in minus y",
    {"axes": "minus y"},
    Text(
        en="up_m stands in y, with a minus: that is up in a picture, the optical frame. On `base_link` z points up.",
        ko="up_m을 y에 음수로 넣었습니다. 그것은 영상(광학 좌표계)의 위쪽입니다. `base_link`에서는 z가 위입니다.",
    ),
    "M4",
)


Y_AHEAD = WrongStep(
    "y ahead",
    {"axes": "y ahead"},
    Text(
        en="ahead_m stands in y, as on a map. On a robot x points ahead and y to the left.",
        ko="ahead_m을 지도처럼 y에 넣었습니다. 로봇에서는 x가 앞, y가 왼쪽입니다.",
    ),
    "M4",
)


Y_UP_Z_AHEAD = WrongStep(
    "y up and z ahead",
    {"axes": "y up, z ahead"},
    Text(
        en="up_m stands in y and ahead_m in z. On `base_link` x points ahead and z up.",
        ko="up_m을 y에, ahead_m을 z에 넣었습니다. `base_link`에서는 x가 앞, z가 위입니다.",
    ),
    "M4",
)


OFFSET_TURNED_BACK = WrongAnswer(
    "offset turned back",
    partial(mounted, numbers="turned back"),
    Text(
        en="you turned the offset, by minus the camera's angle. It is measured along the axes of `base_link`: however "
        "the camera is turned, it sits in the same place.",
        ko="위치를 카메라 각도의 반대로 돌렸습니다. 위치는 `base_link`의 축을 따라 잰 것이므로, 카메라가 어느 쪽을 보든 달린 "
        "자리는 같습니다.",
    ),
    "M3",
)


def of_place(name: str, axes: str, en: str, ko: str) -> WrongAnswer:
    """Return the mount with a length in a place where it does not belong."""
    return WrongAnswer(name, partial(mounted, axes=axes), Text(en=en, ko=ko))


PLACES = (
    of_place(
        "ahead twice",
        "ahead twice",
        "ahead_m stands in z as well as in x, and up_m nowhere. Up is z.",
        "ahead_m이 x뿐 아니라 z에도 들어 있고, up_m은 어디에도 없습니다. 위는 z입니다.",
    ),
    of_place(
        "up twice",
        "up twice",
        "up_m stands in x as well as in z, and ahead_m nowhere. Ahead is x.",
        "up_m이 z뿐 아니라 x에도 들어 있고, ahead_m은 어디에도 없습니다. 앞은 x입니다.",
    ),
    of_place(
        "ahead in y too",
        "ahead in y too",
        "ahead_m stands in y as well as in x: this camera sits to the left of the middle.",
        "ahead_m이 x뿐 아니라 y에도 들어 있습니다. 카메라가 중심에서 왼쪽으로 벗어납니다.",
    ),
    of_place(
        "up in y too",
        "up in y too",
        "up_m stands in y as well as in z: this camera sits to the left of the middle.",
        "up_m이 z뿐 아니라 y에도 들어 있습니다. 카메라가 중심에서 왼쪽으로 벗어납니다.",
    ),
)


def of_rotation(name: str, steps: dict[str, str], en: str, ko: str) -> WrongAnswer:
    """Return the mount with a rotation that was made otherwise."""
    return WrongAnswer(name, partial(mounted, **steps), Text(en=en, ko=ko), "M5")


ROTATIONS = (
    of_rotation(
        "half in z alone",
        {"quaternion": "half in z"},
        "z is the sine of half the angle, and w the cosine of the whole: both take the half.",
        "z는 각도 절반의 sin인데 w는 각도 전체의 cos입니다. 둘 다 절반을 씁니다.",
    ),
    of_rotation(
        "half in w alone",
        {"quaternion": "half in w"},
        "w is the cosine of half the angle, and z the sine of the whole: both take the half.",
        "w는 각도 절반의 cos인데 z는 각도 전체의 sin입니다. 둘 다 절반을 씁니다.",
    ),
    of_rotation(
        "w lost",
        {"quaternion": "w lost"},
        "w is 0, which only half a turn has: it takes the cosine of half the angle.",
        "w가 0입니다. w가 0인 것은 반 바퀴뿐입니다. w에는 각도 절반의 cos을 넣습니다.",
    ),
    of_rotation(
        "whole degrees",
        {"angle": "whole degrees"},
        "an angle of 22.5 degrees has lost its half: `int` and `//` cut off what comes after the point.",
        "22.5도에서 소수점 아래가 없어졌습니다. `int`와 `//`는 소수점 아래를 잘라 냅니다.",
    ),
    of_rotation(
        "degrees in z",
        {"quaternion": "degrees"},
        "you wrote the degrees themselves into z. A quaternion holds no angle: z takes the sine of half of it, w the "
        "cosine.",
        "z에 도(degree)를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 cos을 "
        "넣으십시오.",
    ),
    of_rotation(
        "half cut off",
        {"angle": "half cut off"},
        "half of an odd number of degrees has lost its half degree: `//` cuts off what comes after the point.",
        "홀수인 각도를 반으로 나눌 때 0.5도가 없어졌습니다. `//`는 소수점 아래를 잘라 냅니다.",
    ),
    of_rotation(
        "optical axes on top",
        {"quaternion": "optical"},
        "the turn of an optical frame was put on top. camera_link has the axes of a robot's part, x ahead; the optical "
        "frame hangs below it, and has its own transform.",
        "광학 좌표계의 회전까지 더했습니다. camera_link는 로봇 부품의 축(x가 앞)을 씁니다. 광학 좌표계는 그 아래에 따로 "
        "달리고 변환도 따로 있습니다.",
    ),
    of_rotation(
        "halved twice",
        {"angle": "halved"},
        "the camera turns half as far as asked: the angle was halved twice.",
        "카메라가 절반만 돌았습니다. 각도를 두 번 반으로 나누었습니다.",
    ),
    of_rotation(
        "no pi",
        {"angle": "no pi"},
        "the angle was divided by 180, and π is missing: half a turn is π radians. `math.radians` does both.",
        "각도를 180으로 나누기만 하고 π를 곱하지 않았습니다. 반 바퀴는 π 라디안입니다. `math.radians`가 둘 다 합니다.",
    ),
    of_rotation(
        "radians of radians",
        {"angle": "twice"},
        "the angle was made radians twice: the camera hardly turns. `math.radians`, or π/180, belongs there once.",
        "각도를 라디안으로 두 번 바꾸어서 카메라가 거의 돌지 않습니다. `math.radians`나 π/180은 한 번만 씁니다.",
    ),
)


def of_name(name: str, ends: str, en: str, ko: str) -> WrongAnswer:
    """Return the mount between other frames."""
    return WrongAnswer(name, partial(mounted, ends=ends), Text(en=en, ko=ko), "M2")


ENDS = (
    of_name(
        "child camera",
        "camera",
        "the child is called camera; the frame that is bolted on has another name, camera_link. To TF these are two.",
        "자식의 이름이 camera입니다. 달아야 할 좌표계의 이름은 camera_link이고, TF에게 둘은 서로 다릅니다.",
    ),
    of_name(
        "child laser_frame",
        "laser",
        "the child is laser_frame: this moves the laser, and the camera stays unknown to TF.",
        "자식이 laser_frame입니다. 레이저의 자리를 바꾼 셈이고, TF는 카메라를 알지 못합니다.",
    ),
    of_name(
        "parent base",
        "base",
        "the parent is called base; the robot's frame has another name, base_link. To TF these are two.",
        "부모의 이름이 base입니다. 로봇 좌표계의 이름은 base_link이고, TF에게 둘은 서로 다릅니다.",
    ),
    of_name(
        "parent base_footprint",
        "footprint",
        "the parent is base_footprint, which lies on the floor. The lengths are measured from `base_link`.",
        "부모가 바닥에 있는 base_footprint입니다. 길이는 `base_link`에서 잰 값입니다.",
    ),
    of_name(
        "parent laser_frame",
        "laser below",
        "the parent is laser_frame: this bolts the camera onto the laser. The lengths are measured from `base_link`.",
        "부모가 laser_frame입니다. 카메라를 레이저 위에 단 셈입니다. 길이는 `base_link`에서 잰 값입니다.",
    ),
)


TASK = Task(
    id="E3.6",
    kind="C",
    points=4,
    title=Text(en="Bolt the camera on", ko="카메라 달기"),
    answer="camera_mount",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation", "header.stamp"),
    ),
    inputs=mount_inputs,
    variants=3,
    model=mounted,
    mistakes=(
        PARENT_AND_CHILD_SWAPPED,
        OFFSET_TURNED,
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
        OPTICAL_CHILD,
        INVERSE_NUMBERS,
        NEGATIVE_NUMBERS,
        UP_IN_Y,
        OPTICAL_AXES,
        MILLIMETRES,
        PITCHED,
        SINE_IN_W,
        STAMPED,
        TO_DEGREES,
        PARENT_MAP,
        PARENT_ODOM,
        UP_IN_MINUS_Y,
        Y_AHEAD,
        Y_UP_Z_AHEAD,
        OFFSET_TURNED_BACK,
        *PLACES,
        *ROTATIONS,
        *ENDS,
    ),
    hints=(
        Text(
            en="Which frame holds the numbers? That one is the parent, `header.frame_id`.",
            ko="숫자를 잰 좌표계는 어느 쪽입니까? 그쪽이 부모, `header.frame_id`입니다.",
        ),
        Text(
            en="A turn to the left by an angle is z = sin(half of it), w = cos(half of it), and x = y = 0.",
            ko="왼쪽으로 어떤 각도만큼 돌면 z = sin(그 절반), w = cos(그 절반), x = y = 0입니다.",
        ),
        Text(
            en="ahead is x, up is z. Message fields want floats, so write `float(...)` around what may be an int.",
            ko="앞은 x, 위는 z입니다. 메시지 필드는 float를 받으므로 int일 수 있는 값은 `float(...)`로 감싸십시오.",
        ),
    ),
    misconceptions=("M2", "M5"),
)
