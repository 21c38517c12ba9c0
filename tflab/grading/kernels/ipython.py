"""Run a learner's cells in ipykernel, with one socket pair in place of its five ZeroMQ sockets.

    grader                        kernel (forked, sandboxed)
    {"msg_id", "code"}   ----->   IPythonKernel.do_execute, in a running event loop, as in JupyterLab
                         <-----   error · probe's display_data · execute_reply · status: idle

Magics, `await`, widgets, `display` and plots are what they are in JupyterLab, but only what grading
reads goes over the wire: prints, pictures and widgets are made and then dropped, so a talkative
answer costs nothing.  The kernel is built once, before the fork (`build`), and has no thread.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import os
import socket
import subprocess
import sys
import threading
from types import SimpleNamespace
from typing import Any

from .probe_answer import PROBE_TYPE
from .wire import Wire

__all__ = ["build", "serve", "warm_up"]

LONGEST_TEXT = 2000
LONGEST_CODE = 64 << 20
WARMING = (
    "x = {'a': [1, 2.5], 'b': (None, True)}\nprint(x)",
    'import math\ndef f(x, y):\n    """Return something."""\n    return math.hypot(x, y)  # [m]\nf(3, 4)',
    f"from IPython.display import display\ndisplay({{{PROBE_TYPE!r}: {{'id': '', 'v': [x]}}}}, raw=True)",
    "1 / 0",
)


def build() -> Any:
    """Make the kernel, once per process; it talks to nobody before `serve`."""
    import IPython
    from ipykernel.ipkernel import IPythonKernel
    from ipykernel.zmqshell import ZMQInteractiveShell
    from IPython.core.profiledir import ProfileDir
    from jupyter_client.session import Session
    from traitlets import Any as AnyTrait
    from traitlets import Type as TypeTrait
    from traitlets.config import Config

    class OneWire(Session):
        """ipykernel sends everything through its session: here it goes to the wire, or nowhere."""

        wire: Wire | None = None

        def send(self, stream: Any, message: Any, content: Any = None, parent: Any = None, **rest: Any) -> Any:
            if not isinstance(message, dict):  # a type, and what belongs to it
                message = as_message(message, parent or {}, content)
            said = filter_message(message)
            if said is not None and self.wire is not None:  # there is none before `serve`
                self.wire.send_bytes(said)
            return message

    class Shell(ZMQInteractiveShell):
        def enable_gui(self, gui: Any = None) -> None:
            """Accept every event loop of windows: there are none."""
            self.active_eventloop = gui

        def system_piped(self, cmd: str) -> None:
            """Run `!cmd` without a terminal: not every wall has one, and nobody reads what it prints."""
            null = subprocess.DEVNULL
            words = self.var_expand(cmd, depth=1)
            done = subprocess.run(words, shell=True, stdin=null, stdout=null, stderr=null, check=False)
            self.user_ns["_exit_code"] = done.returncode

        system = system_piped

        def ask_exit(self) -> None:
            """End nothing: there may be answers after a cell with `exit` in it."""

    class SocketlessKernel(IPythonKernel):
        shell_class = TypeTrait(Shell)
        shell_stream = AnyTrait()

        def start(self) -> None:
            """Serve nothing by itself."""

    class NoFolder(ProfileDir):
        def _location_changed(self, change: Any) -> None:
            """Make no folder in anybody's home."""

    IPython.embed = refuse_nested_shell
    config = Config()
    config.HistoryManager.enabled = False
    config.InteractiveShell.xmode = "Minimal"  # nobody reads the traceback, and a full one takes long
    config.InteractiveShell.colors = "nocolor"
    config.InteractiveShell.cache_size = 1000
    kernel = SocketlessKernel.instance(
        config=config,
        session=OneWire(config=config, key=b""),
        iopub_socket=object(),
        profile_dir=NoFolder(location="."),
        log=logging.getLogger("tflab.grading"),
    )
    kernel.shell_channel_thread = SimpleNamespace(parent_thread=threading.main_thread())
    return kernel


def warm_up(kernel: Any) -> None:
    """Run a few cells before the fork: what Python learns from them, every kernel knows."""
    shell = kernel.shell
    before = set(shell.user_ns)

    async def run() -> None:
        for _ in range(12):  # an interpreter adapts to code that it has seen eight times
            for code in WARMING:
                kernel.set_parent([], {"header": {"msg_id": "", "session": "grader"}})
                await kernel.do_execute(code, silent=False, store_history=False, allow_stdin=False)

    asyncio.run(run())
    for name in set(shell.user_ns) - before:
        del shell.user_ns[name]
    shell.execution_count = 1


def refuse_nested_shell(*_: Any, **__: Any) -> None:
    """Stand in for IPython's shell in a shell, which would take this one's place and wait for a keyboard."""
    raise RuntimeError("there is no keyboard here")


def as_message(kind: str, parent: dict[str, Any], content: Any) -> dict[str, Any]:
    return {"msg_type": kind, "parent_header": parent.get("header", parent), "content": content}


def filter_message(message: dict[str, Any]) -> bytes | None:
    """Return what of a message goes to the grader, as JSON; None if nothing does."""
    kind, content = message.get("msg_type"), message.get("content") or {}
    if kind == "error":
        words = {name: str(content[name])[:LONGEST_TEXT] for name in ("ename", "evalue")}
        content = words | {"traceback": []}
    elif kind in ("display_data", "execute_result"):
        data = content.get("data") or {}
        if PROBE_TYPE not in data:
            return None
        content = {"data": {PROBE_TYPE: data[PROBE_TYPE]}, "metadata": {}}
        kind = "display_data"
    else:
        return None
    parent = {"msg_id": (message.get("parent_header") or {}).get("msg_id")}
    said = {"channel": "iopub", "msg_type": kind, "parent_header": parent, "content": content}
    return json.dumps(said, default=str).encode()


def serve(kernel: Any, end: socket.socket) -> None:
    """Run what comes over the wire, cell by cell, until the grader hangs up."""
    loop = asyncio.new_event_loop()
    asyncio.set_event_loop(loop)
    serving = loop.create_task(_serve(kernel, Wire(end, longest=LONGEST_CODE)))
    while not serving.done():
        with contextlib.suppress(RuntimeError):  # an answer stopped the loop: on it goes
            loop.run_until_complete(serving)


async def _serve(kernel: Any, wire: Wire) -> None:
    from tornado.ioloop import IOLoop

    kernel.session.wire = wire
    kernel.io_loop = IOLoop.current()
    me = os.getpid()
    wire.send({"ready": True})
    while True:
        try:
            request = await _next(wire)
        except asyncio.CancelledError:  # by an answer that cancelled every task: on it goes
            continue
        if any(stream is None or getattr(stream, "closed", False) for stream in (sys.stdout, sys.stderr)):
            sys.stdout = sys.stderr = open(os.devnull, "w")  # noqa: SIM115  # an answer closed it: none could run then
        parent = {"header": {"msg_id": request["msg_id"], "session": "grader", "msg_type": "execute_request"}}
        kernel.set_parent([], parent)
        try:
            reply = await kernel.do_execute(request["code"], silent=False, store_history=False, allow_stdin=False)
            status = reply["status"]
        except (Exception, asyncio.CancelledError, KeyboardInterrupt) as fault:  # of the kernel, perhaps tampered with
            status = "error"
            words = {"ename": type(fault).__name__, "evalue": str(fault)}
            kernel.session.send(None, "error", words, parent)
        if os.getpid() != me:
            os._exit(0)  # a copy that an answer made of the kernel, and forgot to end
        wire.send({"channel": "shell"} | as_message("execute_reply", parent, {"status": status}))
        wire.send({"channel": "iopub"} | as_message("status", parent, {"execution_state": "idle"}))


async def _next(wire: Wire) -> dict[str, Any]:
    """Return the next request, while whatever answers left running in the loop runs on."""
    loop = asyncio.get_running_loop()
    while (request := wire.receive(0)) is None:
        ready = loop.create_future()
        loop.add_reader(wire.fileno(), lambda ready=ready: ready.done() or ready.set_result(None))
        try:
            await ready
        finally:
            loop.remove_reader(wire.fileno())
        # nothing is lost in between: the wire keeps what has come
    return request
