"""E4.4: Two robots, one map."""

from __future__ import annotations

from tflab.workbook.tasks import Task, Text, Tree, WrongAnswer, WrongStep

from .draws import robot

TEAMS = (("left", "right"), ("red", "blue"), ("tb3_0", "tb3_1"), ("alpha", "beta"), ("north", "south"))


def robots(rng):
    tree = robot(rng, parts=2)
    first, second = TEAMS[int(rng.integers(len(TEAMS)))]
    return {"edges": [(parent, child) for child, parent in tree.items()], "prefixes": [first, second]}


def together(
    given,
    *,
    robots="beside each other",
    named="as given",
    shared=("map",),
    glue="{}/{}",
    parents="prefixed",
    children="prefixed",
    who="both",
    whose="all frames",
    way="child -> parent",
):
    """Return the tree of both robots, step by step; other steps are the slips."""
    fleet = {}
    first, second = prefixes = ["robot1", "robot2"] if named == "numbered" else given.prefixes
    for prefix in {"the first": prefixes[:1], "the last": prefixes[1:]}.get(who, prefixes):
        for parent, child in given.edges:
            prefixed = {
                name: glue.format(prefix, name)
                for name in (parent, child)
                if name not in shared and (whose == "all frames" or name.startswith(("odom", "base")))
            }
            above, below = prefixed.get(parent, parent), prefixed.get(child, child)
            is_bare = parents == "bare" or (parents == "odom bare" and parent == "odom")
            fleet[below if children == "prefixed" else child] = parent if is_bare else above
    if parents == "robot by robot":
        fleet |= {child: prefix for prefix in prefixes for child in fleet if fleet[child] == "map" and prefix in child}
        fleet |= dict.fromkeys(prefixes, "map")
    if who == "the first bare":
        fleet |= {child: parent for parent, child in given.edges}
        fleet = {child: parent for child, parent in fleet.items() if not child.startswith(f"{first}/")}
    if robots == "on the other's base":
        fleet[f"{second}/odom"] = f"{first}/base_link"
    if robots == "one below the other":
        fleet = {c: p if p != "map" or not c.startswith(second) else f"{first}/odom" for c, p in fleet.items()}
    return {parent: child for child, parent in fleet.items()} if way == "parent -> child" else fleet


ODOM_SHARED = WrongStep(
    "odom shared",
    {"shared": ("map", "odom")},
    Text(
        en="Both robots hang below one odom. Each counts its wheels from zero there: two owners, and one robot inside the other.",
        ko="두 로봇이 한 odom 아래에 있습니다. 저마다 0부터 바퀴를 세므로 발행 책임이 둘이 되고, 한 로봇이 다른 로봇 안에 들어갑니다.",
    ),
    "M14",
)

MAP_PREFIXED = WrongStep(
    "map prefixed",
    {"shared": ()},
    Text(
        en="You gave map a prefix, too. Then there are two maps and two trees, and no question leads from one robot to the other.",
        ko="map에도 접두사를 붙였습니다. 지도가 둘, 트리도 둘이 되어 한 로봇에서 다른 로봇으로 가는 길이 없습니다.",
    ),
    "M14",
)

NO_SLASH = WrongStep(
    "no slash",
    {"glue": "{}{}"},
    Text(
        en="The slash between the robot's name and the frame is missing.",
        ko="로봇 이름과 좌표계 사이에 슬래시가 없습니다.",
    ),
    "M14",
)

SLASH_IN_FRONT = WrongStep(
    "slash in front",
    {"glue": "/{}/{}"},
    Text(
        en="The names begin with a slash. tf2 forgives one when you send and refuses it when you ask; leave it out.",
        ko="이름이 슬래시로 시작합니다. tf2는 보낼 때는 눈감아 주지만 물을 때는 거부합니다. 쓰지 마십시오.",
    ),
    "M14",
)

NAMESPACE_DOES_IT = WrongStep(
    "bare names",
    {"glue": "{1}"},
    Text(
        en="There is no prefix. A namespace does not put one before frames: both robots would send the very same names.",
        ko="접두사가 없습니다. 네임스페이스는 좌표계 이름에 붙지 않으므로 두 로봇이 똑같은 이름을 보내게 됩니다.",
    ),
    "M14",
)

SENSORS_BARE = WrongStep(
    "sensors bare",
    {"whose": "odom and base"},
    Text(
        en="Only odom and the base have a prefix. A frame is known by its name alone, not by what it hangs below: two "
        "lasers of one name are one frame with two parents.",
        ko="odom과 base에만 접두사를 붙였습니다. 좌표계는 어디에 매달렸는지가 아니라 이름으로만 구별합니다. 이름이 같은 "
        "레이저 둘은 부모가 둘인 좌표계 하나입니다.",
    ),
    "M14",
)

CHILDREN_ONLY = WrongStep(
    "children only",
    {"parents": "bare"},
    Text(
        en="Only the children have a prefix. A parent is a frame too: below the bare name there would hang both robots.",
        ko="자식에만 접두사를 붙였습니다. 부모도 좌표계입니다. 접두사가 없는 이름 아래에 두 로봇이 함께 매달립니다.",
    ),
    "M14",
)

UNDERSCORE = WrongStep(
    "underscore",
    {"glue": "{}_{}"},
    Text(
        en="Between the robot's name and the frame stands an underscore; asked for is a slash, as in robot1/odom.",
        ko="로봇 이름과 좌표계 사이에 밑줄이 있습니다. robot1/odom처럼 슬래시를 쓰십시오.",
    ),
)

UPSIDE_DOWN = WrongStep(
    "upside down",
    {"way": "parent -> child"},
    Text(
        en="That is parent → child, and a parent of several children keeps one. Asked for is child → parent.",
        ko="부모 → 자식으로 써서, 자식이 여럿인 부모에는 하나만 남습니다. 자식 → 부모로 써야 합니다.",
    ),
    "M2",
)

THE_FIRST_ALONE = WrongStep(
    "the first alone",
    {"who": "the first"},
    Text(
        en="The second robot is missing: both stand in one tree, under one map.",
        ko="두 번째 로봇이 빠졌습니다. 두 로봇 모두 한 map 아래의 한 트리에 있습니다.",
    ),
)

THE_LAST_ALONE = WrongStep(
    "the last alone",
    {"who": "the last"},
    Text(
        en="The first robot is missing, and the second is there. A dict that is made inside the loop over the robots begins anew for each: make one, before the loop.",
        ko="첫 번째 로봇이 빠지고 두 번째 로봇만 있습니다. 로봇마다 도는 반복문 안에서 dict를 만들면 그때마다 새로 시작합니다. 반복문 앞에서 하나만 만드십시오.",
    ),
)

NAME_FIRST = WrongStep(
    "name first",
    {"glue": "{1}/{0}"},
    Text(
        en="The frame stands before the robot's name. A prefix stands in front: robot1/odom.",
        ko="좌표계 이름이 로봇 이름보다 먼저 있습니다. 접두사는 앞에 붙입니다. robot1/odom입니다.",
    ),
    "M14",
)

SLASH_IN_FRONT_OF_ALL = WrongAnswer(
    "slash in front of all",
    lambda given: {
        child: "/map" if parent == "map" else parent for child, parent in together(given, glue="/{}/{}").items()
    },
    Text(
        en="Every name begins with a slash, map too. ROS 2 refuses such a name when somebody asks for it.",
        ko="map까지 모든 이름이 슬래시로 시작합니다. ROS 2에서는 그런 이름을 조회하면 거부합니다.",
    ),
    "M14",
)


NUMBERED = WrongStep(
    "numbered",
    {"named": "numbered"},
    Text(
        en="You named the robots robot1 and robot2. Their names are in `prefixes`; robot1/odom was an example.",
        ko="로봇의 이름을 robot1, robot2라고 적었습니다. 이름은 `prefixes`에 있습니다. robot1/odom은 예입니다.",
    ),
    "M14",
)


BELOW_MAP_IN_NAME = WrongStep(
    "below map in name",
    {"glue": "map/{}/{}"},
    Text(
        en="You wrote map into every name. A name holds no path through the tree: the parents say what hangs where.",
        ko="모든 이름에 map을 넣었습니다. 이름은 트리의 경로가 아닙니다. 무엇이 어디 달리는지는 부모를 보고 압니다.",
    ),
    "M14",
)


A_FRAME_FOR_EACH_ROBOT = WrongStep(
    "a frame for each robot",
    {"parents": "robot by robot"},
    Text(
        en="You put a frame for each robot between map and its odom. A prefix is a part of the names, and no frame of its own.",
        ko="map과 odom 사이에 로봇마다 좌표계를 하나씩 더 넣었습니다. 접두사는 이름의 일부이지 좌표계가 아닙니다.",
    ),
    "M14",
)


ONE_ROBOT_BELOW_THE_OTHER = WrongStep(
    "one robot below the other",
    {"robots": "one below the other"},
    Text(
        en="The second robot hangs below the first one's odom: it would be carried along. They share map, and nothing else.",
        ko="두 번째 로봇이 첫 번째 로봇의 odom 아래에 달렸습니다. 함께 끌려다니게 됩니다. 둘이 함께 쓰는 것은 map뿐입니다.",
    ),
    "M2",
)

ON_THE_OTHERS_BASE = WrongStep(
    "on the other's base",
    {"robots": "on the other's base"},
    Text(
        en="The second robot hangs on the first one's base_link: it would be carried along. What do the two share?",
        ko="둘째 로봇이 첫째 로봇의 base_link에 달려 있어서 함께 실려 다닙니다. 두 로봇이 함께 쓰는 것은 무엇입니까?",
    ),
    "M14",
)

FIRST_BARE = WrongStep(
    "first robot bare",
    {"who": "the first bare"},
    Text(
        en="The first robot has no prefix. A bare name belongs to nobody: the next robot that joins sends the same.",
        ko="첫째 로봇에는 접두사가 없습니다. 접두사가 없는 이름은 누구의 것인지 알 수 없습니다. 다음 로봇도 같은 이름을 보낼 수 있습니다.",
    ),
    "M14",
)

ODOM_BARE_AS_PARENT = WrongStep(
    "odom bare as a parent",
    {"parents": "odom bare"},
    Text(
        en="As a parent odom has no prefix, and as a child it has one: these are two frames, and the tree breaks between them.",
        ko="부모로 쓴 odom에는 접두사가 없고 자식으로 쓴 odom에는 있습니다. 둘은 다른 좌표계라서 트리가 그 사이에서 끊깁니다.",
    ),
    "M14",
)


CHILDREN_BARE = WrongStep(
    "children bare",
    {"children": "bare"},
    Text(
        en="Only the parents have a prefix. As children the frames of both robots have one name, so the second robot's row takes the place of the first one's.",
        ko="부모에만 접두사가 붙었습니다. 자식으로서는 두 로봇의 좌표계 이름이 같아서 두 번째 로봇의 줄이 첫 번째의 것을 덮어씁니다.",
    ),
    "M14",
)


SUFFIX = WrongStep(
    "robot behind",
    {"glue": "{1}_{0}"},
    Text(
        en="The robot's name stands behind the frame, with an underscore. A prefix stands in front, with a slash: robot1/odom.",
        ko="로봇 이름이 좌표계 뒤에 밑줄로 붙었습니다. 접두어는 앞에 쓰고 슬래시로 잇습니다: robot1/odom.",
    ),
    "M14",
)


TASK = Task(
    id="E4.4",
    kind="T",
    points=3,
    title=Text(en="Two robots, one map", ko="로봇 두 대, 지도 하나"),
    answer="fleet",
    form=Tree(),
    given=robots,
    variants=8,
    model=together,
    mistakes=(
        ODOM_SHARED,
        MAP_PREFIXED,
        NO_SLASH,
        SLASH_IN_FRONT,
        NAMESPACE_DOES_IT,
        UNDERSCORE,
        CHILDREN_ONLY,
        SENSORS_BARE,
        UPSIDE_DOWN,
        THE_FIRST_ALONE,
        THE_LAST_ALONE,
        NAME_FIRST,
        SLASH_IN_FRONT_OF_ALL,
        NUMBERED,
        BELOW_MAP_IN_NAME,
        A_FRAME_FOR_EACH_ROBOT,
        ONE_ROBOT_BELOW_THE_OTHER,
        ON_THE_OTHERS_BASE,
        FIRST_BARE,
        ODOM_BARE_AS_PARENT,
        CHILDREN_BARE,
        SUFFIX,
    ),
    hints=(
        Text(
            en="Which one name do both robots mean the same thing by?",
            ko="두 로봇이 똑같은 것을 가리키는 데 쓰는 이름이 하나 있습니다. 무엇입니까?",
        ),
        Text(
            en="Every other name has a prefix, wherever it stands: as a child and as a parent.",
            ko="나머지 이름에는 자식으로 나오든 부모로 나오든 접두사를 붙입니다.",
        ),
        Text(
            en="Two loops: over `e4_4.prefixes`, and over `e4_4.edges`; a name is `f\"{robot}/{frame}\"`, but map stays map. In the inner loop: `fleet[child's name] = parent's name`.",
            ko='반복문 두 개입니다. `e4_4.prefixes`와 `e4_4.edges`를 돌며 이름을 `f"{robot}/{frame}"`으로 만드십시오. map은 그대로 둡니다. 안쪽 반복문에서 `fleet[자식 이름] = 부모 이름`을 씁니다.',
        ),
    ),
    misconceptions=("M2", "M14"),
)
