"""A function stopped with Python's own error: what does it mean here?  The few that everybody meets, once for all.

    map_T_base @ odom_T_base.inverse    unsupported operand type(s) for @: 'Transform' and 'method'
                                        -> a method was not called: its brackets are missing

Python says what it could not do; this page adds which slip is behind it, where that is
sure; what was asked of a message, a Time or a tuple that has no such thing is told in
`objects.py`.
"""

from __future__ import annotations

import re

from ...text import Text
from .objects import OF_OBJECTS

__all__ = ["tip_for"]

NO_TIP = Text("", "")
LONGEST = 500  # letters of an error that are looked at
TIPS = (  # the error's name and text, the first that fits
    (
        r"TypeError: .*different clock types",
        Text(
            "One of the two times is of the ROS clock, the other is not (a bare `Time()`, say): "
            "compare their `.nanoseconds`.",
            "두 시각 가운데 하나는 ROS 시계의 것이고 다른 하나는 아닙니다(예: 그냥 `Time()`). "
            "`.nanoseconds`로 비교하십시오.",
        ),
    ),
    (
        r"AttributeError: 'property' object has no attribute",  # a type that lacks a name is a misspelt one as often
        Text(
            "That is the class, and not one of its kind: brackets make one, as in `PointStamped()`.",
            "클래스 자체입니다. `PointStamped()`처럼 괄호를 붙여 객체를 만드십시오.",
        ),
    ),
    (
        r"(Type|Attribute)Error: .*'(method|builtin_function_or_method|function)'",
        Text(
            "A method was not called: its brackets are missing, as in `.inverse()`.",
            "메서드를 호출하지 않았습니다. `.inverse()`처럼 괄호가 필요합니다.",
        ),
    ),
    (
        r"TypeError: unsupported operand type\(s\) for [-+*/]: .*'Transform'",
        Text(
            "Transforms are not added, subtracted or divided: `@` joins them, `.inverse()` turns one round.",
            "변환은 더하거나 빼거나 나누지 않습니다. `@`로 잇고 `.inverse()`로 뒤집습니다.",
        ),
    ),
    (
        r"TypeError: unsupported operand type\(s\) for @: ",
        Text(
            "`@` joins two Transforms; a point is moved by `.apply(point)`.",
            "`@`는 변환 둘을 잇습니다. 점은 `.apply(point)`로 옮깁니다.",
        ),
    ),
    (
        r"TypeError: (can only concatenate str|.*unsupported operand.*'str'|can't multiply sequence)",
        Text(
            "A text or a list does not compute: `float(text)` makes a number of a text, members of a list are taken "
            "one by one.",
            "글자나 리스트로는 계산할 수 없습니다. 글자는 `float(글자)`로 수를 만들고, 리스트는 원소를 하나씩 "
            "꺼내십시오.",
        ),
    ),
    (
        r"TypeError: .*(unsupported operand.*'(tuple|list)'|can only concatenate (list|tuple))",
        Text(
            "Lists and tuples do not compute as wholes: take their members one by one.",
            "리스트와 튜플은 통째로 계산되지 않습니다. 원소를 하나씩 꺼내 계산하십시오.",
        ),
    ),
    (
        r"(Type|Attribute)Error: .*'?NoneType'?",
        Text(
            "Something there is None: what gave it has no `return`, or found nothing.",
            "그곳의 값이 None입니다. 그 값을 준 것에 `return`이 없거나, 찾지 못한 것입니다.",
        ),
    ),
    (
        r"AttributeError: 'dict' object",
        Text(
            'What a dict holds stands in square brackets: `pose["x"]`.',
            '딕셔너리의 값은 대괄호로 꺼냅니다: `pose["x"]`.',
        ),
    ),
    (
        r"TypeError: '(Transform|Point|PointStamped|TransformStamped|Vector3|Quaternion)' object is not "
        r"(subscriptable|iterable)",
        Text(
            "Its numbers have names, and no places: `.translation`, `.point.x` and the like.",
            "순번이 아니라 이름으로 꺼냅니다: `.translation`, `.point.x` 등.",
        ),
    ),
    (
        r"KeyError",
        Text(
            "That key is not in it: of a dict, `.get(key, otherwise)` does not stop where one is missing.",
            "그 안에 없는 키입니다. 딕셔너리라면 `.get(key, 기본값)`으로 꺼내면 멈추지 않습니다.",
        ),
    ),
    (
        r"IndexError: .*(out of range|out of bounds|pop from empty)|ValueError: (max|min)\(\) .*empty|StopIteration",
        Text(
            "There is less in it than you count on: is a list short, or empty? Did nothing fit what you looked for?",
            "생각보다 적게 들어 있습니다. 리스트가 짧거나 비어 있습니까? 찾으려던 것과 맞는 것이 하나도 없었습니까?",
        ),
    ),
    (
        r"ValueError: (could not convert string to float|invalid literal for int)",
        Text(
            "That text is no such number as it stands: a point where a whole number is wanted, or another word, a "
            "colon or a comma on it. Lines and words counted off in one text stand elsewhere in another: look for the "
            "words around the number.",
            "그 문자열은 그대로는 그런 수가 아닙니다. 정수여야 하는데 소수점이 있거나 다른 낱말, 콜론, 쉼표가 붙어 "
            "있습니다. 한 글에서 센 줄과 낱말의 자리는 다른 글에서 달라집니다. 숫자 앞뒤의 낱말로 찾으십시오.",
        ),
    ),
    (
        r"ValueError: .*(to unpack|unpack )",
        Text(
            "As many names as values have to stand on the left.",
            "왼쪽의 이름 수와 값의 수가 같아야 합니다.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*'sec' field must be (an integer in|of type 'int')",
        Text(
            "`sec` holds whole seconds, as an `int`, and `nanosec` what is left over of them: `.to_msg()` of a Time "
            "writes both.",
            "`sec`에는 초의 정수 부분(`int`)이, `nanosec`에는 나머지가 들어갑니다. Time의 `.to_msg()`가 둘을 채웁니다.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be of type 'int'",
        Text(
            "The field takes a whole number alone: `int(…)` or `round(…)` makes one.",
            "이 필드에는 정수만 들어갑니다. `int(…)`나 `round(…)`로 바꾸십시오.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be of type 'str'",
        Text(
            "The field takes a text: a name in quotes, or a variable that holds one.",
            "이 필드에는 글자가 들어갑니다. 따옴표로 묶은 이름이나 그런 값을 담은 변수를 쓰십시오.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be an? (un)?signed integer",
        Text(
            "The type is right, and the number does not fit. `nanosec` holds only what is left over the whole "
            "seconds, below 1000000000: `.to_msg()` of a Time splits it.",
            "자료형은 맞지만 들어갈 수 없는 수입니다. `nanosec`에는 초를 뺀 나머지, 곧 1000000000보다 작은 수만 "
            "들어갑니다. Time의 `.to_msg()`가 나누어 줍니다.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be a sub message of type '(Vector3|Point|Quaternion)'",
        Text(
            "A tuple or a list is no such message: write its numbers one by one, `.x`, `.y`, `.z`, of a rotation "
            "`.w` too.",
            "튜플이나 리스트는 그런 메시지가 아닙니다. `.x`, `.y`, `.z`에 하나씩, 회전은 `.w`까지 쓰십시오.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be a sub message of type 'Time'",
        Text(
            "A stamp is a message of its own: `.to_msg()` of a Time makes it.",
            "stamp도 하나의 메시지입니다. Time의 `.to_msg()`로 만드십시오.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be of type 'float'",
        Text(
            "The field takes a `float` alone: `float(…)` makes one of a whole number or a text.",
            "이 필드에는 `float`만 들어갑니다. 정수나 글자는 `float(…)`로 바꾸십시오.",
        ),
    ),
    (
        r"(Assertion|Type)Error: .*field must be",
        Text(
            "A field of a message takes its own type alone: `float(…)` for a number, `.to_msg()` for a Time.",
            "메시지의 필드는 정해진 자료형만 받습니다. 숫자는 `float(…)`, Time은 `.to_msg()`로 바꾸십시오.",
        ),
    ),
    (
        r"ZeroDivisionError",
        Text(
            "Which of the arguments is 0 in this call, or which two are the same?",
            "이 호출에서 0인 인자, 또는 서로 같은 두 인자는 무엇입니까?",
        ),
    ),
    (
        r"NameError|UnboundLocalError",
        Text(
            "Inside the function nobody has given that name a value: is it misspelt, or set on another way through?",
            "함수 안에서 그 이름에 값을 준 적이 없습니다. 철자가 다르거나, 값을 정하지 않고 지나가는 갈래가 "
            "있지 않습니까?",
        ),
    ),
    (
        r"AttributeError: 'Time' object has no attribute '(sec|nanosec|nanoseconds)'",
        Text(
            "There are two kinds of Time: the stamp of a message has `.sec` and `.nanosec`, a Time of rclpy has "
            "`.nanoseconds`. `Time.from_msg(stamp)` makes the second of the first.",
            "Time은 두 가지입니다. 메시지의 stamp에는 `.sec`과 `.nanosec`이, rclpy의 Time에는 `.nanoseconds`가 "
            "있습니다. `Time.from_msg(stamp)`가 앞의 것을 뒤의 것으로 바꿉니다.",
        ),
    ),
    (
        r"TypeError: unhashable type: '(list|set|dict)'",
        Text(
            "A list, a set or a dict cannot be a member of a set or a key of a dict: `.update(…)` puts its members "
            "into a set one by one.",
            "리스트, 집합, 딕셔너리는 집합의 원소나 딕셔너리의 키가 될 수 없습니다. `.update(…)`를 쓰면 그 원소가 "
            "하나씩 집합에 들어갑니다.",
        ),
    ),
    (
        r"RecursionError",
        Text(
            "It calls itself without an end: which case has to stop it?",
            "자기 자신을 끝없이 호출합니다. 어떤 경우에 멈춰야 합니까?",
        ),
    ),
    (
        r"TypeError: .*(an unexpected|an invalid) keyword argument",
        Text(
            "It takes no argument of that name: is it misspelt?",
            "그런 이름의 인자는 없습니다. 철자가 다르지 않습니까?",
        ),
    ),
    (
        r"TypeError: .*(positional argument|keyword argument)",
        Text(
            "Compare how many arguments are handed over with how many are taken.",
            "넘기는 인자의 수와 받는 인자의 수를 비교하십시오.",
        ),
    ),
    (
        r'LookupException: "[^"]*" passed to lookupTransform argument',
        Text(
            "The buffer of this call holds no frame of that name, and yet the call has an answer. If the name is "
            "written down in your function, is it the name that this call is about? If it came with the call, does "
            "your `except` name another class?",
            "이 호출의 버퍼에는 그런 이름의 좌표계가 없는데, 이 호출에는 답이 있습니다. 함수 안에 적어 둔 이름이라면, "
            "이 호출에서 묻는 이름이 맞습니까? 호출과 함께 온 이름이라면, `except`에 다른 클래스를 쓰지는 않았습니까?",
        ),
    ),
    (
        r"(Lookup|Connectivity|Extrapolation|InvalidArgument|Transform)Exception",
        Text(
            "That is a refusal, tf2's or that of a `raise` of your own, and this call has an answer: are the frames, "
            "their order and the time those of this call? Is a `raise` reached too soon, or does an `except` name "
            "another class?",
            "tf2나 직접 쓴 `raise`가 거절했는데, 이 호출에는 답이 있습니다. 좌표계와 그 순서, 시각이 이 호출의 "
            "것입니까? `raise`에 너무 일찍 이르거나, `except`에 다른 클래스를 쓰지는 않았습니까?",
        ),
    ),
)


def tip_for(error: str, text: str) -> Text:
    """Return what is behind one of Python's errors, or nothing."""
    said = f"{error}: {text}"[:LONGEST]
    return next((tip for pattern, tip in (*OF_OBJECTS, *TIPS) if re.match(pattern, said, re.DOTALL)), NO_TIP)
