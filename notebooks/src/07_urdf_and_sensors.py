# %% [markdown] lang="en" name="title" slide="slide"
# # 07 · URDF and sensors
#
# **The description and the real mount** · about 35 minutes · builds on 02 and 06
#
# After this chapter you can
#
# - read a joint of a [[urdf|URDF]]: its origin and its axis, and in which axes each is given,
# - calculate the position of an arm's tip, transform by transform,
# - say which frames `robot_state_publisher` publishes, on which topic, and why some are missing,
# - recognise a sensor whose mount differs from the URDF: rotated, tilted, upside down.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 07 · URDF와 센서
#
# **도면과 실제 장착** · 약 35분 · 02, 06장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - [[urdf|URDF]]의 관절 하나를 읽고, origin과 axis가 각각 어느 좌표계의 축으로 적히는지 말할 수 있습니다.
# - 로봇 팔 끝의 위치를 변환을 하나씩 합성해 계산할 수 있습니다.
# - `robot_state_publisher`가 어떤 좌표계를 어느 토픽으로 발행하는지, 왜 일부가 빠지는지 설명할 수 있습니다.
# - 도면과 다르게 달린 센서(회전한 것, 기울어진 것, 뒤집힌 것)를 알아볼 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# One sentence for this chapter: a URDF is a claim about the mounts, and TF repeats it without checking. Ask: how would you notice that a laser is rotated by 90 degrees? Collect answers; somebody will say "RViz shows an error".

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 이 장의 핵심은 한 문장입니다. URDF에는 도면에 적힌 값이 있을 뿐이고, TF는 확인하지 않고 그대로 전달합니다. 먼저 묻습니다. 레이저가 90° 회전해 있다면 어떻게 알아챌까요? “RViz에 오류가 납니다”라는 답이 나올 것입니다.

# %% name="load" slide="skip"
# %load_ext tflab
import math

from tflab.core import Transform, seconds
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## The line that rotated nothing
#
# A new lidar is mounted on its robot at another angle than the old one. Somebody opens the robot's URDF, the file that describes where its parts are, and writes `rpy="0 0 1.57"`: 90°.
# Nothing happens. They ask for help. Two years later the question is closed, unanswered (cartographer_ros #1017).
# The line was in the `<visual>`, which only describes how a part looks. And the shape was a cylinder, rotated about its own axis: not even the picture could change.
#
# Another robot published its yaw rate with the wrong sign *on every run it had ever done*. Its wheels reported left, its gyro (the sensor of the rotation rate) reported right. The wheels were blamed, twice (fusioncore #88).

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 아무것도 회전시키지 못한 한 줄
#
# 어느 사용자가 새 라이다를 달았는데 예전 것과 각도가 달랐습니다. 그래서 부품의 위치를 적은 파일인 URDF를 열어 `rpy="0 0 1.57"`이라고 썼습니다. 90°입니다.
# 아무 일도 일어나지 않았습니다. 도움을 청한 질문은 2년 뒤 답 없이 닫혔습니다([cartographer_ros, 이슈 1017](https://github.com/cartographer-project/cartographer_ros/issues/1017)).
#
# 그 줄은 `<visual>`, 곧 겉모습에 적혀 있었습니다. 게다가 그 겉모습은 원기둥이었고 자기 축을 중심으로 회전시켰으니, 그림조차 달라질 수 없었습니다.
#
# 또 다른 로봇은 *그때까지의 모든 주행에서* 회전을 반대 부호로 발행했습니다. 오도메트리는 왼쪽 회전을, 자이로(회전 속도를 재는 센서)는 오른쪽 회전을 보고했습니다. 사람들은 두 번이나 오도메트리를 의심했습니다([fusioncore, 이슈 88](https://github.com/manankharwar/fusioncore/issues/88)).

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* cartographer_ros [1017](https://github.com/cartographer-project/cartographer_ros/issues/1017); fusioncore [88](https://github.com/manankharwar/fusioncore/issues/88). (There the driver counted clockwise, like a compass; an IMU mounted upside down has the same effect.) [URDF's rules for a joint](http://wiki.ros.org/urdf/XML/joint).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* cartographer_ros [1017](https://github.com/cartographer-project/cartographer_ros/issues/1017), fusioncore [88](https://github.com/manankharwar/fusioncore/issues/88). (이 로봇에서는 드라이버가 나침반처럼 시계 방향을 양수로 셌습니다. IMU를 뒤집어 달아도 같은 일이 생깁니다.) [URDF의 관절 규칙](http://wiki.ros.org/urdf/XML/joint).

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# 1. Our robot's laser is really rotated to the left by 90°, and that line is in its `<visual>`. **How far off** are the walls on the map: centimetres, or metres?
# 2. `robot_state_publisher` runs, and no node publishes joint positions. **Which frames are missing?** None, all, or some?
# 3. A laser looks down by 3° in a room of 10 m. **What does the map show?**
# 4. An IMU is mounted upside down, and the robot turns **left**. What is the sign of z of its gyro?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 1. 우리 로봇의 레이저가 실제로 왼쪽으로 90° 회전해 있고, 그 줄은 `<visual>`에 적혀 있습니다. 지도에서 벽은 **얼마나 어긋날까요?** 센티미터일까요, 미터일까요?
# 2. `robot_state_publisher`는 실행 중이지만 관절 값을 발행하는 노드가 없습니다. **어떤 좌표계가 빠질까요?** 하나도 빠지지 않을까요, 모두 빠질까요, 일부만 빠질까요?
# 3. 10 m 길이의 방에서 레이저가 아래로 3° 기울어 있습니다. **지도에는 무엇이 보일까요?**
# 4. IMU를 뒤집어 달았는데 로봇이 **왼쪽**으로 회전합니다. 자이로 z의 부호는 무엇일까요?

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Hands for each. For 1, the common answer is "at least the picture rotates". For 2, "all, at zero". For 3, somebody will compute a cosine: walls 0.14 % too far. All three are good mistakes.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 하나씩 손을 들게 합니다. 나올 법한 오답은 1번에서는 “그림은 회전한다”, 2번에서는 “모두 0의 자리에 나온다”, 3번에서는 코사인을 계산한 “벽이 0.14 % 멀어진다”입니다. 모두 배울 것이 있는 실수입니다.

# %% name="my-guess" slide="skip"
walls_off, missing, tilted_map, gyro_z = ..., ..., ..., ...

# %% [markdown] lang="en" name="two-origins" slide="slide"
# ## Two origins
#
# A URDF has [[link|links]], the rigid parts, and [[joint|joints]], which connect a link to its parent. Each link is a [[frame]]; each joint is one [[transform]], parent to child. This is the lecture's whole robot. (`parse_urdf` reads it, and `link_poses` returns the pose of each link in the root link.)

# %% [markdown] lang="ko" name="two-origins" slide="slide"
# ## 두 가지 origin
#
# URDF에는 단단한 부품인 [[link|링크(link)]]와, 링크가 다른 링크에 어떻게 달려 있는지 적은 [[joint|관절(joint)]]이 있습니다. 링크마다 [[frame|좌표계]]가 하나씩 있고, 관절은 부모를 기준으로 자식의 자리를 적은 [[transform|변환]] 하나입니다. 다음은 강의에 나온 로봇의 URDF 전체입니다. (`parse_urdf`는 이것을 읽고, `link_poses`는 루트 기준으로 각 링크가 어디에 있는지 구합니다.)

# %% name="lecture-urdf" slide="-"
LECTURE = """<robot name="tf_lab_robot">
  <link name="base_link"/>
  <link name="laser_frame"/>
  <joint name="base_to_laser" type="fixed">
    <parent link="base_link"/>
    <child link="laser_frame"/>
    <origin xyz="0.20 0.0 0.15" rpy="0.0 0.0 0.0"/>
  </joint>
</robot>"""
base_T_laser = lesson.link_poses(lesson.parse_urdf(LECTURE))['laser_frame']
print('base_T_laser', lesson.fmt_all(base_T_laser.translation), 'rpy', lesson.fmt_all(base_T_laser.rpy(), 'rad'))

# %% [markdown] lang="en" name="two-origins-why"
# Read it aloud: *the laser is a child of `base_link`, 0.20 ahead and 0.15 up, not rotated.* That is `base_T_laser`: `xyz` is its translation [m], `rpy` its rotation [rad].
# Our own robot's URDF has these lines among others.
#
# A link can have a `<visual>` with an `<origin>` of its own. It describes the position of the *shape* on the link. TF never reads it.
#
# In the next cells the real laser is rotated to the left by 90°. The line is written in one of two places:
#
# ```xml
# <!-- in the link's <visual> -->
# <visual> <origin rpy="0 0 1.5708"/> <geometry>...</geometry> </visual>
#
# <!-- in the <joint> -->
# <origin xyz="0.20 0.0 0.15" rpy="0 0 1.5708"/>
# ```

# %% [markdown] lang="ko" name="two-origins-why"
# 소리 내어 읽어 보세요. *레이저는 `base_link`에 달려 있고, 앞으로 0.20, 위로 0.15이며, 회전은 없다.* 이것이 `base_T_laser`입니다. `xyz`는 이동[m], `rpy`는 회전[rad]입니다.
# 우리 로봇의 URDF에도 이 줄들이 있습니다.
#
# 링크에는 `<visual>`이 있을 수 있고, 그 안에도 `<origin>`이 있습니다. 이것은 *겉모습*이 링크의 어디에 그려지는지를 적은 것입니다. TF는 읽지 않습니다.
#
# 다음 셀들에서는 레이저를 실제로 왼쪽으로 90° 회전시켜 답니다. 그 줄을 두 곳 가운데 한 곳에 적습니다.
#
# ```xml
# <!-- in the link's <visual> -->
# <visual> <origin rpy="0 0 1.5708"/> <geometry>...</geometry> </visual>
#
# <!-- in the <joint> -->
# <origin xyz="0.20 0.0 0.15" rpy="0 0 1.5708"/>
# ```

# %% name="write-the-line" tags=["collapsed"] slide="fragment"
# Write the line in <visual>, and in <joint>.
URDF = lesson.teaching_urdf()
QUARTER = 'rpy="0 0 1.5707963267948966"'
paint = '<geometry><cylinder radius="0.04"'
in_visual = URDF.replace(paint, f'<origin {QUARTER}/> {paint}')
in_joint = URDF.replace('xyz="0.20 0.0 0.15" rpy="0.0 0.0 0.0"', f'xyz="0.20 0.0 0.15" {QUARTER}')
truly = {'laser_frame': Transform.from_rpy(yaw=math.pi / 2, translation=(0.20, 0.0, 0.15))}

# %% name="where-the-walls-are" tags=["predicted", "collapsed"] slide="subslide"
# Draw the map for each URDF.
placed = {}
for name, urdf in {'nothing written': URDF, 'in <visual>': in_visual, 'in <joint>': in_joint}.items():
    robot = lesson.TeachingRobot(urdf=urdf, screws=truly)
    placed[name] = lesson.scan_on_map(robot, at_s=1.0)
lesson.draw_placed(placed, walls=lesson.ROOM.walls)

# %% [markdown] lang="en" name="walls-seen" tags=["predicted"]
# From above: the walls are grey, and the dots are where the robot's TF places what its laser measured. They are one and a half metres off on average, almost five at worst, and the line in `<visual>` changes not one dot.
# In the `<joint>` the same line puts every dot on the walls, except for the laser's own noise of millimetres.
# No tool compares the description with the real mount. *You* have to, with an object that you know to be straight ahead.

# %% [markdown] lang="ko" name="walls-seen" tags=["predicted"]
# *그림 읽기:* 위에서 본 모습입니다. 회색은 벽, 점은 TF가 레이저의 측정값을 놓은 자리입니다. nothing written = 아무것도 쓰지 않음, off by = 어긋난 거리, on average = 평균, at worst = 최대.
#
# 평균 1.5미터, 최대 5미터 가까이 어긋납니다. `<visual>`에 쓴 줄은 점 하나도 바꾸지 못했습니다. 관절에 쓰면 레이저의 잡음 몇 밀리미터만 남고 모두 맞습니다.
#
# 아무 오류도 나지 않았습니다. 도면과 실제 장착을 비교해 주는 도구는 없습니다. 로봇의 정면에 물체를 놓고 *여러분이* 비교해야 합니다.

# %% [markdown] lang="en" name="walls-notes" slide="notes"
# Stay here until somebody says why the middle picture is no better than the left one. Then ask who in the class has a URDF with a sensor that was moved since.

# %% [markdown] lang="ko" name="walls-notes" slide="notes"
# 가운데 그림이 왼쪽 그림보다 나을 것이 없는 이유가 나올 때까지 기다립니다. 그다음 묻습니다. 센서를 옮긴 뒤 URDF를 고치지 않은 로봇이 있습니까?

# %% name="laser-and-ghost" tags=["collapsed"] slide="subslide"
# Draw the frames of TF, and the real laser.
poses = lesson.link_poses(lesson.parse_urdf(in_visual))
axes = {name: poses[name] for name in ('base_link', 'laser_frame')}
real = Transform((0.0, 0.0, 0.2)) @ poses['base_link'] @ truly['laser_frame']  # higher, so that both can be seen
ghosts = {'the real laser (drawn 0.2 m higher)': real}
lesson.draw_scene(axes, ghosts=ghosts, fixed_frame='base_footprint', length_m=0.1)

# %% [markdown] lang="en" name="small-mistakes"
# In colour, the frames that TF has. In grey, the laser as it is really mounted: its x axis points to the left.
#
# Smaller errors are harder to see. A laser that is described 0.20 m behind its true position puts the walls 0.08 m off on average. `1.57` for 90° is short by 0.0456°: 8 mm at 10 m. Write `1.5708`, or more digits.

# %% [markdown] lang="ko" name="small-mistakes"
# *그림 읽기:* 색이 있는 축은 TF에 있는 좌표계이고, 기울임꼴 회색(the real laser)은 실제로 달린 레이저입니다(drawn 0.2 m higher = 둘 다 보이도록 0.2 m 위에 그렸습니다). 실제 레이저의 x축은 왼쪽을 향합니다.
#
# 작은 오차는 더 알아채기 어렵습니다. URDF에 레이저를 실제보다 0.20 m 뒤에 적으면 벽이 평균 0.08 m 어긋납니다. 90°를 `1.57`로 적으면 0.0456° 모자라고, 10 m 앞에서 8 mm 어긋납니다. `1.5708`이나 더 긴 숫자를 쓰십시오.

# %% [markdown] lang="en" name="axis" slide="slide"
# ## A joint: an origin, then a movement
#
# A joint that moves has an `<axis>`. It is given in the **child's** axes, which the origin has already rotated: `parent_T_child = origin @ movement`.
# A camera head is mounted facing left, `rpy="0 0 1.5708"`, and its axis is `0 1 0`. The motor rotates by +0.5 rad. **Predict:** does the head nod or does it roll?

# %% [markdown] lang="ko" name="axis" slide="slide"
# ## 관절: origin 다음에 움직임
#
# 움직이는 관절에는 `<axis>`가 있습니다. axis는 origin을 적용한 뒤의 **자식** 좌표계의 축으로 적습니다. `parent_T_child = origin @ movement`입니다.
#
# 카메라 머리가 왼쪽을 보도록 달려 있고(`rpy="0 0 1.5708"`) 축은 `0 1 0`입니다. 모터가 +0.5 rad 회전합니다. **예측해 봅시다.** 고개를 끄덕일까요, 옆으로 갸웃할까요?

# %% name="neck"
NECK = """<robot name="neck"> <link name="body"/> <link name="head"/>
  <joint name="neck" type="revolute">
    <parent link="body"/> <child link="head"/>
    <origin xyz="0 0 0" rpy="0 0 1.5707963267948966"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint> </robot>"""
origin, movement = Transform.from_rpy(yaw=math.pi / 2), Transform.from_rpy(pitch=0.5)

# %% name="nod-or-roll" tags=["predicted"] slide="fragment"
head = lesson.link_poses(lesson.parse_urdf(NECK), {'neck': 0.5})['head']
misread = movement @ origin
nose = (1.0, 0.0, 0.0)  # a metre ahead of the head
print('origin @ movement: the nose is at', lesson.fmt_all(head.apply(nose)))
print('movement @ origin: the nose is at', lesson.fmt_all(misread.apply(nose)))

# %% name="nod-or-roll-drawn" tags=["predicted", "collapsed"] slide="fragment"
# Draw both heads.
aside = Transform((1.9, -0.3, 0.0)) @ misread  # beside the other one, so that both can be seen
noses = {'nose, 0.48 m lower': head.apply(nose), 'nose, not lower': aside.apply(nose)}
lesson.draw_scene({'head': head, 'head, misread': aside}, noses, fixed_frame='body', length_m=0.6)

# %% [markdown] lang="en" name="axis-seen" tags=["predicted"]
# It nods. The head faces the left of the body, and its nose goes down there to z = −0.479. (The misread head is drawn beside it.) If you read the axis in the parent's axes, the head rolls, and its nose stays where it was.
#
# A TurtleBot3's wheels are written like this: `rpy="-1.57 0 0"` rotates the axes, and then `axis="0 0 1"` points sideways.
#
# Two more facts about the same lines. A URDF has no degrees: `rpy="0 0 90"` is 90 rad, fourteen full rotations and 116.62°. And rpy rotates about the fixed axes of the parent, roll first, as in chapter 02.

# %% [markdown] lang="ko" name="axis-seen" tags=["predicted"]
# *그림 읽기:* head = 머리, nose, 0.48 m lower = 0.48 m 내려간 코, misread = 축을 잘못 읽은 경우(둘 다 보이도록 옆에 그렸습니다), not lower = 내려가지 않음.
#
# 끄덕입니다. 머리가 보는 방향인 왼쪽에서 코가 z = −0.479까지 내려갑니다. 축을 부모의 축으로 읽으면 머리가 옆으로 갸웃하고 코는 제자리입니다.
# TurtleBot3의 바퀴가 이렇게 적혀 있습니다. `rpy="-1.57 0 0"`으로 좌표계를 눕히면 `axis="0 0 1"`이 옆을 향합니다.
#
# 두 가지를 더 조심하십시오. URDF에는 도(degree)가 없습니다. `rpy="0 0 90"`은 90 rad이고, 열네 번 회전하고도 116.62°를 더 회전합니다. rpy는 02장에서처럼 부모의 고정된 축을 중심으로 roll부터 회전합니다.

# %% [markdown] lang="en" name="chain" slide="slide"
# ## A chain of joints
#
# `base_link`, `shoulder`, `elbow`, `wrist`, `tool0`, `tcp`: each joint is one transform, and the pose of the tip is their product. (This is called [[forward kinematics]].) The figure draws each transform as a domino, with a ring if the joint moves. At the bottom is the URDF of the joint with the thick border. Move a slider: which transforms change?

# %% [markdown] lang="ko" name="chain" slide="slide"
# ## 사슬: 경첩이 달린 도미노
#
# `base_link`, `shoulder`, `elbow`, `wrist`, `tool0`, `tcp`. 그림에서는 관절 하나의 변환을 도미노 하나로 그립니다. 이 변환을 모두 합성하면 팔 끝의 포즈가 나옵니다. (이 계산을 [[forward kinematics|정기구학(forward kinematics)]]이라고 합니다.) 슬라이더를 움직여 보세요. 어느 도미노의 숫자가 바뀔까요?

# %% name="arm-panel" tags=["interactive", "collapsed"]
# Show the arm.
lesson.joints_panel()

# %% name="arm-still" tags=["static"]
at = {'shoulder_joint': 0.5, 'elbow_joint': -0.6, 'wrist_joint': 0.4}
poses = lesson.link_poses(lesson.parse_urdf(URDF), at)
x, y, z = (poses['base_link'].inverse() @ poses['tool0']).translation
lesson.draw_joints(at, touched='elbow_joint', ghosts={'0.12 added to z': (x, y, z + 0.12)})

# %% [markdown] lang="en" name="chain-seen" slide="subslide"
# - A joint changes one transform, its own. The tip moves because the product changes.
# - The fixed joints are transforms, too, without a slider.
# - [[tcp|`tcp`]] (tool centre point) is the working point of the tool. It is 0.12 m beyond `tool0`, the end of the arm. It is a **frame of its own**, offset along the tool's z. If you change the tool, only this transform changes. If you add 0.12 to the z in `base_link` instead, you get the grey ring, 15 cm off.
#
# Zero is a position like any other: at zero the tip is at (0.470, 0, 0.150).

# %% [markdown] lang="ko" name="chain-seen" slide="subslide"
# *그림 읽기:* from above = 위에서, from the side = 옆에서, fixed = 고정. 둥근 고리가 있는 도미노가 움직이는 관절이고, 아래는 굵은 테두리 관절의 URDF입니다. 회색 고리는 0.12를 z에 더한 경우입니다.
#
# - 관절은 자기 도미노 하나만 바꿉니다. 그래서 합성한 변환이 바뀌고 팔 끝이 움직입니다.
# - 고정된 관절에도 숫자는 있습니다. 경첩만 없습니다.
# - [[tcp|`tcp`]](tool centre point)는 공구의 작업점이고, 팔이 끝나는 `tool0`에서 공구의 z축을 따라 0.12 m 더 나간 곳입니다. **따로 둔 좌표계**이므로, 공구를 바꾸면 도미노 하나만 바뀝니다. `base_link`의 z에 0.12를 더하면 15 cm 옆의 회색 고리로 갑니다.
#
# 관절 값 0은 특별한 위치가 아닙니다. 모두 0이면 팔 끝은 (0.470, 0, 0.150)에 있습니다.

# %% [markdown] lang="en" name="chain-notes" slide="notes"
# Let somebody call out a joint and everybody say which transforms will change, before you move the slider. It is always one.

# %% [markdown] lang="ko" name="chain-notes" slide="notes"
# 누군가 관절 이름을 부르게 하고, 슬라이더를 움직이기 전에 어느 도미노가 바뀔지 모두 말하게 합니다. 언제나 하나입니다.

# %% [markdown] lang="en" name="faded" slide="subslide"
# ### Now you write
#
# A camera is a child of `base_link`, 10 cm ahead, 12 cm to its right, 30 cm up, and faces 20° to the left. Fill in the four blanks. The second joint adds the optical frame, rotated as in chapter 02.
#
# ```xml
# <joint name="base_to_camera" type="fixed">
#   <parent link="____________"/> <child link="camera_link"/>
#   <origin xyz="____________" rpy="____________"/>
# </joint>
# <joint name="camera_to_optical" type="fixed">
#   <parent link="camera_link"/> <child link="camera_optical_frame"/>
#   <origin rpy="____________"/>
# </joint>
# ```
#
# <details><summary>Compare</summary>
#
# `base_link` · `0.10 -0.12 0.30` (right is −y) · `0 0 0.3491` (left is positive, 20° in radians) · `-1.5708 0 -1.5708`.
# The camera's own rotation is in the first joint, the rotation of the axes in the second, each once.
#
# </details>

# %% [markdown] lang="ko" name="faded" slide="subslide"
# ### 빈칸을 채워 보세요
#
# 카메라가 `base_link`에 달려 있습니다. 앞으로 10 cm, 오른쪽으로 12 cm, 위로 30 cm이고 왼쪽으로 20°를 봅니다. 빈칸 네 개를 채워 보세요. 둘째 관절은 광학 좌표계이며, 02장에서처럼 회전합니다.
#
# ```xml
# <joint name="base_to_camera" type="fixed">
#   <parent link="____________"/> <child link="camera_link"/>
#   <origin xyz="____________" rpy="____________"/>
# </joint>
# <joint name="camera_to_optical" type="fixed">
#   <parent link="camera_link"/> <child link="camera_optical_frame"/>
#   <origin rpy="____________"/>
# </joint>
# ```
#
# <details><summary>맞춰 보기</summary>
#
# `base_link` · `0.10 -0.12 0.30`(오른쪽은 −y) · `0 0 0.3491`(왼쪽이 양수, 20°를 라디안으로) · `-1.5708 0 -1.5708`.
# 카메라의 회전은 첫 관절에, 축의 방향이 다른 것은 둘째 관절에, 각각 한 번만 적습니다.
#
# </details>

# %% [markdown] lang="en" name="publisher" slide="slide"
# ## Which node publishes the frames
#
# [[robot_state_publisher]] reads the URDF. It publishes fixed joints on `/tf_static`, once, also for listeners that join later (chapter 06).
# For a joint that moves it needs a position. It waits for messages on `/joint_states`, which a joint driver publishes. Then it publishes on `/tf` the joints that a message **names**, and no others.
#
# Here it runs alone. No node publishes joint positions. What do you expect of the arm?

# %% [markdown] lang="ko" name="publisher" slide="slide"
# ## 어느 노드가 좌표계를 발행할까요?
#
# [[robot_state_publisher|`robot_state_publisher`]]가 URDF를 읽습니다. 고정된 관절은 `/tf_static`으로 한 번 보내며, 나중에 참가한 수신기도 받습니다(06장).
# 움직이는 관절은 관절 값이 있어야 합니다. 그래서 관절 드라이버가 발행하는 `/joint_states` 메시지를 기다리고, 메시지에 **이름이 있는** 관절만 `/tf`로 보냅니다.
#
# 이번에는 이 노드만 켭니다. 관절 값을 발행하는 노드는 없습니다. 팔은 어떻게 될까요?

# %% name="ros-imports" slide="skip"
import rclpy
from builtin_interfaces.msg import Time as Stamp
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import JointState
from tf2_ros import Buffer, TransformException, TransformListener

# %% name="alone" tags=["collapsed"] slide="skip"
# Start robot_state_publisher alone.
graph = lesson.new_graph()  # the simulation; a new one whenever this cell runs
robot = lesson.TeachingRobot()
nodes = lesson.launch(graph, robot, only=['robot_state_publisher'])

# %% name="the-tree-alone" tags=["predicted", "collapsed"] slide="fragment"
# Draw the tree.
lesson.frame_tree(graph, seconds=1.0)

# %% [markdown] lang="en" name="the-tree-alone-seen" tags=["predicted"]
# A hand without an arm: `tool0` and `tcp` are connected to the wrist, and the wrist to nothing. The wheels, `shoulder` and `elbow` are missing.
# The publisher does not assume zero. In RViz the RobotModel prints `left_wheel: No transform from [left_wheel] to [odom]`, and a lookup of the hand raises:

# %% [markdown] lang="ko" name="the-tree-alone-seen" tags=["predicted"]
# *그림 읽기:* published by = 발행자, S(static) = 정적. 맨 아래 줄은 트리가 둘로 나뉘었다는 경고입니다.
#
# 팔 없는 손입니다. `tool0`와 `tcp`는 손목에 고정되어 있지만 손목은 아무 데도 연결되어 있지 않습니다. 바퀴와 `shoulder`, `elbow`는 아예 없습니다.
# 이 노드는 받지 못한 관절 값을 0으로 가정하지 않습니다. RViz의 RobotModel에는 `left_wheel: No transform from [left_wheel] to [odom]`이라고 나오고, 손의 변환을 조회하면 이런 오류가 납니다.

# %% [markdown] lang="en" name="alone-notes" slide="notes"
# The class laughs at the hand without an arm. Give them time. Then: which node publishes wrist? None, and none reports it. The four drivers after this take five minutes; vote on each.

# %% [markdown] lang="ko" name="alone-notes" slide="notes"
# 팔 없는 손을 보고 웃는 사람이 있습니다. 잠시 둡니다. 그다음 묻습니다. wrist는 어느 노드가 발행합니까? 아무 노드도 발행하지 않는데 오류도 나지 않습니다. 다음에 나올 네 드라이버에 5분을 씁니다. 하나씩 손을 들게 합니다.

# %% name="ask-for-the-hand" slide="-"
rclpy.init()
node = Node('driver_and_listener')
buffer = Buffer()
listener = TransformListener(buffer, node, spin_thread=True)
graph.run(seconds=1.0)
try:
    buffer.lookup_transform('base_link', 'tool0', Time())
except TransformException as error:
    print(type(error).__name__, error, sep='\n')

# %% [markdown] lang="en" name="play-driver" slide="subslide"
# Now you are the joint driver, four times: with other joint names, with the stamp zero, with velocities but no positions, and as it should be. The first three are mistakes that real drivers make. **Predict:** after which of the four is the arm complete, and which of the four cause a warning?

# %% [markdown] lang="ko" name="play-driver" slide="subslide"
# 이번에는 관절 드라이버가 되어 봅시다. 메시지를 네 번 보냅니다. 이름이 다른 것, 시각이 0인 것, 위치 없이 속도만 있는 것, 제대로 된 것입니다. 앞의 셋은 실제 드라이버가 하는 실수입니다. **예측해 봅시다.** 어느 것이 손과 팔을 연결할까요? 연결하지 못할 때 이유를 알려 주는 것은 어느 것일까요?

# %% name="driver" slide="skip"
states = node.create_publisher(JointState, 'joint_states', 10)
JOINTS = ['shoulder_joint', 'elbow_joint', 'wrist_joint']


def drive(names, stamp=None, **values):
    message = JointState(name=names, **values)
    message.header.stamp = stamp or node.get_clock().now().to_msg()
    states.publish(message)
    graph.run(seconds=0.5)
    return bool(buffer.can_transform('base_link', 'tool0', Time()))

# %% name="four-drivers" tags=["predicted"] slide="fragment"
print('other names   ', drive(['shoulder', 'elbow', 'wrist'], position=[0.5, -0.6, 0.4]))
print('stamp zero    ', drive(JOINTS, stamp=Stamp(), position=[0.5, -0.6, 0.4]))
print('velocity only ', drive(JOINTS, velocity=[0.1, 0.1, 0.1]))
print('as it should  ', drive(JOINTS, position=[0.5, -0.6, 0.4]))

# %% [markdown] lang="en" name="drivers-seen" tags=["predicted"]
# - **Other names:** no warning at all. No node checks that the names are those of the URDF.
# - **Stamp zero:** no warning. A JointState that is not newer than the last one is ignored, and zero is never newer.
# - **Velocity only:** only this one causes a WARN. It names the first joint, and its text is that of the real node.
#
# If an arm is missing, run `ros2 topic echo /joint_states`. Compare the names with the URDF, and check stamp and position.
#
# The URDF itself is on a topic, too:

# %% [markdown] lang="ko" name="drivers-seen" tags=["predicted"]
# - **이름이 다를 때**(other names): 아무 메시지도 없습니다. URDF의 이름과 같은지 확인하지 않습니다.
# - **시각이 0일 때**(stamp zero): 아무 메시지도 없습니다. 마지막 메시지보다 나중의 시각이 아니면 무시하는데, 0은 결코 더 나중일 수 없습니다.
# - **속도만 있을 때**(velocity only): 유일하게 WARN이 나옵니다. 첫 관절의 이름이 적혀 있고, 문구는 실제 노드의 것입니다.
#
# 팔이 보이지 않으면 `ros2 topic echo /joint_states`를 실행해 이름을 URDF와 비교하고, 시각과 위치가 있는지 확인하십시오.
#
# URDF도 토픽으로 나옵니다.

# %% name="the-drawing-itself" slide="skip"
# %ros2 topic echo /robot_description --once

# %% name="stop" tags=["collapsed"] slide="skip"
# Stop the nodes.
graph.stop()
node.destroy_node()
rclpy.shutdown()

# %% [markdown] lang="en" name="tilt" slide="slide"
# ## A laser that looks down
#
# The laser is 0.15 m above `base_link`, and `base_link` 0.10 m above the floor: **0.25 m**. If it looks down by a small angle, a ray meets the floor at 0.25 / tan(angle):

# %% [markdown] lang="ko" name="tilt" slide="slide"
# ## 아래를 보는 레이저
#
# 레이저는 `base_link`에서 0.15 m 위에 있고, `base_link`는 바닥에서 0.10 m 위에 있습니다. 합하면 **0.25 m**입니다. 조금 기울면 앞을 보는 빛은 0.25 / tan(각도)에서 바닥에 닿습니다.

# %% name="how-far" tags=["collapsed"] slide="-"
# Tilt the laser by 1° to 5°.
def tilted(degrees):
    mount = Transform.from_rpy(pitch=math.radians(degrees), translation=(0.20, 0.0, 0.15))
    return lesson.TeachingRobot(screws={'laser_frame': mount})


for degrees in (1, 2, 3, 5):
    robot = tilted(degrees)
    points = robot.truth_at(seconds(1.0))['laser_frame'].apply(robot.laser.scan_at(seconds(1.0)).points())
    floor = (points[:, 2] < 0.05).mean()
    floor_m = 0.25 / math.tan(math.radians(degrees))
    print(f'{degrees}°: floor at {floor_m:5.1f} m; {floor:.0%} of the rays end there')

# %% [markdown] lang="en" name="tilt-3d" slide="subslide"
# In 3D: move the slider, and watch the far wall.

# %% [markdown] lang="ko" name="tilt-3d" slide="subslide"
# 3D로 봅시다. 슬라이더(tilt = 기울기)를 움직이며 먼 벽을 보세요.

# %% name="tilt-scene" tags=["collapsed"] slide="skip"
# Prepare the 3D view.
scene = lesson.Scene(height_px=360)
scene.look(eye=(-2.5, -6.5, 4.5), target=(3.0, 0.0, 0.0))
lesson.draw_walls(scene)


def at_tilt(degrees):
    robot = tilted(degrees)
    scan, pose = robot.laser.scan_at(seconds(1.0)), robot.truth_at(seconds(1.0))['laser_frame']
    lesson.draw_frame(scene, 'laser_frame', pose, length_m=0.5)
    lesson.draw_scan(scene, 'scan', pose, scan.ranges[::4], scan.angle_min, 4 * scan.angle_increment)

# %% name="tilt-sweep" tags=["interactive", "collapsed"]
# Show the 3D view.
scene.sweep('tilt', [0.5 * i for i in range(11)], at_tilt, unit='deg', start=6)
scene

# %% name="tilt-still" tags=["static"]
lesson.draw_placed({f'tilt {d}°': lesson.scan_on_map(tilted(d), at_s=1.0) for d in (1, 3, 5)}, walls=lesson.ROOM.walls)

# %% [markdown] lang="en" name="tilt-map" slide="subslide"
# And the map, seen from above? First with a URDF that describes the laser as level, then with a correct one. **Predict:** does the correct URDF put the dots back on the walls?

# %% [markdown] lang="ko" name="tilt-map" slide="subslide"
# 위에서 본 지도는 어떨까요? 먼저 레이저가 수평이라고 적힌 URDF, 다음은 기울기를 제대로 적은 URDF입니다. **예측해 봅시다.** 제대로 적으면 점들이 다시 벽 위에 놓일까요?

# %% name="tilt-placed" tags=["predicted", "collapsed"]
# Draw the map for three cases.
drawn = URDF.replace('xyz="0.20 0.0 0.15" rpy="0.0 0.0 0.0"', f'xyz="0.20 0.0 0.15" rpy="0 {math.radians(3)} 0"')
level = lesson.scan_on_map(tilted(3), at_s=1.0)
true = lesson.scan_on_map(lesson.TeachingRobot(urdf=drawn), at_s=1.0)
above = true[true[:, 2] > 0.05]
lesson.draw_placed({'URDF: level': level, 'URDF: 3°': true, 'URDF: 3°, z > 0.05': above}, walls=lesson.ROOM.walls)

# %% [markdown] lang="en" name="tilt-seen" tags=["predicted"]
# There is a **phantom wall** across the room, five metres ahead, where there is only floor. It retreats as you drive towards it, and a planner does not drive through it.
# The walls that are still seen are up to 0.14 % too far; nobody sees that.
#
# The correct URDF does not put the dots back: these rays *did* end there, on the floor. But now they have the correct z, so you can drop them.
# A program that accepts only a planar scan cannot use z. In that case level the laser with a screwdriver. The lecture says that obstacles are misplaced if a tilted laser is described as level. A correct URDF is only the first part of the fix.

# %% [markdown] lang="ko" name="tilt-seen" tags=["predicted"]
# *그림 읽기:* level = 수평이라고 적힘, 3° = 기울기를 적음, z > 0.05 = 높이 5 cm가 넘는 점만.
#
# 5미터 앞, 바닥뿐인 자리에 **유령 벽**이 가로놓입니다. 다가가면 그만큼 물러나지만, 경로 계획기는 지나가려 하지 않습니다.
# 바닥에 닿지 않은 빛은 벽을 최대 0.14 % 멀게 측정하지만, 아무도 알아채지 못합니다.
#
# URDF를 제대로 적어도 점들은 벽 위로 되돌아오지 않습니다. 빛이 *실제로* 바닥에서 끝났기 때문입니다. 대신 점마다 z가 생기고, 그러면 걸러 낼 수 있습니다.
# 평면 스캔만 받는 프로그램이라면 나사를 조절해 레이저를 수평으로 맞추십시오. 강의에서는 기울어진 레이저를 수평으로 여기면 장애물 위치가 틀어진다고 했습니다. URDF를 제대로 적는 것은 고치는 일의 시작이지 끝이 아닙니다.

# %% [markdown] lang="en" name="tilt-notes" slide="notes"
# The surprise is the second panel: the URDF is right and the dots are where they were. Ask what the URDF has given us then. The answer is one number: z.

# %% [markdown] lang="ko" name="tilt-notes" slide="notes"
# 예상과 다른 것은 둘째 그림입니다. URDF가 맞는데도 점들은 그대로입니다. 그러면 URDF를 고쳐서 얻은 것은 무엇일까요? 답은 숫자 하나, z입니다.

# %% [markdown] lang="en" name="imu" slide="slide"
# ## An IMU upside down
#
# The gyro of an IMU measures angular velocity. The accelerometer measures the acceleration of the robot together with the force that holds the IMU up against gravity. Both measure along the IMU's own axes. Ours is mounted upside down. The robot stands still, and then drives a curve to the left, 0.5 m/s and 0.5 rad/s.

# %% [markdown] lang="ko" name="imu" slide="slide"
# ## 뒤집힌 IMU
#
# IMU의 자이로는 각속도를 잽니다. 가속도계는 로봇의 가속도와, 중력에 맞서 IMU를 떠받치는 힘을 함께 잽니다. 둘 다 IMU 자신의 축으로 잽니다. 우리 IMU를 뒤집어 답니다. 로봇은 서 있다가 왼쪽으로 굽은 길을 0.5 m/s, 0.5 rad/s로 달립니다.

# %% name="imu-reads" tags=["predicted", "collapsed"] slide="fragment"
# Read the IMU at rest and in the bend.
bend = lesson.Drive(legs=[lesson.Leg(2.0), lesson.Leg(6.0, 0.5, 0.5)])
back = Transform.from_rpy(roll=math.pi, translation=(0.0, 0.0, 0.05))
imu = lesson.TeachingRobot(bend, screws={'imu_link': back}).imu
rest, turning = imu.reading_at(seconds(2.0)), imu.reading_at(seconds(6.0))
turn = Transform(rotation=back.rotation)  # base_T_imu: a vector is rotated, not translated
for name, reading in {'at rest': rest, 'in the bend': turning}.items():
    print(f'{name:<12} acceleration in imu_link  {lesson.fmt_all(reading.linear_acceleration, "m/s²", 2)}')
    gyro = reading.angular_velocity
    in_imu, in_base = lesson.fmt(gyro[2], '', 2), lesson.fmt(turn.apply(gyro)[2], 'rad/s', 2)
    print(f'{"":<12} gyro z in imu_link {in_imu}, in base_link {in_base}')

# %% [markdown] lang="en" name="imu-seen" tags=["predicted"]
# At rest z reads **−9.8** instead of +9.8, and a rotation to the left reads **−0.50**. In `base_link` left is still positive. It is the IMU's z that points down.
# It is not broken. Describe its mount in the URDF, `rpy="3.1416 0 0"`, and a rotation by `base_T_imu` corrects each vector: `base_v = R @ imu_v`, a rotation without the translation. A minus sign in your own node would fix this one number, leave y wrong, and surprise the next person.

# %% [markdown] lang="ko" name="imu-seen" tags=["predicted"]
# *그림 읽기:* at rest = 서 있을 때, in the bend = 굽은 길에서, acceleration = 가속도계 값.
#
# 서 있을 때 z가 +9.8이 아니라 **−9.8**이고, 왼쪽 회전이 **−0.50**입니다. 왼쪽이 양수라는 약속은 그대로이고, IMU의 z가 아래를 향할 뿐입니다.
# 고장이 아닙니다. 실제로 달린 대로 URDF에 `rpy="3.1416 0 0"`이라고 적으면 `base_T_imu`의 회전이 모든 벡터를 바르게 바꿉니다. 벡터에는 이동 없이 회전만 적용합니다(`base_v = R @ imu_v`). 내 노드에서 마이너스를 붙이면 숫자 하나는 맞지만 y는 틀린 채로 남고, 다음 사람이 이유를 알 수 없게 됩니다.

# %% name="imu-arrows" tags=["collapsed"] slide="subslide"
# Draw the IMU and its acceleration at rest.
imu_link = {'base_link': Transform(), 'imu_link': Transform.from_rpy(roll=math.pi, translation=(0.0, 0.0, 0.6))}
up = (0.0, 0.0, rest.linear_acceleration[2])
lesson.draw_scene(imu_link, arrows={'acceleration at rest': ('imu_link', up)}, fixed_frame='base_link', length_m=0.2)

# %% [markdown] lang="en" name="imu-arrows-seen" slide="-"
# The IMU's z points down, and the acceleration at rest still points up.

# %% [markdown] lang="ko" name="imu-arrows-seen" slide="-"
# *그림 읽기:* acceleration at rest = 서 있을 때의 가속도계 값입니다. IMU의 z는 아래를 향하는데 화살표는 위를 향합니다.

# %% [markdown] lang="en" name="imu-rules" slide="subslide"
# ### Three checks before you use an `Imu` message
#
# The axes are one thing to check. The lecture (§25) names three more. Their rules are in REP 103, REP 145 and the comments of `sensor_msgs/msg/Imu`.
#
# - **Has the driver removed gravity?** It must not. At rest a correct IMU reads +9.81 on the axis that points up. If z is 0 at rest, the driver has removed gravity.
# - **Which way is yaw 0?** `orientation` is given in the earth's axes: x points east, y north, z up. So yaw 0 is **east**, and yaw grows to the left. A compass counts from north and to the right. An IMU without a compass has no east: its yaw 0 is the direction in which it was switched on.
# - **Is the value measured at all?** Each of the three measurements has a covariance. `orientation_covariance[0] = -1` means that this IMU gives no orientation: do not use the quaternion. A covariance of nothing but zeros means "unknown", not "exact".

# %% [markdown] lang="ko" name="imu-rules" slide="subslide"
# ### `Imu` 메시지를 쓰기 전에 확인할 세 가지
#
# 축의 방향만 확인해서는 부족합니다. 강의(§25)에는 세 가지가 더 나옵니다. 규칙은 REP 103, REP 145와 `sensor_msgs/msg/Imu`의 주석에 있습니다.
#
# - **드라이버가 중력을 뺐습니까?** 빼면 안 됩니다. 서 있을 때 올바른 IMU는 위를 향한 축에 +9.81을 보입니다. 서 있는데 z가 0이면 드라이버가 중력을 뺀 것입니다.
# - **yaw 0은 어느 쪽입니까?** `orientation`은 지구에 고정된 축을 기준으로 합니다. x가 동쪽, y가 북쪽, z가 위입니다. 따라서 yaw 0은 **동쪽**이고 왼쪽으로 갈수록 커집니다. 나침반은 북쪽에서 오른쪽으로 셉니다. 나침반이 없는 IMU는 동쪽을 모르므로, 켤 때 향하던 쪽이 yaw 0입니다.
# - **정말 측정한 값입니까?** 세 측정값마다 공분산이 있습니다. `orientation_covariance[0] = -1`이면 방향을 측정하지 않는 IMU이므로 쿼터니언을 쓰지 마십시오. 공분산이 모두 0이면 “정확하다”가 아니라 “모른다”라는 뜻입니다.

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it: faulty URDF files
#
# Four changes to the file: parent and child are swapped, a link's name has a typo, an expression of xacro (a program that generates URDF files) is left in, and an angle is in degrees. Each of them happens when a file is written by hand. **Predict** which of them the parser reports.

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기: 실수가 있는 URDF
#
# 파일에 실수 네 가지를 하나씩 넣습니다. 부모와 자식을 바꾼 것, 링크 이름의 오타, 펼치지 않은 xacro 식(xacro는 URDF를 만들어 내는 프로그램입니다), 도(degree)로 적은 각도입니다. 손으로 쓰다 보면 생기는 실수입니다. 파일을 읽는 프로그램이 찾아내는 실수는 어느 것일지 **예측해 봅시다.**

# %% name="broken-files" tags=["predicted"] slide="fragment"
ends = '<parent link="base_link"/>\n    <child link="laser_frame"/>'
broken = {
    'ends swapped': URDF.replace(ends, '<parent link="laser_frame"/>\n    <child link="base_link"/>'),
    'a typo': URDF.replace('<child link="laser_frame"/>', '<child link="laser"/>'),
    'xacro left in': URDF.replace('xyz="0.20 0.0 0.15"', 'xyz="${ahead} 0.0 0.15"'),
    'degrees': URDF.replace('xyz="0.20 0.0 0.15" rpy="0.0 0.0 0.0"', 'xyz="0.20 0.0 0.15" rpy="0 0 90"'),
}
for what, text in broken.items():
    try:
        lesson.parse_urdf(text)
        print(f'{what}: fine')
    except ValueError as error:
        print(f'{what}: {error}')

# %% [markdown] lang="en" name="broken-seen" tags=["predicted"]
# Three of the four are reported, with their line: a link with two parents, a joint that names a link which does not exist, and an expression of xacro where a number belongs. (The workbook's parser reports more than ROS 2's. ROS 2's parser stops at these faults as well.)
# **Degrees** are accepted, because 90 is a valid number of radians. No parser can compare the file with what you measured.

# %% [markdown] lang="ko" name="broken-seen" tags=["predicted"]
# *그림 읽기:* ends swapped = 부모와 자식이 바뀜, a typo = 오타, xacro left in = xacro를 펼치지 않음, degrees = 도(degree), fine = 문제없음.
#
# 넷 가운데 셋은 줄 번호와 함께 알려 줍니다. 부모가 둘인 링크, 없는 링크를 쓴 관절, 숫자 자리에 남은 xacro 식입니다. (이 워크북의 프로그램은 ROS 2의 프로그램보다 자세히 알려 줍니다. ROS 2의 프로그램도 이런 파일에서는 멈춥니다.)
# **도**(degree)는 문제없다고 나옵니다. 숫자 90 역시 올바른 값이기 때문입니다. 여러분이 무슨 단위로 쟀는지는 파일에 나타나지 않습니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# In RViz everything is green. Yet the walls of the scan are rotated by 90° against the walls of the map. Where do you look first?
#
# 1. At the laser: it is broken.
# 2. At the quaternion that the laser driver publishes.
# 3. At `<joint><origin>` of the laser in the URDF, compared with the real robot.
# 4. At `<visual><origin>` of the laser.
#
# <details><summary>I chose 1</summary>
#
# Its ranges are right: the walls have the right shape, only rotated. A broken laser does not measure a tidy room.
#
# </details>
# <details><summary>I chose 2</summary>
#
# A scan contains no pose at all, only ranges and a frame's name. The pose of that frame comes from TF.
#
# </details>
# <details><summary>I chose 3</summary>
#
# Yes: compare the description with the real mount. `tf2_echo base_link laser_frame` prints the description. Look at the mount yourself.
#
# </details>
# <details><summary>I chose 4</summary>
#
# That rotates only the shape in the picture. The dots would not move.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# RViz에서는 모두 초록색입니다. 그런데 스캔의 벽이 지도의 벽을 기준으로 90° 회전해 있습니다. 무엇을 먼저 봐야 합니까?
#
# 1. 레이저가 고장입니다.
# 2. 레이저 드라이버가 발행하는 쿼터니언.
# 3. URDF에 있는 레이저의 `<joint><origin>`과 실제 로봇.
# 4. 레이저의 `<visual><origin>`.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 거리는 맞습니다. 벽의 모양이 그대로이고 회전해 있을 뿐입니다. 고장 난 레이저라면 방의 모양이 반듯하게 나오지 않습니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 스캔에는 포즈가 없습니다. 거리와 좌표계 이름만 있습니다. 그 좌표계가 어디에 있는지는 TF가 알려 줍니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞습니다. 도면에 적힌 값과 실제 장착입니다. `tf2_echo base_link laser_frame`은 도면에 적힌 값을 보여 줍니다. 실제 장착은 직접 봐야 합니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 겉모습만 회전합니다. 점들은 움직이지 않습니다.
#
# </details>

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# The lecture does not say how to start `robot_state_publisher` with its URDF (§11). Save the URDF as `robot.urdf`. The parameter takes the *text* of the file, so let the shell read it:
#
# ```
# ros2 run robot_state_publisher robot_state_publisher \
#   --ros-args -p robot_description:="$(cat robot.urdf)"
# ```
#
# Without the parameter the node stops with `robot_description parameter must not be empty`. (On a computer without ROS 2, put `tflab` in front of `ros2`, and the same command runs.) Then look at what it publishes, and at the sensors:
#
# ```
# ros2 topic echo /robot_description --once        # the URDF that all nodes use
# ros2 topic echo /joint_states                    # names, stamp, position
# ros2 node info /robot_state_publisher
# ros2 run tf2_ros tf2_echo base_link laser_frame  # the mount, as described
# ros2 topic echo /imu --field angular_velocity.z  # rotate the robot to the left by hand: positive?
# ```
#
# For a laser: put a box straight ahead of the robot and look where RViz shows it. It takes thirty seconds. Do it on the day on which the laser is mounted.

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# 강의(§11)에는 이 URDF로 `robot_state_publisher`를 켜는 법이 나오지 않습니다. URDF를 `robot.urdf`로 저장합니다. 파라미터의 값은 파일 이름이 아니라 파일의 *내용*이므로, 셸이 읽어 넣게 합니다.
#
# ```
# ros2 run robot_state_publisher robot_state_publisher \
#   --ros-args -p robot_description:="$(cat robot.urdf)"
# ```
#
# 파라미터가 없으면 노드는 `robot_description parameter must not be empty`라며 멈춥니다. (ROS 2가 없는 컴퓨터에서는 `ros2` 앞에 `tflab`을 붙이면 같은 명령을 실행할 수 있습니다.) 이제 무엇을 발행하는지, 센서는 어떤지 살펴봅니다.
#
# ```
# ros2 topic echo /robot_description --once        # 모든 노드가 받는 URDF
# ros2 topic echo /joint_states                    # 이름, 시각, 위치
# ros2 node info /robot_state_publisher
# ros2 run tf2_ros tf2_echo base_link laser_frame  # 도면에 적힌 값
# ros2 topic echo /imu --field angular_velocity.z  # 로봇을 손으로 왼쪽으로 회전시키면 양수?
# ```
#
# 레이저라면 로봇 바로 앞에 상자를 놓고 RViz의 어디에 보이는지 확인하십시오. 레이저를 다는 날 30초면 됩니다.

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - A [[urdf|URDF]] is a claim about the mounts. TF repeats it and never checks it.
# - `<joint><origin>` moves the frame, `<visual><origin>` only the shape. Metres, radians, parent to child.
# - `parent_T_child = origin @ movement`; the axis is given in the child's axes.
# - [[robot_state_publisher]]: fixed joints on `/tf_static`, once; moving ones on `/tf`, and only those that a JointState names, with a stamp and a position.
# - A laser that looks down by 3° sees the floor as a wall, five metres ahead. An IMU upside down reports a rotation to the left with the wrong sign. Fix both at the joint or with a screwdriver, not in a node.
# - `tcp` is a frame of its own, a child of `tool0`.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - [[urdf|URDF]]에는 장착이 도면의 값으로 적혀 있습니다. TF는 확인하지 않고 모든 노드에 그대로 전달합니다.
# - `<joint><origin>`은 좌표계의 위치를 바꾸고, `<visual><origin>`은 겉모습의 위치만 바꿉니다. 관절의 origin은 부모를 기준으로 한 자식의 포즈이고, 단위는 미터와 라디안입니다.
# - `parent_T_child = origin @ movement`이고, axis는 자식의 축으로 적습니다.
# - [[robot_state_publisher|`robot_state_publisher`]]는 고정된 관절을 `/tf_static`으로 한 번, 움직이는 관절을 `/tf`로 보냅니다. JointState에 이름, 시각, 위치가 있는 관절만 보냅니다.
# - 3° 아래를 보는 레이저는 5미터 앞의 바닥을 벽으로 측정합니다. 뒤집힌 IMU에서는 왼쪽 회전의 부호가 바뀝니다. 둘 다 노드의 코드가 아니라 관절의 origin이나 실제 장착을 바로잡으십시오.
# - `tcp`는 `tool0` 아래에 따로 둔 좌표계입니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > On Monday somebody rotates the laser by 180° so that its cable fits, and tells nobody. On Friday the robot brakes for walls that are behind it. Which line of which file is wrong, and which tool would have reported it on Monday?
#
# <details><summary>Compare</summary>
#
# The `rpy` of the laser's **joint** origin. No tool: RViz, view_frames and tf2_echo all repeat the description. A box straight ahead of the robot would have shown it.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > 월요일에 누군가 케이블 때문에 레이저를 180° 회전시켜 달고 아무에게도 알리지 않았습니다. 금요일에 로봇은 뒤에 있는 벽 때문에 멈춥니다. 어느 파일의 어느 줄이 틀렸고, 월요일에 알려 줄 수 있었던 도구는 무엇입니까?
#
# <details><summary>맞춰 보기</summary>
#
# 레이저 **관절**의 origin에 있는 `rpy`입니다. 알려 줄 도구는 없습니다. RViz, view_frames, tf2_echo는 모두 도면의 값을 그대로 보여 줄 뿐입니다. 로봇 바로 앞에 상자를 놓아 보았다면 알 수 있었습니다.
#
# </details>

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now read a joint of a URDF, say which of its frames are published, and recognise a sensor whose mount differs from the description.
# Do the exercises next, [E7 URDF and sensors](../../exercises/en/E07_urdf_and_sensors.ipynb). Then go on to [08 Buffer and measurement time](08_buffer_and_measurement_time.ipynb), about the time of a transform.
# In the exercises, `solution("E7.1")` shows a solution after you have passed the task or tried three times.
#
# The sections below are optional. They contain the calibration of a tool, what gravity tells about a mount, rare kinds of joints, and questions for practice.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 URDF의 관절을 읽고, 어느 좌표계가 발행되는지 말하고, 도면과 다르게 달린 센서를 알아볼 수 있습니다.
# 다음은 연습 문제 [E7 URDF와 센서](../../exercises/ko/E07_urdf_and_sensors.ipynb)입니다. 그다음 [08 버퍼와 측정 시각](08_buffer_and_measurement_time.ipynb)으로 갑니다. 어느 시각의 변환을 조회할지 배웁니다.
# 연습 문제에서는 통과하거나 세 번 시도한 뒤 `solution("E7.1")`로 풀이를 볼 수 있습니다.
#
# 아래는 더 알고 싶은 사람을 위한 것입니다. 공구의 tcp를 구하는 법, 중력으로 장착을 알아내는 법, 드문 관절, 복습 문제가 있습니다.

# %% [markdown] lang="en" name="touch-heading" slide="slide"
# ## How to find a tcp: touch a mark

# %% [markdown] lang="ko" name="touch-heading" slide="slide"
# ## tcp의 위치 구하기: 표시에 대 보기

# %% [markdown] lang="en" name="touch" slide="-"
# Touch a mark whose position is known, `base_p_tip`, and transform it into the tool's frame: `tool0_p_tip = tool0_T_base @ base_p_tip`. The arm stands as in the figure of *A chain of joints*.

# %% [markdown] lang="ko" name="touch" slide="-"
# 위치를 아는 표시 `base_p_tip`에 공구 끝을 대고, 그 점을 공구 기준으로 계산합니다. `tool0_p_tip = tool0_T_base @ base_p_tip`입니다. 팔의 자세는 *사슬: 경첩이 달린 도미노*의 그림과 같습니다.

# %% name="touch-it" slide="-"
arm = lesson.link_poses(lesson.parse_urdf(URDF), {'shoulder_joint': 0.5, 'elbow_joint': -0.6, 'wrist_joint': 0.4})
base_T_tool0 = arm['base_link'].inverse() @ arm['tool0']
base_p_tip = (0.3563, 0.2491, 0.3546)  # where the mark is, measured with a ruler
tool0_p_tip = base_T_tool0.inverse().apply(base_p_tip)
print('tool0_p_tip', lesson.fmt_all(tool0_p_tip))

# %% [markdown] lang="en" name="gravity-heading" slide="slide"
# ## What gravity tells about a mount, and what it does not

# %% [markdown] lang="ko" name="gravity-heading" slide="slide"
# ## 중력으로 알 수 있는 것과 알 수 없는 것

# %% [markdown] lang="en" name="gravity" slide="-"
# Upside down by roll π, or by pitch π? Or only rotated to the left? **Predict:** with the reading at rest, which of these can you tell apart?

# %% [markdown] lang="ko" name="gravity" slide="-"
# roll로 π만큼 뒤집힌 것일까요, pitch로 뒤집힌 것일까요? 아니면 뒤집히지 않고 왼쪽으로 회전해 달린 것일까요? **예측해 봅시다.** 서 있을 때의 값으로 구별되는 것은 어느 것일까요?

# %% name="what-gravity-tells" tags=["predicted"]
mounts = {'as drawn': {}, 'left': {'yaw': math.pi / 2}, 'roll π': {'roll': math.pi}, 'pitch π': {'pitch': math.pi}}
for name, rpy in mounts.items():
    base_T_imu = Transform.from_rpy(**rpy)
    at_rest, in_bend = (base_T_imu.inverse().apply((0.0, pull, 9.81)) for pull in (0.0, 0.25))
    print(f'{name:<9} at rest {lesson.fmt_all(at_rest, "", 2)}   in the bend {lesson.fmt_all(in_bend, "m/s²", 2)}')

# %% [markdown] lang="en" name="gravity-seen" tags=["predicted"]
# Gravity points along one line. It shows that the IMU is upside down, but not about which axis it was rotated. A rotation about the vertical cannot be seen at all.
# A curve to the left gives an acceleration to the left, 0.5 m/s · 0.5 rad/s = 0.25 m/s². That second vector decides the rest. On a real robot, rotate the robot to the left by hand: `angular_velocity.z` must be positive.

# %% [markdown] lang="ko" name="gravity-seen" tags=["predicted"]
# *그림 읽기:* as drawn = 도면대로, left = 왼쪽으로 회전.
#
# 중력은 방향 하나만 알려 줍니다. IMU가 뒤집혔다는 것은 알 수 있지만 어떻게 뒤집혔는지는 알 수 없고, 수직축을 중심으로 한 회전은 전혀 알 수 없습니다.
# 왼쪽으로 굽은 길에서는 왼쪽으로 0.5 m/s · 0.5 rad/s = 0.25 m/s²의 가속도가 생깁니다. 이 둘째 벡터로 나머지가 정해집니다. 실제 로봇은 손으로 왼쪽으로 회전시켜 봅니다. `angular_velocity.z`가 양수여야 합니다.

# %% [markdown] lang="en" name="gravity-notes" slide="notes"
# Take a phone, lay it on its face, rotate it about the vertical: gravity reads the same. That is why a curve is needed.

# %% [markdown] lang="ko" name="gravity-notes" slide="notes"
# 휴대전화를 엎어 놓고 수직축을 중심으로 회전시켜 보입니다. 중력은 그대로입니다. 그래서 굽은 길이 필요합니다.

# %% [markdown] lang="en" name="deeper-heading" slide="skip"
# ## What `robot_state_publisher` does with other joints

# %% [markdown] lang="ko" name="deeper-heading" slide="skip"
# ## `robot_state_publisher`가 다른 관절을 다루는 법

# %% [markdown] lang="en" name="deeper" slide="skip"
# - A joint with `<mimic>` follows another one; a driver need not name it.
# - A joint message that comes sooner than `publish_frequency` (20 Hz) allows is ignored. The transforms have the **stamp of the message**, not the current time.
# - `frame_prefix` is put before every frame: one URDF, two robots (chapter 04).
# - `floating` joints are not published at all, and `planar` ones count as fixed.
# - If the root link has an inertia, the node prints: `The root link … has an inertia specified in the URDF, but KDL does not support a root link with an inertia.` It is a WARN, and harmless; the usual solution is `base_footprint` above `base_link`.

# %% [markdown] lang="ko" name="deeper" slide="skip"
# - `<mimic>`이 있는 관절은 다른 관절을 따라갑니다. 드라이버가 이름을 보내지 않아도 됩니다.
# - `publish_frequency`(20 Hz)보다 자주 오는 관절 메시지는 무시합니다. 변환에는 현재 시각이 아니라 **메시지의 시각**을 적습니다.
# - `frame_prefix`는 모든 좌표계 이름 앞에 붙습니다. URDF 하나로 로봇 두 대를 만듭니다(04장).
# - `floating` 관절은 아예 발행하지 않고, `planar` 관절은 고정된 것으로 다룹니다.
# - 루트 링크에 관성이 있으면 `The root link … has an inertia specified in the URDF, but KDL does not support a root link with an inertia.`라는 WARN이 나옵니다. 해롭지 않으며, `base_link` 위에 `base_footprint`를 두어 없애는 것이 보통입니다.

# %% [markdown] lang="en" name="from-before-heading" slide="slide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="slide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# 1. A detector detects a cup at (0, 0, 2) in `camera_optical_frame`. Where is it in `camera_link`?
# 2. A laser's mount was sent once, on `/tf` instead of `/tf_static`. What does a listener that joins later receive?
# 3. Which of `base_T_laser` and `laser_T_base` transforms a point that the laser measured into `base_link`?
#
# <details><summary>Answers</summary>
#
# 1. At (2, 0, 0): optical z is forward.
# 2. Nothing: `/tf` keeps no messages for listeners that join later.
# 3. `base_T_laser`: the frame on the left is the one that you want.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# 1. 검출기가 `camera_optical_frame` 기준 (0, 0, 2)에서 컵을 봅니다. `camera_link` 기준으로는 어디입니까?
# 2. 레이저의 장착 변환을 `/tf_static`이 아니라 `/tf`로 한 번 보냈습니다. 나중에 참가한 수신기는 무엇을 받습니까?
# 3. 레이저가 본 점을 `base_link` 기준으로 바꾸는 것은 `base_T_laser`와 `laser_T_base` 가운데 어느 것입니까?
#
# <details><summary>답</summary>
#
# 1. (2, 0, 0)입니다. 광학 좌표계의 z가 앞입니다.
# 2. 아무것도 받지 못합니다. `/tf`는 나중에 참가한 수신기를 위해 보관하지 않습니다.
# 3. `base_T_laser`입니다. 왼쪽에 적힌 것이 결과의 기준입니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="slide"
# ## Practice question · Q14: the URDF's part

# %% [markdown] lang="ko" name="practice-heading" slide="slide"
# ## 서술형 문제 · Q14: URDF의 몫

# %% [markdown] lang="en" name="practice" slide="-"
# **14.** How can the work of publishing transforms be divided between the URDF, odometry, an EKF and a localiser? Write what the URDF's part is, and where it ends. (Chapter 12 asks for the rest.)
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] Everything below `base_link` (or `base_footprint`) comes from the URDF, through `robot_state_publisher`.
# - [ ] Fixed joints on `/tf_static`, moving ones on `/tf` from `/joint_states`.
# - [ ] `odom → base` belongs to the wheel odometry or the EKF, one of them; `map → odom` to the localiser. The URDF has neither.
# - [ ] A mount in the URDF is not also published by a second, static publisher.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# **14.** URDF, 오도메트리, EKF, 위치 추정은 변환의 발행 책임을 어떻게 나눌 수 있습니까? URDF의 몫은 무엇이고 어디까지인지 써 보세요. (나머지는 12장에서 묻습니다.)
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] `base_link`(또는 `base_footprint`) 아래의 모든 것은 URDF에서 `robot_state_publisher`를 거쳐 나옵니다.
# - [ ] 고정된 관절은 `/tf_static`, 움직이는 관절은 `/joint_states`를 받아 `/tf`로 발행합니다.
# - [ ] `odom → base`는 바퀴 오도메트리나 EKF 가운데 하나, `map → odom`은 위치 추정의 책임입니다. URDF에는 둘 다 없습니다.
# - [ ] URDF에 있는 장착 변환을 별도의 정적 발행자가 또 발행하지 않습니다.
#
# </details>
