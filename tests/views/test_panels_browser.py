"""Panels in a real JupyterLab: they are there, they follow a slider, and the keyboard reaches them."""

import pytest

pytestmark = pytest.mark.browser

SETUP = """
from tflab.core import StampedTransform, Transform, seconds
from tflab.views import motion_error, panels, timeline
"""
LOOKUP = """
def lookup(target, source, stamp_ns):
    return StampedTransform(target, source, stamp_ns, Transform())

lanes = [timeline.Lane("map", "odom", (seconds(1), seconds(2)))]
poses = {"map": Transform(), "odom": Transform((2.0, 1.0, 0.0)), "base_link": Transform((3.0, 1.5, 0.5))}
"""
CELLS = [
    SETUP + LOOKUP,
    "motion_error.draw_latency(motion_error.Sight())",
    "panels.latency_panel()",
    "panels.timeline_panel('map', 'odom', lanes, lookup)",
    "panels.sentence_panel(poses, 'map', 'base_link')",
    "panels.rotation_panel()",
    "panels.cameras_panel()",
]
PANELS = 5
IMAGE = "img.tflab-picture"


def settled(page, image, before):
    """Wait until an image shows another picture than `before`, and return its address."""
    page.wait_for_function(
        "([i, old]) => document.querySelectorAll('img.tflab-picture')[i].src !== old", arg=[image, before]
    )
    return page.locator(IMAGE).nth(image).get_attribute("src")


@pytest.fixture(name="shown")
def shown_fixture(lab, page):
    page.set_viewport_size({"width": 1100, "height": 4000})
    lab.write_notebook("panels.ipynb", CELLS)
    lab.open(page, "panels.ipynb")
    lab.run_all(page)
    page.wait_for_function(f"document.querySelectorAll('{IMAGE}').length === {PANELS}")
    return page


def test_a_panel_without_a_slider_shows_what_its_button_has_changed_and_its_menu_has_its_own_keys(lab, page):
    patient = "from tflab.clinic.panel import clinic_panel\nfrom tflab.clinic.practice import practice_patient"
    lab.write_notebook("clinic.ipynb", [patient, "clinic_panel(practice_patient(7))"])
    lab.open(page, "clinic.ipynb")
    lab.run_all(page)
    page.locator(IMAGE).wait_for()
    before = page.locator(IMAGE).get_attribute("src")
    page.get_by_role("button", name="Ask").click()
    settled(page, 0, before)
    assert page.locator(IMAGE).get_attribute("alt").startswith("2 of 3 suspects left")  # it has looked at RViz again

    # in a notebook's command mode an arrow goes to another cell, and "dd" deletes one
    menu, cells = page.locator(".widget-dropdown select").nth(0), page.locator(".jp-Cell").count()
    page.wait_for_function("document.querySelector('.widget-dropdown select').dataset.lmSuppressShortcuts === 'true'")
    menu.click()
    page.keyboard.press("Escape")
    was = menu.input_value()
    page.keyboard.press("ArrowDown")
    page.wait_for_function("was => document.querySelector('.widget-dropdown select').value !== was", arg=was)
    page.keyboard.type("dd")
    assert page.evaluate("document.activeElement.tagName") == "SELECT"
    assert page.locator(".jp-Cell").count() == cells


def test_panels_follow_mouse_and_keyboard_in_both_themes(lab, shown):
    assert shown.locator(".jupyter-widgets-error-widget").count() == 0
    assert shown.locator(".jp-RenderedImage img").get_attribute("width") == "760"

    # drag the first slider of the latency panel
    before = shown.locator(IMAGE).nth(0).get_attribute("src")
    box = shown.locator(".noUi-handle").nth(0).bounding_box()
    shown.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    shown.mouse.down()
    shown.mouse.move(box["x"] + 80, box["y"] + 5, steps=6)
    settled(shown, 0, before)
    shown.mouse.up()

    # what a hand comes near to is drawn ahead: the same picture, with its own words
    shown.locator(".noUi-handle").nth(1).focus()
    for _ in range(3):
        shown.keyboard.press("ArrowRight")
    shown.wait_for_function("document.querySelector('img.tflab-picture').alt.includes('turns 0.650 rad/s')")

    # move the query of the timeline with the keyboard alone, and read it in words
    before = shown.locator(IMAGE).nth(1).get_attribute("src")
    shown.locator(".noUi-handle").nth(4).focus()
    shown.keyboard.press("End")
    settled(shown, 1, before)
    shown.get_by_role("button", name="as text").nth(1).click()
    shown.locator("pre", has_text="lookup_transform('map', 'odom', 2.167 s)").wait_for()

    # choose the other direction of the sentence
    before = shown.locator(IMAGE).nth(2).get_attribute("src")
    shown.locator(".widget-dropdown select").nth(2).select_option(label="lookup_transform('base_link', 'map', Time())")
    settled(shown, 2, before)
    assert shown.locator(".widget-dropdown select").nth(0).input_value() == "map"

    # a picture is the same card of light paper on a dark page
    lab.set_theme(shown, "JupyterLab Dark")
    assert shown.locator(IMAGE).count() == PANELS
