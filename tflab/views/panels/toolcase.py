"""Which tool for which question?  Two menus: what is asked, and what is typed.

    question  How often does one edge come?  v        tool  ros2 topic hz  v
    ~ half: it counts the messages of everybody.
    $ ros2 topic hz /tf ...

The pure part is `tflab.views.toolcase`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape

from ..libraries import ipywidgets as widgets
from ..toolcase import SIGNS, Suitabilities, ToolOutput, ToolPicture
from .drawn_ahead import At
from .panel import Panel


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

    for menu in (question, tool):
        menu.observe(say_why, names="value")
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
