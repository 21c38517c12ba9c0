"""What does the class misunderstand?  One page for the instructor: mistakes by count, hardest tasks, distribution.

    what is misunderstood     M1 target and source swapped  ##########  57
    which mistakes            E3.2 swapped (M1)      ################  31 of 180
    how hard the tasks are    E3.4                   #######......     52 %
    how the class did         0 .. 100 %             ..:|||::.
    before and after          gain 0.67              M3 33 % -> 0 %

Each picture stands beside the same in words.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from tflab.text import Text
from tflab.workbook.inventory.items import read_inventory
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from ..submissions.remarks import Remark
from .class_figures import bars, histogram
from .feedback import STATUS
from .gain import class_gain
from .gain_section import gain_section
from .gradebook import remarks_of, tasks_of, verdicts_of
from .html import figure, page, points, prose, rows, text

__all__ = ["CommonMistake", "class_page", "mistakes"]

MOST_BARS = 14
TITLE = Text("The class", "반 전체 결과")
COUNTED = Text(
    "{graded} graded, {empty} with nothing to grade.", "{graded}명을 채점했고, {empty}명은 채점할 것이 없습니다."
)
TOOK = Text("Running them took {seconds} s in all.", "실행에 모두 {seconds}초가 걸렸습니다.")
MISUNDERSTOOD = Text("What is misunderstood", "무엇을 잘못 알고 있을까요?")
MISTAKES = Text("Which mistakes", "어떤 실수를 했을까요?")
NO_MISTAKES = Text("No answer was one of the named mistakes.", "이름 붙은 실수와 일치한 답이 없습니다.")
HARDEST = Text("How hard the tasks were", "과제의 난이도")
DISTRIBUTION = Text("How the class did", "점수 분포")
EVERYBODY = Text("Everybody", "전체 명단")
IN_WORDS = Text("the same in words", "글로 보기")
SPOILT = Text("misconceptions by the answers they spoilt", "잘못 알고 있는 점과 그 때문에 틀린 답")
ANSWERS = Text("answers", "개")
NAMED = Text("named mistakes", "이름 붙은 실수")
LEARNERS = Text("learners", "명")
HARDEST_FIRST = Text("the hardest tasks first", "어려운 과제부터")
MEAN = Text("mean points [%]", "평균 점수[%]")
ON_THE_WALL = Text("What stood between the submissions and this machine", "제출물을 이 컴퓨터와 격리한 방법")
ABOUT = Text("What was odd about the files", "파일에 대한 알림")
MISTAKE_HEADS = (
    Text("Learners", "인원"),
    Text("Task", "과제"),
    Text("Mistake", "실수"),
    Text("What they are told", "안내"),
)
HEADS = (Text("Learner", "학습자"), Text("Points", "점수"), Text("Tasks", "과제"), Text("Remarks", "비고"))


class CommonMistake(NamedTuple):
    """One named mistake, and how many made it."""

    task: str
    name: str
    misconception: str
    reply: Text
    count: int


def mistakes(records: Sequence[Mapping[str, Any]]) -> list[CommonMistake]:
    """Return the mistakes that were made, the most frequent first."""
    made = [
        (task, name, twin["misconception"], Text(**twin["reply"]))
        for record in records
        for chapter in record["chapters"].values()
        for task, row in chapter["tasks"].items()
        for name, twin in row.get("slips", {}).items()
    ]
    found = [CommonMistake(*what, count) for what, count in Counter(made).items()]
    return sorted(found, key=lambda one: (-one.count, one.task, one.name))


def class_page(
    records: Sequence[Mapping[str, Any]],
    *,
    language: str = "en",
    wall: Sequence[Text] = (),
    remarks: Sequence[Remark] = (),
) -> str:
    """Return the instructor's page as HTML."""
    graded = [record for record in records if record["handed_in"]]
    counted = COUNTED.say(language, graded=len(graded), empty=len(records) - len(graded))
    took = TOOK.say(language, seconds=f"{sum(record['seconds'] for record in records):.1f}")
    body = [f"<h1>{text(TITLE.say(language))}</h1>", f"<p>{text(counted)} {text(took)}</p>"]
    if graded:
        found = mistakes(graded)
        body += _misunderstood(found, language)
        body += _mistakes(found, len(graded), language)
        body += _hardest(graded, language)
        body += _distribution(graded, language)
        items = read_inventory()
        gain = class_gain(records, items)
        body += gain_section(gain, items, language) if gain else []
    body += [f"<h2>{text(EVERYBODY.say(language))}</h2>", _everybody(records, language)]
    for heading, lines in ((ABOUT, remarks), (ON_THE_WALL, wall)):
        if lines:
            items = "".join(f"<li>{text(line.say(language))}</li>" for line in lines)
            body.append(f'<div class="card"><b>{text(heading.say(language))}</b><ul>{items}</ul></div>')
    return page(TITLE.say(language), language, body)


def _misunderstood(found: Sequence[CommonMistake], language: str) -> list[str]:
    """Return the thoughts behind the mistakes, by how many answers they spoilt."""
    counts: Counter[str] = Counter()
    for mistake in found:
        if mistake.misconception in MISCONCEPTIONS:
            counts[mistake.misconception] += mistake.count
    if not counts:
        return []
    order = sorted(counts, key=lambda name: (-counts[name], int(name[1:])))
    named = [(Text(*(f"{words} ({name})" for words in MISCONCEPTIONS[name])), counts[name]) for name in order]
    picture = bars(named, ANSWERS, most=max(counts.values()), title=SPOILT, language=language)
    body = [f"<h2>{text(MISUNDERSTOOD.say(language))}</h2>"]
    body.append(figure(picture.png(), picture.text, picture.size_px[0], IN_WORDS.say(language)))
    if language != "en":  # figures are in English
        body.append(
            f"<p>{text(', '.join(f'{MISCONCEPTIONS[name].say(language)} {counts[name]}' for name in order))}</p>"
        )
    return body


def _mistakes(found: Sequence[CommonMistake], graded: int, language: str) -> list[str]:
    body = [f"<h2>{text(MISTAKES.say(language))}</h2>"]
    if not found:
        return [*body, f"<p>{text(NO_MISTAKES.say(language))}</p>"]
    named = [(Text(_label(mistake), _label(mistake)), mistake.count) for mistake in found[:MOST_BARS]]
    picture = bars(named, LEARNERS, most=graded, title=NAMED, language=language)
    cells = [
        (
            f"{mistake.count} / {graded}",
            text(mistake.task),
            text(_label(mistake, with_task=False)),
            prose(mistake.reply.say(language)),
        )
        for mistake in found
    ]
    return [
        *body,
        figure(picture.png(), picture.text, picture.size_px[0], IN_WORDS.say(language)),
        rows([head.say(language) for head in MISTAKE_HEADS], cells, numbers=(0,), widths=(10, 8, 24, 58)),
    ]


def _label(mistake: CommonMistake, *, with_task: bool = True) -> str:
    misconception = f" ({mistake.misconception})" if mistake.misconception else ""
    return f"{mistake.task + ' ' if with_task else ''}{mistake.name.replace('_', ' ')}{misconception}"


def _hardest(graded: Sequence[Mapping[str, Any]], language: str) -> list[str]:
    share = {}
    for task in tasks_of(graded):
        got = [verdicts_of(record)[task] for record in graded if task in verdicts_of(record)]
        share[task] = 100 * sum(row["points"] for row in got) / sum(row["most"] for row in got)
    hardest = sorted(share.items(), key=lambda pair: (pair[1], pair[0]))
    named = [(Text(task, task), value) for task, value in hardest[:MOST_BARS]]
    picture = bars(named, MEAN, most=100, title=HARDEST_FIRST, language=language)
    return [
        f"<h2>{text(HARDEST.say(language))}</h2>",
        figure(picture.png(), picture.text, picture.size_px[0], IN_WORDS.say(language)),
    ]


def _distribution(graded: Sequence[Mapping[str, Any]], language: str) -> list[str]:
    percents = [100 * record["points"] / record["most"] if record["most"] else 0.0 for record in graded]
    picture = histogram(percents, language)
    return [
        f"<h2>{text(DISTRIBUTION.say(language))}</h2>",
        figure(picture.png(), picture.text, picture.size_px[0], IN_WORDS.say(language)),
    ]


def _everybody(records: Sequence[Mapping[str, Any]], language: str) -> str:
    cells = []
    for record in records:
        name = f"<b>{text(record['learner'])}</b> {text(record['name'])}"
        got = f"{points(record['points'])} / {points(record['most'])}"
        signs = " ".join(f"{task}&nbsp;{STATUS[row['status']][0]}" for task, row in verdicts_of(record).items())
        lines = [remark.say(language) for remark in remarks_of(record)]
        cells.append((name, got, signs, "<br>".join(text(line) for line in dict.fromkeys(lines))))
    return rows([head.say(language) for head in HEADS], cells, numbers=(1,), widths=(20, 12, 38, 30))
