"""Which build runs?  The same four pages, as they stand or compiled to machine code.

    poses.py  segments.py  cache.py  routes.py          read these
    poses.so  segments.so  cache.so  routes.so          `make fast`, or a wheel for your platform, adds these

A compiler for typed Python (mypyc) makes the second row of the first.  They answer
alike to the last digit; one lookup takes a third of the time.  Python prefers what
is compiled, a debugger what can be stepped through: `TFLAB_COMPILED=0` in the
environment takes the pages as they stand.

`tflab.core.BUILD` says which one runs.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

__all__ = ["BUILD", "COMPILED_PAGES"]

COMPILED_PAGES = ("poses", "segments", "cache", "routes")  # each imports only from those before it, and from others
HERE = Path(__file__).parent


def _is_compiled() -> bool:
    suffixes = tuple(EXTENSION_SUFFIXES)
    return all(any((HERE / (page + suffix)).exists() for suffix in suffixes) for page in COMPILED_PAGES)


def _load_as_they_stand() -> None:
    """Import the pages from their sources, before anybody else imports them."""
    for page in COMPILED_PAGES:
        name = f"{__package__}.{page}"
        spec = spec_from_file_location(name, HERE / f"{page}.py")
        assert spec is not None and spec.loader is not None
        sys.modules[name] = module = module_from_spec(spec)
        spec.loader.exec_module(module)
        setattr(sys.modules[__package__], page, module)


BUILD = "pure"
if _is_compiled():
    if os.environ.get("TFLAB_COMPILED") == "0":
        _load_as_they_stand()
    else:
        BUILD = "compiled"
