"""E7.5: How is this IMU screwed on?"""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Choice, Number, Parts, Task, Text, WrongAnswer

MOUNTS = {
    "as drawn": {},
    "left": {"yaw": math.pi / 2},
    "right": {"yaw": -math.pi / 2},
    "backwards": {"yaw": math.pi},
    "rolled over": {"roll": math.pi},
    "pitched over": {"pitch": math.pi},
    "pitched over, left": {"pitch": math.pi, "yaw": math.pi / 2},
    "pitched over, right": {"pitch": math.pi, "yaw": -math.pi / 2},
}
MENDS = ("rpy in the joint", "rpy in the visual", "minus in my node", "leave it")


def an_imu(rng):
    """Means of some seconds, with the sensor's noise; never as drawn, for then there is nothing to find."""
    mount = str(rng.choice([name for name in MOUNTS if name != "as drawn"]))
    speed, rate = round(float(rng.uniform(0.5, 1.0)), 2), round(float(rng.uniform(0.5, 0.9)), 2)
    imu_R_base = Transform.from_rpy(**MOUNTS[mount]).inverse()
    readings = [imu_R_base.apply((0.0, pull, 9.81)) for pull in (0.0, speed * rate)]
    at_rest, in_bend = ([round(float(each + 0.01 * rng.standard_normal()), 3) for each in read] for read in readings)
    return {"at_rest": at_rest, "in_left_bend": in_bend, "speed_mps": speed, "yaw_rate_radps": rate}


def with_x_and_y_exchanged(given) -> dict:
    """Return the answers of one who reads the accelerometer as (y, x, z)."""
    x, y, z = given.in_left_bend
    pull = (0.0, given.speed_mps * given.yaw_rate_radps, 9.81)
    mount = min(MOUNTS, key=lambda each: math.dist((y, x, z), Transform.from_rpy(**MOUNTS[each]).inverse().apply(pull)))
    rate = given.yaw_rate_radps
    return {"mount": mount, "gyro_z": rate if z > 0 else -rate, "mend": MENDS[3 if mount == "as drawn" else 0]}


X_AND_Y_EXCHANGED = WrongAnswer(
    "x and y exchanged",
    with_x_and_y_exchanged,
    Text(
        en="that would be the mount if x and y were exchanged. The readings are (x, y, z): in which number is the bend?",
        ko="x와 y를 서로 바꾸었을 때의 장착입니다. 값은 (x, y, z) 순서입니다. 굽은 길의 값은 몇째 숫자에 나옵니까?",
    ),
    part="mount",
)


TASK = Task(
    id="E7.5",
    kind="D",
    points=4,
    title=Text(en="How is this IMU screwed on?", ko="이 IMU는 어떻게 달렸습니까?"),
    answer="imu",
    form=Parts({"mount": Choice(tuple(MOUNTS)), "gyro_z": Number("rad/s", 0.02), "mend": Choice(MENDS)}),
    given=an_imu,
    variants=8,
    mistakes=(X_AND_Y_EXCHANGED,),
    means={
        "as drawn": Text(
            en="then at rest z reads +9.8, and in a bend to the left y reads above 0, as along the robot's own y.",
            ko="그렇다면 서 있을 때 z가 +9.8이고, 왼쪽으로 굽은 길에서 +y가 커져야 합니다.",
        ),
        "left": Text(
            en="then z reads +9.8, and its x points to the robot's left: the bend is read along +x.",
            ko="그렇다면 z가 +9.8이고 x가 로봇의 왼쪽을 향하므로, 굽은 길의 값이 +x에 나와야 합니다.",
        ),
        "right": Text(
            en="then z reads +9.8, and its x points to the robot's right: the bend is read along −x.",
            ko="그렇다면 z가 +9.8이고 x가 로봇의 오른쪽을 향하므로, 굽은 길의 값이 −x에 나와야 합니다.",
        ),
        "backwards": Text(
            en="then z reads +9.8, and its y points to the robot's right: the bend is read along −y.",
            ko="그렇다면 z가 +9.8이고 y가 로봇의 오른쪽을 향하므로, 굽은 길의 값이 −y에 나와야 합니다.",
        ),
        "rolled over": Text(
            en="then z reads −9.8, and its y points to the robot's right: the bend is read along −y.",
            ko="그렇다면 z가 −9.8이고 y가 로봇의 오른쪽을 향하므로, 굽은 길의 값이 −y에 나와야 합니다.",
        ),
        "pitched over": Text(
            en="then z reads −9.8, and its y still points to the robot's left: the bend is read along +y.",
            ko="그렇다면 z가 −9.8이고 y는 그대로 로봇의 왼쪽을 향하므로, 굽은 길의 값이 +y에 나와야 합니다.",
        ),
        "pitched over, left": Text(
            en="then z reads −9.8, and its x points to the robot's right: the bend is read along −x.",
            ko="그렇다면 z가 −9.8이고 x가 로봇의 오른쪽을 향하므로, 굽은 길의 값이 −x에 나와야 합니다.",
        ),
        "pitched over, right": Text(
            en="then z reads −9.8, and its x points to the robot's left: the bend is read along +x.",
            ko="그렇다면 z가 −9.8이고 x가 로봇의 왼쪽을 향하므로, 굽은 길의 값이 +x에 나와야 합니다.",
        ),
        "rpy in the visual": Text(
            en="that turns the paint. TF, and whoever asks it, learns nothing of it.",
            ko="겉모습만 돕니다. TF도, TF에 묻는 프로그램도 알지 못합니다.",
        ),
        "minus in my node": Text(
            en="a minus cures one number in one program. The other axes, and all other programs, read the URDF.",
            ko="마이너스는 한 프로그램의 숫자 하나만 고칩니다. 다른 축과 다른 프로그램은 URDF를 읽습니다.",
        ),
        "leave it": Text(
            en="then every vector stays turned: its readings are not those of the drawing.",
            ko="그러면 모든 벡터가 돌아간 채로 남습니다. 값이 도면과 다릅니다.",
        ),
    },
    shows={
        "gyro_z": Text(
            en="A gyro's z turns about the IMU's own z: left is positive only while that points up.",
            ko="자이로 z는 IMU 자신의 z축 둘레 회전입니다. 그 z가 위를 향할 때만 왼쪽이 양수입니다.",
        ),
    },
    hints=(
        Text(
            en="At rest: does z read +9.8 or −9.8? That tells upright from upside down, and nothing else.",
            ko="서 있을 때 z가 +9.8입니까, −9.8입니까? 바로 섰는지 뒤집혔는지만 알려 줍니다.",
        ),
        Text(
            en="In a bend to the left the pull is to the robot's left. Which of the IMU's axes feels it, with which sign?",
            ko="왼쪽으로 굽은 길에서는 로봇의 왼쪽으로 당겨집니다. IMU의 어느 축에 어떤 부호로 나타납니까?",
        ),
        Text(
            en="gyro z is the yaw rate where z points up, and its negative where z points down. Say the mount where TF reads it.",
            ko="자이로 z는 z가 위를 향하면 yaw rate 그대로, 아래를 향하면 부호가 반대입니다. 장착은 TF가 읽는 곳에 적으십시오.",
        ),
    ),
    misconceptions=("M4",),
)
