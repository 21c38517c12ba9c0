# %% [markdown] lang="en" name="title" slide="slide"
# # 06 · Static and dynamic
#
# **Publish it once, or all the time?** · about 35 minutes · builds on 03 and 04
#
# After this chapter you can
#
# - decide for each edge whether it belongs on `/tf_static` or on `/tf`, and say what the wrong choice costs,
# - say what a late listener receives, and what remains when a publisher stops,
# - publish a [[static transform]] from the command line, and both kinds from Python,
# - find out that a robot slides sideways although RViz shows a perfect circle.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 06 · 정적 변환과 동적 변환
#
# **한 번만 발행할까요, 계속 발행할까요?** · 약 35분 · 03, 04장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 연결마다 `/tf_static`과 `/tf` 가운데 어디에 발행할지 정하고, 잘못 골랐을 때 무엇을 잃는지 설명할 수 있습니다.
# - 나중에 참가한 수신기가 무엇을 받는지, 발행자가 멈추면 무엇이 남는지 설명할 수 있습니다.
# - [[static transform|정적 변환(static transform)]]을 명령줄에서 발행하고, 두 종류를 모두 파이썬으로 발행할 수 있습니다.
# - RViz에서는 완벽한 원을 그리는 로봇이 사실은 옆으로 미끄러지고 있음을 알아낼 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Two pictures are enough for this chapter: a notice board and a radio. Ask: how do you tell a class something that never changes, if people come in late? And something that changes all the time?

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 이 시간은 비유 두 개로 진행합니다. 게시판과 라디오입니다. 먼저 묻습니다. 변하지 않는 소식을 나중에 오는 사람에게도 알리려면 어떻게 할까요? 끊임없이 변하는 소식은 어떻게 할까요?

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## Four cameras, until RViz is opened again
#
# A program calibrates the mounts of four cameras in a room, one after the other, and publishes each when it is done. RViz shows them all.
# Then somebody closes RViz and opens it again: cameras are missing (Ikerlan-KER/extrinsic_calibrator, 2025).
# Somebody sent a hundred frames in a loop and had the same problem, and the library was changed because of it (ros2/geometry2, 2023).
#
# Another driver did the opposite. It published its laser's mount about 110 times a second, so that RViz would not report it as old (ouster-ros, 2023).
# The first published too little, the second too much. This chapter shows what is right.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 카메라 네 대, 그리고 다시 연 RViz
#
# 어느 프로그램이 방에 고정한 카메라의 위치를 하나씩 구해, 구하는 대로 발행합니다. RViz에는 모두 보입니다.
# 그런데 RViz를 닫았다가 다시 열면 보이지 않는 카메라가 있습니다(Ikerlan-KER/extrinsic_calibrator, 2025년).
#
# 좌표계 100개를 반복문으로 보낸 사람도 같은 일을 겪었고, 그 때문에 라이브러리 자체가 바뀌었습니다(ros2/geometry2, 2023년).
# 반대로 너무 자주 보낸 드라이버도 있습니다. RViz가 값이 오래되었다고 표시할까 봐, 고정된 레이저의 장착 변환을 1초에 110번쯤 보냈습니다(ouster-ros, 2023년).
#
# 앞의 두 프로그램은 한 번씩만 보냈고, 이 드라이버는 쉬지 않고 보냈습니다. 이 장은 무엇을 얼마나 자주 발행할지 다룹니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Ask who has closed RViz and opened it again because something was missing.
# Here that made it worse.
# Collect guesses: where are the missing cameras stored?

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 무언가 보이지 않아 RViz를 껐다 켜 본 사람이 있는지 묻습니다.
# 여기서는 그래서 더 나빠졌습니다.
# 보이지 않는 카메라의 변환은 어디에 남아 있을까요?
# 추측을 모읍니다.

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* extrinsic_calibrator [1](https://github.com/Ikerlan-KER/extrinsic_calibrator/issues/1), [2](https://github.com/Ikerlan-KER/extrinsic_calibrator/pull/2); geometry2 [585](https://github.com/ros2/geometry2/issues/585), [634](https://github.com/ros2/geometry2/pull/634); ouster-ros [105](https://github.com/ouster-lidar/ouster-ros/issues/105).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* extrinsic_calibrator [1](https://github.com/Ikerlan-KER/extrinsic_calibrator/issues/1), [2](https://github.com/Ikerlan-KER/extrinsic_calibrator/pull/2), geometry2 [585](https://github.com/ros2/geometry2/issues/585), [634](https://github.com/ros2/geometry2/pull/634), ouster-ros [105](https://github.com/ouster-lidar/ouster-ros/issues/105).

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# 1. Four cameras were sent on `/tf_static`, each in a message of its own. Then RViz is opened. **How many** of them does it receive: none, one or all four?
# 2. The program is stopped with Ctrl-C. **Which listeners** still have the cameras: all, none, or those that received them before?
# 3. A lift rises for two seconds to 0.5 m and publishes its height. At 3 s it stops publishing. It stays where it is. A node looks up its height at 5 s. **What** is the answer?
# 4. The lecture's robot drives a circle. **In which direction** does it drive in its own frame: forward, backward, left or right?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 1. 카메라 네 대의 변환을 `/tf_static`에 메시지 하나씩 따로 보냈습니다. 그 뒤에 연 RViz는 카메라 **몇 대**의 변환을 받을까요? 0대일까요, 한 대일까요, 네 대일까요?
# 2. 프로그램을 Ctrl-C로 멈춥니다. 카메라의 변환이 **어디에** 아직 남아 있을까요? 모든 노드일까요, 어디에도 없을까요, 이미 받은 노드뿐일까요?
# 3. 리프트가 2초 동안 0.5 m까지 올라가며 높이를 발행하다가 3초에 발행을 멈춥니다. 높이는 그대로입니다. 5초의 높이를 조회하면 **어떤 결과**가 나올까요?
# 4. 강의의 로봇이 원을 그리며 달립니다. 로봇을 기준으로 **어느 쪽**으로 움직일까요? 앞, 뒤, 왼쪽, 오른쪽 가운데 골라 보세요.

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Ask for a show of hands for each. Write the numbers on the board and leave them there: you need each of them again. For question 4 nearly everybody says forward.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 네 번 손을 들게 하고 숫자를 칠판에 남겨 둡니다. 하나씩 다시 나옵니다. 4번에는 거의 모두가 앞이라고 합니다.

# %% name="my-guess" slide="skip"
cameras_known, who_still_knows, height_at_5_s, drives = ..., ..., ..., ...

# %% [markdown] lang="en" name="board" slide="slide"
# ## The notice board
#
# A mount does not change, so one message is enough, if it is kept for listeners that join later.
# That is what `/tf_static` is for. Think of a **notice board**: each publisher has one, and its last message hangs there. A listener that joins reads the board first.
#
# The board is a part of the [[qos|quality of service]] of a publisher. Its ROS name is durability, and the value is [[transient local|TRANSIENT_LOCAL]]. The `depth` is the number of messages that it keeps. tf2's publishers on `/tf_static` use **one**.
#
# Here is the program of the story. `placed` fills in the message: parent, child, position and rotation.

# %% [markdown] lang="ko" name="board" slide="slide"
# ## 게시판
#
# 고정된 것은 움직이지 않으므로 메시지 하나로 충분합니다. 나중에 참가하는 수신기를 위해 남겨 두기만 하면 됩니다.
# `/tf_static`이 바로 그런 토픽입니다. 이 워크북에서는 이것을 게시판에 비유합니다. 발행자마다 **게시판**이 하나씩 있고, 보낸 메시지가 거기에 붙어 있습니다. 새로 온 수신기는 게시판부터 읽습니다.
#
# 게시판을 둘지는 [[qos|서비스 품질(QoS)]]로 정합니다. 메시지를 어떻게 전달할지 정하는 설정들입니다. 그 가운데 게시판에 관한 것은 지속성(durability)이고 값은 [[transient local|TRANSIENT_LOCAL]]입니다. 게시판에 메시지를 몇 개까지 남길지는 `depth`로 정합니다. `/tf_static`에서는 **하나**입니다.
#
# 다음은 이야기 속의 프로그램입니다. `placed`는 메시지에 부모, 자식, 위치, 회전을 채웁니다.

# %% name="imports" tags=["collapsed"] slide="skip"
# Import what this page needs.
import math
import time

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformException, TransformListener

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, seconds

# %% name="a-bolt" slide="skip"
def placed(node, parent, child, x=0.0, y=0.0, z=0.0, yaw=0.0):
    """Return a message that says where `child` is in `parent`, stamped now."""
    message = TransformStamped()
    message.header.stamp = node.get_clock().now().to_msg()
    message.header.frame_id, message.child_frame_id = parent, child
    message.transform.translation.x, message.transform.translation.y, message.transform.translation.z = x, y, z
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return message

# %% name="calibrator"
def calibrator():
    rclpy.init()
    node = Node('calibrator')
    board = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)  # as /tf_static has it
    publisher = node.create_publisher(TFMessage, '/tf_static', board)
    for number in range(1, 5):
        publisher.publish(TFMessage(transforms=[placed(node, 'base_link', f'camera_{number}')]))
        time.sleep(0.25)
    rclpy.spin(node)

# %% name="listen" tags=["collapsed"]
# Define listen(), which creates a listener.
def listen(name):
    node = Node(name)
    buffer = Buffer()
    node.listener = TransformListener(buffer, node, spin_thread=True)
    graph.run(seconds=0.5)
    return buffer

# %% [markdown] lang="en" name="early-and-late"
# Two listeners join, each a node with a `Buffer` and a `TransformListener`. `early` exists before the program starts, `late` joins when all four have been sent.
# (`graph` is this page's simulation, and `graph.run` lets simulated time pass. `listen` creates a listener.)

# %% [markdown] lang="ko" name="early-and-late"
# 수신기 둘이 참가합니다. 저마다 `Buffer`와 `TransformListener`가 있는 노드입니다. `early`는 프로그램보다 먼저 참가해 있고, `late`는 네 개를 모두 보낸 뒤에 참가합니다.
# (`graph`는 이 페이지 안에 있는 가상의 ROS 2 환경이고, `graph.run`은 가상 시간을 흐르게 합니다. `listen`은 수신기를 만듭니다.)

# %% name="two-listeners" tags=["predicted", "collapsed"] slide="fragment"
# Start both listeners and the program.
graph = lesson.new_graph()
rclpy.try_shutdown()
rclpy.init()
early = listen('early')
calibrating = graph.start(calibrator, name='calibrator')
graph.run(seconds=1.5)
late = listen('late')
print('early:', *early.all_frames_as_string().splitlines(), sep='\n')
print('late:', *late.all_frames_as_string().splitlines(), sep='\n')

# %% [markdown] lang="en" name="two-listeners-seen" tags=["predicted"]
# `early` has four cameras, `late` has **one**, as RViz had in the story. Not zero, because there is a board. Not four, because the board keeps only the last message.
#
# The next figure shows the same. A circle is a message; it is filled if the listener received it. The strip shows what the board holds.

# %% [markdown] lang="ko" name="two-listeners-seen" tags=["predicted"]
# `early`는 카메라 네 대를, `late`는 **한 대**를 받았습니다. 이야기 속의 RViz도 한 대만 받았습니다. 게시판이 있으므로 0대는 아닙니다. 게시판에는 마지막 메시지만 남으므로 네 대도 아닙니다.
#
# *그림 읽기:* 동그라미는 메시지이고, 채워진 것은 수신기가 받은 것입니다. 띠는 게시판이고 stored는 거기에 붙어 있는 것입니다. join = 참가한 시각, listener knows = 수신기가 받은 것, time = 시각.

# %% [markdown] lang="en" name="two-listeners-notes" slide="notes"
# Do it with paper: four notes, one nail.
# Each new note covers the last.
# Somebody who comes in now reads one.
# Not zero, and not four: both halves of the class were wrong in their own way.

# %% [markdown] lang="ko" name="two-listeners-notes" slide="notes"
# 종이로 해 봅니다.
# 쪽지 네 장에 못 하나입니다.
# 새 쪽지는 앞의 것 위에 겁니다.
# 지금 들어온 사람은 한 장을 읽습니다.
# 답은 0이나 4가 아닙니다.
# 0이라고 한 사람도 4라고 한 사람도 이유를 확인합니다.

# %% name="late-join" tags=["predicted", "collapsed"] slide="-"
# Draw the messages and the board.
letters = tuple(lesson.Letter(1.5 + 0.25 * i, (f'camera_{i + 1}',)) for i in range(4))
one_by_one = lesson.Sender('calibrator', letters)
lesson.draw_joins([one_by_one], join_s=3.0, until_s=6.0)

# %% [markdown] lang="en" name="all-at-once" slide="subslide"
# ### The fix: all in one message
#
# `StaticTransformBroadcaster` is the [[broadcaster]] that has such a board, and `sendTransform` takes a list. So collect first, and send once.

# %% [markdown] lang="ko" name="all-at-once" slide="subslide"
# ### 고치는 방법: 한 메시지에 모두
#
# `StaticTransformBroadcaster`가 바로 이 게시판을 만드는 ROS 2의 [[broadcaster|발행기(broadcaster)]]이고, `sendTransform`은 리스트를 받습니다. 모두 모은 다음 한 번에 보내면 됩니다.

# %% name="all-in-one" slide="-"
def all_in_one():
    rclpy.init()
    node = Node('calibrator')
    cameras = [placed(node, 'base_link', f'camera_{number}') for number in range(1, 5)]
    StaticTransformBroadcaster(node).sendTransform(cameras)
    rclpy.spin(node)

# %% name="all-in-one-run" tags=["collapsed"] slide="-"
# Run it, and let a listener join.
graph.stop(calibrating)
calibrating = graph.start(all_in_one, name='calibrator')
later = listen('later')
print(later.all_frames_as_string())

# %% [markdown] lang="en" name="who-holds-it" slide="slide"
# ## The board belongs to its publisher
#
# Now the program is stopped, as if with Ctrl-C. `later` has received the cameras. `newcomer` joins after the end.

# %% [markdown] lang="ko" name="who-holds-it" slide="slide"
# ## 게시판은 발행자에게 달려 있습니다
#
# 이제 프로그램을 Ctrl-C처럼 멈춥니다. `later`는 카메라의 변환을 이미 받았고, `newcomer`는 멈춘 뒤에 참가합니다.

# %% name="ctrl-c" tags=["predicted"] slide="fragment"
graph.stop(calibrating)
graph.run(seconds=1.0)
newcomer = listen('newcomer')
answer = later.lookup_transform('base_link', 'camera_4', Time(seconds=1000))
print('later, for 1000 s:', answer.child_frame_id, 'in', answer.header.frame_id)
print('newcomer knows:', newcomer.all_frames_as_string().splitlines())

# %% name="count-publishers" tags=["predicted"] slide="-"
# %ros2 topic info /tf_static

# %% [markdown] lang="en" name="ctrl-c-seen" tags=["predicted"]
# Nothing "in ROS" stores a static transform. The board is in the publisher's process and ends with it: `Publisher count: 0`.
# A listener that received the message keeps it, for all times, even for 1000 s. A listener that joins later receives nothing.
#
# So a static publisher has to stay alive. That is why the first file in *On a real robot* sends its one message and then calls `spin`, which keeps it alive. "Late listeners receive it" is true while the publisher lives.
#
# And this is what `newcomer` raises if you look up a camera:

# %% [markdown] lang="ko" name="ctrl-c-seen" tags=["predicted"]
# 정적 변환을 “ROS가” 어딘가에 저장해 두는 것이 아닙니다. 게시판은 발행자의 프로세스 안에 있고, 프로세스가 끝나면 함께 사라집니다. `Publisher count: 0`이 그 뜻입니다.
# 이미 받은 수신기에는 변환이 남아 있습니다. 1000초의 변환을 조회해도 값이 나옵니다. 나중에 참가한 수신기는 아무것도 받지 못합니다.
#
# 그래서 정적 변환의 발행자는 계속 실행되고 있어야 합니다. *실제 로봇에서* 절의 첫 파일이 메시지 하나를 보낸 뒤에 `spin`만 하는 것도 이 때문입니다. “나중에 참가한 구독자도 받는다”는 말은 발행자가 실행 중인 동안에만 맞습니다.
#
# 아무것도 받지 못한 `newcomer`에서 카메라의 변환을 조회하면 다음 오류가 납니다.

# %% [markdown] lang="en" name="ctrl-c-notes" slide="notes"
# Take the board off the wall and carry it out with you.
# Those who read it still know; those who come in now find an empty wall.
# Ask what that means for a launch file whose static publisher has crashed.

# %% [markdown] lang="ko" name="ctrl-c-notes" slide="notes"
# 게시판을 벽에서 떼어 들고 나갑니다.
# 이미 읽은 사람은 내용을 알고, 지금 들어온 사람은 빈 벽을 봅니다. launch 파일의 정적 발행자가 종료되면 어떻게 될지 묻습니다.

# %% name="a-newcomer-asks" slide="-"
try:
    newcomer.lookup_transform('base_link', 'camera_1', Time())
except TransformException as error:
    print(f'{type(error).__name__}: {error}')

# %% [markdown] lang="en" name="volatile" slide="slide"
# ## Break it: a publisher without a board
#
# A driver publishes its mount on `/tf_static`, with a plain publisher: `create_publisher(TFMessage, '/tf_static', 1)`.
# Its durability is the default, VOLATILE: no board. tf2's listener requests the board.
#
# **Predict:** the listener exists *before* the driver sends. Does it receive the message?

# %% [markdown] lang="ko" name="volatile" slide="slide"
# ## 일부러 고장 내기: 게시판 없는 발행자
#
# 어느 드라이버가 장착 변환을 `/tf_static`에 보통의 발행기로 보냅니다. `create_publisher(TFMessage, '/tf_static', 1)`입니다.
# 지속성은 기본값인 VOLATILE이라 게시판이 없습니다. 그런데 tf2의 수신기는 게시판을 요구합니다.
#
# **예측해 봅시다.** 수신기는 드라이버가 보내기 *전부터* 참가해 있습니다. 메시지를 받을까요?

# %% name="a-volatile-driver" tags=["predicted", "collapsed"] slide="fragment"
def driver():
    rclpy.init()
    node = Node('driver')
    publisher = node.create_publisher(TFMessage, '/tf_static', 1)
    publisher.publish(TFMessage(transforms=[placed(node, 'base_link', 'laser_frame', x=0.20, z=0.15)]))
    rclpy.spin(node)


graph = lesson.new_graph()
rclpy.try_shutdown()
rclpy.init()
early = listen('early')
graph.start(driver, name='driver')
graph.run(seconds=1.0)
print('early knows:', early.all_frames_as_string().splitlines())

# %% [markdown] lang="en" name="volatile-seen" tags=["predicted"]
# No frame at all. The publisher offers less than the listener requests, so the two are never connected. Sender and listener both need the board. Each prints one warning, which contains `DURABILITY`.
# The error that you meet later reports only that a frame does not exist. Look for this warning first.
#
# Now it is your turn. Drag `join` from left to right, and watch what the listener receives. Then let it request VOLATILE.
#
# - When do the four cameras of the first timeline disappear, one after the other?
# - For which timeline does it not matter when you join? For which one does the board not matter?

# %% [markdown] lang="ko" name="volatile-seen" tags=["predicted"]
# 좌표계를 하나도 받지 못했습니다. 발행자가 제공하는 지속성이 수신기가 요구하는 것보다 낮아서 통신이 아예 성립하지 않습니다. 게시판은 발행자와 수신기 모두 설정해야 합니다. 양쪽 모두 `DURABILITY`라는 경고를 한 번 내고, 그 경고는 화면 위로 밀려 올라갑니다.
# 나중에 나오는 오류 메시지에는 좌표계가 없다고만 적혀 있습니다. 이 경고부터 찾으십시오.
#
# 이제 직접 해 볼 차례입니다. 참가 시각을 왼쪽에서 오른쪽으로 끌며 수신기가 받는 것을 읽어 보세요. 그다음에는 VOLATILE을 골라 보세요.
#
# - 첫 줄의 카메라 네 대는 언제 하나씩 사라질까요?
# - 언제 참가해도 결과가 같은 줄은 어느 것일까요? 게시판과 상관없는 줄은 어느 것일까요?
#
# *그림 읽기:* calibrator = 하나씩 보내는 발행자(×에서 끝남), all_in_one = 한 번에 보내는 발행자, driver = 게시판이 없는 발행자, wheels = `/tf`로 계속 보내는 발행자, join = 참가 시각, durability = 지속성, incompatible QoS = 서비스 품질이 맞지 않음.

# %% [markdown] lang="en" name="volatile-notes" slide="notes"
# The warning is the only hint, and it is printed once.
# Show where it is, then ask for the error that somebody will send you a week later.
# It reports that a frame does not exist.

# %% [markdown] lang="ko" name="volatile-notes" slide="notes"
# 단서는 경고뿐이고 한 번만 지나갑니다.
# 어디에 나오는지 보여 준 다음, 일주일 뒤 누군가 보내올 오류를 묻습니다.
# 좌표계가 없다는 오류입니다.

# %% name="come-later" tags=["interactive", "collapsed"] slide="subslide"
# Show the panel.
cameras = ('camera_1', 'camera_2', 'camera_3', 'camera_4')
senders = (
    one_by_one._replace(ends_s=4.5),
    lesson.Sender('all_in_one', (lesson.Letter(1.5, cameras),)),
    lesson.Sender('driver', (lesson.Letter(1.5, ('laser_frame',)),), is_stored=False),
    lesson.Sender('wheels', tuple(lesson.Letter(0.5 * i, ('base_link',)) for i in range(1, 12)), None, False, '/tf'),
)
lesson.joins_panel(senders, join_s=1.0, until_s=6.0)

# %% name="come-later-still" tags=["static"]
lesson.draw_joins(senders, join_s=3.0, until_s=6.0)

# %% [markdown] lang="en" name="come-later-answers" slide="fragment"
# <details><summary>Answers</summary>
#
# Each camera disappears as soon as you join after the *next* message: 1.75, 2.0, 2.25 s; the last one when the process ends, at 4.5 s.
# For `all_in_one` it does not matter when you join, as long as you request the board. `wheels` has no board: you receive what is sent from now on, and that is enough, because it is sent again and again.
# With VOLATILE the driver's message is received by listeners that joined before it was sent.
#
# </details>

# %% [markdown] lang="ko" name="come-later-answers" slide="fragment"
# <details><summary>답</summary>
#
# *다음* 카메라의 메시지가 나온 뒤에 참가하면 이전 카메라의 변환은 받지 못합니다. 1.75초, 2.0초, 2.25초이고, 마지막 카메라는 프로세스가 끝나는 4.5초에 사라집니다.
# `all_in_one`의 변환은 수신기가 게시판을 요구하기만 하면 언제 참가해도 모두 받습니다. `wheels`에는 게시판이 없습니다. 참가한 뒤에 나오는 메시지만 받지만, 계속 나오므로 그것으로 충분합니다.
# VOLATILE을 고르면 드라이버의 메시지도 받습니다. 다만 보내기 전에 참가해 있어야 합니다.
#
# </details>

# %% [markdown] lang="en" name="command-line" slide="slide"
# ## The board from the command line
#
# For one mount you do not need a program. This is the lecture's command: 0.20 m in front of `base_link`, 0.15 m up.

# %% [markdown] lang="ko" name="command-line" slide="slide"
# ## 명령줄에서 게시판 만들기
#
# 장착 변환 하나 때문에 프로그램을 작성할 필요는 없습니다. 다음은 강의의 명령입니다. `base_link`에서 앞으로 0.20 m, 위로 0.15 m입니다.

# %% name="static-by-command" slide="-"
graph = lesson.new_graph()
# %ros2 run tf2_ros static_transform_publisher \
# --x 0.20 --y 0.0 --z 0.15 \
# --roll 0.0 --pitch 0.0 --yaw 0.0 \
# --frame-id base_link \
# --child-frame-id laser_frame

# %% [markdown] lang="en" name="radio" slide="slide"
# ## The radio
#
# A transform that changes is published on `/tf`, again and again, each time stamped with the time at which it is true: a [[dynamic transform]]. Think of a radio: there is no board. A listener that joins late waits for the next message, at 20 Hz at most 0.05 s.
# Here is the lecture's robot on its circle, 20 times a second.

# %% [markdown] lang="ko" name="radio" slide="slide"
# ## 라디오
#
# 움직이는 것은 `/tf`로 계속 발행합니다. 메시지마다 그 값이 어느 시각의 것인지 적혀 있습니다. 이것이 [[dynamic transform|동적 변환(dynamic transform)]]입니다. 라디오 방송처럼, 보관되는 것이 없습니다. 나중에 참가한 수신기는 다음 메시지를 기다리면 됩니다. 20 Hz라면 길어야 0.05초입니다.
#
# 강의의 로봇이 1초에 스무 번 포즈를 발행하며 원을 그립니다.

# %% name="moving-robot"
class MovingRobotBroadcaster(Node):
    heading = 0.0  # [rad]; the lecture's

    def __init__(self):
        super().__init__('moving_robot_broadcaster')
        self.broadcaster = TransformBroadcaster(self)
        self.theta = 0.0
        self.timer = self.create_timer(0.05, self.tick)

    def tick(self):
        self.theta += 0.01
        x, y = math.cos(self.theta), math.sin(self.theta)
        self.broadcaster.sendTransform(placed(self, 'odom', 'base_link', x, y, yaw=self.theta + self.heading))

# %% name="drive-the-circle" tags=["collapsed"]
# Start the robot and a listener, and draw the tree.
def run(node_class):
    rclpy.init()
    rclpy.spin(node_class())


graph.start(run, MovingRobotBroadcaster, name='moving_robot_broadcaster')
rclpy.try_shutdown()
rclpy.init()
listener = listen('listener')
graph.run(seconds=5.0)
lesson.frame_tree(graph, seconds=1.0)

# %% [markdown] lang="en" name="radio-seen"
# **S** is static, with a board and no rate; **D** is dynamic, with a rate and an age. On the right is the publisher: each edge has one owner.
# The rate of 20 Hz is shown as 21.1, because the samples are divided by the time from the first to the last.
#
# And this is what the listener keeps: of `/tf` the last ten seconds, each [[sample]] at its stamp; of `/tf_static` one value, valid at all times.

# %% [markdown] lang="ko" name="radio-seen"
# *그림 읽기:* **S**(static)는 정적, **D**(dynamic)는 동적입니다. rate = 발행률(1초에 몇 번), age = 나이, published by = 발행자. 연결마다 발행자는 하나입니다.
# 20 Hz가 21.1 Hz로 나오는 것은 표본의 수를 첫 표본부터 마지막 표본까지의 시간으로 나누기 때문입니다.
#
# 다음은 수신기의 버퍼에 있는 것입니다. `/tf`는 최근 10초의 [[sample|표본]]이 저마다 측정 시각 자리에 있고, `/tf_static`은 값 하나가 어느 시각에나 유효합니다. *그림 읽기:* stamp = 측정 시각, all of them = 모든 시간줄에 값이 있는 구간. 맨 아래는 요청 시각의 변환을 조회한 결과입니다.

# %% name="radio-history" tags=["collapsed"] slide="subslide"
# Draw the listener's buffer.
lesson.draw_history(listener, 'odom', 'laser_frame', graph.now_ns - seconds(0.5))

# %% [markdown] lang="en" name="lift" slide="slide"
# ## No message does not mean no motion
#
# A lift rises from 1 s to 3 s, up to 0.5 m, and publishes its height 20 times a second. Then it stops. Its program publishes nothing more, because nothing changes.
# (`BufferCore` is what a listener fills; here we fill it ourselves.)

# %% [markdown] lang="ko" name="lift" slide="slide"
# ## 메시지가 없다고 멈춰 있는 것은 아닙니다
#
# 리프트가 1초부터 3초까지 0.5 m를 올라가며 1초에 스무 번 높이를 발행합니다. 그런 다음 멈춥니다. 높이가 그대로이므로 프로그램은 더 발행하지 않습니다.
# (`BufferCore`는 수신기가 채우는 버퍼입니다. 여기서는 직접 채웁니다.)

# %% name="lift-rises" tags=["collapsed"] slide="-"
# Fill a buffer with the heights of the lift.
def height_at(t):
    return StampedTransform('base_link', 'lift', seconds(t), Transform((0.0, 0.0, 0.25 * (t - 1.0))))


lift = BufferCore()
for k in range(41):
    lift.set_transform(height_at(1.0 + 0.05 * k))

# %% name="lift-latest" tags=["predicted"] slide="fragment"
newest = lift.lookup_transform('base_link', 'lift', LATEST)
print('the latest:', lesson.fmt(newest.transform.translation[2]), 'of second', newest.stamp_ns / 1e9)

# %% name="lift-at-five" tags=["predicted"] slide="-"
try:
    lift.lookup_transform('base_link', 'lift', seconds(5.0))
except TransformException as error:
    print(f'{type(error).__name__}: {error}')

# %% [markdown] lang="en" name="lift-seen" tags=["predicted"]
# For "the latest" you get 0.5 m, with the stamp 3 s. For 5 s you get an exception: `into the future`. tf2 cannot distinguish a lift that stands still from one that moves without publishing, and it does not guess.
# A listener that joins late has even less: it has no frame `lift` at all.
#
# What can move is published again and again, also while it stands still.

# %% [markdown] lang="ko" name="lift-seen" tags=["predicted"]
# “최신”을 조회하면 3초의 값 0.5 m가 나옵니다. 5초를 조회하면 거절됩니다. `into the future`입니다. 리프트가 멈춰 있는지, 움직이는데 발행하지 않는지 tf2로서는 구별할 수 없고, 짐작하지도 않습니다.
# 그 뒤에 참가한 수신기는 사정이 더 나쁩니다. 리프트 좌표계조차 받지 못합니다.
#
# 메시지가 없다는 것만으로는 아무것도 알 수 없습니다. 움직일 수 있는 것은 멈춰 있는 동안에도 계속 발행해야 합니다.

# %% name="lift-history" tags=["predicted", "collapsed"] slide="subslide"
# Draw the buffer.
lesson.draw_history(lift, 'base_link', 'lift', seconds(5.0))

# %% [markdown] lang="en" name="bolt" slide="slide"
# ## A mount on the radio
#
# Then publish everything on `/tf`, to be safe? A camera is fixed to a robot that drives at 0.5 m/s. Its mount is published on `/tf`, once a second; the laser's mount is on a board.
# A hundred times in three seconds we look up "the latest" pose of each in `odom`.
#
# **Predict:** the camera does not move on the robot. How old is the answer at worst? And what does its track look like?

# %% [markdown] lang="ko" name="bolt" slide="slide"
# ## `/tf`로 보낸 고정 부품
#
# 그렇다면 안전하게 모두 `/tf`로 보내면 될까요? 0.5 m/s로 달리는 로봇에 카메라가 고정되어 있습니다. 카메라의 장착 변환은 `/tf`로 1초에 한 번 보내고, 레이저의 장착 변환은 게시판에 붙입니다.
# 3초 동안 백 번, `odom` 기준으로 두 센서의 “최신” 포즈를 조회합니다.
#
# **예측해 봅시다.** 카메라는 로봇 위에서 움직이지 않습니다. 조회한 값은 최악의 경우 몇 초 전의 것일까요? 카메라의 경로는 어떤 모양일까요?

# %% name="three-nodes" tags=["collapsed"] slide="skip"
# Define the node of the wheels.
class Wheels(Node):
    def __init__(self):
        super().__init__('wheels')
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.05, self.tick)

    def tick(self):
        x = 0.5 * self.get_clock().now().nanoseconds / 1e9
        self.broadcaster.sendTransform(placed(self, 'odom', 'base_link', x))

# %% name="mounts" slide="-"
class CameraMount(Node):
    def __init__(self):
        super().__init__('camera_mount')
        self.broadcaster = TransformBroadcaster(self)  # the wrong one
        self.create_timer(1.0, lambda: self.broadcaster.sendTransform(placed(self, 'base_link', 'camera_link', 0.1)))


class LaserMount(Node):
    def __init__(self):
        super().__init__('laser_mount')
        StaticTransformBroadcaster(self).sendTransform(placed(self, 'base_link', 'laser_frame', 0.2))

# %% name="start-the-mounts" tags=["collapsed"] slide="skip"
# Start the three nodes and a listener.
graph = lesson.new_graph()
for node_class in (Wheels, CameraMount, LaserMount):
    graph.start(run, node_class, name=node_class.__name__.lower())
rclpy.try_shutdown()
rclpy.init()
listener = listen('listener')
graph.run(seconds=2.5)

# %% name="hundred-questions" tags=["predicted", "collapsed"] slide="subslide"
# Look up both sensors a hundred times.
asked, age, where, refused = [], {'camera_link': [], 'laser_frame': []}, [], 0
for _ in range(100):
    graph.run(seconds=0.03)
    asked.append(graph.now_ns / 1e9)
    for frame, ages in age.items():
        answer = listener.core.lookup_transform('odom', frame, LATEST)
        ages.append(asked[-1] - answer.stamp_ns / 1e9)
    where.append(listener.core.lookup_transform('odom', 'camera_link', LATEST).transform.translation[0])
    a_tenth_ago = Time(nanoseconds=graph.now_ns - seconds(0.1))
    refused += not listener.can_transform('odom', 'camera_link', a_tenth_ago)
for frame, ages in age.items():
    print(f'{frame:<12} at worst {max(ages):.2f} s old')
print('camera places:', sorted({round(x, 2) for x in where}), '| 0.1 s back refused:', refused, 'of 100')

# %% name="draw-the-ages" tags=["predicted", "collapsed"] slide="-"
# Draw the age of each answer.
lesson.draw_ages([lesson.Curve(frame, asked, ages) for frame, ages in age.items()], 'age of the answer')

# %% [markdown] lang="en" name="bolt-seen" tags=["predicted"]
# The answer for the camera is up to a second old, and for the laser at most a twentieth of a second. The odometry is as fast as before. But "the latest" is the newest time for which **every** edge of the path has data, and the mount has new data only once a second.
# So the camera, which is screwed to the robot, jumps by half a metre each second, and nine of ten lookups for a tenth of a second ago raise an exception.
#
# A mount on `/tf` costs more than bandwidth: every lookup of *the latest* through it is up to a period old, and a lookup for a time just past raises an exception. Publishing it 110 times a second hides that, but loads the network. One message on a board fixes it.

# %% [markdown] lang="ko" name="bolt-seen" tags=["predicted"]
# *그림 읽기:* age of the answer = 조회한 값의 나이, time = 조회한 시각.
#
# 최악의 경우 1초 전의 값이 나옵니다. 레이저는 길어야 0.05초입니다. 바퀴 오도메트리는 여전히 자주 발행되지만, “최신”은 경로의 **모든** 연결에 값이 있는 가장 최근 시각이고, 장착 변환은 1초에 한 번만 발행됩니다.
# 그래서 로봇에 나사로 고정한 카메라가 1초마다 0.5 m씩 튑니다. 0.1초 전의 포즈를 조회하면 열 번 가운데 아홉 번은 거절됩니다.
#
# 고정 부품을 `/tf`로 보내면 통신량만 낭비하는 것이 아닙니다. 그 연결을 지나는 *최신* 조회의 값은 최대 한 주기만큼 오래된 것이고, 조금 전의 시각을 조회하면 예외가 발생합니다. 1초에 110번 보내면 문제가 드러나지 않지만 그만큼 통신량이 듭니다. 게시판의 메시지 하나면 됩니다.

# %% name="bolt-history" tags=["predicted", "collapsed"] slide="subslide"
# Draw the buffer.
graph.run(seconds=0.6)
lesson.draw_history(listener, 'odom', 'camera_link', graph.now_ns - seconds(0.1))

# %% [markdown] lang="en" name="mover" slide="slide"
# ## A moving frame on the board
#
# Now the opposite mistake: each height of the lift is sent as static. **Predict** what the buffer returns for 1, 3 and 6 s.

# %% [markdown] lang="ko" name="mover" slide="slide"
# ## 움직이는 것을 게시판에 붙이면
#
# 이번에는 반대입니다. 앞의 리프트가 높이를 모두 정적 변환으로 보냅니다. 1초, 3초, 6초의 높이를 조회하면 어떤 값이 나올지 **예측해 봅시다.**

# %% name="static-lift" tags=["predicted"] slide="fragment"
static_lift = BufferCore()
for k in range(41):
    static_lift.set_transform(height_at(1.0 + 0.05 * k), is_static=True)
for t in (1.0, 3.0, 6.0):
    print(t, 's:', lesson.fmt(static_lift.lookup_transform('base_link', 'lift', seconds(t)).transform.translation[2]))

# %% [markdown] lang="en" name="static-lift-seen" tags=["predicted"]
# The buffer returns 0.5 m for all times, also for 1 s, when the lift was at the bottom. A board has no past and no future: its last message is used for all times.
# There is no error message for that. If a link is sent once and then moves, RViz still shows it in its first pose.
#
# | the link | on the board `/tf_static` | on the radio `/tf` |
# |---|---|---|
# | is fixed | **right** | *the latest* through it is up to one period old |
# | moves | one pose for all times | **right**, if it never stops publishing |

# %% [markdown] lang="ko" name="static-lift-seen" tags=["predicted"]
# 어느 시각을 조회해도 0.5 m입니다. 바닥에 있던 1초의 높이까지 0.5 m로 나옵니다. 게시판에는 과거도 미래도 없습니다. 마지막 값이 모든 시각에 적용됩니다.
# 오류는 끝내 나지 않습니다. 높이를 한 번만 보낸 다음 리프트가 움직이면 RViz의 리프트는 처음 위치에 머물러 있습니다.
#
# | 연결 | 게시판 `/tf_static` | 라디오 `/tf` |
# |---|---|---|
# | 고정된 것 | **맞습니다** | 그 연결을 지나는 *최신* 조회의 값이 최대 한 주기만큼 오래된 것입니다 |
# | 움직이는 것 | 모든 시각에 같은 포즈가 나옵니다 | 멈춰도 계속 보내면 **맞습니다** |

# %% [markdown] lang="en" name="static-lift-notes" slide="notes"
# Fill the two-by-two table with the class, one cell at a time, each with the picture that showed it.
# The lower left one has no error message at all: ask how one would ever find it.

# %% [markdown] lang="ko" name="static-lift-notes" slide="notes"
# 두 칸씩 두 줄인 표를 함께 채웁니다.
# 칸마다 그것을 보여 준 그림을 떠올립니다.
# 왼쪽 아래 칸에는 오류 메시지가 아예 없습니다.
# 어떻게 찾아낼지 묻습니다.

# %% [markdown] lang="en" name="faded" slide="subslide"
# ### Now you write
#
# A robot has three cameras with fixed mounts, and a pan head that rotates. Fill in the two blanks.
#
# ```python
# mounts = [placed(node, 'base_link', f'camera_{i}') for i in (1, 2, 3)]
# ____________(node).sendTransform(______)
# self.create_timer(0.05, self.publish_pan_head)
# ```
#
# <details><summary>Compare</summary>
#
# `StaticTransformBroadcaster(node).sendTransform(mounts)`: the whole list, once. The pan head is published by a `TransformBroadcaster` in `publish_pan_head`, also while it stands still.
#
# </details>

# %% [markdown] lang="ko" name="faded" slide="subslide"
# ### 빈칸을 채워 보세요
#
# 로봇에 고정된 카메라 세 대와 좌우로 회전하는 팬 헤드가 있습니다. 빈칸 두 개를 채워 보세요.
#
# ```python
# mounts = [placed(node, 'base_link', f'camera_{i}') for i in (1, 2, 3)]
# ____________(node).sendTransform(______)
# self.create_timer(0.05, self.publish_pan_head)
# ```
#
# <details><summary>맞춰 보기</summary>
#
# `StaticTransformBroadcaster(node).sendTransform(mounts)`입니다. 리스트 전체를 한 번만 보냅니다. 팬 헤드는 `publish_pan_head` 안에서 `TransformBroadcaster`로 보내며, 멈춰 있는 동안에도 보냅니다.
#
# </details>

# %% [markdown] lang="en" name="crab" slide="slide"
# ## The crab
#
# Back to the lecture's robot. In RViz its circle looks perfect. But in which direction does it move in its own frame?
# Take the robot's pose at 4 s. Where is the robot one second later, in the `base_link` of 4 s?

# %% [markdown] lang="ko" name="crab" slide="slide"
# ## 게걸음
#
# 다시 강의의 로봇입니다. RViz에서 보면 훌륭한 원입니다. 그런데 로봇을 기준으로는 어디로 가고 있을까요?
# 5초의 로봇 위치를 *4초의* `base_link` 기준으로 적어 봅시다.

# %% name="drive-it" tags=["collapsed"] slide="skip"
# Define drive(), which runs a node for five seconds.
def drive(node_class):
    graph = lesson.new_graph()
    graph.start(run, node_class)
    rclpy.try_shutdown()
    rclpy.init()
    heard = Buffer()
    heard.listener = TransformListener(heard, Node('listener'), spin_thread=True)
    graph.run(seconds=5.0)
    return [heard.core.lookup_transform('odom', 'base_link', seconds(t)).transform for t in (4.0, 5.0)]


circle = [(math.cos(0.05 * k), math.sin(0.05 * k), 0.0) for k in range(127)]

# %% name="one-second-later" tags=["predicted"] slide="fragment"
then, later = drive(MovingRobotBroadcaster)  # odom_T_base at 4 s and at 5 s
step = then.inverse().apply(later.translation)
print('a second later, in base_link of 4 s:', lesson.fmt_all(step))

# %% name="crab-from-above" tags=["predicted", "collapsed"] slide="-"
# Draw both poses from above.
lesson.draw_moves({'base_link': (then, later)}, 'odom', ['base_link'], circle, length_m=0.15, before='at 4 s')

# %% [markdown] lang="en" name="crab-seen" tags=["predicted"]
# Two centimetres backward and twenty to the left: it slides **sideways**, like a crab, and faces outwards all the time. A robot with ordinary wheels cannot do that.
# The code sets `yaw = θ`. But θ is the angle of the *position* on the circle, seen from its centre. On a circle, forward is at right angles to that: `θ + π/2`.
#
# No tool reports an error, since each message is a valid pose. Only one question finds it: in which direction does the robot move *along its own axes*?
# In the figure the pointed end is the robot's front, its x axis, and the arrow is the move of one second. The arrow should go where the front points.

# %% [markdown] lang="ko" name="crab-seen" tags=["predicted"]
# *그림 읽기:* 위에서 본 그림입니다. 회색은 4초(grey: at 4 s), 검은색은 5초의 로봇이고 뾰족한 쪽이 앞, 곧 x축입니다. 화살표는 1초 동안 간 거리와 방향입니다. 화살표는 뾰족한 쪽으로 향해야 합니다.
#
# 뒤로 2센티미터, 왼쪽으로 20센티미터입니다. 로봇은 줄곧 바깥을 보면서 게처럼 **옆으로** 미끄러집니다. 보통의 바퀴로 달리는 로봇은 이렇게 움직일 수 없습니다.
#
# 코드에는 `yaw = θ`라고 적혀 있습니다. 그런데 θ는 원의 중심을 기준으로 한 *위치*의 각도입니다. 원 위에서 앞은 그 방향과 직각, 곧 `θ + π/2`입니다.
# 메시지 하나하나는 올바른 포즈이므로 어떤 도구에서도 오류가 나지 않습니다. 로봇이 *자기 축으로* 어디로 가는지 따져 보아야만 드러납니다.

# %% [markdown] lang="en" name="crab-notes" slide="notes"
# Before the numbers, show only the circle and ask what is wrong with it.
# In RViz, nothing.
# Then ask the one question that finds it: along its own axes, in which direction does it move?
# It is the lecture's own code; say so with a smile.

# %% [markdown] lang="ko" name="crab-notes" slide="notes"
# 숫자를 보여 주기 전에 원만 보여 주고 무엇이 잘못인지 묻습니다.
# RViz에서는 멀쩡합니다.
# 그다음 이것을 찾아내는 질문을 하나 합니다.
# 로봇은 자기 축으로 어디로 갑니까?
# 강의의 코드 그대로입니다.

# %% [markdown] lang="en" name="forward" slide="subslide"
# The fix is one number. In 3D: change the position on the circle, and compare the robot as written (grey) with the robot that drives forward.

# %% [markdown] lang="ko" name="forward" slide="subslide"
# 숫자 하나만 고치면 됩니다. 3D 장면에서 theta를 바꾸며 강의 코드의 로봇(회색)과 앞으로 달리는 로봇을 비교해 보세요.
#
# *그림 읽기:* theta = 원 위의 각도, as written = 강의 코드대로, forward = 앞으로 달리는 로봇, goes = 가는 방향.

# %% name="forward-robot" slide="-"
class ForwardRobot(MovingRobotBroadcaster):
    heading = math.pi / 2


then, later = drive(ForwardRobot)
step = then.inverse().apply(later.translation)
print('a second later, in base_link of 4 s:', lesson.fmt_all(step))

# %% name="crab-scene" tags=["interactive", "collapsed"]
scene = lesson.Scene(height_px=340)
scene.look(eye=(0.3, -2.5, 1.9), target=(0.1, -0.4, 0.0))
lesson.draw_path(scene, 'circle', circle, colour='#9AA0A6')


def at_angle(theta):
    place = (math.cos(theta), math.sin(theta), 0.0)
    ahead = (place[0] - 0.6 * math.sin(theta), place[1] + 0.6 * math.cos(theta), 0.0)
    lesson.draw_frame(scene, 'as written', Transform.from_rpy(yaw=theta, translation=place), length_m=0.4, is_ghost=True)
    lesson.draw_frame(scene, 'forward', Transform.from_rpy(yaw=theta + math.pi / 2, translation=place), length_m=0.3)
    lesson.draw_arrow(scene, 'goes', place, ahead, 'goes', lesson.ACCENT, radius_m=0.02)


scene.sweep('theta', [round(0.3 * k, 1) for k in range(22)], at_angle, unit='rad', start=15)
scene

# %% name="forward-still" tags=["static"]
lesson.draw_moves({'base_link': (then, later)}, 'odom', ['base_link'], circle, length_m=0.15, before='at 4 s')

# %% [markdown] lang="en" name="forward-notes" slide="notes"
# Let one person walk the circle, once facing outwards, once facing where they go. The class laughs at the first, and nobody forgets it.

# %% [markdown] lang="ko" name="forward-notes" slide="notes"
# 한 사람에게 원을 따라 걷게 합니다. 한 번은 바깥을 보면서, 한 번은 가는 쪽을 보면서 걷습니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# A lidar is mounted on a mast that moves up and down only while the robot is parked. Where does `base_link → laser_frame` belong?
#
# 1. On `/tf_static`: while the robot drives, it does not move.
# 2. On `/tf`, all the time.
# 3. On `/tf`, but only while the mast moves.
# 4. On `/tf_static`, sent again after each move.
#
# <details><summary>I chose 1</summary>
#
# "Not now" is not "never". Once the mast has moved, the board's single value is used for every scan, also for earlier ones.
#
# </details>
# <details><summary>I chose 2</summary>
#
# Yes. It can move, so it is published, also while it stands still.
#
# </details>
# <details><summary>I chose 3</summary>
#
# Then the path has no data once the mast stops publishing: later scans are rejected, `into the future`, and listeners that join late have no laser at all.
#
# </details>
# <details><summary>I chose 4</summary>
#
# Then a scan from before the move is transformed with the mount from after it: a board has no past. And on Jazzy a Python broadcaster ignores the second value.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 라이다가 마스트 위에 있고, 마스트는 로봇이 주차해 있을 때만 오르내립니다. `base_link → laser_frame`은 어디에 발행해야 합니까?
#
# 1. `/tf_static`: 달리는 동안에는 움직이지 않기 때문입니다.
# 2. `/tf`로 늘 보냅니다.
# 3. `/tf`로 보내되 마스트가 움직일 때만 보냅니다.
# 4. `/tf_static`으로 보내고, 움직일 때마다 다시 보냅니다.
#
# <details><summary>1번을 골랐습니다</summary>
#
# “지금은 움직이지 않는다”는 “절대 움직이지 않는다”와 다릅니다. 마스트가 한 번 움직이면 게시판의 값 하나가 이전 스캔까지 포함해 모든 스캔에 쓰입니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 맞습니다. 움직일 수 있으므로, 멈춰 있는 동안에도 발행합니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 마스트의 발행이 멈추면 그 뒤의 변환도 없습니다. 그 이후의 스캔은 `into the future`로 거절되고, 새로 참가한 수신기는 레이저 좌표계조차 받지 못합니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 움직이기 전에 측정한 스캔까지 움직인 뒤의 장착 변환으로 바뀝니다. 게시판에는 과거가 없습니다. 게다가 Jazzy의 파이썬 발행기는 두 번째 값을 무시합니다.
#
# </details>

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# ```
# ros2 topic info /tf_static --verbose      # the publishers, and the durability of each
# ros2 topic echo /tf_static                # every board; stop with Ctrl-C
# ros2 topic hz /tf                         # is it 20?
# ros2 run tf2_ros static_transform_publisher --help
# ```
#
# On your checklist this chapter is **C3** (a static transform from the command line and from Python) and **C4** (a dynamic transform from Python). Here it was simulated; do it once on the robot.
#
# The first command prints this for a driver without a board and a publisher with one. Compare their `Durability`.

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# ```
# ros2 topic info /tf_static --verbose      # 게시판이 있는 발행자와 지속성
# ros2 topic echo /tf_static                # 모든 게시판, Ctrl-C로 끝내기
# ros2 topic hz /tf                         # 20이 나오는지 확인
# ros2 run tf2_ros static_transform_publisher --help
# ```
#
# 실습 체크리스트에서 이 장은 **C3**(명령줄과 파이썬으로 발행한 정적 변환)과 **C4**(파이썬으로 발행한 동적 변환)입니다. 여기서는 시뮬레이션으로 했으니 로봇에서도 한 번 해 보세요.
#
# 첫 명령의 출력입니다. 게시판이 없는 발행자와 있는 발행자가 하나씩 있습니다. 둘의 `Durability`를 비교해 보세요.

# %% name="two-durabilities" slide="subslide"
graph = lesson.new_graph()
graph.start(driver, name='driver')
# %ros2 run tf2_ros static_transform_publisher --x 0.1 --frame-id base_link --child-frame-id camera_link
# %ros2 topic info /tf_static --verbose

# %% [markdown] lang="en" name="static-node" slide="skip"
# ### Two files to take home
#
# Save the first one as `static_sensor_broadcaster.py`. It creates a `TransformStamped`, fills in parent, child and numbers, and sends it once. `spin` keeps its board alive.
#
# ```python
# # tf_lab_py/static_sensor_broadcaster.py
# import rclpy
# from geometry_msgs.msg import TransformStamped
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
#
#
# class StaticSensorBroadcaster(Node):
#     def __init__(self):
#         super().__init__('static_sensor_broadcaster')
#         self.broadcaster = StaticTransformBroadcaster(self)
#         transform = TransformStamped()
#         transform.header.stamp = self.get_clock().now().to_msg()
#         transform.header.frame_id = 'base_link'
#         transform.child_frame_id = 'laser_frame'
#         transform.transform.translation.x = 0.20
#         transform.transform.translation.y = 0.0
#         transform.transform.translation.z = 0.15
#         transform.transform.rotation.x = 0.0
#         transform.transform.rotation.y = 0.0
#         transform.transform.rotation.z = 0.0
#         transform.transform.rotation.w = 1.0
#         self.broadcaster.sendTransform(transform)
#         self.get_logger().info('sent: base_link → laser_frame')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = StaticSensorBroadcaster()
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
# The mounts of a whole robot are better kept in its URDF, and published by one node from there: chapter 07. Never do both for one sensor.

# %% [markdown] lang="ko" name="static-node" slide="skip"
# ### 저장해서 쓸 파일 두 개
#
# 첫 파일을 `static_sensor_broadcaster.py`로 저장해 보세요. `TransformStamped`를 만들고, 부모와 자식과 숫자를 채우고, 한 번 보냅니다. `spin`이 실행되는 동안 게시판이 남아 있습니다.
#
# ```python
# # tf_lab_py/static_sensor_broadcaster.py
# import rclpy
# from geometry_msgs.msg import TransformStamped
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
#
#
# class StaticSensorBroadcaster(Node):
#     def __init__(self):
#         super().__init__('static_sensor_broadcaster')
#         self.broadcaster = StaticTransformBroadcaster(self)
#         transform = TransformStamped()
#         transform.header.stamp = self.get_clock().now().to_msg()
#         transform.header.frame_id = 'base_link'
#         transform.child_frame_id = 'laser_frame'
#         transform.transform.translation.x = 0.20
#         transform.transform.translation.y = 0.0
#         transform.transform.translation.z = 0.15
#         transform.transform.rotation.x = 0.0
#         transform.transform.rotation.y = 0.0
#         transform.transform.rotation.z = 0.0
#         transform.transform.rotation.w = 1.0
#         self.broadcaster.sendTransform(transform)
#         self.get_logger().info('sent: base_link → laser_frame')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = StaticSensorBroadcaster()
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
# 로봇 전체의 장착 변환은 URDF에 적고 노드 하나가 발행하는 편이 좋습니다(07장). 같은 센서의 장착 변환을 두 노드에서 발행하지는 마십시오.

# %% [markdown] lang="en" name="dynamic-node" slide="skip"
# Save the second one as `moving_robot_broadcaster.py`. It publishes the pose 20 times a second and drives forward.
#
# ```python
# # tf_lab_py/moving_robot_broadcaster.py
# import math
# import rclpy
# from geometry_msgs.msg import TransformStamped
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from tf2_ros import TransformBroadcaster
#
#
# class MovingRobotBroadcaster(Node):
#     def __init__(self):
#         super().__init__('moving_robot_broadcaster')
#         self.broadcaster = TransformBroadcaster(self)
#         self.theta = 0.0
#         self.timer = self.create_timer(0.05, self.tick)
#
#     def tick(self):
#         self.theta += 0.01
#         transform = TransformStamped()
#         transform.header.stamp = self.get_clock().now().to_msg()
#         transform.header.frame_id = 'odom'
#         transform.child_frame_id = 'base_link'
#         transform.transform.translation.x = math.cos(self.theta)
#         transform.transform.translation.y = math.sin(self.theta)
#         transform.transform.translation.z = 0.0
#         # forward on the circle, as a quaternion
#         transform.transform.rotation.z = math.sin((self.theta + math.pi / 2.0) / 2.0)
#         transform.transform.rotation.w = math.cos((self.theta + math.pi / 2.0) / 2.0)
#         self.broadcaster.sendTransform(transform)
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = MovingRobotBroadcaster()
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
# With ROS 2, start each with `python3`. Without ROS, start both in a terminal of JupyterLab, and look up the laser in `odom`:
#
# ```
# tflab run static_sensor_broadcaster.py moving_robot_broadcaster.py --with "ros2 run tf2_ros tf2_echo odom laser_frame"
# ```
#
# Ctrl-C stops them. Do not start the second one on a robot whose odometry is running: both would publish `odom → base_link`.
#
# Stamp a dynamic transform with the time of its *measurement*. This robot's pose is calculated in the callback, so `now()` is right here. If you stamp a sensor's measurement with the time at which a callback ran, you hide every delay before the callback.

# %% [markdown] lang="ko" name="dynamic-node" slide="skip"
# 둘째 파일을 `moving_robot_broadcaster.py`로 저장해 보세요. 1초에 스무 번 포즈를 발행하며 앞으로 달립니다.
#
# ```python
# # tf_lab_py/moving_robot_broadcaster.py
# import math
# import rclpy
# from geometry_msgs.msg import TransformStamped
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from tf2_ros import TransformBroadcaster
#
#
# class MovingRobotBroadcaster(Node):
#     def __init__(self):
#         super().__init__('moving_robot_broadcaster')
#         self.broadcaster = TransformBroadcaster(self)
#         self.theta = 0.0
#         self.timer = self.create_timer(0.05, self.tick)
#
#     def tick(self):
#         self.theta += 0.01
#         transform = TransformStamped()
#         transform.header.stamp = self.get_clock().now().to_msg()
#         transform.header.frame_id = 'odom'
#         transform.child_frame_id = 'base_link'
#         transform.transform.translation.x = math.cos(self.theta)
#         transform.transform.translation.y = math.sin(self.theta)
#         transform.transform.translation.z = 0.0
#         # forward on the circle, as a quaternion
#         transform.transform.rotation.z = math.sin((self.theta + math.pi / 2.0) / 2.0)
#         transform.transform.rotation.w = math.cos((self.theta + math.pi / 2.0) / 2.0)
#         self.broadcaster.sendTransform(transform)
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = MovingRobotBroadcaster()
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
# ROS 2가 있으면 `python3`로 하나씩 실행합니다. ROS가 없으면 JupyterLab의 터미널에서 둘을 함께 실행하고 `odom` 기준의 레이저를 조회합니다.
#
# ```
# tflab run static_sensor_broadcaster.py moving_robot_broadcaster.py --with "ros2 run tf2_ros tf2_echo odom laser_frame"
# ```
#
# Ctrl-C로 끝냅니다. 오도메트리 노드가 실행 중인 로봇에서는 둘째 파일을 실행하지 마십시오. 둘 다 `odom → base_link`를 발행하게 됩니다.
#
# 동적 변환에는 *측정한* 시각을 적습니다. 이 로봇의 포즈는 콜백 안에서 계산하므로 `now()`가 맞습니다. 센서로 잰 값에 콜백이 실행된 시각을 적으면 그때까지의 지연이 드러나지 않습니다.

# %% [markdown] lang="en" name="lecture-form" slide="skip"
# **The lecture's form.** Both files of the lecture end in this way:
#
# ```python
#     except KeyboardInterrupt:
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.shutdown()
# ```
#
# Since Humble, Ctrl-C shuts ROS down by itself, so a second shutdown in the last line raises an `RCLError`; `try_shutdown` does nothing then.
# The lecture's moving robot is the crab, because its heading is θ:
#
# ```python
#         transform.transform.rotation.z = math.sin(self.theta / 2.0)
#         transform.transform.rotation.w = math.cos(self.theta / 2.0)
# ```

# %% [markdown] lang="ko" name="lecture-form" slide="skip"
# **강의의 형태.** 강의의 두 파일은 이렇게 끝납니다.
#
# ```python
#     except KeyboardInterrupt:
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.shutdown()
# ```
#
# Humble부터는 Ctrl-C가 ROS를 직접 종료하므로, 마지막 줄에서 다시 종료하면 `RCLError`가 납니다. `try_shutdown`은 이때 아무것도 하지 않습니다.
# 강의의 움직이는 로봇은 방향이 θ라서 게걸음을 합니다.
#
# ```python
#         transform.transform.rotation.z = math.sin(self.theta / 2.0)
#         transform.transform.rotation.w = math.cos(self.theta / 2.0)
# ```

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - [[static transform|Static]]: a fixed mount, one message on `/tf_static`. [[dynamic transform|Dynamic]]: it can move, so it is published on `/tf` again and again, each time with its stamp.
# - A board keeps the **last message** of its publisher (`depth` 1, [[transient local|TRANSIENT_LOCAL]]), and ends with the publisher. So: one list, one call, and stay alive.
# - Sender and listener both need the board. A `DURABILITY` warning means: not connected at all.
# - No message does not mean no motion. With a mount on `/tf`, *the latest* through it is up to one period old. A moving frame on `/tf_static` has one pose for all times.
# - Each message can be right and the motion wrong. Check in which direction the robot moves along its own axes.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - 고정된 것은 [[static transform|정적 변환]]으로 `/tf_static`에 메시지 하나를 보냅니다. 움직일 수 있는 것은 [[dynamic transform|동적 변환]]으로 `/tf`에 측정 시각과 함께 계속 보냅니다.
# - 게시판에는 발행자의 **마지막 메시지**만 남고(`depth` 1, [[transient local|TRANSIENT_LOCAL]]), 발행자가 멈추면 사라집니다. 그러니 리스트 하나를 한 번에 보내고 발행자를 계속 실행해 두어야 합니다.
# - 발행자와 수신기 모두 게시판을 설정해야 합니다. `DURABILITY` 경고가 나오면 통신이 아예 성립하지 않은 것입니다.
# - 메시지가 없다고 멈춰 있는 것은 아닙니다. 고정된 것을 `/tf`로 보내면 *최신* 조회의 값이 최대 한 주기만큼 오래된 것이 됩니다. 움직이는 것을 게시판에 붙이면 모든 시각의 포즈가 같아집니다.
# - 메시지 하나하나가 맞아도 움직임은 틀릴 수 있습니다. 로봇이 자기 축으로 어디로 가는지 확인해 보세요.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > A friend starts RViz after the robot, and one sensor is missing. Which three causes from this chapter fit, and which command do you run first to tell them apart?
#
# <details><summary>Compare</summary>
#
# Several messages on one board, a publisher that has ended, a publisher without a board. `ros2 topic info /tf_static --verbose`: is the publisher there, and what is its durability? If both are right, `ros2 topic echo /tf_static` shows what is on the boards.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > 친구가 로봇을 시작하고 나중에 RViz를 켰더니 센서 하나가 보이지 않습니다. 이 장에서 배운 원인 가운데 들어맞는 셋은 무엇이고, 어느 명령으로 먼저 구별할 수 있습니까?
#
# <details><summary>맞춰 보기</summary>
#
# 한 게시판에 메시지를 여러 번 보냈거나, 발행자가 끝났거나, 발행자에게 게시판이 없습니다. `ros2 topic info /tf_static --verbose`로 발행자가 있는지, 지속성이 무엇인지 봅니다. 둘 다 문제가 없으면 `ros2 topic echo /tf_static`으로 게시판의 내용을 봅니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Three causes, one command.
# If somebody writes 'restart', return the paper with one question: which process?

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 원인 셋에 명령 하나입니다.
# ‘재시작’이라고 쓴 쪽지는 한마디를 적어 돌려줍니다.
# 어느 프로세스를?

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now choose the topic for each edge, publish both kinds from Python and a static one from the command line, and say what a listener receives that joins late.
#
# **Next:** the exercises, [E6 Static and dynamic](../../exercises/en/E06_static_and_dynamic.ipynb), and after them [07 URDF and sensors](07_urdf_and_sensors.ipynb), about the robot's own parts. Task E6.2 has lines like those of "Two mistakes on the command line" below.
# In the exercises, `solution("E6.1")` shows a solution after you have passed the task or tried three times. To start a page over, delete its file and type `tflab lab --copy-only` in a terminal of JupyterLab.
#
# The sections below are optional. Open a heading to see what it holds.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 연결마다 알맞은 토픽을 고르고, 두 종류를 파이썬으로, 정적 변환을 명령줄로 발행하고, 나중에 참가한 수신기가 무엇을 받는지 설명할 수 있습니다.
#
# **다음:** 연습 문제 [E6 정적 변환과 동적 변환](../../exercises/ko/E06_static_and_dynamic.ipynb)을 풀고 [07 URDF와 센서](07_urdf_and_sensors.ipynb)로 갑니다. 로봇의 부품이 어디에 붙어 있는지 알아봅니다. E6.2에는 아래의 “명령줄에서 하는 실수 두 가지”와 비슷한 명령이 나옵니다.
# 연습 문제에서는 통과하거나 세 번 시도한 뒤 `solution("E6.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 그 파일을 지우고 JupyterLab의 터미널에서 `tflab lab --copy-only`를 입력해 보세요.
#
# 아래는 더 알고 싶을 때 보는 부분입니다. 제목을 펼치면 내용이 나옵니다.

# %% [markdown] lang="en" name="in-a-loop-heading" slide="slide"
# ## sendTransform in a loop, by release

# %% [markdown] lang="ko" name="in-a-loop-heading" slide="slide"
# ## 반복문에서 sendTransform을 호출하면

# %% [markdown] lang="en" name="in-a-loop" slide="-"
# The result depends on the release: newer broadcasters put all that they sent before into each message. One broadcaster sends `camera_1`, `camera_2` … one at a time:
#
# | ROS 2, Python | a late listener receives | a child that is sent again |
# |---|---|---|
# | Humble | the last one | is the only one on the board |
# | Jazzy | all | is **ignored**: the old value stays |
# | Lyrical, and C++ everywhere | all | replaces the old value |
#
# One list in one call is right on all releases. On Jazzy, to publish a mount that was measured again, call `node.destroy_publisher(broadcaster.pub_tf)`, create a new broadcaster, and send all its mounts again.

# %% [markdown] lang="ko" name="in-a-loop" slide="-"
# 배포판에 따라 다릅니다. 새 배포판의 발행기는 메시지마다 앞서 보낸 변환까지 모두 담습니다. 발행기 하나로 `camera_1`, `camera_2` …를 하나씩 보낼 때의 결과입니다.
#
# | ROS 2, 파이썬 | 나중에 참가한 수신기가 받는 것 | 같은 자식을 다시 보내면 |
# |---|---|---|
# | Humble | 마지막 하나 | 그 하나만 게시판에 남습니다 |
# | Jazzy | 모두 | **무시됩니다**. 이전 값이 그대로 남습니다 |
# | Lyrical, 그리고 모든 배포판의 C++ | 모두 | 새 값으로 바뀝니다 |
#
# 리스트 하나를 한 번에 보내면 어느 배포판에서나 모두 받습니다. Jazzy에서 장착 변환을 다시 쟀다면 `node.destroy_publisher(broadcaster.pub_tf)`를 호출하고 발행기를 새로 만들어 장착 변환을 모두 다시 보내야 합니다.

# %% [markdown] lang="en" name="break-command" slide="slide"
# ## Two mistakes on the command line
#
# Two attempts to publish a camera that is rotated by 30°, 0.2 m ahead. **Predict** for each: an error, or something else?

# %% [markdown] lang="ko" name="break-command" slide="slide"
# ## 명령줄에서 하는 실수 두 가지
#
# 0.2 m 앞에 30° 회전시켜 장착한 카메라를 두 가지로 적었습니다. 각각 오류가 날지, 다른 일이 일어날지 **예측해 봅시다.**

# %% name="command-again" tags=["collapsed"] slide="skip"
# Publish the laser's mount again.
graph = lesson.new_graph()
# %ros2 run tf2_ros static_transform_publisher --x 0.20 --z 0.15 --frame-id base_link --child-frame-id laser_frame

# %% name="thirty" tags=["predicted"] slide="fragment"
# %ros2 run tf2_ros static_transform_publisher --x 0.2 --yaw 30 --frame-id base_link --child-frame-id camera_link
# %ros2 --for 1.2 run tf2_ros tf2_echo base_link camera_link

# %% name="equals-sign" tags=["predicted"] slide="subslide"
# %ros2 run tf2_ros static_transform_publisher --x=0.2 --yaw 0.52 --frame-id base_link --child-frame-id camera_link

# %% [markdown] lang="en" name="break-command-seen" tags=["predicted"]
# - `--yaw 30` is accepted without a warning: 30 **radians**, more than four full rotations. tf2_echo prints −81°. The command without an error is the harmful one.
# - `--x=0.2` is right in many other programs. This tool rejects it: write the option and its value as two words, `--x 0.2`.
# - A rotation is given once, as angles or as a quaternion. With `--qz` beside `--yaw` the tool prints `Cannot specify both quaternion and Euler rotations`.
#
# <details><summary>Deeper: the old order</summary>
#
# Old tutorials pass six numbers and two frames without option names: `x y z yaw pitch roll parent child`. Note that **yaw** comes first. It still works, with a warning, and one day it will not.
#
# </details>

# %% [markdown] lang="ko" name="break-command-seen" tags=["predicted"]
# - `--yaw 30`은 오류 없이 받아들여집니다. 30 **라디안**, 곧 네 번 회전하고도 279°를 더 회전합니다. tf2_echo에는 −81°로 나옵니다. 오류가 나지 않는 쪽이 더 위험합니다.
# - `--x=0.2`는 다른 프로그램에서는 대개 맞는 표기입니다. 여기서는 옵션과 값을 띄어 써야 합니다.
# - 회전은 각도와 쿼터니언 가운데 하나로만 적습니다. `--yaw`와 `--qz`를 함께 쓰면 `Cannot specify both quaternion and Euler rotations`라고 나옵니다.
#
# <details><summary>더 깊이: 예전의 순서</summary>
#
# 오래된 자료에는 옵션 없이 `x y z yaw pitch roll parent child`로 적혀 있습니다. **yaw**가 먼저임을 주의하십시오. 아직은 경고와 함께 동작하지만 언젠가는 사라집니다.
#
# </details>

# %% [markdown] lang="en" name="break-command-notes" slide="notes"
# Hands before each: error or not?
# The one without an error rotated the camera by more than four full rotations.
# Degrees are a strong habit; say radians aloud with every yaw today.

# %% [markdown] lang="ko" name="break-command-notes" slide="notes"
# 하나씩 손을 들게 합니다.
# 오류가 날까요?
# 오류 없이 지나간 쪽이 카메라를 네 번 넘게 회전시켰습니다.
# 라디안 자리에 도를 쓰는 것은 잘 고쳐지지 않는 버릇입니다.
# 이 시간에는 yaw를 말할 때마다 라디안을 붙입니다.

# %% [markdown] lang="en" name="echo-once" slide="subslide"
# ## All boards, and `topic echo --once`
#
# The laser and the camera of the last section have one publisher each, and you want to see both. The first command that everybody types is the lecture's `topic echo --once`. Try it, and then let it run for a second.

# %% [markdown] lang="ko" name="echo-once" slide="subslide"
# ## 게시판 전부와 `topic echo --once`
#
# 앞 절의 레이저와 카메라는 발행자가 하나씩이고, 둘 다 보고 싶습니다. 흔히 강의의 `topic echo --once`부터 입력합니다. 먼저 해 보고, 그다음에는 1초 동안 받아 보세요.

# %% name="echo-one-board" tags=["predicted"] slide="-"
# %ros2 topic echo /tf_static --once --flow-style
# %ros2 --for 1 topic echo /tf_static --flow-style

# %% [markdown] lang="en" name="echo-one-board-seen" tags=["predicted"]
# `--once` means one *message*, and there are two boards, one for each publisher. So the first command prints only one of the two mounts.

# %% [markdown] lang="ko" name="echo-one-board-seen" tags=["predicted"]
# `--once`는 *메시지* 하나라는 뜻이고 게시판은 둘입니다. 첫 번째 명령으로는 로봇의 절반만 본 셈입니다. 게시판은 발행자마다 따로 있습니다.

# %% name="stop" slide="skip"
graph.stop()
rclpy.try_shutdown()

# %% [markdown] lang="en" name="turtles-heading" slide="skip"
# ## The two turtles of the official tutorials

# %% [markdown] lang="ko" name="turtles-heading" slide="skip"
# ## 공식 튜토리얼의 거북이 두 마리

# %% [markdown] lang="en" name="turtles" slide="skip"
# The official tf2 tutorials drive turtles in turtlesim. `turtle2` looks up the transform to `turtle1`, and follows it. Their package `turtle_tf2_py` runs here unchanged (github.com/ros/geometry_tutorials, branch `ros2`). Put its folder beside this notebook, and run three cells:
#
# ```
# %ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py
# %ros2 --for 10 topic pub -r 10 -p 100 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2.0}, angular: {z: 1.8}}'
# %turtlesim
# ```
#
# The first cell starts turtlesim, two broadcasters and the listener. The second drives `turtle1` in a circle for ten seconds. The third draws the field and the lines of both pens. In a terminal, `tflab ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py` does the same as the first cell.

# %% [markdown] lang="ko" name="turtles" slide="skip"
# tf2 공식 튜토리얼은 turtlesim의 거북이를 씁니다. `turtle2`가 `turtle1`의 변환을 조회하면서 따라갑니다. 튜토리얼 패키지 `turtle_tf2_py`는 고치지 않고 여기서 그대로 실행할 수 있습니다(github.com/ros/geometry_tutorials의 `ros2` 브랜치). 패키지 폴더를 이 노트북 옆에 두고 셀 세 개를 실행해 보세요.
#
# ```
# %ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py
# %ros2 --for 10 topic pub -r 10 -p 100 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2.0}, angular: {z: 1.8}}'
# %turtlesim
# ```
#
# 첫째 셀은 turtlesim과 발행 노드 두 개, 조회하는 노드 하나를 시작합니다. 둘째 셀은 `turtle1`이 10초 동안 원을 그리며 움직이게 합니다. 셋째 셀은 두 거북이의 위치와 펜이 그린 선을 그림으로 보여 줍니다. 터미널에서는 `tflab ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py`가 첫째 셀과 같은 일을 합니다.

# %% [markdown] lang="en" name="from-before-heading" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# 1. `laser_frame` is 0.20 m in front of `base_link`. Which frame is the parent, and along whose axes are the 0.20 m measured?
# 2. You look up target `odom`, source `laser_frame`. Which edges are on the path, and which of them is static?
# 3. The crab was found with `then.inverse().apply(later.translation)`. In which frame are the coordinates that go in, and those that come out?
#
# <details><summary>Answers</summary>
#
# 1. Parent `base_link`, and along its axes.
# 2. `odom → base_link`, dynamic, and `base_link → laser_frame`, static.
# 3. `odom` goes in, `base_link` of 4 s comes out: `base_T_odom` applied to a point in `odom`.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# 1. `laser_frame`은 `base_link`에서 0.20 m 앞에 있습니다. 부모는 어느 좌표계이고, 0.20 m는 어느 좌표계의 축으로 잰 값입니까?
# 2. 목표 `odom`, 원본 `laser_frame`으로 조회합니다. 어느 연결을 지나며, 그 가운데 정적인 것은 무엇입니까?
# 3. 게걸음은 `then.inverse().apply(later.translation)`으로 알아냈습니다. 어느 좌표계의 좌표가 들어가고, 어느 좌표계의 좌표가 나옵니까?
#
# <details><summary>답</summary>
#
# 1. 부모는 `base_link`이고, `base_link`의 축으로 잽니다.
# 2. 동적인 `odom → base_link`와 정적인 `base_link → laser_frame`입니다.
# 3. `odom` 기준의 점이 들어가고 4초의 `base_link` 기준으로 나옵니다. `base_T_odom`을 `odom` 기준의 점에 적용한 것입니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice question · Q7

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제 · Q7

# %% [markdown] lang="en" name="practice" slide="-"
# **7.** How do `/tf` and `/tf_static` differ, in what they carry and in their QoS, and what happens to a transform on the wrong one? Write five sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] Static: never changes, `/tf_static`, sent once; durability TRANSIENT_LOCAL, so that late listeners receive it while the publisher lives.
# - [ ] Dynamic: changes, `/tf`, sent again and again, each with the stamp of its measurement.
# - [ ] A mount on `/tf` costs bandwidth and, worse, holds back the latest common time of its path.
# - [ ] A moving frame on `/tf_static` has one value for all times: the last one sent, or the first if it was sent only once.
# - [ ] A lookup for a time after the last message of a dynamic transform raises an exception; the frame is not assumed to stand still.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# **7.** `/tf`와 `/tf_static`은 데이터와 QoS 동작에서 어떻게 다르며, 변환을 다른 쪽 토픽으로 발행하면 어떤 일이 일어납니까? 다섯 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 정적: 변하지 않으며 `/tf_static`에 한 번 보냅니다. 지속성이 TRANSIENT_LOCAL이라, 발행자가 실행 중인 동안 나중에 참가한 수신기도 받습니다.
# - [ ] 동적: 변하므로 `/tf`에 계속 보내며, 메시지마다 측정 시각이 있습니다.
# - [ ] 고정된 것을 `/tf`로 보내면 통신량이 늘고, 더 큰 문제로 최신 공통 시각이 뒤처집니다.
# - [ ] 움직이는 것을 `/tf_static`으로 보내면 값 하나가 모든 시각에 쓰이거나 처음 위치에 고정됩니다.
# - [ ] 동적 변환의 발행이 멈추면 그 뒤의 시각은 거절됩니다. “멈춰 있는” 것으로 처리하지 않습니다.
#
# </details>
