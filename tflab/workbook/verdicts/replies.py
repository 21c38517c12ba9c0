"""What does `check` say besides?  How it was called, where help is, what grading will add: in both languages.

What is wrong with an answer is said in `mistake.py`, once for everybody who says it.
"""

from __future__ import annotations

from ...text import Text

__all__ = ["LATER", "PHRASES"]

PHRASES = {
    "still_waiting": Text(
        en="still waiting for your function. If a loop in it never ends, ■ at the top of the page stops it.",
        ko="아직 함수가 끝나기를 기다리고 있습니다. 끝나지 않는 반복이 있다면 페이지 위쪽의 ■로 멈추십시오.",
    ),
    "no_answer_given": Text(
        en='nothing to check: write check("{id}", {answer}).',
        ko='검사할 답이 없습니다. check("{id}", {answer})처럼 쓰십시오.',
    ),
    "case": Text(
        en="It was called as {call}, and gave {got}.",
        ko="이렇게 호출했습니다: {call}. 나온 결과: {got}.",
    ),
    "hint": Text(
        en='hint("{id}") in a new cell (Esc, then b) helps, one step at a time.',
        ko='새 셀을 만들어(Esc, b) hint("{id}")를 실행하면 한 단계씩 도움을 받을 수 있습니다.',
    ),
    "drawn": Text(
        en="In the picture, yours is grey, and what is expected is in colour.",
        ko="그림 읽기: yours = 내 답(회색), expected = 정답(색).",
    ),
    "hint_number": Text(en="hint {number} of 3", ko="힌트 {number}/3"),
    "last_hint": Text(en="that was the last hint, once more", ko="마지막 힌트를 다시 보여 드립니다"),
    "one word": Text(
        en="{names}: right, and counts nothing yet. A word that stands in too many places is right in some by chance.",
        ko="{names}: 맞지만 아직 점수가 없습니다. 같은 말을 너무 여러 곳에 쓰면 어딘가는 우연히 맞습니다.",
    ),
    "solution": Text(
        en='Three tries: hint("{id}") still helps, one step at a time, and solution("{id}") shows a solution.',
        ko='세 번 시도했습니다. hint("{id}")를 실행하면 여전히 한 단계씩 도움을 받을 수 있고, '
        'solution("{id}")를 실행하면 풀이가 나옵니다.',
    ),
    "solution_later": Text(
        en="the solution opens after a pass or three tries; {tries} so far.",
        ko="풀이는 통과하거나 세 번 시도한 뒤에 열립니다. 지금까지 {tries}번 시도했습니다.",
    ),
    "solution_of_class": Text(
        en="in a class, the solutions are with your instructor.",
        ko="수업용 교재의 풀이는 강사에게 있습니다.",
    ),
    "unknown_task": Text(
        en="there is no such task here; there is {known}.{close}",
        ko="그런 과제가 없습니다. 있는 과제: {known}.{close}",
    ),
    "no_task": Text(
        en='for which task? Say it in quotes, such as "E1.1"; there is {known}.{close}',
        ko='어느 과제입니까? "E1.1"처럼 따옴표 안에 쓰십시오. 있는 과제: {known}.{close}',
    ),
    "did_you_mean": Text(en=' Did you mean "{name}"?', ko=' 혹시 "{name}"을(를) 찾으십니까?'),
    "no_cases": Text(
        en="this task cannot be checked: {why}. If a file of tflab is missing, install tflab again. "
        "Your notebooks and progress stay as they are.",
        ko="이 과제를 검사할 수 없습니다: {why}. tflab의 파일이 없어졌으면 tflab을 다시 설치하십시오. "
        "노트북과 진도는 그대로 남습니다.",
    ),
}

# After a pass: what was looked at, and what grading will look at besides.
LATER = {
    "function": Text(
        en="Your function was called with {of} public inputs. Grading calls it with others.",
        ko="공개된 입력 {of}개로 함수를 호출해 보았습니다. 채점에서는 다른 입력으로 호출합니다.",
    ),
    "same for all": Text(
        en="Your answer was compared with the right one, and grading does just that.",
        ko="답을 정답과 비교했습니다. 채점에서도 똑같이 비교합니다.",
    ),
    "value": Text(
        en="Your answer was compared for the numbers given to you. Grading runs your cell again and compares.",
        ko="주어진 값으로는 맞았습니다. 채점에서는 셀을 다시 실행하여 그 결과를 봅니다.",
    ),
}
