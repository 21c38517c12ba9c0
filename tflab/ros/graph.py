"""Hold the processes, nodes and topics of one ROS graph.

    graph = Graph()                    virtual time, stands at 1 s
    graph.start(main)                  a participant: a main function, as one would run it in a terminal
    graph.run(seconds=3)               time passes, the participants work
    graph.disturb("/tf", delay=0.1)    trouble, staged
    graph.set_clock_offset("lidar", 0.5)
    graph.stop()                       Ctrl-C for all of them

Between two calls time stands still.  A participant's exception is reported with
its name and does not hurt the others; one that keeps busy without ever sleeping
or spinning is stopped and named.
"""

from __future__ import annotations

import gc
import math
import random
import sys
import threading
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tflab.core import NSEC_PER_SEC

from .network import Disturbance, Network
from .process import Process, patch_threads, process_here, use_graph, write_line
from .virtual import EndlessLoop, VirtualTime
from .wall import WallTime

__all__ = ["Graph", "Participant", "current_graph", "current_process", "new_graph"]

# After Ctrl-C a participant may still tidy up, sleeping if need be, for this long.
GRACE_NS = 10_000_000_000


class Participant(Process):
    """A process that runs a main function.

    Attributes:
        exception: what ended it, None if it still runs or returned.
        is_running: whether its main function has not returned yet.
    """

    def __init__(self, name: str, graph: Graph, main: Callable[..., Any], args: tuple, argv: list[str]) -> None:
        super().__init__(name, graph, argv)
        self.exception: BaseException | None = None
        self.is_running = True
        self._main = main
        self._args = args
        self.main_thread = threading.Thread(target=self._run, name=name, daemon=True)
        self.main_thread.tflab_process = self

    def stop(self) -> None:
        """Interrupt it, as Ctrl-C does, and wait until it has ended."""
        self.graph.stop(self)

    def run_here(self) -> None:
        """Run it to its end in this thread, instead of in one of its own."""
        self.main_thread = threading.current_thread()
        self.main_thread.tflab_process = self
        try:
            self._run()
        finally:
            del self.main_thread.tflab_process

    def _run(self) -> None:
        try:
            self._main(*self._args)
        except EndlessLoop as error:
            self._report(error, self.loop_text())
        except KeyboardInterrupt as error:
            self.exception = error  # asked for, so not worth a report
        except SystemExit as error:
            self.exception = error if error.code else None
            if isinstance(error.code, str):
                write_line(error.code)
        except BaseException as error:
            self._report(error, "".join(traceback.format_exception(_without_our_frames(error))).rstrip())
        finally:
            self.is_running = False
            self.end()

    def lost(self, where: str) -> None:
        """Give it up: it keeps busy, and cannot even be interrupted."""
        super().lost(where)
        self.is_running = False

    def _report(self, error: BaseException, text: str) -> None:
        self.exception = error
        write_line(f'participant "{self.name}" ended with an exception:\n{text}')

    def __repr__(self) -> str:
        state = "running" if self.is_running else "ended"
        return f"<Participant {self.name!r}, {state}>"


class Graph:
    """Processes that see each other's topics, on one clock.

    Args:
        virtual: whether time only passes in run(); otherwise it is the machine's.

    Attributes:
        driver: the clock.
        network: topics, services and nodes.
        main: the process of whoever made the graph: the notebook, the script.
        participants: everybody who was started, in order, the ended ones included.
    """

    def __init__(self, virtual: bool = True) -> None:
        self.driver = VirtualTime() if virtual else WallTime()
        self.network = Network()
        self.main = Process("main", self)
        self.participants: list[Participant] = []
        self._offsets_ns: dict[str, int] = {}
        patch_threads()

    @property
    def now_ns(self) -> int:
        """The time [ns]."""
        return self.driver.now_ns()

    @property
    def nodes(self) -> list[Any]:
        """Every node, in the order they came."""
        return list(self.network.nodes)

    # -- participants -------------------------------------------------------------------

    def start(
        self, main: Callable[..., Any], *args: Any, name: str | None = None, argv: list[str] | None = None
    ) -> Participant:
        """Run `main(*args)` as a program of its own, up to where it first waits; it goes on in run().

        Args:
            name: for reports; the function's own if None, with a number if that is taken.
            argv: its command line: sys.argv, and what `rclpy.init()` finds.

        Raises:
            TypeError: `main` is no function.
        """
        participant = self.add(main, *args, name=name, argv=argv)
        if self.driver.is_virtual:
            self.driver.adopt(participant.main_thread, participant)
        participant.main_thread.start()
        if self.driver.is_virtual and not isinstance(process_here(), Participant):  # which gets its turn later
            self._advance(0)
        return participant

    def add(self, main: Callable[..., Any], *args: Any, name: str | None, argv: list[str] | None = None) -> Participant:
        """Make a participant, as start() does, whose thread has not been started."""
        if not callable(main):
            raise TypeError(f"start() takes a function, not {main!r}: pass main itself, without calling it")
        name = self._free_name(name or getattr(main, "__name__", "participant"))
        participant = Participant(name, self, main, args, argv or [name])
        self.participants.append(participant)
        return participant

    def run(self, *, seconds: float) -> None:
        """Let `seconds` [s] pass; the participants work meanwhile.

        Raises:
            ValueError: a negative time.
            RuntimeError: called from within a participant.
        """
        if not seconds >= 0:
            raise ValueError(f"time cannot run back: seconds={seconds}")
        if self.driver.is_virtual:
            self._advance(round(seconds * NSEC_PER_SEC))
        else:
            self.main.sleep(round(seconds * NSEC_PER_SEC))

    def stop(self, participant: Participant | None = None) -> None:
        """Interrupt one participant, or all, as Ctrl-C does, and wait until they have ended.

        They see a KeyboardInterrupt where they spin or sleep.  Unlike on a robot,
        their contexts are still valid then.
        """
        concerned = [each for each in self.participants if each.is_running and participant in (None, each)]
        for each in concerned:
            each.interrupt()
        if self.driver.is_virtual:
            self._advance(GRACE_NS, lambda: not any(each.is_running for each in concerned), stop=False)
        else:
            for each in concerned:
                each.main_thread.join(GRACE_NS / NSEC_PER_SEC / len(concerned))
        for each in concerned:
            if each.is_running:
                print(f'participant "{each.name}" went on after it was interrupted, and was ended.', file=sys.stderr)
                each.end()
        if self.driver.is_virtual:
            self._advance(0, stop=False)

    # -- trouble --------------------------------------------------------------------------

    def disturb(self, topic: str, *, delay: float = 0.0, jitter: float = 0.0, loss: float = 0.0, seed: int = 0) -> None:
        """Put something between the publishers and the subscriptions of a topic; nothing, without arguments.

        Args:
            delay: how long every message takes [s].
            jitter: up to how much longer [s]; messages keep their order.
            loss: the share of messages that never arrive, 0 to 1, whatever the quality of service.
            seed: the same seed gives the same trouble.
        """
        if delay < 0 or jitter < 0 or not 0 <= loss <= 1:
            raise ValueError(
                f"delay and jitter must not be negative, and loss is between 0 and 1: delay={delay}, "
                f"jitter={jitter}, loss={loss}"
            )
        if not topic.startswith("/"):
            raise ValueError(f'a topic of the graph has an absolute name: "/{topic}", not "{topic}"')
        disturbance = None
        if delay or jitter or loss:
            disturbance = Disturbance(
                round(delay * NSEC_PER_SEC), round(jitter * NSEC_PER_SEC), loss, random.Random(f"{seed} {topic}")
            )
        self.network.topic(topic).disturbance = disturbance

    def set_clock_offset(self, node_name: str, seconds: float) -> None:
        """Set the clock of a node wrong by `seconds` [s], as on a machine whose clock is: now and when it comes.

        Raises:
            ValueError: it would show a time before zero, which ROS has no stamp for.
        """
        if self.now_ns + round(seconds * NSEC_PER_SEC) < 0:
            raise ValueError(
                f"the clock of {node_name} would show {self.now_ns / NSEC_PER_SEC + seconds:.3f} s, and there is no "
                f"stamp before zero: the graph is at {self.now_ns / NSEC_PER_SEC:.3f} s. Let time pass first: "
                f"graph.run(seconds={math.ceil(-seconds - self.now_ns / NSEC_PER_SEC)})"
            )
        full_name = node_name if node_name.startswith("/") else f"/{node_name}"
        self._offsets_ns[full_name] = round(seconds * NSEC_PER_SEC)
        for node in self.network.nodes:
            if node.get_fully_qualified_name() == full_name:
                node.get_clock().offset_ns = self._offsets_ns[full_name]

    # -- for nodes ------------------------------------------------------------------------

    def add_node(self, node: Any) -> None:
        """Take a new node in."""
        self.network.nodes.append(node)
        node.get_clock().offset_ns = self._offsets_ns.get(node.get_fully_qualified_name(), 0)

    def remove_node(self, node: Any) -> None:
        """Let a node go."""
        if node in self.network.nodes:
            self.network.nodes.remove(node)

    # -- inside -----------------------------------------------------------------------------

    def _advance(self, duration_ns: int, done: Callable[[], bool] = lambda: False, stop: bool = True) -> None:
        gc.freeze()  # what is there already is not garbage; looking through it again and again takes a fifth longer
        try:
            self.driver.run_until(self.driver.now_ns() + duration_ns, done)
        except KeyboardInterrupt:  # the stop button of the notebook stops everything
            if stop:
                self.stop()
            raise
        finally:
            gc.unfreeze()

    def _free_name(self, name: str) -> str:
        taken = {each.name for each in self.participants if each.is_running}
        number, free = 1, name
        while free in taken:
            number += 1
            free = f"{name}_{number}"
        return free


def new_graph(virtual: bool = True) -> Graph:
    """Make a graph, and make it the current one; what lived in the one before is stopped."""
    before = use_graph(None)
    if before is not None:
        before.stop()
    graph = Graph(virtual)
    use_graph(graph)
    return graph


def current_process() -> Process:
    """Return the process that this thread belongs to; where nobody lives yet, a graph in real time begins."""
    process = process_here()
    if process is None:
        graph = Graph(virtual=False)
        use_graph(graph)
        return graph.main
    return process


def current_graph() -> Graph:
    """Return the graph that this thread's process lives in."""
    return current_process().graph


def _without_our_frames(error: BaseException) -> BaseException:
    """Return an exception whose traceback begins in the participant's own code."""
    trace = error.__traceback__
    while trace is not None and trace.tb_frame.f_code.co_filename in _OUR_FILES:
        trace = trace.tb_next
    return error.with_traceback(trace)


# What runs a participant's main function, and is nothing that a reader of its traceback should look at.
_OUR_FILES = {__file__, str(Path(__file__).with_name("run.py"))}
