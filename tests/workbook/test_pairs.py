"""Two mistakes made together are searched for an answer that nothing simpler explains."""

from __future__ import annotations

import sys
from types import SimpleNamespace

import pytest

from tflab.workbook.answers.values import outcome_of, to_plain
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks import Number, Parts, Task, Text, WrongAnswer, WrongStep, pairs
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.generate_cases import task_cases
from tflab.workbook.tasks.pairs import PairSearch, combinable
from tflab.workbook.tasks.reference import CodeCell, Solution, in_process_ros

from .small_chapter import bare


def said(text: str) -> Text:
    return Text(en=text, ko=f"한국어: {text}")


def distance(given, *, offset=1.0, scale=1.0, sign=1.0):
    """Return how far it is, by three steps of which each can go wrong."""
    return sign * scale * (given.measured + offset * given.mounted)


SLIPS = (
    WrongStep("sign turned", {"sign": -1.0}, said("the sign is turned")),  # the last step of the work stands first
    WrongStep("mount forgotten", {"offset": 0.0}, said("the mount is left out")),
    WrongStep("mount subtracted", {"offset": -1.0}, said("the mount is subtracted")),
    WrongStep("doubled", {"scale": 2.0}, said("it is taken twice")),
)


METRES = Number("m", 0.001)


def task_of(form=METRES, model=distance, mistakes=SLIPS, **changes) -> Task:
    return Task(
        "E3.1", "N", 1, said("distance"), "answer", form, (said("1"), said("2"), said("3")), mistakes=mistakes,
        model=model,
        given=lambda rng: {"measured": float(rng.uniform(3, 4)), "mounted": float(rng.uniform(0.2, 0.4))}, **changes,
    )  # fmt: skip


def made(task: Task, cell: str) -> TaskCases:
    with in_process_ros():
        return task_cases(task, "a seed", Solution("03_small", [CodeCell("e3-1-answer", cell)]), 1)


@pytest.fixture
def of_a_value() -> TaskCases:
    return made(task_of(), "answer = e3_1.measured + e3_1.mounted")


def mistakes_found(task: TaskCases, **steps: float) -> list[str]:
    """Return the mistakes that explain what the model gives with these steps."""
    (variant,) = task.variants
    given = SimpleNamespace(**variant.given)
    return list(judge_outcomes(task, variant, [to_plain(distance(given, **steps))]).mistakes)


def test_mistakes_combine_at_different_steps():
    names = [(first.name, then.name) for first, then in combinable(task_of())]
    assert names == [
        ("mount forgotten", "doubled"),
        ("mount forgotten", "sign turned"),
        ("mount subtracted", "doubled"),
        ("mount subtracted", "sign turned"),
        ("doubled", "sign turned"),
    ]
    assert combinable(task_of(model=None, mistakes=(WrongAnswer("swapped", 1.0, said("swapped")),))) == []


def test_a_pair_that_gives_the_answer_is_found(of_a_value):
    assert mistakes_found(of_a_value, offset=-1.0, scale=2.0) == ["mount subtracted", "doubled"]
    assert mistakes_found(of_a_value, offset=0.0, sign=-1.0) == ["mount forgotten", "sign turned"]
    assert mistakes_found(of_a_value, offset=5.0, scale=7.0) == []


def test_no_pair_is_searched_if_one_mistake_explains_the_answer(of_a_value, monkeypatch):
    monkeypatch.setattr(PairSearch, "matching", lambda *_: pytest.fail("a pair was searched"))
    for steps in ({"offset": -1.0}, {"scale": 2.0}, {"sign": -1.0}):
        assert len(mistakes_found(of_a_value, **steps)) == 1
    with pytest.raises(pytest.fail.Exception, match="a pair was searched"):
        mistakes_found(of_a_value, offset=-1.0, scale=2.0)


def times(x, flag=False, *, scale=1.0, offset=0.0, limit=9.0):
    return min(scale * x, limit) + offset


FUNCTION_SLIPS = (
    WrongStep("doubled", {"scale": 2.0}, said("it is taken twice")),
    WrongStep("halved", {"scale": 0.5}, said("it is taken by half")),
    WrongStep("shifted", {"offset": 0.7}, said("it is shifted")),
    WrongStep("unlimited", {"limit": 99.0}, said("nothing limits it")),
)


@pytest.fixture
def of_a_function() -> TaskCases:
    task = Task(
        "E3.1", "F", 1, said("times"), "answer", Number("m", 0.001), (said("1"), said("2"), said("3")),
        inputs=lambda rng: [(1.0,), (2.5,), (3.5,), (8.0,), (12.0,)], mistakes=FUNCTION_SLIPS, model=times,
    )  # fmt: skip
    return made(task, "def answer(x):\n    return min(x, 9.0)")


def test_a_pair_in_a_function_is_found(of_a_function):
    (variant,) = of_a_function.variants
    for steps, names in (
        ({"scale": 0.5, "offset": 0.7}, ["halved", "shifted"]),
        ({"offset": 0.7, "limit": 99.0}, ["shifted", "unlimited"]),
        ({"scale": 3.0, "offset": 0.7}, []),
    ):
        outcomes = [outcome_of(lambda x, s=steps: times(x, **s), case.args) for case in variant.cases]
        assert sorted(judge_outcomes(of_a_function, variant, outcomes).mistakes) == names


def test_pairs_are_computed_only_while_they_fit(of_a_function, monkeypatch):
    (variant,) = of_a_function.variants
    computed = []
    usual = pairs.values_of

    def counted(answers, case, given):
        computed.append((case.args, len(answers)))
        return usual(answers, case, given)

    monkeypatch.setattr(pairs, "values_of", counted)
    wanted = [times(*case.args, scale=0.5, offset=0.7) for case in variant.cases]
    search = of_a_function.pairs

    def reproduced_by(number, value):
        return ["whole"] * (abs(value - wanted[number]) < 1e-9)

    found = search.matching(variant.cases, [4, 0, 1, 2, 3], reproduced_by, None)
    assert {name: pytest.approx(row) for name, row in found.items()} == {"halved + shifted": wanted}
    assert computed == [([12.0], 5), ([1.0], 1), ([2.5], 1), ([3.5], 1), ([8.0], 1)]
    computed.clear()
    assert search.matching(variant.cases, [4, 0, 1, 2, 3], lambda number, value: [], None) == {}
    assert computed == [([12.0], 5)]


def test_a_pair_must_give_the_same_part_in_every_case(of_a_function):
    (variant,) = of_a_function.variants
    parts = ["a", "b"]
    found = of_a_function.pairs.matching(variant.cases, range(5), lambda number, value: [parts[number % 2]], None)
    assert found == {}
    found = of_a_function.pairs.matching(variant.cases, range(5), lambda number, value: [*parts[number % 2], "c"], None)
    assert "halved + shifted" in found


def test_a_pair_that_gives_the_same_as_something_simpler_is_left_out():
    adds = {"a": 1.0, "b": -1.0, "c": 10.0, "d": 11.0, "e": 2.0}

    def model(given, *, a=0.0, b=0.0, c=0.0, d=0.0, e=0.0):
        return given.measured + a + b + c + d + e

    task = task_of(model=model, mistakes=tuple(WrongStep(name, {name: adds[name]}, said(name)) for name in adds))
    cases = made(task, "answer = e3_1.measured")
    (variant,) = cases.variants
    found = cases.pairs.matching(variant.cases, [0], lambda number, value: ["any"], variant.given)
    every = {f"{first.name} + {then.name}" for first, then in combinable(task)}
    assert len(every) == 10
    right, one_mistake, another_pair = {"a + b"}, {"a + c", "b + d", "b + e"}, {"a + d", "c + e"}
    assert every - set(found) == right | one_mistake | another_pair


def test_of_pairs_that_look_alike_only_the_mistake_that_they_share_is_named():
    def model(given, *, a=0.0, b=0.0, c=0.0):
        return given.measured + a + max(b, c)

    steps = {"a": 1.0, "b": 10.0, "c": 10.0001}
    task = task_of(model=model, mistakes=tuple(WrongStep(name, {name: steps[name]}, said(name)) for name in steps))
    (variant,) = made(task_of(model=model, mistakes=task.mistakes[:1]), "answer = e3_1.measured").variants
    search = PairSearch(lambda: task)
    found = search.matching(variant.cases, [0], lambda number, value: ["any"], variant.given)
    assert "a" in found and "a + b" not in found and "a + c" not in found


def test_a_pair_explains_one_part_of_an_answer():
    def model(given, *, offset=1.0, scale=1.0, sign=1.0):
        total = distance(given, offset=offset, scale=scale, sign=sign)
        return {"far": total, "near": given.measured, "mounted": given.mounted}

    form = Parts(dict.fromkeys(("far", "near", "mounted"), METRES))
    cell = 'answer = {"far": e3_1.measured + e3_1.mounted, "near": e3_1.measured, "mounted": e3_1.mounted}'
    task = made(task_of(form, model), cell)
    (variant,) = task.variants
    given = SimpleNamespace(**variant.given)
    answer = model(given, offset=-1.0, scale=2.0)
    verdict = judge_outcomes(task, variant, [to_plain(answer)])
    assert (verdict.passed, verdict.of, list(verdict.mistakes)) == (2, 3, ["mount subtracted", "doubled"])
    verdict = judge_outcomes(task, variant, [to_plain(answer | {"far": 77.7})])
    assert (verdict.passed, list(verdict.mistakes)) == (2, [])


def test_a_search_without_its_task_finds_nothing():
    asked = []
    search = PairSearch(lambda: asked.append("asked"))
    task, variant = bare(Number(), *[])
    for _ in range(2):
        assert search.matching(variant.cases, [], lambda number, value: ["whole"], None) == {}
    assert asked == ["asked"] and task.pairs is None


def test_a_search_leaves_no_ros_modules():
    before = {name for name in sys.modules if name.partition(".")[0] in ("rclpy", "tf2_ros")}

    def with_ros(given, *, offset=1.0, scale=1.0, sign=1.0):
        import tf2_ros

        return distance(given, offset=offset, scale=scale, sign=sign) if tf2_ros.Buffer else None

    task = made(task_of(model=with_ros), "answer = e3_1.measured + e3_1.mounted")
    (variant,) = task.variants
    assert task.pairs.matching(variant.cases, [0], lambda number, value: ["whole"], variant.given)
    assert {name for name in sys.modules if name.partition(".")[0] in ("rclpy", "tf2_ros")} == before


def test_a_pair_is_computed_from_the_learners_inputs(of_a_value):
    (variant,) = of_a_value.variants
    other = {"measured": 1.0, "mounted": 0.5}
    found = of_a_value.pairs.matching(variant.cases, [0], lambda number, value: ["whole"], other)
    assert found["mount subtracted + doubled"] == [pytest.approx(1.0)]
