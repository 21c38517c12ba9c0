"""What does this buffer look like?  The views that draw one, wired to a buffer of ours or of tf2_ros.

    buffer --+-- draw_buffer(buffer)                               the tree
             +-- draw_walk(buffer, "map", "laser_frame")           the way through it, up and down
             +-- draw_history(buffer, "map", "laser_frame", t)     a lane for each edge between, and the query
             `-- draw_question(buffer, "map", "laser_frame", t)    the sentence, among all frames

A view takes values; here they are taken out of the buffer.  tf2_ros.Buffer has the
engine as `.core`, so both kinds will do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tflab.core import LATEST, BufferCore, Snapshot, Transform, TransformException
from tflab.ros.tf2.core import BufferCore as RosBuffer
from tflab.views import tree_path
from tflab.views.tree import TreePicture, draw_tree

if TYPE_CHECKING:
    from tflab.views.picture import Picture
    from tflab.views.sentence import SentencePicture
    from tflab.views.timeline import TimelinePicture

__all__ = ["draw_buffer", "draw_history", "draw_question", "draw_walk", "edges_between"]


def draw_buffer(buffer: BufferCore | RosBuffer, now_ns: int | None = None) -> TreePicture:
    """Draw the tree of a buffer; ages are reckoned from `now_ns` [ns]."""
    return draw_tree(_core(buffer).snapshot(), now_ns)


def draw_walk(buffer: BufferCore | RosBuffer, target_frame: str, source_frame: str) -> Picture:
    """Draw the tree of a buffer, and in it the way from `source_frame` up and down to `target_frame`.

    Raises:
        ValueError: there is no such frame.
    """
    return tree_path.draw_walk(_core(buffer).snapshot(), target_frame, source_frame)


def draw_history(
    buffer: BufferCore | RosBuffer, target_frame: str, source_frame: str, stamp_ns: int = LATEST
) -> TimelinePicture:
    """Draw what a buffer knew of the edges between two frames, and what it answers at `stamp_ns` [ns].

    Raises:
        LookupException: a frame was never named.
    """
    from tflab.views.timeline import draw_timeline, lane_from_history

    core = _core(buffer)
    for frame in (target_frame, source_frame):
        core.history(frame)
    children = edges_between(core.snapshot(), target_frame, source_frame)
    lanes = [lane_from_history(core.history(child)) for child in children]
    return draw_timeline(target_frame, source_frame, lanes, core.lookup_transform, stamp_ns)


def draw_question(
    buffer: BufferCore | RosBuffer,
    target_frame: str,
    source_frame: str,
    stamp_ns: int = LATEST,
    fixed_frame: str | None = None,
) -> SentencePicture:
    """Draw a question and its answer among all frames that have a place in `fixed_frame`, the root if None.

    Raises:
        TransformException: there is no answer.
    """
    from tflab.views.sentence import draw_sentence

    core = _core(buffer)
    stamped = core.lookup_transform(target_frame, source_frame, stamp_ns)
    fixed_frame = fixed_frame or _way_up(core.snapshot(), source_frame)[-1]
    poses = {frame: pose for frame in core.frame_names() if (pose := _pose(core, fixed_frame, frame, stamp_ns))}
    return draw_sentence(poses, stamped, stamp_ns)


def edges_between(tree: Snapshot, target_frame: str, source_frame: str) -> list[str]:
    """Return the child of each edge between two frames, from the target's side on.

    Frames of separate trees have no edge between; then it is every edge above either.
    """
    up_from_target, up_from_source = _way_up(tree, target_frame), _way_up(tree, source_frame)
    met = next((frame for frame in up_from_target if frame in up_from_source), None)
    target_side = _below(up_from_target, met or up_from_target[-1])
    source_side = _below(up_from_source, met or up_from_source[-1])
    return [*target_side, *reversed(source_side)]


def _below(way_up: list[str], top: str) -> list[str]:
    return way_up[: way_up.index(top)]


def _way_up(tree: Snapshot, frame: str) -> list[str]:
    """Return the frames from one up to its root; in a loop, each once."""
    parents = {edge.name: edge.parent for edge in tree.frames}
    way = [frame]
    while parents.get(way[-1]) is not None and parents[way[-1]] not in way:
        way.append(parents[way[-1]])
    return way


def _pose(core: BufferCore, fixed_frame: str, frame: str, stamp_ns: int) -> Transform | None:
    try:
        return core.lookup_transform(fixed_frame, frame, stamp_ns).transform
    except TransformException:
        return None


def _core(buffer: BufferCore | RosBuffer) -> BufferCore:
    return buffer.core if isinstance(buffer, RosBuffer) else buffer
