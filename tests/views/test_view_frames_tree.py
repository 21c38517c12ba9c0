"""The picture of view_frames: what the service answered, nothing that it does not know, and nothing that overlaps."""

from itertools import combinations

from hypothesis import given, settings
from hypothesis import strategies as st

from tflab.views.sheet import BoxMark, TextMark, text_width
from tflab.views.view_frames_tree import draw_upstream_tree


def child_of(parent, rate=10.2):
    figures = {"buffer_length": 4.9, "most_recent_transform": 5.95, "oldest_transform": 1.05}
    return {"parent": parent, "broadcaster": "default_authority", "rate": rate, **figures}


def words_of(picture):
    return [mark.text for mark in picture.sheet.marks if isinstance(mark, TextMark)]


def test_each_edge_carries_its_five_figures_and_the_legend_its_time():
    picture = draw_upstream_tree({"odom": child_of("map")}, 6.0)
    assert words_of(picture) == [
        "view_frames Result", "Recorded at time: 6.0", "Broadcaster: default_authority", "Average rate: 10.2",
        "Buffer length: 4.9", "Most recent transform: 5.95", "Oldest transform: 1.05", "map", "odom",
    ]  # fmt: skip
    assert picture.text == (
        "view_frames Result, recorded at time: 6.0\n"
        '"map" -> "odom"  Broadcaster: default_authority, Average rate: 10.2, Buffer length: 4.9, '
        "Most recent transform: 5.95, Oldest transform: 1.05"
    )


def test_without_frames_it_says_so():
    assert words_of(draw_upstream_tree({}, 6.0)) == ["No tf data received"]
    assert draw_upstream_tree({}, 6.0).text == "No tf data received"


names = st.lists(st.text("abc_/", min_size=1, max_size=20), min_size=2, max_size=15, unique=True)


@settings(max_examples=60, deadline=None)
@given(names=names, data=st.data())
def test_every_frame_stands_once_and_no_oval_touches_another_or_leaves_the_paper_also_in_loops(names, data):
    frames = {name: child_of(data.draw(st.sampled_from(names))) for name in names[1:]}
    sheet = draw_upstream_tree(frames, 6.0).sheet
    ovals = [mark for mark in sheet.marks if isinstance(mark, BoxMark)][1:]
    assert len(ovals) == len(set(frames) | {frame["parent"] for frame in frames.values()})
    for a, b in combinations(ovals, 2):
        assert a.x + a.width <= b.x or b.x + b.width <= a.x or a.y + a.height <= b.y or b.y + b.height <= a.y
    for mark in sheet.marks:
        if isinstance(mark, TextMark) and not mark.centred:
            assert mark.x >= 0
            assert mark.x + text_width(mark.text, mark.size) <= sheet.width
            assert mark.y <= sheet.height
