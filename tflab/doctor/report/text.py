"""How does a report read in a terminal, and to a program?

```
drive: 1 error, 1 warning

ERROR    odom -> base_link has two owners                      12.3 s to 40.0 s
         two sequences of values, 0.300 m apart ...
         Why   Two nodes publish the same transform ...
         Sure  likely; to settle it: stop one of the two ...
         Next  ros2 topic info /tf --verbose
```
"""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import wrap

from tflab.core import NSEC_PER_SEC

from ..findings import SEVERITIES, Finding, Report
from .certainty import certainty_of, what_settles
from .faults import faults_of_code
from .sentences import Sentences
from .texts import TEXTS, sentences

__all__ = ["data_from_report", "effects_text", "finding_text", "headline", "moments_text", "text_from_report"]

WIDTH = 100
MOST_EFFECTS = 4  # that are told by name
SURE = {"likely": "likely", "open": "cannot be told from a recording alone"}
INDENT = " " * 9


def text_from_report(report: Report, texts: Mapping[str, Sentences] = TEXTS) -> str:
    """Return a report for a terminal."""
    lines = [headline(report), ""]
    for finding in report.findings:
        lines += [*_finding_lines(report, finding, texts), ""]
    lines.append(f"{len(report.checks_made)} checks made{_looked_at(report)}.")
    for needs in dict.fromkeys(check.needs for check in report.checks_not_made):
        names = [check.check for check in report.checks_not_made if check.needs == needs]
        listed = f": {', '.join(names)}" if report.checks_made else ""
        lines += wrap(f"{len(names)} not made, for want of {needs}{listed}.", WIDTH)
    if report.seen and not report.findings:
        lines.append("With --edges: the rate, the delays and the owners of each edge.")
    return "\n".join(lines)


def _looked_at(report: Report) -> str:
    """Return what the checks were made on, as the end of a sentence."""
    if report.seen is None:
        return ""
    seen = report.seen
    return (
        f": {seen.frames} frames, {seen.transforms} transforms and {seen.messages} other stamped messages"
        f" in {seen.duration_s:.1f} s"
    )


def data_from_report(report: Report, texts: Mapping[str, Sentences] = TEXTS) -> dict:
    """Return a report as plain data, for JSON."""
    return {
        "version": 1,
        "subject": report.subject,
        "begin_ns": report.begin_ns,
        "findings": [_data_from_finding(finding, texts) for finding in report.findings],
        "checks_made": list(report.checks_made),
        "checks_not_made": [check._asdict() for check in report.checks_not_made],
        "seen": report.seen._asdict() if report.seen else None,
    }


def _data_from_finding(finding: Finding, texts: Mapping[str, Sentences]) -> dict:
    return {
        "code": finding.code,
        "faults": [str(fault) for fault in faults_of_code(finding.code)],
        "severity": finding.severity,
        "certainty": certainty_of(finding.code),
        "settled_by": what_settles(finding.code),
        "namespace": finding.namespace,
        "parent": finding.parent,
        "child": finding.child,
        "topic": finding.topic,
        "begin_ns": finding.begin_ns,
        "end_ns": finding.end_ns,
        "facts": finding.facts,
        **sentences(finding, texts)._asdict(),
        "effects": [
            {"code": effect.code, "parent": effect.parent, "child": effect.child, "topic": effect.topic}
            for effect in finding.effects
        ],
    }


def headline(report: Report) -> str:
    """Return the outcome in one line."""
    counts = [(severity, len(report.of_severity(severity))) for severity in SEVERITIES]
    if not report.findings:
        return f"{report.subject}: nothing is wrong" if report.checks_made else f"{report.subject}: nothing to check"
    names = {"error": "error", "warning": "warning", "info": "note"}
    said = [f"{n} {names[severity]}{'s' if n > 1 else ''}" for severity, n in counts if n]
    return f"{report.subject}: {', '.join(said)}"


def moments_text(report: Report, finding: Finding) -> str:
    """Return from when to when, in seconds from the beginning; "" if always."""
    if not finding.begin_ns:
        return ""
    begin_s = (finding.begin_ns - report.begin_ns) / NSEC_PER_SEC
    end_s = (max(finding.end_ns, finding.begin_ns) - report.begin_ns) / NSEC_PER_SEC
    return f"{begin_s:.2f} s" if end_s - begin_s < 0.005 else f"{begin_s:.2f} s to {end_s:.2f} s"


def finding_text(report: Report, finding: Finding, texts: Mapping[str, Sentences] = TEXTS) -> str:
    """Return one finding for a terminal."""
    return "\n".join(_finding_lines(report, finding, texts))


def _finding_lines(report: Report, finding: Finding, texts: Mapping[str, Sentences]) -> list[str]:
    said = sentences(finding, texts)
    when = moments_text(report, finding)
    title = said.title + (f"   [{when}]" if when else "")
    lines = wrap(title, WIDTH, initial_indent=f"{finding.severity.upper():<9}", subsequent_indent=INDENT)
    lines += _indented(said.evidence, "")
    lines += _indented(said.cause, "Why   ")
    if finding.effects:
        lines += _indented(effects_text(finding, texts), "Also  ")
    if certainty_of(finding.code) != "certain":
        lines += _indented(f"{SURE[certainty_of(finding.code)]}; to settle it: {what_settles(finding.code)}", "Sure  ")
    if said.command:
        lines += [f"{INDENT}Next  {said.command}"]
    return lines


def effects_text(finding: Finding, texts: Mapping[str, Sentences] = TEXTS) -> str:
    """Return what follows from a finding, in a line."""
    titles = list(dict.fromkeys(sentences(effect, texts).title for effect in finding.effects))
    more = f"; and {len(titles) - MOST_EFFECTS} more" if len(titles) > MOST_EFFECTS else ""
    return f"which explains: {'; '.join(titles[:MOST_EFFECTS])}{more}"


def _indented(text: str, label: str) -> list[str]:
    rest = INDENT + " " * len(label)
    return wrap(text, WIDTH, initial_indent=INDENT + label, subsequent_indent=rest, break_on_hyphens=False)
