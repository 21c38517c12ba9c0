"""Who says each edge: none and two are marked, in the picture and in words."""

import pytest

from tflab.views.fault_tables import Owner, describe_owners, draw_owners

TWO = [
    Owner("map -> odom", "localization", "scan", "tf_broadcast", "10.2 Hz"),
    Owner("odom -> base_footprint", "wheel_odometry", "wheels", "publish_tf", "20.2 Hz"),
    Owner("odom -> base_footprint", "ekf_filter_node", "wheels, imu", "publish_tf", "30.1 Hz"),
    Owner("base_link -> laser_frame", ""),
]


def test_the_words_mark_an_edge_with_two_owners_and_one_with_none():
    assert describe_owners(TWO).splitlines() == [
        "map -> odom               localization     scan         tf_broadcast  10.2 Hz",
        "odom -> base_footprint    wheel_odometry   wheels       publish_tf    20.2 Hz  ! 2",
        "odom -> base_footprint    ekf_filter_node  wheels, imu  publish_tf    30.1 Hz  ! 2",
        "base_link -> laser_frame  nobody           -            -             -        ! 0",
    ]


def test_the_picture_says_the_same():
    picture = draw_owners([tuple(owner) for owner in TWO])
    assert picture.text == describe_owners(TWO)
    drawn = [text.get_text() for text in picture.figure.axes[0].texts]
    assert drawn.count("! 2") == 2 and "nobody" in drawn
    with pytest.raises(ValueError, match="needs a row"):
        draw_owners([])
