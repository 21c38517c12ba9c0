"""Inject faults into the samples of an edge: invalid rotations, NaN, and wrong, late or missing stamps.

Each function takes a `Patient` and returns the stream with this fault, and its diagnosis.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tflab.core import NSEC_PER_SEC, Transform, quaternions

from .catalogue import Fault
from .streams import FEWEST_SAMPLES, CannotInject, Injection, InjectionTarget, StreamEdge, restamped

__all__ = [
    "clock_back",
    "clock_offset",
    "duplicate_stamps",
    "early",
    "gap",
    "late",
    "nan",
    "non_unit_quaternion",
    "optical_identity",
    "out_of_order",
    "zero_quaternion",
]


def _spoil(target: InjectionTarget, fault: Fault, spoilt: Callable[[Transform], Transform], words: str) -> Injection:
    """Change the numbers of most samples of one edge."""
    edge = target.pick(target.edges.values(), "a transform")
    places = target.tail(edge)
    share = 1.0 if edge.is_static else target.between(0.3, 1.0)
    hit = [place for place in places if target.rng.random() < share] or [places[0]]
    changes = {
        place: restamped(target.records[place], transform=spoilt(target.records[place].stamped.transform))
        for place in hit
    }
    detail = f"{len(hit)} of {len(edge.places)} samples of {edge.parent} -> {edge.child} {words}"
    return target.done(target.changed(changes), fault, [edge], hit[0], detail)


def zero_quaternion(target: InjectionTarget) -> Injection:
    def spoilt(transform: Transform) -> Transform:
        return Transform(transform.translation, (0.0, 0.0, 0.0, 0.0))

    return _spoil(target, Fault.ZERO_QUATERNION, spoilt, "have the rotation (0, 0, 0, 0)")


def nan(target: InjectionTarget) -> Injection:
    number = int(target.rng.integers(7))

    def spoilt(transform: Transform) -> Transform:
        numbers = [*transform.translation, *transform.rotation]
        numbers[number] = math.nan
        return Transform(numbers[:3], numbers[3:])

    return _spoil(target, Fault.NAN, spoilt, f"have NaN for {('x', 'y', 'z', 'qx', 'qy', 'qz', 'qw')[number]}")


def non_unit_quaternion(target: InjectionTarget) -> Injection:
    length = target.between(1.2, 2.5) if target.rng.random() < 0.5 else target.between(0.3, 0.85)

    def spoilt(transform: Transform) -> Transform:
        return Transform(transform.translation, tuple(length * part for part in transform.rotation))

    return _spoil(target, Fault.NON_UNIT_QUATERNION, spoilt, f"have a quaternion of length {length:.2f}")


def optical_identity(target: InjectionTarget) -> Injection:
    """The turn from a camera to its optical frame is left out."""

    def is_turned(edge: StreamEdge) -> bool:
        rotation = target.records[edge.places[0]].stamped.transform.rotation
        return abs(abs(rotation[3]) - 1.0) > 1e-6

    edge = target.pick(
        (e for e in target.edges.values() if "optical" in e.child.lower() and is_turned(e)), "a frame called optical"
    )
    changes = {}
    for place in edge.places:
        flat = Transform(target.records[place].stamped.transform.translation, quaternions.IDENTITY)
        changes[place] = restamped(target.records[place], transform=flat)
    detail = f"{edge.child} has the axes of {edge.parent}"
    return target.done(target.changed(changes), Fault.OPTICAL_IDENTITY, [edge], edge.places[0], detail)


def duplicate_stamps(target: InjectionTarget) -> Injection:
    """Samples are sent twice, or every other sample has the stamp of the one before."""
    edge = target.pick_moving()
    places = target.tail(edge)
    if target.rng.random() < 0.5:
        quarter_ns = target.period_ns(edge) // 4
        copies = [target.records[p]._replace(receive_ns=target.records[p].receive_ns + quarter_ns) for p in places]
        detail = f"every sample of {edge.parent} -> {edge.child} is sent twice"
        return target.done([*target.records, *copies], Fault.DUPLICATE_STAMPS, [edge], places[0], detail)
    changes = {}
    for before, after in zip(places[::2], places[1::2], strict=False):
        changes[after] = restamped(target.records[after], stamp_ns=target.records[before].stamped.stamp_ns)
    detail = f"every other sample of {edge.parent} -> {edge.child} has the stamp of the one before"
    return target.done(target.changed(changes), Fault.DUPLICATE_STAMPS, [edge], places[1], detail)


def out_of_order(target: InjectionTarget) -> Injection:
    """Neighbours of one edge change places on the way."""
    edge = target.pick_moving()
    places = target.tail(edge)
    changes = {}
    for before, after in zip(places[::2], places[1::2], strict=False):
        if target.rng.random() < 0.5 or not changes:
            changes[before] = target.records[before]._replace(stamped=target.records[after].stamped)
            changes[after] = target.records[after]._replace(stamped=target.records[before].stamped)
    detail = f"{len(changes) // 2} pairs of samples of {edge.parent} -> {edge.child} arrive in the wrong order"
    return target.done(target.changed(changes), Fault.OUT_OF_ORDER, [edge], min(changes), detail)


def clock_back(target: InjectionTarget) -> Injection:
    """From some moment on, all moving edges live in the past."""
    if target.aim:
        raise CannotInject("a clock that jumps back takes every moving edge with it: it cannot be aimed at one")
    edges = target.moving()
    if not edges:
        raise CannotInject(f"this stream cannot have the fault: it needs a moving edge of {FEWEST_SAMPLES} samples")
    heard = [target.records[place].receive_ns for edge in edges for place in edge.places]
    length_s = (max(heard) - min(heard)) / NSEC_PER_SEC
    back_ns = round(min(target.between(2.0, 10.0), 0.3 * length_s) * NSEC_PER_SEC)
    since_ns = min(heard) + round(target.between(0.4, 0.6) * length_s * NSEC_PER_SEC)
    changes = {}
    for place, record in enumerate(target.records):
        if record.receive_ns >= since_ns and not record.is_static:
            changes[place] = restamped(record, stamp_ns=record.stamped.stamp_ns - back_ns)
    detail = f"all stamps step back by {back_ns / NSEC_PER_SEC:.3f} s"
    return target.done(target.changed(changes), Fault.CLOCK_JUMPED_BACK, edges, min(changes), detail)


def clock_offset(target: InjectionTarget) -> Injection:
    """The computer of one publisher, not of all, has another time."""
    groups: dict[str, list[StreamEdge]] = {}
    for edge in target.moving():
        groups.setdefault(edge.publisher or edge.child, []).append(edge)
    if len(groups) < 2:
        raise CannotInject("this stream cannot have the fault: it needs moving edges of two publishers to compare")
    named = [name for name in sorted(groups) if target.aimed(groups[name])]
    edges = groups[target.choose(named, "a moving edge")]
    places = sorted(place for edge in edges for place in edge.places)
    offset_ns = round(target.between(1.0, 30.0) * NSEC_PER_SEC)
    earliest_ns = min(target.records[place].stamped.stamp_ns for place in places)
    if target.rng.random() < 0.5 and offset_ns < earliest_ns:  # a stamp before zero would be another fault
        offset_ns = -offset_ns
    changes = {
        place: restamped(target.records[place], stamp_ns=target.records[place].stamped.stamp_ns + offset_ns)
        for place in places
    }
    detail = (
        f"the clock that stamps {', '.join(edge.child for edge in edges)} is off by {offset_ns / NSEC_PER_SEC:+.3f} s"
    )
    return target.done(target.changed(changes), Fault.CLOCK_OFFSET, edges, places[0], detail)


def late(target: InjectionTarget) -> Injection:
    """From some moment on, the samples of one edge arrive long after their stamps, sometimes more, sometimes less."""
    edge = target.pick_moving()
    places = target.tail(edge)
    delay_s = target.between(0.3, 1.0)
    changes, heard_ns = {}, 0
    for place in places:
        record = target.records[place]
        late_ns = round(delay_s * target.between(0.7, 1.3) * NSEC_PER_SEC)
        heard_ns = max(heard_ns + 1, record.receive_ns + late_ns)  # a queue: nobody overtakes
        changes[place] = record._replace(receive_ns=heard_ns)
    detail = f"{edge.parent} -> {edge.child} arrives about {delay_s:.3f} s later than before"
    return target.done(target.changed(changes), Fault.LATE_STAMPS, [edge], places[0], detail)


def early(target: InjectionTarget) -> Injection:
    """From some moment on, the samples of one edge are stamped ahead; not a localiser's, which may do so."""
    edge = target.pick(
        (e for e in target.moving() if e.parent.rpartition("/")[2] != "map"),
        "a moving edge that is not a child of map",
    )
    places = target.tail(edge)
    ahead_ns = round(target.between(0.3, 1.5) * NSEC_PER_SEC)
    changes = {
        place: restamped(target.records[place], stamp_ns=target.records[place].stamped.stamp_ns + ahead_ns)
        for place in places
    }
    detail = f"{edge.parent} -> {edge.child} is stamped {ahead_ns / NSEC_PER_SEC:.3f} s ahead"
    return target.done(target.changed(changes), Fault.EARLY_STAMPS, [edge], places[0], detail)


def gap(target: InjectionTarget) -> Injection:
    """Nothing is heard for a while: of one edge, or of all that move."""
    edge = target.pick_moving()
    edges = target.moving() if target.rng.random() < 0.3 and not target.aim else [edge]
    period_ns = max(map(target.period_ns, edges))
    heard = [target.records[place].receive_ns for place in edge.places]
    silence_ns = min(max(NSEC_PER_SEC, 15 * period_ns), (heard[-1] - heard[0]) // 3)
    begin_ns = heard[0] + round(target.between(0.3, 0.6) * (heard[-1] - heard[0]))
    names = {e.child for e in edges}
    silent = [
        place
        for place, record in enumerate(target.records)
        if record.stamped.child_frame_id in names and begin_ns <= record.receive_ns < begin_ns + silence_ns
    ]
    if not silent:
        raise CannotInject("this stream cannot have the fault: it is silent already")
    left = [record for place, record in enumerate(target.records) if place not in set(silent)]
    detail = f"{', '.join(sorted(names))}: silence of {silence_ns / NSEC_PER_SEC:.3f} s"
    return target.done(left, Fault.GAP, edges, silent[0], detail)
