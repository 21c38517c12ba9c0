"""How does the gain stand on the class's page?  One number for the class, and each misconception before and after.

    30 learners answered both forms. Mean of 15: 6.2 before, 12.1 after.
    Normalised gain 0.67: medium (0.3 to 0.7)
    Most cured   the inverse is only a minus sign: 10 -> 0
    Grew         a timeout cures everything: 0 -> 10
    M3   33 % -> 0 %    sure 10 of 10 -> 0 of 0

No learner is named but in the lines on who could not be matched.
"""

from __future__ import annotations

from collections.abc import Sequence

from tflab.text import Text
from tflab.workbook.inventory.items import Item
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from .class_figures import scores
from .gain import BY_GUESSING, Believed, ClassGain, band, believed, normalised_gain, out_of_reach, unused_options
from .html import figure, rows, text

__all__ = ["gain_section"]

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
