"""E4.1: One letter too few."""

from __future__ import annotations

from difflib import get_close_matches

from tflab.workbook.tasks import Task, Text, Tree, WrongAnswer, WrongStep

from .draws import robot, typo


def misspelt(rng):
    """One edge whose parent lacks a letter; the parent has other edges under its right name, one above it at least."""
    tree = robot(rng)
    child = str(rng.choice([child for child, parent in tree.items() if parent != "map"]))
    wrong = typo(rng, tree[child])
    while wrong in tree:
        wrong = typo(rng, tree[child])
    return {"edges": [(wrong if each == child else parent, each) for each, parent in tree.items()]}


def names(given):
    tree = {child: parent for parent, child in given.edges}
    (wrong,) = set(tree.values()) - set(tree) - {"map"}
    return tree, wrong, get_close_matches(wrong, tree, n=1)[0]


def built(given, *, fault="mended", way="child -> parent"):
    """Return the tree, step by step; other steps are the slips."""
    tree, wrong, meant = names(given)
    swap = {"mended": (wrong, meant), "at the top": (wrong, "map")}.get(fault)
    if swap:
        tree = {child: swap[1] if parent == swap[0] else parent for child, parent in tree.items()}
    elif fault in ("bridged", "bridged at the top"):
        tree = {**tree, wrong: meant if fault == "bridged" else "map"}
    elif fault == "below the typo":
        tree = {**tree, meant: wrong}
    elif fault == "left out":
        tree = {child: parent for child, parent in tree.items() if parent != wrong}
    elif fault == "renamed":
        tree = {wrong if c == meant else c: wrong if p == meant else p for c, p in tree.items()}
    return {parent: child for child, parent in tree.items()} if way == "parent -> child" else tree


UNCHANGED = WrongStep(
    "unchanged",
    {"fault": "left"},
    Text(
        en="The fault is still in there. Collect the parents that are nobody's child: one of the two is no root but a typo. If you look for the name that is most like the typo, look among the others: every word is most like itself.",
        ko="고장이 그대로 있습니다. 누구의 자식도 아닌 부모를 모아 보세요. 둘 가운데 하나는 루트가 아니라 오타입니다. 오타와 가장 비슷한 이름을 찾을 때는 오타를 후보에서 빼십시오. 어떤 이름이든 자기 자신과 가장 비슷합니다.",
    ),
    "M14",
)

BRIDGED = WrongStep(
    "bridged",
    {"fault": "bridged"},
    Text(
        en="A bridge from the right name to the misspelt one: the plaster of the page. One place has two names now. Mend the name itself.",
        ko="맞는 이름과 틀린 이름을 잇는 다리를 놓았습니다. 본문의 반창고입니다. 한 자리에 이름이 둘이 됩니다. 이름 자체를 고치십시오.",
    ),
    "M14",
)

RENAMED = WrongStep(
    "renamed to the typo",
    {"fault": "renamed"},
    Text(
        en="You renamed the right name, everywhere, to the misspelt one. Whoever else sends or asks knows the other.",
        ko="맞는 이름을 모두 틀린 이름으로 바꿨습니다. 다른 노드들이 보내고 묻는 이름은 그것이 아닙니다.",
    ),
    "M14",
)

AT_THE_TOP = WrongStep(
    "hung at the top",
    {"fault": "at the top"},
    Text(
        en="You hung the lost part below map. It is one tree again, but the part no longer moves with what carries it.",
        ko="떨어진 부분을 map 아래에 매달았습니다. 트리는 하나가 되지만, 그 부분이 자기를 싣고 다니는 것과 함께 움직이지 않습니다.",
    ),
)

UPSIDE_DOWN = WrongStep(
    "upside down",
    {"way": "parent -> child"},
    Text(
        en="That is parent → child. A key has one value: whoever has several children would keep one. Asked for is child → parent.",
        ko="부모 → 자식으로 썼습니다. 키에는 값이 하나이므로 자식이 여럿이면 하나만 남습니다. 자식 → 부모로 써야 합니다.",
    ),
    "M2",
)

ONLY_THE_EDGE = WrongAnswer(
    "only the edge",
    lambda given: dict([next((c, names(given)[2]) for p, c in given.edges if p == names(given)[1])]),
    Text(
        en="The edge is mended, and the others are missing: give the whole tree.",
        ko="고친 연결은 맞지만 나머지가 빠졌습니다. 트리 전체를 답하십시오.",
    ),
)

BRIDGED_AT_THE_TOP = WrongStep(
    "bridged at the top",
    {"fault": "bridged at the top"},
    Text(
        en="The misspelt frame has a parent now, map, and is still a frame that nobody has. One name has to be mended, and no edge added.",
        ko="잘못 적힌 좌표계에 map이라는 부모를 붙였지만, 그 좌표계는 실제로 없습니다. 연결을 더하지 말고 이름 하나를 고치십시오.",
    ),
    "M14",
)

LEFT_OUT = WrongStep(
    "edge left out",
    {"fault": "left out"},
    Text(
        en="The edge with the misspelt name is gone, and with it the way up from its child. Mend the name, and keep the edge.",
        ko="이름이 잘못 적힌 연결을 빼 버려서, 그 자식에서 위로 가는 길이 없어졌습니다. 연결은 두고 이름을 고치십시오.",
    ),
)


RIGHT_NAME_BELOW_THE_TYPO = WrongStep(
    "right name below the typo",
    {"fault": "below the typo"},
    Text(
        en="You hung the right name below the misspelt one. Both are one place: mend the name, and no edge is needed.",
        ko="맞는 이름을 틀린 이름 아래에 달았습니다. 둘은 같은 곳입니다. 이름을 고치면 연결은 더 필요 없습니다.",
    ),
    "M14",
)


A_PARENT_FOR_MAP = WrongAnswer(
    "a parent for map",
    lambda given: {**built(given), "map": "world"},
    Text(
        en="map has a parent now, and it is the root: nothing stands above it.",
        ko="map에 부모가 생겼습니다. map은 루트이므로 위에 아무것도 없습니다.",
    ),
)


ALL_BELOW_ONE = WrongAnswer(
    "all below one",
    lambda given: dict.fromkeys(built(given), names(given)[2]),
    Text(
        en="All frames hang below one. Only the misspelt name is to be mended; every other edge stays as it was heard.",
        ko="모든 좌표계를 하나 아래에 달았습니다. 틀린 이름만 고치고 나머지 연결은 들은 그대로 두십시오.",
    ),
)


THE_MENDING_ALONE = WrongAnswer(
    "the mending alone",
    lambda given: {names(given)[1]: names(given)[2]},
    Text(
        en="That says which name is meant by which, and is no tree: asked for are all edges, child → parent, with that parent mended.",
        ko="어느 이름이 어느 이름이어야 하는지만 있고 트리는 없습니다. 그 부모를 고친 모든 연결을 자식 → 부모로 쓰십시오.",
    ),
    "M14",
)


THE_MENDING_TURNED = WrongAnswer(
    "the mending turned round",
    lambda given: {names(given)[2]: names(given)[1]},
    Text(
        en="That sets the right name below the misspelt one, and is no tree: asked for are all edges, child → parent, with that parent mended.",
        ko="맞는 이름을 오타 밑에 두었을 뿐 트리가 아닙니다. 그 부모를 고친 모든 연결을 자식 → 부모로 쓰십시오.",
    ),
    "M14",
)


TASK = Task(
    id="E4.1",
    kind="T",
    points=3,
    title=Text(en="One letter too few", ko="한 글자가 모자랍니다"),
    answer="mended",
    form=Tree(),
    given=misspelt,
    variants=8,
    model=built,
    mistakes=(
        UNCHANGED,
        BRIDGED,
        RENAMED,
        AT_THE_TOP,
        UPSIDE_DOWN,
        ONLY_THE_EDGE,
        BRIDGED_AT_THE_TOP,
        LEFT_OUT,
        RIGHT_NAME_BELOW_THE_TYPO,
        A_PARENT_FOR_MAP,
        ALL_BELOW_ONE,
        THE_MENDING_ALONE,
        THE_MENDING_TURNED,
    ),
    hints=(
        Text(en="Which parents are nobody's child?", ko="누구의 자식도 아닌 부모는 무엇입니까?"),
        Text(
            en="There are two. One is map; which name of the list does the other resemble?",
            ko="둘입니다. 하나는 map입니다. 다른 하나는 목록의 어느 이름과 닮았습니까?",
        ),
        Text(
            en="`{child: parent for parent, child in e4_1.edges}` is the tree as told; then put the right name in one place.",
            ko="`{child: parent for parent, child in e4_1.edges}`가 들은 그대로의 트리입니다. 그다음 한 곳의 이름을 바로잡으십시오.",
        ),
    ),
    misconceptions=("M2", "M14"),
)
