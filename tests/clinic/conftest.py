"""A patient that several tests visit; it is made once, and none of them changes it."""

import pytest

from tflab.clinic.practice import worked_patient


@pytest.fixture(scope="session")
def ahead():
    return worked_patient("laser clock ahead")
