"""Run `static_transform_publisher`: one transform, published once, latched.

    --x 0.2 --z 0.15 --frame-id base_link --child-frame-id laser_frame
                          |
    base_link --(0.2, 0, 0.15)--> laser_frame      on /tf_static, as long as the tool runs

The arguments are read as upstream's own parser reads them: any order, `--x=1`
unknown, the first fault ends it.  The quaternion is neither normalised nor
checked: whoever hears it refuses it.

upstream: tf2_ros/src/static_transform_broadcaster_program.cpp.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from tflab.core.quaternions import from_rpy
from tflab.ros.node import Node

from .cpp_numbers import stod
from .session import abort, log_as_root, spin, tool_node, unused_name

__all__ = ["USAGE", "Request", "UsageError", "main", "parse"]

USAGE = Path(__file__).with_suffix(".txt").read_text(encoding="utf-8").rstrip()
OLD_STYLE = "Old-style arguments are deprecated; see --help for new-style arguments"
TRANSLATION, QUATERNION, EULER = ("x", "y", "z"), ("qx", "qy", "qz", "qw"), ("roll", "pitch", "yaw")
NAMES = ("frame-id", "child-frame-id")


@dataclass(frozen=True, slots=True)
class Request:
    """What is to be published; with `help`, only the usage is."""

    translation: tuple[float, float, float] = (0.0, 0.0, 0.0)  # [m]
    rotation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)  # x, y, z, w
    frame_id: str = ""
    child_frame_id: str = ""
    help: bool = False


class UsageError(Exception):
    """The arguments are no good; the text is upstream's."""


def parse(arguments: Sequence[str], warn: Callable[[str], None] = lambda text: None) -> Request:
    """Return what the arguments ask for; `warn` hears that they are old-style.

    Raises:
        UsageError: with the first fault in upstream's order.
    """
    options, positional, wants_help = _scan(arguments)
    if wants_help:
        return Request(help=True)
    if options.keys() & set(EULER) and options.keys() & set(QUATERNION):
        raise UsageError("Cannot specify both quaternion and Euler rotations")
    if len(positional) in (8, 9):
        warn(OLD_STYLE)
        if options.keys() - set(EULER):
            raise UsageError("Cannot specify both new-style (flags) and old-style (arguments)")
        options = _old_style(positional)
    elif positional:
        raise UsageError("Extra unparsed arguments on command-line")
    request = _request(options)
    if not request.frame_id:
        raise UsageError("Frame id must not be empty")
    if not request.child_frame_id:
        raise UsageError("Child frame id must not be empty")
    return request


def _scan(arguments: Sequence[str]) -> tuple[dict[str, float | str], list[str], bool]:
    """Sort the arguments into options with a value, the rest, and whether help is wanted."""
    options: dict[str, float | str] = {}
    positional: list[str] = []
    wants_help = False
    remaining = iter(arguments)
    for argument in remaining:
        name = argument.removeprefix("--")
        if argument in ("--help", "-h"):
            wants_help = True
        elif not argument.startswith("--") or name not in (*TRANSLATION, *QUATERNION, *EULER, *NAMES):
            positional.append(argument)
        else:
            value = next(remaining, None)
            if value is None:
                raise UsageError(f"Not enough arguments for {argument}")
            options[name] = value if name in NAMES else _number(argument, value)
    return options, positional, wants_help


def _old_style(positional: list[str]) -> dict[str, float | str]:
    """Return the options that eight (yaw pitch roll) or nine (a quaternion) bare arguments stand for."""
    angles = ("yaw", "pitch", "roll") if len(positional) == 8 else QUATERNION
    numbers = (*TRANSLATION, *angles)
    options: dict[str, float | str] = {
        name: _number(name, text) for name, text in zip(numbers, positional, strict=False)
    }
    return options | dict(zip(NAMES, positional[-2:], strict=True))


def _number(name: str, text: str) -> float:
    try:
        return stod(text)[0]
    except ValueError:
        raise UsageError(f"Failed to parse {name} argument as float") from None


def _request(options: dict[str, float | str]) -> Request:
    request = Request(
        translation=tuple(options.get(name, 0.0) for name in TRANSLATION),
        rotation=tuple(options.get(name, float(name == "qw")) for name in QUATERNION),
        frame_id=options.get("frame-id", ""),
        child_frame_id=options.get("child-frame-id", ""),
    )
    if options.keys() & set(EULER):
        return replace(request, rotation=from_rpy(*(options.get(name, 0.0) for name in EULER)))
    return request


def announcement(request: Request) -> str:
    """Return what the tool logs once it publishes."""
    translation = ", ".join(f"'{value:f}'" for value in request.translation)
    rotation = ", ".join(f"'{value:f}'" for value in request.rotation)
    return (
        f"Spinning until stopped - publishing transform\ntranslation: ({translation})\nrotation: ({rotation})\n"
        f"from '{request.frame_id}' to '{request.child_frame_id}'"
    )


def main(arguments: Sequence[str]) -> int:
    """Publish until stopped; return the exit code."""
    try:
        request = parse(arguments, warn=lambda text: log_as_root("warning", text))
    except UsageError as fault:
        log_as_root("error", f"error parsing command line arguments: {fault}")
        print(USAGE)
        return 1
    if request.help:
        print(USAGE)
        return 0
    return _publish(request, arguments)


def _publish(request: Request, arguments: Sequence[str]) -> int:
    from tflab.ros.messages.geometry_msgs import Quaternion, TransformStamped, Vector3
    from tflab.ros.tf2.topics import StaticTransformBroadcaster

    with tool_node(unused_name("static_transform_publisher_", arguments)) as node:
        if request.frame_id == request.child_frame_id:
            same = f"cannot publish static transform from '{request.frame_id}' to '{request.child_frame_id}', exiting"
            node.get_logger().error(same)
            return abort("std::runtime_error", "child_frame_id cannot equal frame_id")
        _declare_parameters(node, request)
        message = TransformStamped(child_frame_id=request.child_frame_id)
        message.header.frame_id = request.frame_id
        message.header.stamp = node.get_clock().now().to_msg()
        message.transform.translation = Vector3(**dict(zip("xyz", request.translation, strict=True)))
        message.transform.rotation = Quaternion(**dict(zip("xyzw", request.rotation, strict=True)))
        StaticTransformBroadcaster(node).sendTransform(message)
        node.get_logger().info(announcement(request))
        spin(node)
    return 0


def _declare_parameters(node: Node, request: Request) -> None:
    """Show what is published as parameters, which cannot be changed."""
    from tflab.ros.messages.rcl_interfaces import ParameterDescriptor

    values = {
        **{f"translation.{axis}": value for axis, value in zip("xyz", request.translation, strict=True)},
        **{f"rotation.{axis}": value for axis, value in zip("xyzw", request.rotation, strict=True)},
        "frame_id": request.frame_id,
        "child_frame_id": request.child_frame_id,
    }
    for name, value in values.items():
        node.declare_parameter(name, value, ParameterDescriptor(read_only=True))
