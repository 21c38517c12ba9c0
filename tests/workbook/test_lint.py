"""What can be seen in the text of a function is said with its line, and correct code is left alone."""

from __future__ import annotations

import linecache
import math
from pathlib import Path

import pytest
import yaml

from tflab.workbook.diagnosis import lint

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

COUNT = iter(range(1_000_000))


def written(source, name):
    """Return a function as a notebook's cell would make it: its text can be read."""
    file = f"<cell {next(COUNT)}>"
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    names = {"math": math}
    exec(compile(source, file, "exec"), names)
    return names[name]


KIND = CASES["function"]


def seen(old, new):
    assert old in KIND
    return lint.describe_function_text(written(KIND.replace(old, new), "kind"))


@pytest.mark.parametrize(("old", "new", "line", "text", "names"), CASES["says_something"])
def test_what_is_plain_to_see_is_said_with_its_line(old, new, line, text, names):
    for told, said in zip(seen(old, new), lint.TEXTS[text].filled(**names), strict=True):
        assert told.endswith(said) and str(line) in told


@pytest.mark.parametrize(("old", "new"), CASES["says_nothing"])
def test_nothing_is_said_of_what_means_what_it_says(old, new):
    assert seen(old, new) is None
    assert lint.describe_function_text(len) is None  # of which there is no text


def test_of_a_cell_it_is_said_whether_it_uses_what_is_given():
    assert "`e1_1`" in lint.describe_cell_text("post = 3.2", "e1_1").en
    assert lint.describe_cell_text("post = e1_1.a + 1.0\npost == 2.0", "e1_1") is None  # shown, as a cell's last line
    assert "not stored" in lint.describe_cell_text("name.replace('a', 'b')\npost = 1").en
    assert lint.describe_cell_text("post = (") is None
