"""Hold the result of an examination: findings with their facts, in a report.

A finding holds no sentences. `report/sentences.py` makes them of its code and its facts, in the reader's language.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from tflab.text import Text

from .evidence import LookupRow

__all__ = ["SEVERITIES", "Coverage", "Finding", "Report", "Severity", "SkippedCheck", "english", "first_of", "times_of"]

Severity = Literal["error", "warning", "info"]
SEVERITIES: tuple[Severity, ...] = ("error", "warning", "info")


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong, or worth knowing.

    Attributes:
        code: a key of `report/sentences.yaml`: "zero-quaternion".
        parent, child: the edge it is about, "" if it is about more than one.
        topic: where it was seen, "" if that does not matter.
        begin_ns, end_ns: when it was seen, by the recorder's clock [ns]; 0 if always.
        facts: what fills the blanks of the text: numbers, names, or a Text.
        effects: the findings that it explains; they need no fix of their own.
        siblings: other children of which the same is to be said: they come from one node, as a rule.
        namespace: of which robot, "" if its transforms are on /tf: "/robot1" for /robot1/tf.
        is_ros1: whether the robot runs ROS 1, whose commands are others.
    """

    code: str
    severity: Severity
    parent: str = ""
    child: str = ""
    topic: str = ""
    begin_ns: int = 0
    end_ns: int = 0
    facts: dict[str, object] = field(default_factory=dict)
    effects: tuple[Finding, ...] = ()
    siblings: tuple[str, ...] = ()
    namespace: str = ""
    is_ros1: bool = False


def english(facts: dict[str, object]) -> dict[str, object]:
    """Return facts as JSON and other machine-readable forms hold them: in English."""
    return {name: fact.en if isinstance(fact, Text) else fact for name, fact in facts.items()}


def first_of(names: Sequence[str], most: int, between: str = ", ") -> Text:
    """Return names in a row, the first of many and how many more there are."""
    shown, more = between.join(names[:most]), len(names) - most
    before = between if between.strip() != "," else " "
    return Text(f"{shown}{before}and {more} more", f"{shown} 외 {more}개") if more > 0 else Text(shown, shown)


def times_of(count: int, moments: str = "") -> Text:
    """Return how often something happened, and at which times [s] if it happened more than once."""
    if count == 1:
        return Text("once", "한 번")
    when = Text(f" (at {moments} s)", f"({moments} s)") if moments else Text("", "")
    return Text(f"{count} times{when.en}", f"{count}번{when.ko}")


class SkippedCheck(NamedTuple):
    """A check that could not be made, and what it would need."""

    check: str
    needs: Text


class Coverage(NamedTuple):
    """How much was looked at: frames, transforms, other messages with a stamp, and how long it took to record [s]."""

    frames: int
    transforms: int
    messages: int
    duration_s: float


@dataclass(frozen=True, slots=True)
class Report:
    """What the doctor found.

    Attributes:
        subject: what was looked at, for people.
        begin_ns: when it began, by the recorder's clock [ns]; times are told from here.
        findings: worst first, and then in the order of the checks.
        checks_made: names of the checks.
        checks_not_made: the others, and what each would need.
        seen: what was looked at; None of a buffer, which has forgotten.
        ignored: how many findings somebody has chosen to ignore.
        lookups: of every topic, frame and fixed frame.
    """

    subject: str
    begin_ns: int
    findings: tuple[Finding, ...]
    checks_made: tuple[str, ...]
    checks_not_made: tuple[SkippedCheck, ...] = ()
    seen: Coverage | None = None
    ignored: int = 0
    lookups: tuple[LookupRow, ...] = ()

    def of_severity(self, *severities: Severity) -> tuple[Finding, ...]:
        """Return the findings of these severities, in order."""
        return tuple(finding for finding in self.findings if finding.severity in severities)
