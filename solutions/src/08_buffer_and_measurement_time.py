# %% [markdown] lang="en" name="title"
# # Exercises 08 · Buffer and measurement time
#
# Seven tasks, 22 points, about 60 minutes. The page they belong to: [08 · Buffer and measurement time](../../notebooks/en/08_buffer_and_measurement_time.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E8.1")` gives the first of three hints.
# Your numbers come from `task(...)` and may differ from your neighbour's, so answer with an expression, such as `e8_1.clock_s - 1.0`, and not with a number that you calculated elsewhere.
# After a pass, or three tries, `solution("E8.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 08 · 버퍼와 측정 시각
#
# 과제 일곱 개, 22점, 약 60분입니다. 함께 보는 페이지: [08 · 버퍼와 측정 시각](../../notebooks/ko/08_buffer_and_measurement_time.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E8.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E8.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다. 그러니 따로 계산한 숫자가 아니라 `e8_1.clock_s - 1.0` 같은 식으로 답해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math

from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_geometry_msgs import do_transform_point
from tf2_ros import Buffer, ExtrapolationException, TransformException

# %% [markdown] lang="en" name="e8-1"
# ## E8.1 · How fresh is "latest"? (2 points)
#
# A buffer has the timelines below. `oldest_s` and `newest_s` contain, for each dynamic edge, the stamps of its first and its last sample; the edges in `static` were sent once, long ago.
# The current time is `clock_s`.
#
# You call `lookup_transform('map', 'laser_frame', Time())`. Which stamp [s] does the returned transform have?

# %% [markdown] lang="ko" name="e8-1"
# ## E8.1 · “최신”은 언제의 것입니까? (2점)
#
# 버퍼에 아래의 시간줄이 있습니다. `oldest_s`와 `newest_s`는 동적 연결마다 첫 표본과 마지막 표본의 측정 시각이고, `static`에 있는 연결은 오래전에 한 번 보낸 것입니다.
# 현재 시각은 `clock_s`입니다.
#
# 누군가 `lookup_transform('map', 'laser_frame', Time())`를 호출합니다. 어느 시각[s]의 변환이 나옵니까?

# %% name="e8-1-given"
e8_1 = task("E8.1")

# %% name="e8-1-answer" tags=["answer"]
# BEGIN SOLUTION
latest_common_s = min(e8_1.newest_s["map -> odom"], e8_1.newest_s["odom -> base_link"])  # [s]
# END SOLUTION

# %% name="e8-1-check" tags=["check"]
check("E8.1", latest_common_s)

# %% [markdown] lang="en" name="e8-2"
# ## E8.2 · Between two samples (4 points)
#
# Write a function that does what the buffer does between two samples of one edge, in the plane.
# A sample is a tuple `(stamp_s, x, y, yaw)` in seconds, metres and radians.
#
# Return a dict: `"position"` is `(x, y)` on the straight line, `"yaw"` is on the shortest arc.
# If `stamp_s` is before the first sample or after the second, raise `ExtrapolationException`: a buffer never guesses.

# %% [markdown] lang="ko" name="e8-2"
# ## E8.2 · 두 표본 사이 (4점)
#
# 버퍼는 한 연결의 두 표본 사이를 보간합니다. 바닥 위의 2차원에서 같은 계산을 하는 함수를 작성하십시오.
# 표본은 `(stamp_s, x, y, yaw)` tuple이고 단위는 초, m, rad입니다.
#
# dict를 반환합니다. `"position"`은 직선 위의 `(x, y)`, `"yaw"`는 가장 짧은 호 위의 각도입니다.
# `stamp_s`가 첫 표본 이전이거나 둘째 표본 이후이면 `ExtrapolationException`을 일으키십시오. 버퍼는 결코 짐작하지 않습니다.


# %% name="e8-2-answer" tags=["answer"]
def interpolate(stamp_s, before, after):
    """Return {"position": (x, y), "yaw": yaw} at stamp_s, between two samples (stamp_s, x, y, yaw)."""
    # BEGIN SOLUTION
    (t0, x0, y0, yaw0), (t1, x1, y1, yaw1) = before, after
    if not t0 <= stamp_s <= t1:
        raise ExtrapolationException(f"asked for {stamp_s}, have {t0} to {t1}")
    ratio = (stamp_s - t0) / (t1 - t0)
    turn = math.remainder(yaw1 - yaw0, math.tau)  # the short way round, -pi to pi
    return {"position": (x0 + ratio * (x1 - x0), y0 + ratio * (y1 - y0)), "yaw": yaw0 + ratio * turn}
    # END SOLUTION


# %% name="e8-2-check" tags=["check"]
check("E8.2", interpolate)

# %% [markdown] lang="en" name="e8-3"
# ## E8.3 · PointToMap: a point onto the map (4 points)
#
# Write the main part of the lecture's node as a function. It takes a `tf2_ros.Buffer`, a `PointStamped`, and `now`, the time at which the message arrived.
#
# Return the point in `map`, as a `PointStamped` that keeps the stamp of the measurement.
# If the buffer has no answer for that time, let its exception through: the caller decides what to do.
# You do not need all three arguments.

# %% [markdown] lang="ko" name="e8-3"
# ## E8.3 · PointToMap: 점을 지도 위로 (4점)
#
# 본문의 노드 `PointToMap`의 핵심을 함수로 작성합니다. `tf2_ros.Buffer`, `PointStamped`, 그리고 메시지가 도착한 시각 `now`를 받습니다.
# `map` 기준의 점을 `PointStamped`로 반환하되, 언제 측정했는지가 그대로 남아 있어야 합니다.
# 버퍼에 그 시각의 값이 없으면 예외를 그대로 내보내십시오. 어떻게 할지는 호출한 쪽이 정합니다.
#
# 세 인자 가운데 하나는 쓰지 않아야 합니다.


# %% name="e8-3-answer" tags=["answer"]
def point_to_map(buffer, message, now):
    """Return `message`, a PointStamped, expressed in map at the moment it was measured."""
    # BEGIN SOLUTION
    return buffer.transform(message, "map")
    # END SOLUTION


# %% name="e8-3-check" tags=["check"]
check("E8.3", point_to_map)

# %% [markdown] lang="en" name="e8-4"
# ## E8.4 · How far off? (3 points)
#
# A robot drives and turns as below, and detects an object straight ahead, `range_m` away.
# `delay_ms` later a node transforms the detection with the *current* pose. (Check the units: the data sheets were written by different people.)
#
# Estimate the error with the two products of the page, x forward and y left, relative to the robot at the stamp:
# `"forwards_m"` and `"left_m"`, with their signs, and `"together_m"`, the length of the whole error.

# %% [markdown] lang="ko" name="e8-4"
# ## E8.4 · 얼마나 빗나갑니까? (3점)
#
# 로봇이 아래처럼 달리고 회전하면서 정면 `range_m` 앞의 물체를 봅니다.
# `delay_ms` 뒤에 누군가 *지금*의 포즈로 그 관측을 지도 기준으로 바꿉니다. (단위에 주의하십시오. 데이터시트마다 단위가 다릅니다.)
#
# 본문에 나온 두 성분의 식으로 오차를 어림하십시오. 측정 시각의 로봇을 기준으로 x는 앞, y는 왼쪽입니다.
# `"forwards_m"`과 `"left_m"`은 부호를 붙여서, `"together_m"`은 둘을 합친 길이로 답합니다.

# %% name="e8-4-given"
e8_4 = task("E8.4")

# %% name="e8-4-answer" tags=["answer"]
# BEGIN SOLUTION
delay_s = e8_4.delay_ms / 1000.0
forwards_m = e8_4.speed_mps * delay_s
left_m = e8_4.range_m * math.radians(e8_4.yaw_rate_degps) * delay_s
together_m = math.hypot(forwards_m, left_m)
# END SOLUTION
late_error = {"forwards_m": forwards_m, "left_m": left_m, "together_m": together_m}

# %% name="e8-4-check" tags=["check"]
check("E8.4", late_error)

# %% [markdown] lang="en" name="e8-5"
# ## E8.5 · Six symptoms (3 points)
#
# Name the likeliest cause of each. The causes:
# `"stamp overwritten"`, `"odometry slow"`, `"static mount wrong"`, `"two clocks"`, `"cache too short"`, `"import missing"`.
#
# - **a** While the robot turns, the walls swing. When it stands still, they are right. `ros2 topic delay /scan` prints 0.000 s, although a filter before it takes 0.3 s.
# - **b** The scan is 5 cm beside the wall, in motion or at rest, always on the same side of the robot.
# - **c** `Lookup would require extrapolation into the future.  Requested time 1763000012.400000 but the latest data is at time 12.350000, …`
# - **d** `Lookup would require extrapolation into the past.  Requested time 41.300000 but the earliest data is at time 42.900000, …`, from a detector that takes 12 s.
# - **e** About three of four points are rejected: `… into the future …`, always by less than a second. `view_frames` shows a rate of 1.0 for one edge, and `ros2 topic hz` prints 30 for the camera.
# - **f** The node stops with a traceback, although every lookup is inside `try … except TransformException`.

# %% [markdown] lang="ko" name="e8-5"
# ## E8.5 · 여섯 가지 증상 (3점)
#
# 증상마다 가장 그럴듯한 원인을 고르십시오. 원인은 다음과 같습니다.
# `"stamp overwritten"`(측정 시각을 덮어씀), `"odometry slow"`(오도메트리의 발행률이 낮음), `"static mount wrong"`(정적 장착 변환이 틀림), `"two clocks"`(시계가 둘), `"cache too short"`(보관 시간이 짧음), `"import missing"`(import를 빠뜨림).
#
# - **a** 로봇이 회전하는 동안 벽이 흔들립니다. 서 있으면 또렷합니다. 앞단의 필터가 0.3초 걸리는데도 `ros2 topic delay /scan`은 0.000초를 출력합니다.
# - **b** 달리든 서 있든 스캔이 벽에서 5 cm 옆에, 언제나 로봇의 같은 쪽에 그려집니다.
# - **c** `Lookup would require extrapolation into the future.  Requested time 1763000012.400000 but the latest data is at time 12.350000, …`
# - **d** 12초 동안 계산하는 검출기에서 `Lookup would require extrapolation into the past.  Requested time 41.300000 but the earliest data is at time 42.900000, …`
# - **e** 점 넷 가운데 셋쯤이 `… into the future …`로 거절되며, 모자라는 시간은 언제나 1초 미만입니다. `view_frames`는 어느 연결의 발행률을 1.0으로 보여 주고, `ros2 topic hz`로 본 카메라의 발행률은 30입니다.
# - **f** 조회가 모두 `try … except TransformException` 안에 있는데도 노드가 traceback을 남기고 멈춥니다.

# %% name="e8-5-answer" tags=["answer"]
causes = {
    # BEGIN SOLUTION
    "a": "stamp overwritten",
    "b": "static mount wrong",
    "c": "two clocks",
    "d": "cache too short",
    "e": "odometry slow",
    "f": "import missing",
    # END SOLUTION
}

# %% name="e8-5-check" tags=["check"]
check("E8.5", causes)

# %% [markdown] lang="en" name="e8-6"
# ## E8.6 · How long must it remember? (2 points)
#
# A detector computes for `thinking_s` before it looks up the transform at the image's stamp.
# Each transform on the path is published at `rate_hz`, immediately after it is measured.
# By the rule of the page, what is the smallest `cache_time` [s] that is enough for every image, wherever its stamp is between two samples?

# %% [markdown] lang="ko" name="e8-6"
# ## E8.6 · 얼마나 오래 기억해야 합니까? (2점)
#
# 검출기는 `thinking_s` 동안 계산한 뒤 영상의 측정 시각으로 변환을 조회합니다.
# 경로의 연결은 각각 `rate_hz`로 발행되며, 측정하는 즉시 보냅니다.
# 본문의 규칙을 쓰십시오. 측정 시각이 두 표본 사이 어디에 있든 모든 영상에 충분한 `cache_time`[s] 가운데 가장 작은 값은 얼마입니까?

# %% name="e8-6-given"
e8_6 = task("E8.6")

# %% name="e8-6-answer" tags=["answer"]
# BEGIN SOLUTION
cache_time_s = e8_6.thinking_s + 1.0 / min(e8_6.rate_hz.values())  # [s]
# END SOLUTION

# %% name="e8-6-check" tags=["check"]
check("E8.6", cache_time_s)

# %% [markdown] lang="en" name="e8-7"
# ## E8.7 · Where is it now? (4 points)
#
# The message contains the position of an object, in some sensor's frame, at its stamp. The object is at rest; the robot drove on.
# Return its coordinates `(x, y, z)` in `base_link` at `now`, with `odom` as the fixed frame.

# %% [markdown] lang="ko" name="e8-7"
# ## E8.7 · 지금은 어디에 있습니까? (4점)
#
# 메시지에는 측정 시각에 센서의 좌표계를 기준으로 잰 물체의 위치가 들어 있습니다. 물체는 가만히 있고 로봇은 계속 달렸습니다.
# `now` 시각의 `base_link` 기준으로 물체의 좌표 `(x, y, z)`를 반환하십시오. 가만히 있는 좌표계는 `odom`입니다.


# %% name="e8-7-answer" tags=["answer"]
def object_now(buffer, message, now):
    """Return (x, y, z) of a resting object in base_link at `now`; `message`, a PointStamped, saw it earlier."""
    # BEGIN SOLUTION
    stamp = Time.from_msg(message.header.stamp)
    now_T_then = buffer.lookup_transform_full("base_link", now, message.header.frame_id, stamp, "odom")
    point = do_transform_point(message, now_T_then).point
    return (point.x, point.y, point.z)
    # END SOLUTION


# %% name="e8-7-check" tags=["check"]
check("E8.7", object_now)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading asks the same questions with other numbers.
# On a robot, do C8 and C9 of the checklist that `tflab progress` shows once more: run `point_to_map.py`, and look at `ros2 topic delay` of each sensor that you use.
#
# **Next:** [09 · Exceptions and waiting](../../notebooks/en/09_exceptions_and_waiting.ipynb).

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기의 check는 여러분의 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서 실습 체크리스트 C8과 C9를 한 번 더 해 보세요. `point_to_map.py`를 실행하고, 실제로 쓰는 센서마다 `ros2 topic delay`를 확인해 보세요.
#
# **다음:** [09 · 예외와 기다림](../../notebooks/ko/09_exceptions_and_waiting.ipynb).
