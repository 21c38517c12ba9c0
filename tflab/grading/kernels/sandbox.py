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
from tflab.text import Text
from tflab.workbook import paths

from . import landlock, seccomp

__all__ = ["LEVELS", "Sandbox"]

ONLY_FILES = (
    Text(
        en="Code in a submission can see which other processes run.",
        ko="제출된 코드가 다른 프로세스의 목록을 볼 수 있습니다.",
    ),
    Text(
        en="An answer that shares locks between processes (multiprocessing) fails: the memory for them is everybody's.",
        ko="프로세스 사이에 잠금을 공유하는 답(multiprocessing)은 실패합니다. "
        "잠금에 필요한 메모리를 모든 프로세스가 함께 쓰기 때문입니다.",
    ),
)
NETWORK = Text(
    en="Code in a submission can reach the network.",
    ko="제출된 코드가 네트워크에 접속할 수 있습니다.",
)
GAPS = {
    "namespaces": (),
    "bubblewrap": (
        Text(
            en="Every kernel starts from nothing, so grading takes several times as long.",
            ko="커널을 매번 처음부터 시작하므로 채점이 몇 배 오래 걸립니다.",
        ),
    ),
    "limits": (
        Text(
            en="Code in a submission can read and change files that the instructor can, the pack and the other "
            "submissions among them, so hidden answers are only advisory. Keep a copy of what was handed in.",
            ko="제출된 코드가 강사의 파일을 읽고 바꿀 수 있습니다. instructor 폴더와 다른 제출물도 마찬가지입니다. "
            "따라서 점수는 참고용일 뿐입니다. 제출물의 사본을 따로 보관하십시오.",
        ),
        Text(
            en="Code in a submission can end the grader; the run has to be started again then.",
            ko="제출된 코드가 채점 프로그램을 끝낼 수 있습니다. 그러면 채점을 다시 시작해야 합니다.",
        ),
    ),
}
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
        if self.level != "limits":
            return GAPS[self.level]
        gaps = ONLY_FILES if landlock.abi() >= landlock.CONFINES else GAPS["limits"]
        return gaps if seccomp.is_there() else (*gaps, NETWORK)

    def announce(self) -> Text:
        """Return one line for the report: which wall, and why no better one; `gaps` are the lines after it."""
        why = f" ({'; '.join(self.refused)})" if self.refused else ""
        return Text(f"Sandbox: {self.level}{why}.", f"격리 방식: {self.level}{why}.")

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
