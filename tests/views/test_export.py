"""What becomes of a notebook's widgets when it is exported; the page itself is tried in test_scene_browser.py."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
import pytest

from tflab.views.export import export_html, with_mathml
from tflab.views.export_widgets import outputs_from_widget

STATE = "application/vnd.jupyter.widget-state+json"
VIEW = "application/vnd.jupyter.widget-view+json"


def widget(kind: str, **state) -> dict:
    return {"model_name": f"{kind}Model", "model_module": "@jupyter-widgets/controls", "state": state}


def live(scene: str = "AAAAAA==", **state) -> dict:
    buffers = [{"path": ["scene"], "encoding": "base64", "data": scene}]
    module = {"_esm": "export default { render() {} };", "_css": ".of-the-view {}", "_anywidget_id": "x"}
    return {"model_name": "AnyModel", "model_module": "anywidget", "state": state | module, "buffers": buffers}


def words_of(**models: dict) -> list[str]:
    outputs = outputs_from_widget("top", models, {})
    return [output["data"]["text/html"] for output in outputs]


def notebook_at(path, models: dict, shown: tuple[str, ...], source: str = "1 + 1"):
    outputs = [nbformat.v4.new_output("display_data", {VIEW: {"model_id": one}, "text/plain": "view"}) for one in shown]
    cell = nbformat.v4.new_code_cell(source, outputs=outputs, execution_count=1, id="a")
    prose = nbformat.v4.new_markdown_cell("# Title\n\nProse.", id="b")
    notebook = nbformat.v4.new_notebook(cells=[prose, cell], metadata={"widgets": {STATE: {"state": models}}})
    nbformat.write(notebook, path)
    return path


@pytest.mark.parametrize(
    ("model", "text"),
    [
        (widget("FloatSlider", description="yaw:", value=0.5, readout_format=".2f"), "yaw: 0.50"),
        (widget("FloatRangeSlider", description="t", value=[0.0, 1.0], readout_format=".1f"), "t: 0.0 to 1.0"),
        (widget("Checkbox", description="names", value=True), "names: yes"),
        (widget("Dropdown", description="Frame", index=1, _options_labels=["map", "odom"]), "Frame: odom"),
        (widget("Text", description="", value="<b>"), "&lt;b&gt;"),
    ],
)
def test_an_input_stands_as_text_at_its_stored_value_and_a_button_is_left_out(model, text):
    assert words_of(top=model) == [f'<p class="tflab-value">{text}</p>']
    assert words_of(top=widget("Button", description="Go")) == []
    assert words_of(top=widget("Dropdown", description="Frame", index=None, _options_labels=["map"])) == []


def test_what_is_in_a_box_comes_in_its_order_and_live_views_are_counted():
    models = {
        "top": widget("VBox", children=["IPY_MODEL_a", "IPY_MODEL_b", "IPY_MODEL_a"]),
        "a": live(description="3D scene <1>"),
        "b": widget("Label", value="between"),
    }
    first = '<div class="tflab-live" data-view="view-0"><pre>3D scene &lt;1&gt;</pre></div>'
    assert words_of(**models) == [first, "<p>between</p>", first]


def test_what_an_output_widget_held_is_kept_as_it_is():
    stream = {"output_type": "stream", "name": "stdout", "text": "hello"}
    inner = {"output_type": "display_data", "data": {VIEW: {"model_id": "b"}}}
    models = {"top": widget("Output", outputs=[stream, inner]), "b": widget("Label", value="inside")}
    outputs = outputs_from_widget("top", models, {})
    assert outputs[0] == stream
    assert outputs[1]["data"]["text/html"] == "<p>inside</p>"


def test_a_view_whose_state_was_not_stored_says_what_to_do():
    assert words_of() == ["<p><em>This view was not stored; run the notebook to see it.</em></p>"]
    (korean,) = outputs_from_widget("top", {}, {}, "ko")
    assert "저장되지 않았습니다" in korean["data"]["text/html"]


PANEL = {
    "top": widget("VBox", _dom_classes=["tflab-panel"], children=["IPY_MODEL_a", "IPY_MODEL_b", "IPY_MODEL_c"]),
    "a": widget("FloatSlider", description="speed [m/s]", value=0.5, readout_format=".2f"),
    "b": live(description="a robot drives"),
    "c": widget("ToggleButton", description="as text", value=False),
}


@pytest.mark.parametrize(("language", "said"), [("en", "Run the notebook to move it"), ("ko", "실행하면 움직이고")])
def test_a_panel_whose_kernel_is_gone_says_that_it_stands_still_and_how_to_have_its_slider(language, said):
    outputs = outputs_from_widget("top", PANEL, {}, language)
    slider, picture, sentence = (output["data"]["text/html"] for output in outputs)
    assert "speed [m/s]: 0.50" in slider and "a robot drives" in picture
    assert said in sentence and "tflab build --html" in sentence


def exported_image(folder: Path, data: dict, **metadata: dict) -> str:
    """Export a page that shows this, and return the tag of its image."""
    output = nbformat.v4.new_output("display_data", data, metadata=metadata)
    cell = nbformat.v4.new_code_cell("picture", outputs=[output], execution_count=1, id="a")
    nbformat.write(nbformat.v4.new_notebook(cells=[cell]), folder / "page.ipynb")
    (image,) = re.findall(r"<img[^>]*>", export_html(folder / "page.ipynb", folder / "out").read_text(encoding="utf-8"))
    return image


def test_a_drawing_shrinks_with_its_column_by_a_fifth_and_no_more_and_brings_its_words_along(tmp_path):
    svg = '<svg xmlns="http://www.w3.org/2000/svg" width="1087.2" height="9"/>'
    image = exported_image(tmp_path, {"image/svg+xml": svg, "text/plain": "a tree of two"})
    assert 'style="min-width: 870px"' in image
    assert 'alt="a tree of two"' in image


def test_pages_share_their_assets_and_fetch_nothing(tmp_path):
    for name in ("one", "two"):
        notebook = notebook_at(tmp_path / f"{name}.ipynb", {"m": live(description=name)}, ("m",))
        page = export_html(notebook, tmp_path / "site").read_text()
        assert "http" not in "".join(line for line in page.splitlines() if "src=" in line or "<link" in line)
        assert ".of-the-view {}" in page
    assets = sorted({path.name.rsplit("-", 1)[0] for path in (tmp_path / "site" / "assets").iterdir()})
    assert assets == ["live", "meshcat", "meshcat.LICENSE.txt", "module", "style"]
    beside = (tmp_path / "site" / "assets" / "meshcat.LICENSE.txt").read_text(encoding="utf-8")
    for word in ("Robin Deits", "three", "dat.gui", "Permission is hereby granted", "Apache License"):
        assert word in beside
    assert beside in export_html(notebook, tmp_path / "mail", single_file=True).read_text(encoding="utf-8")


def test_the_same_notebook_gives_the_same_bytes(tmp_path):
    def exported(model_id: str, name: str) -> bytes:
        (tmp_path / name).mkdir()
        notebook = notebook_at(tmp_path / name / "page.ipynb", {model_id: live()}, (model_id,))
        return export_html(notebook, tmp_path / name, single_file=True).read_bytes()

    assert exported("4711", "a") == exported("0815", "b")


def test_what_a_view_stores_cannot_end_the_script_it_stands_in(tmp_path):
    notebook = notebook_at(tmp_path / "page.ipynb", {"m": live(words="</script><b>")}, ("m",))
    page = export_html(notebook, tmp_path).read_text()
    assert "</script><b>" not in page


def test_a_page_says_its_language_and_without_live_views_it_has_no_script(tmp_path):
    path = notebook_at(tmp_path / "page.ipynb", {}, ())
    page = export_html(path, tmp_path).read_text()
    assert '<html lang="en">' in page and "Prose." in page and "<script" not in page
    notebook = nbformat.read(path, as_version=4)
    notebook.metadata["tflab"] = {"language": "ko"}
    nbformat.write(notebook, path)
    assert '<html lang="ko">' in export_html(path, tmp_path).read_text()


def test_what_jupyterlab_collapses_is_folded_and_its_heading_stays_in_sight(tmp_path):
    new, collapsed = nbformat.v4, {"jp-MarkdownHeadingCollapsed": True}
    cells = [
        new.new_markdown_cell("# Page", id="page"),
        new.new_markdown_cell("## More\n\nIf you like.", id="more", metadata=collapsed),
        new.new_code_cell("draw()", id="draw", metadata={"jupyter": {"source_hidden": True}}),
        new.new_markdown_cell("## Last", id="last", metadata=collapsed),
        new.new_markdown_cell("### Inside", id="inside", metadata=collapsed),
        new.new_markdown_cell("### So?\n\nIt turned.", id="told", metadata={"tags": ["predicted"]}),
    ]
    nbformat.write(new.new_notebook(cells=cells), tmp_path / "page.ipynb")
    page = export_html(tmp_path / "page.ipynb", tmp_path / "out").read_text(encoding="utf-8")
    folds = re.findall(r'<(details class="[\w-]+|/details|h2 id="\w+|(?:p|pre))\b', page)
    assert folds == [
        'details class="tflab-section', 'h2 id="More', "p", 'details class="tflab-code', "pre", "/details", "/details",
        'details class="tflab-section', 'h2 id="Last', 'details class="tflab-answer', "p", "/details", "/details",
    ]  # fmt: skip
    assert "After your prediction: So?" in page
    assert "<details" not in export_html(tmp_path / "page.ipynb", tmp_path / "deck", folded=False).read_text()


def test_a_picture_brings_its_words_along_and_keeps_its_size(tmp_path):
    data = {"image/png": "AAAA", "text/plain": 'two frames: "map" & odom'}
    image = exported_image(tmp_path, data, **{"image/png": {"width": 76, "height": 38}})
    assert 'alt="two frames: &quot;map&quot; &amp; odom"' in image or "alt='two frames: \"map\" &amp; odom'" in image
    assert 'width="76"' in image and 'height="38"' in image


pytest.importorskip("latex2mathml", reason="no latex2mathml: pip install 'tflab[lab]'")


def test_a_formula_in_a_line_and_one_on_its_own():
    text = with_mathml("It turns by $\\theta$.\n\n$$p = R q + t$$\n")
    assert text.startswith('It turns by <math xmlns="http://www.w3.org/1998/Math/MathML" display="inline">')
    assert 'display="block"' in text
    assert "$" not in text


def test_code_and_prices_stay_as_they_are():
    for text in (
        "in xacro: `${pi/2}` and `$HOME`",
        "```\n$ ros2 topic list $x$\n```",
        "    $ source $HOME/setup.bash $x$",
        "it costs 5$ or 6$ a piece",
        r"a price of \$5 and \$6",
    ):
        assert with_mathml(text) == text
