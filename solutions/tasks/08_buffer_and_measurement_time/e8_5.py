"""E8.5: Six symptoms."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

SYMPTOMS = ("a", "b", "c", "d", "e", "f")


CAUSES = (
    "stamp overwritten", "odometry slow", "static mount wrong", "two clocks", "cache too short", "import missing",
)  # fmt: skip


RIGHT = dict(
    zip(
        SYMPTOMS,
        ("stamp overwritten", "static mount wrong", "two clocks", "cache too short", "odometry slow", "import missing"),
        strict=True,
    )
)


MOUNT_FOR_A_SMEAR = WrongAnswer(
    "mount for a smear",
    {**RIGHT, "a": "static mount wrong"},
    Text(
        en="a: a wrong mount is wrong standing still, too. What changes only while the robot turns, and why would a delay read zero after 0.3 s of filtering?",
        ko="a: 장착값이 틀렸다면 서 있을 때도 틀립니다. 회전할 때만 달라지는 것은 무엇이고, 0.3초를 거른 뒤에 delay가 0인 까닭은 무엇입니까?",
    ),
    "M9",
)


ODOMETRY_FOR_A_SMEAR = WrongAnswer(
    "odometry for a smear",
    {**RIGHT, "a": "odometry slow"},
    Text(
        en="a: late odometry can smear walls, but it does not make the delay of a filtered scan read zero. Whose clock wrote that stamp?",
        ko="a: 늦은 오도메트리도 벽을 번지게 하지만, 거른 스캔의 delay를 0으로 만들지는 않습니다. 그 시각은 누구의 시계로 찍었습니까?",
    ),
    "M9",
)


STAMPS_FOR_A_MOUNT = WrongAnswer(
    "stamps for a mount",
    {**RIGHT, "b": "stamp overwritten"},
    Text(
        en="b: an error of time needs motion. This one stays when the robot stands.",
        ko="b: 시간의 오차는 움직여야 나타납니다. 이것은 로봇이 서 있어도 남습니다.",
    ),
    "M15",
)


SLOW_FOR_TWO_CLOCKS = WrongAnswer(
    "slow for two clocks",
    {**RIGHT, "c": "odometry slow"},
    Text(
        en="c: look at the size of the gap. No network and no publisher is that late.",
        ko="c: 차이의 크기를 보십시오. 어떤 네트워크도 어떤 발행자도 그렇게 늦지 않습니다.",
    ),
    "M10",
)


CLOCKS_FOR_A_SHORT_CACHE = WrongAnswer(
    "clocks for a short cache",
    {**RIGHT, "d": "two clocks"},
    Text(
        en="d: no clock has to be wrong for this. The picture is thought about for 12 s, so its stamp is 12 s old by every clock; and the earliest data is 1.6 s younger than that. How long does a buffer remember if you say nothing?",
        ko="d: 시계가 틀리지 않아도 이렇게 됩니다. 영상을 12초 동안 계산하므로 그 측정 시각은 어느 시계로 보아도 12초 지난 것이고, 버퍼의 가장 오래된 데이터는 그보다 1.6초 늦습니다. 따로 정하지 않으면 버퍼는 얼마나 기억합니까?",
    ),
    "M11",
)


CACHE_FOR_A_SLOW_LANE = WrongAnswer(
    "cache for a slow lane",
    {**RIGHT, "e": "cache too short"},
    Text(
        en="e: the cache decides how far back you can ask. These requests look forward, past the newest sample.",
        ko="e: 보관 시간은 얼마나 옛날까지 물을 수 있는지를 정합니다. 이 요청들은 가장 새로운 표본보다 늦은 시각을 묻습니다.",
    ),
    "M11",
)


CLOCKS_FOR_A_SLOW_LANE = WrongAnswer(
    "clocks for a slow lane",
    {**RIGHT, "e": "two clocks"},
    Text(
        en="e: two clocks that disagree do so for every message alike. Here one in four gets through, and one publisher speaks once a second.",
        ko="e: 시계가 서로 다르면 모든 메시지가 똑같이 어긋납니다. 여기서는 넷 중 하나가 통과하고, 한 발행자는 초당 한 번 발행합니다.",
    ),
    "M10",
)


OVERWRITTEN_FOR_A_SLOW_LANE = WrongAnswer(
    "overwritten for a slow lane",
    {**RIGHT, "e": "stamp overwritten"},
    Text(
        en="e: a stamp that was overwritten asks too late as well, but by its delay, and so does every message alike. Here one in four gets through, others lack up to a second, and one publisher speaks once a second.",
        ko="e: 측정 시각을 덮어써도 너무 늦은 시각의 변환을 조회하지만, 숨긴 지연만큼이고 어느 메시지나 똑같습니다. 여기서는 넷 중 하나가 통과하고 나머지는 길면 1초까지 모자라며, 한 발행자는 초당 한 번 발행합니다.",
    ),
    "M9",
)


SLOW_FOR_A_SHORT_CACHE = WrongAnswer(
    "slow for a short cache",
    {**RIGHT, "d": "odometry slow"},
    Text(
        en="d: this one is about the earliest data. A slow lane ends too early; which fault makes a lane begin too late?",
        ko="d: 이 오류에 나오는 것은 가장 오래된 데이터의 시각입니다. 느린 시간줄은 너무 일찍 끝납니다. 시간줄이 너무 늦게 시작하게 만드는 것은 무엇입니까?",
    ),
    "M11",
)


A_CAUSE_OF_TIME_FOR_THE_TRACEBACK = WrongAnswer(
    "a cause of time for the traceback",
    {**RIGHT, "f": "two clocks"},
    Text(
        en="f: whatever is wrong with time or frames raises a TransformException, and every one of those is caught here. So this error is of another family.",
        ko="f: 시각이나 좌표계에 문제가 있으면 TransformException이 나오고, 여기서는 그것을 모두 잡습니다. 그러니 이 오류는 다른 집안의 것입니다.",
    ),
    "M11",
)


TASK = Task(
    id="E8.5",
    kind="D",
    points=3,
    title=Text(en="Six symptoms", ko="여섯 가지 증상"),
    answer="causes",
    form=Parts({symptom: Choice(CAUSES) for symptom in SYMPTOMS}),
    mistakes=(
        MOUNT_FOR_A_SMEAR,
        ODOMETRY_FOR_A_SMEAR,
        STAMPS_FOR_A_MOUNT,
        SLOW_FOR_TWO_CLOCKS,
        CLOCKS_FOR_A_SHORT_CACHE,
        CACHE_FOR_A_SLOW_LANE,
        CLOCKS_FOR_A_SLOW_LANE,
        OVERWRITTEN_FOR_A_SLOW_LANE,
        SLOW_FOR_A_SHORT_CACHE,
        A_CAUSE_OF_TIME_FOR_THE_TRACEBACK,
    ),
    hints=(
        Text(
            en="Ask of each symptom first: does it stay when the robot stands still?",
            ko="증상마다 먼저 물으십시오. 로봇이 서 있어도 남아 있습니까?",
        ),
        Text(
            en="For the three texts: into the past or into the future, and by how much? Milliseconds, seconds or years?",
            ko="오류 메시지에서는 과거인지 미래인지, 그리고 얼마나 모자라는지를 보십시오. 밀리초입니까, 초입니까, 년입니까?",
        ),
        Text(
            en="One of them is no TransformException at all, one has been made to look fresh, one forgot too soon. Each cause is used once.",
            ko="하나는 TransformException이 아예 아니고, 하나는 새것처럼 꾸며졌으며, 하나는 너무 빨리 잊었습니다. 원인은 한 번씩만 쓰입니다.",
        ),
    ),
    misconceptions=("M9", "M10", "M11", "M15"),
    means={
        "stamp overwritten": Text(
            en="a stamp that was overwritten makes data look fresh: it is late by the delay that it hides, some hundredths or tenths of a second, in every message alike.",
            ko="측정 시각을 덮어쓰면 데이터가 새것처럼 보입니다. 숨긴 지연만큼, 곧 0.01초에서 0.1초대만큼 어느 메시지에서나 똑같이 늦습니다.",
        ),
        "odometry slow": Text(
            en="a slow edge lacks its newest samples only: it refuses the latest requests, by less than its period.",
            ko="느린 연결에는 가장 새로운 표본만 없습니다. 한 주기보다 짧은 차이로 최신 요청을 거절합니다.",
        ),
        "static mount wrong": Text(
            en="a wrong mount is wrong at rest, too, and raises no error.",
            ko="장착값이 틀리면 서 있을 때도 틀리고, 오류는 나지 않습니다.",
        ),
        "two clocks": Text(
            en="two clocks that disagree do so for every message alike, moving or not.",
            ko="서로 다른 두 시계는 움직이든 서 있든 모든 메시지에서 똑같이 어긋납니다.",
        ),
        "cache too short": Text(
            en="a short cache forgets what is old: its errors go into the past.",
            ko="보관 시간이 짧으면 오래된 것을 잊으므로 과거 쪽의 오류가 납니다.",
        ),
        "import missing": Text(
            en="a missing import raises a TypeException, each time, moving or not.",
            ko="import가 없으면 움직임과 상관없이 매번 TypeException이 납니다.",
        ),
    },
    shows={
        "a": Text(
            en="Here it is wrong only while it turns, and the delay reads zero after 0.3 s of filtering.",
            ko="여기서는 회전할 때만 틀리고, 0.3초를 거른 뒤인데 delay가 0입니다.",
        ),
        "b": Text(
            en="Here there is no error, and the same 5 cm driving or standing.",
            ko="여기서는 오류가 없고, 달리든 서 있든 똑같이 5cm 어긋납니다.",
        ),
        "c": Text(
            en="Here the two times are more than fifty years apart.",
            ko="여기서는 두 시각이 50년 넘게 떨어져 있습니다.",
        ),
        "d": Text(
            en="Here it is 1.6 s into the past, for one who thinks for 12 s.",
            ko="여기서는 12초를 계산하는 쪽이 1.6초 과거를 물었습니다.",
        ),
        "e": Text(
            en="Here it is less than a second into the future, three times of four, and one publisher speaks once a second.",
            ko="여기서는 넷 중 셋이 1초 이내의 미래이고, 한 발행자는 초당 한 번 보냅니다.",
        ),
        "f": Text(
            en="Here the error walks past `except TransformException`.",
            ko="여기서는 오류가 `except TransformException`에 잡히지 않습니다.",
        ),
    },
)
