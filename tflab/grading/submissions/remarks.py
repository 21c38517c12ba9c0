"""Describe what there is to say about a submission: a kind of remark, its task and its names, in both languages.

    Remark("twice", "E3.2", cell="e3-2-answer").say("en")
    -> 'E3.2: two different cells are called "e3-2-answer", so neither counts. ...'

A remark never repeats what a learner's code printed or raised: that could carry hidden inputs
out. Why a file cannot be read is a remark inside a remark. What an operating system or Python
says of a fault is in English everywhere. The texts are in `remarks.yaml`; what is wrong with an
answer is said as `failure.py` of the workbook has it.
"""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from tflab.text import Text, Texts
from tflab.workbook.diagnosis.failure import WITHOUT_THE_ANSWER

__all__ = ["KINDS", "Remark", "printable"]

# By kind: the texts of the YAML file, and what may be said of a wrong answer.
KINDS: Mapping[str, Text] = ChainMap(WITHOUT_THE_ANSWER, Texts(__file__))


@dataclass(frozen=True)
class Remark:
    """One thing to say; `words` fill the gaps of its text, and may be remarks themselves."""

    kind: str
    task: str = ""
    words: dict[str, str | Remark] = field(default_factory=dict)

    def __init__(self, kind: str, task: str = "", **words: Any) -> None:
        object.__setattr__(self, "kind", kind)
        object.__setattr__(self, "task", task)
        said = {name: one if isinstance(one, Remark) else printable(str(one)) for name, one in words.items()}
        object.__setattr__(self, "words", said)

    def say(self, language: str, *, with_task: bool = True) -> str:
        """Return the remark as one line."""
        words = {name: one.say(language) if isinstance(one, Remark) else one for name, one in self.words.items()}
        text = KINDS[self.kind].say(language).format(**words)
        return f"{self.task}: {text}" if self.task and with_task else text

    def plain(self) -> dict[str, Any]:
        """Return the remark as JSON has it."""
        words = {name: one.plain() if isinstance(one, Remark) else one for name, one in self.words.items()}
        return {"kind": self.kind, "task": self.task, "words": words}

    @classmethod
    def from_plain(cls, plain: dict[str, Any]) -> Remark:
        """Return the remark that `plain` wrote."""
        words = {name: cls.from_plain(one) if isinstance(one, dict) else one for name, one in plain["words"].items()}
        return cls(plain["kind"], plain["task"], **words)


def printable(text: str) -> str:
    """Return a text for one line: no line ends, no terminal's commands, no letters that cannot be written."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)
