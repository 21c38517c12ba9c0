"""Panels for lookups: choose target and source in any of five forms, or give a frame another parent."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import permutations
from typing import NamedTuple

from tflab.core import StampedTransform, Transform
from tflab.core.quaternions import canonical

from ..libraries import ipywidgets as widgets
from ..sentence import SentencePicture, sentence
from ..tree_path import TreeWalkPicture, snapshot_of_parents
from .panel import Panel, menu, said
from .prefetch import At

Pair = tuple[str, str]  # target, source

WORDS = {
    "en": ("data expressed in", ", wanted in", ""),
    "ko": ("", "기준으로 표현된 데이터를", "기준으로 보고 싶습니다."),
}


class SentencePanel(Panel):
    """A question about two frames that can be put in any of its forms."""

    def __init__(self, poses: Mapping[str, Transform], target: str, source: str, language: str) -> None:
        self._answers = {pair: between(poses, *pair) for pair in permutations(poses, 2)}
        forms = {pair: sentence(answer) for pair, answer in self._answers.items()}
        self._pair: Pair = (target, source)
        self._is_following = False
        frames = [(frame, frame) for frame in poses]
        self._source = _menu("source", frames, source, language, "250px")
        self._target = _menu("target", frames, target, language, "250px")
        self._lines = [
            _menu("Python", [(words.call, pair) for pair, words in forms.items()], self._pair, language),
            _menu("arrow", [(words.arrow, pair) for pair, words in forms.items()], self._pair, language),
            _menu("shell", [(words.echo_command, pair) for pair, words in forms.items()], self._pair, language),
        ]
        before, between_words, after = (widgets.Label(words) for words in WORDS[language])
        picture = SentencePicture(poses, language)
        super().__init__(
            "One question about two frames, said in five ways",
            picture,
            (self._source, self._target, *self._lines),
            lambda at: picture.show(self._answers[self._pair_at(at)]),
            layout=[
                widgets.HBox([before, self._source, between_words, self._target, after]),
                *self._lines,
            ],
            language=language,
        )

    def _on_change(self, change) -> None:
        if self._is_following:  # this menu was set by us, below
            return
        if change.owner in self._lines:
            self._pair = change.new
        else:
            self._pair = _pair_without_repeat(self._pair, (self._target.value, self._source.value))
        self._is_following = True
        self._target.value, self._source.value = self._pair
        for line in self._lines:
            line.value = self._pair
        self._is_following = False
        self._show(change.owner)

    def _pair_at(self, at: At) -> Pair:
        """Return what is asked when one menu has been set, and the others have not followed yet."""
        if at.moved in self._lines:
            return at(at.moved)
        return _pair_without_repeat(self._pair, (at(self._target), at(self._source)))


def sentence_panel(
    poses: Mapping[str, Transform], target_frame: str, source_frame: str, language: str = "en"
) -> SentencePanel:
    """Return a panel in which a question can be chosen in any of its forms.

    Args:
        poses: where each frame is in the drawing's own frame, `fixed_T_name`; at least two.
        target_frame, source_frame: what to begin with.
        language: of the sentence, "en" or "ko".

    Raises:
        ValueError: `poses` lacks one of the frames, both are the same, or the language is unknown.
    """
    for frame in (target_frame, source_frame):
        if frame not in poses:
            raise ValueError(f'no pose is given for "{frame}"; there are poses for {", ".join(poses)}')
    if target_frame == source_frame:
        raise ValueError(f'target and source are both "{target_frame}": choose two frames')
    if language not in WORDS:
        raise ValueError(f'there is no sentence in "{language}"; languages are {", ".join(WORDS)}')
    return SentencePanel(poses, target_frame, source_frame, language)


def between(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> StampedTransform:
    """Return `target_T_source` of two frames whose poses are known, as a buffer of static transforms would."""
    target_T_source = poses[target_frame].inverse() @ poses[source_frame]
    return StampedTransform(
        target_frame, source_frame, 0, Transform(target_T_source.translation, canonical(target_T_source.rotation))
    )


def _pair_without_repeat(before: Pair, chosen: Pair) -> Pair:
    """Return the chosen pair, or, if a frame was chosen that the other menu has, the pair the other way round."""
    target, source = chosen
    return (before[1], before[0]) if target == source else chosen


def _menu(description: str, options, value, language: str, width: str = "560px") -> widgets.Dropdown:
    follow = said("choose, and the others follow", language)
    return menu(said(description, language), options, value, follow, label_width="60px", width=width)


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


TREE_WORDS = {
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
    if language not in TREE_WORDS:
        raise ValueError(f'there are no words in "{language}"; languages are {", ".join(TREE_WORDS)}')
    words = TREE_WORDS[language]
    first = next(iter(parent_of))
    child = _tree_menu(words.move, list(parent_of), first, words.chosen)
    parent = _tree_menu(words.under, [*frames, misspelt], parent_of[first], words.chosen)
    source = _tree_menu(words.source, frames, source_frame, words.chosen)
    target = _tree_menu(words.target, frames, target_frame, words.chosen)
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


def _tree_menu(description: str, options: list[str], value: str, chosen: str) -> widgets.Dropdown:
    return menu(description, options, value, chosen, label_width="90px", width="330px")
