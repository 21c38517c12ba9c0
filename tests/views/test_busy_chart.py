"""Rows of work and moments."""

from tflab.views.busy_chart import Work, draw_work

S = 1_000_000_000
WAITING = Work("on_scan", ((1 * S, 3 * S),))
STORED = Work("/tf stored", moments_ns=(S // 2, 35 * S // 10))


def test_work_in_words():
    assert draw_work([WAITING, STORED], 0, 4 * S).text == (
        "from 0.000 s to 4.000 s\n"
        f"on_scan    |{' ' * 15}{'#' * 31}{' ' * 14}| busy 2.000 s\n"
        f"/tf stored |{' ' * 7}o{' ' * 44}o{' ' * 7}| 2 moments"
    )


def test_only_what_is_shown_is_counted():
    words = draw_work([WAITING, STORED], 2 * S, 3 * S).text.splitlines()
    assert words[1].endswith("busy 1.000 s")
    assert words[2].endswith("0 moments")


def test_bars_and_marks_stand_at_their_times():
    picture = draw_work([WAITING, STORED], 0, 4 * S)
    bar = picture.figure.axes[0].collections[0].get_paths()[0].get_extents()
    assert (bar.x0, bar.x1) == (1.0, 3.0)
    marks = next(line for line in picture.figure.axes[0].lines if line.get_gid() == "/tf stored")
    assert list(marks.get_xdata()) == [0.5, 3.5]
