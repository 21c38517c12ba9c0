"""Is an answer of the wrong kind in a way that is plain to see?  Nothing for a word, a class for its name.

    asked for   "none"                 "LookupException"
    given       None                   LookupException, the class itself
                the word needs quotes  `type(error).__name__` is its name

    asked for   a quaternion           a PointStamped            a list of names
    given       a Transform            a Point                   a set
                its `.rotation`        it is only a part         it has no order

A Duration or a Time where seconds are asked for has a number in it: what is wrong with that is said, too.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...text import Text
from ..answers.form import Form, inside, is_number, member
from ..answers.forms import Angle, Choice, Message, Name, Number, Quaternion, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.members import members_of
from ..answers.values import Plain
from ..mistakes.fitting import all_alike
from ..tasks.case_types import Case, TaskCases
from .explanation import Explains, Explanation, and_then

__all__ = ["kind_said", "kinds_said", "of_times"]

NO_NAME = Text(
    en='Python\'s None is nothing; if you mean the word, write it in quotes: "none"',
    ko='파이썬의 None은 아무것도 없다는 뜻입니다. 그 낱말을 쓰려면 따옴표로 묶으십시오: "none"',
)
A_CLASS = Text(
    en="That is a class itself, and a word is asked for: `type(error).__name__` is the name of an error's class",
    ko="클래스 자체를 넘겼습니다. 여기서 필요한 것은 낱말입니다. 예외 클래스의 이름은 `type(error).__name__`입니다",
)
AN_ERROR = Text(
    en="That is an exception itself, and a word is asked for: `type(error).__name__` is the name of its class",
    ko="예외 자체를 넘겼습니다. 여기서 필요한 것은 낱말입니다. 그 클래스의 이름은 `type(error).__name__`입니다",
)

ANGLES = Text(
    en="Three numbers are angles, as `.rpy()` gives them, an axis or a place; the four of a Transform's rotation are "
    "in `.rotation`",
    ko="숫자 세 개는 `.rpy()`가 주는 각도이거나 축, 또는 위치입니다. 변환의 회전을 나타내는 숫자 네 개는 `.rotation`에 "
    "있습니다",
)
WITHOUT_ZEROS = Text(
    en="Two numbers say too little: a number that is 0 stands there, too",
    ko="숫자 두 개로는 모자랍니다. 0인 숫자도 자리에 써야 합니다",
)
ROWS = Text(
    en="Several rows of numbers stand there, and one quaternion is asked for: of two turns it is their product",
    ko="숫자 묶음이 여럿 있습니다. 필요한 것은 쿼터니언 하나이고, 두 회전이라면 그 곱입니다",
)
JOINED = Text(
    en="`+` between two lists or tuples joins them; it does not add their numbers",
    ko="리스트나 튜플끼리 `+`를 쓰면 이어 붙을 뿐, 숫자가 더해지지 않습니다",
)
ONE_INSIDE = Text(
    en="There is a pair of brackets too many: the numbers stand in a list inside another",
    ko="괄호가 한 겹 더 있습니다. 숫자가 든 리스트가 다른 리스트 안에 있습니다",
)
A_MATRIX = Text(
    en="That is a matrix; the four numbers of a Transform's rotation are in `.rotation`",
    ko="행렬을 넘겼습니다. 변환의 회전을 나타내는 숫자 네 개는 `.rotation`에 있습니다",
)
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
OF_A_TRANSFORM = {
    Quaternion: Text(
        en="That is a whole transform; its quaternion is `.rotation`",
        ko="변환 전체를 넘겼습니다. 쿼터니언은 `.rotation`입니다",
    ),
    Vector: Text(
        en="That is a whole transform: its own place is `.translation`, and a point is moved by `.apply(point)`",
        ko="변환 전체를 넘겼습니다. 변환 자체의 위치는 `.translation`이고, 점은 `.apply(점)`으로 옮깁니다",
    ),
    Angle: Text(
        en="That is a whole transform; its yaw is `.rpy()[2]`",
        ko="변환 전체를 넘겼습니다. yaw는 `.rpy()[2]`입니다",
    ),
}
NO_MESSAGE = Text(
    en="A message is made by its class, and then its fields are filled in: `message = {name}()`",
    ko="메시지는 그 클래스로 만들고 항목을 채웁니다: `message = {name}()`",
)
A_FIELD = Text(
    en="That is its `.{field}` alone: hand over the whole message",
    ko="메시지의 `.{field}`만 넘겼습니다. 메시지 전체를 넘기십시오",
)
SEVERAL = Text(
    en="Exactly one of them is asked for",
    ko="그 가운데 정확히 하나만 써야 합니다",
)
A_TEXT = Text(
    en="That is a text in which numbers stand: `.split(', ')` parts a line, and `float(…)` makes a number of each part",
    ko="숫자가 적힌 문자열입니다. `.split(', ')`로 나누고 조각마다 `float(…)`로 수를 만드십시오",
)
ONE_TEXT = Text(
    en="That is a text, as one prints it: hand over the number itself; of a text that was read, `float(…)` makes one",
    ko="출력용 문자열입니다. 수를 그대로 넘기십시오. 읽어 온 문자열이라면 `float(…)`가 수로 만듭니다",
)
THREE_ANGLES = Text(
    en="If these are roll, pitch, yaw, as `.rpy()` gives them, the yaw is the last, `[2]`",
    ko="`.rpy()`가 주는 roll, pitch, yaw라면 yaw는 마지막, 곧 `[2]`입니다",
)
A_TIME = Text(
    en="A {kind} is no number: its seconds are `.nanoseconds / 1e9`",
    ko="{kind}은(는) 수가 아닙니다. 초는 `.nanoseconds / 1e9`입니다",
)
A_STAMP = Text(
    en="A stamp is no number: its seconds are `.sec + .nanosec / 1e9`",
    ko="시각 메시지는 수가 아닙니다. 초는 `.sec + .nanosec / 1e9`입니다",
)
A_SET = Text(
    en="A set has no order, a list has one: `[…]`",
    ko="집합에는 순서가 없습니다. 순서가 있는 리스트 `[…]`로 쓰십시오",
)
ONE_ALONE = Text(
    en="One alone is given, and a list is asked for, even if it holds only that one: `[…]`",
    ko="여럿을 담을 리스트가 필요한 곳에 하나만 있습니다. 하나뿐이어도 `[…]`에 넣으십시오",
)


def kind_said(form: Form, outcome: Plain) -> Text | None:
    """Return what to say of an answer of another kind than the one asked for; None if nothing is plain."""
    if outcome is None and (isinstance(form, Name) or (isinstance(form, Choice) and "none" in form.options)):
        return NO_NAME
    if isinstance(form, ListForm):
        return _said_of_a_list(form, outcome)
    if seconds_of(form, outcome) is not None:
        kind = next(iter(outcome))
        return A_STAMP if kind == "message" else A_TIME.filled(kind=kind)
    if isinstance(form, Message) and form.read(outcome) is None and outcome is not None:
        return _said_of_no_such_message(form, outcome)
    return _said_of_what_it_holds(form, outcome) or (
        _said_of_an_object(form, outcome) if isinstance(outcome, dict) else None
    )


def _said_of_what_it_holds(form: Form, outcome: Plain) -> Text | None:
    """Return what to say of a list or a text by what stands in it."""
    if _is_joined(form, outcome):
        return JOINED
    if isinstance(form, Choice) and (held := members_of(outcome)) and len(held) > 1:
        return SEVERAL if all(form.option(one) in form.options for one in held) else None
    if isinstance(form, Quaternion) and isinstance(numbers := inside(outcome), list):
        return _said_of_no_quaternion(numbers)
    if isinstance(form, Angle) and isinstance(held := inside(outcome), list) and len(held) == len("rpy"):
        return THREE_ANGLES if all(map(is_number, held)) else None
    return _said_of_a_text(form, outcome) if isinstance(outcome, str) else None


def _said_of_a_text(form: Form, outcome: str) -> Text | None:
    """Return that numbers stand in a text where they are asked for."""
    count = len(NUMBER.findall(outcome))
    if isinstance(form, Number | Angle):
        return ONE_TEXT if count == 1 else None
    return A_TEXT if isinstance(form, Vector) and count >= form.size else None


def _is_joined(form: Form, outcome: Plain) -> bool:
    """Return whether a list or tuple holds as many numbers as several points, or quaternions, have."""
    size = form.size if isinstance(form, Vector) else 4 if isinstance(form, Quaternion) else 0
    body = outcome["tuple"] if isinstance(outcome, dict) and "tuple" in outcome else outcome
    is_row = isinstance(body, list) and all(map(is_number, body))
    return size > 0 and is_row and len(body) > size and len(body) % size == 0


def _said_of_no_quaternion(members: list[Plain]) -> Text | None:
    if members and all(isinstance(row, list) or isinstance(inside(row), list) for row in members):
        return {1: ONE_INSIDE, 3: A_MATRIX, 4: A_MATRIX}.get(len(members), ROWS)
    return {2: WITHOUT_ZEROS, 3: ANGLES}.get(len(members)) if all(map(is_number, members)) else None


def _said_of_no_such_message(form: Message, outcome: Plain) -> Text:
    kind = str(outcome["message"][0]) if isinstance(outcome, dict) and "message" in outcome else ""
    fields = {path.partition(".")[0] for path in form.fields}
    field = kind.rpartition("/")[2].lower()
    return A_FIELD.filled(field=field) if field in fields else NO_MESSAGE.filled(name=form.type.rpartition("/")[2])


def _said_of_an_object(form: Form, outcome: dict[str, Plain]) -> Text | None:
    if "Transform" in outcome and type(form) in OF_A_TRANSFORM:
        return OF_A_TRANSFORM[type(form)]
    if not isinstance(form, Name | Choice):
        return None
    held = str(outcome.get("object"))
    return A_CLASS if held == "type" else AN_ERROR if "returned and not raised" in held else None


def _said_of_a_list(form: ListForm, outcome: Plain) -> Text | None:
    if isinstance(outcome, dict) and "set" in outcome:
        return A_SET
    return ONE_ALONE if not isinstance(outcome, list) and form.of.read(outcome) is not None else None


def kinds_said(form: Form, outcomes: Sequence[Plain]) -> list[Text]:
    """Return the same of all calls of a function, each once."""
    return list(dict.fromkeys(words for outcome in outcomes if (words := kind_said(form, outcome)) is not None))


def seconds_of(form: Form, outcome: Plain) -> float | None:
    """Return the seconds of a Duration, a Time or a stamp that was given for a number of seconds; None of others."""
    if not (isinstance(form, Number) and form.unit == "s" and isinstance(outcome, dict)):
        return None
    sec, nanosec = member(outcome, "sec"), member(outcome, "nanosec")
    if isinstance(sec, int) and isinstance(nanosec, int) and "message" in outcome:
        return sec + nanosec / 1e9
    held = outcome.get("Duration", outcome.get("Time"))
    length = held[0] if isinstance(held, list) and held else held
    return length / 1e9 if isinstance(length, int) else None


def of_times(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], explained: Explains
) -> Explanation | None:
    """Return what `explained` says of the seconds in Durations or Times, and that they are no numbers; else None."""
    seconds = [seconds_of(task.form, outcome) for outcome in outcomes]
    if None in seconds or all_alike(task.form, seconds, [case.expected for case in cases]):
        return None
    first, said = explained(task, cases, seconds), kind_said(task.form, outcomes[0])
    if first is None or said is None:
        return None
    return and_then(first, Explanation.of("no number", Text(f"{said.en}.", f"{said.ko}.")))
