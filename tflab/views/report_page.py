"""Write an HTML report as one file that loads and runs nothing from elsewhere.

It follows the reader's light or dark theme and can be printed. A Content-Security-Policy in the
page forbids loading and scripts, whatever was written into it.
"""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment

SHELL = """
:root { color-scheme: light dark; --paper: #fdfdfb; --ink: #1f2328; --quiet: #5b6168; --line: #d5d8dc;
  --card: #f3f4f2; --code: #eff0ec; }
@media screen and (prefers-color-scheme: dark) { :root { --paper: #17191c; --ink: #e6e8ea; --quiet: #a3a9b0;
  --line: #3a3f45; --card: #212428; --code: #2a2e33; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); overflow-wrap: anywhere;
  font: 16px/1.55 system-ui, "Apple SD Gothic Neo", "Malgun Gothic", "Noto Sans KR", sans-serif; }
main { max-width: 60rem; margin: 0 auto; padding: 2.5rem 1.25rem 4rem; }
h1 { font-size: 1.65rem; margin: 0 0 .3rem; line-height: 1.25; } h2 { font-size: 1.2rem; margin: 2.3rem 0 .65rem; }
figure { margin: .8rem 0; overflow-x: auto; } figure img, figure svg { max-width: 100%; height: auto; }
details { color: var(--quiet); margin-top: .4rem; } summary { cursor: pointer; }
@media print { :root { color-scheme: light; } main { max-width: none; padding: 0; } details { display: none; } }
"""
POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def template_environment(*folders: Path, **options: Any) -> Environment:
    """Return a Jinja2 environment for the templates in some folders: values are escaped, a missing one is an error."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        loader=FileSystemLoader(folders),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        **options,
    )


def render(module_file: str, template: str = "", /, **values: Any) -> str:
    """Return the template beside a module with its values filled in; by default `gallery.jinja` beside `gallery.py`."""
    path = Path(module_file)
    return template_environment(path.parent).get_template(template or f"{path.stem}.jinja").render(**values)


def report_page(title: str, language: str, body: Iterable[str], style: str = "") -> str:
    """Return a whole page; `body` is HTML already, `title` is not; `style` comes behind what all reports share."""
    name = escape("".join(letter if letter.isprintable() else "\ufffd" for letter in title))
    return "\n".join(
        [
            "<!DOCTYPE html>",
            f'<html lang="{escape(language)}"><head><meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{name}</title><style>{SHELL}{style}</style></head><body><main>",
            *body,
            "</main></body></html>\n",
        ]
    )
