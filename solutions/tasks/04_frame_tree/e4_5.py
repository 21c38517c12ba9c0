"""E4.5: What becomes of this name?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongStep

OPTIONS = ("kept as odom", "another frame", "refused when sent", "refused when asked", "shared by accident")
LINES = {
    "send '/odom' -> 'base_link'": "kept as odom",
    "send 'Odom' -> 'base_link'": "another frame",
    "send '//odom' -> 'base_link'": "another frame",
    "send '' -> 'base_link'": "refused when sent",
    "send 'odom' -> 'odom'": "refused when sent",
    "ask lookup_transform('/odom', 'base_link', Time())": "refused when asked",
    "robot1 and robot2 both send 'map' -> 'odom'": "shared by accident",
    "robot1 and robot2, each in a namespace of its own, both send 'odom' -> 'base_link'": "shared by accident",
}
LETTERS = "abcdefgh"


def lines(rng):
    order = [list(LINES)[int(number)] for number in rng.permutation(len(LINES))]
    return {"lines": dict(zip(LETTERS, order, strict=True))}


def fates(given, *, slash="forgiven", case="told apart", double="told apart", senseless="refused", asked="refused", namespace="no prefix", shared="told"):  # fmt: skip
    """Return what becomes of each line, one belief after the other; other beliefs are the slips."""
    beliefs = {
        "send '/odom' -> 'base_link'": {"forgiven": "kept as odom"}.get(slash, slash),
        "send 'Odom' -> 'base_link'": {"told apart": "another frame", "ignored": "kept as odom"}.get(case, case),
        "send '//odom' -> 'base_link'": {"told apart": "another frame"}.get(double, double),
        "send '' -> 'base_link'": {"refused": "refused when sent", "stored": "another frame"}.get(senseless, senseless),
        "send 'odom' -> 'odom'": {"refused": "refused when sent", "stored": "kept as odom"}.get(senseless, senseless),
        "ask lookup_transform('/odom', 'base_link', Time())": {"refused": "refused when asked"}.get(asked, asked),
        "robot1 and robot2 both send 'map' -> 'odom'": {"told": "shared by accident", "fine": "kept as odom"}.get(
            shared, shared
        ),
        "robot1 and robot2, each in a namespace of its own, both send 'odom' -> 'base_link'": {
            "no prefix": "shared by accident"
        }.get(namespace, namespace),
    }
    return {letter: beliefs[line] for letter, line in given.lines.items()}


SLASH_REFUSED = WrongStep(
    "slash refused when sent",
    {"slash": "refused when sent"},
    Text(
        en="tf2 drops one slash of a name that is *sent*, and stores the rest. It is strict only about questions.",
        ko="tf2는 *보내는* 이름의 슬래시 하나를 떼고 저장합니다. 엄격한 것은 물을 때뿐입니다.",
    ),
    "M14",
)

SLASH_IS_ANOTHER = WrongStep(
    "slash makes another frame",
    {"slash": "another frame"},
    Text(
        en="For a Python dict /odom is another key; tf2 drops one slash when it stores.",
        ko="파이썬 dict라면 /odom은 다른 키입니다. 하지만 tf2는 저장할 때 슬래시 하나를 뗍니다.",
    ),
    "M14",
)

CASE_IGNORED = WrongStep(
    "case ignored",
    {"case": "ignored"},
    Text(
        en="Capitals count: names are compared letter by letter.",
        ko="대문자도 구별합니다. 이름은 글자 하나하나를 비교합니다.",
    ),
    "M14",
)

BOTH_SLASHES = WrongStep(
    "both slashes dropped",
    {"double": "kept as odom"},
    Text(
        en="Only *one* slash is dropped. What is left begins with the second.",
        ko="슬래시는 *하나만* 뗍니다. 남은 이름은 두 번째 슬래시로 시작합니다.",
    ),
    "M14",
)

DOUBLE_REFUSED = WrongStep(
    "double slash refused",
    {"double": "refused when sent"},
    Text(
        en="//odom is stored, though it cannot be asked for: tf2 drops one slash and looks no further.",
        ko="//odom은 저장됩니다. 물을 수는 없지만 tf2는 슬래시 하나만 떼고 더 보지 않습니다.",
    ),
    "M14",
)

ANYTHING_STORED = WrongStep(
    "anything is stored",
    {"senseless": "stored"},
    Text(
        en="tf2 checks little, but not nothing: what has no name, or is its own parent, cannot be stored.",
        ko="tf2는 거의 확인하지 않지만 전혀 확인하지 않는 것은 아닙니다. 이름이 없거나 자기 자신이 부모이면 저장할 수 없습니다.",
    ),
    partly=True,
)

ASKING_FORGIVEN = WrongStep(
    "forgiven when asked",
    {"asked": "kept as odom"},
    Text(
        en="The slash is forgiven to whoever sends. A question with one is an InvalidArgumentException.",
        ko="슬래시는 보내는 쪽에만 눈감아 줍니다. 슬래시로 묻는 것은 InvalidArgumentException입니다.",
    ),
    "M14",
)

ASKED_IS_UNKNOWN = WrongStep(
    "asked for another frame",
    {"asked": "another frame"},
    Text(
        en="The question never gets as far as looking a name up: its form is refused.",
        ko="이름을 찾아보는 데까지 가지 못합니다. 질문의 꼴에서 거부됩니다.",
    ),
    "M11",
)

NAMESPACE_DIVIDES = WrongStep(
    "a namespace divides",
    {"namespace": "kept as odom"},
    Text(
        en="A namespace goes before topics and services, never before the frames in a message. Both robots send one name.",
        ko="네임스페이스는 토픽과 서비스 이름에 붙고 메시지 속 좌표계에는 붙지 않습니다. 두 로봇이 한 이름을 보냅니다.",
    ),
    "M14",
)

NAMESPACE_PREFIXES = WrongStep(
    "a namespace prefixes",
    {"namespace": "another frame"},
    Text(
        en="It would be another frame if the namespace made robot1/odom of odom. It does that to topics, never to frames.",
        ko="네임스페이스가 odom을 robot1/odom으로 바꿔 준다면 다른 좌표계일 것입니다. 토픽은 그렇게 되지만 좌표계는 아닙니다.",
    ),
    "M14",
)

SHARING_IS_FINE = WrongStep(
    "sharing is fine",
    {"shared": "fine"},
    Text(
        en="It is stored as odom, yes; but two robots count their wheels from two places, and mean two things by that one name.",
        ko="odom으로 저장되기는 합니다. 하지만 두 로봇은 서로 다른 곳에서 바퀴를 세므로 한 이름으로 두 가지를 뜻합니다.",
    ),
    "M14",
)


CAPITAL_REFUSED = WrongStep(
    "a capital refused",
    {"case": "refused when sent"},
    Text(
        en="tf2 has nothing against capitals: `Odom` is as good a name as any, that of another frame.",
        ko="tf2는 대문자를 막지 않습니다. `Odom`도 다른 이름만큼 쓸 수 있는, 다른 좌표계의 이름입니다.",
    ),
    "M14",
)

SENT_IS_ASKED = WrongStep(
    "sent, and called asked",
    dict.fromkeys(("slash", "case", "double", "senseless"), "refused when asked"),
    Text(
        en="Nobody asks anything there: the line is sent. What becomes of it is settled when it arrives.",
        ko="묻는 줄이 아니라 보내는 줄입니다. 어떻게 될지는 도착했을 때 정해집니다.",
    ),
    partly=True,
)

ASKED_IS_SENT = WrongStep(
    "asked, and called sent",
    {"asked": "refused when sent"},
    Text(
        en="Nothing is sent there: the line is a question, and its own form is at fault.",
        ko="보내는 줄이 아니라 묻는 줄이고, 물음의 형식 자체가 잘못되었습니다.",
    ),
)

SHARED_IS_REFUSED = WrongStep(
    "two senders refused",
    {"shared": "refused when sent", "namespace": "refused when sent"},
    Text(
        en="tf2 does not ask who sends. Both messages are well made and both are stored, each over the other.",
        ko="tf2는 누가 보내는지 따지지 않습니다. 두 메시지 모두 형식이 맞고, 서로를 덮으며 둘 다 저장됩니다.",
    ),
    partly=True,
)

SHARED_IS_ANOTHER = WrongStep(
    "two senders told apart",
    {"shared": "another frame"},
    Text(
        en="Both send the same letters, so to tf2 it is one frame, whoever sends.",
        ko="둘 다 같은 글자를 보내므로 tf2에게는 누가 보내든 한 좌표계입니다.",
    ),
    "M14",
)


TASK = Task(
    id="E4.5",
    kind="M",
    points=3,
    title=Text(en="What becomes of this name?", ko="이 이름은 어떻게 될까요?"),
    answer="fates",
    form=Parts({letter: Choice(OPTIONS) for letter in LETTERS}),
    given=lines,
    variants=8,
    model=fates,
    mistakes=(
        SLASH_REFUSED,
        SLASH_IS_ANOTHER,
        CASE_IGNORED,
        BOTH_SLASHES,
        DOUBLE_REFUSED,
        ANYTHING_STORED,
        ASKING_FORGIVEN,
        ASKED_IS_UNKNOWN,
        NAMESPACE_DIVIDES,
        NAMESPACE_PREFIXES,
        SHARING_IS_FINE,
        CAPITAL_REFUSED,
        SENT_IS_ASKED,
        ASKED_IS_SENT,
        SHARED_IS_REFUSED,
        SHARED_IS_ANOTHER,
    ),
    hints=(
        Text(
            en="First: is it sent, or asked? Then: by one robot, or by two?",
            ko="먼저 보내는 것인지 묻는 것인지, 다음으로 로봇이 하나인지 둘인지 보십시오.",
        ),
        Text(
            en="Sending forgives one slash, asking none; and letters are compared one by one.",
            ko="보낼 때는 슬래시 하나를 눈감아 주고 물을 때는 하나도 눈감아 주지 않습니다. 글자는 하나하나 비교합니다.",
        ),
        Text(
            en="Try it: `Buffer().set_transform_static(...)`, as `send` does on the page, and look at `buffer.core.frame_names()`. What two robots mean by a name no buffer can tell you.",
            ko="직접 해 보세요. 본문의 `send`처럼 `Buffer().set_transform_static(...)`을 호출하고 `buffer.core.frame_names()`를 보십시오. 두 로봇이 한 이름으로 무엇을 뜻하는지는 버퍼가 알려 주지 않습니다.",
        ),
    ),
    misconceptions=("M14",),
    means={
        "kept as odom": Text(
            en="Kept as odom: one robot sends, and what is stored is just these four letters.",
            ko="kept as odom: 로봇 하나가 보내고, 저장되는 것은 정확히 이 네 글자입니다.",
        ),
        "another frame": Text(
            en="Another frame: it is sent and stored, under other letters.",
            ko="another frame: 보내서 저장되지만 글자가 다릅니다.",
        ),
        "refused when sent": Text(
            en="Refused when sent: it could not be stored as an edge at all, for want of a name or of a second frame.",
            ko="refused when sent: 이름이나 상대 좌표계가 없어 연결로 저장할 수 없습니다.",
        ),
        "refused when asked": Text(
            en="Refused when asked: that is said of a question; most of these lines are sent.",
            ko="refused when asked: 질문에만 해당합니다. 여기 있는 줄은 대부분 보내는 것입니다.",
        ),
        "shared by accident": Text(
            en="Shared by accident: that needs two robots.",
            ko="shared by accident: 로봇이 둘이어야 합니다.",
        ),
    },
)
