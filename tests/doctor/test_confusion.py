"""Every fault is named by its cause and by nothing else, and a healthy robot is left in peace.

benchmarks/doctor.py has the same matrix with more seeds, and for given bags.
"""

import pytest

from tflab.bags.recording import recording_from_records
from tflab.doctor.diagnose import diagnose_recording
from tflab.doctor.report.sentences import descriptions, faults_of_code
from tflab.robots.faults.catalogue import Fault
from tflab.robots.faults.inject import inject, inject_all
from tflab.robots.teaching import TeachingRobot

SEEDS = (0, 1)


def run(seed):
    """A clean run; every other one without publishers, as in a rosbag2."""
    records = TeachingRobot(seed=seed).records(until_s=20.0)
    return records if seed % 2 else [record._replace(publisher="") for record in records]


def on_another_clock(records):
    """The same run, heard by somebody whose clock is years ahead and drifts by 100 ppm."""
    return [r._replace(receive_ns=1_700_000_000_000_000_000 + round(1.0001 * r.receive_ns)) for r in records]


def codes_of(fault):
    return {code for code, description in descriptions().items() if fault in description.faults}


def alarms(records):
    return diagnose_recording(recording_from_records(records)).of_severity("error", "warning")


@pytest.fixture(scope="module")
def runs():
    return {seed: run(seed) for seed in SEEDS}


@pytest.mark.parametrize("seed", SEEDS)
def test_a_clean_run_raises_no_alarm_on_its_own_clock_nor_on_another(runs, seed):
    assert alarms(runs[seed]) == ()
    assert alarms(on_another_clock(runs[seed])) == ()


@pytest.mark.parametrize("fault", list(Fault))
@pytest.mark.parametrize("seed", SEEDS)
def test_each_fault_is_named_and_nothing_else_is(runs, fault, seed):
    broken, diagnosis = inject(runs[seed], fault, seed)
    codes = {finding.code for finding in alarms(broken)}
    assert codes, diagnosis.detail
    assert codes <= codes_of(fault), diagnosis.detail


@pytest.mark.parametrize("fault", [Fault.LATE_STAMPS, Fault.EARLY_STAMPS, Fault.CLOCK_JUMPED_BACK, Fault.GAP])
def test_faults_of_time_are_named_in_simulated_time_too(runs, fault):
    broken, diagnosis = inject(on_another_clock(runs[0]), fault, 0)
    codes = {finding.code for finding in alarms(broken)}
    assert codes and codes <= codes_of(fault), diagnosis.detail


def test_faults_of_different_edges_are_all_named(runs):
    wanted = [Fault.OPTICAL_IDENTITY, Fault.SECOND_OWNER, Fault.LEADING_SLASH]
    broken, _ = inject_all(runs[1], wanted, seed=5)
    named = {fault for finding in alarms(broken) for fault in faults_of_code(finding.code)}
    assert set(wanted) <= named
