"""E11.3: Often enough?"""

from __future__ import annotations

import math
import re

from tflab.tools.tf2_monitor import Delays, NetDelay, broadcaster_line, frame_lines, results_heading
from tflab.workbook.tasks import Choice, Number, Parts, Task, Text, WrongAnswer, WrongStep

LOOKS = 21


def a_slow_robot(rng):
    """Other nodes' rates, everybody's together, a first report, a bend, and what is allowed: enough or not, by turns."""
    others = {"robot_state_publisher": float(rng.choice((15.0, 20.0, 25.0))), "localization": 10.0}
    rate = float(rng.choice((2.0, 2.5, 3.0, 4.0)))
    v = w = 0.0
    while 1000 * v * w**3 / (24 * rate**4) < 0.08:  # until a cosine differs from its first terms, by this [mm]
        v, w = round(float(rng.uniform(0.5, 1.2)), 2), round(float(rng.uniform(0.5, 1.2)), 2)
    chord_mm = 1000 * v / w * (1 - math.cos(w / (2 * rate)))
    share = float(rng.choice((0.6, 1.6)))
    travel_s = round(float(rng.uniform(0.004, 0.020)), 3)
    late_s = round(1 / rate + travel_s + float(rng.uniform(0.02, 0.05)), 3)  # one message came later than its turn
    return {
        "sends_hz": others,
        "hz_of_tf": sum(others.values()) + rate,
        "report": report_of(late_s, travel_s, round(float(rng.uniform(8.0, 30.0)), 1)),
        "speed_mps": v,
        "yaw_rate_radps": w,
        "allowed_mm": max(0.1, round(chord_mm * share, 1)),
        "transform_travels_s": travel_s,
        "scan_travels_s": 0.105,
    }


def report_of(late_s, travel_s, static_s):
    """Return a first report, as tf2_monitor writes it."""
    net, delays = NetDelay(), Delays()
    for _ in range(LOOKS):
        net.add(late_s)
    delays.hear(static_s, [("laser_frame", 0.0)])
    for number in range(100):
        delays.hear(static_s + 0.1 * number, [("base_footprint", static_s + 0.1 * number - travel_s)])
        delays.hear(static_s + 0.1 * number, [("odom", static_s + 0.1 * number - 0.01)])
    chain = ("map", "odom", "base_footprint", "laser_frame")
    rows = [results_heading(chain, net).strip("\n"), "", "Frames:", *frame_lines(delays, chain)]
    return "\n".join([*rows, "", "All Broadcasters:", broadcaster_line(delays)])


def judged(given, *, rate="the rest", late="max", curve="chord", period="whole", travel="with the scan"):
    """Return the five answers, step by step; other steps are the slips."""
    f = {
        "the rest": given.hz_of_tf - sum(given.sends_hz.values()),
        "everybody": given.hz_of_tf,
        "shared": given.hz_of_tf / (len(given.sends_hz) + 1),
        "localization's": given.sends_hz["localization"],
        "without localization": given.hz_of_tf - given.sends_hz["robot_state_publisher"],
        "without the state publisher": given.hz_of_tf - given.sends_hz["localization"],
        "the report's": float(re.search(r"([\d.]+) Hz", given.report)[1]),
    }[rate]
    avg, largest = map(float, re.search(r"avg = (\S+): max = (\S+)", given.report).groups())
    static = float(re.search(r"laser_frame,.*Average Delay: (\S+),", given.report)[1])
    of_the_report = {
        "max": largest,
        "avg": avg,
        "static": static,
        "without its way": largest - given.transform_travels_s,
    }
    v, w = given.speed_mps, given.yaw_rate_radps
    gap = {
        "chord": v / w * (1 - math.cos(w / (2 * f))),
        "way": v / f,
        "half way": v / (2 * f),
        "whole angle": v / w * (1 - math.cos(w / f)),
        "angle in degrees": v / w * (1 - math.cos(math.degrees(w / (2 * f)))),
        "straight": 0.0,
        "way while late": v * largest,
        "half the square": v * w / (2 * f**2),
        "product": v * w * (1 - math.cos(w / (2 * f))),
        "radius": v / w,
        "chord itself": 2 * v / w * math.sin(w / (2 * f)),
        "sideways": v / w * math.sin(w / (2 * f)),
    }[curve]
    way = {
        "with the scan": given.transform_travels_s - given.scan_travels_s,
        "without the scan": given.transform_travels_s,
        "scan added": given.transform_travels_s + given.scan_travels_s,
        "the scan's alone": given.scan_travels_s,
        "the other way": given.scan_travels_s - given.transform_travels_s,
        "both taken off": -given.transform_travels_s - given.scan_travels_s,
        "without the transform": -given.scan_travels_s,
    }.get(travel, 0.0)
    if travel == "lateness without the scan":
        way = largest - given.scan_travels_s - 1 / f
    wait = {"whole": 1.0, "half": 0.5, "none": 0.0}[period] / f + way
    return {
        "odometry_hz": f,
        "late_s": of_the_report[late],
        "off_mm": 1000 * gap,
        "wait_s": wait if period == "none" else max(0.0, wait),
        "enough": "yes" if 1000 * gap <= given.allowed_mm else "no",
    }


SUM_OF_TF = WrongStep(
    "sum of tf",
    {"rate": "everybody"},
    Text(
        en="That is what everybody on /tf sends together. What is left if you take the other nodes' messages away?",
        ko="/tf에서 모두가 보내는 것을 합친 값입니다. 다른 노드의 메시지를 빼면 얼마가 남습니까?",
    ),
    part="odometry_hz",
)

SHARED_EVENLY = WrongStep(
    "shared evenly",
    {"rate": "shared"},
    Text(
        en="You shared /tf evenly among the nodes. Nobody promised that: two of their rates are on the card.",
        ko="/tf를 노드 수로 똑같이 나누었습니다. 그런 약속은 없습니다. 두 노드의 발행률은 카드에 있습니다.",
    ),
    part="odometry_hz",
)

ONE_LEFT_IN = WrongStep(
    "one left in",
    {"rate": "without localization"},
    Text(en="You took one other node away; there are two.", ko="다른 노드 하나만 뺐습니다. 둘입니다."),
    part="odometry_hz",
)

ANOTHER_NODES = WrongStep(
    "another node's",
    {"rate": "localization's"},
    Text(
        en="That is how often localization sends, by the card. Asked is the node that is not on the card.",
        ko="카드에 적힌 localization의 발행률입니다. 카드에 없는 노드를 물었습니다.",
    ),
    part="odometry_hz",
)

THE_REPORT_S = WrongStep(
    "the report's",
    {"rate": "the report's"},
    Text(
        en="That is the Hz in the report's last line, which counts all broadcasters together. Asked is what odometry alone sends.",
        ko="보고의 마지막 줄에 있는 Hz이고, 발행하는 노드를 모두 합쳐 센 값입니다. 오도메트리만의 발행률을 물었습니다.",
    ),
    part="odometry_hz",
)

AVERAGE_BELIEVED = WrongStep(
    "average believed",
    {"late": "avg"},
    Text(
        en="That is avg, in a first report: it began at 0 and has come 19 % of the way.",
        ko="첫 보고의 avg입니다. 0에서 시작해 19 %까지 왔을 뿐입니다.",
    ),
    part="late_s",
)

STATIC_COUNTED = WrongStep(
    "static counted",
    {"late": "static"},
    Text(
        en="That is the age of a static transform, which was sent once. It is good for any time.",
        ko="한 번 보낸 정적 변환의 나이입니다. 정적 변환은 언제나 유효합니다.",
    ),
    "M12",
    part="late_s",
)

WAY_FOR_PLACE = WrongStep(
    "way for place",
    {"curve": "way"},
    Text(
        en="v/f is how far the robot drives from one sample to the next. TF does not stand still meanwhile: it joins the two by a straight line.",
        ko="v/f는 표본 사이에 로봇이 달리는 거리입니다. TF는 그동안 멈춰 있지 않고 두 표본을 직선으로 잇습니다.",
    ),
    "M9",
    part="off_mm",
)

HALF_WAY_FOR_PLACE = WrongStep(
    "half way for place",
    {"curve": "half way"},
    Text(
        en="That is half the way between two samples. How far is the *arc* from the straight line there?",
        ko="두 표본 사이 거리의 절반입니다. 그곳에서 *호*는 직선에서 얼마나 떨어져 있습니까?",
    ),
    "M9",
    part="off_mm",
)

WHOLE_ANGLE = WrongStep(
    "whole angle",
    {"curve": "whole angle"},
    Text(
        en="Between two samples the robot turns by ω/f; from the middle of the bend to its end it is half of that.",
        ko="두 표본 사이에 로봇은 ω/f만큼 돕니다. 가운데에서 끝까지는 그 절반입니다.",
    ),
    part="off_mm",
)

ANGLE_IN_DEGREES = WrongStep(
    "angle in degrees",
    {"curve": "angle in degrees"},
    Text(
        en="The cosine was taken of an angle in degrees. `math.cos` wants radians, and ω/(2f) is in radians as it is.",
        ko="도 단위 각도의 cos을 구했습니다. `math.cos`에는 라디안을 넣어야 하고, ω/(2f)는 그대로 라디안입니다.",
    ),
    part="off_mm",
)

WAY_WHILE_LATE = WrongStep(
    "way while late",
    {"curve": "way while late"},
    Text(
        en="That is how far the robot drives while the chain is late. Asked is how far the straight line between two samples is from the arc.",
        ko="사슬이 늦는 동안 로봇이 달리는 거리입니다. 구할 것은 두 표본을 이은 직선이 호에서 얼마나 떨어져 있는지입니다.",
    ),
    "M9",
    part="off_mm",
)

PRODUCT_FOR_THE_RADIUS = WrongStep(
    "product for the radius",
    {"curve": "product"},
    Text(
        en="You began with v·ω. The radius of the bend is v/ω: the faster it turns, the narrower the bend.",
        ko="v·ω에서 시작했습니다. 굽은 길의 반지름은 v/ω입니다. 빨리 돌수록 더 급하게 굽습니다.",
    ),
    part="off_mm",
)

BOTH_TAKEN_OFF = WrongStep(
    "both travels taken off",
    {"travel": "both taken off"},
    Text(
        en="You took both travels off. The transform is under way, too, after it was measured: its way makes the wait longer.",
        ko="두 이동 시간을 모두 뺐습니다. 변환도 측정된 뒤에 오는 시간이 걸리므로 그만큼 더 기다립니다.",
    ),
    part="wait_s",
)

HALF_A_PERIOD = WrongStep(
    "half a period",
    {"period": "half"},
    Text(
        en="Half a period is the wait on average. Asked is the longest.",
        ko="반 주기는 평균입니다. 가장 긴 기다림을 물었습니다.",
    ),
    part="wait_s",
)

SCAN_FORGOTTEN = WrongStep(
    "scan forgotten",
    {"travel": "without the scan"},
    Text(
        en="While the scan was under way, time had passed already: that much less there is to wait.",
        ko="스캔이 오는 동안 이미 시간이 지났습니다. 그만큼 덜 기다립니다.",
    ),
    part="wait_s",
)

SCAN_ADDED = WrongStep(
    "scan added",
    {"travel": "scan added"},
    Text(
        en="You added the scan's way. The wait begins when the scan has arrived: what had passed until then makes it shorter.",
        ko="스캔이 오는 시간을 더했습니다. 기다림은 스캔이 도착한 때부터 잽니다. 그 전에 지난 시간만큼 짧아집니다.",
    ),
    part="wait_s",
)

SCAN_S_WAY_ALONE = WrongStep(
    "the scan's way alone",
    {"travel": "the scan's alone"},
    Text(
        en="You added the scan's way, and the transform's is not in it. Which of the two has passed already when the wait begins, and which is still to come?",
        ko="스캔이 오는 시간을 더했고 변환이 오는 시간은 없습니다. 기다림이 시작될 때 이미 지난 것은 어느 쪽이고, 아직 남은 것은 어느 쪽입니까?",
    ),
    part="wait_s",
)

PERIOD_ALONE = WrongStep(
    "period alone",
    {"travel": "nothing"},
    Text(
        en="That is the period alone: both messages also take a while on their way.",
        ko="주기만 계산했습니다. 두 메시지가 오는 데도 시간이 걸립니다.",
    ),
    part="wait_s",
)

STRAIGHT_AHEAD = WrongStep(
    "straight ahead",
    {"curve": "straight"},
    Text(
        en="Nothing is lost on a straight. This robot turns: yaw_rate_radps is not 0.",
        ko="곧은 길이라면 틀리지 않습니다. 이 로봇은 돌고 있습니다. yaw_rate_radps가 0이 아닙니다.",
    ),
    part="off_mm",
)

WITHOUT_ITS_WAY = WrongStep(
    "without its way",
    {"late": "without its way"},
    Text(
        en="You took the transform's way off. What the tool prints is how late the chain is, its way with it.",
        ko="변환이 오는 시간을 뺐습니다. 도구가 출력하는 것은 오는 시간까지 포함해 사슬이 얼마나 늦는지입니다.",
    ),
    part="late_s",
)

RADIUS = WrongStep(
    "radius",
    {"curve": "radius"},
    Text(
        en="v/ω is the radius of the bend. How far is the middle of the arc from the straight line between its ends?",
        ko="v/ω는 굽은 길의 반지름입니다. 호의 가운데는 두 끝을 이은 직선에서 얼마나 떨어져 있습니까?",
    ),
    part="off_mm",
)

CHORD_ITSELF = WrongStep(
    "chord itself",
    {"curve": "chord itself"},
    Text(
        en="That is how long the straight line is. Asked is how far the arc is from it.",
        ko="직선의 길이입니다. 구할 것은 호가 직선에서 얼마나 떨어져 있는지입니다.",
    ),
    part="off_mm",
)

SINE_FOR_THE_GAP = WrongStep(
    "sine for the gap",
    {"curve": "sideways"},
    Text(
        en="With the sine you get half of the straight line itself. How far the arc is from it, the cosine says.",
        ko="sin으로는 직선 자체의 절반이 나옵니다. 호가 직선에서 얼마나 떨어져 있는지는 cos으로 구합니다.",
    ),
    part="off_mm",
)

TRAVELS_EXCHANGED = WrongStep(
    "travels exchanged",
    {"travel": "the other way"},
    Text(
        en="The two travels have changed places. What is on its way for longer arrives later: for which of the two does the other wait?",
        ko="두 이동 시간이 서로 바뀌었습니다. 오래 걸리는 쪽이 늦게 옵니다. 어느 쪽이 어느 쪽을 기다립니까?",
    ),
    part="wait_s",
)

OTHER_VERDICT = WrongAnswer(
    "other verdict",
    lambda g: {**judged(g), "enough": "no" if judged(g)["enough"] == "yes" else "yes"},
    Text(
        en="Compare off_mm with allowed_mm: it is enough where off_mm is at most that, both in millimetres, and not where it is more. Waiting is another question. If your own off_mm is not right yet, look at that first.",
        ko="off_mm과 allowed_mm을 비교하십시오. off_mm이 allowed_mm을 넘지 않으면 충분하고, 넘으면 충분하지 않습니다. 둘 다 mm입니다. 기다림은 다른 문제입니다. 구한 off_mm이 아직 틀리다면 그것부터 보십시오.",
    ),
    part="enough",
)

LATENESS_FOR_THE_PERIOD = WrongStep(
    "lateness for the period",
    {"travel": "lateness without the scan"},
    Text(
        en="You began with how late the chain was at worst. Asked is what follows from the period and the two travels.",
        ko="사슬이 최악으로 늦은 값에서 시작했습니다. 구할 것은 주기와 두 이동 시간에서 나오는 값입니다.",
    ),
    part="wait_s",
)

TRANSFORM_FORGOTTEN = WrongStep(
    "transform forgotten",
    {"travel": "without the transform"},
    Text(
        en="The transform is on its way, too, before it is heard.",
        ko="변환도 들릴 때까지 오는 시간이 걸립니다.",
    ),
    part="wait_s",
)


THE_OTHER_LEFT_IN = WrongStep(
    "the other left in",
    {"rate": "without the state publisher"},
    Text(
        en="You took away what the localization sends, and the robot_state_publisher's messages are still in it: there are two others.",
        ko="localization의 것만 뺐고 robot_state_publisher의 메시지는 아직 들어 있습니다. 다른 노드는 둘입니다.",
    ),
    part="odometry_hz",
)


HALF_THE_SQUARE = WrongStep(
    "half the square",
    {"curve": "half the square"},
    Text(
        en="v·ω·T²/2 is how far the arc leaves its first direction in a whole period. The line here joins both ends, and is at its farthest in the middle: about a quarter of that.",
        ko="v·ω·T²/2는 한 주기 동안 호가 처음 방향에서 벗어나는 거리입니다. 여기서 직선은 두 끝을 잇고 가운데에서 가장 멀어지므로, 그 값의 4분의 1쯤입니다.",
    ),
    part="off_mm",
)


NO_PERIOD = WrongStep(
    "no period",
    {"period": "none"},
    Text(
        en="The odometry's period is missing: at worst the scan arrives when a message has just been sent, and the next one is a whole period away.",
        ko="오도메트리의 주기가 빠졌습니다. 최악의 경우 스캔은 메시지가 막 나간 뒤의 순간을 측정한 것이고, 다음 메시지까지 한 주기가 남습니다.",
    ),
    part="wait_s",
)


TASK = Task(
    id="E11.3",
    kind="N",
    points=4,
    title=Text(en="Often enough?", ko="충분히 자주 옵니까?"),
    answer="verdict",
    form=Parts(
        {
            "odometry_hz": Number("Hz", tolerance=0.01),
            "late_s": Number("s", tolerance=0.001),
            "off_mm": Number("mm", tolerance=0.05),
            "wait_s": Number("s", tolerance=0.001),
            "enough": Choice(("yes", "no")),
        }
    ),
    given=a_slow_robot,
    variants=6,
    model=judged,
    mistakes=(
        SUM_OF_TF,
        SHARED_EVENLY,
        ONE_LEFT_IN,
        ANOTHER_NODES,
        THE_REPORT_S,
        WAY_WHILE_LATE,
        PRODUCT_FOR_THE_RADIUS,
        BOTH_TAKEN_OFF,
        AVERAGE_BELIEVED,
        STATIC_COUNTED,
        WAY_FOR_PLACE,
        HALF_WAY_FOR_PLACE,
        WHOLE_ANGLE,
        ANGLE_IN_DEGREES,
        HALF_A_PERIOD,
        SCAN_FORGOTTEN,
        SCAN_ADDED,
        SCAN_S_WAY_ALONE,
        PERIOD_ALONE,
        STRAIGHT_AHEAD,
        WITHOUT_ITS_WAY,
        RADIUS,
        CHORD_ITSELF,
        SINE_FOR_THE_GAP,
        TRAVELS_EXCHANGED,
        OTHER_VERDICT,
        LATENESS_FOR_THE_PERIOD,
        TRANSFORM_FORGOTTEN,
        THE_OTHER_LEFT_IN,
        HALF_THE_SQUARE,
        NO_PERIOD,
    ),
    hints=(
        Text(
            en="First the rate: everybody's Hz, minus the two nodes whose rate you know.",
            ko="먼저 발행률입니다. 모두를 합친 Hz에서, 발행률을 아는 두 노드의 것을 뺍니다.",
        ),
        Text(
            en="Late: the report's max. Off: (v/ω)(1 − cos(ω/2f)), in millimetres.",
            ko="지연은 보고의 max, 틈은 (v/ω)(1 − cos(ω/2f))이고 단위는 mm입니다.",
        ),
        Text(
            en="Wait: one period, plus the transform's way, minus the scan's way, and never below 0. Enough: is off_mm within what is allowed?",
            ko="기다림은 한 주기 + 변환의 이동 시간 − 스캔의 이동 시간이고 0보다 작지 않습니다. off_mm이 허용 범위 안이면 충분합니다.",
        ),
    ),
    shows={
        "off_mm": Text(
            en="The angle in it is in radians already, as `math.cos` wants it, and metres become millimetres at the end. Through which angle does the robot turn from the middle between two samples to one of them?",
            ko="식의 각도는 이미 라디안이므로 `math.cos`에 그대로 넣고, 미터는 마지막에 밀리미터로 바꿉니다. 두 표본의 가운데에서 한 표본까지 로봇이 도는 각도는 얼마입니까?",
        ),
    },
    misconceptions=("M9",),
)
