"""Each form names the mistakes that it recognises: each is named where it was made, and nowhere else."""

from __future__ import annotations

import json
import math
import random
from itertools import combinations, permutations, product

import pytest

from tflab.workbook.answers.form import Form
from tflab.workbook.answers.forms import Angle, Message, Name, Number, Parts, Quaternion, Sequence, Tree, Vector
from tflab.workbook.answers.values import is_raised, to_plain
from tflab.workbook.diagnosis.explain import TABLE, read_conditions
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.matching import RECOGNISERS
from tflab.workbook.diagnosis.parts import PARTS
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.diagnosis.wrong_types import TYPES

from .each_task import READS, cases_of, each_task
from .test_explain import judged


def turned(q, share):
    """Return a rotation that goes so many times as far."""
    sine, angle = math.hypot(*q[:3]), share * math.atan2(math.hypot(*q[:3]), q[3])
    return (*(part / sine * math.sin(angle) for part in q[:3]), math.cos(angle))


def scaled(factor, row):
    return tuple(factor * x for x in row)


def one_sign(row):
    return [tuple(-x if at == place else x for at, x in enumerate(row)) for place in range(3)]


MADE = {
    Number("m"): {
        "unit": lambda n: [1e3 * n, 1e2 * n, 1e-3 * n],
        "sign": lambda n: [-n],
        "one over it": lambda n: [1 / n],
        "twice": lambda n: [2 * n],
        "half": lambda n: [n / 2],
        "squared": lambda n: [n * n],
        "root": lambda n: [math.sqrt(abs(n))],
        "power of ten": lambda n: [n * 10.0**power for power in range(-9, 10)],
    },
    Angle(): {
        "unit": lambda a: [math.degrees(a)],
        "sign": lambda a: [-a],
        "half a turn": lambda a: [a + math.pi, a - math.pi],
        "z for the angle": lambda a: [math.sin(a / 2)],
        "twice": lambda a: [2 * a],
        "half the angle": lambda a: [a / 2],
    },
    Vector(3): {
        "unit": lambda v: [scaled(factor, v) for factor in (1e3, 1e2, 1e-3)],
        "all signs": lambda v: [scaled(-1, v)],
        "exchanged": lambda v: list(permutations(v)),
        "one sign": one_sign,
        "places and signs": lambda v: [
            (a * x, b * y, c * z) for x, y, z in permutations(v) for a, b, c in product((1, -1), repeat=3)
        ],
        "twice": lambda v: [scaled(2, v)],
        "half": lambda v: [scaled(0.5, v)],
        "power of ten": lambda v: [scaled(10.0**power, v) for power in range(-9, 10)],
    },
    Quaternion(): {
        "w first": lambda q: [(q[3], *q[:3])],
        "w taken first": lambda q: [(*q[1:], q[0])],
        "inverse rotation": lambda q: [(-q[0], -q[1], -q[2], q[3])],
        "not normalised": lambda q: [scaled(1.7, q), scaled(0.4, q)],
        "whole angle": lambda q: [turned(q, 2.0)],
        "half angle": lambda q: [turned(q, 0.5)],
        "one sign": one_sign,
        "exchanged": lambda v: list(permutations(v)),
        "w left at 1": lambda q: [(*q[:3], 1.0), (-q[0], -q[1], -q[2], 1.0)],
    },
    Name(): {
        "other case": lambda name: [name.upper(), name.title()],
        "slash in front": lambda name: ["/" + name],
        "space around": lambda name: [name + " ", " " + name],
        "other separator": lambda name: [name.replace("/", "_"), name.replace("/", ".")],
    },
    Sequence(Name()): {
        "other order": lambda row: [row[::-1]],
        "unsorted": lambda row: list(map(list, permutations(row))),
        "members missing": lambda row: [list(some) for n in range(1, len(row)) for some in combinations(row, n)],
        "members twice": lambda row: [[*row[:at], one, *row[at:]] for at in range(1, 5) for one in row[:at]],
    },
    Tree(): {
        "tree: not whole": lambda tree: [dict(some) for n in (1, 2, 3) for some in combinations(tree.items(), n)],
        "tree: more than asked for": lambda tree: [tree | {"lamp": parent} for parent in tree],
        "tree: no such parent": lambda tree: [tree | {child: "hall"} for child in tree],
    },
}


def right_one(form, draws):
    if not form.is_measured:
        names = sorted(draws.sample("abcdefgh", 4))
        tree = {name: draws.choice(["map", *names[:at]]) for at, name in enumerate(names)}
        return {Name: f"r{draws.randrange(99)}/odom", Sequence: names, Tree: tree}[type(form)]
    row = [draws.uniform(0.3, 2.9) for _ in range(getattr(form, "size", 4 if isinstance(form, Quaternion) else 1))]
    length = math.hypot(*row) if isinstance(form, Quaternion) else 1.0
    return tuple(x / length for x in row) if len(row) > 1 else row[0]


def is_near(form, answer, other):
    if not form.is_measured:
        return answer == other
    one, two = (form.numbers(to_plain(value)) for value in (answer, other))
    near = min(math.dist(one, [sign * x for x in two]) for sign in ((1, -1) if isinstance(form, Quaternion) else (1,)))
    if isinstance(form, Angle):
        near = min(near, abs(math.remainder(one[0] - two[0], math.tau)))
    return near <= 2e-3 * math.hypot(*one) + 1e-9


def wrong_ones(form, right, draws):
    """Return answers with one mistake, with two, and with another number."""
    made = [(kind, answer) for kind, make in MADE[form].items() for answer in make(right)]
    pairs = [(one, make) for kind, one in made for then, make in MADE[form].items() if then != kind]
    twice = [answer for one, make in pairs for answer in make(one)[:2]]
    others = [right_one(form, draws) for _ in range(40)]
    return [answer for _, answer in made] + draws.sample(twice, min(80, len(twice))) + others


@pytest.mark.parametrize("form", MADE, ids=lambda form: type(form).__name__)
def test_no_answer_gets_an_explanation_whose_condition_is_false(form):
    draws, named = random.Random(7), set()
    for _ in range(4):
        right = right_one(form, draws)
        assert judged(form, right, {}, right).failure is None
        for answer in wrong_ones(form, right, draws):
            for name in judged(form, right, {}, answer).mistakes:
                named.add(kind := "unit" if name.startswith("unit ") else name)
                made = MADE[form][kind](right) if kind in MADE[form] else [answer]
                assert any(is_near(form, answer, one) for one in made), (right, answer, name)
    assert named >= MADE[form].keys()


def all_forms(of=Form):
    return [of, *(form for one in of.__subclasses__() for form in all_forms(one))]


def test_each_explanation_and_each_mistake_of_a_form_has_its_condition():
    names = {name for form in all_forms() for name in form.mistakes}
    assert names == RECOGNISERS.keys() | TYPES.keys()
    several = {"parts that changed places", "mistakes in parts"}
    assert read_conditions().keys() == names | several | {row.name for row in (*TABLE, *PARTS)}


OF_TASKS = {
    Number: ("sign", "twice"),
    Angle: ("sign", "half a turn", "half the angle"),
    Vector: ("one sign", "twice", "all signs"),
    Quaternion: ("half angle", "whole angle", "w left at 1", "inverse rotation"),
    Name: ("slash in front", "other case"),
}
SAID = {Failure.KNOWN, Failure.UNIT, Failure.ECHO, Failure.CONSTANT, None}


def with_part(plain, path, value):
    """Return an answer in which one part, or one field of a message, holds another value."""
    if not path:
        return value
    kind = "dict" if "dict" in plain else "message"
    held = plain[kind] if kind == "dict" else plain[kind][1]
    name, *rest = [path] if kind == "dict" else path.split(".")
    if kind == "message" and not rest and isinstance(value, dict):
        value = {"message": [held[name]["message"][0], dict(zip("xyzw", value["tuple"], strict=False))]}
    changed = held | {name: with_part(held[name], ".".join(rest), value) if rest else value}
    return {kind: changed if kind == "dict" else [plain[kind][0], changed]}


@pytest.mark.proof(reads=READS)
@each_task
def test_in_each_task_a_mistake_that_a_form_recognises_is_named(stem, file):
    task = cases_of(stem, file, 1)
    expected = [case.expected for case in task.variants[0].cases]
    made = {type(form): makes for form, makes in MADE.items()}
    first = next(want for want in expected if not is_raised(want))
    parts = task.form.forms_of_parts(first) if isinstance(task.form, Parts | Message) else {"": task.form}
    for path, form in parts.items():
        of_part = [value_in(task.form.part_of(want, path) if path else want, form) for want in expected]
        for kind in OF_TASKS.get(type(form), ()) if getattr(form, "unit", "-") and None not in of_part else ():
            values = [made[type(form)][kind](value)[0] for value in of_part]
            pairs = zip(expected, values, strict=True)
            wrong = [want if is_raised(want) else with_part(want, path, to_plain(value)) for want, value in pairs]
            verdict = judge_outcomes(task, task.variants[0], [json.loads(json.dumps(plain)) for plain in wrong])
            is_short = len(expected) == 1 and form.is_short(to_plain(values[0]))
            assert verdict.failure in SAID or is_short, (path, kind, verdict)


def value_in(plain, form):
    """Return a number, a row of numbers or a name of an answer, or something of the form where it raises."""
    if is_raised(plain) or (isinstance(form, Name) and isinstance(plain, str)):
        return right_one(form, random.Random(7)) if is_raised(plain) else plain
    row = form.numbers(plain)
    if isinstance(form, Angle) and row:
        return math.remainder(row[0], math.tau)
    return row[0] if row and len(row) == 1 else row
