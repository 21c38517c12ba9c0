"""Code in a submission can see, harm or outlive nothing: each protection is attacked in each sandbox."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace

import psutil
import pytest
import yaml

from tflab.grading.kernels import kernel_pool, landlock, seccomp, supervisor
from tflab.grading.kernels.kernel_pool import Kernel, KernelError, Kernels, choose_sandbox
from tflab.grading.kernels.limits import Limits
from tflab.grading.kernels.probe_answer import PROBE_TYPE
from tflab.grading.kernels.sandbox import LEVELS, Sandbox

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
NETWORKS, LOCKS, CALLS, BEHIND, SURVIVORS = (
    CASES[name] for name in ("networks", "locks", "calls", "behind", "survivors")
)
SAY = f"""
import os, sys
from IPython.display import display
def say(value):
    display({{{PROBE_TYPE!r}: {{"id": "", "v": value}}}}, raw=True)
"""
TRY = CASES["attempt"]
pytestmark = pytest.mark.proof(
    reads=["tflab/grading/kernels/**/*.py", "tests/grading/test_sandbox.*"]
)  # every attack behind every wall
WALLS = ("namespaces", "bubblewrap")  # the third one says itself that it is none


class Inside:
    """A kernel to attack from within: `inside("2 + 2")` is 4."""

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.run(SAY + TRY)

    def __call__(self, expression: str, before: str = "") -> object:
        said = self.run(f"{before}\nsay({expression})")
        values = [one["data"][PROBE_TYPE]["v"] for one in said if "data" in one]
        assert len(values) == 1, said
        return values[0]

    def run(self, code: str) -> list[dict]:
        """Run a cell; return what it said."""
        self.kernel.wire.send({"msg_id": "1", "code": code})
        said = []
        while True:
            message = self.kernel.wire.receive(20.0)
            assert message is not None, "no answer from the kernel"
            if message["msg_type"] == "status":
                return said
            said.append(message["content"])


@pytest.fixture(scope="module")
def secret(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    folder = tmp_path_factory.mktemp("instructor")
    (folder / "pack.json").write_text('{"expected": 42}', encoding="utf-8")
    folder.chmod(0o755)
    yield folder


@pytest.fixture(scope="module", params=LEVELS)
def kernels(request: pytest.FixtureRequest, secret: Path) -> Iterator[Kernels]:
    pool = Kernels(Sandbox(request.param, hide=(str(secret),)), ahead=0)
    try:
        pool.take(Limits()).close()
    except KernelError as fault:
        pool.close()
        if os.environ.get("CI") == "true":
            raise
        pytest.skip(f"{request.param}: {fault}")
    yield pool
    pool.close()


@pytest.fixture(scope="module")
def shared(kernels: Kernels) -> Iterator[Inside]:
    """One kernel for attacks that leave nothing behind."""
    kernel = kernels.take(Limits())
    yield Inside(kernel)
    kernel.close()


@pytest.fixture
def inside(shared: Inside, kernels: Kernels) -> Inside:
    """The same behind a real wall."""
    if kernels.sandbox.level not in WALLS:
        pytest.skip("this level does not promise it, and says so")
    return shared


@pytest.fixture
def confined(shared: Inside, kernels: Kernels) -> Inside:
    """The same where only Landlock confines it."""
    if kernels.sandbox.level != "limits":
        pytest.skip("this level has a file system of its own")
    if landlock.abi() < landlock.CONFINES:
        pytest.skip("this machine's Landlock is too old, and the report says what follows")
    return shared


@pytest.fixture
def fresh(kernels: Kernels) -> Iterator[Inside]:
    kernel = kernels.take(Limits(memory_bytes=300 << 20, processes=40, file_bytes=16 << 20))
    yield Inside(kernel)
    kernel.close()


# What an answer may need works.


def test_modules_files_and_commands_can_be_used(shared: Inside) -> None:
    assert shared("int(np.arange(4).sum())", "import numpy as np") == 6
    assert shared("rclpy.ok()", "%load_ext tflab\nimport rclpy") is False
    assert shared("colorsys.__name__ + wave.__name__", "import colorsys, wave") == "colorsyswave"  # not loaded before
    assert shared("open('a.txt').read()", "open('a.txt', 'w').write('hello')") == "hello"
    assert shared("os.path.exists(tempfile.mkstemp()[1])", "import tempfile") is True
    assert shared("subprocess.run(['echo', 'x'], capture_output=True, text=True).stdout", "import subprocess") == "x\n"


def test_a_cell_may_wait_for_a_coroutine_and_leave_a_task_running(shared: Inside) -> None:
    assert shared("len(ticks) > 1", CASES["a_task_that_stays"]) is True
    assert shared("task.cancel()") is True


def test_figures_widgets_threads_and_processes_work(shared: Inside, kernels: Kernels) -> None:
    assert shared("len(plt.get_fignums())", "import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()") == 1
    shared.run("%matplotlib inline")
    assert shared("len(plt.get_fignums())") == 1
    assert shared("w.IntSlider(value=3).value", "import ipywidgets as w") == 3
    threads = "from concurrent.futures import ThreadPoolExecutor as Pool"
    assert shared("list(Pool(3).map(abs, [-1, 2]))", threads) == [1, 2]
    if kernels.sandbox.level != "limits" or landlock.abi() < landlock.CONFINES:  # else it says that they do not
        assert shared("list(multiprocessing.Pool(2).map(abs, [-1, 2]))", "import multiprocessing") == [1, 2]


STOP = "import asyncio\nasyncio.get_event_loop().stop()"


def test_leaving_in_a_cell_ends_the_cell_and_nothing_else(shared: Inside) -> None:
    for cell in ("exit", "quit()", "import sys; sys.exit(0)", "%%time\nexit()", STOP):
        shared.run(cell)
        shared("asyncio.sleep and 1", "import asyncio\nawait asyncio.sleep(0.12)")
        assert shared("1 + 1") == 2
    assert shared("attempt(lambda: input('?'))") == "StdinNotImplementedError"


def test_what_is_random_is_the_same_every_time(kernels: Kernels) -> None:
    draws = []
    for _ in range(2):
        kernel = kernels.take(Limits())
        draws.append(
            Inside(kernel)("[random.random(), np.random.rand(), hash('a')]", "import random\nimport numpy as np")
        )
        kernel.close()
    assert draws[0] == draws[1]


# Nothing can be seen.


def test_the_pack_cannot_be_seen(inside: Inside, secret: Path) -> None:
    assert inside(f"attempt(lambda: open({str(secret / 'pack.json')!r}).read())") == "FileNotFoundError"
    assert inside(f"os.path.exists({str(secret)!r})") is False


def test_what_is_hidden_is_covered_even_beside_what_is_shown(kernels: Kernels) -> None:
    import tflab

    if kernels.sandbox.level == "limits" and landlock.abi() < landlock.CONFINES:
        pytest.skip("this machine's Landlock is too old, and the report says what follows")
    package = Path(tflab.__file__).parent / "grading"
    folder, file = package / "judging", package / "batch.py"
    pool = Kernels(Sandbox(kernels.sandbox.level, hide=(str(folder), str(file))), ahead=0)
    try:
        inside = Inside(pool.take(Limits()))
        for path in (file, folder / "pack.py"):
            seen = inside(f"attempt(lambda: open({str(path)!r}).read())")
            assert path.read_text() and seen in ("''", "PermissionError", "FileNotFoundError"), path
        assert inside(f"bool(open({str(package / 'release.py')!r}).read())") is True
        if kernels.sandbox.level == "namespaces":
            assert inside(f"attempt(lambda: os.listdir({str(folder)!r}))") == "PermissionError"
    finally:
        pool.close()


def test_solutions_tasks_and_the_history_of_the_repository_cannot_be_seen(inside: Inside) -> None:
    from tflab.workbook.paths import workbook_data

    for name in ("solutions", "solutions/tasks", "solutions/en", "exercises", ".git", "tests"):
        assert inside(f"attempt(lambda: os.listdir({str(workbook_data() / name)!r}))") in (
            "FileNotFoundError",
            "PermissionError",
            "[]",
        )


def test_no_case_can_be_computed(inside: Inside) -> None:
    before = (
        "from tflab.workbook import paths\nfrom tflab.workbook.tasks.catalog import *\n"
        "data, stem = paths.workbook_data(), '03_target_and_source'"
    )
    for call in ("tasks_of(data, stem)", "assigned_cases(data, stem, 'E3.2', paths.Workbook())"):
        assert inside(f"attempt(lambda: {call})", before) in ("TaskError", "PermissionError")


def test_there_is_no_home_but_an_empty_one_and_no_network(inside: Inside) -> None:
    assert inside("[line.split(':')[0].strip() for line in open('/proc/net/dev') if ':' in line]") == ["lo"]
    assert inside("os.listdir('/home')") == ["learner"]
    assert inside("[os.environ['HOME'], os.getcwd()]") == ["/home/learner", "/home/learner"]
    if os.path.isdir("/root"):
        assert inside("set(os.listdir('/root')) <= {'.pyenv'} if os.path.exists('/root') else True") is True


def test_no_process_of_the_grader_can_be_seen_or_signalled(inside: Inside) -> None:
    pids = inside("sorted(int(name) for name in os.listdir('/proc') if name.isdigit())")
    assert len(pids) <= 4
    assert inside(f"attempt(lambda: os.kill({os.getpid()}, 0))") == "ProcessLookupError"


def test_no_variable_and_no_file_of_the_grader_comes_along(kernels: Kernels, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GRADER_TOKEN", "do-not-tell")
    pool = Kernels(kernels.sandbox, ahead=0)
    kernel = pool.take(Limits())
    try:
        inside = Inside(kernel)
        assert inside("'GRADER_TOKEN' in os.environ") is False
        seen = inside("attempt(lambda: open('/proc/self/environ').read() + open('/proc/1/environ').read())")
        assert "do-not-tell" not in seen
        files = "[os.readlink(f'/proc/self/fd/{n}').split(':')[0] for n in os.listdir('/proc/self/fd')[:-1]]"
        assert set(inside(files)) <= {"/dev/null", "socket", "anon_inode"}
    finally:
        kernel.close()
        pool.close()


@pytest.mark.skipif(not seccomp.is_there(), reason="this machine has no filter, and the report says so")
def test_no_wall_gives_a_socket_of_a_network_or_a_lock_on_a_file_of_python(shared: Inside) -> None:
    sockets = {name: shared(f"attempt(lambda: {NETWORKS[name]})", "import socket") for name in NETWORKS}
    assert {name: seen for name, seen in sockets.items() if seen not in ("OSError", "gaierror")} == {}
    locks = {name: shared(f"attempt(lambda: {LOCKS[name]})", "import fcntl") for name in LOCKS}
    assert {name: seen for name, seen in locks.items() if seen != "PermissionError"} == {}
    assert shared("fcntl.fcntl(open('mine', 'w'), fcntl.F_GETFD)") == 1


def test_nobody_reads_what_is_typed_and_a_command_waits_for_no_keyboard(shared: Inside) -> None:
    keyboard, terminal = os.openpty()
    os.write(keyboard, b"a password\n")
    name = os.ttyname(terminal)
    tried = f"attempt(lambda: os.read(os.open({name!r}, os.O_RDONLY | os.O_NOCTTY | os.O_NONBLOCK), 100).decode())"
    assert shared(tried) in ("PermissionError", "FileNotFoundError")
    for end in (keyboard, terminal):
        os.close(end)
    before = "!cat\n!exit 3\nwhere = 'b'\n!echo $where {1 + 1} > c.txt\nsaid = !echo hi"
    assert shared("[open('c.txt').read(), list(said), _exit_code]", before) == ["b 2\n", ["hi"], 0]


def test_without_a_wall_landlock_keeps_the_pack_from_being_read_and_the_grader_from_being_ended(
    confined: Inside, secret: Path
) -> None:
    pack, grader = str(secret / "pack.json"), f"/proc/{os.getpid()}"
    for call in (
        f"open({pack!r}).read()",
        f"os.listdir({str(secret)!r})",
        "open('/etc/passwd').read()",
        f"os.kill({os.getpid()}, 0)",
        f"open('{grader}/environ').read()",
        f"open('{grader}/mem', 'rb').read(1)",
    ):
        assert confined(f"attempt(lambda: {call})") == "PermissionError", call
    assert confined("attempt(socket.socket)", "import socket") == "OSError"


def test_landlock_hides_what_lies_in_a_folder_that_is_shown(tmp_path: Path) -> None:
    (tmp_path / "a" / "b").mkdir(parents=True)
    (tmp_path / "a" / "c.py").touch()
    rules = dict(landlock.readable(tmp_path, (tmp_path / "a" / "b",)))
    assert rules == {
        str(tmp_path): landlock.LIST,
        str(tmp_path / "a"): landlock.LIST,
        str(tmp_path / "a" / "c.py"): landlock.EXECUTE | landlock.READ | landlock.LIST,
    }


# Nothing can be changed.


def test_no_two_kernels_are_the_same_user(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(supervisor.os, "getpid", lambda: 7)  # or a number as far away as there are users
    monkeypatch.setattr(supervisor, "FIRST_UID", 60000)  # those of the kernels that run are not in the way
    monkeypatch.setattr(supervisor, "UIDS", 3)
    users = [supervisor.reserve_user_id() for _ in range(3)]
    assert sorted(uid for uid, _ in users) == [60000, 60001, 60002]
    with pytest.raises(OSError, match="no user from 60000 to 60002 is free"):
        supervisor.reserve_user_id()
    first, reserved = users.pop(0)
    reserved.close()
    assert supervisor.reserve_user_id()[0] == first
    for _, taken in users:
        taken.close()


def test_the_system_is_read_only_and_nobody_is_root(inside: Inside) -> None:
    import tflab

    for path in ("/", "/usr", "/etc", "/proc/sys/kernel/hostname", "/dev", str(Path(tflab.__file__).parent)):
        file = f"{path!r} if os.path.isfile({path!r}) else {path!r} + '/x'"
        assert inside(f"attempt(lambda: open({file}, 'w').write('x'))") in ("OSError", "PermissionError"), path
    assert inside("os.getuid() != 0 and os.geteuid() != 0") is True
    assert inside("attempt(lambda: os.setuid(0))") == "PermissionError"


def test_a_kernel_has_no_rights_but_one_to_read_python_and_can_get_none(shared: Inside, kernels: Kernels) -> None:
    status = shared("open('/proc/self/status').read()")
    fields = dict(line.split(":\t", 1) for line in status.splitlines() if ":\t" in line)
    to_read_python = kernels.sandbox.level == "limits" and supervisor.gets_a_user() and supervisor.right_to_python()
    rights = 1 << to_read_python if to_read_python else 0
    assert {int(fields[name], 16) for name in ("CapInh", "CapPrm", "CapEff", "CapAmb")} == {rights}
    assert fields["NoNewPrivs"] == "1"


@pytest.mark.skipif(os.uname().machine != "x86_64", reason="these are x86-64's numbers")
def test_dangerous_system_calls_are_refused(shared: Inside) -> None:
    before = "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)"
    results = {call: shared(f"[{CALLS[call]}, ctypes.get_errno()]", before) for call in CALLS}
    refused = ([-1, 1], [-1, 97])  # EPERM, EAFNOSUPPORT: not tried
    assert {call: result for call, result in results.items() if result not in refused} == {}


@pytest.mark.skipif(os.uname().machine != "x86_64", reason="these are x86-64's numbers")
def test_without_a_file_system_of_its_own_no_socket_has_a_name_and_no_file_is_changed(
    shared: Inside, kernels: Kernels
) -> None:
    if kernels.sandbox.level != "limits":
        pytest.skip("this level has a file system of its own")
    for made in ("socket(socket.AF_UNIX)", "socketpair(type=socket.SOCK_DGRAM)", "socketpair(type=socket.SOCK_RAW)"):
        assert shared(f"attempt(lambda: socket.{made})", "import socket") in ("OSError", "PermissionError")
    works = "import asyncio\nfrom multiprocessing import Pipe\nloop = asyncio.new_event_loop()"
    assert shared("[len(socket.socketpair()), len(Pipe())]", works) == [2, 2]
    change = "os.chmod('f', 0), os.utime('f', (0, 0)), os.chown('f', 1, 1)"
    seen = "os.stat('f').st_mode & 0o777, os.stat('f').st_mtime > 1"
    assert shared(f"[{change}, {seen}]", "open('f', 'w').close()") == [None, None, None, 0o644, True]
    assert shared("attempt(lambda: os.setxattr('f', 'user.x', b'y'))") == "OSError"
    assert shared("[__import__('shutil').copy('f', 'g'), __import__('shutil').copy2('f', 'h')]") == ["g", "h"]


def test_kernels_share_no_place_to_leave_something(kernels: Kernels) -> None:
    if kernels.sandbox.level == "limits" and landlock.abi() < landlock.CONFINES:
        pytest.skip("this machine's Landlock is too old, and the report says what follows")
    first, second = kernels.take(Limits()), kernels.take(Limits())
    try:
        assert Inside(first)("left > 0", CASES["leave"]) is True  # its own folder at least
        assert Inside(second)("there", CASES["look"]) == []
    finally:
        first.close()
        second.close()
    assert not Path("/dev/shm/tflab-left-here").exists()


# Nothing can be used up.


@pytest.mark.parametrize("place", BEHIND)
def test_the_memory_of_all_processes_counts_wherever_it_is(kernels: Kernels, place: str) -> None:
    assert how_it_ends(kernels, BEHIND[place], memory_bytes=200 << 20) == "memory limit"


def how_it_ends(kernels: Kernels, code: str, **limits: int) -> str:
    kernel = kernels.take(Limits(**limits))
    kernel.wire.send({"msg_id": "1", "code": code})
    deadline = time.monotonic() + 30
    with pytest.raises(Exception, match=r"hung up|reset"):
        while time.monotonic() < deadline:
            kernel.wire.receive(1.0)
    return kernel.close()


def test_memory_is_limited_and_none_is_shared_by_forks(fresh: Inside, kernels: Kernels) -> None:
    assert fresh("attempt(lambda: bytearray(4 << 30))") == "MemoryError"
    before = "import mmap\ndef zero():\n    return mmap.mmap(os.open('/dev/zero', os.O_RDWR), 4096, mmap.MAP_SHARED)"
    assert fresh("attempt(lambda: mmap.mmap(-1, 4096))", before) == "PermissionError"
    if kernels.sandbox.level in WALLS:
        assert fresh("attempt(zero)", before) in ("PermissionError", "FileNotFoundError")
    assert "mmap" in str(fresh("attempt(lambda: mmap.mmap(-1, 4096, mmap.MAP_PRIVATE))", before))


def test_processes_are_limited(fresh: Inside, kernels: Kernels) -> None:
    if kernels.sandbox.level == "limits" and fresh("os.getuid()") in (0, os.getuid()):
        pytest.skip("the limit is for all processes of a user here, and this user is the grader's")
    bomb = CASES["bomb"]
    assert fresh("[attempt(bomb), len(children) < 60]", bomb) == ["BlockingIOError", True]


TWO_IN_EACH = CASES["two_in_each"]


def test_where_the_system_counts_no_processes_the_keeper_does() -> None:
    done = subprocess.run([sys.executable, "-c", TWO_IN_EACH], capture_output=True, text=True, timeout=60)
    assert done.stdout.strip() == "{'fault': 'process limit'} []", done.stderr


def test_files_are_limited(fresh: Inside, kernels: Kernels) -> None:
    def fill(count: int) -> str:
        return f"attempt(lambda: [open(f'f{{n}}', 'wb').write(bytes(5 << 20)) for n in range({count})])"

    if kernels.sandbox.level in WALLS:
        assert fresh(fill(9)) == "OSError"
    before = "import signal\nsignal.signal(signal.SIGXFSZ, signal.SIG_IGN)"
    assert fresh("attempt(lambda: open('g', 'wb').write(bytes(20 << 20)))", before) == "OSError"


def test_without_a_file_system_of_its_own_all_files_together_are_limited(kernels: Kernels) -> None:
    if kernels.sandbox.level != "limits":
        pytest.skip("this level has a file system of its own")
    fill = "import os, time\nkept = []\nfor n in range(9):\n    kept.append(open(f'f{n}', 'wb'))\n"
    fill += "    kept[-1].write(bytes(5 << 20)); kept[-1].flush()\n"
    for removed in ("", "    os.remove(f'f{n}')\n"):
        assert how_it_ends(kernels, fill + removed + "time.sleep(60)", file_bytes=16 << 20) == "disk limit"


# Nothing outlives.


def descendants_of_the_forkserver(kernels: Kernels) -> set[psutil.Process]:
    assert kernels._server is not None
    return set(filter(lives, psutil.Process(kernels._server.pid).children(recursive=True)))


def lives(process: psutil.Process) -> bool:
    """Return whether a process runs; it may end between two looks."""
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


@pytest.mark.parametrize("survivor", SURVIVORS)
def test_nothing_outlives_its_kernel(kernels: Kernels, survivor: str) -> None:
    before = descendants_of_the_forkserver(kernels)
    kernel = kernels.take(Limits())
    kernel.wire.send({"msg_id": "1", "code": SURVIVORS[survivor]})
    kernel.wire.receive(0.3)
    assert descendants_of_the_forkserver(kernels) - before
    kernel.close()
    end = time.monotonic() + 30.0  # its supervisor has said its last word, and ends now
    while (left := descendants_of_the_forkserver(kernels) - before) and time.monotonic() < end:
        time.sleep(0.01)
    assert not left


def test_a_kernel_ends_with_the_grader_even_if_that_is_killed(tmp_path: Path, kernels: Kernels) -> None:
    script = tmp_path / "grader.py"
    script.write_text(
        "from tflab.grading.kernels.kernel_pool import Kernels\n"
        "from tflab.grading.kernels.limits import Limits\n"
        "from tflab.grading.kernels.sandbox import Sandbox\n"
        f"kernels = Kernels(Sandbox({kernels.sandbox.level!r}), ahead=0)\n"
        "kernel = kernels.take(Limits())\n"
        "code = 'import ctypes\\nctypes.CDLL(None).prctl(1, 0)\\nwhile True: pass'\n"
        "kernel.wire.send({'msg_id': '1', 'code': code})\n"
        "print(kernels._server.pid, flush=True)\n"
        "input()\n",
        encoding="utf-8",
    )
    grader = subprocess.Popen([sys.executable, script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert grader.stdout is not None
    server = psutil.Process(int(grader.stdout.readline()))
    family = [server, *server.children(recursive=True)]
    assert len(family) >= 3
    grader.kill()
    grader.communicate()
    _, alive = psutil.wait_procs(family, timeout=30)
    assert not list(filter(lives, alive))


# Which wall.


def test_without_landlock_the_memory_of_the_grader_is_closed_at_least() -> None:
    done = subprocess.run([sys.executable, "-c", CASES["without_landlock"]], capture_output=True, text=True, check=True)
    assert done.stdout.split()[-1] == "0"


def test_the_best_wall_that_works_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    def kernels(works: tuple[str, ...]) -> Callable[[Sandbox], SimpleNamespace]:
        def take(level: str) -> SimpleNamespace:
            if level not in works:
                raise KernelError("not permitted")
            return SimpleNamespace(close=lambda: None)

        return lambda sandbox: SimpleNamespace(begin=lambda: None, take=lambda limits: take(sandbox.level))

    for works in (LEVELS, LEVELS[1:], LEVELS[2:]):
        monkeypatch.setattr(kernel_pool, "for_this_process", kernels(works))
        chosen = choose_sandbox()
        assert chosen.level == works[0]
        assert chosen.refused == tuple(f"no {level}: not permitted" for level in LEVELS[: -len(works)])
    monkeypatch.setattr(kernel_pool, "for_this_process", kernels(()))
    with pytest.raises(KernelError, match="no kernel can be started here; no namespaces: not permitted; no bubblewrap"):
        choose_sandbox()


def test_a_fallback_says_why_and_what_it_does_not_protect_from(monkeypatch: pytest.MonkeyPatch) -> None:
    def gaps(level: str) -> str:
        return " ".join(gap.en for gap in Sandbox(level).gaps)

    assert Sandbox("namespaces").announce() == ("Sandbox: namespaces.", "격리 방식: namespaces.")
    assert gaps("namespaces") == ""
    assert "several times as long" in gaps("bubblewrap")
    monkeypatch.setattr(landlock, "abi", lambda: landlock.CONFINES)
    assert "which other processes run" in gaps("limits") and "advisory" not in gaps("limits")
    monkeypatch.setattr(landlock, "abi", lambda: 0)
    assert "hidden answers are only advisory" in gaps("limits") and "network" not in gaps("limits")
    monkeypatch.setattr(seccomp, "is_there", lambda: False)  # another architecture
    assert "can reach the network" in gaps("limits")
    fallback = Sandbox("limits", refused=("no namespaces: not permitted", "no bubblewrap: there is no program bwrap"))
    why = "no namespaces: not permitted; no bubblewrap: there is no program bwrap"
    assert fallback.announce().en == f"Sandbox: limits ({why})."
    with pytest.raises(ValueError, match="no sandbox 'docker'; there are namespaces, bubblewrap, limits"):
        Sandbox("docker")


def test_a_look_at_many_processes_takes_no_longer_than_it_may(monkeypatch: pytest.MonkeyPatch) -> None:
    spent = iter(range(1_000))
    monkeypatch.setattr(supervisor.time, "thread_time", lambda: 0.2 * next(spent))
    monkeypatch.setattr(supervisor, "behind_sockets", lambda processes: 0)
    monkeypatch.setattr(supervisor, "rough_memory_of", lambda pid: (100, 1))
    monkeypatch.setattr(supervisor, "memory_of", lambda pid: 10)
    monkeypatch.setattr(supervisor, "mappings_of", lambda pid: [])
    assert supervisor.memory_of_all([1, 2, 3, 4, 5], enough=0) == 10 + 1 + 10 + 1 + 3 * (100 + 1)


@pytest.mark.skipif(os.getuid() != 0, reason="somebody who is not root runs all of these as such already")
def test_somebody_who_is_not_root_has_the_same_walls() -> None:
    code = (
        "import os; assert os.getuid() == 1000\n"
        "from tflab.grading.kernels.kernel_pool import Kernels, choose_sandbox\n"
        "from tflab.grading.kernels.limits import Limits\n"
        "print(choose_sandbox().level)\n"
    )
    words = ["unshare", "--user", "--map-user=1000", "--map-group=1000", sys.executable, "-c", code]
    done = subprocess.run(words, capture_output=True, text=True)
    if "Operation not permitted" in done.stderr and os.environ.get("CI") != "true":
        pytest.skip("this machine gives no namespace of users")
    assert done.stdout == "namespaces\n", done.stderr


def test_solutions_are_hidden_wherever_else_the_workbook_is_said_to_be(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    elsewhere, package = tmp_path / "elsewhere", tmp_path / "tflab"
    for folder in (elsewhere / "solutions", package / "_workbook" / "solutions"):
        folder.mkdir(parents=True)
    monkeypatch.setenv("TFLAB_WORKBOOK", str(elsewhere))
    monkeypatch.setattr("tflab.grading.kernels.sandbox.tflab.__file__", str(package / "__init__.py"))
    assert Sandbox().hidden() == (str(elsewhere / "solutions"), str(package / "_workbook" / "solutions"))
