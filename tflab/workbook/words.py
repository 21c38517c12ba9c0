"""In which language?  What a person reads stands here twice, in English and in Korean.

    Words(en="Not answered yet.", ko="아직 답하지 않았습니다.").say("ko")

Names, code and numbers are the same in both.  Read `whole_files.py` next.
"""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["LANGUAGES", "Words"]

LANGUAGES = ("en", "ko")


class Words(NamedTuple):
    """One thing to say, each time as if written first."""

    en: str
    ko: str

    def say(self, language: str, **names: object) -> str:
        """Return the text in a language, with its {names} filled in."""
        text = self.ko if language == "ko" else self.en
        return text.format(**names) if names else text

    def plain(self) -> dict[str, str]:
        """Return both texts as JSON has them: {"en": ..., "ko": ...}."""
        return self._asdict()
