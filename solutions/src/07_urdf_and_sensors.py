# %% [markdown] lang="en" name="title"
# # Exercises 07 · URDF and sensors
#
# Six tasks, 26 points, about 60 minutes. The page they belong to: [07 · URDF and sensors](../../notebooks/en/07_urdf_and_sensors.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E7.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E7.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# Your numbers come from `task(...)` and may differ from your neighbour's, so answer with an expression, such as `e7_1.up_cm / 100`, and not with a number that you calculated elsewhere.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 07 · URDF와 센서
#
# 과제 여섯 개, 26점, 약 60분입니다. 함께 보는 페이지: [07 · URDF와 센서](../../notebooks/ko/07_urdf_and_sensors.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E7.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E7.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 숫자는 `task(...)`가 주며 옆 사람과 다를 수 있습니다. 그러니 따로 계산한 숫자가 아니라 `e7_1.up_cm / 100` 같은 식으로 답해 보세요.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
import math

from geometry_msgs.msg import TransformStamped

from tflab.core import Transform

# %% [markdown] lang="en" name="e7-1"
# ## E7.1 · Two joints to finish (5 points)
#
# A camera head is mounted on the robot. Somebody measured its position in `base_link` (ahead, to the right, up) with a ruler, and its rotation to the right with a protractor. A motor lets it **nod**: a positive angle lowers its view. The lens is a little in front of the head's centre.
#
# Write the two joints, as a URDF has them; the links are declared for you.
#
# - `nod_joint`, revolute, from `base_link` to `camera_link`, which has a body's axes (x where the head faces);
# - `optical_joint`, fixed, from `camera_link` to `camera_optical_frame`, in the lens.
#
# An f-string inserts numbers: `f'<origin xyz="0 0 {e7_1.up_cm / 100}"/>'`. Only position, rotation and movement count; you may leave `<limit>` out (a real robot needs one). Angles must be right to 0.0005 rad.

# %% [markdown] lang="ko" name="e7-1"
# ## E7.1 · 관절 두 개 완성하기 (5점)
#
# 카메라 머리를 로봇에 달고 자와 각도기로 쟀습니다. `base_link`에서 앞으로, 오른쪽으로, 위로 얼마인지, 그리고 머리 전체가 오른쪽으로 몇 도 회전해 있는지입니다. 모터가 고개를 **끄덕이게** 합니다. 각도가 양수이면 시선이 내려갑니다. 렌즈는 머리 중심보다 조금 앞에 있습니다.
#
# 두 관절을 URDF의 형식으로 쓰십시오. 링크는 이미 선언되어 있습니다.
#
# - `nod_joint`: revolute, 부모는 `base_link`, 자식은 `camera_link`. `camera_link`는 본체의 축을 따릅니다(머리가 보는 쪽이 x).
# - `optical_joint`: fixed, 부모는 `camera_link`, 자식은 렌즈에 있는 `camera_optical_frame`.
#
# 숫자는 f-string으로 넣을 수 있습니다. `f'<origin xyz="0 0 {e7_1.up_cm / 100}"/>'`. 위치, 방향, 움직임만 채점합니다. `<limit>`은 쓰지 않아도 됩니다(실제 로봇에는 필요합니다). 각도는 0.0005 rad까지 맞아야 합니다.

# %% name="e7-1-given"
e7_1 = task("E7.1")

# %% name="e7-1-answer" tags=["answer"]
# BEGIN SOLUTION
ahead, right, up = e7_1.ahead_cm / 100, e7_1.to_its_right_cm / 100, e7_1.up_cm / 100
yaw = -math.radians(e7_1.turned_to_the_right_deg)
joints = f"""
<joint name="nod_joint" type="revolute">
  <parent link="base_link"/> <child link="camera_link"/>
  <origin xyz="{ahead} {-right} {up}" rpy="0 0 {yaw}"/>
  <axis xyz="0 1 0"/>
</joint>
<joint name="optical_joint" type="fixed">
  <parent link="camera_link"/> <child link="camera_optical_frame"/>
  <origin xyz="{e7_1.lens_ahead_cm / 100} 0 0" rpy="-1.5707963 0 -1.5707963"/>
</joint>
"""
# END SOLUTION

# %% name="e7-1-check" tags=["check"]
check("E7.1", joints)

# %% [markdown] lang="en" name="e7-2"
# ## E7.2 · Where the beam meets the floor (3 points)
#
# A laser looks down by `tilt_deg`. It is mounted `laser_above_base_link_m` above `base_link`, which is `base_link_above_floor_m` above the floor. For the beam straight ahead:
#
# - `"floor_m"`: how far ahead, along the floor, does it meet the floor, if nothing is in between [m]?
# - `"wall_up_m"`: a wall is `wall_m` ahead. How high above the floor does the beam meet it [m]?

# %% [markdown] lang="ko" name="e7-2"
# ## E7.2 · 빛이 바닥에 닿는 곳 (3점)
#
# 레이저가 아래로 `tilt_deg`만큼 기울어 있습니다. `base_link`에서 `laser_above_base_link_m` 위에 있고, `base_link`는 바닥에서 `base_link_above_floor_m` 위에 있습니다. 똑바로 앞을 보는 광선에 대해 답하십시오.
#
# - `"floor_m"`: 가로막는 것이 없다면, 바닥을 따라 앞으로 얼마 나아간 곳에서 바닥에 닿습니까[m]?
# - `"wall_up_m"`: `wall_m` 앞에 벽이 있습니다. 빛은 바닥에서 얼마나 높은 곳에 닿습니까[m]?

# %% name="e7-2-given"
e7_2 = task("E7.2")

# %% name="e7-2-answer" tags=["answer"]
# BEGIN SOLUTION
slope = math.tan(math.radians(e7_2.tilt_deg))
height_m = e7_2.laser_above_base_link_m + e7_2.base_link_above_floor_m
floor_m = height_m / slope
wall_up_m = height_m - e7_2.wall_m * slope
# END SOLUTION
beam = {"floor_m": floor_m, "wall_up_m": wall_up_m}

# %% name="e7-2-check" tags=["check"]
check("E7.2", beam)

# %% [markdown] lang="en" name="e7-3"
# ## E7.3 · Forward kinematics (5 points)
#
# `chain` is a list of joints from the base to the tip, each a dict: `"name"`, `"type"` (`"fixed"`, `"revolute"` or `"prismatic"`), `"xyz"` [m], `"rpy"` [rad] and `"axis"`, which is `"x"`, `"y"` or `"z"`.
# `positions` is a dict: name → rad or m. A joint that is missing in `positions` is at 0. `positions` may also contain other names. A fixed joint does not move.
# Return the pose of the tip in the base, a `Transform`.

# %% [markdown] lang="ko" name="e7-3"
# ## E7.3 · 정기구학 (5점)
#
# `chain`은 베이스에서 팔 끝까지의 관절 리스트입니다. 관절은 dict이고 키는 `"name"`, `"type"`(`"fixed"`, `"revolute"`, `"prismatic"`), `"xyz"`[m], `"rpy"`[rad], `"axis"`(`"x"`, `"y"`, `"z"`)입니다.
# `positions`는 관절 이름이 키이고 관절 값(rad 또는 m)이 값인 dict입니다. dict에 없는 관절의 값은 0이고, 다른 이름이 섞여 있을 수 있습니다. fixed 관절은 움직이지 않습니다.
# 베이스 기준의 팔 끝을 `Transform`으로 반환하십시오.


# %% name="e7-3-answer" tags=["answer"]
def fk(chain, positions):
    """Return base_T_tip."""
    # BEGIN SOLUTION
    base_T_tip = Transform()
    for joint in chain:
        at = positions.get(joint["name"], 0.0)
        movement = Transform()
        if joint["type"] == "revolute":
            movement = Transform.from_rpy(**{{"x": "roll", "y": "pitch", "z": "yaw"}[joint["axis"]]: at})
        if joint["type"] == "prismatic":
            movement = Transform(tuple(at if letter == joint["axis"] else 0.0 for letter in "xyz"))
        origin = Transform.from_rpy(*joint["rpy"], translation=tuple(joint["xyz"]))
        base_T_tip = base_T_tip @ origin @ movement
    return base_T_tip
    # END SOLUTION


# %% name="e7-3-check" tags=["check"]
check("E7.3", fk)

# %% [markdown] lang="en" name="e7-4"
# ## E7.4 · Five robots (5 points)
#
# Each of `e7_4.a` to `e7_4.e` shows the tree of a robot, and the output of one command. The joints of the URDF are `shoulder_joint`, `elbow_joint` and `wrist_joint`. On every robot the laser really is rotated. Somebody measured it.
#
# - `"a"` … `"e"`, the cause: `"other names"` (in the joint states), `"stamp zero"`, `"no driver"`, `"paint moved"` (the `<visual>`, and not the frame), `"degrees"`
# - `"a do"` … `"e do"`, the fix: `"use the URDF's names"`, `"stamp the message"`, `"start the joint driver"`, `"write it into the joint"`, `"write radians"`, `"restart RViz"`, `"change the cable"`, `"wait longer"`
#
# The answer cell gives each of these words a name, so that you need not type it: `"a": stamp_zero`.

# %% [markdown] lang="ko" name="e7-4"
# ## E7.4 · 다섯 로봇 (5점)
#
# `e7_4.a`부터 `e7_4.e`까지는 각각 로봇의 트리와 명령 하나의 출력입니다. URDF의 관절은 `shoulder_joint`, `elbow_joint`, `wrist_joint`이고, 레이저는 모두 누군가 잰 만큼 회전한 채 달려 있습니다.
#
# - `"a"` … `"e"`, 원인: `"other names"`(관절 메시지의 이름이 다름), `"stamp zero"`(시각이 0), `"no driver"`(드라이버 없음), `"paint moved"`(좌표계가 아니라 겉모습의 위치를 바꿈), `"degrees"`(도로 씀)
# - `"a do"` … `"e do"`, 고치는 법: `"use the URDF's names"`(URDF의 이름 쓰기), `"stamp the message"`(시각 적기), `"start the joint driver"`(드라이버 켜기), `"write it into the joint"`(관절에 적기), `"write radians"`(라디안으로 적기), `"restart RViz"`(RViz 다시 켜기), `"change the cable"`(케이블 바꾸기), `"wait longer"`(더 기다리기)
#
# 답 셀에는 이 문구들이 변수로 준비되어 있습니다. `"a": stamp_zero`처럼 변수를 쓰십시오.

# %% name="e7-4-given"
e7_4 = task("E7.4")

# %% name="e7-4-answer" tags=["answer"]
other_names, stamp_zero, no_driver, paint_moved, degrees = "other names", "stamp zero", "no driver", "paint moved", "degrees"
use_the_urdfs_names, stamp_the_message, write_radians = "use the URDF's names", "stamp the message", "write radians"
start_the_joint_driver, write_it_into_the_joint = "start the joint driver", "write it into the joint"
restart_rviz, change_the_cable, wait_longer = "restart RViz", "change the cable", "wait longer"
findings = {"a": ..., "a do": ..., "b": ..., "b do": ..., "c": ..., "c do": ..., "d": ..., "d do": ..., "e": ..., "e do": ...}
# BEGIN SOLUTION
_signs = (("Publisher count: 0", no_driver, start_the_joint_driver), ("<visual>", paint_moved, write_it_into_the_joint),
          ("<joint", degrees, write_radians), ("sec: 0,", stamp_zero, stamp_the_message), ("", other_names, use_the_urdfs_names))
for letter, report in vars(e7_4).items():
    findings[letter], findings[f"{letter} do"] = next(row[1:] for row in _signs if row[0] in report)
# END SOLUTION

# %% name="e7-4-check" tags=["check"]
check("E7.4", findings)

# %% [markdown] lang="en" name="e7-5"
# ## E7.5 · How is this IMU mounted? (4 points)
#
# The URDF describes it as not rotated. `at_rest` and `in_left_bend` are mean readings of its accelerometer, in the true `imu_link` [m/s²]: at rest, and in a curve to the left at `speed_mps` and `yaw_rate_radps`.
#
# - `"mount"`: `"as drawn"`, `"left"` (rotated to the left by 90°), `"right"`, `"backwards"` (by 180°), `"rolled over"` (roll π), `"pitched over"` (pitch π), or `"pitched over, left"` and `"pitched over, right"`: pitched over, and then rotated by 90°
# - `"gyro_z"`: what does its gyro's z read in that curve [rad/s]?
# - `"fix"`, how you fix it: `"rpy in the joint"`, `"rpy in the visual"`, `"minus in my node"`, `"leave it"`

# %% [markdown] lang="ko" name="e7-5"
# ## E7.5 · 이 IMU는 어떻게 달렸습니까? (4점)
#
# URDF에는 회전이 없다고 적혀 있습니다. 실제로 달린 `imu_link`의 축으로 잰 가속도계의 평균[m/s²]이 있습니다. `at_rest`는 서 있을 때, `in_left_bend`는 왼쪽으로 굽은 길을 `speed_mps`, `yaw_rate_radps`로 달릴 때입니다.
#
# - `"mount"`: `"as drawn"`(도면대로), `"left"`(왼쪽으로 90°), `"right"`(오른쪽으로 90°), `"backwards"`(180°), `"rolled over"`(roll π), `"pitched over"`(pitch π), `"pitched over, left"`와 `"pitched over, right"`(pitch π로 뒤집은 것을 통째로 90° 회전)
# - `"gyro_z"`: 그 굽은 길에서 자이로의 z는 얼마입니까[rad/s]?
# - `"fix"`: `"rpy in the joint"`(관절에 rpy), `"rpy in the visual"`(visual에 rpy), `"minus in my node"`(내 노드에서 마이너스), `"leave it"`(그대로 두기)

# %% name="e7-5-given"
e7_5 = task("E7.5")

# %% name="e7-5-answer" tags=["answer"]
x, y, z = e7_5.in_left_bend
pull = e7_5.speed_mps * e7_5.yaw_rate_radps  # to the robot's left [m/s²]
# BEGIN SOLUTION
mount = {
    (0, 1, True): "as drawn", (1, 0, True): "left", (-1, 0, True): "right", (0, -1, True): "backwards",
    (0, -1, False): "rolled over", (0, 1, False): "pitched over",
    (-1, 0, False): "pitched over, left", (1, 0, False): "pitched over, right",
}[round(x / pull), round(y / pull), z > 0]
gyro_z = math.copysign(e7_5.yaw_rate_radps, z)
fix = "leave it" if mount == "as drawn" else "rpy in the joint"
# END SOLUTION
imu = {"mount": mount, "gyro_z": gyro_z, "fix": fix}

# %% name="e7-5-check" tags=["check"]
check("E7.5", imu)

# %% [markdown] lang="en" name="e7-6"
# ## E7.6 · Find the tool's tip by touching (4 points)
#
# The robot has a new gripper. You let its tip touch a mark whose position in `map` you know: `map_p_tip`, (x, y, z) [m]. At that time the localiser reports `map_T_base` and the arm `base_T_tool0`, two `Transform`s.
# Return the message for the frame `tcp`: a `TransformStamped` whose parent is `tool0`, without a rotation, its stamp left as it is.

# %% [markdown] lang="ko" name="e7-6"
# ## E7.6 · 표시에 대어 찾는 공구 끝 (4점)
#
# 그리퍼를 새로 달았습니다. 그 끝을 표시에 댑니다. 표시의 위치는 `map` 기준 `map_p_tip`(x, y, z)[m]입니다. 그때 위치 추정 노드가 구한 포즈가 `map_T_base`, 팔 드라이버가 발행한 tool0의 포즈가 `base_T_tool0`입니다(둘 다 `Transform`).
# 좌표계 `tcp`가 어디에 있는지 알리는 `TransformStamped`를 반환하십시오. 부모는 `tool0`이고, 그 기준으로 회전이 없으며, 시각은 그대로 둡니다.


# %% name="e7-6-answer" tags=["answer"]
def tcp_mount(map_T_base, base_T_tool0, map_p_tip):
    """Return a TransformStamped, tool0 -> tcp."""
    # BEGIN SOLUTION
    message = TransformStamped()
    message.header.frame_id = "tool0"
    message.child_frame_id = "tcp"
    tool0_p_tip = (map_T_base @ base_T_tool0).inverse().apply(map_p_tip)
    place = message.transform.translation
    place.x, place.y, place.z = map(float, tool0_p_tip)
    return message
    # END SOLUTION


# %% name="e7-6-check" tags=["check"]
check("E7.6", tcp_mount)

# %% [markdown] lang="en" name="after"
# ## What you have shown
#
# The checks here used your own numbers. In a class, grading uses the same tasks with other numbers.
# On a robot, begin with a box straight ahead of the laser, and with a rotation to the left by hand. Then you have compared two mounts with the URDF.
#
# **Next:** [08 Buffer and measurement time](../../notebooks/en/08_buffer_and_measurement_time.ipynb).

# %% [markdown] lang="ko" name="after"
# ## 여기까지 해낸 것
#
# 여기서 check는 여러분에게 주어진 숫자로 확인했습니다. 채점할 때는 같은 문제를 다른 숫자로 확인합니다.
# 로봇에서는 레이저 바로 앞에 상자를 놓고, 로봇을 손으로 왼쪽으로 회전시켜 보는 것부터 해 보세요. 도면에 적힌 값 두 가지를 직접 확인하게 됩니다.
#
# **다음:** [08 버퍼와 측정 시각](../../notebooks/ko/08_buffer_and_measurement_time.ipynb)
