"""E11.6: Read tf2_monitor by program."""

from __future__ import annotations

import re

from tflab.tools.tf2_monitor import Delays, NetDelay, broadcaster_line, frame_lines, results_heading
from tflab.workbook.tasks import Name, Number, Parts, Set, Task, Text, WrongStep

STATIC = ("base_link", "laser_frame", "camera_link", "imu_link", "mast")
MOVING = ("odom", "base_footprint", "arm_link", "pan_link", "left_wheel")
ON_THE_MAST = "mast_top"  # it moves, and the name of a frame that does not stands in its name


def reports(rng):
    """Robots with one late frame: some with stamps from the future, one on the wrong clock, one long running."""
    usual = [one_report(rng, future=number) for number in (0, 1, 2)]
    usual.append(one_report(rng, future=0, only="laser_frame"))  # elsewhere another may be as old
    far_ahead = one_report(rng, future=1, early_s=1.2)  # earlier than anybody is late
    wrong_clock = one_report(rng, future=0, late_s=1.6e9 + float(rng.uniform(0.0, 9e7)))
    long_running = one_report(rng, future=1, looks=2000)
    spiky = one_report(rng, future=0, spike=True)
    at_once = one_report(rng, future=1, second_s=0.0)  # neither late nor early
    ahead = one_report(rng, future=2, static_s=-round(float(rng.uniform(2.0, 5.0)), 1))  # mounts of a fast clock
    slow = one_report(rng, future=0, late_s=round(float(rng.uniform(10.5, 19.0)), 2))  # "4.2" comes after "14" as text
    restless = one_report(rng, future=2, once_s=0.1)  # ahead on average, and once late
    alike = one_report(rng, future=1, is_alike=True)
    return [*usual, far_ahead, wrong_clock, long_running, spiky, at_once, ahead, slow, restless, alike]


def one_report(rng, future, late_s=None, looks=21, spike=False, second_s=None, static_s=None, early_s=0.05, once_s=None, only="", is_alike=False):  # fmt: skip
    """Return a report's text and the names of the static frames."""
    statics = [STATIC[i] for i in rng.permutation(len(STATIC))[: int(rng.integers(1, 4))]]
    moving = [MOVING[i] for i in rng.permutation(len(MOVING))[: future + 2]]
    statics = [only] if only else statics
    if is_alike:
        statics, moving = ["mast", *[name for name in statics if name != "mast"]], [ON_THE_MAST, *moving[1:]]
    late_s = round(float(rng.uniform(0.15, 0.9)), 3) if late_s is None else late_s
    delays_s = [late_s, round(late_s * 0.3, 4) if late_s < 1e6 else late_s * 0.3]
    delays_s[1] = delays_s[1] if second_s is None else second_s
    delays_s += [-round(float(rng.uniform(early_s, early_s + 0.35)), 3) for _ in range(future)]
    delays, net = Delays(), NetDelay()
    for frame, delay_s in zip(moving, delays_s, strict=True):
        for number in range(10):
            delays.hear(50.0 + number, [(frame, 50.0 + number - delay_s)])
    if spike:  # the second is late on average, the first was once later
        delays.of_frame[moving[0]].extend([0.001] * 40)
    if once_s is not None:
        delays.of_frame[moving[-1]].append(once_s)
    static_s = round(float(rng.uniform(8.0, 60.0)), 1) if static_s is None else static_s
    for frame in statics:
        delays.hear(50.0, [(frame, 50.0 - static_s)])
    for _ in range(looks):
        net.add(late_s + 0.01)
    chain = ["map", *moving, *statics]
    rows = [results_heading(chain, net), "", "Frames:", *frame_lines(delays, chain)]
    return "\n".join([*rows, "", "All Broadcasters:", broadcaster_line(delays)]), sorted(statics)


def figures(
    report, static_frames, *, keep="moving", late="largest max", ahead="moving", sign="average", net="max",
):  # fmt: skip
    """Return the three figures, step by step; other steps are the slips."""
    rows = re.findall(r"Frame: (\S+), .*Average Delay: (\S+), Max Delay: (\S+)", report)
    texts = {frame: largest for frame, _, largest in rows}
    rows = every = [(frame, float(average), float(largest)) for frame, average, largest in rows]
    if keep == "not the laser":
        rows = [row for row in rows if row[0] != "laser_frame"]
    if keep == "static":
        rows = [row for row in rows if row[0] in static_frames]
    if keep == "moving":
        rows = [row for row in rows if row[0] not in static_frames]
    if keep == "no static within":
        rows = [row for row in rows if not any(name in row[0] for name in static_frames)]
    by = {
        "largest max": lambda row: row[2], "largest average": lambda row: row[1], "smallest": lambda row: -row[2],
        "largest size": lambda row: abs(row[1]), "first": lambda row: -rows.index(row), "last": rows.index, "text": lambda row: texts[row[0]],
        "digits": lambda row: float(texts[row[0]].partition("e")[0]),
        "static": lambda row: (row[0] in static_frames, row[2]),
    }[late]  # fmt: skip
    below = {
        "average": lambda row: row[1] < 0, "max": lambda row: row[2] < 0, "max is 0": lambda row: row[2] <= 0,
        "average is 0": lambda row: row[1] <= 0, "positive": lambda row: row[1] > 0,
        "first": lambda row: row[1] < 0, "all": lambda row: True, "earliest": lambda row: row[1] < 0,
    }[sign]  # fmt: skip
    early = sorted(row[0] for row in (every if ahead == "all" else rows) if below(row))
    if sign == "earliest":
        early = [min(rows, key=lambda row: row[1])[0]]
    found = re.search(r"avg = (\S+): max = (\S+)", report).groups()
    worst = max(every if late == "static" else rows, key=by)
    of_frames = {
        "frame": worst[2], "largest frame": max(row[2] for row in every), "sum": sum(row[2] for row in rows),
        "sum of all": sum(row[2] for row in every), "average of a frame": worst[1],
        "digits": float(found[1].partition("e")[0]),
    }  # fmt: skip
    return {
        "late": worst[0],
        "future": early[: 1 if sign == "first" else None],
        "delay_s": of_frames.get(net, float(found[net != "avg"])),
    }


STATIC_WINS = WrongStep(
    "static wins",
    {"keep": "all"},
    Text(
        en="late: a static frame wins. It was sent once; its age is no delay: leave static_frames out.",
        ko="late: 정적 좌표계가 뽑혔습니다. 한 번만 보냈으므로 나이는 지연이 아닙니다. static_frames를 빼십시오.",
    ),
    "M12",
    part="late",
)

LATE_ON_AVERAGE = WrongStep(
    "late on average",
    {"late": "largest average"},
    Text(
        en="late: you compare Average Delay. Asked is who was latest at worst: Max Delay.",
        ko="late: Average Delay를 비교합니다. 최악의 경우 가장 늦은 좌표계, 곧 Max Delay를 물었습니다.",
    ),
    part="late",
)

THE_QUICKEST = WrongStep(
    "the quickest",
    {"late": "smallest"},
    Text(en="late: that is the one that comes soonest.", ko="late: 가장 빨리 오는 좌표계입니다."),
    part="late",
)

MAX_ZERO_IS_HEALTHY = WrongStep(
    "max zero is healthy",
    {"sign": "max"},
    Text(
        en="future: you find nobody in any report. Max Delay is never below 0: which figure of the line is, and do you read its minus?",
        ko="future: 어느 보고에서도 아무도 찾지 못합니다. Max Delay는 0보다 작아지지 않습니다. 0보다 작아지는 숫자는 무엇이고, 마이너스까지 읽습니까?",
    ),
    "M10",
    part="future",
)

LATE_FOR_FUTURE = WrongStep(
    "late for future",
    {"sign": "positive"},
    Text(
        en="future: a positive delay is a stamp of the past. The future has the other sign.",
        ko="future: 지연이 양수면 과거의 시각입니다. 미래는 부호가 반대입니다.",
    ),
    "M10",
    part="future",
)

ZERO_IS_FUTURE = WrongStep(
    "zero is future",
    {"sign": "average is 0"},
    Text(
        en="future: an Average Delay of 0 counts as the future for you, too. A stamp that is just as new as the clock is neither late nor early.",
        ko="future: Average Delay가 0일 때도 미래로 셉니다. 측정 시각이 시계와 똑같으면 늦은 것도 이른 것도 아닙니다.",
    ),
    "M10",
    part="future",
)

MAX_FOR_AVERAGE = WrongStep(
    "max for average",
    {"sign": "max is 0"},
    Text(
        en="future: you name the frames whose Max Delay is 0. That one begins at 0 and never falls below: it says 0 of a frame that is just in time, and more of one that is ahead on average and was late once. Asked is for the average: which figure of the line is it?",
        ko="future: Max Delay가 0인 좌표계를 답합니다. Max Delay는 0에서 시작해 더 작아지지 않습니다. 꼭 맞게 온 좌표계도 0이고, 평균은 0보다 작아도 한 번 늦었다면 0보다 큽니다. 여기서 볼 것은 평균입니다. 줄에서 어느 숫자입니까?",
    ),
    "M10",
    part="future",
)

ONE_IS_ENOUGH = WrongStep(
    "one is enough",
    {"sign": "first"},
    Text(
        en="future: you return one frame at most. There may be several.",
        ko="future: 많아야 하나를 반환합니다. 여럿일 수 있습니다.",
    ),
    part="future",
)

LARGEST_SIZE = WrongStep(
    "largest size",
    {"late": "largest size"},
    Text(
        en="late: you compare averages by their size. A stamp far ahead of the clock is the opposite of late.",
        ko="late: 평균을 크기로만 비교합니다. 측정 시각이 현재보다 훨씬 미래인 것은 늦은 것의 반대입니다.",
    ),
    "M10",
    part="late",
)

STATIC_AHEAD = WrongStep(
    "static ahead",
    {"ahead": "all"},
    Text(
        en="future: you name frames that do not move. Theirs is the age of one message: leave static_frames out here, too.",
        ko="future: 움직이지 않는 좌표계도 들어 있습니다. 그것은 메시지 하나의 나이입니다. 여기서도 static_frames를 빼십시오.",
    ),
    "M12",
    part="future",
)

EARLIEST_ALONE = WrongStep(
    "earliest alone",
    {"sign": "earliest"},
    Text(
        en="future: you always name the one with the smallest average. There may be none in the future, and there may be several.",
        ko="future: 평균이 가장 작은 하나를 언제나 답합니다. 미래인 것은 없을 수도, 여럿일 수도 있습니다.",
    ),
    "M10",
    part="future",
)

SUM_OF_DELAYS = WrongStep(
    "sum of delays",
    {"net": "sum"},
    Text(
        en="delay_s: you added up what the frames say. Each of them comes by itself: the chain's own figure stands in the line Net delay.",
        ko="delay_s: 좌표계들의 값을 더했습니다. 좌표계는 저마다 따로 옵니다. 사슬의 값은 Net delay 줄에 있습니다.",
    ),
    part="delay_s",
)

SUM_OF_ALL = WrongStep(
    "sum of all delays",
    {"net": "sum of all"},
    Text(
        en="delay_s: you added up what all frames say, static ones with them. Each comes by itself; the chain's own figure stands in the line Net delay.",
        ko="delay_s: 정적 좌표계까지 모두 더했습니다. 저마다 따로 옵니다. 사슬의 값은 Net delay 줄에 있습니다.",
    ),
    "M12",
    part="delay_s",
)

NET_AVERAGE = WrongStep(
    "net average",
    {"net": "avg"},
    Text(
        en="delay_s: that is avg, which begins at 0 and takes minutes. Read the other one.",
        ko="delay_s: 0에서 시작해 몇 분이 걸려야 맞는 avg입니다. 다른 값을 읽으십시오.",
    ),
    part="delay_s",
)

AVERAGE_OF_A_FRAME = WrongStep(
    "average of a frame",
    {"net": "average of a frame"},
    Text(
        en="delay_s: that is one frame's Average Delay. Asked is for the chain, and for its worst: the line Net delay has both.",
        ko="delay_s: 한 좌표계의 Average Delay입니다. 구할 것은 사슬 전체에서 가장 많이 늦은 값이고, Net delay 줄에 있습니다.",
    ),
    part="delay_s",
)

DELAY_OF_A_FRAME = WrongStep(
    "delay of a frame",
    {"net": "frame"},
    Text(
        en="delay_s: that is one frame's. The chain's stands in the line Net delay.",
        ko="delay_s: 한 좌표계의 값입니다. 사슬의 값은 Net delay 줄에 있습니다.",
    ),
    part="delay_s",
)

EXPONENTS_LOST = WrongStep(
    "exponents lost",
    {"late": "digits", "net": "digits"},
    Text(
        en="What is very large is written with an exponent, as in 2.5e+03, which is 2500. You read the digits before the e, and leave the rest: then 4.5e+02 counts as more than 1.5e+03. `float` reads the whole of it.",
        ko="아주 큰 값은 2.5e+03(2500)처럼 지수로 적힙니다. e 앞의 숫자만 읽고 나머지를 버렸습니다. 그러면 4.5e+02가 1.5e+03보다 크다고 나옵니다. `float`는 전체를 읽습니다.",
    ),
)

EXPONENT_LOST_OF_FRAMES = WrongStep(
    "exponent lost of frames",
    {"late": "digits"},
    Text(
        en="late: what is very large is written with an exponent, as in 2.5e+03, which is 2500. You compare the digits before the e alone: then 4.5e+02 counts as more than 1.5e+03.",
        ko="late: 아주 큰 값은 2.5e+03(2500)처럼 지수로 적힙니다. e 앞의 숫자만 비교하고 있습니다. 그러면 4.5e+02가 1.5e+03보다 크다고 나옵니다.",
    ),
    part="late",
)

EXPONENT_LOST = WrongStep(
    "exponent lost",
    {"net": "digits"},
    Text(
        en="delay_s: a long delay is written with an exponent, as in 2.5e+03. You read the digits before the e, and leave the rest.",
        ko="delay_s: 아주 긴 지연은 2.5e+03처럼 지수로 적힙니다. e 앞의 숫자만 읽고 나머지를 버렸습니다.",
    ),
    part="delay_s",
)

FIRST_ROW = WrongStep(
    "first row",
    {"late": "first"},
    Text(
        en="late: that is the first frame of the report. Compare their Max Delay.",
        ko="late: 보고의 첫 좌표계입니다. Max Delay를 비교하십시오.",
    ),
    part="late",
)

LAST_ROW = WrongStep(
    "last row",
    {"late": "last"},
    Text(
        en="late: that is the last frame of the report. Compare their Max Delay.",
        ko="late: 보고의 마지막 좌표계입니다. Max Delay를 비교하십시오.",
    ),
    part="late",
)

STATICS_ALONE = WrongStep(
    "statics alone",
    {"late": "static"},
    Text(
        en="late: you compare just those that do not move. The list names what is to be left out.",
        ko="late: 움직이지 않는 것끼리만 비교합니다. 목록에 있는 것은 빼야 합니다.",
    ),
    "M12",
    part="late",
)

COMPARED_AS_TEXT = WrongStep(
    "compared as text",
    {"late": "text"},
    Text(
        en='late: you compare Max Delay as text, letter by letter: there "9.1" comes after "10.2", and "4e+08" after "1e+09". Turn them into numbers first: `float(...)`.',
        ko='late: Max Delay를 문자열로 비교하여 글자 하나씩 견줍니다. 그러면 "9.1"이 "10.2"보다, "4e+08"이 "1e+09"보다 큽니다. 먼저 `float(...)`로 숫자로 바꾸십시오.',
    ),
    part="late",
)

ALL_THAT_MOVE = WrongStep(
    "all that move",
    {"sign": "all"},
    Text(
        en="future: these are all that move. Which of them have stamps ahead of the clock?",
        ko="future: 움직이는 것 모두입니다. 그 가운데 측정 시각이 현재보다 미래인 것은 무엇입니까?",
    ),
    "M10",
    part="future",
)

LARGEST_OF_ALL = WrongStep(
    "largest of all",
    {"net": "largest frame"},
    Text(
        en="delay_s: that is the largest Max Delay of any frame, static ones with it. The chain's stands in the line Net delay.",
        ko="delay_s: 정적 좌표계까지 포함한 Max Delay의 최댓값입니다. 사슬의 값은 Net delay 줄에 있습니다.",
    ),
    "M12",
    part="delay_s",
)

ONLY_THE_LASER = WrongStep(
    "only the laser left out",
    {"keep": "not the laser"},
    Text(
        en="You leave out laser_frame alone. The second argument names all that hang on static transforms.",
        ko="laser_frame만 뺐습니다. 정적 변환에 이어진 것은 모두 둘째 인자에 있습니다.",
    ),
    "M12",
)

ONLY_STATICS = WrongStep(
    "only statics",
    {"keep": "static"},
    Text(
        en="You keep just those that do not move, for who is late and for who is ahead: is there an `in` where `not in` is meant? The second argument names what is to be left out.",
        ko="누가 늦는지도, 누구의 측정 시각이 미래인지도 움직이지 않는 것 가운데서만 찾습니다. `not in`을 쓸 곳에 `in`을 썼습니까? 둘째 인자에 있는 것은 빼야 합니다.",
    ),
    "M12",
)


LEFT_OUT_BY_A_PART = WrongStep(
    "left out by a part of the name",
    {"keep": "no static within"},
    Text(
        en="You leave out a frame as soon as the name of a static one stands in its own, as `mast` does in `mast_top`. Names are compared whole: `name in static_frames`.",
        ko="이름 안에 정적 좌표계의 이름이 들어 있으면 뺍니다. `mast`가 `mast_top`에 들어 있듯이 말입니다. 이름은 통째로 비교하십시오: `name in static_frames`.",
    ),
    "M14",
)


TASK = Task(
    id="E11.6",
    kind="F",
    points=4,
    title=Text(en="Read tf2_monitor by program", ko="프로그램으로 tf2_monitor 읽기"),
    answer="read_monitor",
    form=Parts({"late": Name(), "future": Set(Name()), "delay_s": Number("s", tolerance=1e-4)}),
    inputs=reports,
    variants=3,
    model=figures,
    mistakes=(
        STATIC_WINS,
        LATE_ON_AVERAGE,
        THE_QUICKEST,
        MAX_ZERO_IS_HEALTHY,
        LATE_FOR_FUTURE,
        ZERO_IS_FUTURE,
        MAX_FOR_AVERAGE,
        ONE_IS_ENOUGH,
        NET_AVERAGE,
        DELAY_OF_A_FRAME,
        AVERAGE_OF_A_FRAME,
        EXPONENTS_LOST,
        EXPONENT_LOST_OF_FRAMES,
        EXPONENT_LOST,
        FIRST_ROW,
        LAST_ROW,
        STATICS_ALONE,
        COMPARED_AS_TEXT,
        ALL_THAT_MOVE,
        LARGEST_OF_ALL,
        LARGEST_SIZE,
        STATIC_AHEAD,
        EARLIEST_ALONE,
        SUM_OF_DELAYS,
        SUM_OF_ALL,
        ONLY_THE_LASER,
        ONLY_STATICS,
        LEFT_OUT_BY_A_PART,
    ),
    hints=(
        Text(
            en="Go through the lines that begin with `Frame: `, and take out name, Average Delay and Max Delay.",
            ko="`Frame: `으로 시작하는 줄에서 이름, Average Delay, Max Delay를 꺼내 보세요.",
        ),
        Text(
            en="Leave the static frames out. Largest Max Delay: late. Average Delay below 0: future.",
            ko="정적 좌표계를 뺍니다. Max Delay가 가장 크면 late, Average Delay가 0보다 작으면 future입니다.",
        ),
        Text(
            en='`line.split(", ")` gives the parts of a line, and `part.split(": ")[1]` what stands behind the colon; `float` reads 1.6e+09 too.',
            ko='`line.split(", ")`로 줄을 나누고 `part.split(": ")[1]`로 콜론 뒤를 꺼냅니다. `float`는 1.6e+09도 읽습니다.',
        ),
    ),
    misconceptions=("M10", "M12"),
)
