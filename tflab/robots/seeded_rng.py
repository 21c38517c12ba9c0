"""Make a random generator from a seed and a name.

    seeded_rng(0, "laser")    a stream of numbers of its own      (a pseudo-random generator, seeded by name)
    seeded_rng(0, "camera")   another one, which has nothing to do with it

Everything that draws does so under a name, never under its place in a list: a sensor
or a fault that is added, anywhere, leaves what all the others draw as it was.
"""

from __future__ import annotations

from zlib import crc32

import numpy as np

__all__ = ["seeded_rng"]


def seeded_rng(seed: int, name: str, stamp_ns: int = 0) -> np.random.Generator:
    """Return the generator that draws under `name`, a new one for each moment [ns] if one is given."""
    return np.random.default_rng([seed, crc32(name.encode()), stamp_ns])
