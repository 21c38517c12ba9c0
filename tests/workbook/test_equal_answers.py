"""Which of many answers are the same: comparing them together gives what comparing each two gives."""

from __future__ import annotations

from itertools import permutations

import pytest

from tflab.workbook.answers.equal_answers import EqualAnswers
from tflab.workbook.answers.form import Form
from tflab.workbook.answers.forms import Angle, Choice, Number, Parts, Pose, Quaternion, Vector
from tflab.workbook.answers.values import Plain, raised

HALF = 0.7071067811865476
ODD: list[Plain] = [
    None,
    "map",
    {"unanswered": True},
    raised(ValueError("no")),
    1.0,
    1.0005,
    1.002,
    [1.0, 0.0, 0.0],
    {},
]


@pytest.mark.parametrize(
    ("form", "answers"),
    [
        (Number("m", 1e-3), [2.0, 2.0009, -2.0]),
        (Angle(1e-3), [3.1415, -3.1415, 9.4247, 0.0]),
        (Vector(3, "m", tolerance=0.005), [[1.0, 0.0, 0.004], [1.0, 0.0, 0.02], [-1.0, 0.0, 0.0]]),
        (Quaternion(), [[0, 0, HALF, HALF], [0, 0, -HALF, -HALF], [0, 0, HALF, -HALF], [0, 0, 0, 1], [0, 0, 0, -1]]),
        (Pose(), [{"Transform": [[1, 0, 0], [0, 0, s * HALF, s * HALF]]} for s in (1, -1)]),
        (Choice(("map", "odom")), ["odom", "MAP", "Odom "]),
        (
            Parts({"frame": Choice(("map", "odom")), "x": Number("m", 1e-3)}),
            [{"dict": {"frame": frame, "x": x}} for frame in ("map", "odom", "lamp") for x in (1.0, 1.0004, 2.0)],
        ),
    ],
)
def test_many_are_compared_as_each_two_are(form: Form, answers: list[Plain]) -> None:
    rows = [[answer, other] for answer in (*answers, *ODD) for other in (answers[0], answer)]
    equal_answers = EqualAnswers(form, rows)
    for one, other in permutations(range(len(rows)), 2):
        is_alike = all(map(form.comparing(), rows[one], rows[other]))
        assert equal_answers.has_equal([other], one) == is_alike, (rows[one], rows[other])
