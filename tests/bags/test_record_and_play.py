"""ros2 bag: what the graph said is in the file, and what is in the file is said again."""

import time
from pathlib import Path
from shutil import copyfile

import numpy as np
import pytest
import yaml
from rosbags.highlevel import AnyReader
from rosbags.interfaces import QosDurability
from rosbags.rosbag2 import Writer
from rosbags.typesys import Stores, get_typestore

from tflab.bags.errors import BagError
from tflab.bags.info import BagFacts, bag_facts, info_text, size_text
from tflab.bags.listen import recording_from_graph
from tflab.bags.play import PlayOptions, events
from tflab.bags.reader import read_bag
from tflab.bags.record import BagWriter, adapted_profile
from tflab.bags.wire import profile_of, qos_of
from tflab.cli import main
from tflab.robots.model import joint_transform
from tflab.robots.nodes import launch
from tflab.robots.teaching import TeachingRobot
from tflab.robots.urdf import parse_urdf
from tflab.ros import client_library
from tflab.ros.graph import new_graph
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformListener
from tflab.ros.time import Duration, Time
from tflab.tools import ros2

from .making_bags import circle, tf_message, write_rosbag1

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

SECOND = 1_000_000_000


def record(graph, path, seconds, *options):
    """Record for a while, and end it as Ctrl-C does."""
    participant = graph.start(ros2.main, ["bag", "record", *options, "-o", str(path)], name="record")
    graph.run(seconds=seconds)
    graph.stop(participant)
    return path


@pytest.fixture
def drive(graph, tmp_path):
    """A recording of the teaching robot, all topics."""
    launch(graph)
    return record(graph, tmp_path / "drive", 4.0, "--all")


def test_the_libraries_own_reader_finds_definitions_types_and_qos(drive):
    with AnyReader([drive]) as reader:
        by_topic = {connection.topic: connection for connection in reader.connections}
        assert by_topic["/tf"].msgtype == "tf2_msgs/msg/TFMessage"
        assert all(connection.msgdef.data and connection.digest for connection in reader.connections)
        (qos,) = by_topic["/tf_static"].ext.offered_qos_profiles
        assert (qos.durability, qos.depth) == (QosDurability.TRANSIENT_LOCAL, 1)
        connection, _, data = next(reader.messages([by_topic["/tf_static"]]))
        message = reader.deserialize(data, connection.msgtype)
        laser = next(t for t in message.transforms if t.child_frame_id == "laser_frame")
        assert (laser.transform.translation.x, laser.transform.translation.z) == (0.20, 0.15)


def test_odometry_and_tf_of_a_recording_agree_at_every_stamp(drive):
    recording = read_bag(drive)
    (odometry,) = recording.odometry
    batch = recording.buffer().lookup_transforms(odometry.frame, odometry.child, odometry.stamp_ns)
    ok = batch.ok
    assert ok.sum() > 60 and (~ok).sum() <= 1  # the last /odom may have come without its transform
    assert np.allclose(batch.translations[ok], odometry.numbers[ok, :3], atol=1e-12)
    assert np.allclose(np.abs((batch.rotations[ok] * odometry.numbers[ok, 3:]).sum(axis=1)), 1.0, atol=1e-12)


def test_joint_states_and_urdf_reproduce_the_recorded_transforms(drive):
    recording = read_bag(drive)
    assert recording.robot_description == TeachingRobot().urdf
    assert bag_facts(drive).ros_distro == "jazzy"
    assert {event.topic for event in events(drive, PlayOptions(topics=("/odom",)), ("/odom",))} == {"/odom"}
    joints = {joint.name: joint for joint in parse_urdf(recording.robot_description, source="bag").joints}
    buffer = recording.buffer()
    (states,) = recording.joint_states
    compared = 0
    for stamp_ns, names, positions in zip(states.stamp_ns.tolist(), states.names, states.positions, strict=True):
        for name, position in zip(names, positions, strict=True):
            joint = joints[name]
            if not buffer.can_transform(joint.parent, joint.child, stamp_ns):
                continue
            recorded = buffer.lookup_transform(joint.parent, joint.child, stamp_ns).transform
            assert np.allclose(recorded.matrix(), joint_transform(joint, position).matrix(), atol=1e-9)
            compared += 1
    assert compared > 300


def test_an_existing_path_is_left_alone(graph, tmp_path, capsys):
    (tmp_path / "drive").mkdir()
    (tmp_path / "drive" / "precious").write_text("data")
    assert ros2.main(["bag", "record", "/tf", "-o", str(tmp_path / "drive")]) == 1
    assert f"Output folder '{tmp_path / 'drive'}' already exists." in capsys.readouterr().err
    assert (tmp_path / "drive" / "precious").read_text() == "data"
    with pytest.raises(BagError, match="nothing is overwritten"):
        BagWriter(tmp_path / "drive")


def test_the_words_of_a_recording_are_rosbag2s(graph, tmp_path, capsys):
    launch(graph, only=["wheel_odometry"])
    record(graph, tmp_path / "b", 1.0, "/tf")
    lines = [line.split("]: ", 1) for line in capsys.readouterr().err.splitlines() if "rosbag2" in line]
    assert [text for _, text in lines] == CASES["words_of_a_recording"]
    assert lines[0][0].startswith("[INFO] [1.000000000] [rosbag2_recorder")
    facts = bag_facts(record(graph, tmp_path / "c", 1.0, "/tf", "/scan"))  # for which it waits
    assert [topic[0] for topic in facts.topics] == ["/tf"]


def test_statics_that_were_said_before_are_recorded_and_said_again(graph, tmp_path):
    launch(graph)
    graph.run(seconds=2.0)
    path = record(graph, tmp_path / "late", 1.0, "/tf_static")
    assert read_bag(path).transforms.labels[0].is_static
    graph.stop()
    again = new_graph()
    again.start(ros2.main, ["bag", "play", str(path), "--loop"], name="play")  # without a loop it would end at once
    heard = recording_from_graph(again, seconds=0.05)
    again.stop()
    assert {label.child for label in heard.transforms.labels} >= {"laser_frame", "imu_link"}


def test_what_is_played_and_recorded_again_is_the_same(drive, tmp_path):
    first = read_bag(drive).transforms
    graph = new_graph()
    graph.start(ros2.main, ["bag", "play", str(drive), "--rate", "2.0"], name="play")
    second = read_bag(record(graph, tmp_path / "again", 3.0, "/tf", "-s", "sqlite3")).transforms
    graph.stop()
    moving = [i for i, label in enumerate(first.labels) if label.topic == "/tf"]
    rows = np.isin(first.label, moving)
    missed = int(rows.sum()) - len(second)
    assert 0 <= missed <= 3  # what was played in the same instant as the recorder looked around
    assert np.array_equal(first.stamp_ns[rows][missed:], second.stamp_ns)
    assert np.array_equal(first.numbers[rows][missed:], second.numbers)
    span_s = (second.receive_ns[-1] - second.receive_ns[0]) / SECOND
    assert 1.8 < span_s < 2.0  # four seconds at twice the speed


def test_a_loop_sets_the_clock_back_and_an_offset_leaves_out_the_beginning(drive, tmp_path):
    graph = new_graph()
    graph.start(ros2.main, ["bag", "play", str(drive), "--clock", "10", "--loop", "--start-offset", "3.0"], name="play")
    recording = read_bag(record(graph, tmp_path / "loop", 2.5, "/clock", "/tf"))
    graph.stop()
    steps_ns = np.diff(recording.clock.time_ns)
    assert (steps_ns < 0).sum() == 2
    assert set(steps_ns[steps_ns > 0].tolist()) == {SECOND // 10}
    begin_ns = read_bag(drive).begin_ns
    assert recording.clock.time_ns.min() == begin_ns + 3 * SECOND


@pytest.mark.parametrize("msgtype", ["tf2_msgs/msg/TFMessage", "tf/msg/tfMessage"])
def test_a_ros1_bag_is_played_with_todays_types(tmp_path, msgtype):
    rows = circle(20)
    path = write_rosbag1(tmp_path / "old.bag", rows, msgtype)
    graph = new_graph()
    graph.start(ros2.main, ["bag", "play", str(path), "--loop"], name="play")
    heard = recording_from_graph(graph, seconds=0.9).transforms
    graph.stop()
    new_graph()
    assert {label[2:4] for label in heard.labels} == {("odom", "base_link")}
    assert heard.numbers[:10].tolist() == [list(row[3]) for row in rows[1:11]]  # the first was said before we listened


def test_a_living_graph_tells_who_publishes(graph):
    launch(graph)
    labels = recording_from_graph(graph, seconds=1.0).transforms.labels
    publishers = {label.child: label.publisher for label in labels}
    assert publishers["base_footprint"] == "/wheel_odometry"
    assert publishers["laser_frame"] == "/robot_state_publisher"


# -- info ---------------------------------------------------------------------

FACTS = BagFacts(
    files=("bag_0.mcap",),
    size=2_831_155,
    storage="mcap",
    ros_distro="jazzy",
    begin_ns=1_701_316_731_045_123_000,
    duration_ns=27_045_000_000,
    count=959,
    topics=(("/tf_static", "tf2_msgs/msg/TFMessage", 1, "cdr"), ("/tf", "tf2_msgs/msg/TFMessage", 958, "cdr")),
)


def test_info_prints_what_jazzy_prints(monkeypatch):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", "jazzy")
    lines = info_text(FACTS).split("\n")
    assert lines[:5] == CASES["begin_of_facts"]
    assert lines[5] == "Duration:          27.045000000s"
    assert lines[6].endswith(".045123000 (1701316731.045123000)")
    assert lines[8:] == CASES["facts"]
    assert [size_text(n) for n in (518, 1024, 2_831_155)] == ["518 B", "1.0 KiB", "2.7 MiB"]
    monkeypatch.setenv("TFLAB_ROS_DISTRO", "humble")  # which does not pad milliseconds, and knows no services
    text = info_text(FACTS)
    assert "Duration:          27.45s\n" in text and "(1701316731.45)" in text
    assert "Service" not in text and "ROS Distro" not in text


# -- on the wire ----------------------------------------------------------------


def test_a_quality_of_service_survives_the_way_to_a_file_and_back():
    profile = QoSProfile(
        depth=7,
        reliability=ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL,
        deadline=Duration(seconds=1.5),
    )
    assert profile_of(qos_of(profile)) == profile


def test_a_recorder_asks_for_what_all_publishers_offer():
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    volatile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    assert adapted_profile([latched]).durability == DurabilityPolicy.TRANSIENT_LOCAL
    assert adapted_profile([latched, volatile]).durability == DurabilityPolicy.VOLATILE
    assert adapted_profile([latched, volatile]).reliability == ReliabilityPolicy.BEST_EFFORT


def test_a_bag_is_whole_after_an_error_and_holds_nothing_that_comes_later(tmp_path, capsys):
    point = geometry_msgs.PointStamped(header=std_msgs.Header(frame_id="map"), point=geometry_msgs.Point(x=1.5, z=-2.0))
    with pytest.raises(ZeroDivisionError), BagWriter(tmp_path / "drive") as writer:
        writer.add_topic("/point", point.ROS_TYPE, [QoSProfile(depth=1)])
        writer.write("/point", point, 5)
        raise ZeroDivisionError
    writer.write("/point", point, 6)
    writer.close()
    (event,) = events(tmp_path / "drive", PlayOptions(), ("/point",))
    assert (event.moment_ns, event.message) == (5, point)
    (tmp_path / "x.mcap").write_bytes(b"nonsense")
    assert ros2.main(["bag", "info", str(tmp_path / "x.mcap")]) == 1
    assert "not a bag" in capsys.readouterr().err


@pytest.mark.parametrize("parts", [1, 2])
def test_a_name_in_korean_is_read_where_the_system_writes_another_encoding(parts, graph, tmp_path, monkeypatch):
    launch(graph)
    path = record(graph, tmp_path / "주행", 2.0, "/tf", "/tf_static")
    if parts == 2:
        split(path)
    before = read_bag(path)
    real = Path.read_text
    monkeypatch.setattr(Path, "read_text", lambda file, *how: real(file, *(how if any(how) else ("cp949", "replace"))))
    assert "주행" not in (path / "metadata.yaml").read_text()
    assert read_bag(path).transforms.numbers.tolist() == before.transforms.numbers.tolist()


def split(path: Path) -> None:
    """Make of a bag of one file one of two, which hold the same."""
    (file,) = path.glob("*.mcap")
    copyfile(file, path / f"{file.stem}_1.mcap")
    told = yaml.safe_load((path / "metadata.yaml").read_text(encoding="utf-8"))
    about = told["rosbag2_bagfile_information"]
    about["relative_file_paths"].append(f"{file.stem}_1.mcap")
    about["files"] += [dict(about["files"][0], path=f"{file.stem}_1.mcap")]
    (path / "metadata.yaml").write_text(yaml.safe_dump(told, allow_unicode=True), encoding="utf-8")


def test_times_of_day_on_virtual_time_are_the_same_in_every_zone(graph, tmp_path, monkeypatch, capsys):
    launch(graph, only=["wheel_odometry"])
    path = record(graph, tmp_path / "b", 1.0, "/tf")
    capsys.readouterr()
    texts = set()
    for zone in ("UTC", "Asia/Seoul"):
        monkeypatch.setenv("TZ", zone)
        time.tzset()
        graph.start(ros2.main, ["bag", "info", str(path)])
        texts.add(capsys.readouterr().out)
    monkeypatch.undo()
    time.tzset()
    (text,) = texts
    assert "Start:             Jan  1 1970 00:00:01.050000000 (1.050000000)" in text
    assert "ROS Distro:        jazzy\n" in text


def simulated(path: Path, clock_hz: int) -> Path:
    """Write ten seconds of odom -> base_link in simulated time, received at the wall clock, with or without /clock."""
    store, wall_ns = get_typestore(Stores.ROS2_JAZZY), 1_700_000_000 * SECOND
    time_at = store.types["builtin_interfaces/msg/Time"]
    with Writer(path, version=9) as writer:
        tf = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store)
        for row in circle(200):
            data = store.serialize_cdr(tf_message(store, [row]), "tf2_msgs/msg/TFMessage")
            writer.write(tf, wall_ns + row[0] + 4_000_000, data)
        if clock_hz:
            clock = writer.add_connection("/clock", "rosgraph_msgs/msg/Clock", typestore=store)
            for moment_ns in range(SECOND, 11 * SECOND, SECOND // clock_hz):
                message = store.types["rosgraph_msgs/msg/Clock"](time_at(*divmod(moment_ns, SECOND)))
                writer.write(clock, wall_ns + moment_ns, store.serialize_cdr(message, "rosgraph_msgs/msg/Clock"))
    return path


@pytest.mark.parametrize("clock_hz", [0, 10, 100])
@pytest.mark.parametrize(("words", "shown"), CASES["tools"])
def test_a_tool_follows_one_clock_of_a_bag_in_simulated_time(words, shown, clock_hz, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["ros2", "--bag", str(simulated(tmp_path / "simulated", clock_hz)), *words.split()]) == 0
    out, err = capsys.readouterr()
    assert shown in out + err and "jump back" not in out + err and "e+" not in out


def test_a_looped_bag_leaves_a_buffer_that_watches_its_clock_whole(graph, tmp_path, capsys):
    launch(graph)
    path = record(graph, tmp_path / "drive", 6.0, "/tf", "/tf_static")
    graph.stop()
    again = new_graph()
    again.start(ros2.main, ["bag", "play", str(path), "--clock", "100", "--loop"], name="play")
    asked = []

    def main():
        client_library.init()
        node = Node("asking", parameter_overrides=[Parameter("use_sim_time", value=True)])
        buffer = Buffer(node=node)
        listener = TransformListener(buffer, node)
        node.create_timer(0.2, lambda: asked.append(buffer.can_transform("odom", "laser_frame", Time())))
        client_library.spin(node)
        assert listener

    again.start(main)
    capsys.readouterr()
    again.run(seconds=14.0)
    again.stop()
    said = capsys.readouterr().err
    assert said.count("Detected jump back in time") == 2
    assert "TF_OLD_DATA" not in said
    assert len(asked) > 60 and all(asked[2:])


def test_a_second_run_of_a_cell_that_records_puts_the_first_bag_aside(graph, tmp_path, capsys):
    launch(graph, only=["wheel_odometry"])
    path = tmp_path / "drive"
    record(graph, path, 1.0, "/tf")
    first = (path / "metadata.yaml").read_text()
    record(graph, path, 2.0, "/tf")
    assert (tmp_path / "drive_1" / "metadata.yaml").read_text() == first
    assert bag_facts(path).count > bag_facts(tmp_path / "drive_1").count
    assert f"[WARN] [ros2bag]: Output folder '{path}' already exists: it is now '{path}_1'." in capsys.readouterr().err
