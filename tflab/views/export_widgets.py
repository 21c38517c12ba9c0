"""Convert widgets to notebook outputs that work without a kernel.

    VBox                       "speed: 0.50"          a slider, at its stored value
    |-- FloatSlider speed  =>  <live view view-0>     drawn by its own JavaScript, with its scrubber
    |-- Scene                  (image)                what an Output widget held
    `-- Button                                        nothing

A widget that draws itself in the browser (an anywidget) stays live. All others become text.
"""

from __future__ import annotations

from html import escape
from typing import Any, NamedTuple

WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
REFERENCE = "IPY_MODEL_"
NOT_STORED = {
    "en": "This view was not stored; run the notebook to see it.",
    "ko": "이 화면은 저장되지 않았습니다. 노트북을 실행하면 보입니다.",
}
STANDS_STILL = {
    "en": "As it was when the notebook was saved. Run the notebook to move it; a page that tflab build --html writes "
    "keeps a slider.",
    "ko": "노트북을 저장했을 때의 모습입니다. 노트북을 실행하면 움직이고, "
    "tflab build --html로 만든 페이지에는 슬라이더가 하나 남습니다.",
}
PANEL = "tflab-panel"  # the class of a picture with controls that only a kernel can draw anew
FLOAT_SLIDERS, FLOATS = ("FloatSliderModel", "FloatRangeSliderModel"), ".2f"  # JupyterLab saves no form that is usual
WITHOUT_KERNEL_NOTHING = ("ButtonModel", "ToggleButtonModel", "PlayModel", "FileUploadModel", "ControllerModel")

Models = dict[str, dict]  # as stored in a notebook: model id -> model_name, state, buffers
Model = dict[str, Any]


class LiveView(NamedTuple):
    """A widget that still draws itself: its name in the page, and all it knows.

    Attributes:
        state: its traits, but not its code.
        buffers: its binary traits, as the notebook stores them: path, encoding, data.
        esm, css: its code and its style.
    """

    name: str
    state: Model
    buffers: list[Model]
    esm: str
    css: str


def outputs_from_widget(model_id: str, models: Models, names: dict[str, str], language: str = "en") -> list[dict]:
    """Return the widget `model_id`, and all inside it, as notebook outputs; what is missing is said in `language`.

    Live views are named "view-0", "view-1", ... in `names`, in the order they are met.
    """
    model = models.get(model_id)
    if model is None:
        return [_html(f"<p><em>{NOT_STORED[language]}</em></p>")]
    state, kind = model["state"], model["model_name"]
    if kind == "AnyModel":
        name = names.setdefault(model_id, f"view-{len(names)}")
        words = escape(state.get("description") or "\n".join(state.get("words", ())[:1]))
        return [_html(f'<div class="tflab-live" data-view="{name}"><pre>{words}</pre></div>')]
    if "children" in state:
        inside = [reference.removeprefix(REFERENCE) for reference in state["children"]]
        outputs = [output for child in inside for output in outputs_from_widget(child, models, names, language)]
        is_panel = PANEL in state.get("_dom_classes", ())
        return [*outputs, _html(f"<p><em>{STANDS_STILL[language]}</em></p>")] if is_panel else outputs
    if kind == "OutputModel":
        return [
            shown
            for output in state.get("outputs", ())
            for shown in (
                outputs_from_widget(output["data"][WIDGET_VIEW]["model_id"], models, names, language)
                if WIDGET_VIEW in output.get("data", {})
                else [output]
            )
        ]
    if kind == "ImageModel":
        return [_image(model)]
    words = _words(kind, state)
    return [_html(words)] if words else []


def live_view(name: str, model: Model) -> LiveView:
    """Return what the page must know to draw a live view."""
    own = {
        key: value
        for key, value in model["state"].items()
        if not key.startswith("_") and key not in ("layout", "tabbable", "tooltip")
        if not (isinstance(value, str) and value.startswith(REFERENCE))
    }
    esm, css = model["state"]["_esm"], model["state"].get("_css", "")
    return LiveView(name, own, model.get("buffers", []), esm, css)


def _words(kind: str, state: Model) -> str:
    """Return an input as text: what it is called, and its value."""
    if kind in WITHOUT_KERNEL_NOTHING or state.get("value", state.get("index")) is None:
        return ""
    if kind in ("HTMLModel", "HTMLMathModel"):
        return f"<div>{state['value']}</div>"
    value = escape(_value(state, FLOATS if kind in FLOAT_SLIDERS else ""))
    if kind == "LabelModel":
        return f"<p>{value}</p>"
    called = escape(state.get("description") or "").rstrip(": ")
    return f'<p class="tflab-value">{called}: {value}</p>' if called else f'<p class="tflab-value">{value}</p>'


def _value(state: Model, usual_form: str) -> str:
    labels, index = state.get("_options_labels"), state.get("index")
    if labels is not None and index is not None:
        chosen = index if isinstance(index, (list, tuple)) else [index]
        return ", ".join(str(labels[i]) for i in chosen)
    value = state["value"]
    if isinstance(value, bool):
        return "yes" if value else "no"
    values = value if isinstance(value, (list, tuple)) else [value]
    form = state.get("readout_format") or usual_form
    return " to ".join(format(v, form) if isinstance(v, float) and form else str(v) for v in values)


def _image(model: Model) -> dict:
    data = next(buffer["data"] for buffer in model["buffers"] if buffer["path"] == ["value"])
    kind = f"image/{model['state'].get('format', 'png')}"
    return {"output_type": "display_data", "data": {kind: data}, "metadata": {}}


def _html(text: str) -> dict:
    return {"output_type": "display_data", "data": {"text/html": text}, "metadata": {}}
