"""A reply is a card in a notebook and a line of text anywhere else, and nothing of an answer runs in it."""

from __future__ import annotations

from IPython.core.interactiveshell import InteractiveShell

from tflab.text import Text
from tflab.workbook import reply_card
from tflab.workbook.reply_card import as_html, show_reply


def test_in_a_notebook_it_is_a_card_that_has_the_same_text_beside_it(monkeypatch):
    shown = []
    monkeypatch.setattr(reply_card, "in_notebook", lambda: True)
    monkeypatch.setattr("IPython.display.display", lambda data, raw: shown.append(data))
    show_reply("E3.2 ✓ 1/1", more=["well done"], kind="passed")
    assert shown[0]["text/plain"] == "E3.2 ✓ 1/1\nwell done"
    assert "<strong>E3.2 ✓ 1/1</strong><br><small>well done</small>" in shown[0]["text/html"]


def test_code_is_set_as_code_and_what_an_answer_held_stays_text():
    more = ['hint("E3.2") helps.', "called as invert({x: (1.0, 2.0)})."]
    card = as_html("E3.2 ✗ 0/1", 'apply `base_T_laser`: it gave "<script>"', more, "wrong")
    assert "<code>base_T_laser</code>" in card
    assert "<script>" not in card and '"&lt;script&gt;"' in card
    assert '<code>hint("E3.2")</code> helps.' in card
    assert "<code>invert({x: (1.0, 2.0)})</code>." in card


def test_stressed_words_are_set_so_and_products_are_not():
    card = as_html("E3.2 ✗ 0/1", "only *one*, *둘 다*; 2 * x * 3, a*b*c and `*args, *more`", (), "wrong")
    assert "Only <em>one</em>, <em>둘 다</em>; 2 * x * 3, a*b*c and <code>*args, *more</code>" in card


def test_what_is_said_of_each_part_has_a_line_of_its_own(capsys):
    said = '"a", "b": turned the wrong way. "c": is "x": "y" a name? Look again. 그렇습니다. "d[0]": look again.'
    show_reply("E1.2 ✗ 1/4", said, ["once more"], "wrong")
    lines = [
        '"a", "b": turned the wrong way.',
        '"c": is "x": "y" a name? Look again. 그렇습니다.',
        '"d[0]": look again.',
    ]
    assert capsys.readouterr().out.splitlines() == ["E1.2 ✗ 1/4:", *lines, "once more"]
    assert "<br>".join(lines) in as_html("E1.2 ✗ 1/4", said, (), "wrong")


def test_a_shell_without_a_kernel_gets_text():
    InteractiveShell.instance()
    try:
        assert not reply_card.in_notebook()
    finally:
        InteractiveShell.clear_instance()


def test_a_reply_begins_as_a_sentence_does_and_leaves_names_as_they_are():
    said = ("you swapped x and y", "base_link에 서 있다고", "nanosec을 소수점", "map is the target", "odom: late")
    begins = [as_html("E1.1", text, [], "wrong").partition("<br>")[2][:2] for text in said]
    assert begins == ["Yo", "ba", "na", "ma", "od"]


def test_what_fills_a_text_is_in_its_language_where_it_has_one():
    said = Text(en="in {part}, {count} of them: {tip}", ko="{part}에서 {count}개: {tip}")
    filled = said.filled(part="yaw", count=2, tip=Text(en="look {again}", ko="다시"))
    assert filled == Text(en="in yaw, 2 of them: look {again}", ko="yaw에서 2개: 다시")
