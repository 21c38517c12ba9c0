"""Which parts does an answer have?  Those of a dict by their names, those of a message by their fields.

```
Parts({"x": Number(), ...})                      "x", "y", "yaw"
Parts({"a": Sequence(Choice(...)), ...})         "a[0]", "a[1]"
Message(..., ("header.frame_id", "point"))       a name, three numbers [m]
Pose                                             a translation, three numbers [m], and a rotation
Command, `static_transform_publisher`            two names, three numbers [m], a rotation
```
"""

from __future__ import annotations

from collections.abc import Sequence

from ..answers.form import Form, inside, member, numbers_of, pose_of
from ..answers.forms import Command, Message, Name, Number, Parts, Pose, Quaternion, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain

__all__ = ["section", "sections", "split"]

OF_A_MOUNT = {
    "--frame-id": Name(), "--child-frame-id": Name(), "translation": Vector(3, "m"), "rotation": Quaternion(),
}  # fmt: skip


def sections(form: Form, like: Plain) -> dict[str, Form]:
    """Return the parts of an answer that are judged each on its own; of a message its fields, as `like` has them."""
    if isinstance(form, Parts):
        return dict(form.parts)
    if isinstance(form, Message):
        held = {path: section(form, like, path) for path in form.fields}
        return {path: _form_of_field(path, field, form.tolerance) for path, field in held.items()}
    if isinstance(form, Pose) and not form.frames and not form.stamp:
        return {"translation": Vector(3, "m", "", form.tolerance_m), "rotation": Quaternion(form.tolerance_rad)}
    return dict(OF_A_MOUNT) if isinstance(form, Command) and _mount(form, like) else {}


def split(form: Form, parts: dict[str, Form], answers: Sequence[Plain]) -> dict[str, Form]:
    """Return the same parts, with each member of a list a part of its own, where all answers have as many."""
    found: dict[str, Form] = {}
    for name, part in parts.items():
        lists = [inside(section(form, answer, name)) for answer in answers]
        lengths = {len(held) if isinstance(held, list) else None for held in lists}
        is_split = isinstance(form, Parts) and isinstance(part, ListForm) and len(lengths) == 1 and None not in lengths
        found |= {f"{name}[{place}]": part.of for place in range(len(lists[0]))} if is_split else {name: part}
    return found


def section(form: Form, plain: Plain, name: str) -> Plain:
    """Return one of an answer's parts, as it is meant beside the others; of something else, None."""
    if isinstance(form, Command):
        return _mount(form, plain).get(name)
    if isinstance(form, Pose):
        parts = pose_of(plain)
        return None if parts is None else list(parts[2 if name == "translation" else 3])
    if isinstance(form, Parts):
        held = inside(plain)
        if not isinstance(held, dict):
            return None
        name, _, place = name.partition("[")
        part = form.part(held, name)
        return _member(part, int(place[:-1])) if place else part
    return member(plain, *name.split("."))


def _member(plain: Plain, place: int) -> Plain:
    held = inside(plain)
    return held[place] if isinstance(held, list) and place < len(held) else None


def _mount(form: Command, plain: Plain) -> dict[str, Plain]:
    """Return what a line publishes as a static transform, by parts; nothing of another line."""
    read = form.read(plain)
    words = [mark.value for mark in read[0][0]] if read else []
    if words[:1] != ["static"]:
        return {}
    return dict(zip(OF_A_MOUNT, (words[1], words[2], words[3:6], words[6:]), strict=True))


def _form_of_field(path: str, held: Plain, tolerance: float) -> Form:
    """Return the form of a message's field: its numbers are metres, its rotation a quaternion, its texts words."""
    if numbers_of(held, 4) is not None or path.endswith("rotation"):
        return Quaternion(tolerance)
    if numbers_of(held, 3) is not None or path.endswith(("translation", "point", "position")):
        return Vector(3, "m", "", tolerance)
    return Number("", tolerance) if numbers_of(held, None) is not None else Name()
