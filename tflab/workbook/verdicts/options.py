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

from ...text import Text, Texts
from ..answers.form import Form
from ..answers.forms import Choice, Parts
from ..answers.values import Plain

__all__ = ["near_an_option", "no_options_either", "one_part_alone", "option_of_another", "raised_option"]

TEXTS = Texts(__file__)

ON, OFF = ("true", "on", "yes"), ("false", "off", "no")
NEAR = 0.8  # share of letters that two words have in common


def near_an_option(form: Choice, answer: str) -> Text | None:
    """Return which option a word is near to, or is with a name in front; None if it is near none."""
    topic = next((one for one in form.options if one.startswith("/") and answer.endswith(one)), None)
    if topic is not None:
        return TEXTS["a_topic"].filled(option=topic)
    near = difflib.get_close_matches(answer[:100], form.options, 1, NEAR)
    meant = next((words for words in (ON, OFF) if answer.lower() in words), ())
    near += [option for option in form.options if option.lower() in meant]
    return TEXTS["nearly"].filled(option=near[0]) if near else None


def raised_option(form: Form, text: str) -> Text | None:
    """Return that an option was raised as an error's text; None of any other error."""
    option = form.option(text) if isinstance(form, Choice) and text else None
    return None if option is None else TEXTS["raised"].filled(option=option)


def one_part_alone(form: Parts, outcome: Plain) -> Text | None:
    """Return which part a word is for that was given where all parts are asked for; None if it is for none."""
    if not isinstance(outcome, str):
        return None
    parts = (name for name, part in form.parts.items() if isinstance(part, Choice) and part.option(outcome) is not None)
    name = next(parts, None)
    return TEXTS["alone"].filled(name=name) if name else None


def option_of_another(form: Parts, name: str, answer: Plain) -> Text | None:
    """Return under which other part a word is to choose from; None if it is under none, or of a kind of its own."""
    for other, part in form.parts.items():
        if other != name and isinstance(part, Choice) and part.options and part.option(answer) is not None:
            return TEXTS["anothers"].filled(name=other)
    return None


def no_options_either(form: Parts, name: str, answers: Mapping[str, Plain]) -> Text | None:
    """Return which other parts hold words that are none to choose from; None if no other does."""
    bad = [
        f'"{other}": "{answers[other]}"'
        for other, part in form.parts.items()
        if other != name and isinstance(part, Choice) and isinstance(answers[other], str)
        and part.option(answers[other]) is None
    ]  # fmt: skip
    return TEXTS["neither"].filled(parts=", ".join(bad)) if bad else None
