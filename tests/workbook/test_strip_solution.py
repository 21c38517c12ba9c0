"""What is removed to turn a solution into an exercise, what stays, and what is refused."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
import yaml

from tflab.workbook.tasks.strip_solution import BlankError, blank

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_region_is_removed_and_the_rest_stays(case: dict[str, str]) -> None:
    assert blank(case["solution"]) == case["exercise"]
    ast.parse(case["exercise"])


def test_a_region_that_cannot_be_removed_is_refused() -> None:
    for source, wrong in (
        ("# BEGIN SOLUTION\nx = 1", 'has no "# END SOLUTION"'),
        ("x = 1\n# END SOLUTION", 'has no "# BEGIN SOLUTION"'),
        ("# BEGIN SOLUTION\n# BEGIN SOLUTION\nx = 1\n# END SOLUTION", "stands inside another"),
        ("# BEGIN SOLUTION\nprint(1)\n# END SOLUTION", "assigns nothing"),
        ("# BEGIN SOLUTION\ndef f():\n    return 1\n# END SOLUTION", "the whole of f stands in the region"),
        ("# BEGIN SOLUTION\nx = (\n# END SOLUTION", "is not Python"),
    ):
        with pytest.raises(BlankError, match=wrong):
            blank(source)
