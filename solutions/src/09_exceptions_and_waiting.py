# %% [markdown] lang="en" name="title"
# # Exercises 09 · Exceptions and waiting
#
# Seven tasks, 22 points, about 45 minutes. The page they belong to: [09 · Exceptions and waiting](../../notebooks/en/09_exceptions_and_waiting.ipynb).
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# `check` tells you which mistake it was; `hint("E9.2")` helps, one step at a time.
#
# The numbers of E9.4 and E9.7 come from `task(...)` and may differ from your neighbour's. So in E9.7 write a formula with `e9_7.…`, not a number.
#
# What you write in E9.2, E9.3 and E9.5 runs unchanged on a robot.
# After a pass, or three tries, `solution("E9.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 09 · 예외와 기다림
#
# 과제 일곱 개, 22점, 약 45분입니다. 함께 보는 페이지: [09 · 예외와 기다림](../../notebooks/ko/09_exceptions_and_waiting.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E9.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E9.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
#
# E9.4와 E9.7의 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다. E9.7에는 계산한 숫자가 아니라 식으로 답하십시오.
#
# E9.2, E9.3, E9.5에서 쓴 코드는 로봇에서 그대로 실행됩니다.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import numpy as np
from rclpy.time import Time
from tf2_ros import ConnectivityException, ExtrapolationException, InvalidArgumentException
from tf2_ros import LookupException, TransformException

# %% [markdown] lang="en" name="e9-1"
# ## E9.1 · Eight lines from a log (4 points)
#
# Eight lines, all from one robot, and what its buffer contained at that time.
#
# - `"a"` to `"h"`: which kind is it? `"lookup"`, `"connectivity"`, `"future"`, `"past"`, `"one sample"`, `"invalid argument"` or `"not a TransformException"`.
# - `"c edge"`, `"d edge"`: which edge limits the lookup? Give its child frame.
# - `"h check"`: what do you look at first? `"spelling and publisher"`, `"roots of the tree"`, `"use_sim_time"`, `"the line of code"` or `"a longer timeout"`.

# %% [markdown] lang="ko" name="e9-1"
# ## E9.1 · 로그 속 여덟 줄 (4점)
#
# `e9_1`에는 한 로봇의 로그 여덟 줄과 그때 버퍼에 들어 있던 내용이 있습니다.
#
# - `"a"`부터 `"h"`까지: 어떤 종류입니까? `"lookup"`, `"connectivity"`, `"future"`, `"past"`, `"one sample"`, `"invalid argument"`, `"not a TransformException"` 가운데 하나입니다.
# - `"c edge"`, `"d edge"`: 어느 연결에서 막혔습니까? 그 연결의 자식 좌표계를 쓰십시오.
# - `"h check"`: 무엇부터 확인합니까? `"spelling and publisher"`(철자와 발행자), `"roots of the tree"`(트리의 루트), `"use_sim_time"`, `"the line of code"`(그 코드 줄), `"a longer timeout"`(더 긴 timeout) 가운데 하나입니다.

# %% name="e9-1-given"
e9_1 = task("E9.1")

# %% name="e9-1-answer" tags=["answer"]
lines = {
    # BEGIN SOLUTION
    "a": "lookup",
    "b": "connectivity",
    "c": "future",
    "d": "past",
    "e": "one sample",
    "f": "invalid argument",
    "g": "not a TransformException",
    "h": "future",
    "c edge": "odom",
    "d edge": "base_footprint",
    "h check": "use_sim_time",
    # END SOLUTION
}

# %% name="e9-1-check" tags=["check"]
check("E9.1", lines)

# %% [markdown] lang="en" name="e9-2"
# ## E9.2 · Classify an exception (4 points)
#
# `buffer` is a `tf2_ros.Buffer`, `stamp` an `rclpy.time.Time`. Return `"ok"` if there is an answer, else
# `"invalid argument"`, `"lookup"`, `"connectivity"`, `"future"`, `"past"` or `"one sample"`.
# Use only what a robot has: the exception's class and its text. If there are several faults, tf2 decides which one it reports.

# %% [markdown] lang="ko" name="e9-2"
# ## E9.2 · 거절을 분류하기 (4점)
#
# `buffer`는 `tf2_ros.Buffer`, `stamp`는 `rclpy.time.Time`입니다. 문자열 하나를 반환하십시오. 값이 있으면 `"ok"`, 없으면
# `"invalid argument"`, `"lookup"`, `"connectivity"`, `"future"`, `"past"`, `"one sample"` 가운데 하나입니다.
#
# 로봇에서 얻을 수 있는 것, 곧 예외의 클래스와 오류 메시지만 보고 판단하십시오. 문제가 둘이면 tf2가 보고하는 것을 따르십시오.

# %% name="e9-2-answer" tags=["answer"]
def classify(buffer, target, source, stamp):
    """Return what kind of "no" tf2 says, or "ok"."""
    # BEGIN SOLUTION
    try:
        buffer.lookup_transform(target, source, stamp)
    except ExtrapolationException as error:
        in_text = (kind for kind in ("future", "past") if f"into the {kind}" in str(error))
        return next(in_text, "one sample")
    except TransformException as error:
        kinds = {LookupException: "lookup", ConnectivityException: "connectivity"}
        return kinds.get(type(error), "invalid argument")
    return "ok"
    # END SOLUTION

# %% name="e9-2-check" tags=["check"]
check("E9.2", classify)

# %% [markdown] lang="en" name="e9-3"
# ## E9.3 · From exception to action (4 points)
#
# A `PointStamped` has arrived, and is wanted in `map`. Decide what to do with it:
#
# | what tf2 reports | action |
# | --- | --- |
# | an answer | `"use"` |
# | future, TF is behind by 0.2 s or less | `"wait"` |
# | future, TF is behind by more | `"check clocks"` |
# | any other extrapolation | `"drop"` |
# | an unknown name | `"check names"` |
# | no path | `"check tree"` |
# | an invalid argument | `"fix message"` |
#
# "TF is behind" refers to the whole path. A wait must last until its *slowest* edge has data.
# If there are two faults at once, tf2 decides which one it reports.

# %% [markdown] lang="ko" name="e9-3"
# ## E9.3 · 예외에서 행동으로 (4점)
#
# `PointStamped`가 하나 왔고, 이것을 `map` 기준으로 바꾸려 합니다. 어떻게 할지 정하십시오.
#
# | tf2의 결과 | 행동 |
# | --- | --- |
# | 값이 있음 | `"use"` |
# | 미래, TF가 0.2초 이하로 뒤처짐 | `"wait"` |
# | 미래, TF가 그보다 더 뒤처짐 | `"check clocks"` |
# | 그 밖의 외삽 | `"drop"` |
# | 없는 이름 | `"check names"` |
# | 경로 없음 | `"check tree"` |
# | 인자가 잘못됨 | `"fix message"` |
#
# “TF가 뒤처진다”는 경로 전체를 두고 하는 말입니다. *가장 느린* 연결이 올 때까지 기다려야 합니다.
# 두 가지가 한꺼번에 틀렸다면 tf2가 보고하는 쪽을 따르십시오.

# %% name="e9-3-answer" tags=["answer"]
def decide(buffer, message):
    """Return what to do with a PointStamped that is wanted in map."""
    source, stamp = message.header.frame_id, Time.from_msg(message.header.stamp)
    # BEGIN SOLUTION
    try:
        buffer.lookup_transform("map", source, stamp)
    except ExtrapolationException as error:
        newest = buffer.get_latest_common_time("map", source)  # of the whole chain
        is_near = stamp.nanoseconds - newest.nanoseconds <= 200_000_000
        return "drop" if "into the future" not in str(error) else "wait" if is_near else "check clocks"
    except TransformException as error:
        actions = {LookupException: "check names", ConnectivityException: "check tree"}
        return actions.get(type(error), "fix message")
    return "use"
    # END SOLUTION

# %% name="e9-3-check" tags=["check"]
check("E9.3", decide)

# %% [markdown] lang="en" name="e9-4"
# ## E9.4 · Late, or wrong? (3 points)
#
# Three robots have the same warning in their logs: extrapolation into the future, by about a third of a second.
# Six messages of `/scan` and of `/odom` were recorded on each. A row is (stamp, arrival) in seconds; the arrival is by the clock of the computer that receives.
# A healthy `/scan` arrives about 0.105 s after its stamp, a healthy `/odom` about 0.005 s.
#
# - `"a"`, `"b"`, `"c"`: what is the cause on robot a, b, c? `"transforms arrive late"`, `"laser clock is fast"` (ahead) or `"cannot be told from this"`.
# - `"a do"`, `"b do"`, `"c do"`: what do you do? `"wait a little"`, `"set the laser's clock"`, `"ask chrony on both computers"` or `"set a timeout of 10 s"`.
#
# Set a clock only if these numbers show which one is wrong. If they do not, ask chrony.
#
# You may read the answer from the numbers, or let Python find it.

# %% [markdown] lang="ko" name="e9-4"
# ## E9.4 · 늦은 것입니까, 틀린 것입니까? (3점)
#
# 로봇 세 대의 로그에 똑같은 경고가 있습니다. 약 3분의 1초만큼의 미래 외삽입니다.
# 로봇마다 `/scan`과 `/odom` 메시지를 여섯 개씩 적었습니다. 한 행은 (측정 시각, 수신 시각)[s]이고, 수신 시각은 받는 컴퓨터의 시계로 적었습니다.
# 정상인 `/scan`은 측정 후 약 0.105초, 정상인 `/odom`은 약 0.005초 뒤에 도착합니다.
#
# - `"a"`, `"b"`, `"c"`: 로봇 a, b, c의 원인은 무엇입니까? `"transforms arrive late"`(변환이 늦게 옴), `"laser clock is fast"`(레이저 시계가 앞섬), `"cannot be told from this"`(이것만으로는 알 수 없음) 가운데 하나입니다.
# - `"a do"`, `"b do"`, `"c do"`: 어떻게 합니까? `"wait a little"`(조금 기다린다), `"set the laser's clock"`(레이저의 시계를 맞춘다), `"ask chrony on both computers"`(두 컴퓨터에서 chrony로 확인한다), `"set a timeout of 10 s"`(timeout을 10초로 한다) 가운데 하나입니다.
#
# 이 숫자만으로 어느 시계가 틀렸는지 알 수 있을 때만 시계를 맞추십시오. 알 수 없다면 chrony로 확인합니다.
# 눈으로 보고 적어도 되고, 파이썬으로 찾아도 됩니다.

# %% name="e9-4-given"
e9_4 = task("E9.4")

# %% name="e9-4-answer" tags=["answer"]
# BEGIN SOLUTION
causes = {}  # {"a": the cause, "a do": what you do, "b": ..., "b do": ..., "c": ..., "c do": ...}
for name, robot in (("a", e9_4.robot_a), ("b", e9_4.robot_b), ("c", e9_4.robot_c)):
    scan_s, odom_s = (np.diff(robot[topic], axis=1).ravel() for topic in ("scan", "odom"))
    if scan_s.min() < 0.0:  # heard before it was measured: no network does that
        causes[name], causes[f"{name} do"] = "laser clock is fast", "set the laser's clock"
    elif np.ptp(odom_s) > 0.1:  # it trembles
        causes[name], causes[f"{name} do"] = "transforms arrive late", "wait a little"
    else:  # smooth and positive: a slow network, or a slow clock
        causes[name], causes[f"{name} do"] = "cannot be told from this", "ask chrony on both computers"
# END SOLUTION

# %% name="e9-4-check" tags=["check"]
check("E9.4", causes)

# %% [markdown] lang="en" name="e9-5"
# ## E9.5 · A queue that stays fresh (3 points)
#
# Messages wait with the stamps `stamps_s` [s], in the order in which they arrived. The time is `now_s`.
# Keep only what is useful for a decision: nothing older than `max_age_s`, nothing from the future, and of the rest at most the `max_size` newest.
#
# Return `{"kept": [...], "lost": n}`: the stamps that stay, oldest first, and the number of messages that were dropped.
# Both are scored: what you keep must be fresh, and the number of lost messages is its price.

# %% [markdown] lang="ko" name="e9-5"
# ## E9.5 · 최근 것만 남기는 큐 (3점)
#
# 시각이 `stamps_s`[s]인 메시지들이 도착한 순서대로 기다립니다. 지금은 `now_s`입니다.
# 결정에 쓸 만한 것만 남기십시오. `max_age_s`보다 오래된 것은 버리고, 측정 시각이 미래인 것도 버리고, 나머지 가운데 가장 최근 것부터 `max_size`개까지만 남깁니다.
#
# `{"kept": [...], "lost": n}`을 반환하십시오. `"kept"`는 남은 메시지의 시각을 오래된 것부터 적은 리스트이고, `"lost"`는 버린 메시지의 수입니다.
# 둘 다 채점합니다. 최근 것만 남기면 그만큼 메시지를 잃습니다.

# %% name="e9-5-answer" tags=["answer"]
def keep(stamps_s, now_s, max_age_s, max_size):
    """Return which messages stay, oldest first, and how many go."""
    # BEGIN SOLUTION
    young = sorted(stamp for stamp in stamps_s if 0.0 <= now_s - stamp <= max_age_s)
    kept = young[max(0, len(young) - max_size):]  # [-max_size:] would keep all for a size of 0
    return {"kept": kept, "lost": len(stamps_s) - len(kept)}
    # END SOLUTION

# %% name="e9-5-check" tags=["check"]
check("E9.5", keep)

# %% [markdown] lang="en" name="e9-6"
# ## E9.6 · Where may I wait? (2 points)
#
# Transforms arrive 0.1 s late, unless the line states otherwise. For each line: `"works"`, `"waits in vain"` (and gives up), or `"waits for ever"`.
#
# - a: in the callback of `/scan`, a lookup at the scan's stamp with `timeout=0.3 s`; the node runs in `rclpy.spin(node)`.
# - b: the same, but `rclpy.spin(node, executor=MultiThreadedExecutor())`.
# - c: in a *timer's* callback, `timeout=0.3 s`; the node runs in `rclpy.spin(node)`.
# - d: in a subscription's callback, `wait_for_transform_async`; the node runs in `rclpy.spin(node)`.
# - e: as d, but the stamp is older than everything in the buffer.
# - f: as b, but the laser's clock is 2 s ahead.
# - g: in `main()`, `timeout=0.3 s`, after the node and its listener were created and before anything spins.
# - h: in `main()`, `timeout=0.3 s`, with `TransformListener(buffer, node, spin_thread=True)`.

# %% [markdown] lang="ko" name="e9-6"
# ## E9.6 · 어디서 기다려도 될까요? (2점)
#
# 따로 말이 없으면 변환은 0.1초 늦게 도착합니다. 줄마다 `"works"`(통한다), `"waits in vain"`(헛되이 기다리다 포기한다), `"waits for ever"`(영원히 기다린다) 가운데 고르십시오.
#
# - a: 구독 콜백 안에서 `timeout=0.3 s`. 노드는 `rclpy.spin(node)`로 실행합니다.
# - b: a와 같지만 `rclpy.spin(node, executor=MultiThreadedExecutor())`입니다.
# - c: *타이머* 콜백 안에서 `timeout=0.3 s`. 노드는 `rclpy.spin(node)`로 실행합니다.
# - d: 구독 콜백 안에서 `wait_for_transform_async`. 노드는 `rclpy.spin(node)`로 실행합니다.
# - e: d와 같지만 조회하는 시각이 버퍼의 모든 표본보다 과거입니다.
# - f: b와 같지만 레이저 시계가 2초 앞서 있습니다.
# - g: `main()`에서 `timeout=0.3 s`. 노드와 수신기는 만들었고, 아직 아무것도 spin하지 않습니다.
# - h: `main()`에서 `timeout=0.3 s`. 수신기는 `TransformListener(buffer, node, spin_thread=True)`입니다.

# %% name="e9-6-answer" tags=["answer"]
outcomes = {
    # BEGIN SOLUTION
    "a": "waits in vain",
    "b": "works",
    "c": "waits in vain",
    "d": "works",
    "e": "waits for ever",
    "f": "waits in vain",
    "g": "waits in vain",
    "h": "works",
    # END SOLUTION
}

# %% name="e9-6-check" tags=["check"]
check("E9.6", outcomes)

# %% [markdown] lang="en" name="e9-7"
# ## E9.7 · The smallest wait that always succeeds (2 points)
#
# `map → odom` comes from `localization`, `odom → base_footprint` from `wheel_odometry`. Each has a rate, a delay, and a jitter: each message takes between 0 and `jitter_s` longer than the delay.
# A scan arrives `scan_delay_s` after its stamp. All clocks are right, no message is lost.
#
# How long must you wait at most, counted from the scan's *arrival*, so that the lookup at its stamp always succeeds? Answer in seconds; 0.5 ms more or less is accepted.

# %% [markdown] lang="ko" name="e9-7"
# ## E9.7 · 언제나 성공하는 가장 짧은 기다림 (2점)
#
# `map → odom`은 `localization`이, `odom → base_footprint`는 `wheel_odometry`가 발행합니다. 각각 발행률과 지연이 있고, 최대 `jitter_s`만큼 더 늦을 수 있습니다.
# 스캔은 측정 시각에서 `scan_delay_s` 뒤에 도착합니다. 시계는 모두 맞고, 잃는 메시지는 없습니다.
#
# 스캔이 *도착한 때부터* 최대 얼마나 기다려야 그 시각의 조회가 언제나 성공합니까? 초 단위로 답하십시오. 0.5 ms까지의 차이는 받아들입니다.

# %% name="e9-7-given"
e9_7 = task("E9.7")

# %% name="e9-7-answer" tags=["answer"]
# BEGIN SOLUTION
sources = (e9_7.localization, e9_7.wheel_odometry)  # both edges
latest_arrival_s = max(  # [s], after the scan's stamp: when both are there, at the latest
    1 / one["rate_hz"] + one["delay_s"] + one["jitter_s"] for one in sources
)
wait_s = latest_arrival_s - e9_7.scan_delay_s  # [s], from the scan's arrival
# END SOLUTION

# %% name="e9-7-check" tags=["check"]
check("E9.7", wait_s)

# %% [markdown] lang="en" name="after"
# ## Done?
#
# On a robot, do line C10 of the checklist that `tflab progress` shows: cause each of the three errors once more, on purpose.
# **Next:** [10 Clocks and bags](../../notebooks/en/10_clocks_and_bags.ipynb). [The start page](../../notebooks/en/00_start.ipynb) shows what you have passed, and what is left.

# %% [markdown] lang="ko" name="after"
# ## 다 했다면
#
# 로봇에서 실습 체크리스트 C10을 해 보세요. 세 가지 오류를 일부러 한 번씩 더 만들어 보는 일입니다.
#
# **다음:** [10 시계와 bag](../../notebooks/ko/10_clocks_and_bags.ipynb)으로 갑니다. [첫 페이지](../../notebooks/ko/00_start.ipynb)에서 무엇을 통과했고 무엇이 남았는지 볼 수 있습니다.
