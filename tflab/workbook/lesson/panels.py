"""In whose language?  A panel with words in it speaks that of the learner's copy.

What a panel has to ask a buffer is asked here, of a fresh one each time.

Read `joints.py` next.
"""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, TransformException
from tflab.views import panels
from tflab.views.clocks import Play
from tflab.views.panels import Panel, SentencePanel
from tflab.views.style import fmt_all

from ..places import read_workbook, workbook_root

__all__ = ["clocks_panel", "sentence_panel", "tree_panel"]


def clocks_panel(play: Play | None = None, played_s: float = 9.0) -> Panel:
    """Return a panel of two nodes' clocks while a bag is played, in the language of this copy."""
    return panels.clocks_panel(play, played_s, read_workbook(workbook_root()).language)


def sentence_panel(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> SentencePanel:
    """Return a panel in which a question can be chosen in any of its forms, in the language of this copy."""
    language = read_workbook(workbook_root()).language
    return panels.sentence_panel(poses, target_frame, source_frame, language=language)


def tree_panel(parent_of: Mapping[str, str], target_frame: str, source_frame: str) -> Panel:
    """Return a panel in which a frame can be given another parent, and tf2 be asked, in the language of this copy."""
    language = read_workbook(workbook_root()).language
    return panels.tree_panel(parent_of, target_frame, source_frame, _answer, language=language)


def _answer(edges: Sequence[tuple[str, str]], target_frame: str, source_frame: str) -> tuple[bool, str]:
    """Return what tf2 logs and says: of static edges (parent, child), each a step of 1 m along x, and a question."""
    buffer, log = BufferCore(), _Lines()
    logger = logging.getLogger("tflab.tf2")
    was_propagated, logger.propagate = logger.propagate, False
    logger.addHandler(log)
    try:
        for parent, child in edges:
            step = Transform(translation=(1.0, 0.0, 0.0))
            buffer.set_transform(StampedTransform(parent, child, 1, step), "node", is_static=True)
    finally:
        logger.removeHandler(log)
        logger.propagate = was_propagated
    call = f"lookup_transform('{target_frame}', '{source_frame}', Time())"
    try:
        found = buffer.lookup_transform(target_frame, source_frame, LATEST)
    except TransformException as error:
        return False, "\n".join([*log.lines, call, f"{type(error).__name__}: {error}".rstrip()])
    return not log.lines, "\n".join([*log.lines, call, f"translation {fmt_all(found.transform.translation, digits=1)}"])


class _Lines(logging.Handler):
    """Keeps what is logged."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.lines.append(record.getMessage())
