"""Products of transforms as rows of dominoes."""

from itertools import pairwise

import pytest

from tflab.views.transform_chain import describe_dominoes, draw_dominoes, mismatches


def words_in(picture):
    return [text.get_text() for text in picture.figure.axes[0].texts]


def test_a_row_that_fits_comes_down_to_its_two_ends():
    assert describe_dominoes([("map", "odom"), ("odom", "base_link"), ("base_link", "laser_frame")]) == (
        "[map|odom][odom|base_link][base_link|laser_frame]\n"
        "map_T_odom @ odom_T_base_link @ base_link_T_laser_frame\n"
        "fits: map_T_laser_frame"
    )


def test_a_row_in_the_wrong_order_says_which_halves_do_not_match():
    tiles = [("odom", "base_link"), ("map", "odom")]
    assert mismatches(tiles) == [0]
    assert describe_dominoes(tiles).endswith("does not fit: base_link is not map")


def test_every_place_that_does_not_fit_is_marked():
    picture = draw_dominoes(("map", "odom"), ("base_link", "laser_frame"), ("odom", "base_link"))
    assert words_in(picture).count("≠") == 2
    assert "odom is not base_link, laser_frame is not odom" in words_in(picture)


def test_a_row_that_fits_shows_what_is_left():
    picture = draw_dominoes(("map", "odom"), ("odom", "base_link"))
    assert words_in(picture)[-2:] == ["map", "base_link"] and "≠" not in words_in(picture)


def test_a_long_row_stays_on_the_card():
    names = ["map", "odom", "base_footprint", "base_link", "camera_link", "camera_optical_frame"]
    picture = draw_dominoes(*pairwise(names))
    ax = picture.figure.axes[0]
    assert all(0 < text.get_position()[0] < ax.get_xlim()[1] for text in ax.texts)
    assert picture.png() == draw_dominoes(*pairwise(names)).png()


def test_no_domino_is_refused_with_an_example():
    with pytest.raises(ValueError, match="needs at least one, such as"):
        draw_dominoes()
