"""Files that are no notebooks, or old ones, or in other encodings."""

from __future__ import annotations

import json

from .recipe import Honest, Notebook, as_bytes, edited, own_cell, raw, value

__all__ = ["FILES"]


def _without_ids(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        del cell["id"]
    notebook["nbformat_minor"] = 4


def _broken_metadata(notebook: Notebook, honest: Honest) -> None:
    notebook["metadata"] = []
    notebook["cells"][0]["metadata"] = "none"
    notebook["cells"].insert(1, {"cell_type": 3})
    notebook["cells"].insert(2, None)


def _as_colab(notebook: Notebook, honest: Honest) -> None:
    notebook["nbformat_minor"] = 0
    notebook["metadata"] = {"colab": {"provenance": []}, "kernelspec": {"name": "python3", "display_name": "Python 3"}}
    for number, cell in enumerate(notebook["cells"]):
        cell.pop("id", None)
        cell["metadata"] = {"id": f"aB{number}"}


def _as_vs_code(notebook: Notebook, honest: Honest) -> None:
    for number, cell in enumerate(notebook["cells"]):
        cell["id"] = f"{number:08x}"
        cell["metadata"] = {"vscode": {"languageId": "python"}}


FILES = [
    raw("half a file", lambda h: as_bytes(h.notebook)[:400]),
    raw("a picture", lambda h: b"\x89PNG\r\n\x1a\n" + bytes(range(256))),
    raw("a web page", lambda h: b"<!DOCTYPE html><html><body>Please log in</body></html>"),
    raw("far too large", lambda h: as_bytes(h.notebook) + b" " * 110_000_000),
    raw(
        "Windows line ends",
        lambda h: json.dumps(h.notebook, indent=1).replace("\n", "\r\n").encode(),
        "all",
    ),
    raw("blanks before and after", lambda h: b"\n\n  " + as_bytes(h.notebook) + b"\n\n", "all"),
    edited("cells without ids", _without_ids),
    edited("metadata of the wrong type", _broken_metadata),
    edited(
        "a kernel for Julia",
        lambda n, h: n["metadata"].update(kernelspec={"name": "julia-1.10", "language": "julia"}),
    ),
    edited("no kernel at all", lambda n, h: n["metadata"].pop("kernelspec", None)),
    edited("a letter that is half a pair", lambda n, h: n["cells"].append(own_cell("# \ud800")) and None),
    edited("a NUL in a comment of its own", lambda n, h: n["cells"].append(own_cell("# \x00"))),
    value("halves of letters", "V = {'base_link': '\\ud800', 'map': '\\udfff', '\\ud800': 1}"),
    edited("saved by Colab", _as_colab),
    edited("saved by VS Code", _as_vs_code),
]  # fmt: skip
