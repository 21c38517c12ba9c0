"""E7.3: Forward kinematics."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Pose, Task, Text, WrongAnswer, WrongStep

from .draws import either, turned_about


def joint(name, kind, xyz, rpy, axis):
    return {"name": name, "type": kind, "xyz": list(xyz), "rpy": list(rpy), "axis": axis}


def some(rng, low=0.1, high=0.6):
    return round(float(either(rng) * rng.uniform(low, high)), 2)


def a_joint(rng, name, kind, axis):
    xyz, rpy = [some(rng) for _ in range(3)], [some(rng, 0.3, 1.2) for _ in range(3)]
    return joint(name, kind, xyz, rpy, axis)


def chains(rng):
    """Arms of up to four joints, all types and axes; positions in another order, one that is not named, one too many."""
    cases = []
    for kinds in (
        ("revolute", "fixed", "revolute"),
        ("fixed", "prismatic", "revolute", "fixed"),
        ("revolute", "prismatic", "prismatic"),
        ("revolute", "revolute", "fixed"),
    ):
        names = [f"joint_{letter}" for letter in "dbca"[: len(kinds)]]
        axes = list(rng.permutation(["x", "y", "z", "y"]))
        chain = [a_joint(rng, *each) for each in zip(names, kinds, map(str, axes), strict=False)]
        moving = [each["name"] for each in chain if each["type"] != "fixed"]
        positions = {name: some(rng, 0.2, 1.1) for name in reversed(moving)}
        cases.append((chain, positions))
    chain, positions = cases[0]
    cases.append((chain, {name: positions[name] for name in list(positions)[:1]}))  # one stands at zero
    cases.append((cases[3][0], {}))
    cases.append((chain[:1], {chain[0]["name"]: 0.7, "somebody_else": 1.0}))
    fixed = a_joint(rng, "weld", "fixed", "z")
    cases.append(([fixed, *cases[2][0]], {**cases[2][1], "weld": 0.5}))  # a fixed joint has no position
    return cases


def walk(chain, positions, *, names="by name", order="origin first", product="onwards", turn="rad", kinds="by type",
         rotation="rpy", frames="each in its parent", fixed="stays", axis="its own"):  # fmt: skip
    """Return base_T_tip, joint by joint; other steps are the slips."""
    pose, moved = Transform(), 0
    for number, each in enumerate(chain):
        rpy = each["rpy"][::-1] if rotation == "ypr" else (0.0, 0.0, 0.0) if rotation == "none" else each["rpy"]
        origin = Transform.from_rpy(*rpy, translation=tuple(each["xyz"]))
        if rotation == "before xyz":
            origin = Transform(Transform(rotation=origin.rotation).apply(each["xyz"]), origin.rotation)
        at = positions.get(each["name"], 0.0)
        if names == "by order":
            values = list(positions.values())
            at = values[moved] if each["type"] != "fixed" and moved < len(values) else 0.0
            moved += each["type"] != "fixed"
        if names == "by place":
            values = list(positions.values())
            at = values[number] if number < len(values) else 0.0
        if _is_left_out(each, positions, names):
            continue
        if fixed == "left out" and each["type"] == "fixed":
            continue
        if rotation == "replaced" and each["type"] == "revolute":
            origin = Transform(tuple(each["xyz"]))
        if rotation == "xyz left out":
            origin = Transform.from_rpy(*each["rpy"])
        if order == "added to rpy" and each["type"] == "revolute":
            rpy = [
                angle + (at if letter == each["axis"] else 0.0)
                for angle, letter in zip(each["rpy"], "xyz", strict=True)
            ]
            pose = pose @ Transform.from_rpy(*rpy, translation=tuple(each["xyz"]))
            continue
        if order in ("added to xyz", "added to both") and each["type"] != "fixed":
            pose = pose @ _added(each, at, order)
            continue
        movement = _movement(each, at, turn, kinds, fixed, axis)
        step = movement @ origin if order == "movement first" else origin @ movement
        if frames == "in the base":
            steps = [pose.translation, each["xyz"], movement.translation]
            pose = Transform(tuple(map(sum, zip(*steps, strict=True))), (pose @ step).rotation)
            continue
        if frames == "steps added" and number:
            place = tuple(a + b for a, b in zip(pose.translation, step.translation, strict=True))
            pose = Transform(place, (pose @ step).rotation)
        else:
            pose = step @ pose if product == "backwards" else pose @ step
    return pose


def _is_left_out(each, positions, names):
    is_unnamed = each["name"] not in positions
    return is_unnamed and (names == "named alone" or (names == "unnamed left out" and each["type"] != "fixed"))


def _added(each, at, order):
    """Return a joint whose position was added to the numbers of its origin, number by number."""
    more = [at if letter == each["axis"] else 0.0 for letter in "xyz"]
    xyz, rpy = each["xyz"], each["rpy"]
    if each["type"] == "prismatic":
        return Transform.from_rpy(*rpy, translation=tuple(a + b for a, b in zip(xyz, more, strict=True)))
    if order == "added to both":
        return Transform.from_rpy(*(a + b for a, b in zip(rpy, more, strict=True)), translation=tuple(xyz))
    return Transform.from_rpy(*rpy, translation=tuple(xyz)) @ turned_about(each["axis"], at)


def _movement(each, at, turn, kinds, fixed, axis):
    if each["type"] == "fixed" and fixed == "stays":
        return Transform()
    at = -at if turn == "other way" else math.radians(at) if turn == "deg, all" else at
    if turn in ("turns other way", "slides other way"):
        at = -at if (each["type"] == "prismatic") == (turn == "slides other way") else at
    if kinds == "never turns" and each["type"] == "revolute":
        return Transform()
    if kinds == "all slide":
        return Transform(tuple(at if letter == each["axis"] else 0.0 for letter in "xyz"))
    if axis == "turned round" and each["type"] == "revolute":
        return turned_about({"x": "z", "y": "y", "z": "x"}[each["axis"]], at)
    if each["type"] == "fixed" and fixed == "slides":
        return Transform(tuple(at if letter == each["axis"] else 0.0 for letter in "xyz"))
    about = (
        "z"
        if axis == "always z" or (axis in ("turns about z", "z and x") and each["type"] != "prismatic")
        else each["axis"]
    )
    about = axis[-1] if axis in ("always x", "always y") else about
    about = "x" if axis in ("slides along x", "z and x") and each["type"] == "prismatic" else about
    about = "z" if axis == "slides along z" and each["type"] == "prismatic" else about
    if each["type"] == "prismatic" and kinds in ("by type", "never turns"):
        return Transform(tuple(at if letter == about else 0.0 for letter in "xyz"))
    if kinds == "never slides" and each["type"] == "prismatic":
        return Transform()
    return turned_about(about, math.radians(at) if turn == "deg" else at)


def slip(name, at, en, ko, misconception=""):
    return WrongStep(name, at, Text(en=en, ko=ko), misconception)


SLIPS = (
    slip("by order", {"names": "by order"},
         "You take positions in the order in which they come. A JointState is read by name: its order means nothing.",
         "위치를 들어온 순서대로 썼습니다. JointState는 이름으로 읽습니다. 순서에는 뜻이 없습니다."),
    slip("rpy turned round", {"rotation": "ypr"},
         "rpy holds roll, pitch, yaw, in this order; you took them the other way round.",
         "rpy는 roll, pitch, yaw 순서입니다. 거꾸로 썼습니다.", "M5"),
    slip("origin not turned", {"rotation": "none"},
         "The rpy of the origins is not in it: only their xyz.",
         "origin의 rpy가 빠졌습니다. xyz만 들어 있습니다."),
    slip("moves what is fixed", {"fixed": "moves"},
         "A fixed joint moves with you, because a position goes by its name. Fixed is fixed, whatever anybody says.",
         "이름이 같은 위치가 있다고 고정된 관절을 움직였습니다. fixed는 누가 뭐라고 해도 움직이지 않습니다."),
    slip("everything turns", {"kinds": "all turn"},
         "You turn prismatic joints, too. They slide along their axis, in metres.",
         "prismatic 관절까지 돌렸습니다. 축을 따라 미터 단위로 미끄러집니다."),
    slip("nothing slides", {"kinds": "never slides"},
         "Prismatic joints hardly move with you, or not at all. They slide along their axis, in metres.",
         "prismatic 관절이 전혀, 또는 거의 움직이지 않습니다. 축을 따라 미터 단위로 미끄러집니다."),
    slip("always about z", {"axis": "always z"},
         "Every joint moves about z, or along it. Each has an axis of its own.",
         "모든 관절이 z를 중심으로, 또는 z를 따라 움직입니다. 관절마다 axis가 있습니다."),
    slip("degrees", {"turn": "deg"},
         "You took positions for degrees. Joint positions are radians.",
         "위치를 도(degree)로 여겼습니다. 관절의 위치는 라디안입니다.", "M5"),
    slip("degrees, all", {"turn": "deg, all"},
         "You took every position for degrees. Turns are radians, and what slides is in metres.",
         "모든 위치를 도(degree)로 여겼습니다. 회전은 라디안이고, 미끄러지는 것은 미터입니다.", "M5"),
    slip("the other way", {"turn": "other way"},
         "Your joints move the other way: the sign of the positions is turned round.",
         "관절이 반대로 움직입니다. 위치의 부호가 뒤집혔습니다."),
    slip("movement first", {"order": "movement first"},
         "The movement comes before the origin: that reads the axis in the parent's axes. Origin first, then the movement.",
         "움직임이 origin보다 먼저입니다. axis를 부모의 축으로 읽은 셈입니다. origin 다음에 움직임입니다."),
    slip("product backwards", {"product": "backwards"},
         "The product runs from the tip to the base. Lay the dominoes: what is nearer to the base stands left.",
         "곱의 순서가 팔 끝에서 시작합니다. 도미노를 놓아 보세요. 베이스에 가까운 것이 왼쪽입니다.", "M1"),
    slip("turns about z and slides along x", {"axis": "z and x"},
         "All your revolute joints turn about z and all your prismatic ones slide along x, whatever \"axis\" says. Each joint has its own.",
         "\"axis\"가 무엇이든 회전 관절은 모두 z축을 돌고 직선 관절은 모두 x축을 따라 미끄러집니다. 축은 관절마다 다릅니다."),
    slip("steps added", {"frames": "steps added"},
         "You added the steps. Each is measured in axes that the joints before it have turned.",
         "이동을 그대로 더했습니다. 이동은 저마다 앞의 관절들이 돌려놓은 축으로 잰 것입니다.", "M3"),
)  # fmt: skip

NOT_MOVED = WrongAnswer(
    "not moved",
    lambda chain, positions: walk(chain, {}),
    Text(
        en="This arm stands at zero: the positions are not in it.", ko="모두 0인 팔입니다. 위치가 들어 있지 않습니다."
    ),
)

ORIGINS_LEFT_OUT = WrongAnswer(
    "origins left out",
    lambda chain, positions: walk(
        [{**each, "xyz": [0.0, 0.0, 0.0], "rpy": [0.0, 0.0, 0.0]} for each in chain], positions
    ),
    Text(
        en="Only the movements are in it. Each joint begins with its origin, which never changes.",
        ko="움직임만 들어 있습니다. 관절은 변하지 않는 origin에서 시작합니다.",
    ),
)

LAST_ONE = WrongAnswer(
    "last joint",
    lambda chain, positions: walk(chain[-1:], positions),
    Text(
        en="That is the last joint alone: the tip in its parent, not in the base. Multiply all of them.",
        ko="마지막 관절 하나입니다. 베이스가 아니라 바로 위 부모 기준의 팔 끝입니다. 모두 곱하십시오.",
    ),
)


ALWAYS_TURNS_ABOUT_Z = WrongStep(
    "always turns about z",
    {"axis": "turns about z"},
    Text(
        en="Every revolute joint turns about z. Each has an axis of its own.",
        ko="revolute 관절이 모두 z 둘레로 돕니다. 관절마다 axis가 있습니다.",
    ),
)


ALWAYS_SLIDES_ALONG_X = WrongStep(
    "always slides along x",
    {"axis": "slides along x"},
    Text(
        en="Every prismatic joint slides along x. Each has an axis of its own.",
        ko="prismatic 관절이 모두 x를 따라 미끄러집니다. 관절마다 axis가 있습니다.",
    ),
)


UNNAMED_LEFT_OUT = WrongStep(
    "unnamed left out",
    {"names": "unnamed left out"},
    Text(
        en="You leave out a joint that has no position. It stands at 0: its origin is still in the chain.",
        ko="위치가 없는 관절을 건너뜁니다. 0에 서 있을 뿐 origin은 사슬에 남습니다.",
    ),
)


RPY_OF_WHAT_TURNS = WrongStep(
    "rpy of what turns",
    {"rotation": "replaced"},
    Text(
        en="Where a joint turns you left its rpy out, as if the position took its place. The origin is turned first, and then the joint moves.",
        ko="도는 관절의 rpy를 위치로 대신했습니다. 먼저 origin이 돌고, 그다음에 관절이 움직입니다.",
    ),
)


ADDED_TO_RPY = WrongStep(
    "added to rpy",
    {"order": "added to rpy"},
    Text(
        en="You added the position to the roll, pitch or yaw of the origin. Angles about different axes do not add up so: origin first, then the movement, as two factors.",
        ko="위치를 origin의 roll, pitch, yaw에 더했습니다. 다른 축의 각도는 그렇게 더해지지 않습니다. origin 다음에 움직임을 곱합니다.",
    ),
    "M5",
)


STEPS_LEFT_OUT = WrongStep(
    "steps left out",
    {"rotation": "xyz left out"},
    Text(
        en="The xyz of the origins is not in it: only their turns.",
        ko="origin의 xyz가 빠졌습니다. 회전만 들어 있습니다.",
    ),
)


FIRST_JOINT_LEFT_OUT = WrongAnswer(
    "first joint left out",
    lambda chain, positions: walk(chain[1:] or chain[:0], positions),
    Text(
        en="The first joint is not in it: the chain begins at the base.",
        ko="첫 관절이 빠졌습니다. 사슬은 베이스에서 시작합니다.",
    ),
)

ALWAYS_SLIDES_ALONG_Z = WrongStep(
    "always slides along z",
    {"axis": "slides along z"},
    Text(
        en="You let every prismatic joint slide along z. Each joint names its own axis.",
        ko="모든 prismatic 관절을 z축으로 밀었습니다. 축은 관절마다 적혀 있습니다.",
    ),
)

ADDED_TO_XYZ = WrongStep(
    "added to xyz",
    {"order": "added to xyz"},
    Text(
        en="You added how far a joint slides to its xyz. That is along the parent's axes; it slides along its own, after the turn of its origin.",
        ko="관절이 미끄러진 거리를 xyz에 더했습니다. 그러면 부모의 축을 따라 움직입니다. 관절은 origin만큼 돌린 뒤 자신의 축을 따라 움직입니다.",
    ),
)

ADDED_TO_BOTH = WrongStep(
    "added to xyz and rpy",
    {"order": "added to both"},
    Text(
        en="You added each position to the numbers of the origin. Then it moves along and about the parent's axes, and not its own.",
        ko="위치를 origin의 숫자에 더했습니다. 그러면 자신의 축이 아니라 부모의 축을 따라 움직입니다.",
    ),
)

BY_PLACE = WrongStep(
    "positions by place",
    {"names": "by place"},
    Text(
        en="You took the positions by their place, one for each joint of the chain. They have names: a joint's own is the one under its name.",
        ko="위치를 관절의 순서대로 하나씩 썼습니다. 위치에는 이름이 있습니다. 관절의 위치는 그 이름 아래에 있는 것입니다.",
    ),
)


FIXED_LEFT_OUT = WrongStep(
    "fixed left out",
    {"fixed": "left out"},
    Text(
        en="You leave fixed joints out. They never move, but each has an origin, and what comes after hangs on it.",
        ko="fixed 관절을 건너뜁니다. 움직이지는 않지만 origin이 있고, 그다음 것이 거기에 달려 있습니다.",
    ),
)

SLIDES_WHAT_IS_FIXED = WrongStep(
    "slides what is fixed",
    {"fixed": "slides"},
    Text(
        en="A fixed joint slides with you, because a position goes by its name and it is not revolute. Fixed is a third type: it never moves.",
        ko="revolute가 아니고 이름이 같은 위치가 있다고 고정된 관절을 미끄러뜨렸습니다. fixed는 셋째 종류이고 움직이지 않습니다.",
    ),
)

STEPS_IN_THE_BASE = WrongStep(
    "steps in the base",
    {"frames": "in the base"},
    Text(
        en="You joined the turns, and added all steps as if they were measured along the base's axes. Each is measured in axes that the joints before it have turned.",
        ko="회전은 이었지만 이동은 모두 베이스의 축으로 잰 것처럼 더했습니다. 이동은 저마다 앞의 관절들이 돌려놓은 축으로 잰 것입니다.",
    ),
    "M3",
)

LETTERS_TURNED_ROUND = WrongStep(
    "letters turned round",
    {"axis": "turned round"},
    Text(
        en="You took a turn about x for a yaw, and one about z for a roll. Roll is about x, yaw about z.",
        ko="x를 중심으로 도는 것을 yaw, z를 중심으로 도는 것을 roll로 여겼습니다. roll이 x, yaw가 z입니다.",
    ),
    "M5",
)

ALWAYS_X = WrongAnswer(
    "always about x",
    lambda chain, positions: walk(chain, positions, axis="always x"),
    Text(
        en="Every joint moves about x, or along it. Each has an axis of its own.",
        ko="모든 관절이 x를 중심으로, 또는 x를 따라 움직입니다. 관절마다 axis가 있습니다.",
    ),
)


ALWAYS_Y = WrongAnswer(
    "always about y",
    lambda chain, positions: walk(chain, positions, axis="always y"),
    Text(
        en="Every joint moves about y, or along it. Each has an axis of its own.",
        ko="모든 관절이 y를 중심으로, 또는 y를 따라 움직입니다. 관절마다 axis가 있습니다.",
    ),
)


TURNS_THE_OTHER_WAY = WrongAnswer(
    "turns the other way",
    lambda chain, positions: walk(chain, positions, turn="turns other way"),
    Text(
        en="Your revolute joints turn the other way: the sign of their positions is turned round.",
        ko="revolute 관절이 반대로 돕니다. 위치의 부호가 뒤집혔습니다.",
    ),
)


SLIDES_THE_OTHER_WAY = WrongAnswer(
    "slides the other way",
    lambda chain, positions: walk(chain, positions, turn="slides other way"),
    Text(
        en="Your prismatic joints slide the other way: the sign of their positions is turned round.",
        ko="prismatic 관절이 반대로 미끄러집니다. 위치의 부호가 뒤집혔습니다.",
    ),
)


NOTHING_TURNS = WrongAnswer(
    "nothing turns",
    lambda chain, positions: walk(chain, positions, kinds="never turns"),
    Text(
        en="Revolute joints stand still with you. They turn about their axis, in radians.",
        ko="revolute 관절이 움직이지 않습니다. 축을 중심으로 라디안 단위로 돕니다.",
    ),
)


EVERYTHING_SLIDES = WrongAnswer(
    "everything slides",
    lambda chain, positions: walk(chain, positions, kinds="all slide"),
    Text(
        en="You slide revolute joints, too. They turn about their axis, in radians.",
        ko="revolute 관절까지 미끄러뜨렸습니다. 축을 중심으로 라디안 단위로 돕니다.",
    ),
)


NAMED_ALONE = WrongAnswer(
    "named alone",
    lambda chain, positions: walk(chain, positions, names="named alone"),
    Text(
        en="You leave out every joint that has no position, fixed ones, too. Each has an origin, and what comes after hangs on it.",
        ko="위치가 없는 관절을, fixed 관절까지 모두 건너뜁니다. 관절마다 origin이 있고 그다음 것이 거기에 달려 있습니다.",
    ),
)


TURNED_BEFORE_THE_STEP = WrongAnswer(
    "turned before the step",
    lambda chain, positions: walk(chain, positions, rotation="before xyz"),
    Text(
        en="The origin is turned by its rpy before its xyz is gone. xyz is measured along the parent's axes: first the place, then the turn.",
        ko="origin에서 rpy로 먼저 돌린 다음 xyz만큼 갔습니다. xyz는 부모의 축으로 잽니다. 먼저 위치, 다음에 회전입니다.",
    ),
)


FIRST_JOINT_ALONE = WrongAnswer(
    "first joint alone",
    lambda chain, positions: walk(chain[:1], positions),
    Text(
        en="That is the first joint alone. Does your `return` stand inside the loop?",
        ko="첫 관절 하나뿐입니다. `return`이 반복문 안에 있지 않습니까?",
    ),
)

LAST_JOINT_DROPPED = WrongAnswer(
    "last joint dropped",
    lambda chain, positions: walk(chain[:-1], positions),
    Text(
        en="You stop one joint before the tip: the last one is not in your product, neither its place nor its movement. Does the loop, or a slice, end one too early?",
        ko="팔 끝보다 관절 하나 앞에서 멈춥니다. 마지막 관절이 위치도 움직임도 곱에 들어 있지 않습니다. 반복문이나 슬라이스가 하나 일찍 끝나지 않습니까?",
    ),
)

ENDS_WITH_THE_POSITIONS = WrongAnswer(
    "ends with the positions",
    lambda chain, positions: walk(chain[: len(positions)], positions, names="by place"),
    Text(
        en="You pair joints and positions by their places, as `zip` does: the first joint gets the first number, and whichever list is shorter ends the chain. Go through all joints, and look each one up by its name.",
        ko="관절과 위치를 `zip`처럼 순서대로 짝짓습니다. 첫 관절이 첫 숫자를 받고, 짧은 쪽이 끝나면 사슬도 끝납니다. 관절을 모두 지나면서 이름으로 찾으십시오.",
    ),
)

LAST_MOVEMENT_LEFT_OUT = WrongAnswer(
    "last movement left out",
    lambda chain, positions: walk(
        chain, {name: at for name, at in positions.items() if not chain or name != chain[-1]["name"]}
    ),
    Text(
        en="The last joint stands still with you. The tip is behind it: it moves, too.",
        ko="마지막 관절이 움직이지 않습니다. 팔 끝은 그 뒤에 있으므로 함께 움직입니다.",
    ),
)


def numbers_added(chain, positions):
    """Return the sum of all offsets and angles, as if a chain were one joint."""
    place, angles = [0.0] * 3, [0.0] * 3
    for each in chain:
        at = positions.get(each["name"], 0.0)
        for number, letter in enumerate("xyz"):
            moved = at if letter == each["axis"] else 0.0
            place[number] += each["xyz"][number] + (moved if each["type"] == "prismatic" else 0.0)
            angles[number] += each["rpy"][number] + (moved if each["type"] == "revolute" else 0.0)
    return Transform.from_rpy(*angles, translation=tuple(place))


NUMBERS_ADDED = WrongAnswer(
    "numbers added",
    numbers_added,
    Text(
        en="You added up all offsets, and all angles. Each joint stands in axes that those before it have turned, and turns about different axes do not add up: multiply transforms, joint by joint.",
        ko="오프셋은 오프셋끼리, 각도는 각도끼리 모두 더했습니다. 관절은 앞의 관절들이 돌려놓은 축에 서 있고, 서로 다른 축의 회전은 더해지지 않습니다. 관절마다 변환을 곱하십시오.",
    ),
    "M3",
)


TASK = Task(
    id="E7.3",
    kind="F",
    points=5,
    title=Text(en="Forward kinematics", ko="정기구학"),
    answer="fk",
    form=Pose(),
    inputs=chains,
    variants=3,
    model=walk,
    mistakes=(
        *SLIPS,
        NOT_MOVED,
        ORIGINS_LEFT_OUT,
        LAST_ONE,
        ALWAYS_TURNS_ABOUT_Z,
        ALWAYS_SLIDES_ALONG_X,
        UNNAMED_LEFT_OUT,
        RPY_OF_WHAT_TURNS,
        ADDED_TO_RPY,
        STEPS_LEFT_OUT,
        FIRST_JOINT_LEFT_OUT,
        ALWAYS_SLIDES_ALONG_Z,
        ADDED_TO_XYZ,
        ADDED_TO_BOTH,
        BY_PLACE,
        FIXED_LEFT_OUT,
        SLIDES_WHAT_IS_FIXED,
        STEPS_IN_THE_BASE,
        LETTERS_TURNED_ROUND,
        FIRST_JOINT_ALONE,
        LAST_JOINT_DROPPED,
        ENDS_WITH_THE_POSITIONS,
        LAST_MOVEMENT_LEFT_OUT,
        NUMBERS_ADDED,
        ALWAYS_X,
        ALWAYS_Y,
        TURNS_THE_OTHER_WAY,
        SLIDES_THE_OTHER_WAY,
        NOTHING_TURNS,
        EVERYTHING_SLIDES,
        NAMED_ALONE,
        TURNED_BEFORE_THE_STEP,
    ),
    hints=(
        Text(
            en="Begin with Transform() and multiply one domino for each joint.",
            ko="Transform()에서 시작해 관절마다 도미노를 하나씩 곱하십시오.",
        ),
        Text(
            en="One domino: the origin, Transform.from_rpy(*rpy, translation=xyz), and then the movement.",
            ko="도미노 하나는 origin, 곧 Transform.from_rpy(*rpy, translation=xyz)에 움직임을 이은 것입니다.",
        ),
        Text(
            en="positions.get(name, 0.0): who is not named stands at zero. A turn about x is roll, about y pitch, about z yaw.",
            ko="positions.get(name, 0.0)이면 이름이 없는 관절은 0입니다. x를 중심으로 돌면 roll, y는 pitch, z는 yaw입니다.",
        ),
    ),
    equivalent={"tuple(joint['xyz']) -> joint['xyz']": "a Transform makes a tuple of any three numbers itself"},
    misconceptions=("M1", "M3", "M5"),
)
