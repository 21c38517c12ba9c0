"""Read plans of a course in two hours, a day or a term: minutes, cells, tasks, what to bring.

    solutions/teaching/plans.yaml
      talk:  title, about, minutes, parts
        - minutes: 22
          do:    {en: "08: the latency slider ...", ko: ...}
          cells: {08_buffer_and_measurement_time: [predict-error, slider]}     [] is the whole deck
          tasks: [E8.4]
          bring: {en: "dominoes", ko: "도미노"}

A plan is a page to print, and a deck of each chapter with only its cells.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from tflab.text import LANGUAGES, Text, Texts
from tflab.workbook.paths import workbook_data

from .layout import render, sheet
from .lecture import lectured_page
from .teaching import TEACHING, TeachingError, as_words, read_yaml, said_once

__all__ = ["CoursePlan", "PlanPart", "cells_of", "plan_lines", "plan_sheet", "read_plans"]

TEXTS = Texts(__file__)
FILE = "plans.yaml"
NEEDED, ALLOWED = {"minutes", "do"}, {"minutes", "do", "label", "cells", "tasks", "bring"}


class PlanPart(NamedTuple):
    """A part of a course: `cells` by chapter, none of a chapter for the whole deck."""

    minutes: int
    do: Text
    cells: Mapping[str, tuple[str, ...]]
    tasks: tuple[str, ...]
    label: Text | None
    bring: Text | None


class CoursePlan(NamedTuple):
    """A course of some length; `name` is what one types."""

    name: str
    title: Text
    about: Text
    minutes: int
    parts: tuple[PlanPart, ...]


def read_plans(data: Path | None = None) -> dict[str, CoursePlan]:
    """Return the plans by name.

    Raises:
        TeachingError: one names a cell that its page does not show, or its minutes do not add up.
    """
    data = data or workbook_data()
    found = read_yaml(data / TEACHING / FILE, f"{TEACHING.as_posix()}/{FILE}")
    faults = list(said_once(found, f"{FILE}:"))
    faults += [f"{FILE}: {name}: {fault}" for name, plan in found.items() for fault in _faults(plan, data)]
    if faults:
        raise TeachingError(*faults)
    return {name: _plan(name, plan) for name, plan in found.items()}


def cells_of(plan: CoursePlan) -> dict[str, tuple[str, ...]]:
    """Return what is shown of each chapter, in the order of the plan; nothing named is everything."""
    shown: dict[str, tuple[str, ...]] = {}
    for part in plan.parts:
        for stem, cells in part.cells.items():
            before = shown.get(stem)
            shown[stem] = cells if before is None else (*before, *cells) if before and cells else ()
    return shown


def plan_lines(plan: CoursePlan, language: str) -> list[str]:
    """Return a plan as it is printed into a terminal."""
    lines = [f"{plan.title.say(language)} · {TEXTS['length'].say(language, minutes=plan.minutes)}"]
    for when, part in zip(_times(plan), plan.parts, strict=True):
        named = f"{part.label.say(language)} ({when})" if part.label else when
        lines.append(f"{named:>12}  {part.do.say(language)}")
    return lines


def plan_sheet(plan: CoursePlan, language: str) -> str:
    """Return a plan as a page to print."""
    parts = list(zip(_times(plan), plan.parts, strict=True))
    return sheet(plan.title.say(language), language, render("plan.html", TEXTS, language, plan=plan, parts=parts))


def _times(plan: CoursePlan) -> list[str]:
    """Return from when to when each part goes; where parts have names of their own (a week), how long each is."""
    times, clock = [], 0
    for part in plan.parts:
        times.append(f"{part.minutes}" if part.label else f"{clock}–{clock + part.minutes}")
        clock += part.minutes
    return times


def _plan(name: str, plan: Mapping[str, Any]) -> CoursePlan:
    parts = []
    for part in plan["parts"]:
        cells = {stem: tuple(names) for stem, names in part.get("cells", {}).items()}
        said = (as_words(part[key]) if key in part else None for key in ("label", "bring"))
        parts.append(PlanPart(part["minutes"], as_words(part["do"]), cells, tuple(part.get("tasks", ())), *said))
    return CoursePlan(name, as_words(plan["title"]), as_words(plan["about"]), plan["minutes"], tuple(parts))


def _faults(plan: Mapping[str, Any], data: Path) -> Iterator[str]:
    lacks = sorted({"title", "about", "minutes", "parts"} - set(plan))
    if lacks:
        yield f"it lacks {', '.join(lacks)}"
        return
    total = sum(part.get("minutes", 0) for part in plan["parts"])
    if total != plan["minutes"]:
        yield f"its parts sum to {total} minutes, not to {plan['minutes']}"
    for number, part in enumerate(plan["parts"], start=1):
        wrong = [f"it lacks `{name}`" for name in sorted(NEEDED - set(part))]
        wrong += [f"`{name}` means nothing" for name in sorted(set(part) - ALLOWED)]
        for stem, cells in part.get("cells", {}).items():
            wrong += _unknown_cells(stem, cells, data)
        yield from (f"part {number}: {fault}" for fault in wrong)


def _unknown_cells(stem: str, cells: Sequence[str], data: Path) -> Iterator[str]:
    try:
        pages = [lectured_page(stem, language, data) for language in LANGUAGES]
    except FileNotFoundError:
        yield f"there is no page `{stem}`"
        return
    for cell in cells:
        if any(cell not in page.cells for page in pages):
            yield f"{stem} has no cell `{cell}`"
