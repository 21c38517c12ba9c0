"""Lanes, the common interval, and a query past either end, in tf2's own words."""

import pytest

from tflab.core import LATEST, BufferCore, LookupException, StampedTransform, Transform, seconds
from tflab.views.timeline import Lane, Timeline, TimelinePicture, answer, draw_timeline, lane_from_history


@pytest.fixture(name="buffer")
def buffer_fixture():
    #  map --(1 s .. 5 s, 1 Hz)--> odom --(2 s .. 6 s, 1 Hz, 1 m/s)--> base_link --(static)--> laser_frame
    buffer = BufferCore()
    for i in range(5):
        buffer.set_transform(StampedTransform("map", "odom", seconds(1 + i), Transform()))
        buffer.set_transform(StampedTransform("odom", "base_link", seconds(2 + i), Transform((float(i), 0.0, 0.0))))
    laser = StampedTransform("base_link", "laser_frame", 0, Transform((0.2, 0.0, 0.15)))
    buffer.set_transform(laser, is_static=True)
    return buffer


@pytest.fixture(name="timeline")
def timeline_fixture(buffer):
    lanes = tuple(lane_from_history(buffer.history(frame)) for frame in ("odom", "base_link", "laser_frame"))
    return Timeline("map", "laser_frame", lanes)


def lane(*stamps_s, is_static=False):
    return Lane("a", "b", tuple(map(seconds, stamps_s)), is_static)


def test_the_common_interval_goes_from_the_last_start_to_the_first_end(timeline):
    assert timeline.common_ns == (seconds(2), seconds(5))
    assert Timeline("a", "b", (lane(1, 3), lane(is_static=True))).common_ns == (seconds(1), seconds(3))
    for lanes in ([lane(is_static=True)], [lane(1, 2), lane(3, 4)], [lane(1, 2), lane()]):
        assert Timeline("a", "b", tuple(lanes)).common_ns is None


def test_a_query_between_two_samples_shows_the_interpolated_pose(timeline, buffer):
    # five seconds of data and a sixth on either side are 6.667 s on 47 steps: 7.05 letters to a second
    text = TimelinePicture(timeline, buffer.lookup_transform).show(seconds(3.25)).text
    assert text == (
        "lookup_transform('map', 'laser_frame', 3.250 s)\n"
        "map -> odom              |      o======o======o======o======o             | 1.000 s to 5.000 s, 5 samples\n"
        "odom -> base_link        |             o======o======o======o======o      | 2.000 s to 6.000 s, 5 samples\n"
        "base_link -> laser_frame |<==============================================>| static\n"
        "all of them              |             ----------------------             | 2.000 s to 5.000 s\n"
        "query                    |                      ^                         | 3.250 s\n"
        "laser_frame in map at 3.250 s\n"
        "translation (1.450, 0.000, 0.150) m\n"
        "roll, pitch, yaw (0.000, 0.000, 0.000) rad"
    )


@pytest.mark.parametrize(
    ("stamp_s", "text"),
    [
        (5.5, "into the future.  Requested time 5.500000 but the latest data is at time 5.000000"),
        (0.5, "into the past.  Requested time 0.500000 but the earliest data is at time 2.000000"),
    ],
)
def test_past_either_end_tf2s_exception_and_text_appear(timeline, buffer, stamp_s, text):
    picture = TimelinePicture(timeline, buffer.lookup_transform).show(seconds(stamp_s))
    whole = (
        f"Lookup would require extrapolation {text}, when looking up transform from frame [laser_frame] to frame [map]"
    )
    assert picture.text.endswith(f"\nExtrapolationException\n{whole}")
    assert picture.headline.get_text() == "ExtrapolationException"
    assert picture.body.text.replace("\n", " ") == whole
    assert picture.handle.get_marker() == "X"
    picture.show(seconds(3.0))
    assert picture.headline.get_text() == "laser_frame in map at 3.000 s"
    assert picture.handle.get_marker() == "o"


def test_the_moment_stays_on_the_card_however_far_the_query_is(timeline, buffer):
    picture = TimelinePicture(timeline, buffer.lookup_transform).show(seconds(3.0))
    before = len(picture.figure.findobj())
    for stamp_s in (0.0, 3.0, 99.0):
        picture.show(seconds(stamp_s)).png()
        words, card = picture.moment.get_window_extent(), picture.figure.bbox
        assert card.x0 < words.x0 and words.x1 < card.x1
    assert len(picture.figure.findobj()) == before  # moving the query adds no artist


def test_a_text_that_is_too_long_for_the_card_is_whole_in_the_words(timeline):
    def refuse(target, source, stamp_ns):
        raise LookupException("word " * 200)

    picture = TimelinePicture(timeline, refuse).show(seconds(3.0))
    assert picture.body.text.count("\n") == 3 and picture.body.text.endswith("\n...")
    assert picture.text.count("word ") == 200


def test_latest_is_the_end_of_the_common_interval_and_every_sample_has_its_mark(timeline, buffer):
    picture = TimelinePicture(timeline, buffer.lookup_transform).show(LATEST)
    assert picture.moment.get_text() == "LATEST: 5.000 s"
    assert answer(timeline, buffer.lookup_transform, LATEST).moment_ns == seconds(5)
    dots = [line for line in picture.ax.lines if line.get_marker() == "o" and len(line.get_xdata()) == 5]
    left_ns, _ = timeline.shown_ns
    places = [[round(float(x) + left_ns / 1e9, 6) for x in dot.get_xdata()] for dot in dots]
    assert places == [[1.0, 2.0, 3.0, 4.0, 5.0], [2.0, 3.0, 4.0, 5.0, 6.0]]


def test_epoch_stamps_keep_their_nanoseconds():
    # a float of seconds could not tell these two apart
    start = 1_700_000_000_000_000_000
    asked = []
    draw_timeline(
        "a", "b", [Lane("a", "b", (start, start + 100))], lambda *q: asked.append(q) or StampedTransform(
            "a", "b", q[2], Transform()), start + 1,
    )  # fmt: skip
    assert asked == [("a", "b", start + 1)]


def test_stamps_since_1970_are_counted_from_a_whole_second():
    start = 1_700_000_000_500_000_000
    lanes = [Lane("a", "b", (start, start + seconds(6)))]
    ax = draw_timeline("a", "b", lanes, lambda a, b, t: StampedTransform(a, b, t, Transform()), start).ax
    assert ax.get_xlabel() == "stamp [s] after 1699999999"  # a sixth of 6 s before the first sample
    labels = [label.get_text() for label in ax.get_xticklabels()]
    assert labels == ["1.0", "2.0", "3.0", "4.0", "5.0", "6.0", "7.0", "8.0"]


@pytest.mark.parametrize(
    ("last_s", "labels"),
    [(4.75, ["1.0", "1.5", "2.0", "2.5", "3.0", "3.5", "4.0", "4.5", "5.0"]), (1.62, ["1.50", "1.55", "1.60", "1.65"])],
)
def test_stamps_stand_at_numbers_that_people_count_in(last_s, labels):
    ax = draw_timeline("a", "b", [lane(1.52, last_s)], _at_rest, seconds(1.52)).ax
    assert [label.get_text() for label in ax.get_xticklabels()] == labels


def test_a_still_card_is_as_high_as_its_answer(timeline, buffer):
    two_rows, text_of_tf2 = (
        draw_timeline(timeline.target_frame, timeline.source_frame, timeline.lanes, buffer.lookup_transform, seconds(s))
        for s in (3.0, 9.0)
    )
    assert two_rows.size_px[1] < text_of_tf2.size_px[1] < TimelinePicture(timeline, _at_rest).size_px[1]
    assert "..." not in text_of_tf2.body.text


def _at_rest(target, source, stamp_ns):
    return StampedTransform(target, source, stamp_ns, Transform())


def test_static_only_and_empty_lanes_are_drawn_too():
    text = draw_timeline("a", "b", [lane(is_static=True)], _at_rest, LATEST).text
    assert "any time" in text and text.startswith("lookup_transform('a', 'b', LATEST)")
    text = draw_timeline("a", "b", [lane(), lane(1, 2)], _at_rest, seconds(1)).text
    assert "no data" in text and "no common time" in text
