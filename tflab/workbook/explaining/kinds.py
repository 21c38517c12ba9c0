"""Is an answer of the wrong kind in a way that is plain to see?  Nothing for a word, a class for its name.

    asked for   "none"                 "LookupException"
    given       None                   LookupException, the class itself
                the word needs quotes  `type(error).__name__` is its name

Read `habits.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..answers.form import Form
from ..answers.forms import Choice, Name
from ..answers.values import Plain
from ..words import Words

__all__ = ["kind_said", "kinds_said"]

NO_NAME = Words(
    en='Python\'s None is nothing; if you mean the word, write it in quotes: "none"',
    ko='파이썬의 None은 아무것도 없다는 뜻입니다. 그 낱말을 쓰려면 따옴표로 묶으십시오: "none"',
)
A_CLASS = Words(
    en="That is a class itself, and a word is asked for: `type(error).__name__` is the name of an error's class",
    ko="클래스 자체를 넘겼습니다. 여기서 필요한 것은 낱말입니다. 예외 클래스의 이름은 `type(error).__name__`입니다",
)
AN_ERROR = Words(
    en="That is an exception itself, and a word is asked for: `type(error).__name__` is the name of its class",
    ko="예외 자체를 넘겼습니다. 여기서 필요한 것은 낱말입니다. 그 클래스의 이름은 `type(error).__name__`입니다",
)


def kind_said(form: Form, outcome: Plain) -> Words | None:
    """Return what to say of an answer where a word is asked for and something else stands; None if nothing is plain."""
    if outcome is None and (isinstance(form, Name) or (isinstance(form, Choice) and "none" in form.options)):
        return NO_NAME
    if not isinstance(form, Name | Choice) or not isinstance(outcome, dict):
        return None
    held = str(outcome.get("object"))
    return A_CLASS if held == "type" else AN_ERROR if "returned and not raised" in held else None


def kinds_said(form: Form, outcomes: Sequence[Plain]) -> list[Words]:
    """Return the same of all calls of a function, each once."""
    return list(dict.fromkeys(words for outcome in outcomes if (words := kind_said(form, outcome)) is not None))
