"""Draw a task's numbers: the same for the same seed, whatever the version of NumPy.

NumPy keeps the raw output of its bit generators and says so (NEP 19), but not what its
`Generator` makes of it.  A learner's numbers must stay the same while a course lasts, so
the few methods that tasks need are defined here on the raw output of PCG64.  They give
the numbers that `numpy.random.Generator` gives today, except `standard_normal`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod
from statistics import NormalDist
from typing import Any

import numpy as np

__all__ = ["Draws"]

BITS_32 = 2**32


class Draws:
    """A seeded source of numbers with the methods of `numpy.random.Generator` that tasks use."""

    def __init__(self, seed: int) -> None:
        self._source = np.random.PCG64(seed)
        self._half: int | None = None  # the upper 32 bits of a raw number of which the lower ones were used

    def random(self) -> float:
        """Return a number in [0, 1)."""
        return (int(self._source.random_raw()) >> 11) * 2.0**-53

    def uniform(self, low: Any = 0.0, high: Any = 1.0, size: int | tuple[int, ...] | None = None) -> Any:
        """Return a number in [low, high), or an array of them if a bound is a sequence or a size is given."""
        if size is None and np.ndim(low) == np.ndim(high) == 0:
            return low + (high - low) * self.random()
        shape = np.broadcast_shapes(np.shape(low), np.shape(high)) if size is None else size
        numbers = np.array([self.random() for _ in range(_count(shape))]).reshape(shape)
        return np.asarray(low) + (np.asarray(high) - np.asarray(low)) * numbers

    def standard_normal(self) -> float:
        """Return a number of the normal distribution with mean 0 and standard deviation 1."""
        return NormalDist().inv_cdf(max(self.random(), 2.0**-53))

    def integers(self, low: int, high: int | None = None, size: int | tuple[int, ...] | None = None) -> Any:
        """Return an integer in [low, high), or in [0, low) without `high`; an array of them if a size is given."""
        low, high = (0, low) if high is None else (low, high)
        if size is None:
            return low + self._below(high - low)
        return np.array([low + self._below(high - low) for _ in range(_count(size))]).reshape(size)

    def choice(self, options: int | Sequence[Any], size: int | None = None, replace: bool = True) -> Any:
        """Return one of the options, or an array of `size` of them; an integer n stands for 0 ... n-1."""
        options = np.arange(options) if isinstance(options, int | np.integer) else np.asarray(options)
        if size is None:
            return options[self._below(len(options))]
        if replace:
            return options[[self._below(len(options)) for _ in range(size)]]
        return options[self._sample(len(options), size)]

    def permutation(self, options: int | Sequence[Any]) -> np.ndarray:
        """Return the options in another order; an integer n stands for 0 ... n-1."""
        options = np.arange(options) if isinstance(options, int | np.integer) else np.asarray(options)
        return options[_shuffled(list(range(len(options))), self._up_to)]

    def _sample(self, count: int, size: int) -> list[int]:
        """Return `size` different numbers below `count` (Floyd's algorithm), in any order."""
        chosen: list[int] = []
        for last in range(count - size, count):
            number = self._below(last + 1)
            chosen.append(last if number in chosen else number)
        return _shuffled(chosen, lambda last: self._below(last + 1))

    def _below(self, count: int) -> int:
        """Return an integer in [0, count), each as likely as the others (Lemire, arXiv:1805.10941)."""
        count = int(count)
        if not 1 <= count <= BITS_32:
            raise ValueError(f"from 1 to {BITS_32} integers to draw from, not {count}")
        if count == 1:
            return 0
        product = self._bits_32() * count
        if product % BITS_32 < count:
            threshold = (BITS_32 - count) % count
            while product % BITS_32 < threshold:
                product = self._bits_32() * count
        return product // BITS_32

    def _up_to(self, last: int) -> int:
        """Return an integer in [0, last], each as likely as the others, by rejection."""
        mask = 2 ** last.bit_length() - 1
        while (number := self._bits_32() & mask) > last:
            pass
        return number

    def _bits_32(self) -> int:
        if self._half is not None:
            number, self._half = self._half, None
            return number
        self._half, number = divmod(int(self._source.random_raw()), BITS_32)
        return number


def _shuffled(numbers: list[int], up_to: Callable[[int], int]) -> list[int]:
    """Return the numbers in another order (Fisher and Yates)."""
    for last in range(len(numbers) - 1, 0, -1):
        other = up_to(last)
        numbers[last], numbers[other] = numbers[other], numbers[last]
    return numbers


def _count(shape: int | tuple[int, ...]) -> int:
    return prod(shape) if isinstance(shape, tuple) else shape
