"""E3.1: Four sentences, four calls."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Sequence, Task, Text, WrongAnswer

FRAMES = ("map", "odom", "base_link", "laser_frame", "camera_link", "camera_optical_frame")


SENTENCES = {
    "a": ["map", "laser_frame"],
    "b": ["base_link", "map"],
    "c": ["base_link", "camera_link"],
    "d": ["laser_frame", "base_link"],
}


SWAPPED = WrongAnswer(
    "swapped",
    {key: pair[::-1] for key, pair in SENTENCES.items()},
    Text(
        en="where it is wrong, you wrote [source, target]. In the call, the frame in which you want the "
        "data comes first.",
        ko="틀린 답은 순서가 뒤집혔습니다. [원본, 목표] 순서로 썼습니다. 호출에서는 데이터를 보고 싶은 좌표계가 "
        "먼저 옵니다.",
    ),
    "M1",
    partly=True,
)


WHERE_IS_IT = WrongAnswer(
    "where_is_it",
    SENTENCES | {"c": SENTENCES["c"][::-1]},
    Text(
        en='only c is the wrong way round. "Where is it?" asks for its own origin, which is written in '
        "`camera_link`; in which frame do you want it?",
        ko='c만 순서가 뒤집혔습니다. "어디에 있습니까?"는 그 원점을 묻는 말이고, 원점은 `camera_link` 기준입니다. '
        "그것을 어느 좌표계 기준으로 보고 싶습니까?",
    ),
    "M1",
)


PARENT_FIRST = {
    "a": ["map", "laser_frame"],
    "b": ["map", "base_link"],
    "c": ["base_link", "camera_link"],
    "d": ["base_link", "laser_frame"],
}


PARENT_FIRST_TWIN = WrongAnswer(
    "parent_first",
    PARENT_FIRST,
    Text(
        en="in b and d you put the parent first. Target and source have nothing to do with who is whose "
        "parent: in these two the data is wanted farther down the tree. Say each sentence aloud.",
        ko="b와 d에서 부모를 앞에 두었습니다. 목표와 원본은 누가 누구의 부모인지와 상관없습니다. 두 문장은 트리 "
        "아래쪽에서 데이터를 보고 싶은 경우입니다. 문장을 하나씩 소리 내어 읽어 보십시오.",
    ),
    "M2",
)


TASK = Task(
    id="E3.1",
    kind="M",
    points=4,
    title=Text(en="Four sentences, four calls", ko="문장 네 개, 호출 네 개"),
    answer="calls",
    form=Parts({key: Sequence(Choice(FRAMES)) for key in SENTENCES}),
    mistakes=(
        SWAPPED,
        WHERE_IS_IT,
        PARENT_FIRST_TWIN,
    ),
    hints=(
        Text(
            en='Turn each one into "data written in …, wanted in …".',
            ko='하나씩 "… 기준 데이터를 … 기준으로 보고 싶다"로 바꿔 보십시오.',
        ),
        Text(
            en="`lookup_transform(target, source, time)`: wanted in first, written in second.",
            ko="`lookup_transform(target, source, time)`입니다. 보고 싶은 기준이 먼저, 지금 기준이 다음입니다.",
        ),
        Text(
            en='"Where is X, seen from Y?" asks for X\'s own origin: written in X, wanted in Y.',
            ko='"Y에서 볼 때 X는 어디인가?"는 X의 원점을 묻습니다. X 기준인 점을 Y 기준으로 보고 싶은 것입니다.',
        ),
    ),
    misconceptions=("M1", "M2"),
    means={
        "odom": Text(
            en="In none of the four is anything written or wanted in odom.",
            ko="네 문장 어디에도 odom 기준인 데이터나 odom 기준으로 보려는 데이터가 없습니다.",
        ),
        "camera_optical_frame": Text(
            en="None of the four speaks of the optical frame.",
            ko="네 문장 어디에도 광학 좌표계는 나오지 않습니다.",
        ),
    },
    shows={
        "a[0]": Text(
            en="The first name is where the data is wanted: on what are the obstacles painted?",
            ko="첫 번째는 데이터를 보고 싶은 좌표계입니다. 장애물을 어디에 그립니까?",
        ),
        "a[1]": Text(
            en="The second name is the frame in which the data is written: not that of the robot they belong to, but of the "
            "sensor that reports the obstacles, in its own axes. Which one is it?",
            ko="두 번째는 데이터가 적힌 좌표계입니다. 장애물을 피할 로봇의 좌표계가 아니라, 장애물을 제 축으로 재서 알려 주는 "
            "센서의 좌표계입니다. 어느 센서입니까?",
        ),
        "b[0]": Text(
            en="The first name is where the data is wanted: who works with the goal, and in which frame?",
            ko="첫 번째는 데이터를 보고 싶은 좌표계입니다. 목표를 쓰는 것은 무엇이고, 어느 좌표계에서 계산합니까?",
        ),
        "b[1]": Text(
            en="The second name is the frame in which the data is written: in which was the goal given?",
            ko="두 번째는 데이터가 적힌 좌표계입니다. 목표는 어느 좌표계 기준으로 주어졌습니까?",
        ),
        "c[0]": Text(
            en="The first name is where the data is wanted: from where is it seen?",
            ko="첫 번째는 데이터를 보고 싶은 좌표계입니다. 어디에서 보았을 때의 위치입니까?",
        ),
        "c[1]": Text(
            en='The second name is the frame in which the data is written. "Where is X?" asks for X\'s own origin, '
            "(0, 0, 0): in which frame has it these numbers?",
            ko='두 번째는 데이터가 적힌 좌표계입니다. "X는 어디에 있습니까?"는 X의 원점 (0, 0, 0)을 묻습니다. '
            "어느 좌표계에서 이 숫자입니까?",
        ),
        "d[0]": Text(
            en="The first name is where the data is wanted: in which frame is this picture drawn?",
            ko="첫 번째는 데이터를 보고 싶은 좌표계입니다. 이 그림은 어느 좌표계로 그립니까?",
        ),
        "d[1]": Text(
            en="The second name is the frame in which the data is written: the robot's middle is the origin of one "
            "frame. Of which?",
            ko="두 번째는 데이터가 적힌 좌표계입니다. 로봇의 한가운데는 어느 좌표계의 원점입니까?",
        ),
    },
)
