# %% [markdown] lang="en" name="title" slide="slide"
# # From here to a robot
#
# 20 minutes. Your nodes run in this workbook. Here you put them into a package for a robot, see what is different there, and learn which five commands to type first on a robot that you have never seen.
# The page builds on all chapters, and nothing on it counts for marks.
# Commands in grey boxes are for a terminal. You need no robot to read on.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 이제 로봇으로
#
# 20분. 지금까지 만든 노드는 이 워크북 안에서 실행되었습니다. 여기서는 노드를 로봇에 올릴 패키지로 만들고, 로봇에서 무엇이 달라지는지 알아보고, 처음 보는 로봇에서 가장 먼저 입력할 다섯 명령을 익힙니다.
# 모든 장을 바탕으로 하며, 점수에는 들어가지 않습니다.
# 회색 상자의 명령은 터미널에서 입력하는 것입니다. 로봇이 없어도 읽을 수 있습니다.

# %% [markdown] lang="en" name="install" slide="slide"
# ## Install ROS 2 on the robot's computer
#
# ROS 2 Jazzy, the default release of this book, runs on Ubuntu 24.04.
# A robot that came with Humble (Ubuntu 22.04) stays with Humble: read `humble` for `jazzy` below.
# How to add the package source of ROS is described on docs.ros.org under "Installation". Then install these:
#
# | Ubuntu package | what for |
# |---|---|
# | `ros-jazzy-ros-base` | the robot's computer: rclpy, tf2, robot_state_publisher, rosbag2 |
# | `ros-jazzy-desktop` | your laptop: the same, and RViz |
# | `ros-jazzy-tf2-tools` | `view_frames` |
# | `ros-dev-tools` | `colcon`, which builds packages, and `rosdep`, which installs what they need |
# | `chrony` | the same time on all computers |

# %% [markdown] lang="ko" name="install" slide="slide"
# ## 로봇의 컴퓨터에 ROS 2 설치하기
#
# 이 책의 기본 배포판인 ROS 2 Jazzy는 Ubuntu 24.04에 설치합니다.
# Humble(Ubuntu 22.04)이 설치되어 온 로봇은 그대로 두고, 아래의 `jazzy`를 `humble`로 바꾸어 읽으십시오.
# ROS의 패키지 저장소를 추가하는 방법은 docs.ros.org의 “Installation”에 있습니다. 그다음 아래 패키지를 설치합니다.
#
# | Ubuntu 패키지 | 용도 |
# |---|---|
# | `ros-jazzy-ros-base` | 로봇의 컴퓨터: rclpy, tf2, robot_state_publisher, rosbag2 |
# | `ros-jazzy-desktop` | 노트북 컴퓨터: 위의 것과 RViz |
# | `ros-jazzy-tf2-tools` | `view_frames` |
# | `ros-dev-tools` | 패키지를 빌드하는 `colcon`, 필요한 패키지를 설치하는 `rosdep` |
# | `chrony` | 모든 컴퓨터의 시계 맞추기 |

# %% [markdown] lang="en" name="package" slide="slide"
# ## Turn your nodes into a package
#
# `ros2 run` starts the executables of a package. It does not start files.
# Put the nodes that you saved from the chapters into a folder `tf_lab_py`, open a terminal (*File* → *New* → *Terminal*), and type:
#
# ```
# tflab package tf_lab_py
# cd ros2_ws
# tflab ros2 launch tf_lab_py tf_lab_py.launch.py    # does it run here? Ctrl-C ends it
# ```
#
# The first line writes `ros2_ws/src/tf_lab_py`. The folder `ros2_ws` is a *workspace*: `colcon` builds the packages in its `src`. Your own files stay as they are.
# `package.xml` lists the packages that your nodes import, `setup.py` has an executable for each `main()`, and beside them are a launch file, a URDF and a test.
# Copy the folder `ros2_ws` to the robot, and type there:
#
# ```
# source /opt/ros/jazzy/setup.bash
# cd ros2_ws
# sudo rosdep init && rosdep update                  # once on a computer
# rosdep install --from-paths src --ignore-src -y    # installs what package.xml lists
# colcon build --symlink-install
# source install/setup.bash                          # again in every new terminal
# ros2 run tf_lab_py static_sensor_broadcaster
# ```
#
# `source` reads settings into one terminal, so each new terminal needs it again.
# After `--symlink-install` you can edit a node without building again.
# `Package 'tf_lab_py' not found` usually means that `source install/setup.bash` was not run in this terminal.

# %% [markdown] lang="ko" name="package" slide="slide"
# ## 내 노드를 패키지로 만들기
#
# `ros2 run`은 패키지의 실행 파일을 시작하며, 파일을 바로 시작하지는 않습니다.
# 각 장에서 저장한 노드를 `tf_lab_py` 폴더에 모으고, 터미널(*File* → *New* → *Terminal*)을 열어 입력해 보세요.
#
# ```
# tflab package tf_lab_py
# cd ros2_ws
# tflab ros2 launch tf_lab_py tf_lab_py.launch.py    # 여기서 먼저 실행, 끝낼 때는 Ctrl-C
# ```
#
# 첫 줄이 `ros2_ws/src/tf_lab_py`를 만듭니다. `ros2_ws` 폴더는 작업 공간(workspace)이고, `colcon`이 그 안의 `src`에 있는 패키지를 빌드합니다. 원래 파일은 그대로입니다.
# `package.xml`에는 노드가 임포트하는 패키지가, `setup.py`에는 `main()`마다 실행 파일 하나가 적혀 있습니다. 런치 파일, URDF, 테스트도 들어 있습니다.
# `ros2_ws` 폴더를 로봇에 복사하고, 로봇에서 입력합니다.
#
# ```
# source /opt/ros/jazzy/setup.bash
# cd ros2_ws
# sudo rosdep init && rosdep update                  # 컴퓨터마다 한 번
# rosdep install --from-paths src --ignore-src -y    # package.xml에 적힌 패키지 설치
# colcon build --symlink-install
# source install/setup.bash                          # 새 터미널을 열 때마다
# ros2 run tf_lab_py static_sensor_broadcaster
# ```
#
# `source`는 그 터미널에만 설정을 읽어 들이므로, 새 터미널마다 다시 실행해야 합니다.
# `--symlink-install`로 빌드했다면 노드를 고친 뒤 다시 빌드하지 않아도 됩니다.
# `Package 'tf_lab_py' not found`가 나오면, 대개 그 터미널에서 `source install/setup.bash`를 실행하지 않은 것입니다.

# %% [markdown] lang="en" name="differs" slide="slide"
# ## What is different on a robot
#
# | here | on a robot | so |
# |---|---|---|
# | Time is simulated and stops between commands. | Time never stops, and no two runs are the same. | Look up at the stamp of the message, with a short timeout. Handle all three exceptions. |
# | All nodes are in one process. | DDS finds the nodes over the network, which takes a second or two. | Do not expect a transform in the constructor. Another robot on the network gets another `ROS_DOMAIN_ID`. |
# | Nearly all messages arrive. | Wi-Fi loses and delays messages. | Transform on the computer to which the sensor is connected. |
# | The [[qos]] settings of the nodes fit. | Many drivers offer `BEST_EFFORT`. A subscription that requests `RELIABLE` receives nothing. | Compare both sides with `ros2 topic info /scan --verbose`. |
# | There is one clock, unless a page adds one. | Each computer has its own clock. | Synchronise them with `chrony` (below). |
# | A wrong transform moves an arrow. | A wrong transform moves a robot. | Wheels off the ground, the emergency stop in your hand. |
#
# The robot's computer serves the time, and all others take it from there, also without internet. Restart `chrony` after the change. The offset that `chronyc tracking` prints must be much smaller than the time between two transforms.
#
# ```
# allow 192.168.0.0/16             # robot: /etc/chrony/chrony.conf
# local stratum 10                 # robot: serves the time also without internet
# server ROBOTS_ADDRESS iburst     # the other computers, in the same file
# ```

# %% [markdown] lang="ko" name="differs" slide="slide"
# ## 로봇에서는 무엇이 다를까요?
#
# | 여기서는 | 로봇에서는 | 그래서 |
# |---|---|---|
# | 가상의 시간이고, 명령과 명령 사이에는 멈춥니다. | 시간이 멈추지 않고, 실행할 때마다 결과가 다릅니다. | 메시지의 측정 시각으로, 짧은 timeout을 두고 조회하십시오. 세 예외를 모두 처리하십시오. |
# | 모든 노드가 한 프로세스에 있습니다. | DDS가 네트워크에서 노드를 찾으며, 1~2초가 걸립니다. | 생성자에서 바로 변환을 조회하지 마십시오. 같은 네트워크의 다른 로봇에는 다른 `ROS_DOMAIN_ID`를 주십시오. |
# | 메시지가 거의 모두 도착합니다. | Wi-Fi에서는 메시지가 사라지거나 지연됩니다. | 센서가 연결된 컴퓨터에서 변환하십시오. |
# | 노드들의 [[qos|QoS]] 설정이 서로 맞습니다. | 많은 드라이버가 `BEST_EFFORT`를 제공합니다. `RELIABLE`을 요청한 구독자는 아무것도 받지 못합니다. | `ros2 topic info /scan --verbose`로 양쪽을 비교하십시오. |
# | 페이지에서 더하지 않는 한 시계는 하나입니다. | 컴퓨터마다 시계가 있습니다. | `chrony`로 맞추십시오(아래). |
# | 변환이 틀리면 화살표가 움직입니다. | 변환이 틀리면 로봇이 움직입니다. | 바퀴를 바닥에서 띄우고, 비상 정지 버튼을 손에 쥐십시오. |
#
# 시계는 로봇의 컴퓨터를 기준으로 삼고 나머지 컴퓨터를 거기에 맞춥니다. 인터넷이 없어도 됩니다. 설정을 바꾼 뒤에는 `chrony`를 다시 시작하십시오. `chronyc tracking`에 나오는 차이는 변환의 발행 간격보다 훨씬 작아야 합니다.
#
# ```
# allow 192.168.0.0/16             # 로봇: /etc/chrony/chrony.conf
# local stratum 10                 # 로봇: 인터넷이 없어도 시각을 알려 줌
# server ROBOTS_ADDRESS iburst     # 다른 컴퓨터: 같은 파일
# ```

# %% [markdown] lang="en" name="first-five" slide="slide"
# ## Five commands for a robot that you have never seen
#
# ```
# 1  ros2 node list
# 2  ros2 run tf2_ros tf2_echo base_link laser_frame
# 3  ros2 topic delay /scan
# 4  ros2 run tf2_tools view_frames
# 5  ros2 topic info /tf --verbose
# ```
#
# **Predict:** which of the five commands finds a wrong clock? Which one helps to find that somebody has moved the laser and not changed the URDF?
# Then run them, here on the simulated robot.

# %% [markdown] lang="ko" name="first-five" slide="slide"
# ## 처음 보는 로봇에서 입력할 다섯 명령
#
# ```
# 1  ros2 node list
# 2  ros2 run tf2_ros tf2_echo base_link laser_frame
# 3  ros2 topic delay /scan
# 4  ros2 run tf2_tools view_frames
# 5  ros2 topic info /tf --verbose
# ```
#
# **예측해 봅시다.** 다섯 명령 가운데 틀린 시계를 찾아내는 것은 무엇일까요? 누군가 레이저를 옮기고 URDF는 고치지 않았다면 어느 명령이 도움이 될까요?
# 예측한 다음 시뮬레이션 로봇에서 실행해 보세요.

# %% name="robot" tags=["collapsed"]
# %load_ext tflab
from tflab.workbook import lesson

nodes = lesson.launch(lesson.new_graph())

# %% [markdown] lang="en" name="nodes-why" slide="skip"
# **1. Which nodes run?** Look for the driver of each sensor, for odometry and for localisation.

# %% [markdown] lang="ko" name="nodes-why" slide="skip"
# **1. 어떤 노드가 있습니까?** 센서의 드라이버, 오도메트리, 위치 추정 노드를 찾습니다.

# %% name="nodes"
# %ros2 node list

# %% [markdown] lang="en" name="mount-why" slide="skip"
# **2. Where does TF have the sensor?** Compare the numbers with a tape measure.

# %% [markdown] lang="ko" name="mount-why" slide="skip"
# **2. TF에서 센서는 어디에 있습니까?** 줄자로 잰 값과 비교합니다.

# %% name="mount" tags=["predicted"]
# %ros2 --for 2 run tf2_ros tf2_echo base_link laser_frame

# %% [markdown] lang="en" name="clock-why" slide="skip"
# **3. How old is the data on arrival?** A negative delay, or one that is too long, points to a clock.

# %% [markdown] lang="ko" name="clock-why" slide="skip"
# **3. 데이터는 얼마나 늦게 도착합니까?** 지연이 음수이거나 너무 길면 시계를 의심합니다.

# %% name="clock" tags=["predicted"]
# %ros2 topic delay /scan

# %% [markdown] lang="en" name="frames-why" slide="skip"
# **4. Is it one tree?** Look for one root, the right names, and a plausible rate of each edge.

# %% [markdown] lang="ko" name="frames-why" slide="skip"
# **4. 트리가 하나입니까?** 루트가 하나인지, 이름이 맞는지, 연결마다 발행률이 알맞은지 봅니다.

# %% name="frames"
# %ros2 run tf2_tools view_frames

# %% [markdown] lang="en" name="owners-why" slide="skip"
# **5. Which nodes have a publisher on `/tf`?** Each edge has one [[owner]]. Begin your table of owners with these names.

# %% [markdown] lang="ko" name="owners-why" slide="skip"
# **5. 어떤 노드에 `/tf`의 발행기가 있습니까?** 연결마다 [[owner|발행 책임]]은 한 노드에 있습니다. 이 이름들로 발행 책임표를 쓰기 시작하십시오.

# %% name="owners"
# %ros2 topic info /tf --verbose

# %% [markdown] lang="en" name="five-seen" slide="skip" tags=["predicted"]
# The third command finds a wrong clock. The second one helps with the moved laser, but only together with a tape measure, because TF repeats what the URDF contains.

# %% [markdown] lang="ko" name="five-seen" slide="skip" tags=["predicted"]
# 틀린 시계는 셋째 명령이 찾아냅니다. 옮겨진 레이저에는 둘째 명령이 도움이 되지만, 줄자가 있어야 합니다. TF는 URDF에 적힌 값을 그대로 알려 줄 뿐입니다.

# %% [markdown] lang="en" name="checklist" slide="slide"
# ## What only a robot can tick off
#
# In the chapters you did each item of the checklist in simulation. Do these again on a robot:
#
# | item | what the simulation could not show you | command |
# |---|---|---|
# | C2 | a mount that is not as drawn | `ros2 run tf2_ros tf2_echo base_link laser_frame` |
# | C5 | a tree that somebody else has built | `ros2 run tf2_tools view_frames` |
# | C6 | the delay of your own network | `ros2 run tf2_ros tf2_monitor map base_link` |
# | C7 | RViz's own window | `rviz2` |
# | C11 | that `use_sim_time` is false everywhere | `ros2 param get /NODE use_sim_time` |
# | C12 | a bag that you can take home | `ros2 bag record /scan /odom /tf /tf_static` |
# | C14 | the owners on a robot that others have configured | `ros2 topic info /tf --verbose` |
#
# Type `tflab progress` for the commands of all items. Take the bag home: `tflab doctor BAG` examines it.

# %% [markdown] lang="ko" name="checklist" slide="slide"
# ## 로봇에서만 마칠 수 있는 것
#
# 체크리스트의 항목은 각 장에서 시뮬레이션으로 해 보았습니다. 아래 항목은 로봇에서 다시 해 보세요.
#
# | 항목 | 시뮬레이션에서 볼 수 없었던 것 | 명령 |
# |---|---|---|
# | C2 | 도면과 다른 장착 변환 | `ros2 run tf2_ros tf2_echo base_link laser_frame` |
# | C5 | 다른 사람이 만든 트리 | `ros2 run tf2_tools view_frames` |
# | C6 | 내 네트워크의 지연 | `ros2 run tf2_ros tf2_monitor map base_link` |
# | C7 | RViz의 실제 창 | `rviz2` |
# | C11 | 모든 노드에서 `use_sim_time`이 false인지 | `ros2 param get /NODE use_sim_time` |
# | C12 | 가져올 수 있는 bag | `ros2 bag record /scan /odom /tf /tf_static` |
# | C14 | 다른 사람이 설정한 로봇의 발행 책임 | `ros2 topic info /tf --verbose` |
#
# 모든 항목의 명령은 `tflab progress`로 볼 수 있습니다. 기록한 bag을 가져와 `tflab doctor BAG`으로 진단해 보세요.

# %% name="stop" slide="skip" tags=["collapsed"]
lesson.current_graph().stop()
