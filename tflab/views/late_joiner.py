"""Draw which transforms a listener knows that joins late.

                    1 2 3 4                       x        o  a message    @  one that the listener received
    calibrator      o o o @=======================x        =  the publisher stores the last one
                                  :
    listener                      ^ joins                  knows: camera_4

A publisher that stores (durability TRANSIENT_LOCAL) keeps its last message for whoever joins, for
as long as it lives. A listener that requests stored messages and a publisher that stores none
(VOLATILE) are never connected.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

STATIC_TOPIC = "/tf_static"
INCOMPATIBLE = "incompatible QoS"
COLUMNS = 60  # how wide a row is in words
ROW_PX, TOP_PX, BOTTOM_PX, KNOWS_PX = 74, 48, 52, 168
BAR = 0.30  # of a row's height
WORDS_END = 0.42  # of a row's height below its middle: the stored message stands above, and no line crosses it
LETTER_PX = 7  # of a name's, in small print
MOST_NAMES = 4  # beside a row


class SentMessage(NamedTuple):
    """One message: when it was sent [s], and the child frames in it."""

    sent_s: float
    frames: tuple[str, ...]


class Sender(NamedTuple):
    """One publisher of transforms.

    Attributes:
        name: of its node.
        messages: what it sends, in order.
        ends_s: when its process ends [s]; None if it does not.
        is_stored: whether it offers TRANSIENT_LOCAL, and so keeps its last message.
        topic: where it publishes.
    """

    name: str
    messages: tuple[SentMessage, ...]
    ends_s: float | None = None
    is_stored: bool = True
    topic: str = STATIC_TOPIC


def messages_received(sender: Sender, join_s: float, until_s: float, asks_for_stored: bool = True) -> list[SentMessage]:
    """Return the messages of a sender that a listener has received by `until_s` [s], if it joined at `join_s` [s].

    Args:
        asks_for_stored: whether the listener requests TRANSIENT_LOCAL on /tf_static, as tf2's does; on /tf it never
            does.
    """
    asks = asks_for_stored and sender.topic == STATIC_TOPIC
    if asks and not sender.is_stored:
        return []
    ends_s = float("inf") if sender.ends_s is None else sender.ends_s
    sent = [message for message in sender.messages if message.sent_s <= until_s and message.sent_s < ends_s]
    before = [message for message in sent if message.sent_s < join_s]
    stored = before[-1:] if asks and join_s < ends_s and join_s <= until_s else []
    return stored + [message for message in sent if message.sent_s >= join_s]


def frames_known(senders: Sequence[Sender], join_s: float, until_s: float, asks_for_stored: bool = True) -> list[str]:
    """Return the child frames that a listener knows at `until_s` [s], each once, in the order of the senders."""
    received = (message for each in senders for message in messages_received(each, join_s, until_s, asks_for_stored))
    return list(dict.fromkeys(frame for message in received for frame in message.frames))


def describe_joins(senders: Sequence[Sender], join_s: float, until_s: float, asks_for_stored: bool) -> str:
    """Return the figure's text: `o` a message, `@` one received, `=` the stored one, `x` the end, `^` the join."""
    width = max(len("listener"), *(len(sender.name) for sender in senders))

    def column(at_s: float) -> int:
        return min(max(int(at_s * COLUMNS / until_s), 0), COLUMNS - 1)

    lines = [f"from 0.0 s to {style.fmt(until_s, 's', 1)}"]
    for sender in senders:
        cells = [" "] * COLUMNS
        for first_s, last_s, _ in _stored_spans(sender, until_s):
            cells[column(first_s) : column(last_s) + 1] = "=" * (column(last_s) + 1 - column(first_s))
        received = messages_received(sender, join_s, until_s, asks_for_stored)
        for mark, messages in (("o", sender.messages), ("@", received)):
            for message in messages:
                cells[column(message.sent_s)] = mark
        if sender.ends_s is not None and sender.ends_s <= until_s:
            cells[column(sender.ends_s)] = "x"
        remark = _remark(sender, len(received), asks_for_stored)
        lines.append(f"{sender.name:<{width}} |{''.join(cells)}| {sender.topic}, {remark}")
    line = " " * column(join_s) + "^"
    lines.append(f"{'listener':<{width}} |{line:<{COLUMNS}}| joins at {style.fmt(join_s, 's', 2)}, "
                 f"{_durability(asks_for_stored)}")  # fmt: skip
    lines.append(f"knows: {', '.join(frames_known(senders, join_s, until_s, asks_for_stored)) or 'nothing'}")
    return "\n".join(lines)


class JoinsPicture(Picture):
    """A row for each sender, and the join; `show` moves the join and says what is known."""

    def __init__(self, senders: Sequence[Sender], until_s: float) -> None:
        """Make a row for each sender, from 0 s to `until_s` [s]."""
        width_px = style.WIDE[0] * style.SCREEN_DPI
        height_px = TOP_PX + ROW_PX * len(senders) + BOTTOM_PX
        super().__init__(style.wide(height_px))
        self._senders, self._until_s = tuple(senders), until_s
        name_px = style.names_width_px(max((sender.name, sender.topic), key=len) for sender in senders)
        axis_px = width_px - name_px - KNOWS_PX
        with style.our_settings():
            self.ax = self.add_axes_px(name_px, BOTTOM_PX, axis_px, ROW_PX * len(senders))
            self._draw_rows(axis_px / until_s)
            self._draw_moving(1 - (KNOWS_PX - 14) / width_px, height_px)

    def show(self, join_s: float, asks_for_stored: bool) -> None:
        """Show a listener that joins at `join_s` [s], asking for what is stored or not."""
        self._join.set_xdata([join_s] * len(self._join.get_ydata()))
        self._join_name.xy = (join_s, 1.0)
        for sender, marks, known in zip(self._senders, self._received, self._known, strict=True):
            received = messages_received(sender, join_s, self._until_s, asks_for_stored)
            row = marks.get_gid()
            marks.set_data([message.sent_s for message in received], [row] * len(received))
            known.set_text(_known_text(sender, received, asks_for_stored))
        self._durability.set_text(_durability(asks_for_stored))
        self.text = describe_joins(self._senders, join_s, self._until_s, asks_for_stored)

    def _draw_rows(self, px_per_s: float) -> None:
        """Draw what stands still: when each message was sent, which one was stored, and the end."""
        ax = self.ax
        ax.set_xlim(0.0, self._until_s)
        style.label_rows(ax, [f"{sender.name}\n{sender.topic}" for sender in self._senders], style.SMALL_PT)
        ax.set_xlabel("time [s]", loc="right")
        how = {"facecolor": style.SHADE, "edgecolor": style.FAINT, "linewidth": 1.0, "zorder": 1}
        for i, sender in enumerate(self._senders):
            ax.axhline(i, color=style.HAIR, linewidth=1.0, zorder=0)
            for first_s, last_s, message in _stored_spans(sender, self._until_s):
                ax.broken_barh([(first_s, last_s - first_s)], (i - BAR / 2, BAR), **how)
                text = "stored: " + ", ".join(message.frames)
                if LETTER_PX * len(text) < (last_s - first_s) * px_per_s - 16:
                    middle_s = (first_s + last_s) / 2
                    ax.annotate(text, (middle_s, i + BAR / 2), (0, -4), textcoords="offset points", ha="center",
                                va="top", color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip
            sent = [message.sent_s for message in sender.messages]
            ax.plot(sent, [i] * len(sent), color=style.INK, linestyle="none", marker="o", markersize=8.0,
                    markerfacecolor=style.PAPER, markeredgewidth=1.4, zorder=3)  # fmt: skip
            if sender.ends_s is not None:
                ax.plot([sender.ends_s], [i], color=style.INK, marker="x", markersize=10.0, markeredgewidth=2.2,
                        linestyle="none", zorder=5)  # fmt: skip

    def _draw_moving(self, knows_x: float, height_px: float) -> None:
        """Make what `show` moves: the join, the messages that are received, and what is known of each sender."""
        ax, write = self.ax, self.figure.text
        heights = [y for i in range(len(self._senders)) for y in (i - 0.5, i + BAR / 2, math.nan, i + WORDS_END)]
        heights.append(len(self._senders) - 0.5)
        (self._join,) = ax.plot([0.0] * len(heights), heights, color=style.ACCENT, linewidth=1.8,
                                linestyle=(0, (4.0, 2.0)), zorder=4)  # fmt: skip
        self._join_name = ax.annotate("join", (0.0, 1.0), (0, 4), xycoords=("data", "axes fraction"), ha="center",
                                      textcoords="offset points", color=style.ACCENT,
                                      fontsize=style.SMALL_PT)  # fmt: skip
        self._received = [
            ax.plot([], [], color=style.ACCENT, linestyle="none", marker="o", markersize=8.0, zorder=6, gid=i)[0]
            for i in range(len(self._senders))
        ]
        write(knows_x, 1 - 10 / height_px, "listener knows", va="top", fontsize=style.TEXT_PT, fontweight="bold")
        self._durability = write(knows_x, 1 - 28 / height_px, "", va="top", color=style.GREY, fontsize=style.SMALL_PT)
        middles = [1 - (TOP_PX + ROW_PX * (i + 0.5)) / height_px for i in range(len(self._senders))]
        self._known = [write(knows_x, y, "", va="center", fontsize=style.SMALL_PT) for y in middles]
        self.moving = [self._join, self._join_name, *self._received, self._durability, *self._known]


def draw_joins(senders: Sequence[Sender], join_s: float, until_s: float) -> JoinsPicture:
    """Draw what a listener knows at `until_s` [s] that joins at `join_s` [s]; see `messages_received`."""
    picture = JoinsPicture(senders, until_s)
    picture.show(join_s, asks_for_stored=True)
    return picture


def _stored_spans(sender: Sender, until_s: float) -> list[tuple[float, float, SentMessage]]:
    """Return from when until when [s] the sender stored each message."""
    if not sender.is_stored:
        return []
    ends_s = until_s if sender.ends_s is None else min(sender.ends_s, until_s)
    moments = [*(message.sent_s for message in sender.messages[1:]), ends_s]
    return [
        (message.sent_s, min(next_s, ends_s), message)
        for message, next_s in zip(sender.messages, moments, strict=False)
        if message.sent_s < ends_s
    ]


def _durability(asks_for_stored: bool) -> str:
    return "TRANSIENT_LOCAL" if asks_for_stored else "VOLATILE"


def _is_incompatible(sender: Sender, asks_for_stored: bool) -> bool:
    return asks_for_stored and sender.topic == STATIC_TOPIC and not sender.is_stored


def _remark(sender: Sender, received: int, asks_for_stored: bool) -> str:
    if _is_incompatible(sender, asks_for_stored):
        return INCOMPATIBLE
    return f"{received} of {len(sender.messages)} heard"


def _known_text(sender: Sender, received: Sequence[SentMessage], asks_for_stored: bool) -> str:
    """Return what is known of a sender as it stands beside its row."""
    if _is_incompatible(sender, asks_for_stored):
        return INCOMPATIBLE
    frames = list(dict.fromkeys(frame for message in received for frame in message.frames))
    if len(frames) > MOST_NAMES:
        frames = [*frames[: MOST_NAMES - 1], f"… {len(frames)} frames"]
    return "\n".join(frames) or "—"
