"""Compare what was built with what would be built, and report the first difference.

notebooks/en/03_target_and_source.ipynb: cell "lookup": prints '1.5 m' and would be '1.6 m'; run: tflab build 03_...
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..paths import chapter_of

__all__ = ["difference", "stale"]

SHOWN = 60


def stale(root: Path, built: Mapping[str, str]) -> list[str]:
    """Return a line for each file below `root` that is not as in `built` (path: text)."""
    lines = []
    for name, text in sorted(built.items()):
        path = root / name
        if not path.is_file():
            lines.append(f"{name}: is not there; run: tflab build {chapter_of(path)}")
            continue
        there = path.read_text(encoding="utf-8")
        if there != text:
            lines.append(f"{name}: {difference(there, text)}; run: tflab build {chapter_of(path)}")
    return lines


def difference(there: str, new: str) -> str:
    """Say in which cell two texts of a notebook first differ, and in what."""
    try:
        old_page, new_page = json.loads(there), json.loads(new)
        if "cells" in new_page:
            return _pages(old_page, new_page)
        return _values(old_page, new_page, "")
    except (ValueError, KeyError, TypeError, AttributeError):
        return "cannot be read as what it should be"


def _pages(old: dict, new: dict) -> str:
    old_names, new_names = ([cell.get("id") for cell in page["cells"]] for page in (old, new))
    for name in new_names:
        if name not in old_names:
            return f'cell "{name}" is missing'
    for name in old_names:
        if name not in new_names:
            return f'cell "{name}" is no longer in the source'
    if old_names != new_names:
        return "the cells stand in another order"
    for was, is_now in zip(old["cells"], new["cells"], strict=True):
        if was != is_now:
            return f'cell "{was["id"]}": {_cells(was, is_now)}'
    return _values(old["metadata"], new["metadata"], "metadata") if old != new else "is written in another way"


def _cells(old: dict, new: dict) -> str:
    if old.get("source") != new.get("source"):
        return f"reads {_parting(old['source'], new['source'])}"
    if old.get("outputs") != new.get("outputs"):
        said = [[line for output in cell["outputs"] for line in _text(output)] for cell in (old, new)]
        if said[0] != said[1]:
            return f"prints {_parting(*said)}"
        return "draws another picture"
    key = next(key for key in sorted({*old, *new}) if old.get(key) != new.get(key))
    return f"its {key} is {_short(old.get(key))} and would be {_short(new.get(key))}"


def _text(output: dict) -> list[str]:
    data = output.get("data", {})
    texts = [value for mime, value in sorted(data.items()) if mime.startswith("text/")]
    texts += [output[key] for key in ("text", "evalue") if key in output]
    return "".join("".join(text) for text in texts).splitlines(keepends=True)


def _parting(old: list[str], new: list[str]) -> str:
    """Say which is the first line that differs."""
    for was, is_now in zip([*old, ""], [*new, ""], strict=False):
        if was != is_now:
            return _both(was, is_now)
    return "other lines"


def _values(old: Any, new: Any, where: str) -> str:
    """Say where two values of JSON first differ."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted({*old, *new}):
            if old.get(key) != new.get(key):
                return _values(old.get(key), new.get(key), f"{where}.{key}".lstrip("."))
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for number, (was, is_now) in enumerate(zip(old, new, strict=True)):
            if was != is_now:
                return _values(was, is_now, f"{where}[{number}]")
    if old == new:
        return "is written in another way"
    return f"{where} is {_short(old)} and would be {_short(new)}"


def _both(old: str, new: str) -> str:
    """Show two lines, from a little before the letter in which they differ."""
    same = next((i for i, (one, other) in enumerate(zip(old, new, strict=False)) if one != other), 0)
    begin = max(0, same - SHOWN // 3)
    return " and would be ".join(_short(("..." if begin else "") + text[begin:]) for text in (old, new))


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."
