"""Compile four modules of the engine, beside their sources: `make fast`; and say where the project lives.

A wheel holds them if it is built with TFLAB_COMPILED=1 in the environment; every
other build is pure Python.  See tflab/core/builds.py.

What is built with TFLAB_ADDRESS=https://… names that address: in its project URLs,
and in the README that a package index shows, for its picture and its links.  Without
it, nothing points anywhere; the repository itself knows no address.  TFLAB_REF is the
tag to link to (main), TFLAB_BOOK the address of the book, if it has one.
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
from hatchling.metadata.plugin.interface import MetadataHookInterface

ROOT = Path(__file__).parent
COMPILERS = ["mypy>=1.18", "setuptools>=70", "numpy>=1.26"]


def compiled() -> list[Path]:
    """Compile the modules in place; return the files that were made."""
    from mypyc.build import mypycify
    from setuptools import Distribution

    modules = re.search(r"COMPILED_MODULES = (\(.*?\))", (ROOT / "tflab/core/builds.py").read_text(encoding="utf-8"))
    assert modules is not None
    sources = [f"tflab/core/{name}.py" for name in re.findall(r"\w+", modules[1])]
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


class CompiledModules(BuildHookInterface):  # type: ignore[type-arg]
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


def indexed(readme: str, address: str, ref: str = "main") -> str:
    """Return the README as a package index can show it: whole addresses, or no picture and no link at all."""
    picture, link = r"!\[([^\]]*)\]\(([^)]+)\)", r"\[([^\]]*)\]\((?!https:)([^)]+)\)"
    if not address:
        without = re.sub(rf"^{picture}\n\n(?:\*[^*\n].*\*\n\n)?", "", readme, flags=re.MULTILINE)
        return re.sub(link, r"\1", without)
    cloned = re.sub(r"git clone ADDRESS tflab .*", f"git clone {address} tflab", readme)
    pictured = re.sub(picture, rf"![\1]({address}/raw/{ref}/\2)", cloned)
    return re.sub(link, rf"[\1]({address}/blob/{ref}/\2)", pictured)


def urls(address: str, ref: str = "main", book: str = "") -> dict[str, str]:
    """Return the project's addresses, by what an index calls them."""
    there = {"Documentation": book, "Source": address}
    if address:
        there |= {"Issues": f"{address}/issues", "Changelog": f"{address}/blob/{ref}/CHANGELOG.md"}
    return {name: one for name, one in there.items() if one}


class Address(MetadataHookInterface):
    """Hatchling's hook: the README for an index, and where the project lives, if the environment says it."""

    PLUGIN_NAME = "custom"

    def update(self, metadata: dict[str, Any]) -> None:
        address, ref = os.environ.get("TFLAB_ADDRESS", "").rstrip("/"), os.environ.get("TFLAB_REF", "main")
        readme = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": indexed(readme, address, ref)}
        metadata["urls"] = urls(address, ref, os.environ.get("TFLAB_BOOK", ""))


if __name__ == "__main__":
    print(*compiled(), sep="\n", file=sys.stderr)
