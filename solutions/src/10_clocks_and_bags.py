# %% [markdown] lang="en" name="title"
# # Exercises 10 · Clocks and bags
#
# Seven tasks, 27 points, about 60 minutes. The page they belong to: [10 · Clocks and bags](../../notebooks/en/10_clocks_and_bags.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E10.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E10.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# Your numbers come from `task(...)` and may differ from your neighbour's.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 10 · 시계와 bag
#
# 과제 일곱 개, 27점, 약 60분입니다. 함께 보는 페이지: [10 · 시계와 bag](../../notebooks/ko/10_clocks_and_bags.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E10.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E10.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
from itertools import pairwise

from rclpy.time import Time
from tf2_ros import TransformException

# %% [markdown] lang="en" name="e10-1"
# ## E10.1 · Four set-ups (4 points)
#
# A bag that was recorded last year is played, and a node looks up `map ← laser_frame` for each scan. `e10_1.setups` has four set-ups: the node's `use_sim_time`, and whether the bag is played with `--clock`.
# For each, give a list of three results, in this order:
#
# 1. the lookup at the scan's stamp, 2. the lookup at `self.get_clock().now()`, 3. a timer of one second.
#
# Each result is one of these: `"works"` · `"just short"` (an exception: less than a second is missing) · `"years off"` (an exception: the two times are years apart) · `"silently latest"` (answered with the latest transform instead) · `"never"` (nothing ever happens)
#
# A list looks like `["works", "works", "never"]`. The first scan, which is older than all transforms, does not count.

# %% [markdown] lang="ko" name="e10-1"
# ## E10.1 · 네 가지 설정 (4점)
#
# 작년의 bag을 재생하고, 노드는 스캔마다 `map ← laser_frame`을 조회합니다. `e10_1.setups`에 네 가지 설정이 있습니다. 노드의 `use_sim_time` 값과, 재생할 때 `--clock`을 주었는지입니다.
#
# 설정마다 다음 셋이 어떻게 되는지 이 순서의 리스트로 답하십시오.
#
# 1. 스캔의 측정 시각의 변환을 조회할 때, 2. `self.get_clock().now()`의 변환을 조회할 때, 3. 1초짜리 타이머
#
# `"works"`(됩니다) · `"just short"`(1초 미만의 차이로 거절됩니다) · `"years off"`(아주 큰 차이로 거절됩니다) · `"silently latest"`(오류 없이 최신 변환이 나옵니다) · `"never"`(아무 일도 일어나지 않습니다)
#
# 예: `["works", "works", "never"]`. TF 전체보다 오래된 첫 스캔은 세지 않습니다.

# %% name="e10-1-given"
e10_1 = task("E10.1")

# %% name="e10-1-answer" tags=["answer"]
# BEGIN SOLUTION
a, b, c, d = (
    {
        (False, False): ["works", "years off", "works"],
        (False, True): ["works", "years off", "works"],
        (True, False): ["works", "silently latest", "never"],
        (True, True): ["works", "just short", "works"],
    }[way["use_sim_time"], way["--clock"]]
    for way in e10_1.setups.values()
)
# END SOLUTION
outcomes = {"a": a, "b": b, "c": c, "d": d}

# %% name="e10-1-check" tags=["check"]
check("E10.1", outcomes)

# %% [markdown] lang="en" name="e10-2"
# ## E10.2 · The smallest recording (4 points)
#
# Three robots. For each write the `ros2 bag record …` line with as few topics as possible and no options. On Jazzy you may write `--topics` before the topics. Humble does not have it, and Lyrical requires it.
#
# - **a** A real robot with localisation and wheel odometry, like ours. Tomorrow you want to see `e10_2.sensor["a"]` on the map, where the robot placed it.
# - **b** The same in a simulation, with `e10_2.sensor["b"]`. Tomorrow your nodes should use the simulation's own time.
# - **c** A real robot without localisation. Its wheel odometry is published as messages on `e10_2.wheels["c"]`, and not as transforms. Tomorrow you want to localise it with `e10_2.sensor["c"]`; a node will turn the odometry into transforms then.

# %% [markdown] lang="ko" name="e10-2"
# ## E10.2 · 가장 작은 기록 (4점)
#
# 로봇이 셋 있습니다. 각각 토픽이 가장 적은 `ros2 bag record …` 명령을 쓰십시오. 옵션 없이 토픽만 적습니다. Jazzy에서는 토픽 앞에 `--topics`를 적어도 됩니다. Humble에는 없고, Lyrical에서는 반드시 적어야 합니다.
#
# - **a** 우리 로봇처럼 위치 추정과 바퀴 오도메트리가 있는 실제 로봇입니다. 내일 `e10_2.sensor["a"]`의 데이터를 지도에, 로봇이 측정한 그 자리에 표시하려 합니다.
# - **b** 시뮬레이션에서 `e10_2.sensor["b"]`로 같은 일을 합니다. 내일 재생할 때도 시뮬레이션의 시간을 써야 합니다.
# - **c** 위치 추정이 없는 실제 로봇입니다. 바퀴 오도메트리 노드는 `e10_2.wheels["c"]`로 오도메트리 메시지를 발행하고, 변환은 발행하지 않습니다. 내일 `e10_2.sensor["c"]`로 위치를 추정하려 합니다. 그때 다른 노드가 오도메트리를 변환으로 바꿉니다.

# %% name="e10-2-given"
e10_2 = task("E10.2")

# %% name="e10-2-answer" tags=["answer"]
# BEGIN SOLUTION
on_the_map = f"ros2 bag record {e10_2.sensor['a']} /tf /tf_static"
in_simulation = f"ros2 bag record {e10_2.sensor['b']} /tf /tf_static /clock"
to_localise = f"ros2 bag record {e10_2.sensor['c']} {e10_2.wheels['c']} /tf_static"
# END SOLUTION
recordings = {"a": on_the_map, "b": in_simulation, "c": to_localise}

# %% name="e10-2-check" tags=["check"]
check("E10.2", recordings)

# %% [markdown] lang="en" name="e10-3"
# ## E10.3 · Five failures (5 points)
#
# `e10_3.failures` describes five failures. Each has the counts of `bag info`, the command that plays the bag, each node's `use_sim_time`, and the first line of the log. For each give its cause and what to do first:
#
# - causes: `"mounts not recorded"`, `"mounts skipped"`, `"nobody publishes /clock"`, `"one node on another clock"`, `"time went back"`, `"sensor broken"`
# - what to do: `"record again, with /tf_static"`, `"play from the start"`, `"play with --clock"`, `"set use_sim_time on that node"`, `"Buffer(node=self)"`, `"set use_sim_time on all nodes"`, `"raise the timeout"`, `"replace the sensor"`

# %% [markdown] lang="ko" name="e10-3"
# ## E10.3 · 다섯 가지 고장 (5점)
#
# `e10_3.failures`에 다섯 가지 고장이 있습니다. `bag info`의 개수, 재생 명령, 노드마다의 `use_sim_time`, 로그의 첫 줄입니다. 각각 원인과 먼저 할 일을 답하십시오.
#
# - 원인: `"mounts not recorded"`(장착 변환을 기록하지 않음), `"mounts skipped"`(장착 변환을 건너뜀), `"nobody publishes /clock"`(/clock을 발행하는 노드가 없음), `"one node on another clock"`(한 노드가 다른 시계를 따름), `"time went back"`(시각이 되돌아감), `"sensor broken"`(센서 고장)
# - 할 일: `"record again, with /tf_static"`(다시 기록), `"play from the start"`(처음부터 재생), `"play with --clock"`, `"set use_sim_time on that node"`(그 노드에 설정), `"Buffer(node=self)"`, `"set use_sim_time on all nodes"`(모든 노드에 설정), `"raise the timeout"`(timeout 늘리기), `"replace the sensor"`(센서 교체)

# %% name="e10-3-given"
e10_3 = task("E10.3")

# %% name="e10-3-answer" tags=["answer"]
# BEGIN SOLUTION
# fmt: off
a_cause, a_do, b_cause, b_do, c_cause, c_do, d_cause, d_do, e_cause, e_do = (
    word for one in e10_3.failures.values() for word in (
        ("mounts not recorded", "record again, with /tf_static") if "/tf_static" not in one["info"]
        else ("mounts skipped", "play from the start") if "--start-offset" in one["play"]
        else ("nobody publishes /clock", "play with --clock") if "--clock" not in one["play"]
        else ("time went back", "Buffer(node=self)") if "--loop" in one["play"]
        else ("one node on another clock", "set use_sim_time on that node")
    )
)
# fmt: on
# END SOLUTION
findings = {"a cause": a_cause, "a do": a_do, "b cause": b_cause, "b do": b_do, "c cause": c_cause, "c do": c_do}
findings |= {"d cause": d_cause, "d do": d_do, "e cause": e_cause, "e do": e_do}

# %% name="e10-3-check" tags=["check"]
check("E10.3", findings)

# %% [markdown] lang="en" name="e10-4"
# ## E10.4 · Which clock does a node get? (4 points)
#
# `params` is a YAML parameter file as Python reads it, such as `{"/**": {"ros__parameters": {"use_sim_time": True}}, "mapper": {"ros__parameters": {"rate": 5.0}}}`; `nodes` are full names, such as `["/mapper", "/front/mapper"]`, which are two nodes.
#
# - `/**` applies to all nodes. A node's own entry, with or without the leading slash, overrides the values that it sets, wherever it is in the file. A node has at most one entry of its own: never both `mapper` and `/mapper`.
# - `True` is `"sim"`, and `False` is `"wall"` (system time, also called wall time). A node without a value is `"wall"`, too.
# - Anything other than `True` or `False` is `"refused"`: rclpy logs an error.
#
# Return a list with one word for each node, in the order of `nodes`.

# %% [markdown] lang="ko" name="e10-4"
# ## E10.4 · 노드는 어느 시계를 씁니까? (4점)
#
# `params`는 YAML 파라미터 파일을 파이썬이 읽은 것입니다. 예: `{"/**": {"ros__parameters": {"use_sim_time": True}}, "mapper": {"ros__parameters": {"rate": 5.0}}}`. `nodes`는 `["/mapper", "/front/mapper"]` 같은 전체 이름이며, 이 둘은 서로 다른 노드입니다.
#
# - `/**`는 모든 노드에 적용됩니다. 노드 자신의 항목은 이름 앞에 슬래시가 있든 없든, 파일의 어디에 있든 `/**`보다 우선합니다. 노드 자신의 항목은 많아야 하나입니다. `mapper`와 `/mapper`가 함께 있는 일은 없습니다.
# - `True`면 `"sim"`, `False`면 `"wall"`(시스템 시간, wall time)입니다. 설정되지 않은 노드도 `"wall"`입니다.
# - `True`도 `False`도 아니면 `"refused"`입니다. rclpy가 오류를 기록합니다.
#
# `nodes`의 순서대로 노드마다 단어 하나가 든 리스트를 반환하십시오.


# %% name="e10-4-answer" tags=["answer"]
def clock_of(params, nodes):
    """Return for each node "sim", "wall" or "refused"."""
    # BEGIN SOLUTION
    words = []
    for node in nodes:
        value = False
        for key in ("/**", node.lstrip("/"), node):
            value = params.get(key, {}).get("ros__parameters", {}).get("use_sim_time", value)
        words.append(("sim" if value else "wall") if isinstance(value, bool) else "refused")
    return words
    # END SOLUTION


# %% name="e10-4-check" tags=["check"]
check("E10.4", clock_of)

# %% [markdown] lang="en" name="e10-5"
# ## E10.5 · How wrong is the sensor's clock? (3 points)
#
# `e10_5.log` contains (stamp, arrival) of a sensor's messages [s]: the stamp by the sensor's clock, the arrival by the robot's. A message that is not held up takes `e10_5.shortest_delay_s`, and in a log as long as this one at least one message arrives without further delay.
# By how many seconds is the sensor's clock **behind** the robot's? Negative if it is ahead.

# %% [markdown] lang="ko" name="e10-5"
# ## E10.5 · 센서의 시계는 얼마나 틀렸습니까? (3점)
#
# `e10_5.log`에는 센서 메시지들의 (측정 시각, 수신 시각)이 초 단위로 있습니다. 측정 시각은 센서의 시계로, 수신 시각은 로봇의 시계로 잰 것입니다. 정상인 메시지는 `e10_5.shortest_delay_s`만큼 걸리고, 이만큼 긴 로그라면 막히지 않고 온 메시지가 적어도 하나는 있습니다.
#
# 센서의 시계는 로봇의 시계보다 몇 초 **뒤처져 있습니까**? 앞서 있으면 음수로 답하십시오.

# %% name="e10-5-given"
e10_5 = task("E10.5")

# %% name="e10-5-answer" tags=["answer"]
# BEGIN SOLUTION
behind_s = min(heard - stamp for stamp, heard in e10_5.log) - e10_5.shortest_delay_s
# END SOLUTION

# %% name="e10-5-check" tags=["check"]
check("E10.5", behind_s)

# %% [markdown] lang="en" name="e10-6"
# ## E10.6 · Can a bag's transforms place its own messages? (4 points)
#
# `buffer` contains a bag's transforms, `messages` its stamped messages (each has a `header`), `target` is the frame in which they are wanted.
# Return `{"placed": how many have a transform at their own stamps, "last_x_m": an x [m], "first_no": the name of the first exception's class}`.
# Take the last message that has a transform. `"last_x_m"` is the x of the origin of its frame, in `target`. It is `0.0` if no message has a transform. If all have one, `"first_no"` is `"none"`. For example `{"placed": 4, "last_x_m": 2.5, "first_no": "LookupException"}`.

# %% [markdown] lang="ko" name="e10-6"
# ## E10.6 · 담긴 변환만으로 센서 데이터를 지도에 표시할 수 있습니까? (4점)
#
# `buffer`에는 bag의 변환이, `messages`에는 측정 시각이 있는 메시지(`header`가 있습니다)가 들어 있습니다. `target`은 기준이 될 좌표계입니다.
#
# `{"placed": 자기 측정 시각의 변환이 있는 메시지의 수, "last_x_m": x [m], "first_no": 처음 발생한 예외의 클래스 이름}`을 반환하십시오.
# 변환이 있는 마지막 메시지를 찾습니다. `"last_x_m"`은 그 메시지의 좌표계 원점의 x이고, `target`을 기준으로 합니다. 변환이 있는 메시지가 없으면 `0.0`입니다. 모두 변환이 있으면 `"first_no"`는 `"none"`입니다. 예: `{"placed": 4, "last_x_m": 2.5, "first_no": "LookupException"}`.


# %% name="e10-6-answer" tags=["answer"]
def placeable(buffer, messages, target):
    """Return how many messages can be placed, the x of the last one's frame, and the first refusal."""
    # BEGIN SOLUTION
    placed, last_x_m, first_no = 0, 0.0, "none"
    for message in messages:
        try:
            found = buffer.lookup_transform(target, message.header.frame_id, Time.from_msg(message.header.stamp))
            last_x_m = found.transform.translation.x
            placed += 1
        except TransformException as error:
            if first_no == "none":
                first_no = type(error).__name__
    return {"placed": placed, "last_x_m": last_x_m, "first_no": first_no}
    # END SOLUTION


# %% name="e10-6-check" tags=["check"]
check("E10.6", placeable)

# %% [markdown] lang="en" name="e10-7"
# ## E10.7 · When must a buffer be cleared? (3 points)
#
# `clock_s` are the values of `/clock` [s], in the order in which they arrived. A buffer must be cleared when the time goes back by 1 s or more from one value to the next; a smaller step back only means that messages arrived out of order.
# Return the values at which it must be cleared: for each jump back, the first value after the jump.

# %% [markdown] lang="ko" name="e10-7"
# ## E10.7 · 버퍼는 언제 비워야 합니까? (3점)
#
# `clock_s`는 받은 순서대로 적은 `/clock`의 값입니다[s]. 시각이 한 값에서 다음 값으로 1초 이상 되돌아가면 버퍼를 비워야 합니다. 그보다 조금 되돌아간 것은 메시지의 순서가 바뀌었을 뿐입니다.
#
# 시각이 되돌아간 직후의 첫 값들을 리스트로 반환하십시오.


# %% name="e10-7-answer" tags=["answer"]
def jumps(clock_s):
    """Return the readings at which a buffer must forget."""
    # BEGIN SOLUTION
    return [after for before, after in pairwise(clock_s) if before - after >= 1.0]
    # END SOLUTION


# %% name="e10-7-check" tags=["check"]
check("E10.7", jumps)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading asks the same questions with other numbers.
# On a robot: after your next recording, type `ros2 bag info`, and look for `/tf_static` first.
#
# **Next:** [11 Tools and RViz](../../notebooks/en/11_tools_and_rviz.ipynb).

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기의 check는 여러분의 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서는 다음 기록을 마친 뒤 `ros2 bag info`를 입력하고, 가장 먼저 `/tf_static`의 줄을 찾아보세요.
#
# **다음:** [11 도구와 RViz](../../notebooks/ko/11_tools_and_rviz.ipynb)로 갑니다.
