"""The report as GitHub shows it beside a commit: workflow commands.

    ::error file=drive,title=odom -> base_link has two owners::two sequences of values ...

What has a meaning in a command is percent-encoded.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from ..findings import Report
from ..report.sentences import describe

__all__ = ["annotations_from_reports"]

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
