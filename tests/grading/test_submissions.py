"""What a learning system exports is sorted: who handed in what, and what is refused."""

from __future__ import annotations

import io
import os
import stat
import unicodedata
import zipfile
from pathlib import Path

import pytest
import yaml

from tflab.grading.submissions import archives
from tflab.grading.submissions import collect as collecting
from tflab.grading.submissions.archives import archive_members, safe_parts
from tflab.grading.submissions.collect import Collection
from tflab.grading.submissions.reader import Unreadable
from tflab.grading.submissions.roster import Learner

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

CHAPTERS = ["02_axes", "03_tiny"]
ROSTER = {"s101": Learner("s101", "Kim Minji", "ko"), "s102": Learner("s102", "Ada Byron"), "7": Learner("7", "Lee")}


def collect(place: Path, roster: dict | None, chapters: list[str], leave_out: list[Path] = []) -> Collection:  # noqa: B006
    return collecting.collect(
        place, roster, chapters, leave_out, is_genuine=lambda stamp: not stamp.get("seal", "").startswith("forged")
    )


def put(folder: Path, *names: str, data: bytes = b"{}") -> Path:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return folder


def zipped(path: Path, files: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return path


def who(collection: Collection) -> dict[str, list[str]]:
    return {one.learner: ["/".join(member.parts) for member in one.notebooks] for one in collection.submissions}


def remarks_of(collection: Collection, learner: str) -> tuple[str, ...]:
    remarks = next(one.remarks for one in collection.submissions if one.learner == learner)
    return tuple(remark.say("en").rstrip(".") for remark in remarks)


@pytest.mark.parametrize("name", CASES["places"])
def test_a_learner_is_known_by_where_the_file_is(tmp_path: Path, name: str) -> None:
    put(tmp_path, name, "s102/03_tiny.ipynb" if "submitted" not in name else "submitted/s102/03_tiny.ipynb")
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert len(found["s101"]) == len(found["s102"]) == 1


def test_everybody_on_the_roster_has_one_place_in_its_order_and_strangers_come_after_them(tmp_path: Path) -> None:
    put(tmp_path, "a-stranger/03_tiny.ipynb", "s102/03_tiny.ipynb")
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    assert list(who(collection)) == ["s101", "s102", "7", "a-stranger"]
    assert remarks_of(collection, "7") == ("nothing was handed in",)
    assert "nobody on the roster" in remarks_of(collection, "a-stranger")[0]
    assert [one.known for one in collection.submissions] == [True, True, True, False]


def test_without_a_roster_learners_go_by_their_folders_and_files(tmp_path: Path) -> None:
    put(tmp_path, "ada/03_tiny.ipynb", "bob.ipynb", "03_tiny_eve.ipynb")
    assert sorted(who(collect(tmp_path, None, CHAPTERS))) == ["ada", "bob", "eve"]
    assert who(collect(tmp_path / "bob.ipynb", None, CHAPTERS)) == {"bob": ["bob.ipynb"]}


def test_an_empty_folder_and_one_without_a_notebook_are_a_line_each(tmp_path: Path) -> None:
    (tmp_path / "s101").mkdir()
    put(tmp_path, "s102/answers.docx", "s102/a.pdf")
    put(tmp_path, "HW1_7_attempt_1_03_tiny.ipynb", "HW1_7_attempt_1.txt", "7/desktop.ini")  # not worth a line
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    assert remarks_of(collection, "s101") == ("an empty folder",)
    assert remarks_of(collection, "s102") == ("no notebook was found, only a.pdf, answers.docx",)
    assert remarks_of(collection, "7") == ()
    with pytest.raises(Unreadable, match="there is no"):
        collect(tmp_path / "nowhere", ROSTER, CHAPTERS)


def test_checkpoints_and_pristine_copies_are_not_the_learners_work(tmp_path: Path) -> None:
    put(tmp_path, "s101/03_tiny.ipynb.txt", "s101/.ipynb_checkpoints/03_tiny-checkpoint.ipynb", "s102/03_tiny.IPYNB")
    put(tmp_path, "s101/.tflab/pristine/03_tiny.ipynb", "__MACOSX/s101/._03_tiny.ipynb")
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert (found["s101"], found["s102"]) == (["s101/03_tiny.ipynb.txt"], ["s102/03_tiny.IPYNB"])


def test_a_link_to_a_folder_is_not_entered(tmp_path: Path) -> None:
    put(tmp_path / "elsewhere", "03_tiny.ipynb")
    put(tmp_path / "in", "s101/03_tiny.ipynb")
    (tmp_path / "in" / "s102").symlink_to(tmp_path / "elsewhere")
    collection = collect(tmp_path / "in", ROSTER, CHAPTERS)
    assert who(collection)["s102"] == []
    assert [remark.say("en") for remark in collection.remarks] == ["s102: a link to another folder; left out."]


@pytest.mark.parametrize("folder", ["", "hw1/"])
def test_a_zip_is_read_as_the_folder_it_was(tmp_path: Path, folder: str) -> None:
    files = {f"{folder}kimminji_1_2_03_tiny.ipynb": b"{}", f"{folder}s102/03_tiny.ipynb": b"[]"}
    collection = collect(zipped(tmp_path / "all.zip", files), ROSTER, CHAPTERS)
    assert who(collection)["s101"] and who(collection)["s102"]
    assert [one.notebooks[0].read() for one in collection.submissions if one.learner == "s102"] == [b"[]"]


def test_a_learners_own_zip_is_opened_and_a_zip_in_it_too(tmp_path: Path) -> None:
    inner = a_zip(**{"exercises__03_tiny.ipynb": b"{}"})
    put(tmp_path, "Kim Minji_1_assignsubmission_file_/my work.zip", data=a_zip(**{"b.zip": inner}))
    put(tmp_path, "s102.zip", data=inner)
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert [len(found[learner]) for learner in ("s101", "s102")] == [1, 1]


def test_a_broken_zip_costs_its_learner_only(tmp_path: Path) -> None:
    put(tmp_path, "s101.zip", "s102/03_tiny.ipynb", data=b"PK nonsense")
    os.mkfifo(tmp_path / "7.zip")
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    said = sorted(remark.say("en") for remark in collection.remarks)
    assert said[0].endswith("not a file.") and said[1].startswith("s101.zip: not a zip file")
    assert who(collection)["s102"]


@pytest.mark.parametrize("name", ["../out.ipynb", "a/../../out.ipynb", "/etc/x.ipynb", "C:\\x.ipynb", "..\\x.ipynb"])
def test_a_name_that_leads_out_is_refused_and_so_is_a_link(tmp_path: Path, name: str) -> None:
    with zipfile.ZipFile(tmp_path / "all.zip", "w") as archive:
        link = zipfile.ZipInfo("s101/03_tiny.ipynb")
        link.create_system, link.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
        archive.writestr(link, "/etc/passwd")
        archive.writestr(name, b"{}")
        archive.writestr("s102/./x//03_tiny.ipynb", b"{}")
    members, refused = archive_members(tmp_path / "all.zip")
    assert [member.parts for member in members] == [("s102", "x", "03_tiny.ipynb")]
    said = [remark.say("en") for remark in refused]
    assert said[0] == "s101/03_tiny.ipynb: a link to another file; refused."
    assert len(said) == 2 and "leads out of the archive; refused" in said[1]


def test_a_name_of_nothing_has_no_parts() -> None:
    assert [safe_parts(name) for name in ("", "/", ".", "a\0b")] == [None] * 4


def test_a_damaged_member_costs_itself_only(tmp_path: Path) -> None:
    path = zipped(tmp_path / "all.zip", {"s101.ipynb": b"x" * 5000, "s102.ipynb": b"{}"})
    data = bytearray(path.read_bytes())
    data[45:60] = bytes(15)  # in the middle of the first
    path.write_bytes(data)
    first, second = archive_members(path)[0]
    with pytest.raises(Unreadable, match="damaged"):
        first.read()
    assert second.read() == b"{}"


@pytest.mark.parametrize("encoding", ["cp949", "utf-8"])
def test_korean_names_are_read_as_they_were_written(tmp_path: Path, encoding: str) -> None:
    name = "김민지.ipynb".encode(encoding)
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr("X" * len(name), b"{}")
    path = tmp_path / "all.zip"
    path.write_bytes(buffer.getvalue().replace(b"X" * len(name), name))
    assert archive_members(path)[0][0].parts == ("김민지.ipynb",)


def test_a_stamp_never_adds_to_what_somebody_handed_in_themselves(tmp_path: Path) -> None:
    put(tmp_path, "s102/03_tiny.ipynb")
    put(tmp_path, "stranger/03_tiny.ipynb", data=b'{"metadata": {"tflab": {"learner": "s102"}}, "cells": []}')
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    assert who(collection)["s102"] == ["s102/03_tiny.ipynb"]
    assert remarks_of(collection, "stranger") == ('stamped for "s102", who handed in elsewhere; not graded for them',)


def test_the_results_and_the_pack_are_no_submissions_wherever_they_are(tmp_path: Path) -> None:
    put(tmp_path, "s101/03_tiny.ipynb", "results/feedback/x.ipynb", "pack/masters/03_tiny.ipynb")
    collection = collect(tmp_path, None, CHAPTERS, [tmp_path / "results", tmp_path / "pack"])
    assert list(who(collection)) == ["s101"]


@pytest.mark.parametrize("is_zip", [False, True])
def test_a_notebook_with_answers_is_found_behind_many_empty_ones(tmp_path: Path, is_zip: bool) -> None:
    names = [f"{number:04}.ipynb" for number in range(100)]
    put(tmp_path, "s102/03_tiny.ipynb")
    if is_zip:
        zipped(tmp_path / "s101.zip", dict.fromkeys(names, b"{}") | {"zz_03_tiny.ipynb": b'{"cells": []}'})
    else:
        put(put(tmp_path / "s101", *names, "node_modules/x.js"), "zz_03_tiny.ipynb", data=b'{"cells": []}')
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    found = who(collection)
    assert len(found["s101"]) == 60 and "s101/zz_03_tiny.ipynb" in found["s101"]
    assert remarks_of(collection, "s101") == ("more than 60 notebooks. Only the 60 largest were graded",)
    assert found["s102"] == ["s102/03_tiny.ipynb"]


@pytest.mark.parametrize("name", ["S101/03_tiny.ipynb", "s101 /03_tiny.ipynb", "s101./03_tiny.ipynb", "s101 .ipynb"])
def test_a_name_that_only_looks_like_an_id_brings_no_other_learners_work_into_that_place(
    tmp_path: Path, name: str
) -> None:
    stamped = b'{"cells": [], "metadata": {"tflab": {"learner": "s102", "seal": "ours"}}}'
    put(put(tmp_path, "s101/03_tiny.ipynb"), name, data=stamped)
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    assert who(collection)["s101"] == ["s101/03_tiny.ipynb"]
    assert sum(map(len, who(collection).values())) == 2  # and it is not lost


def test_without_a_roster_names_that_are_written_alike_are_several_people(tmp_path: Path) -> None:
    names = {"s0": "s0", "S0": "S0", "s0 (2)": "s0 ", "s0 (3)": "s0.", "a_b": "a*b", "a_b (2)": "a?b"}
    put(tmp_path, *(f"{folder}/03_tiny.ipynb" for folder in names.values()))
    found = who(collect(tmp_path, None, CHAPTERS))
    assert found == {name: [f"{folder}/03_tiny.ipynb"] for name, folder in names.items()}


def test_a_zip_that_is_forty_deep_is_said_once_and_read_no_further(tmp_path: Path) -> None:
    inner = b"{}"
    for level in range(40):
        held = io.BytesIO()
        with zipfile.ZipFile(held, "w") as archive:
            for copy in range(2):
                archive.writestr(f"{copy}_{level}.zip" if level else f"{copy}.ipynb", inner)
        inner = held.getvalue() if len(held.getvalue()) < 1 << 16 else inner
    (tmp_path / "s101.zip").write_bytes(inner)
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    said = [remark.say("en") for remark in collection.remarks]
    assert len([line for line in said if "a zip in a zip in a zip" in line]) == 1
    assert who(collection)["s101"] == []


def test_a_name_that_is_no_text_is_made_one(tmp_path: Path) -> None:
    folder = bytes(tmp_path) + b"/s101\xff\n\x1b[2J"
    Path(folder.decode("utf-8", "surrogateescape")).mkdir()
    put(tmp_path, "s102/03_tiny.ipynb")
    (one,) = [learner for learner in who(collect(tmp_path, None, CHAPTERS)) if learner != "s102"]
    assert one.isprintable()
    assert one.encode("utf-8")


@pytest.mark.parametrize("folders", [("02_axes", "03_tiny"), ("week 1", "week 2")])
def test_a_folder_for_each_chapter_or_assignment_is_nobodys(tmp_path: Path, folders: tuple[str, str]) -> None:
    put(tmp_path, f"{folders[0]}/s101.ipynb", f"{folders[1]}/s101.ipynb", f"{folders[1]}/s102/work.ipynb")
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert {learner: len(files) for learner, files in found.items()} == {"s101": 2, "s102": 1, "7": 0}


def test_a_strange_folder_hands_in_for_nobody_else(tmp_path: Path) -> None:
    put(tmp_path, "s101/03_tiny.ipynb", "submission_9/s101.ipynb", "submission_9/other.ipynb")
    assert who(collect(tmp_path, ROSTER, CHAPTERS))["s101"] == ["s101/03_tiny.ipynb"]
    put(tmp_path, *(f"submitted/x{n}/hw1/03_tiny.ipynb" for n in range(70)))
    assert len(who(collect(tmp_path / "submitted", None, CHAPTERS))) == 70


def test_hangul_that_a_mac_took_apart_is_the_same_name(tmp_path: Path) -> None:
    roster = {"김민지": Learner("김민지"), "s102": Learner("s102", "이 준")}
    put(tmp_path, *(unicodedata.normalize("NFD", name) for name in ("김민지/03_tiny.ipynb", "이 준/03_tiny.ipynb")))
    assert all(who(collect(tmp_path, roster, CHAPTERS)).values())


@pytest.mark.skipif(os.geteuid() == 0, reason="root may open everything")
def test_a_folder_that_cannot_be_opened_is_said(tmp_path: Path) -> None:
    put(tmp_path, "s101/03_tiny.ipynb")
    (tmp_path / "s101").chmod(0)
    try:
        assert "cannot be opened" in collect(tmp_path, ROSTER, CHAPTERS).remarks[0].say("en")
    finally:
        (tmp_path / "s101").chmod(0o700)


@pytest.mark.parametrize("inside", ["03_tiny.ipynb", "03_tiny/03_tiny.ipynb", "s102.ipynb"])
@pytest.mark.parametrize("roster", [ROSTER, None])
def test_a_zip_that_a_system_named_by_person_and_chapter_is_that_persons(
    tmp_path: Path, roster: dict[str, Learner] | None, inside: str
) -> None:
    for name in ("kimminji_4711_98765_03_tiny.zip", "adabyron_4712_98766_03_tiny.zip"):
        zipped(tmp_path / name, {inside: b"{}"})
    found = who(collect(tmp_path, roster, CHAPTERS))
    names = ("s101", "s102") if roster else ("kimminji_4711", "adabyron_4712")
    assert [len(found[name]) for name in names] == [1, 1]


def test_folders_named_by_person_and_chapter_are_the_persons_and_one_for_all_is_nobodys(tmp_path: Path) -> None:
    put(tmp_path, "ada_03_tiny/03_tiny.ipynb", "ada_02_axes/02_axes.ipynb", "kim_03_tiny/work.ipynb")
    put(tmp_path, "week 3, 03_tiny/lee.ipynb", "week 3, 03_tiny/park.ipynb")
    found = {learner: len(files) for learner, files in who(collect(tmp_path, None, CHAPTERS)).items()}
    assert found == {"ada": 2, "kim": 1, "lee": 1, "park": 1}


# Nobody reaches another's submission, and nobody loses their own.

OTHERS = b'{"metadata": {"tflab": {"learner": "s102"}}, "cells": []}'
OWN = b'{"metadata": {"tflab": {"learner": "s101"}}, "cells": []}'


def a_zip(**files: bytes) -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w") as archive:
        for name, data in files.items():
            archive.writestr(name.replace("__", "/"), data)
    return held.getvalue()


@pytest.mark.parametrize("folder", ["", "hw1/", "submissions/", "submissions/hw1/", "03_tiny/"])
def test_zips_in_a_folder_belong_to_whom_they_are_named_after(tmp_path: Path, folder: str) -> None:
    for learner in ("s101", "s102"):
        put(tmp_path, f"{folder}{learner}.zip", data=a_zip(**{"03_tiny.ipynb": b"{}"}))
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert [len(found[learner]) for learner in ("s101", "s102")] == [1, 1]
    assert set(found) == set(ROSTER)


@pytest.mark.parametrize(
    "inside", ["s102__zz_03_tiny.ipynb", "s102.ipynb", "submissions__s102__03_tiny.ipynb", "03_tiny__s102.ipynb"]
)
@pytest.mark.parametrize("name", ["hw1/s101.zip", "s101.zip", "s101/x.zip", "03_tiny.zip", "hw1/03_tiny.zip", "x.zip"])
def test_what_is_in_a_zip_never_becomes_anothers(tmp_path: Path, name: str, inside: str) -> None:
    folder = "hw1/" if name.startswith("hw1") else ""
    put(tmp_path, f"{folder}s102/03_tiny.ipynb", f"{folder}7/03_tiny.ipynb")
    put(tmp_path, name, data=a_zip(**{inside: OTHERS}))
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert [name.removeprefix(folder) for name in found["s102"]] == ["s102/03_tiny.ipynb"]
    assert len(found["7"]) == 1


def test_two_learners_of_one_name_in_moodle_are_told_apart_by_their_stamps(tmp_path: Path) -> None:
    people = {"s1": Learner("s1", "Kim Minji"), "s2": Learner("s2", "Kim Minji")}
    for number, learner in ((4711, "s1"), (4712, "s2")):
        stamped = OWN.replace(b"s101", learner.encode())
        put(tmp_path, f"Kim Minji_{number}_assignsubmission_file_/03_tiny.ipynb", data=stamped)
    found = who(collect(tmp_path, people, CHAPTERS))
    assert {learner: files[0].split("_")[1] for learner, files in found.items()} == {"s1": "4711", "s2": "4712"}


MOODLE = "Ada Byron_{}_assignsubmission_file_/03_tiny.ipynb"
FORGED = b'{"metadata": {"tflab": {"learner": "s102", "seal": "forged"}}, "cells": []}'
NOTHING = b"{}"


@pytest.mark.parametrize("data", [OWN, FORGED, NOTHING])
@pytest.mark.parametrize("number", [4710, 4712])  # before and behind the other's
def test_a_stamp_forged_beside_a_display_name_brings_nothing_into_anothers_submission(
    tmp_path: Path, data: bytes, number: int
) -> None:
    put(tmp_path, MOODLE.format(number), data=data)
    put(tmp_path, MOODLE.format(4711), data=OTHERS)
    assert who(collect(tmp_path, ROSTER, CHAPTERS))["s102"] == [MOODLE.format(4711)]


@pytest.mark.parametrize("data", [OTHERS, FORGED, NOTHING])
def test_of_two_who_go_by_one_name_alike_neither_is_taken_for_the_one_on_the_roster(
    tmp_path: Path, data: bytes
) -> None:
    for number in (4711, 4712):
        put(tmp_path, MOODLE.format(number), data=data)
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    found = who(collection)
    assert found["s102"] == []
    assert len(found["Ada Byron_4711"]) == len(found["Ada Byron_4712"]) == 1
    assert "no valid stamp shows which" in remarks_of(collection, "Ada Byron_4711")[0]


@pytest.mark.parametrize("name", ["upload/03_tiny.ipynb", "Nobody_4_assignsubmission_file_/03_tiny.ipynb"])
def test_a_path_that_says_nothing_is_settled_by_a_stamp_that_is_not_forged(tmp_path: Path, name: str) -> None:
    for data, files in ((FORGED, []), (OTHERS, [name])):
        put(tmp_path, name, data=data)
        assert who(collect(tmp_path, ROSTER, CHAPTERS))["s102"] == files


def test_a_place_called_by_the_id_stays_that_persons_and_another_is_whose_seal_it_bears(tmp_path: Path) -> None:
    put(tmp_path, MOODLE.format(4710), data=OWN)
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert (found["s101"], found["s102"]) == ([MOODLE.format(4710)], [])
    put(tmp_path, "s102/03_tiny.ipynb", data=NOTHING)
    put(tmp_path, MOODLE.format(4710), data=NOTHING)
    assert who(collect(tmp_path, ROSTER, CHAPTERS))["s102"] == ["s102/03_tiny.ipynb"]


@pytest.mark.parametrize("display", ["Mallory s102", "Ada Byron", "Mallory, Ada Byron", "s102 Mallory"])
@pytest.mark.parametrize("system", ["{}_4710_assignsubmission_file_/zz_03_tiny.ipynb", "12-34 - {} - Nov 20/z.ipynb"])
def test_a_display_name_does_not_bring_a_notebook_into_anothers_submission(
    tmp_path: Path, display: str, system: str
) -> None:
    put(tmp_path, system.format(display), data=OWN)
    put(tmp_path, "Ada Byron_4711_assignsubmission_file_/03_tiny.ipynb", data=OTHERS)
    found = who(collect(tmp_path, ROSTER, CHAPTERS))
    assert found["s102"] == ["Ada Byron_4711_assignsubmission_file_/03_tiny.ipynb"]
    assert len(found["s101"]) == 1


@pytest.mark.parametrize("data", [OWN, FORGED, NOTHING])
@pytest.mark.parametrize("theirs", ["Ada Byron - 03_tiny.ipynb", "s102/03_tiny.ipynb"])
@pytest.mark.parametrize("named", ["Mallory s102 - 03_tiny.ipynb", "s102 (1).ipynb", "zz_s102_03_tiny.ipynb"])
def test_a_name_of_ones_own_choice_brings_nothing_to_what_bears_its_owners_seal(
    tmp_path: Path, named: str, theirs: str, data: bytes
) -> None:
    put(tmp_path, named, data=data)
    put(tmp_path, theirs, data=OTHERS)
    assert who(collect(tmp_path, ROSTER, CHAPTERS))["s102"] == [theirs]


def test_two_attempts_that_bear_their_owners_seal_or_of_which_none_does_are_that_owners(tmp_path: Path) -> None:
    for data in (OTHERS, NOTHING):
        put(tmp_path, "HW1_s102_attempt1/03_tiny.ipynb", "HW1_s102_attempt2/03_tiny.ipynb", data=data)
        assert len(who(collect(tmp_path, ROSTER, CHAPTERS))["s102"]) == 2


def test_zips_in_a_zip_are_opened_within_a_budget(tmp_path: Path) -> None:
    inner = a_zip(**{"03_tiny.ipynb": b"{}"})
    put(tmp_path, "s101.zip", data=a_zip(**{f"{number}.zip": inner for number in range(60)}))
    put(tmp_path, "s102.zip", data=a_zip(**{"03_tiny.ipynb": b"{}"}))
    collection = collect(tmp_path, ROSTER, CHAPTERS)
    found = who(collection)
    assert (len(found["s101"]), len(found["s102"])) == (8, 1)
    said = [remark.say("en") for remark in collection.remarks]
    assert len([line for line in said if "zips in a zip" in line]) == 20
    assert said[-1] == "s101.zip: 32 more like these."


def test_large_zips_in_a_zip_are_not_unpacked_to_be_listed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read = []
    really = archives._reader

    def counted(source, entry):
        give = really(source, entry)
        return lambda: read.append(entry.file_size) or give()

    monkeypatch.setattr(archives, "_reader", counted)
    zipped(tmp_path / "s101.zip", {f"{number}.zip": b"\0" * (30 << 20) for number in range(4)})
    collect(tmp_path, ROSTER, CHAPTERS)
    assert sum(read) <= 64 << 20
