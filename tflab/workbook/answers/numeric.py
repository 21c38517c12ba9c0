"""Define the numeric forms of answers: numbers, angles, vectors, rotations and transforms."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from ...text import Text, Texts
from .form import Form, Mark, Probe, Row, member, numbers_of, pose_of
from .values import Plain

__all__ = ["Angle", "Number", "Pose", "Quaternion", "Vector"]

TEXTS = Texts(__file__)
LETTERS = "xyzw"
ROUNDING_DEG = 1e-6
FEWEST_DIGITS = 3  # of a number, for two mistakes that give it to be no chance


class NumberForm(Form):
    """What one number and a row of numbers share."""

    is_measured: ClassVar[bool] = True

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        given, wanted = self.numbers(answer), self.numbers(expected)
        return self.compare(given, wanted) if given and wanted else None

    def compare(self, given: Sequence[float], wanted: Sequence[float]) -> Text:
        """Return in which direction, and how far, numbers are off."""
        raise NotImplementedError


@dataclass(frozen=True)
class Number(NumberForm):
    """One number [unit]."""

    unit: str = ""
    tolerance: float = 1e-3
    mistakes: ClassVar = (
        *("a_time", "a_stamp", "one_text", "unit", "sign", "one over it", "twice", "half", "squared", "root"),
        *("power of ten", "zeros", "count", "no sign", "rounded"),
    )

    def probes(self, plain: Plain) -> list[Probe] | None:
        row = numbers_of(plain, None)
        return None if row is None else [[(Mark(row[0], self.tolerance),)]]

    def wanted(self) -> Text:
        unit = f" [{self.unit}]" if self.unit else ""
        return Text(en=f"one number{unit}", ko=f"숫자 하나{unit}")

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        said = super().describe_difference(answer, expected)
        is_cut = self.unit and 0 < self.digits(answer) < min(FEWEST_DIGITS, self.digits(expected))
        return Text.joined(said, TEXTS["more_digits"], between="") if said and is_cut else said

    def digits(self, plain: Plain) -> int:
        """Return how many significant digits a number has, of nine behind its point; 0 of what is none."""
        numbers = self.numbers(plain)
        return len(f"{abs(numbers[0]):.9f}".replace(".", "").strip("0")) if numbers else 0

    def compare(self, given: Sequence[float], wanted: Sequence[float]) -> Text:
        have, want = given[0], wanted[0]
        large = have > want
        side = Text("too large", "너무 큽니다") if large else Text("too small", "너무 작습니다")
        off = abs(have - want)
        if off < 0.1 * abs(want):
            return Text(f"{side.en}, by less than 10 %", f"{side.ko}(차이는 10% 이내)")
        if off <= abs(want):
            return Text(f"{side.en}, by more than 10 %", f"{side.ko}(차이는 10% 초과)")
        return Text(f"{side.en}, by more than the answer itself", f"{side.ko}(차이가 정답의 크기보다 큼)")

    def is_short(self, plain: Plain) -> bool:
        return self.numbers(plain) is not None and self.digits(plain) < FEWEST_DIGITS


@dataclass(frozen=True)
class Angle(NumberForm):
    """An angle [rad]; a full turn more or less is the same."""

    tolerance: float = 1e-3
    unit = "rad"
    mistakes: ClassVar = (
        *("three_angles", "one_text", "its_yaw"),
        *("unit", "sign", "half a turn", "z for the angle", "twice", "half the angle", "zeros", "rounded"),
    )

    def probes(self, plain: Plain) -> list[Probe] | None:
        row = numbers_of(plain, None)
        if row is None:
            return None
        angle = math.remainder(row[0], math.tau)
        return [[(Mark(angle + turn, self.tolerance),) for turn in (0.0, math.tau, -math.tau)]]

    def wanted(self) -> Text:
        return Text(en="one angle [rad]", ko="각도 하나 [rad]")

    def compare(self, given: Sequence[float], wanted: Sequence[float]) -> Text:
        off = math.remainder(given[0] - wanted[0], math.tau)
        size = _degrees(abs(off))
        if off > 0:
            return Text(f"rotated too far to the left, by {size.en}", f"왼쪽으로 {size.ko} 더 회전했습니다")
        return Text(f"rotated too far to the right, by {size.en}", f"오른쪽으로 {size.ko} 더 회전했습니다")


@dataclass(frozen=True)
class Vector(NumberForm):
    """`size` numbers [unit], expressed in `frame`; a message with x, y, z will do, and its frame is looked at."""

    size: int = 3
    unit: str = "m"
    frame: str = ""
    tolerance: float = 1e-3
    mistakes: ClassVar = (
        *("joined", "a_text", "its_translation", "unit", "all signs", "exchanged", "one sign", "places and signs"),
        *("twice", "half", "power of ten", "zeros", "rounded"),
    )

    def probes(self, plain: Plain) -> list[Probe] | None:
        frame = member(plain, "header", "frame_id")
        if frame is not None and self.frame and frame != self.frame:
            return None
        row = numbers_of(plain, self.size)
        return None if row is None else [[tuple(Mark(number, self.tolerance) for number in row)]]

    def wanted(self) -> Text:
        unit = f" [{self.unit}]" if self.unit else ""
        where = f" in {self.frame}" if self.frame else ""
        names = " (x, y, z)" if self.size == 3 else ""
        return Text(
            en=f"{self.size} numbers{names}{unit}{where}",
            ko=f"{self.frame + ' 기준 ' if self.frame else ''}숫자 {self.size}개{names}{unit}",
        )

    def numbers(self, plain: Plain) -> tuple[float, ...] | None:
        return numbers_of(plain, self.size)

    def compare(self, given: Sequence[float], wanted: Sequence[float]) -> Text:
        return _compare_vectors(given, wanted, self.tolerance)


@dataclass(frozen=True)
class Quaternion(NumberForm):
    """A rotation (x, y, z, w); q and -q are the same."""

    tolerance: float = 1e-3
    mistakes: ClassVar = (
        *("joined", "one_inside", "a_matrix", "rows", "without_zeros", "angles", "its_rotation"),
        *("w first", "w taken first", "inverse rotation", "not normalised", "whole angle", "half angle", "one sign"),
        *("exchanged", "w left at 1", "angles for a quaternion", "rounded"),
    )

    def probes(self, plain: Plain) -> list[Probe] | None:
        row = numbers_of(plain, 4)
        return None if row is None else [_both_signs((), row, self.tolerance)]

    def wanted(self) -> Text:
        return Text(en="a quaternion: 4 numbers (x, y, z, w)", ko="쿼터니언: 숫자 네 개 (x, y, z, w)")

    def numbers(self, plain: Plain) -> tuple[float, ...] | None:
        return numbers_of(plain, 4)

    def compare(self, given: Sequence[float], wanted: Sequence[float]) -> Text:
        return _compare_rotations(given, wanted, self.tolerance)


@dataclass(frozen=True)
class Pose(Form):
    """A transform: a Transform, a StampedTransform, a message of either, or a 4x4 matrix.

    Where the expected value names frames, so must the answer; with `stamp`, its time counts too.
    """

    tolerance_m: float = 1e-3
    tolerance_rad: float = 1e-3
    stamp: bool = False
    frames: bool = False
    is_measured: ClassVar[bool] = True
    mistakes: ClassVar = (
        *("transposed", "inverse transform", "not turned back", "translation taken away", "w first", "w taken first"),
        *("inverse rotation", "not normalised", "whole angle", "half angle", "exchanged"),
    )

    def probes(self, plain: Plain) -> list[Probe] | None:
        parts = pose_of(plain)
        if parts is None:
            return None
        names, stamp_ns, translation, rotation = parts
        if self.frames and names is None:
            return None
        row = tuple(Mark(name) for name in names or ()) if self.frames else ()
        row += (Mark(str(stamp_ns)),) if self.stamp else ()
        row += tuple(Mark(number, self.tolerance_m) for number in translation)
        return [_both_signs(row, rotation, self.tolerance_rad / 2.0)]

    def wanted(self) -> Text:
        if self.frames:
            return Text(en="a transform with its two frames", ko="두 좌표계 이름이 있는 변환(Transform)")
        return Text(en="a transform: translation and rotation", ko="변환(Transform): 이동과 회전")

    def forms_of_parts(self, like: Plain) -> dict[str, Form]:
        if self.frames or self.stamp:
            return {}
        return {"translation": Vector(3, "m", "", self.tolerance_m), "rotation": Quaternion(self.tolerance_rad)}

    def part_of(self, plain: Plain, name: str) -> Plain:
        parts = pose_of(plain)
        return None if parts is None else list(parts[2 if name == "translation" else 3])

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        given, wanted = pose_of(answer), pose_of(expected)
        if given is None or wanted is None:
            return None
        place = _compare_vectors(given[2], wanted[2], self.tolerance_m)
        turn = _compare_rotations(given[3], wanted[3], self.tolerance_rad / 2.0)  # as the form compares its parts
        return Text(f"translation: {place.en}. Rotation: {turn.en}", f"이동: {place.ko}. 회전: {turn.ko}")


def _both_signs(before: Row, rotation: tuple[float, ...], tolerance: float) -> Probe:
    return [before + tuple(Mark(sign * number, tolerance) for number in rotation) for sign in (1.0, -1.0)]


def _compare_vectors(given: Sequence[float], wanted: Sequence[float], tolerance: float) -> Text:
    rows = list(zip(LETTERS, given, wanted, strict=False))
    right = [name for name, number, other in rows if abs(number - other) <= tolerance]
    large = [name for name, number, other in rows if number - other > tolerance]
    small = [name for name, number, other in rows if other - number > tolerance]
    if not right and abs(math.hypot(*given) - math.hypot(*wanted)) <= 2 * tolerance:
        return TEXTS["direction"]
    pieces = [(right, "right", "맞음"), (large, "too large", "너무 큼"), (small, "too small", "너무 작음")]
    said = [(", ".join(names), en, ko) for names, en, ko in pieces if names]
    return Text("; ".join(f"{names}: {en}" for names, en, _ in said), "; ".join(f"{n}: {ko}" for n, _, ko in said))


def _compare_rotations(given: Sequence[float], wanted: Sequence[float], tolerance: float) -> Text:
    if math.hypot(*given) < 1e-9:
        return Text("all zeros is not a rotation", "모두 0이면 회전이 아닙니다")
    if any(all(abs(sign * a - b) <= tolerance for a, b in zip(given, wanted, strict=True)) for sign in (1.0, -1.0)):
        return Text("right", "맞음")
    cosine = abs(sum(map(lambda a, b: a * b, given, wanted))) / math.hypot(*given) / math.hypot(*wanted)
    size = _degrees(2.0 * math.acos(min(1.0, cosine)))
    return Text(f"off by {size.en}", f"{size.ko} 어긋났습니다")


def _degrees(angle_rad: float) -> Text:
    angle = math.degrees(angle_rad)
    for bound in (1, 5, 15, 45, 90):
        if angle <= bound + ROUNDING_DEG:
            return Text(f"at most {bound}°", f"{bound}° 이내로")
    return Text("more than 90°", "90° 넘게")
