"""Exchange JSON frames between grader and kernel over one pair of connected sockets.

    +----------------+----------------------------------------+
    | length, 4 byte | {"msg_type": "execute_reply", ... }    |
    +----------------+----------------------------------------+

No ports, no files, no keys: whoever holds an end may speak, and nobody else can.  The other end
belongs to code that may be hostile, so a frame that is too long, that is not JSON, or that is not
an object ends the conversation with `WireFault`; and nothing here waits longer than it is told to.
"""

from __future__ import annotations

import json
import select
import socket
import struct
import time
from typing import Any

from ..submissions import bounded_json

__all__ = ["Wire", "WireClosed", "WireFault"]

HEAD = struct.Struct("!I")
CHUNK = 1 << 16


class WireFault(Exception):
    """What the other end sent is not a message."""


class WireClosed(Exception):
    """The other end is gone."""


class Wire:
    """One end of a conversation."""

    def __init__(self, end: socket.socket, longest: int) -> None:
        end.setblocking(False)
        self.end = end
        self.longest = longest  # of one frame [bytes]
        self.taken = 0  # bytes, so far
        self._got = bytearray()

    def fileno(self) -> int:
        return self.end.fileno()

    def send(self, message: dict[str, Any], deadline: float | None = None) -> None:
        """Send one message; raise TimeoutError if the other end does not take it before `deadline` (monotonic)."""
        self.send_bytes(json.dumps(message).encode(), deadline)

    def send_bytes(self, body: bytes, deadline: float | None = None) -> None:
        """Send one message that is JSON already."""
        rest = memoryview(HEAD.pack(len(body)) + body)
        while rest:
            try:
                rest = rest[self.end.send(rest) :]
            except BlockingIOError:
                left = None if deadline is None else deadline - time.monotonic()
                if left is not None and left <= 0:
                    raise TimeoutError("the other end does not listen") from None
                select.select([], [self.end], [], left)
            except OSError as gone:
                raise WireClosed(str(gone)) from None

    def receive(self, timeout: float | None) -> dict[str, Any] | None:
        """Return the next message, or None if there is none within `timeout` seconds."""
        end = None if timeout is None else time.monotonic() + timeout
        while (message := self._frame()) is None:
            left = None if end is None else max(0.0, end - time.monotonic())
            ready, _, _ = select.select([self.end], [], [], left)
            if not ready:
                return None
            self.read_some()
        return message

    def read_some(self) -> int:
        """Take what has arrived; return how many bytes that were."""
        try:
            got = self.end.recv(CHUNK)
        except BlockingIOError:
            return 0
        except OSError as gone:
            raise WireClosed(str(gone)) from None
        if not got:
            raise WireClosed("the other end hung up")
        self._got += got
        self.taken += len(got)
        return len(got)

    def _frame(self) -> dict[str, Any] | None:
        if len(self._got) < HEAD.size:
            return None
        (length,) = HEAD.unpack_from(self._got)
        if length > self.longest:
            raise WireFault(f"a message of {length} bytes; at most {self.longest} are read")
        if len(self._got) < HEAD.size + length:
            return None
        body = bytes(self._got[HEAD.size : HEAD.size + length])
        del self._got[: HEAD.size + length]
        try:
            message = bounded_json.read(body)
        except ValueError as fault:  # UnicodeDecodeError is one, too
            raise WireFault(f"a message that is not JSON ({type(fault).__name__})") from None
        if not isinstance(message, dict):
            raise WireFault("a message that is not an object")
        return message

    def close(self) -> None:
        self.end.close()
