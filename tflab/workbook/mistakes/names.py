"""What is wrong with a name?  Its letters, its slashes, or nothing was filled in.

    asked for   red/odom   odom         given   /red/odom   /odom      one begins with a slash that should not,
                red/arm/tool0                   red//arm/tool0         another holds two slashes in a row
                                                {prefix}/{name}        an f before the quotes is missing

Each name is looked at beside the one that is asked for; what is told is so in the learner's
own.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from ...text import Text, Texts
from ..answers.form import Form
from ..answers.forms import Command, Name
from ..answers.values import Plain, is_raised

__all__ = ["of_names", "renamed", "unfilled"]

TEXTS = Texts(__file__)

RENAMED: dict[str, Callable[[str], str]] = {
    "other case": str.lower,
    "slash in front": lambda name: name.removeprefix("/"),
    "no slash in front": lambda name: name if name.startswith("/") else f"/{name}",
    "space around": str.strip,
    "other separator": lambda name: re.sub(r"[_.:-]+", "/", name, count=1) if "/" not in name else name,
}
BRACES = re.compile(r"(?<!\$)\{[A-Za-z_][^{}:\"\s]*(?:\s[-+*/]\s?[^{}:\"\s]+)*(?::(?:[.\d]*[a-z]|\.\d+))?\}")
FACTS: dict[str, Callable[[str, str], bool]] = {  # of a name and of the one that is asked for
    "nothing": lambda one, want: not one and bool(want),
    "slash in front": lambda one, want: one.startswith("/") and not want.startswith("/"),
    "slashes in a row": lambda one, want: "//" in one.lstrip("/") and "//" not in want,
    "slash behind": lambda one, want: len(one) > 1 and one.endswith("/") and not want.endswith("/"),
    "too little in front": lambda one, want: bool(one.strip("/")) and want.endswith("/" + one.strip("/")),
    "too much in front": lambda one, want: bool(want) and one.strip("/").endswith("/" + want),
    "other letters": lambda one, want: one != want and one.lower() == want.lower(),
}


def unfilled(form: Form, outcomes: Sequence[Plain]) -> Text | None:
    """Return what to say of texts in whose braces nothing was filled in; None if there is none."""
    texts = [outcome for outcome in outcomes if isinstance(outcome, str)]
    if not isinstance(form, Name | Command) or len(texts) < len(outcomes):
        return None
    first = next(filter(None, map(BRACES.search, texts)), None)
    if first is None:
        return None
    return TEXTS["unfilled"].filled(text=first[0])


def of_names(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Text | None:
    """Return what can be seen at the names that a function gives; None unless that covers all that are wrong."""
    if not isinstance(form, Name) or any(map(is_raised, wanted)):
        return None
    wrong = _that_differ(outcomes, wanted)
    shows = {name: [pair for pair in wrong if is_shown(*pair)] for name, is_shown in FACTS.items()}
    seen = [pair for pairs in shows.values() for pair in pairs]
    if not wrong or any(pair not in seen for pair in wrong):
        return None
    said = [_filled(TEXTS[name], pairs, wrong) for name, pairs in shows.items() if pairs]
    return Text("; ".join(words.en for words in said) + ".", ". ".join(words.ko for words in said) + ".")


def _that_differ(outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> list[tuple[str, str]]:
    """Return the names that are wrong, each beside the one that is asked for; none if one is no text."""
    wrong = [(given, want) for given, want in zip(outcomes, wanted, strict=True) if given != want]
    return wrong if all(isinstance(word, str) for pair in wrong for word in pair) else []


def _filled(words: Text, pairs: list[tuple[str, str]], wrong: list[tuple[str, str]]) -> Text:
    return TEXTS["in"].filled(count=len(pairs), of=len(wrong), fact=words.filled(one=pairs[0][0]))


def renamed(answer: Plain) -> Iterator[tuple[str, Plain]]:
    """Yield a name, a set of names or a tree as it would be if each of its names were written otherwise."""
    ways = {name: _changed(answer, change) for name, change in RENAMED.items()}
    yield from ((name, left) for name, left in ways.items() if left != answer)


def _changed(plain: Plain, change: Callable[[str], str]) -> Plain:
    if isinstance(plain, str):
        return change(plain)
    if isinstance(plain, list):
        return [_changed(member, change) for member in plain]
    if isinstance(plain, dict) and set(plain) in ({"tuple"}, {"set"}):
        return {kind: _changed(held, change) for kind, held in plain.items()}
    if isinstance(plain, dict) and set(plain) == {"dict"} and isinstance(plain["dict"], dict):
        return {"dict": {change(key): _changed(value, change) for key, value in plain["dict"].items()}}
    return plain
