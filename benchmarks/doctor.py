"""How often is the doctor right, and how fast?

    python benchmarks/doctor.py matrix [BAG ...] [--seeds 20]    every fault, in simulated runs and in the bags
    python benchmarks/doctor.py speed [--transforms 1000000]     a large bag: time and memory

The matrix has a row for each fault that was put in and a column for each fault
that was named above "info".  A finding that names the injected fault counts for
recall; one that names none of the injected faults counts against precision.
"""

from __future__ import annotations

import argparse
import math
import resource
import struct
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np
from planted import CODES_OF_PLANT, PLANTS, with_records, with_transforms_of_odometry
from tqdm import tqdm

from tflab.bags.reader import read_bag
from tflab.bags.recording import Headers, Recording, recording_from_records
from tflab.core.transforms import TransformRecord
from tflab.doctor.collect_evidence import evidence_from_recording
from tflab.doctor.diagnose import diagnose_recording
from tflab.doctor.lookups import lookups_of
from tflab.doctor.report.sentences import faults_of_code
from tflab.robots.faults.catalogue import Fault
from tflab.robots.faults.inject import CannotInject, inject
from tflab.robots.teaching import TeachingRobot

SECONDS_FOR_A_MILLION = 20.0
LEAST = 0.95  # of recall and of precision
SILENCES = {"gap", "stall", "tf-silent", "went-silent"}  # one event is one of them, whoever else fell silent


@dataclass
class Row:
    """How often a fault was put in, how often it was named, and what else was."""

    cases: int = 0
    right: int = 0
    wrong: Counter = field(default_factory=Counter)

    def count(self, fault: str, found: set[str]) -> None:
        self.cases += 1
        self.right += fault in found if fault else not found
        self.wrong.update(str(other) for other in sorted(found - {fault}))

    @property
    def recall(self) -> float:
        return self.right / self.cases

    @property
    def precision(self) -> float:
        return self.right / max(self.right + self.wrong.total(), 1)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    matrix = commands.add_parser("matrix")
    matrix.add_argument("bags", nargs="*", type=Path)
    matrix.add_argument("--seeds", type=int, default=20)
    matrix.add_argument("--first-seed", type=int, default=0, help="measure on seeds that nobody has looked at")
    matrix.add_argument("--verbose", action="store_true", help="tell each miss")
    speed = commands.add_parser("speed")
    speed.add_argument("--transforms", type=int, default=1_000_000)
    arguments = parser.parse_args()
    if arguments.command == "matrix":
        return run_matrix(
            arguments.bags,
            range(arguments.first_seed, arguments.first_seed + arguments.seeds),
            arguments.verbose,
        )
    return run_speed(arguments.transforms)


def run_matrix(bags: list[Path], seeds: range, verbose: bool) -> int:
    """Print how often each fault is named, in simulated runs and in the bags, and return 1 if it is not good enough."""
    rows: dict[str, Row] = {}
    for name, clean in (("simulated", simulated_run), ("simulated, on another clock", other_clock)):
        confusion(name, lambda seed, clean=clean: recording_from_records(clean(seed)), seeds, rows, verbose)
    is_good = print_matrix("simulated runs", rows)
    rows = {}
    for bag in bags:
        recording = with_transforms_of_odometry(read_bag(bag))
        confusion(bag.name, lambda _, recording=recording: recording, seeds, rows, verbose)
    return 0 if (not bags or print_matrix("the bags", rows)) and is_good else 1


def simulated_run(seed: int) -> list[TransformRecord]:
    """Return a clean run of the teaching robot; every other one without publishers, as in a rosbag2."""
    records = TeachingRobot(seed=seed).records(until_s=20.0)
    return records if seed % 2 else [record._replace(publisher="") for record in records]


def other_clock(seed: int) -> list[TransformRecord]:
    """Return a clean run in simulated time, which is years behind the recorder's clock and drifts."""
    records = simulated_run(seed)
    return [r._replace(receive_ns=1_700_000_000_000_000_000 + round(1.0001 * r.receive_ns)) for r in records]


def confusion(name: str, clean, seeds: range, rows: dict[str, Row], verbose: bool) -> None:
    """Count, for each fault that can be put in, how often which faults were named.

    What the clean recording is said to have natively is not counted for or against.
    """
    kinds: dict[str, Callable] = {str(fault): partial(injected, fault=fault) for fault in Fault} | PLANTS
    with tqdm(desc=name, total=len(kinds) * len(seeds), leave=False, disable=None) as progress:
        for seed in seeds:
            recording = clean(seed)
            native = found_in(recording)
            if seed == seeds[0]:
                rows.setdefault("(clean)", Row()).count("", {code for code, *_ in native})
                print(*([f"{name} natively: {sorted({code for code, *_ in native})}"] if native else ()))
            for kind, plant in kinds.items():
                progress.update()
                try:
                    broken, detail = plant(recording, seed)
                except CannotInject:
                    continue
                found = named(found_in(broken), native, kind)
                rows.setdefault(kind, Row()).count(kind, found)
                if verbose and found != {kind}:
                    print(f"{name} seed {seed}: {kind}: {detail}: {sorted(found)}", file=sys.stderr)


def injected(recording: Recording, seed: int, fault: Fault) -> tuple[Recording, str]:
    """Return a recording with a fault of the catalogue in its transforms, and the other topics as they were."""
    records, diagnosis = inject(recording.records(), fault, seed)
    return with_records(recording, records), diagnosis.detail


def found_in(recording: Recording) -> set[tuple]:
    """Return (code, child, topic, when, how often) of each finding above "info", and of what it explains."""
    told = diagnose_recording(recording).of_severity("error", "warning")
    return {
        (f.code, f.child, f.topic, f.begin_ns // 100_000_000, f.facts.get("times"), f in told)
        for finding in told
        for f in (finding, *finding.effects)
    }


def named(found: set[tuple], native: set[tuple], kind: str) -> set[str]:
    """Return what findings name; of several faults that one names, the one that was put in if it is among them.

    What a recording has natively counts neither for nor against: it stays what it
    is if it is only told of other edges, or more often.
    """
    native_codes = {code for code, *_ in native}
    if native_codes & SILENCES:
        native_codes |= SILENCES
    names = set()
    for code, *_, is_told in found - native:
        faults = [str(fault) for fault in faults_of_code(code)]
        faults += [name for name, codes in CODES_OF_PLANT.items() if code in codes]
        if is_told and kind in faults:
            names.add(kind)
        elif is_told and code not in native_codes:
            names.add(faults[0] if faults else code)
    return names


def print_matrix(name: str, rows: dict[str, Row]) -> bool:
    """Print one matrix with recall and precision, and return whether both are at least 0.95 everywhere."""
    print(f"\n{name}\n  {'injected':22s} {'cases':>5s} {'recall':>7s} {'precision':>9s}   also named")
    for fault, row in rows.items():
        print(f"  {fault:22s} {row.cases:5d} {row.recall:7.3f} {row.precision:9.3f}   {dict(row.wrong) or ''}")
    totals = [(row.cases, row.right, row.wrong.total()) for row in rows.values()]
    cases, right, wrong = (sum(values) for values in zip(*totals, strict=True))
    print(f"  {'all':22s} {cases:5d} {right / cases:7.3f} {right / max(right + wrong, 1):9.3f}")
    return all(min(row.recall, row.precision) >= LEAST for row in rows.values())


def run_speed(transforms: int) -> int:
    """Write a bag with so many transforms, one a message, and examine it; return 1 if that is too slow."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "large"
        write_large_bag(path, transforms)
        size_mb = sum(file.stat().st_size for file in path.iterdir()) / 1e6
        subprocess.run([sys.executable, "-m", "tflab", "doctor", path, "--edges"], check=False)
        lookups_s = seconds_for_lookups(read_bag(path), 15, transforms // 50)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds, memory_mb = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
    print(f"{transforms} transforms, {size_mb:.0f} MB")
    print(f"file to report  {seconds:6.1f} s of one core, {transforms / seconds:8.0f} transforms a second")
    print(f"memory          {memory_mb:6.0f} MB")
    print(f"lookups         {lookups_s:6.2f} s of one core, of {15 * (transforms // 50)} messages of 15 topics")
    return 0 if seconds < SECONDS_FOR_A_MILLION * max(transforms / 1e6, 1.0) and memory_mb < 1024 else 1


def seconds_for_lookups(recording: Recording, topics: int, messages: int) -> float:
    """Return how long the table of lookups takes for messages in the frames of the joints [s of CPU]."""
    span = (recording.begin_ns, recording.end_ns, messages)
    stamp_ns, frame = np.linspace(*span).astype(np.int64), np.zeros(messages, dtype=int)
    headers = tuple(
        Headers(f"/scan_{i}", "sensor_msgs/msg/LaserScan", stamp_ns + 5_000_000, stamp_ns, frame, (f"joint_{i % 8}",))
        for i in range(topics)
    )
    evidence = evidence_from_recording(replace(recording, headers=headers))
    begin = time.process_time()
    lookups_of(evidence)
    return time.process_time() - begin


def write_large_bag(path: Path, transforms: int) -> None:
    """Write a mast on a robot with eight joints, a thousand messages a second, one transform in each."""
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_JAZZY)
    message_types = store.types
    edges = [("map", "odom"), ("odom", "base_link"), *(("base_link", f"joint_{i}") for i in range(8))]
    templates = [cdr_template(store, message_types, parent, child) for parent, child in edges]
    with Writer(path, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connection = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store)
        for i in range(transforms):
            step, edge = divmod(i, len(edges))
            stamp_ns = 1_700_000_000_000_000_000 + step * 10_000_000
            angle = 0.001 * step * (edge + 1)
            data = bytearray(templates[edge])
            struct.pack_into("<iI", data, 8, *divmod(stamp_ns, 1_000_000_000))
            pose = (math.cos(angle), math.sin(angle), 0.0, 0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2))
            struct.pack_into("<7d", data, len(data) - 56, *pose)
            writer.write(connection, stamp_ns + 3_000_000 + step * 7919 % 13 * 100_000, data)


def cdr_template(store, types: dict, parent: str, child: str) -> bytes:
    """Return a TFMessage of one transform, as rosbags writes it; its last 56 bytes are the seven numbers."""
    header = types["std_msgs/msg/Header"](types["builtin_interfaces/msg/Time"](0, 0), parent)
    transform = types["geometry_msgs/msg/Transform"](
        types["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0), types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
    )
    stamped = types["geometry_msgs/msg/TransformStamped"](header, child, transform)
    return bytes(store.serialize_cdr(types["tf2_msgs/msg/TFMessage"]([stamped]), "tf2_msgs/msg/TFMessage"))


if __name__ == "__main__":
    sys.exit(main())
