"""Collect submissions from a folder, a zip or a notebook: one for each learner.

    s101/exercises/en/E03_target_and_source.ipynb        a folder for each learner
    s101/hw1/03_target_and_source.ipynb                 as nbgrader collects
    Kim Minji_4711_assignsubmission_file_/03.ipynb      as Moodle gives it
    kimminji_4711_98765_03.ipynb                        as Canvas gives it
    s101.ipynb, s101_03_target_and_source.ipynb         a folder of notebooks
    03_target_and_source/s101.ipynb                     a folder for each chapter

Files are only listed here, and read when their turn comes.  Whose they are is said
first by where they were found, then by the sealed stamp in the notebook; what is inside
a zip never says it.  Nobody's hand-in adds to what another has handed in.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, count
from pathlib import Path
from typing import NamedTuple

from .archives import Member
from .listing import MAX_NOTEBOOKS, few_of_each, is_notebook, largest, listed
from .remarks import Remark
from .roster import IsGenuine, Learner, StampsIn, group_of, is_lms_name, owner_of, read_stamps, stamped_for

__all__ = ["Collection", "Submission", "collect"]

WRAPPERS = {"submitted", "submissions", "submission", "exercises"}


@dataclass(frozen=True)
class Submission:
    """What one learner handed in.

    Attributes:
        learner: the id: the roster's, else the name that the files go by.
        notebooks: the files that call themselves notebooks.
        remarks: one line each, on what is odd about how it was handed in.
    """

    learner: str
    notebooks: tuple[Member, ...]
    remarks: tuple[Remark, ...] = ()
    known: bool = True


@dataclass(frozen=True)
class Collection:
    """Every submission, in the order of the roster, then by name, and remarks on what belongs to nobody."""

    submissions: tuple[Submission, ...]
    remarks: tuple[Remark, ...] = ()


class HandIn(NamedTuple):
    """What goes by one name: the name, the number that a learning system has for it, the files, and whose it is.

    `contested` is whose it would be, if others did not go by that name, too.
    """

    name: str
    number: str
    members: list[Member]
    owner: str | None
    stamp: str | None = None
    contested: str | None = None

    @property
    def is_the_id(self) -> bool:
        """Whether it is called by its owner's id, and by nothing else."""
        return not self.number and self.name == self.owner

    @property
    def called(self) -> str:
        """The name as it can stand in a report; a number tells two of one name apart."""
        return _printable(f"{self.name}_{self.number}" if self.number else self.name)


StampOf = Callable[[HandIn], str | None]  # for whom a hand-in was handed out, by the stamps in it


def collect(
    place: Path,
    roster: Mapping[str, Learner] | None,
    chapters: Sequence[str],
    leave_out: Sequence[Path] = (),
    *,
    is_genuine: IsGenuine,
    stamps_in: StampsIn = read_stamps,
) -> Collection:
    """Return what there is in a folder, a zip or a notebook; with a roster, one submission for each who is on it.

    Args:
        leave_out: folders that are no submissions, wherever they are: the results, the pack.
        is_genuine: whether a notebook's stamp is as it was handed out.
        stamps_in: reads the stamps in files; what strangers made may be read in a process of its own.

    Raises:
        Unreadable: there is no such thing, or it cannot be listed.
    """
    people = roster or {}
    members, remarks = listed(place, {path.resolve() for path in leave_out})
    members = few_of_each(_by_learner(_unwrapped(members, people), people, chapters))
    found: dict[str, Submission] = {}
    stamp_of = _stamp_of(people, is_genuine, stamps_in)
    for hand_in in _with_owners(_hand_ins(members, chapters), people, stamp_of):
        submission = _submission(hand_in, _strange(hand_in, found) if roster else (), roster is None)
        if not roster or not submission.known:
            submission = replace(submission, learner=_own_name(submission.learner, {*people, *found}))
        there = found.get(submission.learner)
        found[submission.learner] = _together(there, submission, hand_in) if there else submission
    on_roster = [found.pop(learner, Submission(learner, (), (Remark("no file"),))) for learner in people]
    return Collection((*on_roster, *(found[learner] for learner in sorted(found))), tuple(remarks))


# -- whose is it? --------------------------------------------------------------------------


def _stamp_of(roster: Mapping[str, Learner], is_genuine: IsGenuine, stamps_in: StampsIn) -> StampOf:
    """Return what says for whom a hand-in was handed out; each is read once, and of it no more than is graded."""
    said: dict[int, str | None] = {}  # by the list of the files: it is there as long as this is

    def stamp_of(hand_in: HandIn) -> str | None:
        key = id(hand_in.members)
        if key not in said:
            counted = largest([member for member in hand_in.members if is_notebook(member)], MAX_NOTEBOOKS)
            said[key] = stamped_for(counted, roster, is_genuine, stamps_in)
        return said[key]

    return stamp_of


def _hand_ins(members: Sequence[Member], chapters: Sequence[str]) -> list[HandIn]:
    """Return the files by the names that they go by."""
    groups: dict[tuple[str, str], list[Member]] = {}
    for member in members:
        groups.setdefault(group_of(member.parts, chapters), []).append(member)
    return [HandIn(name, number, group, None) for (name, number), group in sorted(groups.items())]


def _with_owners(hand_ins: Sequence[HandIn], roster: Mapping[str, Learner], stamp_of: StampOf) -> list[HandIn]:
    """Return the hand-ins with their owners, those first whose owner is said by where they were found."""
    if not roster:
        return sorted(hand_ins, key=lambda hand_in: hand_in.name != hand_in.called)  # who is called just so comes first
    by_path = [
        hand_in._replace(owner=owner_of(hand_in.name, roster, whole=bool(hand_in.number))) for hand_in in hand_ins
    ]
    settled = [_settled(hand_in, by_path, stamp_of) for hand_in in by_path]
    said = [hand_in for hand_in in settled if hand_in.owner is not None]
    left = [hand_in for hand_in in settled if hand_in.owner is None]
    return [*said, *(hand_in._replace(stamp=stamp_of(hand_in)) for hand_in in left)]


def _settled(hand_in: HandIn, all_: Sequence[HandIn], stamp_of: StampOf) -> HandIn:
    """Return a hand-in with its owner by where it was found, or without one where it may be another person's.

    A learning system's numbers are different people, and the names that it shows can be changed to somebody else's:
    then the seal in the notebook says who it is. A place that is called by the id alone is that person's. Any other
    name is an instructor's; beside it, what was handed out to somebody else is not taken for that person's.
    """
    owner = hand_in.owner
    if owner is None or hand_in.is_the_id:
        return hand_in
    rivals = [other for other in all_ if other.owner == owner and other is not hand_in]
    if not rivals and not hand_in.number:
        return hand_in
    stamp = stamp_of(hand_in)
    if not rivals:  # a copy of what another handed in, too, is whose place it is in
        is_moved = stamp not in (None, owner) and all(other.owner != stamp for other in all_)
        return hand_in._replace(owner=None) if is_moved else hand_in
    return hand_in if _is_the_one(hand_in, stamp, rivals, stamp_of) else hand_in._replace(owner=None, contested=owner)


def _is_the_one(hand_in: HandIn, stamp: str | None, rivals: Sequence[HandIn], stamp_of: StampOf) -> bool:
    """Return whether a hand-in stays its owner's beside others that were found for the same."""
    if not hand_in.number:  # some systems show a learner's own words only: beside the owner's seal they say nothing
        is_sealed_elsewhere = any(stamp_of(other) == hand_in.owner for other in rivals)
        return stamp == hand_in.owner or (stamp is None and not is_sealed_elsewhere)
    others = [stamp_of(other) for other in rivals if other.number]
    return stamp == hand_in.owner and hand_in.owner not in others


def _strange(hand_in: HandIn, found: Mapping[str, Submission]) -> tuple[Remark, ...]:
    """Return what is strange about whose it is; a stamp is easily copied: it never adds to what somebody handed in."""
    if hand_in.owner is not None:
        return ()
    if hand_in.stamp in (None, hand_in.contested):
        return (Remark("contested" if hand_in.contested else "nobody", stamp=hand_in.called),)
    return (Remark("stamped", stamp=hand_in.stamp),) if hand_in.stamp in found else ()


def _submission(hand_in: HandIn, strange: tuple[Remark, ...], everybody_is_known: bool) -> Submission:
    notebooks = tuple(filter(is_notebook, hand_in.members))
    others = {member.parts[-1] for member in hand_in.members} - {member.parts[-1] for member in notebooks} - {""}
    remarks = list(strange)
    if not notebooks:
        remarks.append(Remark("no notebook", stamp=_few(sorted(others))) if others else Remark("empty"))
    if len(notebooks) > MAX_NOTEBOOKS:
        remarks.append(Remark("many", ours=MAX_NOTEBOOKS))
    learner = None if strange else hand_in.owner or hand_in.stamp
    is_known = everybody_is_known or learner is not None
    return Submission(learner or hand_in.called, tuple(largest(notebooks, MAX_NOTEBOOKS)), tuple(remarks), is_known)


def _together(there: Submission, more: Submission, hand_in: HandIn) -> Submission:
    """Return as one what a learner handed in at two places; what lies beside a notebook is not worth a line."""
    if bool(there.notebooks) != bool(more.notebooks):
        return there if there.notebooks else more
    remarks = (*there.remarks, *more.remarks, Remark("places", stamp=hand_in.called))
    return replace(more, notebooks=there.notebooks + more.notebooks, remarks=remarks)


# -- what stands above the learners' folders -----------------------------------------------


def _unwrapped(members: list[Member], roster: Mapping[str, Learner]) -> list[Member]:
    """Return the members without a folder that they all share and that is nobody's."""
    while members:
        tops = {member.parts[0] for member in members}
        inside = {member.parts[1] for member in members if len(member.parts) > 2}
        top = next(iter(tops))
        if len(tops) > 1 or any(len(member.parts) == 1 for member in members) or top in roster:
            return members
        if not (top.lower() in WRAPPERS or any(owner_of(name, roster) for name in inside)):
            return members
        members = [_without_top(member) for member in members]
    return members


def _by_learner(members: list[Member], roster: Mapping[str, Learner], chapters: Sequence[str]) -> list[Member]:
    """Return the members without the folders above the learners', one for each chapter or each assignment."""
    folders = {member.parts[0] for member in members if len(member.parts) > 1}
    strange = {folder for folder in folders if not _is_somebodys(folder, roster)}
    if roster and strange == folders and _is_everybody_known(members, roster, chapters):
        strip = folders  # nobody's folders, and somebody's in each
    else:
        zips = {member.parts[0] for member in members if member.outside == 1}  # somebody's, whatever is in it
        strip = {folder for folder in strange - zips if _is_a_chapters(folder, members, roster, chapters)}
    return [
        _without_top(member) if len(member.parts) > 1 and member.parts[0] in strip else member for member in members
    ]


def _without_top(member: Member) -> Member:
    return replace(member, parts=member.parts[1:], outside=max(0, member.outside - 1))


def _is_somebodys(folder: str, roster: Mapping[str, Learner]) -> bool:
    return is_lms_name(folder) or bool(owner_of(folder, roster))


def _is_everybody_known(members: Sequence[Member], roster: Mapping[str, Learner], chapters: Sequence[str]) -> bool:
    below = {member.parts[1] for member in members if len(member.parts) > 1}
    return all(owner_of(group_of((name,), chapters)[0], roster) for name in below)


def _is_a_chapters(
    folder: str, members: Sequence[Member], roster: Mapping[str, Learner], chapters: Sequence[str]
) -> bool:
    """Return whether a folder that has a chapter's name holds learners, and is not a learner's own."""
    if folder in chapters or not any(chapter in folder for chapter in chapters):
        return folder in chapters
    inside = {group_of(member.parts[1:2], chapters)[0] for member in members if member.parts[0] == folder}
    if roster:
        return all(owner_of(name, roster) for name in inside)
    return len(inside) > 1 and not inside & set(chapters)


# -- what is said --------------------------------------------------------------------------


def _printable(key: str) -> str:
    """Return a name that can stand in a report and as a file's name."""
    key = unicodedata.normalize("NFC", key)
    return (
        "".join(letter if letter.isprintable() and letter not in '/\\:*?"<>|' else "_" for letter in key)[:64].strip(
            " ."
        )
        or "unnamed"
    )


def _own_name(name: str, taken: Container[str]) -> str:
    """Return a name that nobody else goes by, though it was written otherwise: "s0 (2)" for "s0 " beside "s0"."""
    numbered = (f"{name} ({number})" for number in count(2))
    return next(own for own in chain([name], numbered) if own not in taken)


def _few(names: list[str]) -> str | Remark:
    shown = ", ".join(_printable(name) for name in names[:3])
    return shown if len(names) <= 3 else Remark("and more", names=shown, count=len(names) - 3)
