"""How sure is a finding, and what would settle it?

    certain   it is in the recording, whatever the cause
    likely    the pattern fits one cause best
    open      two causes leave the same traces: somebody has to look

Statisticians would give a posterior; three words are what the evidence carries.
"""

from __future__ import annotations

from typing import Literal

__all__ = ["Certainty", "certainty_of", "what_settles"]

Certainty = Literal["certain", "likely", "open"]

LIKELY = {
    "name-case": "look whether both names are meant: `ros2 param get` of the nodes that say them",
    "name-prefix": "compare frame_prefix and frame_id of the nodes that say the two names",
    "name-slip": "add the transform between the two for a moment: if the tree is whole, it was another frame",
    "two-owners": "stop one of the two publishers: the other values should stay, smooth",
    "constant-on-tf": "move every joint once: what still never moves is a mount",
    "upside-down": "ask the publisher's code which frame it calls the parent",
    "statics-missing": "record again with /tf_static and look whether the frames appear",
    "stall": "record on the robot itself: if it is gone, it was the network or the recorder",
    "tf-silent": "record on the robot itself: if it is gone, it was the network or the recorder",
    "slow-edge": "`ros2 topic hz` on the robot: the rate at the source, without the recorder",
    "clock-jump-back": "the log of the simulator, of the player, or of chrony at that moment",
    "clock-jump-forward": "the log of the simulator, of the player, or of chrony at that moment",
    "other-time": "`ros2 param get NODE use_sim_time` of both publishers",
    "optical-unturned": "look at a point cloud in RViz: does it look ahead, or up into the sky?",
}
OPEN = {
    "late-stamps": "`chronyc tracking` on both computers: if they agree, the node takes long",
    "early-stamps": "`chronyc tracking` on both computers: if they agree, the node adds to its stamps",
    "messages-early": "`chronyc tracking` on the sensor's computer",
    "messages-late": "`chronyc tracking` on the sensor's computer: if it agrees, processing takes long",
    "clock-offset": "`chronyc tracking` on both computers: if they agree, everything is delayed alike",
    "static-changed": "`ros2 topic info --verbose`: one publisher (calibrated anew), or two",
    "gap": "record on the robot itself: a gap that stays is the publisher's",
    "went-silent": "the log of the node at that moment (~/.ros/log), if it is not there any more",
    "late-start": "the order in the launch file, and the log of the node",
    "re-parented": "`ros2 topic info --verbose`: one publisher (a parameter changed), or two",
    "repeated-stamps": "`ros2 topic info --verbose`: one publisher (it sends too often), or two",
    "unknown-frame": "the drawn tree: is there a name like it (the driver's is wrong), or none (the mount is missing)?",
}


def certainty_of(code: str) -> Certainty:
    """Return how sure a finding is."""
    return "likely" if code in LIKELY else "open" if code in OPEN else "certain"


def what_settles(code: str) -> str:
    """Return what would settle a finding that is not certain, "" if it is."""
    return LIKELY.get(code) or OPEN.get(code, "")
