"""How long from a slider to the drawn frame?  Our widget against meshcat's own iframe, in one run.

    python benchmarks/scene.py [rounds]

A real JupyterLab shows one notebook with two sliders.  Each moves the same box: one
in a `Scene`, one in meshcat's own iframe, which has a server and a socket of its own.
The mouse drags the two sliders in turn, step by step, so that both meet the same
machine.  For each step the page itself takes the time from the mouse's event to the
animation frame after the one in which that view was drawn.

Printed: median and 95th percentile of both [ms], and the ratio of the medians.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))

from conftest import CHROMIUM_ARGUMENTS, PATIENCE_S, find_chromium, running_lab  # noqa: E402

STEPS = 12
GOAL = 1.4

OURS = """
import ipywidgets, meshcat
from meshcat.geometry import Box
from meshcat.transformations import translation_matrix
from tflab.views.scene import Scene

def slider_for(place):
    slider = ipywidgets.FloatSlider(min=-1.0, max=1.0, step=0.01)
    slider.observe(lambda change: place.set_transform(translation_matrix([change["new"], 0.0, 0.0])), "value")
    return slider

scene = Scene(height_px=250)
scene["robot"].set_object(Box([0.5, 0.5, 0.5]))
ipywidgets.VBox([slider_for(scene["robot"]), scene])
"""
STOCK = """
stock = meshcat.Visualizer()
stock["robot"].set_object(Box([0.5, 0.5, 0.5]))
display(slider_for(stock["robot"]))
stock.jupyter_cell(height=250)
"""

# Note when a view was drawn: ours is in the page, the stock one in the iframe's `viewer`.
WATCH = """() => {
  const note = (viewer) => {
    const render = viewer.render.bind(viewer);
    viewer.render = () => {
      render();
      viewer.drawn = (viewer.drawn ?? 0) + 1;
    };
  };
  window.watched = [[...tflabViews][0].viewer, document.querySelector("iframe").contentWindow.viewer];
  watched.forEach(note);
}"""
# The time from the next mouse move to the frame after the view has been drawn again.
NEXT_FRAME = """(which) => {
  window.latency = new Promise((done) => {
    addEventListener("pointermove", () => {
      const began = performance.now(), before = watched[which].drawn ?? 0;
      const check = () => {
        if ((watched[which].drawn ?? 0) > before) requestAnimationFrame(() => done(performance.now() - began));
        else if (performance.now() - began > 2000) done(-1);
        else requestAnimationFrame(check);
      };
      requestAnimationFrame(check);
    }, { once: true, capture: true });
  });
}"""


def main(rounds: int) -> None:
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as home, running_lab(Path(home)) as lab, sync_playwright() as driver:
        lab.write_notebook("latency.ipynb", [OURS, STOCK])
        browser = driver.chromium.launch(
            executable_path=find_chromium(driver),
            args=[*CHROMIUM_ARGUMENTS, "--disable-web-security"],  # to look into the iframe
            ignore_default_args=["--headless", "--headless=old"],
        )
        page = browser.new_page(viewport={"width": 1100, "height": 1400})
        page.set_default_timeout(PATIENCE_S * 1000)
        lab.open(page, "latency.ipynb")
        lab.run_all(page)
        page.wait_for_function(
            "globalThis.tflabViews?.size && document.querySelector('iframe')?.contentWindow.viewer", timeout=30_000
        )
        page.evaluate(WATCH)
        ours, stock = measured(page, rounds)
        browser.close()
    report(ours, stock)


def measured(page, rounds: int) -> tuple[list[float], list[float]]:
    """Return the times of both [ms], taken in turn."""
    times: tuple[list[float], list[float]] = ([], [])
    for _ in range(rounds):
        for which in (0, 1):
            handle = page.locator(".noUi-handle").nth(which).bounding_box()
            x, y = handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2
            toward = 1 if _middle(page, which) > x else -1
            page.mouse.move(x, y)
            page.mouse.down()
            for step in range(1, STEPS + 1):
                page.evaluate(NEXT_FRAME, which)
                page.mouse.move(x + toward * 6 * step, y)
                took = page.evaluate("latency")
                if took > 0:
                    times[which].append(took)
                page.wait_for_timeout(60)
            page.mouse.up()
    return times


def _middle(page, which: int) -> float:
    rail = page.locator(".noUi-target").nth(which).bounding_box()
    return rail["x"] + rail["width"] / 2


def report(ours: list[float], stock: list[float]) -> None:
    for name, times in (("tflab scene", ours), ("meshcat iframe", stock)):
        worst = statistics.quantiles(times, n=20)[-1]
        print(f"{name:<15} median {statistics.median(times):6.1f} ms   p95 {worst:6.1f} ms   n = {len(times)}")
    ratio = statistics.median(ours) / statistics.median(stock)
    print(f"ratio of medians {ratio:.2f}   (goal: at most {GOAL})")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
