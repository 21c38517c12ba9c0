"""Switch the checks of field types on or off.

    ROS_PYTHON_CHECK_FIELDS=1, or Humble   on from the start
    %load_ext tflab                        set_field_checks(True)
    Vector3(check_fields=True)             this message only

Unchecked, ROS 2 stores a wrong type without a word and fails when the message is
published; checked, the line that makes the mistake is the line that fails.
"""

from __future__ import annotations

from .. import distro

__all__ = ["field_checks", "set_field_checks"]

on = distro.checks_fields()  # for reading; set_field_checks() changes it


def field_checks() -> bool:
    """Return whether a new message checks the types of its fields."""
    return on


def set_field_checks(value: bool | None) -> None:
    """Turn the checks of new messages on or off; None goes back to what distribution and environment say."""
    global on
    on = distro.checks_fields() if value is None else value
