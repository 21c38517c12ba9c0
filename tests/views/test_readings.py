"""Two readings of "from A to B"."""

import math

from tflab.core import Transform
from tflab.views.sentence import describe_readings, draw_readings
from tflab.views.style import fmt_all

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
    names_and_numbers = [text.get_text() for text in picture.figure.texts]
    assert names_and_numbers[::2] == ["map_T_odom", "odom_T_map"]
    there, back = names_and_numbers[1::2]
    assert there.endswith("along the axes of map") and back.endswith("along the axes of odom")
    assert there.startswith(fmt_all(TURNED.translation, digits=2))
    assert back.startswith(fmt_all(TURNED.inverse().translation, digits=2))
    assert len(picture.figure.axes) == 2
