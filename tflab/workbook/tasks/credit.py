"""Decide which right results earn credit, so that a constant answer or a guess earns nothing.

    asked for      3.1   0.0  -2.4   0.0           [True, True]: two different results, and right
    always 0.0     0.0   0.0   0.0   0.0    right in two cases, but for one result only: no credit

A probe earns credit if the function is right for two different results.  So a constant
earns nothing, and neither does returning the argument or raising in every call.

Of a composite value, such as a tree, parts that were given already earn nothing.  Of
choices between the same words, a word that is used too often earns nothing if it is
right no more often than it would be by chance:

    right                stays  changes changes changes stays  stays      changes in half of them
    "changes" to all       -      +       +       +       -      -        right in half: no credit
    "changes" to four      -      +       +       +       0      0        right in three of four: credit

If most variants have the same right value for a part, this part alone earns nothing.

Grading also corrects for guessing: the best result of an answer that ignores its input
counts as zero.

    16 cases, 7 of them "ok"      always "ok": 7        right in 13: (13 - 7) / (16 - 7) of the points
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations

from ..answers.form import inside
from ..answers.forms import Choice, Form, Parts
from ..answers.members import dict_of
from ..answers.values import Plain, is_raised
from .case_types import Case

__all__ = [
    "asked_alike", "beyond_guessing", "beyond_one_word", "beyond_the_given", "beyond_the_usual", "credited",
    "negated", "trivial_pattern", "usual_among",
]  # fmt: skip

FEWEST_ALIKE = 3  # choices between the same words: of two, one word is as likely a mistake as a guess


def credited(
    form: Form, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]]
) -> list[list[bool]]:
    """Return for each case which of its probes earn credit: those of `rights` that show something.

    Args:
        form: of the function's result.
        cases: with their arguments and what is expected.
        outcomes: for each case what came out, as `to_plain` writes it.
        rights: for each case and probe, whether it is right.
    """
    if len(cases) < 2 or all(map(all, rights)):
        return [list(row) for row in rights]
    if trivial_pattern(form, cases, outcomes):
        return [[False] * len(row) for row in rights]
    by_luck = _right_by_luck(form, cases, rights)
    return [
        [right and (is_raised(case.expected) or place not in by_luck) for place, right in enumerate(row)]
        for case, row in zip(cases, rights, strict=True)
    ]


def beyond_the_given(
    form: Form, given: Mapping[str, Plain] | None, expected: Plain, right: Sequence[bool]
) -> list[bool]:
    """Return which probes of a value earn credit: all if all are right, else those that no given has already."""
    if all(right):
        return list(right)
    handed_out = [form.judge(dict_of(value), expected) for value in (given or {}).values()]
    return [good and not any(row[place] for row in handed_out) for place, good in enumerate(right)]


def beyond_one_word(form: Form, answer: Plain, expected: Plain, right: Sequence[bool]) -> list[bool]:
    """Return which probes of several choices earn credit: of a word said too often, those that no chance explains."""
    if all(right) or form.read(answer) is None or not isinstance(form, Parts):
        return list(right)
    answers = inside(answer)
    earned = dict(zip(form.parts, right, strict=True))
    for names in asked_alike(form.parts):
        said = {name: form.parts[name].option(answers.get(name)) for name in names}
        for word in set(said.values()) - {None}:
            there = [name for name in names if said[name] == word]
            fits = sum(form.judge({"dict": dict.fromkeys(names, word)}, expected))
            if fits < len(there) and sum(earned[name] for name in there) * len(names) <= fits * len(there):
                earned |= dict.fromkeys(there, False)
    return list(earned.values())


def usual_among(form: Form, expected: Plain, others: Sequence[Plain]) -> list[bool]:
    """Return for each part of a value whether what is right there is right in half of the other variants, too.

    Nothing is usual, [], where nothing differs: then a part is known, and not guessed from others.
    """
    if not others or not isinstance(form, Parts):
        return []
    columns = list(zip(*(form.judge(expected, other) for other in others), strict=True))
    return [] if all(map(all, columns)) else [2 * sum(column) >= len(others) for column in columns]


def beyond_the_usual(right: Sequence[bool], usual: Sequence[bool], follows: Sequence[bool] = ()) -> list[bool]:
    """Return which probes of a value earn credit: all if all are right, else those that are not usual.

    What only follows from a mistake earns none unless something else does.
    """
    if all(right) or len(right) != len(usual):
        return list(right)
    earned = [good and not often for good, often in zip(right, usual, strict=True)]
    only_follow = follows or [False] * len(earned)
    return (
        earned
        if any(good and not after for good, after in zip(earned, only_follow, strict=True))
        else [False] * len(earned)
    )


def asked_alike(parts: Mapping[str, Form]) -> list[list[str]]:
    """Return the names of the parts that are choices between the same words, for each such words."""
    alike: dict[tuple[str, ...], list[str]] = {}
    for name, part in parts.items():
        if isinstance(part, Choice):
            alike.setdefault(part.options, []).append(name)
    return [names for words, names in alike.items() if words and len(names) >= FEWEST_ALIKE]


def _right_by_luck(form: Form, cases: Sequence[Case], rights: Sequence[list[bool]]) -> set[int]:
    """Return the places at which different results are expected, and the function is right for one of them only."""
    values = [(case.expected, row) for case, row in zip(cases, rights, strict=True) if not is_raised(case.expected)]
    expected = [value for value, _ in values]
    by_luck = set()
    for place in range(min((len(row) for _, row in values), default=0)):
        right = [value for value, row in values if row[place]]
        if _differ(form, expected, place) and not _differ(form, right, place):
            by_luck.add(place)
    return by_luck


def trivial_pattern(form: Form, cases: Sequence[Case], outcomes: Sequence[Plain]) -> str:
    """Return what a function does whatever it is asked: "constant", "echo", or "" if neither."""
    expected = [case.expected for case in cases]
    if len(cases) < 2 or all(form.alike(value, expected[0]) for value in expected[1:]):
        return ""
    if all(form.alike(outcome, outcomes[0]) for outcome in outcomes[1:]):
        return "constant"
    count = min(len(case.args or ()) for case in cases)
    for place in range(count):
        if all(form.alike(out, case.args[place]) for out, case in zip(outcomes, cases, strict=True)):
            return "echo"
    return ""


def beyond_guessing(form: Form, cases: Sequence[Case], passed: int, known: Sequence[bool]) -> float:
    """Return the share of a function's points that is earned: what is right beyond what guessing gives, from 0 to 1.

    Args:
        passed: how many probes earn credit (see `credited`).
        known: for each case whether its arguments stand among those that the learner was shown.
    """
    of = probes_of(form, cases)
    return share_beyond(passed, of, 0 if passed in (0, of) else guessed_of(form, cases, known))


def share_beyond(passed: int, of: int, guessed: int) -> float:
    """Return which share of so many probes is right beyond those that guessing gives, from 0 to 1."""
    if passed == of or guessed == of:  # where nothing varies, nothing can be guessed
        return passed / of
    return max(0, passed - guessed) / (of - guessed)


def probes_of(form: Form, cases: Sequence[Case]) -> int:
    """Return how many probes cases have."""
    return sum(len(form.judge(case.expected, case.expected)) for case in cases)


def guessed_of(form: Form, cases: Sequence[Case], known: Sequence[bool]) -> int:
    """Return how many probes the best answer has that knows what was shown, and of the rest only what is frequent."""
    sizes = [len(form.judge(case.expected, case.expected)) for case in cases]
    sure = sum(size for size, seen in zip(sizes, known, strict=True) if seen)
    unseen = [case for case, seen in zip(cases, known, strict=True) if not seen]
    names = [case.expected["raises"] for case in unseen if is_raised(case.expected)]
    values = [case for case in unseen if not is_raised(case.expected)]
    raising = max(map(names.count, names), default=0)
    echoed = max(
        (_echoed(form, values, place, signed) for place in range(_fewest_args(values)) for signed in (_same, negated)),
        default=0,
    )
    return sure + max(raising, echoed, _most_frequent(form, [case.expected for case in values]))


def _most_frequent(form: Form, values: Sequence[Plain]) -> int:
    """Return how many probes a constant has, made of what is most frequent at each place; once is not frequent."""
    rows = [[form.judge(constant, value) for value in values] for constant in values]
    places = min((len(right) for row in rows for right in row), default=0)
    counts = [max(sum(right[place] for right in row) for row in rows) for place in range(places)]
    return sum(count for count in counts if count > 1)


def _echoed(form: Form, cases: Sequence[Case], place: int, signed: Callable[[Plain], Plain]) -> int:
    """Return how many probes the argument at `place` has, handed back as it is, or with each number's sign turned."""
    return sum(sum(form.judge(signed(case.args[place]), case.expected)) for case in cases)


def _same(value: Plain) -> Plain:
    return value


def negated(value: Plain) -> Plain:
    """Return a value with the sign of each of its numbers turned: nobody need understand a pose to write `-v`."""
    if isinstance(value, dict):
        return {name: negated(part) for name, part in value.items()}
    if isinstance(value, list):
        return [negated(part) for part in value]
    return -value if isinstance(value, int | float) and not isinstance(value, bool) else value


def _fewest_args(cases: Sequence[Case]) -> int:
    return min((len(case.args or ()) for case in cases), default=0)


def _differ(form: Form, values: Iterable[Plain], place: int) -> bool:
    """Return whether two of these values have different probes at `place`."""
    return any(not form.judge(value, other)[place] for value, other in combinations(values, 2))
