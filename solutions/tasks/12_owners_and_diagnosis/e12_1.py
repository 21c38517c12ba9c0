"""E12.1: Who says what."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongStep

NODES = ("amcl", "slam_toolbox", "wheel_odometry", "ekf_filter_node", "lidar_driver", "joint_driver",
         "robot_state_publisher", "nobody")  # fmt: skip
EDGES = ("map -> odom", "odom -> base_footprint", "base_footprint -> base_link", "base_link -> laser_frame",
         "wrist -> tool0")  # fmt: skip
SWITCHES = ("amcl tf_broadcast", "slam_toolbox publishes", "wheel_odometry enable_odom_tf", "ekf publish_tf",
            "lidar_driver publish_tf")  # fmt: skip
LOCALIZERS = {"a map is there": "amcl", "the map is being made": "slam_toolbox", "no map at all": "nobody"}

FINDERS = (
    ("amcl", "slam_toolbox", "nobody"), ("slam_toolbox", "amcl", "nobody"), ("nobody", "amcl", "slam_toolbox"),
)  # fmt: skip


def a_robot(rng):
    """Draw what the robot is for, and whether wheels and imu are fused."""
    return {
        "map_frame": str(rng.choice(list(LOCALIZERS))),
        "odometry": str(rng.choice(["wheels alone", "wheels and imu, fused by ekf_filter_node"])),
    }


def owners(given, *, finder="by the map", odom="one", localizer="its edge", switches="as needed", lidar="quiet",
           arm="by the drawing"):  # fmt: skip
    """Return the owner of each edge and every switch, step by step; other steps are the slips."""
    right = list(LOCALIZERS).index(given.map_frame)
    finder = FINDERS[right][("by the map", "the other", "the third").index(finder)]
    fused = "ekf" in given.odometry
    wheels = "ekf_filter_node" if fused else "wheel_odometry"
    answers = {
        "map -> odom": finder,
        "odom -> base_footprint": wheels,
        "base_footprint -> base_link": "robot_state_publisher",
        "base_link -> laser_frame": "robot_state_publisher",
        "wrist -> tool0": "robot_state_publisher",
        "amcl tf_broadcast": finder == "amcl",
        "slam_toolbox publishes": finder == "slam_toolbox",
        "wheel_odometry enable_odom_tf": not fused,
        "ekf publish_tf": fused,
        "lidar_driver publish_tf": False,
    }
    if odom == "both":
        answers |= {"wheel_odometry enable_odom_tf": True, "ekf publish_tf": True}
    elif odom in ("the other", "switches exchanged"):
        answers |= {"wheel_odometry enable_odom_tf": fused, "ekf publish_tf": not fused}
        if odom == "the other":
            answers["odom -> base_footprint"] = "wheel_odometry" if fused else "ekf_filter_node"
    if localizer == "the base":
        answers["odom -> base_footprint"] = "amcl" if finder == "nobody" else finder
    if switches == "all off":
        answers |= dict.fromkeys(SWITCHES, False)
    elif switches == "both localizers on":
        answers |= dict.fromkeys(SWITCHES[:2], True)
    if lidar == "switched on":
        answers |= {"lidar_driver publish_tf": True}
    if lidar == "repeats":
        answers |= {"lidar_driver publish_tf": True, "base_link -> laser_frame": "lidar_driver"}
    if arm == "by the driver":
        answers["wrist -> tool0"] = "joint_driver"
    return answers


OTHER_LOCALIZER = WrongStep(
    "the other localizer",
    {"finder": "the other"},
    Text(
        en="map → odom and its switch: amcl finds a robot on a map that is there, slam_toolbox makes the map while it drives, and where there is no map nobody sends this edge. Which of the three does `map_frame` say?",
        ko="map → odom과 그 스위치: amcl은 이미 있는 지도에서 로봇을 찾고, slam_toolbox는 달리면서 지도를 만들며, 지도가 없으면 아무도 이 연결을 보내지 않습니다. `map_frame`은 셋 가운데 무엇입니까?",
    ),
)

THIRD_LOCALIZER = WrongStep(
    "the third localizer",
    {"finder": "the third"},
    Text(
        en="map → odom and its switch do not fit what `map_frame` says: a map that is there, a map that is being made, or no map at all. Who finds the robot in each of the three, and does anybody?",
        ko="map → odom과 그 스위치가 `map_frame`과 맞지 않습니다. 지도가 있거나, 만들고 있거나, 아예 없습니다. 셋에서 각각 누가 로봇을 찾고, 찾기는 합니까?",
    ),
)

BOTH_ON = WrongStep(
    "both switches on",
    {"odom": "both"},
    Text(
        en="Two nodes send odom → base_footprint now. TF2 takes both, without an error, and the robot goes to and fro. One has to be switched off.",
        ko="이제 두 노드가 odom → base_footprint를 보냅니다. TF2는 오류 없이 둘 다 받고, 로봇은 오락가락합니다. 하나는 꺼야 합니다.",
    ),
    "M6",
)

OTHER_OWNER = WrongStep(
    "the other owner",
    {"odom": "the other"},
    Text(
        en="You gave odom → base_footprint to the other of the two, its switch with it. A filter owns the edge where there is something to fuse; where the wheels stand alone, they do.",
        ko="odom → base_footprint를 둘 가운데 다른 쪽에 맡기고 스위치도 그렇게 두었습니다. 합칠 것이 있으면 필터가, 바퀴뿐이면 바퀴가 이 연결을 맡습니다.",
    ),
    "M6",
)

SWITCHES_EXCHANGED = WrongStep(
    "switches exchanged",
    {"odom": "switches exchanged"},
    Text(
        en="The two switches stand the wrong way round: the node that you name as the owner is silent, and the other one sends.",
        ko="두 스위치가 반대입니다. 발행자로 적은 노드는 조용하고 다른 노드가 보냅니다.",
    ),
    "M6",
)

LOCALIZER_OWNS_BASE = WrongStep(
    "localizer owns the base",
    {"localizer": "the base"},
    Text(
        en="A localiser finds the robot on the map, and yet sends no edge to base_footprint: that frame has its parent. Who turns the wheels' counts into a pose?",
        ko="위치 추정 노드는 지도에서 로봇을 찾지만 base_footprint로 가는 연결은 보내지 않습니다. 그 좌표계에는 부모가 있습니다. 바퀴의 회전을 포즈로 바꾸는 것은 누구입니까?",
    ),
    "M7",
)

ALL_OFF = WrongStep(
    "all switches off",
    {"switches": "all off"},
    Text(
        en="With every switch off nobody sends the moving edges, and the tree falls apart. Each edge needs one owner: not two, and not none.",
        ko="스위치를 모두 끄면 움직이는 연결을 아무도 보내지 않아 트리가 나뉩니다. 연결마다 발행자가 하나 있어야 합니다. 둘이어도, 없어도 안 됩니다.",
    ),
    "M6",
)

BOTH_LOCALIZERS_ON = WrongStep(
    "both localizers on",
    {"switches": "both localizers on"},
    Text(
        en="amcl and slam_toolbox are both on, so two nodes send map → odom, and TF2 takes both. Whom you name as the owner changes nothing of that.",
        ko="amcl과 slam_toolbox를 모두 켰으므로 두 노드가 map → odom을 보내고 TF2는 둘 다 받습니다. 발행자로 누구를 적든 그대로입니다.",
    ),
    "M6",
)

DRIVER_ON = WrongStep(
    "driver switched on",
    {"lidar": "switched on"},
    Text(
        en="The driver's switch is on, so it says the laser's mount, too, beside the one whom you name as the owner. Two that agree today need not agree tomorrow.",
        ko="드라이버의 스위치를 켰으므로, 발행자로 적은 노드 말고 드라이버도 레이저의 장착을 보냅니다. 오늘은 둘이 같은 값을 보내도 내일은 다를 수 있습니다.",
    ),
    "M6",
)

DRIVER_REPEATS = WrongStep(
    "driver repeats the mount",
    {"lidar": "repeats"},
    Text(
        en="The mount stands in the URDF, and robot_state_publisher says it once, as a static transform. A driver that says it again is a second owner.",
        ko="장착 위치는 URDF에 있고, robot_state_publisher가 정적 변환으로 한 번 보냅니다. 드라이버가 또 보내면 발행자가 둘이 됩니다.",
    ),
    "M12",
)

ARM_BY_DRIVER = WrongStep(
    "arm by its driver",
    {"arm": "by the driver"},
    Text(
        en="joint_driver sends angles on /joint_states, no transforms. Who turns angles and a URDF into frames?",
        ko="joint_driver가 보내는 것은 /joint_states의 각도이지 변환이 아닙니다. 각도와 URDF로 좌표계를 만드는 것은 누구입니까?",
    ),
    "M12",
)


TASK = Task(
    id="E12.1",
    kind="O",
    points=4,
    title=Text(en="Who says what", ko="누가 무엇을 말합니까?"),
    answer="owners",
    form=Parts(
        {**{edge: Choice(NODES) for edge in EDGES}, **{switch: Choice(("True", "False")) for switch in SWITCHES}}
    ),
    given=a_robot,
    variants=6,
    model=owners,
    mistakes=(
        OTHER_LOCALIZER,
        THIRD_LOCALIZER,
        BOTH_ON,
        OTHER_OWNER,
        SWITCHES_EXCHANGED,
        LOCALIZER_OWNS_BASE,
        ALL_OFF,
        BOTH_LOCALIZERS_ON,
        DRIVER_REPEATS,
        DRIVER_ON,
        ARM_BY_DRIVER,
    ),
    means={
        "amcl": Text(
            en="amcl finds the robot on a map that is there, and sends map -> odom.",
            ko="amcl은 이미 있는 지도에서 로봇을 찾아 map -> odom을 보냅니다.",
        ),
        "slam_toolbox": Text(
            en="slam_toolbox makes a map while the robot drives, and sends map -> odom.",
            ko="slam_toolbox는 로봇이 달리는 동안 지도를 만들며 map -> odom을 보냅니다.",
        ),
        "wheel_odometry": Text(
            en="wheel_odometry knows what the wheels have counted, and sends odom -> base_footprint at the most.",
            ko="wheel_odometry는 바퀴가 센 것만 압니다. 보낸다면 odom -> base_footprint뿐입니다.",
        ),
        "ekf_filter_node": Text(
            en="The filter fuses wheels and imu, and sends odom -> base_footprint at the most.",
            ko="필터는 바퀴와 imu를 합칩니다. 보낸다면 odom -> base_footprint뿐입니다.",
        ),
        "lidar_driver": Text(
            en="A driver measures; where its sensor is bolted on it was only told.",
            ko="드라이버는 측정합니다. 센서가 어디에 달렸는지는 전해 들을 뿐입니다.",
        ),
        "joint_driver": Text(
            en="joint_driver sends the angles of joints, and no transforms.",
            ko="joint_driver가 보내는 것은 관절의 각도이지 변환이 아닙니다.",
        ),
        "robot_state_publisher": Text(
            en="robot_state_publisher sends what stands in the URDF, and nothing of where the robot is.",
            ko="robot_state_publisher는 URDF에 있는 것을 보냅니다. 로봇이 어디에 있는지는 모릅니다.",
        ),
        "nobody": Text(
            en="An edge that nobody sends is not there, and what hangs below it is cut off.",
            ko="아무도 보내지 않는 연결은 없는 것이고, 그 아래는 끊어집니다.",
        ),
        "True": Text(
            en="Switched on, this node sends its edge, whoever else does.",
            ko="켜면 다른 노드가 보내든 말든 이 노드도 연결을 보냅니다.",
        ),
        "False": Text(
            en="Switched off, this node sends no edge, and another one has to.",
            ko="끄면 이 노드는 연결을 보내지 않으므로 다른 노드가 보내야 합니다.",
        ),
    },
    shows={
        "map -> odom": Text(
            en="`map_frame` says who finds the robot on a map, and whether anybody does.",
            ko="지도에서 로봇을 찾는 것이 누구인지, 찾기는 하는지 `map_frame`에 적혀 있습니다.",
        ),
        "odom -> base_footprint": Text(
            en="This edge is made of the way that was driven. `odometry` says whose pose of it is to be believed.",
            ko="이 연결은 로봇이 달려온 길로 만듭니다. 누구의 포즈를 쓸지 `odometry`에 적혀 있습니다.",
        ),
        "base_footprint -> base_link": Text(
            en="This edge never moves, and stands in the URDF. Who reads the URDF?",
            ko="이 연결은 움직이지 않고 URDF에 있습니다. URDF를 읽는 것은 누구입니까?",
        ),
        "base_link -> laser_frame": Text(
            en="The mount is bolted on, and stands in the URDF. Who reads the URDF?",
            ko="장착은 고정되어 있고 URDF에 있습니다. URDF를 읽는 것은 누구입니까?",
        ),
        "wrist -> tool0": Text(
            en="This edge stands in the URDF. Who reads the URDF?",
            ko="이 연결은 URDF에 있습니다. URDF를 읽는 것은 누구입니까?",
        ),
        "amcl tf_broadcast": Text(
            en="Does `amcl` own an edge on this robot, by `map_frame`?",
            ko="`map_frame`을 보면 이 로봇에서 `amcl`이 맡은 연결이 있습니까?",
        ),
        "slam_toolbox publishes": Text(
            en="Does `slam_toolbox` own an edge on this robot, by `map_frame`?",
            ko="`map_frame`을 보면 이 로봇에서 `slam_toolbox`가 맡은 연결이 있습니까?",
        ),
        "wheel_odometry enable_odom_tf": Text(
            en="A switch is on where its node owns the edge, and off where another does. Who owns odom -> base_footprint here?",
            ko="스위치는 그 노드가 연결을 맡았을 때 켜고, 다른 노드가 맡았을 때 끕니다. 여기서 odom -> base_footprint를 맡은 것은 누구입니까?",
        ),
        "ekf publish_tf": Text(
            en="A switch is on where its node owns the edge, and off where another does. Who owns odom -> base_footprint here?",
            ko="스위치는 그 노드가 연결을 맡았을 때 켜고, 다른 노드가 맡았을 때 끕니다. 여기서 odom -> base_footprint를 맡은 것은 누구입니까?",
        ),
        "lidar_driver publish_tf": Text(
            en="Does anybody say the laser's mount already?",
            ko="레이저의 장착을 이미 보내는 노드가 있지 않습니까?",
        ),
    },
    hints=(
        Text(en="Go edge by edge: whose data is it made of?", ko="연결마다 물어보세요. 누구의 데이터로 만듭니까?"),
        Text(
            en="One owner each. Where a filter takes over an edge, its former owner is switched off.",
            ko="발행자는 하나씩입니다. 필터가 연결을 넘겨받으면 전 발행자의 스위치를 끕니다.",
        ),
        Text(
            en="What is bolted on or turned by a joint comes from the URDF, so from robot_state_publisher; every driver keeps quiet.",
            ko="고정된 것과 관절로 도는 것은 URDF에서, 곧 robot_state_publisher에서 옵니다. 드라이버는 보내지 않습니다.",
        ),
    ),
    misconceptions=("M6", "M7", "M12"),
)
