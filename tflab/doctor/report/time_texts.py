"""What is said of stamps, silences, delays and clocks, and of what was recorded at all?

The blanks are filled from a finding's edge, topic and facts.
"""

from __future__ import annotations

from .sentences import ECHO, EDGE_HZ, MONITOR, SIM_TIME, TOPIC_INFO, Sentences

__all__ = ["TIME_TEXTS"]

TIME_TEXTS: dict[str, Sentences] = {
    # time
    "repeated-stamps": Sentences(
        "{edge} repeats its stamps",
        "{count} of {total} samples have the stamp of an earlier one, with {values} values.",
        "The node publishes faster than it computes, or the messages arrive twice (a bridge, a bag played "
        "beside the robot). "
        "tf2 of ROS 2 keeps the different ones and answers with one of them; ROS 1 (Noetic) warns TF_REPEATED_DATA.",
        TOPIC_INFO,
    ),
    "unordered-stamps": Sentences(
        "{edge} does not arrive in the order of its stamps",
        "{count} of {total} samples were older than one before them, by up to {most} s.",
        "Samples overtake each other: several threads, a lossy network, or a queue that is not emptied in order. tf2 "
        "sorts in what is less than its cache (10 s) behind the newest, and refuses the rest (TF_OLD_DATA).",
        MONITOR,
    ),
    "unset-stamps": Sentences(
        "{edge} has stamps of zero",
        "{count} of {total} samples.",
        "header.stamp was never set, or the node runs on simulated time and has not heard of /clock.",
        SIM_TIME,
    ),
    "future-stamp": Sentences(
        "{edge}: a stamp {ahead} s in the future",
        "{count} of {total} samples are so far ahead of the others.",
        "A stamp was set wrongly once. Until time has caught up with it, tf2 refuses all later samples that are more "
        "than its cache (10 s) behind it (TF_OLD_DATA).",
        TOPIC_INFO,
    ),
    "gap": Sentences(
        "There are gaps in {edges}",
        "Silent {times}, at most for {longest} s (usually {period} s between samples): a hole of {hole} s in the "
        "stamps, across which it moved {moved} m and turned {turned} rad.",
        "The publisher was blocked, or its messages were lost. tf2 draws a straight line across, and the shorter arc: "
        "wrong if a wheel turned more than half a turn.",
        EDGE_HZ,
    ),
    "tf-silent": Sentences(
        "All of {topic} was silent, other topics were not",
        "For {longest} s, {times}: {edges}.",
        "Several publishers do not stop at once: the topic was lost on its way, in the network or in the queue of the "
        "recorder.",
        "ros2 topic hz {topic}",
    ),
    "late-start": Sentences(
        "{edge} begins {late} s after the others",
        "Before, every lookup that needs it fails.",
        "Its node was started later, or waited for something: a pose to begin with, a parameter, a driver.",
        ECHO,
    ),
    "slow-edge": Sentences(
        "{edge} comes only {rate} times a second",
        "From one sample to the next it moves {far} m and turns {turned} rad; the others: {others}.",
        "A rate was set too low, or most of its messages are lost. tf2 draws a straight line from sample to sample; "
        "a lookup of now must wait for the next one.",
        EDGE_HZ,
    ),
    "went-silent": Sentences(
        "{edges}: no more transforms",
        "Nothing for the last {longest} s (usually {period} s between samples), while others went on.",
        "The node died, or was shut down. Lookups will fail with an extrapolation into the future.",
        "ros2 node list",
    ),
    "stall": Sentences(
        "Everything stood still",
        "For {longest} s, {times}: {edges}.",
        "Not the publishers but what they share: the recorder, the network or the computer was blocked.",
        "ros2 topic hz {topic}",
    ),
    "late-stamps": Sentences(
        "{edge} comes late",
        "{count} of {total} samples were received {delay} s after their stamp (others: {others} s; spread {spread} s).",
        "The node takes long, or the clock of its computer is behind the others: this alone cannot tell which. A "
        "lookup at the stamp of a measurement has to wait so long, or fails (extrapolation into the future).",
        MONITOR,
    ),
    "early-stamps": Sentences(
        "{edge} is stamped in the future",
        "{count} of {total} samples were received {delay} s before their stamp (others: {others} s after; "
        "spread {spread} s).",
        "The clock of its computer is ahead of the others, or the node adds something to its stamps: this "
        "alone cannot tell which.",
        MONITOR,
    ),
    "stamped-ahead": Sentences(
        "{edge} is stamped ahead, as localisers do",
        "Received {delay} s before its stamp as a rule.",
        "AMCL and others add their transform_tolerance, so that lookups between two corrections succeed.",
        MONITOR,
    ),
    "messages-early": Sentences(
        "Messages on {topic} are stamped in the future",
        "{count} messages, received {delay} s before their stamp as a rule.",
        "The clock of the sensor's computer is ahead, or the driver adds to its stamps: lookups at these stamps need "
        "an extrapolation into the future; whoever waits learns where the robot is by then, not where it measured.",
        "ros2 topic delay {topic}",
    ),
    "messages-late": Sentences(
        "Messages on {topic} are stamped long ago",
        "{count} messages, received {delay} s after their stamp as a rule.",
        "Processing takes long, or the clock of the sensor's computer is behind: lookups at these stamps may find "
        "that the buffer has forgotten them.",
        "ros2 topic delay {topic}",
    ),
    # clocks
    "clock-jump-back": Sentences(
        "The clock jumped back",
        "Stamps of {edges} went back by {size} s and went on from there; seen {times}.",
        "A bag in a loop, a simulator that was reset, or a clock that was set. tf2 refuses what is older than "
        "its cache; "
        "a buffer without a node is not cleared.",
        SIM_TIME,
    ),
    "clock-jump-forward": Sentences(
        "The clock jumped forward",
        "Stamps of {edges} leapt by {size} s and went on from there; seen {times}.",
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
    "all-late": Sentences(
        "Everything comes late",
        "{count} sources are received {offset} s {way} their stamp, all alike, although the clocks agree.",
        "The network, or the queue of the listener: not the clocks.",
        "ros2 topic delay /tf",
    ),
    "other-time": Sentences(
        "{what} has stamps of another day",
        "{count} messages are {away} s away from the others.",
        "Its node reads another clock: use_sim_time is set for some nodes and not for all. Nothing can be looked up "
        "between the two times.",
        TOPIC_INFO,
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
    # files
    "no-transforms": Sentences(
        "There are no transforms",
        "Recorded: {topics}. {what}",
        "With the sensors alone nothing can be placed.",
        "ros2 bag record /tf /tf_static",
    ),
    "unfinished": Sentences(
        "The recorder was killed",
        "{what}: what is there was read.",
        "The recorder was not stopped by Ctrl-C, the disk was full, the power failed, or a copy is not complete. "
        "What comes last may be missing.",
        "{remedy}",
    ),
    "unreadable": Sentences(
        "Messages on {topic} could not be read",
        "{note}.",
        "They are broken, or of another type than the topic says.",
        "ros2 topic info {topic} --verbose",
    ),
}
