"""Samples with equal stamps, and stamp zero, also after interpolation was cached."""

from __future__ import annotations

from tflab.core.cache import TimeCache


def moving_along_x(*samples: tuple[int, float], cache_time_ns: int = 10) -> TimeCache:
    cache = TimeCache(cache_time_ns)
    for stamp_ns, x in samples:
        assert cache.insert(stamp_ns, (x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), 1, "me")
    return cache


def test_time_zero_is_the_newest_sample_even_between_negative_and_positive_stamps() -> None:
    cache = moving_along_x((-5, 0.0), (5, 10.0))
    assert cache.at(-1)[0] == 4.0
    assert cache.at(0)[0] == 10.0


def test_of_two_oldest_samples_with_one_stamp_the_first_answers() -> None:
    cache = moving_along_x((1, 0.0), (5, 1.0), (5, 2.0), (9, 6.0), (15, 12.0))
    assert cache.at(6)[0] == 3.0
    assert cache.at(5)[0] == 2.0  # in the middle, the last to come
    assert cache.insert(16, (13.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), 1, "me")  # 1 is pruned
    assert cache.at(5)[0] == 1.0  # at the old end, the first to come
    assert cache.at(6)[0] == 3.0
