"""E11.5: What does the Fixed Frame change?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

RIGHT = {
    "screen": "changes",
    "pose in odom": "stays",
    "ranges": "stays",
    "errors": "changes",
    "localiser": "stays",
    "planner": "stays",
}


def but(*parts):
    return {**RIGHT, **{part: "stays" if RIGHT[part] == "changes" else "changes" for part in parts}}


EVERYTHING = WrongAnswer(
    "everything",
    dict.fromkeys(RIGHT, "changes"),
    Text(
        en="Not everything changes. RViz listens and draws; it publishes no transform and rewrites no message.",
        ko="모두 바뀌지는 않습니다. RViz는 듣고 그릴 뿐, 변환을 발행하거나 메시지를 고쳐 쓰지 않습니다.",
    ),
    "M15",
)

NOTHING = WrongAnswer(
    "nothing",
    dict.fromkeys(RIGHT, "stays"),
    Text(
        en="Something does change: turn to another Fixed Frame on the page, and look at the picture and at its list.",
        ko="바뀌는 것이 있습니다. 본문에서 Fixed Frame을 바꾸어 그림과 목록을 보세요.",
    ),
)

DATA_MOVED = WrongAnswer(
    "data moved",
    but("pose in odom", "ranges"),
    Text(
        en="The numbers that were published are the same; what is drawn elsewhere is their picture.",
        ko="발행된 숫자는 그대로입니다. 다른 자리에 그려진 것은 그림뿐입니다.",
    ),
    "M15",
    partly=True,
)

JUMPS_CURED = WrongAnswer(
    "jumps cured",
    but("localiser"),
    Text(
        en="localiser: it corrects map → odom as before. With Fixed Frame odom the map jumps on the screen instead of the robot: you have only turned your head.",
        ko="localiser: 예전처럼 map → odom을 바로잡습니다. Fixed Frame이 odom이면 화면에서 로봇 대신 지도가 튈 뿐입니다. 고개만 돌린 셈입니다.",
    ),
    "M8",
)

PLANNER_TOO = WrongAnswer(
    "planner too",
    but("planner"),
    Text(
        en="planner: no other node learns what you chose in RViz.",
        ko="planner: RViz에서 고른 것을 다른 노드는 알지 못합니다.",
    ),
)

ERRORS_STAY = WrongAnswer(
    "errors stay",
    but("errors"),
    Text(
        en="errors: whether something can be drawn depends on whether there is a path to the Fixed Frame. From a frame of the other tree other things can be reached.",
        ko="errors: 그릴 수 있는지는 Fixed Frame까지 경로가 있는지에 달렸습니다. 다른 트리의 좌표계를 고르면 닿을 수 있는 것도 달라집니다.",
    ),
)

SCREEN_STAYS = WrongAnswer(
    "screen stays",
    but("screen"),
    Text(
        en="screen: everything is drawn in the Fixed Frame. Another frame, another place.",
        ko="screen: 모든 것을 Fixed Frame 기준으로 그립니다. 기준이 바뀌면 자리도 바뀝니다.",
    ),
)


TASK = Task(
    id="E11.5",
    kind="M",
    points=2,
    title=Text(en="What does the Fixed Frame change?", ko="Fixed Frame은 무엇을 바꿉니까?"),
    answer="changes",
    form=Parts({part: Choice(("changes", "stays")) for part in RIGHT}),
    mistakes=(EVERYTHING, NOTHING, JUMPS_CURED, PLANNER_TOO, ERRORS_STAY, SCREEN_STAYS, DATA_MOVED),
    hints=(
        Text(
            en="Ask for each: is it on the screen, or in a message?",
            ko="하나씩 물어보세요. 화면에 있는 것입니까, 메시지에 있는 것입니까?",
        ),
        Text(en="RViz publishes no transform.", ko="RViz는 변환을 발행하지 않습니다."),
        Text(
            en="Two of the six are RViz's own: where it draws, and what it can draw.",
            ko="여섯 가운데 둘만 RViz의 것입니다. 어디에 그리는지와 무엇을 그릴 수 있는지입니다.",
        ),
    ),
    misconceptions=("M8", "M15"),
)
