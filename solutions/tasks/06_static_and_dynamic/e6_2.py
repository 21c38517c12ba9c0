"""E6.2: A mount on the command line."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Command, Task, Text, WrongStep

TOOL = "ros2 run tf2_ros static_transform_publisher"


def mount(rng):
    """A sensor some centimetres ahead, to the right and up, turned to the left."""
    ahead, right, up = (int(n) for n in rng.choice([7, 12, 15, 18, 22, 26, 31, 35], 3, replace=False))
    child = str(rng.choice(["camera_link", "laser_frame", "lidar_link", "radar_link", "imu_link", "sonar_link"]))
    return {"child": child, "ahead_cm": ahead, "right_cm": right, "up_cm": up,
            "turn_left_deg": int(rng.choice([25, 35, 50, 70, 110, 130]))}  # fmt: skip


def line(g, *, ends="parent first", length="m", side="right", places="as given", turn="left", angle="radians",
         about="yaw", style="options"):  # fmt: skip
    """Return the command line, step by step; other steps are the slips."""
    names = {"child first": (g.child, "base_link"), "map": ("map", g.child)}
    parent, child = names.get(ends, ("base_link", g.child))
    scale = {"m": 0.01, "cm": 1.0, "mm": 0.001}[length]
    x, y, z = g.ahead_cm * scale, g.right_cm * scale * (1 if side == "left" else -1), g.up_cm * scale
    z = g.up_cm if places == "up in cm" else z
    x = g.ahead_cm if places == "ahead in cm" else x
    y = -g.right_cm if places == "right in cm" else y
    if places == "y ahead":
        x, y = -y, x
    if places == "up second":
        x, y, z = x, z, y
    value = float(g.turn_left_deg) if angle == "degrees" else math.radians(g.turn_left_deg)
    value = {"half turns": g.turn_left_deg / 180, "tenths": round(math.radians(g.turn_left_deg), 1), "doubled": math.tau * g.turn_left_deg / 180,
             "twice": math.degrees(g.turn_left_deg)}.get(angle, value)  # fmt: skip
    value = -value if turn == "right" else value
    if about == "none":
        value, about = 0.0, "yaw"
    about = "qz" if style == "half" else about
    words = f"{TOOL} --x {x} --y {y} --z {z} --{about} {value} --frame-id {parent} --child-frame-id {child}"
    styles = {
        "equals": words.replace("--x ", "--x="),
        "bare": words.removeprefix("ros2 run tf2_ros "),
        "no parent": words.replace(f" --frame-id {parent}", ""),
    }
    return styles.get(style, words)


PARENT_AND_CHILD_SWAPPED = WrongStep(
    "parent and child swapped",
    {"ends": "child first"},
    Text(
        en="`--frame-id` and `--child-frame-id` are swapped: this bolts the robot onto the sensor. The numbers are measured from the parent.",
        ko="`--frame-id`와 `--child-frame-id`가 바뀌었습니다. 로봇을 센서에 단 셈입니다. 숫자는 부모에서 잽니다.",
    ),
    "M2",
)

CENTIMETRES = WrongStep(
    "centimetres",
    {"length": "cm"},
    Text(
        en="The lengths went in as centimetres: the sensor hangs many metres away. ROS counts in metres.",
        ko="길이를 센티미터 그대로 넣었습니다. 센서가 몇십 미터 밖에 달립니다. ROS는 미터를 씁니다.",
    ),
)

MILLIMETRES = WrongStep(
    "divided by a thousand",
    {"length": "mm"},
    Text(
        en="The lengths are ten times too small: a metre has a hundred centimetres.",
        ko="길이가 열 배 작습니다. 1미터는 100센티미터입니다.",
    ),
)

TO_THE_LEFT = WrongStep(
    "to the left",
    {"side": "left"},
    Text(
        en="The sensor sits on the left. y points to the left (REP-103), so what sits to the right has a negative y.",
        ko="센서가 왼쪽에 있습니다. y는 왼쪽을 가리키므로(REP-103) 오른쪽에 있는 것은 y가 음수입니다.",
    ),
)

Y_AHEAD = WrongStep(
    "y ahead",
    {"places": "y ahead"},
    Text(
        en="You took y for forward and x for right, as on a map. On a robot x points forward and y to the left.",
        ko="지도에서처럼 y를 앞, x를 오른쪽으로 보았습니다. 로봇에서는 x가 앞, y가 왼쪽입니다.",
    ),
)

UP_IN_Y = WrongStep(
    "up in y",
    {"places": "up second"},
    Text(
        en="Height and side have changed places: z points up, y to the left.",
        ko="높이와 옆이 바뀌었습니다. z가 위, y가 왼쪽입니다.",
    ),
)

TURNED_RIGHT = WrongStep(
    "turned right",
    {"turn": "right"},
    Text(
        en="The turn goes to the right: a positive yaw turns to the left.",
        ko="오른쪽으로 돌렸습니다. 양수 yaw는 왼쪽으로 돕니다.",
    ),
)

DEGREES = WrongStep(
    "degrees",
    {"angle": "degrees"},
    Text(
        en="The angle went in as degrees. The tool takes it without a word, as radians: several turns. `math.radians` helps.",
        ko="각도를 도(degree) 그대로 넣었습니다. 도구는 아무 말 없이 라디안으로 받아들여 여러 바퀴를 돌립니다. `math.radians`를 쓰십시오.",
    ),
    "M5",
)

ROLLED = WrongStep(
    "rolled",
    {"about": "roll"},
    Text(
        en="the sensor is rolled onto its side. A turn to the left goes about z: which angle is that? (Without options the order is yaw, pitch, roll.)",
        ko="센서가 옆으로 기울었습니다. 왼쪽으로 도는 회전은 z축에 대한 것입니다. 어느 각도입니까? (옵션 없는 형식은 yaw, pitch, roll 순서입니다.)",
    ),
    "M5",
)

PITCHED = WrongStep(
    "pitched",
    {"about": "pitch"},
    Text(
        en="`--pitch` makes the sensor nod. A turn to the left goes about z: which angle is that?",
        ko="`--pitch`는 센서를 위아래로 기울입니다. 왼쪽으로 도는 회전은 z축에 대한 것입니다. 어느 각도입니까?",
    ),
    "M5",
)

NOT_TURNED = WrongStep(
    "not turned",
    {"about": "none"},
    Text(
        en="The sensor looks straight ahead: the turn is missing.",
        ko="센서가 똑바로 앞을 봅니다. 회전이 빠졌습니다.",
    ),
)

ON_THE_MAP = WrongStep(
    "on the map",
    {"ends": "map"},
    Text(
        en="The parent is map: this bolts the sensor to the building. It is measured from `base_link`, and rides along with it.",
        ko="부모가 map입니다. 센서를 건물에 고정한 셈입니다. 숫자는 `base_link`에서 쟀고 센서는 로봇과 함께 움직입니다.",
    ),
    "M2",
)

EQUALS_SIGN = WrongStep(
    "equals sign",
    {"style": "equals"},
    Text(
        en="The tool does not read `--x=0.2`: an option and its value are two words, with a space between.",
        ko="이 도구는 `--x=0.2`를 읽지 못합니다. 옵션과 값을 띄어 쓰십시오.",
    ),
)

WITHOUT_ROS2_RUN = WrongStep(
    "without ros2 run",
    {"style": "bare"},
    Text(
        en="A shell does not find the tool by its name alone: `ros2 run tf2_ros` comes before it.",
        ko="도구 이름만으로는 셸이 찾지 못합니다. 앞에 `ros2 run tf2_ros`가 필요합니다.",
    ),
)

NO_PARENT = WrongStep(
    "no parent",
    {"style": "no parent"},
    Text(
        en="`--frame-id` is missing: the tool ends with `Frame id must not be empty`.",
        ko="`--frame-id`가 없습니다. 도구가 `Frame id must not be empty`라고 하며 끝납니다.",
    ),
)

ANGLE_AS_QZ = WrongStep(
    "angle as qz",
    {"style": "half"},
    Text(
        en="`--qz` takes a part of a quaternion, no angle, and without `--qw` its length is not even one.",
        ko="`--qz`는 각도가 아니라 쿼터니언의 성분입니다. `--qw`가 없으면 길이도 1이 아닙니다.",
    ),
    "M5",
)


UP_IN_CENTIMETRES = WrongStep(
    "up in centimetres",
    {"places": "up in cm"},
    Text(
        en="The height alone went in as centimetres: the sensor hangs many metres up. All three lengths are wanted in metres.",
        ko="높이만 센티미터 그대로 넣었습니다. 센서가 몇십 미터 위에 달립니다. 세 길이 모두 미터로 쓰십시오.",
    ),
)


AHEAD_IN_CENTIMETRES = WrongStep(
    "ahead in centimetres",
    {"places": "ahead in cm"},
    Text(
        en="The way ahead alone went in as centimetres: the sensor hangs many metres in front of the robot. All three lengths are wanted in metres.",
        ko="앞쪽 길이만 센티미터 그대로 넣었습니다. 센서가 로봇에서 몇십 미터 앞에 달립니다. 세 길이 모두 미터로 쓰십시오.",
    ),
)


RIGHT_IN_CENTIMETRES = WrongStep(
    "right in centimetres",
    {"places": "right in cm"},
    Text(
        en="The way to the right alone went in as centimetres: the sensor hangs many metres beside the robot. All three lengths are wanted in metres.",
        ko="오른쪽 길이만 센티미터 그대로 넣었습니다. 센서가 로봇에서 몇십 미터 옆에 달립니다. 세 길이 모두 미터로 쓰십시오.",
    ),
)


HALF_TURNS = WrongStep(
    "half turns",
    {"angle": "half turns"},
    Text(
        en="The angle is counted in half turns: degrees divided by 180, and π is missing. `math.radians` does both.",
        ko="각도를 반 바퀴 단위로 썼습니다. 180으로 나누기만 하고 π를 곱하지 않은 값입니다. `math.radians`가 둘 다 합니다.",
    ),
)


ANGLE_TO_TENTHS = WrongStep(
    "angle to tenths",
    {"angle": "tenths"},
    Text(
        en="You rounded the angle to tenths of a radian, and a tenth is almost six degrees. Write it as it was computed.",
        ko="각도를 0.1라디안 단위로 반올림했습니다. 0.1라디안은 거의 6도입니다. 계산한 그대로 쓰십시오.",
    ),
)


TURNED_TWICE_AS_FAR = WrongStep(
    "turned twice as far",
    {"angle": "doubled"},
    Text(
        en="The sensor is turned twice as far. 180 degrees are π, not 2π; and a quaternion holds the sine and cosine of *half* the angle.",
        ko="두 배로 돌아갔습니다. 180도는 2π가 아니라 π입니다. 쿼터니언에는 각도의 *절반*의 사인과 코사인이 들어갑니다.",
    ),
)


TURNED_TO_DEGREES = WrongStep(
    "turned to degrees once more",
    {"angle": "twice"},
    Text(
        en="The degrees were multiplied by 180/π, as `math.degrees` does. They are degrees already: it is `math.radians` that you want.",
        ko="도에 180/π를 곱했습니다. `math.degrees`가 하는 일입니다. 이미 도이므로 필요한 것은 `math.radians`입니다.",
    ),
)


TASK = Task(
    id="E6.2",
    kind="C",
    points=3,
    title=Text(en="A mount on the command line", ko="명령줄로 장착 위치 발행하기"),
    answer="command",
    form=Command(),
    given=mount,
    variants=6,
    model=line,
    mistakes=(
        PARENT_AND_CHILD_SWAPPED,
        CENTIMETRES,
        MILLIMETRES,
        TO_THE_LEFT,
        Y_AHEAD,
        UP_IN_Y,
        TURNED_RIGHT,
        DEGREES,
        ROLLED,
        PITCHED,
        NOT_TURNED,
        ON_THE_MAP,
        EQUALS_SIGN,
        WITHOUT_ROS2_RUN,
        NO_PARENT,
        ANGLE_AS_QZ,
        UP_IN_CENTIMETRES,
        AHEAD_IN_CENTIMETRES,
        RIGHT_IN_CENTIMETRES,
        HALF_TURNS,
        ANGLE_TO_TENTHS,
        TURNED_TWICE_AS_FAR,
        TURNED_TO_DEGREES,
    ),
    hints=(
        Text(
            en="Which unit does each option want, and which way does each axis point?",
            ko="옵션마다 단위가 무엇이고, 축마다 어느 쪽을 가리킵니까?",
        ),
        Text(
            en="Metres and radians; x forward, y to the left, z up; a turn to the left is a positive yaw.",
            ko="미터와 라디안입니다. x는 앞, y는 왼쪽, z는 위이고, 왼쪽으로 도는 회전은 양수 yaw입니다.",
        ),
        Text(
            en='An f-string fills in your numbers: f"… --x {e6_2.ahead_cm / 100} …". What sits to the right has a negative y.',
            ko='f-문자열에 숫자를 넣을 수 있습니다. f"… --x {e6_2.ahead_cm / 100} …" 오른쪽에 있는 것은 y가 음수입니다.',
        ),
    ),
    misconceptions=("M2", "M5", "M12"),
)
