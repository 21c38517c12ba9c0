"""E5.3: Which frame for which job?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

RIGHT = {
    "dock": "map",
    "line": "odom",
    "laser": "base_link",
    "kitchen": "map",
    "speed": "odom",
    "obstacles": "odom",
    "tray": "base_link",
    "goal": "map",
}


def but(*jobs, frame):
    return {**RIGHT, **dict.fromkeys(jobs, frame)}


MAP_FOR_CONTROL = WrongAnswer(
    "map for control",
    but("line", "speed", "obstacles", frame="map"),
    Text(
        en="In map the robot leaps at each correction: a speed of metres a second that nobody drove, obstacles that move aside. What is young and near wants the smooth frame.",
        ko="map 기준으로는 보정할 때마다 로봇이 튑니다. 달리지 않은 속도가 나오고 장애물이 옆으로 움직입니다. 새롭고 가까운 것에는 매끄러운 좌표계를 씁니다.",
    ),
    "M8",
)

SPEED_IN_MAP = WrongAnswer(
    "speed in map",
    but("speed", frame="map"),
    Text(
        en="speed: from poses in map a correction of 24 cm in a tenth of a second looks like more than 2 m/s.",
        ko="speed: map 기준 포즈로 계산하면 0.1초 사이의 24 cm 보정이 2 m/s가 넘는 속도로 보입니다.",
    ),
    "M8",
)

SPEED_ON_BOARD = WrongAnswer(
    "speed on board",
    but("speed", frame="base_link"),
    Text(
        en="speed: in base_link the robot never moves. Its own pose is zero there at every moment, and so is each difference.",
        ko="speed: base_link 기준으로 로봇은 움직이지 않습니다. 자기 포즈가 언제나 0이므로 차이도 0입니다.",
    ),
)

LINE_ON_BOARD = WrongAnswer(
    "line on board",
    but("line", frame="base_link"),
    Text(
        en="line: the line rests on the floor. In base_link its numbers change as the robot drives along it, and a point half a metre ahead stays half a metre ahead.",
        ko="line: 선은 바닥에 그대로 있습니다. base_link 기준 숫자는 로봇이 선을 따라갈수록 바뀌고, 0.5 m 앞의 점은 언제까지나 0.5 m 앞에 있습니다.",
    ),
)

LINE_IN_MAP = WrongAnswer(
    "line in map",
    but("line", frame="map"),
    Text(
        en="line: a controller in map takes each correction for a push. Half a metre is over before odom has drifted.",
        ko="line: map 기준 제어기는 보정을 떠밀린 것으로 받아들입니다. 0.5 m는 odom이 흐르기 전에 끝납니다.",
    ),
    "M8",
)

OBSTACLES_IN_MAP = WrongAnswer(
    "obstacles in map",
    but("obstacles", frame="map"),
    Text(
        en="obstacles: when the robot leaps on the map, what it saw a moment ago does not leap along.",
        ko="obstacles: 지도 위에서 로봇이 튈 때 방금 본 것은 함께 튀지 않습니다.",
    ),
    "M8",
)

OBSTACLES_ON_BOARD = WrongAnswer(
    "obstacles on board",
    but("obstacles", frame="base_link"),
    Text(
        en="obstacles: in base_link their numbers are sour as soon as the robot has moved. They rest in the room, not on the robot.",
        ko="obstacles: base_link 기준 숫자는 로봇이 움직이면 바로 상합니다. 장애물은 로봇이 아니라 방에 가만히 있습니다.",
    ),
)

GOALS_IN_ODOM = WrongAnswer(
    "goals in odom",
    but("dock", "kitchen", "goal", frame="odom"),
    Text(
        en="Goals kept in odom drift away: 0.7 m after ten seconds, 2.8 m after forty, on the page's robot. What is to hold for long belongs into the frame that does not drift.",
        ko="odom에 둔 목적지는 흘러갑니다. 이 장의 로봇에서는 10초가 지나면 0.7 m, 40초가 지나면 2.8 m였습니다. 오래 쓸 것은 흐르지 않는 좌표계에 둡니다.",
    ),
    "M8",
)

GOAL_IN_ODOM = WrongAnswer(
    "goal in odom",
    but("goal", frame="odom"),
    Text(
        en="goal: for ten minutes odom drifts away under it. Corrections move the robot on the map, not the goal.",
        ko="goal: 10분 동안 odom이 흘러갑니다. 보정은 지도 위의 로봇을 옮기지 목적지를 옮기지 않습니다.",
    ),
    "M8",
)

ALL_MAP = WrongAnswer(
    "all map",
    but(*RIGHT, frame="map"),
    Text(
        en="map for everything: accurate on average, and it leaps. Ask for each job: do I need smooth, or do I need lasting, or does it ride along?",
        ko="모두 map입니다. 평균은 정확하지만 튑니다. 일마다 물어보세요. 매끄러워야 합니까, 오래가야 합니까, 함께 움직입니까?",
    ),
    "M8",
)

ALL_ODOM = WrongAnswer(
    "all odom",
    but(*RIGHT, frame="odom"),
    Text(
        en="odom for everything: smooth, and after some minutes in another room. Ask for each job: smooth, lasting, or riding along?",
        ko="모두 odom입니다. 매끄럽지만 몇 분 뒤에는 다른 방에 있습니다. 일마다 물어보세요. 매끄러워야 합니까, 오래가야 합니까, 함께 움직입니까?",
    ),
    "M8",
)

BOLTED_IN_THE_ROOM = WrongAnswer(
    "bolted in the room",
    but("laser", "tray", frame="odom"),
    Text(
        en="What rides on the robot changes its numbers in odom with every wheel's turn. In which frame do they stand still?",
        ko="로봇에 실린 것은 바퀴가 돌 때마다 odom 기준 숫자가 바뀝니다. 어느 좌표계에서 숫자가 가만히 있습니까?",
    ),
)


TASK = Task(
    id="E5.3",
    kind="M",
    points=4,
    title=Text(en="Which frame for which job?", ko="어떤 일에 어떤 좌표계를 씁니까?"),
    answer="jobs",
    form=Parts({job: Choice(("map", "odom", "base_link")) for job in RIGHT}),
    mistakes=(
        MAP_FOR_CONTROL,
        SPEED_IN_MAP,
        LINE_IN_MAP,
        SPEED_ON_BOARD,
        LINE_ON_BOARD,
        OBSTACLES_IN_MAP,
        OBSTACLES_ON_BOARD,
        GOALS_IN_ODOM,
        GOAL_IN_ODOM,
        ALL_MAP,
        ALL_ODOM,
        BOLTED_IN_THE_ROOM,
    ),
    means={
        "map": Text(
            en="map does not drift, and it leaps at each correction.",
            ko="map은 흐르지 않지만 보정할 때마다 튑니다.",
        ),
        "odom": Text(
            en="odom never leaps, and it drifts by the minute.",
            ko="odom은 튀지 않지만 몇 분이면 흘러갑니다.",
        ),
        "base_link": Text(
            en="base_link rides along: what rests in the room moves in it.",
            ko="base_link는 로봇과 함께 갑니다. 방에 가만히 있는 것도 base_link를 기준으로 보면 움직입니다.",
        ),
    },
    shows={
        "dock": Text(
            en="dock: a dock stays in its corner of the building, tomorrow as well.",
            ko="dock: 충전대는 내일도 건물의 같은 자리에 있습니다.",
        ),
        "line": Text(
            en="line: half a metre lasts a second or two, and must not leap meanwhile.",
            ko="line: 0.5 m는 1, 2초면 끝나고 그동안 튀면 안 됩니다.",
        ),
        "laser": Text(
            en="laser: it is bolted on: which frame does it ride with?",
            ko="laser: 고정되어 있습니다. 어느 좌표계와 함께 움직입니까?",
        ),
        "kitchen": Text(
            en="kitchen: the way there takes minutes, along walls that stay.",
            ko="kitchen: 가는 데 몇 분이 걸리고 벽은 그대로 있습니다.",
        ),
        "speed": Text(
            en="speed: the difference of two poses must be what was driven, and nothing else.",
            ko="speed: 두 포즈의 차이는 실제로 달린 만큼이어야 합니다.",
        ),
        "obstacles": Text(
            en="obstacles: they rest in the room, and are of the last five seconds.",
            ko="obstacles: 방에 가만히 있는 것이고 지난 5초 동안 본 것입니다.",
        ),
        "tray": Text(
            en="tray: the cup rides on the robot: in which frame does it rest?",
            ko="tray: 컵은 로봇에 실려 있습니다. 어느 좌표계에서 가만히 있습니까?",
        ),
        "goal": Text(
            en="goal: ten minutes are long, and corrections come meanwhile: what has to stay where it is?",
            ko="goal: 10분은 길고 그동안 보정이 옵니다. 무엇이 제자리에 있어야 합니까?",
        ),
    },
    hints=(
        Text(en="Ask how long the numbers have to hold.", ko="숫자가 얼마나 오래 맞아야 하는지 물어보세요."),
        Text(
            en="Minutes and more: map. The next and the last few seconds: odom.",
            ko="몇 분 이상이면 map, 방금 지난 몇 초와 다음 몇 초면 odom입니다.",
        ),
        Text(en="What is bolted on or carried: base_link.", ko="고정되어 있거나 실려 있으면 base_link입니다."),
    ),
    misconceptions=("M8",),
)
