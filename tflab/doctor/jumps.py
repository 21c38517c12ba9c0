r"""Was the clock set?  Where the stamps of an edge leave the time of receipt for good.

```
received minus stamp
      |          ________        a clock that was set back: a new level
      |__________|
      |     |                    a message that was late, or overtaken: the old level again
      |_____|____________

''''\____________      a queue that empties, as after a start: no jump, there was no level before
```
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC

__all__ = ["Jump", "find_jumps"]

LEAST_JUMP_S = 0.05
LEAST_PERIODS = 3.0  # less can be a message or two that took another way
LEAST_HABITS = 8.0
FEWEST_SAMPLES = 4  # on either side
OVERTAKING = 4  # samples: who is ahead of the old maximum again so soon, was overtaken
UNSTEADY = 0.5  # of the jump: a level that varies so much is none, but a queue that empties
LEVEL_SAMPLES = 8  # that tell where a level is, before and after a jump


class Jump(NamedTuple):
    """Before sample `index` the clock was set by `size_s` (negative: back)."""

    index: int
    size_s: float


def find_jumps(stamp_ns: np.ndarray, receive_ns: np.ndarray, period_ns: int) -> list[Jump]:
    """Return where a clock was set; both shape (n,), in the order of arrival [ns].

    Only what shows in the stamps themselves counts: they go back, or leap ahead
    further than the time that passed.
    """
    if len(stamp_ns) < 4:
        return []
    offset_s = (receive_ns - stamp_ns) / NSEC_PER_SEC
    change_s = np.diff(offset_s)
    habit_s = 1.4826 * float(np.median(np.abs(change_s - np.median(change_s))))
    least_s = max(LEAST_JUMP_S, LEAST_HABITS * habit_s, LEAST_PERIODS * period_ns / NSEC_PER_SEC)
    stamp_step_s = np.diff(stamp_ns) / NSEC_PER_SEC
    receive_step_s = np.diff(receive_ns) / NSEC_PER_SEC
    is_back = (stamp_step_s < 0.0) & (change_s > least_s)
    is_forward = (change_s < -least_s) & (stamp_step_s > receive_step_s + least_s)
    jumps = []
    for before in np.flatnonzero(is_back | is_forward).tolist():
        after = before + 1
        if min(after, len(stamp_ns) - after) < FEWEST_SAMPLES:
            continue
        earlier_s = offset_s[max(0, after - LEVEL_SAMPLES) : after]
        later_s = offset_s[after : after + LEVEL_SAMPLES]
        shift_s = float(np.median(later_s) - np.median(earlier_s))
        is_overtaken = is_back[before] and stamp_ns[after : after + OVERTAKING].max() > stamp_ns[before]
        is_unsteady = max(np.ptp(earlier_s), np.ptp(later_s)) > UNSTEADY * abs(change_s[before])
        if is_overtaken or is_unsteady:
            continue
        if abs(shift_s) > 0.7 * abs(change_s[before]) and shift_s * change_s[before] > 0.0:
            jumps.append(Jump(after, -shift_s))
    return jumps
