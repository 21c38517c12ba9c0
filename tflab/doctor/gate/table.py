"""Many recordings, a line each: which one does somebody have to open?

```
bag        errors  warnings  notes   worst
monday          0         0      1   map -> odom is stamped ahead, as localisers do
tuesday         1         2      0   The frames go round in a circle
wednesday       -         -      -   cannot be read: the file is cut short
```
"""

from __future__ import annotations

from collections.abc import Sequence

from ..findings import SEVERITIES, Report
from ..report.sentences import describe

__all__ = ["text_from_reports"]


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
    widths = [max(len(row[column]) for row in rows) for column in range(4)]
    lines = []
    for first, *counts, worst in rows:
        cells = [first.ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(counts, widths[1:], strict=True))]
        lines.append("  ".join([*cells, worst]).rstrip())
    return "\n".join(lines)
