"""Each injected fault is in the stream, where its diagnosis reports it, and nowhere else."""

import math
from collections import defaultdict
from contextlib import suppress
from enum import Enum
from itertools import pairwise

import numpy as np
import pytest

from tflab.core import LATEST, BufferCore, ConnectivityException, LookupException, StampedTransform, Transform, seconds
from tflab.core.transforms import TransformRecord
from tflab.robots.faults import inject as injecting
from tflab.robots.faults.catalogue import Fault
from tflab.robots.faults.inject import INJECTORS, CannotInject, inject, inject_all, possible_faults
from tflab.robots.faults.streams import edges_of
from tflab.robots.teaching import TeachingRobot

CLEAN = TeachingRobot().records(until_s=21.0)
SEEDS = range(3)


def small_stream() -> list[TransformRecord]:
    """odom -> base, 10 Hz for 5 s; nothing else."""
    records = []
    for k in range(50):
        stamp_ns = seconds(1.0 + 0.1 * k)
        stamped = StampedTransform("odom", "base", stamp_ns, Transform((0.1 * k, 0.0, 0.0)))
        records.append(TransformRecord("/tf", stamp_ns + 5_000_000, "", stamped, False))
    return records


def stamps_of(records, child) -> list[int]:
    return [record.stamped.stamp_ns for record in records if record.stamped.child_frame_id == child]


def heard_of(records, child) -> list[int]:
    return [record.receive_ns for record in records if record.stamped.child_frame_id == child]


def parents_of(records, child) -> set[str]:
    return {record.stamped.frame_id for record in records if record.stamped.child_frame_id == child}


def filled(records) -> BufferCore:
    buffer = BufferCore(seconds(100.0))
    for record in records:
        buffer.set_transform(record.stamped, is_static=record.is_static)
    return buffer


def test_the_order_of_the_catalogue_does_not_change_injected_faults(monkeypatch):
    before = {fault: repr(inject(CLEAN, fault, 1)) for fault in Fault}
    reordered = {"NEW": "new", **{fault.name: fault.value for fault in reversed(Fault)}}
    monkeypatch.setattr(injecting, "Fault", Enum("Fault", reordered, type=str))
    assert {fault: repr(inject(CLEAN, fault, 1)) for fault in Fault} == before


@pytest.mark.parametrize("fault", list(Fault))
@pytest.mark.parametrize("seed", [0, 1])
def test_the_same_seed_makes_the_same_fault_on_edges_that_its_diagnosis_names_and_on_no_other(fault, seed):
    before = list(CLEAN)
    first, again = inject(CLEAN, fault, seed), inject(CLEAN, fault, seed)
    assert repr(first) == repr(again)  # NaN is not equal to itself, but its text is
    assert before == CLEAN
    assert first.records != CLEAN
    assert first.diagnosis.fault == fault
    heard = [record.receive_ns for record in first.records]
    assert heard == sorted(heard)
    for edge in edges_of(CLEAN).values():
        if edge.child not in first.diagnosis.frames:
            original = [CLEAN[place] for place in edge.places]
            assert [r for r in first.records if r.stamped.child_frame_id == edge.child] == original


@pytest.mark.parametrize("seed", SEEDS)
def test_reparented_frames_have_two_parents_and_no_loop(seed):
    records, diagnosis = inject(CLEAN, Fault.REPARENTED, seed)
    (child,) = diagnosis.frames
    assert len(parents_of(records, child)) == 2
    filled(records).lookup_transform("map", child, LATEST)


@pytest.mark.parametrize("seed", range(4))
def test_a_second_owner_contradicts_the_first_at_other_moments(seed):
    records, diagnosis = inject(CLEAN, Fault.SECOND_OWNER, seed)
    (child,) = diagnosis.frames
    owners = defaultdict(dict)
    for record in records:
        if record.stamped.child_frame_id == child:
            owners[record.publisher][record.stamped.stamp_ns] = record.stamped
    mine, other = (stampeds for _, stampeds in sorted(owners.items()))
    assert not mine.keys() & other.keys()
    assert {each.frame_id for each in mine.values()} == {each.frame_id for each in other.values()}
    lie_ns = min(other)
    before_ns = max(stamp for stamp in mine if stamp < lie_ns)
    assert math.dist(other[lie_ns].transform.translation, mine[before_ns].transform.translation) > 0.3


def test_mounts_can_have_a_second_owner_and_frames_two_parents_in_turns():
    static = {edge.child for edge in edges_of(CLEAN).values() if edge.is_static}
    owned_twice = {inject(CLEAN, Fault.SECOND_OWNER, seed).diagnosis.frames[0] for seed in range(12)}
    assert owned_twice & static and owned_twice - static
    ways = {
        inject(CLEAN, Fault.REPARENTED, seed).diagnosis.detail.split(" from ")[0].split(" ", 1)[1] for seed in range(20)
    }
    assert ways == {"moves", "moves to and fro"}


@pytest.mark.parametrize("seed", SEEDS)
def test_duplicate_stamps_repeat_within_one_edge(seed):
    records, diagnosis = inject(CLEAN, Fault.DUPLICATE_STAMPS, seed)
    stamps = stamps_of(records, diagnosis.frames[0])
    assert len(stamps) - len(set(stamps)) > 20
    assert stamps == sorted(stamps)


@pytest.mark.parametrize("seed", SEEDS)
def test_out_of_order_stamps_step_back_by_one_sample(seed):
    records, diagnosis = inject(CLEAN, Fault.OUT_OF_ORDER, seed)
    (child,) = diagnosis.frames
    stamps = stamps_of(records, child)
    steps = [after - before for before, after in pairwise(stamps)]
    assert min(steps) in (-seconds(0.05), -seconds(0.1))
    assert sorted(stamps) == stamps_of(CLEAN, child)


@pytest.mark.parametrize("seed", SEEDS)
def test_bad_numbers_are_in_the_edge_that_is_named(seed):
    for fault, is_bad in (
        (Fault.ZERO_QUATERNION, lambda t: t.rotation == (0.0, 0.0, 0.0, 0.0)),
        (Fault.NAN, lambda t: any(map(math.isnan, t.translation + t.rotation))),
        (Fault.NON_UNIT_QUATERNION, lambda t: abs(math.hypot(*t.rotation) - 1.0) > 0.1),
    ):
        records, diagnosis = inject(CLEAN, fault, seed)
        bad = {record.stamped.child_frame_id for record in records if is_bad(record.stamped.transform)}
        assert bad == set(diagnosis.frames)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_loop_is_one_and_a_missing_edge_leaves_two_trees(seed):
    buffer = filled(inject(CLEAN, Fault.LOOP, seed).records)
    buffer.set_transform(StampedTransform("island", "rock", seconds(1.0), Transform()), is_static=True)
    with pytest.raises(LookupException, match="contains a loop"):
        buffer.lookup_transform("island", "laser_frame", LATEST)
    records, diagnosis = inject(CLEAN, Fault.MISSING_EDGE, seed)
    with pytest.raises(ConnectivityException):
        filled(records).lookup_transform("map", diagnosis.frames[0], LATEST)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_leading_slash_is_on_both_names_of_one_edge(seed):
    records, diagnosis = inject(CLEAN, Fault.LEADING_SLASH, seed)
    slashed = {r.stamped.child_frame_id for r in records if r.stamped.child_frame_id.startswith("/")}
    assert slashed == {f"/{frame}" for frame in diagnosis.frames}
    assert all(r.stamped.frame_id.startswith("/") for r in records if r.stamped.child_frame_id in slashed)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_clock_that_jumps_back_takes_every_moving_edge_with_it(seed):
    records, diagnosis = inject(CLEAN, Fault.CLOCK_JUMPED_BACK, seed)
    for child in ("odom", "base_footprint", "wrist"):
        steps = [after - before for before, after in pairwise(stamps_of(records, child))]
        assert sum(step < -seconds(1.0) for step in steps) == 1
        assert child in diagnosis.frames
    assert min(record.stamped.stamp_ns for record in records) > 0


@pytest.mark.parametrize("seed", SEEDS)
def test_a_clock_offset_is_the_same_for_all_of_one_publisher_and_none_of_another(seed):
    records, diagnosis = inject(CLEAN, Fault.CLOCK_OFFSET, seed)
    offsets = {
        child: {a - b for a, b in zip(stamps_of(records, child), stamps_of(CLEAN, child), strict=True)}
        for child in ("odom", "base_footprint", "wrist", "elbow")
    }
    assert all(len(values) == 1 for values in offsets.values())
    assert {child for child, values in offsets.items() if values != {0}} == set(diagnosis.frames) & set(offsets)
    assert offsets["wrist"] == offsets["elbow"]
    assert all(abs(offset) >= seconds(1.0) for values in offsets.values() for offset in values - {0})


def test_an_edge_on_the_wrong_topic_is_there_and_nowhere_else():
    records, diagnosis = inject(CLEAN, Fault.STATIC_ON_TF)
    laser = [record for record in records if record.stamped.child_frame_id == "laser_frame"]
    assert len(laser) > 150
    assert {record.topic for record in laser} == {"/tf"}
    assert {record.stamped.transform for record in laser} == {Transform((0.2, 0.0, 0.15))}
    assert "laser_frame" in diagnosis.frames
    records, diagnosis = inject(CLEAN, Fault.NO_TF_STATIC)
    assert not any(record.is_static for record in records)
    assert "laser_frame" in diagnosis.frames
    for seed in SEEDS:
        records, diagnosis = inject(CLEAN, Fault.MOVING_ON_TF_STATIC, seed)
        topics = {(r.topic, r.is_static) for r in records if r.stamped.child_frame_id == diagnosis.frames[0]}
        assert topics == {("/tf_static", True)}


@pytest.mark.parametrize("seed", SEEDS)
def test_a_gap_is_a_silence_of_a_second_or_more(seed):
    records, diagnosis = inject(CLEAN, Fault.GAP, seed)
    for child in diagnosis.frames:
        heard = heard_of(records, child)
        assert max(after - before for before, after in pairwise(heard)) >= seconds(1.0)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_wrong_name_is_new_resembles_the_right_one_and_cuts_the_tree(seed):
    records, _ = inject(CLEAN, Fault.WRONG_NAME, seed)
    known = {name for r in CLEAN for name in (r.stamped.frame_id, r.stamped.child_frame_id)}
    names = {name for r in records for name in (r.stamped.frame_id, r.stamped.child_frame_id)}
    (wrong,) = names - known
    letters = wrong.lower().removeprefix("robot1/").replace("_", "")
    assert any(abs(len(letters) - len(name.replace("_", ""))) <= 1 and letters[0] == name[0] for name in known)
    buffer = filled(records)
    with pytest.raises((ConnectivityException, LookupException)):
        for frame in known:
            buffer.lookup_transform("map", frame, LATEST)


def test_an_optical_frame_with_identity_rotation_looks_along_x():
    records, diagnosis = inject(CLEAN, Fault.OPTICAL_IDENTITY)
    link_T_optical = filled(records).lookup_transform("camera_link", "camera_optical_frame", LATEST).transform
    assert link_T_optical.apply((0.0, 0.0, 1.0)) == (0.0, 0.0, 1.0)
    assert diagnosis.frames == ("camera_optical_frame",)


@pytest.mark.parametrize("seed", SEEDS)
def test_late_stamps_are_old_when_they_arrive_and_early_ones_are_from_the_future(seed):
    for fault, low_s, high_s in ((Fault.LATE_STAMPS, 0.2, 1.5), (Fault.EARLY_STAMPS, -1.6, -0.25)):
        records, diagnosis = inject(CLEAN, fault, seed)
        (child,) = diagnosis.frames
        delays = [(r.receive_ns - r.stamped.stamp_ns) / 1e9 for r in records if r.stamped.child_frame_id == child]
        assert 0.0 < delays[0] < 0.05  # it begins later
        assert low_s < delays[-1] < high_s


def test_faults_add_up_and_each_has_its_diagnosis():
    records, diagnoses = inject_all(CLEAN, [Fault.NO_TF_STATIC, Fault.GAP, Fault.LEADING_SLASH], seed=1)
    assert [diagnosis.fault for diagnosis in diagnoses] == [Fault.NO_TF_STATIC, Fault.GAP, Fault.LEADING_SLASH]
    assert not any(record.is_static for record in records)
    slashed, silent = f"/{diagnoses[2].frames[0]}", set(diagnoses[1].frames)
    assert stamps_of(records, slashed)
    for child in silent - set(diagnoses[2].frames):
        assert len(stamps_of(records, child)) < len(stamps_of(CLEAN, child))


@pytest.mark.parametrize("seed", range(10))
def test_any_three_faults_can_be_injected_in_sequence_or_raise(seed):
    faults = np.random.default_rng(seed).choice(list(Fault), 3, replace=False)
    with suppress(CannotInject):
        records, diagnoses = inject_all(CLEAN, faults, seed)
        assert len(diagnoses) == 3
        assert [r.receive_ns for r in records] == sorted(r.receive_ns for r in records)


def test_corrupted_samples_are_not_used_for_later_faults():
    spoilt, _ = inject(small_stream(), Fault.ZERO_QUATERNION)
    bad = {record.stamped.stamp_ns for record in spoilt if record.stamped.transform.rotation[3] == 0.0}
    records, _ = inject(spoilt, Fault.LOOP)
    assert not bad & {record.stamped.stamp_ns for record in records if record.stamped.child_frame_id == "odom"}


def test_an_impossible_fault_names_what_is_missing():
    assert possible_faults(CLEAN) == list(Fault) == sorted(INJECTORS, key=list(Fault).index)
    few = possible_faults(small_stream())
    assert Fault.GAP in few
    assert not {Fault.NO_TF_STATIC, Fault.OPTICAL_IDENTITY, Fault.MISSING_EDGE, Fault.CLOCK_OFFSET} & set(few)
    with pytest.raises(CannotInject, match="it needs a frame called optical"):
        inject(small_stream(), Fault.OPTICAL_IDENTITY)
    with pytest.raises(CannotInject, match="it needs a moving edge of at least 20 samples"):
        inject([], Fault.GAP)
    with pytest.raises(ValueError, match="'gremlins' is not a valid Fault; there is reparented, second-owner, "):
        inject(CLEAN, "gremlins")


@pytest.mark.parametrize("fault", [f for f in Fault if f not in (Fault.CLOCK_JUMPED_BACK, Fault.NO_TF_STATIC)])
def test_aim_selects_the_edge(fault):
    hit = 0
    for child in edges_of(CLEAN):
        with suppress(CannotInject):
            frames = inject(CLEAN, fault, 1, aim=child).diagnosis.frames
            assert child in frames if fault is Fault.CLOCK_OFFSET else frames == (child,)
            hit += 1
    assert hit


def test_an_aim_at_an_unsuitable_edge_raises():
    with pytest.raises(ValueError, match="nobody sends 'bse_link' as a child; there is base_footprint, base_link"):
        inject(CLEAN, Fault.GAP, aim="bse_link")
    with pytest.raises(CannotInject, match="laser_frame cannot have the fault: it needs a moving edge"):
        inject(CLEAN, Fault.GAP, aim="laser_frame")
    for fault in (Fault.CLOCK_JUMPED_BACK, Fault.NO_TF_STATIC):
        with pytest.raises(CannotInject, match="it cannot be aimed at one"):
            inject(CLEAN, fault, aim="base_footprint")
