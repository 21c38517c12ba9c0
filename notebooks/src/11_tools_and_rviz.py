# %% [markdown] lang="en" name="title" slide="slide"
# # 11 · Tools and RViz
#
# **Ok means computed, not true** · about 45 minutes, 50 as a talk · builds on 04, 05 and 08
#
# After this chapter you can
#
# - choose the tool by the question, and say what that tool cannot show,
# - read `view_frames`, `tf2_echo` and `tf2_monitor`, including their traps,
# - say how often a transform has to be published at a given speed, and what a lower rate costs,
# - read RViz's list of displays, and tell "could be computed" from "is right".

# %% [markdown] lang="ko" name="title" slide="slide"
# # 11 · 도구와 RViz
#
# **Ok는 계산했다는 뜻이지 맞다는 뜻이 아닙니다** · 약 45분, 강의로는 50분 · 04, 05, 08장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 질문에 맞는 도구를 고르고, 그 도구로 알 수 없는 것을 말할 수 있습니다.
# - `view_frames`, `tf2_echo`, `tf2_monitor`의 출력을 읽고, 잘못 읽기 쉬운 곳을 짚을 수 있습니다.
# - 주어진 속도에서 변환이 얼마나 자주 와야 하는지, 덜 오면 무엇을 잃는지 계산할 수 있습니다.
# - RViz의 목록을 읽고, “계산할 수 있었다”와 “맞다”를 구별할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Ask: who has seen a green Ok beside a picture that was wrong? Collect one story. The chapter shows three that look alike.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 먼저 묻습니다. 목록은 모두 Ok인데 그림이 틀렸던 적이 있습니까? 하나만 들어 봅니다. 이 장에는 똑같이 보이는 고장 세 가지가 나옵니다.

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## Slow, by half a century
#
# "The transform between odom and base_link is being published very slow." That was the report, and the proof was two lines of [[tf2_monitor]]:
#
# ```
# Net delay     avg = 3.10486e+08: max = 1.6318e+09
# Frame: base_footprint, published by <no authority available>, Average Delay: 1.6318e+09, Max Delay: 1.6318e+09
# ```
#
# How slow is that? And why is the average so much smaller than the maximum, if every message was late by the same amount?

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 반세기나 느린 변환
#
# “odom과 base_link 사이의 변환이 아주 느리게 발행됩니다.” 이런 보고가 있었고, 증거는 [[tf2_monitor]]의 두 줄이었습니다.
#
# ```
# Net delay     avg = 3.10486e+08: max = 1.6318e+09
# Frame: base_footprint, published by <no authority available>, Average Delay: 1.6318e+09, Max Delay: 1.6318e+09
# ```
#
# 얼마나 느린 것일까요? 그리고 모든 메시지의 지연이 똑같다면 평균은 왜 최댓값보다 훨씬 작을까요?

# %% name="half-a-century" slide="fragment"
print(f'{1.6318e9 / (365.25 * 24 * 3600):.1f} years')
print(f'avg / max = {3.10486e8 / 1.6318e9:.6f}')
print(f'1 - 0.99 ** 21 = {1 - 0.99**21:.6f}')

# %% [markdown] lang="en" name="half-a-century-seen"
# It is not slow: it is **51.7 years**. That is the current system time minus a stamp of a simulation that began at 0. [[latency|Delay]] is *now minus stamp*. The rate is a different quantity, and this line does not contain it.
# And the average is not an average yet: it begins at 0 and moves by one hundredth of the remaining difference with each sample. The tool had taken 21 samples.

# %% [markdown] lang="ko" name="half-a-century-seen"
# 느린 것이 아닙니다. 1.6318e+09초는 **51.7년**이고, 시스템 시간에서 시뮬레이션의 측정 시각을 뺀 값입니다. 시뮬레이션은 0초에 시작했습니다. [[latency|지연(delay)]]은 *현재 시각 − 측정 시각*입니다. 발행률은 다른 질문이고, 이 줄에는 답이 없습니다.
# 그리고 이 평균은 아직 평균이 아닙니다. 0에서 시작해, 측정할 때마다 남은 차이의 100분의 1만큼 다가갑니다. 이 도구는 그때까지 21번 측정했습니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Six minutes, the title included. Give them a minute to divide 1.6318e9 s by a year, with a phone; open the output when somebody has said 51. The section on tf2_monitor explains why avg is a fifth of max.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 제목 슬라이드까지 합해 6분입니다. 1.6318e9초가 몇 년인지 계산하게 하고, 51이라는 답이 나오면 출력을 엽니다. avg가 max의 5분의 1인 까닭은 tf2_monitor에서 다룹니다.

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* [gazebo_ros_pkgs 1310](https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1310), still open; further below [ros2/ros2 1655](https://github.com/ros2/ros2/issues/1655), [geometry2 88](https://github.com/ros2/geometry2/issues/88).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* 지금도 열려 있는 [gazebo_ros_pkgs 1310](https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1310), 아래에 나오는 [ros2/ros2 1655](https://github.com/ros2/ros2/issues/1655), [geometry2 88](https://github.com/ros2/geometry2/issues/88).

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# Our robot has been driving for nine seconds. `tf2_monitor map laser_frame` prints its first report, `ros2 topic hz /tf` counts:
#
# ```
# Net delay     avg = 0.0209299: max = 0.11
# Frame: laser_frame, ... Average Delay: 9.6, Max Delay: 9.6
#
# average rate: 50.000
# ```
#
# 1. How late is the path from `map` to `laser_frame`: 0.021, 0.11 or 9.6 s?
# 2. How often does the wheel odometry publish: 10, 20 or 50 times a second?
# 3. The URDF says that the laser is 0.20 m *behind* `base_link`; it is mounted 0.20 m *in front of* it. Which line of RViz's list turns red?
# 4. You change RViz's Fixed Frame from `map` to `odom`. Does the robot's pose in `odom` change?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 로봇이 9초째 달리고 있습니다. `tf2_monitor map laser_frame`의 첫 보고와 `ros2 topic hz /tf`의 출력입니다.
#
# ```
# Net delay     avg = 0.0209299: max = 0.11
# Frame: laser_frame, ... Average Delay: 9.6, Max Delay: 9.6
#
# average rate: 50.000
# ```
#
# 1. 경로 `map ← laser_frame`의 지연은 얼마일까요? 0.021초, 0.11초, 9.6초 가운데 하나입니다.
# 2. 바퀴 오도메트리 노드는 1초에 몇 번 발행할까요? 10번, 20번, 50번 가운데 하나입니다.
# 3. URDF에는 레이저가 `base_link`에서 *뒤로* 0.20 m에 있다고 적혀 있지만, 실제로는 *앞으로* 0.20 m에 달려 있습니다. RViz 목록의 어느 줄에 오류가 나올까요?
# 4. RViz의 고정 좌표계(Fixed Frame)를 `map`에서 `odom`으로 바꿉니다. `odom` 기준 로봇의 포즈가 바뀔까요?

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# On paper, four lines, no talking. Do not give answers now: each is answered in its section.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 말없이 종이에 네 줄을 적게 합니다. 답은 지금 알려 주지 않습니다. 각 절에서 하나씩 다시 나옵니다.

# %% name="my-guess" slide="skip"
late_s, wheels_hz, red_line, pose_changes = ..., ..., ..., ...

# %% [markdown] lang="en" name="ask-first" slide="slide"
# ## Ask first, then type
#
# A tool that cannot answer your question still prints something. So choose the question first.
# Below, try seven tools on seven questions. The output is that of the tools, shortened. The line above the output states whether the tool answers the question.

# %% [markdown] lang="ko" name="ask-first" slide="slide"
# ## 질문부터 정하고, 그다음에 입력합니다
#
# 질문에 맞지 않는 도구도 무언가는 출력합니다. 그러니 질문부터 정합니다.
# 달리는 로봇을 두고 일곱 가지 질문마다 일곱 도구를 써 보세요. 출력은 실제 도구의 출력을 조금 줄인 것입니다. 질문에 맞는지는 출력 바로 위의 줄에 나옵니다.

# %% name="ask-first-panel" tags=["interactive", "collapsed"] slide="subslide"
# Start a robot, and put seven questions to seven tools.
lesson.start_robot()
lesson.tools_panel()

# %% name="ask-first-still" tags=["static"]
lesson.tools_panel().picture

# %% [markdown] lang="en" name="ask-first-notes" slide="notes"
# Four minutes with the table. Try the wrong tool first on two questions, then the right one: a wrong tool prints, too.

# %% [markdown] lang="ko" name="ask-first-notes" slide="notes"
# 표까지 합해 4분입니다. 질문 둘을 골라 먼저 틀린 도구를, 그다음 맞는 도구를 씁니다. 틀린 도구도 무언가를 출력합니다.

# %% name="ask-first-table" tags=["collapsed"] slide="subslide"
# Draw which tool answers which question.
lesson.draw_toolbox()

# %% [markdown] lang="en" name="ask-first-seen"
# In the figure, *delay* is how late a path is, *age* is how old a message is, and *look* is the picture in RViz.
#
# Every tool has gaps, and one row has no ✓ at all: **no ROS 2 tool names the [[owner]] of an edge**, the node that publishes it. `topic info --verbose` names the nodes that publish on `/tf`. The messages do not show which of them publishes which edge.
# The lecture uses `tf2_monitor` to find the broadcaster's name. The older tool `tf_monitor` of ROS 1 printed it. In ROS 2 every line of `tf2_monitor` has `<no authority available>`.

# %% [markdown] lang="ko" name="ask-first-seen"
# *그림 읽기:* frames = 좌표계와 트리, value = 값, rate = 발행률(1초에 몇 번 오는지, 단위 Hz), delay = 경로의 지연, age = 메시지의 나이, owner = 발행자, look = 보이는 모습. ✓ answers = 알 수 있음, ~ half = 반만 알 수 있음, ✗ cannot = 알 수 없음.
#
# 도구마다 알려 주지 못하는 것이 있고, ✓가 하나도 없는 행도 있습니다. **연결의 [[owner|발행 책임(owner)]]이 어느 노드에 있는지, 곧 누가 그 연결을 발행하는지 알려 주는 ROS 2 도구는 없습니다.** `topic info --verbose`로 `/tf`에 발행하는 노드들의 이름을 알 수 있지만, 어느 노드가 어느 연결을 발행하는지는 메시지 어디에도 없습니다.
# 강의에서는 `tf2_monitor`로 발행자 이름을 확인합니다. ROS 1의 `tf_monitor`는 이름을 출력했지만, ROS 2의 `tf2_monitor`에서는 어느 노드나 `<no authority available>`로 나옵니다.

# %% [markdown] lang="en" name="ask-first-table-notes" slide="notes"
# Ask which row has no tick. Wait until somebody says "the owner", and leave the question open: chapter 12 is about it.

# %% [markdown] lang="ko" name="ask-first-table-notes" slide="notes"
# ✓가 하나도 없는 행은 어느 것입니까? 발행 책임(owner) 행이라는 답이 나오면, 그 질문은 12장으로 미룹니다.

# %% [markdown] lang="en" name="monitor" slide="slide"
# ## tf2_monitor: how late?
#
# The robot drives for nine seconds. Then the tool starts. Its first report comes 10.5 s later.

# %% [markdown] lang="ko" name="monitor" slide="slide"
# ## tf2_monitor: 얼마나 늦을까요?
#
# 로봇이 9초 동안 달린 다음에 도구를 실행합니다. 첫 보고는 실행하고 10.5초가 지나면 나옵니다.

# %% name="monitor-robot" tags=["collapsed"] slide="skip"
# Start the robot, and let it drive for nine seconds.
graph = lesson.start_robot()
graph.run(seconds=9.1)

# %% name="monitor-run" slide="-"
# %ros2 run tf2_ros tf2_monitor map laser_frame

# %% [markdown] lang="en" name="monitor-seen"
# Line by line:
#
# - `Waiting for …`: the tool looks up the transform before it has received any. Your robot is fine.
# - `max = 0.11`: **the answer to question 1.** The localiser's newest stamp is 0.01 s old when it arrives, and up to another 0.1 s passes before the next one.
# - `avg = 0.0209299`: 19 % of 0.11, because the tool has taken 21 samples.
# - `laser_frame … 9.6`: a [[static transform|static]] transform was sent once, 9.6 s before the tool received it, and is valid at all times. Its age means nothing.
# - `50.3349 Hz`: the messages of all nodes together.
#
# What `avg` does if you let the tool run:

# %% [markdown] lang="ko" name="monitor-seen"
# 한 줄씩 읽습니다.
#
# - `Waiting for …`: 아직 아무 변환도 받지 못한 채 조회부터 하기 때문에 나옵니다. 로봇의 잘못이 아닙니다.
# - `max = 0.11`: **질문 1의 답입니다.** 위치 추정 노드의 최신 변환은 도착했을 때 이미 0.01초 전의 것이고, 다음 변환이 올 때까지 최대 0.1초가 더 지납니다.
# - `avg = 0.0209299`: 21번 측정했으므로 0.11의 19 %입니다.
# - `laser_frame … 9.6`: [[static transform|정적 변환]]은 도구가 받기 9.6초 전에 한 번 보냈고 언제까지나 유효합니다. 이 나이는 지연이 아닙니다.
# - `50.3349 Hz`: 모든 발행자를 합친 값입니다.
#
# 계속 켜 두면 `avg`는 이렇게 됩니다.

# %% [markdown] lang="en" name="monitor-run-notes" slide="notes"
# Eight minutes with the curve. Before you read line by line, everybody underlines the one number that they would report.

# %% [markdown] lang="ko" name="monitor-run-notes" slide="notes"
# 곡선까지 합해 8분입니다. 한 줄씩 읽기 전에, 보고하고 싶은 숫자 하나에 밑줄을 긋게 합니다.

# %% name="monitor-average" tags=["collapsed"] slide="subslide"
# Draw how avg approaches the true delay.
looks = range(0, 481, 4)  # two a second, for four minutes
times = [0.5 * n for n in looks]
avg = lesson.Curve('avg', times, [0.11 * (1 - 0.99**n) for n in looks])
lesson.draw_ages([lesson.Curve('truth', times, [0.11] * len(times)), avg], 'net delay')

# %% [markdown] lang="en" name="monitor-average-seen"
# `avg` is 19 % of the true delay at first, half after 34 s, 91 % after two minutes.
# So read `max`, and the lines of the frames that move. One more trap: `max` begins at 0, so stamps from the future, which give a negative delay, show as `Max Delay: 0`, which looks perfect. Their `Average Delay` is negative: look there. (One negative delay is intended: AMCL stamps `map → odom` with a time in the future, by its `transform_tolerance`, so that no node has to wait for it.)
#
# And if a path is sometimes missing, the tool cannot report that. It ends at the first lookup that fails, with `terminate called after throwing an instance of 'tf2::ConnectivityException'`.

# %% [markdown] lang="ko" name="monitor-average-seen"
# *그림 읽기:* net delay = 경로의 지연, truth = 실제 지연, avg = 도구가 출력하는 평균, time = 시각.
#
# `avg`는 첫 보고에서 실제 지연의 19 %, 34초가 지나면 절반, 2분이 지나면 91 %입니다.
# 그러니 `max`와, 움직이는 좌표계의 줄을 읽습니다. 주의할 것이 하나 더 있습니다. `max`는 0에서 시작하므로 측정 시각이 미래여서 지연이 음수이면 `Max Delay: 0`으로 나와 정상처럼 보입니다. 이때는 `Average Delay`가 음수이므로 그 값을 보십시오. (일부러 음수로 만든 지연도 있습니다. AMCL은 기다리는 노드가 없도록 `map → odom`에 `transform_tolerance`만큼 미래의 시각을 적습니다.)
# 경로가 연결되었다 끊어졌다 하면 `tf2_monitor`는 그것을 보고하지 못하고 종료됩니다. 조회가 처음 실패할 때 `terminate called after throwing an instance of 'tf2::ConnectivityException'`을 출력합니다.

# %% [markdown] lang="en" name="monitor-notes" slide="notes"
# Let somebody read the first report aloud and say "so it is late by two hundredths". Wait. Then ask what 0.0209 divided by 0.11 is.

# %% [markdown] lang="ko" name="monitor-notes" slide="notes"
# 한 사람에게 첫 보고를 읽게 합니다. 나올 법한 오답은 “0.02초 늦네요”입니다. 그런 다음 0.0209를 0.11로 나누면 얼마인지 묻습니다.

# %% [markdown] lang="en" name="rates" slide="slide"
# ## view_frames: how often is one edge published?
#
# `topic hz` counts the messages of a topic. Three nodes share `/tf`.

# %% [markdown] lang="ko" name="rates" slide="slide"
# ## view_frames: 연결 하나의 발행률은 얼마일까요?
#
# `topic hz`는 토픽의 메시지를 셉니다. `/tf`는 세 노드가 함께 씁니다.

# %% name="rates-hz" slide="-"
# %ros2 --for 1.5 topic hz /tf
# %ros2 topic info /tf

# %% [markdown] lang="en" name="rates-notes" slide="notes"
# Eight minutes from here to tf2_echo. 50: of which node? Three nodes share the topic, 20 and 20 and 10.

# %% [markdown] lang="ko" name="rates-notes" slide="notes"
# 여기서 tf2_echo까지 8분입니다. 50은 어느 노드의 것입니까? 세 노드가 토픽을 함께 씁니다. 20, 20, 10입니다.

# %% name="rates-view-frames" slide="subslide"
# %ros2 run tf2_tools view_frames -o frames

# %% [markdown] lang="en" name="rates-seen" slide="subslide"
# The long line is the reply of a service (a call that a node answers), and the picture is drawn from it (on a robot: `frames.pdf` and `frames.gv`; without `-o` their names contain date and time). In the picture, each edge has its own `Average rate`:
#
# - `odom → base_footprint` 20.204 and `map → odom` 10.208: **the answer to question 2 is 20**. The 50 of `topic hz` is 20 + 20 + 10. (`view_frames` divides n samples by the time from the first to the last. With n − 1 its 20.204 would be 20.0.)
# - static edges have 10000.0, which is not a rate: tf2 divides the number of samples by at least 0.0001 s, and a static edge has one sample.
# - `default_authority` everywhere: no owner here either.
#
# It is a **[[snapshot]]** of five seconds. It probably misses what happens once a minute.

# %% [markdown] lang="ko" name="rates-seen" slide="subslide"
# 긴 줄은 서비스 호출(노드에 보내는 요청)의 응답이고, 그림은 그 응답으로 그린 것입니다(로봇에서는 `frames.pdf`와 `frames.gv`가 생기고, `-o`가 없으면 이름에 날짜와 시각이 들어갑니다). 그림에는 연결마다 `Average rate`(평균 발행률)가 있습니다.
#
# - `odom → base_footprint` 20.204, `map → odom` 10.208입니다. **질문 2의 답은 20입니다.** `topic hz`의 50은 20 + 20 + 10입니다. (도구는 표본의 수 n을 첫 표본과 마지막 표본 사이의 시간으로 나눕니다. n − 1을 나누면 20.0입니다.)
# - 정적 연결의 10000.0은 발행률이 아닙니다. tf2는 표본 수를 적어도 0.0001초로 나누는데, 정적 연결은 표본이 하나입니다.
# - 모든 연결이 `default_authority`이므로 여기서도 발행자는 알 수 없습니다.
#
# 5초 동안의 [[snapshot|스냅샷]]이라서, 1분에 한 번 일어나는 일은 거의 놓칩니다.

# %% [markdown] lang="en" name="view-frames-notes" slide="notes"
# Find one edge together, `odom → base_footprint`, and read its rate. 10000 is not a rate: it is one sample divided by 0.0001 s.

# %% [markdown] lang="ko" name="view-frames-notes" slide="notes"
# 연결 하나(`odom → base_footprint`)를 함께 찾아 발행률을 읽습니다. 10000은 발행률이 아니라 표본 하나를 0.0001초로 나눈 값입니다.

# %% [markdown] lang="en" name="six-points" slide="subslide"
# The lecture (section 12) reads six things from this picture:
#
# - Is the tree in one piece?
# - Is the order `map → odom → base_link` right?
# - Is each sensor below the right parent?
# - Is a name misspelt, or a prefix wrong?
# - Are the rates and the oldest transforms normal?
# - Does one node alone publish each child? This the picture cannot show: it draws one parent for each frame, and no owner.

# %% [markdown] lang="ko" name="six-points" slide="subslide"
# 강의 12절에서는 이 그림에서 여섯 가지를 확인합니다.
#
# - 트리가 한 덩어리로 연결되어 있습니까?
# - `map → odom → base_link`의 순서가 맞습니까?
# - 센서 좌표계가 올바른 부모 아래에 있습니까?
# - 예상하지 않은 철자나 접두사가 있습니까?
# - 발행률과 가장 오래된 변환이 정상입니까?
# - 자식마다 발행하는 노드가 하나입니까? 이것은 그림으로 알 수 없습니다. 부모는 하나만 그려지고 발행자는 나오지 않습니다.

# %% [markdown] lang="en" name="two-owners" slide="subslide"
# Still, the picture shows that there are two publishers. **Predict:** a second node, the EKF, publishes `odom → base_footprint` too, 30 times a second. What is the edge's rate?

# %% [markdown] lang="ko" name="two-owners" slide="subslide"
# 그래도 발행자가 둘이면 드러납니다. **예측해 봅시다.** 두 번째 노드인 EKF도 `odom → base_footprint`를 1초에 30번 발행합니다. 이 연결의 발행률은 얼마로 나올까요?

# %% name="two-owners-robot" tags=["predicted", "collapsed"] slide="skip"
# Start a robot whose EKF publishes the edge, too.
graph = lesson.start_robot(also=['ekf_filter_node'])

# %% name="two-owners-tree" tags=["predicted"]
# %ros2 run tf2_tools view_frames -o frames

# %% [markdown] lang="en" name="two-owners-seen" tags=["predicted"]
# **50.1 Hz where 20.2 is normal.** More messages than one node sends means more than one node. `ros2 topic info /tf --verbose` lists the nodes that can be the second owner; chapter 12 finds out which of them it is.

# %% [markdown] lang="ko" name="two-owners-seen" tags=["predicted"]
# **평소에는 20.2 Hz인데 50.1 Hz입니다.** 노드 하나의 발행률보다 높으면 노드가 하나가 아닌 것입니다. 두 번째 발행자일 수 있는 노드는 `ros2 topic info /tf --verbose`로 알 수 있고, 그 가운데 어느 노드인지는 12장에서 찾습니다.

# %% [markdown] lang="en" name="two-owners-notes" slide="notes"
# Vote with fingers, one for each 10 Hz: 20, 30 or 50 Hz? On a robot you would have the 50 alone, and no names beside it.

# %% [markdown] lang="ko" name="two-owners-notes" slide="notes"
# 손가락 하나를 10 Hz로 하여 답하게 합니다. 20 Hz, 30 Hz, 50 Hz 가운데 무엇입니까? 로봇에서는 50만 보이고 이름은 없습니다.

# %% [markdown] lang="en" name="echo" slide="slide"
# ## tf2_echo: which value?
#
# [[tf2_echo]] prints the pose of its second frame in its first, by default once a second.

# %% [markdown] lang="ko" name="echo" slide="slide"
# ## tf2_echo: 값은 얼마일까요?
#
# [[tf2_echo]]는 첫째 좌표계를 기준으로 한 둘째 좌표계의 포즈를 출력합니다. 따로 정하지 않으면 1초에 한 번입니다.

# %% name="echo-robot" tags=["collapsed"] slide="skip"
# Start the robot, and let it drive for twenty seconds.
graph = lesson.start_robot()
graph.run(seconds=20.15)

# %% name="echo-run" slide="-"
# %ros2 --for 2.5 run tf2_ros tf2_echo map laser_frame

# %% [markdown] lang="en" name="echo-predict"
# **Predict:** `At time 22.90000000`. Which time is that?

# %% [markdown] lang="ko" name="echo-predict"
# **예측해 봅시다.** `At time 22.90000000`은 몇 초일까요?

# %% name="echo-stamp" tags=["predicted"] slide="fragment"
sec, nanosec = ['22', '90000000']
print(f'{int(sec) + int(nanosec) / 1e9:.3f} s')

# %% [markdown] lang="en" name="echo-seen" tags=["predicted"]
# **22.090 s**: the part after the point is a number of nanoseconds, printed without its leading zeros. With nine digits, the first one is the tenths of a second. With eight digits, it is the hundredths.
# Two more facts about the tool:
#
# - For two frames with only static edges between them it prints `At time 0.0`. Such a value is valid at all times.
# - It *samples*. You do not see what goes wrong between two prints. If something flickers, choose a higher rate: `tf2_echo map base_link 20`.

# %% [markdown] lang="ko" name="echo-seen" tags=["predicted"]
# **22.090초**입니다. 점 뒤는 나노초이고, 첫머리의 0은 출력되지 않습니다. 아홉 자리면 0.1초 자리부터, 여덟 자리면 0.01초 자리부터입니다.
#
# 알아 둘 것이 두 가지 더 있습니다.
#
# - 사이에 정적 연결만 있는 두 좌표계는 `At time 0.0`으로 나옵니다. 언제나 유효하다는 뜻입니다.
# - *1초에 한 번만 조회합니다.* 두 출력 사이에 일어난 일은 보이지 않습니다. 무언가 깜빡이면 `tf2_echo map base_link 20`처럼 더 자주 출력하게 합니다.

# %% [markdown] lang="en" name="echo-notes" slide="notes"
# One sentence: the part after the point is nanoseconds without their leading zeros. E11.2 asks for it again.

# %% [markdown] lang="ko" name="echo-notes" slide="notes"
# 한 문장만 말합니다. 소수점 오른쪽은 앞자리 0이 빠진 나노초입니다. E11.2에서 다시 묻습니다.

# %% [markdown] lang="en" name="often-enough" slide="slide"
# ## Often enough?
#
# Between two samples TF interpolates the position along a straight line, and the rotation at a constant rate. How large is the error at a constant speed of half a metre per second?
#
# **Predict:** odometry is published once a second instead of twenty times. How far off is the robot, at worst, on a straight line? And in a curve of 1 rad/s?

# %% [markdown] lang="ko" name="often-enough" slide="slide"
# ## 발행률은 충분할까요?
#
# TF는 두 표본 사이를 직선으로 보간합니다(회전도 고르게 나눕니다). 0.5 m/s의 일정한 속도로 달릴 때 오차는 얼마일까요?
# **예측해 봅시다.** 오도메트리가 1초에 20번이 아니라 한 번 옵니다. 로봇의 위치는 최대 얼마나 틀릴까요? 곧은 길에서는? 1 rad/s로 회전하는 길에서는?

# %% name="often-enough-table" tags=["predicted"] slide="fragment"
import math

v, w = 0.5, 1.0
print('rate     straight   curve       wait at most')
for f in (1, 2, 10, 20):
    gap = v / w * (1 - math.cos(w / (2 * f)))
    wait = 1 / f + 0.004 - 0.105  # a period and the way of a transform, minus the way of the scan
    print(f'{f:>2} Hz    {0.0:.1f} mm     {1000 * gap:5.2f} mm    {max(0.0, wait):.3f} s')

# %% [markdown] lang="en" name="often-enough-seen" tags=["predicted"]
# On a straight line at constant speed: **nothing**, at any rate. Between two samples the robot, too, moves evenly along the line.
# In a curve (*bend* in the table) TF cuts the corner: the path is an arc, the interpolation its chord, and the error is (v/ω)(1 − cos(ω/2f)). Here v is the speed, ω the yaw rate [rad/s] and f the rate [Hz]. That is 61 mm at 1 Hz and 0.6 mm at 10 Hz. At half the rate the error is four times as large.
#
# What a slow edge can cost even on a straight line is **waiting**: a scan can be placed only when the next sample has arrived. Our scan takes 0.105 s to arrive, so at 10 and 20 Hz it never waits for a sample. At 1 Hz it waits up to 0.9 s.
# The lecture is right to warn of a slow `odom → base_link`. Its formula v · Δt is how far the robot drives *while you wait*, or the error if a node uses the newest pose instead of waiting. It is not the error of TF's interpolation.

# %% [markdown] lang="ko" name="often-enough-seen" tags=["predicted"]
# (표에서 straight는 곧은 길, bend는 굽은 길, wait at most는 가장 긴 기다림입니다.)
#
# 곧은 길을 일정한 속도로 달리면 발행률이 얼마든 **조금도 틀리지 않습니다.** 두 표본 사이에서 로봇도 그 직선 위를 고르게 움직이기 때문입니다.
# 굽은 길에서는 TF가 보간한 선이 길의 안쪽을 지납니다. 로봇이 실제로 달린 선은 호, 보간한 선은 현이고, 가장 큰 틈은 (v/ω)(1 − cos(ω/2f))입니다. v는 속도, ω는 각속도[rad/s], f는 발행률[Hz]입니다. 1 Hz에서 61 mm, 10 Hz에서 0.6 mm입니다. 발행률이 절반이면 틈은 네 배입니다.
#
# 발행률이 낮은 연결에는 곧은 길에서도 **기다림**이 따를 수 있습니다. 다음 표본이 와야 스캔의 위치를 계산할 수 있습니다. 스캔은 이미 0.105초 걸려 왔으므로 10 Hz와 20 Hz에서는 기다리지 않고, 1 Hz에서는 0.9초까지 기다립니다.
# 강의에서 느린 `odom → base_link`를 경고하는 것은 옳습니다. 다만 강의의 식 v · Δt는 *기다리는 동안*, 또는 기다리지 않고 최신 포즈를 쓸 때 로봇이 달린 거리입니다. TF가 위치를 그만큼 틀리게 계산한다는 뜻은 아닙니다.

# %% [markdown] lang="en" name="often-enough-try"
# Try it with the sliders: at which rate is the error (the *gap*) below a millimetre, at 1 m/s and 1 rad/s? And which yaw rate gives no error at all?
#
# <details><summary>Answers</summary>
#
# From 11.2 Hz on. On the slider that is 11.5 Hz (0.95 mm). And a yaw rate of 0: straight ahead.
#
# </details>

# %% [markdown] lang="ko" name="often-enough-try"
# 슬라이더를 직접 움직여 보세요. 1 m/s, 1 rad/s에서 틈이 1 mm보다 작아지는 발행률은 얼마일까요? 틈이 아예 없으려면 yaw rate가 얼마여야 할까요?
#
# <details><summary>답</summary>
#
# 11.2 Hz부터입니다. 슬라이더에서는 11.5 Hz입니다(0.95 mm). yaw rate는 0, 곧 직진입니다.
#
# </details>
#
# *그림 읽기:* arc = 로봇이 달린 호, chord = TF가 보간한 현, gap = 둘 사이의 틈, samples = 표본, v/f = 표본 사이에 달린 거리, wait = 가장 긴 기다림. speed = 속도, yaw rate = 각속도, rate = 발행률.

# %% name="often-enough-panel" tags=["interactive", "collapsed"] slide="subslide"
# Show arc and chord at a speed, a yaw rate and a rate.
lesson.rate_panel()

# %% name="often-enough-still" tags=["static"]
lesson.draw_bend(lesson.Bend(speed_mps=0.5, yaw_rate_radps=1.0, rate_hz=1.0))

# %% [markdown] lang="en" name="often-enough-notes" slide="notes"
# Two minutes, the answer only: nothing on a straight line, 61 mm at 1 Hz in a curve, up to 0.9 s of waiting. The panel is for reading.

# %% [markdown] lang="ko" name="often-enough-notes" slide="notes"
# 2분 동안 답만 봅니다. 곧은 길에서는 0, 굽은 길에서는 1 Hz일 때 61 mm, 기다림은 최대 0.9초입니다. 패널은 각자 읽을 때 씁니다.

# %% [markdown] lang="en" name="often-enough-still-notes" slide="notes"
# Hold a ruler against the arc: that is TF between two samples.

# %% [markdown] lang="ko" name="often-enough-still-notes" slide="notes"
# 호에 자를 대어 보입니다. 두 표본 사이에서 TF의 보간은 그 자와 같습니다.

# %% [markdown] lang="en" name="rviz" slide="slide"
# ## RViz: one frame for everything
#
# [[rviz]] transforms each message **at its own stamp** into one frame, the [[fixed frame]], and draws it. Each entry of its list is a *display* and draws one kind of data. What it cannot transform it leaves out, and reports in the list as the [[display status]].
# Choose another Fixed Frame, rotate the scene with the mouse, open a line of the list.

# %% [markdown] lang="ko" name="rviz" slide="slide"
# ## RViz: 모든 데이터를 한 좌표계 기준으로
#
# [[rviz]]는 메시지를 하나씩 **그 메시지의 측정 시각으로** [[fixed frame|고정 좌표계(Fixed Frame)]] 기준으로 바꿔 그립니다. 목록의 항목 하나가 *디스플레이*이고, 디스플레이마다 한 종류의 데이터를 그립니다. 바꾸지 못한 것은 그리지 않고 목록에 적습니다. 이것이 [[display status|디스플레이 상태]]입니다.
# 고정 좌표계를 바꾸고, 마우스로 시점을 돌리고, 목록의 줄을 펼쳐 보세요.

# %% name="rviz-robot" tags=["collapsed"] slide="skip"
# Start the robot, and let it drive for 24 seconds.
graph = lesson.start_robot()
graph.run(seconds=24)

# %% name="rviz-live" tags=["interactive"] slide="subslide"
# %rviz2 -f map

# %% name="rviz-still" tags=["static"]
lesson.start_robot()
lesson.draw_rviz(until_s=25.0)

# %% [markdown] lang="en" name="rviz-notes" slide="notes"
# Four minutes with the still picture. Change the Fixed Frame, and let them say what moves before it does.

# %% [markdown] lang="ko" name="rviz-notes" slide="notes"
# 정지 그림까지 합해 4분입니다. 고정 좌표계를 바꾸기 전에 무엇이 움직일지 말하게 합니다.

# %% [markdown] lang="en" name="rviz-seen"
# The figure shows the robot from above: the walls are grey, and what the laser measured in the last second is coloured (the [[decay time]] is 1 s here). Below it is the list. The scans are on the walls to within some centimetres: the robot is in a curve, and a sweep takes 0.1 s.
#
# **Question 4.** RViz calls `lookup_transform` with the Fixed Frame as target. Do the same for three Fixed Frames, and look up the robot's pose in `odom` each time:

# %% [markdown] lang="ko" name="rviz-seen"
# *그림 읽기:* 위에서 본 모습입니다. 회색은 벽, 색이 있는 점은 레이저가 지난 1초 동안 본 것입니다(점이 남는 시간인 [[decay time|Decay Time]]이 여기서는 1초입니다). 아래는 RViz의 목록입니다. 스캔이 벽 위에 놓이고 몇 센티미터만 벗어납니다. 로봇이 회전하는 중이고 레이저가 한 번 훑는 데 0.1초가 걸리기 때문입니다.
#
# **질문 4.** RViz는 고정 좌표계를 목표로 `lookup_transform`을 호출합니다. 고정 좌표계 셋으로 똑같이 해 보고, 그때마다 `odom` 기준 로봇의 포즈도 조회합니다.

# %% name="fixed-frame-robot" tags=["predicted", "collapsed"] slide="skip"
# Start the robot again, and let it drive for 24 seconds.
graph = lesson.start_robot()
graph.run(seconds=24)

# %% name="fixed-frame" tags=["predicted"] slide="fragment"
import rclpy
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener

rclpy.init()
node, buffer = Node('viewer'), Buffer()
listener = TransformListener(buffer, node, spin_thread=True)
graph.run(seconds=1)
for fixed_frame in ('map', 'odom', 'base_link'):
    laser = buffer.lookup_transform(fixed_frame, 'laser_frame', Time()).transform.translation
    robot = buffer.lookup_transform('odom', 'base_footprint', Time()).transform.translation
    print(f'{fixed_frame:<9}  laser at ({laser.x:.3f}, {laser.y:.3f})   robot in odom ({robot.x:.3f}, {robot.y:.3f})')
rclpy.shutdown()

# %% [markdown] lang="en" name="fixed-frame-seen" tags=["predicted"]
# The picture changes, the data does not. A Fixed Frame is a point of view. If you change it, nothing is published, nothing is stored, and no other node is affected. (Only a goal or an initial pose that you send with RViz's own tools is expressed in the Fixed Frame.)
# Use `map` to see whether scans are on the map, `odom` to see whether odometry is smooth without the localiser's jumps, `base_link` to see the data relative to the robot. Choosing `odom` because "it does not jump there" fixes nothing.

# %% [markdown] lang="ko" name="fixed-frame-seen" tags=["predicted"]
# 그림은 움직이지만 데이터는 그대로입니다. 고정 좌표계는 그림의 기준일 뿐입니다. 바꾸어도 발행되거나 저장되는 것은 없고, 다른 노드에 영향이 없습니다. (RViz의 도구로 보내는 목적지와 초기 포즈만 고정 좌표계를 기준으로 합니다.)
# 스캔이 지도와 맞는지 볼 때는 `map`, 위치 추정 때문에 튀는 일 없이 오도메트리가 연속인지 볼 때는 `odom`, 로봇을 기준으로 볼 때는 `base_link`를 씁니다. “odom에서는 튀지 않으니까” `odom`을 고른다고 해서 고쳐지는 것은 없습니다.

# %% [markdown] lang="en" name="fixed-frame-notes" slide="notes"
# Show it with your head: turn it to the left. Did the room rotate?

# %% [markdown] lang="ko" name="fixed-frame-notes" slide="notes"
# 고개를 왼쪽으로 돌려 보입니다. 방이 회전했습니까?

# %% [markdown] lang="en" name="ok-is-not-true" slide="slide"
# ## Ok is not true
#
# A team's scan moved along with the robot. Their report had four ticks: the scan is published ✔, it is there in RViz ✔, the static transform is set correctly ✔, odometry is dynamic ✔. Every tick was true. The lidar's orientation in the URDF was off by 180° (ros2/ros2 1655).
#
# Here are three robots, each with one mistake. **Predict** for each: which line of the list turns red?
#
# - **mount**: the URDF has −0.20 m instead of 0.20 (question 3);
# - **header**: the laser's driver writes `base_link` into its header;
# - **clock**: the laser's computer is 0.3 s behind.

# %% [markdown] lang="ko" name="ok-is-not-true" slide="slide"
# ## Ok는 맞다는 뜻이 아닙니다
#
# 어느 팀의 스캔이 로봇을 따라 움직였습니다. 보고에는 ✔가 네 개 있었습니다. 스캔이 발행된다 ✔, RViz에 보인다 ✔, 정적 변환이 올바르다 ✔, 오도메트리가 동적이다 ✔. ✔는 모두 사실이었습니다. 그런데 URDF에서 라이다의 방향이 180° 틀려 있었습니다(ros2/ros2 1655).
#
# 다음 로봇 세 대에는 실수가 하나씩 있습니다. 각각 목록의 어느 줄에 오류가 나올지 **예측해 봅시다.**
#
# - **mount**: URDF에 0.20 m 대신 −0.20 m라고 적혀 있습니다(질문 3).
# - **header**: 레이저 드라이버가 헤더에 `base_link`라고 적습니다.
# - **clock**: 레이저를 읽는 컴퓨터의 시계가 0.3초 뒤처져 있습니다.

# %% [markdown] lang="en" name="ok-is-not-true-notes" slide="notes"
# Five minutes for the three robots. Stop at the four ticks: which one was false? None. Then let them vote on paper, once for each robot.

# %% [markdown] lang="ko" name="ok-is-not-true-notes" slide="notes"
# 로봇 셋에 5분입니다. ✔ 네 개에서 멈추고 묻습니다. 사실이 아닌 것은 어느 것입니까? 없습니다. 그다음 로봇마다 오류가 나올 줄을 종이에 적게 합니다.

# %% name="three-robots-mount" tags=["predicted", "collapsed"] slide="subslide"
# Draw what RViz shows of the robot with the wrong mount.
lesson.start_robot('mount')
lesson.draw_rviz(until_s=25.0)

# %% [markdown] lang="en" name="three-robots-mount-notes" slide="notes"
# Who has a red line on paper? Let the class find the wall that does not fit. Ask what they would compare it with (the drawing).

# %% [markdown] lang="ko" name="three-robots-mount-notes" slide="notes"
# 빨간 줄을 적은 사람이 있습니까? 맞지 않는 벽을 함께 찾습니다. 무엇과 비교할까요? 도면입니다.

# %% name="three-robots-header" tags=["predicted", "collapsed"] slide="subslide"
# Draw what RViz shows of the robot with the wrong header.
lesson.start_robot('header')
lesson.draw_rviz(until_s=25.0)

# %% [markdown] lang="en" name="three-robots-header-notes" slide="notes"
# The same list again. Ask what they would compare the header with (the driver's manual). If time is short, leave out this robot first.

# %% [markdown] lang="ko" name="three-robots-header-notes" slide="notes"
# 또 같은 목록입니다. 헤더는 무엇과 비교할까요? 드라이버의 설명서입니다. 시간이 모자라면 여기를 건너뜁니다.

# %% name="three-robots-clock" tags=["predicted", "collapsed"] slide="subslide"
# Draw what RViz shows of the robot with the slow clock.
lesson.start_robot('clock')
lesson.draw_rviz(until_s=25.0)

# %% [markdown] lang="en" name="three-robots-seen" tags=["predicted"]
# **None.** All three lists are identical to that of the healthy robot. The points are 0.20, 0.12 and 0.30 m off the walls on average (healthy 0.05), and only your eye, or the map, shows it.
# *Ok* means: RViz could compute where to draw it. No tool can check whether the numbers, the frame name or the stamp are true; it has nothing to compare them with. You have: the drawing, the driver's manual, the clock.

# %% [markdown] lang="ko" name="three-robots-seen" tags=["predicted"]
# **어느 줄에도 오류가 나오지 않습니다.** 세 목록은 정상인 로봇의 목록과 한 글자도 다르지 않습니다. 점은 벽에서 평균 0.20, 0.12, 0.30 m 벗어나 있지만(정상인 로봇은 0.05 m), 지도를 깔고 눈으로 보아야만 알 수 있습니다.
# *Ok*는 어디에 그릴지 계산할 수 있었다는 뜻입니다. 입력된 숫자, 이름, 시각이 사실인지는 어떤 도구로도 알 수 없습니다. 비교할 것이 없기 때문입니다. 여러분에게는 비교할 것이 있습니다. 도면, 드라이버 설명서, 시계입니다.

# %% [markdown] lang="en" name="three-robots-notes" slide="notes"
# Vote before each picture: LaserScan, RobotModel, TF, none. By the third robot the class has learned it; then ask what would have to be compared with what.

# %% [markdown] lang="ko" name="three-robots-notes" slide="notes"
# 그림마다 먼저 손을 들게 합니다. LaserScan, RobotModel, TF, 없음 가운데 하나입니다. 세 번째 로봇쯤이면 모두 압니다. 그때 무엇을 무엇과 비교해야 하는지 묻습니다.

# %% [markdown] lang="en" name="one-minute" slide="slide"
# ### One minute each
#
# Three commands, each with something to compare: the mount with the drawing or a ruler, the header's `frame_id` with the frame of the sensor, the age with the duration of a sweep.
# Try them on each of the robots: change the name in the first line.

# %% [markdown] lang="ko" name="one-minute" slide="slide"
# ### 1분이면 됩니다
#
# 명령 세 개에는 저마다 비교할 것이 있습니다. 장착 변환은 도면이나 자로 잰 값과, 헤더의 `frame_id`는 센서의 좌표계와, 나이는 레이저가 한 번 훑는 시간과 비교합니다.
# 첫 줄의 이름을 바꾸어 가며 로봇마다 실행해 보세요.

# %% name="one-minute-mount" slide="-"
lesson.start_robot('mount').run(seconds=5)
# %ros2 --for 1.5 run tf2_ros tf2_echo base_link laser_frame

# %% name="one-minute-header" slide="-"
lesson.start_robot('header').run(seconds=5)
# %ros2 topic echo /scan --once --field header

# %% name="one-minute-clock" slide="-"
lesson.start_robot('clock').run(seconds=5)
# %ros2 --for 1.2 topic delay /scan

# %% [markdown] lang="en" name="one-minute-seen"
# −0.200 where the ruler shows +0.20. `base_link` where the laser's frame is `laser_frame`. 0.405 s where a sweep and its transport take 0.105.

# %% [markdown] lang="ko" name="one-minute-seen"
# 장착 변환은 −0.200으로 나오는데 자로 재면 +0.20입니다. 헤더에는 `base_link`라고 적혀 있는데 레이저의 좌표계는 `laser_frame`입니다. 나이는 0.405초인데 한 번 훑고 전송하는 데는 0.105초면 됩니다.

# %% [markdown] lang="en" name="one-minute-notes" slide="notes"
# In pairs, a minute each. Before typing they say the correct value.

# %% [markdown] lang="ko" name="one-minute-notes" slide="notes"
# 두 사람씩 로봇 하나에 1분을 씁니다. 입력하기 전에 정상인 값을 먼저 말합니다.

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it
#
# Two faults whose lists begin with the same red line. **Predict** before each: which displays fail? First, the localiser stops (Ctrl-C in its terminal), and RViz is opened a while later.

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기
#
# 목록의 첫 오류 줄이 같은 고장 두 가지입니다. 매번 어느 디스플레이가 실패할지 **예측해 봅시다.** 먼저 위치 추정 노드를 멈추고(터미널에서 Ctrl-C) 한참 뒤에 RViz를 엽니다.

# %% name="break-localization" tags=["predicted", "collapsed"]
# Stop the localiser, and draw what RViz shows.
lesson.start_robot().run(seconds=5)
lesson.stop_node('localization')
lesson.draw_rviz()

# %% [markdown] lang="en" name="break-localization-seen" tags=["predicted"]
# `Frame [map] does not exist`: only the localiser published `map`. The robot is fine, the sensors are fine. And **`Map: Ok`**: the map's message is in `map`, and from `map` to `map` no transform is needed. Map Ok does not mean that the localiser runs.

# %% [markdown] lang="ko" name="break-localization-seen" tags=["predicted"]
# `Frame [map] does not exist`: `map`을 발행하던 노드는 위치 추정 노드뿐이었습니다. 로봇도 센서도 정상입니다. 그런데 **`Map: Ok`**입니다. 지도 메시지는 `map` 기준이고, `map` 기준의 데이터를 `map` 기준으로 바꿀 때는 TF가 필요 없습니다. Map이 Ok라고 해서 위치 추정 노드가 실행 중이라는 뜻은 아닙니다.

# %% [markdown] lang="en" name="break-capital-predict" slide="subslide"
# Second, a capital letter: Fixed Frame `Map`.

# %% [markdown] lang="ko" name="break-capital-predict" slide="subslide"
# 둘째는 대문자 하나입니다. 고정 좌표계가 `Map`입니다.

# %% name="break-capital" tags=["predicted", "collapsed"]
# Draw what RViz shows with the Fixed Frame Map.
lesson.start_robot().run(seconds=5)
lesson.draw_rviz(fixed_frame='Map')

# %% [markdown] lang="en" name="break-capital-seen" tags=["predicted"]
# The same first line, another cause: now the list below TF *contains* `map`, and even Map fails. If a name does not exist and a similar one does, it is misspelt. If there is no similar one, its node is not running.

# %% [markdown] lang="ko" name="break-capital-seen" tags=["predicted"]
# 첫 줄은 같지만 원인이 다릅니다. 이번에는 TF 목록에 `map`이 *있고*, Map 디스플레이까지 실패합니다. 없는 이름 옆에 비슷한 이름이 있으면 잘못 입력한 것이고, 어디에도 없으면 그 이름을 발행하는 노드가 멈춘 것입니다.

# %% [markdown] lang="en" name="break-notes" slide="notes"
# Before you show the table, name each symptom, and let the class call out the node that they would check first. If they call "the sensor", answer "its messages arrived".

# %% [markdown] lang="ko" name="break-notes" slide="notes"
# 표를 보이기 전에 증상마다 외치게 합니다. 무엇을 먼저 확인하겠습니까? “센서”라는 답에는 “메시지는 왔습니다”라고 답합니다.

# %% [markdown] lang="en" name="symptoms" slide="slide"
# ### What the list shows, and where to look first
#
# | you see | likely | first check |
# |---|---|---|
# | `Frame [x] does not exist`, and no name like it in TF | its publisher is not running, or waits (AMCL: for an initial pose) | `ros2 node list`, its log |
# | the same, and a name like it | misspelt | the spelling in RViz, and in the node |
# | RobotModel: some links | URDF, joint states | `ros2 topic hz /joint_states` |
# | `not part of the same tree` | an edge without a publisher | `view_frames`: the two roots |
# | all Ok, off the walls even when it stands still | a mount, or the header's frame | `tf2_echo base_link laser_frame`, `--field header` |
# | all Ok, right when it stands still, smeared in curves | stamps, clocks | `topic delay /scan` |
# | all Ok, alternating between two positions | two publishers | the edge's rate in `view_frames`; `topic info --verbose` |
# | nothing at all: `No messages received` | no publisher, or an incompatible QoS: most lasers offer `BEST_EFFORT`, RViz requests `RELIABLE` | `topic info /scan --verbose`; in RViz, the display's Reliability Policy |
#
# Rows 3, 4 and 7 are shown in *More faults in RViz* below.
# "Not in RViz, so the sensor is broken" is in no row. Suspect the sensor last, and look at its messages first.

# %% [markdown] lang="ko" name="symptoms" slide="slide"
# ### 목록이 알려 주는 것과 먼저 확인할 것
#
# | 보이는 것 | 흔한 원인 | 먼저 확인할 것 |
# |---|---|---|
# | `Frame [x] does not exist`, TF에 비슷한 이름도 없음 | 발행 노드가 멈췄거나 기다림(AMCL은 초기 포즈를 기다립니다) | `ros2 node list`, 그 노드의 로그 |
# | 같은 오류, 비슷한 이름이 있음 | 잘못 입력함 | RViz와 노드의 철자 |
# | RobotModel의 일부 링크 | URDF, 관절 상태 | `ros2 topic hz /joint_states` |
# | `not part of the same tree` | 발행하는 노드가 없는 연결 | `view_frames`의 두 루트 |
# | 모두 Ok, 서 있을 때도 벽에서 벗어남 | 장착 변환, 헤더의 좌표계 | `tf2_echo base_link laser_frame`, `--field header` |
# | 모두 Ok, 서 있으면 맞고 굽은 길에서 번짐 | 측정 시각, 시계 | `topic delay /scan` |
# | 모두 Ok, 두 곳을 오감 | 발행자가 둘 | `view_frames`에서 연결의 발행률, `topic info --verbose` |
# | 아무것도 없음: `No messages received` | 발행자가 없거나 QoS가 맞지 않음. 레이저는 대개 `BEST_EFFORT`로 보내는데 RViz는 `RELIABLE`을 요청합니다 | `topic info /scan --verbose`, RViz에서는 디스플레이의 Reliability Policy |
#
# 셋째, 넷째, 일곱째 줄의 고장은 아래의 *RViz의 다른 고장* 절에서 볼 수 있습니다.
# “RViz에 보이지 않으니 센서 고장”은 어느 줄에도 없습니다. 센서는 메시지를 확인한 다음 마지막에 의심합니다.

# %% [markdown] lang="en" name="symptoms-notes" slide="notes"
# Cover the last column, fill in three rows together, then let them photograph it.

# %% [markdown] lang="ko" name="symptoms-notes" slide="notes"
# 마지막 열을 가리고 세 줄을 함께 채운 다음, 사진으로 찍게 합니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# RViz: everything Ok. In curves the scan smears along the wall; when the robot stands still it is right. What do you do first?
#
# 1. Replace the laser.
# 2. `tf2_echo base_link laser_frame`
# 3. `ros2 topic delay /scan`
# 4. Set the Fixed Frame to `odom`.
#
# <details><summary>I chose 1</summary>
#
# A laser that measures the wall correctly while the robot stands still is not broken. A first check should not cost a new laser.
#
# </details>
# <details><summary>I chose 2</summary>
#
# A wrong mount would also show while the robot stands still. The scan would always be off by the same amount, relative to the robot.
#
# </details>
# <details><summary>I chose 3</summary>
#
# Yes. If it is right at rest and wrong in motion, the cause has to do with *time*. A stamp that is off by 0.3 s rotates the scan by the angle that the robot turns in 0.3 s. On a straight line it only shifts the scan along the path: the walls beside the robot look right, and the wall ahead is 15 cm off at half a metre per second.
#
# </details>
# <details><summary>I chose 4</summary>
#
# The picture will look different, and the stamp is as wrong as before.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# RViz는 모두 Ok입니다. 굽은 길에서는 스캔이 벽을 따라 번지고, 로봇이 서 있으면 제자리에 놓입니다. 무엇을 먼저 합니까?
#
# 1. 레이저를 교체합니다.
# 2. `tf2_echo base_link laser_frame`
# 3. `ros2 topic delay /scan`
# 4. 고정 좌표계를 `odom`으로 바꿉니다.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 서 있을 때 벽을 제대로 재는 레이저는 고장이 아닙니다. 비용이 드는 점검은 나중에 합니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 장착 변환이 틀렸다면 서 있을 때도 보입니다. 로봇을 기준으로 늘 같은 만큼 벗어납니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞습니다. 서 있을 때는 맞고 움직일 때만 틀리면 원인은 *시각*에 있습니다. 측정 시각이 0.3초 틀리면 스캔은 0.3초 동안 회전한 만큼 회전해 그려집니다. 곧은 길에서는 나아가는 방향으로만 밀립니다. 옆의 벽은 맞아 보이고, 앞의 벽은 0.5 m/s에서 15 cm 어긋납니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 그림은 달라 보이지만 측정 시각은 그대로 틀려 있습니다.
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Two minutes. Open the reply of the wrong option that most have taken, then that of the right one.

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 2분입니다. 가장 많이 고른 틀린 보기의 설명을 먼저 열고, 이어서 맞는 보기의 설명을 엽니다.

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# ```
# ros2 run tf2_tools view_frames                       # five seconds, then frames_<date>.pdf
# ros2 run tf2_tools view_frames --help                # its options differ between distributions
# ros2 run tf2_ros tf2_echo map base_link 20           # twenty a second
# ros2 run tf2_ros tf2_monitor map laser_frame         # first report after 10.5 s: read max
# ros2 topic delay /scan
# ros2 topic info /tf --verbose                        # History (Depth) may say UNKNOWN: DDS does not pass it on
# ros2 node info /wheel_odometry
# rviz2
# ```
#
# In RViz set the Fixed Frame to `map` or `odom`, and add TF (tick *Show Names* and *Show Axes*), RobotModel, LaserScan, PointCloud2 and Map.
#
# In simulation, or while a bag is played, the tools need the simulated clock as your nodes do. That was the fix for the story:
#
# ```
# ros2 run tf2_ros tf2_monitor odom base_footprint --ros-args -p use_sim_time:=true
# rviz2 --ros-args -p use_sim_time:=true
# ```

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# ```
# ros2 run tf2_tools view_frames                       # 5초 뒤 frames_<날짜>.pdf
# ros2 run tf2_tools view_frames --help                # 옵션은 배포판마다 다름
# ros2 run tf2_ros tf2_echo map base_link 20           # 1초에 20번
# ros2 run tf2_ros tf2_monitor map laser_frame         # 첫 보고는 10.5초 뒤, max를 읽기
# ros2 topic delay /scan
# ros2 topic info /tf --verbose                        # History (Depth)는 UNKNOWN일 수 있음(DDS가 전하지 않음)
# ros2 node info /wheel_odometry
# rviz2
# ```
#
# RViz에서는 고정 좌표계(Fixed Frame)를 `map`이나 `odom`으로 정하고 TF(*Show Names*와 *Show Axes*를 켭니다), RobotModel, LaserScan, PointCloud2, Map을 추가합니다.
# 시뮬레이션이나 bag 재생 중에는 도구도 노드처럼 시뮬레이션 시간을 써야 합니다. 처음 이야기의 해결책도 이것입니다.
#
# ```
# ros2 run tf2_ros tf2_monitor odom base_footprint --ros-args -p use_sim_time:=true
# rviz2 --ros-args -p use_sim_time:=true
# ```

# %% [markdown] lang="en" name="on-the-robot-notes" slide="notes"
# For reference. One sentence: with a simulation or a bag the tools need `use_sim_time`, too; that was the fix for the first story.

# %% [markdown] lang="ko" name="on-the-robot-notes" slide="notes"
# 찾아보는 슬라이드입니다. 한 문장만 말합니다. 시뮬레이션이나 bag에서는 도구에도 `use_sim_time`이 필요합니다. 처음 이야기의 해결책이었습니다.

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - Ask first, then type. [[view_frames]]: frames, and the rate of each edge. [[tf2_echo]]: a value. [[tf2_monitor]]: how late. `topic delay`: a message's age. RViz: the picture. The [[owner]]: no tool.
# - Delay is not rate. `hz /tf` and the monitor's Hz count all nodes.
# - `tf2_monitor`: read `max`, not `avg`. Ignore static edges. A negative average means stamps in the future.
# - At constant speed, a slow edge costs nothing on a straight line, (v/ω)(1 − cos(ω/2f)) in a curve, and on both a wait if its period is longer than the scan's delay.
# - [[fixed frame|Fixed Frame]] changes the picture, never the data.
# - **Ok means computed, not true.** Compare value, frame name and stamp yourself.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - 질문부터 정하고 그다음에 입력합니다. [[view_frames]]는 좌표계와 연결별 발행률, [[tf2_echo]]는 값, [[tf2_monitor]]는 지연, `topic delay`는 메시지의 나이, RViz는 모습입니다. [[owner|발행 책임]]이 어느 노드에 있는지 알려 주는 도구는 없습니다.
# - 지연과 발행률은 다릅니다. `hz /tf`와 tf2_monitor의 Hz는 모든 발행자를 합친 값입니다.
# - `tf2_monitor`에서는 `avg`가 아니라 `max`를 읽습니다. 정적 좌표계의 줄은 읽지 않습니다. 평균이 음수이면 측정 시각이 미래입니다.
# - 속도가 일정하면 발행률이 낮은 연결도 곧은 길에서는 틀리지 않고, 굽은 길에서 (v/ω)(1 − cos(ω/2f))만큼 틀립니다. 주기가 스캔의 지연보다 길면 어느 길에서나 기다리게 됩니다.
# - [[fixed frame|고정 좌표계]]를 바꾸면 그림의 기준만 바뀌고 데이터는 바뀌지 않습니다.
# - **Ok는 계산했다는 뜻이지 맞다는 뜻이 아닙니다.** 값, 이름, 시각은 직접 비교해 확인합니다.

# %% [markdown] lang="en" name="recap-notes" slide="notes"
# Leave it on the screen while they write the exit tickets.

# %% [markdown] lang="ko" name="recap-notes" slide="notes"
# 쪽지를 쓰는 동안 화면에 띄워 둡니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > RViz shows everything Ok, and the scan is 20 cm off the wall, at rest and in motion. Write down two commands, and what you compare their output with.
#
# <details><summary>Compare</summary>
#
# `tf2_echo base_link laser_frame`, with the drawing or a ruler. `topic echo /scan --once --field header`, its `frame_id` with the frame of the sensor.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > RViz는 모두 Ok인데, 서 있을 때나 달릴 때나 스캔이 벽에서 20 cm 벗어나 있습니다. 명령 두 개와, 그 출력을 무엇과 비교할지 써 보세요.
#
# <details><summary>맞춰 보기</summary>
#
# `tf2_echo base_link laser_frame`의 값을 도면이나 자로 잰 값과 비교합니다. `topic echo /scan --once --field header`의 `frame_id`를 센서의 좌표계와 비교합니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Two minutes, without talking: two commands, and with what you compare each. Collect before the laboratory.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 2분 동안 말없이 적습니다. 명령 두 개와 저마다 비교할 것입니다. 실습 전에 걷습니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now choose a tool by its question, read what the tools print, and check what RViz's Ok leaves open.
#
# **Now the exercises:** [E11 Tools and RViz](../../exercises/en/E11_tools_and_rviz.ipynb). In them, `solution("E11.1")` shows a solution after you have passed the task or tried three times.
# After them comes [12 Owners and diagnosis](12_owners_and_diagnosis.ipynb): which node owns an edge, and what is broken.
#
# The sections below are for the curious: three more faults in RViz, and questions to practise.
#
# On your checklist this chapter is **C5** (`view_frames`), **C6** (`tf2_monitor`) and **C7** (RViz2), and **C2** (`tf2_echo`) once more. Here it was simulated; do it once on the robot.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 질문에 맞는 도구를 고르고, 도구의 출력을 읽고, RViz의 Ok로 알 수 없는 것을 직접 확인할 수 있습니다.
#
# **이제 연습 문제입니다.** [E11 도구와 RViz](../../exercises/ko/E11_tools_and_rviz.ipynb)를 풀어 보세요. 통과하거나 세 번 시도한 뒤에는 `solution("E11.1")`로 풀이를 볼 수 있습니다.
# 그다음은 [12 발행 책임과 진단](12_owners_and_diagnosis.ipynb)입니다. 누가 발행하고 무엇이 고장 났는지 찾습니다.
#
# 아래는 더 알고 싶을 때 보는 절입니다. RViz의 다른 고장 세 가지와 복습 문제, 서술형 문제가 있습니다.
#
# 실습 체크리스트에서 이 장은 **C5**(`view_frames`), **C6**(`tf2_monitor`), **C7**(RViz2)이고, **C2**(`tf2_echo`)도 다시 나옵니다. 여기서는 시뮬레이션이었으니, 로봇에서도 한 번 해 보세요.

# %% [markdown] lang="en" name="more-faults-heading" slide="subslide"
# ## More faults in RViz: no joints, no odometry, two owners

# %% [markdown] lang="ko" name="more-faults-heading" slide="subslide"
# ## RViz의 다른 고장: 관절 값 없음, 오도메트리 없음, 발행자 둘

# %% [markdown] lang="en" name="break-joints-predict" slide="-"
# **Predict** for each of three more faults: which displays fail? First, no node publishes the joint positions any more.

# %% [markdown] lang="ko" name="break-joints-predict" slide="-"
# 고장이 세 가지 더 있습니다. 매번 어느 디스플레이가 실패할지 **예측해 봅시다.** 먼저 관절 값을 발행하는 노드가 없을 때입니다.

# %% name="break-joints" tags=["predicted", "collapsed"]
# Stop the joint driver, and draw what RViz shows.
lesson.start_robot()
lesson.stop_node('joint_driver')
lesson.draw_rviz()

# %% [markdown] lang="en" name="break-joints-seen" tags=["predicted"]
# RobotModel counts 7 errors, TF only 3 warnings. TF lists the frames that it has *received*; RobotModel lists the links *in the URDF*. The scan is not affected: no joint that moves is between `map` and `laser_frame`.

# %% [markdown] lang="ko" name="break-joints-seen" tags=["predicted"]
# RobotModel의 오류는 7개인데 TF의 경고는 3개뿐입니다. TF는 *받은* 좌표계를, RobotModel은 *URDF에 있는* 링크를 나열합니다. 스캔은 정상입니다. `map`과 `laser_frame` 사이에는 움직이는 관절이 없습니다.

# %% [markdown] lang="en" name="break-odometry-predict"
# Next, the wheel odometry stops, and RViz is opened a while later.

# %% [markdown] lang="ko" name="break-odometry-predict"
# 다음은 바퀴 오도메트리 노드가 멈추고, 조금 뒤에 RViz를 엽니다.

# %% name="break-odometry" tags=["predicted", "collapsed"]
# Stop the wheel odometry, and draw what RViz shows.
lesson.start_robot().run(seconds=5)
lesson.stop_node('wheel_odometry')
lesson.draw_rviz()

# %% [markdown] lang="en" name="break-odometry-seen" tags=["predicted"]
# The message `not part of the same tree` points to its cause. `map` and `odom` are one tree, everything on the robot another; the edge between them has lost its publisher.

# %% [markdown] lang="ko" name="break-odometry-seen" tags=["predicted"]
# `not part of the same tree`는 원인을 알려 주는 오류입니다. `map`과 `odom`이 한 트리, 로봇의 좌표계 모두가 다른 트리입니다. 둘 사이의 연결을 발행하는 노드가 없어졌습니다.

# %% [markdown] lang="en" name="break-ekf-predict" slide="subslide"
# And the one without a red line: the EKF publishes `odom → base_footprint`, too. RViz draws the robot here, then there; every single lookup is Ok. The list cannot show it, but lookups twenty times a second can:

# %% [markdown] lang="ko" name="break-ekf-predict" slide="subslide"
# 그리고 오류 줄이 없는 고장입니다. EKF도 `odom → base_footprint`를 발행합니다. RViz는 로봇을 여기 그렸다가 저기 그리지만, 그때마다 Ok입니다. 목록에 나오지 않는 것도 1초에 스무 번 조회하면 드러납니다.

# %% name="break-ekf-robot" tags=["predicted", "collapsed"] slide="skip"
# Start a robot whose EKF publishes the edge, too.
graph = lesson.start_robot(also=['ekf_filter_node'])
graph.run(seconds=25.5)

# %% name="break-ekf" tags=["predicted"]
# %ros2 --for 0.25 run tf2_ros tf2_echo odom base_footprint 20

# %% [markdown] lang="en" name="break-ekf-seen" tags=["predicted"]
# x alternates by 0.15 m and the yaw by 11°: the wheel odometry drifts to one side, the EKF does not. Each value alone is valid.

# %% [markdown] lang="ko" name="break-ekf-seen" tags=["predicted"]
# x는 0.15 m, yaw는 11° 차이로 두 값 사이를 오갑니다. 바퀴 오도메트리의 포즈는 한쪽으로 드리프트하고 EKF의 포즈는 그렇지 않습니다. 값 하나하나에는 문제가 없습니다.

# %% name="stop" tags=["collapsed"] slide="skip"
# Stop the robot's nodes.
graph.stop()

# %% [markdown] lang="en" name="from-before-heading" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# 1. A frame without a parent: what is it called, and how many of them has a healthy robot?
# 2. The localiser corrects the pose by 20 cm. Which edge changes?
# 3. Which stamp does RViz use to place a scan, and why not the newest?
#
# <details><summary>Answers</summary>
#
# 1. A root; one.
# 2. `map → odom`, and no other.
# 3. The scan's own, because the robot has moved since the measurement.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# 1. 부모가 없는 좌표계를 무엇이라고 합니까? 정상인 로봇에는 몇 개 있습니까?
# 2. 위치 추정 노드가 포즈를 20 cm 바로잡습니다. 어느 연결이 바뀝니까?
# 3. RViz는 스캔을 어느 시각의 변환으로 그립니까? 왜 최신 변환을 쓰지 않습니까?
#
# <details><summary>답</summary>
#
# 1. 루트이고, 하나입니다.
# 2. `map → odom`뿐입니다.
# 3. 스캔의 측정 시각입니다. 측정한 뒤에 로봇이 움직였기 때문입니다.
#
# </details>

# %% [markdown] lang="en" name="from-before-notes" slide="notes"
# For home; the second one aloud if a minute is left.

# %% [markdown] lang="ko" name="from-before-notes" slide="notes"
# 집에서 합니다. 1분이 남으면 둘째 문제만 소리 내어 풉니다.

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice question · Q9

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제 · Q9

# %% [markdown] lang="en" name="practice" slide="-"
# What is each of `view_frames`, `tf2_echo` and `tf2_monitor` for? Write four or five sentences, and say of each what it cannot show.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] `view_frames` draws the tree of the last five seconds: parents, the rate and the ages of each edge.
# - [ ] `tf2_echo A B` prints the value of one pair, the pose of B in A, the latest one, again and again.
# - [ ] `tf2_monitor` measures how late a path and its frames are (`max`, not the first `avg`).
# - [ ] None of them names the owner of an edge; `topic info --verbose` names the nodes on the topic.
# - [ ] Each is a sample: what happens between two samples is not shown. For an extra point: a value that is printed need not be true.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# `view_frames`, `tf2_echo`, `tf2_monitor`는 각각 무엇을 위한 도구입니까? 저마다 알 수 없는 것까지 네다섯 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] `view_frames`는 5초 동안의 트리를 그립니다. 부모, 연결마다의 발행률과 시각이 나옵니다.
# - [ ] `tf2_echo A B`는 한 쌍의 값, 곧 A 기준 B의 최신 포즈를 되풀이해 출력합니다.
# - [ ] `tf2_monitor`는 경로와 좌표계의 지연을 잽니다(첫 `avg`가 아니라 `max`).
# - [ ] 연결의 발행자가 어느 노드인지는 어느 도구로도 알 수 없습니다. `topic info --verbose`는 토픽에 있는 노드를 알려 줍니다.
# - [ ] 모두 띄엄띄엄 조회할 뿐이라서, 그 사이에 일어난 일은 보이지 않습니다. 그리고 출력된 값이 맞는 값이라는 보장은 없습니다.
#
# </details>

# %% [markdown] lang="en" name="practice-notes" slide="notes"
# Written at home. What each tool cannot show is worth as much as what it shows.

# %% [markdown] lang="ko" name="practice-notes" slide="notes"
# 집에서 씁니다. 도구로 알 수 있는 것만큼 알 수 없는 것도 중요합니다.
