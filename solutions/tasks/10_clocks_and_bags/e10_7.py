"""E10.7: When must a buffer forget?"""

from __future__ import annotations

from itertools import pairwise

from tflab.workbook.tasks import Number, Sequence, Task, Text, WrongAnswer, WrongStep


def clocks(rng):
    """Draw what /clock said: steps back by 1 s and a hair to either side, leaps ahead, loops, and nothing at all."""
    t = float(rng.integers(20, 60))
    lap = [t + 0.25 * step for step in range(int(rng.integers(6, 10)))]
    end = lap[-1]
    return [
        ([*lap, *lap, *lap],),
        (lap,),
        ([*lap, end - 1.0, end - 0.75, end],),
        ([*lap, end - 0.9995, end - 0.5, end + 0.25],),
        ([*lap, end - 1.0005, end + 0.5],),
        ([*lap, end + 30.0, end + 30.25],),
        ([*lap, end - 0.25, end, end - 0.5],),
        ([*lap, end + 0.25, t],),
        ([*lap, end + 30.0, end + 30.25, t, t + 0.25, t - 5.0, t - 4.75, t + 0.5],),
        ([*lap, end - 0.4, end - 0.8, end - 1.2, end + 0.25],),
        ([t],),
        ([],),
    ]


def moments(clock_s, back="a second", against="the one before", which="all", tell="after", ahead=False, upto="the end"):
    """Return when to forget, step by step."""
    found = []
    highest = clock_s[0] if clock_s else 0.0
    if tell == "after" and which == "and the first":
        found = list(clock_s[:1])
    for place, (before, after) in enumerate(pairwise(clock_s[:-1] if upto == "the last but one" else clock_s)):
        highest = max(highest, before)
        step = {"the one before": before, "the highest": highest, "the first": clock_s[0]}[against] - after
        is_back = {
            "a second": step >= 1.0, "any": step > 0.0, "more": step > 1.0, "ahead": step <= -1.0,
            "whole seconds": int(before) - int(after) >= 1 and against == "the one before",
            "small": 0.0 < step < 1.0, "almost": step >= 0.9, "turned round": step >= -1.0,
        }[back]  # fmt: skip
        if is_back and against == "the highest" and which == "begun anew":
            highest = after
        if is_back or (ahead and -step >= 1.0):
            found.append(
                {"after": after, "before": before, "step": step, "place": place + 1, "place before": place}[tell]
            )
    return {"first": found[:1], "last": found[-1:]}.get(which, found)


WHOLE_SECONDS = WrongStep(
    "whole seconds",
    {"back": "whole seconds"},
    Text(
        en="You cut the readings to whole seconds before you compare them: a step from 30.1 back to 29.9 then counts as a second. Subtract first.",
        ko="읽은 값을 초 단위로 자른 다음 비교합니다. 그러면 30.1에서 29.9로 가는 것도 1초로 셉니다. 먼저 빼십시오.",
    ),
)


ANY_STEP_BACK = WrongStep(
    "any step back",
    {"back": "any"},
    Text(
        en="You forget at every small step back. Messages on /clock overtake each other by milliseconds, and each time all that moves would be gone.",
        ko="조금만 돌아가도 지웁니다. /clock 메시지는 몇 밀리초씩 순서가 바뀔 수 있고, 그때마다 움직이는 연결이 모두 사라집니다.",
    ),
)

NOT_AT_THE_BOUND = WrongStep(
    "not at the bound",
    {"back": "more"},
    Text(
        en='"by 1 s or more": a step back of just 1 s counts, too.',
        ko='"1초 이상"입니다. 정확히 1초 돌아간 것도 셉니다.',
    ),
)

LEAPS_AHEAD = WrongStep(
    "leaps ahead",
    {"ahead": True},
    Text(
        en="You forget at leaps ahead, too. What was heard before stays true when the clock hurries on.",
        ko="앞으로 건너뛸 때도 지웁니다. 시계가 서둘러 나아가도 전에 받은 것은 여전히 맞습니다.",
    ),
)

AGAINST_THE_HIGHEST = WrongStep(
    "against the highest",
    {"against": "the highest"},
    Text(
        en="You compare with the largest value so far. After a jump back the new lap lies below it for long, and you would forget at every tick: compare with the reading before.",
        ko="지금까지의 최댓값과 비교합니다. 한번 돌아가면 새 바퀴는 오랫동안 그보다 작으므로 매번 지우게 됩니다. 바로 앞의 값과 비교하십시오.",
    ),
)

AGAINST_THE_HIGHEST_SINCE = WrongStep(
    "against the highest since",
    {"against": "the highest", "which": "begun anew"},
    Text(
        en="You compare with the largest value since the last jump, so that small steps back add up. Each step counts by itself: compare with the reading just before.",
        ko="마지막으로 돌아간 뒤의 최댓값과 비교하므로 작게 돌아간 것들이 더해집니다. 한 걸음씩 따로 봅니다. 바로 앞의 값과 비교하십시오.",
    ),
)

ALMOST_A_SECOND = WrongStep(
    "almost a second",
    {"back": "almost"},
    Text(
        en='A step back of a hair less than 1 s counts for you. "By 1 s or more" has a sharp bound: nothing is rounded before it is compared.',
        ko='1초에 조금 못 미치게 돌아간 것도 셉니다. "1초 이상"의 한계는 정확합니다. 비교하기 전에 반올림하지 마십시오.',
    ),
)

AND_THE_FIRST = WrongStep(
    "and the first reading",
    {"which": "and the first"},
    Text(
        en="You always name the first reading of all. Nothing came before it, so nothing is to be forgotten there.",
        ko="맨 처음 값을 언제나 넣습니다. 그 앞에는 아무것도 없었으므로 지울 것도 없습니다.",
    ),
)

ONLY_THE_FIRST = WrongStep(
    "only the first",
    {"which": "first"},
    Text(
        en="You name one jump alone. A loop comes back again and again.",
        ko="되돌아간 곳을 하나만 적었습니다. 반복 재생은 거듭 돌아옵니다.",
    ),
)

READING_BEFORE = WrongStep(
    "the reading before",
    {"tell": "before"},
    Text(
        en="You give the last reading before the jump. Asked for is the first one after it: only then one knows.",
        ko="돌아가기 직전의 값을 반환합니다. 필요한 것은 돌아간 직후의 값입니다. 그때에야 알 수 있습니다.",
    ),
)

PLACE_IN_THE_LIST = WrongStep(
    "place in the list",
    {"tell": "place"},
    Text(
        en="You give places in the list. Asked for are the readings that stand there.",
        ko="리스트에서의 자리를 반환합니다. 필요한 것은 그 자리에 있는 값입니다.",
    ),
)

PLACE_BEFORE = WrongStep(
    "place before",
    {"tell": "place before"},
    Text(
        en="You give places in the list, and those before the jump. Asked for are the readings just after it.",
        ko="돌아가기 직전의 리스트 자리를 반환합니다. 필요한 것은 돌아간 직후의 값입니다.",
    ),
)

SIZE_OF_THE_STEP = WrongStep(
    "size of the step",
    {"tell": "step"},
    Text(
        en="You give how far the clock went back. Asked for is what it shows then.",
        ko="얼마나 돌아갔는지를 반환합니다. 필요한 것은 그때 시계의 값입니다.",
    ),
)

ONLY_AHEAD = WrongStep(
    "only ahead",
    {"back": "ahead"},
    Text(
        en="You find the leaps ahead, and none of those back. `before - after` is positive where the clock went back.",
        ko="앞으로 건너뛴 것만 찾고 돌아간 것은 찾지 못합니다. 시계가 돌아가면 `before - after`가 양수입니다.",
    ),
)

ONLY_THE_LAST = WrongStep(
    "only the last",
    {"which": "last"},
    Text(
        en="You keep the last jump alone. Each of them empties the buffer.",
        ko="마지막 것만 남깁니다. 돌아갈 때마다 버퍼를 지워야 합니다.",
    ),
)

ONLY_SMALL_STEPS = WrongStep(
    "only small steps",
    {"back": "small"},
    Text(
        en="You keep the small steps back, and leave out those of 1 s or more: just the other way round.",
        ko="작게 돌아간 것만 남기고 1초 이상은 뺍니다. 거꾸로입니다.",
    ),
)

AGAINST_THE_FIRST = WrongStep(
    "against the first",
    {"against": "the first"},
    Text(
        en="You compare with the first reading of all. Compare with the one just before.",
        ko="맨 처음 값과 비교합니다. 바로 앞의 값과 비교하십시오.",
    ),
)

LAST_READING_LEFT_OUT = WrongStep(
    "last reading left out",
    {"upto": "the last but one"},
    Text(
        en="You never look at the last reading. The clock can go back there, too.",
        ko="마지막 값을 보지 않습니다. 시계는 거기서도 돌아갈 수 있습니다.",
    ),
)

TURNED_ROUND = WrongStep(
    "turned round",
    {"back": "turned round"},
    Text(
        en="You find nearly every reading. Whether a clock went back shows in before minus after, and not the other way round.",
        ko="거의 모든 값을 찾습니다. 시계가 돌아갔는지는 이전 값에서 다음 값을 빼야 보입니다.",
    ),
)


TWO_BEFORE = WrongAnswer(
    "two before",
    lambda clock_s: [after for before, after in zip(clock_s, clock_s[2:], strict=False) if before - after >= 1.0],
    Text(
        en="You compare with the reading before the last one, two places back. Compare with the one just before.",
        ko="두 칸 앞의 값과 비교합니다. 바로 앞의 값과 비교하십시오.",
    ),
)


EVERY_OTHER_PAIR = WrongAnswer(
    "every other pair",
    lambda clock_s: [b for a, b in zip(clock_s[::2], clock_s[1::2], strict=False) if a - b >= 1.0],
    Text(
        en="You look at the readings two by two, and never from the second of one pair to the first of the next. `pairwise` gives all steps.",
        ko="값을 둘씩 묶어서 보므로, 한 쌍의 둘째 값에서 다음 쌍의 첫째 값으로 가는 걸음을 보지 않습니다. `pairwise`는 모든 걸음을 줍니다.",
    ),
)


TASK = Task(
    id="E10.7",
    kind="F",
    points=3,
    title=Text(en="When must a buffer forget?", ko="버퍼는 언제 지워야 합니까?"),
    answer="jumps",
    form=Sequence(Number(unit="s")),
    inputs=clocks,
    variants=3,
    model=moments,
    mistakes=(
        WHOLE_SECONDS,
        AGAINST_THE_HIGHEST,
        AGAINST_THE_HIGHEST_SINCE,
        ALMOST_A_SECOND,
        AND_THE_FIRST,
        ANY_STEP_BACK,
        NOT_AT_THE_BOUND,
        LEAPS_AHEAD,
        ONLY_THE_FIRST,
        READING_BEFORE,
        SIZE_OF_THE_STEP,
        PLACE_IN_THE_LIST,
        PLACE_BEFORE,
        ONLY_AHEAD,
        ONLY_THE_LAST,
        ONLY_SMALL_STEPS,
        AGAINST_THE_FIRST,
        LAST_READING_LEFT_OUT,
        TURNED_ROUND,
        TWO_BEFORE,
        EVERY_OTHER_PAIR,
    ),
    hints=(
        Text(
            en="Look at each reading together with the one before it.",
            ko="값마다 바로 앞의 값과 함께 보십시오.",
        ),
        Text(
            en="`pairwise(clock_s)` gives the pairs, and none for a list with fewer than two.",
            ko="`pairwise(clock_s)`는 이웃한 쌍을 줍니다. 값이 둘보다 적으면 하나도 없습니다.",
        ),
        Text(
            en="`before - after >= 1.0`, and keep `after`.",
            ko="`before - after >= 1.0`이면 `after`를 모읍니다.",
        ),
    ),
    misconceptions=("M13",),
)
