"""`tflab run` and `tflab ros2`: in a shell, in real time."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import yaml

from tflab import __version__
from tflab.cli import main
from tflab.tools.ros2 import plan

from .robot import fixed, moving

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
TALKER = CASES["talker"]


def tflab(*words, **options):
    """Start `tflab` in a process of its own."""
    code = "import sys; from tflab.cli import main; sys.exit(main())"
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    return subprocess.Popen([sys.executable, "-c", code, *words], **pipes, **options)


@pytest.fixture
def talker(tmp_path):
    path = tmp_path / "talker.py"
    path.write_text(TALKER)
    return str(path)


def test_nodes_run_with_a_tool_beside_them(talker):
    process = tflab("run", talker, "--with", "ros2 topic hz /tf", "--for", "2.6")
    out, error = process.communicate(timeout=30)
    assert out.splitlines()[0].startswith("average rate: ")
    assert (error, process.returncode) == ("", 0)


def test_ctrl_c_ends_everything(talker):
    process = tflab("run", talker, "--with", "ros2 run tf2_ros tf2_echo odom base_link 20")
    while not process.stdout.readline().startswith("At time"):
        assert process.poll() is None
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=30)
    assert process.returncode == 0


@pytest.mark.parametrize(("words", "text"), CASES["cannot_run"])
def test_what_cannot_be_run_is_explained(words, text, capsys):
    assert main(words) == 2
    assert text in capsys.readouterr().err


def test_a_wrong_tool_is_refused_before_anything_starts(talker, capsys):
    assert main(["run", talker, "--with", "ros2 topic hz"]) == 2
    assert capsys.readouterr().err.endswith("ros2 topic hz: error: the following arguments are required: topic_name\n")
    assert main(["ros2", "topic", "info", "/nope"]) == 1
    assert capsys.readouterr() == ("", "Unknown topic '/nope'\n")


@pytest.fixture
def bag(terminal, tmp_path):
    """Five seconds of odom -> base_link -> laser_frame."""
    terminal.graph.start(moving())
    terminal.graph.start(fixed())
    path = str(tmp_path / "drive")
    terminal.type(f"--for 5 bag record /tf /tf_static -o {path}")
    return path


def test_a_tool_sees_what_a_bag_plays(bag, capsys):
    assert main(["ros2", "--bag", bag, *["run", "tf2_ros", "tf2_echo", "odom", "base_link"]]) == 0
    out, err = capsys.readouterr()
    assert [line for line in out.splitlines() if line.startswith("At time")] == [
        f"At time {second}.950000000" for second in (1, 2, 3, 4, 5)
    ]
    assert err.splitlines()[-1].startswith("tflab ros2: the recording is over, after 5.0 s")
    assert err.splitlines()[-1].endswith("on a robot this tool runs until Ctrl-C")
    main(["ros2", "--bag", bag, "run", "tf2_ros", "tf2_monitor", "odom", "base_link"])  # which follows its clock
    out = capsys.readouterr().out
    assert "Frame: base_link, published by <no authority available>, Average Delay: 0" in out
    assert main(["ros2", "--bag", bag, "topic", "info", "/tf_static"]) == 0  # it has its topics from the beginning
    assert capsys.readouterr().out.startswith("Type: tf2_msgs/msg/TFMessage\nPublisher count: 1\n")
    main(["ros2", "--bag", bag, "--for", "2", "topic", "hz", "/tf"])
    assert re.fullmatch(r"tflab ros2: stopped after 2 s; the recording is [45]\.\d s long\n", capsys.readouterr().err)


def test_version_and_help(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"tflab {__version__}\n"
    assert main([]) == 0
    assert "run node files in real time" in capsys.readouterr().out


def test_help_imports_no_package_of_tflab():
    code = (
        "import sys; from tflab.cli import main; main(['--help']); "
        "print(sorted(name for name in sys.modules if 'tflab' in name))"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert out.splitlines()[-1] == "['tflab', 'tflab.cli', 'tflab.extras', 'tflab.text']"


def test_a_reader_that_has_gone_is_no_fault(talker):
    process = tflab("run", talker, "--with", "ros2 topic echo /tf", "--for", "2")
    assert process.stdout.readline() == "transforms:\n"
    process.stdout.close()
    assert (process.stderr.read(), process.wait(timeout=30)) == ("", 0)


def test_a_reader_that_has_gone_ends_a_tool_on_a_bag(bag):
    process = tflab("ros2", "--bag", bag, "topic", "echo", "/tf")
    process.stdout.readline()
    process.stdout.close()
    assert (process.stderr.read(), process.wait(timeout=30)) == ("", 141)


@pytest.mark.parametrize("moment_s", [0.1, 0.3])
def test_ctrl_c_while_it_is_still_loading_says_nothing(moment_s):
    code = "import sys; from tflab.cli import main; print(flush=True); sys.exit(main())"
    process = subprocess.Popen(
        [sys.executable, "-c", code, "ros2", "topic", "hz", "/tf"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    process.stdout.readline()
    time.sleep(moment_s)
    process.send_signal(signal.SIGINT)
    _, error = process.communicate(timeout=30)
    assert b"Traceback" not in error
    assert process.returncode in (0, 130)  # 0: the tool ran already, and Ctrl-C is how it ends


def test_an_endless_loop_is_interrupted_as_python_would_and_named(tmp_path):
    (tmp_path / "loop.py").write_text("import rclpy\n\nrclpy.init()\nwhile True:\n    pass\n")
    process = tflab("run", "loop.py", "--for", "0.5", cwd=tmp_path)
    _, error = process.communicate(timeout=30)
    assert error.startswith('participant "loop" neither slept nor spun: interrupted at loop.py:')
    assert "went on" not in error


@pytest.mark.parametrize(
    ("source", "last_line"),
    [
        (b"def main(:\n", "SyntaxError: invalid syntax"),
        (b"print(1)\n\n# \xc7\xd1\xb1\xdb\n", "save it as UTF-8 in your editor"),
        (b"raise ValueError('mine')\n", "ValueError: mine"),
    ],
)
def test_what_is_wrong_in_a_file_is_shown_without_our_own_lines(tmp_path, source, last_line):
    (tmp_path / "node.py").write_bytes(source)
    process = tflab("run", "node.py", cwd=tmp_path)
    out, error = process.communicate(timeout=30)
    assert error.rstrip().endswith(last_line)
    assert "run.py" not in error
    assert (out, process.returncode) == ("", 1)


def test_a_full_disk_is_one_line_and_a_failure(bag):
    with open("/dev/full", "w") as full:
        code = "import sys; from tflab.cli import main; sys.exit(main())"
        words = ["ros2", "--bag", bag, "topic", "echo", "/tf"]
        ended = subprocess.run([sys.executable, "-c", code, *words], stdout=full, stderr=subprocess.PIPE, text=True)
    assert ended.stderr.splitlines()[0] == "ros2: [Errno 28] No space left on device"
    assert ended.returncode != 0


def test_where_one_may_not_write_is_one_line(tmp_path, capsys):
    (tmp_path / "page.ipynb").write_text('{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}')
    (tmp_path / "file").touch()
    assert main(["export", str(tmp_path / "page.ipynb"), "--out", str(tmp_path / "file" / "site")]) == 2
    assert capsys.readouterr().err.startswith(f"tflab export: {tmp_path / 'file'}")
    with open("/dev/full", "w") as full:
        code = "import sys; from tflab.cli import main; sys.exit(main())"
        ended = subprocess.run([sys.executable, "-c", code, "-h"], stdout=full, stderr=subprocess.PIPE, text=True)
    assert (ended.returncode, ended.stderr) == (2, "tflab -h: No space left on device\n")


def test_closed_outputs_are_no_fault():
    code = "import sys; from tflab.cli import main; sys.exit(main(['-h']) or main(['nothing']))"
    assert subprocess.run(["sh", "-c", 'exec "$0" -c "$1" >&- 2>&-', sys.executable, code]).returncode == 2


@pytest.mark.parametrize(
    ("files", "last", "code"),
    [
        (["ask.py"], "neither slept nor spun: interrupted at ask.py:2 in <module>.", 0),  # a signal ends input()
        (["empty.py", "ask.py"], "went on after it was interrupted, at ask.py:2 in <module>.", 1),  # in another thread
    ],
)
def test_a_node_that_waits_for_the_keyboard_does_not_keep_the_shell(files, last, code, tmp_path):
    (tmp_path / "ask.py").write_text("print('asking', flush=True)\ninput()\n")
    (tmp_path / "empty.py").touch()
    process = tflab("run", *files, stdin=subprocess.PIPE, cwd=tmp_path)
    while "asking" not in process.stdout.readline():
        assert process.poll() is None
    for _ in range(1 + code):  # the second one ends the patience
        time.sleep(1.0)  # a signal that comes before input() waits would not end it
        process.send_signal(signal.SIGINT)
    assert process.wait(timeout=60) == code
    assert process.stderr.read().splitlines()[-1] == f'participant "ask" {last}'


@pytest.mark.parametrize(("words", "reason"), CASES["options_of_a_bag"])
def test_wrong_options_of_a_bag_are_explained(words, reason, capsys):
    with pytest.raises(SystemExit):
        plan(["bag", *words])
    assert capsys.readouterr().err.splitlines()[-1] == f"ros2 bag {words[0]}: error: argument {reason}"


def test_a_terminal_that_lacks_a_letter_shows_its_number(tmp_path):
    (tmp_path / "hangul.py").write_text("print('발행')\n", encoding="utf-8")
    process = tflab("run", "hangul.py", cwd=tmp_path, env=os.environ | {"PYTHONIOENCODING": "ascii"})
    assert process.communicate(timeout=30) == ("\\ubc1c\\ud589\n", "")
    assert process.returncode == 0
