r"""Leave out findings that somebody has accepted: `--ignore` and `--baseline`.

    --ignore unknown-frame                 whatever it is about
    --ignore unknown-frame:/diagnostics    on this topic
    --ignore "gap:map -> odom"             of this edge; * and ? stand for letters
    --baseline known.json                  all that were there when the file was written

With a baseline, only new findings fail. A finding is identified by code, edge and topic (its fingerprint), not by its
figures.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import replace
from fnmatch import fnmatchcase
from pathlib import Path

from ..findings import Finding, Report

__all__ = ["BaselineError", "baseline_from", "filter_findings", "fingerprint", "read_baseline"]


class BaselineError(ValueError):
    """A baseline cannot be used; the text is one line that says why."""


def fingerprint(finding: Finding) -> str:
    """Return by what a finding is known again."""
    words = (finding.code, finding.parent, finding.child, finding.topic)
    return "|".join((*words, finding.namespace) if finding.namespace else words)


def filter_findings(report: Report, patterns: Iterable[str] = (), baseline: Iterable[str] = ()) -> Report:
    """Return a report without the findings that are let pass; the effects of these are findings of their own again."""
    patterns, known = list(patterns), set(baseline)
    rest, kept, passed = list(report.findings), [], report.ignored
    while rest:
        finding = rest.pop(0)
        if fingerprint(finding) in known or _is_ignored(finding, patterns):
            passed += 1
            rest[:0] = [replace(e, namespace=finding.namespace, is_ros1=finding.is_ros1) for e in finding.effects]
        else:
            kept.append(finding)
    return replace(report, findings=tuple(kept), ignored=passed)


def baseline_from(reports: Iterable[Report]) -> str:
    """Return a baseline of everything that was found, as JSON."""
    known = sorted({
        fingerprint(replace(found, namespace=finding.namespace))
        for report in reports for finding in report.findings for found in (finding, *finding.effects)
    })  # fmt: skip
    return json.dumps({"version": 1, "known": known}, indent=2, ensure_ascii=False) + "\n"


def read_baseline(path: str | Path) -> tuple[str, ...]:
    """Return the fingerprints in a baseline.

    Raises:
        BaselineError: it is not there, or no baseline.
    """
    try:
        known = json.loads(Path(path).read_text(encoding="utf-8"))["known"]
    except OSError as error:
        raise BaselineError(f"{path}: cannot be read ({error.strerror})") from None
    except (ValueError, KeyError, TypeError, RecursionError):
        raise BaselineError(f"{path}: not a baseline, which --write-baseline writes") from None
    if not isinstance(known, list) or not all(isinstance(word, str) for word in known):
        raise BaselineError(f"{path}: not a baseline, which --write-baseline writes")
    return tuple(known)


def _is_ignored(finding: Finding, patterns: list[str]) -> bool:
    edge = f"{finding.parent} -> {finding.child}"
    places = (finding.topic, finding.namespace, finding.child, edge, *_frames_of(finding))
    for pattern in patterns:
        code, colon, where = pattern.partition(":")
        if fnmatchcase(finding.code, code) and (not colon or any(fnmatchcase(place, where) for place in places)):
            return True
    return False


def _frames_of(finding: Finding) -> tuple[str, ...]:
    """Return the topics and frames that a finding without an edge is about."""
    named = (finding.facts.get(key) for key in ("name", "topics"))
    return tuple(word for words in named if isinstance(words, str) for word in words.split(", "))
