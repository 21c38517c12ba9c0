"""Blind answers: they compute rightly from the wrong thing, and must not pass the cases of a task.

    classify(buffer, target, source, stamp)    -->    target frozen: always that of the first call
    known(letters, ends, join_s, now_s)        -->    letters without the first
    read_monitor(report, static_frames)        -->    late = report, word 9

One that passes shows a case that is missing; one that is right stands with the task as `equivalent`.
"""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Iterator, Sequence
from inspect import signature
from itertools import combinations
from statistics import median_high, median_low
from typing import Any

from tflab.workbook.answers.values import Plain, is_raised, outcome_of
from tflab.workbook.tasks.case_types import Case
from tflab.workbook.tasks.task import Task

__all__ = ["answers_by_place", "blind_survivors"]

SHORTER = {"first alone": slice(1), "last alone": slice(-1, None), "without the first": slice(1, None),
           "without the last": slice(-1), "reversed": slice(None, None, -1)}  # fmt: skip
CUT = {"first word": r"(\w+)/[\w/]+", "last word": r"[\w/]*/(\w+)"}  # of robot1/odom
OF_LISTS = {"smallest": min, "largest": max, "median": median_low, "higher median": median_high, "count": len,
            "sorted": sorted}  # fmt: skip
Change = Callable[[list[Plain]], Plain]


def blind_survivors(task: Task, right: Callable, cases: Sequence[Case]) -> list[str]:
    """Return the names of the blind functions, made from the right one, that pass every case."""
    names, passed = list(signature(right).parameters), []
    for name, change in _changes(names, [case.args for case in cases]):
        frozen = [whole.removesuffix(" frozen") for whole in passed if whole.endswith(" frozen")]
        is_said = any(name.startswith((f"{whole}.", f"{whole} frozen")) for whole in frozen)
        outcomes = (outcome_of(right, change(copy.deepcopy(case.args))) for case in cases)
        if not is_said and all(map(task.form.same, outcomes, (case.expected for case in cases))):
            passed.append(name)
    calls = [({"dict": dict(zip(names, case.args, strict=True))}, case.expected) for case in cases]
    return passed + answers_by_place(task, calls)


def _changes(names: list[str], every: list[list[Plain]]) -> Iterator[tuple[str, Change]]:
    """Yield the name of each change of the arguments, and what makes it."""
    for path in (path for number in range(len(names)) for path in _fields(every, (number,))):
        name = ".".join(map(str, (names[path[0]], *path[1:])))
        values = [held[key] for args in every for held, key in _places(args, path)]
        yield f"{name} frozen", _put(path, lambda _, value=values[0]: copy.deepcopy(value))
        yield f"{name} frozen at the last", _put(path, lambda _, value=values[-1]: copy.deepcopy(value))
        for how, part in SHORTER.items() if isinstance(values[0], list) else ():
            yield f"{name} {how}", _put(path, lambda value, part=part: value[part])
    for one, other in combinations(range(len(names)), 2):
        order = [{one: other, other: one}.get(number, number) for number in range(len(names))]
        yield f"{names[one]} and {names[other]} exchanged", lambda args, order=order: [args[n] for n in order]
    if any(isinstance(value, str) for args in every for name, value in _by_place("", args) if "keys" not in name):
        for how, pattern in CUT.items():
            yield f"{how} of each name", lambda args, pattern=pattern: _cut(args, pattern)


def _members(plain: Plain) -> list[tuple[Any, Any, Any]]:
    """Return the fields of a value: the name of each, what holds it, and where; "*" for any member of a list."""
    if isinstance(plain, list):
        return [("*", plain, number) for number in range(len(plain))]
    kind = next(iter(plain), "") if isinstance(plain, dict) else ""
    held = plain[kind][1] if kind == "message" else plain[kind] if kind in ("tuple", "dict") else {}
    return [(key, held, key) for key in (held if isinstance(held, dict) else range(len(held)))]


def _places(args: list[Plain], path: tuple) -> list[tuple[Any, Any]]:
    """Return every place of a field: what holds it, and where."""
    held = [(args, path[0])]
    for step in path[1:]:
        held = [(owner, key) for place, at in held for name, owner, key in _members(place[at]) if name == step]
    return held


def _fields(every: list[list[Plain]], path: tuple) -> Iterator[tuple]:
    """Yield a path and those of the fields below it that each call has."""
    yield path
    names = [{name for name, *_ in _members(held[at])} for args in every for held, at in _places(args, path)]
    if {"*"} in names or all(each == names[0] for each in names):
        for name in sorted(set().union(*names), key=str):
            yield from _fields(every, (*path, name))


def _put(path: tuple, change: Callable[[Plain], Plain]) -> Change:
    """Return what changes a field of the arguments, wherever it stands."""

    def changed(args: list[Plain]) -> list[Plain]:
        for held, key in _places(args, path):
            held[key] = change(held[key])
        return args

    return changed


def _cut(plain: Plain, pattern: str) -> Plain:
    """Return a value with each of its texts and keys cut."""
    if isinstance(plain, str):
        return re.sub(pattern, r"\1", plain)
    for _, held, key in _members(plain):
        held[key] = _cut(held[key], pattern)
    if isinstance(plain, dict) and "dict" in plain:
        return {"dict": {_cut(key, pattern): value for key, value in plain["dict"].items()}}
    return plain


def answers_by_place(task: Task, calls: Sequence[tuple[Plain, Plain]]) -> list[str]:
    """Return what is right in every call by its place alone: of what was given, or as in the first call."""
    rights = [right for _, right in calls]
    if any(map(is_raised, rights)):
        return []
    survivors, found = [], [dict(_by_place("", given)) for given, _ in calls]
    for part in rights[0]["dict"] if isinstance(rights[0], dict) and "dict" in rights[0] else [""]:
        for each in found:
            each["the first answer"] = rights[0]["dict"][part] if part else rights[0]
        for name in found[0]:
            values = [each.get(name) for each in found]
            answers = [{"dict": r["dict"] | {part: v}} if part else v for v, r in zip(values, rights, strict=True)]
            survivors += [f"{part} = {name}"] if all(map(task.form.same, answers, rights)) else []
    return survivors


def _by_place(name: str, plain: Plain) -> Iterator[tuple[str, Plain]]:
    """Yield what stands at each place of a value: its fields, members by order and by size, words of a text."""
    yield name, plain
    members = [(key, held[key]) for _, held, key in _members(plain)]
    if isinstance(plain, str) and "\n" in plain:
        words = re.findall(r"[\w/.+-]+", plain)
        for number in range(-len(words), len(words)):
            is_number = re.fullmatch(r"-?\d+(\.\d+)?(e[+-]\d+)?", words[number])
            yield f"{name}, word {number}", float(words[number]) if is_number else words[number]
    elif isinstance(plain, list) and plain:
        for number in (0, 1, -2, -1):
            yield from _by_place(f"{name}[{number}]", plain[number % len(plain)])
        if len(set(map(type, plain))) == 1 and not isinstance(plain[0], list | dict):
            yield from ((f"{name}, {how}", of(plain)) for how, of in OF_LISTS.items())
    elif members:
        for key, member in members:
            yield from _by_place(f"{name}.{key}", member)
        for how, row in (("keys", [key for key, _ in members]), ("values", [value for _, value in members])):
            yield from _by_place(f"{name}, {how}", row) if len(members) > 1 else ()
