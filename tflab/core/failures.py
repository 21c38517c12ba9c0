"""Build tf2's exception for a failed lookup, with the cause in attributes.

    find_path  ->  LookupFailure("future", laser, t, t_newest)  ->  ExtrapolationException
                          "disconnected"                 ->  ConnectivityException
                          "loop"                         ->  LookupException

The texts are tf2's to the letter, so that a web search and a robot agree.  Names
in a question are judged first: see `validation.py`.

tf2: BufferCore::createExtrapolationException1..3, createConnectivityErrorString.
"""

from __future__ import annotations

from .describe import all_frames_as_string
from .errors import ConnectivityException, ExtrapolationException, LookupException, TransformException
from .stamps import format_stamp
from .tree import FrameTree, LookupFailure

__all__ = ["exception_from_failure", "extrapolation_text", "text_from_failure"]


def text_from_failure(tree: FrameTree, failure: LookupFailure, target_frame: str, source_frame: str) -> str:
    """Return tf2's words for a failure."""
    if failure.kind == "loop":
        return f"The tf tree is invalid because it contains a loop.\n{all_frames_as_string(tree)}\n"
    if failure.kind == "disconnected":
        return (
            f"Could not find a connection between '{target_frame}' and '{source_frame}' because they are "
            "not part of the same tree.Tf has two or more unconnected trees."
        )
    return extrapolation_text(failure.kind, failure.requested_ns, failure.bound_ns, target_frame, source_frame)


def extrapolation_text(direction: str, requested_ns: int, bound_ns: int, target_frame: str, source_frame: str) -> str:
    """Return tf2's words for a history that does not reach."""
    requested, bound = format_stamp(requested_ns), format_stamp(bound_ns)
    if direction == "no_data":
        fault = f"at time {requested}, but only time {bound} is in the buffer"
    else:
        end = "latest" if direction == "future" else "earliest"
        fault = f"into the {direction}.  Requested time {requested} but the {end} data is at time {bound}"
    return (
        f"Lookup would require extrapolation {fault}, "
        f"when looking up transform from frame [{source_frame}] to frame [{target_frame}]"
    )


def exception_from_failure(
    tree: FrameTree, failure: LookupFailure, target_frame: str, source_frame: str
) -> TransformException:
    """Return the exception that tf2 raises for a failure, with the cause in attributes."""
    text = text_from_failure(tree, failure, target_frame, source_frame)
    if failure.kind == "loop":
        return LookupException(text, target_frame=target_frame, source_frame=source_frame)
    if failure.kind == "disconnected":
        return ConnectivityException(
            text,
            target_frame=target_frame,
            source_frame=source_frame,
            target_root=tree.names[_root(tree, tree.numbers[target_frame])],
            source_root=tree.names[_root(tree, tree.numbers[source_frame])],
        )
    parent = _newest_parent(tree, failure.frame)
    return ExtrapolationException(
        text,
        target_frame=target_frame,
        source_frame=source_frame,
        direction=failure.kind,
        frame=tree.names[failure.frame],
        parent=tree.names[parent] if parent else "",
        requested_ns=failure.requested_ns,
        bound_ns=failure.bound_ns,
    )


def _root(tree: FrameTree, frame: int) -> int:
    """Return where today's parents lead from a frame."""
    seen: set[int] = set()
    while frame not in seen and (parent := _newest_parent(tree, frame)):
        seen.add(frame)
        frame = parent
    return frame


def _newest_parent(tree: FrameTree, frame: int) -> int:
    cache = tree.caches[frame]
    return cache.newest_parent if cache is not None else 0
