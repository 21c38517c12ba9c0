"""E2.1: Say the sign."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

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


AEROPLANE = WrongAnswer(
    "aeroplane",
    signs("pitch_nose_down"),
    Text(
        en="That is an aeroplane's pitch, whose z points down. Here z points up: lay the thumb of your right hand along y, to the left, and see where the fingers take the nose.",
        ko="그것은 z가 아래를 향하는 비행기의 pitch입니다. 여기서는 z가 위를 향합니다. 오른손 엄지를 y, 곧 왼쪽으로 뻗고 나머지 손가락이 기수를 어디로 보내는지 보십시오.",
    ),
)


COMPASS = WrongAnswer(
    "compass",
    signs("angular_z_turning_left"),
    Text(
        en="A compass counts clockwise; REP-103 does not. Thumb up along z: which way do the fingers curl?",
        ko="나침반은 시계 방향으로 세지만 REP-103은 그렇지 않습니다. 엄지를 z 방향으로 세우면 나머지 손가락은 어느 쪽으로 감깁니까?",
    ),
)


RIGHT_IS_PLUS = WrongAnswer(
    "right is plus",
    signs("y_right_in_base_link"),
    Text(
        en="On paper, right is plus. On a robot's body, look where y points: hold up the pistol hand.",
        ko="종이 위에서는 오른쪽이 양수입니다. 로봇 본체에서는 y가 어디를 가리킵니까? 오른손을 권총 모양으로 들어 보십시오.",
    ),
)


OPTICAL_AS_BODY = WrongAnswer(
    "optical as body",
    signs(OPTICAL_RIGHT, OPTICAL_UP),
    Text(
        en="So it would be with the body's axes. In the optical frame one counts as in a picture: x to the right, y down.",
        ko="본체의 축이라면 그렇습니다. 광학 좌표계는 영상처럼 셉니다. x는 오른쪽, y는 아래입니다.",
    ),
    misconception="M4",
    partly=True,
)


Y_UP_IN_THE_PICTURE = WrongAnswer(
    "y up in the picture",
    signs(OPTICAL_UP),
    Text(
        en="In school, y goes up. In a picture, row 0 is at the top: which way do the rows count?",
        ko="학교에서 배운 y는 위로 갑니다. 영상에서는 0번 행이 맨 위입니다. 행 번호는 어느 쪽으로 커집니까?",
    ),
    misconception="M4",
)


LEFT_HAND = WrongAnswer(
    "left hand",
    signs("angular_z_turning_left", BODY_RIGHT),
    Text(
        en="Both are so where y points right and z up: those are the axes of a left hand, and turns count by it, too. ROS takes the right hand: thumb up along z, fingers from x forward to y, left.",
        ko="y가 오른쪽, z가 위를 가리킨다면 둘 다 그렇습니다. 그것은 왼손의 축이고 회전도 왼손으로 셉니다. ROS는 오른손을 씁니다. 엄지를 z 방향으로 세우면 나머지 손가락은 앞쪽 x에서 왼쪽 y로 감깁니다.",
    ),
)


AEROPLANE_AXES = WrongAnswer(
    "an aeroplane's axes",
    signs("angular_z_turning_left", "pitch_nose_down", BODY_RIGHT),
    Text(
        en="All three are so with the axes of an aeroplane or a ship: x forward, y right, z down. In ROS y points left and z up.",
        ko="셋 다 비행기나 배의 축이라면 그렇습니다. x 앞, y 오른쪽, z 아래입니다. ROS에서는 y가 왼쪽, z가 위를 가리킵니다.",
    ),
)


TURNED_BY_THE_LEFT_HAND = WrongAnswer(
    "turned by the left hand",
    signs("angular_z_turning_left", "pitch_nose_down"),
    Text(
        en="Both turns go the other way, as the fingers of the left hand curl. Take the right one: thumb along z for the yaw, along y, to the left, for the pitch.",
        ko="두 회전 모두 왼손의 손가락이 감기는 쪽, 곧 반대쪽으로 셌습니다. 오른손을 쓰십시오. yaw라면 엄지를 z 방향으로, pitch라면 왼쪽인 y 방향으로 뻗으십시오.",
    ),
)


MIRRORED = WrongAnswer(
    "mirrored",
    signs(OPTICAL_RIGHT),
    Text(
        en="So it would be with the body's y, which points left, or in a mirror, seen from in front. The picture is what the camera itself sees: its x counts to the right.",
        ko="왼쪽을 가리키는 본체의 y이거나, 앞에서 마주 본 거울 속이라면 그렇습니다. 영상은 카메라가 직접 본 것이고 x는 오른쪽으로 셉니다.",
    ),
    misconception="M4",
)


BY_THE_WORD = WrongAnswer(
    "by the word",
    signs("pitch_nose_down", OPTICAL_UP),
    Text(
        en="Both go by the word, down for minus and above for plus. No word has a sign: it is the axis that says it. A pitch turns about y, from z to x; and in a picture y points down.",
        ko="둘 다 낱말대로 아래를 음수, 위를 양수로 보았습니다. 부호는 낱말이 아니라 축이 정합니다. pitch는 y축 둘레로 z에서 x 쪽으로 돌고, 영상에서는 y가 아래를 가리킵니다.",
    ),
)


TASK = Task(
    id="E2.1",
    kind="M",
    points=3,
    title=Text(en="Say the sign", ko="부호를 말하십시오"),
    answer="signs",
    form=Parts(dict.fromkeys(SIGNS, SIGN)),
    mistakes=(
        AEROPLANE,
        COMPASS,
        RIGHT_IS_PLUS,
        OPTICAL_AS_BODY,
        Y_UP_IN_THE_PICTURE,
        LEFT_HAND,
        AEROPLANE_AXES,
        TURNED_BY_THE_LEFT_HAND,
        MIRRORED,
        BY_THE_WORD,
    ),
    hints=(
        Text(en="Do not calculate. Use your right hand.", ko="계산하지 마십시오. 오른손을 쓰십시오."),
        Text(
            en="For a turn: thumb along the axis, fingers curl the positive way. For a place: is it where the axis points, or on the other side?",
            ko="회전이라면 엄지를 축 방향으로 뻗으십시오. 나머지 손가락이 감기는 쪽이 양수입니다. 위치라면 축이 가리키는 쪽에 있는지 반대쪽에 있는지 보십시오.",
        ),
        Text(
            en="Body: x forward, y left, z up. Picture: x right, y down, z forward. Pitch turns z towards x.",
            ko="본체는 x 앞, y 왼쪽, z 위입니다. 영상은 x 오른쪽, y 아래, z 앞입니다. pitch는 z를 x 쪽으로 돌립니다.",
        ),
    ),
    misconceptions=("M4",),
)
