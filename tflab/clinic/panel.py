"""How does one examine a patient without typing?  A trolley to choose from, a clock that runs down, a table that fills.

    check [ delay /scan ]  because [ laser clock ahead ]  ( Ask )      2 min; 10 of 12 left
    +--------------------------------+
    |  suspects by checks            |    the readings below it, and all of it as text
    +--------------------------------+

Which checks stand in the table is its own choice: those that can tell the suspects
of this complaint apart, and the ones asked.  The same visit can be carried on in
code: `panel.visit`.

This is the last page of the room.
"""

from __future__ import annotations

from html import escape

import ipywidgets as widgets

from tflab.views.panels.drawn_ahead import At
from tflab.views.panels.panel import Panel, side_by_side
from tflab.views.suspects import draw_suspects

from .patient import SickRobot
from .table import COMPLAINTS, SUSPECTS, kind_expected
from .trolley import TROLLEY
from .visit import Visit

__all__ = ["ClinicPanel", "clinic_panel", "columns_for", "suspects_table"]

LABELS = {
    "en": {"check": "check", "because": "because", "ask": "Ask", "nobody": "(nobody yet)"},
    "ko": {"check": "검사", "because": "의심", "ask": "묻기", "nobody": "(아직 없음)"},
}


def columns_for(suspects: tuple[str, ...]) -> list[str]:
    """Return the checks that tell at least two of the suspects apart, cheap ones first."""
    useful = [key for key in TROLLEY if len({kind_expected(suspect, key) for suspect in suspects}) > 1]
    return sorted(useful, key=lambda key: TROLLEY[key].minutes)


def suspects_table(suspects: tuple[str, ...], checks: list[str]) -> dict[str, dict[str, str]]:
    """Return what each suspect would say to each check, as `draw_suspects` takes it."""
    return {suspect: {check: kind_expected(suspect, check) for check in checks} for suspect in suspects}


class ClinicPanel(Panel):
    """A visit with controls.

    Attributes:
        visit: the same, to be carried on in code.
    """

    def __init__(self, visit: Visit) -> None:
        self.visit = visit
        words = LABELS[visit.language]
        complaint = COMPLAINTS.get(visit.patient.complaint)
        suspects = complaint.suspects if complaint else SUSPECTS
        self._columns = columns_for(suspects)
        options = [(f"{check.command} ({check.minutes:g} min)", key) for key, check in TROLLEY.items()]
        check = widgets.Dropdown(options=options, description=words["check"], layout={"width": "430px"})
        because = widgets.Dropdown(
            options=[(words["nobody"], ""), *((suspect, suspect) for suspect in suspects)],
            description=words["because"], layout={"width": "300px"},
        )  # fmt: skip
        button = widgets.Button(description=words["ask"], button_style="primary")
        button.on_click(lambda _: self.ask())
        self._check, self._because = check, because
        self._readings = widgets.HTML(f"<pre>{escape(visit.opening())}</pre>")
        picture = draw_suspects(suspects_table(suspects, self._columns))
        super().__init__(
            "clinic", picture, [], self._move,
            layout=[side_by_side([check, because, button]), self._readings],
        )  # fmt: skip

    @property
    def text(self) -> str:
        """The clock, and the table in words."""
        return f"{self.visit.clock()}\n{self.picture.text}"

    def ask(self) -> None:
        """Ask what is chosen."""
        said = self.visit.take(self._check.value, self._because.value)
        command = escape(TROLLEY[self._check.value].command)
        clock = escape(self.visit.clock())
        self._readings.value = f"<b>{clock}</b><pre>$ {command}\n{escape(said)}</pre>"
        self.redraw()

    def _move(self, at: At) -> None:
        asked = {check: kind for check, kind in self.visit.found.items() if check in self._columns}
        self.picture.tell(asked if self.visit.helped else {})


def clinic_panel(patient: SickRobot, language: str = "en", helped: bool = True) -> ClinicPanel:
    """Return a visit to a patient, with controls; where the table helps, it strikes whom a reading does not fit."""
    return ClinicPanel(Visit(SickRobot.unpacked(patient.packed()), language, helped))
