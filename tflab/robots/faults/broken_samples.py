"""Inject faults into the samples of an edge: invalid rotations, NaN, and wrong, late or missing stamps.

Each function takes a `Patient` and returns the stream with this fault, and its diagnosis.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tflab.core import NSEC_PER_SEC, Transform, quaternions

from .catalogue import Fault
from .streams import FEWEST_SAMPLES, CannotInject, Injection, Patient, StreamEdge, restamped

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


def _spoil(patient: Patient, fault: Fault, spoilt: Callable[[Transform], Transform], words: str) -> Injection:
    """Change the numbers of most samples of one edge."""
    edge = patient.pick(patient.edges.values(), "a transform")
    places = patient.tail(edge)
    share = 1.0 if edge.is_static else patient.between(0.3, 1.0)
    hit = [place for place in places if patient.rng.random() < share] or [places[0]]
    changes = {
        place: restamped(patient.records[place], transform=spoilt(patient.records[place].stamped.transform))
        for place in hit
    }
    detail = f"{len(hit)} of {len(edge.places)} samples of {edge.parent} -> {edge.child} {words}"
    return patient.done(patient.changed(changes), fault, [edge], hit[0], detail)


def zero_quaternion(patient: Patient) -> Injection:
    def spoilt(transform: Transform) -> Transform:
        return Transform(transform.translation, (0.0, 0.0, 0.0, 0.0))

    return _spoil(patient, Fault.ZERO_QUATERNION, spoilt, "have the rotation (0, 0, 0, 0)")


def nan(patient: Patient) -> Injection:
    number = int(patient.rng.integers(7))

    def spoilt(transform: Transform) -> Transform:
        numbers = [*transform.translation, *transform.rotation]
        numbers[number] = math.nan
        return Transform(numbers[:3], numbers[3:])

    return _spoil(patient, Fault.NAN, spoilt, f"have NaN for {('x', 'y', 'z', 'qx', 'qy', 'qz', 'qw')[number]}")


def non_unit_quaternion(patient: Patient) -> Injection:
    length = patient.between(1.2, 2.5) if patient.rng.random() < 0.5 else patient.between(0.3, 0.85)

    def spoilt(transform: Transform) -> Transform:
        return Transform(transform.translation, tuple(length * part for part in transform.rotation))

    return _spoil(patient, Fault.NON_UNIT_QUATERNION, spoilt, f"have a quaternion of length {length:.2f}")


def optical_identity(patient: Patient) -> Injection:
    """The turn from a camera to its optical frame is left out."""

    def is_turned(edge: StreamEdge) -> bool:
        rotation = patient.records[edge.places[0]].stamped.transform.rotation
        return abs(abs(rotation[3]) - 1.0) > 1e-6

    edge = patient.pick(
        (e for e in patient.edges.values() if "optical" in e.child.lower() and is_turned(e)), "a frame called optical"
    )
    changes = {}
    for place in edge.places:
        flat = Transform(patient.records[place].stamped.transform.translation, quaternions.IDENTITY)
        changes[place] = restamped(patient.records[place], transform=flat)
    detail = f"{edge.child} has the axes of {edge.parent}"
    return patient.done(patient.changed(changes), Fault.OPTICAL_IDENTITY, [edge], edge.places[0], detail)


def duplicate_stamps(patient: Patient) -> Injection:
    """Samples are sent twice, or every other sample has the stamp of the one before."""
    edge = patient.pick_moving()
    places = patient.tail(edge)
    if patient.rng.random() < 0.5:
        quarter_ns = patient.period_ns(edge) // 4
        copies = [patient.records[p]._replace(receive_ns=patient.records[p].receive_ns + quarter_ns) for p in places]
        detail = f"every sample of {edge.parent} -> {edge.child} is sent twice"
        return patient.done([*patient.records, *copies], Fault.DUPLICATE_STAMPS, [edge], places[0], detail)
    changes = {}
    for before, after in zip(places[::2], places[1::2], strict=False):
        changes[after] = restamped(patient.records[after], stamp_ns=patient.records[before].stamped.stamp_ns)
    detail = f"every other sample of {edge.parent} -> {edge.child} has the stamp of the one before"
    return patient.done(patient.changed(changes), Fault.DUPLICATE_STAMPS, [edge], places[1], detail)


def out_of_order(patient: Patient) -> Injection:
    """Neighbours of one edge change places on the way."""
    edge = patient.pick_moving()
    places = patient.tail(edge)
    changes = {}
    for before, after in zip(places[::2], places[1::2], strict=False):
        if patient.rng.random() < 0.5 or not changes:
            changes[before] = patient.records[before]._replace(stamped=patient.records[after].stamped)
            changes[after] = patient.records[after]._replace(stamped=patient.records[before].stamped)
    detail = f"{len(changes) // 2} pairs of samples of {edge.parent} -> {edge.child} arrive in the wrong order"
    return patient.done(patient.changed(changes), Fault.OUT_OF_ORDER, [edge], min(changes), detail)


def clock_back(patient: Patient) -> Injection:
    """From some moment on, all moving edges live in the past."""
    if patient.aim:
        raise CannotInject("a clock that jumps back takes every moving edge with it: it cannot be aimed at one")
    edges = patient.moving()
    if not edges:
        raise CannotInject(f"this stream cannot have the fault: it needs a moving edge of {FEWEST_SAMPLES} samples")
    heard = [patient.records[place].receive_ns for edge in edges for place in edge.places]
    length_s = (max(heard) - min(heard)) / NSEC_PER_SEC
    back_ns = round(min(patient.between(2.0, 10.0), 0.3 * length_s) * NSEC_PER_SEC)
    since_ns = min(heard) + round(patient.between(0.4, 0.6) * length_s * NSEC_PER_SEC)
    changes = {}
    for place, record in enumerate(patient.records):
        if record.receive_ns >= since_ns and not record.is_static:
            changes[place] = restamped(record, stamp_ns=record.stamped.stamp_ns - back_ns)
    detail = f"all stamps step back by {back_ns / NSEC_PER_SEC:.3f} s"
    return patient.done(patient.changed(changes), Fault.CLOCK_JUMPED_BACK, edges, min(changes), detail)


def clock_offset(patient: Patient) -> Injection:
    """The computer of one publisher, not of all, has another time."""
    groups: dict[str, list[StreamEdge]] = {}
    for edge in patient.moving():
        groups.setdefault(edge.publisher or edge.child, []).append(edge)
    if len(groups) < 2:
        raise CannotInject("this stream cannot have the fault: it needs moving edges of two publishers to compare")
    named = [name for name in sorted(groups) if patient.aimed(groups[name])]
    edges = groups[patient.choose(named, "a moving edge")]
    places = sorted(place for edge in edges for place in edge.places)
    offset_ns = round(patient.between(1.0, 30.0) * NSEC_PER_SEC)
    earliest_ns = min(patient.records[place].stamped.stamp_ns for place in places)
    if patient.rng.random() < 0.5 and offset_ns < earliest_ns:  # a stamp before zero would be another fault
        offset_ns = -offset_ns
    changes = {
        place: restamped(patient.records[place], stamp_ns=patient.records[place].stamped.stamp_ns + offset_ns)
        for place in places
    }
    detail = (
        f"the clock that stamps {', '.join(edge.child for edge in edges)} is off by {offset_ns / NSEC_PER_SEC:+.3f} s"
    )
    return patient.done(patient.changed(changes), Fault.CLOCK_OFFSET, edges, places[0], detail)


def late(patient: Patient) -> Injection:
    """From some moment on, the samples of one edge arrive long after their stamps, sometimes more, sometimes less."""
    edge = patient.pick_moving()
    places = patient.tail(edge)
    delay_s = patient.between(0.3, 1.0)
    changes, heard_ns = {}, 0
    for place in places:
        record = patient.records[place]
        late_ns = round(delay_s * patient.between(0.7, 1.3) * NSEC_PER_SEC)
        heard_ns = max(heard_ns + 1, record.receive_ns + late_ns)  # a queue: nobody overtakes
        changes[place] = record._replace(receive_ns=heard_ns)
    detail = f"{edge.parent} -> {edge.child} arrives about {delay_s:.3f} s later than before"
    return patient.done(patient.changed(changes), Fault.LATE_STAMPS, [edge], places[0], detail)


def early(patient: Patient) -> Injection:
    """From some moment on, the samples of one edge are stamped ahead; not a localiser's, which may do so."""
    edge = patient.pick(
        (e for e in patient.moving() if e.parent.rpartition("/")[2] != "map"),
        "a moving edge that is not a child of map",
    )
    places = patient.tail(edge)
    ahead_ns = round(patient.between(0.3, 1.5) * NSEC_PER_SEC)
    changes = {
        place: restamped(patient.records[place], stamp_ns=patient.records[place].stamped.stamp_ns + ahead_ns)
        for place in places
    }
    detail = f"{edge.parent} -> {edge.child} is stamped {ahead_ns / NSEC_PER_SEC:.3f} s ahead"
    return patient.done(patient.changed(changes), Fault.EARLY_STAMPS, [edge], places[0], detail)


def gap(patient: Patient) -> Injection:
    """Nothing is heard for a while: of one edge, or of all that move."""
    edge = patient.pick_moving()
    edges = patient.moving() if patient.rng.random() < 0.3 and not patient.aim else [edge]
    period_ns = max(map(patient.period_ns, edges))
    heard = [patient.records[place].receive_ns for place in edge.places]
    silence_ns = min(max(NSEC_PER_SEC, 15 * period_ns), (heard[-1] - heard[0]) // 3)
    begin_ns = heard[0] + round(patient.between(0.3, 0.6) * (heard[-1] - heard[0]))
    names = {e.child for e in edges}
    silent = [
        place
        for place, record in enumerate(patient.records)
        if record.stamped.child_frame_id in names and begin_ns <= record.receive_ns < begin_ns + silence_ns
    ]
    if not silent:
        raise CannotInject("this stream cannot have the fault: it is silent already")
    left = [record for place, record in enumerate(patient.records) if place not in set(silent)]
    detail = f"{', '.join(sorted(names))}: silence of {silence_ns / NSEC_PER_SEC:.3f} s"
    return patient.done(left, Fault.GAP, edges, silent[0], detail)
