# %% [markdown] lang="en" name="title"
# # Exercises 12 · Owners and diagnosis
#
# Eight tasks, 31 points, about 105 minutes. The page they belong to: [12 · Owners and diagnosis](../../notebooks/en/12_owners_and_diagnosis.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E12.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E12.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# What `task(...)` gives may differ from your neighbour's. Your patients are your own.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 12 · 발행 책임과 진단
#
# 과제 여덟 개, 31점, 약 105분입니다. 함께 보는 페이지: [12 · 발행 책임과 진단](../../notebooks/ko/12_owners_and_diagnosis.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E12.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E12.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# `task(...)`가 주는 값과 로봇은 옆 사람과 다를 수 있습니다.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, lesson, solution, task

# %% [markdown] lang="en" name="e12-1"
# ## E12.1 · Which node publishes what (4 points)
#
# A robot with wheels, an IMU, a lidar and an arm. Its packages contain `amcl` and `slam_toolbox`, an `ekf_filter_node`, and a lidar driver that "also publishes TF". The URDF contains all mounts. Each of them publishes what its switch allows.
# The task's data have two fields:
#
# - `map_frame`: with `"a map is there"`, `amcl` localises the robot. With `"the map is being made"`, `slam_toolbox` does. With `"no map at all"`, no node publishes `map → odom`.
# - `odometry`: with `"wheels alone"` there is nothing to fuse, and the filter stays off. With `"wheels and imu, fused by ekf_filter_node"` the filter's pose is better, so use it.
#
# Name the owner of each edge, one of `"amcl"`, `"slam_toolbox"`, `"wheel_odometry"`, `"ekf_filter_node"`, `"lidar_driver"`, `"joint_driver"`, `"robot_state_publisher"`, `"nobody"`, and set each switch to `True` or `False`.

# %% [markdown] lang="ko" name="e12-1"
# ## E12.1 · 어느 노드가 무엇을 발행합니까? (4점)
#
# 바퀴, imu, 라이다, 팔이 있는 로봇입니다. 패키지에는 `amcl`과 `slam_toolbox`, `ekf_filter_node`, 그리고 “TF도 발행하는” 라이다 드라이버가 들어 있습니다. 장착 변환은 모두 URDF에 있습니다. 어느 노드든 스위치가 켜져 있으면 발행합니다.
# 발행자는 `task`가 주는 두 값에 따라 정해집니다.
#
# - `map_frame`: `"a map is there"`(지도 있음)면 `amcl`이, `"the map is being made"`(지도를 만드는 중)면 `slam_toolbox`가 위치를 찾습니다. `"no map at all"`(지도 없음)이면 아무 노드도 `map → odom`을 발행하지 않습니다.
# - `odometry`: `"wheels alone"`(바퀴만)이면 융합할 것이 없어 필터를 쓰지 않습니다. `"wheels and imu, fused by ekf_filter_node"`(바퀴와 imu를 융합)면 필터가 바퀴와 imu의 값을 합쳐 더 나은 포즈를 구하므로 필터의 포즈를 씁니다.
#
# 연결마다 발행자를 `"amcl"`, `"slam_toolbox"`, `"wheel_odometry"`, `"ekf_filter_node"`, `"lidar_driver"`, `"joint_driver"`, `"robot_state_publisher"`, `"nobody"` 가운데서 고르고, 스위치는 `True`나 `False`로 정하십시오.

# %% name="e12-1-given"
e12_1 = task("E12.1")

# %% name="e12-1-answer" tags=["answer"]
owners = {
    # BEGIN SOLUTION
    "map -> odom": {"a map is there": "amcl", "no map at all": "nobody"}.get(e12_1.map_frame, "slam_toolbox"),
    "odom -> base_footprint": "ekf_filter_node" if "ekf" in e12_1.odometry else "wheel_odometry",
    "base_footprint -> base_link": "robot_state_publisher",
    "base_link -> laser_frame": "robot_state_publisher",
    "wrist -> tool0": "robot_state_publisher",
    "amcl tf_broadcast": e12_1.map_frame == "a map is there",
    "slam_toolbox publishes": e12_1.map_frame == "the map is being made",
    "wheel_odometry enable_odom_tf": "ekf" not in e12_1.odometry,
    "ekf publish_tf": "ekf" in e12_1.odometry,
    "lidar_driver publish_tf": False,
    # END SOLUTION
}

# %% name="e12-1-check" tags=["check"]
check("E12.1", owners)

# %% [markdown] lang="en" name="e12-2"
# ## E12.2 · Five terminals (4 points)
#
# Five terminals on five robots, `e12_2.a` to `e12_2.e`: print them. In each, the same four commands were typed about `odom → base_footprint`; their output is shortened. The card of the healthy robot is the one from the page. For each terminal, from `"a …"` to `"e …"`:
#
# - `"… state"`: `"one owner"`, `"nobody"`, `"two owners"`, `"another edge"` or `"a misspelt parent"`
# - `"… cure"`, the fix: `"leave it as it is"`, `"start wheel_odometry"`, `"ekf_filter_node: publish_tf false"`, `"localization: send map -> odom"` or `"wheel_odometry: parent odom"`. It names the node that has to change.
#
# The answer cell gives each of these words a name, so that you need not type it: `"a state": two_owners`.

# %% [markdown] lang="ko" name="e12-2"
# ## E12.2 · 터미널 다섯 개 (4점)
#
# 로봇 다섯 대의 터미널 `e12_2.a`부터 `e12_2.e`까지입니다. 출력해 보세요. `odom → base_footprint`에 관해 똑같은 네 가지 검사를 했고, 출력은 조금 줄였습니다. 정상일 때의 카드는 이 장의 것과 같습니다. `"a …"`부터 `"e …"`까지 터미널마다 답하십시오.
#
# - `"… state"`: `"one owner"`, `"nobody"`, `"two owners"`, `"another edge"`, `"a misspelt parent"` 가운데 하나
# - `"… cure"`: `"leave it as it is"`, `"start wheel_odometry"`, `"ekf_filter_node: publish_tf false"`, `"localization: send map -> odom"`, `"wheel_odometry: parent odom"` 가운데 하나. 고쳐야 할 노드의 이름이 들어 있습니다.
#
# 답 셀에는 이 문구가 변수로 정의되어 있으니 `"a state": two_owners`처럼 변수 이름을 쓰십시오.

# %% name="e12-2-given"
e12_2 = task("E12.2")

# %% name="e12-2-answer" tags=["answer"]
one_owner, nobody, two_owners, another_edge = "one owner", "nobody", "two owners", "another edge"
a_misspelt_parent, leave_it_as_it_is = "a misspelt parent", "leave it as it is"
start_wheel_odometry, switch_off_the_filter = "start wheel_odometry", "ekf_filter_node: publish_tf false"
send_map_to_odom, correct_the_parent = "localization: send map -> odom", "wheel_odometry: parent odom"
terminals = {"a state": ..., "a cure": ..., "b state": ..., "b cure": ..., "c state": ..., "c cure": ...,
             "d state": ..., "d cure": ..., "e state": ..., "e cure": ...}
# BEGIN SOLUTION
_signs = (("Failure at", True, another_edge, send_map_to_odom), ("/wheel_odometry", False, nobody, start_wheel_odometry),
          ("/ekf_filter_node", True, two_owners, switch_off_the_filter),
          ("base_footprint: \n  parent: 'odom'", False, a_misspelt_parent, correct_the_parent),
          ("", True, one_owner, leave_it_as_it_is))  # the first that fits: how it shows, and what is to be done
for place, text in vars(e12_2).items():
    found = next(found for words, are_there, *found in _signs if (words in text) == are_there)
    terminals[f"{place} state"], terminals[f"{place} cure"] = found
# END SOLUTION

# %% name="e12-2-check" tags=["check"]
check("E12.2", terminals)

# %% [markdown] lang="en" name="e12-3"
# ## E12.3 · The first check (3 points)
#
# Ten symptoms. For each: what do you check **first**? Choose a check that takes two minutes at most and has different results for the symptom's two suspects. If there are several such checks, choose any of them. An answer is the short name of a check, as printed by the next cell. Two more answers are `"longer timeout"` and `"read the code"`.
#
# - **no frame map** RViz does not know `map`. Is the localiser not running, or does it wait?
# - **odom stands alone** /odom arrives, and `odom` has no child. Is the switch off, or the parent misspelt?
# - **robot to and fro** the robot jumps in `odom`. Two owners, or a bad wheel?
# - **scan beside the walls** all Ok, and 20 cm off even at rest. A wrong mount, or a wrong map?
# - **walls smear in bends** sharp while the robot stands still, smeared in curves. The scan's clock, or the mount?
# - **into the future** the scan flickers. The laser's clock, or late transforms?
# - **localizer silent** the node is there and publishes nothing. Does it wait for /clock, or for a scan?
# - **unknown frame** RViz: For frame [x]: Frame [x] does not exist. Is the name in the scan's header misspelt, or is the mount missing?
# - **static late joiner** a listener that starts later never receives a mount. Is its publisher volatile, or was the mount never sent?
# - **slow robot** scans are shown, but in steps. A slow odometry, or a slow scan?

# %% [markdown] lang="ko" name="e12-3"
# ## E12.3 · 첫 검사 (3점)
#
# 열 가지 증상입니다. 무엇을 **먼저** 검사하겠습니까? 둘 가운데 어느 쪽이 원인인지에 따라 결과가 다르고, 2분을 넘지 않는 검사를 고르십시오. 그런 검사가 여럿이면 어느 것이든 맞습니다. 답은 다음 셀이 출력하는 검사의 짧은 이름입니다. 그 밖에 `"longer timeout"`과 `"read the code"`도 있습니다.
#
# - **no frame map** RViz에 `map`이 없습니다. 위치 추정 노드가 꺼졌습니까, 무언가를 기다립니까?
# - **odom stands alone** /odom은 오는데 `odom` 아래에 연결이 없습니다. 스위치가 꺼졌습니까, 부모 이름이 틀렸습니까?
# - **robot to and fro** `odom` 기준으로 로봇이 튑니다. 발행자가 둘입니까, 바퀴 오도메트리가 나쁩니까?
# - **scan beside the walls** RViz는 초록색인데, 로봇이 서 있어도 스캔이 20 cm 어긋납니다. 장착 변환이 틀렸습니까, 지도가 틀렸습니까?
# - **walls smear in bends** 서 있으면 또렷한데 회전하면 번집니다. 스캔의 시계입니까, 장착 변환입니까?
# - **into the future** 스캔이 깜빡입니다. 레이저의 시계입니까, 지연된 변환입니까?
# - **localizer silent** 노드는 있는데 아무것도 발행하지 않습니다. /clock을 기다립니까, 스캔을 기다립니까?
# - **unknown frame** RViz: For frame [x]: Frame [x] does not exist. 스캔의 헤더에 적힌 이름이 틀렸습니까, 장착 변환이 없습니까?
# - **static late joiner** 나중에 켠 노드는 장착 변환을 받지 못합니다. 발행자가 volatile입니까, 보낸 적이 없습니까?
# - **slow robot** 스캔이 나오기는 하는데 뚝뚝 끊깁니다. 오도메트리의 발행률이 낮습니까, 스캔의 발행률이 낮습니까?

# %% name="e12-3-trolley"
lesson.show_trolley()

# %% name="e12-3-answer" tags=["answer"]
first = {
    # BEGIN SOLUTION
    "no frame map": "node list",
    "odom stands alone": "publish_tf",
    "robot to and fro": "echo odom base_footprint",
    "scan beside the walls": "echo base_link laser_frame",
    "walls smear in bends": "delay /scan",
    "into the future": "delay /scan",
    "localizer silent": "use_sim_time",
    "unknown frame": "scan header",
    "static late joiner": "info /tf_static",
    "slow robot": "hz /odom",
    # END SOLUTION
}

# %% name="e12-3-check" tags=["check"]
check("E12.3", first)

# %% [markdown] lang="en" name="e12-4"
# ## E12.4 · Three patients (6 points)
#
# Three robots of your own: `e12_4.a`, `e12_4.b`, `e12_4.c`. Examine each as on the page: `visit = lesson.admit(e12_4.a)`, `visit.ask("...")`, `visit.say(cause=..., fix=...)`, `visit.try_fix()`; or `lesson.clinic_panel(e12_4.a, helped=False)`. Twelve minutes each.
#
# For each patient, `"a ..."`, `"b ..."` and `"c ..."`:
#
# - `"a checks"`: a list of checks that **would have been enough**, in their order and by their short names, such as `["hz /scan", "node list"]`. Together they take twelve minutes at most, rule out every other suspect of the complaint, and contain one result that is not normal. No check comes after that
# - `"a cause"`: one of the eighteen suspects, as `lesson.show_suspects()` prints them, or `"sensor broken"`
# - `"a frame"`: the frame that is missing or is not in its true position: `"map"`, `"odom"`, `"base_footprint"`, `"laser_frame"`, `"all that move"` or `"none"`. If an edge is wrong, its child. If the clock or the header of the laser is wrong, `"laser_frame"`
# - `"a owner"`: which node has to change: `"localization"`, `"wheel_odometry"`, `"ekf_filter_node"`, `"laser_mount"`, `"laser_driver"`, `"rviz"`, `"network"` or `"nobody"`
# - `"a fix"`: one of those that `visit.fixes()` prints

# %% [markdown] lang="ko" name="e12-4"
# ## E12.4 · 로봇 세 대의 진단 (6점)
#
# 여러분의 로봇 세 대 `e12_4.a`, `e12_4.b`, `e12_4.c`입니다. 본문에서처럼 진단하십시오. `visit = lesson.admit(e12_4.a)`, `visit.ask("...")`, `visit.say(cause=..., fix=...)`, `visit.try_fix()`를 쓰거나, `lesson.clinic_panel(e12_4.a, helped=False)`를 씁니다. 로봇마다 12분입니다.
#
# 로봇마다 `"a ..."`, `"b ..."`, `"c ..."`로 답합니다.
#
# - `"a checks"`: 원인을 증명하는 데 **충분했을** 검사의 리스트. `["hz /scan", "node list"]`처럼 짧은 이름을 순서대로 씁니다. 네 가지 조건이 있습니다. 걸리는 시간의 합이 12분을 넘지 않습니다. 그 증상의 다른 용의자를 모두 지웁니다. 카드와 결과가 다른 검사가 적어도 하나 들어 있어야 합니다. 증명이 끝난 뒤의 검사는 쓰지 않습니다.
# - `"a cause"`: `lesson.show_suspects()`가 출력하는 용의자 열여덟 가운데 하나, 또는 `"sensor broken"`
# - `"a frame"`: 없거나 제자리에 보이지 않는 좌표계. `"map"`, `"odom"`, `"base_footprint"`, `"laser_frame"`, `"all that move"`, `"none"` 가운데 하나. 연결이 틀렸으면 그 연결의 자식을 씁니다. 레이저의 시계나 헤더가 틀렸으면 `"laser_frame"`을 씁니다.
# - `"a owner"`: 고쳐야 할 노드. `"localization"`, `"wheel_odometry"`, `"ekf_filter_node"`, `"laser_mount"`, `"laser_driver"`, `"rviz"`, `"network"`, `"nobody"` 가운데 하나
# - `"a fix"`: `visit.fixes()`가 보여 주는 것 가운데 하나

# %% name="e12-4-given"
e12_4 = task("E12.4")

# %% name="e12-4-answer" tags=["answer"]
# BEGIN SOLUTION
from tflab.clinic.checks import CHECKS
from tflab.clinic.fixes import DIAGNOSES
from tflab.clinic.proof import consistent_suspects, shortest_proof

patients = {}  # {"a checks": [...], "a cause": ..., "a frame": ..., "a owner": ..., "a fix": ..., "b checks": [...], ...}
for who, patient in vars(e12_4).items():  # nobody on a visit may read all of it; a solution for any patient has to
    (cause,) = consistent_suspects({key: check.kind(patient.ask(key)) for key, check in CHECKS.items()})
    told = {"checks": (cause, shortest_proof(cause)), "cause": cause, **DIAGNOSES[cause]._asdict()}
    for what, answer in told.items():
        patients[f"{who} {what}"] = answer
# END SOLUTION

# %% name="e12-4-check" tags=["check"]
check("E12.4", patients)

# %% [markdown] lang="en" name="e12-5"
# ## E12.5 · A robot from its specification (5 points)
#
# A second robot joins the first in one room, on one map. Its name is `e12_5.robot`. It has wheels with odometry. If `e12_5.fused` is `True`, a filter fuses the odometry with an IMU. The name of its sensor is `e12_5.sensor`. The sensor's link (`…_link`) is a child of `base_link`, and the optical frame (`…_optical_frame`) is a child of that link. The URDF contains both. `e12_5.camera_driver_publishes_tf` is the default of the camera driver's switch. The robot's frames are `odom`, `base_footprint`, `base_link` and the two frames of the sensor. Put the robot's name and a slash before each of them. Both robots share `map`.
#
# - `"tree"`: child → parent
# - `"moving"`, `"mounts"`: the topic, `"/tf"` or `"/tf_static"`, of the frames that move and of the fixed mounts
# - `"odom owner"`, `"mounts owner"`: `"localization"`, `"wheel_odometry"`, `"ekf_filter_node"`, `"robot_state_publisher"` or `"camera_driver"`
# - `"wheel_odometry publish_tf"`, `"ekf publish_tf"`, `"camera_driver publish_tf"`: `True` or `False`
# - `"bag"`: the topics to record so that the tree is complete in a playback, and no others
#
# The cell below your answer launches this robot beside the first one, exactly as you wrote it. It shows RViz's list, the publisher of each edge, and which data a playback of your bag would provide. It does not mark your answer. What is wrong there would be wrong on the robot.

# %% [markdown] lang="ko" name="e12-5"
# ## E12.5 · 사양서로 만드는 로봇 (5점)
#
# 같은 방, 같은 지도에 두 번째 로봇이 들어옵니다. 이름은 `e12_5.robot`입니다. 바퀴 오도메트리가 있습니다. `e12_5.fused`가 `True`이면 필터가 바퀴 오도메트리와 IMU를 융합합니다. 센서의 이름은 `e12_5.sensor`입니다. 센서의 링크(`…_link`)는 `base_link`의 자식이고, 광학 좌표계(`…_optical_frame`)는 그 링크의 자식입니다. 두 변환은 URDF에 있습니다. `e12_5.camera_driver_publishes_tf`는 카메라 드라이버 스위치의 기본값입니다. 좌표계는 `odom`, `base_footprint`, `base_link`와 센서의 좌표계 둘입니다. 이 다섯 이름의 앞에는 로봇의 이름과 슬래시(/)를 붙입니다. `map`은 두 로봇이 함께 씁니다.
#
# - `"tree"`: 자식 → 부모
# - `"moving"`, `"mounts"`: 움직이는 것과 고정된 것의 토픽. `"/tf"` 또는 `"/tf_static"`
# - `"odom owner"`, `"mounts owner"`: `"localization"`, `"wheel_odometry"`, `"ekf_filter_node"`, `"robot_state_publisher"`, `"camera_driver"` 가운데 하나
# - `"wheel_odometry publish_tf"`, `"ekf publish_tf"`, `"camera_driver publish_tf"`: `True` 또는 `False`
# - `"bag"`: 내일 재생해도 트리가 온전하도록 기록할 토픽. 꼭 필요한 것만 씁니다.
#
# 답 아래의 셀은 쓴 그대로 로봇을 만들어 첫 번째 로봇 옆에서 실행합니다. RViz의 상태, 연결마다 누가 발행하는지, bag으로 무엇을 할 수 있는지 보여 줍니다. 채점은 하지 않습니다. 여기서 이상한 것은 실제 로봇에서도 이상합니다.

# %% name="e12-5-given"
e12_5 = task("E12.5")

# %% name="e12-5-answer" tags=["answer"]
# BEGIN SOLUTION
_names = ["odom", "base_footprint", "base_link", f"{e12_5.sensor}_link", f"{e12_5.sensor}_optical_frame"]
_names = [f"{e12_5.robot}/{name}" for name in _names]
robot = {  # {"tree": {child: parent, ...}, "moving": ..., "mounts": ..., "odom owner": ..., and so on: nine entries}
    "tree": dict(zip(_names, ["map", *_names], strict=False)),
    "moving": "/tf",
    "mounts": "/tf_static",
    "odom owner": "ekf_filter_node" if e12_5.fused else "wheel_odometry",
    "mounts owner": "robot_state_publisher",
    "wheel_odometry publish_tf": not e12_5.fused,
    "ekf publish_tf": e12_5.fused,
    "camera_driver publish_tf": False,
    "bag": {"/tf", "/tf_static"},
}
# END SOLUTION

# %% name="e12-5-launch" tags=["interactive"]
lesson.launch_answer(robot, e12_5)

# %% name="e12-5-seen"
lesson.draw_rviz()

# %% name="e12-5-check" tags=["check"]
check("E12.5", robot)

# %% [markdown] lang="en" name="e12-6"
# ## E12.6 · The wall that smears (3 points)
#
# In the middle of a drive, a straight wall appears two or three times. There are eight possible steps:
#
# - **new sensor** install another laser
# - **mount** compare `tf2_echo base_link laser_frame` with the drawing
# - **publishers** which node publishes which edge, and which switches are on
# - **fixed frame** names: the Fixed Frame, and the frames in RViz's list
# - **longer timeout** let RViz wait longer
# - **header** the scan's own frame and stamp, and the clock it comes from
# - **tree** does `view_frames` show one tree?
# - **rates** delays and rates of the edges
#
# Six observations follow one another, `"first"` to `"sixth"`. After each, choose the step that you take next:
#
# 1. RViz reports all Ok. The wall is sharp while the robot stands still. It smears in curves.
# 2. That step shows nothing unusual: each scan arrives 0.05 s after its stamp. The wall still smears.
# 3. `odom → base_footprint` arrives 80 times a second, and the wheel odometry publishes 50.
# 4. A second node is switched off. The wall is sharp in curves, too, but it is 0.15 m behind the wall of the map, even while the robot stands still.
# 5. That is corrected. After a restart RViz prints `No transform from [laser_frame] to [map]`. RViz lists both frames.
# 6. That is corrected. The next morning nothing is drawn: `Frame [mpa] does not exist`.

# %% [markdown] lang="ko" name="e12-6"
# ## E12.6 · 번지는 벽 (3점)
#
# 강의의 마지막 문제입니다. 달리는 도중에 곧은 벽이 두 겹, 세 겹으로 보입니다. 할 수 있는 단계는 여덟 가지입니다.
#
# - **new sensor** 레이저를 새것으로 바꾼다
# - **mount** `tf2_echo base_link laser_frame`을 도면과 비교한다
# - **publishers** 누가 어느 연결을 발행하고 어느 스위치가 켜졌는지 본다
# - **fixed frame** 이름: 고정 좌표계와 RViz 목록의 좌표계를 본다
# - **longer timeout** RViz가 더 오래 기다리게 한다
# - **header** 스캔의 좌표계와 측정 시각, 그 시각을 준 시계를 본다
# - **tree** `view_frames`의 트리가 하나인지 본다
# - **rates** 연결의 지연과 발행률을 본다
#
# 관찰 여섯 가지가 `"first"`부터 `"sixth"`까지 차례로 이어집니다. 관찰마다 다음에 할 단계를 고르십시오.
#
# 1. RViz는 모두 Ok입니다. 벽은 로봇이 서 있으면 또렷하고, 회전할 때 번집니다.
# 2. 그 단계에서는 이상이 나오지 않습니다. 스캔은 측정 시각에서 0.05초 뒤에 도착합니다. 벽은 여전히 번집니다.
# 3. `odom → base_footprint`가 1초에 80번 오는데, 바퀴 오도메트리는 50번 발행합니다.
# 4. 다른 노드를 껐습니다. 이제 회전할 때도 벽이 또렷하지만, 서 있을 때도 지도의 벽보다 0.15 m 뒤에 있습니다.
# 5. 그것을 고쳤습니다. 다시 켜니 RViz가 `No transform from [laser_frame] to [map]`을 출력합니다. RViz의 목록에는 두 좌표계가 모두 있습니다.
# 6. 그것을 고쳤습니다. 다음 날 아침에는 아무것도 그려지지 않고 `Frame [mpa] does not exist`가 나옵니다.

# %% name="e12-6-answer" tags=["answer"]
steps = {
    # BEGIN SOLUTION
    "first": "header",
    "second": "rates",
    "third": "publishers",
    "fourth": "mount",
    "fifth": "tree",
    "sixth": "fixed frame",
    # END SOLUTION
}

# %% name="e12-6-check" tags=["check"]
check("E12.6", steps)

# %% [markdown] lang="en" name="e12-7"
# ## E12.7 · A program that diagnoses (5 points)
#
# The only complaint is “It does not work”. There are eighteen suspects and twelve minutes. `patient.ask(check)` costs its minutes and returns a finding in a line, such as `"all Ok"`, `"-0.295 s, std dev 0.000 s"`, `"True"` or `"not in one tree"`. The next cell prints for every check its normal result (`card`), and its result for each suspect. These names and numbers are those of one robot. On another robot a clock can be off by 0.35 s, and a frame can be called `lidar`.
#
# Return `patient.verdict(cause, frame)`, with causes and frames as in E12.4. The verdict includes your checks, and they have to be a proof: within twelve minutes they rule out all seventeen other suspects, and no check comes after that.

# %% [markdown] lang="ko" name="e12-7"
# ## E12.7 · 진단하는 프로그램 (5점)
#
# 정보는 “작동하지 않습니다”뿐입니다. 용의자는 열여덟, 시간은 12분입니다. `patient.ask(check)`는 그 검사의 시간을 쓰고 결과를 한 줄로 반환합니다. `"all Ok"`, `"-0.295 s, std dev 0.000 s"`, `"True"`, `"not in one tree"` 같은 것입니다. 다음 셀은 검사마다 정상일 때(`카드`)의 결과와 용의자마다 나올 결과를 출력합니다. 출력의 이름과 숫자는 로봇 한 대의 예입니다. 다른 로봇에서는 시계가 0.35초 틀릴 수도 있고, 좌표계 이름이 `lidar`일 수도 있습니다.
# `patient.verdict(cause, frame)`을 반환하십시오. 원인과 좌표계는 E12.4와 같은 이름을 씁니다. verdict에는 실행한 검사도 담기며, 그 검사로 원인이 증명되어야 합니다. 12분 안에 나머지 용의자 열일곱을 모두 지우고, 그다음에는 검사를 더 하지 마십시오.

# %% name="e12-7-findings"
lesson.show_findings()


# %% name="e12-7-answer" tags=["answer"]
def triage(patient):
    """Return the verdict on a patient of whom nothing is known."""
    # BEGIN SOLUTION
    from tflab.clinic.fixes import DIAGNOSES
    from tflab.clinic.proof import CHECKS, SUSPECTS, bits_per_minute, consistent_suspects

    left = SUSPECTS
    for _ in SUSPECTS:
        if len(left) != 1:
            check = max(CHECKS, key=lambda key: bits_per_minute(key, left))
            left = consistent_suspects({check: CHECKS[check].kind(patient.ask(check))}, left)
    (cause,) = left
    return patient.verdict(cause, DIAGNOSES[cause].frame)
    # END SOLUTION


# %% name="e12-7-check" tags=["check"]
check("E12.7", triage)

# %% [markdown] lang="en" name="e12-8"
# ## E12.8 · Fifteen questions, after (1 point)
#
# These questions ask for the same ideas as E0.1 at the very beginning, with other numbers. Afterwards you can compare both forms.
# Again you get the point for answering, whether your answers are right or not, and again you look nothing up. Write one letter for each question, from `"a"` to `"d"`, with a `?` behind it if you guess, or `"e"` if you do not know.
# When all fifteen are answered, `check` opens both forms, with a sentence for each option. If you have not answered [E0.1](E00_start.ipynb) yet, there is no before to compare with.

# %% [markdown] lang="ko" name="e12-8"
# ## E12.8 · 열다섯 문제, 끝 (1점)
#
# 기억납니까? 맨 처음에 만난 것과 같은 내용이고 숫자만 다릅니다. 답하고 나면 시험지 두 장을 모두 볼 수 있습니다.
# 이번에도 채점하지 않습니다. 아무것도 찾아보지 말고, 문제마다 `"a"`에서 `"d"`까지 글자 하나를 쓰십시오. 짐작이면 뒤에 `?`를 붙이고, 모르면 `"e"`를 쓰십시오.
# 열다섯 문제에 모두 답하면 `check`가 시험지 두 장을 열고 보기마다 한 문장씩 설명합니다. [E0.1](E00_start.ipynb)에 아직 답하지 않았다면 비교할 처음 답이 없습니다.

# %% [markdown] lang="en" name="questions"
# Unless a question says otherwise, *x* is ahead, *y* is to the left, *z* is up, and lengths are in metres. (2, 0) is two metres ahead.

# %% [markdown] lang="ko" name="questions"
# 따로 말하지 않으면 *x*는 앞쪽, *y*는 왼쪽, *z*는 위쪽이고, 길이의 단위는 미터입니다. (2, 0)은 2미터 앞입니다.

# %% [markdown] lang="en" name="question-1"
# **1.** A laser is fixed to a robot, 0.3 ahead of the robot's centre and turned 90° to the right. It reports a ball at (1.5, 0), straight ahead of itself. Where is the ball for the robot?
#
# - **a** (0, 1.2)
# - **b** (1.8, 0)
# - **c** (0, −1.8)
# - **d** (0.3, −1.5)
# - **e** I do not know

# %% [markdown] lang="ko" name="question-1"
# **1.** 로봇 한가운데에서 앞으로 0.3 떨어진 자리에 레이저가 오른쪽으로 90° 회전한 채 고정되어 있습니다. 레이저는 자기 정면 (1.5, 0)에 공이 있다고 알립니다. 로봇을 기준으로 공은 어디에 있습니까?
#
# - **a** (0, 1.2)
# - **b** (1.8, 0)
# - **c** (0, −1.8)
# - **d** (0.3, −1.5)
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-2"
# **2.** In a drawing, an arrow goes from a charging dock to a robot. The numbers (4, 1, 0) are written beside it. A bolt is exactly at the robot's own origin. What do you know then?
#
# - **a** For the dock, the bolt is at (−4, −1, 0).
# - **b** What is known for the dock can be turned into the robot's numbers, but not back.
# - **c** It shows only which route the messages take.
# - **d** For the dock, the bolt is at (4, 1, 0).
# - **e** I do not know

# %% [markdown] lang="ko" name="question-2"
# **2.** 그림에 충전대에서 로봇으로 향하는 화살표가 있고, 그 옆에 (4, 1, 0)이라고 적혀 있습니다. 나사 하나가 정확히 로봇의 원점에 있습니다. 이로부터 알 수 있는 것은 무엇입니까?
#
# - **a** 충전대를 기준으로 나사는 (−4, −1, 0)에 있습니다.
# - **b** 충전대 기준의 값을 로봇 기준으로 바꿀 수 있지만, 거꾸로는 바꿀 수 없습니다.
# - **c** 메시지가 전달되는 순서만 알 수 있습니다.
# - **d** 충전대를 기준으로 나사는 (4, 1, 0)에 있습니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-3"
# **3.** Seen from A, B is at (3, 0) and turned 90° to the right. Where is A, seen from B?
#
# - **a** (0, 3)
# - **b** (0, −3)
# - **c** (−3, 0)
# - **d** (3, 0)
# - **e** I do not know

# %% [markdown] lang="ko" name="question-3"
# **3.** A를 기준으로 B는 (3, 0)에 있고 오른쪽으로 90° 회전해 있습니다. B를 기준으로 A는 어디에 있습니까?
#
# - **a** (0, 3)
# - **b** (0, −3)
# - **c** (−3, 0)
# - **d** (3, 0)
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-4"
# **4.** A camera's software counts x to the right, y down, z ahead. A cup stands 3 ahead of it and 0.4 to the right, at the same height. What does it write?
#
# - **a** (0.4, 0, 3)
# - **b** (3, −0.4, 0)
# - **c** (0, −3, 0.4)
# - **d** (−0.4, 0, 3)
# - **e** I do not know

# %% [markdown] lang="ko" name="question-4"
# **4.** 어떤 카메라 소프트웨어에서는 x가 오른쪽, y가 아래쪽, z가 앞쪽을 향합니다. 컵이 카메라에서 앞으로 3, 오른쪽으로 0.4 떨어진 곳에 카메라와 같은 높이로 놓여 있습니다. 이 소프트웨어는 컵의 위치를 어떻게 적습니까?
#
# - **a** (0.4, 0, 3)
# - **b** (3, −0.4, 0)
# - **c** (0, −3, 0.4)
# - **d** (−0.4, 0, 3)
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-5"
# **5.** The rotation of a part is sent as four numbers. “No rotation” is (0, 0, 0, 1). Another library writes “no rotation” as (1, 0, 0, 0), and a program sends these numbers. What happens?
#
# - **a** It is recognised as “no rotation”.
# - **b** It is rejected, because its length is wrong.
# - **c** The sender stops with an error.
# - **d** It is accepted, and the part is upside down.
# - **e** I do not know

# %% [markdown] lang="ko" name="question-5"
# **5.** 부품의 회전은 숫자 네 개로 보내며, ‘회전 없음’은 (0, 0, 0, 1)입니다. 다른 라이브러리는 ‘회전 없음’을 (1, 0, 0, 0)으로 적고, 그것을 그대로 보냅니다. 무슨 일이 일어납니까?
#
# - **a** 알아서 ‘회전 없음’으로 읽습니다.
# - **b** 길이가 맞지 않아 거절됩니다.
# - **c** 보내는 쪽이 오류를 내고 멈춥니다.
# - **d** 그대로 받아들이고, 부품은 위아래가 뒤집힙니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-6"
# **6.** Two programs each report the robot's position 20 times a second: one “3.0”, the other “3.6”. You ask for the position at times between the messages. What do you get?
#
# - **a** an error
# - **b** 3.0, 3.6 and anything between, changing
# - **c** always 3.3
# - **d** the one that sends more often
# - **e** I do not know

# %% [markdown] lang="ko" name="question-6"
# **6.** 두 프로그램이 저마다 1초에 20번씩 로봇의 위치를 알립니다. 하나는 “3.0에 있다”, 다른 하나는 “3.6에 있다”라고 합니다. 메시지와 메시지 사이 시각의 위치를 요청하면 무엇을 얻습니까?
#
# - **a** 오류
# - **b** 3.0, 3.6, 그 사이의 값이 때에 따라 바뀌며 나옴
# - **c** 언제나 3.3
# - **d** 더 자주 보내는 쪽의 값
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-7"
# **7.** A robot's wheels have counted 25.0 from the door. A map shows it 25.8 from the door. The wheel program keeps reporting “25.0 in my count”. What should the map program announce?
#
# - **a** “Set your count to 25.8.”
# - **b** “Zero of that count is at −0.8 on the map.”
# - **c** “Zero of that count is at +0.8 on the map.”
# - **d** “The robot is at 25.8 on the map.”
# - **e** I do not know

# %% [markdown] lang="ko" name="question-7"
# **7.** 로봇이 바퀴로 센 거리는 문에서부터 25.0입니다. 지도에서는 로봇이 문에서 25.8 떨어져 있습니다. 바퀴 프로그램은 계속해서 “내가 센 값으로 25.0”이라고 알립니다. 지도 프로그램은 무엇을 알려야 합니까?
#
# - **a** “센 값을 25.8로 고쳐라.”
# - **b** “바퀴로 세기 시작한 0은 지도에서 −0.8에 있다.”
# - **c** “바퀴로 세기 시작한 0은 지도에서 +0.8에 있다.”
# - **d** “로봇은 지도에서 25.8에 있다.”
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-8"
# **8.** Two programs report where a robot is. S never jumps, but is 0.5 m off after ten minutes. J is right to 2 cm, but jumps 5 cm now and then. The charger is 40 m away, and the robot has driven for an hour. Which one do you use to find the charger?
#
# - **a** S, because it is smooth
# - **b** the mean of both
# - **c** J
# - **d** neither: a program that jumps is broken
# - **e** I do not know

# %% [markdown] lang="ko" name="question-8"
# **8.** 로봇의 위치를 알려 주는 출처가 둘 있습니다. S는 튀지 않지만 10분 뒤에는 0.5 m 어긋납니다. J는 오차가 2 cm를 넘지 않지만 가끔 5 cm씩 튑니다. 충전기는 40 m 떨어져 있고 로봇은 한 시간 동안 달렸습니다. 충전기의 위치를 알려면 어느 것을 씁니까?
#
# - **a** 튀지 않는 S
# - **b** 둘의 평균
# - **c** J
# - **d** 둘 다 쓰지 않음: 튀면 고장입니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-9"
# **9.** A robot drives 0.8 m/s and turns 0.6 rad/s. A picture that is 0.25 s old shows a post 4 ahead. The post is drawn on the map from the robot's current position and direction. By about how much is the post off?
#
# - **a** 0.15
# - **b** 0.63
# - **c** 0.20
# - **d** 0: posts stand still
# - **e** I do not know

# %% [markdown] lang="ko" name="question-9"
# **9.** 로봇이 0.8 m/s로 달리면서 0.6 rad/s로 회전하고 있습니다. 0.25초 전에 찍은 영상에는 기둥이 앞쪽 4에 있습니다. 이 기둥을 로봇의 지금 위치와 방향으로 지도에 표시합니다. 기둥은 얼마쯤 빗나갑니까?
#
# - **a** 0.15
# - **b** 0.63
# - **c** 0.20
# - **d** 0: 기둥은 움직이지 않습니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-10"
# **10.** Messages with a robot's position arrive 0.1 to 0.4 s late. The delay changes each time, and it occurs only while the hall is full of phones. What do you do?
#
# - **a** set a clock
# - **b** wait a little, and drop what is older
# - **c** write the time of arrival into them
# - **d** wait as long as it takes
# - **e** I do not know

# %% [markdown] lang="ko" name="question-10"
# **10.** 로봇의 위치를 알리는 메시지가 0.1초에서 0.4초까지, 매번 다르게 늦게 옵니다. 전시장에 휴대전화가 가득할 때만 그렇습니다. 어떻게 합니까?
#
# - **a** 시계를 맞춥니다
# - **b** 잠깐 기다리고, 그보다 늦은 것은 버립니다
# - **c** 메시지에 도착한 시각을 써넣습니다
# - **d** 올 때까지 기다립니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-11"
# **11.** A guide refuses in three ways: “I do not know this name” · “I know both places, but no road joins them” · “There is a road, but I know nothing about it for that hour”. After the third, what do you look at?
#
# - **a** the spelling
# - **b** the missing stretch
# - **c** times and clocks
# - **d** a restart
# - **e** I do not know

# %% [markdown] lang="ko" name="question-11"
# **11.** 안내원은 세 가지로 거절합니다. “그런 이름은 모릅니다” · “두 곳 다 알지만 잇는 길이 없습니다” · “길은 있지만 그 시각의 상황은 모릅니다”. 세 번째 말을 들었다면 무엇을 살펴봅니까?
#
# - **a** 철자
# - **b** 빠진 구간
# - **c** 시각과 시계
# - **d** 다시 켜기
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-12"
# **12.** The angle of an arm is reported once, as if the arm could not move. Then the arm moves. What do the programs that received it do?
#
# - **a** They follow it.
# - **b** They get an error: too old.
# - **c** They lose it after ten seconds.
# - **d** They see it where it was, without any error.
# - **e** I do not know

# %% [markdown] lang="ko" name="question-12"
# **12.** 팔이 마치 고정된 부품인 것처럼 팔의 각도를 한 번만 알렸습니다. 그 뒤에 팔이 움직입니다. 받는 프로그램은 어떻게 됩니까?
#
# - **a** 따라서 움직입니다.
# - **b** 너무 오래되었다는 오류를 받습니다.
# - **c** 10초 뒤에 팔을 놓칩니다.
# - **d** 예전 자리에 있는 것으로 보고, 오류는 나지 않습니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-13"
# **13.** A recording of last week is replayed. All programs except one take their time from the recording. What is the first sign?
#
# - **a** none: that one runs a bit behind
# - **b** that one asks for times far from those of all the others
# - **c** the recording plays more slowly
# - **d** the sensor is silent
# - **e** I do not know

# %% [markdown] lang="ko" name="question-13"
# **13.** 지난주의 기록을 재생합니다. 프로그램 하나만 빼고 모두 기록의 시각을 따릅니다. 맨 처음 나타나는 증상은 무엇입니까?
#
# - **a** 증상이 없습니다. 그 프로그램이 조금 뒤처질 뿐입니다
# - **b** 그 프로그램만 다른 프로그램과 동떨어진 시각의 값을 요청합니다
# - **c** 기록이 느리게 재생됩니다
# - **d** 센서에서 아무것도 오지 않습니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-14"
# **14.** One program says where Base_link is, all others ask for base_link. What do they find?
#
# - **a** the same: capitals do not count
# - **b** a warning, and it is corrected
# - **c** two different parts, and nothing joins them
# - **d** what the last one calls it
# - **e** I do not know

# %% [markdown] lang="ko" name="question-14"
# **14.** 프로그램 하나는 Base_link의 위치를 알리고, 나머지는 모두 base_link의 위치를 요청합니다. 어떻게 됩니까?
#
# - **a** 같은 것입니다. 대문자와 소문자를 구별하지 않습니다
# - **b** 경고가 나오고 자동으로 고쳐집니다
# - **c** 서로 다른 두 부품이고, 둘 사이에 연결이 없습니다
# - **d** 마지막에 알린 쪽의 이름을 따릅니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-15"
# **15.** A viewer says “Ok, 360 points”, and all walls appear 0.4 m behind where they are. What do you do first?
#
# - **a** compare the laser's place on paper with a tape measure
# - **b** change the sensor: it is worn
# - **c** look at it from another fixed frame
# - **d** nothing: it says Ok
# - **e** I do not know

# %% [markdown] lang="ko" name="question-15"
# **15.** 시각화 프로그램에 “Ok, 360 points”라고 나오는데, 모든 벽이 실제보다 0.4 m 뒤에 나타납니다. 맨 먼저 무엇을 합니까?
#
# - **a** 도면에 적힌 레이저의 위치를 줄자로 잰 값과 비교합니다
# - **b** 센서를 바꿉니다. 낡았습니다
# - **c** 다른 고정 좌표계를 골라 봅니다
# - **d** 아무것도 하지 않습니다. Ok라고 나옵니다
# - **e** 모르겠습니다


# %% name="e12-8-answer" tags=["answer"]
after = {
    # BEGIN SOLUTION
    "1": "e", "2": "e", "3": "e", "4": "e", "5": "e",
    "6": "e", "7": "e", "8": "e", "9": "e", "10": "e",
    "11": "e", "12": "e", "13": "e", "14": "e", "15": "e",
    # END SOLUTION
}

# %% name="e12-8-check" tags=["check"]
check("E12.8", after)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# You have named owners, read terminals, proved causes with the fewest checks, and specified a robot. In a class, grading uses other robots for the same tasks, and your program gets other patients.
# On a robot, take the card with you: without the normal results you cannot see a fault.
#
# **Next:** [the start page](../../notebooks/en/00_start.ipynb) shows what you have learned between the two tests, and what to read again; [practice](../../notebooks/en/91_practice.ipynb) asks about it again.

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 어느 노드가 발행하는지 적고, 터미널을 읽고, 가장 적은 검사로 원인을 증명하고, 로봇 한 대를 설계했습니다. 채점할 때는 다른 로봇으로 같은 것을 확인합니다. E12.7의 프로그램은 처음 보는 로봇을 진단합니다.
# 로봇 앞에 갈 때는 카드를 가지고 가십시오. 정상일 때의 값을 모르면 이상이 있는지도 알 수 없습니다.
#
# **다음:** [첫 페이지](../../notebooks/ko/00_start.ipynb)에서 두 시험 사이에 무엇을 배웠고 무엇을 다시 볼지 볼 수 있습니다. [끝없는 연습](../../notebooks/ko/91_practice.ipynb)에서는 다른 숫자로 다시 풀 수 있습니다.
