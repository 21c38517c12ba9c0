"""Compile four pages of the engine, beside their sources: `make fast`.

A wheel holds them if it is built with TFLAB_COMPILED=1 in the environment; every
other build is pure Python.  See tflab/core/builds.py.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).parent
COMPILERS = ["mypy>=1.18", "setuptools>=70", "numpy>=1.26"]


def compiled() -> list[Path]:
    """Compile the pages in place; return the files that were made."""
    from mypyc.build import mypycify
    from setuptools import Distribution

    pages = re.search(r"COMPILED_PAGES = (\(.*?\))", (ROOT / "tflab/core/builds.py").read_text(encoding="utf-8"))
    assert pages is not None
    sources = [f"tflab/core/{page}.py" for page in re.findall(r"\w+", pages[1])]
    os.chdir(ROOT)
    extensions = mypycify(["--strict", "--follow-imports=silent", *sources], opt_level="3", group_name="tflab_core")
    command = Distribution({"name": "tflab", "ext_modules": extensions}).get_command_obj("build_ext")
    command.inplace = True
    with TemporaryDirectory() as scratch:
        command.build_temp = command.build_lib = scratch
        command.ensure_finalized()
        command.run()
    shutil.rmtree(ROOT / "build", ignore_errors=True)  # the compiler's C
    return [Path(command.get_ext_fullpath(extension.name)) for extension in extensions]


class CompiledPages(BuildHookInterface):  # type: ignore[type-arg]
    """Hatchling's hook: puts what is compiled into the wheel, and names the platform in its file name."""

    PLUGIN_NAME = "custom"

    def dependencies(self) -> list[str]:
        return COMPILERS if os.environ.get("TFLAB_COMPILED") == "1" else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if os.environ.get("TFLAB_COMPILED") != "1" or version == "editable":
            return
        build_data["pure_python"] = False
        build_data["infer_tag"] = True
        for file in compiled():
            inside = file.resolve().relative_to(ROOT).as_posix()
            build_data["force_include"][str(file)] = inside


if __name__ == "__main__":
    print(*compiled(), sep="\n", file=sys.stderr)
