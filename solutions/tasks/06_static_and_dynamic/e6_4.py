"""E6.4: A circle that drives forward."""

from __future__ import annotations

import math

from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Message, Task, Text, WrongAnswer, WrongStep


def circles(rng):
    """Both ways round, radii other than 1, the start among them, names of several robots."""
    rows = []
    for place, is_left in enumerate((True, False, True, False, True, False)):
        radius = float(rng.choice([0.5, 0.8, 1.5, 2.0, 2.5]))
        speed = float(rng.choice([0.3, 0.4, 0.6, 0.7]))
        angle = float(rng.uniform(0.4, 1.2)) if place % 3 else float(rng.uniform(1.8, 2.6))
        names = (("odom", "base_link"), ("robot1/odom", "robot1/base_link"), ("odom", "base_footprint"))[place % 3]
        rows.append((round(angle * radius / speed, 2), radius, speed, is_left, *names))
    start = (0.0, 1.5, 0.4)
    return [*rows, (*start, True, "odom", "base_link"), (*start, False, "odom", "base_link")]


def message(odom, base, x, y, xyzw):
    t = geometry_msgs.TransformStamped()
    t.header.frame_id, t.child_frame_id = odom, base
    t.transform.translation.x, t.transform.translation.y = float(x), float(y)
    turn = t.transform.rotation
    turn.x, turn.y, turn.z, turn.w = map(float, xyzw)
    return t


def driven(elapsed_s, radius_m, speed_mps, is_left, odom, base, *, ends="parent first", rate="by radius",
           side="as asked", circle="by radius", heading="forward", angle="radians", half="halved",
           quaternion="z and w", stamp="kept"):  # fmt: skip
    """Return odom -> base on the circle, step by step; other steps are the slips."""
    theta = (
        elapsed_s
        * {
            "by radius": speed_mps / radius_m,
            "speed": speed_mps,
            "times": speed_mps * radius_m,
            "to degrees": math.degrees(speed_mps / radius_m),
            "circles": math.tau * speed_mps / radius_m,
            "by diameter": speed_mps / radius_m / 2,
            "time alone": 1.0,
            "turned over": radius_m / speed_mps,
            "in rounds": speed_mps / radius_m / math.tau,
        }[rate]
    )
    left = {"always left": True, "other way": not is_left}.get(side, is_left)
    theta = theta if left or side == "place always left" else -theta
    ahead = math.pi / 2 if left else -math.pi / 2
    turn = {"forward": ahead, "crab": 0.0, "backwards": -ahead, "left's": math.pi / 2, "inwards": math.pi}.get(
        heading, ahead
    )
    yaw = math.degrees(theta + turn) if angle == "degrees" else theta + turn
    yaw = theta + math.degrees(turn) if angle == "quarter in degrees" else yaw
    size = 1.0 if circle == "of one metre" else radius_m
    x, y = size * math.cos(theta), size * math.sin(theta)
    y = -y if side == "heading alone" and not left else y
    x = x - size if circle == "from zero" else x
    x, y = (
        (size * math.cos(math.degrees(theta)), size * math.sin(math.degrees(theta))) if circle == "degrees" else (x, y)
    )
    x, y = (y, x) if circle == "sine first" else (x, y)
    x, y = (
        (size * math.sin(abs(theta)), (1 if left else -1) * size * (1 - math.cos(theta)))
        if circle == "ahead of zero"
        else (x, y)
    )
    yaw = turn if heading == "at the start" else yaw
    z, w = (math.sin(yaw), math.cos(yaw)) if half == "whole" else (math.sin(yaw / 2), math.cos(yaw / 2))
    ways = {"z and w": (0, 0, z, w), "w first": (w, 0, 0, z), "angle": (0, 0, yaw, 1), "none": (0, 0, 0, 1)}
    names = {"child first": (base, odom), "fixed": ("odom", "base_link")}
    parent, child = names.get(ends, (odom, base))
    t = message(parent, child, x, y, ways[quaternion])
    t.header.stamp.sec = int(elapsed_s) + 1 if stamp == "set" else 0
    return t


QUARTER_IN_DEGREES = WrongStep(
    "quarter in degrees",
    {"angle": "quarter in degrees"},
    Text(
        en="A turn in degrees is added to an angle in radians. A quarter turn is pi / 2 rad.",
        ko="라디안인 각도에 도 단위의 회전을 더했습니다. 4분의 1바퀴는 pi / 2 rad입니다.",
    ),
    "M5",
)

SWAPPED = WrongStep(
    "swapped",
    {"ends": "child first"},
    Text(
        en="Parent and child are swapped: this drives the world round the robot.",
        ko="부모와 자식이 바뀌었습니다. 로봇이 아니라 세계가 돕니다.",
    ),
    "M2",
)

FIXED_NAMES = WrongStep(
    "fixed names",
    {"ends": "fixed"},
    Text(
        en="The names are always odom and base_link. They are handed in, and other robots have others.",
        ko="이름이 늘 odom과 base_link입니다. 이름은 인자로 들어오고 로봇마다 다릅니다.",
    ),
)

AS_IN_THE_LECTURE = WrongAnswer(
    "as in the lecture",
    lambda elapsed_s, radius_m, speed_mps, is_left, odom, base: driven(
        elapsed_s, radius_m, speed_mps, True, "odom", "base_link", rate="speed", circle="of one metre", heading="crab"
    ),
    Text(
        en="That is the lecture's node, whole: a circle of one metre, to the left, and the robot looks outwards. Here radius, side and names are handed in, and it drives forward.",
        ko="강의 자료의 노드 그대로입니다. 반지름 1미터, 왼쪽 회전이고 로봇은 바깥을 봅니다. 여기서는 반지름과 방향, 이름이 인자이고 로봇은 앞으로 달립니다.",
    ),
)

SPEED_AS_RATE = WrongStep(
    "speed as rate",
    {"rate": "speed"},
    Text(
        en="You took the speed [m/s] for the rate of turning [rad/s]. On a larger circle the same speed turns more slowly: divide by the radius.",
        ko="속도[m/s]를 각속도[rad/s]로 썼습니다. 원이 클수록 같은 속도라도 천천히 돕니다. 반지름으로 나누십시오.",
    ),
)

TIMES_THE_RADIUS = WrongStep(
    "times the radius",
    {"rate": "times"},
    Text(
        en="You multiplied by the radius. On a larger circle the same speed turns more slowly.",
        ko="반지름을 곱했습니다. 원이 클수록 같은 속도라도 천천히 돕니다.",
    ),
)

ALWAYS_LEFT = WrongStep(
    "always left",
    {"side": "always left"},
    Text(
        en="Your robot always turns to the left; `is_left` is not asked.",
        ko="늘 왼쪽으로만 돕니다. `is_left`를 쓰지 않았습니다.",
    ),
)

OTHER_WAY = WrongStep(
    "other way",
    {"side": "other way"},
    Text(
        en="Left and right are exchanged. Turning left, the angle on the circle grows.",
        ko="왼쪽과 오른쪽이 바뀌었습니다. 왼쪽으로 돌면 원 위의 각도가 커집니다.",
    ),
)

OF_ONE_METRE = WrongStep(
    "of one metre",
    {"circle": "of one metre"},
    Text(
        en="The place lies on a circle of one metre: the cosine and sine still have to be multiplied by the radius.",
        ko="반지름 1미터인 원 위의 위치입니다. cos과 sin에 반지름을 곱해야 합니다.",
    ),
)

CRAB = WrongStep(
    "crab",
    {"heading": "crab"},
    Text(
        en="Your robot looks outwards, along the radius, and slides sideways: the crab of the lecture. Forward is square to the radius.",
        ko="로봇이 반지름을 따라 바깥을 보며 옆으로 미끄러집니다. 강의 자료의 게걸음입니다. 앞은 반지름과 직각입니다.",
    ),
)

BACKWARDS = WrongStep(
    "backwards",
    {"heading": "backwards"},
    Text(
        en="Your robot drives its circle in reverse: it looks against the way it goes.",
        ko="로봇이 후진으로 원을 돕니다. 가는 쪽과 반대를 보고 있습니다.",
    ),
)

LEFTS_HEADING = WrongStep(
    "left's heading",
    {"heading": "left's"},
    Text(
        en="On the circle to the right your robot drives in reverse: it still has the heading of a left turn. Which way is forward there?",
        ko="오른쪽으로 도는 원에서는 후진하고 있습니다. 왼쪽으로 돌 때의 방향 그대로입니다. 이때는 어느 쪽이 앞입니까?",
    ),
)

INWARDS = WrongStep(
    "inwards",
    {"heading": "inwards"},
    Text(
        en="Your robot looks at the middle of the circle, and slides sideways. Forward is square to the radius.",
        ko="로봇이 원의 중심을 보며 옆으로 미끄러집니다. 앞은 반지름과 직각입니다.",
    ),
)

DEGREES = WrongStep(
    "degrees",
    {"angle": "degrees"},
    Text(
        en="The heading went into sine and cosine in degrees; Python counts in radians.",
        ko="방향을 도(degree)로 sin과 cos에 넣었습니다. 파이썬은 라디안을 씁니다.",
    ),
    "M5",
)

WHOLE_ANGLE = WrongStep(
    "whole angle",
    {"half": "whole"},
    Text(
        en="The robot is turned twice as far: a quaternion holds the sine and cosine of *half* the angle.",
        ko="로봇이 두 배로 돌아갔습니다. 쿼터니언에는 각도 *절반*의 sin과 cos을 넣습니다.",
    ),
    "M5",
)

W_FIRST = WrongStep(
    "w first",
    {"quaternion": "w first"},
    Text(
        en="The cosine stands in x and the sine in w: ROS has (x, y, z, w), and a turn on the floor needs z and w.",
        ko="cos이 x에, sin이 w에 있습니다. ROS는 (x, y, z, w) 순서이고, 바닥에서 도는 회전은 z와 w를 씁니다.",
    ),
    "M5",
)

ANGLE_IN_Z = WrongStep(
    "angle in z",
    {"quaternion": "angle"},
    Text(
        en="The angle itself stands in z. A quaternion holds the sine of half of it in z, the cosine in w.",
        ko="z에 각도를 그대로 넣었습니다. z에는 각도 절반의 sin, w에는 cos을 넣습니다.",
    ),
    "M5",
)

NOT_TURNED = WrongStep(
    "not turned",
    {"quaternion": "none"},
    Text(
        en="Your robot never turns: it looks along odom's x all the way round.",
        ko="로봇이 돌지 않습니다. 원을 도는 내내 odom의 x 방향만 봅니다.",
    ),
)


TO_DEGREES = WrongStep(
    "to degrees",
    {"rate": "to degrees"},
    Text(
        en="You turned the angle on the circle into degrees, and sin and cos want radians.",
        ko="원 위의 각도를 도로 바꾸었습니다. sin과 cos은 라디안을 받습니다.",
    ),
    "M5",
)


CIRCLES_A_SECOND = WrongStep(
    "circles a second",
    {"rate": "circles"},
    Text(
        en="You took speed over radius for circles a second and multiplied by 2π. It is radians a second already.",
        ko="속도 나누기 반지름을 초당 바퀴 수로 여기고 2π를 곱했습니다. 이미 초당 라디안입니다.",
    ),
)


BY_THE_DIAMETER = WrongStep(
    "by the diameter",
    {"rate": "by diameter"},
    Text(
        en="You divided by the diameter. An arc is radius times angle.",
        ko="지름으로 나누었습니다. 호의 길이는 반지름 곱하기 각도입니다.",
    ),
)


TIME_ALONE = WrongStep(
    "time alone",
    {"rate": "time alone"},
    Text(
        en="Your robot turns by one radian a second, whatever its speed and its circle.",
        ko="속도와 원의 크기와 상관없이 초당 1라디안씩 돕니다.",
    ),
)


FROM_ZERO = WrongStep(
    "from zero",
    {"circle": "from zero"},
    Text(
        en="Your circle begins at odom's origin. It goes about the origin: at the start the robot is at (radius, 0).",
        ko="원이 odom 원점에서 시작합니다. 원은 원점을 중심으로 돌므로 처음에 로봇은 (반지름, 0)에 있습니다.",
    ),
)


AHEAD_OF_ZERO = WrongStep(
    "ahead of zero",
    {"circle": "ahead of zero"},
    Text(
        en="The place: your circle begins at odom's origin, going along x, and lies beside it. Asked for is a circle about the origin, begun at (radius, 0).",
        ko="위치: 원이 odom 원점에서 x를 따라 시작하고 원점 옆에 있습니다. 원점을 중심으로, (반지름, 0)에서 시작해야 합니다.",
    ),
)


DRIVEN_FROM_ZERO = WrongStep(
    "driven from zero",
    {"circle": "ahead of zero", "heading": "crab"},
    Text(
        en="Your robot begins at odom's origin, looking along x, and its circle lies beside it. Asked for is a circle about the origin, begun at (radius, 0).",
        ko="로봇이 odom 원점에서 x를 보고 시작하고 원이 그 옆에 있습니다. 원점을 중심으로, (반지름, 0)에서 시작해야 합니다.",
    ),
)


HEADING_OF_THE_START = WrongStep(
    "heading of the start",
    {"heading": "at the start"},
    Text(
        en="Your robot keeps the heading of its start all the way round. Forward turns with the circle.",
        ko="로봇이 처음 방향을 그대로 유지합니다. 앞은 원을 따라 돌아갑니다.",
    ),
)


STAMPED = WrongStep(
    "stamped",
    {"stamp": "set"},
    Text(
        en="You set the stamp; the task leaves it as it is.",
        ko="시각(stamp)을 바꾸었습니다. 문제에서는 그대로 둡니다.",
    ),
)

DEGREES_TO_COSINE = WrongStep(
    "degrees to the cosine",
    {"circle": "degrees"},
    Text(
        en="The place: sine and cosine are given degrees. They take radians, as speed over radius gives them.",
        ko="위치: sin과 cos에 도(degree)를 넣었습니다. 라디안을 받습니다. 속력을 반지름으로 나누면 라디안입니다.",
    ),
    "M5",
)

SINE_FIRST = WrongStep(
    "sine first",
    {"circle": "sine first"},
    Text(
        en="The place: sine and cosine have changed places. At the start the robot is on the x axis.",
        ko="위치: sin과 cos의 자리가 바뀌었습니다. 처음에 로봇은 x축 위에 있습니다.",
    ),
)


PLACE_ALWAYS_LEFT = WrongStep(
    "place always left",
    {"side": "place always left"},
    Text(
        en="To the right your robot still goes round to the left: `is_left` changes only which way it looks. There the angle on the circle falls below zero, for place and heading.",
        ko="오른쪽으로 돌 때도 위치는 왼쪽으로 돕니다. `is_left`에 따라 바라보는 방향만 바뀝니다. 오른쪽에서는 원 위의 각도가 음수가 되고, 위치와 방향 모두 그 각도를 씁니다.",
    ),
)


HEADING_ALONE = WrongStep(
    "place mirrored twice",
    {"side": "heading alone"},
    Text(
        en="To the right the heading turns rightly, and the place goes round to the left: its y has the wrong sign there.",
        ko="오른쪽으로 돌 때 방향은 맞는데 위치는 왼쪽으로 돕니다. 거기서 y의 부호가 반대입니다.",
    ),
)


RADIUS_OVER_SPEED = WrongStep(
    "radius over speed",
    {"rate": "turned over"},
    Text(
        en="You divided the radius by the speed. The rate of turning is speed over radius: on a larger circle it is smaller.",
        ko="반지름을 속도로 나누었습니다. 도는 빠르기는 속도 / 반지름입니다. 원이 클수록 느립니다.",
    ),
)


IN_ROUNDS = WrongStep(
    "in rounds",
    {"rate": "in rounds"},
    Text(
        en="Your angle counts rounds: it lacks the factor 2π that makes radians of them.",
        ko="각도를 바퀴 수로 셌습니다. 라디안으로 만드는 2π가 빠졌습니다.",
    ),
    "M5",
)


TASK = Task(
    id="E6.4",
    kind="F",
    points=4,
    title=Text(en="A circle that drives forward", ko="앞으로 달리는 원"),
    answer="on_circle",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation", "header.stamp"),
    ),
    inputs=circles,
    variants=3,
    model=driven,
    mistakes=(
        SWAPPED,
        FIXED_NAMES,
        QUARTER_IN_DEGREES,
        AS_IN_THE_LECTURE,
        SPEED_AS_RATE,
        TIMES_THE_RADIUS,
        ALWAYS_LEFT,
        OTHER_WAY,
        OF_ONE_METRE,
        CRAB,
        BACKWARDS,
        LEFTS_HEADING,
        INWARDS,
        DEGREES,
        WHOLE_ANGLE,
        W_FIRST,
        ANGLE_IN_Z,
        NOT_TURNED,
        TO_DEGREES,
        CIRCLES_A_SECOND,
        BY_THE_DIAMETER,
        TIME_ALONE,
        FROM_ZERO,
        AHEAD_OF_ZERO,
        DRIVEN_FROM_ZERO,
        HEADING_OF_THE_START,
        STAMPED,
        DEGREES_TO_COSINE,
        SINE_FIRST,
        PLACE_ALWAYS_LEFT,
        HEADING_ALONE,
        RADIUS_OVER_SPEED,
        IN_ROUNDS,
    ),
    hints=(
        Text(
            en="First the angle θ of the place on the circle, then the place, then where the robot looks.",
            ko="먼저 원 위 위치의 각도 θ, 다음으로 위치, 마지막으로 로봇이 보는 방향을 구하십시오.",
        ),
        Text(
            en="θ = speed / radius × time, negative to the right. The place is (radius·cos θ, radius·sin θ).",
            ko="θ = 속도 / 반지름 × 시간이고, 오른쪽으로 돌면 음수입니다. 위치는 (반지름·cos θ, 반지름·sin θ)입니다.",
        ),
        Text(
            en="Forward is a quarter turn ahead of the radius: θ + π/2 on the way left, θ − π/2 on the way right. Half of it goes into sine and cosine.",
            ko="앞은 반지름에서 90° 돌아간 방향입니다. 왼쪽이면 θ + π/2, 오른쪽이면 θ − π/2입니다. 그 절반을 sin과 cos에 넣으십시오.",
        ),
    ),
    misconceptions=("M2", "M5"),
)
