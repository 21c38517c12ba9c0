# %% [markdown] lang="en" name="title" slide="slide"
# # Exercises 03 · Target and source
#
# Eight tasks, 29 points, about 50 minutes.
# The page they belong to: [03 · Target and source](../../notebooks/en/03_target_and_source.ipynb).
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake, and you can try again as often as you like.
# `hint("E3.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E3.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 연습 문제 03 · 목표 좌표계와 원본 좌표계
#
# 과제 여덟 개, 29점, 약 50분입니다.
# 본문은 여기에 있습니다: [03 · 목표 좌표계와 원본 좌표계](../../notebooks/ko/03_target_and_source.ipynb).
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E3.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E3.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math

from geometry_msgs.msg import TransformStamped

from tflab.core import Transform

# %% [markdown] lang="en" name="e3-1" slide="slide"
# ## E3.1 · Four sentences, four calls (4 points)
#
# Write the two frames of `lookup_transform(…, …, time)` for each, in the order of the call, as a pair of names such as `['odom', 'map']`.
#
# - **a** Obstacles come from the laser; draw them on the map.
# - **b** The goal is given in the map; the controller works in `base_link`.
# - **c** Where is `camera_link` on the robot, expressed in `base_link`?
# - **d** The laser's picture is drawn in `laser_frame`. Draw the origin of `base_link` into it.

# %% [markdown] lang="ko" name="e3-1" slide="slide"
# ## E3.1 · 문장 네 개, 호출 네 개 (4점)
#
# 각각 `lookup_transform(…, …, time)`에 들어갈 두 좌표계를 호출 순서대로, `['odom', 'map']`처럼 이름 한 쌍으로 쓰십시오.
#
# - **a** 레이저가 찾은 장애물을 지도에 칠합니다.
# - **b** 목적지는 지도 기준으로 주어지고, 제어기는 `base_link` 기준으로 계산합니다.
# - **c** `base_link`를 기준으로 `camera_link`는 어디에 있습니까?
# - **d** `laser_frame` 기준으로 그린 레이저 그림에 로봇의 중심을 표시합니다.

# %% name="e3-1-answer" tags=["answer"]
calls = {
    # BEGIN SOLUTION
    'a': ['map', 'laser_frame'],
    'b': ['base_link', 'map'],
    'c': ['base_link', 'camera_link'],
    'd': ['laser_frame', 'base_link'],
    # END SOLUTION
}

# %% name="e3-1-check" tags=["check"]
check("E3.1", calls)

# %% [markdown] lang="en" name="e3-2" slide="slide"
# ## E3.2 · A corner seen by a rotated laser (4 points)
#
# The laser is mounted rotated, and the robot is rotated in the map.
# The laser detects a corner at `laser_p_corner`.
# Where is the corner in `base_link`, and where in `map`?
#
# `e3_2.base_T_laser.apply(point)` transforms a point. `@` chains transforms that match.

# %% [markdown] lang="ko" name="e3-2" slide="slide"
# ## E3.2 · 회전시켜 장착한 레이저가 본 모서리 (4점)
#
# 레이저는 회전한 채 달려 있고, 로봇도 지도를 기준으로 회전해 있습니다.
# 레이저가 `laser_p_corner`에서 모서리를 봅니다.
# 모서리의 위치는 `base_link` 기준으로 어디이고, `map` 기준으로 어디입니까?
#
# `e3_2.base_T_laser.apply(점)`은 점의 좌표를 `base_link` 기준으로 바꾸고, `@`는 이웃한 이름이 같은 두 변환을 합성합니다.

# %% name="e3-2-given"
e3_2 = task("E3.2")

# %% name="e3-2-answer" tags=["answer"]
corner = {
    # BEGIN SOLUTION
    'base_link': e3_2.base_T_laser.apply(e3_2.laser_p_corner),  # (x, y, z) [m]
    'map': (e3_2.map_T_base @ e3_2.base_T_laser).apply(e3_2.laser_p_corner),  # (x, y, z) [m]
    # END SOLUTION
}

# %% name="e3-2-check" tags=["check"]
check("E3.2", corner)

# %% [markdown] lang="en" name="e3-3" slide="slide"
# ## E3.3 · The inverse (4 points)
#
# In the plane, the pose of b in a has three numbers: the position of b (`x`, `y`) and its rotation (`yaw`).
# Return the pose of **a in b**, in the same form.
# Use paper, `math.cos` and `math.sin`. You need no other library.
#
# One formula is all you need: (u, v), rotated by an angle α, is (u·cos α − v·sin α, u·sin α + v·cos α).

# %% [markdown] lang="ko" name="e3-3" slide="slide"
# ## E3.3 · 역변환 (4점)
#
# 평면에서 포즈는 숫자 세 개입니다. a를 기준으로 b가 어디에 있고(`x`, `y`) 얼마나 회전해 있는지(`yaw`)입니다.
# 같은 꼴로 **b를 기준으로 a가 어디에 있는지** 반환하십시오.
# 종이와 `math.cos`, `math.sin`이면 됩니다. 라이브러리는 필요 없습니다.
#
# 필요한 공식은 하나입니다. (u, v)를 각도 α만큼 회전시키면 (u·cos α − v·sin α, u·sin α + v·cos α)입니다.

# %% name="e3-3-answer" tags=["answer"]
def invert(a_pose_b):
    """Return b_pose_a, {'x': [m], 'y': [m], 'yaw': [rad]}, of a_pose_b."""
    # BEGIN SOLUTION
    yaw = -a_pose_b['yaw']  # the inverse rotation
    c, s = math.cos(yaw), math.sin(yaw)
    x, y = -a_pose_b['x'], -a_pose_b['y']  # the negated translation, rotated below
    return {'x': c * x - s * y, 'y': s * x + c * y, 'yaw': yaw}
    # END SOLUTION

# %% name="e3-3-check" tags=["check"]
check("E3.3", invert)

# %% [markdown] lang="en" name="e3-4" slide="slide"
# ## E3.4 · Two dominoes into one (4 points)
#
# `[a|b][b|c]` is `[a|c]`.
# You get the pose of b in a, and the pose of c in b. Return the pose of c in a.
# Poses and the formula are those of E3.3.

# %% [markdown] lang="ko" name="e3-4" slide="slide"
# ## E3.4 · 도미노 둘을 하나로 (4점)
#
# `[a|b][b|c]`는 `[a|c]`입니다.
# a 기준의 b와 b 기준의 c를 알 때, a를 기준으로 c가 어디에 있는지 반환하십시오.
# 포즈의 꼴과 공식은 E3.3과 같습니다.

# %% name="e3-4-answer" tags=["answer"]
def compose(a_pose_b, b_pose_c):
    """Return a_pose_c, {'x': [m], 'y': [m], 'yaw': [rad]}."""
    # BEGIN SOLUTION
    c, s = math.cos(a_pose_b['yaw']), math.sin(a_pose_b['yaw'])
    x, y = b_pose_c['x'], b_pose_c['y']
    return {
        'x': a_pose_b['x'] + c * x - s * y,
        'y': a_pose_b['y'] + s * x + c * y,
        'yaw': a_pose_b['yaw'] + b_pose_c['yaw'],
    }
    # END SOLUTION

# %% name="e3-4-check" tags=["check"]
check("E3.4", compose)

# %% [markdown] lang="en" name="e3-5" slide="slide"
# ## E3.5 · tf2_echo in both directions (3 points)
#
# This is what `ros2 run tf2_ros tf2_echo base_link laser_frame` printed on a robot.
# Read it, and say what it would print with the frames swapped.
# The first lines of the answer cell read the numbers for you, into `x`, `y`, `z` and `yaw`. You may also type them yourself.
#
# - `laser_in_base`: the position of the laser in `base_link`, (x, y, z) [m]
# - `base_in_laser`: the position of `base_link` in the laser's frame, (x, y, z) [m]
# - `yaw_back`: the yaw [rad] that `tf2_echo laser_frame base_link` prints

# %% [markdown] lang="ko" name="e3-5" slide="slide"
# ## E3.5 · tf2_echo를 두 방향으로 읽기 (3점)
#
# 어느 로봇에서 `ros2 run tf2_ros tf2_echo base_link laser_frame`을 실행했을 때의 출력입니다.
# 이것을 읽고, 목표와 원본을 바꾸어 조회하면 무엇이 나올지 답하십시오.
# 답 셀의 처음 몇 줄이 숫자를 읽어 `x`, `y`, `z`, `yaw`에 넣어 줍니다. 직접 옮겨 적어도 됩니다.
#
# - `laser_in_base`: `base_link`를 기준으로 레이저가 있는 자리, (x, y, z) [m]
# - `base_in_laser`: 레이저를 기준으로 `base_link`가 있는 자리, (x, y, z) [m]
# - `yaw_back`: `tf2_echo laser_frame base_link`가 출력할 yaw [rad]

# %% name="e3-5-given"
e3_5 = task("E3.5")

# %% name="e3-5-answer" tags=["answer"]
lines = [line.rstrip(']').split('[')[-1] for line in e3_5.echo.splitlines()]
x, y, z = map(float, lines[1].split(', '))  # Translation
roll, pitch, yaw = map(float, lines[3].split(', '))  # RPY (radian)
both_ways = {
    # BEGIN SOLUTION
    'laser_in_base': (x, y, z),
    'base_in_laser': Transform.from_rpy(yaw=yaw, translation=(x, y, z)).inverse().translation,
    'yaw_back': -yaw,
    # END SOLUTION
}

# %% name="e3-5-check" tags=["check"]
check("E3.5", both_ways)

# %% [markdown] lang="en" name="e3-6" slide="slide"
# ## E3.6 · Mount the camera (4 points)
#
# `camera_link` is mounted on `base_link`: `ahead_m` in front of its origin, `up_m` above it, and rotated to the left by `yaw_deg` **degrees**.
# Fill in the message that a static broadcaster would send. Leave the stamp as it is.

# %% [markdown] lang="ko" name="e3-6" slide="slide"
# ## E3.6 · 카메라 달기 (4점)
#
# `camera_link`를 `base_link`에 답니다. 중심에서 앞으로 `ahead_m`, 위로 `up_m`이고, 왼쪽으로 `yaw_deg`만큼 회전시켜 답니다. 각도의 단위는 **도**(degree)입니다.
# 정적 발행기가 보낼 메시지를 채우십시오. 시각(stamp)은 그대로 둡니다.

# %% name="e3-6-answer" tags=["answer"]
def camera_mount(ahead_m, up_m, yaw_deg):
    """Return the TransformStamped of camera_link on base_link."""
    t = TransformStamped()
    # BEGIN SOLUTION
    t.header.frame_id = 'base_link'
    t.child_frame_id = 'camera_link'
    t.transform.translation.x = float(ahead_m)
    t.transform.translation.z = float(up_m)
    half = math.radians(yaw_deg) / 2
    t.transform.rotation.z = math.sin(half)
    t.transform.rotation.w = math.cos(half)
    # END SOLUTION
    return t

# %% name="e3-6-check" tags=["check"]
check("E3.6", camera_mount)

# %% [markdown] lang="en" name="e3-7" slide="slide"
# ## E3.7 · Three nodes, one swap (3 points)
#
# One of three nodes has swapped target and source. No error was ever logged.
#
# ```python
# # node_a: stops for obstacles near the bumper, which is given in base_link
# t = buffer.lookup_transform('base_link', point.header.frame_id, point.header.stamp)
# near = do_transform_point(point, t).point
#
# # node_b: drives to a goal that is given in map; the controller works in base_link
# t = buffer.lookup_transform('map', 'base_link', Time())
# ahead = do_transform_point(goal, t).point
#
# # node_c: paints the robot on the map
# t = buffer.lookup_transform('map', 'base_link', Time())
# here = t.transform.translation
# ```
#
# - `node`: `"node_a"`, `"node_b"` or `"node_c"`
# - `robot`, what the robot of that node does: `"stops for the wrong things"`, `"is drawn where it is not"`, `"stops with an exception"` or `"drives to another place"`
# - `hidden_while`, when nobody would notice: `"it stands on the map's origin, not turned"`, `"it stands still"` or `"the goal is far away"`

# %% [markdown] lang="ko" name="e3-7" slide="slide"
# ## E3.7 · 노드 셋, 하나는 거꾸로 (3점)
#
# 세 노드 가운데 하나가 목표와 원본을 바꿔 썼습니다. 로그에는 오류가 하나도 없습니다.
#
# ```python
# # node_a: 장애물 앞에서 멈춥니다. 범퍼의 위치는 base_link 기준입니다
# t = buffer.lookup_transform('base_link', point.header.frame_id, point.header.stamp)
# near = do_transform_point(point, t).point
#
# # node_b: map 기준으로 주어진 목적지로 갑니다. 제어기는 base_link 기준으로 계산합니다
# t = buffer.lookup_transform('map', 'base_link', Time())
# ahead = do_transform_point(goal, t).point
#
# # node_c: 지도에 로봇을 그립니다
# t = buffer.lookup_transform('map', 'base_link', Time())
# here = t.transform.translation
# ```
#
# - `node`: `"node_a"`, `"node_b"`, `"node_c"` 가운데 하나
# - `robot`, 그 로봇이 하는 일: `"stops for the wrong things"`(엉뚱한 것에 멈춘다), `"is drawn where it is not"`(엉뚱한 자리에 그려진다), `"stops with an exception"`(예외로 멈춘다), `"drives to another place"`(다른 곳으로 간다) 가운데 하나
# - `hidden_while`, 문제가 드러나지 않는 때: `"it stands on the map's origin, not turned"`(지도 원점에 회전 없이 서 있는 동안), `"it stands still"`(서 있는 동안), `"the goal is far away"`(목적지가 멀리 있는 동안) 가운데 하나

# %% name="e3-7-answer" tags=["answer"]
verdict = {
    # BEGIN SOLUTION
    'node': 'node_b',
    'robot': 'drives to another place',
    'hidden_while': "it stands on the map's origin, not turned",
    # END SOLUTION
}

# %% name="e3-7-check" tags=["check"]
check("E3.7", verdict)

# %% [markdown] lang="en" name="e3-8" slide="slide"
# ## E3.8 · Rotation, translation, both or neither (3 points)
#
# Six values are measured in a sensor's frame, and you need them in `base_link`. The sensor is mounted away from the origin of `base_link`, and it is rotated. Which part of the transform changes each value? Choose `"both"`, `"rotation"` or `"neither"`.
#
# - **corner** the corner of a shelf, a point that the laser measured
# - **velocity** of a person who walks past
# - **gravity** the acceleration that the IMU measures while the robot stands still
# - **position** of a box, from a `PoseStamped`
# - **orientation** of the same box
# - **distance** between the box and the corner, one number in metres

# %% [markdown] lang="ko" name="e3-8" slide="slide"
# ## E3.8 · 회전, 이동, 둘 다, 둘 다 아님 (3점)
#
# 센서의 좌표계를 기준으로 측정한 값 여섯 개를 `base_link` 기준으로 바꾸려고 합니다. 센서는 `base_link`의 원점에서 떨어진 곳에 회전시켜 달았습니다. 값마다 변환의 어느 부분이 적용됩니까? `"both"`(둘 다), `"rotation"`(회전만), `"neither"`(둘 다 아님) 가운데 하나로 답하십시오.
#
# - **corner** 레이저가 측정한 점인 선반 모서리
# - **velocity** 지나가는 사람의 속도
# - **gravity** 로봇이 서 있는 동안 IMU가 측정한 가속도
# - **position** `PoseStamped`에 들어 있는 상자의 위치
# - **orientation** 같은 상자의 방향
# - **distance** 상자와 모서리 사이의 거리, 미터 단위인 숫자 하나

# %% name="e3-8-answer" tags=["answer"]
applies = {
    # BEGIN SOLUTION
    'corner': 'both',
    'velocity': 'rotation',
    'gravity': 'rotation',
    'position': 'both',
    'orientation': 'rotation',
    'distance': 'neither',
    # END SOLUTION
}

# %% name="e3-8-check" tags=["check"]
check("E3.8", applies)

# %% [markdown] lang="en" name="done" slide="slide"
# ## Done?
#
# On a robot, run `ros2 run tf2_ros tf2_echo base_link laser_frame`, and then with the frames swapped.
# Predict the second output before you look. That is line 2 of the checklist that `tflab progress` shows.
#
# **Next:** [04 · The tree of frames](../../notebooks/en/04_frame_tree.ipynb).

# %% [markdown] lang="ko" name="done" slide="slide"
# ## 다 했다면
#
# 로봇에서 `ros2 run tf2_ros tf2_echo base_link laser_frame`을 실행하고, 목표와 원본을 바꾸어서도 실행해 보세요.
# 두 번째 출력을 보기 전에 먼저 예측해 보세요. 실습 체크리스트(00장의 *나의 학습 현황*에 있습니다)의 둘째 줄입니다.
#
# **다음:** [04 · 좌표계 트리](../../notebooks/ko/04_frame_tree.ipynb).
