"""Lookups stay consistent while another thread writes."""

from __future__ import annotations

import sys
import threading

import pytest

from tflab.core import BufferCore, ExtrapolationException, StampedTransform, Transform


@pytest.fixture
def impatient_interpreter():
    """Let Python switch threads as often as it can."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


def test_readers_see_whole_samples_while_the_history_grows_is_pruned_and_cut(impatient_interpreter) -> None:
    # The child is always at (stamp, stamp, stamp) under a parent at (-stamp, 0, 0), so every true answer is known.
    buffer = BufferCore(cache_time_ns=50)
    wrong, answers, done = [], [0, 0, 0], threading.Event()

    def write() -> None:
        try:
            for stamp_ns in range(1, 1_000_000):
                if stamp_ns > 5000 and min(answers) > 20:
                    break
                at = float(stamp_ns)
                buffer.set_transform(StampedTransform("a", "b", stamp_ns, Transform((-at, 0.0, 0.0))))
                buffer.set_transform(StampedTransform("b", "c", stamp_ns, Transform((at, at, at))))
        finally:
            done.set()

    def read(reader: int) -> None:
        while not done.is_set():
            stamp_ns = int(buffer.history_ends().max(initial=0)) - 20 * reader
            if stamp_ns <= 0:  # nothing yet, and 0 would mean LATEST
                continue
            try:
                stamped = buffer.lookup_transform("a", "c", stamp_ns)
                batch = buffer.lookup_transforms("a", "c", [stamp_ns] * 20)
            except ExtrapolationException:
                continue
            at = float(stamped.stamp_ns)
            if stamped.transform.translation != (0.0, at, at):
                wrong.append((stamp_ns, stamped))
            if batch.ok.any() and tuple(batch.translations[0]) != (0.0, stamp_ns, stamp_ns):
                wrong.append((stamp_ns, batch))
            answers[reader] += 1

    threads = [threading.Thread(target=write), *(threading.Thread(target=read, args=(i,)) for i in range(3))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []
    assert min(answers) > 20


def test_requests_are_decided_by_the_thread_that_writes() -> None:
    buffer, decided_in = BufferCore(), []
    buffer.request_transformable("map", "odom", 5, lambda *event: decided_in.append(threading.current_thread().name))
    writer = threading.Thread(
        target=buffer.set_transform, args=(StampedTransform("map", "odom", 5, Transform()),), name="writer"
    )
    writer.start()
    writer.join()
    assert decided_in == ["writer"]
