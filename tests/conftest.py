"""One JupyterLab and one Chromium for all tests in a real browser.

    lab        a real JupyterLab on a free port of this machine, in an empty folder
    chromium   a browser without a window, WebGL in software
    page       a tab of it; afterwards, no request of it may have left this machine

Only tests marked `browser` ask for these.  Without Chromium they are skipped, and
say how to get one; where CI=true they fail instead.
"""

from __future__ import annotations

import os
import shutil
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn
from urllib.parse import urlsplit

import pytest
from hypothesis import settings

from tflab.workbook.copy.lab import OUR_OPTIONS, our_environment

# Where a change has to pass, the same examples every time; on a developer's machine, new ones every time.
settings.register_profile("ci", derandomize=True, deadline=None)
settings.register_profile("developer", deadline=None)
settings.load_profile("ci" if os.environ.get("CI") == "true" else "developer")

# A script that starts the tests in the background has Ctrl-C ignored, and all that they start would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

TOKEN = "for-this-test-only"
PATIENCE_S = 180  # what is waited for in a browser comes, on a machine with other work; who waits longer is stuck
HERE = ("127.0.0.1", "localhost")
LOCAL_SCHEMES = ("file", "data", "blob", "about")
CHROMIUM_ARGUMENTS = [
    "--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
]  # fmt: skip
HOW_TO_GET_CHROMIUM = (
    "no Chromium: install one (apt install chromium; or: playwright install chromium), "
    "or name it in TFLAB_CHROMIUM, to run the tests in a browser"
)


@dataclass(frozen=True)
class Lab:
    """A running JupyterLab: where it is, and the folder it shows."""

    url: str
    folder: Path

    def write_notebook(self, name: str, sources: list[str]) -> None:
        """Put a notebook with these code cells into the folder."""
        import nbformat

        cells = [nbformat.v4.new_code_cell(source, id=f"cell-{i}") for i, source in enumerate(sources)]
        kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
        nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), self.folder / name)

    def open(self, page, name: str) -> None:
        """Show a notebook of the folder alone in `page`, ready to run."""
        page.goto(f"{self.url}/doc/tree/{name}?token={TOKEN}&reset")
        page.wait_for_selector(".jp-Notebook .jp-Cell")
        page.wait_for_function("jupyterapp.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'")

    def run_all(self, page) -> None:
        """Run every cell, and wait until the last one has run."""
        page.evaluate("void window.jupyterapp.commands.execute('notebook:run-all-cells')")
        page.wait_for_function(
            "[...document.querySelectorAll('.jp-CodeCell .jp-InputPrompt')]"
            ".every((p) => /\\[\\d+\\]/.test(p.innerText))"
        )

    def set_theme(self, page, theme: str) -> None:
        """Change to "JupyterLab Light" or "JupyterLab Dark"."""
        page.evaluate(f"window.jupyterapp.commands.execute('apputils:change-theme', {{theme: '{theme}'}})")
        light = str(theme == "JupyterLab Light").lower()
        page.wait_for_selector(f"body[data-jp-theme-light={light}]", state="attached")


@pytest.fixture
def undone() -> Iterator[None]:
    """What `%load_ext tflab` changes in this process is as it was when the test is over."""
    from tflab import ros
    from tflab.ros.logging import write_to_stdout
    from tflab.ros.messages import set_field_checks
    from tflab.ros.process import use_graph

    yield
    ros.deactivate()
    set_field_checks(None)
    write_to_stdout(False)
    use_graph(None)


@pytest.fixture
def graph() -> Iterator:
    """A graph on virtual time, at 1 s; it is stopped when the test is over."""
    from tflab import ros
    from tflab.ros.client_library import try_shutdown
    from tflab.ros.logging import clear_config, show_engine_refusals
    from tflab.ros.process import use_graph

    graph = ros.new_graph()
    yield graph
    try_shutdown()
    graph.stop()
    use_graph(None)
    clear_config()
    show_engine_refusals(False)


@pytest.fixture(scope="session")
def chromium() -> Iterator:
    """A headless Chromium with WebGL in software."""
    try:
        from playwright.sync_api import sync_playwright
    except ModuleNotFoundError:
        _do_without("no playwright: pip install playwright")
    with sync_playwright() as driver:
        path = find_chromium(driver)
        if path is None:
            _do_without(HOW_TO_GET_CHROMIUM)
        browser = driver.chromium.launch(
            executable_path=path, args=CHROMIUM_ARGUMENTS, ignore_default_args=["--headless", "--headless=old"]
        )
        yield browser
        browser.close()


@pytest.fixture
def page(chromium) -> Iterator:
    """A new tab; when the test is over, every request it made must have stayed on this machine."""
    context = chromium.new_context(viewport={"width": 1100, "height": 900})
    context.set_default_timeout(PATIENCE_S * 1000)
    tab = context.new_page()
    asked: list[str] = []
    context.on("request", lambda request: asked.append(request.url))
    yield tab
    context.close()
    parts = [urlsplit(url) for url in asked]
    outside = [part.geturl() for part in parts if part.scheme not in LOCAL_SCHEMES and part.hostname not in HERE]
    assert not outside, f"these requests left the machine: {outside}"


@pytest.fixture(scope="session")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """A JupyterLab without news, update checks or look-ups of extensions."""
    with running_lab(tmp_path_factory.mktemp("jupyter")) as running:
        yield running


@contextmanager
def running_lab(home: Path) -> Iterator[Lab]:
    """Run JupyterLab for as long as the context lasts, with everything it writes in `home`.

    Raises:
        RuntimeError: it did not start; the end of its log follows.
    """
    folder = home / "notebooks"
    folder.mkdir()
    port = _free_port()
    own_folders = {
        "JUPYTER_CONFIG_DIR": str(home / "config"),
        "JUPYTER_RUNTIME_DIR": str(home / "runtime"),
        "JUPYTERLAB_SETTINGS_DIR": str(home / "settings"),
        "JUPYTERLAB_WORKSPACES_DIR": str(home / "workspaces"),
        "IPYTHONDIR": str(home / "ipython"),
    }
    arguments = [
        "--no-browser",
        "--allow-root",
        f"--ServerApp.root_dir={folder}",
        f"--ServerApp.port={port}",
        "--ServerApp.port_retries=0",
        f"--IdentityProvider.token={TOKEN}",
        "--LabApp.expose_app_in_browser=True",
        *OUR_OPTIONS,
    ]
    with (home / "log").open("w") as log:
        server = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", *arguments],
            env=os.environ | own_folders | our_environment(os.environ), stdout=subprocess.DEVNULL, stderr=log,
        )  # fmt: skip
        url = f"http://127.0.0.1:{port}"
        try:
            _wait_for(f"{url}/api?token={TOKEN}", server, home / "log")
            yield Lab(url, folder)
        finally:
            server.terminate()  # it ends its kernels, too
            server.wait(timeout=20)


def _do_without(reason: str) -> NoReturn:
    """Skip the test; where browsers must be there, fail it."""
    if os.environ.get("CI") == "true":
        pytest.fail(reason)
    pytest.skip(reason)


def find_chromium(driver) -> str | None:
    """Return the browser to use: the one that was named, the system's, or playwright's own."""
    for name in (os.environ.get("TFLAB_CHROMIUM", ""), "chromium", "chromium-browser", "google-chrome"):
        if name and shutil.which(name):
            return shutil.which(name)
    own = driver.chromium.executable_path
    return own if Path(own).exists() else None


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _wait_for(url: str, server: subprocess.Popen, log: Path) -> None:
    deadline = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline and server.poll() is None:
        try:
            with urllib.request.urlopen(url, timeout=5):
                return
        except OSError:
            time.sleep(0.2)
    raise RuntimeError(f"JupyterLab did not start:\n{log.read_text()[-2000:]}")
