"""Export an executed notebook as HTML that works without a kernel and without a network.

    executed notebook  -->  03_target_and_source.html        text, figures, the state of its live views
                            assets/meshcat-1f2e3d4c.js       the 3D viewer      \\
                            assets/module-5a6b7c8d.js        our JavaScript      > once for all pages
                            assets/style-9e8f7a6b.css        Jupyter's style    /

The page works from a disk (file://): 3D turns, a click picks, and each view keeps its scrubber;
other inputs stand as text at their stored values (`export_widgets.py`), and formulas as MathML.
Code and sections that JupyterLab shows collapsed are folded, and so is what a page asks to predict.
With `single_file` everything is in one file. The notebook must have been run with its widgets'
state stored, as nbclient does. Files in `assets` are named after their content.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .export_widgets import WIDGET_VIEW, LiveView, live_view, outputs_from_widget
from .scene import viewer_file

STATIC = Path(__file__).parent / "static"
STATE = "application/vnd.jupyter.widget-state+json"
VIEWER_LICENCES = "meshcat.LICENSE.txt"
LARGE_STYLE = 10_000  # characters; smaller styles stay in the page
COLLAPSED_HEADING = "jp-MarkdownHeadingCollapsed"  # JupyterLab's name for it
HEADING = re.compile(r"(#+) .+\n*")
SMALLEST = 0.8  # a drawing shrinks with its column, but not its letters below what can be read: then it scrolls


class NotANotebook(ValueError):
    """A file that Jupyter could not open; the text names it."""


def read_notebook(path: str | Path) -> Any:
    """Return a notebook as nbformat's node, version 4.

    Raises:
        FileNotFoundError: there is no such notebook.
        NotANotebook: the file is something else.
    """
    import nbformat

    try:
        return nbformat.reads(Path(path).read_text(encoding="utf-8"), as_version=4)
    except (ValueError, AttributeError, nbformat.ValidationError):
        raise NotANotebook(f"{path}: this is no notebook, or a damaged one") from None


def page_language(notebook: Mapping[str, Any]) -> str:
    """Return the language that a page was built in; English if it does not say."""
    return notebook["metadata"].get("tflab", {}).get("language", "en")


def page_title(notebook: Mapping[str, Any]) -> str:
    """Return a page's first heading as plain text; "" if it has none."""
    texts = (cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "markdown")
    found = next(filter(None, (re.search(r"^# +(.+)$", text, re.MULTILINE) for text in texts)), None)
    return re.sub(r"[*`]", "", found[1]).strip() if found else ""


def export_html(
    notebook_path: str | Path, out_dir: str | Path, single_file: bool = False, *, folded: bool = True
) -> Path:
    """Write an executed notebook as HTML into `out_dir`; return the page's path.

    Args:
        folded: fold sections that JupyterLab collapses, and answers to predictions.

    Raises:
        FileNotFoundError: there is no such notebook.
        NotANotebook: the file is something else.
    """
    notebook_path, out_dir = Path(notebook_path), Path(out_dir)
    notebook = read_notebook(notebook_path)
    views = _without_widgets(notebook)
    if folded:
        _mark_folded_sections(notebook.cells)
    page = _page(notebook, page_title(notebook) or notebook_path.stem, page_language(notebook), folded)
    assets = _assets(views)
    if not single_file:
        page, styles = _styles_apart(page)
        assets |= styles
        _write_assets(assets, out_dir / "assets")
    page = page.replace("</head>", _head(assets, views, single_file) + "</head>", 1)
    content, end, rest = page.rpartition("</body>")
    page = content + _foot(views) + end + rest
    out_dir.mkdir(parents=True, exist_ok=True)
    path = out_dir / f"{notebook_path.stem}.html"
    path.write_text(page, encoding="utf-8")
    return path


def _without_widgets(notebook: Any) -> list[LiveView]:
    """Replace every widget in the notebook by what is left of it, and formulas by MathML; return its live views."""
    import nbformat

    language = page_language(notebook)

    models = notebook.metadata.pop("widgets", {}).get(STATE, {}).get("state", {})
    names: dict[str, str] = {}
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = with_mathml(cell.source)
        if cell.cell_type != "code":
            continue
        outputs = []
        for output in cell.outputs:
            view = output.get("data", {}).get(WIDGET_VIEW)
            _say_least_width(output)
            outputs += [output] if view is None else outputs_from_widget(view["model_id"], models, names, language)
        cell.outputs = [nbformat.from_dict(output) for output in outputs]
    return [live_view(name, models[model_id]) for model_id, name in names.items()]


def _mark_folded_sections(cells: Sequence[Any]) -> None:
    """Move the heading of each collapsed section into the metadata of its cell, and mark the section's last cell."""
    depth = 0  # of the section, if one is open
    for before, cell in zip((None, *cells), cells, strict=False):
        heading = HEADING.match(cell.source) if cell.cell_type == "markdown" else None
        if before and heading and len(heading[1]) <= depth:
            before.metadata["section_ends"], depth = True, 0
        if heading and not depth and cell.metadata.get(COLLAPSED_HEADING):  # what is inside a section stays unfolded
            cell.metadata["section"], depth = heading[0], len(heading[1])
            cell.source = cell.source[heading.end() :]
    if depth:
        cells[-1].metadata["section_ends"] = True


def _say_least_width(output: Any) -> None:
    """Write beside a drawing how narrow it may stand, if it says how wide it is."""
    said = re.match(r"<svg[^>]*\swidth=\"([\d.]+)\"", output.get("data", {}).get("image/svg+xml", ""))
    if said:
        output.metadata["image/svg+xml"] = {"least_width": round(SMALLEST * float(said[1]))}


def _page(notebook: Any, title: str, language: str, folded: bool) -> str:
    from jinja2 import FileSystemLoader
    from nbconvert import HTMLExporter

    loaders = [FileSystemLoader(STATIC.parent)]
    exporter = HTMLExporter(extra_loaders=loaders, template_file="export.jinja", language_code=language)
    page, _ = exporter.from_notebook_node(notebook, {"metadata": {"name": title}, "folded": folded})
    return page


def _assets(views: list[LiveView]) -> dict[str, str]:
    """Return the scripts that these views need, by file name."""
    assets = {}
    if any("scene" in view.state or any(b["path"] == ["scene"] for b in view.buffers) for view in views):
        viewer = viewer_file().read_text(encoding="utf-8")
        assets[f"meshcat-{_hash(viewer)}.js"] = viewer
    for esm in sorted({view.esm for view in views}):
        key = _hash(esm)
        assets[f"module-{key}.js"] = f"(globalThis.tflabModules ??= {{}})['{key}'] = {_script_text(esm)};\n"
    if views:
        live = (STATIC / "export.js").read_text(encoding="utf-8")
        assets[f"live-{_hash(live)}.js"] = live
    return assets


def _styles_apart(page: str) -> tuple[str, dict[str, str]]:
    """Take the large styles out of a page; return it with links in their place, and the styles by file name."""
    styles: dict[str, str] = {}

    def link(found: re.Match) -> str:
        if len(found[1]) < LARGE_STYLE:
            return found[0]
        name = f"style-{_hash(found[1])}.css"
        styles[name] = found[1]
        return f'<link rel="stylesheet" href="assets/{name}">'

    return re.sub(r'<style type="text/css">(.*?)</style>', link, page, flags=re.DOTALL), styles


def _write_assets(assets: dict[str, str], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in assets.items():
        if not (folder / name).exists():
            (folder / name).write_text(text, encoding="utf-8")
    if _has_viewer(assets):
        (folder / VIEWER_LICENCES).write_text(_licences(), encoding="utf-8")


def _has_viewer(assets: Mapping[str, str]) -> bool:
    return any(name.startswith("meshcat-") for name in assets)


def _licences() -> str:
    """Return the licences of meshcat's viewer and of all that its file holds, with their texts."""
    parts = json.loads(viewer_file().with_suffix(".js.THIRD_PARTY_LICENSES.json").read_text(encoding="utf-8"))
    texts = [(viewer_file().parents[1] / "LICENSE").read_text(encoding="utf-8")]
    texts += [f"{part['name']} {part['version']}\n\n{part['licenseText']}" for part in parts]
    return f"\n\n{'-' * 72}\n\n".join(text.strip() for text in texts) + "\n"


def _head(assets: dict[str, str], views: list[LiveView], single_file: bool) -> str:
    own = (STATIC / "export.css").read_text(encoding="utf-8")
    style = own + "\n".join(sorted({view.css for view in views}))
    scripts = sorted(
        (name for name in assets if name.endswith(".js")), key=lambda name: (name.startswith("live-"), name)
    )
    if single_file:
        tags = [_inline_script(assets[name], wait=name.startswith("live-")) for name in scripts]
        if _has_viewer(assets):
            tags.append(f'<script type="text/plain" id="{VIEWER_LICENCES}">\n{_licences()}</script>\n')
    else:
        tags = [f'<script defer src="assets/{name}"></script>\n' for name in scripts]
    return f"<style>{style}</style>\n" + "".join(tags)


def _foot(views: list[LiveView]) -> str:
    """Return the state of the live views as the page carries it."""
    if not views:
        return ""
    state = {view.name: {"module": _hash(view.esm), "state": view.state, "buffers": view.buffers} for view in views}
    return f'<script type="application/json" id="tflab-state">{_script_text(state)}</script>\n'


def _inline_script(text: str, wait: bool) -> str:
    """Return a script as part of the page; `wait` runs it once the page is complete."""
    text = text.replace("</script", "<\\/script")
    return f"<script>addEventListener('load', () => {{{text}}});</script>\n" if wait else f"<script>{text}</script>\n"


def _script_text(value: Any) -> str:
    """Return JSON that may stand inside <script>."""
    return json.dumps(value, sort_keys=True).replace("</", "<\\/")


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:8]


FENCES, SPAN, INDENTED = r"```.*?```|~~~.*?~~~", r"(?<!`)(`+)(?!`).*?(?<!`)\1(?!`)", r"^(?: {4}|\t)[^\n]*$"
CODE = re.compile(f"{FENCES}|{SPAN}|{INDENTED}", re.DOTALL | re.MULTILINE)
FORMULA = re.compile(r"(?<![\\$])\$\$(?P<block>[^$]+)\$\$|(?<![\\\w$])\$(?=\S)(?P<line>[^$\n]+?)(?<=\S)\$(?![\w$])")


def with_mathml(markdown: str) -> str:
    """Return Markdown with its formulas as MathML."""
    parts, at = [], 0
    for code in CODE.finditer(markdown):
        parts += [_set(markdown[at : code.start()]), code[0]]
        at = code.end()
    return "".join([*parts, _set(markdown[at:])])


def _set(text: str) -> str:
    return FORMULA.sub(lambda found: _mathml(found["block"] or found["line"], found["block"] is not None), text)


def _mathml(formula: str, block: bool) -> str:
    from latex2mathml.converter import convert  # only where a page has a formula

    return convert(formula.strip(), display="block" if block else "inline")
