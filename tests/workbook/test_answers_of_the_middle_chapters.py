"""What is said of whole answers in chapters 5 to 8: the reply that they mean, and none that is untrue of them."""

from __future__ import annotations

import pytest

from .whole_answers import slips_of, verdict_on

# -- chapter 8 ------------------------------------------------------------------------

BETWEEN = """
from tf2_ros import ExtrapolationException

def interpolate(stamp_s, before, after):
    (t0, x0, y0, a0), (t1, x1, y1, a1) = before, after
    if stamp_s < t0:
        raise ExtrapolationException("too early")
    if stamp_s > t1:
        raise ExtrapolationException("too late")
    u = (stamp_s - t0) / (t1 - t0)
    turn = a1 - a0
    if turn > math.pi:
        turn -= math.tau
    if turn < -math.pi:
        turn += math.tau
    return {"position": (x0 + u * (x1 - x0), y0 + u * (y1 - y0)), "yaw": a0 + u * turn}
"""
EARLY = '    if stamp_s < t0:\n        raise ExtrapolationException("too early")\n'
LATE = '    if stamp_s > t1:\n        raise ExtrapolationException("too late")\n'
ABOVE = "    if turn > math.pi:\n        turn -= math.tau\n"
BELOW = "    if turn < -math.pi:\n        turn += math.tau\n"


@pytest.mark.parametrize(
    ("changes", "slips"),
    [
        ({}, []),
        ({EARLY: ""}, ["guesses before"]),
        ({LATE: ""}, ["guesses after"]),
        ({EARLY: "", LATE: ""}, ["guesses outside"]),
        ({EARLY: "    stamp_s = max(stamp_s, t0)\n"}, ["stops at the first"]),
        ({LATE: "    stamp_s = min(stamp_s, t1)\n"}, ["stops at the second"]),
        ({"stamp_s < t0": "stamp_s <= t0"}, ["refuses at the first"]),
        ({"stamp_s > t1": "stamp_s >= t1"}, ["refuses at the second"]),
        ({"stamp_s > t1": "stamp_s >= t1", "stamp_s < t0": "stamp_s <= t0"}, ["refuses at a sample"]),
        (
            {EARLY: "    if t0 <= stamp_s <= t1:\n        raise ExtrapolationException()\n", LATE: ""},
            ["refuses inside"],
        ),
        ({ABOVE: ""}, ["long way from above"]),
        ({BELOW: ""}, ["long way from below"]),
        ({ABOVE: "", BELOW: ""}, ["the long way"]),
        ({"turn -= math.tau": "turn -= math.pi", "turn += math.tau": "turn += math.pi"}, ["what is left over of pi"]),
        ({"turn -= math.tau": "turn += math.tau", "turn += math.tau": "turn -= math.tau"}, ["turned too far"]),
        ({"turn = a1 - a0": "turn = (a1 - a0) % math.pi"}, ["modulo half a turn, to the left"]),
        ({"turn = a1 - a0": "turn = a0 - a1"}, ["yaw away"]),
        ({"(stamp_s - t0) / (t1 - t0)": "(stamp_s - t0) // (t1 - t0)"}, ["a whole ratio"]),
        ({"(stamp_s - t0) / (t1 - t0)": "stamp_s / (t1 - t0)"}, ["stamp by the gap"]),
        ({"(stamp_s - t0) / (t1 - t0)": "(stamp_s - t0) / t1"}, ["by the second stamp"]),
        ({"(stamp_s - t0) / (t1 - t0)": "stamp_s - t0 / (t1 - t0)"}, ["no brackets"]),
        ({"y0 + u * (y1 - y0)": "x0 + u * (x1 - x0)"}, ["y of x"]),
        ({"y0 + u * (y1 - y0)": "y0 + u * (x1 - x0)"}, ["y by x"]),
        ({"(t0, x0, y0, a0), (t1, x1, y1, a1)": "(t0, x0, a0, y0), (t1, x1, a1, y1)"}, ["yaw before y"]),
        ({"a0 + u * turn": "a1 - u * turn"}, ["yaw back from the later"]),
        ({"y0 + u * (y1 - y0)": "u * y0 + (1 - u) * y1"}, ["y from the other end"]),
        (
            {"x0 + u * (x1 - x0), y0 + u * (y1 - y0)": "u * x0 + (1 - u) * x1, u * y0 + (1 - u) * y1"},
            ["position from the other end"],
        ),
        ({"turn = a1 - a0": "turn = y1 - y0", "a0 + u * turn": "y0 + u * turn"}, ["yaw of y"]),
        ({"a0 + u * turn": "math.atan2(y1 - y0, x1 - x0)"}, ["yaw along the way"]),
        ({ABOVE: "", BELOW: "", "a0 + u * turn": "math.degrees(a0 + u * turn)"}, ["the long way", "unit degrees"]),
        ({"x0 + u * (x1 - x0), y0 + u * (y1 - y0)": "x0 + u * x1, y0 + u * y1"}, ["second position added"]),
        ({"x0 + u * (x1 - x0), y0 + u * (y1 - y0)": "u * x1, u * y1"}, ["share of the later position"]),
        ({LATE: "", ABOVE: "", BELOW: ""}, ["guesses after", "the long way"]),
        ({"u = (stamp_s - t0) / (t1 - t0)": "u = ((stamp_s - t0) / (t1 - t0)) ** 2"}, ["ratio squared"]),
        ({"a0 + u * turn": "a0 + u * u * turn"}, ["ratio squared"]),
        ({"u = (stamp_s - t0)": "u = 100 * (stamp_s - t0)"}, ["ratio in per cent"]),
        (
            {"x0 + u * (x1 - x0), y0": "x0 + (stamp_s - t0) * (x1 - x0), y0", " u * (y1": " (stamp_s - t0) * (y1"},
            ["seconds for a ratio"],
        ),
        ({"turn = a1 - a0": "turn = math.asin(math.sin(a1 - a0))"}, ["asin of the sine"]),
        ({"turn = a1 - a0": "turn = math.atan2(math.cos(a1 - a0), math.sin(a1 - a0))"}, ["atan2 exchanged"]),
        ({ABOVE: "", BELOW: "", "turn = a1 - a0": "turn = (a1 - a0 + math.pi) % math.tau"}, ["half a turn on"]),
        ({ABOVE: "", BELOW: "", "turn = a1 - a0": "turn = (a1 - a0) % math.tau - math.pi"}, ["half a turn back"]),
        ({"turn -= math.tau": "turn = math.pi", "turn += math.tau": "turn = -math.pi"}, ["cut off at pi"]),
        ({ABOVE: "    if abs(turn) > math.pi:\n        turn = -turn\n", BELOW: ""}, ["turned the other way"]),
        ({"turn -= math.tau": "turn = math.tau - turn"}, ["rest of the turn"]),
        ({"a0 + u * turn": "a0 + u * turn / 2"}, ["half the turn"]),
        ({"a0 + u * turn": "a1 + u * turn"}, ["yaw on from the second"]),
        ({"y0 + u * (y1 - y0)": "x0 + u * (y1 - y0)"}, ["y from x"]),
        ({"x0 + u * (x1 - x0)": "x0 + u * (x1 - y0)"}, ["x less y"]),
        ({"(t0, x0, y0, a0), (t1, x1, y1, a1)": "(t0, a0, x0, y0), (t1, a1, x1, y1)"}, ["yaw before x"]),
    ],
)
def test_between_two_samples(changes, slips):
    source = BETWEEN
    marks = {old: f"<{number}>" for number, old in enumerate(changes)}  # one may hold what another is replaced by
    for old, mark in marks.items():
        assert source.count(old) == 1
        source = source.replace(old, mark)
    for old, new in changes.items():
        source = source.replace(marks[old], new)
    assert slips_of("E8.2", source) == slips


ON_THE_MAP = """
from tf2_geometry_msgs import do_transform_point
from tf2_ros import TransformException

def point_to_map(buffer, message, now):
    stamp = message.header.stamp
    return do_transform_point(message, buffer.lookup_transform("map", {source}, {time}))
"""
OWN, AT = "message.header.frame_id", "Time.from_msg(stamp)"


@pytest.mark.parametrize(
    ("time", "what"),
    [
        ("Time(seconds=stamp.sec + stamp.nanosec)", "is its sec plus nanosec, taken for seconds, too."),
        ("Time(nanoseconds=stamp.sec)", "is the stamp's sec, taken for nanoseconds, without its nanosec."),
        ("Time(nanoseconds=stamp.nanosec)", "is the stamp's nanosec, with its sec left out"),
        ("Time(seconds=stamp.sec + stamp.nanosec * 1e-6)", "nanosec taken for millionths of a second."),
        ("Time(nanoseconds=stamp.sec * 10**6 + stamp.nanosec)", "is its nanosec, and sec taken for milliseconds."),
        ("Time(nanoseconds=now.nanoseconds - Time.from_msg(stamp).nanoseconds)", "to argument 3, and no moment."),
        ("Time(nanoseconds=now.nanoseconds + 10**9)", "is 1 s later than argument 3, in each call."),
        ("Time(nanoseconds=Time.from_msg(stamp).nanoseconds - 2 * 10**9)", "2 s earlier than the stamp, in each call."),
    ],
)
def test_whoever_is_always_refused_is_told_for_which_moment_the_buffer_was_asked(time, what):
    assert what in verdict_on("E8.3", ON_THE_MAP.format(source=OWN, time=time)).said.en


@pytest.mark.parametrize("result", ["message", "do_transform_point(message, transform) and message"])
def test_what_was_moved_and_not_kept_is_told_so(result):
    source = ON_THE_MAP.replace("return do_transform_point(message, buffer", "transform = buffer").rstrip().rstrip(")")
    source = source.format(source=OWN, time=AT) + f")\n    return {result}\n"
    assert slips_of("E8.3", source) == ["nothing moved"]


@pytest.mark.parametrize(
    ("refusal", "slip"), [("return None", "swallows the refusal"), ("stamp = now", "falls back on now")]
)
def test_a_fall_back_that_is_mostly_refused_is_told_all_the_same(refusal, slip):
    source = f"""
from tf2_geometry_msgs import do_transform_point
from tf2_ros import TransformException

def point_to_map(buffer, message, now):
    stamp, frame = message.header.stamp, message.header.frame_id
    try:
        buffer.lookup_transform("map", frame, stamp)
    except TransformException:
        {refusal}
    return do_transform_point(message, buffer.lookup_transform("map", frame, stamp))
"""
    assert slips_of("E8.3", source) == [slip]


@pytest.mark.parametrize(
    ("source", "time", "slips"),
    [
        (OWN, AT, []),
        ('"odom"', AT, ["from odom"]),
        ('"base_link"', AT, ["from base_link"]),
        (OWN, "Time(seconds=stamp.sec)", ["sec alone"]),
        (OWN, "Time()", ["latest"]),
        (OWN, "now if buffer.can_transform('map', message.header.frame_id, now) else Time()",
         ["now", "falls back on latest"]),
    ],
)  # fmt: skip
def test_a_point_onto_the_map(source, time, slips):
    assert slips_of("E8.3", ON_THE_MAP.format(source=source, time=time)) == slips


def test_a_point_left_in_odom_and_called_map_is_told_apart_from_one_that_says_odom():
    left = ON_THE_MAP.format(source=OWN, time=AT).replace('"map"', '"odom"')
    assert slips_of("E8.3", left) == ["left in odom"]
    called = left.replace("return do", "moved = do") + '    moved.header.frame_id = "map"\n    return moved\n'
    assert slips_of("E8.3", called) == ["odom called map"]


@pytest.mark.parametrize(
    ("of_map", "of_the_rest", "slip"),
    [
        ("now", AT, "map of now"),
        ("Time()", AT, "map of the latest"),
        (AT, "Time()", "robot of the latest"),
        (AT, "now", "robot of now"),
    ],
)
def test_two_moments_on_one_way_are_told_apart(of_map, of_the_rest, slip):
    lookup = f'"map", {of_map}, {OWN}, {of_the_rest}, "odom"'
    source = ON_THE_MAP.format(source=OWN, time=AT).replace(f'lookup_transform("map", {OWN}, {AT})',
                                                            f"lookup_transform_full({lookup})")  # fmt: skip
    assert slip in slips_of("E8.3", source)


@pytest.mark.parametrize(
    ("ending", "slip"),
    [("return None", "gives up on the old"), ("raise ExtrapolationException('old')", "refuses the old")],
)
def test_who_answers_young_messages_alone_is_told_so(ending, slip):
    is_old = "    if now - Time.from_msg(message.header.stamp) > Duration(seconds=0.35):\n"
    source = ON_THE_MAP.format(source=OWN, time=AT).replace("    stamp =", f"{is_old}        {ending}\n    stamp =")
    imports = "from rclpy.duration import Duration\nfrom tf2_ros import ExtrapolationException\n"
    assert slips_of("E8.3", imports + source) == [slip]


LATE_ERROR = """
delay_s = given.delay_ms / {delay}
forwards_m = given.speed_mps * delay_s
left_m = {left}
late_error = {{"forwards_m": forwards_m, "left_m": left_m, "together_m": {together}}}
"""
LEFT = "given.range_m * math.radians(given.yaw_rate_degps) * delay_s"


@pytest.mark.parametrize("variant", range(6))
def test_the_sum_of_two_numbers_with_their_signs_is_told_as_what_it_comes_to(variant):
    source = LATE_ERROR.format(delay=1000, left=LEFT, together="forwards_m + left_m")
    verdict = verdict_on("E8.4", source, variant)
    assert verdict.said.en.startswith('"together_m": That is the ') and "You took" not in verdict.said.en


@pytest.mark.parametrize(
    ("delay", "left", "slips"),
    [
        (1000, LEFT, []),
        (100, "given.range_m * given.yaw_rate_degps * delay_s", ["hundredths", "degrees"]),
        (1000, "given.range_m * math.sin(given.yaw_rate_degps * delay_s)", ["sine of degrees"]),
        (1000, "forwards_m * math.radians(given.yaw_rate_degps)", ["speed for the range"]),
        (1e6, LEFT, ["microseconds"]),
        (1e6, "given.range_m * given.yaw_rate_degps * delay_s", ["microseconds", "degrees"]),
        ("given.delay_ms", LEFT, ["no delay"]),
        (1000, "given.range_m * given.yaw_rate_degps / 360 * delay_s", ["turns"]),
        (1000, "(given.range_m - forwards_m) * math.radians(given.yaw_rate_degps) * delay_s", ["range left over"]),
    ],
)
def test_how_far_off(delay, left, slips):
    source = LATE_ERROR.format(delay=delay, left=left, together="math.hypot(forwards_m, left_m)")
    assert slips_of("E8.4", source) == slips


def test_a_length_of_parts_of_which_one_is_wrong_follows_and_is_no_mistake_of_its_own():
    left = "given.range_m * math.radians(given.yaw_rate_degps) * given.delay_ms"
    said = verdict_on("E8.4", LATE_ERROR.format(delay=1000, left=left, together="math.hypot(forwards_m, left_m)")).said
    assert (
        said.en == '"left_m": right, if it were in mm. "together_m": this only follows from what is wrong in "left_m".'
    )


CAUSES = """
causes = {"a": "stamp overwritten", "b": "static mount wrong", "c": "two clocks", "d": "cache too short",
          "e": "odometry slow", "f": "import missing"}
"""


@pytest.mark.parametrize("part", "bcdef")
def test_an_overwritten_stamp_is_not_said_to_show_only_while_the_robot_moves(part):
    said = verdict_on("E8.5", f'{CAUSES}\ncauses["{part}"] = "stamp overwritten"').said
    assert "only while the robot moves" not in said.en and "움직일 때만" not in said.ko


@pytest.mark.parametrize("variant", range(6))
@pytest.mark.parametrize(
    ("more", "slips"),
    [
        ("1 / min(rates)", []),
        ("sum(1 / rate for rate in rates) / 2", ["mean period"]),
        ("2 / sum(rates)", ["mean rate"]),
        ("1 / sum(rates)", ["sum of rates"]),
        ("1.0", ["1.0 s more"]),
        ("0.1", ["0.1 s more"]),
        ("0.1 * given.thinking_s", ["1.1 times the thinking time"]),
        ("1 / min(rates) + 0.1", []),
        ("max(rates)", ["fast rate instead of period"]),
        ("1 / max(rates)", ["the fast lane"]),
        ("2 / max(rates)", ["the fast lane", "two periods"]),
        ("1 / min(rates) - 1 / max(rates)", ["difference of periods"]),
        ("0 + math.ceil(given.thinking_s) - given.thinking_s", ["thinking rounded up"]),
        ("math.ceil(given.thinking_s * min(rates)) + 1 - given.thinking_s", ["count of min samples, and 1"]),
        ("given.thinking_s + 2 / min(rates)", ["twice all"]),
    ],
)
def test_how_long_it_must_remember(more, slips, variant):
    source = f"rates = given.rate_hz.values()\ncache_time_s = given.thinking_s + {more}"
    assert slips_of("E8.6", source, variant) == slips


def test_a_time_that_is_divided_by_a_rate_is_not_said_to_be_multiplied_alone():
    said = verdict_on("E8.6", "cache_time_s = given.thinking_s / min(given.rate_hz.values())").said.en
    assert "or divided by a rate, which is the same" in said


def test_a_duration_for_the_seconds_hears_what_is_wrong_with_them_too():
    source = """
from rclpy.duration import Duration
cache_time_s = Duration(seconds=given.thinking_s + 1 / max(given.rate_hz.values()))
"""
    assert slips_of("E8.6", source) == ["the fast lane", "no number"]


OBJECT_NOW = """
from tf2_geometry_msgs import do_transform_point

def object_now(buffer, message, now):
    seen = buffer.transform(message, "odom")
    point = do_transform_point(seen, buffer.lookup_transform({ends}, now)).point
    return (point.x, point.y, point.z)
"""


@pytest.mark.parametrize(
    ("ends", "slips"),
    [
        ('"base_link", "odom"', []),
        ('"odom", "base_link"', ["second step swapped"]),
        ('"base_link", "map"', ["second step from map"]),
        ("message.header.frame_id, 'odom'", ["in the sensor's frame"]),
    ],
)
def test_where_it_is_now(ends, slips):
    assert slips_of("E8.7", OBJECT_NOW.format(ends=ends)) == slips


# -- chapters 5 to 7 ------------------------------------------------------------------

FOOTPRINT = """
def footprint(odom_T_base):
    x, y, height = odom_T_base.translation
    (a, b, z, w), (roll, pitch, yaw) = odom_T_base.rotation, odom_T_base.rpy()
    return {{"x": {x}, "y": {y}, "yaw": {yaw}}}
"""


@pytest.mark.parametrize(
    ("x", "y", "yaw", "slips"),
    [
        ("x", "y", "yaw", []),
        ("x", "y", "abs(yaw)", ["size of yaw"]),
        ("x", "y", "-yaw", ["sign of yaw"]),
        ("x", "y", "math.copysign(2 * math.acos(w), z)", ["signed acos"]),
        ("x", "y", "math.atan2(2 * (w * z + a * b), 1 - 2 * z * z)", ["formula without y"]),
        ("x", "y", "math.atan2(2 * (w * z + a * b), 1 - 2 * (b * b + z * z))", []),
        ("x", "y", "w", ["w for yaw"]),
        ("x - height * math.tan(pitch)", "y + height * math.tan(roll)", "yaw", ["moved by the tangent"]),
        ("x * math.cos(yaw) - y * math.sin(yaw)", "x * math.sin(yaw) + y * math.cos(yaw)", "yaw", ["place turned"]),
    ],
)
def test_the_shadow_on_the_floor(x, y, yaw, slips):
    assert slips_of("E5.5", FOOTPRINT.format(x=x, y=y, yaw=yaw)) == slips


@pytest.mark.parametrize(
    ("wheels", "slips"),
    [
        ("odom_T_base.inverse()", []),
        ("Transform(odom_T_base.translation, odom_T_base.inverse().rotation)", ["turn back alone"]),
        ("Transform([-each for each in odom_T_base.translation], odom_T_base.rotation)", ["step negated"]),
    ],
)
def test_half_an_inverse_is_told_by_the_half_that_is_missing(wheels, slips):
    source = f"""
from tflab.core import Transform

def map_to_odom(map_T_base, odom_T_base):
    return map_T_base @ {wheels}
"""
    assert slips_of("E5.1", source) == slips


@pytest.mark.parametrize("variant", range(6))
@pytest.mark.parametrize(
    ("age", "slips"),
    [
        ("delay", ["delay only"]),
        ("delay / given.speed_mps", []),
        ("1 / given.rate_hz + delay / 2", ["half the delay"]),
        ("1 / given.rate_hz + 10 * delay", ["hundredths"]),
        ("0.5 / given.rate_hz + delay", ["half a period"]),
    ],
)
def test_how_far_a_bolt_falls_behind(age, slips, variant):
    source = f"delay = given.delay_ms / 1000\nworst_error_m = given.speed_mps * ({age})"
    assert slips_of("E6.6", source, variant) == slips


def test_a_height_by_the_cosine_is_no_meeting_of_two_other_mistakes():
    source = """
up = given.laser_above_base_link_m + given.base_link_above_floor_m
turn = math.radians(given.tilt_deg)
beam = {"floor_m": up / math.cos(turn), "wall_up_m": up - given.wall_m * math.tan(turn)}
"""
    assert slips_of("E7.2", source) == ["cosine"]


FORWARD = """
from tflab.core import Transform

def fk(chain, positions):
    pose = Transform()
    for joint in chain:
        at, about = positions.get(joint["name"], 0.0), {axis}
        movement = Transform()
        if joint["type"] == "revolute":
            movement = Transform.from_rpy(**{{dict(x="roll", y="pitch", z="yaw")[about]: {turn}}})
        if joint["type"] == "prismatic":
            movement = Transform([{slide} if letter == about else 0.0 for letter in "xyz"])
        pose = pose @ Transform.from_rpy(*joint["rpy"], translation=tuple(joint["xyz"])) @ movement
    return pose
"""


@pytest.mark.parametrize(
    ("axis", "turn", "slide", "slips"),
    [
        ('joint["axis"]', "at", "at", []),
        ("'x'", "at", "at", ["always about x"]),
        ("'y'", "at", "at", ["always about y"]),
        ('joint["axis"]', "-at", "at", ["turns the other way"]),
        ('joint["axis"]', "at", "-at", ["slides the other way"]),
        ('joint["axis"]', "-at", "-at", ["the other way"]),
        ('joint["axis"]', "0.0", "at", ["nothing turns"]),
        ('joint["axis"]', "at", "0.0", ["nothing slides"]),
    ],
)
def test_forward_kinematics(axis, turn, slide, slips):
    assert slips_of("E7.3", FORWARD.format(axis=axis, turn=turn, slide=slide)) == slips
