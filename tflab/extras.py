"""Name the extra of tflab that installs a missing library.

`pip install tflab` installs NumPy and PyYAML.  Everything else comes with an extra:
`pip install "tflab[lab]"`.  This module must load without any of them.
"""

from __future__ import annotations

from importlib.util import find_spec

__all__ = ["hint", "require"]

# The smallest extra that installs each library, as pyproject.toml lists them.
EXTRA_OF = {
    "matplotlib": "views", "PIL": "views", "ipywidgets": "views", "anywidget": "views", "meshcat": "views",
    "ipykernel": "lab", "IPython": "lab", "jupyter_client": "lab", "jupyter_server": "lab", "jupyterlab": "lab",
    "latex2mathml": "lab", "nbclient": "lab", "nbconvert": "lab", "nbformat": "lab",
    "jinja2": "bags", "rosbags": "bags", "tqdm": "bags",
    "joblib": "grade", "nbval": "grade", "pytest": "grade",
    "pdoc": "site",
}  # fmt: skip


def hint(module: str) -> str | None:
    """Return how to install the library that a module belongs to, or None if no extra contains it."""
    library = module.partition(".")[0]
    extra = EXTRA_OF.get(library)
    return extra and f'This needs {library}. Install it with: pip install "tflab[{extra}]"'


def require(*libraries: str) -> None:
    """Raise a ModuleNotFoundError that names the extra, unless all these libraries are installed."""
    for library in libraries:
        if find_spec(library) is None:
            raise ModuleNotFoundError(hint(library), name=library)
