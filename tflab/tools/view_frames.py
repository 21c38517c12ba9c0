"""Run `view_frames`: listen for five seconds, then draw the tree.

    /tf, /tf_static --5 s--> Buffer --service tf2_frames--> frames_<date>_<time>.gv
                                                            frames_<date>_<time>.pdf

The .gv is upstream's to the letter, and the .pdf shows what it says: `tflab.views`
draws it, so that no `dot` program is needed, and a page shows the same drawing.  A
frame stands under its newest parent only, and the broadcaster is `default_authority`
for everybody.  So it is upstream.  `frame_tree()` in `trees.py` draws our own picture
of a graph, with every parent and the real publishers.

upstream: tf2_tools/tf2_tools/view_frames.py.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

import yaml

from tflab.core import NSEC_PER_SEC
from tflab.ros import distro
from tflab.ros.node import Node
from tflab.views.tree import TreePicture
from tflab.views.view_frames_tree import draw_upstream_tree

from .session import display_time_zone, spin_for, spin_until_done, tool_node

__all__ = ["dot_from_frames", "main", "parser", "write_pictures"]


def parser() -> argparse.ArgumentParser:
    """Return the tool's options, with upstream's help texts."""
    options = argparse.ArgumentParser(
        prog="view_frames", description="Create a diagram of the TF frames being broadcast over ROS"
    )
    options.add_argument(
        "--wait-time", "-t", type=float, default=5.0,
        help="Listen to the /tf topic for this many seconds before rendering the frame tree",
    )  # fmt: skip
    options.add_argument("-o", "--output", help="Output filename")
    if distro.current().listener_takes_topics:
        options.add_argument("--tf_topic", help="Topic for dynamic transforms", default="/tf")
        options.add_argument("--tf_static_topic", help="Topic for static transforms", default="/tf_static")
    return options


def dot_from_frames(frames: Mapping[Any, Mapping[str, Any]], recorded_s: float) -> str:
    """Return upstream's Graphviz text of what the service `tf2_frames` answered."""
    if not frames:
        return 'digraph G { "No tf data received" }'
    lines, root = ["digraph G {"], ""
    for name, frame in frames.items():
        lines.append(
            f'"{frame["parent"]}" -> "{name}"[label=" '
            f"Broadcaster: {frame['broadcaster']}\\n"
            f"Average rate: {frame['rate']}\\n"
            f"Buffer length: {frame['buffer_length']}\\n"
            f"Most recent transform: {frame['most_recent_transform']}\\n"
            f'Oldest transform: {frame["oldest_transform"]}\\n"];'
        )
        if frame["parent"] not in frames:
            root = frame["parent"]
    lines.append("edge [style=invis];")
    lines.append(' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";')
    lines.append(f'"Recorded at time: {recorded_s}"[ shape=plaintext ] ;')
    lines.append(f'}}->"{root}";\n}}')
    return "\n".join(lines)


def write_pictures(stem: str, dot: str, picture: TreePicture) -> None:
    """Write `stem`.gv and `stem`.pdf."""
    Path(f"{stem}.gv").write_text(dot, encoding="utf-8")
    Path(f"{stem}.pdf").write_bytes(picture.pdf())


def main(arguments: Sequence[str], pictures: list[Any]) -> int:
    """Listen, write the files, and append the drawing to `pictures`; return the exit code."""
    options = parser().parse_args(arguments)
    with tool_node("view_frames") as node:
        return _view(node, options, pictures)


def _view(node: Node, options: argparse.Namespace, pictures: list[Any]) -> int:
    from tflab.ros.messages.tf2_msgs import FrameGraph
    from tflab.ros.tf2.buffer import Buffer
    from tflab.ros.tf2.topics import TransformListener

    log = node.get_logger()
    buffer = Buffer(node=node)
    topics = {name: topic for name, topic in vars(options).items() if name in ("tf_topic", "tf_static_topic")}
    listener = TransformListener(buffer, node, **topics)
    log.info(f"Listening to tf data for {options.wait_time} seconds...")
    spin_for(node, options.wait_time)
    log.info("Generating graph...")

    client = node.create_client(FrameGraph, "tf2_frames")
    while not client.wait_for_service(timeout_sec=1.0):
        log.info("service not available, waiting again...")
    future = client.call_async(FrameGraph.Request())
    spin_until_done(node, future)
    answer = future.result()
    log.info(f"Result:{answer}")

    now = node.get_clock().now()
    stem = options.output or _dated_name(node.context.process.driver.now_ns())
    log.info(f"Exporting graph in {stem}.pdf file...")
    sec, nanosec = now.seconds_nanoseconds()
    frames, recorded_s = yaml.safe_load(answer.frame_yaml) or {}, sec + nanosec / NSEC_PER_SEC
    picture = draw_upstream_tree(_with_names_as_text(frames), recorded_s)
    try:
        write_pictures(stem, dot_from_frames(frames, recorded_s), picture)
    except OSError as fault:
        print(f"{fault.filename}: cannot be written ({fault.strerror})", file=sys.stderr)
        return 1
    pictures.append(picture)
    listener.unregister()
    return 0


def _with_names_as_text(frames: Mapping[Any, Mapping[str, Any]]) -> dict[str, Mapping[str, Any]]:
    """Return frames with names as Graphviz has them; YAML takes some for numbers."""
    return {str(name): {**frame, "parent": str(frame["parent"])} for name, frame in frames.items()}


def _dated_name(now_ns: int) -> str:
    """Return the name with date and time."""
    return datetime.fromtimestamp(now_ns / NSEC_PER_SEC, display_time_zone()).strftime("frames_%Y-%m-%d_%H.%M.%S")
