"""The reference implementation reproduces the recordings of tf2."""

from __future__ import annotations

import pytest

from tflab.core import Transform, TransformException
from tflab.core.plain import PlainBuffer

from .test_tf2_vectors import CPP_NAMES, SCENARIOS, numbers

# A frame called NO_PARENT, and a robot at infinity.
BEYOND_THE_PAGE = {"edge_no_parent_name", "pub_names_002", "pub_names_005", "pub_quat_015"}


@pytest.mark.parametrize("name", sorted(set(SCENARIOS) - BEYOND_THE_PAGE))
def test_the_plain_engine_answers_as_tf2(name: str) -> None:
    buffer = PlainBuffer(SCENARIOS[name]["cache_time_ns"])
    for op in SCENARIOS[name]["ops"]:
        play(buffer, op)


def play(buffer: PlainBuffer, op: dict) -> None:
    match op["op"]:
        case "set":
            publish(buffer, op, op["p"], op["c"])
        case "set_chain":
            for i in range(1, op["n"] + 1):
                publish(buffer, op, f"{op['prefix']}{i - 1}", f"{op['prefix']}{i}")
        case "clear":
            buffer.clear()
        case "lookup":
            kind, answer = outcome(buffer.lookup_transform, op["target"], op["source"], op["ns"])
            assert kind == expected_kind(op)
            if kind == "":
                same_place(answer[1], op["out"])
        case "can":
            kind, _ = outcome(buffer.lookup_transform, op["target"], op["source"], op["ns"])
            assert (kind == "") == op["ok"]
        case "lct":
            kind, answer = outcome(buffer.latest_common_time, op["target"], op["source"])
            assert (kind == "") == ("err" not in op)
            assert answer == op.get("time_ns")


def publish(buffer: PlainBuffer, op: dict, parent: str, child: str) -> None:
    transform = Transform(numbers(op["t"]), numbers(op["q"]))
    assert buffer.set_transform(parent, child, op["ns"], transform, op.get("static", False)) == op["ok"]


def outcome(ask, *arguments) -> tuple[str, object]:
    """Return ("", the answer), or the kind of failure and None."""
    try:
        return "", ask(*arguments)
    except TransformException as error:
        return getattr(error, "direction", "") or type(error).__name__, None


def expected_kind(op: dict) -> str:
    name = op["err"]["cls"] if "err" in op else ""
    return CPP_NAMES.get(name, name)


def same_place(got: Transform, out: dict) -> None:
    assert got.translation == pytest.approx(numbers(out["t"]), rel=1e-9, abs=1e-9, nan_ok=True)
    same = sum(a * b for a, b in zip(got.rotation, numbers(out["q"]), strict=True))
    assert abs(same) == pytest.approx(1.0, abs=1e-9)
