# %% [markdown] lang="en" name="title" slide="slide"
# # tflab: where is it, and when?
#
# A number without a frame is not yet information.
# `(2.0, 0.0, 0.0)` may be two metres ahead of the laser, two metres ahead of the robot, or two metres from the origin of the map.
# And a point that was two metres ahead a moment ago is somewhere else once the robot has moved.
#
# [[tf2|TF2]] is the part of ROS 2 that keeps track of this. It stores the pose (position and orientation) of each [[frame]] in another frame, and the time of this pose.
# In this workbook you learn TF2 from the beginning, with a simulated robot.
#
# You need basic Python.
# You do not need ROS, a robot, or a network. Nothing that you do here leaves this machine.
# The ROS 2 code that you write runs on a real robot unchanged.
# The workbook follows one lecture on TF2. "The lecture" on a page always means that one. You do not need to have attended it.
#
# On this page you take a tour of ten minutes. Then you see what you have passed so far, the chapters, and how your answers are checked.
# Rest the pointer on a word with a dotted line to see what it means. The [glossary](90_glossary.ipynb) lists all of them.

# %% [markdown] lang="ko" name="title" slide="slide"
# # tflab: 그때, 어디에 있었을까요?
#
# 좌표계가 없는 숫자만으로는 위치를 알 수 없습니다.
# `(2.0, 0.0, 0.0)`은 레이저 앞 2미터일 수도, 로봇 앞 2미터일 수도, 지도의 원점에서 2미터 떨어진 곳일 수도 있습니다.
# 조금 전에 로봇의 ‘앞 2미터’였던 곳도 로봇이 움직이면 더는 앞 2미터가 아닙니다.
#
# [[tf2|TF2]]는 [[frame|좌표계(frame)]] 사이의 위치와 방향을 시각마다 기억하는 ROS 2 라이브러리입니다.
# 이 워크북에서는 시뮬레이션 로봇으로 TF2를 처음부터 배웁니다.
#
# 파이썬 기초만 알면 됩니다.
# ROS도, 로봇도, 네트워크도 필요 없습니다. 모두 이 컴퓨터 안에서 실행됩니다.
# 여기서 쓴 ROS 2 코드는 실제 로봇에서 그대로 실행됩니다.
# 이 워크북은 TF2 강의 하나를 처음부터 끝까지 따라갑니다. 본문의 ‘강의’는 언제나 그 강의입니다. 강의를 듣지 않았어도 됩니다.
#
# 이 페이지에서는 10분 동안 먼저 둘러본 다음, 나의 학습 현황, 장 목록, 답을 확인하는 방법을 차례로 봅니다.
# 점선이 그어진 단어에 마우스를 올리면 설명이 나타납니다. 모든 용어는 [용어집](90_glossary.ipynb)에 모여 있습니다.

# %% [markdown] lang="en" name="how-to-run" slide="skip"
# Click into the first cell below and press `Shift`+`Enter`. The cell runs, and you are in the next one.
# (*Run* → *Run All Cells* in the menu runs all of them.)

# %% [markdown] lang="ko" name="how-to-run" slide="skip"
# 아래 첫 셀을 클릭하고 `Shift`+`Enter`를 눌러 보세요. 셀이 실행되고 다음 셀로 넘어갑니다.
# (메뉴에서 *Run* → *Run All Cells*를 고르면 한꺼번에 실행됩니다.)

# %% name="load"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="load-why" slide="skip"
# These two lines are in the first code cell of every chapter. The first line loads a simulated ROS 2 into this page's own Python process ("in-process"). Its output names the ROS 2 release that is simulated. The second line imports this workbook's own functions. What you import from `tflab` belongs to the workbook, such as every name that begins with `lesson.`, and so does the simulation, `graph`. Everything else is Python or ROS 2, as on a robot.
# Time is simulated here, and it advances only during certain commands. So a page prints the same text each time you run it from its start.
# A cell that only prepares or draws something shows its first line and three dots. Run it like the others. A click on the dots shows the rest.

# %% [markdown] lang="ko" name="load-why" slide="skip"
# 모든 장의 첫 코드 셀에 이 두 줄이 있습니다. 첫 줄은 이 페이지 안에서 실행되는(in-process) ROS 2를 불러옵니다. 출력의 괄호 속 이름은 ROS 2의 배포판입니다. 둘째 줄은 이 워크북의 도구를 가져옵니다. `lesson.…`처럼 `tflab`에서 가져온 것과 가상의 ROS 2 환경인 `graph`는 이 워크북의 것입니다. 나머지는 모두 로봇에서와 똑같은 파이썬과 ROS 2입니다.
# 이 페이지의 시간은 가상이며, 몇몇 명령을 실행하는 동안에만 흐릅니다. 그래서 페이지를 처음부터 실행하면 언제나 같은 결과가 나옵니다.
# 준비하거나 그리기만 하는 셀은 첫 줄과 점 세 개만 보입니다. 다른 셀처럼 실행하면 됩니다. 점을 클릭하면 나머지 코드가 보입니다.

# %% [markdown] lang="en" name="motion-why" slide="slide"
# ## A robot that drives through a room
#
# Run the cell below, then press ▶ under its picture. The drive takes 24 seconds, and the animation shows it in four.
#
# - The body with wheels and an arm is our robot. It drives round a pillar.
# - The coloured dots are the points that its laser measures, ten times a second. The pale area is what it has covered. The dots are on the walls, although the laser measures only distances *from itself*. In curves they are a little off the walls. Chapter 08 explains why.
# - The three arrows on the robot are the frame [[base_link]], and the three above them are `laser_frame`. The arrows that stay on the floor are `map`.
#
# This workbook is about one step. The laser measures a point in its own frame, and you calculate the point's position on the map.

# %% [markdown] lang="ko" name="motion-why" slide="slide"
# ## 방 안을 달리는 로봇
#
# 아래 셀을 실행하고 그림 밑의 ▶를 눌러 보세요. 24초 동안의 주행을 4초 만에 보여 줍니다.
#
# - 바퀴와 팔이 달린 몸체가 우리 로봇입니다. 로봇은 기둥 둘레를 돌며 달립니다.
# - 색이 있는 점은 레이저가 1초에 열 번 재는 곳이고, 점과 로봇 사이의 옅은 면은 레이저가 훑은 자리입니다. 점들은 벽 위에 놓이지만, 레이저가 재는 것은 벽의 위치가 아니라 *레이저를 기준으로* 한 거리와 방향뿐입니다. 로봇이 방향을 바꾸며 달릴 때는 점들이 벽에서 조금 벗어납니다. 그 까닭은 08장에서 다룹니다.
# - 화살표 세 개가 좌표계 하나입니다. 로봇에 붙은 것이 [[base_link|`base_link`]], 그 위의 것이 `laser_frame`, 바닥에 가만히 있는 것이 `map`입니다.
#
# 이 워크북은 *레이저 기준*의 값을 *지도 기준*으로 바꾸는 법을 다룹니다.

# %% name="motion" tags=["interactive"]
lesson.show_drive()

# %% name="motion-still" tags=["static"]
lesson.draw_room(at_s=5.0)

# %% [markdown] lang="en" name="motion-controls" slide="skip"
# <details><summary>With the mouse and with the keyboard</summary>
#
# Drag to rotate the view, scroll to zoom, and double-click to see all of it again.
# By keyboard, Tab moves into the view. The arrow keys rotate it, and with Shift they move it. + and − zoom, Home shows all, and Escape leaves it.
#
# </details>
# <details><summary>The view stays empty</summary>
#
# WebGL is switched off in your browser. Every 3D view is a figure until you run its cell. So switch WebGL on, or do not run these cells.
#
# </details>

# %% [markdown] lang="ko" name="motion-controls" slide="skip"
# <details><summary>마우스와 키보드로 움직이기</summary>
#
# 마우스로 끌면 시점이 회전하고, 그림을 클릭한 뒤 휠을 굴리면 가까워집니다. 두 번 클릭하면 처음처럼 전체가 보입니다.
# 키보드를 쓸 때는 Tab으로 그림에 들어갑니다. 화살표 키는 회전, Shift+화살표 키는 이동, +와 −는 확대와 축소, Home은 전체 보기입니다. Esc를 누르면 셀로 되돌아갑니다.
#
# </details>
# <details><summary>3D 화면이 비어 있습니다</summary>
#
# 브라우저의 WebGL이 꺼져 있는 것입니다. 3D 화면은 셀을 실행하기 전에는 같은 내용의 그림으로 보입니다. WebGL을 켜거나, 이런 셀은 실행하지 말고 그림을 보십시오.
#
# </details>

# %% [markdown] lang="en" name="first-question" slide="slide"
# ## Be wrong once, on purpose
#
# The laser is mounted 0.20 m in front of the robot's centre, `base_link`, and 0.15 m above it. It faces forward. It detects a post at (2.0, 0.5, 0.0): 2 m ahead of the laser, 0.5 m to the left.
# What are the post's coordinates in `base_link`?
#
# The cell below contains a common wrong answer. Run the cell and read the reply. Then correct the numbers and run it again.

# %% [markdown] lang="ko" name="first-question" slide="slide"
# ## 한 번 틀려 봅시다
#
# 레이저는 로봇의 중심에서 앞으로 0.20 m, 위로 0.15 m 떨어져 있고 로봇과 같은 방향을 봅니다. 레이저가 (2.0, 0.5, 0.0)에서 기둥을 측정했습니다. 레이저에서 앞으로 2 m, 왼쪽으로 0.5 m입니다.
# 로봇의 중심인 `base_link`를 기준으로 기둥은 어디에 있을까요?
#
# 아래에는 흔한 오답 하나가 적혀 있습니다. 셀을 실행하고 출력된 설명을 읽어 보세요. 그다음 숫자를 고쳐 다시 실행해 보세요.

# %% name="first-try" tags=["predicted"]
base_p_post = (2.0, 0.5, 0.0)  # (x, y, z) [m]
lesson.ask_first(base_p_post)

# %% [markdown] lang="en" name="robot-why" slide="slide"
# ## The same robot, in ROS 2
#
# So far you saw an animation. Now you run the robot's programs. Each is a ROS 2 [[node]], as it would run on the robot itself.
# One node calculates the pose from the wheels, another finds the robot on the map, and a third publishes where each part is mounted.
# Each node *publishes* transforms. A transform gives the pose of one frame in another. TF2 combines them.
#
# `new_graph` creates the simulation, `launch` starts the nodes, and `graph.run` lets two seconds pass. (On a robot you need neither `new_graph` nor `graph.run`: time passes by itself.)

# %% [markdown] lang="ko" name="robot-why" slide="slide"
# ## 같은 로봇을 ROS 2로
#
# 앞에서 본 것은 그림일 뿐이었습니다. 이번에는 로봇의 프로그램, 곧 ROS 2 [[node|노드(node)]]들을 실제 로봇에서와 똑같이 실행합니다.
# 어떤 노드는 바퀴의 회전에서 로봇의 이동을 계산하고, 어떤 노드는 지도에서 로봇의 위치를 추정하고, 또 어떤 노드는 부품이 로봇의 어디에 달려 있는지 알려 줍니다.
# 한 좌표계의 위치와 방향을 다른 좌표계 기준으로 적은 것을 *변환*이라고 합니다. 노드마다 자기가 구한 변환을 보내고, 그 변환이 필요한 노드가 받습니다. 이렇게 보내는 것을 *발행*이라고 합니다. TF2는 변환들을 합성합니다.
#
# `new_graph`는 노드가 실행될 가상의 ROS 2 환경을 만들고, `launch`는 노드들을 실행하고, `graph.run`은 시간이 2초 흐르게 합니다. (실제 로봇에서는 환경이 이미 있고 시간도 저절로 흐르므로 첫 번째와 세 번째가 필요 없습니다.)

# %% name="robot"
graph = lesson.new_graph()
nodes = lesson.launch(graph)
graph.run(seconds=2.0)

# %% [markdown] lang="en" name="echo-why" slide="slide"
# ## Where is the laser in `map`?
#
# Read the question as a sentence: *data expressed in* `laser_frame`, *wanted in* `map`. The tool `tf2_echo` looks this up once a second and prints it. In the command, the frame in which you want the data comes first.
# `%ros2` is what you type as `ros2` in a terminal. Only `--for 2` belongs to this workbook: it ends the command after two seconds. On a robot, leave it out and press Ctrl-C.
# The first line of its output is not an error. It appears because the tool looks up the transform before it has received any. You see the same on a robot.

# %% [markdown] lang="ko" name="echo-why" slide="slide"
# ## `map` 기준으로 레이저는 어디에 있을까요?
#
# 소리 내어 읽어 보세요. “`laser_frame` 기준 데이터를 `map` 기준으로 보고 싶다.” `tf2_echo`는 이것을 1초에 한 번씩 조회해 출력하는 도구입니다. 명령에는 결과의 기준이 될 좌표계(목표)를 먼저 씁니다.
# `%ros2`는 터미널에서 입력하는 `ros2`와 같습니다. 다만 `--for 2`는 이 워크북에만 있는 옵션으로, 명령을 2초 뒤에 끝냅니다. 로봇에서는 이 옵션을 빼고 Ctrl-C로 끝냅니다.

# %% name="echo"
# %ros2 --for 2 run tf2_ros tf2_echo map laser_frame

# %% [markdown] lang="en" name="echo-read" slide="-"
# The answer is the line *Translation*: x, y and z in metres, in `map`, once a second. The lines below it give the rotation, written in four ways (the last column of the matrix is the translation). Chapter 02 explains them.

# %% [markdown] lang="ko" name="echo-read" slide="-"
# 답은 *Translation* 줄입니다. 지도 기준의 x, y, z를 1초에 한 번씩 미터로 보여 줍니다. 그 아래 줄들은 회전을 네 가지 방식으로 적은 것입니다(행렬의 마지막 열은 이동입니다). 02장에서 다룹니다.
# (첫 줄은 도구가 변환을 하나도 받지 못한 상태에서 조회부터 하기 때문에 나옵니다. 실제 로봇에서도 똑같습니다.)

# %% [markdown] lang="en" name="fail-why" slide="-"
# ## Now make it fail
#
# Here one letter of the frame's name is missing. On a robot you read exactly these lines. The first line is printed before any transform has arrived, so it reports that `map` does not exist. The second line is about the misspelt name.

# %% [markdown] lang="ko" name="fail-why" slide="-"
# ## 이번에는 실패해 봅시다
#
# 한 글자가 빠진 이름을 조회합니다. 로봇에서도 정확히 이 두 줄을 보게 됩니다. 첫 줄은 도구가 변환을 받기 전에 출력한 것이라 `map`이 없다고 나옵니다. 둘째 줄이 잘못된 이름을 알려 줍니다.

# %% name="fail"
# %ros2 --for 1 run tf2_ros tf2_echo map laser_fame

# %% [markdown] lang="en" name="rviz-why" slide="slide"
# ## See what ROS 2 sees
#
# This is a small [[rviz]], ROS 2's 3D visualiser. Choose another [[fixed frame|Fixed Frame]] in the menu: the view changes, the data does not.
# Choose `base_link`: now the robot is at the centre, and the room is drawn around it. Time does not advance here. If the robot drove, the room would move towards it.

# %% [markdown] lang="ko" name="rviz-why" slide="slide"
# ## ROS 2가 보는 것을 봅시다
#
# 아래는 ROS 2의 3D 시각화 도구인 [[rviz|RViz]]를 작게 만든 것입니다. 메뉴에서 [[fixed frame|고정 좌표계(Fixed Frame)]]를 바꿔 보세요. 그림은 바뀌지만 데이터는 바뀌지 않습니다.
# `base_link`를 고르면 로봇이 중심이 되고, 방은 로봇에서 본 대로 놓입니다. 여기서는 시간이 멈추어 있지만, 달리는 로봇이라면 방이 다가옵니다.

# %% name="rviz" tags=["interactive"]
# %rviz2 -f map

# %% name="rviz-still" tags=["static"]
lesson.draw_rviz()

# %% name="stop" tags=["collapsed"]
graph.stop()

# %% [markdown] lang="en" name="progress-why" slide="skip"
# ## Where you stand
#
# Run the next cell whenever you like, or type `tflab progress` in a terminal. It shows your tasks, and a checklist of what you have done.
# A task counts as passed after a successful check. The results are in the file `progress.json` in your copy.
# After a chapter, [practice](91_practice.ipynb) gives you its tasks again with other numbers.
# After you have installed a new version of tflab, `tflab lab --update` adds its new material and keeps what you wrote.

# %% [markdown] lang="ko" name="progress-why" slide="skip"
# ## 나의 학습 현황
#
# 언제든지 다음 셀을 실행하거나, 터미널에서 `tflab progress`를 입력해 보세요. 통과한 과제와 실습 체크리스트가 나옵니다.
# `check`를 통과한 과제만 통과한 것으로 표시됩니다. 결과는 내 워크북의 `progress.json`에만 저장됩니다.
# 한 장을 마쳤다면 [끝없는 연습](91_practice.ipynb)에서 같은 과제를 다른 숫자로 다시 풀어 보세요. 틀렸던 것이 먼저 나옵니다.
# tflab의 새 버전을 설치한 뒤 `tflab lab --update`를 실행하면 새 내용이 더해집니다. 직접 쓴 내용은 그대로 남습니다.

# %% name="progress" tags=["interactive"] slide="skip"
lesson.show_progress()

# %% [markdown] lang="en" name="chapters" slide="slide"
# ## The chapters
#
# Each chapter begins with a fault that somebody reported. Its core takes three quarters of an hour at most, and ends with the heading *Enough to go on*.
# What follows is for the curious. It is collapsed to its headings. Click on *cells hidden* below a heading to open it. The minutes in the table are for the core: to read, to predict and to run it.
#
# **If you have one evening,** read 00, 01, 03 and 08, in this order and without the exercises. They are the core path: what a position needs, in which frame you want it, and where the robot was when it measured.
#
# After chapter 12, [From here to a robot](92_to_a_robot.ipynb) takes your nodes to a real robot.

# %% [markdown] lang="ko" name="chapters" slide="slide"
# ## 장 목록
#
# 각 장은 누군가 실제로 겪고 보고한 실패로 시작합니다. 장마다 핵심은 길어야 45분이고, *여기까지면 충분합니다*라는 제목에서 끝납니다.
# 그다음은 더 알고 싶은 사람을 위한 것으로, 제목만 남기고 접혀 있습니다. 제목 밑의 *cells hidden*을 클릭하면 펼쳐집니다. 표의 분은 핵심을 읽고, 예측하고, 실행하는 데 걸리는 시간입니다.
#
# **하룻저녁만 낼 수 있다면** 00, 01, 03, 08장을 이 순서로, 연습 문제 없이 보십시오. 위치에 꼭 필요한 것, 결과의 기준이 될 좌표계, 측정한 순간에 로봇이 있던 곳을 다루는 핵심 코스입니다.
#
# 12장을 마친 다음에는 [이제 로봇으로](92_to_a_robot.ipynb)에서 내 노드를 로봇에 올립니다.

# %% [markdown] lang="en" name="chapters-table" slide="-"
# | no. | chapter | its question | minutes | builds on | exercise, minutes |
# |--:|:--|:--|--:|:--|:--|
# | 1 | **[Value, frame and stamp](01_value_frame_stamp.ipynb)** | When are three numbers a position? | 30 | 0 | [E1](../../exercises/en/E01_value_frame_stamp.ipynb), 50 |
# | 2 | **[Axes and quaternions](02_axes_and_quaternions.ipynb)** | Which way is forward? | 45 | 1 | [E2](../../exercises/en/E02_axes_and_quaternions.ipynb), 45 |
# | 3 | **[Target and source](03_target_and_source.ipynb)** | In which frame is the data, and in which do you want it? | 35 | 1, 2 | [E3](../../exercises/en/E03_target_and_source.ipynb), 50 |
# | 4 | **[The tree of frames](04_frame_tree.ipynb)** | How are two frames connected? | 30 | 3 | [E4](../../exercises/en/E04_frame_tree.ipynb), 60 |
# | 5 | **[map, odom, base_link](05_map_odom_base_link.ipynb)** | Why are there two fixed frames? | 25 | 3, 4 | [E5](../../exercises/en/E05_map_odom_base_link.ipynb), 60 |
# | 6 | **[Static and dynamic](06_static_and_dynamic.ipynb)** | Which node publishes a transform, and how often? | 35 | 3, 4 | [E6](../../exercises/en/E06_static_and_dynamic.ipynb), 70 |
# | 7 | **[URDF and sensors](07_urdf_and_sensors.ipynb)** | Where are the robot's parts mounted? | 35 | 2, 6 | [E7](../../exercises/en/E07_urdf_and_sensors.ipynb), 60 |
# | 8 | **[Buffer and measurement time](08_buffer_and_measurement_time.ipynb)** | Where was the robot when it measured? | 45 | 1, 3, 4, 5, 6 | [E8](../../exercises/en/E08_buffer_and_measurement_time.ipynb), 60 |
# | 9 | **[Exceptions and waiting](09_exceptions_and_waiting.ipynb)** | Why is there no answer, and does waiting help? | 35 | 4, 8 | [E9](../../exercises/en/E09_exceptions_and_waiting.ipynb), 45 |
# | 10 | **[Clocks and bags](10_clocks_and_bags.ipynb)** | Which clock do the stamps come from? | 30 | 6, 8, 9 | [E10](../../exercises/en/E10_clocks_and_bags.ipynb), 60 |
# | 11 | **[Tools and RViz](11_tools_and_rviz.ipynb)** | Which tool answers which question? | 45 | 4, 5, 8 | [E11](../../exercises/en/E11_tools_and_rviz.ipynb), 45 |
# | 12 | **[Owners and diagnosis](12_owners_and_diagnosis.ipynb)** | Which node owns each edge, and what is broken? | 45 | 5, 6, 7, 9, 10, 11 | [E12](../../exercises/en/E12_owners_and_diagnosis.ipynb), 105 |
#
# The cores of all pages take about 8 hours together, and all exercises about 12 hours more.
# The path for one evening takes 125 minutes.

# %% [markdown] lang="ko" name="chapters-table" slide="-"
# | 번호 | 장 | 장의 질문 | 분 | 먼저 볼 장 | 연습, 분 |
# |--:|:--|:--|--:|:--|:--|
# | 1 | **[값, 좌표계, 측정 시각](01_value_frame_stamp.ipynb)** | 숫자 세 개가 위치가 되려면 무엇이 더 필요할까요? | 30 | 0 | [E1](../../exercises/ko/E01_value_frame_stamp.ipynb), 50 |
# | 2 | **[좌표축과 쿼터니언](02_axes_and_quaternions.ipynb)** | 어느 축이 앞이고, 회전은 어떻게 적을까요? | 45 | 1 | [E2](../../exercises/ko/E02_axes_and_quaternions.ipynb), 45 |
# | 3 | **[목표 좌표계와 원본 좌표계](03_target_and_source.ipynb)** | 데이터는 어느 좌표계 기준이고, 어느 좌표계 기준으로 바꿀까요? | 35 | 1, 2 | [E3](../../exercises/ko/E03_target_and_source.ipynb), 50 |
# | 4 | **[좌표계 트리](04_frame_tree.ipynb)** | 두 좌표계는 어떻게 연결될까요? | 30 | 3 | [E4](../../exercises/ko/E04_frame_tree.ipynb), 60 |
# | 5 | **[map, odom, base_link](05_map_odom_base_link.ipynb)** | 세계에 고정된 기준 좌표계는 왜 둘이나 필요할까요? | 25 | 3, 4 | [E5](../../exercises/ko/E05_map_odom_base_link.ipynb), 60 |
# | 6 | **[정적 변환과 동적 변환](06_static_and_dynamic.ipynb)** | 어느 노드가 변환을 발행하고, 얼마나 자주 발행할까요? | 35 | 3, 4 | [E6](../../exercises/ko/E06_static_and_dynamic.ipynb), 70 |
# | 7 | **[URDF와 센서](07_urdf_and_sensors.ipynb)** | 로봇의 부품은 어디에 붙어 있을까요? | 35 | 2, 6 | [E7](../../exercises/ko/E07_urdf_and_sensors.ipynb), 60 |
# | 8 | **[버퍼와 측정 시각](08_buffer_and_measurement_time.ipynb)** | 측정한 순간, 로봇은 어디에 있었을까요? | 45 | 1, 3, 4, 5, 6 | [E8](../../exercises/ko/E08_buffer_and_measurement_time.ipynb), 60 |
# | 9 | **[예외와 기다림](09_exceptions_and_waiting.ipynb)** | 왜 조회가 실패할까요? 기다리면 될까요? | 35 | 4, 8 | [E9](../../exercises/ko/E09_exceptions_and_waiting.ipynb), 45 |
# | 10 | **[시계와 bag](10_clocks_and_bags.ipynb)** | 측정 시각은 어느 시계의 시각일까요? | 30 | 6, 8, 9 | [E10](../../exercises/ko/E10_clocks_and_bags.ipynb), 60 |
# | 11 | **[도구와 RViz](11_tools_and_rviz.ipynb)** | 어떤 질문에 어떤 도구를 쓸까요? | 45 | 4, 5, 8 | [E11](../../exercises/ko/E11_tools_and_rviz.ipynb), 45 |
# | 12 | **[발행 책임과 진단](12_owners_and_diagnosis.ipynb)** | 각 연결은 어느 노드의 책임이고, 무엇이 고장 났을까요? | 45 | 5, 6, 7, 9, 10, 11 | [E12](../../exercises/ko/E12_owners_and_diagnosis.ipynb), 105 |
#
# 모든 페이지의 핵심을 보는 데 약 8시간, 모든 연습 문제를 푸는 데 다시 약 12시간이 걸립니다.
# 하룻저녁 코스는 125분입니다.

# %% [markdown] lang="en" name="map-why" slide="-"
# An arrow points from a chapter to one that builds on it. An arrow that follows from others is left out.

# %% [markdown] lang="ko" name="map-why" slide="-"
# 화살표는 먼저 볼 장에서 그다음 장을 가리킵니다. 다른 화살표들을 따라가면 알 수 있는 화살표는 그리지 않았습니다. *그림 읽기:* 영어 제목은 표에 있는 같은 번호의 장 제목입니다.

# %% name="map" tags=["collapsed"]
lesson.draw_course([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12])

# %% [markdown] lang="en" name="fifteen" slide="skip"
# <details><summary>Your course may ask you to answer fifteen questions before you begin</summary>
#
# The [fifteen questions](../../exercises/en/E00_start.ipynb) are about robots. They take a quarter of an hour, and a wrong answer costs nothing. If you guess, write a `?` after the letter.
# You answer similar questions again at the end of chapter 12. After that, *Where you stand* shows what you have learned, what to read again, and an explanation of every answer option.
# The test is small, and nobody has validated it yet. Use it to see what to read again, not to compare yourself with others.
#
# </details>

# %% [markdown] lang="ko" name="fifteen" slide="skip"
# <details><summary>수업에서는 시작하기 전에 열다섯 문제를 풀어 오라고 할 수 있습니다</summary>
#
# 로봇에 관한 [열다섯 문제](../../exercises/ko/E00_start.ipynb)입니다. 15분이면 되고, 틀려도 괜찮습니다. 짐작한 답에는 글자 뒤에 `?`를 적습니다.
# 12장이 끝나면 비슷한 문제를 다시 풉니다. 그다음에는 *나의 학습 현황*에서 무엇을 배웠는지, 무엇을 다시 볼지, 각 보기가 왜 맞거나 틀린지 볼 수 있습니다.
# 이 시험은 문항이 적고, 실력을 제대로 재는지 아직 검증하지 않았습니다. 다시 볼 곳을 찾는 데만 쓰고, 다른 사람과 비교하지는 마십시오.
#
# </details>

# %% [markdown] lang="en" name="checks" slide="slide"
# ## How your answers are checked
#
# Every chapter has exercises. Each task gives you data, asks for an answer, and checks it:
#
# ```python
# e2_2 = task("E2.2")          # prints the data of the task
# link_p_part = ...            # your answer goes here
# check("E2.2", link_p_part)   # reports that it is right, or which mistake you made
# hint("E2.2")                 # the next of three hints
# solution("E2.2")             # after a pass, or three tries
# ```
#
# The reply to a wrong answer names the mistake, as above. You may try as often as you like, in any order.
# `check` tries your answer on a few inputs. In a class, grading also uses other inputs.
# To start a page over, delete its file and type `tflab lab --copy-only` in a terminal of JupyterLab (File → New → Terminal). It restores missing files and changes nothing else.

# %% [markdown] lang="ko" name="checks" slide="slide"
# ## 답을 확인하는 방법
#
# 장마다 연습 문제가 있습니다. 과제마다 값이 주어집니다. 답을 쓰고 `check`로 확인합니다.
#
# ```python
# e2_2 = task("E2.2")          # 주어진 값을 보여 줍니다
# link_p_part = ...            # 여기에 답을 씁니다
# check("E2.2", link_p_part)   # 맞았는지, 아니면 어떤 실수인지 알려 줍니다
# hint("E2.2")                 # 힌트 세 개를 차례로 봅니다
# solution("E2.2")             # 통과하거나 세 번 시도하면 풀이를 봅니다
# ```
#
# 틀린 답을 내면 앞에서 본 것처럼 어떤 실수인지 알려 줍니다. 순서에 상관없이 몇 번이든 다시 해 볼 수 있습니다.
# `check`는 몇 가지 입력으로 확인하고, 수업에서는 공개하지 않은 입력으로 채점합니다.
# 어떤 페이지를 처음부터 다시 하려면 그 파일을 지우고 JupyterLab의 터미널(File → New → Terminal)에서 `tflab lab --copy-only`를 입력해 보세요. 없는 파일만 새로 만들고 나머지는 건드리지 않습니다.

# %% [markdown] lang="en" name="environment-why" slide="skip"
# ## If something did not work
#
# The next cell checks what the pages need: several programs, and a folder for your progress. A ✗ shows what is missing and what to type.

# %% [markdown] lang="ko" name="environment-why" slide="skip"
# ## 잘 되지 않는다면
#
# 다음 셀은 페이지에 필요한 프로그램과 진도를 저장할 폴더를 한 줄에 하나씩 점검합니다. ✗가 있으면 무엇이 없는지, 무엇을 입력하면 되는지 알려 줍니다.

# %% name="environment" tags=["predicted"] slide="skip"
lesson.check_environment()

# %% [markdown] lang="en" name="next" slide="skip"
# **Next:** [01 · Value, frame and stamp](01_value_frame_stamp.ipynb).

# %% [markdown] lang="ko" name="next" slide="skip"
# **다음:** [01 · 값, 좌표계, 측정 시각](01_value_frame_stamp.ipynb)으로 갑니다.
