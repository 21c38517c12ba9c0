"""Film pages and a reply in a browser, for the pictures of the README and the site: `make pictures`.

    page 00, "motion"       the robot drives, its laser sees the room         \\
    page 09, "walls-walk"   a clock runs late, and the walls walk away         > docs/pictures/drive.webp, drive.ko.webp
    exercise E3.3           a wrong answer, and what `check` says of it       /

Nothing is drawn here.  The reply that is seen is written into the file as well (XMP, `dc:description`), for a
test to hold it to what `check` says today.  It needs Chromium, as the tests in a browser do, and a Korean font.
"""

from __future__ import annotations

import io
import os
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.sax.saxutils import escape

import nbformat
from PIL import Image
from playwright.sync_api import Page, sync_playwright

from tflab.text import LANGUAGES
from tflab.views.export import export_html
from tflab.workbook.pages.html import run_with_films
from tflab.workbook.paths import workbook_data

PICTURES = Path(__file__).parent / "pictures"
SIZE = (720, 380)  # [px]
QUALITY = 65  # of 100; below, what differs little from the frame before keeps its colour
FILMS = (("00_start", "motion", 20, 130), ("09_exceptions_and_waiting", "walls-walk", 6, 450))  # frames, each [ms]
REPLY = '[id="cell-id=reply"]'
WRITTEN = f"{REPLY} :is(.jp-Cell-inputWrapper, .jp-OutputArea-child:first-child)"  # the answer and its reply
DRAWN = f"{REPLY} .jp-OutputArea-child:not(:first-child)"  # where it went
REPLY_MS = 6000
REPLY_WIDTH = 720  # [px] of the window: as wide as a frame, so that the letters of the reply are not made smaller
WRONG_ANSWER = """def invert(a_pose_b):
    return {"x": -a_pose_b["x"], "y": -a_pose_b["y"], "yaw": -a_pose_b["yaw"]}

check("E3.3", invert)"""
CHROMIUM = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader"]
CHROMIUM += ["--enable-unsafe-swiftshader"]
XMP = """<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description xmlns:dc="http://purl.org/dc/elements/1.1/" dc:language="{language}">
<dc:description>{said}</dc:description></rdf:Description></rdf:RDF></x:xmpmeta>"""
SET = "(range, value) => { range.value = value; range.dispatchEvent(new Event('input', {bubbles: true})); }"


def main() -> int:
    """Make the pictures; return 0, or 2 where there is no browser."""
    named = (os.environ.get("TFLAB_CHROMIUM", ""), "chromium", "google-chrome")
    browser = next(filter(None, map(shutil.which, named)), None)
    if browser is None:
        print("make pictures: no Chromium (Debian: apt-get install chromium)", file=sys.stderr)
        return 2
    PICTURES.mkdir(exist_ok=True)
    with TemporaryDirectory() as folder, sync_playwright() as driver:
        chromium = driver.chromium.launch(
            executable_path=browser, args=CHROMIUM, ignore_default_args=["--headless", "--headless=old"]
        )
        for language in LANGUAGES:
            _make(chromium.new_page(viewport={"width": 900, "height": 700}), language, Path(folder) / language)
        chromium.close()
    return 0


def _make(tab: Page, language: str, folder: Path) -> None:
    """Film the pages of a language, then the reply, and write the picture."""
    folder.mkdir()
    frames: list[tuple[Image.Image, int]] = []
    for stem, cell, count, each_ms in FILMS:
        tab.goto(_exported(workbook_data() / "notebooks" / language / f"{stem}.ipynb", folder).as_uri())
        frames += [(frame, each_ms) for frame in _film(tab, cell, count)]
    tab.set_viewport_size({"width": REPLY_WIDTH, "height": SIZE[1]})
    tab.goto(_exported(_reply(language, folder), folder).as_uri())
    for hidden, shown_ms in ((DRAWN, REPLY_MS), (WRITTEN, REPLY_MS // 2)):
        style = tab.add_style_tag(content=f"{hidden} {{ display: none !important }}")
        frames.append((_shot(tab, REPLY), shown_ms))
        style.evaluate("style => style.remove()")
    said = _plain_reply(folder / "run-reply" / "reply.ipynb")
    _write(PICTURES / ("drive.webp" if language == "en" else f"drive.{language}.webp"), frames, language, said)


def _exported(notebook: Path, folder: Path) -> Path:
    """Return a page that was run, as HTML."""
    run_in = folder / f"run-{notebook.stem}"
    run_in.mkdir()
    return export_html(run_with_films(notebook, run_in), folder / "pages")


def _reply(language: str, folder: Path) -> Path:
    """Return a notebook with one wrong answer, and its check."""
    cells = [
        nbformat.v4.new_code_cell("%load_ext tflab\nfrom tflab.workbook import check", id="load"),
        nbformat.v4.new_code_cell(WRONG_ANSWER, id="reply"),
    ]
    path = folder / "reply.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata={"tflab": {"language": language}}), path)
    return path


def _plain_reply(notebook: Path) -> str:
    """Return as text what the last cell of a notebook that was run says first."""
    output, *_ = nbformat.read(notebook, as_version=4).cells[-1].outputs
    return output.data["text/plain"]


def _film(tab: Page, cell: str, count: int) -> Iterator[Image.Image]:
    """Yield pictures of a cell's view, its scrubber moved from end to end."""
    view = f'[id="cell-id={cell}"] .tflab-live'
    tab.locator(view).scroll_into_view_if_needed()
    tab.wait_for_timeout(1500)
    scrubber = tab.locator(f"{view} input[type=range]").first
    last = int(scrubber.get_attribute("max") or 0)
    for number in range(count):
        scrubber.evaluate(SET, round(number * last / (count - 1)))
        tab.wait_for_timeout(250)
        yield _shot(tab, view)


def _shot(tab: Page, selector: str) -> Image.Image:
    """Return what a part of the page looks like, as large as all frames."""
    part = Image.open(io.BytesIO(tab.locator(selector).screenshot())).convert("RGB")
    part.thumbnail(SIZE, Image.Resampling.LANCZOS)
    frame = Image.new("RGB", SIZE, "white")
    frame.paste(part, ((SIZE[0] - part.width) // 2, (SIZE[1] - part.height) // 2))
    return frame


def _write(path: Path, frames: list[tuple[Image.Image, int]], language: str, said: str) -> None:
    """Write a moving picture that goes round for ever, and with it the reply that it shows."""
    first, *rest = [frame for frame, _ in frames]
    durations = [each_ms for _, each_ms in frames]
    xmp = XMP.format(language=language, said=escape(said)).encode()
    how = {"quality": QUALITY, "method": 6, "minimize_size": True, "loop": 0}
    first.save(path, save_all=True, append_images=rest, duration=durations, xmp=xmp, **how)
    print(f"{path}: {path.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    sys.exit(main())
