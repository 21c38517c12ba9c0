"""How fast is the engine, next to the real tf2 and to pytransform3d?  Ratios from one interleaved run.

    python benchmarks/engine.py [--rounds 9] [--quick] [--single]

Peers, each used where it is installed:
    tf2_py          Debian's python3-tf2 (C++ tf2 0.7.6 behind its own Python binding), run by /usr/bin/python3
    pytransform3d   TemporalTransformManager (pure Python and NumPy), from the extra `bench`

Every round times all of them on the same data, one after the other, so that a
slow moment of the machine hits all alike; a figure is the median over rounds, a
ratio the median of the rounds' ratios (above 1: we are faster).
"""

from __future__ import annotations

import argparse
import json
import math
import os
import random
import statistics
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from tflab.core import BufferCore, StampedTransform, Transform, seconds

START_NS = seconds(1000.0)
STEP_NS = seconds(0.01)
PER_EDGE = 1000  # ten seconds at 100 Hz


def chain_samples(depth: int, per_edge: int, seed: int = 1) -> list[tuple]:
    """Return (parent, child, stamp_ns, translation, rotation) of a chain f0 <- f1 <- ... with every edge moving."""
    chance = random.Random(seed)
    samples = []
    for edge in range(depth):
        for k in range(per_edge):
            rotation = [chance.gauss(0, 1) for _ in range(4)]
            length = math.hypot(*rotation)
            translation = [chance.uniform(-1, 1) for _ in range(3)]
            samples.append(
                (f"f{edge}", f"f{edge + 1}", START_NS + k * STEP_NS, translation, [c / length for c in rotation])
            )
    return samples


def filled(samples: list[tuple]) -> BufferCore:
    buffer = BufferCore(seconds(1e6))
    edges: dict[tuple[str, str], list] = {}
    for parent, child, *sample in samples:
        edges.setdefault((parent, child), []).append(sample)
    for (parent, child), rows in edges.items():
        stamps, translations, rotations = zip(*rows, strict=True)
        buffer.set_transforms(parent, child, stamps, np.array(translations), np.array(rotations))
    return buffer


def timed(work) -> float:
    begin = time.process_time()
    work()
    return time.process_time() - begin


class Peer:
    """A process that is asked and told one by one: see engine_peer.py."""

    def __init__(self, kind: str, compiled: str = "0") -> None:
        script = Path(__file__).with_name("engine_peer.py")
        self.process = subprocess.Popen(
            [PEER_PYTHON, str(script), kind],
            env={**os.environ, "TFLAB_COMPILED": compiled},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.build = self.ask(do="hello")["build"]

    def ask(self, **command) -> dict:
        self.process.stdin.write(json.dumps(command) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self) -> None:
        self.process.stdin.close()
        self.process.wait()


def peers() -> dict[str, Peer]:
    """Return tf2_py, where it is installed, and our engine: as it stands, and compiled where `make fast` was run."""
    found = {"pure": Peer("tflab")}
    compiled = Peer("tflab", "1")
    if compiled.build == "compiled":
        found["compiled"] = compiled
    else:
        print(f"compiled: not there for {PEER_PYTHON} (make fast)")
        compiled.close()
    if runs_under_peer_python("import tf2_py, rospy"):
        found["tf2_py"] = Peer("tf2_py")
    else:
        print("tf2_py: not installed (Debian: apt-get install python3-tf2 python3-tf2-ros python3-geometry-msgs)")
    return found


def runs_under_peer_python(code: str, python: str = "/usr/bin/python3") -> bool:
    try:
        return subprocess.run([python, "-c", code], capture_output=True).returncode == 0
    except OSError:
        return False


# tf2_py needs the system's interpreter, and a ratio is only fair under one and the same
PEER_PYTHON = "/usr/bin/python3" if runs_under_peer_python("import numpy") else sys.executable


def pytransform3d_manager(samples: list[tuple], depth: int):
    try:
        from pytransform3d.transform_manager import NumpyTimeseriesTransform, TemporalTransformManager
    except ModuleNotFoundError:
        print("pytransform3d: not installed (pip install 'tflab[bench]')")
        return None
    manager = TemporalTransformManager()
    for edge in range(depth):
        rows = [s for s in samples if s[0] == f"f{edge}"]
        times = np.array([s[2] for s in rows]) / 1e9
        poses = np.array([[*s[3], s[4][3], *s[4][:3]] for s in rows])  # w first there
        manager.add_transform(f"f{edge + 1}", f"f{edge}", NumpyTimeseriesTransform(times, poses))
    return manager


class Table:
    def __init__(self) -> None:
        self.missed: list[str] = []

    def row(
        self, what: str, ours: list[float], peers: dict[str, list[float]], per: int, goals: dict[str, float]
    ) -> None:
        text = f"{what:<44}{statistics.median(ours) / per * 1e6:>9.3f} us"
        for name, theirs in peers.items():
            if not theirs:
                continue
            ratio = statistics.median(t / o for t, o in zip(theirs, ours, strict=True))
            goal = goals.get(name)
            verdict = "" if goal is None else f" (goal {goal:g})" if ratio >= goal else f" (goal {goal:g}: MISSED)"
            text += f"   {name} {statistics.median(theirs) / per * 1e6:.2f} us, x{ratio:.2f}{verdict}"
            if goal is not None and ratio < goal:
                self.missed.append(f"{what}: x{ratio:.2f} of {name}, goal {goal:g}")
        print(text, flush=True)


def one_by_one(table: Table, found: dict[str, Peer], rounds: int, asked: int) -> None:
    """Time single lookups: at random moments, at the newest, with stamps as they come from a real network, and live."""
    goals = {  # of tf2_py, at depth 1 / 4 / 10
        ("pure", "random"): (2.5, 0.9, 0.5),
        ("compiled", "random"): (4.0, 3.0, 2.5),
        ("pure", "LATEST"): (2.5, 1.2, 0.6),
        ("compiled", "LATEST"): (3.0, 2.5, 2.5),
        ("pure", "live"): (1.3, 0.65, 0.55),
        ("compiled", "live"): (1.6, 1.2, 1.1),
    }
    for place, depth in enumerate((1, 4, 10)):
        names = {"target": "f0", "source": f"f{depth}"}
        steady = chain_samples(depth, PER_EDGE)
        ragged = jittered(steady)
        chance = random.Random(2)
        moments = [START_NS + STEP_NS + chance.randrange((PER_EDGE - 3) * STEP_NS) for _ in range(asked)]
        for what, samples, stamps in (
            ("random", steady, moments),
            ("LATEST", steady, [0] * asked),
            ("random, jitter and loss", ragged, moments),
        ):
            for peer in found.values():
                peer.ask(do="fill", samples=samples, stamps_ns=stamps, **names)
            compare(table, found, f"{what}, depth {depth}", "lookup", rounds, asked, goals, what, place)
        rows = [steady[k::PER_EDGE] for k in range(PER_EDGE)]
        stamps = [None, *(row[0][2] - STEP_NS // 3 for row in rows[1:])]  # between the newest two: met only once
        for peer in found.values():
            peer.ask(do="prepare_live", rows=rows, stamps_ns=stamps, **names)
        compare(table, found, f"live, depth {depth}", "live", rounds, PER_EDGE, goals, "live", place)
    rows = [chain_samples(30, PER_EDGE)[k::PER_EDGE] for k in range(PER_EDGE)]
    stamps = [None, *(row[0][2] - STEP_NS // 3 for row in rows[1:])]
    for peer in found.values():
        peer.ask(do="prepare_live", rows=rows, stamps_ns=stamps, target="f8", source="f12")
    compare(table, found, "live, 30 edges told, 4 asked", "live", rounds, PER_EDGE, {}, "", 0)


def compare(table, found, label, do, rounds, per, goals, what, place) -> None:
    times: dict[str, list[float]] = {name: [] for name in found}
    for _ in range(rounds):
        for name, peer in found.items():
            times[name].append(peer.ask(do=do)["seconds"])
    for name in ("pure", "compiled"):
        if name in found:
            goal = {"tf2_py": goals[name, what][place]} if (name, what) in goals else {}
            table.row(f"{label}: {name}", times[name], {"tf2_py": times.get("tf2_py", [])}, per, goal)


def jittered(samples: list[tuple]) -> list[tuple]:
    """Return samples whose stamps are off by up to a third of a period, and of which one in fifty was lost."""
    chance = random.Random(5)
    ends = (START_NS, START_NS + (PER_EDGE - 1) * STEP_NS)
    return [
        (parent, child, ns if ns in ends else ns + chance.randint(-STEP_NS // 3, STEP_NS // 3), *numbers)
        for parent, child, ns, *numbers in samples
        if ns in ends or chance.random() > 0.02
    ]


def against_pytransform3d(table: Table, rounds: int, asked: int) -> None:
    for depth in (1, 4, 10):
        samples = chain_samples(depth, PER_EDGE)
        manager = pytransform3d_manager(samples, depth)
        if manager is None:
            return
        chance = random.Random(2)
        stamps = [START_NS + chance.randrange((PER_EDGE - 1) * STEP_NS) for _ in range(asked)]
        buffer, target, source = filled(samples), "f0", f"f{depth}"
        few = stamps[:: max(1, len(stamps) // 20)]

        def ours(buffer=buffer, target=target, source=source, stamps=stamps) -> None:
            for stamp in stamps:
                buffer.lookup_transform(target, source, stamp)

        def theirs(manager=manager, target=target, source=source, few=few) -> None:
            for stamp in few:
                manager.get_transform_at_time(source, target, stamp / 1e9)

        ours()
        own = [timed(ours) for _ in range(rounds)]
        other = [timed(theirs) * len(stamps) / len(few) for _ in range(rounds)]
        table.row(f"lookup, depth {depth}", own, {"pytransform3d": other}, asked, {"pytransform3d": 200.0})


def batch_lookups(table: Table, peer: Peer | None, rounds: int, sizes: list[int]) -> None:
    rng = np.random.default_rng(3)
    goals = {
        (1, "random"): 30,
        (4, "random"): 9,
        (10, "random"): 4,
        (1, "sorted"): 60,
        (4, "sorted"): 14,
        (10, "sorted"): 6,
    }
    for depth in (1, 4, 10):
        samples = chain_samples(depth, PER_EDGE)
        buffer, target, source = filled(samples), "f0", f"f{depth}"
        chance = random.Random(2)
        few = [START_NS + chance.randrange((PER_EDGE - 1) * STEP_NS) for _ in range(5000)]
        if peer:
            peer.ask(do="fill", samples=samples, target=target, source=source, stamps_ns=few)
        for n in sizes:
            stamps = START_NS + rng.integers(0, (PER_EDGE - 1) * STEP_NS, n)
            for order, asked in (("random", stamps), ("sorted", np.sort(stamps))):
                buffer.lookup_transforms(target, source, asked)
                own, theirs = [], []
                for _ in range(rounds if n <= 10**5 else max(3, rounds // 3)):
                    own.append(timed(lambda b=buffer, t=target, s=source, a=asked: b.lookup_transforms(t, s, a)))
                    if peer:
                        theirs.append(peer.ask(do="lookup")["seconds"] / len(few) * n)
                what = f"batch of {n:.0e}, depth {depth}, {order}"
                table.row(what, own, {"tf2_py": theirs}, n, {"tf2_py": goals[depth, order]})


def ingest(table: Table, found: dict[str, Peer], rounds: int, n: int) -> None:
    samples = [("a", "b", START_NS + k * seconds(0.001), *chain_samples(1, 1, seed=k)[0][3:]) for k in range(n)]
    columns = [np.array(column) for column in zip(*(s[2:] for s in samples), strict=True)]
    for peer in found.values():
        peer.ask(do="prepare", samples=samples)
    goals = {("pure", "set"): (1.4,), ("compiled", "set"): (2.0,)}
    compare(table, found, "set_transform", "ingest", rounds, n, goals, "set", 0)
    bulk, theirs = [], []
    for _ in range(rounds):
        bulk.append(timed(lambda: BufferCore().set_transforms("a", "b", *columns, "me")))
        if "tf2_py" in found:
            theirs.append(found["tf2_py"].ask(do="ingest")["seconds"])
    table.row("set_transforms", bulk, {"tf2_py": theirs}, n, {"tf2_py": 5.0})


def growth(rounds: int, sizes: list[int]) -> None:
    """Print how the cost of a lookup and of an insert grows with the history, and what a sample weighs."""
    for n in sizes:
        stamps = START_NS + np.arange(n, dtype=np.int64) * STEP_NS
        rng = np.random.default_rng(4)
        translations, rotations = rng.normal(size=(n, 3)), rng.normal(size=(n, 4))
        buffer = BufferCore(seconds(1e9))
        filling = timed(lambda b=buffer, s=stamps, t=translations, r=rotations: b.set_transforms("a", "b", s, t, r))
        per_sample = buffer.memory().sample_bytes / n
        asked = (START_NS + rng.integers(0, (n - 1) * STEP_NS, 5000)).tolist()
        later = [
            StampedTransform("a", "b", int(stamps[-1]) + (k + 1) * STEP_NS, Transform((1, 2, 3))) for k in range(5000)
        ]

        def lookups(buffer=buffer, asked=asked) -> None:
            for stamp in asked:
                buffer.lookup_transform("a", "b", stamp)

        def inserts(buffer=buffer, later=later) -> None:
            for transform in later:
                buffer.set_transform(transform)

        lookup_us = statistics.median(timed(lookups) for _ in range(rounds)) / 5000 * 1e6
        insert_us = timed(inserts) / 5000 * 1e6
        print(
            f"history of {n:.0e}: bulk {filling / n * 1e6:.3f} us, lookup {lookup_us:.2f} us, "
            f"insert {insert_us:.2f} us, "
            f"{per_sample:.1f} bytes a sample, memos {buffer.memory().memo_bytes / 1024:.0f} KiB",
            flush=True,
        )


def import_time(rounds: int) -> None:
    """Print what `import tflab` and `import tflab.core` cost above numpy, in fresh processes."""

    def seconds_for(code: str) -> float:
        probe = f"import time, numpy; t = time.process_time(); {code}; print(time.process_time() - t)"
        return float(subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True).stdout)

    for code in ("import tflab", "import tflab.core"):
        print(f"{code}: {statistics.median(seconds_for(code) for _ in range(rounds)) * 1e3:.1f} ms above numpy")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--quick", action="store_true", help="small sizes only")
    parser.add_argument("--single", action="store_true", help="only what is asked and told one by one")
    options = parser.parse_args()
    sizes = [10**4] if options.quick else [10**4, 10**5, 10**6]
    table, found = Table(), peers()
    one_by_one(table, found, options.rounds, 5000)
    ingest(table, found, options.rounds, 10**4)
    if not options.single:
        against_pytransform3d(table, options.rounds, 5000)
        batch_lookups(table, found.get("tf2_py"), options.rounds, sizes)
        growth(3, [10**3, 10**4, 10**5, 10**6])
        import_time(options.rounds)
    for peer in found.values():
        peer.close()
    print("\nGoals missed:", *(table.missed or ["none"]), sep="\n  ")


if __name__ == "__main__":
    main()
