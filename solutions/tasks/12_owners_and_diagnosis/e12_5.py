"""E12.5: A robot from its specification."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Name, Parts, Set, Task, Text, Tree, WrongStep

TOPICS = ("/tf", "/tf_static")
BAGS = {
    "all": ["/tf", "/tf_static"],
    "moving only": ["/tf"],
    "statics only": ["/tf_static"],
    "with /odom": ["/tf", "/tf_static", "/odom"],
    "with /clock": ["/tf", "/tf_static", "/clock"],
}
OWNERS = ("localization", "wheel_odometry", "ekf_filter_node", "robot_state_publisher", "camera_driver")


def a_specification(rng):
    """Draw a robot's name, its camera, and whether it fuses."""
    return {
        "robot": str(rng.choice(["alpha", "bravo", "carrier2", "dolly"])),
        "sensor": str(rng.choice(["camera", "rgb", "depth"])),
        "fused": bool(rng.integers(2)),
        "camera_driver_publishes_tf": True,
    }


def robot(
    given, *, prefix="own", map="shared", chain="whole", camera="on the base", optical="below the camera",
    more="nothing", moving="again and again", mounts="static", localizer="map to odom", fuse="as given", owner="one",
    driver="quiet", bag="all",
):  # fmt: skip
    """Return the robot, step by step; other steps are the slips."""
    odom, foot, base = "odom", "base_footprint", "base_link"
    link, seen = f"{given.sensor}_link", f"{given.sensor}_optical_frame"
    tree = {odom: "map", foot: odom, base: foot, link: {"on the base": base, "on the footprint": foot}[camera]}
    tree[seen] = tree[link] if optical == "beside the camera" else link
    if chain == "no footprint":
        tree = {child: odom if parent == foot else parent for child, parent in tree.items() if child != foot}
    elif chain == "footprint below the base":
        tree |= {base: odom, foot: base}
    if optical == "left out":
        del tree[seen]
    elif optical == "above the camera":
        tree |= {seen: tree[link], link: seen}
    if localizer == "map to base":
        tree[foot] = "map"
    if map == "left out":
        del tree[odom]
    tree = _called(tree, given, prefix, {link, seen}, "" if map == "own" else "map")
    if more == "the first robot's":
        tree |= {odom: "map", foot: odom, base: foot, link: base, seen: link}
    fused = bool(given.fused) != (fuse == "the other way")
    switch = {"both": True, "none": False}.get(owner)
    return {
        "tree": tree,
        "moving": "/tf_static" if moving == "static" else "/tf",
        "mounts": "/tf" if mounts == "moving" else "/tf_static",
        "odom owner": "ekf_filter_node" if fused else "wheel_odometry",
        "mounts owner": "robot_state_publisher",
        "wheel_odometry publish_tf": not fused if switch is None else switch,
        "ekf publish_tf": fused if switch is None else switch,
        "camera_driver publish_tf": driver == "on",
        "bag": BAGS[bag],
    }


def _called(tree, given, prefix, sensors, bare):
    """Return a tree with the robot's name before its frames; before which of them, `prefix` says."""

    def name(frame, side):
        without = {
            "own": False, "none": True, "not the sensor's": frame in sensors, "not odom's": frame == "odom",
            "not the parents'": side == "parent", "not the children's": side == "child",
        }[prefix]  # fmt: skip
        return frame if frame == bare or without else f"{given.robot}/{frame}"

    return {name(child, "child"): name(parent, "parent") for child, parent in tree.items()}


NO_OPTICAL = WrongStep(
    "no optical frame",
    {"optical": "left out"},
    Text(
        en="The pictures are stamped with an optical frame: z forward, x right, y down. Without it in the tree every point lies beside itself by a quarter turn, or nowhere.",
        ko="영상의 header에는 optical frame이 적힙니다. z가 앞, x가 오른쪽, y가 아래입니다. 트리에 없으면 점이 90도 돌아가거나 아예 놓이지 못합니다.",
    ),
    "M4",
)

MOUNTS_ON_TF = WrongStep(
    "mounts on /tf",
    {"mounts": "moving"},
    Text(
        en="What is bolted on needs saying once, for everybody who comes later too. On /tf it is forgotten after ten seconds, or sent for ever.",
        ko="고정된 것은 한 번 보내면 나중에 온 쪽도 알아야 합니다. /tf에 보내면 10초 뒤에 잊히거나 끝없이 보내야 합니다.",
    ),
    "M12",
)

NO_PREFIX = WrongStep(
    "no prefix",
    {"prefix": "none"},
    Text(
        en="A second robot has an odom and a base_link, too. TF2 has one tree for all: every frame of this robot but the shared one carries its name.",
        ko="두 번째 로봇에도 odom과 base_link가 있습니다. TF2의 트리는 모두의 것입니다. 함께 쓰는 것 말고는 모든 좌표계 앞에 로봇의 이름이 붙습니다.",
    ),
    "M14",
)

HALF_A_BAG = WrongStep(
    "bag without statics",
    {"bag": "moving only"},
    Text(
        en="Played tomorrow, that bag has no mounts: they were said once, before anything moved. Record both topics.",
        ko="내일 그 bag을 재생하면 장착 변환이 없습니다. 움직이기 전에 한 번 보냈기 때문입니다. 두 토픽을 모두 기록하십시오.",
    ),
    "M13",
)

MAP_TO_BASE = WrongStep(
    "map to base",
    {"localizer": "map to base"},
    Text(
        en="The footprint has its parent by the wheels. A localiser sends the edge above odom.",
        ko="footprint의 부모는 바퀴가 이미 정했습니다. 위치 추정 노드는 odom 위의 연결을 보냅니다.",
    ),
    "M7",
)

TWO_OWNERS = WrongStep(
    "two owners",
    {"owner": "both"},
    Text(
        en="Filter and wheels both send odom → base_footprint now. Leave one switch on.",
        ko="필터와 바퀴가 함께 odom → base_footprint를 보냅니다. 스위치는 하나만 켜 두십시오.",
    ),
    "M6",
)

MOVING_AS_STATIC = WrongStep(
    "moving as static",
    {"moving": "static"},
    Text(
        en="What moves is sent as static now: it is heard once, and then the robot stands still on the map for ever.",
        ko="움직이는 것을 정적으로 보냅니다. 한 번만 보내므로 로봇이 지도 위에 영원히 서 있게 됩니다.",
    ),
    "M12",
)

BAG_OF_STATICS = WrongStep(
    "bag of statics",
    {"bag": "statics only"},
    Text(
        en="That bag holds the mounts alone: nothing in it moves, so nothing hangs on map.",
        ko="그 bag에는 장착뿐입니다. 움직이는 것이 없으니 map에 이어지는 것도 없습니다.",
    ),
    "M13",
)

ODOMETRY_IN_THE_BAG = WrongStep(
    "odometry in the bag",
    {"bag": "with /odom"},
    Text(
        en="The tree needs transforms. /odom is a message that nobody turns into one tomorrow.",
        ko="트리에는 변환이 필요합니다. /odom은 메시지일 뿐이고, 내일 그것을 변환으로 만들 노드는 없습니다.",
    ),
    "M13",
)

CLOCK_IN_THE_BAG = WrongStep(
    "clock in the bag",
    {"bag": "with /clock"},
    Text(
        en="A real robot has no /clock; the player makes one, if it is asked to.",
        ko="실제 로봇에는 /clock이 없습니다. 재생기에 부탁하면 재생기가 만듭니다.",
    ),
    "M13",
)

NO_FOOTPRINT = WrongStep(
    "no footprint",
    {"chain": "no footprint"},
    Text(
        en="The specification has a base_footprint between odom and base_link. Without it wheels and filter send an edge that hangs beside your tree.",
        ko="사양서에는 odom과 base_link 사이에 base_footprint가 있습니다. 없으면 바퀴와 필터가 보내는 연결이 트리 옆에 따로 남습니다.",
    ),
)

OWN_MAP = WrongStep(
    "a map of its own",
    {"map": "own"},
    Text(
        en="With a name before map the two robots have two maps: nothing connects them.",
        ko="map에도 이름을 붙이면 두 로봇의 지도가 따로 있게 됩니다. 둘을 잇는 것이 없습니다.",
    ),
    "M14",
)

OPTICAL_ON_THE_BASE = WrongStep(
    "optical frame on the base",
    {"optical": "beside the camera"},
    Text(
        en="The optical frame turns the camera's axes; it hangs on the camera's link, not beside it.",
        ko="optical frame은 카메라의 축을 돌린 것입니다. 카메라의 link 옆이 아니라 그 아래에 달립니다.",
    ),
    "M4",
)

OPTICAL_ABOVE = WrongStep(
    "optical frame above the camera",
    {"optical": "above the camera"},
    Text(
        en="You have the optical frame above the camera's link. The link is what is bolted on; the optical frame only turns its axes.",
        ko="광학 좌표계가 카메라 링크 위에 있습니다. 로봇에 고정된 것은 링크이고, 광학 좌표계는 그 축을 돌릴 뿐입니다.",
    ),
    "M4",
)

CAMERA_ON_THE_FOOTPRINT = WrongStep(
    "camera on the footprint",
    {"camera": "on the footprint"},
    Text(
        en="You hang the camera on base_footprint, the robot's shadow on the floor. What is it bolted to?",
        ko="카메라를 base_footprint에 이었습니다. 바닥에 비친 그림자입니다. 카메라는 무엇에 고정되어 있습니까?",
    ),
)

FOOTPRINT_BELOW = WrongStep(
    "footprint below the base",
    {"chain": "footprint below the base"},
    Text(
        en="Odometry sends the edge from odom to base_footprint. With the footprint below base_link that child has two parents.",
        ko="오도메트리가 보내는 연결은 odom에서 base_footprint로 갑니다. base_footprint가 base_link 아래에 있으면 부모가 둘이 됩니다.",
    ),
    "M6",
)

NOT_BELOW_MAP = WrongStep(
    "not below map",
    {"map": "left out"},
    Text(
        en="Nothing hangs on map now, so the two robots know nothing of each other.",
        ko="map에 이어진 것이 없습니다. 그러면 두 로봇은 서로의 위치를 모릅니다.",
    ),
    "M7",
)

SENSOR_WITHOUT_NAME = WrongStep(
    "sensor without the name",
    {"prefix": "not the sensor's"},
    Text(
        en="The sensor's frames lack the robot's name. Bolt the same sensor on the other robot, and one frame has two parents.",
        ko="센서의 좌표계에 로봇 이름이 없습니다. 다른 로봇에도 같은 센서를 달면 좌표계 하나의 부모가 둘이 됩니다.",
    ),
    "M14",
)

ODOM_SHARED = WrongStep(
    "odom shared",
    {"prefix": "not odom's"},
    Text(
        en="The two robots share an odom now. Each begins to count its way at a place of its own.",
        ko="두 로봇이 odom을 함께 씁니다. 로봇마다 길을 세기 시작한 곳이 다릅니다.",
    ),
    "M14",
)

PARENTS_WITHOUT_NAME = WrongStep(
    "parents without the name",
    {"prefix": "not the parents'"},
    Text(
        en="Only the children have the robot's name. A parent is a child itself, one edge higher, and is called the same there.",
        ko="자식에만 로봇 이름이 있습니다. 부모도 한 단계 위에서는 자식이고, 이름은 같아야 합니다.",
    ),
    "M14",
)

CHILDREN_WITHOUT_NAME = WrongStep(
    "children without the name",
    {"prefix": "not the children's"},
    Text(
        en="Only the parents have the robot's name. A child is a parent itself, one edge lower, and is called the same there.",
        ko="부모에만 로봇 이름이 있습니다. 자식도 한 단계 아래에서는 부모이고, 이름은 같아야 합니다.",
    ),
    "M14",
)

FIRST_ROBOTS_TOO = WrongStep(
    "the first robot's, too",
    {"more": "the first robot's"},
    Text(
        en="There are frames without a name among them. The first robot has a tree already; asked is that of the second.",
        ko="로봇 이름이 없는 좌표계도 들어 있습니다. 첫째 로봇의 트리는 이미 있습니다. 구할 것은 둘째 로봇의 트리입니다.",
    ),
)

THE_OTHER_OWNER = WrongStep(
    "the other owner",
    {"fuse": "the other way"},
    Text(
        en="Of the two switches you have the other one on. What does `fused` say, and who makes the better pose of wheels and imu then?",
        ko="두 스위치 가운데 다른 쪽을 켰습니다. `fused`는 무엇이라고 합니까? 그렇다면 바퀴와 imu로 더 나은 포즈를 만드는 것은 누구입니까?",
    ),
    "M6",
)

NO_OWNER = WrongStep(
    "no owner",
    {"owner": "none"},
    Text(
        en="Both switches are off, so nobody sends the edge below odom, and the tree falls apart.",
        ko="스위치가 둘 다 꺼져 있어 odom 아래 연결을 아무도 보내지 않습니다. 트리가 나뉩니다.",
    ),
    "M6",
)

DRIVER_TOO = WrongStep(
    "the driver, too",
    {"driver": "on"},
    Text(
        en="The driver says the camera's edges once more: a second owner of what the URDF has.",
        ko="드라이버가 카메라의 연결을 한 번 더 보냅니다. URDF에 있는 것의 두 번째 발행자입니다.",
    ),
    "M6",
)


TASK = Task(
    id="E12.5",
    kind="T",
    points=5,
    title=Text(en="A robot from its specification", ko="사양서로 만드는 로봇"),
    answer="robot",
    form=Parts(
        {
            "tree": Tree(),
            "moving": Choice(TOPICS),
            "mounts": Choice(TOPICS),
            "odom owner": Choice(OWNERS),
            "mounts owner": Choice(OWNERS),
            "wheel_odometry publish_tf": Choice(("True", "False")),
            "ekf publish_tf": Choice(("True", "False")),
            "camera_driver publish_tf": Choice(("True", "False")),
            "bag": Set(Name(topic=True)),
        }
    ),
    given=a_specification,
    variants=6,
    model=robot,
    mistakes=(
        NO_PREFIX,
        NO_OPTICAL,
        MOUNTS_ON_TF,
        MAP_TO_BASE,
        TWO_OWNERS,
        HALF_A_BAG,
        MOVING_AS_STATIC,
        BAG_OF_STATICS,
        ODOMETRY_IN_THE_BAG,
        CLOCK_IN_THE_BAG,
        NO_FOOTPRINT,
        OWN_MAP,
        OPTICAL_ON_THE_BASE,
        OPTICAL_ABOVE,
        CAMERA_ON_THE_FOOTPRINT,
        FOOTPRINT_BELOW,
        NOT_BELOW_MAP,
        SENSOR_WITHOUT_NAME,
        ODOM_SHARED,
        PARENTS_WITHOUT_NAME,
        CHILDREN_WITHOUT_NAME,
        FIRST_ROBOTS_TOO,
        THE_OTHER_OWNER,
        NO_OWNER,
        DRIVER_TOO,
    ),
    shows={
        "bag": Text(
            en="A tree is made of transforms, and of nothing else. Which topics carry them, as `ros2 topic list` prints them?",
            ko="트리는 변환으로만 만들어집니다. 변환이 담긴 토픽은 무엇이고, `ros2 topic list`에는 어떻게 적혀 있습니까?",
        ),
        "moving": Text(
            en="What moves is said again and again; who comes later hears the next one. Which topic is for that?",
            ko="움직이는 것은 거듭 보내므로 늦게 온 쪽도 다음 것을 받습니다. 그런 것은 어느 토픽으로 보냅니까?",
        ),
        "mounts": Text(
            en="What is bolted on is said once, for whoever comes later, too. Which topic keeps it?",
            ko="고정된 것은 한 번 보내고, 늦게 온 쪽도 알아야 합니다. 그것을 간직하는 토픽은 무엇입니까?",
        ),
        "odom owner": Text(
            en="The edge below odom is made of wheels, or of wheels and imu: `fused` says which.",
            ko="odom 아래 연결은 바퀴로, 또는 바퀴와 imu로 만듭니다. 어느 쪽인지 `fused`가 알려 줍니다.",
        ),
        "mounts owner": Text(
            en="What is bolted on stands in the URDF. Who reads it?",
            ko="고정된 것은 URDF에 있습니다. URDF를 읽는 것은 누구입니까?",
        ),
        "wheel_odometry publish_tf": Text(
            en="The switch is on where the wheels own the edge below odom: see `fused`.",
            ko="바퀴 노드가 odom 아래 연결을 맡을 때 켭니다. `fused`를 보십시오.",
        ),
        "ekf publish_tf": Text(
            en="The switch is on where the filter owns the edge below odom: see `fused`.",
            ko="필터가 odom 아래 연결을 맡을 때 켭니다. `fused`를 보십시오.",
        ),
        "camera_driver publish_tf": Text(
            en="Does anybody say the camera's edges already? `camera_driver_publishes_tf` tells what the driver does when nobody forbids it.",
            ko="카메라의 연결을 이미 보내는 노드가 있습니다. `camera_driver_publishes_tf`는 막지 않으면 드라이버가 하는 일입니다.",
        ),
    },
    hints=(
        Text(
            en="Write the frames of one robot first, from map down to the optical frame, each with one parent.",
            ko="먼저 로봇 하나의 좌표계를 map부터 optical frame까지 쓰고, 저마다 부모를 하나씩 주십시오.",
        ),
        Text(
            en="Then the name before every frame but map. What is bolted on goes to /tf_static.",
            ko="그다음 map을 뺀 모든 좌표계 앞에 이름을 붙입니다. 고정된 것은 /tf_static으로 갑니다.",
        ),
        Text(
            en="The edge from odom has one owner: the filter if there is one, and then the wheels' switch is off. A driver keeps quiet.",
            ko="odom의 연결은 발행자가 하나입니다. 필터가 있으면 필터이고, 그때 바퀴의 스위치는 끕니다. 드라이버는 보내지 않습니다.",
        ),
    ),
    misconceptions=("M4", "M6", "M7", "M12", "M13", "M14"),
)
