"""E4.1: One missing letter."""

from __future__ import annotations

from difflib import get_close_matches

from tflab.workbook.tasks import Tree, define_task

from .draws import draw_tree, draw_typo


def draw_misspelt_tree(rng):
    """Draw an edge whose parent lacks a letter, where other edges use the right name of the parent."""
    tree = draw_tree(rng)
    child = str(rng.choice([child for child, parent in tree.items() if parent != "map"]))
    wrong = draw_typo(rng, tree[child])
    while wrong in tree:
        wrong = draw_typo(rng, tree[child])
    return {"edges": [(wrong if each == child else parent, each) for each, parent in tree.items()]}


def names(given):
    tree = {child: parent for parent, child in given.edges}
    (wrong,) = set(tree.values()) - set(tree) - {"map"}
    return tree, wrong, get_close_matches(wrong, tree, n=1)[0]


def build_tree(given, *, fault="corrected", way="child -> parent"):
    """Return the tree, step by step; other arguments are mistakes."""
    tree, wrong, meant = names(given)
    swap = {"corrected": (wrong, meant), "at the top": (wrong, "map")}.get(fault)
    if swap:
        tree = {child: swap[1] if parent == swap[0] else parent for child, parent in tree.items()}
    elif fault in ("bridged", "bridged at the top"):
        tree = {**tree, wrong: meant if fault == "bridged" else "map"}
    elif fault == "below the typo":
        tree = {**tree, meant: wrong}
    elif fault == "left out":
        tree = {child: parent for child, parent in tree.items() if parent != wrong}
    elif fault in ("renamed", "parents renamed"):
        spelt = wrong if fault == "renamed" else meant
        tree = {spelt if c == meant else c: wrong if p == meant else p for c, p in tree.items()}
    return {parent: child for child, parent in tree.items()} if way == "parent -> child" else tree


ANSWERS = {
    "only the edge": lambda given: dict([next((c, names(given)[2]) for p, c in given.edges if p == names(given)[1])]),
    "a parent for map": lambda given: {**build_tree(given), "map": "world"},
    "all below one": lambda given: dict.fromkeys(build_tree(given), names(given)[2]),
    "the correction alone": lambda given: {names(given)[1]: names(given)[2]},
    "the correction reversed": lambda given: {names(given)[2]: names(given)[1]},
}

TASK = define_task(
    __file__,
    kind="T",
    points=3,
    answer="corrected",
    form=Tree(),
    given=draw_misspelt_tree,
    variants=8,
    model=build_tree,
    answers=ANSWERS,
)
