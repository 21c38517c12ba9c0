"""Define Evidence, the input of every check: the transforms of one namespace by child frame, headers and clocks.

    Recording  --.
    BufferCore --+-->  Evidence:  edges      one child each, in the order of arrival
                                  headers    what other messages say about time and frames
                                  clock      what to expect of "received minus stamp"

Results that are needed more than once are cached. A clock that was set shows in an edge as a jump:

    received minus stamp
          |          ________        the clock was set back: a new level
          |__________|
          |     |                    a message that was late, or overtaken: the old level again
          |_____|____________
"""

from __future__ import annotations

import mmap
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tflab.bags.recording import Connection, Headers, JointStates
from tflab.core import NSEC_PER_SEC
from tflab.robots.urdf import UrdfError, parse_urdf

__all__ = ["SAME_CLOCK_NS", "YEAR_NS", "ClockRelation", "Edge", "Evidence", "Jump", "LookupRow", "OtherSamples",
           "find_jumps", "is_stamped", "part_of"]  # fmt: skip

LEAST_JUMP_S = 0.05
LEAST_PERIODS = 3.0  # less can be a message or two that took another way
LEAST_HABITS = 8.0
FEWEST_SAMPLES = 4  # on either side
OVERTAKING = 4  # samples: who is ahead of the old maximum again so soon, was overtaken
UNSTEADY = 0.5  # of the jump: a level that varies so much is none, but a queue that empties
LEVEL_SAMPLES = 8  # that tell where a level is, before and after a jump


class Jump(NamedTuple):
    """Before sample `index` the clock was set by `size_s` (negative: back)."""

    index: int
    size_s: float


def find_jumps(stamp_ns: np.ndarray, receive_ns: np.ndarray, period_ns: int) -> list[Jump]:
    """Return where a clock was set; both shape (n,), in the order of arrival [ns].

    Only what shows in the stamps themselves counts: they go back, or leap ahead
    further than the time that passed.
    """
    if len(stamp_ns) < 4:
        return []
    offset_s = (receive_ns - stamp_ns) / NSEC_PER_SEC
    change_s = np.diff(offset_s)
    habit_s = 1.4826 * float(np.median(np.abs(change_s - np.median(change_s))))
    least_s = max(LEAST_JUMP_S, LEAST_HABITS * habit_s, LEAST_PERIODS * period_ns / NSEC_PER_SEC)
    stamp_step_s = np.diff(stamp_ns) / NSEC_PER_SEC
    receive_step_s = np.diff(receive_ns) / NSEC_PER_SEC
    is_back = (stamp_step_s < 0.0) & (change_s > least_s)
    is_forward = (change_s < -least_s) & (stamp_step_s > receive_step_s + least_s)
    jumps = []
    for before in np.flatnonzero(is_back | is_forward).tolist():
        after = before + 1
        if min(after, len(stamp_ns) - after) < FEWEST_SAMPLES:
            continue
        earlier_s = offset_s[max(0, after - LEVEL_SAMPLES) : after]
        later_s = offset_s[after : after + LEVEL_SAMPLES]
        shift_s = float(np.median(later_s) - np.median(earlier_s))
        is_overtaken = is_back[before] and stamp_ns[after : after + OVERTAKING].max() > stamp_ns[before]
        is_unsteady = max(np.ptp(earlier_s), np.ptp(later_s)) > UNSTEADY * abs(change_s[before])
        if is_overtaken or is_unsteady:
            continue
        if abs(shift_s) > 0.7 * abs(change_s[before]) and shift_s * change_s[before] > 0.0:
            jumps.append(Jump(after, -shift_s))
    return jumps


LEAST_TICK_S = 1e-4  # of /clock: less is the same time again
ROWS_AT_ONCE = 100_000  # of a recording on disk
MANY = 5_000  # samples tell enough
LARGEST = 1e150  # whose square is a number still
SAME_CLOCK_NS = 3600 * NSEC_PER_SEC  # two clocks of one robot differ by less than this, sim time and 1970 by more
YEAR_NS = 365 * 86_400 * NSEC_PER_SEC  # stamps below are no date


@dataclass(eq=False)
class Edge:
    """One child, as it came on /tf or on /tf_static, in the order of arrival.

    Attributes:
        child: without a leading slash.
        parents, publishers: the different ones, in the order of first mention.
        parent, publisher: shape (n,), indices into these.
        receive_ns, stamp_ns, message: shape (n,).
        source, rows: numbers of the whole recording, shape (N, 7), and which of them are this edge's, shape (n,).
    """

    child: str
    is_static: bool
    topic: str
    parents: tuple[str, ...]
    publishers: tuple[str, ...]
    parent: np.ndarray
    publisher: np.ndarray
    receive_ns: np.ndarray
    stamp_ns: np.ndarray
    message: np.ndarray
    source: np.ndarray
    rows: np.ndarray

    def __len__(self) -> int:
        return len(self.stamp_ns)

    @property
    def numbers(self) -> np.ndarray:
        """The numbers of each sample, as sent: shape (n, 7); of a long recording they are read again each time."""
        if not isinstance(self.source, np.memmap):
            return self.source[self.rows]
        numbers = np.empty((len(self.rows), 7))
        for first in range(0, len(self.rows), ROWS_AT_ONCE):
            here = slice(first, first + ROWS_AT_ONCE)
            numbers[here] = self.source[self.rows[here]]
            if hasattr(mmap, "MADV_DONTNEED"):
                self.source.base.madvise(mmap.MADV_DONTNEED)  # the pages stay in the system's cache, and leave ours
        return numbers

    @property
    def usual_parent(self) -> str:
        """The parent of most samples."""
        return self.parents[int(np.bincount(self.parent).argmax())]

    @cached_property
    def is_finite(self) -> np.ndarray:
        """Which samples hold only finite numbers, of a size that can be squared: shape (n,)."""
        return (np.abs(self.numbers) < LARGEST).all(axis=1)

    @cached_property
    def norm(self) -> np.ndarray:
        """The length of each rotation: shape (n,)."""
        rotations = self.numbers[:, 3:]
        rotations = rotations if self.is_finite.all() else np.where(self.is_finite[:, None], rotations, 0.0)
        return np.sqrt(np.einsum("ij,ij->i", rotations, rotations))

    @cached_property
    def is_usable(self) -> np.ndarray:
        """Which samples are poses: shape (n,)."""
        return self.is_finite & (self.norm > 0.0)

    @cached_property
    def period_ns(self) -> int:
        """The usual time between two samples [ns], 0 if there are none."""
        steps = np.diff(np.unique(self.stamp_ns))
        return int(np.median(steps)) if len(steps) else 0

    @cached_property
    def jumps(self) -> list[Jump]:
        """Where the clock behind the stamps was set; none if there are no times of receipt."""
        return find_jumps(self.stamp_ns, self.receive_ns, self.period_ns)

    def stretches(self) -> list[slice]:
        """Return the samples between the jumps of the clock."""
        bounds = [0, *(jump.index for jump in self.jumps), len(self)]
        return [slice(a, b) for a, b in pairwise(bounds) if b > a]


class OtherSamples(NamedTuple):
    """The samples of an edge or a topic that are in another time base than most.

    Attributes:
        source: the edge or topic, with these samples alone.
        total: how many samples it has with the others.
    """

    source: Edge | Headers
    total: int


class LookupRow(NamedTuple):
    """How many messages of one topic and frame can be looked up in a fixed frame at their stamps.

    Attributes:
        shares: at once, and after 0.1 s, 0.5 s and 1 s, from 0 to 1.
        parent, child: the edge that is waited for, "" if none is, or if the frames are not connected.
        wait_ns: nine of ten messages wait at least so long [ns].
        period_ns: usual time between two messages [ns], 0 if there is only one.
    """

    topic: str
    frame: str
    fixed: str
    count: int
    shares: tuple[float, ...]
    parent: str
    child: str
    wait_ns: int
    period_ns: int


@dataclass(frozen=True)
class ClockRelation:
    """What "received minus stamp" is on the whole: (time of receipt, difference) pairs to interpolate between.

    Attributes:
        source: "same" (one clock), "/clock" (recorded) or "estimated".
    """

    source: str
    receive_ns: np.ndarray
    difference_s: np.ndarray

    @property
    def resolution_s(self) -> float:
        """The least delay that shows: one and a half steps of the time on /clock [s], 0 if it was not recorded."""
        steps_s = np.diff(self.receive_ns) / NSEC_PER_SEC - np.diff(self.difference_s)
        steps_s = steps_s[steps_s > LEAST_TICK_S]
        return 1.5 * float(np.median(steps_s)) if self.source == "/clock" and len(steps_s) else 0.0

    def difference_at(self, receive_ns: np.ndarray) -> np.ndarray:
        """Return the difference of the two clocks at moments of receipt [s]."""
        if not len(self.receive_ns):
            return np.zeros(len(receive_ns))
        begin_ns = self.receive_ns[0]  # a float cannot tell nanoseconds apart that are counted from 1970
        return np.interp(
            (receive_ns - begin_ns).astype(float), (self.receive_ns - begin_ns).astype(float), self.difference_s
        )


@dataclass(eq=False)
class Evidence:
    """Everything that the checks look at.

    Attributes:
        moving, statics: what came on /tf and on /tf_static, in the order of first mention.
        has_arrival: whether times of receipt and the order of arrival are known.
        raw_names: every (parent, child, topic), as sent, in the order of first mention.
        in_other_time: samples in another time base, which are not among those of `moving` and `headers`.
        lookups: see lookups.py; empty until they are calculated.
    """

    subject: str
    namespace: str
    moving: list[Edge]
    statics: list[Edge]
    raw_names: list[tuple[str, str, str]]
    has_arrival: bool
    begin_ns: int = 0
    end_ns: int = 0
    headers: tuple[Headers, ...] = ()
    in_other_time: tuple[OtherSamples, ...] = ()
    joint_states: tuple[JointStates, ...] = ()
    connections: tuple[Connection, ...] = ()
    robot_description: str = ""
    clock: ClockRelation = field(default_factory=lambda: ClockRelation("same", np.zeros(0), np.zeros(0)))
    lookups: tuple[LookupRow, ...] = ()

    def edges(self) -> Iterator[Edge]:
        """Yield every edge, the moving ones first."""
        yield from self.moving
        yield from self.statics

    @cached_property
    def parent_of(self) -> dict[str, str]:
        """The usual parent of each child; a static one counts if there are both."""
        return {edge.child: edge.usual_parent for edge in self.edges() if edge.usual_parent}

    @cached_property
    def frames(self) -> set[str]:
        """Every frame of the tree."""
        return {frame for pair in self.parent_of.items() for frame in pair}

    def roots(self) -> list[str]:
        """Return the frames that are nobody's child, sorted."""
        return sorted(self.frames - set(self.parent_of))

    @cached_property
    def trees(self) -> dict[str, list[str]]:
        """The frames under each root, sorted; frames that go round in a circle are under none."""
        below: dict[str, list[str]] = {}
        for child, parent in self.parent_of.items():
            below.setdefault(parent, []).append(child)
        trees = {}
        for root in self.roots():
            members, rest = [], [root]
            while rest:
                members.append(rest.pop())
                rest += below.get(members[-1], ())
            trees[root] = sorted(members)
        return trees

    @cached_property
    def _root_of(self) -> dict[str, str]:
        return {frame: root for root, members in self.trees.items() for frame in members}

    def is_below(self, frame: str, ancestor: str) -> bool:
        """Return whether the climb from a frame comes past another, or begins there."""
        seen = set()
        while frame not in seen | {ancestor} and frame in self.parent_of:
            seen.add(frame)
            frame = self.parent_of[frame]
        return frame == ancestor

    def root_of(self, frame: str) -> str:
        """Return where the climb from a frame ends; in a loop, and of a stranger, the frame itself."""
        return self._root_of.get(frame, frame)

    @cached_property
    def all_parents(self) -> set[str]:
        """Every parent that any sample named, also those that are not the usual ones."""
        return {parent for edge in self.edges() for parent in edge.parents if parent}

    @cached_property
    def named_by_messages(self) -> set[str]:
        """Every frame that a header named, without slashes."""
        return {frame.removeprefix("/") for header in self.headers for frame in header.frames if frame}

    @cached_property
    def joint_kinds(self) -> dict[str, str]:
        """The kind of joint above each link of the robot's description; empty if none was recorded."""
        try:
            joints = parse_urdf(self.robot_description).joints if self.robot_description else ()
        except UrdfError:
            return {}
        return {joint.child: joint.type for joint in joints}

    @cached_property
    def stamped_by_joint_states(self) -> set[str]:
        """The moving children with the stamps of /joint_states: robot_state_publisher hands these on."""
        return {
            edge.child
            for edge in self.moving
            for joints in self.joint_states
            if np.isin(edge.stamp_ns[:MANY], joints.stamp_ns).mean() > 0.5
        }

    def is_detection(self, edge: Edge) -> bool:
        """Return whether an edge ends below a camera, in a frame of no message and no joint: it is seen at times."""
        images = {frame for header in self.headers if "Image" in header.msgtype for frame in header.frames}
        if edge.usual_parent not in images and "optical" not in edge.usual_parent:
            return False
        needed = self.all_parents | self.named_by_messages | self.stamped_by_joint_states | set(self.joint_kinds)
        return edge.child not in needed

    def publishers_of(self, topic: str) -> int:
        """Return how many publishers a topic had, as far as the recording tells."""
        return sum(max(1, len(connection.qos)) for connection in self.connections if connection.topic == topic)

    def delay_s(self, edge: Edge | Headers) -> np.ndarray:
        """Return how late each message was received, the clocks' difference taken off [s]."""
        offset_s = (edge.receive_ns - edge.stamp_ns) / NSEC_PER_SEC
        return offset_s - self.clock.difference_at(edge.receive_ns)


def is_stamped(source: Edge | Headers) -> bool:
    """Return whether the stamps of a source were set; a single zero may be the first moment of a simulated clock."""
    return len(source.stamp_ns) > 0 and np.count_nonzero(source.stamp_ns == 0) <= min(1, len(source.stamp_ns) - 1)


def part_of(source: Edge | Headers, which: np.ndarray | slice) -> Edge | Headers:
    """Return the samples of a source that are marked, shape (n,), or in a slice."""
    if isinstance(source, Headers):
        return source._replace(**{name: getattr(source, name)[which] for name in ("receive_ns", "stamp_ns", "frame")})
    columns = ("parent", "publisher", "receive_ns", "stamp_ns", "message", "rows")
    return replace(source, **{name: getattr(source, name)[which] for name in columns})
