"""In whose language?  A panel with a sentence in it speaks that of the learner's copy.

Read `joints.py` next.
"""

from __future__ import annotations

from collections.abc import Mapping

from tflab.core import Transform
from tflab.views import panels
from tflab.views.clocks import Play
from tflab.views.panels import Panel, SentencePanel

from ..places import read_workbook, workbook_root

__all__ = ["clocks_panel", "sentence_panel"]


def clocks_panel(play: Play | None = None, played_s: float = 9.0) -> Panel:
    """Return a panel of two nodes' clocks while a bag is played, in the language of this copy."""
    return panels.clocks_panel(play, played_s, read_workbook(workbook_root()).language)


def sentence_panel(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> SentencePanel:
    """Return a panel in which a question can be chosen in any of its forms, in the language of this copy."""
    language = read_workbook(workbook_root()).language
    return panels.sentence_panel(poses, target_frame, source_frame, language=language)
