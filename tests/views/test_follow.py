"""What the browser shows of a panel whose pictures are drawn ahead, without a kernel that would hurry it."""

from itertools import pairwise

import pytest

from tflab.views.slider_frames import javascript

pytestmark = pytest.mark.browser

# A model as anywidget gives it, with a slider from 0 to 10 in steps of 0.01, and a box that the kernel ticks
# when the slider has moved; what it sends is kept.
PANEL = """async (source) => {
  class Source {
    constructor(values) { this.values = values; this.heard = {}; }
    get(name) { return this.values[name]; }
    on(events, action) { for (const event of events.split(" ")) (this.heard[event] ??= []).push(action); }
    off() {}
    set(name, value) { this.values[name] = value; this.tell(`change:${name}`); }
    tell(event, ...what) { for (const action of this.heard[event] ?? []) action(...what); }
  }
  const slider = new Source({ min: 0, max: 10, step: 0.01, value: 5, description: "delay" });
  const box = new Source({ value: false, description: "moved" });
  const model = new Source({
    controls: ["IPY_MODEL_slider", "IPY_MODEL_box"], png: new Uint8Array(), description: "at 5",
    at: { places: [5, false], moved: 0 }, width: 76, height: 38,
  });
  model.widget_manager = { get_model: async (name) => ({ slider, box })[name] };
  model.sent = [];
  model.send = (message) => model.sent.push(message);
  const { default: panel } = await import(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
  document.body.innerHTML = "<div id=panel></div>";
  panel.render({ model, el: document.getElementById("panel") });
  await new Promise((done) => setTimeout(done));
  window.move = (value) => slider.set("value", value);
  window.follow = () => { // as ipywidgets does when the kernel says so
    box._state_lock = { value: true };
    box.set("value", true);
    box._state_lock = null;
  };
  window.drawn = (place) => model.tell(
    "msg:custom", { type: "drawn", places: [place, false], moved: 0, words: `at ${place}` }, [new Uint8Array()]);
  window.sent = async () => {
    while (!model.sent.length) await new Promise((done) => setTimeout(done, 10));
    return model.sent.shift();
  };
  window.asked = async () => (await sent()).missing;
  window.seen = async () => {
    await new Promise((done) => setTimeout(done, 20));
    const shown = document.getElementById("panel");
    return [shown.querySelector("img").alt, shown.ariaBusy];
  };
}"""


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
