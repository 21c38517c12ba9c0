"""E12.4: Three patients."""

from __future__ import annotations

from tflab.clinic.fixes import DIAGNOSES
from tflab.clinic.proof import shortest_proof
from tflab.workbook.tasks import Choice, Parts, Proof, define_task

from .draws import CAUSES, FIXES, FRAMES, OWNERS, cause_of, draw_patients, everything

GROUPS = (("no map", "no robot", "no scan"), ("jumps", "beside the walls"), ("flickers",))
FORMS = {
    "checks": Proof(),
    "cause": Choice(CAUSES),
    "frame": Choice(FRAMES),
    "owner": Choice(OWNERS),
    "fix": Choice(FIXES),
}
PARTS = {f"{who} {what}": form for who in "abc" for what, form in FORMS.items()}


def draw_three(rng):
    """Draw a patient that shows too little, one that shows something wrong, and one with a time fault."""
    return dict(zip("abc", draw_patients(rng, GROUPS), strict=True))


def right(given):
    """Return the right answer from all evidence."""
    answers = {}
    for who in "abc":
        cause = cause_of(getattr(given, who))
        told = {"checks": (cause, shortest_proof(cause)), "cause": cause, **DIAGNOSES[cause]._asdict()}
        answers |= {f"{who} {what}": answer for what, answer in told.items()}
    return answers


def but(what, value):
    """Return the right answers with another value for one part in all three patients."""
    return lambda given: right(given) | {f"{who} {what}": value for who in "abc"}


ANSWERS = {
    "sensor broken": but("cause", "sensor broken"),
    "new sensor": but("fix", "new sensor"),
    "longer timeout": but("fix", "timeout of 1 s"),
    "newest instead": but("fix", "ask with Time()"),
    "stamp on arrival": but("fix", "stamp on arrival"),
    "restart": but("fix", "restart everything"),
    "shotgun": but("checks", everything()),
}

TASK = define_task(
    __file__,
    kind="D",
    points=6,
    answer="patients",
    form=Parts(PARTS),
    given=draw_three,
    variants=6,
    is_costly=True,
    answers=ANSWERS,
)
