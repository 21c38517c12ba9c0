"""What is said to a wrong answer?  A question to try it on, before there is an exercise; nothing of it is kept.

    lesson.ask_first((2.0, 0.5, 0.0))    the laser's numbers, with another label
    lesson.ask_first((2.2, 0.5, 0.15))   right

It is tried, judged and told as `check` does it in an exercise.
"""

from __future__ import annotations

from typing import Any

from ..text import Text, Texts
from .answers.forms import Vector
from .paths import read_workbook, workbook_root
from .reply import show_reply
from .tasks.case_types import Case, Feedback, TaskCases, Variant
from .trying import AssignedTask, say_verdict, tried_on

__all__ = ["ask_first"]

TEXTS = Texts(__file__)
LASER_P_POST, BASE_P_LASER = (2.0, 0.5, 0.0), (0.2, 0.0, 0.15)
RIGHT = [round(seen + mount, 3) for seen, mount in zip(LASER_P_POST, BASE_P_LASER, strict=True)]
MISTAKES = {
    "same numbers": (
        list(LASER_P_POST),
        Text(
            en="These are the laser's numbers with another label. A frame is not a name to be changed: "
            "count the way again, from the robot's middle.",
            ko="레이저의 숫자에 이름표만 바꾸어 달았습니다. 좌표계는 이름만 바꾼다고 바뀌지 않습니다. "
            "로봇의 중심에서 기둥까지 다시 재어 보세요.",
        ),
    ),
    "taken away": (
        [round(seen - mount, 3) for seen, mount in zip(LASER_P_POST, BASE_P_LASER, strict=True)],
        Text(
            en="You took the step away. The laser sits ahead of the middle: from the middle, is the post nearer or "
            "farther?",
            ko="레이저를 단 위치를 뺐습니다. 레이저는 중심보다 앞에 있습니다. "
            "중심에서 보면 기둥은 더 가까울까요, 더 멀까요?",
        ),
    ),
    "height forgotten": (
        [RIGHT[0], RIGHT[1], LASER_P_POST[2]],
        Text(
            en="Ahead is right, and the height is still the laser's. z is counted like x.",
            ko="앞쪽 거리는 맞고, 높이는 아직 레이저 기준입니다. z도 x와 똑같이 셉니다.",
        ),
    ),
    "height alone": (
        [LASER_P_POST[0], LASER_P_POST[1], RIGHT[2]],
        Text(
            en="The height is right. The laser also sits ahead of the middle: the way ahead is still the laser's.",
            ko="높이는 맞습니다. 레이저는 중심보다 앞에 있기도 합니다. 앞쪽 거리는 아직 레이저 기준입니다.",
        ),
    ),
    "only the mount": (
        list(BASE_P_LASER),
        Text(
            en="That is where the laser is. The post is farther: from there, go on to what the laser saw.",
            ko="레이저의 위치입니다. 기둥은 더 멉니다. 레이저가 본 것까지 더 가야 합니다.",
        ),
    ),
}
QUESTION = TaskCases(
    kind="N",
    points=0,
    answer="base_p_post",
    is_function=False,
    title=TEXTS["name"],
    form=Vector(3, unit="m", frame="base_link", tolerance=0.003),
    hints=(),
    misconceptions=(),
    feedback={name: Feedback(reply, "") for name, (_, reply) in MISTAKES.items()},
    variants=(Variant(None, (Case(None, RIGHT, {name: came for name, (came, _) in MISTAKES.items()}),)),),
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
    verdict, outcomes = tried_on(assigned, base_p_post)
    said = TEXTS["go_on"] if verdict.mistake else TEXTS["done"]
    say_verdict(assigned, verdict, outcomes, [said.say(workbook.language)], draws=False)
