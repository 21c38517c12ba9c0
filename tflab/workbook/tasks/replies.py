"""What does one say to a wrong answer?  What is wrong with it, how to see it, and never the right one.

One sentence or two for each kind of verdict, in English and in Korean; what a
task says of its own twins stands with the task.  Read `comparison.py` next.
"""

from __future__ import annotations

from ..words import Words

__all__ = ["LATER", "REPLIES"]

REPLIES = {
    "unanswered": Words(
        en="not answered yet. Write your answer in the cell above, then run that cell and this one.",
        ko="아직 답하지 않았습니다. 위 셀에 답을 쓰고, 그 셀과 이 셀을 차례로 실행하십시오.",
    ),
    "no_answer_given": Words(
        en='nothing to check: write check("{id}", {answer}).',
        ko='검사할 답이 없습니다. check("{id}", {answer})처럼 쓰십시오.',
    ),
    "type": Words(
        en="your answer is of the wrong kind ({got}). Asked for: {wanted}.",
        ko="답의 종류가 다릅니다({got}). 필요한 것: {wanted}.",
    ),
    "not_a_function": Words(
        en="{answer} should be a function, and it is not ({got}). Hand over the function itself, without calling it.",
        ko="{answer}에는 함수가 있어야 하는데 다른 것이 있습니다({got}). 호출하지 말고 함수 자체를 넘기십시오.",
    ),
    "nothing_returned": Words(
        en="your function returned nothing (None). Did you forget `return`? What it prints is not looked at.",
        ko="함수가 아무것도 돌려주지 않았습니다(None). `return`을 빠뜨리지 않았습니까? 출력한 것은 검사하지 않습니다.",
    ),
    "a_function": Words(
        en="this is a function, and its result is asked for: {wanted}. Did you forget the brackets of the call?",
        ko="함수가 아니라 그 결과가 필요합니다: {wanted}. 호출 괄호를 빠뜨리지 않았습니까?",
    ),
    "shape": Words(
        en="your answer has the wrong shape ({got}). Asked for: {wanted}.",
        ko="답의 모양이 다릅니다({got}). 필요한 것: {wanted}.",
    ),
    "option": Words(
        en='"{answer}" is not among the answers to choose from: {wanted}.',
        ko='보기에 없는 답입니다: "{answer}". 필요한 것: {wanted}.',
    ),
    "missing": Words(
        en="there is no answer yet for {parts}.",
        ko="아직 답이 없는 곳: {parts}.",
    ),
    "frame": Words(
        en='this says that it is expressed in "{frame}", and "{wanted_frame}" is asked for.',
        ko='이 값은 "{frame}" 기준이라고 적혀 있는데, 필요한 것은 "{wanted_frame}" 기준입니다.',
    ),
    "raised": Words(
        en="your function stopped with {error}: {text}",
        ko="함수가 예외를 내고 멈췄습니다. {error}: {text}",
    ),
    "another exception": Words(
        en="to raise an exception is right here, but {error} is not the one that is asked for. (It says: {text})",
        ko="여기서 예외를 일으키는 것은 맞지만, 다른 예외가 필요합니다. 함수가 낸 예외: {error}: {text}",
    ),
    "no refusal": Words(
        en="for this call an exception has to be raised, and your function returned something.",
        ko="이렇게 부르면 예외를 일으켜야 하는데, 함수가 값을 반환했습니다.",
    ),
    "interrupted": Words(
        en="you stopped it. Does a loop in your function never end?",
        ko="실행을 멈췄습니다. 함수 안에 끝나지 않는 반복이 있지 않습니까?",
    ),
    "unsteady": Words(
        en="the same arguments gave two different results. A function may not remember earlier calls.",
        ko="같은 인자로 두 번 불렀더니 결과가 다릅니다. 함수가 이전 호출을 기억하면 안 됩니다.",
    ),
    "unit": Words(
        en="right, if it were in {unit}; {wanted_unit} is asked for.",
        ko="{unit} 단위라면 맞습니다. 여기서 필요한 단위는 {wanted_unit}입니다.",
    ),
    "constant": Words(
        en="your function gives the same result whatever it is asked. Does it use its arguments?",
        ko="무엇을 넣어도 함수의 결과가 같습니다. 함수가 인자를 사용하고 있습니까?",
    ),
    "echo": Words(
        en="your function hands back what it was given, unchanged.",
        ko="함수가 받은 값을 바꾸지 않고 그대로 돌려줍니다.",
    ),
    "parts": Words(
        en="look again at {wrong}.",
        ko="다시 볼 곳: {wrong}.",
    ),
    "value": Words(
        en="the form is right, the value is not.",
        ko="형식은 맞지만 값이 다릅니다.",
    ),
    "case": Words(
        en="It was called as {call}, and gave {got}.",
        ko="이렇게 불렀습니다: {call}. 나온 결과: {got}.",
    ),
    "hint": Words(
        en='hint("{id}") helps, one step at a time.',
        ko='hint("{id}")를 실행하면 한 단계씩 도움을 받을 수 있습니다.',
    ),
    "hint_number": Words(en="hint {number} of 3", ko="힌트 {number}/3"),
    "last_hint": Words(en="that was the last hint, once more", ko="마지막 힌트를 다시 보여 드립니다"),
    "solution": Words(
        en='Three tries: if you like, read the solution with solution("{id}").',
        ko='세 번 시도했습니다. 원하면 solution("{id}")로 풀이를 볼 수 있습니다.',
    ),
    "solution_later": Words(
        en="the solution opens after a pass or three tries; {tries} so far.",
        ko="풀이는 통과하거나 세 번 시도한 뒤에 열립니다. 지금까지 {tries}번 시도했습니다.",
    ),
    "solution_of_class": Words(
        en="in a class, the solutions are with your instructor.",
        ko="수업용 교재의 풀이는 강사에게 있습니다.",
    ),
    "unknown_task": Words(
        en="there is no such task here; there is {known}.{close}",
        ko="그런 과제가 없습니다. 있는 과제: {known}.{close}",
    ),
    "did_you_mean": Words(en=' Did you mean "{name}"?', ko=' 혹시 "{name}" 아닙니까?'),
    "no_cases": Words(
        en="cannot be checked: {why}. `tflab lab --update` brings back what is missing, and keeps what you wrote.",
        ko="검사할 수 없습니다: {why}. `tflab lab --update`를 실행하면 빠진 것이 복구되고 작성한 것은 그대로 남습니다.",
    ),
}

# After a pass: what was looked at, and what grading will look at besides.
LATER = {
    "function": Words(
        en="Your function was called with {of} public inputs. Grading calls it with others.",
        ko="공개된 입력 {of}개로 함수를 불러 보았습니다. 채점에서는 다른 입력으로 부릅니다.",
    ),
    "same for all": Words(
        en="Your answer was compared with the right one, and grading does just that.",
        ko="답을 정답과 비교했습니다. 채점에서도 똑같이 비교합니다.",
    ),
    "value": Words(
        en="Your answer was compared for the numbers given to you. Grading runs your cell again and compares.",
        ko="주어진 값에 대한 답을 비교했습니다. 채점에서는 셀을 다시 실행하여 그 결과를 봅니다.",
    ),
}
