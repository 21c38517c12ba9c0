"""E9.4: Late, or wrong?"""

from __future__ import annotations

import numpy as np

from tflab.workbook.tasks import Choice, Draws, Parts, Task, Text, WrongAnswer

CAUSES = ("transforms arrive late", "laser clock is fast", "cannot be told from this")


REMEDIES = ("wait a little", "set the laser's clock", "ask chrony on both computers")


LATE, FAST, UNKNOWN = CAUSES


def arrivals(rng: Draws) -> dict:
    """Draw six seconds of three robots, each with another trouble; rows are (stamp, heard) [s]."""
    troubles = [CAUSES[i] for i in rng.permutation(3)]
    return {f"robot_{name}": one_robot(rng, trouble) for name, trouble in zip("abc", troubles, strict=True)}


def one_robot(rng: Draws, trouble: str) -> dict:
    stamps = round(float(rng.uniform(20.0, 60.0)), 1) + np.arange(6.0)
    scan = 0.105 + rng.uniform(0.0, 0.004, 6)
    odom = 0.004 + rng.uniform(0.0, 0.002, 6)
    if trouble == LATE:
        odom = odom + rng.uniform(0.18, 0.24) + rng.permutation(np.linspace(0.0, 0.25, 6))
    elif trouble == FAST:
        scan = scan - rng.uniform(0.32, 0.48)
    else:
        odom = odom + rng.uniform(0.28, 0.42)
    rows = {"scan": np.column_stack([stamps, stamps + scan]), "odom": np.column_stack([stamps, stamps + odom])}
    return {name: np.round(row, 3) for name, row in rows.items()}


def guess(given, cause_of) -> dict:
    """Return an answer in which each robot's cause is `cause_of(scan delays, odom delays)`."""
    answer = {}
    for name in "abc":
        heard = getattr(given, f"robot_{name}")
        scan, odom = (np.asarray(heard[topic])[:, 1] - np.asarray(heard[topic])[:, 0] for topic in ("scan", "odom"))
        cause = cause_of(scan, odom)
        answer[name], answer[f"{name} do"] = cause, REMEDIES[CAUSES.index(cause)]
    return answer


def always_late(given) -> dict:
    return guess(given, lambda scan, odom: LATE)


ALWAYS_LATE = WrongAnswer(
    "always late",
    always_late,
    misconception="M10",
    reply=Text(
        en="not all three are late. Subtract stamp from heard for each message first, and look at the sign and at how much the numbers tremble. If a loop wrote this: does each turn read its own robot's rows?",
        ko="셋 다 늦은 것은 아닙니다. 먼저 메시지마다 들은 시각에서 측정 시각을 빼고, 부호와 떨림을 보십시오. 반복문으로 구했다면 바퀴마다 그 로봇의 행을 읽습니까?",
    ),
)


def always_fast(given) -> dict:
    return guess(given, lambda scan, odom: FAST)


ALWAYS_A_CLOCK = WrongAnswer(
    "always a clock",
    always_fast,
    misconception="M10",
    reply=Text(
        en="not every gap is the laser's clock. A fast laser clock makes the delay of /scan too small: look at /scan of each robot first. If a loop wrote this: does each turn read its own robot's rows?",
        ko="모든 간격이 레이저 시계 탓은 아닙니다. 레이저 시계가 빠르면 /scan의 지연이 너무 작아집니다. 로봇마다 /scan부터 보십시오. 반복문으로 구했다면 바퀴마다 그 로봇의 행을 읽습니까?",
    ),
)


def no_tremble(given) -> dict:
    return guess(given, lambda scan, odom: FAST if scan.min() < 0 else LATE)


TREMBLE_OVERLOOKED = WrongAnswer(
    "tremble overlooked",
    no_tremble,
    misconception="M10",
    reply=Text(
        en="of the two robots without a negative delay, one trembles and one is smooth as glass: can a smooth delay only be a slow network? A clock that is slow by so much gives the same numbers.",
        ko="지연이 음수가 아닌 둘 가운데 하나는 떨리고 하나는 유리처럼 매끈합니다. 매끈한 지연이 느린 네트워크에서만 나올까요? 시계가 그만큼 느려도 숫자는 똑같습니다.",
    ),
)


def smooth_is_laser(given) -> dict:
    return guess(given, lambda scan, odom: LATE if np.ptp(odom) > 0.1 else FAST)


SMOOTH_MEANS_LASER = WrongAnswer(
    "smooth means laser",
    smooth_is_laser,
    misconception="M10",
    reply=Text(
        en="one robot's delay is smooth, but it is on /odom, and positive. Nothing is wrong with that laser's numbers.",
        ko="한 로봇의 지연은 매끈하지만 /odom 쪽이고 양수입니다. 그 레이저의 숫자에는 이상이 없습니다.",
    ),
)


def no_sign(given) -> dict:
    return guess(given, lambda scan, odom: LATE if np.ptp(odom) > 0.1 else UNKNOWN)


SIGN_OVERLOOKED = WrongAnswer(
    "sign overlooked",
    no_sign,
    misconception="M10",
    reply=Text(
        en="one robot hears its scans before they are measured: a clock does that, and no network. And were it the listener's clock, that robot's /odom would come out wrong by as much. What is its delay there? If you computed it: column 1 minus column 0, of the rows of /scan?",
        ko="한 로봇은 스캔을 측정하기도 전에 듣습니다. 네트워크로는 그럴 수 없으니 시계 탓입니다. 듣는 쪽의 시계가 틀렸다면 그 로봇의 /odom도 그만큼 어긋났을 것입니다. /odom의 지연은 얼마입니까? 계산했다면 /scan의 행에서 1열 빼기 0열로 했습니까?",
    ),
)


def tremble_not_trusted(given) -> dict:
    return guess(given, lambda scan, odom: FAST if scan.min() < 0 else UNKNOWN)


TREMBLE_NOT_TRUSTED = WrongAnswer(
    "tremble not trusted",
    tremble_not_trusted,
    misconception="M10",
    reply=Text(
        en="one robot's /odom trembles by a quarter of a second from message to message. A clock does not do that, a network does: so much can be told. If you computed it: from the rows of /odom, and is the bound a tenth of a second or so?",
        ko="한 로봇의 /odom은 메시지마다 4분의 1초씩 떨립니다. 시계는 그러지 않지만 네트워크는 그럽니다. 그만큼은 알 수 있습니다. 계산했다면 /odom의 행으로 했습니까? 기준은 0.1초쯤입니까?",
    ),
)


def always_open(given) -> dict:
    return guess(given, lambda scan, odom: UNKNOWN)


ALWAYS_OPEN = WrongAnswer(
    "always open",
    always_open,
    misconception="M10",
    reply=Text(
        en="you leave all three open. Of two of them the numbers do tell it: one hears its scans before their stamps while its /odom comes as it should, and the /odom of another trembles, which no clock does. If a loop wrote this: does each turn read its own robot's rows?",
        ko="셋 다 알 수 없다고 했습니다. 그 가운데 둘은 숫자로 알 수 있습니다. 하나는 /odom은 제대로 오는데 스캔을 측정 시각보다 먼저 듣고, 다른 하나는 /odom이 떨립니다. 시계는 그렇게 떨리지 않습니다. 반복문으로 구했다면 바퀴마다 그 로봇의 행을 읽습니까?",
    ),
)


def smooth_and_trembling_exchanged(given) -> dict:
    return guess(given, lambda scan, odom: FAST if scan.min() < 0 else UNKNOWN if np.ptp(odom) > 0.1 else LATE)


SMOOTH_AND_TREMBLING_EXCHANGED = WrongAnswer(
    "smooth and trembling exchanged",
    smooth_and_trembling_exchanged,
    misconception="M10",
    reply=Text(
        en="you call the smooth delay late and leave the trembling one open; it is the other way round. No clock trembles by a quarter of a second, so there it is the network; and what is the same each time, a clock may do as well.",
        ko="매끈한 지연을 늦은 것이라 하고 떨리는 지연은 알 수 없다고 했는데, 반대입니다. 시계는 4분의 1초씩 떨리지 않으므로 떨리면 네트워크입니다. 매번 똑같은 지연은 시계 때문일 수도 있습니다.",
    ),
)


def long_timeout(given) -> dict:
    def cause_of(scan, odom) -> str:
        return FAST if scan.min() < 0 else LATE if np.ptp(odom) > 0.1 else UNKNOWN

    answer = guess(given, cause_of)
    late = next(name for name in "abc" if answer[name] == LATE)
    return {**answer, f"{late} do": "set a timeout of 10 s"}


TEN_SECONDS_FOR_THE_LATE_ONE = WrongAnswer(
    "ten seconds for the late one",
    long_timeout,
    misconception="M10",
    reply=Text(
        en="the late robot is late by about a third of a second: whoever may wait ten will one day decide on data that is ten seconds old.",
        ko="늦은 로봇도 겨우 3분의 1초 늦습니다. 10초를 기다려도 되는 로봇은 언젠가 10초 묵은 데이터로 결정합니다.",
    ),
)


def turned_around(fast: str):
    """Return the answers of one who takes heard from stamp, and finds this for the laser that is fast."""

    def answer(given) -> dict:
        def cause_of(scan, odom) -> str:
            return FAST if max(scan) > 0 else fast

        return guess(given, cause_of)

    return answer


STAMP_MINUS_HEARD = WrongAnswer(
    "stamp minus heard",
    turned_around(UNKNOWN),
    misconception="M10",
    reply=Text(
        en="you call the laser's clock fast just where it is not, and not where it is: your subtraction is turned around, or your comparison. The delay is heard minus stamp; then what has come from the future is below zero.",
        ko="레이저 시계가 빠르지 않은 곳에서만 빠르다고 하고, 빠른 곳에서는 아니라고 합니다. 뺄셈이나 비교가 뒤집혔습니다. 지연은 들은 시각에서 측정 시각을 뺀 값이고, 그러면 미래에서 온 것이 음수가 됩니다.",
    ),
)


STAMP_MINUS_HEARD_AND_LATE = WrongAnswer(
    "stamp minus heard, and late",
    turned_around(LATE),
    misconception="M10",
    reply=Text(
        en="you call the one fast clock late, and the two others fast: your subtraction is turned around, or your comparison. The delay is heard minus stamp; then what has come from the future is below zero.",
        ko="빠른 시계 하나를 늦었다고 하고 나머지 둘을 빠르다고 했습니다. 뺄셈이나 비교가 뒤집혔습니다. 지연은 들은 시각에서 측정 시각을 뺀 값이고, 그러면 미래에서 온 것이 음수가 됩니다.",
    ),
)


TASK = Task(
    id="E9.4",
    kind="D",
    points=3,
    title=Text(en="Late, or wrong?", ko="늦은 것입니까, 틀린 것입니까?"),
    answer="causes",
    form=Parts(
        {
            **{name: Choice(CAUSES) for name in "abc"},
            **{f"{name} do": Choice((*REMEDIES, "set a timeout of 10 s")) for name in "abc"},
        }
    ),
    given=arrivals,
    variants=6,
    mistakes=(
        ALWAYS_LATE,
        TEN_SECONDS_FOR_THE_LATE_ONE,
        TREMBLE_OVERLOOKED,
        SMOOTH_MEANS_LASER,
        ALWAYS_A_CLOCK,
        SIGN_OVERLOOKED,
        TREMBLE_NOT_TRUSTED,
        ALWAYS_OPEN,
        SMOOTH_AND_TREMBLING_EXCHANGED,
        STAMP_MINUS_HEARD,
        STAMP_MINUS_HEARD_AND_LATE,
    ),
    hints=(
        Text(
            en="For each topic: heard minus stamp. Then look at three things: sign, size, tremble.",
            ko="토픽마다 들은 시각에서 측정 시각을 빼십시오. 그리고 부호, 크기, 떨림 세 가지를 보십시오.",
        ),
        Text(
            en="A healthy /scan is about 0.105 s, a healthy /odom about 0.005 s. Which topic of each robot is not healthy?",
            ko="정상인 /scan은 약 0.105초, 정상인 /odom은 약 0.005초입니다. 로봇마다 어느 토픽이 정상이 아닙니까?",
        ),
        Text(
            en="Negative: a clock, and you can say whose. Positive and trembling: the network. Positive and smooth: either, and one-way times cannot tell.",
            ko="음수면 시계이고, 누구의 시계인지 말할 수 있습니다. 양수이고 떨리면 네트워크입니다. 양수이고 매끈하면 둘 중 어느 쪽인지 한 방향 시각만으로는 알 수 없습니다.",
        ),
    ),
    misconceptions=("M10",),
    means={
        "transforms arrive late": Text(
            en="late transforms: the delays of /odom are large and tremble from message to message.",
            ko="변환이 늦으면 /odom의 지연이 크고 메시지마다 떨립니다.",
        ),
        "laser clock is fast": Text(
            en="a fast laser clock: the delays of /scan are too small, even negative, and /odom has nothing to do with it.",
            ko="레이저 시계가 빠르면 /scan의 지연이 너무 작아지고 음수까지 됩니다. /odom은 상관없습니다.",
        ),
        "cannot be told from this": Text(
            en="it cannot be told only where a delay is too large and smooth: a network or a clock may do that.",
            ko="지연이 너무 크고 매끈할 때만 구별할 수 없습니다. 네트워크도 시계도 그럴 수 있습니다.",
        ),
        "wait a little": Text(
            en="to wait a little cures what is on its way, nothing else: a wrong clock stays wrong meanwhile.",
            ko="조금 기다리는 것은 오는 중인 데이터에만 통합니다. 틀린 시계는 기다려도 그대로입니다.",
        ),
        "set the laser's clock": Text(
            en="the laser's clock is set only where the numbers show that it is the wrong one: where /scan comes too soon, and /odom as it should.",
            ko="레이저 시계는 그 시계가 틀렸다고 숫자가 보여 줄 때만 맞춥니다. /scan은 너무 일찍, /odom은 제대로 올 때입니다.",
        ),
        "ask chrony on both computers": Text(
            en="chrony is asked where the numbers leave it open: where a delay is too large, and the same each time.",
            ko="chrony는 숫자만으로 알 수 없을 때, 곧 지연이 너무 크면서 매번 똑같을 때 확인합니다.",
        ),
        "set a timeout of 10 s": Text(
            en="the gap is about a third of a second: whoever may wait ten seconds will decide on data that is ten seconds old.",
            ko="간격은 3분의 1초쯤입니다. 10초를 기다려도 되는 로봇은 10초 묵은 데이터로 결정합니다.",
        ),
    },
    seen={
        LATE: Text(
            en="Here /scan is heard as it should be, and /odom too late, by another amount each time.",
            ko="여기서는 /scan은 제대로 들리고, /odom은 매번 다른 만큼 늦습니다.",
        ),
        FAST: Text(
            en="Here /scan is heard before its stamp, which no network does, and /odom as it should be, which it would not be if the listener's clock were wrong.",
            ko="여기서는 /scan이 측정 시각보다 먼저 들립니다. 네트워크로는 그럴 수 없습니다. /odom은 제대로 들립니다. 듣는 쪽의 시계가 틀렸다면 그럴 수 없습니다.",
        ),
        UNKNOWN: Text(
            en="Here /scan is heard as it should be, and /odom a third of a second too late or so, by the same amount each time.",
            ko="여기서는 /scan은 제대로 들리고, /odom은 매번 같은 만큼, 3분의 1초쯤 늦습니다.",
        ),
        REMEDIES[0]: Text(
            en="Here what is late is on its way.",
            ko="여기서는 늦는 것이 오는 중입니다.",
        ),
        REMEDIES[1]: Text(
            en="Here the numbers leave nothing open: they show whose clock it is.",
            ko="여기서는 숫자만으로 누구의 시계인지 알 수 있습니다.",
        ),
        REMEDIES[2]: Text(
            en="Here the numbers fit a network, and a clock as well.",
            ko="여기서는 숫자가 네트워크에도 시계에도 들어맞습니다.",
        ),
    },
)
