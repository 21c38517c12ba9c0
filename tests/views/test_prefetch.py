"""What comes next is drawn before it is asked for, and is the same picture as if it had been asked for."""

from __future__ import annotations

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor

import ipywidgets as widgets
from matplotlib import rcParams

from tflab.core import StampedTransform, Transform, seconds
from tflab.views.panels import cameras_panel, sentence_panel, timeline_panel
from tflab.views.panels.prefetch import KEPT, Controls, Drawing, DrawnAhead
from tflab.views.style import our_settings
from tflab.views.timeline import Lane

POSES = {name: Transform((x, 0.0, 0.0)) for name, x in (("map", 0.0), ("base_link", 1.0), ("laser_frame", 2.0))}


def drawn_ahead(*controls):
    """A picture whose PNG says where the controls are, and what has been drawn of it."""
    drawn = []

    def draw(at: Controls) -> Drawing:
        drawn.append([at(control) for control in controls])
        return Drawing(repr(drawn[-1]).encode(), f"moved {at.moved.description}")

    return DrawnAhead(controls, (760, 380), draw), drawn


def sent_for(picture: DrawnAhead, *messages: dict) -> list[dict]:
    """Return what goes to the browser, each with its PNG, when it sends these messages one after the other."""
    sent: list[dict] = []
    picture.send = lambda content, buffers: sent.append({**content, "png": buffers[0]})

    async def hear() -> None:
        for message in messages:
            picture._handle_custom_msg(message, [])
        while picture._is_at_work:
            await asyncio.sleep(0)

    with ThreadPoolExecutor(1) as elsewhere:  # a browser's test before this one may have left a loop running here
        elsewhere.submit(asyncio.run, hear()).result()
    return sent


def test_what_the_browser_wants_is_drawn_in_its_order_and_the_controls_stay_where_they_are():
    speed, delay = widgets.FloatSlider(1.0, description="speed"), widgets.FloatSlider(2.0, description="delay")
    picture, _ = drawn_ahead(speed, delay)
    sent = sent_for(picture, {"type": "want", "places": [1, 2], "moved": 1, "missing": [2.5, 1.5]})
    assert [(each["places"], each["png"], each["words"]) for each in sent] == [
        ([1, 2.5], b"[1.0, 2.5]", "moved delay"),
        ([1, 1.5], b"[1.0, 1.5]", "moved delay"),
    ]
    assert (speed.value, delay.value) == (1.0, 2.0)


def test_what_is_wanted_now_takes_the_place_of_what_was_wanted_before():
    speed = widgets.FloatSlider(1.0, description="speed")
    picture, drawn = drawn_ahead(speed)
    first = {"type": "want", "places": [1.0], "moved": 0, "missing": [2.0, 3.0]}
    sent = sent_for(picture, first, {"type": "want", "places": [7.0], "moved": 0, "missing": [8.0]})
    assert [each["places"] for each in sent] == [[8.0]]
    assert drawn == [[8.0]]


def test_a_place_that_was_drawn_ahead_is_not_drawn_again_when_the_slider_comes_there():
    speed = widgets.FloatSlider(1.0, max=3.0, description="speed")
    picture, drawn = drawn_ahead(speed)
    sent_for(picture, {"type": "want", "places": [1.0], "moved": 0, "missing": [1.3000000000000003]})
    speed.value = 1.3
    assert picture.show(speed).png == b"[1.3000000000000003]"
    assert len(drawn) == 1
    assert picture.at == {"places": [1.3], "moved": 0}
    before = picture.anew
    picture.show(anew=True)
    assert picture.anew == before + 1  # nothing else tells a browser of it where no control has moved


def test_nothing_from_before_is_used_when_drawn_anew_and_no_more_is_kept_than_fits():
    speed = widgets.FloatSlider(0.0, max=1e6, description="speed")
    picture, drawn = drawn_ahead(speed)
    for anew, count in ((False, 1), (False, 1), (True, 2)):
        picture.show(anew=anew)
        assert len(drawn) == count
    drawn.clear()
    for place in range(1, KEPT + 2):
        picture.drawing([place], 0)
    picture.drawing([KEPT + 1], 0)
    assert len(drawn) == KEPT + 1
    picture.drawing([1], 0)  # the oldest went
    assert len(drawn) == KEPT + 2


def test_two_threads_that_draw_get_each_its_own_picture():
    """JupyterLab hears of a slider in one thread, while another draws ahead."""
    slider, figure = widgets.FloatSlider(0.0, max=100.0, description="speed"), []

    def draw(at: Controls) -> Drawing:
        figure[:] = [at(slider)]
        time.sleep(0.001)  # drawing takes a while, and lets others have their turn
        return Drawing(b"", str(figure[0]))

    picture = DrawnAhead([slider], (760, 380), draw)
    with ThreadPoolExecutor(2) as threads:
        drawings = list(threads.map(lambda place: picture.drawing([place], 0), map(float, range(40))))
    assert [drawing.words for drawing in drawings] == [str(float(place)) for place in range(40)]


def test_matplotlibs_settings_are_held_for_one_thread():
    def seen(number: int) -> float:
        with our_settings():
            time.sleep(0.002 * (number % 3))
            return rcParams["axes.ymargin"]

    before = rcParams["axes.ymargin"]
    with ThreadPoolExecutor(4) as threads:
        assert set(threads.map(seen, range(40))) == {0.0}
    assert rcParams["axes.ymargin"] == before != 0.0


def test_a_sentence_drawn_ahead_is_the_one_that_the_menu_leads_to():
    panel = sentence_panel(POSES, "map", "laser_frame")
    places = [control.index for control in panel.controls.values()]
    python = panel.controls["Python"]
    wanted = next(i for i, (_, pair) in enumerate(python.options) if pair == ("base_link", "map"))
    words = panel.shown.drawing([*places[:2], wanted, *places[3:]], 2).words
    assert words.startswith("data expressed in [map], wanted in [base_link]")
    python.index = wanted
    assert panel.text == words


def test_a_panel_drawn_ahead_is_the_panel_moved_there_and_leaves_its_slider_usable():
    def ask(target: str, source: str, stamp_ns: int) -> StampedTransform:
        return StampedTransform(target, source, stamp_ns, Transform())

    panel, ahead = cameras_panel(), cameras_panel()
    panel.controls["left [m]"].value = 0.5
    assert ahead.shown.drawing([2.0, 0.5, 0.0], 1) == Drawing(panel.shown.png, panel.text)
    panel = timeline_panel("map", "odom", [Lane("map", "odom", (seconds(1), seconds(3)))], ask)
    query = panel.controls["query [s]"]
    assert "LATEST" in panel.shown.drawing([query.value, True], 1).words
    assert not query.disabled
