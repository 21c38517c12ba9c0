"""The four moments of a message."""

from tflab.views.ages import Journey, draw_journeys

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
