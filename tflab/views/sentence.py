"""Draw a lookup with its target and source, and the two readings of "from A to B".

    data expressed in [laser_frame], wanted in [map]
                  source                  target
    lookup_transform('map', 'laser_frame', t)
    laser_frame o------------------------> map           the direction of the data
    4x4 matrix        map_p = map_T_laser_frame.apply(laser_frame_p)
    tf2_echo map laser_frame                             the pose of laser_frame in map

"From A to B" can be read both ways: `A_T_B` is the pose of B in A, and it moves data from B to A.
The sentence without "from" and "to" is unambiguous. The help of tf2_echo itself calls its first
argument "source_frame"; it is the target of the lookup.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tflab.core import LATEST, NSEC_PER_SEC, StampedTransform, Transform

from . import style
from .frames import clear_paper, draw_arrow, draw_frames, draw_ground, show_frames, write_caption
from .labels import place_labels
from .picture import Picture
from .projection import SLANTING


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
        super().__init__((style.WIDE[0], 4.3))
        self.poses, self._language = dict(poses), language
        places = np.array([pose.translation for pose in self.poses.values()])
        span_m = float(np.ptp(places, axis=0).max()) or 1.0
        length_m = 0.22 * span_m
        with style.our_settings():
            ax = self.figure.add_axes((0.02, 0.36, 0.62, 0.61))
            ax.set_axis_off()
            show_frames(ax, SLANTING, places, length_m, margin_m=0.4 * length_m)
            low, high = places.min(axis=0) - 2 * length_m, places.max(axis=0) + 2 * length_m
            draw_ground(ax, SLANTING, (low[0], high[0]), (low[1], high[1]), 0.5 * span_m)
            self.frames = draw_frames(ax, self.poses, SLANTING, length_m)
            self.arrow = draw_arrow(ax, (0, 0, 0), (1, 0, 0), "", SLANTING, curve=-0.25)
            self.words = self.figure.text(0.03, 0.31, "", fontsize=style.TITLE_PT, va="top", color=style.ACCENT)
            self.lines = self.add_number_table(0.03, 0.235)
            self.matrix = self.add_number_table(0.66, 0.78)
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


CAPTIONS = ("reading 1: the pose of {b} in {a}", "reading 2: data of {a}, wanted in {b}")
DASHES = (0, (4.0, 2.0))


def describe_readings(a: str, b: str, a_T_b: Transform) -> str:
    """Return both readings of "from a to b" in words, with their matrices."""
    lines = [f'"from {a} to {b}"']
    for caption, name, transform in zip(CAPTIONS, _names(a, b), (a_T_b, a_T_b.inverse()), strict=True):
        lines += [f"{caption.format(a=a, b=b)}: {name}", *(f"  {row}" for row in matrix_rows(transform))]
    return "\n".join(lines)


def draw_readings(a: str, b: str, a_T_b: Transform) -> Picture:
    """Draw both readings of "from a to b" beside each other."""
    picture = Picture((style.WIDE[0], 3.3))
    span_m = float(np.abs(a_T_b.translation).max()) or 1.0
    places = np.array(((0.0, 0.0, 0.0), a_T_b.translation))
    length_m = 0.4 * span_m
    with style.our_settings():
        readings = zip(CAPTIONS, _names(a, b), (a_T_b, a_T_b.inverse()), (a, b), strict=True)
        for column, (caption, name, transform, axes_of) in enumerate(readings):
            ax = clear_paper(picture.figure.add_axes((0.015 + 0.495 * column, 0.15, 0.475, 0.81)))
            show_frames(ax, SLANTING, places, length_m, margin_m=0.5 * length_m)
            draw_ground(ax, SLANTING, (-span_m, 2 * span_m), (-span_m, span_m), 0.5 * span_m)
            draw_frames(ax, {a: Transform(), b: a_T_b}, SLANTING, length_m)
            draw_arrow(ax, *places, curve=0.0 if column == 0 else 0.18, line="solid" if column == 0 else DASHES)
            write_caption(ax, caption.format(a=a, b=b))
            numbers = f"{style.fmt_all(transform.translation, digits=2)} along the axes of {axes_of}"
            middle = {"x": 0.25 + 0.495 * column, "ha": "center", "va": "center", "color": style.ACCENT}
            picture.figure.text(y=0.105, s=name, fontsize=style.TITLE_PT, family="monospace", **middle)
            picture.figure.text(y=0.04, s=numbers, fontsize=style.TEXT_PT, **middle)
    picture.text = describe_readings(a, b, a_T_b)
    return picture


def _names(a: str, b: str) -> tuple[str, str]:
    """Return the transforms of both readings."""
    return f"{a}_T_{b}", f"{b}_T_{a}"
