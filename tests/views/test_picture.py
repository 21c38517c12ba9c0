"""A picture gives the same bytes each time, and stays small."""

import matplotlib
import numpy as np
import pytest
from matplotlib.text import Text

from tflab.core import ExtrapolationException, Transform
from tflab.views import (
    ages,
    axes,
    coordinates,
    frames,
    map_error,
    motion_error,
    rotations,
    sentence,
    style,
    timeline,
    tree_path,
)
from tflab.views.late_joiner import Sender, SentMessage, draw_joins
from tflab.views.moved_frames import draw_moves
from tflab.views.number_table import NumberTable
from tflab.views.picture import Picture
from tflab.views.transform_chain import Step, draw_joints

POSES = {"map": Transform(), "base_link": Transform.from_rpy(yaw=0.5, translation=(2.0, 1.0, 0.0))}


def lookup(target, source, stamp_ns):
    return sentence.StampedTransform(target, source, stamp_ns, Transform((1.0, 2.0, 3.0)))


def refuse(target, source, stamp_ns):
    raise ExtrapolationException(
        "Lookup would require extrapolation into the future.  Requested time 1700000010.000000 but the latest data is "
        f"at time 1700000002.000000, when looking up transform from frame [{source}] to frame [{target}]"
    )


def one_lane(parent, child, stamps_ns, asked_ns, ask=lookup, **more):
    return timeline.draw_timeline(parent, child, [timeline.Lane(parent, child, stamps_ns, **more)], ask, asked_ns)


PICTURES = {
    "scene": lambda: frames.draw_scene(POSES, points={"corner": (3.0, 0.0, 0.0)}),
    "body axes": axes.draw_body_axes,
    "right hand": axes.draw_right_hand,
    "rotation": lambda: axes.draw_rotation(0.1, 0.2, 0.3),
    "cameras": axes.draw_cameras,
    "sentence": lambda: sentence.draw_sentence(POSES, lookup("map", "base_link", 0)),
    "timeline": lambda: one_lane("map", "odom", (10**9, 2 * 10**9), 1_500_000_000),
    "long names": lambda: sentence.draw_sentence(
        {"base_footprint": Transform(), "camera_optical_frame": Transform((1.0, 0.4, 0.5))},
        lookup("camera_optical_frame", "base_footprint", 0),
    ),
    "long lanes": lambda: one_lane("camera_link", "camera_optical_frame", (), 0, is_static=True),
    "refusal": lambda: one_lane("base_footprint", "camera_optical_frame", (10**9, 2 * 10**9), 10**10, refuse),
    "stamps since 1970": lambda: one_lane("map", "odom", (SINCE_1970, SINCE_1970 + 3 * 10**9), SINCE_1970 + 2 * 10**9),
    "journeys": lambda: ages.draw_journeys([ages.Journey("scan", 0, 10_000_000, 20_000_000)]),
    "latency": lambda: motion_error.draw_latency(motion_error.Sight()),
}


SINCE_1970 = 1_700_000_000_250_000_000
PARENTS = {"odom": "map", "base": "odom", "laser": "base"}
SENDER = Sender("driver", (SentMessage(1.0, ("laser_frame",)),))
ARM = [
    Step("neck", "base", "arm", Transform((0.0, 0.0, 1.0)), 0.3),
    Step("weld", "arm", "tool", Transform((2.0, 0, 0))),
]
LINE = np.linspace((0.0, 0.0), (4.0, 1.0), 5)
DRAWINGS = {
    "card": axes.draw_card,
    "tree path": lambda: tree_path.draw_walk(tree_path.snapshot_of_parents(PARENTS), "map", "laser"),
    "late joiner": lambda: draw_joins([SENDER], 2.5, 6.0),
    "arm": lambda: draw_joints(ARM, "neck", {"wrong": (1.0, 1.0, 1.0)}),
    "rulers": lambda: coordinates.draw_rulers(POSES, (3.0, 1.0, 0.0)),
    "two times": lambda: coordinates.draw_moments(POSES, (3.0, 1.0, 0.0)),
    "tracks": lambda: map_error.draw_tracks({"odom": LINE}, LINE + 0.1, range(5)),
    "moves": lambda: draw_moves({"base_link": (POSES["base_link"], Transform())}, "odom", ["base_link"], LINE),
    "many points": lambda: map_error.draw_placed(
        {"here": np.random.default_rng(1).normal(size=(5000, 3))}, walls=[((0.0, 0.0), (4.0, 0.0))]
    ),
    "detections": lambda: map_error.draw_detections(LINE[3:], LINE[4], path=LINE[:3], how="as measured"),
    "orders": lambda: rotations.draw_orders(("roll", 1.5), ("yaw", 1.5)),
    "drives": lambda: rotations.draw_drives({"left": 0.4, "right": -0.4}),
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_a_drawing_is_small_and_has_the_same_bytes_every_time(name):
    first, again = (DRAWINGS[name]().png() for _ in range(2))
    assert first == again and len(first) < 60_000


@pytest.fixture(scope="module", params=PICTURES, name="drawn")
def drawn_fixture(request):
    """A picture, drawn once, with its bytes; tests only look at it."""
    from matplotlib import pyplot

    picture = PICTURES[request.param]()
    png = picture.png()
    assert pyplot.get_fignums() == []  # pyplot knows nothing of it, so nobody needs to close it
    return request.param, picture, png


def test_a_second_drawing_gives_the_same_small_png_whatever_the_learners_settings_and_its_words(drawn):
    name, _, png = drawn
    assert png.startswith(b"\x89PNG") and len(png) <= 60_000
    with matplotlib.rc_context({"font.size": 20, "axes.grid": True, "text.color": "red", "axes.facecolor": "black"}):
        picture = PICTURES[name]()
        data, metadata = picture._repr_mimebundle_()
    width, height = picture.figure.get_size_inches()
    assert data == {"image/png": png, "text/plain": picture.text}
    assert picture.text == repr(picture) != ""
    assert metadata["image/png"] == {"width": round(width * 100), "height": round(height * 100)}


def test_every_word_is_on_the_card_and_covers_no_other(drawn):
    _, picture, _ = drawn
    card, texts = picture.figure.bbox, list(visible_texts(picture.figure))
    boxes = [text.get_window_extent() for text in texts]
    for i, (text, box) in enumerate(zip(texts, boxes, strict=True)):
        assert card.x0 <= box.x0 and box.x1 <= card.x1 and card.y0 <= box.y0 and box.y1 <= card.y1, text
        for other in boxes[:i]:
            assert box.x1 <= other.x0 or other.x1 <= box.x0 or box.y1 <= other.y0 or other.y1 <= box.y0


def test_a_live_picture_shows_what_moved_and_what_stands_still():
    picture = Picture((2.0, 1.0))
    (still,) = picture.figure.add_axes((0, 0, 1, 1)).plot([0.25], [0.5], "o", color="black")
    ax = still.axes
    (moving,) = ax.plot([0.5], [0.5], "o", color="black")
    ax.set(xlim=(0, 1), ylim=(0, 1))
    picture.moving = [moving]
    assert dark(picture) == (True, True, False)
    moving.set_data([0.75], [0.5])
    assert dark(picture) == (True, False, True)
    still.set_visible(False)
    assert dark(picture) == (True, False, True)  # drawn once for all live pictures ...
    picture.redraw_all()
    assert dark(picture) == (False, False, True)  # ... until told


def dark(picture):
    """Return whether the live picture is black at a quarter, a half and three quarters of its width."""
    picture.live_png()
    pixels = np.asarray(picture.figure.canvas.buffer_rgba())
    row = pixels[pixels.shape[0] // 2]
    return tuple(bool(row[round(part * style.LIVE_DPI * 2), 0] < 60) for part in (0.25, 0.5, 0.75))


def visible_texts(figure):
    """Yield everything with letters that can be seen."""
    yield from (block for block in figure.findobj(NumberTable) if block.text)
    for text in figure.findobj(Text):
        on_axis_off = text.axes is not None and not text.axes.axison and text not in text.axes.texts
        if text.get_visible() and text.get_text().strip() and not on_axis_off:
            yield text
