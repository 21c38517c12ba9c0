"""Where is a bag, if I have none?  Here: ten seconds of our robot, recorded in real time on a real machine.

    BAG = example_bag()        then on your own: BAG = "~/bags/kitchen"
    read_bag(BAG)              ros2 bag info, tflab doctor: whatever reads a bag reads both

Its stamps are those of the day on which it was made, its messages come a little late
and never quite evenly: what virtual time never shows.  It holds /scan, /tf and
/tf_static, no /clock: a real robot has none.  `docs/make_example_bag.py` made it.

This is the last page of the room.
"""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path

__all__ = ["example_bag"]


def example_bag() -> Path:
    """Return the folder of the bag that comes with the package; it is there to be read."""
    return Path(str(files("tflab.bags") / "data" / "kitchen"))
