# %% [markdown] lang="en" name="title"
# # Exercises 02 · Axes and quaternions
#
# Eight tasks, 24 points, about 45 minutes. The page of this chapter is [here](../../notebooks/en/02_axes_and_quaternions.ipynb).
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E2.1")` gives the first of three hints.
#
# Have your right hand ready.
# After a pass, or three tries, `solution("E2.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 02 · 좌표축과 쿼터니언
#
# 과제 여덟 개, 24점, 약 45분입니다. 이 장의 본문은 [여기](../../notebooks/ko/02_axes_and_quaternions.ipynb)에 있습니다.
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E2.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E2.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
#
# 오른손을 준비해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math

import numpy as np
from tflab.core import Transform

# %% [markdown] lang="en" name="e2-1"
# ## E2.1 · Say the sign (3 points)
#
# Is each of these numbers `"positive"` or `"negative"`? Use your hand first, then write.
#
# 1. The `angular.z` that makes a robot turn left.
# 2. The pitch of a robot whose nose looks down.
# 3. The y of a post on the robot's right, in `base_link`.
# 4. The x of the same post, in `camera_optical_frame`. The camera looks ahead.
# 5. The y of a lamp that hangs higher than the camera, in `camera_optical_frame`.

# %% [markdown] lang="ko" name="e2-1"
# ## E2.1 · 부호를 말하십시오 (3점)
#
# 다음 숫자는 각각 `"positive"`(양수)입니까, `"negative"`(음수)입니까? 손으로 먼저 확인하고 나서 쓰십시오.
#
# 1. 로봇을 왼쪽으로 회전시키는 `angular.z`
# 2. 기수가 아래를 보는 로봇의 pitch
# 3. 로봇 오른쪽에 있는 기둥의 y, `base_link` 기준
# 4. 같은 기둥의 x, `camera_optical_frame` 기준. 카메라는 앞을 봅니다.
# 5. 카메라보다 높이 달린 전등의 y, `camera_optical_frame` 기준

# %% name="e2-1-answer" tags=["answer"]
signs = {
    # BEGIN SOLUTION
    "angular_z_turning_left": "positive",
    "pitch_nose_down": "positive",
    "y_right_in_base_link": "negative",
    "x_right_in_optical_frame": "positive",
    "y_above_in_optical_frame": "negative",
    # END SOLUTION
}

# %% name="e2-1-check" tags=["check"]
check("E2.1", signs)

# %% [markdown] lang="en" name="e2-2"
# ## E2.2 · From the optical frame to the camera (3 points)
#
# A detector reports a part in `camera_optical_frame` [m]. Where is it in `camera_link`?
# Predict first: is it left or right of the camera, above or below?

# %% [markdown] lang="ko" name="e2-2"
# ## E2.2 · 영상 기준의 점을 카메라 기준으로 (3점)
#
# 검출기가 부품의 위치를 `camera_optical_frame` 기준으로 알려 줍니다 [m]. `camera_link` 기준으로는 어디입니까?
#
# 먼저 예측하십시오. 카메라의 왼쪽입니까, 오른쪽입니까? 위입니까, 아래입니까?

# %% name="e2-2-given"
e2_2 = task("E2.2")

# %% name="e2-2-answer" tags=["answer"]
# BEGIN SOLUTION
camera_T_optical = Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)
camera_p_part = camera_T_optical.apply(e2_2.optical_p_part)  # (x, y, z) in camera_link [m]
# END SOLUTION

# %% name="e2-2-check" tags=["check"]
check("E2.2", camera_p_part)

# %% [markdown] lang="en" name="e2-3"
# ## E2.3 · The quaternion of a yaw (3 points)
#
# Write the function that every planar robot needs: convert a yaw in radians to a quaternion (x, y, z, w).
# No library, only `math`.

# %% [markdown] lang="ko" name="e2-3"
# ## E2.3 · yaw를 쿼터니언으로 (3점)
#
# 평면을 달리는 로봇이라면 꼭 필요한 함수를 만드십시오. 라디안으로 받은 yaw를 쿼터니언 (x, y, z, w)로 바꿉니다.
# 다른 라이브러리 없이 `math`만 씁니다.

# %% name="e2-3-answer" tags=["answer"]
def quaternion_from_yaw(yaw_rad):
    """Return (x, y, z, w) of a turn to the left by `yaw_rad`."""
    # BEGIN SOLUTION
    return (0.0, 0.0, math.sin(yaw_rad / 2), math.cos(yaw_rad / 2))
    # END SOLUTION

# %% name="e2-3-check" tags=["check"]
check("E2.3", quaternion_from_yaw)

# %% [markdown] lang="en" name="e2-4"
# ## E2.4 · Check a quaternion (4 points)
#
# A listener rejects only zeros and NaN. It accepts a wrong length, and w written first. So let your function check each quaternion that enters your program.
# The robot drives on a flat floor, so a good quaternion rotates only about z.
# Return the first verdict that fits, in this order:
#
# | verdict | when |
# |---|---|
# | `"nan"` | one of the four is not finite (NaN or infinite) |
# | `"zero"` | the length is zero (below 0.000001) |
# | `"not unit"` | the length differs from 1 by more than 0.01 |
# | `"w first"` | the absolute value of x or y is larger than 0.1: the robot drives on a flat floor, so this means that w was written first |
# | `"ok"` | none of these |

# %% [markdown] lang="ko" name="e2-4"
# ## E2.4 · 쿼터니언 검문소 (4점)
#
# TF의 수신기는 모두 0이거나 NaN이 든 쿼터니언만 거절합니다. 길이가 틀리거나 w를 먼저 쓴 쿼터니언은 그대로 받습니다. 여러분은 데이터가 들어오는 곳에서 바로 가려내십시오.
# 로봇은 평평한 바닥을 달리므로 올바른 쿼터니언은 z축을 중심으로만 회전합니다.
# 표의 순서대로 확인하고, 처음 해당하는 판정을 반환하십시오.
#
# | 판정 | 조건 |
# |---|---|
# | `"nan"` | 숫자 네 개 가운데 하나라도 유한하지 않음(NaN 또는 무한대) |
# | `"zero"` | 길이가 0임(0.000001 미만) |
# | `"not unit"` | 길이가 1에서 0.01보다 더 벗어남 |
# | `"w first"` | x나 y의 크기가 0.1보다 큼: 평평한 바닥이라면 누군가 w를 먼저 쓴 것입니다 |
# | `"ok"` | 어느 것도 아님 |

# %% name="e2-4-answer" tags=["answer"]
def judge_quaternion(q):
    """Return the verdict on `q`, four numbers (x, y, z, w)."""
    x, y, z, w = q
    # BEGIN SOLUTION
    if not all(math.isfinite(part) for part in q):
        return "nan"
    length = math.hypot(*q)
    if length < 1e-6:
        return "zero"
    if abs(length - 1.0) > 0.01:
        return "not unit"
    return "w first" if max(abs(x), abs(y)) > 0.1 else "ok"
    # END SOLUTION

# %% name="e2-4-check" tags=["check"]
check("E2.4", judge_quaternion)

# %% [markdown] lang="en" name="e2-5"
# ## E2.5 · First the yaw, then the pitch (3 points)
#
# A sensor is on a bench, aligned with the robot. You rotate it **first** by a yaw about the robot's z, **then** by a pitch about the robot's y. Both axes are fixed to the robot.
# What is the sensor's rotation in the robot's frame, as a quaternion (x, y, z, w)?

# %% [markdown] lang="ko" name="e2-5"
# ## E2.5 · 먼저 yaw, 다음에 pitch (3점)
#
# 작업대 위에 센서가 로봇과 축이 나란하게 놓여 있습니다. **먼저** 로봇의 z축을 중심으로 yaw만큼, **다음에** 로봇의 y축을 중심으로 pitch만큼 회전시킵니다. 두 축 모두 로봇에 고정되어 있습니다.
# 로봇 기준으로 센서의 회전을 쿼터니언 (x, y, z, w)로 쓰면 무엇입니까?

# %% name="e2-5-given"
e2_5 = task("E2.5")

# %% name="e2-5-answer" tags=["answer"]
# BEGIN SOLUTION
yaw = Transform.from_rpy(yaw=e2_5.first_yaw_rad)
pitch = Transform.from_rpy(pitch=e2_5.then_pitch_rad)
robot_q_sensor = (pitch @ yaw).rotation  # (x, y, z, w)
# END SOLUTION

# %% name="e2-5-check" tags=["check"]
check("E2.5", robot_q_sensor)

# %% [markdown] lang="en" name="e2-6"
# ## E2.6 · A cloud at ninety degrees (3 points)
#
# A depth camera looks straight ahead at a wall. Its cloud is right in its own optical axes, but wrong in RViz (Fixed Frame: `base_link`).
# Here is the evidence: the cloud's header, and the output of `tf2_echo` for the two mounts. One of the three is wrong.
#
# - `"wall_appears"`: where does the wall appear? `"ahead"`, `"above"`, `"left"` or `"right"`
# - `"fault"`: what is wrong? `"header"`, `"mount of camera_link"`, `"mount of camera_optical_frame"`, `"data"` or `"quaternion"`
# - `"change"`: where do you fix it? `"driver"`, `"URDF"` or `"my node"`

# %% [markdown] lang="ko" name="e2-6"
# ## E2.6 · 90° 회전한 클라우드 (3점)
#
# 깊이 카메라가 정면의 벽을 보고 있습니다. 클라우드의 숫자는 카메라의 광학 축 기준으로 올바르지만, RViz(고정 좌표계는 `base_link`)에서는 엉뚱한 곳에 놓입니다.
# 증거는 셋입니다. 클라우드의 헤더, 그리고 `tf2_echo`로 읽은 두 장착 변환입니다. 셋 중 하나가 잘못되어 있습니다.
#
# - `"wall_appears"`: 벽이 어디에 나타납니까? `"ahead"`(앞), `"above"`(위), `"left"`(왼쪽), `"right"`(오른쪽)
# - `"fault"`: 무엇이 잘못되었습니까? `"header"`(헤더), `"mount of camera_link"`, `"mount of camera_optical_frame"`(각 장착 변환), `"data"`(데이터), `"quaternion"`(쿼터니언)
# - `"change"`: 어디를 고칩니까? `"driver"`(드라이버), `"URDF"`, `"my node"`(내 노드)

# %% name="e2-6-given"
e2_6 = task("E2.6")

# %% name="e2-6-answer" tags=["answer"]
diagnosis = {
    # BEGIN SOLUTION
    "wall_appears": (
        "right" if e2_6.rpy_of_camera_link_in_base_link_deg[2]  # rotated twice
        else "left" if e2_6.rpy_of_camera_optical_frame_in_camera_link_deg == (-90.0, 0.0, 0.0)  # roll only
        else "above"
    ),
    "fault": (
        "header" if e2_6.header_frame_id == "camera_link"
        else "mount of camera_link" if any(e2_6.rpy_of_camera_link_in_base_link_deg)
        else "mount of camera_optical_frame"
    ),
    "change": "driver" if e2_6.header_frame_id == "camera_link" else "URDF",
    # END SOLUTION
}

# %% name="e2-6-check" tags=["check"]
check("E2.6", diagnosis)

# %% [markdown] lang="en" name="e2-7"
# ## E2.7 · A slightly wrong angle (2 points)
#
# A URDF should rotate a camera's mount by a yaw of π/2, and somebody wrote a slightly different number.
# A point is `range_m` metres ahead of the camera. By how many millimetres does the error move it sideways? Give a number without a sign, to the nearest millimetre or finer.

# %% [markdown] lang="ko" name="e2-7"
# ## E2.7 · 조금 틀린 각도 (2점)
#
# URDF에서 카메라를 yaw로 π/2만큼 회전시켜야 하는데, 누군가 조금 다른 숫자를 적었습니다.
# 과제에 주어진 거리에 있는 점은 옆으로 얼마나 어긋납니까 [mm]? 1 mm 또는 그보다 정밀하게, 부호 없이 답하십시오.

# %% name="e2-7-given"
e2_7 = task("E2.7")

# %% name="e2-7-answer" tags=["answer"]
# BEGIN SOLUTION
off_mm = 1000.0 * e2_7.range_m * abs(math.pi / 2 - e2_7.written_yaw_rad)  # [mm]
# END SOLUTION

# %% name="e2-7-check" tags=["check"]
check("E2.7", off_mm)

# %% [markdown] lang="en" name="e2-8"
# ## E2.8 · From a pixel to a point (3 points)
#
# A depth camera sees a part at the pixel (`u`, `v`). Its depth image has the value `depth_m` [m] there.
# `camera_info` has `fx`, `fy`, `cx` and `cy` [pixels]. `camera_link` is at `base_p_camera` [m] in `base_link` and is not rotated, so the camera looks straight ahead.
# `e2_8` has all these values, such as `e2_8.u`.
# Where is the part in `base_link`? Predict first: is it left or right of the camera, above or below?

# %% [markdown] lang="ko" name="e2-8"
# ## E2.8 · 픽셀에서 점으로 (3점)
#
# 깊이 카메라의 영상에서 부품이 픽셀 (`u`, `v`)에 보입니다. 깊이 영상의 이 픽셀에는 `depth_m` [m]이 들어 있습니다.
# `camera_info`에는 `fx`, `fy`, `cx`, `cy` [픽셀]가 들어 있습니다. `camera_link`는 `base_link` 기준 `base_p_camera` [m]에 회전 없이 달려 있어서, 카메라는 정면을 봅니다.
# 값은 모두 `e2_8.u`처럼 `e2_8`에 들어 있습니다.
# 부품은 `base_link` 기준으로 어디에 있습니까? 먼저 예측하십시오. 카메라의 왼쪽입니까, 오른쪽입니까? 위입니까, 아래입니까?

# %% name="e2-8-given"
e2_8 = task("E2.8")

# %% name="e2-8-answer" tags=["answer"]
# BEGIN SOLUTION
ray = ((e2_8.u - e2_8.cx) / e2_8.fx, (e2_8.v - e2_8.cy) / e2_8.fy, 1.0)
optical_p_part = [e2_8.depth_m * number for number in ray]
base_T_optical = Transform(e2_8.base_p_camera) @ Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)
base_p_part = base_T_optical.apply(optical_p_part)  # (x, y, z) in base_link [m]
# END SOLUTION

# %% name="e2-8-check" tags=["check"]
check("E2.8", base_p_part)

# %% [markdown] lang="en" name="end"
# ## Done
#
# Everything passed? Then run `hint("E2.2")` and ask yourself whether you could have written that hint.
# If you can help others with a mistake, you will not make it again.
#
# **Next:** [03 · Target and source](../../notebooks/en/03_target_and_source.ipynb).

# %% [markdown] lang="ko" name="end"
# ## 마쳤습니다
#
# 모두 통과했다면 한 가지만 더 해 보세요. `hint("E2.2")`를 실행하고, 자신도 그런 힌트를 쓸 수 있을지 생각해 보세요.
# 남의 실수를 바로잡아 줄 수 있으면 같은 실수를 하지 않습니다.
#
# **다음:** [03 · 목표 좌표계와 원본 좌표계](../../notebooks/ko/03_target_and_source.ipynb).
