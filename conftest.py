"""Leave out exhaustive tests that passed before, while nothing that they depend on has changed.

    @pytest.mark.proof(reads=["solutions/tasks/{stem}/*"])
    def test_each_pair_of_mistakes_gets_its_reply(stem, sample): ...

`pytest --all` runs such a test in full. If it passes, `tests/proofs.json` keeps the files
of which a function ran, and a digest of these files and of those that `reads` names.
Without `--all`, a test whose digest is unchanged is deselected; another one runs on a
sample: `sample(items, 20)` returns 20 of them, and all of them under `--all`. A test that is
named on the command line always runs. A test in a browser is such a test, too, and so is a
notebook under nbval.

The digest covers what a change can reach: the files of the functions that ran, of the constants
that these files import, data files beside them, and `constraints.txt`. Comments, docstrings and the
sentences of a YAML file (`en:`, `ko:`) are left out, unless a marker says `texts=True`. Code in a
sandbox or a browser cannot be traced, so `reads` has to name it. What stays unseen is found by
the nightly run of everything. All files of a test module are kept together, because its tests
share fixtures.
"""

from __future__ import annotations

import ast
import hashlib
import importlib.util
import json
import os
import random
import re
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import pytest

ROOT = Path(__file__).parent
STORE = ROOT / "tests" / "proofs.json"
ALWAYS = ("constraints.txt",)
CODE = ("tflab/", "tests/")  # what `ran` keeps; a task or a notebook belongs to one test, and `reads` names it
DATA = ("[!_]*.[!p]*", "static/**/*.*", "data/**/*.*")  # beside a module
TRACER = "tests/tracing/sitecustomize.py"
SENTENCE = re.compile(r" *(?:- )?(?=(?:en|ko):)")
EVERY_CELL = "every cell"
NO_TESTS = 5  # pytest's exit code

Member = TypeVar("Member")
Key = tuple[str, str, str]  # test module, test function, parameters

_spec = importlib.util.spec_from_file_location("tracing", ROOT / TRACER)
tracing = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(tracing)


# -- what a proof depends on ----------------------------------------------


def code_in(text: str) -> str:
    """Return Python without lines of comment, docstrings and blank lines."""
    lines = text.splitlines()
    for node in ast.walk(ast.parse(text)):
        match getattr(node, "body", None):
            case [ast.Expr(value=ast.Constant(value=str())) as docstring, *_]:
                for number in range(docstring.lineno - 1, docstring.end_lineno):
                    lines[number] = ""
    return "\n".join(line for line in lines if line.strip() and not line.lstrip().startswith("#"))


def data_in(text: str) -> str:
    """Return YAML without its sentences: the lines of `en:` and `ko:`, and those that go on below them."""
    kept, column = [], None
    for line in text.splitlines():
        if column is not None and (not line.strip() or len(line) - len(line.lstrip()) > column):
            continue
        begin = SENTENCE.match(line)
        column = begin.end() if begin else None
        if begin is None:
            kept.append(line)
    return "\n".join(kept)


WITHOUT_TEXTS = {".py": code_in, ".yaml": data_in}


@cache
def hash_of(name: str, texts: bool = False) -> str:
    path = ROOT / name
    if not path.is_file():
        return "missing"
    content = path.read_bytes()
    if path.suffix in WITHOUT_TEXTS and not texts:
        content = WITHOUT_TEXTS[path.suffix](content.decode()).encode()
    return hashlib.sha256(content).hexdigest()


def digest_of(names: Iterable[str], texts: bool = False) -> str:
    text = "\n".join(f"{name} {hash_of(name, texts)}" for name in sorted({*names, *ALWAYS}))
    return hashlib.sha256(text.encode()).hexdigest()[:12]


@cache
def files_matching(pattern: str) -> tuple[str, ...]:
    names = (path.relative_to(ROOT).as_posix() for path in ROOT.glob(pattern) if path.is_file())
    return tuple(sorted(name for name in names if "__pycache__" not in name))


def files_read_by(item: pytest.Item) -> set[str]:
    """Return the data files of a test: of a notebook itself, else those that its markers name."""
    if not is_python(item):
        return {key_of(item)[0]}
    parameters = item.callspec.params if hasattr(item, "callspec") else {}
    patterns = (pattern for marker in item.iter_markers("proof") for pattern in marker.kwargs.get("reads", ()))
    return {name for pattern in patterns for name in files_matching(pattern.format(**parameters))}


def digest_of_reads(item: pytest.Item) -> str:
    return digest_of(files_read_by(item), any(marker.kwargs.get("texts") for marker in item.iter_markers("proof")))


@cache
def module_file(name: str) -> str | None:
    """Return the file of a module of tflab or of the tests, or None."""
    path = name.replace(".", "/")
    return next((file for file in (f"{path}.py", f"{path}/__init__.py") if (ROOT / file).is_file()), None)


@cache
def values_imported_by(name: str) -> frozenset[str]:
    """Return the modules from which a module imports a value: that has an effect although no function runs."""
    package, found = name.split("/")[:-1], set()
    for node in ast.walk(ast.parse((ROOT / name).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, node.module] if node.module else base)
            file = module_file(module)
            if file and values_in(file) & {alias.name for alias in node.names}:
                found.add(file)
    return frozenset(found)


@cache
def values_in(name: str) -> frozenset[str]:
    """Return the names of a module's constants, and of its classes that hold nothing but fields."""
    names = set()
    for node in ast.parse((ROOT / name).read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ClassDef) and not any(isinstance(part, ast.FunctionDef) for part in node.body):
            names.add(node.name)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            names |= {
                part.id for part in ast.walk(node) if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store)
            }
    return frozenset(names)


def with_what_they_use(ran: Iterable[str]) -> list[str]:
    """Add the modules of imported values, and the data files beside a module."""
    found, waiting = set(), list(ran)
    while waiting:
        name = waiting.pop()
        if name.startswith(CODE) and name not in (*found, TRACER) and (ROOT / name).is_file():
            found.add(name)
            if name.endswith(".py"):  # a Jinja template runs, too, under its own name
                waiting += values_imported_by(name)
    folders = {name.rpartition("/")[0] for name in found if name.startswith("tflab/")}
    beside = {name for folder in folders for pattern in DATA for name in files_matching(f"{folder}/{pattern}")}
    return sorted(found | beside)


# -- the store ------------------------------------------------------------


@dataclass
class Proofs:
    """What is proved of a test module."""

    ran: list[str] = field(default_factory=list)  # the files on which each of its proofs depends
    digest: str = ""  # of these
    proved: dict[str, dict[str, str]] = field(default_factory=dict)  # function, parameters: digest of what it reads

    def is_current(self) -> bool:
        return self.digest == digest_of(self.ran)


def read_store() -> dict[str, Proofs]:
    """Return what is proved of each test module."""
    stored = json.loads(STORE.read_text(encoding="utf-8")) if STORE.is_file() else {}
    return {
        module: Proofs(
            [f"{folder}/{name}" for folder, names in held["ran"].items() for name in names.split()],
            held["digest"],
            held["proved"],
        )
        for module, held in stored.items()
    }


def write_store(store: dict[str, Proofs]) -> None:
    plain = {}
    for module, proofs in store.items():
        folders = defaultdict(list)
        for name in sorted(proofs.ran):
            folder, _, file = name.rpartition("/")
            folders[folder].append(file)
        ran = {folder: " ".join(files) for folder, files in folders.items()}
        plain[module] = {"ran": ran, "digest": proofs.digest, "proved": proofs.proved}
    STORE.write_text(json.dumps(plain, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def is_python(item: pytest.Item) -> bool:
    return isinstance(item, pytest.Function)


def is_proof(item: pytest.Item) -> bool:
    return not is_python(item) or any(item.iter_markers("proof")) or any(item.iter_markers("browser"))


def key_of(item: pytest.Item) -> Key:
    module, _, rest = item.nodeid.partition("::")
    name, _, parameters = rest.partition("[")
    return (module, name, parameters.removesuffix("]")) if is_python(item) else (module, EVERY_CELL, "")


# -- hooks ----------------------------------------------------------------


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--all", action="store_true", help="run every proof in full, and record those that pass")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(Recorder() if config.option.all else Remembered(config), "proofs")


@pytest.fixture(scope="session")
def sample(pytestconfig: pytest.Config) -> Callable[[Iterable[Member], int], Sequence[Member]]:
    """Return a function that draws some of many, the same ones each time; under `--all`, it returns all of them."""

    def draw(items: Iterable[Member], count: int) -> Sequence[Member]:
        found = list(items)
        if pytestconfig.option.all or len(found) <= count:
            return found
        chosen = sorted(random.Random(count).sample(range(len(found)), count))
        return [found[place] for place in chosen]

    return draw


class Remembered:
    """Deselect the proofs that are unchanged, and report how many."""

    def __init__(self, config: pytest.Config) -> None:
        named = any("::" in word for word in config.args)
        self.count = 0
        self.store = {} if named else {module: held for module, held in read_store().items() if held.is_current()}

    def is_unchanged(self, item: pytest.Item) -> bool:
        module, name, parameters = key_of(item)
        proved = self.store[module].proved.get(name, {}) if module in self.store else {}
        return parameters in proved and proved[parameters] == digest_of_reads(item)

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        remembered = [item for item in items if is_proof(item) and self.is_unchanged(item)]
        if remembered:
            config.hook.pytest_deselected(items=remembered)
            left_out = set(remembered)
            items[:] = [item for item in items if item not in left_out]
        self.count = len({key_of(item) for item in remembered})
        if hasattr(config, "workeroutput"):
            config.workeroutput["remembered"] = self.count

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        self.count = max(self.count, getattr(node, "workeroutput", {}).get("remembered", 0))

    def pytest_sessionfinish(self, session: pytest.Session, exitstatus: int) -> None:
        if exitstatus == NO_TESTS and self.count:
            session.exitstatus = pytest.ExitCode.OK

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        if self.count:
            terminalreporter.write_line(f"{self.count} proved before and unchanged")


class Recorder:
    """Trace the test modules that have proofs, and keep what passed."""

    def __init__(self) -> None:
        self.started = time.time()
        self.sizes: dict[Key, int] = defaultdict(int)  # items of a proof: one, or the cells of a notebook
        self.passed: dict[Key, int] = defaultdict(int)
        self.failed: set[str] = set()
        self.reads: dict[Key, tuple[list[str], str]] = {}  # files, and their digest
        self.ran: dict[str, set[str]] = defaultdict(set)
        self.children = Path(tempfile.mkdtemp(prefix="tflab-ran-")) / "files"  # that ran in child processes
        self.children.touch()
        self.read = 0  # characters of it

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        for item in filter(is_proof, items):
            self.sizes[key_of(item)] += 1

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        if not self.is_traced(item):
            return (yield)
        with pytest.MonkeyPatch.context() as environment:
            environment.setenv("PYTHONPATH", str((ROOT / TRACER).parent), prepend=os.pathsep)
            environment.setenv("TRACED_FILES", str(self.children))
            tracing.start(tracing.collect)
            try:
                return (yield)
            finally:
                tracing.stop()

    def is_traced(self, item: pytest.Item) -> bool:
        return any(module == key_of(item)[0] for module, _, _ in self.sizes)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self, item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
        report = yield
        if call.when == "teardown" and self.is_traced(item):
            lines = self.children.read_text(encoding="utf-8")
            ran = tracing.ran | set(lines[self.read :].split())
            self.read = len(lines)
            tracing.ran.clear()
            names = sorted(name.removeprefix(tracing.ROOT) for name in ran if name.startswith(tracing.ROOT))
            key = key_of(item)
            reads = [sorted(files_read_by(item)), digest_of_reads(item)] if is_proof(item) else None
            report.user_properties.append(("proof", [key, self.sizes.get(key, 0), names, reads]))
        return report

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Collect the reports; under pytest-xdist, those of all workers come to their controller."""
        if not report.passed:
            self.failed.add(report.nodeid)
        for name, held in report.user_properties:
            if name == "proof":
                key, size, ran, reads = tuple(held[0]), *held[1:]
                self.ran[key[0]] |= set(ran)
                if reads is not None:
                    self.sizes[key], self.reads[key] = size, reads
                    self.passed[key] += report.nodeid not in self.failed

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if hasattr(session.config, "workerinput"):
            return
        store = read_store()
        for module, ran in self.ran.items():
            store[module] = self.merged(module, with_what_they_use(ran), store.get(module, Proofs()))
        write_store({module: held for module, held in store.items() if held.proved and (ROOT / module).is_file()})

    def merged(self, module: str, ran: list[str], old: Proofs) -> Proofs:
        """Return what is proved of a module: what passed now, beside what was proved before and is current."""
        kept = old if old.is_current() else Proofs()
        names = sorted({*ran, *kept.ran})
        proved = {function: dict(digests) for function, digests in kept.proved.items()}
        for key in self.reads:
            if key[0] == module:
                proved.setdefault(key[1], {}).pop(key[2], None)
                reads, digest = self.reads[key]
                if self.passed[key] == self.sizes[key] and not self.is_edited({*names, *reads}):
                    proved[key[1]][key[2]] = digest
        return Proofs(names, digest_of(names), {function: held for function, held in proved.items() if held})

    def is_edited(self, names: set[str]) -> bool:
        """Return whether a file was edited while the tests ran, so that nothing is known of it."""
        return any((ROOT / name).stat().st_mtime > self.started for name in names)
