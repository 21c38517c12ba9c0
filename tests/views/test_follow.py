"""What the browser shows of a panel whose pictures are drawn ahead, without a kernel that would hurry it."""

from itertools import pairwise
from pathlib import Path

import pytest
import yaml

from tflab.views.slider_frames import javascript

pytestmark = pytest.mark.browser

# A model as anywidget gives it, with a slider from 0 to 10 in steps of 0.01, and a box that the kernel ticks
# when the slider has moved; what it sends is kept.
PANEL = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))["panel"]


@pytest.fixture(name="panel")
def panel_fixture(page):
    page.goto("about:blank")
    page.evaluate(PANEL, javascript("near", "follow"))
    return page


def test_the_nearest_drawing_is_shown_until_the_right_one_comes(panel):
    panel.evaluate("[5.3, 5.6].forEach(drawn)")
    panel.evaluate("move(5.5)")
    assert panel.evaluate("seen()") == ["at 5.6", "true"]
    panel.evaluate("drawn(5.49)")
    assert panel.evaluate("seen()") == ["at 5.49", "true"]
    panel.evaluate("drawn(5.5)")
    assert panel.evaluate("seen()") == ["at 5.5", "false"]


def test_a_drawing_from_far_away_is_not_shown_for_another_place(panel):
    panel.evaluate("drawn(5.3)")
    assert panel.evaluate("seen()") == ["at 5", "false"]
    panel.evaluate("move(9)")
    assert panel.evaluate("seen()") == ["at 5", "true"]


def test_neighbours_are_asked_for_first_and_then_some_over_the_whole_rail(panel):
    panel.evaluate("move(5)")
    asked = panel.evaluate("asked()")
    assert sorted(round(place, 2) for place in asked[:12]) == [
        4.94, 4.95, 4.96, 4.97, 4.98, 4.99, 5.01, 5.02, 5.03, 5.04, 5.05, 5.06,
    ]  # fmt: skip
    over_all = sorted(asked[12:60])
    assert over_all[0] < 0.3
    assert over_all[-1] > 9.7
    assert max(b - a for a, b in pairwise(over_all)) < 0.5
    assert len(asked) == len(set(asked)) == 200


def test_drawn_next_is_what_the_hand_moves_and_not_what_follows_it(panel):
    panel.evaluate("(() => { move(6); follow(); })()")  # at once, before anything is sent
    sent = panel.evaluate("sent()")
    assert sent["moved"] == 0
    assert sent["places"] == [6, True]
