"""Read the glossary, and expand its terms on a page.

    [[target frame]]            ->  <abbr title="...">target frame</abbr>
    [[target frame|the target]] ->  <abbr title="...">the target</abbr>

In Korean a bare term shows both: 목표 좌표계(target frame), tf2_echo(변환 확인 도구).
"""

from __future__ import annotations

import html
import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

from ...text import Text, load_yaml

__all__ = ["GLOSSARY", "MARKED", "Term", "UnknownTerm", "expand", "read_glossary"]

GLOSSARY = Path(__file__).with_name("glossary.yaml")
MARKED = re.compile(r"\[\[(?P<key>[^\[\]|]+)(?:\|(?P<shown>[^\[\]]*))?\]\]")
FENCED = r"(?ms:^[ ]*(?P<fence>```+|~~~+).*?^[ ]*(?P=fence)[`~]*[ ]*$)"
INLINE = r"(?s:(?P<ticks>`+)(?!`)(?:(?!\n\s*\n).)+?(?<!`)(?P=ticks)(?!`))"
CODE_OR_MARKED = re.compile(f"{FENCED}|{MARKED.pattern}|{INLINE}")  # whichever begins first


class Term(NamedTuple):
    """A word of the course.

    Attributes:
        key: how pages mark it, in lower case unless it is a name in code.
        word: the word itself in each language.
        definition: one sentence in each.
        chapter: the stem of the chapter that introduces it.
        lecture: whether it is one of the lecture's twenty.
        code: whether it is a name that is written as it is in every language.
    """

    key: str
    word: Text
    definition: Text
    chapter: str
    lecture: bool = False
    code: bool = False

    def shown(self, language: str) -> str:
        """Return the word as running text has it; in Korean with its gloss, which names in code have after them."""
        if language != "ko" or self.word.ko == self.word.en:
            return self.word.say(language)
        return f"{self.word.en}({self.word.ko})" if self.code else f"{self.word.ko}({self.word.en})"


class UnknownTerm(Exception):
    """A page marks a term that the glossary does not have."""


@cache
def read_glossary() -> dict[str, Term]:
    """Return the terms by their keys, in the file's order."""
    found = load_yaml(GLOSSARY.read_text(encoding="utf-8"))
    return {
        key: Term(
            key,
            Text(line["en"], line["ko"]),
            Text(line["definition"]["en"], line["definition"]["ko"]),
            line["chapter"],
            line.get("lecture", False),
            line.get("code", False),
        )
        for key, line in found.items()
    }


def expand(text: str, language: str) -> str:
    """Return markdown with its marked terms as tooltips; code in it stays as it is.

    Raises:
        UnknownTerm: a term is not in the glossary.
    """

    def tooltip(found: re.Match) -> str:
        if found["key"] is None:
            return found[0]  # code
        term = _term(found["key"].strip())
        shown = found["shown"] or term.shown(language)
        return f'<abbr title="{html.escape(term.definition.say(language).replace("`", ""))}">{shown}</abbr>'

    return CODE_OR_MARKED.sub(tooltip, text)


def _term(key: str) -> Term:
    glossary = read_glossary()
    if key not in glossary:
        from difflib import get_close_matches

        close = get_close_matches(key, glossary, n=1)
        hint = f'did you mean "{close[0]}"?' if close else "add it to tflab/workbook/course/glossary.yaml"
        raise UnknownTerm(f'the glossary has no "{key}"; {hint}')
    return glossary[key]
