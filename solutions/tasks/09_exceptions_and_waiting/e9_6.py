"""E9.6: Where may I wait?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Twin, Words

OUTCOMES = ("works", "waits in vain", "waits for ever")


WAITS = dict(zip("abcdefgh", ("waits in vain", "works", "waits in vain", "works", "waits for ever", "waits in vain",
                              "waits in vain", "works"), strict=True))  # fmt: skip


def waits(**changed: str) -> dict[str, str]:
    return {**WAITS, **changed}


A_TIMEOUT_ALWAYS_HELPS = Twin(
    "a timeout always helps",
    waits(a="works", c="works", e="works", f="works", g="works"),
    misconception="M10",
    reply=Words(
        en="you trust waiting too much. For each line ask: while it waits, who takes the transform off the network? And is it ever going to come?",
        ko="기다림을 너무 믿고 있습니다. 줄마다 물어보십시오. 기다리는 동안 변환은 누가 받습니까? 그리고 오기는 합니까?",
    ),
)


ONLY_SUBSCRIPTIONS_BLOCK = Twin(
    "only subscriptions block",
    waits(c="works"),
    misconception="M10",
    reply=Words(
        en="a timer's callback runs in the same thread as every other callback.",
        ko="타이머 콜백도 다른 모든 콜백과 같은 스레드에서 실행됩니다.",
    ),
)


THREADS_CANNOT_HELP = Twin(
    "threads cannot help",
    waits(b="waits in vain", h="waits in vain"),
    misconception="M10",
    reply=Words(
        en="waiting in a callback is not bad as such. Where another thread may call the listener meanwhile, it works.",
        ko="콜백에서 기다리는 것 자체가 나쁜 것은 아닙니다. 그동안 다른 스레드가 수신기를 부를 수 있으면 통합니다.",
    ),
    partly=True,
)


A_TIMEOUT_NEVER_ENDS = Twin(
    "a timeout never ends",
    waits(**dict.fromkeys("acfg", "waits for ever")),
    misconception="M10",
    reply=Words(
        en="a wait with `timeout=0.3 s` is over after 0.3 s, whatever happens. Which line has no timeout at all?",
        ko="`timeout=0.3 s`인 기다림은 무슨 일이 있어도 0.3초 뒤에 끝납니다. timeout이 아예 없는 줄은 어느 것입니까?",
    ),
    partly=True,
)


A_PROMISE_BLOCKS = Twin(
    "a promise blocks",
    waits(d="waits in vain"),
    misconception="M10",
    reply=Words(
        en="`wait_for_transform_async` returns at once, so the one thread is free again to take in the transform.",
        ko="`wait_for_transform_async`는 바로 돌아오므로, 하나뿐인 스레드도 다시 변환을 받을 수 있습니다.",
    ),
)


PROMISES_EXPIRE = Twin(
    "promises expire",
    waits(e="waits in vain"),
    misconception="M10",
    reply=Words(
        en="a promise of `wait_for_transform_async` has no timeout. What becomes of one that can never be kept?",
        ko="`wait_for_transform_async`의 약속에는 timeout이 없습니다. 결코 지켜질 수 없는 약속은 어떻게 됩니까?",
    ),
)


TASK = Task(
    id="E9.6",
    kind="M",
    points=2,
    title=Words(en="Where may I wait?", ko="어디서 기다려도 될까요?"),
    answer="outcomes",
    form=Parts({name: Choice(OUTCOMES) for name in "abcdefgh"}),
    twins=(
        A_TIMEOUT_ALWAYS_HELPS,
        ONLY_SUBSCRIPTIONS_BLOCK,
        THREADS_CANNOT_HELP,
        A_TIMEOUT_NEVER_ENDS,
        A_PROMISE_BLOCKS,
        PROMISES_EXPIRE,
    ),
    hints=(
        Words(
            en="Two questions for each line: who takes in transforms meanwhile, and will the right one ever come?",
            ko="줄마다 두 가지를 물으십시오. 그동안 변환은 누가 받습니까? 맞는 변환이 언젠가 오기는 합니까?",
        ),
        Words(
            en="`rclpy.spin(node)` is one thread. Nobody spins at all in one of the lines.",
            ko="`rclpy.spin(node)`는 스레드 하나입니다. 아무도 spin하지 않는 줄도 있습니다.",
        ),
        Words(
            en="In two lines the right transform does not come in time whatever the threads: one has a timeout and gives up, the other is a promise and does not.",
            ko="두 줄에서는 스레드가 몇 개든 맞는 변환이 제때 오지 않습니다. 하나는 timeout이 있어 포기하고, 다른 하나는 약속이라 포기하지 않습니다.",
        ),
    ),
    cures=("M10",),
)
