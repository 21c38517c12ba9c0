"""Draw robots of six to nine frames for several tasks of chapter 04."""

from __future__ import annotations

PARTS = {
    "lidar": ("laser_frame",),
    "camera": ("camera_link", "camera_optical_frame"),
    "imu": ("imu_link",),
    "arm": ("shoulder", "tool0"),
    "radar": ("radar_link",),
    "depth": ("depth_link", "depth_optical_frame"),
    "gps": ("gps_link",),
}
NODES = {"odom": "/localization", "base_link": "/wheel_odometry", "base_footprint": "/wheel_odometry"}


def draw_tree(rng, parts=3):
    """Draw a healthy tree, child -> parent, in any order."""
    base = ["odom", "base_footprint", "base_link"] if rng.random() < 0.5 else ["odom", "base_link"]
    tree = dict(zip(base, ["map", *base], strict=False))
    for part in rng.permutation(list(PARTS))[:parts]:
        tree |= dict(zip(PARTS[str(part)], ["base_link", *PARTS[str(part)]], strict=False))
    return {str(child): tree[str(child)] for child in rng.permutation(list(tree))}


def draw_typo(rng, name):
    """Return a name without one of its letters."""
    letters = [place for place, letter in enumerate(name) if letter.isalpha() and place]
    place = int(rng.choice(letters))
    return name[:place] + name[place + 1 :]


def node_of(child):
    """Return the node that publishes a child of a healthy robot."""
    return NODES.get(child, "/robot_state_publisher")


def path_to_root(parent_of, frame):
    """Return the frames from one up to its root."""
    way = [frame]
    while way[-1] in parent_of:
        way.append(parent_of[way[-1]])
    return way
