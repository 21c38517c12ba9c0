"""E6.5: Six extracts from a log."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

CAUSES = (
    "several letters", "publisher gone", "no board", "silent mover", "bolt on /tf", "mover on /tf_static",
    "misspelt name",
)  # fmt: skip
REMEDIES = (
    "send one list", "keep it running", "offer TRANSIENT_LOCAL", "send on while it stands", "send it on /tf_static",
    "send it on /tf", "wait longer", "send it faster", "mend the name",
)  # fmt: skip

RIGHT = {
    "a": "bolt on /tf",
    "a do": "send it on /tf_static",
    "b": "no board",
    "b do": "offer TRANSIENT_LOCAL",
    "c": "mover on /tf_static",
    "c do": "send it on /tf",
    "d": "several letters",
    "d do": "send one list",
    "e": "silent mover",
    "e do": "send on while it stands",
    "f": "publisher gone",
    "f do": "keep it running",
}
DO = tuple(part for part in RIGHT if part.endswith(" do"))


def but(**parts):
    return {**RIGHT, **{part.replace("_", " "): value for part, value in parts.items()}}


def unknown(frame):
    return f'"{frame}" passed to lookupTransform argument source_frame does not exist. '


def future(asked_s, newest_s, target, source):
    return (
        f"Lookup would require extrapolation into the future.  Requested time {asked_s:.6f} but the latest data is at "
        f"time {newest_s:.6f}, when looking up transform from frame [{source}] to frame [{target}]"
    )


def extracts(rng):
    """Return six extracts, each of another robot; names and numbers are drawn, and so is nothing that tells."""
    sensors = [str(name) for name in rng.permutation(["camera", "radar", "sonar", "thermal", "stereo", "depth"])]
    mover, lift = (str(name) for name in rng.permutation(["lift_link", "mast_link", "fork_link", "gripper_link"])[:2])
    now = round(float(rng.uniform(40.0, 90.0)), 1)
    gap, late = round(float(rng.uniform(0.25, 0.75)), 2), round(float(rng.uniform(2.0, 9.0)), 1)
    cams = [f"{sensors[0]}_{number}" for number in range(1, int(rng.integers(3, 6)) + 1)]
    heights = sorted(round(float(h), 2) for h in rng.uniform(0.1, 0.9, 3))
    bolt, driver, stopped = (f"{sensors[place]}_link" for place in (1, 2, 3))
    lines = {
        "a": [
            future(now, now - gap, "odom", bolt),
            f"odom -> base_link: /tf, 50 Hz.  base_link -> {bolt}: /tf, 1 Hz, always the same numbers.",
        ],
        "b": [
            f"[{sensors[2]}_driver]: New subscription discovered on topic '/tf_static', requesting incompatible QoS. "
            "No messages will be sent to it. Last incompatible policy: DURABILITY",
            unknown(driver),
        ],
        "c": [
            "No error in any log.",
            f"base_link -> {lift}, height asked for three moments: {heights[2]} m, {heights[2]} m, {heights[2]} m.",
            f"A camera saw it at these moments at {heights[0]} m, {heights[1]} m, {heights[2]} m.",
        ],
        "d": [
            unknown(cams[0]),
            f"/tf_static: Publisher count: 1, TRANSIENT_LOCAL.  The first listener knows {', '.join(cams)}.",
            f"A listener that was started later knows {cams[-1]}.",
        ],
        "e": [
            future(now, round(now - late, 1), "base_link", mover),
            f"base_link -> {mover}: /tf, 20 Hz until {now - late:.1f} s, when it reached its end, then nothing.",
        ],
        "f": [
            unknown(stopped),
            f"/tf_static: Publisher count: 0.  A listener that runs since the morning knows {stopped}.",
        ],
    }
    return {name: "\n".join(text) for name, text in lines.items()}


WAIT = WrongAnswer(
    "late, so wait",
    {**RIGHT, **dict.fromkeys(DO, "wait longer")},
    Text(
        en="Waiting brings what is on its way. Here nothing is: each of these says the same in an hour.",
        ko="기다려서 오는 것은 이미 오고 있는 것뿐입니다. 여기에는 오는 것이 없습니다. 한 시간 뒤에도 모두 그대로입니다.",
    ),
    "M10",
    partly=True,
)

FASTER = WrongAnswer(
    "send the bolt faster",
    but(a_do="send it faster"),
    Text(
        en="a do: a bolt sent faster is only less old. The driver of the story did it 110 times a second.",
        ko="a do: 볼트를 더 자주 보내면 덜 낡을 뿐입니다. 이야기 속 드라이버는 1초에 110번 보냈습니다.",
    ),
    "M12",
    part="a do",
)

WAIT_FOR_THE_BOLT = WrongAnswer(
    "wait for the bolt",
    but(a_do="wait longer"),
    Text(
        en="a do: waiting brings an answer, up to a second late, at every single question. Why should a bolt have to be waited for?",
        ko="a do: 기다리면 답은 오지만 조회할 때마다 길면 1초가 늦습니다. 볼트를 왜 기다려야 합니까?",
    ),
    "M10",
    part="a do",
)

TYPO = WrongAnswer(
    "typo",
    but(b="misspelt name", d="misspelt name", f="misspelt name", b_do="mend the name", d_do="mend the name",
        f_do="mend the name"),
    Text(
        en='"Does not exist" means: this listener never heard of it. A misspelt name is one reason; the lines around show another.',
        ko='"Does not exist"는 이 수신기가 들은 적이 없다는 뜻입니다. 철자 오류도 한 원인이지만, 앞뒤의 줄이 다른 원인을 보여 줍니다.',
    ),
    "M11",
    partly=True,
)  # fmt: skip

FASTER_MOVER = WrongAnswer(
    "mover faster",
    but(e_do="send it faster"),
    Text(
        en="e do: while it was sent, it was sent often enough. What matters is what happens when it stands.",
        ko="e do: 보내는 동안에는 충분히 자주 보냈습니다. 멈춰 있을 때가 문제입니다.",
    ),
    part="e do",
)

MOVER_TO_THE_BOARD = WrongAnswer(
    "mover to the board",
    but(e_do="send it on /tf_static"),
    Text(
        en="e do: on a board it has an answer for every moment, and for all but the last a wrong one.",
        ko="e do: 게시판에 붙이면 어느 시각이든 답이 나오지만, 마지막 말고는 모두 틀린 답입니다.",
    ),
    "M12",
    part="e do",
)

SOLD_OUT = WrongAnswer(
    "letters and gone exchanged",
    but(d="publisher gone", d_do="keep it running", f="several letters", f_do="send one list"),
    Text(
        en="Look at the publisher count: one board that holds too little, and no board at all, are two things.",
        ko="발행자 수를 보세요. 게시판에 적게 남은 것과 게시판이 아예 없는 것은 다릅니다.",
    ),
    "M12",
    partly=True,
)

BOARD_FOR_LETTERS = WrongAnswer(
    "durability for letters",
    but(d="no board", d_do="offer TRANSIENT_LOCAL"),
    Text(
        en="TRANSIENT_LOCAL is on offer there already. Where it is missing, both sides log a warning.",
        ko="TRANSIENT_LOCAL은 그곳에서 이미 제공하고 있습니다. 지속성이 맞지 않으면 양쪽이 경고를 냅니다.",
    ),
    "M12",
    partly=True,
)

BOARD_FOR_THE_GONE = WrongAnswer(
    "durability for the gone",
    but(f="no board", f_do="offer TRANSIENT_LOCAL"),
    Text(
        en="Nobody is left there to offer TRANSIENT_LOCAL, or anything else: look at the publisher count.",
        ko="그곳에는 TRANSIENT_LOCAL이든 무엇이든 제공할 발행자가 남아 있지 않습니다. 발행자 수를 보십시오.",
    ),
    "M12",
    partly=True,
)

AGAIN_ON_THE_BOARD = WrongAnswer(
    "one list for the mover",
    but(c="several letters", c_do="send one list"),
    Text(
        en="c: a late listener is not the trouble here. The numbers are wrong, for earlier moments, for everybody.",
        ko="c: 늦게 온 수신기의 문제가 아닙니다. 이전 시각의 숫자가 누구에게나 틀립니다.",
    ),
    "M12",
)

TWO_SILENCES = WrongAnswer(
    "bolt and mover exchanged",
    but(a="silent mover", a_do="send on while it stands", e="bolt on /tf", e_do="send it on /tf_static"),
    Text(
        en="Both texts say `into the future`. Ask of each edge: can it move? What always has the same numbers is bolted on.",
        ko="두 오류 모두 `into the future`입니다. 연결마다 움직일 수 있는지 따져 보세요. 숫자가 늘 같은 것은 고정된 것입니다.",
    ),
    "M12",
    partly=True,
)


TASK = Task(
    id="E6.5",
    kind="D",
    points=5,
    title=Text(en="Six extracts from a log", ko="로그에서 뽑은 여섯 토막"),
    answer="diagnosis",
    form=Parts({part: Choice(REMEDIES if part in DO else CAUSES) for part in RIGHT}),
    given=extracts,
    variants=6,
    mistakes=(
        WAIT,
        FASTER,
        WAIT_FOR_THE_BOLT,
        TYPO,
        FASTER_MOVER,
        MOVER_TO_THE_BOARD,
        SOLD_OUT,
        BOARD_FOR_LETTERS,
        BOARD_FOR_THE_GONE,
        AGAIN_ON_THE_BOARD,
        TWO_SILENCES,
    ),
    hints=(
        Text(
            en="First ask: is the frame unknown, or known and refused for this moment, or answered wrongly?",
            ko="먼저 따져 보세요. 좌표계를 모릅니까, 알지만 그 시각을 거절합니까, 아니면 틀린 답을 합니까?",
        ),
        Text(
            en="Unknown: look at the publisher count, at DURABILITY, at who came first. Refused: can this edge move?",
            ko="모른다면 발행자 수와 DURABILITY, 누가 먼저 왔는지를 보세요. 거절한다면 그 연결이 움직일 수 있는 것인지 보세요.",
        ),
        Text(
            en="An answer that is the same for all moments comes from a board. What has the same numbers a thousand times is a bolt.",
            ko="어느 시각이든 같은 답은 게시판에서 온 것입니다. 천 번 보내도 같은 숫자라면 볼트입니다.",
        ),
    ),
    misconceptions=("M10", "M11", "M12"),
    means={
        "several letters": Text(
            en="then the late listener would know one frame, and the early one more.",
            ko="그렇다면 늦게 온 수신기는 하나를, 먼저 온 수신기는 더 많이 압니다.",
        ),
        "publisher gone": Text(
            en="then nobody would publish any more: a count of 0.",
            ko="그렇다면 발행자가 없습니다. 발행자 수가 0입니다.",
        ),
        "no board": Text(
            en="then two warnings about DURABILITY would stand in the logs.",
            ko="그렇다면 로그에 DURABILITY 경고가 두 번 나옵니다.",
        ),
        "silent mover": Text(
            en="then something that can move would have fallen silent.",
            ko="그렇다면 움직일 수 있는 것이 발행을 멈춘 것입니다.",
        ),
        "bolt on /tf": Text(
            en="then the same numbers would come again and again, and the end of the window with them.",
            ko="그렇다면 같은 숫자가 되풀이해서 오고, 그 사이의 시각은 거절됩니다.",
        ),
        "mover on /tf_static": Text(
            en="then one value would be given for every moment, without an error.",
            ko="그렇다면 오류 없이 모든 시각에 같은 값이 나옵니다.",
        ),
        "misspelt name": Text(
            en="then nobody, neither early nor late, would know the name.",
            ko="그렇다면 먼저 왔든 늦게 왔든 아무도 그 이름을 모릅니다.",
        ),
        "send one list": Text(
            en="one list helps where several messages share a board.",
            ko="리스트 하나로 보내기는 한 게시판에 메시지를 여러 번 보낼 때 도움이 됩니다.",
        ),
        "keep it running": Text(
            en="to keep a publisher running helps where it has ended.",
            ko="계속 실행하기는 발행자가 끝났을 때 도움이 됩니다.",
        ),
        "offer TRANSIENT_LOCAL": Text(
            en="TRANSIENT_LOCAL helps where a publisher on /tf_static offers less than listeners request.",
            ko="TRANSIENT_LOCAL은 /tf_static의 발행자가 수신기의 요구보다 적게 제공할 때 도움이 됩니다.",
        ),
        "send on while it stands": Text(
            en="to send on helps where something that moves falls silent.",
            ko="계속 보내기는 움직이는 것이 조용해졌을 때 도움이 됩니다.",
        ),
        "send it on /tf_static": Text(
            en="/tf_static helps what can never move against its parent.",
            ko="/tf_static은 부모를 기준으로 절대 움직이지 않는 것에 맞습니다.",
        ),
        "send it on /tf": Text(
            en="/tf helps what moves and needs a past.",
            ko="/tf는 움직이고 과거가 필요한 것에 맞습니다.",
        ),
        "wait longer": Text(
            en="waiting helps where an answer is on its way already.",
            ko="기다리기는 답이 이미 오고 있을 때 도움이 됩니다.",
        ),
        "send it faster": Text(
            en="a higher rate helps what moves and is told too seldom.",
            ko="더 자주 보내기는 움직이는 것을 너무 드물게 알릴 때 도움이 됩니다.",
        ),
        "mend the name": Text(
            en="to mend a name helps where nobody at all knows it.",
            ko="이름 고치기는 아무도 그 이름을 모를 때 도움이 됩니다.",
        ),
    },
    shows={
        **dict.fromkeys(
            ("a", "a do"),
            Text(
                en="Here an edge always has the same numbers, and comes once a second.",
                ko="여기서는 한 연결이 1초에 한 번 오고 숫자가 늘 같습니다.",
            ),
        ),
        **dict.fromkeys(
            ("b", "b do"),
            Text(en="Here the first line names a policy.", ko="여기서는 첫 줄에 정책 이름이 나옵니다."),
        ),
        **dict.fromkeys(
            ("c", "c do"),
            Text(
                en="Here three moments get one answer, and the thing was in three places.",
                ko="여기서는 세 시각의 답이 하나인데 실제로는 세 곳에 있었습니다.",
            ),
        ),
        **dict.fromkeys(
            ("d", "d do"),
            Text(
                en="Here there is one publisher with a board, and only the last frame reaches who comes late.",
                ko="여기서는 게시판이 있는 발행자가 하나이고, 늦게 온 수신기에는 마지막 좌표계만 전해집니다.",
            ),
        ),
        **dict.fromkeys(
            ("e", "e do"),
            Text(
                en="Here something came 20 times a second, arrived, and then nothing came.",
                ko="여기서는 1초에 스무 번 오다가, 도착한 뒤로 아무것도 오지 않습니다.",
            ),
        ),
        **dict.fromkeys(
            ("f", "f do"),
            Text(
                en="Here the count is 0, and who came early still knows the frame.",
                ko="여기서는 발행자 수가 0이고, 먼저 온 수신기만 좌표계를 압니다.",
            ),
        ),
    },
)
