# %% [markdown] lang="en" name="title" slide="slide"
# # 12 · Owners and diagnosis
#
# **Which node publishes what?** · about 45 minutes, and the clinic as long as you like · builds on 05, 06, 07, 09, 10 and 11
#
# After this chapter you can
#
# - write down the owner of each edge: the node, its data, and its switch,
# - recognise the four states of an edge in a terminal: one [[owner]], no owner, two owners, or another edge to the same child,
# - choose the check that rules out the most [[suspect|suspects]] per minute, and stop when one is left,
# - tell a fix from a workaround.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 12 · 발행 책임과 진단
#
# **어느 노드가 무엇을 발행할까요?** · 약 45분, 진단 연습은 원하는 만큼 · 05, 06, 07, 09, 10, 11장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 연결마다 어느 노드가, 어떤 데이터로, 어떤 스위치로 발행하는지, 곧 [[owner|발행 책임]]을 적을 수 있습니다.
# - 터미널을 보고 연결의 네 가지 상태(발행자가 하나, 없음, 둘, 같은 자식의 다른 연결)를 구별할 수 있습니다.
# - [[suspect|용의자]]를 가장 적은 시간에 구별하는 검사를 고르고, 증명이 끝나면 멈출 수 있습니다.
# - 원인을 고치는 처치와 증상만 가리는 임시방편을 구별할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Two halves: owners first, then diagnosis. Ask: when something is wrong on your robot, what do you do in the first minute? Collect the answers, and come back to them at the end.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 앞부분은 발행 책임, 뒷부분은 진단입니다. 먼저 묻습니다. 로봇이 이상할 때 처음 1분 동안 무엇을 합니까? 답을 모아 두고 끝에 다시 봅니다.

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## Three publishers of one tree
#
# A robot with two cameras jumped back and forth while it was mapping. Its user changed cameras, frames and settings. In the end he counted the publishers of the tree: the mapper with its visual odometry (odometry from images), a filter, and the recording that was being played, which contained the old `/tf` (introlab/rtabmap_ros, 2021).
# His fix: no `/tf` from the bag, `publish_tf: false` in the filter, and one of the three was left.
#
# None of the three was broken. None of them raised an error. And the tree looked complete. TF2 keeps only the newest parent of a frame, so the drawing shows one parent, however many nodes publish the frame.

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 하나의 트리를 셋이 발행했습니다
#
# 카메라가 두 대인 로봇이 지도를 만들면서 앞뒤로 튀었습니다. 카메라도, 좌표계도, 설정도 바꾸어 보았습니다. 마지막에 누가 트리를 발행하는지 세어 보니 셋이었습니다. 비주얼 오도메트리(visual odometry, 영상으로 구하는 오도메트리)까지 맡은 지도 작성 노드, 필터, 그리고 재생 중인 bag입니다. bag에는 기록할 때의 `/tf`가 들어 있었습니다(introlab/rtabmap_ros, 2021년).
# 고친 방법은 이렇습니다. bag에서 `/tf`를 빼고 필터의 `publish_tf`를 `false`로 바꾸어 셋 가운데 하나만 남겼습니다.
#
# 셋 가운데 고장 난 것은 없었습니다. 오류도 없었습니다. 트리도 정상으로 보였습니다. 좌표계는 가장 최근의 부모 아래에만 그려지므로, 발행하는 노드가 몇이든 그림에는 부모가 하나만 보입니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Ask which of the three was broken. None. Ask what the tree tool showed. One parent. Write both answers on the board; you need them again in ten minutes. Do not say yet how one would have seen it.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 셋 가운데 누가 고장이었는지 묻습니다. 아무도 아닙니다. 트리 도구에는 무엇이 보였는지 묻습니다. 부모 하나입니다. 두 답을 칠판에 적어 두면 10분 뒤에 다시 씁니다. 어떻게 알아낼 수 있었는지는 아직 말하지 않습니다.

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* rtabmap_ros [645](https://github.com/introlab/rtabmap_ros/issues/645), and a similar one in [760](https://github.com/introlab/rtabmap_ros/issues/760); why `tf2_monitor` names no node: geometry2 [798](https://github.com/ros2/geometry2/issues/798).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* rtabmap_ros [645](https://github.com/introlab/rtabmap_ros/issues/645), 비슷한 경우 [760](https://github.com/introlab/rtabmap_ros/issues/760), `tf2_monitor`에 이름이 나오지 않는 이유: geometry2 [798](https://github.com/ros2/geometry2/issues/798).

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# The wheel odometry and a filter (`ekf_filter_node`) both publish `odom → base_footprint`.
#
# 1. How many publishers does `ros2 topic info /tf` count? And after you set `publish_tf` to false in the filter: one fewer, or as many as before?
# 2. What does a lookup return for a time **between** a pose of the wheel odometry and a pose of the filter: the one, the other, or something else?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 바퀴 오도메트리 노드와 필터(`ekf_filter_node`)가 모두 `odom → base_footprint`를 발행합니다.
#
# 1. `ros2 topic info /tf`에 발행자는 몇으로 나올까요? 필터의 `publish_tf`를 false로 한 뒤에는 하나 줄어들까요, 그대로일까요?
# 2. 오도메트리의 표본과 필터의 표본 **사이** 시각의 변환을 조회하면 무엇이 나올까요? 한쪽, 다른 쪽, 아니면 또 다른 값일까요?

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Let everybody write down a number for the first and a word for the second. Most say: one fewer.

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 첫째는 숫자로, 둘째는 한마디로 적게 합니다. 대부분 하나 줄어든다고 답합니다.

# %% name="my-guess" slide="skip"
before, after, between = ..., ..., ...

# %% name="two-owners" tags=["collapsed"] slide="skip"
# Start the robot, and 10 ms later the filter.
graph = lesson.new_graph()
robot = lesson.TeachingRobot()
lesson.launch(graph, robot, only=["robot_state_publisher", "joint_driver", "wheel_odometry", "localization"])
graph.run(seconds=0.01)  # no two nodes keep step on a robot
lesson.launch(graph, robot, only=["ekf_filter_node"])
graph.run(seconds=20.0)

# %% name="count-before" tags=["predicted"] slide="fragment"
# %ros2 topic info /tf

# %% name="switch-off" tags=["predicted"] slide="fragment"
# %ros2 param set /ekf_filter_node publish_tf false
# %ros2 topic info /tf

# %% [markdown] lang="en" name="count-seen" tags=["predicted"]
# Four before, four after. `topic info` counts all publishers on `/tf`, whether they send or not. The filter keeps its publisher and sends nothing. So a count of four does not prove a second owner, and a count of four after the fix does not disprove the fix.
# The proof is in the edge itself: its rate, and whether it changes smoothly. The next cells store the tree with a listener; `count_edge()` lets the robot drive for four seconds and counts the samples of this edge.

# %% [markdown] lang="ko" name="count-seen" tags=["predicted"]
# 끄기 전에도 넷, 끈 다음에도 넷입니다. `topic info`는 실제로 보내든 보내지 않든 `/tf`의 발행기를 모두 셉니다. 필터의 발행기는 남아 있고, 보내지 않을 뿐입니다. 그러니 넷이라는 숫자는 두 번째 발행자가 있다는 증거도, 고쳐지지 않았다는 증거도 아닙니다.
# 증거는 연결에 있습니다. 발행률이 얼마인지, 값이 끊김 없이 변하는지 보아야 합니다. 다음 셀의 수신기가 변환을 버퍼에 모읍니다. `count_edge()`는 로봇이 4초 동안 달리게 하고 이 연결의 표본을 셉니다.

# %% [markdown] lang="en" name="count-seen-notes" slide="notes"
# Let those who said “one fewer” explain why. They think of messages. But `topic info` counts publishers, just as a telephone book lists telephones and not calls. Then ask: what would show the messages? Wait for “the rate of the edge”.

# %% [markdown] lang="ko" name="count-seen-notes" slide="notes"
# “하나 줄어든다”고 답한 사람에게 까닭을 묻습니다. 지금 발행하는 노드를 센다고 생각했겠지만, 이 도구는 발행할 수 있는 노드를 셉니다. 그럼 실제로 발행하는지 알려면 무엇을 보아야 할까요? “연결의 발행률”이라는 답이 나오게 합니다.

# %% name="listen" slide="skip"
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformBroadcaster, TransformListener

rclpy.init()
node = Node("asker")
buffer = Buffer()
listener = TransformListener(buffer, node, spin_thread=True)

# %% name="count-edge" tags=["collapsed"] slide="skip"
# Define count_edge(): count the samples of odom -> base_footprint.
def count_edge(seconds=4.0):
    buffer.clear()
    graph.run(seconds=seconds)
    stamps = buffer.core.history("base_footprint").stamps_ns  # `.core` is ours: ROS's Buffer does not list its samples
    print(f"odom -> base_footprint: {len(stamps) / seconds:.1f} a second")

# %% name="rates" tags=["predicted"] slide="fragment"
count_edge()
# %ros2 param set /ekf_filter_node publish_tf true
count_edge()

# %% name="neighbours" tags=["predicted", "collapsed"] slide="skip"
# Find two neighbouring samples, one of each owner.
from itertools import pairwise

history = buffer.core.history("base_footprint")
samples = list(zip(history.stamps_ns, history.transforms, strict=True))[-12:]
apart = [(a, b) for a, b in pairwise(samples) if abs(a[1].translation[0] - b[1].translation[0]) > 0.08]
(first, one), (then, other) = apart[0]  # the stamps of two neighbours [ns], and their transforms

# %% name="between" tags=["predicted"]
middle = Time(nanoseconds=(first + then) // 2)  # the two stamps are of one owner and of the other
half = buffer.lookup_transform("odom", "base_footprint", middle).transform.translation
places = (("one owner", one.translation[:2]), ("in between", (half.x, half.y)), ("the other", other.translation[:2]))
for name, (x, y) in places:
    print(f"{name:<11} x {x:.3f}  y {y:.3f}")

# %% [markdown] lang="en" name="between-seen" tags=["predicted"]
# Twenty a second with one owner, fifty with two. And between the two a lookup interpolates, as between any two samples: **a position that no node ever published**. TF2 does not store owners. For TF2 there is one edge.

# %% [markdown] lang="ko" name="between-seen" tags=["predicted"]
# 발행자가 하나면 1초에 스무 번, 둘이면 쉰 번입니다. 두 노드의 표본 사이를 조회하면 여느 두 표본처럼 보간하므로, **아무도 발행한 적 없는 위치**가 나옵니다. TF2는 발행자를 기록하지 않으므로 둘을 한 연결로 처리합니다.

# %% [markdown] lang="en" name="owner" slide="slide"
# ## An owner is a node, a source, and a switch
#
# For each edge write down three things: **which node** publishes it, **from which data**, and **which switch** turns it off. If two nodes can publish the same edge, the switch of one has to be off. The switch is a parameter of the node. In common packages it has these names:
#
# | package | switch |
# |---|---|
# | robot_localization | `publish_tf` |
# | ros2_controllers, diff drive (two driven wheels) | `enable_odom_tf` |
# | nav2 amcl | `tf_broadcast` |
# | slam_toolbox | `transform_publish_period: 0.0` |
# | rtabmap | `publish_tf` |

# %% [markdown] lang="ko" name="owner" slide="slide"
# ## 발행 책임은 노드, 데이터, 스위치입니다
#
# 연결마다 세 가지를 적습니다. **어느 노드**가, **어떤 데이터로** 발행하는지, **어떤 스위치**로 그 발행을 켜고 끄는지입니다. 발행자가 둘이면 스위치 하나를 꺼야 합니다. 스위치는 노드의 파라미터이며, 흔히 쓰는 패키지에서는 다음 이름입니다.
#
# | 패키지 | 스위치 |
# |---|---|
# | robot_localization | `publish_tf` |
# | ros2_controllers, diff drive(두 바퀴 구동) | `enable_odom_tf` |
# | nav2 amcl | `tf_broadcast` |
# | slam_toolbox | `transform_publish_period: 0.0` |
# | rtabmap | `publish_tf` |

# %% [markdown] lang="en" name="owner-table" slide="fragment"
# These are six rows of the table for the robot above. Somebody has also mounted a gripper on it. The rates are those that `view_frames` prints:
#
# |  | edge | owner | source | switch | rate |
# |---|---|---|---|---|---|
# |  | `map → odom` | `localization` | scan, map | `tf_broadcast` | 10.2 Hz |
# | **! 2** | `odom → base_footprint` | `wheel_odometry` | wheels | `publish_tf` | 20.2 Hz |
# | **! 2** | `odom → base_footprint` | `ekf_filter_node` | wheels, IMU | `publish_tf` | 30.2 Hz |
# |  | `base_footprint → base_link` | `robot_state_publisher` | URDF | – | static |
# |  | `wrist → tool0` | `robot_state_publisher` | URDF | – | static |
# | **! 0** | `base_link → gripper` | **nobody** | – | – | – |

# %% [markdown] lang="ko" name="owner-table" slide="fragment"
# 위 로봇의 발행 책임표 가운데 여섯 줄입니다. 누군가 그리퍼도 하나 달았습니다. 발행률은 `view_frames`에 나오는 값입니다.
#
# |  | 연결 | 발행자 | 데이터 | 스위치 | 발행률 |
# |---|---|---|---|---|---|
# |  | `map → odom` | `localization` | 스캔, 지도 | `tf_broadcast` | 10.2 Hz |
# | **! 2** | `odom → base_footprint` | `wheel_odometry` | 바퀴 | `publish_tf` | 20.2 Hz |
# | **! 2** | `odom → base_footprint` | `ekf_filter_node` | 바퀴, IMU | `publish_tf` | 30.2 Hz |
# |  | `base_footprint → base_link` | `robot_state_publisher` | URDF | – | 정적 |
# |  | `wrist → tool0` | `robot_state_publisher` | URDF | – | 정적 |
# | **! 0** | `base_link → gripper` | **없음** | – | – | – |

# %% [markdown] lang="en" name="owner-seen"
# `! 2` marks an edge with two owners, `! 0` one without any. Fill in such a table for your own robot before anything is wrong. An empty one is in the section *A table of owners to print* near the end of the page. You need to know the normal state to notice a fault.
#
# If you know the lecture on which this workbook is based: one point in it is wrong. In ROS 2, `tf2_monitor` names no owner. It prints `<no authority available>` for each frame and each node. `ros2 topic info /tf --verbose` names the nodes. No tool names their edges.

# %% [markdown] lang="ko" name="owner-seen"
# `! 2`는 발행자가 둘인 연결, `! 0`은 아무도 발행하지 않는 연결입니다. 강의(00장에서 소개한 TF2 강의)의 24절은 문제가 생기기 전에 이런 표를 채워 두라고 합니다. 빈 표는 페이지 끝부분의 *인쇄용 발행 책임표* 절에 있습니다. 정상일 때의 값을 모르면 이상이 있는지도 알 수 없습니다.
#
# 강의 14절과 27절의 내용 하나를 바로잡습니다. ROS 2의 `tf2_monitor`에는 발행자의 이름이 나오지 않습니다. 좌표계와 노드의 줄마다 `<no authority available>`이 나옵니다. 노드 이름은 `ros2 topic info /tf --verbose`로 알 수 있고, 그 노드가 어느 연결을 발행하는지는 직접 알아내야 합니다.

# %% [markdown] lang="en" name="owner-notes" slide="notes"
# Twelve minutes, most of them at the board: an empty table (there is one to print near the end of the page), one sheet for two. They call out, you write node, data and switch. Leave a wrong line until somebody objects; only then show the table.

# %% [markdown] lang="ko" name="owner-notes" slide="notes"
# 12분이고, 대부분 칠판 앞에서 보냅니다. 빈 표를 칠판에 그리고, 인쇄한 표를 두 사람에 한 장씩 나누어 줍니다. 학생이 말하면 노드, 데이터, 스위치를 적습니다. 틀린 줄은 누가 지적할 때까지 두고, 그런 다음 표를 보여 줍니다.

# %% [markdown] lang="en" name="four-states" slide="slide"
# ## Four states of an edge
#
# Between a parent and a child there is **one owner**, or **none**, or **two**, or a node publishes **another edge** to the same child. You can tell them apart:
#
# | state | `tf2_echo odom base_footprint 20` | the tree |
# |---|---|---|
# | one | changes smoothly | complete |
# | none | never succeeds | an extra root `base_footprint` |
# | two | alternates | complete, and the rate is too high |
# | another edge | succeeds and fails in turn | alternates between complete and torn |

# %% [markdown] lang="ko" name="four-states" slide="slide"
# ## 연결의 네 가지 상태
#
# 부모와 자식 사이의 상태는 넷입니다. **발행자가 하나**이거나, **없거나**, **둘**이거나, 다른 노드가 같은 자식을 **다른 연결**로 발행합니다. 알맞은 검사를 하면 서로 다르게 보입니다.
#
# | 상태 | `tf2_echo odom base_footprint 20` | 트리 |
# |---|---|---|
# | 하나 | 끊김 없이 변합니다 | 한 덩어리입니다 |
# | 없음 | 값이 나오지 않습니다 | `base_footprint`가 따로 떨어진 루트가 됩니다 |
# | 둘 | 두 값 사이를 오갑니다 | 한 덩어리이지만 그 연결의 발행률이 너무 높습니다 |
# | 다른 연결 | 값이 나오다 말다 합니다 | 한 덩어리였다가 나뉘었다가 합니다 |

# %% [markdown] lang="en" name="four-states-notes" slide="notes"
# Cover the second column and let the class fill it in, row by row. Most miss “succeeds and fails in turn”: two owners of one edge never tear the tree, another edge does.

# %% [markdown] lang="ko" name="four-states-notes" slide="notes"
# 둘째 열을 가리고 한 줄씩 채우게 합니다. 많은 사람이 “값이 나오다 말다”를 놓칩니다. 한 연결의 발행자가 둘이면 트리가 끊어지지 않지만, 다른 연결이 오면 끊어집니다.

# %% name="to-and-fro" slide="fragment"
graph.run(seconds=0.005)
for _ in range(6):
    graph.run(seconds=0.05)
    newest = buffer.lookup_transform("odom", "base_footprint", Time())
    at, stamp = newest.transform.translation, Time.from_msg(newest.header.stamp)
    print(f"{stamp.nanoseconds / 1e9:.3f}  x {at.x:.3f}  y {at.y:.3f}")

# %% [markdown] lang="en" name="to-and-fro-seen"
# At twenty lookups a second you see both in turn. At one a second, the default of `tf2_echo`, it can look like a single owner for minutes. That is why the command ends in `20`.

# %% [markdown] lang="ko" name="to-and-fro-seen"
# 20 Hz로 조회하면 둘이 번갈아 나옵니다. `tf2_echo`의 기본값처럼 1 Hz로 조회하면 몇 분 동안이나 정상으로 보일 수 있습니다. 그래서 끝에 `20`을 붙입니다.

# %% [markdown] lang="en" name="stop-one" slide="slide"
# ## Stop one node and look
#
# No tool shows which node publishes which edge. But a stopped node publishes nothing. Stop one, and see whether the edge continues. **Predict:** what is the rate of `odom → base_footprint` without the filter, and without the wheel odometry?

# %% [markdown] lang="ko" name="stop-one" slide="slide"
# ## 노드를 하나 멈추고 보기
#
# 어느 노드가 어느 연결을 발행하는지 알려 주는 도구는 없습니다. 하지만 멈춘 노드는 아무것도 발행하지 않습니다. 하나를 멈추고 연결이 계속 오는지 봅시다. **예측해 봅시다.** 필터를 멈추면 `odom → base_footprint`가 1초에 몇 번 올까요? 바퀴 오도메트리 노드를 멈추면 몇 번 올까요?

# %% [markdown] lang="en" name="stop-one-notes" slide="notes"
# Let them write down three numbers before you run it: without the filter, without the wheel odometry, without the localiser. Say the safety sentence aloud: wheels off the ground, hand on the emergency stop. It is the one experiment here that moves a real machine.

# %% [markdown] lang="ko" name="stop-one-notes" slide="notes"
# 실행하기 전에 세 숫자를 적게 합니다. 필터 없이, 바퀴 오도메트리 노드 없이, 위치 추정 노드 없이. 안전 수칙은 소리 내어 말합니다. 바퀴는 바닥에서 띄우고 손은 비상 정지 버튼에 둡니다. 여기서 실제 기계를 움직이는 실험은 이것뿐입니다.

# %% name="stop-one-look" tags=["predicted", "collapsed"] slide="fragment"
# Stop one node after another, and count the edge's samples.
for name in ("ekf_filter_node", "wheel_odometry", "localization"):
    lesson.stop_node(name)
    print(f"without {name:<16}", end=" ")
    count_edge()
    lesson.launch(graph, robot, only=[name])

# %% [markdown] lang="en" name="stop-one-seen" tags=["predicted"]
# Without the filter 20 a second are left, without the wheel odometry 30, and without the localiser all 50: it does not publish this edge. If the rate drops when a node stops, that node is an owner. On a real robot: wheels off the ground, and the emergency stop in your hand.

# %% [markdown] lang="ko" name="stop-one-seen" tags=["predicted"]
# 필터를 멈추면 1초에 스무 번, 바퀴 오도메트리 노드를 멈추면 서른 번이 남고, 위치 추정 노드를 멈추면 쉰 번 그대로입니다. 이 연결과 상관없는 노드이기 때문입니다. 어떤 노드를 멈췄을 때 연결의 메시지가 줄거나 없어지면, 그 노드가 그 연결의 발행자입니다. 실제 로봇에서는 바퀴를 바닥에서 띄우고 비상 정지 버튼을 손에 쥐고 하십시오.

# %% [markdown] lang="en" name="another-edge" slide="subslide"
# ### The fourth state
#
# A localiser knows the robot's pose on the map, and publishes it directly: `map → base_footprint`. The wheel odometry continues as before. **Predict:** of forty lookups, how many find `odom → base_footprint`?

# %% [markdown] lang="ko" name="another-edge" slide="subslide"
# ### 네 번째 상태
#
# 위치 추정 노드가 지도에서 구한 로봇의 포즈를 `map → base_footprint`로 바로 발행합니다. 바퀴 오도메트리 노드는 이전과 같습니다. **예측해 봅시다.** 마흔 번 조회하면 몇 번이나 `odom → base_footprint`가 나올까요?

# %% [markdown] lang="en" name="another-edge-notes" slide="notes"
# Draw the tree on the board and let somebody add the new arrow. Whose child is the robot then? Wait for "of both, in turn".

# %% [markdown] lang="ko" name="another-edge-notes" slide="notes"
# 칠판에 트리를 그리고 한 사람에게 새 화살표를 더하게 합니다. 그러면 로봇의 부모는 무엇입니까? “번갈아 둘”이라는 답이 나오게 합니다.

# %% name="another-edge-look" tags=["predicted", "collapsed"] slide="fragment"
# Let a localiser publish map -> base_footprint, and look up the other edge forty times.
for name in ("ekf_filter_node", "localization"):
    lesson.stop_node(name)
graph.run(seconds=0.03)
bold = lesson.run_node(lambda: lesson.BaseLocalizer(robot), 1.0)
buffer.clear()
looks = ""
for _ in range(40):
    graph.run(seconds=0.05)
    looks += "+" if buffer.can_transform("odom", "base_footprint", Time()) else "."
print(looks)

# %% [markdown] lang="en" name="another-edge-seen" tags=["predicted"]
# 27 of the 40 lookups find it (`+`). Each `.` is a lookup after a message of the localiser. Then the robot is a child of `map`, `odom` is separate, and `tf2_echo` prints *not part of the same tree*. A child has one parent, the newest (04). So a localiser publishes `map → odom` and leaves the base to the wheel odometry.

# %% [markdown] lang="ko" name="another-edge-seen" tags=["predicted"]
# 40번 가운데 27번 나옵니다(`+`). `.`은 최신 변환이 위치 추정 노드에서 왔을 때의 조회입니다. 그때 로봇의 부모는 `map`이고 `odom`은 트리에서 떨어지며, `tf2_echo`에는 *not part of the same tree*가 나옵니다. 자식의 부모는 가장 최근의 하나뿐입니다(04장). 그래서 위치 추정 노드는 `map → odom`만 발행하고 base는 바퀴 오도메트리 노드에 맡깁니다.

# %% name="stop-two" tags=["collapsed"] slide="skip"
# Stop the nodes of this scene.
graph.stop()
node.destroy_node()
rclpy.shutdown()

# %% [markdown] lang="en" name="experiments" slide="slide"
# ## Experiments A, B, C
#
# The lecture (section 23) breaks a tree on purpose. A: everything right. B: the parent misspelt. C: two owners of one edge.
# Do them in simulation only, and stop every process afterwards, because a robot would move according to what they publish.

# %% [markdown] lang="ko" name="experiments" slide="slide"
# ## 강의의 실험 A, B, C
#
# 강의 23절에는 일부러 트리를 끊어 보는 실험이 셋 있습니다. A는 모두 맞는 경우, B는 부모 이름이 틀린 경우, C는 연결 하나를 둘이 발행하는 경우입니다.
# 시뮬레이션에서만 하고, 끝나면 프로세스를 모두 종료하십시오. 실제 로봇은 이 변환에 따라 움직입니다.

# %% [markdown] lang="en" name="experiments-notes" slide="notes"
# A takes a minute. Ask whether 2e+08 Hz is a fault. Before B ask: what will the first line of the tool be about, and what the second? Before the static C ask: 1.000, 2.000, or an error? Before the two processes let them draw forty digits for each pair of rates.

# %% [markdown] lang="ko" name="experiments-notes" slide="notes"
# A는 1분이면 됩니다. 2e+08 Hz를 고장이라고 하는 사람이 있습니까? B 전에는 도구의 첫 줄과 둘째 줄이 무엇일지 묻습니다. 정적 C 전에는 1.000, 2.000, 오류 가운데 무엇일지 묻습니다. 두 프로세스로 하기 전에는 발행률마다 숫자가 어떻게 늘어설지 적게 합니다.

# %% name="experiment-a" slide="subslide"
graph = lesson.new_graph()
zero = "--y 0 --z 0 --yaw 0 --pitch 0 --roll 0"
# %ros2 run tf2_ros static_transform_publisher --x 0 {zero} --frame-id map --child-frame-id odom
# %ros2 run tf2_ros static_transform_publisher --x 1 {zero} --frame-id odom --child-frame-id base_link
# %ros2 --for 1 run tf2_ros tf2_echo map base_link
# %ros2 --for 11 run tf2_ros tf2_monitor map base_link

# %% [markdown] lang="en" name="experiment-a-seen"
# A: 1.000, `At time 0.0`. The monitor's output looks wrong: a net delay of up to 12.5 s, and `2e+08 Hz` (two messages, no time between them). Both are normal for static transforms: sent once, valid at all times (11). Know the healthy output first.

# %% [markdown] lang="ko" name="experiment-a-seen"
# A는 1.000이고 `At time 0.0`입니다. 그런데 tf2_monitor의 출력은 고장처럼 보입니다. 경로의 지연은 최대 12.5초이고 `2e+08 Hz`라고 나옵니다(메시지 둘 사이의 간격이 0이기 때문입니다). 둘 다 정적 변환의 정상적인 모습입니다. 한 번 보내고 언제까지나 유효하기 때문입니다(11장). 정상일 때의 출력부터 알아 두어야 합니다.

# %% name="experiment-b" slide="subslide"
graph = lesson.new_graph()
# %ros2 run tf2_ros static_transform_publisher --frame-id map --child-frame-id odom
# %ros2 run tf2_ros static_transform_publisher --x 1 --frame-id odm --child-frame-id base_link
# %ros2 --for 2 run tf2_ros tf2_echo map base_link

# %% [markdown] lang="en" name="experiment-b-seen"
# B: the parent is `odm`. The first line of `tf2_echo` is only about the first lookup, before any message had arrived. The second line is the one that matters: **not part of the same tree**. A restart would not help, because the node is running. It publishes the name that it was given. Look for a name that nobody typed on purpose. RViz lists it:

# %% [markdown] lang="ko" name="experiment-b-seen"
# B에서는 부모 이름이 `odm`입니다. `tf2_echo`의 첫 줄은 변환을 받기 전의 조회에 대한 것이고, 둘째 줄이 실제 상태입니다. **같은 트리가 아닙니다.** 여기서 노드가 종료되었다고 생각해 노드를 다시 시작하는 사람이 있습니다. 하지만 노드는 실행 중이고 설정된 대로 발행합니다. 증거는 `odm`이라는 이름입니다. 이런 이름을 일부러 쓰는 사람은 없습니다. 이 이름은 RViz의 목록에도 나옵니다.

# %% name="experiment-b-rviz" tags=["collapsed"] slide="subslide"
# Draw what RViz shows.
lesson.draw_rviz()

# %% name="experiment-c" slide="subslide"
graph = lesson.new_graph()
# %ros2 run tf2_ros static_transform_publisher --x 1 --frame-id odom --child-frame-id base_link
# %ros2 run tf2_ros static_transform_publisher --x 2 --frame-id odom --child-frame-id base_link
# %ros2 --for 1 run tf2_ros tf2_echo odom base_link
# %ros2 topic info /tf_static

# %% [markdown] lang="en" name="experiment-c-seen"
# C, first with two static publishers: 2.000 is the value that was received last, and there is no message about the other. A listener that receives the two in the other order gets 1.000. **Nothing trembles, because each publisher sends once and tf2 keeps one value for a static edge.** Only the publisher count of `/tf_static` is a hint, and it rises with every correct publisher as well.

# %% [markdown] lang="ko" name="experiment-c-seen"
# C는 먼저 정적 발행자 둘로 합니다. 2.000은 마지막에 받은 값이고, 다른 쪽에 대해서는 아무 메시지도 없습니다. 다른 순서로 받은 수신기에는 1.000이 남습니다. **발행자마다 한 번만 보내고 tf2는 정적 연결에 값을 하나만 두므로, 아무것도 떨리지 않습니다.** 단서는 `/tf_static`의 발행자 수뿐인데, 다른 정적 연결의 발행자가 있어도 이 수는 늘어납니다.

# %% [markdown] lang="en" name="experiment-c-twice" slide="subslide"
# ### C with two processes that keep publishing
#
# The lecture's robot trembles in RViz. So its two processes must publish again and again, as `Odometry` does: a fixed pose, `rate_hz` times a second. `two_processes(20, 30)` starts one with x = 1 and one with x = 2, 13 ms apart. Then it looks up `odom → base_link` forty times, 20 times a second like `tf2_echo odom base_link 20`, and prints x.
#
# **Predict:** which digits do you see at 20 and 20 Hz, and which at 20 and 30 Hz?

# %% [markdown] lang="ko" name="experiment-c-twice" slide="subslide"
# ### 계속 발행하는 두 프로세스로 하는 C
#
# 강의의 로봇은 RViz에서 떨립니다. 그러려면 두 프로세스가 계속 발행해야 합니다. 아래의 `Odometry`가 그런 노드이고, 정해진 포즈를 1초에 `rate_hz`번 발행합니다. `two_processes(20, 30)`은 x가 1인 노드와 2인 노드를 13 ms 간격으로 시작합니다. 그런 다음 `tf2_echo odom base_link 20`처럼 20 Hz로 마흔 번 조회해 x를 출력합니다.
#
# **예측해 봅시다.** 20 Hz와 20 Hz이면 어떤 숫자가 늘어설까요? 20 Hz와 30 Hz이면 어떨까요?

# %% name="odometry-node" slide="-"
class Odometry(Node):
    def __init__(self, name, x, rate_hz):
        super().__init__(name)
        self.x = x
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(1.0 / rate_hz, self.tick)

    def tick(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id, t.child_frame_id = "odom", "base_link"
        t.transform.translation.x, t.transform.rotation.w = self.x, 1.0
        self.broadcaster.sendTransform(t)

# %% name="two-processes" tags=["collapsed"] slide="skip"
# Define two_processes(): start two Odometry nodes, and print x of forty lookups.
def two_processes(*rates_hz):
    graph = lesson.new_graph()
    for name, x, rate_hz in zip(("wheels", "ekf"), (1.0, 2.0), rates_hz, strict=True):
        lesson.run_node(lambda name=name, x=x, rate_hz=rate_hz: Odometry(name, x, rate_hz), 0.013)
    rclpy.init()
    buffer, viewer, found = Buffer(), Node("viewer"), []
    listener = TransformListener(buffer, viewer, spin_thread=True)
    graph.run(seconds=1.0)
    for _ in range(40):
        graph.run(seconds=0.05)
        found.append(f"{buffer.lookup_transform('odom', 'base_link', Time()).transform.translation.x:.0f}")
    listener.unregister()
    rclpy.shutdown()
    print(*found)

# %% name="experiment-c-equal" tags=["predicted"] slide="fragment"
two_processes(20, 20)  # Hz

# %% name="experiment-c-unequal" tags=["predicted"] slide="fragment"
two_processes(20, 30)

# %% [markdown] lang="en" name="experiment-c-twice-seen" tags=["predicted"]
# At 20 and 30 Hz, 1 and 2 alternate: RViz draws the robot here, then there, and it trembles. At equal rates every lookup returns 2, because the two keep their phase and the same process is always the last to send. **That is why a test on the bench can miss a second owner.** On a robot the rates are seldom equal for long. Try `two_processes(20, 20.1)`: seconds of one value, then seconds of the other.
#
# The rate of the edge shows the second owner in each of these cases: 40 or 50 messages a second, where 20 are expected.

# %% [markdown] lang="ko" name="experiment-c-twice-seen" tags=["predicted"]
# 20 Hz와 30 Hz에서는 1과 2가 번갈아 나옵니다. RViz는 로봇을 여기 그렸다가 저기 그리므로 로봇이 떨립니다. 발행률이 같으면 조회할 때마다 2입니다. 두 노드의 위상이 그대로라서 늘 같은 노드가 나중에 발행하기 때문입니다. **그래서 실험실에서 시험할 때는 두 번째 발행자를 놓칠 수 있습니다.** 실제 로봇에서 두 발행률이 오래 똑같은 일은 드뭅니다. `two_processes(20, 20.1)`도 실행해 보세요. 몇 초 동안 한 값이 나오다가, 다음 몇 초 동안은 다른 값이 나옵니다.
#
# 어느 경우든 연결의 발행률에는 두 번째 발행자가 드러납니다. 20 Hz여야 할 연결이 40 Hz나 50 Hz입니다.

# %% [markdown] lang="en" name="stop-guessing" slide="slide"
# ## A check is worth what it rules out
#
# The lecture's order of checks (section 27) has six steps:
#
# 1. the names of the frames, and RViz's Fixed Frame,
# 2. `view_frames`: is the tree in one piece?
# 3. `tf2_echo`: the value of the edge or path that looks wrong,
# 4. `tf2_monitor`: delays and rates (the lecture adds the owner, but ROS 2 prints none),
# 5. the message: its `frame_id`, its stamp, its clock,
# 6. the URDF, the switches of the publishers, second owners.
#
# They go from cheap and coarse to expensive and fine, and they find everything. But a fixed order is slow, because it does not use the complaint.
# Take the complaint “the scan flickers, something about the future”. There are three suspects: the laser's **clock is ahead**, the **transforms are late**, the **odometry is slow**. Before you type anything: which check would give different results for them?

# %% [markdown] lang="ko" name="stop-guessing" slide="slide"
# ## 좋은 검사는 용의자를 많이 지웁니다
#
# 강의 27절의 진단 순서는 여섯 단계입니다.
#
# 1. 좌표계 이름과 RViz의 고정 좌표계(Fixed Frame)를 확인합니다.
# 2. `view_frames`로 트리가 하나로 연결되어 있는지 봅니다.
# 3. `tf2_echo`로 의심스러운 연결이나 경로의 값을 봅니다.
# 4. `tf2_monitor`로 지연과 발행률을 봅니다. (강의에는 발행자도 있지만, ROS 2에서는 이름이 나오지 않습니다.)
# 5. 메시지의 `frame_id`와 측정 시각, 그리고 시계를 봅니다.
# 6. URDF, 발행 스위치, 두 번째 발행자를 확인합니다.
#
# 빠르고 대략적인 검사부터 오래 걸리고 세밀한 검사까지의 순서이고, 끝까지 하면 원인을 찾습니다. 하지만 증상을 살피지 않고 순서만 따르면 오래 걸립니다.
# “스캔이 깜빡이고 future라는 말이 나온다”는 증상을 봅시다. 용의자는 셋입니다. 레이저의 **시계가 앞섰거나**, **변환이 늦거나**, **오도메트리의 발행률이 낮습니다**. 명령을 입력하기 전에 생각해 보세요. 용의자마다 결과가 다를 검사는 무엇입니까?

# %% [markdown] lang="en" name="stop-guessing-notes" slide="notes"
# Ask for a check and write it down only if somebody can say the result for each of the three suspects. Cross out checks with the same result for all three. After five minutes one is left that costs a minute.

# %% [markdown] lang="ko" name="stop-guessing-notes" slide="notes"
# 검사를 제안받되, 세 용의자마다 어떤 결과가 나올지 말할 수 있을 때만 적습니다. 셋의 결과가 같은 검사는 지웁니다. 5분쯤 뒤에는 1분짜리 하나가 남습니다.

# %% name="columns" tags=["collapsed"] slide="fragment"
# Draw suspects and checks.
lesson.draw_columns("flickers", {"delay /scan": "ahead"})

# %% [markdown] lang="en" name="columns-seen"
# Rows are suspects, and columns are checks that can tell them apart. Hatched checks have not been made yet. The result of `topic delay /scan` was “ahead”. It fits the first row (`=`) and does not fit the others (`≠`), so one minute rules out two rows. When all other rows are ruled out, and at least one result was not normal, the one row that is left is proved. A result that all suspects share is no [[evidence]].

# %% [markdown] lang="ko" name="columns-seen"
# *그림 읽기:* 행은 용의자, 열은 용의자를 구별할 수 있는 검사입니다. 빗금은 아직 하지 않은 검사, `=`는 결과가 용의자와 맞음, `≠`는 맞지 않음입니다. laser clock ahead = 레이저의 시계가 앞섬, transforms late = 변환이 늦음, odometry slow = 오도메트리의 발행률이 낮음. `topic delay /scan`의 결과가 “ahead”(시계가 앞섬)로 나오자 1분 만에 두 행이 지워졌습니다. 행을 지울 때마다 근거가 하나씩 쌓입니다. 행이 하나만 남고 그동안 정상일 때와 다른 결과가 하나라도 나왔으면, 증명이 끝납니다. 어느 용의자가 원인이든 똑같이 나올 출력은 [[evidence|증거]]가 아닙니다.

# %% [markdown] lang="en" name="two-ways" slide="subslide"
# Two people now diagnose the eighteen simulated robots of the clinic, the exercise of the next section. Seventeen have one fault each, all different, and one has none. The two people get no complaint. One follows the six steps, the other always chooses the check that rules out the most suspects per minute. **Predict:** how many minutes does each of them need on average?

# %% [markdown] lang="ko" name="two-ways" slide="subslide"
# 이제 두 사람이 다음 절에 나오는 진료실의 로봇 열여덟 대를 진단합니다. 증상은 알려 주지 않으며, 원인은 저마다 다릅니다. 그중 한 대에는 이상이 없습니다. 한 사람은 여섯 단계를 따르고, 한 사람은 늘 1분당 용의자를 가장 많이 지우는 검사를 고릅니다. **예측해 봅시다.** 두 사람은 평균 몇 분이 걸릴까요?

# %% [markdown] lang="en" name="two-ways-notes" slide="notes"
# Let them guess both averages first. The order is not wrong: it is safe, it teaches, and it finds everything. It just does not use what you already know.

# %% [markdown] lang="ko" name="two-ways-notes" slide="notes"
# 먼저 두 평균을 짐작하게 합니다. 순서가 틀렸다는 이야기가 아닙니다. 순서는 안전하고, 배우기 좋고, 모두 찾아냅니다. 다만 이미 아는 것을 쓰지 않을 뿐입니다.

# %% name="both-ways" tags=["predicted", "collapsed"] slide="fragment"
# Draw the minutes of both people.
lesson.draw_both_ways()

# %% [markdown] lang="en" name="both-ways-seen" tags=["predicted"]
# | | on average | at worst |
# |:--|--:|--:|
# | the six steps | 6.1 minutes | 14 minutes |
# | always the best check | 2.3 minutes | 5 minutes |
#
# In the clinic you have twelve minutes (the dashed line). With the six steps, three of the eighteen robots take longer. Both people find every cause in the end. All checks together would take 72 minutes.

# %% [markdown] lang="ko" name="both-ways-seen" tags=["predicted"]
# *그림 읽기:* six steps = 강의의 여섯 단계, best next = 용의자를 가장 많이 지우는 검사부터, minutes = 걸린 시간(분), 세로 점선 = 쓸 수 있는 12분.
#
# | | 평균 | 가장 길 때 |
# |:--|--:|--:|
# | 여섯 단계 | 6.1분 | 14분 |
# | 용의자를 가장 많이 지우는 검사부터 | 2.3분 | 5분 |
#
# 진료실에서 쓸 수 있는 시간은 12분입니다. 여섯 단계로는 열여덟 대 가운데 세 대가 이 시간을 넘깁니다. 두 방법 모두 결국 원인을 찾습니다. 모든 검사를 하면 72분이 걸립니다.

# %% [markdown] lang="en" name="clinic" slide="slide"
# ## The clinic: how it works
#
# A patient is a simulated robot, usually with one fault, together with the recorded output of every tool. You get the complaint, RViz's screen and the card of the healthy robot, which lists its normal values, for free. Each check costs minutes, and you have twelve.

# %% [markdown] lang="ko" name="clinic" slide="slide"
# ## 진료실: 이렇게 합니다
#
# 진료실은 진단 연습이고, 환자는 누군가 고장 낸 로봇의 시뮬레이션입니다. 모든 도구의 출력이 기록되어 있습니다. 증상, RViz 화면, 정상일 때의 값을 적은 카드는 처음부터 볼 수 있습니다. 검사마다 시간이 들고, 쓸 수 있는 시간은 12분입니다.

# %% [markdown] lang="en" name="clinic-notes" slide="notes"
# Diagnose one patient together, aloud: read the complaint, read RViz, and let nobody type before the three suspects are named. If somebody proposes a fix, ask which result would change after it.

# %% [markdown] lang="ko" name="clinic-notes" slide="notes"
# 환자 한 명을 함께 봅니다. 증상과 RViz를 소리 내어 읽고, 세 용의자의 이름이 나오기 전에는 아무것도 입력하지 않습니다. 처치를 제안하는 사람에게는 처치한 다음 어느 값이 바뀔지 묻습니다.

# %% name="trolley" tags=["translated"] slide="skip"
lesson.show_trolley()

# %% [markdown] lang="en" name="trolley-seen"
# `show_trolley` prints all checks, with their minutes. On the left is the short name, which you can use instead of the command. Checks by hand, such as measuring the mount, take longer than commands. So begin with commands.
# `lesson.admit` starts a visit. With `helped=True` it rules out the suspects that do not fit a result; without it, you do so yourself. `because=` records which suspect the check is about. It earns no points.

# %% [markdown] lang="ko" name="trolley-seen"
# 왼쪽 열은 검사의 짧은 이름이고, 명령 대신 쓸 수 있습니다. 줄자나 케이블이 필요한 검사는 명령보다 오래 걸립니다. 그래서 명령으로 하는 검사가 먼저입니다.
# `lesson.admit`은 환자를 받습니다. `helped=True`면 검사 결과와 맞지 않는 용의자가 지워지고, 쓰지 않으면 여러분이 직접 지웁니다. `because=`에는 의심하는 용의자를 적습니다. 채점하지는 않습니다.

# %% name="worked" tags=["translated"] slide="subslide"
visit = lesson.admit(lesson.worked_patient("laser clock ahead"), helped=True)

# %% [markdown] lang="en" name="hasty"
# Most people want to fix it now. Try it, without a check:

# %% [markdown] lang="ko" name="hasty"
# 누구나 바로 고치고 싶어 합니다. 아무 검사도 하지 않고 해 봅시다.

# %% name="hasty-say" tags=["translated"]
visit.say(cause="laser clock ahead", fix="set the laser's clock")

# %% [markdown] lang="en" name="worked-think"
# The fix is refused: no fix without a diagnosis. The reply proposes a check with different results for all three suspects. But if the clock is the cause, the result of `hz /odom` is the normal one of the card, and a normal result proves nothing. Which check would give an abnormal result?
#
# “Into the future”: the scan's stamp is newer than the newest transform. Either the stamp is too new, or the transforms are too old. Each takes one minute to check: `delay /scan` checks the stamp, `delay /odom` the transforms.

# %% [markdown] lang="ko" name="worked-think"
# 거절당했습니다. 진단하기 전에는 고칠 수 없습니다. 거절하는 메시지는 `hz /odom`을 권합니다. 세 용의자에서 결과가 모두 다른 검사이기 때문입니다. 그러나 원인이 시계라면 `hz /odom`의 결과는 카드와 같습니다. 카드와 같은 결과로는 아무것도 증명할 수 없습니다. 어느 검사에서 카드와 다른 결과가 나올까요?
# “Into the future”는 스캔의 측정 시각이 최신 변환보다 미래라는 뜻입니다. 측정 시각이 미래로 틀렸거나, 변환이 아직 거기까지 오지 않았습니다. 어느 쪽이든 1분이면 알 수 있습니다. 측정 시각은 `delay /scan`으로, 변환은 `delay /odom`으로 봅니다.

# %% name="worked-ask" tags=["translated"]
visit.ask("ros2 topic delay /scan", because="laser clock ahead")

# %% [markdown] lang="en" name="worked-say"
# A negative delay: by its stamp, the scan arrived before it was measured. A late transform or a slow odometry cannot cause that. One suspect is left, so the proof is complete after one minute. (A positive delay that is too large proves less. The cause can be a clock that is behind, or a slow network. Then look at the walls: a late scan with a true stamp is on them, one with a wrong stamp is beside them.)
# Now comes the fix. First the one that everybody tries, a workaround that hides the symptom.

# %% [markdown] lang="ko" name="worked-say"
# 지연이 음수입니다. 측정 시각대로라면 측정하기도 전에 받은 것입니다. 변환이 늦거나 오도메트리의 발행률이 낮아서는 이럴 수 없습니다. 용의자가 하나 남았으니 1분 만에 증명이 끝났습니다. (양수일 때는 증명이 약합니다. 지연이 너무 크면 센서 시계가 뒤처졌을 수도, 전송이 느릴 수도 있습니다. 그럴 때는 벽을 보십시오. 측정 시각이 맞으면 지연된 스캔도 벽에 놓이고, 측정 시각이 틀리면 벽에서 어긋납니다.)
# 이제 고칠 차례입니다. 먼저 누구나 해 보는 임시방편, 곧 증상만 가리는 처치부터 봅시다.

# %% name="plaster" tags=["translated"] slide="subslide"
visit.say(cause="laser clock ahead", frame="laser_frame", owner="laser_driver", fix="timeout of 1 s")
visit.try_fix()

# %% name="cure" tags=["translated"]
visit.say(cause="laser clock ahead", frame="laser_frame", owner="laser_driver", fix="set the laser's clock")
visit.try_fix()

# %% [markdown] lang="en" name="cure-seen"
# Both times RViz reports Ok everywhere. But with the longer timeout the points are up to half a metre off the walls, and the delay that found the fault is as before. **A fix is proved by the check that found the fault**, not by the missing symptom.

# %% [markdown] lang="ko" name="cure-seen"
# 두 번 다 RViz는 모두 Ok입니다. 하지만 timeout을 늘렸을 때는 점이 벽에서 0.5미터 가까이 어긋나고, 고장을 찾아낸 지연도 그대로입니다. **고쳤다는 증거는 고장을 찾아낸 검사에 있습니다.** 증상이 사라졌다고 고친 것은 아닙니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# RViz shows no scan. What do you do in the first minute?
#
# 1. Swap the laser's cable.
# 2. Restart everything.
# 3. Read RViz's own list: what could it not do?
# 4. Give the lookup a longer timeout.
#
# <details><summary>I chose 1</summary>
#
# That takes half an hour, and the list in RViz may well show that messages arrive. It counts them.
#
# </details>
# <details><summary>I chose 2</summary>
#
# The same nodes come back with the same settings, and the outputs are lost. If the start order was the fault, a restart may even help, and tomorrow the fault is back.
#
# </details>
# <details><summary>I chose 3</summary>
#
# Yes. “No messages received”, “Frame [x] does not exist” and “into the future” each leave different suspects, and reading one takes a glance.
#
# </details>
# <details><summary>I chose 4</summary>
#
# That is a fix, and there is no diagnosis yet. If the clock is wrong, the scan will be back, in the wrong position.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# RViz에 스캔이 없습니다. 처음 1분 동안 무엇을 합니까?
#
# 1. 레이저의 케이블을 바꿉니다.
# 2. 모두 다시 켭니다.
# 3. RViz의 목록을 읽습니다. 무엇을 할 수 없었다고 적혀 있습니까?
# 4. 조회의 timeout을 늘립니다.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 30분이 걸립니다. 그런데 RViz 목록에는 메시지가 온다고 적혀 있을지 모릅니다. 개수까지 세어 줍니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 같은 노드가 같은 설정으로 다시 실행되고, 읽을 수 있었던 것은 사라집니다. 시작 순서가 문제였다면 해결된 듯 보이지만, 내일 다시 나타납니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞습니다. “No messages received”, “Frame [x] does not exist”, “into the future”는 한 번 보는 것만으로 용의자를 세 무리로 나눕니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 아직 진단이 없는데 처치부터 했습니다. 시계가 틀렸다면 스캔은 다시 보이지만 틀린 자리에 놓입니다.
#
# </details>

# %% [markdown] lang="en" name="checkpoint-notes" slide="notes"
# Hands for 1 to 4. Come back to the first minute that they named at the beginning: who would change it now?

# %% [markdown] lang="ko" name="checkpoint-notes" slide="notes"
# 1번부터 4번까지 손을 들게 합니다. 처음에 적은 “처음 1분”을 다시 보고 누가 바꾸겠는지 묻습니다.

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# ```
# ros2 node list
# ros2 run tf2_tools view_frames
# ros2 run tf2_ros tf2_echo map base_link
# ros2 run tf2_ros tf2_monitor map base_link
# ros2 topic info /tf --verbose                # which nodes have a publisher
# ros2 topic info /tf_static --verbose         # which nodes; is one of them VOLATILE?
# ros2 topic echo /tf_static --once            # of two publishers only one
# ros2 param get /problem_node use_sim_time    # with the name of your node
# ```
#
# What these eight commands cannot show, the following five do:
#
# ```
# ros2 run tf2_ros tf2_echo odom base_footprint 20   # smooth?
# ros2 topic delay /scan                             # stamp and clock
# ros2 lifecycle get /amcl                           # active?
# ros2 node info /ekf_filter_node
# chronyc tracking                                   # on each computer
# ```
#
# To find the owner of an edge, stop one node at a time and check whether the edge continues: wheels off the ground, and the emergency stop in your hand.
#
# The clinic has seventeen faults, and a robot can have others. Three common ones are not in the clinic: a localiser that waits for its initial pose or was never activated, a subscriber that requests `RELIABLE` where the driver offers `BEST_EFFORT`, a neighbour's robot on the same `ROS_DOMAIN_ID`. The method is the same: which check has different results for them?

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# ```
# ros2 node list
# ros2 run tf2_tools view_frames
# ros2 run tf2_ros tf2_echo map base_link
# ros2 run tf2_ros tf2_monitor map base_link
# ros2 topic info /tf --verbose                # 발행기가 있는 노드
# ros2 topic info /tf_static --verbose         # VOLATILE은 아닌지
# ros2 topic echo /tf_static --once            # 발행자가 둘이면 하나만
# ros2 param get /problem_node use_sim_time    # 문제가 되는 노드의 이름으로
# ```
#
# 강의 27절의 여덟 명령입니다. 이 여덟 개로 알 수 없는 것은 다음 다섯 명령으로 확인합니다.
#
# ```
# ros2 run tf2_ros tf2_echo odom base_footprint 20   # 끊김 없이 변하는지
# ros2 topic delay /scan                             # 측정 시각과 시계
# ros2 lifecycle get /amcl                           # 활성 상태인지
# ros2 node info /ekf_filter_node
# chronyc tracking                                   # 컴퓨터마다
# ```
#
# 어느 노드가 연결을 발행하는지 보려면 노드를 하나씩 멈추고 연결이 계속 오는지 봅니다. 바퀴는 바닥에서 띄우고 비상 정지 버튼을 손에 쥐고 하십시오.
# 진료실의 고장은 17가지이고, 실제 로봇에는 그 밖의 고장도 있습니다. 누구나 만나지만 진료실에 없는 것이 셋 있습니다. 초기 포즈(initial pose)를 기다리거나 활성화되지 않은 위치 추정 노드, `BEST_EFFORT`로 보내는 드라이버에 `RELIABLE`을 요청하는 노드, 같은 `ROS_DOMAIN_ID`를 쓰는 옆 로봇입니다. 방법은 같습니다. 이들의 결과가 서로 다를 검사는 무엇일까요?

# %% [markdown] lang="en" name="on-the-robot-notes" slide="notes"
# To photograph. Say the last line aloud: wheels off the ground, the emergency stop in your hand.

# %% [markdown] lang="ko" name="on-the-robot-notes" slide="notes"
# 사진으로 찍게 합니다. 마지막 줄은 소리 내어 말합니다. 바퀴는 바닥에서 띄우고, 비상 정지 버튼은 손에 쥡니다.

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - An [[owner]] is a node, a source of data and a switch. Each edge has exactly one.
# - A [[second-owner|second owner]] raises no error. Look up twenty times a second, and look at the rate of the edge.
# - A complaint is not a cause. A check is worth what it rules out: choose one with different results for your [[suspect|suspects]].
# - Stop when one is left. A fix is proved by the check that found the fault.
# - From all twelve chapters: a value needs its frame and its stamp. `map` is right in the long run, `odom` is smooth, `base_link` is the robot. A mount is published once on `/tf_static`, a moving frame again and again on `/tf`. Most errors are a name, a gap, a second owner or a clock, and seldom mathematics.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - [[owner|발행 책임]]은 노드, 데이터, 스위치입니다. 연결마다 발행자는 꼭 하나여야 합니다.
# - [[second-owner|두 번째 발행자]]가 있어도 오류는 나지 않습니다. 20 Hz로 조회하고, 연결의 발행률을 확인하십시오.
# - 증상은 원인이 아닙니다. 좋은 검사는 용의자를 많이 지웁니다. [[suspect|용의자]]마다 결과가 다를 검사를 고르십시오.
# - 하나가 남으면 멈추십시오. 고쳤다는 증거는 고장을 찾아낸 검사에 있습니다.
# - 그리고 열두 장 모두의 정리입니다(31절). 값에는 좌표계와 측정 시각이 필요합니다. `map`은 오래 지나도 맞고, `odom`은 연속이며, `base_link`는 로봇의 몸체입니다. 고정된 것은 `/tf_static`으로 한 번, 움직이는 것은 `/tf`로 계속 보냅니다. 오류는 대개 이름, 빠진 연결, 두 번째 발행자, 시계에서 나오고 수식에서 나오는 일은 드뭅니다.

# %% [markdown] lang="en" name="recap-notes" slide="notes"
# Five minutes at the end of the second sitting. Two pairs read their lists of checks: which one could they have left out?

# %% [markdown] lang="ko" name="recap-notes" slide="notes"
# 둘째 시간 끝의 5분입니다. 두 조가 검사 목록을 읽습니다. 어느 검사를 뺄 수 있었을까요?

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > A colleague says: “I set a timeout of one second, and now RViz is green. Fixed.” Which check do you ask him to repeat, and what would the result have to be?
#
# <details><summary>Compare</summary>
#
# The one that found the fault. If it was `delay /scan`, the result has to be that of the card. As long as it is negative, the points are off the walls, although RViz is green.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > 동료가 말합니다. “timeout을 1초로 했더니 RViz가 초록색이야. 고쳤어.” 어떤 검사를 다시 해 보라고 하겠습니까? 그 결과는 어떠해야 합니까?
#
# <details><summary>맞춰 보기</summary>
#
# 고장을 찾아낸 그 검사입니다. `delay /scan`이었다면 카드와 같은 값이 나와야 합니다. 지연이 음수이면 RViz가 초록색이어도 점이 벽에서 어긋나 있습니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Two minutes, in silence, on paper. The ticket ends the first sitting.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 2분 동안 말없이 쪽지에 적습니다. 첫째 시간은 여기서 끝납니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now name the owner of each edge, recognise a second one, choose a check by what it rules out, and prove a fix.
#
# **Now the exercises:** [E12 Owners and diagnosis](../../exercises/en/E12_owners_and_diagnosis.ipynb), with three patients of your own. In them, `solution("E12.1")` shows a solution after you have passed the task or tried three times.
# This was the last chapter; [the start page](00_start.ipynb) shows what you have passed, and what is left.
# When you go to a real robot, begin with [From here to a robot](92_to_a_robot.ipynb): your nodes as a package, what differs there, and the first five commands.
#
# The sections below are for practice and reference: more patients of the clinic, two faults at once, experiment C on your computer, a table of owners to print, tables of symptoms and mistakes, and questions.
#
# On your checklist this chapter is **C13** (a second broadcaster found and removed) and **C14** (the table of owners). Here it was simulated; do it once on the robot.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 연결마다 누가 발행하는지 적고, 두 번째 발행자를 알아보고, 용의자를 많이 지우는 검사를 고르고, 고쳤다는 것을 증명할 수 있습니다.
#
# **이제 연습 문제입니다.** [E12 발행 책임과 진단](../../exercises/ko/E12_owners_and_diagnosis.ipynb)에서 여러분의 로봇 세 대를 진단합니다. 통과하거나 세 번 시도한 뒤에는 `solution("E12.1")`로 풀이를 볼 수 있습니다.
# 이것이 마지막 장입니다. [시작 페이지](00_start.ipynb)에서 통과한 것과 남은 것을 볼 수 있습니다.
# 실제 로봇으로 갈 때는 [이제 로봇으로](92_to_a_robot.ipynb)부터 보십시오. 내 노드를 패키지로 만드는 법, 로봇에서 다른 점, 처음 입력할 다섯 명령이 있습니다.
#
# 아래는 더 연습하거나 찾아볼 때 쓰는 절입니다. 진료실의 다른 환자, 원인이 둘인 환자, 여러분의 컴퓨터에서 하는 실험 C, 인쇄용 발행 책임표, 증상과 실수의 표, 복습 문제와 서술형 문제가 있습니다.
#
# 실습 체크리스트에서 이 장은 **C13**(중복 발행자를 찾아 제거)과 **C14**(발행 책임표)입니다. 여기서는 시뮬레이션이었으니, 로봇에서도 한 번 해 보세요.

# %% [markdown] lang="en" name="faded-heading" slide="slide"
# ## Half with help: the robot jumps

# %% [markdown] lang="ko" name="faded-heading" slide="slide"
# ## 반만 도움받기: 로봇이 튑니다

# %% [markdown] lang="en" name="faded" slide="-"
# Two checks are given (`take` is `ask` without the lines about costs). You name the cause. Fill in `my_cause`, then try a fix: it is refused as long as your results fit another suspect.

# %% [markdown] lang="ko" name="faded" slide="-"
# 검사 둘은 정해져 있습니다(`take`는 남은 시간을 출력하지 않는 `ask`입니다). 용의자를 하나 지목하면 됩니다. `my_cause`를 채우고 처치를 실행해 보세요. 검사 결과가 다른 용의자에게도 맞으면 처치가 거절됩니다.

# %% [markdown] lang="en" name="faded-notes" slide="notes"
# Five minutes in pairs. One makes the checks, one keeps the list of suspects and rules out. Then change roles for the next patient.

# %% [markdown] lang="ko" name="faded-notes" slide="notes"
# 둘씩 5분 동안 합니다. 한 사람은 검사하고, 한 사람은 목록에서 용의자를 지웁니다. 다음 환자에서는 역할을 바꿉니다.

# %% name="faded-visit" tags=["translated"]
jumps = lesson.admit(lesson.worked_patient("two owners of one edge"))

# %% name="faded-checks" slide="subslide"
lines = jumps.take("echo odom base_footprint").splitlines()
print(*[line for line in lines if line.startswith(("At time", "- Translation"))][:12], sep="\n")
print("", jumps.take("node list"), sep="\n")

# %% name="faded-yours"
my_cause = ...  # 'two owners of one edge', 'localizer owns the base' or 'nothing is wrong'
if my_cause is not ...:
    jumps.say(cause=my_cause, frame="base_footprint", owner="ekf_filter_node", fix="ekf_filter_node: publish_tf false")
    jumps.try_fix()

# %% [markdown] lang="en" name="alone-heading" slide="slide"
# ## Alone: as many patients as you like

# %% [markdown] lang="ko" name="alone-heading" slide="slide"
# ## 혼자서: 환자는 얼마든지

# %% [markdown] lang="en" name="alone" slide="-"
# `lesson.practice_patient(7)` makes a patient in a few seconds. Each number makes a different patient. In the panel you do the same as with the calls: choose a check, choose the suspect that it is about, and make the check. Then choose a cause and a fix, and try the fix. `lesson.answer_of(7)` returns the answer. Look at it last.

# %% [markdown] lang="ko" name="alone" slide="-"
# `lesson.practice_patient(7)`은 몇 초 만에 환자를 만듭니다. 숫자가 다르면 다른 환자이고, 얼마든지 있습니다. 패널로도 함수를 호출할 때와 똑같이 할 수 있습니다. 검사를 고르고, 의심하는 용의자를 정하고, 검사를 실행해 보세요. 그다음 원인과 처치를 골라 해 보세요. 답은 `lesson.answer_of(7)`에 있으니 맨 나중에 보십시오.

# %% name="panel" tags=["interactive"] slide="skip"
lesson.clinic_panel(lesson.practice_patient(7))

# %% name="panel-still" tags=["static"]
lesson.draw_questions(lesson.answer_of(7), ["hz /scan", "view_frames", "node list", "use_sim_time"])

# %% [markdown] lang="en" name="panel-seen" slide="skip"
# The figure shows four checks of the same patient, what each cost, and how many suspects were left. `★` marks the check after which one suspect was left; the checks after it are hatched, because their results add nothing.

# %% [markdown] lang="ko" name="panel-seen" slide="skip"
# *그림 읽기:* 같은 환자에게 한 검사 넷입니다. 막대는 걸린 시간, left는 남은 용의자의 수입니다. `★`에서 하나가 남았고, 그 뒤의 빗금 친 막대에서는 새로 알게 된 것이 없습니다.

# %% [markdown] lang="en" name="second" slide="subslide"
# And what does a program find? `second_opinion` starts that robot once more and lets the doctor examine it (`tflab doctor`, a program that looks for TF problems), as soon as you have named a suspect.

# %% [markdown] lang="ko" name="second" slide="subslide"
# 자동 진단의 결과는 어떨까요? 용의자를 하나 지목하면 `second_opinion`이 그 로봇을 다시 켜고 `tflab doctor`로 진단합니다.

# %% name="second-opinion" tags=["translated"] slide="-"
my_suspect = ...  # one of the three
lesson.second_opinion(7, my_suspect)

# %% [markdown] lang="en" name="second-seen"
# Compare: did it name the same node, or only what is missing? Which of its sentences could you have written with your results, and which of your checks did it not need?

# %% [markdown] lang="ko" name="second-seen"
# 비교해 보세요. doctor는 같은 노드를 지목했습니까, 무엇이 빠졌는지만 알려 주었습니까? doctor가 출력한 문장 가운데 여러분의 검사 결과로도 쓸 수 있었던 것은 무엇입니까? doctor에는 필요 없었던 검사는 무엇입니까?

# %% [markdown] lang="en" name="alone-notes" slide="notes"
# In pairs, 45 minutes together with E12.4. One types; the other gives the reason before each check. Change roles with each patient.

# %% [markdown] lang="ko" name="alone-notes" slide="notes"
# 둘씩, E12.4까지 45분입니다. 한 사람은 입력하고 한 사람은 검사마다 까닭을 먼저 말합니다. 환자가 바뀌면 역할도 바꿉니다.

# %% [markdown] lang="en" name="suspects" slide="skip"
# For reference, without a panel: the six complaints with their suspects, and for one complaint the results of the checks that can tell its suspects apart. `lesson.show_findings()` prints the results for all eighteen suspects. E12.7 shows them, too.

# %% [markdown] lang="ko" name="suspects" slide="skip"
# 패널 없이 찾아보는 표입니다. 여섯 증상과 용의자, 그리고 한 증상의 용의자를 가려낼 수 있는 검사의 결과입니다. `lesson.show_findings()`는 열여덟 모두를 출력하며, E12.7에도 있습니다.

# %% name="suspects-words" tags=["translated"] slide="skip"
lesson.show_suspects()

# %% name="findings-words" tags=["translated"] slide="skip"
lesson.show_findings("flickers")

# %% [markdown] lang="en" name="break-it-heading" slide="slide"
# ## Break it: two causes

# %% [markdown] lang="ko" name="break-it-heading" slide="slide"
# ## 일부러 고장 내기: 원인이 둘

# %% [markdown] lang="en" name="break-it" slide="-"
# Some robots of the clinic have two faults (`lesson.night_shift`). **Predict:** the localiser is not running, and in addition the laser's mount is wrong. You start the localiser. What does RViz report, and where is the scan?

# %% [markdown] lang="ko" name="break-it" slide="-"
# 이번 환자는 원인이 둘입니다. **예측해 봅시다.** 위치 추정 노드가 꺼져 있고, 레이저의 장착 변환도 틀렸습니다. 위치 추정 노드를 켜면 RViz에는 무엇이 나오고, 스캔은 어디에 있을까요?

# %% [markdown] lang="en" name="break-it-notes" slide="notes"
# Let them write a sentence about the scan before you run it. The laugh comes with “all Ok”.

# %% [markdown] lang="ko" name="break-it-notes" slide="notes"
# 실행하기 전에 스캔이 어떨지 한 문장으로 적게 합니다. “모두 Ok”가 나오면 예측과 비교합니다.

# %% name="night" tags=["predicted", "translated"] slide="subslide"
night = lesson.admit(lesson.night_shift(6))

# %% name="night-fix" tags=["predicted", "translated"] slide="subslide"
night.take("node list")
night.take("use_sim_time")
night.say(cause="localizer not running", frame="odom", owner="localization", fix="start localization")
night.try_fix()

# %% [markdown] lang="en" name="night-seen" tags=["predicted"]
# The first cause is gone, and RViz is all Ok, but the scan is up to 0.26 m off the walls. (With its clock set, the robot of the clinic above was at 0.09 m.) The second fault was there all along, and could not be seen. Fix one, and examine again from the beginning.

# %% [markdown] lang="ko" name="night-seen" tags=["predicted"]
# 첫 원인은 사라지고 RViz는 모두 Ok인데, 스캔은 벽에서 0.26 m까지 어긋나 있습니다(앞에서 시계를 맞춘 로봇은 0.09 m였습니다). 두 번째 원인은 처음부터 있었지만 보이지 않았습니다. 하나를 고치면 처음부터 다시 검사하십시오.

# %% [markdown] lang="en" name="doctor" slide="subslide"
# A program helps, but it does not know what you intended. Of the eighteen robots the doctor reports a finding on fourteen, correctly reports none on one, and misses three: a mistyped Fixed Frame, a mount at another position, a header that names a wrong frame that exists. Such a robot looks as if it had been built that way on purpose. Only the card shows the difference.

# %% [markdown] lang="ko" name="doctor" slide="subslide"
# 자동 진단으로는 로봇이 원래 어떠해야 하는지 알 수 없습니다. 열여덟 대를 모두 `tflab doctor`로 진단하면 열네 대에서는 문제를 찾아내고, 한 대는 이상이 없다고 바르게 판정하며, 세 대에서는 아무것도 찾지 못합니다. 사람이 틀리게 입력한 고정 좌표계(Fixed Frame), 값이 다른 장착 변환, 다른 (실제로 있는) 좌표계 이름이 적힌 헤더입니다. 누군가 일부러 그렇게 설정한 로봇처럼 보이기 때문입니다. 정상일 때의 카드와 비교해야만 알 수 있습니다.

# %% [markdown] lang="en" name="doctor-notes" slide="notes"
# Only after a pair has a diagnosis of its own. Who was right about the mount, and why could the program not be?

# %% [markdown] lang="ko" name="doctor-notes" slide="notes"
# 학생들이 둘씩 직접 진단해 본 다음에 보여 줍니다. 틀린 장착 변환을 찾아낸 사람은 누구입니까? 자동 진단으로는 왜 찾을 수 없었습니까?

# %% [markdown] lang="en" name="experiment-c-heading" slide="skip"
# ## Experiment C on your own computer

# %% [markdown] lang="ko" name="experiment-c-heading" slide="skip"
# ## 여러분의 컴퓨터에서 하는 실험 C

# %% [markdown] lang="en" name="experiment-c-file" slide="skip"
# Save this node, and start it twice with different parameters: two processes, one edge.
#
# ```python
# # tf_lab_py/one_of_two.py
# import rclpy
# from geometry_msgs.msg import TransformStamped
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from tf2_ros import TransformBroadcaster
#
#
# class OneOfTwo(Node):
#     """Publish odom -> base_link at a fixed pose; start it twice, and the edge has two owners."""
#
#     def __init__(self):
#         super().__init__('one_of_two')
#         self.x = self.declare_parameter('x', 1.0).value  # [m]
#         rate_hz = self.declare_parameter('rate_hz', 20.0).value
#         self.broadcaster = TransformBroadcaster(self)
#         self.timer = self.create_timer(1.0 / rate_hz, self.tick)
#         self.get_logger().info(f'odom -> base_link: x {self.x:.2f} m, {rate_hz:.1f} Hz')
#
#     def tick(self):
#         t = TransformStamped()
#         t.header.stamp = self.get_clock().now().to_msg()
#         t.header.frame_id = 'odom'
#         t.child_frame_id = 'base_link'
#         t.transform.translation.x = self.x
#         t.transform.rotation.w = 1.0
#         self.broadcaster.sendTransform(t)
#
#
# def main():
#     rclpy.init()
#     node = OneOfTwo()
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
# ```
# python3 one_of_two.py --ros-args -r __node:=wheels -p x:=1.0 -p rate_hz:=20.0
# python3 one_of_two.py --ros-args -r __node:=ekf -p x:=2.0 -p rate_hz:=30.0
# ros2 run tf2_ros tf2_echo odom base_link 20
# rviz2
# ```
#
# Each command needs a terminal of its own. In RViz set the Fixed Frame to `odom` and add *TF*: `base_link` jumps between x = 1 and x = 2. Start the second process again with `rate_hz:=20.0`, and compare.
# Do this only where no robot listens, and stop both processes with Ctrl-C afterwards. Without ROS 2, `tflab run one_of_two.py` runs one of the two.

# %% [markdown] lang="ko" name="experiment-c-file" slide="skip"
# 이 노드를 저장하고, 파라미터를 달리해 두 번 시작합니다. 프로세스는 둘이고 연결은 하나입니다.
#
# ```python
# # tf_lab_py/one_of_two.py
# import rclpy
# from geometry_msgs.msg import TransformStamped
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from tf2_ros import TransformBroadcaster
#
#
# class OneOfTwo(Node):
#     """Publish odom -> base_link at a fixed pose; start it twice, and the edge has two owners."""
#
#     def __init__(self):
#         super().__init__('one_of_two')
#         self.x = self.declare_parameter('x', 1.0).value  # [m]
#         rate_hz = self.declare_parameter('rate_hz', 20.0).value
#         self.broadcaster = TransformBroadcaster(self)
#         self.timer = self.create_timer(1.0 / rate_hz, self.tick)
#         self.get_logger().info(f'odom -> base_link: x {self.x:.2f} m, {rate_hz:.1f} Hz')
#
#     def tick(self):
#         t = TransformStamped()
#         t.header.stamp = self.get_clock().now().to_msg()
#         t.header.frame_id = 'odom'
#         t.child_frame_id = 'base_link'
#         t.transform.translation.x = self.x
#         t.transform.rotation.w = 1.0
#         self.broadcaster.sendTransform(t)
#
#
# def main():
#     rclpy.init()
#     node = OneOfTwo()
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
# ```
# python3 one_of_two.py --ros-args -r __node:=wheels -p x:=1.0 -p rate_hz:=20.0
# python3 one_of_two.py --ros-args -r __node:=ekf -p x:=2.0 -p rate_hz:=30.0
# ros2 run tf2_ros tf2_echo odom base_link 20
# rviz2
# ```
#
# 명령마다 터미널을 하나씩 씁니다. RViz에서 고정 좌표계(Fixed Frame)를 `odom`으로 정하고 *TF*를 추가하면 `base_link`가 x = 1과 x = 2 사이를 오갑니다. 둘째 프로세스를 `rate_hz:=20.0`으로 다시 시작해 비교해 보세요.
# 이 변환을 받는 로봇이 없는 곳에서만 하고, 끝나면 두 프로세스를 Ctrl-C로 종료하십시오. ROS 2가 없으면 `tflab run one_of_two.py`로 둘 가운데 하나를 실행해 볼 수 있습니다.

# %% [markdown] lang="en" name="owner-blank-heading" slide="skip"
# ## A table of owners to print

# %% [markdown] lang="ko" name="owner-blank-heading" slide="skip"
# ## 인쇄용 발행 책임표

# %% [markdown] lang="en" name="owner-blank" slide="skip"
# Five usual edges (section 24 of the lecture), and space for those of your own robot.
#
# | edge | usual owner | made of | our node | its switch, on or off | rate |
# |---|---|---|---|---|---|
# | `map → odom` | AMCL, SLAM, localisation | map and sensors | | | |
# | `odom → base_link` | EKF or odometry | encoders, IMU, visual odometry | | | |
# | `base_link → sensor` | robot_state_publisher | fixed joints of the URDF | | | static |
# | `base_link → moving_link` | robot_state_publisher | `/joint_states` | | | |
# | `earth → map`, or a fleet's frame | localisation, fleet manager | GNSS, a survey | | | |
# | | | | | | |

# %% [markdown] lang="ko" name="owner-blank" slide="skip"
# 강의 24절의 다섯 연결과, 여러분 로봇의 연결을 적을 빈칸입니다.
#
# | 연결 | 흔한 발행자 | 데이터 | 우리 노드 | 스위치(켬/끔) | 발행률 |
# |---|---|---|---|---|---|
# | `map → odom` | AMCL, SLAM, 위치 추정 | 지도와 센서 | | | |
# | `odom → base_link` | EKF 또는 오도메트리 | 인코더, IMU, 비주얼 오도메트리 | | | |
# | `base_link → sensor` | robot_state_publisher | URDF의 고정 관절 | | | static |
# | `base_link → moving_link` | robot_state_publisher | `/joint_states` | | | |
# | `earth → map`, 또는 여러 로봇의 공통 좌표계 | 위치 추정, 관제 시스템 | GNSS, 측량 | | | |
# | | | | | | |

# %% [markdown] lang="en" name="ten-heading" slide="skip"
# ## Ten symptoms, and the first check of each

# %% [markdown] lang="ko" name="ten-heading" slide="skip"
# ## 열 가지 증상과 먼저 할 확인

# %% [markdown] lang="en" name="ten" slide="skip"
# | you see | likely | first check | chapter |
# |---|---|---|---|
# | no Fixed Frame | misspelt, or no node publishes it | RViz's own list, `view_frames` | 11 |
# | two frames not connected | an edge in between is missing | `view_frames`: the two roots | 04, 09 |
# | the robot trembles | two owners | the edge's rate and `tf2_echo … 20`, then `topic info /tf --verbose` | 12 |
# | the sensor is drawn beside the robot | the mount's value | `tf2_echo base_link laser_frame`, the URDF's origin | 07, 11 |
# | the scan smears along walls | stamps, late odometry | `topic delay /scan`, then `tf2_monitor` (which does not see the scan) | 11 |
# | future extrapolation | late transforms, or a clock ahead | `topic delay`: its sign; `/clock` | 09, 12 |
# | past extrapolation | slow processing, or a short buffer | the message's age compared with the cache time | 08, 09 |
# | it fails with a bag only | `/tf`, `/tf_static` or `/clock` missing | `ros2 bag info`, and `--clock` | 10 |
# | several robots' frames mixed up | prefix and namespace disagree | the whole tree in `view_frames` | 04 |
# | off by 90° or 180° | axes, rpy, the order of a quaternion | the URDF's rpy, the axes in RViz | 02, 07 |

# %% [markdown] lang="ko" name="ten" slide="skip"
# 강의 28절의 증상입니다.
#
# | 보이는 것 | 흔한 원인 | 먼저 확인할 것 | 장 |
# |---|---|---|---|
# | Fixed Frame 없음 | 잘못 입력했거나 아무도 발행하지 않음 | RViz의 목록, `view_frames` | 11 |
# | 두 좌표계가 연결되지 않음 | 사이의 연결이 빠짐 | `view_frames`의 두 루트 | 04, 09 |
# | 로봇이 떨림 | 발행자가 둘 | 연결의 발행률과 `tf2_echo … 20`, 이어서 `topic info /tf --verbose` | 12 |
# | 센서가 몸체에서 떨어져 보임 | 장착 변환의 값 | `tf2_echo base_link laser_frame`, URDF의 origin | 07, 11 |
# | 센서 자취가 벽에 번짐 | 측정 시각, 지연된 오도메트리 | `topic delay /scan`, 그다음 `tf2_monitor`(스캔은 보지 못함) | 11 |
# | 미래 외삽 | 지연된 변환, 앞선 시계 | `topic delay`의 부호, `/clock` | 09, 12 |
# | 과거 외삽 | 느린 처리, 짧은 버퍼 | 메시지의 나이와 보관 시간 | 08, 09 |
# | bag에서만 실패 | `/tf`, `/tf_static`, `/clock`이 없음 | `ros2 bag info`, `--clock` | 10 |
# | 여러 로봇의 좌표계가 섞임 | 접두사와 네임스페이스가 어긋남 | `view_frames`의 트리 전체 | 04 |
# | 방향이 90°나 180° 틀림 | 축, rpy, 쿼터니언의 순서 | URDF의 rpy, RViz의 축 | 02, 07 |

# %% [markdown] lang="en" name="twelve-heading" slide="skip"
# ## Twelve common mistakes, and their remedies

# %% [markdown] lang="ko" name="twelve-heading" slide="skip"
# ## 열두 가지 실수와 교정

# %% [markdown] lang="en" name="twelve" slide="skip"
# These are the mistakes of the lecture (section 29). The second column names the patient of the clinic that has the mistake, or the chapter if no patient has it.
#
# | the mistake | patient or chapter | remedy |
# |---|---|---|
# | numbers without a frame are used | chapter 01 | make `frame_id` a required part of every message, and reject one without it |
# | the sensor's stamp is overwritten on arrival | chapter 08; in the clinic the workaround “stamp on arrival” | keep the time of the measurement |
# | target and source of `lookup_transform` are swapped | chapter 03 | read the call as a sentence: expressed in the source, wanted in the target |
# | all four numbers of a quaternion are 0 | quaternion of zeros | no rotation is w = 1 |
# | a mount is published on `/tf` again and again | chapter 06, E12.5 | put it into the URDF, or use a static broadcaster |
# | a moving frame is published as static | chapter 06 | publish it on `/tf` again and again, with its stamp |
# | several nodes publish the same child | two owners of one edge; localizer owns the base | one owner for each transform |
# | a longer timeout hides a wrong clock | laser clock ahead, with the workaround “timeout of 1 s” | correct stamps and time source |
# | the pose in `map` is used for local control | chapter 05 | use `odom` where control needs a pose that does not jump |
# | a bag holds sensor topics only | chapter 10, E12.5 | record `/tf`, `/tf_static`, and the clock and odometry that belong to them |
# | a frame prefix is taken for the node's namespace | chapter 04, E12.5 | agree on frame names separately, and check them in the tree |
# | RViz shows nothing, so the sensor must be broken | chapter 11; in the clinic everybody's first suspect, and no patient's fault | check the Fixed Frame and the path in TF first |

# %% [markdown] lang="ko" name="twelve" slide="skip"
# 강의 29절의 실수입니다. 둘째 열은 그 실수를 한 진료실의 환자이고, 그런 환자가 없으면 그 실수를 다룬 장입니다.
#
# | 실수 | 환자 또는 장 | 교정 |
# |---|---|---|
# | 좌표계 없는 숫자를 씀 | 01장 | `frame_id`를 메시지의 필수 항목으로 두고, 없으면 거절합니다 |
# | 수신 시각으로 센서의 측정 시각을 덮음 | 08장, 진료실에서는 임시방편 “stamp on arrival” | 실제로 측정한 시각을 유지합니다 |
# | `lookup_transform`의 목표와 원본을 반대로 씀 | 03장 | 문장으로 읽어 확인합니다. 원본 기준의 데이터를 목표 기준으로 바꿉니다 |
# | 쿼터니언의 네 값이 모두 0 | quaternion of zeros | 회전이 없으면 w = 1입니다 |
# | 고정된 관계를 `/tf`로 계속 보냄 | 06장, E12.5 | URDF에 적거나 정적 발행기를 씁니다 |
# | 움직이는 관계를 정적으로 보냄 | 06장 | 측정 시각과 함께 `/tf`로 계속 보냅니다 |
# | 같은 자식을 여러 노드가 발행 | two owners of one edge, localizer owns the base | 변환마다 발행자를 하나로 정합니다 |
# | timeout만 늘려 시계 오류를 숨김 | laser clock ahead와 임시방편 “timeout of 1 s” | 측정 시각과 시간의 출처를 맞춥니다 |
# | `map` 기준 포즈를 지역 제어에 바로 씀 | 05장 | 튀지 않는 포즈가 필요한 제어에는 `odom`을 씁니다 |
# | bag에 센서만 기록 | 10장, E12.5 | `/tf`, `/tf_static`과 관련된 시계, 오도메트리도 함께 기록합니다 |
# | 좌표계 접두사를 노드의 네임스페이스와 같게 여김 | 04장, E12.5 | 좌표계 이름을 따로 정하고 트리에서 확인합니다 |
# | RViz에 안 보이면 센서 고장으로 판단 | 11장, 진료실에서는 누구나 먼저 의심하지만 그런 환자는 없음 | 고정 좌표계와 TF의 경로부터 확인합니다 |

# %% [markdown] lang="en" name="from-before-heading" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before" slide="-"
# 1. A localiser finds the robot on the map. Which edge does it publish, and from which two poses?
# 2. A driver publishes its mount on `/tf_static` with VOLATILE. Why does a tf2 listener not receive it, even one that existed before?
# 3. “Extrapolation into the future”: which two times do you compare?
#
# <details><summary>Answers</summary>
#
# 1. `map → odom`, from `map_T_base` and the wheel odometry's `odom_T_base` at the same stamp.
# 2. A tf2 listener requests TRANSIENT_LOCAL. A volatile publisher offers less, so the two are never connected.
# 3. The requested time, and the newest stamp of an edge on the path.
#
# </details>

# %% [markdown] lang="ko" name="from-before" slide="-"
# 1. 위치 추정 노드가 지도에서 로봇을 찾았습니다. 어느 연결을, 어떤 두 포즈로 구해 발행합니까?
# 2. 드라이버가 `/tf_static`에 장착 변환을 VOLATILE로 발행합니다. 먼저 참가한 tf2 수신기도 받지 못하는 까닭은 무엇입니까?
# 3. “Extrapolation into the future”에서 비교하는 두 숫자는 무엇입니까?
#
# <details><summary>답</summary>
#
# 1. `map → odom`입니다. 같은 시각의 `map_T_base`와 오도메트리의 `odom_T_base`로 구합니다.
# 2. tf2 수신기는 TRANSIENT_LOCAL을 요청합니다. VOLATILE 발행자는 그만큼 제공하지 않으므로 둘은 연결되지 않습니다.
# 3. 요청 시각과, 경로에 있는 한 연결의 최신 표본 시각입니다.
#
# </details>

# %% [markdown] lang="en" name="from-before-notes" slide="notes"
# For home; the first one aloud if a minute is left.

# %% [markdown] lang="ko" name="from-before-notes" slide="notes"
# 집에서 합니다. 1분이 남으면 첫 문제만 소리 내어 풉니다.

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice questions · Q4, Q14 and Q15

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제 · Q4, Q14, Q15

# %% [markdown] lang="en" name="practice" slide="-"
# **4.** Two nodes publish the same child. What can be seen? Write three or four sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] No error: TF2 stores every sample, whichever node sends it.
# - [ ] With the same parent the pose alternates, and a lookup in between gives a position that no node published.
# - [ ] With different parents the tree itself changes, and a part of it is unreachable now and then.
# - [ ] `view_frames` shows one parent; the edge's rate and values at 20 Hz show the second owner.
#
# </details>
#
# **14.** How are the transforms divided between URDF, odometry, EKF and localisation? Write three or four sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] URDF, through robot_state_publisher: every mount and every joint, and no driver repeats it.
# - [ ] Odometry *or* the EKF: `odom → base_footprint`; with the EKF, the switch of the wheel odometry is off, and /odom continues as data.
# - [ ] Localisation: `map → odom`, and never the base.
# - [ ] One owner for each edge, written down as node, source and switch.
#
# </details>
#
# **15.** A wall smears while the robot drives. In which order do you look? Name at least five steps.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] Fixed Frame and names, then the tree.
# - [ ] The mount's value, at rest.
# - [ ] Delays and rates of the edges, and the scan's own frame, stamp and clock.
# - [ ] Publishers and their switches last.
# - [ ] Neither a new sensor nor a longer timeout is among them, because neither is a check.
#
# </details>

# %% [markdown] lang="ko" name="practice" slide="-"
# **4.** 같은 자식을 두 노드가 발행하면 어떤 증상이 나타납니까? 서너 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 오류는 나지 않습니다. TF2는 누가 발행하든 표본을 모두 저장합니다.
# - [ ] 부모가 같으면 포즈가 오락가락하고, 그 사이를 조회하면 아무도 발행한 적 없는 위치가 나옵니다.
# - [ ] 부모가 다르면 트리의 모양이 번갈아 바뀌고, 그때마다 한쪽이 떨어져 나갑니다.
# - [ ] `view_frames`에는 부모가 하나만 보입니다. 두 번째 발행자는 연결의 발행률과 20 Hz로 조회한 값에서 드러납니다.
#
# </details>
#
# **14.** URDF, 오도메트리, EKF, 위치 추정은 변환의 발행 책임을 어떻게 나눕니까? 서너 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] URDF는 robot_state_publisher를 통해 고정된 것과 관절을 모두 맡고, 드라이버는 같은 변환을 다시 보내지 않습니다.
# - [ ] `odom → base_footprint`는 오도메트리나 EKF *가운데 하나*가 맡습니다. EKF가 융합하면 바퀴 오도메트리 노드의 스위치를 끄고, /odom은 데이터로 계속 보냅니다.
# - [ ] 위치 추정은 `map → odom`을 맡고, base는 건드리지 않습니다.
# - [ ] 연결마다 발행자는 하나이고, 노드와 데이터와 스위치를 적어 둡니다.
#
# </details>
#
# **15.** 로봇이 달릴 때 벽이 번집니다. 어떤 순서로 살펴봅니까? 다섯 단계 이상 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 고정 좌표계와 이름, 그다음 트리를 봅니다.
# - [ ] 서 있을 때 장착 변환의 값을 봅니다.
# - [ ] 연결의 지연과 발행률, 그리고 스캔의 좌표계, 측정 시각, 시계를 봅니다.
# - [ ] 발행자와 스위치는 마지막입니다.
# - [ ] 새 센서와 긴 timeout은 들어 있지 않습니다. 원인을 알려 주지 않기 때문입니다.
#
# </details>

# %% [markdown] lang="en" name="practice-notes" slide="notes"
# Written at home. Question 15 is graded by its order as well as by its steps.

# %% [markdown] lang="ko" name="practice-notes" slide="notes"
# 집에서 씁니다. 15번은 단계뿐 아니라 순서도 봅니다.
