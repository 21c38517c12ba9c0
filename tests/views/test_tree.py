"""The drawn frame tree: what it says in words, what it calls a fault, and that nothing in it overlaps."""

import re
from itertools import combinations
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tflab.core import (
    LATEST,
    BufferCore,
    FrameSnapshot,
    LookupException,
    Snapshot,
    StampedTransform,
    Transform,
    seconds,
)
from tflab.views.sheet import BoxMark, LineMark, TextMark, text_width
from tflab.views.tree import draw_tree, rows_of, text_from_tree, tree_faults

AHEAD = Transform((1.0, 0.0, 0.0))


def edge(parent, child, owners=("/node",), static=False, parents=None, samples=20):
    return FrameSnapshot(
        name=child,
        parent=parent,
        is_static=static,
        owners=tuple(sorted({(each, owner) for each in parents or (parent,) for owner in owners})),
        samples=samples,
        rate_hz=0.0 if static else 20.0,
        oldest_ns=0 if static else seconds(1),
        newest_ns=0 if static else seconds(2),
        parent_T_frame=AHEAD,
    )


def forest(*edges, roots=()):
    return Snapshot(tuple(roots), tuple(edges))


ROBOT = forest(
    edge("odom", "base_link", ["/ekf"]),
    edge("map", "odom", ["/amcl"]),
    edge("base_link", "laser_frame", ["/robot_state_publisher"], static=True),
    edge("base_link", "camera_link", ["/robot_state_publisher"], static=True),
    roots=["map"],
)


def test_a_healthy_tree_in_words():
    assert text_from_tree(ROBOT, now_ns=seconds(2.05)) == (
        "map\n"
        "└─ odom               D  20.0 Hz  0.050 s  /amcl\n"
        "   └─ base_link       D  20.0 Hz  0.050 s  /ekf\n"
        "      ├─ camera_link  S                    /robot_state_publisher\n"
        "      └─ laser_frame  S                    /robot_state_publisher"
    )
    assert tree_faults(ROBOT) == ()


def test_without_a_present_moment_the_newest_stamp_is_shown_and_a_rate_needs_two_samples():
    assert "D  20.0 Hz  at 2.000 s  /amcl" in text_from_tree(ROBOT)
    assert "1 sample" in text_from_tree(forest(edge("odom", "base_link", samples=1)))
    assert text_from_tree(forest()) == "(no frames yet)"
    assert "no frames yet" in draw_tree(forest()).svg


def test_a_misspelt_parent_shows_as_two_trees():
    typo = forest(edge("map", "odom", static=True), edge("odm", "base_link", static=True))
    assert text_from_tree(typo).splitlines()[-1] == (
        "! 2 separate trees, from map, odm. No lookup crosses from one to another (ConnectivityException)."
    )


def test_a_loop_is_drawn_once_and_closed_by_its_first_frame():
    loop = forest(edge("a", "b"), edge("b", "c"), edge("c", "a", ["/late"]), edge("c", "tool", static=True))
    assert [(row.frame, row.parent_row, row.role) for row in rows_of(loop)] == [
        ("a", None, "frame"), ("b", 0, "frame"), ("c", 1, "frame"), ("a", 2, "again"), ("tool", 2, "frame"),
    ]  # fmt: skip
    assert "a (again)  D  20.0 Hz" in text_from_tree(loop)
    assert [fault.text for fault in tree_faults(loop)] == [
        "loop: a -> b -> c -> a. A lookup that enters it fails (LookupException), unless it meets its target on the "
        "way up from its source."
    ]


def test_what_is_said_of_a_loop_is_what_the_engine_does():
    buffer = BufferCore()
    for parent, child in (("odom", "body"), ("body", "odom"), ("body", "head")):
        buffer.set_transform(StampedTransform(parent, child, 0, AHEAD), is_static=True)
    assert [fault.kind for fault in draw_tree(buffer.snapshot()).faults] == ["loop"]
    assert tree_faults(forest(edge("a", "a")))[0].frames == ("a",)
    buffer.lookup_transform("odom", "body", LATEST)
    buffer.lookup_transform("odom", "head", LATEST)
    for target, source in (("head", "odom"), ("head", "body")):
        with pytest.raises(LookupException, match="contains a loop"):
            buffer.lookup_transform(target, source, LATEST)


def test_a_second_publisher_is_named_and_drawn_as_a_doubled_line():
    buffer = BufferCore()
    for stamp_ns, owner in ((seconds(1), "/ekf"), (seconds(2), "/wheels")):
        buffer.set_transform(StampedTransform("odom", "base_link", stamp_ns, AHEAD), owner)
    picture = draw_tree(buffer.snapshot())
    (fault,) = picture.faults
    assert fault.text == "odom -> base_link has 2 publishers: /ekf, /wheels. Lookups land between their values."
    lines = [mark for mark in picture.sheet.marks if isinstance(mark, LineMark)]
    assert len({line.points[1][1] for line in lines if line.points[0][1] == line.points[1][1]}) == 2
    assert "The one heard last counts." in tree_faults(forest(edge("a", "b", ["/1", "/2"], static=True)))[0].text


def test_a_publisher_belongs_to_its_edge_and_a_second_parent_is_named():
    contested = edge("odom", "base_link")._replace(owners=(("map", "/eager"), ("odom", "/wheels")))
    tree = forest(edge("map", "odom"), contested, roots=["map"])
    assert [(row.frame, row.role, row.owners) for row in rows_of(tree)] == [
        ("map", "frame", ()), ("base_link", "also here", ("/eager",)),
        ("odom", "frame", ("/node",)), ("base_link", "frame", ("/wheels",)),
    ]  # fmt: skip
    mount = edge("base_link", "laser", static=True)._replace(owners=(("base_link", "/b"), ("plate", "/a")))
    mounted = forest(edge("base_link", "plate"), mount, roots=["base_link"])
    assert [fault.text for both in (tree, mounted) for fault in tree_faults(both)] == [
        "base_link has 2 parents: map (from /eager), odom (from /wheels). It jumps from one to the other.",
        "laser has 2 parents: base_link (from /b), plate (from /a). The one heard last counts.",
    ]


def test_a_root_whose_last_child_hangs_elsewhere_now_is_no_tree():
    buffer = BufferCore()
    for parent in ("odm", "odom"):
        buffer.set_transform(StampedTransform(parent, "base_link", 0, AHEAD), is_static=True)
    picture = draw_tree(buffer.snapshot())
    assert picture.text.splitlines()[0] == "odm (left over)"
    assert picture.faults == ()
    contested = edge("odom", "base_link")._replace(owners=(("map", "/eager"), ("odom", "/wheels")))
    assert [fault.kind for fault in tree_faults(forest(contested, roots=["map", "odom"]))] == ["parents"]


def test_what_is_odd_about_a_name_shows():
    odd = forest(edge("base_link ", "laser"), edge("base_link", "b\u0430se"), edge("base_link", "바닥"))
    assert [line.split("  ")[0] for line in text_from_tree(odd).splitlines()[:5]] == [
        "base_link", "├─ 'b\\u0430se'", "└─ 바닥", "'base_link '", "└─ laser",
    ]  # fmt: skip
    assert tree_faults(odd)[0].text.startswith("2 separate trees, from base_link, 'base_link '.")


def test_static_and_dynamic_edges_differ_in_line_and_letter_and_the_order_of_arrival_does_not_show():
    picture = draw_tree(ROBOT)
    arrows = [mark.style for mark in picture.sheet.marks if isinstance(mark, LineMark) and mark.arrow]
    assert arrows == ["solid", "solid", "dashed", "dashed"]
    assert re.findall(r">([DS])</text>", picture.svg) == ["D", "D", "S", "S"]
    assert picture.svg == draw_tree(Snapshot(ROBOT.roots, ROBOT.frames[::-1])).svg
    assert picture._repr_mimebundle_() == {"image/svg+xml": picture.svg, "text/plain": picture.text}
    assert str(picture) == picture.text


def test_the_svg_is_well_formed_carries_its_words_and_reaches_for_nothing():
    picture = draw_tree(forest(edge("<&>", 'q"'), roots=["<&>"]))
    tree = ElementTree.fromstring(picture.svg)
    assert tree.find("{http://www.w3.org/2000/svg}desc").text == picture.text
    assert re.findall(r"https?://[^\"]*", picture.svg) == ["http://www.w3.org/2000/svg"]


def test_the_pdf_is_the_same_every_time():
    first, second = draw_tree(ROBOT).pdf(), draw_tree(ROBOT).pdf()
    assert first.startswith(b"%PDF-")
    assert first == second
    assert b"CreationDate" not in first


def room_of(mark):
    """The rectangle a label or a box takes: left, top, right, bottom."""
    if isinstance(mark, BoxMark):
        return (mark.x, mark.y, mark.x + mark.width, mark.y + mark.height)
    width = text_width(mark.text, mark.size)
    left = mark.x - width / 2 if mark.centred else mark.x
    return (left, mark.y - mark.size / 2, left + width, mark.y + mark.size / 2)


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


names = st.lists(st.text("abc_/", min_size=1, max_size=30), min_size=1, max_size=40, unique=True)


@settings(max_examples=40, deadline=None)
@given(names=names, data=st.data())
def test_no_label_touches_another_or_leaves_the_paper(names, data):
    edges = []
    for number, name in enumerate(names[1:], start=1):
        parents = data.draw(st.sets(st.sampled_from(names), min_size=1, max_size=2))
        owners = data.draw(st.sampled_from([["/one"], ["/one", "/another_with_a_long_name"]]))
        edges.append(edge(sorted(parents)[0], name, owners, static=bool(number % 3), parents=sorted(parents)))
    sheet = draw_tree(forest(*edges, roots=names[:1]), now_ns=seconds(3)).sheet
    rooms = [room_of(mark) for mark in sheet.marks if isinstance(mark, TextMark)]
    assert not any(overlap(a, b) for a, b in combinations(rooms, 2))
    assert all(room[0] >= 0 and room[2] <= sheet.width and room[3] <= sheet.height for room in rooms)


@settings(max_examples=60, deadline=None)
@given(names=names, data=st.data())
def test_every_frame_is_drawn_once_whatever_the_parents(names, data):
    edges = [edge(data.draw(st.sampled_from(names)), name) for name in names[1:]]
    rows = rows_of(forest(*edges, roots=names[:1]))
    assert sorted(row.frame for row in rows if row.role in ("frame", "left over")) == sorted(names)


def test_a_long_chain_fits_a_page():
    chain = forest(*(edge(f"frame_{n}", f"frame_{n + 1}") for n in range(40)))
    sheet = draw_tree(chain).sheet
    assert len(rows_of(chain)) == 41
    assert sheet.height < 60 + 34 * 42
    assert sheet.width < 1700
