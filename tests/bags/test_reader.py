"""Reading bags: what is in them comes out, whatever the format, and what is no bag is refused in one line."""

import struct
import sys

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

from tflab.bags.errors import BagError
from tflab.bags.info import bag_facts
from tflab.bags.play import PlayOptions, events
from tflab.bags.reader import read_bag
from tflab.bags.recording import TransformLabel

from .making_bags import DELAY_NS, LASER, START_NS, circle, ros1_store, write_rosbag1, write_rosbag2


@pytest.mark.parametrize("storage", ["MCAP", "SQLITE3"])
def test_a_rosbag2_is_read_as_it_was_written(tmp_path, storage):
    rows = circle(30)
    recording = read_bag(write_rosbag2(tmp_path / "drive", rows, storage=storage))
    table = recording.transforms
    assert table.labels == (
        TransformLabel("/tf_static", "", "base_link", "laser_frame", True),
        TransformLabel("/tf", "", "odom", "base_link", False),
    )
    assert table.stamp_ns.tolist() == [LASER[0], *(row[0] for row in rows)]
    assert table.receive_ns.tolist() == [START_NS, *(row[0] + DELAY_NS for row in rows)]
    assert table.numbers.tolist() == [list(LASER[3]), *(list(row[3]) for row in rows)]
    assert (recording.begin_ns, recording.end_ns) == (START_NS, rows[-1][0] + DELAY_NS)
    qos = {connection.topic: connection.qos for connection in recording.connections}
    assert qos["/tf"] == ()
    assert [profile.durability for profile in qos["/tf_static"]] == ["transient_local"]


@pytest.mark.parametrize("msgtype", ["tf2_msgs/msg/TFMessage", "tf/msg/tfMessage"])
def test_a_ros1_bag_is_read_with_its_publisher_and_also_with_the_old_type(tmp_path, msgtype):
    rows = circle(4)
    table = read_bag(write_rosbag1(tmp_path / "old.bag", rows, msgtype)).transforms
    assert table.labels == (TransformLabel("/tf", "/driver", "odom", "base_link", False),)
    assert table.numbers.tolist() == [list(row[3]) for row in rows]
    assert table.stamp_ns.tolist() == [row[0] for row in rows]


def test_what_is_wrong_with_a_transform_is_kept(tmp_path):
    nan = float("nan")
    rows = [
        (START_NS, "/odom", "/base_link", (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
        (START_NS + 1, "", "Base Link", (nan, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0)),
    ]
    table = read_bag(write_rosbag2(tmp_path / "drive", rows, statics=[])).transforms
    assert [(label.parent, label.child) for label in table.labels] == [("/odom", "/base_link"), ("", "Base Link")]
    assert table.numbers[0, 3:].tolist() == [0.0, 0.0, 0.0, 0.0]
    assert np.isnan(table.numbers[1, 0]) and table.numbers[1, 6] == 2.0


def test_stamps_frames_joints_odometry_and_clock_of_the_other_topics_are_read(tmp_path):
    store = get_typestore(Stores.ROS2_HUMBLE)
    types = store.types
    time = types["builtin_interfaces/msg/Time"](3, 5)
    header = types["std_msgs/msg/Header"](time, "odom")
    numbers = np.array([0.25])
    joints = types["sensor_msgs/msg/JointState"](header, ["wheel"], numbers, np.zeros(0), np.zeros(0))
    pose = types["geometry_msgs/msg/Pose"](
        types["geometry_msgs/msg/Point"](1.0, 2.0, 3.0), types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
    )
    zero = types["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0)
    twist = types["geometry_msgs/msg/Twist"](zero, zero)
    odometry = types["nav_msgs/msg/Odometry"](
        header, "base_link",
        types["geometry_msgs/msg/PoseWithCovariance"](pose, np.zeros(36)),
        types["geometry_msgs/msg/TwistWithCovariance"](twist, np.zeros(36)),
    )  # fmt: skip
    messages = {
        "/joint_states": ("sensor_msgs/msg/JointState", joints),
        "/odom": ("nav_msgs/msg/Odometry", odometry),
        "/clock": ("rosgraph_msgs/msg/Clock", types["rosgraph_msgs/msg/Clock"](time)),
        "/cmd_vel": ("geometry_msgs/msg/Twist", twist),
    }
    with Writer(tmp_path / "others", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        for topic, (msgtype, message) in messages.items():
            connection = writer.add_connection(topic, msgtype, typestore=store)
            writer.write(connection, 4_000_000_000, store.serialize_cdr(message, msgtype))

    recording = read_bag(tmp_path / "others")
    stamp_ns = 3_000_000_005
    assert [(h.topic, h.frames, h.stamp_ns.tolist(), h.receive_ns.tolist()) for h in recording.headers] == [
        ("/joint_states", ("odom",), [stamp_ns], [4_000_000_000]),
        ("/odom", ("odom",), [stamp_ns], [4_000_000_000]),
    ]
    assert recording.joint_states[0].names == (("wheel",),) and recording.joint_states[0].positions == ((0.25,),)
    assert recording.odometry[0].child == "base_link"
    assert recording.odometry[0].numbers.tolist() == [[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0]]
    assert recording.clock.time_ns.tolist() == [stamp_ns]
    assert {connection.topic for connection in recording.connections} == set(messages)


def test_a_message_that_is_cut_off_is_counted_and_passed_over(tmp_path):
    store = get_typestore(Stores.ROS2_HUMBLE)
    with Writer(tmp_path / "drive", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connection = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store)
        writer.write(connection, 1, b"\0\1\0\0" + struct.pack("<I", 3) + b"\0" * 20)
    recording = read_bag(tmp_path / "drive")
    assert len(recording.transforms) == 0
    assert recording.notes == ("1 messages on /tf could not be read and were passed over",)
    with Writer1(tmp_path / "none.bag") as writer:
        writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=ros1_store())
    recording = read_bag(tmp_path / "none.bag")  # without a message
    assert len(recording.transforms) == 0 and recording.namespaces() == ()


def test_whole_files_that_rosbags_does_not_read_are_read(tmp_path):
    zstd = pytest.importorskip("compression.zstd" if sys.version_info >= (3, 14) else "backports.zstd")
    with Writer1(tmp_path / "closed_without_messages.bag"):
        pass
    assert len(read_bag(tmp_path / "closed_without_messages.bag", salvage=True).transforms) == 0
    drive = write_rosbag2(tmp_path / "drive", circle(9), storage="SQLITE3")
    metadata = (drive / "metadata.yaml").read_text()
    (drive / "metadata.yaml").write_text(metadata.replace("storage_identifier: sqlite3", 'storage_identifier: ""'))
    (tmp_path / "drive.db3.zstd").write_bytes(zstd.compress((drive / "drive.db3").read_bytes()))
    foreign = foreign_mcap(write_rosbag2(tmp_path / "m", circle(9)) / "m.mcap", b"")
    for path in (drive, tmp_path / "drive.db3.zstd", foreign):
        assert len(read_bag(path, salvage=True).transforms) == 10 and read_bag(path).unfinished is None
    assert bag_facts(foreign).count == 10 and bag_facts(foreign).storage == "mcap"
    assert len(list(events(foreign, PlayOptions(), ["/tf"]))) == 9
    assert "encoded as jsn" in refusal(foreign_mcap(foreign, b"jsn"))


def foreign_mcap(path, encoding):
    """Take the profile, and if one is given another encoding of the messages, into a copy of an .mcap."""
    header, data = b"\4\0\0\0ros2", path.read_bytes()
    if header in data:
        data = (
            data[:9] + struct.pack("<Q", struct.unpack("<Q", data[9:17])[0] - 4) + data[17:].replace(header, bytes(4))
        )
    copy = path.with_name(f"foreign_{encoding.decode()}.mcap")
    copy.write_bytes(data.replace(b"\3\0\0\0cdr", b"\3\0\0\0" + encoding) if encoding else data)
    return copy


@pytest.mark.parametrize(
    ("named", "there", "code", "what"),
    [
        ("drive.mcap\n  - drive_1.mcap", "drive.mcap", "file-missing", "drive_1.mcap of drive is missing"),
        ("drive.mcap", "lap.mcap", "file-renamed", "names drive.mcap, which is lap.mcap now"),
        ("drive_1.mcap\n  - drive.mcap", "lap.mcap", "file-missing", "drive_1.mcap of drive is missing"),
    ],
)
def test_of_a_recording_in_several_files_those_that_are_there_are_read(tmp_path, named, there, code, what):
    path = write_rosbag2(tmp_path / "drive", circle(9))
    (path / "drive.mcap").rename(path / there)
    metadata = (path / "metadata.yaml").read_text()
    (path / "metadata.yaml").write_text(metadata.replace("  - drive.mcap", f"  - {named}"))
    left = read_bag(path, salvage=True)
    assert len(left.transforms) == 10
    assert left.unfinished.code == code and what in left.unfinished.what


# -- what is no bag ----------------------------------------------------------


def refusal(path) -> str:
    with pytest.raises(BagError) as caught:
        read_bag(path)
    text = str(caught.value)
    assert "\n" not in text and str(path) in text
    return text


def test_a_missing_an_empty_and_a_foreign_file_are_refused(tmp_path):
    assert "no such file" in refusal(tmp_path / "nowhere")
    (tmp_path / "empty.bag").touch()
    assert "empty" in refusal(tmp_path / "empty.bag")
    (tmp_path / "picture.bag").write_bytes(b"\x89PNG\r\n" + bytes(100))
    assert "not a bag" in refusal(tmp_path / "picture.bag")
    (tmp_path / "folder").mkdir()
    assert "not a bag" in refusal(tmp_path / "folder")


@pytest.mark.parametrize("part", [0.2, 0.6, 0.95])
def test_a_file_that_is_cut_short_is_refused(tmp_path, part):
    files = [
        *write_rosbag2(tmp_path / "m", circle(200)).glob("*.mcap"),
        *write_rosbag2(tmp_path / "d", circle(200), storage="SQLITE3").glob("*.db3"),
        write_rosbag1(tmp_path / "r.bag", circle(200)),
    ]
    for file in files:
        data = file.read_bytes()
        cut = tmp_path / f"cut{file.suffix}"
        cut.write_bytes(data[: int(part * len(data))])
        assert "cut short" in refusal(cut)


def test_a_directory_without_metadata_says_which_file_to_try_and_a_wrong_suffix_is_named(tmp_path):
    path = write_rosbag2(tmp_path / "killed.bag", circle(3))  # a name like that of a bag of ROS 1
    assert len(read_bag(path).transforms) == 4
    (path / "metadata.yaml").unlink()
    (file,) = path.glob("*.mcap")
    assert file.name in refusal(path)
    assert len(read_bag(file).transforms) == 4
    assert ".mcap" in refusal(file.rename(file.with_suffix(".db3")))
