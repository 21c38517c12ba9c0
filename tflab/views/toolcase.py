"""Which tool answers this question, and what is it blind to?  Real outputs, and a table of verdicts.

    $ ros2 run tf2_ros tf2_monitor map laser_frame
    RESULTS: for map to laser_frame                        what it prints, to the letter
    Net delay     avg = 0.0209299: max = 0.11

    ✗ frames   ✗ value   ✗ rate   [✓ delay]   ✗ owner      answers ✓, half ~, cannot ✗

A tool that does not answer a question prints something all the same: so one should
ask first, and then type.  What the field calls the observability of each tool.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import style
from .picture import Picture
from .typed import TypedBlock

__all__ = ["SIGNS", "Suitability", "ToolOutput", "ToolPicture", "describe_tools", "draw_tools"]

SIGNS = {"answers": "✓", "half": "~", "cannot": "✗"}
COLOURS = {"answers": "#00694E", "half": "#8A5A00", "cannot": style.GREY}
MOST_ROWS, MOST_LETTERS = 20, 92
ROW_PX, HEAD_PX, FIRST_PX = 34, 96, 150


class ToolOutput(NamedTuple):
    """A tool, what was typed, and what it printed."""

    name: str
    command: str
    output: str


class Suitability(NamedTuple):
    """Whether a tool answers a question, "answers", "half" or "cannot", and why, in the reader's language."""

    level: str
    why: str


Suitabilities = Mapping[str, Mapping[str, Suitability]]  # by the question's term, then by the tool's name


class ToolPicture(Picture):
    """One tool's output, and below it a sign for each question."""

    def __init__(self, terms: Sequence[str]) -> None:
        super().__init__(style.TALL)
        with style.our_settings():
            self._command = TypedBlock(self.figure, 0.025, 0.965, style.ACCENT)
            self._output = TypedBlock(self.figure, 0.025, 0.905)
            self._signs = [
                self.figure.text(0.0, 0.045, "", fontsize=style.SMALL_PT, va="center", bbox={"pad": 4.0}) for _ in terms
            ]
        self.moving = [self._command, self._output, *self._signs]

    def show(self, tool: ToolOutput, asked: str, verdicts: Suitabilities) -> None:
        """Show what a tool printed; `asked` is the term of the question that is put to it."""
        self._command.write(f"$ {tool.command}")
        rows = [part for row in tool.output.strip("\n").split("\n") for part in _parts(row)]
        kept = rows if len(rows) <= MOST_ROWS else [*rows[: MOST_ROWS - 1], "..."]
        self._output.write("\n".join(kept))
        x = 0.025
        for term, sign in zip(verdicts, self._signs, strict=True):
            verdict = verdicts[term][tool.name]
            sign.set_text(f"{SIGNS[verdict.level]} {term}")
            sign.set_color(COLOURS[verdict.level])
            sign.set_fontweight("bold" if term == asked else "normal")
            sign.get_bbox_patch().set_facecolor(style.SHADE if term == asked else style.PAPER)
            sign.get_bbox_patch().set_edgecolor(style.INK if term == asked else style.PAPER)
            sign.set_x(x)
            x += 0.035 + 0.0118 * len(sign.get_text())
        verdict = verdicts[asked][tool.name]
        self.text = f"{asked}: {SIGNS[verdict.level]} {verdict.level}. {verdict.why}\n$ {tool.command}\n{tool.output}"


def describe_tools(verdicts: Suitabilities) -> str:
    """Return the table in words: a line for each question, with the tools that answer it, half or in full."""
    lines = []
    for term, row in verdicts.items():
        said = [
            f"{level} {', '.join(tools)}"
            for level in SIGNS
            if (tools := [name for name, verdict in row.items() if verdict.level == level])
        ]
        lines.append(f"{term}: {'; '.join(said)}")
    return "\n".join(lines)


def draw_tools(verdicts: Suitabilities) -> Picture:
    """Draw questions by tools: which answers which, in full, half or not at all."""
    tools = list(next(iter(verdicts.values())))
    width_px = style.WIDE[0] * style.SCREEN_DPI
    height_px = HEAD_PX + ROW_PX * len(verdicts) + 34
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    column_px = (width_px - FIRST_PX - 60) / len(tools)
    with style.our_settings():

        def write(x_px: float, y_px: float, text: str, **how: object) -> None:
            picture.figure.text(x_px / width_px, 1 - y_px / height_px, text, va="center", **how)

        for i, tool in enumerate(tools):
            write(FIRST_PX + (i + 0.5) * column_px, HEAD_PX - 22, tool, rotation=24, ha="left", rotation_mode="anchor")
        for j, (term, row) in enumerate(verdicts.items()):
            y_px = HEAD_PX + (j + 0.5) * ROW_PX
            write(24, y_px, term)
            for i, tool in enumerate(tools):
                level = row[tool].level
                write(
                    FIRST_PX + (i + 0.5) * column_px, y_px, SIGNS[level], ha="center", color=COLOURS[level],
                    fontsize=13, fontweight="normal" if level == "cannot" else "bold",
                )  # fmt: skip
        legend = "     ".join(f"{sign} {level}" for level, sign in SIGNS.items())
        write(24, height_px - 18, legend, color=style.GREY, fontsize=style.SMALL_PT)
    picture.text = describe_tools(verdicts)
    return picture


def _parts(row: str) -> list[str]:
    """Return a row of output in parts that fit, as a terminal folds it."""
    row = row.expandtabs(8)
    return [row[start : start + MOST_LETTERS] for start in range(0, max(len(row), 1), MOST_LETTERS)]
