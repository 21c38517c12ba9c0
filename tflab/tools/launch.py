"""Run `ros2 launch`: read a launch file in Python, and start each of its nodes as a participant of this graph.

    ros2 launch hop pair.launch.py pace:=2.0             a file of a package of the workspace
    ros2 launch src/hop/launch/pair.launch.py -s         any file; -s shows its arguments

    Node(package="hop", executable="rabbit", namespace="left", parameters=[{"pace": 2.0}])      in the file
        -->  LaunchEntity("Node", {"package": "hop", ...}, "pair.launch.py:7")
        -->  LaunchStep(0.0, "pair.launch.py:7", ("hop", "rabbit", "--ros-args", "-r", "__ns:=/left", ...))

A file is expanded as a whole before its first node starts.   upstream: ros2launch, launch, launch_ros.
"""

from __future__ import annotations

import argparse
import os
import runpy
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import yaml

from tflab.core import NSEC_PER_SEC
from tflab.ros.ament_index import PackageNotFoundError, get_package_prefix
from tflab.ros.graph import Participant, current_process
from tflab.ros.run import run_entry_point
from tflab.ros.workspace import find_executable, find_package, packages_around, use_packages

from . import ros2

__all__ = ["add_options", "maker_of"]

OPTIONS = {  # of each entity, in the order of its positional arguments; the first one is its value
    "DeclareLaunchArgument": "name default_value description choices condition",
    "FindPackageShare": "package",
    "GroupAction": "actions scoped forwarding condition",
    "IfCondition": "predicate_expression",
    "IncludeLaunchDescription": "launch_description_source launch_arguments condition",
    "LaunchConfiguration": "variable_name default",
    "LaunchDescription": "initial_entities",
    "LogInfo": "msg condition",
    "Node": "executable package name namespace parameters remappings arguments condition "
    "output emulate_tty exec_name sigterm_timeout sigkill_timeout",  # those of this line change nothing here
    "ParameterValue": "value value_type",
    "PathJoinSubstitution": "substitutions",
    "PushRosNamespace": "namespace condition",
    "PythonLaunchDescriptionSource": "location",
    "TextSubstitution": "text",
    "TimerAction": "period actions condition",
    "UnlessCondition": "predicate_expression",
}
NAMESPACE = "ros_namespace"  # the launch configuration that holds it
TRUTHS = {"true": True, "1": True, "false": False, "0": False}
POLL_NS = NSEC_PER_SEC // 10


@dataclass(frozen=True)
class LaunchEntity:
    """What a line of a launch file makes: an action, a substitution, a condition or a description, with its options."""

    kind: str
    options: dict[str, Any]
    line: str

    def add_action(self, action: LaunchEntity) -> None:
        """Add an action to a description."""
        self.options["initial_entities"] = [*(self.options.get("initial_entities") or ()), action]


class LaunchStep(NamedTuple):
    """What to do so many seconds after the beginning: print a text, or run (package, executable, arguments ...)."""

    delay_s: float
    line: str
    words: Sequence[str]


def maker_of(kind: str) -> Callable[..., LaunchEntity]:
    """Return what the modules of `launch` and `launch_ros` have under a name; it is an error to call an unknown one."""
    if kind.startswith("_"):
        raise AttributeError(kind)

    def make(*values: Any, **options: Any) -> LaunchEntity:
        frame = sys._getframe(1)
        line, names = f"{frame.f_code.co_filename}:{frame.f_lineno}", OPTIONS.get(kind, "").split()
        if not names:
            raise RuntimeError(f"{line}: tflab has no {kind}. A launch file can use {', '.join(OPTIONS)}")
        options = dict(zip(names, values, strict=False)) | options
        if others := [name for name, value in options.items() if value and name not in names]:
            raise RuntimeError(f"{line}: tflab's {kind} has no {others[0]}; it has {', '.join(names)}")
        return LaunchEntity(kind, options, line)

    return make


# -- the command ----------------------------------------------------------


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `ros2 launch`."""
    parser.add_argument("package_name", help="Name of the ROS package which contains the launch file, or a launch file")
    parser.add_argument("launch_file_name", nargs="?", default="", help="Name of the launch file")
    parser.add_argument("launch_arguments", nargs="*", help="Arguments to the launch file; '<name>:=<value>'")
    parser.add_argument("-s", "--show-args", "--show-arguments", action="store_true", help="Show launch file arguments")
    parser.set_defaults(run=_launch)


def _launch(options: argparse.Namespace) -> int:
    """Launch until all nodes have ended, or Ctrl-C; return 0, also if nodes fail."""
    path, words = options.package_name, options.launch_arguments
    if os.path.isfile(path):
        path, words = os.path.abspath(path), [*filter(None, [options.launch_file_name]), *words]
    else:
        path = _file_in(path, options.launch_file_name)
    use_packages(packages_around(path))
    if options.show_args:
        print("Arguments (pass arguments as '<name>:=<value>'):")
        print("\n".join(_arguments_of(_entities_of(path), {})) or "\n  No arguments.")
        return 0
    if malformed := [word for word in words if ":=" not in word]:
        raise RuntimeError(f"malformed launch argument '{malformed[0]}', expected format '<name>:=<value>'")
    steps = list(_steps(_entities_of(path), dict(word.split(":=", 1) for word in words)))
    process, participants = current_process(), []
    begin_ns = process.driver.steady_ns()
    try:
        for step in sorted(steps, key=lambda step: step.delay_s):
            process.sleep(begin_ns + round(step.delay_s * NSEC_PER_SEC) - process.driver.steady_ns())
            participants += _do(step, len(participants) + 1)
        while any(each.is_running for each in participants):
            process.sleep(POLL_NS)
    finally:
        for each in participants if process.driver.is_virtual else ():  # in a shell Ctrl-C is for all of them
            each.interrupt()
    return 0


def _file_in(name: str, file_name: str) -> str:
    """Return the path of a launch file in a package."""
    package = find_package(name)
    if package is None:
        raise RuntimeError(f"Package '{name}' not found")
    for path in sorted(package.folder.rglob(file_name or "*.launch.py")):
        if path.name == file_name:
            return str(path)
    where = f"in the share directory of package '{name}' which is at '{package.folder}'"
    raise RuntimeError(f"file '{file_name}' was not found {where}")


def _do(step: LaunchStep, number: int) -> list[Participant]:
    """Print the text of a step, or start its node; return the participant, if there is one."""
    if len(step.words) == 1:
        print(f"[INFO] [launch.user]: {step.words[0]}", flush=True)
        return []
    package, executable, *arguments = step.words
    tools, argv = ros2.EXECUTABLES.get(package), [executable]
    try:
        if package == "rviz2":
            raise LookupError("it is a window; in a page, %rviz2 draws the same")
        if tools is None:
            program, argv = partial(run_entry_point, find_executable(package, executable)), [executable, *arguments]
        elif executable in tools:
            program = partial(ros2.main, ["run", *step.words])
        else:
            raise LookupError("No executable found")
    except LookupError as fault:
        print(f"[WARN] [launch]: {step.line}: {package} {executable} is left out: {fault}", flush=True)
        return []
    print(f"[INFO] [{executable}-{number}]: process started", flush=True)
    return [current_process().graph.start(program, name=f"{executable}-{number}", argv=argv)]


# -- from a file to steps -------------------------------------------------


def _entities_of(path: str) -> list[LaunchEntity]:
    """Return the actions that a launch file generates."""
    if not path.endswith(".py"):
        raise RuntimeError(f"{path}: tflab reads launch files in Python, such as pair.launch.py")
    try:
        return runpy.run_path(path)["generate_launch_description"]().options.get("initial_entities") or []
    except (PackageNotFoundError, ImportError) as error:
        lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path]
        raise RuntimeError(f"{path}:{lines[-1]}: {error.args[0]}") from None


def _arguments_of(entities: Iterable[LaunchEntity], known: dict[str, str]) -> Iterator[str]:
    """Yield a paragraph about each argument that a launch file declares."""
    for each in entities:
        if each.kind == "DeclareLaunchArgument":
            name, default = _text(each.options["name"], known), each.options.get("default_value")
            yield f"\n    '{name}':\n        {each.options.get('description') or 'no description given'}"
            if default is not None:
                known[name] = _text(default, known)
                yield f"        (default: '{known[name]}')"
        yield from _arguments_of(each.options.get("actions") or (), known)


def _steps(entities: Iterable[LaunchEntity], known: dict[str, str], delay_s: float = 0.0) -> Iterator[LaunchStep]:
    """Yield the steps of actions; `known` are the launch configurations, which they may set."""
    for each in entities:
        try:
            condition = each.options.get("condition")
            text = "true" if condition is None else _text(condition, known).strip().lower()
            if text not in TRUTHS:
                raise ValueError(f"a condition is true, false, 1 or 0, not '{text}'")
            if TRUTHS[text] == (condition is None or condition.kind == "IfCondition"):
                yield from _steps_of(each, known, delay_s)
        except (PackageNotFoundError, ValueError) as error:
            raise RuntimeError(f"{each.line}: {error.args[0]}") from None


def _steps_of(each: LaunchEntity, known: dict[str, str], delay_s: float) -> Iterator[LaunchStep]:
    value, option = "" if each.kind == "GroupAction" else _text(each, known), each.options.get
    match each.kind:
        case "DeclareLaunchArgument":
            _declare(value, option("default_value"), option("choices"), known)
        case "LogInfo":
            yield LaunchStep(delay_s, each.line, (value,))
        case "PushRosNamespace":
            known[NAMESPACE] = _namespace(value, known)
        case "GroupAction":
            yield from _steps(option("actions"), dict(known) if option("scoped", True) else known, delay_s)
        case "TimerAction":
            yield from _steps(option("actions"), known, delay_s + float(value))
        case "IncludeLaunchDescription":
            known |= {_text(name, known): _text(text, known) for name, text in option("launch_arguments") or ()}
            yield from _steps(_entities_of(value), known, delay_s)
        case "Node":
            words = (_text(option("package"), known), value, *_words_of(each.options, known))
            yield LaunchStep(delay_s, each.line, words)
        case _:
            raise ValueError(f"{each.kind} is no action")


def _declare(name: str, default: Any, choices: Sequence[str] | None, known: dict[str, str]) -> None:
    if name not in known and default is None:
        raise ValueError(f'Required launch argument "{name}" was not provided.')
    value = known.setdefault(name, _text(default, known))
    if choices and value not in choices:
        raise ValueError(f'Argument "{name}" provided value "{value}" is not valid. Valid options are: {choices}')


def _text(value: Any, known: Mapping[str, str]) -> str:
    """Return the text of a value: a plain one, that of an entity, or a list of these, joined."""
    if isinstance(value, list | tuple):
        return "".join(_text(each, known) for each in value)
    if not isinstance(value, LaunchEntity):
        return str(value)
    inner = value.options[OPTIONS[value.kind].split()[0]]
    if value.kind == "PathJoinSubstitution":
        return os.path.join(*(_text(each, known) for each in inner))
    text = _text(inner, known)
    if value.kind == "FindPackageShare":
        return get_package_prefix(text)
    if value.kind != "LaunchConfiguration" or text in known:
        return known[text] if value.kind == "LaunchConfiguration" else text
    if value.options.get("default") is None:
        raise ValueError(f"launch configuration '{text}' does not exist")
    return _text(value.options["default"], known)


def _namespace(name: str, known: Mapping[str, str]) -> str:
    return name if name.startswith("/") else f"{known.get(NAMESPACE, '')}/{name}".rstrip("/")


def _words_of(node: Mapping[str, Any], known: Mapping[str, str]) -> Iterator[str]:
    """Yield the command line of a node."""
    yield from (_text(each, known) for each in node.get("arguments") or ())
    yield "--ros-args"
    if node.get("name"):
        yield from ("-r", f"__node:={_text(node['name'], known)}")
    if namespace := _namespace(_text(node.get("namespace") or "", known), known):
        yield from ("-r", f"__ns:={namespace}")
    for each in node.get("parameters") or ():
        if isinstance(each, Mapping):
            yield from (word for rule in _rules("", each, known) for word in ("-p", rule))
        else:
            yield from ("--params-file", _text(each, known))
    for before, after in node.get("remappings") or ():
        yield from ("-r", f"{_text(before, known)}:={_text(after, known)}")


def _rules(prefix: str, values: Mapping[Any, Any], known: Mapping[str, str]) -> Iterator[str]:
    """Yield "name:=value" of each parameter in a dict; the value is YAML."""
    for key, value in values.items():
        name, parts = prefix + _text(key, known), value if isinstance(value, list | tuple) else [value]
        if isinstance(value, Mapping):
            yield from _rules(f"{name}.", value, known)
            continue
        if any(isinstance(part, LaunchEntity) for part in parts):
            is_text = isinstance(value, LaunchEntity) and value.options.get("value_type") is str
            value = _text(value, known) if is_text else yaml.safe_load(_text(value, known))
        value = list(value) if isinstance(value, tuple) else value
        yield f"{name}:={yaml.safe_dump(value, default_flow_style=True)}"
