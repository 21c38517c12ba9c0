"""What is told in the learner's language, and what stays as it was printed?

    $ ros2 topic delay /scan        as it is typed, and what it prints as it is printed
    look at RViz again              nobody types that:   RViz를 다시 봅니다
    Scan on the map: up to 0.47 m beside the walls       what the ward measured, and no tool

A patient is kept in English, whoever reads it; its words are turned when they are
told.
"""

from __future__ import annotations

import re

from .trolley import TrolleyCheck

__all__ = ["done", "told"]

_DONE = {
    "rviz": "RViz를 다시 보기",
    "tape measure": "레이저의 장착 위치를 줄자로 재기",
    "other cable": "다른 케이블 꽂기",
}
_TOLD = (
    (r"RViz: all Ok", "RViz: 모두 Ok"),
    (r"Scan on the map: up to (\S+) m beside the walls", r"지도 위의 스캔: 벽에서 최대 \1 m 벗어남"),
    (r"Scan on the map: nothing can be placed", "지도 위의 스캔: 놓을 수 있는 점이 없음"),
    (
        r"(\S+) m ahead, (\S+) m to the side, (\S+) m up: where the drawing has it",
        r"앞 \1 m, 옆 \2 m, 위 \3 m: 도면에 있는 그 자리",
    ),
    (r"360 points ten times a second, as with the cable before", "점 360개가 1초에 열 번, 케이블을 바꾸기 전과 같음"),
)


def done(check: TrolleyCheck, language: str = "en") -> str:
    """Return what is typed, or done."""
    return _DONE.get(check.key, check.command) if language == "ko" else check.command


def told(text: str, language: str = "en") -> str:
    """Return what the ward wrote, with its own words in a language; what a tool printed stays as it is."""
    return text if language == "en" else "\n".join(map(_korean, text.split("\n")))


def _korean(line: str) -> str:
    bare = line.lstrip(" ")
    for pattern, korean in _TOLD:
        if match := re.fullmatch(pattern, bare):
            return line[: len(line) - len(bare)] + match.expand(korean)
    return line
