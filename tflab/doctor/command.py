"""`tflab doctor BAG`: what is wrong with the TF of this recording?

    words -> options -> recordings -> reports -> text, files, exit status
                                         ^
                           expectations, baseline, --ignore

The exit status is 1 if something is as severe as --fail-on asks, 2 if a bag
cannot be read or a file not be written, and 0 otherwise.  `options.py` lists the
words.
"""

from __future__ import annotations

import json
import logging
import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tflab.bags.errors import BagError
from tflab.bags.recording import Recording

from .diagnose import diagnose_recording, told_causes, worst_first
from .findings import Report
from .gate.annotations import annotations_from_reports
from .gate.deviations import changes_between, deviations_from
from .gate.expectations import ExpectationError, Expectations, expectations_from, read_expectations, toml_from
from .gate.filters import BaselineError, baseline_from, let_pass, read_baseline
from .gate.junit import junit_from_reports
from .gate.sarif import sarif_from_reports
from .gate.table import text_from_reports
from .live import NoRos, recording_from_ros
from .options import FAILING, options_from
from .profile import RecordingProfile, profile_of, text_from_profile
from .report.text import data_from_report, text_from_report

__all__ = ["main"]

FOUND, UNUSABLE = 1, 2


class Rules(NamedTuple):
    """What is expected, and what is let pass."""

    expectations: Expectations
    ignore: tuple[str, ...]
    baseline: tuple[str, ...]


class Examined(NamedTuple):
    """One recording after the examination; where it could not be read, only why.

    Attributes:
        recording: only kept where a page with pictures is asked for.
        cut: what it lacks if it could not be read to its end.
    """

    name: str
    report: Report | None = None
    profile: RecordingProfile | None = None
    recording: Recording | None = None
    refusal: str = ""
    cut: str = ""


def main(words: Sequence[str]) -> int:
    """Run `tflab doctor` with these words; return the exit status."""
    options = options_from(words)
    taken = [file for file in _files_to_write(options) if Path(file).exists()]
    if taken:
        return _refuse(f"{taken[0]}: exists already; nothing is overwritten")
    try:
        rules = _rules(options)
    except (ExpectationError, BaselineError) as error:
        return _refuse(f"{error}")
    examined = [_examined(name, read, options, rules) for name, read in _patients(options)]
    examined = _compared(examined, options)
    _print(examined, options)
    try:
        _write_files(examined, options)
    except OSError as error:
        return _refuse(f"{error.filename}: cannot be written ({error.strerror})")
    return _exit_status(examined, options)


def _files_to_write(options: Namespace) -> list[str]:
    asked = (options.html, options.junit, options.sarif, options.write_expectations, options.write_baseline)
    return [file for file in asked if file is not None]


def _rules(options: Namespace) -> Rules:
    expectations = read_expectations(options.expect) if options.expect else Expectations()
    baseline = read_baseline(options.baseline) if options.baseline else ()
    return Rules(expectations, (*options.ignore, *expectations.ignore), baseline)


def _patients(options: Namespace) -> list[tuple[str, Callable[[], Recording]]]:
    """Return what is to be examined: its name, and how to get hold of it."""
    if options.live is not None:
        return [("live", lambda: recording_from_ros(options.live))]
    return [(bag, lambda bag=bag: _read(bag)) for bag in options.bags]


def _read(bag: str) -> Recording:
    from tflab.bags.reader import read_bag

    return read_bag(bag, salvage=True)


def _examined(name: str, read: Callable[[], Recording], options: Namespace, rules: Rules) -> Examined:
    try:
        recording = read()
    except (BagError, NoRos) as error:
        return Examined(name, refusal=f"{error}")
    report = diagnose_recording(recording)
    is_asked = options.expect or options.write_expectations or options.edges or len(options.bags) == 2
    profile = profile_of(recording) if is_asked else None
    if options.expect and profile is not None:
        report = replace(report, findings=(*report.findings, *deviations_from(rules.expectations, profile)))
    report, _ = let_pass(report, rules.ignore, rules.baseline)
    report = replace(report, findings=worst_first(told_causes(list(report.findings))))
    unfinished = recording.unfinished
    cut = f"{name}: read as far as it goes: {unfinished.what}" if unfinished and unfinished.is_cut else ""
    return Examined(name, report, profile, recording if options.html else None, cut=cut)


def _compared(examined: list[Examined], options: Namespace) -> list[Examined]:
    """Return what was examined, with what changed among the findings of the second of two."""
    if len(examined) != 2 or options.table or not all(patient.profile for patient in examined):
        return examined
    before, after = examined
    changes = changes_between(before.profile, after.profile)
    changed, _ = let_pass(replace(after.report, findings=(*after.report.findings, *changes)), options.ignore)
    changed = replace(changed, findings=worst_first(told_causes(list(changed.findings))))
    return [before, after._replace(report=changed)]


def _print(examined: list[Examined], options: Namespace) -> None:
    as_table = not options.json and (options.table or len(examined) > 2)
    _print_refusals(examined, is_in_table=as_table)
    told = [patient for patient in examined if patient.report is not None]
    if options.json:
        _print_json(examined, told)
        return
    if as_table:
        print(text_from_reports([p.name for p in examined], [p.report or p.refusal for p in examined], options.lang))
    else:
        _print_text(told, options.lang)
    for patient in told if options.edges else ():
        print(f"\n{patient.name}\n{text_from_profile(patient.profile)}")
    _print_annotations(told, _refusals(examined), options)


def _print_annotations(told: list[Examined], refusals: dict[str, str], options: Namespace) -> None:
    if options.github and (told or refusals):
        print(annotations_from_reports([p.report for p in told], [p.name for p in told], refusals))


def _refusals(examined: list[Examined]) -> dict[str, str]:
    return {patient.name: patient.refusal or patient.cut for patient in examined if patient.refusal or patient.cut}


def _print_refusals(examined: list[Examined], is_in_table: bool) -> None:
    for patient in examined:
        reason = patient.cut or ("" if is_in_table else patient.refusal)
        if reason:
            print(f"tflab doctor: {reason}", file=sys.stderr)


def _print_json(examined: list[Examined], told: list[Examined]) -> None:
    data = [data_from_report(patient.report) for patient in told]
    if data:
        print(json.dumps(data[0] if len(examined) == 1 else {"version": 1, "reports": data}, indent=2))


def _print_text(told: list[Examined], language: str) -> None:
    if len(told) == 2:
        print(f"{told[1].name}, and what changed since {told[0].name}:\n")
    for patient in told[-1:]:
        print(text_from_report(patient.report, language))


def _write_files(examined: list[Examined], options: Namespace) -> None:
    reports = [patient for patient in examined if patient.report is not None]
    names = [patient.name for patient in reports]
    if options.junit:
        told = [patient.report for patient in reports]
        _write(options.junit, junit_from_reports(told, FAILING[options.fail_on], _refusals(examined)))
    if not reports:
        return
    if options.sarif:
        _write(options.sarif, sarif_from_reports([patient.report for patient in reports], names))
    if options.write_baseline:
        _write(options.write_baseline, baseline_from(patient.report for patient in reports))
    if options.write_expectations:
        _write(options.write_expectations, toml_from(expectations_from(reports[0].profile)))
    if options.html:
        from .report.html import html_from_report

        with _quiet_engine():
            page = html_from_report(reports[0].report, reports[0].recording, options.lang)
        _write(options.html, page)


def _write(path: str, text: str) -> None:
    with Path(path).open("x", encoding="utf-8") as file:
        file.write(text)


@contextmanager
def _quiet_engine():
    """Silence what the buffer for the pictures refuses: it is in the report already."""
    refusals = logging.getLogger("tflab.tf2")
    was_disabled, refusals.disabled = refusals.disabled, True
    try:
        yield
    finally:
        refusals.disabled = was_disabled


def _exit_status(examined: list[Examined], options: Namespace) -> int:
    if any(patient.refusal or patient.cut for patient in examined):
        return UNUSABLE
    failing = FAILING[options.fail_on]
    return FOUND if any(patient.report.of_severity(*failing) for patient in examined) else 0


def _refuse(reason: str) -> int:
    print(f"tflab doctor: {reason}", file=sys.stderr)
    return UNUSABLE
