"""E10.1: Four set-ups."""

from __future__ import annotations

from functools import partial

from tflab.workbook.tasks import Choice, Parts, Sequence, Task, Text, WrongAnswer, WrongStep

KINDS = ("works", "just short", "years off", "silently latest", "never")
LETTERS = "abcd"
ORDERS = {
    "timer second": (0, 2, 1),
    "timer first": (2, 0, 1),
    "now first": (1, 0, 2),
    "now, timer, stamp": (1, 2, 0),
    "backwards": (2, 1, 0),
}


def four_set_ups(rng):
    """Draw the four ways to set use_sim_time and --clock, in an order of their own."""
    ways = [(sim, clock) for sim in (False, True) for clock in (False, True)]
    order = rng.permutation(len(ways))
    chosen = [ways[i] for i in order]
    return {
        "setups": {
            letter: {"use_sim_time": sim, "--clock": clock}
            for letter, (sim, clock) in zip(LETTERS, chosen, strict=True)
        }
    }


def outcomes(
    g, who="the parameter", stamp="the bag's", machine="years off", stopped="silently latest", running="just short",
    stopped_timer="never", machine_timer="works", order="as asked",
):  # fmt: skip
    """Return for each set-up what becomes of the three, step by step."""
    answers = {}
    for letter, way in g.setups.items():
        sim, clock = way["use_sim_time"], way["--clock"]
        if who == "the player":
            sim = clock
        elif who == "either":
            sim = sim or clock
        elif who == "the parameter alone":
            clock = True
        if not sim:
            answers[letter] = _on_the_machines_time(stamp, clock, machine, machine_timer, stopped_timer)
        elif not clock:
            at_stamp = {"the bag's": "works", "needs sim": "works", "needs time": "never", "needs both": "never"}
            answers[letter] = [at_stamp.get(stamp, "years off"), stopped, stopped_timer.split(",")[0]]
        else:
            answers[letter] = ["works", running, "works"]
        answers[letter] = [answers[letter][place] for place in ORDERS.get(order, (0, 1, 2))]
    return answers


def _on_the_machines_time(stamp, clock, machine, timer, stopped_timer):
    if stamp == "needs --clock":
        at_stamp = "works" if clock else "years off"
    else:
        at_stamp = "years off" if stamp in ("needs sim", "needs both") else "works"
    now = ("works" if clock else "years off") if machine == "helped by --clock" else machine
    return [at_stamp, now, "never" if "nor" in stopped_timer and not clock else timer]


STAMPS_NEED_SIM_TIME = WrongStep(
    "stamps need sim time",
    {"stamp": "needs sim"},
    Text(
        en="You let the question at the stamp fail where the node keeps the machine's time. Where do the stamp and the transforms come from, and does a clock take part in comparing them?",
        ko="노드가 컴퓨터의 시간에 있으면 측정 시각의 조회가 실패한다고 했습니다. 측정 시각과 변환은 어디에서 옵니까? 둘을 비교하는 데 시계가 끼어듭니까?",
    ),
    "M13",
    partly=True,
)

STAMPS_NEED_A_CLOCK = WrongStep(
    "stamps need a clock",
    {"stamp": "needs time"},
    Text(
        en="You let the question at the stamp fail while the clock stands. It hands over the stamp, and never looks at a clock.",
        ko="시계가 멈춰 있으면 측정 시각의 조회가 실패한다고 했습니다. 측정 시각을 넘길 뿐, 시계는 보지 않습니다.",
    ),
    "M13",
)

EVERYTHING_BREAKS = WrongStep(
    "everything breaks",
    {"stamp": "needs both"},
    Text(
        en="Only the set-up with everything switched on answers your questions at the stamp. Count on the page in how many of the four it did.",
        ko="모두 켠 설정에서만 측정 시각의 조회가 된다고 했습니다. 이 장의 표에서 네 설정 가운데 몇 개에서 되었는지 세어 보세요.",
    ),
    "M13",
)

STOPPED_RAISES = WrongStep(
    "stopped clock raises",
    {"stopped": "never"},
    Text(
        en="With a clock that stands you expect that asking for now never answers. What number does that clock show, and what does tf2 take it for?",
        ko="시계가 멈추면 현재 시각의 조회가 답을 얻지 못한다고 했습니다. 그 시계의 숫자는 얼마이고, tf2는 그것을 무엇으로 받아들입니까?",
    ),
    "M13",
)

STOPPED_IS_LONG_AGO = WrongStep(
    "stopped clock is long ago",
    {"stopped": "years off"},
    Text(
        en="With nobody on /clock that node's clock stands at 0: it does not fall back on the machine's time. 0 looks like 1970, years before the bag, but tf2 does not read that 0 as a moment.",
        ko="/clock이 발행되지 않으면 그 노드의 시계는 0에 멈춰 있고, 컴퓨터의 시간으로 돌아가지 않습니다. 0은 bag보다 여러 해 전인 1970년처럼 보이지만, tf2는 그 0을 시각으로 읽지 않습니다.",
    ),
    "M13",
)

NOW_IS_FINE = WrongStep(
    "now is fine",
    {"running": "works"},
    Text(
        en="With everything set right you expect an answer for now. The clock is right, and yet: has a transform of this very moment been heard already?",
        ko="모두 맞게 설정했으니 현재 시각의 조회가 된다고 했습니다. 시계는 맞습니다. 하지만 바로 지금의 변환이 벌써 도착했을까요?",
    ),
    "M9",
)

RUNNING_NOW_IS_THE_LATEST = WrongStep(
    "the running now is the latest",
    {"running": "silently latest"},
    Text(
        en="With everything set right you let now stand for the latest. That clock runs, so now is a moment like any other.",
        ko="모두 제대로 설정했는데 지금을 최신으로 보았습니다. 시계가 가고 있으므로 지금도 여느 시각과 같습니다.",
    ),
    "M9",
)

RUNNING_NOW_IS_YEARS_OFF = WrongStep(
    "the running now is years off",
    {"running": "years off"},
    Text(
        en="With everything set right you find now years off. From where does that node take its time, and of which year is it?",
        ko="모두 제대로 설정했는데 지금이 몇 년 어긋난다고 보았습니다. 그 노드는 어디서 시간을 얻고, 그것은 어느 해입니까?",
    ),
    "M13",
)

STOPPED_NOW_IS_JUST_SHORT = WrongStep(
    "the stopped now is just short",
    {"stopped": "just short"},
    Text(
        en="With a clock that stands you find now only just too new. What number does that clock show?",
        ko="멈춘 시계에서 지금이 조금 이를 뿐이라고 보았습니다. 그 시계는 어떤 숫자를 가리킵니까?",
    ),
    "M13",
)

MACHINE_NOW_IS_FINE = WrongStep(
    "the machine's now is fine",
    {"machine": "works"},
    Text(
        en="On the machine's time you expect an answer for now. The machine says this year; of which year are the transforms?",
        ko="컴퓨터의 시간에서 현재 시각의 조회가 된다고 했습니다. 컴퓨터는 올해를 가리킵니다. 변환은 어느 해의 것입니까?",
    ),
    "M13",
)

MACHINE_NOW_JUST_SHORT = WrongStep(
    "the machine's now is just short",
    {"machine": "just short"},
    Text(
        en="On the machine's time you find now only just too new. How far is the machine's clock from the bag's stamps?",
        ko="컴퓨터의 시간에서 현재 시각이 조금 모자랄 뿐이라고 했습니다. 컴퓨터의 시계와 bag의 측정 시각은 얼마나 떨어져 있습니까?",
    ),
    "M10",
)

TIMERS_ALWAYS_RING = WrongStep(
    "timers always ring",
    {"stopped_timer": "works"},
    Text(
        en="You let a timer ring on a clock that stands. It waits for that clock to move on.",
        ko="멈춘 시계에서 타이머가 울린다고 했습니다. 타이머는 바로 그 시계가 나아가기를 기다립니다.",
    ),
    "M13",
)

MACHINE_TIMER_STOPS = WrongStep(
    "the machine's timer stops",
    {"machine_timer": "never"},
    Text(
        en="You stop the timers of a node on the machine's time. That clock runs by itself, whatever is played.",
        ko="컴퓨터의 시간에 있는 노드의 타이머가 멈춘다고 했습니다. 그 시계는 무엇을 재생하든 스스로 갑니다.",
    ),
)

PLAYER_DECIDES = WrongStep(
    "the player decides",
    {"who": "the player"},
    Text(
        en="You let `--clock` decide in whose time a node lives. It only says something; who listens to it?",
        ko="노드가 어느 시간에 사는지를 `--clock`이 정한다고 했습니다. `--clock`은 알려 줄 뿐입니다. 그것을 누가 듣습니까?",
    ),
    "M13",
)

EITHER_DOES = WrongStep(
    "either does",
    {"who": "either"},
    Text(
        en="You let a node follow a clock that it was never told to listen to: `--clock` publishes, and only `use_sim_time` makes a node listen.",
        ko="들으라고 한 적 없는 시계를 노드가 따른다고 했습니다. `--clock`은 발행할 뿐이고, `use_sim_time`을 켜야 노드가 듣습니다.",
    ),
    "M13",
)

MACHINE_NOW_IS_THE_LATEST = WrongStep(
    "the machine's now is the latest",
    {"machine": "silently latest"},
    Text(
        en="On the machine's time you let now stand for the latest. tf2 takes a moment at its word; only one single number means the latest.",
        ko="컴퓨터의 시간에서 현재 시각이 최신을 뜻한다고 했습니다. tf2는 시각을 그대로 받아들입니다. 최신을 뜻하는 숫자는 하나뿐입니다.",
    ),
    "M9",
)

PARAMETER_SUFFICES = WrongStep(
    "the parameter suffices",
    {"who": "the parameter alone"},
    Text(
        en="You let `use_sim_time` suffice. It makes a node listen to /clock; does anybody speak there in each of the set-ups?",
        ko="`use_sim_time`만 켜면 된다고 했습니다. 노드가 /clock을 듣게 할 뿐입니다. 설정마다 /clock을 발행하는 노드가 있습니까?",
    ),
    "M13",
)

STAMPS_NEED_THE_PLAYER = WrongStep(
    "stamps need --clock",
    {"stamp": "needs --clock"},
    Text(
        en="You let the question at the stamp fail wherever the bag is played without --clock. The stamp and the transforms come from the bag: which of the two does --clock change?",
        ko="--clock 없이 재생하면 측정 시각의 조회가 실패한다고 했습니다. 측정 시각과 변환은 bag에서 옵니다. --clock이 그 가운데 무엇을 바꿉니까?",
    ),
    "M13",
)

STAMPS_ARE_LONG_AGO = WrongStep(
    "stamps are long ago",
    {"stamp": "years off on a stopped clock"},
    Text(
        en="With a clock that stands at 0 you find the stamp years off. The question at a stamp looks at no clock at all.",
        ko="0에 멈춘 시계에서 측정 시각이 몇 년 어긋난다고 했습니다. 측정 시각의 조회는 시계를 보지 않습니다.",
    ),
    "M13",
)

TIMERS_NEED_THE_PLAYER = WrongStep(
    "timers need --clock",
    {"stopped_timer": "never, nor without --clock"},
    Text(
        en="You stop every timer where no --clock is played. A node on the machine's time does not wait for /clock.",
        ko="--clock이 없으면 모든 타이머가 멈춘다고 했습니다. 컴퓨터의 시간에 있는 노드는 /clock을 기다리지 않습니다.",
    ),
    "M13",
)

PLAYED_CLOCK_HELPS = WrongStep(
    "a played clock helps",
    {"machine": "helped by --clock"},
    Text(
        en="Where the bag is played with --clock you expect an answer for now, even from a node that never listens to it. Which parameter makes a node listen?",
        ko="--clock으로 재생하면 그것을 듣지 않는 노드에서도 현재 시각의 조회가 된다고 했습니다. 노드가 듣게 하는 파라미터는 무엇입니까?",
    ),
    "M13",
)

STOPPED_NOW_IS_FINE = WrongStep(
    "the stopped now is fine",
    {"stopped": "works"},
    Text(
        en="With a clock that stands you expect a right answer for now. There is an answer; of which moment is it?",
        ko="시계가 멈춰도 현재 시각의 조회가 제대로 된다고 했습니다. 답은 나옵니다. 어느 순간의 답입니까?",
    ),
    "M13",
)

TIMER_BEFORE_NOW = WrongStep(
    "timer before now",
    {"order": "timer second"},
    Text(
        en="The order is: at the stamp, at now, the timer. You have the timer before now.",
        ko="순서는 측정 시각, 현재 시각, 타이머입니다. 타이머를 현재 시각보다 먼저 썼습니다.",
    ),
)

TIMER_FIRST = WrongStep(
    "timer first",
    {"order": "timer first"},
    Text(
        en="The order is: at the stamp, at now, the timer. You have the timer first of all.",
        ko="순서는 측정 시각, 현재 시각, 타이머입니다. 타이머를 맨 먼저 썼습니다.",
    ),
)


NOW_FIRST = WrongAnswer(
    "now first",
    partial(outcomes, order="now first"),
    Text(
        en="The order is: at the stamp, at now, the timer. You have now before the stamp.",
        ko="순서는 측정 시각, 현재 시각, 타이머입니다. 현재 시각을 측정 시각보다 먼저 썼습니다.",
    ),
)

STAMP_LAST = WrongAnswer(
    "stamp last",
    partial(outcomes, order="now, timer, stamp"),
    Text(
        en="The order is: at the stamp, at now, the timer. You have the stamp last of all.",
        ko="순서는 측정 시각, 현재 시각, 타이머입니다. 측정 시각을 맨 뒤에 썼습니다.",
    ),
)

BACKWARDS = WrongAnswer(
    "backwards",
    partial(outcomes, order="backwards"),
    Text(
        en="The order is: at the stamp, at now, the timer. You have the three the other way round.",
        ko="순서는 측정 시각, 현재 시각, 타이머입니다. 셋을 거꾸로 썼습니다.",
    ),
)


TASK = Task(
    id="E10.1",
    kind="M",
    points=4,
    title=Text(en="Four set-ups", ko="네 가지 설정"),
    answer="outcomes",
    form=Parts({letter: Sequence(Choice(KINDS)) for letter in LETTERS}),
    given=four_set_ups,
    variants=8,
    model=outcomes,
    mistakes=(
        PLAYER_DECIDES,
        EITHER_DOES,
        PARAMETER_SUFFICES,
        STAMPS_NEED_SIM_TIME,
        STAMPS_NEED_A_CLOCK,
        EVERYTHING_BREAKS,
        MACHINE_NOW_IS_FINE,
        MACHINE_NOW_JUST_SHORT,
        MACHINE_NOW_IS_THE_LATEST,
        STOPPED_RAISES,
        STOPPED_IS_LONG_AGO,
        NOW_IS_FINE,
        TIMERS_ALWAYS_RING,
        MACHINE_TIMER_STOPS,
        STAMPS_NEED_THE_PLAYER,
        STAMPS_ARE_LONG_AGO,
        TIMERS_NEED_THE_PLAYER,
        PLAYED_CLOCK_HELPS,
        STOPPED_NOW_IS_FINE,
        TIMER_BEFORE_NOW,
        TIMER_FIRST,
        NOW_FIRST,
        STAMP_LAST,
        BACKWARDS,
        RUNNING_NOW_IS_THE_LATEST,
        RUNNING_NOW_IS_YEARS_OFF,
        STOPPED_NOW_IS_JUST_SHORT,
    ),
    shows={
        "[0]": Text(
            en="The question at the stamp hands over a number from the bag and is answered by transforms from the same bag: no clock takes part in it.",
            ko="측정 시각의 조회는 bag에 적힌 숫자를 넘기고, 같은 bag에서 온 변환이 답합니다. 시계는 끼어들지 않습니다.",
        ),
        "[1]": Text(
            en="The question for now hands over what the node's clock shows: the machine's year, the bag's moment, or 0. How far is that from the newest transform?",
            ko="현재 시각의 조회는 노드의 시계가 가리키는 것을 넘깁니다. 컴퓨터의 올해, bag의 순간, 또는 0입니다. 최신 변환과 얼마나 떨어져 있습니까?",
        ),
        "[2]": Text(
            en="A timer waits until its node's clock has moved on. Does that clock move in this set-up?",
            ko="타이머는 노드의 시계가 그만큼 가기를 기다립니다. 이 설정에서 그 시계가 갑니까?",
        ),
    },
    hints=(
        Text(
            en="Say for each set-up first what the node's clock shows: this year, the bag's year, or 0.",
            ko="설정마다 먼저 노드의 시계가 무엇을 가리키는지 말해 보세요. 올해, bag의 해, 아니면 0입니다.",
        ),
        Text(
            en="The stamp is a number in the message, and the transforms came with it from the same bag.",
            ko="측정 시각은 메시지에 적힌 숫자이고, 변환도 같은 bag에서 왔습니다.",
        ),
        Text(
            en="For now, compare the clock with the newest transform. Of these clocks one shows what tf2 reads as the latest.",
            ko="현재 시각은 시계를 최신 변환과 비교하면 됩니다. 세 시계 가운데 하나는 tf2가 최신으로 읽는 숫자를 가리킵니다.",
        ),
    ),
    misconceptions=("M13", "M9"),
)
