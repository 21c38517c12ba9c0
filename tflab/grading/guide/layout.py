"""Render guides and plans as self-contained HTML, for screen and print, light and dark.

sheet("11 · Tools and RViz", "en", body)       a whole page
markdown("`max`, not **avg**")                 HTML, as in the pages of the course
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from markupsafe import Markup

from tflab.text import Text
from tflab.views.report_page import report_page

from ..reports import html

__all__ = ["STATIC", "inline", "markdown", "render", "sheet"]

STATIC = Path(__file__).parent / "static"


def sheet(title: str, language: str, body: Markup) -> str:
    """Return a whole page."""
    return report_page(title, language, [body], (STATIC / "sheet.css").read_text(encoding="utf-8"))


def markdown(words: str) -> Markup:
    """Return Markdown as HTML; links into the workbook lead nowhere from here, so their words stay."""
    from nbconvert.filters import markdown2html

    plain = str(markdown2html(words)).strip()
    plain = re.sub(r'<a class="anchor-link".*?</a>', "", plain)
    return Markup(re.sub(r'<a href="[^"]*\.ipynb[^"]*"[^>]*>(.*?)</a>', r"\1", plain, flags=re.DOTALL))


def inline(words: str) -> Markup:
    """Return one paragraph of Markdown without the paragraph."""
    made = markdown(words)
    whole = re.fullmatch(r"<p>(.*)</p>", made, re.DOTALL)
    return Markup(whole[1]) if whole and "<p>" not in whole[1] else made


ENVIRONMENT = html.environment(Path(__file__).parent / "templates")
ENVIRONMENT.filters |= {"inline": inline, "markdown": markdown}


def render(template: str, texts: Mapping[str, Text], language: str, **values: Any) -> Markup:
    """Return a template of the guide as HTML."""
    return html.render(template, texts, language, ENVIRONMENT, **values)
