"""One drive, told by several frames: how large its steps are, and how far it is off."""

import numpy as np
import pytest

from tflab.views.map_error import describe_tracks, draw_tracks, smoothness

# The robot drives along x, 1 m a second.  One track is 1 cm short each second, the other leaps by half a metre once.
TIMES_S = np.arange(5.0)
TRUTH = np.column_stack((TIMES_S, np.zeros(5)))
DRIFTS = TRUTH * (0.99, 1.0)
LEAPS = TRUTH + np.array([(0, 0), (0, 0), (0, 0.5), (0, 0.5), (0, 0.5)])


def test_a_track_that_drifts_has_small_steps_and_a_growing_error():
    assert smoothness(DRIFTS, TRUTH) == pytest.approx((0.99, 0.04))


def test_a_track_that_leaps_has_one_step_that_no_robot_drives():
    assert smoothness(LEAPS, TRUTH) == pytest.approx((np.hypot(1.0, 0.5), 0.5))


def test_the_words_say_the_same():
    assert describe_tracks({"map": LEAPS, "odom": DRIFTS}, TRUTH).splitlines() == [
        "map   largest step 1.118 m, worst error 0.500 m",
        "odom  largest step 0.990 m, worst error 0.040 m",
    ]


def test_tracks_are_told_apart_by_their_lines_too():
    ground, steps, errors = draw_tracks({"map": LEAPS, "odom": DRIFTS}, TRUTH, TIMES_S).figure.axes
    for axes in (steps, errors):
        assert len({line.get_linestyle() for line in axes.lines}) == 2
    assert [text.get_text() for text in ground.get_legend().get_texts()] == ["truth", "map", "odom"]


@pytest.mark.parametrize(
    ("tracks", "why"),
    [
        ({}, "between one and 3 tracks"),
        ({"short": TRUTH[:3]}, "short has 3 samples, and there are 5 times"),
    ],
)
def test_what_cannot_be_drawn_is_said(tracks, why):
    with pytest.raises(ValueError, match=why):
        draw_tracks(tracks, TRUTH, TIMES_S)


def test_the_picture_is_small_and_the_same_bytes_every_time():
    first, again = (draw_tracks({"odom": DRIFTS}, TRUTH, TIMES_S).png() for _ in range(2))
    assert first == again
    assert len(first) < 60_000
