"""Try an answer on its cases, judge it, and word the reply.

    task as a learner has it  +  answer  -->  outcomes  -->  verdict (verdict.py)  -->  texts (failure.py)

`check` asks so about an exercise, and practice about what it has drawn.
"""

from __future__ import annotations

import inspect
import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ..text import Text
from .answers.forms import Sequence as SequenceForm
from .answers.values import Plain, is_raised, is_unanswered, outcome_of
from .assigned_task import AssignedTask
from .call_limits import CALL_S, TimeLimitError, call_limits
from .diagnosis.error_line import error_line, hidden_error
from .diagnosis.failure import REPLIES, Failure
from .diagnosis.lint import describe_function_text
from .diagnosis.verdict import Verdict, judge_outcomes, kind_of
from .phrases import PHRASES
from .replay import describe_call, remember_call, show_call
from .reply_card import shell, show_caption, show_reply

__all__ = ["judge_answer", "show_hint", "show_verdict"]

DRAWN = {Failure.KNOWN, Failure.VALUE, Failure.UNIT, Failure.PARTS, Failure.ECHO}  # beside the right one
END = (".", "?", "!")


def judge_answer(assigned: AssignedTask, answer: Any) -> tuple[Verdict, list[Plain]]:
    """Return the verdict, and what came out of each case."""
    cases = assigned.variant.cases
    if not assigned.cases.is_function:
        outcomes = [outcome_of(lambda: answer, ())]
        return judge_outcomes(assigned.cases, assigned.variant, outcomes), outcomes
    if not callable(answer):
        failure = Failure.UNANSWERED if answer is ... else Failure.NOT_A_FUNCTION
        verdict = Verdict(0, len(cases), failure, detail={"got": kind_of(outcome_of(lambda: answer, ()))})
        return verdict, []
    return _judge_function(assigned, answer)


def _judge_function(assigned: AssignedTask, answer: Any) -> tuple[Verdict, list[Plain]]:
    """Return the verdict on a function, and what it gave in each case."""
    cases, outcomes, lines = assigned.variant.cases, [], 0
    for number, case in enumerate(cases):
        try:
            with call_limits(CALL_S) as printed:
                first = outcome_of(answer, case.args)
            again = _call_again(answer, case.args)
            if case is cases[-1] and _call_again(answer, cases[0].args) != [*outcomes, first][0]:
                again = {}  # calls in between have changed what the first one gives
        except (KeyboardInterrupt, TimeLimitError) as stopped:
            failure = Failure.ENDLESS if isinstance(stopped, TimeLimitError) else Failure.INTERRUPTED
            return Verdict(0, len(cases), failure, case=number, detail=_stopped_call(assigned, number)), []
        lines += printed.lines
        if is_raised(first) and first["raises"] == MemoryError.__name__:
            detail = _stopped_call(assigned, number)
            return Verdict(0, len(cases), Failure.OUT_OF_MEMORY, case=number, detail=detail), []
        if first != again:
            return Verdict(0, len(cases), Failure.UNSTEADY, case=number, detail=_remembered(answer)), []
        outcomes.append(first)
        if number == 0 and is_unanswered(first):
            behind = describe_function_text(answer)  # an answer, perhaps, behind the `raise`
            return Verdict(0, len(cases), Failure.UNANSWERED, detail={"place": behind} if behind else {}), []
    verdict = judge_outcomes(assigned.cases, assigned.variant, outcomes)
    verdict = replace(verdict, detail=verdict.detail | {"printed": lines} if lines else verdict.detail)
    return _with_its_place(assigned, answer, verdict, outcomes)


def _call_again(answer: Any, args: Sequence[Plain] | None) -> Plain:
    with call_limits(CALL_S):
        return outcome_of(answer, args)


def _remembered(answer: Any) -> dict[str, Any]:
    """Return in which default argument a function keeps what earlier calls left; nothing if in none."""
    try:
        parameters = inspect.signature(answer).parameters.values()
    except (TypeError, ValueError):
        return {}
    names = [each.name for each in parameters if isinstance(each.default, list | dict | set) and each.default]
    return {"tip": PHRASES["default"].filled(name=names[0])} if names else {}


def _stopped_call(assigned: AssignedTask, number: int) -> dict[str, Any]:
    return {"seconds": CALL_S, "call": show_call(assigned, number)}


def _with_its_place(
    assigned: AssignedTask, answer: Any, verdict: Verdict, outcomes: list[Plain]
) -> tuple[Verdict, list[Plain]]:
    """Return the verdict with what is plain to see in the text of a wrong function, or where it stopped."""
    if verdict.failure is not None:
        remember_call(assigned, verdict.case, answer)
    if verdict.failure is None or os.environ.get("NBGRADER_EXECUTION"):
        return verdict, outcomes
    case = assigned.variant.cases[verdict.case]
    stop = error_line(answer, case.args) if is_raised(outcomes[verdict.case]) else None
    if stop is not None:
        is_other = stop.is_own_raise and is_raised(case.expected) and verdict.failure is Failure.RAISES
        failure = Failure.OTHER_EXCEPTION if is_other else verdict.failure
        tip = {"tip": Text("", "")} if stop.is_cause else {}
        tip |= {"meant": case.expected["raises"]} if is_other else {}
        return replace(verdict, failure=failure, detail=verdict.detail | tip | {"place": stop.said}), outcomes
    place = hidden_error(answer, case.args) or describe_function_text(answer)
    return (replace(verdict, detail=verdict.detail | {"place": place}) if place else verdict), outcomes


# -- saying ---------------------------------------------------------------------------


def show_hint(assigned: AssignedTask, number: int) -> None:
    """Show a task's hints up to this number, in their order."""
    hints = [assigned.words(hint) for hint in assigned.cases.hints]
    of = min(number, len(hints))
    head = assigned.phrase("hint_number" if number <= len(hints) else "last_hint", number=number)
    lines = [f"{number}. {hint}" for number, hint in enumerate(hints[:of], 1)]
    show_reply(f"{assigned.id} · {head}", hints[0] if of == 1 else "\n".join(lines))


def show_verdict(
    assigned: AssignedTask, verdict: Verdict, outcomes: list[Plain], more: Sequence[str] = (), draws: bool = True
) -> None:
    """Show the reply to an answer.

    Args:
        more: lines that go with it, smaller.
        draws: whether a wrong value may be drawn beside the right one, which tells the number; a function's always is.
    """
    score = f"{assigned.id} {'✗' if verdict.failure else '✓'} {assigned.score(verdict.passed, verdict.of)}"
    if verdict.failure is None:
        show_reply(score, more=more, kind="passed")
        return
    if verdict.failure is Failure.UNANSWERED:
        said = Text.joined(REPLIES[verdict.failure], verdict.detail.get("place"))
        show_reply(assigned.id, assigned.words(said))
        return
    if assigned.cases.is_function and outcomes:
        if lines := verdict.detail.get("printed"):
            more = [assigned.phrase("printed", lines=lines), *more]
        more = [describe_call(assigned, verdict.case, outcomes[verdict.case]), *more]
    show_reply(score, _reply(assigned, verdict), more, "wrong")
    if draws or assigned.cases.is_function:
        _show_both(assigned, verdict, outcomes)


def _reply(assigned: AssignedTask, verdict: Verdict) -> str:
    place = verdict.detail.get("place")
    if verdict.said is not None and verdict.failure is Failure.KNOWN:
        return assigned.words(Text.joined(verdict.said, place))
    names = {name: _listed(held) if isinstance(held, list) else held for name, held in verdict.detail.items()}
    bounds, tip = names.get("certain"), names.get("tip")
    certain = assigned.words(bounds).removeprefix(f"{names.get('wrong')}: ") if bounds else ""
    names["certain"] = f" ({certain})" if certain else ""
    names["tip"] = f". {assigned.words(tip)}" if tip and tip.en else ""
    names = {"answer": assigned.cases.answer, "wanted": _wanted(assigned, verdict)} | names
    text = assigned.words(REPLIES[verdict.failure], **names)
    if place:
        text = f"{text if text.endswith(END) else text + '.'} {assigned.words(place)}"
    return f'"{names["part"]}": {text}' if "part" in names else text


def _listed(names: list[str]) -> str:
    return ", ".join(f'"{name}"' for name in names)


def _wanted(assigned: AssignedTask, verdict: Verdict) -> str:
    form = assigned.cases.form
    part = verdict.detail.get("part")
    form = form.parts[part] if part else form
    if verdict.failure is Failure.OPTION and isinstance(form, SequenceForm):
        form = form.of
    return form.wanted().say(assigned.workbook.language)


def _show_both(assigned: AssignedTask, verdict: Verdict, outcomes: list[Plain]) -> None:
    """Draw the answer beside the right one, where both are in space, and say which is whose."""
    if not outcomes or verdict.failure not in DRAWN or shell() is None:
        return
    try:
        from .diagnosis.comparison import picture_of
    except ModuleNotFoundError as missing:  # the reply is complete without the figure
        show_caption(str(missing))
        return
    picture = picture_of(assigned.cases.form, outcomes[verdict.case], assigned.variant.cases[verdict.case].expected)
    if picture is not None:
        from IPython.display import display

        display(picture)
        show_caption(assigned.phrase("drawn"))
