"""Define the errors that a bag can cause.

    a path --> no such file | empty | not a bag | cut short | not readable

One class, one line of text: which file, what is wrong, what to try.
"""

from __future__ import annotations

__all__ = ["BagError"]


class BagError(Exception):
    """A bag cannot be read or written; the text is one line that says why."""
