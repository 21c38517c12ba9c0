"""What a page stores when it is run, and which outputs are refused."""

from __future__ import annotations

import asyncio
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import yaml
import zmq.asyncio

from tflab.workbook.pages.execute import Outputs, run_page, wait_for
from tflab.workbook.pages.source import PageFault

from .making_pages import TITLE, code, page

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

DRAW = "from tflab.views.picture import Picture\npicture = Picture()\npicture.text = 'nothing yet'\npicture"
WIDGET = "import ipywidgets\nipywidgets.IntSlider()"


def run(root: Path, *parts: str) -> tuple[Outputs, list[PageFault]]:
    beside = {"solutions/tasks/03_x/e3_1.py": b"TASK = 1\n"}
    return wait_for(run_page(page(root, TITLE, *parts), "notebooks/en", beside))


def test_a_page_stores_what_is_the_same_every_time(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("TFLAB_ROS_DISTRO", "humble")
    outputs, faults = run(
        tmp_path,
        code("twice", "print('one', flush=True)\nprint('two', flush=True)\n1 + 2"),
        code("silent", "x = 1"),
        code("turn", WIDGET, ' tags=["interactive"]'),
        code("figure", DRAW),
        code("again", WIDGET, ' tags=["interactive"]'),
        code("again-still", DRAW, ' tags=["static"]'),
        code("fails", "1 / 0", ' tags=["raises-exception"]'),
        code("after", "print(open('../../solutions/tasks/03_x/e3_1.py').read(), end='')"),
        code("shell", "import os\nprint([name for name in os.environ if name.startswith('TFLAB_ROS')])"),
    )
    assert faults == []
    assert outputs["twice"] == [
        {"name": "stdout", "output_type": "stream", "text": ["one\n", "two\n"]},
        {"data": {"text/plain": ["3"]}, "metadata": {}, "output_type": "execute_result"},
    ]
    assert outputs["silent"] == outputs["turn"] == []
    assert outputs["figure"] == outputs["again"]
    assert outputs["figure"][0]["data"]["text/plain"] == ["nothing yet"]
    division = {"ename": "ZeroDivisionError", "evalue": "division by zero", "output_type": "error", "traceback": []}
    assert outputs["fails"] == [division]
    assert outputs["after"][0]["text"] == ["TASK = 1\n"]  # a task file, beside the page
    assert outputs["shell"][0]["text"] == ["[]\n"]


def test_everything_that_must_not_be_put_out_is_a_fault_and_the_rest_still_runs(tmp_path: Path) -> None:
    _, faults = run(
        tmp_path,
        code("error", "raise RuntimeError('wheel came off')"),
        code("no-error", "1", ' tags=["raises-exception"]'),
        code("warns", "import warnings\nwarnings.warn('slippery')"),
        code("address", "print(object())"),
        code("place", "import os\nprint(os.getcwd())"),
        code("widget", WIDGET),
        code("no-words", WORDLESS),
        code("large", LARGE),
        code("turn", WIDGET, ' tags=["interactive"]'),
        code("no-figure", "print('nothing to see')"),
        code("ends", "import os\nos._exit(1)"),
        code("after", "1"),
    )
    said = {fault.cell: fault.wrong for fault in faults}
    expected = CASES["refused"]
    assert set(said) == set(expected)
    for cell, wrong in expected.items():
        assert re.match(wrong, said[cell], re.DOTALL), said[cell]
    assert len(faults) == len(expected), [str(fault) for fault in faults]


WORDLESS = CASES["wordless"]
LARGE = CASES["large"]


def test_the_event_loop_of_windows_is_nothing_to_whoever_waits_for_a_page(monkeypatch, recwarn) -> None:
    """As there: pyzmq helps itself with a thread."""
    monkeypatch.setattr(asyncio, "ProactorEventLoop", asyncio.SelectorEventLoop, raising=False)
    monkeypatch.setattr(zmq.asyncio, "_get_selector", zmq.asyncio._get_selector_windows)

    async def talk() -> bytes:
        with zmq.asyncio.Context() as context, context.socket(zmq.PAIR) as one, context.socket(zmq.PAIR) as other:
            one.bind("inproc://here")
            other.connect("inproc://here")
            said = other.recv()  # waits, and for that the loop has to watch a socket
            await one.send(b"heard")
            return await said

    assert wait_for(talk()) == b"heard"
    assert recwarn.list == []
    with pytest.warns(RuntimeWarning, match="Proactor event loop"), ThreadPoolExecutor(1) as thread:
        thread.submit(lambda: asyncio.run(talk())).result()  # without us it is said; a browser's test keeps this thread
