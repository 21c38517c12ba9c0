"""In which language?  What a person reads stands here twice, in English and in Korean.

    Words(en="Not answered yet.", ko="아직 답하지 않았습니다.").say("ko")
    Words(en="{part} is wrong.", ko="{part} 부분이 틀렸습니다.").filled(part="yaw")     both texts

Names, code and numbers are the same in both.
"""

from __future__ import annotations

import re
from typing import NamedTuple

__all__ = ["LANGUAGES", "Words", "begun"]

LANGUAGES = ("en", "ko")
ENGLISH_WORD = re.compile(r"[a-z]+(?=[ ,:;.'’-]|$)")
NAMES = ("map", "nanosec", "odom", "rclpy", "sec")  # written small, wherever they stand


class Words(NamedTuple):
    """One thing to say, each time as if written first."""

    en: str
    ko: str

    def say(self, language: str, **names: object) -> str:
        """Return the text in a language, with its {names} filled in."""
        text = self.ko if language == "ko" else self.en
        return text.format(**names) if names else text

    def filled(self, **names: object) -> Words:
        """Return both texts with their {names} filled in; of a name that is Words, each text takes its own."""
        texts = []
        for language in LANGUAGES:
            own = {name: one.say(language) if isinstance(one, Words) else one for name, one in names.items()}
            texts.append(self.say(language, **own))
        return Words(*texts)

    @classmethod
    def joined(cls, *parts: Words | None, between: str = " ") -> Words:
        """Return texts one after the other, at least one; what is None is left out."""
        return cls(*(between.join(row) for row in zip(*filter(None, parts), strict=True)))

    def plain(self) -> dict[str, str]:
        """Return both texts as JSON has them: {"en": ..., "ko": ...}."""
        return self._asdict()


def begun(text: str) -> str:
    """Return a text as a sentence begins: with a capital, but for a name, which another capital would make another."""
    word = ENGLISH_WORD.match(text)
    return text[:1].upper() + text[1:] if word and word[0] not in NAMES else text
