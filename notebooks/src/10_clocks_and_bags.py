# %% [markdown] lang="en" name="title" slide="slide"
# # 10 · Clocks and bags
#
# **Which clock do the stamps come from?** · about 30 minutes · builds on 06, 08 and 09
#
# After this chapter you can
#
# - record a [[bag]] that contains the transforms for its own messages, and check it with one number,
# - say which time a node uses: system time, the bag's time, or a clock that stays at 0 ([[simulation time]]),
# - recognise a forgotten `--clock`, a node whose clock shows another day, and a bag that plays in a loop,
# - check a bag of your own on a robot.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 10 · 시계와 bag
#
# **측정 시각은 어느 시계의 시각일까요?** · 약 30분 · 06, 08, 09장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 담긴 변환만으로 센서 데이터를 지도에 표시할 수 있는 [[bag]]을 기록하고, 정말 그런지 숫자 하나로 확인할 수 있습니다.
# - 노드가 시스템 시간, bag의 시간([[simulation time|시뮬레이션 시간]]), 멈춘 시간 가운데 어느 것을 따르는지 말할 수 있습니다.
# - 빠뜨린 `--clock`, 다른 날짜의 시각을 쓰는 노드, 반복 재생되는 bag을 알아볼 수 있습니다.
# - 로봇에서 자신의 bag을 검사할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Ask first: you play yesterday's recording. What time is it? Two answers are right, and the nodes of a robot have to agree on one. 55 minutes: 11 up to the offset, 9 for one number, 15 for the two clocks and the node that reports the error, 8 for the loop, 6 for the vote and the robot's commands, 6 for the ticket and questions.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 먼저 묻습니다. 어제 기록한 것을 지금 재생합니다. 지금은 몇 시일까요? 어제라는 답도 오늘이라는 답도 맞습니다. 다만 한 로봇의 노드는 모두 같은 시간을 써야 합니다. 55분은 이렇게 나눕니다. ‘지루한 처음 1초 건너뛰기’까지 11분, ‘숫자 하나’ 9분, ‘두 시계’와 ‘오류를 내는 노드’ 15분, 반복 재생 8분, 투표와 로봇의 명령 6분, 쪽지와 질문 6분입니다.

# %% [markdown] lang="en" name="needed" slide="slide"
# ## What you need to begin
#
# - **Static transforms** (06) are sent once, on `/tf_static`. Their publisher keeps the message for listeners that join later.
# - **The stamp** (08) is the time of the measurement. The [[buffer]] answers between its oldest and its newest sample; `Time()` means the latest.
# - **Three exceptions** (09): an unknown name, no path, a time outside the data (into the past, into the future). If an edge has a single sample, the error has a third text.

# %% [markdown] lang="ko" name="needed" slide="slide"
# ## 시작하기 전에 알아 둘 것
#
# - **정적 변환**(06)은 `/tf_static`으로 한 번 보냅니다. 나중에 참가하는 노드를 위해 발행자가 메시지를 보관합니다.
# - **측정 시각**(08)은 언제 측정했는지를 나타냅니다. [[buffer|버퍼]]에서는 가장 오래된 표본과 최신 표본 사이의 시각만 조회할 수 있고, `Time()`은 최신을 뜻합니다.
# - **세 가지 예외**(09): 없는 이름, 경로 없음, 범위 밖의 시각(과거, 미래). 한 연결의 표본이 하나뿐이면 시각에 관한 셋째 오류 메시지가 나옵니다.

# %% [markdown] lang="en" name="needed-notes" slide="notes"
# Take a minute. Read one line, ask which chapter it comes from, go on. If somebody hesitates, they write the chapter's number down and read it at home.

# %% [markdown] lang="ko" name="needed-notes" slide="notes"
# 1분만 씁니다. 한 줄을 읽고 어느 장에서 배웠는지 묻고 넘어갑니다. 망설이는 사람은 오늘 복습할 장을 적어 둡니다.

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## Skip the boring first second
#
# A recording begins with a robot that stands still. So somebody played it with `--start-offset`, from a little after the start, and there were no sensors: no laser, no camera, no model. The report of 2026 was closed as working as designed ([ros2/rosbag2, issue 2333](https://github.com/ros2/rosbag2/issues/2333)).
# Others started the recorder in the paused state, and got a bag without any mounts ([issue 1302](https://github.com/ros2/rosbag2/issues/1302)).
#
# What was in that first second? Record a drive of our robot and look.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 지루한 처음 1초 건너뛰기
#
# 기록의 처음에는 로봇이 가만히 서 있습니다. 그래서 누군가 `--start-offset`으로 조금 뒤부터 재생했더니 센서 좌표계가 트리에서 사라졌습니다. 레이저도, 카메라도, 로봇 모델도 보이지 않았습니다. 2026년에 보고되었고, 의도한 동작이라며 닫혔습니다([ros2/rosbag2, 이슈 2333](https://github.com/ros2/rosbag2/issues/2333)).
# 일시 정지 상태로 기록을 시작한 사람들은 장착 변환이 하나도 없는 bag을 얻었습니다([이슈 1302](https://github.com/ros2/rosbag2/issues/1302)).
#
# 그 첫 순간에 무엇이 있었을까요? 우리 로봇이 방을 달리는 15초를 기록해 봅시다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Stop after the first paragraph: what may have been in that second? Collect guesses on the board, and explain nothing yet.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 첫 문단에서 멈추고 묻습니다. 그 1초에 무엇이 있었을까요? 추측을 칠판에 모으고 답은 아직 말하지 않습니다.

# %% name="start-the-robot" tags=["collapsed"] slide="skip"
# Start the robot.
graph = lesson.new_graph()
robot = lesson.TeachingRobot()
nodes = lesson.launch(graph, robot)
bags = lesson.fresh_folder()  # for this page's recordings; it goes away with the kernel

# %% [markdown] lang="en" name="record-intro" slide="subslide"
# This is the lecture's command, with `/imu` added. On a robot you stop the command with Ctrl-C. Here `--for` stops it. `{bags}` is a temporary folder of this page. (With `TFLAB_ROS_DISTRO=lyrical`, write `--topics` before the topics.)

# %% [markdown] lang="ko" name="record-intro" slide="subslide"
# 강의의 명령에 IMU를 더했습니다. 로봇에서는 Ctrl-C로 끝내고, 여기서는 `--for`에 적은 시간이 지나면 끝납니다. `{bags}`는 이 페이지의 임시 폴더입니다. (`TFLAB_ROS_DISTRO=lyrical`이라면 토픽 앞에 `--topics`를 적으십시오.)

# %% name="record"
# %ros2 --for 15.03 bag record -o {bags}/lap /scan /odom /tf /tf_static /imu /clock

# %% [markdown] lang="en" name="record-read" slide="-"
# Five subscriptions for six topics: there is no `/clock`, and the recorder reports no error. It waits for topics that may still appear.
# A real robot publishes no `/clock`. A simulation publishes one, and then it belongs in the bag. The lecture's command includes it to be safe.

# %% [markdown] lang="ko" name="record-read" slide="-"
# 토픽은 여섯인데 구독은 다섯입니다. `/clock`이 없지만 아무 오류도 나지 않습니다. 기록기는 나중에 나타날지도 모르는 토픽을 기다릴 뿐입니다.
#
# 실제 로봇에는 `/clock`이 없습니다. 시뮬레이션은 `/clock`을 발행하므로, 그때는 bag에 담습니다. 강의의 명령에는 만일을 위해 적혀 있습니다.

# %% name="info" slide="fragment"
# %ros2 bag info {bags}/lap

# %% [markdown] lang="en" name="info-read" slide="-"
# Read the counts. `/tf` 750, `/tf_static` **1**. One message contains every mount, and here is when it was received:

# %% [markdown] lang="ko" name="info-read" slide="-"
# 개수를 읽어 보세요. `/tf`는 750, `/tf_static`은 **1**입니다. 메시지 하나에 모든 장착 변환이 들어 있습니다. 다음 그림은 토픽마다 메시지를 받은 시각입니다.

# %% [markdown] lang="en" name="record-notes" slide="notes"
# Seven minutes from here to the offset. Why five subscriptions for six topics? Then `bag info`: who finds the count of 1 first?

# %% [markdown] lang="ko" name="record-notes" slide="notes"
# 여기서 건너뛰기까지 7분입니다. 토픽은 여섯인데 왜 구독은 다섯입니까? 그다음 `bag info`에서 개수가 1인 토픽을 찾게 합니다.

# %% name="heard" tags=["collapsed"] slide="subslide"
# Draw when each message was received.
lap = lesson.read_bag(bags / "lap", show_progress=False)
lesson.draw_heard(lap, for_s=2.0)

# %% [markdown] lang="en" name="heard-read"
# Each circle is a message, at the time at which the recorder *received* it. That is one of its two times. The other, its stamp, is the time of the measurement. A scan is received 0.105 s after its stamp.
# `ros2 bag play` uses the first, TF uses the second.
#
# ### Predict
#
# With its own transforms the bag can place 149 of its 150 scans on the map: a lookup of `map ← laser_frame` at each scan's own stamp. (The first scan is older than all transforms.)
# How many can be placed if you play with `--start-offset 0.001`, one millisecond later?

# %% [markdown] lang="ko" name="heard-read"
# *그림 읽기:* 행마다 토픽 하나, 동그라미마다 메시지 하나입니다. time = 시간.
#
# 동그라미는 기록기가 메시지를 받은 *수신 시각*입니다. 메시지에는 시각이 둘 있습니다. 다른 하나인 측정 시각은 언제 측정했는지를 나타냅니다. 스캔은 측정된 지 0.105초 뒤에 기록기에 들어옵니다.
# `ros2 bag play`는 수신 시각을, TF는 측정 시각을 따릅니다.
#
# ### 예측해 봅시다
#
# 스캔 150개 가운데 149개는 bag에 담긴 변환만으로 지도 기준으로 바꿀 수 있습니다. 스캔마다 자기 측정 시각의 `map ← laser_frame`을 씁니다. (첫 스캔은 TF 전체보다 오래되었습니다.)
# `--start-offset 0.001`로 기록의 처음 1밀리초를 건너뛰고 재생하면 몇 개를 바꿀 수 있을까요?

# %% [markdown] lang="en" name="heard-notes" slide="notes"
# Cover the last row with your hand and ask how often each of the other topics is published. Uncover it. Then everybody writes a number for one millisecond.

# %% [markdown] lang="ko" name="heard-notes" slide="notes"
# 마지막 줄을 손으로 가리고 나머지 줄의 발행률을 묻습니다. 손을 떼고, 1밀리초를 건너뛰면 몇 개일지 모두 숫자로 적게 합니다.

# %% [markdown] lang="en" name="asker-intro" slide="subslide"
# To find out you need a node that listens while the bag plays. For each scan it makes three lookups: at the scan's stamp, at its own *now*, and at `Time()`. It also counts its timer callbacks, and measures the age of a scan by its own clock. Its code is folded away: you need only its counts.

# %% [markdown] lang="ko" name="asker-intro" slide="subslide"
# 알아보려면 재생하는 동안 메시지를 받는 노드가 필요합니다. 이 노드는 스캔마다 세 시각의 변환을 조회합니다. 스캔의 측정 시각, 자신의 현재 시각, 그리고 `Time()`입니다. 타이머가 몇 번 울리는지, 스캔의 나이가 얼마인지도 적습니다. 코드는 접어 두었습니다. 여기서는 그 결과만 봅니다.

# %% name="imports" tags=["collapsed"] slide="skip"
# Import what the page's node needs.
import io
import math
from collections import Counter
from contextlib import redirect_stdout

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformException, TransformListener

# %% name="ask" tags=["collapsed"]
# Look up one transform, and count it.
def ask(node, question, frame, moment):
    try:
        node.buffer.lookup_transform("map", frame, moment)
        node.heard[question] += 1
    except TransformException as error:
        node.first_no = node.first_no or error

# %% [markdown] lang="en" name="asker-intro-notes" slide="notes"
# Nobody has to read the code. Say what the node will do: three lookups for each scan, a timer, an age.

# %% [markdown] lang="ko" name="asker-intro-notes" slide="notes"
# 코드를 다 읽지 않아도 됩니다. 노드가 하는 일만 말합니다. 스캔마다 시각 셋, 타이머 하나, 나이 하나입니다.

# %% name="asker" tags=["collapsed"] slide="subslide"
class Asker(Node):  # three lookups for each scan
    def __init__(self, use_sim_time=True, make_buffer=lambda node: Buffer(node=node)):
        super().__init__("asker", parameter_overrides=[Parameter("use_sim_time", value=use_sim_time)])
        self.buffer = make_buffer(self)
        self.listener = TransformListener(self.buffer, self)
        self.heard, self.first_no = Counter(), None
        self.create_subscription(LaserScan, "scan", self.on_scan, qos_profile_sensor_data)
        self.create_timer(1.0, lambda: self.heard.update(["timer"]))

    def on_scan(self, scan):
        stamp, now = Time.from_msg(scan.header.stamp), self.get_clock().now()
        self.heard["scans"] += 1
        self.age_s = (now.nanoseconds - stamp.nanoseconds) / 1e9
        for question, moment in {"at its stamp": stamp, "at now": now, "Time()": Time()}.items():
            ask(self, question, scan.header.frame_id, moment)

# %% name="offset" tags=["predicted", "collapsed"] slide="fragment"
# Play the bag twice.
for options in ("--clock", "--clock --start-offset 0.001"):
    asker = lesson.replay(Asker, bags / "lap", options, for_s=16.0)
    print(f"$ ros2 bag play lap {options}")
    print(f"  {asker.heard['at its stamp']} of {asker.heard['scans']} placed")
print(asker.first_no)

# %% [markdown] lang="en" name="offset-read" tags=["predicted"]
# None. The one message with the mounts was at 0.000 s, and the player skipped it. From then on `laser_frame` is in no buffer.
# On the robot its publisher would send it again to each listener that joins later; that is how `/tf_static` works. A player publishes nothing from before the offset.
#
# If you must begin later, let `robot_state_publisher` publish the mounts, with the robot's URDF. Or play them first, `ros2 bag play lap --topics /tf_static`, while your nodes are already listening. When that player ends, the message that it kept for late listeners is gone.

# %% [markdown] lang="ko" name="offset-read" tags=["predicted"]
# 하나도 없습니다. 장착 변환이 담긴 메시지 하나가 0.000초에 있었고, 재생기는 그 메시지를 보내지 않았습니다. 그 뒤로 `laser_frame`은 어느 버퍼에도 없습니다.
#
# 로봇에서는 발행자가 나중에 참가하는 노드에게 다시 보내 줍니다. `/tf_static`이 그런 토픽이기 때문입니다. 재생기는 재생한 것만 보관합니다.
# 꼭 중간부터 재생해야 한다면 장착 변환은 따로 보내십시오. 로봇의 URDF로 `robot_state_publisher`를 실행하면 됩니다. 또는 노드를 모두 실행한 뒤에 `ros2 bag play lap --topics /tf_static`을 먼저 실행합니다. 이 재생기가 끝나면 보관하던 메시지도 함께 사라지므로, 그 뒤에 시작한 노드는 받지 못합니다.

# %% [markdown] lang="en" name="offset-notes" slide="notes"
# Hands for 149, for all but a few, for none; then run it. One sentence is enough: a player publishes nothing from before the offset.

# %% [markdown] lang="ko" name="offset-notes" slide="notes"
# 149개, 몇 개만 빼고 모두, 하나도 없음에 손을 들게 한 다음 실행합니다. 정리는 한 문장입니다. 재생기는 재생한 것만 보냅니다.

# %% [markdown] lang="en" name="one-number" slide="slide"
# ## One number for any bag
#
# *Can the transforms in this bag place its own messages?* You need not play it to know. Fill a buffer with its transforms, and look up each message at its stamp.
#
# **Predict:** how many of the 150 scans can be placed with all topics, how many without `/tf_static`, and how many without `/tf`?

# %% [markdown] lang="ko" name="one-number" slide="slide"
# ## 어떤 bag에나 통하는 숫자 하나
#
# *이 bag은 담긴 변환만으로 센서 데이터를 지도에 표시할 수 있을까요?* 재생하지 않아도 알 수 있습니다. bag의 변환으로 버퍼를 채우고, 메시지마다 측정 시각의 변환을 조회하면 됩니다.
#
# **예측해 봅시다.** 모두 기록했을 때, `/tf_static`이 없을 때, `/tf`가 없을 때 스캔을 몇 개나 지도에 표시할 수 있을까요?

# %% name="place-all" tags=["predicted", "collapsed"] slide="fragment"
# Look up each scan at its stamp.
for left_out in ((), ("/tf_static",), ("/tf",)):
    *_, scan = lesson.place_messages(lap, "map", left_out)
    print(f"left out: {', '.join(left_out) or 'nothing'}\n  {scan}\n")

# %% [markdown] lang="en" name="place-all-read" tags=["predicted"]
# The three bags have almost the same size, but they place 149, 0 and 0 scans. The two errors name different frames: without `/tf_static` the sensor's frame is unknown; without `/tf`, `map` is unknown.
# So the frame in the error shows which topic is missing. The sensor is not broken.
#
# So what is the smallest recording? It depends on what you want to do with it tomorrow:
#
# | tomorrow you want | record besides the sensor |
# |---|---|
# | the sensor on the map, as the robot placed it | `/tf` `/tf_static` |
# | to run the localisation again, with another algorithm | `/tf_static` and the odometry (`/tf` or `/odom`). When you play, filter `map → odom` out of `/tf` |
# | either of these, from a simulation | the topics above, and `/clock`, which shows how fast the simulation ran. Play that bag without `--clock`: the recorded `/clock` is played. With `--clock`, `ros2 bag play` of older releases would publish a second one |

# %% [markdown] lang="ko" name="place-all-read" tags=["predicted"]
# 크기가 거의 같은 bag 셋인데 149, 0, 0입니다. 그리고 두 오류 메시지에는 서로 다른 좌표계의 이름이 나옵니다. `/tf_static`이 없으면 버퍼에 센서의 좌표계가, `/tf`가 없으면 지도의 좌표계가 없습니다.
# 첫 오류 메시지에서 어떤 토픽이 빠졌는지 알 수 있습니다. 센서는 고장 나지 않았습니다.
#
# 그렇다면 가장 작은 기록은 무엇일까요? 내일 그 bag으로 무엇을 알아내려는지에 달려 있습니다.
#
# | 내일 하려는 일 | 센서 말고 기록할 것 |
# |---|---|
# | 로봇이 본 대로 센서 데이터를 지도 기준으로 바꾸기 | `/tf` `/tf_static` |
# | 다른 알고리즘으로 위치를 새로 추정하기 | `/tf_static`과 오도메트리(`/tf` 또는 `/odom`). 재생할 때 `map → odom`은 뺍니다 |
# | 위의 일을 시뮬레이션에서 하기 | 위의 토픽에 더해, 시뮬레이션의 속도를 남기려면 `/clock`도 담습니다. 이런 bag은 `--clock` 없이 재생합니다. `--clock`을 주면 예전 버전의 재생기는 `/clock`을 두 번 발행합니다 |

# %% [markdown] lang="en" name="place-all-notes" slide="notes"
# Let them guess the errors before the numbers. M13 belongs here: "I recorded the sensor, so I have the data." Then M15: people read "laser_frame does not exist" and take the laser apart.

# %% [markdown] lang="ko" name="place-all-notes" slide="notes"
# 숫자보다 오류 메시지를 먼저 예측하게 합니다. “센서를 기록했으니 데이터는 있다”는 오개념(M13)이 여기서 나옵니다. "laser_frame does not exist"를 보고 레이저를 뜯는 사람도 있습니다(M15).

# %% [markdown] lang="en" name="two-clocks" slide="slide"
# ## Two clocks
#
# It is the next day. The bag's stamps are from yesterday. System time, the time of the machine's clock, is 86 400 s ahead of them.
# A node's parameter `use_sim_time` decides which of the two it uses: `false`, system time; `true`, the time on `/clock`. This bag has no `/clock`, so the player publishes one only with `--clock`.
#
# ### Predict
#
# Sixty scans are played. There are four set-ups: `use_sim_time` false or true, with and without `--clock`. For each: how many lookups succeed at the scan's **stamp**, how many at the node's **now**, and does the timer run?
# Begin with this one: `use_sim_time` is false, no `--clock`, and the node looks up at `header.stamp`. Does it work at all?

# %% [markdown] lang="ko" name="two-clocks" slide="slide"
# ## 두 시계
#
# 다음 날이 되었습니다. bag의 측정 시각은 어제의 것이고, 시스템 시간은 그보다 86,400초 미래입니다.
# 노드의 파라미터 `use_sim_time`은 둘 가운데 어느 시간을 따를지 정합니다. `false`면 시스템 시간, `true`면 `/clock`의 시간입니다. 이 bag에는 `/clock`이 없으므로 재생기는 `--clock`을 주어야 `/clock`을 발행합니다.
#
# ### 예측해 봅시다
#
# 스캔 예순 개를 재생합니다. 설정은 네 가지입니다. `use_sim_time`이 false이거나 true이고, `--clock`이 없거나 있습니다. 설정마다 스캔의 **측정 시각**으로는 몇 개, 노드의 **현재 시각**으로는 몇 개의 조회가 성공할까요? 타이머는 울릴까요?
#
# 먼저 이것부터 생각해 봅시다. `use_sim_time`은 false이고 `--clock`도 없으며, 노드는 `header.stamp`의 변환을 조회합니다. 동작하기는 할까요?

# %% name="four-set-ups" tags=["predicted", "collapsed"] slide="fragment"
# Play the bag with each of the four set-ups.
print("use_sim_time  play       at its stamp  at now  timer  age of a scan")
for use_sim_time in (False, True):
    for options in ("", "--clock"):
        asker = lesson.replay(lambda sim=use_sim_time: Asker(sim), bags / "lap", options)
        counts = [asker.heard[what] for what in ("at its stamp", "at now", "timer")]
        print(
            f"{use_sim_time!s:<13} {options:<10} {counts[0]:>12} {counts[1]:>7} {counts[2]:>6} {asker.age_s:>12.3f} s"
        )

# %% [markdown] lang="en" name="four-set-ups-read" tags=["predicted"]
# - **At the stamp: 59 of 60, always.** Stamps and transforms come from the same bag, and they agree whatever a clock shows. That is another reason to look up at the stamp (08).
# - **With system time** everything else is a day off: now is 86 400 s in the future of all data, a scan appears to be a day old, and this node stamps its messages a day after the data.
# - **With `use_sim_time` and `--clock`** the node uses the bag's time. A scan is 0.105 s old, as on the robot. A lookup at *now* fails because a hundredth of a second is missing: transforms take time to arrive, too.
# - **And the third line?** `use_sim_time`, without `--clock`. The timer never runs, the age is minus seven seconds, and the lookup at *now* succeeds 59 times out of 60. It succeeds in no other set-up!

# %% [markdown] lang="ko" name="four-set-ups-read" tags=["predicted"]
# - **측정 시각으로는 언제나 60개 가운데 59개입니다.** 측정 시각과 변환은 같은 bag에서 왔으므로, 시계가 몇 시이든 서로 맞습니다. 측정 시각의 변환을 써야 하는 또 하나의 이유입니다(08).
# - **시스템 시간을 따르면** 나머지가 모두 하루씩 틀립니다. 현재 시각은 모든 데이터보다 86,400초 미래이고, 스캔의 나이는 하루로 계산되며, 노드가 새로 적는 측정 시각은 bag의 시간으로는 내일입니다.
# - **둘 다 켜면** 노드는 bag의 시간을 따릅니다. 스캔의 나이는 로봇에서처럼 0.105초입니다. *현재 시각*의 조회는 0.01초 모자라 실패합니다. 변환이 오는 데도 시간이 걸리기 때문입니다.
# - **셋째 줄은 어떨까요?** `use_sim_time`은 켰고 `--clock`은 없습니다. 타이머는 한 번도 울리지 않고, 나이는 −7초쯤이며, *현재 시각*의 조회는 60번 가운데 59번 성공합니다. 이 조회가 성공하는 설정은 이것뿐입니다.

# %% [markdown] lang="en" name="two-clocks-notes" slide="notes"
# Fifteen minutes from here to "The node that reports the error is not the cause". Four rows and three columns on the board; the class fills in each before it is run. Most leave the first cell empty, and it is 59.

# %% [markdown] lang="ko" name="two-clocks-notes" slide="notes"
# 여기서 ‘오류를 내는 노드가 원인은 아닙니다’까지 15분입니다. 칠판에 네 줄 세 칸짜리 표를 만든 다음, 실행하기 전에 함께 채웁니다. 대부분 첫 칸을 비워 두지만 답은 59입니다.

# %% [markdown] lang="en" name="stopped" slide="subslide"
# ### The stopped clock
#
# A node with `use_sim_time` that receives no `/clock` has a clock that stays at **0**. A timer or a sleep that waits on this clock never ends.
# And tf2 reads the time 0 as *the latest*. So a node that looks up *now* gets the latest transform, without an error, while its clock stands still. The broken set-up is the one that looks best.
#
# A user once reported that a transform library failed with `use_sim_time`, and withdrew the report the same day: `--clock` had been forgotten ([swri-robotics/marti_common, issue 495](https://github.com/swri-robotics/marti_common/issues/495)).

# %% [markdown] lang="ko" name="stopped" slide="subslide"
# ### 멈춘 시계
#
# `use_sim_time`을 켰는데 `/clock`이 오지 않으면 노드의 시계는 **0**에 멈춰 있습니다. 시간이 흘러야 실행되는 코드는 하나도 실행되지 않습니다.
# 그런데 tf2는 시각 0을 *최신*으로 처리합니다. 그래서 시계가 멈춘 채로 *현재 시각*을 조회하면 오류 없이 최신 변환이 나옵니다. 고장 난 설정이 가장 정상으로 보입니다.
#
# 어느 사용자는 변환 라이브러리가 `use_sim_time`에서 동작하지 않는다고 보고했다가 그날 바로 거두었습니다. `--clock`을 빠뜨렸던 것입니다([swri-robotics/marti_common, 이슈 495](https://github.com/swri-robotics/marti_common/issues/495)).

# %% [markdown] lang="en" name="stopped-notes" slide="notes"
# Stay with the third row: why does the broken set-up look best? Wait until somebody says that zero means the latest.

# %% [markdown] lang="ko" name="stopped-notes" slide="notes"
# 셋째 줄을 오래 봅니다. 왜 고장 난 설정이 가장 정상으로 보입니까? 0이 최신을 뜻한다는 말이 나올 때까지 기다립니다.

# %% [markdown] lang="en" name="panel-intro" slide="subslide"
# Set the clocks yourself. Switch `--clock` off: which line falls to zero? Then drag the time, change `--rate` (the speed of playing), and switch `--loop` off.

# %% [markdown] lang="ko" name="panel-intro" slide="subslide"
# 시계를 직접 바꿔 보세요. `--clock`을 끄면 어느 노드의 선이 0으로 떨어질까요? 그다음 재생 시간의 슬라이더를 끌고, `--rate`(재생 속도)를 바꾸고, `--loop`(반복)를 꺼 보세요.

# %% name="clocks-panel" tags=["interactive", "collapsed"]
# Show the panel.
lesson.clocks_panel()

# %% name="clocks-still" tags=["static"]
lesson.draw_clocks({"rviz2": True, "detector": False}, lesson.Play(loops=True), played_s=9.0)

# %% [markdown] lang="en" name="clocks-read"
# Below the break of the axis is the bag's time: a line that rises with `--rate` and begins again in a loop. Above it is system time. The table shows the result of a lookup at *now* in each node.

# %% [markdown] lang="ko" name="clocks-read"
# *그림 읽기:* clock = 시계, playing = 재생한 시간, now = 노드의 현재 시각, newest TF = 최신 변환의 시각, lookup at now = 현재 시각을 조회하면, future extrapolation = 미래 외삽.
#
# 끊어진 축의 아래쪽은 bag의 시간입니다. 선은 `--rate`만큼 가파르게 올라가고, 반복하면 처음으로 되돌아갑니다. 축의 위쪽은 시스템 시간입니다. 표는 노드마다 *현재 시각*을 조회한 결과입니다.

# %% [markdown] lang="en" name="clocks-notes" slide="notes"
# A student has the mouse: two switches, four pictures. Before each, ask which line will move.

# %% [markdown] lang="ko" name="clocks-notes" slide="notes"
# 한 사람에게 마우스를 맡깁니다. 스위치 둘, 그림 넷입니다. 바꾸기 전에 어느 선이 움직일지 묻습니다.

# %% [markdown] lang="en" name="by-hand-intro" slide="subslide"
# ### By hand
#
# These are the lecture's two checks. The `&` keeps the player running, as a second terminal would. `param set` works on a running node, too. Its output shows what the change costs.

# %% [markdown] lang="ko" name="by-hand-intro" slide="subslide"
# ### 직접 확인하기
#
# 강의에 나온 두 명령입니다. `&`를 붙이면 터미널을 하나 더 연 것처럼 재생기가 계속 실행됩니다. 실행 중인 노드에 `param set`도 할 수 있습니다. 그러면 무엇을 잃는지 출력에서 읽어 보세요.

# %% name="by-hand-node" tags=["collapsed"] slide="-"
# Start the node on the next day.
asker = lesson.replay(Asker, bags / "lap", "", for_s=1.0)

# %% name="by-hand-play" slide="-"
# %ros2 bag play {bags}/lap --clock &

# %% name="by-hand-clock" slide="-"
# %ros2 topic echo /clock --once
# %ros2 param get /asker use_sim_time

# %% [markdown] lang="en" name="by-hand-notes" slide="notes"
# The first part to leave out when time is short. Otherwise ask what `&` stands for on a robot: a second terminal.

# %% [markdown] lang="ko" name="by-hand-notes" slide="notes"
# 시간이 모자라면 가장 먼저 건너뜁니다. 아니라면 `&`가 로봇에서 무엇에 해당하는지 묻습니다. 두 번째 터미널입니다.

# %% name="by-hand-set" slide="subslide"
# %ros2 param set /asker use_sim_time false

# %% [markdown] lang="en" name="by-hand-read"
# *Clearing tf buffer*: when a node changes its clock, the data in its buffer belongs to another time, so the buffer deletes every dynamic edge. Only the mounts stay, because a static transform is valid at all times. Until `/tf` has arrived again nothing can be placed. Data that was measured before the switch can never be placed. So set `use_sim_time` when you start a node, for all nodes alike (`/**` means every node), in the parameter file that the launch file passes to them:
#
# ```yaml
# /**:
#   ros__parameters:
#     use_sim_time: true
# ```

# %% [markdown] lang="ko" name="by-hand-read"
# *Clearing tf buffer*라고 나옵니다. 노드의 시계가 바뀌면 지금까지 모은 것은 다른 시간의 것이므로, 버퍼는 동적 연결을 모두 비웁니다. 장착 변환만 남습니다. 정적 변환은 어느 시각에나 유효하기 때문입니다. `/tf`가 다시 올 때까지는 아무것도 지도 기준으로 변환할 수 없습니다. 파라미터를 바꾸기 전에 측정한 데이터는 그 뒤에도 변환할 수 없습니다. 그러니 `use_sim_time`은 노드를 시작할 때, 모든 노드에 똑같이(`/**`는 모든 노드라는 뜻입니다), launch 파일에서 정하십시오.
#
# ```yaml
# /**:
#   ros__parameters:
#     use_sim_time: true
# ```

# %% [markdown] lang="en" name="by-hand-set-notes" slide="notes"
# Ask what the change has cost: every dynamic edge is deleted, and what was measured before the switch is never placed. The mounts stay. Hence at the start, and for all nodes.

# %% [markdown] lang="ko" name="by-hand-set-notes" slide="notes"
# 바꾸면서 무엇을 잃었는지 묻습니다. 동적 연결이 모두 비었고, 설정을 바꾸기 전에 측정한 것은 영영 지도 기준으로 바꿀 수 없습니다. 장착 변환은 남습니다. 그래서 시작할 때, 모든 노드에 정합니다.

# %% [markdown] lang="en" name="innocent" slide="slide"
# ## The node that reports the error is not the cause
#
# You want to run the localisation again. The bag contains laser, wheel odometry and mounts, and a new localiser publishes `map → odom`. Every node has `use_sim_time`, except one that was forgotten: the localiser.
#
# **Predict:** which node reports an error, and which error?

# %% [markdown] lang="ko" name="innocent" slide="slide"
# ## 오류를 내는 노드가 원인은 아닙니다
#
# 위치를 새로 추정하려 합니다. 레이저와 바퀴 오도메트리와 장착 변환은 bag에서 오고, `map → odom`은 오늘 실행한 위치 추정 노드가 발행합니다. 모든 노드에 `use_sim_time`을 켰는데 하나를 빠뜨렸습니다. 바로 위치 추정 노드입니다.
#
# **예측해 봅시다.** 어느 노드가 오류를 낼까요? 어떤 오류일까요?

# %% name="record-raw" tags=["collapsed"] slide="skip"
# Record a drive without a localiser.
from IPython import get_ipython

graph = lesson.new_graph()
parts = ["robot_state_publisher", "joint_driver", "wheel_odometry", "laser_driver"]
with redirect_stdout(io.StringIO()):  # the recorder's log, as above
    nodes = lesson.launch(graph, only=parts)
    get_ipython().run_line_magic("ros2", f"--for 9.03 bag record -o {bags}/raw /scan /odom /tf /tf_static")

# %% name="innocent-run" tags=["predicted", "collapsed"] slide="fragment"
# Play that bag beside the new localiser.
asker = lesson.replay(Asker, bags / "raw", "--clock", for_s=5.0, beside=["localization"])
print(f"{asker.heard['at its stamp']} of {asker.heard['scans']} scans placed")
try:
    asker.buffer.lookup_transform("map", "laser_frame", Time(seconds=5))
except TransformException as error:
    print(error)

# %% [markdown] lang="en" name="innocent-read" tags=["predicted"]
# Every node that looks up a transform gets the error; the one at fault has none. This localiser stamps its transforms with its own clock, a day later than the bag. (AMCL stamps with the time of the scan, plus a tolerance, and would not be affected here. Look into a node's manual to find out which stamp it uses.)
#
# *Requested time 5, the earliest data is at 86401.* `Time()` does not help either: on this path the two days have no common time.
# Which node wrote those stamps? `tflab doctor`, a program that looks for TF problems, examines all nodes at once. Read its first finding, and the line *Published by*. (The player may keep system time: it only repeats what was recorded.)

# %% [markdown] lang="ko" name="innocent-read" tags=["predicted"]
# 조회하는 노드에서는 모두 오류가 나는데, 정작 원인인 노드에서는 나지 않습니다. 위치 추정 노드는 변환에 자신의 현재 시각을 적으므로, bag의 시간으로는 내일의 변환을 발행합니다. (AMCL은 사용한 스캔의 측정 시각에 허용 시간을 더해 적으므로 여기서는 문제가 없습니다. 노드가 어떤 시각을 적는지는 설명서에서 확인하십시오.)
# *요청 시각은 5초, 가장 오래된 데이터는 86401초.* `Time()`도 소용없습니다. 이 경로의 시간줄들에는 공통인 시각이 없습니다.
# 누구의 측정 시각일까요? TF 문제를 찾는 프로그램 `tflab doctor`로 모든 노드를 한꺼번에 검사해 봅시다. 첫 결과와 *Published by* 줄을 읽어 보세요. (재생기는 시스템 시간을 따라도 됩니다. 기록된 것을 다시 발행할 뿐입니다.)

# %% name="innocent-doctor" slide="-"
print(lesson.doctor(lesson.current_graph(), seconds=3.0))

# %% [markdown] lang="en" name="innocent-notes" slide="notes"
# The node that reports the error is not at fault. Let them name the cause from the two times, before the doctor does.

# %% [markdown] lang="ko" name="innocent-notes" slide="notes"
# 오류를 내는 노드와 잘못된 노드는 다릅니다. doctor를 실행하기 전에 두 시각만 보고 잘못된 노드를 지목하게 합니다.

# %% [markdown] lang="en" name="loop" slide="slide"
# ## Back in time
#
# `ros2 bag play lap --clock --loop`: fifteen seconds, again and again. At the end of each pass the clock goes back from 16 to 1.
# The lecture's node has `Buffer(cache_time=Duration(seconds=20.0))`. The node listens to the second pass, and its clock shows 11.9 s.
#
# **Predict:** where does a lookup at `Time()` place the robot?

# %% [markdown] lang="ko" name="loop" slide="slide"
# ## 시각이 되돌아갈 때
#
# `ros2 bag play lap --clock --loop`는 15초를 거듭 재생합니다. 반복하는 지점에서 시각이 16초에서 1초로 되돌아갑니다.
# 강의에 나온 노드는 `Buffer(cache_time=Duration(seconds=20.0))`을 씁니다. 지금 두 번째 재생이고, 노드의 시계는 11.9초입니다.
#
# **예측해 봅시다.** `Time()`으로 조회하면 로봇은 어디에 있을까요?

# %% name="looped" tags=["collapsed"] slide="-"
# The node, with the age of its newest transform.
class Looped(Asker):
    def __init__(self, make_buffer):
        super().__init__(True, make_buffer)
        self.times, self.ages = [], []

    def on_scan(self, scan):
        super().on_scan(scan)
        if self.buffer.can_transform("map", "base_link", Time()):
            newest = self.buffer.get_latest_common_time("map", "base_link")
            self.times.append(lesson.current_graph().now_ns / 1e9 - 86401)
            self.ages.append((self.get_clock().now().nanoseconds - newest.nanoseconds) / 1e9)

# %% name="twenty-seconds" tags=["collapsed"] slide="-"
# Print where a node places the robot.
def show(node):
    now = node.get_clock().now().nanoseconds
    newest = node.buffer.lookup_transform("map", "base_link", Time())
    at, here = newest.transform.translation, robot.truth_at(now)["base_link"].translation
    print(f"its clock {now / 1e9:.1f} s, newest of {Time.from_msg(newest.header.stamp).nanoseconds / 1e9:.2f} s")
    print(f"the robot is off by {math.dist((at.x, at.y), here[:2]):.2f} m")
    print(f"{node.heard['at its stamp']} of {node.heard['scans']} scans placed")

# %% name="twenty-seconds-run" tags=["predicted"] slide="fragment"
def lecture(node):
    return Buffer(cache_time=Duration(seconds=20.0))


long = lesson.replay(lambda: Looped(lecture), bags / "lap", "--clock --loop", for_s=25.93)
show(long)

# %% [markdown] lang="en" name="twenty-seconds-read" tags=["predicted"]
# `Time()` places the robot at the end of the *previous* pass, almost two metres from its true position. There is no error and no warning, and every scan but the first of each pass is placed: a buffer of 20 s has room for both passes, and "the latest" is the sample with the largest stamp.
#
# With the default of ten seconds, the buffer prints a warning, many times:

# %% [markdown] lang="ko" name="twenty-seconds-read" tags=["predicted"]
# *첫* 재생의 끝 위치가 나옵니다. 실제 위치에서 2 m 가까이 떨어져 있습니다. 오류도 경고도 없고, 스캔도 재생할 때마다 맨 처음 것만 빼고 모두 지도 기준으로 바뀌었습니다. 20초짜리 버퍼에는 두 번 재생한 것이 다 들어가고, “최신”이란 측정 시각이 가장 큰 표본이기 때문입니다.
# 보통의 10초짜리 버퍼라면 경고가 나옵니다. 아주 많이 나옵니다.

# %% [markdown] lang="en" name="loop-notes" slide="notes"
# Eight minutes for the loop. Write the clock on the board: 15, 16, 1, 2. Where is the robot by the latest? Wait for the answer: where it stopped.

# %% [markdown] lang="ko" name="loop-notes" slide="notes"
# 반복 재생은 8분입니다. 칠판에 시계를 적습니다. 15, 16, 1, 2. 최신을 조회하면 로봇은 어디에 있습니까? 멈췄던 자리라는 답을 기다립니다.

# %% name="ten-seconds" tags=["collapsed"] slide="subslide"
# Run the node with Buffer().
with redirect_stdout(io.StringIO()) as log:  # it would fill the page
    warned = lesson.replay(lambda: Looped(lambda node: Buffer()), bags / "lap", "--clock --loop", for_s=25.93)
show(warned)
warnings = [line for line in log.getvalue().splitlines() if "TF_OLD_DATA" in line]
print(len(warnings), "warnings, such as")
print(warnings[0])

# %% [markdown] lang="en" name="ten-seconds-read"
# Fifty scans are lost. The new stamps are more than ten seconds older than the newest sample, so the buffer rejects the new pass until its stamps are within those ten seconds.
# A `Buffer()` without a node watches the system clock, not `/clock`, so it does not notice that time went back. Pass your node to the buffer:

# %% [markdown] lang="ko" name="ten-seconds-read"
# 스캔 쉰 개를 잃었습니다. 다시 재생한 변환은 처음 5초 동안 버퍼의 최신 표본보다 10초 넘게 과거의 것입니다. 보관 시간이 10초인 버퍼는 이런 변환을 거절합니다.
# 노드를 넘기지 않은 `Buffer()`는 `/clock`이 아니라 시스템 시계를 살피므로, 시각이 되돌아간 것을 알 수 없습니다. 노드를 넘겨 봅시다.

# %% [markdown] lang="en" name="ten-seconds-notes" slide="notes"
# 643 warnings and fifty scans lost. Ask which is worse: this one with its warnings, or the one before without any.

# %% [markdown] lang="ko" name="ten-seconds-notes" slide="notes"
# 경고가 643개, 잃은 스캔이 쉰 개입니다. 어느 쪽이 더 나쁜지 묻습니다. 경고가 나오는 이번 결과입니까, 경고가 없던 앞의 결과입니까?

# %% name="with-a-node" slide="subslide"
sound = lesson.replay(lambda: Looped(lambda node: Buffer(node=node)), bags / "lap", "--clock --loop", for_s=25.93)
show(sound)

# %% [markdown] lang="en" name="with-a-node-read"
# There is one line in the log for each pass (*Clearing tf buffer*), and every position is right: the buffer deletes the dynamic edges, keeps the mounts, and stores the transforms of the new pass.
# In C++ the buffer always watches its clock. In Python no buffer did, until somebody reported this fault ([ros2/geometry2, issue 606](https://github.com/ros2/geometry2/issues/606)). Since then a Python buffer watches the clock of the node that you pass as `node=`. On Humble it still does not. Call `buffer.clear()` there yourself.
#
# How old is the newest transform, for each of the three?

# %% [markdown] lang="ko" name="with-a-node-read"
# 반복할 때마다 로그가 한 줄 나오고, 결과는 모두 맞습니다. 버퍼는 동적 연결을 비우고 장착 변환은 남겨 둔 채, 다시 재생한 변환을 받습니다.
# C++의 버퍼는 언제나 자기 시계를 살핍니다. 파이썬의 버퍼는 이 문제가 보고된 뒤에야([ros2/geometry2, 이슈 606](https://github.com/ros2/geometry2/issues/606)) `node=`로 넘긴 노드의 시계를 살피게 되었습니다. Humble에서는 파이썬 버퍼가 시계를 살피지 않으므로 `buffer.clear()`를 직접 호출하십시오.
#
# 세 버퍼에서 최신 변환은 각각 얼마나 오래되었을까요?

# %% name="loop-ages" tags=["collapsed"] slide="-"
# Draw the age of the newest transform.
from tflab.views.ages import Curve

named = {"cache 20 s": long, "Buffer()": warned, "node=self": sound}
curves = [Curve(name, tuple(node.times), tuple(node.ages)) for name, node in named.items()]
lesson.draw_ages(curves, "age of the newest transform")

# %% [markdown] lang="en" name="loop-ages-read"
# Below zero, the newest transform is in the node's future. Just after the clock went back, the first two buffers (their lines lie on each other) answer with data from fifteen seconds ahead. The difference shrinks as the clock advances.

# %% [markdown] lang="ko" name="loop-ages-read"
# *그림 읽기:* age of the newest transform = 최신 변환의 나이, time = 재생한 시간, cache 20 s = 20초를 보관하는 버퍼.
#
# 0 아래는 최신 변환이 노드의 현재 시각보다 미래의 것이라는 뜻입니다. 반복하는 지점을 지난 직후에 처음 두 버퍼의 최신 변환은 현재 시각보다 15초 미래의 것입니다(두 선은 겹쳐 있습니다). 그 뒤로는 시계가 나아가는 만큼 차이가 줄어듭니다.

# %% [markdown] lang="en" name="node-self-notes" slide="notes"
# One argument: `node=self`. Point at the picture: two lines fall by fifteen seconds, one does not.

# %% [markdown] lang="ko" name="node-self-notes" slide="notes"
# 한 단어입니다. `node=self`. 그림에서 두 선은 15초만큼 내려가고 하나는 그대로인 것을 짚어 줍니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# You play yesterday's bag with `--clock`. RViz shows the robot. Your own node prints
#
# ```
# Lookup would require extrapolation into the future.  Requested time 1795460830.512000
# but the latest data is at time 1795374431.204000, when looking up transform ...
# ```
#
# What do you do first?
#
# 1. Raise the timeout.
# 2. Use `Time()` instead.
# 3. `ros2 param get /my_node use_sim_time`
# 4. Record the bag once more.
#
# <details><summary>I chose 1</summary>
#
# The two times are 86 399 s apart. No timeout bridges a day. Compare the times before you wait.
#
# </details>
# <details><summary>I chose 2</summary>
#
# Then the error is gone, but the node's clock still shows another day: its stamps and its ages are wrong, without an error.
#
# </details>
# <details><summary>I chose 3</summary>
#
# Yes. The requested time is today's, the data is yesterday's. So your node does not use the bag's time.
#
# </details>
# <details><summary>I chose 4</summary>
#
# RViz places everything, so the bag is complete. The difference is in your node.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 어제의 bag을 `--clock`으로 재생합니다. RViz에는 로봇이 보입니다. 그런데 여러분의 노드에는 이런 오류가 나옵니다.
#
# ```
# Lookup would require extrapolation into the future.  Requested time 1795460830.512000
# but the latest data is at time 1795374431.204000, when looking up transform ...
# ```
#
# 무엇을 먼저 하겠습니까?
#
# 1. timeout을 늘립니다.
# 2. 대신 `Time()`을 조회합니다.
# 3. `ros2 param get /my_node use_sim_time`
# 4. bag을 다시 기록합니다.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 두 시각은 86,399초 떨어져 있습니다. timeout으로 하루를 기다릴 수는 없습니다. 기다리기 전에 두 시각을 비교하십시오.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 오류는 사라지지만 노드는 여전히 다른 날짜의 시각을 씁니다. 측정 시각도, 나이도 오류 없이 틀립니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞습니다. 요청 시각은 오늘의 것이고 데이터는 어제의 것입니다. 조회한 노드가 bag의 시간을 따르지 않습니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# RViz는 모든 것을 제자리에 그리므로 bag에는 빠진 것이 없습니다. 문제는 노드에 있습니다.
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Four minutes. Before the vote somebody subtracts the two times aloud: 86 399 s.

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 4분입니다. 투표하기 전에 한 사람이 두 시각을 소리 내어 뺍니다. 86,399초입니다.

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# You need your robot, or a simulation, for ten seconds, and two terminals. Stop the robot's own nodes before you play, or two nodes publish each transform.
#
# ```
# ros2 bag record -o kitchen /scan /odom /tf /tf_static
# ros2 bag info kitchen                        # is /tf_static there?
# python3 bag_check.py                         # the node below, in terminal 2
# ros2 bag play kitchen --clock                # and again with --start-offset 1
# ros2 topic echo /clock --once
# ros2 param get /point_to_map use_sim_time    # of every node
# ros2 param set /point_to_map use_sim_time true
# ```
#
# From a simulation record `/clock`, too: `ros2 bag record /scan /odom /tf /tf_static /clock`. On Jazzy you may also write `--topics` before the topics. Humble does not have this option, and Lyrical requires it.
# `use_sim_time` goes under `/**:` into the parameter file that the launch file passes to the nodes, so that no node is forgotten. RViz is a node, too.

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# 로봇이나 시뮬레이션을 10초 동안 기록합니다. 터미널은 두 개가 필요합니다. 재생하기 전에 로봇의 노드를 멈추십시오. 그러지 않으면 변환마다 발행자가 둘이 됩니다.
#
# ```
# ros2 bag record -o kitchen /scan /odom /tf /tf_static
# ros2 bag info kitchen                        # /tf_static이 있는지?
# python3 bag_check.py                         # 아래 노드, 터미널 2에서
# ros2 bag play kitchen --clock                # --start-offset 1을 붙여 한 번 더
# ros2 topic echo /clock --once
# ros2 param get /point_to_map use_sim_time    # 모든 노드에서
# ros2 param set /point_to_map use_sim_time true
# ```
#
# 시뮬레이션에서는 `/clock`도 기록합니다. `ros2 bag record /scan /odom /tf /tf_static /clock`입니다. Jazzy에서는 토픽 앞에 `--topics`를 적어도 됩니다. Humble에는 이 옵션이 없고, Lyrical에서는 반드시 적어야 합니다.
# `use_sim_time`은 launch 파일이 넘겨주는 파라미터 파일의 `/**:` 아래에 적어 빠지는 노드가 없게 하십시오. RViz도 노드입니다.

# %% [markdown] lang="en" name="on-the-robot-notes" slide="notes"
# To photograph, not to read aloud. One sentence: RViz is a node, too.

# %% [markdown] lang="ko" name="on-the-robot-notes" slide="notes"
# 읽지 말고 사진으로 찍게 합니다. 한 문장만 말합니다. RViz도 노드입니다.

# %% [markdown] lang="en" name="bag-check" slide="skip"
# ### A node to take home
#
# It prints the one number while a bag plays. Each scan is looked up at its own stamp, a second later, so that late transforms are there. If it prints nothing, its clock stands still: `--clock` is missing.
#
# ```python
# # tf_lab_py/bag_check.py
# from collections import deque
#
# import rclpy
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.parameter import Parameter
# from rclpy.qos import qos_profile_sensor_data
# from rclpy.time import Time
# from sensor_msgs.msg import LaserScan
# from tf2_ros import Buffer, TransformException, TransformListener
#
#
# class BagCheck(Node):
#     def __init__(self):
#         super().__init__('bag_check', parameter_overrides=[Parameter('use_sim_time', value=True)])
#         self.buffer = Buffer(node=self)  # is cleared when the bag's time goes back
#         self.listener = TransformListener(self.buffer, self)
#         self.waiting, self.scans, self.placed, self.reason = deque(), 0, 0, ''
#         self.create_subscription(LaserScan, 'scan', self.on_scan, qos_profile_sensor_data)
#         self.create_timer(1.0, self.report)  # waits for /clock
#
#     def on_scan(self, scan):
#         self.waiting.append(scan)
#
#     def report(self):
#         while self.waiting and self.age(self.waiting[0]) > Duration(seconds=1.0):
#             header = self.waiting.popleft().header
#             self.scans += 1
#             try:
#                 self.buffer.lookup_transform('map', header.frame_id, Time.from_msg(header.stamp))
#                 self.placed += 1
#             except TransformException as error:
#                 self.reason = f', the last error: {error}'
#         self.get_logger().info(f'{self.placed} of {self.scans} scans placed{self.reason}')
#
#     def age(self, scan):
#         return self.get_clock().now() - Time.from_msg(scan.header.stamp)
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = BagCheck()
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
# Without ROS: `tflab run bag_check.py --with "ros2 bag play kitchen --clock"`.

# %% [markdown] lang="ko" name="bag-check" slide="skip"
# ### 가져갈 노드
#
# bag이 재생되는 동안 그 숫자 하나를 출력합니다. 스캔마다 자기 측정 시각의 변환을 조회하되, 늦게 오는 변환까지 받도록 1초 뒤에 조회합니다. 아무것도 출력하지 않으면 시계가 멈춰 있는 것입니다. `--clock`을 빠뜨렸습니다.
#
# ```python
# # tf_lab_py/bag_check.py
# from collections import deque
#
# import rclpy
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.parameter import Parameter
# from rclpy.qos import qos_profile_sensor_data
# from rclpy.time import Time
# from sensor_msgs.msg import LaserScan
# from tf2_ros import Buffer, TransformException, TransformListener
#
#
# class BagCheck(Node):
#     def __init__(self):
#         super().__init__('bag_check', parameter_overrides=[Parameter('use_sim_time', value=True)])
#         self.buffer = Buffer(node=self)  # is cleared when the bag's time goes back
#         self.listener = TransformListener(self.buffer, self)
#         self.waiting, self.scans, self.placed, self.reason = deque(), 0, 0, ''
#         self.create_subscription(LaserScan, 'scan', self.on_scan, qos_profile_sensor_data)
#         self.create_timer(1.0, self.report)  # waits for /clock
#
#     def on_scan(self, scan):
#         self.waiting.append(scan)
#
#     def report(self):
#         while self.waiting and self.age(self.waiting[0]) > Duration(seconds=1.0):
#             header = self.waiting.popleft().header
#             self.scans += 1
#             try:
#                 self.buffer.lookup_transform('map', header.frame_id, Time.from_msg(header.stamp))
#                 self.placed += 1
#             except TransformException as error:
#                 self.reason = f', the last error: {error}'
#         self.get_logger().info(f'{self.placed} of {self.scans} scans placed{self.reason}')
#
#     def age(self, scan):
#         return self.get_clock().now() - Time.from_msg(scan.header.stamp)
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = BagCheck()
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
# ROS가 없는 컴퓨터에서는 `tflab run bag_check.py --with "ros2 bag play kitchen --clock"`입니다.

# %% [markdown] lang="en" name="recap" slide="slide"
# ## Recap
#
# - A message in a [[bag]] has two times: the time of its arrival, by which it is played, and its stamp, which TF uses.
# - `/tf_static` is sent once, at the beginning. If you skip that message, no sensor can be placed.
# - *Can the transforms in the bag place its own messages?* One number answers this, and you need not play the bag.
# - `use_sim_time` on every node, `--clock` at the player: use both. Without them a node's clock shows another day; with `use_sim_time` alone it stands still ([[simulation time]]).
# - With a clock at 0, a lookup at *now* returns the latest transform, so the broken set-up looks best. A lookup at the stamp does not depend on the node's clock.
# - The node that reports an error about times is often not the one at fault.
# - Use `Buffer(node=self)`. Without it, a bag in a loop leads to wrong transforms.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - [[bag]]의 메시지에는 시각이 둘 있습니다. 재생은 수신 시각을 따르고, TF는 측정 시각을 따릅니다.
# - `/tf_static`은 첫 순간에 한 번 나옵니다. 그 순간을 빼면 센서의 좌표계가 트리에 없습니다.
# - *bag은 담긴 변환만으로 센서 데이터를 지도에 표시할 수 있을까요?* 재생하지 않고도 숫자 하나로 압니다.
# - 모든 노드에 `use_sim_time`, 재생기에 `--clock`. 둘 다 씁니다. 둘 다 없으면 노드의 시계가 다른 날짜를 가리키고, `use_sim_time`만 켜면 멈춥니다([[simulation time|시뮬레이션 시간]]).
# - 시계가 0에 멈추면 현재 시각의 조회가 최신 조회가 되므로, 고장 났을 때 가장 정상으로 보입니다. 측정 시각의 조회는 노드의 시계와 상관없습니다.
# - 시각 오류를 내는 노드가 원인이 아닌 경우가 많습니다.
# - 반복 재생에는 `Buffer(node=self)`를 써야 합니다. 쓰지 않으면 앞선 재생의 변환이 최신으로 나옵니다.

# %% [markdown] lang="en" name="recap-notes" slide="notes"
# Leave the recap on the screen while you hand out the paper for the exit ticket.

# %% [markdown] lang="ko" name="recap-notes" slide="notes"
# 쪽지를 나누어 주는 동안 화면에 띄워 둡니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > A colleague sends you a bag and writes: "your detector is broken, it says that laser_frame does not exist". Which two things do you check before you open the detector's code?
#
# <details><summary>Compare</summary>
#
# `ros2 bag info`: is `/tf_static` among the topics, with a count above 0? And how was it played: from the start, or with an offset?
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > 동료가 bag을 보내며 이렇게 썼습니다. “검출기가 고장 났어요. laser_frame이 없다고 나와요.” 검출기 코드를 열기 전에 먼저 확인할 두 가지는 무엇입니까?
#
# <details><summary>맞춰 보기</summary>
#
# `ros2 bag info`에 `/tf_static`이 있고 개수가 0보다 큰지 봅니다. 그리고 처음부터 재생했는지, 중간부터 재생했는지 봅니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Two minutes, on a slip, without talking. Collect them before the laboratory begins.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 2분 동안 말없이 쪽지에 적습니다. 실습을 시작하기 전에 쪽지를 거둡니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now record a bag that is complete, say which clock a node uses, and find the node that uses another one.
#
# **Now the exercises:** [E10 Clocks and bags](../../exercises/en/E10_clocks_and_bags.ipynb).
# **The next chapter** is [11 Tools and RViz](11_tools_and_rviz.ipynb): which tool answers which question?
#
# On your checklist this chapter is **C11** (simulation time) and **C12** (a bag with `/tf` and `/tf_static`). Here it was simulated; do it once on the robot.
#
# The sections below are optional: a bag of your own, a parameter in quotes, a bag in a loop, and questions. Each heading opens one.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 빠진 것 없는 bag을 기록하고, 노드가 어느 시계를 따르는지 말하고, 다른 시계를 따르는 노드를 찾아낼 수 있습니다.
#
# **이제 연습 문제입니다.** [E10 시계와 bag](../../exercises/ko/E10_clocks_and_bags.ipynb)을 풀어 보세요.
# **다음 장**은 [11 도구와 RViz](11_tools_and_rviz.ipynb)입니다. 어떤 질문에 어떤 도구를 쓰는지 배웁니다.
#
# 실습 체크리스트에서 이 장은 **C11**(시뮬레이션 시간)과 **C12**(`/tf`와 `/tf_static`을 담은 bag)입니다. 여기서는 시뮬레이션이었으니, 로봇에서도 한 번 해 보세요.
#
# 아래는 더 알고 싶은 사람을 위한 절입니다. 여러분의 bag, 따옴표를 붙인 파라미터, 반복 재생, 복습 문제가 있습니다. 제목을 누르면 펼쳐집니다.

# %% [markdown] lang="en" name="your-bag-heading" slide="slide"
# ## Your own bag

# %% [markdown] lang="ko" name="your-bag-heading" slide="slide"
# ## 여러분의 bag

# %% [markdown] lang="en" name="your-bag" slide="-"
# Now a real recording: ten seconds of our robot, recorded in real time on a machine that was also busy with other work. If you have a bag of your own, write its path instead, such as `BAG = "~/bags/kitchen"`, and run the cells below again. ROS 1's `.bag` files work, too.

# %% [markdown] lang="ko" name="your-bag" slide="-"
# 이제 진짜 기록입니다. 다른 일도 하고 있던 컴퓨터에서 실제 시간으로 우리 로봇을 10초 동안 기록했습니다. 여러분의 bag이 있습니까? 그렇다면 `BAG = "~/bags/kitchen"`처럼 경로를 적고 아래 셀들을 다시 실행해 보세요. ROS 1의 `.bag`도 됩니다.

# %% name="bag"
BAG = lesson.example_bag()  # or the path of yours

# %% name="bag-info"
# %ros2 bag info {BAG}

# %% [markdown] lang="en" name="your-bag-notes" slide="notes"
# Six minutes, if there is time, at their own machines. Those who have a bag write its path; the others keep ours. What do you expect of it?

# %% [markdown] lang="ko" name="your-bag-notes" slide="notes"
# 시간이 남으면 각자 컴퓨터에서 6분 동안 합니다. 자기 bag이 있으면 경로를 적고, 없으면 우리 것을 씁니다. 무엇을 예상합니까?

# %% name="bag-tree" tags=["collapsed"] slide="subslide"
# Draw the bag's tree.
recording = lesson.read_bag(BAG, show_progress=False)
tree = recording.buffer(namespace=(recording.namespaces() or [None])[0])  # of the first robot, if there are more
lesson.draw_buffer(tree, recording.end_ns)

# %% [markdown] lang="en" name="bag-tree-notes" slide="notes"
# One question: which edges have no rate here, and why is that no fault?

# %% [markdown] lang="ko" name="bag-tree-notes" slide="notes"
# 질문 하나입니다. 발행률이 없는 연결은 어느 것이고, 왜 고장이 아닙니까?

# %% name="bag-places" tags=["collapsed"] slide="subslide"
# Count the messages that the bag can place.
placed = lesson.place_messages(recording)
print("topics with a frame:", *placed, sep="\n")

# %% name="bag-statics" tags=["collapsed"] slide="-"
# Print how old two static transforms are.
for record in [record for record in recording.records() if record.is_static][:2]:
    before_s = (recording.begin_ns - record.stamped.stamp_ns) / 1e9
    print(f"{record.stamped.child_frame_id}: stamped {before_s:.1f} s before the recording began")

# %% name="bag-doctor" slide="-"
print(lesson.doctor(recording))

# %% [markdown] lang="en" name="bag-read"
# The static transforms are older than the whole recording, because the robot was switched on before. That is no fault: a static transform is valid at all times, and its stamp only shows when it was sent. Somebody has mistaken such a stamp for stale data before ([SteveMacenski/slam_toolbox, issue 814](https://github.com/SteveMacenski/slam_toolbox/issues/814)).
#
# Stamps that begin with 17… or 18… count the seconds since 1970. Small ones come from a simulation, or from a page like this one.

# %% [markdown] lang="ko" name="bag-read"
# *그림 읽기:* D(dynamic) = 동적(실선, 표본의 시각에만 유효), S(static) = 정적(점선, 어느 시각에나 유효), rate = 발행률, age = 나이, published by = 발행자.
#
# 정적 변환은 기록 전체보다 오래되었습니다. 로봇을 먼저 켰기 때문이고, 고장이 아닙니다. 정적 변환은 어느 시각에나 유효하고, 측정 시각은 보낸 때를 알려 줄 뿐입니다. 이것을 오래된 데이터로 오해한 일도 있습니다([SteveMacenski/slam_toolbox, 이슈 814](https://github.com/SteveMacenski/slam_toolbox/issues/814)).
#
# 17…이나 18…로 시작하는 측정 시각은 1970년부터 센 초입니다. 작은 숫자는 시뮬레이션이나 이 페이지 같은 곳에서 온 것입니다.

# %% [markdown] lang="en" name="bag-shell" slide="-"
# The same without a notebook, on a laptop without ROS:
#
# ```
# tflab doctor ~/bags/kitchen
# tflab ros2 --bag ~/bags/kitchen run tf2_ros tf2_echo map base_link
# ```

# %% [markdown] lang="ko" name="bag-shell" slide="-"
# 노트북(notebook) 없이, ROS가 없는 컴퓨터에서도 똑같이 할 수 있습니다.
#
# ```
# tflab doctor ~/bags/kitchen
# tflab ros2 --bag ~/bags/kitchen run tf2_ros tf2_echo map base_link
# ```

# %% [markdown] lang="en" name="bag-places-notes" slide="notes"
# The one number first, the doctor last. Stamps from before the recording are the trap; let somebody fall into it.

# %% [markdown] lang="ko" name="bag-places-notes" slide="notes"
# 숫자 하나를 먼저 보고 doctor는 마지막에 봅니다. 정적 변환의 시각이 기록 전체보다 오래된 것을 고장으로 보기 쉽습니다. 누군가 그렇게 말할 때까지 기다립니다.

# %% [markdown] lang="en" name="quotes-heading" slide="subslide"
# ## Break it: `"true"` in quotes

# %% [markdown] lang="ko" name="quotes-heading" slide="subslide"
# ## 일부러 고장 내기: 따옴표를 붙인 `"true"`

# %% [markdown] lang="en" name="quotes" slide="-"
# Somebody writes `"true"` in quotes into the parameter file. **Predict:** simulation time, system time, or no node at all?

# %% [markdown] lang="ko" name="quotes" slide="-"
# 누군가 파라미터 파일에 `"true"`처럼 따옴표를 붙였습니다. **예측해 봅시다.** 시뮬레이션 시간일까요, 시스템 시간일까요, 아니면 노드가 아예 시작되지 않을까요?

# %% name="quotes-run" tags=["predicted"] slide="fragment"
graph = lesson.new_graph()
(bags / "params.yaml").write_text('/**:\n  ros__parameters:\n    use_sim_time: "true"\n')
rclpy.try_shutdown()
rclpy.init(args=["mapper", "--ros-args", "--params-file", str(bags / "params.yaml")])
mapper = Node("mapper")
print("follows /clock:", mapper.get_clock().ros_time_is_active)
rclpy.shutdown()

# %% [markdown] lang="en" name="quotes-read" tags=["predicted"]
# A string is not a boolean. There is one line in the log, and the node goes on with system time. (A node in C++ is stricter: it does not start.)

# %% [markdown] lang="ko" name="quotes-read" tags=["predicted"]
# 문자열은 참·거짓 값이 아닙니다. 로그에 한 줄이 남고, 노드는 시스템 시간을 따르며 그대로 실행됩니다. (C++로 쓴 노드는 더 엄격해서 아예 시작되지 않습니다.)

# %% [markdown] lang="en" name="quotes-notes" slide="notes"
# Hands: simulation time, system time, or no node at all? Read the line of the log aloud; the node goes on.

# %% [markdown] lang="ko" name="quotes-notes" slide="notes"
# 손을 들게 합니다. 시뮬레이션 시간, 시스템 시간, 노드 없음 가운데 무엇입니까? 로그 한 줄을 소리 내어 읽습니다. 노드는 계속 실행됩니다.

# %% [markdown] lang="en" name="loop-blanks" slide="subslide"
# ## Two blanks: a bag in a loop

# %% [markdown] lang="ko" name="loop-blanks" slide="subslide"
# ## 빈칸 둘: 반복 재생되는 bag

# %% [markdown] lang="en" name="faded" slide="-"
# Fill in the two blanks: a bag in a loop, and a node that handles it.
#
# ```python
# # $ ros2 bag play lap ____________ --loop
# self.buffer = Buffer(____________)
# ```
#
# <details><summary>Compare</summary>
#
# `--clock`, and `node=self`. The node also needs `use_sim_time: true`; without it, its clock does not go back.
#
# </details>

# %% [markdown] lang="ko" name="faded" slide="-"
# 빈칸 두 개를 채워 보세요. 반복 재생되는 bag과, 그에 대비한 노드입니다.
#
# ```python
# # $ ros2 bag play lap ____________ --loop
# self.buffer = Buffer(____________)
# ```
#
# <details><summary>맞춰 보기</summary>
#
# `--clock`과 `node=self`입니다. 노드에는 `use_sim_time: true`도 필요합니다. 없으면 시각이 되돌아간 것을 알 수 없습니다.
#
# </details>

# %% [markdown] lang="en" name="faded-notes" slide="notes"
# For those who are quick; the others do it at home. There are two blanks, and the third thing that is needed is in the answer.

# %% [markdown] lang="ko" name="faded-notes" slide="notes"
# 빠른 사람이 풀고 나머지는 집에서 합니다. 빈칸은 둘이고, 하나 더 필요한 것은 답에 있습니다.

# %% [markdown] lang="en" name="earlier" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="earlier" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# 1. 06: why does a node that starts late on a robot receive `/tf_static`?
# 2. 08: what does `Time()` mean, and why is it not now?
# 3. 09: two texts mention the future, one by 0.05 s and one by a day. For which does waiting help?
#
# <details><summary>Answers</summary>
#
# 1. Its publisher keeps the last message for listeners that join later (transient local).
# 2. The latest common time of the path: the earliest of the newest samples. Nothing in the buffer is as new as now.
# 3. For the first, perhaps. The second comes from a clock that shows another day, and waiting does not help.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# 1. 06: 로봇에서 나중에 시작한 노드도 `/tf_static`을 받는 까닭은 무엇입니까?
# 2. 08: `Time()`은 무엇을 뜻하며, 왜 현재 시각이 아닙니까?
# 3. 09: "into the future" 오류 메시지가 두 개 있습니다. 하나는 0.05초, 하나는 하루 차이입니다. 기다리면 해결되는 것은 어느 쪽입니까?
#
# <details><summary>답</summary>
#
# 1. 발행자가 나중에 참가하는 노드를 위해 마지막 메시지를 보관합니다(transient local).
# 2. 경로의 최신 공통 시각입니다. 연결마다 최신 표본의 시각 가운데 가장 이른 것입니다. 버퍼에 현재 시각의 표본은 없습니다.
# 3. 앞의 것은 해결될 수 있습니다. 뒤의 것은 시계 문제입니다.
#
# </details>

# %% [markdown] lang="en" name="from-before-notes" slide="notes"
# For home; one of the three aloud if a minute is left.

# %% [markdown] lang="ko" name="from-before-notes" slide="notes"
# 집에서 합니다. 1분이 남으면 하나만 소리 내어 풉니다.

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice question

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제

# %% [markdown] lang="en" name="practice" slide="-"
# **13.** Why do you check `use_sim_time`, `/clock` and `/tf_static` when you work with a simulation or a bag? Write four or five sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] Stamps in a bag or a simulation come from its own clock and are not in system time. A node with `use_sim_time` reads the current time from `/clock`.
# - [ ] All nodes must agree: if one uses system time, its stamps and lookups are a day off, and other nodes get the errors.
# - [ ] With `use_sim_time` and without `/clock` the time stays at 0: timers never run, ages are wrong, and a lookup at the current time gives the latest without an error.
# - [ ] `/tf_static` is sent once. Without it, or if the playback begins after it, no sensor is connected to the robot.
# - [ ] In a loop time goes back, and earlier data has to be deleted.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# **13.** 시뮬레이션이나 bag으로 작업할 때 `use_sim_time`, `/clock`, `/tf_static`을 확인하는 까닭은 무엇입니까? 네다섯 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] bag과 시뮬레이션의 측정 시각은 시스템 시간이 아니라 자기 시간의 것입니다. `use_sim_time`을 켠 노드는 현재 시각을 `/clock`에서 얻습니다.
# - [ ] 모든 노드가 같아야 합니다. 하나라도 시스템 시간을 따르면 다른 날짜의 시각을 적고 조회하며, 오류는 다른 노드에서 납니다.
# - [ ] `use_sim_time`은 켰는데 `/clock`이 없으면 시간이 0에 멈춥니다. 타이머는 울리지 않고 나이는 틀린 값이 되며, 현재 시각을 조회하면 오류 없이 최신 변환이 나옵니다.
# - [ ] `/tf_static`은 한 번만 나옵니다. 없거나 그 뒤부터 재생하면 어떤 센서도 로봇에 연결되지 않습니다.
# - [ ] 반복 재생에서는 시각이 되돌아가므로, 전에 받은 것을 비워야 합니다.
#
# </details>

# %% [markdown] lang="en" name="practice-notes" slide="notes"
# Written at home. Five points make a full answer; the clock that stays at 0 is the one that is forgotten.

# %% [markdown] lang="ko" name="practice-notes" slide="notes"
# 집에서 씁니다. 완전한 답에는 다섯 가지가 있고, 0에 멈춘 시계를 가장 많이 빠뜨립니다.

# %% name="stop" tags=["collapsed"] slide="skip"
# Stop the nodes.
lesson.current_graph().stop()
rclpy.try_shutdown()
