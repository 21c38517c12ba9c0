"""Which one is the target?  Five ways to say it, and choosing in one changes the others.

    data expressed in [laser_frame v], wanted in [map v]
    Python    lookup_transform('map', 'laser_frame', Time())  v
    arrow     laser_frame o--------> map                      v
    shell     ros2 run tf2_ros tf2_echo map laser_frame       v
    and the picture with the matrix

The pure function behind it is `tflab.views.sentence.sentence`.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import permutations

from tflab.core import StampedTransform, Transform
from tflab.core.quaternions import canonical

from ..libraries import ipywidgets as widgets
from ..sentence import SentencePicture, sentence
from .drawn_ahead import At
from .panel import Panel, menu
from .words import said

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
