"""The report as static analysis gives it: SARIF 2.1.0, which GitHub's code scanning and editors read.

```
rules     each code once, with its cause
results   each finding, with the bag as its file and the edge as its logical place
```
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from hashlib import sha256
from urllib.parse import quote

from tflab import __version__

from ..findings import Finding, Report
from ..report.sentences import certainty_of, describe, descriptions
from .filters import fingerprint

__all__ = ["sarif_from_reports"]

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
    place: dict[str, object] = {
        "physicalLocation": {
            "artifactLocation": {"uri": quote(path.replace("\\", "/"), safe="/:")},
            "region": {"startLine": 1},
        }
    }
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
