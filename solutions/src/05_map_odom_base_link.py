# %% [markdown] lang="en" name="title"
# # Exercises 05 · map, odom, base_link
#
# Six tasks, 22 points, about 60 minutes. The page they belong to: [05 · map, odom, base_link](../../notebooks/en/05_map_odom_base_link.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E5.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E5.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# Your numbers come from `task(...)` and may differ from your neighbour's. So answer with an expression, such as `e5_2.odom_T_base.inverse()`, and not with a number that you calculated elsewhere.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 05 · map, odom, base_link
#
# 과제 여섯 개, 22점, 약 60분입니다. 함께 보는 페이지: [05 · map, odom, base_link](../../notebooks/ko/05_map_odom_base_link.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E5.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E5.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다. 그러니 따로 계산한 숫자가 아니라 `e5_2.odom_T_base.inverse()` 같은 식으로 답해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math

from tflab.core import Transform

# %% [markdown] lang="en" name="e5-1"
# ## E5.1 · What a localiser publishes (4 points)
#
# All three arguments are `Transform`s that are valid at the same time: the pose of the *laser* on the map, as the localiser found it, the robot's pose from the wheel odometry, and the laser's mount.
# Return the `Transform` to publish as `map → odom`.

# %% [markdown] lang="ko" name="e5-1"
# ## E5.1 · 위치 추정 노드가 발행하는 것 (4점)
#
# 세 인자는 같은 시각의 `Transform`입니다. 지도에서 찾아낸 *레이저의* 포즈, 로봇의 오도메트리 포즈, 레이저의 장착 변환입니다.
# `map → odom`으로 발행할 `Transform`을 반환하십시오.


# %% name="e5-1-answer" tags=["answer"]
def map_to_odom(map_T_laser, odom_T_base, base_T_laser):
    """Return map_T_odom."""
    # BEGIN SOLUTION
    map_T_base = map_T_laser @ base_T_laser.inverse()
    return map_T_base @ odom_T_base.inverse()
    # END SOLUTION


# %% name="e5-1-check" tags=["check"]
check("E5.1", map_to_odom)

# %% [markdown] lang="en" name="e5-2"
# ## E5.2 · A loop closure (4 points)
#
# Before the correction the edge is `map_T_odom`, and the odometry gives `odom_T_base`. Now the robot recognises a door, and the localiser finds the robot's pose: `found_T_base` is the new `map_T_base`. All of these are for the same time.
#
# - `"believed"`: where was the robot on the map before, (x, y) [m]?
# - `"jump_m"`: how far does the robot jump on the map [m]?
# - `"map_T_odom"`: the new edge.
# - `"step_in_odom_m"`: how far does the robot jump in `odom` [m]?

# %% [markdown] lang="ko" name="e5-2"
# ## E5.2 · 루프 폐쇄가 일어날 때 (4점)
#
# 바로잡기 전의 연결은 `map_T_odom`이고, 오도메트리의 포즈는 `odom_T_base`입니다. 이때 루프 폐쇄(loop closure)가 일어납니다. 로봇이 전에 본 문을 알아보고 지도 위의 자기 포즈를 새로 구합니다. 이 새 `map_T_base`가 `found_T_base`입니다. 모두 같은 시각의 것입니다.
#
# - `"believed"`: 바로잡기 전의 변환으로는 로봇이 지도의 어디에 있습니까? (x, y) [m]
# - `"jump_m"`: 지도 기준으로 로봇이 얼마나 튑니까[m]?
# - `"map_T_odom"`: 새 연결입니다.
# - `"step_in_odom_m"`: `odom` 기준으로 로봇이 얼마나 튑니까[m]?

# %% name="e5-2-given"
e5_2 = task("E5.2")

# %% name="e5-2-answer" tags=["answer"]
# BEGIN SOLUTION
before = e5_2.map_T_odom @ e5_2.odom_T_base
believed = before.translation[:2]
jump_m = math.dist(before.translation, e5_2.found_T_base.translation)
new_edge = e5_2.found_T_base @ e5_2.odom_T_base.inverse()
step_in_odom_m = 0.0
# END SOLUTION
closure = {"believed": believed, "jump_m": jump_m, "map_T_odom": new_edge, "step_in_odom_m": step_in_odom_m}

# %% name="e5-2-check" tags=["check"]
check("E5.2", closure)

# %% [markdown] lang="en" name="e5-3"
# ## E5.3 · Which frame for which purpose? (4 points)
#
# Choose `"map"`, `"odom"` or `"base_link"` for each of the eight purposes:
#
# - **dock** the position of the charging dock, for tomorrow
# - **line** follow the next half metre of a line on the floor
# - **laser** the laser's mount
# - **kitchen** the route to the kitchen
# - **speed** the robot's speed over the last second, from its poses
# - **obstacles** obstacles of the last five seconds, around the robot, to keep clear of
# - **tray** the position of the cup that the robot carries
# - **goal** a goal to which the robot drives for ten minutes, while corrections come

# %% [markdown] lang="ko" name="e5-3"
# ## E5.3 · 어떤 일에 어떤 좌표계를 씁니까? (4점)
#
# 여덟 가지 일에 각각 `"map"`, `"odom"`, `"base_link"` 가운데 하나로 답하십시오.
#
# - **dock** 내일도 쓸 충전대의 위치
# - **line** 바닥의 선을 앞으로 0.5 m 따라가기
# - **laser** 레이저의 장착 변환
# - **kitchen** 부엌까지 가는 경로
# - **speed** 포즈로 계산하는 지난 1초의 속도
# - **obstacles** 최근 5초 동안 로봇 주위에서 본, 피해야 할 것
# - **tray** 로봇이 나르는 컵의 위치
# - **goal** 보정이 들어오는 10분 동안 찾아가는 목적지

# %% name="e5-3-answer" tags=["answer"]
jobs = {
    # BEGIN SOLUTION
    "dock": "map",
    "line": "odom",
    "laser": "base_link",
    "kitchen": "map",
    "speed": "odom",
    "obstacles": "odom",
    "tray": "base_link",
    "goal": "map",
    # END SOLUTION
}

# %% name="e5-3-check" tags=["check"]
check("E5.3", jobs)

# %% [markdown] lang="en" name="e5-4"
# ## E5.4 · A robot that flickers (3 points)
#
# In RViz the robot appears and disappears many times a second, with Fixed Frame `map` as well as with `odom`. This was published in one second:
#
# | node | edge | messages |
# |---|---|---|
# | `/wheels` | `odom → base_footprint` | 20 |
# | `/scan_matcher` | `map → base_footprint` | 10 |
# | `/robot_state_publisher` | `base_footprint → base_link` | 1 |
#
# - `"node"`: which node has to change: `"/wheels"`, `"/scan_matcher"` or `"/robot_state_publisher"`?
# - `"edge"`: which edge should it send: `"map -> odom"`, `"map -> base_link"`, `"odom -> base_footprint"` or `"none"`?
# - `"error"`: what error does TF2 report because two nodes publish the same child: `"LookupException"`, `"ConnectivityException"` or `"nothing"`?

# %% [markdown] lang="ko" name="e5-4"
# ## E5.4 · 깜빡이는 로봇 (3점)
#
# RViz의 고정 좌표계(Fixed Frame)가 `map`이든 `odom`이든, 로봇이 1초에도 여러 번 나타났다 사라집니다. 1초 동안 발행된 변환을 요약하면 다음과 같습니다.
#
# | 노드 | 연결 | 메시지 수 |
# |---|---|---|
# | `/wheels` | `odom → base_footprint` | 20 |
# | `/scan_matcher` | `map → base_footprint` | 10 |
# | `/robot_state_publisher` | `base_footprint → base_link` | 1 |
#
# - `"node"`: 어느 노드를 고쳐야 합니까? `"/wheels"`, `"/scan_matcher"`, `"/robot_state_publisher"` 가운데 하나.
# - `"edge"`: 그 노드는 어느 연결을 발행해야 합니까? `"map -> odom"`, `"map -> base_link"`, `"odom -> base_footprint"`, `"none"`(발행하지 않음) 가운데 하나.
# - `"error"`: 두 노드가 같은 자식을 발행한다는 이유로 TF2는 어떤 오류를 냅니까? `"LookupException"`, `"ConnectivityException"`, `"nothing"`(오류 없음) 가운데 하나.

# %% name="e5-4-answer" tags=["answer"]
finding = {
    # BEGIN SOLUTION
    "node": "/scan_matcher",
    "edge": "map -> odom",
    "error": "nothing",
    # END SOLUTION
}

# %% name="e5-4-check" tags=["check"]
check("E5.4", finding)

# %% [markdown] lang="en" name="e5-5"
# ## E5.5 · The projection onto the floor (3 points)
#
# `odom_T_base` is a `Transform`: the pose of `base_link`, at some height, and tilted by a ramp. `Transform.rpy()` returns roll, pitch and yaw, in this order.
# Return the pose of `base_footprint`: straight below `base_link` on the floor, level, and with the same yaw. Write it as a dict `{"x": …, "y": …, "yaw": …}` in metres and radians.

# %% [markdown] lang="ko" name="e5-5"
# ## E5.5 · 바닥에 투영하기 (3점)
#
# `odom_T_base`는 `Transform`입니다. `base_link`는 바닥보다 높은 곳에 있고 경사로에서 기울어져 있습니다. `Transform.rpy()`는 roll, pitch, yaw를 반환합니다.
# 로봇을 바닥에 투영하여, 기울지 않으며 yaw가 같은 footprint를 dict로 반환하십시오. `{"x": …, "y": …, "yaw": …}`, 단위는 m와 rad입니다.


# %% name="e5-5-answer" tags=["answer"]
def footprint(odom_T_base):
    """Return {"x", "y", "yaw"} of base_footprint in odom."""
    # BEGIN SOLUTION
    x, y, _ = odom_T_base.translation
    return {"x": x, "y": y, "yaw": odom_T_base.rpy()[2]}
    # END SOLUTION


# %% name="e5-5-check" tags=["check"]
check("E5.5", footprint)

# %% [markdown] lang="en" name="e5-6"
# ## E5.6 · The correction, through TF (4 points)
#
# A scan was taken at `stamp_ns` and matched to the map, which took some time. The result is `map_T_base`, a `Transform`: the pose of `base_footprint` on the map when the scan was taken.
# `buffer` is tflab's own buffer, as on this chapter's page: `buffer.lookup_transform(target, source, stamp_ns).transform` is a `Transform`. It contains the edge of the wheel odometry, `odom → base_footprint`.
# Return the `Transform` to publish as `map → odom`. If the buffer has no data for that time, let its exception through.

# %% [markdown] lang="ko" name="e5-6"
# ## E5.6 · TF로 구하는 보정 (4점)
#
# `stamp_ns`에 측정한 스캔을 지도와 맞추는 데 시간이 조금 걸렸습니다. 결과 `map_T_base`는 스캔을 측정한 시각의, 지도 위 `base_footprint`의 포즈를 담은 `Transform`입니다.
# `buffer`는 이 장의 페이지에서 쓴 tflab의 버퍼입니다. `buffer.lookup_transform(target, source, stamp_ns).transform`이 `Transform`입니다. 버퍼에는 바퀴 오도메트리의 연결 `odom → base_footprint`가 들어 있습니다.
# `map → odom`으로 발행할 `Transform`을 반환하십시오. 버퍼에 그 시각의 값이 없으면 예외를 잡지 말고 그대로 두십시오.


# %% name="e5-6-answer" tags=["answer"]
def correction(buffer, map_T_base, stamp_ns):
    """Return map_T_odom at stamp_ns."""
    # BEGIN SOLUTION
    odom_T_base = buffer.lookup_transform("odom", "base_footprint", stamp_ns).transform
    return map_T_base @ odom_T_base.inverse()
    # END SOLUTION


# %% name="e5-6-check" tags=["check"]
check("E5.6", correction)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading asks the same questions with other numbers.
# On a robot, let `ros2 run tf2_ros tf2_echo map odom` run while it drives: the value is constant, and then it jumps.
#
# **Next:** [06 Static and dynamic](../../notebooks/en/06_static_and_dynamic.ipynb).

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기의 check는 여러분의 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서는 달리는 동안 `ros2 run tf2_ros tf2_echo map odom`을 실행해 보세요. 가만히 있다가 한 번에 튑니다.
#
# **다음:** [06 정적 변환과 동적 변환](../../notebooks/ko/06_static_and_dynamic.ipynb)
