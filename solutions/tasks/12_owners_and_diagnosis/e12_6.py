"""E12.6: The wall that smears."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

ORDER = ("fixed frame", "tree", "mount", "rates", "header", "publishers")
CARDS = (*ORDER, "new sensor", "longer timeout")
RIGHT = dict(zip(("first", "second", "third", "fourth", "fifth", "sixth"), ORDER, strict=True))


def in_this_order(*cards):
    return dict(zip(RIGHT, cards, strict=True))


SENSOR_FIRST = WrongAnswer(
    "sensor first",
    in_this_order("new sensor", *ORDER[:5]),
    Text(
        en="The points come ten times a second and are sharp while the robot stands. A new sensor smears just the same. Begin with names, which cost nothing.",
        ko="점은 1초에 열 번 오고, 로봇이 서 있으면 또렷합니다. 새 센서도 똑같이 번집니다. 돈이 들지 않는 이름부터 보십시오.",
    ),
    "M15",
)

TIMEOUT_AMONG_THEM = WrongAnswer(
    "timeout among them",
    in_this_order("fixed frame", "tree", "longer timeout", "mount", "rates", "header"),
    Text(
        en="Nothing is missing in this picture, so nothing is gained by waiting. A timeout is no check: it shows no fact.",
        ko="이 그림에는 빠진 것이 없으니 기다려도 얻을 것이 없습니다. timeout은 검사가 아닙니다. 사실을 보여 주지 않습니다.",
    ),
    "M10",
)

TIMEOUT_FIRST = WrongAnswer(
    "timeout first",
    in_this_order("longer timeout", *ORDER[:5]),
    Text(
        en="A longer timeout stands first, and so each check after it comes one place too late, and the last has none. It is no check: it waits, and shows no fact.",
        ko="timeout을 늘리는 것이 맨 앞에 있어서 그 뒤의 검사가 모두 한 자리씩 밀리고, 마지막 검사는 자리를 잃었습니다. 그것은 검사가 아닙니다. 기다릴 뿐 사실을 보여 주지 않습니다.",
    ),
    "M10",
)

NAMES_LAST = WrongAnswer(
    "names last",
    in_this_order(*ORDER[1:], ORDER[0]),
    Text(
        en="The names stand last, and so all else comes one place too early. A name costs one glance, and while it is wrong nothing else can be judged.",
        ko="이름을 맨 나중에 두어서 나머지가 모두 한 자리씩 앞당겨졌습니다. 이름은 한 번 보면 되고, 이름이 틀린 동안에는 다른 것을 판단할 수 없습니다.",
    ),
)

NO_STAMP = WrongAnswer(
    "ends before the stamp",
    in_this_order("fixed frame", "tree", "mount", "rates", "publishers", "new sensor"),
    Text(
        en="You never look at the message itself: its frame, its stamp, the clock it came from. A smear in bends is a question of the moment.",
        ko="메시지 자체를 보지 않습니다. 좌표계, 측정 시각, 그 시각을 준 시계를 보아야 합니다. 굽은 길에서 번지는 것은 시각의 문제입니다.",
    ),
    "M9",
)

PUBLISHERS_FIRST = WrongAnswer(
    "publishers first",
    in_this_order("publishers", "fixed frame", "tree", "mount", "rates", "header"),
    Text(
        en="Counting publishers is the sixth step of six: it costs most and says least as long as nobody knows which edge it is about.",
        ko="발행자를 세는 일은 여섯 걸음 가운데 마지막입니다. 어느 연결이 문제인지 모를 때는 가장 비싸고 알려 주는 것도 가장 적습니다.",
    ),
    "M6",
)

VALUE_BEFORE_TREE = WrongAnswer(
    "value before the tree",
    in_this_order("fixed frame", "mount", "tree", "rates", "header", "publishers"),
    Text(
        en="A value can be read only where there is a way: first whether the frames hang together, then what an edge says.",
        ko="값은 길이 있어야 읽을 수 있습니다. 먼저 좌표계가 이어졌는지 보고, 그다음에 연결의 값을 봅니다.",
    ),
)


TASK = Task(
    id="E12.6",
    kind="D",
    points=3,
    title=Text(en="The wall that smears", ko="번지는 벽"),
    answer="steps",
    form=Parts({place: Choice(CARDS) for place in RIGHT}),
    mistakes=(
        SENSOR_FIRST,
        TIMEOUT_FIRST,
        TIMEOUT_AMONG_THEM,
        NAMES_LAST,
        NO_STAMP,
        PUBLISHERS_FIRST,
        VALUE_BEFORE_TREE,
    ),
    means={
        "fixed frame": Text(
            en="Names cost one glance. What can be judged while a name is wrong?",
            ko="이름은 한 번 보면 됩니다. 이름이 틀린 동안에 판단할 수 있는 것이 있습니까?",
        ),
        "tree": Text(
            en="The tree tells whether there is a way at all. Which of the cards need a way, and what has to be right before you look for one?",
            ko="트리는 길이 있기는 한지 알려 줍니다. 길이 있어야 볼 수 있는 카드는 무엇이고, 길을 찾기 전에 맞아야 하는 것은 무엇입니까?",
        ),
        "mount": Text(
            en="A value can be read where there is a way, and it stands still while you read. Which cards does it need before, and which look at something that moves?",
            ko="값은 길이 있어야 읽을 수 있고, 읽는 동안 변하지 않습니다. 그보다 먼저 필요한 카드는 무엇이고, 움직이는 것을 보는 카드는 무엇입니까?",
        ),
        "rates": Text(
            en="Delays and rates take some listening. Which cards are cheaper, and which look at one message instead of the edges?",
            ko="지연과 발행률은 한동안 들어야 합니다. 더 싼 카드는 무엇이고, 연결이 아니라 메시지 하나를 보는 카드는 무엇입니까?",
        ),
        "header": Text(
            en="The header belongs to the message: it is held against what TF itself does. Has TF been looked at before it, and is the question who sends still to come?",
            ko="header는 메시지의 것이고, TF가 하는 일에 견주어 봅니다. 그 전에 TF를 보았습니까? 누가 보내는지는 아직 보지 않았습니까?",
        ),
        "publishers": Text(
            en="Who sends is asked when it is known which edge or message it is about. What tells you that?",
            ko="누가 보내는지는 어느 연결이나 메시지의 문제인지 안 다음에 묻습니다. 그것을 알려 주는 카드는 무엇입니까?",
        ),
        "new sensor": Text(
            en="That buys something, and shows no fact.",
            ko="새로 사는 것이고, 사실을 보여 주지 않습니다.",
        ),
        "longer timeout": Text(
            en="That waits, and shows no fact. Nothing is missing in this picture.",
            ko="기다리는 것이고, 사실을 보여 주지 않습니다. 이 그림에는 빠진 것이 없습니다.",
        ),
    },
    hints=(
        Text(
            en="Cheap and coarse first, dear and fine last.",
            ko="싸고 대략적인 것이 먼저, 비싸고 세밀한 것이 나중입니다.",
        ),
        Text(
            en="Names, then connections, then values, then times, then the message, then who sends.",
            ko="이름, 연결, 값, 시간, 메시지, 발행자 순서입니다.",
        ),
        Text(
            en="Two cards are no checks: one buys something, the other waits.",
            ko="두 카드는 검사가 아닙니다. 하나는 새로 사는 것이고 하나는 기다리는 것입니다.",
        ),
    ),
    misconceptions=("M6", "M9", "M10", "M15"),
)
