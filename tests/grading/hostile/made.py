"""Objects, patches, outcomes and files that are made by the dozen: what each is, and how it is handed in."""

from __future__ import annotations

import gzip

from .recipe import WRONG, Honest, Notebook, as_bytes, edited, function, own_cell, page, raw, recipes, value

__all__ = ["MADE"]

# Expressions for an object, each alone, in each part, and as a value.
PAGE = page("made")
OBJECTS = PAGE["objects"]

PATCHES = PAGE["patches"]

KINDS = ("raises", "changed", "object", "unanswered", "tuple", "set", "array", "Transform", "StampedTransform", "message",
         "Time", "Patient", "BufferCore", "sealed")  # fmt: skip
OUTCOMES = (
    "import itertools, tflab.grading.kernels.probe_answer as p\nsend = p._send\nodd = itertools.cycle([None, [], {{}}, 'x', 0, [[]], ['a', {{}}], {{'a': 1}}, [[0, 0, 0], [0, 0, 0, 1]]])\np._send = lambda identity, plain: send(identity, [{{{kind!r}: next(odd)}} for _ in plain])\n"
    + WRONG.replace("{", "{{")
)


def _second_list(notebook: Notebook, honest: Honest) -> None:
    notebook["metadata"]["outputs"] = {"cells": []}
    notebook["outputs"] = notebook["cells"]


def _brackets(notebook: Notebook, honest: Honest) -> None:
    notebook["cells"][3:3] = [own_cell("x = " + "(" * 5000, "open"), own_cell("x = " + "[" * 190 + "]" * 190, "deep")]


def _capitals(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        cell["id"] = cell["id"].upper()


MADE = [
    *recipes("made"),
    *(function(f"{name}, alone", f"def F(transform):\n    return {made}") for name, made in OBJECTS.items()),
    *(function(f"{name}, in each part", f"def F(transform):\n    odd = {made}\n    return {{k: odd for k in ('x', 'y', 'yaw')}}") for name, made in list(OBJECTS.items())[::3]),
    *(value(f"{name}, as a value", f"odd = {made}\nV = {{'base_link': odd, 'map': odd}}") for name, made in list(OBJECTS.items())[1::5]),
    *(function(f"patches {name}", WRONG + code, keeps="any") for name, code in PATCHES.items()),
    *(function(f"every outcome is of the kind {kind}", OUTCOMES.format(kind=kind), keeps="any") for kind in KINDS),
    raw("lists behind the cells", lambda h: as_bytes(h.fresh())[:-1] + b', "x": ' + b"[" * 100_000),
    raw("two notebooks in one file", lambda h: as_bytes(h.fresh()) * 2),
    raw("packed by gzip", lambda h: gzip.compress(as_bytes(h.fresh()))),
    edited("a second list of cells, called outputs", _second_list),
    edited("brackets in cells of its own", _brackets),
    edited("ids in capitals", _capitals),
]  # fmt: skip
