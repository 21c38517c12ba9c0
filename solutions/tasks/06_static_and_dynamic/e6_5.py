"""E6.5: Six extracts from a log."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

CAUSES = (
    "several messages", "publisher gone", "no board", "moving frame not sent", "mount on /tf",
    "moving frame on /tf_static", "misspelt name",
)  # fmt: skip
REMEDIES = (
    "send one list", "keep it running", "offer TRANSIENT_LOCAL", "keep sending at rest",
    "send it on /tf_static", "send it on /tf", "wait longer", "send it faster", "correct the name",
)  # fmt: skip

RIGHT = {
    "a": "mount on /tf",
    "a do": "send it on /tf_static",
    "b": "no board",
    "b do": "offer TRANSIENT_LOCAL",
    "c": "moving frame on /tf_static",
    "c do": "send it on /tf",
    "d": "several messages",
    "d do": "send one list",
    "e": "moving frame not sent",
    "e do": "keep sending at rest",
    "f": "publisher gone",
    "f do": "keep it running",
}
DO = tuple(part for part in RIGHT if part.endswith(" do"))


def unknown(frame):
    return f'"{frame}" passed to lookupTransform argument source_frame does not exist. '


def future(asked_s, newest_s, target, source):
    return (
        f"Lookup would require extrapolation into the future.  Requested time {asked_s:.6f} but the latest data is at "
        f"time {newest_s:.6f}, when looking up transform from frame [{source}] to frame [{target}]"
    )


def draw_extracts(rng):
    """Return six extracts, each of another robot; names and numbers are drawn."""
    sensors = [str(name) for name in rng.permutation(["camera", "radar", "sonar", "thermal", "stereo", "depth"])]
    mover, lift = (str(name) for name in rng.permutation(["lift_link", "mast_link", "fork_link", "gripper_link"])[:2])
    now = round(float(rng.uniform(40.0, 90.0)), 1)
    gap, late = round(float(rng.uniform(0.25, 0.75)), 2), round(float(rng.uniform(2.0, 9.0)), 1)
    cams = [f"{sensors[0]}_{number}" for number in range(1, int(rng.integers(3, 6)) + 1)]
    heights = sorted(round(float(h), 2) for h in rng.uniform(0.1, 0.9, 3))
    bolt, driver, stopped = (f"{sensors[place]}_link" for place in (1, 2, 3))
    lines = {
        "a": [
            future(now, now - gap, "odom", bolt),
            f"odom -> base_link: /tf, 50 Hz.  base_link -> {bolt}: /tf, 1 Hz, always the same numbers.",
        ],
        "b": [
            f"[{sensors[2]}_driver]: New subscription discovered on topic '/tf_static', requesting incompatible QoS. "
            "No messages will be sent to it. Last incompatible policy: DURABILITY",
            unknown(driver),
        ],
        "c": [
            "No error in any log.",
            f"base_link -> {lift}, height asked for three moments: {heights[2]} m, {heights[2]} m, {heights[2]} m.",
            f"A camera saw it at these moments at {heights[0]} m, {heights[1]} m, {heights[2]} m.",
        ],
        "d": [
            unknown(cams[0]),
            f"/tf_static: Publisher count: 1, TRANSIENT_LOCAL.  The first listener knows {', '.join(cams)}.",
            f"A listener that was started later knows {cams[-1]}.",
        ],
        "e": [
            future(now, round(now - late, 1), "base_link", mover),
            f"base_link -> {mover}: /tf, 20 Hz until {now - late:.1f} s, when it reached its end, then nothing.",
        ],
        "f": [
            unknown(stopped),
            f"/tf_static: Publisher count: 0.  A listener that runs since the morning knows {stopped}.",
        ],
    }
    return {name: "\n".join(text) for name, text in lines.items()}


TASK = define_task(
    __file__,
    kind="D",
    points=5,
    answer="diagnosis",
    form=Parts({part: Choice(REMEDIES if part in DO else CAUSES) for part in RIGHT}),
    given=draw_extracts,
    variants=6,
)
