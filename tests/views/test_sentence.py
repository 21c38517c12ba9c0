"""A lookup in five forms, and the two readings of "from A to B"."""

import math

import pytest

from tflab.core import BufferCore, StampedTransform, Transform, seconds
from tflab.views.sentence import SentencePicture, describe_readings, draw_readings, draw_sentence, echo_text, sentence
from tflab.views.style import fmt_all

# the laser is mounted 0.2 m ahead and 0.15 m up, turned to the left by a quarter
BASE_T_LASER = Transform.from_rpy(yaw=math.pi / 2, translation=(0.2, 0.0, 0.15))
LASER_IN_BASE = StampedTransform("base_link", "laser_frame", 0, BASE_T_LASER)


def test_one_question_in_five_ways():
    said = sentence(LASER_IN_BASE)
    assert said.english == "data expressed in [laser_frame], wanted in [base_link]"
    assert said.korean == "[laser_frame] 기준으로 표현된 데이터를 [base_link] 기준으로 보고 싶습니다."
    assert said.call == "lookup_transform('base_link', 'laser_frame', Time())"
    assert said.arrow == "laser_frame o--------> base_link"
    assert said.matrix == (
        "[ 0.000 -1.000  0.000  0.200 ]",
        "[ 1.000  0.000  0.000  0.000 ]",
        "[ 0.000  0.000  1.000  0.150 ]",
        "[ 0.000  0.000  0.000  1.000 ]",
    )
    assert said.echo_command == "ros2 run tf2_ros tf2_echo base_link laser_frame"


def test_the_sentence_agrees_with_the_engine_and_is_read_in_one_language_only():
    buffer = BufferCore()
    buffer.set_transform(LASER_IN_BASE, is_static=True)
    said = sentence(buffer.lookup_transform("laser_frame", "base_link", 0), asked_ns=seconds(4.25))
    assert said.english == "data expressed in [base_link], wanted in [laser_frame]"
    assert said.call == "lookup_transform('laser_frame', 'base_link', Time(nanoseconds=4_250_000_000))"
    assert said.matrix[1] == "[-1.000  0.000  0.000  0.200 ]"  # not minus the step: turned back first
    assert said.text.startswith(said.english) and said.korean not in said.text
    assert said.text_in("ko").startswith(said.korean) and said.english not in said.text_in("ko")


def test_tf2_echo_to_the_letter():
    assert echo_text(LASER_IN_BASE) == (
        "At time 0.0\n"
        "- Translation: [0.200, 0.000, 0.150]\n"
        "- Rotation: in Quaternion [0.000, 0.000, 0.707, 0.707]\n"
        "- Rotation: in RPY (radian) [0.000, -0.000, 1.571]\n"
        "- Rotation: in RPY (degree) [0.000, -0.000, 90.000]\n"
        "- Matrix:\n"
        "  0.000 -1.000  0.000  0.200\n"
        "  1.000  0.000  0.000  0.000\n"
        "  0.000  0.000  1.000  0.150\n"
        "  0.000  0.000  0.000  1.000"
    )


@pytest.mark.parametrize(("pitch", "shown"), [(math.pi / 2, "1.571"), (-math.pi / 2, "-1.571")])
def test_tf2_echo_prints_nanoseconds_without_leading_zeros_and_yaw_zero_when_looking_straight_up_or_down(pitch, shown):
    straight = Transform((0.0, 0.0, 0.0), (0.0, math.copysign(math.sqrt(0.5), pitch), 0.0, math.sqrt(0.5)))
    lines = echo_text(StampedTransform("a", "b", seconds(12.005), straight)).split("\n")
    assert lines[0] == "At time 12.5000000"
    assert lines[3] == f"- Rotation: in RPY (radian) [0.000, {shown}, 0.000]"


def test_the_arrow_goes_from_source_to_target():
    poses = {"base_link": Transform(), "laser_frame": Transform((2.0, 0.0, 0.0))}
    picture = draw_sentence(poses, StampedTransform("base_link", "laser_frame", 0, poses["laser_frame"]))
    (tail, head) = picture.arrow.arrow._posA_posB
    assert tail == pytest.approx(picture.frames["laser_frame"].label.anchor)
    assert head == pytest.approx(picture.frames["base_link"].label.anchor)
    assert picture.frames["laser_frame"].label.text.get_text() == "laser_frame\nsource"
    assert picture.frames["base_link"].label.text.get_text() == "base_link\ntarget"


def test_showing_another_question_changes_all_of_it():
    poses = {"map": Transform(), "odom": Transform((1.0, 0.0, 0.0)), "base_link": Transform((2.0, 0.0, 0.0))}
    picture = SentencePicture(poses)
    picture.show(StampedTransform("map", "odom", 0, Transform((1.0, 0.0, 0.0))))
    picture.show(StampedTransform("odom", "base_link", 0, Transform((1.0, 0.0, 0.0))))
    assert picture.words.get_text() == "data expressed in [base_link], wanted in [odom]"
    assert picture.frames["map"].label.text.get_text() == "map"
    assert "lookup_transform('odom', 'base_link', Time())" in picture.lines.text
    assert "tf2_echo odom base_link" in picture.lines.text
    assert picture.text.startswith("data expressed in [base_link], wanted in [odom]\n")


TURNED = Transform.from_rpy(yaw=math.pi / 2, translation=(0.2, 0.0, 0.15))


def test_the_two_readings_are_opposite_transforms():
    # where the laser sits is (0.2, 0, 0.15); for the other, turn back first: (0, 0.2, -0.15)
    assert describe_readings("base_link", "laser_frame", TURNED) == (
        '"from base_link to laser_frame"\n'
        "reading 1: the pose of laser_frame in base_link: base_link_T_laser_frame\n"
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
