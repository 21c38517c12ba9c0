"""E6.1: Board or radio?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Sequence, Task, Twin, Words

BOARD, RADIO = "/tf_static", "/tf"
RIGHT = {
    "cart": [RADIO, BOARD, RADIO],
    "scout": [BOARD, RADIO, BOARD],
    "arm": [RADIO, BOARD, BOARD],
    "drone": [RADIO, RADIO, BOARD],
}


def but(**robots):
    return {**RIGHT, **robots}


NOT_MOVING_NOW = Twin(
    "not moving now",
    but(cart=[BOARD, BOARD, RADIO], scout=[BOARD, BOARD, BOARD], arm=[BOARD, BOARD, BOARD]),
    Words(
        en="You went by what moves now. A parked robot, a mast at rest, a joint that is held: each can move, so its value belongs to a moment.",
        ko="지금 움직이는지를 기준으로 골랐습니다. 주차한 로봇, 멈춘 마스트, 붙잡고 있는 관절도 움직일 수 있으므로 값마다 시각이 필요합니다.",
    ),
    "M12",
    partly=True,
)

PARKED = Twin(
    "parked",
    but(cart=[BOARD, BOARD, RADIO]),
    Words(
        en="cart: it is parked, and it has wheels. On a board it would have one place for all times, also for those when it was elsewhere.",
        ko="cart: 지금은 주차해 있지만 바퀴가 있습니다. 게시판에 붙이면 다른 곳에 있던 시각까지 포함해 위치가 하나뿐입니다.",
    ),
    "M12",
)

MAST_AT_REST = Twin(
    "mast at rest",
    but(scout=[BOARD, BOARD, BOARD]),
    Words(
        en="scout: its mast moves while the robot is parked. A board has no past: scans of before the move would be placed with the mount of after it.",
        ko="scout: 마스트는 주차 중에 움직입니다. 게시판에는 과거가 없어서, 움직이기 전의 스캔이 움직인 뒤의 위치로 놓입니다.",
    ),
    "M12",
)

HELD_JOINT = Twin(
    "held joint",
    but(arm=[BOARD, BOARD, BOARD]),
    Words(
        en="arm: a joint that is held is still a joint. Somebody will let go of it.",
        ko="arm: 붙잡고 있는 관절도 관절입니다. 언젠가는 움직입니다.",
    ),
    "M12",
)

STEADY_PICTURE = Twin(
    "steady picture",
    but(drone=[RADIO, BOARD, BOARD]),
    Words(
        en="drone: the picture stands still because the gimbal moves against the body.",
        ko="drone: 영상이 흔들리지 않는 것은 짐벌이 본체와 반대로 움직이기 때문입니다.",
    ),
    "M12",
)

EVERY_CAMERA_MOVES = Twin(
    "what is on a mover moves",
    but(drone=[RADIO, RADIO, RADIO], arm=[RADIO, RADIO, RADIO], scout=[BOARD, RADIO, RADIO]),
    Words(
        en="You asked whether the part moves through the room. Ask whether it moves against its *parent*: what is screwed, taped or drawn there does not.",
        ko="부품이 방 안에서 움직이는지를 따졌습니다. *부모를 기준으로* 움직이는지를 따져 보세요. 나사나 테이프로 고정했거나 정의로 정해진 것은 움직이지 않습니다.",
    ),
    "M12",
    partly=True,
)

TAPED = Twin(
    "taped",
    but(arm=[RADIO, BOARD, RADIO]),
    Words(
        en="arm: tape is not pretty, and it does not move against the flange.",
        ko="arm: 테이프가 보기 좋지는 않아도, 플랜지를 기준으로 움직이지는 않습니다.",
    ),
    "M12",
)

OPTICAL = Twin(
    "optical",
    but(scout=[BOARD, RADIO, RADIO]),
    Words(
        en="scout: an optical frame is the camera's own, with its axes turned. That turn is a definition and never changes.",
        ko="scout: 광학 좌표계는 같은 카메라의 축을 돌려 적은 것입니다. 그 회전은 정의이므로 변하지 않습니다.",
    ),
    "M12",
)

CORRECTED_SELDOM = Twin(
    "corrected seldom",
    but(cart=[RADIO, BOARD, BOARD]),
    Words(
        en="cart: seldom is not never. Between two corrections `map → odom` still has to be told, or the chain ends there.",
        ko="cart: 드물게 바뀌는 것도 바뀌는 것입니다. 보정과 보정 사이에도 `map → odom`을 계속 알려야 하며, 그러지 않으면 사슬이 거기서 끝납니다.",
    ),
    "M12",
)

ALL_ON_THE_RADIO = Twin(
    "all on the radio",
    {robot: [RADIO] * 3 for robot in RIGHT},
    Words(
        en="All on /tf, to be safe: then each bolt holds its whole chain back to the moment at which the bolt was last told.",
        ko="안전하게 모두 /tf로 보냈습니다. 그러면 볼트 하나하나가 사슬 전체를 볼트를 마지막으로 알린 시각에 묶어 둡니다.",
    ),
    "M12",
)

ALL_ON_THE_BOARD = Twin(
    "all on the board",
    {robot: [BOARD] * 3 for robot in RIGHT},
    Words(
        en="All on /tf_static: then nothing has a past, and what moves is frozen or lies about earlier moments.",
        ko="모두 /tf_static으로 보냈습니다. 그러면 과거가 없어서, 움직이는 것은 얼어붙거나 이전 시각에 대해 틀린 값을 줍니다.",
    ),
    "M12",
)

OTHER_WAY_ROUND = Twin(
    "other way round",
    {robot: [BOARD if topic == RADIO else RADIO for topic in topics] for robot, topics in RIGHT.items()},
    Words(
        en="The other way round: the board is for what is bolted on, the radio for what moves.",
        ko="반대입니다. 게시판은 고정된 것, 라디오는 움직이는 것에 씁니다.",
    ),
    "M12",
    partly=True,
)


TASK = Task(
    id="E6.1",
    kind="M",
    points=4,
    title=Words(en="Board or radio?", ko="게시판일까요, 라디오일까요?"),
    answer="topics",
    form=Parts({robot: Sequence(Choice((BOARD, RADIO))) for robot in RIGHT}),
    twins=(
        NOT_MOVING_NOW,
        PARKED,
        MAST_AT_REST,
        HELD_JOINT,
        STEADY_PICTURE,
        EVERY_CAMERA_MOVES,
        TAPED,
        OPTICAL,
        CORRECTED_SELDOM,
        ALL_ON_THE_RADIO,
        ALL_ON_THE_BOARD,
        OTHER_WAY_ROUND,
    ),
    hints=(
        Words(
            en="Ask of each edge: can the child ever move against its parent?",
            ko="연결마다 물어보세요. 자식이 부모를 기준으로 한 번이라도 움직일 수 있습니까?",
        ),
        Words(
            en='"Not now" and "seldom" are not "never". And riding along with the parent is not moving against it.',
            ko='"지금은 아니다", "드물다"는 "절대 아니다"와 다릅니다. 부모와 함께 움직이는 것은 부모를 기준으로 움직이는 것이 아닙니다.',
        ),
        Words(
            en="Screwed, taped, or fixed by definition: /tf_static. Wheels, joints, masts, gimbals, corrections: /tf.",
            ko="나사, 테이프, 정의로 정해진 것은 /tf_static입니다. 바퀴, 관절, 마스트, 짐벌, 보정은 /tf입니다.",
        ),
    ),
    cures=("M12",),
)
