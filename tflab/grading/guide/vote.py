"""What is a vote?  A question of the page, its options, how many are expected to take each, and what to say to them.

    - name: wheels-hz
      cell: predict            where the question stands; `item: 2` is its second one
      after: rates             the slide after which hands are raised; that of `cell` if left out
      answered: rates          where the page answers it, if later: until then it is a prediction, and only counted
      options:
        - {text: {en: "50", ko: "50번"}, expect: 45, say: {en: ..., ko: ...}}

Where the page replies to each option (a checkpoint), options stand there, and here only
what is expected of each, in their order.  `quote` is how the page words it, if it is not
the text; `unsure: true` is the option of whoever does not know, which no page has to name.

*Peer instruction* (Mazur): below 35 % right explain again, up to 70 % let neighbours
argue and vote again, above that go on.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from tflab.text import Text

from .lecture import LecturedPage
from .teaching import Teaching, as_words

__all__ = ["ARGUE_BELOW", "EXPLAIN_BELOW", "LATER", "RULES", "Vote", "VoteOption", "votes_of"]

EXPLAIN_BELOW, ARGUE_BELOW = 35, 70  # percent of a room that are right
LATER = Text(
    "A prediction: only count. What to say is for the slide “{slide}”, where it is answered.",
    "예측이므로 세기만 합니다. 할 말은 답이 나오는 슬라이드 “{slide}”에서 합니다.",
)
RULES = (
    Text(
        "Below 35 % right: explain it again, another way, then vote anew.",
        "정답이 35 % 미만이면 다르게 다시 설명하고 새로 투표합니다.",
    ),
    Text(
        "35 to 70 %: say nothing yet. Two minutes with a neighbour who chose otherwise, then vote again.",
        "35–70 %이면 아직 설명하지 않습니다. 다른 답을 고른 옆 사람과 2분 동안 이야기하게 하고 다시 투표합니다.",
    ),
    Text(
        "Above 70 %: say one sentence to each wrong option, and go on.",
        "70 %를 넘으면 오답마다 한 문장씩 말하고 넘어갑니다.",
    ),
)
UNSURE = Text("I do not know", "모르겠습니다")


@dataclass(frozen=True)
class VoteOption:
    """One option, in one language.

    Attributes:
        label: what is called out, and stands on the card that is raised.
        expected: the share that is expected to take it before anybody has argued [%].
        say: what to say to it, Markdown.
    """

    label: str
    text: str
    expected: float
    is_right: bool
    say: str


@dataclass(frozen=True)
class Vote:
    """A question to the room, in one language; it follows the cell `after`, and is answered at `answered`, if later.

    Attributes:
        asked: the cell of which the question is the whole text; none if it is a part of one.
    """

    stem: str
    name: str
    after: str
    question: str
    options: tuple[VoteOption, ...]
    answered: str = ""
    asked: str = ""


def votes_of(teaching: Teaching, page: LecturedPage) -> list[Vote]:
    """Return a chapter's votes in the order of the deck; the file fits the page (see `validate.py`)."""
    votes = [_vote(plain, teaching.stem, page) for plain in teaching.votes]
    return sorted(votes, key=lambda vote: page.shown.get(vote.after, 0))


def _vote(plain: Mapping[str, Any], stem: str, page: LecturedPage) -> Vote:
    cell = plain["cell"]
    choices = page.choices(cell) if "item" not in plain else []
    options = []
    for number, row in enumerate(plain["options"], start=1):
        said = as_words(row["say"]).say(page.language) if "say" in row else ""
        if row.get("unsure"):
            label, text = "?", UNSURE.say(page.language)
        elif "text" in row:
            label, text = str(number), as_words(row["text"]).say(page.language)
        else:
            label, text, reply = choices[number - 1]
            said = said or reply
        options.append(VoteOption(label, text, row["expect"], bool(row.get("right")), said))
    question = page.item(cell, plain["item"]) if "item" in plain else page.text(cell)
    asked = "" if "item" in plain else cell
    after, answered = plain.get("after", cell), plain.get("answered", "")
    return Vote(stem, plain["name"], after, question or "", tuple(options), answered, asked)
