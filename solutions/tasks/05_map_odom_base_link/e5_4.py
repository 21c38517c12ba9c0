"""E5.4: A robot that flickers."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

RIGHT = {"node": "/scan_matcher", "edge": "map -> odom", "error": "nothing"}


BLAME_THE_WHEELS = WrongAnswer(
    "blame the wheels",
    {**RIGHT, "node": "/wheels"},
    Text(
        en="node: the wheels publish their own edge, as REP-105 has it. Who gives base_footprint a second parent?",
        ko="node: 바퀴는 REP-105대로 자기 연결을 발행합니다. base_footprint에 두 번째 부모를 주는 것은 누구입니까?",
    ),
    "M7",
    part="node",
)

BLAME_THE_BODY = WrongAnswer(
    "blame the body",
    {**RIGHT, "node": "/robot_state_publisher"},
    Text(
        en="node: one message a second on an edge of its own harms nobody. Look for a child with two parents.",
        ko="node: 자기 연결을 1초에 한 번 보내는 것은 문제가 없습니다. 부모가 둘인 자식을 찾아보세요.",
    ),
    part="node",
)

THE_TRUTH_ITSELF = WrongAnswer(
    "the truth itself",
    {**RIGHT, "edge": "map -> base_link"},
    Text(
        en="edge: base_link hangs below base_footprint already. It would have two parents again, one floor lower.",
        ko="edge: base_link는 이미 base_footprint 아래에 있습니다. 한 층 아래에서 다시 부모가 둘이 됩니다.",
    ),
    "M7",
    part="edge",
)

THE_WHEELS_EDGE = WrongAnswer(
    "the wheels' edge",
    {**RIGHT, "edge": "odom -> base_footprint"},
    Text(
        en="edge: that one has its owner. A second owner of one edge flickers too.",
        ko="edge: 그 연결의 발행 책임은 이미 바퀴에 있습니다. 한 연결을 둘이 발행해도 깜빡입니다.",
    ),
    "M6",
    part="edge",
)

SWITCH_IT_OFF = WrongAnswer(
    "switch it off",
    {**RIGHT, "edge": "none"},
    Text(
        en="edge: the node that gives a second parent could keep silent, and the flicker would end; but nobody would know where odom is on the map.",
        ko="edge: 두 번째 부모를 주는 노드가 조용해지면 깜빡임은 멈추지만, odom이 지도의 어디에 있는지 아무도 모르게 됩니다.",
    ),
    part="edge",
)

SURELY_AN_ERROR = WrongAnswer(
    "surely an error",
    {**RIGHT, "error": "ConnectivityException"},
    Text(
        en="error: that is what somebody hears who *asks* in the wrong half. The senders hear nothing: TF2 takes every edge as it comes.",
        ko="error: 하필 다른 절반에 *조회한* 쪽이 듣는 오류입니다. 발행한 쪽은 아무 말도 듣지 못합니다. TF2는 들어오는 연결을 그대로 받습니다.",
    ),
    "M11",
    part="error",
)

SURELY_A_LOOKUP_ERROR = WrongAnswer(
    "surely a lookup error",
    {**RIGHT, "error": "LookupException"},
    Text(
        en="error: all frames are known all the time, and sending raises nothing.",
        ko="error: 좌표계는 모두 알려져 있고, 발행할 때는 오류가 나지 않습니다.",
    ),
    "M11",
    part="error",
)


TASK = Task(
    id="E5.4",
    kind="D",
    points=3,
    title=Text(en="A robot that flickers", ko="깜빡이는 로봇"),
    answer="finding",
    form=Parts(
        {
            "node": Choice(("/wheels", "/scan_matcher", "/robot_state_publisher")),
            "edge": Choice(("map -> odom", "map -> base_link", "odom -> base_footprint", "none")),
            "error": Choice(("LookupException", "ConnectivityException", "nothing")),
        }
    ),
    mistakes=(
        BLAME_THE_WHEELS,
        BLAME_THE_BODY,
        THE_TRUTH_ITSELF,
        THE_WHEELS_EDGE,
        SWITCH_IT_OFF,
        SURELY_AN_ERROR,
        SURELY_A_LOOKUP_ERROR,
    ),
    hints=(
        Text(en="Find the child that stands in two rows with two parents.", ko="부모가 둘인 자식을 표에서 찾아보세요."),
        Text(
            en="The wheels keep their edge. What is missing above odom?",
            ko="바퀴의 연결은 그대로 둡니다. odom 위에 빠진 것은 무엇입니까?",
        ),
        Text(
            en="Does TF2 check anything when a transform is *sent*?",
            ko="변환을 *발행할* 때 TF2가 무언가 확인합니까?",
        ),
    ),
    misconceptions=("M6", "M7"),
)
