"""When does one meet an idea again?  The oftener it went right, the later: boxes, each with a longer way back.

    box            1        2        3         4         5
    again after    1 task   4 tasks  12 tasks  36 tasks  108 tasks      in between, or
                   1 hour   1 day    3 days    1 week    3 weeks        whichever is over first

    right                                 one box up, if it was due
    right after a hint                    it stays where it is
    wrong, or its misconception shown     back to box 1

An idea is a misconception of the course, "M3", or a task that looks for none.  This
is *spaced repetition* with the boxes of Sebastian Leitner (So lernt man lernen, 1972);
SM-2 and its heirs fit a curve to each card, which fifteen ideas do not need.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

__all__ = [
    "AGAIN",
    "AHEAD",
    "DAY_S",
    "DUE",
    "GAPS",
    "HOUR_S",
    "LAST_BOX",
    "NEW",
    "Idea",
    "Pick",
    "Spacing",
    "after",
    "choose",
    "is_due",
]

HOUR_S, DAY_S = 3600, 86400
AGAIN, DUE, NEW, AHEAD = "again", "due", "new", "ahead"  # why a task is asked


class Spacing(NamedTuple):
    """How far apart two meetings are: tasks in between, or seconds."""

    tasks: int
    seconds: int


GAPS = (Spacing(1, HOUR_S), Spacing(4, DAY_S), Spacing(12, 3 * DAY_S), Spacing(36, 7 * DAY_S), Spacing(108, 21 * DAY_S))
LAST_BOX = len(GAPS)


@dataclass(frozen=True)
class Idea:
    """Where one idea stands.

    Attributes:
        box: from 1.
        shown: how often its misconception was shown.
        right: how often it went right since.
        number: of the question that asked for it last; 0 for none yet.
        asked_s: when that was [s since 1970].
    """

    box: int = 1
    shown: int = 0
    right: int = 0
    number: int = 0
    asked_s: int = 0

    @property
    def gap(self) -> Spacing:
        """Return how long it stays away."""
        return GAPS[self.box - 1]


class Pick(NamedTuple):
    """What is asked next: a task, the idea it is asked for, and why."""

    task: str
    idea: str
    why: str


def is_due(idea: Idea, number: int, now_s: int) -> bool:
    """Return whether an idea may come back with the question of this number."""
    return not idea.number or number - idea.number > idea.gap.tasks or now_s - idea.asked_s >= idea.gap.seconds


def after(
    ideas: Mapping[str, Idea],
    of_task: tuple[str, ...],
    choice: Pick,
    *,
    number: int,
    now_s: int,
    right: bool,
    hinted: bool = False,
    shown: frozenset[str] = frozenset(),
) -> dict[str, Idea]:
    """Return where all ideas stand after a question.

    Args:
        of_task: the ideas that the task looks for.
        right: whether the first answer was.
        hinted: whether a hint was read before it.
        shown: the misconceptions that any answer to it showed.
    """
    held = dict(ideas)
    for name in sorted({*of_task, *shown}):
        idea = held.get(name)
        due = idea is not None and is_due(idea, number, now_s)
        if name in shown:
            moved = replace(idea or Idea(), box=1, shown=(idea.shown if idea else 0) + 1, right=0)
        elif name == choice.idea or (due and right and not hinted):
            moved = _moved(idea, right=right, hinted=hinted, due=due)
        else:
            continue  # nothing was seen of it
        held[name] = replace(moved, number=number, asked_s=now_s)
    return held


def _moved(idea: Idea | None, *, right: bool, hinted: bool, due: bool) -> Idea:
    """Return an idea in the box to which an answer takes it."""
    if not right:
        return replace(idea or Idea(), box=1, right=0)
    if idea is None:
        return Idea(box=1 if hinted else 2, right=1)  # known before it was ever got wrong
    if hinted:
        return idea
    return replace(idea, box=min(idea.box + 1, LAST_BOX) if due else idea.box, right=idea.right + 1)


def choose(
    tasks: Mapping[str, tuple[str, ...]], ideas: Mapping[str, Idea], asked: Mapping[str, int], number: int, now_s: int
) -> Pick:
    """Return what is asked next: what is due, box 1 first; else what was never asked, or longest ago.

    Args:
        tasks: the ideas of each task, those that it looks for most first.
        asked: the number of the question with which each task was asked last.

    Raises:
        ValueError: there are no tasks.
    """
    if not tasks:
        raise ValueError("there are no tasks to choose from")
    last = max(asked, key=asked.__getitem__, default="")
    other = [name for name in tasks if name != last] or list(tasks)
    dice = np.random.default_rng(number)  # what comes is no secret, and the same for the same way there
    rank = dict(zip(other, dice.permutation(len(other)).tolist(), strict=True))
    due = [name for name, idea in ideas.items() if is_due(idea, number, now_s)]
    for name in sorted(due, key=lambda name: (ideas[name].box, -ideas[name].shown, ideas[name].number, name)):
        with_it = [task for task in other if name in tasks[task]]
        if with_it:
            task = min(with_it, key=lambda task: (asked.get(task, 0), tasks[task].index(name), rank[task]))
            return Pick(task, name, AGAIN if ideas[name].shown else DUE)
    task = min(other, key=lambda task: (asked.get(task, 0), rank[task]))
    name = min(tasks[task], key=lambda name: ideas[name].number if name in ideas else 0)
    return Pick(task, name, AHEAD if name in ideas else NEW)
