"""What may be wrong with an answer?  One list of mistakes, and what is said of each, here and on a feedback page.

    outcomes --judge_outcomes--> Verdict(mistake=Mistake.UNIT, ...)
                                     |-- REPLIES[...]              what `check` says to the one who wrote it
                                     '-- WITHOUT_THE_ANSWER[...]   what a feedback page says of a hidden case

The second table repeats nothing that a learner's code made, for that could carry
hidden inputs out.  Both cover every mistake, coarse to fine; the field calls such a
list an error taxonomy.  A mistake of one task, its *slips*, stands with the task.
"""

from __future__ import annotations

from enum import Enum

from ...text import Text

__all__ = ["REPLIES", "WITHOUT_THE_ANSWER", "Mistake"]


class Mistake(str, Enum):
    """A kind of mistake that any task may see, coarse to fine."""

    UNANSWERED = "unanswered"
    NOT_A_FUNCTION = "not a function"
    A_FUNCTION = "a function"
    INTERRUPTED = "interrupted"
    UNSTEADY = "unsteady"
    SLIP = "slip"  # one that the task knows, or two
    NOTHING_RETURNED = "nothing returned"
    SOMETIMES_NOTHING = "sometimes nothing"
    INPUT_CHANGED = "input changed"
    RAISES = "raises"
    OTHER_EXCEPTION = "other exception"
    NO_REFUSAL = "no refusal"
    TYPE = "type"
    SHAPE = "shape"
    OPTION = "option"
    MISSING_PARTS = "missing parts"
    MORE_PARTS = "more parts"
    NO_ROBOT = "no robot"
    FRAME = "frame"
    UNIT = "unit"
    CONSTANT = "constant"
    ECHO = "echo"
    PARTS = "parts"
    VALUE = "value"

    __str__ = str.__str__  # StrEnum does the same, from Python 3.11 on


REPLIES = {
    Mistake.UNANSWERED: Text(
        en="not answered yet. Write your answer where the `...` or the `raise` stands, and run its cell and the check.",
        ko="아직 답하지 않았습니다. `...`이나 `raise`가 있는 자리에 답을 쓰고, 그 셀과 `check`를 실행하십시오.",
    ),
    Mistake.NOT_A_FUNCTION: Text(
        en="{answer} should be a function, and it is not ({got}). Hand over the function itself, without calling it.",
        ko="{answer}에는 함수가 있어야 하는데 다른 것이 있습니다({got}). 호출하지 말고 함수 자체를 넘기십시오.",
    ),
    Mistake.A_FUNCTION: Text(
        en="this is a function, and its result is asked for: {wanted}. Did you forget the brackets of the call?",
        ko="함수가 아니라 그 결과가 필요합니다: {wanted}. 호출 괄호를 빠뜨리지 않았습니까?",
    ),
    Mistake.INTERRUPTED: Text(
        en="you stopped it. Does a loop in your function never end?",
        ko="실행을 멈췄습니다. 함수 안에 끝나지 않는 반복이 있지 않습니까?",
    ),
    Mistake.UNSTEADY: Text(
        en="the same arguments gave two different results. A function may not remember earlier calls.",
        ko="같은 인자로 두 번 호출했더니 결과가 다릅니다. 함수가 이전 호출을 기억하면 안 됩니다.",
    ),
    Mistake.SLIP: Text(en="{said}", ko="{said}"),
    Mistake.NOTHING_RETURNED: Text(
        en="your function returned nothing (None). Did you forget `return`? What it prints is not looked at.",
        ko="함수가 아무것도 돌려주지 않았습니다(None). `return`을 빠뜨리지 않았습니까? 출력한 것은 검사하지 않습니다.",
    ),
    Mistake.SOMETIMES_NOTHING: Text(
        en="for this call there is an answer, and your function returned None; for others it did not. "
        "Either a way through it has no `return`, or it gives up where it need not.{certain}",
        ko="답이 있는 호출인데 None이 나왔고, 다른 호출에서는 값이 나왔습니다. "
        "`return`이 없는 갈래가 있거나, 포기하지 않아도 될 곳에서 포기한 것입니다.{certain}",
    ),
    Mistake.INPUT_CHANGED: Text(
        en="your function changes what it is given (argument {changed}): whoever called it has lost the original. "
        "Work on a copy.",
        ko="함수가 받은 것을 바꿉니다({changed}번째 인자). 호출한 쪽은 원래 값을 잃습니다. 복사본으로 계산하십시오.",
    ),
    Mistake.RAISES: Text(
        en="your function stopped with {error}: {text}{tip}",
        ko="함수가 예외를 내고 멈췄습니다. {error}: {text}{tip}",
    ),
    Mistake.OTHER_EXCEPTION: Text(
        en="to raise an exception is right here, but {error} is not the one that is asked for. (It says: {text})",
        ko="여기서 예외를 일으키는 것은 맞지만, 다른 예외가 필요합니다. 함수가 낸 예외: {error}: {text}",
    ),
    Mistake.NO_REFUSAL: Text(
        en="for this call an exception has to be raised, and your function raised none.",
        ko="이렇게 호출하면 예외를 일으켜야 하는데, 예외가 나오지 않았습니다.",
    ),
    Mistake.TYPE: Text(
        en="your answer is of the wrong kind ({got}). Asked for: {wanted}{tip}.",
        ko="답의 종류가 다릅니다({got}). 필요한 것: {wanted}{tip}.",
    ),
    Mistake.SHAPE: Text(
        en="your answer has the wrong shape ({got}). Asked for: {wanted}{tip}.",
        ko="답의 모양이 다릅니다({got}). 필요한 것: {wanted}{tip}.",
    ),
    Mistake.OPTION: Text(
        en='"{answer}" is not among the answers to choose from: {wanted}{tip}.',
        ko='보기에 없는 답입니다: "{answer}". 필요한 것: {wanted}{tip}.',
    ),
    Mistake.MISSING_PARTS: Text(
        en="there is no answer yet for {parts}{tip}.",
        ko="아직 답이 없는 곳: {parts}{tip}.",
    ),
    Mistake.MORE_PARTS: Text(
        en="your dict holds more than is asked for: {parts}. Asked for: {wanted}.",
        ko="딕셔너리에 필요 없는 것이 들어 있습니다: {parts}. 필요한 것: {wanted}.",
    ),
    Mistake.NO_ROBOT: Text(
        en="this is no robot yet. {fault}.",
        ko="아직 로봇이 되지 않았습니다. URDF를 읽는 프로그램의 오류 메시지: {fault}",
    ),
    Mistake.FRAME: Text(
        en='this says that it is expressed in "{frame}", and "{wanted_frame}" is asked for.',
        ko='이 값은 "{frame}" 기준이라고 적혀 있는데, 필요한 것은 "{wanted_frame}" 기준입니다.',
    ),
    Mistake.UNIT: Text(
        en="right, if it were in {unit}; {wanted_unit} is asked for.",
        ko="{unit} 단위라면 맞습니다. 여기서 필요한 단위는 {wanted_unit}입니다.",
    ),
    Mistake.CONSTANT: Text(
        en="your function gives the same result whatever it is asked. Does it use its arguments?",
        ko="무엇을 넣어도 함수의 결과가 같습니다. 함수가 인자를 사용하고 있습니까?",
    ),
    Mistake.ECHO: Text(
        en="your function hands back what it was given, unchanged.",
        ko="함수가 받은 값을 바꾸지 않고 그대로 돌려줍니다.",
    ),
    Mistake.PARTS: Text(
        en="not right yet: {wrong}{certain}.",
        ko="아직 틀린 부분: {wrong}{certain}.",
    ),
    Mistake.VALUE: Text(
        en="the form is right, the value is not{certain}.",
        ko="형식은 맞지만 값이 다릅니다{certain}.",
    ),
}

WITHOUT_THE_ANSWER = {
    Mistake.UNANSWERED: Text(en="not answered yet.", ko="아직 답하지 않았습니다."),
    Mistake.NOT_A_FUNCTION: Text(
        en="this should be a function, and it is not.", ko="함수가 있어야 하는데 다른 것이 있습니다."
    ),
    Mistake.A_FUNCTION: Text(
        en="this is a function, and its result is asked for: {wanted}.",
        ko="함수가 아니라 그 결과가 필요합니다: {wanted_ko}.",
    ),
    Mistake.INTERRUPTED: Text(en="it was stopped before it ended.", ko="끝나기 전에 중단되었습니다."),
    Mistake.UNSTEADY: Text(
        en="the function gives another result when it is called a second time with the same input.",
        ko="같은 입력으로 다시 호출하면 함수의 결과가 달라집니다.",
    ),
    Mistake.SLIP: Text(en="one of the mistakes of this task: {said}", ko="이 과제에서 흔히 하는 실수입니다. {said_ko}"),
    Mistake.NOTHING_RETURNED: Text(
        en="the function returns nothing (None): is its `return` missing?",
        ko="함수가 아무것도 반환하지 않습니다(None). `return`이 빠지지 않았습니까?",
    ),
    Mistake.SOMETIMES_NOTHING: Text(
        en="for some inputs the function returns nothing (None): each way through it needs a `return`.",
        ko="일부 입력에서 함수가 아무것도 반환하지 않습니다(None). 어느 갈래로 가도 `return`이 있어야 합니다.",
    ),
    Mistake.INPUT_CHANGED: Text(
        en="the function changes what it is given (argument {changed}).",
        ko="함수가 받은 것을 바꿉니다({changed}번째 인자).",
    ),
    Mistake.RAISES: Text(
        en="the function raises {error} where it should return a value ({of_cases}).{tip}",
        ko="함수가 값을 돌려주어야 할 곳에서 {error} 예외를 냅니다({of_cases}).{tip_ko}",
    ),
    Mistake.OTHER_EXCEPTION: Text(
        en="the function raises {error} where another exception is asked for.",
        ko="다른 예외가 필요한 곳에서 함수가 {error} 예외를 냅니다.",
    ),
    Mistake.NO_REFUSAL: Text(
        en="the function returns something where an exception has to be raised.",
        ko="예외를 일으켜야 하는 곳에서 함수가 값을 반환합니다.",
    ),
    Mistake.TYPE: Text(
        en="the answer is of another kind; wanted: {wanted}.",
        ko="답의 종류가 다릅니다. 필요한 것: {wanted_ko}.",
    ),
    Mistake.SHAPE: Text(
        en="the answer is of another shape; wanted: {wanted}.",
        ko="답의 모양이 다릅니다. 필요한 것: {wanted_ko}.",
    ),
    Mistake.OPTION: Text(
        en="the answer is not one of those to choose from; wanted: {wanted}.",
        ko="보기에 없는 답입니다. 필요한 것: {wanted_ko}.",
    ),
    Mistake.MISSING_PARTS: Text(en="not answered: {parts}.", ko="답하지 않은 부분: {parts}."),
    Mistake.MORE_PARTS: Text(
        en="the dict holds more than is asked for; wanted: {wanted}.",
        ko="딕셔너리에 필요 없는 것이 들어 있습니다. 필요한 것: {wanted_ko}.",
    ),
    Mistake.NO_ROBOT: Text(en="the text is no URDF that can be read.", ko="URDF로 읽을 수 없는 텍스트입니다."),
    Mistake.FRAME: Text(
        en="the answer is in another frame; wanted: {wanted_frame}.",
        ko="답의 좌표계가 다릅니다. 필요한 좌표계: {wanted_frame}.",
    ),
    Mistake.UNIT: Text(
        en="the number would fit in {unit}; wanted: {wanted_unit}.",
        ko="{unit} 단위라면 맞는 값입니다. 필요한 단위: {wanted_unit}.",
    ),
    Mistake.CONSTANT: Text(
        en="the function gives the same result whatever it is asked.",
        ko="무엇을 넣어도 함수의 결과가 같습니다.",
    ),
    Mistake.ECHO: Text(
        en="the function hands back what it was given, unchanged.",
        ko="함수가 받은 값을 그대로 돌려줍니다.",
    ),
    Mistake.PARTS: Text(en="not right yet: {wrong}.", ko="아직 틀린 부분: {wrong}."),
    Mistake.VALUE: Text(en="the form is right, the value is not.", ko="형식은 맞지만 값이 다릅니다."),
}
