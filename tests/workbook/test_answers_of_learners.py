"""What is said of whole answers as learners write them: the reply that they mean, and none that is untrue of them."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from tflab.workbook import checks
from tflab.workbook.answers.values import to_plain

from .whole_answers import slips_of, task_of, verdict_on

# -- chapter 9 ------------------------------------------------------------------------

CLASSIFY = """
def classify(buffer, target, source, stamp):
    try:
        buffer.lookup_transform(target, source, stamp)
    except InvalidArgumentException:
        return "invalid argument"
    except LookupException:
        return "lookup"
    except ConnectivityException:
        return "connectivity"
    except ExtrapolationException as error:
        said = str(error)
        return "future" if "into the future" in said else "past" if "into the past" in said else "one sample"
    return "ok"
"""
UNCAUGHT = "    except {}:\n        return {}\n"


@pytest.mark.parametrize(
    ("old", "new", "slips"),
    [
        ('"into the ', '"in the ', ["no text is read"]),
        (UNCAUGHT.format("InvalidArgumentException", '"invalid argument"'), "", ["no branch for no question"]),
        ("except ExtrapolationException as error", "except KeyError as error", ["no branch for extrapolation"]),
        ("except ", "except KeyError or ", ["nothing is caught"]),
        (
            "    try:\n",
            '    if target.startswith("/") or source.startswith("/"):\n        return "invalid argument"\n    try:\n',
            ["ends swapped"],
        ),
        ('"invalid argument"', '"lookup"', ["no question is a wrong name"]),
        (
            "    try:\n",
            '    if target.startswith("/"):\n        return "lookup"\n    try:\n',
            ["a slash is a wrong name"],
        ),
    ],
)
def test_how_a_refusal_is_classified_wrongly_is_told(old, new, slips):
    assert old in CLASSIFY
    assert slips_of("E9.2", CLASSIFY) == []
    assert slips_of("E9.2", CLASSIFY.replace(old, new)) == slips


def test_whoever_looks_at_the_names_first_is_not_told_for_sure_that_they_are_turned_round():
    looked = CLASSIFY.replace("    try:\n", '    if source[:1] == "/":\n        return "invalid argument"\n    try:\n')
    assert "or check the names yourself?" in verdict_on("E9.2", looked).said.en


DECIDE = """
def decide(buffer, message):
    source, stamp = message.header.frame_id, Time.from_msg(message.header.stamp)
    try:
        buffer.lookup_transform("map", source, stamp)
        return "use"
    except LookupException:
        return "check names"
    except ConnectivityException:
        return "check tree"
    except InvalidArgumentException:
        return "fix message"
    except ExtrapolationException as error:
        if "into the future" not in str(error):
            return "drop"
        behind = stamp.nanoseconds - buffer.get_latest_common_time("map", source).nanoseconds
        return "wait" if behind <= 200_000_000 else "check clocks"
"""
BY_THE_GAP_ALONE = '        if "into the future" not in str(error):\n            return "drop"\n'


@pytest.mark.parametrize(
    ("changes", "slips"),
    [
        ({"200_000_000": "0.2"}, ["never waits"]),
        ({"200_000_000": "200"}, ["a limit in milliseconds"]),
        ({"200_000_000": "200_000"}, ["a limit in microseconds"]),
        ({"200_000_000": "1_000_000_000"}, ["a limit of a second"]),
        ({"200_000_000": "2_000_000_000"}, ["a limit of seconds"]),
        ({"200_000_000": "float('inf')"}, ["waits however far"]),
        ({"behind <=": "-behind <="}, ["waits however far"]),
        ({"behind <= 200_000_000": "round(behind / 1e6) <= 200"}, ["the limit is blunt"]),
        ({"behind <=": "behind >="}, ["comparison turned round"]),
        ({'time("map"': 'time("base_link"'}, ["gap from base_link"]),
        ({BY_THE_GAP_ALONE: ""}, ["direction unread"]),
        ({'"check tree"': '"check names"'}, ["no path is a wrong name"]),
        ({'"fix message"': '"check names"'}, ["no question is a wrong name"]),
        ({"except InvalidArgumentException": "except KeyError"}, ["no branch for no question"]),
        (
            {"    try:\n": '    if source[:1] == "/":\n        return "check names"\n    try:\n'},
            ["a slash is a wrong name"],
        ),
        (
            {"behind <= 200_000_000": "True", '"fix message"': '"check names"'},
            ["waits however far", "no question is a wrong name"],
        ),
        ({'time("map"': 'time("odom"', 'transform("map"': 'transform("odom"'}, ["odom throughout"]),
        (
            {'transform("map"': 'transform("odom"', '"fix message"': '"check names"'},
            ["wanted in odom", "no question is a wrong name"],
        ),
    ],
)
def test_why_a_decision_is_wrong_is_told_by_its_cause(changes, slips):
    source = DECIDE
    for old, new in changes.items():
        assert old in source
        source = source.replace(old, new)
    assert sorted(slips_of("E9.3", source)) == sorted(slips)


def test_that_no_branch_waits_for_the_past_is_said_without_calling_a_single_sample_old():
    waits = DECIDE.replace('return "drop"', 'return "wait"')
    verdict = verdict_on("E9.3", waits)
    assert list(verdict.slips) == ["waits for the past"]
    assert "older than everything" not in verdict.said.en


KEEP = """
def keep(stamps_s, now_s, max_age_s, max_size):
    good = sorted(s for s in stamps_s if 0 <= now_s - s <= max_age_s)
    kept = good[max(0, len(good) - max_size):]
    return {"kept": kept, "lost": len(stamps_s) - len(kept)}
"""


@pytest.mark.parametrize(
    ("test", "slips"),
    [
        ("abs(now_s - s) <= max_age_s", ["age by its size"]),
        ("now_s - s <= max_age_s", ["future kept"]),
        ("0 <= now_s - s and round(now_s - s, 1) <= max_age_s", ["ages rounded"]),
        ("0 <= round(now_s - s, 1) <= max_age_s", ["everything rounded"]),
        ("0 <= int(now_s - s) <= max_age_s", ["ages in whole seconds"]),
        ("s <= max_age_s", ["stamp for age"]),
        (
            "0 <= now_s - s and max([t for t in stamps_s if t <= now_s]) - s <= max_age_s",
            ["age by the newest of the past"],
        ),
        ("0 <= now_s - s <= max_age_s / 1000", ["age in milliseconds"]),
        ("0 <= s - now_s <= max_age_s", ["age turned round"]),
    ],
)
def test_what_a_queue_keeps_too_much_is_told(test, slips):
    assert slips_of("E9.5", KEEP.replace("0 <= now_s - s <= max_age_s", test)) == slips


def test_two_limits_that_are_left_out_are_both_named():
    both = KEEP.replace("0 <= now_s - s <= max_age_s", "0 < now_s - s < max_age_s")
    assert sorted(slips_of("E9.5", both)) == ["now is the future", "the limit is too old"]


DELAYS = """
causes, FAST, LATE, OPEN = {}, "laser clock is fast", "transforms arrive late", "cannot be told from this"
DO = {FAST: "set the laser's clock", LATE: "wait a little", OPEN: "ask chrony on both computers"}
for name in "abc":
    scan, odom = ([heard - stamp for stamp, heard in getattr(given, f"robot_{name}")[t]] for t in ("scan", "odom"))
    is_early, trembles = min(scan) < 0, max(odom) - min(odom) > 0.1
    causes[name] = %s
    causes[f"{name} do"] = DO[causes[name]]
"""


@pytest.mark.parametrize(
    ("cause", "name"),
    [
        ("OPEN", "always open"),
        ("OPEN if is_early or not trembles else LATE", "sign overlooked"),
        ("FAST if is_early else OPEN if trembles else LATE", "smooth and trembling exchanged"),
    ],
)
def test_what_a_delay_shows_is_told_to_whoever_leaves_it_open(cause, name):
    for variant in range(6):
        assert slips_of("E9.4", DELAYS % cause, variant) == [name]
    assert slips_of("E9.4", DELAYS % "FAST if is_early else LATE if trembles else OPEN") == []


def test_whoever_doubts_which_clock_is_wrong_is_led_to_the_other_topic():
    said = verdict_on("E9.4", DELAYS % "OPEN if is_early or not trembles else LATE").said
    assert "/odom" in said.en
    assert "/odom" in said.ko


def test_a_word_that_is_right_and_counts_nothing_is_told_where_it_is_said_everywhere():
    task = task_of("E9.4")
    one = dict.fromkeys("abc", "transforms arrive late") | {f"{name} do": "wait a little" for name in "abc"}
    two = one | {"a": "laser clock is fast", "a do": "set the laser's clock"}
    held = SimpleNamespace(cases=task, variant=task.variants[0])
    assert len(checks._said_too_often(held, [to_plain(one)])) == 2
    assert checks._said_too_often(held, [to_plain(two)]) == []


WAIT = """
sources = (given.localization, given.wheel_odometry)
period, late = {}
wait_s = max(period(s) + late(s) for s in sources) {} given.scan_delay_s
"""


@pytest.mark.parametrize("variant", range(5))
def test_a_wait_of_which_two_things_are_wrong_is_not_called_by_one_that_comes_near(variant):
    no_period = "lambda s: 0.0, lambda s: s['delay_s'] + s['jitter_s']"
    assert slips_of("E9.7", WAIT.format(no_period, "+"), variant) == ["period forgotten", "scan's delay added"]
    both = "lambda s: 1 / s['rate_hz'], lambda s: s['delay_s'] + s['jitter_s']"
    mean = WAIT.format(both, "-").replace("max(", "0.5 * sum(")
    assert slips_of("E9.7", mean, variant) == ["mean of the edges"]
    added = both.replace("1 / s['rate_hz']", "sum(1 / o['rate_hz'] for o in sources)")
    assert slips_of("E9.7", WAIT.format(added, "-"), variant) == ["periods added"]
    assert slips_of("E9.7", WAIT.format(both, "-"), variant) == []
    for margin in (" + 0.05", " + 0.1"):
        assert slips_of("E9.7", WAIT.format(both, "-").rstrip() + margin, variant) == []
    less = WAIT.format(both.replace("s['delay_s'] +", "-s['delay_s'] +"), "-")
    assert slips_of("E9.7", less.replace("for s in sources", "for s in sources[:1]"), variant) == ["delay taken off"]


WAITS = (
    "waits in vain",
    "works",
    "waits in vain",
    "works",
    "waits for ever",
    "waits in vain",
    "waits in vain",
    "works",
)


@pytest.mark.parametrize(
    ("lines", "part"),
    [("b", "executor with several threads"), ("h", "`spin_thread=True` does not depend"), ("bh", "a thread at once")],
)
def test_each_line_on_threads_has_its_own_reply(lines, part):
    answer = dict(zip("abcdefgh", WAITS, strict=True)) | dict.fromkeys(lines, "waits in vain")
    verdict = verdict_on("E9.6", f"outcomes = {answer!r}")
    assert part in verdict.said.en
    assert len(verdict.slips) == 1


# -- chapter 10 -----------------------------------------------------------------------

CLOCK_OF = """
def clock_of(params, nodes):
    words = []
    for node in nodes:
        value = False
        for key in ("/**", node.lstrip("/"), node):
            value = params.get(key, {}).get("ros__parameters", {}).get("use_sim_time", value)
        words.append("sim" if %s else "wall" if value is False else "refused")
    return words
"""


@pytest.mark.parametrize(
    ("test", "slips"),
    [
        ("value is True or value == 'true'", ["true in quotes"]),
        ("value in (True, 'true')", ["true in quotes, and 1"]),
        ("value is True", []),
    ],
)
def test_a_true_in_quotes_is_told_whatever_word_was_drawn(test, slips):
    for variant in range(4):
        assert slips_of("E10.4", CLOCK_OF % test, variant) == slips


def test_whoever_lets_the_general_entry_stand_for_all_hears_one_thing():
    general = CLOCK_OF % "value is True"
    old = '("/**", node.lstrip("/"), node)'
    assert old in general
    alone = general.replace(old, '(("/**",) if "/**" in params else (node.lstrip("/"), node))')
    assert slips_of("E10.4", alone) == ["everyone alone"]


@pytest.mark.parametrize(
    ("order", "name"),
    [((1, 0, 2), "now first"), ((1, 2, 0), "stamp last"), ((2, 1, 0), "backwards"), ((2, 0, 1), "timer first")],
)
def test_three_questions_in_another_order_are_one_mistake(order, name):
    source = (
        "outcomes = {}\n"
        "for letter, way in given.setups.items():\n"
        "    sim, clock = way['use_sim_time'], way['--clock']\n"
        "    row = ['works', 'just short', 'works'] if sim and clock else ['works', 'silently latest', 'never']\n"
        "    row = row if sim else ['works', 'years off', 'works']\n"
        f"    outcomes[letter] = [row[place] for place in {order}]\n"
    )
    assert slips_of("E10.1", source) == [name]


# -- chapter 11 -----------------------------------------------------------------------

READ_MONITOR = r"""
def read_monitor(report, static_frames):
    found = re.findall(r"Frame: (\S+), published by .*, Average Delay: (\S+), Max Delay: (\S+)", report)
    moving = [(name, float(avg), float(most)) for name, avg, most in found if name not in static_frames]
    late = max(moving, key=lambda row: row[2])[0]
    future = [name for name, avg, most in moving if avg < 0]
    delay_s = float(re.search(r"Net delay .*max = (\S+)", report).group(1))
    return {"late": late, "future": future, "delay_s": delay_s}
"""


@pytest.mark.parametrize(
    ("changes", "slips"),
    [
        ({r"Max Delay: (\S+)": r"Max Delay: ([\d.]+)", r"max = (\S+)": r"max = ([\d.]+)"}, ["exponents lost"]),
        ({r"Max Delay: (\S+)": r"Max Delay: ([\d.]+)"}, ["exponent lost of frames"]),
        ({r"max = (\S+)": r"max = ([\d.]+)"}, ["exponent lost"]),
        ({"float(most)": "most"}, ["compared as text"]),
        ({"if avg < 0": "if most <= 0"}, ["max for average"]),
        ({"if avg < 0": "if most == 0"}, ["max for average"]),
        ({"if avg < 0": "if avg <= 0"}, ["zero is future"]),
        ({"not in static_frames": "in static_frames"}, ["only statics"]),
    ],
)
def test_which_figure_of_a_report_was_read_and_how_is_told(changes, slips):
    source = READ_MONITOR
    for old, new in changes.items():
        assert old in source
        source = source.replace(old, new)
    assert slips_of("E11.6", source) == slips


TWO_READINGS = r"""
def read(text):
    sec, nanosec = re.search(r"At time (\d+)\.(\d+)", text).groups()
    x, y, z = map(float, re.search(r"Translation: \[(.*)\]", text).group(1).split(","))
    yaw = float(re.search(r"RPY \(degree\) \[.*, (.*)\]", text).group(1))
    return int(sec) + int(nanosec) / 1e9, x, y, yaw
t0, x0, y0, a0 = read(given.first)
t1, x1, y1, a1 = read(given.second)
turn = %s
motion = {"speed_mps": math.hypot(x1 - x0, y1 - y0) / (t1 - t0), "yaw_rate_radps": turn / (t1 - t0), "stamp_s": t1}
"""


def test_degrees_are_seen_even_if_turns_of_radians_were_taken_off():
    assert slips_of("E11.2", TWO_READINGS % "a1 - a0") == ["degrees"]
    assert slips_of("E11.2", TWO_READINGS % "math.remainder(a1 - a0, math.tau)") == ["degrees wrapped"]
    assert slips_of("E11.2", TWO_READINGS % "math.radians(a1 - a0)") == []


OFTEN_ENOUGH = """
hz = given.hz_of_tf - sum(given.sends_hz.values())
v, w = given.speed_mps, given.yaw_rate_radps
off_mm = 1000 * v / w * (1 - math.cos(%s(w / (2 * hz))))
verdict = {
    "odometry_hz": hz,
    "late_s": float(re.search(r"max = (\\S+)", given.report)[1]),
    "off_mm": off_mm,
    "wait_s": max(0.0, 1 / hz + given.transform_travels_s - given.scan_travels_s),
    "enough": "yes" if off_mm <= given.allowed_mm else "no",
}
"""


def test_an_angle_that_was_turned_into_another_unit_is_told():
    assert "already in radians" in verdict_on("E11.3", OFTEN_ENOUGH % "math.radians").said.en
    assert slips_of("E11.3", OFTEN_ENOUGH % "math.degrees")[:1] == ["angle in degrees"]
    assert slips_of("E11.3", OFTEN_ENOUGH % "") == []


# -- chapter 12 -----------------------------------------------------------------------

FIRST = {
    "no frame map": "node list",
    "odom stands alone": "publish_tf",
    "robot to and fro": "echo odom base_footprint",
    "scan beside the walls": "echo base_link laser_frame",
    "walls smear in bends": "delay /scan",
    "into the future": "delay /scan",
    "localizer silent": "use_sim_time",
    "unknown frame": "scan header",
    "static late joiner": "info /tf_static",
    "slow robot": "hz /odom",
}


@pytest.mark.parametrize(
    ("symptom", "check", "said", "not_said"),
    [
        ("slow robot", "monitor", "tell these two apart, but it takes 4 minutes", "alone"),
        ("no frame map", "monitor", "It receives transforms for four minutes", "tell these two apart, but"),
        ("unknown frame", "hz /scan", "says the same whichever of these two it is", "tell these two apart, but"),
        ("slow robot", "other cable", "a cable is neither of the two suspects", "data flows"),
    ],
)
def test_why_a_check_does_not_do_is_told_as_it_is(symptom, check, said, not_said):
    reply = verdict_on("E12.3", f"first = {FIRST | {symptom: check}!r}").said.en
    assert said in reply
    assert not_said not in reply


def test_one_card_out_of_its_place_is_told_as_one():
    places = ("first", "second", "third", "fourth", "fifth", "sixth")
    cards = ("header", "fixed frame", "tree", "mount", "rates", "publishers")
    verdict = verdict_on("E12.6", f"steps = {dict(zip(places, cards, strict=True))!r}")
    assert list(verdict.slips) == ["one out of place"]
    assert '"header" alone is out of its place, and comes later' in verdict.said.en
    assert '"header" 하나만 제자리가 아니며' in verdict.said.ko


TRIAGE = """
def triage(patient):
    seen = patient.ask("rviz")
    if "not listed" in seen:
        clock = patient.ask("use_sim_time")
        return patient.verdict("localizer waits for /clock" if clock == "True" else "localizer not running", "odom")
    if "Fixed Frame" in seen:
        return patient.verdict("Fixed Frame misspelt", "map")
    if "foreign" in seen:
        return patient.verdict("parent misspelt", "base_footprint")
    if "no transform from" in seen:
        said = patient.ask("publish_tf")
        cause = {"True": "localizer owns the base", "False": "publish_tf off"}.get(said, "odometry not running")
        return patient.verdict(cause, "base_footprint")
    if "future" in seen:
        hz = patient.ask("hz /odom").split()
        if float(hz[0]) < 10:
            return patient.verdict("odometry slow", "base_footprint")
        if float(hz[-2]) > 0.02:
            return patient.verdict("transforms late", "all that move")
        return patient.verdict("laser clock ahead", "laser_frame")
    if "unknown" in seen and "[laser_frame]" not in seen:
        return patient.verdict("header says another frame", "laser_frame")
    if "unknown" in seen:
        log = patient.ask("echo base_link laser_frame")
        cause = "quaternion of zeros" if "DENORMALIZED" in log else "mount volatile"
        return patient.verdict(cause, "laser_frame")
    if "ekf_filter_node" in patient.ask("node list"):
        return patient.verdict("two owners of one edge", "base_footprint")
    if patient.ask("echo base_link laser_frame") != "0.200, 0.000, 0.150":
        return patient.verdict("mount wrong", "laser_frame")
    if patient.ask("scan header") == "base_link":
        return patient.verdict("header says base_link", "laser_frame")
    if float(patient.ask("delay /scan").split()[0]) > 0.2:
        return patient.verdict("laser clock behind", "laser_frame")
    return patient.verdict("nothing is wrong", "none")
"""
A_DELAY, ITS_NUMBER = 'float(patient.ask("delay /scan").split()[0]) > 0.2', 'patient.ask("delay /scan") == "0.505 s"'


@pytest.mark.parametrize(
    ("changes", "slips"),
    [
        ({}, []),
        ({A_DELAY: ITS_NUMBER}, ["delay misread"]),
        ({'"Fixed Frame misspelt", "map"': '"Fixed Frame misspelt", "none"'}, ["no frame for a name"]),
        ({'clock == "True"': "bool(clock)"}, ["always waits for /clock"]),
        (
            {
                '"transforms late", "all that move"': '"transforms late", "laser_frame"',
                '"odometry slow", "base_footprint"': '"odometry slow", "laser_frame"',
                '"Fixed Frame misspelt", "map"': '"Fixed Frame misspelt", "none"',
            },
            ["the laser's frame for the future", "no frame for a name"],
        ),
    ],
)
def test_what_a_program_on_its_rounds_overlooks_is_told(changes, slips):
    source = TRIAGE
    for old, new in changes.items():
        assert old in source
        source = source.replace(old, new)
    assert [name for name in slips_of("E12.7", source) if name != "proof: no proof"] == slips


def test_of_a_cause_that_never_comes_it_is_told_where_it_shows():
    never = TRIAGE.replace("float(hz[-2]) > 0.02", "False").replace(A_DELAY, ITS_NUMBER)
    said = verdict_on("E12.7", never).said
    assert "std dev" in said.en
    assert "std dev" in said.ko


def test_a_word_where_a_whole_verdict_is_asked_for_is_told_what_it_lacks():
    alone = TRIAGE.replace('return patient.verdict("nothing is wrong", "none")', 'return "nothing is wrong"')
    assert verdict_on("E12.7", alone).detail["tip"].en.startswith('That is the word for "cause" alone')


def test_a_list_on_which_all_is_healthy_hears_that_beside_what_it_does_not_tell_apart():
    form = task_of("E12.4").form.parts["a checks"]
    said = form.remark(["node list"], {"a cause": "localizer waits for /clock"})
    assert "something sick" in said.en
    assert "Fixed Frame misspelt" in said.en
    assert "something sick" not in form.remark(["rviz"], {"a cause": "localizer waits for /clock"}).en
    assert "something sick" not in form.remark([], {"a cause": "nothing is wrong"}).en


def test_the_refusal_of_the_oldest_stamp_is_not_called_the_last():
    def placeable(buffer, messages, target):
        noes = []
        for message in sorted(messages, key=lambda each: (each.header.stamp.sec, each.header.stamp.nanosec)):
            try:
                buffer.lookup_transform(target, message.header.frame_id, message.header.stamp)
            except Exception as error:
                noes.append(type(error).__name__)
        return {"placed": len(messages) - len(noes), "first_no": (noes or ["none"])[0]}

    assert slips_of("E10.6", placeable) == ["first by stamp"]
