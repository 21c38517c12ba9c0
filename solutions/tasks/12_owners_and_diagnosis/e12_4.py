"""E12.4: Three patients."""

from __future__ import annotations

from tflab.clinic.cures import DIAGNOSES
from tflab.clinic.proof import shortest_proof
from tflab.workbook.tasks import Choice, Parts, Proof, Task, Text, WrongAnswer

from .draws import CAUSES, FIXES, FRAMES, MEANS, OWNERS, admitted, cause_of, everything

GROUPS = (("no map", "no robot", "no scan"), ("jumps", "beside the walls"), ("flickers",))
FORMS = {
    "checks": Proof(),
    "cause": Choice(CAUSES),
    "frame": Choice(FRAMES),
    "owner": Choice(OWNERS),
    "fix": Choice(FIXES),
}
PARTS = {f"{who} {what}": form for who in "abc" for what, form in FORMS.items()}


def three(rng):
    """Draw one who shows too little, one who shows something wrong, and one whose time is out of joint."""
    return dict(zip("abc", admitted(rng, GROUPS), strict=True))


def right(given):
    """Return what is right, worked out from all evidence."""
    answers = {}
    for who in "abc":
        cause = cause_of(getattr(given, who))
        told = {"checks": (cause, shortest_proof(cause)), "cause": cause, **DIAGNOSES[cause]._asdict()}
        answers |= {f"{who} {what}": answer for what, answer in told.items()}
    return answers


def but(what, value):
    """Return the right answers, but for one kind of part another value in all three patients."""
    return lambda given: right(given) | {f"{who} {what}": value for who in "abc"}


SENSOR_BROKEN = WrongAnswer(
    "sensor broken",
    but("cause", "sensor broken"),
    Text(
        en="It sends 360 points ten times a second, with a frame and a stamp. Which line of RViz says what it could not do with them?",
        ko="센서는 360개의 점을 1초에 열 번, 좌표계와 측정 시각을 붙여 보냅니다. 그것으로 무엇을 못 했는지 RViz의 어느 줄에 나옵니까?",
    ),
    "M15",
    partly=True,
)

NEW_SENSOR = WrongAnswer(
    "new sensor",
    but("fix", "new sensor"),
    Text(
        en="A new sensor sends the same points into the same tree. Look at what `try_fix` shows after it.",
        ko="새 센서도 같은 점을 같은 트리로 보냅니다. 그 뒤에 `try_fix`가 무엇을 보여 주는지 보십시오.",
    ),
    "M15",
    partly=True,
)

LONGER_TIMEOUT = WrongAnswer(
    "longer timeout",
    but("fix", "timeout of 1 s"),
    Text(
        en="Waiting helps against what comes late. What never comes, or is stamped wrong, is not cured by it: how far from the walls are the points then?",
        ko="기다리면 늦게 오는 것에만 도움이 됩니다. 아예 오지 않거나 시각이 틀린 것은 낫지 않습니다. 그때 점은 벽에서 얼마나 떨어져 있습니까?",
    ),
    "M10",
    partly=True,
)

NEWEST_INSTEAD = WrongAnswer(
    "newest instead",
    but("fix", "ask with Time()"),
    Text(
        en="`Time()` takes the error away and the moment with it: old points under a new pose. Green is not cured.",
        ko="`Time()`을 쓰면 오류와 함께 측정 시각도 사라집니다. 옛 점을 새 포즈에 놓게 됩니다. 초록색이라고 나은 것은 아닙니다.",
    ),
    "M9",
    partly=True,
)

STAMP_ON_ARRIVAL = WrongAnswer(
    "stamp on arrival",
    but("fix", "stamp on arrival"),
    Text(
        en="Then the stamp says when somebody heard it, not when it was measured. The one who stamps wrongly stays as he was.",
        ko="그러면 측정 시각이 아니라 받은 시각이 적힙니다. 시각을 틀리게 적는 쪽은 그대로입니다.",
    ),
    "M9",
    partly=True,
)

RESTART = WrongAnswer(
    "restart",
    but("fix", "restart everything"),
    Text(
        en="After a restart the same nodes start with the same settings. Nothing that you proved is changed by it.",
        ko="다시 켜도 같은 노드가 같은 설정으로 시작합니다. 증명한 것은 하나도 바뀌지 않습니다.",
    ),
    partly=True,
)

SHOTGUN = WrongAnswer(
    "shotgun",
    but("checks", everything()),
    Text(
        en="That is the whole trolley. A check is worth what it rules out: which of these would have come out differently for the other two suspects?",
        ko="트롤리 전체를 다 쓴 것입니다. 검사의 값어치는 무엇을 지우느냐에 있습니다. 다른 두 용의자라면 다르게 나왔을 검사는 무엇입니까?",
    ),
    partly=True,
)


TASK = Task(
    id="E12.4",
    kind="D",
    points=6,
    title=Text(en="Three patients", ko="환자 세 명"),
    answer="patients",
    form=Parts(PARTS),
    given=three,
    variants=6,
    is_costly=True,
    mistakes=(SENSOR_BROKEN, NEW_SENSOR, LONGER_TIMEOUT, NEWEST_INSTEAD, STAMP_ON_ARRIVAL, RESTART, SHOTGUN),
    means=MEANS,
    hints=(
        Text(
            en="The complaint names three suspects. For each check ask first: would they answer differently?",
            ko="증상마다 용의자가 셋입니다. 검사하기 전에 물어보세요. 셋의 답이 다르겠습니까?",
        ),
        Text(
            en='`lesson.show_findings("no map")` prints what each suspect of a complaint would answer; for yours, put in its name. A check for which all three say the same is left out: it tells nothing.',
            ko='`lesson.show_findings("no map")`이 그 증상의 용의자마다 나올 소견을 출력합니다. 여러분의 증상 이름을 넣으십시오. 셋의 소견이 똑같은 검사는 알려 주는 것이 없어 빠져 있습니다.',
        ),
        Text(
            en="Hand in what would have been enough, not what you asked: one or two checks, the last of which strikes the last rival.",
            ko="물어본 것이 아니라 충분했을 것을 내십시오. 한두 개면 되고, 마지막 검사가 마지막 경쟁자를 지워야 합니다.",
        ),
    ),
    misconceptions=("M6", "M7", "M9", "M10", "M11", "M15"),
)
