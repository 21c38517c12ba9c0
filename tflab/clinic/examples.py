"""Print an example line for each kind of finding of each diagnostic tool.

    delay /scan   1 min   ros2 topic delay /scan
        0.105 s, std dev 0.000 s       (card)
        -0.295 s, std dev 0.000 s      laser clock ahead

Who writes a program that reads findings needs to know their form; numbers and names
are those of one robot, and another has others.  The same three tables in print: the
suspects, the checks, and what each suspect would say.
"""

from __future__ import annotations

from pathlib import Path

from tflab.text import load_yaml

from .checks import CHECKS, unknown_name_error
from .table import COMPLAINTS, SUSPECTS, expected_kind

__all__ = ["EXAMPLES", "checks_as_text", "findings_as_text", "suspects_as_text"]

EXAMPLES: dict[str, dict[str, str]] = load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
WIDEST = 64  # letters of a finding that has its suspects beside it
CARD = {"en": "(card)", "ko": "(카드)"}
MINUTES = {"en": "{minutes:>4g} min", "ko": "{minutes:>4g}분"}


def suspects_as_text(language: str = "en") -> str:
    """Return each complaint, and its three suspects."""
    return "\n".join(
        f"{key}: {getattr(each, language)}\n" + "".join(f"    {suspect}\n" for suspect in each.suspects)
        for key, each in COMPLAINTS.items()
    ).rstrip("\n")


def checks_as_text(language: str = "en") -> str:
    """Return each check by its short name, what it costs, and what is typed."""
    width = max(map(len, CHECKS))
    return "\n".join(
        f"{key:<{width}} {MINUTES[language].format(minutes=check.minutes)}   {check.instruction(language)}"
        for key, check in CHECKS.items()
    )


def findings_as_text(complaint: str = "", language: str = "en") -> str:
    """Return of each check what it says of a healthy robot, and of whom it says something else.

    Args:
        complaint: only its suspects, and the checks that tell them apart; "" for all eighteen and every check.

    Raises:
        ValueError: there is no such complaint.
    """
    if complaint and complaint not in COMPLAINTS:
        raise unknown_name_error(complaint, "no complaint", COMPLAINTS)
    suspects = COMPLAINTS[complaint].suspects if complaint else SUSPECTS
    blocks = []
    for key, check in CHECKS.items():
        who: dict[str, list[str]] = {check.usual: []}
        for suspect in suspects:
            who.setdefault(expected_kind(suspect, key), []).append(suspect)
        if complaint and sum(map(bool, who.values())) < 2:
            continue
        rows = [(EXAMPLES[key][kind], ", ".join(who[kind]) if kind != check.usual else CARD[language]) for kind in who]
        blocks.append(
            f"{key}  {MINUTES[language].format(minutes=check.minutes).strip()}  $ {check.instruction(language)}"
        )
        width = max(len(line) for line, _ in rows)
        between = "   " if width <= WIDEST else "\n        "  # a list of nodes leaves no room beside it
        blocks += [f"    {line:<{width if width <= WIDEST else 0}}{between}{names}" for line, names in rows]
    return "\n".join(blocks)
