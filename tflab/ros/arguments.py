"""Parse `--ros-args`: remappings, parameters, log levels.

node.py --ros-args -r __node:=robot1 -r /tf:=/robot1/tf -p use_sim_time:=true --params-file p.yaml
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TextIO

from .exceptions import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError
from .logging import LoggingSeverity

__all__ = ["Arguments", "parse_arguments", "remove_ros_args"]

FAILED = "Failed to parse ROS arguments: Couldn't parse"


@dataclass(frozen=True, slots=True)
class Arguments:
    """What of a command line concerns ROS.

    Attributes:
        remaps: (node or "", from, to), in order.
        parameters: (node pattern, name, value), in order; the last one counts.
        log_levels: (logger or "", severity).
    """

    remaps: tuple[tuple[str, str, str], ...] = ()
    parameters: tuple[tuple[str, str, object], ...] = ()
    log_levels: tuple[tuple[str, LoggingSeverity], ...] = ()

    def remapped(self, node_name: str, name: str, expand=lambda name: name) -> str:
        """Return what a node's name, namespace or topic is called instead; the first rule that fits counts.

        `expand` completes the names of a rule as it does the node's own.
        """
        for node, before, after in self.remaps:
            if node in ("", node_name) and expand(before) == name:
                return expand(after)
        return name

    def parameters_of(self, full_name: str) -> dict[str, object]:
        """Return the values that the command line gives to the parameters of a node."""
        return {name: value for node, name, value in self.parameters if _concerns(node, full_name)}


@dataclass
class _Parsed:
    remaps: list = field(default_factory=list)
    parameters: list = field(default_factory=list)
    log_levels: list = field(default_factory=list)
    unknown: list = field(default_factory=list)


def parse_arguments(argv: Sequence[str]) -> Arguments:
    """Return what follows each `--ros-args`, up to `--` or the end.

    Raises:
        RCLInvalidROSArgsError, RCLError: something there is malformed.
        UnknownROSArgsError: something there is not known.
    """
    parsed, rest = _Parsed(), list(argv)
    "".join(rest).encode()  # what is not UTF-8 is a UnicodeEncodeError, as in rclpy
    while "--ros-args" in rest:
        rest = rest[rest.index("--ros-args") + 1 :]
        while rest and rest[0] not in ("--", "--ros-args"):
            rest = _parse_one(rest, parsed)
    if parsed.unknown:
        raise UnknownROSArgsError(repr(parsed.unknown))
    return Arguments(tuple(parsed.remaps), tuple(parsed.parameters), tuple(parsed.log_levels))


def remove_ros_args(args: Sequence[str]) -> list[str]:
    """Return a command line without what concerns ROS."""
    kept, inside = [], False
    for word in args:
        if word == "--ros-args":
            inside = True
        elif inside and word == "--":
            inside = False
        elif not inside:
            kept.append(word)
    return kept


def _parse_one(rest: list[str], parsed: _Parsed) -> list[str]:
    flag, value = rest[0], rest[1] if len(rest) > 1 else None
    if flag in ("--disable-rosout-logs", "--enable-rosout-logs", "--disable-stdout-logs", "--enable-stdout-logs"):
        return rest[1:]
    if flag not in ("-r", "--remap", "-p", "--param", "--params-file", "--log-level", "-e", "--enclave"):
        parsed.unknown.append(flag)
        return rest[1:]
    if value is None:
        raise RCLInvalidROSArgsError(f"{FAILED} trailing {flag} flag. No value found")
    if flag in ("-r", "--remap"):
        node, before, after = _rule(flag, value)
        parsed.remaps.append((node, before, after))
    elif flag in ("-p", "--param"):
        node, name, text = _rule(flag, value)
        parsed.parameters.append(
            (f"/**/{node}" if node else "/**", name, _yaml(text, f"parameter override rule: '{flag} {value}'"))
        )
    elif flag == "--params-file":
        with _opened(value) as file:
            parsed.parameters.extend(_parameters_in(_yaml(file.read(), f"parameter file: '{value}'"), value))
    elif flag == "--log-level":
        logger, _, level = value.rpartition(":=")
        if level.upper() not in LoggingSeverity.__members__:
            raise RCLError(f"failed to initialize rcl: Couldn't parse log level rule: '{flag} {value}'.")
        parsed.log_levels.append((logger, LoggingSeverity[level.upper()]))
    return rest[2:]


def _opened(path: str) -> TextIO:
    try:
        return open(path, encoding="utf-8")
    except OSError as error:
        raise RCLError(f"failed to initialize rcl: Error opening YAML file: {path}: {error.strerror}") from None


def _rule(flag: str, text: str) -> tuple[str, str, str]:
    """Return (node or "", left, right) of "node:left:=right"."""
    left, found, right = text.partition(":=")
    if not found or not left:
        raise RCLInvalidROSArgsError(f"{FAILED} '{flag} {text}': expected name:=value")
    node, _, name = left.rpartition(":")
    return node, name, right


def _yaml(text: str, what: str) -> object:
    import yaml  # only where a command line says something about parameters

    try:
        return yaml.safe_load(text)
    except yaml.YAMLError as error:
        reason = " ".join(str(error).split())
        raise RCLError(f"failed to initialize rcl: Couldn't parse {what}. Error: {reason}") from None


def _parameters_in(content: object, path: str) -> Iterable[tuple[str, str, object]]:
    """Yield (node pattern, name, value) of a parameter file."""
    if not isinstance(content, dict):
        raise RuntimeError(f"{path}: a parameter file is a mapping: node name, then ros__parameters, then names")

    def walk(prefix: str, mapping: dict) -> Iterable[tuple[str, str, object]]:
        for key, value in mapping.items():
            if key == "ros__parameters":
                yield from ((prefix or "/**", name, leaf) for name, leaf in _leaves("", value))
            elif isinstance(value, dict):
                yield from walk(f"{prefix}/{str(key).strip('/')}", value)
            else:
                raise RuntimeError(f"{path}: '{key}' has no ros__parameters")

    yield from walk("", content)


def _leaves(prefix: str, mapping: dict) -> Iterable[tuple[str, object]]:
    for key, value in mapping.items():
        if isinstance(value, dict):
            yield from _leaves(f"{prefix}{key}.", value)
        else:
            yield f"{prefix}{key}", value


def _concerns(pattern: str, full_name: str) -> bool:
    """Return whether a pattern such as /**, /ns/* or /ns/node means this node: * is one name, ** any number of them."""
    expression = re.sub(r"/\*\*?", lambda star: r"(/\w+)*" if star[0] == "/**" else r"/\w+", pattern)
    return re.fullmatch(expression, full_name) is not None
