"""How is an answer typed?  Part by part, words without quotes, numbers and expressions as Python has them.

    base_link = (1.2, 0.3, 0)                       a number, a tuple, e3_2.base_T_laser.apply(...)
     1 usable
     2 no frame
    a = 2                                           an option by its number, or by its words
    b = map, laser_frame                            a list of names

Enter keeps what was typed before.  Trees, files and messages are written in a file.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ..answers.forms import Choice, Command, Form, Message, Name, Pair, Parts, Proof, Sequence, Set, Tree, Urdf

__all__ = ["WORDS", "Mistyped", "Said", "ask_for", "can_be_typed"]

WORDS = ("hint", "skip", "solution", "quit")
IN_A_FILE = (Tree, Urdf, Message, Pair, Proof)
BRACKETS = ("[", "(", "{")


class Said(Exception):
    """A word was typed that is no answer: one of WORDS."""


class Mistyped(Exception):
    """What was typed is not what was asked for; the text says what is wrong with it."""


def can_be_typed(form: Form) -> bool:
    """Return whether an answer of a form fits into lines; else it is written in a file."""
    if isinstance(form, Parts):
        return all(map(can_be_typed, form.parts.values()))
    if isinstance(form, Sequence | Set):
        return can_be_typed(form.of)
    return not isinstance(form, IN_A_FILE)


def ask_for(
    name: str, form: Form, typed: Mapping[str, str], space: Mapping[str, Any], ask: Callable[[str, str], str]
) -> Any:
    """Return the answer that is typed for a form; `...` where nothing is.

    Args:
        typed: what was typed before, by part; "" is the whole.
        space: what an expression may use.
        ask: shows a prompt, and returns what is typed for a part.

    Raises:
        Said: a word was typed instead.
    """
    if isinstance(form, Parts):
        options = ["", *map(_options, form.parts.values())]
        return {
            part: _asked(part, part, inner, typed, space, ask, options[number] != options[number - 1])
            for number, (part, inner) in enumerate(form.parts.items(), start=1)
        }
    return _asked(name, "", form, typed, space, ask, True)


def _asked(
    name: str,
    part: str,
    form: Form,
    typed: Mapping[str, str],
    space: Mapping[str, Any],
    ask: Callable[[str, str], str],
    shows_options: bool,
) -> Any:
    before = typed.get(part, "")
    prompt = f"{name}{f' (Enter: {before})' if before else ''} = "
    label = _options(form) * shows_options + prompt
    while True:
        text = ask(label, part).strip() or before
        if text in WORDS:
            raise Said(text)
        if not text:
            return ...
        try:
            return value_of(text, form, space)
        except Mistyped as wrong:
            label = f"  {wrong}\n{prompt}"


def value_of(text: str, form: Form, space: Mapping[str, Any]) -> Any:
    """Return the value that a line says.

    Raises:
        Mistyped: it is no expression, and something else than words is wanted.
    """
    if isinstance(form, Choice):
        return _option(text, form)
    if isinstance(form, Name | Command):
        return _unquoted(text)
    if isinstance(form, Sequence | Set) and not text.startswith(BRACKETS) and isinstance(form.of, Choice | Name):
        return [value_of(word.strip(), form.of, space) for word in text.split(",")]
    try:
        return eval(text, dict(space))  # the learner's own machine, and their own line
    except Exception as error:
        raise Mistyped(f"{type(error).__name__}: {error}") from None


def _option(text: str, form: Choice) -> str:
    number = int(text) if text.isdigit() else 0
    return form.options[number - 1] if 1 <= number <= len(form.options) else _unquoted(text)


def _unquoted(text: str) -> str:
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text


def _options(form: Form) -> str:
    held = form.of if isinstance(form, Sequence | Set) else form
    if not isinstance(held, Choice):
        return ""
    return "".join(f"  {number:>2} {option}\n" for number, option in enumerate(held.options, start=1))
