"""A tool in a page: how long it runs, that it always ends, and what can be completed."""

from pathlib import Path

import pytest
import yaml
from IPython.core.completer import provisionalcompleter
from IPython.core.interactiveshell import InteractiveShell

from tflab.tools import magic
from tflab.tools.magic import Known, complete, known_in
from tflab.tools.page import LineError, run_words, split_line, words_of_line

from .robot import fixed, moving

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

KNOWN = Known(
    frames=["base_link", "map", "odom"],
    topics=["/tf", "/tf_static"],
    nodes=["/ekf", "/point_to_map"],
    parameters={"/ekf": ["use_sim_time"]},
)


@pytest.mark.parametrize(("line", "seconds", "words"), CASES["lines"])
def test_a_line_is_a_time_and_words(line, seconds, words):
    assert split_line(line) == (seconds, words)


@pytest.mark.parametrize(("line", "text"), CASES["faulty_lines"])
def test_a_line_that_cannot_be_read_is_explained(line, text):
    with pytest.raises(LineError, match=text):
        split_line(line)


def test_time_passes_only_while_the_tool_runs(graph):
    graph.start(moving())
    run_words(graph, ["topic", "list"])
    assert graph.now_ns == 1_000_000_000
    run_words(graph, ["topic", "hz", "/tf"], seconds=2.0)
    assert graph.now_ns == 3_000_000_000
    assert [each.name for each in graph.participants if each.is_running] == ["main"]


def test_a_tool_follows_its_own_ros_arguments(terminal):
    terminal.graph.start(fixed())
    terminal.graph.start(moving())
    out = terminal.type("--for 2.5 run tf2_ros tf2_echo odom base_link --ros-args -r __node:=other")
    assert "[other]: Waiting for transform odom ->  base_link" in out + terminal.error


@pytest.mark.parametrize(("line", "code", "text"), CASES["wrong_words"])
def test_wrong_words_are_answered_as_ros2_answers(terminal, line, code, text):
    terminal.type(line)
    assert text in terminal.error
    assert terminal.exit_code == code


def test_help_is_no_error(terminal):
    for line in ("", "-h", "topic", "topic -h", "topic echo --help", "run -h"):
        assert terminal.type(line).startswith("usage: ros2")
        assert terminal.exit_code == 0


# -- completion -----------------------------------------------------------


def test_what_can_stand_there():
    for line, begun, found in CASES["completions"]:
        assert complete(line.split(), begun, KNOWN) == found, line


def test_what_a_graph_has_to_be_named(graph):
    graph.start(moving())
    graph.start(fixed())
    graph.run(seconds=0.1)
    known = known_in(graph)
    assert known.frames == ["base_link", "laser_frame", "odom"]
    assert known.nodes == ["/moving_robot_broadcaster", "/static_sensor_broadcaster"]
    assert "/tf_static" in known.topics
    assert known.parameters["/moving_robot_broadcaster"] == ["use_sim_time"]


@pytest.fixture
def shell(graph):
    made = InteractiveShell()
    magic.register(made)
    return made


def test_a_second_cell_sees_the_nodes_that_the_first_one_started(shell, graph, capsys):
    shell.user_ns |= {"graph": graph, "main": moving()}
    shell.run_cell("graph.start(main); graph.run(seconds=1)")
    shell.run_cell("%ros2 --for 1.5 run tf2_ros tf2_echo \\\n  odom \\\n  base_link")
    assert "At time 2.950000000\n- Translation: [1.950, 0.000, 0.000]\n" in capsys.readouterr().out


def test_the_magic_explains_a_bad_line_and_does_not_raise(shell, capsys):
    shell.run_line_magic("ros2", "--for x topic list")
    shell.run_line_magic("ros2", "nope")
    captured = capsys.readouterr()
    assert captured.out.startswith("--for needs a time in seconds")
    assert "invalid choice: 'nope'" in captured.out and not captured.err  # a terminal shows both in one


def test_the_notebook_completes_topics_and_frames(shell, graph):
    graph.start(moving())
    graph.run(seconds=0.1)
    for line, word in [
        ("%ros2 topic echo /t", "/tf"),
        ("%ros2 run tf2_ros tf2_echo od", "odom"),
        ("%ros2 to", "topic"),
    ]:
        with provisionalcompleter():
            assert word in [each.text for each in shell.Completer.completions(line, len(line))]


def test_the_stop_button_between_two_steps_stops_everything(graph, monkeypatch):
    graph.start(moving())

    def pressed(seconds):
        raise KeyboardInterrupt

    monkeypatch.setattr(graph, "run", pressed)
    with pytest.raises(KeyboardInterrupt):
        run_words(graph, ["run", "tf2_ros", "tf2_echo", "odom", "base_link"])
    assert [each.name for each in graph.participants if each.is_running] == []


def test_on_windows_a_backslash_is_part_of_a_path():
    line = r'ros2 bag info "C:\Users\kim\my drive" -o D:\tmp\new'
    words = words_of_line(line, backslash_escapes=False)
    assert words == ["ros2", "bag", "info", r"C:\Users\kim\my drive", "-o", r"D:\tmp\new"]
    assert words_of_line(r"echo a\ b  # said", comments="#", backslash_escapes=True) == ["echo", "a b"]


def test_a_tool_with_an_ampersand_runs_beside_the_page(terminal, tmp_path, monkeypatch):
    terminal.graph.start(moving())
    monkeypatch.chdir(tmp_path)
    terminal.type("ros2 --for 3 bag record /tf -o drive")
    terminal.graph.stop()
    assert terminal.type("ros2 bag play drive --loop &") == ""
    assert terminal.exit_code is None
    assert terminal.type("ros2 node list") == "/rosbag2_player\n"
    assert "Publisher count: 1" in terminal.type("ros2 topic info /tf")
    assert "At time" in terminal.type("ros2 run tf2_ros tf2_echo odom base_link")


def test_an_ampersand_with_a_time_ends_after_it(terminal):
    terminal.graph.start(moving())
    terminal.type("ros2 --for 2 topic hz /tf &")
    tool = terminal.graph.participants[-1]
    terminal.graph.run(seconds=1.9)
    assert tool.is_running
    terminal.graph.run(seconds=0.2)
    assert not tool.is_running


def test_the_first_cell_of_a_page_begins_a_new_world_whenever_it_runs(capsys, undone):
    shell = InteractiveShell.instance()
    try:
        said = []
        for _ in range(2):
            shell.run_cell("%load_ext tflab")
            shell.run_cell("import rclpy\nrclpy.init()\ngraph.run(seconds=1.5)\nprint(graph.now_ns)")
            said.append(capsys.readouterr().out)
        assert said[0] == said[1]
        assert said[0].startswith("tflab: in-process ROS 2")
    finally:
        InteractiveShell.clear_instance()
