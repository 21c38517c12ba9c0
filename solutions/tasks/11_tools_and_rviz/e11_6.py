"""E11.6: Parse the output of tf2_monitor."""

from __future__ import annotations

import re

from tflab.tools.tf2_monitor import Delays, NetDelay, broadcaster_line, frame_lines, results_heading
from tflab.workbook.tasks import Name, Number, Parts, Set, define_task

STATIC = ("base_link", "laser_frame", "camera_link", "imu_link", "mast")
MOVING = ("robot1/odom", "odom", "base_footprint", "arm_link", "pan_link", "left_wheel")


def draw_reports(rng):
    """Draw robots with one late frame: stamps from the future, a wrong clock, a long run."""
    usual = [make_report(rng, future=number) for number in (0, 1, 2)]
    usual.append(make_report(rng, future=0, only="laser_frame"))  # elsewhere another may be as old
    far_ahead = make_report(rng, future=1, early_s=1.2)  # earlier than anybody is late
    wrong_clock = make_report(rng, future=0, late_s=1.6e9 + float(rng.uniform(0.0, 9e7)))
    long_running = make_report(rng, future=1, looks=2000)
    spiky = make_report(rng, future=0, spike=True)
    at_once = make_report(rng, future=1, second_s=0.0)  # neither late nor early
    scientific = make_report(rng, future=0, second_s=2e-5)  # "2e-05": the minus belongs to the exponent
    ahead = make_report(rng, future=2, static_s=-round(float(rng.uniform(2.0, 5.0)), 1))  # mounts of a fast clock
    slow = make_report(rng, future=0, late_s=round(float(rng.uniform(10.5, 19.0)), 2))  # "4.2" comes after "14" as text
    restless = make_report(rng, future=2, once_s=0.1)  # ahead on average, and once late
    alike = make_report(rng, future=1, pair=("mast", "mast_top"))
    within = make_report(rng, future=1, pair=("base_link", "base"))
    others = [long_running, spiky, at_once, scientific, ahead, slow, restless, alike, within]
    return [*usual, far_ahead, wrong_clock, *others]


def make_report(
    rng,
    future,
    late_s=None,
    looks=21,
    spike=False,
    second_s=None,
    static_s=None,
    early_s=0.05,
    once_s=None,
    only="",
    pair=(),
):
    """Return a report's text and the names of the static frames."""
    statics = [STATIC[i] for i in rng.permutation(len(STATIC))[: int(rng.integers(1, 4))]]
    moving = [MOVING[i] for i in rng.permutation(len(MOVING))[: future + 2]]
    statics = [only] if only else statics
    if pair:  # the name of a static frame stands in that of a moving one, or the other way round
        statics = [pair[0], *[name for name in statics if name != pair[0]]]
        moving = [pair[1], *moving[1:]]
    late_s = round(float(rng.uniform(0.15, 0.9)), 3) if late_s is None else late_s
    delays_s = [late_s, round(late_s * 0.3, 4) if late_s < 1e6 else late_s * 0.3]
    delays_s[1] = delays_s[1] if second_s is None else second_s
    delays_s += [-round(float(rng.uniform(early_s, early_s + 0.35)), 3) for _ in range(future)]
    delays, net = Delays(), NetDelay()
    for frame, delay_s in zip(moving, delays_s, strict=True):
        for number in range(10):
            delays.add_message(50.0 + number, [(frame, 50.0 + number - delay_s)])
    if spike:  # the second is late on average, the first was once later
        delays.of_frame[moving[0]].extend([0.001] * 40)
    if once_s is not None:
        delays.of_frame[moving[-1]].append(once_s)
    static_s = round(float(rng.uniform(8.0, 60.0)), 1) if static_s is None else static_s
    for frame in statics:
        delays.add_message(50.0, [(frame, 50.0 - static_s)])
    for _ in range(looks):
        net.add(late_s + 0.01)
    chain = ["map", *rng.permutation(moving).tolist(), *statics]
    rows = [results_heading(chain, net), "", "Frames:", *frame_lines(delays, chain)]
    return "\n".join([*rows, "", "All Broadcasters:", broadcaster_line(delays)]), sorted(statics)


def read_figures(
    report, static_frames, *, keep="moving", late="largest max", ahead="moving", sign="average", net="max",
):  # fmt: skip
    """Return the three figures, step by step; other arguments are mistakes."""
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
        "largest max": lambda row: row[2],
        "largest average": lambda row: row[1],
        "smallest": lambda row: -row[2],
        "largest size": lambda row: abs(row[1]),
        "first": lambda row: -rows.index(row),
        "last": rows.index,
        "text": lambda row: texts[row[0]],
        "digits": lambda row: float(texts[row[0]].partition("e")[0]),
        "static": lambda row: (row[0] in static_frames, row[2]),
    }[late]
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


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="read_monitor",
    form=Parts({"late": Name(), "future": Set(Name()), "delay_s": Number("s", tolerance=1e-4)}),
    inputs=draw_reports,
    variants=3,
    model=read_figures,
)
