"""A patient is made once, and found again by what it was made from."""

from tflab.clinic import archive
from tflab.clinic.archive import Admission, patients
from tflab.clinic.causes import Numbers


def test_a_patient_is_made_once(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    admission = Admission(("header says another frame",), Numbers())
    made = patients([admission])[0].packed()
    monkeypatch.setattr(archive, "make_patient", None)
    assert patients([admission, admission])[1].packed() == made
    assert len([path for path in tmp_path.rglob("*") if path.is_file()]) == 1
