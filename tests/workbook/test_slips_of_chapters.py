"""Every mistake that a task knows is told apart and named, alone and together with others."""

from __future__ import annotations

import pytest

from tflab.workbook.tasks.generate_cases import PUBLIC_SEED, task_cases
from tflab.workbook.tasks.reference import in_process_ros
from tflab.workbook.verdicts.mistake import Mistake
from tflab.workbook.verdicts.verdict import judge_outcomes

from .each_task import PAIRS, READS, each_task, pairs_of, singles_of, solution_of, task_in

# what two slips together may come to
SAID_MORE_SIMPLY = {Mistake.ECHO, Mistake.CONSTANT, Mistake.NOTHING_RETURNED, Mistake.RAISES}


MOST_PAIRS = 400  # of a task that has more, this many: each takes a tenth of a second, and some have fifteen hundred


@pytest.mark.proof(reads=READS)
@each_task
def test_every_slip_and_two_at_a_time_get_their_own_reply_and_the_solution_full_marks(stem, file, sample):
    task = task_in(stem, file)
    with in_process_ros():
        made = task_cases(task, PUBLIC_SEED if task.is_costly else "replies", solution_of(stem))
    for variant in sample(made.variants, 1):
        right = [case.expected for case in variant.cases]
        assert judge_outcomes(made, variant, right).mistake is None
        for name in [*singles_of(variant), *sample(_thinned(pairs_of(variant)), PAIRS)]:
            verdict = judge_outcomes(made, variant, [case.wrong[name] for case in variant.cases])
            if verdict.mistake in SAID_MORE_SIMPLY and " + " in name:
                continue
            assert verdict.mistake is Mistake.SLIP, name
            if " + " in name and len(verdict.slips) == 1 and not verdict.slips.keys() & made.feedback.keys():
                continue  # two signs that come to what anybody's one slip gives: x and y changed places, say
            if " + " in name and _is_explained_by_one(task, variant, name, verdict):
                continue
            said = " + ".join(verdict.slips)  # in two parts: in the order of the parts, not of the work
            assert said == name or (
                made.form.plain().get("parts") and sorted(verdict.slips) == sorted(name.split(" + "))
            )


def _thinned(names):
    """Return each pair, or each second, or third ..."""
    return names[:: -(-len(names) // MOST_PAIRS) or 1]


def _is_explained_by_one(task, variant, name, verdict):
    """Return whether one slip gives in each part that is wrong what the two gave together, in these numbers."""
    (one, *others), parts = verdict.slips, getattr(task.form, "parts", {})
    if others or not parts or one not in variant.cases[0].wrong:
        return False
    rows = [(case.wrong[name]["dict"], case.wrong[one]["dict"], case.expected["dict"]) for case in variant.cases]
    return all(
        form.alike(both[part], alone[part]) or form.alike(both[part], right[part])
        for both, alone, right in rows
        for part, form in parts.items()
    )
