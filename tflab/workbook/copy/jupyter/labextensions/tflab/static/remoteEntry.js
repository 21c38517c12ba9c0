// What does JupyterLab not say of a page?  Its language, what a picture shows, and what to do with a widget whose
// kernel is gone.
//
//   image/png + text/plain               <img alt="...">           JupyterLab drops the words that came along
//   a panel's picture, and its sliders   their names                ipywidgets shows them, and does not say them
//   a view whose model is nowhere        the words, and "run this cell"    instead of "model not found"
//
// Written as JupyterLab loads it, so that nothing has to be built.
(() => {
  const RUN = { en: "Run this cell to see it move.", ko: "이 셀을 실행하면 다시 움직입니다." };

  const style = Object.assign(document.createElement("link"), { rel: "stylesheet" });
  style.href = new URL("tflab.css", document.currentScript.src);
  document.head.append(style);

  const words = (data) => [data?.["text/plain"] ?? ""].flat().join("");

  function name(output, text) {
    for (const handle of output.querySelectorAll(".widget-slider [role=slider]:not([aria-label])")) {
      handle.setAttribute("aria-label", handle.closest(".widget-slider").querySelector(".widget-label")?.textContent ?? "");
    }
    for (const image of output.querySelectorAll("img.widget-image:not([alt])")) {
      // What it shows changes; the button below, whose title begins with the panel's, says it in words.
      image.alt = image.parentElement.querySelector("button[title]")?.title.split(":")[0] ?? text;
    }
  }

  function describe(output, model, language) {
    const text = words(model.data);
    for (const image of output.querySelectorAll(".jp-RenderedImage img:not([alt])")) image.alt = text;
    name(output, text);
    for (const view of output.querySelectorAll(".jp-OutputArea-output")) {
      if (!model.data?.["application/vnd.jupyter.widget-view+json"] || !view.textContent.includes("model not found")) continue;
      const said = document.createElement("pre");
      said.textContent = `${text}\n\n${RUN[language]}`;
      view.replaceChildren(said);
    }
  }

  function describeAll(shell) {
    for (const { content } of shell.widgets("main")) {
      const language = content?.model?.getMetadata?.("tflab")?.language === "ko" ? "ko" : "en";
      if (content?.widgets && content.node.lang !== language) content.node.lang = language;
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
