"""How is each fault made?  A recording in, a broken recording and the truth about it out.

    inject(records, Fault.GAP, seed=3)  ->  Injection(records, diagnosis)
    inject_all(records, [Fault.GAP, Fault.LOOP], seed=3)  ->  (records, [diagnosis, diagnosis])

The records that come in are not touched.  The seed decides which edge, when and
how much; the same seed makes the same fault.  Not every stream can have every
fault: without an optical frame there is none to leave unturned.  Then the error
says so, and `possible_faults` lists what a stream can have.

Each injector picks an edge (`streams.py`), changes its records, and writes down
what it did.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC, StampedTransform, Transform, quaternions
from tflab.core.records import TransformRecord

from .faults import Diagnosis, Fault
from .streams import Edge, Stream, edges_of, in_order, restamped

__all__ = ["CannotInject", "Injection", "inject", "inject_all", "possible_faults"]

FEWEST_SAMPLES = 20  # with fewer, a change halfway is hardly to be seen


class CannotInject(ValueError):
    """The stream has nothing that this fault could happen to."""


class Injection(NamedTuple):
    """A broken stream, and what is wrong with it."""

    records: Stream
    diagnosis: Diagnosis


def inject(records: Sequence[TransformRecord], fault: Fault | str, seed: int = 0) -> Injection:
    """Return `records` with one fault more.

    Raises:
        CannotInject: nothing in the stream can have this fault.
        ValueError: no such fault.
    """
    fault = Fault(fault)
    scene = _Scene(list(records), edges_of(records), np.random.default_rng([seed, list(Fault).index(fault)]))
    return INJECTORS[fault](scene)


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


class _Scene(NamedTuple):
    """What an injector works with: the stream, its edges, and chance."""

    records: Stream
    edges: dict[str, Edge]
    rng: np.random.Generator

    def pick(self, edges: Iterable[Edge], otherwise: str) -> Edge:
        """Return one of `edges` by chance, or raise CannotInject saying what is missing."""
        choice = list(edges)
        if not choice:
            raise CannotInject(f"this stream cannot have the fault: it needs {otherwise}")
        return choice[int(self.rng.integers(len(choice)))]

    def moving(self) -> list[Edge]:
        return [e for e in self.edges.values() if not e.is_static and e.varies and len(e.places) >= FEWEST_SAMPLES]

    def static(self) -> list[Edge]:
        return [edge for edge in self.edges.values() if edge.is_static]

    def pick_moving(self) -> Edge:
        return self.pick(self.moving(), f"a moving edge of at least {FEWEST_SAMPLES} samples")

    def between(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))

    def tail(self, edge: Edge) -> tuple[int, ...]:
        """Return the places of an edge from some moment in the middle on; of a static one, all."""
        return edge.places if edge.is_static else edge.places[int(len(edge.places) * self.between(0.25, 0.6)) :]

    def period_ns(self, edge: Edge) -> int:
        """Return the usual time between two samples of an edge, as they arrive."""
        heard = np.array([self.records[place].receive_ns for place in edge.places])
        return int(np.median(np.diff(heard)))

    def below(self, frame: str) -> set[str]:
        """Return a frame and everything under it."""
        family = {frame}
        while True:
            more = {edge.child for edge in self.edges.values() if edge.parent in family} - family
            if not more:
                return family
            family |= more

    def frames(self) -> list[str]:
        return sorted({edge.child for edge in self.edges.values()} | {edge.parent for edge in self.edges.values()})

    def changed(self, changes: dict[int, TransformRecord]) -> Stream:
        """Return the stream with some records replaced."""
        return [changes.get(place, record) for place, record in enumerate(self.records)]

    def done(
        self, records: Sequence[TransformRecord], fault: Fault, edges: Iterable[Edge], at: int, detail: str
    ) -> Injection:
        """Return the result; `at` is the place of the first record at fault."""
        frames = tuple(edge.child for edge in edges)
        return Injection(in_order(records), Diagnosis(fault, frames, self.records[at].receive_ns, detail))


# -- who is whose child ------------------------------------------------------


def _reparent(scene: _Scene) -> Injection:
    """From some moment on, a frame hangs under another parent."""
    choices = {}
    for edge in scene.edges.values():
        others = [name for name in scene.frames() if name != edge.parent and name not in scene.below(edge.child)]
        if others and (edge.is_static or len(edge.places) >= FEWEST_SAMPLES):
            choices[edge.child] = others
    edge = scene.pick((scene.edges[child] for child in choices), "an edge, and a frame that could be another parent")
    parent = choices[edge.child][int(scene.rng.integers(len(choices[edge.child])))]
    detail = f"{edge.child} moves from under {edge.parent} to under {parent}"
    if not edge.is_static:
        places = scene.tail(edge)
        changes = {place: restamped(scene.records[place], frame_id=parent) for place in places}
        return scene.done(scene.changed(changes), Fault.REPARENTED, [edge], places[0], detail)
    middle = scene.records[len(scene.records) // 2]
    again = restamped(scene.records[edge.places[-1]], frame_id=parent)._replace(receive_ns=middle.receive_ns)
    at = len(scene.records) // 2
    return scene.done([*scene.records, again], Fault.REPARENTED, [edge], at, detail)


def _second_owner(scene: _Scene) -> Injection:
    """Another node publishes the same edge, with other values, between the samples of the first."""
    edge = scene.pick_moving()
    places = scene.tail(edge)
    half_ns = scene.period_ns(edge) // 2
    off = Transform.from_rpy(yaw=scene.between(0.3, 1.0), translation=(scene.between(0.3, 1.0), 0.2, 0.0))
    owner = f"{edge.publisher}_2" if edge.publisher else ""
    lies = []
    for place in places:
        record = scene.records[place]
        lie = restamped(record, stamp_ns=record.stamped.stamp_ns + half_ns, transform=record.stamped.transform @ off)
        lies.append(lie._replace(receive_ns=record.receive_ns + half_ns, publisher=owner))
    detail = f"a second publisher of {edge.parent} -> {edge.child} says {off.translation[0]:.2f} m further"
    return scene.done([*scene.records, *lies], Fault.SECOND_OWNER, [edge], places[0], detail)


def _remove_edge(scene: _Scene) -> Injection:
    """An edge inside the tree is not there, so the tree falls in two."""
    parents = {edge.parent for edge in scene.edges.values()}
    mentions = [name for edge in scene.edges.values() for name in (edge.parent, edge.child)]
    edge = scene.pick(
        (e for e in scene.edges.values() if e.child in parents and mentions.count(e.parent) > 1),
        "an edge with others above and below it",
    )
    left = [record for record in scene.records if record.stamped.child_frame_id != edge.child]
    detail = f"nobody publishes {edge.parent} -> {edge.child}"
    return scene.done(left, Fault.MISSING_EDGE, [edge], 0, detail)


def _close_loop(scene: _Scene) -> Injection:
    """Somebody publishes the root as the child of one of its own descendants."""
    roots = [name for name in scene.frames() if name not in scene.edges and len(scene.below(name)) > 1]
    edge = scene.pick(
        (e for e in scene.moving() if any(e.child in scene.below(root) for root in roots)), "a moving edge under a root"
    )
    root = next(root for root in roots if edge.child in scene.below(root))
    places = scene.tail(edge)
    topic = scene.records[places[0]].topic
    backwards = []
    for place in places:
        record = scene.records[place]
        stamped = StampedTransform(edge.child, root, record.stamped.stamp_ns, record.stamped.transform.inverse())
        backwards.append(
            TransformRecord(topic, record.receive_ns, "/backwards" if record.publisher else "", stamped, False)
        )
    detail = f"{root} is published as a child of {edge.child}, which hangs below it"
    return scene.done([*scene.records, *backwards], Fault.LOOP, [edge], places[0], detail)


# -- names --------------------------------------------------------------------


def _leading_slash(scene: _Scene) -> Injection:
    """One publisher writes its frame names with a slash, as in ROS 1."""
    edge = scene.pick(
        (e for e in scene.edges.values() if not (e.parent.startswith("/") or e.child.startswith("/"))),
        "a name without one",
    )
    parent, child = f"/{edge.parent}", f"/{edge.child}"
    changes = {place: restamped(scene.records[place], frame_id=parent, child_frame_id=child) for place in edge.places}
    detail = f"{edge.parent} -> {edge.child} is published as {parent} -> {child}"
    return scene.done(scene.changed(changes), Fault.LEADING_SLASH, [edge], edge.places[0], detail)


def _wrong_name(scene: _Scene) -> Injection:
    """One publisher spells a frame differently from all others."""
    parents = {edge.parent for edge in scene.edges.values()}
    known_elsewhere = [
        (edge, role)
        for edge in scene.edges.values()
        for role in ("parent", "child")
        if (role == "child" and edge.child in parents)
        or (role == "parent" and (edge.parent in scene.edges or _is_shared(edge, scene)))
    ]
    if not known_elsewhere:
        raise CannotInject("this stream cannot have the fault: it needs a frame that two edges name")
    edge, role = known_elsewhere[int(scene.rng.integers(len(known_elsewhere)))]
    name = edge.parent if role == "parent" else edge.child
    spellings = {
        "case": name.title() if name.title() != name else name.lower(),
        "prefix": f"robot1/{name}",
        "letter": name[: len(name) // 2] + name[len(name) // 2 + 1 :] if len(name) > 2 else name + "s",
    }
    kind = list(spellings)[int(scene.rng.integers(len(spellings)))]
    wrong = spellings[kind]
    field = "frame_id" if role == "parent" else "child_frame_id"
    changes = {place: restamped(scene.records[place], **{field: wrong}) for place in edge.places}
    detail = f"wrong {kind}: {edge.parent} -> {edge.child} is published with {wrong} for {name}"
    return scene.done(scene.changed(changes), Fault.WRONG_NAME, [edge], edge.places[0], detail)


def _is_shared(edge: Edge, scene: _Scene) -> bool:
    return any(other.parent == edge.parent for other in scene.edges.values() if other is not edge)


# -- numbers ------------------------------------------------------------------


def _spoil(scene: _Scene, fault: Fault, spoilt: Callable[[Transform], Transform], words: str) -> Injection:
    """Change the numbers of most samples of one edge."""
    edge = scene.pick(scene.edges.values(), "a transform")
    places = scene.tail(edge)
    share = 1.0 if edge.is_static else scene.between(0.3, 1.0)
    hit = [place for place in places if scene.rng.random() < share] or [places[0]]
    changes = {
        place: restamped(scene.records[place], transform=spoilt(scene.records[place].stamped.transform))
        for place in hit
    }
    detail = f"{len(hit)} of {len(edge.places)} samples of {edge.parent} -> {edge.child} {words}"
    return scene.done(scene.changed(changes), fault, [edge], hit[0], detail)


def _zero_quaternion(scene: _Scene) -> Injection:
    def spoilt(transform: Transform) -> Transform:
        return Transform(transform.translation, (0.0, 0.0, 0.0, 0.0))

    return _spoil(scene, Fault.ZERO_QUATERNION, spoilt, "have the rotation (0, 0, 0, 0)")


def _nan(scene: _Scene) -> Injection:
    number = int(scene.rng.integers(7))

    def spoilt(transform: Transform) -> Transform:
        numbers = [*transform.translation, *transform.rotation]
        numbers[number] = math.nan
        return Transform(numbers[:3], numbers[3:])

    return _spoil(scene, Fault.NAN, spoilt, f"have NaN for {('x', 'y', 'z', 'qx', 'qy', 'qz', 'qw')[number]}")


def _non_unit_quaternion(scene: _Scene) -> Injection:
    length = scene.between(1.2, 2.5) if scene.rng.random() < 0.5 else scene.between(0.3, 0.85)

    def spoilt(transform: Transform) -> Transform:
        return Transform(transform.translation, tuple(length * part for part in transform.rotation))

    return _spoil(scene, Fault.NON_UNIT_QUATERNION, spoilt, f"have a quaternion of length {length:.2f}")


def _optical_identity(scene: _Scene) -> Injection:
    """The turn from a camera to its optical frame is left out."""

    def is_turned(edge: Edge) -> bool:
        rotation = scene.records[edge.places[0]].stamped.transform.rotation
        return abs(abs(rotation[3]) - 1.0) > 1e-6

    edge = scene.pick(
        (e for e in scene.edges.values() if "optical" in e.child.lower() and is_turned(e)), "a frame called optical"
    )
    changes = {}
    for place in edge.places:
        flat = Transform(scene.records[place].stamped.transform.translation, quaternions.IDENTITY)
        changes[place] = restamped(scene.records[place], transform=flat)
    detail = f"{edge.child} has the axes of {edge.parent}"
    return scene.done(scene.changed(changes), Fault.OPTICAL_IDENTITY, [edge], edge.places[0], detail)


# -- stamps -------------------------------------------------------------------


def _duplicate_stamps(scene: _Scene) -> Injection:
    """Samples are sent twice, or every other sample has the stamp of the one before."""
    edge = scene.pick_moving()
    places = scene.tail(edge)
    if scene.rng.random() < 0.5:
        quarter_ns = scene.period_ns(edge) // 4
        copies = [scene.records[p]._replace(receive_ns=scene.records[p].receive_ns + quarter_ns) for p in places]
        detail = f"every sample of {edge.parent} -> {edge.child} is sent twice"
        return scene.done([*scene.records, *copies], Fault.DUPLICATE_STAMPS, [edge], places[0], detail)
    changes = {}
    for before, after in zip(places[::2], places[1::2], strict=False):
        changes[after] = restamped(scene.records[after], stamp_ns=scene.records[before].stamped.stamp_ns)
    detail = f"every other sample of {edge.parent} -> {edge.child} has the stamp of the one before"
    return scene.done(scene.changed(changes), Fault.DUPLICATE_STAMPS, [edge], places[1], detail)


def _out_of_order(scene: _Scene) -> Injection:
    """Neighbours of one edge change places on the way."""
    edge = scene.pick_moving()
    places = scene.tail(edge)
    changes = {}
    for before, after in zip(places[::2], places[1::2], strict=False):
        if scene.rng.random() < 0.5 or not changes:
            changes[before] = scene.records[before]._replace(stamped=scene.records[after].stamped)
            changes[after] = scene.records[after]._replace(stamped=scene.records[before].stamped)
    detail = f"{len(changes) // 2} pairs of samples of {edge.parent} -> {edge.child} arrive in the wrong order"
    return scene.done(scene.changed(changes), Fault.OUT_OF_ORDER, [edge], min(changes), detail)


def _clock_back(scene: _Scene) -> Injection:
    """From some moment on, all moving edges live in the past."""
    edges = scene.moving()
    if not edges:
        raise CannotInject(f"this stream cannot have the fault: it needs a moving edge of {FEWEST_SAMPLES} samples")
    heard = [scene.records[place].receive_ns for edge in edges for place in edge.places]
    length_s = (max(heard) - min(heard)) / NSEC_PER_SEC
    back_ns = round(min(scene.between(2.0, 10.0), 0.3 * length_s) * NSEC_PER_SEC)
    since_ns = min(heard) + round(scene.between(0.4, 0.6) * length_s * NSEC_PER_SEC)
    changes = {}
    for place, record in enumerate(scene.records):
        if record.receive_ns >= since_ns and not record.is_static:
            changes[place] = restamped(record, stamp_ns=record.stamped.stamp_ns - back_ns)
    detail = f"all stamps step back by {back_ns / NSEC_PER_SEC:.3f} s"
    return scene.done(scene.changed(changes), Fault.CLOCK_JUMPED_BACK, edges, min(changes), detail)


def _clock_offset(scene: _Scene) -> Injection:
    """The computer of one publisher, not of all, has another time."""
    groups: dict[str, list[Edge]] = {}
    for edge in scene.moving():
        groups.setdefault(edge.publisher or edge.child, []).append(edge)
    if len(groups) < 2:
        raise CannotInject("this stream cannot have the fault: it needs moving edges of two publishers to compare")
    edges = groups[sorted(groups)[int(scene.rng.integers(len(groups)))]]
    places = sorted(place for edge in edges for place in edge.places)
    offset_ns = round(scene.between(1.0, 30.0) * NSEC_PER_SEC)
    earliest_ns = min(scene.records[place].stamped.stamp_ns for place in places)
    if scene.rng.random() < 0.5 and offset_ns < earliest_ns:  # a stamp before zero would be another fault
        offset_ns = -offset_ns
    changes = {
        place: restamped(scene.records[place], stamp_ns=scene.records[place].stamped.stamp_ns + offset_ns)
        for place in places
    }
    detail = (
        f"the clock that stamps {', '.join(edge.child for edge in edges)} is off by {offset_ns / NSEC_PER_SEC:+.3f} s"
    )
    return scene.done(scene.changed(changes), Fault.CLOCK_OFFSET, edges, places[0], detail)


def _late(scene: _Scene) -> Injection:
    """From some moment on, the samples of one edge arrive long after their stamps, sometimes more, sometimes less."""
    edge = scene.pick_moving()
    places = scene.tail(edge)
    delay_s = scene.between(0.3, 1.0)
    changes, heard_ns = {}, 0
    for place in places:
        record = scene.records[place]
        late_ns = round(delay_s * scene.between(0.7, 1.3) * NSEC_PER_SEC)
        heard_ns = max(heard_ns + 1, record.receive_ns + late_ns)  # a queue: nobody overtakes
        changes[place] = record._replace(receive_ns=heard_ns)
    detail = f"{edge.parent} -> {edge.child} arrives about {delay_s:.3f} s later than before"
    return scene.done(scene.changed(changes), Fault.LATE_STAMPS, [edge], places[0], detail)


def _early(scene: _Scene) -> Injection:
    """From some moment on, the samples of one edge are stamped ahead; not a localiser's, which may do so."""
    edge = scene.pick(
        (e for e in scene.moving() if e.parent.rpartition("/")[2] != "map"), "a moving edge that is not a child of map"
    )
    places = scene.tail(edge)
    ahead_ns = round(scene.between(0.3, 1.5) * NSEC_PER_SEC)
    changes = {
        place: restamped(scene.records[place], stamp_ns=scene.records[place].stamped.stamp_ns + ahead_ns)
        for place in places
    }
    detail = f"{edge.parent} -> {edge.child} is stamped {ahead_ns / NSEC_PER_SEC:.3f} s ahead"
    return scene.done(scene.changed(changes), Fault.EARLY_STAMPS, [edge], places[0], detail)


def _gap(scene: _Scene) -> Injection:
    """Nothing is heard for a while: of one edge, or of all that move."""
    edge = scene.pick_moving()
    edges = scene.moving() if scene.rng.random() < 0.3 else [edge]
    period_ns = max(map(scene.period_ns, edges))
    heard = [scene.records[place].receive_ns for place in edge.places]
    silence_ns = min(max(NSEC_PER_SEC, 15 * period_ns), (heard[-1] - heard[0]) // 3)
    begin_ns = heard[0] + round(scene.between(0.3, 0.6) * (heard[-1] - heard[0]))
    names = {e.child for e in edges}
    silent = [
        place
        for place, record in enumerate(scene.records)
        if record.stamped.child_frame_id in names and begin_ns <= record.receive_ns < begin_ns + silence_ns
    ]
    if not silent:
        raise CannotInject("this stream cannot have the fault: it is silent already")
    left = [record for place, record in enumerate(scene.records) if place not in set(silent)]
    detail = f"{', '.join(sorted(names))}: silence of {silence_ns / NSEC_PER_SEC:.3f} s"
    return scene.done(left, Fault.GAP, edges, silent[0], detail)


# -- topics -------------------------------------------------------------------


def _static_on_tf(scene: _Scene) -> Injection:
    """The fixed mounts are sent on /tf, ten times a second, and not on /tf_static."""
    edges = scene.static()
    if not edges:
        raise CannotInject("this stream cannot have the fault: it needs static transforms")
    begin_ns, end_ns = scene.records[0].receive_ns, scene.records[-1].receive_ns
    clock = scene.pick(scene.moving(), "a moving edge, for the stamps")
    first = scene.records[clock.places[0]]
    lag_ns = first.receive_ns - first.stamped.stamp_ns
    sent = [record for record in scene.records if not record.is_static]
    for heard_ns in range(begin_ns, end_ns, NSEC_PER_SEC // 10):
        for edge in edges:
            record = restamped(scene.records[edge.places[-1]], stamp_ns=heard_ns - lag_ns)
            sent.append(record._replace(topic=first.topic, receive_ns=heard_ns, is_static=False))
    detail = f"{len(edges)} fixed edges are sent on {first.topic} at 10 Hz"
    return scene.done(sent, Fault.STATIC_ON_TF, edges, edges[0].places[0], detail)


def _moving_on_static(scene: _Scene) -> Injection:
    """A moving edge is sent on /tf_static."""
    edge = scene.pick_moving()
    changes = {}
    for place in edge.places:
        record = scene.records[place]
        changes[place] = record._replace(topic=f"{record.topic}_static", is_static=True)
    detail = f"{edge.parent} -> {edge.child}, which moves, is sent on {changes[edge.places[0]].topic}"
    return scene.done(scene.changed(changes), Fault.MOVING_ON_TF_STATIC, [edge], edge.places[0], detail)


def _no_statics(scene: _Scene) -> Injection:
    """Nothing of /tf_static was recorded."""
    edges = scene.static()
    if not edges:
        raise CannotInject("this stream cannot have the fault: it has no static transforms to lose")
    left = [record for record in scene.records if not record.is_static]
    detail = f"{len(edges)} static edges were not recorded"
    return scene.done(left, Fault.NO_TF_STATIC, edges, 0, detail)


INJECTORS: dict[Fault, Callable[[_Scene], Injection]] = {
    Fault.REPARENTED: _reparent,
    Fault.SECOND_OWNER: _second_owner,
    Fault.DUPLICATE_STAMPS: _duplicate_stamps,
    Fault.OUT_OF_ORDER: _out_of_order,
    Fault.ZERO_QUATERNION: _zero_quaternion,
    Fault.NAN: _nan,
    Fault.NON_UNIT_QUATERNION: _non_unit_quaternion,
    Fault.MISSING_EDGE: _remove_edge,
    Fault.LOOP: _close_loop,
    Fault.LEADING_SLASH: _leading_slash,
    Fault.CLOCK_JUMPED_BACK: _clock_back,
    Fault.CLOCK_OFFSET: _clock_offset,
    Fault.STATIC_ON_TF: _static_on_tf,
    Fault.MOVING_ON_TF_STATIC: _moving_on_static,
    Fault.NO_TF_STATIC: _no_statics,
    Fault.GAP: _gap,
    Fault.WRONG_NAME: _wrong_name,
    Fault.OPTICAL_IDENTITY: _optical_identity,
    Fault.LATE_STAMPS: _late,
    Fault.EARLY_STAMPS: _early,
}
