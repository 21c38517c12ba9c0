"""E4.7: The line that the dog needed."""

from __future__ import annotations

from tflab.workbook.tasks import Name, Task, Text, WrongAnswer, WrongStep

FRAMES = ("base_link", "laser_frame", "camera_link", "tool0", "imu_link")
ROBOTS = ("robot1", "spot", "tb3_0", "red", "alpha")


def names(rng):
    """Every way to write a prefix with every way to write a frame, map and odom among them."""
    rows = []
    for first in ("odom", FRAMES[int(rng.integers(len(FRAMES)))]):
        robot = ROBOTS[int(rng.integers(len(ROBOTS)))]
        second = [frame for frame in FRAMES if frame != first][int(rng.integers(len(FRAMES) - 1))]
        for prefix in ("", "/", robot, f"{robot}/", f"/{robot}", f"/{robot}/"):
            rows += [(prefix, first), (prefix, f"/{second}"), (prefix, "map")]
        rows += [(robot, "/map"), (f"fleet/{robot}", first), (robot, "map_server_frame"), (f"/{robot}/", "odom")]
        rows += [("", "/map"), (robot, "odom"), (robot, f"arm/{second}"), (robot.capitalize(), first)]
    return rows


def joined(prefix, name, *, ends="stripped", inner="stripped", glue="/", empty="bare", shared="map alone",
           first="the prefix", slash="between", letters="as they are"):  # fmt: skip
    """Return the full name, step by step; other steps are the slips."""
    came, was_empty = name, not prefix
    if ends == "all removed":
        prefix = prefix.replace("/", "")
    elif ends == "left only":
        prefix = prefix.lstrip("/")
    elif ends == "right only":
        prefix = prefix.rstrip("/")
    elif ends == "stripped":
        prefix = prefix.strip("/")
    name = name.strip("/") if inner != "as it is" else name
    name = name.rpartition("/")[2] if inner == "last word" else name
    name = name.replace("/", "") if inner == "all removed" else name
    if letters == "small":
        prefix, name = prefix.lower(), name.lower()
    is_shared = {
        "map alone": name == "map",
        "nothing": False,
        "begins with": name.startswith("map"),
        "odom too": name in ("map", "odom"),
        "as it came": came == "map",
        "a slash in front": name == "map" or came.startswith("/"),
        "a slash inside": name == "map" or "/" in name,
    }[shared]
    is_bare = {"bare": not prefix, "asked first": was_empty, "glued": False}[empty]
    if is_shared or is_bare:
        return name
    whole = f"{name}{glue}{prefix}" if first == "the name" else f"{prefix}{glue}{name}"
    return {"in front": f"/{whole}", "behind": f"{whole}/"}.get(slash, whole)


SMALL_LETTERS = WrongStep(
    "small letters",
    {"letters": "small"},
    Text(
        en="You make all letters small. TF2 takes names as they are: Spot/odom and spot/odom are two frames.",
        ko="글자를 모두 소문자로 바꿨습니다. TF2는 이름을 있는 그대로 봅니다. Spot/odom과 spot/odom은 서로 다른 좌표계입니다.",
    ),
    "M14",
)

SLASH_INSIDE_IS_A_PREFIX = WrongStep(
    "a slash inside is a prefix",
    {"shared": "a slash inside"},
    Text(
        en="A frame with a slash inside gets no prefix from you. arm/tool0 is a name like any other: the robot's is missing in front.",
        ko="안에 슬래시가 있는 이름에는 접두사를 붙이지 않았습니다. arm/tool0도 여느 이름과 같습니다. 앞에 로봇 이름이 빠졌습니다.",
    ),
    "M14",
)

EMPTY_GLUED = WrongStep(
    "slash after nothing",
    {"empty": "glued"},
    Text(
        en="A robot without a name gets a slash in front: /odom, the very fault of the story.",
        ko="이름이 없는 로봇의 좌표계 앞에 슬래시가 붙습니다. 이야기 속의 바로 그 /odom입니다.",
    ),
    "M14",
)

EMPTY_ASKED_FIRST = WrongStep(
    "emptiness asked first",
    {"empty": "asked first"},
    Text(
        en='You ask whether the prefix is empty before its slashes are gone. One that is only "/" is an empty one, too.',
        ko='슬래시를 떼기 전에 접두사가 비었는지 봅니다. "/"뿐인 접두사도 빈 접두사입니다.',
    ),
    "M14",
)

NO_SLASH = WrongStep(
    "no slash",
    {"glue": ""},
    Text(
        en="Nothing stands between the prefix and the frame: robot1odom is a name that nobody expects.",
        ko="접두사와 좌표계 사이에 아무것도 없습니다. robot1odom은 아무도 찾지 않는 이름입니다.",
    ),
    "M14",
)

PREFIX_AS_IT_IS = WrongStep(
    "prefix as it is",
    {"ends": "as it is"},
    Text(
        en="The prefix goes in as it came, with the slashes around it: some results begin with a slash, or hold two in a row.",
        ko="접두사를 받은 그대로 씁니다. 슬래시로 시작하거나 슬래시가 둘 이어지는 결과가 나옵니다.",
    ),
    "M14",
)

LEFT_ONLY = WrongStep(
    "left end only",
    {"ends": "left only"},
    Text(
        en="A prefix that ends with a slash gives two in a row.",
        ko="슬래시로 끝나는 접두사를 넣으면 슬래시가 둘 이어집니다.",
    ),
    "M14",
)

RIGHT_ONLY = WrongStep(
    "right end only",
    {"ends": "right only"},
    Text(
        en="A prefix that begins with a slash gives a result that does.",
        ko="슬래시로 시작하는 접두사를 넣으면 결과도 슬래시로 시작합니다.",
    ),
    "M14",
)

NAME_AS_IT_IS = WrongStep(
    "name as it is",
    {"inner": "as it is"},
    Text(
        en="The frame may come with a slash of its own: it has to go before the two are joined.",
        ko="좌표계 이름에도 슬래시가 있을 수 있습니다. 잇기 전에 떼어야 합니다.",
    ),
    "M14",
)

MAP_TOO = WrongStep(
    "map prefixed",
    {"shared": "nothing"},
    Text(
        en="map has a prefix now. It is the one frame that all robots share.",
        ko="map에도 접두사가 붙었습니다. map은 모든 로봇이 함께 쓰는 좌표계입니다.",
    ),
    "M14",
)

LIKE_MAP = WrongStep(
    "whatever begins with map",
    {"shared": "begins with"},
    Text(
        en="You share more than map: whatever begins with it, or holds it. Names are compared whole: only map itself is shared.",
        ko="map으로 시작하거나 map이 든 이름까지 함께 씁니다. 이름은 통째로 비교합니다. 함께 쓰는 것은 map뿐입니다.",
    ),
    "M14",
)

NEVER = WrongAnswer(
    "never a prefix",
    lambda prefix, name: name.strip("/"),
    Text(
        en="The prefix is lost: every robot would send the same names.",
        ko="접두사가 사라졌습니다. 모든 로봇이 같은 이름을 보내게 됩니다.",
    ),
    "M14",
)

GLUED = WrongAnswer(
    "glued as they are",
    lambda prefix, name: prefix + name,
    Text(
        en="You glue the two as they came: no slash between them, or several, and map gets a prefix, too. Clean both words first.",
        ko="둘을 받은 그대로 이었습니다. 사이에 슬래시가 없거나 여럿이고 map에도 접두사가 붙습니다. 먼저 두 낱말을 다듬으십시오.",
    ),
    "M14",
)

WITH_A_SLASH = WrongAnswer(
    "a slash between, always",
    lambda prefix, name: f"{prefix}/{name}",
    Text(
        en="That is the driver of the story: a slash between the two, whatever they are. An empty prefix gives /odom, and slashes of their own give two in a row.",
        ko="이야기 속의 드라이버와 같습니다. 무엇이 오든 사이에 슬래시를 넣습니다. 접두사가 비면 /odom이 되고, 원래 있던 슬래시와 이어지기도 합니다.",
    ),
    "M14",
)

IF_PREFIX = WrongAnswer(
    "only the empty prefix",
    lambda prefix, name: f"{prefix}/{name}" if prefix else name,
    Text(
        en="The empty prefix is looked after. The slashes around a prefix, that before a name, and map are not yet.",
        ko="빈 접두사는 처리했습니다. 접두사 양 끝의 슬래시와 이름 앞의 슬래시, 그리고 map이 남았습니다.",
    ),
    "M14",
)

ONLY_THE_PREFIX = WrongAnswer(
    "only the prefix cleaned",
    lambda prefix, name: f"{prefix.strip('/')}/{name}",
    Text(
        en="The prefix is clean. What if nothing is left of it, if the name has a slash, if it is map?",
        ko="접두사는 다듬었습니다. 접두사가 비어 버리거나, 이름에 슬래시가 있거나, 이름이 map이면 어떻게 됩니까?",
    ),
    "M14",
)

UNDERSCORE = WrongStep(
    "underscore",
    {"glue": "_"},
    Text(
        en="Prefix and name are joined with an underscore. That is a name like any other to tf2, and not the one that robot_state_publisher sends: use a slash.",
        ko="접두사와 이름을 밑줄로 이었습니다. tf2에는 다른 이름일 뿐이고 robot_state_publisher가 보내는 이름도 아닙니다. 슬래시로 이으십시오.",
    ),
    "M14",
)

NAME_FIRST = WrongStep(
    "name first",
    {"first": "the name"},
    Text(
        en="The name stands before the prefix: a prefix stands in front.",
        ko="이름이 접두사보다 먼저 있습니다. 접두사는 앞에 붙입니다.",
    ),
    "M14",
)

IN_FRONT = WrongStep(
    "slash in front",
    {"slash": "in front"},
    Text(
        en="Some of your results begin with a slash. Such a name is kept without it, and refused when somebody asks for it: write none.",
        ko="슬래시로 시작하는 결과가 있습니다. 저장할 때는 떼지만 조회하면 거부합니다. 맨 앞에는 슬래시를 쓰지 마십시오.",
    ),
    "M14",
)

BEHIND = WrongStep(
    "slash behind",
    {"slash": "behind"},
    Text(
        en="A slash is left at the end: a frame of its own, that nobody else publishes.",
        ko="끝에 슬래시가 남았습니다. 아무도 발행하지 않는 다른 좌표계가 됩니다.",
    ),
    "M14",
)

SLASH_ALWAYS = WrongAnswer(
    "a slash in front, always",
    lambda prefix, name: "/" + "/".join(part for part in (prefix.strip("/"), name.strip("/")) if part),
    Text(
        en="Every name of yours begins with a slash, and map has a prefix. Without a prefix that is /odom, the very fault of the story.",
        ko="모든 이름이 슬래시로 시작하고 map에도 접두사가 붙습니다. 접두사가 없으면 이야기 속의 바로 그 /odom이 됩니다.",
    ),
    "M14",
)

DOUBLES_ALONE = WrongAnswer(
    "doubled slashes alone",
    lambda prefix, name: f"{prefix}/{name}".replace("//", "/"),
    Text(
        en="Doubled slashes become one. One in front still stays, and map has a prefix.",
        ko="겹친 슬래시는 하나로 만들었습니다. 맨 앞의 슬래시는 남아 있고 map에도 접두사가 붙습니다.",
    ),
    "M14",
)


MAP_AS_IT_CAME = WrongStep(
    "map as it came",
    {"shared": "as it came"},
    Text(
        en="You look for map before the slash in front of it is gone: `/map` gets a prefix.",
        ko="앞의 슬래시를 떼기 전에 map인지 봅니다. 그래서 `/map`에 접두사가 붙습니다.",
    ),
    "M14",
)


ODOM_SHARED = WrongStep(
    "odom shared",
    {"shared": "odom too"},
    Text(
        en="You share odom as well. Each robot counts its wheels from a place of its own: only map is shared.",
        ko="odom도 함께 씁니다. 로봇마다 바퀴를 세기 시작한 곳이 다릅니다. 함께 쓰는 것은 map뿐입니다.",
    ),
    "M14",
)


ALL_SLASHES_REMOVED = WrongStep(
    "all slashes removed",
    {"ends": "all removed"},
    Text(
        en="You take every slash out of the prefix, also the one in the middle: fleet/robot becomes another name. Only those at its ends go.",
        ko="접두사에서 가운데 슬래시까지 모두 지웁니다. fleet/robot이 다른 이름이 됩니다. 양 끝의 것만 지우십시오.",
    ),
    "M14",
)


JOINED_AS_PATHS = WrongAnswer(
    "joined as paths",
    lambda prefix, name: name if name.startswith("/") else f"{prefix.rstrip('/')}/{name}",
    Text(
        en="You join them as paths of files: there, a name with a slash in front throws away all before it. Frames are no files; strip the slashes first.",
        ko="파일 경로처럼 이었습니다. 경로에서는 앞에 슬래시가 있는 이름이 앞부분을 버립니다. 좌표계는 파일이 아닙니다. 슬래시를 먼저 떼십시오.",
    ),
    "M14",
)


CLEANED_AT_THE_END = WrongAnswer(
    "cleaned at the end",
    lambda prefix, name: name.strip("/") if name.strip("/") == "map" else f"{prefix}/{name}".strip("/"),
    Text(
        en="You strip the whole after joining: what stands twice in the middle stays there. Clean prefix and name before.",
        ko="이은 다음에 양 끝만 정리합니다. 가운데 겹친 슬래시는 그대로 남습니다. 접두사와 이름을 먼저 정리하십시오.",
    ),
    "M14",
)

SLASH_IS_ABSOLUTE = WrongStep(
    "slash is absolute",
    {"shared": "a slash in front"},
    Text(
        en="A frame that comes with a slash in front gets no prefix from you. That is how paths and topics work; a frame's slash says nothing.",
        ko="앞에 슬래시가 있는 좌표계에는 접두사를 붙이지 않습니다. 경로나 토픽에서는 그렇지만, 좌표계 앞의 슬래시에는 뜻이 없습니다.",
    ),
    "M14",
)


LAST_WORD_OF_THE_NAME = WrongStep(
    "last word of the name",
    {"inner": "last word"},
    Text(
        en="Of a name with a slash inside only what follows the last slash is left: arm/tool0 is one name, and stays whole.",
        ko="안에 슬래시가 있는 이름에서 마지막 슬래시 뒤만 남았습니다. arm/tool0은 이름 하나이므로 통째로 두십시오.",
    ),
    "M14",
)


FRAME_S_SLASHES_REMOVED = WrongStep(
    "slashes inside the frame removed",
    {"inner": "all removed"},
    Text(
        en="A slash inside the frame goes, too: `arm/tool0` becomes `armtool0`. Only one in front of it is too many.",
        ko="좌표계 이름 안쪽의 슬래시까지 없앱니다. `arm/tool0`이 `armtool0`이 됩니다. 없앨 것은 맨 앞의 슬래시뿐입니다.",
    ),
    "M14",
)


TASK = Task(
    id="E4.7",
    kind="F",
    points=2,
    title=Text(en="The line that the dog needed", ko="로봇 개에게 필요했던 한 줄"),
    answer="frame_name",
    form=Name(),
    inputs=names,
    variants=3,
    model=joined,
    mistakes=(
        EMPTY_GLUED,
        EMPTY_ASKED_FIRST,
        NO_SLASH,
        PREFIX_AS_IT_IS,
        LEFT_ONLY,
        RIGHT_ONLY,
        NAME_AS_IT_IS,
        MAP_TOO,
        LIKE_MAP,
        NEVER,
        GLUED,
        WITH_A_SLASH,
        IF_PREFIX,
        ONLY_THE_PREFIX,
        UNDERSCORE,
        NAME_FIRST,
        IN_FRONT,
        BEHIND,
        SLASH_ALWAYS,
        DOUBLES_ALONE,
        MAP_AS_IT_CAME,
        ODOM_SHARED,
        ALL_SLASHES_REMOVED,
        JOINED_AS_PATHS,
        CLEANED_AT_THE_END,
        SLASH_IS_ABSOLUTE,
        SLASH_INSIDE_IS_A_PREFIX,
        SMALL_LETTERS,
        LAST_WORD_OF_THE_NAME,
        FRAME_S_SLASHES_REMOVED,
    ),
    hints=(
        Text(en="Clean both words first, then join them.", ko="두 낱말을 먼저 다듬고 나서 이으십시오."),
        Text(
            en='`.strip("/")` takes slashes from both ends. What should an empty prefix give?',
            ko='`.strip("/")`은 양 끝의 슬래시를 뗍니다. 접두사가 비어 있으면 무엇이 나와야 합니까?',
        ),
        Text(
            en="Two cases give the bare name: no prefix, and map. All else is prefix, slash, name.",
            ko="접두사가 없을 때와 map일 때는 이름만 반환합니다. 나머지는 접두사, 슬래시, 이름입니다.",
        ),
    ),
    misconceptions=("M14",),
)
