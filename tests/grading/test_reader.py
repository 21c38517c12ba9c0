"""A file that was handed in becomes strings, or one line that says why not."""

from __future__ import annotations

import json
import os
import socket
import struct
from pathlib import Path

import pytest

from tflab.grading.kernels.wire import Wire, WireFault
from tflab.grading.submissions import reader
from tflab.grading.submissions.reader import Unreadable, read_bytes, read_notebook, strip_outputs

ANSWER = {"cell_type": "code", "id": "e3-2-answer", "metadata": {}, "source": "x = '좌표계'"}


def notebook(*cells: object, **more: object) -> dict:
    return {"cells": list(cells) or [ANSWER], "metadata": {}, "nbformat": 4, "nbformat_minor": 5, **more}


def as_bytes(page: object, encoding: str = "utf-8") -> bytes:
    return json.dumps(page, ensure_ascii=False).encode(encoding)


def only_source(data: bytes) -> str:
    (cell,) = read_notebook(data).cells
    return cell.source


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "cp949"])
def test_a_notebook_is_read_in_the_encodings_that_editors_write(encoding: str) -> None:
    read = read_notebook(as_bytes(notebook(), encoding))
    assert [cell.source for cell in read.cells] == ["x = '좌표계'"]
    remarks = [] if encoding.startswith("utf-8") else [f"it is written in {encoding}, not in UTF-8"]
    assert [remark.say("en") for remark in read.remarks] == remarks


def test_what_editors_and_old_machines_write_oddly_is_read() -> None:
    unknown = as_bytes(notebook(ANSWER | {"source": "x = 1  # AB"})).replace(b"AB", b"\xff\xc3")
    assert only_source(unknown).startswith("x = 1  # ")
    twice = b'{"cells": [{"cell_type": "code", "source": "x = 1", "source": "x = 2"}]}'
    assert only_source(twice) == "x = 2"  # as Jupyter has it
    assert only_source(b'{"a": NaN, "b": -Infinity, "c": ' + b"9" * 10_000 + b', "cells": [{"source": "x"}]}') == "x"
    for end in (b"\0", b"\0" * 500, b"\x1a", b"\n\x1a"):
        assert read_notebook(b'{"cells": [], "nbformat": 4}' + end).cells == ()


def test_the_third_format_has_its_cells_in_worksheets_and_their_text_in_input() -> None:
    cell = {
        "cell_type": "code",
        "input": ["x = 1\n", "y = 2"],
        "metadata": {"tflab": {"task": "E3.2"}, "tags": ["answer"]},
    }
    (read,) = read_notebook(as_bytes({"nbformat": 3, "worksheets": [{"cells": [cell]}]})).cells
    assert read.source == "x = 1\ny = 2"
    assert read.claims == ("e3-2-answer",)


def test_a_cell_claims_its_name_before_its_place_in_a_task_before_its_id() -> None:
    def claims(**more: object) -> tuple[str, ...]:
        (cell,) = read_notebook(as_bytes(notebook(ANSWER | more))).cells
        return cell.claims

    metadata = {"name": "one", "tflab": {"task": "E3.2"}, "tags": ["answer"], "nbgrader": {"grade_id": "three"}}
    assert claims(metadata=metadata, id="four") == ("one", "e3-2-answer", "three", "four")
    for odd in (None, [], 3, "x", {"tags": 3}, {"tags": [3]}, {"tflab": []}, {"tflab": {"task": 3}}):
        assert claims(metadata=odd) == ("e3-2-answer",)
    for identity in (None, 3, [], "", "x" * 101):
        assert claims(id=identity) == ()


@pytest.mark.parametrize(
    ("source", "text"),
    [
        ("a\r\nb", "a\nb"),
        ("a\0b", "ab"),
        (None, ""),
        (3, ""),
        (["a", 3, None, ["b"]], "a"),
        ({"a": 1}, ""),
        ("\ud800", "?"),
    ],
)
def test_a_source_is_text_whatever_it_was(source: object, text: str) -> None:
    data = json.dumps(notebook(ANSWER | {"source": source})).encode()
    assert only_source(data) == text


def test_what_is_no_cell_is_left_out_and_remarked() -> None:
    read = read_notebook(as_bytes(notebook(ANSWER, 3, None, "x")))
    assert len(read.cells) == 1
    assert [one.say("en") for one in read.remarks] == ["3 of its cells are not valid cells and were left out"]


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "empty"),
        (b"\0\0\0", "empty"),
        (b"PK\x03\x04...", "zip"),
        (b"not json", "no valid JSON, line 1"),
        (b'{"cells": [', "no valid JSON"),
        (b"[]", "no cells"),
        (b"3", "no cells"),
        (b'{"cells": 3}', "no cells"),
        (b"[" * 500_000 + b"]" * 500_000, "nested too deep"),
        (b"[" + b"[]," * 1_100_000 + b"[]]", "millions of lists"),
        (as_bytes({"cells": [{}] * 10_001}), "10001 cells"),
    ],
)
def test_what_is_no_notebook_is_one_line(data: bytes, why: str) -> None:
    with pytest.raises(Unreadable, match=why) as caught:
        read_notebook(data)
    assert "\n" not in str(caught.value)
    assert caught.value.remark.say("ko") != caught.value.remark.say("en") == str(caught.value)


def test_the_stamp_is_text_only() -> None:
    stamp = {"learner": "s101", "release": 3, "version": None, "chapter": "x" * 300}
    read = read_notebook(as_bytes(notebook(metadata={"tflab": stamp})))
    assert read.stamp == {"learner": "s101", "chapter": "x" * 200}


def test_a_file_is_read_whole_and_what_is_no_file_or_too_large_is_not_read(tmp_path: Path) -> None:
    (tmp_path / "a.ipynb").write_bytes(b"abc")
    assert read_bytes(tmp_path / "a.ipynb") == b"abc"
    with (tmp_path / "large.ipynb").open("wb") as file:
        file.truncate(reader.MAX_BYTES + 1)
    (tmp_path / "link.ipynb").symlink_to(tmp_path / "a.ipynb")
    os.mkfifo(tmp_path / "pipe.ipynb")
    for name, why in (
        ("large.ipynb", "more than 100 MB"),
        ("link.ipynb", "a link"),
        ("pipe.ipynb", "not a regular file"),
        ("/dev/zero", "not a regular file"),
        ("/proc/self", "."),
        ("nowhere.ipynb", "."),
    ):
        with pytest.raises(Unreadable, match=why):
            read_bytes(tmp_path / name)


def nested(depth: int) -> bytes:
    """Return a notebook with so many lists in one another."""
    return as_bytes(notebook()).replace(
        b'"metadata": {}', b'"metadata": {"x": ' + b"[" * depth + b"]" * depth + b"}", 1
    )


def test_what_is_nested_deeper_than_any_notebook_is_refused() -> None:
    assert len(read_notebook(nested(60)).cells) == 1
    for depth in (201, 5000, 100_000):
        with pytest.raises(Unreadable, match="nested too deep"):
            read_notebook(nested(depth))


@pytest.mark.parametrize(("depth", "is_read"), [(100, True), (201, False), (20_000, False)])
def test_a_message_that_is_nested_too_deep_is_none(depth, is_read):
    ours, theirs = socket.socketpair()
    wire = Wire(ours, longest=1_000_000)
    body = b'{"content": ' + b"[" * depth + b"]" * depth + b"}"
    with ours, theirs:
        theirs.sendall(struct.pack("!I", len(body)) + body)
        if is_read:
            assert "content" in wire.receive(5.0)
        else:
            with pytest.raises(WireFault, match="TooDeep"):
                wire.receive(5.0)


def test_what_nobody_reads_counts_against_nobody() -> None:
    picture = {"data": {"image/png": "iVBOR" * 6_000_000, "text/plain": ["[{]" * 1000] * 3000}}
    cells = [
        {"cell_type": "code", "id": "a", "metadata": {}, "source": 'x = {"outputs": [1]}', "outputs": [picture]},
        {"cell_type": "markdown", "id": "b", "metadata": {}, "source": "# b", "attachments": {"p.png": [[]] * 600_000}},
        {"cell_type": "code", "id": "c", "metadata": {}, "outputs": [[]] * 600_000, "source": "y"},
    ]
    page = {"metadata": {"tflab": {"learner": "s1"}, "widgets": {"state": [[]] * 600_000}}, "cells": cells}
    read = read_notebook(as_bytes(page))
    assert [cell.source for cell in read.cells] == ['x = {"outputs": [1]}', "# b", "y"]
    assert read.stamp == {"learner": "s1"}


def test_what_is_dropped_is_dropped_only_where_it_is_a_list_or_an_object_under_its_name() -> None:
    for text in ('{"outputs": [', '"outputs": ]', '{"outputs": "x"}', '["outputs", [1]]', '{"outputs"', ""):
        assert strip_outputs(text) == text


def test_ten_thousand_cells_of_ones_own_and_too_much_to_read_are_cut_off_not_refused() -> None:
    cells = [{"cell_type": "code", "id": f"c{n}", "metadata": {}, "source": "#" * 199_000} for n in range(120)]
    assert len(read_notebook(as_bytes({"cells": cells})).cells) == 10
