"""Find packages for ament_index_python: the folder of a package stands for its installed share folder, too."""

from __future__ import annotations

from pathlib import Path

from .workspace import find_package

__all__ = ["PackageNotFoundError", "get_package_prefix", "get_package_share_path"]


class PackageNotFoundError(KeyError):
    """The workspace has no such package."""


def get_package_prefix(package_name: str, print_warning: bool = True) -> str:
    """Return the folder of a package."""
    package = find_package(package_name)
    if package is None:
        raise PackageNotFoundError(f"package '{package_name}' not found, searching: ['{Path.cwd()}']")
    return str(package.folder)


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return the folder of a package."""
    return Path(get_package_prefix(package_name))
