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

from ...text import Text
from ..answers.form import Form
from ..answers.forms import Command, Name
from ..answers.values import Plain, is_raised

__all__ = ["of_names", "renamed", "unfilled"]

RENAMED: dict[str, Callable[[str], str]] = {
    "other case": str.lower,
    "slash in front": lambda name: name.removeprefix("/"),
    "no slash in front": lambda name: name if name.startswith("/") else f"/{name}",
    "space around": str.strip,
    "other separator": lambda name: re.sub(r"[_.:-]+", "/", name, count=1) if "/" not in name else name,
}
UNFILLED = Text(
    en='`{text}` still stands in the text: nothing was filled in. An f before the quotes does it, as in f"…".',
    ko='값이 채워지지 않고 `{text}` 그대로 남아 있습니다. f"…"처럼 따옴표 앞에 f를 붙이십시오.',
)
BRACES = re.compile(r"(?<!\$)\{[A-Za-z_][^{}:\"\s]*(?:\s[-+*/]\s?[^{}:\"\s]+)*(?::(?:[.\d]*[a-z]|\.\d+))?\}")
IN = Text("in {count} of the {of} names that are wrong: {fact}", "틀린 이름 {of}개 가운데 {count}개에서 {fact}")
FACTS: dict[str, tuple[Callable[[tuple[str, str]], bool], Text]] = {
    "nothing": (
        lambda pair: not pair[0] and bool(pair[1]),
        Text("nothing is left of it", "이름이 비어 있습니다"),
    ),
    "slash in front": (
        lambda pair: pair[0].startswith("/") and not pair[1].startswith("/"),
        Text("a slash in front, `{one}`", "맨 앞에 슬래시가 있습니다(`{one}`)"),
    ),
    "slashes in a row": (
        lambda pair: "//" in pair[0].lstrip("/") and "//" not in pair[1],
        Text("two slashes in a row, `{one}`", "슬래시가 연달아 있습니다(`{one}`)"),
    ),
    "slash behind": (
        lambda pair: len(pair[0]) > 1 and pair[0].endswith("/") and not pair[1].endswith("/"),
        Text("a slash at the end, `{one}`", "맨 끝에 슬래시가 있습니다(`{one}`)"),
    ),
    "too little in front": (
        lambda pair: bool(pair[0].strip("/")) and pair[1].endswith("/" + pair[0].strip("/")),
        Text("what belongs before the frame is missing, `{one}`", "좌표계 앞에 있어야 할 것이 없습니다(`{one}`)"),
    ),
    "too much in front": (
        lambda pair: bool(pair[1]) and pair[0].strip("/").endswith("/" + pair[1]),
        Text("something before the frame that does not belong there, `{one}`",
              "좌표계 앞에 없어야 할 것이 있습니다(`{one}`)"),
    ),
    "other letters": (
        lambda pair: pair[0] != pair[1] and pair[0].lower() == pair[1].lower(),
        Text("other capitals, `{one}`", "대소문자가 다릅니다(`{one}`)"),
    ),
}  # fmt: skip


def unfilled(form: Form, outcomes: Sequence[Plain]) -> Text | None:
    """Return what to say of texts in whose braces nothing was filled in; None if there is none."""
    texts = [outcome for outcome in outcomes if isinstance(outcome, str)]
    if not isinstance(form, Name | Command) or len(texts) < len(outcomes):
        return None
    first = next(filter(None, map(BRACES.search, texts)), None)
    if first is None:
        return None
    return UNFILLED.filled(text=first[0])


def of_names(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Text | None:
    """Return what can be seen at the names that a function gives; None unless that covers all that are wrong."""
    if not isinstance(form, Name) or any(map(is_raised, wanted)):
        return None
    wrong = _that_differ(outcomes, wanted)
    shows = {name: list(filter(is_shown, wrong)) for name, (is_shown, _) in FACTS.items()}
    seen = [pair for pairs in shows.values() for pair in pairs]
    if not wrong or any(pair not in seen for pair in wrong):
        return None
    said = [_filled(FACTS[name][1], pairs, wrong) for name, pairs in shows.items() if pairs]
    return Text("; ".join(words.en for words in said) + ".", ". ".join(words.ko for words in said) + ".")


def _that_differ(outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> list[tuple[str, str]]:
    """Return the names that are wrong, each beside the one that is asked for; none if one is no text."""
    wrong = [(given, want) for given, want in zip(outcomes, wanted, strict=True) if given != want]
    return wrong if all(isinstance(word, str) for pair in wrong for word in pair) else []


def _filled(words: Text, pairs: list[tuple[str, str]], wrong: list[tuple[str, str]]) -> Text:
    return IN.filled(count=len(pairs), of=len(wrong), fact=words.filled(one=pairs[0][0]))


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
