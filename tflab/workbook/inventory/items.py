"""What is asked, and what does each wrong option show?  Fifteen items, each in two forms.

    item 3, M3    form A   B is at (2, 0), turned 90 degrees to the left ...      a M3   b M1   c M3   d right
                  form B   B is at (3, 0), turned 90 degrees to the right ...     a M3   b right   c M3   d M1

Every wrong option is what somebody really believes, a *distractor*; with each stands
what to say of it when both forms are in.  All of it is in `solutions/inventory.yaml`,
beside the solutions: a learner's copy holds the questions (see `questions.py`), and
nothing that tells their key.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from ...text import Text
from ..paths import workbook_data

__all__ = ["FORMS", "LETTERS", "RIGHT", "Item", "Option", "Wording", "inventory_file", "parsed", "read_inventory"]

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
    return tuple(_item(line) for line in yaml.safe_load(text)["items"])


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
