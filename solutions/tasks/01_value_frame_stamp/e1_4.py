"""E1.4: How far ahead by now?"""

from __future__ import annotations

from tflab.workbook.tasks import Number, Parts, Task, Text, WrongStep


def a_late_message(rng):
    """A second begins between stamp and arrival, and the arrival's nanosec is below 0.1 s."""
    sec = int(rng.integers(11, 95))
    stamp_ms = int(rng.integers(560, 880))
    arrived_ms = 1000 + int(rng.integers(12, 96)) + (1000 if rng.random() < 0.3 else 0)
    return {
        "stamp": [sec, stamp_ms * 1_000_000],
        "arrived": [sec + arrived_ms // 1000, arrived_ms % 1000 * 1_000_000],
        "speed_mps": round(float(rng.uniform(0.6, 0.9)) + 0.3 * float(rng.choice([0.0, 2.0])), 2),
        "ahead_m": round(float(rng.uniform(3.0, 7.0)), 2),
    }


def seconds_of(stamp):
    return stamp[0] + stamp[1] / 1e9


def as_digits(stamp):
    return float(f"{stamp[0]}.{stamp[1]}")


def by_arrival(given, *, age="all", way="arrival minus stamp", unit="s", drive="closer", written="s"):
    """Return age and distance, step by step; other steps are the slips."""
    (sec, nanosec), (arrived_sec, arrived_nanosec) = given.stamp, given.arrived
    age_s = {
        "all": seconds_of(given.arrived) - seconds_of(given.stamp),
        "digits": as_digits(given.arrived) - as_digits(given.stamp),
        "sec alone": float(arrived_sec - sec),
        "nanosec alone": (arrived_nanosec - nanosec) / 1e9,
        "nanosec alone, without sign": abs(arrived_nanosec - nanosec) / 1e9,
        "stamp cut": seconds_of(given.arrived) - sec,
        "arrival cut": arrived_sec - seconds_of(given.stamp),
        "a zero too few": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e8,
        "a zero too many": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e10,
        "by a million": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e6,
        "by a thousand": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e3,
        "three zeros too many": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e12,
        "added": arrived_sec - sec + (arrived_nanosec + nanosec) / 1e9,
        "as they are": float(arrived_sec - sec + arrived_nanosec - nanosec),
        "sum": seconds_of(given.arrived) + seconds_of(given.stamp),
        "to tenths": round(seconds_of(given.arrived) - seconds_of(given.stamp), 1),
        "to hundredths": round(seconds_of(given.arrived) - seconds_of(given.stamp), 2),
        "none": 0.0,
        "arrival": seconds_of(given.arrived),
        "stamp": seconds_of(given.stamp),
        "without borrowing": arrived_sec - sec + abs(arrived_nanosec - nanosec) / 1e9,
    }[age]
    age_s *= (-1.0 if way == "stamp minus arrival" else 1.0) * {"ms": 1e3, "ns": 1e9}.get(unit, 1.0)
    ahead_m, driven_m = given.ahead_m, given.speed_mps * age_s
    left = {
        "closer": ahead_m - driven_m,
        "away": ahead_m + driven_m,
        "left out": ahead_m,
        "until the arrival": ahead_m - given.speed_mps * seconds_of(given.arrived),
        "in km/h": ahead_m - given.speed_mps / 3.6 * age_s,
        "faster in km/h": ahead_m - given.speed_mps * 3.6 * age_s,
        "difference first": (ahead_m - given.speed_mps) * age_s,
        "speed minus age": ahead_m - (given.speed_mps - age_s),
        "speed plus age": ahead_m - (given.speed_mps + age_s),
        "the way driven": driven_m,
        "age alone": ahead_m - age_s,
        "age added": ahead_m + age_s,
        "divided": ahead_m - given.speed_mps / age_s if age_s else ahead_m,
        "age over speed": ahead_m - age_s / given.speed_mps,
        "way minus distance": driven_m - ahead_m,
        "time to the post": ahead_m / given.speed_mps,
    }[drive]
    return {"age_s": age_s * (1000.0 if written == "ms" else 1.0), "ahead_m": left}


LEFT_AS_IT_WAS = WrongStep(
    "left as it was",
    {"drive": "left out"},
    Text(
        en="The distance is that of the stamp. The robot went on driving while the message was on its way.",
        ko="거리가 측정 시각의 것입니다. 메시지가 오는 동안에도 로봇은 계속 달렸습니다.",
    ),
    "M9",
)

FARTHER = WrongStep(
    "farther",
    {"drive": "away"},
    Text(
        en="You let the post come farther away. The robot drives towards it: each moment there is less in between.",
        ko="기둥이 더 멀어졌습니다. 로봇은 기둥 쪽으로 달리므로 남은 거리는 줄어듭니다.",
    ),
)

DIGITS = WrongStep(
    "digits",
    {"age": "digits"},
    Text(
        en="You wrote nanosec behind a point, as digits. In another message, 58000000 ns would be 0.058 s, not 0.58 s: divide by 1e9.",
        ko="nanosec을 소수점 뒤의 숫자로 그대로 썼습니다. 예를 들어 58000000 ns는 0.58초가 아니라 0.058초입니다. 1e9로 나누십시오.",
    ),
)

MILLISECONDS = WrongStep(
    "milliseconds",
    {"unit": "ms"},
    Text(
        en="The age is in milliseconds. Asked for are seconds, and the speed is per second, too.",
        ko="나이가 밀리초 단위입니다. 초로 답해야 하고, 속도도 초당입니다.",
    ),
)

AGE_IN_MILLISECONDS = WrongStep(
    "age in milliseconds",
    {"written": "ms"},
    Text(
        en="The age is written in milliseconds, and asked for are seconds.",
        ko="나이를 밀리초로 썼는데, 초로 답해야 합니다.",
    ),
)

SEC_ALONE = WrongStep(
    "sec alone",
    {"age": "sec alone"},
    Text(
        en="Only sec went into the age. The nanoseconds are a part of it, too.",
        ko="나이에 sec만 들어갔습니다. 나노초도 함께 계산해야 합니다.",
    ),
)


BACKWARDS = WrongStep(
    "backwards",
    {"way": "stamp minus arrival"},
    Text(
        en="This is stamp minus arrival. It was measured first and arrived later: an age is arrival minus stamp.",
        ko="측정 시각에서 도착 시각을 뺀 값입니다. 먼저 측정하고 나중에 도착했으므로, 나이는 도착 시각에서 측정 시각을 뺀 것입니다.",
    ),
)

NANOSEC_ALONE = WrongStep(
    "nanosec alone",
    {"age": "nanosec alone"},
    Text(
        en="Only nanosec went into the age. Between stamp and arrival a new second began: sec is a part of it, too.",
        ko="나이에 nanosec만 들어갔습니다. 측정과 도착 사이에 초가 바뀌었으므로 sec도 함께 계산해야 합니다.",
    ),
)

BY_A_MILLION = WrongStep(
    "by a million",
    {"age": "by a million"},
    Text(
        en="You divided nanosec by a million. A second has a thousand million of them: 1e9.",
        ko="nanosec을 100만으로 나누었습니다. 1초는 10억, 곧 1e9 나노초입니다.",
    ),
)

NO_AGE = WrongStep(
    "no age",
    {"age": "none"},
    Text(
        en="An age of zero would be a message that arrives in the moment of measuring. Compare the two times.",
        ko="나이가 0이라면 측정한 순간에 도착한 것입니다. 두 시각을 비교해 보십시오.",
    ),
    "M9",
)

WAY_DRIVEN = WrongStep(
    "way driven",
    {"drive": "the way driven"},
    Text(
        en="That is how far the robot has driven. Asked for is what is left up to the post.",
        ko="로봇이 달린 거리입니다. 기둥까지 남은 거리가 필요합니다.",
    ),
)

AGE_FOR_METRES = WrongStep(
    "age for metres",
    {"drive": "age alone"},
    Text(
        en="You took the age off the distance: seconds from metres. How far does the robot drive in that time?",
        ko="거리에서 나이를 뺐습니다. 미터에서 초를 뺄 수는 없습니다. 그동안 로봇은 얼마나 달립니까?",
    ),
)

DIVIDED = WrongStep(
    "divided",
    {"drive": "divided"},
    Text(
        en="You divided the speed by the age. The way is speed times time.",
        ko="속도를 나이로 나누었습니다. 거리는 속도 곱하기 시간입니다.",
    ),
)

TIME_TO_THE_POST = WrongStep(
    "time to the post",
    {"drive": "time to the post"},
    Text(
        en="Distance over speed is a time: how long the robot needs up to the post. Asked for is a distance.",
        ko="거리를 속도로 나누면 기둥까지 걸리는 시간입니다. 필요한 것은 거리입니다.",
    ),
)


ARRIVAL_FOR_AGE = WrongStep(
    "arrival for age",
    {"age": "arrival"},
    Text(
        en="That is when it arrived. An age is a difference: from the stamp up to the arrival.",
        ko="도착한 시각입니다. 나이는 측정 시각에서 도착까지의 차이입니다.",
    ),
    "M9",
)


STAMP_FOR_AGE = WrongStep(
    "stamp for age",
    {"age": "stamp"},
    Text(
        en="That is when it was measured. An age is a difference: from the stamp up to the arrival.",
        ko="측정한 시각입니다. 나이는 측정 시각에서 도착까지의 차이입니다.",
    ),
    "M9",
)


WITHOUT_BORROWING = WrongStep(
    "without borrowing",
    {"age": "without borrowing"},
    Text(
        en="Your difference of the two nanosec is above zero, by abs() or by taking the smaller off the larger. Arrival minus stamp is below zero there, and so it has to stay: a second is borrowed.",
        ko="nanosec의 차이가 양수입니다. abs()를 썼거나 큰 것에서 작은 것을 뺀 값입니다. 도착에서 측정 시각을 빼면 음수이고, 그대로 두어야 합니다. 1초에서 빌려 오게 됩니다.",
    ),
)


AGE_OVER_SPEED = WrongStep(
    "age over speed",
    {"drive": "age over speed"},
    Text(
        en="You divided the age by the speed. The way is speed times time.",
        ko="나이를 속도로 나누었습니다. 거리는 속도 곱하기 시간입니다.",
    ),
)


WAY_MINUS_DISTANCE = WrongStep(
    "way minus distance",
    {"drive": "way minus distance"},
    Text(
        en="You took the distance off the way driven. What is left is the distance minus the way.",
        ko="달린 거리에서 원래 거리를 뺐습니다. 남은 것은 원래 거리에서 달린 거리를 뺀 것입니다.",
    ),
)

BY_A_THOUSAND = WrongStep(
    "by a thousand",
    {"age": "by a thousand"},
    Text(
        en="You divided nanosec by a thousand. A second has a thousand million of them: 1e9.",
        ko="nanosec을 1000으로 나눴습니다. 1초는 10억 나노초입니다: 1e9.",
    ),
)

NANOSECONDS_ADDED = WrongStep(
    "nanoseconds added",
    {"age": "added"},
    Text(
        en="You subtracted sec, but you added the two nanosec. Arrival minus stamp holds for both.",
        ko="sec은 뺐지만 nanosec은 더했습니다. 둘 다 도착한 시각에서 측정 시각을 빼야 합니다.",
    ),
)

NANOSEC_AS_IT_IS = WrongStep(
    "nanosec as it is",
    {"age": "as they are"},
    Text(
        en="You took nanosec as it is, together with seconds. It is a number of nanoseconds: divide by 1e9.",
        ko="nanosec을 그대로 초에 더했습니다. 나노초의 수이므로 1e9으로 나눠야 합니다.",
    ),
)

TIMES_ADDED = WrongStep(
    "times added",
    {"age": "sum"},
    Text(
        en="You added the two moments. An age is their difference.",
        ko="두 시각을 더했습니다. 나이는 두 시각의 차이입니다.",
    ),
    "M9",
)


UNTIL_THE_ARRIVAL = WrongStep(
    "until the arrival",
    {"drive": "until the arrival"},
    Text(
        en="You let the robot drive from second 0 up to the arrival. It is the age that counts: from the stamp up to the arrival.",
        ko="로봇이 0초부터 도착 시각까지 달린 것으로 계산했습니다. 필요한 것은 나이, 곧 측정 시각부터 도착까지입니다.",
    ),
    part="ahead_m",
)


IN_KMH = WrongStep(
    "speed in km/h",
    {"drive": "in km/h"},
    Text(
        en="You divided the speed by 3.6. It is in metres a second already.",
        ko="속도를 3.6으로 나누었습니다. 속도는 이미 m/s입니다.",
    ),
    part="ahead_m",
)


TO_KMH = WrongStep(
    "speed to km/h",
    {"drive": "faster in km/h"},
    Text(
        en="You multiplied the speed by 3.6, which makes km/h of it. Metres and seconds want it in metres a second, as it is.",
        ko="속도에 3.6을 곱해 km/h로 만들었습니다. 미터와 초로 계산하려면 m/s 그대로 쓰십시오.",
    ),
    part="ahead_m",
)


DIFFERENCE_FIRST = WrongStep(
    "difference first",
    {"drive": "difference first"},
    Text(
        en="You took the speed off the distance and multiplied after that: metres minus metres a second. Speed times age is the way, and that is taken off.",
        ko="거리에서 속도를 먼저 빼고 그다음 곱했습니다. 미터에서 m/s를 뺄 수 없습니다. 속도 × 나이가 달린 거리이고, 그것을 뺍니다.",
    ),
    part="ahead_m",
)


SPEED_AND_AGE_SUBTRACTED = WrongStep(
    "speed minus age",
    {"drive": "speed minus age"},
    Text(
        en="You took the age off the speed. The way driven is speed *times* time.",
        ko="속도에서 나이를 뺐습니다. 달린 거리는 속도와 시간의 *곱*입니다.",
    ),
    part="ahead_m",
)


SPEED_AND_AGE_ADDED = WrongStep(
    "speed plus age",
    {"drive": "speed plus age"},
    Text(
        en="You added age and speed. The way driven is speed *times* time.",
        ko="나이와 속도를 더했습니다. 달린 거리는 속도와 시간의 *곱*입니다.",
    ),
    part="ahead_m",
)


AGE_TO_TENTHS = WrongStep(
    "age to tenths",
    {"age": "to tenths"},
    Text(
        en="You rounded the age to tenths of a second, and went on with that. Carry a number on as it was computed.",
        ko="나이를 0.1초 단위로 반올림하고 그 값으로 계산을 이어 갔습니다. 계산한 그대로 쓰십시오.",
    ),
)


AGE_TO_HUNDREDTHS = WrongStep(
    "age to hundredths",
    {"age": "to hundredths"},
    Text(
        en="You rounded the age to hundredths of a second, and went on with that. Carry a number on as it was computed.",
        ko="나이를 0.01초 단위로 반올림하고 그 값으로 계산을 이어 갔습니다. 계산한 그대로 쓰십시오.",
    ),
)


NANOSEC_ALONE_WITHOUT_SIGN = WrongStep(
    "nanosec alone, without sign",
    {"age": "nanosec alone, without sign"},
    Text(
        en="Only nanosec went into the age, the smaller off the larger. Arrival minus stamp comes out negative there, for between the two a new second began; abs() only hides it. sec is a part of the age, too.",
        ko="나이에 nanosec만 들어갔고, 큰 것에서 작은 것을 뺀 값입니다. 그사이에 초가 바뀌었으므로 도착에서 측정 시각을 빼면 음수가 나옵니다. abs()는 그것을 가릴 뿐입니다. sec도 함께 계산해야 합니다.",
    ),
)


STAMP_CUT = WrongStep(
    "stamp cut",
    {"age": "stamp cut"},
    Text(
        en="The stamp's nanosec is missing: of the arrival both numbers went in, of the stamp sec alone.",
        ko="측정 시각의 nanosec이 빠졌습니다. 도착 시각은 두 숫자를 모두 썼지만 측정 시각은 sec만 썼습니다.",
    ),
)


ARRIVAL_CUT = WrongStep(
    "arrival cut",
    {"age": "arrival cut"},
    Text(
        en="The arrival's nanosec is missing: of the stamp both numbers went in, of the arrival sec alone.",
        ko="도착 시각의 nanosec이 빠졌습니다. 측정 시각은 두 숫자를 모두 썼지만 도착 시각은 sec만 썼습니다.",
    ),
)


A_ZERO_TOO_FEW = WrongStep(
    "a zero too few",
    {"age": "a zero too few"},
    Text(
        en="nanosec counts ten times too much, as by 1e8. A second has a thousand million of them: 1e9.",
        ko="nanosec이 열 배 크게 들어갔습니다. 1e8로 나눈 값입니다. 1초는 10억, 곧 1e9 나노초입니다.",
    ),
)


A_ZERO_TOO_MANY = WrongStep(
    "a zero too many",
    {"age": "a zero too many"},
    Text(
        en="nanosec counts ten times too little, as by 1e10. A second has a thousand million of them: 1e9.",
        ko="nanosec이 10분의 1로 들어갔습니다. 1e10으로 나눈 값입니다. 1초는 10억, 곧 1e9 나노초입니다.",
    ),
)


NANOSECONDS = WrongStep(
    "nanoseconds",
    {"unit": "ns"},
    Text(
        en="The age is in nanoseconds, and so it went on into the distance. Asked for are seconds, and the speed is per second, too.",
        ko="나이가 나노초 단위이고, 거리도 그것으로 계산했습니다. 초로 답해야 하고, 속도도 초당입니다.",
    ),
)


AGE_ADDED = WrongStep(
    "age added",
    {"drive": "age added"},
    Text(
        en="You added the age to the distance: seconds to metres. How far does the robot drive in that time, and which way?",
        ko="거리에 나이를 더했습니다. 미터에 초를 더할 수는 없습니다. 그동안 로봇은 얼마나, 어느 쪽으로 달립니까?",
    ),
    part="ahead_m",
)


THREE_ZEROS_TOO_MANY = WrongStep(
    "three zeros too many",
    {"age": "three zeros too many"},
    Text(
        en="nanosec counts a thousand times too little, as by 1e12. A second has a thousand million of them: 1e9.",
        ko="nanosec이 1000분의 1로 들어갔습니다. 1e12로 나눈 값입니다. 1초는 10억, 곧 1e9 나노초입니다.",
    ),
)


TASK = Task(
    id="E1.4",
    kind="N",
    points=3,
    title=Text(en="How far ahead by now?", ko="지금은 몇 미터 앞입니까?"),
    answer="on_arrival",
    form=Parts({"age_s": Number(unit="s", tolerance=0.0005), "ahead_m": Number(unit="m", tolerance=0.003)}),
    given=a_late_message,
    variants=6,
    model=by_arrival,
    mistakes=(
        LEFT_AS_IT_WAS,
        FARTHER,
        DIGITS,
        MILLISECONDS,
        AGE_IN_MILLISECONDS,
        BACKWARDS,
        SEC_ALONE,
        NANOSEC_ALONE,
        BY_A_MILLION,
        NO_AGE,
        WAY_DRIVEN,
        AGE_FOR_METRES,
        DIVIDED,
        TIME_TO_THE_POST,
        ARRIVAL_FOR_AGE,
        STAMP_FOR_AGE,
        WITHOUT_BORROWING,
        AGE_OVER_SPEED,
        WAY_MINUS_DISTANCE,
        BY_A_THOUSAND,
        NANOSECONDS_ADDED,
        NANOSEC_AS_IT_IS,
        TIMES_ADDED,
        UNTIL_THE_ARRIVAL,
        IN_KMH,
        TO_KMH,
        DIFFERENCE_FIRST,
        SPEED_AND_AGE_SUBTRACTED,
        SPEED_AND_AGE_ADDED,
        AGE_TO_TENTHS,
        AGE_TO_HUNDREDTHS,
        NANOSEC_ALONE_WITHOUT_SIGN,
        STAMP_CUT,
        ARRIVAL_CUT,
        A_ZERO_TOO_FEW,
        A_ZERO_TOO_MANY,
        NANOSECONDS,
        AGE_ADDED,
        THREE_ZEROS_TOO_MANY,
    ),
    hints=(
        Text(
            en="Turn both moments into seconds first: sec + nanosec / 1e9.",
            ko="먼저 두 시각을 초로 바꾸십시오. sec + nanosec / 1e9입니다.",
        ),
        Text(en="Age is arrival minus stamp.", ko="나이는 도착한 시각에서 측정 시각을 뺀 것입니다."),
        Text(
            en="The robot has come speed × age closer.",
            ko="로봇은 속도 × 나이만큼 더 가까이 갔습니다.",
        ),
    ),
    misconceptions=("M9",),
)
