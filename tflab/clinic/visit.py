"""How does one examine a patient?  A visit: questions that cost minutes, a diagnosis, and then, perhaps, a fix.

    visit = admit(patient)                          the complaint, RViz's screen, the card; twelve minutes
    visit.ask("delay /scan", because="laser clock ahead")
    visit.strike("odometry slow")                   a suspect less on one's own list
    visit.say(cause=..., frame=..., owner=..., fix=...)
    visit.try_fix()                                 the robot after it

Whatever is misspelt is refused before it costs anything.

Nobody repairs here on a suspicion: as long as the readings fit another suspect as
well, or do not fit the one that was named, no fix is tried.
"""

from __future__ import annotations

from typing import NamedTuple

from .cures import DIAGNOSES
from .patient import SickRobot, seen_after
from .proof import NOTHING_IS_WRONG, best_check, fitting
from .table import COMPLAINTS, DECIDING, SENSOR_BROKEN, SUSPECTS
from .told import done, told
from .trolley import TROLLEY, check_named, no_such

__all__ = ["CARD", "FixTried", "Visit", "VisitEntry", "admit"]

CARD = {
    "en": """\
The robot when it is well
  tree    map -> odom -> base_footprint -> base_link -> laser_frame, and the other parts
  owners  map -> odom                 /localization, 10 Hz, 0.010 s behind
          odom -> base_footprint      /wheel_odometry, 20 Hz, 0.004 s behind
          base_link -> laser_frame    /laser_mount, static, x 0.200 y 0.000 z 0.150
          the rest                    /robot_state_publisher
  data    /odom 20 Hz, 0.004 s behind     /scan 10 Hz, 0.105 s behind, header laser_frame
  nodes   joint_driver laser_driver laser_mount localization map_server robot_state_publisher wheel_odometry
          (RViz is open only while you look at it, and so in no list of nodes)""",
    "ko": """\
정상일 때의 로봇
  트리    map -> odom -> base_footprint -> base_link -> laser_frame, 그 밖의 부품
  발행자  map -> odom                 /localization, 10 Hz, 0.010초 늦음
          odom -> base_footprint      /wheel_odometry, 20 Hz, 0.004초 늦음
          base_link -> laser_frame    /laser_mount, static, x 0.200 y 0.000 z 0.150
          나머지                      /robot_state_publisher
  데이터  /odom 20 Hz, 0.004초 늦음   /scan 10 Hz, 0.105초 늦음, header는 laser_frame
  노드    joint_driver laser_driver laser_mount localization map_server robot_state_publisher wheel_odometry
          (RViz는 들여다볼 때만 켜므로 노드 목록에 나오지 않음)""",
}

FRAMES = dict.fromkeys(remedy.frame for remedy in DIAGNOSES.values())
OWNERS = dict.fromkeys(remedy.owner for remedy in DIAGNOSES.values())

WORDS = {
    "en": {
        "nothing": "It does not work.",
        "budget": "You have {left:g} minutes. Suspects: {suspects}",
        "clock": "{minutes:g} min; {left:g} of {budget:g} left. Your suspects: {suspects}",
        "over": "{minutes:g} min; the time is up, {over:g} minutes over. Your suspects: {suspects}",
        "again": "You asked this before: it says the same, and takes its minutes once more.",
        "noted": "Noted: your readings prove this cause. Now `try_fix()`.",
        "no diagnosis": "First a diagnosis: say(cause=..., frame=..., owner=..., fix=...).",
        "no fix": 'Now a fix: `fixes()` prints what there is, then `try_fix("...")`.',
        "nothing asked": 'Nothing was asked yet, so "{cause}" is a guess. What would `{command}` say then? Ask it.',
        "contradicted": 'If it were "{cause}", `{command}` would not say: {finding}. You asked it.',
        "not apart": 'Your readings fit "{cause}", and {count} more. What would `{command}` say of each? Ask it.',
        "nothing sick": "Each of your readings is as on the card. Show what is sick first: `{command}` would.",
        "after": "{fix} (+{minutes:g} min)",
        "struck": 'You struck "{cause}" from your list, and now you name it.',
    },
    "ko": {
        "nothing": "작동하지 않습니다.",
        "budget": "{left:g}분 있습니다. 용의자: {suspects}",
        "clock": "{minutes:g}분 사용, {budget:g}분 가운데 {left:g}분 남음. 남은 용의자: {suspects}",
        "over": "{minutes:g}분 사용, 시간이 {over:g}분 초과되었습니다. 남은 용의자: {suspects}",
        "again": "이미 물어본 검사입니다. 결과는 같고 시간만 다시 듭니다.",
        "noted": "적어 두었습니다. 읽은 값이 이 원인을 증명합니다. 이제 `try_fix()`를 실행하십시오.",
        "no diagnosis": "진단이 먼저입니다. say(cause=..., frame=..., owner=..., fix=...)를 실행하십시오.",
        "no fix": '이제 처치를 고르십시오. `fixes()`로 목록을 보고 `try_fix("...")`를 실행합니다.',
        "nothing asked": '물어본 것이 없으니 "{cause}"은(는) 짐작입니다. '
        "그렇다면 `{command}`의 결과는 어떻겠습니까? 물어보십시오.",
        "contradicted": '원인이 "{cause}"라면 `{command}`의 결과가 이렇지 않습니다: {finding}. 이미 물어본 것입니다.',
        "not apart": '읽은 값은 "{cause}" 말고도 용의자 {count}명에게 맞습니다. '
        "`{command}`의 결과는 저마다 어떻겠습니까? 물어보십시오.",
        "nothing sick": "읽은 값이 모두 카드와 같습니다. 아픈 곳을 먼저 보이십시오. `{command}`의 결과에 나옵니다.",
        "after": "{fix} (+{minutes:g}분)",
        "struck": '"{cause}"은(는) 목록에서 지운 용의자입니다.',
    },
}


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

    def __init__(self, patient: SickRobot, language: str = "en", helped: bool = False) -> None:
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
        return {asked.check: TROLLEY[asked.check].kind(asked.finding) for asked in self.log}

    def opening(self) -> str:
        """Return what one is told at the door, for nothing."""
        complaint = COMPLAINTS.get(self.patient.complaint)
        said = getattr(complaint, self.language) if complaint else self._say("nothing")
        screen = f"\nRViz\n{_indented(_folded(self.patient.screen))}\n" if complaint else ""
        budget = self._say("budget", left=self.patient.budget_min, suspects=", ".join(self._all))
        return f"{said}\n{screen}\n{CARD[self.language]}\n\n{budget}"

    def ask(self, check: str, because: str = "") -> None:
        """Print what a check says, and what time is left; `because` says whom one suspects, or why one asks.

        Raises:
            ValueError: there is no such check on the trolley, or `because` is a second one.
        """
        before = {asked.check for asked in self.log}
        text = self.take(check, because)
        again = f"{self._say('again')}\n" if self.log[-1].check in before else ""
        print(f"{self._typed(check)}\n{text}\n\n{again}{self.clock()}")

    def take(self, check: str, because: str = "") -> str:
        """Ask without printing, and return the text."""
        key = check_named(check).key
        if any(because in (each.key, each.command) for each in TROLLEY.values()):
            raise ValueError(f'one check at a time: first "{key}", then "{because}"')
        minutes, text, finding = self.patient.reading(key)
        if self.helped:
            kind = TROLLEY[key].kind(finding)
            self.suspects = fitting({key: kind}, self.suspects)
        self.log.append(VisitEntry(key, minutes, finding, because, self.suspects))
        return told(text, self.language)

    def strike(self, *suspects: str) -> None:
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
                raise no_such(name, f"no {what}", names)
        self.diagnosis = {"cause": cause, "frame": frame, "owner": owner, "fix": fix}
        if cause in self._all and cause not in self.suspects and not self.helped:
            print(self._say("struck", cause=cause))
        print(self._doubt(cause) or self._say("noted" if fix else "no fix"))

    def fixes(self) -> None:
        """Print what can be done about it: every fix, the plasters among them."""
        print("\n".join(self.patient.fixes))

    def try_fix(self, fix: str = "") -> None:
        """Print the robot after this fix, or that which was said, if the readings warrant the diagnosis; else why not.

        Raises:
            ValueError: there is no such fix.
        """
        if fix and fix not in self.patient.fixes:
            raise no_such(fix, "no fix", self.patient.fixes)
        if fix and self.diagnosis:
            self.diagnosis["fix"] = fix
        print(self._refusal() or self._after())

    def _after(self) -> str:
        fix = self.diagnosis["fix"]
        minutes, text = seen_after(self.patient, fix)
        self.tried.append(FixTried(fix, minutes, text))
        return f"{self._say('after', fix=fix, minutes=minutes)}\n{_indented(told(text, self.language))}"

    def _refusal(self) -> str:
        """Return why no fix is tried yet, or ""."""
        if not self.diagnosis:
            return self._say("no diagnosis")
        return self._doubt(self.diagnosis["cause"]) or ("" if self.diagnosis["fix"] else self._say("no fix"))

    def _doubt(self, cause: str) -> str:
        """Return what the readings say against a cause, with a check that was asked or should be; "" if nothing."""
        for asked in self.log:
            if not fitting({asked.check: TROLLEY[asked.check].kind(asked.finding)}, [cause]):
                finding = told(asked.finding, self.language)
                return self._say("contradicted", cause=cause, command=self._done(asked.check), finding=finding)
        rivals = [each for each in fitting(self.found, self._all) if each != cause]
        if rivals:
            command, why = self._done(best_check([cause, *rivals])), "not apart" if self.log else "nothing asked"
            return self._say(why, cause=cause, count=len(rivals), command=command)
        is_sick = any(kind != TROLLEY[check].usual for check, kind in self.found.items())
        if is_sick or cause == NOTHING_IS_WRONG:
            return ""
        return self._say("nothing sick", command=self._done(DECIDING[cause]))

    def _done(self, check: str) -> str:
        return done(TROLLEY[check], self.language)

    def _typed(self, check: str) -> str:
        command = self._done(check_named(check).key)
        return f"$ {command}" if command.startswith("ros2 ") else command

    def _known(self, suspect: str) -> None:
        if suspect not in (*SUSPECTS, SENSOR_BROKEN):
            raise no_such(suspect, "no suspect", SUSPECTS)

    def _say(self, name: str, **names: object) -> str:
        return WORDS[self.language][name].format(**names)


def admit(patient: SickRobot, language: str = "en", helped: bool = False) -> Visit:
    """Let a patient in: print its complaint, its card and the budget, and return the visit.

    Raises:
        TypeError: that is no patient.
    """
    if not isinstance(patient, SickRobot):
        raise TypeError(f"a patient is wanted, such as practice_patient(3) or e12_4.a, not {type(patient).__name__}")
    visit = Visit(SickRobot.unpacked(patient.packed()), language, helped)
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
