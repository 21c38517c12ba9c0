"""Run `ros2 interface show`, `list`, `packages`, `package` and `proto`.

    ros2 interface show geometry_msgs/msg/TransformStamped
        std_msgs/Header header
        \tbuiltin_interfaces/Time stamp
        ...

The definitions of ROS's own packages are kept without their comments; those of a
package that was defined here show theirs, as the real one does.

upstream: ros2cli/ros2interface.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterator

from tflab.ros.messages import type_named
from tflab.ros.messages.base import (
    Message,
    is_action_class,
    is_message_class,
    is_service_class,
    message_in,
)
from tflab.ros.messages.definition import parse_definition
from tflab.ros.messages.packages import all_types
from tflab.ros.messages.text import message_to_yaml

from .discovery import add_verb, full_type_name

__all__ = ["add_verbs", "definition_lines"]

KINDS: dict[str, Callable[[object], bool]] = {
    "Messages": is_message_class,
    "Services": is_service_class,
    "Actions": is_action_class,
}


TYPE_HELP = "Show an interface definition (e.g. 'example_interfaces/msg/String')"


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 interface` to a parser."""
    verb = add_verb(verbs, "list", "List all interface types available", list_types, looks_around=False)
    _add_kinds(verb, "Print out only the {} types")
    what = "Output a list of available interface types within one package"
    verb = add_verb(verbs, "package", what, list_package, looks_around=False)
    verb.add_argument("package_name", help="Name of the ROS package (e.g. 'example_interfaces')")
    what = "Output a list of packages that provide interfaces"
    verb = add_verb(verbs, "packages", what, list_packages, looks_around=False)
    _add_kinds(verb, "Only list packages that generate {}s")
    verb = add_verb(verbs, "proto", "Output an interface prototype", print_prototype, looks_around=False)
    verb.add_argument("type", help=TYPE_HELP)
    verb.add_argument("--no-quotes", action="store_true", help="if true output has no outer quotes.")
    verb = add_verb(verbs, "show", "Output the interface definition", show, looks_around=False)
    verb.add_argument("type", help=TYPE_HELP)
    comments = verb.add_mutually_exclusive_group()
    comments.add_argument(
        "--all-comments", action="store_true",
        help="Show all comments, including for nested interface definitions",
    )  # fmt: skip
    comments.add_argument("--no-comments", action="store_true", help="Show no comments or whitespace")


def _add_kinds(verb: argparse.ArgumentParser, what: str) -> None:
    """Add an option for each kind of type; the blank in `what` is for its name."""
    for letter, kind, word in (("m", "msgs", "message"), ("s", "srvs", "service"), ("a", "actions", "action")):
        verb.add_argument(f"-{letter}", f"--only-{kind}", action="store_true", help=what.format(word))


def _kinds_wanted(options: argparse.Namespace) -> dict[str, Callable[[object], bool]]:
    """Return the kinds that were asked for; all if none was."""
    asked = (options.only_msgs, options.only_srvs, options.only_actions)
    return {kind: KINDS[kind] for kind, wanted in zip(KINDS, asked, strict=True) if wanted} or KINDS


def show(options: argparse.Namespace) -> str | None:
    """Print a definition, each message in it opened below its line."""
    try:
        found = _type(options.type)
    except LookupError as fault:
        return str(fault.args[0])
    for number, part in enumerate(_parts(found)):
        if number:
            print("---")
        for line in definition_lines(part, own_comments=not options.no_comments, all_comments=options.all_comments):
            print(line)
    return None


def definition_lines(
    cls: type[Message], own_comments: bool = True, all_comments: bool = False, depth: int = 0
) -> Iterator[str]:
    """Yield the lines of a message's definition, each followed by what is in it, one tab deeper."""
    package = cls.ROS_TYPE.split("/")[0]
    with_comments = all_comments or (own_comments and depth == 0)
    for line in cls.DEFINITION.splitlines():
        bare = re.sub(r"\s*(#.*)?$", "", line)
        if bare or with_comments:
            yield "\t" * depth + (line.rstrip() if with_comments else bare)
        for field in parse_definition(line, package)[0]:
            inner = message_in(field.slot_type)
            if inner is not None:
                yield from definition_lines(inner, own_comments, all_comments, depth + 1)


def list_types(options: argparse.Namespace) -> None:
    """Print every type, by kind."""
    for heading, is_kind in _kinds_wanted(options).items():
        print(f"{heading}:")
        for name, cls in all_types().items():
            if is_kind(cls):
                print(f"    {name}")


def list_packages(options: argparse.Namespace) -> None:
    """Print the packages that have types."""
    kinds = _kinds_wanted(options).values()
    names = [name for name, cls in all_types().items() if any(is_kind(cls) for is_kind in kinds)]
    for package in sorted({name.split("/")[0] for name in names}):
        print(package)


def list_package(options: argparse.Namespace) -> str | None:
    """Print the types of one package."""
    names = [name for name in all_types() if name.split("/")[0] == options.package_name]
    if not names:
        return f"Unknown package '{options.package_name}'"
    print("\n".join(names))
    return None


def print_prototype(options: argparse.Namespace) -> str | None:
    """Print a message of zeros as one would type it for `ros2 topic pub`; of a service its request."""
    try:
        first = _parts(_type(options.type))[0]
    except LookupError as fault:
        return str(fault.args[0])
    text = message_to_yaml(first())
    print(text if options.no_quotes else f'"{text}"')
    return None


def _type(name: str) -> type:
    """Return the class of a type that was named in full, or as 'geometry_msgs/Point'.

    Raises:
        LookupError: there is none of that name; with upstream's sentence, and what there is.
    """
    parts = full_type_name(name, "msg").split("/")
    if len(parts) != 3 or not all(parts):
        raise LookupError(f"Invalid name '{name}'. Expected three parts separated by '/'")
    there = all_types()
    try:
        return type_named("/".join(parts))
    except KeyError:
        beside = [each for each in there if each.split("/")[0] == parts[0]]
        if not beside:
            raise LookupError(f"Unknown package '{parts[0]}'") from None
        raise LookupError(
            f"Could not find the interface '{name}': the in-process ROS 2 has {', '.join(beside)}"
        ) from None


def _parts(cls: type) -> list[type[Message]]:
    """Return the messages that a type is made of: itself, request and response, or goal, result and feedback."""
    if is_service_class(cls):
        return [cls.Request, cls.Response]
    return [cls.Goal, cls.Result, cls.Feedback] if is_action_class(cls) else [cls]
