"""Who is left, and which question would tell the most?  Suspects by checks, as a table that fills.

                     delay /scan   hz /odom    scan header
    laser clock      [ ahead    ]  //////////  //////////     asked: what each suspect would have said
    late network     --- card ---  //////////  //////////     struck: it would have said something else
    slow odometry    --- card ---  //////////  //////////     hatched: not asked yet

A column in which all suspects would say the same is a question that tells nothing.
The field calls the table a fault dictionary, and the choice of the next column
*best-first test selection*.
"""

from __future__ import annotations

from collections.abc import Mapping

from . import style
from .picture import Picture

__all__ = ["SuspectsPicture", "describe_suspects", "draw_suspects"]

ROW_PX, HEAD_PX, BORDER_PX, SLANT_PX = 30, 112, 14, 96
AS_USUAL = "as on the card"

Findings = Mapping[str, Mapping[str, str]]  # of each suspect what it would say to each check


def left_of(findings: Findings, asked: Mapping[str, str]) -> list[str]:
    """Return the suspects that would have said what was said."""
    return [name for name, row in findings.items() if all(row[check] == said for check, said in asked.items())]


def describe_suspects(findings: Findings, asked: Mapping[str, str]) -> str:
    """Return the same in words: a line for each suspect, then what was said, and how each other check would split."""
    left = left_of(findings, asked)
    width = max(map(len, findings))
    lines = [f"{len(left)} of {len(findings)} suspects left"]
    for name, row in findings.items():
        struck = next((check for check, said in asked.items() if row[check] != said), None)
        why = f"struck: {check_said(struck, row[struck])}" if struck else "left"
        lines.append(f"  {name:<{width}}  {why}")
    lines += [f"asked: {check}: {said}" for check, said in asked.items()]
    for check in next(iter(findings.values())):
        groups = {findings[name][check] for name in left}
        if check not in asked:
            lines.append(
                f"not asked: {check}: " + (f"would tell {len(groups)} apart" if len(groups) > 1 else "nothing")
            )
    return "\n".join(lines)


def check_said(check: str, kind: str) -> str:
    """Return what a suspect would have said to a check."""
    return f"{check} would be {kind}"


class SuspectsPicture(Picture):
    """The table; `tell(asked)` fills in what was asked by now."""

    def __init__(self, findings: Findings, asked: Mapping[str, str]) -> None:
        self._findings = findings
        self._checks = list(next(iter(findings.values())))
        self._names_px = style.room_px(findings) + BORDER_PX
        height_px = HEAD_PX + ROW_PX * len(findings) + BORDER_PX
        super().__init__((style.WIDE[0], height_px / style.SCREEN_DPI))
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
        left, cell_px = left_of(self._findings, asked), self._cell_px
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
