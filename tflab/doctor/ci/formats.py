"""Write reports in the formats of other programs: JUnit, SARIF 2.1.0, GitHub annotations, and a table of many bags.

In JUnit, a check that was made and found nothing passes, one that could not be made is skipped, and a finding fails
from the chosen severity on. In SARIF, the rules are the codes with their causes; a result has the bag as its file and
the edge as its logical location. All of these are English, except the table.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from hashlib import sha256
from types import MappingProxyType
from urllib.parse import quote
from xml.sax.saxutils import escape, quoteattr

from tflab import __version__

from ..findings import SEVERITIES, Finding, Report
from ..profile import lines_of_table
from ..report.sentences import certainty_of, describe, descriptions
from ..report.text import finding_text
from .filters import fingerprint

__all__ = ["annotations_from_reports", "junit_from_reports", "sarif_from_reports", "text_from_reports"]

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


LEVELS = {"error": "error", "warning": "warning", "info": "note"}
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def sarif_from_reports(reports: Sequence[Report], paths: Sequence[str]) -> str:
    """Return reports, and the files that they are about, as SARIF."""
    codes = sorted({finding.code for report in reports for finding in report.findings})
    driver = {"name": "tflab doctor", "version": __version__, "rules": [_rule(code) for code in codes]}
    results = [
        _result(finding, path, codes.index(finding.code))
        for report, path in zip(reports, paths, strict=True)
        for finding in report.findings
    ]
    run = {"tool": {"driver": driver}, "results": results, "columnKind": "unicodeCodePoints"}
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _rule(code: str) -> dict:
    return {
        "id": code,
        "shortDescription": {"text": code.replace("-", " ")},
        "fullDescription": {"text": descriptions()[code].cause.en},
        "properties": {"certainty": certainty_of(code)},
    }


def _result(finding: Finding, path: str, rule: int) -> dict:
    said = describe(finding)
    where = f"{finding.parent} -> {finding.child}" if finding.child else finding.topic
    uri = quote(path.replace("\\", "/"), safe="/:")
    place: dict[str, object] = {"physicalLocation": {"artifactLocation": {"uri": uri}, "region": {"startLine": 1}}}
    if where:
        place["logicalLocations"] = [{"fullyQualifiedName": where}]
    return {
        "ruleId": finding.code,
        "ruleIndex": rule,
        "level": LEVELS[finding.severity],
        "message": {"text": f"{said.title}. {said.evidence} {said.cause} Next: {said.command}"},
        "locations": [place],
        "partialFingerprints": {"finding/v1": sha256(fingerprint(finding).encode()).hexdigest()},
    }


WORDS = {"error": "error", "warning": "warning", "info": "notice"}


def annotations_from_reports(
    reports: Sequence[Report], paths: Sequence[str], refusals: Mapping[str, str] = MappingProxyType({})
) -> str:
    """Return one command for each finding, and for each bag that could not be read, a line each."""
    lines = [f"::error file={_encoded_property(bag)}::{_encoded(reason)}" for bag, reason in refusals.items()]
    for report, path in zip(reports, paths, strict=True):
        for finding in report.findings:
            said = describe(finding)
            text = _encoded(f"{said.evidence} {said.cause}\nNext: {said.command}")
            title = _encoded_property(said.title)
            lines.append(f"::{WORDS[finding.severity]} file={_encoded_property(path)},title={title}::{text}")
    return "\n".join(lines)


def _encoded(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _encoded_property(text: str) -> str:
    return _encoded(text).replace(":", "%3A").replace(",", "%2C")


def text_from_reports(names: Sequence[str], reports: Sequence[Report | str], language: str = "en") -> str:
    """Return a table of reports; a text in place of one says why there is none."""
    rows = [("bag", "errors", "warnings", "notes", "worst")]
    for name, report in zip(names, reports, strict=True):
        if isinstance(report, str):
            rows.append((name, "-", "-", "-", f"cannot be read: {report}"))
            continue
        counts = (str(len(report.of_severity(severity))) for severity in SEVERITIES)
        worst = describe(report.findings[0], language).title if report.findings else ""
        rows.append((name, *counts, worst))
    return "\n".join(lines_of_table(rows))
