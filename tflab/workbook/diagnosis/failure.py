"""List the ways in which an answer can fail, and what `check` and a feedback page say of each.

    outcomes --judge_outcomes--> Verdict(failure=Failure.UNIT, ...)
                                     |-- REPLIES[...]              what `check` says to the one who wrote it
                                     '-- WITHOUT_THE_ANSWER[...]   what a feedback page says of a hidden case

The second table repeats nothing that a learner's code made, for that could carry
hidden inputs out.  Both cover every failure, coarse to fine; the field calls such a
list an error taxonomy.  A mistake of one task stands with the task.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from pathlib import Path

from ...text import Text, Texts

__all__ = ["REPLIES", "WITHOUT_THE_ANSWER", "Failure"]


class Failure(str, Enum):
    """How an answer failed, coarse to fine."""

    UNANSWERED = "unanswered"
    NOT_A_FUNCTION = "not a function"
    A_FUNCTION = "a function"
    ENDLESS = "endless"
    OUT_OF_MEMORY = "out of memory"
    INTERRUPTED = "interrupted"
    UNSTEADY = "unsteady"
    KNOWN = "known"  # one that the task knows, or two
    NOTHING_RETURNED = "nothing returned"
    SOMETIMES_NOTHING = "sometimes nothing"
    INPUT_CHANGED = "input changed"
    RAISES = "raises"
    OTHER_EXCEPTION = "other exception"
    NO_REFUSAL = "no refusal"
    TYPE = "type"
    SHAPE = "shape"
    OPTION = "option"
    MISSING_PARTS = "missing parts"
    MORE_PARTS = "more parts"
    NO_ROBOT = "no robot"
    FRAME = "frame"
    UNIT = "unit"
    CONSTANT = "constant"
    ECHO = "echo"
    PARTS = "parts"
    VALUE = "value"

    __str__ = str.__str__  # StrEnum does the same, from Python 3.11 on


REPLIES = Texts(__file__)
WITHOUT_THE_ANSWER: Mapping[str, Text] = Texts(str(Path(__file__).with_name("hidden_cases.yaml")))
