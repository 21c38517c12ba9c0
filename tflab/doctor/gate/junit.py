"""The report as a test run: JUnit's XML, which every CI shows.

    <testsuite name="drive">  <testcase name="loops"/>  <testcase name="gap ..."><failure>...</failure></testcase>

A check that was made and found nothing passes; one that could not be made is
skipped; a finding fails from the chosen severity on.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from xml.sax.saxutils import escape, quoteattr

from ..findings import Finding, Report
from ..report.sentences import describe
from ..report.text import finding_text

__all__ = ["junit_from_reports"]

NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit_from_reports(
    reports: Sequence[Report], failing: Sequence[str], refusals: Mapping[str, str] = MappingProxyType({})
) -> str:
    """Return reports as JUnit XML; findings of the severities `failing` are failures.

    Args:
        refusals: bags that could not be read, or not to their end, and why: they are errors.
    """
    suites = "\n".join([_suite(report, failing) for report in reports] + [_refused(*bag) for bag in refusals.items()])
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<testsuites name="tflab doctor">\n{suites}\n</testsuites>\n'


def _suite(report: Report, failing: Sequence[str]) -> str:
    cases = [f"    <testcase classname={_attribute(report.subject)} name={_attribute(n)}/>" for n in report.checks_made]
    for check in report.checks_not_made:
        name = f"classname={_attribute(report.subject)} name={_attribute(check.check)}"
        cases.append(f"    <testcase {name}><skipped message={_attribute('needs ' + check.needs.en)}/></testcase>")
    cases += [_case(report, finding, failing) for finding in report.findings]
    failures = sum(finding.severity in failing for finding in report.findings)
    counts = f'tests="{len(cases)}" failures="{failures}" errors="0" skipped="{len(report.checks_not_made)}"'
    return "\n".join([f"  <testsuite name={_attribute(report.subject)} {counts}>", *cases, "  </testsuite>"])


def _refused(name: str, reason: str) -> str:
    case = f"<testcase classname={_attribute(name)} name={_attribute('reading')}>"
    error = f'<error type="unreadable" message={_attribute(reason)}/>'
    suite = f'<testsuite name={_attribute(name)} tests="1" failures="0" errors="1" skipped="0">'
    return f"  {suite}\n    {case}{error}</testcase>\n  </testsuite>"


def _case(report: Report, finding: Finding, failing: Sequence[str]) -> str:
    title = describe(finding).title
    text = escape(NO_XML.sub("?", finding_text(report, finding)))
    name = f"classname={_attribute(report.subject)} name={_attribute(f'{finding.code}: {title}')}"
    if finding.severity in failing:
        kind = f"type={_attribute(finding.severity)} message={_attribute(title)}"
        return f"    <testcase {name}><failure {kind}>{text}</failure></testcase>"
    return f"    <testcase {name}><system-out>{text}</system-out></testcase>"


def _attribute(text: str) -> str:
    return quoteattr(NO_XML.sub("?", text))
