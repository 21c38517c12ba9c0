# %% [markdown] lang="en" name="title" slide="slide"
# # 03 · Target and source
#
# **In which frame is the data, and in which do you want it?** · about 35 minutes · builds on 01 and 02
#
# After this chapter you can
#
# - say what a transform tells you about a child and its parent, and in which direction it transforms data,
# - turn a sentence into `lookup_transform(target, source, time)` without guessing the order,
# - chain transforms like dominoes, and see at once when a product is wrong,
# - invert a transform that contains a rotation, and read `tf2_echo` in both directions.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 03 · 목표 좌표계와 원본 좌표계
#
# **데이터는 어느 좌표계 기준이고, 어느 좌표계 기준으로 바꿀까요?** · 약 35분 · 01, 02장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 변환이 무엇을 나타내는지, 그리고 어느 기준의 데이터를 어느 기준으로 바꾸는지 말할 수 있습니다.
# - 문장 하나를 `lookup_transform(target, source, time)` 호출로, 인자 순서를 짐작하지 않고 쓸 수 있습니다.
# - 변환을 도미노처럼 이어 합성하고, 잘못된 합성은 보자마자 알아챌 수 있습니다.
# - 회전이 있는 변환의 역변환을 구하고, `tf2_echo`를 두 방향 모두 읽을 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# The whole chapter is one sentence: "data expressed in source, wanted in target".
# Ask the class now: who has ever fixed a transform by swapping two arguments until the picture looked right?
# Most hands go up. This chapter is for them.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 이 장은 한 문장입니다. “원본 기준 데이터를 목표 기준으로 보고 싶다.”
# 먼저 물어봅니다. 그림이 맞아 보일 때까지 두 인자를 바꿔 가며 고친 적이 있는 사람?
# 대부분 손을 듭니다. 그것이 이 장의 주제입니다.

# %% [markdown] lang="en" name="what-you-need" slide="subslide"
# ## What you need to begin
#
# From earlier chapters. If a fact is new, accept it for now.
#
# - A position is a value **in a [[frame]]**: `(2, 0, 0)` alone means nothing, `(2, 0, 0)` in `laser_frame` does.
# - x points forward, y left, z up. A positive yaw rotates to the left.
# - A rotation is a quaternion (x, y, z, w). "No rotation" is (0, 0, 0, 1).
# - A sensor's mount does not change, so its transform is published once, as a static transform.
# - A `Buffer` stores what was published, and a `TransformListener` fills it. `Time()` means the latest transform.
# - In this workbook `Transform.from_rpy(yaw=…, translation=…)` creates a transform, and `base_T_laser.apply(laser_p)` applies one to a point.
#
# In this chapter the robot stands still, so the time of a transform does not matter. It does in chapter 08.

# %% [markdown] lang="ko" name="what-you-need" slide="subslide"
# ## 시작하기 전에 알아 둘 것
#
# 앞 장에서 배운 것들입니다. 처음 보는 것이 있어도 일단 받아들이고 읽어 보세요.
#
# - 위치는 **어떤 [[frame|좌표계(frame)]]를 기준으로** 읽은 값입니다. `(2, 0, 0)`만으로는 아무 뜻이 없고, `laser_frame` 기준 `(2, 0, 0)`이라야 뜻이 있습니다.
# - x는 앞, y는 왼쪽, z는 위입니다. 양의 yaw는 왼쪽 회전입니다.
# - 회전은 쿼터니언 (x, y, z, w)이고, “회전 없음”은 (0, 0, 0, 1)입니다.
# - 센서의 장착 변환은 바뀌지 않으므로 정적 변환으로 한 번만 발행합니다.
# - `Buffer`는 발행된 변환을 기억하고, `TransformListener`가 버퍼를 채웁니다. `Time()`은 가장 최근 값을 달라는 뜻입니다.
# - 이 워크북에서 `Transform.from_rpy(yaw=…, translation=…)`은 변환을 만들고, `base_T_laser.apply(laser_p)`는 변환을 점에 적용합니다.
#
# 이 장에서는 로봇이 서 있으므로 시간은 신경 쓰지 않습니다. 시간은 08장에서 다시 나옵니다.

# %% name="load" slide="skip"
# %load_ext tflab
import math

from tflab.core import Transform
from tflab.workbook import lesson

# %% [markdown] lang="en" name="ten-years" slide="slide"
# ## Ten years of "reversed"
#
# A robot's IMU, which measures rotation and acceleration, was mounted rotated. Its readings came out as if a transform were reversed.
# The team published a *wrong* mount, and the readings came out right.
# Later they proposed to swap two frames in the program that uses the IMU. The maintainers answered that the target comes first, and that the program already passes it first.
#
# They were not the only ones.
# In 2015 somebody asked whether the frames in `tf_echo`, the tool that prints a transform, are reversed.
# Three more people asked the same. ROS 2 brought `tf2_echo`, and the question came again in 2021 and in 2024.
# Even the maintainer of a widely used package for pose estimation wrote about frequently confusing the two frames.
#
# The strange part: the tool's numbers were right all along.
# The authors had asked for the transform **"from A to B"**, and that phrase has two meanings.

# %% [markdown] lang="ko" name="ten-years" slide="slide"
# ## 10년 동안 “거꾸로”
#
# IMU(회전과 가속을 재는 센서)를 회전시켜 장착한 로봇이 있었는데, 어딘가에서 변환이 거꾸로인 것 같았습니다.
# 그래서 팀은 장착 방향을 *틀리게* 발행했고, 그러자 숫자가 맞았습니다.
# 나중에 팀은 IMU를 쓰는 프로그램에서 두 좌표계의 순서를 바꾸자고 제안했습니다. 관리자는 기준이 될 좌표계가 첫 인자이고, 그 프로그램은 이미 그렇게 쓰고 있다고 답했습니다.
#
# 이 팀만 헷갈린 것이 아닙니다.
# 2015년, 누군가 변환을 출력하는 도구인 `tf_echo`의 좌표계 순서가 거꾸로 아니냐고 물었습니다.
# 같은 질문이 세 번 더 올라왔습니다. ROS 2에서 `tf2_echo`로 바뀐 뒤에도 2021년에 한 번, 2024년에 또 한 번 올라왔습니다.
# 포즈를 추정하는 데 널리 쓰이는 패키지의 관리자도 자신이 자주 거꾸로 쓴다고 적었습니다.
#
# 이상한 점은 따로 있습니다. 도구가 출력한 숫자는 처음부터 맞았습니다.
# 모두 <b>“A에서 B로 가는 변환”</b>을 물었는데, 이 말은 두 가지로 읽힙니다.

# %% [markdown] lang="en" name="ten-years-sources" slide="skip"
# *Read the reports:* navigation [239](https://github.com/ros-planning/navigation/issues/239); geometry [108](https://github.com/ros/geometry/issues/108), [111](https://github.com/ros/geometry/issues/111), [192](https://github.com/ros/geometry/issues/192), [226](https://github.com/ros/geometry/issues/226); geometry2 [470](https://github.com/ros2/geometry2/issues/470); ros2_documentation [4239](https://github.com/ros2/ros2_documentation/issues/4239); robot_localization [437](https://github.com/cra-ros-pkg/robot_localization/issues/437).

# %% [markdown] lang="ko" name="ten-years-sources" slide="skip"
# *더 읽기:* navigation [239](https://github.com/ros-planning/navigation/issues/239), geometry [108](https://github.com/ros/geometry/issues/108), [111](https://github.com/ros/geometry/issues/111), [192](https://github.com/ros/geometry/issues/192), [226](https://github.com/ros/geometry/issues/226), geometry2 [470](https://github.com/ros2/geometry2/issues/470), ros2_documentation [4239](https://github.com/ros2/ros2_documentation/issues/4239), robot_localization [437](https://github.com/cra-ros-pkg/robot_localization/issues/437).

# %% name="two-readings" tags=["collapsed"] slide="subslide"
# Draw both readings of the phrase.
mount = Transform.from_rpy(yaw=math.pi / 2, translation=(0.20, 0.0, 0.15))  # rotated left, ahead, above
lesson.draw_readings('base_link', 'laser_frame', mount)

# %% [markdown] lang="en" name="two-readings-seen"
# The left picture is for an engineer who mounts sensors. Where is the laser *mounted*, measured on the robot? The numbers are (0.20, 0, 0.15).
# The right picture is for an engineer who transforms data. The data is in the robot's frame and is *wanted* in the laser's frame. The numbers are (0, 0.20, −0.15), along the laser's axes.
# Both say "from base_link to laser_frame", and each needs the inverse of the other's transform.
#
# The solution is a sentence with neither "from" nor "to". First, make the mistake yourself.

# %% [markdown] lang="ko" name="two-readings-seen"
# *그림 읽기:* reading 1 = 읽기 1(base_link를 기준으로 laser_frame이 어디에 있는가), reading 2 = 읽기 2(base_link 기준 데이터를 laser_frame 기준으로 보고 싶다), along the axes of = 이 좌표계의 축을 따라 잰 값.
#
# 읽기 1은 센서를 다는 사람의 말입니다. 로봇을 기준으로 레이저는 어디에 *달려* 있는가? 로봇의 축을 따라 잰 값은 (0.20, 0, 0.15)입니다.
# 읽기 2는 데이터를 바꾸는 사람의 말입니다. 로봇 기준 숫자가 있는데, 레이저 기준으로 *보고 싶다*. 레이저의 축을 따라 잰 값은 (0, 0.20, −0.15)입니다.
# 둘 다 “base_link에서 laser_frame으로”라고 말하지만, 필요한 변환은 서로 반대입니다.
#
# 해결책은 “…에서 …(으)로”라고 말하지 않는 문장 하나입니다. 먼저 예측하고 실행해 봅시다.

# %% [markdown] lang="en" name="two-readings-seen-notes" slide="notes"
# Let two people act it: one is base_link, one is laser_frame, an object lies between them.
# "Go from A to B" moves a person. "Take this number from A to B" moves a note. The words are the same.
# Do not name target and source yet.

# %% [markdown] lang="ko" name="two-readings-seen-notes" slide="notes"
# 두 사람에게 시켜 봅니다. 한 명은 base_link, 한 명은 laser_frame이고, 물체 하나를 사이에 둡니다.
# “A에서 B로 가세요”라고 하면 사람이 움직이고, “이 숫자를 A에서 B로 전하세요”라고 하면 쪽지가 움직입니다. “A에서 B로”라는 말은 같습니다.
# 아직 목표와 원본이라는 말은 꺼내지 않습니다.

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# The laser is mounted 20 cm in front of `base_link` and 15 cm above it.
# It is rotated by +90°, so that it faces the shelf on the left.
# It detects the corner of the shelf straight ahead: **(2, 0, 0) in `laser_frame`**.
#
# Where is the corner in `base_link`?
# Write your prediction into the next cell before you go on. A wrong prediction teaches you more than no prediction.

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 레이저는 로봇 중심에서 앞으로 20 cm, 위로 15 cm인 곳에 달려 있습니다.
# 레이저는 왼쪽 선반을 보도록 +90° 회전해 있습니다.
# 레이저가 정면에서 선반 모서리를 측정했습니다. <b>`laser_frame` 기준 (2, 0, 0)</b>입니다.
#
# `base_link` 기준으로 모서리는 어디에 있을까요?
# 다음 셀에 예측을 적고 실행해 보세요. 틀려도 괜찮습니다. 적어 두어야 어디에서 틀렸는지 알 수 있습니다.

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Give them a full minute, with paper, and let them show hands: ahead, left, right, behind.
# Keep the count on the board. You need it after the run. Do not comment on it.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 종이를 주고 1분을 기다린 뒤 손을 들게 합니다. 앞, 왼쪽, 오른쪽, 뒤.
# 인원수를 칠판에 남겨 두었다가 실행한 뒤에 다시 봅니다. 지금은 맞고 틀림을 말하지 않습니다.

# %% name="my-guess" slide="skip"
my_guess = (0.0, 0.0, 0.0)  # your guess: (x, y, z) in base_link [m]

# %% [markdown] lang="en" name="run-it" slide="subslide"
# ## Run it
#
# The first cell publishes the mount with ROS 2's own tool. The second creates a node with a buffer, exactly as on a robot.
# With `spin_thread=True` the listener has a thread of its own, so you need not call `spin`.
# Time is simulated. It advances, and messages arrive, only while `graph.run(…)` is running. `%load_ext tflab` created `graph`.

# %% [markdown] lang="ko" name="run-it" slide="subslide"
# ## 실행해 봅시다
#
# 먼저 ROS 2 도구로 레이저의 장착 변환을 발행하고, 이어서 버퍼가 있는 노드를 만듭니다. 로봇에서도 똑같이 씁니다.
# `spin_thread=True`를 주면 수신기가 별도의 스레드에서 수신하므로 `spin`을 호출하지 않아도 됩니다.
# 여기서 시간은 가상입니다. `graph.run(…)`을 실행할 때만 시간이 흐르고 메시지가 도착합니다. `graph`는 `%load_ext tflab`이 만들어 둔 것입니다.

# %% name="mount-the-laser"
# %ros2 run tf2_ros static_transform_publisher --x 0.20 --z 0.15 --yaw 1.5707963 \
#     --frame-id base_link --child-frame-id laser_frame

# %% name="listen"
import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener

rclpy.try_shutdown()  # so that this cell can be run again
rclpy.init()
node = Node('corner_watcher')
buffer = Buffer()
listener = TransformListener(buffer, node, spin_thread=True)
graph.run(seconds=0.5)

# %% name="the-corner" tags=["predicted"] slide="fragment"
import tf2_geometry_msgs  # lets buffer.transform() accept a PointStamped
from geometry_msgs.msg import PointStamped

seen = PointStamped()
seen.header.frame_id = 'laser_frame'
seen.point.x = 2.0

corner = buffer.transform(seen, 'base_link')
base_p_corner = (corner.point.x, corner.point.y, corner.point.z)
print(corner.header.frame_id, lesson.fmt_all(base_p_corner))
print('your guess was off by', f'{math.dist(my_guess, base_p_corner):.2f} m')

# %% [markdown] lang="en" name="the-corner-seen" tags=["predicted"] slide="fragment"
# The laser faces left, so straight ahead of the laser is to the left of the robot: 2 m along y, measured from the laser.

# %% [markdown] lang="ko" name="the-corner-seen" tags=["predicted"] slide="fragment"
# 레이저가 왼쪽을 보므로, 레이저의 “앞”은 로봇의 “왼쪽”입니다. 레이저의 장착 위치에서 y로 2 m입니다.

# %% [markdown] lang="en" name="compare" slide="subslide"
# ### How was your guess?
#
# <details><summary>I said (2.2, 0, 0.15)</summary>
#
# You added the translation and left out the rotation.
# That is right only for a laser that faces straight ahead.
#
# </details>
# <details><summary>I said (0, −1.8, −0.15)</summary>
#
# You applied the inverse transform, which transforms data of `base_link` into `laser_frame`.
# The corner has changed sides, from the left of the robot to the right.
#
# </details>
# <details><summary>I said (0, 2.2, 0.15)</summary>
#
# You added the translation first and rotated the sum.
# The 20 cm are measured along `base_link`'s x, so they are not rotated. Rotate the point, *then* add the translation.
#
# </details>

# %% [markdown] lang="ko" name="compare" slide="subslide"
# ### 예측은 어땠나요?
#
# <details><summary>(2.2, 0, 0.15)라고 했습니다</summary>
#
# 이동은 더했지만 회전을 빠뜨렸습니다.
# 정면을 보는 레이저라면 맞는 답이고, 그때만 맞습니다.
#
# </details>
# <details><summary>(0, −1.8, −0.15)라고 했습니다</summary>
#
# 반대 변환을 적용했습니다. 그것은 로봇 기준 데이터를 레이저 기준으로 바꾸는 변환입니다.
# 그래서 로봇 왼쪽에 있는 모서리가 오른쪽에 나타났습니다.
#
# </details>
# <details><summary>(0, 2.2, 0.15)라고 했습니다</summary>
#
# 이동을 먼저 더한 다음 그 합을 회전시켰습니다.
# 20 cm는 로봇의 x축을 따라 잰 값이므로 회전시키면 안 됩니다. 점을 회전시키고, *그다음에* 이동을 더합니다.
#
# </details>

# %% [markdown] lang="en" name="one-transform" slide="slide"
# ## One transform, read twice
#
# What you published is a [[transform]]: the pose of the [[child frame]] in its [[parent frame]].
#
# ```
# header.frame_id = base_link      # parent
# child_frame_id  = laser_frame    # child
# translation     = (0.20, 0, 0.15)  [m], in the parent
# rotation        = (0, 0, 0.707, 0.707)   x, y, z, w
# ```
#
# These seven numbers, three for the translation and four for the rotation, have a second use.
# They take the coordinates of a point in the **child** and give the coordinates of the same point in the **parent**.
# So the arrow that is usually drawn, parent → child, shows which frame is the parent. Data goes the other way, child → parent.
#
# Name a transform by both frames, the parent first: `base_T_laser`. Read it as "laser, expressed in base".
#
# The next cell looks this transform up with ROS's own call, which returns a message.
# `look_up` converts the message into a `Transform` of this workbook: you can apply it to a point, and multiply it with `@`.

# %% [markdown] lang="ko" name="one-transform" slide="slide"
# ## 변환 하나, 두 가지 읽기
#
# 방금 발행한 것이 [[transform|좌표 변환(transform)]]입니다. [[child frame|자식 좌표계(child frame)]]가 [[parent frame|부모 좌표계(parent frame)]]를 기준으로 어디에 있는지 나타냅니다.
#
# ```
# header.frame_id = base_link      # parent
# child_frame_id  = laser_frame    # child
# translation     = (0.20, 0, 0.15)  [m], in the parent
# rotation        = (0, 0, 0.707, 0.707)   x, y, z, w
# ```
#
# 이 숫자 일곱 개(이동 셋, 회전 넷)의 쓰임새는 하나 더 있습니다.
# 이 숫자로 **자식** 기준인 점의 좌표를 **부모** 기준 좌표로 바꿀 수 있습니다.
# 흔히 그리는 부모 → 자식 화살표는 누가 누구에게 달려 있는지를 나타냅니다. 데이터는 그 반대로, 자식 기준에서 부모 기준으로 바뀝니다.
#
# 변환의 이름에는 두 좌표계를 모두 적고, 부모를 앞에 씁니다. `base_T_laser`라고 쓰고 “base 기준 laser”라고 읽습니다.
#
# 다음 셀은 ROS의 호출 그대로 이 변환을 조회합니다. 답은 메시지입니다.
# `look_up`은 메시지를 이 워크북의 `Transform`으로 바꿉니다. `Transform`은 점에 적용하고 `@`로 합성할 수 있습니다.

# %% name="one-transform-in-numbers" slide="subslide"
from rclpy.time import Time
from tflab.ros.convert import stamped_from_msg


def look_up(target, source):
    message = buffer.lookup_transform(target, source, Time())  # as on a robot
    return stamped_from_msg(message).transform


base_T_laser = look_up('base_link', 'laser_frame')

print('where the laser is mounted ', lesson.fmt_all(base_T_laser.translation))
print('its origin, in base_link   ', lesson.fmt_all(base_T_laser.apply((0.0, 0.0, 0.0))))
print('the corner, in base_link   ', lesson.fmt_all(base_T_laser.apply((2.0, 0.0, 0.0))))

# %% [markdown] lang="en" name="one-transform-numbers-seen"
# (The next section explains the order of the two names in the call.)
#
# The first two lines must be equal, and that shows in which direction a transform works.
# The laser's origin is (0, 0, 0) in `laser_frame`, and the transform gives its position in `base_link`: coordinates in the child go in, coordinates in the parent come out.

# %% [markdown] lang="ko" name="one-transform-numbers-seen"
# (호출에서 두 이름의 순서는 다음 절에서 다룹니다.)
#
# 처음 두 줄을 보십시오. 두 값은 같을 수밖에 없습니다. 이 사실 하나로 변환의 방향을 언제든 확인할 수 있습니다.
# 레이저의 원점은 레이저 기준으로 (0, 0, 0)입니다. 변환은 이 점의 좌표를 `base_link` 기준으로 바꾸며, 결과는 레이저가 달린 자리입니다.
# 자식 기준 데이터를 넣으면 부모 기준 데이터가 나옵니다.

# %% [markdown] lang="en" name="one-transform-notes" slide="notes"
# One question settles every doubt in this chapter: where does (0, 0, 0) end up? Let them ask it aloud each time somebody hesitates.

# %% [markdown] lang="ko" name="one-transform-notes" slide="notes"
# 변환의 방향이 헷갈리면 언제나 원점으로 확인합니다. “(0, 0, 0)을 넣으면 무엇이 나옵니까?” 누가 머뭇거릴 때마다 소리 내어 묻게 합니다.

# %% [markdown] lang="en" name="in-3d" slide="subslide"
# Now in 3D: drag to rotate the view, and move the slider to rotate the mount.
# The purple beam runs from the laser to the corner. The grey, hatched frame is the inverse transform, and the grey beam ends where it would place the corner. The still figure shows that position as a grey circle, *swapped*.

# %% [markdown] lang="ko" name="in-3d" slide="subslide"
# 이번에는 3D입니다. 마우스로 끌어 시점을 돌려 보고, 아래 슬라이더를 움직여 레이저를 회전시켜 보세요.
# 보라색 빔은 레이저에서 모서리까지입니다. 빗금 친 회색 좌표계는 역변환이고, 회색 빔의 끝은 역변환을 쓰면 모서리가 놓일 자리입니다. 정지 그림에서는 그 자리가 회색 원입니다. *그림 읽기:* corner = 모서리, swapped = 바꿔 씀, in base_link; grid of 1 m = base_link 기준, 눈금 한 칸이 1미터.

# %% name="in-3d-scene" tags=["interactive", "collapsed"]
# Show the mount, the corner and the swapped answer in 3D.
scene = lesson.Scene(height_px=380)
lesson.draw_frame(scene, 'base_link', Transform(), length_m=0.3)

def turn_the_mount(yaw):
    mount = Transform.from_rpy(yaw=yaw, translation=(0.20, 0.0, 0.15))
    places = lesson.seen_from(mount, (2.0, 0.0, 0.0))
    lesson.draw_frame(scene, 'laser_frame', mount, parent='base_link', length_m=0.3)
    lesson.draw_frame(scene, 'swapped', mount.inverse(), length_m=0.3, is_ghost=True)
    lesson.draw_arrow(scene, 'beam', mount.translation, places['corner'], 'corner', lesson.ACCENT)
    lesson.draw_path(scene, 'wrong beam', [mount.inverse().translation, places['swapped']], is_ghost=True)

scene.look(eye=(-2.7, -1.7, 2.0))
scene.sweep('yaw', [math.radians(angle) for angle in range(-180, 181, 15)], turn_the_mount, unit='rad', start=18)
scene

# %% name="in-3d-still" tags=["static"]
from tflab.views.projection import eye_at

lesson.draw_scene({'base_link': Transform(), 'laser_frame': base_T_laser}, {'corner': (0.2, 2.0, 0.15)},
                  ghost_points={'swapped': (0.0, -1.8, -0.15)}, eye=eye_at(math.radians(-150), math.radians(30)),
                  fixed_frame='base_link', length_m=0.35, caption='in base_link; grid of 1 m', size_inch=(5.4, 3.6))

# %% [markdown] lang="en" name="the-sentence" slide="slide"
# ## The sentence
#
# > Data **expressed in** `laser_frame`, **wanted in** `base_link`.
#
# That is all.
# The frame in which the data is expressed is the [[source frame|source]]. The frame in which you want it is the [[target frame|target]].
# In a call that names both frames, the target comes first:
#
# ```python
# lookup_transform('base_link', 'laser_frame', time)   # wanted in, expressed in, when
# ```
#
# The call returns `base_T_laser`, with the two frames in the same order.
# The sentence contains no "from" and no "to", so there is nothing to swap.
#
# | you want | target | source |
# |---|---|---|
# | a laser point on the map | `map` | `laser_frame` |
# | the robot's position on the map | `map` | `base_link` |
# | a goal on the map, relative to the robot | `base_link` | `map` |
#
# The second row is a special case of the first: "where is the robot" means the robot's own origin, expressed in `base_link`, wanted in `map`.

# %% [markdown] lang="ko" name="the-sentence" slide="slide"
# ## 문장 하나
#
# > `laser_frame` **기준으로 표현된** 데이터를 `base_link` **기준으로 보고 싶다**.
#
# 이것이 전부입니다.
# 데이터가 지금 표현된 기준이 [[source frame|원본 좌표계(source frame)]](소스 프레임이라고도 합니다)이고, 기준이 될 좌표계가 [[target frame|목표 좌표계(target frame)]]입니다. 줄여서 원본, 목표라고 부릅니다.
# 두 좌표계를 적는 호출에서는 목표가 먼저 옵니다.
#
# ```python
# lookup_transform('base_link', 'laser_frame', time)   # 목표, 원본, 시각
# ```
#
# 답은 `base_T_laser`입니다. 이름에 적힌 순서도 인자의 순서와 같습니다.
# 이 문장에는 “여기서 저기로”라는 말이 없으므로 거꾸로 읽힐 수 없습니다.
#
# | 하고 싶은 일 | 목표 | 원본 |
# |---|---|---|
# | 레이저 점을 지도에 찍기 | `map` | `laser_frame` |
# | 로봇이 지도 기준으로 어디에 있는지 알기 | `map` | `base_link` |
# | 지도에 있는 목적지를 로봇 기준으로 보기 | `base_link` | `map` |
#
# 둘째 줄도 같은 문장입니다. “로봇이 어디 있는가”는 `base_link` 기준인 로봇의 원점을 `map` 기준으로 보고 싶다는 뜻입니다.

# %% [markdown] lang="en" name="the-sentence-notes" slide="notes"
# Let everybody say it aloud three times with other frames: camera and map, tool and base, goal and robot.
# If the board is free, write both meanings of "from A to B" beside it once more, and strike them out.
# If somebody says "from", stop and smile.

# %% [markdown] lang="ko" name="the-sentence-notes" slide="notes"
# 다른 좌표계로 세 번 소리 내어 말하게 합니다. 카메라와 지도, 공구와 베이스, 목적지와 로봇.
# 칠판에 “A에서 B로”의 두 가지 읽기를 다시 쓰고, 줄을 그어 지웁니다.
# 누가 “어디에서 어디로”라고 말하면 잠시 멈추고 문장으로 고쳐 말하게 합니다.

# %% [markdown] lang="en" name="dominoes" slide="slide"
# ## Dominoes
#
# The laser is mounted on the robot. The robot moves in [[odom|`odom`]], the frame of its wheel odometry. The pose of `odom` is given in [[map|`map`]], the frame of the building.
# [[base_footprint|`base_footprint`]] is a frame on the floor, directly below `base_link`.
#
# The next cells publish the rest of the robot. Each `edge(…)` is one message: the parent, the child, the child's position in the parent, and its yaw.
# (The folded cell defines `edge`.)

# %% [markdown] lang="ko" name="dominoes" slide="slide"
# ## 도미노
#
# 레이저는 로봇에 달려 있습니다. 로봇의 포즈는 [[odom|`odom`]](바퀴로 잰 위치의 기준)을 기준으로 정해지고, `odom`의 포즈는 [[map|`map`]](건물 지도의 기준)을 기준으로 정해집니다.
# [[base_footprint|`base_footprint`]]는 로봇 중심을 바닥에 투영한 자리입니다.
#
# 다음 셀은 나머지 연결을 발행합니다. `edge(…)` 하나가 메시지 하나이며, 차례로 부모, 자식, 부모 기준인 자식의 위치, yaw입니다.
# (`edge`는 접힌 셀에서 정의합니다.)

# %% name="an-edge" tags=["collapsed"] slide="skip"
# Define edge(), which fills one message.
from geometry_msgs.msg import TransformStamped


def edge(parent, child, x=0.0, y=0.0, z=0.0, yaw=0.0):
    t = TransformStamped()
    t.header.frame_id = parent
    t.child_frame_id = child
    t.transform.translation.x = x
    t.transform.translation.y = y
    t.transform.translation.z = z
    t.transform.rotation.z = math.sin(yaw / 2)
    t.transform.rotation.w = math.cos(yaw / 2)
    return t

# %% name="the-rest-of-the-robot"
from tf2_ros import StaticTransformBroadcaster

broadcaster = StaticTransformBroadcaster(node)
broadcaster.sendTransform(
    [
        edge('map', 'odom', x=4.0, y=1.0, yaw=math.pi / 2),
        edge('odom', 'base_footprint', x=2.0),
        edge('base_footprint', 'base_link', z=0.10),
        edge('base_link', 'camera_link', x=0.10, z=0.30),
    ]
)
graph.run(seconds=0.5)

# %% [markdown] lang="en" name="the-tree-why" slide="subslide"
# The robot stands still in this chapter, so every edge may be static. The picture marks a static edge with **S**.
# (The last column is `default_authority` everywhere: a ROS 2 message does not name its publisher.)

# %% [markdown] lang="ko" name="the-tree-why" slide="subslide"
# 이 장에서는 로봇이 서 있으므로 모든 연결이 정적이어도 됩니다. 그림에는 **S**로 표시됩니다.
# (ROS 2는 누가 발행한 연결인지 전달하지 않으므로 마지막 열은 모두 `default_authority`입니다.)

# %% name="the-tree" tags=["collapsed"]
# Draw the tree.
lesson.draw_buffer(buffer)

# %% [markdown] lang="en" name="dominoes-fit" slide="subslide"
# ### Neighbours must match
#
# Transforms multiply like dominoes: the right half of one must be the left half of the next.
# Matching halves cancel, and the two ends remain.

# %% [markdown] lang="ko" name="dominoes-fit" slide="subslide"
# ### 이웃끼리 맞아야 합니다
#
# 변환을 합성하는 것은 도미노를 놓는 것과 같습니다. 앞 조각의 오른쪽 칸과 다음 조각의 왼쪽 칸이 같아야 합니다.
# 맞닿은 두 이름은 지워지고 양 끝만 남습니다.

# %% [markdown] lang="en" name="dominoes-fit-notes" slide="notes"
# Bring real dominoes, or six paper cards with frame names on both halves.
# Let somebody lay the dominoes from map to laser, then hand over one card turned round: that is an inverse.

# %% [markdown] lang="ko" name="dominoes-fit-notes" slide="notes"
# 진짜 도미노나, 양쪽 칸에 좌표계 이름을 적은 종이 카드 여섯 장을 준비합니다.
# 한 사람에게 목표 map, 원본 laser가 되도록 놓게 한 다음, 카드 한 장을 뒤집어 건넵니다. 그것이 역변환입니다.

# %% name="dominoes-that-fit" tags=["collapsed"]
# Draw the dominoes.
lesson.draw_dominoes(('map', 'odom'), ('odom', 'base_link'), ('base_link', 'laser_frame'))

# %% [markdown] lang="en" name="worked-example" slide="subslide"
# ### A worked example
#
# The corner once more: expressed in `laser_frame`, wanted in `map`.
# First you calculate it by hand, one domino after the other. Then you compare with `lookup_transform`.

# %% [markdown] lang="ko" name="worked-example" slide="subslide"
# ### 예제
#
# 다시 그 모서리입니다. `laser_frame` 기준 좌표를 `map` 기준으로 보고 싶습니다.
# 먼저 도미노를 하나씩 놓아 손으로 구하고, 그다음 `lookup_transform`의 답과 비교합니다.

# %% name="worked-example-by-hand"
map_T_odom = look_up('map', 'odom')
odom_T_base = look_up('odom', 'base_link')

laser_p_corner = (2.0, 0.0, 0.0)
base_p_corner = base_T_laser.apply(laser_p_corner)
odom_p_corner = odom_T_base.apply(base_p_corner)
map_p_corner = map_T_odom.apply(odom_p_corner)
for frame, point in (('base', base_p_corner), ('odom', odom_p_corner), ('map', map_p_corner)):
    print(f'{frame}_p_corner', lesson.fmt_all(point))

# %% name="worked-example-in-one"
map_T_laser = map_T_odom @ odom_T_base @ base_T_laser

print('one product   ', lesson.fmt_all(map_T_laser.apply(laser_p_corner)))
print('one lookup    ', lesson.fmt_all(look_up('map', 'laser_frame').apply(laser_p_corner)))

# %% [markdown] lang="en" name="wrong-order" slide="subslide"
# ### Dominoes that do not fit
#
# Here the transforms are multiplied in another order.
# The picture shows that they do not fit.

# %% [markdown] lang="ko" name="wrong-order" slide="subslide"
# ### 맞지 않는 도미노
#
# 누군가 다른 순서로 합성합니다.
# 그림에서는 바로 드러납니다. *그림 읽기:* A is not B = A와 B가 다름.

# %% name="dominoes-that-do-not-fit" tags=["collapsed"]
# Draw the dominoes in the wrong order.
lesson.draw_dominoes(('map', 'odom'), ('base_link', 'laser_frame'), ('odom', 'base_link'))

# %% name="wrong-order-in-numbers" slide="fragment"
nonsense = map_T_odom @ base_T_laser @ odom_T_base
print('the corner, in the wrong order', lesson.fmt_all(nonsense.apply(laser_p_corner)))

# %% [markdown] lang="en" name="wrong-order-seen"
# Python reports no error: it multiplies any two transforms.
# The corner has moved by metres.
# That is why a variable's name contains both frames: `map_T_odom @ base_T_laser` *looks* wrong, and `T1 @ T3` never does.

# %% [markdown] lang="ko" name="wrong-order-seen"
# 파이썬은 오류를 내지 않습니다. 변환은 어떤 둘이든 합성할 수 있기 때문입니다.
# 모서리의 위치가 몇 미터나 틀렸는데 오류는 나지 않았습니다.
# 변수 이름에 두 좌표계를 모두 적는 이유가 이것입니다. `map_T_odom @ base_T_laser`는 틀려 *보이지만*, `T1 @ T3`는 절대 틀려 보이지 않습니다.

# %% [markdown] lang="en" name="wrong-order-notes" slide="notes"
# Write T1 @ T3 @ T2 on the board and ask who would stop it in a review. Then write the same line with its real names.

# %% [markdown] lang="ko" name="wrong-order-notes" slide="notes"
# 칠판에 T1 @ T3 @ T2라고 쓰고, 코드 검토에서 찾을 수 있겠는지 묻습니다. 그다음 같은 줄을 두 좌표계가 드러나는 이름으로 다시 씁니다.

# %% [markdown] lang="en" name="inverse" slide="slide"
# ## The inverse
#
# Stand up. You are the laser, and you face the same way as the robot. The robot's centre is 20 cm behind you. Now turn left by 90°.
# Where is the robot's centre now, **measured from you**? Point at it before you read on.
#
# <details><summary>Sit down again</summary>
#
# The robot's front is to your right now. Its centre is farther back on the robot than you are, so it is on your **left**: +y, not −x.
# If you only change the sign, you get "20 cm behind you", and there is nothing there.
#
# </details>

# %% [markdown] lang="ko" name="inverse" slide="slide"
# ## 되돌아가는 변환: 역변환
#
# 자리에서 일어나 보세요. 여러분이 레이저입니다. 지금 보는 쪽이 로봇의 앞이고, 로봇의 중심은 등 뒤로 20 cm 떨어져 있습니다. 이제 왼쪽으로 90° 회전해 보세요.
# **여러분을 기준으로** 로봇의 중심은 이제 어느 쪽일까요? 손으로 가리킨 다음 아래를 열어 보세요.
#
# <details><summary>이제 앉아도 됩니다</summary>
#
# 이제 로봇의 앞은 여러분의 오른쪽입니다. 중심은 레이저보다 로봇의 뒤쪽에 있으므로 여러분의 **왼쪽**, 즉 −x가 아니라 +y입니다.
# 부호만 바꾸었다면 “등 뒤 20 cm”라고 했을 텐데, 거기에는 아무것도 없습니다.
#
# </details>

# %% [markdown] lang="en" name="inverse-why" slide="fragment"
# A transform first rotates by R and then adds the translation t. To invert it, subtract t first, then apply the inverse rotation R⁻¹.
# The inverse is also written as a rotation, then a translation. Its rotation is R⁻¹. Its translation is t, rotated by R⁻¹ and negated:
#
# ```
# base_T_laser:  R      then  t
# laser_T_base:  R⁻¹    then  −R⁻¹ t
# ```
#
# Negating the translation alone is right only if the rotation does not change it, for example if there is no rotation.

# %% [markdown] lang="ko" name="inverse-why" slide="fragment"
# 변환은 회전 R을 한 다음 이동 t를 더하는 것입니다. 되돌리려면 이동을 먼저 빼고, 그다음 반대로 회전시킵니다.
# 이것을 다시 “회전한 다음 이동” 꼴로 쓰면 이동도 함께 회전합니다.
#
# ```
# base_T_laser:  R      then  t
# laser_T_base:  R⁻¹    then  −R⁻¹ t
# ```
#
# 부호만 바꾸는 것은 회전시켜도 이동이 그대로일 때만 맞습니다. 회전이 없을 때가 그렇습니다.

# %% name="inverse-in-numbers" slide="subslide"
laser_T_base = base_T_laser.inverse()
x, y, z = base_T_laser.translation
flipped = Transform((-x, -y, -z), laser_T_base.rotation)  # the minus sign alone

print('there and back      ', lesson.fmt_all(laser_T_base.apply(base_p_corner)))
print('there and "flipped" ', lesson.fmt_all(flipped.apply(base_p_corner)))

# %% name="inverse-seen-from-the-laser" tags=["collapsed"]
# Draw the inverse, seen from the laser.
lesson.draw_scene({'laser_frame': Transform(), 'base_link': laser_T_base}, ghosts={'sign flipped': flipped},
                  eye=lesson.FROM_ABOVE, fixed_frame='laser_frame', length_m=0.075, size_inch=(5.2, 4.4))

# %% [markdown] lang="en" name="inverse-seen"
# If you transform a point there and back, it must return to where it was: (2, 0, 0).
# With only the sign changed it misses by 28 cm, the length of a shoe. That is just small enough to look like a bad calibration.

# %% [markdown] lang="ko" name="inverse-seen"
# *그림 읽기:* 위에서 본 모습입니다. x, y in laser_frame = laser_frame 기준 x, y. sign flipped = 부호만 바꾼 것.
#
# 변환한 다음 역변환하면 처음의 점인 (2, 0, 0)이 나와야 합니다.
# 부호만 바꾼 쪽은 신발 한 짝 길이인 28 cm만큼 빗나갑니다. 보정이 조금 틀어졌다고 넘기기 쉬운 크기입니다.

# %% [markdown] lang="en" name="inverse-seen-notes" slide="notes"
# Really let one person stand up. It takes twenty seconds, and nobody forgets it.
# Then ask: for which yaw of this mount is the changed sign right? Only for zero. How large is the error?
# Twice the translation times the sine of half the rotation: 2 × 0.20 m × sin 45° = 0.28 m.

# %% [markdown] lang="ko" name="inverse-seen-notes" slide="notes"
# 정말로 한 사람을 일으켜 세웁니다. 20초면 되고, 오래 기억에 남습니다.
# 그다음 묻습니다. 부호만 바꾸어도 맞는 회전은 몇 도입니까? 0°뿐입니다. 얼마나 틀립니까?
# 이동 거리의 두 배에 회전각 절반의 사인을 곱한 만큼, 2 × 0.20 m × sin 45° = 0.28 m입니다.

# %% [markdown] lang="en" name="echo-help" slide="slide"
# ## The tool that caused it all
#
# `tf2_echo A B` prints the pose of B in A.
# So A is the target, the frame in which you want the pose, and B is the source. `lookup_transform` has the same order.
# Now read the tool's own help.

# %% [markdown] lang="ko" name="echo-help" slide="slide"
# ## 10년 된 질문의 시작: tf2_echo
#
# `tf2_echo A B`는 A를 기준으로 B가 어디에 있는지 출력합니다.
# 따라서 A가 기준이 될 좌표계(목표)이고 B가 원본입니다. `lookup_transform`과 같은 순서입니다.
# 이제 도구의 도움말을 직접 읽어 봅시다.

# %% name="echo-help-itself"
# %ros2 run tf2_ros tf2_echo

# %% [markdown] lang="en" name="echo-help-seen"
# The first argument is the *target* of the lookup, and the help calls it `source_frame`.
# The first sentence of the help says "from … to …". Two lines later it says, correctly, that data goes the other way.
# Rely on the sentence instead: first the frame *wanted in*, then the frame *expressed in*.

# %% [markdown] lang="ko" name="echo-help-seen"
# 첫 인자는 조회의 *목표*인데, 도움말은 그것을 `source_frame`이라고 부릅니다.
# 첫 문장은 “어디에서 어디로”라고 적었습니다. 두 줄 아래에는 데이터가 그 반대로 바뀐다고 적었고, 이쪽이 맞습니다.
# 도움말 대신 앞에서 배운 문장 “원본 기준 데이터를 목표 기준으로 보고 싶다”를 따르십시오. **`tf2_echo 목표 원본`** 순서입니다.

# %% [markdown] lang="en" name="echo-help-notes" slide="notes"
# Read the help aloud, slowly and with a straight face. Let the class find the contradiction before you name it.

# %% [markdown] lang="ko" name="echo-help-notes" slide="notes"
# 도움말을 진지한 얼굴로 천천히 읽습니다. 모순은 먼저 말하지 말고 청중이 찾게 합니다.

# %% [markdown] lang="en" name="echo-predict" slide="subslide"
# ### Predict the second from the first
#
# Here is `tf2_echo base_link laser_frame`.
# Before you run the second cell: what will the Translation of `tf2_echo laser_frame base_link` be?
# (`--for 1.5` exists only in this workbook and stops the tool. In a terminal, press Ctrl-C.)

# %% [markdown] lang="ko" name="echo-predict" slide="subslide"
# ### 첫 출력에서 둘째 출력 예측하기
#
# 아래는 `tf2_echo base_link laser_frame`입니다.
# 그다음 셀을 실행하기 전에, `tf2_echo laser_frame base_link`의 Translation이 무엇일지 적어 보세요.
# (`--for 1.5`는 이 페이지에만 있는 것으로, 1.5초 뒤에 도구를 멈춥니다. 터미널에서는 빼고 입력한 다음 Ctrl-C로 멈춥니다.)

# %% name="echo-one-way" slide="-"
# %ros2 --for 1.5 run tf2_ros tf2_echo base_link laser_frame

# %% name="echo-the-other-way" tags=["predicted"] slide="subslide"
# %ros2 --for 1.5 run tf2_ros tf2_echo laser_frame base_link

# %% [markdown] lang="en" name="echo-seen" tags=["predicted"]
# If you only change the sign, you expect (−0.20, 0, −0.15). The tool prints (0, 0.20, −0.15), which is to the laser's left, as you saw when you stood up.
# The first line of each output was printed before any transform arrived. The tool prints zero as `-0.000` here.

# %% [markdown] lang="ko" name="echo-seen" tags=["predicted"]
# 부호만 바꾸면 (−0.20, 0, −0.15)이지만, 도구는 (0, 0.20, −0.15)를 출력합니다. 일어서서 본 대로 레이저의 왼쪽입니다.
# 출력의 첫 줄은 도구가 변환을 받기 전에 출력한 것입니다. `-0.000`은 0과 같습니다.

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it: a swap passes the tests
#
# A team swaps the arguments.
# Their robot has one laser, at the back, facing backwards: 20 cm behind `base_link`, rotated by 180°.
# They test with a corner 2 m ahead of the laser and 0.7 m to its left. Everything is in one plane.
#
# **Predict:** how far is the swapped answer from the right one? A centimetre, half a metre, four metres?

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기: 시험을 통과한 실수
#
# 어느 팀이 인자를 바꿔 썼습니다.
# 그 로봇에는 뒤를 보는 레이저가 중심에서 20 cm 뒤에 180° 회전한 채 달려 있습니다.
# 팀은 레이저의 앞 2 m, 왼쪽 0.7 m에 있는 모서리로 시험합니다. 모두 한 평면 위에 있습니다.
#
# **예측해 봅시다.** 바꿔 쓴 답은 올바른 답에서 얼마나 떨어져 있을까요? 1 cm일까요, 0.5 m일까요, 4 m일까요?

# %% [markdown] lang="en" name="break-it-notes" slide="notes"
# Ask before running: will the numbers differ? Almost everybody says yes.
# Then: what would your own test have been? A symmetric test cannot find a swap.

# %% [markdown] lang="ko" name="break-it-notes" slide="notes"
# 실행 전에 묻습니다. 두 숫자가 다르겠습니까? 거의 모두 다르다고 답합니다.
# 그다음 묻습니다. 여러분이라면 무엇으로 시험했겠습니까? 대칭인 시험으로는 바꿔 쓴 답을 찾지 못합니다.

# %% name="swap-at-the-back" tags=["predicted"] slide="fragment"
rear = Transform.from_rpy(yaw=math.pi, translation=(-0.20, 0.0, 0.0))
seen_at = (2.0, 0.7, 0.0)

print('right  ', lesson.fmt_all(rear.apply(seen_at)))
print('swapped', lesson.fmt_all(rear.inverse().apply(seen_at)))

# %% [markdown] lang="en" name="swap-at-the-back-seen" tags=["predicted"] slide="subslide"
# They are identical: this mount is its own inverse. If you apply it twice, the two rotations by 180° cancel, and so do the two translations.
# Every test passes.

# %% [markdown] lang="ko" name="swap-at-the-back-seen" tags=["predicted"] slide="subslide"
# 똑같습니다. 180° 회전은 두 번 하면 제자리이므로, 이렇게 단 센서의 변환은 자기 자신이 역변환입니다.
# 시험은 모두 통과합니다.

# %% [markdown] lang="en" name="swap-once-more"
# The code is reviewed, merged, and copied to the next robot, whose laser faces left.
#
# **Predict** once more: how far off is the swapped answer now?

# %% [markdown] lang="ko" name="swap-once-more"
# 코드는 검토를 거쳐 병합되고, 레이저가 왼쪽을 보는 다음 로봇으로 복사됩니다.
#
# 다시 **예측**해 봅시다. 이번에는 얼마나 어긋날까요?

# %% name="swap-on-the-side" tags=["predicted"] slide="fragment"
answer = look_up('laser_frame', 'base_link')  # swapped
right, swapped = base_T_laser.apply(seen_at), answer.apply(seen_at)
print('right  ', lesson.fmt_all(right))
print('swapped', lesson.fmt_all(swapped), f'off by {math.dist(right, swapped):.2f} m')

# %% [markdown] lang="en" name="no-error" slide="subslide"
# ### Where is the error message?
#
# There is none.
# Both lookups are valid, and TF2 cannot know which one you meant.
# The shelf is on the robot's left. The swapped answer places it on the right, so the robot drives into the shelf.

# %% [markdown] lang="ko" name="no-error" slide="subslide"
# ### 오류 메시지는 어디에 있을까요?
#
# 없습니다.
# 두 조회 모두 올바른 조회이고, TF2는 여러분이 어느 쪽을 뜻했는지 알 길이 없습니다.
# 선반은 왼쪽에 있는데 로봇은 오른쪽을 조심하다가 선반을 들이받습니다.

# %% [markdown] lang="en" name="safest-call"
# The safest call is the one that you used at the start: `buffer.transform(message, 'base_link')`.
# The message carries its source in `header.frame_id`. You only name the target, so you cannot swap anything.
# Only if you look up and transform in two calls do you have to get the order right yourself.

# %% [markdown] lang="ko" name="safest-call"
# 가장 안전한 호출은 처음에 쓴 `buffer.transform(message, 'base_link')`입니다.
# 원본은 메시지의 `header.frame_id`에 들어 있으므로 목표만 정하면 되고, 바꿔 쓸 것이 없습니다.
# 조회와 변환을 두 호출로 나누어 쓸 때에만 두 이름의 순서를 직접 지켜야 합니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# A detector publishes an apple with `header.frame_id = 'camera_optical_frame'`.
# The motion of the arm is planned in `base_link`.
# Which line gives the transform to apply to the apple?
#
# 1. `lookup_transform('camera_optical_frame', 'base_link', t)`
# 2. `lookup_transform('base_link', 'camera_link', t)`
# 3. `lookup_transform('base_link', 'camera_optical_frame', t)`
# 4. `lookup_transform('map', 'camera_optical_frame', t)`, because `map` contains everything
#
# <details><summary>I chose 1</summary>
#
# Say the sentence: data expressed in `camera_optical_frame`, wanted in `base_link`. Wanted comes first.
#
# </details>
# <details><summary>I chose 2</summary>
#
# The order is right, the source is not: the apple is expressed in the *optical* frame, whose axes point in other directions (chapter 02).
#
# </details>
# <details><summary>I chose 3</summary>
#
# Yes: expressed in `camera_optical_frame`, wanted in `base_link`.
#
# </details>
# <details><summary>I chose 4</summary>
#
# The source is right, the target is not: the motion of the arm is planned in `base_link`.
# Through `map` you add the corrections of the localisation, which have nothing to do with the arm (chapter 05).
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 검출기가 사과의 위치를 `header.frame_id = 'camera_optical_frame'`으로 발행합니다.
# 팔의 동작은 `base_link` 기준으로 계획합니다.
# 사과에 적용할 변환을 얻는 줄은 어느 것입니까?
#
# 1. `lookup_transform('camera_optical_frame', 'base_link', t)`
# 2. `lookup_transform('base_link', 'camera_link', t)`
# 3. `lookup_transform('base_link', 'camera_optical_frame', t)`
# 4. `lookup_transform('map', 'camera_optical_frame', t)`, 무엇이든 `map` 기준으로 두어야 하므로
#
# <details><summary>1번을 골랐습니다</summary>
#
# 문장으로 말해 보십시오. `camera_optical_frame` 기준 데이터를 `base_link` 기준으로 보고 싶습니다. 기준이 될 좌표계(목표)를 먼저 씁니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 순서는 맞지만 원본이 다릅니다. 사과는 축 방향이 다른 *광학* 좌표계 기준입니다(02장).
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞습니다. `camera_optical_frame` 기준 데이터를 `base_link` 기준으로 보고 싶습니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 원본은 맞지만 목표가 다릅니다. 팔은 `base_link` 기준으로 계획합니다.
# `map`을 거치면 팔과 상관없는 위치 추정의 보정까지 사과의 위치에 섞입니다(05장).
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Vote on all four before you open any reply. Let a voter for 1 and a voter for 3 convince each other.
# Option 2 is the instructive one: the order is right, and the apple is still in the wrong position.

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 답을 펼치기 전에 네 가지 모두 손을 들게 하고, 1번과 3번을 고른 사람이 서로 설득하게 합니다.
# 나올 법한 오답은 2번입니다. 순서는 맞는데 사과는 여전히 엉뚱한 자리에 있습니다.

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# Once a second this node looks up where the laser is mounted, and compares that with the drawing.
# Save it as `where_is_the_laser.py`, and put the numbers of your own drawing into `DRAWING`.
#
# ```python
# # tf_lab_py/where_is_the_laser.py
# import math
#
# import rclpy
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
# from tf2_ros import Buffer, TransformException, TransformListener
#
# DRAWING = (0.20, 0.00, 0.15)  # laser_frame in base_link [m]
#
#
# class WhereIsTheLaser(Node):
#     def __init__(self):
#         super().__init__('where_is_the_laser')
#         self.buffer = Buffer()
#         self.listener = TransformListener(self.buffer, self)
#         self.timer = self.create_timer(1.0, self.compare)
#
#     def compare(self):
#         try:
#             t = self.buffer.lookup_transform('base_link', 'laser_frame', Time())  # wanted in, expressed in
#         except TransformException as error:
#             self.get_logger().warning(f'not yet: {error}')
#             return
#         p = t.transform.translation
#         off = math.dist((p.x, p.y, p.z), DRAWING)
#         text = f'laser in {t.header.frame_id}: ({p.x:.2f}, {p.y:.2f}, {p.z:.2f}), {off:.2f} m off'
#         if off > 0.01:
#             self.get_logger().error(text)
#         else:
#             self.get_logger().info(text)
#
#
# def main():
#     rclpy.init()
#     node = WhereIsTheLaser()
#     try:
#         rclpy.spin(node)
#     except (KeyboardInterrupt, ExternalShutdownException):
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.try_shutdown()
#
#
# if __name__ == '__main__':
#     main()
# ```
#
# In the result of a lookup, `header.frame_id` is the target and `child_frame_id` is the source.
# Directly after its start a listener has received nothing, so the node has to handle "not yet". Chapter 09 shows how to wait.

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# 이 노드는 1초마다 레이저의 장착 변환을 확인합니다. 발행된 레이저의 위치를 조회하여 도면과 비교합니다.
# `where_is_the_laser.py`로 저장하고, `DRAWING`에 여러분 로봇의 도면 값을 넣습니다.
#
# ```python
# # tf_lab_py/where_is_the_laser.py
# import math
#
# import rclpy
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
# from tf2_ros import Buffer, TransformException, TransformListener
#
# DRAWING = (0.20, 0.00, 0.15)  # laser_frame in base_link [m]
#
#
# class WhereIsTheLaser(Node):
#     def __init__(self):
#         super().__init__('where_is_the_laser')
#         self.buffer = Buffer()
#         self.listener = TransformListener(self.buffer, self)
#         self.timer = self.create_timer(1.0, self.compare)
#
#     def compare(self):
#         try:
#             t = self.buffer.lookup_transform('base_link', 'laser_frame', Time())  # wanted in, expressed in
#         except TransformException as error:
#             self.get_logger().warning(f'not yet: {error}')
#             return
#         p = t.transform.translation
#         off = math.dist((p.x, p.y, p.z), DRAWING)
#         text = f'laser in {t.header.frame_id}: ({p.x:.2f}, {p.y:.2f}, {p.z:.2f}), {off:.2f} m off'
#         if off > 0.01:
#             self.get_logger().error(text)
#         else:
#             self.get_logger().info(text)
#
#
# def main():
#     rclpy.init()
#     node = WhereIsTheLaser()
#     try:
#         rclpy.spin(node)
#     except (KeyboardInterrupt, ExternalShutdownException):
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.try_shutdown()
#
#
# if __name__ == '__main__':
#     main()
# ```
#
# 조회한 결과에서 `header.frame_id`는 목표이고 `child_frame_id`는 원본입니다.
# 막 시작한 수신기는 아직 받은 변환이 없습니다. 그래서 이 노드는 “아직 없음”(not yet)도 처리합니다. 기다리는 방법은 09장에서 다룹니다.

# %% [markdown] lang="en" name="on-the-robot-commands" slide="subslide"
# On a robot, `python3 where_is_the_laser.py` runs the node. Without ROS, type this into a terminal of JupyterLab. It runs the node beside a publisher of the mount:
#
# ```
# tflab run where_is_the_laser.py --for 5 \
#     --with "ros2 run tf2_ros static_transform_publisher --x 0.20 --z 0.15 \
#     --yaw 1.5707963 --frame-id base_link --child-frame-id laser_frame"
# ```
#
# Then exchange the names of the two frames in the publisher: now the laser is 0.41 m off.
#
# Three commands to type on any robot:
#
# ```
# ros2 run tf2_ros tf2_echo base_link laser_frame   # the laser, on the robot
# ros2 run tf2_ros tf2_echo odom base_link          # the robot, by its wheels
# ros2 run tf2_ros tf2_echo map base_link           # the robot, on the map
# ```

# %% [markdown] lang="ko" name="on-the-robot-commands" slide="subslide"
# 로봇에서는 `python3 where_is_the_laser.py`로 실행합니다. ROS가 없으면 JupyterLab의 터미널에 다음을 입력해 보세요. 장착 변환을 발행하는 도구와 함께 노드를 실행합니다.
#
# ```
# tflab run where_is_the_laser.py --for 5 \
#     --with "ros2 run tf2_ros static_transform_publisher --x 0.20 --z 0.15 \
#     --yaw 1.5707963 --frame-id base_link --child-frame-id laser_frame"
# ```
#
# 이어서 발행하는 명령에서 두 좌표계의 이름을 맞바꿔 보세요. 이번에는 레이저가 0.41 m 어긋나 있습니다.
#
# 어느 로봇에서나 입력해 볼 명령 세 개와 그 뜻입니다.
#
# ```
# ros2 run tf2_ros tf2_echo base_link laser_frame   # 로봇 기준의 레이저
# ros2 run tf2_ros tf2_echo odom base_link          # odom 기준의 로봇(바퀴로 잰 포즈)
# ros2 run tf2_ros tf2_echo map base_link           # 지도 기준의 로봇
# ```

# %% name="stop" tags=["collapsed"] slide="skip"
# Stop the nodes.
graph.stop()
rclpy.try_shutdown()

# %% [markdown] lang="en" name="recap" slide="slide"
# ## Recap
#
# - A [[transform]] `parent_T_child` is the pose of the child in the parent. It transforms coordinates in the child into coordinates in the parent.
# - Say it without "from" and "to": **data expressed in [[source frame|source]], wanted in [[target frame|target]]**. Wanted comes first.
# - Neighbours match: `map_T_laser = map_T_odom @ odom_T_base @ base_T_laser`.
# - The reverse transform is the inverse. It rotates the translation as well. A minus sign is not enough.
# - A swap raises no error. A rotation by 180° hides it, a rotation by 90° shows it.
# - `tf2_echo A B` prints the pose of B in A.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - [[transform|변환]] `parent_T_child`는 자식이 부모를 기준으로 어디에 있는지 나타내고, 자식 기준의 데이터를 부모 기준으로 바꿉니다.
# - “어디에서 어디로” 대신 이렇게 말합니다. **[[source frame|원본]] 기준 데이터를 [[target frame|목표]] 기준으로 보고 싶다.** 호출에서는 **목표**가 먼저입니다.
# - 이웃끼리 맞춥니다. `map_T_laser = map_T_odom @ odom_T_base @ base_T_laser`.
# - 되돌아가는 변환은 역변환입니다. 반대로 회전시키고, 이동도 회전시켜야 합니다. 부호만으로는 부족합니다.
# - 바꿔 써도 오류는 나지 않습니다. 180°에서는 드러나지 않고, 90°에서는 드러납니다.
# - `tf2_echo A B`는 A를 기준으로 B가 어디에 있는지 출력합니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# Fill in the blanks without looking anything up.
#
# > "`goal` is expressed in `map`. The controller works in `base_link`."
# > `lookup_transform('____', '____', Time())`, and the product that gives it: `base_T_map = ______ @ ______`
#
# <details><summary>Compare</summary>
#
# The call is `lookup_transform('base_link', 'map', Time())`. The product is `base_T_map = base_T_odom @ odom_T_map`. Both factors are inverses of transforms along the tree: `odom_T_base` and `map_T_odom`.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# 찾아보지 말고 빈칸을 채워 보세요.
#
# > "`goal`은 `map` 기준이다. 제어기는 `base_link`를 기준으로 움직인다."
# > `lookup_transform('____', '____', Time())`, 그리고 이 변환을 만드는 합성: `base_T_map = ______ @ ______`
#
# <details><summary>맞춰 보기</summary>
#
# `lookup_transform('base_link', 'map', Time())`이고, `base_T_map = base_T_odom @ odom_T_map`입니다. 두 변환은 각각 `odom_T_base`와 `map_T_odom`의 역변환입니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Collect the tickets. If the order is wrong on many, return to it at the start of the next lecture.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 쪽지를 걷습니다. 순서가 틀린 사람이 있으면 다음 강의를 그 이야기로 시작합니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now turn a sentence into a lookup, chain and invert transforms, and read `tf2_echo` in both directions.
# Practise that in [E3 Target and source](../../exercises/en/E03_target_and_source.ipynb). Its tasks E3.1 and E3.5 tick one line of the checklist that `tflab progress` shows: *I have run tf2_echo with target and source in the right order.* For task E3.8, read "A point, a velocity, a pose" below.
# The next chapter, [04 The tree of frames](04_frame_tree.ipynb), shows how the edges form a tree, and that tf2 does not check this.
#
# The sections below are optional: velocities and poses, a call with blanks, two panels, two sensors, wrong frame names, and questions for practice.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 문장을 조회로 바꾸고, 변환을 합성하고 역변환을 구하며, `tf2_echo`를 두 방향 모두 읽을 수 있습니다.
# 연습 문제 [E3 목표 좌표계와 원본 좌표계](../../exercises/ko/E03_target_and_source.ipynb)에서 손에 익혀 보세요. 과제 E3.1과 E3.5를 통과하면 실습 체크리스트(00장의 *나의 학습 현황*에 있습니다)의 한 줄을 채웁니다. *목표와 원본의 순서를 지켜 tf2_echo를 실행했습니다.* E3.8 과제에 필요한 내용은 아래 “점, 속도, 포즈” 절에 있습니다.
# 다음 장 [04 좌표계 트리](04_frame_tree.ipynb)에서는 연결들이 어떻게 트리를 이루는지 봅니다. 트리가 되도록 보장하는 프로그램은 없습니다.
#
# 아래는 더 알고 싶을 때 읽는 절입니다. 속도와 포즈, 빈칸이 있는 호출, 패널 두 개, 센서 두 개 사이의 변환, 잘못된 좌표계 이름, 복습과 서술형 문제가 있습니다.

# %% [markdown] lang="en" name="what-moves-heading" slide="slide"
# ## A point, a velocity, a pose: which part of the transform applies?

# %% [markdown] lang="ko" name="what-moves-heading" slide="slide"
# ## 점, 속도, 포즈: 변환의 어느 부분이 적용될까요?

# %% [markdown] lang="en" name="what-moves"
# The laser detects a person at (2, 0, 0) m who walks straight towards it. In `laser_frame` the velocity is (−1, 0, 0) m/s.
#
# **Predict:** what is the velocity in `base_link`? (−0.80, 0, 0.15), (0.20, −1, 0.15) or (0, −1, 0)?

# %% [markdown] lang="ko" name="what-moves"
# 레이저가 (2, 0, 0) m에 있는 사람을 측정했습니다. 사람은 레이저를 향해 똑바로 걸어옵니다. `laser_frame` 기준 속도는 (−1, 0, 0) m/s입니다.
#
# **예측해 봅시다.** `base_link` 기준 속도는 얼마일까요? (−0.80, 0, 0.15)일까요, (0.20, −1, 0.15)일까요, (0, −1, 0)일까요?

# %% name="velocity-and-pose" tags=["predicted"] slide="fragment"
from geometry_msgs.msg import PoseStamped, Vector3Stamped

velocity = Vector3Stamped()
velocity.header.frame_id = 'laser_frame'
velocity.vector.x = -1.0
v = buffer.transform(velocity, 'base_link').vector
print('velocity   ', lesson.fmt_all((v.x, v.y, v.z), 'm/s'))

person = PoseStamped()
person.header.frame_id = 'laser_frame'
person.pose.position.x = 2.0
person.pose.orientation.z, person.pose.orientation.w = 1.0, 0.0  # yaw 180°: facing the laser
at = buffer.transform(person, 'base_link').pose
print('position   ', lesson.fmt_all((at.position.x, at.position.y, at.position.z)))
print('yaw        ', lesson.fmt(2 * math.atan2(at.orientation.z, at.orientation.w), 'rad'))

# %% [markdown] lang="en" name="velocity-and-pose-seen" tags=["predicted"] slide="subslide"
# The velocity is (0, −1, 0): in the robot's axes the person walks to the right. A velocity has a direction and a size, but no position, so only the rotation applies.
# In a `PointStamped` the same numbers would become (0.20, −1, 0.15). Then a person who stands still would seem to move at 0.25 m/s.
#
# | quantity | message | rotation | translation |
# |---|---|---|---|
# | a point | `PointStamped` | yes | yes |
# | a direction, a velocity, a force | `Vector3Stamped` | yes | no |
# | a pose | `PoseStamped` | position and orientation | position only |
# | linear and angular velocity | `TwistStamped` | not supported in Python | not supported in Python |
#
# `buffer.transform` chooses by the type of the message. For a `TwistStamped` it raises `TypeException`, which `except TransformException` does not catch. Put each of its two vectors into a `Vector3Stamped`.
# The pose is turned as well: its yaw is −90° in `base_link`, the direction in which the person walks.
# A change of the frame changes the axes only. It is still the velocity of the same point of the robot, seen by the same observer. If the robot turns, another point of it moves with another linear velocity.

# %% [markdown] lang="ko" name="velocity-and-pose-seen" tags=["predicted"] slide="subslide"
# 속도는 (0, −1, 0)입니다. 로봇의 축으로 보면 사람은 오른쪽으로 걷습니다. 속도에는 방향과 크기가 있을 뿐 위치가 없으므로 회전만 적용됩니다.
# 같은 값을 `PointStamped`에 넣으면 (0.20, −1, 0.15)가 됩니다. 그러면 가만히 서 있는 사람도 0.25 m/s로 움직이는 것처럼 보입니다.
#
# | 값 | 메시지 | 회전 | 이동 |
# |---|---|---|---|
# | 점 | `PointStamped` | 적용 | 적용 |
# | 방향, 속도, 힘 | `Vector3Stamped` | 적용 | 적용 안 함 |
# | 포즈 | `PoseStamped` | 위치와 방향 | 위치만 |
# | 선속도와 각속도 | `TwistStamped` | 파이썬에서는 지원 안 함 | 파이썬에서는 지원 안 함 |
#
# `buffer.transform`은 메시지의 타입을 보고 고릅니다. `TwistStamped`를 넣으면 `TypeException`이 나는데, `except TransformException`으로는 잡히지 않습니다. 두 벡터를 각각 `Vector3Stamped`에 넣으십시오.
# 포즈의 방향도 함께 회전했습니다. `base_link` 기준 yaw는 사람이 걷는 방향인 −90°입니다.
# 기준을 바꾸면 축만 바뀝니다. 로봇의 같은 점을 같은 관측자가 본 속도라는 것은 그대로입니다. 로봇이 회전하면 로봇의 다른 점은 다른 선속도로 움직입니다.

# %% [markdown] lang="en" name="vector-trap" slide="fragment"
# One trap: `do_transform_vector3` sets the translation of the transform that you pass to zero. ROS 2 does the same. Look up again before you use that transform for a point. Task E3.8 asks for six more values.

# %% [markdown] lang="ko" name="vector-trap" slide="fragment"
# 함정이 하나 있습니다. `do_transform_vector3`은 인자로 받은 변환의 이동을 0으로 바꿔 놓습니다. ROS 2에서도 그렇습니다. 그 변환을 점에 쓰려면 먼저 다시 조회하십시오. 과제 E3.8에서 여섯 가지 값을 더 다룹니다.

# %% name="vector-trap-run" slide="-"
from tf2_geometry_msgs import do_transform_point, do_transform_vector3

t = buffer.lookup_transform('base_link', 'laser_frame', Time())
for when in ('before', 'after'):
    p = do_transform_point(seen, t).point
    print(f'the corner, {when:6}', lesson.fmt_all((p.x, p.y, p.z)))
    do_transform_vector3(velocity, t)

# %% [markdown] lang="en" name="faded-heading" slide="subslide"
# ## Your turn: a call with two blanks

# %% [markdown] lang="ko" name="faded-heading" slide="subslide"
# ## 빈칸을 채워 보세요: 목적지는 어느 쪽일까요?

# %% [markdown] lang="en" name="faded"
# A goal is given in `map` at (4, 1, 0). Where is it relative to the robot: ahead, behind, left, right?
# Fill in both blanks, and run the cell.

# %% [markdown] lang="ko" name="faded"
# 목적지가 `map` 기준 (4, 1, 0)에 있습니다. 서 있는 로봇을 기준으로 앞일까요, 뒤일까요, 왼쪽일까요, 오른쪽일까요?
# 빈칸 두 개를 채우고 실행해 보세요.

# %% name="faded-blanks"
wanted_in = ...  # blank 1: a frame's name, in quotes
expressed_in = ...  # blank 2

if ... not in (wanted_in, expressed_in):
    answer = look_up(wanted_in, expressed_in)
    print('the goal is at', lesson.fmt_all(answer.apply((4.0, 1.0, 0.0))), 'in', wanted_in)

# %% [markdown] lang="en" name="faded-answer"
# <details><summary>Compare</summary>
#
# Expressed in `map`, wanted in `base_link`: `lookup_transform('base_link', 'map', …)` gives the goal at (−2, 0, −0.1).
# That is 2 m behind the robot, and 10 cm below `base_link`, on the floor.
# If you got (3, 7, 0.1), you swapped the two names, and your robot drives somewhere else.
#
# </details>

# %% [markdown] lang="ko" name="faded-answer"
# <details><summary>맞춰 보기</summary>
#
# `map` 기준 좌표를 `base_link` 기준으로 보고 싶으므로 `lookup_transform('base_link', 'map', …)`이고, 목적지는 (−2, 0, −0.1)입니다.
# 로봇 뒤 2 m, 로봇 중심보다 10 cm 아래인 바닥입니다.
# (3, 7, 0.1)이 나왔다면 두 이름을 바꿔 쓴 것이고, 로봇은 엉뚱한 곳으로 갑니다.
#
# </details>

# %% [markdown] lang="en" name="one-edge-heading" slide="subslide"
# ## One published transform, two questions

# %% [markdown] lang="ko" name="one-edge-heading" slide="subslide"
# ## 발행된 변환 하나, 질문 두 개

# %% [markdown] lang="en" name="one-edge"
# A node publishes `base_link → camera_link` with the translation (0.10, 0, 0.30).
#
# 1. In which frame were 0.10 and 0.30 measured?
# 2. A point is expressed in `camera_link`. Which call gives the transform into `base_link`?
#
# <details><summary>Answers, and the trap</summary>
#
# 1. In `base_link`, the parent: the camera is 10 cm in front of it and 30 cm above it.
# 2. `lookup_transform('base_link', 'camera_link', t)`: wanted in, expressed in. The answer is the published transform itself.
#
# The trap is the arrow. It points from parent to child and shows which frame is the parent.
# If you read it as the direction of the data, you swap the frames in the second answer.
#
# </details>

# %% [markdown] lang="ko" name="one-edge"
# 어느 노드가 `base_link → camera_link`를 이동 (0.10, 0, 0.30)으로 발행합니다.
#
# 1. 0.10과 0.30은 어느 좌표계 기준으로 잰 값일까요?
# 2. `camera_link` 기준인 점이 있습니다. 어떤 호출이 그 점을 `base_link` 기준으로 바꿀까요?
#
# <details><summary>답과 함정</summary>
#
# 1. 부모인 `base_link`입니다. 거기서 앞으로 10 cm, 위로 30 cm인 곳에 카메라가 있습니다.
# 2. `lookup_transform('base_link', 'camera_link', t)`입니다. 기준이 될 좌표계(목표)가 먼저, 지금 기준(원본)이 다음입니다. 답은 발행된 변환 그대로입니다.
#
# 함정은 화살표입니다. 화살표는 부모에서 자식을 가리키며, 누가 누구에게 달려 있는지를 나타냅니다.
# 이것을 데이터가 바뀌는 방향으로 읽으면 호출을 거꾸로 쓰게 됩니다.
#
# </details>

# %% [markdown] lang="en" name="the-sentence-panel-why-heading" slide="subslide"
# ## A panel: the sentence, the call and the matrix

# %% [markdown] lang="ko" name="the-sentence-panel-why-heading" slide="subslide"
# ## 패널: 문장, 호출, 행렬

# %% [markdown] lang="en" name="the-sentence-panel-why"
# You can choose the two frames in any of the forms below. The other forms show the same choice.
# On the right is the same transform as a matrix: the first three columns are the rotation, the last one is the translation.
# Find a pair for which the matrix and its inverse (target and source swapped) differ in only one sign.

# %% [markdown] lang="ko" name="the-sentence-panel-why"
# 메뉴에서 좌표계를 고르면 문장과 호출과 행렬이 함께 바뀝니다.
# 오른쪽은 같은 변환을 표로 적은 행렬입니다. 앞의 세 열은 회전이고, 마지막 열은 이동입니다.
# *그림 읽기:* data expressed in [A], wanted in [B] = A 기준으로 표현된 데이터를 B 기준으로 보고 싶다, source = 원본, target = 목표.
# 목표와 원본을 맞바꾸어도 행렬의 부호가 하나만 달라지는 두 좌표계가 있습니다. 어느 것인지 찾아보세요.

# %% name="the-sentence-panel" tags=["interactive", "collapsed"]
# Show the panel.
lesson.sentence_panel(
    {
        'base_link': Transform(),
        'laser_frame': base_T_laser,
        'rear_laser': Transform.from_rpy(yaw=math.pi, translation=(-0.20, 0.0, 0.15)),
    },
    'base_link',
    'laser_frame',
)

# %% name="the-sentence-still" tags=["static"]
from tflab.core import LATEST

lesson.draw_sentence({'base_link': Transform(), 'laser_frame': base_T_laser},
                     buffer.core.lookup_transform('base_link', 'laser_frame', LATEST))

# %% [markdown] lang="en" name="the-sentence-panel-answer" slide="skip"
# <details><summary>A pair with only one sign of difference</summary>
#
# `base_link` and `rear_laser`, a laser at the back that is rotated by 180°.
# Its matrix and the inverse differ only in the sign of z.
# It is the laser of the team whose tests all passed.
#
# </details>

# %% [markdown] lang="ko" name="the-sentence-panel-answer" slide="skip"
# <details><summary>부호 하나만 다른 쌍</summary>
#
# `base_link`와 `rear_laser`입니다. 뒤쪽에 180° 회전시켜 단 레이저입니다.
# 목표와 원본을 맞바꾸면 행렬에서 이동의 z만 부호가 달라집니다.
# 앞에서 시험을 모두 통과한 팀의 레이저가 바로 이렇게 달려 있었습니다.
#
# </details>

# %% [markdown] lang="en" name="up-up-down-heading" slide="slide"
# ## Two sensors: the laser in the camera's frame

# %% [markdown] lang="ko" name="up-up-down-heading" slide="slide"
# ## 센서 두 개: 카메라 기준의 레이저

# %% [markdown] lang="en" name="up-up-down"
# No node publishes the pose of the laser in the camera's frame.
# They are siblings: `base_link` is the parent of both.
# You can still look it up, because a lookup walks the tree: **up** from the source to the nearest frame above both, then **down** to the target.
# On the way up it uses the transforms as published. On the way down it uses their inverses.

# %% [markdown] lang="ko" name="up-up-down"
# 카메라 기준으로 레이저가 어디에 있는지 발행한 노드는 없습니다.
# 둘은 형제 좌표계입니다. 부모가 모두 `base_link`입니다.
# 그래도 조회할 수 있습니다. 조회(lookup)가 트리를 따라가기 때문입니다. 원본에서 둘이 만나는 좌표계까지 **올라가고**, 거기서 목표까지 **내려갑니다**.
# 올라갈 때는 발행된 변환을 그대로 쓰고, 내려갈 때는 역변환을 씁니다.

# %% [markdown] lang="en" name="up-up-down-notes" slide="notes"
# Walk the tree with a finger: going up say "as published", going down say "inverse". Then ask for map in laser_frame: how many are inverted? All of them.

# %% [markdown] lang="ko" name="up-up-down-notes" slide="notes"
# 손가락으로 트리를 따라갑니다. 올라갈 때는 “발행된 그대로”, 내려갈 때는 “역변환”이라고 말합니다. 그다음 laser_frame 기준의 map을 묻습니다. 역변환이 몇 개입니까? 전부입니다.

# %% name="siblings"
camera_T_laser = look_up('base_link', 'camera_link').inverse() @ base_T_laser

print('down after up ', lesson.fmt_all(camera_T_laser.translation))
print('one lookup    ', lesson.fmt_all(look_up('camera_link', 'laser_frame').translation))

# %% name="siblings-as-dominoes" tags=["collapsed"]
# Draw the dominoes.
lesson.draw_dominoes(('camera_link', 'base_link'), ('base_link', 'laser_frame'))

# %% [markdown] lang="en" name="siblings-seen"
# The laser is 10 cm in front of the camera and 15 cm below it. Check that with the numbers of both mounts.
# The domino `camera_link | base_link` is the inverse of the published `base_link | camera_link`.

# %% [markdown] lang="ko" name="siblings-seen"
# 레이저는 카메라보다 10 cm 앞, 15 cm 아래에 있습니다. 두 센서의 장착 위치로 확인해 보세요.
# 조각 `camera_link | base_link`는 발행된 `base_link | camera_link`의 역변환입니다.

# %% [markdown] lang="en" name="try-it-heading" slide="slide"
# ## A slider: rotate the mount and watch two mistakes

# %% [markdown] lang="ko" name="try-it-heading" slide="slide"
# ## 슬라이더: 레이저를 회전시키며 두 가지 실수 보기

# %% [markdown] lang="en" name="try-it"
# 1. At which yaw does "rotation left out" make no difference?
# 2. At which yaw do you not see "swapped" from above? Look at z as well.
# 3. At which yaw is the error of the swap largest?

# %% [markdown] lang="ko" name="try-it"
# 1. “rotation left out”(회전을 빠뜨림)은 yaw가 얼마일 때 정답과 겹쳐 보일까요?
# 2. 위에서 볼 때 “swapped”(바꿔 씀)는 yaw가 얼마일 때 정답과 겹쳐 보일까요? z도 살펴보세요.
# 3. yaw가 얼마일 때 바꿔 쓴 실수가 가장 크게 드러날까요?
#
# *그림 읽기:* from above, grid of 0.5 m = 위에서 본 모습, 눈금 한 칸이 0.5미터. corner = 모서리, yaw of the mount = 장착 yaw, as measured = 잰 그대로, off by = 빗나간 거리.

# %% name="try-it-panel" tags=["interactive", "collapsed"]
# Show the slider.
lesson.mount_panel()

# %% name="try-it-still" tags=["static"]
lesson.draw_mount(math.pi / 2)

# %% [markdown] lang="en" name="try-it-answers"
# <details><summary>What I found</summary>
#
# 1. At yaw 0, because there is no rotation that you could leave out.
# 2. At ±π, with a laser that faces backwards. From above the swap cannot be seen, and z is off by 0.30 m, which a flat 2D scan does not show.
# 3. Near ±π/2, by 3.8 m here: the corner is on the other side of the robot.
#
# </details>

# %% [markdown] lang="ko" name="try-it-answers"
# <details><summary>찾은 것 확인하기</summary>
#
# 1. yaw가 0일 때입니다. 회전이 없으면 빠뜨릴 것도 없습니다.
# 2. ±π, 즉 뒤를 보는 레이저입니다. 위에서 보면 전혀 드러나지 않습니다. z는 0.30 m 틀리지만 평면 2D 스캔에는 보이지 않습니다.
# 3. ±π/2 근처입니다. 여기서는 3.8 m나 빗나가서, 모서리가 로봇 반대편에 나타납니다.
#
# </details>

# %% [markdown] lang="en" name="try-it-notes" slide="notes"
# Let a student move the slider. The class calls "stop" when a wrong position coincides with the right one. Then ask what a test at that angle would have found.

# %% [markdown] lang="ko" name="try-it-notes" slide="notes"
# 한 사람이 슬라이더를 움직이고, 잘못된 답이 정답과 겹치는 순간 모두가 “멈춰”라고 외칩니다. 그 각도에서 시험했다면 무엇을 찾았겠는지 묻습니다.

# %% [markdown] lang="en" name="unknown-name-why-heading" slide="subslide"
# ## An unknown frame name, and a leading slash

# %% [markdown] lang="ko" name="unknown-name-why-heading" slide="subslide"
# ## 없는 좌표계 이름, 앞에 붙은 슬래시

# %% [markdown] lang="en" name="unknown-name-why"
# An unknown frame name raises an exception. Its message contains the argument in which you used the name.
# (`%xmode Minimal` shows only the last line of an error, the one to read. `%xmode Context` shows the rest again.)

# %% [markdown] lang="ko" name="unknown-name-why"
# 버퍼에 없는 이름을 쓰면 오류가 납니다. 그 이름을 어떤 인자로 썼는지도 메시지에 나옵니다.
# (`%xmode Minimal`은 오류에서 꼭 읽어야 할 마지막 줄만 보여 줍니다. `%xmode Context`로 되돌립니다.)

# %% name="unknown-name" tags=["raises-exception"]
# %xmode Minimal
buffer.lookup_transform('laser_fame', 'base_link', Time())

# %% [markdown] lang="en" name="unknown-name-seen"
# `argument target_frame`: you passed the misspelt name as the target.
# If you meant it as the *source*, this message is the only hint at a swap that you ever get. Read it to the end.
#
# A name that begins with a slash, common in ROS 1, cannot be looked up at all:

# %% [markdown] lang="ko" name="unknown-name-seen"
# `argument target_frame`, 즉 철자가 틀린 이름이 목표 자리에 있다는 뜻입니다.
# 이 이름을 *원본*으로 쓰려고 했다면, 두 인자를 바꿔 쓴 것입니다. 그것을 알려 주는 것은 이 한 줄뿐이므로 끝까지 읽으십시오.
#
# 그리고 ROS 1에서 흔히 쓰던, 슬래시로 시작하는 이름은 조회에 쓸 수 없습니다.

# %% name="leading-slash" tags=["raises-exception"]
buffer.lookup_transform('/base_link', 'laser_frame', Time())

# %% [markdown] lang="en" name="from-before-heading" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before"
# 1. A message contains `(2.0, 0.0, 0.0)` and an empty `frame_id`. May you use it?
# 2. A wheeled robot turns right. Is its yaw rate positive or negative?
# 3. Which quaternion (x, y, z, w) means "no rotation", and what does TF2 do with (0, 0, 0, 0)?
#
# <details><summary>Answers</summary>
#
# 1. No: without a frame you do not know where the point is. Reject it, and log a warning.
# 2. Negative: z points up, and by the right-hand rule a positive yaw rate turns left.
# 3. (0, 0, 0, 1). Four zeros are not a valid rotation: each listener rejects the transform, and the frame never appears.
#
# </details>

# %% [markdown] lang="ko" name="from-before"
# 1. 어떤 메시지에 `(2.0, 0.0, 0.0)`이 들어 있고 `frame_id`는 비어 있습니다. 써도 됩니까?
# 2. 바퀴 달린 로봇이 오른쪽으로 회전합니다. yaw 속도는 양수입니까, 음수입니까?
# 3. “회전 없음”을 뜻하는 쿼터니언(x, y, z, w)은 무엇이고, (0, 0, 0, 0)을 받으면 TF2는 어떻게 합니까?
#
# <details><summary>답</summary>
#
# 1. 안 됩니다. 좌표계 없는 값에는 아무 뜻이 없습니다. 거절하고 로그에 남깁니다.
# 2. 음수입니다. z가 위를 향하므로 오른손 법칙에 따라 양의 회전은 왼쪽입니다.
# 3. (0, 0, 0, 1)입니다. 모두 0인 것은 회전이 아닙니다. 수신기마다 거절하고, 그 좌표계는 끝내 나타나지 않습니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice question · Q3

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제 · Q3

# %% [markdown] lang="en" name="practice"
# Explain the parent and the child of a transform, and what `lookup_transform(target, source, time)` returns.
# Write four or five sentences, then open the list and give yourself a point for each idea.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] A transform gives the position and rotation of the child frame, measured in the parent.
# - [ ] In the message, the parent is `header.frame_id` and the child is `child_frame_id`.
# - [ ] The lookup returns the transform that takes data expressed in *source* into *target*.
# - [ ] Target and source need not be parent and child. They can be any two frames of one tree, and the lookup follows the path between them.
# - [ ] `time` is the time of the transform. `Time()` means the latest time for which all edges on the path have data.
# - [ ] If you swap the two, you get the inverse and no error. With a rotation, the inverse differs in more than the sign.
#
# Five or six: you could teach it. Three or four: read "One transform, read twice" again. Fewer: do the predictions again, with a pencil.
#
# </details>

# %% [markdown] lang="ko" name="practice"
# 변환의 부모와 자식, 그리고 `lookup_transform(target, source, time)`의 의미를 설명하십시오.
# 네다섯 문장으로 쓴 다음, 목록을 펼쳐 스스로 채점해 보세요. 아래 내용이 하나 들어 있을 때마다 1점입니다.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 변환은 부모 기준으로 잰 자식 좌표계의 위치와 회전입니다.
# - [ ] 메시지에서 부모는 `header.frame_id`, 자식은 `child_frame_id`입니다.
# - [ ] 조회는 *원본* 기준 데이터를 *목표* 기준으로 바꾸는 변환을 반환합니다.
# - [ ] 목표와 원본이 꼭 부모와 자식일 필요는 없습니다. 한 트리 안의 어떤 두 좌표계라도 되고, 조회가 그 사이의 경로를 따라갑니다.
# - [ ] `time`은 어느 시각의 변환인지를 정합니다. `Time()`은 경로의 모든 연결에 값이 있는 가장 최근 시각입니다.
# - [ ] 둘을 바꿔 쓰면 역변환이 나올 뿐 오류는 나지 않습니다. 회전이 있으면 부호만 다른 것이 아닙니다.
#
# 다섯 개 이상이면 남을 가르칠 수 있습니다. 서너 개면 “변환 하나, 두 가지 읽기”를 다시 읽으십시오. 그보다 적으면 예측부터 다시 해 보십시오.
#
# </details>
