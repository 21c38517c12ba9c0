"""E1.2: Which message can be used?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

OPTIONS = ("usable", "no frame", "no stamp", "label contradicts numbers")
RIGHT = {
    "a": "usable",
    "b": "no frame",
    "c": "no stamp",
    "d": "usable",
    "e": "label contradicts numbers",
    "f": "usable",
}


ZERO_TAKEN_FOR_FRESH = WrongAnswer(
    "zero taken for fresh",
    {**RIGHT, "c": "usable"},
    Text(
        en='c: a stamp of zero is no time at all. TF2 reads it as "whatever is latest" and moves the apple with the pose of another moment, without a word.',
        ko="c: 0인 측정 시각은 시각이 아닙니다. TF2는 “가장 최근 것이면 된다”로 읽고, 아무 말 없이 다른 순간의 포즈로 사과를 옮깁니다.",
    ),
    "M9",
)


A_NAME_THAT_LOOKS_FINE = WrongAnswer(
    "a name that looks fine",
    {**RIGHT, "e": "usable"},
    Text(
        en="e: map is a good name, but can every door of a building be at the same place in map? "
        "From where would each of them look alike?",
        ko="e: map은 올바른 이름입니다. 그런데 건물의 문이 모두 지도에서 같은 자리에 있을 수 있습니까? "
        "어디에서 보면 어느 문이든 똑같아 보입니까?",
    ),
)


OLD_IS_USELESS = WrongAnswer(
    "old is useless",
    {**RIGHT, "d": "no stamp"},
    Text(
        en="d: there is a stamp, half a minute old. A lamp that rests keeps its numbers in map: age does not spoil them.",
        ko="d: 측정 시각이 있습니다. 30초쯤 되었을 뿐입니다. 가만히 있는 전등의 map 기준 숫자는 오래되어도 상하지 않습니다.",
    ),
)


WHAT_RESTS_ON_THE_ROBOT = WrongAnswer(
    "what rests on the robot",
    {**RIGHT, "f": "label contradicts numbers"},
    Text(
        en="f: 10 cm behind the robot's middle and 20 cm up is a likely place for a tray, and in base_link it stays there.",
        ko="f: 로봇 중심에서 뒤로 10 cm, 위로 20 cm는 쟁반이 있을 만한 자리이고, base_link 기준으로는 늘 거기에 있습니다.",
    ),
)


NEW_LABEL_FOR_A_LIE = WrongAnswer(
    "missing for a lie",
    {**RIGHT, "e": "no frame"},
    Text(
        en="e: a frame is written there. The trouble is not that it is missing, but that it cannot be true.",
        ko="e: 좌표계는 적혀 있습니다. 없는 것이 아니라 사실일 수 없는 것이 문제입니다.",
    ),
)


TASK = Task(
    id="E1.2",
    kind="M",
    points=3,
    title=Text(en="Which message can be used?", ko="어느 메시지를 쓸 수 있습니까?"),
    answer="verdicts",
    form=Parts({name: Choice(OPTIONS) for name in RIGHT}),
    mistakes=(
        ZERO_TAKEN_FOR_FRESH,
        A_NAME_THAT_LOOKS_FINE,
        OLD_IS_USELESS,
        WHAT_RESTS_ON_THE_ROBOT,
        NEW_LABEL_FOR_A_LIE,
    ),
    means={
        "usable": Text(
            en="To be usable, a message needs both labels, and they have to be true.",
            ko="쓸 수 있으려면 두 이름표가 다 있고 사실이어야 합니다.",
        ),
        "no frame": Text(
            en="No frame means that `frame_id` is empty.", ko="no frame은 `frame_id`가 비어 있다는 뜻입니다."
        ),
        "no stamp": Text(
            en="No stamp means that it is zero: nobody wrote one. An old stamp is a stamp.",
            ko="no stamp는 0, 곧 아무도 쓰지 않았다는 뜻입니다. 오래된 측정 시각도 측정 시각입니다.",
        ),
        "label contradicts numbers": Text(
            en="A contradiction needs a label, and numbers that cannot come from that frame.",
            ko="모순이라고 하려면 이름표가 있고, 그 좌표계에서 나올 수 없는 숫자여야 합니다.",
        ),
    },
    shows={
        "a": Text(
            en="a: what a laser measured, told in the laser's own frame, a tenth of a second ago.",
            ko="a: 레이저가 0.1초 전에 잰 것을 레이저 자신의 좌표계로 적었습니다.",
        ),
        "b": Text(en="b: read its `frame_id` once more.", ko="b: `frame_id`를 다시 읽어 보세요."),
        "c": Text(en="c: read its stamp once more.", ko="c: 측정 시각을 다시 읽어 보세요."),
        "d": Text(
            en="d: do the lamps of a building move? Whoever saw one may have moved its numbers into map before sending them.",
            ko="d: 건물의 전등이 움직입니까? 카메라가 본 것이라도 map 기준으로 바꾼 뒤에 보낼 수 있습니다.",
        ),
        "e": Text(
            en="e: the same three numbers before every door: seen from where?",
            ko="e: 어느 문 앞에서나 같은 숫자 세 개입니다. 어디에서 본 숫자입니까?",
        ),
        "f": Text(
            en="f: a tray that is bolted on does not move in base_link, however long ago it was measured.",
            ko="f: 고정된 쟁반은 언제 쟀든 base_link 기준으로 움직이지 않습니다.",
        ),
    },
    hints=(
        Text(
            en="Read frame and stamp before you read the numbers.",
            ko="숫자를 읽기 전에 좌표계와 측정 시각부터 읽어 보세요.",
        ),
        Text(
            en="Then ask: could numbers like these come from that frame?",
            ko="그다음 물어보세요. 이런 숫자가 그 좌표계에서 나올 수 있습니까?",
        ),
        Text(
            en="Three are usable. One of them is old, and rests; one is older still, and rides on the robot.",
            ko="쓸 수 있는 것은 셋입니다. 하나는 오래되었지만 가만히 있고, 하나는 더 오래되었지만 로봇에 실려 있습니다.",
        ),
    ),
    misconceptions=("M9",),
)
