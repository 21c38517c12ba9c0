"""In whose language are the controls?  What stands beside a slider, in English and in Korean.

    slider("robot x", ...)   --"ko"-->   로봇 x [m]

Names stay as they are: of frames, of joints, of options that ROS 2 prints; roll,
pitch and yaw.
"""

from __future__ import annotations

__all__ = ["LANGUAGES", "said"]

LANGUAGES = ("en", "ko")
KOREAN = {
    "as text": "글로 보기",
    "the same in words": "같은 내용을 글로",
    "robot x": "로봇 x",
    "robot yaw": "로봇 yaw",
    "thing x": "물체 x",
    "thing y": "물체 y",
    "rests on": "놓인 곳",
    "floor": "바닥",
    "tray: it rides along": "쟁반: 로봇과 함께 움직임",
    "forward": "앞",
    "left": "왼쪽",
    "up": "위",
    "mount yaw": "장착 yaw",
    "speed": "속도",
    "yaw rate": "각속도",
    "range": "거리",
    "delay": "지연",
    "rate": "발행률",
    "query": "요청 시각",
    "Ask for the newest common time": "최신 공통 시각을 묻습니다",
    "join": "참여 시각",
    "source": "원본",
    "target": "목표",
    "arrow": "화살표",
    "shell": "터미널",
    "played": "재생 시간",
    "step": "단계",
    "a visit": "진료",
    "the arrow keys go on and back": "화살표 키로 앞뒤로 넘깁니다",
    "choose, and the others follow": "고르면 나머지가 따라 바뀝니다",
}


def said(words: str, language: str) -> str:
    """Return words of a control in a language; what has no other name stays as it is.

    Raises:
        ValueError: the language is unknown.
    """
    if language not in LANGUAGES:
        raise ValueError(f'there are no words in "{language}"; languages are {", ".join(LANGUAGES)}')
    return KOREAN.get(words, words) if language == "ko" else words
