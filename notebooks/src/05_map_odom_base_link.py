# %% [markdown] lang="en" name="title" slide="slide"
# # 05 · map, odom, base_link
#
# **One may jump, one may drift** · about 25 minutes · builds on 03 and 04
#
# After this chapter you can
#
# - say which pose is smooth but drifts, which is accurate but jumps, and use each where it belongs,
# - compute what a localiser (a node that does [[localisation|localization]]) publishes: `map → odom`, from two poses of the same time,
# - explain why no node publishes `map → base_link`, and recognise a robot on which one does,
# - project a tilted robot onto the floor: `base_footprint`.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 05 · map, odom, base_link
#
# **하나는 튈 수 있고, 하나는 드리프트할 수 있습니다** · 약 25분 · 03, 04장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 끊김 없이 변하지만 오차가 쌓이는 포즈와 정확하지만 튀는 포즈를 구별하고, 알맞은 곳에 쓸 수 있습니다.
# - [[localisation|위치 추정(localization)]] 노드가 발행하는 `map → odom`을 같은 시각의 두 포즈로 계산할 수 있습니다.
# - `map → base_link`를 아무도 발행하지 않는 이유를 설명하고, 그것을 발행하는 로봇을 알아볼 수 있습니다.
# - 기울어진 로봇을 바닥으로 투영할 수 있습니다. 그것이 `base_footprint`입니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# This chapter is about one edge: map to odom. Ask now: if the robot knows its pose on the map, why not simply publish that? Collect answers, and promise to come back to them.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 이 장은 연결 하나, map → odom을 다룹니다. 먼저 묻습니다. 지도 위의 포즈를 안다면 왜 그대로 발행하지 않을까요? 답을 모아 두고 나중에 다시 봅니다.

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.core import StampedTransform, Transform, seconds
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## The robot that was in two places
#
# A new program matches laser scans to a map, and finds the robot on it. So it publishes what it found: *base_link is here in map*.
# The wheel odometry has always published: *base_link is there in odom*.
# In a video of the author, the robot flickers between two positions, many times a second (rsasaki0109/lidar_slam_ros2, 2024).
#
# Both were right. But a [[frame]] has one parent, and they gave it two. The last message decided which parent it had, until the next one came.
# The author was not the first. Others had proposed the same for two widely used packages (2014, 2021). Both packages publish `map → odom` instead.
# The fix is the one edge of this chapter, `map → odom`.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 번갈아 두 곳에 있던 로봇
#
# 새 프로그램이 레이저 스캔을 지도와 맞추어 로봇의 위치를 잘 찾아냈습니다. 그리고 찾은 것을 그대로 발행했습니다. *base_link는 map의 여기에 있다.*
# 바퀴 오도메트리 노드는 늘 이렇게 발행해 왔습니다. *base_link는 odom의 저기에 있다.*
# 개발자가 올린 영상에서 로봇은 1초에도 여러 번 두 곳을 오가며 깜빡입니다(rsasaki0109/lidar_slam_ros2, 2024년).
#
# 둘 다 맞는 값이었습니다. 하지만 [[frame|좌표계]]의 부모는 하나입니다. 두 노드가 서로 다른 부모를 발행했으므로, 그때그때 마지막에 발행된 부모가 쓰였습니다.
# 이 프로그램만의 일이 아닙니다. 널리 쓰는 위치 추정 패키지 두 개에서도 로봇의 포즈를 `map` 기준으로 바로 발행하자는 제안이 있었고(2014년, 2021년), 같은 방법으로 고쳤습니다.
# 그 방법이 이 장의 연결 하나, `map → odom`입니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Both nodes published correct values. Say that twice.
# Then ask for a solution, and take every proposal seriously: average them, prefer the better one, alternate.
# The last is what happens in tf2.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 두 노드 모두 맞는 값을 발행했습니다.
# 이 점을 거듭 강조합니다.
# 그다음 해결책을 묻고 모두 진지하게 받습니다.
# 평균을 낸다, 더 나은 쪽을 따른다, 번갈아 쓴다.
# 마지막 것이 tf2에서 실제로 일어나는 일입니다.

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* lidar_slam_ros2 [86](https://github.com/rsasaki0109/lidar_slam_ros2/issues/86), [87](https://github.com/rsasaki0109/lidar_slam_ros2/pull/87); robot_localization [23](https://github.com/cra-ros-pkg/robot_localization/issues/23); hdl_localization [67](https://github.com/koide3/hdl_localization/issues/67); [REP-105](https://ros.org/reps/rep-0105.html).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* lidar_slam_ros2 [86](https://github.com/rsasaki0109/lidar_slam_ros2/issues/86), [87](https://github.com/rsasaki0109/lidar_slam_ros2/pull/87), robot_localization [23](https://github.com/cra-ros-pkg/robot_localization/issues/23), hdl_localization [67](https://github.com/koide3/hdl_localization/issues/67), [REP-105](https://ros.org/reps/rep-0105.html).

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# A robot drives laps for a minute, at half a metre per second. One of its wheels is 1 % larger than the odometry assumes. Every five seconds a localiser matches a scan to the map and corrects the pose.
#
# 1. Which pose is **farther off** at worst: the one in `odom`, or the one in `map`?
# 2. Which pose has the **larger steps**?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 로봇이 1분 동안 0.5 m/s로 방 안을 돌며 달립니다. 한쪽 바퀴가 설정된 값보다 1 % 큽니다. 위치 추정 노드는 5초마다 벽을 보고 지도 위의 포즈를 바로잡습니다.
#
# 1. 최악의 경우 어느 포즈가 **더 많이 틀릴까요?** `odom` 기준일까요, `map` 기준일까요?
# 2. 어느 포즈가 한 번에 **더 크게** 바뀔까요?

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Hands for both questions. The common answer is "map is better in both". It is half right.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 두 질문 모두 손을 들게 합니다. 나올 법한 오답은 “둘 다 map이 낫다”입니다. 반만 맞습니다.

# %% name="my-guess" slide="skip"
farther_off, larger_steps = ..., ...  # "odom" or "map"

# %% name="the-drive" tags=["collapsed"] slide="skip"
# Drive for a minute, and fill the buffer.
import numpy as np

robot = lesson.TeachingRobot(bias=0.01, correction_period_s=5.0)
buffer = robot.buffer(until_s=62.0, cache_time_s=100.0)  # what a listener would have received

# %% [markdown] lang="en" name="pose-at-why" slide="skip"
# The robot has driven for a minute, and `buffer` holds every transform that a listener received.
# All numbers below come from one lookup: where is `child` in `frame`, `t` seconds after the start?

# %% [markdown] lang="ko" name="pose-at-why" slide="skip"
# 로봇은 1분 동안 달렸고, `buffer`에는 그동안 수신기가 받은 변환이 모두 들어 있습니다.
# 아래의 숫자는 모두 이 조회 하나로 얻습니다. 시작하고 `t`초가 지났을 때 `frame` 기준으로 `child`는 어디에 있을까요?

# %% name="pose-at" slide="skip"
def pose(frame, child, t):
    return buffer.lookup_transform(frame, child, seconds(t)).transform

# %% name="three-pens" tags=["predicted", "collapsed"] slide="fragment"
# Draw the three paths.
times = [1.5 + 0.1 * k for k in range(600)]
start = robot.truth_at(seconds(1.0))['base_footprint']  # where odom begins
in_map = np.array([pose('map', 'base_footprint', t).translation for t in times])
in_odom = np.array([start.apply(pose('odom', 'base_footprint', t).translation) for t in times])
truth = np.array([robot.truth_at(seconds(t))['base_footprint'].translation for t in times])
lesson.draw_tracks({'map': in_map, 'odom': in_odom}, truth, times)

# %% [markdown] lang="en" name="three-pens-seen" tags=["predicted"]
# The upper plot shows the paths from above. The broad grey line is the true path. The plots below it show how far each sample is from the one before it, a tenth of a second earlier, and how far it is from the truth.
#
# - The pose in [[odom]] never takes a step that the robot did not drive, and within the minute it is more than three metres off. It **drifts**.
# - The pose in [[map]] is never more than a quarter of a metre off, and it jumps each time it is corrected. It **jumps**.
#
# Neither is wrong. [[rep-105]], the convention for these frames, promises just that: odom is continuous and may drift, map does not drift and may jump.
# The publisher has to keep this promise. If a node corrects its odometry in one step, the pose jumps in `odom`, too.

# %% [markdown] lang="ko" name="three-pens-seen" tags=["predicted"]
# *그림 읽기:* 위 그림은 위에서 본 경로입니다. 넓은 회색 띠(truth)가 실제 경로이고, x in map과 y in map은 `map` 기준 좌표입니다. 가운데(distance between two samples)는 0.1초 간격인 두 표본 사이의 거리, 아래(error: distance from the truth)는 실제 위치와의 거리입니다. time = 시각.
#
# - [[odom|`odom`]] 기준 포즈는 끊김 없이 변합니다. 대신 오차가 조금씩 쌓여, 1분 사이에 3 m 넘게 틀립니다. 이것을 **드리프트**(drift)라고 합니다.
# - [[map|`map`]] 기준 포즈는 0.25 m 넘게 틀리지 않습니다. 대신 바로잡을 때마다 값이 한꺼번에 바뀝니다. 이것을 **튄다**(jump)고 합니다.
#
# 어느 쪽도 잘못이 아닙니다. 이 좌표계들에 관한 ROS의 규약인 [[rep-105]]의 약속이 바로 이렇습니다. odom은 연속이지만 드리프트할 수 있고, map은 드리프트하지 않지만 튈 수 있습니다.
# 이 약속의 첫 부분은 발행하는 노드가 지켜야 합니다. 오도메트리를 한꺼번에 바로잡으면 `odom` 기준 포즈도 튑니다.

# %% [markdown] lang="en" name="three-pens-notes" slide="notes"
# Point at one jump in the upper plot and find it in both curves below it.
# Then ask the two questions again, as they were predicted.
# The two answers are different frames.

# %% [markdown] lang="ko" name="three-pens-notes" slide="notes"
# 위 그림에서 튀는 곳 하나를 짚고, 아래 두 곡선에서 찾게 합니다.
# 그다음 예측한 두 질문을 다시 묻습니다.
# 두 질문의 답은 서로 다릅니다.

# %% [markdown] lang="en" name="speed-of-a-jump" slide="subslide"
# Suppose a controller estimates the speed from the pose in `map`. What would it see?

# %% [markdown] lang="ko" name="speed-of-a-jump" slide="subslide"
# 제어기가 `map` 기준 포즈로 속도를 계산하면 어떤 값이 나올까요?

# %% name="speeds" slide="-"
for name, track in {'map': in_map, 'odom': in_odom}.items():
    speed = np.linalg.norm(np.diff(track[:, :2], axis=0), axis=1) / 0.1
    print(f'{name:<5} fastest {speed.max():.2f} m/s')

# %% [markdown] lang="en" name="speeds-notes" slide="notes"
# Ask somebody who has tuned a controller what it would do at 2.4 m/s on a robot that drives half a metre per second.
# It brakes.
# The robot jerks. Most people have seen that on a real robot.

# %% [markdown] lang="ko" name="speeds-notes" slide="notes"
# 제어기를 조정해 본 사람에게 묻습니다.
# 0.5 m/s로 달리는 로봇에서 2.4 m/s가 나오면 제어기는 어떻게 합니까?
# 제동을 겁니다.
# 복도에서 로봇이 덜컥거리는 까닭입니다.

# %% [markdown] lang="en" name="speeds-seen"
# The robot drives at 0.5 m/s and appears to drive at almost 2.5 m/s. A controller that brakes because of that makes the robot jerk.

# %% [markdown] lang="ko" name="speeds-seen"
# 0.5 m/s로 달리는 로봇이 순간 2.4 m/s로 달리는 것처럼 보입니다. 이 값으로 제동하면 로봇이 덜컥거립니다.

# %% [markdown] lang="en" name="who-moves" slide="slide"
# ## What moves when the pose jumps?
#
# Between 26.0 and 26.1 s the localiser corrects the pose. **Predict** for each: does it jump, or not?
#
# - the robot in `odom` · `odom` in `map` · the robot in `map`

# %% [markdown] lang="ko" name="who-moves" slide="slide"
# ## 튈 때 움직이는 것은 무엇일까요?
#
# 26.0초와 26.1초 사이에 위치 추정 노드가 포즈를 바로잡습니다. 각각 튈지 아닐지 **예측해 봅시다.**
#
# - `odom` 기준의 로봇 · `map` 기준의 `odom` · `map` 기준의 로봇

# %% name="around-the-jump" tags=["predicted"] slide="fragment"
for parent, child in (('odom', 'base_footprint'), ('map', 'odom'), ('map', 'base_footprint')):
    before, after = pose(parent, child, 26.0), pose(parent, child, 26.1)
    moved = np.linalg.norm(np.subtract(after.translation, before.translation))
    rotated = after.rpy()[2] - before.rpy()[2]
    print(f'{child:<15} in {parent:<5} moves {moved:.2f} m, rotates {rotated:+.2f} rad')

# %% [markdown] lang="en" name="around-the-jump-seen" tags=["predicted"]
# In `odom` the robot moved five centimetres, as driven: a correction never changes [[odometry]].
# What jumped is **`odom` itself, in `map`**, and with it all its descendants, the robot too.
# Note the rotation: 0.2 rad. The correction is not just a shift. It moves the origin of `odom`, and rotates the whole frame about that origin.

# %% [markdown] lang="ko" name="around-the-jump-seen" tags=["predicted"]
# `odom` 기준의 로봇은 실제로 달린 만큼인 5 cm만 움직였습니다. 보정은 [[odometry|오도메트리(odometry)]]를 바꾸지 않습니다.
# 튄 것은 **`map` 기준의 `odom` 자체**이고, 그 아래에 매달린 것도 모두 함께 튑니다. 로봇도 마찬가지입니다.
# 회전을 살펴보세요. 0.2 rad입니다. 보정은 어긋난 만큼 밀기만 하는 것이 아닙니다. odom 전체를 이동시키고, odom의 원점을 중심으로 회전시킵니다.

# %% [markdown] lang="en" name="in-3d" slide="subslide"
# In 3D, seen from the map: move the slider, and watch the frame `odom`. It stands still, and then jumps.
# At 26 s `odom` moves by 0.12 m and rotates. The robot is a metre and a half away from its origin, and moves by 0.24 m.
# (The still picture shows both from above. Grey is the pose before the correction.)

# %% [markdown] lang="ko" name="in-3d" slide="subslide"
# 지도를 기준으로 본 3D 장면입니다. 슬라이더를 움직이며 odom 좌표계를 살펴보세요. 가만히 있다가 갑자기 튑니다.
# 26초에 `odom`은 0.12 m 이동하고 회전합니다. 그 원점에서 1.5 m 떨어진 로봇은 0.24 m 이동합니다.
#
# *그림 읽기:* truth = 실제 경로, time = 시각. 위에서 본 그림에서는 회색이 바로잡기 전(grey: before)이고 뾰족한 쪽이 로봇의 앞입니다.

# %% name="in-3d-scene" tags=["collapsed"] slide="skip"
# Prepare the 3D view.
scene = lesson.Scene(height_px=360)
scene.look(eye=(2.2, -4.0, 3.6), target=(2.2, -0.3, 0.0))
lesson.draw_frame(scene, 'map', Transform(), length_m=0.7)
lesson.draw_path(scene, 'truth', truth[::5], colour='#9AA0A6')


def at_time(t):
    lesson.draw_frame(scene, 'odom', pose('map', 'odom', t), parent='map', length_m=0.7)
    lesson.draw_frame(scene, 'base_footprint', pose('map', 'base_footprint', t), parent='odom', length_m=0.5)

# %% name="in-3d-sweep" tags=["interactive", "collapsed"]
# Show the 3D view.
scene.sweep('time', [20.0 + 0.5 * i for i in range(41)], at_time, unit='s')
scene

# %% name="in-3d-still" tags=["static"]
jump = {frame: (pose('map', frame, 26.0), pose('map', frame, 26.1)) for frame in ('odom', 'base_footprint')}
lesson.draw_moves(jump, bodies=['base_footprint'])

# %% [markdown] lang="en" name="the-sum" slide="slide"
# ## What a localiser publishes
#
# It measures `map_T_base`, the robot's pose on the map. TF has `odom_T_base`, from the wheel odometry.
# The localiser needs the transform between the two: `map_T_odom`. Lay the dominoes: [map | base] [base | odom] = [map | odom].

# %% [markdown] lang="ko" name="the-sum" slide="slide"
# ## 위치 추정 노드가 발행하는 것
#
# 노드는 지도 위 로봇의 포즈 `map_T_base`를 측정합니다. TF에는 오도메트리의 `odom_T_base`가 있습니다.
# 필요한 것은 둘 사이의 변환 `map_T_odom`입니다. 도미노를 놓아 보세요. [map | base] [base | odom] = [map | odom].

# %% name="dominoes" tags=["collapsed"] slide="-"
# Draw the dominoes.
lesson.draw_dominoes(('map', 'base'), ('base', 'odom'))

# %% name="the-sum-in-code" slide="fragment"
def map_to_odom(map_T_base, odom_T_base):
    return map_T_base @ odom_T_base.inverse()


t = 26.1
computed = map_to_odom(pose('map', 'base_footprint', t), pose('odom', 'base_footprint', t))
print('computed ', lesson.fmt_all(computed.translation), f'yaw {computed.rpy()[2]:+.3f} rad')
print('published', lesson.fmt_all(pose('map', 'odom', t).translation), f'yaw {pose("map", "odom", t).rpy()[2]:+.3f} rad')

# %% [markdown] lang="en" name="faded" slide="subslide"
# ### Now you write
#
# A scan matcher (a program that fits a scan to the map) returns `map_T_laser` for the scan's stamp. TF has `odom_T_base` and `base_T_laser` for the same time. Fill in the two blanks.
#
# ```python
# map_T_base = map_T_laser @ ____________
# map_T_odom = map_T_base @ ____________
# ```
#
# <details><summary>Compare</summary>
#
# `base_T_laser.inverse()`, which is `laser_T_base`, and `odom_T_base.inverse()`. Neighbours match: [map | laser][laser | base][base | odom].
#
# </details>

# %% [markdown] lang="ko" name="faded" slide="subslide"
# ### 빈칸을 채워 보세요
#
# 스캔을 지도에 맞추는 프로그램(scan matcher)이 스캔을 측정한 시각의 `map_T_laser`를 반환합니다. TF에는 같은 시각의 `odom_T_base`와 `base_T_laser`가 있습니다. 빈칸 두 개를 채워 보세요.
#
# ```python
# map_T_base = map_T_laser @ ____________
# map_T_odom = map_T_base @ ____________
# ```
#
# <details><summary>맞춰 보기</summary>
#
# `base_T_laser.inverse()`, 곧 `laser_T_base`와 `odom_T_base.inverse()`입니다. 이웃끼리 맞습니다. [map | laser][laser | base][base | odom].
#
# </details>

# %% [markdown] lang="en" name="same-moment" slide="subslide"
# Both poses must be of the **same time**: the stamp of the scan that was matched. **Predict:** the robot drives a curve, and the odometry's pose is a tenth of a second older. How far off is `map → odom`?

# %% [markdown] lang="ko" name="same-moment" slide="subslide"
# 두 포즈는 **같은 시각**의 것이어야 합니다. 그 시각은 지도와 맞춘 스캔의 측정 시각입니다. **예측해 봅시다.** 로봇이 회전하며 달릴 때 오도메트리 포즈가 0.1초 이전의 것이라면 `map → odom`은 얼마나 틀릴까요?

# %% name="another-moment" tags=["predicted"]
late = map_to_odom(pose('map', 'base_footprint', 31.0), pose('odom', 'base_footprint', 30.9))
right = pose('map', 'odom', 31.0)
off = right.inverse() @ late
print(f'off by {np.hypot(*off.translation[:2]):.2f} m and {off.rpy()[2]:+.2f} rad')

# %% [markdown] lang="en" name="another-moment-seen" tags=["predicted"]
# A third of a metre, from a tenth of a second. The rotation between the two poses ends up in `map → odom` and rotates `odom` about the robot. The origin of `odom` is three and a half metres from the robot, so it moves by a third of a metre.
# A well-known estimator fixed exactly this in 2025 (robot_localization [939](https://github.com/cra-ros-pkg/robot_localization/pull/939)).

# %% [markdown] lang="ko" name="another-moment-seen" tags=["predicted"]
# 0.1초 차이로 0.33 m 틀립니다. 0.1초 동안 로봇이 회전한 각도가 `map → odom`에 들어갑니다. 그래서 odom이 로봇을 중심으로 그 각도만큼 회전합니다. 로봇에서 3.5 m 떨어진 odom의 원점은 그만큼 크게 밀려납니다.
# 널리 쓰는 추정 패키지도 2025년에 바로 이것을 고쳤습니다(robot_localization [939](https://github.com/cra-ros-pkg/robot_localization/pull/939)).

# %% [markdown] lang="en" name="same-moment-notes" slide="notes"
# A tenth of a second, a third of a metre.
# Before you say why, let them draw it: rotate the robot by six degrees and look at what happens to a point three metres away.
# The stamp is part of the calculation.

# %% [markdown] lang="ko" name="same-moment-notes" slide="notes"
# 0.1초에 0.33 m입니다.
# 이유를 말하기 전에 그리게 합니다.
# 로봇을 6° 회전시키면 3 m 떨어진 점은 어떻게 될까요?
# 측정 시각도 식의 일부입니다.

# %% [markdown] lang="en" name="what-where" slide="slide"
# ## What to keep in which frame
#
# An obstacle is one metre ahead. You store its coordinates for a tenth of a second, once in `map` and once in `odom`. Meanwhile the correction comes.
# You also store a goal for longer, by its coordinates in `odom`.
#
# **Predict:** how far off is each of the two obstacles after the correction? And the goal after 40 seconds?

# %% [markdown] lang="ko" name="what-where" slide="slide"
# ## 무엇을 어느 좌표계에 둘까요?
#
# 1 m 앞의 장애물을 0.1초 동안 기억합니다. 한 번은 `map` 기준 숫자로, 한 번은 `odom` 기준 숫자로 기억합니다. 그사이 보정이 들어옵니다.
# 목적지 하나는 `odom` 기준 숫자로 더 오래 기억합니다.
#
# **예측해 봅시다.** 보정이 들어온 뒤 두 장애물은 각각 얼마나 어긋날까요? 40초 뒤의 목적지는 얼마나 어긋날까요?

# %% name="obstacle" tags=["predicted", "collapsed"] slide="fragment"
# Keep an obstacle and a goal, and compare.
there = robot.truth_at(seconds(26.1))['base_footprint'].inverse() @ robot.truth_at(seconds(26.0))['base_footprint']
for keep in ('map', 'odom'):
    kept = pose(keep, 'base_footprint', 26.0).apply((1.0, 0.0, 0.0))
    seen = pose('base_footprint', keep, 26.1).apply(kept)
    off = np.linalg.norm(np.subtract(seen, there.apply((1.0, 0.0, 0.0))))
    print(f'obstacle kept in {keep:<5} off by {off:.2f} m after the correction')

goal = (3.0, 2.0, 0.0)  # in map, noted in odom at 10 s
for later in (20.0, 50.0):
    back = pose('map', 'odom', later).apply(pose('odom', 'map', 10.0).apply(goal))
    print(f'goal kept in odom: after {later - 10:.0f} s it is {np.linalg.norm(np.subtract(back, goal)):.2f} m from where it was')

# %% [markdown] lang="en" name="what-where-seen" tags=["predicted"]
# The obstacle in `map` is off by 0.44 m, the one in `odom` not at all. The goal in `odom` is almost three metres off after 40 seconds.
#
# | keep in | what | because |
# |---|---|---|
# | `odom` | recent obstacles, the next half metre, speeds | it is smooth, and recent coordinates have not drifted |
# | `map` | goals, rooms, the charging dock | it does not drift |
# | `base_link` | what is mounted on the robot | it moves with the robot |
#
# If you avoid `odom` because it drifts, you lose the smooth pose. If you use `map` for everything, you get the jumps.

# %% [markdown] lang="ko" name="what-where-seen" tags=["predicted"]
# `map` 기준으로 기억한 장애물은 0.44 m 어긋나고, `odom` 기준으로 기억한 장애물은 어긋나지 않습니다. `odom` 기준으로 기억한 목적지는 40초 뒤 3 m 가까이 어긋납니다.
#
# | 두는 곳 | 무엇을 | 이유 |
# |---|---|---|
# | `odom` | 방금 본 것, 다음 0.5 m, 속도 | 끊김이 없고, 아직 드리프트가 쌓이지 않았습니다 |
# | `map` | 목적지, 방, 내일 갈 충전대 | 드리프트하지 않습니다 |
# | `base_link` | 로봇에 고정된 것 | 함께 움직입니다 |
#
# “odom은 드리프트하니까 틀렸다”며 버리면 끊김 없는 포즈를 잃고, “map이 더 낫다”며 제어에 쓰면 로봇이 덜컥거립니다.

# %% [markdown] lang="en" name="what-where-notes" slide="notes"
# Let the class fill the table before you scroll to it: call out an item, and they call back a frame.
# Dock, next half metre, mount of the laser, goal.
# Stop at every disagreement; there will be one about obstacles.

# %% [markdown] lang="ko" name="what-where-notes" slide="notes"
# 표를 보여 주기 전에 채우게 합니다.
# 물건을 하나씩 부르면 좌표계로 답합니다.
# 충전대, 다음 0.5 m, 레이저의 나사, 목적지.
# 의견이 갈리면 멈추고 이유를 묻습니다.
# 장애물에서는 대개 의견이 갈립니다.

# %% [markdown] lang="en" name="footprint" slide="slide"
# ## base_footprint: the robot's projection onto the floor
#
# `base_link` is fixed to the body: it has height, and it tilts on a ramp. [[base_footprint]] is its projection onto the floor: x, y and yaw only.
# Our `base_link` is 0.10 m above the floor, and the robot's front tilts up by 10°. The laser detects a point at (2.2, 0, 0.15) in `base_link`. How high above the floor is it?

# %% [markdown] lang="ko" name="footprint" slide="slide"
# ## base_footprint: 바닥에 투영한 로봇
#
# `base_link`는 몸체에 붙어 있어 높이가 있고, 경사로에서 기울어집니다. [[base_footprint|`base_footprint`]]는 로봇을 바닥에 투영한 좌표계입니다. x, y, yaw만 있습니다.
# 우리 로봇의 `base_link`는 바닥에서 0.10 m 위에 있습니다. 앞쪽이 10° 들립니다. 레이저가 `base_link` 기준 (2.2, 0, 0.15)에 있는 점을 보았습니다. 이 점은 바닥에서 얼마나 높을까요?

# %% name="nose-up"
import math

footprint_T_base = Transform.from_rpy(pitch=-math.radians(10), translation=(0.0, 0.0, 0.10))
point = footprint_T_base.apply((2.2, 0.0, 0.15))
print('in base_footprint', lesson.fmt_all(point, digits=2))

# %% name="nose-up-picture" tags=["collapsed"] slide="-"
# Draw both points from the side.
lesson.draw_scene({'base_footprint': Transform(), 'base_link': footprint_T_base}, {'detected: 0.63 m up': point},
                  ghost_points={'if level: 0.25 m up': (2.2, 0.0, 0.25)},
                  fixed_frame='base_footprint', length_m=0.5, eye=lesson.FROM_THE_SIDE)

# %% [markdown] lang="en" name="nose-up-seen"
# 0.63 m above the floor. If you assume that the robot is level, you get 0.25 m, and you mistake a wall for a low step. The figure shows both from the side.
# On our robot the wheel odometry publishes `odom → base_footprint`, and `base_link` is a child of it. Other robots have it as a child of `base_link`. Check whether your robot publishes `odom → base_footprint` or `odom → base_link`, and never publish both.
#
# Not every robot needs a `base_footprint`: it is useful where `base_link` is above the floor and can tilt.
# Decide by three things: the frame that your navigation stack is set to (`robot_base_frame` in Nav2, the navigation of ROS 2, and `base_frame_id` in AMCL, its localiser), the frames that your URDF has, and the contract that says which node publishes which edge.
# If a frame for the projection is already there, use it, and do not add a second frame for the same thing.

# %% [markdown] lang="ko" name="nose-up-seen"
# *그림 읽기:* 옆에서 본 그림입니다. detected = 레이저가 본 점, if level = 로봇이 기울지 않았다고 여길 때의 점, up = 바닥에서의 높이.
#
# 바닥에서 0.63 m 위입니다. 로봇이 기울지 않았다고 여기면 0.25 m가 되어, 벽 한가운데를 낮은 턱으로 착각합니다.
# 우리 로봇에서는 바퀴 오도메트리가 `odom → base_footprint`를 발행하고 `base_link`가 그 자식입니다. `base_footprint`가 `base_link`의 자식인 로봇도 있습니다. 내 로봇이 `odom → base_footprint`와 `odom → base_link` 가운데 어느 것을 발행하는지 확인하고, 둘 다 발행하지는 마십시오.
#
# 모든 로봇에 `base_footprint`가 필요한 것은 아닙니다. `base_link`가 바닥보다 높고 기울 수 있을 때 쓸모가 있습니다.
# 세 가지를 보고 정합니다. 주행 패키지에 설정된 좌표계(ROS 2의 주행 패키지인 Nav2의 `robot_base_frame`, Nav2의 위치 추정 노드인 AMCL의 `base_frame_id`), URDF에 있는 좌표계, 그리고 어느 노드가 어느 연결을 발행하는지 정한 약속입니다.
# 바닥에 투영한 좌표계가 이미 있으면 그것을 쓰고, 같은 것에 좌표계를 하나 더 만들지 마십시오.

# %% [markdown] lang="en" name="footprint-notes" slide="notes"
# Tilt a book with a pen on it: how high is the pen's tip above the table?
# Then the question for a real robot: which of the two frames does your odometry publish?

# %% [markdown] lang="ko" name="footprint-notes" slide="notes"
# 책 위에 펜을 올리고 책을 기울입니다.
# 펜 끝은 책상에서 얼마나 위에 있습니까?
# 그다음 실제 로봇으로 묻습니다.
# 여러분의 로봇에서 오도메트리 노드는 두 좌표계 가운데 어느 것을 발행합니까?

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it: publish the pose in map
#
# Now do what the program of the story did. The localiser stops publishing its edge, and another node publishes the robot's pose in `map`, ten times a second.
# A listener looks up the robot a thousand times in ten seconds, in `map` and in `odom`.
# The folded cells start the nodes. Their function `measured_pose(now)` returns the robot's pose in `map` as a message.
#
# **Predict:** how often do *both* lookups succeed? Always, half the time, never?

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기: 맞는 포즈를 그대로 발행하기
#
# 이야기 속 프로그램이 한 일을 해 봅시다. 위치 추정 노드의 발행은 끄고, 다른 노드가 `map` 기준 로봇의 포즈를 1초에 열 번 발행합니다.
# 또 다른 노드는 10초 동안 천 번, `map` 기준과 `odom` 기준의 로봇을 조회합니다.
# 접힌 셀에서 노드들을 시작합니다. 거기서 정의한 `measured_pose(now)`는 `map` 기준 로봇의 포즈를 메시지로 반환합니다.
#
# **예측해 봅시다.** 두 조회가 *모두* 성공하는 때는 얼마나 될까요? 늘, 절반, 아니면 한 번도 없을까요?

# %% name="eager-robot" tags=["collapsed"] slide="skip"
# Start the robot, and define measured_pose().
from tflab.ros.convert import msg_from_stamped

graph = lesson.new_graph()
parts = ['robot_state_publisher', 'joint_driver', 'wheel_odometry', 'localization']
nodes = lesson.launch(graph, robot, only=parts)
graph.run(seconds=1.0)


def measured_pose(now):
    """Return what the scan matcher finds at this time: map → base_footprint, as a TransformStamped."""
    map_T_base = robot.truth_at(now.nanoseconds)['base_footprint']
    return msg_from_stamped(StampedTransform('map', 'base_footprint', now.nanoseconds, map_T_base))

# %% name="eager-localizer" slide="skip"
import rclpy
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformBroadcaster, TransformException, TransformListener


class EagerLocalizer(Node):
    def __init__(self):
        super().__init__('eager_localizer')
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self.publish_pose)

    def publish_pose(self):
        self.broadcaster.sendTransform(measured_pose(self.get_clock().now()))  # map → base_footprint

# %% name="switch-over" slide="-"
# %ros2 param set /localization tf_broadcast false

# %% name="a-thousand-questions" tags=["predicted", "collapsed"]
# Start the new node and a listener.
def main():
    rclpy.init()
    rclpy.spin(EagerLocalizer())


graph.start(main, name='eager_localizer')
rclpy.init()
node = Node('asker')
tf_buffer = Buffer()
listener = TransformListener(tf_buffer, node, spin_thread=True)
graph.run(seconds=5.0)

# %% name="count-the-answers" tags=["predicted"] slide="-"
answered = {'map': 0, 'odom': 0, 'both': 0}
for _ in range(1000):
    graph.run(seconds=0.01)
    there = [frame for frame in ('map', 'odom') if tf_buffer.can_transform(frame, 'base_link', Time())]
    for frame in there:
        answered[frame] += 1
    answered['both'] += len(there) == 2
print(answered)

# %% [markdown] lang="en" name="counted" tags=["predicted"]
# Half the time the robot is in `map`, half the time in `odom`, and never in both. No node raises an error: two correct values alternate.
# A lookup in `map` while `odom` is the parent raises:

# %% [markdown] lang="ko" name="counted" tags=["predicted"]
# 로봇은 시간의 절반은 `map`에, 절반은 `odom`에 연결되어 있고, 둘 다에 연결된 때는 한 번도 없습니다. 두 노드가 발행할 때는 오류가 나지 않습니다. 맞는 두 포즈가 번갈아 나타날 뿐입니다.
# 로봇이 `odom`에 연결되어 있을 때 `map` 기준으로 조회하면 이런 오류가 나옵니다.

# %% [markdown] lang="en" name="counted-notes" slide="notes"
# Read the three numbers slowly: half, half, zero.
# Remember the proposals of the first slide: this is what alternating costs.
# There was no error.

# %% [markdown] lang="ko" name="counted-notes" slide="notes"
# 세 숫자를 천천히 읽습니다.
# 절반, 절반, 0입니다.
# 첫 슬라이드의 제안을 다시 꺼냅니다.
# 번갈아 쓴 결과가 이것입니다.
# 오류는 하나도 나지 않았습니다.

# %% name="wrong-half"
for _ in range(10):
    graph.run(seconds=0.01)
    try:
        tf_buffer.lookup_transform('map', 'laser_frame', Time())
    except TransformException as error:
        print(error)
        break

# %% [markdown] lang="en" name="cure"
# The fix is one line: publish `map_to_odom(map_T_base, odom_T_base)` with the stamp of the scan, and leave `base_footprint` to the wheel odometry.

# %% [markdown] lang="ko" name="cure"
# 고치는 데는 한 줄이면 됩니다. 스캔의 측정 시각으로 `map_to_odom(map_T_base, odom_T_base)`를 발행하고, `base_footprint`는 바퀴 오도메트리 노드에 맡기십시오.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# A robot follows a line on the floor in front of it. Its controller reads its pose thirty times a second. In which frame?
#
# 1. `map`: it is the accurate one.
# 2. `odom`: it is the smooth one.
# 3. `base_link`: the robot is always at (0, 0, 0) there.
# 4. Whichever is available.
#
# <details><summary>I chose 1</summary>
#
# It is accurate on average, but it jumps at each correction, and the controller reacts to the jump. The next half metre does not depend on the map.
#
# </details>
# <details><summary>I chose 2</summary>
#
# Yes: each step in odom is one that the robot drove. Over half a metre the drift is too small to matter.
#
# </details>
# <details><summary>I chose 3</summary>
#
# True, but useless: in base_link the robot never moves, so there is nothing to control.
#
# </details>
# <details><summary>I chose 4</summary>
#
# Then the controller changes frames while it drives, with a jump each time. That is the flicker of the story.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 로봇이 앞쪽 바닥에 그려진 선을 따라갑니다. 제어기는 1초에 서른 번 자기 포즈를 읽습니다. 어느 좌표계 기준이어야 합니까?
#
# 1. `map`: 정확하기 때문입니다.
# 2. `odom`: 끊김 없이 변하기 때문입니다.
# 3. `base_link`: 그 기준으로 로봇은 늘 (0, 0, 0)에 있기 때문입니다.
# 4. 그때그때 얻을 수 있는 것.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 평균은 정확하지만 보정할 때마다 튀고, 제어기는 로봇이 실제로 움직인 것으로 처리합니다. 다음 0.5 m를 가는 데는 지도 위의 위치가 필요하지 않습니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 맞습니다. `odom` 기준 포즈는 끊김 없이 변합니다. 0.5 m 동안에는 문제가 될 만큼 드리프트가 쌓이지 않습니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞는 말이지만 쓸모가 없습니다. base_link 기준으로 로봇은 움직이지 않으므로 제어할 것이 없습니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 달리는 도중에 좌표계가 바뀌고, 그때마다 튑니다. 이야기 속의 깜빡임을 직접 만드는 셈입니다.
#
# </details>

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# ```
# ros2 run tf2_ros tf2_echo map odom               # constant, then a jump
# ros2 run tf2_ros tf2_echo odom base_footprint    # smooth, and slowly drifting
# ros2 param get /amcl tf_broadcast                # does AMCL publish map -> odom?
# ```
#
# In Nav2 (the navigation of ROS 2; `/amcl` is its localiser) the local costmap (a map of the obstacles nearby) has `global_frame: odom`, and the global costmap has `global_frame: map`. In robot_localization, the parameter `world_frame` selects `odom` or `map`, and with it the edge that the node publishes.

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# ```
# ros2 run tf2_ros tf2_echo map odom               # 가만히 있다가 한 번에 튑니다
# ros2 run tf2_ros tf2_echo odom base_footprint    # 끊김 없이 변하고 오차가 조금씩 쌓입니다
# ros2 param get /amcl tf_broadcast                # map -> odom을 발행하는지
# ```
#
# Nav2는 ROS 2의 주행 패키지이고 `/amcl`은 Nav2의 위치 추정 노드입니다. 코스트맵(costmap)은 장애물을 적는 격자 지도입니다. 가까운 곳의 지역 코스트맵(local costmap)은 `global_frame: odom`, 전역 코스트맵(global costmap)은 `global_frame: map`을 씁니다. robot_localization에서는 `world_frame`을 `odom`이나 `map`으로 정하며, 그에 따라 노드가 발행하는 연결이 달라집니다.

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - [[odom]] is smooth and drifts. [[map]] does not drift and jumps. Use each for what it is good at.
# - A correction moves and rotates `odom` in `map`. It does not change the odometry.
# - `map_T_odom = map_T_base @ odom_T_base.inverse()`, both at one stamp.
# - A frame has one parent. If a node publishes `map → base_link` beside the odometry, two values alternate, without an error.
# - [[base_footprint]] is the projection onto the floor: x, y, yaw.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - [[odom|`odom`]]은 연속이고 드리프트합니다. [[map|`map`]]은 드리프트하지 않고 튑니다. 제어에는 `odom`을, 목적지와 지도에는 `map`을 씁니다.
# - 보정하면 `map` 기준의 `odom`이 이동하고 회전합니다. 오도메트리는 보정으로 바뀌지 않습니다.
# - `map_T_odom = map_T_base @ odom_T_base.inverse()`이고, 두 포즈는 같은 시각의 것입니다.
# - 좌표계의 부모는 하나입니다. 바퀴 오도메트리 노드가 이미 로봇의 포즈를 발행하는데 다른 노드가 `map → base_link`까지 발행하면, 오류 없이 두 포즈가 번갈아 나타납니다.
# - [[base_footprint|`base_footprint`]]는 로봇을 바닥에 투영한 좌표계입니다. x, y, yaw만 있습니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > The localiser finds the robot 20 cm from the pose in `map` that TF gives. Which edge changes, which values stay the same, and which program must not be affected?
#
# <details><summary>Compare</summary>
#
# `map → odom` changes. `odom → base_link` and all mounts stay the same. A controller that uses `odom` must not be affected.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > 위치 추정 노드가 `map` 기준 로봇의 위치가 20 cm 틀렸음을 알아냈습니다. 어느 연결이 바뀌고, 무엇의 숫자가 그대로이며, 어느 노드는 영향을 받지 않아야 합니까?
#
# <details><summary>맞춰 보기</summary>
#
# `map → odom`이 바뀝니다. `odom → base_link`와 장착 변환은 그대로입니다. `odom` 기준으로 움직이는 제어기는 영향을 받지 않아야 합니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Two minutes.
# If somebody writes that the odometry is corrected, they still have the wrong idea. Pair them with somebody who has the right one.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 2분입니다.
# 오도메트리를 바로잡는다고 쓴 사람은 배우기 전의 생각이 그대로입니다.
# `map → odom`이라고 쓴 사람과 짝을 지어 줍니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now say which pose may jump and which may drift, compute `map → odom`, and recognise a robot on which two nodes publish the base.
#
# **Next:** the exercises, [E5 map, odom, base_link](../../exercises/en/E05_map_odom_base_link.ipynb), and after them [06 Static and dynamic](06_static_and_dynamic.ipynb), about which node publishes which transform, and how often.
# In the exercises, `solution("E5.1")` shows a solution after you have passed the task or tried three times. To start a page over, delete its file and type `tflab lab --copy-only` in a terminal of JupyterLab.
#
# The sections below are optional. Open a heading to see what it holds.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 어느 포즈가 튈 수 있고 어느 포즈가 드리프트할 수 있는지 구별하고, `map → odom`을 계산하고, 두 노드가 로봇의 포즈를 발행하는 로봇을 알아볼 수 있습니다.
#
# **다음:** 연습 문제 [E5 map, odom, base_link](../../exercises/ko/E05_map_odom_base_link.ipynb)를 풀고 [06 정적 변환과 동적 변환](06_static_and_dynamic.ipynb)으로 갑니다. 어느 변환을 한 번만 발행하고, 어느 변환을 계속 발행할지 배웁니다.
# 연습 문제에서는 통과하거나 세 번 시도한 뒤 `solution("E5.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 그 파일을 지우고 JupyterLab의 터미널에서 `tflab lab --copy-only`를 입력해 보세요.
#
# 아래는 더 알고 싶을 때 보는 부분입니다. 제목을 펼치면 내용이 나옵니다.

# %% [markdown] lang="en" name="tree-of-it" slide="slide"
# ## Two publishers in one tree, and a rate of 32.1 Hz
#
# The robot of "Break it" is still running. You see its fault once the tree lists the publisher of each transform:

# %% [markdown] lang="ko" name="tree-of-it" slide="slide"
# ## 트리에 나타난 발행자 둘과 32.1 Hz
#
# 앞에서 고장 낸 로봇이 아직 실행되고 있습니다. 트리에서 모양뿐 아니라 발행자까지 보면 고장이 드러납니다.

# %% name="owners" slide="subslide"
lesson.frame_tree(graph, seconds=1.0)

# %% [markdown] lang="en" name="owners-seen"
# 32.1 Hz stands beside `/eager_localizer`, but that node sends 10 messages a second. The odometry sends 20, and the rate counts both.
# The reason is that a buffer has one cache for each child, whichever node sends it. The name is that of the publisher of the last message. ROS 2's own `view_frames` counts in the same way.
# The rate is slightly above 30, because the number of samples is divided by the time from the first sample to the last. For the same reason a wheel at 20 Hz is shown with 21.1 Hz.

# %% [markdown] lang="ko" name="owners-seen"
# *그림 읽기:* rate = 발행률, age = 나이, published by = 발행자, also here = 여기에도 있음, D(dynamic) = 동적, S(static) = 정적. 아래 줄은 base_footprint의 부모가 둘이라는 경고입니다.
#
# `/eager_localizer` 옆에 32.1 Hz가 적혀 있습니다. 그런데 이 노드는 1초에 10번 보냅니다. 20번을 보내는 것은 바퀴 오도메트리 노드이고, 발행률은 둘을 합한 값입니다.
# 버퍼는 어느 노드가 보냈든 자식마다 기록을 하나만 두기 때문입니다. 이름은 마지막 메시지를 보낸 발행자의 것입니다. ROS 2의 `view_frames`도 이렇게 셉니다.
# 표본의 수를 첫 표본부터 마지막 표본까지의 시간으로 나누므로 30보다 조금 크게 나옵니다. 20 Hz인 바퀴가 21.1 Hz로 나오는 것도 같은 까닭입니다.

# %% name="stop" slide="skip"
graph.stop()
node.destroy_node()
rclpy.shutdown()

# %% [markdown] lang="en" name="from-before-heading" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# 1. In chapter 01, why are the ball's coordinates (6.5, −1.5) in `map` still correct tomorrow, and the 3.60 m in `base_link` already wrong when the message arrives?
# 2. A second node makes `base_link` a child of `map`. What does tf2 report, and what becomes of the tree?
# 3. What is `(map_T_odom @ odom_T_base).inverse()`, as a product of the inverses of two published edges?
#
# <details><summary>Answers</summary>
#
# 1. An object at rest keeps its coordinates in the frame in which it is at rest. The robot drove on.
# 2. Nothing: tf2 does not check whether a child already has another parent. The child moves to the parent of the last message (chapter 04).
# 3. `base_T_odom @ odom_T_map`: the order is reversed, too.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# 1. `map` 기준 (6.5, −1.5)는 내일도 쓸 수 있는데, `base_link` 기준 3.60 m는 왜 메시지를 받은 순간 이미 맞지 않습니까?
# 2. 다른 노드가 `base_link`를 `map` 아래에도 매답니다. tf2는 오류를 냅니까? 트리는 어떻게 됩니까?
# 3. `(map_T_odom @ odom_T_base).inverse()`를, 발행된 두 연결의 역변환의 합성으로 쓰면 무엇입니까?
#
# <details><summary>답</summary>
#
# 1. 물체의 좌표는 그 물체가 움직이지 않는 좌표계에서만 변하지 않습니다. 로봇은 그사이 달렸습니다.
# 2. 오류를 내지 않습니다. 자식에게 이미 다른 부모가 있는지는 확인하지 않습니다. 자식의 부모는 마지막에 발행한 것으로 바뀝니다(04장).
# 3. `base_T_odom @ odom_T_map`입니다. 합성하는 순서도 바뀝니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice questions · Q5 and Q6

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제 · Q5, Q6

# %% [markdown] lang="en" name="practice" slide="-"
# **5.** What does each of `map`, `odom` and `base_link` promise, and why are there two frames that are fixed in the world? Write four or five sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] `odom → base_link` comes from odometry: continuous, good for a short time, and it drifts without bound.
# - [ ] `map` is fixed in the world over a long time, and the robot's pose in it may jump when it is corrected.
# - [ ] Use `odom` for control and for recent obstacles, `map` for goals.
# - [ ] One frame cannot be continuous and free of drift at once, so there are two.
# - [ ] `base_link` is fixed to the robot; sensors are its descendants.
#
# </details>
#
# **6.** Why does a localiser publish `map → odom` and not `map → base_link`? Write three or four sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] A frame has one parent, and the wheel odometry already publishes `base_link` as a child of `odom`.
# - [ ] Two parents do not raise an error: the frame alternates between them.
# - [ ] `map_T_odom = map_T_base @ odom_T_base.inverse()` contains the correction, and the edge of the odometry stays as it is.
# - [ ] Both poses in that product have the same stamp.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# **5.** `map`, `odom`, `base_link`는 각각 무엇을 약속합니까? 세계에 고정된 기준 좌표계가 왜 둘입니까? 네다섯 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] `odom → base_link`는 오도메트리로 구합니다. 연속이고 짧은 시간에는 정확하지만, 드리프트가 한없이 쌓입니다.
# - [ ] `map`은 시간이 지나도 세계에 고정되어 있고, 그 기준의 로봇 포즈는 바로잡을 때 튈 수 있습니다.
# - [ ] 제어와 최근 몇 초의 장애물은 `odom`에, 목적지는 `map`에 둡니다.
# - [ ] 한 좌표계가 연속이면서 드리프트하지 않을 수는 없으므로 둘입니다.
# - [ ] `base_link`는 로봇에 고정되어 있고, 센서가 그 아래에 있습니다.
#
# </details>
#
# **6.** 위치 추정 노드는 왜 `map → base_link`가 아니라 `map → odom`을 발행합니까? 서너 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 좌표계의 부모는 하나이고, `base_link`는 바퀴 오도메트리 노드가 이미 `odom` 아래에 두었습니다.
# - [ ] 부모가 둘이어도 오류는 나지 않습니다. 트리가 번갈아 바뀝니다.
# - [ ] `map_T_odom = map_T_base @ odom_T_base.inverse()`에 보정이 담기고, 두 연결이 모두 남습니다.
# - [ ] 합성하는 두 포즈는 같은 시각의 것입니다.
#
# </details>
