"""What was a buffer asked that it cannot answer?  What its refusals mean where there is an answer.

    lookup_transform_full(...) missing 1 required positional argument     -> it takes five things
    Type <class 'geometry_msgs.msg._point.Point'> is not loaded           -> what has no header cannot be moved
    Lookup would require extrapolation into the future                    -> later than all that the buffer holds

The first pattern that fits, from the special to the general.
"""

from __future__ import annotations

from ...text import Text

__all__ = ["BUFFERS"]

BUFFERS = (
    (
        r"TypeError: Buffer\.lookup_transform_full\(\) missing",
        Text(
            "This lookup takes five things: the target frame and its moment, the source frame and its moment, and the "
            "frame that stands still between the two.",
            "이 조회에는 목표 좌표계와 그 시각, 원본 좌표계와 그 시각, 그리고 두 시각 사이에 가만히 있는 좌표계까지 "
            "다섯 가지가 필요합니다.",
        ),
    ),
    (
        r"TypeException: Type <class '(?:\w+\.)*(Point|Vector3|Quaternion|Pose|Transform|Header)'> is not loaded",
        Text(
            "`buffer.transform` moves messages with a header, such as a PointStamped: it reads frame and stamp there, "
            "and this one has none.",
            "`buffer.transform`은 PointStamped처럼 header가 있는 메시지를 옮깁니다. 좌표계와 시각을 거기서 읽는데, "
            "header가 없는 메시지에는 둘 다 없습니다.",
        ),
    ),
    (
        r"TypeException: Type <class '(?:\w+\.)*\w+Stamped'> is not loaded",
        Text(
            "The type is a right one, and nobody has loaded it: `import tf2_geometry_msgs`.",
            "옮길 수 있는 타입이지만 불러오지 않았습니다: `import tf2_geometry_msgs`.",
        ),
    ),
    (
        r"TypeException: Type <class '\w+'> is not loaded",
        Text(
            "`buffer.transform` takes the message first, then the frame that it is wanted in.",
            "`buffer.transform`에는 메시지를 먼저, 그다음에 목표 좌표계를 넘깁니다.",
        ),
    ),
    (
        r"TypeError: (BufferCore|Buffer)\.lookup_transform\(\) missing",
        Text(
            "A lookup takes three things: the target frame, the source frame and the moment.",
            "조회에는 목표 좌표계, 원본 좌표계, 시각의 세 가지가 필요합니다.",
        ),
    ),
    (
        r"InvalidArgumentException: .*cannot start with a '/'",
        Text(
            "A frame is asked for without the slash in front.",
            "좌표계는 앞에 슬래시를 붙이지 않고 묻습니다.",
        ),
    ),
    (
        r"InvalidArgumentException: .*cannot be empty",
        Text(
            "You ask for a frame without a name: the text is empty that you hand over.",
            "이름이 없는 좌표계를 물었습니다. 넘긴 문자열이 비어 있습니다.",
        ),
    ),
    (
        r"ExtrapolationException: Lookup would require extrapolation into the future",
        Text(
            "You ask about a moment later than all that the buffer holds (both stand in the text), and this call has "
            "an answer. Is it the moment of this call, and in the unit that the buffer takes?",
            "버퍼에 있는 것보다 나중 시각을 물었습니다(두 시각이 메시지에 있습니다). 이 호출에는 답이 있습니다. 이 "
            "호출에서 말하는 시각이 맞고, 버퍼가 받는 단위입니까?",
        ),
    ),
    (
        r"ExtrapolationException: Lookup would require extrapolation into the past",
        Text(
            "You ask about a moment earlier than all that the buffer holds (both stand in the text), and this call has "
            "an answer. Is it the moment of this call, and in the unit that the buffer takes?",
            "버퍼에 있는 것보다 이른 시각을 물었습니다(두 시각이 메시지에 있습니다). 이 호출에는 답이 있습니다. 이 "
            "호출에서 말하는 시각이 맞고, 버퍼가 받는 단위입니까?",
        ),
    ),
    (
        r"ConnectivityException: Could not find a connection between",
        Text(
            "In this buffer no way leads between the two frames of the text, and this call has an answer: are they the "
            "frames of this call?",
            "메시지에 나온 두 좌표계는 이 버퍼에서 이어져 있지 않은데, 이 호출에는 답이 있습니다. 이 호출에서 말하는 "
            "좌표계가 맞습니까?",
        ),
    ),
)
