"""E1.6: Write both labels."""

from __future__ import annotations

from tflab.ros.messages import builtin_interfaces
from tflab.workbook.tasks import Message, Task, Text, WrongStep

from .draws import point, time


def measurements(rng):
    rows = []
    for number in range(5):
        late_s = 0.6 if number == 3 else 0.0  # in its second, where who rounds has the next one
        measured_s = round(float(rng.integers(3, 60)) + float(rng.uniform(0.011, 0.099)) + late_s, 3)
        later_s = round(measured_s + float(rng.uniform(0.04, 0.5)), 3)
        hair_m = 0.004 if number == 2 else 0.0  # what a range to centimetres has lost
        rows.append((round(round(float(rng.uniform(0.4, 6.0)), 2) + hair_m, 3), time(measured_s), time(later_s)))
    return rows


def honest(range_m, measured, now, *, frame="laser_frame", moment="measured", sight="range", axis="x"):
    """Return the message, step by step; other steps are the slips."""
    measured_ns, now_ns = measured.nanoseconds, now.nanoseconds
    stamps_ns = {
        "measured": measured_ns,
        "now": now_ns,
        "zero": 0,
        "sec alone": measured_ns // 10**9 * 10**9,
        "age": now_ns - measured_ns,
        "half way": (measured_ns + now_ns) // 2,
    }
    age_s = (now_ns - measured_ns) / 1e9
    value = {"range": range_m, "none": 0.0, "age taken off": range_m - age_s, "age added": range_m + age_s,
             "centimetres": round(range_m, 2)}[sight]  # fmt: skip
    message = point(frame, stamps_ns.get(moment, 0), 0.0)
    if moment == "all in nanosec":
        message.header.stamp = builtin_interfaces.Time(sec=0, nanosec=measured_ns % 2**32)
    if moment == "milliseconds in nanosec":
        message.header.stamp = builtin_interfaces.Time(sec=measured_ns // 10**9, nanosec=measured_ns % 10**9 // 10**6)
    if moment == "sec rounded":
        message.header.stamp = builtin_interfaces.Time(sec=round(measured_ns / 1e9), nanosec=measured_ns % 10**9)
    for letter in axis:
        setattr(message.point, letter, value)
    return message


STAMPED_NOW = WrongStep(
    "stamped now",
    {"moment": "now"},
    Text(
        en="The stamp is the moment at which your function was called. By then the measurement was already old, and nobody who reads the message can know.",
        ko="측정 시각에 함수가 호출된 시각을 적었습니다. 그때는 측정한 지 이미 시간이 지났고, 메시지를 읽는 사람은 그것을 알 수 없습니다.",
    ),
    "M9",
)

NO_STAMP = WrongStep(
    "no stamp",
    {"moment": "zero"},
    Text(
        en='The stamp is still zero. For TF2 that means "whatever is latest", and it will not complain.',
        ko="측정 시각이 아직 0입니다. TF2에게는 “가장 최근 것이면 된다”는 뜻이고, 아무 경고도 없습니다.",
    ),
    "M9",
)

ON_THE_MAP = WrongStep(
    "on the map",
    {"frame": "map"},
    Text(
        en="The label says map, and the number was counted from the laser. The wall would stand that far from the corner of the map.",
        ko="이름표는 map인데 숫자는 레이저에서 센 것입니다. 벽이 지도 원점에서 그만큼 떨어진 곳에 서게 됩니다.",
    ),
)

ON_THE_ROBOT = WrongStep(
    "on the robot",
    {"frame": "base_link"},
    Text(
        en="Counted from the laser, labelled as counted from the robot's middle: off by the mount.",
        ko="레이저에서 센 숫자인데 이름표는 로봇의 중심입니다. 장착 위치만큼 어긋납니다.",
    ),
)

NO_FRAME = WrongStep(
    "no frame",
    {"frame": ""},
    Text(
        en="The frame is still empty. Whoever gets this message has to refuse it.",
        ko="좌표계가 아직 비어 있습니다. 이 메시지를 받은 쪽은 거절할 수밖에 없습니다.",
    ),
)

ALL_IN_NANOSEC = WrongStep(
    "all in nanosec",
    {"moment": "all in nanosec"},
    Text(
        en="All nanoseconds went into nanosec, which holds less than one second of them. `measured.to_msg()` splits a time into both fields.",
        ko="나노초를 모두 nanosec에 넣었습니다. nanosec에는 1초보다 적은 나노초만 들어갑니다. `measured.to_msg()`가 시각을 두 항목으로 나눠 줍니다.",
    ),
)

ALONG_Z = WrongStep(
    "along z",
    {"axis": "z"},
    Text(
        en="The range went into z. The finder looks along the x of its frame; z points up.",
        ko="거리를 z에 넣었습니다. 센서는 자기 좌표계의 x 방향을 봅니다. z는 위쪽입니다.",
    ),
    "M4",
)

EVERYWHERE = WrongStep(
    "range in all three",
    {"axis": "xyz"},
    Text(
        en="The range stands in x, y and z. The finder looks along x alone: y and z are 0.",
        ko="x, y, z에 모두 거리를 넣었습니다. 센서는 x축 방향만 봅니다. y와 z는 0입니다.",
    ),
)

SEC_ALONE = WrongStep(
    "sec alone",
    {"moment": "sec alone"},
    Text(
        en="Only sec is in the stamp. `measured.to_msg()` writes both fields.",
        ko="측정 시각에 sec만 들어 있습니다. `measured.to_msg()`를 쓰면 두 항목이 모두 채워집니다.",
    ),
)

AGE_FOR_STAMP = WrongStep(
    "age for stamp",
    {"moment": "age"},
    Text(
        en="The stamp holds an age. A stamp is a moment: when was it measured?",
        ko="측정 시각에 나이를 적었습니다. 측정 시각은 순간입니다. 언제 측정했습니까?",
    ),
    "M9",
)

NO_RANGE = WrongStep(
    "no range",
    {"sight": "none"},
    Text(
        en="The labels are there, and the point is still (0, 0, 0): where is the range?",
        ko="이름표는 있지만 점이 아직 (0, 0, 0)입니다. 거리는 어디에 있습니까?",
    ),
)

OTHER_NAME = WrongStep(
    "another name",
    {"frame": "laser"},
    Text(
        en="There is no frame of this name on the robot: it is called `laser_frame`.",
        ko="로봇에 이런 이름의 좌표계는 없습니다. `laser_frame`이라고 합니다.",
    ),
    "M14",
)


HALF_WAY = WrongStep(
    "half way",
    {"moment": "half way"},
    Text(
        en="The stamp lies between the two times, and at that moment nothing was measured.",
        ko="측정 시각이 두 시각 사이에 있습니다. 그 순간에는 아무것도 측정하지 않았습니다.",
    ),
    "M9",
)


AGE_TAKEN_OFF = WrongStep(
    "age taken off",
    {"sight": "age taken off"},
    Text(
        en="You took the age off the range: seconds from metres. A driver reports what was measured, and says when; whoever reads it knows what to do.",
        ko="거리에서 나이를 뺐습니다. 미터에서 초를 뺄 수 없습니다. 드라이버는 측정한 것과 그 시각을 그대로 알리고, 나머지는 읽는 쪽이 합니다.",
    ),
    "M9",
)


ALONG_Y = WrongStep(
    "along y",
    {"axis": "y"},
    Text(
        en="The range went into y. The finder looks along the x of its frame; y points to the left.",
        ko="거리를 y에 넣었습니다. 센서는 자기 좌표계의 x 방향을 봅니다. y는 왼쪽입니다.",
    ),
)


IN_ODOM = WrongStep(
    "in odom",
    {"frame": "odom"},
    Text(
        en="The label says odom, and the number was counted from the laser.",
        ko="이름표는 odom인데 숫자는 레이저에서 센 것입니다.",
    ),
)


AGE_ADDED = WrongStep(
    "age added",
    {"sight": "age added"},
    Text(
        en="You added the age to the range: seconds to metres. A driver reports what was measured, and says when.",
        ko="거리에 나이를 더했습니다. 미터에 초를 더할 수 없습니다. 드라이버는 측정한 것과 그 시각을 그대로 알립니다.",
    ),
    "M9",
)


IN_CAMERA_LINK = WrongStep(
    "in camera_link",
    {"frame": "camera_link"},
    Text(
        en="The label says camera_link, and no camera measured this: the number was counted from the laser.",
        ko="이름표는 camera_link인데 카메라가 잰 것이 아닙니다. 레이저에서 센 숫자입니다.",
    ),
)


LASER_LINK = WrongStep(
    "laser_link",
    {"frame": "laser_link"},
    Text(
        en="`laser_link` is no frame of this robot: its laser's frame is called `laser_frame`.",
        ko="`laser_link`라는 좌표계는 이 로봇에 없습니다. 레이저의 좌표계는 `laser_frame`입니다.",
    ),
    "M14",
)


MILLISECONDS_IN_NANOSEC = WrongStep(
    "milliseconds in nanosec",
    {"moment": "milliseconds in nanosec"},
    Text(
        en="sec is right, and nanosec holds milliseconds: a second has a thousand million nanoseconds. `measured.to_msg()` splits a time into both fields.",
        ko="sec은 맞지만 nanosec에 밀리초를 넣었습니다. 1초는 10억 나노초입니다. `measured.to_msg()`가 시각을 두 항목으로 나눠 줍니다.",
    ),
)


SEC_ROUNDED = WrongStep(
    "sec rounded",
    {"moment": "sec rounded"},
    Text(
        en="sec is rounded: past the half of a second it is one too many, and nanosec is added to it all the same. `measured.to_msg()` splits a time into both fields.",
        ko="sec을 반올림했습니다. 반 초가 지나면 1이 더 많아지는데 nanosec은 그대로 더해집니다. `measured.to_msg()`가 시각을 두 항목으로 나눠 줍니다.",
    ),
)


TO_CENTIMETRES = WrongStep(
    "to centimetres",
    {"sight": "centimetres"},
    Text(
        en="You rounded the range to centimetres. A driver hands on what was measured, as it is.",
        ko="거리를 센티미터 단위로 반올림했습니다. 드라이버는 잰 값을 그대로 전합니다.",
    ),
)


TASK = Task(
    id="E1.6",
    kind="C",
    points=3,
    title=Text(en="Write both labels", ko="이름표 두 개를 쓰십시오"),
    answer="as_message",
    form=Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "header.stamp", "point")),
    inputs=measurements,
    variants=3,
    model=honest,
    mistakes=(
        STAMPED_NOW,
        NO_STAMP,
        ON_THE_MAP,
        ON_THE_ROBOT,
        NO_FRAME,
        ALL_IN_NANOSEC,
        ALONG_Z,
        EVERYWHERE,
        SEC_ALONE,
        SEC_ROUNDED,
        AGE_FOR_STAMP,
        NO_RANGE,
        OTHER_NAME,
        HALF_WAY,
        AGE_TAKEN_OFF,
        ALONG_Y,
        IN_ODOM,
        AGE_ADDED,
        IN_CAMERA_LINK,
        LASER_LINK,
        MILLISECONDS_IN_NANOSEC,
        TO_CENTIMETRES,
    ),
    hints=(
        Text(
            en="Three things to fill in: the point, the frame that it is counted in, the moment of measuring.",
            ko="채울 것은 셋입니다. 점, 점을 센 좌표계, 측정한 시각입니다.",
        ),
        Text(
            en="A `Time` becomes a message's stamp by `.to_msg()`.",
            ko="`Time`은 `.to_msg()`로 메시지의 측정 시각이 됩니다.",
        ),
        Text(
            en="Of the two times, only one says when it was measured.",
            ko="두 시각 가운데 측정한 때를 말하는 것은 하나뿐입니다.",
        ),
    ),
    misconceptions=("M9",),
)
