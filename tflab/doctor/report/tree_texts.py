"""What is said of names, trees, numbers, owners and mounts?

The blanks are filled from a finding's edge, topic and facts.
"""

from __future__ import annotations

from .sentences import ECHO, TOPIC_ECHO, TOPIC_INFO, VIEW_FRAMES, Sentences

__all__ = ["OWNERS", "TREE_TEXTS"]

# who usually quarrels about an edge, by what it stands for
OWNERS = {
    "odometry": "wheel odometry and a filter, say; switch off one (often a parameter publish_tf)",
    "joint": "a driver and joint_state_publisher, or two robot_state_publishers; stop one",
    "mount": "two robot descriptions, or a description and a static_transform_publisher; remove one",
}

TREE_TEXTS: dict[str, Sentences] = {
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
        'Both occur; tf2 takes "{name}" for another frame. It is said in {said}.',
        'One of two nodes spells the frame in another case or with other separators: "{other}" is what the others say.',
        TOPIC_INFO,
    ),
    "name-prefix": Sentences(
        '"{name}" and "{other}" differ only in the prefix "{prefix}"',
        "Both occur; tf2 takes them for two frames. With the prefix: {names}.",
        "A frame_prefix or a namespace is set for one node and not for the others. Namespaces do not change "
        "frame names.",
        TOPIC_INFO,
    ),
    "name-slip": Sentences(
        '"{name}" is probably meant to be "{other}"',
        'They are a letter or two apart, and "{hanging}" hangs in the air. "{name}" is said in {said}.',
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
        'Messages are in the frame "{name}", which nobody publishes',
        "{count} messages on {topics} name it; it is not in the tree.{alike}",
        "The static transform of the sensor is missing, or its name is written differently in the driver and "
        "in the URDF.",
        VIEW_FRAMES,
    ),
    "unknown-world-frame": Sentences(
        'Messages are in the frame "{name}", which nobody publishes',
        "{count} messages on {topics} name it; it is not in the tree.{alike}",
        "Whoever should publish the transform from or to it does not: for odometry the filter or the driver "
        "(a parameter publish_tf), for a map the localiser.",
        "ros2 topic info /tf --verbose",
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
        "{circle}, each the child of the next.{closed}",
        "One of these transforms points the wrong way, or two nodes disagree about which frame is the parent.",
        VIEW_FRAMES,
    ),
    "re-parented": Sentences(
        '"{child}" changed its parent',
        "Its parent was {parents}.",
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
        "The tree is in {count} pieces: not connected to {largest}: {roots}",
        "Nobody publishes a parent for {root}. The pieces: {pieces}.",
        "A transform between them is not published: its node is not running, or it was not recorded.",
        "ros2 run tf2_ros tf2_echo {largest} {root}",
    ),
    "upside-down": Sentences(
        "{edge} stands upside down",
        'REP-105: map -> odom -> base_link; here "{child}" is the child of "{parent}".',
        "Parent and child were exchanged, or a transform was published without inverting it.",
        TOPIC_INFO,
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
        "{edge} has values that are not numbers",
        "{count} of {total} samples hold NaN or infinity; tf2 refuses NaN (TF_NAN_INPUT).",
        "A division by zero, or a filter that diverged, upstream of the publisher.",
        ECHO,
    ),
    "zero-quaternion": Sentences(
        "{edge} has rotations of (0, 0, 0, 0)",
        "{count} of {total} samples; tf2 refuses them (TF_DENORMALIZED_QUATERNION): if all are, the frame does not "
        "exist, if some are, they are holes.",
        "The rotation was never set, or zeroed. No rotation is (0, 0, 0, 1).",
        TOPIC_ECHO,
    ),
    "not-unit-quaternion": Sentences(
        "{edge} has rotations that are not of length one",
        "{count} of {total} samples, of length {shortest} to {longest}.",
        "Numbers were rounded, mixed or interpolated without normalising. ROS 2 scales them in silence, ROS 1 "
        "refuses them.",
        TOPIC_ECHO,
    ),
    "out-of-this-world": Sentences(
        "{edge} is further away than anything on the earth",
        "{count} of {total} samples, up to {furthest} m.",
        "A number that was never set, or units mixed up. tf2 takes it as it is.",
        ECHO,
    ),
    "optical-unturned": Sentences(
        'The optical frame "{child}" is not turned',
        "{edge} has no rotation ({count} of {total} samples).",
        "REP-103: z of an optical frame looks ahead, x to the right: rpy (-1.5708, 0, -1.5708) under the "
        "camera's body frame.",
        ECHO,
    ),
    # owners
    "two-owners": Sentences(
        "{edge} has two owners",
        "{evidence}.",
        "Two nodes publish the same transform: {who}. The robot trembles between their values.",
        TOPIC_INFO,
    ),
    "moving-and-static": Sentences(
        '"{child}" is published on /tf and on /tf_static',
        "{count} times as moving, {static_count} times as static.",
        "Two owners: each new kind wipes out what tf2 has stored of the other.",
        "ros2 topic info /tf_static --verbose",
    ),
    # statics
    "statics-missing": Sentences(
        "There is no {topic}",
        "Frames of messages that are not in the tree: {hanging}; pieces of the tree: {trees}.",
        "It was not recorded, or the recorder came late and did not ask for transient_local.",
        "ros2 bag record /tf /tf_static",
    ),
    "constant-on-tf": Sentences(
        "{edge} never moves, but is repeated on /tf",
        "{count} samples at {rate} Hz, all equal.",
        "A mount that should be sent once, on /tf_static: by the URDF, or a static broadcaster.",
        TOPIC_INFO,
    ),
    "moving-on-static": Sentences(
        "{edge} moves on /tf_static",
        "{changes} changes in {count} samples, up to {apart} m.",
        "A moving transform was sent with a static broadcaster: it has no history, so every lookup gets the "
        "last value.",
        TOPIC_INFO,
    ),
    "static-changed": Sentences(
        "{topic} changed: {edges}",
        "{count} of its transforms, once, by up to {apart} m.",
        "It was calibrated anew, or two nodes publish it with different values (two robot descriptions): one change "
        "cannot tell which.",
        "ros2 topic info {topic} --verbose",
    ),
    "volatile-static": Sentences(
        "{topic} was offered as volatile",
        "By {publisher}.{heard}",
        "Listeners that start later never hear of it; a listener that asks for transient_local hears nothing at all.",
        TOPIC_INFO,
    ),
}
