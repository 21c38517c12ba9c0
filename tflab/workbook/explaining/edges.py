"""Was an edge named by its parent?  It goes by its child, the frame below: map -> odom is the edge of "odom".

    asked for   "odom", "base_footprint"      given   "map", "odom"      each the parent of what is asked for

Only parts that ask for an edge ("c edge") are looked at; who hangs below whom is known of
the robot that runs through the course.
"""

from __future__ import annotations

from collections.abc import Mapping

from ...text import Texts
from ..answers.form import Form, inside
from ..answers.forms import Choice
from ..answers.values import Plain
from .together import Found

__all__ = ["CARD", "parents_named"]

TEXTS = Texts(__file__)

CARD = {  # child -> parent, of the robot that every chapter meets
    "odom": "map", "base_footprint": "odom", "base_link": "base_footprint", "laser_frame": "base_link",
}  # fmt: skip
FEWEST = 2  # of a single one nobody knows whether another edge was meant, unless it is no child at all


def parents_named(
    forms: Mapping[str, Form], given: Mapping[str, Plain], wanted: Mapping[str, str | None]
) -> list[Found]:
    """Return that edges were named by their parents: of parts that ask for one, all that are wrong.

    Args:
        given: the answers that are wrong, by part.
        wanted: the word that is asked for, of these parts at least.
    """
    named = {name: inside(answer) for name, answer in given.items()}
    if not named or not all(name.split()[-1] == "edge" for name in named):
        return []
    if not all(answer is not None and CARD.get(str(wanted[name])) == answer for name, answer in named.items()):
        return []
    is_no_child = any(
        isinstance(form, Choice) and named.get(name, "") not in (*form.options, "") for name, form in forms.items()
    )
    if len(named) < FEWEST and not is_no_child:
        return []
    quoted = ", ".join(f'"{answer}"' for answer in dict.fromkeys(named.values()))
    said = TEXTS["by_its_child"].filled(named=quoted)
    return [Found.of("parents for children", said, *named)]
