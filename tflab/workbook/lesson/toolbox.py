"""Compare seven ROS 2 tools on the current robot: which of seven questions does each one answer?

```
tools_panel()        put a question to a tool, in the language of the copy
draw_toolbox()       the same as a table
say_tools(...)       the outputs themselves
```

`toolbox.yaml` holds the questions and the verdicts.
"""

from __future__ import annotations

import io
import tempfile
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

from tflab.ros.graph import Graph, current_graph
from tflab.tools.page import run_words
from tflab.tools.rviz import look
from tflab.views import panels
from tflab.views.fault_tables import Suitability, ToolOutput, draw_tools
from tflab.views.panels import Panel
from tflab.views.picture import Picture
from tflab.views.rviz_status import look_through, statuses_as_text

from ...text import Text, language_of_workbook, load_yaml

CHAIN = ("odom", "base_footprint", "base_link", "laser_frame")
NAMES = Text(en="question / tool", ko="질문 / 도구")

COMMANDS = {
    "view_frames": "ros2 run tf2_tools view_frames",
    "tf2_echo": "ros2 run tf2_ros tf2_echo map laser_frame",
    "tf2_monitor": "ros2 run tf2_ros tf2_monitor map laser_frame",
    "topic hz": "ros2 topic hz /tf",
    "topic delay": "ros2 topic delay /scan",
    "topic info": "ros2 topic info /tf --verbose",
    "RViz": "rviz2 -f map",
}

FOUND = load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
ASKED = {term: Text(**text) for term, text in FOUND["questions"].items()}
BLIND = {tool: Text(**text) for tool, text in FOUND["blind"].items()}
REPLIES = {(row["question"], row["tool"]): (row["level"], Text(row["en"], row["ko"])) for row in FOUND["replies"]}


def _verdicts(language: str) -> dict[str, dict[str, Suitability]]:
    return {
        term: {
            tool: Suitability(level, why.say(language))
            for tool in COMMANDS
            for level, why in [REPLIES.get((term, tool), ("cannot", BLIND[tool]))]
        }
        for term in ASKED
    }


VERDICTS = _verdicts("en")


def say_tools(graph: Graph | None = None) -> list[ToolOutput]:
    """Return what each tool says of a robot, the current graph's if None; about 25 s of its time pass."""
    graph = current_graph() if graph is None else graph
    return [ToolOutput(name, command, _said_by(graph, name, command)) for name, command in COMMANDS.items()]


def tools_panel() -> Panel:
    """Return a panel that puts questions to tools on the current robot, in the language of this copy."""
    language = language_of_workbook()
    asked = {term: words.say(language) for term, words in ASKED.items()}
    names = tuple(NAMES.say(language).split(" / "))
    return panels.tools_panel(asked, say_tools(), _verdicts(language), names)


def draw_toolbox() -> Picture:
    """Draw which tool answers which question, in full, half or not at all."""
    return draw_tools(VERDICTS)


def _said_by(graph: Graph, name: str, command: str) -> str:
    if name == "RViz":
        return statuses_as_text(look_through("map", *look(graph, seconds=4.0)))
    printed = io.StringIO()
    with tempfile.TemporaryDirectory() as folder, redirect_stdout(printed), redirect_stderr(printed):
        words = command.split()[1:] + (["-o", str(Path(folder) / "frames")] if name == "view_frames" else [])
        seconds = {"topic hz": 2.5, "topic delay": 2.5, "tf2_echo": 2.2}.get(name)
        pictures = run_words(graph, words, seconds).pictures
    if name == "view_frames":
        return _of_the_chain(pictures[0].text)
    if name == "topic info":
        rows = printed.getvalue().splitlines()
        return "\n".join(row for row in rows if row.startswith(("Type", "Publisher", "Node name", "Subscription")))
    rows = [row for row in printed.getvalue().splitlines() if row and "Waiting for transform" not in row]
    return "\n".join(rows)


def _of_the_chain(drawn: str) -> str:
    """Return the drawing's words for the edges of one chain, a figure on each line."""
    head, *edges = drawn.split("\n")
    kept = [edge for child in CHAIN[:2] + CHAIN[3:] for edge in edges if f'-> "{child}"' in edge]
    return "\n".join([head, *(edge.replace("  ", "\n    ", 1).replace(", ", "\n    ") for edge in kept)])
