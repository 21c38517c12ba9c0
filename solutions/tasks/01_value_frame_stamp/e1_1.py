"""E1.1: One place, three triples."""

from __future__ import annotations

from tflab.workbook.tasks import Parts, Task, Text, Vector, WrongAnswer, WrongStep


def robot_and_post(rng):
    return {
        "map_p_base": [round(float(rng.uniform(low, high)), 2) for low, high in ((3, 8), (-3, -1), (0.05, 0.12))],
        "base_p_laser": [
            round(float(rng.uniform(low, high)), 2) for low, high in ((0.15, 0.3), (0.05, 0.12), (0.14, 0.3))
        ],
        "laser_p_post": [round(float(rng.uniform(low, high)), 2) for low, high in ((1.5, 4), (0.4, 1.2), (0.33, 0.6))],
    }


def plus(*points):
    return [sum(numbers) for numbers in zip(*points, strict=True)]


def answer(base, map_):
    return {"base_link": base, "map": map_}


SIGN = {"added": 1.0, "taken away": -1.0, "skipped": 0.0, "turned round": 1.0, "twice": 2.0}


def both(g, *, side="left", mount="added", way="laser to post", height="added", start="base_link", robot="added"):
    """Return where the post is, step by step; other steps are the slips."""
    x, y, z = g.laser_p_post
    seen = [x, -y if side == "right" else y, z]
    kept = {"x alone": "x", "without y": "xz"}.get(mount, "xyz")
    there = [
        SIGN.get(mount, 1.0) * n if letter in kept else 0.0 for letter, n in zip("xyz", g.base_p_laser, strict=True)
    ]
    base = plus(there, [seen, [-one for one in seen]][way == "mount minus post"])
    base = plus(g.map_p_base, g.base_p_laser) if way == "the laser in map" else base
    starts = {
        "base_link": base,
        "laser": seen,
        "mount twice": plus(base, g.base_p_laser),
        "robot alone": g.base_p_laser,
    }
    map_ = plus([SIGN[robot] * number for number in g.map_p_base], starts[start])
    map_ = plus(map_, g.laser_p_post, [-number for number in g.map_p_base]) if way == "the laser in map" else map_
    map_ = plus(g.map_p_base, [-number for number in starts[start]]) if robot == "turned round" else map_
    heights = {"added": (base[2], map_[2]), "the laser's": (z, z), "floor": (0.0, 0.0),
               "robot's forgotten": (base[2], map_[2] - g.map_p_base[2])}[height]  # fmt: skip
    return answer([*base[:2], heights[0]], [*map_[:2], heights[1]])


SAME_NUMBERS = WrongAnswer(
    "same numbers",
    lambda g: answer(g.laser_p_post, g.laser_p_post),
    Text(
        en="These are the laser's numbers with other labels. A frame is not a name to be changed: count the way from each frame's own origin.",
        ko="레이저의 숫자에 이름표만 바꾸어 달았습니다. 좌표계는 이름만 바꾼다고 바뀌지 않습니다. 각 좌표계의 원점에서 기둥까지 다시 재어 보세요.",
    ),
)


TAKEN_AWAY = WrongStep(
    "taken away",
    {"mount": "taken away", "robot": "taken away"},
    Text(
        en="You took the steps away. The laser sits ahead of the robot's middle, so from the middle the way to the post is that much longer: the steps add.",
        ko="이동을 뺐습니다. 레이저는 로봇의 중심보다 앞에 있으므로, 중심에서 기둥까지는 그만큼 더 멉니다. 이동은 더합니다.",
    ),
    "M3",
)


MOUNT_TAKEN_AWAY = WrongStep(
    "mount taken away",
    {"mount": "taken away"},
    Text(
        en="The laser's mount has the wrong sign. It sits ahead of and above the middle: from there the post is farther ahead and higher, not less.",
        ko="레이저 장착 위치의 부호가 틀렸습니다. 레이저는 중심보다 앞쪽 위에 있습니다. 중심에서 보면 기둥은 더 앞에, 더 높이 있습니다.",
    ),
    "M3",
)


MOUNT_SKIPPED = WrongStep(
    "mount skipped",
    {"mount": "skipped"},
    Text(
        en="You left the mount out, as if the laser sat in the robot's middle. From the laser to the map there are two steps.",
        ko="레이저가 로봇의 중심에 있는 것처럼 장착 위치를 빠뜨렸습니다. 레이저에서 지도까지는 이동이 두 번입니다.",
    ),
)


MOUNT_SKIPPED_ON_THE_MAP = WrongStep(
    "mount skipped on the map",
    {"start": "laser"},
    Text(
        en="For the map you went on from the laser's numbers: start from where you have just arrived, in base_link.",
        ko="지도로 갈 때 레이저를 단 위치를 건너뛰고 레이저의 숫자에서 다시 시작했습니다. 방금 구한 base_link 기준 값에서 이어 가 보세요.",
    ),
)


MOUNT_TWICE = WrongStep(
    "mount twice",
    {"start": "mount twice"},
    Text(
        en="On the map the mount is counted twice. It is already in your numbers of base_link.",
        ko="지도에서 장착 위치를 두 번 셌습니다. base_link 기준 값에 이미 들어 있습니다.",
    ),
)


HEIGHT_FORGOTTEN = WrongStep(
    "height forgotten",
    {"height": "the laser's"},
    Text(
        en="The heights are still the laser's. z adds like the others.",
        ko="높이는 아직 레이저 기준입니다. z도 똑같이 더합니다.",
    ),
)


NOT_ON_THE_MAP = WrongStep(
    "not on the map",
    {"robot": "skipped"},
    Text(
        en="On the map the robot's own place is missing. It does not stand in the map's corner: `map_p_base` comes on top.",
        ko="지도 기준 값에 로봇의 위치가 빠졌습니다. 로봇은 지도 원점에 서 있지 않으므로 `map_p_base`를 더해야 합니다.",
    ),
)

ROBOT_TAKEN_AWAY = WrongStep(
    "robot taken away",
    {"robot": "taken away"},
    Text(
        en="You took the robot's place away. The robot stands at `map_p_base`: from the map's origin one walks there first, and then on to the post.",
        ko="로봇의 위치를 뺐습니다. 로봇은 `map_p_base`에 있습니다. 지도 원점에서 먼저 거기까지 가고, 이어서 기둥까지 갑니다.",
    ),
    "M3",
)

Y_TO_THE_RIGHT = WrongStep(
    "y to the right",
    {"side": "right"},
    Text(
        en="The post's y went in with a minus, as if it counted to the right. In ROS, y points to the left.",
        ko="기둥의 y를 오른쪽으로 잰 것처럼 빼서 계산했습니다. ROS에서 y는 왼쪽을 가리킵니다.",
    ),
)

ON_THE_FLOOR = WrongStep(
    "on the floor",
    {"height": "floor"},
    Text(
        en="The heights are zero. The laser sits up on the robot and saw the post higher still: z adds like x and y.",
        ko="높이가 0입니다. 레이저는 로봇 위에 있고 기둥을 더 높은 곳에서 보았습니다. z도 x, y처럼 더합니다.",
    ),
)

ONLY_THE_MOUNT = WrongStep(
    "only the mount on the map",
    {"start": "robot alone"},
    Text(
        en="On the map you have the place of the laser, not of the post: what the laser saw has to be added.",
        ko="지도 기준으로 레이저의 위치를 썼습니다. 레이저가 본 것까지 더해야 기둥의 위치입니다.",
    ),
)


ROBOT_MINUS_POST = WrongStep(
    "robot minus post",
    {"robot": "turned round"},
    Text(
        en="On the map you took the way to the post off the robot's place. The post lies ahead of the robot: from the robot's place one walks on.",
        ko="지도에서 로봇의 위치에서 기둥까지의 거리를 뺐습니다. 기둥은 로봇 앞에 있으므로 로봇의 위치에서 더 가야 합니다.",
    ),
    "M3",
)


MOUNT_MINUS_POST = WrongStep(
    "mount minus post",
    {"way": "mount minus post"},
    Text(
        en="You took the laser's numbers off the mount. From the laser one goes on to the post: the two add.",
        ko="장착 위치에서 레이저의 숫자를 뺐습니다. 레이저에서 기둥까지 더 가야 하므로 둘을 더합니다.",
    ),
    "M3",
)


THE_LASER_IN_MAP = WrongStep(
    "the laser in map",
    {"way": "the laser in map"},
    Text(
        en="Under base_link you wrote where the laser is on the map. The robot's place on the map has no part in what is counted from the robot.",
        ko="base_link에 지도에서 레이저의 위치를 썼습니다. 로봇에서 셀 때 지도 위 로봇의 위치는 들어가지 않습니다.",
    ),
)


MOUNT_ALONG_X = WrongStep(
    "mount along x alone",
    {"mount": "x alone"},
    Text(
        en="Of the mount you added x alone. It also sits to one side and higher up: y and z add like x.",
        ko="장착 위치에서 x만 더했습니다. 레이저는 옆으로, 위로도 떨어져 있습니다. y와 z도 x처럼 더합니다.",
    ),
)


MOUNT_WITHOUT_Y = WrongStep(
    "mount without y",
    {"mount": "without y"},
    Text(
        en="The mount's y is missing: the laser does not sit in the middle, but a little to one side.",
        ko="장착 위치의 y가 빠졌습니다. 레이저는 한가운데가 아니라 옆으로 조금 치우쳐 있습니다.",
    ),
)


ROBOT_TWICE = WrongStep(
    "robot twice",
    {"robot": "twice"},
    Text(
        en="On the map the robot's place is counted twice. Once, and the way from the map's origin is whole.",
        ko="지도에서 로봇의 위치를 두 번 더했습니다. 한 번만 더하면 지도 원점에서 오는 길이 됩니다.",
    ),
)


HEIGHT_OF_THE_ROBOT = WrongStep(
    "height of the robot",
    {"height": "robot's forgotten"},
    Text(
        en="On the map the height lacks the robot's own: `map_p_base` has a z, too.",
        ko="지도 기준 높이에 로봇의 높이가 빠졌습니다. `map_p_base`에도 z가 있습니다.",
    ),
)


TASK = Task(
    id="E1.1",
    kind="N",
    points=4,
    title=Text(en="One place, three triples", ko="한 위치, 세 가지 숫자"),
    answer="post",
    form=Parts({frame: Vector(3, unit="m", frame=frame, tolerance=0.003) for frame in ("base_link", "map")}),
    given=robot_and_post,
    variants=6,
    model=both,
    mistakes=(
        SAME_NUMBERS,
        TAKEN_AWAY,
        MOUNT_TAKEN_AWAY,
        MOUNT_SKIPPED,
        MOUNT_SKIPPED_ON_THE_MAP,
        MOUNT_TWICE,
        HEIGHT_FORGOTTEN,
        NOT_ON_THE_MAP,
        ROBOT_TAKEN_AWAY,
        Y_TO_THE_RIGHT,
        ON_THE_FLOOR,
        ONLY_THE_MOUNT,
        ROBOT_MINUS_POST,
        MOUNT_MINUS_POST,
        THE_LASER_IN_MAP,
        MOUNT_ALONG_X,
        MOUNT_WITHOUT_Y,
        ROBOT_TWICE,
        HEIGHT_OF_THE_ROBOT,
    ),
    hints=(
        Text(
            en="Draw the robot from the side, and the laser on it.",
            ko="로봇을 옆에서 본 모습과 그 위의 레이저를 그려 보세요.",
        ),
        Text(
            en="Stand in base_link: first walk to the laser, then go on to the post.",
            ko="base_link에 서 있다고 생각해 보세요. 먼저 레이저까지 가고, 거기서 기둥까지 더 갑니다.",
        ),
        Text(
            en="While nobody is turned, add part by part: base = mount + laser's numbers, map = robot's place + base.",
            ko="회전이 없으면 성분끼리 더합니다. base = 장착 위치 + 레이저의 숫자, map = 로봇의 위치 + base입니다.",
        ),
    ),
    misconceptions=("M3",),
)
