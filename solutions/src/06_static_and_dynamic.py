# %% [markdown] lang="en" name="title"
# # Exercises 06 · Static and dynamic
#
# Seven tasks, 27 points, about 70 minutes. The page they belong to: [06 · Static and dynamic](../../notebooks/en/06_static_and_dynamic.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E6.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E6.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# Your numbers come from `task(...)` and may differ from your neighbour's, so answer with an expression, such as `e6_6.speed_mps * 2`, and not with a number that you calculated elsewhere.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 06 · 정적 변환과 동적 변환
#
# 과제 일곱 개, 27점, 약 70분입니다. 함께 보는 페이지: [06 · 정적 변환과 동적 변환](../../notebooks/ko/06_static_and_dynamic.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E6.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E6.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다. 그러니 따로 계산한 숫자가 아니라 `e6_6.speed_mps * 2` 같은 식으로 답해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math

from geometry_msgs.msg import TransformStamped

from tflab.core import Transform

# %% [markdown] lang="en" name="e6-1"
# ## E6.1 · Board or radio? (4 points)
#
# Four robots have three edges each. For each robot give a list of three topics, in the order of its edges: `"/tf_static"` (the notice board of the page) or `"/tf"` (the radio).
#
# - **cart**, parked since yesterday: `odom → base_link` from its wheels · `base_link → laser_frame`, screwed on · `map → odom`, corrected once in a while
# - **scout**: `base_link → imu_link`, screwed on · `base_link → ramp_link`, a loading ramp that a person folds down twice a day · `camera_link → camera_optical_frame`
# - **arm**: `base_link → shoulder_link`, a joint that has been held for an hour · `wrist_link → tool0`, the flange at its end · `tool0 → tcp`, a pen taped onto it, measured once
# - **drone**: `odom → base_link` · `base_link → gimbal_link`, which keeps the image steady · `gimbal_link → camera_link`, screwed on

# %% [markdown] lang="ko" name="e6-1"
# ## E6.1 · `/tf_static`입니까, `/tf`입니까? (4점)
#
# 로봇 네 대에 연결이 세 개씩 있습니다. 로봇마다 아래 순서대로 `"/tf_static"` 또는 `"/tf"`를 세 개 적은 리스트로 답하십시오.
#
# - **cart**, 어제부터 주차 중: 바퀴 오도메트리의 `odom → base_link` · 나사로 고정한 `base_link → laser_frame` · 가끔 보정되는 `map → odom`
# - **scout**: 나사로 고정한 `base_link → imu_link` · 사람이 하루에 두 번 펼치는 적재 경사판 `base_link → ramp_link` · `camera_link → camera_optical_frame`
# - **arm**: 한 시간째 붙잡고 있는 관절 `base_link → shoulder_link` · 손목 끝의 플랜지 `wrist_link → tool0` · 플랜지에 테이프로 붙이고 위치를 한 번 잰 펜 `tool0 → tcp`
# - **drone**: `odom → base_link` · 영상이 흔들리지 않게 하는 `base_link → gimbal_link` · 나사로 고정한 `gimbal_link → camera_link`

# %% name="e6-1-answer" tags=["answer"]
topics = {
    # BEGIN SOLUTION
    "cart": ["/tf", "/tf_static", "/tf"],
    "scout": ["/tf_static", "/tf", "/tf_static"],
    "arm": ["/tf", "/tf_static", "/tf_static"],
    "drone": ["/tf", "/tf", "/tf_static"],
    # END SOLUTION
}

# %% name="e6-1-check" tags=["check"]
check("E6.1", topics)

# %% [markdown] lang="en" name="e6-2"
# ## E6.2 · A mount on the command line (3 points)
#
# The sensor `e6_2.child` is mounted on `base_link`: `ahead_cm` centimetres ahead, `right_cm` **to its right**, `up_cm` up, and rotated to the left by `turn_left_deg` degrees.
# Write the line that publishes this, with `ros2 run tf2_ros static_transform_publisher`.

# %% [markdown] lang="ko" name="e6-2"
# ## E6.2 · 명령줄로 장착 변환 발행하기 (3점)
#
# 센서 `e6_2.child`를 `base_link`에 고정했습니다. 앞으로 `ahead_cm`센티미터, **오른쪽으로** `right_cm`센티미터, 위로 `up_cm`센티미터이고, 왼쪽으로 `turn_left_deg`°만큼 회전해 있습니다.
# 이 변환을 발행하는 명령 한 줄을 `ros2 run tf2_ros static_transform_publisher`로 쓰십시오.

# %% name="e6-2-given"
e6_2 = task("E6.2")

# %% name="e6-2-answer" tags=["answer"]
# BEGIN SOLUTION
command = (
    "ros2 run tf2_ros static_transform_publisher"
    f" --x {e6_2.ahead_cm / 100} --y {-e6_2.right_cm / 100} --z {e6_2.up_cm / 100}"
    f" --yaw {math.radians(e6_2.turn_left_deg)} --frame-id base_link --child-frame-id {e6_2.child}"
)
# END SOLUTION

# %% name="e6-2-check" tags=["check"]
check("E6.2", command)

# %% [markdown] lang="en" name="e6-3"
# ## E6.3 · One message for all mounts (4 points)
#
# `mounts` is a list of one to four rows such as `{"parent": "base_link", "child": "imu_link", "xyz": [0.1, 0.0, 0.2], "rpy": [0.0, 0.0, 1.57]}`, in metres and radians. `stamp` has the type of `header.stamp`.
# Return the list of `TransformStamped` for **one** `sendTransform`: one message for each row, in the order of the rows, each with `header.stamp = stamp`.
# `Transform.from_rpy(roll=…, pitch=…, yaw=…).rotation` is a quaternion (x, y, z, w).

# %% [markdown] lang="ko" name="e6-3"
# ## E6.3 · 모든 장착 변환을 메시지 하나에 (4점)
#
# `mounts`는 `{"parent": "base_link", "child": "imu_link", "xyz": [0.1, 0.0, 0.2], "rpy": [0.0, 0.0, 1.57]}` 같은 행이 한 개에서 네 개 담긴 리스트이고 단위는 m와 rad입니다. `stamp`는 메시지의 시각입니다.
# `sendTransform`을 **한 번** 호출할 때 넘길 `TransformStamped`의 리스트를 반환하십시오. 행의 순서대로 행마다 메시지를 하나씩 만들고, `header.stamp`에는 모두 `stamp`를 넣습니다.
# `Transform.from_rpy(roll=…, pitch=…, yaw=…).rotation`은 쿼터니언 (x, y, z, w)입니다.


# %% name="e6-3-answer" tags=["answer"]
def letter(mounts, stamp):
    """Return the list of TransformStamped that holds all mounts."""
    # BEGIN SOLUTION
    messages = []
    for mount in mounts:
        t = TransformStamped()
        t.header.stamp = stamp
        t.header.frame_id, t.child_frame_id = mount["parent"], mount["child"]
        step, turn = t.transform.translation, t.transform.rotation
        step.x, step.y, step.z = mount["xyz"]
        roll, pitch, yaw = mount["rpy"]
        turn.x, turn.y, turn.z, turn.w = Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw).rotation
        messages.append(t)
    return messages
    # END SOLUTION


# %% name="e6-3-check" tags=["check"]
check("E6.3", letter)

# %% [markdown] lang="en" name="e6-4"
# ## E6.4 · A circle that drives forward (4 points)
#
# A robot drives a circle about the origin of the frame `odom`, at `speed_mps`, and it drives **forward**. At `elapsed_s` = 0 it is at (`radius_m`, 0). If `is_left`, it turns to the left, else to the right.
# `odom` and `base` are the names of the two frames. Return the `TransformStamped` of `base` in `odom` after `elapsed_s`; leave the stamp as it is.

# %% [markdown] lang="ko" name="e6-4"
# ## E6.4 · 앞으로 달리는 원 (4점)
#
# 로봇이 좌표계 `odom`의 원점을 중심으로 원을 그리며 `speed_mps`로 **앞으로** 달립니다. `elapsed_s`가 0일 때 (`radius_m`, 0)에 있습니다. `is_left`이면 왼쪽으로, 아니면 오른쪽으로 돕니다.
# `odom`과 `base`는 두 좌표계의 이름입니다. `elapsed_s`초 뒤 `odom` 기준 `base`의 `TransformStamped`를 반환하십시오. 시각(stamp)은 그대로 둡니다.


# %% name="e6-4-answer" tags=["answer"]
def on_circle(elapsed_s, radius_m, speed_mps, is_left, odom, base):
    """Return the TransformStamped of base in odom."""
    t = TransformStamped()
    # BEGIN SOLUTION
    side = 1.0 if is_left else -1.0
    theta = side * speed_mps / radius_m * elapsed_s
    yaw = theta + side * math.pi / 2
    t.header.frame_id, t.child_frame_id = odom, base
    t.transform.translation.x = radius_m * math.cos(theta)
    t.transform.translation.y = radius_m * math.sin(theta)
    t.transform.rotation.z = math.sin(yaw / 2)
    t.transform.rotation.w = math.cos(yaw / 2)
    # END SOLUTION
    return t


# %% name="e6-4-check" tags=["check"]
check("E6.4", on_circle)

# %% [markdown] lang="en" name="e6-5"
# ## E6.5 · Six extracts from a log (5 points)
#
# The next cell prints what was found on each of six robots, a to f. For each give the cause, and under `"a do"` to `"f do"` what to do. Causes:
#
# - `"several messages"`: one node sent them one after the other
# - `"publisher gone"`: the node has ended
# - `"no board"`: the publisher is VOLATILE
# - `"moving frame not sent"`: the frame can move and is no longer published
# - `"mount on /tf"`: a fixed mount is sent on `/tf`
# - `"moving frame on /tf_static"`: a frame that moves is sent on `/tf_static`
# - `"misspelt name"`
#
# What to do:
#
# `"send one list"` · `"keep it running"` · `"offer TRANSIENT_LOCAL"` · `"keep sending at rest"` · `"send it on /tf_static"` · `"send it on /tf"` · `"wait longer"` · `"send it faster"` · `"correct the name"`
#
# The answer cell defines a variable for each of these words. Use the variables: `"a": no_board`.

# %% [markdown] lang="ko" name="e6-5"
# ## E6.5 · 로그에서 뽑은 여섯 사례 (5점)
#
# 로봇 여섯 대에서 알아낸 것을 다음 셀이 보여 줍니다. a부터 f까지 원인을, `"a do"`부터 `"f do"`까지 할 일을 고르십시오. 원인:
#
# - `"several messages"` 한 노드가 메시지를 하나씩 따로 보냄
# - `"publisher gone"` 발행자가 끝남
# - `"no board"` 게시판이 없음(VOLATILE)
# - `"moving frame not sent"` 움직일 수 있는 것의 발행이 멈춤
# - `"mount on /tf"` 고정된 것을 /tf로 보냄
# - `"moving frame on /tf_static"` 움직이는 것을 /tf_static으로 보냄
# - `"misspelt name"` 이름의 철자가 틀림
#
# 할 일:
#
# - `"send one list"` 리스트 하나로 보내기
# - `"keep it running"` 계속 실행하기
# - `"offer TRANSIENT_LOCAL"` TRANSIENT_LOCAL 제공하기
# - `"keep sending at rest"` 멈춰 있는 동안에도 보내기
# - `"send it on /tf_static"`, `"send it on /tf"` 그 토픽으로 보내기
# - `"wait longer"` 더 기다리기 · `"send it faster"` 더 자주 보내기 · `"correct the name"` 이름 고치기
#
# 답 셀에는 이 문구들이 변수로 준비되어 있습니다. `"a": no_board`처럼 변수를 쓰십시오.

# %% name="e6-5-given"
e6_5 = task("E6.5")

# %% name="e6-5-answer" tags=["answer"]
several_messages, publisher_gone, no_board, misspelt_name = "several messages", "publisher gone", "no board", "misspelt name"
mount_on_tf, moving_frame_on_tf_static, moving_frame_not_sent = "mount on /tf", "moving frame on /tf_static", "moving frame not sent"
send_one_list, keep_it_running, offer_transient_local = "send one list", "keep it running", "offer TRANSIENT_LOCAL"
keep_sending_at_rest, send_it_on_tf_static, send_it_on_tf = "keep sending at rest", "send it on /tf_static", "send it on /tf"
wait_longer, send_it_faster, correct_the_name = "wait longer", "send it faster", "correct the name"
diagnosis = {
    # BEGIN SOLUTION
    "a": mount_on_tf, "a do": send_it_on_tf_static,
    "b": no_board, "b do": offer_transient_local,
    "c": moving_frame_on_tf_static, "c do": send_it_on_tf,
    "d": several_messages, "d do": send_one_list,
    "e": moving_frame_not_sent, "e do": keep_sending_at_rest,
    "f": publisher_gone, "f do": keep_it_running,
    # END SOLUTION
}

# %% name="e6-5-check" tags=["check"]
check("E6.5", diagnosis)

# %% [markdown] lang="en" name="e6-6"
# ## E6.6 · How far does a mount on /tf fall behind? (2 points)
#
# A mount is sent on `/tf`, `rate_hz` times a second, and each message takes `delay_ms` **milliseconds** to arrive. The odometry is published so often that it adds no error. The robot drives straight on at `speed_mps`.
# You use "the latest" position of the sensor in `odom` as its current position. How large is the error at worst [m]?

# %% [markdown] lang="ko" name="e6-6"
# ## E6.6 · 장착 변환은 얼마나 뒤처질까요? (2점)
#
# 장착 변환을 `/tf`로 1초에 `rate_hz`번 보내고, 메시지가 도착하는 데 `delay_ms`**밀리초**가 걸립니다. 바퀴 오도메트리의 지연은 무시해도 됩니다. 로봇은 `speed_mps`로 곧게 달립니다.
# 누군가 `odom` 기준으로 조회한 센서의 “최신” 위치를 지금의 위치로 여깁니다. 최악의 경우 얼마나 빗나갑니까[m]?

# %% name="e6-6-given"
e6_6 = task("E6.6")

# %% name="e6-6-answer" tags=["answer"]
# BEGIN SOLUTION
worst_error_m = e6_6.speed_mps * (1 / e6_6.rate_hz + e6_6.delay_ms / 1000)
# END SOLUTION

# %% name="e6-6-check" tags=["check"]
check("E6.6", worst_error_m)

# %% [markdown] lang="en" name="e6-7"
# ## E6.7 · Which frames does the listener know? (5 points)
#
# `letters` contains all messages that were ever sent, in order of time: dicts with `node`, `topic` (`"/tf"` or `"/tf_static"`), `sent_s` and `children`, a list of names. `ends` maps the name of a node to the time at which it ended; a node that is not in it still runs.
# tf2's listener joins at `join_s`. Return the children that it has received by `now_s`, each once.
#
# It receives what is sent from `join_s` to `now_s`, both included. Every node on `/tf_static` has a board of depth 1, which holds the last message that the node sent on `/tf_static`. At `join_s` the listener reads what was sent to the boards *before* `join_s`, but only the boards of nodes that end *after* `join_s` or never.

# %% [markdown] lang="ko" name="e6-7"
# ## E6.7 · 수신기는 무엇을 받습니까? (5점)
#
# `letters`는 지금까지 보낸 모든 메시지를 시간순으로 담은 리스트입니다. 각각 `node`, `topic`(`"/tf"` 또는 `"/tf_static"`), `sent_s`, 이름의 리스트 `children`이 있는 dict입니다. `ends`는 노드 이름별로 끝난 시각이고, 여기에 없는 노드는 아직 실행 중입니다.
# tf2의 수신기가 `join_s`에 참가합니다. `now_s`에 이 수신기의 버퍼에 있는 자식 좌표계의 이름을 중복 없이 반환하십시오.
#
# `join_s`부터 `now_s`까지(양 끝 포함) 보낸 것은 받습니다. 그 *이전에* 보낸 것은 `join_s` *이후에* 끝나는 노드의 게시판에서 읽습니다. `/tf_static`으로 보내는 노드마다 depth가 1인 게시판이 있습니다.


# %% name="e6-7-answer" tags=["answer"]
def known(letters, ends, join_s, now_s):
    """Return the child frames that a listener which joined at join_s knows at now_s."""
    # BEGIN SOLUTION
    heard, boards = set(), {}
    for each in letters:
        if join_s <= each["sent_s"] <= now_s:
            heard.update(each["children"])
        elif each["topic"] == "/tf_static" and each["sent_s"] < join_s:
            boards[each["node"]] = each["children"]
    for node, children in boards.items():
        if ends.get(node, math.inf) > join_s:
            heard.update(children)
    return sorted(heard)
    # END SOLUTION


# %% name="e6-7-check" tags=["check"]
check("E6.7", known)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading asks the same questions with other numbers.
# On a robot, let `ros2 topic info /tf_static --verbose` list the boards, and stop one of their publishers: which listeners still have the frame?
#
# **Next:** [07 URDF and sensors](../../notebooks/en/07_urdf_and_sensors.ipynb).

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기의 check는 여러분의 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서는 `ros2 topic info /tf_static --verbose`로 게시판을 찾고, 발행자 하나를 멈춰 보세요. 그 좌표계는 어느 수신기에 아직 남아 있습니까?
#
# **다음:** [07 URDF와 센서](../../notebooks/ko/07_urdf_and_sensors.ipynb)
