"""E4.2: Five listings."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Name, Parts, Task, Text, WrongStep

from .draws import robot, sender, typo

KINDS = ("healthy", "two trees", "loop", "two parents", "two owners")
LETTERS = "abcde"
BESIDE = (("door_frame", "door_handle"), ("turntable", "workpiece"), ("lift_base", "lift_plate"))


def listings(rng):
    """Draw five robots, one of each kind, in an order of their own."""
    kinds = [str(kind) for kind in rng.permutation(KINDS)]
    return {letter: _listing(rng, kind) for letter, kind in zip(LETTERS, kinds, strict=True)}


def _listing(rng, kind):
    tree = robot(rng)
    rows = [(parent, child, sender(child)) for child, parent in tree.items()]
    # A sensor that carries nothing, so that who names its parent instead names another frame.
    leaf = str(rng.choice([child for child in tree if child not in tree.values()]))
    place = next(number for number, row in enumerate(rows) if row[1] == leaf)
    parent = rows[place][0]
    if kind == "two trees":
        rows[place] = (typo(rng, parent), leaf, rows[place][2])
    elif kind == "two parents":
        rows.append(("odom", leaf, "/calibration"))
    elif kind == "two owners":
        rows.append((parent, leaf, "/sensor_driver"))
    elif kind == "loop":
        one, other = BESIDE[int(rng.integers(len(BESIDE)))]
        rows += [(one, other, "/fixture"), (other, one, "/fixture")]
    return [rows[int(number)] for number in rng.permutation(len(rows))]


def diagnosed(given, *, loops="looked for", owners="counted", parents="counted", named="child"):
    """Return all five findings, step by step; other steps are the slips."""
    finding = {}
    for letter in LETTERS:
        rows = getattr(given, letter)
        kind, child = _kind(rows)
        parent = next((row[0] for row in rows if row[1] == child), "none")
        if kind == "loop" and loops != "looked for":
            kind, child = ("healthy" if loops == "roots only" else "two trees"), "none"
        if kind == "two owners" and owners != "counted":
            kind, child = owners, ("none" if owners == "healthy" else child)
        if kind == "two parents" and parents != "counted":
            kind, child = parents, ("none" if parents == "healthy" else child)
        finding[letter], finding[f"{letter} child"] = kind, parent if named == "parent" else child
    return finding


def _kind(rows):
    parents, nodes = {}, {}
    for parent, child, node in rows:
        parents.setdefault(child, set()).add(parent)
        nodes.setdefault(child, set()).add(node)
    for child in parents:
        if len(parents[child]) > 1:
            return "two parents", child
        if len(nodes[child]) > 1:
            return "two owners", child
    tree = {child: min(above) for child, above in parents.items()}
    if any(tree.get(tree.get(frame)) == frame for frame in tree):
        return "loop", "none"
    lost = [child for child, parent in tree.items() if parent not in tree and parent != "map"]
    return ("two trees", lost[0]) if lost else ("healthy", "none")


ROOTS_ONLY = WrongStep(
    "roots only",
    {"loops": "roots only"},
    Text(
        en="Counting roots does not show it: a loop beside a sound tree has none, and hides behind the one root of the other. Climb from each frame.",
        ko="루트를 세어서는 보이지 않습니다. 멀쩡한 트리 옆의 고리에는 루트가 없어서, 다른 트리의 루트 하나만 보입니다. 좌표계마다 위로 올라가 보십시오.",
    ),
)

LOOP_IS_A_TREE = WrongStep(
    "a loop is a tree",
    {"loops": "two trees"},
    Text(
        en="Two frames stand beside the tree, but they are no second tree: each is the other's parent, and neither is a root.",
        ko="트리 옆에 좌표계 둘이 따로 있지만 두 번째 트리는 아닙니다. 서로가 서로의 부모이고, 어느 쪽도 루트가 아닙니다.",
    ),
)

SAME_EDGE_TWICE = WrongStep(
    "the same edge twice is fine",
    {"owners": "healthy"},
    Text(
        en="The shape is fine there; read the nodes, too: an edge that two of them send goes to and fro.",
        ko="모양은 멀쩡합니다. 노드까지 읽어 보세요. 한 연결을 두 노드가 보내면 값이 오갑니다.",
    ),
    "M6",
)

OWNERS_ARE_PARENTS = WrongStep(
    "two owners are two parents",
    {"owners": "two parents"},
    Text(
        en="There are two nodes, and no two parents: one child stands in two rows with the *same* parent there.",
        ko="노드는 둘이지만 부모는 둘이 아닙니다. 그 목록에서 두 줄에 나오는 자식의 부모는 *같습니다*.",
    ),
    "M6",
)

PARENTS_ARE_OWNERS = WrongStep(
    "two parents are two owners",
    {"parents": "two owners"},
    Text(
        en="There are two nodes, but look at the parents in the two rows of that child: they differ, so the child changes its place in the tree.",
        ko="노드도 둘이지만, 그 자식이 나오는 두 줄의 부모를 보세요. 서로 다르므로 자식이 트리 안에서 자리를 옮깁니다.",
    ),
    "M6",
)

PARENTS_ARE_FINE = WrongStep(
    "two parents are fine",
    {"parents": "healthy"},
    Text(
        en="A child hangs below two parents there. tf2 will take both, by turns: that is no healthy tree.",
        ko="거기에는 두 부모 아래에 있는 자식이 하나 있습니다. tf2는 둘을 번갈아 받아들입니다. 멀쩡한 트리가 아닙니다.",
    ),
    "M6",
)

NAMED_THE_PARENT = WrongStep(
    "named the parent",
    {"named": "parent"},
    Text(
        en="You named the parent. What has two parents, two owners or a misspelt parent is the child of the row.",
        ko="부모의 이름을 썼습니다. 부모가 둘이거나, 노드가 둘이거나, 부모가 잘못 적힌 것은 그 줄의 자식입니다.",
    ),
    "M2",
    partly=True,
)

LOOK_AGAIN = Text(
    en="Write that listing down as a dict: which child is set twice, and is every parent somebody's child, or map?",
    ko="그 목록을 dict로 적어 보세요. 두 번 쓰이는 자식이 있습니까? 부모는 모두 map이거나 누군가의 자식입니까?",
)
WHO = Text(
    en="For a healthy robot and for a loop write none; everywhere else the child that is meant stands second in its row.",
    ko="멀쩡한 로봇과 고리에는 none이라고 씁니다. 나머지에서는 문제가 되는 자식이 줄의 두 번째에 있습니다.",
)


TASK = Task(
    id="E4.2",
    kind="D",
    points=5,
    title=Text(en="Five listings", ko="목록 다섯 개"),
    answer="finding",
    form=Parts(
        {key: form for letter in LETTERS for key, form in ((letter, Choice(KINDS)), (f"{letter} child", Name()))}
    ),
    given=listings,
    variants=8,
    model=diagnosed,
    mistakes=(
        ROOTS_ONLY,
        LOOP_IS_A_TREE,
        SAME_EDGE_TWICE,
        OWNERS_ARE_PARENTS,
        PARENTS_ARE_OWNERS,
        PARENTS_ARE_FINE,
        NAMED_THE_PARENT,
    ),
    hints=(
        Text(
            en="Look for a child that stands in two rows. The same parent, or another?",
            ko="두 줄에 나오는 자식을 찾으십시오. 부모가 같습니까, 다릅니까?",
        ),
        Text(
            en="Where no child stands twice, collect the parents that are nobody's child. More than `map`: two trees.",
            ko="두 번 나오는 자식이 없으면, 누구의 자식도 아닌 부모를 모으십시오. `map` 말고 더 있으면 트리가 둘입니다.",
        ),
        Text(
            en="Siblings share a parent, which is fine. And a loop has no root: climb from each frame and see whether you arrive.",
            ko="형제는 부모가 같을 뿐이며 문제가 없습니다. 고리에는 루트가 없습니다. 좌표계마다 올라가서 끝에 닿는지 보십시오.",
        ),
    ),
    misconceptions=("M2", "M6"),
    means={
        "two parents": Text(
            en="Two parents: one child in two rows whose parents differ; siblings are none of that.",
            ko="two parents: 한 자식이 두 줄에 나오고 부모가 다릅니다. 형제는 여기에 들지 않습니다.",
        ),
        "two owners": Text(
            en="Two owners: one child in two rows with one parent, and two nodes.",
            ko="two owners: 한 자식이 두 줄에 나오고 부모는 같으며 노드가 다릅니다.",
        ),
        "two trees": Text(
            en="Two trees: beside map a second name that is a parent and nobody's child.",
            ko="two trees: map 말고도 누구의 자식도 아닌 부모가 있습니다.",
        ),
        "loop": Text(
            en="A loop: following the parents leads back to where one began.",
            ko="loop: 부모를 따라가면 출발한 곳으로 돌아옵니다.",
        ),
        "healthy": Text(
            en="Healthy: every child in one row only, one root, and every climb ends there.",
            ko="healthy: 자식마다 한 줄뿐이고 루트가 하나이며, 어디서 올라가도 그 루트에 닿습니다.",
        ),
    },
    shows=dict.fromkeys(LETTERS, LOOK_AGAIN) | {f"{letter} child": WHO for letter in LETTERS},
)
