"""E4.3: Up, then down."""

from __future__ import annotations

from tflab.core import ConnectivityException
from tflab.workbook.tasks import Choice, Name, Pair, Sequence, define_task

from .draws import draw_tree, path_to_root


def draw_queries(rng):
    """Draw siblings, cousins, ancestors, descendants, a frame and itself, and frames of two trees."""
    rows = []
    for _ in range(2):
        tree = draw_tree(rng, parts=4) | {"camera_link": "base_link", "camera_optical_frame": "camera_link"}
        tree |= {"imu_link": "base_link", "laser_frame": "base_link", "lens": "camera_optical_frame"}
        twins = tree | {"left/eye": "lens", "left/lamp": "left/eye", "right/lamp": "left/eye", "map": "earth"}
        deep = tree | {"mast": "lens", "pan": "mast", "tilt": "pan", "eye": "tilt"}
        long = tree | {f"link_{n}": f"link_{n - 1}" if n else "base_link" for n in range(12)}
        rows += [
            (long, "imu_link", "link_11"),
            (deep, "eye", "imu_link"),
            (twins, "left/lamp", "right/lamp"),
            (twins, "earth", "left/lamp"),
            (tree, "imu_link", "laser_frame"),
            (tree, "lens", "laser_frame"),
            (tree, "map", "camera_optical_frame"),
            (tree, "camera_optical_frame", "odom"),
            (tree, "odom", "odom"),
            (tree, "base_link", "lens"),
            (tree, "map", "map"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "map", "lamp"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "hall", "lamp"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "lamp", "imu_link"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "map", "hall"),
        ]
    return rows


def walk_path(
    parent_of,
    target,
    source,
    *,
    ends="as asked",
    climb="until they meet",
    words="as they are",
    order="outward",
    both="up, then down",
    named="child",
    pairs="child first",
    lost="raises",
):
    """Return the path, decision by decision; other arguments are mistakes."""
    if ends == "exchanged":
        target, source = source, target
    up, down = path_to_root(parent_of, source), path_to_root(parent_of, target)
    if up[-1] != down[-1]:
        if lost == "raises":
            raise ConnectivityException("not part of the same tree")
        if lost != "joined":
            return [] if lost == "empty" else None
    if named == "a step to itself" and target == source:
        return [(source, "up")]
    if climb == "to the root, but for itself":
        up, down = ([], []) if target == source else (up[:-1], down[:-1])
    if (climb == "up alone" and target not in up) or (climb == "down alone" and source not in down):
        raise ConnectivityException("no way up") if climb == "up alone" else ConnectivityException("no way down")
    if climb == "straight alone" and target not in up and source not in down:
        raise ConnectivityException("neither above nor below")
    if climb not in ("to the root", "to the root, but for itself"):
        while up and down and up[-1] == down[-1]:
            up.pop()
            down.pop()
    elif climb == "to the root":
        up, down = up[:-1], down[:-1]
    whole = path_to_root(parent_of, source)[:-1]
    up = whole if climb == "up to the root" and target != source else up
    meeting = parent_of.get(up[-1], up[-1]) if up else source
    first, then = {"exchanged": ("down", "up"), "all up": ("up", "up"), "all down": ("down", "down")}.get(
        words, ("up", "down")
    )
    down = {"outward": down[::-1], "as climbed": down, "left out": [], "but for the last": down[:0:-1]}.get(
        order, down[::-1]
    )
    up = up[1:] if order == "but for the first" else up
    if named == "where they meet, too" and up:
        up = [*up, parent_of.get(up[-1], up[-1])]
    is_met = named == "where they meet, always" or (named == "where they meet, but for itself" and target != source)
    up = [*up, meeting] if is_met else up
    down = [meeting, *down] if named == "where they meet, down" else down
    if named == "parent":
        up, down = ([parent_of.get(child, child) for child in way] for way in (up, down))
    if named == "where it arrives":
        up = [parent_of.get(child, child) for child in up]
    down = [parent_of.get(child, child) for child in down] if named == "parent, going down" else down
    climbing, descending = [(child, first) for child in up], [(child, then) for child in down]
    if pairs == "way first":
        return [(way, child) for child, way in climbing + descending]
    if both == "reversed":
        return (climbing + descending)[::-1]
    if both == "up, then down":
        return climbing + descending
    return descending + climbing if both == "down, then up" else descending


def count_climbs(parent_of, target, source):
    way = []
    while source in parent_of and source != target:
        way.append((source, "up"))
        source = parent_of[source]
    return way


ANSWERS = {
    "climbs alone": count_climbs,
}

TASK = define_task(
    __file__,
    kind="F",
    points=5,
    answer="path",
    form=Sequence(Pair(Name(), Choice(("up", "down")))),
    inputs=draw_queries,
    variants=3,
    model=walk_path,
    answers=ANSWERS,
)
