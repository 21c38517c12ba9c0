# %% [markdown] lang="en" name="title" slide="slide"
# # 08 · Buffer and measurement time
#
# **Where was the robot when it measured?** · about 45 minutes · builds on 01, 03, 04, 05 and 06
#
# After this chapter you can
#
# - describe a [[buffer]] as one [[timeline]] for each edge of the tree,
# - say what the buffer returns between two samples, and which times it rejects,
# - find the [[latest common time]] of a path, and say what `Time()` means,
# - transform a message at the time of its measurement,
# - estimate the error if you use another time.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 08 · 버퍼와 측정 시각
#
# **측정한 순간, 로봇은 어디에 있었을까요?** · 약 45분 · 01, 03, 04, 05, 06장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - [[buffer|변환 버퍼(buffer)]]가 트리의 연결마다 [[timeline|시간줄(timeline)]]을 하나씩 두는 것을 설명할 수 있습니다.
# - 두 표본 사이의 시각을 조회하면 무엇이 나오고, 그 바깥의 시각은 왜 거절되는지 말할 수 있습니다.
# - 경로의 [[latest common time|최신 공통 시각]]을 찾고, `Time()`이 무엇을 뜻하는지 말할 수 있습니다.
# - 측정한 순간의 변환을 써서 메시지를 다른 좌표계 기준으로 바꿀 수 있습니다.
# - 그렇게 하지 않으면 얼마나 빗나가는지 어림할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Ask the class first: how old is what you see on your phone's camera screen?
# Nobody says "zero" for long.
# The whole chapter is about that number and how tf2 handles it.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 먼저 이렇게 묻습니다. 휴대전화 카메라 화면에 보이는 장면은 몇 밀리초 전의 것일까요?
# “0”이라고 답한 사람에게는 화면 앞에서 손을 흔들어 보게 합니다.
# 이 장은 처음부터 끝까지 그 숫자, 곧 지연을 다룹니다.

# %% [markdown] lang="en" name="needed" slide="slide"
# ## What you need to begin
#
# - **A point** (01) needs three things: a value, a frame, and the time of its measurement. In ROS 2 the last two are `header.frame_id` and `header.stamp`.
# - **A lookup** (03) has a fixed order: `lookup_transform(target, source, time)`. Data is expressed in the source, and wanted in the target.
# - **The tree** (04) has one path between two frames, made of edges.
# - **Our robot** (05) has `map → odom → base_footprint → base_link`. The localisation corrects `map → odom`. The wheel odometry publishes `odom → base_footprint` many times a second.
# - **Two kinds of edge** (06): a static one, such as a camera's mount, is sent once and is valid at all times. A dynamic one is sent again and again, each time with its [[stamp]].
# - **A node** is a program. ROS 2 calls one of its functions, a *callback*, with each message that arrives. *Spinning* means waiting for messages and calling callbacks.

# %% [markdown] lang="ko" name="needed" slide="slide"
# ## 시작하기 전에 알아 둘 것
#
# - **점**(01)을 나타내려면 값, 좌표계, 측정 시각이 모두 필요합니다. ROS 2에서 뒤의 둘은 `header.frame_id`와 `header.stamp`입니다.
# - **조회**(03)의 순서는 정해져 있습니다. `lookup_transform(target, source, time)`은 원본(source) 기준 데이터를 목표(target) 기준으로 바꾸는 변환을 반환합니다.
# - **트리**(04)에서 두 좌표계 사이에는 연결(edge)로 이루어진 경로가 하나 있습니다.
# - **우리 로봇**(05)에는 `map → odom → base_footprint → base_link`가 있습니다. `map → odom`은 위치 추정 노드가 보정하고, `odom → base_footprint`는 바퀴 오도메트리 노드가 1초에 여러 번 발행합니다.
# - **두 종류의 연결**(06): 카메라 장착 변환 같은 정적 연결은 한 번 보내면 언제나 유효합니다. 동적 연결은 매번 [[stamp|측정 시각(stamp)]]과 함께 계속 보냅니다.
# - **노드**는 프로그램입니다. 메시지가 도착할 때마다 ROS 2가 그 노드의 함수, 즉 *콜백*(callback)을 호출합니다. *spin*은 메시지를 기다리며 콜백을 호출하는 일입니다.

# %% name="load" slide="skip"
# %load_ext tflab
import math

import numpy as np

from tflab.core import BufferCore, StampedTransform, Transform, seconds
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## Fifty years, and the length of a hand
#
# A mapping node looked up the robot's pose at 1574652168.59 s. (Computers count the seconds since 1 January 1970.)
# The newest transform was from 3.235 s.
# The node used system time, in 2019, and TF used the clock of a simulation that had just started. They were almost fifty years apart ([ANYbotics/elevation_mapping, issue 122](https://github.com/ANYbotics/elevation_mapping/issues/122)).
#
# That mistake is easy to find. Nothing works, and the error message shows why.
#
# This one is harder: everything works, there is no error, and each obstacle is the length of a hand away from where it really is.
# You now build it.
# A robot weaves through a room at half a metre per second.
# Its camera looks for one ball. The detector takes 0.2 s to find it in an image.
#
# The next cell starts the robot. Its code is folded away.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 오십 년, 그리고 20센티미터
#
# 어느 지도 작성 노드가 1574652168.59초의 로봇 포즈를 조회했습니다. (컴퓨터의 시계는 1970년 1월 1일부터 지난 시간을 초로 나타냅니다.)
# 그때 TF의 최신 변환은 3.235초의 변환이었습니다.
# 노드는 2019년의 시스템 시간을, TF는 방금 켜진 시뮬레이션의 시각을 썼으니 둘은 거의 오십 년 떨어져 있었습니다([ANYbotics/elevation_mapping, 이슈 122](https://github.com/ANYbotics/elevation_mapping/issues/122)).
#
# 이 고장은 찾기 쉽습니다. 아무것도 동작하지 않고, 오류 메시지에 이유가 나옵니다.
#
# 더 찾기 어려운 고장이 있습니다. 모든 것이 동작하고 오류도 없는데, 장애물마다 실제 위치에서 20센티미터쯤 어긋나 있습니다.
# 직접 만들어 봅시다.
# 로봇 한 대가 초속 0.5미터로 방 안을 구불구불 나아갑니다.
# 카메라는 공 하나를 찾고, 찾는 계산에 0.2초가 걸립니다.
#
# 다음 셀은 로봇을 출발시킵니다. 상황을 준비하는 코드일 뿐이라 접어 두었습니다.

# %% name="start-the-robot" tags=["collapsed"]
# Start the robot.
graph = lesson.new_graph()  # the simulation; a new one whenever this cell runs
left, right = lesson.Leg(1.0, 0.5, 0.5), lesson.Leg(2.0, 0.5, -0.5)  # seconds, m/s, rad/s
weave = [lesson.Leg(1.0), *3 * [left, right, left]]
plan = lesson.Drive(weave, lesson.PlanarPose(-1.0, -1.5, 0.0), start_ns=graph.now_ns)
robot = lesson.TeachingRobot(plan, bias=0.0, slip=0.0005)  # good wheels: what you will see is time
parts = ["robot_state_publisher", "wheel_odometry", "localization", "object_detector"]
nodes = lesson.launch(graph, robot, only=parts)

# %% [markdown] lang="en" name="finder-intro" slide="subslide"
# This node puts the ball on the map. Read it slowly.
#
# - The [[listener]] subscribes to `/tf` and `/tf_static`, and fills the [[buffer]]. This buffer keeps the last 20 s (`cache_time`).
# - `on_point` is called with each detection. It looks up `map_T_camera`, and transforms the point.
# - It uses `Time()`. The author thought: "the newest pose is surely the best one".
#
# The cell after the class lets twelve seconds pass. `spin_once` waits for one message and calls its callback. Time here is simulated, so this is quick.

# %% [markdown] lang="ko" name="finder-intro" slide="subslide"
# 공의 위치를 지도에 표시하는 노드입니다.
# 천천히 읽어 보세요. 이런 노드는 대개 이 정도로 짧습니다.
#
# - [[listener|변환 수신기(listener)]]는 `/tf`와 `/tf_static`을 구독해 [[buffer|버퍼]]를 채웁니다. 이 버퍼는 최근 20초를 보관합니다(`cache_time`).
# - 공을 볼 때마다 `on_point`가 호출됩니다. 버퍼에서 `map_T_camera`를 조회하고, 점을 지도 기준으로 바꿉니다.
# - 조회할 때는 `Time()`을 씁니다. 작성자는 “가장 최근 포즈가 당연히 가장 좋겠지”라고 생각했습니다.
#
# 그다음 셀에서는 12초가 흐릅니다. `spin_once`는 메시지 하나를 기다려 콜백을 호출합니다. 이 페이지의 시간은 가상이라 금방 끝납니다.

# %% name="finder-imports" slide="skip"
import rclpy
from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_geometry_msgs import do_transform_point
from tf2_ros import Buffer, TransformException, TransformListener

# %% name="finder"
class Finder(Node):
    def __init__(self):
        super().__init__("finder")
        self.buffer = Buffer(cache_time=Duration(seconds=20.0))
        self.listener = TransformListener(self.buffer, self)
        self.create_subscription(PointStamped, "detected_point", self.on_point, 10)
        self.messages, self.balls = [], []

    def on_point(self, message):
        self.messages.append(message)
        map_T_camera = self.buffer.lookup_transform("map", message.header.frame_id, Time())
        point = do_transform_point(message, map_T_camera).point
        self.balls.append((point.x, point.y, point.z))

# %% name="twelve-seconds"
rclpy.init()
finder = Finder()
end = finder.get_clock().now() + Duration(seconds=12.0)  # to repeat the drive, start the robot again first
while finder.get_clock().now() < end:
    rclpy.spin_once(finder)
print(len(finder.balls), "detections")

# %% [markdown] lang="en" name="how-many-balls" slide="slide"
# ### Predict
#
# The robot detected one resting ball forty times.
# Before you run the next cell: what does the map look like, and how many balls would you say there are?

# %% [markdown] lang="ko" name="how-many-balls" slide="slide"
# ### 예측해 봅시다
#
# 공은 하나이고 움직이지 않습니다. 로봇은 그 공을 마흔 번 보았습니다.
# 다음 셀을 실행하기 전에 생각해 봅시다. 지도는 어떤 모습일까요? 지도만 보면 공이 몇 개라고 할까요?

# %% name="one-ball" tags=["predicted", "collapsed"] slide="fragment"
# Draw the path, the ball and the detections.
drive = [robot.truth_at(seconds(0.1 * i))["base_link"].translation for i in range(131)]
lesson.draw_detections(finder.balls, lesson.BALL, path=drive, how="transformed with Time()")

# %% [markdown] lang="en" name="many-balls" tags=["predicted"] slide="subslide"
# The upper part shows the robot's path in `map`, and where it ended. The lower part enlarges the rectangle around the ball. The ring is the ball's true position. The dots are the detections.
#
# Not one dot is in the ring.
# You would count four or five balls on the map. They form two groups, one on either side of the real ball. They are off by 0.20 m on average and by 0.28 m at worst.
# A gripper would close on nothing.
#
# The mathematics was right, and so was the tree.
# The lookup was wrong: it returned the camera's *newest* pose, for an image that was taken *earlier*.

# %% [markdown] lang="ko" name="many-balls" tags=["predicted"] slide="subslide"
# 그림의 위쪽은 `map` 기준으로 그린 로봇의 경로와 마지막 위치입니다. 아래쪽은 공을 둘러싼 네모를 확대한 것입니다. 고리가 공의 실제 위치이고, 점은 지도에 찍힌 공의 위치입니다.
# *그림 읽기:* the robot's path = 로봇의 경로, ball (true position) = 공(실제 위치), detections, transformed with Time() = `Time()`으로 변환한 관측, x (y) in map = `map` 기준 x(y), off by … on average / at worst = 평균 / 최대 … 빗나감.
#
# 고리 안에 든 점은 하나도 없습니다.
# 지도에는 공이 네다섯 개, 진짜 공의 양쪽에 두 무리로 나타납니다. 평균 0.20 m, 최대 0.28 m 빗나갔습니다.
# 그리퍼라면 허공을 움켜쥐었을 것입니다.
#
# 수식도 트리도 맞았습니다.
# 틀린 것은 요청 시각입니다. 카메라가 *그때* 본 것인데, 카메라가 *지금* 어디 있는지를 조회했습니다.

# %% [markdown] lang="en" name="many-balls-notes" slide="notes"
# Let them count. Wait for the laugh, then ask why there are two groups and not one cloud.
# The robot turned left or right nearly all the time. It hardly ever drove straight.
# Real numbers to mention: in a recorded Nav2 run, looking up map → base_link "now" instead of at the localiser's stamp moved the robot by 3 cm in the median and 15 cm at worst.

# %% [markdown] lang="ko" name="many-balls-notes" slide="notes"
# 직접 세어 보게 합니다. 그다음 왜 한 무리가 아니라 두 무리인지 묻습니다.
# 로봇은 왼쪽으로 회전하고 있었거나 오른쪽으로 회전하고 있었습니다. 곧게 가는 순간은 거의 없었습니다.
# 실제 수치도 있습니다. 기록된 Nav2 주행에서 map → base_link를 위치 추정의 측정 시각 대신 현재 시각으로 조회하면 로봇의 위치가 중앙값으로 3 cm, 최대 15 cm 틀렸습니다.

# %% [markdown] lang="en" name="predict-error" slide="slide"
# ## How far off, with a pencil
#
# ### Predict
#
# 1. A robot drives straight ahead at 1 m/s. It detects an object 5 m ahead and uses the detection 200 ms later, with the robot's *current* pose. How large is the error?
# 2. The same, but the robot also turns left at 0.5 rad/s. How large is the error now: about the same, twice, or more than twice?
#
# Write both numbers down. Then run the cell.

# %% [markdown] lang="ko" name="predict-error" slide="slide"
# ## 연필로 어림하는 오차
#
# ### 예측해 봅시다
#
# 1. 로봇이 1 m/s로 곧게 달립니다. 5 m 앞의 물체를 보고, 200 ms 뒤에 그 관측을 지도 기준으로 바꿉니다. 이때 로봇의 *지금* 포즈를 씁니다. 물체는 얼마나 빗나가 그려질까요?
# 2. 같은 조건에서, 이번에는 달리면서 0.5 rad/s로 왼쪽으로 회전합니다. 이제 얼마나 빗나갈까요? 비슷할까요, 두 배일까요, 두 배보다 클까요?
#
# 두 숫자를 적어 두고 실행해 보세요.

# %% name="run-error" tags=["predicted", "collapsed"] slide="fragment"
# Calculate both errors.
straight = lesson.Sight(speed_mps=1.0, yaw_rate_radps=0.0, range_m=5.0, delay_ns=seconds(0.2))
turning = lesson.Sight(speed_mps=1.0, yaw_rate_radps=0.5, range_m=5.0, delay_ns=seconds(0.2))
for name, sight in (("straight", straight), ("turning", turning)):
    error = lesson.latency_error(sight)
    print(f"{name}: {error.exact_m:.3f} m off, at ({error.drawn_at[0]:.3f}, {error.drawn_at[1]:.3f})")

# %% [markdown] lang="en" name="two-pieces" tags=["predicted"] slide="subslide"
# Straight: 0.2 m. Turning: 0.54 m, nearly three times as much, although the robot rotates by less than 6° in that time.
#
# The error has two components, at right angles to each other:
#
# - **forwards**: speed × delay = 1.0 × 0.2 = 0.2 m;
# - **sideways**: range × yaw rate × delay = 5 × 0.5 × 0.2 = 0.5 m.
#
# The lecture's formula (§17) is the first component, `speed × delay`. It leaves out the rotation, so it holds only for a robot that drives straight. On a robot that turns, the second component is the larger one as soon as range × yaw rate is larger than the speed.
# It grows with the range: distant objects are far off.
# (On our map the error is only about half of what this formula gives for 0.2 s, because `Time()` did not return the current pose, but one from about 0.1 s earlier, halfway back to the stamp.)
#
# <details><summary>If you predicted something else</summary>
#
# - *0.2 m both times*: you left out the rotation. By now the robot has rotated another 0.1 rad, and at 5 m that is half a metre.
# - *0.7 m*: you added the components. They are at right angles, so it is √(0.2² + 0.5²).
# - *To the right*: the old detection is placed straight ahead of the robot. Now the robot faces further left, so the error is to the left.
# - *About 29 m, or 9 mm sideways*: you mixed up degrees and radians.
#
# </details>

# %% [markdown] lang="ko" name="two-pieces" tags=["predicted"] slide="subslide"
# 곧게 갈 때 0.2 m, 회전할 때 0.54 m입니다. 거의 느끼지도 못할 회전 때문에 오차가 세 배 가까이 커졌습니다.
#
# 오차는 서로 직각인 두 성분으로 이루어집니다.
#
# - **앞뒤 방향**: 속도 × 지연 = 1.0 × 0.2 = 0.2 m
# - **좌우 방향**: 거리 × yaw 각속도 × 지연 = 5 × 0.5 × 0.2 = 0.5 m
#
# 강의의 식(§17)은 첫 성분인 `속도 × 지연`입니다. 회전이 빠져 있으므로 곧게 가는 로봇에만 맞습니다. 로봇이 회전해 거리 × yaw 각속도가 속도보다 커지면, 둘째 성분이 더 큽니다.
# 둘째 성분은 거리에 비례합니다. 멀리 있는 것일수록 멀리 빗나갑니다.
# (우리 지도의 공은 이 식에 0.2초를 넣은 값의 절반쯤만 빗나갔습니다. `Time()`으로 얻은 것은 지금의 포즈가 아니라 약 0.1초 전의 포즈, 곧 측정 시각과 지금의 중간쯤의 포즈였기 때문입니다.)
#
# <details><summary>다르게 예측했다면</summary>
#
# - *두 번 다 0.2 m*: 회전을 빠뜨렸습니다. 지금의 로봇은 0.1 rad 더 회전해 있고, 5 m 앞에서는 그것이 0.5 m입니다.
# - *0.7 m*: 두 성분을 더했습니다. 서로 직각이므로 √(0.2² + 0.5²)입니다.
# - *오른쪽으로 빗나간다*: 관측값은 ‘정면 5 m’라는 뜻일 뿐입니다. 지금 로봇은 더 왼쪽을 보고 있으니 관측도 왼쪽으로 어긋납니다.
# - *약 29 m, 또는 옆으로 9 mm*: 라디안을 쓰는 식에 도 단위 각속도를 넣었거나 그 반대입니다.
#
# </details>

# %% [markdown] lang="en" name="two-pieces-notes" slide="notes"
# Collect the numbers for the second question before you go on; most say 0.2 or 0.3 m.
# Then rotate on the spot by a few degrees with an arm stretched out: the body hardly moves, the hand does.

# %% [markdown] lang="ko" name="two-pieces-notes" slide="notes"
# 다음으로 넘어가기 전에 둘째 문제의 답을 모읍니다. 대개 0.2 m나 0.3 m라고 합니다.
# 그런 다음 팔을 뻗고 제자리에서 몇 도만 회전해 보입니다. 몸은 거의 움직이지 않는데 손은 크게 움직입니다.

# %% [markdown] lang="en" name="the-sentence" slide="slide"
# ## The idea, three times
#
# **In a sentence:** look up where the sensor was at the time of the measurement, not where it is when the computation has finished.
#
# **In numbers:** 0.2 m straight ahead, 0.54 m in a turn.
#
# **In 3D:** below. The solid lines are the robot at the stamp, the dashed lines are the robot now.
# Drag the delay, and watch the error grow.

# %% [markdown] lang="ko" name="the-sentence" slide="slide"
# ## 같은 내용을 세 가지로
#
# **한 문장으로:** 계산이 끝난 지금 센서가 어디 있는지가 아니라, 빛이 들어온 그때 센서가 어디 있었는지를 조회합니다.
#
# **숫자로:** 곧게 갈 때 0.2 m, 회전할 때 0.54 m입니다.
#
# **3D로:** 아래입니다. 실선은 측정 시각의 로봇, 파선은 지금의 로봇입니다.
# delay 슬라이더를 끌면서 공이 어떻게 어긋나는지 살펴보세요.
# *그림 읽기:* robot at the stamp = 측정 시각의 로봇, robot now = 지금의 로봇, ball = 공, object = 물체, from above = 위에서 본 모습, in 3D = 3D로, error = 오차, enlarged = 확대한 것, exactly = 정확한 값, speed × delay = 속도 × 지연, range × yaw rate × delay = 거리 × yaw 각속도 × 지연, drawn with the pose of now = 지금의 포즈로 그린 것.

# %% name="scene-of-the-delay" tags=["interactive", "collapsed"] slide="subslide"
# Show the 3D view.
lesson.show_latency()

# %% name="picture-of-the-delay" tags=["static"]
lesson.draw_latency(turning)

# %% [markdown] lang="en" name="slider-intro" slide="slide"
# ### Play with it
#
# There are four sliders. Say your answers aloud first. Then move the sliders and check your answers.
#
# - You set one of speed, yaw rate, range and delay to zero. For which one does the error vanish?
# - Your robot turns at 0.5 rad/s, and at a range of 5 m you accept an error of 0.1 m. How old may a detection be?

# %% [markdown] lang="ko" name="slider-intro" slide="slide"
# ### 직접 해 보세요
#
# 슬라이더가 네 개 있습니다. 먼저 소리 내어 답하고, 그다음 슬라이더를 움직여 확인해 보세요.
#
# - 속도, yaw 각속도, 거리, 지연 가운데 하나만 0으로 놓습니다. 어느 것을 0으로 놓으면 오차가 사라질까요?
# - 5 m 앞에서 오차가 0.1 m까지 허용되고 로봇은 0.5 rad/s로 회전합니다. 관측은 몇 초 전의 것까지 써도 될까요?

# %% name="slider" tags=["interactive", "collapsed"] slide="subslide"
# Show the panel.
lesson.latency_panel(turning)

# %% name="slider-still" tags=["static"]
lesson.draw_latency(turning)

# %% [markdown] lang="en" name="slider-answer" slide="fragment"
# <details><summary>Answers</summary>
#
# Only the delay, and that is why this chapter is about time.
# At zero speed the rotation still causes an error; at zero yaw rate the translation does.
#
# 0.1 m = 5 m × 0.5 rad/s × delay, so 0.04 s even for a robot that rotates on the spot. That is about one period of a 30 Hz camera.
# A faster detector alone does not help. Looking up the right time does.
#
# </details>

# %% [markdown] lang="ko" name="slider-answer" slide="fragment"
# <details><summary>답</summary>
#
# 지연뿐입니다. 그래서 이 장은 시간에 관한 장입니다.
# 속도가 0이어도 회전 때문에 오차가 남고, 각속도가 0이어도 이동 때문에 오차가 남습니다.
#
# 0.1 m = 5 m × 0.5 rad/s × 지연이므로, 제자리에서 회전하는 로봇이라도 0.04초까지입니다. 30 Hz 카메라의 한 주기보다 조금 깁니다.
# 계산을 더 빠르게 하는 것만으로는 부족합니다. 올바른 시각의 변환을 조회해야 합니다.
#
# </details>

# %% [markdown] lang="en" name="the-lanes" slide="slide"
# ## What the buffer remembers
#
# You can look up a past pose only if the buffer stored it.
#
# Each edge of the tree has a timeline of its own.
# A timeline holds the [[sample|samples]] that were received, each at its stamp, for the last few seconds.
# A static edge has one value, and it is valid at all times.
#
# Here is a small buffer, filled by hand so that you can count its samples.
# `map → odom` has one sample a second, `odom → base_link` has four and drives along x at 1 m/s, and the laser is mounted 0.20 m ahead.

# %% [markdown] lang="ko" name="the-lanes" slide="slide"
# ## 버퍼가 기억하는 것
#
# 과거의 포즈는 저장되어 있어야 조회할 수 있습니다.
# 버퍼가 하는 일이 바로 그것입니다.
#
# 트리의 연결마다 시간줄이 하나씩 있습니다. 아래 그림에서는 가로로 한 줄입니다.
# 시간줄에는 최근 몇 초 동안 받은 [[sample|표본(sample)]]이 저마다 측정 시각 자리에 놓여 있습니다.
# 정적 연결에는 값이 하나뿐이고, 어느 시각에나 유효합니다.
#
# 표본을 셀 수 있도록 작은 버퍼를 손으로 채웠습니다.
# `map → odom`에는 1초에 표본 하나, `odom → base_link`에는 1초에 네 개가 있고 x 방향으로 초속 1 m로 나아갑니다. 레이저는 0.20 m 앞에 달려 있습니다.

# %% name="small-buffer" tags=["collapsed"]
# Fill a small buffer.
small = Buffer()
mount = StampedTransform("base_link", "laser_frame", seconds(1.0), Transform((0.20, 0.0, 0.15)))
small.core.set_transform(mount, is_static=True)
for i in range(3):  # map -> odom, once a second
    small.core.set_transform(StampedTransform("map", "odom", seconds(2.0 + i), Transform()))
for i in range(14):  # odom -> base_link, four times a second, at 1 m/s
    pose = Transform((0.25 * i, 0.0, 0.0))
    small.core.set_transform(StampedTransform("odom", "base_link", seconds(1.5 + 0.25 * i), pose))

# %% name="three-lanes" tags=["collapsed"] slide="subslide"
# Draw its timelines.
lesson.draw_history(small.core, "map", "laser_frame", seconds(3.4))

# %% [markdown] lang="en" name="between" slide="slide"
# ### Between two samples
#
# No sample has the stamp 3.4 s, and still there is an answer: x = 2.1 m.
# The neighbours on `odom → base_link` are 3.25 s (1.75 m) and 3.5 s (2.00 m). 3.4 s is 0.6 of the way between them, so the robot is at 1.90 m. The laser is 0.20 m further ahead.
# That is [[interpolation]]: positions along a straight line, rotations along the shortest arc.
#
# Within a timeline the buffer interpolates. Outside it, it never guesses.

# %% [markdown] lang="ko" name="between" slide="slide"
# ### 두 표본 사이
#
# 3.4초에는 표본이 없는데도 값이 나옵니다. x = 2.1 m입니다.
# `odom → base_link`의 이웃 표본은 3.25초(1.75 m)와 3.5초(2.00 m)입니다. 3.4초는 그 사이의 0.6 지점이므로 1.90 m이고, 레이저까지 0.20 m를 더합니다.
# 이것이 [[interpolation|보간(interpolation)]]입니다. 이동은 직선을, 회전은 가장 짧은 호를 따라 보간합니다.
#
# 시간줄 안에서는 표본이 없는 시각을 보간합니다. 바깥의 시각은 결코 짐작하지 않습니다.

# %% [markdown] lang="en" name="latest-common" slide="slide"
# ### How fresh is "latest"?
#
# A lookup uses several timelines, and *each* must cover the requested time.
# The shaded band in the picture is where all of them do.
#
# `Time()` means "time zero", and tf2 takes it as the [[latest common time]] of the path.
# It does **not** mean now.
#
# **Predict** from the picture: `map → odom` ends at 4.00 s, `odom → base_link` at 4.75 s, the static mount was sent at 1.00 s, and the time now is 4.80 s.
# Which time does `Time()` give? (The output writes target `<-` source.)

# %% [markdown] lang="ko" name="latest-common" slide="slide"
# ### “최신”은 언제의 것일까요?
#
# 조회 하나가 여러 시간줄을 지나며, 시간줄 *하나하나*에 그 시각의 값이 있어야 합니다.
# 그림에서 칠해진 띠가 모든 시간줄에 값이 있는 구간입니다. *그림 읽기:* all of them = 모든 시간줄, query = 조회, stamp = 측정 시각.
#
# `Time()`은 “시각 0”이고, tf2는 이것을 그 경로의 [[latest common time|최신 공통 시각]]으로 처리합니다.
# “지금”이라는 뜻이 **아닙니다**.
#
# 그림을 보고 **예측해 봅시다.** `map → odom`은 4.00초에, `odom → base_link`는 4.75초에 끝나고, 정적인 장착 변환은 1.00초에 보냈으며, 현재 시각은 4.80초입니다.
# `Time()`으로 조회하면 어느 시각의 변환이 나올까요? (출력의 `map <- laser_frame`은 목표 ← 원본입니다.)

# %% name="latest-common-run" tags=["predicted"] slide="fragment"
for target in ("map", "odom", "base_link"):
    latest = small.get_latest_common_time(target, "laser_frame")
    print(latest.nanoseconds / 1e9, "s ", target, "<- laser_frame")

# %% [markdown] lang="en" name="latest-common-read" tags=["predicted"] slide="subslide"
# 4.00 s: **the earliest of the latest samples**. The timeline that ends first limits the result.
#
# - For 4.75 s, `map → odom` has no data yet.
# - 1.00 s is the stamp of the static edge, which is valid at all times and limits nothing.
# - 4.80 s is now, and nothing in the buffer is that new.
#
# The path between `odom` and `laser_frame` does not contain the slow timeline, so its latest common time is 4.75 s.
# A path of static edges only has no latest time; tf2 returns 0.
#
# Here is our driving robot, shortly after its last detection:

# %% [markdown] lang="ko" name="latest-common-read" tags=["predicted"] slide="subslide"
# 4.00초, 즉 **마지막 시각들 가운데 가장 이른 것**입니다. 가장 먼저 끝나는 시간줄이 전체를 제한합니다.
#
# - 4.75초에는 `map → odom`의 값이 아직 없습니다.
# - 1.00초는 정적 연결의 측정 시각입니다. 정적 연결은 언제나 유효하므로 제한하지 않습니다.
# - 4.80초는 현재 시각이고, 버퍼에 그만큼 최근의 표본은 없습니다.
#
# 목표가 `odom`이면 `map → odom`을 지나지 않으므로 4.75초입니다.
# 정적 연결만으로 된 경로에는 최신 시각이 없고, tf2는 0을 반환합니다.
#
# 다음은 마지막으로 공을 본 직후의 우리 로봇입니다.

# %% name="latest-live"
newest = finder.buffer.lookup_transform("map", "camera_optical_frame", Time())
print("now:                 ", finder.get_clock().now().nanoseconds / 1e9)
print("stamp of Time():     ", Time.from_msg(newest.header.stamp).nanoseconds / 1e9)
print("stamp of the message:", Time.from_msg(finder.messages[-1].header.stamp).nanoseconds / 1e9)

# %% [markdown] lang="en" name="latest-live-read"
# There are three times here: 13.00 s is now, 12.89 s is the latest common time, and 12.80 s is the stamp of the image.
# `Time()` gives neither now nor the time of the image. It gives the end of the timeline that ends first.
# The returned transform contains its stamp.
#
# Now drag the requested time through the small buffer, and past both of its ends.

# %% [markdown] lang="ko" name="latest-live-read"
# 시각이 셋입니다. 지금 13.00초, “최신” 12.89초, 영상을 찍은 12.80초입니다.
# `Time()`은 지금도 아니고 영상을 찍은 때도 아닙니다. 가장 먼저 끝나는 시간줄의 마지막 시각일 뿐입니다.
# 조회한 변환에는 시각(stamp)이 붙어 있습니다. 출력해 보면 “지금”이 아님을 알 수 있습니다.
#
# 이제 작은 버퍼에서 요청 시각을 끌어 시간줄의 양쪽 끝을 넘어가 보세요.

# %% name="drag-the-query" tags=["interactive", "collapsed"] slide="subslide"
# Show the panel.
frames = ("odom", "base_link", "laser_frame")
timelines = [lesson.lane_from_history(small.core.history(child)) for child in frames]
lesson.timeline_panel("map", "laser_frame", timelines, small.core.lookup_transform, seconds(3.4))

# %% name="past-the-end" tags=["static"]
lesson.draw_history(small.core, "map", "laser_frame", seconds(4.4))

# %% [markdown] lang="en" name="past-the-end-read"
# At 4.4 s, for example, `odom → base_link` has data and `map → odom` has none, so there is no answer.
# tf2 calls this [[extrapolation]], and raises an exception. Chapter 09 is about these exceptions.

# %% [markdown] lang="ko" name="past-the-end-read"
# 예를 들어 4.4초에 `odom → base_link`에는 값이 있지만 `map → odom`에는 값이 없으므로, 조회가 실패합니다.
# tf2는 이것을 [[extrapolation|외삽(extrapolation)]]이라 부르고 예외를 일으킵니다. 예외는 09장에서 자세히 다룹니다.

# %% [markdown] lang="en" name="past-the-end-notes" slide="notes"
# Drag slowly across 4.00 s and let the class see the handle change into a cross.
# Ask: what is the cause, the lookup or map → odom?
# Then tick LATEST and watch the handle jump back to 4.00 s.

# %% [markdown] lang="ko" name="past-the-end-notes" slide="notes"
# 4.00초를 천천히 넘기며 손잡이가 X로 바뀌는 순간을 보여 줍니다.
# 그리고 묻습니다. 무엇을 고쳐야 합니까? 조회입니까, map → odom입니까?
# 그런 다음 LATEST를 켜서 손잡이가 4.00초로 되돌아가는 것을 보여 줍니다.

# %% [markdown] lang="en" name="worked" slide="slide"
# ## A worked example: value, frame and stamp
#
# A message contains the value, the frame and the stamp. You only have to name the target:
#
# 1. **target**: where you want it, `"map"`;
# 2. **source**: `message.header.frame_id`;
# 3. **time**: `message.header.stamp`.

# %% [markdown] lang="ko" name="worked" slide="slide"
# ## 예제: 값, 좌표계, 측정 시각
#
# 값, 좌표계, 측정 시각은 모두 메시지에 있습니다. 우리가 정할 것은 목표뿐입니다.
#
# 1. **목표**(target): 기준이 될 좌표계, `"map"`
# 2. **원본**(source): `message.header.frame_id`
# 3. **시각**(time): `message.header.stamp`

# %% name="worked-by-hand"
message = finder.messages[12]
stamp = Time.from_msg(message.header.stamp)  # the message's stamp, as lookups take it
map_T_camera = finder.buffer.lookup_transform("map", message.header.frame_id, stamp)
by_hand = do_transform_point(message, map_T_camera)
print(f"at {stamp.nanoseconds / 1e9} s: ({by_hand.point.x:.2f}, {by_hand.point.y:.2f}, {by_hand.point.z:.2f})")

# %% [markdown] lang="en" name="worked-one-line" slide="subslide"
# The true position of the ball is (6.50, -1.50, 0.30).
#
# tf2 has one call for these lines.
# `buffer.transform(message, "map")` reads frame and stamp from the message, so you cannot mix them up:

# %% [markdown] lang="ko" name="worked-one-line" slide="subslide"
# 공의 실제 위치는 (6.50, -1.50, 0.30)입니다.
#
# 워낙 자주 쓰는 코드라 tf2에는 한 줄로 끝내는 함수가 있습니다.
# `buffer.transform(message, "map")`은 좌표계와 측정 시각을 메시지에서 직접 읽으므로, 인자를 틀릴 여지가 없습니다.

# %% name="transform-in-one-line"
points = [finder.buffer.transform(message, "map").point for message in finder.messages]

# %% name="one-ball-drawn" tags=["collapsed"] slide="fragment"
# Draw the detections, transformed at both times.
ways = {
    "newest pose: Time()": np.array(finder.balls),
    "pose at the stamp": np.array([(point.x, point.y, point.z) for point in points]),
}
lesson.draw_placed(ways, things=[lesson.BALL], shown_m=(5.8, -2.0, 7.2, -1.0))

# %% [markdown] lang="en" name="one-ball-again"
# One ball. The messages, the buffer and the robot are the same. Only the time of the lookup is different.
# The remaining error, 2 cm on average, is noise of the camera and the localisation.

# %% [markdown] lang="ko" name="one-ball-again"
# *그림 읽기:* newest pose = 최신 포즈, pose at the stamp = 측정 시각의 포즈. 고리는 공의 실제 위치입니다.
#
# 공이 하나입니다. 같은 메시지 마흔 개, 같은 버퍼, 같은 로봇이고, 바뀐 것은 셋째 인자뿐입니다.
# 남은 오차(평균 2 cm)는 카메라와 위치 추정의 잡음입니다.

# %% [markdown] lang="en" name="faded" slide="slide"
# ## Your turn, with two blanks
#
# The same kind of point, wanted in `odom` this time. Replace each `...`, and run the cell.

# %% [markdown] lang="ko" name="faded" slide="slide"
# ## 빈칸을 채워 보세요
#
# 같은 점을 이번에는 `odom` 기준으로 보고 싶습니다. `...` 두 곳을 바꾸고 실행해 보세요.

# %% name="faded-example"
message = finder.messages[20]
source_frame = ...  # which frame are the numbers expressed in?
moment = ...  # at which time were they measured? Time.from_msg(...) converts a stamp to a Time
if ... in (source_frame, moment):
    print("2 blanks")
else:
    odom_T_camera = finder.buffer.lookup_transform("odom", source_frame, moment)
    print(do_transform_point(message, odom_T_camera).point)

# %% [markdown] lang="en" name="faded-answer"
# <details><summary>How you know that it is right</summary>
#
# `finder.buffer.transform(message, "odom").point` gives the same numbers.
# The blanks are `message.header.frame_id` and `Time.from_msg(message.header.stamp)`.
#
# </details>

# %% [markdown] lang="ko" name="faded-answer"
# <details><summary>맞았는지 확인하는 법</summary>
#
# `finder.buffer.transform(message, "odom").point`의 숫자와 같아야 합니다.
# 빈칸은 `message.header.frame_id`와 `Time.from_msg(message.header.stamp)`입니다.
#
# </details>

# %% [markdown] lang="en" name="break-stamp" slide="slide"
# ## Break it on purpose: overwrite the stamp
#
# Many real nodes do this:
# they receive a message, filter it, and publish it with a new stamp, because "it is published now, after all".
# (`%xmode Minimal` hides the traceback. Only the last line matters here.)

# %% [markdown] lang="ko" name="break-stamp" slide="slide"
# ## 일부러 고장 내기: 측정 시각 덮어쓰기
#
# 이렇게 하는 노드가 실제로 많습니다.
# 메시지를 받아 필터를 거친 뒤, “어쨌든 지금 발행하니까”라며 지금 시각을 새로 적어 내보냅니다.
# (오류 위에는 원래 traceback이 길게 나옵니다. `%xmode Minimal`이 그것을 생략합니다. 중요한 것은 마지막 줄입니다.)

# %% name="overwritten" tags=["raises-exception"]
import copy

# %xmode Minimal
measured = finder.messages[-1]
late = copy.deepcopy(measured)
late.header.stamp = finder.get_clock().now().to_msg()  # measured 0.2 s ago, but stamped with the time now
finder.buffer.transform(late, "map")

# %% [markdown] lang="en" name="overwritten-read" slide="subslide"
# Read the last line. The lookup was for 13.000 s. The 12.946 s in the message is the end of `odom → base_footprint`, the first timeline on the path that ends too early. `map → odom` ends even earlier, at 12.890 s, as `Time()` showed above.
# So only 110 ms are missing. That looks easy to fix: let 0.2 s pass and try again.

# %% [markdown] lang="ko" name="overwritten-read" slide="subslide"
# 마지막 줄을 읽어 보세요. 13.000초의 변환을 조회했습니다. 오류 메시지의 12.946초는 경로에서 처음으로 값이 모자란 `odom → base_footprint`의 끝이고, `map → odom`은 앞에서 `Time()`으로 본 대로 12.890초에서 이미 끝납니다.
# 110 ms가 모자랄 뿐이니 쉽게 해결될 것 같습니다. 0.2초가 지난 다음 다시 조회해 봅시다.

# %% name="the-cure" slide="fragment"
end = finder.get_clock().now() + Duration(seconds=0.2)
while finder.get_clock().now() < end:
    rclpy.spin_once(finder)
for name, detection in (("overwritten", late), ("as measured", measured)):
    point = finder.buffer.transform(detection, "map").point
    off_m = math.dist((point.x, point.y), (6.50, -1.50))  # from the ball's true position
    print(f"{name}: ({point.x:.2f}, {point.y:.2f}), off by {off_m:.2f} m")

# %% [markdown] lang="en" name="the-cure-read" slide="subslide"
# The exception is gone, but the ball's position is wrong. From now on there is no error message.
# **The stamp is the time of the measurement, not of the arrival.** If you overwrite it, the error does not go away. It becomes invisible.

# %% [markdown] lang="ko" name="the-cure-read" slide="subslide"
# 오류는 사라졌지만 공의 위치가 틀렸습니다. 이제는 틀려도 오류가 나지 않습니다.
# **`header.stamp`는 도착한 시각이 아니라 측정한 시각입니다.** 덮어쓰면 오차가 없어지는 것이 아니라 드러나지 않게 됩니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# Your node looks up at `header.stamp`. Every few messages it gets "extrapolation into the future", and 40 ms are missing.
# Four colleagues suggest four changes. Choose one, then open its reply.
#
# <details><summary>A. Look up at <code>Time()</code> instead of the stamp.</summary>
#
# The error goes away, and each point is now transformed with a pose of another time. On a turning robot that was 20 cm in our room. You replaced an exception by a silent error.
#
# </details>
#
# <details><summary>B. Set <code>header.stamp</code> to now before the lookup.</summary>
#
# Then you look up an even newer time: more exceptions, and the lookups that succeed are wrong by the whole delay. Every node that receives the message after you gets the wrong stamp, too.
#
# </details>
#
# <details><summary>C. Keep the stamp, let the message wait a little for its transform, drop it when it is too old.</summary>
#
# Yes. 40 ms missing means that the transform is on its way. The time is right; you only looked it up too soon. Chapter 09 shows how to wait without blocking, and for how long.
#
# </details>
#
# <details><summary>D. Make the <code>cache_time</code> longer.</summary>
#
# The cache time decides how far *back* the buffer remembers. The transform that you need has not arrived yet.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 여러분의 노드는 `header.stamp`의 변환을 조회합니다. 몇 번에 한 번씩 40 ms가 모자란다며 "extrapolation into the future"가 나옵니다.
# 동료 넷이 수정안 넷을 내놓았습니다. 하나를 고른 뒤 답을 펼쳐 보세요.
#
# <details><summary>A. 측정 시각 대신 <code>Time()</code>으로 조회합니다.</summary>
#
# 오류는 사라지지만, 점마다 다른 순간의 포즈로 변환됩니다. 이 장 첫머리의 로봇은 회전하면서 그렇게 20 cm를 틀렸습니다. 눈에 띄는 오류를 눈에 띄지 않는 오차와 맞바꾼 셈입니다.
#
# </details>
#
# <details><summary>B. 조회하기 전에 <code>header.stamp</code>를 지금으로 바꿉니다.</summary>
#
# 더 나중의 시각을 조회하게 되어 예외가 늘고, 성공해도 지연 전체만큼 틀립니다. 게다가 그 메시지를 나중에 읽는 노드는 모두 틀린 시각을 쓰게 됩니다.
#
# </details>
#
# <details><summary>C. 측정 시각은 두고, 변환이 올 때까지 잠깐 기다리게 하고, 너무 오래되면 버립니다.</summary>
#
# 맞습니다. 40 ms가 모자란다는 것은 변환이 오는 중이라는 뜻입니다. 요청 시각은 옳았고, 너무 일찍 조회했을 뿐입니다. 스레드를 멈추지 않고 기다리는 법과 기다릴 시간은 09장에서 다룹니다.
#
# </details>
#
# <details><summary>D. <code>cache_time</code>을 늘립니다.</summary>
#
# 보관 시간은 버퍼가 얼마나 *오래된 것*까지 보관하는지를 정합니다. 지금 조회하는 것은 아직 도착하지 않았습니다. 보관 시간을 아무리 늘려도 소용없습니다.
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Everybody writes a letter down before anybody speaks. Let an A and a C argue: both get rid of the error, and only one of them places the ball correctly.

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 말하기 전에 모두 글자 하나를 적게 합니다. A와 C를 고른 사람이 서로 설득하게 합니다. 둘 다 오류는 없애지만, 공을 제자리에 놓는 것은 하나뿐입니다.

# %% [markdown] lang="en" name="on-a-robot" slide="slide"
# ## The same on a real robot
#
# The next cell is the main part of the lecture's node (§18). It is our finder with three changes: it uses the point's own stamp, waits for a transform (`timeout=`, 0.2 s in the lecture), and logs a warning if TF has none.
# It has a fault, which you find by running it.

# %% [markdown] lang="ko" name="on-a-robot" slide="slide"
# ## 실제 로봇에서
#
# 다음 셀은 강의에 나온 노드(§18)의 핵심 부분입니다. 앞의 `Finder`에서 세 가지를 바꾸었습니다. 점의 측정 시각을 쓰고, 변환을 기다리고(`timeout=`, 강의에서는 0.2초), TF에 변환이 없으면 경고를 남깁니다.
# 이 노드에는 결함이 하나 있고, 실행해 보면 드러납니다.

# %% name="point-to-map"
class PointToMap(Node):
    def __init__(self, timeout):
        super().__init__("point_to_map")
        self.timeout = timeout
        self.buffer = Buffer(cache_time=Duration(seconds=20.0))
        self.listener = TransformListener(self.buffer, self)
        self.subscription = self.create_subscription(PointStamped, "detected_point", self.on_point, 10)

    def on_point(self, message):
        try:
            point = self.buffer.transform(message, "map", timeout=self.timeout).point
            self.get_logger().info(f"map point=({point.x:.2f}, {point.y:.2f}, {point.z:.2f})")
        except TransformException as error:
            self.get_logger().warning(f"no transform: {error}")

# %% [markdown] lang="en" name="point-to-map-predict" slide="subslide"
# The robot is still driving when the node starts. (`graph.start` starts it beside the robot, and `graph.run` lets time pass.)
#
# **Predict:** the first point was measured before the node began to receive transforms, so it must be rejected. What about the second one, 0.2 s later?

# %% [markdown] lang="ko" name="point-to-map-predict" slide="subslide"
# 로봇이 아직 달리고 있을 때 노드를 켭니다. (`graph.start`는 로봇 옆에서 노드를 시작하고, `graph.run`은 시간을 보냅니다.)
#
# **예측해 봅시다.** 첫 점은 노드가 구독을 시작하기 전에 측정된 것이니 거절될 수밖에 없습니다. 0.2초 뒤의 둘째 점은 지도에 찍힐까요, 거절될까요?

# %% name="with-a-timeout" tags=["predicted"] slide="fragment"
def main(timeout):
    rclpy.init()
    rclpy.spin(PointToMap(timeout))


node = graph.start(main, Duration(seconds=0.2))
graph.run(seconds=1.3)
node.stop()

# %% [markdown] lang="en" name="with-a-timeout-read" tags=["predicted"] slide="subslide"
# Every point is rejected. The first line compares the requested time with the earliest transform, each other line with the newest one. From the second line on, this gap grows.
# The robot publishes as before. It is the node that receives hardly any transforms.
#
# A node that spins on one thread does one thing at a time.
# The lookup for the first point fails, so its callback waits 0.2 s for a transform. While it waits, nothing reads `/tf`, so the wait cannot succeed.
# Then comes the next point, and its callback waits 0.2 s as well.
# Transforms queue up, and the node processes one of them between two waiting callbacks.
#
# Now without the timeout:

# %% [markdown] lang="ko" name="with-a-timeout-read" tags=["predicted"] slide="subslide"
# 모든 점이 거절되었습니다. 첫 줄은 요청 시각을 가장 이른 변환과, 나머지 줄은 최신 변환과 비교합니다. 둘째 줄부터 차이가 점점 *벌어집니다*.
# 로봇은 전과 똑같이 발행하고 있습니다. 변환을 받지 못하는 것은 노드입니다.
#
# 스레드가 하나인 노드는 한 번에 한 가지 일만 합니다.
# 첫 점의 조회가 실패하자 콜백은 0.2초 동안 변환을 기다리고, 그동안 `/tf`를 읽는 스레드가 없습니다. 그래서 아무리 기다려도 소용이 없습니다.
# 그러면 다음 점이 와서 또 0.2초를 기다립니다.
# 변환은 큐에 쌓이고, 노드는 한 번 기다릴 때마다 하나씩만 읽습니다.
#
# timeout 없이 해 봅니다.

# %% name="without-a-timeout"
node = graph.start(main, Duration())
graph.run(seconds=1.3)
node.stop()

# %% [markdown] lang="en" name="point-to-map-read" slide="subslide"
# One point is rejected. After that the ball is in its true position each time.
#
# The first point is older than all transforms that the node has received. (Its message has another text, because one edge had only one sample.) That point is lost, and this is correct.
# A mapping node once crashed for this reason at start-up, because a scan was 41 ms older than the first transform ([SteveMacenski/slam_toolbox, issue 775](https://github.com/SteveMacenski/slam_toolbox/issues/775)).
# The change that was proposed there looked up the latest transform instead. You know now which error that would have hidden.

# %% [markdown] lang="ko" name="point-to-map-read" slide="subslide"
# 한 번 거절한 뒤로는 공을 계속 제자리에 찍습니다.
#
# 첫 점은 노드가 받은 가장 이른 변환보다도 오래되었습니다. (오류 메시지가 앞의 것과 다른 까닭은, 표본이 아직 하나뿐인 연결이 있기 때문입니다.) 그 점은 버리는 것이 맞습니다.
# 어느 지도 작성 노드는 바로 이 때문에 시작하자마자 종료되었습니다. 스캔이 첫 변환보다 41 ms 오래된 것이었습니다([SteveMacenski/slam_toolbox, 이슈 775](https://github.com/SteveMacenski/slam_toolbox/issues/775)).
# 그때 제안된 수정은 최신 변환을 대신 조회하는 것이었습니다. 그랬다면 어떤 오차가 생겼을지 이제 알 수 있습니다.

# %% [markdown] lang="en" name="point-to-map-notes" slide="notes"
# Every lookup of the lecture's node is right. It works as long as no transform is ever late. After one failed lookup it receives hardly any transforms.
# With a slower detector (1 Hz) it would recover: 0.2 s of waiting in each second leaves time to receive. Ask the class why.
# Chapter 09 shows how to wait: a listener with its own thread, wait_for_transform_async, or a message filter.

# %% [markdown] lang="ko" name="point-to-map-notes" slide="notes"
# 이 노드의 조회는 모두 옳습니다. 변환이 한 번도 늦지 않는 한 잘 동작하지만, 한 번 늦으면 변환을 거의 받지 못합니다.
# 검출기가 더 느렸다면(1 Hz) 회복했을 것입니다. 1초에 0.2초만 기다리면 나머지 시간에 변환을 받을 수 있습니다. 왜 그런지 묻습니다.
# 기다리는 법은 09장에서 다룹니다. 별도의 스레드를 쓰는 수신기, wait_for_transform_async, 메시지 필터입니다.

# %% [markdown] lang="en" name="corrected-file" slide="skip"
# ### The file to take home
#
# Save this node as `tf_lab_py/point_to_map.py`. It differs from the lecture's file in three ways:
#
# - It has no `timeout=`, because in a callback of a node on one thread the wait cannot succeed. A point that arrives before its transform is dropped. Chapter 09 shows how to keep it until the transform is there.
# - It publishes each point in `map`, on `/point_in_map`, where RViz and other nodes can use it. It also rejects a point without a stamp.
# - It ends without an error. Since ROS 2 Humble, Ctrl-C shuts the context down by itself, and the lecture's last `rclpy.shutdown()` then raises `RCLError`.
#
# ```python
# # tf_lab_py/point_to_map.py
# import rclpy
# import tf2_geometry_msgs  # registers the conversion of PointStamped
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
# from tf2_ros import Buffer, TransformException, TransformListener
#
#
# class PointToMap(Node):
#     def __init__(self):
#         super().__init__('point_to_map')
#         self.buffer = Buffer(cache_time=Duration(seconds=20.0))
#         self.listener = TransformListener(self.buffer, self)
#         self.publisher = self.create_publisher(PointStamped, 'point_in_map', 10)
#         self.subscription = self.create_subscription(
#             PointStamped, 'detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         if not message.header.frame_id or Time.from_msg(message.header.stamp).nanoseconds == 0:
#             self.get_logger().warning('rejected: a point needs a frame_id and a stamp')
#             return
#         try:
#             in_map = self.buffer.transform(message, 'map')  # at the stamp of the message
#         except TransformException as error:
#             self.get_logger().warning(f'rejected: {error}')
#             return
#         self.publisher.publish(in_map)
#         point = in_map.point
#         self.get_logger().info(f'map point=({point.x:.2f}, {point.y:.2f}, {point.z:.2f})')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = PointToMap()
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

# %% [markdown] lang="ko" name="corrected-file" slide="skip"
# ### 가져갈 파일
#
# 이 노드를 `tf_lab_py/point_to_map.py`로 저장하십시오. 강의의 파일과 세 가지가 다릅니다.
#
# - `timeout=`이 없습니다. 스레드가 하나인 노드의 콜백에서는 아무리 기다려도 변환을 받지 못하기 때문입니다. 변환보다 먼저 도착한 점은 버립니다. 변환이 올 때까지 점을 보관하는 법은 09장에서 다룹니다.
# - 점마다 `map` 기준으로 바꾸어 `/point_in_map`으로 발행하므로, RViz나 다른 노드가 쓸 수 있습니다. 측정 시각이 없는 점도 거절합니다.
# - 오류 없이 끝납니다. ROS 2 Humble부터는 Ctrl-C를 누르면 rclpy가 context를 닫으므로, 강의의 마지막 줄 `rclpy.shutdown()`이 `RCLError`를 일으킵니다.
#
# ```python
# # tf_lab_py/point_to_map.py
# import rclpy
# import tf2_geometry_msgs  # registers the conversion of PointStamped
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.time import Time
# from tf2_ros import Buffer, TransformException, TransformListener
#
#
# class PointToMap(Node):
#     def __init__(self):
#         super().__init__('point_to_map')
#         self.buffer = Buffer(cache_time=Duration(seconds=20.0))
#         self.listener = TransformListener(self.buffer, self)
#         self.publisher = self.create_publisher(PointStamped, 'point_in_map', 10)
#         self.subscription = self.create_subscription(
#             PointStamped, 'detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         if not message.header.frame_id or Time.from_msg(message.header.stamp).nanoseconds == 0:
#             self.get_logger().warning('rejected: a point needs a frame_id and a stamp')
#             return
#         try:
#             in_map = self.buffer.transform(message, 'map')  # at the stamp of the message
#         except TransformException as error:
#             self.get_logger().warning(f'rejected: {error}')
#             return
#         self.publisher.publish(in_map)
#         point = in_map.point
#         self.get_logger().info(f'map point=({point.x:.2f}, {point.y:.2f}, {point.z:.2f})')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = PointToMap()
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

# %% [markdown] lang="en" name="recap" slide="slide"
# ## Recap
#
# - The buffer keeps a timeline for each edge. Between samples it interpolates; outside them it raises an exception.
# - `Time()` means the latest common time: the earliest of the edges' newest samples. Static edges do not count. It is not now.
# - Value + frame + stamp. `buffer.transform()` uses all three, and so should you.
# - A wrong time gives a wrong position: speed × delay forwards, range × yaw rate × delay sideways.
# - The stamp is the time of the measurement. If you overwrite it, the error becomes invisible.
#
# Terms of this chapter: [[buffer]], [[listener]], [[stamp]], [[interpolation]], [[latest common time]], [[extrapolation]], [[cache time]], [[latency]]. Of the sections after the core: [[motion distortion]], [[fixed frame]].
#
# Lab checklist: *looked up the newest transform with Buffer and Listener* (C8), *transformed a PointStamped at its measurement time* (C9). The exercises tick both for you.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - 버퍼에는 연결마다 시간줄이 하나씩 있습니다. 표본 사이는 보간하고, 바깥의 시각에는 예외를 일으킵니다.
# - `Time()`은 최신 공통 시각입니다. 동적 연결마다 마지막 표본의 시각이 있고, 그 가운데 가장 이른 것입니다. 현재 시각이 아닙니다.
# - 값 + 좌표계 + 측정 시각. `buffer.transform()`은 셋을 모두 씁니다. 여러분도 그래야 합니다.
# - 요청 시각이 틀리면 위치가 틀립니다. 앞뒤로 속도 × 지연, 좌우로 거리 × yaw 각속도 × 지연.
# - `header.stamp`는 측정한 시각입니다. 덮어쓰면 오차가 드러나지 않습니다.
#
# 이 장의 용어: [[buffer|버퍼]], [[listener|수신기]], [[stamp|측정 시각]], [[interpolation|보간]], [[latest common time|최신 공통 시각]], [[extrapolation|외삽]], [[cache time|보관 시간]], [[latency|지연(latency)]]. 핵심 부분 다음의 절에 나오는 용어: [[motion distortion|움직임 왜곡]], [[fixed frame|고정 좌표계]].
#
# 실습 체크리스트: *버퍼와 수신기로 최신 변환을 조회했습니다*(C8), *PointStamped를 측정 시각의 변환으로 바꾸었습니다*(C9). 연습 문제를 풀면 둘 다 표시됩니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# Finish this sentence without looking: *"I look the transform up at …, because …; and if there is none yet, I …"*
#
# <details><summary>One good ending</summary>
#
# "… at the message's own stamp, because the sensor was there at that time; and if there is none yet, I wait a bounded time, and then drop the message."
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# 보지 않고 문장을 완성해 보세요. *“나는 변환을 …로 조회한다. 왜냐하면 … 때문이다. 아직 없다면 나는 …”*
#
# <details><summary>좋은 답의 한 예</summary>
#
# “나는 변환을 메시지 자신의 측정 시각으로 조회한다. 왜냐하면 그때 센서가 그 자리에 있었기 때문이다. 아직 없다면 나는 정해 둔 시간만큼만 기다리고, 그다음에는 그 메시지를 버린다.”
#
# </details>

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now transform a measurement at its own stamp, and estimate the error of a program that uses another time.
#
# Do the exercises next, [E8 Buffer and measurement time](../../exercises/en/E08_buffer_and_measurement_time.ipynb). Three of them need a section below: E8.5 "Is your robot's data old?" and "A forgotten import", E8.6 "How long must the buffer remember?", E8.7 "Two times in one lookup".
# Then go on to [09 Exceptions and waiting](09_exceptions_and_waiting.ipynb).
#
# The other sections are optional: more experiments with time, the lecture's file, and questions for practice.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 메시지를 그 측정 시각의 변환으로 바꿀 수 있고, 다른 시각을 쓰는 프로그램이 얼마나 빗나가는지 어림할 수 있습니다.
#
# 다음은 연습 문제 [E8 버퍼와 측정 시각](../../exercises/ko/E08_buffer_and_measurement_time.ipynb)입니다. 세 과제에는 아래의 절이 필요합니다. E8.5는 ‘여러분 로봇의 데이터는 얼마나 오래되었을까요?’와 ‘빠뜨린 import’, E8.6은 ‘버퍼는 얼마나 오래 기억해야 할까요?’, E8.7은 ‘두 시각을 한 번에’입니다.
# 그다음 [09 예외와 기다림](09_exceptions_and_waiting.ipynb)으로 갑니다.
#
# 나머지 절은 더 알고 싶은 사람을 위한 것입니다. 시각을 바꾸어 보는 실험, 강의의 파일, 복습 문제가 있습니다.

# %% [markdown] lang="en" name="try-it-heading" slide="slide"
# ## Try it: other times, and a drive without curves

# %% [markdown] lang="ko" name="try-it-heading" slide="slide"
# ## 직접 해 보세요: 다른 시각, 그리고 회전 없는 주행

# %% [markdown] lang="en" name="try-it" slide="-"
# - In the cell with the two blanks, set `moment = Time()` and run it again. By how much does the ball move? Then try messages 25 and 38. (By now the latest common time is 13.1 s, so `Time()` returns that pose for every message. The older the message, the larger the error.)
# - Look up 100 ms before the stamp. Is that better or worse than 100 ms after it?
# - In the folded cell that starts the robot, set every yaw rate (the third number of a `Leg`) to 0, choose *Restart Kernel and Run All*, and count the balls again. What remains is the small component, speed × delay.
#
# <details><summary>What I found</summary>
#
# - 2.0 m for message 20, 1.9 m for 25, 0.5 m for 38. They were measured at different times, and now all of them are transformed with one pose. During the drive, in `on_point`, the newest pose was never more than 0.2 s newer than the detection.
# - 100 ms too early is as bad as 100 ms too late, in the other direction: the error has the sign of the delay.
# - Without rotation there is one ball, stretched a little along the robot's path.
#
# </details>

# %% [markdown] lang="ko" name="try-it" slide="-"
# - 빈칸이 두 개 있던 셀의 `moment`를 `Time()`으로 바꾸어 실행해 보세요. 공이 얼마나 움직일까요? 메시지 25번과 38번으로도 해 보세요. (지금 `Time()`은 어느 메시지를 쓰든 13.1초의 변환입니다. 그래서 오래된 메시지일수록 더 빗나갑니다.)
# - 측정 시각보다 100 ms 이전의 변환을 조회해 보세요. 100 ms 이후의 변환보다 나을까요, 나쁠까요?
# - 로봇을 출발시킨 셀(접혀 있습니다)로 올라가 `Leg`의 셋째 수인 각속도를 모두 0으로 바꾸고 *Restart Kernel and Run All*을 고른 뒤 공을 다시 세어 보세요. 작은 성분인 속도 × 지연만 남습니다.
#
# <details><summary>찾은 것 확인하기</summary>
#
# - 20번은 2.0 m, 25번은 1.9 m, 38번은 0.5 m 빗나갑니다. 저마다 다른 때 본 것을 모두 하나의 포즈로 바꾸었기 때문입니다. `on_point`에서 바로 조회했을 때는 최신 포즈의 시각이 관측보다 최대 0.2초 이후였습니다.
# - 100 ms 이전의 변환은 100 ms 이후의 변환만큼 나쁘고, 방향만 반대입니다. 오차의 부호는 지연의 부호를 따릅니다.
# - 회전이 없으면 점들은 한 무리가 되고, 나아간 방향으로 길게 퍼집니다.
#
# </details>

# %% [markdown] lang="en" name="shortest-arc-ask-heading" slide="slide"
# ## Between 170° and −170°: the shortest arc

# %% [markdown] lang="ko" name="shortest-arc-ask-heading" slide="slide"
# ## 170°와 −170° 사이: 가장 짧은 호

# %% [markdown] lang="en" name="shortest-arc-ask" slide="-"
# **Predict.** At 1.0 s the yaw is 170°, at 2.0 s it is −170°. What is it at 1.5 s: 0° or 180°?

# %% [markdown] lang="ko" name="shortest-arc-ask" slide="-"
# **예측해 봅시다.** 1.0초에 yaw가 170°, 2.0초에 −170°입니다. 1.5초에는 0°일까요, 180°일까요?

# %% name="shortest-arc" tags=["predicted"] slide="fragment"
turn = BufferCore()
for stamp_s, yaw_deg in ((1.0, 170.0), (2.0, -170.0)):
    pose = Transform.from_rpy(yaw=math.radians(yaw_deg))
    turn.set_transform(StampedTransform("odom", "base_link", seconds(stamp_s), pose))
for stamp_s in (1.0, 1.25, 1.5, 1.75, 2.0):
    yaw = turn.lookup_transform("odom", "base_link", seconds(stamp_s)).transform.rpy()[2]
    print(f"{stamp_s:.2f} s: yaw {math.degrees(yaw):7.2f} degrees")

# %% [markdown] lang="en" name="shortest-arc-read" tags=["predicted"]
# 180°. The robot rotated by 20°, through ±180°, as any robot would.
# If you average the two angles you get 0°, and the robot appears to face in the opposite direction.
# Many programs contain this bug. In E8.2 you write the interpolation yourself.

# %% [markdown] lang="ko" name="shortest-arc-read" tags=["predicted"]
# 180°입니다. 뒤쪽을 지나 20°만 회전했습니다.
# 두 숫자를 평균하면 0°가 되고, 로봇이 한순간 반대쪽을 봅니다.
# 어느 프로그래밍 언어에서나 흔한 버그입니다. 연습 문제 E8.2에서 이 보간을 직접 구현합니다.

# %% [markdown] lang="en" name="walls-twice-heading" slide="slide"
# ## Walls drawn twice: an overwritten stamp on a laser

# %% [markdown] lang="ko" name="walls-twice-heading" slide="slide"
# ## 두 번 그린 벽: 레이저의 측정 시각을 덮어쓰면

# %% [markdown] lang="en" name="walls-twice" slide="-"
# A filter holds each scan for 0.3 s. The walls are drawn twice, from the same scans. Only the time of the lookup differs:
#
# ```python
# buffer.lookup_transform("map", "laser_frame", Time.from_msg(scan.header.stamp))  # left: the laser's stamp
# buffer.lookup_transform("map", "laser_frame", node.get_clock().now())  # right: a fresh stamp on arrival
# ```

# %% [markdown] lang="ko" name="walls-twice" slide="-"
# 필터를 거치는 데 0.3초가 걸립니다. 같은 스캔으로 벽을 두 번 그려 봅니다. 조회하는 시각만 다릅니다.
#
# ```python
# buffer.lookup_transform("map", "laser_frame", Time.from_msg(scan.header.stamp))  # left: the laser's stamp
# buffer.lookup_transform("map", "laser_frame", node.get_clock().now())  # right: a fresh stamp on arrival
# ```
#
# *그림 읽기:* the laser's stamp = 레이저의 측정 시각(왼쪽), a fresh stamp on arrival = 도착할 때 새로 적은 시각(오른쪽).

# %% name="scans" tags=["collapsed"]
# Record scans that a filter holds for 0.3 s.
filtered = {"laser": lesson.Source("laser_driver", 10.0, 0.3, 0.004)}  # 10 Hz, 0.3 s late
held = lesson.TeachingRobot(plan, bias=0.0, slip=0.0005, sources=filtered)
poses = held.buffer(until_s=14.0, cache_time_s=30.0)
scans = [heard for heard in held.readings(until_s=13.0) if heard.topic == "/scan"][2:58:4]


def placed(stamp_of):
    walls = []
    for heard in scans:
        map_T_laser = poses.lookup_transform("map", "laser_frame", stamp_of(heard)).transform
        walls.append(map_T_laser.apply(heard.value.points()))
    return np.vstack(walls)

# %% name="smear" tags=["collapsed"] slide="subslide"
# Draw the walls with both stamps.
at_stamp = placed(lambda heard: heard.value.stamp_ns)
ways = {
    "the laser's stamp": at_stamp,
    "a fresh stamp on arrival": placed(lambda heard: heard.receive_ns),
}
lesson.draw_placed(ways, walls=lesson.ROOM.walls)

# %% [markdown] lang="en" name="smear-read" slide="subslide"
# RViz users call such walls "smeared", and look for a broken laser.
# Distant walls are off the most: that is range × yaw rate × delay again.
#
# The left figure is not perfect either: its points are off by 4 cm on average, and by 27 cm at worst.
# A sweep takes 0.1 s, and the header's stamp is that of its *first* ray. The last ray is 0.1 s newer.
# That is [[motion distortion]], and you know the fix by now: look up each ray at its own time.

# %% [markdown] lang="ko" name="smear-read" slide="subslide"
# RViz에서 흔히 “스캔이 벽에 번진다”고 하는 증상입니다. 그래서 레이저가 고장 났는지부터 의심하기 쉽습니다.
# 먼 벽일수록 크게 어긋납니다. 이번에도 거리 × yaw 각속도 × 지연입니다.
#
# 왼쪽 그림도 완벽하지는 않습니다. 평균 4 cm, 최대 27 cm 어긋납니다.
# 레이저가 한 번 훑는 데 0.1초가 걸리고, 헤더의 측정 시각은 *첫* 광선의 시각입니다. 마지막 광선은 그 0.1초 뒤에 측정했습니다.
# 이것이 [[motion distortion|움직임 왜곡(motion distortion)]]이고, 해결책은 이미 압니다. 광선마다 자기 측정 시각의 변환을 쓰면 됩니다. *그림 읽기:* one stamp a scan = 스캔마다 시각 하나, one stamp a ray = 광선마다 시각 하나.

# %% name="ray-by-ray" tags=["collapsed"]
# Draw the walls with one stamp a scan, and one a ray.
rays = []
for heard in scans:
    for ray_stamp_ns, point in zip(heard.value.ray_stamps_ns, heard.value.points(), strict=True):
        map_T_laser = poses.lookup_transform("map", "laser_frame", int(ray_stamp_ns)).transform
        rays.append(map_T_laser.apply(np.array([point])))
lesson.draw_placed({"one stamp a scan": at_stamp, "one stamp a ray": np.vstack(rays)}, walls=lesson.ROOM.walls)

# %% [markdown] lang="en" name="ray-by-ray-notes" slide="notes"
# This slide is for the engineers in the class. In C++, laser_geometry corrects this if you pass it a TF buffer. It interpolates between the poses of the first and the last ray.
# In a sweep of 0.1 s a robot at 0.5 rad/s rotates by 0.05 rad from the first ray to the last: 25 cm at 5 m.
# Then go back: most of the smear in practice comes from stamps, and costs nothing to fix.

# %% [markdown] lang="ko" name="ray-by-ray-notes" slide="notes"
# 현업 엔지니어를 위한 슬라이드입니다. C++의 laser_geometry도 TF 버퍼를 주면 이 왜곡을 보정합니다. 첫 광선과 마지막 광선의 포즈를 조회하고 그 사이를 보간합니다.
# 10 Hz로 훑는 레이저와 0.5 rad/s로 회전하는 로봇이면, 한 번 훑는 사이에 0.05 rad 회전하고 5 m 앞에서 25 cm가 된다고 말해 줍니다.
# 그리고 다시 정리합니다. 실제 번짐의 대부분은 측정 시각이 원인이고, 고치는 데 비용이 들지 않습니다.

# %% [markdown] lang="en" name="break-slow-heading" slide="slide"
# ## Odometry once a second: which detections can be transformed?

# %% [markdown] lang="ko" name="break-slow-heading" slide="slide"
# ## 초당 한 번뿐인 오도메트리: 몇 개나 변환될까요?

# %% [markdown] lang="en" name="break-slow" slide="-"
# The odometry is now published at 1 Hz instead of 20. The camera still detects the ball five times a second, and each detection arrives 0.2 s after its stamp. On arrival, the node makes one call:
#
# ```python
# buffer.lookup_transform("map", message.header.frame_id, Time.from_msg(message.header.stamp))
# ```
#
# **Predict:** of about forty such calls, how many return a transform?

# %% [markdown] lang="ko" name="break-slow" slide="-"
# 이제 바퀴 오도메트리가 20 Hz가 아니라 1 Hz로 옵니다. 카메라는 여전히 1초에 다섯 번 공을 보고, 관측은 측정한 지 0.2초 뒤에 도착합니다. 도착하면 노드는 이렇게 조회합니다.
#
# ```python
# buffer.lookup_transform("map", message.header.frame_id, Time.from_msg(message.header.stamp))
# ```
#
# **예측해 봅시다.** 관측은 마흔 개쯤입니다. 이 조회가 몇 번이나 성공할까요?

# %% name="slow-odometry" tags=["predicted", "collapsed"] slide="fragment"
# Look each detection up when it arrives.
slow_wheels = {"odometry": lesson.Source("wheel_odometry", 1.0, 0.004, 0.002)}  # 1 Hz
slow = lesson.TeachingRobot(plan, bias=0.0, slip=0.0005, sources=slow_wheels)
answered, refusals = 0, []
for heard in slow.readings(until_s=13.0):
    if heard.topic == "/detected_point":
        known_by_then = slow.buffer(until_s=heard.receive_ns / 1e9, cache_time_s=20.0)
        try:
            known_by_then.lookup_transform("map", heard.value.frame_id, heard.value.stamp_ns)
            answered += 1
        except TransformException as refusal:
            refusals.append(str(refusal))
print(answered, "answered,", len(refusals), "rejected")
print(refusals[0])

# %% [markdown] lang="en" name="slow-odometry-read" tags=["predicted"] slide="subslide"
# One in three.
# A detection can be transformed only if *each* timeline has a sample at or after its stamp. For most of each second the newest odometry is older.
#
# There are three solutions, in this order: publish the odometry faster; let the message wait until the timeline has caught up (chapter 09); or drop it.
# `Time()` is not among them. It always answers, with a pose that is up to a second old.

# %% [markdown] lang="ko" name="slow-odometry-read" tags=["predicted"] slide="subslide"
# 3분의 1뿐입니다.
# 관측의 측정 시각을 조회하려면 *모든* 시간줄에 측정 시각 이후의 표본이 하나는 있어야 합니다. 그런데 대개는 최신 오도메트리도 아직 그 시각에 이르지 못했습니다.
#
# 방법은 셋이며, 이 순서로 시도합니다. 오도메트리를 더 자주 발행합니다. 필요한 표본이 올 때까지 메시지를 기다리게 합니다(09장). 아니면 버립니다.
# `Time()`은 여기에 없습니다. 언제나 값이 나오지만, 최대 1초 전의 포즈입니다.

# %% [markdown] lang="en" name="break-type-heading" slide="slide"
# ## A forgotten import: an exception that slips through

# %% [markdown] lang="ko" name="break-type-heading" slide="slide"
# ## 빠뜨린 import: 잡히지 않는 예외

# %% [markdown] lang="en" name="break-type" slide="-"
# Where does `transform()` find the conversion of a `PointStamped`?
# Importing `tf2_geometry_msgs` registers the conversion. The import looks unused, so one day a tidy colleague deletes it.
#
# This page imported the conversions for points but not those for point clouds, `tf2_sensor_msgs`:

# %% [markdown] lang="ko" name="break-type" slide="-"
# `transform()`은 `PointStamped`의 변환 방법을 어디에서 얻을까요?
# `tf2_geometry_msgs`를 import할 때 등록됩니다. 쓰이지 않는 import처럼 보이므로, 정리하다가 지우기 쉽습니다.
#
# 이 페이지에서는 점을 다루는 패키지만 import했고, 포인트 클라우드를 다루는 `tf2_sensor_msgs`는 import하지 않았습니다.

# %% name="forgotten-import" tags=["raises-exception"]
from sensor_msgs.msg import PointCloud2

try:
    finder.buffer.transform(PointCloud2(), "map")
except TransformException as error:
    print("handled:", error)

# %% [markdown] lang="en" name="forgotten-import-read"
# `except TransformException` did not catch it, because `TypeException` is **not** a `TransformException`.
# TF is not the cause. No transform was looked up, because the conversion of this type is not registered.
# Fix: `import tf2_geometry_msgs` for points, poses and vectors; `import tf2_sensor_msgs` for clouds. Give the reason in a comment beside it.

# %% [markdown] lang="ko" name="forgotten-import-read"
# 예외가 `except TransformException`에 잡히지 않았습니다. `TypeException`은 `TransformException`이 **아니기** 때문입니다.
# TF의 문제가 아닙니다. 이 자료형의 변환 방법이 등록되지 않아서 조회조차 하지 않았습니다.
# 고치는 법: 점, 포즈, 벡터에는 `import tf2_geometry_msgs`, 포인트 클라우드에는 `import tf2_sensor_msgs`. 왜 필요한지 주석을 옆에 달아 두십시오.

# %% [markdown] lang="en" name="forgotten-import-notes" slide="notes"
# Ask who has a linter that deletes unused imports. This import has to stay, and the comment beside it protects it.

# %% [markdown] lang="ko" name="forgotten-import-notes" slide="notes"
# 쓰지 않는 import를 지우는 린터를 쓰는 사람이 있는지 묻습니다. 이 import는 남아야 하고, 옆에 주석을 달아 두면 지워지지 않습니다.

# %% [markdown] lang="en" name="break-years-heading" slide="slide"
# ## Fifty years: two clocks on one robot

# %% [markdown] lang="ko" name="break-years-heading" slide="slide"
# ## 오십 년: 시계가 둘인 로봇

# %% [markdown] lang="en" name="break-years" slide="-"
# Now the story from the beginning, with its own numbers: TF in simulation time, and a node in system time (wall time):

# %% [markdown] lang="ko" name="break-years" slide="-"
# 처음의 이야기를 그때의 숫자 그대로 재현합니다. TF는 시뮬레이션의 시계를, 노드는 시스템 시간(wall time)을 따릅니다.

# %% name="fifty-years" tags=["raises-exception"]
simulation = BufferCore()
for stamp_s in (3.185, 3.235):
    simulation.set_transform(StampedTransform("map", "base_link", seconds(stamp_s), Transform()))
simulation.lookup_transform("map", "base_link", seconds(1574652168.59))

# %% [markdown] lang="en" name="fifty-years-read"
# A slow network never explains two times this far apart. They come from two clocks: set `use_sim_time` on every node, or on none (chapter 10).

# %% [markdown] lang="ko" name="fifty-years-read"
# 두 숫자가 이렇게 멀면 네트워크 지연이 원인일 수 없습니다. 시계가 둘입니다. `use_sim_time`을 모든 노드에 켜거나 모두 끄십시오(10장).

# %% [markdown] lang="en" name="how-long-heading" slide="slide"
# ## How long must the buffer remember?

# %% [markdown] lang="ko" name="how-long-heading" slide="slide"
# ## 버퍼는 얼마나 오래 기억해야 할까요?

# %% [markdown] lang="en" name="how-long" slide="-"
# A buffer forgets. Each timeline keeps its samples for the [[cache time]], ten seconds by default, counted back from its newest one.
# If your computation takes longer than that, the sample is gone:

# %% [markdown] lang="ko" name="how-long" slide="-"
# 버퍼는 오래된 것을 지웁니다. 시간줄마다 최신 표본에서 거꾸로 세어 [[cache time|보관 시간(cache time)]]만큼만 보관합니다. 따로 정하지 않으면 10초입니다.
# 계산이 그보다 오래 걸리면, 필요한 표본은 이미 지워지고 없습니다.

# %% name="short-memory" tags=["raises-exception"]
forgetful = robot.buffer(until_s=13.0, cache_time_s=1.0)
forgetful.lookup_transform("map", "camera_optical_frame", seconds(11.0))

# %% [markdown] lang="en" name="short-memory-read"
# A detection is used one *delay* after its stamp. To interpolate at the stamp, the timeline must still hold the sample *before* the stamp, which can be a whole period older.
# So, for the slowest timeline of the path:
#
# > cache time ≥ delay + one period
#
# A detector that needs 2 s, on a path with an edge of 4 Hz: 2.25 s. Choose more; memory is cheap.

# %% [markdown] lang="ko" name="short-memory-read"
# 관측을 쓸 때 그 측정 시각은 *지연*만큼 과거에 있습니다. 측정 시각에서 보간하려면 *바로 이전*의 표본이 시간줄에 남아 있어야 하고, 그 표본은 한 주기만큼 더 오래된 것일 수 있습니다.
# 따라서 경로에서 발행률이 가장 낮은 연결에 대해 다음이 성립해야 합니다.
#
# > 보관 시간 ≥ 지연 + 한 주기
#
# 2초 걸리는 검출기와 4 Hz 연결이 있는 경로라면 2.25초입니다. 넉넉히 잡으십시오. 메모리는 비싸지 않습니다.

# %% [markdown] lang="en" name="two-moments-heading" slide="slide"
# ## Two times in one lookup: `lookup_transform_full`

# %% [markdown] lang="ko" name="two-moments-heading" slide="slide"
# ## 두 시각을 한 번에: `lookup_transform_full`

# %% [markdown] lang="en" name="two-moments" slide="-"
# A ball was detected at 7.4 s. A planner computes with that detection for one second. Now, at 8.4 s, it has to steer.
# So it needs the ball of *then* in the base_link of *now*.
#
# One stamp is not enough for that. You need a frame that does not move between the two times: the [[fixed frame]], here `odom`.
# `lookup_transform_full` follows the path from the camera at the **first** time up to `odom`, and down to `base_link` at the **second** time.
# Its arguments are two frames, each followed by its own time, and the fixed frame.

# %% [markdown] lang="ko" name="two-moments" slide="-"
# 경로 계획기가 7.4초에 본 공을 두고 1초 동안 계산합니다. 이제 8.4초이고, 조향하려고 합니다.
# 따라서 *그때*의 공을 *지금*의 base_link 기준으로 알아야 합니다.
#
# 시각 하나로는 이런 조회를 할 수 없습니다. 두 시각 사이에 가만히 있다고 보는 [[fixed frame|고정 좌표계(fixed frame)]]가 둘을 연결합니다. 여기서는 `odom`입니다.
# `lookup_transform_full`은 변환 하나를 반환합니다. **그때**의 카메라 기준 점을 `odom` 기준으로 바꾸고, 다시 1초 뒤인 **지금**의 base_link 기준으로 바꾸는 변환입니다.
# 인자는 좌표계 두 개(각각 시각이 하나씩 따라옵니다)와 고정 좌표계 하나입니다.

# %% name="six-arguments"
message = finder.messages[12]
stamp = Time.from_msg(message.header.stamp)
now = stamp + Duration(seconds=1.0)
now_T_then = finder.buffer.lookup_transform_full("base_link", now, message.header.frame_id, stamp, "odom")
old = finder.buffer.transform(message, "base_link").point
fresh = do_transform_point(message, now_T_then).point
truth = robot.truth_at(now.nanoseconds)["base_link"].inverse().apply(lesson.BALL)
print(f"base_link then: ({old.x:.2f}, {old.y:.2f})   base_link now: ({fresh.x:.2f}, {fresh.y:.2f})")
print(f"the truth now:  ({truth[0]:.2f}, {truth[1]:.2f})")

# %% name="picture-of-two-moments" tags=["collapsed"] slide="subslide"
# Draw the ball as seen from both poses.
ball = finder.buffer.transform(message, "odom").point
moments = {f"base_link, {moment.nanoseconds / 1e9:.1f} s": moment for moment in (stamp, now)}
poses_then = {
    name: finder.buffer.core.lookup_transform("odom", "base_link", moment.nanoseconds).transform
    for name, moment in moments.items()
}
lesson.draw_moments(poses_then, (ball.x, ball.y, ball.z), "ball")

# %% [markdown] lang="en" name="two-moments-read"
# A second ago the ball was 1.6 m to the **right**. Now it is 0.7 m to the **left**.
# The old coordinates were correct for the old pose. If the planner had used them, it would have turned the robot away from the ball.
#
# Why `odom` and not `map`? The ball is at rest in both. But if the localisation corrects the pose in between, the robot's pose in `map` jumps, and the result jumps with it (chapter 05).

# %% [markdown] lang="ko" name="two-moments-read"
# *그림 읽기:* ball = 공, ahead = 앞, to the right = 오른쪽, to the left = 왼쪽, grid of 1 m = 눈금 한 칸이 1미터.
#
# 1초 전에 공은 **오른쪽** 1.6 m에 있었습니다. 지금은 **왼쪽** 0.7 m에 있습니다.
# 1초 전의 값은 1초 전에는 옳았습니다. 그대로 조향했다면 로봇은 공의 반대쪽으로 회전했을 것입니다.
#
# 왜 `map`이 아니라 `odom`일까요? 공은 둘 다에서 가만히 있습니다. 하지만 그사이 위치 추정이 보정하면 `map` 기준 로봇의 포즈가 튀고, 그만큼 base_link 기준 공의 위치도 튑니다(05장).

# %% [markdown] lang="en" name="two-moments-notes" slide="notes"
# Walk it: one student is the ball, you are the robot. Say where the ball is, close your eyes, take three steps and turn, and point to where you said it was.
# The floor did not move. That is what odom is for.

# %% [markdown] lang="ko" name="two-moments-notes" slide="notes"
# 직접 걸어 보입니다. 학생 한 명이 공이고 강사가 로봇입니다. 공의 위치를 말하고 눈을 감은 채 세 발 걷고 방향을 바꾼 다음, 처음에 말한 곳을 가리킵니다.
# 바닥은 움직이지 않았습니다. odom이 하는 일이 바로 그것입니다.

# %% [markdown] lang="en" name="lecture-file-heading" slide="skip"
# ## The lecture's file, as it is (§17, §18)

# %% [markdown] lang="ko" name="lecture-file-heading" slide="skip"
# ## 강의의 파일 그대로(§17, §18)

# %% [markdown] lang="en" name="lecture-file" slide="skip"
# Compare it with the file to take home. It waits inside its callback, and it ends with `rclpy.shutdown()`.

# %% [markdown] lang="ko" name="lecture-file" slide="skip"
# 가져갈 파일과 비교해 보세요. 이 파일은 콜백 안에서 기다리고, `rclpy.shutdown()`으로 끝납니다.

# %% [markdown] lang="en" name="the-file" slide="skip"
# ```python
# import rclpy
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.node import Node
# from tf2_ros import Buffer, TransformListener, TransformException
# import tf2_geometry_msgs  # registers the geometry messages
#
#
# class PointToMap(Node):
#     def __init__(self):
#         super().__init__('point_to_map')
#         self.buffer = Buffer(cache_time=Duration(seconds=20.0))
#         self.listener = TransformListener(self.buffer, self)
#         self.subscription = self.create_subscription(
#             PointStamped, 'detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         if not message.header.frame_id:
#             self.get_logger().warning('refused: a point without a frame_id')
#             return
#         try:
#             transformed = self.buffer.transform(
#                 message,
#                 'map',
#                 timeout=Duration(seconds=0.2),
#             )
#             self.get_logger().info(
#                 f'map point=({transformed.point.x:.2f}, '
#                 f'{transformed.point.y:.2f}, '
#                 f'{transformed.point.z:.2f})')
#         except TransformException as error:
#             self.get_logger().warning(f'no transform: {error}')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = PointToMap()
#     try:
#         rclpy.spin(node)
#     except KeyboardInterrupt:
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.shutdown()
#
#
# if __name__ == '__main__':
#     main()
# ```

# %% [markdown] lang="ko" name="the-file" slide="skip"
# ```python
# import rclpy
# from geometry_msgs.msg import PointStamped
# from rclpy.duration import Duration
# from rclpy.node import Node
# from tf2_ros import Buffer, TransformListener, TransformException
# import tf2_geometry_msgs  # Geometry Message 변환 등록
#
#
# class PointToMap(Node):
#     def __init__(self):
#         super().__init__('point_to_map')
#         self.buffer = Buffer(cache_time=Duration(seconds=20.0))
#         self.listener = TransformListener(self.buffer, self)
#         self.subscription = self.create_subscription(
#             PointStamped, 'detected_point', self.on_point, 10)
#
#     def on_point(self, message):
#         if not message.header.frame_id:
#             self.get_logger().warning('frame_id가 없는 Point 거절')
#             return
#         try:
#             transformed = self.buffer.transform(
#                 message,
#                 'map',
#                 timeout=Duration(seconds=0.2),
#             )
#             self.get_logger().info(
#                 f'map point=({transformed.point.x:.2f}, '
#                 f'{transformed.point.y:.2f}, '
#                 f'{transformed.point.z:.2f})')
#         except TransformException as error:
#             self.get_logger().warning(f'TF 변환 실패: {error}')
#
#
# def main(args=None):
#     rclpy.init(args=args)
#     node = PointToMap()
#     try:
#         rclpy.spin(node)
#     except KeyboardInterrupt:
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.shutdown()
#
#
# if __name__ == '__main__':
#     main()
# ```

# %% [markdown] lang="en" name="robot-care" slide="skip"
# If you need the transform itself, look it up by hand, as the lecture does in §17. This call has a `timeout`, too, so do not use it in a callback of a node that spins on one thread:
#
# ```python
# measurement_time = Time.from_msg(message.header.stamp)
#
# transform = self.tf_buffer.lookup_transform(
#     'map',
#     message.header.frame_id,
#     measurement_time,
#     timeout=Duration(seconds=0.2),
# )
# ```

# %% [markdown] lang="ko" name="robot-care" slide="skip"
# 변환 자체가 필요할 때는 강의의 §17처럼 직접 조회합니다. 여기에도 `timeout`이 있으므로, 스레드가 하나인 노드의 콜백에서는 쓰지 않습니다.
#
# ```python
# measurement_time = Time.from_msg(message.header.stamp)
#
# transform = self.tf_buffer.lookup_transform(
#     'map',
#     message.header.frame_id,
#     measurement_time,
#     timeout=Duration(seconds=0.2),
# )
# ```

# %% [markdown] lang="en" name="topic-delay-why-heading" slide="slide"
# ## Is your robot's data old? Symptoms and first looks

# %% [markdown] lang="ko" name="topic-delay-why-heading" slide="slide"
# ## 여러분 로봇의 데이터는 얼마나 오래되었을까요? 증상과 첫 확인

# %% [markdown] lang="en" name="topic-delay-why" slide="-"
# `ros2 topic delay` prints arrival minus stamp:

# %% [markdown] lang="ko" name="topic-delay-why" slide="-"
# `ros2 topic delay`는 도착 시각에서 측정 시각을 뺀 값을 출력합니다.

# %% name="topic-delay"
# %ros2 --for 2 topic delay /detected_point

# %% [markdown] lang="en" name="topic-delay-read"
# 0.200 s is the detector's computing time. You can see it because its stamp is correct.
# With an overwritten stamp the command would print 0.000 s.
#
# | symptom | likely cause | first look |
# |---|---|---|
# | scan smeared along walls while turning | stamp overwritten, or late odometry | `ros2 topic delay`, then `tf2_monitor` |
# | smeared, and the delay reads 0.000 s | stamp overwritten on the way | which node republishes the topic? |
# | "extrapolation into the future" by some ms | transform still on its way | wait a little (09) |
# | "extrapolation into the past" | long computation, or a short cache | age of the data, `cache_time` |
# | off by the same amount, standing or moving | static mount is wrong | `tf2_echo base_link laser_frame` |

# %% [markdown] lang="ko" name="topic-delay-read"
# 0.200초입니다. 측정 시각이 맞게 적혀 있으므로 검출기의 계산 시간이 그대로 나타납니다.
# 누군가 측정 시각을 덮어썼다면 0.000초로, 지연이 전혀 없는 것처럼 보였을 것입니다.
#
# | 증상 | 가능성이 큰 원인 | 첫 확인 |
# |---|---|---|
# | 회전할 때 스캔이 벽에 번짐 | 측정 시각 덮어쓰기, 또는 지연된 오도메트리 | `ros2 topic delay`, 다음에 `tf2_monitor` |
# | 번지는데 delay는 0.000초 | 도중에 측정 시각을 덮어씀 | 그 토픽을 다시 발행하는 노드 |
# | 몇 ms짜리 "extrapolation into the future" | 변환이 아직 오는 중 | 조금 기다림(09장) |
# | "extrapolation into the past" | 긴 계산, 또는 짧은 보관 시간 | 데이터의 나이, `cache_time` |
# | 서 있으나 움직이나 똑같이 어긋남 | 정적 장착 변환의 오류 | `tf2_echo base_link laser_frame` |

# %% [markdown] lang="en" name="from-before-heading" slide="slide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="slide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# <details><summary>01. A message contains (2.0, 0.0, 0.0). Which two things must you know before you use it?</summary>
#
# Its frame and its stamp.
#
# </details>
#
# <details><summary>03. You have a point in <code>camera_optical_frame</code> and want it in <code>base_link</code>. Which arguments, in which order?</summary>
#
# `lookup_transform("base_link", "camera_optical_frame", stamp)`: target first, then source. "Data expressed in camera_optical_frame, wanted in base_link."
#
# </details>
#
# <details><summary>06. Why does a camera's mount not limit the latest common time?</summary>
#
# It is static: sent once on `/tf_static`, and valid at all times.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# <details><summary>01. 메시지에 (2.0, 0.0, 0.0)이 있습니다. 쓰기 전에 알아야 할 두 가지는 무엇입니까?</summary>
#
# 좌표계와 측정 시각입니다. 어느 좌표계의 x 방향으로 2 m인지, 그리고 언제 측정했는지입니다.
#
# </details>
#
# <details><summary>03. <code>camera_optical_frame</code>의 점을 <code>base_link</code> 기준으로 보고 싶습니다. 인자를 어떤 순서로 씁니까?</summary>
#
# `lookup_transform("base_link", "camera_optical_frame", stamp)`입니다. 목표가 먼저, 원본이 다음입니다. “camera_optical_frame 기준 데이터를 base_link 기준으로 보고 싶다.”
#
# </details>
#
# <details><summary>06. 카메라의 장착 변환은 왜 최신 공통 시각을 정할 때 세지 않습니까?</summary>
#
# 정적 연결이기 때문입니다. `/tf_static`으로 한 번 보내면 어느 시각에나 유효합니다. 끝이 없는 시간줄이 먼저 끝날 수는 없습니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="slide"
# ## Practice question · Q10: why at the measurement stamp?

# %% [markdown] lang="ko" name="practice-heading" slide="slide"
# ## 서술형 문제 · Q10: 왜 측정 시각입니까?

# %% [markdown] lang="en" name="practice" slide="-"
# **Q10.** Why must a sensor message be transformed at its measurement stamp, and not with the newest transform? Write five lines, then open the rubric and mark yourself.
#
# <details><summary>Rubric: one point for each idea in your text</summary>
#
# 1. The message contains what the sensor measured at its stamp. Processing and the network make it older before it is used.
# 2. Meanwhile the robot moves, so the newest pose is not the pose of the sensor at the measurement.
# 3. The error has a size: about speed × delay, and range × yaw rate × delay when the robot turns.
# 4. No exception warns you: there is always a newest transform. Walls are smeared, and obstacles leave a trail.
# 5. The buffer keeps the past for this purpose: look up at `header.stamp`, or use `transform()`; do not overwrite the stamp.
#
# 4 or 5: you have it. 2 or 3: read "How far off, with a pencil" again. Less: play with the sliders first.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# **Q10.** 센서 메시지를 최신 변환이 아니라 측정 시각의 변환으로 바꾸어야 하는 이유는 무엇입니까? 다섯 줄로 쓴 뒤 채점 기준을 펼쳐 스스로 채점해 보세요.
#
# <details><summary>채점 기준: 아래 내용이 하나 들어 있을 때마다 1점</summary>
#
# 1. 메시지는 측정 시각에 센서가 본 것이며, 처리와 네트워크를 거쳐 쓰일 때는 이미 오래된 것입니다.
# 2. 그사이 로봇이 움직이므로 최신 포즈는 측정한 순간의 센서 포즈가 아닙니다.
# 3. 오차에는 크기가 있습니다. 속도 × 지연쯤이고, 회전하면 거리 × yaw 각속도 × 지연이 더해집니다.
# 4. 오류가 나지 않습니다. 최신 변환은 언제나 있기 때문입니다. 벽이 번지고 장애물의 자국이 뒤에 남습니다.
# 5. 버퍼는 이 일을 위해 과거의 변환을 보관합니다. `header.stamp`로 조회하거나 `transform()`을 쓰고, 측정 시각을 덮어쓰지 않습니다.
#
# 4–5점: 충분합니다. 2–3점: “연필로 어림하는 오차”를 다시 읽어 보세요. 그 아래: 슬라이더부터 움직여 보세요.
#
# </details>
