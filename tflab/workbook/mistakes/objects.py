"""What was asked of something that has no such thing?  A message, a Time, a transform, a tuple: what it has instead.

    'TransformStamped' object has no attribute 'translation'     -> one level down: `.transform.translation`
    unsupported operand type(s) for -: 'Time' and 'Time'         -> stamps of messages: `Time.from_msg(stamp)` first
    'tuple' object has no attribute 'x'                          -> places, and no names: `[0]`

Like `stumbles.py`, which asks here first: the first pattern that fits, from the special
to the general.
"""

from __future__ import annotations

from ...text import Text
from .buffers import BUFFERS

__all__ = ["OF_OBJECTS"]

NO_ATTRIBUTE = "object has no attribute"
MESSAGES = (
    (
        rf"AttributeError: 'StampedTransform' {NO_ATTRIBUTE} '(translation|rotation|inverse|apply|rpy)"
        r"|TypeError: unsupported operand type\(s\) for @: .*'StampedTransform'",
        Text(
            "A lookup gives frames and stamp as well: the transform itself is its `.transform`.",
            "조회 결과에는 좌표계와 시각도 들어 있습니다. 변환 자체는 `.transform`입니다.",
        ),
    ),
    (
        rf"AttributeError: '(TransformStamped|Transform)' {NO_ATTRIBUTE} '(inverse|apply|rpy)'"
        r"|TypeError: unsupported operand type\(s\) for @: ('TransformStamped'|.* and 'TransformStamped'|"
        r"'Transform' and 'Transform'$)",
        Text(
            "That is a message, which holds numbers and does not compute: make a `Transform(translation, rotation)` of "
            "them first.",
            "숫자만 담은 메시지라 계산은 하지 못합니다. 그 숫자로 `Transform(이동, 회전)`을 먼저 만드십시오.",
        ),
    ),
    (
        rf"AttributeError: '\w+Stamped' {NO_ATTRIBUTE} '(frame_id|stamp)'",
        Text(
            "Frame and stamp stand in the message's header: `.header.frame_id`, `.header.stamp`.",
            "좌표계와 시각은 메시지의 header 안에 있습니다: `.header.frame_id`, `.header.stamp`.",
        ),
    ),
    (
        rf"AttributeError: '(PointStamped|PoseStamped|TransformStamped|Pose)' {NO_ATTRIBUTE} "
        r"'([xyzw]|position|orientation|translation|rotation)'",
        Text(
            "Its numbers are one level down: `.point.x`, `.pose.position.x`, `.transform.translation.x`, as the "
            "message has them.",
            "숫자는 한 단계 안쪽에 있습니다. 메시지에 따라 `.point.x`, `.pose.position.x`, "
            "`.transform.translation.x`입니다.",
        ),
    ),
    (
        rf"AttributeError: 'Header' {NO_ATTRIBUTE} ",
        Text(
            "A header has `.frame_id` and `.stamp`; `.child_frame_id` stands beside the header, in the message itself.",
            "header에는 `.frame_id`와 `.stamp`만 있습니다. `.child_frame_id`는 header 옆, 메시지 바로 아래에 있습니다.",
        ),
    ),
    (
        rf"AttributeError: 'Transform' {NO_ATTRIBUTE} ",
        Text(
            "A Transform has `.translation` and `.rotation`; roll, pitch and yaw come from `.rpy()`.",
            "Transform에는 `.translation`과 `.rotation`이 있고, roll, pitch, yaw는 `.rpy()`로 얻습니다.",
        ),
    ),
    (
        rf"AttributeError: '(Point|Vector3|Quaternion)' {NO_ATTRIBUTE} ",
        Text(
            "It has the numbers `.x`, `.y`, `.z`, a Quaternion also `.w`, and nothing else.",
            "그 안에는 `.x`, `.y`, `.z`(Quaternion은 `.w`까지)만 있습니다.",
        ),
    ),
    (
        rf"AttributeError: 'TransformStamped' {NO_ATTRIBUTE} ",
        Text(
            "A TransformStamped has three parts: `.header`, `.child_frame_id` and `.transform`.",
            "TransformStamped에는 `.header`, `.child_frame_id`, `.transform` 세 가지가 있습니다.",
        ),
    ),
    (
        rf"AttributeError: 'PointStamped' {NO_ATTRIBUTE} ",
        Text(
            "A PointStamped has two parts: `.header` and `.point`.",
            "PointStamped에는 `.header`와 `.point` 두 가지가 있습니다.",
        ),
    ),
    (
        r"TypeError: (point|translation|rotation) .*needs . numbers, not (geometry_msgs|Transform)",
        Text(
            "Hand over numbers, and no object: of a message `(point.x, point.y, point.z)`, of a Transform its "
            "`.translation` or `.rotation`.",
            "객체가 아니라 숫자를 넘기십시오. 메시지라면 `(point.x, point.y, point.z)`, Transform이라면 "
            "`.translation`이나 `.rotation`입니다.",
        ),
    ),
    (
        r"TypeError: (Transform\.)?apply\(\) takes 2 positional arguments",
        Text(
            "`.apply` takes one point, with brackets of its own: `.apply((x, y, z))`.",
            "`.apply`는 점 하나를 받습니다. 점에도 괄호가 필요합니다: `.apply((x, y, z))`.",
        ),
    ),
    (
        r"TypeError: bad operand type for unary -: 'Transform'",
        Text("A transform is turned round by `.inverse()`.", "변환은 `.inverse()`로 뒤집습니다."),
    ),
)
TIMES = (
    (
        rf"AttributeError: 'Time' {NO_ATTRIBUTE} 'to_msg'",
        Text(
            "This one is the stamp of a message already; `.to_msg()` makes such a stamp of a Time of rclpy.",
            "이미 메시지의 stamp입니다. `.to_msg()`는 rclpy의 Time을 stamp로 바꿀 때 씁니다.",
        ),
    ),
    (
        rf"AttributeError: 'Time' {NO_ATTRIBUTE} '(?!(sec|nanosec|nanoseconds)')",
        Text(
            "The stamp of a message has `.sec` and `.nanosec`, a Time of rclpy has `.nanoseconds`.",
            "메시지의 stamp에는 `.sec`과 `.nanosec`이, rclpy의 Time에는 `.nanoseconds`가 있습니다.",
        ),
    ),
    (
        rf"AttributeError: 'Duration' {NO_ATTRIBUTE} ",
        Text(
            "The difference of two Times is a Duration, whose length is its `.nanoseconds`.",
            "두 Time의 차는 Duration이고, 그 길이는 `.nanoseconds`입니다.",
        ),
    ),
    (
        r"TypeError: unsupported operand type\(s\) for [-+]: 'Time' and 'Time'",
        Text(
            "The stamp of a message does not compute. `Time.from_msg(stamp)` makes a Time of it: subtract such Times, "
            "or their `.nanoseconds`.",
            "메시지의 stamp로는 계산할 수 없습니다. `Time.from_msg(stamp)`로 Time을 만들어 빼거나, 그 `.nanoseconds`를 "
            "빼십시오.",
        ),
    ),
    (
        r"TypeError: .*(unsupported operand|not supported between|must be a string or a real number).*"
        r"'(Time|Duration)'",
        Text(
            "A time is no number. A Time and a Duration of rclpy have one, `.nanoseconds`; `Time.from_msg(stamp)` "
            "makes a Time of a message's stamp.",
            "시각은 수가 아닙니다. rclpy의 Time과 Duration에서는 `.nanoseconds`가 수입니다. 메시지의 stamp는 "
            "`Time.from_msg(stamp)`로 Time을 만드십시오.",
        ),
    ),
    (
        r"TypeError: Must pass a builtin_interfaces.msg.Time",
        Text(
            "`Time.from_msg` takes the stamp of a message, `.header.stamp`, and what you hand over is none.",
            "`Time.from_msg`에는 메시지의 stamp, 곧 `.header.stamp`를 넣습니다. 지금 넘긴 것은 stamp가 아닙니다.",
        ),
    ),
    (
        r"TypeError: Time\.__init__\(\) takes 1 positional argument",
        Text(
            "A Time wants to be told what the number counts: `Time(nanoseconds=…)` or `Time(seconds=…)`.",
            "Time에는 무엇을 세는 수인지 함께 씁니다: `Time(nanoseconds=…)` 또는 `Time(seconds=…)`.",
        ),
    ),
    (
        r"TypeError: a stamp is an int of nanoseconds, not (Time\(|builtin_interfaces)",
        Text(
            "The `.nanoseconds` of a Time are such a number; `Time.from_msg(stamp)` makes a Time of a message's stamp.",
            "Time의 `.nanoseconds`가 그런 수입니다. 메시지의 stamp는 `Time.from_msg(stamp)`로 Time을 만드십시오.",
        ),
    ),
    (
        r"TypeError: time must have sec and nanosec",
        Text(
            "Where this buffer expects a moment, it was handed something else: a number, say, or a frame's name. "
            "`Time(nanoseconds=…)` makes a moment, and the order is that of the method.",
            "이 버퍼가 시각을 받을 자리에 숫자나 좌표계 이름처럼 다른 것을 넘겼습니다. 시각은 `Time(nanoseconds=…)`로 "
            "만들고, 인자의 순서는 메서드를 따르십시오.",
        ),
    ),
    (
        rf"AttributeError: '(int|float)' {NO_ATTRIBUTE} 'nanoseconds'",
        Text(
            "A plain number stands where a Duration or a Time is expected. A `timeout`, say, is a Duration: "
            "`Duration(seconds=…)`.",
            "Duration이나 Time이 와야 할 자리에 그냥 숫자가 있습니다. 예를 들어 `timeout`에는 `Duration(seconds=…)`을 "
            "넘깁니다.",
        ),
    ),
)
VALUES = (
    (
        rf"AttributeError: '(tuple|list)' {NO_ATTRIBUTE} '[xyzw]'",
        Text(
            "The numbers of a tuple or a list have places, and no names: `[0]` for x, `[1]` for y, `[2]` for z.",
            "튜플과 리스트의 숫자에는 이름이 없고 자리가 있습니다. x는 `[0]`, y는 `[1]`, z는 `[2]`입니다.",
        ),
    ),
    (
        rf"AttributeError: 'tuple' {NO_ATTRIBUTE} '(roll|pitch|yaw)'",
        Text(
            "Roll, pitch and yaw come as a tuple in this order: `[0]`, `[1]`, `[2]`.",
            "roll, pitch, yaw는 이 순서대로 튜플에 들어 있습니다: `[0]`, `[1]`, `[2]`.",
        ),
    ),
    (
        r"TypeError: (list|tuple) indices must be integers or slices, not str",
        Text(
            "The members of a list or a tuple have numbers, and no names. If they are dicts, take one of them first, "
            "`for row in rows`, and then its key.",
            "리스트와 튜플의 원소에는 이름이 없고 번호가 있습니다. 원소가 딕셔너리라면 `for row in rows`처럼 하나를 "
            "꺼낸 다음 키를 쓰십시오.",
        ),
    ),
    (
        r"TypeError: '\w+' object is not callable",
        Text(
            "Brackets behind a value call it like a function. Either they are too many, as in `.translation()`, or a "
            "variable of yours has the name of a function, such as `sum` or `max`.",
            "값 뒤에 괄호를 쓰면 함수처럼 호출하게 됩니다. `.translation()`처럼 괄호가 필요 없거나, 변수 이름이 `sum`, "
            "`max` 같은 함수 이름과 같습니다.",
        ),
    ),
    (
        rf"AttributeError: '(int|float)' {NO_ATTRIBUTE} ",
        Text(
            "That is a plain number already: nothing has to be taken out of it.",
            "이미 숫자 하나입니다. 그 안에서 더 꺼낼 것이 없습니다.",
        ),
    ),
    (
        r"TypeError: ('(int|float)' object is not (subscriptable|iterable)|cannot unpack non-iterable (int|float)|"
        r"object of type '(int|float)' has no len)",
        Text(
            "A single number stands there, and it is taken for several: it has no members.",
            "그곳에는 숫자가 하나뿐인데 여럿인 것처럼 다루었습니다. 숫자 하나에는 원소가 없습니다.",
        ),
    ),
    (
        rf"AttributeError: 'list' {NO_ATTRIBUTE} 'add'|AttributeError: 'set' {NO_ATTRIBUTE} '(append|extend)'",
        Text(
            "A list grows by `.append(…)`, a set by `.add(…)`.",
            "리스트에는 `.append(…)`로, 집합에는 `.add(…)`로 넣습니다.",
        ),
    ),
    (
        rf"AttributeError: '(tuple|str)' {NO_ATTRIBUTE} '(append|add|extend|remove|insert|sort)'"
        r"|TypeError: '(tuple|str)' object does not support item assignment",
        Text(
            "A tuple or a text cannot be changed: begin with a list, `[]`, or make a new one.",
            "튜플과 글자는 바꿀 수 없습니다. 리스트 `[]`로 시작하거나 새로 만드십시오.",
        ),
    ),
    (
        rf"AttributeError: 'dict' {NO_ATTRIBUTE} '(append|add|extend)'",
        Text(
            "Into a dict one writes by a key: `tree[child] = parent`.",
            "딕셔너리에는 키로 넣습니다: `tree[child] = parent`.",
        ),
    ),
    (
        r"TypeError: must be real number, not (?!(NoneType|method|function|builtin_function_or_method))",
        Text(
            "`math` computes with single numbers: take one out of a tuple or a list; `float(text)` makes one of a "
            "text.",
            "`math`는 숫자 하나로 계산합니다. 튜플이나 리스트에서는 하나를 꺼내고, 글자는 `float(글자)`로 바꾸십시오.",
        ),
    ),
    (
        r"ValueError: (math domain error|expected a (nonnegative|number in range from -1))",
        Text(
            "`math.asin` and `math.acos` take numbers from -1 to 1, `math.sqrt` none below 0: what was handed over "
            "here?",
            "`math.asin`과 `math.acos`는 -1에서 1까지, `math.sqrt`는 0 이상의 수만 받습니다. 여기서는 무엇을 "
            "넘겼습니까?",
        ),
    ),
    (
        r"TypeError: bad operand type for .*'(tuple|list)'",
        Text(
            "Lists and tuples do not compute as wholes: take their members one by one.",
            "리스트와 튜플은 통째로 계산되지 않습니다. 원소를 하나씩 꺼내 계산하십시오.",
        ),
    ),
    (
        r"TypeError: '[<>]=?' not supported between instances of 'dict' and 'dict'",
        Text(
            'Dicts have no order: `key=lambda row: row["x"]` says by what they are compared.',
            '딕셔너리끼리는 크기를 비교할 수 없습니다. `key=lambda row: row["x"]`처럼 무엇으로 비교할지 쓰십시오.',
        ),
    ),
    (
        r"TypeError: '[<>]=?' not supported between instances of ('str' and '(int|float)'|'(int|float)' and 'str')",
        Text(
            "A text is not compared with a number: `float(text)` makes one of it.",
            "글자와 숫자는 비교할 수 없습니다. `float(글자)`로 바꾸십시오.",
        ),
    ),
    (
        r"ValueError: .*not in list",
        Text(
            "What you look for is not in that list: ask `if … in …` first.",
            "찾는 것이 그 리스트에 없습니다. 먼저 `if … in …`으로 확인하십시오.",
        ),
    ),
    (
        r"RuntimeError: (dictionary|Set|OrderedDict) .*changed .*during iteration",
        Text(
            "What a loop goes through is changed inside it: go through a copy, `list(…)`.",
            "반복하고 있는 것을 반복문 안에서 바꿉니다. `list(…)`로 복사한 것을 반복하십시오.",
        ),
    ),
    (
        r"AttributeError: module '\w+' has no attribute ",
        Text(
            "In that module nothing has this name: look at its spelling.",
            "그 모듈에는 이런 이름이 없습니다. 철자를 확인하십시오.",
        ),
    ),
)
OF_OBJECTS = (*MESSAGES, *TIMES, *BUFFERS, *VALUES)
