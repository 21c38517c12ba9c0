"""Which finding names which fault?  The doctor's words beside those of the catalogue of faults.

    Fault.GAP          <->  "gap", "went-silent", "stall"
    Fault.LATE_STAMPS  <->  "late-stamps"
    Fault.CLOCK_OFFSET <->  "clock-offset", "late-stamps", "early-stamps"

Where the evidence cannot separate two causes, the text of the finding names both
("the node takes long, or its clock is behind"), and so it stands here twice.
"""

from __future__ import annotations

from tflab.robots.faults.catalogue import Fault

__all__ = ["CODES_OF_FAULT", "faults_of_code"]

CODES_OF_FAULT: dict[Fault, tuple[str, ...]] = {
    Fault.REPARENTED: ("re-parented", "two-parents"),
    Fault.SECOND_OWNER: ("two-owners", "moving-and-static", "static-changed"),
    Fault.DUPLICATE_STAMPS: ("repeated-stamps",),
    Fault.OUT_OF_ORDER: ("unordered-stamps",),
    Fault.ZERO_QUATERNION: ("zero-quaternion",),
    Fault.NAN: ("not-a-number",),
    Fault.NON_UNIT_QUATERNION: ("not-unit-quaternion",),
    Fault.MISSING_EDGE: ("two-trees", "unknown-frame", "unknown-world-frame"),
    Fault.LOOP: ("loop", "self-transform"),
    Fault.LEADING_SLASH: ("leading-slash", "message-slash"),
    Fault.CLOCK_JUMPED_BACK: ("clock-jump-back",),
    Fault.CLOCK_OFFSET: (
        "clock-offset",
        "late-stamps",
        "early-stamps",
        "messages-early",
        "messages-late",
        "other-time",
    ),
    Fault.STATIC_ON_TF: ("constant-on-tf",),
    Fault.MOVING_ON_TF_STATIC: ("moving-on-static", "static-changed"),
    Fault.NO_TF_STATIC: ("statics-missing",),
    Fault.GAP: ("gap", "went-silent", "stall", "tf-silent"),
    Fault.WRONG_NAME: ("name-case", "name-prefix", "name-slip", "empty-name"),
    Fault.OPTICAL_IDENTITY: ("optical-unturned",),
    Fault.LATE_STAMPS: ("late-stamps",),
    Fault.EARLY_STAMPS: ("early-stamps",),
}


def faults_of_code(code: str) -> tuple[Fault, ...]:
    """Return the faults that a finding names; none for a mere note."""
    return tuple(fault for fault, codes in CODES_OF_FAULT.items() if code in codes)
