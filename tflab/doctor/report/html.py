"""How does a report look in a browser?  One file that needs nothing else, in light and in dark.

    headline
    findings      a card each, worst first: what, evidence, why, what to type next
    timeline      when each edge was heard, and how late
    tree          who is whose child
    checks        made, and not made

No network, no scripts: the pictures are in the file.  Read `profile.py` next.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping
from html import escape

from tflab.bags.recording import Recording, namespace_of
from tflab.core import Snapshot
from tflab.views.report_page import report_page
from tflab.views.tree import draw_tree

from ..findings import Finding, Report
from ..gather import evidence_from_recording
from .history import draw_history
from .sentences import Sentences
from .text import headline, moments_text
from .texts import TEXTS, sentences

__all__ = ["html_from_report"]

SIGNS = {"error": "✕", "warning": "!", "info": "i"}

STYLE = """
:root { --error: #b3261e; --warning: #8a5a00; --info: #0b5c8f; }
@media (prefers-color-scheme: dark) { :root { --error: #ff8a80; --warning: #f2c060; --info: #7cc4f4; } }
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
figure img, figure svg { display: block; } ul { padding-left: 1.2rem; color: var(--quiet); }
"""


def html_from_report(report: Report, recording: Recording, texts: Mapping[str, Sentences] = TEXTS) -> str:
    """Return a report as a page of its own, with the pictures of the recording it is about."""
    findings = "\n".join(_card(report, finding, texts) for finding in report.findings)
    pictures = "\n".join(_pictures(report, recording, namespace) for namespace in recording.namespaces())
    subject = escape(report.subject)
    outcome = escape(headline(report).removeprefix(f"{report.subject}: "))
    body = [f"<h1>{subject}</h1>", f'<p class="outcome">{outcome}</p>', findings, pictures, "<h2>Checks</h2>"]
    return report_page(f"{report.subject}: TF report", "en", [*body, _checks(report)], STYLE)


def _card(report: Report, finding: Finding, texts: Mapping[str, Sentences]) -> str:
    said = sentences(finding, texts)
    when = moments_text(report, finding)
    command = f"<p><code>{escape(said.command)}</code></p>" if said.command else ""
    return f"""<article class="{finding.severity}">
<div class="kind"><span class="sign" aria-hidden="true">{SIGNS[finding.severity]}</span>{finding.severity}
<span class="when">{escape(when)}</span></div>
<h3>{escape(said.title)}</h3>
<p>{escape(said.evidence)}</p>
<p class="why">{escape(said.cause)}</p>
{command}
</article>"""


def _pictures(report: Report, recording: Recording, namespace: str) -> str:
    """Return the timeline and the tree of one namespace."""
    evidence = evidence_from_recording(recording, namespace)
    of = f" of {escape(namespace)}" if namespace else ""
    history = draw_history(evidence, report.findings)
    png = b64encode(history.png()).decode()
    tree = draw_tree(_tree_of(recording, namespace), title="")
    return f"""<h2>Timeline{of}</h2>
<figure><img src="data:image/png;base64,{png}" width="{history.size_px[0]}" alt="{escape(history.text, quote=True)}">
</figure>
<h2>Tree{of}</h2>
<figure>{tree.svg}</figure>"""


def _tree_of(recording: Recording, namespace: str) -> Snapshot:
    """Return the tree with everybody who published an edge; a buffer forgets the earlier of two statics."""
    tree = recording.buffer(namespace=namespace).snapshot()
    publishers: dict[str, set[tuple[str, str]]] = {}
    for label in recording.transforms.labels:
        if label.publisher and namespace_of(label.topic) == namespace:
            owner = (label.parent.removeprefix("/"), label.publisher)
            publishers.setdefault(label.child.removeprefix("/"), set()).add(owner)
    frames = []
    for frame in tree.frames:
        owners = publishers.get(frame.name, set()) | {(parent, "") for parent in frame.parents}
        frames.append(frame._replace(owners=tuple(sorted(owners))))
    return tree._replace(frames=tuple(frames))


def _checks(report: Report) -> str:
    made = "".join(f"<li>{escape(name)}</li>" for name in report.checks_made)
    missing = "".join(f"<li>{escape(c.check)}: needs {escape(c.needs)}</li>" for c in report.checks_not_made)
    text = f"<details><summary>{len(report.checks_made)} made</summary><ul>{made}</ul></details>"
    if missing:
        text += f"<details><summary>{len(report.checks_not_made)} not made</summary><ul>{missing}</ul></details>"
    return text
