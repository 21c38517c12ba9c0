"""A URDF becomes a model, or an error with line and remedy."""

import math
from pathlib import Path

import pytest
import yaml

from tflab.robots.model import Box, Capsule, Cylinder, Limit, Material, Mesh, Mimic, Sphere
from tflab.robots.urdf import UrdfError, parse_urdf

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
ARM = CASES["arm"]


def robot_text(body: str) -> str:
    return f'<robot name="r">\n{body}\n</robot>'


def joint_text(name: str, parent: str, child: str, kind: str = "fixed", more: str = "") -> str:
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{more}</joint>'


def fault(text: str | bytes) -> UrdfError:
    with pytest.raises(UrdfError) as caught:
        parse_urdf(text, source="robot.urdf")
    return caught.value


def test_links_joints_and_root_are_read():
    robot = parse_urdf(ARM)
    assert (robot.name, robot.root) == ("arm", "base")
    assert [link.name for link in robot.links] == ["base", "upper", "hand"]
    assert [link.has_inertia for link in robot.links] == [False, True, False]
    assert [joint.name for joint in robot.joints] == ["shoulder", "slide"]  # parents first
    assert [joint.name for joint in robot.chain("hand")] == ["shoulder", "slide"]
    assert robot.chain("base") == ()
    with pytest.raises(KeyError, match="has no link 'hnad'; it has base, hand, upper"):
        robot.link("hnad")


def test_origin_axis_limits_and_mimic_of_a_joint_and_their_defaults():
    shoulder, slide = parse_urdf(ARM).joints
    assert shoulder.origin.translation == (1.0, 2.0, 3.0)
    assert shoulder.origin.rotation == pytest.approx((0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))
    assert shoulder.axis == pytest.approx((0.0, 0.6, 0.8))
    assert shoulder.limit == Limit(lower=-1.5, upper=1.5, effort=30.0, velocity=2.0)
    assert shoulder.line == 26
    assert (slide.axis, slide.origin.translation) == ((1.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert slide.mimic == Mimic("shoulder", -2.0, 0.5)
    plain = ARM.replace(' multiplier="-2" offset="0.5"', "")
    assert parse_urdf(plain).joint("slide").mimic == Mimic("shoulder", 1.0, 0.0)


def test_shapes_have_geometry_origin_and_the_colour_defined_elsewhere():
    upper = parse_urdf(ARM).link("upper")
    (tube,) = upper.visuals
    assert tube.geometry == Cylinder(radius=0.05, length=0.4)
    assert tube.origin.translation == (0.0, 0.0, 0.1)
    assert tube.material == Material("grey", (0.5, 0.5, 0.5, 1.0))
    assert [shape.geometry for shape in upper.collisions] == [Box((0.1, 0.2, 0.3))]
    mesh, ball = parse_urdf(ARM).link("hand").visuals
    assert mesh.geometry == Mesh("package://arm/hand.dae", (0.001, 0.001, 0.001))
    assert ball.geometry == Sphere(0.02)
    assert ball.material == Material("", (1.0, 0.0, 0.0, 0.5))


def test_undeclared_prefixes_and_unknown_elements_are_passed_over():
    text = robot_text('<drake:member link="a"/><link name="a"><drake:soft/></link><gazebo><joint name="x"/></gazebo>')
    assert [link.name for link in parse_urdf(text).links] == ["a"]
    declared = '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><!-- ${prefix} <xacro:x/> --><link name="a"/>'
    assert parse_urdf(f"{declared}</robot>").root == "a"


def test_an_axis_of_zeros_on_a_moving_joint_names_the_joint_and_the_line():
    def text(kind):
        joint = joint_text("j", "a", "b", kind, '\n<axis xyz="0 0 0"/>')
        return robot_text(f'<link name="a"/><link name="b"/>\n{joint}')

    assert str(fault(text("revolute"))).startswith('robot.urdf:4: joint "j": axis 0 0 0 has no direction')
    assert parse_urdf(text("fixed")).joint("j").axis == (0.0, 0.0, 0.0)


def test_a_revolute_joint_without_limits_is_read_and_noted():
    text = robot_text('<link name="a"/><link name="b"/>\n' + joint_text("j", "a", "b", "revolute"))
    (note,) = parse_urdf(text).notes
    assert note == 'line 3: joint "j" is revolute and has no <limit>; ROS refuses such a file'


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:include filename="x.xacro"/>\n<link name="a"/>',
        '<link name="${prefix}base"/>',
        '<link name="a"/><link name="b"/>' + joint_text("j", "$(arg p)a", "b"),
    ],
)
def test_unexpanded_xacro_raises_with_the_command_to_run(body):
    error = fault(robot_text(body))
    assert error.line == 2
    assert "Expand it first: xacro robot.urdf > expanded.urdf" in str(error)


def test_two_roots_are_named_with_their_lines():
    error = fault(robot_text('<link name="a"/>\n<link name="b"/>'))
    assert str(error) == (
        'robot.urdf:3: 2 root links: "a" (line 2), "b" (line 3). All but one of them must be the child of a joint'
    )


def test_a_loop_is_named_link_by_link_even_if_another_link_is_a_root():
    body = '<link name="top"/><link name="a"/><link name="b"/><link name="c"/>\n'
    ring = "\n".join([joint_text("ab", "a", "b"), joint_text("bc", "b", "c"), joint_text("ca", "c", "a")])
    error = fault(robot_text(body + ring))
    assert error.joint == "ca"
    assert error.line == 5
    assert "closes a loop of links: a -> b -> c -> a" in str(error)


def test_a_joint_to_a_missing_link_suggests_the_closest_name():
    error = fault(robot_text('<link name="base_link"/>\n' + joint_text("j", "base_lnk", "base_link")))
    assert str(error) == (
        'robot.urdf:3: joint "j": its parent link "base_lnk" does not exist. Did you mean "base_link"?'
    )
    error = fault(robot_text('<link name="a"/>' + joint_text("j", "a", "a")))
    assert 'joint "j": joins link "a" to itself' in str(error)


def test_a_link_with_two_parents_names_both_joints():
    body = '<link name="a"/><link name="b"/><link name="c"/>\n' + joint_text("ac", "a", "c") + "\n"
    error = fault(robot_text(body + joint_text("bc", "b", "c")))
    assert str(error).startswith('robot.urdf:4: joint "bc": link "c" already is the child of joint "ac" (line 3)')


@pytest.mark.parametrize(
    ("body", "name"),
    [
        ('<link name="a"/>\n<link name="a"/>', 'a second link of the name "a"; the first is in line 2'),
        (
            '<link name="a"/><link name="b"/><link name="c"/>\n'
            + joint_text("j", "a", "b")
            + joint_text("j", "b", "c"),
            'joint "j": a second joint of the name "j"; the first is in line 3',
        ),
    ],
)
def test_a_duplicate_name_raises_with_the_line_of_the_first(body, name):
    error = fault(robot_text(body))
    assert error.line == 3
    assert name in str(error)


@pytest.mark.parametrize("written", ["0 0", "0 0 zero", "0,0,0", "0 nan 0", "1_0 0 0", ""])
def test_a_bad_number_names_the_attribute_and_the_joint(written):
    more = f'\n<origin xyz="{written}"/>'
    error = fault(robot_text('<link name="a"/><link name="b"/>\n' + joint_text("j", "a", "b", "fixed", more)))
    assert str(error) == (
        f'robot.urdf:4: joint "j": bad number: <origin> xyz="{written}" should be 3 numbers with spaces between'
    )


@pytest.mark.parametrize(("body", "words"), CASES["missing"])
def test_missing_or_unknown_elements_name_what_is_needed(body, words):
    assert words in str(fault(robot_text(body)))


QUATERNION = '<origin quat_xyzw="0 2 0 2"/>'
CAPSULE = '<capsule radius="0.1" length="0.4"/>'


@pytest.mark.parametrize(
    ("release", "version", "origin", "geometry", "expected"),
    [
        ("humble", "1.2", QUATERNION, "", "Invalid 'version' specified; only version 1.0 is currently supported"),
        ("jazzy", "1.1", "", "", "Invalid 'version' specified; only version 1.0 is currently supported in ROS 2 jazzy"),
        ("jazzy", "1.0", QUATERNION, "", (0.0, 0.0, 0.0, 1.0)),  # as on a robot, which is silent about it
        ("lyrical", "1.0", QUATERNION, "", (0.0, 0.0, 0.0, 1.0)),
        ("lyrical", "1.0", "", CAPSULE, "URDF 1.0 has box, cylinder, sphere, mesh"),
        ("lyrical", "1.1", QUATERNION, CAPSULE, (0.0, math.sqrt(0.5), 0.0, math.sqrt(0.5))),
        ("lyrical", "1.2", '<origin quat_xyzw="0 0 0 1" rpy="0 0 0"/>', "", "either rpy or quat_xyzw"),
        ("lyrical", "1.2", '<origin quat_xyzw="0 0 0 0"/>', "", "a quaternion has a length"),
        ("lyrical", "1.3", "", "", "only versions 1.0 to 1.2 are currently supported in ROS 2 lyrical"),
    ],
)
def test_urdf_after_1_0_is_read_as_the_release_reads_it(monkeypatch, release, version, origin, geometry, expected):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", release)
    visual = "<visual><geometry>" + (geometry or '<sphere radius="1"/>') + "</geometry></visual>"
    text = robot_text(f'<link name="a">{visual}</link><link name="b"/>' + joint_text("j", "a", "b", "fixed", origin))
    text = text.replace('"r"', f'"r" version="{version}"')
    if isinstance(expected, str):
        assert expected in str(fault(text))
        return
    robot = parse_urdf(text)
    assert robot.joint("j").origin.rotation == pytest.approx(expected)
    assert robot.link("a").visuals[0].geometry == (Capsule(0.1, 0.4) if geometry else Sphere(1.0))
    assert ("quat_xyzw is ignored" in "".join(robot.notes)) is (version == "1.0")


@pytest.mark.parametrize(("mimic", "words"), CASES["mimics"])
def test_a_mimic_must_follow_another_joint_that_has_one_position(mimic, words):
    body = '<link name="a"/><link name="b"/><link name="c"/>' + joint_text("ball", "a", "c", "floating")
    error = fault(robot_text(body + joint_text("j", "a", "b", "continuous", f'<mimic joint="{mimic}"/>')))
    assert words in str(error)


def test_two_hyphens_in_a_comment_are_explained_with_their_line():
    error = fault('<robot name="r">\n<!-- all\n is -- well -->\n<link name="a"/></robot>')
    assert error.line == 3
    assert 'two hyphens, "--", inside a comment' in str(error)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "robot.urdf:1: the file is empty"),
        ("not xml", "robot.urdf:1: not well-formed XML"),
        ('<robot name="r">\n<link name="a">', "robot.urdf:2: not well-formed XML"),
        ('<sdf version="1.6"/>', "robot.urdf:1: a URDF begins with <robot>, this file with <sdf>. That is SDF"),
        (b'<?xml version="1.0" encoding="uft-8"?><robot name="r"/>', "cannot be read as text: unknown encoding: uft-8"),
        ('<robot name="r"><link name="a"/><link name="a&#10;b"/></robot>', '"a b" (line 1)'),
        ('<robot name="r">\ud800</robot>', "these bytes cannot be read as text"),
        ('<!DOCTYPE r [<!ENTITY e "x">]>\n<robot name="&e;"/>', "the entity &e; is declared here"),
    ],
)
def test_a_file_that_is_not_a_urdf_raises_in_one_line(text, words):
    error = str(fault(text))
    assert words in error
    assert "\n" not in error


def test_a_chain_of_two_thousand_links_is_read():
    links = "".join(f'<link name="l{i}"/>' for i in range(2000))
    joints = "".join(joint_text(f"j{i}", f"l{i}", f"l{i + 1}") for i in range(1999))
    robot = parse_urdf(robot_text(links + joints))
    assert len(robot.chain("l1999")) == 1999
