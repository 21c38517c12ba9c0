"""What was lost, and cannot be put back?  Digits, zeros, an order, half a stamp: seen by comparing, not by undoing.

    answer (1.2, 2.3, 3.4)     expected (1.234, 2.345, 3.456)     rounded
    answer (1.0, 2.0, 0.0)     expected (1.0, 2.0, 3.0)           left at zero
    answer [b, a, c]           expected [a, b, c]                 another order
    answer 12.000000000        expected 12.345000000              a stamp of whole seconds

Only where the right answer is open; a tree's edges are found where it is sealed, too.
Read `shell_words.py` next.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator

from ..answers import sealed
from ..answers.form import Row as Marks
from ..answers.form import inside, member, numbers_of
from ..answers.forms import Angle, Command, Form, Name, Number, Quaternion, Sequence, Set, Tree, Vector
from ..answers.members import edges_of, members_of
from ..answers.values import Plain
from ..words import Words
from .shell_words import LINES, wrong_in
from .universal import OF_FORM

__all__ = ["LOSSES", "by_comparison"]

Numbers = tuple[float, ...]
Parents = dict[str, str]  # child -> parent

LOSSES = {
    "empty": Words(en="this is still empty.", ko="아직 비어 있습니다."),
    "left at zero": Words(
        en="what is not 0 is right; a number that is still 0 is missing.",
        ko="0이 아닌 숫자는 맞습니다. 아직 0인 숫자가 빠졌습니다.",
    ),
    "zero": Words(
        en="0 would say that there is nothing of it, and there is.",
        ko="0이라면 아무것도 없다는 뜻인데, 없지 않습니다.",
    ),
    "rounded": Words(
        en="digits were cut off: hand over the number as it was computed, without rounding.",
        ko="자릿수를 잘라 냈습니다. 반올림하지 말고 계산한 그대로 넘기십시오.",
    ),
    "other order": Words(en="the right members, in the opposite order.", ko="원소는 맞지만 순서가 거꾸로입니다."),
    "another order": Words(
        en="the right members, and not in the order that is asked for.",
        ko="원소는 맞지만 요구한 순서가 아닙니다.",
    ),
    "members twice": Words(
        en="the right members, and some of them more than once.", ko="원소는 맞지만 두 번 이상 든 것이 있습니다."
    ),
    "members once": Words(
        en="the right members, each of them once; a member counts as often as it comes.",
        ko="원소는 맞지만 한 번씩만 있습니다. 같은 원소도 나온 횟수만큼 있어야 합니다.",
    ),
    "members missing": Words(
        en="what is there belongs there, in this order; members are missing.",
        ko="있는 원소와 그 순서는 맞지만 빠진 원소가 있습니다.",
    ),
    "members too many": Words(
        en="all members that are asked for are there, in their order, and others among them.",
        ko="필요한 원소가 순서대로 다 있지만 들어가면 안 되는 원소도 섞여 있습니다.",
    ),
    "parent for child": Words(
        en="parents and children have changed places. Each child has one parent, so the child is the key: "
        "child -> parent.",
        ko="부모와 자식의 자리가 바뀌었습니다. 자식의 부모는 하나뿐이므로 자식이 키입니다: 자식 -> 부모.",
    ),
    "tree: a list for a name": Words(
        en="a list stands where the name of one frame belongs, child -> parent; out of a list comes a name by `[0]`.",
        ko="좌표계 이름 하나가 올 자리에 리스트가 있습니다. 자식 -> 부모로 쓰고, 리스트의 이름은 `[0]`으로 꺼냅니다.",
    ),
    "tree: not whole": Words(
        en="all that is there is right, and a part of the tree is missing.",
        ko="있는 것은 모두 맞지만 트리의 일부가 빠졌습니다.",
    ),
    "tree: more than asked for": Words(
        en="the tree that is asked for is there, and more beside it.",
        ko="필요한 트리는 다 있지만 필요 없는 것이 더 있습니다.",
    ),
    "tree: a frame left out": Words(
        en="a frame is left out of the chain: what hung below it hangs on the frame above it.",
        ko="사슬에서 좌표계가 빠졌습니다. 그 아래에 있던 것이 그 위의 좌표계에 이어졌습니다.",
    ),
    "tree: too high": Words(
        en="the frames are the right ones; what hangs wrong hangs too high: there is a frame between.",
        ko="좌표계는 모두 맞습니다. 틀린 것은 너무 위에 이어졌습니다. 그 사이에 좌표계가 더 있습니다.",
    ),
    "tree: too low": Words(
        en="the frames are the right ones; what hangs wrong hangs too low: below one that belongs beside it.",
        ko="좌표계는 모두 맞습니다. 틀린 것은 너무 아래에, 옆에 있어야 할 좌표계 밑에 이어졌습니다.",
    ),
    "tree: places changed": Words(
        en="the right frames, in a tree of the right shape, and some of them stand in each other's places.",
        ko="좌표계도 트리의 모양도 맞지만 일부 좌표계의 자리가 서로 바뀌었습니다.",
    ),
    "tree: other names": Words(
        en="the tree has the shape that is asked for, and not all of its names.",
        ko="트리의 모양은 맞지만 이름 가운데 다른 것이 있습니다.",
    ),
    "stamp: seconds alone": Words(
        en="only `sec` is right: the nanoseconds are missing. `.to_msg()` of a Time writes both.",
        ko="`sec`만 맞고 나노초가 빠졌습니다. Time의 `.to_msg()`가 둘 다 씁니다.",
    ),
    "stamp: nanoseconds alone": Words(
        en="only `nanosec` is right: the whole seconds are missing. `.to_msg()` of a Time writes both.",
        ko="`nanosec`만 맞고 초가 빠졌습니다. Time의 `.to_msg()`가 둘 다 씁니다.",
    ),
    "stamp: zero": Words(
        en="the stamp is still zero: nobody has written it.", ko="시각이 아직 0입니다. 아무도 쓰지 않았습니다."
    ),
    "stamp: written": Words(
        en="a stamp was written, and here it is to be left as it is, zero.",
        ko="시각을 썼습니다. 여기서는 0인 그대로 두어야 합니다.",
    ),
    **LINES,
}


def by_comparison(form: Form, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield the mistakes that lose something and cannot be undone."""
    if answers == [""] * len(answers):
        yield "empty"
    elif isinstance(form, Sequence):
        yield from _of_lists(form, answers, wanted)
    elif isinstance(form, Set) and form.once and all(map(_is_held_twice, [form] * len(wanted), answers, wanted)):
        yield "members twice"
    elif isinstance(form, Tree):
        yield from _of_trees(form, answers, wanted)
    elif isinstance(form, Name | Command):
        yield from _of_stamps(answers, wanted) if isinstance(form, Name) else _of_lines(form, answers, wanted)
    elif type(form) in OF_FORM and all(form.read(answer) is not None for answer in answers):
        size = form.size if isinstance(form, Vector) else 4 if isinstance(form, Quaternion) else None
        yield from _lost(form, [(numbers_of(*pair), numbers_of(want, size)) for *pair, want in
                                zip(answers, [size] * len(answers), wanted, strict=True)])  # fmt: skip


def _lost(form: Form, rows: list[tuple[Numbers, Numbers]]) -> Iterator[str]:
    if None in sum(rows, ()):
        return
    is_empty = not any(any(given) for given, _ in rows)
    if isinstance(form, Vector) and all(_left_at_zero(*row, form.tolerance) for row in rows):
        yield "empty" if is_empty else "left at zero"
    elif is_empty and isinstance(form, Number | Angle):
        yield "zero"
    if not is_empty and any(all(_rounded(*row, digits) for row in rows) for digits in (0, 1, 2, 3)):
        yield "rounded"


def _left_at_zero(given: Numbers, wanted: Numbers, tolerance: float) -> bool:
    return all(number == 0.0 or abs(number - want) <= tolerance for number, want in zip(given, wanted, strict=True))


def _rounded(given: Numbers, wanted: Numbers, digits: int) -> bool:
    """Return whether each number was rounded to so many digits, or cut there."""
    scale = 10**digits
    return all(
        any(abs(number - cut / scale) < 1e-9 for cut in (round(want * scale), math.trunc(want * scale)))
        for number, want in zip(given, wanted, strict=True)
    )


def _of_lists(form: Sequence, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    pairs = [(_ways(form, answer), _ways(form, want)) for answer, want in zip(answers, wanted, strict=True)]
    if not any(None in pair for pair in pairs) and any(given for given, _ in pairs):
        yield from (name for name, fits in LISTS.items() if all(fits(given, want) for given, want in pairs))


def _is_within(few: list[str], many: list[str]) -> bool:
    """Return whether these members stand among those, in the same order."""
    rest = iter(many)
    return all(member in rest for member in few)


LISTS: dict[str, Callable[[list[str], list[str]], bool]] = {
    "other order": lambda given, want: given in (want, want[::-1]),
    "another order": lambda given, want: sorted(given) == sorted(want),
    "members twice": lambda given, want: list(dict.fromkeys(given)) == want,
    "members once": lambda given, want: list(dict.fromkeys(want)) == given,
    "members missing": lambda given, want: _is_within(given, want),
    "members too many": lambda given, want: _is_within(want, given),
}


def _ways(form: Sequence, plain: Plain) -> list[str] | None:
    """Return each member of a list as one word that says how it can be written; None if it is no such list."""
    held = inside(plain)
    if sealed.is_sealed(plain) or not isinstance(held, list):
        return None
    read = [form.of.read(one) for one in held]
    return None if None in read else [json.dumps([_plain(row) for probe in probes for row in probe]) for probes in read]


def _plain(row: Marks) -> list[float | str]:
    return [mark.value if isinstance(mark.value, str) else round(mark.value, 9) + 0.0 for mark in row]


def _is_held_twice(form: Set, answer: Plain, wanted: Plain) -> bool:
    """Return whether an answer is right once each of its members counts once, or right as it is."""
    members = members_of(answer)
    return members is not None and all(sealed.judge(Set(form.of), members, wanted))


def _of_trees(form: Tree, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield that an answer has its edges the wrong way round; a dict by parents has lost some of them."""
    if all(_is_turned(form, *pair) for pair in zip(answers, wanted, strict=True)):
        yield "parent for child"
    elif any(map(_has_lists, answers)):
        yield "tree: a list for a name"
    elif not any(map(sealed.is_sealed, wanted)) and all(edges_of(answer) is not None for answer in answers):
        pairs = [(_parents(answer), _parents(want)) for answer, want in zip(answers, wanted, strict=True)]
        yield from (
            name for name, fits in TREES.items() if all(given == want or fits(given, want) for given, want in pairs)
        )


def _is_turned(form: Tree, answer: Plain, want: Plain) -> bool:
    edges = edges_of(answer) or []
    turned = [[child, parent] for child, parent in edges]  # a Tree takes pairs (parent, child)
    return len(edges) >= 2 and all(sealed.belongs(form, turned, want))


def _has_lists(answer: Plain) -> bool:
    """Return whether a dict has a list for one of its values."""
    is_dict = isinstance(answer, dict) and "dict" in answer
    return is_dict and any(isinstance(inside(parent), list) for parent in answer["dict"].values())


def _parents(plain: Plain) -> Parents:
    return dict(edges_of(plain) or [])


def _names(tree: Parents) -> set[str]:
    return {*tree, *tree.values()}


def _above(tree: Parents, frame: str) -> list[str]:
    """Return the frames above one, the nearest first; a loop ends where it began."""
    found: list[str] = []
    while (frame := tree.get(frame, "")) and frame not in found:
        found.append(frame)
    return found


def _is_left_out(given: Parents, want: Parents) -> bool:
    """Return whether a tree is what is wanted without some frames, what hung on them hanging above them."""
    gone = _names(want) - _names(given)
    kept = {child: [each for each in _above(want, child) if each not in gone] for child in want if child not in gone}
    below = gone & set(want.values())
    return bool(below) and given == {child: above[0] for child, above in kept.items() if above}


def _hang(given: Parents, want: Parents, is_so: Callable[[str, str], bool]) -> bool:
    """Return whether the frames are those wanted, and each that hangs wrong `is_so`: child, and its parent now."""
    wrong = [(child, parent) for child, parent in given.items() if want.get(child) != parent]
    return set(given) == set(want) and all(is_so(child, parent) for child, parent in wrong)


def _shape(tree: Parents) -> str:
    """Return how a tree branches, without any names; none for what is no tree."""
    roots = sorted(_names(tree) - set(tree))

    def below(frame: str) -> str:
        return "(" + "".join(sorted(below(child) for child, parent in tree.items() if parent == frame)) + ")"

    is_tree = all(_above(tree, child)[-1] in roots for child in tree)
    return "".join(sorted(map(below, roots))) if is_tree else ""


def _has_shape(given: Parents, want: Parents) -> bool:
    return bool(_shape(want)) and _shape(given) == _shape(want)


TREES: dict[str, Callable[[Parents, Parents], bool]] = {
    "tree: not whole": lambda given, want: bool(given) and given.items() <= want.items(),
    "tree: more than asked for": lambda given, want: given.items() >= want.items(),
    "tree: a frame left out": _is_left_out,
    "tree: too high": lambda given, want: _hang(given, want, lambda child, parent: parent in _above(want, child)),
    "tree: too low": lambda given, want: _hang(
        given, want, lambda child, parent: want[child] in _above(want, parent) and child not in _above(want, parent)
    ),
    "tree: places changed": lambda given, want: _names(given) == _names(want) and _has_shape(given, want),
    "tree: other names": lambda given, want: _names(given) != _names(want) and _has_shape(given, want),
}


def _of_lines(form: Command, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    given, right = form.read(answers[0]), None if sealed.is_sealed(wanted[0]) else form.read(wanted[0])
    if given and right and len(answers) == 1:
        yield from wrong_in(*([mark.value for mark in probes[0][0]] for probes in (given, right)))


def _of_stamps(answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    rows = [(_stamp(answer), _stamp(want)) for answer, want in zip(answers, wanted, strict=True)]
    if any(None in row for row in rows):
        return
    if all(want == (0, 0) for _, want in rows):
        yield "stamp: written"
    elif all(given == (0, 0) for given, _ in rows):
        yield "stamp: zero"
    elif all(given == (sec, 0) for given, (sec, _) in rows):
        yield "stamp: seconds alone"
    elif all(given == (0, nanosec) for given, (_, nanosec) in rows):
        yield "stamp: nanoseconds alone"


def _stamp(plain: Plain) -> tuple[int, int] | None:
    sec, nanosec = member(plain, "sec"), member(plain, "nanosec")
    return (sec, nanosec) if isinstance(sec, int) and isinstance(nanosec, int) else None
