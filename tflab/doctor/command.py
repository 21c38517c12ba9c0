"""`tflab doctor BAG`: what is wrong with the TF of this recording?

    tflab doctor drive                    for the eye
    tflab doctor drive --json             for a program
    tflab doctor drive --html report.html for a browser

The exit status is 1 if errors were found, 2 if the bag cannot be read or the
report not be written, and 0 otherwise.
"""

from __future__ import annotations

import argparse
import json
import logging
import sys
from collections.abc import Sequence
from pathlib import Path

from tflab.bags.errors import BagError

__all__ = ["main"]

FOUND_ERRORS, UNUSABLE = 1, 2


def main(words: Sequence[str]) -> int:
    """Run `tflab doctor` with these words; return the exit status."""
    parser = argparse.ArgumentParser(prog="tflab doctor", description="Say what is wrong with the TF of a recording.")
    parser.add_argument("bag", metavar="BAG", help="a rosbag2 directory, an .mcap or .db3 file, or a .bag of ROS 1")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.add_argument("--html", metavar="FILE", help="also write the report, with pictures, as a page of its own")
    options = parser.parse_args(list(words))
    return _diagnose(options.bag, options.json, options.html)


def _diagnose(bag: str, as_json: bool, html: str | None) -> int:
    """Diagnose a bag, print the report, and return the exit status."""
    from tflab.bags.reader import read_bag

    from .diagnose import diagnose_recording
    from .report.text import data_from_report, text_from_report

    if html is not None and Path(html).exists():
        return _refuse(f"{html}: exists already; nothing is overwritten")
    try:
        recording = read_bag(bag)
    except BagError as error:
        return _refuse(f"{error}")
    report = diagnose_recording(recording)
    print(json.dumps(data_from_report(report), indent=2) if as_json else text_from_report(report))
    if html is not None:
        try:
            _write_html(html, report, recording)
        except OSError as error:
            return _refuse(f"{html}: cannot be written ({error.strerror})")
    return FOUND_ERRORS if report.has_errors else 0


def _write_html(path: str, report, recording) -> None:
    from .report.html import html_from_report

    refusals = logging.getLogger("tflab.tf2")  # what the buffer for the tree refuses is in the report already
    was_disabled, refusals.disabled = refusals.disabled, True
    try:
        page = html_from_report(report, recording)
    finally:
        refusals.disabled = was_disabled
    with Path(path).open("x", encoding="utf-8") as file:
        file.write(page)


def _refuse(reason: str) -> int:
    print(f"tflab doctor: {reason}", file=sys.stderr)
    return UNUSABLE
