// What does JupyterLab not say of a page?  Its language, what a picture shows, what to do with a widget whose
// kernel is gone, and that nothing in it was changed.
//
//   image/png, svg + text/plain      <img alt="...">                   JupyterLab drops the words that came along
//   a slider                         its name                          ipywidgets shows it, and does not say it
//   a menu, a button, a handle       its own keys                      JupyterLab takes them for its shortcuts
//   Escape in an output              back to its cell                  nothing else leads out of a 3D view but the mouse
//   a page of the workbook           its language; no line of code is cut
//   a view whose model is nowhere    the words, and "run this cell"    instead of "model not found"
//   a name, in a new kernel          what to run first                 the page's first cell would say so, had it run
//   hint(E1.2)                       that the number is a word         Python's words are "invalid syntax"
//   a kernel that says what it is    a page is not unsaved for that   JupyterLab writes it into the page
//   a drawing wider than its column  smaller, as far as it can be read; then it scrolls, and says so
//   a dotted word                    reached by key, and by touch      its explanation waits for a pointer
//   a narrow window                  the list of files is folded       of a page nothing could be read
//
// `tflab lab` brings it along, and an install of tflab puts it where any JupyterLab of the same Python finds it:
// there, notebooks that are none of ours get names for their pictures and sliders, keys for their menus, and nothing
// else.
// Written as JupyterLab loads it, so that nothing has to be built.
(() => {
  const RUN = { en: "Run this cell to see it move.", ko: "이 셀을 실행하면 다시 움직입니다." };

  const FIRST = {
    en: "The page's first cell has not run in this kernel. Run it first (or all of them: Run → Run All Above Selected Cell), then this cell again.",
    ko: "이 커널에서는 페이지의 첫 셀을 아직 실행하지 않았습니다. 첫 셀을 먼저 실행한 다음(Run → Run All Above Selected Cell을 고르면 위의 셀을 모두 실행합니다) 이 셀을 다시 실행하세요.",
  };

  const QUOTES = {
    en: 'A task\'s number stands in quotes: hint("E1.2"), check("E1.2", …).',
    ko: '과제 번호는 따옴표 안에 씁니다: hint("E1.2"), check("E1.2", …).',
  };

  const NEAR = {
    en: (said, meant) => `There is no ${said}. Did you mean ${meant}?`,
    ko: (said, meant) => `그런 이름은 없습니다: ${said}. 혹시 ${meant}입니까?`,
  };

  const TYPED = {
    en: "A command of the terminal begins with ! in a cell: !tflab.",
    ko: "셀에서 터미널 명령을 실행하려면 앞에 !를 붙입니다: !tflab",
  };

  const style = Object.assign(document.createElement("link"), { rel: "stylesheet" });
  style.href = new URL("tflab.css", document.currentScript.src);
  document.head.append(style);

  const words = (data) => [data?.["text/plain"] ?? ""].flat().join("");

  function name(output) {
    for (const handle of output.querySelectorAll(".widget-slider [role=slider]:not([aria-label])")) {
      handle.setAttribute("aria-label", handle.closest(".widget-slider").querySelector(".widget-label")?.textContent ?? "");
    }
  }

  // An arrow in a menu would go to another cell, and a letter typed there may delete one.
  function keepKeys(output) {
    for (const control of output.querySelectorAll(".jupyter-widgets :is(select, button, [tabindex])")) {
      control.dataset.lmSuppressShortcuts = "true";
    }
  }

  const SMALLEST = 0.8;
  const columns = new ResizeObserver((all) => all.forEach(({ target }) => {
    const scrolls = target.toggleAttribute("data-scrolls", target.scrollWidth > target.clientWidth + 1);
    target.tabIndex = scrolls ? 0 : -1; // reached by key
  }));

  function shrink(output) {
    for (const image of output.querySelectorAll(".jp-RenderedSVG img:not([style])")) {
      if (!image.complete) {
        image.addEventListener("load", () => shrink(output), { once: true });
        continue;
      }
      Object.assign(image.style, { maxWidth: "100%", minWidth: `${Math.round(SMALLEST * image.naturalWidth)}px`, height: "auto" });
      columns.observe(image.parentElement);
    }
  }

  // What the first cell brings along: of anything else, a word that is not found is a slip.
  const MAGICS = /magic function `%(ros2|rviz2|turtlesim)` not found/;
  const PACKAGES = new Set([
    "action_msgs", "actionlib_msgs", "ament_index_python", "builtin_interfaces", "cv_bridge", "diagnostic_msgs",
    "example_interfaces", "geometry_msgs", "launch", "launch_ros", "lifecycle_msgs", "message_filters", "nav_msgs",
    "rcl_interfaces", "rclpy", "rosgraph_msgs", "sensor_msgs", "sensor_msgs_py", "service_msgs", "shape_msgs",
    "std_msgs", "std_srvs", "stereo_msgs", "tf2_geometry_msgs", "tf2_msgs", "tf2_py", "tf2_ros", "tf2_sensor_msgs",
    "tf_transformations", "trajectory_msgs", "turtlesim", "type_description_interfaces", "unique_identifier_msgs",
    "visualization_msgs",
  ]);

  // Once the first cell has run, tflab itself says what to do about a name that is not there, in an output of its own.
  function isTooEarly(model, isLast) {
    if (!isLast) return false;
    const { ename, evalue } = model.data?.["application/vnd.jupyter.error"] ?? {};
    const missing = /^No module named '(\w+)'$/.exec(evalue)?.[1];
    return ename === "NameError" || PACKAGES.has(missing) || MAGICS.test(model.data?.["application/vnd.jupyter.stderr"] ?? "");
  }

  function isUnquoted(model) {
    const { ename, traceback } = model.data?.["application/vnd.jupyter.error"] ?? {};
    const plain = (traceback ?? []).join("\n").replace(/\x1b\[[\d;]*m/g, ""); // without colours
    return ename === "SyntaxError" && /\b(task|check|hint|solution)\(\s*[Ee]\d+\.\d/.test(plain);
  }

  // What was meant by a name that is not there: ROS 2's tools or its window, a command of the terminal, tflab itself.
  function meant(model, language) {
    const { evalue } = model.data?.["application/vnd.jupyter.error"] ?? {};
    const missing = /^No module named '(tfl\w*|flab|tlab)'$/.exec(evalue)?.[1];
    if (missing && missing !== "tflab") return NEAR[language](missing, "tflab");
    const magic = /magic function `%(\w+)` not found/.exec(model.data?.["application/vnd.jupyter.stderr"] ?? "")?.[1] ?? "";
    if (magic === "tflab") return TYPED[language];
    if (!/^r[ov]/.test(magic) || /^(ros2|rviz2)$/.test(magic)) return "";
    return NEAR[language](`%${magic}`, magic.startsWith("ro") ? "%ros2" : "%rviz2");
  }

  // What to do about an error, if we know; below it, not beside it.
  function advise(output, advice) {
    const said = output.querySelector(".tflab-advice");
    if (said?.textContent === advice) return;
    said?.remove();
    if (!advice) return;
    const words = Object.assign(document.createElement("p"), { className: "tflab-advice", textContent: advice });
    output.querySelector(".jp-OutputArea-output")?.append(words);
  }

  function describe(output, model, language, isLast) {
    const text = words(model.data);
    for (const image of output.querySelectorAll(":is(.jp-RenderedImage, .jp-RenderedSVG) img:not([alt])")) image.alt = text;
    name(output);
    keepKeys(output);
    if (!language) return;
    shrink(output);
    advise(output, isTooEarly(model, isLast) ? FIRST[language] : isUnquoted(model) ? QUOTES[language] : meant(model, language));
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

  // In a narrow window the list of files leaves a page a few letters a line. Whoever opens it again keeps it.
  let hasRoom = false;

  function makeRoom(shell) {
    if (!hasRoom && innerWidth < 800) shell.collapseLeft?.();
    hasRoom = true;
  }

  function describeAll(shell) {
    for (const widget of shell.widgets("main")) {
      const { content } = widget;
      watch(widget);
      const ours = content?.widgets && content.model?.getMetadata?.("tflab");
      const language = ours && (ours.language === "ko" ? "ko" : "en");
      if (ours) makeRoom(shell);
      if (ours) dress(content, language);
      if (ours) for (const word of content.node.querySelectorAll("abbr[title]:not([tabindex])")) word.tabIndex = 0;
      for (const cell of content?.widgets ?? []) {
        const area = cell.outputArea;
        area?.widgets.forEach((output, place) => {
          const model = area.model.get(place);
          if (model) describe(output.node, model, language, place === area.model.length - 1);
        });
      }
    }
  }

  // On opening, the kernel's own name and version go into a page, and JupyterLab calls it unsaved.
  function keepClean({ model }) {
    const written = () => JSON.stringify(model.toJSON().cells);
    const opened = written();
    const look = (_, change) => {
      if (change.name !== "dirty" || !change.newValue) return;
      if (written() === opened) model.dirty = false;
      else model.stateChanged.disconnect(look);
    };
    model.stateChanged.connect(look);
    look(model, { name: "dirty", newValue: model.dirty }); // a quick kernel was there first
  }

  const watched = new WeakSet();

  function watch({ context }) {
    if (!context?.ready || watched.has(context)) return;
    watched.add(context);
    context.ready.then(() => context.model.getMetadata?.("tflab") && keepClean(context));
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
      document.addEventListener("keydown", ({ key, target }) => {
        if (key === "Escape") target.closest?.(".jp-OutputArea-output")?.closest(".jp-Cell")?.focus();
      });
      new MutationObserver(() => {
        if (!asked) setTimeout(look, 200);
        asked = true;
      }).observe(document.body, { childList: true, subtree: true });
    },
  };

  (window._JUPYTERLAB ??= {}).tflab = { init: () => {}, get: async () => () => ({ __esModule: true, default: plugin }) };
})();
