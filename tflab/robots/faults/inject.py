"""Inject faults into a recording and return the diagnosis.

    inject(records, Fault.GAP, seed=3)  ->  Injection(records, diagnosis)
    inject_all(records, [Fault.GAP, Fault.LOOP], seed=3)  ->  (records, [diagnosis, diagnosis])

The input is not changed. The seed decides the edge, the time and the amount; `aim` selects
the edge by its child (`aim="base_footprint"`). The same seed makes the same fault. Not every
stream can have every fault: `possible_faults` lists those it can have.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from tflab.core.transforms import TransformRecord

from ..seeded_rng import seeded_rng
from . import broken_samples, broken_tree
from .catalogue import Diagnosis, Fault
from .streams import CannotInject, Injection, InjectionTarget, Stream, edges_of

__all__ = ["INJECTORS", "CannotInject", "Injection", "inject", "inject_all", "possible_faults"]

INJECTORS: dict[Fault, Callable[[InjectionTarget], Injection]] = {
    Fault.REPARENTED: broken_tree.reparent,
    Fault.SECOND_OWNER: broken_tree.second_owner,
    Fault.DUPLICATE_STAMPS: broken_samples.duplicate_stamps,
    Fault.OUT_OF_ORDER: broken_samples.out_of_order,
    Fault.ZERO_QUATERNION: broken_samples.zero_quaternion,
    Fault.NAN: broken_samples.nan,
    Fault.NON_UNIT_QUATERNION: broken_samples.non_unit_quaternion,
    Fault.MISSING_EDGE: broken_tree.remove_edge,
    Fault.LOOP: broken_tree.close_loop,
    Fault.LEADING_SLASH: broken_tree.leading_slash,
    Fault.CLOCK_JUMPED_BACK: broken_samples.clock_back,
    Fault.CLOCK_OFFSET: broken_samples.clock_offset,
    Fault.STATIC_ON_TF: broken_tree.static_on_tf,
    Fault.MOVING_ON_TF_STATIC: broken_tree.moving_on_tf_static,
    Fault.NO_TF_STATIC: broken_tree.no_tf_static,
    Fault.GAP: broken_samples.gap,
    Fault.WRONG_NAME: broken_tree.wrong_name,
    Fault.OPTICAL_IDENTITY: broken_samples.optical_identity,
    Fault.LATE_STAMPS: broken_samples.late,
    Fault.EARLY_STAMPS: broken_samples.early,
}


def inject(records: Sequence[TransformRecord], fault: Fault | str, seed: int = 0, *, aim: str = "") -> Injection:
    """Return `records` with one fault more.

    Args:
        aim: the child of the edge that is to have it; chance chooses if "".

    Raises:
        CannotInject: nothing in the stream, or not this edge, can have this fault.
        ValueError: no such fault, or no such edge.
    """
    fault = Fault(fault)
    if aim and aim not in edges_of(records):
        raise ValueError(f"nobody sends {aim!r} as a child; there is {', '.join(edges_of(records))}")
    target = InjectionTarget(list(records), edges_of(records), seeded_rng(seed, fault), aim)
    return INJECTORS[fault](target)


def inject_all(
    records: Sequence[TransformRecord], faults: Iterable[Fault | str], seed: int = 0
) -> tuple[Stream, list[Diagnosis]]:
    """Return `records` with several faults, put in one after the other, and all their diagnoses."""
    stream, diagnoses = list(records), []
    for fault in faults:
        stream, diagnosis = inject(stream, fault, seed)
        diagnoses.append(diagnosis)
    return stream, diagnoses


def possible_faults(records: Sequence[TransformRecord]) -> list[Fault]:
    """Return the faults that this stream can have, in the order of the catalogue."""
    possible = []
    for fault in Fault:
        try:
            inject(records, fault)
        except CannotInject:
            continue
        possible.append(fault)
    return possible
