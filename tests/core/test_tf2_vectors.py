"""The engine does what tf2 does, in 352 scenarios recorded from the real library (geometry2 0.39.1, C++)."""

from __future__ import annotations

import gzip
import hashlib
import json
import logging
import math
from pathlib import Path

import pytest

from tflab.core import BufferCore, StampedTransform, Transform, TransformException, Velocity
from tflab.core.velocity import lookup_velocity_as_tf2

VECTORS = Path(__file__).parent / "data" / "tf2_vectors.jsonl.gz"
SCENARIOS = {s["name"]: s for s in map(json.loads, gzip.decompress(VECTORS.read_bytes()).splitlines())}

# Upstream's cancel takes away the wrong callback, and a lookup past a frame named
# NO_PARENT gives a meaningless identity; neither is copied (see requests.py, walk.py).
NOT_COPIED = {"edge_requests_cancel_UPSTREAM_BUG", "edge_no_parent_name"}

CPP_NAMES = {
    "BackwardExtrapolationException": "past",
    "ForwardExtrapolationException": "future",
    "NoDataForExtrapolationException": "no_data",
}


class Player:
    """Plays one scenario on a BufferCore and compares every outcome."""

    def __init__(self, cache_time_ns: int, caplog: pytest.LogCaptureFixture) -> None:
        self.buffer = BufferCore(cache_time_ns)
        self.caplog = caplog
        self.events: list = []

    def play(self, op: dict) -> None:
        self.caplog.clear()
        self.events.clear()
        getattr(self, "op_" + op["op"])(op)
        logs = [["WARN" if r.levelname == "WARNING" else r.levelname, r.getMessage()] for r in self.caplog.records]
        assert logs == [[level, text.replace("-nan", "nan")] for level, text in op.get("logs", [])]
        assert self.events == op.get("events", [])

    # -- publishing

    def op_set(self, op: dict) -> None:
        stamped = StampedTransform(op["p"], op["c"], op["ns"], Transform(numbers(op["t"]), numbers(op["q"])))
        assert self.buffer.set_transform(stamped, op.get("auth", "auth"), op.get("static", False)) == op["ok"]

    def op_set_chain(self, op: dict) -> None:
        for i in range(1, op["n"] + 1):
            self.op_set({**op, "p": f"{op['prefix']}{i - 1}", "c": f"{op['prefix']}{i}"})

    def op_clear(self, op: dict) -> None:
        self.buffer.clear()

    # -- asking

    def op_lookup(self, op: dict) -> None:
        self.expect_transform(op, self.buffer.lookup_transform, op["target"], op["source"], op["ns"])

    def op_lookup_full(self, op: dict) -> None:
        self.expect_transform(op, self.buffer.lookup_transform_full, *full_arguments(op))

    def op_can(self, op: dict) -> None:
        assert self.buffer.why_not(op["target"], op["source"], op["ns"]) == (op["ok"], full_text(op, "msg"))
        assert self.buffer.can_transform(op["target"], op["source"], op["ns"]) == op["ok"]

    def op_can_full(self, op: dict) -> None:
        assert self.buffer.why_not_full(*full_arguments(op)) == (op["ok"], op["msg"])
        assert self.buffer.can_transform_full(*full_arguments(op)) == op["ok"]

    def op_lct(self, op: dict) -> None:
        if "err" in op:
            with pytest.raises(TransformException) as raised:
                self.buffer.latest_common_time_ns(op["target"], op["source"])
            expect_exception(raised.value, op["err"])
        else:
            assert self.buffer.latest_common_time_ns(op["target"], op["source"]) == op["time_ns"]

    def op_request(self, op: dict) -> None:
        handle = self.buffer.request_transformable(
            op["target"], op["source"], op["ns"], lambda *event: self.events.append(list(event))
        )
        assert handle == op["handle"]

    def op_cancel(self, op: dict) -> None:
        self.buffer.cancel_request(op["handle"])

    # -- looking inside

    def op_yaml(self, op: dict) -> None:
        expect_text(self.buffer.all_frames_as_yaml(op["ns"] or None), op)

    def op_string(self, op: dict) -> None:
        expect_text(self.buffer.all_frames_as_string(), op)

    def op_dot(self, op: dict) -> None:
        expect_text(self.buffer.all_frames_as_dot(op["ns"] or None), op)

    def op_frames(self, op: dict) -> None:
        assert self.buffer.frame_names() == op["names"]

    def op_exists(self, op: dict) -> None:
        assert self.buffer.frame_exists(op["frame"]) == op["ok"]

    def op_number(self, op: dict) -> None:
        assert self.buffer.frame_number(op["frame"]) == op["id"]

    def op_parent(self, op: dict) -> None:
        assert self.buffer.parent_of(op["frame"], op["ns"]) == op["parent"]

    def op_chain(self, op: dict) -> None:
        """Upstream's list is erratic, so ours is its own: see test_buffer.py."""

    def op_velocity(self, op: dict) -> None:
        arguments = (op["tracking"], op["observation"], op["ns"], op["avg_ns"])
        if "err" in op:
            for lookup in (self.buffer.lookup_velocity, self.velocity_as_tf2):
                with pytest.raises(TransformException) as raised:
                    lookup(*arguments)
                expect_exception(raised.value, op["err"])
            return
        velocity, out = self.velocity_as_tf2(*arguments), op["out"]
        assert (velocity.frame_id, velocity.body_frame_id) == (out["frame_id"], out["body_frame_id"])
        assert abs(velocity.stamp_ns - out["stamp_ns"]) <= 1  # tf2 reckons in float seconds here
        assert close(velocity.linear, numbers(out["linear"]))
        assert close(velocity.angular, numbers(out["angular"]))

    def velocity_as_tf2(self, *arguments) -> Velocity:
        return lookup_velocity_as_tf2(self.buffer.lookup_transform, self.buffer.latest_common_time_ns, *arguments)

    # -- comparing

    def expect_transform(self, op: dict, lookup, *arguments) -> None:
        if "err" in op:
            with pytest.raises(TransformException) as raised:
                lookup(*arguments)
            expect_exception(raised.value, op["err"])
            return
        result, out = lookup(*arguments), op["out"]
        assert (result.frame_id, result.child_frame_id) == (out["frame_id"], out["child_frame_id"])
        assert as_in_header(result.stamp_ns) == out["stamp_ns"]
        assert close(result.transform.translation, numbers(out["t"]))
        rotation, expected = result.transform.rotation, numbers(out["q"])
        assert close(rotation, expected) or (
            hangs_on_the_last_digit(expected) and close(tuple(-c for c in rotation), expected)
        )


@pytest.mark.parametrize("name", sorted(set(SCENARIOS) - NOT_COPIED))
def test_every_outcome_is_that_of_tf2(name: str, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG, logger="tflab.tf2")
    player = Player(SCENARIOS[name]["cache_time_ns"], caplog)
    for op in SCENARIOS[name]["ops"]:
        player.play(op)


def numbers(values: list) -> tuple[float, ...]:
    return tuple(map(float, values))


def full_arguments(op: dict) -> tuple:
    return op["target"], op["target_ns"], op["source"], op["source_ns"], op["fixed"]


def close(got: tuple, want: tuple) -> bool:
    return all(
        (math.isnan(a) and math.isnan(b)) or a == b or abs(a - b) <= 1e-9 * max(1.0, abs(b))
        for a, b in zip(got, want, strict=True)
    )


def hangs_on_the_last_digit(q: tuple) -> bool:
    """Return whether the choice between q and -q depends on rounding."""
    squares = sorted(c * c for c in q[:3])
    return abs(4.0 * q[3] * q[3] - 1.0) < 1e-9 or squares[2] - squares[1] < 1e-9


def as_in_header(stamp_ns: int) -> int:
    """Return a stamp after it went through a message: 32-bit seconds, and nanoseconds of the unsigned number."""
    seconds = int(abs(stamp_ns) // 10**9) * (1 if stamp_ns >= 0 else -1)
    seconds = (seconds + 2**31) % 2**32 - 2**31
    return seconds * 10**9 + (stamp_ns % 2**64) % 10**9


def expect_exception(error: TransformException, expected: dict) -> None:
    cpp_name = expected["cls"]
    if cpp_name in CPP_NAMES:
        assert (type(error).__name__, error.direction) == ("ExtrapolationException", CPP_NAMES[cpp_name])
    else:
        assert type(error).__name__ == cpp_name
    expect_text(str(error), expected, "msg")


def full_text(op: dict, key: str) -> str | Text:
    return op[key] if key in op else Text(op[key + "_sha256"], op[key + "_len"])


class Text(str):
    """A long text of which only the fingerprint was kept; equal to the text that has it."""

    def __new__(cls, sha256: str, length: int) -> Text:
        text = super().__new__(cls, sha256)
        text.length = length
        return text

    def __eq__(self, other: object) -> bool:
        return len(other) == self.length and hashlib.sha256(other.encode()).hexdigest() == str.__str__(self)

    __hash__ = str.__hash__


def expect_text(text: str, op: dict, key: str = "text") -> None:
    if key in op:
        assert text == op[key]
    else:
        assert text.startswith(op[key + "_head"])
        assert full_text(op, key) == text
