"""Draw tables for a diagnosis: suspects by checks, tools by questions.

suspects   a fault dictionary: what each suspect would show in each check
tools      which tool answers which question, and what it prints
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from . import style
from .picture import Picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ROW_PX, HEAD_PX, BORDER_PX, SLANT_PX = 30, 112, 14, 96

Findings = Mapping[str, Mapping[str, str]]  # of each suspect what it would say to each check


def remaining_suspects(findings: Findings, asked: Mapping[str, str]) -> list[str]:
    """Return the suspects that would have said what was said."""
    return [name for name, row in findings.items() if all(row[check] == said for check, said in asked.items())]


def describe_suspects(findings: Findings, asked: Mapping[str, str]) -> str:
    """Return the figure's text: a line for each suspect, then what was said, and how each other check would split."""
    left = remaining_suspects(findings, asked)
    width = max(map(len, findings))
    lines = [f"{len(left)} of {len(findings)} suspects left"]
    for name, row in findings.items():
        struck = next((check for check, said in asked.items() if row[check] != said), None)
        why = f"ruled out: {struck} would be {row[struck]}" if struck else "left"
        lines.append(f"  {name:<{width}}  {why}")
    lines += [f"asked: {check}: {said}" for check, said in asked.items()]
    for check in next(iter(findings.values())):
        groups = {findings[name][check] for name in left}
        if check not in asked:
            lines.append(
                f"not asked: {check}: " + (f"would tell {len(groups)} apart" if len(groups) > 1 else "nothing")
            )
    return "\n".join(lines)


class SuspectsPicture(Picture):
    """The table; `tell(asked)` fills in what was asked by now."""

    def __init__(self, findings: Findings, asked: Mapping[str, str]) -> None:
        self._findings = findings
        super().__init__(style.wide(HEAD_PX + ROW_PX * len(findings) + BORDER_PX))
        with style.our_settings():
            self.ax = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.tell(asked)

    def tell(self, asked: Mapping[str, str]) -> None:
        """Show the table after these checks: of each what was said."""
        self.text = describe_suspects(self._findings, asked)
        with style.our_settings():
            self._draw(style.pixel_paper(self.ax), asked)
        self.redraw_all()

    def _draw(self, ax: Axes, asked: Mapping[str, str]) -> None:
        left, checks = remaining_suspects(self._findings, asked), list(next(iter(self._findings.values())))
        names_px = style.names_width_px(self._findings) + BORDER_PX
        cell_px = (self.size_px[0] - names_px - SLANT_PX) / len(checks)
        for column, check in enumerate(checks):
            weight = "bold" if check in asked else "normal"
            style.write_slanted(ax, names_px + (column + 0.5) * cell_px, HEAD_PX - 8, check, weight=weight)
        for row, (name, kinds) in enumerate(self._findings.items()):
            y, is_left = HEAD_PX + (row + 0.5) * ROW_PX, name in left
            how = {"color": style.INK, "weight": "bold"} if is_left else {"color": style.GREY}
            ax.text(BORDER_PX, y, name, va="center", **how)
            for column, check in enumerate(checks):
                _draw_cell(ax, names_px + column * cell_px, y, cell_px, kinds[check], asked.get(check))
            if not is_left:
                ax.plot([BORDER_PX - 4, self.size_px[0] - SLANT_PX], [y, y], color=style.GREY, linewidth=1.4)


def _draw_cell(ax: Axes, x: float, y: float, width_px: float, kind: str, said: str | None) -> None:
    """Draw whether a suspect would have said what was said; hatched where nothing was asked."""
    from matplotlib.patches import Rectangle

    fits = said == kind
    ax.add_patch(
        Rectangle(
            (x + 2, y - ROW_PX / 2 + 2), width_px - 4, ROW_PX - 4, facecolor=style.PAPER,
            edgecolor=style.ACCENT if fits else style.FAINT, hatch="////" if said is None else None,
            linewidth=1.8 if fits else 0.8 if said else 1.0,
        )
    )  # fmt: skip
    if said is not None:
        ax.text(x + width_px / 2, y, "=" if fits else "≠", ha="center", va="center",
                color=style.ACCENT if fits else style.GREY, weight="bold")  # fmt: skip


def draw_suspects(findings: Findings, asked: Mapping[str, str] = {}) -> SuspectsPicture:
    """Draw suspects by checks.

    Args:
        findings: of each suspect what it would say to each check, the same checks for all.
        asked: of each check that was asked what it did say.

    Raises:
        ValueError: there are no suspects, or something was asked that is no column.
    """
    if not findings:
        raise ValueError("there is nobody to suspect")
    columns = list(next(iter(findings.values())))
    if unknown := [check for check in asked if check not in columns]:
        raise ValueError(f"no column {unknown[0]!r}; there is {', '.join(columns)}")
    return SuspectsPicture(findings, dict(asked))


SIGNS = {"answers": "✓", "half": "~", "cannot": "✗"}
COLOURS = {"answers": "#00694E", "half": "#8A5A00", "cannot": style.GREY}
MOST_ROWS, MOST_LETTERS = 20, 92
QUESTION_PX, NAMES_PX, FIRST_PX = 34, 96, 150


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
            self._command = self.add_number_table(0.025, 0.965, style.ACCENT)
            self._output = self.add_number_table(0.025, 0.905)
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
    picture = Picture(style.wide(NAMES_PX + QUESTION_PX * len(verdicts) + 34))
    width_px, height_px = picture.size_px
    column_px = (width_px - FIRST_PX - 60) / len(tools)
    places_px = {tool: FIRST_PX + (i + 0.5) * column_px for i, tool in enumerate(tools)}
    with style.our_settings():
        ax = style.pixel_paper(picture.figure.add_axes((0.0, 0.0, 1.0, 1.0)))
        for tool, x in places_px.items():
            style.write_slanted(ax, x, NAMES_PX - 14, tool)
        for row, (term, answers) in enumerate(verdicts.items()):
            y = NAMES_PX + (row + 0.5) * QUESTION_PX
            ax.text(24, y, term, va="center")
            for tool, x in places_px.items():
                level = answers[tool].level
                how = {"color": COLOURS[level], "fontweight": "normal" if level == "cannot" else "bold"}
                ax.text(x, y, SIGNS[level], ha="center", va="center", fontsize=13, **how)
        legend = "     ".join(f"{sign} {level}" for level, sign in SIGNS.items())
        ax.text(24, height_px - 18, legend, va="center", color=style.GREY, fontsize=style.SMALL_PT)
    picture.text = describe_tools(verdicts)
    return picture


def _parts(row: str) -> list[str]:
    """Return a row of output in parts that fit, as a terminal folds it."""
    row = row.expandtabs(8)
    return [row[start : start + MOST_LETTERS] for start in range(0, max(len(row), 1), MOST_LETTERS)]
