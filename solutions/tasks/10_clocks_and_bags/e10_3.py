"""E10.3: Five failures."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongStep

LETTERS = "abcde"
CAUSES = (
    "mounts not recorded", "mounts skipped", "nobody publishes /clock", "one node in another time", "time went back",
    "sensor broken",
)  # fmt: skip
CURES = (
    "record again, with /tf_static", "play from the start", "play with --clock", "set use_sim_time on that node",
    "Buffer(node=self)", "set use_sim_time on all nodes", "raise the timeout", "replace the sensor",
)  # fmt: skip
ALL = {"/scan": 300, "/tf": 900, "/tf_static": 1}
GONE = '"laser_frame" passed to lookupTransform argument source_frame does not exist. '


def five_failures(rng):
    """Draw the five, in an order of their own, with numbers of their own."""
    start_s = round(float(rng.uniform(1.70e9, 1.79e9)), 1)
    offset_s = round(float(rng.uniform(0.5, 4.0)), 1)
    asked_s, later_s = round(start_s + float(rng.uniform(3.0, 9.0)), 3), round(float(rng.uniform(2e5, 9e6)), 1)
    scans = int(rng.integers(200, 900))
    counts = {**ALL, "/scan": scans}
    everywhere = {"/detector": True, "/localizer": True, "/rviz2": True}
    failures = [
        ({"/scan": scans, "/tf": 3 * scans}, "ros2 bag play drive --clock", everywhere, GONE),
        (counts, f"ros2 bag play drive --clock --start-offset {offset_s}", everywhere, GONE),
        (counts, "ros2 bag play drive", everywhere, "(nothing: a timer of 1 s has not rung in a minute)"),
        (
            counts, "ros2 bag play drive --clock", {**everywhere, "/localizer": False},
            "Lookup would require extrapolation into the past.  "
            f"Requested time {asked_s:.6f} but the earliest data is at time {start_s + later_s:.6f}, "
            "when looking up transform from frame [laser_frame] to frame [map]",
        ),
        (
            counts, "ros2 bag play drive --clock --loop", everywhere,
            f"TF_OLD_DATA ignoring data from the past for frame odom at time {start_s + 0.4:.6f} "
            "according to authority default_authority",
        ),
    ]  # fmt: skip
    order = rng.permutation(len(failures))
    rows = [failures[i] for i in order]
    return {
        "failures": {
            letter: {"info": info, "play": play, "use_sim_time": nodes, "log": log}
            for letter, (info, play, nodes, log) in zip(LETTERS, rows, strict=True)
        }
    }


def findings(
    g,
    gone=("mounts not recorded", "mounts skipped"),
    gone_do=("record again, with /tf_static", "play from the start"),
    silent=("nobody publishes /clock", "play with --clock"),
    apart=("one node in another time", "set use_sim_time on that node"),
    back=("time went back", "Buffer(node=self)"),
):
    """Return cause and cure of each, step by step."""
    answers = {}
    for letter, failure in g.failures.items():
        if "/tf_static" not in failure["info"]:
            cause, cure = gone[0], gone_do[0]
        elif "--start-offset" in failure["play"]:
            cause, cure = gone[1], gone_do[1]
        elif "--clock" not in failure["play"]:
            cause, cure = silent
        elif "--loop" in failure["play"]:
            cause, cure = back
        else:
            cause, cure = apart
        answers[f"{letter} cause"], answers[f"{letter} do"] = cause, cure
    return answers


BLAME_THE_SENSOR = WrongStep(
    "blame the sensor",
    {"gone": ("sensor broken", "sensor broken"), "gone_do": ("replace the sensor", "replace the sensor")},
    Text(
        en="A frame that does not exist is no broken sensor: its messages are in the bag, hundreds of them. Who should have told where it is bolted on?",
        ko="존재하지 않는 좌표계는 센서 고장이 아닙니다. 센서의 메시지는 bag에 수백 개 있습니다. 어디에 달려 있는지 누가 알려 주어야 했습니까?",
    ),
    "M15",
)

ONE_SENSOR = WrongStep(
    "a sensor in one of them",
    {
        "gone": ("mounts not recorded", "sensor broken"),
        "gone_do": ("record again, with /tf_static", "replace the sensor"),
    },
    Text(
        en="The bag of that failure is whole, its sensor too. Which moment of it is never played?",
        ko="그 bag에는 빠진 것이 없고 센서도 멀쩡합니다. 재생되지 않는 순간은 언제입니까?",
    ),
    "M15",
)

NEVER_RECORDED = WrongStep(
    "never recorded",
    {
        "gone": ("mounts not recorded", "mounts not recorded"),
        "gone_do": ("record again, with /tf_static", "record again, with /tf_static"),
    },
    Text(
        en="Two logs are the same, but not the two bags: count /tf_static in each before you drive the robot again.",
        ko="두 로그는 같지만 bag은 다릅니다. 로봇을 다시 몰기 전에 /tf_static의 개수를 각각 세어 보세요.",
    ),
    "M13",
)

ONLY_SKIPPED = WrongStep(
    "only skipped",
    {"gone": ("mounts skipped", "mounts skipped"), "gone_do": ("play from the start", "play from the start")},
    Text(
        en="One of the two bags has no /tf_static at all: from wherever it is played, there is nothing to play.",
        ko="두 bag 가운데 하나에는 /tf_static이 아예 없습니다. 어디서부터 재생해도 나올 것이 없습니다.",
    ),
    "M13",
)

RECORD_THE_SKIPPED_AGAIN = WrongStep(
    "record the skipped again",
    {"gone_do": ("record again, with /tf_static", "record again, with /tf_static")},
    Text(
        en="Where the mounts were skipped, the bag has them. Nothing needs to be recorded again.",
        ko="장착 변환을 건너뛴 경우에는 bag에 들어 있습니다. 다시 기록할 필요가 없습니다.",
    ),
    "M13",
)

TIMEOUT_FOR_A_CLOCK = WrongStep(
    "timeout for a clock",
    {"apart": ("one node in another time", "raise the timeout")},
    Text(
        en="Compare the two times of that log: days apart. For how long would you wait?",
        ko="그 로그의 두 시각을 비교해 보세요. 며칠이나 떨어져 있습니다. 얼마나 기다리겠습니까?",
    ),
    "M10",
)

TIMEOUT_FOR_A_TIMER = WrongStep(
    "timeout for a timer",
    {"silent": ("nobody publishes /clock", "raise the timeout")},
    Text(
        en="Where no timer rings, no timeout ends either: both wait for the same clock. Who sets it going?",
        ko="타이머가 울리지 않으면 timeout도 끝나지 않습니다. 둘 다 같은 시계를 기다립니다. 그 시계를 누가 가게 합니까?",
    ),
    "M10",
)

SIM_TIME_FOR_ALL = WrongStep(
    "sim time for all",
    {"apart": ("one node in another time", "set use_sim_time on all nodes")},
    Text(
        en="Look at the list of nodes: which of them lack it? At the others it changes nothing.",
        ko="노드 목록을 보세요. 어느 노드에 빠져 있습니까? 나머지 노드에서는 달라지는 것이 없습니다.",
    ),
    "M13",
)

SIM_TIME_FOR_THE_SILENT = WrongStep(
    "sim time for the silent",
    {"silent": ("nobody publishes /clock", "set use_sim_time on all nodes")},
    Text(
        en="Where the timer does not ring, all nodes have use_sim_time already. They listen; what do they hear?",
        ko="타이머가 울리지 않는 경우, 노드에는 이미 모두 use_sim_time이 켜져 있습니다. 듣고는 있는데, 무엇이 들립니까?",
    ),
    "M13",
)

OTHER_TIME_FOR_THE_SILENT = WrongStep(
    "another time for the silent",
    {"silent": ("one node in another time", "set use_sim_time on that node")},
    Text(
        en="Where the timer does not ring, no node differs from the others: read their parameters. Then read the line with which the bag is played.",
        ko="타이머가 울리지 않는 경우, 다른 노드와 설정이 다른 노드는 없습니다. 파라미터를 읽고, 그다음 재생 명령을 읽어 보세요.",
    ),
    "M13",
)

NO_CLOCK_FOR_THE_LOOP = WrongStep(
    "no clock for the loop",
    {"back": ("nobody publishes /clock", "play with --clock")},
    Text(
        en="The line with which that bag is played has --clock already. What else stands there, and what does the clock do at the end of the bag?",
        ko="그 bag의 재생 명령에는 --clock이 이미 있습니다. 또 무엇이 있으며, bag이 끝나면 시계는 어떻게 됩니까?",
    ),
    "M13",
)

OTHER_TIME_FOR_THE_LOOP = WrongStep(
    "another time for the loop",
    {"back": ("one node in another time", "set use_sim_time on that node")},
    Text(
        en="Data from the past, and every node follows the clock. Then it is the clock itself that moved.",
        ko="과거의 데이터라고 하는데 노드는 모두 /clock을 따릅니다. 그렇다면 시계 자체가 움직인 것입니다.",
    ),
    "M13",
)

START_FOR_THE_LOOP = WrongStep(
    "start for the loop",
    {"back": ("time went back", "play from the start")},
    Text(
        en="A loop is played from the start, again and again: that is what the buffer stumbles over. What must the buffer be able to see?",
        ko="반복 재생은 거듭 처음부터 재생합니다. 버퍼는 바로 거기에 걸려 넘어집니다. 버퍼가 무엇을 볼 수 있어야 합니까?",
    ),
    "M13",
)

BACK_FOR_THE_OTHER_DAY = WrongStep(
    "back in time for the other day",
    {"apart": ("time went back", "Buffer(node=self)")},
    Text(
        en="*Into the past* sounds like going back, but nothing loops there. Whose data begins days after the requested time?",
        ko="*into the past*라고 해서 시간이 돌아간 것은 아닙니다. 거기에는 반복이 없습니다. 요청 시각보다 며칠 늦게 시작하는 데이터는 누구의 것입니까?",
    ),
    "M11",
)


TASK = Task(
    id="E10.3",
    kind="D",
    points=5,
    title=Text(en="Five failures", ko="다섯 가지 고장"),
    answer="findings",
    form=Parts(
        {
            name: choice
            for letter in LETTERS
            for name, choice in ((f"{letter} cause", Choice(CAUSES)), (f"{letter} do", Choice(CURES)))
        }
    ),
    given=five_failures,
    variants=8,
    model=findings,
    mistakes=(
        BLAME_THE_SENSOR,
        ONE_SENSOR,
        NEVER_RECORDED,
        ONLY_SKIPPED,
        RECORD_THE_SKIPPED_AGAIN,
        TIMEOUT_FOR_A_TIMER,
        SIM_TIME_FOR_THE_SILENT,
        OTHER_TIME_FOR_THE_SILENT,
        TIMEOUT_FOR_A_CLOCK,
        SIM_TIME_FOR_ALL,
        BACK_FOR_THE_OTHER_DAY,
        NO_CLOCK_FOR_THE_LOOP,
        OTHER_TIME_FOR_THE_LOOP,
        START_FOR_THE_LOOP,
    ),
    hints=(
        Text(
            en="Read in this order: what is in the bag, how it is played, who follows the clock, and only then the log.",
            ko="이 순서로 읽어 보세요. bag에 무엇이 있는지, 어떻게 재생하는지, 누가 /clock을 따르는지, 그다음이 로그입니다.",
        ),
        Text(
            en="Two logs are the same text and two causes. One log is empty, and that is a finding, too.",
            ko="두 로그는 글자가 같지만 원인이 다릅니다. 로그 하나는 비어 있는데, 비어 있다는 것도 증거입니다.",
        ),
        Text(
            en="One node can be in another day only if its parameter differs. TF_OLD_DATA without a difference: the clock went back.",
            ko="파라미터가 다른 노드만 다른 날에 있을 수 있습니다. 다른 것이 없는데 TF_OLD_DATA가 나오면 시계가 돌아간 것입니다.",
        ),
    ),
    misconceptions=("M10", "M13", "M15"),
    means={
        "mounts not recorded": Text(
            en="mounts that were not recorded: /tf_static is missing from the bag itself.",
            ko="기록되지 않은 장착 변환: bag 자체에 /tf_static이 없습니다.",
        ),
        "mounts skipped": Text(
            en="skipped mounts: /tf_static is in the bag, and the playing begins after it.",
            ko="건너뛴 장착 변환: bag에 /tf_static이 있지만 그 뒤부터 재생합니다.",
        ),
        "nobody publishes /clock": Text(
            en="without /clock every node with use_sim_time stands still.",
            ko="/clock이 없으면 use_sim_time을 켠 노드의 시계가 모두 멈춥니다.",
        ),
        "one node in another time": Text(
            en="a node in another time has a parameter unlike the others, and two times in the log lie far apart.",
            ko="다른 시간에 사는 노드는 파라미터가 나머지와 다르고, 로그의 두 시각이 멀리 떨어져 있습니다.",
        ),
        "time went back": Text(
            en="time goes back where a bag begins again.",
            ko="bag이 처음으로 돌아가면 시간이 돌아갑니다.",
        ),
        "sensor broken": Text(
            en="a broken sensor would leave no messages in the bag.",
            ko="센서가 고장 났다면 bag에 메시지가 없을 것입니다.",
        ),
        "set use_sim_time on all nodes": Text(
            en="use_sim_time on all nodes helps where it is set on none.",
            ko="모든 노드에 use_sim_time을 켜는 것은 켜진 노드가 하나도 없을 때 도움이 됩니다.",
        ),
        "set use_sim_time on that node": Text(
            en="a parameter of one node helps where one node differs from the others.",
            ko="한 노드의 파라미터를 고치는 것은 그 노드만 다를 때 도움이 됩니다.",
        ),
        "play with --clock": Text(
            en="--clock helps where it is missing from the line that plays.",
            ko="--clock은 재생 명령에 빠져 있을 때 도움이 됩니다.",
        ),
        "play from the start": Text(
            en="playing from the start brings back what stood at the start, if it was recorded.",
            ko="처음부터 재생하면 처음에 있던 것이 나옵니다. 기록되어 있다면 그렇습니다.",
        ),
        "record again, with /tf_static": Text(
            en="recording again is needed only where the bag lacks something.",
            ko="다시 기록하는 것은 bag에 빠진 것이 있을 때만 필요합니다.",
        ),
        "Buffer(node=self)": Text(
            en="a buffer with a node sees when the clock goes back.",
            ko="노드를 준 버퍼는 시계가 돌아가는 것을 봅니다.",
        ),
        "raise the timeout": Text(
            en="a longer timeout helps where something is late by a moment.",
            ko="timeout을 늘리는 것은 무언가 잠깐 늦을 때 도움이 됩니다.",
        ),
        "replace the sensor": Text(
            en="the sensor's messages are in the bag: a new sensor would send no others.",
            ko="센서의 메시지는 bag에 있습니다. 새 센서도 똑같은 메시지를 보낼 뿐입니다.",
        ),
    },
)
