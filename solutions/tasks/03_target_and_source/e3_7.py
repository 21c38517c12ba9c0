"""E3.7: Three nodes, one swap."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

NODES = ("node_a", "node_b", "node_c")


ROBOTS = (
    "stops for the wrong things",
    "is drawn where it is not",
    "stops with an exception",
    "drives to another place",
)


HIDDEN = ("it stands on the map's origin, not turned", "it stands still", "the goal is far away")


def blamed(node: str, robot: str, hidden_while: str = HIDDEN[0]) -> dict[str, str]:
    return {"node": node, "robot": robot, "hidden_while": hidden_while}


BY_ITS_LOOKS = WrongAnswer(
    "by_its_looks",
    blamed("node_c", ROBOTS[1]),
    Text(
        en="node_c has the same line as node_b, and it is not the line that is wrong. The robot's own "
        "origin is written in `base_link`; node_c wants it in `map`. What does node_b hold, and want?",
        ko="node_c는 node_b와 같은 줄을 썼고, 줄 자체가 틀린 것은 아닙니다. 로봇의 원점은 `base_link` "
        "기준이고 node_c는 그것을 `map` 기준으로 보고 싶어 합니다. node_b는 어느 좌표계의 데이터를, 어느 좌표계에서 보려 합니까?",
    ),
    "M2",
)


AGAINST_THE_ARROW = WrongAnswer(
    "against_the_arrow",
    blamed("node_a", ROBOTS[0]),
    Text(
        en="node_a is right. In the call the target comes first, the frame in which the data is wanted: `base_link`. The "
        "source comes second, the frame in which it is written: the point's own. Who is whose parent plays no part.",
        ko="node_a는 맞습니다. 호출에서는 데이터를 보고 싶은 좌표계인 목표가 먼저이고, 여기서는 `base_link`입니다. 데이터가 적힌 "
        "좌표계인 원본은 그다음이고, 여기서는 점의 헤더에 있는 좌표계입니다. 누가 누구의 부모인지와는 상관없습니다.",
    ),
    "M2",
)


EXPECTS_AN_EXCEPTION = WrongAnswer(
    "expects_an_exception",
    blamed("node_b", ROBOTS[2]),
    Text(
        en="a swapped lookup raises nothing: both questions have an answer. What "
        "does a robot do that believes this one?",
        ko="바꿔 쓴 조회는 예외를 내지 않습니다. 두 질문 모두 답이 있기 때문입니다. 그 답을 믿은 로봇은 무엇을 합니까?",
    ),
    "M1",
)


STILL_IS_ENOUGH = WrongAnswer(
    "still_is_enough",
    blamed("node_b", ROBOTS[3], HIDDEN[1]),
    Text(
        en="standing still does not help: a wrong transform is wrong at rest, "
        "too. For which transform is the inverse the same?",
        ko="서 있다고 해서 맞지는 않습니다. 틀린 변환은 서 있을 때도 틀립니다. 역변환이 "
        "자기 자신과 같은 변환은 어떤 것입니까?",
    ),
    "M3",
)


FAR_AWAY = WrongAnswer(
    "far_away",
    blamed("node_b", ROBOTS[3], HIDDEN[2]),
    Text(
        en="a far goal does not help: the farther away it is, the farther off a "
        "wrong turn throws it. For which transform is the inverse the same?",
        ko="목적지가 멀어도 드러납니다. 멀수록 틀린 회전 때문에 더 크게 어긋납니다. 역변환이 "
        "자기 자신과 같은 변환은 어떤 것입니까?",
    ),
    "M3",
)


NODE_A_AT_REST = WrongAnswer(
    "node_a_at_rest",
    blamed("node_a", ROBOTS[0], HIDDEN[1]),
    Text(
        en="node_a asks rightly: the target comes first, and its point is wanted in `base_link`; the source comes second, "
        "and the point is written in the frame of its own header. And a wrong transform would be wrong at rest, too. Say the sentences of the other two nodes.",
        ko="node_a는 바르게 물었습니다. 목표가 먼저인데, 점을 보고 싶은 기준이 `base_link`입니다. 원본은 그다음인데, 점은 자기 "
        "헤더의 좌표계 기준입니다. 그리고 틀린 변환은 "
        "서 있을 때도 틀립니다. 나머지 두 노드를 문장으로 말해 보십시오.",
    ),
    "M2",
)


NODE_C_AT_REST = WrongAnswer(
    "node_c_at_rest",
    blamed("node_c", ROBOTS[1], HIDDEN[1]),
    Text(
        en="node_c asks rightly: the robot's origin is written in `base_link`, and wanted in `map`. And a wrong "
        "transform would be wrong at rest, too. Which node has a goal of the map, and wants it in `base_link`?",
        ko="node_c는 바르게 물었습니다. 로봇의 원점은 `base_link` 기준이고, 그것을 `map` 기준으로 보고 싶습니다. 그리고 틀린 변환은 "
        "서 있을 때도 틀립니다. 지도 기준 목적지를 `base_link` 기준으로 보고 싶은 노드는 어느 것입니까?",
    ),
    "M2",
)


TASK = Task(
    id="E3.7",
    kind="D",
    points=3,
    title=Text(en="Three nodes, one swap", ko="노드 셋, 하나는 거꾸로"),
    answer="verdict",
    form=Parts({"node": Choice(NODES), "robot": Choice(ROBOTS), "hidden_while": Choice(HIDDEN)}),
    mistakes=(
        BY_ITS_LOOKS,
        AGAINST_THE_ARROW,
        EXPECTS_AN_EXCEPTION,
        STILL_IS_ENOUGH,
        FAR_AWAY,
        NODE_A_AT_REST,
        NODE_C_AT_REST,
    ),
    hints=(
        Text(
            en="Each comment says in which frame the data is written. Say the three sentences.",
            ko="주석마다 데이터가 어느 좌표계 기준인지 적혀 있습니다. 문장 세 개로 말해 보십시오.",
        ),
        Text(
            en="The frame that the data is written in must be the second argument.",
            ko="데이터의 기준 좌표계가 둘째 인자여야 합니다.",
        ),
        Text(
            en="Nothing stops: TF2 answers the opposite question. The numbers that come out belong somewhere else.",
            ko="아무것도 멈추지 않습니다. TF2는 반대 질문에 답할 뿐이고, 나온 숫자는 다른 곳을 가리킵니다.",
        ),
    ),
    misconceptions=("M1", "M2"),
    means={
        "node_a": Text(
            en="node_a asks rightly: the target comes first, and its point is wanted in `base_link`; the source comes "
            "second, and the point is written in the frame of its own header.",
            ko="node_a는 바르게 물었습니다. 목표가 먼저인데, 점을 보려는 기준이 `base_link`입니다. 원본은 그다음인데, 점은 자기 "
            "헤더의 좌표계 기준입니다.",
        ),
        "node_c": Text(
            en="node_c asks rightly: the target comes first, and the robot's origin is wanted in `map`; the source comes "
            "second, and it is written in `base_link`.",
            ko="node_c는 바르게 물었습니다. 목표가 먼저인데, 로봇의 원점을 보려는 기준이 `map`입니다. 원본은 그다음인데, 그 "
            "원점은 `base_link` 기준입니다.",
        ),
        "stops for the wrong things": Text(
            en="to stop for obstacles is node_a's work, and node_a asks rightly.",
            ko="장애물 앞에서 멈추는 것은 node_a의 일이고, node_a는 바르게 물었습니다.",
        ),
        "is drawn where it is not": Text(
            en="to paint the robot is node_c's work, and node_c asks rightly.",
            ko="로봇을 그리는 것은 node_c의 일이고, node_c는 바르게 물었습니다.",
        ),
        "stops with an exception": Text(
            en="a swapped lookup raises nothing: both questions have an answer.",
            ko="바꿔 쓴 조회는 예외를 내지 않습니다. 두 질문 모두 답이 있습니다.",
        ),
        "it stands still": Text(
            en="a wrong transform is wrong at rest, too. For which transform is the inverse the same?",
            ko="틀린 변환은 서 있을 때도 틀립니다. 역변환이 자기 자신과 같은 변환은 어떤 것입니까?",
        ),
        "the goal is far away": Text(
            en="the farther the goal, the farther off a wrong turn throws it. For which transform is the inverse the same?",
            ko="목적지가 멀수록 틀린 회전 때문에 더 크게 어긋납니다. 역변환이 자기 자신과 같은 변환은 어떤 것입니까?",
        ),
    },
)
