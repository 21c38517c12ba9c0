"""Whom does one treat on the board, and in the oral examination?  Six sick robots: a complaint, one output, the truth.

    solutions/teaching/patients/2_no_robot.yaml
      said, command, text    what the room gets: "it drives, I can hear it", and what one tool printed
      rules_out, next, no_timeout, truth     what you want to hear

They were made by the clinic's ward, from a public number; what stands here is what was
printed then (a test compares).
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from tflab.text import Text
from tflab.workbook.paths import workbook_data

from ..reports.html import text
from .layout import grid, inline
from .teaching import TEACHING, TeachingError, as_words, read_yaml, said_once

__all__ = ["BoardPatient", "board_patients", "patients_section"]

FOLDER = "patients"
SPOKEN = ("said", "rules_out", "next", "no_timeout", "truth")
TITLE = Text("Six patients for the board, and the oral clinic", "칠판용 환자 여섯과 구술 진료")
HOW = Text(
    "On the board: read the complaint, show the output, ask the three questions. As an examination, five minutes and "
    "one patient: a point each for reading the output, for what it rules out, for a cheap next question, and for a "
    "proof. Nobody has to name the cause at once; who names it without a proof has three points at most.",
    "칠판에서는 증상을 읽고 출력을 보인 다음 세 가지를 묻습니다. 시험에서는 5분에 환자 하나입니다. "
    "출력 읽기, 지워지는 것, 값싼 다음 질문, 증명에 1점씩입니다. "
    "원인을 바로 맞히지 않아도 됩니다. 증명 없이 원인만 맞히면 3점까지입니다.",
)
ASKED = (
    ("rules_out", Text("What does this rule out?", "이것으로 무엇이 지워집니까?")),
    ("next", Text("What would you ask next, and why?", "다음에는 무엇을, 왜 묻겠습니까?")),
    ("no_timeout", Text("Why not a longer timeout?", "왜 timeout을 늘리지 않습니까?")),
    ("truth", Text("Truth", "실제 원인")),
)


class BoardPatient(NamedTuple):
    """One patient; `words` holds what is said, by its name in the file."""

    cause: str
    number: int
    check: str
    command: str
    text: str
    words: dict[str, Text]


def board_patients(data: Path | None = None) -> list[BoardPatient]:
    """Return the patients, in order; none where there are none.

    Raises:
        TeachingError: a file lacks something, or says it in one language.
    """
    found, faults = [], []
    for path in sorted(((data or workbook_data()) / TEACHING / FOLDER).glob("*.yaml")):
        shown = f"{FOLDER}/{path.name}"
        plain = read_yaml(path, shown)
        lacks = [name for name in (*BoardPatient._fields[:-1], *SPOKEN) if name not in plain]
        faults += [f"{shown} lacks `{name}`" for name in lacks] + list(said_once(plain, f"{shown}:"))
        if not lacks:
            words = {name: as_words(plain[name]) for name in SPOKEN}
            found.append(BoardPatient(*(plain[name] for name in BoardPatient._fields[:-1]), words))
    if faults:
        raise TeachingError(*faults)
    return found


def patients_section(patients: list[BoardPatient], language: str) -> str:
    """Return the patients as a part of a guide."""
    parts = [
        f'<section class="chapter" id="patients"><h1>{text(TITLE.say(language))}</h1><p>{text(HOW.say(language))}</p>'
    ]
    for number, patient in enumerate(patients, start=1):
        said = patient.words
        rows = [(text(asked.say(language)), inline(said[name].say(language))) for name, asked in ASKED]
        parts.append(
            f"<h3>{number}. “{text(said['said'].say(language))}”</h3>"
            f"<pre><code>$ {text(patient.command)}\n{text(patient.text.rstrip())}</code></pre>{grid(('', ''), rows)}"
        )
    return "\n".join([*parts, "</section>"])
