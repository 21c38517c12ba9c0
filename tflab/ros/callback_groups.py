"""Who may run beside whom?  Callback groups.

A node's callbacks are in one mutually exclusive group unless they are put
elsewhere: while one of them runs, the others wait, even with many threads.
tf2's listener is reentrant, so transforms keep arriving.
"""

from __future__ import annotations

import weakref
from typing import Any

__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"]


class CallbackGroup:
    """What the two kinds share: a list of members."""

    def __init__(self) -> None:
        self._members: weakref.WeakSet = weakref.WeakSet()

    def add_entity(self, entity: Any) -> None:
        """Take a timer, subscription, service ... in."""
        self._members.add(entity)

    def has_entity(self, entity: Any) -> bool:
        """Return whether it is a member."""
        return entity in self._members

    def can_execute(self, entity: Any) -> bool:
        """Return whether a member's callback may begin now."""
        raise NotImplementedError

    def beginning_execution(self, entity: Any) -> bool:
        """Note that a member's callback begins; return False if it may not."""
        raise NotImplementedError

    def ending_execution(self, entity: Any) -> None:
        """Note that it has ended."""
        raise NotImplementedError


class ReentrantCallbackGroup(CallbackGroup):
    """Any of its callbacks may run at any time, several at once."""

    def can_execute(self, entity: Any) -> bool:
        return True

    def beginning_execution(self, entity: Any) -> bool:
        return True

    def ending_execution(self, entity: Any) -> None:
        pass


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One of its callbacks runs at a time."""

    def __init__(self) -> None:
        super().__init__()
        self._active: Any = None

    def can_execute(self, entity: Any) -> bool:
        return self._active is None

    def beginning_execution(self, entity: Any) -> bool:
        if self._active is not None:
            return False
        self._active = entity
        return True

    def ending_execution(self, entity: Any) -> None:
        assert self._active is entity
        self._active = None
