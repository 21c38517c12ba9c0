"""Put sliders and menus in front of the pictures.

    slider --> a pure function --> the picture moves its artists --> a PNG for the page
                                `-> panel.text

    panel       controls, a picture, its text
    prefetch    draws the pictures of a panel before they are requested
    geometry    rotations, camera axes, a turned sensor, coordinates, joints
    timing      transform rate, latency, timeline, clocks, late joiners
    lookups     target and source, the tree
    diagnosis   tools

A page shows a panel by naming it in the last line of a cell; `.close()` frees it.
"""

from .diagnosis import tools_panel
from .geometry import Travel, cameras_panel, joints_panel, mount_panel, rotation_panel, rulers_panel
from .lookups import SentencePanel, sentence_panel, tree_panel
from .panel import Panel
from .timing import clocks_panel, joins_panel, latency_panel, rate_panel, timeline_panel

__all__ = [
    "Panel",
    "SentencePanel",
    "Travel",
    "cameras_panel",
    "clocks_panel",
    "joins_panel",
    "joints_panel",
    "latency_panel",
    "mount_panel",
    "rate_panel",
    "rotation_panel",
    "rulers_panel",
    "sentence_panel",
    "timeline_panel",
    "tools_panel",
    "tree_panel",
]
