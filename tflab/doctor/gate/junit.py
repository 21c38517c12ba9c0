"""The report as a test run: JUnit's XML, which every CI shows.

    <testsuite name="drive">  <testcase name="loops"/>  <testcase name="gap ..."><failure>...</failure></testcase>

A check that was made and found nothing passes; one that could not be made is
skipped; a finding fails from the chosen severity on.  Read `sarif.py` next.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from xml.sax.saxutils import escape, quoteattr

from ..findings import Finding, Report
from ..report.text import finding_text
from ..report.texts import sentences

__all__ = ["junit_from_reports"]

NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit_from_reports(reports: Sequence[Report], failing: Sequence[str]) -> str:
    """Return reports as JUnit XML; findings of the severities `failing` are failures."""
    suites = "\n".join(_suite(report, failing) for report in reports)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="tflab doctor">\n{suites}\n</testsuites>\n'


def _suite(report: Report, failing: Sequence[str]) -> str:
    cases = [f"    <testcase classname={_attribute(report.subject)} name={_attribute(n)}/>" for n in report.checks_made]
    for check in report.checks_not_made:
        name = f"classname={_attribute(report.subject)} name={_attribute(check.check)}"
        cases.append(f"    <testcase {name}><skipped message={_attribute('needs ' + check.needs)}/></testcase>")
    cases += [_case(report, finding, failing) for finding in report.findings]
    failures = sum(finding.severity in failing for finding in report.findings)
    counts = f'tests="{len(cases)}" failures="{failures}" errors="0" skipped="{len(report.checks_not_made)}"'
    return "\n".join([f"  <testsuite name={_attribute(report.subject)} {counts}>", *cases, "  </testsuite>"])


def _case(report: Report, finding: Finding, failing: Sequence[str]) -> str:
    title = sentences(finding).title
    text = escape(NO_XML.sub("?", finding_text(report, finding)))
    name = f"classname={_attribute(report.subject)} name={_attribute(f'{finding.code}: {title}')}"
    if finding.severity in failing:
        kind = f"type={_attribute(finding.severity)} message={_attribute(title)}"
        return f"    <testcase {name}><failure {kind}>{text}</failure></testcase>"
    return f"    <testcase {name}><system-out>{text}</system-out></testcase>"


def _attribute(text: str) -> str:
    return quoteattr(NO_XML.sub("?", text))
