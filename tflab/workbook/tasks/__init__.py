"""A task: its right answer, its wrong ones, and what is said of each.

    task        what a task is
    reference   its right answer comes from its solution; there is no other
    case        what a file of cases holds
    cases       what an answer is tried on
    evidence    what an answer shows, beyond luck: guess correction
    units       in which other unit it may be
    universal   mistakes that any answer can have
    names       what is wrong with a name: its slashes, or nothing was filled in
    losses      what was lost and cannot be put back
    trees       what is wrong with a tree
    shell_words where a command line goes wrong
    fields      which parts an answer has
    fitting     whether outcomes are just what a mistake gives
    certain     what is certain where none fits
    explanation what an explanation is
    confused    which word a function says for which
    common      what the calls that go wrong have in common
    arithmetic  what was computed of what was given
    givens      what was given, as it was
    habits      what habits of writing give: the first member, a loop that removes
    together    what is said of several parts at once
    edges       edges that were named by their parents
    orders      an order the other way round, or one place off
    members     parts of a dict, fields of a message, each by itself
    lists       members of a list, all together
    robots      links of a robot, each by itself
    refusals    errors that were swallowed
    beside      slips that show in different calls
    apart       slips that show in different words
    stops       errors in some calls, beside what is wrong in others
    changes     arguments that were changed
    explain     how a wrong answer came about: slips, alone and two together
    verdict     what became of an answer
    stumbles    what one of Python's own errors means
    mistake     what may be wrong with it, in two tables of words
    replies     what `check` says besides
    comparison  the wrong answer drawn beside the right one
    mutants     solutions spoilt on purpose, none of which may pass: mutation testing
    blank       a solution with its answers taken out

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
from .task import TAKING_PART, Slip, Task, Twin

__all__ = [
    "TAKING_PART",
    "Angle",
    "Choice",
    "Command",
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
