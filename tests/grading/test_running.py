"""What comes of cells on nbval: honest ones, broken ones, and those that lie to the grader."""

from __future__ import annotations

import os
import socket
import threading
import time
from types import SimpleNamespace

import pytest

from tflab.grading.judging import nbval_run
from tflab.grading.judging.job import CellOutcome, Run, RunCell
from tflab.grading.judging.nbval_run import run_cells
from tflab.grading.kernels.kernel_pool import Kernel, KernelError, Kernels, choose_sandbox, for_this_process
from tflab.grading.kernels.limits import Limits
from tflab.grading.kernels.probe import PROBE_TYPE
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
    assert done.stopped is None


def test_what_a_probe_brings_back_is_plain_and_carries_no_library_along(sandbox: Sandbox) -> None:
    (outcome,) = run(sandbox, probe("[{'x': {'y': [{}]}}]")).outcomes
    assert type(outcome.value[0]) is type(outcome.value[0]["x"]) is type(outcome.value[0]["x"]["y"][0]) is dict


def test_an_error_is_told_in_short_and_stops_nothing(sandbox: Sandbox) -> None:
    done = run(sandbox, "1 / 0", "x = 1 +* 2", "y = 2", probe("y"))
    troubles = [outcome.trouble for outcome in done.outcomes]
    assert troubles[0] == "error: ZeroDivisionError: division by zero"
    assert troubles[1].startswith("error: SyntaxError: ")
    assert troubles[2:] == [None, None]


def test_of_an_error_in_a_probe_only_the_kind_is_told(sandbox: Sandbox) -> None:
    done = run(sandbox, RunCell("probe", "p", "raise ValueError('the hidden input is 42')", probe="p"))
    assert done.outcomes[0].trouble == "error: ValueError"


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
        "while True:\n    pass",
        "import time\ntime.sleep(60)",
        "while True:\n    print('drip')",
        "import signal, time\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\nwhile True:\n    time.sleep(1)",
        "try:\n    while True: pass\nexcept BaseException:\n    while True: pass",
        "import asyncio\nawait asyncio.sleep(60)",
        "import threading\nthreading.Lock().acquire() and threading.Lock().acquire()\nthreading.Event().wait()",
        "(lambda f: f(f))(lambda f: sum(x * 0 for x in range(10**9)) or f(f))",
        "10 ** 10 ** 10",
        "import re\nre.match('(a+)+$', 'a' * 50 + 'b')",
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
        "import os\nos._exit(0)",
        "import ctypes\nctypes.string_at(0)",
        "import os\nos.closerange(0, 200)",
        "import os\nos.abort()",
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


@pytest.mark.parametrize(
    ("cell", "trouble"),
    [
        (RunCell("probe", "p", "1", probe="p"), "no answer came"),
        (RunCell("probe", "p", 'print(\'{"id": "p", "v": 1}\')', probe="p"), "no answer came"),
        (probe("1", times=2), "something else than one answer came"),
        (RunCell("probe", "p", probe("1", "q").source, probe="p"), "something else than one answer came"),
        (
            RunCell("probe", "p", probe("1", "q").source + probe("1", "p").source, probe="p"),
            "something else than one answer came",
        ),
    ],
    ids=["nothing", "a print", "two", "another id", "one of each"],
)
def test_exactly_one_answer_with_the_right_id_counts(sandbox: Sandbox, cell: RunCell, trouble: str) -> None:
    done = run(sandbox, cell)
    assert (done.outcomes[0].value, done.outcomes[0].trouble) == (None, trouble)


@pytest.mark.parametrize(
    "shape",
    ["'p'", "None", "[1]", "{'id': 'p'}", "{'v': 1}", "{'id': ['p'], 'v': 1}", "{'id': None, 'v': 1}", "1.5"],
)
def test_an_answer_of_another_shape_is_none(sandbox: Sandbox, shape: str) -> None:
    show = f"from IPython.display import display\ndisplay({{{PROBE_TYPE!r}: {shape}}}, raw=True)"
    done = run(sandbox, RunCell("probe", "p", show, probe="p"))
    assert done.outcomes[0].trouble == "something else than one answer came"
    assert done.stopped is None


@pytest.mark.parametrize(
    "value",
    ["float('nan')", "float('inf')", "10 ** 4000", "True", "-0.0", "'\\ud800'", "[[]] * 1000", "{'a': {'b': {}}}"],
)
def test_odd_values_arrive_and_harm_nothing(sandbox: Sandbox, value: str) -> None:
    done = run(sandbox, probe(value), probe("2", "q"))
    assert done.outcomes[-1].value == 2


def test_a_value_too_deep_or_too_long_to_read_ends_the_run_and_not_the_grader(sandbox: Sandbox) -> None:
    deep = raw("b'{\"a\":' * 200000 + b'1' + b'}' * 200000")
    long = raw("b'1' * 10000")
    assert run(sandbox, deep, probe("1")).stopped == "unreadable output"
    assert run(sandbox, long, probe("1")).stopped == "unreadable output"


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
        raw("b'not json'"),
        raw("b'\\xff\\xfe'"),
        raw("b'[]'"),
        raw("b'null'"),
        raw("b'x'", length="0xffffffff"),
        raw("b'{}'", length="1"),
    ],
    ids=["no json", "no text", "a list", "null", "a length without end", "a length too short"],
)
def test_nonsense_on_the_wire_ends_the_run(sandbox: Sandbox, cell: str) -> None:
    done = run(sandbox, cell, probe("1"))
    assert done.stopped == "unreadable output"
    assert all(one.value is None for one in done.outcomes)


@pytest.mark.parametrize(
    "message",
    [
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
    ],
)
def test_messages_that_are_nobodys_are_ignored(sandbox: Sandbox, message: str) -> None:
    done = run(sandbox, raw(f"b'{message}'"), probe("1"))
    assert (done.stopped, done.outcomes[-1].value) == (None, 1)


HEADER = "get_ipython().kernel.get_parent()['header']"


def test_a_cell_that_is_said_to_have_ended_before_it_has_gains_nothing(sandbox: Sandbox) -> None:
    early = f"""
import time
wire = get_ipython().kernel.session.wire
header = {HEADER}
wire.send({{"channel": "shell", "msg_type": "execute_reply", "parent_header": header, "content": {{}}}})
idle = {{"execution_state": "idle"}}
wire.send({{"channel": "iopub", "msg_type": "status", "parent_header": header, "content": idle}})
time.sleep(60)
"""
    done = run(sandbox, early, probe("1"), limits=SHORT)
    assert all(one.value is None for one in done.outcomes)
    assert done.stopped == "timed out"


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


def test_a_kernel_that_does_not_listen_is_ended(sandbox: Sandbox) -> None:
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
    done = run(sandbox, deaf, "x = '" + "x" * (8 << 20) + "'", limits=SHORT)
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


def test_threads_of_one_process_may_run_cells_at_the_same_time(sandbox: Sandbox) -> None:
    got: dict[int, object] = {}

    def one(number: int) -> None:
        got[number] = run(sandbox, f"x = {number}", probe("x * 2")).outcomes[-1].value

    threads = [threading.Thread(target=one, args=(n,)) for n in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert got == {n: 2 * n for n in range(6)}


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
    order, orders = kernels._order, []

    def without_room(limits: Limits) -> Kernel:
        orders.append(limits)
        if len(orders) > 1:
            return order(limits)
        (wire, its_wire), (leash, its_leash) = socket.socketpair(), socket.socketpair()
        its_wire.close()
        its_leash.close()
        return Kernel(Wire(wire, longest=1000), leash)

    kernels._order = without_room
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
