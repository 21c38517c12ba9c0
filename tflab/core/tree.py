"""Number the frames and keep one cache for each child.

            map  (1: no history, so a root)
             |
            odom (2: a history whose samples name 1 as parent)
            /
    base_link (3)        NO_PARENT (0: tf2's word for "none")

A frame is born when its name is first heard, as child or as parent, gets the
next number, and is never forgotten.  The tree itself is not stored anywhere:
each sample names its own parent, so the shape may change from one moment to the
next, and nothing stops two samples from closing a loop.

tf2 keeps this in BufferCore (frameIDs_, frames_, frame_authority_).
"""

from __future__ import annotations

from .cache import Cache, StaticCache, TimeCache

__all__ = ["NO_PARENT", "FrameTree"]

NO_PARENT = "NO_PARENT"


class FrameTree:
    """Every frame ever named; `caches[n]` is the history of frame number n, None for a root.

    Attributes:
        names: name of each number.
        numbers: number of each name.
        caches: history of each number.
        authorities: who last set each child, by number.
        has_infinity: whether any translation ever stored was infinite (tf2 allows it).
    """

    def __init__(self, cache_time_ns: int) -> None:
        self.cache_time_ns = cache_time_ns
        self.names: list[str] = [NO_PARENT]
        self.numbers: dict[str, int] = {NO_PARENT: 0}
        self.caches: list[Cache | None] = [None]
        self.authorities: dict[int, str] = {}
        self.has_infinity = False

    def number_of(self, name: str) -> int:
        """Return the number of a frame, a new one if the name was never heard."""
        number = self.numbers.get(name)
        if number is None:
            number = self.numbers[name] = len(self.names)
            self.names.append(name)
            self.caches.append(None)
        return number

    def cache_for(self, number: int, is_static: bool) -> Cache:
        """Return the history of a child, of the kind asked for.

        A child that changes its kind starts anew with an empty history, as in tf2.
        """
        cache = self.caches[number]
        if cache is None or cache.is_static != is_static:
            cache = self.caches[number] = StaticCache() if is_static else TimeCache(self.cache_time_ns)
        return cache

    def known_names(self) -> tuple[str, ...]:
        """Return every name, in the order in which they were first heard."""
        return tuple(self.names[1:])
