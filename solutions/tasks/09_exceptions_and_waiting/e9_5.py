"""E9.5: A queue that stays fresh."""

from __future__ import annotations

from functools import partial

from tflab.workbook.tasks import Draws, Number, Parts, Sequence, Task, Text, WrongAnswer, WrongStep


def queues(rng: Draws) -> list[tuple]:
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
        (before(0.4, 0.3, 0.2, -0.4), now, 0.5, 1),  # in rising order, and room for one: no third mistake shows
        (before(0.15, 0.45, 0.25), now, 1.0, 2),
        ([], now, 0.5, 2),
        (before(0.3, 0.2, 0.1), now, 0.5, 0),  # room for none
        ([float(int(now) - 1), int(now) - 0.5, float(int(now))], float(int(now)), 0.5, 5),  # at both limits
        ([int(now) - 0.501, int(now) - 0.4995, int(now) + 5e-4, int(now) - 5e-4], float(int(now)), 0.5, 5),
        ([int(now) - 0.5005, int(now) + 0.005, int(now) - 0.005], float(int(now)), 0.5, 5),  # a hair beside them
        ([int(now) - 0.25, int(now) - 0.25, int(now) + 0.05], float(int(now)), 0.5, 5),  # two at once
        (before(0.3, -0.9, 0.2), now, 0.5, 5),  # further ahead than the limit
        ([int(now) - 0.25, int(now) - 0.25, int(now) - 0.05], float(int(now)), 0.5, 2),  # one of two twins has to go
        (before(0.3, 0.9, 0.2, 0.1), now, 0.5, 5),  # one that is too old came late
        ([int(now) - 0.5, int(now) - 0.25], float(int(now)), 0.5, 5),  # at one limit alone
        ([int(now) - 0.25, float(int(now))], float(int(now)), 0.5, 5),  # at the other
        *(([int(now) - age], float(int(now)), 0.5, 5) for age in (0.9, 0.5, 0.0, -0.4)),  # one alone, of each sort
        (before(0.3, 0.1), now, 1.0, 1),  # room for one
        (before(0.25, 0.05, 0.15), now, 1.0, 5),  # out of order, and room for all
        ([int(now) - 0.25, int(now) - 0.25, int(now) - 0.05], float(int(now)), 0.5, 5),  # room for both twins
    ]


def kept(stamps_s, now_s, max_age_s, max_size, *, first="sieve", old="dropped", ahead="dropped", order="by stamp",
         size="newest", out="oldest first", lost="went", loop="a new list", age="now minus stamp") -> dict:  # fmt: skip
    """Return what a policy keeps, step by step; other steps are the slips."""
    all_s, came = stamps_s, len(stamps_s)

    def cut_to_size(stamps_s: list[float]) -> list[float]:
        return {
            "newest": stamps_s[max(0, len(stamps_s) - max_size) :],
            "slice": stamps_s[-max_size:],
            "one more": stamps_s[max(0, len(stamps_s) - max_size - 1) :],
            "one less": stamps_s[max(0, len(stamps_s) - max_size + 1) :],
            "oldest": stamps_s[:max_size],
            "all but the newest": stamps_s[:-max_size],
            "not cut": stamps_s,
            "one goes": stamps_s[len(stamps_s) > max_size :],
        }[size]

    if first == "cut":
        stamps_s = cut_to_size(list(stamps_s) if order == "cut by place" else sorted(stamps_s))

    if ahead == "as now":
        stamps_s = [min(stamp, now_s) for stamp in stamps_s]
    newest_s = max((stamp for stamp in stamps_s if stamp <= now_s), default=0.0)

    def stays(age_s: float) -> bool:
        age_s = -age_s if age == "stamp minus now" else age_s
        is_young = {
            "dropped": age_s <= max_age_s,
            "at the limit": age_s < max_age_s,
            "milliseconds": 1000.0 * age_s <= max_age_s,
            "rounded": round(age_s, 1) <= max_age_s,
            "whole seconds": int(age_s) <= max_age_s,
            "the stamp itself": now_s - age_s <= max_age_s,
            "by the newest": max(stamps_s, default=0.0) - (now_s - age_s) <= max_age_s,
            "by the newest of the past": newest_s - (now_s - age_s) <= max_age_s,
            "kept": True,
            "wanted": age_s >= max_age_s,
        }[old]
        is_past = {
            "dropped": age_s >= 0.0,
            "now, too": age_s > 0.0,
            "0.1 s": age_s >= -0.1,
            "rounded": round(age_s, 1) >= 0.0,
            "whole seconds": int(age_s) >= 0,
            "by its size": abs(age_s) <= max_age_s,
            "kept": True,
        }.get(ahead, True)
        return is_young and is_past

    young = [stamp for stamp in stamps_s if stays(now_s - stamp)]
    if loop == "ends at the first":
        young = [
            stamp for place, stamp in enumerate(stamps_s) if all(stays(now_s - each) for each in stamps_s[: place + 1])
        ]
    if loop == "backwards to the first":
        young = []
        for stamp in reversed(stamps_s):
            if now_s - stamp > max_age_s:
                break
            young += [stamp] if stays(now_s - stamp) else []
    if loop == "removed in it":
        young = list(stamps_s)
        for stamp in young:
            if not stays(now_s - stamp):
                young.remove(stamp)
    young = {"by stamp": sorted(young), "by place": young, "cut by place": young, "set": sorted(set(young))}[order]
    cut = young if first == "cut" else cut_to_size(young)
    cut = sorted(cut) if order == "cut by place" else cut
    losses = {
        "went": came - len(cut),
        "stayed": len(cut),
        "sieved": came - len(young),
        "cut": len(young) - len(cut),
        "none": 0,
        "none where there is no room": came - len(cut) if max_size else 0,
        "none where none is young": came - len(cut) if young else 0,
        "what is not among the kept": sum(stamp not in cut for stamp in all_s),
        "ahead": sum(stamp > now_s for stamp in all_s),
        "too old": sum(now_s - stamp > max_age_s for stamp in stamps_s),
        "too old and cut": sum(now_s - stamp > max_age_s for stamp in stamps_s) + len(young) - len(cut),
    }
    ages_s = [now_s - stamp for stamp in cut]
    kept = {"newest first": cut[::-1], "ages": ages_s, "ages, the youngest first": ages_s[::-1]}.get(out, cut)
    return {"kept": kept, "lost": losses[lost]}


KEEPS_THE_OLDEST = WrongStep(
    "keeps the oldest",
    {"size": "oldest"},
    reply=Text(
        en="when the queue is full, yours turns the new ones away. Then the robot decides on the oldest data it has. Let the oldest go.",
        ko="큐가 꽉 차면 새 메시지를 돌려보내고 있습니다. 그러면 로봇은 가진 것 중 가장 오래된 데이터로 결정합니다. 가장 오래된 것부터 버리십시오.",
    ),
)


AGE_IGNORED = WrongStep(
    "age ignored",
    {"old": "kept"},
    reply=Text(
        en="there are messages in your queue that are older than the limit. A queue that is not full may still be stale.",
        ko="한계보다 오래된 메시지가 큐에 남아 있습니다. 꽉 차지 않은 큐도 낡을 수 있습니다.",
    ),
)


NOTHING_SIEVED = WrongStep(
    "nothing sieved",
    {"old": "kept", "ahead": "kept"},
    reply=Text(
        en="nothing is sieved out: what is too old stays, and what comes from the future as well. Is it `or` where both bounds have to hold, or `and` where one of two reasons is enough to go?",
        ko="아무것도 거르지 않습니다. 너무 오래된 것도, 미래에서 온 것도 남습니다. 두 조건이 다 맞아야 남는 곳에 `or`를 썼거나, 하나만 어겨도 버릴 곳에 `and`를 썼습니까?",
    ),
)


ALL_BUT_THE_NEWEST = WrongStep(
    "all but the newest",
    {"size": "all but the newest"},
    reply=Text(
        en="`[:-max_size]` is all but the last `max_size`: just those that should stay go.",
        ko="`[:-max_size]`은 마지막 `max_size`개를 뺀 나머지입니다. 남아야 할 바로 그것들이 나갑니다.",
    ),
)


SIZE_IGNORED = WrongStep(
    "size ignored",
    {"size": "not cut"},
    reply=Text(
        en="your queue has no size. Where everybody is young enough, everybody stays, and the decisions fall behind.",
        ko="큐에 크기 제한이 없습니다. 모두 충분히 새로우면 모두 남고, 결정은 점점 뒤처집니다.",
    ),
)


FUTURE_KEPT = WrongStep(
    "future kept",
    {"ahead": "kept"},
    misconception="M10",
    reply=Text(
        en="a message from the future has a negative age, which is younger than any limit. It comes from a clock that is wrong: do not keep it.",
        ko="미래에서 온 메시지는 나이가 음수라서 어떤 한계보다도 젊습니다. 틀린 시계에서 온 것이니 두지 마십시오.",
    ),
)


AGE_BY_ITS_SIZE = WrongStep(
    "age by its size",
    {"ahead": "by its size"},
    misconception="M10",
    reply=Text(
        en="you keep a message from the future if it is no further ahead than `max_age_s`, as `abs(...)` makes it. What is ahead of `now_s` comes from a clock that is wrong, by whatever: its age is below 0, so let the sign stand.",
        ko="미래에서 온 메시지도 `now_s`에서 `max_age_s` 이내면 남깁니다. `abs(...)`를 쓰면 그렇게 됩니다. 측정 시각이 `now_s`보다 늦은 것은 조금이든 많이든 틀린 시계에서 온 것입니다. 나이가 음수이니 부호를 그대로 두십시오.",
    ),
)


NEWEST_FIRST = WrongStep(
    "newest first",
    {"out": "newest first"},
    reply=Text(
        en="the right messages, in the other order: asked for is oldest first.",
        ko="메시지는 맞게 골랐지만 순서가 반대입니다. 오래된 것부터 넣어야 합니다.",
    ),
)


BY_PLACE = WrongStep(
    "by place",
    {"order": "by place"},
    reply=Text(
        en="you go by the order of arrival. Messages may overtake each other: age is a matter of the stamp.",
        ko="도착 순서를 따르고 있습니다. 메시지는 서로 앞지를 수 있습니다. 나이는 측정 시각으로 정합니다.",
    ),
)


CUT_BY_PLACE = WrongStep(
    "cut by place",
    {"order": "cut by place"},
    reply=Text(
        en="you sort only what is left: which messages have to go, you decide by the order of arrival. A `deque(maxlen=…)` does so, too. Messages may overtake each other: sort by stamp before you cut.",
        ko="남은 것만 정렬합니다. 무엇을 버릴지는 도착 순서로 정했습니다. `deque(maxlen=…)`도 그렇게 합니다. 메시지는 서로 앞지를 수 있으니 자르기 전에 시각 순으로 정렬하십시오.",
    ),
)


CUT_BEFORE_SIEVING = WrongStep(
    "cut before sieving",
    {"first": "cut"},
    reply=Text(
        en="you cut to size first and sieve afterwards. Then a message from the future takes the place of a good one: sieve first, and cut what is left.",
        ko="먼저 개수를 자르고 나중에 거르고 있습니다. 그러면 미래에서 온 메시지가 멀쩡한 메시지의 자리를 차지합니다. 먼저 거르고, 남은 것을 자르십시오.",
    ),
)


COUNTED_WHAT_STAYED = WrongStep(
    "counted what stayed",
    {"lost": "stayed"},
    reply=Text(
        en='"lost" counts the messages that went, not those that stayed.',
        ko='"lost"는 남은 메시지가 아니라 버린 메시지의 수입니다.',
    ),
)


EVERYTHING_KEPT = WrongAnswer(
    "everything kept",
    lambda *a: {"kept": list(a[0]), "lost": 0},
    reply=Text(
        en="nothing is ever lost in your queue. That is the queue of the page that decides on data four seconds old.",
        ko="이 큐는 아무것도 버리지 않습니다. 4초 묵은 데이터로 결정하던 그 큐입니다.",
    ),
)


AGE_LIMIT = WrongStep(
    "the limit is too old",
    {"old": "at the limit"},
    Text(
        en='A message that is exactly `max_age_s` old may stay: "nothing older than" lets the limit itself in.',
        ko='나이가 정확히 `max_age_s`인 메시지는 남아도 됩니다. "더 오래된 것"만 버리므로 한계 자체는 괜찮습니다.',
    ),
)

NOW_LIMIT = WrongStep(
    "now is the future",
    {"ahead": "now, too"},
    Text(
        en="A message whose stamp is `now_s` itself is not from the future: its age is 0. Let it stay.",
        ko="측정 시각이 `now_s`와 같은 메시지는 미래에서 온 것이 아닙니다. 나이가 0이므로 남겨야 합니다.",
    ),
)

SOME_FUTURE = WrongStep(
    "a little future",
    {"ahead": "0.1 s"},
    Text(
        en='You let a little of the future in. The task says "nothing from the future": 0 <= now_s - stamp.',
        ko="미래의 메시지를 조금은 통과시킵니다. 문제에는 미래에서 온 것은 두지 말라고 되어 있습니다. 0 <= now_s - stamp입니다.",
    ),
    misconception="M10",
)

EQUAL_MERGED = WrongStep(
    "equal stamps merged",
    {"order": "set"},
    Text(
        en="Two messages with one stamp are two messages: a set, or a dict by stamp, makes one of them.",
        ko="측정 시각이 같아도 메시지는 두 개입니다. set이나 시각을 키로 한 dict를 쓰면 하나가 됩니다.",
    ),
)

SIZE_ZERO = WrongStep(
    "a slice of size zero",
    {"size": "slice"},
    Text(
        en="For `max_size` 0 your queue keeps everybody: `[-0:]` is the whole list. Count from the front, or ask for 0 first.",
        ko="`max_size`가 0이면 모두 남습니다. `[-0:]`은 리스트 전체이기 때문입니다. 앞에서부터 세거나 0인지 먼저 확인하십시오.",
    ),
)

LOST_SIEVED = WrongStep(
    "lost without the cut",
    {"lost": "sieved"},
    Text(
        en='"lost" leaves out those that were turned away because the queue was full. Count all that came and did not stay.',
        ko='"lost"에 큐가 꽉 차서 버린 것이 빠졌습니다. 들어왔지만 남지 않은 것을 모두 세십시오.',
    ),
)

LOST_CUT = WrongStep(
    "lost without the sieve",
    {"lost": "cut"},
    Text(
        en='"lost" counts only those that were cut off at the end, not those that were sieved out before.',
        ko='"lost"가 마지막에 잘라 낸 것만 세고, 그 전에 걸러 낸 것은 세지 않습니다.',
    ),
)

LOST_NONE = WrongStep(
    "lost is always zero",
    {"lost": "none"},
    Text(en='"lost" is always 0, although messages went.', ko='메시지를 버렸는데도 "lost"가 언제나 0입니다.'),
)

LOST_OLD = WrongStep(
    "lost are only the old",
    {"lost": "too old"},
    Text(
        en='"lost" counts only those that are too old. Those from the future and those for which there is no room went, too.',
        ko='"lost"가 너무 오래된 것만 셉니다. 미래에서 온 것과 자리가 없어 버린 것도 세어야 합니다.',
    ),
)

LOST_AHEAD = WrongStep(
    "lost are only those ahead",
    {"lost": "ahead"},
    Text(
        en='"lost" counts only those from the future. Those that are too old and those for which there is no room went, too.',
        ko='"lost"가 미래에서 온 것만 셉니다. 너무 오래된 것과 자리가 없어 버린 것도 세어야 합니다.',
    ),
)

LOST_WITHOUT_THE_FUTURE = WrongStep(
    "lost without the future",
    {"lost": "too old and cut"},
    Text(
        en='"lost" leaves out those from the future. They came, and they do not stay.',
        ko='"lost"에 미래에서 온 것이 빠졌습니다. 들어왔지만 남지 않은 것입니다.',
    ),
)

AGES = WrongStep(
    "ages",
    {"out": "ages"},
    reply=Text(
        en="what stays is told by its age. Asked for are the stamps.",
        ko="남은 것을 나이로 답했습니다. 측정 시각이 필요합니다.",
    ),
)

OLD_ONES_WANTED = WrongStep(
    "the old ones stay",
    {"old": "wanted"},
    reply=Text(
        en="the comparison is the wrong way round: what is older than `max_age_s` stays, and what is fresh goes.",
        ko="비교가 거꾸로입니다. `max_age_s`보다 오래된 것이 남고 새것이 나갑니다.",
    ),
)


AGE_IN_MILLISECONDS = WrongStep(
    "age in milliseconds",
    {"old": "milliseconds"},
    Text(
        en="Only what is younger than a thousandth of `max_age_s` stays: the age and the limit are in two units. Both are given in seconds.",
        ko="`max_age_s`의 1000분의 1보다 젊은 것만 남습니다. 나이와 한계의 단위가 다릅니다. 둘 다 초 단위로 주어집니다.",
    ),
)


STAMP_FOR_AGE = WrongStep(
    "stamp for age",
    {"old": "the stamp itself"},
    Text(
        en="Nothing ever stays in your queue. What do you compare with `max_age_s`: the age, which is `now_s - stamp`, or the stamp itself?",
        ko="큐에 아무것도 남지 않습니다. `max_age_s`와 무엇을 비교합니까? 나이, 곧 `now_s - stamp`입니까, 측정 시각 자체입니까?",
    ),
)


AGES_IN_WHOLE_SECONDS = WrongStep(
    "ages in whole seconds",
    {"old": "whole seconds", "ahead": "whole seconds"},
    Text(
        en="You cut ages to whole seconds: then all that is less than a second old, or less than a second ahead, counts as 0. Compare the age as it is.",
        ko="나이를 초 단위로 끊습니다. 그러면 1초가 되지 않은 것과 1초 안쪽의 미래가 모두 0이 됩니다. 나이를 있는 그대로 비교하십시오.",
    ),
)


AGE_BY_THE_NEWEST = WrongStep(
    "age by the newest",
    {"old": "by the newest"},
    Text(
        en="You measure the age from the newest message. It is `now_s` that says how old each is.",
        ko="가장 새로운 메시지를 기준으로 나이를 잽니다. 얼마나 오래되었는지는 `now_s`로 셉니다.",
    ),
    "M9",
)


AGE_BY_THE_NEWEST_OF_THE_PAST = WrongStep(
    "age by the newest of the past",
    {"old": "by the newest of the past"},
    Text(
        en="You measure the age from the newest message that is not from the future. It is `now_s` that says how old each is.",
        ko="미래에서 온 것을 뺀 가장 새로운 메시지를 기준으로 나이를 잽니다. 얼마나 오래되었는지는 `now_s`로 셉니다.",
    ),
    "M9",
)


ENDS_AT_THE_FIRST = WrongStep(
    "ends at the first that goes",
    {"loop": "ends at the first"},
    Text(
        en="After the first message that has to go you look at no further one: `break` ends the loop, `continue` only goes on to the next.",
        ko="나가야 할 메시지를 처음 만나면 그 뒤는 보지 않습니다. `break`는 반복문을 끝내고, `continue`는 다음으로 넘어갑니다.",
    ),
)


AGES_ROUNDED = WrongStep(
    "ages rounded",
    {"old": "rounded"},
    Text(
        en="What is older than the limit by a thousandth of a second stays in your queue. Do you round the age, or allow some more? Compare it as it is, and round, if at all, what is printed.",
        ko="한계보다 1000분의 1초 더 오래된 것이 큐에 남습니다. 나이를 반올림하거나 여유를 두었습니까? 있는 그대로 비교하고, 반올림은 출력할 때만 하십시오.",
    ),
)


EVERYTHING_ROUNDED = WrongStep(
    "everything rounded",
    {"old": "rounded", "ahead": "rounded"},
    Text(
        en="Some thousandths of a second do not count for you: what is older than the limit by so little stays, and so does what is so little ahead of `now_s`. Do you round the age? Compare it as it is.",
        ko="1000분의 몇 초를 무시합니다. 그만큼 한계보다 오래된 것도, 측정 시각이 그만큼 `now_s`보다 늦은 것도 남습니다. 나이를 반올림합니까? 있는 그대로 비교하십시오.",
    ),
)


REMOVED_IN_THE_LOOP = WrongStep(
    "removed in the loop",
    {"loop": "removed in it"},
    Text(
        en="What has to go stays where it follows on another that went: whoever removes from the list that the loop goes through makes it pass over the next one. Build a new list of those that stay.",
        ko="나가야 할 것 가운데 앞의 것이 빠진 바로 다음 것이 남습니다. 반복문이 지나는 리스트에서 지우면 그다음 것을 건너뛰기 때문입니다. 남길 것만 모아 새 리스트를 만드십시오.",
    ),
)


ONE_TOO_MANY = WrongStep(
    "one too many",
    {"size": "one more"},
    Text(
        en="Your queue holds one message more than `max_size`.",
        ko="큐에 `max_size`보다 하나 더 남습니다.",
    ),
)


ONE_TOO_FEW = WrongStep(
    "one too few",
    {"size": "one less"},
    Text(
        en="Your queue holds one message less than `max_size`.",
        ko="큐에 `max_size`보다 하나 덜 남습니다.",
    ),
)


ONE_GOES = WrongStep(
    "one goes",
    {"size": "one goes"},
    Text(
        en="where more are left than `max_size`, one goes and no more: with two too many, one too many stays. Is it an `if` where a loop or a slice is meant?",
        ko="남은 것이 `max_size`보다 많으면 하나만 버립니다. 둘이 넘치면 하나가 넘친 채로 남습니다. 반복이나 자르기를 쓸 곳에 `if`를 썼습니까?",
    ),
)


AHEAD_AS_NOW = WrongStep(
    "the future as now",
    {"ahead": "as now"},
    Text(
        en="a message from the future stays in your queue with `now_s` for its stamp. Nobody measured anything then: its clock is wrong, so do not keep it, and change no stamp.",
        ko="미래에서 온 메시지가 `now_s`라는 시각으로 큐에 남습니다. 그 시각에 측정된 것은 없습니다. 그 시계가 틀린 것이므로 남기지 말고, 어떤 시각도 바꾸지 마십시오.",
    ),
    "M10",
)


ENDS_BACKWARDS = WrongStep(
    "backwards to the first that is old",
    {"loop": "backwards to the first"},
    Text(
        en="you go back from the end and stop at the first that is too old. A message may overtake an older one: what came before an old one may still be fresh. Look at each.",
        ko="끝에서부터 거슬러 가다가 너무 오래된 것을 처음 만나면 멈춥니다. 메시지는 더 오래된 것을 앞지를 수 있으므로, 오래된 것보다 먼저 온 것이 아직 신선할 수 있습니다. 하나하나 모두 보십시오.",
    ),
)


LOST_NONE_OF_NONE = WrongAnswer(
    "nothing lost where nothing stays",
    partial(kept, lost="none where none is young"),
    Text(
        en='where nothing is worth keeping, "lost" is 0 for you. All that came have gone then: count them.',
        ko='남길 만한 것이 하나도 없으면 "lost"를 0으로 셉니다. 그때는 들어온 것이 모두 사라졌으니 그 수를 세십시오.',
    ),
)


LOST_BY_STAMP = WrongStep(
    "lost by stamp",
    {"lost": "what is not among the kept"},
    Text(
        en='of two messages with one stamp, one stays and one goes, and "lost" misses the latter: its stamp is among those that stayed, so `not in` does not see it go. Count messages: what came minus what stayed.',
        ko='시각이 같은 두 메시지 가운데 하나는 남고 하나는 사라지는데, "lost"가 사라진 것을 놓칩니다. 그 시각이 남은 것 가운데 있어서 `not in`으로는 보이지 않습니다. 들어온 수에서 남은 수를 빼 메시지를 세십시오.',
    ),
)


AGES_YOUNGEST_FIRST = WrongAnswer(
    "ages, the youngest first",
    partial(kept, out="ages, the youngest first"),
    Text(
        en="what stays is told by its age, the youngest first. Asked for are the stamps, and the oldest first.",
        ko="남은 것을 나이로, 그것도 어린 것부터 적었습니다. 필요한 것은 시각이고, 오래된 것부터입니다.",
    ),
)


AGE_TURNED_ROUND = WrongStep(
    "age turned round",
    {"age": "stamp minus now"},
    Text(
        en="your age is turned round: `stamp - now_s` is below 0 for all that was ever measured, and above it only for what comes from the future. An age is `now_s - stamp`.",
        ko="나이를 거꾸로 뺐습니다. `stamp - now_s`는 실제로 측정한 것에서는 언제나 0 이하이고 미래에서 온 것에서만 0보다 큽니다. 나이는 `now_s - stamp`입니다.",
    ),
    "M10",
)


LOST_NONE_WITHOUT_ROOM = WrongAnswer(
    "nothing lost without room",
    partial(kept, lost="none where there is no room"),
    Text(
        en='where `max_size` is 0, "lost" is 0 for you, too. All that came have gone then: count them.',
        ko='`max_size`가 0일 때 "lost"도 0입니다. 그때는 온 것이 모두 버려졌으니 세어야 합니다.',
    ),
)


TASK = Task(
    id="E9.5",
    kind="F",
    points=3,
    title=Text(en="A queue that stays fresh", ko="늘 신선한 큐"),
    answer="keep",
    form=Parts({"kept": Sequence(Number("s", 1e-6)), "lost": Number("", 1e-6)}),
    inputs=queues,
    variants=3,
    model=kept,
    mistakes=(
        KEEPS_THE_OLDEST,
        AGE_IGNORED,
        NOTHING_SIEVED,
        ALL_BUT_THE_NEWEST,
        SIZE_IGNORED,
        FUTURE_KEPT,
        AGE_BY_ITS_SIZE,
        NEWEST_FIRST,
        BY_PLACE,
        CUT_BY_PLACE,
        CUT_BEFORE_SIEVING,
        EVERYTHING_KEPT,
        COUNTED_WHAT_STAYED,
        AGE_LIMIT,
        NOW_LIMIT,
        SOME_FUTURE,
        EQUAL_MERGED,
        SIZE_ZERO,
        LOST_SIEVED,
        LOST_CUT,
        LOST_NONE,
        LOST_OLD,
        LOST_AHEAD,
        LOST_WITHOUT_THE_FUTURE,
        AGES,
        OLD_ONES_WANTED,
        AGE_IN_MILLISECONDS,
        STAMP_FOR_AGE,
        AGES_IN_WHOLE_SECONDS,
        AGE_BY_THE_NEWEST,
        AGE_BY_THE_NEWEST_OF_THE_PAST,
        ENDS_AT_THE_FIRST,
        AGES_ROUNDED,
        EVERYTHING_ROUNDED,
        REMOVED_IN_THE_LOOP,
        ONE_TOO_MANY,
        ONE_TOO_FEW,
        ONE_GOES,
        AHEAD_AS_NOW,
        ENDS_BACKWARDS,
        LOST_NONE_OF_NONE,
        LOST_BY_STAMP,
        AGES_YOUNGEST_FIRST,
        AGE_TURNED_ROUND,
        LOST_NONE_WITHOUT_ROOM,
    ),
    hints=(
        Text(
            en="Three sieves, one after the other: from the future, too old, too many.",
            ko="차례로 세 번 거르십시오. 미래에서 온 것, 너무 오래된 것, 너무 많은 것입니다.",
        ),
        Text(en="Sort by stamp before you count from the end.", ko="뒤에서부터 세기 전에 시각 순으로 정렬하십시오."),
        Text(
            en="`0 <= now_s - stamp <= max_age_s` for the first two; a slice from the end for the third. Lost is what came minus what stayed.",
            ko="앞의 둘은 `0 <= now_s - stamp <= max_age_s`, 셋째는 끝에서 자르기입니다. 버린 수는 들어온 수에서 남은 수를 뺀 것입니다.",
        ),
    ),
    misconceptions=("M10",),
)
