"""A compacted scene is the scene: the same last commands, in an order that gives the same picture."""

from __future__ import annotations

import struct

import numpy as np
import pytest
import umsgpack
from hypothesis import given
from hypothesis import strategies as st

from tflab.core import Transform
from tflab.views.scene.state import SceneState, pack, plain, with_stable_ids


def heard(*commands: dict) -> SceneState:
    state = SceneState()
    for command in commands:
        state.apply(command, pack(command))
    return state


def replayed(state: SceneState) -> list[dict]:
    """What a late viewer is told."""
    data, commands, at = state.packed(), [], 4
    while at < len(data):
        (length,) = struct.unpack_from("<I", data, at)
        commands.append(umsgpack.unpackb(data[at + 4 : at + 4 + length]))
        at += 4 + length
    return commands


def move(path: str, x_m: float) -> dict:
    matrix = Transform((x_m, 0.0, 0.0)).matrix()
    return {"type": "set_transform", "path": path, "matrix": matrix.T.flatten().tolist()}


def put(path: str, what: str = "box") -> dict:
    return {"type": "set_object", "path": path, "object": what}


def paint(path: str, colour: str) -> dict:
    return {"type": "set_property", "path": path, "property": "color", "value": colour}


def delete(path: str) -> dict:
    return {"type": "delete", "path": path}


def test_of_two_commands_on_one_subject_only_the_last_is_kept_and_all_are_counted():
    state = heard(put("/meshcat/a"), move("/meshcat/a", 1.0), move("/meshcat/a", 2.0))
    assert replayed(state) == [put("/meshcat/a"), move("/meshcat/a", 2.0)]
    assert struct.unpack_from("<I", state.packed()) == (3,)


def test_a_deleted_branch_is_not_mentioned_but_a_namesake_and_what_is_the_viewers_own_is():
    state = heard(put("/meshcat/a/b"), put("/meshcat/ab"), delete("/meshcat/a"))
    assert replayed(state) == [put("/meshcat/ab")]
    assert replayed(heard(delete("/Grid"))) == [delete("/Grid")]


def test_an_animation_is_said_after_the_objects_it_moves():
    animation = {"type": "set_animation", "path": "", "animations": [], "options": {}}
    assert replayed(heard(animation, put("/meshcat/a"))) == [put("/meshcat/a"), animation]


def test_paint_stays_before_the_object_that_replaced_what_was_painted():
    state = heard(put("/meshcat/a"), paint("/meshcat", "red"), put("/meshcat/a", "sphere"))
    assert replayed(state) == [paint("/meshcat", "red"), put("/meshcat/a", "sphere")]


PATHS = st.sampled_from(["/meshcat", "/meshcat/a", "/meshcat/a/b", "/meshcat/c"])
COMMANDS = st.lists(
    st.one_of(
        st.builds(put, PATHS, st.sampled_from(["box", "sphere"])),
        st.builds(paint, PATHS, st.sampled_from(["red", "blue"])),
        st.builds(delete, st.sampled_from(["/meshcat/a", "/meshcat/a/b", "/meshcat/c"])),
    ),
    max_size=12,
)


def seen(commands: list[dict]) -> dict[str, tuple[str, str | None]]:
    """What a viewer shows: each object with the paint on it.  Paint colours what is there at that moment."""
    shown: dict[str, tuple[str, str | None]] = {}
    for command in commands:
        path = command["path"]
        below = [p for p in shown if (p + "/").startswith(path + "/")]
        if command["type"] == "set_object":
            shown[path] = (command["object"], None)
        for p in below:
            if command["type"] == "set_property":
                shown[p] = (shown[p][0], command["value"])
            if command["type"] == "delete":
                del shown[p]
    return shown


@given(COMMANDS)
def test_a_late_viewer_sees_what_an_early_one_sees(commands):
    assert seen(replayed(heard(*commands))) == seen(commands)


@given(COMMANDS, COMMANDS)
def test_what_is_said_already_changes_nothing_when_said_again(before, again):
    state, said = heard(*before), list(before)
    for command in again:
        if state.is_redundant(command):
            assert seen([*said, command]) == seen(said)
        else:
            state.apply(command, pack(command))
            said.append(command)


def test_a_pose_is_the_product_of_all_above_it():
    turn = Transform.from_rpy(yaw=np.pi / 2, translation=(0.0, 0.0, 1.0))
    above = {"type": "set_transform", "path": "/meshcat/a", "matrix": turn.matrix().T.flatten().tolist()}
    pose = heard(above, move("/meshcat/a/b", 2.0)).pose("/meshcat/a/b")
    assert pose.translation == pytest.approx((0.0, 2.0, 1.0))  # 2 m along an x that points along y


def test_numpy_values_become_plain_ones_and_bytes_stay():
    value = {"a": np.float32(0.5), "b": [np.array([[1, 2]])], "c": b"\x01"}
    assert plain(value) == {"a": 0.5, "b": [[[1, 2]]], "c": b"\x01"}


def test_ids_come_from_the_path_and_still_agree_with_each_other():
    def command(geometry: str, material: str) -> dict:
        return {
            "path": "/meshcat/a",
            "geometries": [{"uuid": geometry}],
            "materials": [{"uuid": material}],
            "object": {"geometry": geometry, "material": material},
        }

    first = with_stable_ids(command("random-1", "random-2"), "/meshcat/a")
    assert first == with_stable_ids(command("other-1", "other-2"), "/meshcat/a")
    assert first["object"] == {"geometry": "/meshcat/a#0", "material": "/meshcat/a#1"}
