"""Formulas become MathML; a dollar that is a shell's stays one."""

import pytest

from tflab.views.export import with_mathml

pytest.importorskip("latex2mathml", reason="no latex2mathml: pip install 'tflab[lab]'")


def test_a_formula_in_a_line_and_one_on_its_own():
    text = with_mathml("It turns by $\\theta$.\n\n$$p = R q + t$$\n")
    assert text.startswith('It turns by <math xmlns="http://www.w3.org/1998/Math/MathML" display="inline">')
    assert 'display="block"' in text
    assert "$" not in text


@pytest.mark.parametrize(
    "text",
    [
        "in xacro: `${pi/2}` and `$HOME`",
        "```\n$ ros2 topic list $x$\n```",
        "    $ source $HOME/setup.bash $x$",
        "it costs 5$ or 6$ a piece",
        r"a price of \$5 and \$6",
    ],
)
def test_code_and_prices_stay_as_they_are(text):
    assert with_mathml(text) == text
