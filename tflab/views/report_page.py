"""Write an HTML report as one file that loads and runs nothing from elsewhere.

It follows the reader's light or dark theme and can be printed. A Content-Security-Policy in the
page forbids loading and scripts, whatever was written into it.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment


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
    printable = "".join(letter if letter.isprintable() else "\ufffd" for letter in title)
    return render(__file__, title=printable, language=language, body="\n".join(body), style=style) + "\n"
