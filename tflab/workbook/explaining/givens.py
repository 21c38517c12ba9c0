"""Was an answer handed out already?  Something that was given, as it was.

```
given   speed_mps 0.73   map_T_base (x, y, z), a turn
answer  0.73, in m/s     "this is `speed_mps` as it was given"       0.73, in m: chance
        (x, y, z)        "this is `map_T_base` as it was given"
```
"""

from __future__ import annotations

from collections.abc import Iterator

from ..answers.form import Form, inside, pose_of
from ..answers.forms import Angle, Choice, Number, Parts, Pose, Quaternion, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain
from ..mistakes.fitting import alike
from ..mistakes.units import unit_of

__all__ = ["given_to", "leaves"]


def given_to(form: Form, outcome: Plain, expected: Plain, given: dict[str, Plain] | None) -> str | None:
    """Return under which name an answer was given, if it is nothing else than that."""
    if isinstance(form, Choice | Parts | ListForm) or alike(form, outcome, expected):
        return None
    for name, leaf in leaves(given or {}):
        for shaped in _shaped(form, name, leaf):
            if form.read(shaped) is not None and alike(form, outcome, shaped):
                return name
    return None


def _shaped(form: Form, name: str, leaf: Plain) -> Iterator[Plain]:
    """Yield what was given as an answer of this form might have it; a number only if its name ends in the unit."""
    if isinstance(form, Pose) or (isinstance(form, Number | Angle) and name.endswith(f"_{unit_of(form)}")):
        yield leaf
    parts = pose_of(leaf)
    if isinstance(form, Vector):
        yield from ([leaf] if parts is None else [list(parts[2])[: form.size]])
    elif isinstance(form, Quaternion):
        yield from ([leaf] if parts is None else [list(parts[3])])


def leaves(given: dict[str, Plain], before: str = "") -> Iterator[tuple[str, Plain]]:
    """Yield what was given, by name; of a dict its members, too."""
    for name, held in given.items():
        yield before + name, held
        if isinstance(inner := inside(held), dict) and "Transform" not in inner:
            yield from leaves(inner, f"{before}{name}: ")
