# %% [markdown] lang="en" name="title" slide="slide"
# # 01 · Value, frame and stamp
#
# **Three numbers are not yet a position** · about 30 minutes · builds on 00
#
# After this chapter you can
#
# - name the three parts of a usable measurement: value, frame and stamp,
# - express one position in three frames, and say which coordinates change when something moves,
# - read a message header, nanoseconds included, and calculate the age of a measurement,
# - reject incomplete data, and say why.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 01 · 값, 좌표계, 측정 시각
#
# **숫자 세 개만으로는 위치를 알 수 없습니다** · 약 30분 · 00장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 측정값에 꼭 필요한 세 가지, 곧 값과 좌표계와 측정 시각을 말할 수 있습니다.
# - 같은 위치를 세 좌표계 기준으로 나타내고, 무엇이 움직일 때 어느 숫자가 바뀌는지 구별할 수 있습니다.
# - 메시지 헤더를 나노초까지 읽고 측정값의 나이를 계산할 수 있습니다.
# - 좌표계나 측정 시각이 없는 데이터를 거절하고, 그 이유를 설명할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# One idea: a number without a frame and a time is a rumour.
# Ask the class: "I have (2, 0, 0). Where is it?" Wait until someone answers with a question. That question is today's topic.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 이 장의 핵심은 하나입니다. 좌표계와 시각이 없는 숫자는 쓸 수 없습니다.
# 칠판에 (2, 0, 0)을 적고 묻습니다. “이것은 어디입니까?” 누군가 “무엇을 기준으로요?”라고 되물으면 그 질문으로 수업을 시작합니다.

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## One click, two maps
#
# A robot did not know where it was, so its operator clicked the robot's position on a map.
# The click became a ROS message with three coordinates and a [[frame]] name: `world`.
# The mapping program used the coordinates and ignored the frame name.
# It assumed `map`, whose origin is five metres from the origin of `world`.
#
# There was no error and no warning.
# The program kept mapping from the wrong position and produced a second copy of the building, five metres off (SteveMacenski/slam_toolbox, 2026).
# One question would have prevented it: *what are these coordinates in `map`?* TF2, TF for short, answers that question.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 클릭 한 번에 지도가 두 장
#
# 로봇이 자기 위치를 알 수 없게 되었습니다. 운영자가 화면의 지도를 클릭해 현재 위치를 알려 주었습니다.
# 클릭은 메시지로 전달됩니다. 이 메시지에는 숫자 세 개와 함께 ‘이 숫자는 `world` [[frame|좌표계(frame)]] 기준’이라는 이름표가 있었습니다.
# 지도 작성 프로그램은 숫자만 읽고 이름표는 확인하지 않았습니다.
# 이 프로그램은 `map`을 기준으로 계산하는데, `map`의 원점은 `world`의 원점에서 5미터 떨어져 있었습니다.
#
# 오류도 경고도 나오지 않았습니다.
# 프로그램은 5미터 어긋난 자리에서 지도를 계속 그렸고, 같은 건물의 지도가 두 장 생겼습니다(SteveMacenski/slam_toolbox, 2026년).
# 필요한 질문은 하나였습니다. *이 위치를 `map` 기준으로 나타내면 얼마인가?* TF2(줄여서 TF)가 이 질문에 답합니다.

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* slam_toolbox [863](https://github.com/SteveMacenski/slam_toolbox/issues/863), [872](https://github.com/SteveMacenski/slam_toolbox/pull/872), [876](https://github.com/SteveMacenski/slam_toolbox/pull/876). A similar bug on the sending side: vision_visp [96](https://github.com/lagadic/vision_visp/issues/96).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* slam_toolbox [863](https://github.com/SteveMacenski/slam_toolbox/issues/863), [872](https://github.com/SteveMacenski/slam_toolbox/pull/872), [876](https://github.com/SteveMacenski/slam_toolbox/pull/876). 보내는 쪽에서 일어난 같은 사고: vision_visp [96](https://github.com/lagadic/vision_visp/issues/96).

# %% name="story-picture" tags=["collapsed"] slide="subslide"
# Draw both positions.
from tflab.core import Transform, seconds

world_T_map = Transform(translation=(5.0, 0.0, 0.0))
meant, understood = (2.0, 1.5, 0.0), world_T_map.apply((2.0, 1.5, 0.0))
lesson.draw_scene({'world': Transform(), 'map': world_T_map}, {'meant (2, 1.5)': meant},
                  ghost_points={'understood (2, 1.5)': understood}, fixed_frame='world', length_m=0.8,
                  eye=lesson.FROM_ABOVE, size_inch=(4.9, 2.6))

# %% [markdown] lang="en" name="story-seen"
# The operator meant (2, 1.5) in `world`. The program read the same numbers in `map`, and so understood a position five metres away.
#
# Here the receiver ignored the frame. The sender can get it wrong, too. One program detected a printed marker one metre in front of its camera, but wrote `/map` into the message instead of the camera's frame.
# From then on the marker appeared one metre from the origin of the map, wherever the robot was.
# The sender has to write the right frame, and the receiver has to read it.

# %% [markdown] lang="ko" name="story-seen"
# *그림 읽기:* 위에서 본 그림입니다. meant = 운영자가 뜻한 위치, understood = 프로그램이 알아들은 위치.
# 같은 (2, 1.5)라도 `world`의 원점에서 재면 meant, `map`의 원점에서 재면 understood입니다. 두 위치는 5미터 떨어져 있습니다.
#
# 이 사고에서는 받는 쪽이 이름표를 읽지 않았습니다. 보내는 쪽이 이름표를 잘못 쓴 사고도 있습니다. 어느 프로그램은 카메라 1미터 앞에서 마커(QR 코드처럼 인쇄한 표식)를 찾고는, 메시지의 좌표계 칸인 `frame_id`에 `/map`을 적어 보냈습니다.
# 그러면 로봇이 어디에 있든 마커는 지도 원점에서 1미터 떨어진 것이 됩니다.
# 이름표는 보내는 쪽이 바르게 쓰고, 받는 쪽이 반드시 읽어야 합니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Act it out: one student writes (2, 1.5) on a note. Another picks a corner of the room and walks to that position.
# Nobody made a mistake on purpose, and nothing reported an error. This course is about bugs of that kind.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 두 사람이 해 봅니다. 한 사람이 쪽지에 (2, 1.5)라고 적어 건네고, 다른 사람은 교실의 모서리 하나를 골라 거기서부터 걸어갑니다. 어느 모서리인지는 쪽지에 없습니다.
# 일부러 틀린 사람은 없고 경고도 없었습니다. 이 과정에서 다루는 오류는 대개 이렇습니다.

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# A robot is in a room.
#
# - Its centre, `base_link`, is at **(6.2, −1.7, 0.10)** in `map`. The robot faces along the x axis of `map`.
# - Its laser, `laser_frame`, is mounted at **(0.20, 0, 0.15)** in `base_link`, in front of the centre and above it. It faces forward.
# - The laser detects a ball at **(2, 0, 0)** in `laser_frame`, two metres straight ahead.
#
# What are the ball's coordinates in `base_link`? And in `map`?
# Write your prediction into the next cell before you go on. A wrong prediction teaches you more than no prediction.

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 로봇이 방 안에 서 있습니다. 로봇의 중심 `base_link`는 `map` 기준 <b>(6.2, −1.7, 0.10)</b>에 있고 지도의 x축 방향을 봅니다.
# 레이저 `laser_frame`은 `base_link` 기준 <b>(0.20, 0, 0.15)</b>에 달려 있습니다. 중심보다 앞쪽 위에 있고 로봇과 같은 방향을 봅니다.
# 레이저가 정면 2미터에서 공을 측정했습니다. `laser_frame` 기준으로 <b>(2, 0, 0)</b>입니다.
#
# 공은 `base_link` 기준으로 어디에 있을까요? `map` 기준으로는 어디일까요?
# 다음 셀에 예측을 적은 뒤 실행해 보세요. 틀려도 괜찮습니다. 적어 두어야 어디에서 틀렸는지 알 수 있습니다.

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Give them one minute with pen and paper. Then ask for a show of hands: who kept the numbers, who added, who subtracted? Leave the counts on the board.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 1분 동안 종이에 적게 합니다. 숫자를 그대로 둔 사람, 더한 사람, 뺀 사람이 각각 몇 명인지 칠판에 남겨 둡니다.

# %% name="my-guess" slide="skip"
my_guess = {'base_link': (0.0, 0.0, 0.0), 'map': (0.0, 0.0, 0.0)}  # your guesses: (x, y, z) [m]

# %% [markdown] lang="en" name="run-it" slide="subslide"
# ## Run it
#
# Two nodes publish the transforms: the robot's pose in `map`, and the laser's mount on the robot. In the output, rotation (0, 0, 0, 1) means "no rotation" (chapter 02).

# %% [markdown] lang="ko" name="run-it" slide="subslide"
# ## 실행해 봅시다
#
# 노드 두 개가 변환을 발행합니다. 하나는 `map` 기준 로봇의 포즈, 다른 하나는 레이저의 장착 변환(레이저가 로봇의 어디에 달려 있는지)입니다. 출력의 rotation (0, 0, 0, 1)은 회전이 없다는 뜻입니다(02장).

# %% name="say-where"
# %ros2 run tf2_ros static_transform_publisher --x 6.2 --y -1.7 --z 0.10 --frame-id map --child-frame-id base_link
# %ros2 run tf2_ros static_transform_publisher --x 0.20 --z 0.15 --frame-id base_link --child-frame-id laser_frame

# %% [markdown] lang="en" name="listen-why" slide="-"
# The next cell is what you would write on a robot. Only `graph.run` belongs to this workbook: it lets simulated time pass. (`%load_ext tflab` created `graph`.)
#
# - `rclpy` is the ROS 2 library for Python. A [[node]] is a program that takes part in ROS 2.
# - The [[buffer]] stores transforms.
# - The [[listener]] receives transforms and fills the buffer. With `spin_thread=True` it does so in the background.

# %% [markdown] lang="ko" name="listen-why" slide="-"
# 다음 셀은 실제 로봇에서도 똑같이 쓰는 코드입니다. `graph.run`만 이 워크북의 것으로, 가상의 시간을 흐르게 합니다(`graph`는 `%load_ext tflab`이 만들어 두었습니다).
#
# - `rclpy`는 파이썬용 ROS 2 라이브러리이고, [[node|노드(node)]]는 ROS 2에 참가하는 프로그램입니다.
# - [[buffer|버퍼(buffer)]]는 변환을 저장합니다.
# - [[listener|수신기(listener)]]는 변환을 구독해 버퍼를 채웁니다. `spin_thread=True`이면 다른 코드가 실행되는 동안에도 별도의 스레드에서 수신합니다.

# %% name="listen"
import rclpy
import tf2_geometry_msgs  # lets the buffer transform a PointStamped
from geometry_msgs.msg import PointStamped
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener

rclpy.init()
node = Node('reader')
buffer = Buffer()
listener = TransformListener(buffer, node, spin_thread=True)
graph.run(seconds=0.5)

# %% [markdown] lang="en" name="ask-why" slide="-"
# A `PointStamped` is a point with a header: a frame and a stamp. Nothing moves here, so the stamp may stay 0 for once.

# %% [markdown] lang="ko" name="ask-why" slide="-"
# `PointStamped`는 좌표계와 측정 시각이 헤더에 든 점 메시지입니다. 여기서는 아무것도 움직이지 않으므로 이번만 측정 시각을 0으로 둡니다.

# %% name="three-answers" tags=["predicted"] slide="fragment"
ball = PointStamped()
ball.header.frame_id = 'laser_frame'
ball.point.x = 2.0

for frame in ('laser_frame', 'base_link', 'map'):
    point = buffer.transform(ball, frame).point
    print(f'{frame:<12} ({point.x:.2f}, {point.y:.2f}, {point.z:.2f}) m')
print('you guessed ', my_guess)

# %% [markdown] lang="en" name="compare" tags=["predicted"] slide="subslide"
# ### How was your guess?
#
# <details><summary>I said (2, 0, 0) each time</summary>
#
# You kept the coordinates and changed the frame name. That is the mistake of the story above: the ball would be two metres from the origin of the map, wherever the robot is.
#
# </details>
# <details><summary>I said (1.8, 0, −0.15) in base_link</summary>
#
# You subtracted the mounting offset. The laser is mounted *in front of* `base_link`, so the ball is farther from `base_link` than from the laser. Add the offset.
#
# </details>
# <details><summary>I said (8.2, −1.7, 0.10) in map</summary>
#
# The mount is left out: this would be right if the laser were at the robot's centre.
#
# </details>

# %% [markdown] lang="ko" name="compare" tags=["predicted"] slide="subslide"
# ### 예측은 어땠나요?
#
# <details><summary>모두 (2, 0, 0)이라고 했습니다</summary>
#
# 숫자는 그대로 두고 이름표만 바꾸었습니다. 위의 이야기와 같은 실수입니다. 그러면 로봇이 어디에 있든 공은 지도 원점에서 2미터 떨어진 것이 됩니다.
#
# </details>
# <details><summary>base_link 기준 (1.8, 0, −0.15)라고 했습니다</summary>
#
# 레이저의 장착 위치를 뺐습니다. 레이저는 중심보다 *앞에* 있으므로, 중심에서 공까지가 더 멉니다.
#
# </details>
# <details><summary>map 기준 (8.2, −1.7, 0.10)이라고 했습니다</summary>
#
# 레이저의 장착 위치가 빠졌습니다. 레이저가 로봇의 중심에 있다면 맞는 값입니다.
#
# </details>

# %% [markdown] lang="en" name="run-notes" slide="notes"
# Compare the hands with the counts on the board. The three replies are the three mistakes.
# Open the first one and read it aloud, because it is the mistake of the story.
# Those who were right explain it to a neighbour in one sentence.

# %% [markdown] lang="ko" name="run-notes" slide="notes"
# 칠판의 숫자와 비교합니다.
# 펼쳐 볼 답 세 개가 흔한 실수입니다.
# 첫째 것은 소리 내어 읽습니다.
# 앞의 이야기와 같은 실수입니다.
# 맞힌 사람은 옆 사람에게 한 문장으로 설명합니다.

# %% [markdown] lang="en" name="three-places" slide="slide"
# ## The same numbers are three positions
#
# (2, 0, 0) alone is not a position. In three frames it is three positions.

# %% [markdown] lang="ko" name="three-places" slide="slide"
# ## 같은 숫자, 세 곳의 위치
#
# (2, 0, 0)만으로는 위치를 알 수 없습니다. 어느 좌표계를 기준으로 재느냐에 따라 서로 다른 세 곳이 됩니다.

# %% name="three-places-picture" tags=["collapsed"]
# Draw (2, 0, 0) in three frames.
map_T_base = Transform(translation=(6.2, -1.7, 0.10))
map_T_laser = map_T_base @ Transform(translation=(0.20, 0.0, 0.15))
poses = {'map': Transform(), 'base_link': map_T_base, 'laser_frame': map_T_laser}

places = {frame: pose.apply((2.0, 0.0, 0.0)) for frame, pose in poses.items()}
lesson.draw_rulers(poses, places, 'point')

# %% [markdown] lang="en" name="three-places-seen"
# Each row shows the same floor from above, and the point at (2, 0, 0) of one frame.
# A [[frame]] has a name, an origin and three axes. On a robot, x points forward, y left and z up (chapter 02 explains why).

# %% [markdown] lang="ko" name="three-places-seen"
# *그림 읽기:* 줄마다 같은 바닥을 위에서 본 그림이고, 저마다 한 좌표계의 (2, 0, 0)에 점이 있습니다. from above = 위에서 봄, grid of 1 m = 눈금 한 칸이 1미터.
# [[frame|좌표계]]는 이름이 붙은 원점 하나와 방향 세 개입니다. 로봇에서 x는 앞, y는 왼쪽, z는 위입니다(이유는 02장).

# %% [markdown] lang="en" name="one-place" slide="slide"
# ## One position has three sets of coordinates
#
# Now the other way round: the ball is at rest in one position, and each frame measures that position along its own axes.

# %% [markdown] lang="ko" name="one-place" slide="slide"
# ## 한 위치, 세 가지 숫자
#
# 이번에는 반대입니다. 공은 한 곳에 가만히 있습니다. 그 위치를 세 좌표계의 축으로 각각 잽니다.

# %% name="one-place-picture" tags=["predicted", "collapsed"]
# Draw one ball, measured in three frames.
ball_in_map = map_T_laser.apply((2.0, 0.0, 0.0))
lesson.draw_rulers(poses, ball_in_map, 'ball')

# %% [markdown] lang="en" name="one-place-seen"
# Each row shows the same scene from above. It draws the distance along that frame's x, then along its y.
# All three sets of coordinates are right. Which one you need depends on the task: a gripper, the robot's hand, needs `base_link`. A path planner needs `map`.

# %% [markdown] lang="ko" name="one-place-seen"
# *그림 읽기:* 같은 장면을 위에서 본 그림이 좌표계마다 한 줄씩 있습니다. 줄마다 그 좌표계의 x 방향 거리를 먼저, 그다음 y 방향 거리를 그렸습니다.
# 세 가지 모두 맞습니다. 어느 것을 쓸지는 어디에 쓰느냐에 달려 있습니다. 그리퍼(로봇의 집게)에는 `base_link` 기준이, 경로 계획에는 `map` 기준이 필요합니다.

# %% [markdown] lang="en" name="while-nobody-turns" slide="subslide"
# As long as no frame is rotated, you can simply add: 2 + 0.20 + 6.2.
# Now the robot rotates on the spot, 90° to the left, and detects another ball, again two metres straight ahead of its laser.
#
# **Predict:** which of the three sets of coordinates stay the same?

# %% [markdown] lang="ko" name="while-nobody-turns" slide="subslide"
# 회전한 좌표계가 없으면 2 + 0.20 + 6.2처럼 그냥 더하면 됩니다.
# 이제 로봇이 제자리에서 왼쪽으로 90° 돌고, 레이저 정면에서 다른 공을 봅니다.
#
# **예측해 봅시다.** 세 가지 숫자 가운데 그대로인 것은 무엇일까요?

# %% name="turned" tags=["predicted", "collapsed"] slide="fragment"
# Rotate the robot, and draw the other ball.
import math

map_T_base = Transform.from_rpy(yaw=math.pi / 2, translation=(6.2, -1.7, 0.10))
map_T_laser = map_T_base @ Transform(translation=(0.20, 0.0, 0.15))
turned = {'map': Transform(), 'base_link': map_T_base, 'laser_frame': map_T_laser}

lesson.draw_rulers(turned, map_T_laser.apply((2.0, 0.0, 0.0)), 'ball', before=lesson.readings_of(poses, ball_in_map))

# %% [markdown] lang="en" name="turned-seen" tags=["predicted"]
# The ball is straight ahead again, so its coordinates in `laser_frame` and `base_link` are the same as before. Only those in `map` are different, and 2 + 0.20 + 6.2 no longer gives them, because the robot now faces along the map's y.
# Adding stops working as soon as a frame is rotated. Chapters 02 and 03 show what to do instead, and TF does it for you.

# %% [markdown] lang="ko" name="turned-seen" tags=["predicted"]
# *그림 읽기:* same은 숫자가 그대로라는 뜻, changed는 바뀌었다는 뜻입니다.
# 정면은 여전히 정면입니다. 레이저와 로봇의 숫자는 그대로이고 지도의 숫자만 바뀌었습니다. 지도의 숫자는 아까처럼 더해서는 나오지 않습니다. 이제 정면은 지도의 y 방향이기 때문입니다.
# 좌표계가 하나라도 회전해 있으면 더하기만으로는 구할 수 없습니다. 대신 쓰는 계산은 02장과 03장에서 다루며, 실제로는 TF가 계산합니다.

# %% [markdown] lang="en" name="turned-notes" slide="notes"
# Let everybody stand up and rotate 90° to the left.
# Ask: where is the door now in your frame, and where in the room's?
# The door's coordinates change only in your frame. Those of a hand that you stretch out forward change only in the room's.
# Adding coordinates works only as long as no frame is rotated.

# %% [markdown] lang="ko" name="turned-notes" slide="notes"
# 모두 일어나 왼쪽으로 90° 돌게 합니다.
# 문은 나를 기준으로 어디입니까? 방을 기준으로는 어디입니까?
# 문의 숫자는 나를 기준으로만 바뀝니다.
# 앞으로 뻗은 내 손의 숫자는 반대로, 방을 기준으로만 바뀝니다.
# 좌표를 더하기만 해도 되는 것은 회전한 좌표계가 없을 때뿐입니다.

# %% name="stop-the-reader" tags=["collapsed"] slide="skip"
# Stop the nodes of this scene.
graph.stop()
node.destroy_node()
rclpy.shutdown()

# %% [markdown] lang="en" name="who-moved" slide="slide"
# ## Which coordinates change?
#
# A new scene: the robot faces along the map's x again, and drives straight ahead at half a metre per second.
# A ball lies on the floor ahead of it. A cup stands on the robot's own tray.
#
# **Predict:** while the robot drives, whose coordinates change, the ball's or the cup's? In `map`? In `base_link`?

# %% [markdown] lang="ko" name="who-moved" slide="slide"
# ## 어느 숫자가 바뀔까요?
#
# 장면을 바꿉니다. 로봇은 다시 지도의 x 방향을 보고, 1초에 0.5미터씩 곧장 달립니다.
# 앞쪽 바닥에 공이 있고, 로봇의 쟁반 위에 컵이 있습니다.
#
# **예측해 봅시다.** 로봇이 달리는 동안 공과 컵 가운데 어느 쪽의 숫자가 바뀔까요? `map` 기준으로는? `base_link` 기준으로는?

# %% name="start-the-robot" tags=["collapsed"] slide="skip"
# Start the robot's nodes.
graph = lesson.new_graph()
drive = lesson.Drive([lesson.Leg(20.0, 0.5)], lesson.PlanarPose(0.5, -1.5, 0.0), start_ns=graph.now_ns)
robot = lesson.TeachingRobot(drive, bias=0.0, slip=0.0, correction_period_s=60.0)  # perfect wheels: this page is about frames and stamps
parts = ['robot_state_publisher', 'wheel_odometry', 'localization', 'object_detector', 'imu_driver']
nodes = lesson.launch(graph, robot, only=parts)

# %% name="ball-and-cup" tags=["predicted", "collapsed"] slide="fragment"
# Print where the ball and the cup are at three times.
map_p_ball, base_p_cup = (6.5, -1.5, 0.3), (-0.1, 0.0, 0.2)

poses_at = {t: robot.truth_at(seconds(t))['base_link'] for t in (2, 4, 6)}
print('           ball in map        ball in base_link   cup in map          cup in base_link')
for t, pose in poses_at.items():
    row = (map_p_ball, pose.inverse().apply(map_p_ball), pose.apply(base_p_cup), base_p_cup)
    print(f'at {t} s    ', '  '.join(lesson.fmt_all(point, digits=1) for point in row))

# %% [markdown] lang="en" name="ball-and-cup-seen" tags=["predicted"]
# The ball did not move, and its coordinates in `base_link` change. The cup moves with the robot, and its coordinates in `base_link` stay the same.
# "It is at rest, so its coordinates stay the same" is true only in frames in which it is at rest.
#
# The next figure shows the same three times.

# %% [markdown] lang="ko" name="ball-and-cup-seen" tags=["predicted"]
# 공은 움직이지 않았는데 `base_link` 기준 숫자는 줄어듭니다. 컵은 로봇과 함께 달리는데도 `base_link` 기준 숫자는 그대로입니다.
# “가만히 있으니 숫자도 그대로”라는 말은 그 물체가 가만히 있는 좌표계에서만 맞습니다.
#
# 다음은 그 세 시각의 그림입니다. *그림 읽기:* ball = 공, ahead = 로봇 앞으로 떨어진 거리.

# %% name="moments-picture" tags=["predicted", "collapsed"] slide="subslide"
# Draw the robot and the ball at these times.
lesson.draw_moments({f'{t} s': pose for t, pose in poses_at.items()}, map_p_ball, 'ball')

# %% [markdown] lang="en" name="in-3d" slide="subslide"
# ### The same in 3D
#
# Run the next two cells, drag to rotate the view, and move the slider below it to let the robot drive.
# The arrow goes from the robot to the ball. Its label shows the ball's coordinates in `base_link`. The cup moves with the robot.

# %% [markdown] lang="ko" name="in-3d" slide="subslide"
# ### 3D로 보기
#
# 다음 두 셀을 실행하고 마우스로 끌어 시점을 돌려 보세요. 아래 슬라이더를 움직이면 로봇이 달립니다.
# 화살표는 로봇에서 공으로 향하고, 화살표의 이름은 `base_link` 기준의 숫자입니다. 컵은 로봇에 실려 함께 갑니다. *그림 읽기:* ball = 공, cup = 컵.

# %% name="in-3d-scene" tags=["collapsed"] slide="skip"
# Prepare the 3D view.
scene = lesson.Scene(height_px=360)
scene.look(eye=(2.6, -6.2, 3.0), target=(3.5, -1.0, 0.1))
lesson.draw_frame(scene, 'map', Transform(), length_m=0.8)
lesson.draw_ball(scene, 'ball', map_p_ball)


def at_time(t):
    pose = robot.truth_at(seconds(t))['base_link']
    lesson.draw_body(scene, robot, seconds(t))
    lesson.draw_frame(scene, 'base_link', pose, parent='map', length_m=0.5)
    lesson.draw_mug(scene, 'cup', pose.apply(base_p_cup), 'cup', height_m=0.14)
    said = lesson.fmt_all(pose.inverse().apply(map_p_ball), digits=1)
    lesson.draw_arrow(scene, 'way to the ball', pose.translation, map_p_ball, said, lesson.ACCENT)

# %% name="in-3d-drive" tags=["interactive", "collapsed"]
# Show the 3D view.
scene.sweep('time', [2.0 + 0.25 * i for i in range(25)], at_time, unit='s')
scene

# %% name="in-3d-still" tags=["static"]
lesson.draw_scene({'map': Transform(), 'base_link': poses_at[4]}, {'ball': map_p_ball, 'cup': poses_at[4].apply(base_p_cup)},
                  size_inch=(4.9, 3.0))

# %% [markdown] lang="en" name="header" slide="slide"
# ## The header of a message
#
# The robot has a camera, and a node that finds the ball in its images. Each of its messages begins with a **header**: a frame and a [[stamp]].
# The stamp is the time of the measurement, on the robot's clock.
# The next cell subscribes to the node's [[topic]], `/detected_point`, and stores each message in `heard`, with the time of its arrival.

# %% [markdown] lang="ko" name="header" slide="slide"
# ## 메시지의 헤더
#
# 로봇에는 카메라가 있고, 영상에서 공을 찾는 노드가 있습니다. 이 노드의 메시지는 모두 <b>헤더(header)</b>로 시작합니다. 헤더에는 좌표계와 [[stamp|측정 시각(stamp)]]이 있습니다.
# 측정 시각은 로봇의 시계로 *언제 측정했는지* 나타냅니다.
# 다음 셀은 [[topic|토픽(topic)]] `/detected_point`를 구독하고, 받은 메시지를 도착한 시각과 함께 `heard`에 모읍니다.

# %% name="hear-the-ball"
heard = []  # (arrival [ns], message)


def on_point(message):
    heard.append((node.get_clock().now().nanoseconds, message))


rclpy.init()
node = Node('reader')
buffer = Buffer()
listener = TransformListener(buffer, node, spin_thread=True)
node.create_subscription(PointStamped, '/detected_point', on_point, 10)
graph.run(seconds=5.05)

# %% name="one-message" slide="-"
arrived_ns, seen = heard[-1]
print('frame_id ', seen.header.frame_id)
print('stamp    ', seen.header.stamp.sec, 's and', seen.header.stamp.nanosec, 'ns')
print(f'point     ({seen.point.x:.1f}, {seen.point.y:.1f}, {seen.point.z:.1f}) m')

# %% [markdown] lang="en" name="one-message-seen"
# In `camera_optical_frame` the ball is 3.5 m along **z**. In a camera's optical frame, z points forward (chapter 02). Without the frame name you would have placed the ball above the robot.
#
# Here are the same two fields of another message, from the IMU, a sensor that measures rotation and acceleration. **Predict:** at which time, in seconds, was it measured?

# %% [markdown] lang="ko" name="one-message-seen"
# `camera_optical_frame`에서 공은 **z** 방향으로 3.5 m에 있습니다. 카메라의 광학 좌표계에서는 z가 앞을 향합니다(02장). 헤더를 보지 않았다면 공이 로봇 위쪽에 있다고 여겼을 것입니다.
#
# 이번에는 IMU(로봇의 회전과 가속을 재는 센서) 메시지에서 같은 두 항목을 읽습니다. **예측해 봅시다.** 몇 초일까요?

# %% name="imu-header" slide="-"
# %ros2 topic echo /imu --once --field header

# %% [markdown] lang="en" name="imu-header-seen" tags=["predicted"]
# <details><summary>At which time?</summary>
#
# `nanosec` counts billionths of a second, so 58000000 is 0.058 s. The stamp is **6.058 s**, and not 6.58 s.
# As a decimal fraction, nanoseconds need nine digits: 6.058000000.
#
# </details>

# %% [markdown] lang="ko" name="imu-header-seen" tags=["predicted"]
# <details><summary>몇 초인가요?</summary>
#
# `nanosec`은 10억분의 1초를 셉니다. 58000000은 0.058초이므로 측정 시각은 6.58초가 아니라 **6.058초**입니다.
# 소수점 뒤에 쓸 때는 앞을 0으로 채워 아홉 자리로 만듭니다. 6.058000000입니다.
#
# </details>

# %% [markdown] lang="en" name="age" slide="slide"
# ## How old is it?
#
# The node takes 0.2 s to find a ball in an image. The message that you have is stamped 5.800 and arrived at 6.000.
# At the time of the stamp the ball was 3.60 m ahead of the robot, which drives at 0.5 m/s.
#
# **Predict:** how far ahead is the ball when the message arrives?

# %% [markdown] lang="ko" name="age" slide="slide"
# ## 얼마나 오래된 것일까요?
#
# 노드가 영상에서 공을 찾는 데 0.2초가 걸립니다. 앞에서 출력한 메시지의 측정 시각은 5.800초이고 도착한 시각은 6.000초입니다.
# 측정 시각에 공은 로봇 앞 3.60 m에 있었고, 로봇은 0.5 m/s로 달립니다.
#
# **예측해 봅시다.** 메시지가 도착했을 때 공은 로봇 앞 몇 미터에 있을까요?

# %% name="age-in-numbers" tags=["predicted"] slide="fragment"
from rclpy.time import Time

stamp_ns = Time.from_msg(seen.header.stamp).nanoseconds
age_s = (arrived_ns - stamp_ns) / 1e9
ahead_then = buffer.transform(seen, 'base_link').point.x
ahead_now = ahead_then - 0.5 * age_s  # towards the ball at 0.5 m/s
print(f'age {age_s:.3f} s, ahead at the stamp {ahead_then:.2f} m, ahead on arrival {ahead_now:.2f} m')

# %% [markdown] lang="en" name="age-seen" tags=["predicted"]
# 3.50 m: in 0.2 s the robot drove 0.1 m towards the ball. If you said 3.60, you kept the distance at the time of the stamp. If you said 3.70, you moved the robot backwards.
# The error equals the distance driven only if the robot drives straight. If it also rotates, distant points shift much further (chapter 08).

# %% [markdown] lang="ko" name="age-seen" tags=["predicted"]
# 3.50 m입니다. 0.2초 동안 로봇이 공 쪽으로 0.1 m 달렸습니다. 3.60이라고 했다면 측정 시각의 거리를 그대로 쓴 것이고, 3.70이라고 했다면 부호를 거꾸로 쓴 것입니다.
# 로봇이 곧게 달리면 달린 거리만큼만 어긋납니다. 그사이 로봇이 회전하면 멀리 있는 것은 훨씬 크게 어긋납니다(08장).

# %% [markdown] lang="en" name="age-notes" slide="notes"
# Draw it: a timeline for the camera, a timeline for the robot, and the 0.2 s between them.
# Ask who would have used 3.60 in a program.
# Then state the main point: the number was right, but it was right 0.2 s ago.

# %% [markdown] lang="ko" name="age-notes" slide="notes"
# 그려 봅니다.
# 카메라의 시간줄, 로봇의 시간줄, 그 사이의 0.2초입니다.
# 프로그램에 3.60을 그대로 썼을 사람이 있는지 묻습니다.
# 숫자는 측정한 시각에는 맞았습니다.
# 받은 시각에는 이미 틀립니다.

# %% [markdown] lang="en" name="topic-delay-why"
# The next command measures the age of each message: the time of arrival minus the stamp.

# %% [markdown] lang="ko" name="topic-delay-why"
# 다음 명령은 메시지마다 나이를 재어, 평균과 최소, 최대를 1초에 한 번 출력합니다. 나이는 메시지가 도착한 시각에서 측정 시각을 뺀 값입니다.

# %% name="topic-delay"
# %ros2 --for 2.2 topic delay /detected_point

# %% [markdown] lang="en" name="milk" slide="subslide"
# ### Milk and tins
#
# Coordinates in `base_link` are like milk, because they go bad. 3.60 m was true at 5.8 s, and is wrong on arrival.
# Coordinates in `map` are like tinned food, because they stay good. For an object at rest, (6.5, −1.5) stays correct.
# So transform a measurement into a frame in which it stays correct, **with the [[pose]] at its stamp**, and do it early.

# %% [markdown] lang="ko" name="milk" slide="subslide"
# ### 우유와 통조림
#
# `base_link` 기준의 숫자는 우유입니다. 3.60 m는 5.8초에는 맞았지만 도착했을 때는 이미 상했습니다.
# 가만히 있는 물체라면, 같은 위치를 `map` 기준으로 적은 (6.5, −1.5)는 통조림입니다. 상하지 않습니다.
# 그러니 측정값은 받는 대로, 시간이 지나도 값이 그대로인 좌표계 기준으로 바꾸십시오. 이때 **측정 시각의 [[pose|포즈(pose)]]를** 쓰십시오.

# %% name="keeps" slide="fragment"
point = buffer.transform(seen, 'map').point  # with the robot's pose at the stamp of the message
print(f'in map ({point.x:.2f}, {point.y:.2f}, {point.z:.2f}) m')

# %% [markdown] lang="en" name="contract" slide="slide"
# ## The contract
#
# > **A measurement is a value, a frame, and a stamp.**
# > The sender fills in frame and stamp at the time of the measurement. The receiver reads both, or rejects the message and reports it.
#
# Here is a receiver that keeps the contract. Read it aloud once.

# %% [markdown] lang="ko" name="contract" slide="slide"
# ## 약속
#
# > **측정값은 값, 좌표계, 측정 시각입니다.**
# > 보내는 쪽은 측정하는 순간에 좌표계와 측정 시각을 모두 채웁니다. 받는 쪽은 둘 다 확인합니다. 하나라도 없으면 거절하고 이유를 로그에 남깁니다.
#
# 받는 쪽의 약속을 지키는 함수입니다.

# %% name="careful-reader" slide="-"
def usable(message, now_ns, max_age_s=1.0):
    header = message.header
    if not header.frame_id:
        return 'rejected: no frame'
    if header.stamp.sec == 0 and header.stamp.nanosec == 0:
        return 'rejected: no stamp'
    age_s = (now_ns - Time.from_msg(header.stamp).nanoseconds) / 1e9
    if age_s > max_age_s:
        return f'rejected: {age_s:.1f} s old'
    return 'used'


print(usable(seen, arrived_ns), '|', usable(seen, arrived_ns + 3_000_000_000), '|', usable(PointStamped(), arrived_ns))

# %% [markdown] lang="en" name="contract-notes" slide="notes"
# Three calls, three results.
# Ask for a fourth message that this function accepts and should not: a stamp from the future, or a wrong frame name.
# Both are in the exercises. The second cannot be detected from one message alone.

# %% [markdown] lang="ko" name="contract-notes" slide="notes"
# 호출 세 번에 서로 다른 판정 세 가지가 나옵니다.
# 이 함수가 받아들이지만 거절해야 할 메시지를 물어봅니다.
# 측정 시각이 미래인 것과 좌표계 이름이 틀린 것입니다.
# 둘 다 연습 문제에 있고, 둘째는 메시지 하나만 보아서는 찾을 수 없습니다.

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it
#
# The next cells transform four messages, each with one mistake. Before you run each of them, predict: does TF2 raise an exception?
#
# (`%xmode Minimal` shows only the last line of an error, the one to read.)

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기
#
# 한 곳씩 망가뜨린 메시지 네 개를 차례로 변환합니다. 셀을 실행하기 전에 오류가 날지 예측해 보세요.
#
# (`%xmode Minimal`은 오류에서 꼭 읽어야 할 마지막 줄만 보여 줍니다.)

# %% name="errors-in-one-line" slide="skip"
# %xmode Minimal

# %% name="no-frame" tags=["raises-exception"]
from copy import deepcopy

nameless = deepcopy(seen)
nameless.header.frame_id = ''
buffer.transform(nameless, 'map')

# %% name="misspelt" tags=["raises-exception"]
misspelt = deepcopy(seen)
misspelt.header.frame_id = 'lazer_frame'
buffer.transform(misspelt, 'map')

# %% [markdown] lang="en" name="shouts"
# Both raise an exception, and both error texts name the faulty argument, `source_frame`.
# Now forget the stamp: TF2 takes a stamp of 0 as "the latest available".
#
# **Predict:** since the image was taken, the robot has driven 1.25 m. At which x does TF2 place the ball in `map`, and what does it report?

# %% [markdown] lang="ko" name="shouts"
# 둘 다 오류를 내며, 어느 이름이 문제인지 알려 줍니다.
# 이번에는 측정 시각을 빠뜨려 봅시다. TF2에서 측정 시각 0은 “가장 최근 것이면 된다”는 뜻입니다.
#
# **예측해 봅시다.** 촬영한 다음 로봇은 1.25 m를 달렸습니다. 공은 `map`의 어디에 놓이고, TF2는 무엇을 출력할까요?

# %% name="no-stamp" tags=["predicted"]
from builtin_interfaces.msg import Time as Stamp

timeless = deepcopy(seen)
timeless.header.stamp = Stamp()
for frame in ('base_link', 'map'):
    right, wrong = (buffer.transform(m, frame).point.x for m in (seen, timeless))
    print(f'x in {frame:<10} with its stamp {right:.2f} m   without {wrong:.2f} m')

# %% [markdown] lang="en" name="no-stamp-seen" tags=["predicted"]
# TF2 reports nothing, and the ball has moved forward with the robot. In `base_link` nothing changed: between the camera and the robot there is only a mount, and a mount is the same at all times.
#
# > Forget the frame, and TF2 raises an exception. Forget the stamp, and it does not.

# %% [markdown] lang="ko" name="no-stamp-seen" tags=["predicted"]
# 오류도 경고도 없고, 공은 로봇과 함께 앞으로 나아갔습니다. `base_link` 기준으로는 달라지지 않았습니다. 카메라와 로봇 사이에는 장착 변환만 있고, 장착 변환은 언제나 같기 때문입니다.
#
# > 좌표계를 빠뜨리면 TF2가 오류를 냅니다. 측정 시각을 빠뜨리면 아무 오류도 나지 않습니다.

# %% [markdown] lang="en" name="wrong-label-why"
# Last, overwrite the frame name, as the marker detector of the story did:

# %% [markdown] lang="ko" name="wrong-label-why"
# 마지막으로, 앞에서 본 프로그램처럼 좌표계 이름을 덮어써 봅시다.

# %% name="wrong-label"
relabelled = deepcopy(seen)
relabelled.header.frame_id = 'map'
point = buffer.transform(relabelled, 'map').point
print(f'in map ({point.x:.1f}, {point.y:.1f}, {point.z:.1f}) m')

# %% [markdown] lang="en" name="wrong-label-seen"
# The coordinates came back unchanged, because TF2 had to transform a point from `map` to `map`.
# The ball now hovers three and a half metres above the origin of the map, and no tool can detect from this message that the frame name is wrong.

# %% [markdown] lang="ko" name="wrong-label-seen"
# 숫자가 그대로 나왔습니다. TF2가 받은 요청은 `map` 기준의 점을 `map` 기준으로 바꾸라는 것이었습니다.
# 이제 공은 지도 원점 위 3.5미터에 떠 있고, 이 메시지 하나만 보고 이름표가 틀렸다는 것을 알아낼 도구는 없습니다.

# %% [markdown] lang="en" name="break-it-notes" slide="notes"
# Ask before each cell: will it raise an exception? Two do, two do not, and the two silent ones are the expensive ones.

# %% [markdown] lang="ko" name="break-it-notes" slide="notes"
# 셀마다 실행 전에 묻습니다. “오류가 날까요?” 둘은 나고 둘은 나지 않습니다. 실제로 큰 손해를 내는 것은 오류가 나지 않는 둘입니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# A message has `frame_id: 'base_link'`, a stamp of half a second ago, and (1.0, 0.0, 0.0): a box one metre ahead.
# The robot has been driving. You want to mark the box on the map. What do you do?
#
# 1. Transform it into `map` with the robot's *current* pose, because nothing is newer.
# 2. Transform it into `map` with the robot's pose at the *stamp*.
# 3. Reject it: half a second is too old.
# 4. Write `map` into its `frame_id`.
#
# <details><summary>I chose 1</summary>
#
# The box was a metre ahead of where the robot *was*. With the current pose you shift the box forward by the distance that the robot has driven since.
#
# </details>
# <details><summary>I chose 2</summary>
#
# Yes: the value, its frame and its stamp belong together. `buffer.transform(message, 'map')` does exactly this.
#
# </details>
# <details><summary>I chose 3</summary>
#
# If the box is at rest, its age does no harm: the pose at the stamp places it correctly. Reject a measurement that is older than the data in the buffer, and an old measurement of an object that moves by itself.
#
# </details>
# <details><summary>I chose 4</summary>
#
# That changes the frame name and leaves the coordinates: the box would be a metre from the origin of the map. It is the mistake of the story again.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 메시지에 `frame_id: 'base_link'`, 0.5초 전의 측정 시각, 그리고 (1.0, 0.0, 0.0)이 들어 있습니다. 1미터 앞의 상자입니다.
# 로봇은 그동안 달리고 있었습니다. 상자를 지도에 표시하려면 어떻게 합니까?
#
# 1. 로봇의 *지금* 포즈로 `map` 기준으로 바꿉니다. 가장 최근 것이기 때문입니다.
# 2. 로봇의 *측정 시각* 포즈로 `map` 기준으로 바꿉니다.
# 3. 거절합니다. 0.5초면 너무 오래되었습니다.
# 4. `frame_id`에 `map`이라고 씁니다.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 상자는 *측정 시각의* 로봇에서 1미터 앞에 있었습니다. 지금의 포즈를 쓰면 그사이 로봇이 달린 만큼 상자의 위치가 앞으로 어긋납니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 맞습니다. 값, 좌표계, 측정 시각은 언제나 함께 씁니다. `buffer.transform(message, 'map')`이 바로 이 일을 합니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 상자가 가만히 있다면 오래된 측정값도 쓸 수 있습니다. 측정 시각의 포즈로 바꾸면 제자리에 놓입니다. 거절할 것은 버퍼가 변환을 보관하는 시간보다 오래된 측정값, 그리고 스스로 움직이는 물체의 오래된 측정값입니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 이름표만 바뀌고 숫자는 그대로입니다. 상자는 지도 원점에서 1미터 떨어진 것이 됩니다. 이 장에서 이미 본 실수입니다.
#
# </details>

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# This node keeps the receiver's side of the contract. It checks each point that it receives, and publishes the usable ones on `/checked_point`. For every other point it logs the reason.
#
# ```python
# # tf_lab_py/careful_reader.py
# import rclpy
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
#
#
# class CarefulReader(Node):
#     def __init__(self):
#         super().__init__('careful_reader')
#         self.publisher = self.create_publisher(PointStamped, '/checked_point', 10)
#         self.create_subscription(PointStamped, '/detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         header = message.header
#         age = self.get_clock().now() - Time.from_msg(header.stamp)
#         if not header.frame_id:
#             self.get_logger().warning('rejected: no frame_id')
#         elif header.stamp.sec == 0 and header.stamp.nanosec == 0:
#             self.get_logger().warning('rejected: no stamp')
#         elif age > Duration(seconds=1.0):
#             self.get_logger().warning(f'rejected: {age.nanoseconds / 1e9:.1f} s old')
#         else:
#             self.publisher.publish(message)
#
#
# def main():
#     rclpy.init()
#     node = CarefulReader()
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
# Save it as `careful_reader.py`, and give it a point to read. In a terminal of JupyterLab:
#
# ```
# tflab run careful_reader.py --for 5 --with 'ros2 topic pub /detected_point geometry_msgs/msg/PointStamped "{header: {frame_id: laser_frame}, point: {x: 2.0}}"'
# ```
#
# The node rejects these points, because they have no stamp. Add `stamp: now,` before `frame_id`, and it publishes them.
# On a robot, start the node with `python3 careful_reader.py`. These commands show the header of a topic, and measure the age of its messages:
#
# ```
# ros2 topic echo /scan --once --field header
# ros2 topic delay /scan
# ```

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# 받는 쪽의 약속을 지키는 노드입니다. 받은 점을 하나씩 확인해 쓸 수 있는 것만 `/checked_point`에 발행하고, 나머지는 거절한 이유를 로그에 남깁니다.
#
# ```python
# # tf_lab_py/careful_reader.py
# import rclpy
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
#
#
# class CarefulReader(Node):
#     def __init__(self):
#         super().__init__('careful_reader')
#         self.publisher = self.create_publisher(PointStamped, '/checked_point', 10)
#         self.create_subscription(PointStamped, '/detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         header = message.header
#         age = self.get_clock().now() - Time.from_msg(header.stamp)
#         if not header.frame_id:
#             self.get_logger().warning('rejected: no frame_id')
#         elif header.stamp.sec == 0 and header.stamp.nanosec == 0:
#             self.get_logger().warning('rejected: no stamp')
#         elif age > Duration(seconds=1.0):
#             self.get_logger().warning(f'rejected: {age.nanoseconds / 1e9:.1f} s old')
#         else:
#             self.publisher.publish(message)
#
#
# def main():
#     rclpy.init()
#     node = CarefulReader()
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
# `careful_reader.py`로 저장하고, 확인할 점을 보내 보세요. JupyterLab의 터미널에서 입력합니다.
#
# ```
# tflab run careful_reader.py --for 5 --with 'ros2 topic pub /detected_point geometry_msgs/msg/PointStamped "{header: {frame_id: laser_frame}, point: {x: 2.0}}"'
# ```
#
# 이 점에는 측정 시각이 없으므로 노드가 거절합니다. `frame_id` 앞에 `stamp: now,`를 더하면 노드가 다시 발행합니다.
# 실제 로봇에서는 `python3 careful_reader.py`로 실행합니다. 다음 명령은 토픽의 헤더를 보여 주고, 메시지의 나이를 잽니다.
#
# ```
# ros2 topic echo /scan --once --field header
# ros2 topic delay /scan
# ```

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - Three numbers are a position only with a [[frame]] and a [[stamp]].
# - One position has different coordinates in each frame. Adding works only as long as no frame is rotated.
# - An object keeps its coordinates in the frames in which it is at rest, and only there.
# - `nanosec` has nine digits. The age of a measurement is the current time minus the stamp.
# - TF2 raises an exception if the frame is missing or unknown. If the stamp is missing, or the frame is another known one, it reports nothing.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - 숫자 세 개는 [[frame|좌표계]]와 [[stamp|측정 시각]]이 있어야 위치가 됩니다.
# - 한 위치의 숫자는 좌표계마다 다릅니다. 더하기는 회전이 없을 때만 맞습니다.
# - 물체의 숫자는 그 물체가 가만히 있는 좌표계에서만 그대로입니다.
# - `nanosec`은 아홉 자리입니다. 나이는 지금 시각에서 측정 시각을 뺀 것입니다.
# - 좌표계가 비어 있거나 버퍼에 없는 이름이면 TF2가 오류를 냅니다. 측정 시각이 없거나, 버퍼에 있는 다른 좌표계의 이름을 잘못 적으면 아무 오류도 나지 않습니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > "The camera saw the ball at (0, 0.1, 3.5)." Write the two questions that you ask before you use it. For each, say what goes wrong if nobody asks.
#
# <details><summary>Compare</summary>
#
# *In which frame?* Otherwise the ball may hover above the origin of the map. *When?* Otherwise the ball moves with the robot.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > “카메라가 (0, 0.1, 3.5)에서 공을 보았습니다.” 이 숫자를 쓰기 전에 확인해야 할 두 가지를 적고, 확인하지 않으면 각각 어떤 일이 생기는지 적어 보세요.
#
# <details><summary>맞춰 보기</summary>
#
# *어느 좌표계 기준인가?* 확인하지 않으면 공이 지도 원점 위에 떠 있습니다. *언제 측정했는가?* 확인하지 않으면 공이 로봇을 따라 움직입니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Collect the tickets. If the second question is missing on many, begin the next lecture with the cell that raised no exception.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 쪽지를 걷습니다. 둘째 질문을 빠뜨린 쪽지가 많으면 다음 강의를 측정 시각 0으로 조회한 셀부터 시작합니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now name the three parts of a measurement, express one position in several frames, calculate the age of a message, and reject incomplete data.
# **Now the exercise:** [01 Value, frame and stamp](../../exercises/en/E01_value_frame_stamp.ipynb). The next chapter is [02 Axes and quaternions](02_axes_and_quaternions.ipynb): which way is forward? On the path for one evening, go on with [03 Target and source](03_target_and_source.ipynb).
#
# The sections below are optional: a panel in which you move the robot, a message with two blanks, practice question Q1, and a note for those who know the lecture.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 측정값에 꼭 필요한 세 가지를 말하고, 한 위치를 여러 좌표계 기준으로 나타내고, 메시지의 나이를 계산하고, 빠진 것이 있는 데이터를 거절할 수 있습니다.
# **이제 연습 문제를 풀어 보세요:** [01 값, 좌표계, 측정 시각](../../exercises/ko/E01_value_frame_stamp.ipynb). 다음 장은 [02 좌표축과 쿼터니언](02_axes_and_quaternions.ipynb)입니다. 어느 축이 앞이고, 회전은 어떻게 적을까요? 하룻저녁 코스라면 [03 목표 좌표계와 원본 좌표계](03_target_and_source.ipynb)로 갑니다.
#
# 아래는 더 연습하거나 더 알고 싶을 때 보는 절입니다. 로봇을 움직여 보는 패널, 빈칸이 두 개 있는 메시지, 서술형 문제 Q1, 강의를 들은 사람을 위한 설명이 있습니다.

# %% [markdown] lang="en" name="rulers" slide="slide"
# ## Move the robot: whose coordinates change?

# %% [markdown] lang="ko" name="rulers" slide="slide"
# ## 직접 해 보세요: 로봇을 움직이면 어느 숫자가 바뀔까요

# %% [markdown] lang="en" name="rulers-try" slide="-"
# Move the robot, rotate it, and move the object. Then put the object on the tray instead of the floor.
# *same* and *changed* compare the coordinates with those at the start, before you moved anything. When you put the object on the tray, its position there becomes the new start. Can you change the coordinates in `laser_frame`, and in no other frame?

# %% [markdown] lang="ko" name="rulers-try" slide="-"
# 로봇을 옮기고 회전시키고, 물체를 옮겨 보세요. 그다음 물체를 바닥이 아니라 쟁반에 놓아 보세요.
# same과 changed는 로봇과 물체를 움직이기 전과 비교한 결과입니다. 쟁반을 고르면 쟁반 위의 처음 자리와 비교합니다. `laser_frame`의 숫자만 바꿀 수 있을까요?

# %% [markdown] lang="en" name="rulers-notes" slide="notes"
# Give the mouse to a student.
# The important question is the last one: can only the coordinates in `laser_frame` change?
# They cannot, as long as nobody loosens a screw, because the laser is fixed to the base.

# %% [markdown] lang="ko" name="rulers-notes" slide="notes"
# 마우스를 한 사람에게 넘깁니다.
# 마지막 질문의 답이 나올 때까지 기다립니다.
# 레이저의 숫자만 바뀔 수 있을까요?
# 나사를 풀지 않는 한 그럴 수 없습니다.
# 레이저와 몸체는 함께 고정되어 있습니다.

# %% name="rulers-panel" tags=["interactive", "collapsed"]
# Show the panel.
lesson.rulers_panel()

# %% name="rulers-still" tags=["static"]
lesson.rulers_panel().picture

# %% [markdown] lang="en" name="rulers-answer"
# <details><summary>Can you?</summary>
#
# No. The laser is fixed to the robot, so the coordinates in `laser_frame` and in `base_link` change together. They differ by an offset that never changes. That is why such an offset is sent only once.
#
# </details>

# %% [markdown] lang="ko" name="rulers-answer"
# <details><summary>바꿀 수 있나요?</summary>
#
# 없습니다. 레이저는 로봇에 고정되어 있으므로 `laser_frame`의 숫자가 바뀌면 `base_link`의 숫자도 바뀝니다. 두 숫자의 차이는 언제나 레이저의 장착 위치입니다. 변하지 않는 값이므로 한 번만 발행하면 됩니다.
#
# </details>

# %% [markdown] lang="en" name="faded-heading" slide="slide"
# ## Fill in the blanks: a message that others can use

# %% [markdown] lang="ko" name="faded-heading" slide="slide"
# ## 빈칸을 채워 보세요: 누구나 쓸 수 있는 메시지

# %% [markdown] lang="en" name="faded" slide="-"
# Fill in both blanks, so that a receiver can use this message. A range finder that points along the x of `laser_frame` measured 1.4 m at `measured`. The program runs this line at `now`, 50 ms later.
#
# ```python
# message.header.frame_id = ____________
# message.header.stamp = ____________.to_msg()
# message.point.x = 1.4
# ```
#
# <details><summary>Compare</summary>
#
# The frame is `'laser_frame'`, because the 1.4 m are measured along its x. The stamp is `measured`, not `now`. With `now` your message would claim that the measurement is 50 ms newer than it is, and no receiver could find out.
#
# </details>

# %% [markdown] lang="ko" name="faded" slide="-"
# 이 메시지를 읽는 누구나 쓸 수 있도록 빈칸 두 개를 채워 보세요. 거리 센서는 `laser_frame`의 x 방향을 보고, `measured`에 1.4 m를 측정했습니다. 프로그램은 50 ms가 지난 `now`에 이 줄을 실행합니다.
#
# ```python
# message.header.frame_id = ____________
# message.header.stamp = ____________.to_msg()
# message.point.x = 1.4
# ```
#
# <details><summary>맞춰 보기</summary>
#
# `'laser_frame'`입니다. 1.4는 그 좌표계의 x를 따라 잰 값입니다. 시각은 `now`가 아니라 `measured`입니다. `now`를 적으면 실제보다 최근의 측정값처럼 보이고, 받는 쪽은 알아낼 방법이 없습니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="slide"
# ## Practice question · Q1

# %% [markdown] lang="ko" name="practice-heading" slide="slide"
# ## 서술형 문제 · Q1

# %% [markdown] lang="en" name="practice" slide="-"
# A node gives you `(2.0, 0.0, 0.0)` and nothing else. What can you do with it, and what do you ask its author to change?
# Write four or five sentences, then open the list and give yourself a point for each idea.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] Alone it is not a position: it may be ahead of the laser, ahead of the robot, or near the origin of the map.
# - [ ] A frame is needed (`header.frame_id`): the origin and the axes of the coordinates.
# - [ ] A stamp is needed (`header.stamp`): the time of the measurement, not of sending or of arrival.
# - [ ] With both, TF can express it in any connected frame, with the poses at that time.
# - [ ] Without them you reject it and report it. A guess gives a wrong position and no error.
#
# Four or five: you could teach it. Two or three: read "The contract" again. Fewer: do the predictions again, with a pencil.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# 어느 노드가 `(2.0, 0.0, 0.0)`만 건네줍니다. 이 숫자로 무엇을 할 수 있고, 만든 사람에게 무엇을 고쳐 달라고 하겠습니까?
# 네다섯 문장으로 쓴 다음, 목록을 펼쳐 스스로 채점해 보세요. 아래 내용이 하나 들어 있을 때마다 1점입니다.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 숫자만으로는 위치가 아닙니다. 레이저 앞일 수도, 로봇 앞일 수도, 지도 원점 옆일 수도 있습니다.
# - [ ] 좌표계(`header.frame_id`)가 필요합니다. 어느 원점에서 어느 축을 따라 잰 값인지 알려 줍니다.
# - [ ] 측정 시각(`header.stamp`)이 필요합니다. 보낸 때나 도착한 때가 아니라 측정한 때입니다.
# - [ ] 둘이 있으면 TF가 그 시각의 포즈를 써서, 트리로 연결된 어느 좌표계 기준으로든 바꿀 수 있습니다.
# - [ ] 없으면 거절하고 이유를 남깁니다. 짐작하면 오류 없이 틀린 위치가 나옵니다.
#
# 네 개 이상이면 남을 가르칠 수 있습니다. 두세 개면 “약속”을 다시 읽어 보세요. 그보다 적으면 예측부터 다시 해 보세요.
#
# </details>

# %% [markdown] lang="en" name="lecture-heading" slide="skip"
# ## If you know the lecture: why z is not 0.3 here

# %% [markdown] lang="ko" name="lecture-heading" slide="skip"
# ## 강의를 들었다면: 여기서는 왜 z가 0.3이 아닐까요

# %% [markdown] lang="en" name="lecture-z" slide="skip"
# The lecture's first example has the ball at (2.2, 0, 0.3) in `base_link` and (8.4, −1.7, 0.3) in `map`. It comes before the lecture introduces its robot.
# Later the lecture mounts the laser 0.15 m up, as here. Then a ball straight ahead of the laser is 0.15 m above the centre. In `map`, the height of the robot's centre, 0.10 m, is added as well.
# This workbook uses the robot of the later examples throughout.

# %% [markdown] lang="ko" name="lecture-z" slide="skip"
# 강의의 첫 예에서 공은 `base_link` 기준 (2.2, 0, 0.3), `map` 기준 (8.4, −1.7, 0.3)에 있습니다. 이때는 로봇을 아직 정하지 않았습니다.
# 강의 뒷부분에서는 여기처럼 레이저를 중심보다 0.15 m 위에 답니다. 그러면 레이저 정면의 공도 중심보다 0.15 m 위에 있고, `map` 기준에서는 중심의 높이 0.10 m도 더합니다.
# 이 워크북은 끝까지 그 로봇 하나를 씁니다.

# %% name="stop" tags=["collapsed"] slide="skip"
# Stop the nodes.
graph.stop()
node.destroy_node()
rclpy.shutdown()
