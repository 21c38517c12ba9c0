"""E9.6: Where may I wait?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

OUTCOMES = ("works", "waits in vain", "waits for ever")


WAITS = dict(zip("abcdefgh", ("waits in vain", "works", "waits in vain", "works", "waits for ever", "waits in vain",
                              "waits in vain", "works"), strict=True))  # fmt: skip


def waits(**changed: str) -> dict[str, str]:
    return {**WAITS, **changed}


A_TIMEOUT_ALWAYS_HELPS = WrongAnswer(
    "a timeout always helps",
    waits(a="works", c="works", e="works", f="works", g="works"),
    misconception="M10",
    reply=Text(
        en="you trust waiting too much. For each line ask: while it waits, who takes the transform off the network? And is it ever going to come?",
        ko="기다림을 너무 믿고 있습니다. 줄마다 물어보십시오. 기다리는 동안 변환은 누가 받습니까? 그리고 오기는 합니까?",
    ),
)


ONLY_SUBSCRIPTIONS_BLOCK = WrongAnswer(
    "only subscriptions block",
    waits(c="works"),
    misconception="M10",
    reply=Text(
        en="a timer's callback runs in the same thread as every other callback.",
        ko="타이머 콜백도 다른 모든 콜백과 같은 스레드에서 실행됩니다.",
    ),
)


THREADS_CANNOT_HELP = WrongAnswer(
    "threads cannot help",
    waits(b="waits in vain", h="waits in vain"),
    misconception="M10",
    reply=Text(
        en="waiting is not bad as such. Where another thread takes in transforms meanwhile, it works: an executor of several threads has one to spare for the listener, which is in a callback group of its own, and `spin_thread=True` starts one at once.",
        ko="기다리는 것 자체가 나쁜 것은 아닙니다. 그동안 다른 스레드가 변환을 받으면 통합니다. 스레드가 여럿인 실행기에는 자기 콜백 그룹에 있는 수신기를 호출할 스레드가 남아 있고, `spin_thread=True`는 스레드를 바로 하나 시작합니다.",
    ),
)


SEVERAL_THREADS_CANNOT_HELP = WrongAnswer(
    "several threads cannot help",
    waits(b="waits in vain"),
    misconception="M10",
    reply=Text(
        en="waiting in a callback is not bad as such. The listener has a callback group of its own, so an executor of several threads calls it in another one meanwhile.",
        ko="콜백에서 기다리는 것 자체가 나쁜 것은 아닙니다. 수신기는 자기 콜백 그룹에 있으므로, 스레드가 여럿인 실행기는 그동안 다른 스레드에서 수신기를 호출합니다.",
    ),
)


ITS_OWN_THREAD_COMES_LATER = WrongAnswer(
    "its own thread comes later",
    waits(h="waits in vain"),
    misconception="M10",
    reply=Text(
        en="`spin_thread=True` does not wait for anybody's `spin`: the listener starts a thread of its own as soon as it is made, and that one takes in transforms while `main()` waits.",
        ko="`spin_thread=True`는 누가 `spin`하기를 기다리지 않습니다. 수신기는 만들어지자마자 자기 스레드를 시작하고, `main()`이 기다리는 동안 그 스레드가 변환을 받습니다.",
    ),
)


A_TIMEOUT_NEVER_ENDS = WrongAnswer(
    "a timeout never ends",
    waits(**dict.fromkeys("acfg", "waits for ever")),
    misconception="M10",
    reply=Text(
        en="a wait with `timeout=0.3 s` is over after 0.3 s, whatever happens. Which line has no timeout at all?",
        ko="`timeout=0.3 s`인 기다림은 무슨 일이 있어도 0.3초 뒤에 끝납니다. timeout이 아예 없는 줄은 어느 것입니까?",
    ),
    partly=True,
)


A_PROMISE_BLOCKS = WrongAnswer(
    "a promise blocks",
    waits(d="waits in vain"),
    misconception="M10",
    reply=Text(
        en="`wait_for_transform_async` returns at once, so the one thread is free again to take in the transform.",
        ko="`wait_for_transform_async`는 바로 돌아오므로, 하나뿐인 스레드도 다시 변환을 받을 수 있습니다.",
    ),
)


PROMISES_EXPIRE = WrongAnswer(
    "promises expire",
    waits(e="waits in vain"),
    misconception="M10",
    reply=Text(
        en="a promise of `wait_for_transform_async` has no timeout. What becomes of one that can never be kept?",
        ko="`wait_for_transform_async`의 약속에는 timeout이 없습니다. 결코 지켜질 수 없는 약속은 어떻게 됩니까?",
    ),
)


TASK = Task(
    id="E9.6",
    kind="M",
    points=2,
    title=Text(en="Where may I wait?", ko="어디서 기다려도 될까요?"),
    answer="outcomes",
    form=Parts({name: Choice(OUTCOMES) for name in "abcdefgh"}),
    mistakes=(
        A_TIMEOUT_ALWAYS_HELPS,
        ONLY_SUBSCRIPTIONS_BLOCK,
        THREADS_CANNOT_HELP,
        SEVERAL_THREADS_CANNOT_HELP,
        ITS_OWN_THREAD_COMES_LATER,
        A_TIMEOUT_NEVER_ENDS,
        A_PROMISE_BLOCKS,
        PROMISES_EXPIRE,
    ),
    hints=(
        Text(
            en="Two questions for each line: who takes in transforms meanwhile, and will the right one ever come?",
            ko="줄마다 두 가지를 물으십시오. 그동안 변환은 누가 받습니까? 맞는 변환이 언젠가 오기는 합니까?",
        ),
        Text(
            en="`rclpy.spin(node)` is one thread. Nobody spins at all in one of the lines.",
            ko="`rclpy.spin(node)`는 스레드 하나입니다. 아무도 spin하지 않는 줄도 있습니다.",
        ),
        Text(
            en="In two lines the right transform does not come in time whatever the threads: one has a timeout and gives up, the other is a promise and does not.",
            ko="두 줄에서는 스레드가 몇 개든 맞는 변환이 제때 오지 않습니다. 하나는 timeout이 있어 포기하고, 다른 하나는 약속이라 포기하지 않습니다.",
        ),
    ),
    misconceptions=("M10",),
    means={
        "works": Text(
            en="it works only where somebody else takes in transforms while it waits, and the right one comes in time.",
            ko="기다리는 동안 다른 누군가가 변환을 받고, 맞는 변환이 제때 올 때만 통합니다.",
        ),
        "waits in vain": Text(
            en="it gives up only if it has a timeout, and meanwhile nobody takes in the right transform, or it does not come.",
            ko="timeout이 있고, 그동안 맞는 변환을 받을 사람이 없거나 변환이 오지 않을 때만 포기합니다.",
        ),
        "waits for ever": Text(
            en="only what has no timeout can wait for ever, for something that never comes.",
            ko="timeout이 없고 결코 오지 않을 것을 기다릴 때만 영원히 기다립니다.",
        ),
    },
    shows={
        "a": Text(
            en="Line a: the thread that waits is the only one.",
            ko="a에서는 기다리는 스레드가 하나뿐인 스레드입니다.",
        ),
        "b": Text(
            en="Line b: there are several threads.",
            ko="b에는 스레드가 여럿 있습니다.",
        ),
        "c": Text(
            en="Line c: a timer's callback runs in the only thread, too.",
            ko="c에서는 타이머 콜백도 하나뿐인 스레드에서 실행됩니다.",
        ),
        "d": Text(
            en="Line d: asking for a promise blocks nobody.",
            ko="d에서는 약속을 요청할 뿐 아무도 막지 않습니다.",
        ),
        "e": Text(
            en="Line e: a promise without a timeout, for a moment that the buffer has forgotten.",
            ko="e는 버퍼가 이미 잊은 시각에 대한, timeout 없는 약속입니다.",
        ),
        "f": Text(
            en="Line f: the stamp lies 2 s ahead, and the timeout is 0.3 s.",
            ko="f에서는 측정 시각이 실제보다 2초 늦게 적히고 timeout은 0.3초입니다.",
        ),
        "g": Text(
            en="Line g: nobody spins yet.",
            ko="g에서는 아직 아무도 spin하지 않습니다.",
        ),
        "h": Text(
            en="Line h: the listener has a thread of its own.",
            ko="h에서는 수신기에 자기 스레드가 있습니다.",
        ),
    },
)
