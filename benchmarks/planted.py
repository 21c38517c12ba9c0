"""Faults that are not in the catalogue: of rates, beginnings, single topics, and of everything at once.

    PLANTS[name](recording, seed)  ->  (broken recording, what was done)

`tflab.robots.faults` breaks streams of transforms; here the other topics break,
too.  The seed decides where, when and how much.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tflab.bags.recording import Headers, Recording, recording_from_records
from tflab.core import StampedTransform, Transform
from tflab.core.transforms import TransformRecord
from tflab.robots.faults.inject import CannotInject

__all__ = ["CODES_OF_PLANT", "PLANTS", "with_records", "with_transforms_of_odometry"]

SECOND_NS = 1_000_000_000
FEWEST = 20  # samples

CODES_OF_PLANT = {
    "low-rate": ("slow-edge",),
    "late-edge": ("late-start",),
    "stall-of-all": ("stall",),
    "tf-stall": ("tf-silent", "stall"),  # a recording without other topics cannot tell them apart
    "one-clock-off": ("late-stamps", "early-stamps", "time-uptime", "time-date"),
    "case-of-a-name": ("name-case",),
    "prefix-of-a-name": ("name-prefix",),
    "sensor-frame-unknown": ("unknown-frame", "unknown-world-frame", "name-case", "name-slip", "name-prefix"),
    "sensor-stamped-ahead": ("messages-early",),
    "sensor-stamped-late": ("messages-late",),
    "one-future-stamp": ("future-stamp",),
}


def with_records(recording: Recording, records: list[TransformRecord]) -> Recording:
    """Return a recording with other transforms, and everything else as it was."""
    made = recording_from_records(sorted(records, key=lambda record: record.receive_ns), recording.name)
    return replace(recording, transforms=made.transforms)


def with_transforms_of_odometry(recording: Recording) -> Recording:
    """Return a recording without moving transforms with those that its odometry tells, at its own times."""
    moving = any(not label.is_static for label in recording.transforms.labels)
    if moving or not recording.odometry:
        return recording
    odometry = recording.odometry[0]
    heard = next(header for header in recording.headers if header.topic == odometry.topic)
    child = odometry.child or "base_footprint"
    records = [
        TransformRecord("/tf", receive_ns, "", StampedTransform(odometry.frame, child, stamp_ns, _pose(row)), False)
        for receive_ns, stamp_ns, row in zip(
            heard.receive_ns.tolist(), odometry.stamp_ns.tolist(), odometry.numbers.tolist(), strict=True
        )
    ]
    return with_records(recording, [*recording.records(), *records])


def _pose(row: list[float]) -> Transform:
    return Transform(tuple(row[:3]), tuple(row[3:]))


def _moving(records: list[TransformRecord]) -> dict[str, list[int]]:
    """Return where the samples of each moving edge are, by child."""
    places: dict[str, list[int]] = {}
    for place, record in enumerate(records):
        if not record.is_static:
            places.setdefault(record.stamped.child_frame_id, []).append(place)
    return {
        child: where
        for child, where in sorted(places.items())
        if len(where) >= FEWEST
        and any(records[p].stamped.transform != records[where[0]].stamped.transform for p in where)
    }


def _pick(rng: np.random.Generator, things, otherwise: str):
    things = list(things)
    if not things:
        raise CannotInject(f"it needs {otherwise}")
    return things[int(rng.integers(len(things)))]


def _moving_by_chance(recording: Recording, rng: np.random.Generator) -> tuple[list[TransformRecord], str, list[int]]:
    records = recording.records()
    moving = _moving(records)
    child = _pick(rng, moving, "a moving edge")
    return records, child, moving[child]


def _low_rate(recording: Recording, rng: np.random.Generator):
    records, child, places = _moving_by_chance(recording, rng)
    heard = [records[place].receive_ns for place in places]
    if heard[-1] - heard[0] < 12 * SECOND_NS or np.median(np.diff(heard)) > 0.25 * SECOND_NS:
        raise CannotInject("it needs a recording of 12 s, and an edge that is fast")
    period_ns = SECOND_NS
    kept, next_ns = set(), 0
    for place in places:
        if records[place].receive_ns >= next_ns:
            kept.add(place)
            next_ns = records[place].receive_ns + period_ns
    gone = set(places) - kept
    return [r for i, r in enumerate(records) if i not in gone], f"{child} at 1 Hz"


def _late_edge(recording: Recording, rng: np.random.Generator):
    records, child, places = _moving_by_chance(recording, rng)
    others = [place for place, record in enumerate(records) if not record.is_static and place not in set(places)]
    if not others and not recording.headers:
        raise CannotInject("it needs somebody who began in time")
    heard = [records[place].receive_ns for place in places]
    late_ns = min(round(rng.uniform(2.0, 6.0) * SECOND_NS), (heard[-1] - heard[0]) // 2)
    if late_ns < 1.5 * SECOND_NS:
        raise CannotInject("it needs a longer recording")
    gone = {place for place in places if records[place].receive_ns < heard[0] + late_ns}
    return [r for i, r in enumerate(records) if i not in gone], f"{child} begins {late_ns / 1e9:.1f} s late"


def _one_clock_off(recording: Recording, rng: np.random.Generator):
    records, child, places = _moving_by_chance(recording, rng)
    others = [header for header in recording.headers if len(header.stamp_ns) >= FEWEST]
    if len(_moving(records)) < 2 and not others:
        raise CannotInject("it needs somebody to compare with")
    is_localiser = any(records[place].stamped.frame_id.rpartition("/")[2] == "map" for place in places)
    off_s = -rng.uniform(0.5, 20.0) if is_localiser or rng.random() < 0.5 else rng.uniform(0.5, 20.0)
    for place in places:
        stamped = records[place].stamped
        records[place] = records[place]._replace(
            stamped=replace(stamped, stamp_ns=stamped.stamp_ns + round(off_s * 1e9))
        )
    if min(records[place].stamped.stamp_ns for place in places) <= 0:
        raise CannotInject("the stamps would be before zero")
    return records, f"{child} is off by {off_s:+.3f} s"


def _one_future_stamp(recording: Recording, rng: np.random.Generator):
    records, child, places = _moving_by_chance(recording, rng)
    place = places[int(rng.uniform(0.2, 0.7) * len(places))]
    stamped = records[place].stamped
    ahead_ns = round(rng.uniform(20.0, 4000.0) * 1e9)
    records[place] = records[place]._replace(stamped=replace(stamped, stamp_ns=stamped.stamp_ns + ahead_ns))
    return records, f"one sample of {child} is {ahead_ns / 1e9:.0f} s ahead"


def _renamed(recording: Recording, rng: np.random.Generator, spell: Callable[[str], str]):
    records = recording.records()
    children = {record.stamped.child_frame_id for record in records}
    parents = {record.stamped.frame_id for record in records}
    child = _pick(rng, sorted(children & parents), "a frame with others above and below it")
    wrong = spell(child)
    if wrong == child:
        raise CannotInject("the name is written so already")
    role = "child_frame_id" if rng.random() < 0.5 else "frame_id"
    below = _pick(rng, sorted({r.stamped.child_frame_id for r in records if r.stamped.frame_id == child}), "a child")
    for place, record in enumerate(records):
        is_it = record.stamped.child_frame_id == (child if role == "child_frame_id" else below)
        if is_it and getattr(record.stamped, role) == child:
            records[place] = record._replace(stamped=replace(record.stamped, **{role: wrong}))
    return records, f"{child} is called {wrong} as {role}"


def _case_of_a_name(recording: Recording, rng: np.random.Generator):
    return _renamed(recording, rng, lambda name: name.upper() if rng.random() < 0.5 else name.replace("_", ""))


def _prefix_of_a_name(recording: Recording, rng: np.random.Generator):
    return _renamed(recording, rng, lambda name: ("robot2_" if rng.random() < 0.5 else "r2/") + name)


def _silence(recording: Recording, rng: np.random.Generator) -> tuple[int, int]:
    records = recording.records()
    moving = _moving(records)
    if not moving:
        raise CannotInject("it needs a moving edge")
    heard = [records[place].receive_ns for places in moving.values() for place in places]
    length_ns = max(heard) - min(heard)
    silence_ns = min(round(rng.uniform(1.0, 3.0) * SECOND_NS), length_ns // 4)
    slowest_ns = max(np.median(np.diff([records[p].receive_ns for p in places])) for places in moving.values())
    if silence_ns < max(0.6 * SECOND_NS, 12 * slowest_ns):
        raise CannotInject("it needs a longer recording")
    begin_ns = min(heard) + round(rng.uniform(0.3, 0.6) * length_ns)
    return begin_ns, begin_ns + silence_ns


def _without(header: Headers, begin_ns: int, end_ns: int) -> Headers:
    kept = (header.receive_ns < begin_ns) | (header.receive_ns >= end_ns)
    columns = {name: getattr(header, name)[kept] for name in ("receive_ns", "stamp_ns", "frame")}
    return header._replace(**columns)


def _tf_stall(recording: Recording, rng: np.random.Generator):
    begin_ns, end_ns = _silence(recording, rng)
    if len(_moving(recording.records())) < 2:
        raise CannotInject("of one edge it is a gap")
    left = [r for r in recording.records() if r.is_static or not begin_ns <= r.receive_ns < end_ns]
    return left, f"/tf is silent for {(end_ns - begin_ns) / 1e9:.2f} s"


def _stall_of_all(recording: Recording, rng: np.random.Generator):
    begin_ns, end_ns = _silence(recording, rng)
    sources = len(_moving(recording.records())) + sum(len(h.stamp_ns) >= FEWEST for h in recording.headers)
    if sources < 2:
        raise CannotInject("of one edge it is a gap")
    left = [r for r in recording.records() if r.is_static or not begin_ns <= r.receive_ns < end_ns]
    headers = tuple(_without(header, begin_ns, end_ns) for header in recording.headers)
    return replace(with_records(recording, left), headers=headers), f"silence of {(end_ns - begin_ns) / 1e9:.2f} s"


def _sensor(recording: Recording, rng: np.random.Generator) -> tuple[int, Headers]:
    wanted = ("LaserScan", "Imu", "PointCloud2", "Image", "Odometry")
    known = {frame for r in recording.records() for frame in (r.stamped.frame_id, r.stamped.child_frame_id)}
    choice = [
        (place, header)
        for place, header in enumerate(recording.headers)
        if header.msgtype.endswith(wanted) and len(header.stamp_ns) >= FEWEST and set(header.frames) <= known
    ]
    return _pick(rng, choice, "a sensor in a known frame")


def _with_header(recording: Recording, place: int, header: Headers) -> Recording:
    return replace(recording, headers=(*recording.headers[:place], header, *recording.headers[place + 1 :]))


def _sensor_frame_unknown(recording: Recording, rng: np.random.Generator):
    if not any(label.is_static for label in recording.transforms.labels):
        raise CannotInject("it needs a recording that lacks nothing")
    place, header = _sensor(recording, rng)
    name = str(rng.choice(["lidar_front", "sensor_frame", "velodyne", "imu0"]))
    return _with_header(
        recording, place, header._replace(frames=(name,) * len(header.frames))
    ), f"{header.topic}: {name}"


def _sensor_off(recording: Recording, rng: np.random.Generator, off_s: float):
    place, header = _sensor(recording, rng)
    off = header._replace(stamp_ns=header.stamp_ns + round(off_s * 1e9))
    return _with_header(recording, place, off), f"{header.topic} is off by {off_s:+.3f} s"


def _plant(how: Callable) -> Callable:
    def plant(recording: Recording, seed: int) -> tuple[Recording, str]:
        made, detail = how(recording, np.random.default_rng([seed, *how.__name__.encode()]))
        return (made if isinstance(made, Recording) else with_records(recording, made)), detail

    return plant


def _sensor_stamped_ahead(recording: Recording, rng: np.random.Generator):
    return _sensor_off(recording, rng, rng.uniform(0.3, 3.0))


def _sensor_stamped_late(recording: Recording, rng: np.random.Generator):
    return _sensor_off(recording, rng, -rng.uniform(0.7, 5.0))


PLANTS: dict[str, Callable] = {
    "low-rate": _plant(_low_rate),
    "late-edge": _plant(_late_edge),
    "stall-of-all": _plant(_stall_of_all),
    "tf-stall": _plant(_tf_stall),
    "one-clock-off": _plant(_one_clock_off),
    "case-of-a-name": _plant(_case_of_a_name),
    "prefix-of-a-name": _plant(_prefix_of_a_name),
    "sensor-frame-unknown": _plant(_sensor_frame_unknown),
    "sensor-stamped-ahead": _plant(_sensor_stamped_ahead),
    "sensor-stamped-late": _plant(_sensor_stamped_late),
    "one-future-stamp": _plant(_one_future_stamp),
}
