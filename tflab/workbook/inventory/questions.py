"""How do the questions stand on a page?  A cell for each, in both languages, made from the items.

    **3.** Seen from A, B is at (2, 0) and turned 90° to the left. Where is A, seen from B?

    - **a** (−2, 0)  ...  - **e** I do not know

The sources of the two exercises hold them between the cells "questions" and "e0-1-answer";
`python -m tflab.workbook.course.contents` writes them there, and a test holds them in step.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...text import LANGUAGES, Text
from ..tasks.task import slug
from .items import FORMS, Item

__all__ = ["DO_NOT_KNOW", "SOURCES", "question", "with_questions"]

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
