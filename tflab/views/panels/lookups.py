"""Panels for lookups: choose target and source in any of five forms, or give a frame another parent."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import permutations

from tflab.core import StampedTransform, Transform
from tflab.core.quaternions import canonical
from tflab.text import Texts, language_of_workbook

from ..libraries import ipywidgets as widgets
from ..sentence import SentencePicture, sentence
from ..tree_path import TreeWalkPicture, snapshot_of_parents
from .panel import Panel, menu
from .prefetch import Controls

TEXTS = Texts(__file__)

Pair = tuple[str, str]  # target, source
Edge = tuple[str, str]  # parent, child
Ask = Callable[[list[Edge], str, str], tuple[bool, str]]  # edges as sent, target, source -> an answer at all? its text

MISSPELT = "odm"  # a parent that no edge has otherwise
LINES = 2  # for tf2's text, besides one for each frame: of a loop it names every edge


class SentencePanel(Panel):
    """A lookup that can be chosen in any of its forms; the other forms follow."""

    def __init__(self, poses: Mapping[str, Transform], target: str, source: str) -> None:
        self._answers = {pair: transform_between(poses, *pair) for pair in permutations(poses, 2)}
        forms = {pair: sentence(answer) for pair, answer in self._answers.items()}
        self._pair: Pair = (target, source)
        self._is_following = False
        language = language_of_workbook()
        hint, frames = TEXTS["forms follow"], [(frame, frame) for frame in poses]
        self._source = menu(TEXTS["source"], frames, source, hint, "60px", "250px")
        self._target = menu(TEXTS["target"], frames, target, hint, "60px", "250px")
        lines = {"Python": "call", TEXTS["arrow"]: "arrow", TEXTS["shell"]: "echo_command"}
        self._lines = [
            menu(name, [(getattr(form, part), pair) for pair, form in forms.items()], self._pair, hint, "60px", "560px")
            for name, part in lines.items()
        ]
        pieces = TEXTS["question"].say(language, source="|", target="|").split("|")
        before, between_menus, after = map(widgets.Label, pieces)
        picture = SentencePicture(poses, language)
        super().__init__(
            "One question about two frames, said in five ways",
            picture,
            (self._source, self._target, *self._lines),
            lambda at: picture.show(self._answers[self._pair_at(at)]),
            layout=[widgets.HBox([before, self._source, between_menus, self._target, after]), *self._lines],
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

    def _pair_at(self, at: Controls) -> Pair:
        """Return the pair when one menu has been set, and the others have not followed yet."""
        if at.moved in self._lines:
            return at(at.moved)
        return _pair_without_repeat(self._pair, (at(self._target), at(self._source)))


def sentence_panel(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> SentencePanel:
    """Return a panel in which a lookup can be chosen in any of its forms.

    Args:
        poses: the pose of each frame in the drawing's own frame, `fixed_T_name`; at least two.
        target_frame, source_frame: what to begin with.

    Raises:
        ValueError: `poses` lacks one of the frames, or both are the same.
    """
    for frame in (target_frame, source_frame):
        if frame not in poses:
            raise ValueError(f'no pose is given for "{frame}"; there are poses for {", ".join(poses)}')
    if target_frame == source_frame:
        raise ValueError(f'target and source are both "{target_frame}": choose two frames')
    return SentencePanel(poses, target_frame, source_frame)


def transform_between(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> StampedTransform:
    """Return `target_T_source` of two frames whose poses are known, as a buffer of static transforms would."""
    target_T_source = poses[target_frame].inverse() @ poses[source_frame]
    return StampedTransform(
        target_frame, source_frame, 0, Transform(target_T_source.translation, canonical(target_T_source.rotation))
    )


def _pair_without_repeat(before: Pair, chosen: Pair) -> Pair:
    """Return the chosen pair, or, if a frame was chosen that the other menu has, the pair the other way round."""
    target, source = chosen
    return (before[1], before[0]) if target == source else chosen


def tree_panel(
    parent_of: Mapping[str, str],
    target_frame: str,
    source_frame: str,
    ask: Ask,
) -> Panel:
    """Return a panel in which a frame can be given another parent, and a lookup shows tf2's text below the picture.

    Args:
        parent_of: the tree to begin with, child -> parent.
        target_frame, source_frame: the lookup to begin with.
        ask: tf2's answer: for edges (parent, child) in the order they are sent, and a lookup.

    Raises:
        ValueError: a frame is not in the tree.
    """
    frames = list(dict.fromkeys(name for child, parent in parent_of.items() for name in (parent, child)))
    for frame in (target_frame, source_frame):
        if frame not in frames:
            raise ValueError(f'there is no frame "{frame}" in this tree; there is {", ".join(frames)}')
    first = next(iter(parent_of))
    rows = (
        (TEXTS["move"], list(parent_of), first),
        (TEXTS["under"], [*frames, MISSPELT], parent_of[first]),
        (TEXTS["source"], frames, source_frame),
        (TEXTS["target"], frames, target_frame),
    )
    follows = TEXTS["tree follows"]
    menus = [menu(name, names, value, follows, "90px", "330px") for name, names, value in rows]
    picture = TreeWalkPicture(len(frames) + 1, len(frames) + LINES)

    def move(at: Controls) -> None:
        child, parent, source, target = map(at, menus)
        sent = [(above, below) for below, above in parent_of.items()]
        sent += [(parent, child)] if parent_of[child] != parent else []
        now = dict(parent_of)
        if parent != child:  # tf2 rejects a frame that is its own parent, and keeps what it had
            now[child] = parent
        is_answer, text = ask(sent, target, source)
        picture.show(snapshot_of_parents(now, frames), target, source, text, is_answer)

    return Panel("A tree whose frames can be moved", picture, menus, move)
