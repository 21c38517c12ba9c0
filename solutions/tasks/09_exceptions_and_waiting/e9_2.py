"""E9.2: Classify a refusal."""

from __future__ import annotations

import numpy as np

from tflab.core import seconds
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Task, Twin, Words

from .draws import kind_of, refusal, robot_buffer, two_texts


def questions(rng: np.random.Generator) -> list[tuple]:
    """Draw one question of each kind, and three that have several faults at once."""
    t = round(float(rng.uniform(20.0, 60.0)), 1)

    def at(low: float, high: float) -> Time:
        return Time(nanoseconds=seconds(round(t + float(rng.uniform(low, high)), 3)))

    drawn = [
        ("map", "laser_frame", at(1.1, 3.9)),
        ("map", "laser_frame", at(4.05, 4.45)),
        ("map", "laser_frame", Time(nanoseconds=seconds(round(t + 4.01, 3)))),  # a hundredth too late
        ("map", "laser_frame", at(0.1, 0.9)),
        ("map", "camera_link", at(1.1, 3.9)),
        ("map", "Laser_frame", at(1.1, 3.9)),
        ("/map", "laser_frame", at(1.1, 3.9)),
        ("base_link", "tool0", at(2.2, 3.9)),
        ("map", "laser_frame", Time()),
        ("camera_link", "odom", at(20.0, 40.0)),  # no path either
        ("map", "gripper", at(20.0, 40.0)),  # an unknown name, and too late
        ("gripper", "/laser_frame", at(1.1, 3.9)),  # two names that are wrong, each in its way
    ]
    return [(robot_buffer(t), *question) for question in drawn]


def latest_only(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return kind_of(refusal(buffer, target, source, Time()))


ASKED_FOR_THE_LATEST = Twin(
    "asked for the latest",
    latest_only,
    misconception="M9",
    reply=Words(
        en="whatever stamp it is given, your function judges as if the latest had been asked for. Is `stamp` really handed on to the lookup?",
        ko="어떤 시각을 주어도 최신을 물은 것처럼 판단합니다. `stamp`를 조회에 그대로 넘기고 있습니까?",
    ),
)


def path_first(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    first = kind_of(refusal(buffer, target, source, Time()))
    return first if first in ("connectivity", "lookup") else kind_of(refusal(buffer, target, source, stamp))


PATH_BEFORE_MOMENT = Twin(
    "path before moment",
    path_first,
    misconception="M11",
    reply=Words(
        en="where a question has no path and no data either, tf2 reports what it finds first while it walks. Ask tf2 once, with the stamp, and believe it; do not check the path yourself beforehand.",
        ko="경로도 없고 데이터도 없는 질문이라면 tf2는 경로를 따라가며 먼저 찾은 것을 보고합니다. 경로를 미리 따로 확인하지 말고, 주어진 시각으로 한 번만 묻고 그 답을 믿으십시오.",
    ),
)


def base_first(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return "ok" if refusal(buffer, target, source, stamp) is None else "invalid argument"


BASE_CLASS_FIRST = Twin(
    "base class first",
    base_first,
    misconception="M11",
    reply=Words(
        en="every refusal ends in the same branch. Python takes the first `except` that fits, and the base class fits everything: let it come last.",
        ko="모든 거절이 같은 분기로 들어갑니다. 파이썬은 조건에 맞는 `except` 가운데 맨 위의 것을 택하고, 부모 클래스는 무엇에나 해당합니다. 맨 뒤로 보내십시오.",
    ),
)


def one_word(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return "ok" if refusal(buffer, target, source, stamp) is None else "lookup"


ONE_WORD_FOR_EVERY_NO = Twin(
    "one word for every no",
    one_word,
    misconception="M11",
    reply=Words(
        en="every refusal gets the same word. An `except TransformException` that stands first takes them all, and `can_transform` says only yes or no: give each class a branch of its own, and let the base class come last.",
        ko="모든 거절에 같은 단어를 돌려줍니다. 맨 앞에 둔 `except TransformException`은 모두를 가져가고, `can_transform`은 예, 아니요만 말합니다. 클래스마다 분기를 두고 부모 클래스는 맨 뒤에 두십시오.",
    ),
)


def ends_swapped(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return kind_of(refusal(buffer, source, target, stamp))


ENDS_SWAPPED = Twin(
    "ends swapped",
    ends_swapped,
    misconception="M1",
    reply=Words(
        en="where both names are wrong, tf2 complains of the target first. Your function seems to hand over source and target in the other order: wanted comes first.",
        ko="두 이름이 모두 틀리면 tf2는 목표(target_frame)부터 탓합니다. 이 함수는 원본과 목표를 거꾸로 넘기는 것 같습니다. 기준이 될 목표가 먼저입니다.",
    ),
)


def turned_round(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    kind = kind_of(refusal(buffer, target, source, stamp))
    return {"past": "future", "future": "past"}.get(kind, kind)


FUTURE_AND_PAST_SWAPPED = Twin(
    "future and past swapped",
    turned_round,
    misconception="M10",
    reply=Words(
        en="future and past have changed places. The words are about the moment asked for: newer than all the data is the future.",
        ko="미래와 과거가 뒤바뀌었습니다. 물어본 시각을 기준으로 한 말입니다. 모든 데이터보다 새로우면 미래입니다.",
    ),
)


TWO_TEXTS = Twin(
    "two texts",
    two_texts,
    misconception="M11",
    reply=Words(
        en="extrapolation has three texts, and your function knows two. What does tf2 say of an edge that has been heard exactly once?",
        ko="외삽 오류 메시지는 세 가지인데 이 함수는 두 가지만 압니다. 딱 한 번 들은 연결에 대해 tf2는 무엇이라고 합니까?",
    ),
)


TASK = Task(
    id="E9.2",
    kind="F",
    points=4,
    title=Words(en="Classify a refusal", ko="거절을 분류하기"),
    answer="classify",
    form=Choice(("ok", "invalid argument", "lookup", "connectivity", "future", "past", "one sample")),
    inputs=questions,
    variants=3,
    twins=(
        ASKED_FOR_THE_LATEST,
        PATH_BEFORE_MOMENT,
        TWO_TEXTS,
        BASE_CLASS_FIRST,
        FUTURE_AND_PAST_SWAPPED,
        ENDS_SWAPPED,
        ONE_WORD_FOR_EVERY_NO,
    ),
    hints=(
        Words(
            en="Do not examine the buffer. Ask it, and sort what it raises.",
            ko="버퍼를 들여다보지 말고 물어본 다음, 일으킨 예외를 분류하십시오.",
        ),
        Words(
            en="One `try`, four `except`. Python has one ExtrapolationException; which of the three it is stands in `str(error)`.",
            ko="`try` 하나에 `except` 넷입니다. 파이썬의 ExtrapolationException은 하나이고, 셋 중 무엇인지는 `str(error)`에 있습니다.",
        ),
        Words(
            en='Look in the text for "into the future" and "into the past"; an extrapolation that says neither is the third. InvalidArgumentException is what is left of TransformException.',
            ko='오류 메시지에서 "into the future"와 "into the past"를 찾으십시오. 둘 다 없으면 세 번째입니다. 나머지 TransformException이 InvalidArgumentException입니다.',
        ),
    ),
    cures=("M11",),
)
