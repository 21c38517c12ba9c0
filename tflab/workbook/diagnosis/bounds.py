"""Say what is certain of a wrong answer that nothing explains: which part, too large or too small."""

from __future__ import annotations

import difflib
import math

from ...text import Text
from ..answers.form import Angle, Form, Mark, Number, Pose, Quaternion, Vector, inside, numbers_of, pose_of
from ..answers.forms import Command, Message, Name, Parts, Sequence, Set, Tree
from ..answers.members import belonging, edges_of, members_of
from ..answers.values import Plain, is_raised
from .matching import part_forms, part_of

__all__ = ["certain"]

NAMES = "xyzw"
STATIC = ("frame-id", "child-frame-id", "x", "y", "z")  # what static_transform_publisher is told, and a rotation
NEARLY = 0.6  # from which share of letters on a name looks like another
TINY_DEG = 1e-6  # what adding up leaves
MOST_NAMED = 4  # children that are called by name


def certain(form: Form, answer: Plain, expected: Plain) -> Text | None:
    """Return what is certain about a wrong answer, or None if there is nothing to say."""
    if isinstance(form, Set | Tree) and not is_raised(expected) and form.read(answer) is not None:
        return _bound_tree(answer, expected) if isinstance(form, Tree) else _bound_set(form, answer, expected)
    if is_raised(expected) or is_raised(answer):
        return None
    if isinstance(form, Number | Angle | Vector | Quaternion):
        return _bound_numbers(form, answer, expected)
    if isinstance(form, Sequence):
        return _bound_sequence(inside(answer), inside(expected))
    if isinstance(form, Pose):
        return _bound_pose(form, answer, expected)
    if isinstance(form, Command):
        return _bound_command(form, answer, expected)
    if isinstance(form, Name):
        return _bound_name(answer, expected)
    return _bound_parts(form, answer, expected)


def _bound_numbers(form: Form, answer: Plain, expected: Plain) -> Text | None:
    if isinstance(form, Number):
        return _bound_number(numbers_of(answer, None), numbers_of(expected, None))
    if isinstance(form, Angle):
        return _bound_angle(numbers_of(answer, None), numbers_of(expected, None))
    if isinstance(form, Vector):
        return _bound_vector(numbers_of(answer, form.size), numbers_of(expected, form.size), form.tolerance)
    return _bound_rotation(numbers_of(answer, 4), numbers_of(expected, 4), 1e-3)


def _bound_number(given: tuple[float, ...] | None, wanted: tuple[float, ...] | None) -> Text | None:
    if given is None or wanted is None:
        return None
    large = given[0] > wanted[0]
    side = Text("too large", "너무 큽니다") if large else Text("too small", "너무 작습니다")
    off = abs(given[0] - wanted[0])
    if off < 0.1 * abs(wanted[0]):
        return Text(f"{side.en}, by less than a tenth", f"10% 이내의 차이로 {side.ko}")
    if off < abs(wanted[0]):
        return Text(f"{side.en}, by more than a tenth", f"10% 넘는 차이로 {side.ko}")
    return Text(f"{side.en}, by more than the answer itself", f"정답 자체보다 큰 차이로 {side.ko}")


def _bound_angle(given: tuple[float, ...] | None, wanted: tuple[float, ...] | None) -> Text | None:
    if given is None or wanted is None:
        return None
    off = math.remainder(given[0] - wanted[0], math.tau)
    size = _degrees(abs(off))
    if off > 0:
        return Text(f"turned too far to the left, by {size.en}", f"왼쪽으로 {size.ko} 더 돌았습니다")
    return Text(f"turned too far to the right, by {size.en}", f"오른쪽으로 {size.ko} 더 돌았습니다")


def _bound_vector(given: tuple[float, ...] | None, wanted: tuple[float, ...] | None, tolerance: float) -> Text | None:
    if given is None or wanted is None:
        return None
    rows = list(zip(NAMES, given, wanted, strict=False))
    right = [name for name, number, other in rows if abs(number - other) <= tolerance]
    large = [name for name, number, other in rows if number - other > tolerance]
    small = [name for name, number, other in rows if other - number > tolerance]
    if not right and abs(math.hypot(*given) - math.hypot(*wanted)) <= 2 * tolerance:
        return Text(
            "its length is right, its direction is not: a turn is missing, or is one too many",
            "길이는 맞지만 방향이 다릅니다. 회전이 빠졌거나 하나 더 들어갔습니다",
        )
    pieces = [(right, "right", "맞음"), (large, "too large", "너무 큼"), (small, "too small", "너무 작음")]
    said = [(", ".join(names), en, ko) for names, en, ko in pieces if names]
    return Text("; ".join(f"{names}: {en}" for names, en, _ in said), "; ".join(f"{n}: {ko}" for n, _, ko in said))


def _bound_rotation(given: tuple[float, ...] | None, wanted: tuple[float, ...] | None, tolerance: float) -> Text | None:
    if given is None or wanted is None or math.hypot(*given) < 1e-9:
        return Text("all zeros is no rotation", "모두 0이면 회전이 아닙니다") if given is not None else None
    if any(all(abs(sign * a - b) <= tolerance for a, b in zip(given, wanted, strict=True)) for sign in (1.0, -1.0)):
        return Text("right", "맞음")
    cosine = abs(sum(map(lambda a, b: a * b, given, wanted))) / math.hypot(*given) / math.hypot(*wanted)
    size = _degrees(2.0 * math.acos(min(1.0, cosine)))
    return Text(f"off by {size.en}", f"{size.ko} 어긋났습니다")


def _bound_pose(form: Pose, answer: Plain, expected: Plain) -> Text | None:
    given, wanted = pose_of(answer), pose_of(expected)
    if given is None or wanted is None:
        return None
    place = _bound_vector(given[2], wanted[2], form.tolerance_m)
    turn = _bound_rotation(given[3], wanted[3], form.tolerance_rad / 2.0)  # as the form compares its parts
    return Text(f"translation: {place.en}. Rotation: {turn.en}", f"이동: {place.ko}. 회전: {turn.ko}")


def _bound_sequence(given: Plain, wanted: Plain) -> Text | None:
    if not isinstance(given, list) or not isinstance(wanted, list):
        return None
    if len(given) > len(wanted):
        return Text("too many members", "원소가 너무 많습니다")
    if len(given) < len(wanted):
        return Text("too few members", "원소가 모자랍니다")
    first = next((place for place, pair in enumerate(zip(given, wanted, strict=True)) if pair[0] != pair[1]), 0)
    if first:
        return Text(f"the first members are right, up to number {first}", f"앞에서 {first}번째 원소까지는 맞습니다")
    return Text("as many members as asked for, and not these", "원소의 수는 맞지만 내용이 다릅니다")


def _bound_tree(answer: Plain, expected: Plain) -> Text | None:
    """Say which children of the answer hang wrong, and how many edges there should be."""
    edges = edges_of(answer) or []
    fits = belonging(Tree(), answer, expected) if edges else []
    wrong = sorted({child for (child, _), fit in zip(edges, fits, strict=True) if not fit})
    short = _wanted_count(Tree(), expected) - len({child for child, _ in edges})
    said = []
    if wrong:
        names = ", ".join(f'"{name}"' for name in wrong[:MOST_NAMED])
        said.append(
            Text(f"wrong as a child, or below the wrong parent: {names}", f"자식이나 그 부모가 틀린 곳: {names}")
        )
    if short > 0:
        said.append(Text(f"children that are missing: {short}", f"빠진 자식: {short}개"))
    return _joined(said)


def _bound_set(form: Set, answer: Plain, expected: Plain) -> Text | None:
    """Say how many members do not belong, and how many are missing."""
    fits = belonging(form, answer, expected) if members_of(answer) else []
    missing = _wanted_count(form, expected) - sum(fits)
    said = []
    if not all(fits):
        count = len(fits) - sum(fits)
        said.append(Text(f"members that do not belong: {count}", f"들어가면 안 되는 원소: {count}개"))
    if missing > 0:
        said.append(Text(f"members that are missing: {missing}", f"빠진 원소: {missing}개"))
    return _joined(said)


def _wanted_count(form: Set | Tree, expected: Plain) -> int:
    """Return how many members are expected."""
    members = edges_of(expected) if isinstance(form, Tree) else members_of(expected)
    return len(form.probes(expected)) if members else 0


def _joined(said: list[Text]) -> Text | None:
    return Text("; ".join(words.en for words in said), "; ".join(words.ko for words in said)) if said else None


def _bound_parts(form: Form, answer: Plain, expected: Plain) -> Text | None:
    """Say it of the first part that is wrong and can be spoken of."""
    if not isinstance(form, Parts):
        return _bound_message(form, answer, expected) if isinstance(form, Message) else None
    given, wanted = inside(answer), inside(expected)
    if not isinstance(given, dict) or not isinstance(wanted, dict):
        return None
    for name, part in form.parts.items():
        if name in given and not part.alike(given[name], wanted[name]):
            said = certain(part, given[name], wanted[name])
            if said is not None:
                return Text(f'"{name}": {said.en}', f'"{name}": {said.ko}')
    return None


def _bound_message(form: Message, answer: Plain, expected: Plain) -> Text | None:
    """Say which fields are right, and of the first one that is not what is certain about it."""
    rights = form.judge(answer, expected)
    right = [path for path, right in zip(form.fields, rights, strict=True) if right]
    said = [Text(f"right: {', '.join(right)}", f"맞음: {', '.join(right)}")] if right else []
    parts = part_forms(form, expected)
    wrong = (name for name, is_right in zip(parts, rights, strict=True) if not is_right)
    for name in wrong:
        of_field = certain(parts[name], *(part_of(form, plain, name) for plain in (answer, expected)))
        if of_field is not None:
            return _joined([*said, Text(f"{name}: {of_field.en}", f"{name}: {of_field.ko}")])
    return _joined(said)


def _bound_command(form: Command, answer: Plain, expected: Plain) -> Text | None:
    """Say which words of a command line are right; of a static transform, which of its numbers and names."""
    given, wanted = form.read(answer), form.probes(expected)
    if not given or not wanted:
        return None
    row, right = given[0][0], wanted[0][0]
    if right[0].value != "static":
        same = next((place for place, pair in enumerate(zip(row, right, strict=False)) if not Mark.fits(*pair)), 0)
        return Text(f"right up to word {same}", f"{same}번째 낱말까지는 맞습니다") if same else None
    if row[0].value != "static":
        return Text(
            "this line publishes no static transform: another program, a word too few, or an option that it lacks",
            "정적 변환을 발행하는 명령이 아닙니다. 다른 프로그램이거나, 낱말이 빠졌거나, 없는 옵션입니다",
        )
    wrong = [name for name, *pair in zip(STATIC, row[1:6], right[1:6], strict=True) if not Mark.fits(*pair)]
    if not any(all(map(Mark.fits, row[6:], other[6:])) for other in wanted[0]):
        wrong.append("rotation")
    right_ones = [name for name in (*STATIC, "rotation") if name not in wrong]
    names, others = ", ".join(wrong), ", ".join(right_ones)
    return Text(f"right: {others}; wrong: {names}", f"맞음: {others}; 틀림: {names}")


def _bound_name(answer: Plain, expected: Plain) -> Text | None:
    """Say whether a name is nearly the one that is asked for; never which that is."""
    if not isinstance(answer, str) or not isinstance(expected, str) or not answer:
        return None
    if difflib.SequenceMatcher(None, answer, expected).ratio() >= NEARLY:
        return Text(
            "nearly the name that is asked for: compare letter by letter",
            "필요한 이름과 비슷합니다. 한 글자씩 비교하십시오",
        )
    return Text("another name than the one that is asked for", "필요한 이름이 아닙니다")


def _degrees(angle_rad: float) -> Text:
    angle = math.degrees(angle_rad)
    for bound in (1, 5, 15, 45, 90):
        if angle <= bound + TINY_DEG:
            return Text(f"at most {bound}°", f"{bound}° 이내로")
    return Text("more than 90°", "90° 넘게")
