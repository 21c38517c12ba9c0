"""Write the reference of the code from its docstrings, by pdoc.

    tflab/core/*.py --pdoc--> reference/tflab/core.html

An API reference: nothing of it is written twice.  Of a room there is what its face
names, of the engine every page, for they are its textbook.
"""

from __future__ import annotations

import re
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from unittest.mock import patch
from warnings import catch_warnings, simplefilter

from tflab import core

__all__ = ["HIDDEN", "sentences_kept", "write_reference"]

HIDDEN = ("tflab.__main__", "tflab.grading.kernels", "tflab.grading.plugin")
SECTIONS = ("Args", "Attributes", "Returns", "Raises", "Yields")
OF_NO_FIELD = re.compile(r"Alias for field number \d+")  # what Python says of a tuple's field if nobody else does
OUR_STYLE = Path(__file__).with_name("static") / "reference"


def write_reference(folder: Path) -> Path:
    """Write the reference into a folder; return its first page.

    Raises:
        ModuleNotFoundError: pdoc is not installed.
    """
    import pdoc
    from pdoc.docstrings import google

    def _sections(docstring: str) -> str:
        return google("" if OF_NO_FIELD.fullmatch(docstring) else sentences_kept(docstring))

    pdoc.render.configure(
        docformat="google", show_source=False, footer_text="tflab", search=True, template_directory=OUR_STYLE
    )
    with (
        patch("pdoc.docstrings.google", _sections),
        patch.object(core, "__all__", [*core.__all__, *_pages_of(core)]),
        catch_warnings(),
    ):  # a name that only a type checker imports stays a word, without a link
        simplefilter("ignore", UserWarning)
        pdoc.pdoc("tflab", *(f"!{name}" for name in HIDDEN), output_directory=folder)
    return folder / "tflab.html"


def _pages_of(room: ModuleType) -> list[str]:
    """Return a room's pages that its face does not name: of the engine, they are what is to be read."""
    return sorted({page.name for page in iter_modules(room.__path__)} - set(room.__all__))


def sentences_kept(docstring: str) -> str:
    """Return a docstring whose sentences that end in a colon are no sections of Google's, whatever stands below."""
    return re.sub(rf"^(?!(?:{'|'.join(SECTIONS)}):)([A-Z][A-Za-z ]*):$", r"\1: ", docstring, flags=re.MULTILINE)
