"""Run node files together in real time, as `tflab run a.py b.py` does.

    a.py               -->  participant "a"       --.
    hop_ws hop:rabbit  -->  participant "rabbit"  --+--  one graph, the machine's clock  -- Ctrl-C --> all of them

Each runs as if in a process of its own: a file as `python file.py` runs it, an
executable of a workspace as `ros2 run` does.  Ctrl-C does what it does on ROS 2: it
shuts the contexts down first, so a file that ends with `finally: rclpy.shutdown()`
ends with an RCLError.
"""

from __future__ import annotations

import ast
import contextlib
import os
import re
import signal
import sys
import threading
import time
import tokenize
import traceback
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

from . import workspace
from .activation import MESSAGE_PACKAGES, PACKAGES, activate
from .graph import Graph, Participant, new_graph
from .process import process_here, write_line
from .virtual import counting_ctrl_c, place_of, raise_in
from .workspace import EntryPoint

__all__ = ["run_entry_point", "run_files"]

# After Ctrl-C: how long whoever sleeps or spins takes to hear of it, and how long to tidy up [s].
HEARING_S, GRACE_S = 0.5, 5.0


def run_files(
    paths: Sequence[str],
    *,
    args: Sequence[str] = (),
    beside: Sequence[tuple[str, Callable[[], None]]] = (),
    seconds: float | None = None,
) -> int:
    """Run node files in real time until all have ended, or Ctrl-C; return 0, or 1 if one of them failed.

    Args:
        paths: files, executables of a workspace as "package:executable", and folders of workspaces or packages.
        args: the command line of each, such as ["--ros-args", "-p", "use_sim_time:=true"].
        beside: (name, main function) of whatever shall run with them; when the files
            have ended these are interrupted, and when these have ended nothing happens.
        seconds: interrupt them after this time [s].

    Raises:
        FileNotFoundError: one of them does not exist; none has been started then.
        LookupError: a workspace has no such executable, or several and none was named.
        TypeError: a single path, outside of a list.
    """
    if isinstance(paths, str | os.PathLike):
        raise TypeError(f"run_files takes a list of files: run_files([{str(paths)!r}])")
    programs = _programs(list(map(str, paths)))
    activate("in-process")
    graph = new_graph(virtual=False)
    is_ignored = signal.getsignal(signal.SIGINT) == signal.SIG_IGN  # in the background of a shell it is ignored
    with _importing_beside(paths), contextlib.nullcontext([]) if is_ignored else counting_ctrl_c() as pressed:
        files = [
            graph.add(partial(run_entry_point, entry), name=name, argv=[command, *args])
            for name, command, entry in programs
        ]
        others = [graph.add(main, name=name) for name, main in beside]
        waiting = (graph, files or others, seconds, pressed)
        supervisor = threading.Thread(target=_supervise, args=waiting, daemon=True)
        for each in graph.participants[1:]:
            each.main_thread.start()
        supervisor.start()
        handler = signal.getsignal(signal.SIGINT)
        for first in graph.participants[:1]:  # this thread may set signal handlers and open windows
            first.run_here()
        if signal.getsignal(signal.SIGINT) != handler:
            signal.signal(signal.SIGINT, handler)
        while supervisor.is_alive():
            with contextlib.suppress(KeyboardInterrupt):  # meant for a file that has just ended
                supervisor.join()
    return max((_status(each) for each in graph.participants), default=0)


def _supervise(graph: Graph, waited: Sequence[Participant], seconds: float | None, pressed: list[int]) -> None:
    """Wait until some have ended, then end the others; in a thread of its own, as a file runs in the main one."""
    _wait_for(waited, seconds, pressed)
    _interrupt([each for each in graph.participants if each.is_running], pressed)
    if any(each.is_running for each in graph.participants[:1]):  # in a call that nothing interrupts
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(1)


def _programs(words: Sequence[str]) -> list[tuple[str, str, EntryPoint]]:
    """Return the name, the command and the entry point of each file and executable that was named."""
    programs, is_named = [], any(map(_named_executable, words))
    for word in words:
        if os.path.isfile(word):
            workspace.use_packages(workspace.packages_around(word))
            programs.append((Path(word).stem, word, EntryPoint(Path(word))))
            continue
        if os.path.isdir(word):
            packages, own = workspace.packages_around(word), workspace.package_around(word)
            workspace.use_packages(packages)
            if is_named:
                continue
            found = [f"{each.name}:{name}" for each in packages.values() for name in each.executables()]
            found = [each for each in found if own is None or each.startswith(f"{own.name}:")]
            if not found:
                raise LookupError(f"{word} has no executable in Python")
            if len(found) > 1:
                raise LookupError(f"name the executables of {word} to run: {' '.join(found)}")
            word = found[0]
        if (match := _named_executable(word)) is None:
            raise FileNotFoundError(f"no such node file: {word}")
        programs.append((match[2], match[2], workspace.find_executable(match[1], match[2])))
    return programs


def _named_executable(word: str) -> re.Match | None:
    return None if os.path.exists(word) else re.fullmatch(r"(\w{2,}):([\w.-]+)", word)


# -- one program ----------------------------------------------------------


def run_entry_point(entry: EntryPoint) -> None:
    """Run an executable of a package as `ros2 run` would, or a file as `python file.py` would.

    Where a file only defines what `ros2 run` would call, that is called.
    """
    try:
        if entry.module:
            _, module = _execute(str(entry.path), entry.module, entry.module.rpartition(".")[0])
            sys.exit(getattr(module, entry.function)())
        _run_file(entry.path)
    except ModuleNotFoundError as error:
        if error.name:
            error.msg += _remedy(error.name.partition(".")[0])
        raise
    except (RuntimeError, ValueError) as error:
        if re.search("main thread|event loop in thread", str(error)):
            error.args = (f"{error}\n(tflab runs only the first file in the main thread. Name this one first.)",)
        raise


def _run_file(path: Path) -> None:
    package, folder, parents = workspace.package_around(path), Path(os.path.abspath(path)).parent, []
    while package is not None and (folder / "__init__.py").is_file():
        parents, folder = [folder.name, *parents], folder.parent
    tree, module = _execute(str(path), "__main__", ".".join(parents))
    entries = package.executables().values() if package is not None else ()
    functions = [each.function for each in entries if each.function and each.path.samefile(path)]
    function = _uncalled(tree, functions or ["main"])
    if function is not None and process_here().default_context is None:
        if not functions:
            write_line(
                f"tflab: nothing in {path} calls {function}(), so python would do nothing with it. tflab calls it. "
                f'End the file with `if __name__ == "__main__": {function}()`.'
            )
        sys.exit(getattr(module, function)())


def _execute(path: str, name: str, package: str) -> tuple[ast.Module, ModuleType]:
    """Execute a file as a module of its own; return its syntax tree, too."""
    tree = compile(_source(path), path, "exec", ast.PyCF_ONLY_AST, dont_inherit=True)
    module = ModuleType(name)
    module.__file__, module.__package__ = path, package
    if name != "__main__":
        sys.modules.setdefault(name, module)
    exec(compile(tree, path, "exec", dont_inherit=True), module.__dict__)
    return tree, module


def _uncalled(tree: ast.Module, functions: Sequence[str]) -> str | None:
    """Return the first of these functions that a file defines and never uses; None where it asks for __name__."""
    has_guard = any(isinstance(each, ast.If) and "__name__" in ast.unparse(each.test) for each in tree.body)
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    defined = {each.name for each in tree.body if isinstance(each, ast.FunctionDef)}
    return None if has_guard else next((each for each in functions if each in defined - used), None)


def _remedy(package: str) -> str:
    """Return what there is, and what to do, where a package is missing."""
    if package in PACKAGES or workspace.find_package(package):
        return ""
    there = set(PACKAGES) - MESSAGE_PACKAGES
    remedy = f"Install {package} with pip, or put its folder into the workspace: {package}/__init__.py."
    if workspace.INTERFACES.fullmatch(package):
        there = MESSAGE_PACKAGES
        remedy = f"Put its texts into the workspace or beside the file: {package}/msg/NAME.msg, and srv/ or action/."
    elif package == "xacro":
        remedy = "Make the URDF where ROS is installed: xacro robot.urdf.xacro > robot.urdf."
    return f". tflab runs without ROS. It brings these packages: {', '.join(sorted(there))}. {remedy}"


def _source(path: str) -> str:
    """Return a Python file's text: UTF-8, or what its "coding:" says.

    Raises:
        SyntaxError: it is neither.
    """
    try:
        with tokenize.open(path) as file:
            return file.read()
    except UnicodeDecodeError as fault:
        raise SyntaxError(f"{path} is not UTF-8 ({fault}); save it as UTF-8 in your editor") from None


@contextlib.contextmanager
def _importing_beside(paths: Sequence[str]) -> Iterator[None]:
    """Let each file import its neighbours, as a script can; report a thread's exception in one piece."""
    folders = list(dict.fromkeys(os.path.dirname(os.path.abspath(path)) for path in paths if os.path.isfile(path)))
    sys.path[:0] = folders
    hook, threading.excepthook = threading.excepthook, _report_thread
    try:
        yield
    finally:
        threading.excepthook = hook
        for folder in folders:
            sys.path.remove(folder)


def _report_thread(fault: Any) -> None:
    if fault.exc_type is not SystemExit:
        text = "".join(traceback.format_exception(fault.exc_type, fault.exc_value, fault.exc_traceback))
        write_line(f"Exception in thread {fault.thread.name}:\n{text.rstrip()}")


def _wait_for(participants: Sequence[Participant], seconds: float | None, pressed: list[int], presses: int = 1) -> None:
    """Wait until all have ended, the time is over, or Ctrl-C was pressed as often as `presses`."""
    until_s = None if seconds is None else time.monotonic() + seconds
    while any(each.is_running for each in participants) and len(pressed) < presses:
        if until_s is not None and time.monotonic() >= until_s:
            return
        time.sleep(0.05)


def _interrupt(participants: Sequence[Participant], pressed: list[int]) -> None:
    """Do what Ctrl-C does to each, and name whoever goes on regardless."""
    again = len(pressed) + 1  # one more Ctrl-C ends the patience
    for each in participants:
        each.interrupt(shut_down_contexts=True)
    _wait_for(participants, HEARING_S, pressed, again)
    for each in participants:
        if len(pressed) < again and each.is_running and each.take_interrupt():
            # Busy: Python interrupts in the middle of a loop, too.
            write_line(
                f'participant "{each.name}" neither slept nor spun: interrupted at {place_of(each.main_thread)}.'
            )
            raise_in(each.main_thread, KeyboardInterrupt)
            if each.main_thread is threading.main_thread() and hasattr(signal, "pthread_kill"):
                signal.pthread_kill(each.main_thread.ident, signal.SIGINT)  # also out of input()
                again += 1
    _wait_for(participants, GRACE_S, pressed, again)
    for each in participants:
        if each.is_running:
            write_line(f'participant "{each.name}" went on after it was interrupted, at {place_of(each.main_thread)}.')


def _status(participant: Participant) -> int:
    """Return the exit status of a file: that of its sys.exit(), 1 for another exception or if it never ended."""
    end = participant.exception
    if isinstance(end, SystemExit) and isinstance(end.code, int):
        return end.code
    return int(participant.is_running or not isinstance(end, (KeyboardInterrupt, type(None))))
