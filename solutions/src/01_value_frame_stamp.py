# %% [markdown] lang="en" name="title"
# # Exercises 01 · Value, frame and stamp
#
# Seven tasks, 23 points, about 50 minutes. The page they belong to: [01 · Value, frame and stamp](../../notebooks/en/01_value_frame_stamp.ipynb)
#
# Run the two cells below first. Then write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E1.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E1.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# Your numbers come from `task(...)` and may differ from your neighbour's. So answer with an expression, such as `e1_4.speed_mps * 2.0`, and not with a number that you calculated elsewhere. (`e1_4` contains the data of E1.4.)

# %% [markdown] lang="ko" name="title"
# # 연습 문제 01 · 값, 좌표계, 측정 시각
#
# 과제 일곱 개, 23점, 약 50분입니다. 함께 보는 페이지: [01 · 값, 좌표계, 측정 시각](../../notebooks/ko/01_value_frame_stamp.ipynb)
#
# 먼저 아래 두 셀을 실행해 보세요. 그다음 `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E1.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E1.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다. 그러니 따로 계산한 숫자가 아니라 `e1_4.speed_mps * 2.0` 같은 식으로 답해 보세요(E1.4에서 주어진 값은 `e1_4`에 들어 있습니다).

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration
from rclpy.time import Time

# %% [markdown] lang="en" name="e1-1"
# ## E1.1 · One position, three sets of coordinates (4 points)
#
# A robot is at `map_p_base` in `map` and faces along the map's x. Its laser is mounted at `base_p_laser` in `base_link` and faces the same way.
# The laser detects a post at `laser_p_post`. No frame is rotated.
# The data are lists of three numbers, and `+` between two lists joins them. So add x to x, y to y, z to z.
#
# Where is the post in `base_link`, and where in `map`? Give (x, y, z) for each.

# %% [markdown] lang="ko" name="e1-1"
# ## E1.1 · 한 위치, 세 가지 숫자 (4점)
#
# 로봇은 `map` 기준 `map_p_base`에 서서 지도의 x 방향을 봅니다. 레이저는 `base_link` 기준 `base_p_laser`에 달려 있고 같은 방향을 봅니다.
# 레이저가 기둥을 봅니다. 기둥은 `laser_frame` 기준 `laser_p_post`에 있습니다. 회전은 없습니다.
# 주어진 값은 숫자 세 개짜리 리스트입니다. 리스트끼리 `+`를 쓰면 더해지지 않고 하나의 긴 리스트가 되므로, x는 x끼리, y는 y끼리, z는 z끼리 더하십시오.
#
# 기둥은 `base_link` 기준으로 어디에 있고, `map` 기준으로는 어디에 있습니까? 각각 (x, y, z)로 답하십시오.

# %% name="e1-1-given"
e1_1 = task("E1.1")

# %% name="e1-1-answer" tags=["answer"]
# BEGIN SOLUTION
base_p_post = [a + b for a, b in zip(e1_1.base_p_laser, e1_1.laser_p_post, strict=True)]
map_p_post = [a + b for a, b in zip(e1_1.map_p_base, base_p_post, strict=True)]
# END SOLUTION
post = {"base_link": base_p_post, "map": map_p_post}

# %% name="e1-1-check" tags=["check"]
check("E1.1", post)

# %% [markdown] lang="en" name="e1-2"
# ## E1.2 · Which message can be used? (3 points)
#
# The time is 60.0 s. Six messages have arrived. The node of every topic is running, and the robot's frames are `map`, `odom`, `base_link`, `laser_frame`, `camera_link` and `camera_optical_frame`.
# For each, choose `"usable"`, `"no frame"`, `"no stamp"` or `"label contradicts numbers"` (the frame name does not fit the numbers).
#
# - **a** `/scan` of the laser: `frame_id: laser_frame`, stamp 59.9, ranges between 0.4 and 9.8
# - **b** `/detected_point` of the camera's detector: `frame_id: ''`, stamp 59.8, point (0.1, 0.2, 3.1)
# - **c** `/apple` of the camera's detector: `frame_id: camera_optical_frame`, stamp 0.0, point (0.0, 0.1, 2.2)
# - **d** `/landmark` of a node that keeps a list of lamps: `frame_id: map`, stamp 31.2, point (7.5, 2.0, 2.6)
# - **e** `/door` of the camera's detector: `frame_id: map`, stamp 59.8, point (0.0, 0.0, 1.9). The message has the same coordinates at every door.
# - **f** `/battery_tray`, measured once by a mechanic: `frame_id: base_link`, stamp 12.0, point (−0.1, 0.0, 0.2)

# %% [markdown] lang="ko" name="e1-2"
# ## E1.2 · 어느 메시지를 쓸 수 있습니까? (3점)
#
# 지금 시각은 60.0초입니다. 메시지 여섯 개가 들어왔습니다. 노드는 모두 실행 중이고, 로봇의 좌표계는 `map`, `odom`, `base_link`, `laser_frame`, `camera_link`, `camera_optical_frame`입니다.
# 각각 `"usable"`(쓸 수 있음), `"no frame"`(좌표계 없음), `"no stamp"`(측정 시각 없음), `"label contradicts numbers"`(좌표계 이름과 숫자가 모순) 가운데 하나를 고르십시오.
#
# - **a** 레이저의 `/scan`: `frame_id: laser_frame`, 측정 시각 59.9, 거리 0.4에서 9.8 사이
# - **b** 카메라 검출기의 `/detected_point`: `frame_id: ''`, 측정 시각 59.8, 점 (0.1, 0.2, 3.1)
# - **c** 카메라 검출기의 `/apple`: `frame_id: camera_optical_frame`, 측정 시각 0.0, 점 (0.0, 0.1, 2.2)
# - **d** 전등 목록이 있는 노드의 `/landmark`: `frame_id: map`, 측정 시각 31.2, 점 (7.5, 2.0, 2.6)
# - **e** 카메라 검출기의 `/door`: `frame_id: map`, 측정 시각 59.8, 점 (0.0, 0.0, 1.9). 로봇이 어느 문 앞에 서도 늘 같은 세 숫자
# - **f** 정비사가 보낸 `/battery_tray`: `frame_id: base_link`, 측정 시각 12.0, 점 (−0.1, 0.0, 0.2)

# %% name="e1-2-answer" tags=["answer"]
verdicts = {
    # BEGIN SOLUTION
    "a": "usable",
    "b": "no frame",
    "c": "no stamp",
    "d": "usable",
    "e": "label contradicts numbers",
    "f": "usable",
    # END SOLUTION
}

# %% name="e1-2-check" tags=["check"]
check("E1.2", verdicts)

# %% [markdown] lang="en" name="e1-3"
# ## E1.3 · A receiver that rejects (4 points)
#
# Write the first lines of a node's callback. `message` is a `PointStamped`, `now` a `Time`, `max_age_s` a number of seconds.
# Check in this order, and return:
#
# 1. `"no frame"` if the frame is empty,
# 2. `"no stamp"` if the stamp is zero,
# 3. `"from the future"` if it was measured after `now`,
# 4. `"too old"` if it is older than `max_age_s` (exactly `max_age_s` is still accepted),
# 5. `"use it"` otherwise.

# %% [markdown] lang="ko" name="e1-3"
# ## E1.3 · 거절할 줄 아는 노드 (4점)
#
# 노드 콜백의 첫 부분을 작성하십시오. `message`는 `PointStamped`, `now`는 `Time`, `max_age_s`는 초 단위의 숫자입니다.
# 다음 순서로 확인하고 해당하는 문자열을 반환하십시오.
#
# 1. 좌표계가 비어 있으면 `"no frame"`,
# 2. 측정 시각이 0이면 `"no stamp"`,
# 3. `now`보다 나중에 측정했다면 `"from the future"`,
# 4. `max_age_s`보다 오래되었으면 `"too old"`(정확히 `max_age_s`만큼 지난 것은 아직 쓸 수 있습니다),
# 5. 나머지는 `"use it"`.


# %% name="e1-3-answer" tags=["answer"]
def judge(message, now, max_age_s):
    """Return "use it", or why not."""
    # BEGIN SOLUTION
    if not message.header.frame_id:
        return "no frame"
    stamp = Time.from_msg(message.header.stamp)
    if stamp.nanoseconds == 0:
        return "no stamp"
    age_ns = now.nanoseconds - stamp.nanoseconds
    if age_ns < 0:
        return "from the future"
    return "too old" if age_ns > round(max_age_s * 1e9) else "use it"
    # END SOLUTION


# %% name="e1-3-check" tags=["check"]
check("E1.3", judge)

# %% [markdown] lang="en" name="e1-4"
# ## E1.4 · How far ahead is it now? (3 points)
#
# A robot drives straight towards a post at rest, at `speed_mps`. A message contains the distance to the post: `ahead_m` ahead of `base_link`.
# Its stamp is `stamp`, and it arrived at `arrived`. Both are given as in a message, (sec, nanosec).
#
# How old [s] was the measurement on arrival, and how far ahead [m] was the post then?

# %% [markdown] lang="ko" name="e1-4"
# ## E1.4 · 지금은 몇 미터 앞입니까? (3점)
#
# 로봇이 가만히 있는 기둥을 향해 `speed_mps`로 곧장 달립니다. 메시지에 따르면 기둥은 `base_link`에서 `ahead_m` 앞에 있었습니다.
# 측정 시각은 `stamp`, 도착한 시각은 `arrived`이고, 둘 다 메시지에 적힌 대로 (sec, nanosec)입니다.
#
# 도착했을 때 측정값은 몇 초[s] 전의 것이었고, 그때 기둥은 몇 미터[m] 앞에 있었습니까?

# %% name="e1-4-given"
e1_4 = task("E1.4")

# %% name="e1-4-answer" tags=["answer"]
# BEGIN SOLUTION
age_s = (e1_4.arrived[0] - e1_4.stamp[0]) + (e1_4.arrived[1] - e1_4.stamp[1]) / 1e9
ahead_on_arrival_m = e1_4.ahead_m - e1_4.speed_mps * age_s
# END SOLUTION
on_arrival = {"age_s": age_s, "ahead_m": ahead_on_arrival_m}

# %% name="e1-4-check" tags=["check"]
check("E1.4", on_arrival)

# %% [markdown] lang="en" name="e1-5"
# ## E1.5 · Which coordinates change? (3 points)
#
# The robot drives straight on. A **ball** lies on the floor, a **cup** stands on the robot's tray, and a second robot, which drives the other way, carries a **lamp**.
# The frames are `"map"`, `"base_link"` and `"laser_frame"`. For each object give the list of the frames in which its coordinates stay the same: `[]` if there are none.

# %% [markdown] lang="ko" name="e1-5"
# ## E1.5 · 누구의 숫자가 바뀝니까? (3점)
#
# 로봇이 곧장 달립니다. **공**(ball)은 바닥에 있고, **컵**(cup)은 로봇의 쟁반 위에 있으며, **전등**(lamp)은 반대쪽으로 달리는 다른 로봇이 들고 있습니다.
# 좌표계는 `"map"`, `"base_link"`, `"laser_frame"`입니다. 물체마다 숫자가 그대로인 좌표계의 리스트를 쓰십시오. 하나도 없으면 `[]`입니다.

# %% name="e1-5-answer" tags=["answer"]
stays = {
    # BEGIN SOLUTION
    "ball": ["map"],
    "cup": ["base_link", "laser_frame"],
    "lamp": [],
    # END SOLUTION
}

# %% name="e1-5-check" tags=["check"]
check("E1.5", stays)

# %% [markdown] lang="en" name="e1-6"
# ## E1.6 · Fill in frame and stamp (3 points)
#
# A sonar points along the y of `sonar_frame`, to the robot's left. Your function is called at `now`, a `Time`. It gets the latest measurement, `range_m` [m], and its age at `now`, `age_ms` [ms] (an int).
# Return the `PointStamped` that a correct driver publishes.

# %% [markdown] lang="ko" name="e1-6"
# ## E1.6 · 좌표계와 측정 시각을 적으십시오 (3점)
#
# 소나(초음파 거리 센서)가 `sonar_frame`의 y 방향, 곧 로봇의 왼쪽을 봅니다. 함수는 `now`(`Time`)에 호출되고, 가장 최근의 측정값 `range_m`[m]와 그때 그 값의 나이 `age_ms`(정수, [ms])를 받습니다.
# 드라이버가 발행해야 할 `PointStamped`를 반환하십시오.


# %% name="e1-6-answer" tags=["answer"]
def as_message(range_m, now, age_ms):
    """Return what was measured, as a PointStamped."""
    # BEGIN SOLUTION
    message = PointStamped()
    message.header.frame_id = "sonar_frame"
    message.header.stamp = (now - Duration(nanoseconds=age_ms * 1_000_000)).to_msg()
    message.point.y = range_m
    return message
    # END SOLUTION


# %% name="e1-6-check" tags=["check"]
check("E1.6", as_message)

# %% [markdown] lang="en" name="e1-7"
# ## E1.7 · Four detectors, one correct (3 points)
#
# A robot drives straight along the map's x at `speed_mps`. One ball lies at rest in front of it. Four detectors detect it; each of them takes 0.2 s for an image.
# `heard` contains five messages of each: (arrival [s], stamp [s], frame, x [m]).
# For each detector, choose a finding: `"honest"` (correct), `"stamp is the arrival"`, `"no stamp"` or `"wrong label"` (a wrong frame name).

# %% [markdown] lang="ko" name="e1-7"
# ## E1.7 · 검출기 넷, 바른 것은 하나 (3점)
#
# 로봇이 지도의 x 방향으로 `speed_mps`로 곧장 달리고, 앞에는 공이 가만히 놓여 있습니다. 검출기 네 개가 공을 봅니다. 영상 한 장을 처리하는 데 모두 0.2초가 걸립니다.
# `heard`에는 검출기마다 다섯 줄이 있습니다. 한 줄은 (도착 시각[s], 측정 시각[s], 좌표계, x[m])입니다.
#
# 각각 `"honest"`(바름), `"stamp is the arrival"`(도착 시각을 적음), `"no stamp"`(측정 시각 없음), `"wrong label"`(좌표계 이름이 틀림) 가운데 하나로 답하십시오.

# %% name="e1-7-given"
e1_7 = task("E1.7")

# %% name="e1-7-answer" tags=["answer"]
# BEGIN SOLUTION
_found = {}
for name, [(arrival, stamp, frame, x_m), *_, last] in e1_7.heard.items():
    labelled = "wrong label" if frame == "map" and x_m - last[3] > 0.1 else "honest"
    stamped = "stamp is the arrival" if stamp == arrival else labelled
    _found[name] = "no stamp" if stamp == 0.0 else stamped
# END SOLUTION
findings = {
    # BEGIN SOLUTION
    "red": _found["red"],
    "green": _found["green"],
    "blue": _found["blue"],
    "grey": _found["grey"],
    # END SOLUTION
}

# %% name="e1-7-check" tags=["check"]
check("E1.7", findings)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading asks the same questions with other numbers.
# On a robot, try `ros2 topic echo --once --field header` on every topic that you want to use: are frame and stamp there, and are they right?
#
# **Next:** [02 Axes and quaternions](../../notebooks/en/02_axes_and_quaternions.ipynb).

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기서 check는 여러분에게 주어진 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서는 쓰려는 토픽마다 `ros2 topic echo --once --field header`를 실행해 보세요. 좌표계와 측정 시각이 모두 있습니까? 값이 맞습니까?
#
# **다음:** [02 좌표축과 쿼터니언](../../notebooks/ko/02_axes_and_quaternions.ipynb)
