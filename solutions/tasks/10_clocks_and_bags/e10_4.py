"""E10.4: Which clock does a node get?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Sequence, define_task

NAMES = ("mapper", "detector", "planner", "camera", "localizer", "recorder", "driver", "watcher", "guard")
ABSENT = object()


def draw_launch_files(rng):
    """Draw parameter files for all nodes, for one, or both; as text, as a number, with and without a slash."""
    a, b, c, d = (NAMES[i] for i in rng.permutation(len(NAMES))[:4])
    nodes = [f"/{name}" for name in (a, b, c)]

    def file(**entries):
        return {key.replace("ALL", "/**"): {"ros__parameters": value} for key, value in entries.items()}

    def entry(name, value):
        return {name: {"ros__parameters": value}}

    sim, wall = {"use_sim_time": True}, {"use_sim_time": False}
    text, other_text, third_text = ({"use_sim_time": str(word)} for word in rng.permutation(["true", "True", "yes"]))
    number = {"use_sim_time": 1}
    return [
        (file(ALL=sim), nodes[:2]),
        ({**file(ALL=sim), **entry(f"/{b}", wall)}, nodes),
        ({**entry(f"/{a}", sim), **entry(c, sim)}, nodes),
        ({**file(ALL=text), **entry(f"/{c}", sim)}, nodes),
        ({**file(ALL=sim), **entry(b, {"rate": 10.0}), **entry(f"/{a}", other_text)}, nodes),
        ({**entry(f"/{c}", number), **file(ALL=wall), **entry(b, sim)}, nodes),
        ({**entry(a, wall), **file(ALL=sim)}, nodes),  # /** comes last in the file, and counts first all the same
        ({}, nodes[:2]),
        ({**file(ALL=sim), **entry(b, wall), **entry(f"/front/{c}", wall)}, [f"/front/{b}", f"/{c}", f"/{b}"]),
        ({**file(ALL={"rate": 5.0}), **entry(f"/{b}", {"use_sim_time": "false"})}, nodes),
        ({**file(ALL=wall), **entry(f"/{a}", third_text)}, nodes),
        (file(ALL={"use_gpu": True, "is_simulated": True}), nodes),  # neither is use_sim_time
        ({**entry(f"/{a}", {"rate": 10.0} | sim), **entry(b, {"use_sim_time": 0}), **entry(f"{c}_2", sim)}, nodes),
        (entry(f"/{d}", sim | {"rate": 5.0}), [*nodes, f"/{d}"]),
    ]


def find_clocks(params, nodes, everyone=True, own="its own", slash="either", text="refused", order="own last",
           unset="wall", lacking="everyone's", level="parameters"):  # fmt: skip
    """Return each node's clock, step by step; other arguments are mistakes."""
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
    """Return the entries that apply to a node, the strongest last."""
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
    """Return the last value that is set, or ABSENT."""
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


def hand_on(params, nodes):
    """Return the clocks if each node starts with the settings of the one before."""
    value = params.get("/**", {}).get("ros__parameters", {}).get("use_sim_time", False)
    found = []
    for node in nodes:
        own = params.get(node, params.get(node[1:], {})).get("ros__parameters", {})
        value = own.get("use_sim_time", value)
        found.append(("sim" if value else "wall") if isinstance(value, bool) else "refused")
    return found


def refuse_for_all(params, nodes):
    """Return the clocks if one invalid value stops every node."""
    general = params.get("/**", {}).get("ros__parameters", {}).get("use_sim_time", False)
    return find_clocks(params, nodes) if isinstance(general, bool) else ["refused" for _ in nodes]


ANSWERS = {
    "handed on": hand_on,
    "refused for all": refuse_for_all,
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="clock_of",
    form=Sequence(Choice(("sim", "wall", "refused"))),
    inputs=draw_launch_files,
    variants=4,
    model=find_clocks,
    answers=ANSWERS,
)
