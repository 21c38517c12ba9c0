"""Run nodes on virtual time: one thread at a time, and the clock moves on when all of them wait.

    driver ---- turn ----> thread A    runs until it sleeps, spins or returns
           <--- turn -----
           ---- turn ----> thread B
           <--- turn -----
    nobody is ready: set the clock to the next event, and go on

Every thread of a participant is scheduled: it only runs while it has the turn, and
gives it back whenever it would block.  So there are no races, 20 s of robot take
milliseconds, and the same program prints the same twice.  This is cooperative
scheduling of a discrete-event simulation: the turn is a baton that a pair of locks
hands over, the agenda is the event queue.  The thread that made
the graph (the notebook's) is not scheduled: while it runs or waits, it hands out the
turns.
"""

from __future__ import annotations

import ctypes
import heapq
import itertools
import signal
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from tflab.core import NSEC_PER_SEC

__all__ = ["START_NS", "EndlessLoop", "VirtualTime", "counting_ctrl_c", "place_of", "raise_in"]

START_NS = 1_000_000_000  # one second: readable stamps, and never 0, which tf2 takes for "latest"

# On a robot every turn takes time.  After so many turns without any, a step makes
# two nodes that answer each other at once get on with it.
TURNS_PER_INSTANT = 2_000
STEP_NS = 1_000_000

# In real time [s]: how often to look whether Ctrl-C was pressed while somebody has the turn, and how long an
# interrupted thread may take to give it back.
SLICE_S = 0.1
PATIENCE_AFTER_INTERRUPT_S = 2.0
LEAST_SHARE = 1 / 6  # of a slice in which a thread had next to nothing of the processor, as far as patience goes


class EndlessLoop(BaseException):
    """A participant kept its turn for too long (a watchdog's timeout); raised past every `except Exception`."""


class VirtualWaiter:
    """Somebody waiting, who can be woken."""

    def __init__(self, driver: VirtualTime) -> None:
        self._driver = driver
        self.woken = False
        self.scheduled: ScheduledThread | None = None

    def wake(self) -> None:
        """End the present wait, or the next one."""
        self.woken = True
        if self.scheduled is not None:
            self._driver.make_ready(self.scheduled)


class ScheduledThread:
    """One thread that waits for its turn."""

    def __init__(self, process: Any, thread: threading.Thread) -> None:
        self.process = process
        self.thread = thread
        self.is_ready = True
        self.is_lost = False
        self.is_finished = False
        self.alarm_ns: int | None = None
        self.at_end: list[VirtualWaiter] = []
        # Two locks that are held from the start: whoever is to wait acquires, the other one releases.
        self._go = threading.Lock()
        self._back = threading.Lock()
        self._go.acquire()
        self._back.acquire()

    def get_turn(self) -> None:
        """Let the thread run until it gives the turn back."""
        self._go.release()

    def has_given_back(self, patience_s: float) -> bool:
        """Return whether the thread gives the turn back within `patience_s` [s] of real time."""
        return self._back.acquire(timeout=patience_s)

    def give_turn_back(self) -> None:
        """Block, in the thread itself, until it has the turn again."""
        self._back.release()
        self._go.acquire()

    def begin(self) -> None:
        """Wait, in the thread itself, for the first turn."""
        self._go.acquire()

    def finish(self) -> None:
        """Give the turn back for good."""
        self.is_finished = True
        for waiter in self.at_end:
            waiter.wake()
        self._back.release()


class VirtualTime:
    """The clock, the turns, and what is due when.

    Attributes:
        patience_s: how long a participant may keep its turn, computing or blocked [s]; time in which it waits
            for a processor that others have counts for little.
    """

    is_virtual = True
    poll_ns = STEP_NS  # a poll that finds nothing takes this long, so that polling in a loop gets somewhere

    def __init__(self) -> None:
        self.patience_s = 5.0
        self._now_ns = START_NS
        self._home = threading.get_ident()
        self._order = itertools.count()
        self._agenda: list[tuple[int, int, Callable[..., None], tuple]] = []
        self._ready: deque[ScheduledThread] = deque()
        self._scheduled: dict[int, ScheduledThread] = {}
        self._in_callback = 0
        self._presses: list[int] = []  # of Ctrl-C, while turns are handed out
        self._pace_ns: int | None = None  # what to add to virtual time for the time it is to have in reality

    def now_ns(self) -> int:
        """Return the virtual time [ns]."""
        return self._now_ns

    steady_ns = now_ns

    # -- for those who wait -------------------------------------------------

    def new_waiter(self) -> VirtualWaiter:
        """Return something to wait on."""
        return VirtualWaiter(self)

    def wait(self, waiter: VirtualWaiter, duration_ns: int | None) -> None:
        """Block until woken, or until `duration_ns` [ns] have passed."""
        until_ns = None if duration_ns is None else self._now_ns + max(0, duration_ns)
        scheduled = self._scheduled.get(threading.get_ident())
        if scheduled is None:
            self._wait_at_home(waiter, until_ns)
        elif not waiter.woken:
            waiter.scheduled = scheduled
            scheduled.is_ready = False
            if until_ns is not None and until_ns != scheduled.alarm_ns:
                scheduled.alarm_ns = until_ns
                self._put(until_ns, self._ring, (scheduled, until_ns))
            scheduled.give_turn_back()
            waiter.scheduled = None
        waiter.woken = False

    def call_after(self, delay_ns: int, action: Callable[[], None]) -> None:
        """Have `action` called in `delay_ns` [ns]; it must not block."""
        self._put(self._now_ns + delay_ns, action, ())

    def make_ready(self, scheduled: ScheduledThread) -> None:
        """Put a thread in the queue for the turn, if it is not there."""
        if not scheduled.is_ready:
            scheduled.is_ready = True
            self._ready.append(scheduled)

    def is_cooperative(self) -> bool:
        """Return whether this thread passes virtual time when it sleeps."""
        ident = threading.get_ident()
        return ident in self._scheduled or (ident == self._home and self._in_callback > 0)

    def enter_callback(self) -> None:
        """Note that a callback begins; at home, sleeping passes virtual time in there."""
        if threading.get_ident() == self._home:
            self._in_callback += 1

    def leave_callback(self) -> None:
        """Note that it has ended."""
        if threading.get_ident() == self._home:
            self._in_callback -= 1

    @contextmanager
    def spinning(self) -> Iterator[None]:
        """Mark that something spins without end; at home, time then passes as fast as it really does.

        On a robot nobody would read faster, either, and the stop button ends it.
        """
        is_first = threading.get_ident() == self._home and self._pace_ns is None
        if is_first:
            self._pace_ns = time.monotonic_ns() - self._now_ns
        try:
            yield
        finally:
            if is_first:
                self._pace_ns = None

    # -- threads --------------------------------------------------------------

    def adopt(self, thread: threading.Thread, process: Any) -> ScheduledThread:
        """Schedule a thread that has not been started yet."""
        scheduled = ScheduledThread(process, thread)
        run = thread.run

        def run_in_turns() -> None:
            self._scheduled[threading.get_ident()] = scheduled
            scheduled.begin()
            try:
                if not process.ended:
                    run()
            except SystemExit:
                pass  # its process has ended
            except BaseException:  # reported while it still has its turn, so that outputs keep their order
                threading.excepthook(threading.ExceptHookArgs((*sys.exc_info(), thread)))
            finally:
                self._scheduled.pop(threading.get_ident(), None)
                scheduled.finish()

        thread.run = run_in_turns
        thread.tflab_scheduled = scheduled
        self._ready.append(scheduled)
        return scheduled

    def join(self, scheduled: ScheduledThread, duration_ns: int | None) -> None:
        """Wait until a thread has finished."""
        waiter = self.new_waiter()
        scheduled.at_end.append(waiter)
        if not scheduled.is_finished:
            self.wait(waiter, duration_ns)

    # -- handing out the turns ------------------------------------------------

    def run_until(self, until_ns: int, done: Callable[[], bool] = lambda: False) -> None:
        """Do everything that is due up to and including `until_ns` [ns], or until `done()`."""
        self._must_be_home()
        self._go_on(until_ns, done)

    def _wait_at_home(self, waiter: VirtualWaiter, until_ns: int | None) -> None:
        self._must_be_home()
        nothing_left = self._go_on(until_ns, lambda: waiter.woken)
        if nothing_left and until_ns is None:
            raise RuntimeError(
                "this would wait for ever: nobody in the graph has anything left to do, so nothing can arrive any "
                "more. Start a participant that publishes or answers, or give a timeout."
            )

    def _go_on(self, until_ns: int | None, done: Callable[[], bool]) -> bool:
        """Hand out turns and pass time; return True when nothing is due any more, False when `done()`."""
        turns = 0
        with self._noting_interrupts():
            while not done():
                if self._presses:
                    return False
                if self._ready and turns < TURNS_PER_INSTANT:
                    self._turn(self._ready.popleft())
                    turns += 1
                    continue
                turns = 0
                next_ns = self._now_ns + STEP_NS if self._ready else self._agenda[0][0] if self._agenda else None
                if next_ns is None or (until_ns is not None and next_ns > until_ns):
                    self._pass_time(self._now_ns if until_ns is None else until_ns)
                    return True
                self._pass_time(next_ns)
                while self._agenda and self._agenda[0][0] <= self._now_ns:
                    _, _, action, arguments = heapq.heappop(self._agenda)
                    action(*arguments)
        return False

    def _pass_time(self, until_ns: int) -> None:
        """Set the clock; while something spins without end at home, wait until reality is there, too."""
        while self._pace_ns is not None and not self._presses:
            left_ns = until_ns + self._pace_ns - time.monotonic_ns()
            if left_ns <= 0:
                break
            time.sleep(min(left_ns / NSEC_PER_SEC, SLICE_S))
        self._now_ns = max(self._now_ns, until_ns)

    @contextmanager
    def _noting_interrupts(self) -> Iterator[None]:
        """Hold Ctrl-C, or the stop button, back until the current turn ends."""
        with counting_ctrl_c() as self._presses:
            yield
        if self._presses:
            raise KeyboardInterrupt

    def _turn(self, scheduled: ScheduledThread) -> None:
        if scheduled.is_lost:
            return
        scheduled.get_turn()
        waited_s, cpu_s = 0.0, None
        while not scheduled.has_given_back(SLICE_S):
            before_s, cpu_s = cpu_s, cpu_s_of(scheduled.thread)
            # Where other programs take the machine, a thread gets less of it than has passed, and less counts.
            worked_s = 0.0 if before_s is None else cpu_s - before_s
            waited_s += min(max(worked_s, LEAST_SHARE * SLICE_S), SLICE_S) if worked_s else SLICE_S
            if self._presses:  # interrupt it, too, while it runs
                raise_in(scheduled.thread, KeyboardInterrupt)
                self._wait_for_turn_of(scheduled)
                return
            if waited_s >= self.patience_s:
                self._end_loop(scheduled)
                return

    def _end_loop(self, scheduled: ScheduledThread) -> None:
        """Throw EndlessLoop into a thread that keeps its turn; give it up if that does not help."""
        where = place_of(scheduled.thread)
        scheduled.process.loop = where
        raise_in(scheduled.thread, EndlessLoop)
        self._wait_for_turn_of(scheduled)

    def _wait_for_turn_of(self, scheduled: ScheduledThread) -> None:
        """Wait for the turn of a thread that was interrupted; give the thread up if it keeps it all the same."""
        if not scheduled.has_given_back(PATIENCE_AFTER_INTERRUPT_S):
            scheduled.is_lost = True
            scheduled.process.lost(place_of(scheduled.thread))

    def _ring(self, scheduled: ScheduledThread, until_ns: int) -> None:
        if scheduled.alarm_ns == until_ns:
            scheduled.alarm_ns = None
            self.make_ready(scheduled)

    def _put(self, time_ns: int, action: Callable[..., None], arguments: tuple) -> None:
        heapq.heappush(self._agenda, (time_ns, next(self._order), action, arguments))

    def _must_be_home(self) -> None:
        if threading.get_ident() != self._home:
            raise RuntimeError(
                "on virtual time this thread is unknown to the graph, and only the thread that made the graph can let "
                "time pass. Start what should run beside it with graph.start(function); inside a participant, spin "
                "or sleep."
            )


@contextmanager
def counting_ctrl_c() -> Iterator[list[int]]:
    """Yield a list that grows by one for each Ctrl-C, instead of an exception that may come between any two lines."""
    pressed: list[int] = []
    if threading.current_thread() is not threading.main_thread():
        yield pressed  # only the main thread receives the signal
        return
    before = signal.signal(signal.SIGINT, lambda number, frame: pressed.append(number))
    try:
        yield pressed
    finally:
        signal.signal(signal.SIGINT, before)


def cpu_s_of(thread: threading.Thread) -> float:
    """Return how much a thread has computed so far [s]; where the system does not say, what has passed."""
    if not hasattr(time, "pthread_getcpuclockid") or not thread.is_alive():
        return time.monotonic()
    return time.clock_gettime(time.pthread_getcpuclockid(thread.ident))


def raise_in(thread: threading.Thread, exception: type[BaseException]) -> None:
    """Have `exception` raised in another thread, as soon as it executes Python again."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread.ident), ctypes.py_object(exception))


def place_of(thread: threading.Thread) -> str:
    """Return where a thread is now, as "file:line in function"."""
    frame = sys._current_frames().get(thread.ident)
    if frame is None:
        return "somewhere"
    last = traceback.extract_stack(frame)[-1]
    return f"{last.filename}:{last.lineno} in {last.name}"
