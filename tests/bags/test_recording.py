"""A recording in bulk gives the same buffer as its transforms one by one."""

import logging

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tflab.bags.recording import recording_from_records
from tflab.core import BufferCore, StampedTransform, Transform
from tflab.core.transforms import TransformRecord

SECOND = 1_000_000_000


def record(stamp_ns, parent, child, x=0.0, *, is_static=False, publisher="", topic=None, rotation=(0.0, 0.0, 0.0, 1.0)):
    topic = topic or ("/tf_static" if is_static else "/tf")
    stamped = StampedTransform(parent, child, stamp_ns, Transform((x, 0.0, 0.0), rotation))
    return TransformRecord(topic, stamp_ns + 5_000_000, publisher, stamped, is_static)


frames = st.sampled_from(["a", "b", "c", "/b", "d", ""])
rotations = st.sampled_from([(0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 2.0, 0.0)])


@st.composite
def streams(draw):
    records = []
    for _ in range(draw(st.integers(0, 25))):
        stamp_ns = draw(st.integers(1, 20)) * SECOND
        child, parent = draw(frames), draw(frames)
        is_static, publisher = draw(st.booleans()), draw(st.sampled_from(["", "/n"]))
        x, rotation = draw(st.integers(0, 3)), draw(rotations)
        records.append(
            record(stamp_ns, parent, child, float(x), is_static=is_static, publisher=publisher, rotation=rotation)
        )
    return records


@settings(max_examples=80)
@given(streams(), st.sampled_from([None, 3 * SECOND]))
def test_the_buffer_is_the_one_that_was_fed_one_by_one(records, cache_time_ns):
    logging.getLogger("tflab.tf2").disabled = True
    try:
        bulk = recording_from_records(records).buffer(cache_time_ns)
        single = BufferCore(bulk.cache_time_ns)
        for each in records:
            single.set_transform(each.stamped, each.publisher or "default_authority", each.is_static)
    finally:
        logging.getLogger("tflab.tf2").disabled = False
    assert bulk.frame_names() == single.frame_names()
    for name in single.frame_names():
        assert bulk.history(name) == single.history(name)
    assert bulk.all_frames_as_yaml() == single.all_frames_as_yaml()


def test_a_long_smooth_edge_goes_in_at_once_and_whole():
    records = [record(i * SECOND // 50, "odom", "base_link", 0.01 * i) for i in range(1, 2001)]
    buffer = recording_from_records(records).buffer()
    assert len(buffer.history("base_link").stamps_ns) == 2000
    middle = buffer.lookup_transform("odom", "base_link", 10 * SECOND + SECOND // 100)
    assert middle.transform.translation[0] == pytest.approx(5.005)


def test_records_come_out_as_they_went_in():
    records = [
        record(SECOND, "odom", "/base", 1.5, publisher="/wheels"),
        record(SECOND, "base", "laser", is_static=True),
        record(SECOND // 2, "odom", "/base", 2.5, publisher="/wheels"),
    ]
    assert recording_from_records(records).records() == records


def test_robots_with_topics_of_their_own_get_buffers_of_their_own():
    records = [
        record(SECOND, "odom", "base", 1.0, topic="/robot1/tf"),
        record(SECOND, "odom", "base", 2.0, topic="/robot2/tf"),
    ]
    recording = recording_from_records(records)
    assert recording.namespaces() == ("/robot1", "/robot2")
    second = recording.buffer(namespace="/robot2")
    assert second.lookup_transform("odom", "base", SECOND).transform.translation[0] == 2.0
    with pytest.raises(ValueError, match="several namespaces"):
        recording.buffer()
    with pytest.raises(ValueError, match="/robot3"):
        recording.buffer(namespace="/robot3")


def test_transforms_of_one_message_keep_together():
    records = [record(SECOND, "a", "b"), record(SECOND, "a", "c"), record(2 * SECOND, "a", "b")]
    assert recording_from_records(records).transforms.message.tolist() == [0, 0, 1]
    assert recording_from_records(records).connections[0].count == 2
