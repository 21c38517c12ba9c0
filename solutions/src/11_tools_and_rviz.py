# %% [markdown] lang="en" name="title"
# # Exercises 11 · Tools and RViz
#
# Seven tasks, 22 points, about 45 minutes. The page they belong to: [11 · Tools and RViz](../../notebooks/en/11_tools_and_rviz.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E11.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E11.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# What `task(...)` prints may differ from your neighbour's, so answer with an expression, and not with a number that you calculated elsewhere.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 11 · 도구와 RViz
#
# 과제 일곱 개, 22점, 약 45분입니다. 함께 보는 페이지: [11 · 도구와 RViz](../../notebooks/ko/11_tools_and_rviz.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E11.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E11.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# `task(...)`가 출력하는 값은 옆 사람과 다를 수 있습니다. 그러니 따로 계산한 숫자가 아니라 식으로 답해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math
import re

# %% [markdown] lang="en" name="e11-1"
# ## E11.1 · Which tool for which question? (3 points)
#
# Eight questions. Answer each with `"view_frames"`, `"tf2_echo"`, `"tf2_monitor"`, `"topic hz"`, `"topic delay"`, `"topic info --verbose"`, `"RViz"` or, if none of them answers it, `"no ROS 2 tool"`. `/tf` has several publishers.
#
# - **trees** Are all frames in one tree?
# - **edge rate** How often is `odom → base_footprint` published?
# - **height** How high above `base_link` is the laser in TF?
# - **chain** How late is the data of the path from `map` to `laser_frame`?
# - **scan** How old is a scan when it arrives?
# - **on tf** Which nodes publish on `/tf`?
# - **sender** Which node sends `odom → base_footprint`?
# - **wall** Is the scan on the map's walls?

# %% [markdown] lang="ko" name="e11-1"
# ## E11.1 · 어떤 질문에 어떤 도구를 씁니까? (3점)
#
# 질문 여덟 개에 각각 `"view_frames"`, `"tf2_echo"`, `"tf2_monitor"`, `"topic hz"`, `"topic delay"`, `"topic info --verbose"`, `"RViz"` 가운데 하나로 답하십시오. 알려 주는 도구가 없으면 `"no ROS 2 tool"`입니다. `/tf`에는 발행자가 여럿입니다.
#
# - **trees** 모든 좌표계가 한 트리에 있습니까?
# - **edge rate** `odom → base_footprint`의 발행률은 얼마입니까?
# - **height** TF에 따르면 레이저는 `base_link`보다 얼마나 높이 있습니까?
# - **chain** 경로 `map ← laser_frame`의 지연은 얼마입니까?
# - **scan** 스캔은 도착했을 때 얼마나 오래된 것입니까?
# - **on tf** 어느 노드들이 `/tf`에 발행합니까?
# - **sender** 어느 노드가 `odom → base_footprint`를 발행합니까?
# - **wall** 스캔이 지도의 벽 위에 놓입니까?

# %% name="e11-1-answer" tags=["answer"]
tools = {
    # BEGIN SOLUTION
    "trees": "view_frames",
    "edge rate": "view_frames",
    "height": "tf2_echo",
    "chain": "tf2_monitor",
    "scan": "topic delay",
    "on tf": "topic info --verbose",
    "sender": "no ROS 2 tool",
    "wall": "RViz",
    # END SOLUTION
}

# %% name="e11-1-check" tags=["check"]
check("E11.1", tools)

# %% [markdown] lang="en" name="e11-2"
# ## E11.2 · Two readings of tf2_echo (3 points)
#
# `first` and `second` are two consecutive outputs of `tf2_echo map base_link`.
#
# - `"speed_mps"`: the straight distance between the two positions, divided by the time between the two stamps [m/s];
# - `"yaw_rate_radps"`: the rotation between the two, divided by that time, positive to the left [rad/s];
# - `"stamp_s"`: the stamp of the second reading, in seconds.

# %% [markdown] lang="ko" name="e11-2"
# ## E11.2 · tf2_echo의 두 출력 (3점)
#
# `first`와 `second`는 `tf2_echo map base_link`가 잇달아 출력한 것입니다. 그 사이의 움직임을 답하십시오.
#
# - `"speed_mps"`: 두 위치 사이의 직선 거리를 두 측정 시각의 간격으로 나눈 값 [m/s]
# - `"yaw_rate_radps"`: 회전 속도, 왼쪽이 양수 [rad/s]
# - `"stamp_s"`: 둘째 출력의 측정 시각 [s]

# %% name="e11-2-given"
e11_2 = task("E11.2")

# %% name="e11-2-answer" tags=["answer"]
# BEGIN SOLUTION
_readings = []
for block in (e11_2.first, e11_2.second):
    head, place, _, turn, *_ = block.splitlines()
    sec, nanosec = head.removeprefix("At time ").split(".")
    x, y, _ = map(float, re.findall(r"-?\d+\.\d+", place))
    yaw = float(re.findall(r"-?\d+\.\d+", turn)[2])
    _readings.append((int(sec) + int(nanosec) / 1e9, x, y, yaw))
(_start_s, _x_0, _y_0, _yaw_0), (stamp_s, _x_1, _y_1, _yaw_1) = _readings
speed_mps = math.hypot(_x_1 - _x_0, _y_1 - _y_0) / (stamp_s - _start_s)
yaw_rate_radps = (_yaw_1 - _yaw_0) / (stamp_s - _start_s)
# END SOLUTION
motion = {"speed_mps": speed_mps, "yaw_rate_radps": yaw_rate_radps, "stamp_s": stamp_s}

# %% name="e11-2-check" tags=["check"]
check("E11.2", motion)

# %% [markdown] lang="en" name="e11-3"
# ## E11.3 · Often enough? (4 points)
#
# A robot's card gives the rates at which two of its nodes publish on `/tf` (`sends_hz`); the third and last is the odometry. `ros2 topic hz /tf` prints `hz_of_tf`. `report` is the first report of `tf2_monitor map laser_frame`. The robot drives a curve (`speed_mps`, `yaw_rate_radps`).
#
# - `"odometry_hz"`: how often does the odometry publish [Hz]?
# - `"late_s"`: how late is the path at worst [s]?
# - `"off_mm"`: how far is TF's straight line from the robot's arc at worst, between two samples of the odometry [mm]?
# - `"wait_s"`: how long does a scan have to wait for the odometry at worst, after it has arrived [s]? A transform takes `transform_travels_s` to arrive, a scan `scan_travels_s`.
# - `"enough"`: is `off_mm` within `allowed_mm`, `"yes"` or `"no"`?

# %% [markdown] lang="ko" name="e11-3"
# ## E11.3 · 발행률은 충분합니까? (4점)
#
# `/tf`에 발행하는 노드는 셋입니다. 로봇의 카드에는 그 가운데 둘의 발행률이 적혀 있고(`sends_hz`), 나머지 하나가 오도메트리 노드입니다. `ros2 topic hz /tf`는 `hz_of_tf`를 출력합니다. `report`는 `tf2_monitor map laser_frame`의 첫 보고입니다. 로봇은 굽은 길을 달립니다(`speed_mps`, `yaw_rate_radps`).
#
# - `"odometry_hz"`: 오도메트리의 발행률은 얼마입니까[Hz]?
# - `"late_s"`: 경로의 지연은 최악의 경우 얼마입니까[s]?
# - `"off_mm"`: 오도메트리의 두 표본 사이에서 TF의 직선은 로봇의 호에서 최대 얼마나 떨어집니까[mm]?
# - `"wait_s"`: 도착한 스캔은 오도메트리를 최대 얼마나 기다려야 합니까[s]? 변환이 오는 데 `transform_travels_s`, 스캔이 오는 데 `scan_travels_s`가 걸립니다.
# - `"enough"`: `off_mm`이 `allowed_mm` 안에 듭니까? `"yes"` 또는 `"no"`.

# %% name="e11-3-given"
e11_3 = task("E11.3")

# %% name="e11-3-answer" tags=["answer"]
# BEGIN SOLUTION
odometry_hz = e11_3.hz_of_tf - sum(e11_3.sends_hz.values())
late_s = float(re.search(r"max = (\S+)", e11_3.report)[1])
_v, _w = e11_3.speed_mps, e11_3.yaw_rate_radps
off_mm = 1000 * _v / _w * (1 - math.cos(_w / (2 * odometry_hz)))
wait_s = max(0.0, 1 / odometry_hz + e11_3.transform_travels_s - e11_3.scan_travels_s)
enough = "yes" if off_mm <= e11_3.allowed_mm else "no"
# END SOLUTION
verdict = {"odometry_hz": odometry_hz, "late_s": late_s, "off_mm": off_mm, "wait_s": wait_s, "enough": enough}

# %% name="e11-3-check" tags=["check"]
check("E11.3", verdict)

# %% [markdown] lang="en" name="e11-4"
# ## E11.4 · Six robots in RViz (4 points)
#
# `robot_a` to `robot_f` contain RViz's list for six robots; if all is Ok, a sentence describes the picture. The Fixed Frame should be `map`.
# For each robot give the likeliest cause (`"a"`) and the first check (`"a check"`). Some of these fit no robot, some more than one:
#
# - `"localiser down"`, `"Fixed Frame misspelt"`, `"joint states missing"`, `"odometry down"`, `"stamps late"`, `"mount wrong"`, `"sensor broken"` or `"nothing wrong"`;
# - `"ros2 node list"`, `"the name in RViz"`, `"ros2 topic hz /joint_states"`, `"ros2 topic delay /scan"`, `"tf2_echo base_link laser_frame"`, `"replace the sensor"`, `"a longer timeout"` or `"no check"`.
#
# The answer cell gives each of these words a name, so that you need not type it: `"a": stamps_late`.

# %% [markdown] lang="ko" name="e11-4"
# ## E11.4 · RViz에 보이는 로봇 여섯 대 (4점)
#
# `robot_a`부터 `robot_f`까지는 로봇 여섯 대의 RViz 목록입니다. 모두 Ok이면 무엇이 보이는지 한 문장으로 적었습니다(the scan lies on / beside the walls = 스캔이 벽 위에 / 옆에 놓인다, standing still = 서 있을 때, in bends it smears = 굽은 길에서 번진다). 고정 좌표계(Fixed Frame)는 `map`이어야 합니다.
# 로봇마다 가장 그럴듯한 원인(`"a"`)과 첫 점검(`"a check"`)을 고르십시오. 어느 로봇에도 맞지 않는 것이 있고, 둘 이상에 맞는 것도 있습니다.
#
# - 원인: `"localiser down"`(위치 추정 노드 멈춤), `"Fixed Frame misspelt"`(잘못 입력), `"joint states missing"`(관절 상태 없음), `"odometry down"`(오도메트리 멈춤), `"stamps late"`(측정 시각이 틀림), `"mount wrong"`(장착 변환이 틀림), `"sensor broken"`(센서 고장), `"nothing wrong"`(이상 없음)
# - 점검: `"ros2 node list"`, `"the name in RViz"`(RViz에 입력한 이름), `"ros2 topic hz /joint_states"`, `"ros2 topic delay /scan"`, `"tf2_echo base_link laser_frame"`, `"replace the sensor"`(센서 교체), `"a longer timeout"`(더 긴 timeout), `"no check"`(점검 안 함)
#
# 답 셀에는 이 문구가 변수로 정의되어 있으니 `"a": stamps_late`처럼 변수 이름을 쓰십시오.

# %% name="e11-4-given"
e11_4 = task("E11.4")

# %% name="e11-4-answer" tags=["answer"]
localiser_down, fixed_frame_misspelt, odometry_down = "localiser down", "Fixed Frame misspelt", "odometry down"
joint_states_missing, stamps_late, mount_wrong = "joint states missing", "stamps late", "mount wrong"
sensor_broken, nothing_wrong, node_list, name_in_rviz = "sensor broken", "nothing wrong", "ros2 node list", "the name in RViz"
hz_of_joint_states, delay_of_scan = "ros2 topic hz /joint_states", "ros2 topic delay /scan"
echo_of_laser, replace_the_sensor = "tf2_echo base_link laser_frame", "replace the sensor"
a_longer_timeout, no_check = "a longer timeout", "no check"
findings = {"a": ..., "a check": ..., "b": ..., "b check": ..., "c": ..., "c check": ...,
            "d": ..., "d check": ..., "e": ..., "e check": ..., "f": ..., "f check": ...}
# BEGIN SOLUTION
_signs = (("  map: No transform", fixed_frame_misspelt, name_in_rviz), ("does not exist", localiser_down, node_list),
          ("same tree", odometry_down, node_list), ("RobotModel: Error", joint_states_missing, hz_of_joint_states),
          ("smears", stamps_late, delay_of_scan), ("beside the walls", mount_wrong, echo_of_laser))
for robot, said in vars(e11_4).items():
    findings[robot[-1]], findings[f"{robot[-1]} check"] = next(row[1:] for row in _signs if row[0] in said)
# END SOLUTION

# %% name="e11-4-check" tags=["check"]
check("E11.4", findings)

# %% [markdown] lang="en" name="e11-5"
# ## E11.5 · What does the Fixed Frame change? (2 points)
#
# You change RViz's Fixed Frame from `map` to `odom`. If the tree is broken, you change it to a frame of the other tree. Answer each with `"changes"` or `"stays"`.
#
# - **screen** where on the screen the laser is drawn
# - **pose in odom** the output of `tf2_echo odom base_link`
# - **ranges** the numbers in the scan's message
# - **errors** which displays can be shown at all
# - **localiser** by how much the localiser corrects `map → odom`
# - **planner** in which frame the planner keeps its goal

# %% [markdown] lang="ko" name="e11-5"
# ## E11.5 · 고정 좌표계를 바꾸면 무엇이 바뀝니까? (2점)
#
# RViz의 고정 좌표계(Fixed Frame)를 `map`에서 `odom`으로, 트리가 끊겼을 때는 다른 트리의 좌표계로 바꿉니다. `"changes"`(바뀐다)입니까, `"stays"`(그대로다)입니까?
#
# - **screen** 레이저가 화면에 그려지는 자리
# - **pose in odom** `tf2_echo odom base_link`의 출력
# - **ranges** 스캔 메시지 속의 숫자
# - **errors** 어떤 디스플레이를 그릴 수 있는지
# - **localiser** 위치 추정 노드가 `map → odom`을 바로잡는 크기
# - **planner** 경로 계획 노드가 목적지를 보관하는 좌표계

# %% name="e11-5-answer" tags=["answer"]
changes = {
    # BEGIN SOLUTION
    "screen": "changes",
    "pose in odom": "stays",
    "ranges": "stays",
    "errors": "changes",
    "localiser": "stays",
    "planner": "stays",
    # END SOLUTION
}

# %% name="e11-5-check" tags=["check"]
check("E11.5", changes)

# %% [markdown] lang="en" name="e11-6"
# ## E11.6 · Parse the output of tf2_monitor (4 points)
#
# `report` is the output of `tf2_monitor A B`, as one text; `static_frames` are the names of the frames that are children of a static transform. Return a dict:
#
# - `"late"`: of the frames that move, the one with the largest maximum delay;
# - `"future"`: a list of the frames that move and whose stamps are in the future on average;
# - `"delay_s"`: how late the whole path was at worst [s].

# %% [markdown] lang="ko" name="e11-6"
# ## E11.6 · 프로그램으로 tf2_monitor 읽기 (4점)
#
# `report`는 `tf2_monitor A B`의 출력 전체이고, `static_frames`는 정적 변환의 자식인 좌표계의 이름들입니다. dict를 반환하십시오.
#
# - `"late"`: 동적 좌표계 가운데 최악의 경우 지연이 가장 큰 것
# - `"future"`: 동적 좌표계 가운데 측정 시각이 평균적으로 미래인 것의 리스트
# - `"delay_s"`: 경로 전체의 지연이 최악의 경우 얼마인지 [s]


# %% name="e11-6-answer" tags=["answer"]
def read_monitor(report, static_frames):
    """Return {"late", "future", "delay_s"}."""
    # BEGIN SOLUTION
    averages, largest = {}, {}
    for line in report.splitlines():
        if line.startswith("Frame: "):
            name, _, average, worst = (part.split(": ")[-1] for part in line.split(", "))
            if name not in static_frames:
                averages[name], largest[name] = float(average), float(worst)
        elif line.startswith("Net delay"):
            delay_s = float(line.split("max = ")[1])
    future = [name for name, average in averages.items() if average < 0]
    return {"late": max(largest, key=largest.get), "future": future, "delay_s": delay_s}
    # END SOLUTION


# %% name="e11-6-check" tags=["check"]
check("E11.6", read_monitor)

# %% [markdown] lang="en" name="e11-7"
# ## E11.7 · Three commands (2 points)
#
# One line each, as you type it in a terminal:
#
# - `"value"`: print the pose of `echo_of` in `echo_in`, `echo_hz` times a second;
# - `"late"`: measure how late the path from `chain[0]` to `chain[1]` is, in a simulation, so that the tool uses the simulated time;
# - `"who"`: show which nodes publish and subscribe on `topic`.

# %% [markdown] lang="ko" name="e11-7"
# ## E11.7 · 명령 세 개 (2점)
#
# 터미널에 입력할 명령을 한 줄씩 쓰십시오.
#
# - `"value"`: `echo_in`을 기준으로 한 `echo_of`의 포즈를 1초에 `echo_hz`번 출력합니다.
# - `"late"`: 시뮬레이션에서 목표 `chain[0]`, 원본 `chain[1]`인 경로의 지연을 잽니다. 도구가 시뮬레이션 시간을 쓰게 합니다.
# - `"who"`: `topic`에 어느 노드가 발행하고 구독하는지 보여 줍니다.

# %% name="e11-7-given"
e11_7 = task("E11.7")

# %% name="e11-7-answer" tags=["answer"]
# BEGIN SOLUTION
value = f"ros2 run tf2_ros tf2_echo {e11_7.echo_in} {e11_7.echo_of} {e11_7.echo_hz}"
late = f"ros2 run tf2_ros tf2_monitor {e11_7.chain[0]} {e11_7.chain[1]} --ros-args -p use_sim_time:=true"
who = f"ros2 topic info {e11_7.topic} --verbose"
# END SOLUTION
commands = {"value": value, "late": late, "who": who}

# %% name="e11-7-check" tags=["check"]
check("E11.7", commands)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading asks the same questions with other numbers.
# On a robot, do C5, C6 and C7 of the lab checklist: draw the tree, read a delay, show the axes in RViz. For each output write down what you compared it with.
#
# **Next:** [12 Owners and diagnosis](../../notebooks/en/12_owners_and_diagnosis.ipynb). [The start page](../../notebooks/en/00_start.ipynb) shows what you have passed, and what is left.

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기의 check는 여러분의 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서 실습 체크리스트 C5, C6, C7을 해 보세요. 트리를 그리고, 지연을 읽고, RViz에 축을 표시합니다. 출력마다 무엇과 비교했는지도 적어 보세요.
#
# **다음:** [12 발행 책임과 진단](../../notebooks/ko/12_owners_and_diagnosis.ipynb)으로 갑니다. [첫 페이지](../../notebooks/ko/00_start.ipynb)에서 무엇을 통과했고 무엇이 남았는지 볼 수 있습니다.
