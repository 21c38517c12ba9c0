"""E6.7: Which frames does the listener know?"""

from __future__ import annotations

import math

from tflab.workbook.tasks import Name, Set, define_task

NODES = ("calibrator", "driver", "wheels", "arm", "lift", "robot1/mast")
PARTS = ("camera", "laser", "radar", "sonar", "imu", "gps")


def draw_logs(rng):
    """Draw logs in which each rule decides somewhere; some joins and ends coincide or nearly do."""
    rows = []
    for place, stay in enumerate((2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 0.0, 0.0, 0.01)):
        join = round(10.0 + float(rng.uniform(0.0, 4.0)), 2)
        rows.append(_log(rng, join, place, stay))
    first = {"node": "arm", "topic": "/tf_static", "sent_s": 0.0, "children": ["tool0"]}
    return [*rows, ([first], {"arm": 0.0}, 1.0, 2.0)]  # of simulated time: all of it at 0 s


def _log(rng, join, place, stay):
    """Draw messages before and after the join on both topics; publishers end before, at and after it."""
    names = [str(name) for name in rng.permutation(PARTS)]
    nodes = [str(node) for node in rng.permutation(NODES)]
    end = {0: join, 1: join + 0.01, 2: join - 0.01}[place % 3]
    last = join + stay
    on_the_edge = {0: join, 1: join - 0.01, 2: join + 0.01}[(place + 1) % 3]
    rows = [
        (nodes[5], "/tf_static", join - 7.0, ["robot1/mast", "robot1/beacon", "robot1/siren"]),
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
        *([(nodes[1], "/tf", last + 1.0, ["tool0"])] if place != 1 else []),  # there, the last is heard
        (nodes[0], "/tf_static", join + 0.7, [f"{names[0]}_4"]),  # heard, and its node ends before now
    ]
    if place % 2:
        rows.append((nodes[4], "/tf_static", join - 0.2, [f"{names[4]}_old"]))
    rows.sort(key=lambda row: row[2])
    letters = [
        {"node": node, "topic": topic, "sent_s": round(sent, 3), "children": children}
        for node, topic, sent, children in rows
    ]
    ends = {nodes[3]: round(end, 3), nodes[0]: round(last - 0.5, 3)}
    return letters, ends, join, round(last, 3)


def known_children(
    letters,
    ends,
    join_s,
    now_s,
    *,
    past="board",
    edge="heard",
    live="both ends",
    topics="static",
    boards="own",
    board="last",
    dead="gone",
):
    """Return the children that a listener knows, step by step; other arguments are mistakes."""
    held, heard = {}, set()
    is_over = {node for node, ends_s in ends.items() if ends_s <= join_s}
    for letter in letters:
        if dead == "never heard" and ends.get(letter["node"], math.inf) <= now_s:
            continue
        sent_s, children = letter["sent_s"], set(letter["children"])
        is_after = sent_s >= join_s if edge == "heard" else sent_s > join_s
        if is_after or past == "everything":
            in_time = {
                "both ends": sent_s <= now_s,
                "after join": join_s < sent_s <= now_s,
                "before now": sent_s < now_s,
                "forever": True,
            }
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


def latest_static(letters, ends, join_s, now_s, topics=("/tf", "/tf_static")):
    heard, boards = set(), {}
    for letter in letters:
        if letter["topic"] == "/tf_static" and letter["sent_s"] <= now_s:
            boards[letter["node"]] = letter["children"]
        elif letter["topic"] in topics and join_s <= letter["sent_s"] <= now_s:
            heard |= set(letter["children"])
    lasting = {child for node, held in boards.items() if ends.get(node, math.inf) > join_s for child in held}
    return sorted(heard | lasting)


def last_message_of_each(letters, ends, join_s, now_s):
    """Return what is known if a listener keeps one message of each node, the static one first."""
    kept, boards = {}, {}
    for letter in letters:
        if join_s <= letter["sent_s"] <= now_s:
            kept[letter["node"]] = letter["children"]
        elif letter["sent_s"] < join_s and letter["topic"] == "/tf_static":
            boards[letter["node"]] = letter["children"]
    kept |= {node: held for node, held in boards.items() if ends.get(node, math.inf) > join_s}
    return sorted({child for children in kept.values() for child in children})


ANSWERS = {
    "names of nodes": lambda letters, ends, join_s, now_s: sorted(
        {each["node"] for each in letters if join_s <= each["sent_s"] <= now_s}
    ),
    "boards of now": latest_static,
    "boards of now alone": lambda letters, ends, join_s, now_s: latest_static(letters, ends, join_s, now_s, topics=()),
    "one letter of each": last_message_of_each,
}

TASK = define_task(
    __file__,
    kind="F",
    points=5,
    answer="known",
    form=Set(Name(), once=True),
    inputs=draw_logs,
    variants=3,
    model=known_children,
    answers=ANSWERS,
)
