"""A small workbook for tests, which can be changed as a new version changes it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import pytest


@dataclass(frozen=True)
class HandedOut:
    """A folder that takes the place of tflab's own workbook."""

    root: Path

    def write(self, name: str, **sources: str) -> None:
        """Put a notebook there, with a cell of each name."""
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(notebook(**sources), encoding="utf-8")


def notebook(**sources: str) -> str:
    """Return a notebook with a cell of each name: prose if it starts with a #, else code."""
    cells = []
    for name, source in sources.items():
        cell = {"id": name.replace("_", "-"), "metadata": {"name": name}, "source": source.splitlines(keepends=True)}
        if source.startswith("#"):
            cells.append(cell | {"cell_type": "markdown"})
        else:
            cells.append(cell | {"cell_type": "code", "execution_count": None, "outputs": []})
    return json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5})


@pytest.fixture
def handed_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> HandedOut:
    """A workbook of one page and one exercise in two languages."""
    small = HandedOut(tmp_path / "handed_out")
    for language in ("en", "ko"):
        small.write(f"notebooks/{language}/00_start.ipynb", title="# Start", hello="print('hello')")
        small.write(f"exercises/{language}/E03_small.ipynb", title="# E3", answer="x = ...", check="check('E3.1', x)")
        small.write(f"solutions/{language}/03_small.ipynb", title="# E3", answer="x = 1", check="check('E3.1', x)")
    (small.root / "solutions" / "tasks" / "03_small").mkdir(parents=True)
    monkeypatch.setenv("TFLAB_WORKBOOK", str(small.root))
    return small
