"""Is a wrong function wrong in one place alone?  It is edited there, called again, and every call comes out right.

    def fresh(age, limit): return age < limit      -->  line 1: "Look at what happens exactly at the bound."

What is said cannot be false: the edit was made, and all calls were right.  It says
the place and the kind of thing, not what belongs there.  Only `check` asks so, in the
learner's own kernel; grading runs nothing again that somebody wrote.  It gives up
after half a second.
"""

from __future__ import annotations

import ast
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from itertools import tee
from types import FunctionType
from typing import Any

from ...text import Text
from ..answers.form import Form
from ..answers.values import Plain, outcome_of, outcomes_of
from ..tasks.case_types import Case
from .calling import edited_as, written_by
from .edits import Edit, edits_of

__all__ = ["PATIENCE_S", "quoted", "said_of_one_place"]

PATIENCE_S = 0.5
LONGEST_LINE = 70
PLACE = Text(
    en="One change makes every call right, and it belongs in line {line}: `{text}`. {look}",
    ko="한 곳만 고치면 모든 호출의 결과가 맞습니다. 고칠 곳은 {line}번째 줄의 `{text}`입니다. {look}",
)
LOOK = {
    "through": Text(
        "Without the `try` all is right: what it catches has to go through.",
        "`try`가 없으면 모두 맞습니다. 거기서 잡는 예외를 그대로 내보내야 합니다.",
    ),
    "choice": Text(
        "One of its two ways is right in every call: nothing has to be told apart there.",
        "두 갈래 가운데 하나가 모든 호출에 맞습니다. 거기서는 경우를 나눌 필요가 없습니다.",
    ),
    "brackets": Text(
        "Brackets are missing there: `*` and `/` come before `+` and `-`, and else it goes from left to right.",
        "괄호가 빠졌습니다. `*`와 `/`를 `+`, `-`보다 먼저 계산하고, 나머지는 왼쪽부터 계산합니다.",
    ),
    "copied": Text(
        "It computes with the numbers of something else throughout: was the line copied, and not changed everywhere?",
        "한 줄 안에서 줄곧 다른 것의 값으로 계산합니다. 줄을 복사하고 다 고치지 않은 것이 아닙니까?",
    ),
    "edge": Text("Look at what happens exactly at the bound.", "경계와 정확히 같을 때 어떻게 되는지 보십시오."),
    "side": Text("Look at which side of the comparison is the larger one.", "부등호의 방향을 보십시오."),
    "order": Text("What stands there is in another order than meant.", "그 줄에 있는 것들의 순서가 잘못되었습니다."),
    "lines": Text("What follows it belongs before it.", "바로 다음에 오는 것이 먼저 와야 합니다."),
    "sign": Text("Look at the signs there.", "그 줄의 부호를 보십시오."),
    "opposite": Text("It says the opposite of what is meant.", "뜻하는 것과 반대로 되어 있습니다."),
    "logic": Text("Look at `and` and `or`.", "`and`와 `or`를 보십시오."),
    "function": Text("Look at which function or constant is used.", "어떤 함수나 상수를 쓰는지 보십시오."),
    "inverse": Text("An inverse is missing there.", "그 줄에 역변환이 빠졌습니다."),
    "field": Text("Look at which field is read.", "어느 필드를 읽는지 보십시오."),
    "member": Text("Look at which place or key is read.", "몇 번째 값이나 어느 키를 읽는지 보십시오."),
    "loop": Text("It ends the loop in its first round.", "반복이 첫 바퀴에서 끝나 버립니다."),
    "exception": Text("Look at which exception is named.", "어느 예외를 썼는지 보십시오."),
    "surplus": Text(
        "There is one step too many in it: without `{part}`, all is right.",
        "계산이 한 단계 더 들어갔습니다. `{part}`이(가) 없으면 모두 맞습니다.",
    ),
    "call": Text("One call there is too many.", "그 줄에 호출이 하나 더 있습니다."),
    "too much": Text("Without it, all is right.", "그 부분이 없으면 모두 맞습니다."),
    "operation": Text("Look at what is multiplied and what is divided.", "무엇을 곱하고 무엇을 나누는지 보십시오."),
    "number": Text("Look at the number there.", "그 줄의 숫자를 보십시오."),
    "name": Text("Another variable is meant there.", "그 줄에는 다른 변수가 와야 합니다."),
    "missing": Text("The call of a function is missing there.", "그 줄에 함수 호출이 하나 빠졌습니다."),
    "word": Text("Look at the words in quotes.", "따옴표 안의 말을 보십시오."),
}


def said_of_one_place(
    function: Any, form: Form, cases: Sequence[Case], outcomes: Sequence[Plain], patience_s: float = PATIENCE_S
) -> Text | None:
    """Return where one edit makes every call right, and what to look at; None where there is none, or it takes long.

    Args:
        function: what a learner wrote; it is called again, edited, as often as there is time.
        outcomes: what it gave in each case.
    """
    end = time.monotonic() + patience_s
    written = written_by(function)
    if written is None:
        return None
    text, first_line, tree = written
    cases = _wrong_first(form, cases, outcomes)
    with redirect_stdout(StringIO()), redirect_stderr(StringIO()):
        for edit, edited in _tried(function, tree, cases[0], form, end):
            if all(_is_right(form, edited, case) for case in cases[1:]):  # past the end, none is
                line = getattr(edit.node, "lineno", 1)
                look = LOOK[edit.kind].filled(part=_left_out(text, edit))
                return PLACE.filled(line=first_line + line - 1, text=quoted(text, tree, edit.node), look=look)
    return None


def quoted(text: str, tree: ast.Module, node: ast.AST) -> str:
    """Return a line as it was written; of a long one the longest expression around the node that can be read."""
    line = getattr(node, "lineno", 1)
    whole = text.splitlines()[line - 1].strip()
    around = (ast.get_source_segment(text, other) or "" for other in ast.walk(tree) if _holds(other, node))
    parts = [part for part in around if len(part) <= LONGEST_LINE and "\n" not in part]
    short = whole if len(whole) <= LONGEST_LINE else max(parts, key=len, default=whole[:LONGEST_LINE])
    return short.replace("`", "'")


def _left_out(text: str, edit: Edit) -> str:
    """Return the side of a sum that is left out; "" of an edit that leaves out none."""
    if edit.kind != "surplus" or not isinstance(edit.node, ast.BinOp):
        return ""
    side = edit.node.right if edit.new is edit.node.left else edit.node.left
    return (ast.get_source_segment(text, side) or "").replace("`", "'")


def _holds(other: ast.AST, node: ast.AST) -> bool:
    return isinstance(other, ast.expr) and any(inner is node for inner in ast.walk(other))


def _wrong_first(form: Form, cases: Sequence[Case], outcomes: Sequence[Plain]) -> list[Case]:
    """Return the cases, those that went wrong first: one of them refuses nearly every edit."""
    rights = [form.same(*pair) for pair in zip(outcomes, (case.expected for case in cases), strict=True)]
    return [case for _, case in sorted(zip(rights, cases, strict=True), key=lambda row: row[0])]


def _tried(
    function: FunctionType, tree: ast.Module, case: Case, form: Form, end: float
) -> Iterator[tuple[Edit, Callable[..., Any]]]:
    """Yield the edits with which this case comes out right, and the edited functions."""
    made = ((edit, edited_as(edit, function, tree, end)) for edit in edits_of(tree))
    pairs, called = tee((edit, edited) for edit, edited in made if edited is not None)
    given = outcomes_of((edited for _, edited in called), case.args or [])
    for pair, outcome in zip(pairs, given, strict=True):
        if time.monotonic() > end:
            return
        if form.same(outcome, case.expected):
            yield pair


def _is_right(form: Form, function: Callable[..., Any], case: Case) -> bool:
    return form.same(outcome_of(function, case.args or []), case.expected)
