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
    assert only_source(as_bytes(notebook(), encoding)) == "x = '좌표계'"


def test_another_encoding_than_utf_8_is_remarked() -> None:
    assert read_notebook(as_bytes(notebook())).remarks == ()
    (remark,) = read_notebook(as_bytes(notebook(), "cp949")).remarks
    assert "cp949" in remark.say("en") and "cp949" in remark.say("ko")


def test_letters_of_no_encoding_cost_those_letters_only() -> None:
    data = as_bytes(notebook(ANSWER | {"source": "x = 1  # AB"})).replace(b"AB", b"\xff\xc3")
    assert only_source(data).startswith("x = 1  # ")


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
    metadata = {"name": "one", "tflab": {"task": "E3.2"}, "tags": ["answer"], "nbgrader": {"grade_id": "three"}}
    (cell,) = read_notebook(as_bytes(notebook(ANSWER | {"metadata": metadata, "id": "four"}))).cells
    assert cell.claims == ("one", "e3-2-answer", "three", "four")


@pytest.mark.parametrize(
    ("source", "text"),
    [
        (["a\n", "b"], "a\nb"),
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


@pytest.mark.parametrize(
    "metadata", [None, [], 3, "x", {"tags": 3}, {"tags": [3]}, {"tflab": []}, {"tflab": {"task": 3}}]
)
def test_metadata_of_any_type_is_survived(metadata: object) -> None:
    (cell,) = read_notebook(as_bytes(notebook(ANSWER | {"metadata": metadata}))).cells
    assert cell.claims == ("e3-2-answer",)


@pytest.mark.parametrize("identity", [None, 3, [], "", "x" * 101])
def test_an_id_that_is_none_is_no_claim(identity: object) -> None:
    (cell,) = read_notebook(as_bytes(notebook(ANSWER | {"id": identity}))).cells
    assert cell.claims == ()


def test_what_is_no_cell_is_left_out_and_remarked() -> None:
    read = read_notebook(as_bytes(notebook(ANSWER, 3, None, "x")))
    assert len(read.cells) == 1
    assert [one.say("en") for one in read.remarks] == ["3 of its cells are no cells, and are left out"]


def test_of_a_key_that_is_there_twice_the_last_counts_as_jupyter_has_it() -> None:
    assert only_source(b'{"cells": [{"cell_type": "code", "source": "x = 1", "source": "x = 2"}]}') == "x = 2"


def test_numbers_that_json_does_not_know_are_survived() -> None:
    data = b'{"a": NaN, "b": -Infinity, "c": ' + b"9" * 10_000 + b', "cells": [{"source": "x"}]}'
    assert only_source(data) == "x"


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


def test_a_file_is_read_whole(tmp_path: Path) -> None:
    (tmp_path / "a.ipynb").write_bytes(b"abc")
    assert read_bytes(tmp_path / "a.ipynb") == b"abc"


def test_a_file_above_the_limit_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "a.ipynb").open("wb") as file:
        file.truncate(reader.MAX_BYTES + 1)
    with pytest.raises(Unreadable, match="more than 100 MB"):
        read_bytes(tmp_path / "a.ipynb")


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("secret")
    (tmp_path / "a.ipynb").symlink_to(tmp_path / "secret")
    with pytest.raises(Unreadable, match="a link"):
        read_bytes(tmp_path / "a.ipynb")


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.ipynb")
    with pytest.raises(Unreadable, match="not a regular file"):
        read_bytes(tmp_path / "a.ipynb")


@pytest.mark.parametrize("path", ["/dev/zero", "/proc/self", "/nowhere/a.ipynb"])
def test_devices_folders_and_nothing_are_no_files(path: str) -> None:
    with pytest.raises(Unreadable):
        read_bytes(Path(path))


def nested(depth: int) -> bytes:
    """Return a notebook with so many lists in one another."""
    return as_bytes(notebook()).replace(
        b'"metadata": {}', b'"metadata": {"x": ' + b"[" * depth + b"]" * depth + b"}", 1
    )


@pytest.mark.parametrize("depth", [201, 900, 5000, 100_000])
def test_what_is_nested_deeper_than_any_notebook_is_refused(depth):
    with pytest.raises(Unreadable, match="nested too deep"):
        read_notebook(nested(depth))


def test_what_is_nested_as_deep_as_a_picture_is_read():
    assert len(read_notebook(nested(60)).cells) == 1


@pytest.mark.parametrize(("depth", "is_read"), [(100, True), (201, False), (900, False), (20_000, False)])
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


@pytest.mark.parametrize("end", [b"\0", b"\0" * 500, b"\x1a", b"\n\x1a"])
def test_what_old_machines_put_behind_a_file_is_no_matter(end: bytes) -> None:
    assert read_notebook(b'{"cells": [], "nbformat": 4}' + end).cells == ()


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


@pytest.mark.parametrize(
    "text", ['{"outputs": [', '"outputs": ]', '{"outputs": "x"}', '["outputs", [1]]', '{"outputs"', ""]
)
def test_what_is_dropped_is_dropped_only_where_it_is_a_list_or_an_object_under_its_name(text: str) -> None:
    assert strip_outputs(text) == text


def test_ten_thousand_cells_of_ones_own_and_too_much_to_read_are_cut_off_not_refused() -> None:
    cells = [{"cell_type": "code", "id": f"c{n}", "metadata": {}, "source": "#" * 199_000} for n in range(120)]
    assert len(read_notebook(as_bytes({"cells": cells})).cells) == 10
