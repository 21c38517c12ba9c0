"""Seven tools, seven questions: who answers what?  Real outputs of the current robot, and a verdict for each pair.

```
tools_panel()        put a question to a tool, in the language of the copy
draw_toolbox()       the same as a table, standing still
say_tools(...)       the outputs themselves
```
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

from ...text import Text
from ..paths import read_workbook, workbook_root

__all__ = ["ASKED", "COMMANDS", "VERDICTS", "draw_toolbox", "say_tools", "tools_panel"]

CHAIN = ("odom", "base_footprint", "base_link", "laser_frame")
NAMES = Text(en="question / tool", ko="질문 / 도구")

ASKED = {
    "frames": Text(en="Which frames are there, and in how many trees?", ko="어떤 좌표계가 있고, 트리는 몇 개입니까?"),
    "value": Text(en="Where is laser_frame in map, in numbers?", ko="map 기준 laser_frame의 위치는 숫자로 얼마입니까?"),
    "rate": Text(en="How often does odom → base_footprint come?", ko="odom → base_footprint는 얼마나 자주 옵니까?"),
    "delay": Text(
        en="How late is the chain from map to laser_frame?", ko="map에서 laser_frame까지의 사슬은 얼마나 늦습니까?"
    ),
    "age": Text(en="How old is a scan when it arrives?", ko="스캔은 도착했을 때 얼마나 오래된 것입니까?"),
    "owner": Text(en="Which node sends odom → base_footprint?", ko="odom → base_footprint는 어느 노드가 보냅니까?"),
    "look": Text(en="Does the scan lie on the walls?", ko="스캔이 벽 위에 놓입니까?"),
}

COMMANDS = {
    "view_frames": "ros2 run tf2_tools view_frames",
    "tf2_echo": "ros2 run tf2_ros tf2_echo map laser_frame",
    "tf2_monitor": "ros2 run tf2_ros tf2_monitor map laser_frame",
    "topic hz": "ros2 topic hz /tf",
    "topic delay": "ros2 topic delay /scan",
    "topic info": "ros2 topic info /tf --verbose",
    "RViz": "rviz2 -f map",
}

BLIND = {
    "view_frames": Text(
        en="Blind here. It draws five seconds of names, parents, rates and ages; values and messages it never "
        "looks at, and its broadcaster is default_authority for everybody.",
        ko="답하지 못합니다. 5초 동안의 이름, 부모, 발행률, 시각만 그립니다. 값과 메시지는 보지 않고, "
        "broadcaster는 누구나 default_authority입니다.",
    ),
    "tf2_echo": Text(
        en="Blind here. It prints one value of one pair, as often as it likes itself: nothing of rates, messages "
        "or nodes.",
        ko="답하지 못합니다. 한 쌍의 값 하나를 정해진 간격으로 출력할 뿐, 발행률도 메시지도 노드도 모릅니다.",
    ),
    "tf2_monitor": Text(
        en="Blind here. It measures now minus stamp; it sees no values and no messages, and everybody is <no "
        "authority available>.",
        ko="답하지 못합니다. 현재 시각에서 측정 시각을 뺄 뿐입니다. 값도 메시지도 보지 않고, 발행자는 누구나 <no "
        "authority available>입니다.",
    ),
    "topic hz": Text(
        en="Blind here. It counts messages and does not open them.",
        ko="답하지 못합니다. 메시지를 열지 않고 세기만 합니다.",
    ),
    "topic delay": Text(
        en="Blind here. It reads the header of one topic's messages, and /tf has none of its own: try it.",
        ko="답하지 못합니다. 한 토픽의 메시지 헤더만 읽는데, /tf 메시지에는 헤더가 없습니다. 직접 실행해 보세요.",
    ),
    "topic info": Text(
        en="Blind here. It knows who publishes and subscribes, and looks into no message.",
        ko="답하지 못합니다. 누가 발행하고 구독하는지만 알고, 메시지 안은 보지 않습니다.",
    ),
    "RViz": Text(
        en="Blind here. It shows what could be computed, not how often it came, how late, or from whom.",
        ko="답하지 못합니다. 계산할 수 있었던 것을 보여 줄 뿐, 얼마나 자주 왔는지, 얼마나 늦었는지, 누가 "
        "보냈는지는 모릅니다.",
    ),
}

SAID = {
    ("frames", "view_frames"): ("answers", Text(
        en="Every frame with its parent; a frame that no arrow leads to is a root. One root: one tree.",
        ko="좌표계마다 부모가 나옵니다. 화살표가 들어오지 않는 좌표계가 루트이고, 루트가 하나면 트리도 하나입니다.",
    )),
    ("frames", "tf2_echo"): ("half", Text(
        en="Only of these two: a value means that there is a path between them.",
        ko="이 둘에 대해서만 압니다. 값이 나오면 둘 사이에 경로가 있는 것입니다.",
    )),
    ("frames", "tf2_monitor"): ("half", Text(
        en="Only the frames of this chain, in its third line.", ko="이 사슬의 좌표계만 나옵니다. Chain is: 줄입니다."
    )),
    ("frames", "RViz"): ("half", Text(
        en="It lists the frames that it has heard of and marks those that do not reach the Fixed Frame; the tree "
        "itself you have to guess.",
        ko="들어 본 좌표계를 나열하고 Fixed Frame에 닿지 않는 것을 표시합니다. 트리 모양은 짐작해야 합니다.",
    )),
    ("value", "tf2_echo"): ("answers", Text(
        en="The pose of laser_frame in map: translation, quaternion, roll-pitch-yaw, matrix, and the stamp it "
        "holds for.",
        ko="map 기준 laser_frame의 포즈입니다. 이동, 쿼터니언, roll-pitch-yaw, 행렬과 그 시각이 나옵니다.",
    )),
    ("value", "RViz"): ("half", Text(
        en="To the eye: ten centimetres you see, one you do not.",
        ko="눈대중으로는 압니다. 10 cm는 보이지만 1 cm는 보이지 않습니다.",
    )),
    ("rate", "view_frames"): ("answers", Text(
        en="Average rate, of each edge on its own. It divides n samples by the time between the first and the "
        "last, so 20 Hz reads 20.2.",
        ko="연결마다 따로 재는 Average rate입니다. 표본 n개를 첫 표본과 마지막 표본 사이의 시간으로 나누므로 20 "
        "Hz가 20.2로 나옵니다.",
    )),
    ("rate", "tf2_monitor"): ("cannot", Text(
        en="The Hz below All Broadcasters is everybody's together: 20 + 20 + 10 here. Of one edge it says nothing.",
        ko="All Broadcasters 아래의 Hz는 모두를 합친 값입니다. 여기서는 20 + 20 + 10입니다. 연결 하나에 대해서는 "
        "알려 주지 않습니다.",
    )),
    ("rate", "topic hz"): ("half", Text(
        en="It counts all messages on /tf, of three nodes here. Only where one node is alone on a topic is that "
        "its rate.",
        ko="/tf의 메시지를 모두 셉니다. 여기서는 세 노드의 것입니다. 노드가 하나뿐일 때만 그 노드의 발행률입니다.",
    )),
    ("delay", "view_frames"): ("half", Text(
        en="Subtract Most recent transform from the time of recording, edge by edge: one moment of it.",
        ko="기록 시각에서 연결마다 Most recent transform을 빼면 됩니다. 다만 한순간의 값입니다.",
    )),
    ("delay", "tf2_echo"): ("half", Text(
        en="At time is the chain's newest common stamp. What time it is now, it does not print.",
        ko="At time이 사슬의 최신 공통 시각입니다. 지금이 몇 시인지는 출력하지 않습니다.",
    )),
    ("delay", "tf2_monitor"): ("answers", Text(
        en="Yes: Net delay max for the chain, and a line for each frame. Not avg, which begins at 0; and a static "
        "frame's line means nothing.",
        ko="답합니다. 사슬은 Net delay의 max를, 좌표계는 저마다의 줄을 봅니다. avg는 0에서 시작하므로 아니고, 정적 "
        "좌표계의 줄은 뜻이 없습니다.",
    )),
    ("age", "topic delay"): ("answers", Text(
        en="Now minus header.stamp, message by message. The laser's sweep takes 0.1 s, so 0.105 s is healthy here.",
        ko="메시지마다 현재 시각에서 header.stamp를 뺍니다. 레이저가 한 바퀴 도는 데 0.1초가 걸리므로 여기서는 "
        "0.105초가 정상입니다.",
    )),
    ("age", "RViz"): ("half", Text(
        en="Old scans smear when the robot turns. By how many seconds, you do not see.",
        ko="오래된 스캔은 로봇이 돌 때 번집니다. 몇 초인지는 보이지 않습니다.",
    )),
    ("owner", "topic info"): ("half", Text(
        en="Who publishes on /tf: three nodes. Which of them sends which edge is written nowhere; stop one, and "
        "see what goes missing.",
        ko="/tf에 발행하는 노드 세 개를 알려 줍니다. 어느 노드가 어느 연결을 보내는지는 어디에도 없습니다. 하나를 "
        "멈추고 무엇이 사라지는지 봅니다.",
    )),
    ("look", "RViz"): ("answers", Text(
        en="This is what it is for: put the map beneath, and look. Its list would say Ok in any case.",
        ko="이것이 RViz의 일입니다. 지도를 깔고 눈으로 봅니다. 목록은 어느 경우에나 Ok일 것입니다.",
    )),
}  # fmt: skip


def _verdicts(language: str) -> dict[str, dict[str, Suitability]]:
    return {
        term: {
            tool: Suitability(level, why.say(language))
            for tool in COMMANDS
            for level, why in [SAID.get((term, tool), ("cannot", BLIND[tool]))]
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
    language = read_workbook(workbook_root()).language
    asked = {term: words.say(language) for term, words in ASKED.items()}
    names = tuple(NAMES.say(language).split(" / "))
    return panels.tools_panel(asked, say_tools(), _verdicts(language), names, language)


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
