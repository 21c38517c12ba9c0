"""The bag that comes with the package: whoever has none can read, play and examine one, made by a real clock."""

import numpy as np

from tflab.bags.info import bag_facts, example_bag
from tflab.bags.reader import read_bag
from tflab.core import seconds
from tflab.doctor import examine


def test_it_is_small_and_holds_what_a_robot_with_a_laser_says_but_no_clock():
    facts = bag_facts(example_bag())
    assert [(name, count) for name, _, count, _ in facts.topics] == [("/scan", 50), ("/tf", 428), ("/tf_static", 1)]
    assert facts.size < 256 * 1024 and facts.ros_distro == "jazzy"


def test_its_times_are_those_of_a_real_clock_and_the_doctor_finds_nothing_wrong_with_it():
    recording = read_bag(example_bag(), show_progress=False)
    assert seconds(1_700_000_000) < recording.begin_ns < recording.end_ns < seconds(4_000_000_000)
    statics = [record for record in recording.records() if record.is_static]
    assert len(statics) > 5
    assert all(record.stamped.stamp_ns < recording.begin_ns - seconds(2.0) for record in statics)
    (scans,) = recording.headers
    late_ns = scans.receive_ns - scans.stamp_ns
    assert late_ns.min() >= seconds(0.105)  # a sweep's time, and never less
    assert len(np.unique(late_ns)) > 40  # unevenly, as on a machine with other work
    assert not examine(recording).findings


def test_a_path_may_begin_with_the_home_of_whoever_reads(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    (tmp_path / "kitchen").symlink_to(example_bag())
    assert len(read_bag("~/kitchen", show_progress=False).transforms) > 400
    assert bag_facts("~/kitchen").count == 479
