"""The tasks of chapter 2: which way is forward, which way does it turn, and is this a rotation at all?

Every mistake that is named here has been made on a robot.  Axes are REP-103's;
quaternions are (x, y, z, w).
"""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.answers.forms import Choice, Number, Parts, Quaternion, Vector
from tflab.workbook.tasks.task import Task, Twin, Words

SIGN = Choice(("positive", "negative"))
SIGNS = {
    "angular_z_turning_left": "positive",
    "pitch_nose_down": "positive",
    "y_right_in_base_link": "negative",
    "x_right_in_optical_frame": "positive",
    "y_above_in_optical_frame": "negative",
}
BODY_RIGHT, OPTICAL_RIGHT, OPTICAL_UP = list(SIGNS)[2:]


def signs(*changed: str) -> dict[str, str]:
    """Return the right signs, but for those named."""
    other = {"positive": "negative", "negative": "positive"}
    return {name: other[sign] if name in changed else sign for name, sign in SIGNS.items()}


# E2.2: a point of the picture ------------------------------------------------------


def detection(rng: np.random.Generator) -> dict:
    """Draw a detection whose three numbers cannot be mistaken for one another."""
    right = rng.choice((-1, 1)) * rng.uniform(0.25, 0.45)
    down = rng.choice((-1, 1)) * rng.uniform(0.55, 0.80)
    return {"optical_p_part": (round(float(right), 2), round(float(down), 2), round(float(rng.uniform(1.2, 3.0)), 2))}


def picked(x: float, y: float, z: float) -> dict[str, tuple[float, float, float]]:
    """Return what each mistake makes of (right, down, forward)."""
    return {
        "forgotten": (x, y, z),
        "backwards": (-y, -z, x),
        "no signs": (z, x, y),
        "up and down": (z, -x, y),
        "side and height": (z, -y, -x),
        "behind": (-z, -x, -y),
        "left and right": (z, x, -y),
        "in base_link": (z + 0.10, -x, -y + 0.30),
        "other order": (y, z, x),
        "degrees": Transform.from_rpy(roll=-90.0, yaw=-90.0).apply((x, y, z)),
    }


# E2.3: the quaternion of a yaw -----------------------------------------------------


def yaws(rng: np.random.Generator) -> list[tuple[float]]:
    """Draw turns to the left and to the right, small and large, and the two that are easy to get right by chance."""
    drawn = (rng.uniform(0.3, 1.4), -rng.uniform(0.3, 1.4), rng.uniform(1.8, 2.9), -rng.uniform(1.8, 2.9))
    return [(0.0,), (math.pi / 2,), *((round(float(yaw), 3),) for yaw in drawn)]


# E2.4: is this a rotation at all? --------------------------------------------------

VERDICTS = ("ok", "nan", "zero", "not unit", "w first")


def quaternions(rng: np.random.Generator) -> list[tuple[tuple[float, float, float, float]]]:
    """Draw good ones, in every dress that a good one may wear, and one of each bad kind."""

    def yawed(low: float, high: float) -> tuple[float, float, float, float]:
        return Transform.from_rpy(yaw=float(rng.uniform(low, high))).rotation

    good, negative, rough = yawed(0.4, 1.4), yawed(-2.4, -0.6), yawed(1.6, 2.6)
    length, share = float(rng.uniform(1.5, 3.0)), round(float(rng.uniform(0.35, 0.65)), 2)
    drawn = [
        (0.0, 0.0, 0.0, 1.0),
        good,
        tuple(-part for part in negative),
        (0.0, 0.0, 1.0, 0.0),
        (0.0, 0.0, -math.sqrt(0.5), math.sqrt(0.5)),
        tuple(1.008 * part for part in good),
        tuple(math.floor(1000.0 * part) / 1000.0 for part in rough),
        (0.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, math.nan, 1.0),
        (math.inf, 0.0, 0.0, 1.0),
        tuple(length * part for part in good),
        (0.0, 0.0, share, round(1.0 - share, 2)),
        wxyz_from_xyzw(yawed(0.3, 1.2)),
        tuple(-part for part in wxyz_from_xyzw(yawed(0.3, 1.2))),
        tuple(length * part for part in wxyz_from_xyzw(yawed(0.3, 1.2))),
        Transform.from_rpy(pitch=float(rng.uniform(0.4, 1.2))).rotation,
    ]
    return [(q,) for q in drawn]


def judged(q: tuple, *, nan=True, zero=True, tolerance=0.01, norm=2, last_sign=False, zero_by_w=False) -> str:
    """Judge a quaternion as the task asks; the options are the mistakes."""
    x, y, _, w = q
    if nan and not all(math.isfinite(part) for part in q):
        return "nan"
    length = float(np.linalg.norm(np.array(q, dtype=float), norm))
    if (zero_by_w and w == 0.0) or (zero and length < 1e-6):
        return "zero"
    if abs(length - 1.0) > tolerance:
        return "not unit"
    if abs(x) > 0.1 or abs(y) > 0.1 or (last_sign and w < 0.0):
        return "w first"
    return "ok"


def w_first_before_length(q: tuple) -> str:
    """Ask whether w is first before asking how long the quaternion is."""
    early = all(math.isfinite(part) for part in q) and max(abs(q[0]), abs(q[1])) > 0.1
    return "w first" if early else judged(q)


def zero_by_sum(q: tuple) -> str:
    """Add the four numbers up, signs and all, to see whether there is any length."""
    return "zero" if abs(sum(q)) < 1e-6 else judged(q)


def judged_by_square(q: tuple) -> str:
    """Forget the root of the length."""
    verdict = judged(q)
    return "not unit" if verdict in ("ok", "w first") and abs(math.hypot(*q) ** 2 - 1.0) > 0.01 else verdict


def judged_without_sign(q: tuple) -> str:
    """Look for a large x or y, but not for one that is largely negative."""
    verdict = judged(q)
    return "ok" if verdict == "w first" and max(q[:2]) <= 0.1 else verdict


def judged_by_x(q: tuple) -> str:
    """Look at x alone, where a w that came first would land."""
    verdict = judged(q)
    return "ok" if verdict == "w first" and abs(q[0]) <= 0.1 else verdict


def short_passes(q: tuple) -> str:
    """Refuse what is too long, but not what is too short."""
    verdict = judged(q)
    return "ok" if verdict == "not unit" and math.hypot(*q) < 1.0 else verdict


# E2.5: two turns -------------------------------------------------------------------


def two_turns(rng: np.random.Generator) -> dict:
    """Draw a yaw and a pitch, both large enough for their order to be seen."""
    yaw = rng.choice((-1, 1)) * rng.uniform(0.5, 2.0)
    pitch = rng.choice((-1, 1)) * rng.uniform(0.4, 1.2)
    return {"first_yaw_rad": round(float(yaw), 2), "then_pitch_rad": round(float(pitch), 2)}


def turned(given, unit: float = 1.0) -> Transform:
    """Return first the yaw, then the pitch, about the fixed axes."""
    return Transform.from_rpy(pitch=unit * given.then_pitch_rad) @ Transform.from_rpy(yaw=unit * given.first_yaw_rad)


# E2.6: a cloud at ninety degrees ---------------------------------------------------

OPTICAL_RPY_DEG = (-90.0, 0.0, -90.0)
STRAIGHT_DEG = (0.0, 0.0, 0.0)
DIAGNOSIS = Parts(
    {
        "wall_appears": Choice(("ahead", "above", "left", "right")),
        "fault": Choice(("header", "mount of camera_link", "mount of camera_optical_frame", "data", "quaternion")),
        "change": Choice(("driver", "URDF", "my node")),
    }
)


def turned_cloud(rng: np.random.Generator) -> dict:
    """Draw one of three ways to turn a cloud by ninety degrees: the evidence, as one would read it off."""
    frame_id, body_deg, optical_deg = (
        ("camera_link", STRAIGHT_DEG, OPTICAL_RPY_DEG),
        ("camera_optical_frame", STRAIGHT_DEG, STRAIGHT_DEG),
        ("camera_optical_frame", OPTICAL_RPY_DEG, OPTICAL_RPY_DEG),
    )[int(rng.integers(3))]
    return {
        "header_frame_id": frame_id,
        "rpy_of_camera_link_in_base_link_deg": body_deg,
        "rpy_of_camera_optical_frame_in_camera_link_deg": optical_deg,
        "wall_in_the_cloud_optical_z_m": round(float(rng.uniform(1.5, 3.0)), 1),
    }


def wall_appears(given) -> str:
    return "above" if given.rpy_of_camera_link_in_base_link_deg == STRAIGHT_DEG else "right"


def named(given) -> dict:
    """Return what is wrong, and where it is mended."""
    if given.header_frame_id == "camera_link":
        return {"fault": "header", "change": "driver"}
    mount = "camera_optical_frame" if wall_appears(given) == "above" else "camera_link"
    return {"fault": f"mount of {mount}", "change": "URDF"}


def at_the_wrong_end(given) -> dict:
    """Blame the mount for a wrong header, and the header for a wrong mount."""
    if given.header_frame_id == "camera_link":
        return {"wall_appears": wall_appears(given), "fault": "mount of camera_optical_frame", "change": "URDF"}
    return {"wall_appears": wall_appears(given), "fault": "header", "change": "driver"}


def mended_elsewhere(given) -> dict:
    """Find the fault, and mend a header in the URDF or a mount in the driver."""
    found = named(given)
    change = "URDF" if found["change"] == "driver" else "driver"
    return {"wall_appears": wall_appears(given), "fault": found["fault"], "change": change}


def the_other_mount(given) -> dict:
    """Blame camera_link whatever the evidence, or the optical frame if camera_link it is."""
    blamed = "camera_link" if wall_appears(given) == "above" else "camera_optical_frame"
    return {"wall_appears": wall_appears(given), "fault": f"mount of {blamed}", "change": "URDF"}


# E2.7: a little too few digits -----------------------------------------------------


def few_digits(rng: np.random.Generator) -> dict:
    """Draw how pi/2 was written in a URDF, and how far away one looks."""
    written = float(rng.choice((1.56, 1.57, 1.58)))
    return {"written_yaw_rad": written, "range_m": round(float(rng.uniform(6.0, 30.0)), 1)}


def missing_rad(given) -> float:
    return abs(math.pi / 2 - given.written_yaw_rad)


TASKS = (
    Task(
        id="E2.1",
        kind="M",
        points=3,
        title=Words(en="Say the sign", ko="부호를 말하십시오"),
        answer="signs",
        form=Parts(dict.fromkeys(SIGNS, SIGN)),
        twins=(
            Twin(
                "aeroplane",
                signs("pitch_nose_down"),
                Words(
                    en="That is an aeroplane's pitch, whose z points down. Here z points up: lay the thumb of your right hand along y, to the left, and see where the fingers take the nose.",
                    ko="그것은 z가 아래를 향하는 비행기의 pitch입니다. 여기서는 z가 위를 향합니다. 오른손 엄지를 y, 곧 왼쪽으로 뻗고 나머지 손가락이 기수를 어디로 보내는지 보십시오.",
                ),
            ),
            Twin(
                "compass",
                signs("angular_z_turning_left"),
                Words(
                    en="A compass counts clockwise; REP-103 does not. Thumb up along z: which way do the fingers curl?",
                    ko="나침반은 시계 방향으로 세지만 REP-103은 그렇지 않습니다. 엄지를 z 방향으로 세우면 나머지 손가락은 어느 쪽으로 감깁니까?",
                ),
            ),
            Twin(
                "right is plus",
                signs("y_right_in_base_link"),
                Words(
                    en="On paper, right is plus. On a robot's body, look where y points: hold up the pistol hand.",
                    ko="종이 위에서는 오른쪽이 양수입니다. 로봇 본체에서는 y가 어디를 가리킵니까? 오른손을 권총 모양으로 들어 보십시오.",
                ),
            ),
            Twin(
                "optical as body",
                signs(OPTICAL_RIGHT, OPTICAL_UP),
                Words(
                    en="You read the optical frame with the body's habits. A picture counts to the right and down.",
                    ko="광학 좌표계를 본체의 습관으로 읽었습니다. 영상은 오른쪽과 아래로 셉니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "y up in the picture",
                signs(OPTICAL_UP),
                Words(
                    en="In school, y goes up. In a picture, row 0 is at the top: which way do the rows count?",
                    ko="학교에서 배운 y는 위로 갑니다. 영상에서는 0번 행이 맨 위입니다. 행 번호는 어느 쪽으로 커집니까?",
                ),
                misconception="M4",
            ),
        ),
        hints=(
            Words(en="Do not calculate. Use your right hand.", ko="계산하지 마십시오. 오른손을 쓰십시오."),
            Words(
                en="For a turn: thumb along the axis, fingers curl the positive way. For a place: is it where the axis points, or on the other side?",
                ko="회전이라면 엄지를 축 방향으로 뻗으십시오. 나머지 손가락이 감기는 쪽이 양수입니다. 위치라면 축이 가리키는 쪽에 있는지 반대쪽에 있는지 보십시오.",
            ),
            Words(
                en="Body: x forward, y left, z up. Picture: x right, y down, z forward. Pitch turns z towards x.",
                ko="본체는 x 앞, y 왼쪽, z 위입니다. 영상은 x 오른쪽, y 아래, z 앞입니다. pitch는 z를 x 쪽으로 돌립니다.",
            ),
        ),
        cures=("M4",),
    ),
    Task(
        id="E2.2",
        kind="N",
        points=3,
        title=Words(en="From the picture to the camera", ko="영상에서 카메라로"),
        answer="camera_p_part",
        form=Vector(3, unit="m", frame="camera_link", tolerance=0.005),
        given=detection,
        variants=5,
        twins=(
            Twin(
                "forgotten",
                lambda given: picked(*given.optical_p_part)["forgotten"],
                Words(
                    en="These are the numbers of the picture, unchanged. In camera_link, which of the three says how far ahead?",
                    ko="영상의 숫자를 그대로 썼습니다. camera_link에서는 셋 가운데 무엇이 앞으로의 거리입니까?",
                ),
                misconception="M4",
            ),
            Twin(
                "backwards",
                lambda given: picked(*given.optical_p_part)["backwards"],
                Words(
                    en="You went the other way, from the body to the picture (or turned twice: this rotation is a third of a full turn, so twice forward is once back). The part must end up in front: is your x the depth?",
                    ko="거꾸로 본체에서 영상 쪽으로 옮겼습니다. 두 번 돌려도 같은 값이 됩니다. 이 회전은 한 바퀴의 3분의 1이라서 앞으로 두 번 돌리면 뒤로 한 번 돌린 것과 같습니다. 부품은 앞에 있어야 합니다. x가 깊이와 같습니까?",
                ),
                misconception="M4",
            ),
            Twin(
                "no signs",
                lambda given: picked(*given.optical_p_part)["no signs"],
                Words(
                    en="The axes are in their places, but their directions are not: right is not left, and down is not up.",
                    ko="축의 자리는 맞지만 방향이 틀립니다. 오른쪽은 왼쪽이 아니고, 아래는 위가 아닙니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "up and down",
                lambda given: picked(*given.optical_p_part)["up and down"],
                Words(
                    en="Depth and side are right. Above and below changed places: the picture's y counts down, the body's z counts up.",
                    ko="깊이와 좌우는 맞습니다. 위아래가 바뀌었습니다. 영상의 y는 아래로, 본체의 z는 위로 셉니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "left and right",
                lambda given: picked(*given.optical_p_part)["left and right"],
                Words(
                    en="Depth and height are right. Left and right changed places: the picture's x counts to the right, the body's y to the left.",
                    ko="깊이와 높이는 맞습니다. 좌우가 바뀌었습니다. 영상의 x는 오른쪽으로, 본체의 y는 왼쪽으로 셉니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "side and height",
                lambda given: picked(*given.optical_p_part)["side and height"],
                Words(
                    en="The depth is right. Sideways and upwards changed places: in the picture x counts sideways and y downwards; on the body y is the side and z the height.",
                    ko="깊이는 맞습니다. 옆 방향과 높이의 자리가 바뀌었습니다. 영상에서는 x가 옆, y가 아래이고, 본체에서는 y가 옆, z가 높이입니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "behind",
                lambda given: picked(*given.optical_p_part)["behind"],
                Words(
                    en="Side and height are right, but this part lies behind the camera. Depth counts forward in the picture, and x counts forward on the body.",
                    ko="옆 방향과 높이는 맞지만 부품이 카메라 뒤에 있습니다. 영상의 깊이도 앞으로 세고, 본체의 x도 앞으로 셉니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "in base_link",
                lambda given: picked(*given.optical_p_part)["in base_link"],
                Words(
                    en="You went one frame too far: these are the numbers in base_link, with the camera's mount of the page added. Asked for is camera_link.",
                    ko="한 좌표계를 더 갔습니다. 본문의 카메라 장착 위치까지 더한 base_link 기준 값입니다. 문제는 camera_link 기준을 묻습니다.",
                ),
            ),
            Twin(
                "other order",
                lambda given: picked(*given.optical_p_part)["other order"],
                Words(
                    en="These are the two right turns in the other order. The roll happens first, so it stands on the right of the product: next to the point.",
                    ko="두 회전은 맞지만 순서가 반대입니다. roll을 먼저 하므로 곱에서는 오른쪽, 곧 점 바로 옆에 와야 합니다.",
                ),
            ),
            Twin(
                "degrees",
                lambda given: picked(*given.optical_p_part)["degrees"],
                Words(
                    en="You gave 90 to a turn that counts in radians: that is fourteen full turns and a bit. A quarter turn is math.pi / 2.",
                    ko="라디안으로 받는 자리에 90을 넣었습니다. 열네 바퀴가 넘는 회전입니다. 4분의 1바퀴는 math.pi / 2입니다.",
                ),
                misconception="M5",
            ),
        ),
        hints=(
            Words(
                en="Say in words where the part is, seen from the camera: ahead, right or left, above or below.",
                ko="카메라에서 볼 때 부품이 어디 있는지 먼저 말로 하십시오. 앞인지, 오른쪽인지 왼쪽인지, 위인지 아래인지.",
            ),
            Words(
                en="You need the rotation that carries optical numbers to camera_link: the one to remember, as rpy.",
                ko="광학 좌표계의 숫자를 camera_link로 옮기는 회전이 필요합니다. 외워 둔 바로 그 rpy입니다.",
            ),
            Words(
                en="Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2) is camera_T_optical; .apply() moves a point from optical to camera_link.",
                ko="Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)가 camera_T_optical입니다. .apply()로 점을 광학 좌표계에서 camera_link로 옮깁니다.",
            ),
        ),
        cures=("M4",),
    ),
    Task(
        id="E2.3",
        kind="F",
        points=3,
        title=Words(en="The quaternion of a yaw", ko="yaw를 쿼터니언으로"),
        answer="quaternion_from_yaw",
        form=Quaternion(tolerance=1e-3),
        inputs=yaws,
        variants=3,
        twins=(
            Twin(
                "whole angle",
                lambda yaw: (0.0, 0.0, math.sin(yaw), math.cos(yaw)),
                Words(
                    en="This turns twice as far as asked: a quaternion holds half the angle. Try 90°: your robot looks backwards.",
                    ko="두 배나 돌았습니다. 쿼터니언에는 각도의 절반이 들어갑니다. 90°를 넣어 보십시오. 로봇이 뒤를 보고 있습니다.",
                ),
                misconception="M5",
            ),
            Twin(
                "degrees",
                lambda yaw: (0.0, 0.0, math.sin(math.radians(yaw) / 2), math.cos(math.radians(yaw) / 2)),
                Words(
                    en="You took the argument for degrees. It comes in radians already (REP-103), and math.sin wants radians.",
                    ko="인자를 도(degree)로 받아들였습니다. 이미 라디안으로 들어오며(REP-103), math.sin도 라디안을 받습니다.",
                ),
                misconception="M5",
            ),
            Twin(
                "w first",
                lambda yaw: (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2)),
                Words(
                    en="The four numbers are right, their order is not: this is (w, x, y, z). ROS writes w last. For a yaw of 0 your robot lies on its back.",
                    ko="숫자 넷은 맞지만 순서가 (w, x, y, z)입니다. ROS는 w를 마지막에 씁니다. yaw가 0일 때 로봇이 뒤집혀 누워 있습니다.",
                ),
                misconception="M5",
            ),
            Twin(
                "sine and cosine",
                lambda yaw: (0.0, 0.0, math.cos(yaw / 2), math.sin(yaw / 2)),
                Words(
                    en="Sine and cosine changed places. Try a yaw of 0: 'no rotation' is (0, 0, 0, 1), and yours?",
                    ko="sin과 cos의 자리가 바뀌었습니다. yaw에 0을 넣어 보십시오. '회전 없음'은 (0, 0, 0, 1)인데 어떤 값이 나옵니까?",
                ),
                misconception="M5",
            ),
            Twin(
                "to the right",
                lambda yaw: (0.0, 0.0, -math.sin(yaw / 2), math.cos(yaw / 2)),
                Words(
                    en="Your robot turns right where left was asked. Positive yaw goes from x towards y.",
                    ko="왼쪽으로 돌아야 하는데 오른쪽으로 돕니다. 양의 yaw는 x에서 y 쪽으로 돕니다.",
                ),
            ),
            Twin(
                "about x",
                lambda yaw: (math.sin(yaw / 2), 0.0, 0.0, math.cos(yaw / 2)),
                Words(
                    en="This is a roll: the sine stands in x. Which axis does a yaw turn about?",
                    ko="이것은 roll입니다. sin이 x 자리에 있습니다. yaw는 어느 축을 중심으로 돕니까?",
                ),
            ),
            Twin(
                "about y",
                lambda yaw: (0.0, math.sin(yaw / 2), 0.0, math.cos(yaw / 2)),
                Words(
                    en="This is a pitch: the sine stands in y, and your robot nods. Which axis does a yaw turn about?",
                    ko="이것은 pitch입니다. sin이 y 자리에 있어서 로봇이 고개를 끄덕입니다. yaw는 어느 축을 중심으로 돕니까?",
                ),
            ),
            Twin(
                "angle in z",
                lambda yaw: (0.0, 0.0, yaw, 1.0),
                Words(
                    en="You wrote the angle itself into z. A quaternion holds no angle: z takes the sine of half of it, w the cosine.",
                    ko="z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 cos을 넣으십시오.",
                ),
                misconception="M5",
            ),
            Twin(
                "halved outside",
                lambda yaw: (0.0, 0.0, math.sin(yaw) / 2, math.cos(yaw) / 2),
                Words(
                    en="You halved the sine, not the angle. The half belongs inside the brackets; look at the length of what you return.",
                    ko="각도가 아니라 sin을 절반으로 나누었습니다. 절반은 괄호 안에서 나누어야 합니다. 반환한 값의 길이를 보십시오.",
                ),
                misconception="M5",
            ),
        ),
        hints=(
            Words(
                en="Axis times the sine of ..., then the cosine of ...: what is the axis of a yaw?",
                ko="축에 sin을 곱하고, 마지막에 cos을 씁니다. yaw의 축은 무엇입니까?",
            ),
            Words(
                en="The axis is (0, 0, 1), so two of the four numbers are zero. And it is half the angle.",
                ko="축은 (0, 0, 1)이므로 넷 중 둘은 0입니다. 그리고 각도의 절반을 씁니다.",
            ),
            Words(
                en="x and y are 0.0; z is math.sin(yaw_rad / 2); one number is left for you.",
                ko="x와 y는 0.0이고 z는 math.sin(yaw_rad / 2)입니다. 남은 하나는 직접 채우십시오.",
            ),
        ),
        cures=("M5",),
    ),
    Task(
        id="E2.4",
        kind="F",
        points=4,
        title=Words(en="A customs officer for quaternions", ko="쿼터니언 검문소"),
        answer="judge_quaternion",
        form=Choice(VERDICTS),
        inputs=quaternions,
        variants=3,
        twins=(
            Twin(
                "nan slips through",
                lambda q: judged(q, nan=False),
                Words(
                    en="NaN slips through: every comparison with it is False, so no 'if' catches it. Ask for it first, with math.isfinite.",
                    ko="NaN이 빠져나갔습니다. NaN과의 비교는 모두 False여서 어떤 if에도 걸리지 않습니다. math.isfinite로 맨 먼저 확인하십시오.",
                ),
                misconception="M5",
            ),
            Twin(
                "infinity slips through",
                lambda q: judged(q, nan=any(math.isnan(part) for part in q)),
                Words(
                    en="You catch NaN, but not infinity, which is no number to compute with either. math.isfinite asks for both at once.",
                    ko="NaN은 잡았지만 무한대가 빠져나갔습니다. 무한대로도 계산할 수 없습니다. math.isfinite는 둘을 한꺼번에 확인합니다.",
                ),
                misconception="M5",
            ),
            Twin(
                "w first before length",
                w_first_before_length,
                Words(
                    en="A quaternion can have two faults at once, and the task says which to name: you ask about x and y before you ask about the length.",
                    ko="한 쿼터니언에 결함이 둘일 수도 있고, 무엇을 먼저 말할지는 문제에 적혀 있습니다. 길이를 보기 전에 x와 y부터 보았습니다.",
                ),
            ),
            Twin(
                "zero by sum",
                zero_by_sum,
                Words(
                    en="You add the four numbers, and a quarter turn to the right adds up to zero. The length is the root of the sum of squares: math.hypot.",
                    ko="네 수를 그냥 더했습니다. 오른쪽으로 4분의 1바퀴 도는 회전은 더하면 0이 됩니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
                ),
                misconception="M5",
            ),
            Twin(
                "square for length",
                judged_by_square,
                Words(
                    en="That is the square of the length, and it strays from 1 twice as fast as the length does. Take the root: math.sqrt, or math.hypot at once.",
                    ko="그것은 길이의 제곱이어서 길이보다 두 배 빨리 1에서 벗어납니다. math.sqrt로 제곱근을 구하거나 처음부터 math.hypot을 쓰십시오.",
                ),
            ),
            Twin(
                "negative x or y passes",
                judged_without_sign,
                Words(
                    en="You look only for a large positive x or y. q and -q are the same rotation, so a w that came first may also be -0.9: compare abs().",
                    ko="x나 y가 양수로 큰 경우만 보았습니다. q와 -q는 같은 회전이므로 맨 앞에 온 w가 -0.9일 수도 있습니다. abs()로 비교하십시오.",
                ),
                misconception="M5",
            ),
            Twin(
                "only x",
                judged_by_x,
                Words(
                    en="You look at x alone. The task says x or y: a large y would tip the robot over just the same.",
                    ko="x만 보았습니다. 문제에는 x나 y라고 적혀 있습니다. y가 커도 로봇은 똑같이 넘어집니다.",
                ),
            ),
            Twin(
                "too short passes",
                short_passes,
                Words(
                    en="You refuse a length above 1, but not one below. It differs to both sides: compare abs(length - 1).",
                    ko="길이가 1보다 큰 것만 걸러 냈고 1보다 작은 것은 통과시켰습니다. 양쪽으로 모두 벗어날 수 있으니 abs(length - 1)을 비교하십시오.",
                ),
            ),
            Twin(
                "zero if w is zero",
                lambda q: judged(q, zero_by_w=True),
                Words(
                    en="You call (0, 0, 1, 0) zero. It is half a turn: w is 0, the length is 1. Look at all four numbers.",
                    ko="(0, 0, 1, 0)을 zero라고 했습니다. 이것은 반 바퀴 회전입니다. w는 0이지만 길이는 1입니다. 네 숫자를 모두 보십시오.",
                ),
                misconception="M5",
            ),
            Twin(
                "exactly one",
                lambda q: judged(q, tolerance=0.0),
                Words(
                    en="A quaternion that was rounded to three decimals is still a good one. Compare its length with a tolerance.",
                    ko="소수 셋째 자리까지 반올림한 쿼터니언도 올바른 쿼터니언입니다. 길이는 허용 오차를 두고 비교하십시오.",
                ),
            ),
            Twin(
                "too strict",
                lambda q: judged(q, tolerance=1e-6),
                Words(
                    en="Your tolerance is finer than the task's: a quaternion that was cut to three decimals has a length of 0.999, and is still a good one.",
                    ko="허용 오차가 문제에서 정한 것보다 엄격합니다. 소수 셋째 자리까지만 적은 쿼터니언은 길이가 0.999쯤 되지만 여전히 올바릅니다.",
                ),
            ),
            Twin(
                "sum for length",
                lambda q: judged(q, norm=1),
                Words(
                    en="That is the sum of the four numbers, not their length. The length is the root of the sum of squares: math.hypot.",
                    ko="그것은 네 수의 합이지 길이가 아닙니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
                ),
            ),
            Twin(
                "minus q refused",
                lambda q: judged(q, last_sign=True),
                Words(
                    en="You refuse a quaternion because its w is negative. q and -q are the same rotation; both are good.",
                    ko="w가 음수라는 이유로 거절했습니다. q와 -q는 같은 회전이며 둘 다 올바릅니다.",
                ),
                misconception="M5",
            ),
            Twin(
                "zero is only not unit",
                lambda q: judged(q, zero=False),
                Words(
                    en="All zeros is worse than not unit: the others can be scaled to length one, this one cannot. Give it its own verdict, before the length.",
                    ko="모두 0인 것은 not unit보다 나쁩니다. 다른 것은 길이를 1로 맞출 수 있지만 이것은 그럴 수 없습니다. 길이를 보기 전에 따로 판정하십시오.",
                ),
                misconception="M5",
            ),
        ),
        hints=(
            Words(
                en="Five verdicts, so four questions, in this order: finite? any length at all? length one? only about z?",
                ko="판정이 다섯이니 질문은 넷입니다. 차례로 묻습니다. 유한합니까? 길이가 있기는 합니까? 길이가 1입니까? z축으로만 돕니까?",
            ),
            Words(
                en="math.isfinite for each number, math.hypot(*q) for the length, a tolerance of 0.01 for one.",
                ko="각 숫자에는 math.isfinite, 길이에는 math.hypot(*q), 1과의 비교에는 허용 오차 0.01을 쓰십시오.",
            ),
            Words(
                en="A yaw has x = y = 0. Written w first, its w lands in x: so ask whether abs(x) or abs(y) exceeds 0.1. The sign of w says nothing.",
                ko="yaw만 있으면 x = y = 0입니다. w를 먼저 쓰면 w가 x 자리에 옵니다. 그러니 abs(x)나 abs(y)가 0.1을 넘는지 보십시오. w의 부호는 아무것도 말해 주지 않습니다.",
            ),
        ),
        cures=("M5",),
    ),
    Task(
        id="E2.5",
        kind="N",
        points=3,
        title=Words(en="First the yaw, then the pitch", ko="먼저 yaw, 다음에 pitch"),
        answer="robot_q_sensor",
        form=Quaternion(tolerance=2e-3),
        given=two_turns,
        variants=5,
        twins=(
            Twin(
                "other order",
                lambda given: Transform.from_rpy(pitch=given.then_pitch_rad, yaw=given.first_yaw_rad).rotation,
                Words(
                    en="That is first the pitch, then the yaw: the order that rpy always has. Here the yaw comes first, and both axes stand still.",
                    ko="먼저 pitch, 다음에 yaw를 한 결과입니다. rpy는 언제나 그 순서입니다. 여기서는 yaw가 먼저이고 두 축 모두 고정되어 있습니다.",
                ),
            ),
            Twin(
                "inverse",
                lambda given: turned(given).inverse().rotation,
                Words(
                    en="This undoes the two turns instead of making them. Did a sign get lost, or an inverse get in?",
                    ko="두 회전을 하는 것이 아니라 되돌렸습니다. 부호를 잃었거나 inverse가 끼어들지 않았습니까?",
                ),
                misconception="M3",
            ),
            Twin(
                "degrees",
                lambda given: turned(given, math.radians(1.0)).rotation,
                Words(
                    en="You turned by hundredths of what was asked: the angles are radians already.",
                    ko="거의 돌지 않았습니다. 각도는 이미 라디안입니다.",
                ),
                misconception="M5",
            ),
            Twin(
                "w first",
                lambda given: wxyz_from_xyzw(turned(given).rotation),
                Words(
                    en="The rotation is right, the order of its numbers is not: w comes last.",
                    ko="회전은 맞지만 숫자의 순서가 다릅니다. w는 마지막에 옵니다.",
                ),
                misconception="M5",
            ),
        ),
        hints=(
            Words(
                en="Two turns, two transforms, one product. Which factor stands next to the point?",
                ko="회전 둘, 변환 둘, 곱 하나입니다. 점과 가까운 쪽에 어느 것이 옵니까?",
            ),
            Words(
                en="What happens first stands on the right. from_rpy with both angles at once has the other order built in.",
                ko="먼저 일어나는 것이 오른쪽에 옵니다. from_rpy에 두 각도를 한꺼번에 넣으면 순서가 반대로 정해져 있습니다.",
            ),
            Words(
                en="Make yaw = Transform.from_rpy(yaw=...) and pitch = Transform.from_rpy(pitch=...), multiply with @, and take .rotation.",
                ko="yaw = Transform.from_rpy(yaw=...)와 pitch = Transform.from_rpy(pitch=...)를 만들어 @로 곱하고 .rotation을 꺼내십시오.",
            ),
        ),
        cures=("M5",),
    ),
    Task(
        id="E2.6",
        kind="D",
        points=3,
        title=Words(en="A cloud at ninety degrees", ko="90° 돌아간 클라우드"),
        answer="diagnosis",
        form=DIAGNOSIS,
        given=turned_cloud,
        variants=6,
        twins=(
            Twin(
                "turn the data",
                lambda given: {"wall_appears": wall_appears(given), "fault": "data", "change": "my node"},
                Words(
                    en="Turning the numbers in your node makes your node right and everybody else's wrong, and it breaks on the day the cause is mended. The numbers are what the camera measured; one of the three labels or mounts is not what it should be.",
                    ko="내 노드에서 숫자를 돌리면 내 노드만 맞고 다른 모두는 틀립니다. 게다가 원인이 고쳐지는 날 망가집니다. 숫자는 카메라가 잰 그대로입니다. 이름표와 두 장착 변환 가운데 하나가 잘못되어 있습니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "wrong end",
                at_the_wrong_end,
                Words(
                    en="You blame a line that is as it should be. Take the three lines of evidence one by one: a depth cloud's header names the optical frame; camera_link looks ahead, 0 0 0; the optical frame is turned -90 0 -90 in it. Which one differs?",
                    ko="멀쩡한 것을 의심하고 있습니다. 증거 세 줄을 하나씩 보십시오. 깊이 클라우드의 헤더에는 광학 좌표계가 적힙니다. camera_link는 앞을 보므로 0 0 0입니다. 광학 좌표계는 그 안에서 -90 0 -90만큼 돌아가 있습니다. 어느 것이 다릅니까?",
                ),
                misconception="M4",
            ),
            Twin(
                "other mount",
                the_other_mount,
                Words(
                    en="There are two mounts, and you blame the wrong one. The turn by -90 0 -90 belongs exactly once between base_link and the data: between camera_link and camera_optical_frame.",
                    ko="장착 변환은 둘인데 엉뚱한 쪽을 의심하고 있습니다. -90 0 -90 회전은 base_link와 데이터 사이에 딱 한 번, camera_link와 camera_optical_frame 사이에 있어야 합니다.",
                ),
                misconception="M4",
            ),
            Twin(
                "wall elsewhere",
                lambda given: {**named(given), "wall_appears": "above" if wall_appears(given) == "right" else "right"},
                Words(
                    en="The fault is right, the place is not. Put three fingers on the numbers (right, down, forward) and read them as the fault makes them be read: which one becomes x, which one becomes z?",
                    ko="결함은 맞지만 벽의 위치가 틀립니다. (오른쪽, 아래, 앞) 세 숫자를 손가락으로 짚고, 이 결함에서 각각 무엇으로 읽히는지 따라가 보십시오. 어느 것이 x가 되고 어느 것이 z가 됩니까?",
                ),
                misconception="M4",
            ),
            Twin(
                "mended elsewhere",
                mended_elsewhere,
                Words(
                    en="You have found the fault, but you would mend it in the wrong file. Who writes a header: the program that sends the data, or the robot's description? And who says where a camera is bolted on?",
                    ko="결함은 찾았지만 엉뚱한 곳을 고치려 합니다. 헤더는 데이터를 보내는 프로그램이 씁니까, 로봇 모델이 씁니까? 카메라가 어디에 달려 있는지는 어디에 적습니까?",
                ),
                misconception="M4",
            ),
            Twin(
                "quaternion",
                lambda given: {"wall_appears": wall_appears(given), "fault": "quaternion", "change": "URDF"},
                Words(
                    en="A quaternion of zeros would not turn the cloud: the transform would be refused and nothing drawn. One with w first would show in the angles. Look at the three lines of evidence.",
                    ko="모두 0인 쿼터니언이라면 변환이 거절되어 아무것도 그려지지 않습니다. w를 먼저 썼다면 각도에 드러납니다. 증거 세 줄을 보십시오.",
                ),
                misconception="M5",
            ),
        ),
        hints=(
            Words(
                en="Write down the chain from the data to base_link: header, then the optical mount, then the camera's mount. How often does the turn by -90 0 -90 occur? It should be once.",
                ko="데이터에서 base_link까지의 길을 적으십시오. 헤더, 광학 좌표계 장착, 카메라 장착 순서입니다. -90 0 -90 회전이 몇 번 나옵니까? 한 번이어야 합니다.",
            ),
            Words(
                en="Never: the wall's depth (z) is read as height. Twice: what is ahead ends at the side. Which is it here, and which line makes it so?",
                ko="한 번도 없으면 벽까지의 깊이(z)가 높이로 읽힙니다. 두 번이면 앞에 있는 것이 옆으로 갑니다. 여기서는 어느 쪽이며, 어느 줄 때문입니까?",
            ),
            Words(
                en="A header is set in the driver, a mount in the URDF. The data stays as it is, always.",
                ko="헤더는 드라이버에서, 장착 변환은 URDF에서 고칩니다. 데이터는 언제나 그대로 둡니다.",
            ),
        ),
        cures=("M4",),
    ),
    Task(
        id="E2.7",
        kind="N",
        points=2,
        title=Words(en="A few digits too few", ko="모자란 숫자 몇 자리"),
        answer="off_mm",
        form=Number(unit="mm", tolerance=0.5),
        given=few_digits,
        variants=5,
        twins=(
            Twin(
                "degrees",
                lambda given: 1000.0 * given.range_m * math.degrees(missing_rad(given)),
                Words(
                    en="You multiplied by degrees. An arc is radius times angle only if the angle is in radians.",
                    ko="도(degree)를 곱했습니다. 호의 길이가 반지름 곱하기 각도인 것은 각도가 라디안일 때뿐입니다.",
                ),
            ),
            Twin(
                "relative",
                lambda given: 1000.0 * given.range_m * missing_rad(given) / (math.pi / 2),
                Words(
                    en="That is the error as a part of pi/2, times the range. The missing angle itself is what swings the ray.",
                    ko="오차를 π/2로 나눈 비율에 거리를 곱했습니다. 광선을 옆으로 미는 것은 비율이 아니라 모자란 각도 자체입니다.",
                ),
            ),
            Twin(
                "half",
                lambda given: 500.0 * given.range_m * missing_rad(given),
                Words(
                    en="You halved the angle. Halves belong into quaternions; the ray swings by the whole missing angle.",
                    ko="각도를 절반으로 나누었습니다. 절반은 쿼터니언에 쓰는 것이고, 광선은 모자란 각도만큼 그대로 돌아갑니다.",
                ),
            ),
            Twin(
                "negative",
                lambda given: -1000.0 * given.range_m * missing_rad(given),
                Words(
                    en="The size is right. How far off is asked without a sign: take abs().",
                    ko="크기는 맞습니다. 얼마나 어긋나는지는 부호 없이 답합니다. abs()를 쓰십시오.",
                ),
            ),
            Twin(
                "rounded pi",
                lambda given: 1000.0 * given.range_m * abs(3.14 / 2 - given.written_yaw_rad),
                Words(
                    en="You compared with 3.14 / 2, which is as short of digits as the URDF. Use math.pi.",
                    ko="3.14 / 2와 비교했습니다. 그 값도 URDF만큼이나 자릿수가 모자랍니다. math.pi를 쓰십시오.",
                ),
            ),
        ),
        hints=(
            Words(
                en="How large is the missing angle? And what does a small angle do to a point far away?",
                ko="모자란 각도는 얼마입니까? 작은 각도는 멀리 있는 점에 어떤 영향을 줍니까?",
            ),
            Words(
                en="The point swings along an arc: radius times angle, the angle in radians.",
                ko="점은 호를 따라 움직입니다. 반지름 곱하기 각도이고, 각도는 라디안입니다.",
            ),
            Words(
                en="abs(math.pi / 2 - written) is the angle. Metres become millimetres at the very end.",
                ko="각도는 abs(math.pi / 2 - written)입니다. 미터를 밀리미터로 바꾸는 일은 맨 마지막에 합니다.",
            ),
        ),
        cures=("M5",),
    ),
)
