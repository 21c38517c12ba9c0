"""How fast is the engine, next to the real tf2 and to pytransform3d?  Ratios from one interleaved run.

    python benchmarks/engine.py [--rounds 9] [--quick]

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


class Tf2Py:
    """The peer process, or None in its place where python3-tf2 is not installed."""

    def __init__(self) -> None:
        script = Path(__file__).with_name("tf2_peer.py")
        self.process = subprocess.Popen(
            ["/usr/bin/python3", str(script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self.ask(do="hello")

    def ask(self, **command) -> dict:
        self.process.stdin.write(json.dumps(command) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self) -> None:
        self.process.stdin.close()
        self.process.wait()


def tf2_py() -> Tf2Py | None:
    probe = "import tf2_py, rospy"
    try:
        found = subprocess.run(["/usr/bin/python3", "-c", probe], capture_output=True).returncode == 0
    except OSError:
        found = False
    if not found:
        print("tf2_py: not installed (Debian: apt-get install python3-tf2 python3-tf2-ros python3-geometry-msgs)")
        return None
    return Tf2Py()


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


def scalar_lookups(table: Table, peer: Tf2Py | None, rounds: int, asked: int) -> dict[int, list[float]]:
    """Time single lookups; return tf2_py's seconds per lookup for each depth, as the yardstick of the batches."""
    yardstick = {}
    for depth, goal in ((1, 2.0), (4, 0.8), (10, 0.4)):
        samples = chain_samples(depth, PER_EDGE)
        chance = random.Random(2)
        stamps = [START_NS + chance.randrange((PER_EDGE - 1) * STEP_NS) for _ in range(asked)]
        buffer, target, source = filled(samples), "f0", f"f{depth}"
        manager = pytransform3d_manager(samples, depth)
        if peer:
            peer.ask(do="fill", samples=samples, target=target, source=source, stamps_ns=stamps)

        def ours(buffer=buffer, target=target, source=source, stamps=stamps) -> None:
            lookup = buffer.lookup_transform
            for stamp in stamps:
                lookup(target, source, stamp)

        def theirs(manager=manager, target=target, source=source, stamps=stamps) -> None:
            for stamp in stamps[:: max(1, len(stamps) // 20)]:
                manager.get_transform_at_time(source, target, stamp / 1e9)

        ours()
        times: dict[str, list[float]] = {"tf2_py": [], "pytransform3d": []}
        own = []
        for _ in range(rounds):
            own.append(timed(ours))
            if peer:
                times["tf2_py"].append(peer.ask(do="lookup")["seconds"])
            if manager:
                times["pytransform3d"].append(timed(theirs) * len(stamps) / len(stamps[:: max(1, len(stamps) // 20)]))
        yardstick[depth] = [t / asked for t in times["tf2_py"]]
        table.row(f"lookup, depth {depth}", own, times, asked, {"tf2_py": goal, "pytransform3d": 200.0})
    return yardstick


def batch_lookups(table: Table, peer: Tf2Py | None, rounds: int, sizes: list[int]) -> None:
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


def ingest(table: Table, peer: Tf2Py | None, rounds: int, n: int) -> None:
    samples = [("a", "b", START_NS + k * seconds(0.001), *chain_samples(1, 1, seed=k)[0][3:]) for k in range(n)]
    stamped = [StampedTransform(p, c, ns, Transform(t, q)) for p, c, ns, t, q in samples]
    columns = [np.array(column) for column in zip(*(s[2:] for s in samples), strict=True)]
    if peer:
        peer.ask(do="prepare", samples=samples)

    def one_by_one() -> None:
        set_transform = BufferCore().set_transform
        for transform in stamped:
            set_transform(transform, "me")

    one, bulk, theirs = [], [], []
    for _ in range(rounds):
        one.append(timed(one_by_one))
        bulk.append(timed(lambda: BufferCore().set_transforms("a", "b", *columns, "me")))
        if peer:
            theirs.append(peer.ask(do="ingest")["seconds"])
    table.row("set_transform", one, {"tf2_py": theirs}, n, {"tf2_py": 2.0})
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
    options = parser.parse_args()
    sizes = [10**4] if options.quick else [10**4, 10**5, 10**6]
    table, peer = Table(), tf2_py()
    scalar_lookups(table, peer, options.rounds, 5000)
    batch_lookups(table, peer, options.rounds, sizes)
    ingest(table, peer, options.rounds, 10**4)
    growth(3, [10**3, 10**4, 10**5, 10**6])
    import_time(options.rounds)
    if peer:
        peer.close()
    print("\nGoals missed:", *(table.missed or ["none"]), sep="\n  ")


if __name__ == "__main__":
    main()
