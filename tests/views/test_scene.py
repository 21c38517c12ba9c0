"""Ordinary meshcat code on a scene, our drawings, and the same in words; no browser is needed for these."""

from __future__ import annotations

import math
import subprocess
import sys
import threading

import numpy as np
import pytest
from meshcat.animation import Animation
from meshcat.geometry import Box, Sphere
from meshcat.transformations import translation_matrix

from tflab.core import Transform
from tflab.views.scene import (
    Part,
    Scene,
    draw_arrow,
    draw_ball,
    draw_camera,
    draw_frame,
    draw_mug,
    draw_path,
    draw_points,
    draw_robot,
    draw_scan,
)
from tflab.views.scene.shapes import ball, mug

FORWARD = Transform((1.0, 0.0, 0.0))
TURNED = Transform.from_rpy(yaw=math.pi / 2, translation=(1.0, 2.0, 0.0))


@pytest.fixture
def scene() -> Scene:
    return Scene()


def sent_by(scene: Scene) -> list[int]:
    """Have the number of commands in each message noted from now on."""
    counts: list[int] = []
    scene.send = lambda _content, buffers=(): counts.append(len(buffers))
    return counts


def test_ordinary_meshcat_code_works(scene):
    scene["robot/base"].set_object(Box([0.5, 0.3, 0.1]))
    scene["robot"].set_transform(translation_matrix(np.float32([1, 2, 3])))
    scene["robot/base"].set_property("visible", np.bool_(True))
    scene["robot/base"]["arm"].set_object(Sphere(0.1))
    animation = Animation()
    with animation.at_frame(scene, 0) as frame:
        frame["robot"].set_transform(translation_matrix([0.0, 0.0, 0.0]))
    scene.set_animation(animation, play=False)
    scene["robot/base/arm"].delete()
    assert scene._state.pose("/meshcat/robot/base").translation == pytest.approx((1.0, 2.0, 3.0))


def test_the_same_scene_gives_the_same_bytes():
    def drawn() -> bytes:
        scene = Scene()
        scene["box"].set_object(Box([1.0, 1.0, 1.0]))
        draw_frame(scene, "map", Transform())
        scene.flush()
        return scene.scene

    assert drawn() == drawn()


def test_the_words_give_each_frame_in_its_parent(scene):
    for name, pose, parent in (("map", Transform(), ""), ("base_link", FORWARD, "map"), ("laser", TURNED, "base_link")):
        draw_frame(scene, name, pose, parent)
    assert scene.describe() == (
        "3D scene: 3 frames, 0 other things\n"
        "  map        frame\n"
        "  base_link  frame in map: x 1.000 m, y 0.000 m, z 0.000 m; roll 0.0 deg, pitch 0.0 deg, yaw 0.0 deg\n"
        "  laser      frame in base_link: x 0.000 m, y 2.000 m, z 0.000 m; roll 0.0 deg, pitch 0.0 deg, yaw 90.0 deg"
    )


def test_the_words_name_everything_else(scene):
    draw_frame(scene, "laser", TURNED, is_ghost=True)
    draw_scan(scene, "scan", Transform(), [1.0, math.inf, 2.0, math.nan], -0.1, 0.1)
    draw_points(scene, "cloud", np.zeros((7, 3)))
    draw_path(scene, "plan", np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0)]))
    draw_camera(scene, "camera", Transform(), pixels=np.array([(320.0, 240.0)]))
    draw_arrow(scene, "step", (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), "t")
    parts = {"base": [Part("box", (1.0, 1.0, 1.0))], "arm": [Part("cylinder", (0.1, 1.0)), Part("sphere", (0.1,))]}
    draw_robot(scene, "robot", parts, {"base": Transform()})
    lines = scene.describe().splitlines()
    assert lines[0] == "3D scene: 1 frame, 7 other things"
    assert [line.split(maxsplit=1) for line in lines[2:]] == [
        ["scan/points", "laser scan, 2 points"],
        ["cloud", "point cloud, 7 points"],
        ["plan", "path, 3 points"],
        ["camera", "camera, 640 x 480 pixels, image plane at 0.60 m"],
        ["camera/pixels", "pixels, 1 points"],
        ["step", "arrow from (0.000, 0.000, 0.000) m to (1.000, 0.000, 0.000) m"],
        ["robot", "robot, 1 of 2 links"],
    ]
    assert lines[1].split(maxsplit=1)[1].startswith("ghost frame at x 1.000 m, y 2.000 m")


def test_a_redraw_is_one_message_and_moving_what_is_there_sends_only_where_it_is(scene):
    sent = sent_by(scene)
    with scene.redraw():
        draw_frame(scene, "map", Transform())
        draw_frame(scene, "base_link", FORWARD, "map")
    assert len(sent) == 1
    sent.clear()
    with scene.redraw():
        draw_frame(scene, "base_link", TURNED, "map")
    assert sent == [1]


def test_an_arrow_points_from_its_start_to_its_end_and_its_name_keeps_clear_of_it(scene):
    draw_arrow(scene, "step", (1.0, 2.0, 0.0), (1.0, 2.0, 3.0), "3 m")
    pose = scene._state.pose("/meshcat/step")
    assert pose.translation == (1.0, 2.0, 0.0)
    assert pose.apply((3.0, 0.0, 0.0)) == pytest.approx((1.0, 2.0, 3.0))
    (label,) = scene._state.properties("labels")["/meshcat/step"]
    assert (label["at"], label["along"]) == ([1.5, 0.0, 0.0], [3.0, 0.0, 0.0])


def test_a_ball_and_a_mug_stand_where_they_are_seen_and_are_said_by_name(scene):
    for draw, name, place in ((draw_ball, "ball", (6.5, -1.5, 0.3)), (draw_mug, "mug", (1.6, -0.4, 0.5))):
        draw(scene, name, place)
        assert scene._state.pose(f"/meshcat/{name}").translation == place
        said = [line.split(maxsplit=1) for line in scene.describe().splitlines()]
        assert [name, "{} at ({:.3f}, {:.3f}, {:.3f}) m".format(name, *place)] in said
    assert np.linalg.norm(ball(0.3, "#B5539B").points, axis=1) == pytest.approx(0.3)
    points = mug(0.2, "#B5539B").points
    assert np.ptp(points[:, 2]) == pytest.approx(0.2)
    assert -points[:, 1].min() > 1.5 * points[:, 1].max()  # the handle


def test_two_threads_may_draw_into_one_scene(scene):
    def draw(name: str) -> None:
        for i in range(50):
            with scene.redraw():
                draw_frame(scene, name, Transform((float(i), 0.0, 0.0)))

    threads = [threading.Thread(target=draw, args=(name,)) for name in "abcd"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [scene._state.pose(f"/meshcat/frames/{name}").translation[0] for name in "abcd"] == [49.0] * 4


def test_a_sweep_leaves_the_scene_at_its_start_and_stores_what_changes(scene):
    scene.sweep("x", [0.0, 1.0, 2.0], lambda x_m: draw_frame(scene, "a", Transform((x_m, 0.0, 0.0))), "m", start=2)
    assert "x 2.000 m" in scene.describe()
    ((_, _, value),) = [(kind, path, word) for (kind, path, _), word in scene._state._words.items() if kind == "sweep"]
    sweep = value.command
    assert sweep["texts"] == ["x = 0.00 m", "x = 1.00 m", "x = 2.00 m"]
    assert [[command["type"] for command in step] for step in sweep["steps"]] == [["set_transform"]] * 3


def test_a_failed_drawing_leaves_the_scene_usable_and_an_unknown_part_is_refused_by_name(scene):
    with pytest.raises(ZeroDivisionError):
        scene.sweep("x", [0.0], lambda x: 1 / x)
    with pytest.raises(ValueError, match='not a "cone"'):
        draw_robot(scene, "robot", {"base": [Part("cone", (1.0,))]}, {"base": Transform()})
    draw_frame(scene, "map", Transform())
    assert "3D scene: 1 frame," in scene.describe()


def test_who_opens_late_gets_everything_and_a_slash_in_a_name_hangs_it_on_no_other_frame(scene):
    draw_frame(scene, "robot1", FORWARD)
    draw_frame(scene, "robot1/base_link", Transform())
    assert "  robot1/base_link  frame\n" in scene.describe() + "\n"
    state = scene.get_state()
    assert b"frames/robot1" in state["scene"]
    assert state["description"] == scene.describe()


def test_importing_the_module_does_not_import_meshcat():
    code = "import sys, tflab.views.scene; sys.exit('meshcat' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], timeout=60).returncode == 0
