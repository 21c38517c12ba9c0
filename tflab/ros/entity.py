"""Define callback groups, guard conditions and Entity, the base of everything that an executor runs.

A node's callbacks are in one mutually exclusive group unless they are put into
another: while one of them runs, the others wait, even with many threads. The group
of tf2's listener is reentrant, so transforms keep arriving.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable
from enum import IntEnum
from typing import Any

__all__ = [
    "CallbackGroup",
    "Entity",
    "GuardCondition",
    "Kind",
    "MutuallyExclusiveCallbackGroup",
    "ReentrantCallbackGroup",
]


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


class GuardCondition(Entity):
    """Calls back once after each trigger."""

    kind = Kind.GUARD_CONDITION

    def __init__(self, node: Any, callback: Callable[[], Any] | None, callback_group: Any) -> None:
        super().__init__(node, callback_group)
        self.callback = callback
        self._triggered = False

    def trigger(self) -> None:
        """Become ready."""
        self._triggered = True
        self.mark_ready()

    def is_pending(self) -> bool:
        return self._triggered

    def take(self) -> Callable[[], Any]:
        self._triggered = False
        return self.callback or (lambda: None)
