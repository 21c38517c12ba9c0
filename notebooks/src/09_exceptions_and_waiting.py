# %% [markdown] lang="en" name="title" slide="slide"
# # 09 · Exceptions and waiting
#
# **Four ways to not get an answer** · about 35 minutes · builds on 04 and 08
#
# After this chapter you can
#
# - tell tf2's exceptions apart by their meaning, and say what to look at first for each,
# - read the text of an extrapolation exception,
# - tell delayed data from a wrong clock,
# - wait without blocking the thread that receives the transform,
# - decide how long to wait, how many messages to keep, and how old data may be when it moves a robot.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 09 · 예외와 기다림
#
# **조회가 실패하는 네 가지 경우** · 약 35분 · 04, 08장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - tf2의 예외를 뜻에 따라 구별하고, 예외마다 무엇부터 확인할지 말할 수 있습니다.
# - 외삽(extrapolation) 오류 메시지를 읽을 수 있습니다.
# - 데이터가 늦은 것인지 시계가 틀린 것인지 구별할 수 있습니다.
# - 변환을 받는 스레드를 막지 않고 기다릴 수 있습니다.
# - 얼마나 기다릴지, 몇 개까지 쌓아 둘지, 얼마나 오래된 데이터부터 로봇을 움직이는 데 쓰지 않을지 정할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Ask for a show of hands: who has fixed a TF warning by raising a timeout?
# Keep that question open. It is answered in the second half.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# timeout을 늘려서 TF 경고를 없애 본 사람은 손을 들어 보라고 합니다.
# 답은 아직 말하지 않습니다. 후반부에 나오고, 그때는 손을 내리고 싶은 사람이 생길 것입니다.

# %% [markdown] lang="en" name="what-you-need" slide="subslide"
# ## What you need to begin
#
# - **A node (08).** A node has *callbacks*: functions that run when a message arrives or a timer fires. An *executor* calls them. `rclpy.spin(node)` uses an executor with one thread, which runs one callback at a time.
#
# <details><summary>What the page uses of 04, 05, 06 and 08, if you have forgotten it</summary>
#
# - **The tree (04).** A frame without a parent is a root. Two frames are connected if the paths up from both end at the same root.
# - **The usual chain (05).** `map → odom → base_footprint → base_link → laser_frame`. A localiser publishes `map → odom`, the wheel odometry `odom → base_footprint`.
# - **Static and dynamic (06).** A mount is sent once on `/tf_static` and is valid at all times. What moves is sent repeatedly on `/tf`, with a stamp.
# - **The buffer (08).** It has a timeline for each edge. `Time()` means their latest common time.
#
# </details>

# %% [markdown] lang="ko" name="what-you-need" slide="subslide"
# ## 시작하기 전에 알아 둘 것
#
# - **노드(08).** 노드에는 메시지가 오거나 타이머가 울릴 때 실행되는 *콜백*(callback)이 있습니다. 콜백을 호출하는 것은 *실행기*(executor)입니다. `rclpy.spin(node)`는 스레드(thread)가 하나인 실행기를 쓰므로 콜백을 한 번에 하나만 실행합니다.
#
# <details><summary>04, 05, 06, 08장에서 쓰는 것(오래전에 보았다면)</summary>
#
# - **트리(04).** 부모가 없는 좌표계가 루트입니다. 두 좌표계에서 위로 올라가 같은 루트에 닿으면 서로 연결된 것입니다.
# - **흔히 쓰는 트리(05).** `map → odom → base_footprint → base_link → laser_frame`. `map → odom`은 위치 추정 노드가, `odom → base_footprint`는 바퀴 오도메트리 노드가 발행합니다.
# - **정적과 동적(06).** 나사로 고정된 것은 `/tf_static`으로 한 번만 보내며 어느 시각에나 유효합니다. 움직이는 것은 `/tf`로 계속 보내고, 보낼 때마다 측정 시각을 붙입니다.
# - **버퍼(08).** 연결마다 시간줄이 하나씩 있습니다. `Time()`은 시간줄들의 최신 공통 시각을 뜻합니다.
#
# </details>

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## 43 milliseconds into the future
#
# A small robot moved in jerks on its first drive, and RViz printed in its log: *extrapolation into the future*.
# RViz had looked up a time 43 ms newer than the newest transform that it had ([ROBOTIS-GIT/turtlebot3, issue 618](https://github.com/ROBOTIS-GIT/turtlebot3/issues/618)).
# The makers of the robot replied with a question: are its clock and the desktop's clock synchronised?
#
# Other users set a timeout (of a whole second, in one case), and the errors went away ([stella_vslam_ros, issue 21](https://github.com/stella-cv/stella_vslam_ros/issues/21); [perception_pcl, issue 416](https://github.com/ros-perception/perception_pcl/issues/416)).
# For some that was the fix. For others it only hid the fault.
# **How can you tell which?**
#
# Here is what two clocks look like. (The numbers are ours. "62 ms, dropped" means: received 62 ms after its stamp, and the desktop found no transform for that scan.)

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 43밀리초 미래
#
# 작은 로봇에 막 소프트웨어를 설치하고 처음 주행하는 날이었습니다.
# 로봇은 뚝뚝 끊기며 움직였고, RViz 로그에는 이런 문장이 나왔습니다. *extrapolation into the future.*
# RViz는 버퍼의 최신 변환보다 43 ms 미래인 시각의 변환을 조회하고 있었습니다([ROBOTIS-GIT/turtlebot3, 이슈 618](https://github.com/ROBOTIS-GIT/turtlebot3/issues/618)).
# 로봇 제조사는 이렇게 되물었습니다. 로봇과 데스크톱의 시계가 맞습니까?
#
# 같은 문장을 본 다른 사람들은 timeout을 넣었고(한 곳은 무려 1초), 오류는 사라졌습니다([stella_vslam_ros, 이슈 21](https://github.com/stella-cv/stella_vslam_ros/issues/21), [perception_pcl, 이슈 416](https://github.com/ros-perception/perception_pcl/issues/416)).
# 누군가에게는 제대로 된 해결책이었고, 누군가에게는 원인을 가린 임시방편이었습니다.
# **어느 쪽인지 어떻게 알 수 있을까요?**
#
# 두 시계가 어긋나면 밖에서는 이렇게 보입니다. 숫자는 예시입니다.
#
# *그림 읽기:* stamped (robot's clock) = 측정(로봇의 시계), sent (robot's clock) = 송신(로봇의 시계), received (desktop's clock) = 수신(데스크톱의 시계), dropped = 버림, on each clock = 저마다의 시계로. “62 ms, dropped”는 측정 시각에서 62 ms 뒤에 수신했지만 데스크톱이 변환을 찾지 못해 그 스캔을 버렸다는 뜻입니다.

# %% name="story-picture" tags=["collapsed"] slide="subslide"
# Draw the journeys of three scans.
from tf2_ros import Buffer
from tflab.core import StampedTransform, Transform, seconds

lesson.draw_journeys([
    lesson.Journey('scan 1', seconds(10.000), seconds(10.105), seconds(10.062)),
    lesson.Journey('scan 2', seconds(10.100), seconds(10.205), seconds(10.163)),
    lesson.Journey('scan 3', seconds(10.200), seconds(10.305), seconds(10.261)),
], {'stamped': "robot's clock", 'sent': "robot's clock", 'received': "desktop's clock"})

# %% [markdown] lang="en" name="story-read" slide="fragment"
# A message cannot arrive before it is sent.
# If it seems to, the cause is not the network. There are two clocks.

# %% [markdown] lang="ko" name="story-read" slide="fragment"
# 메시지는 보내기 전에 도착할 수 없습니다.
# 보내기 전에 도착한 것처럼 보인다면, 지금 보고 있는 것은 네트워크가 아니라 두 개의 시계입니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Let somebody read the picture aloud, row by row: stamped, sent, received.
# Wait until they stop and say: that cannot be.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 한 사람에게 그림을 한 줄씩 소리 내어 읽게 합니다. 측정, 송신, 수신 순서입니다.
# 읽다가 멈추고 “이럴 수는 없는데요”라고 말하는 순간을 기다립니다.

# %% [markdown] lang="en" name="predict-windows" slide="slide"
# ## Predict: which lookup succeeds?
#
# This [[buffer]] has data for the path from `map` to `laser_frame`.
# `map → odom` is published twice a second, and its last sample is from 14.0 s.
# `odom → base_footprint` is published five times a second. The odometry node was started late, at 11.0 s, and its last sample is from 14.6 s.
# The other two edges are mounts.

# %% [markdown] lang="ko" name="predict-windows" slide="slide"
# ## 예측해 봅시다: 어느 조회에서 값이 나올까요?
#
# 이 [[buffer|변환 버퍼(buffer)]]에는 목표 `map`, 원본 `laser_frame`인 조회에 필요한 연결이 모두 들어 있습니다.
# `map → odom`은 1초에 두 번 오고, 마지막 표본은 14.0초의 표본입니다.
# `odom → base_footprint`는 1초에 다섯 번 옵니다. 오도메트리 노드는 11.0초에야 켜졌고, 마지막 표본은 14.6초의 표본입니다.
# 나머지 두 연결은 나사로 고정되어 있습니다. *그림 읽기:* stamp = 측정 시각, all of them = 모든 시간줄에 값이 있는 구간.

# %% name="four-edges" tags=["collapsed"] slide="-"
# Make such a buffer.
def four_edges(ahead_s=0.0):  # how far ahead the localiser dates its transforms
    made = Buffer()
    store = made.core.set_transform  # the engine inside tf2_ros.Buffer
    for i in range(9):
        odom = StampedTransform('map', 'odom', seconds(10.0 + 0.5 * i + ahead_s), Transform((0.1, 0.0, 0.0)))
        store(odom, 'localization')
    for i in range(19):
        base = StampedTransform('odom', 'base_footprint', seconds(11.0 + 0.2 * i), Transform((0.1 * i, 0.0, 0.0)))
        store(base, 'wheel_odometry')
    for parent, child, x, z in (('base_footprint', 'base_link', 0.0, 0.05), ('base_link', 'laser_frame', 0.20, 0.15)):
        store(StampedTransform(parent, child, 0, Transform((x, 0.0, z))), 'urdf', is_static=True)
    return made

# %% name="windows" tags=["collapsed"] slide="subslide"
# Draw its timelines, with a lookup at 12.3 s.
buffer = four_edges()
lesson.draw_history(buffer, 'map', 'laser_frame', seconds(12.3))

# %% [markdown] lang="en" name="predict-question" slide="fragment"
# At 12.3 s there is an answer, although no sample has exactly this time: tf2 interpolates.
#
# **Write down before you go on.** (`map ← laser_frame` means: wanted in map, expressed in laser_frame.)
# You look up the transform `map ← laser_frame` **at 14.3 s**, and then **at 10.6 s**.
# For each: an answer or an exception? Which exception? Because of which edge?
#
# <details><summary>A hint, if you need one</summary>
#
# The timelines do not end together. A lookup needs a value of every timeline at the same time.
#
# </details>

# %% [markdown] lang="ko" name="predict-question" slide="fragment"
# 12.3초의 값은 나옵니다. 마침 표본과 표본 사이인데도 그렇습니다.
#
# **실행하기 전에 적어 보세요.** (`map ← laser_frame`처럼 목표 ← 원본으로 적습니다. 데이터의 기준이 바뀌는 방향입니다.)
# 누군가 **14.3초**의 변환 `map ← laser_frame`을, 그다음 **10.6초**의 변환 `map ← laser_frame`을 조회합니다.
# 각각 값이 나올까요, 예외가 나올까요? 어떤 예외일까요? 어느 연결 때문일까요?
#
# <details><summary>힌트가 필요하면 열어 보세요</summary>
#
# 시간줄마다 끝나는 시각이 다릅니다. 경로를 따라가려면 요청 시각에 모든 시간줄에 값이 있어야 합니다.
#
# </details>

# %% name="ask-three" tags=["predicted"] slide="subslide"
from rclpy.time import Time
from tf2_ros import ExtrapolationException, TransformException

for second in (12.3, 14.3, 10.6):
    try:
        buffer.lookup_transform('map', 'laser_frame', Time(seconds=second))
        print(f'{second}: an answer')
    except TransformException as error:
        print(f'{second}: {type(error).__name__}\n      {error}')

# %% [markdown] lang="en" name="compare-three" tags=["predicted"] slide="-"
# Both raise an [[extrapolation exception|ExtrapolationException]]: there is a path, but not at that time, and tf2 never guesses beyond its samples.
# At 14.3 s it was `map → odom` that ended too early: the *localiser*, although the odometry had data until 14.6 s.
# At 10.6 s it was `odom → base_footprint` that began too late.
#
# Now look at the text again. It names neither `odom` nor `base_footprint`.
# **The text names the two frames of the lookup. It does not name the edge that limits it.**
# On a robot, people read "laser_frame", and replace the laser's cable.

# %% [markdown] lang="ko" name="compare-three" tags=["predicted"] slide="-"
# 둘 다 [[extrapolation exception|ExtrapolationException(시간 외삽 예외)]]입니다. 경로는 있지만 그 시각의 값이 없고, tf2는 표본 바깥을 절대 짐작하지 않습니다.
# 14.3초에서는 `map → odom`이 너무 일찍 끝났습니다. 오도메트리에는 14.6초까지 표본이 있었으니, 원인은 *위치 추정 노드*입니다.
# 10.6초에는 `odom → base_footprint`의 표본이 없습니다. 이 연결은 11.0초에 시작했습니다.
#
# 이제 오류 메시지를 다시 보세요. `odom`도 `base_footprint`도 나오지 않습니다.
# **오류 메시지에는 조회한 두 좌표계의 이름만 나오고, 어느 연결에서 막혔는지는 나오지 않습니다.**
# 그래서 현장에서는 “laser_frame”을 읽고 레이저 케이블부터 바꾸는 일이 생깁니다.

# %% [markdown] lang="en" name="compare-three-notes" slide="notes"
# Ask who blamed the odometry for 14.3 s. That is the common guess, because it is the one that moves.
# The data of a path ends where the first of its edges ends.

# %% [markdown] lang="ko" name="compare-three-notes" slide="notes"
# 14.3초에서 오도메트리를 탓한 사람이 있는지 묻습니다. 움직이는 것이 오도메트리라서 흔히 그렇게 추측합니다.
# 경로에서 값이 있는 구간은 가장 일찍 끝나는 시간줄까지입니다.

# %% [markdown] lang="en" name="family" slide="slide"
# ## The idea in a sentence: name, path, time
#
# A lookup needs valid arguments, two names, a path, and data for the time. The exception shows which of these tf2 first found missing.
#
# | a lookup needs | otherwise tf2 raises | look first at |
# | --- | --- | --- |
# | valid arguments: no empty name, no `/` at the beginning | [[invalid argument exception|InvalidArgumentException]] | the line of the lookup, `header.frame_id` |
# | two **names** in this buffer | [[lookup exception|LookupException]] | spelling; is its publisher running? |
# | a **path**: both names in one tree | [[connectivity exception|ConnectivityException]] | `view_frames`: two roots |
# | data for that **time** on every edge of the path | [[extrapolation exception|ExtrapolationException]] | stamps and clocks |
#
# Their common base class is [[transform exception|TransformException]].

# %% [markdown] lang="ko" name="family" slide="slide"
# ## 한 문장으로: 이름, 경로, 시각
#
# 조회하려면 올바른 인자, 두 이름, 경로, 그 시각의 값이 있어야 합니다. tf2가 처음으로 없다고 확인한 것에 따라 예외가 정해집니다.
#
# | 조회에 필요한 것 | 없으면 나는 예외 | 먼저 볼 곳 |
# | --- | --- | --- |
# | 올바른 인자: 이름이 비어 있거나 `/`로 시작하면 안 됩니다 | [[invalid argument exception|InvalidArgumentException(잘못된 인자 예외)]] | 조회하는 코드, `header.frame_id` |
# | 이 버퍼에 있는 두 **이름** | [[lookup exception|LookupException(좌표계 조회 예외)]] | 철자, 발행 노드가 실행 중인지 |
# | **경로**: 두 이름이 한 트리에 있어야 합니다 | [[connectivity exception|ConnectivityException(연결 예외)]] | `view_frames`: 루트가 둘 |
# | 경로의 모든 연결에 그 **시각**의 값 | [[extrapolation exception|ExtrapolationException(시간 외삽 예외)]] | 측정 시각(stamp)과 시계 |
#
# 이들의 공통 부모 클래스가 [[transform exception|TransformException]]입니다.

# %% [markdown] lang="en" name="worked" slide="slide"
# ## A worked example: reading one line
#
# ```text
# Lookup would require extrapolation into the future.  Requested time 14.300000
# but the latest data is at time 14.000000,
# when looking up transform from frame [laser_frame] to frame [map]
# ```
#
# 1. **Which kind?** "into the future": the requested time is newer than all data of one of the edges.
# 2. **Whose time?** "Requested time 14.300000" was the time argument of the lookup, usually `header.stamp` of a message.
# 3. **How far outside?** 14.3 − 14.0 = 0.3 s.
# 4. **Which data, wanted where?** "from frame [laser_frame] to frame [map]": data expressed in `laser_frame`, wanted in `map`. That is the sentence of chapter 03, and neither frame is the cause.
# 5. **Which edge?** The one on the path whose *newest* sample is from 14.000000. Look for that number: `map → odom`.

# %% [markdown] lang="ko" name="worked" slide="slide"
# ## 예제: 오류 메시지 한 줄 읽기
#
# ```text
# Lookup would require extrapolation into the future.  Requested time 14.300000
# but the latest data is at time 14.000000,
# when looking up transform from frame [laser_frame] to frame [map]
# ```
#
# 1. **어떤 종류일까요?** "into the future": 경로의 한 연결에서, 요청 시각이 최신 표본보다 미래입니다.
# 2. **누구의 시각일까요?** "Requested time 14.300000"은 *조회한 쪽*이 준 요청 시각입니다. 대개 메시지의 `header.stamp`입니다.
# 3. **얼마나 벗어났을까요?** 14.3 − 14.0 = 0.3초입니다.
# 4. **어떤 데이터를 어느 좌표계 기준으로 보려 했을까요?** "from frame [laser_frame] to frame [map]": `laser_frame` 기준 데이터를 `map` 기준으로 보려 합니다. 03장의 그 문장이며, 어느 이름도 원인으로 지목된 것이 아닙니다.
# 5. **어느 연결일까요?** 경로 위에서 *최신* 표본이 14.000000인 연결입니다. 그 숫자를 찾으면 `map → odom`입니다.

# %% [markdown] lang="en" name="faded" slide="subslide"
# ## Your turn, with two blanks
#
# Here is the other line. Fill in the two blanks, and run the cell.

# %% [markdown] lang="ko" name="faded" slide="subslide"
# ## 빈칸을 채워 보세요
#
# 이번에는 다른 줄입니다. 빈칸 두 개를 채우고 셀을 실행해 보세요.

# %% name="two-blanks" slide="-"
# ... into the past.  Requested time 10.600000 but the earliest data is at time 11.000000,
# when looking up transform from frame [laser_frame] to frame [map]
outside_s = ...  # how far outside [s]
stopped_at = ...  # the child frame of the edge that begins at that time, as a str

if ... in (outside_s, stopped_at):
    print('2 blanks')
else:
    print('how far:', 'yes' if abs(outside_s - 0.4) < 1e-6 else 'not yet: requested and earliest, subtracted')
    print('where:', 'yes' if stopped_at == 'base_footprint' else 'not yet: which timeline begins at 11.0?')

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it, one by one
#
# You have caused two extrapolation exceptions. Now cause a LookupException and a ConnectivityException. The red texts are those of a robot, to the letter.
# (`%xmode Minimal` leaves out the traceback. On a robot, read its **last** line.)

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기: 하나씩
#
# 외삽 예외는 이미 두 번 만났습니다. 이번에는 LookupException과 ConnectivityException을 일부러 만들어 봅시다. 빨간 글씨는 실제 로봇에서 나오는 것과 한 글자도 다르지 않습니다.
# (`%xmode Minimal`은 traceback을 생략합니다. 로봇에서는 traceback의 **마지막** 줄을 읽으십시오.)

# %% [markdown] lang="en" name="break-lookup-why" slide="subslide"
# ### A name that no node has published

# %% [markdown] lang="ko" name="break-lookup-why" slide="subslide"
# ### 아무도 발행한 적 없는 이름

# %% name="break-lookup" tags=["raises-exception"] slide="-"
# %xmode Minimal
buffer.lookup_transform('map', 'laser_fame', Time())

# %% [markdown] lang="en" name="lookup-read" slide="-"
# The text names the argument and the frame. Read the name letter by letter.
# The same exception comes in the first second after every start: the name is right, and its publisher has not published yet.
# So a [[lookup exception|LookupException]] is a typo *or* a lookup that came too early.

# %% [markdown] lang="ko" name="lookup-read" slide="-"
# 어느 인자의 어느 이름인지 알려 줍니다. 이름을 한 글자씩 읽어 보세요. (여기서는 frame의 r이 빠졌습니다.)
#
# 노드를 켠 뒤 처음 1초 동안에도 같은 예외가 나옵니다. 이름은 맞지만 발행자가 아직 아무것도 발행하지 않은 것입니다.
# 그래서 [[lookup exception|LookupException(좌표계 조회 예외)]]의 원인은 오타일 수도 있고, 너무 일찍 조회한 것일 수도 있습니다.

# %% [markdown] lang="en" name="connectivity-why" slide="subslide"
# ### A typo in the middle of the tree
#
# Somebody mounts a camera, and writes `base_lnk`.

# %% [markdown] lang="ko" name="connectivity-why" slide="subslide"
# ### 트리 한가운데의 오타
#
# 누군가 카메라를 달면서 `base_lnk`라고 적었습니다.

# %% name="break-connectivity" tags=["raises-exception"] slide="-"
from geometry_msgs.msg import TransformStamped

mount = TransformStamped()
mount.header.frame_id, mount.child_frame_id = 'base_lnk', 'camera_link'
mount.transform.translation.x, mount.transform.rotation.w = 0.10, 1.0
buffer.set_transform_static(mount, 'camera')
buffer.lookup_transform('map', 'camera_link', Time())

# %% [markdown] lang="en" name="connectivity-read" slide="-"
# Both names are known, and they are spelt correctly. The text does not contain the typo at all.
# So do not search the names of a [[connectivity exception|ConnectivityException]]. Look at the **roots**: the names that occur in the list below only as a parent. There are two, and one of them is misspelt.

# %% [markdown] lang="ko" name="connectivity-read" slide="-"
# 두 이름 모두 버퍼에 있고 철자도 맞습니다. 오류 메시지 어디에도 오타가 없습니다.
# 따라서 [[connectivity exception|ConnectivityException(연결 예외)]]에서는 두 이름이 아니라 **루트**를 보십시오. 아래 목록에서 부모(parent)로만 나오는 이름입니다. 루트가 둘이고, 그중 하나의 철자가 틀렸습니다.

# %% name="two-roots" slide="-"
print(buffer.all_frames_as_string())

# %% [markdown] lang="en" name="handler" slide="slide"
# ## Four exceptions, four actions
#
# Each class needs a different action, so your code must distinguish them.

# %% [markdown] lang="ko" name="handler" slide="slide"
# ## 네 가지 예외, 네 가지 행동
#
# 예외의 종류가 다르면 할 일도 다릅니다. 그래서 코드에서 예외를 구별해야 합니다.

# %% name="handler-code" slide="-"
from tf2_ros import ConnectivityException, LookupException


def answer_or_advice(target, source, stamp):
    try:
        buffer.lookup_transform(target, source, stamp)
        return 'use it'
    except LookupException:
        return 'check the name'
    except ConnectivityException:
        return 'check the tree'
    except ExtrapolationException as error:  # the direction is in the text
        return 'wait' if 'into the future' in str(error) else 'drop'
    except TransformException:  # the base class comes last
        return 'fix the call'

# %% name="handler-run" slide="subslide"
for target, source, second in (
    ('map', 'laser_frame', 12.3), ('map', 'laser_fame', 12.3), ('map', 'camera_link', 12.3),
    ('map', 'laser_frame', 14.3), ('map', 'laser_frame', 10.6), ('/map', 'laser_frame', 12.3),
):
    advice = answer_or_advice(target, source, Time(seconds=second))
    print(f'{target:>5} <- {source:<12} at {second}: {advice}')

# %% [markdown] lang="en" name="handler-traps" slide="-"
# Three traps:
#
# - **The base class first.** Put `except TransformException` at the top, and the others are never reached. Python takes the first branch that fits.
# - **Not everything is a `TransformException`.** Without `import tf2_geometry_msgs`, `transform()` raises a `TypeException`, which none of these branches catches (chapter 08).
# - **Another release of ROS 2.** Where an exception is imported from, and what a call accepts, may differ. Look into the package that is installed on your robot. This prints where it is:
#
# ```bash
# python3 -c "import tf2_ros; print(tf2_ros.__file__)"
# ```

# %% [markdown] lang="ko" name="handler-traps" slide="-"
# *출력 읽기:* use it = 사용, check the name = 이름 확인, check the tree = 트리 확인, wait = 조금 기다림, drop = 버림, fix the call = 코드 수정.
#
# 함정이 세 가지 있습니다.
#
# - **부모 클래스를 먼저 쓰는 것.** `except TransformException`을 맨 위에 두면 나머지에는 영영 도달하지 못합니다. 파이썬은 조건에 맞는 분기 중에서 맨 위의 것을 택합니다.
# - **모두가 `TransformException`은 아닙니다.** `import tf2_geometry_msgs`를 빠뜨리면 `transform()`은 `TypeException`을 일으키고, 이것은 위의 어느 분기에도 걸리지 않습니다(08장).
# - **ROS 2 배포판이 다를 때.** 예외를 어디서 import하는지, 호출에 무엇을 넘기는지는 배포판마다 다를 수 있습니다. 로봇에 설치된 패키지를 직접 확인하십시오. 그 경로는 다음 명령으로 알 수 있습니다.
#
# ```bash
# python3 -c "import tf2_ros; print(tf2_ros.__file__)"
# ```

# %% [markdown] lang="en" name="future-past" slide="slide"
# ## Future and past: the causes
#
# `[-----]` is the data in the buffer, `x` the requested time:
#
# ```text
# x [-----]   past
#   [--x--]   an answer
#   [-----] x future
# ```
#
# | x: the requested time | ordinary causes | faults to repair |
# | --- | --- | --- |
# | **future**: newer than the newest sample | the transform is on its way; its publisher is slow (10 Hz means up to 100 ms) | the sensor's clock is ahead; the publisher's clock is behind; the publisher has died |
# | **past**: older than the oldest sample | the message is from before the start of TF; processing took longer than the cache time | the sensor's clock is behind; a bag's old stamps with today's TF |
#
# First subtract the two times of the text.
# If they are 1763690412 s and 30 s, nothing is slow: one node counts from 1970, the other from the start of a simulation (`use_sim_time`, chapter 10).
#
# For the past, waiting is useless: old data does not come back.
# For the future, waiting *may* help. The rest of this page is about that "may".

# %% [markdown] lang="ko" name="future-past" slide="slide"
# ## 미래와 과거: 원인
#
# `[-----]`는 버퍼에 값이 있는 구간, `x`는 요청 시각입니다.
#
# ```text
# x [-----]   과거 외삽
#   [--x--]   값이 나옴
#   [-----] x 미래 외삽
# ```
#
# | x: 요청 시각 | 흔한 원인 | 고쳐야 할 결함 |
# | --- | --- | --- |
# | **미래**: 최신 표본보다 나중의 시각 | 변환이 오는 중입니다. 발행률이 낮습니다(10 Hz면 최대 100 ms) | 센서 시계가 앞서 있습니다. 발행자 시계가 뒤처져 있습니다. 발행자가 종료되었습니다 |
# | **과거**: 가장 오래된 표본보다 이른 시각 | TF가 시작되기 전의 메시지입니다. 처리 시간이 버퍼의 보관 시간보다 깁니다 | 센서 시계가 뒤처져 있습니다. bag 파일에 기록된 옛 시각으로 오늘의 TF를 조회했습니다 |
#
# 먼저 오류 메시지의 두 시각부터 빼 보십시오.
# 1763690412초와 30초가 나란히 나온다면, 늦은 것이 아니라 시계가 다른 것입니다. 한 노드는 1970년부터, 다른 노드는 시뮬레이션의 시작부터 셉니다(`use_sim_time`, 10장).
#
# 과거라면 기다려도 소용없습니다. 지나간 데이터는 다시 오지 않습니다.
# 미래라면 기다림이 도움이 될 *수도* 있습니다. 어느 때 도움이 되는지를 이 장의 나머지에서 다룹니다.

# %% [markdown] lang="en" name="late-or-wrong" slide="slide"
# ## Late, or wrong?
#
# Two robots. On robot A, the Wi-Fi slows down at 3 s, and every transform takes 0.2 to 0.4 s to arrive. On robot B, at 3 s the clock of the laser's computer is set 0.3 s ahead.
#
# A node measures one number: the **gap**, which is the stamp of a scan minus the latest common time (`buffer.get_latest_common_time`).
# A positive gap is an extrapolation into the future.

# %% [markdown] lang="ko" name="late-or-wrong" slide="slide"
# ## 늦은 것일까요, 틀린 것일까요?
#
# 로봇이 두 대 있습니다. 로봇 A에서는 3초에 Wi-Fi가 잠시 느려져 변환이 도착하는 데 0.2~0.4초가 걸립니다. 로봇 B에서는 3초에 레이저 컴퓨터의 시계가 0.3초 앞서게 됩니다.
#
# 노드가 숫자 하나를 계속 계산합니다. **간격(gap)**, 즉 스캔의 측정 시각에서 경로의 최신 공통 시각(`buffer.get_latest_common_time`)을 뺀 값입니다.
# 간격이 양수이면 미래 외삽입니다.

# %% name="robot-a" tags=["collapsed"] slide="subslide"
# Run robot A until 7 s.
from rclpy.duration import Duration

graph = lesson.new_graph()  # a fresh robot; its clock stands at 1 s
lesson.launch(graph)
robot_a = lesson.run_node(lesson.GapWatcher, 2.0)
graph.disturb('/tf', delay=0.2, jitter=0.2, seed=1)  # the Wi-Fi hiccups ...
graph.run(seconds=1.5)
graph.disturb('/tf')  # ... and recovers
graph.run(seconds=2.5)

# %% name="robot-b" tags=["collapsed"] slide="-"
# Run robot B until 7 s.
graph = lesson.new_graph()
lesson.launch(graph)
robot_b = lesson.run_node(lesson.GapWatcher, 2.0)
graph.set_clock_offset('laser_driver', 0.3)  # somebody "sets the clock"
graph.run(seconds=4)

# %% [markdown] lang="en" name="first-second" slide="subslide"
# Here are both, but only up to one second after the fault began.
#
# **Predict.** Your node waits at most 0.1 s. Which of the two robots recovers by itself? Could you tell, if this was all you had?

# %% [markdown] lang="ko" name="first-second" slide="subslide"
# 두 로봇을 나란히 그렸습니다. 다만 문제가 생긴 뒤 1초까지만입니다.
#
# **예측해 봅시다.** 여러분의 노드는 최대 0.1초를 기다립니다. 둘 중 어느 로봇이 저절로 나아질까요? 이 그림만 가지고 알 수 있을까요? (*그림 읽기:* gap = 간격, limit = 기다리는 한도)

# %% name="two-gaps-first" tags=["collapsed"] slide="-"
# Draw the gaps of both robots up to 4 s.
lesson.draw_ages([robot_a.curve('robot A', 4.0), robot_b.curve('robot B', 4.0)], 'gap', limit_s=0.1)

# %% [markdown] lang="en" name="late-notes" slide="notes"
# Show the first second only, and let them argue. There is no right answer yet, and that is the point.

# %% [markdown] lang="ko" name="late-notes" slide="notes"
# 처음 1초만 보여 주고 토론하게 합니다. 아직 정답이 없다는 것이 요점입니다.

# %% [markdown] lang="en" name="whole-story" slide="subslide"
# For a second they look alike. Now the whole recording.

# %% [markdown] lang="ko" name="whole-story" slide="subslide"
# 처음 1초 동안은 똑같아 보입니다. 이제 전체를 봅시다.

# %% name="two-gaps" tags=["predicted", "collapsed"] slide="-"
# Draw the gaps of both robots up to 7 s.
lesson.draw_ages([robot_a.curve('robot A', 7.0), robot_b.curve('robot B', 7.0)], 'gap', limit_s=0.1)

# %% [markdown] lang="en" name="two-gaps-read" tags=["predicted"] slide="subslide"
# A recovers. B never does.
#
# - **A delay passes, and it varies** (look at A's curve). Waiting bridges it.
# - **A [[clock offset]] stays, and it is constant.** Waiting does not reduce it.
#
# But you need not wait and see. `ros2 topic delay` prints *the time of arrival* minus *the stamp*. This is robot B, still running:

# %% [markdown] lang="ko" name="two-gaps-read" tags=["predicted"] slide="subslide"
# A는 회복됩니다. B는 끝내 회복되지 않습니다.
#
# - **지연은 한때이고, 값에 지터가 있습니다**(A의 선이 들쭉날쭉합니다). 잠깐 기다리면 해결됩니다.
# - **[[clock offset|시계 차이(clock offset)]]는 사라지지 않고, 값이 일정합니다.** 기다려도 줄지 않습니다.
#
# 하지만 오래 지켜볼 필요도 없습니다. `ros2 topic delay`는 메시지를 *받은 시각*에서 *측정 시각*을 뺀 값을 보여 줍니다. 아직 달리고 있는 로봇 B에서 실행해 봅시다.

# %% name="delay-scan" slide="-"
# %ros2 --for 1.5 topic delay /scan
# %ros2 --for 1.5 topic delay /odom

# %% [markdown] lang="en" name="delay-read" slide="-"
# `/scan`: a negative delay. The scan arrived 0.195 s *before it was measured*. That is impossible, so a clock is wrong.
# (With a healthy laser it is +0.105 s, because a sweep takes a tenth of a second.)
#
# `/odom`: 0.004 s. The odometry node stamps it by the same clock as its transforms, so their side is healthy. The laser's clock is wrong.

# %% [markdown] lang="ko" name="delay-read" slide="-"
# `/scan`은 지연이 음수입니다. 스캔을 측정 시각보다 0.195초 *먼저* 받았습니다. 그럴 수는 없으니, 시계가 틀린 것입니다.
# (정상인 레이저라면 한 번 훑는 데 0.1초가 걸리므로 +0.105초가 나옵니다.)
#
# `/odom`은 0.004초입니다. 오도메트리 노드는 `/odom`과 변환에 같은 시계의 시각을 적으므로 변환 쪽은 정상입니다. 원인은 레이저의 시계입니다.

# %% [markdown] lang="en" name="plaster" slide="slide"
# ## Break it: the workaround
#
# Robot B again, with a clock 0.3 s ahead. Somebody sets `timeout=Duration(seconds=1)`, as the users of the story did.
# (The node spins with several threads. The reason follows below.)
# The robot drives its first curve, at half a metre per second.
#
# **Predict.** Will the warnings go away? Will the walls stay where they are?

# %% [markdown] lang="ko" name="plaster" slide="slide"
# ## 일부러 고장 내기: 임시방편
#
# 다시 시계가 0.3초 앞선 로봇 B입니다. 누군가 인터넷 게시글에서 본 대로 `timeout=Duration(seconds=1)`을 넣었습니다.
# (그리고 기다림이 통하도록 스레드 여러 개로 spin합니다. 이유는 잠시 뒤에 나옵니다.)
# 로봇은 0.5 m/s로 첫 굽이를 돕니다.
#
# **예측해 봅시다.** 경고가 사라질까요? 벽은 제자리에 있을까요?

# %% name="placer" slide="subslide"
class ScanPlacer(lesson.WaitingNode):  # a node with self.buffer, which receives /tf and /scan
    def on_scan(self, scan):
        stamp = Time.from_msg(scan.header.stamp)
        try:
            self.buffer.lookup_transform('map', 'laser_frame', stamp, timeout=Duration(seconds=1))
            self.answers.append((scan, stamp))
        except TransformException:
            self.failures += 1

# %% name="plaster-run" tags=["predicted", "collapsed"] slide="-"
# Run ScanPlacer on robot B.
from rclpy.executors import MultiThreadedExecutor

graph = lesson.new_graph()
graph.set_clock_offset('laser_driver', 0.3)
lesson.launch(graph)
placer = lesson.run_node(ScanPlacer, 9.0, MultiThreadedExecutor)  # 6 s straight on, then the bend
print(len(placer.answers), 'placed,', placer.failures, 'failed')

# %% [markdown] lang="en" name="plaster-green" tags=["predicted"] slide="subslide"
# There is not one warning. The users of the story seem to be right.
# Now draw the points of the curve. The grey lines are the real walls.

# %% [markdown] lang="ko" name="plaster-green" tags=["predicted"] slide="subslide"
# 경고가 하나도 없습니다. 인터넷 게시글의 말이 맞는 것처럼 보입니다.
# 이제 굽이에서 얻은 점들이 어디에 찍혔는지 그려 봅시다. 회색 선이 실제 벽입니다.

# %% [markdown] lang="en" name="plaster-notes" slide="notes"
# Before the picture, take a vote: is the map right or wrong? The log shows no warning, so most will say right.
# After it, come back to the hands of the beginning.

# %% [markdown] lang="ko" name="plaster-notes" slide="notes"
# 그림을 보여 주기 전에 손을 들게 합니다. 지도는 맞습니까, 틀립니까? 로그에 경고가 없어서 대부분 맞다고 합니다.
# 그림을 본 다음, 처음에 손을 들었던 사람들에게 다시 묻습니다.

# %% name="plaster-picture" tags=["predicted", "collapsed"] slide="subslide"
# Draw the last ten scans on the map.
bend = placer.answers[-10:]
lesson.draw_placed({
    'as measured': lesson.walls_seen(placer.buffer, bend, clock_error_s=0.3),
    'with the wait that "works"': lesson.walls_seen(placer.buffer, bend),
}, walls=lesson.ROOM.walls)

# %% [markdown] lang="en" name="plaster-read" tags=["predicted"] slide="subslide"
# The wait ended each time, because after a while TF had data for the *wrong* stamp.
# The lookup then returned the laser's pose 0.3 s **after** the measurement.
# On the left, the stamps are corrected by 0.3 s: 0.07 m off on average. On the right, as the node used them: 0.32 m.
#
# A timeout checks whether the transform is there. It cannot check whether the stamp is true.
# **Waiting fixes a delay. It does not fix a clock: it hides the fault.**

# %% [markdown] lang="ko" name="plaster-read" tags=["predicted"] slide="subslide"
# *그림 읽기:* as measured = 측정한 그대로, with the wait that "works" = “통한다는” 기다림으로, x / y in map = map 기준 x / y, off by … on average / at worst = 벽에서 평균 / 최대로 벗어난 거리.
#
# 기다림은 매번 성공했습니다. 잠시 뒤 *틀린* 시각의 변환까지 버퍼에 들어왔기 때문입니다.
# 그래서 측정하고 0.3초 **지난 다음**의 레이저 포즈가 나왔습니다. 필요한 것은 측정한 시각의 포즈였습니다.
# 왼쪽은 측정 시각에서 0.3초를 빼서 바로잡은 것으로 평균 0.07 m, 오른쪽은 노드가 쓴 그대로로 평균 0.32 m 벗어났습니다.
#
# timeout은 변환이 왔는지 확인할 뿐, 시각이 맞는지는 확인하지 않습니다.
# **데이터가 늦은 것이면 기다림으로 해결됩니다. 시계 차이는 해결되지 않고 드러나지 않게 될 뿐입니다.**

# %% [markdown] lang="en" name="lanes" slide="slide"
# ## Where may I wait?
#
# For delayed data a short wait is right. Robot C has no fault at all. Still, a careful programmer gives the lookup a timeout of half a second.
#
# The node records when `/tf` messages are stored, and when its callback is busy.
#
# **Predict.** The robot runs for three seconds, ten scans a second. How many scans get their transform?

# %% [markdown] lang="ko" name="lanes" slide="slide"
# ## 어디서 기다려도 될까요?
#
# 앞에서 보았듯이, 데이터가 늦은 것이라면 잠깐 기다리면 됩니다. 로봇 C는 시계도 정확하고 네트워크도 빠릅니다. 잘못된 것이 하나도 없습니다.
# 그래도 조심스러운 프로그래머는 혹시 몰라 조회의 timeout을 0.5초로 정했습니다.
#
# 노드는 `/tf` 메시지가 언제 저장되는지, 콜백이 언제부터 언제까지 바쁜지를 적어 둡니다. *그림 읽기:* time = 시각, sent = 보냄, stored = 저장됨.
#
# **예측해 봅시다.** 로봇은 3초 동안 달리고 스캔은 1초에 열 번 옵니다. 스캔 몇 개가 변환을 얻을까요?

# %% name="robot-c" tags=["predicted"] slide="subslide"
class Patient(lesson.WaitingNode):
    def on_scan(self, scan):
        stamp = Time.from_msg(scan.header.stamp)
        try:
            self.buffer.lookup_transform('map', 'laser_frame', stamp, timeout=Duration(seconds=0.5))
            self.answers.append('ok')
        except TransformException as error:
            self.answers.append(str(error).partition(', when')[0])


patient = lesson.on_robot_c(Patient)
print(*patient.answers, sep='\n')

# %% [markdown] lang="en" name="lanes-read" tags=["predicted"] slide="-"
# None. The callback returned only five times, each time with an exception. ("Only time … is in the buffer": an edge has one sample so far.)
#
# The first scan is 51 ms older than the first transform, so the callback waits its half second for nothing.
# But why does it not recover? At the end it looks up 2.595 s, and the newest transform that it has is from 1.146 s. The longer it waits, the older its data is.

# %% [markdown] lang="ko" name="lanes-read" tags=["predicted"] slide="-"
# 하나도 얻지 못했습니다. 3초 동안 콜백은 다섯 번만 끝났고, 그때마다 예외가 났습니다. (“only time … is in the buffer”는 표본이 아직 하나뿐인 연결이 있다는 뜻입니다.)
#
# 첫 스캔의 측정 시각은 첫 변환보다 51 ms 과거여서 값이 있을 수 없었고, 콜백은 0.5초를 헛되이 기다렸습니다.
# 그런데 왜 회복되지 않을까요? 마지막에는 2.595초의 변환을 조회하지만, 버퍼의 최신 변환은 1.146초의 변환입니다. 기다릴수록 버퍼가 더 뒤처집니다.

# %% name="lanes-picture" tags=["predicted", "collapsed"] slide="subslide"
# Draw when the node was busy.
lesson.draw_lanes(patient)

# %% [markdown] lang="en" name="lanes-why" slide="-"
# `rclpy.spin(node)` has one thread. Between two calls of `on_scan` it processes a single message. While `on_scan` waits in that thread, the listener is not called, and the transform stays in the queue.
# The callback waits for the mail, and it is also the postman.

# %% [markdown] lang="ko" name="lanes-why" slide="-"
# `rclpy.spin(node)`에는 스레드가 하나뿐입니다. `on_scan`이 끝나고 다음 `on_scan`이 시작될 때까지 `/tf` 메시지를 겨우 하나 처리합니다. `on_scan`이 그 *안에서* 기다리는 동안에는 수신기를 호출하는 스레드가 없고, 변환은 읽히지 않은 채 큐에 쌓입니다.
# 편지를 기다리는 사람이 바로 집배원인 셈입니다.

# %% [markdown] lang="en" name="lanes-notes" slide="notes"
# Play it: one student is the executor, a second one brings mail. The executor must answer "where is the robot?" and may not touch the mail while thinking.

# %% [markdown] lang="ko" name="lanes-notes" slide="notes"
# 연극으로 해 봅니다. 한 학생은 실행기, 다른 학생은 편지를 건네는 사람입니다. 실행기는 “로봇이 어디 있습니까?”에 답해야 하고, 생각하는 동안에는 편지에 손댈 수 없습니다.

# %% [markdown] lang="en" name="cure-async" slide="subslide"
# ### The fix: do not wait, be called
#
# `wait_for_transform_async` returns a [[future]] at once. The future is completed when the transform arrives. Your callback returns immediately, and one thread is enough.
# The future has **no timeout**: if the transform never comes, it waits for ever. So keep the futures, and cancel the old ones.
# `future.result()` returns the transform, or raises the exception. (On Humble it returns `True`. Look the transform up then.)
#
# To make it harder, every transform now takes 0.15 s longer to arrive.

# %% [markdown] lang="ko" name="cure-async" slide="subslide"
# ### 해결책: 기다리지 말고, 오면 호출하게 합니다
#
# `wait_for_transform_async`는 [[future|퓨처(future)]]를 바로 반환합니다. 퓨처는 나중에 결과를 담는 객체이고, 변환이 오면 완료됩니다. 콜백은 바로 끝나고 스레드는 하나면 됩니다.
# 퓨처에는 **시간 제한이 없습니다.** 끝내 변환이 오지 않으면 영원히 기다립니다. 그러니 퓨처를 보관하고 오래된 것은 취소하십시오.
# `future.result()`는 변환을 반환하거나 예외를 일으킵니다. (Humble에서는 `True`를 반환합니다. 그때 변환을 조회하십시오.)
#
# 더 어려운 상황을 만들려고, 이제 변환마다 0.15초씩 더 늦게 도착하게 합니다.

# %% name="called-node" slide="subslide"
waiting = []


class Called(lesson.WaitingNode):
    def on_scan(self, scan):
        stamp = Time.from_msg(scan.header.stamp)
        future = self.buffer.wait_for_transform_async('map', 'laser_frame', stamp)
        future.add_done_callback(self.on_answer)
        waiting.append(future)
        if len(waiting) > 3:  # at most three: the oldest is cancelled
            waiting.pop(0).cancel()

    def on_answer(self, future):
        if not future.cancelled():
            self.answers.append(future.result().transform.translation)

# %% name="called-run" tags=["collapsed"] slide="-"
# Run Called on robot C, and draw when it was busy.
waiting.clear()  # of an earlier run
called = lesson.on_robot_c(Called, delay_s=0.15)  # one thread
print(len(called.busy), 'scans,', len(called.answers), 'answered')
lesson.draw_lanes(called)

# %% [markdown] lang="en" name="called-read" slide="-"
# 27 of 30. The first scan can never be answered, and was cancelled when three newer ones were waiting. The last two are still waiting.
# The callback is never busy.

# %% [markdown] lang="ko" name="called-read" slide="-"
# 30개 가운데 27개입니다. 첫 스캔의 변환은 올 수 없으므로, 퓨처가 셋을 넘자 가장 오래된 그것을 취소했습니다. 마지막 둘은 아직 기다리는 중입니다.
# 콜백의 시간줄도 보십시오. 잠깐씩 실행될 뿐 한 번도 오래 걸리지 않습니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# Your robot has two computers. For an hour, every scan has failed with *extrapolation into the future*, always by 0.40 s, give or take 2 ms. `ros2 topic delay /scan` prints −0.31. What do you do? Choose one, then open its reply.
#
# <details><summary>1. <code>timeout=Duration(seconds=1)</code></summary>
#
# The warnings will go away, and each scan gets the laser's pose of 0.4 s after the measurement. You have seen that picture.
#
# </details>
#
# <details><summary>2. Look up with <code>Time()</code>, the latest, instead of the stamp</summary>
#
# `Time()` ignores the time of the measurement. While the robot stands still nobody notices. When it turns, the walls smear (chapter 08).
#
# </details>
#
# <details><summary>3. Write the time of arrival into <code>header.stamp</code></summary>
#
# Then each scan gets the pose at its arrival, and no later node can find out the time of the measurement.
#
# </details>
#
# <details><summary>4. <code>chronyc tracking</code> on both computers, and set the clock right</summary>
#
# Yes. Constant for an hour, hardly any variation, and a negative delay: a clock is wrong. Set it where it is wrong.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 로봇에 컴퓨터가 두 대 있습니다. 한 시간째 모든 스캔이 *extrapolation into the future*로 실패합니다. 차이는 언제나 0.40초이고, 2 ms 남짓만 달라집니다. `ros2 topic delay /scan`은 −0.31을 보여 줍니다. 어떻게 하겠습니까? 하나를 고른 뒤 답을 펼쳐 보세요.
#
# <details><summary>1. <code>timeout=Duration(seconds=1)</code>을 넣습니다</summary>
#
# 경고는 사라지고, 스캔마다 측정하고 0.4초 지난 다음의 레이저 포즈가 쓰입니다. 앞에서 그 그림을 보았습니다.
#
# </details>
#
# <details><summary>2. 측정 시각 대신 최신을 뜻하는 <code>Time()</code>으로 조회합니다</summary>
#
# `Time()`은 측정 시각을 버립니다. 로봇이 서 있으면 드러나지 않습니다. 회전하기 시작하면 벽이 번집니다(08장).
#
# </details>
#
# <details><summary>3. <code>header.stamp</code>에 도착한 시각을 써넣습니다</summary>
#
# 그러면 스캔마다 도착했을 때의 포즈를 쓰게 되고, 나중에 이 데이터를 쓰는 누구도 언제 측정했는지 알아낼 수 없습니다.
#
# </details>
#
# <details><summary>4. 두 컴퓨터에서 <code>chronyc tracking</code>을 실행하고 시계를 바로잡습니다</summary>
#
# 맞습니다. 한 시간째 일정하고, 지터가 거의 없고, 지연이 음수입니다. 원인은 시계입니다. 시계가 틀린 컴퓨터에서 바로잡습니다.
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Let everybody show one to four fingers at the same time. Ask a 2 and a 3 to convince each other before you open the replies.

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 모두 동시에 손가락 하나에서 넷을 펴게 합니다. 답을 열기 전에 2번과 3번을 고른 사람이 서로를 설득해 보게 합니다.

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## The same on a real robot
#
# Messages grow old while they wait. Decide four things first (lecture, section 19):
#
# - **How long do I wait?** Until two newer points wait.
# - **A point without a transform by then?** Drop it, and log the reason.
# - **How many may queue?** Two; the oldest goes first.
# - **How old may data be that moves the robot?** 0.5 s. New is better than complete.

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# 기다리는 동안에도 메시지의 나이는 늘어납니다. 로봇이 달리기 *전에* 네 가지를 정해야 합니다(강의 19절).
#
# - **얼마나 기다릴까요?** 아래 노드는 새 점이 두 개 더 올 때까지 기다립니다.
# - **그때까지 변환을 얻지 못한 점은?** 버리고 이유를 로그에 남깁니다.
# - **큐에는 몇 개까지 둘까요?** 두 개입니다. 가장 오래된 것부터 버립니다.
# - **로봇을 움직이는 데이터의 나이는 얼마까지 허용할까요?** 0.5초입니다. 빠짐없는 것보다 최근 것이 낫습니다.

# %% [markdown] lang="en" name="robot-node" slide="subslide"
# ### A node to take home
#
# Chapter 08's node, now with a future. `on_done` runs when the transform has arrived, and when the wait is cancelled. Then the lookup raises the reason.
#
# ```python
# # tf_lab_py/careful.py
# from collections import deque
#
# import rclpy
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
# from tf2_geometry_msgs import do_transform_point
# from tf2_ros import Buffer, TransformException, TransformListener
# from tf2_ros import ConnectivityException, ExtrapolationException, LookupException
#
#
# class Careful(Node):
#     def __init__(self):
#         super().__init__('careful')
#         self.waiting = deque()
#         self.tf_buffer = Buffer(cache_time=Duration(seconds=20.0), node=self)
#         self.tf_listener = TransformListener(self.tf_buffer, self)
#         self.publisher = self.create_publisher(PointStamped, 'point_in_map', 10)
#         self.create_subscription(PointStamped, 'detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         stamp = Time.from_msg(message.header.stamp)
#         future = self.tf_buffer.wait_for_transform_async('map', message.header.frame_id, stamp)
#         future.add_done_callback(lambda done: self.on_done(message, stamp))
#         self.waiting.append(future)
#         if len(self.waiting) > 2:  # two may wait: the oldest goes
#             self.waiting.popleft().cancel()
#
#     def on_done(self, message, stamp):
#         try:
#             transform = self.tf_buffer.lookup_transform('map', message.header.frame_id, stamp)
#         except LookupException as error:
#             self.get_logger().warning(f'check frame name and publisher: {error}')
#         except ConnectivityException as error:
#             self.get_logger().warning(f'check the broken tree: {error}')
#         except ExtrapolationException as error:
#             self.get_logger().warning(f'check stamp, clock and delay: {error}')
#         except TransformException as error:
#             self.get_logger().warning(f'check the arguments: {error}')
#         else:
#             if self.get_clock().now() - stamp < Duration(seconds=0.5):  # old data moves no robot
#                 point = do_transform_point(message, transform)
#                 self.publisher.publish(point)
#                 self.get_logger().info(f'in map: {point.point.x:.2f}, {point.point.y:.2f}')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = Careful()
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
# Start it on a robot with `python3 careful.py`, without ROS with `tflab run careful.py`. It waits for `/detected_point`.

# %% [markdown] lang="ko" name="robot-node" slide="subslide"
# ### 가져갈 노드
#
# 08장의 노드를 퓨처로 고쳐 썼습니다. `on_done`은 변환이 도착했을 때 호출되고, 기다림이 취소되었을 때도 호출됩니다. 취소되었을 때는 조회에서 예외가 나므로 이유를 알 수 있습니다.
#
# ```python
# # tf_lab_py/careful.py
# from collections import deque
#
# import rclpy
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
# from tf2_geometry_msgs import do_transform_point
# from tf2_ros import Buffer, TransformException, TransformListener
# from tf2_ros import ConnectivityException, ExtrapolationException, LookupException
#
#
# class Careful(Node):
#     def __init__(self):
#         super().__init__('careful')
#         self.waiting = deque()
#         self.tf_buffer = Buffer(cache_time=Duration(seconds=20.0), node=self)
#         self.tf_listener = TransformListener(self.tf_buffer, self)
#         self.publisher = self.create_publisher(PointStamped, 'point_in_map', 10)
#         self.create_subscription(PointStamped, 'detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         stamp = Time.from_msg(message.header.stamp)
#         future = self.tf_buffer.wait_for_transform_async('map', message.header.frame_id, stamp)
#         future.add_done_callback(lambda done: self.on_done(message, stamp))
#         self.waiting.append(future)
#         if len(self.waiting) > 2:  # two may wait: the oldest goes
#             self.waiting.popleft().cancel()
#
#     def on_done(self, message, stamp):
#         try:
#             transform = self.tf_buffer.lookup_transform('map', message.header.frame_id, stamp)
#         except LookupException as error:
#             self.get_logger().warning(f'check frame name and publisher: {error}')
#         except ConnectivityException as error:
#             self.get_logger().warning(f'check the broken tree: {error}')
#         except ExtrapolationException as error:
#             self.get_logger().warning(f'check stamp, clock and delay: {error}')
#         except TransformException as error:
#             self.get_logger().warning(f'check the arguments: {error}')
#         else:
#             if self.get_clock().now() - stamp < Duration(seconds=0.5):  # old data moves no robot
#                 point = do_transform_point(message, transform)
#                 self.publisher.publish(point)
#                 self.get_logger().info(f'in map: {point.point.x:.2f}, {point.point.y:.2f}')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = Careful()
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
# 로봇에서는 `python3 careful.py`, ROS가 없는 컴퓨터에서는 `tflab run careful.py`로 시작합니다. `/detected_point`가 올 때까지 기다립니다.

# %% [markdown] lang="en" name="robot-commands" slide="subslide"
# ### In the terminal
#
# Type these in this order:
#
# ```bash
# ros2 topic delay /scan                        # negative? two clocks
# ros2 topic delay /odom                        # the transforms' side
# ros2 param get /careful use_sim_time          # another time than the rest?
# ros2 run tf2_ros tf2_monitor map laser_frame  # which edge is late
# chronyc tracking                              # on each computer
# ```

# %% [markdown] lang="ko" name="robot-commands" slide="subslide"
# ### 터미널에서
#
# 문제가 생기면 이 순서로 입력합니다.
#
# ```bash
# ros2 topic delay /scan                       # 음수? 시계가 둘
# ros2 topic delay /odom                       # 같은 시계를 쓰는 변환 쪽
# ros2 param get /careful use_sim_time         # 다른 시간을 쓰는 노드?
# ros2 run tf2_ros tf2_monitor map laser_frame # 어느 연결이 얼마나 늦는지
# chronyc tracking                             # 컴퓨터마다
# ```

# %% [markdown] lang="en" name="recap" slide="slide"
# ## Recap
#
# - **Name, path, time.** No name: LookupException. No path: ConnectivityException. No data for the time: ExtrapolationException.
# - The text does not name the edge that limits the lookup. Find that edge by the time in the text.
# - Past: waiting is useless. Future: wait a little if the transform is *late*; set the clock if it is *wrong*. A negative delay means that a clock is wrong.
# - A timeout checks whether the transform is there, never whether the stamp is true.
# - Never wait in the only thread. Use a future.
# - How long, how many, how old: decide before you drive.
#
# Terms of this chapter: [[lookup exception|LookupException]], [[connectivity exception|ConnectivityException]], [[extrapolation exception|ExtrapolationException]], [[invalid argument exception|InvalidArgumentException]], [[transform exception|TransformException]], [[clock offset]], [[jitter]], [[message filter]].

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - **이름, 경로, 시각.** 이름이 없으면 조회 예외, 경로가 없으면 연결 예외, 그 시각의 값이 없으면 외삽 예외입니다.
# - 오류 메시지에 막힌 연결은 나오지 않습니다. 메시지에 나온 시각으로 그 연결을 찾습니다.
# - 과거라면 기다려도 소용없습니다. 미래 외삽에서 변환이 지연된 것이면 조금 기다리고, 시계가 틀렸으면 맞춥니다. 지연이 음수이면 원인은 시계입니다.
# - timeout은 변환이 왔는지 확인할 뿐, 시각이 맞는지는 확인하지 않습니다.
# - 하나뿐인 스레드에서는 절대 기다리지 마십시오. 퓨처를 쓰십시오.
# - 얼마나 오래, 몇 개까지, 얼마나 오래된 것까지. 달리기 전에 정하십시오.
#
# 이 장의 용어: [[lookup exception|LookupException]], [[connectivity exception|ConnectivityException]], [[extrapolation exception|ExtrapolationException]], [[invalid argument exception|InvalidArgumentException]], [[transform exception|TransformException]], [[clock offset|시계 차이]], [[jitter|지터]], [[message filter|메시지 필터]].

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# Without looking: your log contains *extrapolation into the future*. Name the **two** causes that it can have, and the **one** command that tells them apart.
# Write one sentence for the colleague who wants to raise the timeout.
#
# <details><summary>One good ending</summary>
#
# The transform is late, or a clock is wrong. If `ros2 topic delay` is below zero for `/scan`, a clock is wrong. If it is large and varies for `/odom`, transforms are late.
# "A long wait only hides a wrong clock. Let us look at the delay first."
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# 보지 않고 답해 보세요. 로그에 *extrapolation into the future*가 나왔습니다. 이것이 뜻할 수 있는 **두** 가지와, 둘을 구별하는 **한** 가지 명령을 말해 보세요.
# timeout을 늘리자는 동료에게 건넬 한 문장을 적어 보세요.
#
# <details><summary>좋은 답의 한 예</summary>
#
# 변환이 늦거나, 시계가 틀렸습니다. `ros2 topic delay`로 `/scan`과 `/odom`을 봅니다. 변환이 늦으면 `/odom`의 지연이 정상보다 크고 들쭉날쭉합니다. `/scan`의 지연이 0보다 작으면 원인은 시계입니다.
# “늦은 것이라면 조금만 기다려도 되고, 시계라면 오래 기다려도 원인이 가려질 뿐이니, 먼저 지연부터 봅시다.”
#
# </details>

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now read what tf2 reports, tell late data from a wrong clock, and wait without blocking your node.
#
# **Now the exercises:** [E9, seven tasks](../../exercises/en/E09_exceptions_and_waiting.ipynb). Some need a section below: E9.1 and E9.2 "Four more exceptions to cause", E9.4 "What one-way times cannot tell you", E9.6 "Where else may I wait?", E9.7 "How long is 'a little'?". In E9.3, subtract the `.nanoseconds` of two times: rclpy cannot subtract Times of different clock types.
# **The next chapter** is [10 Clocks and bags](10_clocks_and_bags.ipynb): which clock must a node use while a recording is played?
#
# On your checklist this chapter is **C10**: lookup, connectivity and extrapolation error. Cause all three once on the robot, too.
#
# The other sections are optional: a slider, queues, stamps dated ahead, and questions.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 tf2의 오류를 읽고, 늦은 데이터와 틀린 시계를 구별하고, 노드를 막지 않고 기다릴 수 있습니다.
#
# **이제 연습 문제입니다.** [E9, 과제 일곱 개](../../exercises/ko/E09_exceptions_and_waiting.ipynb)를 풀어 보세요. 아래의 절이 필요한 과제도 있습니다. E9.1과 E9.2는 ‘더 만들어 볼 예외 네 가지’, E9.4는 ‘한 방향의 시각만으로는 알 수 없는 것’, E9.6은 ‘그 밖에 어디서 기다려도 될까요?’, E9.7은 ‘“조금”은 얼마일까요?’를 펼쳐 보세요. E9.3에서는 두 시각의 `.nanoseconds`를 뺍니다. rclpy는 종류가 다른 시계의 시각을 서로 빼지 못합니다.
# **다음 장**은 [10 시계와 bag](10_clocks_and_bags.ipynb)입니다. 기록을 재생할 때 노드는 어느 시계를 따라야 할까요?
#
# 실습 체크리스트에서 이 장은 **C10**입니다. 조회·연결·외삽 오류를 모두 직접 만들어 보았습니다. 여기서는 시뮬레이션이었으니, 실제 로봇에서도 한 번 해 보세요.
#
# 나머지는 더 알고 싶은 사람을 위한 절입니다. 슬라이더, 큐, 미래의 시각을 적는 발행자, 복습 문제가 있습니다. 제목을 누르면 펼쳐집니다.

# %% [markdown] lang="en" name="slider-heading" slide="slide"
# ## Drag the lookup out of the buffer

# %% [markdown] lang="ko" name="slider-heading" slide="slide"
# ## 요청 시각을 버퍼 밖으로 끌어 봅시다

# %% [markdown] lang="en" name="slider" slide="-"
# Move the requested time past either end, slowly. Watch three things: where the lookup begins to fail, which number in the text stays the same, and what LATEST means. The boundary is sharp: at 14.000000000 s there is an answer, a nanosecond later there is none.

# %% [markdown] lang="ko" name="slider" slide="-"
# 요청 시각을 양쪽 끝 너머로 천천히 끌어 보세요. 어디서부터 실패하는지, 오류 메시지에서 변하지 않는 숫자는 무엇인지, LATEST는 무엇을 뜻하는지 살펴보세요. 경계는 정확합니다. 14.000000000초의 값은 나오지만 1나노초만 미래여도 나오지 않습니다.

# %% name="slider-panel" tags=["interactive", "collapsed"] slide="-"
# Show the panel.
lanes = lesson.draw_history(buffer, 'map', 'laser_frame').timeline.lanes
lesson.timeline_panel('map', 'laser_frame', lanes, buffer.core.lookup_transform)

# %% name="slider-still" tags=["static"]
lesson.draw_history(four_edges(), 'map', 'laser_frame', seconds(14.3))

# %% [markdown] lang="en" name="more-exceptions" slide="slide"
# ## Four more exceptions to cause

# %% [markdown] lang="ko" name="more-exceptions" slide="slide"
# ## 더 만들어 볼 예외 네 가지

# %% [markdown] lang="en" name="header-why" slide="subslide"
# ### A name that you never typed

# %% [markdown] lang="ko" name="header-why" slide="subslide"
# ### 직접 입력한 적 없는 이름

# %% name="break-header" tags=["raises-exception"] slide="-"
import tf2_geometry_msgs
from geometry_msgs.msg import PointStamped

corner = PointStamped()
corner.header.frame_id = 'Laser_frame'  # some driver wrote this, far away
corner.header.stamp = Time(seconds=12.3).to_msg()
buffer.transform(corner, 'map')

# %% [markdown] lang="en" name="header-read" slide="-"
# You typed only `map`. The other name came with the message: `transform()` takes source and stamp from its header.
# **An exception may name a frame that you never typed, because another source supplied it**: a header, RViz's Fixed Frame, a costmap's parameter.
# Names are compared letter by letter, so there is no `Laser_frame`.

# %% [markdown] lang="ko" name="header-read" slide="-"
# 여러분이 입력한 것은 `map`뿐입니다. 다른 이름은 메시지에 들어 있었습니다. `transform()`은 원본과 시각을 헤더에서 가져옵니다.
# **직접 입력하지 않은 이름이 예외에 나온다면, 다른 곳에서 온 것입니다.** 메시지 헤더, RViz의 고정 좌표계(Fixed Frame), 코스트맵 파라미터가 그렇습니다.
# 이름은 글자 단위로 비교하므로 `Laser_frame`이라는 좌표계는 없습니다.

# %% [markdown] lang="en" name="one-sample" slide="subslide"
# ### One sample is not enough
#
# An [[extrapolation exception|ExtrapolationException]] has three texts. You know "future" and "past". Here is the third: an edge with exactly one sample.
# It happens after a restart, for a joint that was published once, or for a static edge that was published on `/tf` by mistake.

# %% [markdown] lang="ko" name="one-sample" slide="subslide"
# ### 표본 하나로는 부족합니다
#
# [[extrapolation exception|ExtrapolationException(시간 외삽 예외)]]의 오류 메시지는 세 가지입니다. “future”와 “past”는 이미 보았습니다. 세 번째는 표본이 하나뿐인 연결에서 나옵니다.
# 재시작 직후이거나, 관절 값을 한 번만 발행했거나, 정적 연결을 실수로 `/tf`에 보냈을 때 나옵니다.

# %% name="break-one-sample" tags=["raises-exception"] slide="-"
arm = TransformStamped()
arm.header.frame_id, arm.child_frame_id = 'base_link', 'tool0'
arm.header.stamp = Time(seconds=12.0).to_msg()
arm.transform.translation.x, arm.transform.rotation.w = 0.3, 1.0
buffer.set_transform(arm, 'arm')
buffer.lookup_transform('base_link', 'tool0', Time(seconds=12.3))

# %% [markdown] lang="en" name="statics" slide="-"
# One sample is enough for `Time()`, and for a lookup at exactly its stamp. So `tf2_echo`, which uses `Time()`, prints it, while the lookup of your node fails.
#
# And `base_link → laser_frame`, whose stamp is 0? It is valid at all times. **An old stamp on a static edge is not a fault**, although people have searched for days because of one.

# %% [markdown] lang="ko" name="statics" slide="-"
# `Time()`이나 그 표본의 시각으로 조회하면 표본 하나로도 값이 나옵니다. 그래서 `Time()`으로 조회하는 `tf2_echo`에서는 문제가 없고, 여러분의 노드에서는 실패합니다.
#
# 그렇다면 시각이 0인 `base_link → laser_frame`은 어떨까요? 어느 시각에나 값이 나옵니다. **정적 연결의 오래된 시각은 결함이 아닙니다.** 며칠씩 이 시각 때문에 헤맨 사람도 있습니다.

# %% [markdown] lang="en" name="argument-why" slide="subslide"
# ### An invalid argument

# %% [markdown] lang="ko" name="argument-why" slide="subslide"
# ### 올바르지 않은 인자

# %% name="break-argument" tags=["raises-exception"] slide="-"
buffer.lookup_transform('/map', 'laser_frame', Time())

# %% [markdown] lang="en" name="argument-read" slide="-"
# ROS 1 wrote `/map`. ROS 2 writes `map`. An empty `header.frame_id` raises this exception as well.
# It does not depend on the robot's state: it fails today, tomorrow and with any timeout. Fix the line.

# %% [markdown] lang="ko" name="argument-read" slide="-"
# ROS 1에서는 `/map`, ROS 2에서는 `map`이라고 씁니다. 비어 있는 `header.frame_id`도 여기서 걸립니다.
# 이 예외는 로봇의 상태와 상관이 없습니다. timeout을 얼마로 해도 실패합니다. 코드를 고치십시오.

# %% [markdown] lang="en" name="order" slide="subslide"
# ### Predict: two faults at once
#
# `camera_link` is in a tree of its own (the typo is still there). Now look up `camera_link ← odom` at 99 s, long after the newest sample.
# There is no path *and* no data. Which exception do you expect?

# %% [markdown] lang="ko" name="order" slide="subslide"
# ### 예측해 봅시다: 두 결함이 한꺼번에
#
# `camera_link`는 여전히 별도의 트리에 있습니다(오타가 그대로 있습니다). 이제 최신 표본보다 한참 미래인 99초의 변환 `camera_link ← odom`을 조회합니다.
# 경로도 없고 데이터도 없습니다. 어떤 예외가 나올까요?

# %% name="two-faults" tags=["predicted"] slide="fragment"
for when in (Time(seconds=99), Time()):
    try:
        buffer.lookup_transform('camera_link', 'odom', when)
    except TransformException as error:
        print(f'{when.nanoseconds / 1e9:.0f} s: {type(error).__name__}\n      {error}')

# %% [markdown] lang="en" name="order-read" tags=["predicted"] slide="fragment"
# The table was a little too simple. tf2 checks the names first, but it checks path and time **while it walks the tree**.
# It climbs from the source, finds no data for 99 s on `map → odom`, and remembers that. Only then does it find that the path up from the target ends at another root.
# It reports the time, which it found first.
#
# So when an extrapolation exception puzzles you, look up once more with `Time()`, the latest. If *that* says "not part of the same tree", the time was not the cause.

# %% [markdown] lang="ko" name="order-read" tags=["predicted"] slide="fragment"
# 앞의 표는 실제보다 단순합니다. tf2는 이름을 먼저 확인하지만, 경로와 시각은 **트리를 따라가면서** 확인합니다.
# 원본 쪽에서 올라가다 99초의 값이 없는 `map → odom`을 만나 그 사실을 기록해 둡니다. 반대쪽이 다른 루트에서 끝난다는 것은 그다음에야 알게 됩니다.
# 그래서 먼저 찾은 시각 문제를 보고합니다.
#
# 외삽 예외가 이해되지 않으면 최신을 뜻하는 `Time()`으로 한 번 더 조회해 보십시오. *그때* "not part of the same tree"가 나오면 찾아야 할 결함은 시각이 아니라 경로입니다.

# %% [markdown] lang="en" name="order-notes" slide="notes"
# This is the one difficult point about exceptions. If time is short, say only the last sentence: look up once more with Time().

# %% [markdown] lang="ko" name="order-notes" slide="notes"
# 예외에 관해 유일하게 까다로운 대목입니다. 시간이 없으면 마지막 문장만 말합니다. Time()으로 한 번 더 조회합니다.

# %% [markdown] lang="en" name="one-way" slide="subslide"
# ## What one-way times cannot tell you

# %% [markdown] lang="ko" name="one-way" slide="subslide"
# ## 한 방향의 시각만으로는 알 수 없는 것

# %% [markdown] lang="en" name="honest-limit" slide="-"
# A constant delay of +0.3 s may be a slow network, or a publisher whose clock is 0.3 s *behind*.
# From one-way times alone, **nobody** can separate the two: both add the same number to every message.
# You need a message that goes there *and back*. `chrony` and NTP use such messages, so use them to compare the clocks of two computers. For example:
#
# ```text
# $ chronyc tracking
# ...
# System time     : 0.300184021 seconds fast of NTP time      <- this line
# ```
#
# And there is a case without an error. A sensor clock that is *behind* leads to lookups in the past. The buffer answers, as far back as its cache time: no exception, no warning, and a robot that is wrong all day.

# %% [markdown] lang="ko" name="honest-limit" slide="-"
# 지터 없이 늘 +0.3초인 지연은 느린 네트워크일 수도 있고, 시계가 0.3초 *뒤처진* 발행자일 수도 있습니다.
# 한 방향의 시각만으로는 **누구도** 둘을 구별할 수 없습니다. 둘 다 모든 메시지에 같은 숫자를 더하기 때문입니다.
# 갔다가 *되돌아오는* 메시지가 있어야 합니다. `chrony`와 NTP가 그렇게 시계를 비교하니, 컴퓨터가 두 대라면 이들로 확인하십시오. 예를 들면 이렇습니다.
#
# ```text
# $ chronyc tracking
# ...
# System time     : 0.300184021 seconds fast of NTP time      <- 이 줄입니다
# ```
#
# 오류가 나지 않는 경우도 조심하십시오. 시계가 *뒤처진* 센서의 데이터에는 과거의 변환이 쓰입니다. 보관 시간 안이면 언제나 값이 나옵니다. 예외도 경고도 없이 위치가 계속 틀립니다.

# %% [markdown] lang="en" name="plaster-3d-heading" slide="subslide"
# ## The wrong clock in 3D, and a larger error

# %% [markdown] lang="ko" name="plaster-3d-heading" slide="subslide"
# ## 틀린 시계를 3D로, 그리고 더 큰 차이

# %% [markdown] lang="en" name="plaster-3d" slide="-"
# One scan, taken in the middle of the curve. Drag the slider: it is the error of the laser's clock. The grey lines are the real walls.

# %% [markdown] lang="ko" name="plaster-3d" slide="-"
# 굽이 한가운데서 얻은 스캔 하나입니다. 슬라이더를 끌어 보세요. 슬라이더의 값(clock error)은 레이저의 시계 차이입니다. 회색 선이 실제 벽입니다. *그림 읽기:* off by … on average / at worst = 벽에서 평균 / 최대로 벗어난 거리.

# %% name="walls-walk" tags=["interactive", "collapsed"] slide="subslide"
# Show the scene.
lesson.show_clock_error()

# %% name="walls-walk-still" tags=["static"]
one_scan = [sight for sight in placer.answers if sight[1].nanoseconds >= seconds(9.0)][:1]
lesson.draw_placed({
    f'clock error {0.3 - right:.1f} s': lesson.walls_seen(placer.buffer, one_scan, right) for right in (0.3, 0.1, 0.0)
}, lesson.ROOM.walls)

# %% [markdown] lang="en" name="plaster-off-why" slide="-"
# And if the clock is 2 s ahead, and the timeout is still one second?

# %% [markdown] lang="ko" name="plaster-off-why" slide="-"
# 시계가 2초 앞서 있고 timeout은 그대로 1초라면 어떨까요?

# %% name="plaster-off" tags=["collapsed"] slide="-"
# Run ScanPlacer with the clock 2 s ahead.
graph = lesson.new_graph()
graph.set_clock_offset('laser_driver', 2.0)
lesson.launch(graph)
hopeless = lesson.run_node(ScanPlacer, 9.0, MultiThreadedExecutor)
print(len(hopeless.answers), 'placed,', hopeless.failures, 'failed')

# %% [markdown] lang="en" name="plaster-off-read" slide="-"
# However long the robot runs, every wait expires after its full second. No message takes that long *every* time. (The node processed 8 of the 86 scans, one a second. The queue of its subscription is short, and dropped the others.)

# %% [markdown] lang="ko" name="plaster-off-read" slide="-"
# 1초를 꽉 채워 기다리다 매번 시간이 다 되고, 로봇이 달리는 내내 그렇습니다. 오는 중인 데이터라면 *매번* 그렇게 오래 걸리지는 않습니다. (스캔 86개 중에서 노드가 처리한 것은 1초에 하나씩 8개뿐입니다. 구독의 큐는 짧아서 나머지를 버렸습니다.)

# %% [markdown] lang="en" name="cure-threads-heading" slide="subslide"
# ## Where else may I wait?

# %% [markdown] lang="ko" name="cure-threads-heading" slide="subslide"
# ## 그 밖에 어디서 기다려도 될까요?

# %% [markdown] lang="en" name="cure-threads" slide="-"
# The listener's subscriptions are in a *reentrant* callback group of their own. So an executor with several threads may call them while your callback waits. The node `Patient` stays as it is. You change one word: `rclpy.spin(node, executor=MultiThreadedExecutor())`.

# %% [markdown] lang="ko" name="cure-threads" slide="-"
# 수신기의 구독은 따로 마련된 *재진입(reentrant)* 콜백 그룹에 있습니다. 그래서 스레드가 여럿인 실행기는 여러분의 콜백이 기다리는 동안에도 수신기를 호출할 수 있습니다. 노드 `Patient`는 그대로 두고 `rclpy.spin(node, executor=MultiThreadedExecutor())`처럼 실행기만 바꾸면 됩니다.

# %% name="cure-threads-run" tags=["collapsed"] slide="-"
# Run Patient with several threads.
patient = lesson.on_robot_c(Patient, MultiThreadedExecutor, delay_s=0.15)
print(len(patient.answers), 'scans,', patient.answers.count('ok'), 'answered')
lesson.draw_lanes(patient)

# %% [markdown] lang="en" name="cure-threads-read" slide="-"
# 27 of 28. (Of the 30 scans in these three seconds, one still waits for its transform, and the last one waits until the callback is free.) Only the first scan is lost, the one that is older than every transform. One thread waits, another receives the transforms: `/tf stored` keeps up with `/tf sent`.

# %% [markdown] lang="ko" name="cure-threads-read" slide="-"
# 28개 가운데 27개입니다. (3초 동안의 스캔 30개 가운데 하나는 아직 변환을 기다리고 있고, 마지막 하나는 콜백이 끝나기를 기다리고 있습니다.) 잃은 것은 모든 변환보다 오래된 첫 스캔뿐입니다. 한 스레드가 기다리는 동안 다른 스레드가 변환을 받으므로, `/tf stored`가 `/tf sent`를 따라갑니다.

# %% [markdown] lang="en" name="cures-compared" slide="subslide"
# | where you wait | when it is right |
# | --- | --- |
# | nowhere: look up, and drop on failure | fast sensors: the next scan comes in 0.1 s anyway |
# | in the callback, *with* a `MultiThreadedExecutor` | a few messages a second, a short timeout |
# | in `main()`, with `TransformListener(buffer, node, spin_thread=True)` | you spin nothing else: its thread runs the callbacks of the *whole* node |
# | a future (`wait_for_transform_async`) | many messages, one thread; keep the number of futures bounded |
# | in a plain callback with one thread | **never** |
#
# Two more ways:
#
# - `await buffer.lookup_transform_async(...)` does the same in an `async` callback of a [[reentrant]] group. In any other group a future that is never completed would block the group for good.
# - A [[message filter]] (`tf2_ros::MessageFilter`, C++) already does the same: your callback runs only when the transform is there, and its queue has a size.
#
# In C++ the listener has a thread of its own by default, so a wait in a callback works. Without that thread (`spin_thread=false`) tf2 rejects the wait at once, with a long message that requires a dedicated thread (`setUsingDedicatedThread`). In Python the default is no thread, and tf2 lets you wait. A public report of this is ros2/geometry2, issue 327.

# %% [markdown] lang="ko" name="cures-compared" slide="subslide"
# | 기다리는 곳 | 알맞은 경우 |
# | --- | --- |
# | 기다리지 않음: 조회하고, 실패하면 버립니다 | 빠른 센서. 어차피 0.1초 뒤에 다음 스캔이 옵니다 |
# | 콜백 안. 단, `MultiThreadedExecutor`로 실행할 때만 | 1초에 몇 개뿐인 메시지, 짧은 timeout |
# | `main()` 안. `TransformListener(buffer, node, spin_thread=True)`를 쓸 때 | 따로 spin하지 않을 때. 그 스레드가 노드 *전체*의 콜백을 실행합니다 |
# | 퓨처(`wait_for_transform_async`) | 메시지가 많고 스레드가 하나일 때. 퓨처의 수를 제한하십시오 |
# | 스레드 하나인 평범한 콜백 안 | **절대 안 됩니다** |
#
# 두 가지 방법이 더 있습니다.
#
# - `await buffer.lookup_transform_async(...)`는 같은 일을 [[reentrant|재진입(reentrant)]] 그룹의 `async` 콜백에서 합니다. 다른 그룹이라면 완료되지 않는 퓨처 하나가 그룹 전체를 영영 막습니다.
# - [[message filter|메시지 필터(message filter)]](`tf2_ros::MessageFilter`, C++)는 같은 일을 해 주는 완제품입니다. 변환이 있을 때만 콜백이 실행되고, 큐의 크기가 정해져 있습니다.
#
# C++에서는 수신기(listener)가 기본으로 전용 스레드를 가지므로 콜백 안의 기다림이 통합니다. 그 스레드가 없으면(`spin_thread=false`) C++의 tf2는 전용 스레드를 두라는 긴 문장(`setUsingDedicatedThread`)과 함께 곧바로 거절합니다. 파이썬에서는 기본으로 그 스레드가 없고, 그대로 기다립니다. 이 문제는 [ros2/geometry2, 이슈 327](https://github.com/ros2/geometry2/issues/327)에 올라와 있습니다.

# %% [markdown] lang="en" name="policy-heading" slide="slide"
# ## What happens with a queue that has no limit

# %% [markdown] lang="ko" name="policy-heading" slide="slide"
# ## 큐에 한계가 없으면 생기는 일

# %% [markdown] lang="en" name="policy" slide="-"
# Scans come every 100 ms. Processing takes 150 ms each. The queue is unbounded, and there is no limit of age.
#
# **Predict.** After 12 seconds: how old is the data that the robot is using?

# %% [markdown] lang="ko" name="policy" slide="-"
# 스캔은 100 ms마다 옵니다. 결정 한 번에 150 ms가 걸립니다. 큐의 크기에는 한계가 없고, 오래된 것도 버리지 않습니다.
#
# **예측해 봅시다.** 12초 뒤에 로봇은 얼마나 오래된 데이터로 결정하고 있을까요?

# %% name="queues" tags=["predicted"] slide="subslide"
from collections import deque

endless = lesson.ages_of_decisions('no limit', deque())
bounded = lesson.ages_of_decisions('two at most', deque(maxlen=2))  # a full deque drops its oldest
lesson.draw_ages([endless, bounded], 'age of the data', limit_s=0.5)

# %% [markdown] lang="en" name="queues-read" tags=["predicted"] slide="subslide"
# Four seconds. At half a metre per second, the robot brakes for what it detected two metres ago, and nothing in the log is red.
# It *lost no message at all*. That is the problem.
#
# With room for two, a third of the scans is dropped, and no decision uses data older than 0.3 s.

# %% [markdown] lang="ko" name="queues-read" tags=["predicted"] slide="subslide"
# *그림 읽기:* age of the data = 데이터의 나이, no limit = 한계 없음, two at most = 최대 두 개.
#
# 4초입니다. 0.5 m/s라면 로봇은 2미터를 더 달린 다음에야, 그 전에 본 것을 기준으로 제동합니다. 그런데도 로그에 오류는 하나도 없습니다.
# 메시지를 *하나도 잃지 않았습니다*. 바로 그것이 문제입니다.
#
# 두 개만 두면 스캔의 3분의 1을 버리는 대신, 0.3초보다 오래된 데이터로 내리는 결정은 하나도 없습니다.

# %% [markdown] lang="en" name="policy-notes" slide="notes"
# Let them say a number before you run it; most say 0.15 s or 0.3 s.
# Then ask what the curve looks like after an hour.

# %% [markdown] lang="ko" name="policy-notes" slide="notes"
# 실행하기 전에 숫자를 말하게 합니다. 대부분 0.15초나 0.3초라고 합니다.
# 그러고 나서 한 시간 뒤에는 곡선이 어떻게 될지 물어봅니다.

# %% [markdown] lang="en" name="how-long-heading" slide="subslide"
# ## How long is "a little"?

# %% [markdown] lang="ko" name="how-long-heading" slide="subslide"
# ## “조금”은 얼마일까요?

# %% [markdown] lang="en" name="how-long" slide="-"
# A scan waits for the first transform that is stamped *at or after* it.
#
# - In the worst case that transform is stamped one whole **period** later (10 Hz: 0.1 s),
# - and it takes its **delay**, and at worst its whole **[[jitter]]**, to arrive.
# - The scan itself took some time to arrive: that time has already passed.
#
# `wait = period + delay + jitter − the scan's own delay`, for the worst edge on the path. For robot C, with its transport delay of 0.15 s: 0.1 + (0.010 + 0.15) + 0 − 0.105 = 0.155 s. The edge's own delay is 0.010 s, and the scan's delay is 0.105 s.
# If only a longer wait helps, check the clocks.

# %% [markdown] lang="ko" name="how-long" slide="-"
# 스캔은 자기 측정 시각 *이후*의 첫 변환을 기다립니다.
#
# - 그 변환의 측정 시각은 스캔보다 최대 한 **주기** 나중입니다(10 Hz면 0.1초).
# - 그것이 도착하는 데 **지연**만큼, 최악의 경우 **[[jitter|지터(jitter)]]** 전부만큼 더 걸립니다.
# - 스캔도 오는 데 시간이 걸렸습니다. 그 시간은 이미 지나갔습니다.
#
# 경로에서 이 시간이 가장 긴 연결로 계산합니다. `기다림 = 주기 + 지연 + 지터 − 스캔 자신의 지연`입니다. 변환이 오는 데 0.15초가 더 걸린 로봇 C라면 0.1 + (0.010 + 0.15) + 0 − 0.105 = 0.155초입니다. 그 연결 자체의 지연이 0.010초이고, 스캔의 지연이 0.105초입니다.
# 이보다 오래 기다려야 통한다면 시계를 확인하십시오.

# %% [markdown] lang="en" name="ahead" slide="subslide"
# ## A publisher that dates its transforms ahead on purpose

# %% [markdown] lang="ko" name="ahead" slide="subslide"
# ## 일부러 미래의 시각을 적는 발행자

# %% [markdown] lang="en" name="dated-ahead" slide="-"
# A localiser needs time: it has the pose for a scan only when the scan is processed. Must every lookup wait for it?
# AMCL writes another stamp into `map → odom`: the scan's time plus its parameter `transform_tolerance` (1.0 s by default in Nav2). It states that the correction is valid for that long.
#
# Here is the buffer from the beginning of this page, with a localiser that dates its transforms 1.0 s ahead.
#
# **Predict.** At 14.3 s there was an exception, because of `map → odom`. What happens now?

# %% [markdown] lang="ko" name="dated-ahead" slide="-"
# 위치 추정 노드에는 시간이 필요합니다. 스캔을 다 처리해야 그 스캔의 포즈가 나옵니다. 조회할 때마다 그것을 기다려야 할까요?
# AMCL은 `map → odom`에 다른 시각을 적습니다. 스캔의 측정 시각에 파라미터 `transform_tolerance`(Nav2에서는 기본 1.0초)를 더한 시각입니다. 이 보정값이 그때까지 유효하다는 뜻입니다.
#
# 이 장 처음의 버퍼에서 위치 추정 노드가 1.0초 미래의 시각을 적으면 다음과 같습니다.
#
# **예측해 봅시다.** 14.3초의 조회는 `map → odom` 때문에 실패했습니다. 이번에는 어떻게 될까요?

# %% name="dated-ahead-picture" tags=["predicted", "collapsed"] slide="subslide"
# Draw the timelines, with a lookup at 14.3 s.
lesson.draw_history(four_edges(ahead_s=1.0), 'map', 'laser_frame', seconds(14.3))

# %% [markdown] lang="en" name="dated-ahead-read" tags=["predicted"] slide="-"
# There is an answer, and nobody had to wait. The localiser's timeline now ends at 15.0 s, so the odometry's newest sample, from 14.6 s, limits the lookup.
#
# The price: the value for 14.3 s comes from the samples stamped 14.0 and 14.5 s, which the localiser calculated from scans of 13.0 and 13.5 s. The correction is about a second old.
# That is acceptable because `map → odom` changes slowly (chapter 05). `odom → base_footprint` contains the motion of the robot, and must have true stamps.
#
# `tf2_monitor` prints a negative delay for such an edge. Here it is intended: no clock is wrong.
# (Nav2's costmaps have a parameter of the same name, with another meaning: how late a transform may be.)

# %% [markdown] lang="ko" name="dated-ahead-read" tags=["predicted"] slide="-"
# 값이 나옵니다. 기다릴 필요도 없습니다. 위치 추정 노드의 시간줄이 15.0초까지 있으므로, 이제 조회의 한계는 오도메트리의 최신 표본인 14.6초입니다.
#
# 대가도 있습니다. 14.3초의 값은 14.0초와 14.5초라고 적힌 두 표본에서 나오는데, 위치 추정 노드는 이 표본들을 13.0초와 13.5초의 스캔으로 계산했습니다. 보정값이 1초쯤 오래된 것입니다.
# `map → odom`은 천천히 변하므로(05장) 괜찮습니다. 로봇의 움직임이 담긴 `odom → base_footprint`에는 반드시 실제 측정 시각을 적어야 합니다.
#
# 이런 연결에서는 `tf2_monitor`의 지연이 음수로 나옵니다. 의도한 것이므로 시계 문제가 아닙니다.
# (Nav2의 코스트맵에도 이름이 같은 파라미터가 있지만 뜻이 다릅니다. 변환이 얼마나 늦어도 되는지를 정합니다.)

# %% [markdown] lang="en" name="text-more" slide="subslide"
# ## More about the text of an exception

# %% [markdown] lang="ko" name="text-more" slide="subslide"
# ## 예외의 오류 메시지에 대해 더

# %% [markdown] lang="en" name="numbers" slide="-"
# In tflab an extrapolation exception has the numbers as attributes, and the edge that limits the lookup: `error.requested_ns`, `error.bound_ns`, `error.direction`, `error.parent` and `error.frame`.
# On a robot you get only the text. Take the numbers from there, and the edge from `view_frames` or `tf2_monitor`.
#
# If several edges end too early, the text reports only one. In a lookup with the root as its target, such as `map`, it is the first one on the way up from the source. There may be a slower one after it.
# In a lookup below the root, such as `odom ← base_footprint`, tf2 may even climb past the target and report the time of `map → odom`, which is not on the path at all. The releases of March 2026 fix that (ros2/geometry2 #832). tflab behaves as the releases before.
#
# There is one more exception, TimeoutException: a buffer in *another* process did not answer. It does not occur on this page.

# %% [markdown] lang="ko" name="numbers" slide="-"
# tflab의 외삽 예외에는 오류 메시지 외에 숫자와, 경로가 막힌 연결이 함께 들어 있습니다. `error.requested_ns`, `error.bound_ns`, `error.direction`, `error.parent`, `error.frame`입니다.
# 실제 로봇에서는 오류 메시지만 나오므로 숫자는 메시지에서, 연결은 `view_frames`나 `tf2_monitor`에서 찾습니다.
#
# 여러 연결이 일찍 끝났어도 오류 메시지에는 하나만 나옵니다. 목표가 `map` 같은 루트라면, 원본에서 올라가며 처음 막힌 연결이 나옵니다. 그 위에 더 일찍 끝난 연결이 있을 수 있습니다.
# `odom ← base_footprint`처럼 목표가 루트 아래에 있으면 tf2가 목표를 지나쳐 더 올라가, 경로에 있지도 않은 `map → odom`의 시각이 나오기도 합니다. 2026년 3월 릴리스에서 고쳐졌고([ros2/geometry2, 이슈 832](https://github.com/ros2/geometry2/issues/832)), tflab은 그 이전과 같습니다.
#
# 예외가 하나 더 있습니다. TimeoutException은 *다른* 프로세스에 있는 버퍼가 제때 결과를 보내지 않을 때 나옵니다. 이 장에서는 다루지 않습니다.

# %% [markdown] lang="en" name="earlier" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="earlier" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-earlier" slide="-"
# <details><summary>From 03. The text says <em>from frame [laser_frame] to frame [map]</em>. Write the call that was made.</summary>
#
# `lookup_transform('map', 'laser_frame', stamp)`: data expressed in `laser_frame`, wanted in `map`. The frame in which you want it comes first.
#
# </details>
#
# <details><summary>From 08. Which time does a lookup with <code>Time()</code> use? Why is that 14.0 s in this page's buffer, although the odometry had data until 14.6 s?</summary>
#
# The latest *common* time: the earliest of the newest samples of all dynamic edges on the path. Static edges do not count.
#
# </details>
#
# <details><summary>From 02. A node publishes a transform whose quaternion is (0, 0, 0, 0). Which exception will <em>you</em> get, and where?</summary>
#
# A LookupException, at your own lookup, far away from the cause. The listener rejects the transform and logs it, so the frame stays unknown.
#
# </details>

# %% [markdown] lang="ko" name="from-earlier" slide="-"
# <details><summary>03장에서. 오류 메시지에 "from frame [laser_frame] to frame [map]"이라고 나왔습니다. 어떤 호출이었는지 적으십시오.</summary>
#
# `lookup_transform('map', 'laser_frame', stamp)`입니다. `laser_frame` 기준 데이터를 `map` 기준으로 보려 한 것이고, 기준이 될 좌표계(목표)를 먼저 씁니다.
#
# </details>
#
# <details><summary>08장에서. <code>Time()</code>으로 조회하면 어느 시각의 변환이 나옵니까? 이 장의 버퍼에는 오도메트리 표본이 14.6초까지 있는데, 왜 14.0초의 변환이 나올까요?</summary>
#
# 최신 *공통* 시각의 변환입니다. 경로 위 모든 동적 연결의 최신 표본 가운데 가장 이른 시각입니다. 정적 연결은 세지 않습니다.
#
# </details>
#
# <details><summary>02장에서. 누군가 쿼터니언이 (0, 0, 0, 0)인 변환을 발행합니다. <em>여러분</em>은 어디서 어떤 예외를 만나게 될까요?</summary>
#
# 원인과 멀리 떨어진 여러분의 조회에서 LookupException이 납니다. 수신기가 그 변환을 거절하고 로그에만 남기므로, 그 좌표계는 한 번도 받은 적 없는 이름이 됩니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice questions

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제

# %% [markdown] lang="en" name="practice" slide="-"
# Answer on paper, then open the list and mark yourself: one point for each idea that is there.
#
# **Q11.** What is the difference between LookupException, ConnectivityException and ExtrapolationException?
#
# <details><summary>Ideas of a full answer</summary>
#
# - Lookup: a *name* is not in the buffer (typo, publisher not running, nothing received *yet*).
# - Connectivity: both names are known, but there is no *path*: the tree is in pieces, two roots.
# - Extrapolation: there is a path, but an edge on it has no data at that *time*, and tf2 does not guess.
# - Each needs another first check: the name; the tree; stamps and clocks.
# - For an extra point: with two faults at once, tf2 may report the time first.
#
# </details>
#
# **Q12.** Give two causes each of future and of past extrapolation.
#
# <details><summary>Ideas of a full answer</summary>
#
# - Future: the transform is still on its way, or its publisher is slow or has died.
# - Future: the sensor's clock is ahead, or the clock of the transform's publisher is behind.
# - Past: processing the message took longer than the cache time, or the message is from before TF began.
# - Past: stamps of another clock: a sensor clock that is behind, a bag's old stamps.
# - Waiting helps only while the transform is on its way or its publisher is slow.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# 종이에 답한 뒤 목록을 열어 스스로 채점해 보세요. 아래 내용이 하나 들어 있을 때마다 1점입니다.
#
# **Q11.** LookupException, ConnectivityException, ExtrapolationException은 어떻게 다릅니까?
#
# <details><summary>좋은 답에 담긴 내용</summary>
#
# - Lookup: 버퍼에 *이름*이 없습니다(오타, 발행자가 꺼져 있음, *아직* 받지 못함).
# - Connectivity: 두 이름은 있지만 *경로*가 없습니다. 트리가 여러 조각이고 루트가 둘입니다.
# - Extrapolation: 경로는 있지만 그중 한 연결에 그 *시각*의 값이 없고, tf2는 짐작하지 않습니다.
# - 먼저 확인할 것이 서로 다릅니다. 이름, 트리, 시각과 시계입니다.
# - 하나 더: 결함이 둘이면 시각 문제가 먼저 보고될 수 있습니다.
#
# </details>
#
# **Q12.** 미래 외삽과 과거 외삽의 원인을 각각 두 가지씩 쓰십시오.
#
# <details><summary>좋은 답에 담긴 내용</summary>
#
# - 미래: 변환이 아직 오는 중이거나, 발행률이 낮거나 발행자가 종료되었습니다.
# - 미래: 센서 시계가 앞서 있거나, 변환 발행자의 시계가 뒤처져 있습니다.
# - 과거: 처리 시간이 버퍼의 보관 시간보다 길었거나, TF가 시작되기 전의 메시지입니다.
# - 과거: 다른 시계의 시각입니다. 뒤처진 센서 시계, bag에 담긴 옛 시각이 그렇습니다.
# - 기다림은 변환이 아직 오는 중이거나 발행률이 낮을 때만 도움이 됩니다.
#
# </details>
