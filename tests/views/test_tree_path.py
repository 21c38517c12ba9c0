"""Which way a lookup takes through a tree: up, down, and where it ends."""

import pytest

from tflab.views.tree_path import describe_walk, draw_walk, snapshot_of_parents, walk_between

ROBOT = {"odom": "map", "base": "odom", "laser": "base", "camera": "base", "optical": "camera"}
DOG = {"body": "odom", "odom": "body", "head": "body"}


@pytest.mark.parametrize(
    ("target", "source", "up", "down", "met"),
    [
        ("optical", "laser", ("laser",), ("camera", "optical"), "base"),
        ("map", "laser", ("laser", "base", "odom"), (), "map"),
        ("laser", "laser", (), (), "laser"),
    ],
)
def test_a_question_climbs_up_from_its_source_and_down_to_its_target(target, source, up, down, met):
    walk = walk_between(ROBOT, target, source)
    assert (walk.up, walk.down, walk.met) == (up, down, met)


def test_two_trees_end_at_their_two_roots_and_in_a_loop_only_what_is_met_on_the_way_up_is_reached():
    walk = walk_between(ROBOT | {"base": "odm"}, "map", "laser")
    assert (walk.met, walk.ends) == (None, ("odm", "map"))
    for target, source, met in (("odom", "body", "odom"), ("odom", "head", "odom"), ("head", "odom", None)):
        assert walk_between(DOG, target, source).met == met


def test_the_words_number_every_step():
    walk = walk_between(ROBOT, "optical", "laser")
    assert describe_walk(walk, ROBOT).splitlines() == [
        "from laser to optical",
        "  1  up    laser -> base",
        "  2  down  base -> camera",
        "  3  down  camera -> optical",
        "they meet at base",
    ]


@pytest.mark.parametrize(
    ("parent_of", "said"),
    [
        (ROBOT | {"base": "odm"}, "no way: one climb ends at odm, the other at map"),
        (ROBOT | {"odom": "laser"}, "no way: the climb comes round to laser again"),
    ],
)
def test_where_there_is_no_way_the_words_say_where_the_climbs_end(parent_of, said):
    assert describe_walk(walk_between(parent_of, "map", "laser"), parent_of).endswith(said)


def test_up_and_down_are_told_apart_by_their_lines_and_every_step_has_its_number():
    (axes,) = draw_walk(snapshot_of_parents(ROBOT), "optical", "laser").figure.axes
    walked = [line for line in axes.lines if line.get_linewidth() == 2.4]
    assert len({line.get_linestyle() for line in walked}) == 2
    assert {text.get_text() for text in axes.texts} >= {"1", "2", "3", "source", "target", *ROBOT}


def test_every_edge_of_a_loop_that_is_walked_is_numbered_and_an_unknown_frame_is_refused():
    (axes,) = draw_walk(snapshot_of_parents(ROBOT | {"odom": "laser"}, known=["map"]), "map", "laser").figure.axes
    assert {text.get_text() for text in axes.texts} >= {"1", "2", "3", "map (left over)", "base (again)", "target"}
    with pytest.raises(ValueError, match=r'no frame "lamp".*camera, laser, map'):
        draw_walk(snapshot_of_parents(ROBOT), "lamp", "laser")
