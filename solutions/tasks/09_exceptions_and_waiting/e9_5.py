"""E9.5: A queue that stays fresh."""

from __future__ import annotations

import numpy as np

from tflab.workbook.tasks import Number, Parts, Sequence, Task, Twin, Words


def queues(rng: np.random.Generator) -> list[tuple]:
    """Draw queues with room and without, old messages, one from the future, and one out of order."""
    now = round(float(rng.uniform(20.0, 60.0)), 1)

    def before(*ages_s: float) -> list[float]:
        wobble = rng.uniform(0.0, 0.02, len(ages_s))
        return [round(now - age - float(w), 3) for age, w in zip(ages_s, wobble, strict=True)]

    return [
        (before(0.35, 0.25, 0.15, 0.05), now, 1.0, 2),
        (before(0.95, 0.75, 0.35, 0.15), now, 0.5, 3),
        (before(2.4, 1.7, 0.9), now, 0.5, 3),
        (before(0.3, 0.2, 0.1), now, 0.5, 5),
        (before(0.4, 0.3, -0.4, 0.2), now, 0.5, 2),
        (before(0.15, 0.45, 0.25), now, 1.0, 2),
        ([], now, 0.5, 2),
    ]


def kept(
    stamps_s,
    now_s,
    max_age_s,
    max_size,
    *,
    oldest=False,
    ages=True,
    sizes=True,
    future=False,
    by_place=False,
    backwards=False,
    cut_first=False,
) -> dict:
    """Return what a policy keeps; the options are the mistakes."""
    came = len(stamps_s)
    stamps_s = sorted(stamps_s)[-max_size:] if cut_first else stamps_s
    young = [s for s in stamps_s if not ages or (now_s - s <= max_age_s and (future or s <= now_s))]
    young = young if by_place else sorted(young)
    if sizes:
        young = young[:max_size] if oldest else young[-max_size:]
    return {"kept": young[::-1] if backwards else young, "lost": came - len(young)}


KEEPS_THE_OLDEST = Twin(
    "keeps the oldest",
    lambda *a: kept(*a, oldest=True),
    reply=Words(
        en="when the queue is full, yours turns the new ones away. Then the robot decides on the oldest data it has. Let the oldest go.",
        ko="큐가 꽉 차면 새 메시지를 돌려보내고 있습니다. 그러면 로봇은 가진 것 중 가장 오래된 데이터로 결정합니다. 가장 오래된 것부터 버리십시오.",
    ),
)


AGE_IGNORED = Twin(
    "age ignored",
    lambda *a: kept(*a, ages=False),
    reply=Words(
        en="there are messages in your queue that are older than the limit. A queue that is not full may still be stale.",
        ko="한계보다 오래된 메시지가 큐에 남아 있습니다. 꽉 차지 않은 큐도 낡을 수 있습니다.",
    ),
)


SIZE_IGNORED = Twin(
    "size ignored",
    lambda *a: kept(*a, sizes=False),
    reply=Words(
        en="your queue has no size. Where everybody is young enough, everybody stays, and the decisions fall behind.",
        ko="큐에 크기 제한이 없습니다. 모두 충분히 새로우면 모두 남고, 결정은 점점 뒤처집니다.",
    ),
)


FUTURE_KEPT = Twin(
    "future kept",
    lambda *a: kept(*a, future=True),
    misconception="M10",
    reply=Words(
        en="a message from the future has a negative age, which is younger than any limit. It comes from a clock that is wrong: do not keep it.",
        ko="미래에서 온 메시지는 나이가 음수라서 어떤 한계보다도 젊습니다. 틀린 시계에서 온 것이니 두지 마십시오.",
    ),
)


NEWEST_FIRST = Twin(
    "newest first",
    lambda *a: kept(*a, backwards=True),
    reply=Words(
        en="the right messages, in the other order: asked for is oldest first.",
        ko="메시지는 맞게 골랐지만 순서가 반대입니다. 오래된 것부터 써야 합니다.",
    ),
)


BY_PLACE = Twin(
    "by place",
    lambda *a: kept(*a, by_place=True),
    reply=Words(
        en="you go by the order of arrival. Messages may overtake each other: age is a matter of the stamp.",
        ko="도착 순서를 따르고 있습니다. 메시지는 서로 앞지를 수 있습니다. 나이는 측정 시각으로 정합니다.",
    ),
)


CUT_BEFORE_SIEVING = Twin(
    "cut before sieving",
    lambda *a: kept(*a, cut_first=True),
    reply=Words(
        en="you cut to size first and sieve afterwards. Then a message from the future takes the place of a good one: sieve first, and cut what is left.",
        ko="먼저 개수를 자르고 나중에 거르고 있습니다. 그러면 미래에서 온 메시지가 멀쩡한 메시지의 자리를 차지합니다. 먼저 거르고, 남은 것을 자르십시오.",
    ),
)


NEITHER_SORTED_NOR_CUT = Twin(
    "neither sorted nor cut",
    lambda *a: kept(*a, by_place=True, sizes=False),
    reply=Words(
        en="two things: nobody is turned away when the queue is full, and the messages stand in the order of arrival, not of their stamps.",
        ko="두 가지입니다. 큐가 꽉 차도 아무것도 버리지 않고, 메시지가 측정 시각이 아니라 도착 순서로 서 있습니다.",
    ),
)


def counted_wrongly(*arguments) -> dict:
    right = kept(*arguments)
    return {**right, "lost": len(right["kept"])}


COUNTED_WHAT_STAYED = Twin(
    "counted what stayed",
    counted_wrongly,
    reply=Words(
        en='"lost" counts the messages that went, not those that stayed.',
        ko='"lost"는 남은 메시지가 아니라 버린 메시지의 수입니다.',
    ),
)


EVERYTHING_KEPT = Twin(
    "everything kept",
    lambda *a: {"kept": list(a[0]), "lost": 0},
    reply=Words(
        en="nothing is ever lost in your queue. That is the queue of the page that decides on data four seconds old.",
        ko="이 큐는 아무것도 버리지 않습니다. 4초 묵은 데이터로 결정하던 그 큐입니다.",
    ),
)


TASK = Task(
    id="E9.5",
    kind="F",
    points=3,
    title=Words(en="A queue that stays fresh", ko="늘 신선한 큐"),
    answer="keep",
    form=Parts({"kept": Sequence(Number("s", 1e-6)), "lost": Number("", 1e-6)}),
    inputs=queues,
    variants=3,
    twins=(
        KEEPS_THE_OLDEST,
        AGE_IGNORED,
        SIZE_IGNORED,
        FUTURE_KEPT,
        NEWEST_FIRST,
        BY_PLACE,
        CUT_BEFORE_SIEVING,
        EVERYTHING_KEPT,
        NEITHER_SORTED_NOR_CUT,
        COUNTED_WHAT_STAYED,
    ),
    hints=(
        Words(
            en="Three sieves, one after the other: from the future, too old, too many.",
            ko="차례로 세 번 거르십시오. 미래에서 온 것, 너무 오래된 것, 너무 많은 것입니다.",
        ),
        Words(en="Sort by stamp before you count from the end.", ko="뒤에서부터 세기 전에 시각 순으로 정렬하십시오."),
        Words(
            en="`0 <= now_s - stamp <= max_age_s` for the first two; a slice from the end for the third. Lost is what came minus what stayed.",
            ko="앞의 둘은 `0 <= now_s - stamp <= max_age_s`, 셋째는 끝에서 자르기입니다. 버린 수는 들어온 수에서 남은 수를 뺀 것입니다.",
        ),
    ),
    cures=("M10",),
)
