"""Validate and expand the names of topics, nodes and namespaces.

    in node /robot/camera     points     ->  /robot/points
                              ~/points   ->  /robot/camera/points
                              /points    ->  /points

A bad name is answered with rclpy's text, which points at the character.
"""

from __future__ import annotations

import re

from .exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NameValidationException,
)

__all__ = [
    "expand_topic_name",
    "expanded",
    "full_node_name",
    "is_hidden",
    "validate_full_topic_name",
    "validate_namespace",
    "validate_node_name",
    "validate_topic_name",
]

LONGEST_NAME = 255


def validate_node_name(name: str) -> bool:
    """Return True for a good name of a node.

    Raises:
        InvalidNodeNameException: it is not.
    """
    fault = None
    if not name:
        fault = ("node name must not be empty", 0)
    elif found := re.search(r"\W", name, re.ASCII):
        fault = ("node name must not contain characters other than alphanumerics or '_'", found.start())
    elif name[0].isdigit():
        fault = ("node name must not start with a number", 0)
    elif len(name) > LONGEST_NAME:
        fault = (f"node name length should not exceed '{LONGEST_NAME}'", LONGEST_NAME - 1)
    if fault:
        raise InvalidNodeNameException(name, *fault)
    return True


def validate_namespace(namespace: str) -> bool:
    """Return True for a good, absolute namespace.

    Raises:
        InvalidNamespaceException: it is not.
    """
    fault = _fault_in_path(namespace, "namespace", "namespace must not be empty")
    if namespace != "/" and namespace.endswith("/"):
        fault = ("namespace must not end with a '/', unless only a '/'", len(namespace) - 1)
    if fault and namespace != "/":
        raise InvalidNamespaceException(namespace, *fault)
    return True


def validate_full_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True for a good, completed name of a topic or service.

    Raises:
        InvalidTopicNameException, InvalidServiceNameException: it is not.
    """
    fault = _fault_in_path(name, "topic name", "topic name must not be empty string")
    if fault is None and name.endswith("/"):
        fault = ("topic name must not end with a '/'", len(name) - 1)
    if fault:
        raise _exception(is_service)(name, *fault)
    return True


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True for a good name of a topic or service as one writes it, perhaps relative.

    Raises:
        InvalidTopicNameException, InvalidServiceNameException: it is not.
    """
    fault = None
    if not name:
        fault = ("topic name must not be empty string", 0)
    elif name.endswith("/"):
        fault = ("topic name must not end with a forward slash", len(name) - 1)
    elif found := re.search(r"[^\w/~{}]", name, re.ASCII):
        text = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
        fault = (text, found.start())
    elif found := re.search(r"(^|/)\d", name):
        fault = ("topic name token must not start with a number", found.end() - 1)
    elif found := re.search(r"(?<!^)~|^~(?!/|$)", name):
        fault = ("topic name has misplaced tilde '~', it must be the first character, followed by '/'", found.start())
    elif found := re.search(r"//", name):
        fault = ("topic name must not contain repeated '/'", found.start() + 1)
    if fault:
        raise _exception(is_service)(name, *fault)
    return True


def expand_topic_name(name: str, node_name: str, namespace: str) -> str:
    """Return the absolute name of a topic or service as a node means it.

    Raises:
        ValueError: the topic's, the node's or the namespace's name is malformed, or the namespace relative.
    """
    for what, check, given in (
        ("topic name", validate_topic_name, name),
        ("node name", validate_node_name, node_name),
        ("node namespace", validate_namespace, namespace),
    ):
        try:
            check(given)
        except NameValidationException as fault:
            raise ValueError(f"{what} is invalid: {fault.error_msg}:\n  '{given}'") from None
    return expanded(name, node_name, namespace)


def expanded(name: str, node_name: str, namespace: str) -> str:
    """Return what expand_topic_name does, of names that were found good before.

    Raises:
        ValueError: the name has a substitution that is not known.
    """
    name = name.replace("{node}", node_name).replace("{ns}", namespace).replace("{namespace}", namespace)
    if unknown := re.search(r"\{\w*\}", name):
        raise ValueError(f"topic name '{name}' is invalid: unknown substitution: {unknown[0]}")
    if name.startswith("~"):
        return full_node_name(node_name, namespace) + name[1:]
    if name.startswith("/"):
        return name
    return f"{namespace.rstrip('/')}/{name}"


def full_node_name(node_name: str, namespace: str) -> str:
    """Return "/ns/name", or "/name" in the root namespace."""
    return f"{namespace.rstrip('/')}/{node_name}"


def is_hidden(name: str) -> bool:
    """Return whether the command line tools leave a topic or service out of their lists."""
    return any(token.startswith("_") for token in name.split("/"))


def _exception(is_service: bool) -> type:
    return InvalidServiceNameException if is_service else InvalidTopicNameException


def _fault_in_path(name: str, what: str, text_if_empty: str) -> tuple[str, int] | None:
    if not name:
        return text_if_empty, 0
    if not name.startswith("/"):
        return f"{what} must be absolute, it must lead with a '/'", 0
    if found := re.search(r"[^\w/]", name, re.ASCII):
        return f"{what} must not contain characters other than alphanumerics, '_', or '/'", found.start()
    if found := re.search(r"//", name):
        return f"{what} must not contain repeated '/'", found.start() + 1
    if found := re.search(r"/\d", name):
        return f"{what} must not have a token that starts with a number", found.start() + 1
    return None
