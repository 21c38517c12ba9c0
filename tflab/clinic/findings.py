"""Reduce a tool's output to one line with its numbers and names (a finding), and classify it.

    "average delay: -0.295 ..."                 --read-->  "-0.295 s"
    "... roots map and odm, 3 pages of yaml"    --read-->  "roots: map, odm; base_footprint 20.2 Hz; odom 10.2 Hz"

And each finding has a kind, which is what tells suspects apart: "-0.295 s" is
"ahead", "0.105 s" is as on the card.  Medicine calls the first a sign and the
second its interpretation.
"""

from __future__ import annotations

import itertools
import math
import re

import yaml

__all__ = ["AS_ON_THE_CARD", "CARD_FRAMES", "CARD_NODES", "READERS", "kind_of"]

AS_ON_THE_CARD = "as on the card"
CARD_NODES = (
    "joint_driver", "laser_driver", "laser_mount", "localization", "map_server", "robot_state_publisher",
    "wheel_odometry",
)  # fmt: skip
CARD_FRAMES = (
    "base_footprint", "base_link", "camera_link", "camera_optical_frame", "elbow", "imu_link", "laser_frame",
    "left_wheel", "map", "odom", "right_wheel", "shoulder", "tcp", "tool0", "wrist",
)  # fmt: skip
NOTHING = "nothing heard"
UNKNOWN, APART, COMES_AND_GOES, ABORTED = "unknown", "not in one tree", "comes and goes", "answers, then aborts"
DENORMALIZED, INCOMPATIBLE = "TF_DENORMALIZED_QUATERNION", "incompatible QoS"


# -- from a text to a finding ---------------------------------------------


def rviz(text: str) -> str:
    """Read RViz's list: what is not Ok, and every frame that it knows and the card does not."""
    fixed = re.search(r"Frame \[(.+?)\] does not exist", text.split("TF:")[0])
    frames = re.findall(r"^  (\w+): (?:Transform OK|No transform from \[\w+\] to frame)", text, re.MULTILINE)
    foreign = sorted(set(frames) - set(CARD_FRAMES))
    lost = re.findall(r"^  (\w+): No transform from \[\w+\] to frame", text, re.MULTILINE)
    scan = re.search(r"LaserScan.*?Transform: (.+)", text, re.DOTALL)
    said = [f"Fixed Frame [{fixed[1]}] unknown, map {'' if 'map' in frames else 'not '}listed"] if fixed else []
    said += [f"foreign frames: {', '.join(foreign)}"] if foreign else []
    said += ["no transform from base_footprint"] if "base_footprint" in lost and not fixed else []
    if scan and not fixed and "base_footprint" not in lost and scan[1].strip() != "Ok":
        unknown = re.search(r"For frame \[.+?\]: Frame \[(.+?)\]", scan[1])
        said += [f"scan's frame [{unknown[1]}] unknown" if unknown else _error(scan[1])]
    return "; ".join(said) or "all Ok"


def node_list(text: str) -> str:
    """Read which nodes run."""
    return " ".join(name for name in text.replace("/", "").split() if name)


def view_frames(text: str) -> str:
    """Read the roots, and how often the two moving edges came."""
    answer = re.search(r'frame_yaml="(.*?)"\)', text, re.DOTALL)
    frames = yaml.safe_load(answer[1].replace("\\n", "\n")) if answer else {}
    roots = sorted({frame["parent"] for frame in frames.values()} - set(frames))
    said = [f"roots: {', '.join(roots)}"]
    said += [f"{name} {frames[name]['rate']:.1f} Hz" for name in ("odom", "base_footprint") if name in frames]
    said += [] if "laser_frame" in frames else ["no laser_frame"]
    return "; ".join(said + _log(text))


def publishers(text: str) -> str:
    """Read who publishes a topic, and with which durability."""
    ends = re.findall(r"Node name: (\w+).*?Endpoint type: PUBLISHER.*?Durability: (\w+)", text, re.DOTALL)
    return ", ".join(f"{node} {durability}" for node, durability in ends if "transform_listener" not in node)


def connection(text: str) -> str:
    """Read whether tf2_echo had an answer, and whether it kept it."""
    at = re.findall(r"At time ", text)
    last = re.findall(r"(?:Waiting for transform .*?: |Exception thrown:)(.+)", text)
    fault = _error(last[-1]) if last else ""
    is_kept = "Failure" not in text or fault != APART
    said = ("answers" if is_kept else COMES_AND_GOES) if at else fault
    return "; ".join([said, *_log(text)])


def wheels(text: str) -> str:
    """Read how odom -> base_footprint moves at 20 Hz: smoothly, to and fro, seldom, or not at all."""
    said = connection(text)
    if said != "answers":
        return said
    rows = re.findall(r"At time (\d+)\.(\d+)\n- Translation: \[(.+?)\]", text)
    samples = {int(sec) * 10**9 + int(nanosec): tuple(map(float, xyz.split(","))) for sec, nanosec, xyz in rows}
    steps = [(b - a) * 1e-9 for a, b in itertools.pairwise(sorted(samples))]
    apart_m = max((_kink(*three) for three in _threes([samples[at] for at in sorted(samples)])), default=0.0)
    often = sorted(steps)[len(steps) // 2] if steps else math.inf
    if often > 0.3:
        return "a new pose every 0.3 s or less often"
    return f"to and fro, {apart_m:.2f} m apart" if apart_m > 0.1 else "smooth"


def mount(text: str) -> str:
    """Read where the laser is on the robot."""
    found = re.search(r"- Translation: \[(.+?)\]", text)
    return "; ".join([found[1] if found else connection(text).split(";")[0], *_log(text)])


def correction(text: str) -> str:
    """Read by how much map -> odom steps."""
    said = connection(text)
    if said != "answers":
        return said
    rows = [tuple(map(float, xyz.split(","))) for xyz in re.findall(r"- Translation: \[(.+?)\]", text)]
    return f"steps of up to {max(map(math.dist, rows, rows[1:]), default=0.0):.2f} m"


def monitor(text: str) -> str:
    """Read the mean delay of the two moving edges, or that the tool died of a chain that broke."""
    if "terminate called" in text:
        return ABORTED
    delays = re.findall(r"Frame: (odom|base_footprint), published by .*?Average Delay: ([-\d.e+]+)", text)
    if not delays:
        return connection(text)
    rate = re.search(r"Node: .*? ([\d.e+]+) Hz", text)
    return "; ".join([*(f"{name} {float(delay):.3f} s" for name, delay in delays), f"{float(rate[1]):.1f} Hz in all"])


def rate(text: str) -> str:
    """Read the last rate, and how it spreads."""
    found = re.findall(r"average rate: ([\d.]+)\n.*?std dev: ([\d.]+)s", text)
    return f"{float(found[-1][0]):.1f} Hz, std dev {float(found[-1][1]):.3f} s" if found else NOTHING


def delay(text: str) -> str:
    """Read the last mean delay, and how it spreads."""
    found = re.findall(r"average delay: (-?[\d.]+)\n.*?std dev: ([\d.]+)s", text)
    return f"{found[-1][0]} s, std dev {float(found[-1][1]):.3f} s" if found else NOTHING


def header(text: str) -> str:
    """Read the frame in a header."""
    found = re.search(r"frame_id: (\S+)", text)
    return found[1] if found else NOTHING


def static(text: str) -> str:
    """Read what /tf_static says of the laser."""
    found = re.search(
        r"child_frame_id: laser_frame\n.*?x: (\S+)\n\s+y: (\S+)\n\s+z: (\S+)\n\s+rotation:.*?w: (\S+)", text, re.DOTALL
    )
    return f"x {found[1]}, y {found[2]}, z {found[3]}, w {found[4]}" if found else "no laser_frame"


def parameter(text: str) -> str:
    """Read a parameter's value, or that there is no such node."""
    return text.strip().removeprefix("Boolean value is: ")


def verbatim(text: str) -> str:
    """Read a text that is a finding itself."""
    return text.strip()


READERS = {
    reader.__name__: reader
    for reader in (
        rviz, node_list, view_frames, publishers, connection, wheels, mount, correction, monitor, rate, delay, header,
        static, parameter, verbatim,
    )
}  # fmt: skip


def _error(text: str) -> str:
    if "does not exist" in text:
        name = re.search(r'Invalid frame ID "(\w+)"|[Ff]rame \[?(\w+)\]? does not exist', text)
        return f"{(name[1] or name[2]) if name else 'a frame'} {UNKNOWN}"
    if "not part of the same tree" in text:
        return APART
    return "extrapolation into the future" if "into the future" in text else text.strip()[:60]


def _log(text: str) -> list[str]:
    return [f"log: {word}" for word in (DENORMALIZED, INCOMPATIBLE) if word in text]


def _threes(points: list[tuple[float, ...]]):
    return zip(points, points[1:], points[2:], strict=False)


def _kink(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...]) -> float:
    """Return how far the middle one of three points lies from between the others [m]."""
    return math.dist(b, [(x + y) / 2.0 for x, y in zip(a, c, strict=True)])


# -- from a finding to its kind -------------------------------------------


def kind_of(reader: str, finding: str) -> str:
    """Return what kind of finding it is: AS_ON_THE_CARD, or a word or two for what is not."""
    logged = [word for word in (DENORMALIZED, INCOMPATIBLE) if word in finding]
    return logged[0] if logged else _KINDS[reader](finding)


def _kind_of_rviz(finding: str) -> str:
    if "Fixed Frame" in finding:
        return "Fixed Frame unknown, map listed" if finding.endswith("map listed") else "map unknown"
    if "no transform" in finding:
        return "robot lost, and a foreign frame" if "foreign" in finding else "robot lost"
    if "unknown" in finding:
        return "scan's own frame unknown" if "[laser_frame]" in finding else "scan's frame is another"
    return "into the future" if "future" in finding else AS_ON_THE_CARD


def _kind_of_nodes(finding: str) -> str:
    nodes = set(finding.split())
    missing, more = sorted(set(CARD_NODES) - nodes), sorted(nodes - set(CARD_NODES))
    said = [f"without {name}" for name in missing] + [f"with {name}" for name in more]
    return ", ".join(said) or AS_ON_THE_CARD


def _kind_of_tree(finding: str) -> str:
    roots, *rest = finding.removeprefix("roots: ").split("; ")
    if "no laser_frame" in rest:
        return "no laser_frame"
    if roots != "map":
        foreign = set(roots.split(", ")) - set(CARD_FRAMES)
        return "a foreign root" if foreign else f"roots {roots}"
    base = next((float(part.split()[1]) for part in rest if part.startswith("base_footprint")), 20.0)
    return "base_footprint too often" if base > 26.0 else "base_footprint too seldom" if base < 12.0 else AS_ON_THE_CARD


def _kind_of_publishers(finding: str) -> str:
    ends = [end.split() for end in finding.split(", ") if end]
    if any(node == "laser_mount" and durability == "VOLATILE" for node, durability in ends):
        return "laser_mount VOLATILE"
    nodes = {node for node, _ in ends}
    if "laser_mount" in nodes:
        return AS_ON_THE_CARD
    usual = {"robot_state_publisher", "wheel_odometry", "localization"}
    said = [f"without {name}" for name in sorted(usual - nodes)] + [f"with {name}" for name in sorted(nodes - usual)]
    return ", ".join(said) or AS_ON_THE_CARD


def _kind_of_connection(finding: str) -> str:
    return AS_ON_THE_CARD if finding == "answers" else finding


def _kind_of_wheels(finding: str) -> str:
    if finding.startswith("to and fro"):
        return "to and fro"
    return AS_ON_THE_CARD if finding == "smooth" else finding


def _kind_of_mount(finding: str) -> str:
    if UNKNOWN in finding or APART in finding:
        return finding
    return AS_ON_THE_CARD if finding == "0.200, 0.000, 0.150" else "elsewhere"


def _kind_of_correction(finding: str) -> str:
    return AS_ON_THE_CARD if finding.startswith("steps") else finding


def _kind_of_monitor(finding: str) -> str:
    delays = [float(number) for number in re.findall(r"(-?\d+\.\d+) s", finding)]
    if not delays:
        return _kind_of_connection(finding)
    hz = float(re.search(r"(\d+\.\d+) Hz", finding)[1])
    if max(delays) > 0.1:
        return "late"
    return "too much in all" if hz > 60.0 else "too little in all" if hz < 40.0 else AS_ON_THE_CARD


def _kind_of_rate(finding: str) -> str:
    if finding == NOTHING:
        return NOTHING
    hz, spread_s = (float(number) for number in re.findall(r"\d+\.\d+", finding))
    if spread_s > 0.02:
        return "trembles"
    return "too seldom" if hz < 5.0 else AS_ON_THE_CARD


def _kind_of_delay(finding: str) -> str:
    if finding == NOTHING:
        return NOTHING
    delay_s = float(finding.split()[0])
    return "ahead" if delay_s < 0.0 else "late" if delay_s > 0.15 else AS_ON_THE_CARD


def _kind_of_header(finding: str) -> str:
    if finding in ("laser_frame", "base_link"):
        return AS_ON_THE_CARD if finding == "laser_frame" else "base_link"
    return "another frame"


def _kind_of_static(finding: str) -> str:
    if finding == "no laser_frame":
        return finding
    if finding.endswith("w 0.0"):
        return "w 0"
    return AS_ON_THE_CARD if finding.startswith("x 0.2, y 0.0, z 0.15,") else "elsewhere"


def _kind_of_parameter(finding: str) -> str:
    return finding


def _kind_of_what_is(finding: str) -> str:
    return AS_ON_THE_CARD


_KINDS = {
    "rviz": _kind_of_rviz,
    "node_list": _kind_of_nodes,
    "view_frames": _kind_of_tree,
    "publishers": _kind_of_publishers,
    "connection": _kind_of_connection,
    "wheels": _kind_of_wheels,
    "mount": _kind_of_mount,
    "correction": _kind_of_correction,
    "monitor": _kind_of_monitor,
    "rate": _kind_of_rate,
    "delay": _kind_of_delay,
    "header": _kind_of_header,
    "static": _kind_of_static,
    "parameter": _kind_of_parameter,
    "verbatim": _kind_of_what_is,
}
