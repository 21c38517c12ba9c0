"""Explain a wrong robot link by link: its parent, its position, its rotation, how it moves."""

from __future__ import annotations

from collections.abc import Iterator

from tflab.core import Transform

from ...text import Text, Texts
from ..answers.form import Row
from ..answers.forms import Form, Quaternion, Urdf, Vector
from ..answers.values import Plain
from ..tasks.case_types import Feedback, TaskCases
from .explanation import Explanation
from .matching import feedback_of, matching_corrections
from .question import Question

__all__ = ["explain_links"]

TEXTS = Texts(__file__)

KINDS = ("turns", "slides", "fixed")  # of joints
POSE = 7  # marks of a place and a rotation
SMALL = 1e-6
ALONG_AN_AXIS = 1e-4  # by so much less than all of a step along it


def explain_links(question: Question) -> Explanation | None:
    """Return what is wrong with each link of a robot; None if the answer is none."""
    task, form, answer, expected = question.task, question.form, question.outcomes[0], question.expected[0]
    given = form.read(answer) if isinstance(form, Urdf) else None
    if not given:
        return None
    mistakes, said = {}, []
    for link, rows, right in zip(form.links, given, form.read(expected) or [], strict=True):
        row = next((row for row in rows if _fits(row[: 2 + POSE], right[0][: 2 + POSE])), rows[0])
        for name, words in (
            [] if any(_fits(row, right[0]) for row in rows) else _explain_link(task, form, row, right[0])
        ):
            mistakes[f"{link}: {name}"] = Feedback(words, "")
            said.append(Text(f'"{link}": {words.en}', f'"{link}": {words.ko}'))
    return Explanation(mistakes, Text.joined(*said)) if said else None


def _fits(row: Row, right: Row) -> bool:
    return len(row) == len(right) and all(mark.same(other) for mark, other in zip(row, right, strict=True))


def _explain_link(task: TaskCases, robot: Urdf, row: Row, right: Row) -> Iterator[tuple[str, Text]]:
    """Yield what is wrong with one link: what it hangs on alone, or its place and its turn, or how it moves."""
    if not _fits(row[:2], right[:2]):
        yield "hangs", _explain_joint(str(row[0].value), str(row[1].value), str(right[1].value))
        return
    is_placed = True
    place, turn = Vector(3, "m", tolerance=robot.tolerance_m), Quaternion(robot.tolerance_rad / 2.0)
    for name, start, form in (("place", 2, place), ("turn", 5, turn)):
        values = [[float(mark.value) for mark in marks[start : start + len(_names(form))]] for marks in (row, right)]
        if not form.same(*values):
            is_placed = False
            yield name, _filled(TEXTS[name], _explain_numbers(task, form, *values))
    if is_placed:
        yield "moves", _filled(TEXTS["moves"], _movement(row))


def _names(form: Form) -> str:
    return "xyz" if isinstance(form, Vector) else "xyzw"


def _explain_joint(root: str, hangs: str, right: str) -> Text:
    """Return what is wrong with what a link hangs on."""
    kind, _, parent = hangs.partition(" on ")
    if not parent:
        return TEXTS["nowhere"]
    if hangs == right:
        return _filled(TEXTS["root"], root.removeprefix("root "))
    if parent != right.partition(" on ")[2]:
        return _filled(TEXTS["parent"], parent)
    return _filled(TEXTS["kind"], TEXTS[kind] if kind in KINDS else Text(f"is {kind}", f"{kind}입니다"))


def _explain_numbers(task: TaskCases, form: Form, given: Plain, wanted: Plain) -> Text:
    """Return what any answer can have wrong, or else what is certain."""
    name = next(matching_corrections(form, [given], [wanted]), None)
    if name:
        return feedback_of(task, name).reply
    bounds = form.describe_difference(given, wanted) or Text("", "")
    axes = _axes(given) if isinstance(form, Quaternion) else ""
    return TEXTS["axes"].filled(said=bounds, name=axes) if axes else bounds


def _axes(rotation: Plain) -> str:
    """Return along which of its parent's axes those of a link point, if each of them lies along one; else nothing."""
    turned = Transform((0.0, 0.0, 0.0), tuple(rotation))
    rows = [list(turned.apply(axis)) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))]
    is_along = all(max(map(abs, row)) > 1.0 - ALONG_AN_AXIS for row in rows)
    return ", ".join(_axis(row) for row in rows) if is_along else ""


def _movement(row: Row) -> Text:
    """Return how a link moves from its first setting to its second."""
    first, second = (
        Transform(tuple(numbers[:3]), tuple(numbers[3:]))
        for numbers in ([float(mark.value) for mark in row[start : start + POSE]] for start in (2, 2 + POSE))
    )
    step = first.inverse() @ second
    turned, moved = step.rotation[:3], step.translation
    if max(map(abs, turned)) > SMALL:
        sign = 1.0 if step.rotation[3] >= 0.0 else -1.0
        return _filled(TEXTS["about"], _axis([sign * number for number in turned]))
    return _filled(TEXTS["along"], _axis(list(moved))) if max(map(abs, moved)) > SMALL else TEXTS["stays"]


def _axis(numbers: list[float]) -> str:
    """Return the axis that a direction is nearest to, with its sign."""
    most = max(numbers, key=abs)
    return ("" if most > 0.0 else "-") + "xyz"[numbers.index(most)]


def _filled(words: Text, name: Text | str) -> Text:
    return words.filled(name=name, said=name)
