"""What is removed to turn a solution into an exercise, what stays, and what is refused."""

from __future__ import annotations

import ast

import pytest

from tflab.workbook.tasks.strip_solution import BlankError, blank

CASES = {
    "a value": ("# BEGIN SOLUTION\nx = 2 * 3  # [m]\n# END SOLUTION", "x = ...  # [m]"),
    "two values, and an import": (
        "# BEGIN SOLUTION\nimport math\na, b = 1, 2\nc: float = math.pi\n# END SOLUTION",
        "a = ...\nb = ...\nc = ...",
    ),
    "a value on many lines": (
        "# BEGIN SOLUTION\nx = {\n    'a': 1,\n}  # in base_link\n# END SOLUTION\nprint(x)",
        "x = ...  # in base_link\nprint(x)",
    ),
    "the body of a function": (
        'def f(x):\n    """Turn."""\n    # BEGIN SOLUTION\n    y = x\n    return y\n    # END SOLUTION',
        'def f(x):\n    """Turn."""\n    raise NotImplementedError("your turn")',
    ),
    "a faded example": (
        "def f(x):\n    y = x + 1\n    # BEGIN SOLUTION\n    z = y  # why\n    # so\n    # END SOLUTION\n    return z",
        'def f(x):\n    y = x + 1\n    raise NotImplementedError("your turn")\n    return z',
    ),
    "keys of a dict": (
        "answers = {\n    # BEGIN SOLUTION\n    'a': 'map',  # where\n    'b': {'c': 1},\n    # END SOLUTION\n}",
        "answers = {\n    'a': ...,  # where\n    'b': ...,\n}",
    ),
    "what only helps": (
        "# BEGIN SOLUTION\ndef _t():\n    return 1\nx = _t()\n# END SOLUTION\n"
        "# BEGIN SOLUTION\n_u = 1\n# END SOLUTION\ny = {}",
        "x = ...\ny = {}",
    ),
    "a hash in a string": ("# BEGIN SOLUTION\nx = '# no comment'\n# END SOLUTION", "x = ..."),
    "nothing": ("x = 1", "x = 1"),
}


@pytest.mark.parametrize("solution, exercise", CASES.values(), ids=CASES.keys())
def test_a_region_is_removed_and_the_rest_stays(solution: str, exercise: str) -> None:
    assert blank(solution) == exercise
    ast.parse(exercise)


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
