"""Run one diagnosis exercise: checks that cost minutes, a diagnosis, and then a fix.

    visit = admit(patient)                          the complaint, RViz's screen, the card; twelve minutes
    visit.ask("delay /scan", because="laser clock ahead")
    visit.rule_out("odometry slow")                 remove a suspect from your list
    visit.say(cause=..., frame=..., owner=..., fix=...)
    visit.try_fix()                                 the robot after it

Whatever is misspelt is refused before it costs anything.

Nobody repairs here on a suspicion: as long as the readings fit another suspect as
well, or do not fit the one that was named, no fix is tried.
"""

from __future__ import annotations

from typing import NamedTuple

from tflab.text import Texts

from .checks import CHECKS, find_check, unknown_name_error
from .fixes import DIAGNOSES
from .patient import FaultyRobot, result_of_fix, translate_output
from .proof import NOTHING_IS_WRONG, best_check, consistent_suspects
from .table import COMPLAINTS, DECIDING, SENSOR_BROKEN, SUSPECTS

__all__ = ["FixTried", "Visit", "VisitEntry", "admit"]

TEXTS = Texts(__file__)
FRAMES = dict.fromkeys(remedy.frame for remedy in DIAGNOSES.values())
OWNERS = dict.fromkeys(remedy.owner for remedy in DIAGNOSES.values())


class VisitEntry(NamedTuple):
    """One question of a visit: which check, what it cost [min], what it said, why it was asked, who was left then."""

    check: str
    minutes: float
    finding: str
    because: str
    suspects: tuple[str, ...]


class FixTried(NamedTuple):
    """One fix of a visit: which, what it cost [min], and what was seen after it."""

    fix: str
    minutes: float
    text: str


class Visit:
    """A patient, a clock and a list of suspects.

    Args:
        language: of what is printed, "en" or "ko".
        helped: whether the table strikes the suspects that a reading does not fit; otherwise one does so oneself.

    Attributes:
        log: what was asked.
        tried: which fixes were tried.
        suspects: who is not struck yet.
        diagnosis: what was said last; empty before.
    """

    def __init__(self, patient: FaultyRobot, language: str = "en", helped: bool = False) -> None:
        self.patient, self.language, self.helped = patient, language, helped
        self.log: list[VisitEntry] = []
        self.tried: list[FixTried] = []
        complaint = COMPLAINTS.get(patient.complaint)
        self.suspects = complaint.suspects if complaint else SUSPECTS
        self._all = self.suspects
        self.diagnosis: dict[str, str] = {}

    @property
    def minutes(self) -> float:
        """What the visit took so far [min]."""
        return sum(asked.minutes for asked in self.log)

    @property
    def found(self) -> dict[str, str]:
        """Of each check that was asked the kind of its finding."""
        return {asked.check: CHECKS[asked.check].kind(asked.finding) for asked in self.log}

    def opening(self) -> str:
        """Return what is known before the first check: the complaint, RViz, the card and the budget."""
        complaint = COMPLAINTS.get(self.patient.complaint)
        said = getattr(complaint, self.language) if complaint else self._say("nothing")
        screen = f"\nRViz\n{_indented(_folded(self.patient.screen))}\n" if complaint else ""
        card, budget = (
            self._say("card"),
            self._say("budget", left=self.patient.budget_min, suspects=", ".join(self._all)),
        )
        return f"{said}\n{screen}\n{card}\n\n{budget}"

    def ask(self, check: str, because: str = "") -> None:
        """Print what a check says, and what time is left; `because` says whom one suspects, or why one asks.

        Raises:
            ValueError: there is no such check, or `because` is a second one.
        """
        before = {asked.check for asked in self.log}
        text = self.take(check, because)
        again = self._say("again") + "\n" if self.log[-1].check in before else ""
        print(f"{self._typed(check)}\n{text}\n\n{again}{self.clock()}")

    def take(self, check: str, because: str = "") -> str:
        """Ask without printing, and return the text."""
        key = find_check(check).key
        if any(because in (each.key, each.command) for each in CHECKS.values()):
            raise ValueError(f'one check at a time: first "{key}", then "{because}"')
        minutes, text, finding = self.patient.reading(key)
        if self.helped:
            kind = CHECKS[key].kind(finding)
            self.suspects = consistent_suspects({key: kind}, self.suspects)
        self.log.append(VisitEntry(key, minutes, finding, because, self.suspects))
        return translate_output(text, self.language)

    def rule_out(self, *suspects: str) -> None:
        """Take suspects off one's own list.

        Raises:
            ValueError: there is no such suspect.
        """
        for suspect in suspects:
            self._known(suspect)
        self.suspects = tuple(each for each in self.suspects if each not in suspects)
        print(self.clock())

    def clock(self) -> str:
        """Return what the visit took, and who is still suspected."""
        left, suspects = self.patient.budget_min - self.minutes, ", ".join(self.suspects) or "-"
        if left < 0:
            return self._say("over", minutes=self.minutes, over=-left, suspects=suspects)
        return self._say("clock", minutes=self.minutes, left=left, budget=self.patient.budget_min, suspects=suspects)

    def say(self, cause: str, frame: str = "", owner: str = "", fix: str = "") -> None:
        """Note a diagnosis, and print what speaks against it: what was asked, or what should be.

        Raises:
            ValueError: the cause is no suspect, or there is no such frame, owner or fix.
        """
        self._known(cause)
        for name, what, names in ((frame, "frame", FRAMES), (owner, "owner", OWNERS), (fix, "fix", self.patient.fixes)):
            if name and name not in list(names):
                raise unknown_name_error(name, f"no {what}", names)
        self.diagnosis = {"cause": cause, "frame": frame, "owner": owner, "fix": fix}
        if cause in self._all and cause not in self.suspects and not self.helped:
            print(self._say("struck", cause=cause))
        print(self._doubt(cause) or self._say("noted" if fix else "no_fix"))

    def fixes(self) -> None:
        """Print what can be done about it: every fix, the plasters among them."""
        print("\n".join(self.patient.fixes))

    def try_fix(self, fix: str = "") -> None:
        """Print the robot after this fix, or that which was said, if the readings warrant the diagnosis; else why not.

        Raises:
            ValueError: there is no such fix.
        """
        if fix and fix not in self.patient.fixes:
            raise unknown_name_error(fix, "no fix", self.patient.fixes)
        if fix and self.diagnosis:
            self.diagnosis["fix"] = fix
        print(self._refusal() or self._after())

    def _after(self) -> str:
        fix = self.diagnosis["fix"]
        minutes, text = result_of_fix(self.patient, fix)
        self.tried.append(FixTried(fix, minutes, text))
        return self._say("after", fix=fix, minutes=minutes) + f"\n{_indented(translate_output(text, self.language))}"

    def _refusal(self) -> str:
        """Return why no fix is tried yet, or ""."""
        if not self.diagnosis:
            return self._say("no_diagnosis")
        return self._doubt(self.diagnosis["cause"]) or ("" if self.diagnosis["fix"] else self._say("no_fix"))

    def _doubt(self, cause: str) -> str:
        """Return what the readings say against a cause, with a check that was asked or should be; "" if nothing."""
        for asked in self.log:
            if not consistent_suspects({asked.check: CHECKS[asked.check].kind(asked.finding)}, [cause]):
                finding = translate_output(asked.finding, self.language)
                return self._say("contradicted", cause=cause, command=self._done(asked.check), finding=finding)
        rivals = [each for each in consistent_suspects(self.found, self._all) if each != cause]
        if rivals:
            command, why = self._done(best_check([cause, *rivals])), "not_apart" if self.log else "nothing_asked"
            return self._say(why, cause=cause, count=len(rivals), command=command)
        is_sick = any(kind != CHECKS[check].usual for check, kind in self.found.items())
        if is_sick or cause == NOTHING_IS_WRONG:
            return ""
        return self._say("nothing_sick", command=self._done(DECIDING[cause]))

    def _done(self, check: str) -> str:
        return CHECKS[check].instruction(self.language)

    def _typed(self, check: str) -> str:
        command = self._done(find_check(check).key)
        return f"$ {command}" if command.startswith("ros2 ") else command

    def _known(self, suspect: str) -> None:
        if suspect not in (*SUSPECTS, SENSOR_BROKEN):
            raise unknown_name_error(suspect, "no suspect", SUSPECTS)

    def _say(self, name: str, **names: object) -> str:
        return TEXTS[name].say(self.language, **names)


def admit(patient: FaultyRobot, language: str = "en", helped: bool = False) -> Visit:
    """Let a patient in: print its complaint, its card and the budget, and return the visit.

    Raises:
        TypeError: that is no patient.
    """
    if not isinstance(patient, FaultyRobot):
        raise TypeError(f"a patient is needed, such as practice_patient(3) or e12_4.a, not {type(patient).__name__}")
    visit = Visit(FaultyRobot.unpacked(patient.packed()), language, helped)
    print(visit.opening())
    return visit


def _indented(text: str) -> str:
    return "\n".join(f"  {line}" for line in text.splitlines())


def _folded(screen: str) -> str:
    """Return RViz's list as it stands there: what is Ok is folded."""
    lines, is_ok = [], False
    for line in screen.splitlines():
        if not line.startswith(" "):
            is_ok = line.endswith(": Ok") and not line.startswith("Global")
        if not is_ok or not line.startswith(" "):
            lines.append(line)
    return "\n".join(lines)
