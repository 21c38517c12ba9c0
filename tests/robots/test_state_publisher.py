"""robot_state_publisher publishes and logs what the real node does, at the same times."""

import math
from pathlib import Path
from typing import NamedTuple

import pytest
import yaml

from tflab.core import seconds
from tflab.robots.state_publisher import RobotStatePublisher, main
from tflab.ros import client_library as rclpy
from tflab.ros.convert import msg_from_stamp, stamped_from_msg
from tflab.ros.graph import new_graph
from tflab.ros.messages import sensor_msgs, std_msgs, tf2_msgs
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

TERMINATED = "terminate called after throwing an instance of 'std::runtime_error'"
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

# base -+- bolt (fixed) -> plate            turn (revolute about z, 1 m ahead) -> arm -- slide -> hand
#       +- float (floating) -> balloon      follow: mimics turn, half and 0.1 more -> finger
#       '- glide (planar) -> puck
URDF = CASES["urdf"]


class Stage(NamedTuple):
    """A robot_state_publisher, somebody who listens, and a way to speak to it."""

    graph: object
    publisher: RobotStatePublisher
    listener: Node
    moving: list
    static: list

    def say(self, stamp_s: float, **positions: float) -> None:
        """Deliver a joint state at the moment of its stamp, or now if that is past."""
        self.graph.run(seconds=max(stamp_s - self.graph.now_ns / 1e9, 0.0))
        state = sensor_msgs.JointState(name=list(positions), position=list(positions.values()))
        state.header.stamp = msg_from_stamp(seconds(stamp_s))
        self.publisher.on_joint_state(state)
        self.settle()

    def settle(self) -> None:
        for node in (self.publisher, self.listener):
            for _ in range(8):
                rclpy.spin_once(node, timeout_sec=0)

    def heard(self) -> list[str]:
        return [each.child_frame_id for message in self.moving for each in message.transforms]


def staged(**parameters: object) -> Stage:
    graph = new_graph()
    rclpy.init(args=[])
    overrides = [Parameter(name, value=value) for name, value in {"robot_description": URDF, **parameters}.items()]
    publisher = RobotStatePublisher(parameter_overrides=overrides)
    listener = Node("listener")
    stage = Stage(graph, publisher, listener, [], [])
    listener.create_subscription(tf2_msgs.TFMessage, "/tf", stage.moving.append, 100)
    listener.create_subscription(tf2_msgs.TFMessage, "/tf_static", stage.static.append, LATCHED)
    stage.settle()
    return stage


@pytest.fixture(autouse=True)
def clean_graph():
    yield
    rclpy.try_shutdown()
    new_graph()


def test_fixed_joints_and_the_description_are_latched_with_the_time_of_the_start():
    stage, texts = staged(), []
    (message,) = stage.static
    bolt, glide = (stamped_from_msg(each) for each in message.transforms)
    assert (bolt.frame_id, bolt.child_frame_id, bolt.stamp_ns) == ("base", "plate", seconds(1.0))
    assert bolt.transform.translation == (0.0, 0.0, 0.5)
    assert (glide.child_frame_id, glide.transform.translation) == ("puck", (0.0, 2.0, 0.0))  # planar counts as fixed
    stage.listener.create_subscription(std_msgs.String, "/robot_description", texts.append, LATCHED)
    stage.settle()
    assert [text.data for text in texts] == [URDF]


def test_moving_joints_are_published_with_the_stamp_of_the_message_by_the_alphabet():
    stage = staged()
    stage.say(2.5, turn=math.pi / 2, slide=0.25)
    (message,) = stage.moving
    follow, slide, turn = (stamped_from_msg(each) for each in message.transforms)
    assert {each.stamp_ns for each in (follow, slide, turn)} == {seconds(2.5)}
    assert slide.transform.translation == (0.25, 0.0, 0.0)
    assert turn.transform.translation == (1.0, 0.0, 0.0)
    assert turn.transform.rpy()[2] == pytest.approx(math.pi / 2)
    assert follow.transform.rpy()[2] == pytest.approx(math.pi / 4 + 0.1)
    stage.moving.clear()
    stage.say(3.0, follow=0.0, stranger=1.0)  # only what a message names, and that with its own value
    assert stage.heard() == ["finger"]
    follow = stamped_from_msg(stage.moving[0].transforms[0])
    assert follow.transform.rpy()[2] == pytest.approx(0.0)


def test_messages_come_through_at_most_at_the_publish_frequency():
    stage = staged(publish_frequency=10.0)
    for stamp_s in (2.0, 2.05, 2.09, 2.1, 2.15, 2.2):
        stage.say(stamp_s, slide=0.0)
    assert [stamped_from_msg(m.transforms[0]).stamp_ns for m in stage.moving] == [seconds(t) for t in (2.0, 2.1, 2.2)]
    stage = staged(publish_frequency=300.0)  # 3.33 ms count as 3
    stage.say(2.0, slide=0.0)
    stage.say(2.003, slide=0.0)
    assert len(stage.moving) == 2


def test_the_joint_that_waited_longest_decides():
    stage = staged(publish_frequency=10.0)
    stage.say(2.0, slide=0.0)
    stage.say(2.01, slide=0.0, turn=0.0)  # turn is new, so it is due
    assert stage.heard() == ["hand", "finger", "hand", "arm"]


def test_a_joint_state_without_a_stamp_is_published_only_with_ignore_timestamp():
    stage = staged()
    stage.say(0.0, slide=0.0)
    assert stage.moving == []
    carefree = staged(ignore_timestamp=True)
    carefree.say(0.0, slide=0.0)
    carefree.say(0.0, slide=0.0)
    assert len(carefree.moving) == 2


def test_the_prefix_goes_before_every_frame_as_it_is():
    stage = staged(frame_prefix="robot1/")
    stage.say(2.0, slide=0.0)
    assert [each.child_frame_id for each in stage.static[0].transforms] == ["robot1/plate", "robot1/puck"]
    assert stage.heard() == ["robot1/hand"]
    assert stage.moving[0].transforms[0].header.frame_id == "robot1/arm"


def test_bad_joint_states_are_logged(capfd):
    stage = staged()
    stage.publisher.on_joint_state(sensor_msgs.JointState(name=["turn", "slide"]))
    stage.publisher.on_joint_state(sensor_msgs.JointState(name=["turn", "slide"], position=[1.0]))
    lines = capfd.readouterr().err.splitlines()
    assert lines[-2].endswith(
        '[robot_state_publisher]: Robot state publisher ignored a JointState message about joint(s) "turn"(,...) '
        "whose position member was empty."
    )
    assert lines[-2].startswith("[WARN]")
    assert lines[-1].startswith("[ERROR]")
    assert lines[-1].endswith("Robot state publisher ignored an invalid JointState message")
    assert stage.moving == []


def test_after_the_clock_went_back_joints_are_published_again(capfd):
    stage = staged(publish_frequency=1.0)
    clock = stage.publisher.get_clock()
    clock.offset_ns = seconds(10.0)
    stage.say(11.0, slide=0.0)
    clock.offset_ns = 0
    stage.say(1.5, slide=0.0)
    assert len(stage.moving) == 2
    assert "Moved backwards in time, re-publishing joint transforms!" in capfd.readouterr().err


def test_it_announces_itself_and_what_kdl_cannot_do(capfd):
    heavy = URDF.replace('<link name="base"/>', '<link name="base"><inertial/></link>')
    staged(robot_description=heavy)
    text = capfd.readouterr().err
    assert "[robot_state_publisher]: Robot initialized" in text
    assert "[kdl_parser]: The root link base has an inertia specified in the URDF, but KDL does not support" in text
    assert "Converting unknown joint type of joint 'float' into a fixed joint" in text


def test_a_new_description_changes_the_robot_and_its_static_transforms():
    stage = staged()
    results = stage.publisher.set_parameters(
        [Parameter("robot_description", value=URDF.replace('xyz="0 0 0.5"', 'xyz="0 0 0.7"'))]
    )
    assert results[0].successful
    stage.settle()
    plate = stamped_from_msg(stage.static[-1].transforms[0])
    assert (plate.child_frame_id, plate.transform.translation) == ("plate", (0.0, 0.0, 0.7))


@pytest.mark.parametrize(("name", "value", "reason"), CASES["refused"])
def test_parameters_that_cannot_work_are_refused_with_the_reason(name, value, reason):
    (result,) = staged().publisher.set_parameters([Parameter(name, value=value)])
    assert (result.successful, result.reason) == (False, reason)


@pytest.mark.parametrize(("parameters", "words", "logged"), CASES["does_not_start"])
def test_without_a_robot_or_with_an_impossible_rate_it_does_not_start(parameters, words, logged, capfd):
    with pytest.raises(RuntimeError) as caught:
        staged(**parameters)
    assert str(caught.value) == words
    assert logged in capfd.readouterr().err


@pytest.mark.parametrize(
    ("release", "file", "words"),
    [
        ("jazzy", "r.urdf", "in the future.\n[WARN] [1.000000000] [kdl_parser]: Converting unknown joint"),
        ("jazzy", "nobody.urdf", "what():  Failed to open URDF file: nobody.urdf: No such file or directory"),
        ("jazzy", "", f"{TERMINATED}\n  what():  robot_description parameter must not be empty"),
        ("lyrical", "r.urdf", "what():  robot_description parameter must not be empty"),
    ],
)
def test_it_takes_a_file_up_to_jazzy(monkeypatch, tmp_path, capfd, release, file, words):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", release)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "r.urdf").write_text(URDF)
    new_graph().start(main, [file] if file else [])
    assert words in capfd.readouterr().err


def test_as_a_program_it_serves_joint_states_until_it_is_interrupted():
    graph = new_graph()
    command_line = ["robot_state_publisher", "--ros-args", "-p", f"robot_description:={URDF!r}"]
    participant = graph.start(main, argv=command_line)
    rclpy.init(args=[])
    node = Node("driver")
    heard = []
    node.create_subscription(tf2_msgs.TFMessage, "/tf", heard.append, 10)
    states = node.create_publisher(sensor_msgs.JointState, "/joint_states", 10)
    state = sensor_msgs.JointState(name=["slide"], position=[0.5])
    state.header.stamp = msg_from_stamp(seconds(1.1))
    states.publish(state)
    graph.run(seconds=0.1)
    rclpy.spin_once(node, timeout_sec=0.1)
    assert [each.child_frame_id for each in heard[0].transforms] == ["hand"]
    graph.stop()
    assert not participant.is_running
