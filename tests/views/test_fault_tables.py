"""Tables of suspects and tools."""

from __future__ import annotations

import pytest

from tflab.views.fault_tables import (
    Suitability,
    ToolOutput,
    describe_suspects,
    draw_suspects,
    draw_tools,
)
from tflab.views.panels import tools_panel

TABLE = {
    "clock ahead": {"delay /scan": "ahead", "hz /odom": "as on the card", "hz /scan": "as on the card"},
    "late": {"delay /scan": "as on the card", "hz /odom": "trembles", "hz /scan": "as on the card"},
    "slow": {"delay /scan": "as on the card", "hz /odom": "too seldom", "hz /scan": "as on the card"},
}


def test_the_words_say_who_is_left_and_which_questions_tell_something():
    assert describe_suspects(TABLE, {"delay /scan": "as on the card"}).splitlines() == [
        "2 of 3 suspects left",
        "  clock ahead  ruled out: delay /scan would be ahead",
        "  late         left",
        "  slow         left",
        "asked: delay /scan: as on the card",
        "not asked: hz /odom: would tell 2 apart",
        "not asked: hz /scan: nothing",
    ]


def test_a_struck_row_has_a_line_through_it_and_an_unasked_column_is_hatched():
    picture = draw_suspects(TABLE, {"delay /scan": "ahead"})
    assert len(picture.ax.lines) == 2
    assert sum(patch.get_hatch() is not None for patch in picture.ax.patches) == 6
    picture.tell({"delay /scan": "ahead", "hz /odom": "as on the card"})
    assert sum(patch.get_hatch() is not None for patch in picture.ax.patches) == 3
    assert picture.text.startswith("1 of 3 suspects left")


def test_what_is_no_column_is_refused():
    with pytest.raises(ValueError, match="nobody to suspect"):
        draw_suspects({})
    with pytest.raises(ValueError, match=r"no column 'tape'; there is delay /scan"):
        draw_suspects(TABLE, {"tape": "x"})


TOOLS = [
    ToolOutput("echo", "ros2 run tf2_ros tf2_echo a b", "At time 1.0"),
    ToolOutput("hz", "ros2 topic hz /tf", "50"),
]
VERDICTS = {
    "value": {"echo": Suitability("answers", "the pose"), "hz": Suitability("cannot", "it counts")},
    "rate": {"echo": Suitability("cannot", "its own rate"), "hz": Suitability("half", "of everybody")},
}
ASKED = {"value": "Where is b?", "rate": "How often?"}


def test_a_panel_shows_what_the_tool_printed_and_says_whether_it_answers():
    panel = tools_panel(ASKED, TOOLS, VERDICTS, ("question", "tool"))
    said = panel.widget.children[2]
    assert panel.text == "value: ✓ answers. the pose\n$ ros2 run tf2_ros tf2_echo a b\nAt time 1.0"
    assert said.value == "<b>✓</b> the pose"
    panel.controls["question"].value = "rate"
    assert said.value == "<b>✗</b> its own rate"
    panel.controls["tool"].index = 1
    assert said.value == "<b>~</b> of everybody" and "$ ros2 topic hz /tf\n50" in panel.text
    panel.close()
    with pytest.raises(ValueError, match="no verdict on 'hz' for 'rate'"):
        tools_panel(ASKED, TOOLS, {**VERDICTS, "rate": {"echo": Suitability("half", "")}}, ("question", "tool"))


def test_the_table_has_a_sign_for_each_pair_and_says_in_words_who_answers_what():
    picture = draw_tools(VERDICTS)
    assert picture.text == "value: answers echo; cannot hz\nrate: half hz; cannot echo"
    texts = [text.get_text() for text in picture.figure.axes[0].texts]
    assert texts[:8] == ["echo", "hz", "value", "✓", "✗", "rate", "✗", "~"]


def test_a_long_line_is_folded_as_a_terminal_does_it():
    tool = ToolOutput("echo", "x", "a" * 100 + "\n" + "\n".join("b" * 30))
    panel = tools_panel({"value": "?"}, [tool], {"value": {"echo": Suitability("half", "")}}, ("question", "tool"))
    rows = panel.picture._output.text.split("\n")
    assert rows[:2] == ["a" * 92, "a" * 8] and rows[-1] == "..." and len(rows) == 20
    panel.close()
