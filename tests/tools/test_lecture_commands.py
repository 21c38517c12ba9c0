"""Every command of the lecture, on a graph: accepted, and answered as the real tools answer.

The lines are the lecture's own, `\\` at their ends joined, in its order.
"""

import re
import time
from pathlib import Path

import pytest
import yaml

from tflab.core import seconds
from tflab.ros import client_library as rclpy
from tflab.ros import snapshot
from tflab.ros.messages.std_msgs import String
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.node import Node
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformBroadcaster, TransformListener
from tflab.ros.time import Time
from tflab.tools.rviz import look
from tflab.tools.trees import frame_tree

from .robot import fixed, moving, transform

TF_HASH = "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"
UNKNOWN_MAP = 'Invalid frame ID "map" passed to canTransform argument target_frame - frame does not exist'

ODOM_TO_BASE, LASER_MESSAGE = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8")).values()


@pytest.fixture
def robot(terminal):
    """odom -> base_link -> laser_frame, one second old."""
    terminal.graph.start(moving(), name="moving_robot_broadcaster")
    terminal.graph.start(fixed(), name="static_sensor_broadcaster")
    terminal.graph.run(seconds=1)
    return terminal


def intruder():
    """Begins after two seconds, and gives base_link another parent."""
    time.sleep(2)
    moving(parent="elsewhere", name="intruder", rate_hz=97.0)()


def endpoint(name, kind, gid, depth, durability):
    return f"""\
Node name: {name}
Node namespace: /
Topic type: tf2_msgs/msg/TFMessage
Topic type hash: {TF_HASH}
Endpoint type: {kind}
GID: {gid}
QoS profile:
  Reliability: RELIABLE
  History (Depth): KEEP_LAST ({depth})
  Durability: {durability}
  Lifespan: Infinite
  Deadline: Infinite
  Liveliness: AUTOMATIC
  Liveliness lease duration: Infinite
"""


def gid_of(terminal, topic):
    (publisher,) = terminal.graph.network.topic(topic).publishers
    return ".".join(f"{byte:02x}" for byte in publisher.gid)


# -- §7 and §27: static and dynamic ---------------------------------------


def test_topic_info_verbose(robot, monkeypatch):
    for topic, name, depth, durability in (
        ("/tf", "moving_robot_broadcaster", 100, "VOLATILE"),
        ("/tf_static", "static_sensor_broadcaster", 1, "TRANSIENT_LOCAL"),
    ):
        assert robot.type(f"ros2 topic info {topic} --verbose") == (
            "Type: tf2_msgs/msg/TFMessage\n\nPublisher count: 1\n\n"
            + endpoint(name, "PUBLISHER", gid_of(robot, topic), depth, durability)
            + "\nSubscription count: 0\n\n"
        )
    monkeypatch.setenv("TFLAB_ROS_DISTRO", "humble")
    assert "Topic type hash" not in robot.type("ros2 topic info /tf --verbose")


def test_a_gid_has_the_form_of_fast_dds(robot):
    def main():
        rclpy.init()
        node = rclpy.create_node("both")
        node.create_subscription(String, "t", print, 1)
        node.create_publisher(String, "t", 1)
        rclpy.spin(node)

    dynamic, static = gid_of(robot, "/tf"), gid_of(robot, "/tf_static")
    form = r"01\.0f\.2a\.e5(\.[0-9a-f]{2}){4}\.00\.00\.00\.00(\.[0-9a-f]{2}){3}\.03"
    assert re.fullmatch(form, dynamic) and re.fullmatch(form, static)
    assert dynamic[:23] != static[:23]  # two programs, two participants
    robot.graph.start(main)
    robot.graph.run(seconds=0.1)
    topic = robot.graph.network.topic("/t")
    sent, heard = topic.publishers[0].gid, topic.subscriptions[0].gid
    assert sent[:12] == heard[:12] and (sent[-1], heard[-1]) == (0x03, 0x04)  # one participant, two kinds


# -- §8: static_transform_publisher ---------------------------------------


def test_static_transform_publisher_goes_on_after_the_line(terminal):
    out = terminal.type(
        "ros2 run tf2_ros static_transform_publisher --x 0.20 --y 0.0 --z 0.15 --roll 0.0 --pitch 0.0 --yaw 0.0 "
        "--frame-id base_link --child-frame-id laser_frame   # a comment, as in a shell"
    )
    (name,) = [node.get_name() for node in terminal.graph.nodes]
    assert name.startswith("static_transform_publisher_")
    assert len(name) == len("static_transform_publisher_") + 16
    assert out + terminal.error == (
        f"[INFO] [1.000000000] [{name}]: Spinning until stopped - publishing transform\n"
        "translation: ('0.200000', '0.000000', '0.150000')\n"
        "rotation: ('0.000000', '0.000000', '0.000000', '1.000000')\n"
        "from 'base_link' to 'laser_frame'\n"
    )
    assert terminal.type("ros2 topic echo /tf_static --once") == LASER_MESSAGE


def test_static_transform_publisher_says_what_is_wrong(terminal):
    out = terminal.type("ros2 run tf2_ros static_transform_publisher --frame-id map")
    said = "[ERROR] [1.000000000] []: error parsing command line arguments: Child frame id must not be empty\n"
    assert said in out + terminal.error
    assert out.endswith("[ros2run]: Process exited with failure 1\n")
    assert terminal.exit_code == 1
    terminal.type("ros2 run tf2_ros static_transform_publisher --frame-id a --child-frame-id a")
    assert "cannot publish static transform from 'a' to 'a', exiting\n" in terminal.error
    assert "  what():  child_frame_id cannot equal frame_id\n" in terminal.error
    assert terminal.exit_code == -6
    assert terminal.type("ros2 run tf2_ros static_transform_publisher --help").startswith("usage: static_transform_")
    assert terminal.exit_code == 0


def test_static_transform_publisher_shows_its_values_as_parameters(terminal):
    terminal.type("ros2 run tf2_ros static_transform_publisher --x 2 --frame-id a --child-frame-id b")
    (name,) = [node.get_name() for node in terminal.graph.nodes]
    assert terminal.type(f"ros2 param get /{name} translation.x") == "Double value is: 2.0\n"
    terminal.type(f"ros2 param set /{name} translation.x 3.0")
    assert terminal.error.startswith("Setting parameter failed: Trying to set a read-only parameter")


# -- §12: view_frames -----------------------------------------------------


def test_view_frames(robot, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    out = robot.type("ros2 run tf2_tools view_frames")
    log = (out + robot.error).splitlines()
    assert log[0] == "[INFO] [2.000000000] [view_frames]: Listening to tf data for 5.0 seconds..."
    assert log[1] == "[INFO] [7.000000000] [view_frames]: Generating graph..."
    assert log[2].startswith(
        '[INFO] [7.000000000] [view_frames]: Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml="laser_frame: \\n'
    )
    assert log[3] == ("[INFO] [7.000000000] [view_frames]: Exporting graph in frames_1970-01-01_00.00.07.pdf file...")
    assert len(log) == 4
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "frames_1970-01-01_00.00.07.gv",
        "frames_1970-01-01_00.00.07.pdf",
    ]
    (picture,) = robot.pictures
    assert picture.text.splitlines()[0] == "view_frames Result, recorded at time: 7.0"
    assert "default_authority" in picture.text  # ROS 2 does not say who it was


# -- §13, §23, §27: tf2_echo ----------------------------------------------


def test_tf2_echo(robot):
    out = robot.type("ros2 run tf2_ros tf2_echo odom base_link")
    assert out.startswith(ODOM_TO_BASE)
    assert [line for line in out.splitlines() if line.startswith("At")] == [
        "At time 2.950000000", "At time 3.950000000", "At time 4.950000000",
    ]  # fmt: skip
    out = robot.type("ros2 --for 1.5 run tf2_ros tf2_echo base_link laser_frame")
    assert out.splitlines()[:2] == ["At time 0.0", "- Translation: [0.200, 0.000, 0.150]"]
    out = robot.type("ros2 --for 1.5 run tf2_ros tf2_echo laser_frame base_link")
    assert "- Translation: [-0.200, 0.000, -0.150]" in out
    assert robot.type("ros2 --for 1.05 run tf2_ros tf2_echo odom base_link 10").count("At time") == 10
    assert 0 < robot.type("ros2 --for 0.1 run tf2_ros tf2_echo odom base_link inf").count("At time") <= 100


def test_tf2_echo_map_base_link_without_a_map_waits(robot):
    out = robot.type("ros2 run tf2_ros tf2_echo map base_link")
    assert (out + robot.error).splitlines() == [
        f"[INFO] [{second}.000000000] [tf2_echo]: Waiting for transform map ->  base_link: {UNKNOWN_MAP}"
        for second in (2, 3, 4, 5)
    ]


def test_tf2_echo_waits_with_one_line_a_second_however_often_it_asks(terminal):
    out = terminal.type("ros2 --for 2.5 run tf2_ros tf2_echo map base_link 10")
    assert (out + terminal.error).count("Waiting for transform map ->  base_link: ") == 3


def test_tf2_echo_goes_on_when_a_lookup_fails(robot):
    robot.graph.start(intruder)
    out = robot.type("ros2 run tf2_ros tf2_echo odom base_link")
    assert (
        "Failure at 5.000\n"
        "Exception thrown:Could not find a connection between 'odom' and 'base_link' because they are not part of "
        "the same tree.Tf has two or more unconnected trees.\n"
        "The current list of frames is:\n"
        "Frame laser_frame exists with parent base_link.\n"
        "Frame base_link exists with parent elsewhere.\n\n"
    ) in out


def late():
    """Sends base_link's place of a minute ago, after all tools have begun."""
    rclpy.init()
    node = rclpy.create_node("late")
    broadcaster = TransformBroadcaster(node)

    def send():
        old = transform(node, "odom", "base_link")
        old.header.stamp.sec -= 60
        broadcaster.sendTransform(old)

    node.create_timer(0.5, send)
    rclpy.spin(node)


@pytest.mark.parametrize(
    ("command", "authority"),
    [
        ("ros2 --for 4 run tf2_ros tf2_echo odom base_link", "Authority undetectable"),
        ("ros2 --for 4 run tf2_ros tf2_monitor odom base_link", "Authority undetectable"),
        ("ros2 run tf2_tools view_frames", "default_authority"),
        (None, "Authority undetectable"),  # RViz is a tool in C++
    ],
)
def test_a_tool_names_the_authority_of_its_client_library(robot, capsys, command, authority, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    robot.graph.start(late)
    if command is None:
        look(robot.graph)
    else:
        robot.type(command)
    assert f"according to authority {authority}\n" in robot.error + capsys.readouterr().err


def test_a_tool_in_cpp_warns_of_qos_with_the_policys_whole_name(terminal):
    def main():
        rclpy.init()
        node = rclpy.create_node("mount")
        node.create_publisher(TFMessage, "/tf_static", 1)
        rclpy.spin(node)

    terminal.graph.start(main)
    terminal.graph.run(seconds=0.1)
    terminal.type("ros2 run tf2_ros tf2_echo base_link laser_frame")
    (line,) = [line for line in terminal.error.splitlines() if "[transform_listener_impl_55" in line]
    assert line.endswith(
        "New publisher discovered on topic '/tf_static', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: DURABILITY_QOS_POLICY"
    )


def test_two_tools_at_once_do_not_share_a_listener(robot):
    for _ in range(2):
        robot.graph.start(lambda: __import__("tflab.tools.tf2_echo", fromlist=["main"]).main(["odom", "base_link"]))
    names = robot.type("ros2 node list").split()
    assert len([name for name in names if name.startswith("/transform_listener_impl_")]) == 2


# -- §14, §27: tf2_monitor ------------------------------------------------


def test_tf2_monitor(robot):
    out = robot.type("ros2 run tf2_ros tf2_monitor")
    assert out.startswith("Gathering data on all frames for 10 seconds...\n\n\n\nRESULTS: for all Frames\n\nFrames:\n")
    assert "Frame: base_link, published by <no authority available>, Average Delay: 0, Max Delay: 0\n" in out
    assert "\nAll Broadcasters:\n" in robot.error
    assert out.splitlines()[-1].startswith("Node: <no authority available> 20.")


def test_tf2_monitor_map_base_link(robot):
    robot.type("ros2 run tf2_ros static_transform_publisher --frame-id map --child-frame-id odom")
    out = robot.type("ros2 --for 12 run tf2_ros tf2_monitor map base_link")
    assert out.startswith(
        "Gathering data on map -> base_link for 10 seconds...\n\n\n\n"
        "RESULTS: for map to base_link\nChain is: map -> odom -> base_link\nNet delay     avg = "
    )
    assert [line.split(",")[0] for line in out.splitlines() if line.startswith("Frame:")] == [
        "Frame: base_link", "Frame: odom",
    ]  # fmt: skip


def test_tf2_monitor_shows_a_delay(terminal):
    terminal.graph.disturb("/tf", delay=0.25)
    terminal.graph.start(moving())
    out = terminal.type("ros2 run tf2_ros tf2_monitor")
    assert "Average Delay: 0.25, Max Delay: 0.25" in out


def test_tf2_monitor_dies_when_the_chain_breaks_and_wants_two_frames_or_none(robot):
    out = robot.type("ros2 run tf2_ros tf2_monitor map")
    said = "[INFO] [2.000000000] [tf2_monitor_main]: TF_Monitor: usage: tf2_monitor framea frameb\n"
    assert said in out + robot.error
    assert robot.exit_code == 255
    robot.graph.start(intruder)
    out = robot.type("ros2 run tf2_ros tf2_monitor odom base_link")
    assert "terminate called after throwing an instance of 'tf2::ConnectivityException'\n" in robot.error
    assert out.endswith("[ros2run]: Aborted\n")
    assert robot.exit_code == -6


# -- §15: rviz2 -----------------------------------------------------------


def test_rviz2_names_the_view_to_open(terminal):
    assert "%rviz2 -f map" in terminal.type("rviz2")
    assert terminal.exit_code == 0


# -- §22: simulated time --------------------------------------------------


def test_topic_echo_clock_once_without_a_clock(terminal):
    assert terminal.type("ros2 topic echo /clock --once") == (
        "WARNING: topic [/clock] does not appear to be published yet\n"
    )
    assert terminal.error == "Could not determine the type for the passed topic\n"
    assert terminal.exit_code == 1


def test_param_get_and_set_use_sim_time(terminal):
    terminal.graph.start(moving(name="point_to_map"))
    assert terminal.type("ros2 param get /point_to_map use_sim_time") == "Boolean value is: False\n"
    assert terminal.type("ros2 param set /point_to_map use_sim_time true") == "Set parameter successful\n"
    assert terminal.type("ros2 param get /point_to_map use_sim_time") == "Boolean value is: True\n"
    assert terminal.type("ros2 topic info /clock") == (
        "Type: rosgraph_msgs/msg/Clock\nPublisher count: 0\nSubscription count: 1\n"
    )
    terminal.type("ros2 param get /problem_node use_sim_time")
    assert (terminal.error, terminal.exit_code) == ("Node not found\n", 1)
    terminal.type("ros2 node info /problem_node")
    assert (terminal.error, terminal.exit_code) == ("Unable to find node '/problem_node'\n", 1)
    assert terminal.type("ros2 node list") == "/point_to_map\n"


def test_bag_record_and_bag_info(robot, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    robot.type("ros2 --for 2 bag record /scan /odom /tf /tf_static /clock -o drive")
    out = robot.type("ros2 bag info drive")
    assert "Messages:          41\n" in out  # 20 Hz for 2 s, and the laser
    assert "Topic: /tf_static | Type: tf2_msgs/msg/TFMessage | Count: 1 | Serialization Format: cdr" in out
    assert "/scan" not in out  # nobody published it, and nobody said so
    robot.type("ros2 bag info")
    assert robot.error.endswith("ros2 bag info: error: the following arguments are required: bag_path\n")
    assert robot.exit_code == 2


# -- §11: robot_state_publisher -------------------------------------------

URDF = """<robot name="tf_lab_robot"><link name="base_link"/><link name="laser_frame"/>
<joint name="base_to_laser" type="fixed"><parent link="base_link"/><child link="laser_frame"/>
<origin xyz="0.20 0.0 0.15" rpy="0.0 0.0 0.0"/></joint></robot>"""


@pytest.fixture
def state_publisher(terminal):
    description = URDF.replace("\n", " ")
    terminal.type(
        f"ros2 run robot_state_publisher robot_state_publisher --ros-args -p 'robot_description:={description}'"
    )
    return terminal


def test_topics_of_robot_state_publisher(terminal, state_publisher):
    out = state_publisher.type("ros2 topic echo /robot_description --once")
    assert out.startswith('data: <robot name="tf_lab_robot">')
    assert out.endswith("...\n---\n")  # after 128 letters
    out = state_publisher.type("ros2 topic echo /joint_states")
    assert (out, state_publisher.exit_code) == ("", None)  # it listens, and nobody publishes
    out = state_publisher.type("ros2 --for 1.5 run tf2_ros tf2_echo base_link laser_frame")
    assert "- Translation: [0.200, 0.000, 0.150]" in out


def test_node_info_robot_state_publisher(state_publisher):
    out = state_publisher.type("ros2 node info /robot_state_publisher")
    assert out.startswith("/robot_state_publisher\n  Subscribers:\n    /joint_states: sensor_msgs/msg/JointState\n")
    assert "    /robot_description: std_msgs/msg/String\n" in out
    assert "    /tf: tf2_msgs/msg/TFMessage\n    /tf_static: tf2_msgs/msg/TFMessage\n" in out


# -- §23: three experiments -----------------------------------------------

MAP_TO_ODOM = (
    "ros2 run tf2_ros static_transform_publisher --x 0 --y 0 --z 0 --yaw 0 --pitch 0 --roll 0 "
    "--frame-id map --child-frame-id odom"
)
ODOM_TO_BASE_LINK = (
    "ros2 run tf2_ros static_transform_publisher --x 1 --y 0 --z 0 --yaw 0 --pitch 0 --roll 0 "
    "--frame-id odom --child-frame-id base_link"
)


def test_experiment_a_a_healthy_tree(terminal):
    terminal.type(MAP_TO_ODOM)
    terminal.type(ODOM_TO_BASE_LINK)
    out = terminal.type("ros2 run tf2_ros tf2_echo map base_link")
    assert out.splitlines()[:2] == ["At time 0.0", "- Translation: [1.000, 0.000, 0.000]"]


def test_experiment_b_a_misspelt_parent(terminal, tmp_path):
    terminal.type(MAP_TO_ODOM)
    terminal.type(ODOM_TO_BASE_LINK.replace("--frame-id odom --child", "--frame-id odm --child"))
    out = terminal.type("ros2 --for 1.5 run tf2_ros tf2_echo map base_link")
    assert (out + terminal.error).splitlines()[-1] == (
        "[INFO] [2.000000000] [tf2_echo]: Waiting for transform map ->  base_link: "
        "Could not find a connection between 'map' and 'base_link' because they are not part of the same tree."
        "Tf has two or more unconnected trees."
    )
    terminal.type(f"ros2 run tf2_tools view_frames -o {tmp_path}/frames")
    edges = [line.split("  ")[0] for line in terminal.pictures[0].text.splitlines()[1:]]
    assert edges == ['"map" -> "odom"', '"odm" -> "base_link"']
    assert [fault.frames for fault in frame_tree(terminal.graph).faults] == [("map", "odm")]


def test_experiment_c_two_publishers_of_one_frame(terminal):
    terminal.graph.start(moving(name="ekf", speed=0.0, y=0.0))
    terminal.graph.start(moving(name="wheel_odometry", speed=0.0, y=1.0, rate_hz=16.0))
    out = terminal.type("ros2 --for 3.2 run tf2_ros tf2_echo odom base_link 5")
    seen = {line for line in out.splitlines() if line.startswith("- Translation")}
    assert seen == {"- Translation: [0.000, 0.000, 0.000]", "- Translation: [0.000, 1.000, 0.000]"}
    info = terminal.type("ros2 topic info /tf --verbose")
    assert [line for line in info.splitlines() if line.startswith("Node name:")] == [
        "Node name: ekf", "Node name: wheel_odometry",
    ]  # fmt: skip


def test_experiment_c_samples_of_two_publishers_are_interpolated(terminal):
    terminal.graph.start(moving(name="owner_1", speed=0.0, rate_hz=10.0))  # y = 0 at 1.1, 1.2, 1.3 ... s
    terminal.graph.start(moving(name="owner_3", speed=0.0, y=2.0, rate_hz=8.0))  # y = 2 at 1.125, 1.25, 1.375 ... s
    rclpy.init()
    node, buffer = Node("listener"), Buffer()
    node.listener = TransformListener(buffer, node)
    while terminal.graph.now_ns < seconds(2.0):
        rclpy.spin_once(node, timeout_sec=2.0 - terminal.graph.now_ns / 1e9)
    stamps = [Time(nanoseconds=seconds(at_s)) for at_s in (1.2, 1.25, 1.3, 1.225, 1.2625)]
    found = [buffer.lookup_transform("odom", "base_link", stamp).transform.translation.y for stamp in stamps]
    rclpy.shutdown()
    assert found == pytest.approx([0.0, 2.0, 0.0, 1.0, 1.5])  # nobody published the last two
    owners = [edge.node for edge in snapshot(terminal.graph).edges if edge.child == "base_link"]
    assert owners == ["/owner_1", "/owner_3"]


def test_experiment_c_with_static_publishers_the_one_heard_last_counts(terminal):
    terminal.type(ODOM_TO_BASE_LINK)
    terminal.type(ODOM_TO_BASE_LINK.replace("--x 1", "--x 2"))
    assert "Publisher count: 2\n" in terminal.type("ros2 topic info /tf_static")
    out = terminal.type("ros2 run tf2_ros tf2_echo odom base_link")
    assert {line for line in out.splitlines() if line.startswith("- Trans")} == {"- Translation: [2.000, 0.000, 0.000]"}
