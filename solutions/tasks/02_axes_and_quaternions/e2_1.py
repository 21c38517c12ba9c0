"""E2.1: Say the sign."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

SIGN = Choice(("positive", "negative"))

SIGNS = {
    "angular_z_turning_left": "positive",
    "pitch_nose_down": "positive",
    "y_right_in_base_link": "negative",
    "x_right_in_optical_frame": "positive",
    "y_above_in_optical_frame": "negative",
}

TASK = define_task(__file__, kind="M", points=3, answer="signs", form=Parts(dict.fromkeys(SIGNS, SIGN)))
