"""Run `ros2 bag record`, `play` and `info`.

    ros2 bag record -o drive --topics /tf /tf_static      until Ctrl-C; on Humble without --topics
    ros2 bag info drive
    ros2 bag play drive --clock --loop

The work is done in `tflab.bags`; here are the options, and what stands on the
terminal.  upstream: rosbag2/ros2bag, rosbag2_transport.
"""

from __future__ import annotations

import argparse
import re
import sys
from datetime import datetime
from itertools import count
from pathlib import Path

from tflab.bags.errors import BagError
from tflab.bags.record import STORAGES
from tflab.core import NSEC_PER_SEC
from tflab.ros import distro
from tflab.ros.graph import current_process
from tflab.ros.logging import get_logger

from .discovery import add_verb
from .session import display_time_zone, spin, spin_for, tool_node

__all__ = ["add_verbs"]

DEFAULT_CLOCK_HZ = 40.0


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 bag` to a parser."""
    verb = add_verb(verbs, "info", "Print information about a bag to the screen", info, looks_around=False)
    verb.add_argument("bag_path", help="Bag to open")
    verb = add_verb(verbs, "play", "Play back ROS data from a bag", play, looks_around=False)
    _add_play_options(verb)
    verb = add_verb(verbs, "record", "Record ROS data to a bag", record, looks_around=False)
    _add_record_options(verb)


def _add_play_options(verb: argparse.ArgumentParser) -> None:
    bag = verb.add_mutually_exclusive_group(required=True) if distro.current().play_takes_input else verb
    bag.add_argument("bag_path", nargs="?" if distro.current().play_takes_input else None, help="Bag to open")
    if distro.current().play_takes_input:
        bag.add_argument("-i", "--input", action="append", nargs="+", help="Bag to open, and its storage.")
    if distro.current().play_takes_storage:
        verb.add_argument("-s", "--storage", choices=STORAGES, help="Storage implementation of bag.")
    verb.add_argument("-r", "--rate", type=_positive, default=1.0, help="rate at which to play back messages.")
    verb.add_argument("--topics", nargs="+", default=[], metavar="TOPIC", help="topics to replay; all if not given.")
    verb.add_argument("-l", "--loop", action="store_true", help="enables loop playback when playing a bagfile.")
    verb.add_argument(
        "--clock", type=_positive, nargs="?", const=DEFAULT_CLOCK_HZ, default=0.0,
        help="Publish to /clock at a specific frequency in Hz, to act as a ROS Time Source.",
    )  # fmt: skip
    verb.add_argument("--start-offset", type=_not_negative, default=0.0,
                      help="Start the playback player this many seconds into the bag file.")  # fmt: skip


def _add_record_options(verb: argparse.ArgumentParser) -> None:
    release = distro.current()
    names = verb.add_mutually_exclusive_group()
    if release.record_takes_names:
        names.add_argument("names", nargs="*", default=[], metavar="topics", help="List of topics to record.")
    if release.record_takes_topics:
        names.add_argument("--topics", nargs="+", default=[], metavar="Topic",
                           help="Space-delimited list of topics to record.")  # fmt: skip
    verb.add_argument("-a", "--all", action="store_true", help="Record all topics.")
    verb.add_argument("-e", "--regex", type=_pattern, help="Record only topics containing provided regular expression.")
    verb.add_argument("-o", "--output", help="Destination of the bag to create; a timestamped directory by default.")
    verb.add_argument("-s", "--storage", choices=STORAGES, default=release.default_bag_storage,
                      help="Storage identifier to be used.")  # fmt: skip
    verb.add_argument("--use-sim-time", action="store_true", help="Use simulation time for message timestamps.")


def info(options: argparse.Namespace) -> str | None:
    """Print what is in a bag."""
    from tflab.bags.info import bag_facts, info_text

    try:
        print(info_text(bag_facts(options.bag_path), display_time_zone()))
    except BagError as error:
        return f"[ERROR] [ros2bag]: {error}"
    return None


def record(options: argparse.Namespace) -> str | None:
    """Record until stopped; the bag is whole also then."""
    from tflab.bags.record import BagWriter, Recorder

    named = [*getattr(options, "names", ()), *getattr(options, "topics", ())]
    if not (named or options.all or options.regex):
        return "[ERROR] [ros2bag]: Must specify topics to record: by name, with --regex, or --all."
    path = Path(options.output or _dated_name())
    if path.exists() and not _put_aside(path):
        return f"[ERROR] [ros2bag]: Output folder '{path}' already exists."
    arguments = ["--ros-args", "-p", "use_sim_time:=true"] if options.use_sim_time else []
    with tool_node("rosbag2_recorder", cli_args=arguments) as node:
        log = node.get_logger().info
        topics = [node.resolve_topic_name(topic) for topic in named]
        is_wanted = _filter(options, topics)
        try:
            writer = BagWriter(path, options.storage)
        except BagError as error:
            return f"[ERROR] [ros2bag]: {error}"
        with writer:
            log("Press SPACE for pausing/resuming")
            log("Listening for topics...")
            log("Event publisher thread: Starting")
            log("Recording...")
            try:
                Recorder(node, writer, is_wanted, topics)
                spin(node)
            except KeyboardInterrupt:
                pass
            get_logger("rosbag2_cpp").info("Writing remaining messages from cache to the bag. It may take a while")
        log("Event publisher thread: Exiting")
        log("Recording stopped")
    return None


def play(options: argparse.Namespace) -> str | None:
    """Play a bag to its end, or for ever if it loops."""
    from tflab.bags.play import PlayOptions
    from tflab.bags.play import play as play_bag

    bags = [options.bag_path] if options.bag_path else [path for path, *_ in options.input]
    if len(bags) > 1:
        return "[ERROR] [ros2bag]: tflab plays one bag at a time; on a robot, several -i,--input play together."
    with tool_node("rosbag2_player") as node:
        log = node.get_logger().info
        driver = current_process().driver
        begin_ns = driver.steady_ns()

        def wait_until(after_ns: int) -> None:
            left_ns = begin_ns + after_ns - driver.steady_ns()
            if left_ns > 0:
                spin_for(node, left_ns / NSEC_PER_SEC)

        log(f"Set rate to {options.rate:g}")
        log("Adding keyboard callbacks.")
        log("Press SPACE for Pause/Resume")
        log("Press CURSOR_RIGHT for Play Next Message")
        log("Press CURSOR_UP for Increase Rate 10%")
        log("Press CURSOR_DOWN for Decrease Rate 10%")
        log("Playback until timestamp: -1")
        how = PlayOptions(options.rate, options.start_offset, options.loop, tuple(options.topics), options.clock)
        try:
            play_bag(node, bags[0], how, wait_until)
        except BagError as error:
            return f"[ERROR] [ros2bag]: {error}"
    return None


def _filter(options: argparse.Namespace, topics: list[str]):
    """Return the function that says whether a topic is to be recorded."""
    own = ("/rosout", "/parameter_events", "/events/write_split")

    def is_wanted(topic: str) -> bool:
        if topic in topics:
            return True
        if options.regex is not None:
            return options.regex.search(topic) is not None
        return options.all and topic not in own

    return is_wanted


def _dated_name() -> str:
    now = datetime.fromtimestamp(current_process().driver.now_ns() / NSEC_PER_SEC, display_time_zone())
    return f"rosbag2_{now:%Y_%m_%d-%H_%M_%S}"


def _put_aside(path: Path) -> bool:
    """Rename the bag that an earlier run of a page's cell left behind; in a shell it stays, and upstream refuses."""
    if not current_process().driver.is_virtual or not (path / "metadata.yaml").is_file():
        return False
    aside = next(other for n in count(1) if not (other := path.with_name(f"{path.name}_{n}")).exists())
    path.rename(aside)
    print(f"[WARN] [ros2bag]: Output folder '{path}' already exists: it is now '{aside}'.", file=sys.stderr, flush=True)
    return True


def _positive(text: str) -> float:
    value = _float(text)
    if not 0.0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is not in the valid range (> 0.0)")
    return value


def _not_negative(text: str) -> float:
    value = _float(text)
    if not 0.0 <= value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is not in the valid range (>= 0.0)")
    return value


def _float(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text} is not the valid type (float)") from None


def _pattern(text: str) -> re.Pattern[str]:
    try:
        return re.compile(text)
    except re.error as fault:
        raise argparse.ArgumentTypeError(f"{text} is no regular expression: {fault}") from None
