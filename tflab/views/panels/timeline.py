"""What if I ask a little later?  A slider in front of `timeline`.

The pure function behind it is `tflab.views.timeline.answer`.
"""

from __future__ import annotations

from collections.abc import Sequence

from tflab.core import LATEST, NSEC_PER_SEC, seconds

from ..libraries import ipywidgets as widgets
from ..timeline import Ask, Lane, Timeline, TimelinePicture
from .drawn_ahead import At
from .panel import Panel, slider
from .words import said

STEPS = 400  # of the slider, from end to end


def timeline_panel(
    target_frame: str,
    source_frame: str,
    lanes: Sequence[Lane],
    ask: Ask,
    stamp_ns: int | None = None,
    language: str = "en",
) -> Panel:
    """Return a panel whose query can be dragged past either end of the buffer.

    Args:
        lanes: the edges between the two frames.
        ask: lookup_transform of whoever holds the data.
        stamp_ns: where the query begins [ns]; the middle of the common interval if None.
        language: of the controls, "en" or "ko".

    Raises:
        ValueError: the language is unknown.
    """
    timeline = Timeline(target_frame, source_frame, tuple(lanes))
    left_ns, right_ns = timeline.shown_ns
    if stamp_ns is None:
        stamp_ns = sum(timeline.common_ns or timeline.shown_ns) // 2
    step_s = max(round((right_ns - left_ns) / STEPS / NSEC_PER_SEC, 2), 0.001)
    left_s, right_s = left_ns / NSEC_PER_SEC, right_ns / NSEC_PER_SEC
    query = slider("query", stamp_ns / NSEC_PER_SEC, left_s, right_s, step_s, "s", language)
    query.readout_format = ".3f"
    latest = widgets.Checkbox(
        description="LATEST", tooltip=said("Ask for the newest common time", language), indent=False
    )
    latest.observe(lambda change: setattr(query, "disabled", change.new), names="value")
    picture = TimelinePicture(timeline, ask)

    def move(at: At) -> None:
        picture.show(LATEST if at(latest) else seconds(at(query)))

    title = f"What the buffer knows between {target_frame} and {source_frame}"
    return Panel(title, picture, (query, latest), move, layout=[widgets.HBox([query, latest])], language=language)
