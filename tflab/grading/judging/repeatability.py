"""Merge the outcomes of two runs of one answer; a case where they differ has no outcome.

    first run     2.0   raised   5.0   1.0
    second run    2.0   3.0      4.0   -              asked in another order, in a fresh kernel
    merged        2.0   3.0     (none) 1.0

A run that gave no value at all for a case is no answer: another answer may have been in
its way (`math = 3`), so the other run counts.  Who gives a value now and none then, in one
run, has changed their mind.  Nowhere does the better of two count: that would be two
guesses for one task.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tflab.workbook.answers.forms import Form, form_from_plain

from .draw import asks_of
from .task_score import limit_size, most_members

__all__ = ["merge_runs", "reverse_order"]


def reverse_order(task: Mapping[str, Any]) -> dict[str, Any]:
    """Return a task as it is asked in a second run: the last first."""
    return dict(task) | {"asks": list(reversed(asks_of(task)))}


def merge_runs(
    task: Mapping[str, Any], first: Mapping[int, Any], second: Mapping[int, Any]
) -> tuple[dict[str, Any], dict[int, Any]]:
    """Return a task as it was asked in two runs, and its outcomes; `second` is of `reverse_order`."""
    asks, asks_again = asks_of(task), reverse_order(task)["asks"]
    form = form_from_plain(task["form"])
    most = most_members(case["expected"] for case in task["cases"])
    outcomes = dict(first) | {len(asks) + place: outcome for place, outcome in second.items()}
    outcomes = {place: limit_size(outcome, most) for place, outcome in outcomes.items()}
    both = [*asks, *asks_again]
    of_run = {place: (both[place], place < len(asks)) for place in outcomes}  # its case, and whether in the first run
    values = {of_run[place] for place, outcome in outcomes.items() if _is_a_value(form, outcome)}
    kept = {}
    for place, (case, is_first) in of_run.items():
        if (case, is_first) in values or (case, not is_first) not in values:
            kept[place] = outcomes[place]
    return dict(task) | {"asks": both}, kept


def _is_a_value(form: Form, outcome: Any) -> bool:
    """Return whether an outcome is of the form that is wanted, in all its parts."""
    probes = form.read(outcome)
    return probes is not None and all(probes)
