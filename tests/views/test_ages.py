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


def test_curves_differ_in_line_and_mark_the_limit_has_its_height_and_negative_values_are_in_sight():
    below = Curve("gap", (0.0, 1.0), (-0.5, -0.1))
    (ax,) = draw_ages([GROWS, below], limit_s=0.5).figure.axes
    *lines, limit = ax.lines
    assert len({line.get_marker() for line in lines}) == len({line.get_linestyle() for line in lines}) == 2
    assert list(limit.get_ydata()) == [0.5, 0.5]
    assert [text.get_text() for text in ax.texts] == ["limit 0.500 s"]
    assert ax.get_ylim()[0] < -0.5
    without = draw_ages([GROWS])
    assert "limit:" not in without.text and len(without.figure.axes[0].lines) == 1


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


def test_each_step_has_its_own_shape_at_its_own_place():
    picture = draw_journeys([GOOD])
    marks = {line.get_gid(): (line.get_marker(), float(line.get_xdata()[0])) for line in picture.figure.axes[0].lines}
    steps = {"stamped": ("o", 0.0), "sent": (">", 0.02), "received": ("s", 0.035), "transformed": ("D", 0.06)}
    assert marks | {f"scan 1 {name}": mark for name, mark in steps.items()} == marks
    assert (GOOD.age_ns, CLOCKS_APART.age_ns) == (60 * MS, 28 * MS)  # from the stamp to the last step
    named = draw_journeys([CLOCKS_APART], {"sent": "robot's clock", "received": "desktop's clock"}).figure
    assert [text.get_text() for text in named.axes[0].texts] == ["28 ms, dropped"]
    key = [text.get_text() for text in named.legends[0].get_texts()]
    assert key == ["sent (robot's clock)", "received (desktop's clock)"]
