"""What is there to say about a notebook, in plain words?  A kind of remark, the task it is about, and its words twice.

    Remark("twice", "E3.2", cell="e3-2-answer").say("en")
    -> 'E3.2: two different cells are called "e3-2-answer", so neither counts. ...'

A remark never repeats what a learner's code printed or raised: that could carry
hidden inputs out.  Why a file cannot be read is a remark inside a remark: the
kinds in `reasons.py`; what is wrong with an answer is said as `mistake.py` of the
workbook has it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from tflab.text import Text
from tflab.workbook.diagnosis.mistake import WITHOUT_THE_ANSWER

__all__ = ["KINDS", "REASONS", "Remark", "printable"]

REASONS = {
    # files
    "nowhere": Text(
        en="there is no {place}; name a folder, a zip or a notebook",
        ko="없는 곳입니다: {place}. 폴더나 zip 파일, 노트북을 지정하십시오",
    ),
    "link": Text(en="a link to another file, not a file", ko="파일이 아니라 다른 파일을 가리키는 링크입니다"),
    "no file there": Text(en="not a regular file", ko="일반 파일이 아닙니다"),
    "closed": Text(en="cannot be opened ({error})", ko="열 수 없습니다({error})"),
    "not read": Text(en="cannot be read ({error})", ko="읽을 수 없습니다({error})"),
    "too large": Text(
        en="{size} MB, more than {most} MB: clear the outputs and hand it in again",
        ko="{size} MB로 한도 {most} MB를 넘습니다. 출력을 지우고 다시 제출하십시오",
    ),
    "too much": Text(en="more than {most} MB were handed in", ko="제출한 파일이 모두 합해 {most} MB를 넘습니다"),
    "linked folder": Text(
        en="a link to another folder; left out",
        ko="다른 폴더를 가리키는 링크라서 뺐습니다",
    ),
    "and more": Text(en="{names} and {count} more", ko="{names} 외 {count}개"),
    # zips
    "no zip": Text(en="not a zip file that can be read ({error})", ko="읽을 수 있는 zip 파일이 아닙니다({error})"),
    "pipe": Text(en="a link, a pipe or a device, not a file", ko="파일이 아니라 링크나 파이프, 장치입니다"),
    "many files": Text(en="{count} files in it, more than {most}", ko="파일이 {count}개로 한도 {most}개를 넘습니다"),
    "more like these": Text(en="{count} more like these", ko="이와 같은 것이 {count}개 더 있습니다"),
    "many names": Text(
        en="the list of its files is longer than {most} files have",
        ko="파일 목록이 {most}개 분량을 넘습니다",
    ),
    "many zips": Text(
        en="more than {most} zips in a zip, or more than {megabytes} MB of them: hand in the notebooks themselves",
        ko="zip 안의 zip이 {most}개, 모두 합해 {megabytes} MB를 넘습니다. 노트북 파일을 그대로 제출하십시오",
    ),
    "deep zip": Text(
        en="a zip in a zip in a zip, not opened: hand in the notebooks themselves",
        ko="zip 안의 zip 안에 또 zip이 있어 열지 않았습니다. 노트북 파일을 그대로 제출하십시오",
    ),
    "leads out": Text(
        en="it leads out of the archive; refused",
        ko="압축 파일 밖을 가리키는 이름이라서 받지 않았습니다",
    ),
    "link in a zip": Text(
        en="a link to another file; refused",
        ko="다른 파일을 가리키는 링크라서 받지 않았습니다",
    ),
    "locked": Text(en="it is locked with a password; refused", ko="암호가 걸려 있어서 받지 않았습니다"),
    "damaged": Text(en="damaged in the archive ({error})", ko="압축 파일 안에서 손상되었습니다({error})"),
    # notebooks
    "empty file": Text(en="an empty file", ko="빈 파일입니다"),
    "zip": Text(
        en="a zip file, not a notebook: unpack it, or hand over the zip itself",
        ko="노트북이 아니라 zip 파일입니다. 압축을 풀어 제출하거나 이름을 .zip으로 되돌려 제출하십시오",
    ),
    "no JSON": Text(
        en="not a notebook: no valid JSON, line {line}",
        ko="노트북이 아닙니다. {line}번째 줄이 올바른 JSON이 아닙니다",
    ),
    "too deep": Text(
        en="not a notebook: its lists are nested too deep",
        ko="노트북이 아닙니다. 리스트가 너무 깊이 겹쳐 있습니다",
    ),
    "many lists": Text(
        en="not a notebook: millions of lists in it",
        ko="노트북이 아닙니다. 리스트가 수백만 개 들어 있습니다",
    ),
    "no cells": Text(en="not a notebook: no cells in it", ko="노트북이 아닙니다. 셀이 없습니다"),
    "many cells": Text(en="{count} cells, more than {most}", ko="셀이 {count}개로 한도 {most}개를 넘습니다"),
    "no chapter": Text(
        en="none of its cells belongs to a chapter with exercises; in {root} there is {there}",
        ko="연습 문제가 있는 장의 셀이 하나도 없습니다. {root}에 있는 장: {there}",
    ),
    "endless to read": Text(
        en="to read it took more than {seconds} s of computing or {most} MB of memory: "
        "clear the outputs and hand it in again",
        ko="읽는 데 계산 {seconds}초나 메모리 {most} MB가 넘게 듭니다. 출력을 지우고 다시 제출하십시오",
    ),
    # notebooks that can be read
    "encoding": Text(
        en="it is written in {encoding}, not in UTF-8",
        ko="UTF-8이 아닌 인코딩({encoding})으로 저장되어 있습니다",
    ),
    "letters": Text(
        en="some of its letters are in no known encoding",
        ko="어느 인코딩으로도 읽을 수 없는 글자가 있습니다",
    ),
    "no cell": Text(
        en="{count} of its cells are no cells, and are left out",
        ko="셀의 형식이 아닌 것이 {count}개 있어서 뺐습니다",
    ),
}


KINDS = {
    # about cells
    "changed": Text(
        en='the cell "{cell}" was changed; grading uses its own.',
        ko='"{cell}" 셀이 바뀌었습니다. 채점에는 원래 셀을 씁니다.',
    ),
    "twice": Text(
        en='two different cells are called "{cell}", so neither counts. Keep one and delete the other.',
        ko='"{cell}"이라는 이름의 서로 다른 셀이 두 개라서 어느 쪽도 채점하지 않았습니다. 하나만 남기고 지우십시오.',
    ),
    "missing": Text(
        en='the cell "{cell}" is not there. Put the answer into the cell that came with the exercise.',
        ko='"{cell}" 셀이 없습니다. 연습 문제에 들어 있던 셀에 답을 쓰십시오.',
    ),
    "no code": Text(
        en='the cell "{cell}" is text, not code, so it does not run. Turn it back into a code cell (Y).',
        ko='"{cell}" 셀이 코드가 아니라 텍스트라서 실행되지 않습니다. 코드 셀로 되돌리십시오(Y 키).',
    ),
    "elsewhere": Text(
        en='the answer stands in a cell of your own, not in "{cell}". It counts; next time write it there.',
        ko='답이 "{cell}"이 아니라 직접 만든 셀에 있습니다. 이번에는 인정하지만 다음에는 제자리에 쓰십시오.',
    ),
    "apart": Text(
        en="right only by itself: another of the answers gets in its way. It counts.",
        ko="다른 답이 방해하여 따로 실행했을 때만 맞습니다. 점수는 인정합니다.",
    ),
    "left out": Text(
        en='your own cell behind "{cell}" did not end; it was left out.',
        ko='"{cell}" 뒤에 직접 만든 셀이 끝나지 않아서 빼고 채점했습니다.',
    ),
    # about what happened
    "timed out": Text(
        en="it did not end within {seconds} s, and not in a second run with three times as long either.",
        ko="{seconds}초 안에 끝나지 않았고, 세 배의 시간을 준 두 번째 실행에서도 끝나지 않았습니다.",
    ),
    "died": Text(
        en="it ended Python itself, or used up its memory; twice.",
        ko="파이썬 자체가 종료되었거나 메모리를 모두 썼습니다. 두 번 모두 그랬습니다.",
    ),
    "flood": Text(
        en="it wrote without end.",
        ko="출력이 끝없이 이어졌습니다.",
    ),
    "raised": Text(
        en="the answer cell stops with {error}.",
        ko="답안 셀이 {error} 오류로 멈춥니다.",
    ),
    "endless to judge": Text(
        en="to judge it took more than {seconds} s of computing or {most} MB of memory, so it was ended: "
        "no answer is that large.",
        ko="판정하는 데 계산 {seconds}초나 메모리 {most} MB가 넘게 들어 중단했습니다. 그렇게 큰 답은 없습니다.",
    ),
    "no result": Text(en="no result came back.", ko="결과가 돌아오지 않았습니다."),
    "not run": Text(
        en="it could not be run on this machine ({why}); grade it again.",
        ko="이 컴퓨터에서 실행하지 못했습니다({why}). 다시 채점해야 합니다.",
    ),
    # about files
    "unreadable": Text(en="{file}: {why}.", ko="{file}: {why}."),
    "no exercise": Text(
        en="{file}: none of its cells belongs to a chapter that is graded.",
        ko="{file}: 채점하는 장의 셀이 하나도 없습니다.",
    ),
    "several": Text(
        en="{chapter} was handed in more than once; {file} was graded: {rule}.",
        ko="{chapter} 장이 여러 번 제출되었습니다. {rule} 채점했습니다: {file}.",
    ),
    "by answers": Text(en="the one with most answers, of these the later", ko="답이 가장 많은 것을, 같으면 나중 것을"),
    "by latest": Text(en="the latest, by its name", ko="이름으로 보아 가장 나중 것을"),
    "by first": Text(en="the first, by its name", ko="이름으로 보아 가장 먼저 것을"),
    "nothing": Text(en="{chapter} was not handed in.", ko="{chapter} 장은 제출되지 않았습니다."),
    "other release": Text(
        en="{file} comes from another release ({stamp}); it was graded as this one ({ours}).",
        ko="{file}: 다른 배포본({stamp})에서 나온 파일이라 이번 배포본({ours}) 기준으로 채점했습니다.",
    ),
    "other version": Text(
        en="{file} is stamped tflab {stamp}, the release tflab {ours}.",
        ko="{file}: 적혀 있는 버전은 tflab {stamp}, 배포본은 tflab {ours}입니다.",
    ),
    "other learner": Text(
        en="{file} was handed out to {stamp}, and handed in for {ours}.",
        ko="{file}: {stamp}에게 배포된 것인데 {ours}의 이름으로 제출되었습니다.",
    ),
    "unknown task": Text(
        en="{file} has a task {stamp} that is not in this release.",
        ko="{file}: 이번 배포본에 없는 과제가 들어 있습니다({stamp}).",
    ),
    # about what was handed in
    "no file": Text(en="nothing was handed in.", ko="제출한 것이 없습니다."),
    "empty": Text(en="an empty folder.", ko="빈 폴더입니다."),
    "no notebook": Text(en="no notebook; there is {stamp}.", ko="노트북이 없습니다. 있는 것: {stamp}."),
    "many": Text(
        en="more than {ours} notebooks; the {ours} largest are looked at.",
        ko="노트북이 {ours}개보다 많아서 큰 것부터 {ours}개만 보았습니다.",
    ),
    "nobody": Text(
        en='"{stamp}" is nobody on the roster, and neither is the stamp in the notebook.',
        ko='명단에 없는 이름입니다: "{stamp}". 노트북에 적힌 이름도 명단에 없습니다.',
    ),
    "contested": Text(
        en='several people hand in as "{stamp}", and no sealed stamp says which of them is on the roster.',
        ko='"{stamp}" 이름으로 제출한 사람이 여럿인데, 누가 명단의 그 사람인지 확인할 봉인된 표시가 없습니다.',
    ),
    "stamped": Text(
        en='stamped for "{stamp}", who handed in elsewhere; not graded for them.',
        ko='"{stamp}"에게 배포된 것이지만 그 사람은 따로 제출했으므로 그의 것으로 채점하지 않았습니다.',
    ),
    "places": Text(en="handed in at several places: {stamp}.", ko="여러 곳에 제출되었습니다: {stamp}."),
    "file": Text(en="{file}: {why}.", ko="{file}: {why}."),
    # about the whole batch
    "other tflab": Text(
        en="released by tflab {stamp}, graded by tflab {ours}.",
        ko="tflab {stamp}에서 배포하고 tflab {ours}에서 채점했습니다.",
    ),
    "failed": Text(
        en="tflab itself failed here ({error}); please report it, and grade again.",
        ko="tflab 자체의 오류로 채점하지 못했습니다({error}). 오류를 알리고 다시 채점해야 합니다.",
    ),
    "some error": Text(en="an exception", ko="어떤"),  # inside another remark
    "own error": Text(en="an error of its own", ko="직접 정의한"),  # inside another remark
    **WITHOUT_THE_ANSWER,
    **REASONS,
}


@dataclass(frozen=True)
class Remark:
    """One thing to say; `words` fill the gaps of its text, and may be remarks themselves."""

    kind: str
    task: str = ""
    words: dict[str, str | Remark] = field(default_factory=dict)

    def __init__(self, kind: str, task: str = "", **words: Any) -> None:
        object.__setattr__(self, "kind", kind)
        object.__setattr__(self, "task", task)
        said = {name: one if isinstance(one, Remark) else printable(str(one)) for name, one in words.items()}
        object.__setattr__(self, "words", said)

    def say(self, language: str, *, with_task: bool = True) -> str:
        """Return the remark as one line."""
        words = {name: one.say(language) if isinstance(one, Remark) else one for name, one in self.words.items()}
        text = KINDS[self.kind].say(language).format(**words)
        return f"{self.task}: {text}" if self.task and with_task else text

    def plain(self) -> dict[str, Any]:
        """Return the remark as JSON has it."""
        words = {name: one.plain() if isinstance(one, Remark) else one for name, one in self.words.items()}
        return {"kind": self.kind, "task": self.task, "words": words}

    @classmethod
    def from_plain(cls, plain: dict[str, Any]) -> Remark:
        """Return the remark that `plain` wrote."""
        words = {name: cls.from_plain(one) if isinstance(one, dict) else one for name, one in plain["words"].items()}
        return cls(plain["kind"], plain["task"], **words)


def printable(text: str) -> str:
    """Return a text for one line: no line ends, no terminal's commands, no letters that cannot be written."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)
