"""A task: its right answer, its wrong ones, what it is tried on, and how it is tested itself.

    task      what a task is
    reference its right answer comes from its solution; there is no other
    case      what a file of cases holds
    cases     what an answer is tried on
    evidence  what an answer shows, beyond luck: guess correction
    spots     where in a piece of Python something else can stand
    mutants   solutions spoilt on purpose, none of which may pass: mutation testing
    blank     a solution with its answers taken out

What a task file imports is here.  Start with `task.py`; each page names the next.
"""

from ..answers.forms import (
    Angle,
    Choice,
    Command,
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
    Telling,
    Tree,
    Urdf,
    Vector,
)
from ..words import Words
from .draws import Draws
from .task import TAKING_PART, Slip, Task, Twin

__all__ = [
    "TAKING_PART",
    "Angle",
    "Choice",
    "Command",
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
    "Slip",
    "Task",
    "Telling",
    "Tree",
    "Twin",
    "Urdf",
    "Vector",
    "Words",
]
