"""Link poses from joint positions, by hand and by an independent library."""

import math
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from tflab.core import Transform
from tflab.robots.model import Joint, all_positions, joint_transform, link_poses
from tflab.robots.urdf import parse_urdf

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

# base --swing(z) at (1, 0, 0)--> arm --slide(x) at (0, 0, 1), turned on its side--> hand
#                                  '--follow: finger = -2 * slide + 0.1
ROBOT = CASES["robot"]


def test_a_quarter_turn_about_z_turns_the_child_left_about_its_origin():
    poses = link_poses(parse_urdf(ROBOT), {"swing": math.pi / 2})
    assert poses["base"] == Transform()
    assert poses["arm"].apply((2.0, 0.0, 0.0)) == pytest.approx((1.0, 2.0, 0.0))
    robot = parse_urdf(ROBOT)
    assert link_poses(robot)["arm"] == robot.joint("swing").origin  # without a position


def test_a_mimic_joint_follows_unless_its_own_position_is_given():
    robot = parse_urdf(ROBOT)
    assert all_positions(robot, {"slide": 0.2})["follow"] == pytest.approx(-0.3)
    assert all_positions(robot, {})["follow"] == pytest.approx(0.1)
    assert all_positions(robot, {"slide": 0.2, "follow": 1.0})["follow"] == 1.0
    chained = ROBOT.replace('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/><mimic joint="follow" multiplier="10"/>')
    assert all_positions(parse_urdf(chained), {"slide": 0.2})["swing"] == pytest.approx(-3.0)


def test_a_prismatic_joint_slides_a_floating_one_takes_a_pose_and_a_planar_one_moves_square_to_its_axis():
    slide = Joint("j", "prismatic", "a", "b", Transform.from_rpy(yaw=math.pi / 2), axis=(1.0, 0.0, 0.0))
    assert joint_transform(slide, 0.3).translation == pytest.approx((0.0, 0.3, 0.0))
    floating = Joint("j", "floating", "a", "b", Transform((1.0, 0.0, 0.0)))
    assert joint_transform(floating, (0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0)) == Transform((1.0, 2.0, 0.0))
    floor = Joint("j", "planar", "a", "b", axis=(0.0, 0.0, 1.0))
    moved = joint_transform(floor, (1.0, 2.0, math.pi / 2))
    assert moved.apply((1.0, 0.0, 0.0)) == pytest.approx((1.0, 3.0, 0.0))
    wall = Joint("j", "planar", "a", "b", axis=(1.0, 0.0, 0.0))
    assert joint_transform(wall, (1.0, 2.0, 0.5)).apply((0.0, 0.0, 0.0))[0] == pytest.approx(0.0)
    ceiling = Joint("j", "planar", "a", "b", axis=(0.0, 0.0, -1.0))
    assert joint_transform(ceiling, (0.0, 0.0, 0.5)).rpy() == pytest.approx((0.0, 0.0, -0.5))


@pytest.mark.parametrize(("positions", "words"), CASES["invalid"])
def test_an_invalid_position_names_the_expected_type(positions, words):
    with pytest.raises(ValueError, match=words.replace("(", r"\(")):
        link_poses(parse_urdf(ROBOT), positions)


angles = st.floats(-10.0, 10.0)


@settings(max_examples=60, deadline=None)
@given(swing=angles, slide=angles)
def test_every_link_is_where_pinocchio_has_it(swing, slide):
    pin = pytest.importorskip("pinocchio")
    model = pin.buildModelFromXML(ROBOT)
    data = model.createData()
    robot = parse_urdf(ROBOT)
    positions = all_positions(robot, {"swing": swing, "slide": slide})
    configuration = pin.neutral(model)
    for name in ("swing", "slide", "follow"):
        joint = model.joints[model.getJointId(name)]
        angle = positions[name]
        # pinocchio stores an angle without limits as its cosine and sine
        numbers = (math.cos(angle), math.sin(angle)) if joint.nq == 2 else (angle,)
        configuration[joint.idx_q : joint.idx_q + joint.nq] = numbers
    pin.framesForwardKinematics(model, data, configuration)
    for link, root_T_link in link_poses(robot, positions).items():
        expected = data.oMf[model.getFrameId(link)].homogeneous
        assert np.abs(root_T_link.matrix() - expected).max() < 1e-9
