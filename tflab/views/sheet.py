"""Write a drawing of lines, boxes and text as SVG and as PDF, the same bytes every time.

    LineMark, BoxMark, TextMark  -->  Sheet  -->  svg_from_sheet, pdf_from_sheet

Marks are in points, y pointing down. Letters have one width, so that the width of a text is known
before a font is loaded. Line styles repeat what colours say.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal
from unicodedata import east_asian_width
from xml.sax.saxutils import escape

from . import style

FONT_SIZE = 13.0
LETTER_WIDTH = 0.602  # of the font's size; the widest of the common monospaced fonts (DejaVu Sans Mono)
FONTS = "'DejaVu Sans Mono', Menlo, Consolas, monospace"

DASHES = {"solid": (), "dashed": (6.0, 4.0), "dotted": (1.5, 3.5)}
LineStyle = Literal["solid", "dashed", "dotted"]


@dataclass(frozen=True, slots=True)
class LineMark:
    """A line through `points`, with an arrowhead at its end if `arrow`."""

    points: tuple[tuple[float, float], ...]
    colour: str
    width: float = 1.5
    style: LineStyle = "solid"
    arrow: bool = False


@dataclass(frozen=True, slots=True)
class BoxMark:
    """A box with round corners, its top left corner at (x, y)."""

    x: float
    y: float
    width: float
    height: float
    colour: str
    fill: str = style.PAPER
    style: LineStyle = "solid"
    corner: float = 5.0


@dataclass(frozen=True, slots=True)
class TextMark:
    """A word that begins at x (or is centred on it), its middle at the height y."""

    x: float
    y: float
    text: str
    colour: str
    size: float = FONT_SIZE
    bold: bool = False
    centred: bool = False


Mark = LineMark | BoxMark | TextMark


@dataclass(frozen=True, slots=True)
class Sheet:
    """A finished drawing: its size, its marks from back to front, and what it says in words."""

    width: float
    height: float
    marks: tuple[Mark, ...]
    title: str
    description: str


def text_width(text: str, size: float = FONT_SIZE) -> float:
    """Return how wide a text is; a Hangul syllable is as wide as two letters."""
    letters = sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)
    return letters * LETTER_WIDTH * size


def svg_from_sheet(sheet: Sheet) -> str:
    """Return the drawing as SVG, which names no font file, script or address."""
    size = f"{_number(sheet.width)} {_number(sheet.height)}"
    width, height = size.split()
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size}" width="{width}" height="{height}"'
        f' style="max-width: 100%; height: auto" role="img" font-family="{FONTS}">',
        f"<title>{escape(sheet.title)}</title>",
        f"<desc>{escape(sheet.description)}</desc>",
        f'<rect x="0.5" y="0.5" width="{_number(sheet.width - 1)}" height="{_number(sheet.height - 1)}" rx="8"'
        f' fill="{style.PAPER}" stroke="{style.FAINT}"/>',
        *(_svg(mark) for mark in sheet.marks),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def pdf_from_sheet(sheet: Sheet) -> bytes:
    """Return the drawing as a PDF of one page; the same drawing gives the same bytes."""
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.figure import Figure

    file = io.BytesIO()
    no_date = {"CreationDate": None, "Creator": "tflab", "Producer": None, "Title": sheet.title}
    with style.our_settings():
        figure = Figure(figsize=(sheet.width / 72, sheet.height / 72))
        axes = figure.add_axes((0, 0, 1, 1))
        axes.set(xlim=(0, sheet.width), ylim=(sheet.height, 0))
        axes.axis("off")
        for layer, mark in enumerate(sheet.marks, start=1):
            for artist in _artists(mark):
                artist.set_zorder(layer)
                axes.add_artist(artist)
        FigureCanvasPdf(figure).print_figure(file, format="pdf", metadata=no_date)
    return file.getvalue()


def _svg(mark: Mark) -> str:
    if isinstance(mark, TextMark):
        weight = ' font-weight="bold"' if mark.bold else ""
        anchor = ' text-anchor="middle"' if mark.centred else ""
        baseline = _number(mark.y + 0.35 * mark.size)
        return (
            f'<text x="{_number(mark.x)}" y="{baseline}" font-size="{_number(mark.size)}" fill="{mark.colour}"'
            f'{weight}{anchor} xml:space="preserve">{escape(mark.text)}</text>'
        )
    dashes = " ".join(_number(length) for length in DASHES[mark.style])
    dash = f' stroke-dasharray="{dashes}"' if dashes else ""
    if isinstance(mark, BoxMark):
        return (
            f'<rect x="{_number(mark.x)}" y="{_number(mark.y)}" width="{_number(mark.width)}"'
            f' height="{_number(mark.height)}" rx="{_number(mark.corner)}" fill="{mark.fill}"'
            f' stroke="{mark.colour}" stroke-width="1.5"{dash}/>'
        )
    stroke = f'stroke="{mark.colour}" stroke-width="{_number(mark.width)}"'
    line = f'<polyline points="{_points(mark.points)}" fill="none" {stroke}{dash}/>'
    head = f'<polygon points="{_points(_arrowhead(mark))}" fill="{mark.colour}"/>' if mark.arrow else ""
    return line + head


def _artists(mark: Mark) -> list:
    from matplotlib.lines import Line2D
    from matplotlib.patches import FancyBboxPatch, Polygon
    from matplotlib.text import Text

    if isinstance(mark, TextMark):
        return [
            Text(
                mark.x, mark.y, mark.text,
                color=mark.colour, fontsize=mark.size, fontfamily="monospace", parse_math=False,
                fontweight="bold" if mark.bold else "normal",
                ha="center" if mark.centred else "left", va="center_baseline",
            )
        ]  # fmt: skip
    dash = (0, DASHES[mark.style]) if DASHES[mark.style] else "solid"
    if isinstance(mark, BoxMark):
        shape = f"round,pad=0,rounding_size={mark.corner}"
        return [
            FancyBboxPatch(
                (mark.x, mark.y), mark.width, mark.height,
                boxstyle=shape, facecolor=mark.fill, edgecolor=mark.colour, linewidth=1.5, linestyle=dash,
            )
        ]  # fmt: skip
    xs, ys = zip(*mark.points, strict=True)
    artists: list = [Line2D(xs, ys, color=mark.colour, linewidth=mark.width, linestyle=dash)]
    if mark.arrow:
        artists.append(Polygon(_arrowhead(mark), closed=True, facecolor=mark.colour, edgecolor="none"))
    return artists


def _arrowhead(line: LineMark) -> Sequence[tuple[float, float]]:
    """Return the corners of the head of a line whose last piece is horizontal or vertical."""
    length, half_width = 7.0, 3.5
    (x0, y0), (x1, y1) = line.points[-2:]
    if y0 == y1:
        back = x1 - length if x1 > x0 else x1 + length
        return ((x1, y1), (back, y1 - half_width), (back, y1 + half_width))
    back = y1 - length if y1 > y0 else y1 + length
    return ((x1, y1), (x1 - half_width, back), (x1 + half_width, back))


def _points(points: Sequence[tuple[float, float]]) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _number(value: float) -> str:
    return f"{value:.1f}".rstrip("0").rstrip(".")
