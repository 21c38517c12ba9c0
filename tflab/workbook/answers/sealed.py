"""How can an answer be recognised without being written down?  Sealed: as digests of what it rounds to.

    expected 2.2  --tolerance 0.005-->  440  --salt, many rounds of SHA-256-->  "9f1c..."
    answer 2.203  -------------------->  441, 440 or 442: one of them has that digest

That is a salted hash, as passwords are kept.  A class's copies hold the values
that are asked for in this form only, so that reading the file does not spare the
exercise.  It is a curtain, not a vault: whoever tries all numbers finds it, and
would have been faster thinking.  Hidden cases are not sealed: they never leave
the instructor.

Read `showing.py` next.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from .form import Mark, Probe, Row, inside, matched
from .forms import Form
from .values import Plain, is_raised

__all__ = ["belongs", "is_sealed", "judge", "part_of", "seal", "sealed_variant"]

ROUNDS = 300
NEIGHBOURS = (0, -1, 1)


def seal(form: Form, expected: Plain, salt: str) -> Plain:
    """Return what can stand in a learner's file instead of `expected`.

    Raises:
        ValueError: `expected` is not of the form.
    """
    if is_raised(expected):
        return expected
    probes = form.probes(expected)
    if probes is None:
        raise ValueError(f"{expected!r} is not {form.wanted().en}")
    rows = [
        [[_digest(salt, place, _step(mark, 0)), mark.tolerance] for place, mark in enumerate(probe[0])]
        for probe in probes
    ]
    return {"sealed": {"salt": salt, "probes": rows}}


def sealed_variant(form: Form, variant: Mapping[str, Any], learner: str | None) -> dict[str, Any]:
    """Return a variant whose expected values, and the mistakes beside them, cannot be read off."""
    cases = []
    for number, case in enumerate(variant["cases"]):
        salt = hashlib.sha256(f"{learner}/{number}/{json.dumps(variant['given'])}".encode()).hexdigest()[:16]
        twins = {}
        for name, value in case["twins"].items():
            try:
                twins[name] = seal(form, value, salt)
            except (ValueError, TypeError, KeyError):  # a mistake of another form: nothing of the answer is in it
                twins[name] = value
        cases.append(case | {"expected": seal(form, case["expected"], salt), "twins": twins})
    return dict(variant) | {"cases": cases}


def is_sealed(expected: Plain) -> bool:
    """Return whether this is what `seal` writes."""
    return isinstance(expected, dict) and "sealed" in expected


def judge(form: Form, answer: Plain, expected: Plain) -> list[bool]:
    """Return for each probe whether `answer` has it; `expected` may be sealed, or open."""
    if not is_sealed(expected):
        return form.judge(answer, expected)
    salt, wanted = expected["sealed"]["salt"], expected["sealed"]["probes"]
    return matched(form.read(answer), wanted, lambda rows, right: _any_fits(rows, right, salt), form.in_any_order)


def belongs(form: Form, answer: Plain, expected: Plain) -> list[bool]:
    """Return for each probe of an answer in any order whether it is among those expected, open or sealed."""
    if not is_sealed(expected):
        expected = seal(form, expected, "")
    salt, wanted = expected["sealed"]["salt"], expected["sealed"]["probes"]
    return [any(_any_fits(rows, right, salt) for right in wanted) for rows in form.read(answer) or ()]


def part_of(expected: Plain, number: int, name: str) -> Plain:
    """Return what is expected of one part of a dict, the `number`th, as open or as sealed as the whole."""
    if not is_sealed(expected):
        return inside(expected).get(name)
    whole = expected["sealed"]
    return {"sealed": {**whole, "probes": [whole["probes"][number]]}}


def _any_fits(rows: Probe, right: list[list[Any]], salt: str) -> bool:
    return any(_fits(row, right, salt) for row in rows)


def _fits(row: Row, right: list[list[Any]], salt: str) -> bool:
    if len(row) != len(right):
        return False
    return all(
        any(_digest(salt, place, _step(Mark(mark.value, tolerance), by)) == digest for by in NEIGHBOURS)
        for place, (mark, (digest, tolerance)) in enumerate(zip(row, right, strict=True))
    )


def _step(mark: Mark, by: int) -> str:
    """Return a word as it is, a number as the step of its tolerance it lies on, moved `by` steps."""
    if isinstance(mark.value, str):
        return mark.value
    if mark.tolerance == 0.0:
        return repr(mark.value + 0)
    return str(round(mark.value / mark.tolerance) + by)


@lru_cache(maxsize=100_000)
def _digest(salt: str, place: int, text: str) -> str:
    letters = text.encode("utf-8", "surrogatepass")
    return hashlib.pbkdf2_hmac("sha256", letters, f"{salt}/{place}".encode(), ROUNDS).hex()[:24]
