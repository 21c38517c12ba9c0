"""What is a guide set in?  Pages to read on a screen and on paper, by day and by night, with nothing from elsewhere.

```
sheet("11 · Tools and RViz", "en", [...])     a whole page
markdown("`max`, not **avg**")                 HTML, as in the pages of the course
```
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from tflab.views.report_page import report_page

from ..reports.html import text

__all__ = ["STATIC", "grid", "inline", "markdown", "sheet"]

STATIC = Path(__file__).parent / "static"


def sheet(title: str, language: str, body: Iterable[str]) -> str:
    """Return a whole page; `body` is HTML already, `title` is not."""
    return report_page(title, language, body, (STATIC / "sheet.css").read_text(encoding="utf-8"))


def markdown(words: str) -> str:
    """Return Markdown as HTML; links into the workbook lead nowhere from here, so their words stay."""
    from nbconvert.filters import markdown2html

    html = str(markdown2html(words)).strip()
    html = re.sub(r'<a class="anchor-link".*?</a>', "", html)
    return re.sub(r'<a href="[^"]*\.ipynb[^"]*"[^>]*>(.*?)</a>', r"\1", html, flags=re.DOTALL)


def inline(words: str) -> str:
    """Return one paragraph of Markdown without the paragraph."""
    html = markdown(words)
    whole = re.fullmatch(r"<p>(.*)</p>", html, re.DOTALL)
    return whole[1] if whole and "<p>" not in whole[1] else html


def grid(heads: Sequence[str], rows: Iterable[Sequence[str]], *, kind: str = "", marked: Sequence[int] = ()) -> str:
    """Return a table; cells are HTML already; `kind` is its name for the style, `marked` the rows that stand out."""
    head = "".join(f"<th>{text(name)}</th>" for name in heads)
    head = f"<thead><tr>{head}</tr></thead>" if any(heads) else ""
    body = "".join(
        f"<tr{' class=right' if number in marked else ''}>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>"
        for number, row in enumerate(rows)
    )
    return f'<div class="wide {kind}"><table>{head}<tbody>{body}</tbody></table></div>'
