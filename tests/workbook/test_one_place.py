"""The one place in a function that is wrong: found, said truly, and looked for in nothing that is better left alone."""

from __future__ import annotations

import linecache
import math

import pytest

from tflab.workbook import check, checks
from tflab.workbook.answers.forms import Choice, Number, Sequence, Vector
from tflab.workbook.answers.values import outcome_of, to_plain
from tflab.workbook.paths import workbook_data
from tflab.workbook.repairing import edits
from tflab.workbook.repairing.one_place import LOOK, said_of_one_place
from tflab.workbook.tasks.case_types import Case
from tflab.workbook.tasks.reference import in_process_ros

COUNT = iter(range(1_000_000))
FRESH = """
def fresh(stamps, now, limit):
    kept = []
    for stamp in stamps:
        age = now - stamp
        if 0 <= age <= limit:
            kept.append(stamp)
    return kept
"""
ASKED = [([3, 1, 4, 9], 5, 2), ([5, 0, 3], 5, 2), ([], 1, 1), ([6, 7], 5, 3), ([2.5, 2], 4, 2)]
TURNED = """
def turned(x, y, yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    return (c * x - s * y, s * x + c * y)
"""
ANGLES = [(1.0, 2.0, 0.3), (-2.0, 0.5, 2.0), (0.3, -0.7, -1.1)]


def written(source, name):
    """Return a function as a notebook's cell would make it: its text can be read."""
    file = f"<cell {next(COUNT)}>"
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    names = {"math": math}
    exec(compile(source, file, "exec"), names)
    return names[name]


def look(source, name, spoilt, asked, form, patience_s=60.0):
    """Return what is said of a spoilt function, and the line that is quoted."""
    right = written(source, name)
    cases = [Case(to_plain(list(args)), outcome_of(right, to_plain(list(args))), {}) for args in asked]
    function = written(spoilt, name)
    outcomes = [outcome_of(function, case.args) for case in cases]
    return said_of_one_place(function, form, cases, outcomes, patience_s)


def of_fresh(old, new):
    assert old in FRESH
    return look(FRESH, "fresh", FRESH.replace(old, new), ASKED, Sequence(Number("s", 1e-6)))


def of_turned(old, new):
    assert old in TURNED
    return look(TURNED, "turned", TURNED.replace(old, new, 1), ANGLES, Vector(2, "m", "", 1e-6))


@pytest.mark.parametrize(
    ("old", "new", "kind", "quoted"),
    [
        ("age <= limit", "age < limit", "edge", "if 0 <= age < limit:"),
        ("age <= limit", "age >= limit", "side", "if 0 <= age >= limit:"),
        ("now - stamp", "stamp - now", "order", "age = stamp - now"),
        ("kept.append(stamp)", "kept.append(age)", "name", "kept.append(age)"),
        ("kept = []", "kept = [now]", "name", None),
        ("    return kept", "        return kept", "loop", "return kept"),
        ("age = now - stamp", "age = now + stamp", "sign", "age = now + stamp"),
        ("0 <= age", "1 <= age", "number", "if 1 <= age <= limit:"),
        ("return kept", "return kept[::-1]", "missing", None),
        ("return kept", "kept.append(limit)\n    return kept", "too much", "kept.append(limit)"),
        ("return kept", "return kept if now < 5 else []", "choice", "return kept if now < 5 else []"),
    ],
)
def test_the_place_and_its_kind_are_said(old, new, kind, quoted):
    said = of_fresh(old, new)
    if quoted is None:  # two ways to mend it, or none in one place: whatever is said names the line
        assert said is None or new.partition("\n")[0] in said.en
        return
    assert f"`{quoted}`" in said.en
    assert f"`{quoted}`" in said.ko
    assert said.en.endswith(LOOK[kind].en)
    assert said.ko.endswith(LOOK[kind].ko)


@pytest.mark.parametrize(
    ("old", "new", "kind"),
    [
        ("c * x - s * y", "c * x + s * y", "sign"),
        ("math.cos(yaw)", "math.sin(yaw)", "function"),
        ("s * x + c * y", "s * y + c * y", "name"),
        ("math.sin(yaw)", "yaw", "missing"),
        ("c * x - s * y", "s * y - c * x", "order"),
        ("c, s =", "s, c =", "order"),
        ("    return", "    if yaw > 0:\n        c, s = 1.0, 0.0\n    return", "too much"),
    ],
)
def test_formulas_are_mended_too(old, new, kind):
    assert of_turned(old, new).en.endswith(LOOK[kind].en)


def test_a_line_that_belongs_into_every_call_is_not_called_a_line_of_another_variable():
    said = of_turned("    return (c * x", "    if yaw > 0:\n        return (c * x")
    assert said.en.endswith(LOOK["choice"].en) and "`if yaw > 0:`" in said.en


def test_a_number_whose_exponent_has_the_other_sign_is_found():
    asked = [(5e-7,), (0.5,), (2e-6,), (5e5,), (5e6,)]
    text = "def is_short(length):\n    return 'short' if length < 1e-6 else 'long'\n"
    said = look(text, "is_short", text.replace("1e-6", "1e6"), asked, Choice(("short", "long")))
    assert said.en.endswith(LOOK["number"].en)


@pytest.mark.parametrize(
    ("old", "new", "part"),
    [
        ("c * x - s * y", "c * c * x - s * y", "c"),
        ("s * x + c * y", "s * x + c * y / 2", "2"),
        ("s * x + c * y)", "s * x + c * y + x)", "x"),
        ("math.cos(yaw)", "math.cos(2 * yaw)", "2"),
    ],
)
def test_a_step_too_many_is_told_by_what_it_is_made_with(old, new, part):
    said, words = of_turned(old, new), LOOK["surplus"].filled(part=part)
    assert said.en.endswith(words.en) and said.ko.endswith(words.ko)


def test_a_sum_is_mended_as_a_whole():
    line = "def at(s, x0, x1, y0, y1):\n    r = (s - x0) / (x1 - x0)\n    return (r, y0 + r * (y1 - y0))\n"
    asked, form = [(0.5, 0.2, 1.7, 3.0, 4.5), (2.0, 1.0, 4.0, -1.0, 7.0), (1.0, 0.5, 3.0, 2.0, 0.3)], Vector(2)
    copied = look(line, "at", line.replace("y0 + r * (y1 - y0)", "x0 + r * (x1 - x0)"), asked, form)
    assert "`return (r, x0 + r * (x1 - x0))`" in copied.en and copied.en.endswith(LOOK["copied"].en)
    bare = look(line, "at", line.replace("(s - x0) /", "s - x0 /"), asked, form)
    assert "`r = s - x0 / (x1 - x0)`" in bare.en and bare.en.endswith(LOOK["brackets"].en)


def test_an_error_that_was_caught_has_to_go_through():
    divided = "def share(a, b):\n    return a / b\n"
    caught = "def share(a, b):\n    try:\n        return a / b\n    except ZeroDivisionError:\n        return 0.0\n"
    said = look(divided, "share", caught, [(1.0, 2.0), (3.0, 0.0), (5.0, 4.0)], Number("", 1e-9))
    assert said.en.endswith(LOOK["through"].en) and said.ko.endswith(LOOK["through"].ko)


def test_of_a_long_line_the_part_around_is_quoted():
    long = TURNED.replace(
        "return (c * x - s * y, s * x + c * y)",
        "return (x * c - y * s + 0.0 * yaw * yaw * yaw * c, 0.0 + x * s + y * c + 0.0 * x * y * yaw * c)",
    )
    said = look(TURNED, "turned", long.replace("0.0 + x * s", "1.0 + x * s"), ANGLES, Vector(2, "m", "", 1e-6))
    assert "`1.0 + x * s + y * c + 0.0 * x * y * yaw * c`" in said.en


def test_what_is_wrong_in_two_places_is_wrong_in_none():
    spoilt = TURNED.replace("c * x - s * y", "c * x + s * y").replace("s * x + c * y", "s * x * c * y")
    assert look(TURNED, "turned", spoilt, ANGLES, Vector(2, "m", "", 1e-6)) is None


KEEPS = "return [stamp for stamp in stamps if 0 <= now - stamp < limit]"
HEAD = "def fresh(stamps, now, limit):\n    "


@pytest.mark.parametrize(
    "left_alone",
    [
        f"{HEAD}while True:\n        {KEEPS}\n",
        f"{HEAD}import os\n    {KEEPS}\n",
        f"{HEAD}open('x', 'w')\n    {KEEPS}\n",
        f"def made(n):\n    def fresh(stamps, now, limit):\n        {KEEPS}[n:]\n    return fresh\nfresh = made(0)\n",
        f"fresh = lambda stamps, now, limit: {KEEPS.removeprefix('return ')}\n",
        f"class Fresh:\n    def __call__(self, stamps, now, limit):\n        {KEEPS}\nfresh = Fresh()\n",
    ],
)
def test_what_might_not_end_or_touches_a_disk_is_left_alone(left_alone, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    form = Sequence(Number("s", 1e-6))
    assert look(FRESH, "fresh", f"{HEAD}{KEEPS}\n", ASKED, form) is not None
    assert look(FRESH, "fresh", left_alone, ASKED, form) is None


def test_an_edit_that_would_make_a_loop_feed_itself_is_stopped():
    assert of_fresh("now - stamp", "now * stamp") is None  # tried: for stamp in kept, kept.append(stamp)


def test_nothing_of_the_learner_s_is_changed_or_printed(capsys):
    spoilt = FRESH.replace("age <= limit", "age < limit").replace("    kept = []", "    print('called')\n    kept = []")
    function = written(spoilt, "fresh")
    right = written(FRESH, "fresh")
    cases = [Case(to_plain(list(args)), outcome_of(right, to_plain(list(args))), {}) for args in ASKED]
    outcomes = [outcome_of(function, case.args) for case in cases]
    before = dict(function.__globals__)
    capsys.readouterr()
    assert said_of_one_place(function, Sequence(Number("s", 1e-6)), cases, outcomes, 60.0) is not None
    assert function.__globals__ == before
    assert capsys.readouterr().out == ""


def test_lists_beside_a_function_stay_as_they_are_and_helpers_are_called():
    source = """
seen, kinds = [], {"limit": 0.0}

def noted(stamp):
    seen.append(stamp)
    kinds["limit"] += 0.0
    return stamp

def fresh(stamps, now, limit):
    return [noted(stamp) for stamp in stamps if kinds["limit"] <= now - stamp < limit]
"""
    function = written(source, "fresh")
    right = written(source.replace("stamp < limit", "stamp <= limit"), "fresh")
    cases = [Case(to_plain(list(args)), outcome_of(right, to_plain(list(args))), {}) for args in ASKED]
    outcomes = [outcome_of(function, case.args) for case in cases]
    before = len(function.__globals__["seen"])
    said = said_of_one_place(function, Sequence(Number("s", 1e-6)), cases, outcomes, 60.0)
    assert said.en.endswith(LOOK["edge"].en)
    assert len(function.__globals__["seen"]) == before


def test_past_its_time_nothing_is_called_any_more():
    calls = []
    spoilt = FRESH.replace("age <= limit", "age < limit").replace("    kept = []", "    count()\n    kept = []")
    right, function = written(FRESH, "fresh"), written(spoilt, "fresh")
    function.__globals__["count"] = lambda: calls.append(1)
    cases = [Case(to_plain(list(args)), outcome_of(right, to_plain(list(args))), {}) for args in ASKED]
    outcomes = [outcome_of(function, case.args) for case in cases]
    for patience_s, is_found in ((60.0, True), (0.0, False)):
        calls.clear()
        said = said_of_one_place(function, Sequence(Number("s", 1e-6)), cases, outcomes, patience_s)
        assert (said is not None) == is_found
        assert bool(calls) == is_found


def test_every_kind_of_edit_has_its_words():
    assert set(LOOK) == set(edits.KINDS)


def test_check_says_it_where_no_known_mistake_fits(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    source = (
        "def interpolate(stamp_s, before, after):\n"
        "    (t0, x0, y0, yaw0), (t1, x1, y1, yaw1) = before, after\n"
        "    if not t0 <= stamp_s <= t1:\n"
        "        raise ExtrapolationException('outside')\n"
        "    ratio = (stamp_s - t0) / (t1 - t0)\n"
        "    turn = math.remainder(yaw1 - yaw0, math.tau)\n"
        "    return {'position': (x0 + ratio * (x1 - x0), y0 + ratio / (y1 - y0)), 'yaw': yaw0 + ratio * turn}\n"
    )
    assert checks.workbook_root() == workbook_data()  # outside any copy: tflab's own
    with in_process_ros():
        function = written("from tf2_ros import ExtrapolationException\n" + source, "interpolate")
        check("E8.2", function)
    said = capsys.readouterr().out
    assert "line 8: `(x0 + ratio * (x1 - x0), y0 + ratio / (y1 - y0))`" in said
    assert LOOK["operation"].en in said
