"""How do numbers break?  No rotation, not a number, no unit length, no turn where one belongs.

Each function takes a Patient and returns a stream that has this fault, with its
diagnosis.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tflab.core import Transform, quaternions

from .catalogue import Fault
from .patient import Injection, Patient
from .streams import StreamEdge, restamped

__all__ = ["nan", "non_unit_quaternion", "optical_identity", "zero_quaternion"]


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
