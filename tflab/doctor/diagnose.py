"""What is wrong with this TF?  Every check, and then the causes apart from their effects.

    checks/ in their order -> findings
                                 |
                                 v
    one cause has many effects: a misspelt name also makes two trees,
    two owners also bring stamps out of order.  Only the cause is told.

Read `report/` next.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from tflab.bags.recording import Recording
from tflab.core import BufferCore

from .checks import clocks, names, owners, statics, timing, tree, values
from .evidence import Evidence, evidence_from_buffer, evidence_from_recording
from .findings import SEVERITIES, Finding, NotMade, Report
from .report.texts import CHECK_TEXTS

__all__ = ["CHECKS", "Check", "diagnose_buffer", "diagnose_recording"]


class Check(NamedTuple):
    """One question, and what it takes to answer it: "" (a tree), "raw", "arrival" or "recording"."""

    name: str
    run: Callable[[Evidence], Iterator[Finding]]
    needs: str = ""


CHECKS = (
    Check("leading slashes", names.leading_slashes, "raw"),
    Check("empty names", names.empty_names, "raw"),
    Check("misspelt names", names.misspelt_names),
    Check("frames that messages name", names.unknown_frames_in_messages, "recording"),
    Check("frames that are their own parent", tree.self_transforms, "raw"),
    Check("loops", tree.loops),
    Check("one parent for each child", tree.several_parents),
    Check("one tree", tree.separate_trees),
    Check("numbers", values.not_numbers, "raw"),
    Check("rotations", values.bad_rotations, "raw"),
    Check("optical frames", values.unturned_optical_frames),
    Check("stamps that are not set", timing.unset_stamps),
    Check("repeated stamps", timing.repeated_stamps),
    Check("order of stamps", timing.unordered_stamps, "arrival"),
    Check("gaps", timing.gaps),
    Check("delays", timing.odd_delays, "arrival"),
    Check("delays of other messages", timing.odd_message_delays, "recording"),
    Check("jumps of a clock", clocks.jumping_clocks, "arrival"),
    Check("source of time", clocks.other_time_source, "recording"),
    Check("agreement of clocks", clocks.clock_offset, "arrival"),
    Check("one owner for each transform", owners.several_owners),
    Check("one owner for each static transform", owners.several_static_owners, "arrival"),
    Check("moving or static, not both", owners.owners_of_both_kinds, "raw"),
    Check("static transforms are there", statics.missing_statics, "recording"),
    Check("mounts repeated on /tf", statics.constant_on_tf),
    Check("motions on /tf_static", statics.moving_on_static, "arrival"),
    Check("static transforms for late listeners", statics.volatile_statics, "recording"),
)

# cause: effects that it brings about on the same child, and anywhere
EFFECTS_ON_CHILD = {
    "two-owners": ("unordered-stamps", "repeated-stamps", "clock-jump-back", "clock-jump-forward", "late-stamps",
                   "early-stamps", "static-changed", "moving-on-static"),
    "two-parents": ("two-owners", "unordered-stamps", "repeated-stamps", "clock-jump-back", "clock-jump-forward"),
    "re-parented": ("two-owners",),
    "moving-and-static": ("constant-on-tf", "static-changed", "two-parents"),
    "unset-stamps": ("repeated-stamps", "unordered-stamps", "gap", "clock-jump-back", "clock-jump-forward",
                     "late-stamps", "early-stamps"),
    "moving-on-static": ("static-changed", "moving-and-static", "went-silent"),
    "constant-on-tf": ("early-stamps", "stamped-ahead"),  # as ROS 1 sends them: stamped ahead by a period
    "self-transform": ("loop", "two-parents", "re-parented"),
}  # fmt: skip
EFFECTS_ANYWHERE = {
    "name-case": ("two-trees", "re-parented", "two-parents", "unknown-frame", "loop"),
    "name-prefix": ("two-trees", "re-parented", "two-parents", "unknown-frame"),
    "name-slip": ("two-trees", "re-parented", "two-parents", "unknown-frame"),
    "statics-missing": ("two-trees", "unknown-frame"),
    "empty-name": ("two-trees",),
    "loop": ("re-parented", "two-parents", "two-trees"),
    "re-parented": ("two-trees",),
    "two-parents": ("two-trees",),
    "clock-offset": ("late-stamps", "early-stamps", "messages-early", "messages-late"),
    "stall": ("late-stamps",),
    "two-trees": ("unknown-frame",),
}


def diagnose_recording(recording: Recording) -> Report:
    """Return what is wrong with the transforms of a recording, in each of its namespaces."""
    if not recording.namespaces():
        return _report_without_transforms(recording)
    findings = []
    for namespace in recording.namespaces():
        evidence = evidence_from_recording(recording, namespace)
        findings += told_causes([finding for check in CHECKS for finding in check.run(evidence)])
    findings += [Finding("passed-over", "info", facts={"note": note}) for note in recording.notes]
    return Report(recording.name, recording.begin_ns, worst_first(findings), tuple(check.name for check in CHECKS))


def diagnose_buffer(buffer: BufferCore, name: str = "buffer") -> Report:
    """Return what is wrong with what a buffer holds; it has forgotten much of what a recording tells."""
    evidence = evidence_from_buffer(buffer, name)
    made = [check for check in CHECKS if not check.needs]
    findings = told_causes([finding for check in made for finding in check.run(evidence)])
    not_made = tuple(NotMade(check.name, CHECK_TEXTS[check.needs]) for check in CHECKS if check.needs)
    return Report(name, evidence.begin_ns, worst_first(findings), tuple(check.name for check in made), not_made)


def told_causes(findings: list[Finding]) -> list[Finding]:
    """Return the findings without those that another of them explains."""
    explained_on: set[tuple[str, str]] = set()
    explained: set[str] = set()
    for finding in findings:
        if finding.severity != "info":
            explained_on |= {(code, finding.child) for code in EFFECTS_ON_CHILD.get(finding.code, ())}
            explained |= set(EFFECTS_ANYWHERE.get(finding.code, ()))
    return [f for f in findings if f.code not in explained and (f.code, f.child) not in explained_on]


def worst_first(findings: list[Finding]) -> tuple[Finding, ...]:
    """Return findings by severity; among equals the order of the checks stays."""
    return tuple(sorted(findings, key=lambda finding: SEVERITIES.index(finding.severity)))


def _report_without_transforms(recording: Recording) -> Report:
    topics = ", ".join(sorted({connection.topic for connection in recording.connections})) or "nothing"
    findings = (Finding("no-transforms", "info", facts={"topics": topics}),)
    not_made = tuple(NotMade(check.name, "transforms") for check in CHECKS)
    return Report(recording.name, recording.begin_ns, findings, (), not_made)
