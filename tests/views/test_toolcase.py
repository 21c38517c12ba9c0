"""A question put to a tool: what it printed, and whether that is an answer."""

from __future__ import annotations

import pytest

from tflab.views.fault_tables import Suitability, ToolOutput, draw_tools
from tflab.views.panels import tools_panel

TOOLS = [
    ToolOutput("echo", "ros2 run tf2_ros tf2_echo a b", "At time 1.0"),
    ToolOutput("hz", "ros2 topic hz /tf", "50"),
]
VERDICTS = {
    "value": {"echo": Suitability("answers", "the pose"), "hz": Suitability("cannot", "it counts")},
    "rate": {"echo": Suitability("cannot", "its own rate"), "hz": Suitability("half", "of everybody")},
}
ASKED = {"value": "Where is b?", "rate": "How often?"}


@pytest.fixture
def panel():
    made = tools_panel(ASKED, TOOLS, VERDICTS, ("question", "tool"))
    yield made
    made.close()


def said(panel):
    return panel.widget.children[2].value


def test_a_panel_shows_what_the_tool_printed_and_says_whether_it_answers(panel):
    assert panel.text == "value: ✓ answers. the pose\n$ ros2 run tf2_ros tf2_echo a b\nAt time 1.0"
    assert said(panel) == "<b>✓</b> the pose"


def test_another_question_or_tool_has_another_verdict(panel):
    panel.controls["question"].value = "rate"
    assert said(panel) == "<b>✗</b> its own rate"
    panel.controls["tool"].index = 1
    assert said(panel) == "<b>~</b> of everybody" and "$ ros2 topic hz /tf\n50" in panel.text


def test_both_menus_change_the_picture(panel):
    seen = {panel.picture.live_png()}
    panel.controls["question"].value = "rate"
    seen.add(panel.picture.live_png())
    panel.controls["tool"].index = 1
    seen.add(panel.picture.live_png())
    assert len(seen) == 3


def test_a_missing_verdict_is_refused():
    with pytest.raises(ValueError, match="no verdict on 'hz' for 'rate'"):
        tools_panel(ASKED, TOOLS, {**VERDICTS, "rate": {"echo": Suitability("half", "")}}, ("question", "tool"))


def test_the_table_says_in_words_who_answers_what():
    assert draw_tools(VERDICTS).text == "value: answers echo; cannot hz\nrate: half hz; cannot echo"


def test_the_table_has_a_sign_for_each_pair():
    texts = [text.get_text() for text in draw_tools(VERDICTS).figure.texts]
    assert texts[:2] == ["echo", "hz"]
    assert texts[2:8] == ["value", "✓", "✗", "rate", "✗", "~"]


def test_a_long_line_is_folded_as_a_terminal_does_it():
    tool = ToolOutput("echo", "x", "a" * 100 + "\n" + "\n".join("b" * 30))
    panel = tools_panel({"value": "?"}, [tool], {"value": {"echo": Suitability("half", "")}}, ("question", "tool"))
    rows = panel.picture._output.text.split("\n")
    assert rows[:2] == ["a" * 92, "a" * 8] and rows[-1] == "..." and len(rows) == 20
    panel.close()
