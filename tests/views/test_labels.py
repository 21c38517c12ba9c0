"""A name stands beside its thing, and on nothing else."""

import pytest

from tflab.views import style
from tflab.views.labels import FloatingLabel, place_labels


@pytest.fixture(name="ax")
def ax_fixture():
    ax = style.figure((4.0, 4.0)).add_axes((0, 0, 1, 1))
    ax.set(xlim=(0, 400), ylim=(0, 400))  # one unit is one pixel
    return ax


def label_at(ax, x, y, name="name"):
    label = FloatingLabel(ax, name)
    label.anchor = (x, y)
    return label


def way(label):
    """Return the signs of where a name stands: right and up are positive."""
    x, y = label.text.get_position()
    return (int(x > 0) - int(x < 0), int(y > 0) - int(y < 0))


def test_a_name_stands_below_on_the_right_and_keeps_off_lines_and_the_edge(ax):
    line = [((200, 200), (300, 100))]
    for label, others, keep_off, place in (
        (label_at(ax, 200, 200), [], [], (1, -1)),
        (label_at(ax, 200, 200), [], line, (-1, -1)),
        (label_at(ax, 395, 200), [], [], (-1, -1)),
        (label_at(ax, 200, 200), [label_at(ax, 200, 200, name="")], [], (1, -1)),  # no letters take no place
        (label_at(ax, 200, 200), [label_at(ax, 300, 300, name="")], line, (-1, -1)),  # but its lines do
    ):
        (others or [label])[0].keep_off = keep_off
        place_labels([label, *others] if keep_off else [*others, label])
        assert way(label) == place
        assert not label.leader.get_visible()


def test_a_name_keeps_off_the_name_before_it(ax):
    first, second = label_at(ax, 200, 200), label_at(ax, 203, 200)
    place_labels([first, second])
    boxes = [label.text.get_window_extent() for label in (first, second)]
    assert not boxes[0].overlaps(boxes[1])


def test_a_name_that_finds_no_place_near_goes_far_and_gets_a_line(ax):
    label = label_at(ax, 200, 200)
    label.keep_off = [((150, y), (250, y)) for y in range(170, 231, 4)]
    place_labels([label])
    assert label.leader.get_visible()
