"""In whose language?  A panel with a sentence in it speaks that of the learner's copy.

Read `joints.py` next.
"""

from __future__ import annotations

from collections.abc import Mapping

from tflab.core import Transform
from tflab.views import panels
from tflab.views.panels import SentencePanel

from ..places import read_workbook, workbook_root

__all__ = ["sentence_panel"]


def sentence_panel(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> SentencePanel:
    """Return a panel in which a question can be chosen in any of its forms, in the language of this copy."""
    language = read_workbook(workbook_root()).language
    return panels.sentence_panel(poses, target_frame, source_frame, language=language)
