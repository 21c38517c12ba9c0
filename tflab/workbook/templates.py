"""Fill the Jinja template beside a module.

    render(__file__, title="Gallery", figures=figures)     `gallery.jinja` beside `gallery.py`

Values are escaped, except for those that are `Markup`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

__all__ = ["render"]


def render(module_file: str, template: str = "", /, **values: Any) -> str:
    """Return a template with its values filled in.

    Args:
        module_file: the module's `__file__`.
        template: its file's name, if that is not the module's with the ending `.jinja`.
    """
    from jinja2 import Environment, FileSystemLoader, StrictUndefined  # comes with nbconvert

    path = Path(module_file)
    environment = Environment(
        loader=FileSystemLoader(path.parent),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template(template or f"{path.stem}.jinja").render(**values)
