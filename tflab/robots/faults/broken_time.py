"""How does time break?  Twice the same stamp, the wrong order, a wrong clock, too late, too early, silence.

Each function takes a Scene and returns a stream that has this fault, with its
diagnosis.  Read `inject.py` next.
"""

from __future__ import annotations

from tflab.core import NSEC_PER_SEC

from .catalogue import Fault
from .patient import FEWEST_SAMPLES, CannotInject, Injection, Scene
from .streams import Edge, restamped

__all__ = ["clock_back", "clock_offset", "duplicate_stamps", "early", "gap", "late", "out_of_order"]


def duplicate_stamps(scene: Scene) -> Injection:
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


def out_of_order(scene: Scene) -> Injection:
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


def clock_back(scene: Scene) -> Injection:
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


def clock_offset(scene: Scene) -> Injection:
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


def late(scene: Scene) -> Injection:
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


def early(scene: Scene) -> Injection:
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


def gap(scene: Scene) -> Injection:
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
