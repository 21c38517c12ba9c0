"""What can an executor execute?  Timers, subscriptions, guard conditions, clients, services."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import Any

__all__ = ["Entity", "Kind"]


class Kind(IntEnum):
    """The order in which a node's entities have their turn within a round of waiting."""

    WAITABLE = 0
    TIMER = 1
    SUBSCRIPTION = 2
    GUARD_CONDITION = 3
    CLIENT = 4
    SERVICE = 5


class Entity:
    """One thing of a node that can become ready and has a callback."""

    kind: Kind

    def __init__(self, node: Any, callback_group: Any) -> None:
        self.node = node
        self.callback_group = callback_group
        self.rank = (self.kind, node.next_rank())
        self.is_destroyed = False
        callback_group.add_entity(self)

    def mark_ready(self) -> None:
        """Tell the node's executor that there is something to do."""
        node = self.node
        node.pending[self] = None
        executor = node.executor
        if executor is not None:
            executor.wake()

    def is_pending(self) -> bool:
        """Return whether there is something to do."""
        raise NotImplementedError

    def take(self) -> Callable[[], Any]:
        """Take one thing; return what calls the callback with it, in whichever thread.

        The executor that found it pending takes it, before anybody looks again.
        """
        raise NotImplementedError

    def destroy(self) -> None:
        """Have nothing to do any more."""
        self.is_destroyed = True
        self.node.pending.pop(self, None)

    def __enter__(self) -> Entity:
        return self

    def __exit__(self, *exc: object) -> None:
        self.destroy()
