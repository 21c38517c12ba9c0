"""E4.2: Five listings."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Name, Parts, define_task

from .draws import draw_tree, draw_typo, node_of

KINDS = ("healthy", "two trees", "loop", "two parents", "two owners")
LETTERS = "abcde"
BESIDE = (("door_frame", "door_handle"), ("turntable", "workpiece"), ("lift_base", "lift_plate"))


def draw_listings(rng):
    """Draw five robots, one of each kind, in any order."""
    kinds = [str(kind) for kind in rng.permutation(KINDS)]
    return {letter: _listing(rng, kind) for letter, kind in zip(LETTERS, kinds, strict=True)}


def _listing(rng, kind):
    tree = draw_tree(rng)
    rows = [(parent, child, node_of(child)) for child, parent in tree.items()]
    # A sensor that carries nothing, so that who names its parent instead names another frame.
    leaf = str(rng.choice([child for child in tree if child not in tree.values()]))
    place = next(number for number, row in enumerate(rows) if row[1] == leaf)
    parent = rows[place][0]
    if kind == "two trees":
        rows[place] = (draw_typo(rng, parent), leaf, rows[place][2])
    elif kind == "two parents":
        rows.append(("odom", leaf, "/calibration"))
    elif kind == "two owners":
        rows.append((parent, leaf, "/sensor_driver"))
    elif kind == "loop":
        one, other = BESIDE[int(rng.integers(len(BESIDE)))]
        rows += [(one, other, "/fixture"), (other, one, "/fixture")]
    return [rows[int(number)] for number in rng.permutation(len(rows))]


def diagnose(given, *, loops="looked for", owners="counted", parents="counted", named="child"):
    """Return all five findings, step by step; other arguments are mistakes."""
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


TASK = define_task(
    __file__,
    kind="D",
    points=5,
    answer="finding",
    form=Parts(
        {key: form for letter in LETTERS for key, form in ((letter, Choice(KINDS)), (f"{letter} child", Name()))}
    ),
    given=draw_listings,
    variants=8,
    model=diagnose,
)
