"""Hold the sizes, fonts and colours of all figures, and format numbers.

    x  solid   -------->  x     reddish
    y  dashed  - - - -->  y     greenish
    z  dotted  .......->  z     blue

An axis can be recognised by its letter, its line and its colour. Everything else is ink and grey,
and one accent marks what is being taught. A figure is a card of light paper, the same on a light
and on a dark page. `our_settings()` sets matplotlib's settings only while a figure is drawn, for
one thread at a time, because they are global. The colours are those of Okabe and Ito.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from threading import RLock
from typing import TYPE_CHECKING

from tflab.core import format_stamp

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

AXES = ("x", "y", "z")
AXIS_COLOURS = {"x": "#D55E00", "y": "#009E73", "z": "#0072B2"}
AXIS_LINES = {"x": "solid", "y": (0, (4.0, 1.6)), "z": (0, (1.0, 1.1))}

ACCENT = "#8E2A7C"  # the one thing being taught
INK = "#1F2328"  # text, and what is true
GREY = "#63696F"  # second thoughts: units, captions
FAINT = "#B9BEC4"  # guides
HAIR = "#E4E6E9"  # grids, borders
PAPER = "#FDFDFB"  # the card
SHADE = "#EAECE8"  # a quiet area on the card

WIDE = (7.6, 3.8)  # [inch], 100 screen pixels each
TALL = (7.6, 5.2)

TEXT_PT = 9.5
SMALL_PT = 8.5
TITLE_PT = 11.0

SCREEN_DPI = 100  # how large a figure stands on the page
PRINT_DPI = 150  # how finely it is drawn
LIVE_DPI = SCREEN_DPI  # while a slider moves
SMALLEST_DPI = 8  # that letters can still be drawn at

_SETTINGS = {
    "font.family": ["sans-serif"],
    "font.sans-serif": ["DejaVu Sans"],
    "font.monospace": ["DejaVu Sans Mono"],
    "font.size": TEXT_PT,
    "text.usetex": False,
    "text.color": INK,
    "text.hinting": "no_hinting",
    "text.antialiased": True,
    "axes.unicode_minus": False,
    "lines.dash_capstyle": "butt",
    "lines.solid_capstyle": "butt",
    "lines.scale_dashes": True,
    "lines.antialiased": True,
    "patch.antialiased": True,
    "hatch.linewidth": 0.8,
    "path.effects": [],
    "path.sketch": None,
    "path.simplify": True,
    "path.snap": True,
    "figure.constrained_layout.use": False,
    "figure.autolayout": False,
    "axes.facecolor": "none",
    "axes.edgecolor": FAINT,
    "axes.labelcolor": GREY,
    "axes.linewidth": 0.8,
    "axes.axisbelow": True,
    "axes.grid": False,
    "axes.titlesize": TITLE_PT,
    "axes.labelsize": SMALL_PT,
    "axes.xmargin": 0.0,
    "axes.ymargin": 0.0,
    "xtick.labelsize": SMALL_PT,
    "ytick.labelsize": SMALL_PT,
    "xtick.color": FAINT,
    "ytick.color": FAINT,
    "xtick.labelcolor": GREY,
    "ytick.labelcolor": GREY,
    "xtick.direction": "out",
    "ytick.direction": "out",
}

ONE_AT_A_TIME = RLock()  # held by a thread while it moves a figure, draws it or reads it


@contextmanager
def our_settings() -> Iterator[None]:
    """Hold matplotlib's settings as our figures need them, for one thread, and give back the learner's."""
    from matplotlib import rc_context

    with ONE_AT_A_TIME, rc_context(_SETTINGS):
        yield


def figure(size_inch: tuple[float, float] = WIDE) -> Figure:
    """Return an empty card of `size_inch` (width, height), unknown to pyplot, so nobody needs to close it."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.patches import FancyBboxPatch

    with our_settings():
        fig = Figure(figsize=size_inch, dpi=SCREEN_DPI, facecolor="none", edgecolor="none")
        FigureCanvasAgg(fig)
        width, height = size_inch
        card = FancyBboxPatch(
            (0.02, 0.02), width - 0.04, height - 0.04,
            boxstyle="round,pad=0,rounding_size=0.09", facecolor=PAPER, edgecolor=HAIR, linewidth=1.0,
            transform=fig.dpi_scale_trans, zorder=-100,
        )  # fmt: skip
        fig.add_artist(card)
    return fig


def shorten_card(fig: Figure, height_inch: float) -> None:
    """Let a card end `height_inch` below its upper edge; below, the page is seen."""
    card = fig.artists[0]
    _, full = fig.get_size_inches()
    card.set_y(full - height_inch + 0.02)
    card.set_height(height_inch - 0.04)


def wide(height_px: float) -> tuple[float, float]:
    """Return the size of a card of the usual width and this height [inch]."""
    return (WIDE[0], height_px / SCREEN_DPI)


def pixel_paper(ax: Axes) -> Axes:
    """Empty axes that fill a card, and let them count screen pixels from its upper left corner; return them."""
    width, height = ax.figure.get_size_inches() * SCREEN_DPI
    ax.clear()
    ax.set_axis_off()
    ax.set(xlim=(0.0, width), ylim=(height, 0.0))
    return ax


def write_slanted(ax: Axes, x: float, y: float, text: str, **how: object) -> None:
    """Write the heading of a narrow column, slanted upwards from (x, y)."""
    ax.text(x, y, text, rotation=32, ha="left", va="bottom", rotation_mode="anchor", fontsize=SMALL_PT, **how)


def hide_spines(ax: Axes, *sides: str) -> None:
    """Hide the lines at these sides of a graph: "left", "right", "top", "bottom"."""
    for side in sides:
        ax.spines[side].set_visible(False)


def name_plane(ax: Axes, frame: str) -> None:
    """Name the axes of a drawing from above: the x and y of a frame [m]."""
    hide_spines(ax, "top", "right")
    ax.set_xlabel(f"x in {frame} [m]", loc="right")
    ax.set_ylabel(f"y in {frame} [m]", loc="top")


def label_rows(ax: Axes, names: Sequence[str], size_pt: float = TEXT_PT) -> None:
    """Make one row for each name, from the top, and a time axis below."""
    ax.set_ylim(len(names) - 0.5, -0.5)
    hide_spines(ax, "left", "right", "top")
    ax.set_yticks(range(len(names)), names)
    ax.tick_params(axis="y", length=0, pad=10, labelcolor=INK, labelsize=size_pt)


def names_width_px(names: Iterable[str], at_least_px: int = 110) -> int:
    """Return the width of a column for these names, the longest included [screen pixels]."""
    return max(at_least_px, *(42 + 7 * len(name) for name in names))


def fmt(value: float, unit: str = "m", digits: int = 3) -> str:
    """Return a number for people: fixed decimals, no negative zero, its unit: fmt(-0.0004) == "0.000 m"."""
    return f"{round(float(value), digits) + 0.0:.{digits}f} {unit}".rstrip()


def fmt_name(name: str) -> str:
    """Return a frame's name so that what is odd about it shows: fmt_name("laser ") == "'laser '".

    Spaces, invisible characters, and letters of other scripts among Latin ones (which may look the same) are odd.
    """
    is_mixed = not name.isascii() and any(letter.isascii() and letter.isalpha() for letter in name)
    if is_mixed:
        return ascii(name)
    return repr(name) if not name or not name.isprintable() or " " in name else name


def fmt_all(values: Sequence[float], unit: str = "m", digits: int = 3) -> str:
    """Return several numbers with one unit: fmt_all((1, 2)) == "(1.000, 2.000) m"."""
    return f"({', '.join(fmt(value, '', digits) for value in values)}) {unit}".rstrip()


def fmt_stamp(stamp_ns: int) -> str:
    """Return a stamp or a duration [ns] for people: fmt_stamp(1_500_000_000) == "1.500 s"."""
    return f"{format_stamp(stamp_ns, 3)} s"
