"""Run `tflab doctor BAG`: report what is wrong with the TF of a recording.

    options -> recordings -> reports -> text, files, exit status
                                ^
                  expectations, baseline, --ignore

The exit status is 1 if a finding is as severe as --fail-on, 2 if a bag cannot be
read or a file not be written, and 0 otherwise.
"""

from __future__ import annotations

import argparse
import json
import logging
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tflab.bags.errors import BagError
from tflab.bags.recording import Recording
from tflab.text import LANGUAGES, Text, language_of_tools, load_yaml

from .api import NoRos, recording_from_ros
from .ci.expectations import (
    ExpectationError,
    Expectations,
    changes_between,
    deviations_from,
    expectations_from,
    read_expectations,
    toml_from,
)
from .ci.filters import BaselineError, baseline_from, filter_findings, read_baseline
from .ci.formats import annotations_from_reports, junit_from_reports, sarif_from_reports, text_from_reports
from .diagnose import diagnose_recording, group_by_cause, worst_first
from .findings import Report
from .profile import RecordingProfile, profile_of, text_from_profile
from .report.text import data_from_report, text_from_report

__all__ = ["main"]

FAILING = {"error": ("error",), "warning": ("error", "warning"), "info": ("error", "warning", "info"), "never": ()}


def options_from(words: Sequence[str]) -> argparse.Namespace:
    """Return what was asked for; what makes no sense ends the program with status 2."""
    texts = load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))  # of --help
    parser = argparse.ArgumentParser("tflab doctor", formatter_class=argparse.RawDescriptionHelpFormatter, **texts)
    parser.add_argument("bags", metavar="BAG", nargs="*", help="a recording; two are compared, more are a table")
    parser.add_argument("--live", metavar="SECONDS", type=_seconds, help="listen to the robot instead, through rclpy")
    parser.add_argument("--table", action="store_true", help="a line for each bag, also of one or two")
    reading = parser.add_argument_group("how to read it")
    reading.add_argument("--json", action="store_true", help="print JSON")
    reading.add_argument("--html", metavar="FILE", help="also write a page with pictures (of one bag)")
    reading.add_argument("--junit", metavar="FILE", help="also write a test run, as JUnit XML")
    reading.add_argument("--sarif", metavar="FILE", help="also write SARIF, for code scanning")
    reading.add_argument("--github", action="store_true", help="also print annotations for GitHub Actions")
    reading.add_argument("--edges", action="store_true", help="also print rate, delays and owners of each edge")
    reading.add_argument(
        "--lang",
        choices=LANGUAGES,
        default=language_of_tools(),
        help="language of report and page (default: %(default)s)",
    )
    failing = parser.add_argument_group("when it fails")
    failing.add_argument("--fail-on", choices=FAILING, default="error", help="the least severity that gives status 1")
    failing.add_argument("--expect", metavar="FILE", help="what a good recording looks like; deviations are findings")
    failing.add_argument("--write-expectations", metavar="FILE", help="write that file, from this bag")
    failing.add_argument("--ignore", metavar="CODE[:WHERE]", action="append", default=[], help="let findings pass")
    failing.add_argument("--baseline", metavar="FILE", help="let those pass that are in this file")
    failing.add_argument("--write-baseline", metavar="FILE", help="write that file, of everything that is found")
    options = parser.parse_args(list(words))
    if (options.live is None) != bool(options.bags):
        parser.error("name a BAG, or ask for --live SECONDS" + (", not both" if options.bags else ""))
    options.bags = _expanded(options.bags)
    if options.json and options.github:
        parser.error("--json and --github both print: choose one")
    is_one = len(options.bags) < 2
    if not is_one and (options.html or options.write_expectations):
        parser.error("--html and --write-expectations are about one bag")
    return options


def _expanded(bags: list[str]) -> list[str]:
    """Return the bags that are meant, where a shell has left * and ? as they were."""
    expanded = []
    for bag in bags:
        if Path(bag).exists() or not any(sign in bag for sign in "*?["):
            expanded.append(bag)
            continue
        path = Path(bag)
        found = sorted(str(place) for place in Path(path.anchor).glob(str(path.relative_to(path.anchor))))
        expanded += found or [bag]
    return expanded


def _seconds(word: str) -> float:
    seconds = float(word)
    if not 0.0 < seconds < 86400.0:
        raise argparse.ArgumentTypeError(f"{word} s: choose more than 0, and less than a day")
    return seconds


FOUND, UNUSABLE = 1, 2  # exit statuses
CHANGED = Text("{after}, and what changed since {before}:\n", "{after}, {before}에서 바뀐 점:\n")


class Rules(NamedTuple):
    """What is expected, and what is ignored."""

    expectations: Expectations
    ignore: tuple[str, ...]
    baseline: tuple[str, ...]


class Examined(NamedTuple):
    """One recording after the examination; if it could not be read, only the reason.

    Attributes:
        recording: only kept where a page with pictures is requested.
        refusal: why it could not be read.
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
    exists = [file for file in (getattr(options, form) for form in WRITERS) if file and Path(file).exists()]
    if exists:
        return _refuse(f"{exists[0]}: exists already; nothing is overwritten")
    try:
        rules = _rules(options)
    except (ExpectationError, BaselineError) as error:
        return _refuse(f"{error}")
    if options.live is not None:
        examined = [_examine("live", lambda: recording_from_ros(options.live), options, rules)]
    else:
        examined = [_examine(bag, lambda bag=bag: _read(bag), options, rules) for bag in options.bags]
    examined = _compare(examined, options)
    _print(examined, options)
    try:
        _write_files(examined, options)
    except OSError as error:
        return _refuse(f"{error.filename}: cannot be written ({error.strerror})")
    if _refusals(examined):
        return UNUSABLE
    return FOUND if any(e.report.of_severity(*FAILING[options.fail_on]) for e in examined) else 0


def _rules(options: argparse.Namespace) -> Rules:
    expectations = read_expectations(options.expect) if options.expect else Expectations()
    baseline = read_baseline(options.baseline) if options.baseline else ()
    return Rules(expectations, (*options.ignore, *expectations.ignore), baseline)


def _read(bag: str) -> Recording:
    from tflab.bags.reader import read_bag

    return read_bag(bag, salvage=True)


def _examine(name: str, read: Callable[[], Recording], options: argparse.Namespace, rules: Rules) -> Examined:
    try:
        recording = read()
    except (BagError, NoRos) as error:
        return Examined(name, refusal=f"{error}")
    report = diagnose_recording(recording)
    needs_profile = options.expect or options.write_expectations or options.edges or len(options.bags) == 2
    profile = profile_of(recording) if needs_profile else None
    if options.expect and profile is not None:
        report = replace(report, findings=(*report.findings, *deviations_from(rules.expectations, profile)))
    report = filter_findings(report, rules.ignore, rules.baseline)
    report = replace(report, findings=worst_first(group_by_cause(list(report.findings))))
    unfinished = recording.unfinished
    cut = f"{name}: read as far as it goes: {unfinished.what}" if unfinished and unfinished.is_cut else ""
    return Examined(name, report, profile, recording if options.html else None, cut=cut)


def _compare(examined: list[Examined], options: argparse.Namespace) -> list[Examined]:
    """Return what was examined; the findings of the second of two include what changed since the first."""
    if len(examined) != 2 or options.table or not all(patient.profile for patient in examined):
        return examined
    before, after = examined
    changes = changes_between(before.profile, after.profile)
    changed = filter_findings(replace(after.report, findings=(*after.report.findings, *changes)), options.ignore)
    changed = replace(changed, findings=worst_first(group_by_cause(list(changed.findings))))
    return [before, after._replace(report=changed)]


def _refusals(examined: list[Examined]) -> dict[str, str]:
    return {patient.name: patient.refusal or patient.cut for patient in examined if patient.refusal or patient.cut}


def _print(examined: list[Examined], options: argparse.Namespace) -> None:
    is_table = not options.json and (options.table or len(examined) > 2)
    _print_refusals(examined, is_table)
    read = [patient for patient in examined if patient.report is not None]
    if options.json:
        _print_json([data_from_report(patient.report) for patient in read], is_alone=len(examined) == 1)
        return
    if is_table:
        print(text_from_reports([p.name for p in examined], [p.report or p.refusal for p in examined], options.lang))
    elif read:
        changed = CHANGED.say(options.lang, after=read[-1].name, before=read[0].name) + "\n" if len(read) == 2 else ""
        print(changed + text_from_report(read[-1].report, options.lang))
    _print_additions(read, _refusals(examined), options)


def _print_refusals(examined: list[Examined], is_table: bool) -> None:
    for patient in examined:
        reason = patient.cut or ("" if is_table else patient.refusal)
        if reason:
            print(f"tflab doctor: {reason}", file=sys.stderr)


def _print_json(reports: list[dict], is_alone: bool) -> None:
    if reports:
        print(json.dumps(reports[0] if is_alone else {"version": 1, "reports": reports}, indent=2))


def _print_additions(read: list[Examined], refusals: dict[str, str], options: argparse.Namespace) -> None:
    for patient in read if options.edges else ():
        print(f"\n{patient.name}\n{text_from_profile(patient.profile)}")
    if options.github and (read or refusals):
        print(annotations_from_reports([p.report for p in read], [p.name for p in read], refusals))


def _junit(examined: list[Examined], options: argparse.Namespace) -> str:
    reports = [patient.report for patient in examined if patient.report is not None]
    return junit_from_reports(reports, FAILING[options.fail_on], _refusals(examined))


def _html(read: list[Examined], options: argparse.Namespace) -> str:
    from .report.html import html_from_report  # the only form that needs jinja2

    refusals = logging.getLogger("tflab.tf2")  # what the buffer of the pictures refuses is in the report already
    was_disabled, refusals.disabled = refusals.disabled, True
    try:
        return html_from_report(read[0].report, read[0].recording, options.lang)
    finally:
        refusals.disabled = was_disabled


# option: what it writes of the recordings that could be read; JUnit reports the others, too
WRITERS: dict[str, Callable[[list[Examined], argparse.Namespace], str]] = {
    "junit": _junit,
    "sarif": lambda read, _: sarif_from_reports([p.report for p in read], [p.name for p in read]),
    "write_baseline": lambda read, _: baseline_from(p.report for p in read),
    "write_expectations": lambda read, _: toml_from(expectations_from(read[0].profile)),
    "html": _html,
}


def _write_files(examined: list[Examined], options: argparse.Namespace) -> None:
    read = [patient for patient in examined if patient.report is not None]
    for form, write in WRITERS.items():
        file = getattr(options, form)
        if file and (read or form == "junit"):
            text = write(examined if form == "junit" else read, options)
            with Path(file).open("x", encoding="utf-8") as stream:
                stream.write(text)


def _refuse(reason: str) -> int:
    print(f"tflab doctor: {reason}", file=sys.stderr)
    return UNUSABLE
