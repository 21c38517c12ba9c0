"""What if this frame hung somewhere else?  Menus in front of `climb`: give a frame another parent, and ask.

    move [odom v]  under [base_link v]      ask  source [head v]  target [odom v]

Nothing refuses a broken tree: only the question says what is wrong, in tf2's words below
the picture.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from ..climb import TreeWalkPicture, snapshot_of_parents
from ..libraries import ipywidgets as widgets
from .drawn_ahead import At
from .panel import Panel, menu

Edge = tuple[str, str]  # parent, child
Ask = Callable[[list[Edge], str, str], tuple[bool, str]]  # edges as sent, target, source -> an answer at all? its text

LINES = 2  # for tf2's words, besides one for each frame: of a loop it names every edge


class MenuWords(NamedTuple):
    """What stands at the menus."""

    move: str
    under: str
    source: str
    target: str
    chosen: str


WORDS = {
    "en": MenuWords("move", "under", "source", "target", "choose, and the tree follows"),
    "ko": MenuWords("옮길 frame", "새 부모", "원본", "목표", "고르면 트리가 따라 바뀝니다"),
}


def tree_panel(
    parent_of: Mapping[str, str],
    target_frame: str,
    source_frame: str,
    ask: Ask,
    misspelt: str = "odm",
    language: str = "en",
) -> Panel:
    """Return a panel in which a frame can be given another parent, and a question be asked of what comes of it.

    Args:
        parent_of: the tree to begin with, child -> parent.
        target_frame, source_frame: the question to begin with.
        ask: what tf2 says: of edges (parent, child) in the order they are sent, and a question.
        misspelt: a parent that nobody else names, to hang something on.
        language: of the menus, "en" or "ko".

    Raises:
        ValueError: a frame is not in the tree, or the language is unknown.
    """
    frames = list(dict.fromkeys(name for child, parent in parent_of.items() for name in (parent, child)))
    for frame in (target_frame, source_frame):
        if frame not in frames:
            raise ValueError(f'there is no frame "{frame}" in this tree; there is {", ".join(frames)}')
    if language not in WORDS:
        raise ValueError(f'there are no words in "{language}"; languages are {", ".join(WORDS)}')
    words = WORDS[language]
    first = next(iter(parent_of))
    child = _menu(words.move, list(parent_of), first, words.chosen)
    parent = _menu(words.under, [*frames, misspelt], parent_of[first], words.chosen)
    source = _menu(words.source, frames, source_frame, words.chosen)
    target = _menu(words.target, frames, target_frame, words.chosen)
    picture = TreeWalkPicture(len(frames) + 1, len(frames) + LINES)

    def move(at: At) -> None:
        sent = [(above, below) for below, above in parent_of.items()]
        sent += [(at(parent), at(child))] if parent_of[at(child)] != at(parent) else []
        now = dict(parent_of)
        if at(parent) != at(child):  # tf2 refuses a frame that is its own parent, and keeps what it had
            now[at(child)] = at(parent)
        is_answer, text = ask(sent, at(target), at(source))
        picture.show(snapshot_of_parents(now, frames), at(target), at(source), text, is_answer)

    return Panel("A tree whose frames can be moved", picture, (child, parent, source, target), move, language=language)


def _menu(description: str, options: list[str], value: str, chosen: str) -> widgets.Dropdown:
    return menu(description, options, value, chosen, label_width="90px", width="330px")
