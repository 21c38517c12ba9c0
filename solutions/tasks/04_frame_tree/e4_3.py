"""E4.3: Up, then down."""

from __future__ import annotations

from tflab.core import ConnectivityException
from tflab.workbook.tasks import Choice, Name, Pair, Sequence, Task, Text, WrongAnswer, WrongStep

from .draws import climbed, robot


def questions(rng):
    """Siblings, cousins, ancestors, descendants, a frame and itself, two trees: each of some robot."""
    rows = []
    for _ in range(2):
        tree = robot(rng, parts=4) | {"camera_link": "base_link", "camera_optical_frame": "camera_link"}
        tree |= {"imu_link": "base_link", "laser_frame": "base_link", "lens": "camera_optical_frame"}
        rows += [
            (tree, "imu_link", "laser_frame"),
            (tree, "lens", "laser_frame"),
            (tree, "map", "camera_optical_frame"),
            (tree, "camera_optical_frame", "odom"),
            (tree, "odom", "odom"),
            (tree, "base_link", "lens"),
            (tree, "map", "map"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "map", "lamp"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "hall", "lamp"),
            ({**tree, "dock": "hall", "lamp": "dock"}, "lamp", "imu_link"),
        ]
    return rows


def walked(parent_of, target, source, *, ends="as asked", climb="until they meet", words="as they are", order="outward", both="up, then down", named="child", pairs="child first", lost="raises"):  # fmt: skip
    """Return the steps, one decision after the other; other steps are the slips."""
    if ends == "exchanged":
        target, source = source, target
    up, down = climbed(parent_of, source), climbed(parent_of, target)
    if up[-1] != down[-1]:
        if lost == "raises":
            raise ConnectivityException("not part of the same tree")
        if lost != "joined":
            return [] if lost == "empty" else None
    if named == "a step to itself" and target == source:
        return [(source, "up")]
    if climb == "to the root, but for itself":
        up, down = ([], []) if target == source else (up[:-1], down[:-1])
    if (climb == "up alone" and target not in up) or (climb == "down alone" and source not in down):
        raise ConnectivityException("no way up") if climb == "up alone" else ConnectivityException("no way down")
    if climb == "straight alone" and target not in up and source not in down:
        raise ConnectivityException("neither above nor below")
    if climb not in ("to the root", "to the root, but for itself"):
        while up and down and up[-1] == down[-1]:
            up.pop()
            down.pop()
    elif climb == "to the root":
        up, down = up[:-1], down[:-1]
    whole = climbed(parent_of, source)[:-1]
    up = whole if climb == "up to the root" and target != source else up
    meeting = parent_of.get(up[-1], up[-1]) if up else source
    first, then = {"exchanged": ("down", "up"), "all up": ("up", "up"), "all down": ("down", "down")}.get(
        words, ("up", "down")
    )
    down = {"outward": down[::-1], "as climbed": down, "left out": [], "but for the last": down[:0:-1]}.get(
        order, down[::-1]
    )
    up = up[1:] if order == "but for the first" else up
    if named == "where they meet, too" and up:
        up = [*up, parent_of.get(up[-1], up[-1])]
    is_met = named == "where they meet, always" or (named == "where they meet, but for itself" and target != source)
    up = [*up, meeting] if is_met else up
    down = [meeting, *down] if named == "where they meet, down" else down
    if named == "parent":
        up, down = ([parent_of.get(child, child) for child in way] for way in (up, down))
    if named == "where it arrives":
        up = [parent_of.get(child, child) for child in up]
    down = [parent_of.get(child, child) for child in down] if named == "parent, going down" else down
    climbing, descending = [(child, first) for child in up], [(child, then) for child in down]
    if pairs == "way first":
        return [(way, child) for child, way in climbing + descending]
    if both == "reversed":
        return (climbing + descending)[::-1]
    if both == "up, then down":
        return climbing + descending
    return descending + climbing if both == "down, then up" else descending


FROM_THE_TARGET = WrongStep(
    "from the target",
    {"ends": "exchanged"},
    Text(
        en="You start at the target. The data is written in the source: the way begins there.",
        ko="목표에서 출발합니다. 데이터는 원본 기준으로 쓰여 있으므로 길은 원본에서 시작합니다.",
    ),
    "M1",
)

OVER_THE_ROOT = WrongStep(
    "over the root",
    {"climb": "to the root"},
    Text(
        en="You always climb to the root. Where both ways have met, they are the same, up and down again: leave those steps out.",
        ko="언제나 루트까지 올라갑니다. 두 길이 만난 뒤로는 올라갔다가 그대로 내려오는 걸음이니 빼십시오.",
    ),
)

WORDS_EXCHANGED = WrongStep(
    "up for down",
    {"words": "exchanged"},
    Text(
        en="Up and down are exchanged: up is from a child to its parent.",
        ko="up과 down이 바뀌었습니다. 자식에서 부모로 가는 것이 up입니다.",
    ),
    "M2",
)

DOWN_NOT_REVERSED = WrongStep(
    "down not reversed",
    {"order": "as climbed"},
    Text(
        en="The steps down stand in the order in which one climbs from the target. Going down, the topmost comes first.",
        ko="내려가는 걸음이 목표에서 올라간 순서대로 있습니다. 내려갈 때는 가장 위의 것이 먼저입니다.",
    ),
)

NEVER_DOWN = WrongStep(
    "never down",
    {"order": "left out"},
    Text(
        en="You stop where the ways meet. From there it goes down to the target.",
        ko="두 길이 만나는 곳에서 멈춥니다. 거기서 목표까지 내려가야 합니다.",
    ),
)

NAMED_AFTER_PARENTS = WrongStep(
    "up to, not up from",
    {"named": "where it arrives"},
    Text(
        en="You name the frame that a step arrives at. An edge has one child: name the step after it, up and down.",
        ko="걸음이 도착하는 좌표계의 이름을 썼습니다. 연결마다 자식은 하나입니다. 올라가든 내려가든 자식의 이름을 쓰십시오.",
    ),
    "M2",
)

NOTHING_LOST = WrongStep(
    "no way is no step",
    {"lost": "empty"},
    Text(
        en="For two trees you return an empty list, which says: already there. Raise ConnectivityException.",
        ko="트리가 둘일 때 빈 리스트를 반환합니다. 그것은 이미 도착했다는 뜻입니다. ConnectivityException을 일으키십시오.",
    ),
    "M11",
)

NONE_LOST = WrongStep(
    "no way is None",
    {"lost": "None"},
    Text(
        en="For two trees you return None. The caller would not notice: raise ConnectivityException, as tf2 does.",
        ko="트리가 둘일 때 None을 반환합니다. 호출한 쪽은 알아채지 못합니다. tf2처럼 ConnectivityException을 일으키십시오.",
    ),
    "M11",
)

ALL_UP = WrongStep(
    "all up",
    {"words": "all up"},
    Text(
        en="Every step of yours goes up. From where the ways meet, the way leads down to the target.",
        ko="모든 걸음이 up입니다. 두 길이 만나는 곳부터는 목표로 내려갑니다.",
    ),
    "M2",
)

DOWN_FIRST = WrongStep(
    "down first",
    {"both": "down, then up"},
    Text(
        en="The steps down stand before the steps up. One starts at the source, goes up from there, and comes down at the end.",
        ko="내려가는 걸음이 올라가는 걸음보다 먼저 있습니다. 원본에서 출발해 먼저 올라가고 마지막에 내려옵니다.",
    ),
)

NEVER_UP = WrongStep(
    "never up",
    {"both": "down alone"},
    Text(
        en="Only the steps down are there. The way begins at the source, with the steps up.",
        ko="내려가는 걸음만 있습니다. 길은 원본에서 올라가는 걸음으로 시작합니다.",
    ),
)


PARENT_GOING_DOWN = WrongStep(
    "parent going down",
    {"named": "parent, going down"},
    Text(
        en="Going down you name the parent of the edge. Each step is named after the edge's child, down as well as up.",
        ko="내려갈 때 연결의 부모 이름을 썼습니다. 올라갈 때나 내려갈 때나 연결의 자식 이름을 씁니다.",
    ),
)


WHERE_THEY_MEET_TOO = WrongStep(
    "where they meet too",
    {"named": "where they meet, too"},
    Text(
        en="You also name the frame in which the two ways meet. No step is needed above it: its own edge is not walked.",
        ko="두 길이 만나는 좌표계도 걸음에 넣었습니다. 그 위로는 가지 않으므로 그 연결은 지나지 않습니다.",
    ),
)


A_STEP_TO_ITSELF = WrongStep(
    "a step to itself",
    {"named": "a step to itself"},
    Text(
        en="From a frame to itself you take a step. There is none to take: an empty list.",
        ko="좌표계에서 자기 자신으로 가는데 한 걸음을 넣었습니다. 갈 곳이 없으므로 빈 리스트입니다.",
    ),
)


WAY_FIRST = WrongStep(
    "way first",
    {"pairs": "way first"},
    Text(
        en="Your pairs have the way first. Asked for is (child, way).",
        ko="쌍에서 방향이 먼저 나옵니다. (자식, 방향)이 필요합니다.",
    ),
)


JOINED_OVER_TWO_ROOTS = WrongStep(
    "joined over two roots",
    {"lost": "joined"},
    Text(
        en="You walk from one tree into the other, as if their roots were one. Where no frame is above both, raise ConnectivityException.",
        ko="두 트리의 루트가 하나인 것처럼 건너갑니다. 둘 위에 함께 있는 좌표계가 없으면 ConnectivityException을 일으키십시오.",
    ),
    "M11",
)

ALWAYS_THE_PARENT = WrongStep(
    "named after the parent",
    {"named": "parent"},
    Text(
        en="You name each step after the parent of its edge. A frame can have many children, so the child is what tells an edge.",
        ko="걸음마다 연결의 부모 이름을 붙였습니다. 자식은 여럿일 수 있으므로 연결을 가리키는 것은 자식입니다.",
    ),
    "M2",
)


UP_ALONE = WrongStep(
    "up alone",
    {"climb": "up alone"},
    Text(
        en="You only climb, and give up where the target is not above the source. The way goes up to a frame that both have above them, and down from there; it is lost only if there is none.",
        ko="위로만 올라가고, 목표가 원본 위에 없으면 포기합니다. 둘의 위에 함께 있는 좌표계까지 올라갔다가 거기서 내려갑니다. 그런 좌표계가 없을 때만 길이 없습니다.",
    ),
    "M11",
)


DOWN_ALONE = WrongStep(
    "down alone",
    {"climb": "down alone"},
    Text(
        en="You only go down, and give up where the source is not above the target. The way goes up first, to a frame that both have above them.",
        ko="아래로만 내려가고, 원본이 목표 위에 없으면 포기합니다. 먼저 둘의 위에 함께 있는 좌표계까지 올라갑니다.",
    ),
    "M11",
)


MEETING_ALWAYS = WrongStep(
    "the meeting always a step",
    {"named": "where they meet, always"},
    Text(
        en="The frame in which the two ways meet has a step of its own in your list. The way turns there, and its own edge is not walked: no step.",
        ko="두 길이 만나는 좌표계에도 단계가 있습니다. 거기서 방향만 바꿀 뿐 그 좌표계의 연결은 지나지 않으므로 단계가 없습니다.",
    ),
)


MEETING_DOWN = WrongStep(
    "the meeting a step down",
    {"named": "where they meet, down"},
    Text(
        en="The frame in which the two ways meet stands among your steps down. The way turns there, and its own edge is not walked: no step.",
        ko="두 길이 만나는 좌표계가 내려가는 단계에 들어 있습니다. 거기서 방향만 바꿀 뿐 그 좌표계의 연결은 지나지 않으므로 단계가 없습니다.",
    ),
)


OVER_THE_ROOT_BUT_FOR_ITSELF = WrongStep(
    "over the root, but for itself",
    {"climb": "to the root, but for itself"},
    Text(
        en="You climb to the root each time, and come down the same edges again. The ways meet earlier: turn round where they do, and leave out what both share.",
        ko="늘 루트까지 올라갔다가 같은 연결을 다시 내려옵니다. 두 길은 그전에 만납니다. 만나는 곳에서 돌아서고, 두 길이 함께 지나는 부분은 빼십시오.",
    ),
)


MEETING_BUT_FOR_ITSELF = WrongStep(
    "the meeting a step, but for itself",
    {"named": "where they meet, but for itself"},
    Text(
        en="You count one step too many: the frame in which the two ways meet. Going up ends as soon as one stands on it, and its own edge is not walked.",
        ko="걸음이 하나 더 많습니다. 두 길이 만나는 좌표계까지 세었습니다. 그 좌표계에 닿으면 올라가는 길은 끝나고, 그 좌표계의 연결은 지나지 않습니다.",
    ),
)


REVERSED = WrongStep(
    "reversed",
    {"both": "reversed"},
    Text(
        en="The steps are the right ones, and stand the other way round: what you give last is the first step, that of the source.",
        ko="걸음은 모두 맞지만 순서가 거꾸로입니다. 맨 끝에 있는 것이 원본에서 떼는 첫걸음입니다.",
    ),
)


UP_TO_THE_ROOT = WrongStep(
    "up to the root",
    {"climb": "up to the root"},
    Text(
        en="Your steps up go on to the root, and your steps down begin below the frame in which the two ways meet. Go up no farther than to that frame.",
        ko="올라가는 걸음은 루트까지 가는데 내려가는 걸음은 두 길이 만나는 좌표계 아래에서 시작합니다. 올라갈 때도 그 좌표계까지만 가십시오.",
    ),
)


ALL_DOWN = WrongStep(
    "all down",
    {"words": "all down"},
    Text(
        en="Every step of yours goes down. From the source the way first leads up, from child to parent.",
        ko="모든 걸음이 내려갑니다. 원본에서는 먼저 자식에서 부모로 올라갑니다.",
    ),
)


def climbs_alone(parent_of, target, source):
    way = []
    while source in parent_of and source != target:
        way.append((source, "up"))
        source = parent_of[source]
    return way


CLIMBS_ALONE = WrongAnswer(
    "climbs alone",
    climbs_alone,
    Text(
        en="You climb from the source until the target comes or the tree ends, and never go down: a target beside or below is not met that way. And where no way leads, raise ConnectivityException.",
        ko="원본에서 목표가 나오거나 트리가 끝날 때까지 올라가기만 합니다. 옆이나 아래에 있는 목표는 그렇게 만날 수 없습니다. 길이 없을 때는 ConnectivityException을 일으키십시오.",
    ),
    "M11",
)


STRAIGHT_ALONE = WrongStep(
    "straight alone",
    {"climb": "straight alone"},
    Text(
        en="You find a way straight up and a way straight down, and give up where it is both. Beside each other, two frames meet in one that is above both: up to it, then down.",
        ko="곧장 올라가는 길과 곧장 내려가는 길은 찾지만, 둘이 이어진 길은 포기합니다. 나란히 있는 두 좌표계는 둘의 위에 함께 있는 좌표계에서 만납니다. 거기까지 올라갔다가 내려가십시오.",
    ),
    "M11",
)


LAST_STEP_MISSING = WrongStep(
    "last step missing",
    {"order": "but for the last"},
    Text(
        en="The last step down is missing, the one that arrives at the target. It is named after its edge's child, and that is the target itself.",
        ko="목표에 닿는 마지막 내려가는 걸음이 빠졌습니다. 걸음의 이름은 연결의 자식이고, 여기서는 목표 자신입니다.",
    ),
)


FIRST_STEP_MISSING = WrongStep(
    "first step missing",
    {"order": "but for the first"},
    Text(
        en="The first step up is missing, the one that leaves the source. It is named after its edge's child, and that is the source itself.",
        ko="원본을 떠나는 첫 올라가는 걸음이 빠졌습니다. 걸음의 이름은 연결의 자식이고, 여기서는 원본 자신입니다.",
    ),
)


TASK = Task(
    id="E4.3",
    kind="F",
    points=5,
    title=Text(en="Up, then down", ko="올라갔다가 내려갑니다"),
    answer="path",
    form=Sequence(Pair(Name(), Choice(("up", "down")))),
    inputs=questions,
    variants=3,
    model=walked,
    mistakes=(
        FROM_THE_TARGET,
        OVER_THE_ROOT,
        WORDS_EXCHANGED,
        DOWN_NOT_REVERSED,
        NEVER_DOWN,
        NAMED_AFTER_PARENTS,
        NOTHING_LOST,
        NONE_LOST,
        ALL_UP,
        DOWN_FIRST,
        NEVER_UP,
        PARENT_GOING_DOWN,
        WHERE_THEY_MEET_TOO,
        A_STEP_TO_ITSELF,
        WAY_FIRST,
        JOINED_OVER_TWO_ROOTS,
        ALWAYS_THE_PARENT,
        UP_ALONE,
        DOWN_ALONE,
        MEETING_ALWAYS,
        MEETING_DOWN,
        OVER_THE_ROOT_BUT_FOR_ITSELF,
        MEETING_BUT_FOR_ITSELF,
        ALL_DOWN,
        CLIMBS_ALONE,
        REVERSED,
        UP_TO_THE_ROOT,
        STRAIGHT_ALONE,
        LAST_STEP_MISSING,
        FIRST_STEP_MISSING,
    ),
    hints=(
        Text(
            en="Write both ways up to the root, as `way_up` on the page does.",
            ko="본문의 `way_up`처럼 두 좌표계에서 루트까지의 길을 적어 보세요.",
        ),
        Text(
            en="If the last members of both lists differ, `raise ConnectivityException(...)`. Else drop what both share at their ends.",
            ko="두 리스트의 마지막 원소가 다르면 `raise ConnectivityException(...)`입니다. 같으면 끝에서부터 같은 부분을 버리십시오.",
        ),
        Text(
            en="What is left of the source's list goes up as it stands; what is left of the target's goes down, reversed.",
            ko="원본의 리스트에 남은 것은 그대로 up, 목표의 리스트에 남은 것은 뒤집어서 down입니다.",
        ),
    ),
    misconceptions=("M1", "M2", "M11"),
)
