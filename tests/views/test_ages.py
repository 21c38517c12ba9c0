"""Curves of how far behind something is."""

from tflab.views.ages import Curve, draw_ages

GROWS = Curve("no limit", (0.0, 1.0, 2.0), (0.1, 0.6, 1.2))
STAYS = Curve("two at most", (0.0, 1.0, 2.0), (0.1, 0.3, 0.2))


def test_ages_in_words():
    assert draw_ages([GROWS, STAYS], "age", limit_s=0.5).text == (
        "age\n"
        "curve            first    largest       last\n"
        "no limit       0.100 s    1.200 s    1.200 s  over the limit: 2 of 3\n"
        "two at most    0.100 s    0.300 s    0.200 s  over the limit: 0 of 3\n"
        "limit 0.500 s"
    )


def test_without_a_limit_nothing_is_over_it():
    picture = draw_ages([GROWS])
    assert "limit:" not in picture.text
    assert len(picture.figure.axes[0].lines) == 1


def test_curves_differ_in_line_and_mark_not_in_colour_alone():
    lines = draw_ages([GROWS, STAYS]).figure.axes[0].lines
    assert len({line.get_marker() for line in lines}) == 2
    assert len({line.get_linestyle() for line in lines}) == 2


def test_the_limit_stands_at_its_height():
    picture = draw_ages([GROWS], limit_s=0.5)
    assert list(picture.figure.axes[0].lines[-1].get_ydata()) == [0.5, 0.5]
    assert [text.get_text() for text in picture.figure.axes[0].texts] == ["limit 0.500 s"]


def test_negative_values_are_in_sight():
    picture = draw_ages([Curve("gap", (0.0, 1.0), (-0.5, -0.1))])
    low, high = picture.figure.axes[0].get_ylim()
    assert low < -0.5 and high > 0.0
