"""E12.2: Five terminals."""

from __future__ import annotations

import re

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongStep

from .draws import stored_patient

STATES = ("one owner", "nobody", "two owners", "another edge", "a misspelt parent")
NODES = ("wheel_odometry", "ekf_filter_node", "localization", "laser_mount", "none")
CURES = (
    "leave it as it is",
    "start wheel_odometry",
    "ekf_filter_node: publish_tf false",
    "localization: send map -> odom",
    "wheel_odometry: parent odom",
)
TERMINALS = {
    "one owner": "nothing is wrong",
    "nobody": "odometry not running",
    "two owners": "two owners of one edge",
    "another edge": "localizer owns the base",
    "a misspelt parent": "parent misspelt",
}
NODE_OF = dict(
    zip(TERMINALS, ("none", "wheel_odometry", "ekf_filter_node", "localization", "wheel_odometry"), strict=True)
)
CURE_OF = dict(zip(TERMINALS, CURES, strict=True))
PLACES = "abcde"
LINES = 19  # of a reading
# What each terminal shows, the same of all five, or the questions would tell what the answers should.
COUNT = r"^(?:Type|Publisher count|Subscription count): .*"
MOVING = r"(?:odom|base_footprint): \\n(?:  \S+: \S+?\\n)+"


def five(rng):
    """Draw five robots, run their tools, and put what they print into any order."""
    shown = [_shown(stored_patient(rng, cause)) for cause in TERMINALS.values()]
    return {place: shown[int(number)] for place, number in zip(PLACES, rng.permutation(len(shown)), strict=True)}


def _shown(patient):
    def read(check):
        return patient.reading(check)[1]

    echoed = re.sub(
        r"\n- Rotation.*?(?=\nAt time|\nFailure|\n\[|\Z)", "", read("echo odom base_footprint"), flags=re.DOTALL
    )
    echoed = re.sub(r"(?s)\nThe current list of frames is:.*?(?=\nAt time|\nFailure|\Z)", "", echoed)
    readings = {
        "ros2 node list": read("node list"),
        "ros2 topic info /tf": "\n".join(re.findall(COUNT, read("info /tf"), re.MULTILINE)),
        "ros2 run tf2_ros tf2_echo odom base_footprint 20": "\n".join(echoed.splitlines()[:LINES]),
        "ros2 run tf2_tools view_frames   (odom and base_footprint of it)": "\n".join(
            found.replace("\\n", "\n").rstrip() for found in sorted(re.findall(MOVING, read("view_frames")))
        ),
    }
    return "\n".join(f"$ {command}\n{text}" for command, text in readings.items())


def state_of(text):
    """Return what a terminal shows."""
    if "Failure at" in text:
        return "another edge"
    if "wheel_odometry" not in text:
        return "nobody"
    if "ekf_filter_node" in text:
        return "two owners"
    return "one owner" if re.search(r"base_footprint: *\n +parent: 'odom'", text) else "a misspelt parent"


def told(given, *, odm="misspelt", calm="one", count="endpoints", another="another edge", nobody="nobody"):
    """Return state, node and cure of each terminal, step by step; other steps are the slips."""
    answers = {}
    for place in PLACES:
        state = seen = state_of(getattr(given, place))
        node, cure = NODE_OF[state], CURE_OF[state]
        if state == "a misspelt parent" and odm == "node down":
            state, cure = "nobody", "start wheel_odometry"
        if state == "two owners" and calm == "healthy":
            state, node, cure = "one owner", "none", "leave it as it is"
        if state == "one owner" and count == "owners" and node == "none":
            state, node, cure = "two owners", "ekf_filter_node", "ekf_filter_node: publish_tf false"
        if state == "another edge" and another == "two owners":
            state = "two owners"
        if seen == "nobody" and nobody == "switch":
            node, cure = "localization", "localization: send map -> odom"
        answers |= {f"{place} state": state, f"{place} node": node, f"{place} cure": cure}
    return answers


MISSPELT_AS_DOWN = WrongStep(
    "misspelt read as down",
    {"odm": "node down"},
    Text(
        en="A frame is not connected there, and the node runs and sends. Read the roots of the tree: one of them nobody ever meant.",
        ko="좌표계가 이어지지 않았을 뿐, 노드는 실행 중이고 보내고 있습니다. 트리의 루트를 읽어 보세요. 아무도 뜻하지 않은 이름이 하나 있습니다.",
    ),
    "M11",
)

TWO_AS_HEALTHY = WrongStep(
    "two owners taken for healthy",
    {"calm": "healthy"},
    Text(
        en="No error is no health. Read the translations one after the other: no robot drives like that.",
        ko="오류가 없다고 건강한 것은 아닙니다. Translation을 차례로 읽어 보세요. 그렇게 달리는 로봇은 없습니다.",
    ),
    "M6",
)

COUNT_AS_OWNERS = WrongStep(
    "count taken for owners",
    {"count": "owners"},
    Text(
        en="`topic info /tf` counts whoever may speak on /tf, for all edges together. Three publishers may be three nodes with edges of their own.",
        ko="`topic info /tf`는 /tf로 보낼 수 있는 노드를 모든 연결에 걸쳐 셉니다. 발행자 셋은 연결을 하나씩 맡은 노드 셋입니다.",
    ),
    "M6",
)

ANOTHER_AS_TWO = WrongStep(
    "another edge taken for two owners",
    {"another": "two owners"},
    Text(
        en="Two owners of *one* edge never tear the tree apart. Here the question itself fails by turns: a child changes its parent.",
        ko="*한* 연결의 발행자가 둘이어도 트리가 끊어지지는 않습니다. 여기서는 질문 자체가 번갈아 실패합니다. 자식의 부모가 바뀌는 것입니다.",
    ),
    "M7",
)

WRONG_ONE_BLAMED = WrongStep(
    "localiser blamed",
    {"nobody": "switch"},
    Text(
        en="Compare the list of nodes with the card: who of them should send odom → base_footprint, and is not there?",
        ko="노드 목록을 카드와 견주어 보세요. odom → base_footprint를 보내야 하는데 없는 것은 누구입니까?",
    ),
    "M7",
)


TASK = Task(
    id="E12.2",
    kind="D",
    points=4,
    title=Text(en="Five terminals", ko="터미널 다섯 개"),
    answer="terminals",
    form=Parts(
        {
            f"{place} {what}": Choice(options)
            for place in PLACES
            for what, options in (("state", STATES), ("node", NODES), ("cure", CURES))
        }
    ),
    given=five,
    variants=3,
    is_costly=True,
    model=told,
    mistakes=(MISSPELT_AS_DOWN, TWO_AS_HEALTHY, COUNT_AS_OWNERS, ANOTHER_AS_TWO, WRONG_ONE_BLAMED),
    means={
        "one owner": Text(
            en="With one owner the values run smoothly, and every node on /tf has an edge of its own.",
            ko="발행자가 하나면 값이 매끄럽게 이어지고, /tf의 노드마다 자기 연결이 있습니다.",
        ),
        "nobody": Text(
            en="With nobody the edge never comes, and a name of the card is missing from the list of nodes.",
            ko="아무도 발행하지 않으면 연결이 오지 않고, 노드 목록에 카드의 이름 하나가 없습니다.",
        ),
        "two owners": Text(
            en="With two owners of one edge every question is answered, and the values go to and fro.",
            ko="한 연결의 발행자가 둘이면 물을 때마다 답이 나오고 값이 오락가락합니다.",
        ),
        "another edge": Text(
            en="Where another edge is sent to the child, the question fails by turns: the child changes its parent.",
            ko="자식에게 다른 연결이 오면 질문이 번갈아 실패합니다. 자식의 부모가 바뀌기 때문입니다.",
        ),
        "a misspelt parent": Text(
            en="Where a parent is misspelt, the tree has a root whose name is on no card.",
            ko="부모 이름이 틀리면 트리에 카드에 없는 이름의 루트가 있습니다.",
        ),
        "wheel_odometry": Text(
            en="It owns odom -> base_footprint on the card. Does it run, and does it send just that?",
            ko="카드에서 odom -> base_footprint의 발행자입니다. 실행 중이고 바로 그 연결을 보냅니까?",
        ),
        "ekf_filter_node": Text(
            en="It is on no card. Does anything here show that it runs?",
            ko="카드에 없는 노드입니다. 실행 중이라는 흔적이 여기 있습니까?",
        ),
        "localization": Text(
            en="It owns map -> odom. Does that edge come here?",
            ko="map -> odom의 발행자입니다. 그 연결이 여기서 옵니까?",
        ),
        "laser_mount": Text(
            en="It owns base_link -> laser_frame. Nothing in these terminals is about that edge.",
            ko="base_link -> laser_frame의 발행자입니다. 이 터미널들에는 그 연결의 이야기가 없습니다.",
        ),
        "none": Text(
            en="Then every node does what the card says.",
            ko="그렇다면 모든 노드가 카드대로 하고 있어야 합니다.",
        ),
        "leave it as it is": Text(
            en="That would be right for a robot on which nothing is wrong.",
            ko="이상이 없는 로봇에 맞는 답입니다.",
        ),
        "start wheel_odometry": Text(
            en="That cures a node that is not there. Is it missing from the list?",
            ko="없는 노드를 켜는 처치입니다. 목록에 없습니까?",
        ),
        "ekf_filter_node: publish_tf false": Text(
            en="That silences a second owner. Do two nodes send one edge here?",
            ko="두 번째 발행자를 조용하게 하는 처치입니다. 여기서 두 노드가 한 연결을 보냅니까?",
        ),
        "localization: send map -> odom": Text(
            en="That cures a localiser that sends another edge than its own. Is map -> odom gone here?",
            ko="자기 연결이 아닌 것을 보내는 위치 추정 노드를 고치는 처치입니다. 여기서 map -> odom이 사라졌습니까?",
        ),
        "wheel_odometry: parent odom": Text(
            en="That cures a name. Is there a root here that nobody meant?",
            ko="이름을 고치는 처치입니다. 아무도 뜻하지 않은 루트가 여기 있습니까?",
        ),
    },
    seen={
        "one owner": Text(
            en="Here each answer follows from the one before, and the nodes on /tf are those of the card. A first line that says Invalid frame ID is printed by every healthy robot, too, until its first message has come.",
            ko="여기서는 값이 매끄럽게 이어지고, /tf의 노드는 카드에 있는 그대로입니다. 첫 줄의 Invalid frame ID는 건강한 로봇에서도 첫 메시지가 올 때까지 나옵니다.",
        ),
        "nobody": Text(
            en="Here no answer ever comes, and the list of nodes is one short of the card.",
            ko="여기서는 답이 한 번도 나오지 않고, 노드 목록에 카드의 노드 하나가 없습니다.",
        ),
        "two owners": Text(
            en="Here answers come one after the other, and the robot is now in one place and now in another.",
            ko="여기서는 답이 잇달아 나오지만 로봇의 위치가 이곳저곳으로 오락가락합니다.",
        ),
        "another edge": Text(
            en="Here answers and failures take turns, of the same question.",
            ko="여기서는 같은 질문에 답이 나오다 말다 합니다.",
        ),
        "a misspelt parent": Text(
            en="Here the edge comes, and hangs below a root that stands on no card.",
            ko="여기서는 연결이 오는데, 카드에 없는 루트 아래에 있습니다.",
        ),
        "wheel_odometry": Text(
            en="Here the edge below odom, which the card gives to one node, does not come as the card has it.",
            ko="여기서는 카드에서 한 노드가 맡은 odom 아래의 연결이 카드대로 오지 않습니다.",
        ),
        "ekf_filter_node": Text(
            en="Here somebody who is on no card sends as well.",
            ko="여기서는 카드에 없는 누군가도 함께 보냅니다.",
        ),
        "localization": Text(
            en="Here map -> odom does not come, and base_footprint hangs now on this frame, now on that.",
            ko="여기서는 map -> odom이 오지 않고, base_footprint가 이 좌표계에 달렸다가 저 좌표계에 달렸다가 합니다.",
        ),
        "none": Text(
            en="Here everything is as the card has it.",
            ko="여기서는 모든 것이 카드대로입니다.",
        ),
        "leave it as it is": Text(
            en="Here nothing differs from the card.",
            ko="여기서는 카드와 다른 것이 없습니다.",
        ),
        "start wheel_odometry": Text(
            en="Here a node of the card does not run at all.",
            ko="여기서는 카드에 있는 노드 하나가 아예 실행되지 않습니다.",
        ),
        "ekf_filter_node: publish_tf false": Text(
            en="Here two send the same edge.",
            ko="여기서는 둘이 같은 연결을 보냅니다.",
        ),
        "localization: send map -> odom": Text(
            en="Here a node sends an edge that is not its own.",
            ko="여기서는 한 노드가 자기 것이 아닌 연결을 보냅니다.",
        ),
        "wheel_odometry: parent odom": Text(
            en="Here the edge is sent, and the name of its parent is not the card's.",
            ko="여기서는 연결이 오지만 부모의 이름이 카드와 다릅니다.",
        ),
    },
    hints=(
        Text(
            en="Which edge is it about? Then: does it come, from whom, and is it the same edge each time?",
            ko="어느 연결의 이야기입니까? 그 연결이 옵니까, 누구에게서 옵니까, 올 때마다 같은 연결입니까?",
        ),
        Text(
            en="Read numbers in their order, roots by their names, and lists against the card.",
            ko="숫자는 차례로, 루트는 이름을, 목록은 카드와 견주어 읽으십시오.",
        ),
        Text(
            en="To and fro: two owners. Answers by turns: another edge. A root on no card: misspelt. A name missing from the list: nobody.",
            ko="오락가락하면 발행자가 둘, 답이 나오다 말다 하면 다른 연결, 카드에 없는 루트면 틀린 이름, 목록에 이름이 없으면 아무도 없는 것입니다.",
        ),
    ),
    misconceptions=("M6", "M7", "M11"),
)
