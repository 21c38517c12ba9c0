"""Draw tables for a diagnosis: suspects by checks, owners of edges, tools by questions.

suspects   a fault dictionary: what each suspect would show in each check
owners     the node, the data, the switch and the rate of each edge (the authority of a transform)
tools      which tool answers which question, and what it prints
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

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
        why = f"struck: {expected_result_text(struck, row[struck])}" if struck else "left"
        lines.append(f"  {name:<{width}}  {why}")
    lines += [f"asked: {check}: {said}" for check, said in asked.items()]
    for check in next(iter(findings.values())):
        groups = {findings[name][check] for name in left}
        if check not in asked:
            lines.append(
                f"not asked: {check}: " + (f"would tell {len(groups)} apart" if len(groups) > 1 else "nothing")
            )
    return "\n".join(lines)


def expected_result_text(check: str, kind: str) -> str:
    """Return what a suspect would have said to a check."""
    return f"{check} would be {kind}"


class SuspectsPicture(Picture):
    """The table; `tell(asked)` fills in what was asked by now."""

    def __init__(self, findings: Findings, asked: Mapping[str, str]) -> None:
        self._findings = findings
        self._checks = list(next(iter(findings.values())))
        self._names_px = style.names_width_px(findings) + BORDER_PX
        height_px = HEAD_PX + ROW_PX * len(findings) + BORDER_PX
        super().__init__(style.wide(height_px))
        with style.our_settings():
            self.ax = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
            self._height_px, self._width_px = height_px, style.WIDE[0] * style.SCREEN_DPI
        self.tell(asked)

    def tell(self, asked: Mapping[str, str]) -> None:
        """Show the table after these checks: of each what was said."""
        self.text = describe_suspects(self._findings, asked)
        with style.our_settings():
            self.ax.clear()
            self.ax.set_axis_off()
            self.ax.set_xlim(0, self._width_px)
            self.ax.set_ylim(self._height_px, 0)
            self._draw(asked)
        self.redraw_all()

    def _draw(self, asked: Mapping[str, str]) -> None:
        left, cell_px = remaining_suspects(self._findings, asked), self._cell_px
        for column, check in enumerate(self._checks):
            x = self._names_px + (column + 0.5) * cell_px
            weight = "bold" if check in asked else "normal"
            self.ax.text(x, HEAD_PX - 8, check, rotation=32, ha="left", va="bottom", rotation_mode="anchor",
                         fontsize=style.SMALL_PT, color=style.INK, weight=weight)  # fmt: skip
        for row, (name, kinds) in enumerate(self._findings.items()):
            y, is_left = HEAD_PX + row * ROW_PX, name in left
            colour = style.INK if is_left else style.GREY
            self.ax.text(
                BORDER_PX, y + ROW_PX / 2, name, va="center", color=colour, weight="bold" if is_left else "normal"
            )
            for column, check in enumerate(self._checks):
                self._cell(self._names_px + column * cell_px, y, kinds[check], asked.get(check))
            if not is_left:
                self.ax.plot(
                    [BORDER_PX - 4, self._width_px - SLANT_PX], [y + ROW_PX / 2] * 2, color=style.GREY, linewidth=1.4
                )

    def _cell(self, x: float, y: float, kind: str, said: str | None) -> None:
        from matplotlib.patches import Rectangle

        box = Rectangle((x + 2, y + 2), self._cell_px - 4, ROW_PX - 4, facecolor=style.PAPER, edgecolor=style.FAINT)
        self.ax.add_patch(box)
        if said is None:
            box.set_hatch("////")
            return
        fits = said == kind
        box.set_edgecolor(style.ACCENT if fits else style.FAINT)
        box.set_linewidth(1.8 if fits else 0.8)
        text = "=" if fits else "≠"
        self.ax.text(x + self._cell_px / 2, y + ROW_PX / 2, text, ha="center", va="center",
                     color=style.ACCENT if fits else style.GREY, weight="bold")  # fmt: skip

    @property
    def _cell_px(self) -> float:
        return (self._width_px - self._names_px - SLANT_PX) / len(self._checks)


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


OWNER_PX, HEADING_PX, RIM_PX = 30, 44, 16
COLUMNS = (("edge", 0.0), ("owner", 0.29), ("source", 0.50), ("switch", 0.67), ("rate", 0.83))


class Owner(NamedTuple):
    """Who says one edge.

    Attributes:
        edge: "parent -> child".
        node: who; "" if nobody does.
        source: of which data it is made.
        switch: what turns it off; "" if nothing does.
        rate: how often it comes, "20.2 Hz" or "static".
    """

    edge: str
    node: str
    source: str = ""
    switch: str = ""
    rate: str = ""


def describe_owners(owners: Sequence[Owner]) -> str:
    """Return the table in words: a line for each owner, and what is wrong with it."""
    rows = [[*_owner_cells(owner), _owner_fault(owner, owners)] for owner in owners]
    widths = [max(len(row[column]) for row in rows) for column in range(6)]
    return "\n".join(
        "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows
    )


def draw_owners(owners: Sequence[Owner | tuple[str, ...]]) -> Picture:
    """Draw the table of owners.

    Args:
        owners: a row for each that says an edge, and one without a node for an edge that nobody says.

    Raises:
        ValueError: there are no rows.
    """
    if not owners:
        raise ValueError(
            "a table of owners needs a row, such as ('map -> odom', 'amcl', 'scan', 'tf_broadcast', '10 Hz')"
        )
    owners = [Owner(*owner) for owner in owners]
    height_px = HEADING_PX + OWNER_PX * len(owners) + RIM_PX
    picture = Picture(style.wide(height_px))
    picture.text = describe_owners(owners)
    width_px = style.WIDE[0] * style.SCREEN_DPI
    with style.our_settings():
        ax = picture.figure.add_axes((RIM_PX / width_px, 0.0, 1.0 - 2 * RIM_PX / width_px, 1.0))
        ax.set_axis_off()
        ax.set_xlim(0.0, 1.0)
        ax.set_ylim(height_px, 0.0)
        for name, x in COLUMNS:
            ax.text(x, HEADING_PX / 2, name, va="center", color=style.GREY, fontsize=style.SMALL_PT)
        for number, owner in enumerate(owners):
            y, fault = HEADING_PX + (number + 0.5) * OWNER_PX, _owner_fault(owner, owners)
            ax.plot([0.0, 1.0], [y - OWNER_PX / 2] * 2, color=style.HAIR, linewidth=0.8)
            colour = style.ACCENT if fault else style.INK
            for cell, (_, x) in zip(_owner_cells(owner), COLUMNS, strict=True):
                ax.text(
                    x, y, cell, va="center", color=colour, weight="bold" if fault else "normal", fontsize=style.SMALL_PT
                )
            ax.text(1.0, y, fault, va="center", ha="right", color=style.ACCENT, weight="bold", fontsize=style.SMALL_PT)
    return picture


def _owner_cells(owner: Owner) -> tuple[str, ...]:
    return (owner.edge, owner.node or "nobody", owner.source or "-", owner.switch or "-", owner.rate or "-")


def _owner_fault(owner: Owner, owners: Sequence[Owner]) -> str:
    if not owner.node:
        return "! 0"
    count = Counter(other.edge for other in owners)[owner.edge]
    return f"! {count}" if count > 1 else ""


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
    width_px = style.WIDE[0] * style.SCREEN_DPI
    height_px = NAMES_PX + QUESTION_PX * len(verdicts) + 34
    picture = Picture(style.wide(height_px))
    column_px = (width_px - FIRST_PX - 60) / len(tools)
    with style.our_settings():

        def write(x_px: float, y_px: float, text: str, **how: object) -> None:
            picture.figure.text(x_px / width_px, 1 - y_px / height_px, text, va="center", **how)

        for i, tool in enumerate(tools):
            write(FIRST_PX + (i + 0.5) * column_px, NAMES_PX - 22, tool, rotation=24, ha="left", rotation_mode="anchor")
        for j, (term, row) in enumerate(verdicts.items()):
            y_px = NAMES_PX + (j + 0.5) * QUESTION_PX
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
