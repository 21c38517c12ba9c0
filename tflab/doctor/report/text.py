"""Write a report for a terminal, in English or Korean, and as data for JSON, in English.

```
drive: 1 error, 1 warning

ERROR    odom -> base_link has two owners                      12.3 s to 40.0 s
         two sequences of values, 0.300 m apart ...
         Why   Two nodes publish the same transform ...
         Sure  likely. To be certain: stop one of the two ...
         Next  ros2 topic info /tf --verbose
```
"""

from __future__ import annotations

from textwrap import wrap
from unicodedata import east_asian_width

from tflab.core import NSEC_PER_SEC
from tflab.text import Texts

from ..evidence import LookupRow
from ..findings import SEVERITIES, Finding, Report, english, first_of
from ..lookups import NEVER, WAITS_S
from ..profile import lines_of_table
from .sentences import certainty_of, describe, evidence_needed, faults_of_code

__all__ = ["certainty_text", "data_from_report", "effects_text", "finding_text", "headline",
           "moments_text", "text_from_report", "waits_text"]  # fmt: skip

TEXTS = Texts(__file__)
WIDTHS = {"en": 100, "ko": 64}  # letters of a line; a Korean one is two columns wide
MOST_LOOKUPS = 20  # that are listed
MOST_EFFECTS = 4  # that are named
COUNTS = {"error": ("error", "errors"), "warning": ("warning", "warnings"), "info": ("note", "notes")}
LABELS = {"error": "severity_error", "warning": "severity_warning", "info": "severity_info"}
INDENT = " " * 9
PLACE = ("parent", "child", "topic", "begin_ns", "end_ns")  # of a finding, as it is in JSON


def text_from_report(report: Report, language: str = "en") -> str:
    """Return a report for a terminal."""
    lines = [f"{report.subject}: {headline(report, language)}", ""]
    for finding in report.findings:
        lines += [finding_text(report, finding, language), ""]
    lines += _lookup_lines(report, language)
    made = TEXTS["checks_made"].say(language, n=len(report.checks_made))
    if report.seen:
        seen = report.seen._asdict()
        made += TEXTS["looked_at"].say(language, **seen, seconds=f"{report.seen.duration_s:.1f}")
    lines.append(f"{made}.")
    if report.ignored:
        lines.append(TEXTS["let_pass"].say(language, n=report.ignored))
    for needs in dict.fromkeys(check.needs for check in report.checks_not_made):
        names = [check.check for check in report.checks_not_made if check.needs == needs]
        listed = f": {', '.join(names)}" if report.checks_made else ""
        text = TEXTS["not_made"].say(language, n=len(names), needs=needs.say(language), listed=listed)
        lines += wrap(text, WIDTHS[language])
    if report.seen and not report.findings:
        lines.append(TEXTS["with_edges"].say(language))
    return "\n".join(lines)


def data_from_report(report: Report) -> dict:
    """Return a report as plain data, for JSON."""
    return {
        "version": 1,
        "subject": report.subject,
        "begin_ns": report.begin_ns,
        "findings": [_data_from_finding(finding) for finding in report.findings],
        "checks_made": list(report.checks_made),
        "checks_not_made": [{"check": check.check, "needs": check.needs.en} for check in report.checks_not_made],
        "seen": report.seen._asdict() if report.seen else None,
        "let_pass": report.ignored,
        "lookups": [
            {**row._asdict(), "waits_s": WAITS_S, "wait_ns": row.wait_ns if row.wait_ns < NEVER else None}
            for row in report.lookups
        ],
    }


def _lookup_lines(report: Report, language: str) -> list[str]:
    """Return the table of the lookups that do not always work at once, the worst first, and how many others do."""
    late = [row for row in report.lookups if round(100.0 * row.shares[0]) < 100]
    late.sort(key=lambda row: row.shares[::-1])
    rows = [("", *(f"{wait_s:g} s" for wait_s in WAITS_S), "")]
    for row in late[:MOST_LOOKUPS]:
        shares = [f"{100.0 * share:.0f} %" for share in row.shares]
        rows.append((f"{row.topic} -> {row.fixed}", *shares, waits_text(row, language)))
    lines = [TEXTS["lookups"].say(language), *lines_of_table(rows)] if late else []
    if len(late) > MOST_LOOKUPS:
        lines.append(TEXTS["lookups_more"].say(language, n=len(late) - MOST_LOOKUPS))
    if len(report.lookups) > len(late):
        lines.append(TEXTS["lookups_fine"].say(language, n=len(report.lookups) - len(late)))
    return [*lines, ""] if lines else []


def waits_text(row: LookupRow, language: str) -> str:
    """Return the edge that is waited for, and the period of the topic."""
    period = f"{row.period_ns / NSEC_PER_SEC:.3f}"
    key = "waits_for" if row.child else "no_path" if not row.shares[-1] else "waits_for_nothing"
    return TEXTS[key].say(language, edge=f"{row.parent} -> {row.child}", period=period)


def _data_from_finding(finding: Finding) -> dict:
    return {
        **{name: getattr(finding, name) for name in ("code", "severity", "namespace", *PLACE)},
        "faults": [str(fault) for fault in faults_of_code(finding.code)],
        "certainty": certainty_of(finding.code),
        "settled_by": evidence_needed(finding.code),
        "facts": english(finding.facts),
        **describe(finding)._asdict(),
        "effects": [{name: getattr(e, name) for name in ("code", "severity", *PLACE[:3])} for e in finding.effects],
    }


def headline(report: Report, language: str = "en") -> str:
    """Return the outcome in one line, without the subject."""
    if not report.findings:
        return TEXTS["nothing_wrong" if report.checks_made else "nothing_to_check"].say(language)
    counts = [(COUNTS[severity], len(report.of_severity(severity))) for severity in SEVERITIES]
    return ", ".join(TEXTS[names[n > 1]].say(language, n=n) for names, n in counts if n)


def moments_text(report: Report, finding: Finding, language: str = "en") -> str:
    """Return from when to when, in seconds from the beginning; "" if always."""
    if not finding.begin_ns:
        return ""
    begin_s = (finding.begin_ns - report.begin_ns) / NSEC_PER_SEC
    end_s = (max(finding.end_ns, finding.begin_ns) - report.begin_ns) / NSEC_PER_SEC
    if end_s - begin_s < 0.005:
        return f"{begin_s:.2f} s"
    return TEXTS["from_to"].say(language, begin=f"{begin_s:.2f}", end=f"{end_s:.2f}")


def finding_text(report: Report, finding: Finding, language: str = "en") -> str:
    """Return one finding for a terminal."""
    said = describe(finding, language)
    when = moments_text(report, finding, language)
    severity = _padded(TEXTS[LABELS[finding.severity]].say(language), len(INDENT))
    title = said.title + (f"   [{when}]" if when else "")
    lines = wrap(title, WIDTHS[language], initial_indent=severity, subsequent_indent=INDENT)
    why, also, sure, next_ = (_padded(TEXTS[key].say(language), 6) for key in ("why", "also", "sure", "next"))
    lines += _indented(said.evidence, "", language)
    lines += _indented(said.cause, why, language)
    if finding.effects:
        lines += _indented(effects_text(finding, language), also, language)
    lines += _indented(certainty_text(finding, language), sure, language)  # nothing if it is certain
    if said.command:
        lines += [f"{INDENT}{next_}{said.command}"]
    return "\n".join(lines)


def effects_text(finding: Finding, language: str = "en") -> str:
    """Return what follows from a finding, in a line."""
    titles = list(dict.fromkeys(describe(effect, language).title for effect in finding.effects))
    return TEXTS["explains"].say(language, titles=first_of(titles, MOST_EFFECTS, "; ").say(language))


def certainty_text(finding: Finding, language: str = "en") -> str:
    """Return how certain a finding is and what would settle it; "" if it is certain."""
    certainty = certainty_of(finding.code)
    if certainty == "certain":
        return ""
    text = TEXTS["likely"] if certainty == "likely" else TEXTS["open"]
    return text.say(language, settled=evidence_needed(finding.code, language))


def _padded(label: str, columns: int) -> str:
    """Return a label with spaces up to a width; a Korean letter takes two columns."""
    return label + " " * (columns - sum(2 if east_asian_width(letter) in "WF" else 1 for letter in label))


def _indented(text: str, label: str, language: str) -> list[str]:
    rest = INDENT + " " * (6 if label else 0)
    return wrap(text, WIDTHS[language], initial_indent=INDENT + label, subsequent_indent=rest, break_on_hyphens=False)
