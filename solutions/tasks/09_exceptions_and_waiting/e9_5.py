"""E9.5: A queue that stays fresh."""

from __future__ import annotations

from tflab.workbook.tasks import Draws, Number, Parts, Sequence, define_task


def draw_queues(rng: Draws) -> list[tuple]:
    """Draw queues with and without free capacity, old messages, one from the future, and one out of order."""
    now = round(float(rng.uniform(20.0, 60.0)), 1)

    def before(*ages_s: float) -> list[float]:
        wobble = rng.uniform(0.0, 0.02, len(ages_s))
        return [round(now - age - float(w), 3) for age, w in zip(ages_s, wobble, strict=True)]

    return [
        (before(0.35, 0.25, 0.15, 0.05), now, 1.0, 2),
        (before(0.95, 0.75, 0.35, 0.15), now, 0.5, 3),
        (before(2.4, 1.7, 0.9), now, 0.5, 3),
        (before(0.3, 0.2, 0.1), now, 0.5, 5),
        (before(0.4, 0.3, 0.2, -0.4), now, 0.5, 1),  # in rising order, capacity 1: no third mistake shows
        (before(0.15, 0.45, 0.25), now, 1.0, 2),
        ([], now, 0.5, 2),
        (before(0.3, 0.2, 0.1), now, 0.5, 0),  # capacity 0
        ([float(int(now) - 1), int(now) - 0.5, float(int(now))], float(int(now)), 0.5, 5),  # at both limits
        ([int(now) - 0.501, int(now) - 0.4995, int(now) + 5e-4, int(now) - 5e-4], float(int(now)), 0.5, 5),
        ([int(now) - 0.5005, int(now) + 0.005, int(now) - 0.005], float(int(now)), 0.5, 5),  # just past the bounds
        ([int(now) - 0.25, int(now) - 0.25, int(now) + 0.05], float(int(now)), 0.5, 5),  # two at once
        (before(0.3, -0.9, 0.2), now, 0.5, 5),  # further ahead than the limit
        (
            [int(now) - 0.25, int(now) - 0.25, int(now) - 0.05],
            float(int(now)),
            0.5,
            2,
        ),  # one of two equal stamps has to go
        (before(0.3, 0.9, 0.2, 0.1), now, 0.5, 5),  # one that is too old came late
        ([int(now) - 0.5, int(now) - 0.25], float(int(now)), 0.5, 5),  # at one limit alone
        ([int(now) - 0.25, float(int(now))], float(int(now)), 0.5, 5),  # at the other
        *(([int(now) - age], float(int(now)), 0.5, 5) for age in (0.9, 0.5, 0.0, -0.4)),  # one alone, of each sort
        ([3.0, 3.2, 3.45], 3.5, 0.4, 5),  # long before the others
        (before(0.9, 0.6, 0.3), now, 0.8, 5),
        (before(0.4, 0.25, 0.1), now, 0.2, 5),
        (before(0.45, 0.35, 0.25, 0.15, 0.05), now, 0.5, 4),
        (before(0.3, 0.1), now, 1.0, 1),  # capacity 1
        (before(0.25, 0.05, 0.15), now, 1.0, 5),  # out of order, capacity for all
        (
            [int(now) - 0.25, int(now) - 0.25, int(now) - 0.05],
            float(int(now)),
            0.5,
            5,
        ),  # capacity for both equal stamps
    ]


def kept(stamps_s, now_s, max_age_s, max_size, *, first="sieve", old="dropped", ahead="dropped", order="by stamp",
         size="newest", out="oldest first", lost="went", loop="a new list", age="now minus stamp") -> dict:  # fmt: skip
    """Return what a policy keeps, step by step; other arguments are mistakes."""
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


ANSWERS = {
    "everything kept": lambda *a: {"kept": list(a[0]), "lost": 0},
}

TASK = define_task(
    __file__,
    kind="F",
    points=3,
    answer="keep",
    form=Parts({"kept": Sequence(Number("s", 1e-6)), "lost": Number("", 1e-6)}),
    inputs=draw_queues,
    variants=3,
    model=kept,
    answers=ANSWERS,
)
