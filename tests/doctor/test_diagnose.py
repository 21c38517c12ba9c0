"""What is said about small recordings made by hand, and what is not."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tflab.bags.recording import Clock, Connection, Headers, JointStates, QosProfile, recording_from_records
from tflab.core import BufferCore, StampedTransform, Transform
from tflab.core.transforms import TransformRecord
from tflab.doctor import examine
from tflab.doctor.diagnose import diagnose_buffer, diagnose_recording, effects_of
from tflab.doctor.report.sentences import describe
from tflab.robots.nodes import launch
from tflab.ros.graph import new_graph
from tflab.tools import ros2

from .conftest import of_robot

MS = 1_000_000
SECOND = 1000 * MS


def edge(parent, child, count=100, period_ms=50, delay_ms=4, value=None, is_static=False, start_ms=1000, publisher=""):
    """Samples of one edge on a circle, or of what `value(i)` returns."""
    records = []
    for i in range(count):
        stamp_ns = (start_ms + i * period_ms) * MS
        yaw = 0.02 * i
        pose = value(i) if value else Transform.from_rpy(yaw=yaw, translation=(math.cos(yaw), math.sin(yaw), 0.0))
        topic = "/tf_static" if is_static else "/tf"
        stamped = StampedTransform(parent, child, stamp_ns, pose)
        records.append(TransformRecord(topic, stamp_ns + delay_ms * MS, publisher, stamped, is_static))
    return records


def mount(parent, child, x=0.2, **options):
    return edge(parent, child, count=1, value=lambda i: Transform((x, 0.0, 0.0)), is_static=True, **options)


def recording(*edges):
    records = sorted((record for records in edges for record in records), key=lambda record: record.receive_ns)
    return recording_from_records(records, "made by hand")


def found(patient):
    """The findings, as {code: finding}."""
    return {finding.code: finding for finding in diagnose_recording(patient).findings}


def alarming(patient):
    return {finding.code for finding in diagnose_recording(patient).of_severity("error", "warning")}


HEALTHY = (edge("map", "odom", 50, 100), edge("odom", "base_link"), mount("base_link", "laser_frame"))


def test_a_healthy_robot_is_left_in_peace():
    assert found(recording(*HEALTHY)) == {}
    assert diagnose_buffer(BufferCore()).findings == ()


MAP, ODOM, LASER = HEALTHY
OPTICAL = Transform.from_rpy(-math.pi / 2, 0.0, -math.pi / 2)
STILL = [r._replace(stamped=replace(r.stamped, stamp_ns=min(r.stamped.stamp_ns, 2 * SECOND)))
         for r in edge("base_link", "arm")]  # fmt: skip
LENS = edge("base_link", "optical", 1, value=lambda i: OPTICAL, is_static=True)
PLACED = Transform((0.2, 0.0, 0.0))
OLD_MOUNT = [r._replace(stamped=replace(r.stamped, stamp_ns=1)) for r in mount("base_link", "imu_link")]
UNSET = [r._replace(stamped=replace(r.stamped, stamp_ns=0)) for r in ODOM]
CHANGED = [*ODOM[:50], *(r._replace(topic="/tf_static", is_static=True) for r in ODOM[50:])]
ARMS = [edge("base_link", "rh_p12_rn_l1"), edge("rh_p12_rn_r1", "rh_p12_rn_r2")]


def flipping(i):
    return Transform((0.01 * i, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0 if i % 2 else -1.0))


def corrected(i):
    return Transform((0.5 * (i // 10 % 3), 0.0, 0.0))


ALARMS = {
    "a latched static of long ago": ([*HEALTHY, OLD_MOUNT], set()),
    "a localiser that has nothing to correct": (
        [edge("map", "odom", 50, 100, value=lambda i: Transform()), ODOM, LASER], set(),
    ),
    "corrections of a localiser": ([edge("map", "odom", 50, 100, value=corrected), ODOM, LASER], set()),
    "sign flips of a quaternion": ([MAP, edge("odom", "base_link", value=flipping), LASER], set()),
    "odometry that stamps ahead": ([MAP, edge("odom", "base_link", delay_ms=-500), LASER], {"early-stamps"}),
    "the same at the top of a tree": (
        [edge("odom", "body", delay_ms=-800), edge("body", "leg"), mount("body", "imu")], {"early-stamps"},
    ),
    "a tag that a camera sees for a while": ([*HEALTHY, edge("optical", "tag", 20, start_ms=3000), LENS], set()),
    "stamps of the last movement": ([MAP, ODOM, LASER, STILL], {"time-frozen"}),
    "a localiser that publishes the robot": ([*HEALTHY, edge("map", "base_link", start_ms=1020)], {"two-parents"}),
    "a missing link": ([edge("map", "odom"), edge("base_link", "arm"), LASER], {"two-trees"}),
    "two arms, which are no misspelling": ([*HEALTHY, *ARMS], {"two-trees"}),
    "two halves of a gripper": (
        [edge("jaw_left_knuckle", "jaw_left_finger"), edge("jaw_base", "jaw_right_finger"), mount("jaw_base", "plate")],
        {"two-trees"},
    ),
    "arms without a torso": (
        [*(edge(f"{side}_base", f"{side}_elbow") for side in ("left", "right")), mount("left_base", "plate")],
        {"two-trees"},
    ),
    "a mount on both topics": (
        [*HEALTHY, edge("base_link", "laser_frame", value=lambda i: PLACED)], {"constant-on-tf"},
    ),
    "a child that moves and is bolted on": ([*HEALTHY, edge("base_link", "laser_frame")], {"moving-and-static"}),
    "an edge that changes over to /tf_static": ([MAP, CHANGED, LASER], {"moving-on-static"}),
    "a robot that is prefixed below its odometry": (
        [*HEALTHY, *(edge("r1/base_link", f"r1/arm_{i}") for i in range(3))], {"name-prefix"},
    ),
    "a tree that stands upside down": ([edge("base_link", "odom"), edge("odom", "map"), LASER], {"upside-down"}),
    "stamps that were never set": ([MAP, UNSET, LASER], {"unset-stamps"}),
    "an edge that stops": ([MAP, ODOM[:40], LASER], {"went-silent"}),
    "all names with a slash": ([edge("/map", "/odom", 50, 100), edge("/odom", "/base_link"), LASER], {"leading-slash"}),
    "no transforms at all": ([], {"no-transforms"}),
}  # fmt: skip


@pytest.mark.parametrize(("edges", "codes"), ALARMS.values(), ids=ALARMS)
def test_each_fault_is_named_by_its_code_and_what_is_normal_is_not(edges, codes):
    report = diagnose_recording(recording(*edges))
    assert {finding.code for finding in report.of_severity("error", "warning")} == codes
    for finding in report.findings:
        assert all("{" not in part for part in describe(finding))


@pytest.mark.parametrize(("is_copy", "severity"), [(True, "info"), (False, "warning")])
def test_a_stamp_that_repeats_with_the_same_values_is_a_note(is_copy, severity):
    pairs = zip(ODOM[:50:10], ODOM[0 if is_copy else 1 : 51 : 10], strict=False)
    again = [r._replace(receive_ns=r.receive_ns + MS, stamped=replace(r.stamped, transform=other.stamped.transform))
             for r, other in pairs]  # fmt: skip
    assert found(recording(MAP, ODOM, again, LASER))["repeated-stamps"].severity == severity


def test_a_prefix_a_slash_and_a_missing_mount_say_what_they_are_about():
    slashed = found(recording(*ALARMS["all names with a slash"][0]))
    assert slashed["leading-slash"].facts["names"] == "/base_link, /map, /odom"
    assert found(recording(edge("world", "talk", 10, 300)))["statics-missing"].severity == "info"
    patient = replace(recording(*HEALTHY), notes=("7 messages on /tf could not be read and were passed over",))
    assert found(patient)["unreadable"].severity == "error"


# -- what is normal ------------------------------------------------------------


def test_a_localiser_may_stamp_ahead_and_it_is_told_as_a_note():
    findings = found(recording(edge("map", "odom", 50, 100, delay_ms=-500), *HEALTHY[1:]))
    assert [(f.code, f.severity, f.child) for f in findings.values()] == [("stamped-ahead", "info", "odom")]


def test_a_joint_at_rest_is_normal_and_a_repeated_mount_is_not():
    still = [edge("base_link", child, value=lambda i: Transform((0.1, 0.0, 0.0))) for child in ("plate", "bracket")]
    broken = recording(*HEALTHY, *still)
    assert alarming(broken) == {"constant-on-tf"}
    stamps = np.array([record.stamped.stamp_ns for record in still[0]])
    joints = JointStates("/joint_states", stamps, (("j1", "j2"),) * 100, ((0.0, 0.0),) * 100)
    assert alarming(replace(broken, joint_states=(joints,))) == set()


@pytest.mark.parametrize("by_s", [3, 86_400])
def test_a_clock_that_is_set_with_the_times_of_receipt_is_no_silence(by_s):
    def set_forward(record):
        stamped = replace(record.stamped, stamp_ns=record.stamped.stamp_ns + by_s * SECOND)
        return record._replace(receive_ns=record.receive_ns + by_s * SECOND, stamped=stamped)

    edges = [MAP, ODOM, edge("base_link", "arm")]
    edges = [[r if r.receive_ns < 3 * SECOND else set_forward(r) for r in records] for records in edges]
    assert alarming(recording(*edges, LASER)) == {"clock-set"}


def test_a_stall_of_everything_is_one_event():
    def silent(records):
        return [record for record in records if not 2 * SECOND < record.receive_ns < 4 * SECOND]

    findings = found(recording(silent(edge("map", "odom", 50, 100)), silent(edge("odom", "base_link")), HEALTHY[2]))
    assert set(findings) == {"stall"}
    assert float(findings["stall"].facts["longest"]) == pytest.approx(2.0, abs=0.11)


@pytest.mark.parametrize("between", ["/", "_"])
def test_two_robots_in_one_recording_are_two_trees_by_choice(between):
    robots = [edge(f"r{n}{between}odom", f"r{n}{between}base_link") for n in (1, 2)]
    mounts = [mount(f"r{n}{between}base_link", f"r{n}{between}laser") for n in (1, 2)]
    assert {f.code: f.severity for f in found(recording(*robots, *mounts)).values()} == {"several-robots": "info"}


def test_two_robots_with_topics_of_their_own_may_have_the_same_frames():
    both = [of_robot(robot, records) for robot in ("r1", "r2") for records in HEALTHY]
    assert alarming(recording(*both)) == set()


# -- what is not ------------------------------------------------------------------


def test_two_owners_are_told_by_their_names():
    second = edge("odom", "base_link", start_ms=1025, publisher="/ekf")
    first = edge("odom", "base_link", publisher="/wheels")
    finding = found(recording(HEALTHY[0], first, second, HEALTHY[2]))["two-owners"]
    assert "/ekf, /wheels" in finding.facts["evidence"].en


def test_two_owners_without_names_are_told_by_their_values():
    def elsewhere(i):
        return Transform.from_rpy(yaw=0.02 * i, translation=(math.cos(0.02 * i) + 0.4, math.sin(0.02 * i), 0.0))

    second = edge("odom", "base_link", start_ms=1025, value=elsewhere)
    finding = found(recording(*HEALTHY, second))["two-owners"]
    assert float(finding.facts["apart"]) == pytest.approx(0.4, abs=0.05)


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("deviation", [0.004, 0.02])
def test_a_noisy_localiser_is_one_owner(deviation, seed):
    chance = np.random.default_rng(seed)

    def matched(i):  # by a scan matcher, six metres from the origin: its yaw moves odom, too
        x, y, yaw = deviation * chance.standard_normal(3) * (1.0, 1.0, 0.5)
        base = Transform(translation=(6.0 * math.cos(0.005 * i), 6.0 * math.sin(0.005 * i), 0.0))
        return base @ Transform.from_rpy(yaw=yaw, translation=(x, y, 0.0)) @ base.inverse()

    noisy = edge("map", "odom", 600, period_ms=100, value=matched)
    assert "two-owners" not in found(recording(noisy, edge("odom", "base_link", 1200), HEALTHY[2]))


def test_the_misspelt_parent_of_the_lecture_is_named():
    findings = found(recording(edge("map", "odom"), edge("odm", "base_link"), HEALTHY[2]))
    assert set(findings) == {"name-slip"}
    assert [effect.code for effect in findings["name-slip"].effects] == ["two-trees"]  # which follows from it
    assert (findings["name-slip"].facts["name"], findings["name-slip"].facts["other"]) == ("odm", "odom")
    assert findings["name-slip"].facts["said"].en == "odm -> base_link on /tf"


def test_of_a_name_that_many_say_wrongly_the_first_four_edges_are_told():
    arm = [mount("Base_link", name) for name in ("a_link", "b_link", "c_link", "d_link", "e_link", "f_link")]
    facts = found(recording(*HEALTHY, *arm))["name-case"].facts
    assert facts["name"] == "Base_link" and facts["said"].en.startswith("Base_link -> a_link on /tf_static, ")
    assert facts["said"].en.count(" on /tf_static") == 4 and facts["said"].en.endswith(" and 2 more")


def test_a_circle_is_told_in_full_and_which_edge_closed_it_if_that_came_later():
    findings = found(recording(*HEALTHY, edge("base_link", "map", start_ms=1010)))
    assert findings["loop"].facts["circle"] == "base_link -> odom -> map -> base_link"
    assert findings["loop"].facts["closed"] == ""  # all begin together: nobody knows who was there first
    findings = found(recording(*HEALTHY, edge("base_link", "map", 40, start_ms=3010)))
    assert findings["loop"].facts["closed"].en == " It was closed by base_link -> map, which was not there before."


@pytest.mark.parametrize("name", ["laser", "laser_frme", "r1/laser_frame", "laser_frame_link", "Laser_Frame", "lidar"])
def test_messages_in_a_frame_that_nobody_publishes_are_named_beside_the_frame_that_it_may_be(name):
    patient = replace(recording(*HEALTHY), headers=(headers("/scan", "sensor_msgs/msg/LaserScan", name, 29),))
    findings = diagnose_recording(patient).findings
    told = " ".join(describe(finding).title + describe(finding).evidence for finding in findings)
    assert f'"{name}"' in told and ('"laser_frame"' in told) == (name != "lidar")
    if name == "lidar":
        assert findings[0].facts == {"name": "lidar", "topics": "/scan", "count": 29, "alike": ""}
    assert ("name-case" in alarming(patient)) == (name == "Laser_Frame")


@pytest.mark.parametrize(("delay_ms", "codes"), [(105, set()), (-500, {"messages-early"}), (5000, {"messages-late"})])
def test_a_sensor_on_another_clock_is_named(delay_ms, codes):
    stamps = np.arange(1, 30, dtype=np.int64) * 100 * MS + SECOND
    frames = ("laser_frame",)
    scan = Headers("/scan", "LaserScan", stamps + delay_ms * MS, stamps, np.zeros(29, dtype=np.int64), frames)
    assert alarming(replace(recording(*HEALTHY), headers=(scan,))) == codes


def test_everything_late_by_the_same_is_two_clocks_that_disagree():
    late = (edge("map", "odom", 50, 100, delay_ms=2000), edge("odom", "base_link", delay_ms=2000), HEALTHY[2])
    assert found(recording(*late))["clock-offset"].facts["offset"] == "2.000"


# -- graph and buffer ----------------------------------------------------------------


def test_of_a_buffer_only_some_checks_are_made_and_the_others_listed():
    buffer = recording(*HEALTHY, edge("island", "rock")).buffer()
    report = examine(buffer)
    assert [finding.code for finding in report.findings] == ["two-trees"]
    assert "one tree" in report.checks_made
    assert {check.check for check in report.checks_not_made} >= {"order of stamps", "leading slashes", "delays"}
    assert not set(report.checks_made) & {check.check for check in report.checks_not_made}


def test_a_living_graph_is_listened_to_and_owners_have_names():
    graph = new_graph()
    launch(graph)
    launch(graph, only=["wheel_odometry"])
    report = examine(graph, seconds=3.0)
    graph.stop()
    new_graph()
    assert {f.code for f in report.of_severity("error", "warning")} <= {"two-owners", "repeated-stamps"}
    assert report.findings


def test_nodes_that_do_not_follow_the_same_clock_are_named():
    graph = new_graph()
    launch(graph, only=["wheel_odometry"])
    words = ["run", "tf2_ros", "static_transform_publisher", "--frame-id", "base_link", "--child-frame-id", "laser"]
    graph.start(ros2.main, [*words, "--ros-args", "-p", "use_sim_time:=true"])
    report = examine(graph, seconds=2.0)
    graph.stop()
    new_graph()
    (finding,) = [finding for finding in report.findings if finding.code == "mixed-time"]
    assert finding.facts["others"] == "/wheel_odometry"


def test_something_else_is_refused():
    with pytest.raises(TypeError, match=r"not at str; .*read_bag"):
        examine("drive")


# -- what a first version did not see ------------------------------------------------------


def headers(topic, msgtype, frame, count=60, period_ms=100, delay_ms=5, start_ms=1000):
    stamps = (start_ms + period_ms * np.arange(count, dtype=np.int64)) * MS
    return Headers(topic, msgtype, stamps + delay_ms * MS, stamps, np.zeros(count, dtype=np.int64), (frame,))


def without(records, begin_s, end_s):
    return [record for record in records if not begin_s * SECOND < record.receive_ns < end_s * SECOND]


def test_an_edge_that_comes_once_a_second_and_moves_far_meanwhile_is_slow():
    finding = found(recording(HEALTHY[0], edge("odom", "base_link", 10, 1000), HEALTHY[2]))["slow-edge"]
    assert (finding.child, finding.facts["rate"]) == ("base_link", "1.0")


def test_an_edge_that_begins_seconds_after_the_others_is_named():
    late = edge("odom", "base_link", start_ms=4000)
    finding = found(recording(edge("map", "odom", 80, 100), late, HEALTHY[2]))["late-start"]
    assert (finding.child, finding.facts["late"], finding.severity) == ("base_link", "3.000", "warning")


@pytest.mark.parametrize(("frame", "severity"), [("laser_frame", "info"), ("map", "warning")])
def test_a_localiser_that_begins_late_is_a_note_unless_messages_of_that_time_are_in_its_frame(frame, severity):
    patient = recording(edge("map", "odom", 50, 100, start_ms=3000), ODOM, LASER)
    patient = replace(patient, headers=(headers("/path", "nav_msgs/msg/Path", frame),))
    assert found(patient)["late-start"].severity == severity


def test_a_blocked_node_that_first_sends_what_it_had_in_hand_has_a_gap():
    samples = edge("odom", "base_link")
    before, after = samples[:50], samples[90:]  # a hole of 2 s in the stamps ...
    in_hand = samples[50]._replace(receive_ns=after[0].receive_ns - MS)  # ... heard one sample before it shows
    finding = found(recording(edge("map", "odom"), [*before, in_hand, *after], HEALTHY[2]))["gap"]
    assert finding.child == "base_link" and finding.facts["hole"] == "2.000"


def test_all_of_tf_silent_while_a_sensor_goes_on_is_the_topic_and_not_its_publishers():
    silent = [without(edge("map", "odom", 50, 100), 2, 4), without(edge("odom", "base_link"), 2, 4), HEALTHY[2]]
    scan = headers("/scan", "sensor_msgs/msg/LaserScan", "laser_frame")
    assert alarming(replace(recording(*silent), headers=(scan,))) == {"tf-silent"}


def test_one_stamp_an_hour_ahead_is_told_with_what_it_does():
    samples = edge("odom", "base_link")
    ahead = replace(samples[50].stamped, stamp_ns=samples[50].stamped.stamp_ns + 3600 * SECOND)
    samples[50] = samples[50]._replace(stamped=ahead)
    findings = found(recording(HEALTHY[0], samples, HEALTHY[2]))
    assert set(findings) == {"future-stamp"} and findings["future-stamp"].facts["ahead"] == "3600.000"


def test_a_queue_that_empties_at_the_start_is_no_clock_that_was_set():
    samples = edge("odom", "base_link", 160)
    burst = [record._replace(receive_ns=samples[40].receive_ns + i * MS) for i, record in enumerate(samples[:40])]
    findings = found(recording(edge("map", "odom", 80, 100), [*burst, *samples[41:]], HEALTHY[2]))
    assert "clock-jump-forward" not in findings


def test_a_prefix_with_an_underscore_that_leaves_a_tree_in_the_air_is_named():
    broken = recording(edge("map", "odom"), edge("odom", "robot2_base_link"), HEALTHY[2])
    findings = found(broken)
    assert set(findings) == {"name-prefix"} and findings["name-prefix"].facts["prefix"] == "robot2_"


def test_many_pieces_are_one_finding():
    islands = [mount(f"island_{i}_a", f"rock_{i}_b") for i in range(50)]
    trees = [f for f in diagnose_recording(recording(*HEALTHY, *islands)).findings if f.code == "two-trees"]
    assert [f.facts["count"] for f in trees] == [51]


@pytest.mark.parametrize(("delay_ms", "code"), [(900, "late-stamps"), (-300, "early-stamps")])
@pytest.mark.parametrize("topics", [(), ("/joint_states",)])
def test_edges_of_one_node_and_the_topic_with_their_stamps_are_one_finding(delay_ms, code, topics):
    late = [edge("base_link", f"joint_{i}", delay_ms=delay_ms) for i in range(4)]
    joints = [headers(topic, "sensor_msgs/msg/JointState", "", 100, 50, delay_ms) for topic in topics]
    patient = replace(recording(*HEALTHY, *late), headers=tuple(joints))
    (finding,) = diagnose_recording(patient).of_severity("error", "warning")
    assert (finding.code, finding.child) == (code, "joint_0")
    assert finding.siblings == ("joint_1", "joint_2", "joint_3", *topics)


def test_a_mount_that_the_urdf_calls_fixed_is_a_mount_whatever_its_name():
    urdf = '<robot name="r"><link name="base_link"/><link name="wheel_cover"/><joint name="j" type="fixed">'
    urdf += '<parent link="base_link"/><child link="wheel_cover"/></joint></robot>'
    cover = edge("base_link", "wheel_cover", value=lambda i: Transform((0.1, 0.0, 0.0)))
    patient = recording(*HEALTHY, cover)
    assert alarming(patient) == set()
    assert alarming(replace(patient, robot_description=urdf)) == {"constant-on-tf"}


# -- what faults planted by somebody else taught ---------------------------------------------


def test_a_mount_with_the_name_of_a_joint_is_told_where_the_joints_are_known():
    finger = edge("base_link", "left_finger_link", value=lambda i: Transform((0.1, 0.0, 0.0)), start_ms=1003)
    arm = edge("base_link", "arm")
    broken = recording(*HEALTHY, arm, finger)
    assert alarming(broken) == set()
    stamps = np.array([record.stamped.stamp_ns for record in arm])
    joints = JointStates("/joint_states", stamps, (("arm",),) * 100, ((0.0,),) * 100)
    findings = found(replace(broken, joint_states=(joints,)))
    assert findings["constant-on-tf"].child == "left_finger_link"


def test_two_that_disagree_about_the_day_are_one_on_the_clock_of_the_recorder_and_one_that_is_not():
    pose = headers("/pose", "geometry_msgs/msg/PoseStamped", "odom", delay_ms=1_300_000_000_000)
    start_ms = 1_300_000_001_000
    patient = replace(recording(edge("odom", "base_link", start_ms=start_ms)), headers=(pose,))
    told = [f for f in diagnose_recording(patient).findings if f.code == "time-uptime"]
    assert [finding.topic for finding in told] == ["/pose"]


def test_a_clock_that_jumped_back_is_no_stamp_in_the_future_although_another_clock_received_it():
    def jumping(records):
        away_ns = 1_700_000_000 * SECOND
        return [
            record._replace(
                receive_ns=record.receive_ns + away_ns,
                stamped=replace(record.stamped, stamp_ns=record.stamped.stamp_ns - (i >= 380) * 15 * SECOND),
            )
            for i, record in enumerate(records)
        ]

    told = alarming(recording(jumping(edge("odom", "base_link", 400)), jumping(edge("base_link", "arm", 400))))
    assert "clock-jump-back" in told and "future-stamp" not in told


def test_no_two_causes_explain_each_other():
    tables = [effects_of()[where] for where in ("on_the_same_edge_or_topic", "anywhere")]
    explained = {(cause, effect) for table in tables for cause, effects in table.items() for effect in effects}
    assert explained and not {(a, b) for a, b in explained if (b, a) in explained}


def test_silences_of_one_edge_are_one_finding_with_the_moment_of_each():
    silent = without(without(edge("odom", "base_link", 200), 3.01, 4), 6.01, 8)
    finding = found(recording(edge("map", "odom", 100, 100), silent, HEALTHY[2]))["gap"]
    assert finding.facts["times"].en == "2 times (at 2.0, 5.0 s)"


def test_two_holes_after_one_silence_are_one_silence():
    samples = edge("odom", "base_link", 200)
    kept = [*samples[:60], *samples[90:91], *samples[100:]]  # silent once, then one sample, then a hole again
    late_ns = samples[100].receive_ns - 2 * MS
    kept[60] = kept[60]._replace(receive_ns=late_ns)
    assert found(recording(edge("map", "odom", 100, 100), kept, HEALTHY[2]))["gap"].facts["times"].en == "once"


def test_a_wheel_that_turns_too_fast_has_two_owners_if_its_hub_is_in_two_places():
    def turning(x):
        return lambda i: Transform.from_rpy(yaw=0.9 * i, translation=(x, 0.0, 0.0))

    second = edge("base_link", "wheel", start_ms=1025, value=turning(0.4))
    patient = recording(*HEALTHY, edge("base_link", "wheel", value=turning(0.1)), second)
    assert found(patient)["two-owners"].child == "wheel"


# -- what one would type, and whom one would ask ------------------------------------------------


def told(patient, code):
    return describe(found(patient)[code])


def test_the_rate_of_one_edge_is_asked_for_without_the_others_on_its_topic():
    gap = told(recording(HEALTHY[0], without(edge("odom", "base_link"), 2, 4), HEALTHY[2]), "gap")
    assert gap.command == (
        "ros2 topic hz /tf --filter \"any(t.child_frame_id == 'base_link' for t in m.transforms)\""
    )  # fmt: skip


def test_two_owners_of_a_joint_are_two_sources_of_joint_states_and_of_odometry_they_are_not():
    joint = told(
        recording(*HEALTHY, *(edge("base_link", "arm", publisher=name) for name in ("/a", "/b"))), "two-owners"
    )
    assert "joint_state_publisher" in joint.cause
    odometry = told(recording(*(edge("odom", "base_link", publisher=name) for name in ("/a", "/b"))), "two-owners")
    assert "wheel odometry and a filter" in odometry.cause


def test_edges_that_suffer_alike_are_told_by_name():
    late = [edge("base_link", f"joint_{i}", delay_ms=900) for i in range(3)]
    assert told(recording(*HEALTHY, *late), "late-stamps").evidence.endswith("Likewise joint_1, joint_2.")


def test_a_name_with_a_space_is_quoted_in_the_command():
    late = edge("base link", "arm", delay_ms=900)
    command = told(recording(*HEALTHY, edge("base_link", "base link"), late), "late-stamps").command
    assert command.endswith("tf2_monitor 'base link' arm")


def test_a_change_of_parents_is_told_in_its_order():
    samples = edge("odom", "base_link")
    moved = [r._replace(stamped=replace(r.stamped, frame_id="map")) for r in samples[50:]]
    changed = told(recording(HEALTHY[0], samples[:50], moved, HEALTHY[2]), "re-parented")
    assert changed.evidence == "Its parent was odom, then map."


def test_a_prefix_is_told_with_the_names_that_have_it():
    prefixed = [edge("r1/base_link", f"r1/arm_{i}") for i in range(2)]
    assert "With the prefix: r1/base_link." in told(recording(*HEALTHY, *prefixed), "name-prefix").evidence


def test_of_several_robots_a_finding_says_which_and_its_command_listens_there():
    healthy = [of_robot("r1", records) for records in HEALTHY]
    late = (HEALTHY[0], edge("odom", "base_link", delay_ms=900), HEALTHY[2])
    (finding,) = diagnose_recording(recording(*healthy, *(of_robot("r2", records) for records in late))).findings
    said = describe(finding)
    assert said.title == "/r2: odom -> base_link comes late"
    assert said.command.endswith("tf2_monitor odom base_link --ros-args -r /tf:=/r2/tf -r /tf_static:=/r2/tf_static")


# -- whose clock ----------------------------------------------------------------------------------

WALL_MS = 1_700_000_000_000
ON_THE_WALL = [edge("map", "odom", 50, 100, start_ms=WALL_MS), edge("odom", "base_link", start_ms=WALL_MS), LASER]
SIMULATED = [
    LASER,
    *(edge(*names, delay_ms=WALL_MS) for names in (("map", "odom"), ("odom", "base_link"), ("base_link", "arm"))),
]
RESTARTED = [r._replace(stamped=replace(r.stamped, stamp_ns=200 * MS)) if 20 <= i < 30 else r
             for i, r in enumerate(ON_THE_WALL[0])]  # fmt: skip
LONG = [edge("odom", "base_link", 2000, start_ms=WALL_MS), LASER]


def lidar(kind, delay_ms, start_ms=WALL_MS, pace=1.0, count=40):
    header = headers(f"/lidar/{kind}", "sensor_msgs/msg/PointCloud2", "laser_frame", count, 100, delay_ms, start_ms)
    begin_ns = header.stamp_ns[0]
    return header._replace(stamp_ns=begin_ns + np.round((header.stamp_ns - begin_ns) * pace).astype(np.int64))


def lidars(*options):
    return [lidar("imu", *options), lidar("points", options[0] + 110, *options[1:])]


WHOSE_CLOCK = {
    "counted from power-on": (ON_THE_WALL, lidars(WALL_MS - 1_503_000, 1_503_000), "time-uptime", "error"),
    "counted from power-on beside a simulation": (
        SIMULATED,
        lidars(WALL_MS - 9_000_000, 9_001_000),
        "time-uptime",
        "error",
    ),
    "without a date": (ON_THE_WALL, lidars(WALL_MS // 2, WALL_MS // 2), "time-date", "error"),
    "of another date, in most sources": (
        ON_THE_WALL[1:],
        lidars(-7_200_000, WALL_MS + 7_200_000),
        "time-date-ahead",
        "error",
    ),
    "of a slow simulation": (ON_THE_WALL, lidars(WALL_MS, 1000, 0.8), "time-simulated", "error"),
    "that stand still": (ON_THE_WALL, lidars(WALL_MS // 2, WALL_MS // 2, 0.0), "time-frozen", "error"),
    "in TAI": (ON_THE_WALL, lidars(-36_998, WALL_MS + 37_000), "time-tai", "error"),
    "of the wall": (SIMULATED, [*lidars(5, WALL_MS + 1000)], "time-wall", "error"),
    "ahead by half a second": (ON_THE_WALL, lidars(-500), "messages-early", "warning"),
    "of a clock that loses 2 ms a second": (LONG, lidars(0, WALL_MS, 0.998, 1000), "clock-slow", "warning"),
    "of a clock that gains 2 ms a second": (LONG, lidars(300, WALL_MS, 1.002, 1000), "clock-fast", "warning"),
}


@pytest.mark.parametrize(("edges", "sensors", "code", "severity"), WHOSE_CLOCK.values(), ids=WHOSE_CLOCK)
def test_topics_of_one_device_with_stamps(edges, sensors, code, severity):
    findings = diagnose_recording(replace(recording(*edges), headers=tuple(sensors))).of_severity("error", "warning")
    assert [(f.code, f.severity, f.topic, f.siblings) for f in findings] == [
        (code, severity, "/lidar/imu", ("/lidar/points",))
    ]
    said = describe(findings[0])
    assert ("use_sim_time" in said.cause) == (code in ("time-wall", "time-simulated"))
    if code in ("time-date", "time-date-ahead", "time-uptime"):
        is_ahead = np.mean(sensors[0].stamp_ns) > edges[-2][0].stamped.stamp_ns
        assert ("ahead of the others" if is_ahead else "behind the others") in said.evidence


def test_stamps_that_are_not_set_for_a_while_are_no_jump_of_a_clock():
    (finding,) = diagnose_recording(recording(RESTARTED, *ON_THE_WALL[1:])).of_severity("error", "warning")
    assert (finding.code, finding.child, finding.facts["count"], finding.facts["total"]) == (
        "unset-stamps", "odom", 10, 50,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("delay_ms", "sweep_ms", "code", "severity", "siblings"),
    [
        (103, 40, "host-late", "warning", ("wheel", "/imu")),  # the scan's own period explains its delay
        (1400, 90, "host-late", "warning", ("wheel", "/imu", "/scan")),
        (1400, 90, "host-late", "warning", ("/imu", "/scan")),
        (-900, 90, "host-early", "warning", ("wheel", "/imu", "/scan")),
        (-25_000, 90, "host-early", "error", ("wheel", "/imu", "/scan")),
    ],
)
def test_what_one_computer_publishes_late_or_early_is_one_finding(delay_ms, sweep_ms, code, severity, siblings):
    imu = headers("/imu", "sensor_msgs/msg/Imu", "base_link", 143, 35, delay_ms + 1)
    scan = headers("/scan", "sensor_msgs/msg/LaserScan", "laser_frame", 50, 100, delay_ms + sweep_ms)
    odom, wheel = edge("odom", "base_link", delay_ms=delay_ms + 2), edge("base_link", "wheel", 150, 30, delay_ms)
    patient = recording(MAP, odom, LASER, *([wheel] if "wheel" in siblings else []))
    findings = diagnose_recording(replace(patient, headers=(imu, scan))).of_severity("error", "warning")
    (finding,) = [finding for finding in findings if finding.code != "late-start"]
    assert (finding.code, finding.severity, finding.child) == (code, severity, "base_link")
    assert finding.siblings == siblings


@pytest.mark.parametrize(
    ("has_edge", "topics", "severity"),
    [(True, ("/image", "/info"), "error"), (True, (), "error"), (False, ("/image",), "warning"), (False, (), "")],
)
def test_topics_of_a_clock_that_was_set_back_are_named_with_its_edges(has_edge, topics, severity):
    ahead = [r._replace(stamped=replace(r.stamped, stamp_ns=r.stamped.stamp_ns + 8 * SECOND)) for r in ODOM[:40]]
    clean = [headers(topic, "sensor_msgs/msg/Imu", "base_link") for topic in ("/image", "/info", "/steady")]
    set_back = [h._replace(stamp_ns=h.stamp_ns + np.where(np.arange(60) < 20, 8 * SECOND, 0))
                if h.topic in topics else h for h in clean]  # fmt: skip
    patient = recording(MAP, [*ahead, *ODOM[40:]] if has_edge else ODOM, edge("base_link", "arm"), LASER)
    findings = diagnose_recording(replace(patient, headers=tuple(set_back))).of_severity("error", "warning")
    assert [(f.code, f.severity) for f in findings] == ([("clock-jump-back", severity)] if severity else [])
    for finding in findings:
        assert finding.facts["edges"].en == ", ".join((*(["odom -> base_link"] if has_edge else []), *topics))
        assert describe(finding).command == "chronyc tracking"


STEPS = SECOND + 100 * MS * np.arange(50)
COARSE = Clock(STEPS + WALL_MS * MS, STEPS - 80 * MS)
SWEEPS = headers("/points", "sensor_msgs/msg/PointCloud2", "laser_frame", 50, 100, 110)
NO_OTHER_CLOCK = {
    "a step of /clock": (SIMULATED, {"clock": COARSE}),
    "two topics with the stamps of a sweep": (
        [LASER], {"headers": (SWEEPS, SWEEPS._replace(topic="/cloud", receive_ns=SWEEPS.receive_ns + 5 * MS))},
    ),
}  # fmt: skip


@pytest.mark.parametrize(("edges", "more"), NO_OTHER_CLOCK.values(), ids=NO_OTHER_CLOCK)
def test_no_other_clock_is_in(edges, more):
    assert alarming(replace(recording(*edges), **more)) == set()


# -- what the recording says about its publishers --------------------------------------------------

OFFER = QosProfile("keep_last", 10, "best_effort", "transient_local")


def test_a_topic_without_a_message_points_at_the_quality_of_service():
    silent = Connection("/tf", "tf2_msgs/msg/TFMessage", "", (OFFER,), 0)
    odometry = headers("/odom", "nav_msgs/msg/Odometry", "odom")
    patient = replace(recording(LASER), connections=(silent,), headers=(odometry,))
    (finding,) = diagnose_recording(patient).of_severity("error", "warning")
    assert (finding.code, finding.topic, finding.facts["offer"]) == (
        "empty-topic",
        "/tf",
        "best_effort, transient_local",
    )
    assert [effect.code for effect in finding.effects] == ["unknown-world-frame"]


def test_two_publishers_of_one_topic_are_named_where_their_values_contradict_each_other():
    offers = tuple(Connection(topic, "", "", (OFFER, OFFER), 1) for topic in ("/joint_states", "/tf_static"))
    joints = JointStates("/joint_states", np.repeat(np.arange(9), 2), (("j",),) * 18, ((0.0,), (1.0,)) * 9)
    mounts = [mount("base_link", name) for name in ("laser_frame", "imu")]
    patient = recording(MAP, ODOM, *mounts, mount("base_link", "laser_frame", x=0.4, start_ms=2000))
    message = np.where(patient.transforms.receive_ns < 1100 * MS, 0, np.arange(len(patient.transforms)))
    together = replace(patient.transforms, message=message)  # one publisher sent the mounts in one message
    patient = replace(patient, connections=offers, joint_states=(joints,), transforms=together)
    assert alarming(patient) == {"two-joint-publishers", "two-owners"}
    assert found(patient)["two-owners"].facts["apart"] == "0.200"


def test_a_recording_of_ros1_gets_the_commands_of_ros1_and_the_names_of_the_nodes():
    late = edge("odom", "base_link", delay_ms=900, publisher="/base")
    said = told(replace(recording(MAP, late, LASER), is_ros1=True), "late-stamps")
    assert said.command == "rosrun tf tf_monitor odom base_link" and said.evidence.endswith("Published by /base.")


@pytest.mark.parametrize(("frame", "count"), [("base_link", 1), ("laser_frame", 1), ("lens", 0), ("nobody", 0)])
def test_images_in_a_body_frame_are_named_where_no_frame_is_optical(frame, count):
    lens = [r._replace(stamped=replace(r.stamped, child_frame_id="lens")) for r in LENS]
    images = headers("/image", "sensor_msgs/msg/Image", frame)
    patient = replace(recording(MAP, ODOM, LASER, lens), headers=(images,))
    assert sum(f.code == "image-in-body-frame" for f in diagnose_recording(patient).findings) == count


def test_an_image_in_a_body_frame_a_mount_in_degrees_and_latched_messages_that_replace_each_other_are_named():
    mounts = [("laser_frame", Transform.from_rpy(yaw=90.0)), ("camera", Transform.from_rpy(pitch=math.radians(40.0))),
              ("imu", Transform.from_rpy(yaw=-90.0))]  # fmt: skip
    edges = [edge("base_link", child, 1, value=lambda i, pose=pose: pose, is_static=True) for child, pose in mounts]
    edges.append(edge("camera", "camera_optical", 1, value=lambda i: OPTICAL, is_static=True, start_ms=1100))
    patient = recording(MAP, ODOM, *([r._replace(publisher="/play") for r in records] for records in edges))
    patient = replace(patient, headers=(headers("/image", "sensor_msgs/msg/Image", "camera"),))
    assert alarming(patient) == {"image-in-body-frame", "mount-in-degrees", "latched-replaced"}
    findings = [f for f in diagnose_recording(patient).findings if f.code == "mount-in-degrees"]
    assert [(f.child, f.facts["degrees"]) for f in findings] == [("laser_frame", 90), ("imu", -90)]
