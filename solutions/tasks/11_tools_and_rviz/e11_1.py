"""E11.1: Which tool for which question?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

TOOLS = (
    "view_frames", "tf2_echo", "tf2_monitor", "topic hz", "topic delay", "topic info --verbose", "RViz",
    "no ROS 2 tool",
)  # fmt: skip

RIGHT = {
    "trees": "view_frames",
    "edge rate": "view_frames",
    "height": "tf2_echo",
    "chain": "tf2_monitor",
    "scan": "topic delay",
    "on tf": "topic info --verbose",
    "sender": "no ROS 2 tool",
    "wall": "RViz",
}


def but(**tools):
    return {**RIGHT, **{part.replace("_", " "): tool for part, tool in tools.items()}}


OWNER_FROM_MONITOR = WrongAnswer(
    "owner from monitor",
    but(sender="tf2_monitor"),
    Text(
        en="sender: tf2_monitor prints <no authority available> for everybody. ROS 1's had the name; a ROS 2 message does not carry it.",
        ko="sender: tf2_monitor는 누구에게나 <no authority available>을 출력합니다. ROS 1에는 이름이 있었지만 ROS 2 메시지에는 없습니다.",
    ),
    "M6",
)

OWNER_FROM_VIEW_FRAMES = WrongAnswer(
    "owner from view_frames",
    but(sender="view_frames"),
    Text(
        en="sender: its Broadcaster line says default_authority for every edge.",
        ko="sender: Broadcaster 줄은 모든 연결에서 default_authority입니다.",
    ),
    "M6",
)

OWNER_FROM_INFO = WrongAnswer(
    "owner from info",
    but(sender="topic info --verbose"),
    Text(
        en="sender: it names who publishes on /tf. On the page those were three nodes: which of them sends this one edge, it did not say.",
        ko="sender: /tf에 발행하는 노드를 알려 줍니다. 이 장의 로봇에서는 셋이었고, 그중 누가 이 연결을 보내는지는 나오지 않았습니다.",
    ),
    "M6",
)

NOBODY_KNOWS_THE_TOPIC = WrongAnswer(
    "nobody knows the topic",
    but(on_tf="no ROS 2 tool"),
    Text(
        en="on tf: who sends *one edge* nobody says; who publishes on *a topic* somebody does.",
        ko="on tf: *연결 하나*를 누가 보내는지는 아무도 알려 주지 않지만, *토픽*에 누가 발행하는지는 알려 주는 도구가 있습니다.",
    ),
)

RATE_FROM_HZ = WrongAnswer(
    "rate from hz",
    but(edge_rate="topic hz"),
    Text(
        en="edge rate: topic hz counts everybody on /tf, 20 + 20 + 10 on the page. Asked is one edge.",
        ko="edge rate: topic hz는 /tf의 모두를 셉니다. 이 장에서는 20 + 20 + 10이었습니다. 연결 하나의 발행률을 물었습니다.",
    ),
)

RATE_FROM_MONITOR = WrongAnswer(
    "rate from monitor",
    but(edge_rate="tf2_monitor"),
    Text(
        en="edge rate: tf2_monitor's Hz stands below All Broadcasters, and means all of them.",
        ko="edge rate: tf2_monitor의 Hz는 All Broadcasters 아래에 있고, 모두를 합친 값입니다.",
    ),
)

SCAN_FROM_MONITOR = WrongAnswer(
    "scan from monitor",
    but(scan="tf2_monitor"),
    Text(
        en="scan: tf2_monitor listens to /tf and /tf_static. It never sees a scan.",
        ko="scan: tf2_monitor는 /tf와 /tf_static만 듣습니다. 스캔은 보지 않습니다.",
    ),
)

CHAIN_FROM_DELAY = WrongAnswer(
    "chain from delay",
    but(chain="topic delay"),
    Text(
        en="chain: topic delay needs a header, and /tf's message has none of its own: `msg does not have header`.",
        ko="chain: topic delay에는 헤더가 필요한데 /tf 메시지에는 헤더가 없습니다. `msg does not have header`가 나옵니다.",
    ),
)

RVIZ_FIRST = WrongAnswer(
    "RViz first",
    dict.fromkeys(RIGHT, "RViz"),
    Text(
        en="RViz for everything: it shows the result of all of it at once, to the eye. Ask what exactly you want to know: a name, a value, a time, a node?",
        ko="모든 질문에 RViz라고 답했습니다. RViz는 모든 것의 결과를 한꺼번에 눈에 보여 줍니다. 정확히 무엇을 알고 싶은지 물어보세요. 이름입니까, 값입니까, 시각입니까, 노드입니까?",
    ),
    "M15",
)


TASK = Task(
    id="E11.1",
    kind="M",
    points=3,
    title=Text(en="Which tool for which question?", ko="어떤 질문에 어떤 도구를 씁니까?"),
    answer="tools",
    form=Parts({part: Choice(TOOLS) for part in RIGHT}),
    mistakes=(
        OWNER_FROM_MONITOR,
        OWNER_FROM_VIEW_FRAMES,
        OWNER_FROM_INFO,
        NOBODY_KNOWS_THE_TOPIC,
        RATE_FROM_HZ,
        RATE_FROM_MONITOR,
        SCAN_FROM_MONITOR,
        CHAIN_FROM_DELAY,
        RVIZ_FIRST,
    ),
    means={
        "view_frames": Text(
            en="view_frames knows frames, parents, and each edge's rate and ages, over five seconds; no values and no nodes.",
            ko="view_frames는 5초 동안의 좌표계, 부모, 연결마다의 발행률과 시각을 압니다. 값과 노드는 모릅니다.",
        ),
        "tf2_echo": Text(
            en="tf2_echo knows the value of one pair; nothing of other frames, of how often, or of messages.",
            ko="tf2_echo는 한 쌍의 값을 압니다. 다른 좌표계도, 얼마나 자주 오는지도, 메시지도 모릅니다.",
        ),
        "tf2_monitor": Text(
            en="tf2_monitor knows how late transforms are; no values, no messages, no nodes.",
            ko="tf2_monitor는 변환이 얼마나 늦는지 압니다. 값도 메시지도 노드도 모릅니다.",
        ),
        "topic hz": Text(
            en="topic hz counts the messages of a whole topic and opens none.",
            ko="topic hz는 토픽 전체의 메시지를 세기만 하고 열지 않습니다.",
        ),
        "topic delay": Text(
            en="topic delay subtracts the header's stamp from now, for a topic that has a header.",
            ko="topic delay는 헤더가 있는 토픽에서 현재 시각과 측정 시각의 차이를 구합니다.",
        ),
        "topic info --verbose": Text(
            en="topic info --verbose knows who publishes and subscribes; it looks into no message.",
            ko="topic info --verbose는 누가 발행하고 구독하는지 압니다. 메시지 안은 보지 않습니다.",
        ),
        "RViz": Text(
            en="RViz shows to the eye what could be computed, all of it from its Fixed Frame; on the page it gave no root, no value, no rate and no node.",
            ko="RViz는 계산할 수 있었던 것을 Fixed Frame 기준으로 눈에 보여 줍니다. 이 장의 RViz에는 루트, 값, 발행률, 노드가 나오지 않았습니다.",
        ),
        "no ROS 2 tool": Text(
            en="for this one there is a tool: its answer is printed on the page.",
            ko="이 질문에 답하는 도구가 있습니다. 본문에 그 출력이 있습니다.",
        ),
    },
    hints=(
        Text(
            en="For each question: do I want a name, a value, a time, a node, or a look?",
            ko="질문마다 알고 싶은 것이 이름입니까, 값입니까, 시각입니까, 노드입니까, 모습입니까?",
        ),
        Text(
            en="Where a topic is shared by several nodes, what does counting its messages tell of one edge?",
            ko="여러 노드가 함께 쓰는 토픽의 메시지를 세면 연결 하나에 대해 무엇을 알 수 있습니까?",
        ),
        Text(
            en="In the page's table, look for the row without a ✓, and for the tool that answers two rows.",
            ko="본문의 표에서 ✓가 없는 행과, ✓가 둘인 도구를 찾아보세요.",
        ),
    ),
    misconceptions=("M6", "M15"),
)
