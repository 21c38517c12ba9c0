"""E6.7: Who knows what?"""

from __future__ import annotations

import math

from tflab.workbook.tasks import Name, Set, Task, Text, WrongAnswer, WrongStep

NODES = ("calibrator", "driver", "wheels", "arm", "lift")
PARTS = ("camera", "laser", "radar", "sonar", "imu", "gps")


def logs(rng):
    """Logs in which each rule decides somewhere; joins and ends at the very moment, and a hair to either side.

    In the last ones the listener is asked as it joins, and a hair later: it has read the boards, and heard next to
    nothing.
    """
    rows = []
    for place, stay in enumerate((2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 0.0, 0.0, 0.01)):
        join = round(10.0 + float(rng.uniform(0.0, 4.0)), 2)
        rows.append(_log(rng, join, place, stay))
    return rows


def _log(rng, join, place, stay):
    """Several letters before and after the join, on both topics; one board ends before, one at it, one after."""
    names = [str(name) for name in rng.permutation(PARTS)]
    nodes = [str(node) for node in rng.permutation(NODES)]
    end = {0: join, 1: join + 0.01, 2: join - 0.01}[place % 3]
    last = join + stay
    on_the_edge = {0: join, 1: join - 0.01, 2: join + 0.01}[(place + 1) % 3]
    rows = [
        (nodes[0], "/tf_static", join - 6.0, [f"{names[0]}_1"]),
        (nodes[1], "/tf", join - 5.5, ["base_link"]),
        (nodes[2], "/tf_static", join - 5.0, [f"{names[1]}_link", f"{names[1]}_optical"]),
        (nodes[0], "/tf_static", join - 4.0, [f"{names[0]}_2", f"{names[0]}_3"]),
        (nodes[3], "/tf_static", join - 3.0, [f"{names[2]}_link"]),
        (nodes[1], "/tf", join - 0.5, ["base_link", f"{names[3]}_joint"]),
        (nodes[0], "/tf", join - 0.4, [f"{names[0]}_joint"]),
        (nodes[4], "/tf_static", on_the_edge, [f"{names[4]}_link"]),
        (nodes[1], "/tf", join + 1.0, ["base_link"]),
        (nodes[2], "/tf_static", {0: last, 1: last - 0.01, 2: last + 0.01}[place % 3], [f"{names[5]}_link"]),
        (nodes[1], "/tf", join + 1.3, ["base_link"]),  # heard twice, known once
        (nodes[1], "/tf", last + 1.0, ["tool0"]),
        (nodes[0], "/tf_static", join + 0.7, [f"{names[0]}_4"]),  # heard, and its node ends before now
    ]
    if place % 2:
        rows.insert(7, (nodes[4], "/tf_static", join - 0.2, [f"{names[4]}_old"]))
    rows.sort(key=lambda row: row[2])
    letters = [
        {"node": node, "topic": topic, "sent_s": round(sent, 3), "children": children}
        for node, topic, sent, children in rows
    ]
    ends = {nodes[3]: round(end, 3), nodes[0]: round(last - 0.5, 3)}
    return letters, ends, join, round(last, 3)


def listened(letters, ends, join_s, now_s, *, past="board", edge="heard", live="both ends", topics="static", boards="own",
             board="last", dead="gone"):  # fmt: skip
    """Return the children that a listener knows, step by step; other steps are the slips."""
    held, heard = {}, set()
    is_over = {node for node, ends_s in ends.items() if ends_s <= join_s}
    for letter in letters:
        if dead == "never heard" and ends.get(letter["node"], math.inf) <= now_s:
            continue
        sent_s, children = letter["sent_s"], set(letter["children"])
        is_after = sent_s >= join_s if edge == "heard" else sent_s > join_s
        if is_after or past == "everything":
            in_time = {"both ends": sent_s <= now_s, "after join": join_s < sent_s <= now_s, "before now": sent_s < now_s,
                       "forever": True}  # fmt: skip
            is_deaf = topics == "radio unheard" and letter["topic"] == "/tf"
            heard |= children if in_time[live] and past != "only" and not is_deaf else set()
        elif past in ("board", "only") and (letter["topic"] == "/tf_static" or topics in ("both", "each")):
            own = (letter["node"], letter["topic"]) if topics == "each" else letter["node"]
            if boards == "shared by the living" and letter["node"] in is_over:
                continue
            hook = own if boards == "own" else "one for all"
            before = held.get(hook, (None, set()))[1] if board == "all" else set()
            if board != "first" or hook not in held:
                held[hook] = (letter["node"], before | children)
    if dead == "heard forgotten":
        gone = [set(each["children"]) for each in letters if ends.get(each["node"], math.inf) <= now_s]
        heard -= {child for children in gone for child in children}
    for node, children in held.values():
        ends_s = ends.get(node, math.inf)
        if dead == "at the join" and ends_s == join_s:
            heard |= children
        if dead == "ends now" and ends_s == math.inf:
            ends_s = now_s
        if dead == "any end" and ends_s < math.inf:
            continue
        if dead == "none runs on" and ends_s == math.inf:
            continue
        if dead == "turned round" and ends_s >= join_s:
            continue
        ends_s = math.inf if dead == "turned round" else ends_s
        if dead == "read" or (ends_s > now_s if dead == "forgotten" else ends_s > join_s):
            heard |= children
    return sorted(heard)


JOIN_IS_BEFORE = WrongStep(
    "the join counts as before",
    {"edge": "before"},
    Text(
        en="What is sent at the very moment of the join you look for on the boards. It is heard, and the board of before is read as well.",
        ko="참가한 바로 그 시각에 보낸 것을 게시판에서 찾습니다. 그것은 듣게 되고, 그 전의 게시판도 따로 읽습니다.",
    ),
)

TF_LATCHED = WrongStep(
    "tf latched",
    {"topics": "both"},
    Text(
        en="Your listener finds the last letter of /tf on a board, too. /tf is a radio: what was sent before the join is gone.",
        ko="/tf의 마지막 쪽지도 게시판에서 읽습니다. /tf는 라디오입니다. 참가하기 전에 보낸 것은 지나갔습니다.",
    ),
    "M12",
)

TF_LATCHED_TOO = WrongStep(
    "tf latched too",
    {"topics": "each"},
    Text(
        en="Your nodes have a second board, for /tf. What was sent there before the join is gone.",
        ko="노드마다 /tf용 게시판이 하나 더 있습니다. /tf에서는 참가하기 전에 보낸 것이 남지 않습니다.",
    ),
    "M12",
)

ALL_KEPT = WrongStep(
    "all kept",
    {"board": "all"},
    Text(
        en="Your boards keep every letter. A board keeps the last one of its node; what hung there before is gone.",
        ko="게시판에 모든 쪽지가 남아 있습니다. 게시판에는 그 노드의 마지막 쪽지만 남고 이전 것은 사라집니다.",
    ),
    "M12",
)

ONE_BOARD = WrongStep(
    "one board",
    {"boards": "shared"},
    Text(
        en="You have one board for all nodes, and only the very last letter hangs there. Each node has a board of its own.",
        ko="모든 노드가 게시판 하나를 함께 쓰고 맨 마지막 쪽지만 남습니다. 게시판은 노드마다 따로 있습니다.",
    ),
    "M12",
)

ONE_BOARD_OF_THE_LIVING = WrongStep(
    "one board of the living",
    {"boards": "shared by the living"},
    Text(
        en="You have one board for all nodes that still run, and only the last of their letters hangs there. Each node has a board of its own, and its last letter stays though another node writes later.",
        ko="실행 중인 모든 노드가 게시판 하나를 함께 쓰고 맨 마지막 쪽지만 남습니다. 게시판은 노드마다 따로 있고, 다른 노드가 나중에 써도 그 노드의 마지막 쪽지는 남습니다.",
    ),
    "M12",
)

DEAD_READ = WrongStep(
    "dead boards read",
    {"dead": "read"},
    Text(
        en="Your listener reads boards of nodes that had ended before it joined. A board goes with its process.",
        ko="참가하기 전에 끝난 노드의 게시판까지 읽습니다. 게시판은 프로세스와 함께 사라집니다.",
    ),
    "M12",
)

DEAD_FORGOTTEN = WrongStep(
    "dead forgotten",
    {"dead": "forgotten"},
    Text(
        en="Your listener forgets what it read when the node ends later on. What was heard is kept.",
        ko="노드가 나중에 끝나면 이미 읽은 것까지 잊습니다. 받은 것은 그대로 압니다.",
    ),
    "M12",
)

VOLATILE = WrongStep(
    "volatile",
    {"past": "nothing"},
    Text(
        en="Your listener reads no board at all: only what is sent from the join on. tf2's listener asks for TRANSIENT_LOCAL on /tf_static.",
        ko="게시판을 전혀 읽지 않고 참가한 뒤에 보낸 것만 압니다. tf2의 수신기는 /tf_static에서 TRANSIENT_LOCAL을 요구합니다.",
    ),
    "M12",
)

HEARD_EVERYTHING = WrongStep(
    "heard everything",
    {"past": "everything"},
    Text(
        en="Your listener knows all that was ever sent, as if it had been there from the beginning.",
        ko="처음부터 와 있었던 것처럼, 보낸 것을 모두 압니다.",
    ),
    "M12",
)

JOIN_LEFT_OUT = WrongStep(
    "join left out",
    {"live": "after join"},
    Text(
        en="What is sent at the very moment of joining is heard, too: the bound belongs to it.",
        ko="참가하는 바로 그 시각에 보낸 것도 받습니다. 경계도 포함됩니다.",
    ),
)

NOW_LEFT_OUT = WrongStep(
    "now left out",
    {"live": "before now"},
    Text(
        en="What is sent at `now_s` itself is heard, too: the bound belongs to it.",
        ko="`now_s`에 보낸 것도 받습니다. 경계도 포함됩니다.",
    ),
)

BOARDS_ONLY = WrongStep(
    "boards only",
    {"past": "only"},
    Text(
        en="Your listener reads the boards, and then hears nothing any more. What is sent after the join arrives, too, on both topics.",
        ko="게시판만 읽고 그 뒤로는 아무것도 받지 않습니다. 참가한 뒤에 보낸 것도 두 토픽 모두에서 받습니다.",
    ),
    "M12",
)

THE_FUTURE = WrongStep(
    "the future",
    {"live": "forever"},
    Text(
        en="Your listener knows letters that are sent after `now_s`.",
        ko="`now_s` 이후에 보낼 쪽지까지 압니다.",
    ),
)


WHAT_THE_DEAD_SAID = WrongStep(
    "what the dead said",
    {"dead": "heard forgotten"},
    Text(
        en="Your listener forgets what a node said when the node ends. What was heard is kept.",
        ko="노드가 끝나면 그 노드가 한 말까지 잊습니다. 들은 것은 남습니다.",
    ),
    "M12",
)


THE_DEAD_UNHEARD = WrongStep(
    "the dead unheard",
    {"dead": "never heard"},
    Text(
        en="Whoever has ended by now is left out altogether: what you heard or read of it while it ran is kept.",
        ko="지금 이미 끝난 노드의 쪽지를 모두 빼놓았습니다. 살아 있을 때 듣거나 읽은 것은 그대로 압니다.",
    ),
    "M12",
)


ENDED_AT_THE_JOIN = WrongStep(
    "ended at the join",
    {"dead": "at the join"},
    Text(
        en="Your listener reads the board of a node that ends at the very moment of joining. Only those that end after it can still be read.",
        ko="합류하는 바로 그 순간에 끝나는 노드의 게시판을 읽습니다. 그 뒤에 끝나는 것만 읽을 수 있습니다.",
    ),
    "M12",
)


FIRST_LETTER = WrongStep(
    "first letter",
    {"board": "first"},
    Text(
        en="Your boards keep the first letter of their node. A later one takes its place: the last counts.",
        ko="게시판에 노드의 첫 쪽지가 남습니다. 나중 것이 그 자리를 차지하므로 마지막 것이 남습니다.",
    ),
    "M12",
)


RADIO_UNHEARD = WrongStep(
    "radio unheard",
    {"topics": "radio unheard"},
    Text(
        en="Your listener hears nothing of /tf. From the join on it listens to both topics.",
        ko="/tf를 전혀 듣지 않습니다. 합류한 뒤로는 두 토픽을 모두 듣습니다.",
    ),
    "M12",
)


WHO_RUNS_ON_HAS_NO_BOARD = WrongStep(
    "who runs on has no board",
    {"dead": "none runs on"},
    Text(
        en="A node that is not in `ends` still runs, and its board hangs there. Yours counts as ended.",
        ko="`ends`에 없는 노드는 아직 실행 중이고 게시판도 남아 있습니다. 끝난 것으로 보고 있습니다.",
    ),
)


ENDS_NOW = WrongStep(
    "ends now",
    {"dead": "ends now"},
    Text(
        en="A node that is not in `ends` has no end. You put `now_s` there: asked at the very moment of joining, it then counts as ended.",
        ko="`ends`에 없는 노드는 끝나지 않은 것입니다. 그 자리에 `now_s`를 넣으면, 참가하는 바로 그 시각에 물을 때 끝난 것으로 봅니다.",
    ),
)


def as_the_boards_hang_now(letters, ends, join_s, now_s, topics=("/tf", "/tf_static")):
    heard, boards = set(), {}
    for letter in letters:
        if letter["topic"] == "/tf_static" and letter["sent_s"] <= now_s:
            boards[letter["node"]] = letter["children"]
        elif letter["topic"] in topics and join_s <= letter["sent_s"] <= now_s:
            heard |= set(letter["children"])
    lasting = {child for node, held in boards.items() if ends.get(node, math.inf) > join_s for child in held}
    return sorted(heard | lasting)


def one_letter_of_each(letters, ends, join_s, now_s):
    """Return what is known if one keeps a single letter of each node: the board in place of what was heard."""
    kept, boards = {}, {}
    for letter in letters:
        if join_s <= letter["sent_s"] <= now_s:
            kept[letter["node"]] = letter["children"]
        elif letter["sent_s"] < join_s and letter["topic"] == "/tf_static":
            boards[letter["node"]] = letter["children"]
    kept |= {node: held for node, held in boards.items() if ends.get(node, math.inf) > join_s}
    return sorted({child for children in kept.values() for child in children})


BOARDS_OF_NOW = WrongAnswer(
    "boards of now",
    as_the_boards_hang_now,
    Text(
        en="You look at the boards as they hang at `now_s`. The listener reads them as it joins, and hears each later letter: what a later one covers stays known.",
        ko="게시판을 `now_s`의 모습으로 봅니다. 듣는 쪽은 들어올 때 게시판을 읽고 그 뒤의 쪽지는 하나씩 듣습니다. 나중 쪽지가 덮어도 이미 안 것은 남습니다.",
    ),
    "M12",
)


BOARDS_OF_NOW_ALONE = WrongAnswer(
    "boards of now alone",
    lambda letters, ends, join_s, now_s: as_the_boards_hang_now(letters, ends, join_s, now_s, topics=()),
    Text(
        en="You look at the boards alone, as they hang at `now_s`. The listener reads them as it joins, and from then on hears each letter of both topics.",
        ko="게시판만, 그것도 `now_s`의 모습으로 봅니다. 듣는 쪽은 들어올 때 게시판을 읽고, 그때부터 두 토픽의 쪽지를 하나씩 듣습니다.",
    ),
    "M12",
)


NAMES_OF_NODES = WrongAnswer(
    "names of nodes",
    lambda letters, ends, join_s, now_s: sorted(
        {each["node"] for each in letters if join_s <= each["sent_s"] <= now_s}
    ),
    Text(
        en="These are nodes. Asked for are the child frames that they speak of.",
        ko="노드의 이름입니다. 노드가 말한 자식 좌표계가 필요합니다.",
    ),
)


ANY_END = WrongStep(
    "any end",
    {"dead": "any end"},
    Text(
        en="You leave out the board of every node that ends some time. One that ends after the join still hangs there when your listener comes.",
        ko="언젠가 끝나는 노드의 게시판을 모두 뺐습니다. 들어온 뒤에 끝나는 노드의 게시판은 들어올 때 아직 걸려 있습니다.",
    ),
)


ENDED_FOR_RUNNING = WrongStep(
    "ended for running",
    {"dead": "turned round"},
    Text(
        en="You read just those boards that are gone: of the nodes that ended before the join. Those hang that end after it, or never.",
        ko="사라진 게시판만 읽습니다. 합류하기 전에 끝난 노드의 것입니다. 합류한 뒤에 끝나거나 끝나지 않은 노드의 게시판을 읽어야 합니다.",
    ),
    "M12",
)


ONE_LETTER_OF_EACH = WrongAnswer(
    "one letter of each",
    one_letter_of_each,
    Text(
        en="You keep a single letter of each node, the last that you put down. All that is heard stays known, and what hung on its board at the join as well: collect the children, not a letter for each node.",
        ko="노드마다 편지를 하나만, 마지막에 적은 것만 남깁니다. 받은 것은 모두 계속 알고, 합류할 때 게시판에 있던 것도 압니다. 노드마다 편지 하나가 아니라 자식을 모으십시오.",
    ),
    "M12",
)


TASK = Task(
    id="E6.7",
    kind="F",
    points=5,
    title=Text(en="Who knows what?", ko="누가 무엇을 알까요?"),
    answer="known",
    form=Set(Name(), once=True),
    inputs=logs,
    variants=3,
    model=listened,
    mistakes=(
        TF_LATCHED,
        TF_LATCHED_TOO,
        ALL_KEPT,
        ONE_BOARD,
        ONE_BOARD_OF_THE_LIVING,
        DEAD_READ,
        DEAD_FORGOTTEN,
        VOLATILE,
        HEARD_EVERYTHING,
        JOIN_LEFT_OUT,
        NOW_LEFT_OUT,
        BOARDS_ONLY,
        THE_FUTURE,
        WHAT_THE_DEAD_SAID,
        THE_DEAD_UNHEARD,
        ENDED_AT_THE_JOIN,
        FIRST_LETTER,
        RADIO_UNHEARD,
        WHO_RUNS_ON_HAS_NO_BOARD,
        ENDS_NOW,
        NAMES_OF_NODES,
        BOARDS_OF_NOW,
        BOARDS_OF_NOW_ALONE,
        JOIN_IS_BEFORE,
        ANY_END,
        ENDED_FOR_RUNNING,
        ONE_LETTER_OF_EACH,
    ),
    hints=(
        Text(
            en="Two ways to hear a letter: as it is sent, from the join until now; or from a board, at the join.",
            ko="쪽지를 받는 길은 둘입니다. 참가한 뒤부터 지금까지 보내는 대로 받거나, 참가할 때 게시판에서 읽습니다.",
        ),
        Text(
            en="For the boards go through what was sent on /tf_static before the join: a dict from node to children, written over by each letter.",
            ko="게시판은 참가하기 전에 /tf_static에 보낸 것을 차례로 보면 됩니다. 노드에서 children으로 가는 dict를 쪽지마다 덮어쓰십시오.",
        ),
        Text(
            en="A board counts if its node is not in `ends`, or ends later than `join_s`.",
            ko="노드가 `ends`에 없거나 `join_s`보다 늦게 끝나면 그 게시판을 읽을 수 있습니다.",
        ),
    ),
    equivalent={
        "sorted(heard) -> heard in: return sorted(heard)": "a set says the same as a sorted list",
        "each['sent_s'] < join_s -> each['sent_s'] <= join_s": "what is sent at the join has gone the other way",
    },
    misconceptions=("M12",),
)
