"""What a killed recorder has left is read, and said to be unfinished."""

import shutil
import sqlite3

import pytest
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_typestore

from tflab.bags.errors import BagError
from tflab.bags.reader import read_bag

from .making_bags import DELAY_NS, circle, ros1_store, tf_message, write_rosbag1, write_rosbag2


def rosbag1_with(path, compression):
    store = ros1_store()
    writer = Writer1(path)
    writer.chunk_threshold = 4000  # bytes, so that there are many
    if compression:
        writer.set_compression(compression)
    with writer:
        tf = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store, callerid="/driver")
        for row in circle(300):
            data = store.serialize_ros1(tf_message(store, [row], has_seq=True), "tf2_msgs/msg/TFMessage")
            writer.write(tf, row[0] + DELAY_NS, data)
    return path


def rosbag2_with(path, compression, count):
    store = get_typestore(Stores.ROS2_HUMBLE)
    writer = Writer2(path, version=9, storage_plugin=StoragePlugin.MCAP)
    writer.set_compression(CompressionMode.STORAGE, compression)
    with writer:
        tf = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store)
        for row in circle(count):
            writer.write(tf, row[0], store.serialize_cdr(tf_message(store, [row]), "tf2_msgs/msg/TFMessage"))
    return next(path.glob("*.mcap"))


def cut(file, part):
    data = file.read_bytes()
    file.write_bytes(data[: int(part * len(data))])
    return file


def assert_is_a_beginning(recording, share, count=300):
    """The transforms that are left are the first ones, and not fewer than the share of the file."""
    stamps = recording.transforms.stamp_ns.tolist()
    assert stamps == [row[0] for row in circle(count)][: len(stamps)]
    assert len(stamps) >= share * count and recording.unfinished.is_cut
    assert recording.end_ns == recording.transforms.receive_ns[-1]


def test_of_an_mcap_that_is_cut_everything_up_to_the_cut_is_read(tmp_path):
    (file,) = write_rosbag2(tmp_path / "drive", circle(300), statics=[]).glob("*.mcap")
    recording = read_bag(cut(file, 0.5), salvage=True)
    assert_is_a_beginning(recording, 0.4)
    assert recording.unfinished.remedy == "mcap recover drive.mcap -o whole.mcap"


def test_of_an_mcap_with_compressed_chunks_that_is_cut_the_beginning_is_read(tmp_path):
    recording = read_bag(cut(rosbag2_with(tmp_path / "drive", CompressionFormat.ZSTD, 4000), 0.8), salvage=True)
    assert_is_a_beginning(recording, 0.2, 4000)


@pytest.mark.parametrize("compression", [None, Writer1.CompressionFormat.BZ2, Writer1.CompressionFormat.LZ4])
def test_of_a_bag_of_ros1_that_is_cut_everything_up_to_the_cut_is_read(tmp_path, compression):
    recording = read_bag(cut(rosbag1_with(tmp_path / "drive.bag", compression), 0.5), salvage=True)
    assert_is_a_beginning(recording, 0.3)
    assert recording.connections[0].publisher == "/driver"
    assert recording.unfinished.remedy == "rosbag reindex drive.bag"


def test_a_killed_recording_in_several_files_is_read_as_one(tmp_path):
    folder = tmp_path / "drive"
    folder.mkdir()
    for part, rows in enumerate((circle(300)[:100], circle(300)[100:200], circle(300)[200:])):
        (file,) = write_rosbag2(tmp_path / f"part{part}", rows, statics=[]).glob("*.mcap")
        shutil.copy(file, folder / f"drive_{part}.mcap")
    recording = read_bag(folder, salvage=True)
    assert recording.transforms.stamp_ns.tolist() == [row[0] for row in circle(300)]
    assert [(c.topic, c.count) for c in recording.connections] == [("/tf", 300)]
    assert not recording.unfinished.is_cut and recording.unfinished.remedy == "ros2 bag reindex drive"


def test_what_a_killed_recorder_had_only_in_the_log_of_the_database_is_read_too(tmp_path):
    (file,) = write_rosbag2(tmp_path / "drive", circle(100), statics=[], storage="SQLITE3").glob("*.db3")
    whole = sqlite3.connect(file)
    whole.execute("PRAGMA journal_mode=WAL")
    whole.execute("INSERT INTO messages (topic_id, timestamp, data) SELECT topic_id, timestamp + 1, data FROM messages")
    whole.commit()
    killed = tmp_path / "killed"
    killed.mkdir()
    for name in (file.name, f"{file.name}-wal"):
        shutil.copy(file.with_name(name), killed / name)
    whole.close()
    before = {path: path.read_bytes() for path in killed.iterdir()}
    recording = read_bag(killed / file.name, salvage=True)
    assert len(recording.transforms) == 200 and not recording.unfinished.is_cut
    assert {path: path.read_bytes() for path in killed.iterdir()} == before


def test_a_whole_recording_is_not_unfinished(tmp_path):
    path = write_rosbag2(tmp_path / "drive", circle(30))
    assert read_bag(path, salvage=True).unfinished is None
    assert read_bag(write_rosbag1(tmp_path / "drive.bag", circle(30)), salvage=True).unfinished is None


def test_a_file_of_which_no_message_is_left_is_refused(tmp_path):
    (file,) = write_rosbag2(tmp_path / "drive", circle(300)).glob("*.mcap")
    with pytest.raises(BagError, match="no message is left"):
        read_bag(cut(file, 0.01), salvage=True)
