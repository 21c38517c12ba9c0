"""A cloud read in the right frame and in a wrong one."""

import numpy as np

from tflab.views.wrong_frames import describe_extent, draw_misread

WALL = np.array([(2.0, -1.0, 0.0), (2.0, 1.0, 1.5)])


def test_a_cloud_is_described_by_how_far_it_reaches_and_a_flat_side_by_one_number():
    assert (
        describe_extent({"wall": WALL}) == "In base_link:\n  wall: x 2.000 m, y -1.000 to 1.000 m, z 0.000 to 1.500 m"
    )


def test_both_readings_are_in_the_words_and_the_picture_fits_on_a_page():
    picture = draw_misread({"wall": WALL}, {"wall": WALL[:, [1, 2, 0]]}, ("as it is", "as misread"))
    assert picture.text == (
        "as it is. In base_link:\n  wall: x 2.000 m, y -1.000 to 1.000 m, z 0.000 to 1.500 m\n"
        "as misread. In base_link:\n  wall: x -1.000 to 1.000 m, y 0.000 to 1.500 m, z 2.000 m"
    )
    assert len(picture.png()) < 60_000


def test_a_side_may_be_empty():
    assert draw_misread({"wall": WALL}, {}, ("all", "none")).text.endswith("none. In base_link:")
