"""The 3D view in a real JupyterLab and in a real browser, and the same page from a disk."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

pytestmark = pytest.mark.browser

ORANGE, BLUE = (0xD5, 0x5E, 0x00), (0x00, 0x72, 0xB2)

# Where a box stands in the view's width: a metre is 61 pixels of some 850 to 1000.
IN_THE_MIDDLE, AT_1_M, AT_MINUS_1_M = (0.49, 0.51), (0.55, 0.58), (0.42, 0.45)

SETUP, SLIDER, FIND, COUNT_CONTEXTS, ANIMATION, SWEEP, FILM, MENU, PICK, BY_KEYS, CROWD = yaml.safe_load(
    Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8")
).values()

# Where a colour is in the n-th view's canvas: how many pixels, and their middle as a part of its width and height.


def find(page, colour, view: int = 0) -> tuple[int, float, float]:
    """Return how many pixels of a view have a colour, and where their middle is, in parts of its size."""
    return tuple(page.evaluate(FIND, [view, colour]))


def wait_for_rest(page) -> None:
    """Wait until all views are drawn smoothly: without a graphics card, what moves is not."""
    page.wait_for_function("[...tflabViews].every((view) => !view.renderer.isQuick)")


def wait_for_views(page, count: int = 1) -> None:
    page.wait_for_function(f"globalThis.tflabViews?.size >= {count}")
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


def wait_for_colour(page, colour, left: float, right: float, view: int = 0) -> tuple[int, float, float]:
    """Wait until a view shows a colour with its middle between `left` and `right`; return what `find` does."""
    page.locator(".tflab-scene").nth(view).scroll_into_view_if_needed()  # what nobody can see is not drawn
    condition = f"(a) => {{ const [count, x] = ({FIND})(a); return count > 30 && x > {left} && x < {right}; }}"
    page.wait_for_function(condition, arg=[view, colour])
    return find(page, colour, view)


def settled_x(page, colour) -> float:
    """Return where a colour has come to rest in the first view."""
    before, now = -1.0, find(page, colour)[1]
    while before != now:
        page.wait_for_timeout(400)
        before, now = now, find(page, colour)[1]
    return now


def drag(page, box: dict, to_x: float, to_y: float) -> None:
    """Take the middle of `box` with the mouse and pull it to a point."""
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(to_x, to_y, steps=8)
    page.mouse.up()


def test_run_all_shows_the_box_and_dragging_the_slider_moves_it(lab, page):
    lab.write_notebook("slider.ipynb", [SETUP, SLIDER, "scene"])
    lab.open(page, "slider.ipynb")
    lab.run_all(page)
    wait_for_views(page, 2)
    count, _, y = wait_for_colour(page, ORANGE, *IN_THE_MIDDLE)
    # From 5.385 m, 21.8 degrees above, 240 pixels are 3.92 m, and the cube of 0.5 m shows
    # 0.5 (0.5 cos + 0.5 sin) = 0.325 square metres, which is 1217 pixels.
    assert count == pytest.approx(1217, rel=0.1)
    assert y == pytest.approx(0.5, abs=0.05)

    handle = page.locator(".noUi-handle").first.bounding_box()
    drag(page, handle, handle["x"] + 200, handle["y"])
    wait_for_colour(page, ORANGE, 0.55, 0.62)
    moved_x = settled_x(page, ORANGE)
    wait_for_colour(page, ORANGE, moved_x - 0.01, moved_x + 0.01, view=1)

    page.evaluate("jupyterapp.commands.execute('docmanager:save')")
    page.evaluate("jupyterapp.commands.execute('notebook:move-cursor-down')")
    page.reload()  # the kernel lives on, and tells the new page what there is
    wait_for_views(page, 2)
    for view in (0, 1):
        wait_for_colour(page, ORANGE, moved_x - 0.01, moved_x + 0.01, view)


def test_an_object_in_the_place_of_another_is_drawn_with_the_program_that_is_there(lab, page):
    page.add_init_script(
        """window.links = 0;
        const link = WebGL2RenderingContext.prototype.linkProgram;
        WebGL2RenderingContext.prototype.linkProgram = function (...all) { links++; return link.apply(this, all); };"""
    )
    again = """
scene, slider = box_scene(), ipywidgets.IntSlider(0, 0, 9)
def paint(change):
    with scene.redraw():  # one message, so that no picture comes between
        scene.delete()
        colour = 0x0072B2 if change["new"] % 2 else 0xD55E00
        scene["robot/box"].set_object(Box([0.5, 0.5, 0.5]), MeshBasicMaterial(color=colour))
slider.observe(paint, "value")
ipywidgets.VBox([slider, scene])
"""
    lab.write_notebook("again.ipynb", [SETUP, again])
    lab.open(page, "again.ipynb")
    lab.run_all(page)
    wait_for_views(page)
    wait_for_colour(page, ORANGE, *IN_THE_MIDDLE)
    page.locator(".widget-slider [role=slider]").first.focus()
    linked = []
    for colour in (BLUE, ORANGE, BLUE, ORANGE):
        page.keyboard.press("ArrowRight")
        wait_for_colour(page, colour, *IN_THE_MIDDLE)
        wait_for_rest(page)
        linked.append(page.evaluate("links"))
    assert linked == [linked[0]] * 4 and linked[0] > 0  # the first links the program of the quick renderer, too


def test_twenty_views_share_their_webgl_context_and_none_is_lost(lab, page):
    page.add_init_script(COUNT_CONTEXTS)
    twenty = "for i in range(20):\n    display(box_scene(0x0072B2 if i % 2 else 0xD55E00, height_px=60))"
    lab.write_notebook("twenty.ipynb", [SETUP, twenty])
    lab.open(page, "twenty.ipynb")
    lab.run_all(page)
    wait_for_views(page, 20)
    for view in range(20):
        wait_for_colour(page, BLUE if view % 2 else ORANGE, *IN_THE_MIDDLE, view)
    without_card = page.evaluate("tflabQuickRenderer !== null")
    assert page.evaluate("[contexts.size, lost]") == [1 + without_card, 0]

    page.evaluate("void jupyterapp.commands.execute('notebook:clear-all-cell-outputs')")
    page.wait_for_function("globalThis.tflabViews.size === 0")


def test_scenes_start_no_process_and_open_no_port_and_follow_the_dark_theme(lab, page):
    count = """
    import psutil
    def owned():
        me = psutil.Process()
        return len(me.children()), len([c for c in me.net_connections() if c.status == "LISTEN"])
    before = owned()
    """
    lab.write_notebook("clean.ipynb", [SETUP, count, "scene = box_scene()\nscene", "print(owned() == before)"])
    lab.open(page, "clean.ipynb")
    lab.run_all(page)
    wait_for_views(page)
    page.wait_for_selector(".jp-OutputArea-output >> text=True")
    background = "getComputedStyle(document.querySelector('.tflab-scene')).backgroundColor"
    lab.set_theme(page, "JupyterLab Light")  # another test may have left it dark
    page.wait_for_function(f"{background} === 'rgb(255, 255, 255)'")
    lab.set_theme(page, "JupyterLab Dark")
    page.wait_for_function(f"Math.max(...{background}.match(/\\d+/g)) < 40")
    wait_for_colour(page, ORANGE, *IN_THE_MIDDLE)
    lab.set_theme(page, "JupyterLab Light")


@pytest.fixture(scope="module")
def executed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A notebook with a slider, an animation, a sweep and a film, run by nbclient."""
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    cells = [nbformat.v4.new_code_cell(source) for source in (SETUP, SLIDER, ANIMATION, SWEEP, FILM)]
    notebook = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": {"name": "python3", "display_name": "p"}})
    nbclient.NotebookClient(notebook, timeout=60).execute()
    path = tmp_path_factory.mktemp("executed") / "moving.ipynb"
    nbformat.write(notebook, path)
    return path


@pytest.mark.parametrize("single_file", [False, True])
def test_an_exported_page_works_from_the_disk(executed, tmp_path, page, single_file):
    from tflab.views.export import export_html

    exported = export_html(executed, tmp_path, single_file=single_file)
    assert (tmp_path / "assets").exists() != single_file
    page.goto(exported.as_uri())
    wait_for_views(page, 3)
    wait_for_colour(page, ORANGE, *IN_THE_MIDDLE)

    # 3D turns
    wait_for_rest(page)
    picture = "document.querySelector('.tflab-scene canvas').toDataURL()"
    before = page.evaluate(picture)
    pane = page.locator(".tflab-scene-pane").first.bounding_box()
    drag(page, pane, pane["x"] + pane["width"] / 2, pane["y"] + pane["height"] - 5)
    page.wait_for_function(f"(before) => {picture} !== before", arg=before)
    assert find(page, ORANGE)[0] > 0

    # and stays above the floor, by mouse and by key
    first = "[...tflabViews].find(({ pane }) => pane === document.querySelector('.tflab-scene-pane')).viewer"
    above = f"(({{ camera, controls }}) => camera.position.y - controls.target.y)({first})"
    for _ in range(3):
        drag(page, pane, pane["x"] + pane["width"] / 2, pane["y"] + 5)
    for _ in range(12):
        page.keyboard.press("ArrowDown")
    assert abs(page.evaluate(above)) < 1e-6

    # by key it moves, too
    beside = f"(({{ controls }}) => controls.target.x)({first})"
    before = page.evaluate(beside)
    page.keyboard.press("Shift+ArrowRight")
    assert page.evaluate(beside) > before

    # each scrubber moves its own box
    wait_for_colour(page, BLUE, *AT_MINUS_1_M, view=1)
    sliders = page.locator(".tflab-scrubber input")
    sliders.nth(0).fill("1")
    wait_for_colour(page, BLUE, *AT_1_M, view=1)
    wait_for_colour(page, ORANGE, *IN_THE_MIDDLE, view=2)
    sliders.nth(1).fill("2")
    wait_for_colour(page, ORANGE, *AT_1_M, view=2)
    assert page.locator(".tflab-film img").get_attribute("alt") == "it stands"
    sliders.nth(2).fill("1")
    assert page.locator(".tflab-film img").get_attribute("alt") == "it moves"
    assert page.locator(".tflab-scrubber output").all_inner_texts() == ["1.00 s", "x = 1.00 m", "speed: 1"]

    # nothing is left that does nothing
    controls = page.locator("input, button, select, textarea")
    assert controls.count() == page.locator(".tflab-scrubber :is(input, button)").count() == 6
    assert page.locator(".tflab-value").all_inner_texts() == ["x: 0.00", "map"]


def test_a_click_picks_a_frame_and_the_arrow_keys_move_a_sweep(lab, page):
    lab.write_notebook("pick.ipynb", [SETUP, PICK, BY_KEYS])
    lab.open(page, "pick.ipynb")
    lab.run_all(page)
    wait_for_views(page, 2)
    pane = page.locator(".tflab-scene-pane").first.bounding_box()
    page.mouse.click(pane["x"] + pane["width"] / 2, pane["y"] + pane["height"] / 2)
    page.wait_for_function("document.body.innerText.includes('picked: base_link')")
    assert "base_link  frame" in page.locator(".tflab-scene-pane").first.get_attribute("aria-label")

    scrubber = page.get_by_role("slider", name="x")
    scrubber.focus()
    for key in ("ArrowRight", "ArrowRight", "ArrowLeft"):
        page.keyboard.press(key)
    page.wait_for_function("document.querySelector('.tflab-scrubber output').innerText === 'x = 1.00'")
    assert scrubber.get_attribute("aria-valuetext") == "x = 1.00"
    page.keyboard.press("Escape")
    page.wait_for_function("document.activeElement.matches('.jp-Cell')")


def test_what_is_chosen_from_a_menu_is_seen_before_the_kernel_has_drawn_it(lab, page):
    lab.write_notebook("menu.ipynb", [SETUP, MENU])
    lab.open(page, "menu.ipynb")
    lab.run_all(page)
    wait_for_views(page)
    wait_for_colour(page, ORANGE, *IN_THE_MIDDLE)
    menu, labels = page.locator(".widget-dropdown select"), page.locator(".widget-label:text-matches('^[-.0-9]+$')")
    menu.focus()  # a hand is near: all choices are drawn
    page.wait_for_function("[...document.querySelectorAll('.widget-label')].some((label) => label.innerText === '2')")
    for option, place in (("left", AT_MINUS_1_M), ("right", AT_1_M)):
        menu.select_option(option)
        wait_for_colour(page, ORANGE, *place)
        assert labels.last.inner_text() == "-"  # the kernel sleeps
    # the kernel draws the first choice, which is no longer the one, and then the last
    first = "[...document.querySelectorAll('.widget-label')].some((label) => label.innerText === '-1.0')"
    for condition in (first, f"!{first}"):
        page.wait_for_function(condition)
        wait_for_colour(page, ORANGE, *AT_1_M)


WRITTEN = "[...globalThis.tflabViews][0].names.map((name) => name.frame).sort().join(' ')"


def test_labels_are_grouped_when_zoomed_out_and_a_narrow_picture_shows_what_a_wide_one_shows(lab, page) -> None:
    lab.write_notebook(
        "crowd.ipynb", [SETUP, CROWD, "scene = box_scene()\nscene['robot/box'].set_transform(at(1.6))\nscene"]
    )
    lab.open(page, "crowd.ipynb")
    lab.run_all(page)
    wait_for_views(page, 2)
    page.wait_for_function(f"{WRITTEN} === 'base_link map'")
    page.evaluate("[...globalThis.tflabViews][0].look([9.4, -0.5, 0.5], [9, 0.12, 0.1])")
    everybody = " ".join(["base_link", *(f"part_{i}" for i in range(6))])
    page.wait_for_function(f"{WRITTEN}.replace('map ', '') === '{everybody}'")
    wait_for_colour(page, ORANGE, 0.5, 1.0, view=1)
    page.set_viewport_size({"width": 390, "height": 800})
    page.wait_for_timeout(500)
    wait_for_colour(page, ORANGE, 0.5, 0.95, view=1)
