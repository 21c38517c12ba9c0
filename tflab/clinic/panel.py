"""Show a diagnosis exercise with controls: menus for tool and cause, the minutes left, a table of findings.

    check [ delay /scan ]  because [ laser clock ahead ]  ( Ask )      [=======   ] 10 of 12 left
    cause [ laser clock ahead ]  fix [ set the laser's clock ]  ( Try )
    +--------------------------------+
    |  suspects by checks            |    what was printed above it, what each question cost below
    +--------------------------------+

Which checks stand in the table is its own choice: those that can tell the suspects
of this complaint apart.  The same visit can be carried on in code: `panel.visit`.
Where nobody can ask, on an exported page, it shows what each check would say.
"""

from __future__ import annotations

from contextlib import redirect_stdout
from html import escape
from io import StringIO

from tflab.text import language_of_workbook
from tflab.views.diagnosis_log import describe_order, draw_order
from tflab.views.fault_tables import draw_suspects
from tflab.views.libraries import ipywidgets as widgets
from tflab.views.panels.panel import Panel, side_by_side
from tflab.views.panels.prefetch import Controls
from tflab.views.slider_frames import Film

from .checks import CHECKS
from .examples import MINUTES
from .patient import FaultyRobot
from .table import expected_kind
from .visit import Visit

__all__ = ["ClinicPanel", "clinic_panel", "columns_for", "suspects_table"]

LABELS = {
    "en": {
        "check": "check", "because": "because", "ask": "Ask", "nobody": "(nobody yet)", "cause": "cause", "fix": "fix",
        "try": "Try", "clock": "min left", "title": "The clinic",
    },
    "ko": {
        "check": "검사", "because": "의심하는 원인", "ask": "검사하기", "nobody": "(아직 없음)",
        "cause": "원인", "fix": "처치", "try": "해 보기", "clock": "남은 시간", "title": "진료실",
    },
}  # fmt: skip


def columns_for(suspects: tuple[str, ...]) -> list[str]:
    """Return the checks that tell at least two of the suspects apart, cheap ones first."""
    useful = [key for key in CHECKS if len({expected_kind(suspect, key) for suspect in suspects}) > 1]
    return sorted(useful, key=lambda key: CHECKS[key].minutes)


def suspects_table(suspects: tuple[str, ...], checks: list[str]) -> dict[str, dict[str, str]]:
    """Return what each suspect would say to each check, as `draw_suspects` takes it."""
    return {suspect: {check: expected_kind(suspect, check) for check in checks} for suspect in suspects}


class ClinicPanel(Panel):
    """A visit with controls.

    Attributes:
        visit: the same, to be carried on in code.
    """

    def __init__(self, visit: Visit) -> None:
        self.visit = visit
        self._labels = LABELS[visit.language]
        suspects = visit.suspects
        self._columns = columns_for(suspects)
        self._check = self._menu("check", [(self._priced(key), key) for key in CHECKS], "430px")
        nobody = (self._labels["nobody"], "")
        self._because = self._menu("because", [nobody, *((each, each) for each in suspects)], "300px")
        self._cause = self._menu("cause", [nobody, *((each, each) for each in suspects)], "300px")
        self._fix = self._menu("fix", list(visit.patient.fixes), "430px")
        budget_min = visit.patient.budget_min
        self._clock = widgets.FloatProgress(
            value=budget_min, min=0.0, max=budget_min, description=self._labels["clock"], layout={"width": "300px"}
        )
        self._readings = widgets.HTML(f"<pre>{escape(visit.opening())}</pre>")
        self._order = widgets.Image(format="png", layout={"display": "none", "max_width": "100%"})
        rows = [
            side_by_side([self._check, self._because, self._button("ask", self.ask), self._clock]),
            side_by_side([self._cause, self._fix, self._button("try", self.try_fix)]),
        ]
        picture = draw_suspects(suspects_table(suspects, self._columns))
        super().__init__(self._labels["title"], picture, [], self._move, layout=[*rows, self._readings])
        self.widget.children = (*self.widget.children, self._order)

    @property
    def text(self) -> str:
        """The clock, the table and the questions in words."""
        return f"{self.visit.clock()}\n{self.picture.text}\n{describe_order(self._questions())}"

    def ask(self) -> None:
        """Ask what is chosen."""
        with redirect_stdout(StringIO()) as printed:
            self.visit.ask(self._check.value, self._because.value)
        order = draw_order(self._questions())
        self._order.value, self._order.layout.display = order.png(), "block"
        self._order.layout.width = f"{order.size_px[0]}px"
        self._clock.value = max(0.0, self.visit.patient.budget_min - self.visit.minutes)
        self._clock.bar_style = "" if self._clock.value else "danger"
        self._tell(printed.getvalue())

    def try_fix(self) -> None:
        """Say the cause that is chosen, and try the fix."""
        with redirect_stdout(StringIO()) as printed:
            if self._cause.value:
                self.visit.say(self._cause.value, fix=self._fix.value)
                printed.truncate(printed.seek(0))
            self.visit.try_fix()
        self._tell(printed.getvalue())

    def film(self, steps: int = 0) -> widgets.VBox:
        """Return the panel as it lives on without a kernel: what each check would say, and who would be left."""
        pictures, texts, words = [], [], []
        for key in CHECKS:
            alone = Visit(FaultyRobot.unpacked(self.visit.patient.packed()), self.visit.language, helped=True)
            with redirect_stdout(StringIO()) as printed:
                alone.ask(key)
            self.picture.tell({check: kind for check, kind in alone.found.items() if check in self._columns})
            pictures.append(self.picture.live_png())
            texts.append(self._priced(key))
            words.append(f"{printed.getvalue()}{self.picture.text}")
        self.redraw()
        return widgets.VBox([self._readings, Film(pictures, texts, words, self.picture.size_px)])

    def _tell(self, printed: str) -> None:
        clock = self.visit.clock()
        said = printed.rstrip().removesuffix(clock).rstrip()  # once, and not below all that a tool printed
        self._readings.value = f"<b>{escape(clock)}</b><pre>{escape(said)}</pre>"
        self.redraw()

    def _questions(self) -> list[tuple[str, float, int]]:
        return [(asked.check, asked.minutes, len(asked.suspects)) for asked in self.visit.log]

    def _move(self, at: Controls) -> None:
        asked = {check: kind for check, kind in self.visit.found.items() if check in self._columns}
        self.picture.tell(asked if self.visit.helped else {})

    def _priced(self, key: str) -> str:
        language = self.visit.language
        minutes = MINUTES[language].format(minutes=CHECKS[key].minutes).strip()
        return f"{CHECKS[key].instruction(language)} ({minutes})"

    def _menu(self, name: str, options: list, width: str) -> widgets.Dropdown:
        words = self._labels[name]
        return widgets.Dropdown(
            options=options, description=words, tooltip=words, layout={"width": width, "max_width": "100%"}
        )

    def _button(self, name: str, press) -> widgets.Button:
        button = widgets.Button(description=self._labels[name], button_style="primary")
        button.on_click(lambda _: press())
        return button


def clinic_panel(patient: FaultyRobot, helped: bool = True) -> ClinicPanel:
    """Return a visit to a patient, with controls; where the table helps, it strikes whom a reading does not fit."""
    return ClinicPanel(Visit(FaultyRobot.unpacked(patient.packed()), language_of_workbook(), helped))
