"""E10.4: Which clock does a node get?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Sequence, Task, Text, WrongAnswer, WrongStep

NAMES = ("mapper", "detector", "planner", "camera", "localizer", "recorder", "driver", "watcher", "guard")
ABSENT = object()


def launch_files(rng):
    """Draw parameter files: for all, for one, both, as text, as a number, with and without a slash."""
    a, b, c = (NAMES[i] for i in rng.permutation(len(NAMES))[:3])
    nodes = [f"/{name}" for name in (a, b, c)]

    def file(**entries):
        return {key.replace("ALL", "/**"): {"ros__parameters": value} for key, value in entries.items()}

    def entry(name, value):
        return {name: {"ros__parameters": value}}

    sim, wall = {"use_sim_time": True}, {"use_sim_time": False}
    text, number = {"use_sim_time": str(rng.choice(["true", "True", "yes"]))}, {"use_sim_time": 1}
    return [
        (file(ALL=sim), nodes[:2]),
        ({**file(ALL=sim), **entry(f"/{b}", wall)}, nodes),
        ({**entry(f"/{a}", sim), **entry(c, sim)}, nodes),
        ({**file(ALL=text), **entry(f"/{c}", sim)}, nodes),
        ({**file(ALL=sim), **entry(b, {"rate": 10.0}), **entry(f"/{a}", text)}, nodes),
        ({**entry(f"/{c}", number), **file(ALL=wall), **entry(b, sim)}, nodes),
        ({**entry(a, wall), **file(ALL=sim)}, nodes),  # /** comes last in the file, and counts first all the same
        ({}, nodes[:2]),
        ({**file(ALL=sim), **entry(b, wall), **entry(f"/front/{c}", wall)}, [f"/front/{b}", f"/{c}", f"/{b}"]),
        ({**file(ALL={"rate": 5.0}), **entry(f"/{b}", {"use_sim_time": "false"})}, nodes),
        ({**file(ALL=wall), **entry(f"/{a}", {"use_sim_time": "true"})}, nodes),
    ]


def clocks(params, nodes, everyone=True, own="its own", slash="either", text="refused", order="own last",
           unset="wall", lacking="everyone's", level="parameters"):  # fmt: skip
    """Return what each node's clock is, step by step."""
    if level == "too high":
        return [unset for _ in nodes]
    return [_clock(params, node, everyone, own, slash, text, order, unset, lacking) for node in nodes]


def _clock(params, node, everyone, own, slash, text, order, unset, lacking):
    value = _held(_keys(params, node, everyone, own, slash, order), params, order, lacking, text)
    if value is ABSENT:
        return unset
    if isinstance(value, bool):
        return "sim" if value else "wall"
    if text == "unquoted":
        return {"true": "sim", "false": "wall"}.get(str(value).lower(), "refused")
    if text == "numbers":
        return {1: "sim", 0: "wall"}.get(value, "refused")
    if text in ("true in quotes", "true in quotes, and 1"):
        return "sim" if value == "true" or (value == 1 and text.endswith("1")) else "refused"
    if text == "read":
        return "sim" if str(value).lower() in ("true", "1", "yes") else "wall"
    return {"wall": "wall", "truthy": "sim" if value else "wall"}.get(text, "refused")


def _keys(params, node, everyone, own, slash, order):
    """Return the entries that count for a node, the one that counts most last."""
    bare = node.split("/")[-1] if slash == "last part" else node[1:]
    names = {"with": (f"/{bare}",), "without": (bare,)}.get(slash, (node, node[1:], bare))
    mine = {"its own": lambda key: key in names, "nobody's": lambda key: False, "everybody's": lambda key: key != "/**"}
    keys = [key for key in params if mine[own](key) or (everyone and key == "/**")]
    if order == "everyone alone" and "/**" in keys:
        keys = ["/**"]
    if order in ("own last", "any true", "or"):
        keys.sort(key=lambda key: key != "/**")
    elif order == "everyone last":
        keys.sort(key=lambda key: key == "/**")
    return keys[::-1] if order == "the first of the file" else keys


def _held(keys, params, order, lacking, text):
    """Return what is set last; ABSENT if nothing is."""
    value = ABSENT
    for key in keys:
        held = params[key]["ros__parameters"]
        if lacking == "nothing" and key != "/**" and "use_sim_time" not in held:
            value = ABSENT
        if key != "/**" and text == "passed over" and not isinstance(held.get("use_sim_time", True), bool):
            continue
        if key != "/**" and order == "or" and not held.get("use_sim_time"):
            continue
        value = held.get("use_sim_time", value) if order != "any true" or value is not True else value
    return value


def handed_on(params, nodes):
    """Return what comes out if what one node was told is where the next one begins."""
    value = params.get("/**", {}).get("ros__parameters", {}).get("use_sim_time", False)
    found = []
    for node in nodes:
        own = params.get(node, params.get(node[1:], {})).get("ros__parameters", {})
        value = own.get("use_sim_time", value)
        found.append(("sim" if value else "wall") if isinstance(value, bool) else "refused")
    return found


def refused_for_all(params, nodes):
    """Return what comes out if a value that nobody takes ends it for the nodes that have one of their own, too."""
    general = params.get("/**", {}).get("ros__parameters", {}).get("use_sim_time", False)
    return clocks(params, nodes) if isinstance(general, bool) else ["refused" for _ in nodes]


TEXT_IS_READ = WrongStep(
    "text is read",
    {"text": "read"},
    Text(
        en='You read "true" and 1 as if they were true. In YAML quotes make a text, and rclpy takes a text for no answer at all: only True and False will do.',
        ko='"true"나 1을 참으로 읽었습니다. YAML에서 따옴표를 붙이면 문자열이 되고, rclpy는 문자열을 받지 않습니다. True와 False만 됩니다.',
    ),
    "M13",
)

TEXT_IS_TRUTHY = WrongStep(
    "text is truthy",
    {"text": "truthy"},
    Text(
        en='`if value:` takes every text for true, "false" as well. Look at the type before the value.',
        ko='`if value:`는 모든 문자열을 참으로 봅니다. "false"도 참이 됩니다. 값보다 타입을 먼저 보십시오.',
    ),
    "M13",
)

TEXT_IS_WALL = WrongStep(
    "text is wall",
    {"text": "wall"},
    Text(
        en='What is neither True nor False counts as "wall" for you. The clock is the machine\'s then, but the node also logs an error: asked for is "refused".',
        ko='True도 False도 아닌 것을 "wall"로 보았습니다. 시계는 컴퓨터의 것이 되지만 노드가 오류도 기록합니다. 이때의 답은 "refused"입니다.',
    ),
    "M13",
)

QUOTES_DO_NOT_COUNT = WrongStep(
    "quotes do not count",
    {"text": "unquoted"},
    Text(
        en='You read the texts "true" and "false" as the values of that name. In YAML quotes make a text, and rclpy takes no text for this parameter.',
        ko='"true"와 "false"라는 텍스트를 True와 False로 읽습니다. YAML에서 따옴표가 있으면 텍스트이고, rclpy는 이 파라미터에 텍스트를 받지 않습니다.',
    ),
    "M13",
)

TRUE_IN_QUOTES = WrongStep(
    "true in quotes",
    {"text": "true in quotes"},
    Text(
        en='You take the text "true" for True. In YAML quotes make a text, and rclpy takes no text for this parameter.',
        ko='"true"라는 텍스트를 True로 읽었습니다. YAML에서 따옴표가 있으면 텍스트이고, rclpy는 이 파라미터에 텍스트를 받지 않습니다.',
    ),
    "M13",
)

TRUE_IN_QUOTES_AND_ONE = WrongStep(
    "true in quotes, and 1",
    {"text": "true in quotes, and 1"},
    Text(
        en='You take the text "true" for True, and the number 1 with it, for `1 == True` holds in Python. rclpy takes neither a text nor a number for this parameter: look at the type.',
        ko='"true"라는 텍스트를 True로 읽었고, 파이썬에서 `1 == True`가 참이라 숫자 1도 함께 통과했습니다. rclpy는 이 파라미터에 텍스트도 숫자도 받지 않습니다. 타입을 보십시오.',
    ),
    "M13",
)

NUMBERS_COUNT = WrongStep(
    "numbers count",
    {"text": "numbers"},
    Text(
        en="`1 == True` holds in Python, and still 1 is no bool: rclpy takes no number for this parameter. Look at the type.",
        ko="파이썬에서 `1 == True`는 참이지만 1은 bool이 아닙니다. rclpy는 이 파라미터에 숫자를 받지 않습니다. 타입을 보십시오.",
    ),
    "M13",
)

EVERYONE_IGNORED = WrongStep(
    "everyone ignored",
    {"everyone": False},
    Text(
        en="The entry `/**` is for every node, also for one that has no entry of its own.",
        ko="`/**` 항목은 모든 노드의 것입니다. 자기 항목이 없는 노드에도 적용됩니다.",
    ),
    "M13",
)

OWN_IGNORED = WrongStep(
    "own ignored",
    {"own": "nobody's"},
    Text(
        en="A node's own entry does not count for you. It stands there to make an exception.",
        ko="노드 자신의 항목을 보지 않았습니다. 예외를 두려고 적은 항목입니다.",
    ),
    "M13",
)

SLASH_NEEDED = WrongStep(
    "slash needed",
    {"slash": "with"},
    Text(
        en="Entries without a leading slash are passed over: `mapper` and `/mapper` are the same node in such a file.",
        ko="앞에 슬래시가 없는 항목을 건너뛰었습니다. 이 파일에서 `mapper`와 `/mapper`는 같은 노드입니다.",
    ),
    "M14",
)

SLASH_REFUSED = WrongStep(
    "slash refused",
    {"slash": "without"},
    Text(
        en="Entries with a leading slash are passed over: `/mapper` and `mapper` are the same node in such a file.",
        ko="앞에 슬래시가 있는 항목을 건너뛰었습니다. 이 파일에서 `/mapper`와 `mapper`는 같은 노드입니다.",
    ),
    "M14",
)

EVERYONE_WINS = WrongStep(
    "everyone wins",
    {"order": "everyone last"},
    Text(
        en="Where both speak, you let `/**` win. The special entry counts more than the general one.",
        ko="둘 다 있을 때 `/**`를 택했습니다. 특별한 항목이 일반 항목보다 우선합니다.",
    ),
    "M13",
)

EVERYONE_ALONE = WrongStep(
    "everyone alone",
    {"order": "everyone alone"},
    Text(
        en="Where the file has an entry `/**`, you look at no other one. It is the general one: a node's own entry replaces what it names.",
        ko="파일에 `/**` 항목이 있으면 다른 항목을 보지 않습니다. 그것은 일반 항목이고, 노드 자신의 항목은 거기에 적힌 것을 바꿉니다.",
    ),
    "M13",
)

LAST_LINE_WINS = WrongStep(
    "last line wins",
    {"order": "of the file"},
    Text(
        en="You take whichever stands last in the file. Where in the file an entry stands does not matter; whose it is does.",
        ko="파일에서 마지막에 나온 것을 택했습니다. 어디에 적혔는지가 아니라 누구의 항목인지가 중요합니다.",
    ),
)

FIRST_LINE_WINS = WrongStep(
    "first line wins",
    {"order": "the first of the file"},
    Text(
        en="You take whichever stands first in the file. Where in the file an entry stands does not matter; whose it is does.",
        ko="파일에서 먼저 나오는 것을 따릅니다. 항목이 파일의 어디에 있는지가 아니라 누구의 항목인지가 중요합니다.",
    ),
)

ONE_TRUE_IS_ENOUGH = WrongStep(
    "one true is enough",
    {"order": "any true"},
    Text(
        en="One True among the entries, and for you the node is in simulated time. The special entry can take back what the general one says.",
        ko="항목 가운데 True가 하나만 있어도 그 노드를 시뮬레이션 시간으로 봅니다. 노드 자신의 항목은 모두의 항목을 물릴 수 있습니다.",
    ),
)

FALSE_IS_PASSED_OVER = WrongStep(
    "false is passed over",
    {"order": "or"},
    Text(
        en="A node's own False does not count for you, as if it said nothing: `or` passes over what is false. False is an answer; ask whether it is set.",
        ko="노드 자신의 False를 설정하지 않은 것처럼 지나칩니다. `or`는 거짓인 값을 건너뜁니다. False도 설정한 값이므로, 설정되었는지를 물으십시오.",
    ),
    "M13",
)

NO_BOOL_IS_PASSED_OVER = WrongStep(
    "no bool is passed over",
    {"text": "passed over"},
    Text(
        en="Where a node's own entry holds no True or False, you take what is for all instead. The entry replaces it all the same, and the node refuses it.",
        ko="노드 자신의 항목이 True나 False가 아니면 모두의 항목을 대신 썼습니다. 그래도 자신의 항목이 우선하고, 노드는 그 값을 거부합니다.",
    ),
    "M13",
)

ENTRIES_OF_OTHERS = WrongStep(
    "entries of others",
    {"own": "everybody's"},
    Text(
        en="You let the entries of other nodes count, too. For a node two things count: what is for all, and what is its own.",
        ko="다른 노드의 항목까지 셉니다. 노드에게는 모두의 항목과 자신의 항목만 통합니다.",
    ),
)

NAMESPACE_DROPPED = WrongStep(
    "namespace dropped",
    {"slash": "last part"},
    Text(
        en="You compare the last part of a name alone. `/front/mapper` is another node than `/mapper`, and has an entry of its own.",
        ko="이름의 마지막 부분만 비교합니다. `/front/mapper`는 `/mapper`와 다른 노드이고 항목도 따로 있습니다.",
    ),
    "M14",
)

ONE_LEVEL_TOO_HIGH = WrongStep(
    "one level too high",
    {"level": "too high"},
    Text(
        en='Whatever the file says, every node hears the same word from you. Do you look one level too high? What is set stands below "ros__parameters".',
        ko='파일에 무엇이 적혀 있든 모든 노드에 같은 단어를 줍니다. 한 단계 위를 보고 있지 않습니까? 설정한 값은 "ros__parameters" 아래에 있습니다.',
    ),
)

UNSET_IS_REFUSED = WrongStep(
    "unset is refused",
    {"unset": "refused"},
    Text(
        en='A node for which nobody sets it is "refused" for you. There is nothing that could be refused: it keeps what every node begins with.',
        ko='아무도 설정하지 않은 노드를 "refused"라고 합니다. 거부할 값이 없습니다. 노드가 처음에 갖는 값 그대로입니다.',
    ),
    "M13",
)

UNSET_IS_SIM = WrongStep(
    "unset is sim",
    {"unset": "sim"},
    Text(
        en="A node for which nobody says anything lives in the machine's time: use_sim_time is false unless it is set.",
        ko="아무 설정도 없는 노드는 컴퓨터의 시간에 삽니다. use_sim_time은 설정하지 않으면 false입니다.",
    ),
    "M13",
)

OWN_ENTRY_REPLACES_ALL = WrongStep(
    "own entry replaces all",
    {"lacking": "nothing"},
    Text(
        en="A node with an entry of its own loses what `/**` says. The entries are laid on top of each other: only what the upper one names is replaced.",
        ko="자기 항목이 있는 노드는 `/**`의 값을 잃는다고 했습니다. 항목은 겹쳐집니다. 위의 항목에 적힌 것만 바뀝니다.",
    ),
)


HANDED_ON = WrongAnswer(
    "handed on",
    handed_on,
    Text(
        en="A node for which nothing of its own is set gets what the node before it had. Each node begins with what `/**` says: read that inside the loop.",
        ko="자기 항목에서 정하지 않은 노드가 앞 노드의 값을 물려받습니다. 노드마다 `/**`의 값에서 시작해야 합니다. 그 값을 반복문 안에서 읽으십시오.",
    ),
)


REFUSED_FOR_ALL = WrongAnswer(
    "refused for all",
    refused_for_all,
    Text(
        en="Where what `/**` says is refused, you refuse it for every node. One with an entry of its own that says True or False never gets to see it.",
        ko="`/**`의 값이 거절되면 모든 노드를 거절로 답합니다. 자기 항목에 True나 False가 있는 노드는 그 값을 쓰지 않습니다.",
    ),
)


TASK = Task(
    id="E10.4",
    kind="F",
    points=4,
    title=Text(en="Which clock does a node get?", ko="노드는 어느 시계를 얻습니까?"),
    answer="clock_of",
    form=Sequence(Choice(("sim", "wall", "refused"))),
    inputs=launch_files,
    variants=4,
    model=clocks,
    mistakes=(
        ONE_LEVEL_TOO_HIGH,
        EVERYONE_IGNORED,
        OWN_IGNORED,
        ENTRIES_OF_OTHERS,
        NAMESPACE_DROPPED,
        SLASH_NEEDED,
        SLASH_REFUSED,
        EVERYONE_WINS,
        EVERYONE_ALONE,
        LAST_LINE_WINS,
        FIRST_LINE_WINS,
        ONE_TRUE_IS_ENOUGH,
        FALSE_IS_PASSED_OVER,
        NO_BOOL_IS_PASSED_OVER,
        OWN_ENTRY_REPLACES_ALL,
        UNSET_IS_SIM,
        UNSET_IS_REFUSED,
        QUOTES_DO_NOT_COUNT,
        TRUE_IN_QUOTES,
        TRUE_IN_QUOTES_AND_ONE,
        NUMBERS_COUNT,
        TEXT_IS_READ,
        TEXT_IS_TRUTHY,
        TEXT_IS_WALL,
        HANDED_ON,
        REFUSED_FOR_ALL,
    ),
    hints=(
        Text(
            en="Collect the values that concern a node, the general one first, and let the later one replace the earlier.",
            ko="노드에 해당하는 값을 일반 항목부터 모으고, 나중 것이 앞의 것을 바꾸게 하십시오.",
        ),
        Text(
            en='Three keys can hold it: "/**", the name with its slash, and the name without. `params.get(key, {})` spares you an `if`.',
            ko='값이 있을 수 있는 키는 셋입니다. "/**", 슬래시가 있는 이름, 슬래시가 없는 이름입니다. `params.get(key, {})`를 쓰면 `if`가 줄어듭니다.',
        ),
        Text(
            en="At the end look at the type: `isinstance(value, bool)`. A number is none.",
            ko="마지막에 타입을 보십시오. `isinstance(value, bool)`입니다. 숫자는 bool이 아닙니다.",
        ),
    ),
    seen={
        "sim": Text(
            en="There the entry that counts for the node, its own before that of `/**`, says True.",
            ko="여기서는 그 노드에 통하는 항목이 True입니다. 노드 자신의 항목이 `/**`보다 먼저입니다.",
        ),
        "wall": Text(
            en="There the entry that counts for the node says False, or nobody sets it: every node begins with false.",
            ko="여기서는 그 노드에 통하는 항목이 False이거나 아무도 설정하지 않았습니다. 모든 노드는 false로 시작합니다.",
        ),
        "refused": Text(
            en="There the entry that counts for the node, its own before that of `/**`, holds a text or a number. Do you find that entry, written with a slash and without, and do you look at its type?",
            ko="여기서는 그 노드에 통하는 항목이 텍스트나 숫자입니다. 노드 자신의 항목이 `/**`보다 먼저입니다. 슬래시가 있든 없든 그 항목을 찾고, 타입을 봅니까?",
        ),
    },
    misconceptions=("M13", "M14"),
)
