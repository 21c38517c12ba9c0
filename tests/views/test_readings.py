"""Two readings of "from A to B"."""

import math

from tflab.core import Transform
from tflab.views.readings import describe_readings, draw_readings

TURNED = Transform.from_rpy(yaw=math.pi / 2, translation=(0.2, 0.0, 0.15))


def test_the_two_readings_are_opposite_transforms():
    # where the laser sits is (0.2, 0, 0.15); for the other, turn back first: (0, 0.2, -0.15)
    assert describe_readings("base_link", "laser_frame", TURNED) == (
        '"from base_link to laser_frame"\n'
        "reading 1: where laser_frame sits in base_link: base_link_T_laser_frame\n"
        "  [ 0.000 -1.000  0.000  0.200 ]\n"
        "  [ 1.000  0.000  0.000  0.000 ]\n"
        "  [ 0.000  0.000  1.000  0.150 ]\n"
        "  [ 0.000  0.000  0.000  1.000 ]\n"
        "reading 2: data of base_link, wanted in laser_frame: laser_frame_T_base_link\n"
        "  [ 0.000  1.000  0.000  0.000 ]\n"
        "  [-1.000  0.000  0.000  0.200 ]\n"
        "  [ 0.000  0.000  1.000 -0.150 ]\n"
        "  [ 0.000  0.000  0.000  1.000 ]"
    )


def test_both_pictures_name_the_transform_that_their_reading_needs():
    picture = draw_readings("map", "odom", TURNED)
    assert [text.get_text() for text in picture.figure.texts] == ["map_T_odom", "odom_T_map"]
    assert len(picture.figure.axes) == 2
