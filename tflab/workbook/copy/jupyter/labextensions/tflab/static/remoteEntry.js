// What does JupyterLab not say of a page?  Its language, what a picture shows, and what to do with a widget whose
// kernel is gone.
//
//   image/png + text/plain           <img alt="...">                   JupyterLab drops the words that came along
//   a slider                         its name                          ipywidgets shows it, and does not say it
//   a page of the workbook           its language; no line of code is cut
//   a view whose model is nowhere    the words, and "run this cell"    instead of "model not found"
//
// `tflab lab` brings it along, and an install of tflab puts it where any JupyterLab of the same Python finds it:
// there, notebooks that are none of ours get names for their pictures and sliders, and nothing else.
// Written as JupyterLab loads it, so that nothing has to be built.
(() => {
  const RUN = { en: "Run this cell to see it move.", ko: "이 셀을 실행하면 다시 움직입니다." };

  const style = Object.assign(document.createElement("link"), { rel: "stylesheet" });
  style.href = new URL("tflab.css", document.currentScript.src);
  document.head.append(style);

  const words = (data) => [data?.["text/plain"] ?? ""].flat().join("");

  function name(output) {
    for (const handle of output.querySelectorAll(".widget-slider [role=slider]:not([aria-label])")) {
      handle.setAttribute("aria-label", handle.closest(".widget-slider").querySelector(".widget-label")?.textContent ?? "");
    }
  }

  function describe(output, model, language) {
    const text = words(model.data);
    for (const image of output.querySelectorAll(".jp-RenderedImage img:not([alt])")) image.alt = text;
    name(output);
    if (!language) return;
    for (const view of output.querySelectorAll(".jp-OutputArea-output")) {
      if (!model.data?.["application/vnd.jupyter.widget-view+json"] || !view.textContent.includes("model not found")) continue;
      const said = document.createElement("pre");
      said.textContent = `${text}\n\n${RUN[language]}`;
      view.replaceChildren(said);
    }
  }

  function dress(notebook, language) {
    if (notebook.node.lang !== language) notebook.node.lang = language;
    notebook.node.classList.add("tflab-page");
    const { code, ...others } = notebook.editorConfig;
    if (!code.lineWrap) notebook.editorConfig = { ...others, code: { ...code, lineWrap: true } };
  }

  function describeAll(shell) {
    for (const { content } of shell.widgets("main")) {
      const ours = content?.widgets && content.model?.getMetadata?.("tflab");
      const language = ours && (ours.language === "ko" ? "ko" : "en");
      if (ours) dress(content, language);
      for (const cell of content?.widgets ?? []) {
        const area = cell.outputArea;
        area?.widgets.forEach((output, place) => {
          const model = area.model.get(place);
          if (model) describe(output.node, model, language);
        });
      }
    }
  }

  const plugin = {
    id: "tflab:words",
    description: "Pictures that say what they show, and widgets without a kernel that say what to run.",
    autoStart: true,
    activate: ({ shell }) => {
      let asked = false;
      const look = () => {
        asked = false;
        describeAll(shell);
      };
      new MutationObserver(() => {
        if (!asked) setTimeout(look, 200);
        asked = true;
      }).observe(document.body, { childList: true, subtree: true });
    },
  };

  (window._JUPYTERLAB ??= {}).tflab = { init: () => {}, get: async () => () => ({ __esModule: true, default: plugin }) };
})();
