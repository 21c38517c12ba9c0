"""A block of numbers is where it should be, as large as matplotlib's own text."""

import pytest

from tflab.views import style
from tflab.views.number_table import NumberTable


@pytest.fixture(name="figure")
def figure_fixture():
    return style.figure((6.0, 3.0))


def test_a_block_hangs_from_its_upper_left_corner_at_any_resolution(figure):
    block = NumberTable(figure, 0.1, 0.8)
    block.write("MMM\nMMM")
    for dpi in (100, 150):
        figure.set_dpi(dpi)
        box = block.get_window_extent()
        assert box.x0 == pytest.approx(0.1 * 6.0 * dpi, abs=2)
        assert 0.8 * 3.0 * dpi - 0.5 * style.TEXT_PT / 72 * dpi < box.y1 < 0.8 * 3.0 * dpi


def test_letters_are_as_wide_as_in_matplotlibs_text(figure):
    words = "lookup_transform('map', 'odom', Time())"
    block = NumberTable(figure, 0.1, 0.8)
    block.write(words)
    with style.our_settings():
        text = figure.text(0.1, 0.5, words, family="monospace", fontsize=style.TEXT_PT)
        figure.canvas.draw()
        assert block.get_window_extent().width == pytest.approx(
            text.get_window_extent().width, rel=0.02
        )  # less than a letter: older matplotlib rounds each one to pixels


def test_writing_again_replaces_what_was_there(figure):
    block = NumberTable(figure, 0.1, 0.8)
    block.write("a long line of words")
    wide = block.get_window_extent().width
    block.write("a")
    assert block.text == "a"
    assert block.get_window_extent().width < wide / 10
