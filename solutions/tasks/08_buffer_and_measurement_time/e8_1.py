"""E8.1: How fresh is "latest"?"""

from __future__ import annotations

from tflab.workbook.tasks import Number, define_task

PATH = ("map -> odom", "odom -> base_link")


def lanes(rng):
    """Draw until the age of the answer, and the span of the first lane, are near no other time or span."""
    while True:
        given = _draw_edges(rng)
        newest = [given["newest_s"][edge] for edge in PATH]
        oldest = [given["oldest_s"][edge] for edge in PATH]
        first_s = min(given["oldest_s"].values())
        age_s, span_s = given["clock_s"] - min(newest), newest[0] - oldest[0]
        spans = (min(newest) - max(oldest), min(newest) - first_s, max(newest) - first_s)
        far_s = [abs(age_s - other_s) for other_s in (*newest, *oldest, sum(newest) / 2, 0.12)]
        if min(*far_s, *(abs(span_s - other_s) for other_s in spans)) > 0.02:
            return given


def _draw_edges(rng):
    map_s, odom_s = sorted(rng.uniform(6.0, 9.0, 2).round(2).tolist(), key=lambda _: rng.random())
    if abs(map_s - odom_s) < 0.2:
        odom_s = round(odom_s + 0.3, 2)
    arm_s = round(min(map_s, odom_s) - float(rng.uniform(0.3, 1.0)), 2)
    lift_s = round(max(map_s, odom_s) + 0.04, 2) if rng.random() < 0.5 else round(arm_s - 0.2, 2)
    starts = (1.0 + 0.4 * rng.permutation(5)[:4] + rng.uniform(0.0, 0.1, 4)).round(2).tolist()
    names = ("map -> odom", "odom -> base_link", "base_link -> arm_link", "base_link -> lift_link")
    return {
        "oldest_s": dict(zip(names, starts, strict=True)),
        "newest_s": dict(zip(names, (map_s, odom_s, arm_s, lift_s), strict=True)),
        "static": ["base_link -> laser_frame, sent at 0.12"],
        "clock_s": round(max(map_s, odom_s) + 0.17, 2),
    }


def latest_common_time(g, *, lanes="the path", end="newest", which="common", told="time"):
    """Return the time, step by step; other arguments are mistakes."""
    edges = {"the path": PATH, "all": list(g.newest_s), "and the static one": PATH, "map alone": PATH[:1]}[lanes]
    rows = [(g.newest_s if end == "newest" else g.oldest_s)[edge] for edge in edges]
    rows += [0.12] if lanes == "and the static one" else []
    ends = {"latest": max(rows), "earliest": min(rows), "mean": sum(rows) / len(rows)}
    stamp_s = ends.get(which, min(rows) if end == "newest" else max(rows))
    return g.clock_s - stamp_s if told == "age" else stamp_s


ANSWERS = {
    "now": lambda g: g.clock_s,
    "span of the common time": lambda g: (
        min(g.newest_s[edge] for edge in PATH) - max(g.oldest_s[edge] for edge in PATH)
    ),
    "span of one lane": lambda g: g.newest_s[PATH[0]] - g.oldest_s[PATH[0]],
    "span of all samples": lambda g: max(g.newest_s.values()) - min(g.oldest_s.values()),
    "counted from the start": lambda g: min(g.newest_s[edge] for edge in PATH) - min(g.oldest_s.values()),
    "age of the newest": lambda g: g.clock_s - max(g.newest_s.values()),
    "middle of the common time": lambda g: (
        (min(g.newest_s[edge] for edge in PATH) + max(g.oldest_s[edge] for edge in PATH)) / 2
    ),
    "gap of the newest": lambda g: abs(g.newest_s[PATH[0]] - g.newest_s[PATH[1]]),
}

TASK = define_task(
    __file__,
    kind="N",
    points=2,
    answer="latest_common_s",
    form=Number(unit="s", tolerance=0.005),
    given=lanes,
    variants=6,
    model=latest_common_time,
    answers=ANSWERS,
)
