"""Describe the three kinds of sandbox, and what each does not protect from.

    namespaces    its own processes, files, network, users: nothing outside can be seen or signalled
    bubblewrap    the same by the program `bwrap`, which some machines allow more; slower
    limits        only time, memory and what it writes are bounded, and, by Landlock, if the machine has that,
                  which files it can read; without it, hidden answers are advisory

`choose_sandbox` tries them in this order.  What must not be seen (the pack, the other
submissions) goes into `hide`, although the first two walls show only what Python needs.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from pathlib import Path

import tflab
from tflab.text import Text, Texts
from tflab.workbook import paths

from . import landlock, seccomp

__all__ = ["LEVELS", "Sandbox"]

TEXTS = Texts(__file__)
# What each kind does not protect from, as keys of the YAML file; with Landlock, "limits" protects from more.
GAPS = {"namespaces": (), "bubblewrap": ("slow",), "limits": ("files_change", "grader_ends")}
WITH_LANDLOCK = ("processes_seen", "no_locks")
LEVELS = tuple(GAPS)
SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/nix/store", "/gnu/store")
OF_ETC = (
    "alternatives", "fonts", "ld.so.cache", "ld.so.conf", "ld.so.conf.d", "localtime", "matplotlibrc", "mime.types",
    "nsswitch.conf", "timezone",
)  # fmt: skip


@dataclass(frozen=True)
class Sandbox:
    """A kind of wall, and what has to stay behind it."""

    level: str = "namespaces"
    hide: tuple[str, ...] = ()
    refused: tuple[str, ...] = field(default=(), compare=False)  # better ones that this machine has not, and why

    def __post_init__(self) -> None:
        if self.level not in GAPS:
            raise ValueError(f"there is no sandbox {self.level!r}; there are {', '.join(LEVELS)}")

    @property
    def gaps(self) -> tuple[Text, ...]:
        """Return what this wall does not protect from, one sentence each; nothing for the best one."""
        gaps: tuple[str, ...] = GAPS[self.level]
        if self.level == "limits":
            gaps = WITH_LANDLOCK if landlock.abi() >= landlock.CONFINES else gaps
            gaps = gaps if seccomp.is_there() else (*gaps, "network")
        return tuple(TEXTS[gap] for gap in gaps)

    def announce(self) -> Text:
        """Return one line for the report: which wall, and why no better one; `gaps` are the lines after it."""
        why = f" ({'; '.join(self.refused)})" if self.refused else ""
        return TEXTS["announce"].filled(level=f"{self.level}{why}")

    def shown(self) -> tuple[str, ...]:
        """Return the folders and files of this machine that a kernel may read: the system and Python, no home."""
        paths = [
            *SYSTEM,
            *(f"/etc/{name}" for name in OF_ETC),
            sys.base_prefix,
            sys.prefix,
            Path(tflab.__file__).parent,
        ]
        paths += [path for path in sys.path if Path(path).name in ("site-packages", "dist-packages")]
        return without_nested_paths(Path(path) for path in paths)

    def hidden(self) -> tuple[str, ...]:
        """Return what is covered even where it lies in a folder that is shown."""
        books = {paths.workbook_data(), Path(tflab.__file__).parent / "_workbook"}  # TFLAB_WORKBOOK may name another
        secrets = [book / part for book in books for part in ("solutions", "exercises")] + [*map(Path, self.hide)]
        return tuple(sorted({str(path.resolve()) for path in secrets if path.exists()}))


def without_nested_paths(paths: object) -> tuple[str, ...]:
    """Return those of the paths that exist and lie in none of the others."""
    kept: list[Path] = []
    for path in sorted({Path(path) for path in paths if Path(path).exists()}):  # type: ignore[attr-defined]
        if not any(above in path.parents and not above.is_symlink() for above in kept):
            kept.append(path)
    return tuple(map(str, kept))
