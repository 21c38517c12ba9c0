"""What was learnt between two tests: four states, in the picture and in words."""

import pytest

from tflab.views.slope_chart import describe_gain, draw_gain

BEFORE = {"1": "wrong", "2": "right", "3": "gap", "4": "guessed right"}
AFTER = {"1": "right", "2": "right", "3": "wrong", "4": "gap"}


def test_the_words_say_of_each_row_what_was_known_and_what_became_of_it():
    assert describe_gain(BEFORE, AFTER).splitlines() == [
        "1  wrong, sure    -> right, sure     cured",
        "2  right, sure    -> right, sure     held",
        "3  not known      -> wrong, sure     stuck",
        "4  right, guessed -> not known       lost",
        "cured 1 · held 1 · stuck 1 · lost 1",
    ]


def test_the_picture_says_the_same_and_only_what_was_cured_stands_out():
    picture = draw_gain(BEFORE, AFTER)
    assert picture.text == describe_gain(BEFORE, AFTER)
    texts = {text.get_text(): text.get_weight() for text in picture.figure.axes[0].texts}
    assert [name for name, weight in texts.items() if weight == "bold"] == ["1", "cured"]
    assert picture.png() == draw_gain(BEFORE, AFTER).png()


def test_two_tests_with_other_rows_and_a_mark_of_no_kind_are_refused():
    with pytest.raises(ValueError, match="the same rows"):
        draw_gain(BEFORE, {"1": "right"})
    with pytest.raises(ValueError, match="the same rows"):
        draw_gain({}, {})
    with pytest.raises(ValueError, match="lucky: there is right, guessed right, gap, wrong"):
        draw_gain({"1": "lucky"}, {"1": "right"})
