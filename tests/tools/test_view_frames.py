"""What view_frames writes: to the letter."""

import re

import yaml

from tflab.tools.page import run_words
from tflab.tools.view_frames import dot_from_frames, parser

from .robot import fixed

ANSWER = """\
laser_frame: 
  parent: 'base_link'
  broadcaster: 'default_authority'
  rate: 10000.000
  most_recent_transform: 0.000000
  oldest_transform: 0.000000
  buffer_length: 0.000
base_link: 
  parent: 'odom'
  broadcaster: 'default_authority'
  rate: 20.164
  most_recent_transform: 5.950000
  oldest_transform: 1.050000
  buffer_length: 4.900
"""  # noqa: W291 - as tf2 writes it


def test_a_frame_is_an_edge_with_a_label():
    assert dot_from_frames(yaml.safe_load(ANSWER), 6.0) == (
        "digraph G {\n"
        '"base_link" -> "laser_frame"[label=" Broadcaster: default_authority\\nAverage rate: 10000.0\\n'
        'Buffer length: 0.0\\nMost recent transform: 0.0\\nOldest transform: 0.0\\n"];\n'
        '"odom" -> "base_link"[label=" Broadcaster: default_authority\\nAverage rate: 20.164\\n'
        'Buffer length: 4.9\\nMost recent transform: 5.95\\nOldest transform: 1.05\\n"];\n'
        "edge [style=invis];\n"
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
        '"Recorded at time: 6.0"[ shape=plaintext ] ;\n'
        '}->"odom";\n'
        "}"
    )


def test_the_legend_hangs_on_the_last_root_and_a_name_may_be_a_number():
    frames = yaml.safe_load(ANSWER + ANSWER.replace("base_link", "b2").replace("odom", "odm").replace("laser", "l2"))
    assert dot_from_frames(frames, 6.0).endswith('}->"odm";\n}')
    frames = yaml.safe_load(ANSWER.replace("laser_frame:", "7:"))
    assert '"base_link" -> "7"[label=' in dot_from_frames(frames, 6.0)
    assert dot_from_frames(yaml.safe_load("[]"), 6.0) == 'digraph G { "No tf data received" }'


def test_its_options():
    options = parser().parse_args([])
    assert (options.wait_time, options.output) == (5.0, None)
    assert parser().parse_args(["-t", "2", "-o", "tree"]).output == "tree"
    help_text = parser().format_help()
    assert help_text.startswith("usage: view_frames [-h] [--wait-time WAIT_TIME] [-o OUTPUT]")
    assert "Create a diagram of the TF frames being broadcast over ROS" in help_text


def test_where_nothing_can_be_written_it_says_so(terminal):
    terminal.type("run tf2_tools view_frames -t 0 -o /nope/frames")
    assert terminal.error.splitlines()[-1] == "/nope/frames.gv: cannot be written (No such file or directory)"
    assert terminal.exit_code == 1
    terminal.type("run tf2_tools view_frames --nope")
    assert "view_frames: error: unrecognized arguments: --nope" in terminal.error
    assert terminal.exit_code == 2


def test_the_picture_shows_what_the_gv_says_and_no_more(graph, tmp_path):
    graph.start(fixed("odm", "base_link"))
    graph.start(fixed("odom", "base_link"))
    stem = str(tmp_path / "frames")
    (picture,) = run_words(graph, ["run", "tf2_tools", "view_frames", "-o", stem]).pictures
    edges = re.findall(r'"(\w+)" -> "(\w+)"', (tmp_path / "frames.gv").read_text())
    assert edges == re.findall(r'"(\w+)" -> "(\w+)"', picture.text) == [("odom", "base_link")]
    assert "odm" not in picture.svg
    assert picture.faults == ()
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF-")
