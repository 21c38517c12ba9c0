"""How long from a slider to the picture?  Every panel of the course, in its page, in a real JupyterLab.

    python benchmarks/panels.py              all pages
    python benchmarks/panels.py 02 08        these
    python benchmarks/panels.py --steps 12   more of each control

A learner's copy is laid out and each page run from its start to its end.  Then every
control of every panel, of every scene and of every player is moved by the keyboard,
and every slider by the mouse too; of a menu, another option is chosen.  For each step
the page itself takes the time from the event to the animation frame that shows the
changed picture.  A panel may show a drawing of a place nearby until the right one has
come (it is `aria-busy` then): *exact* is the time until that.

After each panel stands an *echo*: a slider whose observer sets a label, which is the
least that a kernel can do.  Its steps are taken in turn with the panel's, and for each
the page also notes when its next *frame* came, which is the least that a browser can
do.  The two are the machine's and JupyterLab's share of the time beside them.

The browser puts its page together on the processor.  Where there is no graphics card it
would have one imitated for that: 80 ms a frame, which no reader's machine takes.  What is
drawn in 3D is drawn by the imitation all the same.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import nbformat

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))

from conftest import CHROMIUM_ARGUMENTS, PATIENCE_S, Lab, find_chromium, running_lab  # noqa: E402
from tflab.workbook.copy.lay_out import lay_out  # noqa: E402

GOAL_MS = 50.0
STEP_PX = 7
PAUSE_MS = 80  # between two steps: somebody looks
HAND_MS = 400  # from the hand's coming to a control until it moves it
MENU = "select-one"
ECHO = "echo-of-"  # before a panel's name
BROWSER = [*CHROMIUM_ARGUMENTS, "--disable-gpu-compositing"]

ECHO_CELL = """
import ipywidgets
_echo = ipywidgets.FloatSlider(min=-1.0, max=1.0, step=0.01), ipywidgets.Label("0")
_echo[1].add_class("echo")
_echo[0].observe(lambda change, label=_echo[1]: setattr(label, "value", str(change["new"])), "value")
ipywidgets.HBox(_echo)
"""
FIND = """() => {
  window.cellNamed = (name) => {
    const { content } = jupyterapp.shell.currentWidget;
    return content.widgets.find((cell) => cell.model.getMetadata("name") === name);
  };
  const drawImage = CanvasRenderingContext2D.prototype.drawImage;
  CanvasRenderingContext2D.prototype.drawImage = function (...what) {
    drawImage.apply(this, what);
    this.canvas.dispatchEvent(new Event("drawn", { bubbles: true }));
  };
}"""
HAVE_RUN = """() => jupyterapp.shell.currentWidget.content.widgets.every(
  ({ model }) => model.type !== "code" || model.executionCount !== null || !model.sharedModel.getSource().trim()
) && jupyterapp.shell.currentWidget.sessionContext.session.kernel.status === "idle" """
SHOW = """(name) => {
  const { content } = jupyterapp.shell.currentWidget;
  return content.scrollToItem(content.widgets.indexOf(cellNamed(name)), "start");
}"""
# What can be moved in a cell's output, in the order of the page.
CONTROLS = """(name) => {
  const found = [...cellNamed(name).outputArea.node.querySelectorAll(
    ".noUi-handle, input[type=range], select, input[type=checkbox]")];
  found.forEach((control, place) => control.setAttribute("data-control", `${name}-${place}`));
  return found.map((control) => control.matches(".noUi-handle") ? "slider" : control.type ?? control.localName);
}"""
# The time from the next event to the frame that shows what came of it [ms]; -1 if nothing changed.
NEXT_PICTURE = """([name, kind]) => {
  const root = cellNamed(name).outputArea.node;
  window.frame = window.exact = -1;
  window.latency = new Promise((done) => {
    addEventListener(kind, ({ timeStamp }) => {
      requestAnimationFrame(() => { window.frame = performance.now() - timeStamp; });
      const shown = () => requestAnimationFrame(() => finish(performance.now() - timeStamp));
      const watch = new MutationObserver((changes) => {
        for (const { target, addedNodes } of changes) {
          const element = target.nodeType === Node.TEXT_NODE ? target.parentElement : target;
          const image = [...addedNodes].find((node) => node.matches?.("img"));
          if (image) image.decode().then(shown, () => {});
          else if (element?.closest(".echo, .tflab-picture")) shown();
        }
      });
      let first = -1;
      const finish = (took) => {
        if (first < 0) first = took;
        if (took > 0 && root.querySelector("[aria-busy=true]")) return;
        window.exact = took;
        watch.disconnect();
        root.removeEventListener("drawn", shown);
        done(first);
      };
      watch.observe(root, { subtree: true, childList: true, characterData: true, attributes: true });
      root.addEventListener("drawn", shown);
      setTimeout(() => finish(-1), 1500);
    }, { once: true, capture: true });
  });
}"""


class Step(NamedTuple):
    """What one step took [ms]: to the first picture, to the right one, to the browser's next frame."""

    picture: float
    exact: float
    frame: float


class Row(NamedTuple):
    """The steps of one panel: by the keyboard or from a menu, by the mouse, and of the echo beside it."""

    page: str
    name: str
    keys: list[Step]
    mouse: list[Step]
    echo: list[Step]

    def columns(self) -> list[list[float]]:
        """Return the times of each column."""
        exact = [step.exact for step in (*self.keys, *self.mouse) if step.exact > 0]
        pictures = [[step.picture for step in steps] for steps in (self.keys, self.mouse, self.echo)]
        return [*pictures[:2], exact, pictures[2], [step.frame for step in self.echo]]


def main(chapters: Sequence[str], steps: int) -> None:
    """Print a line for each panel."""
    from playwright.sync_api import sync_playwright

    head = "".join(f"{name:>16}" for name in ("keys", "mouse", "exact", "echo", "frame"))
    print(f"{'page':<5} {'panel':<22}{head}   median (95 %) [ms], goal {GOAL_MS:.0f}")
    with tempfile.TemporaryDirectory() as home, running_lab(Path(home)) as lab, sync_playwright() as driver:
        copy = lay_out(lab.folder / "copy", "en")
        browser = driver.chromium.launch(
            executable_path=find_chromium(driver),
            args=BROWSER,
            ignore_default_args=["--headless", "--headless=old"],
        )
        rows = []
        for path in sorted((copy / "notebooks" / "en").glob("[01]*.ipynb")):
            if not chapters or path.name[:2] in chapters:
                for row in measured_page(lab, browser, path, steps):
                    rows.append(row)
                    print(line_of(row), flush=True)
        browser.close()
    moved = [row for row in rows if row.keys or row.mouse]
    within = [row for row in moved if statistics.median(step.picture for step in (*row.keys, *row.mouse)) <= GOAL_MS]
    print(f"{len(within)} of {len(moved)} within {GOAL_MS:.0f} ms")


def measured_page(lab: Lab, browser, path: Path, steps: int) -> Iterator[Row]:
    """Run a page, and move whatever can be moved in it."""
    names = with_echoes(path)
    if not names:
        return
    page = browser.new_page(viewport={"width": 1366, "height": 1100})
    page.set_default_timeout(PATIENCE_S * 1000)
    lab.open(page, str(path.relative_to(lab.folder)))
    page.evaluate(FIND)
    page.evaluate("void jupyterapp.commands.execute('notebook:run-all-cells')")
    page.wait_for_function(HAVE_RUN, timeout=300_000)
    for name in names:
        page.evaluate(SHOW, name)
        page.wait_for_timeout(1500)
        controls, echo = page.evaluate(CONTROLS, name), page.evaluate(CONTROLS, ECHO + name)
        if controls and echo:
            yield measured(page, path.name[:2], name, controls, steps)
    page.close()


def with_echoes(path: Path) -> list[str]:
    """Put an echo after each interactive cell of a page; return the names of those cells."""
    notebook = nbformat.read(path, 4)
    cells, names = [], []
    for cell in notebook.cells:
        cells.append(cell)
        if "interactive" in cell.metadata.get("tags", []):
            names.append(cell.metadata["name"])
            cells.append(nbformat.v4.new_code_cell(ECHO_CELL, metadata={"name": ECHO + names[-1]}))
    notebook.cells = cells
    nbformat.write(notebook, path)
    return names


def measured(page, chapter: str, name: str, controls: Sequence[str], steps: int) -> Row:
    """Return the times of a panel and of its echo, taken in turn."""
    row = Row(chapter, name, [], [], [])
    for place, kind in enumerate(controls):
        row.keys.extend(chosen(page, name, place, steps) if kind == MENU else pressed(page, name, place, kind, steps))
        row.echo.extend(pressed(page, ECHO + name, 0, "slider", steps))
        if kind in ("slider", "range"):
            row.mouse.extend(dragged(page, name, place, kind, steps))
            row.echo.extend(dragged(page, ECHO + name, 0, "slider", steps))
    return row


def chosen(page, name: str, place: int, steps: int) -> Iterator[Step]:
    """Choose the options of a menu, one after the other."""
    menu = page.locator(f'[data-control="{name}-{place}"]')
    menu.focus()
    page.wait_for_timeout(HAND_MS)
    count = menu.locator("option").count()
    for _ in range(1, steps + 1):
        index = (menu.evaluate("(menu) => menu.selectedIndex") + 1) % count
        yield from taken(page, name, "change", lambda index=index: menu.select_option(index=index))


def pressed(page, name: str, place: int, kind: str, steps: int) -> Iterator[Step]:
    """Move a control by the keyboard: there, and back again."""
    keys = (" ", " ") if kind == "checkbox" else ("ArrowRight", "ArrowLeft")
    page.locator(f'[data-control="{name}-{place}"]').focus()
    page.wait_for_timeout(HAND_MS)
    for step in range(steps):
        yield from taken(page, name, "keydown", lambda step=step: page.keyboard.press(keys[step >= steps // 2]))


def dragged(page, name: str, place: int, kind: str, steps: int) -> Iterator[Step]:
    """Drag a slider by the mouse, towards its middle."""
    control = page.locator(f'[data-control="{name}-{place}"]')
    control.scroll_into_view_if_needed()
    page.wait_for_timeout(HAND_MS)
    box = rail = control.bounding_box()
    if kind == "range":  # the whole rail: its handle is where its value is
        part = control.evaluate("(range) => (range.value - range.min) / (range.max - range.min)")
        x = box["x"] + 8 + part * (box["width"] - 16)
    else:
        rail = control.locator("xpath=ancestor::*[contains(@class, 'noUi-target')]").bounding_box()
        x = box["x"] + box["width"] / 2
    y = box["y"] + box["height"] / 2
    toward = 1 if rail["x"] + rail["width"] / 2 > x else -1
    page.mouse.move(x, y)
    page.wait_for_timeout(HAND_MS)
    page.mouse.down()
    for step in range(1, steps + 1):
        yield from taken(page, name, "pointermove", lambda step=step: page.mouse.move(x + toward * STEP_PX * step, y))
    page.mouse.up()
    page.wait_for_timeout(PAUSE_MS)


def taken(page, name: str, kind: str, act) -> Iterator[Step]:
    """Do one step, and say how long it took; a step that changes nothing has no time."""
    page.evaluate(NEXT_PICTURE, [name, kind])
    act()
    step = Step(*(page.evaluate(what) for what in ("latency", "exact", "frame")))
    if step.picture > 0:
        yield step
    page.wait_for_timeout(PAUSE_MS)


def line_of(row: Row) -> str:
    """Return a row as text."""
    return f"{row.page:<5} {row.name:<22} " + " ".join(f"{in_words(times):>15}" for times in row.columns())


def in_words(times: Sequence[float]) -> str:
    """Return median, 95th percentile and number of some times."""
    if len(times) < 2:
        return "-"
    return f"{statistics.median(times):.0f} ({statistics.quantiles(times, n=20)[-1]:.0f}) n={len(times)}"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("chapters", nargs="*")
    parser.add_argument("--steps", type=int, default=6)
    options = parser.parse_args()
    main(options.chapters, options.steps)
