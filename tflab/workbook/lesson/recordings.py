"""Show what a bag holds, and how many of its messages its own transforms can place.

    fresh_folder()                a new, empty folder for what a page records
    draw_heard(recording, 3.0)    when each topic was heard, in the first three seconds
    place_messages(recording)     each topic: how many of its messages the bag's own transforms can place
    doctor(recording)             what is wrong with it, in the doctor's words
    replay(Node, bag, "--clock")  a node that listens while the bag is played, the next day

    /scan  laser_frame -> map: 149 of 150, first no: Lookup would require extrapolation into the past. ...

The last is the one number that says whether a bag was recorded well: a message whose
transform is missing here is missing for everybody who plays the bag.
"""

from __future__ import annotations

import atexit
import shutil
import tempfile
from collections.abc import Callable, Collection
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tflab.bags.recording import Headers, Recording
from tflab.core import BufferCore, TransformException, seconds
from tflab.doctor import examine
from tflab.doctor.report.text import text_from_report
from tflab.robots.nodes import launch
from tflab.ros.graph import Graph, new_graph
from tflab.ros.node import Node
from tflab.tools.page import run_words
from tflab.views.busy_chart import Work, draw_work
from tflab.views.picture import Picture

from .robots import run_node

DAY_S = 86400.0
EDGE = 40.0  # of the time that is drawn, left of the first message: its mark should be whole
QUIETLY = ("--ros-args", "--log-level", "rosbag2_player:=warn")


class PlacedTopic(NamedTuple):
    """How many messages of a topic have a transform at their own stamps.

    Attributes:
        topic, frame: of the messages.
        target: the frame in which they are to be placed.
        placed, count: how many can be, of how many.
        first_no: tf2's words for the first that cannot, "" if all can.
    """

    topic: str
    frame: str
    target: str
    placed: int
    count: int
    first_no: str

    def __str__(self) -> str:
        why = f", first no: {self.first_no}" if self.first_no else ""
        return f"{self.topic}  {self.frame} -> {self.target}: {self.placed} of {self.count}{why}"


def fresh_folder() -> Path:
    """Return a new, empty folder outside the learner's copy; it is thrown away when the kernel ends."""
    folder = Path(tempfile.mkdtemp(prefix="tflab_"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def draw_heard(recording: Recording, for_s: float = 3.0) -> Picture:
    """Draw when each topic of a recording was heard, in its first `for_s` [s], counted from its first message."""
    heard = {headers.topic: headers.receive_ns for headers in recording.headers}
    table = recording.transforms
    for topic in sorted({label.topic for label in table.labels}):
        of_topic = np.array([label.topic == topic for label in table.labels])[table.label]
        heard[topic] = np.unique(table.receive_ns[of_topic])
    if len(recording.clock.receive_ns):
        heard["/clock"] = recording.clock.receive_ns
    rows = [Work(topic, moments_ns=tuple((when - recording.begin_ns).tolist())) for topic, when in heard.items()]
    return draw_work(rows or [Work("nothing with a stamp")], -seconds(for_s / EDGE), seconds(for_s))


def place_messages(
    recording: Recording, target_frame: str | None = None, leave_out: Collection[str] = ()
) -> list[PlacedTopic]:
    """Return for each topic and frame how many messages the recording's own transforms can place.

    Args:
        target_frame: where to; the root that most frames hang from if None.  Messages without a frame are left out.
        leave_out: topics of transforms, as if they had not been recorded.
    """
    rows = []
    recording = _without(recording, leave_out)
    for namespace in recording.namespaces() or (None,):
        buffer = recording.buffer(namespace=namespace)
        target = target_frame or root_of_most(buffer)
        known = set(buffer.frame_names())
        for headers in recording.headers:
            for number, frame in enumerate(headers.frames):
                name = frame.removeprefix("/")  # ROS 1 wrote it so
                is_here = len(recording.namespaces()) < 2 or name in known
                if name and is_here:
                    rows.append(_placed(buffer, headers, name, headers.stamp_ns[headers.frame == number], target))
    return rows


def replay(
    make_node: Callable[[], Node],
    bag: str | Path,
    options: str = "",
    for_s: float = 6.0,
    beside: Collection[str] = (),
) -> Node:
    """Play a bag the next day, beside a node that listens, for `for_s` [s]; return the node, which goes on living.

    Args:
        options: as after `ros2 bag play BAG`.
        beside: nodes of the robot that are running, too, by their names in `launch`.
    """
    graph = new_graph()
    graph.run(seconds=DAY_S)
    launch(graph, only=beside)
    node = run_node(make_node, 0.0)
    run_words(graph, ["bag", "play", str(bag), *options.split(), "&"], ros_args=QUIETLY)
    graph.run(seconds=for_s)
    return node


def doctor(patient: Recording | Graph | BufferCore, seconds: float = 5.0) -> str:
    """Return what the doctor says of a recording, a graph or a buffer; a graph is listened to for `seconds` [s]."""
    return text_from_report(examine(patient, seconds))


def _without(recording: Recording, topics: Collection[str]) -> Recording:
    """Return a recording as if these topics of transforms had not been recorded."""
    table = recording.transforms
    keeps = np.array([label.topic not in topics for label in table.labels], dtype=bool)
    rows = keeps[table.label] if len(table) else np.zeros(0, dtype=bool)
    columns = {name: getattr(table, name)[rows] for name in ("receive_ns", "stamp_ns", "message", "numbers")}
    label = (np.cumsum(keeps) - 1)[table.label[rows]]  # the labels that are left count from 0 again
    labels = tuple(each for each, is_kept in zip(table.labels, keeps, strict=True) if is_kept)
    return replace(recording, transforms=replace(table, **columns, label=label, labels=labels))


def root_of_most(buffer: BufferCore) -> str:
    """Return the root that most frames hang from, "map" of an empty buffer."""
    parents = {edge.name: edge.parent for edge in buffer.snapshot().frames}
    below: dict[str, int] = {}
    for frame in parents:
        path = [frame]
        while (parent := parents.get(path[-1])) is not None and parent not in path:
            path.append(parent)
        below[path[-1]] = below.get(path[-1], 0) + 1
    return max(below, key=lambda root: (below[root], root)) if below else "map"


def _placed(buffer: BufferCore, headers: Headers, frame: str, stamps_ns: np.ndarray, target: str) -> PlacedTopic:
    placed, first_no = 0, ""
    for stamp_ns in stamps_ns.tolist():
        try:
            buffer.lookup_transform(target, frame, stamp_ns)
            placed += 1
        except TransformException as refusal:
            first_no = first_no or str(refusal)
    return PlacedTopic(headers.topic, frame, target, placed, len(stamps_ns), first_no)
