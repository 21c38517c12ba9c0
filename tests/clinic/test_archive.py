"""A patient is made once, and found again by what it was made from."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

import tflab
from tflab.clinic import archive
from tflab.clinic.archive import PatientSpec, digest_of, files_of, patients
from tflab.clinic.causes import Numbers

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

PACKAGE = Path(tflab.__file__).parent
READS = CASES["reads"]


def test_a_patient_is_made_once(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    spec = PatientSpec(("header says another frame",), Numbers())
    made = patients([spec])[0].packed()
    monkeypatch.setattr(archive, "make_patient", None)
    assert patients([spec, spec])[1].packed() == made
    assert len([path for path in (tmp_path / "tflab").rglob("*") if path.is_file()]) == 1


@pytest.mark.parametrize(
    "file", ["clinic/simulate_patient.py", "tools/tf2_monitor.py", "robots/data/tf_lab_robot.urdf", "ros/tf2/buffer.py"]
)
def test_after_an_edit_of_what_makes_patients_none_is_found_again(tmp_path, file):
    for name in archive.MADE_BY:
        shutil.copytree(PACKAGE / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__", "*.so"))
    before = digest_of(tmp_path)
    assert before == digest_of(PACKAGE)
    (tmp_path / file).write_text((tmp_path / file).read_text(encoding="utf-8") + " ", encoding="utf-8")
    assert digest_of(tmp_path) != before


def test_whatever_a_patient_is_made_from_is_in_its_name():
    run = subprocess.run([sys.executable, "-c", READS], capture_output=True, text=True, check=True)
    ours = {Path(line) for line in run.stdout.splitlines() if line.startswith(f"{PACKAGE}/")}
    written = {path for path in ours if path.parent.name == "__pycache__"}  # by another process, half done, too
    made_from = {path for path in ours - written if path.suffix not in archive.COMPILED and path.parent != PACKAGE}
    assert made_from, "the reading of a patient's sources found nothing"
    assert made_from <= set(files_of(PACKAGE))
