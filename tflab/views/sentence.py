"""Which one is the target?  One question, said in five ways.

    data expressed in [laser_frame], wanted in [map]
                  source                  target
    lookup_transform('map', 'laser_frame', t)
    laser_frame o------------------------> map           the way the data goes
    4x4 matrix        map_p = map_T_laser_frame.apply(laser_frame_p)
    tf2_echo map laser_frame                             where laser_frame sits in map

"From A to B" can be read both ways, and for ten years people have reported tf2
as reversed.  The sentence without "from" and "to" cannot: what the data is
written in is the source, what it is wanted in is the target, and the target comes
first in every call.

The help of tf2_echo itself calls its first argument "source_frame"; it is the
target of the lookup.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tflab.core import LATEST, NSEC_PER_SEC, StampedTransform, Transform

from . import style
from .eye import SLANTING
from .frames import draw_arrow, draw_frames, draw_ground, show_all
from .labels import place_labels
from .picture import Picture


@dataclass(frozen=True, slots=True)
class Sentence:
    """One question and its answer, said in five ways.

    Attributes:
        english, korean: what is wanted, read aloud.
        call: the same in Python.
        arrow: the way the data goes.
        matrix: `target_T_source`, four rows.
        echo_command, echo_output: the same in a terminal.
    """

    english: str
    korean: str
    call: str
    arrow: str
    matrix: tuple[str, str, str, str]
    echo_command: str
    echo_output: str

    @property
    def text(self) -> str:
        """All of it, for a terminal or a screen reader."""
        return self.text_in("en")

    def text_in(self, language: str) -> str:
        """Return the same with the sentence in another language: "en" or "ko"."""
        read_aloud = self.korean if language == "ko" else self.english
        return "\n".join((read_aloud, self.call, self.arrow, *self.matrix, self.echo_command, self.echo_output))


def sentence(stamped: StampedTransform, asked_ns: int = LATEST) -> Sentence:
    """Return a question and its answer in five ways.

    Args:
        stamped: the answer of lookup_transform; its frame_id is the target, its child_frame_id the source.
        asked_ns: the moment that was asked for [ns].
    """
    target, source = stamped.frame_id, stamped.child_frame_id
    when = "Time()" if asked_ns == LATEST else f"Time(nanoseconds={asked_ns:_})"
    return Sentence(
        english=f"data expressed in [{source}], wanted in [{target}]",
        korean=f"[{source}] 기준으로 표현된 데이터를 [{target}] 기준으로 보고 싶습니다.",
        call=f"lookup_transform('{target}', '{source}', {when})",
        arrow=f"{source} o--------> {target}",
        matrix=matrix_rows(stamped.transform),
        echo_command=f"ros2 run tf2_ros tf2_echo {target} {source}",
        echo_output=echo_text(stamped),
    )


def matrix_rows(transform: Transform) -> tuple[str, str, str, str]:
    """Return the four rows of a 4x4 matrix, in brackets."""
    rows = [[f"{style.fmt(cell, unit=''):>6}" for cell in row] for row in transform.matrix()]
    return tuple(f"[{' '.join(row)} ]" for row in rows)


def echo_text(stamped: StampedTransform) -> str:
    """Return what tf2_echo prints for a transform, to the letter.

    A level pose shows a pitch of -0.000, because the tool computes it as minus
    an arc sine; and the nanoseconds of the stamp are printed without leading zeros.
    """
    matrix = stamped.transform.matrix()
    roll, pitch, yaw = _rpy_of_echo(matrix)
    sec, nanosec = divmod(stamped.stamp_ns, NSEC_PER_SEC)
    lines = [
        f"At time {sec}.{nanosec}",
        f"- Translation: {_bracketed(stamped.transform.translation)}",
        f"- Rotation: in Quaternion {_bracketed(stamped.transform.rotation)}",
        f"- Rotation: in RPY (radian) {_bracketed((roll, pitch, yaw))}",
        f"- Rotation: in RPY (degree) {_bracketed(map(math.degrees, (roll, pitch, yaw)))}",
        "- Matrix:",
        *("".join(f" {cell:6.3f}" for cell in row) for row in matrix),
    ]
    return "\n".join(lines)


def _bracketed(values) -> str:
    return f"[{', '.join(f'{value:.3f}' for value in values)}]"


def _rpy_of_echo(matrix: np.ndarray) -> tuple[float, float, float]:
    """Return roll, pitch, yaw [rad] as tf2's getRPY does, with its minus zero."""
    down = matrix[2, 0]
    if abs(down) >= 1.0:  # looking straight up or down, yaw is called zero
        return (math.atan2(matrix[2, 1], matrix[2, 2]), math.copysign(math.pi / 2, -down), 0.0)
    return (
        math.atan2(matrix[2, 1], matrix[2, 2]),
        -math.asin(down),
        math.atan2(matrix[1, 0], matrix[0, 0]),
    )


class SentencePicture(Picture):
    """All frames, an arrow from source to target, and the sentence, the call and the matrix."""

    def __init__(self, poses: Mapping[str, Transform], language: str = "en") -> None:
        """Draw the frames; `language` is that of `text`."""
        from .typed import TypedBlock

        super().__init__((style.WIDE[0], 4.3))
        self.poses, self._language = dict(poses), language
        places = np.array([pose.translation for pose in self.poses.values()])
        span_m = float(np.ptp(places, axis=0).max()) or 1.0
        length_m = 0.22 * span_m
        with style.our_settings():
            ax = self.figure.add_axes((0.02, 0.36, 0.62, 0.61))
            ax.set_axis_off()
            reach = length_m * np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (0, 1)])
            corners = (places[:, None] + reach).reshape(-1, 3)
            show_all(ax, SLANTING.on_paper(corners), margin_m=0.4 * length_m)
            low, high = places.min(axis=0) - 2 * length_m, places.max(axis=0) + 2 * length_m
            draw_ground(ax, SLANTING, (low[0], high[0]), (low[1], high[1]), 0.5 * span_m)
            self.frames = draw_frames(ax, self.poses, SLANTING, length_m)
            self.arrow = draw_arrow(ax, (0, 0, 0), (1, 0, 0), "", SLANTING, curve=-0.25)
            self.words = self.figure.text(0.03, 0.31, "", fontsize=style.TITLE_PT, va="top", color=style.ACCENT)
            self.lines = TypedBlock(self.figure, 0.03, 0.235)
            self.matrix = TypedBlock(self.figure, 0.66, 0.78)
        self.moving = [self.arrow.arrow, *(part for frame in self.frames.values() for part in frame.label.artists)]
        self.moving += [self.words, self.lines, self.matrix]

    def show(self, stamped: StampedTransform, asked_ns: int = LATEST) -> SentencePicture:
        """Show this answer, `target_T_source`, and return the picture."""
        target, source = stamped.frame_id, stamped.child_frame_id
        said = sentence(stamped, asked_ns)
        with style.our_settings():
            self.arrow.move(self.poses[source].translation, self.poses[target].translation)
            labels = {name: frame.label for name, frame in self.frames.items()}
            for name, label in labels.items():
                roles = [role for role, frame in (("target", target), ("source", source)) if frame == name]
                label.text.set_text("\n".join((name, *roles)))
                label.text.set_color(style.ACCENT if roles else style.GREY)
            place_labels([*labels.values(), self.arrow.label])
            self.words.set_text(said.english)
            product = f"{target}_p = {target}_T_{source}.apply({source}_p)"
            self.lines.write("\n".join((said.call, f"tf2_echo {target} {source}", product)))
            self.matrix.write("\n".join(said.matrix))
        self.text = said.text_in(self._language)
        return self


def draw_sentence(poses: Mapping[str, Transform], stamped: StampedTransform, asked_ns: int = LATEST) -> SentencePicture:
    """Draw a question and its answer among all frames.

    Args:
        poses: where each frame is in the drawing's own frame, `fixed_T_name`.
        stamped: the answer of lookup_transform.
    """
    return SentencePicture(poses).show(stamped, asked_ns)
