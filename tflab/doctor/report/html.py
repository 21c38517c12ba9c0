"""How does a report look in a browser?  One file that needs nothing else, in light and in dark.

    headline
    findings      a card each, worst first: what, evidence, why, what to type next, the moment
    frames in 3D  at what was found
    timeline      when each edge was heard
    edges         rate and delay of each edge, as figures and as distributions
    tree          who is whose child, and who says so
    checks        made, and not made
    elsewhere     what to look at in Foxglove and in PlotJuggler

No network, no scripts: the pictures are in the file.
"""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

import numpy as np

from tflab.bags.recording import Recording
from tflab.core import NSEC_PER_SEC, Transform
from tflab.core.snapshot import FrameSnapshot, Snapshot
from tflab.views.report_page import report_page
from tflab.views.tree import draw_tree

from ..checks.clocks import settled_delays_s
from ..evidence import Edge, Evidence
from ..findings import Finding, Report
from ..gather import evidence_from_recording
from .certainty import certainty_of, what_settles
from .history import draw_distribution, draw_moment, draw_timeline
from .scene3d import draw_frames_at
from .sentences import Sentences
from .text import SURE, effects_text, headline, moments_text
from .texts import TEXTS, sentences

__all__ = ["html_from_report"]

SIGNS = {"error": "✕", "warning": "!", "info": "i"}
MOST_MOMENTS = 12
ELSEWHERE = (
    ("Foxglove", "open the bag, add a 3D panel with the root as its display frame and its transforms shown; a Raw "
     "Messages panel on /tf has the stamps, and the Transform Tree panel is the tree above."),
    ("PlotJuggler", "plot translation/x of the edge, once by the time of receipt and once by the header's stamp: "
     "steps, holes and two owners are seen at once."),
)  # fmt: skip

STYLE = """
:root { --error: #b3261e; --warning: #8a5a00; --info: #0b5c8f; }
@media screen and (prefers-color-scheme: dark) {
  :root { --error: #ff8a80; --warning: #f2c060; --info: #7cc4f4; } }
.outcome { color: var(--quiet); margin: .35rem 0 0; }
article { background: var(--card); border: 1px solid var(--line); border-left: 5px solid var(--tone);
  border-radius: 9px; padding: 1rem 1.25rem; margin: .75rem 0; }
.error { --tone: var(--error); } .warning { --tone: var(--warning); } .info { --tone: var(--info); }
article h3 { margin: 0; font-size: 1.05rem; }
.kind { color: var(--tone); font-weight: 650; font-size: .85rem; letter-spacing: .02em; display: flex; gap: .5rem;
  align-items: center; margin-bottom: .2rem; flex-wrap: wrap; }
.sign { width: 1.25rem; height: 1.25rem; border-radius: 50%; border: 1.5px solid var(--tone); display: inline-grid;
  place-items: center; font-size: .78rem; }
.when { color: var(--quiet); font-weight: 400; margin-left: auto; font-variant-numeric: tabular-nums; }
article p { margin: .45rem 0 0; } .why { color: var(--quiet); }
code { background: var(--code); border-radius: 6px; padding: .3rem .6rem; font: .9rem ui-monospace, monospace;
  display: inline-block; }
ul { padding-left: 1.2rem; color: var(--quiet); }
.timeline, .moment { min-width: 46rem; width: 100%; display: block; }
.timeline text, .moment text, .frames text { fill: var(--ink); font: 12px system-ui, sans-serif; }
.timeline .tick, .moment .tick { fill: var(--quiet); } .grid { stroke: var(--line); }
.spoke { fill: var(--ink); } .heard { stroke: var(--ink); fill: none; stroke-width: 1.2; }
.mark { fill: var(--error); } .band { fill: var(--error); opacity: .18; }
.strip { width: 6rem; height: 1.25rem; fill: var(--quiet); vertical-align: middle; }
.frames { width: min(100%, max(20rem, calc(50% - .6rem))); margin: .2rem; background: var(--card);
  border: 1px solid var(--line); border-radius: 9px; }
.frames .dot { fill: var(--quiet); } .frames .view { fill: var(--quiet); }
.frames .link { stroke: var(--quiet); } .axis-x { stroke: #d55e00; } .axis-y { stroke: #009e73; }
.axis-z { stroke: #0072b2; } [class^=axis] { stroke-width: 2.5; }
figcaption { color: var(--quiet); font-size: .9rem; } figure:target figcaption { color: var(--ink); font-weight: 600; }
a { color: var(--info); }
@media screen and (prefers-color-scheme: dark) { .tree svg { filter: invert(.88) hue-rotate(180deg); }
  .axis-x { stroke: #ff9e4a; } .axis-z { stroke: #62b0ee; } }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
th, td { text-align: right; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid var(--line);
  white-space: nowrap; }
th { color: var(--quiet); font-weight: 600; } th:first-child, td:first-child { text-align: left; }
@media print { .timeline, .moment { min-width: 0; } table { font-size: .75rem; } h2 { break-after: avoid; }
  article, figure { break-inside: avoid; } h2:has(+ details) { display: none; } }
"""


def html_from_report(report: Report, recording: Recording, texts: Mapping[str, Sentences] = TEXTS) -> str:
    """Return a report as a page of its own, with the pictures of the recording it is about."""
    evidences = [evidence_from_recording(recording, namespace) for namespace in recording.namespaces()]
    with_moment = [finding for finding in report.findings if finding.begin_ns and evidences][:MOST_MOMENTS]
    cards = [_card(report, finding, evidences, with_moment, texts) for finding in report.findings]
    outcome = escape(headline(report).removeprefix(f"{report.subject}: "))
    body = [f"<h1>{escape(report.subject)}</h1>", f'<p class="outcome">{outcome}</p>', *cards]
    if evidences:
        body += ["<h2>Frames in 3D</h2>", *_frames(report, evidences, with_moment, texts)]
    body += [_pictures(report, evidence) for evidence in evidences]
    body += ["<h2>Checks</h2>", _checks(report), "<h2>Elsewhere</h2>"]
    body.append(f"<ul>{''.join(f'<li>{escape(tool)}: {escape(what)}</li>' for tool, what in ELSEWHERE)}</ul>")
    return report_page(f"{report.subject}: TF report", "en", body, STYLE)


def _card(report: Report, finding: Finding, evidences: list[Evidence], with_moment: list[Finding], texts) -> str:
    said = sentences(finding, texts)
    lines = [f"<p>{escape(said.evidence)}</p>", f'<p class="why">{escape(said.cause)}</p>']
    if finding.effects:
        lines.append(f'<p class="why">Also: {escape(effects_text(finding, texts))}</p>')
    certainty = certainty_of(finding.code)
    if certainty != "certain":
        settled = escape(f"{SURE[certainty]}; to settle it: {what_settles(finding.code)}")
        lines.append(f'<p class="why">How sure: {settled}</p>')
    if said.command:
        lines.append(f"<p><code>{escape(said.command)}</code></p>")
    if finding in with_moment:
        drawn = draw_moment(_evidence_of(evidences, finding), finding)
        if drawn:
            lines.append(f"<details><summary>the moment, sample by sample</summary><figure>{drawn}</figure></details>")
        lines.append(f'<p><a href="#{_moment(with_moment, finding)}">the frames at that moment, in 3D</a></p>')
    body = "\n".join(lines)
    return f"""<article class="{finding.severity}">
<div class="kind"><span class="sign" aria-hidden="true">{SIGNS[finding.severity]}</span>{finding.severity}
<span class="when">{escape(moments_text(report, finding))}</span></div>
<h3>{escape(said.title)}</h3>
{body}
</article>"""


def _moment(with_moment: list[Finding], finding: Finding) -> str:
    """Return the id of the frames that a finding's link opens."""
    return f"moment-{with_moment.index(finding) + 1}"


def _evidence_of(evidences: list[Evidence], finding: Finding) -> Evidence:
    """Return the namespace that a finding is about."""
    return next((evidence for evidence in evidences if evidence.namespace == finding.namespace), evidences[0])


def _frames(report: Report, evidences: list[Evidence], with_moment: list[Finding], texts) -> list[str]:
    """Return the frames in 3D at the moment of each finding, at the end if there is none."""
    figures = []
    for finding in with_moment:
        seconds = (finding.begin_ns - report.begin_ns) / NSEC_PER_SEC
        caption = escape(f"{seconds:.2f} s: {sentences(finding, texts).title}")
        drawn = draw_frames_at(_evidence_of(evidences, finding), finding.begin_ns, (finding.parent, finding.child))
        figures.append(
            f'<figure id="{_moment(with_moment, finding)}">{drawn}<figcaption>{caption}</figcaption></figure>'
        )
    at_the_end = draw_frames_at(evidences[0], evidences[0].end_ns)
    return figures or [f"<figure>{at_the_end}<figcaption>at the end</figcaption></figure>"]


def _pictures(report: Report, evidence: Evidence) -> str:
    """Return the timeline, the edges and the tree of one namespace."""
    of = f" of {escape(evidence.namespace)}" if evidence.namespace else ""
    timeline = draw_timeline(evidence, [f for f in report.findings if f.namespace == evidence.namespace])
    tree = draw_tree(_tree_of(evidence), title="")
    drawn = f"<h2>Timeline{of}</h2>\n<figure>{timeline}</figure>\n" if timeline else ""
    return f"""{drawn}<h2>Edges{of}</h2>
<figure>{_table(evidence)}</figure>
<h2>Tree{of}</h2>
<figure class="tree">{tree.svg}</figure>"""


def _table(evidence: Evidence) -> str:
    """Return rate and delay of each moving edge, as figures and as distributions."""
    if not evidence.moving:
        return "<p>Nothing moves.</p>"
    names = ("edge", "samples", "Hz", "steps", "delay p50", "p95", "max [ms]", "delays", "silence [s]")
    rows = ["<tr>" + "".join(f"<th>{name}</th>" for name in names) + "</tr>"]
    for edge, delay_s in zip(evidence.moving, settled_delays_s(evidence), strict=True):
        steps_s = np.diff(np.sort(edge.receive_ns)) / NSEC_PER_SEC
        rate = f"{NSEC_PER_SEC / edge.period_ns:.1f}" if edge.period_ns else ""
        delays = [f"{1e3 * value + 0.0:.0f}" for value in np.percentile(delay_s, (50, 95, 100))]
        silence = f"{steps_s.max():.2f}" if len(steps_s) else ""
        cells = (escape(f"{edge.usual_parent} -> {edge.child}"), str(len(edge)), rate, draw_distribution(steps_s),
                 *delays, draw_distribution(delay_s), silence)  # fmt: skip
        rows.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    return f"<table>{''.join(rows)}</table>"


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


def _checks(report: Report) -> str:
    made = "".join(f"<li>{escape(name)}</li>" for name in report.checks_made)
    missing = "".join(f"<li>{escape(c.check)}: needs {escape(c.needs)}</li>" for c in report.checks_not_made)
    text = f"<details><summary>{len(report.checks_made)} made</summary><ul>{made}</ul></details>"
    if missing:
        text += f"<details><summary>{len(report.checks_not_made)} not made</summary><ul>{missing}</ul></details>"
    return text
