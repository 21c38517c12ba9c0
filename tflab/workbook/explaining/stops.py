"""Did a function stop in some calls, and is it wrong in others?  Each is told apart: what stops hides no other mistake.

```
asked for   1.0   2.0   3.0          returned   -1.0   -2.0   TypeError
                                     -> in 1 of 3 calls it stops; where it does not, the sign is wrong
asked for   "ok"  "lookup"           returned   "ok"  LookupException     goes through, and wants a word
```
"""

from __future__ import annotations

from collections.abc import Sequence

from ...text import Text, Texts
from ..answers.forms import Choice
from ..answers.values import Plain, is_raised
from ..mistakes.fitting import ANY_BUG, alike
from ..mistakes.python_errors import tip_for
from ..tasks.case_types import Case, TaskCases
from .explanation import Explains, Explanation, and_then

__all__ = ["of_stops"]

TEXTS = Texts(__file__)

OF_TF2 = {"ConnectivityException", "ExtrapolationException", "InvalidArgumentException", "LookupException"}
BUGS = ANY_BUG | {"AssertionError", "ZeroDivisionError"}
FEWEST = 3  # calls that have to go on, for what is wrong in them to be no chance


def of_stops(
    task: TaskCases,
    cases: Sequence[Case],
    outcomes: Sequence[Plain],
    explained: Explains,
) -> Explanation | None:
    """Return what `explained` says of the calls that go on, and then that others stop; None if either is missing."""
    pairs = list(zip(cases, outcomes, strict=True))
    stopped = [outcome for case, outcome in pairs if is_raised(outcome) and not is_raised(case.expected)]
    rest = [(case, outcome) for case, outcome in pairs if not is_raised(outcome) or is_raised(case.expected)]
    if not stopped:
        return None
    is_rest_right = all(alike(task.form, outcome, case.expected) for case, outcome in rest)
    first = None if is_rest_right else explained(task, *zip(*rest, strict=True))  # any slip fits that shows in none
    if (uncaught := _uncaught(task, pairs, stopped)) is not None:
        return and_then(first, uncaught) if first else uncaught
    if first is None or len(rest) < FEWEST or stopped[0]["raises"] not in BUGS:
        return None
    error, tip = stopped[0]["raises"], tip_for(stopped[0]["raises"], stopped[0].get("text", ""))
    filled = {"stopped": len(stopped), "of": len(pairs), "error": error}
    said = Text(*map(str.rstrip, TEXTS["stops"].filled(**filled, tip=tip)))
    return and_then(first, Explanation.of(f"stops: {error}", said))


def _uncaught(task: TaskCases, pairs: Sequence[tuple[Case, Plain]], stopped: Sequence[Plain]) -> Explanation | None:
    """Return that tf2's own exceptions go through a function which is to put each of them into a word."""
    errors = sorted({str(outcome["raises"]) for outcome in stopped})
    is_of_words = isinstance(task.form, Choice) and not any(is_raised(case.expected) for case, _ in pairs)
    if not errors or not is_of_words or not all(error in OF_TF2 for error in errors):
        return None
    names = ", ".join(errors)
    return Explanation.of("uncaught", TEXTS["uncaught"].filled(stopped=len(stopped), of=len(pairs), errors=names))
