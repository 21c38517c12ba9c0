"""E4.5: What happens to this name?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

OPTIONS = ("kept as odom", "another frame", "refused when sent", "refused when asked", "shared by accident")
LINES = {
    "send '/odom' -> 'base_link'": "kept as odom",
    "send 'Odom' -> 'base_link'": "another frame",
    "send '//odom' -> 'base_link'": "another frame",
    "send '' -> 'base_link'": "refused when sent",
    "send 'odom' -> 'odom'": "refused when sent",
    "ask lookup_transform('/odom', 'base_link', Time())": "refused when asked",
    "robot1 and robot2 both send 'map' -> 'odom'": "shared by accident",
    "robot1 and robot2, each in a namespace of its own, both send 'odom' -> 'base_link'": "shared by accident",
}
LETTERS = "abcdefgh"


def draw_lines(rng):
    order = [list(LINES)[int(number)] for number in rng.permutation(len(LINES))]
    return {"lines": dict(zip(LETTERS, order, strict=True))}


def judge_lines(
    given,
    *,
    slash="forgiven",
    case="told apart",
    double="told apart",
    senseless="refused",
    asked="refused",
    namespace="no prefix",
    shared="told",
):
    """Return what happens to each line, one belief after the other; other arguments are mistakes."""
    beliefs = {
        "send '/odom' -> 'base_link'": {"forgiven": "kept as odom"}.get(slash, slash),
        "send 'Odom' -> 'base_link'": {"told apart": "another frame", "ignored": "kept as odom"}.get(case, case),
        "send '//odom' -> 'base_link'": {"told apart": "another frame"}.get(double, double),
        "send '' -> 'base_link'": {"refused": "refused when sent", "stored": "another frame"}.get(senseless, senseless),
        "send 'odom' -> 'odom'": {"refused": "refused when sent", "stored": "kept as odom"}.get(senseless, senseless),
        "ask lookup_transform('/odom', 'base_link', Time())": {"refused": "refused when asked"}.get(asked, asked),
        "robot1 and robot2 both send 'map' -> 'odom'": {"told": "shared by accident", "fine": "kept as odom"}.get(
            shared, shared
        ),
        "robot1 and robot2, each in a namespace of its own, both send 'odom' -> 'base_link'": {
            "no prefix": "shared by accident"
        }.get(namespace, namespace),
    }
    return {letter: beliefs[line] for letter, line in given.lines.items()}


TASK = define_task(
    __file__,
    kind="M",
    points=3,
    answer="fates",
    form=Parts({letter: Choice(OPTIONS) for letter in LETTERS}),
    given=draw_lines,
    variants=8,
    model=judge_lines,
)
