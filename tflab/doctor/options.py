"""What may one ask of `tflab doctor`?  Its words, and the help that teaches them.

```
what to look at      BAG ...  |  --live SECONDS
how to read it       (text)  --json  --html  --junit  --sarif  --github
when it fails        --fail-on  --expect  --ignore  --baseline
```
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from tflab.text import LANGUAGES

__all__ = ["FAILING", "options_from"]

FAILING = {
    "error": ("error",),
    "warning": ("error", "warning"),
    "info": ("error", "warning", "info"),
    "never": (),
}

DESCRIPTION = """\
Say what is wrong with the TF of a recording, why, and what to type next.

A bag is a rosbag2 directory, an .mcap or .db3 file, or a .bag of ROS 1. Nothing
of ROS needs to be installed, and nothing is written but what you ask for.
"""

EPILOG = """\
examples:
  tflab doctor drive/                          what is wrong?
  tflab doctor drive/ --html report.html       the same, to hand to a colleague
  tflab doctor monday/ tuesday/                what changed between the two?
  tflab doctor 'bags/*.mcap' --table           a line for each
  tflab doctor --live 10                       a robot, for ten seconds (needs ROS 2)

in CI:
  tflab doctor good/ --write-expectations robot.toml      once; then edit the file
  tflab doctor drive/ --expect robot.toml --fail-on warning --junit doctor.xml
  tflab doctor drive/ --write-baseline known.json         live with what is known ...
  tflab doctor drive/ --baseline known.json               ... and fail on what is new
  tflab doctor drive/ --ignore unknown-frame:/diagnostics

how to read a finding:
  ERROR     lookups fail or are wrong: mend it
  WARNING   somebody will notice, sooner or later
  INFO      good to know
  Also      what follows from it, and goes away with it
  Sure      how sure that is, and what would settle it (nothing said: it is certain)
  Next      the command to type on the robot

exit status:
  0  nothing as severe as --fail-on       1  something is
  2  a bag cannot be read, or not to its end; a report not be written; or the words make no sense
"""


def options_from(words: Sequence[str]) -> argparse.Namespace:
    """Return what was asked for; what makes no sense ends the program with status 2."""
    parser = argparse.ArgumentParser(
        prog="tflab doctor",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("bags", metavar="BAG", nargs="*", help="a recording; two are compared, more are a table")
    parser.add_argument("--live", metavar="SECONDS", type=_seconds, help="listen to the robot instead, through rclpy")
    parser.add_argument("--table", action="store_true", help="a line for each bag, also of one or two")
    reading = parser.add_argument_group("how to read it")
    reading.add_argument("--json", action="store_true", help="print JSON")
    reading.add_argument("--html", metavar="FILE", help="also write a page with pictures (of one bag)")
    reading.add_argument("--junit", metavar="FILE", help="also write a test run, as JUnit XML")
    reading.add_argument("--sarif", metavar="FILE", help="also write SARIF, for code scanning")
    reading.add_argument("--github", action="store_true", help="also print annotations for GitHub Actions")
    reading.add_argument("--edges", action="store_true", help="also print rate, delays and owners of each edge")
    reading.add_argument(
        "--lang", choices=LANGUAGES, default="en", help="of the report, the table and the page; %(default)s"
    )
    failing = parser.add_argument_group("when it fails")
    failing.add_argument("--fail-on", choices=FAILING, default="error", help="the least severity that gives status 1")
    failing.add_argument("--expect", metavar="FILE", help="what a good recording looks like; deviations are findings")
    failing.add_argument("--write-expectations", metavar="FILE", help="write that file, from this bag")
    failing.add_argument("--ignore", metavar="CODE[:WHERE]", action="append", default=[], help="let findings pass")
    failing.add_argument("--baseline", metavar="FILE", help="let those pass that are in this file")
    failing.add_argument("--write-baseline", metavar="FILE", help="write that file, of everything that is found")
    options = parser.parse_args(list(words))
    if (options.live is None) != bool(options.bags):
        parser.error("name a BAG, or ask for --live SECONDS" + (", not both" if options.bags else ""))
    options.bags = _expanded(options.bags)
    if options.json and options.github:
        parser.error("--json and --github both print: choose one")
    is_one = len(options.bags) < 2
    if not is_one and (options.html or options.write_expectations):
        parser.error("--html and --write-expectations are about one bag")
    return options


def _expanded(bags: list[str]) -> list[str]:
    """Return the bags that are meant, where a shell has left * and ? as they were."""
    expanded = []
    for bag in bags:
        if Path(bag).exists() or not any(sign in bag for sign in "*?["):
            expanded.append(bag)
            continue
        path = Path(bag)
        found = sorted(str(place) for place in Path(path.anchor).glob(str(path.relative_to(path.anchor))))
        expanded += found or [bag]
    return expanded


def _seconds(word: str) -> float:
    seconds = float(word)
    if not 0.0 < seconds < 86400.0:
        raise argparse.ArgumentTypeError(f"{word} s: choose more than 0, and less than a day")
    return seconds
