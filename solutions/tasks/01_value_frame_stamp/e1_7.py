"""E1.7: Four detectors, one honest."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

NAMES = ("red", "green", "blue", "grey")
HONEST, ARRIVAL, NONE, LABEL = "honest", "stamp is the arrival", "no stamp", "wrong label"
FINDINGS = (HONEST, ARRIVAL, NONE, LABEL)
THINKING_S = 0.2


def logs(rng):
    speed = round(float(rng.uniform(0.4, 1.2)), 2)
    ball_m = round(float(rng.uniform(7.0, 9.0)), 2)
    start_m = round(float(rng.uniform(0.5, 2.0)), 2)
    of = dict(zip(NAMES, (FINDINGS[i] for i in rng.permutation(4)), strict=True))
    heard = {}
    for i, (name, finding) in enumerate(of.items()):
        lines = []
        for n in range(5):
            stamp = round(5.0 + 0.5 * n + 0.07 * i, 2)
            arrival = round(stamp + THINKING_S, 2)
            ahead = round(ball_m - start_m - speed * stamp, 2)
            lines.append({
                HONEST: [arrival, stamp, "map", ball_m],
                ARRIVAL: [arrival, arrival, "map", round(ball_m + speed * THINKING_S, 2)],
                NONE: [arrival, 0.0, "base_link", ahead],
                LABEL: [arrival, stamp, "map", ahead],
            }[finding])  # fmt: skip
        heard[name] = lines
    return {"speed_mps": speed, "heard": heard}


def found(given):
    """Return the right findings, as the clues give them."""
    return {name: _finding(lines) for name, lines in given.heard.items()}


def _finding(lines):
    (arrival, stamp, frame, first), last = lines[0], lines[-1][3]
    if stamp == 0.0:
        return NONE
    if stamp == arrival:
        return ARRIVAL
    return LABEL if frame == "map" and first - last > 0.1 else HONEST


def instead(**said):
    """Return the findings of somebody who says otherwise of these kinds, such as ARRIVAL."""
    swaps = {ARRIVAL: said.get("arrival", ARRIVAL), LABEL: said.get("label", LABEL), HONEST: said.get("honest", HONEST)}
    swaps[NONE] = said.get("none", NONE)
    return lambda given: {name: swaps[finding] for name, finding in found(given).items()}


FAST_IS_HONEST = WrongAnswer(
    "fast is honest",
    instead(arrival=HONEST),
    Text(
        en="One that arrives in the moment of its stamp is not quick: finding the ball takes each of them 0.2 s. An age of 0.000 is too good to be true.",
        ko="측정 시각과 도착 시각이 같다고 해서 빠른 것이 아닙니다. 공을 찾는 데는 모두 0.2초가 걸립니다. 나이 0.000은 너무 좋아서 믿을 수 없습니다.",
    ),
    "M9",
)

FAST_IS_THE_HONEST_ONE = WrongAnswer(
    "fast is the honest one",
    instead(arrival=HONEST, honest=ARRIVAL),
    Text(
        en='Honest and "stamp is the arrival" have changed places. Each of them needs 0.2 s: whose stamp lies that long before its arrival?',
        ko="honest와 “stamp is the arrival”이 뒤바뀌었습니다. 모두 0.2초가 필요합니다. 측정 시각이 도착보다 그만큼 이른 것은 어느 쪽입니까?",
    ),
    "M9",
)

A_KNOWN_FRAME_IS_HONEST = WrongAnswer(
    "a known frame is honest",
    instead(label=HONEST),
    Text(
        en="map is a known name, but a ball that rests cannot move on the map. One of them sees its x shrink as the robot drives: whose numbers are these really?",
        ko="map은 아는 이름이지만, 가만히 있는 공은 지도 위에서 움직일 수 없습니다. 로봇이 달릴수록 x가 줄어드는 것이 있습니다. 그 숫자는 사실 누구의 것입니까?",
    ),
)

SHRINKING_IS_A_LIE = WrongAnswer(
    "shrinking is a lie",
    instead(none=LABEL),
    Text(
        en="The numbers of that one are right for its frame: in base_link a ball ahead *must* come nearer while the robot drives. Look at its stamps instead. They are 0.0, and that is how a missing stamp looks: there is no empty field in a message.",
        ko="그 숫자는 좌표계에 맞습니다. 로봇이 달리면 base_link 기준으로 앞의 공은 *당연히* 가까워집니다. 대신 측정 시각을 보십시오. 0.0입니다. 메시지에는 빈 칸이 없으므로, 아무도 쓰지 않은 측정 시각은 이렇게 보입니다.",
    ),
    "M15",
)

ZERO_IS_FINE = WrongAnswer(
    "zero is fine",
    instead(none=HONEST),
    Text(
        en='A stamp of 0.0 does not mean "just now": nobody has written one.',
        ko="측정 시각 0.0은 “방금”이라는 뜻이 아닙니다. 아무도 쓰지 않은 것입니다.",
    ),
    "M9",
)

LATE_IS_A_FAULT = WrongAnswer(
    "late is a fault",
    instead(honest=LABEL, label=HONEST),
    Text(
        en='Honest and "wrong label" have changed places. The ball rests: on the map its x has to stay, line after line.',
        ko="honest와 “wrong label”이 뒤바뀌었습니다. 공은 가만히 있습니다. 지도 기준이라면 x가 줄마다 그대로여야 합니다.",
    ),
)

MEANS = {
    HONEST: Text(
        en="An honest one is 0.2 s old when it arrives, in a frame in which its x may do what it does.",
        ko="정직한 것은 도착할 때 0.2초 지난 것이고, x의 변화가 그 좌표계에 맞습니다.",
    ),
    ARRIVAL: Text(
        en="A stamp that is the arrival would equal it line by line, to the hundredth: compare the two.",
        ko="stamp is the arrival이라면 줄마다 측정 시각과 도착 시각이 소수점까지 같을 것입니다. 둘을 비교해 보십시오.",
    ),
    NONE: Text(
        en="Without a stamp, the stamps would be 0: read the second number.",
        ko="no stamp라면 측정 시각이 0일 것입니다. 두 번째 숫자를 보십시오.",
    ),
    LABEL: Text(
        en="A wrong label would mean that the numbers cannot be of the frame that is written there: follow x from line to line. The ball "
        "rests, and the robot drives.",
        ko="wrong label이라면 숫자가 거기 적힌 좌표계의 것일 수 없습니다. 줄마다 x를 따라가 보십시오. 공은 가만히 있고 로봇은 달립니다.",
    ),
}

TASK = Task(
    id="E1.7",
    kind="D",
    points=3,
    title=Text(en="Four detectors, one honest", ko="검출기 넷, 정직한 것은 하나"),
    answer="findings",
    form=Parts({name: Choice(FINDINGS) for name in NAMES}),
    given=logs,
    variants=6,
    means=MEANS,
    mistakes=(
        FAST_IS_HONEST,
        FAST_IS_THE_HONEST_ONE,
        A_KNOWN_FRAME_IS_HONEST,
        SHRINKING_IS_A_LIE,
        ZERO_IS_FINE,
        LATE_IS_A_FAULT,
    ),
    hints=(
        Text(
            en="Take arrival minus stamp for each, and compare it with the time that a picture takes.",
            ko="각각 도착에서 측정 시각을 빼고, 영상 처리에 걸리는 시간과 비교해 보세요.",
        ),
        Text(
            en="Then follow x from line to line: in which frame may the x of a resting ball change?",
            ko="그다음 줄마다 x를 따라가 보세요. 가만히 있는 공의 x가 바뀌어도 되는 좌표계는 어느 것입니까?",
        ),
        Text(
            en="Each finding is used once. Age 0: the arrival was written. Stamp 0: nobody wrote one. x in map shrinks: the label lies.",
            ko="답은 한 번씩만 쓰입니다. 나이가 0이면 도착 시각을 적은 것, 측정 시각이 0이면 쓰지 않은 것, map 기준 x가 줄어들면 이름표가 거짓입니다.",
        ),
    ),
    misconceptions=("M9", "M15"),
)
