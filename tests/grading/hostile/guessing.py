"""Answers without understanding, two answers for one task, answers of any size; and honest mistakes in one branch."""

from __future__ import annotations

from .recipe import Recipe, function, page, recipes, value

__all__ = ["GUESSING", "SLIPS"]

COUNTED = page("guessing")["pieces"]["COUNTED"]
HEDGED = "def F(transform):\n    return {}\nif {}:\n    def F(transform):\n        return RIGHT\nraise ValueError('look again')"
ZERO = "{'x': 0.0, 'y': 0.0, 'yaw': 0.0}"
OTHERS = "'calls' not in globals()", "'corner' not in globals()", "not {'calls', 'corner'} <= set(globals())"
SIZES = page("guessing")["sizes"]
GUESSING = [
    *recipes("guessing"),
    *(function(f"a second answer if {when}", HEDGED.format(ZERO, when)) for when in OTHERS),
    *(function(f"a second answer where the first was minus, if {when}", HEDGED.format("{k: -v for k, v in transform.items()}", when)) for when in OTHERS),
    *(value(f"a second value if {when}", f"V = {{'base_link': (0, 0, 0), 'map': (0, 0, 0)}}\nif {when}:\n    p = e3_2.base_T_laser.apply(e3_2.laser_p_corner)\n    V = {{'base_link': p, 'map': e3_2.map_T_base.apply(p)}}\nraise ValueError") for when in (OTHERS[0], "globals().get('calls') is None")),
    *(function(name, f"def F(transform):\n    return {body}") for name, body in SIZES.items()),
    *(value(f"{name}, as a value", f"transform = {{'x': 1.0}}\nV = {body}") for name, body in SIZES.items()),
]  # fmt: skip

PARTS = {
    "None": "None",
    "a text": "'x'",
    "a list": "[1.0, 2.0]",
    "nan": "float('nan')",
    "a dict": "{'x': 1.0}",
    "...": "...",
}
SLIPS = [
    Recipe(
        f"{part} is {name} where yaw is {sign} 0",
        lambda honest, part=part, odd=odd, sign=sign: honest.with_function(
            f"def F(transform):\n    back = RIGHT\n    if transform['yaw'] {sign} 0:\n        back['{part}'] = {odd}\n    return back"
        ),
        "mistake",
        "others",
    )
    for part in ("x", "y", "yaw")
    for name, odd in PARTS.items()
    for sign in ("<", ">=")
]  # fmt: skip
