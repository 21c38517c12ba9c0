"""What did the doctor find?  Findings, each with its evidence, in a report.

    Finding   code       what is wrong: "zero-quaternion"
              severity   error | warning | info
              where      the edge, the topic, from when to when
              facts      the numbers that show it
    Report    findings, the checks that were made, those that could not be, and what was looked at

A finding holds no sentences: `report/` makes them of its code and facts, so that
another language needs another table and nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NamedTuple

__all__ = ["SEVERITIES", "Finding", "NotMade", "Report", "Seen", "Severity"]

Severity = Literal["error", "warning", "info"]
SEVERITIES: tuple[Severity, ...] = ("error", "warning", "info")


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong, or worth knowing.

    Attributes:
        code: which text tells it, a key of `report.texts.TEXTS`.
        parent, child: the edge it is about, "" if it is about more than one.
        topic: where it was seen, "" if that does not matter.
        begin_ns, end_ns: when it was seen, by the recorder's clock [ns]; 0 if always.
        facts: what fills the blanks of the text.
        effects: what else is seen because of it, and needs no mending of its own.
        siblings: other children of which the same is to be said: they come from one node, as a rule.
        namespace: of which robot, "" if its transforms are on /tf: "/robot1" for /robot1/tf.
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


class NotMade(NamedTuple):
    """A check that could not be made, and what it would need."""

    check: str
    needs: str


class Seen(NamedTuple):
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
    """

    subject: str
    begin_ns: int
    findings: tuple[Finding, ...]
    checks_made: tuple[str, ...]
    checks_not_made: tuple[NotMade, ...] = ()
    seen: Seen | None = None

    @property
    def has_errors(self) -> bool:
        """Whether anything is an error."""
        return any(finding.severity == "error" for finding in self.findings)

    def of_severity(self, *severities: Severity) -> tuple[Finding, ...]:
        """Return the findings of these severities, in order."""
        return tuple(finding for finding in self.findings if finding.severity in severities)
