"""Write a report as an HTML page that needs no other file, no network and no script.

    headline
    findings      a card each, worst first: what, evidence, why, what to type next, the moment
    frames in 3D  at the time of each finding
    timeline      when each edge was received
    lookups       which messages can be looked up at their stamp, at once and after a wait
    edges         rate and delay of each edge, as figures and as distributions
    tree          who is whose child, and who publishes it
    checks        made, and not made
    elsewhere     what to look at in Foxglove and in PlotJuggler

`html.jinja` is the page, `html.css` its style, `html.yaml` its headings.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from markupsafe import Markup

from tflab.bags.recording import Recording
from tflab.core import NSEC_PER_SEC, Transform
from tflab.core.inspection import FrameSnapshot, Snapshot
from tflab.text import Texts
from tflab.views.report_page import render, report_page
from tflab.views.tree import draw_tree

from ..checks.clocks import settled_delays_s
from ..collect_evidence import evidence_from_recording
from ..evidence import Edge, Evidence, LookupRow
from ..findings import Finding, Report
from ..lookups import WAITS_S
from .drawings import draw_distribution, draw_frames_at, draw_moment, draw_shares, draw_timeline
from .sentences import describe
from .text import certainty_text, effects_text, headline, moments_text, waits_text

__all__ = ["html_from_report"]

TEXTS = Texts(__file__)
SIGNS = {"error": "✕", "warning": "!", "info": "i"}
MOST_MOMENTS = 12


def html_from_report(report: Report, recording: Recording, language: str = "en") -> str:
    """Return a report as a page of its own, with the pictures of the recording it is about."""
    evidences = [evidence_from_recording(recording, namespace) for namespace in recording.namespaces()]
    of_namespace = {evidence.namespace: evidence for evidence in evidences}
    with_moment = [finding for finding in report.findings if finding.begin_ns and evidences][:MOST_MOMENTS]
    cards, frames = [], []
    for finding in report.findings:
        cards.append(_card(report, finding, language))
        if finding in with_moment:
            evidence = of_namespace.get(finding.namespace, evidences[0])
            figure = f"moment-{with_moment.index(finding) + 1}"
            cards[-1].update(moment=draw_moment(evidence, finding), figure=figure)
            seconds = (finding.begin_ns - report.begin_ns) / NSEC_PER_SEC
            drawn = draw_frames_at(evidence, finding.begin_ns, (finding.parent, finding.child))
            caption = f"{seconds:.2f} s: {describe(finding, language).title}"
            frames.append({"id": figure, "drawn": drawn, "caption": caption})
    if evidences and not frames:
        drawn = draw_frames_at(evidences[0], evidences[0].end_ns)
        frames.append({"id": "", "drawn": drawn, "caption": TEXTS["at_the_end"].say(language)})
    columns = [TEXTS[name].say(language) for name in ("edge", "samples", "steps", "delay", "delays", "silence")]
    columns[2:2], columns[5:5] = ["Hz"], ["p95", "max [ms]"]
    body = render(
        __file__,
        report=report,
        language=language,
        label={name: text.say(language) for name, text in TEXTS.items()},
        outcome=headline(report, language),
        cards=cards,
        frames=frames,
        namespaces=[_namespace(report, evidence, language) for evidence in evidences],
        columns=columns,
        lookups=[_lookup(row, language) for row in report.lookups],
        lookup_columns=[TEXTS["topic"].say(language), "", *(f"{wait_s:g} s" for wait_s in WAITS_S), ""],
    )
    title = TEXTS["title"].say(language, subject=report.subject)
    return report_page(title, language, [body], Path(__file__).with_suffix(".css").read_text(encoding="utf-8"))


def _card(report: Report, finding: Finding, language: str) -> dict[str, object]:
    """Return what the card of a finding shows, without its pictures."""
    effects = effects_text(finding, language) if finding.effects else ""
    return {"severity": finding.severity, "sign": SIGNS[finding.severity], "effects": effects,
            "when": moments_text(report, finding, language), "said": describe(finding, language),
            "certainty": certainty_text(finding, language), "moment": "", "figure": ""}  # fmt: skip


def _namespace(report: Report, evidence: Evidence, language: str) -> dict[str, object]:
    """Return the timeline, the edges and the tree of one namespace."""
    of = TEXTS["of"].say(language, namespace=evidence.namespace) if evidence.namespace else ""
    timeline = draw_timeline(evidence, [f for f in report.findings if f.namespace == evidence.namespace])
    tree = draw_tree(_tree_of(evidence), title="").svg
    return {"of": of, "timeline": timeline, "rows": _rows(evidence), "tree": tree}


def _lookup(row: LookupRow, language: str) -> tuple:
    """Return a row of the table of lookups: as a bar, in figures, and what is waited for."""
    shares = [f"{100.0 * share:.0f} %" for share in row.shares]
    name = f"{row.topic} ({row.frame}) -> {row.fixed}"
    return (name, Markup(draw_shares(row.shares)), *shares, waits_text(row, language))


def _rows(evidence: Evidence) -> list[tuple]:
    """Return rate and delay of each moving edge, as figures and as distributions."""
    rows = []
    for edge, delay_s in zip(evidence.moving, settled_delays_s(evidence), strict=True):
        steps_s = np.diff(np.sort(edge.receive_ns)) / NSEC_PER_SEC
        rate = f"{NSEC_PER_SEC / edge.period_ns:.1f}" if edge.period_ns else ""
        delays = [f"{1e3 * value + 0.0:.0f}" for value in np.percentile(delay_s, (50, 95, 100))]
        silence = f"{steps_s.max():.2f}" if len(steps_s) else ""
        steps, late = Markup(draw_distribution(steps_s)), Markup(draw_distribution(delay_s))
        rows.append((f"{edge.usual_parent} -> {edge.child}", len(edge), rate, steps, *delays, late, silence))
    return rows


def _tree_of(evidence: Evidence) -> Snapshot:
    """Return the tree with everybody who published an edge."""
    of_child: dict[str, list] = {}
    for edge in evidence.edges():
        of_child.setdefault(edge.child, []).append(edge)
    frames = []
    for child, parent in evidence.parent_of.items():
        edges, edge = of_child[child], of_child[child][-1]
        owners = tuple(sorted({owner for e in edges for owner in _owners(e)}))
        rate_hz = NSEC_PER_SEC / edge.period_ns if edge.period_ns and not edge.is_static else 0.0
        span = (0, 0) if edge.is_static else (int(edge.stamp_ns.min()), int(edge.stamp_ns.max()))
        row = (child, parent, edge.is_static, owners, len(edge), rate_hz, *span, Transform())
        frames.append(FrameSnapshot(*row))
    return Snapshot(tuple(evidence.roots()), tuple(frames))


def _owners(edge: Edge) -> set[tuple[str, str]]:
    """Return every (parent, publisher) of an edge; who is not known is ""."""
    pairs = np.unique(np.stack([edge.parent, edge.publisher], axis=1), axis=0).tolist()
    return {(edge.parents[parent], edge.publishers[publisher]) for parent, publisher in pairs}
