"""E2.6: A cloud at ninety degrees."""

from __future__ import annotations

import numpy as np

from tflab.core import Transform
from tflab.workbook.tasks import Choice, Draws, Parts, Task, Text, WrongAnswer

OPTICAL_RPY_DEG = (-90.0, 0.0, -90.0)
STRAIGHT_DEG = (0.0, 0.0, 0.0)
LINK, OPTICAL = "camera_link", "camera_optical_frame"
ODD = (  # the header, the camera's mount, the optical one: one of the three is not as it should be
    (LINK, STRAIGHT_DEG, OPTICAL_RPY_DEG),
    (OPTICAL, STRAIGHT_DEG, STRAIGHT_DEG),
    (OPTICAL, STRAIGHT_DEG, (-90.0, 0.0, 0.0)),
    (OPTICAL, OPTICAL_RPY_DEG, OPTICAL_RPY_DEG),
    (OPTICAL, (0.0, -90.0, 0.0), OPTICAL_RPY_DEG),
)


DIAGNOSIS = Parts(
    {
        "wall_appears": Choice(("ahead", "above", "left", "right")),
        "fault": Choice(("header", "mount of camera_link", "mount of camera_optical_frame", "data", "quaternion")),
        "change": Choice(("driver", "URDF", "my node")),
    }
)


def turned_cloud(rng: Draws) -> dict:
    """Draw one of five ways to turn a cloud by ninety degrees: the evidence, as one would read it off."""
    frame_id, body_deg, optical_deg = ODD[int(rng.integers(len(ODD)))]
    return {
        "header_frame_id": frame_id,
        "rpy_of_camera_link_in_base_link_deg": body_deg,
        "rpy_of_camera_optical_frame_in_camera_link_deg": optical_deg,
        "wall_in_the_cloud_optical_z_m": round(float(rng.uniform(1.5, 3.0)), 1),
    }


def wall_appears(given) -> str:
    """Return where in base_link the cloud's depth points, its z."""
    mounts = [given.rpy_of_camera_link_in_base_link_deg]
    if given.header_frame_id == OPTICAL:
        mounts.append(given.rpy_of_camera_optical_frame_in_camera_link_deg)
    depth = np.array([0.0, 0.0, 1.0])
    for rpy_deg in reversed(mounts):
        depth = Transform.from_rpy(*np.radians(rpy_deg)).apply(depth)
    x, y, z = np.round(depth)
    return {(1, 0, 0): "ahead", (0, 0, 1): "above", (0, 1, 0): "left", (0, -1, 0): "right"}[x, y, z]


TURN_THE_DATA = WrongAnswer(
    "turn the data",
    lambda given: {"wall_appears": wall_appears(given), "fault": "data", "change": "my node"},
    Text(
        en="The numbers are what the camera measured: right, down, forward. To turn them would mend one program, and break on the day the cause is mended; one of the three labels or mounts is not what it should be.",
        ko="숫자는 카메라가 잰 그대로입니다(오른쪽, 아래, 앞). 숫자를 돌리면 프로그램 하나만 맞고, 원인이 고쳐지는 날 그것마저 틀려집니다. 세 이름표와 장착 가운데 하나가 잘못되었습니다.",
    ),
    misconception="M4",
    part="fault",
)


QUATERNION = WrongAnswer(
    "quaternion",
    lambda given: {"wall_appears": wall_appears(given), "fault": "quaternion", "change": "URDF"},
    Text(
        en="A quaternion of zeros would not turn the cloud: the transform would be refused and nothing drawn. One with w first would show in the angles: -90 0 -90 does not come of it, that is how an optical frame is mounted. Look at the three lines of evidence.",
        ko="모두 0인 쿼터니언이라면 변환이 거절되어 아무것도 그려지지 않습니다. w를 먼저 썼다면 각도에 드러납니다. -90 0 -90은 그렇게 나온 값이 아니라 광학 좌표계의 올바른 장착입니다. 증거 세 줄을 보십시오.",
    ),
    misconception="M5",
    part="fault",
)


def named(given) -> dict:
    """Return what is wrong, and where it is mended."""
    if given.header_frame_id == "camera_link":
        return {"fault": "header", "change": "driver"}
    mount = OPTICAL if tuple(given.rpy_of_camera_link_in_base_link_deg) == STRAIGHT_DEG else LINK
    return {"fault": f"mount of {mount}", "change": "URDF"}


def at_the_wrong_end(given) -> dict:
    """Blame the mount for a wrong header, and the header for a wrong mount."""
    if given.header_frame_id == "camera_link":
        return {"wall_appears": wall_appears(given), "fault": "mount of camera_optical_frame", "change": "URDF"}
    return {"wall_appears": wall_appears(given), "fault": "header", "change": "driver"}


WRONG_END = WrongAnswer(
    "wrong end",
    at_the_wrong_end,
    Text(
        en="You blame a line that is as it should be. Take the three lines of evidence one by one: a depth cloud's header names the optical frame; camera_link looks ahead, 0 0 0; the optical frame is turned -90 0 -90 in it. Which one differs?",
        ko="멀쩡한 것을 의심하고 있습니다. 증거 세 줄을 하나씩 보십시오. 깊이 클라우드의 헤더에는 광학 좌표계가 적힙니다. camera_link는 앞을 보므로 0 0 0입니다. 광학 좌표계는 camera_link를 기준으로 -90 0 -90만큼 돌아가 있습니다. 어느 것이 다릅니까?",
    ),
    misconception="M4",
    part="fault",
)


def mended_elsewhere(given) -> dict:
    """Find the fault, and mend a header in the URDF or a mount in the driver."""
    found = named(given)
    change = "URDF" if found["change"] == "driver" else "driver"
    return {"wall_appears": wall_appears(given), "fault": found["fault"], "change": change}


MENDED_ELSEWHERE = WrongAnswer(
    "mended elsewhere",
    mended_elsewhere,
    Text(
        en="You would mend it in the wrong file. Who writes a header: the program that sends the data, or the robot's description? And who says where a camera is bolted on?",
        ko="엉뚱한 곳을 고치려 합니다. 헤더는 데이터를 보내는 프로그램이 씁니까, 로봇 모델이 씁니까? 카메라가 어디에 달려 있는지는 어디에 적습니까?",
    ),
    misconception="M4",
)


def the_other_mount(given) -> dict:
    """Blame camera_link whatever the evidence, or the optical frame if camera_link it is."""
    blamed = OPTICAL if named(given)["fault"] == f"mount of {LINK}" else LINK
    return {"wall_appears": wall_appears(given), "fault": f"mount of {blamed}", "change": "URDF"}


OTHER_MOUNT = WrongAnswer(
    "other mount",
    the_other_mount,
    Text(
        en="The mount that you blame is as it should be. camera_link has to look ahead, 0 0 0; the turn by -90 0 -90 belongs exactly once between base_link and the data, between camera_link and camera_optical_frame. If both mounts are so, the header is left.",
        ko="멀쩡한 장착 변환을 의심하고 있습니다. camera_link는 0 0 0으로 앞을 보아야 하고, -90 0 -90 회전은 base_link와 데이터 사이에 딱 한 번, camera_link와 camera_optical_frame 사이에 있어야 합니다. 두 장착 변환이 모두 그렇다면 헤더를 보십시오.",
    ),
    misconception="M4",
    part="fault",
)


TASK = Task(
    id="E2.6",
    kind="D",
    points=3,
    title=Text(en="A cloud at ninety degrees", ko="90° 돌아간 클라우드"),
    answer="diagnosis",
    form=DIAGNOSIS,
    given=turned_cloud,
    variants=20,
    mistakes=(
        TURN_THE_DATA,
        WRONG_END,
        OTHER_MOUNT,
        MENDED_ELSEWHERE,
        QUATERNION,
    ),
    hints=(
        Text(
            en="Write down the chain from the data to base_link: header, then the optical mount, then the camera's mount. The turn by -90 0 -90 should occur once, whole, and nothing else should turn.",
            ko="데이터에서 base_link까지의 길을 적으십시오. 헤더, 광학 좌표계 장착, 카메라 장착 순서입니다. -90 0 -90 회전이 온전히 한 번 나오고, 그 밖에는 돌지 않아야 합니다.",
        ),
        Text(
            en="Follow the wall's depth, the z of the data, along that chain: what does each turn make of it? In base_link, x is ahead, y to the left, z up.",
            ko="벽까지의 깊이, 곧 데이터의 z를 그 길을 따라 옮겨 보십시오. 회전마다 어느 축이 됩니까? base_link에서는 x가 앞, y가 왼쪽, z가 위입니다.",
        ),
        Text(
            en="A header is set in the driver, a mount in the URDF. The data stays as it is, always.",
            ko="헤더는 드라이버에서, 장착 변환은 URDF에서 고칩니다. 데이터는 언제나 그대로 둡니다.",
        ),
    ),
    misconceptions=("M4",),
    means={
        "data": Text(
            en="the numbers are what the camera measured: to turn them mends one node, and breaks on the day the cause is mended.",
            ko="숫자는 카메라가 잰 그대로입니다. 숫자를 돌리면 노드 하나만 맞고, 원인이 고쳐지는 날 망가집니다.",
        ),
        "quaternion": Text(
            en="a quaternion of zeros would be refused, and w first would show in the angles.",
            ko="모두 0인 쿼터니언은 거절되고, w를 먼저 썼다면 각도에 드러납니다.",
        ),
        "header": Text(
            en="the header names camera_optical_frame, as that of a depth cloud should.",
            ko="헤더에는 camera_optical_frame이 적혀 있고, 깊이 클라우드라면 그래야 합니다.",
        ),
        "mount of camera_link": Text(
            en="camera_link looks ahead, 0 0 0, as it should.",
            ko="camera_link는 0 0 0으로 앞을 봅니다. 그래야 합니다.",
        ),
        "mount of camera_optical_frame": Text(
            en="the optical frame is turned by -90 0 -90 in camera_link, as it should be.",
            ko="광학 좌표계는 camera_link에서 -90 0 -90만큼 돌아가 있습니다. 그래야 합니다.",
        ),
        "driver": Text(
            en="a mount is not written in the driver.",
            ko="장착 변환은 드라이버에 적지 않습니다.",
        ),
        "URDF": Text(
            en="a header is not written in the URDF: the program that sends the data writes it.",
            ko="헤더는 URDF에 적지 않습니다. 데이터를 보내는 프로그램이 씁니다.",
        ),
        "my node": Text(
            en="in your own node you would mend it for yourself alone.",
            ko="내 노드에서 고치면 나에게만 고쳐집니다.",
        ),
        "right": Text(
            en="right is -y of base_link: then the depth, the third number, would have to be read as -y, as where the optical turn is made twice, or backwards.",
            ko="오른쪽은 base_link의 -y입니다. 그러려면 세 번째 숫자인 깊이가 -y로 읽혀야 하고, 광학 좌표계의 회전을 두 번 하거나 거꾸로 하면 그렇게 됩니다.",
        ),
        "left": Text(
            en="left is +y of base_link: then the depth, the third number, would have to be read as y, as where of the optical turn only the roll is made. Without any turn the second number is y, which counts down, to the floor.",
            ko="왼쪽은 base_link의 +y입니다. 그러려면 세 번째 숫자인 깊이가 y로 읽혀야 하고, 광학 좌표계의 회전 가운데 roll만 하면 그렇게 됩니다. 아예 돌리지 않으면 y가 되는 것은 두 번째 숫자, 곧 바닥이 있는 아래쪽입니다.",
        ),
        "above": Text(
            en="above is +z of base_link: then the depth, the third number, would have to be read as z, as where the optical turn is not made at all.",
            ko="위는 base_link의 +z입니다. 그러려면 세 번째 숫자인 깊이가 z로 읽혀야 하고, 광학 좌표계의 회전을 아예 하지 않으면 그렇게 됩니다.",
        ),
        "ahead": Text(
            en="ahead is where the wall would be if nothing were wrong.",
            ko="아무 이상이 없다면 벽이 앞에 있을 것입니다.",
        ),
    },
    shows={
        "wall_appears": Text(
            en="Take (right, down, forward) as the fault makes it be read: which one becomes x, which one z?",
            ko="(오른쪽, 아래, 앞)을 이 결함이 읽는 대로 따라가 보십시오. 어느 것이 x가 되고 어느 것이 z가 됩니까?",
        ),
    },
)
