"""What does it mean, and what to do?  The sentences of the report, in English.

    code  ->  title       what is wrong
              evidence    what shows it
              cause       why it usually happens
              command     what to type on the robot next (lecture, 27)

The blanks are filled from a finding's edge, topic and facts.  Another language is
another table with the same keys.  Read `faults.py` next.
"""

from __future__ import annotations

from typing import NamedTuple

from ..findings import Finding

__all__ = ["CHECK_TEXTS", "TEXTS", "Sentences", "sentences"]

TOPIC_INFO = "ros2 topic info {topic} --verbose"
VIEW_FRAMES = "ros2 run tf2_tools view_frames"
ECHO = "ros2 run tf2_ros tf2_echo {parent} {child}"
MONITOR = "ros2 run tf2_ros tf2_monitor {parent} {child}"
TOPIC_ECHO = "ros2 topic echo {topic} --once"
SIM_TIME = "ros2 param get /NODE use_sim_time"


class Sentences(NamedTuple):
    """What is said of one code, with blanks, or of one finding, without."""

    title: str
    evidence: str
    cause: str
    command: str


TEXTS: dict[str, Sentences] = {
    # names
    "leading-slash": Sentences(
        "Names on {topic} begin with a slash: {names}",
        "tf2 stores them without it, as {bare}.",
        "Code from ROS 1, or a parameter such as frame_id with a slash. A lookup with the slash is refused.",
        TOPIC_ECHO,
    ),
    "empty-name": Sentences(
        "A transform without a name at one end",
        'Parent "{parent}", child "{child}" on {topic}; tf2 refuses it.',
        "header.frame_id or child_frame_id was never set.",
        TOPIC_INFO,
    ),
    "name-case": Sentences(
        '"{name}" and "{other}" differ only in how they are written',
        'Both occur; tf2 takes "{name}" for another frame.',
        'One of two nodes spells the frame in another case or with other separators: "{other}" is what the others say.',
        TOPIC_INFO,
    ),
    "name-prefix": Sentences(
        '"{name}" and "{other}" differ only in the prefix',
        'Both occur; tf2 takes "{name}" for another frame.',
        "A frame_prefix or a namespace is set for one node and not for the others. Namespaces do not change "
        "frame names.",
        TOPIC_INFO,
    ),
    "name-slip": Sentences(
        '"{name}" is probably meant to be "{other}"',
        'Nobody else says "{name}", and it leaves "{other}" unconnected.',
        "A misspelt frame name in a parameter, a launch file or a URDF.",
        VIEW_FRAMES,
    ),
    "message-slash": Sentences(
        'Messages on {topic} name their frame "{name}"',
        'The tree has "{bare}"; a lookup with the slash is refused.',
        "A driver from ROS 1, or its frame_id parameter.",
        "ros2 topic echo {topic} --once --field header",
    ),
    "unknown-frame": Sentences(
        'Messages on {topic} are in the frame "{name}", which nobody publishes',
        "{count} messages name it; it is not in the tree.",
        "The static transform of the sensor is missing, or its name is written differently in the driver and "
        "in the URDF.",
        "ros2 topic echo /tf_static --once",
    ),
    # tree
    "self-transform": Sentences(
        '"{child}" was published as its own parent',
        "Sent on {topic}; tf2 refuses it (TF_SELF_TRANSFORM).",
        "header.frame_id and child_frame_id were filled with the same parameter.",
        TOPIC_INFO,
    ),
    "loop": Sentences(
        "The frames go round in a circle",
        "{circle}, each the child of the next.",
        "One of these transforms points the wrong way, or two nodes disagree about which frame is the parent.",
        VIEW_FRAMES,
    ),
    "re-parented": Sentences(
        '"{child}" changed its parent',
        "Parents: {parents}; changed {changes} times.",
        "Another node took over, or a parameter such as odom_frame was changed while running. "
        "A frame has one parent; tf2 does not interpolate across the change.",
        TOPIC_INFO,
    ),
    "two-parents": Sentences(
        '"{child}" has two parents at the same time',
        "Parents: {parents}; changed {changes} times.",
        "Two nodes publish it, each under its own parent: often a localiser that publishes map -> base_link although "
        "odom -> base_link exists. It should publish map -> odom.",
        TOPIC_INFO,
    ),
    "two-trees": Sentences(
        'The tree is in {count} pieces: "{root}" is not connected',
        'The piece of "{root}": {frames}. The rest hangs under "{largest}".',
        "The transform between the two is not published: its node is not running, or it was not recorded.",
        "ros2 run tf2_ros tf2_echo {largest} {root}",
    ),
    "several-robots": Sentences(
        "Several robots, without a common frame",
        "Roots: {roots}.",
        "Each robot has a tree of its own. That is a choice; for a common map somebody must publish the first "
        "link of each.",
        VIEW_FRAMES,
    ),
    # values
    "not-a-number": Sentences(
        "{parent} -> {child} has values that are not numbers",
        "{count} of {total} samples hold NaN or infinity; tf2 refuses NaN (TF_NAN_INPUT).",
        "A division by zero, or a filter that diverged, upstream of the publisher.",
        ECHO,
    ),
    "zero-quaternion": Sentences(
        "{parent} -> {child} has rotations of (0, 0, 0, 0)",
        "{count} of {total} samples; tf2 refuses them (TF_DENORMALIZED_QUATERNION), so the frame seems not to exist.",
        "The rotation was never set, or zeroed. No rotation is (0, 0, 0, 1).",
        TOPIC_ECHO,
    ),
    "not-unit-quaternion": Sentences(
        "{parent} -> {child} has rotations that are not of length one",
        "{count} of {total} samples, of length {shortest} to {longest}.",
        "Numbers were rounded, mixed or interpolated without normalising. ROS 2 scales them in silence, ROS 1 "
        "refuses them.",
        TOPIC_ECHO,
    ),
    "optical-unturned": Sentences(
        'The optical frame "{child}" is not turned',
        "{parent} -> {child} has no rotation ({count} of {total} samples).",
        "REP-103: z of an optical frame looks ahead, x to the right: rpy (-1.5708, 0, -1.5708) under the "
        "camera's body frame.",
        ECHO,
    ),
    # time
    "repeated-stamps": Sentences(
        "{parent} -> {child} repeats its stamps",
        "{count} of {total} samples have the stamp of an earlier one, with {values} values.",
        "The node publishes faster than it computes, or the messages arrive twice (a bridge, a bag played "
        "beside the robot). "
        "Humble warns TF_REPEATED_DATA and drops them; later tf2 keeps the last.",
        TOPIC_INFO,
    ),
    "unordered-stamps": Sentences(
        "{parent} -> {child} does not arrive in the order of its stamps",
        "{count} of {total} samples were older than one before them, by up to {most} s.",
        "Samples overtake each other: several threads, a lossy network, or a queue that is not emptied in order.",
        MONITOR,
    ),
    "unset-stamps": Sentences(
        "{parent} -> {child} has stamps of zero",
        "{count} of {total} samples.",
        "header.stamp was never set, or the node runs on simulated time and has not heard of /clock.",
        SIM_TIME,
    ),
    "gap": Sentences(
        "There are gaps in {edges}",
        "Silent {count} time(s), at most for {longest} s (usually {period} s between samples), "
        "and moved {moved} m meanwhile.",
        "The publisher was blocked, or its messages were lost. tf2 draws a straight line across, and the shorter arc: "
        "wrong if a wheel turned more than half a turn.",
        "ros2 topic hz {topic}",
    ),
    "went-silent": Sentences(
        "{edges}: no more transforms",
        "Nothing for the last {longest} s (usually {period} s between samples), while others went on.",
        "The node died, or was shut down. Lookups will fail with an extrapolation into the future.",
        "ros2 node list",
    ),
    "stall": Sentences(
        "Everything stood still",
        "All moving edges were silent for {longest} s: {edges}.",
        "Not the publishers but what they share: the recorder, the network or the computer was blocked.",
        MONITOR,
    ),
    "late-stamps": Sentences(
        "{parent} -> {child} comes late",
        "{count} of {total} samples were received {delay} s after their stamp (others: {others} s; spread {spread} s).",
        "The node takes long, or the clock of its computer is behind the others: this alone cannot tell which.",
        MONITOR,
    ),
    "early-stamps": Sentences(
        "{parent} -> {child} is stamped in the future",
        "{count} of {total} samples were received {delay} s before their stamp (others: {others} s after; "
        "spread {spread} s).",
        "The clock of its computer is ahead of the others, or the node adds something to its stamps: this "
        "alone cannot tell which.",
        MONITOR,
    ),
    "stamped-ahead": Sentences(
        "{parent} -> {child} is stamped ahead, as localisers do",
        "Received {delay} s before its stamp as a rule.",
        "AMCL and others add their transform_tolerance, so that lookups between two corrections succeed.",
        MONITOR,
    ),
    "messages-early": Sentences(
        "Messages on {topic} are stamped in the future",
        "{count} messages, received {delay} s before their stamp as a rule.",
        "The clock of the sensor's computer is ahead: lookups at these stamps need an extrapolation into the future, "
        "and waiting does not help.",
        "ros2 topic delay {topic}",
    ),
    "messages-late": Sentences(
        "Messages on {topic} are stamped long ago",
        "{count} messages, received {delay} s after their stamp as a rule.",
        "Processing takes long, or the clock of the sensor's computer is behind: lookups at these stamps may find "
        "that the buffer has forgotten them.",
        "ros2 topic delay {topic}",
    ),
    # owners
    "two-owners": Sentences(
        "{parent} -> {child} has two owners",
        "{evidence}.",
        "Two nodes publish the same transform, such as wheel odometry and a filter. The robot trembles "
        "between their values; "
        "switch off one (often a parameter publish_tf).",
        TOPIC_INFO,
    ),
    "moving-and-static": Sentences(
        '"{child}" is published on /tf and on /tf_static',
        "{count} times as moving, {static_count} times as static.",
        "Two owners: each new kind wipes out what tf2 has stored of the other.",
        "ros2 topic info /tf_static --verbose",
    ),
    # clocks
    "clock-jump-back": Sentences(
        "The clock jumped back",
        "Stamps of {edges} went back by {size} s and went on from there; seen {count} times.",
        "A bag in a loop, a simulator that was reset, or a clock that was set. tf2 refuses what is older than "
        "its cache; "
        "a buffer without a node is not cleared.",
        SIM_TIME,
    ),
    "clock-jump-forward": Sentences(
        "The clock jumped forward",
        "Stamps of {edges} leapt by {size} s and went on from there; seen {count} times.",
        "A clock that was set while running (NTP after the start), or a bag that was skipped ahead.",
        SIM_TIME,
    ),
    "clock-offset": Sentences(
        "Two clocks disagree",
        "{count} sources are received {offset} s {way} their stamp, all alike.",
        "The clocks of the robot and of the recorder differ, or everything is delayed alike: the recording "
        "cannot tell which.",
        "chronyc tracking",
    ),
    "mixed-time": Sentences(
        "Some nodes follow /clock and others do not",
        "use_sim_time is true in {following}, and false in {others}.",
        "The parameter must be the same in all nodes: set it in the launch file, for all (/**).",
        "ros2 param get {node} use_sim_time",
    ),
    "other-clock": Sentences(
        "Stamps come from another clock than the times of receipt",
        "The difference is {difference} s ({source}), with {drift} ms of drift; delays are told without it.",
        "Simulated time, or a recording of a replay. All nodes must then use it.",
        SIM_TIME,
    ),
    # statics
    "statics-missing": Sentences(
        "There is no /tf_static",
        "Frames of messages that are not in the tree: {hanging}; pieces of the tree: {trees}.",
        "It was not recorded, or the recorder came late and did not ask for transient_local.",
        "ros2 bag record /tf /tf_static",
    ),
    "constant-on-tf": Sentences(
        "{parent} -> {child} never moves, but is repeated on /tf",
        "{count} samples at {rate} Hz, all equal.",
        "A mount that should be sent once, on /tf_static: by the URDF, or a static broadcaster.",
        TOPIC_INFO,
    ),
    "moving-on-static": Sentences(
        "{parent} -> {child} moves on /tf_static",
        "{changes} changes in {count} samples, up to {apart} m.",
        "A moving transform was sent with a static broadcaster: it has no history, so every lookup gets the "
        "last value.",
        "ros2 topic echo /tf_static",
    ),
    "static-changed": Sentences(
        "{parent} -> {child} changed on /tf_static",
        "One change, of {apart} m.",
        "It was calibrated anew, or two nodes publish it with different values: one change cannot tell which.",
        "ros2 topic info /tf_static --verbose",
    ),
    "volatile-static": Sentences(
        "{topic} was offered as volatile",
        "By {publisher}.",
        "Listeners that start later never hear of it; a listener that asks for transient_local hears nothing at all.",
        TOPIC_INFO,
    ),
    "no-transforms": Sentences(
        "There are no transforms",
        "Recorded: {topics}.",
        "/tf and /tf_static were not recorded; with the sensors alone nothing can be placed.",
        "ros2 bag record /tf /tf_static",
    ),
    "passed-over": Sentences("Some messages could not be read", "{note}.", "They are broken, or of another type.", ""),
}

CHECK_TEXTS = {
    "arrival": "the order and the times of arrival, which a buffer does not keep",
    "raw": "what was sent, which a buffer corrects or refuses",
    "recording": "the other topics, which a buffer does not know",
}


def sentences(finding: Finding, texts: dict[str, Sentences] = TEXTS) -> Sentences:
    """Return what a finding says, its blanks filled."""
    blanks = {"parent": finding.parent, "child": finding.child, "topic": finding.topic or "/tf", **finding.facts}
    text = texts[finding.code]
    return Sentences(*(part.format(**blanks) for part in text))
