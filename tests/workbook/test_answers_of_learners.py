"""What `check` replies to whole answers of chapters 9 to 12: what is wrong with them, and nothing untrue."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from tflab.workbook import checks
from tflab.workbook.answers.values import to_plain

from .whole_answers import mistakes_of, task_of, verdict_on

# -- chapter 9 ------------------------------------------------------------------------

CLASSIFY = """
def classify(buffer, target, source, stamp):
    try:
        buffer.lookup_transform(target, source, stamp)
    except InvalidArgumentException:
        return "invalid argument"
    except LookupException:
        return "lookup"
    except ConnectivityException:
        return "connectivity"
    except ExtrapolationException as error:
        said = str(error)
        return "future" if "into the future" in said else "past" if "into the past" in said else "one sample"
    return "ok"
"""


@pytest.mark.parametrize(
    ("old", "new", "mistakes"),
    [
        ('"into the ', '"in the ', ["no text is read"]),
        ("except ", "except KeyError or ", ["nothing is caught"]),
        (
            "    try:\n",
            '    if target.startswith("/") or source.startswith("/"):\n        return "invalid argument"\n    try:\n',
            ["ends swapped"],
        ),
    ],
)
def test_how_a_refusal_is_classified_wrongly_is_told(old, new, mistakes):
    assert old in CLASSIFY
    assert mistakes_of("E9.2", CLASSIFY) == []
    assert mistakes_of("E9.2", CLASSIFY.replace(old, new)) == mistakes


DECIDE = """
def decide(buffer, message):
    source, stamp = message.header.frame_id, Time.from_msg(message.header.stamp)
    try:
        buffer.lookup_transform("map", source, stamp)
        return "use"
    except LookupException:
        return "check names"
    except ConnectivityException:
        return "check tree"
    except InvalidArgumentException:
        return "fix message"
    except ExtrapolationException as error:
        if "into the future" not in str(error):
            return "drop"
        behind = stamp.nanoseconds - buffer.get_latest_common_time("map", source).nanoseconds
        return "wait" if behind <= 200_000_000 else "check clocks"
"""


@pytest.mark.parametrize(
    ("changes", "mistakes"),
    [
        ({"200_000_000": "0.2"}, ["never waits"]),
        ({"behind <=": "-behind <="}, ["waits however far"]),
        ({"behind <= 200_000_000": "round(behind / 1e6) <= 200"}, ["the limit is blunt"]),
        ({'time("map"': 'time("base_link"'}, ["gap from base_link"]),
        (
            {"behind <= 200_000_000": "True", '"fix message"': '"check names"'},
            ["waits however far", "no question is a wrong name"],
        ),
        (
            {'transform("map"': 'transform("odom"', '"fix message"': '"check names"'},
            ["wanted in odom", "no question is a wrong name"],
        ),
    ],
)
def test_why_a_decision_is_wrong_is_told_by_its_cause(changes, mistakes):
    source = DECIDE
    for old, new in changes.items():
        assert old in source
        source = source.replace(old, new)
    assert sorted(mistakes_of("E9.3", source)) == sorted(mistakes)


def test_that_no_branch_waits_for_the_past_is_said_without_calling_a_single_sample_old():
    waits = DECIDE.replace('return "drop"', 'return "wait"')
    verdict = verdict_on("E9.3", waits)
    assert list(verdict.mistakes) == ["waits for the past"]
    assert "older than everything" not in verdict.said.en


DELAYS = """
causes, FAST, LATE, OPEN = {}, "laser clock is fast", "transforms arrive late", "cannot be told from this"
DO = {FAST: "set the laser's clock", LATE: "wait a little", OPEN: "ask chrony on both computers"}
for name in "abc":
    scan, odom = ([heard - stamp for stamp, heard in getattr(given, f"robot_{name}")[t]] for t in ("scan", "odom"))
    is_early, trembles = min(scan) < 0, max(odom) - min(odom) > 0.1
    causes[name] = %s
    causes[f"{name} do"] = DO[causes[name]]
"""


def test_what_a_delay_shows_is_told_to_whoever_leaves_it_open():
    for cause, mistakes in (
        ("FAST if is_early else LATE if trembles else OPEN", []),
        ("OPEN", ["always open"]),
        ("OPEN if is_early or not trembles else LATE", ["sign overlooked"]),
    ):
        for variant in range(6):
            assert mistakes_of("E9.4", DELAYS % cause, variant) == mistakes
    said = verdict_on("E9.4", DELAYS % "OPEN if is_early or not trembles else LATE").said
    assert "/odom" in said.en


def test_a_word_that_is_right_and_counts_nothing_is_told_where_it_is_said_everywhere():
    task = task_of("E9.4")
    one = dict.fromkeys("abc", "transforms arrive late") | {f"{name} do": "wait a little" for name in "abc"}
    two = one | {"a": "laser clock is fast", "a do": "set the laser's clock"}
    held = SimpleNamespace(cases=task, variant=task.variants[0])
    assert len(checks._said_too_often(held, [to_plain(one)])) == 2
    assert checks._said_too_often(held, [to_plain(two)]) == []


WAIT = """
sources = (given.localization, given.wheel_odometry)
period, late = {}
wait_s = max(period(s) + late(s) for s in sources) {} given.scan_delay_s
"""


@pytest.mark.parametrize("variant", range(2))
def test_a_wait_of_which_two_things_are_wrong_is_not_called_by_one_that_comes_near(variant):
    no_period = "lambda s: 0.0, lambda s: s['delay_s'] + s['jitter_s']"
    assert mistakes_of("E9.7", WAIT.format(no_period, "+"), variant) == ["period forgotten", "scan's delay added"]
    both = "lambda s: 1 / s['rate_hz'], lambda s: s['delay_s'] + s['jitter_s']"
    mean = WAIT.format(both, "-").replace("max(", "0.5 * sum(")
    assert mistakes_of("E9.7", mean, variant) == ["mean of the edges"]

    assert mistakes_of("E9.7", WAIT.format(both, "-"), variant) == []
    for margin in (" + 0.05", " + 0.1"):
        assert mistakes_of("E9.7", WAIT.format(both, "-").rstrip() + margin, variant) == []
    less = WAIT.format(both.replace("s['delay_s'] +", "-s['delay_s'] +"), "-")
    assert mistakes_of("E9.7", less.replace("for s in sources", "for s in sources[:1]"), variant) == ["delay taken off"]


# -- chapter 12 -----------------------------------------------------------------------


def test_a_list_on_which_all_is_healthy_hears_that_beside_what_it_does_not_tell_apart():
    form = task_of("E12.4").form.parts["a checks"]
    said = form.remark(["node list"], {"a cause": "localizer waits for /clock"})
    assert "differ from the card" in said.en
    assert "Fixed Frame misspelt" in said.en
    assert "differ from the card" not in form.remark(["rviz"], {"a cause": "localizer waits for /clock"}).en
