"""Explain which options a function confuses."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ...text import Text, Texts
from ..answers.form import inside
from ..answers.forms import Choice
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised

__all__ = [
    "confused",
    "confused_in_lists",
    "seen_of",
    "word_never_returned",
    "word_of",
]

TEXTS = Texts(__file__)

MOST_NAMED = 4  # words that never come, by name


class Confusion(NamedTuple):
    """Which words are confused, in a word or two, what to say of it, the word that is asked for and that is said, and
    whether that word is said for several.

    Two that have changed places are none of these: both are as much asked for as said.
    """

    name: str
    said: Text
    wanted: str = ""
    word: str = ""
    is_of_several: bool = False


def confused(form: Choice, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Confusion | None:
    """Return which words a function confuses, the one that it confuses most first; None if it says others."""
    asked = [word_of(form, want) for want in wanted]
    said = [word_of(form, outcome) for outcome in outcomes]
    pairs = _different(asked, said)
    wrong = Counter(pair for pair in pairs if None not in pair)
    if not wrong or None in pairs[0]:  # what comes first is no word at all
        return None
    whole = {pair: count for pair, count in wrong.items() if count == asked.count(pair[0])}
    if swapped := next((pair for pair in whole if pair[::-1] in whole), None):
        one, other = swapped
        words = TEXTS["swapped"].filled(one=one, other=other)
        back = [
            {one: other, other: one}.get(word, word) if want in swapped else word
            for want, word in zip(asked, said, strict=True)
        ]
        rest = _others_confused(asked, back)
        return Confusion(f"{one} and {other} swapped", Text.joined(words, rest))
    return _most_confused(asked, said, wrong, whole)


def _most_confused(
    asked: Sequence[str | None],
    said: Sequence[str | None],
    wrong: Counter,
    whole: Mapping[tuple[str, str], int],
) -> Confusion:
    """Return the word that is said most for another, and whether it stands for several that never come."""
    (want, word), count = max((whole or wrong).items(), key=lambda row: row[1])
    never = [one for one in dict.fromkeys(asked) if (one, word) in whole and one not in said]
    if len(never) > 1:
        quoted = [f'"{one}"' for one in never[:MOST_NAMED]]
        more = len(never) - len(quoted)
        names = Text(*(", ".join(quoted) + (text if more else "") for text in (f" and {more} more", f" 외 {more}개")))
        return Confusion(
            f"{word} for all of them",
            TEXTS["none_of_them"].filled(wanted=names, said=word),
            want,
            word,
            True,
        )
    words = TEXTS["sometimes"] if not whole else TEXTS["instead"] if want in said else TEXTS["never"]
    named = words.filled(wanted=want, said=word, wrong=count, of=asked.count(want))
    return Confusion(f"{word} for {want}", named, want, word)


def _others_confused(asked: Sequence[str | None], said: Sequence[str | None]) -> Text | None:
    """Return which word is said besides for another, wherever that one is asked for."""
    wrong = Counter(_different(asked, said))
    whole = {pair: count for pair, count in wrong.items() if None not in pair and count == asked.count(pair[0])}
    return _most_confused(asked, said, wrong, whole).said if whole else None


def _different(asked: Sequence[str | None], said: Sequence[str | None]) -> list[tuple[str | None, str | None]]:
    return [(want, word) for want, word in zip(asked, said, strict=True) if want != word]


def seen_of(found: Confusion, seen: Mapping[str, Text]) -> Text | None:
    """Return what there is to see where the word that is asked for is right; of several words, of which one it is."""
    words = seen.get(found.wanted)
    if words is None or not found.is_of_several:
        return words
    return Text(f'"{found.wanted}": {words.en}', f'"{found.wanted}": {words.ko}')


def confused_in_lists(form: ListForm, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Confusion | None:
    """Return the same of lists of words, all their members together; None if a list is too long or too short."""
    if not isinstance(form.of, Choice) or any(map(is_raised, wanted)):
        return None
    pairs = [(inside(outcome), inside(want)) for outcome, want in zip(outcomes, wanted, strict=True)]
    if not all(isinstance(said, list) and len(said) == len(asked) for said, asked in pairs):
        return None
    return confused(
        form.of, [word for said, _ in pairs for word in said], [word for _, asked in pairs for word in asked]
    )


def word_never_returned(form: Choice, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Text | None:
    """Return the only word for which a function returns nothing, if it does so wherever that one is asked for."""
    pairs = {(word_of(form, want), outcome is None) for want, outcome in zip(wanted, outcomes, strict=True)}
    words = {word for word, is_nothing in pairs if is_nothing}
    if len(words) != 1 or None in words or (word := words.pop(), False) in pairs:
        return None
    return TEXTS["nothing"].filled(wanted=word)


def word_of(form: Choice, plain: Plain) -> str | None:
    """Return the option that this is; None if it is none."""
    if is_raised(plain):
        return None
    probes = form.read(plain)
    return str(probes[0][0][0].value) if probes else None
