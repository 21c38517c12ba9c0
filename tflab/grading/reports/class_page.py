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
from tflab.workbook.inventory.items import Item, read_inventory
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from ..submissions.remarks import Remark
from .class_figures import bars, histogram, scores
from .feedback import STATUS
from .gain import (
    BY_GUESSING,
    Believed,
    ClassGain,
    band,
    believed,
    class_gain,
    normalised_gain,
    out_of_reach,
    unused_options,
)
from .gradebook import remarks_of, tasks_of, verdicts_of
from .html import figure, page, points, prose, rows, text

__all__ = ["CommonMistake", "class_page", "gain_section", "mistakes"]

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


HEADING = Text("Before and after: the fifteen questions", "처음과 끝: 열다섯 문제")
MEANS = Text(
    "{count} learners answered both forms. Right of {of}, on average: {before} before, {after} after; "
    "guessing alone gives {by_guessing}.",
    "A형과 B형에 모두 답한 학습자는 {count}명입니다. {of}문제 중 맞힌 수의 평균: 처음 {before}개, 끝 {after}개. "
    "짐작만 하면 {by_guessing}개입니다.",
)
GAIN = Text("Normalised gain {gain}: {band}.", "정규화 향상도(normalised gain) {gain}: {band}.")
BANDS_FROM = Text(
    "It is the share of what was left to learn, of the means of these learners; the bands are those of a survey "
    "of 62 courses with 6542 students.",
    "처음에 더 배울 것으로 남아 있던 몫 가운데 얼마를 배웠는지를 이 학습자들의 평균으로 계산했습니다. "
    "구간은 강의 62개, 학생 6542명을 조사한 연구에서 가져왔습니다.",
)
NOTHING_LEFT = Text(
    "Normalised gain: nothing left to gain, everybody had all of it right before.",
    "정규화 향상도(normalised gain): 모두가 처음부터 다 맞혀서 더 오를 것이 없습니다.",
)
NOBODY = Text("No learner has answered both forms yet.", "A형과 B형에 모두 답한 학습자가 아직 없습니다.")
CURED = Text("Most cured: {which}.", "가장 많이 바로잡힌 것: {which}.")
GREW = Text("Grew: {which}. Teach it again.", "늘어난 것: {which}. 다시 가르칠 내용입니다.")
LINES = Text("Who is not in it, and what was odd", "빠진 사람과 특이한 점")
HEADS = (
    Text("Misconception", "잘못 알고 있는 점"),
    Text("Chose it, before → after", "고른 비율, 처음 → 끝"),
    Text("Of these sure", "그중 확신"),
    Text("", ""),
)
GROWN, GONE, FELL = Text("grew", "늘어남"), Text("gone", "사라짐"), Text("fell", "줄어듦")
ON_BOTH = Text(
    "Counted on the items on which both forms offer it, so that it has as many chances before as after.",
    "A형과 B형에 모두 그 보기가 있는 문제만 세었으므로, 고를 기회는 처음과 끝이 같습니다.",
)
ABOUT_THE_TEST = Text("Of the test itself, before the course", "시험 자체에 대하여(강의 전)")
OUT_OF_REACH = Text(
    "fewer than 20 % or more than 80 % had these right, so they tell little: {which}",
    "맞힌 사람이 20 %보다 적거나 80 %보다 많아서 알려 주는 것이 적은 문제: {which}",
)
UNUSED = Text(
    "fewer than 5 % chose these wrong options, so they should be rewritten: {which}",
    "고른 사람이 5 %보다 적어서 고쳐 써야 할 오답 보기: {which}",
)
LIMITS = Text(
    "A small test, and not validated yet: use it to find what to teach again, not to compare people.",
    "문제 수가 적고 아직 타당성을 검증하지 않은 시험입니다. "
    "무엇을 다시 가르칠지 찾는 데만 쓰고, 사람을 비교하는 데는 쓰지 마십시오.",
)
IN_WORDS = Text("the same in words", "글로 보기")
MOST_NAMED = 3
ENOUGH = 20  # learners, to say anything of the test itself


def gain_section(found: ClassGain, items: Sequence[Item], language: str) -> list[str]:
    """Return the part of the class's page on the test, as HTML."""
    body = [f"<h2>{text(HEADING.say(language))}</h2>"]
    if found.matched:
        table = believed(items, found.matched)
        body += _numbers(found, len(items), language)
        body += [f"<p>{text(line)}</p>" for line in _named(table, language)]
        body += [_table(table, len(found.matched), language), _quiet(ON_BOTH, language)]
    else:
        body.append(f"<p>{text(NOBODY.say(language))}</p>")
    if found.lines:
        points = "".join(f"<li>{text(line.say(language))}</li>" for line in found.lines)
        body.append(f'<div class="card"><b>{text(LINES.say(language))}</b><ul>{points}</ul></div>')
    return [*body, *_about_the_test(found, items, language), _quiet(LIMITS, language)]


def _numbers(found: ClassGain, of: int, language: str) -> list[str]:
    before, after = found.means()
    picture = scores(*found.right(), of, BY_GUESSING, language)
    said = MEANS.say(
        language, count=len(found.matched), of=of, before=f"{before:.1f}", after=f"{after:.1f}", by_guessing=BY_GUESSING
    )
    gain = normalised_gain(before, after, of)
    if gain is None:
        lines = [NOTHING_LEFT.say(language)]
    else:
        lines = [GAIN.say(language, gain=f"{gain:.2f}", band=band(gain).say(language)), BANDS_FROM.say(language)]
    return [
        f"<p>{text(said)}</p>",
        f"<p><b>{text(lines[0])}</b> {text(' '.join(lines[1:]))}</p>",
        figure(picture.png(), picture.text, picture.size_px[0], IN_WORDS.say(language)),
    ]


def _named(table: Sequence[Believed], language: str) -> list[str]:
    """Return which misconceptions fell most, and which grew most."""
    fell = sorted((row for row in table if row.after < row.before), key=lambda row: row.after - row.before)
    grew = sorted((row for row in table if row.after > row.before), key=lambda row: row.before - row.after)
    return [
        words.say(language, which="; ".join(_in_short(row, language) for row in some[:MOST_NAMED]))
        for words, some in ((CURED, fell), (GREW, grew))
        if some
    ]


def _in_short(row: Believed, language: str) -> str:
    return f"{MISCONCEPTIONS[row.misconception].say(language)} ({row.misconception}) {row.before} → {row.after}"


def _table(table: Sequence[Believed], of: int, language: str) -> str:
    cells = [
        (
            f"{text(MISCONCEPTIONS[row.misconception].say(language))} ({row.misconception})",
            f"{_share(row.before, of)} → {_share(row.after, of)}",
            f"{_share(row.sure_before, row.before)} → {_share(row.sure_after, row.after)}",
            text(_change(row, language)),
        )
        for row in table
    ]
    return rows([head.say(language) for head in HEADS], cells, numbers=(1, 2), widths=(46, 24, 20, 10))


def _about_the_test(found: ClassGain, items: Sequence[Item], language: str) -> list[str]:
    """Return which items and options tell little, for whoever looks after the test."""
    if len(found.matched) < ENOUGH:
        return []
    sides = ((OUT_OF_REACH, map(str, out_of_reach(found.matched))), (UNUSED, unused_options(items, found.matched)))
    said = [words.say(language, which=", ".join(which)) for words, names in sides if (which := list(names))]
    points = "".join(f"<li>{text(line)}</li>" for line in said)
    summary = text(ABOUT_THE_TEST.say(language))
    return [f"<details><summary>{summary}</summary><ul>{points}</ul></details>"] if said else []


def _share(count: int, of: int) -> str:
    return f"{100 * count / of:.0f}&nbsp;%" if of else "–"


def _change(row: Believed, language: str) -> str:
    if row.after > row.before:
        return GROWN.say(language)
    if row.after == row.before:
        return ""
    return (FELL if row.after else GONE).say(language)


def _quiet(words: Text, language: str) -> str:
    return f'<p class="quiet">{text(words.say(language))}</p>'
