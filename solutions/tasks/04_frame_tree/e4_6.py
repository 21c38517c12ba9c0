"""E4.6: Who has several owners?"""

from __future__ import annotations

from itertools import pairwise

from tflab.workbook.tasks import Name, Sequence, Task, Text, WrongAnswer, WrongStep

from .draws import robot, sender


def logs(rng):
    """Healthy logs, repeats, two owners, two parents, one base name in two namespaces, three owners."""
    rows = []
    for _ in range(2):
        tree = robot(rng)
        healthy = [(sender(child), parent, child) for child, parent in tree.items()]
        names = [str(name) for name in rng.permutation([child for child in tree if child != "odom"])]
        twice = [("/ekf_filter_node", tree[names[0]], names[0])]
        moved = [("/calibration", "odom" if tree[names[1]] != "odom" else "map", names[1])]
        spaces = [("/robot1/driver", "base_link", "lamp"), ("/robot2/driver", "base_link", "lamp")]
        same_node = [("/robot_state_publisher", "odom", "plate"), ("/robot_state_publisher", "map", "plate")]
        everything = [*healthy, *healthy, *twice, *moved, *spaces, *same_node, *twice]
        rows += [
            [],
            healthy * 2,
            [*healthy, *twice],
            [*moved, *healthy],
            [*healthy, *spaces],
            [*healthy, *same_node],
            [everything[int(number)] for number in rng.permutation(len(everything))],
            [*healthy, *spaces, ("/driver_a", "map", "door"), ("/driver_b", "map", "door")],
            [*healthy, *twice, ("/third", tree[names[0]], names[0])],
        ]
    return [(row,) for row in rows]


def neighbours(log):
    """Return the children of which two rows that follow one another have different nodes."""
    rows = pairwise(log)
    return sorted({child for (node, _, child), (other, _, same) in rows if child == same and node != other})


def counted(log, *, names="whole", key="child", what="nodes", least=2, order="sorted"):
    """Return the children with several owners, step by step; other steps are the slips."""
    seen = {}
    for node, parent, child in log:
        who = node.rpartition("/")[2] if names == "base" else node
        who = {"nodes and parents": (node, parent), "parents": parent}.get(what, who)
        seen.setdefault(child if key == "child" else (parent, child), []).append(who)
    counts = {of: len(who) if what == "messages" else len(set(who)) for of, who in seen.items()}
    many = [of for of, count in counts.items() if (count == 2 if least == "just two" else count >= least)]
    many = list(dict.fromkeys(of if key == "child" else of[1] for of in many))
    if order == "the first found":
        return _earliest(log, many)
    if order == "the first by name":
        return sorted(many)[:1]
    return sorted(many) if order == "sorted" else many


def _earliest(log, many):
    """Return of these children the one of which a second node is heard first."""
    nodes = {}
    for node, _, child in log:
        nodes.setdefault(child, set()).add(node)
        if child in many and len(nodes[child]) == 2:
            return [child]
    return many[:1]


MESSAGES = WrongStep(
    "counts messages",
    {"what": "messages"},
    Text(
        en="You count messages. A node that says the same twice is still one owner: count different nodes.",
        ko="메시지를 셉니다. 한 노드가 두 번 발행해도 발행 책임은 하나입니다. 서로 다른 노드를 세십시오.",
    ),
    "M6",
)

EDGES = WrongStep(
    "counts by edge",
    {"key": "edge"},
    Text(
        en="A child that two nodes hang below two parents slips through, as it does where one counts by edge, parent and child together. It has two owners as well: count by child.",
        ko="두 노드가 한 자식에게 서로 다른 부모를 주면 빠져나갑니다. 부모와 자식을 묶은 연결마다 셀 때 그렇습니다. 그런 자식도 발행하는 노드가 둘입니다. 자식마다 세십시오.",
    ),
    "M6",
)

BASE_NAMES = WrongStep(
    "base names",
    {"names": "base"},
    Text(
        en="You cut the namespace off. /robot1/driver and /robot2/driver are two nodes.",
        ko="네임스페이스를 잘랐습니다. /robot1/driver와 /robot2/driver는 서로 다른 노드입니다.",
    ),
    "M14",
)

THREE = WrongStep(
    "more than two",
    {"least": 3},
    Text(en="Two are several already.", ko="둘이면 이미 여럿입니다."),
)

UNSORTED = WrongStep(
    "unsorted",
    {"order": "as heard"},
    Text(
        en="The right children, in another order than asked for: sort them by name.",
        ko="자식은 맞지만 순서가 다릅니다. 이름 순서로 정렬하십시오.",
    ),
)

ALL = WrongAnswer(
    "all children",
    lambda log: sorted({child for _, _, child in log}),
    Text(
        en="These are all children. Only those with two nodes or more are asked for.",
        ko="모든 자식입니다. 둘 이상의 노드가 보내는 것만 골라야 합니다.",
    ),
)

NODES = WrongAnswer(
    "nodes",
    lambda log: sorted({node for node, _, child in log if len({n for n, _, c in log if c == child}) > 1}),
    Text(
        en="These are the nodes. Asked for are the children that they quarrel about.",
        ko="노드의 이름입니다. 두 노드가 다투는 자식의 이름이 필요합니다.",
    ),
    "M2",
)

PARENTS = WrongStep(
    "two parents only",
    {"what": "parents"},
    Text(
        en="You look for children with two parents. Two nodes may give the same parent, and quarrel about the numbers.",
        ko="부모가 둘인 자식을 찾습니다. 두 노드가 같은 부모를 주면서 값을 두고 다툴 수도 있습니다.",
    ),
    "M6",
)

BY_PARENT = WrongAnswer(
    "by parent",
    lambda log: sorted({parent for _, parent, _ in log if len({n for n, p, _ in log if p == parent}) > 1}),
    Text(
        en="You collect the nodes of each parent. A parent may well have children of several nodes; what has one owner is a child.",
        ko="부모마다 노드를 모았습니다. 한 부모의 자식들은 여러 노드가 보내도 됩니다. 발행 책임은 자식마다 하나입니다.",
    ),
    "M2",
)

BUSY_NODES = WrongAnswer(
    "busy nodes",
    lambda log: sorted({node for node, _, _ in log if len({c for n, _, c in log if n == node}) > 1}),
    Text(
        en="These are nodes that send several children, which is nobody's fault. Asked for are children that several nodes send.",
        ko="자식을 여럿 보내는 노드입니다. 그것은 잘못이 아닙니다. 여러 노드가 보내는 자식을 찾으십시오.",
    ),
    "M6",
)


JUST_TWO = WrongStep(
    "just two",
    {"least": "just two"},
    Text(
        en="You look for just two nodes. Three owners are several as well.",
        ko="노드가 정확히 둘인 것만 찾습니다. 셋도 여럿입니다.",
    ),
)


NODES_AND_PARENTS = WrongStep(
    "nodes and parents",
    {"what": "nodes and parents"},
    Text(
        en="A child that one node hangs below two parents counts for you, too. One node that moves a child about is still one owner: count the nodes alone.",
        ko="노드 하나가 부모를 둘 말한 자식까지 들어갑니다. 자식을 옮겨 다녀도 노드 하나는 하나입니다. 노드만 세십시오.",
    ),
)


PARENTS_TOO = WrongAnswer(
    "parents",
    lambda log: sorted({parent for _, parent, child in log if len({n for n, _, c in log if c == child}) > 1}),
    Text(
        en="These are the parents. Asked for are the children that several nodes send.",
        ko="부모들입니다. 여러 노드가 보내는 자식이 필요합니다.",
    ),
)


NEIGHBOURS_ALONE = WrongAnswer(
    "neighbours alone",
    neighbours,
    Text(
        en="You compare each row only with the one before it. Two owners need not follow one another in the log: gather the nodes of each child first.",
        ko="각 줄을 바로 앞줄과만 비교합니다. 두 노드가 로그에 잇달아 나온다는 법은 없습니다. 자식마다 노드를 먼저 모으십시오.",
    ),
)


FIRST_FOUND_ALONE = WrongStep(
    "first found alone",
    {"order": "the first found"},
    Text(
        en="You return one child at most. There may be several: does your `return` stand inside the loop?",
        ko="많아야 자식 하나를 반환합니다. 여럿일 수 있습니다. `return`이 반복문 안에 있습니까?",
    ),
    "M6",
)


FIRST_BY_NAME_ALONE = WrongStep(
    "first by name alone",
    {"order": "the first by name"},
    Text(
        en="You return one child at most, the first by name. There may be several, and all of them are asked for.",
        ko="이름순으로 첫 자식 하나만 반환합니다. 여럿일 수 있고, 모두 필요합니다.",
    ),
    "M6",
)


TASK = Task(
    id="E4.6",
    kind="F",
    points=3,
    title=Text(en="Who has several owners?", ko="발행하는 노드가 여럿인 것은?"),
    answer="several_owners",
    form=Sequence(Name()),
    inputs=logs,
    variants=3,
    model=counted,
    mistakes=(
        MESSAGES,
        EDGES,
        BASE_NAMES,
        THREE,
        UNSORTED,
        ALL,
        NODES,
        PARENTS,
        BY_PARENT,
        BUSY_NODES,
        JUST_TWO,
        NODES_AND_PARENTS,
        PARENTS_TOO,
        NEIGHBOURS_ALONE,
        FIRST_FOUND_ALONE,
        FIRST_BY_NAME_ALONE,
    ),
    hints=(
        Text(en="For each child, collect who sends it.", ko="자식마다 누가 보내는지 모으십시오."),
        Text(en="A set keeps each node once.", ko="set에는 노드가 하나씩만 남습니다."),
        Text(
            en="`nodes.setdefault(child, set()).add(node)`; then those with more than one, sorted.",
            ko="`nodes.setdefault(child, set()).add(node)`로 모은 뒤, 둘 이상인 것을 정렬하십시오.",
        ),
    ),
    misconceptions=("M6",),
)
