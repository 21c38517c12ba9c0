"""How does one wake an executor by hand?  A guard condition."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .entity import Entity, Kind

__all__ = ["GuardCondition"]


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
        return self.callback or _nothing


def _nothing() -> None:
    pass
