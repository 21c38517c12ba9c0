"""E4.6: Which children have several owners?"""

from __future__ import annotations

from itertools import pairwise

from tflab.workbook.tasks import Name, Sequence, define_task

from .draws import draw_tree, node_of


def draw_logs(rng):
    """Draw healthy logs, repeats, two and three owners, two parents, one base name in two namespaces."""
    rows = []
    for _ in range(2):
        tree = draw_tree(rng)
        healthy = [(node_of(child), parent, child) for child, parent in tree.items()]
        names = [str(name) for name in rng.permutation([child for child in tree if child != "odom"])]
        twice = [("/ekf_filter_node", tree[names[0]], names[0])]
        moved = [("/calibration", "odom" if tree[names[1]] != "odom" else "map", names[1])]
        spaces = [("/robot1/driver", "base_link", "lamp"), ("/robot2/driver", "base_link", "lamp")]
        same_node = [("/robot_state_publisher", "odom", "plate"), ("/robot_state_publisher", "map", "plate")]
        back = [("/amcl", "map", "odom"), ("/localization", "map", "odom"), ("/amcl", "odom", "base_link")]
        crowd = [
            (f"/fleet/robot1/transform_source_{side}", "map", child)
            for side, children in (
                ("left", ["robot1/odom", "robot2/odom", "robot1/base", "robot2/base", *"Zabcde"]),
                ("right", ["robot1/odom", "robot1/Base", "robot2/base", *"Zabcde"]),
            )
            for child in children
        ]
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
            [*healthy, *back],
            [*healthy, *crowd],
            [*healthy, *twice, ("/third", tree[names[0]], names[0])],
        ]
    return [(row,) for row in rows]


def changing_children(log):
    """Return the children of which two consecutive rows have different nodes."""
    rows = pairwise(log)
    return sorted({child for (node, _, child), (other, _, same) in rows if child == same and node != other})


def count_owners(log, *, names="whole", key="child", what="nodes", least=2, order="sorted"):
    """Return the children with several owners, step by step; other arguments are mistakes."""
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
    """Return the child of which a second node is received first."""
    nodes = {}
    for node, _, child in log:
        nodes.setdefault(child, set()).add(node)
        if child in many and len(nodes[child]) == 2:
            return [child]
    return many[:1]


ANSWERS = {
    "all children": lambda log: sorted({child for _, _, child in log}),
    "nodes": lambda log: sorted({node for node, _, child in log if len({n for n, _, c in log if c == child}) > 1}),
    "by parent": lambda log: sorted({parent for _, parent, _ in log if len({n for n, p, _ in log if p == parent}) > 1}),
    "taken for (parent, child, node)": lambda log: sorted(
        {parent for _, parent, _ in log if len({c for _, p, c in log if p == parent}) > 1}
    ),
    "busy nodes": lambda log: sorted({node for node, _, _ in log if len({c for n, _, c in log if n == node}) > 1}),
    "parents": lambda log: sorted(
        {parent for _, parent, child in log if len({n for n, _, c in log if c == child}) > 1}
    ),
    "neighbours alone": changing_children,
}

TASK = define_task(
    __file__,
    kind="F",
    points=3,
    answer="several_owners",
    form=Sequence(Name()),
    inputs=draw_logs,
    variants=3,
    model=count_owners,
    answers=ANSWERS,
)
