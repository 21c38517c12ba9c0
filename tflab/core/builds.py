"""Choose between the pure and the compiled build of four modules.

    poses.py  segments.py  cache.py  routes.py          the sources
    poses.so  segments.so  cache.so  routes.so          added by `make fast`, or by a wheel for your platform

The compiler for typed Python (mypyc) makes the second row. Both builds give the same
numbers; compiled, one lookup takes a third of the time. Python prefers the compiled
modules. `TFLAB_COMPILED=0` in the environment selects the sources, for a debugger.

`tflab.core.BUILD` is the build that runs.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

__all__ = ["BUILD", "COMPILED_MODULES"]

COMPILED_MODULES = ("poses", "segments", "cache", "routes")  # each imports only from those before it, and from others
HERE = Path(__file__).parent


def _is_compiled() -> bool:
    suffixes = tuple(EXTENSION_SUFFIXES)
    return all(any((HERE / (name + suffix)).exists() for suffix in suffixes) for name in COMPILED_MODULES)


def _load_sources() -> None:
    """Import the modules from their sources before any other import of them."""
    for name in COMPILED_MODULES:
        full_name = f"{__package__}.{name}"
        spec = spec_from_file_location(full_name, HERE / f"{name}.py")
        assert spec is not None and spec.loader is not None
        sys.modules[full_name] = module = module_from_spec(spec)
        spec.loader.exec_module(module)
        setattr(sys.modules[__package__], name, module)


BUILD = "pure"
if _is_compiled():
    if os.environ.get("TFLAB_COMPILED") == "0":
        _load_sources()
    else:
        BUILD = "compiled"
