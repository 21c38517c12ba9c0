"""E12.5: A robot from its specification."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Name, Parts, Set, Slip, Task, Tree, Words

TOPICS = ("/tf", "/tf_static")
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
    given, *, prefix="own", optical="below the camera", mounts="static", localizer="map to odom", owner="one", bag="all"
):
    """Return the robot, step by step; other steps are the slips."""
    own = f"{given.robot}/" if prefix == "own" else ""
    odom, foot, base = f"{own}odom", f"{own}base_footprint", f"{own}base_link"
    camera, seen = f"{own}{given.sensor}_link", f"{own}{given.sensor}_optical_frame"
    tree = {odom: "map", foot: odom, base: foot, camera: base, seen: camera}
    if optical == "left out":
        del tree[seen]
    if localizer == "map to base":
        tree = {**tree, odom: "map", foot: "map"}
    fused = bool(given.fused)
    return {
        "tree": tree,
        "moving": "/tf",
        "mounts": "/tf" if mounts == "moving" else "/tf_static",
        "odom owner": "ekf_filter_node" if fused else "wheel_odometry",
        "mounts owner": "robot_state_publisher",
        "wheel_odometry publish_tf": True if owner == "both" else not fused,
        "ekf publish_tf": True if owner == "both" else fused,
        "camera_driver publish_tf": False,
        "bag": ["/tf"] if bag == "moving only" else ["/tf", "/tf_static"],
    }


NO_OPTICAL = Slip(
    "no optical frame",
    {"optical": "left out"},
    Words(
        en="The pictures are stamped with an optical frame: z forward, x right, y down. Without it in the tree every point lies beside itself by a quarter turn, or nowhere.",
        ko="영상의 header에는 optical frame이 적힙니다. z가 앞, x가 오른쪽, y가 아래입니다. 트리에 없으면 점이 90도 돌아가거나 아예 놓이지 못합니다.",
    ),
    "M4",
)

MOUNTS_ON_TF = Slip(
    "mounts on /tf",
    {"mounts": "moving"},
    Words(
        en="What is bolted on needs saying once, for everybody who comes later too. On /tf it is forgotten after ten seconds, or sent for ever.",
        ko="고정된 것은 한 번 말하면 나중에 온 쪽도 알아야 합니다. /tf에 보내면 10초 뒤에 잊히거나 끝없이 보내야 합니다.",
    ),
    "M12",
)

NO_PREFIX = Slip(
    "no prefix",
    {"prefix": "none"},
    Words(
        en="A second robot has an odom and a base_link, too. TF2 has one tree for all: every frame of this robot but the shared one carries its name.",
        ko="두 번째 로봇에도 odom과 base_link가 있습니다. TF2의 트리는 모두의 것입니다. 함께 쓰는 것 말고는 모든 좌표계 앞에 로봇의 이름이 붙습니다.",
    ),
    "M14",
)

HALF_A_BAG = Slip(
    "bag without statics",
    {"bag": "moving only"},
    Words(
        en="Played tomorrow, that bag has no mounts: they were said once, before anything moved. Record both topics.",
        ko="내일 그 bag을 재생하면 장착 변환이 없습니다. 움직이기 전에 한 번 말했기 때문입니다. 두 토픽을 모두 기록하십시오.",
    ),
    "M13",
)

MAP_TO_BASE = Slip(
    "map to base",
    {"localizer": "map to base"},
    Words(
        en="The footprint has its parent by the wheels. A localiser sends the edge above odom.",
        ko="footprint의 부모는 바퀴가 이미 정했습니다. 위치 추정 노드는 odom 위의 연결을 보냅니다.",
    ),
    "M7",
)

TWO_OWNERS = Slip(
    "two owners",
    {"owner": "both"},
    Words(
        en="Filter and wheels both send odom → base_footprint now. Leave one switch on.",
        ko="필터와 바퀴가 함께 odom → base_footprint를 보냅니다. 스위치는 하나만 켜 두십시오.",
    ),
    "M6",
)


TASK = Task(
    id="E12.5",
    kind="T",
    points=5,
    title=Words(en="A robot from its specification", ko="사양서로 만드는 로봇"),
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
            "bag": Set(Name()),
        }
    ),
    given=a_specification,
    variants=6,
    model=robot,
    twins=(NO_PREFIX, NO_OPTICAL, MOUNTS_ON_TF, MAP_TO_BASE, TWO_OWNERS, HALF_A_BAG),
    hints=(
        Words(
            en="Write the frames of one robot first, from map down to the optical frame, each with one parent.",
            ko="먼저 로봇 하나의 좌표계를 map부터 optical frame까지 쓰고, 저마다 부모를 하나씩 주십시오.",
        ),
        Words(
            en="Then the name before every frame but map. What is bolted on goes to /tf_static.",
            ko="그다음 map을 뺀 모든 좌표계 앞에 이름을 붙입니다. 고정된 것은 /tf_static으로 갑니다.",
        ),
        Words(
            en="The edge from odom has one owner: the filter if there is one, and then the wheels' switch is off. A driver keeps quiet.",
            ko="odom의 연결은 발행자가 하나입니다. 필터가 있으면 필터이고, 그때 바퀴의 스위치는 끕니다. 드라이버는 말하지 않습니다.",
        ),
    ),
    cures=("M4", "M6", "M7", "M12", "M13", "M14"),
)
