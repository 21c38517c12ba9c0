"""Each learner is asked what nobody can foresee, always the same, and enough to see every mistake."""

from __future__ import annotations

from tflab.grading.judging.draw import asks_of, digest_of, drawn, pool_of
from tflab.workbook.answers.forms import Choice, Number

WORDS = ["ok"] * 14 + ["zero"] * 2 + ["nan"] * 10
SEEDS = [f"secret/s{number}".encode() for number in range(40)]


def pool() -> list:
    cases = [{"args": [number], "expected": word, "wrong": {}} for number, word in enumerate(WORDS)]
    rare = {"args": [99], "expected": "ok", "wrong": {"nobody else tells": "nan"}}
    task = {"form": Choice(("ok", "zero", "nan")).plain()}
    return pool_of(task, [*cases, rare, cases[0]], shown=())


def test_a_case_is_in_the_pool_once_and_says_which_mistakes_it_tells() -> None:
    assert [case["args"] for case in pool()] == [[number] for number in range(26)] + [[99]]
    assert pool()[-1]["tells"] == ["nobody else tells"]


def test_the_same_learner_is_always_asked_the_same_and_another_in_another_order() -> None:
    asked = [drawn(pool(), seed) for seed in SEEDS]
    assert asked == [drawn(pool(), seed) for seed in SEEDS]
    orders = {tuple(case["expected"] for case in one["cases"]) for one in asked}
    assert len(orders) == len(SEEDS)


def test_no_kind_has_a_fixed_place_and_how_many_there_are_varies() -> None:
    asked = [[case["expected"] for case in drawn(pool(), seed)["cases"]] for seed in SEEDS]
    for place in range(10):
        assert len({words[place] for words in asked}) > 1
    assert len({words.count("ok") for words in asked}) > 2
    assert len({len(words) for words in asked}) > 2


def test_every_kind_is_asked_and_every_mistake_is_told() -> None:
    for seed in SEEDS:
        cases = drawn(pool(), seed)["cases"]
        assert {case["expected"] for case in cases} == {"ok", "zero", "nan"}
        assert any(case["tells"] for case in cases)


def test_some_cases_are_asked_again_at_a_distance_and_all_at_least_once() -> None:
    for seed in SEEDS:
        one = drawn(pool(), seed)
        asks = asks_of(one)
        assert set(asks) == set(range(len(one["cases"])))
        places = [[place for place, number in enumerate(asks) if number == again] for again in set(asks)]
        distances = [there[1] - there[0] for there in places if len(there) > 1]
        assert 1 <= len(distances) <= 3
        assert min(distances) >= 5


def test_what_was_shown_is_asked_only_where_there_is_nothing_else() -> None:
    cases = [{"args": [number], "expected": float(number), "wrong": {}} for number in range(30)]
    task = {"form": Number().plain()}
    shown = {digest_of(case["args"]) for case in cases[:10]}
    assert not any(any(drawn(pool_of(task, cases, shown), seed)["known"]) for seed in SEEDS)
    assert any(any(drawn(pool_of(task, cases[:12], shown), seed)["known"]) for seed in SEEDS)
