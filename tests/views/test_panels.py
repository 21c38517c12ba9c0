"""Panels follow their controls, say the same in words, and give everything back."""

import gc
import re
import weakref

import pytest

from tflab.core import StampedTransform, Transform, seconds
from tflab.views.late_joiner import Sender, SentMessage
from tflab.views.panels import (
    Travel,
    cameras_panel,
    clocks_panel,
    joins_panel,
    joints_panel,
    latency_panel,
    mount_panel,
    rate_panel,
    rotation_panel,
    rulers_panel,
    sentence_panel,
    timeline_panel,
    tree_panel,
)
from tflab.views.panels.lookups import transform_between
from tflab.views.timeline import Lane
from tflab.views.transform_chain import Step

POSES = {
    "map": Transform(),
    "base_link": Transform.from_rpy(yaw=1.0, translation=(2.0, 1.0, 0.0)),
    "laser_frame": Transform.from_rpy(yaw=1.0, translation=(2.2, 1.3, 0.15)),
}


def lookup(target, source, stamp_ns):
    return StampedTransform(target, source, stamp_ns, Transform((stamp_ns / 1e9, 0.0, 0.0)))


def query_panel():
    lanes = [Lane("map", "odom", (seconds(1), seconds(3)))]
    return timeline_panel("map", "odom", lanes, lookup)


def listener_panel():
    return joins_panel([Sender("driver", (SentMessage(1.0, ("laser_frame",)),))], 0.5, 4.0)


def arm(positions):
    """A joint that turns, and on it one that slides."""
    turned = Transform.from_rpy(yaw=positions["turn"], translation=(0.2, 0.0, 0.1))
    slid = Transform((0.5 + positions["slide"], 0.0, 0.0))
    return [
        Step("turn", "base", "arm", turned, positions["turn"], "rad", "<joint name='turn'>"),
        Step("slide", "arm", "tip", slid, positions["slide"], "m", "<joint name='slide'>"),
    ]


PARENTS = {"odom": "map", "base_link": "odom", "laser_frame": "base_link", "camera_link": "base_link"}


def one_tree_panel():
    return tree_panel(PARENTS, "map", "laser_frame", lambda *asked: (True, f"asked {asked}"))


PANELS = {
    "tree": one_tree_panel,
    "joints": lambda: joints_panel(arm, [Travel("turn", -1.5, 1.5), Travel("slide", 0.0, 0.3, unit="m")]),
    "clocks": clocks_panel,
    "latency": latency_panel,
    "mount": mount_panel,
    "rotation": rotation_panel,
    "cameras": cameras_panel,
    "timeline": query_panel,
    "sentence": lambda: sentence_panel(POSES, "map", "laser_frame"),
    "rulers": rulers_panel,
    "joins": listener_panel,
    "rate": rate_panel,
}
NAMES = {  # of ROS 2, of Python, of a joint, of an angle, of a unit: the same in both languages
    "Python", "LATEST", "durability", "use_sim_time", "rviz2", "detector", "loop", "clock", "rate", "frame",
    "turn", "slide", "roll", "pitch", "yaw", "x", "y", "m", "s", "rad", "Hz",
}  # fmt: skip


@pytest.fixture(params=PANELS, name="make")
def make_fixture(request):
    return PANELS[request.param]


def test_every_control_changes_the_picture_and_back_and_without_a_kernel_a_panel_is_a_film(make):
    panel = make()
    assert panel.picture.size_px[1] <= 545  # of 656 on a screen 768 high: two rows of controls, a button, a line
    data, _ = panel._repr_mimebundle_()
    assert data["text/plain"] == panel.text  # for a page that cannot show widgets
    assert "application/vnd.jupyter.widget-view+json" in data
    text, controls = panel.text, panel.controls.values()
    film = panel.film(steps=3)
    assert panel.text == text
    if any(hasattr(control, "options") or hasattr(control, "readout_format") for control in controls):
        assert len(film.children[-1].words) >= 2
    else:
        assert film is None
    first, before = next(iter(controls)), panel.shown.png
    value = first.value
    change(first)
    first.value = value
    assert panel.shown.png == before
    for description, control in panel.controls.items():
        assert description == control.description and control.tooltip
        assert getattr(control, "continuous_update", True)  # it follows while it is dragged
        before, words = panel.shown.png, panel.text
        change(control)
        assert panel.shown.png != before and panel.text != words, description


@pytest.fixture(name="in_korean")
def in_korean_fixture(tmp_path, monkeypatch):
    (tmp_path / "workbook.json").write_text('{"language": "ko"}', encoding="utf-8")
    monkeypatch.chdir(tmp_path)


def test_in_korean_nothing_beside_a_control_is_english_but_names(make, in_korean):
    panel = make()
    assert panel.widget.children[-2].description == "글로 보기"
    beside = " ".join(panel.controls).replace("m/s", "").replace("rad/s", "")
    assert set(re.findall(r"[A-Za-z_]\w*", beside)) <= NAMES


def change(control):
    """Move a slider by a third of its way, turn a box over, choose the next of a menu."""
    if hasattr(control, "options"):
        control.index = (control.index + 1) % len(control.options)
    elif hasattr(control, "max"):
        control.value = control.value + (control.max - control.min) / 3 * (1 if control.value < control.max / 2 else -1)
    else:
        control.value = not control.value


def test_the_words_are_shown_on_request_and_follow():
    panel = latency_panel()
    as_text, words = panel.widget.children[-2:]
    assert words.layout.display == "none"
    as_text.value = True
    assert words.layout.display == "block"
    panel.controls["speed [m/s]"].value = 2.0
    assert "A robot drives 2.000 m/s" in words.value
    as_text.value = False
    assert words.layout.display == "none"


def test_the_timeline_asks_for_the_moment_under_the_slider_or_for_the_latest():
    panel = query_panel()
    assert panel.controls["query [s]"].value == 2.0  # the middle of the common interval
    panel.controls["query [s]"].value = 1.5
    assert "translation (1.500, 0.000, 0.000) m" in panel.text
    as_text, words = panel.widget.children[-2:]
    as_text.value = True
    assert "map -&gt; odom" in words.value  # escaped for the page
    panel.controls["LATEST"].value = True
    assert panel.text.startswith("lookup_transform('map', 'odom', LATEST)")
    assert panel.controls["query [s]"].disabled


def test_closing_frees_the_figure_and_every_widget(make):
    panel = make()
    figure = weakref.ref(panel.picture.figure)
    control = next(iter(panel.controls.values()))
    parts = list(all_widgets(panel.widget))
    assert all(part.comm is not None for part in parts)
    panel.close()
    assert all(part.comm is None for part in parts)
    change(control)  # harmless
    del panel, control, parts
    gc.collect()
    assert figure() is None


def all_widgets(widget):
    """Yield a widget, its layout and style, and the same of its children."""
    yield widget
    yield from (getattr(widget, name) for name in ("layout", "style") if hasattr(widget, name))
    for child in getattr(widget, "children", ()):
        yield from all_widgets(child)


def test_choosing_in_one_form_changes_the_others():
    panel = sentence_panel(POSES, "map", "laser_frame")
    menus = panel.controls
    menus["Python"].value = ("base_link", "map")
    assert (menus["target"].value, menus["source"].value) == ("base_link", "map")
    assert menus["arrow"].label == "map o--------> base_link"
    assert menus["shell"].label == "ros2 run tf2_ros tf2_echo base_link map"
    menus["source"].value = "laser_frame"
    assert menus["Python"].label == "lookup_transform('base_link', 'laser_frame', Time())"
    menus["shell"].value = ("map", "base_link")
    assert panel.text.startswith("data expressed in [base_link], wanted in [map]")


def test_the_sentence_is_there_in_korean_and_choosing_the_frame_of_the_other_menu_swaps_the_two(in_korean):
    panel = sentence_panel(POSES, "map", "laser_frame")
    labels = [child.value for child in panel.widget.children[0].children if not child.description]
    assert labels == ["", "기준으로 표현된 데이터를", "기준으로 보고 싶습니다."]
    first, second = list(panel.controls.values())[:2]
    source, target = first.value, second.value
    first.value = target
    assert second.value == source


def test_a_sentence_between_frames_is_target_T_source():
    # base_link is 2 m ahead, turned by a quarter: the map's origin is 2 m to its left
    poses = {"map": Transform(), "base_link": Transform.from_rpy(yaw=1.5707963267948966, translation=(2.0, 0.0, 0.0))}
    answer = transform_between(poses, "base_link", "map")
    assert (answer.frame_id, answer.child_frame_id) == ("base_link", "map")
    assert answer.transform.translation == pytest.approx((0.0, 2.0, 0.0))


def test_what_no_panel_can_show_is_refused_with_a_hint():
    with pytest.raises(ValueError, match='no pose is given for "odom"; there are poses for map, base_link, laser_f'):
        sentence_panel(POSES, "map", "odom")
    with pytest.raises(ValueError, match='target and source are both "map": choose two frames'):
        sentence_panel(POSES, "map", "map")
    with pytest.raises(ValueError, match="no joint of this chain moves"):
        joints_panel(arm, [])


def test_the_file_is_shown_of_the_joint_that_was_touched_last():
    panel = PANELS["joints"]()
    assert "<joint name='turn'>" in panel.text  # the first, before anything is touched
    panel.controls["slide [m]"].value = 0.2
    assert "<joint name='slide'>" in panel.text and "<joint name='turn'>" not in panel.text
    assert panel.text.startswith("tip in base: (0.900, 0.000, 0.100) m")


def test_a_frame_can_be_hung_somewhere_else_and_what_tf2_says_stands_below():
    panel = one_tree_panel()
    panel.controls["move"].value = "odom"
    panel.controls["under"].value = "laser_frame"
    assert "! loop: base_link -> laser_frame -> odom -> base_link." in panel.text
    assert "('map', 'odom'), ('odom', 'base_link')" in panel.text and "('laser_frame', 'odom')]" in panel.text


def test_whatever_is_asked_of_a_tree_it_and_tf2s_words_stand_on_its_card_and_the_panel_fits_a_laptop():
    def looped(edges, target, source):  # tf2's longest answer: it names every edge
        named = (f"Frame {child} exists with parent {parent}." for parent, child in edges[:-1])
        return False, "\n".join(["lookup", "loop", *named])

    panel = tree_panel(PARENTS, "map", "laser_frame", looped)
    (axes,) = panel.picture.figure.axes
    for child in PARENTS:
        for parent in (*PARENTS, "map", "odm"):
            panel.controls["move"].value, panel.controls["under"].value = child, parent
            lowest = min((text.get_position()[1] for text in axes.texts), default=0.0)
            card_inch = panel.picture.figure.artists[0].get_height()
            assert lowest - 10.0 > -72.0 * card_inch > axes.get_ylim()[0]
    assert panel.picture.size_px[1] < 520
