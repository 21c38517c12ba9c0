"""Transform a message by the functions that are registered for its type.

```
import tf2_geometry_msgs                     registers PointStamped, PoseStamped, ...
buffer.transform(point, "map")               looks up, then calls what was registered
```
"""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any, ClassVar

from ..messages import geometry_msgs, std_msgs
from ..time import Duration, Time

__all__ = [
    "BufferInterface",
    "ConvertRegistration",
    "NotImplementedException",
    "Stamped",
    "TransformRegistration",
    "TypeException",
    "convert",
]

_MODULE = "tf2_ros.buffer_interface"
NO_WAIT = Duration()


class TypeException(Exception):
    """Nobody has registered how to treat a type.  Not a TransformException, as upstream."""

    __module__ = _MODULE

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr


class NotImplementedException(Exception):
    """A buffer lacks a method."""

    __module__ = _MODULE

    def __init__(self) -> None:
        super().__init__()
        self.errstr = "CanTransform or LookupTransform not implemented"


class TransformRegistration:
    """How each type of message is moved: `function(message, transform)`.  One table for all."""

    _functions: ClassVar[dict[type, Callable]] = {}

    def print_me(self) -> None:
        """Print the table."""
        print(self._functions)

    def get(self, key: type) -> Callable:
        """Return how a type is moved.

        Raises:
            TypeException: nobody has registered it.
        """
        if key not in self._functions:
            raise TypeException(f"Type {key} is not loaded or supported")
        return self._functions[key]

    def add(self, key: type, callback: Callable) -> None:
        """Register how a type is moved."""
        self._functions[key] = callback


class ConvertRegistration:
    """How types become others: to a message, from one, or directly.  One table for all."""

    _to_msg: ClassVar[dict[type, Callable]] = {}
    _from_msg: ClassVar[dict[type, Callable]] = {}
    _convert: ClassVar[dict[tuple[type, type], Callable]] = {}

    def add_from_msg(self, key: type, callback: Callable) -> None:
        """Register how a type is made from its message."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: type, callback: Callable) -> None:
        """Register how a type becomes its message."""
        self._to_msg[key] = callback

    def add_convert(self, key: tuple[type, type], callback: Callable) -> None:
        """Register how one type becomes another directly."""
        self._convert[key] = callback

    def get_from_msg(self, key: type) -> Callable:
        """Return how a type is made from its message, or raise TypeException."""
        return _registered(self._from_msg, key)

    def get_to_msg(self, key: type) -> Callable:
        """Return how a type becomes its message, or raise TypeException."""
        return _registered(self._to_msg, key)

    def get_convert(self, key: tuple[type, type]) -> Callable:
        """Return how one type becomes another directly, or raise TypeException."""
        return _registered(self._convert, key)


def _registered(table: dict, key: Any) -> Callable:
    if key not in table:
        raise TypeException(f"Type {key} is not loaded or supported")
    return table[key]


def convert(a: Any, b_type: type) -> Any:
    """Return `a` as a `b_type`.

    Raises:
        TypeException: nobody has registered how.
    """
    registration = ConvertRegistration()
    try:
        return registration.get_convert((type(a), b_type))(a)
    except TypeException:
        if type(a) is b_type:
            return deepcopy(a)
    return registration.get_from_msg(b_type)(registration.get_to_msg(type(a))(a))


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """Give an object a header, and return it."""
    obj.header = std_msgs.Header(frame_id=frame_id, stamp=stamp)
    return obj


class BufferInterface:
    """What a buffer, or a client of one, can be asked."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self,
        object_stamped: Any,
        target_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: type | None = None,
    ) -> Any:
        """Return a stamped message as seen from `target_frame`, at its own stamp.

        Raises:
            TypeException: its package was not imported, so nobody knows how.
            TransformException: there is no transform.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        moved = do_transform(
            object_stamped, self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        )
        return moved if new_type is None else convert(moved, new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: type | None = None,
    ) -> Any:
        """Return a stamped message as seen from `target_frame` at `target_time`."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        moved = do_transform(
            object_stamped,
            self.lookup_transform_full(target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout),
        )
        return moved if new_type is None else convert(moved, new_type)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_WAIT
    ) -> geometry_msgs.TransformStamped:
        """Return what moves points from source to target."""
        raise NotImplementedException

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> geometry_msgs.TransformStamped:
        """Return source at its time as seen from target at another."""
        raise NotImplementedException

    def can_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_WAIT) -> bool:
        """Return whether lookup_transform would answer."""
        raise NotImplementedException

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether lookup_transform_full would answer."""
        raise NotImplementedException
