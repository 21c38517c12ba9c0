"""Read the items of the concept inventory, check their balance, and write their questions onto a page.

    item 3, M3    form A   B is at (2, 0), turned 90 degrees to the left ...      a M3   b M1   c M3   d right
                  form B   B is at (3, 0), turned 90 degrees to the right ...     a M3   b right   c M3   d M1

The items are in `solutions/inventory.yaml`, each with its misconception and two forms.  A learner's copy holds
the questions, and nothing of the key.  A form is balanced if each item has one right option, each wrong option
shows a misconception, both forms of an item ask for the same one, and no letter is right more than five times.

The sources of the two exercises hold the questions between the cells "questions" and "e0-1-answer".
`python -m tflab.workbook.course.contents` writes them there.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from ...text import LANGUAGES, Text, load_yaml
from ..paths import workbook_data
from ..tasks.task import slug

__all__ = [
    "DO_NOT_KNOW",
    "FORMS",
    "LETTERS",
    "MISCONCEPTIONS_ASKED",
    "MOST_OF_A_LETTER",
    "RIGHT",
    "SOURCES",
    "Item",
    "Option",
    "Wording",
    "imbalances",
    "inventory_file",
    "parsed",
    "question",
    "read_inventory",
    "with_questions",
]

FORMS = {"A": "E0.1", "B": "E12.8"}  # and the task that each is: before, and after
LETTERS = "abcd"
RIGHT = "right"  # in the place of a misconception


class Option(NamedTuple):
    """One option: what it says, the misconception that it shows (RIGHT if none), and what to say of it later."""

    says: Text
    shows: str
    why: Text


class Wording(NamedTuple):
    """An item as one form words it: the question, and its options by letter."""

    stem: Text
    options: dict[str, Option]

    @property
    def right(self) -> str:
        """The letter of the right option; of several, which is a fault, the first."""
        return next((letter for letter, option in self.options.items() if option.shows == RIGHT), "")


class Item(NamedTuple):
    """One item: its misconception, what it is about, the task that goes with it, and its wording in each form."""

    misconception: str
    about: Text
    task: str
    forms: dict[str, Wording]

    def shown_by(self, form: str, letter: str) -> str:
        """Return the misconception that an option shows; "" of the right one, and of "I do not know"."""
        option = self.forms[form].options.get(letter)
        return option.shows if option is not None and option.shows != RIGHT else ""


def inventory_file() -> Path:
    """Return the file that holds the items, the key and the sentences."""
    return workbook_data() / "solutions" / "inventory.yaml"


def read_inventory() -> tuple[Item, ...]:
    """Return the items in order; none where the workbook has no test."""
    path = inventory_file()
    return _read(path, path.stat().st_mtime_ns) if path.is_file() else ()


@cache
def _read(path: Path, _mtime_ns: int) -> tuple[Item, ...]:
    return parsed(path.read_text(encoding="utf-8"))


def parsed(text: str) -> tuple[Item, ...]:
    """Return the items that a text in YAML holds."""
    return tuple(_item(line) for line in load_yaml(text)["items"])


def _item(line: dict[str, Any]) -> Item:
    return Item(line["shows"], _words(line["about"]), line["task"], {form: _wording(line[form]) for form in FORMS})


def _wording(line: dict[str, Any]) -> Wording:
    options = {letter: line[letter] for letter in LETTERS if letter in line}
    return Wording(
        _words(line["asks"]),
        {
            letter: Option(_words(option["says"]), option["shows"], _words(option["why"]))
            for letter, option in options.items()
        },
    )


def _words(held: Any) -> Text:
    """Return a text in both languages; numbers alone are the same in both."""
    return Text(str(held), str(held)) if not isinstance(held, dict) else Text(held["en"], held["ko"])


MISCONCEPTIONS_ASKED = tuple(f"M{number}" for number in range(1, 16))
MOST_OF_A_LETTER = 5


def imbalances(items: Sequence[Item], form: str) -> Iterator[str]:
    """Yield what is out of balance in a form, and where it is no match for the other."""
    asked = tuple(item.misconception for item in items)
    if asked != MISCONCEPTIONS_ASKED:
        yield f"its items look for {', '.join(asked)}, and one for each of M1 to M15 is wanted, in this order"
    for number, item in enumerate(items, start=1):
        yield from (f"form {form}, item {number}: {fault}" for fault in _of_item(item, form))
    letters = Counter(item.forms[form].right for item in items)
    for letter, count in sorted(letters.items()):
        if count > MOST_OF_A_LETTER:
            yield f'form {form}: "{letter}" is right {count} times, more than {MOST_OF_A_LETTER}'


def _of_item(item: Item, form: str) -> Iterator[str]:
    options = item.forms[form].options
    right = [letter for letter, option in options.items() if option.shows == RIGHT]
    if "".join(options) != LETTERS:
        yield f"it has the options {', '.join(options)}, not {', '.join(LETTERS)}"
    if len(right) != 1:
        yield f"{len(right)} options are right ({', '.join(right) or 'none'}), and one has to be"
    for letter, option in options.items():
        if option.shows != RIGHT and option.shows not in MISCONCEPTIONS_ASKED:
            yield f'option "{letter}" shows no misconception of M1 to M15 ("{option.shows}")'
    for other in FORMS:
        shown = {option.shows for option in item.forms[other].options.values()}
        if item.misconception not in shown:
            yield f"it looks for {item.misconception}, which no option of form {other} shows"


SOURCES = {"A": "solutions/src/00_start.py", "B": "solutions/src/12_owners_and_diagnosis.py"}
DO_NOT_KNOW = Text("I do not know", "모르겠습니다")


def question(item: Item, number: int, form: str, language: str) -> str:
    """Return one question with its options, as a page has it."""
    wording = item.forms[form]
    options = [(letter, option.says) for letter, option in wording.options.items()] + [("e", DO_NOT_KNOW)]
    lines = [f"- **{letter}** {says.say(language)}" for letter, says in options]
    return "\n".join([f"**{number}.** {wording.stem.say(language)}", "", *lines])


def with_questions(source: str, items: Sequence[Item], form: str) -> str:
    """Return a page's source with the questions of a form as they should be.

    Raises:
        LookupError: the page has no place for them.
    """
    answer = rf'# %% name="{slug(FORMS[form])}-answer"'
    place = re.compile(rf'(?s)(# %% \[markdown\] lang="ko" name="questions".*?\n)# %% \[m.*?(?={re.escape(answer)})')
    if place.search(source) is None:
        raise LookupError(f'{SOURCES[form]} has no cells between "questions" and "{slug(FORMS[form])}-answer"')
    cells = [
        _cell(item, number, form, language) for number, item in enumerate(items, start=1) for language in LANGUAGES
    ]
    return place.sub(lambda found: found[1] + "\n\n".join([*cells, ""]) + "\n", source, count=1)


def _cell(item: Item, number: int, form: str, language: str) -> str:
    text = _commented(question(item, number, form, language))
    return f'# %% [markdown] lang="{language}" name="question-{number}"\n{text}'


def _commented(text: str) -> str:
    return "\n".join(f"# {line}".rstrip() for line in text.splitlines())
