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


@pytest.mark.parametrize(
    ("old", "new", "line", "said"),
    [
        ('"future" in text', '"future" or "Future" in text', 8, lint.TEXTS["holds_always"].filled(word='"future"')),
        ('"future" in text', '"into" and "future" in text', 8, lint.TEXTS["asks_nothing"].filled(word='"into"')),
        ('"future" in text', '("future" or "later") in text', 8, lint.TEXTS["one_always"].filled(word='"future"')),
        ('"future" in text', 'text.find("future")', 8, lint.TEXTS["found_nowhere"]),
        ('"future" in text', '"future" in text == True', 8, lint.TEXTS["a_chain"]),
        ('"past" in text', '"future" in text', 10, lint.TEXTS["asked_above"]),
        ("except KeyError", "except Exception", 7, lint.TEXTS["never_reached"].filled(name="Exception")),
        ("except KeyError", "except (KeyError or IndexError)", 5, lint.TEXTS["first_class_alone"]),
        ("    words =", '    finally:\n        return "ok"\n    words =', 14, lint.TEXTS["goes_over_all"]),
        ("words.sort()", "return words\n    words.sort()", 15, lint.TEXTS["after_the_end"]),
        ('return "key"', 'print("key")', 6, lint.TEXTS["only_printed"]),
        ('return "past"', 'print("past")', 11, lint.TEXTS["only_printed"]),
        ("words.sort()", "words.sort", 14, lint.TEXTS["not_called"]),
        ("words.sort()", "sorted(words)", 14, lint.TEXTS["not_kept"]),
        ("words.sort()", 'words == ["ok"]', 14, lint.TEXTS["not_set"]),
        ("words.sort()", "words = words.sort()", 14, lint.TEXTS["gives_none"].filled(name="sort")),
        ("words.sort()", "words + [text]", 14, lint.TEXTS["not_kept"]),
        ('"past" in text', 'text is "past"', 10, lint.TEXTS["same_object"]),
        (
            "words.sort()",
            "half = len(words) / 2\n    wait_s = 3.5\n    half = wait_s // 2",
            16,
            lint.TEXTS["drops_fraction"],
        ),
        ("str(error)", "str(LookupError)", 12, lint.TEXTS["text_of_a_class"]),
        ('"past" in text', "text == math.nan", 10, lint.TEXTS["equals_nothing"]),
        ('"past" in text', 'float("nan") in [text]', 10, lint.TEXTS["equals_nothing"]),
        ('"past" in text', 'text == "True"', 10, lint.TEXTS["text_of_a_bool"].filled(word="True")),
        (
            "text.split()",
            'text.lstrip("map/").split()',
            13,
            lint.TEXTS["strips_letters"].filled(method="lstrip", word="map/"),
        ),
    ],
)
def test_what_is_plain_to_see_is_said_with_its_line(old, new, line, said):
    told = seen(old, new)
    for text, words in zip(told, said, strict=True):
        assert text.endswith(words) and str(line) in text


@pytest.mark.parametrize(("old", "new"), CASES["says_nothing"])
def test_nothing_is_said_of_what_means_what_it_says(old, new):
    assert seen(old, new) is None
    assert lint.describe_function_text(len) is None  # of which there is no text


def test_of_a_cell_it_is_said_whether_it_uses_what_is_given():
    assert "`e1_1`" in lint.describe_cell_text("post = 3.2", "e1_1").en
    assert lint.describe_cell_text("post = e1_1.a + 1.0\npost == 2.0", "e1_1") is None  # shown, as a cell's last line
    assert "not stored" in lint.describe_cell_text("name.replace('a', 'b')\npost = 1").en
    assert lint.describe_cell_text("post = (") is None
