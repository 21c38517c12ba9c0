"""What comes of cells on nbval: honest ones, broken ones, and those that lie to the grader."""

from __future__ import annotations

import os
import socket
import time
from types import SimpleNamespace

import pytest

from tflab.grading.judging import nbval_run
from tflab.grading.judging.job import CellOutcome, Run, RunCell
from tflab.grading.judging.nbval_run import run_cells
from tflab.grading.kernels.kernel_pool import Kernel, KernelError, Kernels, choose_sandbox, for_this_process
from tflab.grading.kernels.limits import Limits
from tflab.grading.kernels.probe_answer import PROBE_TYPE
from tflab.grading.kernels.sandbox import Sandbox
from tflab.grading.kernels.wire import Wire

SHORT = Limits(cell_s=1.0, notebook_s=5.0)
LONG = Limits(cell_s=30.0, notebook_s=60.0)


@pytest.fixture(scope="module")
def sandbox() -> Sandbox:
    return choose_sandbox()


def probe(value: str, name: str = "p", *, times: int = 1) -> RunCell:
    show = f"""
from IPython.display import display
for _ in range({times}):
    display({{{PROBE_TYPE!r}: {{"id": {name!r}, "v": {value}}}}}, raw=True)
"""
    return RunCell("probe", f"probe-{name}", show, probe=name)


def run(sandbox: Sandbox, *sources: str | RunCell, limits: Limits = LONG) -> Run:
    cells = [RunCell("answer", f"c{n}", text) if isinstance(text, str) else text for n, text in enumerate(sources)]
    return run_cells(cells, limits=limits, sandbox=sandbox)


def test_a_probe_brings_back_the_value_of_an_answer(sandbox: Sandbox) -> None:
    done = run(sandbox, "x = [1.5, True, None]", probe("{'x': x}"))
    assert done.outcomes == (CellOutcome(), CellOutcome({"x": [1.5, True, None]}))
    assert type(done.outcomes[1].value) is dict  # and no object of a library
    assert done.stopped is None


def test_an_error_is_told_in_short_and_stops_nothing(sandbox: Sandbox) -> None:
    secret = RunCell("probe", "p", "raise ValueError('the hidden input is 42')", probe="p")
    done = run(sandbox, "1 / 0", "x = 1 +* 2", secret, "y = 2", probe("y"))
    troubles = [outcome.trouble for outcome in done.outcomes]
    assert troubles[0] == "error: ZeroDivisionError: division by zero"
    assert troubles[1].startswith("error: SyntaxError: ")
    assert troubles[2:] == ["error: ValueError", None, None]


def test_a_talkative_answer_costs_nothing(sandbox: Sandbox) -> None:
    chatter = "import sys, warnings\nfor _ in range(20000):\n    print('x' * 1000)\n    sys.stderr.write('y' * 1000)"
    figures = "import matplotlib.pyplot as plt\nfor _ in range(3):\n    plt.figure(); plt.plot([1, 2])\nplt.show()"
    done = run(sandbox, chatter, figures, "warnings.warn('careful')\n'a result'", probe("3"))
    assert [outcome.trouble for outcome in done.outcomes] == [None] * 4
    assert done.outcomes[-1].value == 3


def test_two_runs_share_nothing(sandbox: Sandbox) -> None:
    run(sandbox, "import builtins, numpy\nbuiltins.len = lambda _: 7\nnumpy.pi = 3\nopen('left', 'w').write('x')")
    done = run(sandbox, "import numpy, os", probe("[len([]), numpy.pi > 3.1, os.path.exists('left')]"))
    assert done.outcomes[-1].value == [0, True, False]


# What ends a run.


@pytest.mark.parametrize(
    "source",
    [
        "while True:\n    print('drip')",
        "import signal, time\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\nwhile True:\n    time.sleep(1)",
        "import asyncio\nawait asyncio.sleep(60)",
        "10 ** 10 ** 10",
    ],
)
def test_a_cell_that_does_not_end_is_ended_at_its_deadline(sandbox: Sandbox, source: str) -> None:
    begin = time.monotonic()
    done = run(sandbox, source, probe("1"), limits=SHORT)
    assert time.monotonic() - begin < 20
    assert [outcome.trouble for outcome in done.outcomes] == ["timed out"]
    assert done.stopped == "timed out"


def test_cells_that_share_their_time_have_one_deadline(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [100.0]
    monkeypatch.setattr(nbval_run, "time", SimpleNamespace(monotonic=lambda: now[0]))
    kernel = nbval_run.WiredKernel(SimpleNamespace(), Limits(cell_s=10.0, notebook_s=60.0))
    ends = []
    for later, cell in (
        (0.0, RunCell("answer", "a", shared="1")),
        (4.0, RunCell("answer", "b", shared="1")),
        (1.0, RunCell("answer", "c", shared="2", part=0.1)),
        (1.0, RunCell("answer", "d")),
        (50.0, RunCell("answer", "e")),
    ):
        now[0] += later
        kernel.start_clock(cell)
        ends.append(kernel._cell_end)
    assert ends == [110.0, 110.0, 106.0, 116.0, 160.0]


def test_many_slow_cells_are_ended_at_the_deadline_of_all(sandbox: Sandbox) -> None:
    slow = "import time\ntime.sleep(0.4)"
    done = run(sandbox, *[slow] * 10, limits=Limits(cell_s=5.0, notebook_s=1.0))
    assert done.outcomes[-1].trouble == "timed out"
    assert len(done.outcomes) < 5


@pytest.mark.parametrize(
    "source",
    [
        "import ctypes\nctypes.string_at(0)",
        "import os\nos.closerange(0, 200)",
        "import sys\nsys.setrecursionlimit(10**9)\nf = lambda: f()\nf()",
        "import os\nos.execv('/bin/true', ['true'])",
    ],
)
def test_the_death_of_a_kernel_is_noticed_at_once(sandbox: Sandbox, source: str) -> None:
    begin = time.monotonic()
    done = run(sandbox, source, probe("1"))
    assert time.monotonic() - begin < 15
    assert done.outcomes[-1].trouble in ("kernel died", "memory limit")
    assert done.stopped == done.outcomes[-1].trouble


def test_an_answer_that_cancels_every_task_of_the_loop_does_not_end_the_kernel(sandbox: Sandbox) -> None:
    cancelling = """
import asyncio, threading, time
loop = asyncio.get_running_loop()
def cancel():
    for task in asyncio.all_tasks(loop):
        task.cancel()
def keep_on():
    for _ in range(300):
        loop.call_soon_threadsafe(cancel)
        time.sleep(0.001)
canceller = threading.Thread(target=keep_on)
canceller.start()
"""
    done = run(sandbox, cancelling, *["x = 1"] * 50, "canceller.join()", "x = 2", probe("x"))
    assert done.stopped is None
    assert done.outcomes[-1].value == 2


def test_too_much_output_of_the_kind_that_is_read_ends_the_run(sandbox: Sandbox) -> None:
    many = run(sandbox, probe("1", times=5000))
    long = run(sandbox, probe("'x' * (9 << 20)"))
    long_together = run(sandbox, probe("'x' * (1 << 20)", times=9))
    assert [one.outcomes[0].trouble for one in (many, long_together)] == ["output limit"] * 2
    assert long.outcomes[0].trouble in ("output limit", "unreadable output")


# Lies.


def test_exactly_one_answer_with_the_right_id_and_shape_counts(sandbox: Sandbox) -> None:
    def saying(source: str) -> RunCell:
        return RunCell("probe", "p", source, probe="p")

    def shaped(shape: str) -> RunCell:
        return saying(f"from IPython.display import display\ndisplay({{{PROBE_TYPE!r}: {shape}}}, raw=True)")

    nothing = [saying("1"), saying('print(\'{"id": "p", "v": 1}\')')]
    another = probe("1", "q").source
    several = [probe("1", times=2), saying(another), saying(another + probe("1", "p").source)]
    shapes = ["'p'", "None", "[1]", "{'id': 'p'}", "{'v': 1}", "{'id': ['p'], 'v': 1}", "{'id': None, 'v': 1}", "1.5"]
    odd = ["float('nan')", "10 ** 4000", "-0.0", "'\\ud800'", "[[]] * 1000"]  # arrive, and harm nothing
    cells = [*nothing, *several, *map(shaped, shapes), *map(probe, odd), probe("2")]
    done = run(sandbox, *cells)
    assert [one.trouble for one in done.outcomes[:2]] == ["no answer came"] * 2
    wrong = done.outcomes[2 : 5 + len(shapes)]
    assert [(one.value, one.trouble) for one in wrong] == [(None, "something else than one answer came")] * len(wrong)
    assert (done.stopped, done.outcomes[-1].value) == (None, 2)


def raw(body: str, *, length: str = "len(body)") -> str:
    """Return a cell that speaks on the wire itself."""
    return f"""
import select, struct
body = {body}
end = get_ipython().kernel.session.wire.end
rest = struct.pack("!I", {length}) + body
while rest:
    select.select([], [end], [])
    rest = rest[end.send(rest):]
"""


@pytest.mark.parametrize(
    "cell",
    [
        raw("b'\\xff\\xfe'"),
        raw("b'[]'"),
        raw("b'x'", length="0xffffffff"),
        raw("b'{}'", length="1"),
        raw("b'{\"a\":' * 200000 + b'1' + b'}' * 200000"),
        raw("b'1' * 10000"),
    ],
    ids=["no text", "a list", "a length without end", "a length too short", "too deep", "too many digits"],
)
def test_nonsense_on_the_wire_ends_the_run(sandbox: Sandbox, cell: str) -> None:
    done = run(sandbox, cell, probe("1"))
    assert done.stopped == "unreadable output"
    assert all(one.value is None for one in done.outcomes)


NOBODYS = (
    "{}",
    '{"channel": "shell"}',
    '{"channel": "nowhere", "msg_type": "status", "parent_header": {}, "content": {}}',
    '{"channel": "iopub", "msg_type": "status", "parent_header": {}, "content": {}}',
    '{"channel": "iopub", "msg_type": "status", "parent_header": {"msg_id": []}, '
    '"content": {"execution_state": "idle"}}',
    '{"channel": "iopub", "msg_type": "display_data", "parent_header": {}, "content": {"data": 1}}',
    '{"channel": "iopub", "msg_type": "display_data", "parent_header": 7, "content": {"data": {}}}',
    '{"channel": ["iopub"], "msg_type": {}, "parent_header": {}, "content": []}',
    '{"channel": "shell", "msg_type": "execute_reply", "parent_header": {"msg_id": 1}, "content": {}}',
    '{"channel": "iopub", "msg_type": "error", "parent_header": {}, "content": {"ename": {}, "evalue": 1}}',
    '{"ready": true}',
    '{"fault": "I am the supervisor"}',
)


def test_messages_that_are_nobodys_are_ignored(sandbox: Sandbox) -> None:
    done = run(sandbox, *(raw(f"b'{message}'") for message in NOBODYS), probe("1"))
    assert (done.stopped, done.outcomes[-1].value) == (None, 1)


HEADER = "get_ipython().kernel.get_parent()['header']"


def test_answers_sent_before_the_question_are_ignored(sandbox: Sandbox) -> None:
    ahead = f"""
wire = get_ipython().kernel.session.wire
for name in ("p", "q"):
    said = {{"data": {{{PROBE_TYPE!r}: {{"id": name, "v": 1}}}}, "metadata": {{}}}}
    for header in ({{}}, {{"msg_id": name}}, {HEADER}):
        wire.send({{"channel": "iopub", "msg_type": "display_data", "parent_header": header, "content": said}})
"""
    done = run(sandbox, ahead, probe("2"))
    assert done.outcomes[1].value == 2


def test_a_kernel_that_says_it_is_idle_and_does_not_listen_gains_nothing(sandbox: Sandbox) -> None:
    deaf = f"""
import time
wire = get_ipython().kernel.session.wire
header = {HEADER}
wire.send({{"channel": "shell", "msg_type": "execute_reply", "parent_header": header, "content": {{}}}})
idle = {{"execution_state": "idle"}}
wire.send({{"channel": "iopub", "msg_type": "status", "parent_header": header, "content": idle}})
while True:
    time.sleep(1)
"""
    done = run(sandbox, deaf, "x = '" + "x" * (8 << 20) + "'", probe("1"), limits=SHORT)
    assert all(one.value is None for one in done.outcomes)
    assert done.stopped == "timed out"


def test_a_patched_display_can_only_say_what_could_have_been_answered(sandbox: Sandbox) -> None:
    patched = """
shell = get_ipython()
publish = shell.display_pub.publish
def forge(data, *args, **more):
    for one in data.values():
        if isinstance(one, dict) and "v" in one:
            one["v"] = "whatever"
    publish(data, *args, **more)
shell.display_pub.publish = forge
"""
    done = run(sandbox, patched, probe("1"))
    assert done.outcomes[1].value == "whatever"


# Many.


def test_no_descriptor_is_left_open(sandbox: Sandbox) -> None:
    run(sandbox, "1")
    for_this_process(sandbox).settle()
    before = len(os.listdir("/proc/self/fd"))
    for source in ("1", "1 / 0", "import os; os._exit(0)", "get_ipython().kernel.session.wire.send_bytes(b'[')"):
        run(sandbox, source)
    for_this_process(sandbox).settle()
    assert len(os.listdir("/proc/self/fd")) <= before


def test_a_forkserver_that_died_is_replaced(sandbox: Sandbox) -> None:
    kernels = for_this_process(sandbox)
    run(sandbox, "1")
    assert kernels._server is not None
    kernels._server.kill()
    kernels._server.wait()
    assert run(sandbox, probe("5")).outcomes[0].value == 5
    assert run(sandbox, probe("6")).outcomes[0].value == 6


def test_a_kernel_for_which_there_was_no_room_is_ordered_again(sandbox: Sandbox) -> None:
    kernels = Kernels(sandbox, ahead=0)
    order, orders = kernels._request, []

    def without_room(limits: Limits) -> Kernel:
        orders.append(limits)
        if len(orders) > 1:
            return order(limits)
        (wire, its_wire), (leash, its_leash) = socket.socketpair(), socket.socketpair()
        its_wire.close()
        its_leash.close()
        return Kernel(Wire(wire, longest=1000), leash)

    kernels._request = without_room
    try:
        kernels.take(Limits()).close()
    finally:
        kernels.close()
    assert len(orders) == 2


def test_a_kernel_that_cannot_start_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Sandbox, "shown", lambda self: ("/usr", "/does/not/exist"))
    kernels = Kernels(Sandbox("namespaces"), ahead=0)
    try:
        with pytest.raises(KernelError, match="the kernel did not start: "):
            kernels.take(Limits())
    finally:
        kernels.close()


def test_limits_have_to_be_positive_and_can_be_stretched() -> None:
    assert Limits(cell_s=2.0, notebook_s=10.0).times(3) == Limits(cell_s=6.0, notebook_s=30.0)
    with pytest.raises(ValueError, match=r"Limits.cell_s is 0; it has to be more than 0"):
        Limits(cell_s=0)
