"""Show which tool answers a question, and what it prints, in a panel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape

from ..fault_tables import SIGNS, Suitabilities, ToolOutput, ToolPicture
from ..libraries import ipywidgets as widgets
from .panel import Panel, menu
from .prefetch import Controls


def tools_panel(
    asked: Mapping[str, str],
    tools: Sequence[ToolOutput],
    verdicts: Suitabilities,
    names: tuple[str, str],
) -> Panel:
    """Return a panel that shows what a tool prints for a question, and whether that is an answer.

    Args:
        asked: each question, in the reader's language, by its term.
        tools: what each printed.
        verdicts: by term and by the tool's name.
        names: of the two menus, in the reader's language.

    Raises:
        ValueError: a verdict is missing.
    """
    for term in asked:
        for tool in tools:
            if tool.name not in verdicts.get(term, {}):
                raise ValueError(f"there is no verdict on {tool.name!r} for {term!r}")
    options = ([(text, term) for term, text in asked.items()], [(each.name, each) for each in tools])
    question, tool = (
        menu(name, rows, label_width="60px", width="500px") for name, rows in zip(names, options, strict=True)
    )
    why = widgets.HTML()
    picture = ToolPicture(tuple(verdicts))

    def move(at: Controls) -> None:
        picture.show(at(tool), at(question), verdicts)

    def explain(_change: object = None) -> None:
        verdict = verdicts[question.value][tool.value.name]
        why.value = f"<b>{SIGNS[verdict.level]}</b> {escape(verdict.why)}"

    for control in (question, tool):
        control.observe(explain, names="value")
    explain()
    return Panel(" × ".join(names), picture, (question, tool), move, layout=[question, tool, why])
