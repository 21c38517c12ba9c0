# %% [markdown] lang="en" name="title" slide="slide"
# # tflab: where is it, and when?
#
# A number without a frame is a rumour.
# `(2.0, 0.0, 0.0)` may be two metres ahead of the laser, of the robot, or of the corner of the map.
# Two metres ahead a moment ago is somewhere else now.
#
# [[tf2|TF2]] is the part of ROS 2 that keeps track: which [[frame]] sits where in which other one, and since when.
# This workbook teaches it to you from the beginning, with a robot that lives in these pages.
#
# You need basic Python.
# You do not need ROS, a robot, or a network: nothing you do here leaves this machine.
# What you write runs on a real robot unchanged.
#
# On this page: a tour of five minutes, then the chapters, how your answers are checked, and where you stand.

# %% [markdown] lang="ko" name="title" slide="slide"
# # tflab: 어디에, 언제 있었습니까?
#
# 좌표계 없는 숫자는 소문일 뿐입니다.
# `(2.0, 0.0, 0.0)`은 레이저 앞 2미터일 수도, 로봇 앞 2미터일 수도, 지도 한구석에서 2미터 떨어진 곳일 수도 있습니다.
# 조금 전의 앞 2미터는 지금은 다른 곳입니다.
#
# [[tf2|TF2]]는 어느 [[frame|좌표계(frame)]]가 다른 좌표계의 어디에, 언제부터 있는지 기억하는 ROS 2의 부품입니다.
# 이 워크북은 페이지 안에서 움직이는 로봇과 함께 TF2를 처음부터 가르칩니다.
#
# 파이썬 기초만 알면 됩니다.
# ROS도, 로봇도, 네트워크도 필요 없고, 여기서 하는 일은 이 컴퓨터 밖으로 나가지 않습니다.
# 여기서 쓴 코드는 실제 로봇에서 그대로 실행됩니다.
#
# 이 페이지에서는 5분 동안 한 바퀴 둘러본 다음, 각 장의 내용과 답을 확인하는 방법, 나의 학습 현황을 봅니다.

# %% [markdown] lang="en" name="how-to-run" slide="skip"
# ## Run this page
#
# Run the cells from top to bottom: `Shift`+`Enter` runs one and moves on.
# To run them all, choose *Run* → *Run All Cells* in the menu.
#
# The first cell of every page puts ROS 2's own modules (`rclpy`, `tf2_ros`, `geometry_msgs`, …) in place, inside the page.
# Time is virtual: it stands still until you let it pass, so the same cell prints the same thing every time.

# %% [markdown] lang="ko" name="how-to-run" slide="skip"
# ## 페이지 실행하기
#
# 위에서부터 차례로 셀을 실행하십시오. `Shift`+`Enter`를 누르면 한 셀을 실행하고 다음 셀로 넘어갑니다.
# 한꺼번에 실행하려면 메뉴에서 *Run* → *Run All Cells*를 고릅니다.
#
# 모든 페이지의 첫 셀은 ROS 2의 모듈(`rclpy`, `tf2_ros`, `geometry_msgs` 등)을 페이지 안에 준비합니다.
# 시간은 가상입니다. 흐르게 하기 전에는 멈춰 있으므로, 같은 셀은 언제나 같은 결과를 출력합니다.

# %% name="load"
# %load_ext tflab

# %% name="imports"
import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster

from tflab.core import LATEST
from tflab.tools.rviz import look
from tflab.views import frames
from tflab.workbook.course.course_map import draw_course
from tflab.workbook.copy.environment import check_environment
from tflab.workbook.course.progress_page import show_progress

# %% [markdown] lang="en" name="environment-why" slide="skip"
# ## Is everything there?
#
# One line for each thing that the pages need.
# A ✗ says what is missing and what to type.

# %% [markdown] lang="ko" name="environment-why" slide="skip"
# ## 필요한 것이 모두 있습니까?
#
# 페이지에 필요한 것을 한 줄에 하나씩 확인합니다.
# ✗가 있으면 무엇이 없는지, 무엇을 입력하면 되는지 알려 줍니다.

# %% name="environment"
check_environment()

# %% [markdown] lang="en" name="node-why" slide="slide"
# ## A robot that drives in a circle
#
# This is an ordinary ROS 2 [[node]]. On a robot it would run unchanged.
# Twenty times a second it says where [[base_link]], the robot's body, is in [[odom]], the frame that its wheels keep count in.

# %% [markdown] lang="ko" name="node-why" slide="slide"
# ## 원을 그리며 달리는 로봇
#
# 평범한 ROS 2 [[node|노드(node)]]이며, 로봇에서도 그대로 실행됩니다.
# 로봇 본체인 [[base_link|`base_link`]]가 바퀴로 잰 위치의 기준인 [[odom|`odom`]]의 어디에 있는지 1초에 스무 번 알립니다.

# %% name="pose"
def on_the_circle(angle, stamp):
    t = TransformStamped()
    t.header.stamp = stamp
    t.header.frame_id, t.child_frame_id = 'odom', 'base_link'
    t.transform.translation.x = math.cos(angle)
    t.transform.translation.y = math.sin(angle)
    yaw = angle + math.pi / 2  # along the circle, not out of it
    t.transform.rotation.z = math.sin(yaw / 2)
    t.transform.rotation.w = math.cos(yaw / 2)
    return t

# %% name="node"
class Circle(Node):
    def __init__(self):
        super().__init__('circle')
        self.broadcaster = TransformBroadcaster(self)
        self.angle = 0.0
        self.create_timer(0.05, self.tick)

    def tick(self):
        self.angle += 0.025
        self.broadcaster.sendTransform(on_the_circle(self.angle, self.get_clock().now().to_msg()))

# %% name="start"
def main():
    rclpy.init()
    rclpy.spin(Circle())


circle = graph.start(main, name='circle')
graph.run(seconds=1.0)

# %% [markdown] lang="en" name="laser-why" slide="slide"
# ## A laser, bolted on
#
# The node goes on living after its cell has ended, and time passes only in `graph.run(...)` and in tools.
#
# A sensor that does not move is published once, with ROS 2's own tool.
# `%ros2` is what you would type as `ros2` in a terminal.

# %% [markdown] lang="ko" name="laser-why" slide="slide"
# ## 로봇에 단 레이저
#
# 노드는 셀이 끝난 뒤에도 살아 있고, 시간은 `graph.run(...)`과 도구 안에서만 흐릅니다.
#
# 움직이지 않는 센서는 ROS 2의 도구로 한 번만 발행합니다.
# `%ros2`는 터미널에서 입력하는 `ros2`와 같습니다.

# %% name="laser"
# %ros2 run tf2_ros static_transform_publisher --x 0.20 --z 0.15 --frame-id base_link --child-frame-id laser_frame

# %% [markdown] lang="en" name="echo-why" slide="slide"
# ## Where is the laser, as seen from `odom`?
#
# Read it aloud: *data expressed in* `laser_frame`, *wanted in* `odom`.
# Wanted comes first.
#
# The tool's first line complains about a frame: it asks at once, before it has heard anything.
# Answers follow as soon as the robot speaks. On a robot it is the same.

# %% [markdown] lang="ko" name="echo-why" slide="slide"
# ## `odom`에서 보면 레이저는 어디에 있습니까?
#
# 소리 내어 읽어 보십시오. “`odom`에서 보고 싶다, `laser_frame`의 데이터를.”
# 보고 싶은 쪽을 먼저 씁니다.
#
# 도구는 아직 아무것도 듣지 못한 채로 먼저 묻기 때문에, 첫 줄에서 좌표계가 없다고 불평합니다.
# 로봇이 위치를 알리면 곧 답이 나옵니다. 실제 로봇에서도 똑같습니다.

# %% name="echo"
# %ros2 --for 2 run tf2_ros tf2_echo odom laser_frame

# %% [markdown] lang="en" name="fail-why" slide="-"
# ## Now make it fail
#
# A name that nobody has published. On a robot you would read exactly this line.

# %% [markdown] lang="ko" name="fail-why" slide="-"
# ## 이번에는 실패해 봅니다
#
# 아무도 발행하지 않은 이름을 묻습니다. 로봇에서도 정확히 이 줄을 보게 됩니다.

# %% name="fail"
# %ros2 --for 1 run tf2_ros tf2_echo map laser_frame

# %% [markdown] lang="en" name="rviz-why" slide="slide"
# ## See it
#
# A small RViz. Choose another [[fixed frame|Fixed Frame]]: the picture changes, the data does not.
# Drag to turn, scroll to come closer.
#
# If the box stays empty, your browser has WebGL switched off.
# Every 3D view in this workbook is followed by a figure of the same thing, so you can go on without it.

# %% [markdown] lang="ko" name="rviz-why" slide="slide"
# ## 눈으로 봅니다
#
# 작은 RViz입니다. [[fixed frame|고정 좌표계(Fixed Frame)]]를 바꿔 보십시오. 그림은 바뀌지만 데이터는 바뀌지 않습니다.
# 마우스로 끌면 돌아가고, 휠을 굴리면 가까워집니다.
#
# 상자가 비어 있다면 브라우저의 WebGL이 꺼져 있는 것입니다.
# 이 워크북의 3D 화면 다음에는 늘 같은 내용의 그림이 있으므로, 3D 없이도 계속할 수 있습니다.

# %% name="rviz" tags=["interactive"]
# %rviz2 -f odom

# %% name="rviz-still"
parents, _, ask = look()
frames.draw_scene({frame: ask('odom', frame, LATEST) for frame in parents}, fixed_frame='odom')

# %% name="stop"
graph.stop()

# %% [markdown] lang="en" name="chapters" slide="slide"
# ## The chapters
#
# Each takes about an hour, and begins with something that went wrong on a real robot.
# You can begin with any chapter that is there: it says what it needs from the ones before.

# %% [markdown] lang="ko" name="chapters" slide="slide"
# ## 이 강의의 장
#
# 한 장은 한 시간쯤 걸리고, 실제 로봇에서 일어난 실패로 시작합니다.
# 준비된 장이라면 어디서든 시작할 수 있습니다. 앞 장에서 필요한 내용은 그 장에 적혀 있습니다.

# %% [markdown] lang="en" name="chapters-table" slide="-"
# | | chapter | its question | builds on | exercise |
# |--:|:--|:--|:--|:--|
# | 1 | **[Value, frame and stamp](01_value_frame_stamp.ipynb)** | What makes three numbers a place? |  | [E1](../../exercises/en/01_value_frame_stamp.ipynb) |
# | 2 | **[Axes and quaternions](02_axes_and_quaternions.ipynb)** | Which way is forward? | 1 | [E2](../../exercises/en/02_axes_and_quaternions.ipynb) |
# | 3 | **[Target and source](03_target_and_source.ipynb)** | Data in which frame, wanted in which? | 1, 2 | [E3](../../exercises/en/03_target_and_source.ipynb) |
# | 4 | The tree of frames | How does one frame reach another? | 3 | to come |
# | 5 | map, odom, base_link | Why are there two fixed frames? | 3, 4 | to come |
# | 6 | Static and dynamic | Who says where things are, and how often? | 3, 4 | to come |
# | 7 | URDF and sensors | Where are the robot's own parts? | 2, 6 | to come |
# | 8 | **[Buffer and measurement time](08_buffer_and_measurement_time.ipynb)** | Where was I when I saw it? | 3, 6 | [E8](../../exercises/en/08_buffer_and_measurement_time.ipynb) |
# | 9 | **[Exceptions and waiting](09_exceptions_and_waiting.ipynb)** | Why is there no answer, and does waiting help? | 4, 8 | [E9](../../exercises/en/09_exceptions_and_waiting.ipynb) |
# | 10 | Clocks and bags | Whose time is it? | 8, 9 | to come |
# | 11 | Tools and RViz | Which tool answers which question? | 4, 5, 8 | to come |
# | 12 | Owners and diagnosis | Who owns each edge, and what is broken? | 5, 6, 7, 9, 10, 11 | to come |

# %% [markdown] lang="ko" name="chapters-table" slide="-"
# | | 장 | 장의 질문 | 먼저 볼 장 | 연습 |
# |--:|:--|:--|:--|:--|
# | 1 | **[값과 좌표계와 측정 시각](01_value_frame_stamp.ipynb)** | 숫자 세 개는 언제 위치가 됩니까? |  | [E1](../../exercises/ko/01_value_frame_stamp.ipynb) |
# | 2 | **[좌표축과 쿼터니언](02_axes_and_quaternions.ipynb)** | 어느 쪽이 앞입니까? | 1 | [E2](../../exercises/ko/02_axes_and_quaternions.ipynb) |
# | 3 | **[목표 좌표계와 원본 좌표계](03_target_and_source.ipynb)** | 어느 좌표계의 데이터를 어느 좌표계에서 보려 합니까? | 1, 2 | [E3](../../exercises/ko/03_target_and_source.ipynb) |
# | 4 | 좌표계 트리 | 한 좌표계에서 다른 좌표계로 어떻게 갑니까? | 3 | 준비 중 |
# | 5 | map, odom, base_link | 고정 좌표계가 왜 둘이나 필요합니까? | 3, 4 | 준비 중 |
# | 6 | 정적 변환과 동적 변환 | 누가, 얼마나 자주 위치를 알려 줍니까? | 3, 4 | 준비 중 |
# | 7 | URDF와 센서 | 로봇의 부품은 어디에 붙어 있습니까? | 2, 6 | 준비 중 |
# | 8 | **[버퍼와 측정 시각](08_buffer_and_measurement_time.ipynb)** | 그것을 보았을 때 나는 어디에 있었습니까? | 3, 6 | [E8](../../exercises/ko/08_buffer_and_measurement_time.ipynb) |
# | 9 | **[예외와 기다림](09_exceptions_and_waiting.ipynb)** | 왜 답이 없습니까? 기다리면 됩니까? | 4, 8 | [E9](../../exercises/ko/09_exceptions_and_waiting.ipynb) |
# | 10 | 시계와 백 | 누구의 시간입니까? | 8, 9 | 준비 중 |
# | 11 | 도구와 RViz | 어떤 질문에 어떤 도구를 씁니까? | 4, 5, 8 | 준비 중 |
# | 12 | 발행 책임과 진단 | 각 연결은 누가 책임지고, 무엇이 고장 났습니까? | 5, 6, 7, 9, 10, 11 | 준비 중 |

# %% [markdown] lang="en" name="chapters-words" slide="-"
# Words with a dotted line explain themselves when you rest the pointer on them: [[transform]], for example.
# All of them stand together in the [glossary](90_glossary.ipynb).

# %% [markdown] lang="ko" name="chapters-words" slide="-"
# 점선이 그어진 낱말에 마우스를 올리면 설명이 나타납니다. [[transform|좌표 변환(transform)]]이 그 예입니다.
# 모든 용어는 [용어집](90_glossary.ipynb)에 모여 있습니다.

# %% [markdown] lang="en" name="checks" slide="slide"
# ## How your answers are checked
#
# Every chapter has exercises. Each task gives you something, asks for something, and checks it:
#
# ```python
# e2_2 = task("E2.2")          # prints what is given
# link_p_part = ...            # your answer goes here
# check("E2.2", link_p_part)   # says what is right, or which mistake it is
# hint("E2.2")                 # the next of three hints
# solution("E2.2")             # after a pass, or three tries
# ```
#
# A wrong answer is named for what it is. This is what `check` says if you hand back the camera's numbers unchanged:
#
# ```
# E2.2 ✗ 0/1: These are the numbers of the picture, unchanged. In camera_link, which of the three says how far ahead?
# ```
#
# You may try as often as you like, in any order.
# `check` tries your answer on a few cases; in a class, grading tries it on others that nobody has seen.

# %% [markdown] lang="ko" name="checks" slide="slide"
# ## 답을 확인하는 방법
#
# 장마다 연습 문제가 있습니다. 과제는 값을 주고, 답을 묻고, 확인합니다.
#
# ```python
# e2_2 = task("E2.2")          # prints what is given
# link_p_part = ...            # your answer goes here
# check("E2.2", link_p_part)   # says what is right, or which mistake it is
# hint("E2.2")                 # the next of three hints
# solution("E2.2")             # after a pass, or three tries
# ```
#
# 틀린 답을 내면 어떤 실수인지 알려 줍니다. 카메라의 숫자를 그대로 답하면 `check`는 다음과 같이 말합니다.
#
# ```
# E2.2 ✗ 0/1: 영상의 숫자를 그대로 썼습니다. camera_link에서는 셋 가운데 무엇이 앞으로의 거리입니까?
# ```
#
# 순서에 상관없이 몇 번이든 다시 해 볼 수 있습니다.
# `check`는 몇 가지 경우로 답을 확인합니다. 수업에서는 아무도 보지 못한 다른 경우로 채점합니다.

# %% [markdown] lang="en" name="progress-why" slide="skip"
# ## Where you stand
#
# Run the next cell whenever you like, or type `tflab progress` in a terminal.
# Only a passed check ticks anything, and the file behind it, `progress.json`, stays in your copy.
# When a new version of tflab comes, `tflab lab --update` brings it in around what you wrote.

# %% [markdown] lang="ko" name="progress-why" slide="skip"
# ## 나의 학습 현황
#
# 언제든지 다음 셀을 실행하거나, 터미널에서 `tflab progress`를 입력하십시오.
# check를 통과해야만 표시되며, 기록은 내 워크북의 `progress.json`에만 남습니다.
# tflab의 새 버전이 나오면 `tflab lab --update`로 받으십시오. 직접 쓴 내용은 그대로 남습니다.

# %% name="progress" tags=["interactive"]
show_progress()

# %% [markdown] lang="en" name="map-why" slide="slide"
# ## The map of the course
#
# An arrow means *builds on*.

# %% [markdown] lang="ko" name="map-why" slide="slide"
# ## 강의의 지도
#
# 화살표는 앞 장을 바탕으로 한다는 뜻입니다.

# %% name="map"
draw_course()
