"""E4.4: Two robots, one map."""

from __future__ import annotations

from tflab.workbook.tasks import Tree, define_task

from .draws import draw_tree

TEAMS = (("left", "right"), ("red", "blue"), ("tb3_0", "tb3_1"), ("alpha", "beta"), ("north", "south"))


def robots(rng):
    tree = draw_tree(rng, parts=2)
    first, second = TEAMS[int(rng.integers(len(TEAMS)))]
    return {"edges": [(parent, child) for child, parent in tree.items()], "prefixes": [first, second]}


def merge_trees(
    given,
    *,
    robots="beside each other",
    named="as given",
    shared=("map",),
    glue="{}/{}",
    parents="prefixed",
    children="prefixed",
    who="both",
    whose="all frames",
    way="child -> parent",
):
    """Return the tree of both robots, step by step; other arguments are mistakes."""
    fleet = {}
    first, second = prefixes = ["robot1", "robot2"] if named == "numbered" else given.prefixes
    for prefix in {"the first": prefixes[:1], "the last": prefixes[1:]}.get(who, prefixes):
        for parent, child in given.edges:
            prefixed = {
                name: glue.format(prefix, name)
                for name in (parent, child)
                if name not in shared and (whose == "all frames" or name.startswith(("odom", "base")))
            }
            above, below = prefixed.get(parent, parent), prefixed.get(child, child)
            is_bare = parents == "bare" or (parents == "odom bare" and parent == "odom")
            fleet[below if children == "prefixed" else child] = parent if is_bare else above
    if parents == "robot by robot":
        fleet |= {child: prefix for prefix in prefixes for child in fleet if fleet[child] == "map" and prefix in child}
        fleet |= dict.fromkeys(prefixes, "map")
    if who == "the first bare":
        fleet |= {child: parent for parent, child in given.edges}
        fleet = {child: parent for child, parent in fleet.items() if not child.startswith(f"{first}/")}
    if robots == "on the other's base":
        fleet[f"{second}/odom"] = f"{first}/base_link"
    if robots == "one below the other":
        fleet = {c: p if p != "map" or not c.startswith(second) else f"{first}/odom" for c, p in fleet.items()}
    return {parent: child for child, parent in fleet.items()} if way == "parent -> child" else fleet


ANSWERS = {
    "slash in front of all": lambda given: {
        child: "/map" if parent == "map" else parent for child, parent in merge_trees(given, glue="/{}/{}").items()
    },
}

TASK = define_task(
    __file__,
    kind="T",
    points=3,
    answer="fleet",
    form=Tree(),
    given=robots,
    variants=8,
    model=merge_trees,
    answers=ANSWERS,
)
