"""Render the templates of reports and guides as HTML pages.

    render("feedback.html", TEXTS, "ko", who="s101", ...)     a template of this package, as Markup
    page(title, "ko", body)                                   a whole page around it

Templates are Jinja2 files with autoescape on: whatever comes from a submission or a roster is
escaped, and letters that cannot be printed are replaced. `say("key", name=...)` in a template
is a text of the module that renders it.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from jinja2 import Environment
from markupsafe import Markup, escape

from tflab.text import Text
from tflab.views.picture import Picture
from tflab.views.report_page import report_page, template_environment
from tflab.workbook.phrases import points

__all__ = ["TEMPLATES", "environment", "page", "points", "prose", "render", "text"]

TEMPLATES = Path(__file__).parent / "templates"
STYLE = (TEMPLATES / "report.css").read_text(encoding="utf-8")


def text(words: Any) -> Markup:
    """Return words escaped, with letters that cannot be printed replaced; Markup stays as it is."""
    if hasattr(words, "__html__"):
        return Markup(words)
    return escape("".join(letter if letter.isprintable() or letter == "\n" else "\ufffd" for letter in str(words)))


def prose(words: str) -> Markup:
    """Return a text of ours, with `code` and *stress* in it, as HTML; a word it begins with has a capital."""
    if re.match(r"[a-z]+\s", words):
        words = words[0].upper() + words[1:]
    marked = re.sub(r"`([^`]+)`", r"<code>\1</code>", str(text(words)))
    return Markup(re.sub(r"(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])", r"<em>\1</em>", marked))


def png_address(picture: Picture) -> str:
    """Return a picture as the address of an image in a page."""
    return f"data:image/png;base64,{b64encode(picture.png()).decode()}"


def environment(*folders: Path) -> Environment:
    """Return an environment for templates in some folders, and for those of this package."""
    made = template_environment(*folders, TEMPLATES, finalize=text)
    made.filters |= {"prose": prose, "points": points, "png_address": png_address}
    return made


OF_REPORTS = environment()


def render(
    template: str, texts: Mapping[str, Text], language: str, environment: Environment = OF_REPORTS, **values: Any
) -> Markup:
    """Return a template as HTML; its `say` takes texts of `texts` in the language."""

    def say(key: str, **names: Any) -> str:
        return texts[key].say(language, **names)

    return Markup(environment.get_template(template).render(say=say, language=language, **values))


def page(title: str, language: str, body: Markup) -> str:
    """Return a whole page."""
    return report_page(title, language, [body], STYLE)
