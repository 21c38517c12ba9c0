"""Small pages to build: sources as an author writes them, in a workbook of their own."""

from __future__ import annotations

import re
from pathlib import Path

import yaml

from tflab.workbook.pages.source import Page, read_page

TITLE = (
    '# %% [markdown] lang="en" name="title"\n# # A page\n\n# %% [markdown] lang="ko" name="title"\n# # 한 쪽\n\n'
    '# %% name="load"\n# %load_ext tflab\n\n'
)


def text(name: str, en: str, ko: str, options: str = "") -> str:
    """Return a pair of texts as a source has it."""
    return "".join(
        f'# %% [markdown] lang="{lang}" name="{name}"{options}\n' + "".join(f"# {line}\n" for line in said.splitlines())
        for lang, said in (("en", en), ("ko", ko))
    )


def code(name: str, source: str, options: str = "") -> str:
    """Return a code cell as a source has it."""
    return f'# %% name="{name}"{options}\n{source}\n\n'


def written(root: Path, *parts: str, stem: str = "03_x", folder: str = "notebooks") -> Path:
    """Write a page's source below `root`."""
    path = root / folder / "src" / f"{stem}.py"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("".join(parts), encoding="utf-8")
    return path


def page(root: Path, *parts: str, **where: str) -> Page:
    """Write a page's source below `root`, and read it."""
    return read_page(written(root, *parts, **where))


TASKS = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))["tasks"]

LOAD = code("load-checks", "from tflab.workbook import check, hint, task")
HALF = (
    text("e3-1", "## E3.1 · Half (2 points)", "## E3.1 · 절반 (2점)")
    + code("e3-1-given", 'e3_1 = task("E3.1")')
    + code("e3-1-answer", "# BEGIN SOLUTION\nhalf = e3_1.length / 2  # [m]\n# END SOLUTION", ' tags=["answer"]')
    + code("e3-1-check", 'check("E3.1", half)', ' tags=["check"]')
)
THIRD = (
    text("e3-2", "## E3.2 · Third (3 points)", "## E3.2 · 삼분의 일 (3점)")
    + code(
        "e3-2-answer",
        "def third(x_m):\n    # BEGIN SOLUTION\n    return x_m / 3\n    # END SOLUTION",
        ' tags=["answer"]',
    )
    + code("e3-2-check", 'check("E3.2", third)', ' tags=["check"]')
)


def write_tasks(folder: Path, text: str) -> Path:
    """Write a chapter's tasks, each file below a line `# -- e3_1.py`; return the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    _, *parts = re.split(r"^# -- (\S+)\n", text, flags=re.MULTILINE)
    for name, part in zip(parts[::2], parts[1::2], strict=True):
        (folder / name).write_text(part, encoding="utf-8")
    return folder


def exercise(root: Path, *parts: str, tasks: str = TASKS) -> Path:
    """Write a solution's source and its tasks below `root`; a good one if no parts are given."""
    write_tasks(root / "solutions" / "tasks" / "03_x", tasks)
    return written(root, *(parts or (TITLE, LOAD, HALF, THIRD)), folder="solutions")
