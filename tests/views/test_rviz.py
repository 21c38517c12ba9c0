"""RViz's picture and RViz's words, for a robot in a room, and for each way it can go wrong."""

from __future__ import annotations

import copy
import math
import struct
from typing import NamedTuple

import numpy as np
import pytest
import umsgpack

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, seconds
from tflab.views.rviz import RViz
from tflab.views.rviz_status import (
    Display,
    LaserScan,
    MapCells,
    Path,
    PointCloud2,
    RobotModel,
    look_through,
    statuses_as_text,
)
from tflab.views.scene import Part

#   map -(still)-> odom -(0.5 m/s along x)-> base_link -(bolted)-> laser_frame, wheel_link
PARENTS = {"map": "", "odom": "map", "base_link": "odom", "laser_frame": "base_link", "wheel_link": "base_link"}
MOUNTS = {"laser_frame": Transform((0.2, 0.0, 0.15)), "wheel_link": Transform((0.0, 0.2, 0.05))}
ROBOT = RobotModel(
    {
        "base_link": [Part("box", (0.5, 0.3, 0.12))],
        "laser_frame": [Part("cylinder", (0.04, 0.06))],
        "wheel_link": [Part("cylinder", (0.05, 0.04), Transform.from_rpy(roll=math.pi / 2))],
    }
)
WALL = MapCells("map", LATEST, [(3.0, y) for y in np.arange(-1.5, 1.51, 0.05)])


class World(NamedTuple):
    parents: dict
    displays: tuple
    ask: object


def scan_of_wall(base_x_m: float, stamp_ns: int, frame_id: str = "laser_frame") -> LaserScan:
    """What the laser measures of the wall x = 3 m when the robot is at (base_x_m, 0)."""
    angles = np.linspace(-0.4, 0.4, 41)
    return LaserScan(frame_id, stamp_ns, tuple((3.0 - base_x_m - 0.2) / np.cos(angles)), -0.4, 0.02)


def world(without: tuple = (), mounts: dict = MOUNTS, stamp_shift_ns: int = 0, frame_id: str = "laser_frame") -> World:
    """A robot that has driven from x = 0 at 1 s to x = 1 m at 3 s, with three scans of the wall on its way."""
    buffer = BufferCore()
    edges = [("map", "odom", 1.0, Transform()), ("map", "odom", 3.0, Transform())]
    edges += [("odom", "base_link", 1.0, Transform()), ("odom", "base_link", 3.0, Transform((1.0, 0.0, 0.0)))]
    for parent, child, at_s, pose in edges:
        if child not in without:
            buffer.set_transform(StampedTransform(parent, child, seconds(at_s), pose))
    for child, pose in mounts.items():
        if child not in without:
            buffer.set_transform(StampedTransform("base_link", child, 0, pose), is_static=True)
    scans = tuple(
        scan_of_wall(0.5 * (at_s - 1.0), seconds(at_s) + stamp_shift_ns, frame_id) for at_s in (1.0, 2.0, 3.0)
    )
    displays = (Display("Map", (WALL,), "/map"), Display("RobotModel", ROBOT), Display("LaserScan", scans, "/scan"))
    names = buffer.frame_names()
    parents = {name: "" if name in without else PARENTS[name] for name in names}

    def ask(target_frame: str, source_frame: str, stamp_ns: int) -> Transform:
        return buffer.lookup_transform(target_frame, source_frame, stamp_ns).transform

    return World(parents, displays, ask)


def entry(shown: tuple, name: str):
    return next(one for one in shown if one.name == name)


def text_of(shown_entry, name: str) -> str:
    return next(status.text for status in shown_entry.statuses if status.name == name)


def frame_line(rviz: RViz, frame: str) -> str:
    """What the scene says about a frame, in words."""
    return next(line.split(maxsplit=1)[1] for line in rviz.scene.describe().splitlines() if line.split()[0] == frame)


def hits_x_m(shown: tuple) -> list[float]:
    """Where each scan says the wall is: the x of its middle ray's end, in the Fixed Frame."""
    return [
        fixed_T_scan.apply((scan.ranges_m[20], 0.0, 0.0))[0] for scan, fixed_T_scan in entry(shown, "LaserScan").placed
    ]


def test_a_sound_robot_is_shown_whole_and_everything_is_ok():
    shown = look_through("map", *world())
    assert [(one.name, one.level) for one in shown] == [
        ("Global Status", "Ok"),
        ("TF", "Ok"),
        ("Map", "Ok"),
        ("RobotModel", "Ok"),
        ("LaserScan", "Ok"),
    ]
    assert hits_x_m(shown) == pytest.approx([3.0, 3.0, 3.0])
    assert text_of(entry(shown, "LaserScan"), "Points") == "Showing [123] points from [3] messages"


def test_another_fixed_frame_changes_the_picture_and_not_the_data():
    at = world()
    in_map, in_base = look_through("map", *at), look_through("base_link", *at)
    assert entry(in_map, "TF").poses["base_link"].translation == pytest.approx((1.0, 0.0, 0.0))
    assert entry(in_base, "TF").poses["base_link"].translation == pytest.approx((0.0, 0.0, 0.0))
    assert entry(in_base, "TF").poses["map"].translation == pytest.approx((-1.0, 0.0, 0.0))
    assert entry(in_map, "LaserScan").display is entry(in_base, "LaserScan").display


# -- the six symptoms ---------------------------------------------------------


def test_symptom_1_a_misspelt_fixed_frame_does_not_exist_and_without_any_frame_there_is_no_tf_data():
    shown = look_through("mpa", *world())
    assert text_of(entry(shown, "Global Status"), "Fixed Frame") == "Frame [mpa] does not exist"
    assert entry(shown, "Global Status").level == "Error"
    expected = "For frame [laser_frame]: Fixed Frame [mpa] does not exist"
    assert text_of(entry(shown, "LaserScan"), "Transform") == expected
    assert entry(shown, "TF").poses == {}
    (status,) = entry(look_through("map", {}, (), BufferCore().lookup_transform), "Global Status").statuses
    assert status == ("Warn", "Fixed Frame", "No tf data.  Actual error: Frame [map] does not exist")


def test_symptom_2_a_link_without_joint_state_is_missing_from_the_robot():
    robot = entry(look_through("map", *world(without=("wheel_link",))), "RobotModel")
    assert sorted(robot.poses) == ["base_link", "laser_frame"]
    assert text_of(robot, "wheel_link") == "No transform from [wheel_link] to [map]"
    assert robot.level == "Error"


def test_symptom_3_a_wrong_mount_puts_the_scan_beside_the_wall():
    turned = MOUNTS | {"laser_frame": Transform.from_rpy(yaw=math.pi / 2, translation=(0.2, 0.0, 0.15))}
    shown = look_through("map", *world(mounts=turned))
    assert entry(shown, "LaserScan").level == "Ok"  # RViz cannot know
    assert hits_x_m(shown) == pytest.approx([0.2, 0.7, 1.2])


def test_symptom_4_late_stamps_smear_the_scan_over_the_wall():
    #  0.5 m/s and stamps 0.8 s too early: two scans land 0.4 m short, the first is before all data
    shown = look_through("map", *world(stamp_shift_ns=-seconds(0.8)))
    assert hits_x_m(shown) == pytest.approx([2.6, 2.6])
    scan = entry(shown, "LaserScan")
    assert text_of(scan, "Transform").startswith(
        "No transform to fixed frame [map]. TF error: [Lookup would require extrapolation into the past."
    )
    assert text_of(scan, "Points") == "Showing [82] points from [2] messages"


def test_symptom_5_two_publishers_make_the_robot_jump():
    rviz = RViz({"map": "", "base_link": "map"}, (), lambda target, source, stamp_ns: Transform())

    def at(t_s: float):
        x_m = 0.0 if round(10 * t_s) % 2 == 0 else 1.5  # publishers take turns
        poses = {"map": Transform(), "base_link": Transform((x_m, 0.0, 0.0))}
        return {"map": "", "base_link": "map"}, (), lambda target, source, stamp_ns: poses[source]

    rviz.sweep("t", [0.0, 0.1, 0.2, 0.3], at)
    assert "base_link  frame in map: x 0.000 m" in rviz.scene.describe()


@pytest.mark.parametrize("without", [(), ("wheel_link",), ("base_link",)])
def test_each_choice_that_is_drawn_ahead_is_what_choosing_it_shows(without):
    rviz = RViz(*world(without=without), fixed_frame="laser_frame")
    sent = []
    rviz.scene.send = lambda message, buffers: sent.append((message, buffers))
    rviz.scene._handle_custom_msg({"type": "hand"}, [])
    ((message, steps),) = sent
    assert message == {"type": "ahead"} and len(steps) == len(rviz._picker.options) > 3

    ahead = copy.deepcopy(rviz.scene._state)
    for option, step in zip(rviz._picker.options, steps, strict=True):
        for packed in unjoined(step):
            ahead.apply(umsgpack.unpackb(packed), packed)
        rviz.fixed_frame = option
        assert what_stands(ahead) == what_stands(rviz.scene._state), option


def unjoined(step: bytes) -> list[bytes]:
    (count,) = struct.unpack_from("<I", step)
    packed, i = [], 4
    for _ in range(count):
        (length,) = struct.unpack_from("<I", step, i)
        packed.append(step[i + 4 : i + 4 + length])
        i += 4 + length
    return packed


def what_stands(state) -> dict:
    """Return the last word on everything that is there, with numbers to a micrometre."""
    return {
        subject: np.round(word.command["matrix"], 6).tolist() if "matrix" in word.command else word.packed
        for subject, word in state._words.items()
        if subject[0] != "delete"
    }


def test_symptom_6_a_broken_chain_leaves_the_map_without_a_robot():
    shown = look_through("map", *world(without=("base_link",)))
    assert entry(shown, "Map").placed
    assert entry(shown, "RobotModel").poses == {}
    expected = "No transform from [base_link] to [map]"
    assert text_of(entry(shown, "RobotModel"), "base_link") == expected
    assert text_of(entry(shown, "TF"), "base_link") == "No transform from [base_link] to frame [map]"
    assert "not part of the same tree" in text_of(entry(shown, "LaserScan"), "Transform")


# -- the other displays, and the widget ---------------------------------------


def test_a_path_or_cloud_in_an_unknown_frame_and_a_topic_without_messages_are_named():
    at = world()
    path = Display("Path", (Path("plan", LATEST, ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))),), "/plan")
    cloud = Display("PointCloud2", (PointCloud2("camera", LATEST, ((0.0, 0.0, 1.0),)),), "/points")
    shown = look_through("map", at.parents, (path, cloud, Display("LaserScan", (), "/scna")), at.ask)
    assert text_of(entry(shown, "Path"), "Transform") == "Could not transform from [plan] to [map]"
    unknown = "For frame [camera]: Frame [camera] does not exist"
    assert text_of(entry(shown, "PointCloud2"), "Transform") == unknown
    assert statuses_as_text(shown[4:]) == "LaserScan (/scna): Warn\n  Topic: No messages received"


def test_choosing_a_fixed_frame_in_the_widget_redraws_and_takes_away_what_cannot_be_turned():
    rviz = RViz(*world())
    assert frame_line(rviz, "base_link").startswith("frame in odom: x 1.000 m")
    rviz.fixed_frame = "mpa"
    assert "Fixed Frame: Frame [mpa] does not exist" in rviz.text
    assert rviz.scene.describe() == "3D scene: 0 frames, 0 other things"
    picker = rviz.children[0]
    picker.value = "odom"  # as a learner does with the mouse
    assert frame_line(rviz, "base_link").startswith("frame in odom: x 1.000 m")
    assert set(picker.options) == {*PARENTS, "mpa"}
    assert picker.label == "odom"  # which is what the browser shows


def test_another_fixed_frame_moves_maps_paths_clouds_and_scans_and_sends_none_of_them_again():
    at = world()
    plan = Path("map", LATEST, ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)))
    cloud = PointCloud2("laser_frame", seconds(2.0), ((1.0, 0.0, 0.0),))
    more = (Display("Path", (plan,), "/plan"), Display("PointCloud2", (cloud,), "/points"))
    rviz = RViz(at.parents, (*at.displays, *more), at.ask)
    sent: list[dict] = []
    rviz.scene.send = lambda _content, buffers=(): sent.extend(umsgpack.unpackb(buffer) for buffer in buffers)
    rviz.fixed_frame = "base_link"
    moved = {command["path"].split("/")[2] for command in sent if command["type"] == "set_transform"}
    assert {"Map", "Path", "PointCloud2", "LaserScan", "RobotModel"} <= {name.partition("_")[0] for name in moved}
    assert not [command["path"] for command in sent if command["type"] == "set_object"]


def test_new_values_keep_the_fixed_frame_and_an_exported_page_goes_through_all(monkeypatch):
    monkeypatch.setenv("TFLAB_FILMS", "1")
    rviz = RViz(*world(), fixed_frame="odom")
    rviz.update(*world(without=("wheel_link",)))
    assert rviz.fixed_frame == "odom"
    assert "wheel_link: No transform from [wheel_link] to [odom]" in rviz.text
    rviz._repr_mimebundle_()
    rviz.scene.flush()
    assert b"Fixed Frame = base_link" in rviz.scene.scene
    assert rviz.fixed_frame == "odom"
