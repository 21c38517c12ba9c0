"""The age of data over time, and the steps of a message."""

from tflab.views.ages import Curve, Journey, draw_ages, draw_journeys

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


MS = 1_000_000
GOOD = Journey("scan 1", 1000 * MS, 1020 * MS, 1035 * MS, 1060 * MS)
CLOCKS_APART = Journey("scan 2", 1100 * MS, 1160 * MS, 1128 * MS)


def test_journeys_in_words():
    assert draw_journeys([GOOD, CLOCKS_APART]).text == (
        "message      stamped         sent     received  transformed\n"
        "scan 1       1.000 s     +20.0 ms     +35.0 ms     +60.0 ms\n"
        "scan 2       1.100 s     +60.0 ms     +28.0 ms        never\n"
        "scan 2 was received 32.0 ms before it was sent: two clocks disagree."
    )


def test_age_is_counted_from_the_stamp_to_the_last_step():
    assert GOOD.age_ns == 60 * MS
    assert CLOCKS_APART.age_ns == 28 * MS


def test_each_step_has_its_own_shape_at_its_own_place():
    picture = draw_journeys([GOOD])
    marks = {line.get_gid(): (line.get_marker(), float(line.get_xdata()[0])) for line in picture.figure.axes[0].lines}
    assert marks["scan 1 stamped"] == ("o", 0.0)
    assert marks["scan 1 sent"] == (">", 0.02)
    assert marks["scan 1 received"] == ("s", 0.035)
    assert marks["scan 1 transformed"] == ("D", 0.06)


def test_a_dropped_message_says_so():
    words = [text.get_text() for text in draw_journeys([CLOCKS_APART]).figure.axes[0].texts]
    assert words == ["28 ms, dropped"]
