"""What was meant by a word that is none to choose from?  Another part's, nearly one of these, a topic with a name.

    "a"       "start the driver"     that is to choose from under "a do"
    "moving"  "/dolly/tf"            another topic than "/tf"
    "cause"   "laser clock ahed"     nearly "laser clock ahead"
    "switch"  "off"                  "False" means that here

Only what stands in the question is said.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping

from ...text import Text
from ..answers.form import Form
from ..answers.forms import Choice, Parts
from ..answers.values import Plain

__all__ = ["near_an_option", "no_options_either", "one_part_alone", "option_of_another", "raised_option"]

ON, OFF = ("true", "on", "yes"), ("false", "off", "no")
NEAR = 0.8  # share of letters that two words have in common
ANOTHERS = Text(
    en='It is one of those to choose from under "{name}". Look whether two keys are exchanged',
    ko='"{name}"의 보기에 있는 낱말입니다. 두 키를 서로 바꾸어 썼는지 보십시오',
)
NEARLY = Text(en='The nearest of them is "{option}"', ko='가장 비슷한 보기는 "{option}"입니다')
ALONE = Text(
    en='That is the word for "{name}" alone, and each of these is asked for each time',
    ko='"{name}"에 들어갈 낱말 하나뿐입니다. 이것들이 언제나 모두 있어야 합니다',
)
NEITHER = Text(en="Not among them either: {parts}", ko="역시 보기에 없는 답: {parts}")
RAISED = Text(
    en='"{option}" is an answer: it is returned, not raised, `return "{option}"`',
    ko='"{option}"은(는) 답입니다. 예외로 일으키지 말고 반환하십시오: `return "{option}"`',
)
A_TOPIC = Text(
    en='With a name in front it is another topic: whoever listens on "{option}" hears nothing of it',
    ko='앞에 이름을 붙이면 다른 토픽입니다. "{option}"을(를) 듣는 노드는 그것을 받지 못합니다',
)


def near_an_option(form: Choice, answer: str) -> Text | None:
    """Return which option a word is near to, or is with a name in front; None if it is near none."""
    topic = next((one for one in form.options if one.startswith("/") and answer.endswith(one)), None)
    if topic is not None:
        return A_TOPIC.filled(option=topic)
    near = difflib.get_close_matches(answer[:100], form.options, 1, NEAR)
    meant = next((words for words in (ON, OFF) if answer.lower() in words), ())
    near += [option for option in form.options if option.lower() in meant]
    return NEARLY.filled(option=near[0]) if near else None


def raised_option(form: Form, text: str) -> Text | None:
    """Return that an option was raised as an error's text; None of any other error."""
    option = form.option(text) if isinstance(form, Choice) and text else None
    return None if option is None else RAISED.filled(option=option)


def one_part_alone(form: Parts, outcome: Plain) -> Text | None:
    """Return which part a word is for that was given where all parts are asked for; None if it is for none."""
    if not isinstance(outcome, str):
        return None
    parts = (name for name, part in form.parts.items() if isinstance(part, Choice) and part.option(outcome) is not None)
    name = next(parts, None)
    return ALONE.filled(name=name) if name else None


def option_of_another(form: Parts, name: str, answer: Plain) -> Text | None:
    """Return under which other part a word is to choose from; None if it is under none, or of a kind of its own."""
    for other, part in form.parts.items():
        if other != name and isinstance(part, Choice) and part.options and part.option(answer) is not None:
            return ANOTHERS.filled(name=other)
    return None


def no_options_either(form: Parts, name: str, answers: Mapping[str, Plain]) -> Text | None:
    """Return which other parts hold words that are none to choose from; None if no other does."""
    bad = [
        f'"{other}": "{answers[other]}"'
        for other, part in form.parts.items()
        if other != name and isinstance(part, Choice) and isinstance(answers[other], str)
        and part.option(answers[other]) is None
    ]  # fmt: skip
    return NEITHER.filled(parts=", ".join(bad)) if bad else None
