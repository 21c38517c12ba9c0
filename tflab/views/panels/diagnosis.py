"""Panels for diagnosis: which tool answers a question, and a visit step by step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape

from ..diagnosis_log import VisitPicture, VisitStep
from ..fault_tables import SIGNS, Suitabilities, ToolOutput, ToolPicture
from ..libraries import ipywidgets as widgets
from .panel import Panel, menu, said
from .prefetch import At


def tools_panel(
    asked: Mapping[str, str],
    tools: Sequence[ToolOutput],
    verdicts: Suitabilities,
    names: tuple[str, str],
    language: str = "en",
) -> Panel:
    """Return a panel in which a question is put to a tool: what it prints, and whether that is an answer.

    Args:
        asked: each question, in the reader's language, by its term.
        tools: what each printed.
        verdicts: by term and by the tool's name.
        names: of the two menus, in the reader's language.
        language: of the button, "en" or "ko".

    Raises:
        ValueError: a verdict is missing.
    """
    for term in asked:
        for tool in tools:
            if tool.name not in verdicts.get(term, {}):
                raise ValueError(f"there is no verdict on {tool.name!r} for {term!r}")
    question = _menu(names[0], [(text, term) for term, text in asked.items()], "500px")
    tool = _menu(names[1], [(each.name, each) for each in tools], "500px")
    why = widgets.HTML()
    picture = ToolPicture(tuple(verdicts))

    def move(at: At) -> None:
        picture.show(at(tool), at(question), verdicts)

    def say_why(_change: object = None) -> None:
        verdict = verdicts[question.value][tool.value.name]
        why.value = f"<b>{SIGNS[verdict.level]}</b> {escape(verdict.why)}"

    for control in (question, tool):
        control.observe(say_why, names="value")
    say_why()
    return Panel(" × ".join(names), picture, (question, tool), move, layout=[question, tool, why], language=language)


def _menu(description: str, options: list, width: str) -> widgets.Dropdown:
    return widgets.Dropdown(
        options=options,
        description=description,
        tooltip=description,
        style={"description_width": "60px"},
        layout={"width": width, "max_width": "100%"},
    )


def visit_panel(steps: Sequence[VisitStep], budget_min: float, language: str = "en") -> Panel:
    """Return a panel that plays a visit step by step; on an exported page it is a film.

    Raises:
        ValueError: the language is unknown.
    """
    picture = VisitPicture(steps, budget_min)
    options = [(f"{number + 1}. {step.name}", number) for number, step in enumerate(steps)]
    step = menu(
        said("step", language), options, 0, said("the arrow keys go on and back", language),
        label_width="60px", width="420px",
    )  # fmt: skip
    return Panel(said("a visit", language), picture, (step,), lambda at: picture.show(at(step)), language=language)
