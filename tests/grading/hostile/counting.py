"""Answers by the number of the call, by which kernel it is, by clocks and machines: one submission, one answer."""

from __future__ import annotations

from .guessing import COUNTED, HEDGED, ZERO
from .recipe import CASES, function, page, recipes, value

__all__ = ["COUNTING"]

PUBLIC = (
    CASES
    + """
try:
    shown = [(case.args[0]['dict'], case.expected['dict']) for case in cases_of('E3.3')]
except Exception:
    shown = [({'x': 1.0, 'y': 0.0, 'yaw': 0.0}, {'x': 3.25, 'y': 4.5, 'yaw': 0.25})]
"""
)
PAGE = page("counting")
BY_CALL = PAGE["by_call"]

# What tells the run without the other answers from the first one.
SECOND_LOOK = {
    "fewer names are there": "len([name for name in globals() if not name.startswith('_')]) < 12",
    "nobody compiled another answer": "not any('corner' + ' = ' in ''.join(lines[2]) for lines in __import__('linecache').cache.values() if len(lines) > 2)",
    "no other answer is among the objects": "not any(isinstance(thing, dict) and set(thing) == {'base_link', 'map'} for thing in __import__('gc').get_objects())",
}  # fmt: skip

# What differs from run to run, or from machine to machine, by a clock, a number or a load.  The two values are both wrong.
OF_THE_MOMENT = PAGE["of_the_moment"]

COUNTING = [
    *recipes("counting"),
    *(function(f"what was shown, {name}", PUBLIC + COUNTED + f"    return {body}") for name, body in BY_CALL.items()),
    *(function(f"a second answer where {name}", HEDGED.format(ZERO, when)) for name, when in SECOND_LOOK.items()),
    *(function(f"one of two by {name}", f"def F(transform):\n    return ({ZERO}, dict.fromkeys(transform, 1.5))[{which}]") for name, which in OF_THE_MOMENT.items()),
    *(value(f"one of two values by {name}", f"V = dict.fromkeys(('base_link', 'map'), ((0, 0, 0), (1, 1, 1))[{which}])") for name, which in list(OF_THE_MOMENT.items())[:4]),
]  # fmt: skip
