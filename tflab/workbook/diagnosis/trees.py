"""Recognise what is wrong with a tree of frames."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ...text import Text, Texts
from ..answers.form import inside
from ..answers.members import edges_of
from ..answers.values import Plain

__all__ = ["TEXTS", "compare_trees", "describe_tree"]

TEXTS = Texts(__file__)

Parents = dict[str, str]  # child -> parent
MOST_NAMED = 4  # frames
NOT_ASKED = ("tree: more than asked for", "tree: other names", "tree: no such parent")
TOLD = {"tree: not whole": "orphans"} | dict.fromkeys(NOT_ASKED, "not_asked")


def describe_tree(kind: str, names: str) -> Text:
    """Return what is told of the frames in which a fault shows."""
    return TEXTS[TOLD.get(kind, "so")].filled(names=names)


def compare_trees(answers: list[Plain], wanted: list[Plain]) -> Iterator[tuple[str, str]]:
    """Yield what is wrong with trees, and the names of the first one in which it shows."""
    if all(_is_turned(*pair) for pair in zip(answers, wanted, strict=True)):
        yield "parent for child", ""
    elif any(map(_has_lists, answers)):
        yield "tree: a list for a name", ""
    elif any(map(_has_none, answers)):
        yield "tree: None for a name", ""
    elif all(edges_of(answer) is not None for answer in answers):
        pairs = [(_parents(answer), _parents(want)) for answer, want in zip(answers, wanted, strict=True)]
        yield from _fitting([pair for pair in pairs if pair[0] != pair[1]])


def _fitting(wrong: list[tuple[Parents, Parents]]) -> Iterator[tuple[str, str]]:
    """Yield what all wrong trees have in common, given beside wanted, and the names of the first."""
    for name, fits in FITS.items():
        if wrong and all(fits(*pair) for pair in wrong):
            yield name, ", ".join(f'"{frame}"' for frame in _shown_in(name, *wrong[0])[:MOST_NAMED])


def _is_turned(answer: Plain, want: Plain) -> bool:
    edges, wanted = edges_of(answer) or [], edges_of(want) or []
    return len(edges) >= 2 and all((parent, child) in wanted for child, parent in edges)


def _has_lists(answer: Plain) -> bool:
    """Return whether a dict has a list for one of its values."""
    is_dict = isinstance(answer, dict) and "dict" in answer
    return is_dict and any(isinstance(inside(parent), list) for parent in answer["dict"].values())


def _has_none(answer: Plain) -> bool:
    """Return whether one parent of a dict is None, and every other one a name."""
    parents = list(answer["dict"].values()) if isinstance(answer, dict) and "dict" in answer else []
    return None in parents and all(parent is None or isinstance(parent, str) for parent in parents)


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


def _shown_in(kind: str, given: Parents, want: Parents) -> list[str]:
    """Return the frames of an answer in which a fault shows: those without a parent, those nobody asked for, or those
    that hang wrong.
    """
    if kind == "tree: not whole":
        return sorted(frame for frame in _names(given) & set(want) if frame not in given)
    if kind in ("tree: other names", "tree: no such parent"):
        return sorted(_names(given) - _names(want))
    return sorted(child for child, parent in given.items() if want.get(child) != parent)


FITS: dict[str, Callable[[Parents, Parents], bool]] = {
    "tree: not whole": lambda given, want: bool(given) and given.items() <= want.items(),
    "tree: more than asked for": lambda given, want: given.items() >= want.items(),
    "tree: too high": lambda given, want: _hang(given, want, lambda child, parent: parent in _above(want, child)),
    "tree: too low": lambda given, want: _hang(
        given, want, lambda child, parent: want[child] in _above(want, parent) and child not in _above(want, parent)
    ),
    "tree: other names": lambda given, want: _names(given) != _names(want) and _shape(given) == _shape(want) != "",
    "tree: no such parent": lambda given, want: _hang(given, want, lambda _, parent: parent not in _names(want)),
}
