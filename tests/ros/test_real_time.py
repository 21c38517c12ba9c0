"""The same nodes in real time: scripts, files run together, Ctrl-C."""

import itertools
import os
import runpy
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml

from tflab import ros
from tflab.ros import run_files, wall
from tflab.ros.process import use_graph

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
LECTURE = Path(__file__).parent / "lecture"
NODES = [
    str(LECTURE / f"{name}.py") for name in ("static_sensor_broadcaster", "moving_robot_broadcaster", "point_to_map")
]


@pytest.fixture(autouse=True)
def clean():
    yield
    use_graph(None)
    ros.deactivate()


def run_python(code, until=None):
    """Run a script; interrupt it as soon as a line of its stderr contains `until`.  Return (out, err)."""
    process = subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(code)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    err = ""
    if until is not None:
        for line in process.stderr:
            err += line
            if until in line:
                process.send_signal(signal.SIGINT)
                break
    out, rest = process.communicate(timeout=30)
    return out, err + rest


def test_where_the_systems_clock_is_set_on_every_15_ms_stamps_do_not_repeat(monkeypatch):
    tick_ns, passed_ns = 15_625_000, itertools.count(0, 5_000_000)  # 5 ms from one look at a clock to the next
    monkeypatch.setattr(time, "get_clock_info", lambda name: SimpleNamespace(resolution=tick_ns / 1e9))
    monkeypatch.setattr(time, "time_ns", lambda: 1_700_000_000 * 10**9 + next(passed_ns) // tick_ns * tick_ns)
    monkeypatch.setattr(time, "perf_counter_ns", lambda: next(passed_ns))
    clocks = runpy.run_path(wall.__file__)["WallTime"]()
    stamps = [clocks.now_ns() for _ in range(6)]
    assert [after - before for before, after in itertools.pairwise(stamps)] == [5_000_000] * 5
    assert 1_700_000_000 * 10**9 <= stamps[0] < 1_700_000_000 * 10**9 + 2 * tick_ns


def test_a_snippet_passes_in_real_time(capsys):
    ros.activate("in-process")
    ros.new_graph(virtual=False)
    runpy.run_path(str(LECTURE / "snippet_19_wait_async.py"))["main"]()
    assert capsys.readouterr().out.splitlines()[-1].startswith("OK §19")


def test_the_three_nodes_run_together_and_end_as_on_ros_2(capfd):
    assert run_files(NODES, seconds=0.5) == 1
    err = capfd.readouterr().err
    assert "[static_sensor_broadcaster]: base_link → laser_frame 발행" in err
    # Ctrl-C has shut the context down, so the last line of each file fails.
    text = "_rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context, at "
    text += "./src/rcl/init.c:333\n"
    if sys.version_info >= (3, 11):  # before, an exception has no notes
        text += "tflab: Ctrl-C shut the context down, as on a robot. Write rclpy.try_shutdown(), not"
    assert err.count(text) == 3
    assert "run.py" not in err  # a traceback begins in the reader's own file


def test_a_function_can_run_with_the_files_and_see_their_nodes(capfd):
    from tflab.ros import client_library as rclpy
    from tflab.ros.node import Node

    seen = []

    def look():
        rclpy.init()
        node = Node("looker")
        seen.append(node.wait_for_node("moving_robot_broadcaster", timeout=5.0))

    run_files(NODES[1:2], beside=[("look", look)], seconds=0.5)
    capfd.readouterr()
    assert seen == [True]


def test_a_file_that_ends_well_is_a_success_and_a_missing_one_is_named_before_anything_starts(tmp_path, capfd):
    path = tmp_path / "short.py"
    path.write_text("import helper\nimport rclpy\nrclpy.init()\nprint(helper.WORD, __name__)\n")
    (tmp_path / "helper.py").write_text("WORD = 'neighbour'\n")
    assert run_files([]) == run_files([str(path)]) == 0
    assert capfd.readouterr().out == "neighbour __main__\n"
    with pytest.raises(FileNotFoundError, match=r"no such node file: .*nobody\.py"):
        run_files([*NODES, str(tmp_path / "nobody.py")])
    with pytest.raises(TypeError, match=r"run_files\(\['nobody\.py'\]\)"):
        run_files("nobody.py")


def test_the_first_file_has_the_main_thread(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "node.py").write_text(
        "import asyncio, signal, sys\nsay = sys.stdout.write  # two files at once: one piece each\n"
        "say(' '.join(sys.argv) + '\\n')\nsignal.signal(signal.SIGINT, print)\n"
        "say(f'{isinstance(asyncio.get_event_loop(), asyncio.AbstractEventLoop)}\\n')\n"
    )
    assert run_files(["node.py", "node.py"], args=["--ros-args"]) == 1  # the second one has not
    printed = capfd.readouterr()
    assert sorted(printed.out.splitlines()) == ["True", "node.py --ros-args", "node.py --ros-args"]
    assert printed.err.count("participant") == printed.err.count("ValueError: signal only works in main thread") == 1
    assert printed.err.endswith("\n(tflab runs only the first file in the main thread. Name this one first.)\n")
    assert not hasattr(threading.main_thread(), "tflab_process")


def test_ctrl_c_ends_the_others_after_a_file_with_a_handler_of_its_own_has_ended(tmp_path, capfd):
    own, press = tmp_path / "own.py", tmp_path / "press.py"
    own.write_text("import signal\nsignal.signal(signal.SIGINT, print)\n")
    press.write_text(
        "import os, signal, time\ntime.sleep(0.5)\nos.kill(os.getpid(), signal.SIGINT)\ntime.sleep(2)\nprint('slept')\n"
    )
    assert run_files([str(own), str(press)]) == 0
    assert capfd.readouterr() == ("", "")


def test_the_exit_status_is_that_of_the_files(tmp_path):
    for name, code in {"good": "0", "usage": "2", "text": "'wrong'"}.items():
        (tmp_path / f"{name}.py").write_text(f"import sys\nsys.exit({code})\n")
    good, usage, text = (str(tmp_path / f"{name}.py") for name in ("good", "usage", "text"))
    assert [run_files(files) for files in ([good], [good, usage], [text])] == [0, 2, 1]


def test_the_report_of_a_participant_or_a_thread_is_written_in_one_piece(tmp_path, monkeypatch):
    pieces = []
    monkeypatch.setattr(sys, "stderr", SimpleNamespace(write=pieces.append, flush=lambda: None))
    thread = "thread = threading.Thread(target=int, args=['one'], name='own')\nthread.start()\nthread.join()"
    (tmp_path / "node.py").write_text(f"import threading\n{thread}\nint('two')\n")
    assert run_files([str(tmp_path / "node.py")]) == 1
    assert [piece.splitlines()[0] for piece in pieces] == [
        "Exception in thread own:",
        'participant "node" ended with an exception:',
    ]
    assert [piece[-6:] for piece in pieces] == ["'one'\n", "'two'\n"]


def test_ctrl_c_while_the_files_are_still_being_started_interrupts_all_of_them(capfd):
    from tflab.ros import client_library as rclpy
    from tflab.ros.node import Node

    ended = []

    def press():
        os.kill(os.getpid(), signal.SIGINT)

    def stay():
        rclpy.init()
        try:
            rclpy.spin(Node("stay"))
        finally:
            ended.append(True)

    run_files([], beside=[("press", press), *((f"stay{number}", stay) for number in range(20))])
    assert len(ended) == 20
    assert "went on" not in capfd.readouterr().err


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="Windows has no such signal")
def test_a_signal_handler_wakes_the_thread_that_it_interrupts():
    assert run_python(CASES["woken_by_a_signal"]) == ("woken\n", "")


def test_ctrl_c_in_a_script_shuts_the_context_down_first():
    _, err = run_python(CASES["script"], until="ready")
    assert "[script]: interrupted, ok is False" in err and "[script]: tried to shut down" in err
    assert "RCLError: failed to shutdown: rcl_shutdown already called on the given context" in err


def test_stopping_a_graph_in_real_time_waits_for_its_participants():
    from tflab.ros import client_library as rclpy
    from tflab.ros.node import Node

    seen = []

    def main():
        rclpy.init()
        try:
            rclpy.spin(Node("spinner"))
        except KeyboardInterrupt:
            time.sleep(0.1)
            seen.append(rclpy.ok())

    graph = ros.new_graph(virtual=False)
    participant = graph.start(main)
    graph.run(seconds=0.2)
    graph.stop()
    assert (participant.is_running, seen) == (False, [True])
