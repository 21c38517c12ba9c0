"""Inject faults into the tree: parents, publishers, missing edges, loops, names and topics.

Each function takes a Patient and returns a stream that has this fault, with its
diagnosis.
"""

from __future__ import annotations

from collections.abc import Iterable

from tflab.core import NSEC_PER_SEC, StampedTransform, Transform
from tflab.core.transforms import TransformRecord

from .catalogue import Fault
from .streams import FEWEST_SAMPLES, CannotInject, Injection, InjectionTarget, Stream, StreamEdge, restamped

__all__ = [
    "close_loop",
    "leading_slash",
    "moving_on_tf_static",
    "no_tf_static",
    "remove_edge",
    "reparent",
    "second_owner",
    "static_on_tf",
    "wrong_name",
]


def reparent(target: InjectionTarget) -> Injection:
    """A frame gets another parent: from some moment on, or in turns with the first."""
    choices = {}
    for edge in target.edges.values():
        others = [name for name in target.frames() if name != edge.parent and name not in target.below(edge.child)]
        if others and (edge.is_static or len(edge.places) >= FEWEST_SAMPLES):
            choices[edge.child] = others
    edge = target.pick((target.edges[child] for child in choices), "an edge, and a frame that could be another parent")
    parent = choices[edge.child][int(target.rng.integers(len(choices[edge.child])))]
    if edge.is_static:
        places = (len(target.records) // 2,)
        middle_ns = target.records[places[0]].receive_ns
        again = restamped(target.records[edge.places[-1]], frame_id=parent)._replace(receive_ns=middle_ns)
        records, how = [*target.records, again], "moves"
    else:
        places = target.tail(edge)
        others = {place: restamped(target.records[place], frame_id=parent) for place in places}
        if target.rng.random() < 0.6:
            records, how = target.changed(others), "moves"
        else:
            records, how = [*target.records, *_between_the_samples(target, edge, others.values())], "moves to and fro"
    detail = f"{edge.child} {how} from under {edge.parent} to under {parent}"
    return target.done(records, Fault.REPARENTED, [edge], places[0], detail)


def second_owner(target: InjectionTarget) -> Injection:
    """Another node publishes the same edge, with other values."""
    edge = target.pick([*target.moving(), *target.static()], "an edge that moves, or a static one")
    off = Transform.from_rpy(yaw=target.between(0.3, 1.0), translation=(target.between(0.3, 1.0), 0.2, 0.0))
    places = target.sound(target.tail(edge))
    lies = [
        restamped(target.records[place], transform=target.records[place].stamped.transform @ off) for place in places
    ]
    lies = _again_later(target, edge, lies) if edge.is_static else _between_the_samples(target, edge, lies)
    detail = f"a second publisher of {edge.parent} -> {edge.child} says {off.translation[0]:.2f} m further"
    return target.done([*target.records, *lies], Fault.SECOND_OWNER, [edge], places[0], detail)


def _between_the_samples(target: InjectionTarget, edge: StreamEdge, records: Iterable[TransformRecord]) -> Stream:
    """Return samples as another publisher sends them: half a period after those of the first."""
    half_ns = target.period_ns(edge) // 2
    return [
        restamped(record, stamp_ns=record.stamped.stamp_ns + half_ns)._replace(
            receive_ns=record.receive_ns + half_ns, publisher=_another(record.publisher)
        )
        for record in records
    ]


def _again_later(target: InjectionTarget, edge: StreamEdge, records: Iterable[TransformRecord]) -> Stream:
    """Return static samples as another publisher sends them, which starts a little later."""
    later_ns = round(target.between(0.1, 1.0) * NSEC_PER_SEC)
    return [
        restamped(record, stamp_ns=record.stamped.stamp_ns + later_ns)._replace(
            receive_ns=record.receive_ns + later_ns, publisher=_another(record.publisher)
        )
        for record in records
    ]


def _another(publisher: str) -> str:
    return f"{publisher}_2" if publisher else ""


def remove_edge(target: InjectionTarget) -> Injection:
    """An edge inside the tree is not there, so the tree falls in two."""
    parents = {edge.parent for edge in target.edges.values()}
    mentions = [name for edge in target.edges.values() for name in (edge.parent, edge.child)]
    edge = target.pick(
        (e for e in target.edges.values() if e.child in parents and mentions.count(e.parent) > 1),
        "an edge with others above and below it",
    )
    left = [record for record in target.records if record.stamped.child_frame_id != edge.child]
    detail = f"nobody publishes {edge.parent} -> {edge.child}"
    return target.done(left, Fault.MISSING_EDGE, [edge], 0, detail)


def close_loop(target: InjectionTarget) -> Injection:
    """Somebody publishes the root as the child of one of its own descendants."""
    roots = [name for name in target.frames() if name not in target.edges and len(target.below(name)) > 1]
    edge = target.pick(
        (e for e in target.moving() if any(e.child in target.below(root) for root in roots)),
        "a moving edge under a root",
    )
    root = next(root for root in roots if edge.child in target.below(root))
    places = target.sound(target.tail(edge))
    topic = target.records[places[0]].topic
    backwards = []
    for place in places:
        record = target.records[place]
        stamped = StampedTransform(edge.child, root, record.stamped.stamp_ns, record.stamped.transform.inverse())
        backwards.append(
            TransformRecord(topic, record.receive_ns, "/backwards" if record.publisher else "", stamped, False)
        )
    detail = f"{root} is published as a child of {edge.child}, which hangs below it"
    return target.done([*target.records, *backwards], Fault.LOOP, [edge], places[0], detail)


def leading_slash(target: InjectionTarget) -> Injection:
    """One publisher writes its frame names with a slash, as in ROS 1."""
    edge = target.pick(
        (e for e in target.edges.values() if not (e.parent.startswith("/") or e.child.startswith("/"))),
        "a name without one",
    )
    parent, child = f"/{edge.parent}", f"/{edge.child}"
    changes = {place: restamped(target.records[place], frame_id=parent, child_frame_id=child) for place in edge.places}
    detail = f"{edge.parent} -> {edge.child} is published as {parent} -> {child}"
    return target.done(target.changed(changes), Fault.LEADING_SLASH, [edge], edge.places[0], detail)


def wrong_name(target: InjectionTarget) -> Injection:
    """One publisher spells a frame differently from all others."""
    parents = {edge.parent for edge in target.edges.values()}
    known_elsewhere = [
        (edge, role)
        for edge in target.aimed(target.edges.values())
        for role in ("parent", "child")
        if (role == "child" and edge.child in parents)
        or (role == "parent" and (edge.parent in target.edges or _is_shared(edge, target)))
    ]
    edge, role = target.choose(known_elsewhere, "a frame that two edges name")
    name = edge.parent if role == "parent" else edge.child
    spellings = {
        "case": name.title() if name.title() != name else name.lower(),
        "prefix": f"robot1/{name}",
        "letter": name[: len(name) // 2] + name[len(name) // 2 + 1 :] if len(name) > 2 else name + "s",
    }
    kind = list(spellings)[int(target.rng.integers(len(spellings)))]
    wrong = spellings[kind]
    field = "frame_id" if role == "parent" else "child_frame_id"
    changes = {place: restamped(target.records[place], **{field: wrong}) for place in edge.places}
    detail = f"wrong {kind}: {edge.parent} -> {edge.child} is published with {wrong} for {name}"
    return target.done(target.changed(changes), Fault.WRONG_NAME, [edge], edge.places[0], detail)


def _is_shared(edge: StreamEdge, target: InjectionTarget) -> bool:
    return any(other.parent == edge.parent for other in target.edges.values() if other is not edge)


def static_on_tf(target: InjectionTarget) -> Injection:
    """The fixed mounts are sent on /tf, ten times a second, and not on /tf_static."""
    edges = target.aimed(target.static())
    if not edges:
        raise CannotInject("this stream cannot have the fault: it needs static transforms")
    begin_ns, end_ns = target.records[0].receive_ns, target.records[-1].receive_ns
    clock = target.choose(target.moving(), "a moving edge, for the stamps")
    first = target.records[clock.places[0]]
    lag_ns = first.receive_ns - first.stamped.stamp_ns
    moved = {edge.child for edge in edges}
    sent = [r for r in target.records if not (r.is_static and r.stamped.child_frame_id in moved)]
    for heard_ns in range(begin_ns, end_ns, NSEC_PER_SEC // 10):
        for edge in edges:
            record = restamped(target.records[edge.places[-1]], stamp_ns=heard_ns - lag_ns)
            sent.append(record._replace(topic=first.topic, receive_ns=heard_ns, is_static=False))
    detail = f"{len(edges)} fixed edges are sent on {first.topic} at 10 Hz"
    return target.done(sent, Fault.STATIC_ON_TF, edges, edges[0].places[0], detail)


def moving_on_tf_static(target: InjectionTarget) -> Injection:
    """A moving edge is sent on /tf_static."""
    edge = target.pick_moving()
    changes = {}
    for place in edge.places:
        record = target.records[place]
        changes[place] = record._replace(topic=f"{record.topic}_static", is_static=True)
    detail = f"{edge.parent} -> {edge.child}, which moves, is sent on {changes[edge.places[0]].topic}"
    return target.done(target.changed(changes), Fault.MOVING_ON_TF_STATIC, [edge], edge.places[0], detail)


def no_tf_static(target: InjectionTarget) -> Injection:
    """Nothing of /tf_static was recorded."""
    if target.aim:
        raise CannotInject("a lost /tf_static takes every static edge with it: it cannot be aimed at one")
    edges = target.static()
    if not edges:
        raise CannotInject("this stream cannot have the fault: it has no static transforms to lose")
    left = [record for record in target.records if not record.is_static]
    detail = f"{len(edges)} static edges were not recorded"
    return target.done(left, Fault.NO_TF_STATIC, edges, 0, detail)
