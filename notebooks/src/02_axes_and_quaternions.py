# %% [markdown] lang="en" name="title" slide="slide"
# # 02 · Axes and quaternions
#
# **Which way is forward?** · about 45 minutes · builds on 01
#
# After this chapter you can
#
# - **Part 1, axes:** point along x, y and z of any robot, and say the sign of a rotation before the robot moves,
# - **Part 2, quaternions:** write the quaternion of a rotation, and recognise two wrong ones: zeros, and w first,
# - **Part 3, the camera:** convert a point or a pixel from a camera's optical frame to the robot, and name the one line to change if a point cloud is rotated by 90°.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 02 · 좌표축과 쿼터니언
#
# **어느 축이 앞이고, 회전은 어떻게 적을까요?** · 약 45분 · 01장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - **1부, 좌표축:** 로봇의 x, y, z축을 손으로 가리키고, 로봇이 회전하기 전에 회전각의 부호를 말할 수 있습니다.
# - **2부, 쿼터니언:** 회전을 쿼터니언으로 쓰고, 잘못된 쿼터니언 두 가지(모두 0인 것, w를 맨 앞에 쓴 것)를 알아볼 수 있습니다.
# - **3부, 카메라:** 카메라 광학 좌표계(optical frame) 기준의 점이나 픽셀을 로봇 기준으로 바꾸고, 90° 회전해 있는 포인트 클라우드를 보고 고쳐야 할 단 한 줄을 짚어 낼 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Ask everyone to stand up and point forward, left, up: x, y, z. Then ask them to imagine they are a camera and do it again.
# Half the class will not move their hands. This chapter is for that half.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 모두 일어나서 앞, 왼쪽, 위를 차례로 가리키게 합니다. 각각 x, y, z입니다. 이번에는 자신이 카메라라고 생각하고 카메라 광학 좌표계의 x, y, z를 가리키게 합니다.
# 절반은 손을 움직이지 않을 것입니다. 이 장은 그 절반을 위한 것입니다.

# %% [markdown] lang="en" name="needed" slide="skip"
# ## What you need for this chapter
#
# You need Python, and this from chapter 01:
#
# - A [[frame]] is an origin and three directions, with a name: `base_link`, `camera_link`. A message names its frame in `header.frame_id`.
# - A [[transform]] is the pose of one frame, the [[child frame|child]], in another, the [[parent frame|parent]]: a translation (metres) and a rotation. **This chapter is about the rotation.**
# - [[tf2|TF2]], TF for short, is the part of ROS 2 that stores all transforms and does this arithmetic for you. RViz is ROS 2's 3D visualiser.
# - Our robot has a camera: `camera_link` is at (0.10, 0, 0.30) in `base_link`, 10 cm ahead and 30 cm up.
#
# In code, a name contains both frames: `base_T_camera.apply(camera_p_mug)` transforms a point from the camera into the base. `@` chains two transforms. Chapter 03 explains both.
# What is called `lesson.…` belongs to this workbook. It draws, and formats numbers (`fmt_all`).

# %% [markdown] lang="ko" name="needed" slide="skip"
# ## 시작하기 전에 알아 둘 것
#
# 파이썬, 그리고 01장의 다음 내용만 알면 됩니다.
#
# - [[frame|좌표계(frame)]]는 원점과 세 방향에 이름을 붙인 것입니다. `base_link`, `camera_link`처럼 씁니다. 메시지는 자신의 좌표계를 `header.frame_id`에 적습니다.
# - [[transform|좌표 변환(transform)]]은 한 좌표계([[child frame|자식]])가 다른 좌표계([[parent frame|부모]])를 기준으로 어디에 있고 어느 방향을 향하는지 나타냅니다. 이동(미터)과 회전, 두 부분으로 이루어집니다. **이 장에서는 회전을 다룹니다.**
# - [[tf2|TF2]](줄여서 TF)는 변환을 모두 모아 두고 이런 계산을 대신해 주는 ROS 2의 라이브러리입니다. RViz는 ROS 2의 3D 시각화 도구입니다.
# - 우리 로봇에는 카메라가 달려 있습니다. `camera_link`는 `base_link` 기준 (0.10, 0, 0.30), 즉 로봇 중심에서 앞으로 10 cm, 위로 30 cm인 곳에 있습니다.
#
# 코드에서는 이름에 두 좌표계를 모두 적습니다. `base_T_camera.apply(camera_p_mug)`는 카메라 기준의 점을 base 기준으로 바꾸고, `@`는 변환 둘을 합성합니다. 둘 다 03장에서 자세히 다룹니다.
# `lesson.…`으로 부르는 것은 이 워크북의 도구입니다. 그림을 그리고, 숫자를 보기 좋게 적습니다(`fmt_all`).

# %% name="load" slide="skip"
# %load_ext tflab
import math

import numpy as np
from tflab.core import Transform
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## Half a day, lost in a contest
#
# In a simulated robot contest, cameras look at a bench, a [[detector]] finds the parts, and an arm picks them up.
# One team used a ready-made detector. It found the parts, and their positions were wrong.
#
# The mathematics, the detector and the camera were right.
# The header of the images named the frame of the camera's **body**, and the detector's numbers were in the camera's **optical** frame.
# It cost the team about half a day, during the competition.
# ([usnistgov/ARIAC, issue 345](https://github.com/usnistgov/ARIAC/issues/345). The organisers added the missing frame.)
#
# Here is the same mistake on our robot.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 대회에서 잃은 반나절
#
# 시뮬레이션으로 치르는 로봇 대회입니다. 카메라가 작업대를 보고, [[detector|검출기]]가 물건(부품)을 찾고, 로봇 팔이 집습니다.
# 한 팀은 이미 나와 있는 검출기를 가져다 썼습니다. 잘한 일입니다.
# 검출기는 물건을 찾아냈습니다. 그런데 위치가 모두 틀렸습니다.
#
# 계산은 맞았습니다. 검출기에도 카메라에도 문제가 없었습니다.
# 다만 영상에는 카메라 **본체**의 좌표계가 적혀 있었고, 검출기의 숫자는 카메라 **영상** 기준이었습니다.
# 팀의 기록에 따르면, 이 때문에 대회 도중 반나절쯤을 잃었습니다.
# ([usnistgov/ARIAC, 이슈 345](https://github.com/usnistgov/ARIAC/issues/345). 주최 측은 이후 빠져 있던 좌표계를 추가했습니다.)
#
# 우리 로봇에 같은 일이 일어나면 이렇게 됩니다. 물건 하나가 실제로 있는 곳과, 로봇 팔이 뻗는 곳입니다.
# *그림 읽기:* the part = 물건, where the arm goes = 로봇 팔이 뻗는 곳.

# %% name="story-picture" tags=["collapsed"] slide="subslide"
# Draw where the part is, and where the arm goes.
base_T_camera = Transform((0.10, 0.0, 0.30))
base_T_optical = base_T_camera @ lesson.BODY_T_OPTICAL
detected = (0.25, 0.15, 1.2)  # what the detector reported [m]
lesson.draw_scene(
    {"base_link": Transform(), "camera_link": base_T_camera},
    points={"the part": base_T_optical.apply(detected)},
    ghost_points={"where the arm goes": base_T_camera.apply(detected)},
    fixed_frame="base_link",
    length_m=0.2,
    size_inch=(5.4, 3.8),
    caption="in base_link; grid of 0.2 m",
)

# %% [markdown] lang="en" name="story-after"
# The grey circle is where the arm would go: up, above the camera, into the air.
# No error was raised. For the mathematics, one frame is as good as another.
# By the end of Part 3 you can find this fault in one minute, with one command.

# %% [markdown] lang="ko" name="story-after"
# 이대로라면 로봇 팔은 회색 원이 있는 곳으로 뻗습니다. 카메라보다 위쪽, 허공입니다.
# 오류는 하나도 나지 않았습니다. 헤더에 어느 좌표계가 적혀 있든 TF는 그대로 계산합니다.
# 3부를 마칠 때쯤이면 여러분은 이 결함을 명령 하나로, 1분 안에 찾아낼 것입니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Let the picture stand for ten seconds before you say anything. Ask: "which line of code is wrong?" None of them is. The header contains the wrong word.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 그림을 띄운 채 10초쯤 기다립니다. 그러고 나서 “어느 코드 줄이 틀렸습니까?”라고 묻습니다. 틀린 코드는 없습니다. 헤더에 적힌 단어 하나가 틀렸습니다.

# %% [markdown] lang="en" name="body-axes" slide="slide"
# ## Part 1 · The body: x forward, y left, z up
#
# ROS robots use these axes, by a convention called [[rep-103]].
# Lengths are in metres, angles in radians.
#
# Hold up your **right** hand like a pistol: index finger forward (x), thumb up (z), and the middle finger, stretched out from the palm, points left (y).
# With the left hand it points right.

# %% [markdown] lang="ko" name="body-axes" slide="slide"
# ## 1부 · 본체: x는 앞, y는 왼쪽, z는 위
#
# ROS 로봇은 관례에 따라 이 축을 씁니다. 이 관례의 이름은 [[rep-103]]입니다.
# 길이는 미터, 각도는 라디안을 씁니다.
#
# **오른손**을 권총 모양으로 들어 보세요. 검지는 앞(x), 엄지는 위(z), 가운뎃손가락을 손바닥과 직각으로 펴면 왼쪽(y)을 가리킵니다.
# 왼손으로 하면 오른쪽을 가리킵니다. 그래서 어느 손인지가 중요합니다.

# %% name="body-axes-figure" tags=["collapsed"]
# Draw the axes of the body.
lesson.draw_body_axes()

# %% [markdown] lang="en" name="body-axes-notes" slide="notes"
# Every hand is up before the figure appears. Walk round: in each row somebody holds up the left one.
# Ask that person in which direction y points, and let the neighbours find out why.

# %% [markdown] lang="ko" name="body-axes-notes" slide="notes"
# 그림을 보여 주기 전에 모두 손을 들게 하고 교실을 한 번 돌며 봅니다. 어느 줄에나 왼손을 든 사람이 있습니다.
# 그 사람에게 y가 어느 쪽인지 묻고, 왜 다른지는 옆 사람들이 찾게 합니다.

# %% [markdown] lang="en" name="body-axes-colours" slide="skip"
# In every figure x is a solid line, y is dashed, z is dotted, in RViz's order of colours: red, green, blue. ⊙ is an axis that points towards you, ⊗ one that points away from you.

# %% [markdown] lang="ko" name="body-axes-colours" slide="skip"
# 모든 그림에서 x는 실선, y는 파선, z는 점선이고, 색은 RViz처럼 빨강, 초록, 파랑 순서입니다. ⊙는 보는 사람 쪽으로 나오는 축, ⊗는 반대쪽으로 들어가는 축입니다.
# *그림 읽기:* forward = 앞, left = 왼쪽, up = 위.

# %% [markdown] lang="en" name="signs-predict" slide="slide"
# ### Say the sign before it moves
#
# The thumb of the right hand shows the axis, and the fingers curl in the **positive** direction.
#
# **Predict.** You send a robot a message with a velocity: `linear.x = 0.5` (half a metre per second forward) and `angular.z = -0.5` (half a radian per second about z). Does it go left or right?
# The rotations about x, y and z are called roll, pitch and yaw. With a *positive* pitch, does the robot's nose go up or down?

# %% [markdown] lang="ko" name="signs-predict" slide="slide"
# ### 움직이기 전에 부호를 말해 봅시다
#
# 이번에는 오른손 엄지가 축입니다. 나머지 손가락을 감아쥐는 방향이 <b>양(+)</b>의 회전입니다.
#
# **예측해 봅시다.** 속도를 정하는 메시지로 로봇에 `linear.x = 0.5`(앞으로 0.5 m/s)와 `angular.z = -0.5`(z축 중심으로 초당 0.5라디안)를 보냅니다. 왼쪽으로 회전할까요, 오른쪽으로 회전할까요?
# x, y, z축을 중심으로 하는 회전을 차례로 roll, pitch, yaw라고 합니다. pitch가 *양수*이면 로봇의 앞머리(기수)는 올라갈까요, 내려갈까요?

# %% name="signs-drive" tags=["predicted", "collapsed"] slide="fragment"
# Draw three drives.
lesson.draw_drives({"angular.z = +0.5": 0.5, "angular.z = 0": 0.0, "angular.z = -0.5": -0.5})

# %% name="signs-hand" tags=["predicted", "collapsed"] slide="subslide"
# Draw the positive rotations.
lesson.draw_right_hand()

# %% [markdown] lang="en" name="signs-after" tags=["predicted"] slide="fragment"
# Positive yaw turns **left**: from x towards y. So −0.5 goes right.
#
# Positive pitch puts the **nose down**. Pilots learn the opposite: in an aeroplane's frame y points right and z down, so a positive pitch lifts the nose.
# Neither is wrong. They are two conventions, and some drones use both.
#
# Positive roll lifts the left side.

# %% [markdown] lang="ko" name="signs-after" tags=["predicted"] slide="fragment"
# *그림 읽기:* about x = x축을 중심으로.
#
# yaw가 양수이면 **왼쪽**으로 회전합니다. x에서 y 쪽을 향하는 방향입니다. 따라서 −0.5는 오른쪽입니다.
#
# pitch가 양수이면 **기수가 내려갑니다**. 조종사가 배운 것과는 반대입니다. 비행기 좌표계에서는 z가 아래, y가 오른쪽을 향하므로 양수일 때 기수가 올라갑니다.
# 어느 쪽도 틀리지 않았습니다. 약속이 둘일 뿐이고, 드론 한 대 안에 두 약속이 함께 들어 있기도 합니다.
#
# roll이 양수이면 왼쪽이 올라갑니다.

# %% [markdown] lang="en" name="signs-notes" slide="notes"
# Let them vote on pitch before the figure. About half of the class is usually wrong, among them people who fly a drone.

# %% [markdown] lang="ko" name="signs-notes" slide="notes"
# 그림을 보여 주기 전에 pitch에 대해 손을 들게 합니다. 보통 반반으로 갈리고, 집에 드론이 있는 사람이 틀립니다.

# %% [markdown] lang="en" name="rpy" slide="slide"
# ### Roll, pitch, yaw
#
# [[roll pitch yaw|Three angles]] describe any rotation: roll about x, then pitch about y, then yaw about z.
# The three axes are **fixed**: they do not rotate with the robot.
# URDF's `rpy="..."` and the `--roll --pitch --yaw` of ROS 2's tools mean exactly this. (A [[urdf]] is the file that describes where a robot's parts are mounted.)

# %% [markdown] lang="ko" name="rpy" slide="slide"
# ### Roll, pitch, yaw
#
# [[roll pitch yaw|세 각도]]로 어떤 회전이든 나타낼 수 있습니다. x축 둘레로 roll, 다음에 y축 둘레로 pitch, 다음에 z축 둘레로 yaw만큼 회전시킵니다.
# 세 축은 **고정**되어 있습니다. 로봇이 회전하는 동안에도 축은 제자리에 있습니다.
# URDF의 `rpy="..."`와 ROS 2 도구의 `--roll --pitch --yaw`가 정확히 이 뜻입니다. ([[urdf]]는 로봇의 부품이 어디에 달려 있는지 적은 파일입니다.)

# %% [markdown] lang="en" name="order-predict" slide="subslide"
# **Does the order matter?** Take your phone, screen up, top edge forward.
# Rotate it by a 90° roll (left side up), then by a 90° yaw (to the left).
# Start again, in the other order. Both rotations are about directions of the *room*: the roll is always about the line that pointed forward at the beginning.
#
# **Predict:** does the top edge point in the same direction?

# %% [markdown] lang="ko" name="order-predict" slide="subslide"
# **순서를 바꾸면 달라질까요?** 휴대전화를 꺼내, 화면이 위, 위쪽 끝이 앞을 향하게 둡니다.
# roll로 90°(왼쪽이 위로), 다음에 yaw로 90°(왼쪽으로) 회전시킵니다.
# 처음 상태로 놓고 순서를 바꾸어 다시 해 보세요. 두 회전 모두 *방*의 방향을 기준으로 합니다. roll의 축은 언제나 처음에 앞을 향하던 직선입니다.
#
# **예측해 봅시다.** 위쪽 끝이 같은 방향을 향할까요?

# %% name="order-figure" tags=["predicted", "collapsed"] slide="fragment"
# Draw both orders.
lesson.draw_orders(("roll", math.pi / 2), ("yaw", math.pi / 2))

# %% name="order-numbers" tags=["predicted"] slide="subslide"
roll = Transform.from_rpy(roll=math.pi / 2)
yaw = Transform.from_rpy(yaw=math.pi / 2)
nose = (1.0, 0.0, 0.0)
print("first roll, then yaw:", lesson.fmt_all((yaw @ roll).apply(nose), ""))
print("first yaw, then roll:", lesson.fmt_all((roll @ yaw).apply(nose), ""))

# %% [markdown] lang="en" name="order-after" tags=["predicted"] slide="fragment"
# One robot faces left, the other looks at the ceiling: the order matters.
#
# In code, the rotation that happens **first** is on the **right**, next to the point: `yaw @ roll` is "roll, then yaw".
# `Transform.from_rpy(r, p, y)` is always `yaw @ pitch @ roll`.

# %% [markdown] lang="ko" name="order-after" tags=["predicted"] slide="fragment"
# *그림 읽기:* start = 시작, first roll, then yaw = 먼저 roll, 다음 yaw.
#
# 한 로봇은 왼쪽을 보고, 다른 로봇은 천장을 봅니다. 순서가 중요합니다.
#
# 코드에서 **먼저** 하는 회전은 **오른쪽**에 씁니다. 점에 먼저 적용되는 쪽입니다. `yaw @ roll`은 “roll 다음에 yaw”입니다.
# `Transform.from_rpy(r, p, y)`는 언제나 `yaw @ pitch @ roll`입니다.

# %% [markdown] lang="en" name="order-notes" slide="notes"
# Do it with a book in front of the class, both orders, and let somebody else call the rotations. Nobody forgets a book that ends up on its spine.

# %% [markdown] lang="ko" name="order-notes" slide="notes"
# 책 한 권을 들고 두 순서를 모두 보여 주되, 회전은 다른 사람이 부르게 합니다. 책이 다르게 놓인 것을 눈으로 보면 잊지 않습니다.

# %% [markdown] lang="en" name="rpy-move" slide="skip"
# Now move one slider at a time, and say aloud what will happen before you let go.
# The panel also writes the rotation as a *quaternion* (Part 2) and as a *matrix* (Part 3). For now, watch them change.

# %% [markdown] lang="ko" name="rpy-move" slide="skip"
# 이제 슬라이더를 한 번에 하나만 움직여 봅시다. 움직이기 전에 무슨 일이 일어날지 소리 내어 말해 보세요.
# 패널은 같은 회전을 *quaternion*(2부)과 *matrix*(3부)로도 적어 보여 줍니다. 지금은 어떻게 바뀌는지만 보십시오.
# *그림 읽기:* grey: fixed axes = 회색은 고정된 축.

# %% name="rpy-panel" tags=["interactive", "collapsed"] slide="subslide"
# Show the panel.
lesson.rotation_panel(roll_rad=0.0, pitch_rad=0.0, yaw_rad=math.pi / 6)

# %% name="rpy-figure" tags=["static"]
lesson.draw_rotation(roll_rad=0.0, pitch_rad=0.0, yaw_rad=math.pi / 6)

# %% [markdown] lang="en" name="rpy-try" slide="fragment"
# **Check of Part 1.** Which slider, to which side, makes the robot
#
# - look at the ceiling?
# - look to its right?
# - lie on its back?
#
# Answer with your hand, then with the slider.
#
# <details><summary>Solution</summary>
#
# Pitch −1.57: minus, because plus puts the nose down. Yaw −1.57: plus would be to the left. Roll 3.14 or −3.14: half a turn, the sign does not matter.
#
# </details>

# %% [markdown] lang="ko" name="rpy-try" slide="fragment"
# **1부 점검.** 어느 슬라이더를 어느 쪽으로 움직이면 로봇이 다음과 같이 될까요?
#
# - 천장을 봅니다.
# - 오른쪽을 봅니다.
# - 뒤집혀 눕습니다.
#
# 손으로 먼저 답하고, 슬라이더로 확인해 보세요.
#
# <details><summary>풀이</summary>
#
# 천장은 pitch −1.57입니다. 양수이면 기수가 내려가므로 음수여야 합니다. 오른쪽은 yaw −1.57입니다. 양수이면 왼쪽입니다. 뒤집히는 것은 roll 3.14나 −3.14입니다. 180° 회전이므로 부호는 상관없습니다.
#
# </details>

# %% [markdown] lang="en" name="rpy-notes" slide="notes"
# Ask for the ceiling first, before anybody touches a slider. Most say plus, and the nose goes down.
# One person moves, the others predict: nobody may do both.

# %% [markdown] lang="ko" name="rpy-notes" slide="notes"
# 슬라이더를 만지기 전에 천장부터 묻습니다. 대부분 양수라고 답하고, 기수는 내려갑니다.
# 한 사람은 움직이고 나머지는 예측합니다. 한 사람이 둘 다 하지 않게 합니다.

# %% [markdown] lang="en" name="recipe" slide="slide"
# ## Part 2 · Quaternions: four numbers for a rotation
#
# ROS **stores and sends** a rotation as a [[quaternion]]: four numbers (x, y, z, w), of length one. Three angles jump in some orientations (the optional section on gimbal lock shows it). A quaternion never does. Angles are for people: URDF files contain them, and tools print them.
#
# To rotate by an angle *a* about an axis (a direction of length one), use **half** the angle:
#
# ```
# (x, y, z) = axis * sin(a / 2)
#         w = cos(a / 2)
# ```
#
# **Worked example.** Rotate left by 90°. Left is yaw, so the axis is z: (0, 0, 1).
# Half of 90° is 45°, and sin 45° = cos 45° = 0.707.
# So (x, y, z, w) = (0, 0, 0.707, 0.707).

# %% [markdown] lang="ko" name="recipe" slide="slide"
# ## 2부 · 쿼터니언: 숫자 네 개로 적는 회전
#
# ROS는 회전을 [[quaternion|쿼터니언(quaternion, 사원수)]]으로 **저장하고 전송합니다**. 길이가 1인 숫자 네 개 (x, y, z, w)입니다. 세 각도는 특정한 방향에서 갑자기 튀지만(뒤의 짐벌 락 절에서 다룹니다), 쿼터니언은 어디에서도 튀지 않습니다. 각도는 사람을 위한 것입니다. URDF에는 사람이 각도로 적고, 도구는 사람에게 각도로 보여 줍니다.
#
# 어떤 축(길이 1인 방향)을 중심으로 각도 *a*만큼 회전하려면 각도의 **절반**을 씁니다.
#
# ```
# (x, y, z) = axis * sin(a / 2)
#         w = cos(a / 2)
# ```
#
# **예제.** 왼쪽으로 90° 회전합니다. 왼쪽 회전은 yaw이므로 축은 z, 곧 (0, 0, 1)입니다.
# 90°의 절반은 45°이고 sin 45° = cos 45° = 0.707입니다.
# 따라서 (x, y, z, w) = (0, 0, 0.707, 0.707)입니다.

# %% name="recipe-run" slide="fragment"
a = math.radians(90)
left_90 = (0.0, 0.0, math.sin(a / 2), math.cos(a / 2))
print("quaternion:", lesson.fmt_all(left_90, ""))
print("the nose, after it:", lesson.fmt_all(Transform(rotation=left_90).apply((1.0, 0.0, 0.0)), ""))

# %% [markdown] lang="en" name="recipe-notes" slide="notes"
# Somebody will ask: why half? The short answer: the formula that rotates a point uses the quaternion twice, once on each side of the point.
# Leave the two lines on the board until the end.

# %% [markdown] lang="ko" name="recipe-notes" slide="notes"
# 왜 절반이냐는 질문이 꼭 나옵니다. 짧고 정직한 답은 이렇습니다. 점을 회전시키는 식에서 쿼터니언은 점의 양쪽에 한 번씩, 모두 두 번 쓰입니다.
# 공식 두 줄은 끝날 때까지 칠판에 남겨 둡니다.

# %% [markdown] lang="en" name="four-facts" slide="slide"
# ### Four facts that save an afternoon each
#
# | quaternion (x, y, z, w) | what it is |
# |---|---|
# | (0, 0, 0, 1) | no rotation |
# | (0, 0, 0, 0) | nothing at all: not a rotation. TF rejects it |
# | q and −q | the same rotation |
# | (1, 0, 0, 0) | a rotation by 180° about x: the robot is on its back |
#
# The last line is what "no rotation" looks like if a program writes **w first**.
# Eigen's constructor (C++), the simulator MuJoCo and many papers do. ROS, RViz and SciPy write w last.

# %% [markdown] lang="ko" name="four-facts" slide="slide"
# ### 반나절씩 아껴 주는 네 가지 사실
#
# | 쿼터니언 (x, y, z, w) | 뜻 |
# |---|---|
# | (0, 0, 0, 1) | 회전 없음 |
# | (0, 0, 0, 0) | 회전이 아님. TF가 거절합니다 |
# | q와 −q | 같은 회전 |
# | (1, 0, 0, 0) | x축으로 180°: 로봇이 뒤집혀 누워 있습니다 |
#
# 마지막 줄은 **w를 맨 앞에** 쓰는 프로그램이 보낸 “회전 없음”을 (x, y, z, w)로 읽은 것입니다.
# Eigen(C++ 라이브러리)의 생성자, 시뮬레이터 MuJoCo, 여러 논문이 w를 먼저 씁니다. ROS, RViz, SciPy는 w를 마지막에 씁니다.

# %% [markdown] lang="en" name="four-facts-notes" slide="notes"
# Cover the right column and let the class fill it, line by line. The class will disagree about the second line. Leave it open. It returns after the core, in "Let TF do the arithmetic, and break it with zeros".

# %% [markdown] lang="ko" name="four-facts-notes" slide="notes"
# 표의 오른쪽 열을 가리고 한 줄씩 채우게 합니다. 둘째 줄에서 의견이 갈립니다. 답하지 말고 두십시오. 핵심 뒤의 “TF에 계산을 맡기고, 0으로 고장 내기”에서 다시 나옵니다.

# %% [markdown] lang="en" name="w-first" slide="subslide"
# Now MuJoCo sends a rotation by 20° to the left. **Predict** what the robot does if the four numbers are read as (x, y, z, w).

# %% [markdown] lang="ko" name="w-first" slide="subslide"
# MuJoCo가 왼쪽으로 20° 도는 작은 회전을 보냅니다. 네 숫자를 (x, y, z, w)로 읽으면 로봇이 어떻게 될지 **예측**해 봅시다.

# %% name="w-first-run" tags=["predicted"] slide="fragment"
a = math.radians(20)
w, x, y, z = math.cos(a / 2), 0.0, 0.0, math.sin(a / 2)  # in MuJoCo's order
for name, q in (("taken as it came", (w, x, y, z)), ("put in order", (x, y, z, w))):
    angles = (math.degrees(part) for part in Transform(rotation=q).rpy())
    print(f"{name}: roll, pitch, yaw", lesson.fmt_all(tuple(angles), "degrees", 1))

# %% [markdown] lang="en" name="w-first-after" tags=["predicted"] slide="fragment"
# Roll 160°: upside down, wheels in the air.
# So if a robot is upside down in RViz, check first whether the quaternion was written with w first.
# Convert once, where the data enters your program, in a function whose name states the order: `xyzw_from_wxyz`.

# %% [markdown] lang="ko" name="w-first-after" tags=["predicted"] slide="fragment"
# roll이 160°입니다. 로봇이 뒤집혀 바퀴가 하늘을 향합니다.
# RViz에서 로봇이 뒤집혀 있다면 먼저 w를 맨 앞에 쓰지 않았는지 확인하십시오.
# 순서를 바꾸는 일은 데이터가 드나드는 경계에서 한 번만, 이름만 보아도 뜻이 드러나는 함수로 하십시오. `xyzw_from_wxyz`가 그런 이름입니다.

# %% [markdown] lang="en" name="w-first-notes" slide="notes"
# Ask who has seen a robot on its back in RViz. Then ask how long it took to find out why. The median is longer than this lecture.

# %% [markdown] lang="ko" name="w-first-notes" slide="notes"
# RViz에서 뒤집힌 로봇을 본 사람이 있는지 묻습니다. 이유를 찾는 데 얼마나 걸렸는지도 묻습니다. 대개 이 강의보다 오래 걸립니다.

# %% [markdown] lang="en" name="faded" slide="subslide"
# **Check of Part 2, with two blanks.** Rotate *right* by 40°. Replace the two `...` and run the cell again.

# %% [markdown] lang="ko" name="faded" slide="subslide"
# **2부 점검: 빈칸 두 개를 채워 보세요.** *오른쪽*으로 40° 회전합니다. `...` 두 개를 바꾸고 셀을 다시 실행해 보세요.

# %% name="faded-run"
half = math.radians(-40) / 2  # to the right is negative
right_40 = (0.0, 0.0, ..., ...)  # fill in z and w
if ... in right_40:
    print("2 blanks")
else:
    print("that is a yaw of", lesson.fmt(math.degrees(Transform(rotation=right_40).rpy()[2]), "degrees", 1))

# %% [markdown] lang="en" name="faded-answer"
# <details><summary>What belongs there?</summary>
#
# `math.sin(half)` and `math.cos(half)`. You should read "a yaw of -40.0 degrees".
#
# - 40.0: the minus sign is missing. Use `half`, which is negative, and not 20°.
# - -80.0: a quaternion uses *half* the angle, and you used the whole angle.
# - -140.0: you swapped sine and cosine. z takes the sine, w the cosine.
#
# </details>

# %% [markdown] lang="ko" name="faded-answer"
# <details><summary>무엇이 들어가야 할까요?</summary>
#
# `math.sin(half)`와 `math.cos(half)`입니다. "a yaw of -40.0 degrees"가 나와야 합니다.
#
# - 40.0이면 부호가 빠졌습니다. 부호는 `half`에 들어 있으니 20°를 직접 쓰지 말고 `half`를 쓰십시오.
# - -80.0이면 각도를 통째로 넣었습니다. 쿼터니언에는 각도의 *절반*이 들어갑니다.
# - -140.0이면 sin과 cos의 자리를 바꾸어 썼습니다. z가 sin, w가 cos입니다.
#
# </details>

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Part 3 · A camera has two frames
#
# `camera_link` has the axes of the body. `camera_optical_frame` has the same origin and the axes of the image, where pixels are counted to the right and down.
#
# A mug stands 2 m straight ahead of the camera. In the image it is exactly in the middle.
#
# **Predict.** Write down two sets of coordinates on paper, now: where is the mug in `camera_link`, and where is it in `camera_optical_frame`?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 3부 · 카메라에는 좌표계가 둘입니다
#
# `camera_link`의 축은 본체의 축과 같습니다. `camera_optical_frame`은 원점이 같고, 영상의 축을 씁니다. 영상에서 픽셀은 오른쪽과 아래로 셉니다.
#
# 머그컵이 카메라 정면 2 m 앞에 있습니다. 영상에서는 정확히 한가운데에 보입니다.
#
# **예측해 봅시다.** 지금 종이에 좌표를 두 개 적어 보세요. 머그컵은 `camera_link` 기준으로 어디에 있을까요? `camera_optical_frame` 기준으로는 어디에 있을까요?

# %% name="predict-run" tags=["predicted", "collapsed"] slide="fragment"
# Print the mug in both frames.
mug = (2.0, 0.0, 0.0)
print("in camera_link          ", lesson.fmt_all(mug))
print("in camera_optical_frame ", lesson.fmt_all(lesson.optical_from_body(mug)))

# %% [markdown] lang="en" name="predict-replies" slide="fragment"
# What did you write for the second one?
#
# <details><summary>(2, 0, 0) again</summary>
#
# That is the mistake of the contest. It is one point in two frames: the coordinates must differ, because the axes do.
#
# </details>
# <details><summary>(0, 0, −2)</summary>
#
# Depth is z, but your z points backward, as in computer graphics (OpenGL). ROS cameras look along **+z**.
#
# </details>
# <details><summary>(0, −2, 0)</summary>
#
# You used the right rotation in the wrong direction: from the optical frame to the body. Chapter 03 has a sentence that prevents this mistake.
#
# </details>
# <details><summary>(0, 0, 2)</summary>
#
# Right. Keep the paper: you will need to say *why* at the end.
#
# </details>

# %% [markdown] lang="ko" name="predict-replies" slide="fragment"
# 두 번째 좌표를 무엇이라고 적었습니까?
#
# <details><summary>똑같이 (2, 0, 0)</summary>
#
# 대회에서 일어난 바로 그 실수입니다. 점은 하나지만 좌표계는 둘입니다. 축이 다르므로 숫자도 달라야 합니다.
#
# </details>
# <details><summary>(0, 0, −2)</summary>
#
# 깊이가 z인 것은 맞지만, 컴퓨터 그래픽스(OpenGL)처럼 z가 뒤를 향하고 있습니다. ROS의 카메라는 **+z** 방향을 봅니다.
#
# </details>
# <details><summary>(0, −2, 0)</summary>
#
# 회전은 맞지만 거꾸로 썼습니다. 광학 좌표계 기준의 값을 본체 기준으로 바꿀 때 쓰는 회전입니다. 이 실수를 막아 주는 문장을 03장에서 배웁니다.
#
# </details>
# <details><summary>(0, 0, 2)</summary>
#
# 맞습니다. 종이는 버리지 마십시오. 마지막에 *왜* 그런지 말해야 합니다.
#
# </details>

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Collect the answers on the board before you run the cell, with a count for each. Leave them there: you need them at the end.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 셀을 실행하기 전에 답을 칠판에 모으고 각각 몇 명인지 적습니다. 지우지 마십시오. 마지막에 다시 봅니다.

# %% [markdown] lang="en" name="optical" slide="slide"
# ### The optical frame: z forward, x right, y down
#
# Computer vision keeps the directions of the pixels in space: x **right**, y **down**, and by the right-hand rule z points **forward**, into the scene.
# ROS calls such a frame an [[optical frame]], and its name ends in `_optical_frame`.
#
# Move the mug. Watch the coordinates of the same point in both frames.

# %% [markdown] lang="ko" name="optical" slide="slide"
# ### 광학 좌표계: z는 앞, x는 오른쪽, y는 아래
#
# 컴퓨터 비전에서는 공간에서도 픽셀의 방향을 그대로 씁니다. x가 **오른쪽**, y가 **아래**이면, 오른손 법칙에 따라 z는 장면 속으로 들어가는 **앞**입니다.
# ROS에서는 이런 좌표계를 [[optical frame|광학 좌표계(optical frame)]]라고 부르고, 이름을 `_optical_frame`으로 끝냅니다.
#
# 머그컵을 움직이면서, 같은 점의 좌표가 두 좌표계에서 어떻게 달라지는지 살펴보세요.

# %% name="optical-panel" tags=["interactive", "collapsed"] slide="subslide"
# Show the panel.
lesson.cameras_panel(forward_m=2.0, left_m=0.5, up_m=0.3)

# %% name="optical-figure" tags=["static"]
lesson.draw_cameras((2.0, 0.5, 0.3))

# %% [markdown] lang="en" name="optical-notes" slide="notes"
# Two volunteers: one is the robot's body, one is the camera's image. They look at the same mug and read out their three coordinates at once.

# %% [markdown] lang="ko" name="optical-notes" slide="notes"
# 두 사람이 나옵니다. 한 사람은 로봇 본체, 한 사람은 카메라 영상입니다. 같은 머그컵의 세 숫자를 동시에 읽게 합니다.

# %% [markdown] lang="en" name="two-turns" slide="slide"
# ### Two rotations by 90°
#
# Take the camera's body axes, and rotate about the fixed axes, roll first:
#
# 1. roll −90°: y (left) goes down. Now x is forward, **y is down**, z is left.
# 2. yaw −90°: x (forward) goes right, z (left) goes forward. Now **x is right, y is down, z is forward**.
#
# The rotation to remember: **rpy (−π/2, 0, −π/2)**. As a quaternion: **(−0.5, 0.5, −0.5, 0.5)**.

# %% [markdown] lang="ko" name="two-turns" slide="slide"
# ### 90° 회전 두 번
#
# 본체의 축을 어떻게 회전시키면 영상의 축이 될까요? 카메라 본체의 축에서 시작하여 고정축을 중심으로, roll부터 회전시킵니다.
#
# 1. roll −90°: y(왼쪽)가 아래로 갑니다. 이제 x는 앞, **y는 아래**, z는 왼쪽입니다.
# 2. yaw −90°: x(앞)가 오른쪽으로, z(왼쪽)가 앞으로 갑니다. 이제 **x는 오른쪽, y는 아래, z는 앞**입니다.
#
# 외워 둘 회전은 <b>rpy (−π/2, 0, −π/2)</b>입니다. 쿼터니언으로 쓰면 **(−0.5, 0.5, −0.5, 0.5)**, 크기는 모두 같고 부호만 다릅니다.

# %% name="two-turns-figure" tags=["collapsed"]
# Draw the two rotations.
lesson.draw_turns(("roll", -math.pi / 2), ("yaw", -math.pi / 2))

# %% name="two-turns-run" slide="subslide"
camera_T_optical = Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)
print("quaternion (x, y, z, w):", lesson.fmt_all(camera_T_optical.rotation, ""))
for axis, direction in {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}.items():
    print(f"optical {axis}, in camera_link:", lesson.fmt_all(camera_T_optical.apply(direction), "", 0))

# %% [markdown] lang="en" name="two-turns-after" slide="fragment"
# Read the three lines aloud: optical x points to minus y, that is, right. Optical y points to minus z: down. Optical z points to plus x: forward.
# These lines are the three **columns** of the rotation matrix, the nine numbers of the panel in Part 1: the directions of the child's axes in the parent.
#
# So a point (right, down, forward) in the optical frame is (forward, −right, −down) in the camera's body frame.

# %% [markdown] lang="ko" name="two-turns-after" slide="fragment"
# 세 줄을 소리 내어 읽어 보세요. 광학 좌표계의 x는 −y, 즉 오른쪽을 향합니다. 광학 좌표계의 y는 −z, 즉 아래를 향합니다. 광학 좌표계의 z는 +x, 즉 앞을 향합니다.
# 이 세 줄이 회전 행렬(1부 패널의 숫자 아홉 개)의 세 **열**입니다. 회전 행렬은 자식의 축이 부모를 기준으로 어디를 향하는지 적은 것입니다.
#
# 따라서 광학 좌표계 기준으로 (오른쪽, 아래, 앞)인 점은 카메라 본체 기준으로 (앞, −오른쪽, −아래)입니다.

# %% [markdown] lang="en" name="worked" slide="subslide"
# ### Worked example: from a detection to the robot
#
# A detector reports: 0.40 m to the right, 0.20 m **above** the middle of the image, 1.50 m deep. Where is it in `base_link`?
#
# 1. In the optical frame, up is minus down: (0.40, −0.20, 1.50).
# 2. In `camera_link`: (forward, −right, −down) = (1.50, −0.40, 0.20). Check with your hand: ahead, to the right, above. Yes.
# 3. The camera is at (0.10, 0, 0.30) and not rotated: add. (1.60, −0.40, 0.50).

# %% [markdown] lang="ko" name="worked" slide="subslide"
# ### 예제: 검출 결과에서 로봇까지
#
# 검출 결과입니다. 영상 중심에서 오른쪽으로 0.40 m, **위로** 0.20 m, 깊이 1.50 m. `base_link` 기준으로 어디일까요?
#
# 1. 광학 좌표계에서는 아래가 +y이므로, 위로 0.20 m는 y = −0.20입니다. (0.40, −0.20, 1.50).
# 2. `camera_link`에서는 (앞, −오른쪽, −아래) = (1.50, −0.40, 0.20)입니다. 손으로 확인해 보세요. 앞쪽, 오른쪽, 위쪽. 맞습니다.
# 3. 카메라는 (0.10, 0, 0.30)에 있고 회전이 없으므로 더합니다. (1.60, −0.40, 0.50).

# %% name="worked-run" slide="fragment"
optical_p_mug = (0.40, -0.20, 1.50)
camera_p_mug = camera_T_optical.apply(optical_p_mug)
base_p_mug = base_T_camera.apply(camera_p_mug)
print("camera_link:", lesson.fmt_all(camera_p_mug))
print("base_link:  ", lesson.fmt_all(base_p_mug))

# %% [markdown] lang="en" name="worked-notes" slide="notes"
# Insist on the hand check in step 2. A sign that was checked with a hand is right; a sign that was derived is right most of the time.

# %% [markdown] lang="ko" name="worked-notes" slide="notes"
# 2단계의 손 확인을 꼭 시킵니다. 부호를 유도만 하면 틀릴 때가 있지만, 손으로 확인한 부호는 맞습니다.

# %% [markdown] lang="en" name="ray" slide="slide"
# ### From a pixel to a ray
#
# A detector without depth reports only a pixel: *u* counts to the right, *v* down.
# The driver publishes the camera's numbers on the topic `camera_info`: the focal lengths fx and fy, and the centre (cx, cy), all in pixels.
#
# ```
# x / z = (u - cx) / fx        y / z = (v - cy) / fy
# ```
#
# So a pixel gives a direction in the optical frame, ((u − cx)/fx, (v − cy)/fy, 1). The object is somewhere on this ray.
#
# **Predict.** fx = fy = 525, and the centre is (320, 240). The mug is at pixel (460, 170). In `base_link`, is the y of the ray positive or negative? And its z?

# %% [markdown] lang="ko" name="ray" slide="slide"
# ### 픽셀에서 광선으로
#
# 깊이를 모르는 검출기는 픽셀만 알려 줍니다. *u*는 오른쪽으로, *v*는 아래로 셉니다.
# 카메라의 수치는 드라이버가 `camera_info` 토픽에 발행합니다. 초점 거리 fx, fy와 영상 중심 (cx, cy)이며, 단위는 모두 픽셀입니다.
#
# ```
# x / z = (u - cx) / fx        y / z = (v - cy) / fy
# ```
#
# 따라서 픽셀 하나는 광학 좌표계의 한 방향 ((u − cx)/fx, (v − cy)/fy, 1)이 됩니다. 물체는 이 광선 위 어딘가에 있습니다.
#
# **예측해 봅시다.** fx = fy = 525이고 영상 중심은 (320, 240)입니다. 머그컵이 픽셀 (460, 170)에 보입니다. `base_link` 기준으로 광선의 y는 양수일까요, 음수일까요? z는 어떨까요?

# %% name="ray-run" tags=["predicted"] slide="fragment"
from sensor_msgs.msg import CameraInfo

info = CameraInfo(k=[525.0, 0.0, 320.0, 0.0, 525.0, 240.0, 0.0, 0.0, 1.0])
fx, cx, fy, cy = info.k[0], info.k[2], info.k[4], info.k[5]
u, v = 460.0, 170.0
optical_ray = ((u - cx) / fx, (v - cy) / fy, 1.0)
# base_T_optical is base_T_camera @ camera_T_optical; a direction needs its rotation only
base_ray = Transform(rotation=base_T_optical.rotation).apply(optical_ray)
print("ray in the optical frame:", lesson.fmt_all(optical_ray, ""))
print("ray in base_link:        ", lesson.fmt_all(base_ray, ""))

# %% [markdown] lang="en" name="ray-after" tags=["predicted"] slide="fragment"
# y is negative: to the right. z is positive: the ray rises.
# The ray starts at the camera, (0.10, 0, 0.30). A direction has no position, so **only the rotation** applies to it; in ROS 2 it is a `Vector3Stamped`, and TF leaves the translation out.

# %% [markdown] lang="ko" name="ray-after" tags=["predicted"] slide="fragment"
# y는 음수, 곧 오른쪽입니다. z는 양수, 곧 위로 올라가는 광선입니다.
# 광선은 카메라의 위치 (0.10, 0, 0.30)에서 출발합니다. 방향에는 위치가 없으므로 **회전만** 적용합니다. ROS 2에서는 방향을 `Vector3Stamped`에 담으며, TF가 이동을 빼고 변환합니다.

# %% [markdown] lang="en" name="ray-view" slide="skip"
# Here is the ray. Every point on it is seen at the same pixel. In the 3D view, the pyramid is the camera's field of view.

# %% [markdown] lang="ko" name="ray-view" slide="skip"
# 이 광선을 그려 보았습니다. 광선 위의 점은 모두 같은 픽셀에 보입니다. 3D 화면의 피라미드는 카메라가 보는 범위입니다.
# *그림 읽기:* mug = 머그컵, deep = 깊이, grid = 격자.

# %% name="scene-3d" tags=["interactive", "collapsed"] slide="subslide"
# Show the ray in 3D.
view = lesson.Scene(height_px=380, grid_m=0.5)
lesson.draw_frame(view, "base_link", Transform(), length_m=0.3)
lesson.draw_frame(view, "camera_optical_frame", base_T_optical, "base_link", length_m=0.3)
lesson.draw_camera(view, "camera", base_T_optical, depth_m=1.0, pixels=[(460.0, 170.0)])
lesson.draw_arrow(view, "ray", base_T_optical.translation, base_p_mug)
lesson.draw_mug(view, "mug", base_p_mug)
view

# %% name="scene-figure" tags=["static"]
on_the_ray = {f"{z} m deep": base_T_optical.apply(np.multiply(optical_ray, z)) for z in (0.5, 1.0)}
lesson.draw_scene(
    {"base_link": Transform(), "camera_optical_frame": base_T_optical},
    points={**on_the_ray, "mug": base_p_mug},
    fixed_frame="base_link",
    length_m=0.2,
    size_inch=(5.4, 3.2),
    caption="in base_link; grid of 0.5 m",
)

# %% [markdown] lang="en" name="ray-check" slide="skip"
# **Check.** A depth image has 3.0 m at this pixel. Where is that point in `base_link`?
#
# <details><summary>(3.00, −0.80, 0.40)</summary>
#
# That is three times the ray, but from the origin of `base_link`. The ray starts at the camera.
#
# </details>
# <details><summary>(2.98, −0.77, 0.68)</summary>
#
# You went 3.0 m *along* the ray. A depth image contains z, so multiply the ray whose z is 1. (A laser measures along the ray.)
#
# </details>
# <details><summary>(3.10, −0.80, 0.70)</summary>
#
# Right: (0.10, 0, 0.30) + 3.0 · (1, −0.267, 0.133). With 1.5 m you get the mug of the worked example.
#
# </details>

# %% [markdown] lang="ko" name="ray-check" slide="skip"
# **점검.** 깊이 영상의 이 픽셀에 3.0 m가 들어 있습니다. 이 점은 `base_link` 기준으로 어디에 있을까요?
#
# <details><summary>(3.00, −0.80, 0.40)</summary>
#
# 광선의 세 배이지만 `base_link`의 원점에서 출발했습니다. 광선은 카메라에서 출발합니다.
#
# </details>
# <details><summary>(2.98, −0.77, 0.68)</summary>
#
# 광선을 *따라* 3.0 m를 갔습니다. 깊이 영상에는 z가 들어 있으므로, z가 1인 광선에 곱합니다. (레이저는 광선을 따라 잽니다.)
#
# </details>
# <details><summary>(3.10, −0.80, 0.70)</summary>
#
# 맞습니다. (0.10, 0, 0.30) + 3.0 · (1, −0.267, 0.133)입니다. 1.5 m라면 위 예제의 머그컵이 됩니다.
#
# </details>

# %% [markdown] lang="en" name="why-two" slide="slide"
# ### Why two frames, and which one goes into the header?
#
# - `camera_link` is where the camera is **mounted**. It is used for mechanics and URDF: x forward, like everything else on the robot.
# - `camera_optical_frame` is the frame in which its **data** is expressed: images, detections, rays, depth clouds.
#
# The driver writes the **optical** frame into the header. Then no node has to convert anything: TF does.

# %% [markdown] lang="ko" name="why-two" slide="slide"
# ### 좌표계는 왜 둘이고, 헤더에는 어느 것을 적을까요?
#
# - `camera_link`는 카메라가 **장착된** 자리입니다. 기구 설계와 URDF, 자로 잰 치수는 이 좌표계를 따르며, 로봇의 다른 부분처럼 x가 앞입니다.
# - `camera_optical_frame`은 카메라 **데이터**의 기준입니다. 영상, 검출 결과, 광선, 깊이 포인트 클라우드가 여기에 속합니다.
#
# 드라이버는 데이터의 헤더에 **광학 좌표계**를 적습니다. 그러면 어느 노드도 직접 바꿀 필요가 없습니다. TF가 바꿉니다.

# %% [markdown] lang="en" name="why-two-notes" slide="notes"
# Before this slide, ask: you write the driver, what do you put into the header? Count the hands for each frame.

# %% [markdown] lang="ko" name="why-two-notes" slide="notes"
# 이 슬라이드를 보여 주기 전에 묻습니다. 여러분이 드라이버를 만든다면 헤더에 무엇을 적겠습니까? 좌표계마다 손을 든 사람을 세어 봅니다.

# %% [markdown] lang="en" name="break-zero" slide="slide"
# ### From arithmetic to ROS 2
#
# On a robot, TF multiplies the transforms. A [[node]] is a program with a name that takes part in ROS 2. A [[broadcaster]] is the part of a node that publishes a transform, such as the camera's mount.
# A line that begins with `%ros2` is a command of ROS 2; on a robot you type it in a terminal.
#
# First, the camera as it should be: its mount, and its optical frame.
# Note the second command. It is the one that was missing in the contest.

# %% [markdown] lang="ko" name="break-zero" slide="slide"
# ### 계산에서 ROS 2로
#
# 로봇에서는 변환을 TF가 합성합니다. [[node|노드]]는 이름을 가지고 ROS 2 통신에 참여하는 프로그램이고, [[broadcaster|변환 발행기]]는 노드 안에서 카메라의 장착 변환 같은 변환을 발행하는 객체입니다.
# `%ros2`로 시작하는 줄은 ROS 2 명령입니다. 로봇에서는 터미널에 입력합니다.
#
# 먼저 올바른 카메라부터 만듭니다. 카메라를 장착하고, 같은 자리에 광학 좌표계를 둡니다.
# 두 번째 명령을 눈여겨보십시오. 대회에서 빠져 있던 바로 그 명령입니다.

# %% name="mount-camera"
# %ros2 run tf2_ros static_transform_publisher --x 0.10 --z 0.30 \
#     --frame-id base_link --child-frame-id camera_link
# %ros2 run tf2_ros static_transform_publisher --roll -1.5707963 --yaw -1.5707963 \
#     --frame-id camera_link --child-frame-id camera_optical_frame

# %% [markdown] lang="en" name="break-cloud" slide="slide"
# ### Break it on purpose: one word in a header
#
# A depth camera sees a wall 2 m ahead, and the floor in front of it. Here is what it measures, along its own axes: right, down, forward.

# %% [markdown] lang="ko" name="break-cloud" slide="slide"
# ### 일부러 고장 내기: 헤더의 단어 하나
#
# 깊이 카메라가 2 m 앞의 벽과 그 앞의 바닥을 보고 있습니다. 카메라 자신의 축(오른쪽, 아래, 앞)으로 잰 값은 이렇습니다.

# %% name="cloud" tags=["collapsed"]
# Prepare the camera's data, and print where it is.
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py.point_cloud2 import create_cloud_xyz32, read_points_numpy
from std_msgs.msg import Header

wall, floor = lesson.wall_cloud(), lesson.floor_cloud()  # points (x, y, z), one a row
print(lesson.describe_extent({"wall": wall, "floor": floor}, "the optical frame"))

# %% [markdown] lang="en" name="cloud-node" slide="subslide"
# And its driver: a node that publishes the cloud on the [[topic]] `/camera/points`, five times a second. Somebody set the parameter `frame_id` to the frame in which the camera is mounted.

# %% [markdown] lang="ko" name="cloud-node" slide="subslide"
# 드라이버는 다음과 같습니다. 1초에 다섯 번 `/camera/points` [[topic]]에 클라우드를 발행하는 노드입니다. 누군가 `frame_id` 파라미터에 카메라가 장착된 좌표계를 적었습니다.

# %% name="cloud-driver"
def depth_camera():
    rclpy.init()
    node = Node("depth_camera")
    node.declare_parameter("frame_id", "camera_link")
    publisher = node.create_publisher(PointCloud2, "/camera/points", 10)

    def publish():
        header = Header(stamp=node.get_clock().now().to_msg())
        header.frame_id = node.get_parameter("frame_id").value
        publisher.publish(create_cloud_xyz32(header, np.vstack([wall, floor])))

    node.create_timer(0.2, publish)
    rclpy.spin(node)

# %% name="cloud-start" tags=["collapsed"] slide="skip"
# Start the driver.
graph.start(depth_camera, name="depth_camera")
graph.run(seconds=1.0)

# %% [markdown] lang="en" name="cloud-predict" slide="subslide"
# **Predict.** Where does RViz draw the wall? Where is the floor?
# Use your right hand: right becomes *forward*, down becomes *left*, forward becomes *up*.

# %% [markdown] lang="ko" name="cloud-predict" slide="subslide"
# **예측해 봅시다.** RViz는 벽을 어디에 그릴까요? 바닥은 어디에 그릴까요?
# 오른손을 들어 보세요. 오른쪽이 *앞*이 되고, 아래가 *왼쪽*이 되고, 앞이 *위*가 됩니다.

# %% name="cloud-rviz" tags=["interactive"] slide="fragment"
# %rviz2 -f base_link

# %% name="cloud-figure" tags=["predicted", "collapsed"] slide="subslide"
# Draw the cloud under both names.
lesson.draw_misread(
    {"wall": base_T_optical.apply(wall), "floor": base_T_optical.apply(floor)},
    {"wall": base_T_camera.apply(wall), "floor": base_T_camera.apply(floor)},
    titles=("frame_id: camera_optical_frame", "frame_id: camera_link"),
)

# %% [markdown] lang="en" name="cloud-after" tags=["predicted"]
# The wall is above the robot like a ceiling, and the floor stands upright at its left.
# TF raised nothing: it transformed points from `camera_link` into `base_link`, as the header specifies.
# A planner that looks for obstacles ahead of the robot finds none, and drives into the wall that its own camera sees.
#
# The fix is **one word in the header**, not mathematics in your node. Find it, change it, look again.

# %% [markdown] lang="ko" name="cloud-after" tags=["predicted"]
# *그림 읽기:* wall = 벽, floor = 바닥. 그림 위의 글은 데이터에 적힌 `frame_id`입니다.
#
# 벽은 천장이 되어 로봇 위에 떠 있고, 바닥은 왼쪽 공중에 서 있습니다.
# TF는 아무 오류도 내지 않았습니다. `camera_link` 기준의 점을 `base_link` 기준으로 바꾸라는 요청을 받았고, 그대로 했습니다.
# 앞쪽의 장애물을 찾는 경로 계획기는 아무것도 찾지 못하고, 로봇은 자기 카메라가 보고 있는 바로 그 벽으로 달려갑니다.
#
# 고칠 것은 노드 안의 수식이 아니라 **헤더의 단어 하나**입니다. 찾고, 바꾸고, 다시 확인해 봅시다.

# %% name="cloud-find" slide="subslide"
# %ros2 topic echo /camera/points --field header.frame_id --once

# %% name="cloud-mend"
# %ros2 param set /depth_camera frame_id camera_optical_frame
# %ros2 topic echo /camera/points --field header.frame_id --once

# %% [markdown] lang="en" name="cloud-others" slide="fragment"
# Run the RViz cell above once more: the wall is where it should be.

# %% [markdown] lang="ko" name="cloud-others" slide="fragment"
# 위의 RViz 셀을 다시 실행해 보세요. 벽이 제자리에 서 있습니다.

# %% [markdown] lang="en" name="cloud-notes" slide="notes"
# Ask which of the three programs should have noticed: camera, TF, or planner. (None of them could.)

# %% [markdown] lang="ko" name="cloud-notes" slide="notes"
# 카메라, TF, 경로 계획기 중 누가 알아챘어야 하는지 묻습니다. (아무도 알 수 없었습니다.)

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ### Checkpoint of Part 3
#
# A new camera arrives. In RViz its whole cloud is above the robot, flat like a ceiling.
# `tf2_echo camera_link camera_optical_frame` prints −90, 0, −90 degrees. What do you change?
#
# <details><summary>A. In my node, I swap the coordinates: (z, −x, −y)</summary>
#
# It looks right in your node, and wrong in RViz and in every other node.
# And when somebody fixes the driver, your node breaks. Do not change the numbers.
#
# </details>
# <details><summary>B. In the URDF, I rotate camera_link by −90°, 0, −90°</summary>
#
# Now the cloud is right. But in the model the camera looks to the robot's right, and `camera_optical_frame`, its child, is rotated **twice**.
# The next program that uses the optical frame properly is wrong.
#
# </details>
# <details><summary>C. In the driver, I set frame_id to camera_optical_frame</summary>
#
# Yes. The numbers are in the optical frame, and now the header names it. The mount is right, as tf2_echo has just shown.
#
# </details>
# <details><summary>D. I look for the broken quaternion</summary>
#
# A quaternion of zeros would be rejected, and nothing at all would be drawn.
# One with w first would show in tf2_echo, which has just shown a good one.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ### 3부 마무리 점검
#
# 새 카메라가 도착했습니다. RViz에서 클라우드 전체가 천장처럼 납작하게 로봇 위 허공에 떠 있습니다.
# `tf2_echo camera_link camera_optical_frame`은 −90, 0, −90도를 출력합니다. 무엇을 바꾸겠습니까?
#
# <details><summary>A. 내 노드에서 좌표를 (z, −x, −y)로 바꿉니다</summary>
#
# 내 노드에서는 맞아 보이지만 RViz와 다른 노드에서는 여전히 틀립니다.
# 게다가 누군가 드라이버를 고치는 날, 내 노드가 망가집니다. 숫자는 건드리지 마십시오.
#
# </details>
# <details><summary>B. URDF에서 camera_link를 −90°, 0, −90°만큼 돌립니다</summary>
#
# 클라우드는 제자리에 놓입니다. 하지만 모델 속 카메라는 로봇의 오른쪽을 보게 되고, 그 아래 달린 `camera_optical_frame`은 **두 번** 회전합니다.
# 그러면 나중에 광학 좌표계를 제대로 쓰는 프로그램의 결과가 틀리게 됩니다.
#
# </details>
# <details><summary>C. 드라이버에서 frame_id를 camera_optical_frame으로 바꿉니다</summary>
#
# 맞습니다. 숫자는 광학 좌표계 기준이고, 이제 헤더도 그렇습니다. 방금 tf2_echo로 보았듯이 장착 변환은 옳습니다.
#
# </details>
# <details><summary>D. 망가진 쿼터니언을 찾습니다</summary>
#
# 모두 0인 쿼터니언이라면 변환이 거절되어 아무것도 그려지지 않습니다.
# w를 먼저 썼다면 tf2_echo에 드러나는데, 방금 tf2_echo는 올바른 값을 보여 주었습니다.
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Vote by hands for A to D before opening any. B is the interesting one: it works today.

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 열어 보기 전에 A부터 D까지 손을 들게 합니다. B가 흥미롭습니다. 지금은 제대로 보이기 때문입니다.

# %% [markdown] lang="en" name="robot" slide="slide"
# ## The same on a real robot
#
# All commands above are what you type in a terminal, without the `%`. The next one checks the rotation.
# (`--for 1` belongs to this page. In a terminal you press Ctrl-C.)

# %% [markdown] lang="ko" name="robot" slide="slide"
# ## 실제 로봇에서
#
# 위의 명령은 모두 `%`만 빼면 터미널에 입력하는 그대로입니다. 다음 명령으로 회전을 직접 확인하십시오.
# (`--for 1`은 이 페이지에만 있는 것으로, 1초 뒤에 도구를 멈춥니다. 터미널에서는 Ctrl-C로 멈춥니다.)

# %% name="robot-echo"
# %ros2 --for 1 run tf2_ros tf2_echo camera_link camera_optical_frame

# %% [markdown] lang="en" name="robot-urdf" slide="subslide"
# `tf2_echo` prints "Waiting" first, because it looks up the transform before it has received any. That is normal.
#
# On a robot, mounts belong in the URDF. `robot_state_publisher`, a node of ROS 2, reads it and publishes them. Every camera's description needs these lines:
#
# ```xml
# <link name="camera_link"/>
# <joint name="base_to_camera" type="fixed">
#   <parent link="base_link"/>
#   <child link="camera_link"/>
#   <origin xyz="0.10 0.0 0.30" rpy="0.0 0.0 0.0"/>
# </joint>
# <link name="camera_optical_frame"/>
# <joint name="camera_to_optical" type="fixed">
#   <parent link="camera_link"/>
#   <child link="camera_optical_frame"/>
#   <origin xyz="0.0 0.0 0.0" rpy="-1.5707963267948966 0.0 -1.5707963267948966"/>
# </joint>
# ```
#
# Write π/2 with 16 decimals (in xacro, a URDF that can compute: `${pi/2}`). TurtleBot3's URDF uses `-1.57`; in the exercise you calculate what that costs at 10 m.

# %% [markdown] lang="ko" name="robot-urdf" slide="subslide"
# `tf2_echo`의 첫 줄에 "Waiting"이 나오는 것은 변환을 하나도 받지 못한 상태에서 조회부터 하기 때문입니다. 정상입니다.
#
# 로봇에서는 장착 변환을 URDF에 적습니다. 그러면 ROS 2에 들어 있는 노드 `robot_state_publisher`가 읽어서 발행합니다. 카메라라면 반드시 있어야 할 줄은 다음과 같습니다.
#
# ```xml
# <link name="camera_link"/>
# <joint name="base_to_camera" type="fixed">
#   <parent link="base_link"/>
#   <child link="camera_link"/>
#   <origin xyz="0.10 0.0 0.30" rpy="0.0 0.0 0.0"/>
# </joint>
# <link name="camera_optical_frame"/>
# <joint name="camera_to_optical" type="fixed">
#   <parent link="camera_link"/>
#   <child link="camera_optical_frame"/>
#   <origin xyz="0.0 0.0 0.0" rpy="-1.5707963267948966 0.0 -1.5707963267948966"/>
# </joint>
# ```
#
# π/2는 모든 자릿수를 적으십시오(계산식을 쓸 수 있는 URDF인 xacro에서는 `${pi/2}`). TurtleBot3의 URDF에는 `-1.57`이라고 적혀 있습니다. 10 m 앞에서 얼마나 어긋나는지는 연습 문제에서 계산합니다.

# %% [markdown] lang="en" name="recap" slide="slide"
# ## Recap
#
# - Body frame: x forward, y left, z up. Optical frame: x right, y down, z forward.
# - Positive yaw turns left, positive pitch puts the nose down, positive roll lifts the left side.
# - A quaternion (x, y, z, w) uses half the angle. (0, 0, 0, 1) means no rotation, (0, 0, 0, 0) is not a rotation.
# - Body to optical: rpy (−π/2, 0, −π/2). The header of the data names the optical frame.
# - A pixel is a ray in the optical frame: x/z = (u − cx)/fx, y/z = (v − cy)/fy.
# - If data is rotated by 90°, change the frame name or the mount, never the data.
#
# The card below sums this up. Save it (Shift and a right click) and print it.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - 본체 좌표계: x 앞, y 왼쪽, z 위. 광학 좌표계: x 오른쪽, y 아래, z 앞.
# - yaw가 양수이면 왼쪽으로 회전하고, pitch가 양수이면 기수가 내려가고, roll이 양수이면 왼쪽이 올라갑니다.
# - 쿼터니언 (x, y, z, w)에는 각도의 절반이 들어갑니다. (0, 0, 0, 1)은 회전 없음, (0, 0, 0, 0)은 회전이 아닙니다.
# - 본체에서 광학 좌표계까지는 rpy (−π/2, 0, −π/2). 데이터의 헤더에는 광학 좌표계를 적습니다.
# - 픽셀은 광학 좌표계의 광선입니다. x/z = (u − cx)/fx, y/z = (v − cy)/fy.
# - 데이터가 90° 회전해 있다면 헤더의 좌표계 이름이나 장착 변환을 고치고, 숫자는 절대 고치지 않습니다.
#
# 아래 카드에 모두 적혀 있습니다. 저장하여(그림 위에서 Shift를 누른 채 오른쪽 클릭) 인쇄해 보세요. *카드 읽기:* right hand = 오른손, x to y with the fingers = 손가락은 x에서 y 쪽으로, thumb = 엄지, positive rotations = 양의 회전, forward/left/up = 앞/왼쪽/위, right/down = 오른쪽/아래, nose down = 기수가 내려감, left side up = 왼쪽이 올라감, no rotation = 회전 없음, not a rotation = 회전이 아님.

# %% name="recap-card" tags=["collapsed"] slide="subslide"
# Draw the card.
lesson.draw_card()

# %% [markdown] lang="en" name="exit" slide="slide"
# ## Exit ticket
#
# One sentence each, on paper:
#
# 1. Why is the mug at (0, 0, 2) in the optical frame? Use your hand, not a formula.
# 2. Somebody says: "TF gave no error, so the frames are right." What do you answer?
# 3. What is still unclear?

# %% [markdown] lang="ko" name="exit" slide="slide"
# ## 마무리하며
#
# 종이에 한 문장씩 적어 보세요.
#
# 1. 머그컵은 광학 좌표계에서 왜 (0, 0, 2)에 있을까요? 공식 말고 손으로 설명해 보세요.
# 2. 누가 “TF가 오류를 내지 않았으니 좌표계는 맞다”고 합니다. 어떻게 답하겠습니까?
# 3. 아직 잘 모르겠는 것은 무엇입니까?

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now name the axes of a body and of a camera, write a rotation as a quaternion, and find the wrong frame in a header.
#
# **Next:** the exercises, [E2 Axes and quaternions](../../exercises/en/E02_axes_and_quaternions.ipynb), and then [03 Target and source](03_target_and_source.ipynb).
# Task E2.1 ticks the first line of the checklist that `tflab progress` shows. For task E2.4, read "More on quaternions" below.
#
# The sections below are for the curious, for reference and for practice.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 본체와 카메라의 축을 말하고, 회전을 쿼터니언으로 쓰고, 좌표계가 잘못 적힌 헤더를 찾아낼 수 있습니다.
#
# **다음:** 연습 문제 [E2 좌표축과 쿼터니언](../../exercises/ko/E02_axes_and_quaternions.ipynb)을 풀고 [03 목표 좌표계와 원본 좌표계](03_target_and_source.ipynb)로 갑니다.
# E2.1 과제를 통과하면 실습 체크리스트(00장의 *나의 학습 현황*에 있습니다)의 첫 줄이 채워집니다. E2.4 과제에는 쿼터니언의 길이와 NaN도 나오는데, 아래 “쿼터니언 더 보기” 절에서 다룹니다.
#
# 아래 절들은 더 알고 싶을 때, 찾아볼 때, 더 연습할 때를 위한 것입니다.

# %% [markdown] lang="en" name="gimbal-heading" slide="slide"
# ## Why not three angles? Gimbal lock

# %% [markdown] lang="ko" name="gimbal-heading" slide="slide"
# ## 각도 세 개로는 왜 부족할까요? 짐벌 락

# %% [markdown] lang="en" name="gimbal"
# Point the nose straight down: pitch 90°. Now compare two sets of angles with quite different rolls and yaws.
# **Predict:** how far apart are the two robots?

# %% [markdown] lang="ko" name="gimbal"
# 기수를 똑바로 아래로 내립니다. pitch가 90°입니다. 이제 roll과 yaw가 전혀 다른 두 조합을 비교합니다.
# **예측해 봅시다.** 두 로봇이 향한 방향은 얼마나 다를까요?

# %% name="gimbal-run" tags=["predicted"] slide="fragment"
one = Transform.from_rpy(roll=0.0, pitch=math.pi / 2, yaw=0.5).rotation
other = Transform.from_rpy(roll=1.2, pitch=math.pi / 2, yaw=1.7).rotation
print("one   (x, y, z, w):", lesson.fmt_all(one, ""))
print("other (x, y, z, w):", lesson.fmt_all(other, ""))

# %% [markdown] lang="en" name="gimbal-after" tags=["predicted"] slide="fragment"
# Not at all: they are the same orientation. With the nose down, roll and yaw rotate about the same line, so one of the three angles is redundant.
# That is [[gimbal lock]]. Near it, a tiny real motion makes the angles jump, and a filter or a controller that computes with angles can become unstable.
# With a quaternion there is no such orientation: it has four numbers, one more than necessary, and a small motion is always a small change.
#
# Three angles have another trap. `yaw @ pitch @ roll` can also be read from left to right with axes that rotate with the robot: yaw first, then pitch about the *new* y, then roll about the *new* x.
# Both readings are in use. If somebody gives you three angles, ask for the order, and whether the axes are fixed or rotate with the robot.

# %% [markdown] lang="ko" name="gimbal-after" tags=["predicted"] slide="fragment"
# 전혀 다르지 않습니다. 똑같은 방향입니다. 기수가 아래를 향하면 roll과 yaw의 회전축이 같은 직선이 되어, 세 각도 가운데 하나가 쓸모없어집니다.
# 이것을 [[gimbal lock|짐벌 락(gimbal lock)]]이라고 합니다. 이 근처에서는 로봇이 아주 조금만 움직여도 각도가 크게 튑니다. 각도로 계산하는 필터나 제어기는 여기서 불안정해집니다.
# 쿼터니언에는 그런 방향이 없습니다. 숫자를 하나 더 쓰는 대신, 어디에서나 작은 회전은 작은 변화로 나타납니다.
#
# 세 각도에는 조심할 점이 하나 더 있습니다. `yaw @ pitch @ roll`은 왼쪽부터 읽을 수도 있습니다. 이때는 축도 함께 회전합니다. 먼저 yaw, 다음에 *새로운* y축 둘레로 pitch, 다음에 *새로운* x축 둘레로 roll입니다.
# 두 방식 모두 쓰입니다. 누가 각도 세 개를 건네면 순서는 무엇인지, 축은 고정인지 함께 회전하는지 꼭 확인하십시오.

# %% [markdown] lang="en" name="gimbal-notes" slide="notes"
# Say what it means on a real machine: a gripper whose x axis (forward) points straight down has a pitch of 90° all day long.

# %% [markdown] lang="ko" name="gimbal-notes" slide="notes"
# 실제 기계에서 어떤 뜻인지 말해 줍니다. x축(앞)이 똑바로 아래를 향하는 그리퍼는 하루 종일 pitch가 90°입니다.

# %% [markdown] lang="en" name="length-heading" slide="subslide"
# ## More on quaternions: −q, the length, NaN, half the angle

# %% [markdown] lang="ko" name="length-heading" slide="subslide"
# ## 쿼터니언 더 보기: −q, 길이, NaN, 각도의 절반

# %% [markdown] lang="en" name="length"
# **q and −q.** The formula that rotates a point uses the quaternion twice, once on each side of the point: q · p · q⁻¹. Each side does half of the rotation, hence half the angle. And two minus signs cancel, so −q rotates as q does.
#
# **The length.** The quaternion of a rotation has length one: x² + y² + z² + w² = 1. Such a quaternion is called a [[unit quaternion]].
# If the length is off, TF normalises it without a message. Other programs use it as it is, and draw the robot stretched.
# Rounded numbers are normal, so a check allows a small difference from one.
#
# **NaN**, "not a number", is the result of 0/0 in C++ and NumPy. **Predict:** is NaN close to 1, or far from it?

# %% [markdown] lang="ko" name="length"
# **q와 −q.** 점을 회전시키는 식에서 쿼터니언은 점의 양쪽에 한 번씩, 모두 두 번 쓰입니다(q · p · q⁻¹). 양쪽이 회전을 절반씩 맡으므로 각도의 절반이 들어갑니다. 음의 부호 두 개는 서로 지워지므로 −q는 q와 같은 회전입니다.
#
# **길이.** 회전을 나타내는 쿼터니언은 길이가 1입니다. x² + y² + z² + w² = 1인 쿼터니언을 [[unit quaternion]]이라고 합니다.
# 길이가 1에서 벗어나면 TF는 오류 없이 1로 맞춥니다. 길이를 확인하지 않는 프로그램에서는 로봇이 늘어나거나 찌그러져 보입니다.
# 반올림한 숫자는 정상입니다. 그러므로 길이를 확인할 때는 1과의 작은 차이를 허용합니다.
#
# <b>NaN(숫자가 아님)</b>은 C++나 NumPy에서 0/0을 계산하면 나옵니다. **예측해 봅시다.** NaN은 1에 가까울까요, 1에서 멀까요?

# %% name="length-run" tags=["predicted"] slide="fragment"
for q in (left_90, (0.0, 0.0, 0.707, 0.707), (0.0, 0.0, 1.4, 1.4), (0.0, 0.0, math.nan, 1.0)):
    length = math.hypot(*q)
    off = abs(length - 1)
    print(f"length {length:.4f}:  close to 1? {off < 0.01}   far from 1? {off > 0.01}")

# %% [markdown] lang="en" name="length-after" tags=["predicted"] slide="fragment"
# Neither. NaN is neither greater nor less than any number, so both comparisons are False. It passes every check that asks "is it bad?".
# Check `math.isfinite` first.

# %% [markdown] lang="ko" name="length-after" tags=["predicted"] slide="fragment"
# 둘 다 아닙니다. NaN은 어떤 값과 크기를 비교해도 False이므로, ‘나쁜 값인가?’를 묻는 검사를 그대로 통과합니다.
# `math.isfinite`로 먼저 확인하십시오.

# %% [markdown] lang="en" name="try-it-heading" slide="subslide"
# ## Try it: the same numbers in both frames

# %% [markdown] lang="ko" name="try-it-heading" slide="subslide"
# ## 직접 해 보세요: 두 좌표계에서 숫자가 같은 점

# %% [markdown] lang="en" name="try-it"
# Change the numbers and run the cell again. Can you find
#
# - a point that has the **same** coordinates in both frames?
# - a point whose coordinates in `camera_link` are (1, 1, 1)?
#
# <details><summary>Solution</summary>
#
# You look for (x, y, z) = (z, −x, −y): y = −x and z = x and z = −y, so every (a, −a, a) is a solution. All of them are on one line, the axis of the rotation.
# For (1, 1, 1) in the body: right is −1, down is −1, forward is 1.
#
# </details>

# %% [markdown] lang="ko" name="try-it"
# 숫자를 바꾸어 다시 실행해 보세요. 다음을 찾을 수 있을까요?
#
# - 두 좌표계에서 세 숫자가 **똑같은** 점
# - `camera_link`에서 (1, 1, 1)이 되는 점
#
# <details><summary>풀이</summary>
#
# (x, y, z) = (z, −x, −y)를 풀면 y = −x, z = x, z = −y이므로 (a, −a, a) 꼴이면 됩니다. 이 점들은 모두 한 직선 위에 있습니다. 바로 이 회전의 회전축입니다.
# 본체에서 (1, 1, 1)이 되려면 오른쪽은 −1, 아래는 −1, 앞은 1입니다.
#
# </details>

# %% name="try-it-run"
right, down, forward = 0.3, -0.1, 2.0  # change me
print("camera_link:", lesson.fmt_all(camera_T_optical.apply((right, down, forward))))

# %% [markdown] lang="en" name="asker-before-heading" slide="subslide"
# ## Let TF do the arithmetic, and break it with zeros

# %% [markdown] lang="ko" name="asker-before-heading" slide="subslide"
# ## TF에 계산을 맡기고, 0으로 고장 내기

# %% [markdown] lang="en" name="asker-before"
# The next program looks up transforms. Its [[listener]] receives every transform and stores it in a [[buffer]]. With `spin_thread=True` it does so in a thread of its own while you type.
# `buffer.transform(message, "base_link")` then transforms a message from the frame in its header into the one that you want.
# Chapter 08 explains how. Time on this page advances only while `graph.run` lets it. (`graph` was created by `%load_ext tflab`. A robot does not need it, because there time passes by itself.)

# %% [markdown] lang="ko" name="asker-before"
# 변환을 조회하는 프로그램을 만듭니다. [[listener|변환 수신기(listener)]]가 받은 변환은 모두 [[buffer|변환 버퍼(buffer)]]에 쌓입니다. `spin_thread=True`를 주면 수신기가 별도의 스레드에서 계속 수신합니다. 그러면 `buffer.transform(message, "base_link")`가 메시지를 헤더에 적힌 좌표계 기준에서 `base_link` 기준으로 바꿉니다.
# 버퍼의 속은 08장에서 열어 봅니다. 이 페이지의 시간은 멈춰 있으며, `graph.run`을 호출하는 동안에만 흐릅니다. (`graph`는 `%load_ext tflab`이 만들어 둔 것입니다. 로봇의 시간은 저절로 흐르므로 이런 것이 필요 없습니다.)

# %% name="asker"
import tf2_geometry_msgs  # lets buffer.transform() accept a PointStamped
from tf2_ros import Buffer, TransformListener

rclpy.try_shutdown()  # so that this cell can be run again
rclpy.init()
asker = Node("asker")
buffer = Buffer()
listener = TransformListener(buffer, asker, spin_thread=True)
graph.run(seconds=0.5)

# %% name="asked" slide="fragment"
from geometry_msgs.msg import PointStamped

seen = PointStamped()
seen.header.frame_id = "camera_optical_frame"
seen.point.x, seen.point.y, seen.point.z = optical_p_mug
p = buffer.transform(seen, "base_link").point
print("in base_link:", lesson.fmt_all((p.x, p.y, p.z)))

# %% [markdown] lang="en" name="cloud-planner" slide="subslide"
# This is the worked example, calculated by TF.
#
# ### The planner that sees no wall
#
# And this is the planner that reads the cloud and looks for obstacles at the robot's height.

# %% [markdown] lang="ko" name="cloud-planner" slide="subslide"
# 위의 예제를 TF가 계산했습니다.
#
# ### 벽을 보지 못하는 경로 계획기
#
# 다음은 클라우드를 읽고 로봇 높이의 장애물을 찾는 경로 계획기입니다.

# %% name="cloud-obstacles"
import tf2_sensor_msgs  # lets buffer.transform() accept a PointCloud2


def obstacles_ahead(frame_id):
    cloud = create_cloud_xyz32(Header(frame_id=frame_id), np.vstack([wall, floor]))
    x, y, z = read_points_numpy(buffer.transform(cloud, "base_link")).T
    in_the_way = (x > 0.3) & (abs(y) < 0.3) & (z > 0.0) & (z < 0.5)
    return np.count_nonzero(in_the_way)


print("stamped camera_optical_frame:", obstacles_ahead("camera_optical_frame"), "points in the way")
print("stamped camera_link:         ", obstacles_ahead("camera_link"), "points in the way")

# %% [markdown] lang="en" name="cloud-obstacles-after" slide="fragment"
# With the wrong word in the header there is no obstacle at all, and nobody reports an error: not the camera, not TF, not the planner.
#
# Experienced teams make this mistake, too. Clouds that point at the sky or are rotated by 90° fill the issue lists of a mapping package ([introlab/rtabmap_ros 383](https://github.com/introlab/rtabmap_ros/issues/383)), of the simulator of an underground robot race ([osrf/subt 369](https://github.com/osrf/subt/issues/369)) and of a simulator that very many ROS robots use ([gazebo_ros_pkgs 1329](https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1329)).

# %% [markdown] lang="ko" name="cloud-obstacles-after" slide="fragment"
# 헤더의 단어가 틀리면 장애물이 하나도 없습니다. 카메라도, TF도, 경로 계획기도 오류를 내지 않습니다.
#
# 초보자만 겪는 일이 아닙니다. 하늘을 바라보거나 90° 누운 클라우드는 지도 작성 패키지([introlab/rtabmap_ros 383](https://github.com/introlab/rtabmap_ros/issues/383)), 지하 탐사 로봇 대회의 시뮬레이터([osrf/subt 369](https://github.com/osrf/subt/issues/369)), 수많은 ROS 로봇이 거쳐 간 시뮬레이터([gazebo_ros_pkgs 1329](https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1329))의 이슈 목록에도 올라와 있습니다.

# %% [markdown] lang="en" name="asker-after" slide="subslide"
# ### Break it on purpose: a quaternion of zeros
#
# A colleague adds a second camera, whose quaternion comes from a configuration file. The file contains `0, 0, 0, 0`: "no rotation, of course".
#
# **Predict:** who reports an error? The broadcaster, the listener, or the program that looks up the transform? And with which message?

# %% [markdown] lang="ko" name="asker-after" slide="subslide"
# ### 일부러 고장 내기: 모두 0인 쿼터니언
#
# 이번에는 동료가 두 번째 카메라를 추가합니다. 쿼터니언은 설정 파일에서 읽어 옵니다. 파일에는 `0, 0, 0, 0`이라고 적혀 있습니다. 동료는 회전이 없다는 뜻으로 여겼습니다.
#
# **예측해 봅시다.** 어디에서 오류가 날까요? 변환을 발행할 때일까요, 수신할 때일까요, 조회할 때일까요? 오류 메시지에는 무엇이라고 나올까요?

# %% name="zero-sent" tags=["predicted"] slide="fragment"
from geometry_msgs.msg import TransformStamped
from tf2_ros import StaticTransformBroadcaster

t = TransformStamped()
t.header.frame_id, t.child_frame_id = "base_link", "rear_camera_link"
r = t.transform.rotation
print("a new message already has", lesson.fmt_all((r.x, r.y, r.z, r.w), ""))
r.x, r.y, r.z, r.w = 0.0, 0.0, 0.0, 0.0  # from the configuration file

driver = Node("rear_camera_driver")
broadcaster = StaticTransformBroadcaster(driver)
broadcaster.sendTransform(t)
print("sent")

# %% [markdown] lang="en" name="zero-sent-after" slide="subslide"
# The broadcaster reports no error. Let half a second pass, so that the listener receives the transform, and look it up:
#
# (`%xmode Minimal` shows only the last line of an error, the one to read. `%xmode Context` shows the rest again.)

# %% [markdown] lang="ko" name="zero-sent-after" slide="subslide"
# 발행하는 쪽에서는 아무 일도 일어나지 않았습니다. 수신기가 받을 수 있도록 0.5초가 흐르게 한 다음 조회합니다.
#
# (`%xmode Minimal`은 오류에서 꼭 읽어야 할 마지막 줄만 보여 줍니다. `%xmode Context`로 되돌립니다.)

# %% name="zero-asked" tags=["predicted", "raises-exception"] slide="fragment"
from rclpy.time import Time

# %xmode Minimal
graph.run(seconds=0.5)
buffer.lookup_transform("base_link", "rear_camera_link", Time())

# %% [markdown] lang="en" name="zero-notes" slide="notes"
# Before you run the cell that raises, ask which exception they expect. "InvalidArgument" is a reasonable answer, and it is what the engine raises for bad *lookups*. A bad *transform* is never stored.

# %% [markdown] lang="ko" name="zero-notes" slide="notes"
# 예외가 나오는 셀을 실행하기 전에 어떤 예외가 날지 물어봅니다. "InvalidArgument"도 그럴듯한 답입니다. 그것은 잘못된 *조회*에 나는 예외이고, 잘못된 *변환*은 아예 버퍼에 들어가지 못합니다.

# %% [markdown] lang="en" name="zero-after" slide="subslide"
# Look at what happened, and where.
#
# 1. The **sender** reported nothing.
# 2. **Each listener** rejected the transform, and printed a message about `nan` in its own log. To convert the quaternion to a matrix, it divides by the squared length, and 0/0 is "not a number".
# 3. **You** read that the frame *does not exist*. You look for a typo. You read the launch file, which starts the programs. You restart the driver, which publishes as before.
#
# The cause is in the sender. The error appears in the program that looks up.
# So: when a frame "does not exist" and its publisher runs, search the **listener's** log for `TF_NAN_INPUT` or `TF_DENORMALIZED_QUATERNION`.
#
# A new message in ROS 2 has w = 1 already. The zeros come from other sources: files, arrays made by `zeros(4)`, programs in C, ROS 1.

# %% [markdown] lang="ko" name="zero-after" slide="subslide"
# 무슨 일이 어디에서 일어났는지 보십시오.
#
# 1. **발행한 쪽**에는 아무 오류도 없었습니다.
# 2. **수신기마다** 거절했다는 기록을 로그에 남겼고, 그 기록에는 `nan`이 나옵니다. 행렬을 만들려면 길이의 제곱으로 나누어야 하는데, 0/0은 “숫자가 아님(not a number)”입니다.
# 3. **여러분**은 좌표계가 *존재하지 않는다*는 메시지를 읽었습니다. 그래서 오타를 찾고, 프로그램을 띄우는 launch 파일을 뒤지고, 멀쩡히 발행 중인 드라이버를 다시 시작합니다.
#
# 원인은 발행한 프로그램에 있는데, 오류는 조회한 프로그램에서 나옵니다.
# 따라서 발행자가 실행 중인데도 좌표계가 "does not exist"라고 나오면, **수신기**의 로그에서 `TF_NAN_INPUT`이나 `TF_DENORMALIZED_QUATERNION`을 찾으십시오.
#
# ROS 2의 새 메시지에는 이미 w = 1이 들어 있습니다. 0은 다른 곳에서 옵니다. 설정 파일, `zeros(4)`로 만든 배열, C 프로그램, ROS 1 같은 곳입니다.

# %% [markdown] lang="en" name="earth-heading" slide="skip"
# ## The axes of the earth, and a compass

# %% [markdown] lang="ko" name="earth-heading" slide="skip"
# ## 지구의 축과 나침반

# %% [markdown] lang="en" name="earth" slide="skip"
# REP-103 also fixes the axes of frames on the earth, such as `map` with GPS: **x east, y north, z up** (ENU). Data in north, east, down uses a frame of its own, with the suffix `_ned`.
#
# So yaw 0 is **east**, not north, and yaw grows counterclockwise. A compass heading is 0 at north and grows **clockwise**: yaw = 90° − heading.
#
# | you face | heading | yaw |
# |---|---|---|
# | north | 0° | 90° |
# | east | 90° | 0° |
# | south | 180° | −90° |
# | west | 270° | 180° |

# %% [markdown] lang="ko" name="earth" slide="skip"
# REP-103은 GPS를 쓰는 `map`처럼 지구에 고정된 좌표계의 축도 정합니다. **x는 동쪽, y는 북쪽, z는 위**입니다(ENU). 북쪽, 동쪽, 아래를 축으로 쓰는 데이터에는 이름이 `_ned`로 끝나는 좌표계를 따로 둡니다.
#
# 따라서 yaw 0은 북쪽이 아니라 **동쪽**이고, yaw는 반시계 방향으로 커집니다. 나침반의 방위각은 북쪽이 0이고 **시계 방향**으로 커집니다. yaw = 90° − 방위각입니다.
#
# | 바라보는 쪽 | 방위각 | yaw |
# |---|---|---|
# | 북 | 0° | 90° |
# | 동 | 90° | 0° |
# | 남 | 180° | −90° |
# | 서 | 270° | 180° |

# %% [markdown] lang="en" name="robot-table-heading" slide="subslide"
# ## Look it up: data that is rotated by 90° or 180°

# %% [markdown] lang="ko" name="robot-table-heading" slide="subslide"
# ## 찾아보기: 데이터가 90°나 180° 회전해 있다면

# %% [markdown] lang="en" name="robot-table"
# | what you see | likely cause | first look |
# |---|---|---|
# | a depth cloud above the robot like a ceiling | optical data stamped with the body frame | `ros2 topic echo /camera/points --field header.frame_id --once` |
# | what is ahead appears at the robot's right | the optical rotation applied twice: for example in the mount of camera_link as well | `ros2 run tf2_ros tf2_echo base_link camera_link`, URDF `rpy` |
# | the robot on its back | quaternion written w first | print the quaternion where your program reads it |
# | "frame does not exist", but its publisher runs | all zeros, or NaN | the **listener's** log |
# | a sensor rotated by an unexpected angle | degrees written where radians belong | URDF `rpy`: is any number larger than 3.2? |
# | IMU: gravity appears on the wrong axis | `imu_link` not rotated as the chip is | at rest, level, `ros2 topic echo /imu --field linear_acceleration`: z must read about **+9.8** |
#
# An IMU measures angular velocity and acceleration. At rest it measures how the table pushes it *up*: with z up, it reads plus 9.8. Minus 9.8 means that it is upside down; 9.8 on x or y, that it is on its side.
# Then correct the mount (the `rpy` of `imu_link`), not the numbers.
#
# Old tutorials pass six bare numbers to `static_transform_publisher`. Their order is x y z **yaw pitch roll**: the angles are in the reverse order. The named options of this page cannot be mixed up; `--help` lists them.

# %% [markdown] lang="ko" name="robot-table"
# | 증상 | 가능성이 큰 원인 | 첫 확인 |
# |---|---|---|
# | 깊이 클라우드가 천장처럼 로봇 위에 뜬다 | 광학 좌표계의 데이터에 본체 좌표계를 적음 | `ros2 topic echo /camera/points --field header.frame_id --once` |
# | 앞에 있는 것이 로봇 오른쪽에 나타난다 | 광학 회전을 두 번 적용했거나 본체에도 적용함 | `ros2 run tf2_ros tf2_echo base_link camera_link`, URDF의 `rpy` |
# | 로봇이 뒤집혀 누워 있다 | 쿼터니언의 w를 맨 앞에 씀 | 값이 들어오는 곳에서 출력해 보기 |
# | 발행자가 실행 중인데 "frame does not exist" | 모두 0이거나 NaN | **수신기**의 로그 |
# | 센서가 아무도 정한 적 없는 각도로 회전해 있다 | 라디안 자리에 도(degree)를 씀 | URDF의 `rpy`에 3.2보다 큰 수가 있는지 |
# | IMU의 중력이 엉뚱한 축에 나타난다 | `imu_link`가 실제 칩 방향대로 회전해 있지 않음 | 수평으로 정지한 채 `ros2 topic echo /imu --field linear_acceleration`: z가 약 **+9.8**이어야 함 |
#
# IMU는 각속도와 가속도를 재는 칩입니다. 정지한 IMU는 책상이 자신을 *위로* 미는 힘을 잽니다. z가 위라면 +9.8이 나옵니다. −9.8이면 뒤집힌 것이고, x나 y에 9.8이 나오면 옆으로 누운 것입니다.
# 이때 고칠 것은 숫자가 아니라 장착 변환(`imu_link`의 `rpy`)입니다.
#
# 오래된 예제는 `static_transform_publisher`에 숫자 여섯 개만 나열합니다. 그 순서는 x y z **yaw pitch roll**로, 각도가 거꾸로입니다. 이 페이지처럼 이름이 있는 옵션을 쓰면 뒤섞일 일이 없습니다. 옵션 목록은 `--help`로 볼 수 있습니다.

# %% [markdown] lang="en" name="robot-table-notes" slide="notes"
# Read only the left column aloud, and let the class name the cause. If somebody has met one, ask how long it took to find.

# %% [markdown] lang="ko" name="robot-table-notes" slide="notes"
# 왼쪽 열만 읽어 주고 원인은 청중이 말하게 합니다. 겪어 본 사람이 있으면 얼마나 걸렸는지 들려 달라고 합니다.

# %% [markdown] lang="en" name="words-heading" slide="subslide"
# ## Terms, and three questions from before

# %% [markdown] lang="ko" name="words-heading" slide="subslide"
# ## 이 장의 용어, 그리고 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="words"
# **Terms of this chapter:** [[rep-103]] · [[roll pitch yaw]] · [[quaternion]] · [[gimbal lock]] · [[optical frame]] · [[static transform]]
#
# <details><summary>1. What does a coordinate need, besides its value?</summary>
#
# A frame, and a time: which axes it is expressed in, and when it was measured.
#
# </details>
# <details><summary>2. The robot drives on while a post stands still. Which coordinates of the post change: those in map, or those in laser_frame?</summary>
#
# Those in `laser_frame`, because that frame moves with the robot. In `map` the post is at rest.
#
# </details>
# <details><summary>3. The laser is at (0.20, 0, 0.15) in base_link, not rotated. It detects a corner at (2, 0, 0). Where is the corner in base_link?</summary>
#
# (2.20, 0, 0.15): without a rotation, you add. With a rotation you do not, and that is chapter 03.
#
# </details>

# %% [markdown] lang="ko" name="words"
# **이 장의 용어:** [[rep-103]] · [[roll pitch yaw]] · [[quaternion]] · [[gimbal lock]] · [[optical frame]] · [[static transform]]
#
# <details><summary>1. 좌표에는 값 말고 무엇이 더 필요합니까?</summary>
#
# 좌표계와 시각입니다. 어느 축을 기준으로 적었는지, 언제 측정했는지입니다.
#
# </details>
# <details><summary>2. 로봇은 계속 달리고 기둥은 서 있습니다. map 기준과 laser_frame 기준 중 어느 기둥 좌표가 바뀝니까?</summary>
#
# `laser_frame` 기준입니다. 이 좌표계가 로봇과 함께 움직이기 때문입니다. `map`에서 기둥은 가만히 있습니다.
#
# </details>
# <details><summary>3. 레이저는 base_link 기준 (0.20, 0, 0.15)에 회전 없이 달려 있습니다. 레이저가 모서리를 (2, 0, 0)에서 보았습니다. base_link에서는 어디입니까?</summary>
#
# (2.20, 0, 0.15)입니다. 회전이 없으면 더하면 됩니다. 회전이 있으면 더하기로는 구할 수 없으며, 03장에서 다룹니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice questions

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제

# %% [markdown] lang="en" name="practice"
# Write two or three sentences each, then open the rubric and mark yourself: one point per idea.
#
# **Q2.** Compare the axes of a robot's body frame with those of a camera's optical frame.
#
# **Q8.** What is the difference between the quaternion of "no rotation" and one that is all zeros?
#
# (Q2 and Q8 are their numbers in the course's list of fifteen practice questions.)
#
# <details><summary>Rubric of Q2 (4 points)</summary>
#
# - Body: x forward, y left, z up.
# - Optical: z forward, x right, y down.
# - Both are right-handed, in metres. Between them is a rotation, rpy (−π/2, 0, −π/2), and no translation.
# - If a header names the wrong one, TF computes without an error, and clouds and detections are rotated.
#
# </details>
# <details><summary>Rubric of Q8 (3 points)</summary>
#
# - (0, 0, 0, 1) is the identity: length one, no rotation.
# - (0, 0, 0, 0) has length zero and is not a rotation. Normalising does not help.
# - The sender reports nothing. Each listener rejects the transform, with a message in its log, and a later lookup reports that the frame does not exist.
#
# </details>

# %% [markdown] lang="ko" name="practice"
# 두세 문장씩 적은 다음, 채점 기준을 열어 스스로 정직하게 채점해 보세요. 아래 내용이 하나 들어 있을 때마다 1점입니다.
#
# **Q2.** 로봇 본체의 좌표축과 카메라 광학 좌표계의 좌표축을 비교하십시오.
#
# **Q8.** “회전 없음” 쿼터니언과 모두 0인 쿼터니언은 어떻게 다릅니까?
#
# (Q 번호는 전체 15문제의 일련번호입니다.)
#
# <details><summary>Q2 채점 기준 (4점)</summary>
#
# - 본체: x 앞, y 왼쪽, z 위.
# - 광학: z 앞, x 오른쪽, y 아래.
# - 둘 다 오른손 좌표계이고 단위는 미터입니다. 둘 사이에는 이동 없이 회전 rpy (−π/2, 0, −π/2)만 있습니다.
# - 헤더에 다른 좌표계의 이름이 적히면 TF는 오류 없이 계산하고, 포인트 클라우드와 검출 결과는 회전한 채 나타납니다.
#
# </details>
# <details><summary>Q8 채점 기준 (3점)</summary>
#
# - (0, 0, 0, 1)은 항등 회전입니다. 길이가 1이고 아무것도 회전시키지 않습니다.
# - (0, 0, 0, 0)은 길이가 0이고 회전이 아닙니다. 수를 곱해 길이를 맞추려 해도 회전이 되지 않습니다.
# - 발행하는 쪽에는 오류가 없습니다. 수신기마다 로그를 남기고 변환을 거절하며, 나중에 조회하면 좌표계가 존재하지 않는다는 메시지가 나옵니다.
#
# </details>

# %% [markdown] lang="en" name="stop-why-heading" slide="skip"
# ## Stop the robot's programs

# %% [markdown] lang="ko" name="stop-why-heading" slide="skip"
# ## 로봇의 프로그램 멈추기

# %% [markdown] lang="en" name="stop-why" slide="skip"
# The last cell stops the robot's programs, as Ctrl-C would.

# %% [markdown] lang="ko" name="stop-why" slide="skip"
# 마지막 셀은 Ctrl-C처럼 로봇의 프로그램을 모두 멈춥니다.

# %% name="stop" slide="skip"
graph.stop()
rclpy.try_shutdown()
