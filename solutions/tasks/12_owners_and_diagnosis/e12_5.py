"""E12.5: A robot from its specification."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Name, Parts, Set, Tree, define_task

TOPICS = ("/tf", "/tf_static")
BAGS = {
    "all": ["/tf", "/tf_static"],
    "moving only": ["/tf"],
    "statics only": ["/tf_static"],
    "with /odom": ["/tf", "/tf_static", "/odom"],
    "with /clock": ["/tf", "/tf_static", "/clock"],
}
OWNERS = ("localization", "wheel_odometry", "ekf_filter_node", "robot_state_publisher", "camera_driver")


def draw_specification(rng):
    """Draw a robot's name, its camera, and whether it fuses odometry."""
    return {
        "robot": str(rng.choice(["alpha", "bravo", "carrier2", "dolly"])),
        "sensor": str(rng.choice(["camera", "rgb", "depth"])),
        "fused": bool(rng.integers(2)),
        "camera_driver_publishes_tf": True,
    }


def robot(
    given, *, prefix="own", map="shared", chain="whole", camera="on the base", optical="below the camera",
    more="nothing", moving="again and again", mounts="static", localizer="map to odom", fuse="as given", owner="one",
    driver="quiet", bag="all",
):  # fmt: skip
    """Return the robot, step by step; other arguments are mistakes."""
    odom, foot, base = "odom", "base_footprint", "base_link"
    link, seen = f"{given.sensor}_link", f"{given.sensor}_optical_frame"
    tree = {odom: "map", foot: odom, base: foot, link: {"on the base": base, "on the footprint": foot}[camera]}
    tree[seen] = tree[link] if optical == "beside the camera" else link
    if chain == "no footprint":
        tree = {child: odom if parent == foot else parent for child, parent in tree.items() if child != foot}
    elif chain == "footprint below the base":
        tree |= {base: odom, foot: base}
    if optical == "left out":
        del tree[seen]
    elif optical == "above the camera":
        tree |= {seen: tree[link], link: seen}
    if localizer == "map to base":
        tree[foot] = "map"
    if map == "left out":
        del tree[odom]
    tree = _called(tree, given, prefix, {link, seen}, "" if map == "own" else "map")
    if more == "the first robot's":
        tree |= {odom: "map", foot: odom, base: foot, link: base, seen: link}
    fused = bool(given.fused) != (fuse == "the other way")
    switch = {"both": True, "none": False}.get(owner)
    return {
        "tree": tree,
        "moving": "/tf_static" if moving == "static" else "/tf",
        "mounts": "/tf" if mounts == "moving" else "/tf_static",
        "odom owner": "ekf_filter_node" if fused else "wheel_odometry",
        "mounts owner": "robot_state_publisher",
        "wheel_odometry publish_tf": not fused if switch is None else switch,
        "ekf publish_tf": fused if switch is None else switch,
        "camera_driver publish_tf": driver == "on",
        "bag": BAGS[bag],
    }


def _called(tree, given, prefix, sensors, bare):
    """Return a tree with the robot's name before the frames that `prefix` selects."""

    def name(frame, side):
        without = {
            "own": False, "none": True, "not the sensor's": frame in sensors, "not odom's": frame == "odom",
            "not the parents'": side == "parent", "not the children's": side == "child",
        }[prefix]  # fmt: skip
        return frame if frame == bare or without else f"{given.robot}/{frame}"

    return {name(child, "child"): name(parent, "parent") for child, parent in tree.items()}


TASK = define_task(
    __file__,
    kind="T",
    points=5,
    answer="robot",
    form=Parts(
        {
            "tree": Tree(),
            "moving": Choice(TOPICS),
            "mounts": Choice(TOPICS),
            "odom owner": Choice(OWNERS),
            "mounts owner": Choice(OWNERS),
            "wheel_odometry publish_tf": Choice(("True", "False")),
            "ekf publish_tf": Choice(("True", "False")),
            "camera_driver publish_tf": Choice(("True", "False")),
            "bag": Set(Name(topic=True)),
        }
    ),
    given=draw_specification,
    variants=6,
    model=robot,
)
