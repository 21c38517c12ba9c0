"""E5.2: A loop closes."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Number, Parts, Pose, Task, Text, Vector, WrongAnswer

from .draws import by_parts, on_the_floor


def closing_loop(rng):
    """The robot is found some way beside where it was believed, and turned; odom's origin slides another way."""
    while True:
        given = _one_loop(rng)
        new_edge = given["found_T_base"] @ given["odom_T_base"].inverse()
        slide_m = math.dist(new_edge.translation, given["map_T_odom"].translation)
        believed = given["map_T_odom"] @ given["odom_T_base"]
        leap_m = math.dist(believed.translation, given["found_T_base"].translation)
        sides_m = sum(abs(a - b) for a, b in zip(believed.translation, given["found_T_base"].translation, strict=True))
        origin_m = [math.hypot(*pose.translation) for pose in (believed, given["found_T_base"])]
        farther_m = abs(origin_m[1] - origin_m[0])
        apart = (abs(slide_m - leap_m), abs(slide_m - sides_m), sides_m - leap_m, leap_m - farther_m, farther_m)
        if min(apart) > 0.05:
            return given


def _one_loop(rng):
    map_T_odom, odom_T_base = on_the_floor(rng, 2.0), on_the_floor(rng, 4.0)
    way = float(rng.choice([-1.0, 1.0]))
    aside = Transform.from_rpy(
        yaw=way * float(rng.uniform(0.1, 0.3)),
        translation=(float(rng.uniform(0.3, 0.7)), float(rng.uniform(0.2, 0.5)), 0.0),
    )
    found = map_T_odom @ odom_T_base @ aside
    x, y, _ = found.translation
    found = Transform.from_rpy(yaw=round(found.rpy()[2], 2), translation=(round(x, 2), round(y, 2), 0.0))
    return {"map_T_odom": map_T_odom, "odom_T_base": odom_T_base, "found_T_base": found}


def closure(g, believed=None, jump=None, edge=None, step=0.0):
    believed = list((g.map_T_odom @ g.odom_T_base).translation[:2]) if believed is None else list(believed)
    return {
        "believed": believed,
        "jump_m": math.dist(believed, g.found_T_base.translation[:2]) if jump is None else jump,
        "map_T_odom": g.found_T_base @ g.odom_T_base.inverse() if edge is None else edge,
        "step_in_odom_m": step,
    }


def jump_of_the_edge(g):
    new = g.found_T_base @ g.odom_T_base.inverse()
    return closure(g, jump=math.dist(new.translation, g.map_T_odom.translation))


def odometry_is_reset(g):
    before = g.map_T_odom @ g.odom_T_base
    return closure(g, step=math.dist(before.translation, g.found_T_base.translation))


ODOMETRY_IS_RESET = WrongAnswer(
    "odometry is reset",
    odometry_is_reset,
    Text(
        en="In odom nothing leaps: a correction does not touch what the wheels say, it moves odom as a whole.",
        ko="odom 기준으로는 아무것도 튀지 않습니다. 보정은 바퀴의 값을 건드리지 않고 odom 전체를 옮깁니다.",
    ),
    "M8",
    part="step_in_odom_m",
)

JUMP_OF_THE_EDGE = WrongAnswer(
    "jump of the edge",
    jump_of_the_edge,
    Text(
        en="That is how far odom's origin slides. The edge also turns, about that origin, so the robot, some metres away, leaps by another distance.",
        ko="odom의 원점이 미끄러진 거리입니다. 연결은 그 원점을 중심으로 돌기도 하므로, 몇 미터 떨어진 로봇이 튀는 거리는 다릅니다.",
    ),
    part="jump_m",
)

OLD_EDGE_KEPT = WrongAnswer(
    "old edge kept",
    lambda g: closure(g, edge=g.map_T_odom),
    Text(
        en="The edge is still the old one. What the localiser found has to go into it.",
        ko="연결이 아직 그대로입니다. 새로 알아낸 위치가 이 연결에 들어가야 합니다.",
    ),
    part="map_T_odom",
)

SUBTRACTED = WrongAnswer(
    "subtracted",
    lambda g: closure(g, edge=by_parts(g.found_T_base, g.odom_T_base)),
    Text(
        en="For the edge you subtracted steps and yaws. As soon as something is turned, that is no transform of anything: lay the dominoes.",
        ko="연결을 구할 때 이동과 yaw를 따로 뺐습니다. 무엇이든 돌아 있으면 맞지 않습니다. 도미노를 놓아 보세요.",
    ),
    "M3",
    part="map_T_odom",
)

ROBOT_PUBLISHED = WrongAnswer(
    "robot published",
    lambda g: closure(g, edge=g.found_T_base),
    Text(
        en="You give where the robot is as the edge. The edge lies above odom; the wheels' part has to be taken out.",
        ko="로봇의 위치를 연결로 썼습니다. 연결은 odom 위에 있으므로 바퀴의 몫을 빼내야 합니다.",
    ),
    "M7",
    part="map_T_odom",
)

BELIEVED_IN_ODOM = WrongAnswer(
    "believed in odom",
    lambda g: closure(g, believed=g.odom_T_base.translation[:2]),
    Text(
        en="That is where the robot is in odom. On the map the edge above odom comes first.",
        ko="odom 기준 로봇의 위치입니다. 지도 기준으로는 odom 위의 연결을 먼저 이어야 합니다.",
    ),
    part="believed",
    partly=True,
)

BELIEVED_ADDED = WrongAnswer(
    "believed added",
    lambda g: closure(
        g, believed=[a + b for a, b in zip(g.map_T_odom.translation, g.odom_T_base.translation, strict=True)][:2]
    ),
    Text(
        en="You added the two steps. The second is measured along odom's axes, and odom is turned in map.",
        ko="두 이동을 그대로 더했습니다. 둘째 이동은 odom의 축으로 잰 것이고, odom은 map 기준으로 돌아가 있습니다.",
    ),
    "M3",
    part="believed",
    partly=True,
)


def before(g):
    return g.map_T_odom @ g.odom_T_base


def step(g):
    """Return how far the robot leaps along x and y."""
    return [a - b for a, b in zip(g.found_T_base.translation, before(g).translation, strict=True)]


BELIEVED_IS_FOUND = WrongAnswer(
    "believed is found",
    lambda g: closure(g, believed=g.found_T_base.translation[:2]),
    Text(
        en="That is where it is found. Before that, edge and wheels together said where it is believed to be.",
        ko="찾아낸 위치입니다. 그 전에 믿던 위치는 연결과 바퀴의 값을 이어야 나옵니다.",
    ),
    part="believed",
    partly=True,
)

BELIEVED_OTHER_ORDER = WrongAnswer(
    "believed in the other order",
    lambda g: closure(g, believed=(g.odom_T_base @ g.map_T_odom).translation[:2]),
    Text(
        en="The factors stand in the other order. What begins with map stands first.",
        ko="곱의 순서가 바뀌었습니다. map으로 시작하는 것이 먼저입니다.",
    ),
    "M1",
    part="believed",
    partly=True,
)

BELIEVED_TURNED_BACK = WrongAnswer(
    "believed with the edge turned round",
    lambda g: closure(g, believed=(g.map_T_odom.inverse() @ g.odom_T_base).translation[:2]),
    Text(
        en="The edge is turned round here, and it begins with map already: it stays as it is.",
        ko="연결을 뒤집었습니다. 이미 map으로 시작하므로 그대로 둡니다.",
    ),
    "M1",
    part="believed",
    partly=True,
)

JUMP_FROM_ODOM = WrongAnswer(
    "jump from odom",
    lambda g: closure(g, jump=math.dist(g.found_T_base.translation, g.odom_T_base.translation)),
    Text(
        en="You measured from the pose in odom to the pose in map: two frames. Both ends have to be in map.",
        ko="odom 기준 위치에서 map 기준 위치까지 쟀습니다. 두 끝이 모두 map 기준이어야 합니다.",
    ),
    part="jump_m",
)

JUMP_BY_SIDES = WrongAnswer(
    "jump by sides",
    lambda g: closure(g, jump=abs(step(g)[0]) + abs(step(g)[1])),
    Text(
        en="You added the way along x and the way along y. They stand at right angles: the leap is the straight line.",
        ko="x 방향과 y 방향의 길이를 더했습니다. 둘은 직각이므로 튄 거리는 직선입니다.",
    ),
    part="jump_m",
)

EDGE_OTHER_ORDER = WrongAnswer(
    "edge in the other order",
    lambda g: closure(g, edge=g.odom_T_base.inverse() @ g.found_T_base),
    Text(
        en="The factors of the edge stand in the other order. What begins with map stands first.",
        ko="연결을 만드는 곱의 순서가 바뀌었습니다. map으로 시작하는 것이 먼저입니다.",
    ),
    "M1",
    part="map_T_odom",
)

EDGE_NOT_INVERTED = WrongAnswer(
    "wheels not turned round",
    lambda g: closure(g, edge=g.found_T_base @ g.odom_T_base),
    Text(
        en="For the edge, the wheels' pose went in as it is: [map|base][odom|base] do not match. Turn it round.",
        ko="연결을 구할 때 바퀴의 포즈를 그대로 이었습니다. [map|base][odom|base]는 이웃이 맞지 않습니다. 뒤집으십시오.",
    ),
    "M1",
    part="map_T_odom",
)

EDGE_IS_THE_CORRECTION = WrongAnswer(
    "edge is the correction",
    lambda g: closure(g, edge=g.found_T_base @ before(g).inverse()),
    Text(
        en="That is the correction itself, from the old pose on the map to the new one. The edge is what leads from map to odom.",
        ko="지도 위 옛 포즈에서 새 포즈까지의 보정 그 자체입니다. 연결은 map에서 odom까지 가는 것입니다.",
    ),
    part="map_T_odom",
)

EDGE_IS_THE_LEAP = WrongAnswer(
    "edge is the leap",
    lambda g: closure(g, edge=before(g).inverse() @ g.found_T_base),
    Text(
        en="That is the leap as the robot sees it, from where it was believed. The edge is what leads from map to odom.",
        ko="믿던 위치에서 로봇이 본 이동입니다. 연결은 map에서 odom까지 가는 것입니다.",
    ),
    part="map_T_odom",
)

LEAP_BEHIND_THE_EDGE = WrongAnswer(
    "leap behind the edge",
    lambda g: closure(g, edge=g.map_T_odom @ before(g).inverse() @ g.found_T_base),
    Text(
        en="You multiplied the leap, as the robot sees it, onto the old edge. That leap goes behind the robot's pose; the edge ends at odom, whose axes and origin are others.",
        ko="로봇에서 본 도약을 이전 연결에 곱했습니다. 그 도약은 로봇의 포즈 뒤에 붙는 것입니다. 연결은 odom에서 끝나고, odom은 축도 원점도 다릅니다.",
    ),
    "M1",
    part="map_T_odom",
)

CORRECTION_BEHIND_THE_EDGE = WrongAnswer(
    "correction behind the edge",
    lambda g: closure(g, edge=g.map_T_odom @ g.found_T_base @ before(g).inverse()),
    Text(
        en="You put the correction behind the old edge. It is measured in map, so it stands in front of what begins with map.",
        ko="보정을 이전 연결 뒤에 두었습니다. 보정은 map 기준으로 잰 것이므로 map으로 시작하는 것 앞에 옵니다.",
    ),
    "M1",
    part="map_T_odom",
)

STEP_IS_THE_SLIDE = WrongAnswer(
    "step is the slide",
    lambda g: closure(
        g, step=math.dist((g.found_T_base @ g.odom_T_base.inverse()).translation, g.map_T_odom.translation)
    ),
    Text(
        en="That is how far odom's origin slides on the map. Seen in odom the robot stays where its wheels say: they did not turn in that moment.",
        ko="지도에서 odom의 원점이 미끄러진 거리입니다. odom 기준으로 로봇은 바퀴가 말하는 곳에 그대로 있습니다. 그 순간 바퀴는 구르지 않았습니다.",
    ),
    "M8",
    part="step_in_odom_m",
)

FROM_THE_ORIGIN = WrongAnswer(
    "from the origin",
    lambda g: closure(g, step=math.hypot(*g.odom_T_base.translation[:2])),
    Text(
        en="That is how far the robot is from odom's origin. Asked for is how far it leaps there in the moment of the correction.",
        ko="odom 원점에서 로봇까지의 거리입니다. 보정하는 순간 거기서 얼마나 튀는지가 필요합니다.",
    ),
    "M8",
    part="step_in_odom_m",
)


BELIEVED_TURNED_ROUND = WrongAnswer(
    "believed turned round",
    lambda g: closure(g, believed=before(g).inverse().translation[:2]),
    Text(
        en="That is where the map's origin lies, seen from the robot: the inverse. Asked for is the robot on the map.",
        ko="로봇에서 본 지도 원점의 위치, 곧 역변환입니다. 지도 위의 로봇이 필요합니다.",
    ),
    "M1",
    part="believed",
    partly=True,
)


BELIEVED_IS_THE_EDGE = WrongAnswer(
    "believed is the edge",
    lambda g: closure(g, believed=g.map_T_odom.translation[:2]),
    Text(
        en="That is where odom's origin lies on the map. The robot has driven away from it since: `odom_T_base` comes on top.",
        ko="지도에서 odom 원점의 위치입니다. 로봇은 거기서 더 달렸습니다. `odom_T_base`를 이어야 합니다.",
    ),
    part="believed",
    partly=True,
)


JUMP_IS_THE_PLACE_FOUND = WrongAnswer(
    "jump is the place found",
    lambda g: closure(g, jump=math.hypot(*g.found_T_base.translation[:2])),
    Text(
        en="That is how far from the map's origin the robot was found. A leap is from where it was believed.",
        ko="지도 원점에서 로봇을 찾은 곳까지의 거리입니다. 도약은 있다고 믿던 곳에서 잽니다.",
    ),
    part="jump_m",
)


NO_JUMP = WrongAnswer(
    "no jump",
    lambda g: closure(g, jump=0.0),
    Text(
        en="No leap at all? The robot is found elsewhere than it was believed, and on the map that shows.",
        ko="도약이 없습니까? 믿던 곳과 다른 곳에서 찾았으므로 지도에서는 보입니다.",
    ),
    part="jump_m",
)


JUMP_ALONG_X = WrongAnswer(
    "jump along x",
    lambda g: closure(g, jump=abs(step(g)[0])),
    Text(
        en="That is the leap along x alone. It also goes sideways: the straight line counts both.",
        ko="x 방향의 도약만 셌습니다. 옆으로도 움직였으므로 직선 거리를 구해야 합니다.",
    ),
    part="jump_m",
)


JUMP_OF_DISTANCES = WrongAnswer(
    "jump of distances",
    lambda g: closure(
        g, jump=abs(math.hypot(*g.found_T_base.translation[:2]) - math.hypot(*before(g).translation[:2]))
    ),
    Text(
        en="That is how much farther from the map's origin, or nearer to it, the robot is found. A leap is the way from the one place to the other.",
        ko="지도 원점에서 얼마나 더 멀어졌거나 가까워졌는지입니다. 도약은 한 곳에서 다른 곳까지의 거리입니다.",
    ),
    part="jump_m",
)


JUMP_ALONG_Y = WrongAnswer(
    "jump along y",
    lambda g: closure(g, jump=abs(step(g)[1])),
    Text(
        en="That is the leap along y alone. It also goes along x: the straight line counts both.",
        ko="y 방향의 도약만 셌습니다. x 방향으로도 움직였으므로 직선 거리를 구해야 합니다.",
    ),
    part="jump_m",
)


EDGE_SHIFTED = WrongAnswer(
    "edge shifted",
    lambda g: closure(
        g,
        edge=Transform(
            [a + b for a, b in zip(g.map_T_odom.translation, [*step(g)[:2], 0.0], strict=True)], g.map_T_odom.rotation
        ),
    ),
    Text(
        en="You moved the old edge by the leap. The correction also turns, about odom's origin, so the edge slides by another amount.",
        ko="이전 연결을 도약만큼 옮겼습니다. 보정은 회전도 하므로 연결이 움직이는 양은 다릅니다.",
    ),
    "M3",
    part="map_T_odom",
)


TASK = Task(
    id="E5.2",
    kind="N",
    points=4,
    title=Text(en="A loop closes", ko="고리가 닫힐 때"),
    answer="closure",
    form=Parts(
        {
            "believed": Vector(2, unit="m", tolerance=0.005),
            "jump_m": Number(unit="m", tolerance=0.005),
            "map_T_odom": Pose(tolerance_m=0.005, tolerance_rad=0.005),
            "step_in_odom_m": Number(unit="m", tolerance=0.005),
        }
    ),
    given=closing_loop,
    variants=6,
    mistakes=(
        ODOMETRY_IS_RESET,
        JUMP_OF_THE_EDGE,
        OLD_EDGE_KEPT,
        SUBTRACTED,
        ROBOT_PUBLISHED,
        BELIEVED_IN_ODOM,
        BELIEVED_ADDED,
        BELIEVED_IS_FOUND,
        BELIEVED_OTHER_ORDER,
        BELIEVED_TURNED_BACK,
        JUMP_FROM_ODOM,
        JUMP_BY_SIDES,
        EDGE_OTHER_ORDER,
        EDGE_NOT_INVERTED,
        EDGE_IS_THE_CORRECTION,
        EDGE_IS_THE_LEAP,
        LEAP_BEHIND_THE_EDGE,
        CORRECTION_BEHIND_THE_EDGE,
        STEP_IS_THE_SLIDE,
        FROM_THE_ORIGIN,
        BELIEVED_TURNED_ROUND,
        BELIEVED_IS_THE_EDGE,
        JUMP_IS_THE_PLACE_FOUND,
        NO_JUMP,
        JUMP_ALONG_X,
        JUMP_ALONG_Y,
        JUMP_OF_DISTANCES,
        EDGE_SHIFTED,
    ),
    hints=(
        Text(
            en="Before: map_T_odom @ odom_T_base. After: found_T_base.",
            ko="이전에는 map_T_odom @ odom_T_base, 이후에는 found_T_base입니다.",
        ),
        Text(
            en="The jump is the distance between the two; the edge is E5.1 once more.",
            ko="튄 거리는 둘 사이의 거리이고, 연결은 E5.1과 같습니다.",
        ),
        Text(
            en="The wheels notice nothing of all this.",
            ko="바퀴는 이 모든 일을 전혀 알아채지 못합니다.",
        ),
    ),
    misconceptions=("M3", "M7", "M8"),
)
