"""Random histories give the same results with and without caches."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tflab.core import BufferCore, StampedTransform, Transform, TransformException
from tflab.core.plain import PlainBuffer

CACHE_TIME_NS = 10
FRAMES = "abcd"
ROTATIONS = [(0, 0, 0, 1), (0, 0, 1, 0), (0.5, -0.5, 0.5, -0.5), (0, 0, 0.6, 0.8), (0, 0, -1.2, -1.6)]


@given(st.integers(0, 2**32))
@settings(max_examples=100, deadline=None)
def test_the_engine_agrees_with_the_reference_without_caches(seed: int) -> None:
    chance = random.Random(seed)
    buffer, plain = BufferCore(CACHE_TIME_NS), PlainBuffer(CACHE_TIME_NS)
    now_ns = chance.choice([-5, 1, 1000])
    for _ in range(80):
        now_ns += chance.choice([0, 0, 1, 3])
        act(chance, buffer, plain, now_ns)


def act(chance: random.Random, buffer: BufferCore, plain, now_ns: int) -> None:
    """Publish something mostly sensible, or ask something mostly answerable."""
    one_frame, other = chance.sample(FRAMES, 2)
    if chance.random() < 0.8:  # a is the root, b its child, and so on; now and then somebody disagrees
        child = chance.choice(FRAMES[1:])
        parent = FRAMES[FRAMES.index(child) - chance.choice([1, 1, 1, 2])]
    else:
        parent, child = one_frame, other
    stamp_ns = now_ns - chance.choice([0, 0, 0, 1, 2, 5, 12])
    match chance.choices(["set", "static", "bulk", "clear", "lookup", "batch"], [30, 1, 4, 0.5, 50, 10])[0]:
        case "set":
            publish(buffer, plain, parent, child, stamp_ns, some_transform(chance), False)
        case "static":
            publish(buffer, plain, parent, child, stamp_ns, some_transform(chance), True)
        case "bulk":
            stamps_ns = [stamp_ns + i * chance.choice([1, 1, 1, 0]) for i in range(chance.choice([1, 3, 5]))]
            publish_many(buffer, plain, parent, child, stamps_ns, some_transform(chance))
        case "clear":
            buffer.clear()
            plain.clear()
        case "lookup":
            for target, source in ((one_frame, other), (other, one_frame)):
                compare(lambda *a: one(buffer, *a), plain, target, source, chance.choice([stamp_ns, now_ns - 1, 0]))
        case "batch":
            stamps_ns = [now_ns + chance.randrange(-12, 3) for _ in range(20)] + [0]
            batch = buffer.lookup_transforms(one_frame, other, stamps_ns)
            for i, asked_ns in enumerate(stamps_ns):
                compare(lambda *_, row=i, batch=batch: row_of(batch, row), plain, one_frame, other, asked_ns)


def some_transform(chance: random.Random) -> Transform:
    rotation = chance.choice([*ROTATIONS, *([tuple(chance.gauss(0, 1) for _ in range(4))] * len(ROTATIONS))])
    return Transform((chance.choice([0.0, 1.0, chance.uniform(-4, 4)]), chance.uniform(-4, 4), 0.5), rotation)


def publish(buffer, plain, parent, child, stamp_ns, transform, is_static) -> None:
    accepted = buffer.set_transform(StampedTransform(parent, child, stamp_ns, transform), is_static=is_static)
    assert accepted == plain.set_transform(parent, child, stamp_ns, transform, is_static)


def publish_many(buffer, plain, parent, child, stamps_ns, transform) -> None:
    n = len(stamps_ns)
    shifted = [(transform.translation[0] + i, *transform.translation[1:]) for i in range(n)]
    accepted = buffer.set_transforms(
        parent, child, stamps_ns, np.array(shifted).reshape(n, 3), np.array([transform.rotation] * n).reshape(n, 4)
    )
    expected = [
        plain.set_transform(parent, child, stamp_ns, Transform(translation, transform.rotation), False)
        for stamp_ns, translation in zip(stamps_ns, shifted, strict=True)
    ]
    assert accepted == sum(expected)


def one(buffer: BufferCore, target: str, source: str, stamp_ns: int) -> tuple[int | None, Transform]:
    assert buffer.can_transform(target, source, stamp_ns) == (buffer.why_not(target, source, stamp_ns)[1] == "")
    answer = buffer.lookup_transform(target, source, stamp_ns)
    assert buffer.can_transform(target, source, stamp_ns)
    return answer.stamp_ns, answer.transform


def row_of(batch, row: int) -> tuple[int | None, Transform]:
    if row in batch.failures:
        assert np.isnan(batch.translations[row]).all()
        raise batch.failures[row]
    return None, Transform(batch.translations[row].tolist(), batch.rotations[row].tolist())


def compare(lookup, plain, target: str, source: str, stamp_ns: int) -> None:
    try:
        expected_ns, expected = plain.lookup_transform(target, source, stamp_ns)
    except TransformException as why:
        with pytest.raises(type(why)) as raised:
            lookup(target, source, stamp_ns)
        for fact in ("direction", "requested_ns", "bound_ns"):
            assert getattr(raised.value, fact, None) == getattr(why, fact, None)
        return
    got_ns, got = lookup(target, source, stamp_ns)
    assert got_ns is None or got_ns == expected_ns
    assert got.translation == pytest.approx(expected.translation, abs=1e-9)
    same = sum(a * b for a, b in zip(got.rotation, expected.rotation, strict=True))
    assert abs(same) == pytest.approx(1.0, abs=1e-9)
    assert math.hypot(*got.rotation) == pytest.approx(1.0, abs=1e-9)
