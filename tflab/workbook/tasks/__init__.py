"""Tasks: what they ask, their known mistakes, and the cases that answers are tried on.

    task            a task: what it asks, and its known mistakes
    definition      read a task from its Python and its YAML file
    misconceptions  the fifteen of the course, behind the mistakes of many tasks
    draws           the seeded source of a task's numbers
    reference       the right answer, which the solution's own cell gives
    case_types      the cases of a task, as values
    generate_cases  compute the cases of a task for a seed
    pairs           search two mistakes that together give an answer
    catalog         a learner's tasks, computed on demand
    credit          which right results earn points, beyond guessing
    strip_solution  turn a solution into an exercise

What a task file imports is here.
"""

from ...text import Text
from ..answers.forms import (
    Angle,
    Choice,
    Command,
    DiscriminatingCheck,
    Message,
    Name,
    Number,
    Pair,
    Parts,
    Pose,
    Proof,
    Quaternion,
    Sequence,
    Set,
    Tree,
    Urdf,
    Vector,
)
from .definition import define_task
from .draws import Draws
from .task import PARTICIPATION, Task, WrongAnswer, WrongStep

__all__ = [
    "PARTICIPATION",
    "Angle",
    "Choice",
    "Command",
    "DiscriminatingCheck",
    "Draws",
    "Message",
    "Name",
    "Number",
    "Pair",
    "Parts",
    "Pose",
    "Proof",
    "Quaternion",
    "Sequence",
    "Set",
    "Task",
    "Text",
    "Tree",
    "Urdf",
    "Vector",
    "WrongAnswer",
    "WrongStep",
    "define_task",
]
