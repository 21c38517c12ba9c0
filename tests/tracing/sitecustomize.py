"""Collect the source files of which a function runs, here or in a child process.

`conftest.py` loads this file and calls `start` and `stop` around a test. Python loads
it in a child process, because `PYTHONPATH` names this folder. There it appends each
file of the repository to the file that `TRACED_FILES` names, at its first call: a kernel
may be killed at any time.
"""

import os
import sys
import threading
from contextlib import suppress

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))) + os.sep
REPORT = os.environ.get("TRACED_FILES")
CO_OPTIMIZED = 1  # of a function; the body of a module or a class runs at import, and lacks it
ran: set[str] = set()


def start(trace):
    threading.settrace(trace)
    sys.settrace(trace)


def stop():
    threading.settrace(None)
    sys.settrace(None)


def collect(frame, event, argument):
    """Trace a call. It returns None, so that the lines of the function are not traced."""
    if frame.f_code.co_flags & CO_OPTIMIZED:
        ran.add(frame.f_code.co_filename)


def collect_and_append(frame, event, argument):
    name = frame.f_code.co_filename
    if name not in ran and frame.f_code.co_flags & CO_OPTIMIZED:
        ran.add(name)
        if name.startswith(ROOT):
            with suppress(OSError), open(REPORT, "a", encoding="utf-8") as report:  # a sandbox does not show it
                report.write(name + "\n")


if REPORT and __name__ == "sitecustomize":
    start(collect_and_append)
