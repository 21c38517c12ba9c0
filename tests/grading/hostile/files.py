"""Files that are no notebooks, or old ones, or in other encodings."""

from __future__ import annotations

import json

from .recipe import Honest, Notebook, Recipe, as_bytes, edited, own_cell, raw, value

__all__ = ["FILES"]


def _third_format(notebook: Notebook) -> Notebook:
    cells = []
    for cell in notebook["cells"]:
        old = {"cell_type": cell["cell_type"], "metadata": {**cell["metadata"], "name": cell["id"]}}
        text = cell["source"] if isinstance(cell["source"], str) else "".join(cell["source"])
        old |= {"input": text, "language": "python", "outputs": []} if cell["cell_type"] == "code" else {"source": text}
        cells.append(old)
    return {
        "metadata": {"name": ""},
        "nbformat": 3,
        "nbformat_minor": 0,
        "worksheets": [{"cells": cells, "metadata": {}}],
    }


def _without_ids(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        del cell["id"]
    notebook["nbformat_minor"] = 4


def _lists(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        text = cell["source"] if isinstance(cell["source"], str) else "".join(cell["source"])
        cell["source"] = text.splitlines(keepends=True)


def _broken_metadata(notebook: Notebook, honest: Honest) -> None:
    notebook["metadata"] = []
    notebook["cells"][0]["metadata"] = "none"
    notebook["cells"].insert(1, {"cell_type": 3})
    notebook["cells"].insert(2, None)


def _comment(notebook: Notebook, honest: Honest, text: str) -> None:
    cell = honest.cell(notebook, honest.function_task)
    cell["source"] = f"# {text}\n" + "".join(cell["source"])


def _in_korean(honest: Honest) -> Notebook:
    notebook = honest.fresh()
    _comment(notebook, honest, "역변환을 구합니다")
    return notebook


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
    raw("an empty file", lambda h: b""),
    raw("half a file", lambda h: as_bytes(h.notebook)[:400]),
    raw("a picture", lambda h: b"\x89PNG\r\n\x1a\n" + bytes(range(256))),
    raw("a list", lambda h: b"[]"),
    raw("JSON of no notebook", lambda h: b'{"cells": {"a": 1}, "nbformat": 4}'),
    raw("a hundred thousand brackets", lambda h: b"[" * 100_000),
    raw("a number of a million digits", lambda h: b'{"nbformat": ' + b"9" * 1_000_000 + b"}"),
    raw("a web page", lambda h: b"<!DOCTYPE html><html><body>Please log in</body></html>"),
    raw("far too large", lambda h: as_bytes(h.notebook) + b" " * 110_000_000),
    raw("a byte order mark", lambda h: b"\xef\xbb\xbf" + as_bytes(h.notebook), "all"),
    raw("UTF-16", lambda h: as_bytes(h.notebook, "utf-16"), "all"),
    raw("code page 949", lambda h: as_bytes(_in_korean(h), "cp949"), "all"),
    raw(
        "Windows line ends",
        lambda h: json.dumps(h.notebook, indent=1).replace("\n", "\r\n").encode(),
        "all",
    ),
    raw("blanks before and after", lambda h: b"\n\n  " + as_bytes(h.notebook) + b"\n\n", "all"),
    raw("escaped letters", lambda h: json.dumps(_in_korean(h), ensure_ascii=True).encode(), "all"),
    Recipe("the third format", lambda h: _third_format(h.fresh())),
    edited("cells without ids", _without_ids),
    edited("sources as lists of lines", _lists),
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
