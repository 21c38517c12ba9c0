"""E6.1: Board or radio?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Sequence, Task, Text, WrongAnswer, WrongStep

BOARD, RADIO = "/tf_static", "/tf"
RIGHT = {
    "cart": [RADIO, BOARD, RADIO],
    "scout": [BOARD, RADIO, BOARD],
    "arm": [RADIO, BOARD, BOARD],
    "drone": [RADIO, RADIO, BOARD],
}


def sorted_out(_given, *, wheels=RADIO, laser=BOARD, corrections=RADIO, imu=BOARD, mast=RADIO, optical=BOARD,
               shoulder=RADIO, flange=BOARD, tcp=BOARD, flight=RADIO, gimbal=RADIO, camera=BOARD):  # fmt: skip
    """Return each robot's topics, edge by edge; another topic is a slip."""
    return {
        "cart": [wheels, laser, corrections],
        "scout": [imu, mast, optical],
        "arm": [shoulder, flange, tcp],
        "drone": [flight, gimbal, camera],
    }


PARKED = WrongStep(
    "parked",
    {"wheels": BOARD},
    Text(
        en="it is parked, and it has wheels. On a board it would have one place for all times, also for those when it was elsewhere.",
        ko="지금은 주차해 있지만 바퀴가 있습니다. 게시판에 붙이면 다른 곳에 있던 시각까지 포함해 위치가 하나뿐입니다.",
    ),
    "M12",
    part="cart",
)

LASER_DRIVES_ALONG = WrongStep(
    "laser drives along",
    {"laser": RADIO},
    Text(
        en="the laser drives through the room together with the robot, and not against it. A screw needs one letter.",
        ko="레이저는 로봇과 함께 움직일 뿐, 로봇을 기준으로는 움직이지 않습니다. 나사로 고정한 것은 메시지 하나면 됩니다.",
    ),
    "M12",
    part="cart",
)

CORRECTED_SELDOM = WrongStep(
    "corrected seldom",
    {"corrections": BOARD},
    Text(
        en="seldom is not never. Between two corrections `map → odom` still has to be told, or the chain ends there.",
        ko="드물게 바뀌는 것도 바뀌는 것입니다. 보정과 보정 사이에도 `map → odom`을 계속 알려야 하며, 그러지 않으면 사슬이 거기서 끝납니다.",
    ),
    "M12",
    part="cart",
)

IMU_MEASURES_MOTION = WrongStep(
    "imu measures motion",
    {"imu": RADIO},
    Text(
        en="an IMU measures motion, and its box is screwed on: where it sits does not change.",
        ko="IMU가 재는 것은 움직임이지만 상자는 나사로 고정되어 있습니다. 달린 위치는 변하지 않습니다.",
    ),
    "M12",
    part="scout",
)

MAST_AT_REST = WrongStep(
    "mast at rest",
    {"mast": BOARD},
    Text(
        en="the mast moves while the robot is parked. A board has no past: scans of before the move would be placed with the mount of after it.",
        ko="마스트는 주차 중에 움직입니다. 게시판에는 과거가 없어서, 움직이기 전의 스캔이 움직인 뒤의 위치로 놓입니다.",
    ),
    "M12",
    part="scout",
)

OPTICAL = WrongStep(
    "optical",
    {"optical": RADIO},
    Text(
        en="an optical frame is the camera's own, with its axes turned. That turn is a definition and never changes.",
        ko="광학 좌표계는 같은 카메라의 축을 돌려 적은 것입니다. 그 회전은 정의이므로 변하지 않습니다.",
    ),
    "M12",
    part="scout",
)

HELD_JOINT = WrongStep(
    "held joint",
    {"shoulder": BOARD},
    Text(
        en="a joint that is held is still a joint. Somebody will let go of it.",
        ko="붙잡고 있는 관절도 관절입니다. 언젠가는 움직입니다.",
    ),
    "M12",
    part="arm",
)

FLANGE_MOVES_ALONG = WrongStep(
    "flange moves along",
    {"flange": RADIO},
    Text(
        en="the flange moves with the wrist, and not against it: it is the wrist's own end.",
        ko="플랜지는 손목과 함께 움직일 뿐, 손목을 기준으로는 움직이지 않습니다. 손목 자체의 끝입니다.",
    ),
    "M12",
    part="arm",
)

TAPED = WrongStep(
    "taped",
    {"tcp": RADIO},
    Text(
        en="tape is not pretty, and it does not move against the flange.",
        ko="테이프가 보기 좋지는 않아도, 플랜지를 기준으로 움직이지는 않습니다.",
    ),
    "M12",
    part="arm",
)

FLIES_ON_A_BOARD = WrongStep(
    "flies on a board",
    {"flight": BOARD},
    Text(
        en="a drone that flies changes its place in odom all the time.",
        ko="나는 드론은 odom 기준 위치가 쉬지 않고 변합니다.",
    ),
    "M12",
    part="drone",
)

STEADY_PICTURE = WrongStep(
    "steady picture",
    {"gimbal": BOARD},
    Text(
        en="the picture stands still because the gimbal moves against the body.",
        ko="영상이 흔들리지 않는 것은 짐벌이 본체와 반대로 움직이기 때문입니다.",
    ),
    "M12",
    part="drone",
)

CAMERA_TURNS_ALONG = WrongStep(
    "camera turns along",
    {"camera": RADIO},
    Text(
        en="the camera turns together with the gimbal. Ask whether it moves against its *parent*.",
        ko="카메라는 짐벌과 함께 돕니다. *부모를 기준으로* 움직이는지 따져 보세요.",
    ),
    "M12",
    part="drone",
)

ALL_ON_THE_RADIO = WrongAnswer(
    "all on the radio",
    {robot: [RADIO] * 3 for robot in RIGHT},
    Text(
        en="All on /tf, to be safe: then each bolt holds its whole chain back to the moment at which the bolt was last told.",
        ko="안전하게 모두 /tf로 보냈습니다. 그러면 볼트 하나하나가 사슬 전체를 볼트를 마지막으로 알린 시각에 묶어 둡니다.",
    ),
    "M12",
)

ALL_ON_THE_BOARD = WrongAnswer(
    "all on the board",
    {robot: [BOARD] * 3 for robot in RIGHT},
    Text(
        en="All on /tf_static: then nothing has a past, and what moves is frozen or lies about earlier moments.",
        ko="모두 /tf_static으로 보냈습니다. 그러면 과거가 없어서, 움직이는 것은 얼어붙거나 이전 시각에 대해 틀린 값을 줍니다.",
    ),
    "M12",
)

OTHER_WAY_ROUND = WrongAnswer(
    "other way round",
    {robot: [BOARD if topic == RADIO else RADIO for topic in topics] for robot, topics in RIGHT.items()},
    Text(
        en="The other way round: the board is for what is bolted on, the radio for what moves.",
        ko="반대입니다. 게시판은 고정된 것, 라디오는 움직이는 것에 씁니다.",
    ),
    "M12",
)


TASK = Task(
    id="E6.1",
    kind="M",
    points=4,
    title=Text(en="Board or radio?", ko="게시판일까요, 라디오일까요?"),
    answer="topics",
    form=Parts({robot: Sequence(Choice((BOARD, RADIO))) for robot in RIGHT}),
    model=sorted_out,
    mistakes=(
        PARKED,
        LASER_DRIVES_ALONG,
        CORRECTED_SELDOM,
        IMU_MEASURES_MOTION,
        MAST_AT_REST,
        OPTICAL,
        HELD_JOINT,
        FLANGE_MOVES_ALONG,
        TAPED,
        FLIES_ON_A_BOARD,
        STEADY_PICTURE,
        CAMERA_TURNS_ALONG,
        ALL_ON_THE_RADIO,
        ALL_ON_THE_BOARD,
        OTHER_WAY_ROUND,
    ),
    hints=(
        Text(
            en="Ask of each edge: can the child ever move against its parent?",
            ko="연결마다 물어보세요. 자식이 부모를 기준으로 한 번이라도 움직일 수 있습니까?",
        ),
        Text(
            en='"Not now" and "seldom" are not "never". And riding along with the parent is not moving against it.',
            ko='"지금은 아니다", "드물다"는 "절대 아니다"와 다릅니다. 부모와 함께 움직이는 것은 부모를 기준으로 움직이는 것이 아닙니다.',
        ),
        Text(
            en="Screwed, taped, or fixed by definition: /tf_static. Wheels, joints, masts, gimbals, corrections: /tf.",
            ko="나사, 테이프, 정의로 정해진 것은 /tf_static입니다. 바퀴, 관절, 마스트, 짐벌, 보정은 /tf입니다.",
        ),
    ),
    misconceptions=("M12",),
)
