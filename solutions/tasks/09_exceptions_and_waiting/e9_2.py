"""E9.2: Classify a refusal."""

from __future__ import annotations

from functools import partial

from tflab.core import seconds
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Draws, Task, Text, WrongAnswer, WrongStep

from .draws import kind_of, refusal, robot_buffer


def questions(rng: Draws) -> list[tuple]:
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
        ("map", "", at(1.1, 3.9)),
    ]
    return [(robot_buffer(t), *question) for question in drawn]


def classified(
    buffer, target, source, stamp, *, ends="as given", moment="stamp", texts="three", classes="each its own",
    let_through="none",
):  # fmt: skip
    """Return the kind of a refusal, step by step; other steps are the slips."""
    target, source = (source, target) if ends == "swapped" else (target, source)
    written = {"without slashes": lambda name: name.lstrip("/"), "in small letters": str.lower}.get(ends, str)
    target, source = written(target), written(source)
    moments = {"latest": Time(), "whole seconds": Time(nanoseconds=stamp.nanoseconds // 10**9 * 10**9)}
    refused = refusal(buffer, target, source, moments.get(moment, stamp))
    kind = kind_of(refused)
    extrapolations = ("future", "past", "one sample")
    if refused is not None and let_through in (kind, "extrapolation" if kind in extrapolations else kind, "any"):
        raise refused
    if moment == "no path at the latest" and refusal(buffer, target, source, Time()) is not None:
        return "connectivity"
    if moment == "path first":
        first = kind_of(refusal(buffer, target, source, Time()))
        kind = first if first in ("connectivity", "lookup") else kind
    if texts == "by the newest" and kind in extrapolations:
        newest = buffer.get_latest_common_time(target, source).nanoseconds
        kind = "future" if stamp.nanoseconds > newest else "past"
    said = {
        "turned round": {"past": "future", "future": "past"},
        "two": {"one sample": "past"},
        "two, and an answer": {"one sample": "ok"},
        "two, and future": {"one sample": "future"},
        "all future": {"past": "future", "one sample": "future"},
        "all past": {"future": "past", "one sample": "past"},
        "none read": dict.fromkeys(extrapolations, "one sample"),
    }.get(texts, {})
    kind = said.get(kind, kind)
    odd = {"a slash is a name": lambda name: name.startswith("/"), "nothing is a name": lambda name: not name}
    if kind == "ok" or classes == "each its own" or not any(map(odd.get(classes, bool), (target, source))):
        return kind
    return {
        "base first": "invalid argument",
        "by the text": kind if kind in extrapolations else "one sample",
        "one word": "lookup",
        "one word: future": "future",
        "one word: past": "past",
        "one word: connectivity": "connectivity",
        "exchanged": {"lookup": "connectivity", "connectivity": "lookup"}.get(kind, kind),
        "names alone": {"connectivity": "lookup"}.get(kind, kind),
        "no question is a name": {"invalid argument": "lookup"}.get(kind, kind),
        "a slash is a name": {"invalid argument": "lookup"}.get(kind, kind),
        "nothing is a name": {"invalid argument": "lookup"}.get(kind, kind),
    }[classes]


ASKED_FOR_THE_LATEST = WrongStep(
    "asked for the latest",
    {"moment": "latest"},
    Text(
        en="whatever stamp it is given, your function judges as if the latest had been asked for. Is `stamp` really handed on to the lookup?",
        ko="어떤 시각을 주어도 최신을 조회한 것처럼 판단합니다. `stamp`를 조회에 그대로 넘기고 있습니까?",
    ),
    "M9",
)

NO_ANSWER_AT_THE_LATEST_IS_NO_PATH = WrongAnswer(
    "no answer at the latest is no path",
    partial(classified, moment="no path at the latest"),
    Text(
        en='whatever tf2 refuses at the latest, too, is "connectivity" for you: a name that is unknown, and one that is none, as well. That `can_transform` is false, or that a lookup at `Time()` fails, says no more than no. Which no it is stands in the class of the exception.',
        ko='최신으로 물어도 거절되면 모두 "connectivity"라고 합니다. 모르는 이름도, 이름이 될 수 없는 것도 그렇습니다. `can_transform`이 False이거나 `Time()` 조회가 실패해도 안 된다는 것만 알 수 있습니다. 왜 안 되는지는 예외의 클래스에 있습니다.',
    ),
    "M11",
)

PATH_BEFORE_MOMENT = WrongStep(
    "path before moment",
    {"moment": "path first"},
    Text(
        en="where a question has no path and no data either, tf2 reports what it finds first while it walks. Ask tf2 once, with the stamp, and believe it; do not check the path yourself beforehand.",
        ko="경로도 없고 데이터도 없는 질문이라면 tf2는 경로를 따라가며 먼저 찾은 것을 보고합니다. 경로를 미리 따로 확인하지 말고, 주어진 시각으로 한 번만 묻고 그 답을 믿으십시오.",
    ),
    "M11",
)

BASE_CLASS_FIRST = WrongStep(
    "base class first",
    {"classes": "base first"},
    Text(
        en='every refusal is "invalid argument" for you. Is there one `except` for all? Python takes the first that fits, and the base class fits everything: give each class its own, and let the base class come last.',
        ko='모든 거절이 "invalid argument"입니다. `except` 하나로 모두 잡습니까? 파이썬은 조건에 맞는 맨 위의 것을 택하고, 부모 클래스는 무엇에나 해당합니다. 클래스마다 하나씩 두고 부모 클래스는 맨 뒤로 보내십시오.',
    ),
    "M11",
)

ONE_WORD_FOR_EVERY_NO = WrongStep(
    "one word for every no",
    {"classes": "one word"},
    Text(
        en="every refusal gets the same word. An `except TransformException` that stands first takes them all, and `can_transform` says only yes or no: give each class a branch of its own, and let the base class come last.",
        ko="모든 거절에 같은 단어를 돌려줍니다. 맨 앞에 둔 `except TransformException`이 모두 잡거나, `can_transform`으로 되는지 안 되는지만 보면 그렇게 됩니다. 클래스마다 분기를 두고 부모 클래스는 맨 뒤에 두십시오.",
    ),
    "M11",
)

ENDS_SWAPPED = WrongStep(
    "ends swapped",
    {"ends": "swapped"},
    Text(
        en="where both names are wrong, tf2 complains of the target first, and your function of the source. Does it hand over the two in the other order (wanted comes first), or look at the names before tf2 does?",
        ko="두 이름이 모두 틀리면 tf2는 목표(target_frame)부터 탓하는데, 이 함수는 원본을 탓합니다. 둘을 거꾸로 넘기고 있습니까(목표가 먼저입니다), 아니면 tf2보다 먼저 이름을 따지고 있습니까?",
    ),
    "M1",
)

EVERY_NO_IS_THE_FUTURE = WrongStep(
    "every no is the future",
    {"classes": "one word: future"},
    Text(
        en='every refusal is "future" for you, whatever the reason. `can_transform` says only yes or no, and so does a single `except`; why tf2 refuses stands in the class of its exception, and of an extrapolation in its text.',
        ko='이유가 무엇이든 모든 거절이 "future"입니다. `can_transform`으로는 되는지 안 되는지만 알 수 있고 `except` 하나로도 마찬가지입니다. 거절하는 이유는 예외의 클래스에 있고, 외삽이라면 메시지에 있습니다.',
    ),
    "M11",
)

EVERY_NO_IS_THE_PAST = WrongStep(
    "every no is the past",
    {"classes": "one word: past"},
    Text(
        en='every refusal is "past" for you, whatever the reason. `can_transform` says only yes or no, and so does a single `except`; why tf2 refuses stands in the class of its exception, and of an extrapolation in its text.',
        ko='이유가 무엇이든 모든 거절이 "past"입니다. `can_transform`으로는 되는지 안 되는지만 알 수 있고 `except` 하나로도 마찬가지입니다. 거절하는 이유는 예외의 클래스에 있고, 외삽이라면 메시지에 있습니다.',
    ),
    "M11",
)

EVERY_NO_IS_NO_PATH = WrongStep(
    "every no is no path",
    {"classes": "one word: connectivity"},
    Text(
        en='every refusal is "connectivity" for you, whatever the reason. `can_transform` says only yes or no, and so does a single `except`; why tf2 refuses stands in the class of its exception, and of an extrapolation in its text.',
        ko='이유가 무엇이든 모든 거절이 "connectivity"입니다. `can_transform`으로는 되는지 안 되는지만 알 수 있고 `except` 하나로도 마찬가지입니다. 거절하는 이유는 예외의 클래스에 있고, 외삽이라면 메시지에 있습니다.',
    ),
    "M11",
)

FUTURE_AND_PAST_SWAPPED = WrongStep(
    "future and past swapped",
    {"texts": "turned round"},
    Text(
        en="future and past have changed places. The words are about the moment asked for: newer than all the data is the future.",
        ko="미래와 과거가 뒤바뀌었습니다. 요청 시각을 기준으로 한 말입니다. 요청 시각이 모든 데이터보다 늦으면 미래입니다.",
    ),
    "M10",
)

TWO_TEXTS = WrongStep(
    "two texts",
    {"texts": "two"},
    Text(
        en="extrapolation has three texts, and your function knows two. What does tf2 say of an edge that has been heard exactly once?",
        ko="외삽 오류 메시지는 세 가지인데 이 함수는 두 가지만 압니다. 딱 한 번 들은 연결에 대해 tf2는 무엇이라고 합니까?",
    ),
    "M11",
)


WHOLE_SECONDS = WrongStep(
    "whole seconds",
    {"moment": "whole seconds"},
    Text(
        en="You asked for the whole second alone: the nanoseconds of `stamp` are lost on the way.",
        ko="초만으로 물었습니다. `stamp`의 나노초가 중간에 사라졌습니다.",
    ),
)


THIRD_TEXT_IS_THE_FUTURE = WrongStep(
    "third text is the future",
    {"texts": "two, and future"},
    Text(
        en="extrapolation has three texts: an edge that was heard just once is neither future nor past, and tf2 says so.",
        ko="외삽의 오류 메시지는 세 가지입니다. 한 번만 들은 연결은 미래도 과거도 아니고, 오류 메시지에도 그렇게 나옵니다.",
    ),
    "M11",
)


THIRD_TEXT_IS_AN_ANSWER = WrongStep(
    "third text is an answer",
    {"texts": "two, and an answer"},
    Text(
        en='where an edge was heard just once, you say "ok". tf2 has no answer there: one sample is good for its own moment alone, and another one was asked for. That is "one sample".',
        ko='한 번만 들은 연결을 "ok"라고 합니다. 거기서 tf2는 답하지 못합니다. 표본 하나는 그 시각에만 쓸 수 있는데 다른 시각을 물었습니다. "one sample"입니다.',
    ),
    "M11",
)


TEXTS_ALONE = WrongStep(
    "texts alone",
    {"classes": "by the text"},
    Text(
        en='a wrong name, no path and what is no question are "one sample" for you, too: you look at the text and not at the class. "one sample" is what is left of an ExtrapolationException, not of every exception.',
        ko='틀린 이름도, 없는 경로도, 질문이 되지 않는 것도 "one sample"이라고 합니다. 클래스는 보지 않고 오류 메시지만 봅니다. "one sample"은 모든 예외가 아니라 ExtrapolationException에서 남는 것입니다.',
    ),
    "M11",
)


EVERY_EXTRAPOLATION_IS_THE_FUTURE = WrongStep(
    "every extrapolation is the future",
    {"texts": "all future"},
    Text(
        en="every extrapolation is the future for you. Its text says which way it goes, and an edge heard just once has a text of its own.",
        ko="모든 외삽을 미래로 봅니다. 어느 쪽인지는 오류 메시지에 나오고, 한 번만 들은 연결에는 오류 메시지가 따로 있습니다.",
    ),
    "M11",
)


EVERY_EXTRAPOLATION_IS_THE_PAST = WrongStep(
    "every extrapolation is the past",
    {"texts": "all past"},
    Text(
        en="every extrapolation is the past for you. Its text says which way it goes, and an edge heard just once has a text of its own.",
        ko="모든 외삽을 과거로 봅니다. 어느 쪽인지는 오류 메시지에 나오고, 한 번만 들은 연결에는 오류 메시지가 따로 있습니다.",
    ),
    "M11",
)


NO_TEXT_IS_READ = WrongStep(
    "no text is read",
    {"texts": "none read"},
    Text(
        en='every extrapolation is "one sample" for you. Its text may say "into the future" or "into the past"; what is left says neither. Do you look for just these words, in `str(error)` as a whole and in small letters? Of its single words one is "future.", with the full stop.',
        ko='외삽이면 무조건 "one sample"입니다. 오류 메시지에 "into the future"나 "into the past"가 있을 수 있고, 둘 다 없는 것만 남습니다. `str(error)` 전체에서 바로 그 말을, 소문자로 찾고 있습니까? 낱말로 나누면 마침표가 붙은 "future."가 됩니다.',
    ),
    "M11",
)


LOOKUP_AND_CONNECTIVITY_EXCHANGED = WrongStep(
    "lookup and connectivity exchanged",
    {"classes": "exchanged"},
    Text(
        en="lookup and connectivity have changed places: a name that nobody knows is lookup, two known ones without a path is connectivity.",
        ko="lookup과 connectivity가 바뀌었습니다. 아무도 모르는 이름이 lookup, 아는 두 이름 사이에 길이 없는 것이 connectivity입니다.",
    ),
    "M11",
)


SLASHES_TAKEN_OFF = WrongStep(
    "slashes taken off",
    {"ends": "without slashes"},
    Text(
        en="You take the slash in front off before you ask. Then tf2 answers a question that nobody asked: hand over the names as they came, and let it refuse them.",
        ko="묻기 전에 이름 앞의 슬래시를 뗍니다. 그러면 tf2는 아무도 묻지 않은 질문에 답합니다. 받은 이름을 그대로 넘기고, 거절은 tf2에 맡기십시오.",
    ),
    "M14",
)


IN_SMALL_LETTERS = WrongStep(
    "names in small letters",
    {"ends": "in small letters"},
    Text(
        en="You write the names in small letters before you ask. `Laser_frame` is another name than `laser_frame`, and tf2 does not know it: hand over the names as they came.",
        ko="묻기 전에 이름을 소문자로 바꿉니다. `Laser_frame`은 `laser_frame`과 다른 이름이고 tf2는 그것을 모릅니다. 받은 이름을 그대로 넘기십시오.",
    ),
    "M14",
)


NO_PATH_IS_A_WRONG_NAME = WrongStep(
    "no path is a wrong name",
    {"classes": "names alone"},
    Text(
        en="where both names are known and no path leads across, you say lookup. That is connectivity, another class.",
        ko="두 이름을 다 알지만 길이 없는 곳에서 lookup이라고 합니다. 그것은 다른 클래스인 connectivity입니다.",
    ),
    "M11",
)


NO_QUESTION_IS_A_WRONG_NAME = WrongStep(
    "no question is a wrong name",
    {"classes": "no question is a name"},
    Text(
        en="a question that is none (a slash in front, an empty name) is a lookup for you. It has a class of its own: InvalidArgumentException.",
        ko="질문이 되지 않는 것(앞의 슬래시, 빈 이름)을 lookup이라고 합니다. InvalidArgumentException이라는 클래스가 따로 있습니다.",
    ),
    "M11",
)


SLASH_IS_A_WRONG_NAME = WrongStep(
    "a slash is a wrong name",
    {"classes": "a slash is a name"},
    Text(
        en="a name with a slash in front is a lookup for you. tf2 looks no such name up: it raises an InvalidArgumentException, a class of its own. Do you look at the names yourself, before you ask?",
        ko="앞에 슬래시가 붙은 이름을 lookup이라고 합니다. tf2는 그런 이름을 찾아보지도 않고 InvalidArgumentException이라는 다른 클래스를 일으킵니다. 묻기 전에 이름을 직접 따지고 있습니까?",
    ),
    "M11",
)


NO_BRANCH_FOR_NO_QUESTION = WrongStep(
    "no branch for no question",
    {"let_through": "invalid argument"},
    Text(
        en="you catch three of the four classes. A question that is none (a slash in front, an empty name) goes through your function as an InvalidArgumentException.",
        ko="네 클래스 가운데 셋만 잡습니다. 질문이 되지 않는 것(앞의 슬래시, 빈 이름)은 InvalidArgumentException이 되어 함수를 그대로 지나갑니다.",
    ),
    "M11",
)


NO_BRANCH_FOR_NO_PATH = WrongStep(
    "no branch for no path",
    {"let_through": "connectivity"},
    Text(
        en="you catch three of the four classes. Where no path leads across, a ConnectivityException goes through your function.",
        ko="네 클래스 가운데 셋만 잡습니다. 이어진 길이 없으면 ConnectivityException이 함수를 그대로 지나갑니다.",
    ),
    "M11",
)


NO_BRANCH_FOR_NO_NAME = WrongStep(
    "no branch for no name",
    {"let_through": "lookup"},
    Text(
        en="you catch three of the four classes. Where a name is unknown, a LookupException goes through your function.",
        ko="네 클래스 가운데 셋만 잡습니다. 모르는 이름이 있으면 LookupException이 함수를 그대로 지나갑니다.",
    ),
    "M11",
)


NO_BRANCH_FOR_EXTRAPOLATION = WrongStep(
    "no branch for extrapolation",
    {"let_through": "extrapolation"},
    Text(
        en="you catch three of the four classes. Where there is no data for the moment, an ExtrapolationException goes through your function.",
        ko="네 클래스 가운데 셋만 잡습니다. 그 시각의 데이터가 없으면 ExtrapolationException이 함수를 그대로 지나갑니다.",
    ),
    "M11",
)


NOTHING_IS_CAUGHT = WrongStep(
    "nothing is caught",
    {"let_through": "any"},
    Text(
        en="every refusal goes through your function as the exception that it is. Ask inside of a `try`, and turn each class into its word in an `except`.",
        ko="거절이 모두 예외 그대로 함수를 지나갑니다. `try` 안에서 묻고, `except`에서 클래스마다 단어로 바꾸십시오.",
    ),
    "M11",
)


NOTHING_IS_A_WRONG_NAME = WrongAnswer(
    "an empty name is a wrong name",
    partial(classified, classes="nothing is a name"),
    Text(
        en="an empty name is a lookup for you. tf2 looks no such name up: it raises an InvalidArgumentException, a class of its own. Do you look at the names yourself, before you ask?",
        ko="빈 이름을 lookup이라고 합니다. tf2는 빈 이름을 찾아보지도 않고 InvalidArgumentException을 일으키며, 이것은 따로 있는 클래스입니다. 묻기 전에 이름을 직접 따지고 있습니까?",
    ),
    "M11",
)


BY_THE_NEWEST = WrongStep(
    "by the newest",
    {"texts": "by the newest"},
    Text(
        en="you judge an extrapolation by comparing `stamp` with the latest common time. tf2 has told you why already, in the text of its exception: an edge that was heard just once is neither future nor past there, and the latest common time does not show it.",
        ko="`stamp`와 최신 공통 시각을 비교해 외삽의 종류를 정했습니다. 까닭은 tf2의 오류 메시지에 이미 있습니다. 한 번만 들은 연결은 미래도 과거도 아닌데, 최신 공통 시각으로는 드러나지 않습니다.",
    ),
    "M11",
)


TASK = Task(
    id="E9.2",
    kind="F",
    points=4,
    title=Text(en="Classify a refusal", ko="거절을 분류하기"),
    answer="classify",
    form=Choice(("ok", "invalid argument", "lookup", "connectivity", "future", "past", "one sample")),
    inputs=questions,
    variants=3,
    model=classified,
    mistakes=(
        ASKED_FOR_THE_LATEST,
        PATH_BEFORE_MOMENT,
        NO_ANSWER_AT_THE_LATEST_IS_NO_PATH,
        TWO_TEXTS,
        BASE_CLASS_FIRST,
        FUTURE_AND_PAST_SWAPPED,
        ENDS_SWAPPED,
        ONE_WORD_FOR_EVERY_NO,
        EVERY_NO_IS_THE_FUTURE,
        EVERY_NO_IS_THE_PAST,
        EVERY_NO_IS_NO_PATH,
        WHOLE_SECONDS,
        THIRD_TEXT_IS_THE_FUTURE,
        THIRD_TEXT_IS_AN_ANSWER,
        TEXTS_ALONE,
        EVERY_EXTRAPOLATION_IS_THE_FUTURE,
        EVERY_EXTRAPOLATION_IS_THE_PAST,
        NO_TEXT_IS_READ,
        LOOKUP_AND_CONNECTIVITY_EXCHANGED,
        SLASHES_TAKEN_OFF,
        IN_SMALL_LETTERS,
        NO_PATH_IS_A_WRONG_NAME,
        NO_QUESTION_IS_A_WRONG_NAME,
        SLASH_IS_A_WRONG_NAME,
        NOTHING_IS_A_WRONG_NAME,
        NO_BRANCH_FOR_NO_QUESTION,
        NO_BRANCH_FOR_NO_PATH,
        NO_BRANCH_FOR_NO_NAME,
        NO_BRANCH_FOR_EXTRAPOLATION,
        NOTHING_IS_CAUGHT,
        BY_THE_NEWEST,
    ),
    hints=(
        Text(
            en="Do not examine the buffer. Ask it, and sort what it raises.",
            ko="버퍼를 들여다보지 말고 물어본 다음, 일으킨 예외를 분류하십시오.",
        ),
        Text(
            en="One `try`, four `except`. Python has one ExtrapolationException; which of the three it is stands in `str(error)`.",
            ko="`try` 하나에 `except` 넷입니다. 파이썬의 ExtrapolationException은 하나이고, 셋 중 무엇인지는 `str(error)`에 있습니다.",
        ),
        Text(
            en='Look in the text for "into the future" and "into the past"; an extrapolation that says neither is the third. InvalidArgumentException is what is left of TransformException.',
            ko='오류 메시지에서 "into the future"와 "into the past"를 찾으십시오. 둘 다 없으면 세 번째입니다. 나머지 TransformException이 InvalidArgumentException입니다.',
        ),
    ),
    seen={
        "ok": Text(
            en="There tf2 answers, and nothing is to be classified: ask it first, whatever you know of the names, and sort only what it raises. A root such as map has no entry of its own in a list of frames.",
            ko="여기서는 tf2가 답하므로 분류할 것이 없습니다. 이름을 따지기 전에 먼저 묻고, 일으킨 예외만 분류하십시오. map 같은 루트는 좌표계 목록에 자기 항목이 없습니다.",
        ),
        "invalid argument": Text(
            en="There the question is none, by its slash or its empty name, before any name is looked up.",
            ko="여기서는 앞의 슬래시나 빈 이름 때문에 질문이 되지 않습니다. 이름을 찾아보기도 전입니다.",
        ),
        "lookup": Text(
            en="There tf2 raises a LookupException: a name is unknown to it, and it asks neither for a path nor for a moment then.",
            ko="여기서는 tf2가 LookupException을 일으킵니다. 모르는 이름이 있으면 길도 시각도 묻지 않습니다.",
        ),
        "connectivity": Text(
            en="There tf2 knows both names and raises a ConnectivityException, whatever the moment.",
            ko="여기서는 tf2가 두 이름을 다 알고, 시각이 언제든 ConnectivityException을 일으킵니다.",
        ),
        "future": Text(
            en='There tf2 raises an ExtrapolationException whose text says "into the future".',
            ko='여기서는 tf2가 "into the future"라고 적힌 ExtrapolationException을 일으킵니다.',
        ),
        "past": Text(
            en='There tf2 raises an ExtrapolationException whose text says "into the past".',
            ko='여기서는 tf2가 "into the past"라고 적힌 ExtrapolationException을 일으킵니다.',
        ),
        "one sample": Text(
            en="There tf2 raises an ExtrapolationException whose text names a single time and no direction.",
            ko="여기서는 tf2가 시각 하나만 나오고 방향은 나오지 않는 ExtrapolationException을 일으킵니다.",
        ),
    },
    misconceptions=("M11",),
)
