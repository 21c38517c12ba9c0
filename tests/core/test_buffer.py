"""Properties of the buffer that the recordings of tf2 do not cover."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tflab.core import (
    NEVER,
    POSSIBLE_NOW,
    BufferCore,
    ConnectivityException,
    ExtrapolationException,
    LookupException,
    StampedTransform,
    Transform,
    quaternions,
    seconds,
)


def robot(until_s: float = 5.0) -> BufferCore:
    #  map --(10 Hz)--> odom --(50 Hz)--> base_link --(static)--> laser, camera
    buffer = BufferCore()
    for parent, child, rate_hz in (("map", "odom", 10), ("odom", "base_link", 50)):
        n = int(until_s * rate_hz)
        stamps = [seconds(1) + i * seconds(1 / rate_hz) for i in range(n)]
        yaws = [0.1 * i / rate_hz for i in range(n)]
        rotations = np.array([quaternions.from_rpy(0, 0, yaw) for yaw in yaws])
        buffer.set_transforms(parent, child, stamps, np.column_stack([np.arange(n) / rate_hz] * 3), rotations, "ekf")
    for child, y in (("laser", 0.2), ("camera", -0.2)):
        mount = Transform.from_rpy(yaw=y, translation=(0.1, y, 0.3))
        buffer.set_transform(StampedTransform("base_link", child, 0, mount), "urdf", is_static=True)
    return buffer


FRAMES = ["map", "odom", "base_link", "laser", "camera"]
stamps_in_reach = st.integers(seconds(1), seconds(5.9))


@given(st.sampled_from(FRAMES), st.sampled_from(FRAMES), stamps_in_reach)
@settings(deadline=None)
def test_lookup_a_b_inverts_lookup_b_a(a: str, b: str, stamp_ns: int) -> None:
    there = ROBOT.lookup_transform(a, b, stamp_ns).transform
    back = ROBOT.lookup_transform(b, a, stamp_ns).transform
    assert np.allclose((there @ back).matrix(), np.eye(4), atol=1e-9)


@given(st.sampled_from(FRAMES), st.sampled_from(FRAMES), st.sampled_from(FRAMES), stamps_in_reach)
@settings(deadline=None)
def test_a_lookup_equals_the_product_over_any_third_frame(a: str, b: str, c: str, stamp_ns: int) -> None:
    direct = ROBOT.lookup_transform(a, c, stamp_ns).transform
    over_b = ROBOT.lookup_transform(a, b, stamp_ns).transform @ ROBOT.lookup_transform(b, c, stamp_ns).transform
    assert np.allclose(direct.matrix(), over_b.matrix(), atol=1e-9)


ROBOT = robot()


@given(st.sampled_from(FRAMES), st.sampled_from(FRAMES), st.lists(st.integers(-1, seconds(7)), min_size=1, max_size=60))
@settings(deadline=None)
def test_a_batch_is_its_single_lookups_failures_included(a: str, b: str, stamps_ns: list[int]) -> None:
    batch = ROBOT.lookup_transforms(a, b, stamps_ns)
    for i, stamp_ns in enumerate(stamps_ns):
        try:
            single = ROBOT.lookup_transform(a, b, stamp_ns).transform
        except ExtrapolationException as error:
            assert str(batch.failures[i]) == str(error)
            assert vars(batch.failures[i]) == vars(error)
            assert np.isnan(batch.translations[i]).all()
            continue
        assert i not in batch.failures
        assert batch.translations[i] == pytest.approx(single.translation, abs=1e-12)
        assert batch.rotations[i] == pytest.approx(single.rotation, abs=1e-12)
    assert batch.ok.tolist() == [i not in batch.failures for i in range(len(stamps_ns))]


def test_a_batch_raises_its_first_failure_only_if_asked_to_and_refuses_seconds() -> None:
    with pytest.raises(ExtrapolationException, match=r"into the past\.  Requested time 0\.500000"):
        ROBOT.lookup_transforms("map", "laser", [seconds(2), seconds(0.5), seconds(99)], raise_on_failure=True)
    with pytest.raises(LookupException):
        ROBOT.lookup_transforms("map", "nobody", [seconds(2)] * 50, raise_on_failure=True)
    assert len(ROBOT.lookup_transforms("map", "nobody", [seconds(2)] * 50).failures) == 50
    with pytest.raises(TypeError, match=r"seconds\(1\.5\)"):
        ROBOT.lookup_transforms("map", "laser", np.array([1.5, 2.5]))


def test_set_transforms_stores_what_single_calls_store() -> None:
    stamps = [5, 7, 7, 3, 30, 19, 20]
    translations = np.arange(21.0).reshape(7, 3)
    rotations = np.array([[0, 0, 0, 1.0]] * 7)
    rotations[2] = 0.0
    one_by_one, at_once = BufferCore(cache_time_ns=10), BufferCore(cache_time_ns=10)
    accepted = [
        one_by_one.set_transform(StampedTransform("a", "b", s, Transform(t, r)))
        for s, t, r in zip(stamps, translations, rotations, strict=True)
    ]
    assert at_once.set_transforms("a", "b", stamps, translations, rotations) == sum(accepted) == 5
    assert at_once.history("b") == one_by_one.history("b")
    with pytest.raises(ValueError, match=r"2 stamps need translations of shape \(2, 3\)"):
        BufferCore().set_transforms("a", "b", [1, 2], np.zeros((3, 3)), np.zeros((2, 4)))


def test_a_stamp_in_seconds_is_refused_with_the_remedy() -> None:
    buffer = robot()
    for child in ("base_link", "newcomer"):
        with pytest.raises(TypeError, match=r"an int of nanoseconds, not 6\.5; seconds\(1\.5\) makes one"):
            buffer.set_transform(StampedTransform("odom", child, 6.5, Transform()))
        with pytest.raises(ValueError, match="64 bits"):
            buffer.set_transform(StampedTransform("odom", child, 2**63, Transform()))
    with pytest.raises(TypeError, match=r"a stamp is an int of nanoseconds, not 6\.5"):
        buffer.lookup_transform("odom", "base_link", 6.5)
    with pytest.raises(TypeError, match=r"cache_time_ns is an int of nanoseconds, not 10\.0; seconds"):
        BufferCore(10.0)
    assert not buffer.frame_exists("newcomer")
    assert buffer.set_transform(StampedTransform("odom", "base_link", seconds(6.5), Transform()))


def test_the_chain_goes_up_and_down_without_detours() -> None:
    assert ROBOT.chain("camera", "laser") == ["laser", "base_link", "camera"]
    assert ROBOT.chain("map", "laser") == ["laser", "base_link", "odom", "map"]
    assert ROBOT.chain("laser", "map", seconds(2)) == ["map", "odom", "base_link", "laser"]
    assert ROBOT.chain("map", "map") == ["map"]


def test_history_has_stamps_parents_and_authorities() -> None:
    buffer = BufferCore()
    for stamp_ns, parent, authority in ((1, "odom", "wheels"), (2, "odom", "ekf"), (3, "map", "amcl")):
        buffer.set_transform(StampedTransform(parent, "base_link", stamp_ns, Transform((stamp_ns, 0, 0))), authority)
    history = buffer.history("base_link")
    assert history.stamps_ns == (1, 2, 3)
    assert history.parents == ("odom", "odom", "map")
    assert history.authorities == ("wheels", "ekf", "amcl")
    assert history.transforms[2] == Transform((3, 0, 0))
    assert buffer.history("odom").stamps_ns == ()
    with pytest.raises(LookupException):
        buffer.history("nobody")


def test_a_snapshot_shows_roots_owners_and_kinds() -> None:
    buffer = robot()
    buffer.set_transform(StampedTransform("odom", "base_link", seconds(6), Transform()), "wheels")
    buffer.set_transform(StampedTransform("island", "palm", 0, Transform()), is_static=True)
    tree = buffer.snapshot()
    assert tree.roots == ("map", "island")
    base_link = next(frame for frame in tree.frames if frame.name == "base_link")
    assert base_link.owners == (("odom", "ekf"), ("odom", "wheels"))
    assert base_link.authorities("odom") == ("ekf", "wheels")
    assert base_link.parents == ("odom",)
    assert not base_link.is_static
    assert base_link.newest_ns == seconds(6)
    assert next(frame for frame in tree.frames if frame.name == "laser").is_static


def test_a_sample_takes_at_most_eighty_bytes_and_memos_are_bounded() -> None:
    buffer = BufferCore(seconds(1e6))
    n = 100_000
    for bulk in range(2):
        stamps = seconds(1) + np.arange(n) * 1000 + bulk * n * 1000
        buffer.set_transforms("a", "b", stamps, np.ones((n, 3)), np.ones((n, 4)))
    for i in range(n):
        buffer.set_transform(StampedTransform("a", "b", seconds(1) + (2 * n + i) * 1000, Transform()))
    memory = buffer.memory()
    assert memory.samples == 3 * n
    assert memory.sample_bytes <= 80 * memory.samples
    for stamp_ns in range(seconds(1) + 500, seconds(1) + 5000 * 1000, 1000):
        buffer.lookup_transform("a", "b", stamp_ns)
    assert buffer.memory().memo_bytes < 1_000_000


def test_a_stale_edge_above_does_not_affect_a_lookup_below_it_and_no_parent_leads_nowhere() -> None:
    assert ROBOT.can_transform("camera", "laser", seconds(99)) is True
    assert ROBOT.can_transform("map", "laser", seconds(99)) is False
    buffer = BufferCore()
    for parent, child in (("NO_PARENT", "c"), ("r", "o")):
        buffer.set_transform(StampedTransform(parent, child, seconds(1), Transform()))
    with pytest.raises(ConnectivityException):
        buffer.lookup_transform("r", "c", seconds(1))


def test_callbacks_may_use_the_buffer_and_an_exception_does_not_stop_the_others() -> None:
    buffer = BufferCore()
    called = []

    def failing(*event) -> None:
        called.append("failing")
        raise RuntimeError("mine")

    def asking(handle, target, source, stamp_ns, result) -> None:
        called.append(buffer.lookup_transform(target, source, stamp_ns).stamp_ns)
        assert buffer.request_transformable("x", "y", 1, failing) == 3

    assert buffer.request_transformable("map", "odom", 5, failing) == 1
    assert buffer.request_transformable("map", "odom", 5, asking) == 2
    with pytest.raises(RuntimeError, match="mine"):
        buffer.set_transform(StampedTransform("map", "odom", 5, Transform()))
    assert called == ["failing", 5]
    assert buffer.request_transformable("map", "odom", 5, failing) == POSSIBLE_NOW
    buffer.set_transform(StampedTransform("map", "odom", seconds(60), Transform()))
    assert buffer.request_transformable("map", "odom", 4, failing) == NEVER


def test_velocity_is_that_of_a_body_that_drives_and_turns() -> None:
    # On a circle of radius 2 m at 0.5 rad/s: 1 m/s, forward being the tangent.
    buffer = BufferCore()
    for i in range(101):
        angle = 0.5 * i * 0.01
        pose = Transform.from_rpy(yaw=angle + np.pi / 2, translation=(2 * np.cos(angle), 2 * np.sin(angle), 0))
        buffer.set_transform(StampedTransform("odom", "base_link", seconds(1 + i * 0.01), pose))
    now, interval = seconds(1.5), seconds(0.02)
    in_odom = buffer.lookup_velocity("base_link", "odom", now, interval)
    in_base = buffer.lookup_velocity("base_link", "odom", now, interval, reference_frame="base_link")
    assert np.hypot(*in_odom.linear[:2]) == pytest.approx(1.0, rel=1e-4)
    assert in_odom.angular == pytest.approx((0, 0, 0.5), abs=1e-9)
    assert in_base.linear == pytest.approx((1.0, 0, 0), abs=1e-4)
    ahead = buffer.lookup_velocity("base_link", "odom", now, interval, "base_link", (3.0, 0.0, 0.0))
    assert ahead.linear == pytest.approx((1.0, 1.5, 0), abs=1e-4)  # plus 0.5 rad/s x 3 m to the left
