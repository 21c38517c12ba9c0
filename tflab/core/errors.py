"""Define tf2's exceptions.

    TransformException
    |-- LookupException           a frame name was never published
    |-- ConnectivityException     both frames are known, but no path connects them
    |-- ExtrapolationException    there is a path, but no data at that time
    |-- InvalidArgumentException  a frame name is malformed
    `-- TimeoutException          another node did not answer in time

The texts are tf2's to the letter, so that a web search finds them and a robot prints
the same. Additional information is in attributes and in `hint`.

C++ has three kinds of extrapolation; Python has one class, here with a `direction`.
(tf2/exceptions.hpp)
"""

from __future__ import annotations

from typing import Any

from .stamps import format_stamp

__all__ = [
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "TimeoutException",
    "TransformException",
]


class TransformException(Exception):
    """Any failure of tf2, and nothing else.

    Attributes:
        target_frame, source_frame: what was asked for, "" where that does not apply.
        hint: one sentence: what to look at first.
    """

    # On a robot a traceback says `tf2.LookupException`; here it says so too.
    __module__ = "tf2"

    def __init__(self, text: str = "", *, target_frame: str = "", source_frame: str = "") -> None:
        super().__init__(text)
        self.target_frame = target_frame
        self.source_frame = source_frame

    @property
    def hint(self) -> str:
        return ""

    def __reduce__(self) -> tuple[Any, ...]:
        # No module is called `tf2`, so pickle needs the module of the class.
        return (_rebuild, (type(self).__name__, self.args, self.__dict__))


class LookupException(TransformException):
    """The buffer does not know a frame, or the tree has a loop.

    Attributes:
        frame: the unknown name, "" for a loop.
        known_frames: every name the buffer has heard so far.
    """

    __module__ = "tf2"

    def __init__(
        self,
        text: str = "",
        *,
        target_frame: str = "",
        source_frame: str = "",
        frame: str = "",
        known_frames: tuple[str, ...] = (),
    ) -> None:
        super().__init__(text, target_frame=target_frame, source_frame=source_frame)
        self.frame = frame
        self.known_frames = known_frames

    @property
    def hint(self) -> str:
        if not self.frame:
            return "Follow the parents in the list: they come back to where they started. One of them is wrong."
        if not self.known_frames:
            return "The buffer has not heard of any frame yet: is anything published, and has it had time to arrive?"
        from difflib import get_close_matches

        close = get_close_matches(self.frame, self.known_frames, n=1)
        if close:
            return f'Is the name spelt right? There is a frame "{close[0]}".'
        return f'Who publishes "{self.frame}", and is that node running? Known frames: {_listed(self.known_frames)}.'


class ConnectivityException(TransformException):
    """Both frames are known, but they are in different trees.

    Attributes:
        target_root, source_root: where the climb from each of them ended.
    """

    __module__ = "tf2"

    def __init__(
        self,
        text: str = "",
        *,
        target_frame: str = "",
        source_frame: str = "",
        target_root: str = "",
        source_root: str = "",
    ) -> None:
        super().__init__(text, target_frame=target_frame, source_frame=source_frame)
        self.target_root = target_root
        self.source_root = source_root

    @property
    def hint(self) -> str:
        if not self.target_root:
            return ""
        return (
            f'From "{self.target_frame}" the parents lead to "{self.target_root}", from "{self.source_frame}" to '
            f'"{self.source_root}". Which transform should join those two, and who should publish it?'
        )


class ExtrapolationException(TransformException):
    """There is a path, but one of its frames has no data for that moment, and tf2 never guesses.

    Attributes:
        direction: "past" (older than all its data), "future" (newer than all its data)
            or "no_data" (a single sample, at another moment, or none).
        frame: the child frame whose history does not reach.
        parent: its parent.
        requested_ns: the moment asked for [ns].
        bound_ns: the nearest moment its history holds [ns], 0 if it is empty.
    """

    __module__ = "tf2"

    def __init__(
        self,
        text: str = "",
        *,
        target_frame: str = "",
        source_frame: str = "",
        direction: str = "",
        frame: str = "",
        parent: str = "",
        requested_ns: int = 0,
        bound_ns: int = 0,
    ) -> None:
        super().__init__(text, target_frame=target_frame, source_frame=source_frame)
        self.direction = direction
        self.frame = frame
        self.parent = parent
        self.requested_ns = requested_ns
        self.bound_ns = bound_ns

    @property
    def hint(self) -> str:
        edge = f"{self.parent} -> {self.frame}" if self.parent else self.frame
        distance = f"{abs(self.requested_ns - self.bound_ns) / 1e6:.1f} ms"
        if self.direction == "future":
            return (
                f"The newest {edge} is {distance} older than the moment asked for. If it is merely on its way, a short "
                "wait helps; if two clocks disagree, no wait will."
            )
        if self.direction == "past":
            return (
                f"The oldest {edge} is {distance} newer than the moment asked for. Was the data processed too late, is "
                "the buffer too short, or does the stamp come from another clock?"
            )
        if self.direction == "no_data" and self.bound_ns:
            return f"There is one {edge}, at {format_stamp(self.bound_ns)}. Between two samples tf2 can answer."
        if self.direction == "no_data":
            return f"There is no {edge} in the buffer at all."
        return ""


class InvalidArgumentException(TransformException):
    """The question is malformed: a frame name that is empty or begins with a slash."""

    __module__ = "tf2"

    @property
    def hint(self) -> str:
        return "Frame names in ROS 2 are bare words: write 'map', not '/map', and fill in header.frame_id."


class TimeoutException(TransformException):
    """An answer from another process did not come in time."""

    __module__ = "tf2"


def _listed(names: tuple[str, ...], most: int = 12) -> str:
    shown = ", ".join(names[:most])
    return shown if len(names) <= most else f"{shown} and {len(names) - most} more"


def _rebuild(name: str, args: tuple[Any, ...], facts: dict[str, Any]) -> TransformException:
    exception: TransformException = globals()[name](*args)
    exception.__dict__.update(facts)
    return exception
