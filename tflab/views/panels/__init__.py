"""What happens if I move it?  Sliders in front of the pictures.

    slider --> a pure function --> the picture moves its artists --> a PNG for the page
                                `-> panel.text, the same in words

    panel          controls, a picture, words: what all of them share
    drawn_ahead    the picture of a panel, drawn before it is asked for
    words          in whose language the controls are
    rulers         move a robot, and see whose numbers change
    joints         move an arm, joint by joint
    axes           turn a robot; move a point in front of a camera
    mount          turn a sensor; see two mistakes wander
    sentence       choose target and source in any of five ways
    bend           how often is often enough
    toolcase       put a question to each tool
    visited        go through a visit, step by step
    tree           give a frame another parent, and ask
    timeline       drag a query past either end of the buffer
    joins          come later, and see what is still known
    latency        how far off, for this speed, turn, range and delay
    clocks         whose time a node lives in, while a bag is played

A page shows a panel by naming it in the last line of a cell; `.text` says the same
in a terminal, and `.close()` gives everything back.  Start with `panel.py`.
"""

from .axes import cameras_panel, rotation_panel
from .bend import rate_panel
from .clocks import clocks_panel
from .joins import joins_panel
from .joints import Travel, joints_panel
from .latency import latency_panel
from .mount import mount_panel
from .panel import Panel
from .rulers import rulers_panel
from .sentence import SentencePanel, sentence_panel
from .timeline import timeline_panel
from .toolcase import tools_panel
from .tree import tree_panel
from .visited import visit_panel

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
    "visit_panel",
]
