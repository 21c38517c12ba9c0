"""Ask an ungraded question before the exercises, so that a learner sees a reply to a wrong answer.

    lesson.ask_first((2.0, 0.5, 0.0))    the laser's numbers, with another label
    lesson.ask_first((2.2, 0.5, 0.15))   right

The answer is judged as `check` does it in an exercise.  Nothing is stored.
"""

from __future__ import annotations

from typing import Any

from ..text import Texts
from .answers.forms import Vector
from .assigned_task import AssignedTask
from .judge_answer import judge_answer, show_verdict
from .paths import read_workbook, workbook_root
from .reply_card import show_reply
from .tasks.case_types import Case, Feedback, TaskCases, Variant

__all__ = ["ask_first"]

TEXTS = Texts(__file__)
LASER_P_POST, BASE_P_LASER = (2.0, 0.5, 0.0), (0.2, 0.0, 0.15)
RIGHT = [round(seen + mount, 3) for seen, mount in zip(LASER_P_POST, BASE_P_LASER, strict=True)]
MISTAKES = {
    "same numbers": list(LASER_P_POST),
    "taken away": [round(seen - mount, 3) for seen, mount in zip(LASER_P_POST, BASE_P_LASER, strict=True)],
    "height forgotten": [RIGHT[0], RIGHT[1], LASER_P_POST[2]],
    "height alone": [LASER_P_POST[0], LASER_P_POST[1], RIGHT[2]],
    "only the mount": list(BASE_P_LASER),
}
QUESTION = TaskCases(
    kind="N",
    points=1,
    answer="base_p_post",
    is_function=False,
    title=TEXTS["name"],
    form=Vector(3, unit="m", frame="base_link", tolerance=0.003),
    hints=(),
    misconceptions=(),
    feedback={name: Feedback(TEXTS[name], "") for name in MISTAKES},
    variants=(Variant(None, (Case(None, RIGHT, MISTAKES),)),),
)


def ask_first(base_p_post: Any) -> None:
    """Say what is right or wrong about where the post is, counted from the robot's middle (x, y, z) [m]."""
    root = workbook_root()
    workbook = read_workbook(root)
    name = TEXTS["name"].say(workbook.language)
    if base_p_post is ...:
        show_reply(name, TEXTS["unanswered"].say(workbook.language))
        return
    assigned = AssignedTask(name, "", QUESTION, QUESTION.variants[0], root, workbook)
    verdict, outcomes = judge_answer(assigned, base_p_post)
    said = TEXTS["go_on"] if verdict.failure else TEXTS["done"]
    show_verdict(assigned, verdict, outcomes, [said.say(workbook.language)], draws=False)
