// What does a page of the book do by itself?  It searches, keeps its theme, keeps its place in the other language,
// and before it is printed puts its folded answers at the end and its 3D views as pictures.

(() => {
  const own = document.currentScript.dataset, root = document.documentElement;
  const byClass = (name) => document.querySelector(`.${name}`);

  // -- light or dark
  const show = () => { document.body.dataset.jpThemeLight = String(root.dataset.theme !== "dark"); };
  show();
  byClass("book-theme").addEventListener("click", () => {
    root.dataset.theme = root.dataset.theme === "dark" ? "light" : "dark";
    show();
    localStorage.setItem("tflab-theme", root.dataset.theme); // refused in a sandbox, such as JupyterLab's HTML viewer
  });
  if (matchMedia("(max-width: 860px)").matches) byClass("book-contents").firstElementChild.open = false;

  // -- a link to the heading of a folded section opens the section
  function openTarget() {
    const section = document.getElementById(decodeURIComponent(location.hash.slice(1)))?.closest(".tflab-section");
    if (section) section.open = true;
  }
  openTarget();
  addEventListener("hashchange", openTarget);

  // -- what scrolls sideways is reached by key
  for (const one of document.querySelectorAll("main pre, main table, main .jp-OutputArea-output")) {
    if (one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1) one.tabIndex = 0;
  }

  // -- a drawing shrinks with the page as far as it can be read; then it says that it scrolls
  const wide = new ResizeObserver((all) => all.forEach(({ target }) =>
    target.toggleAttribute("data-scrolls", target.scrollWidth > target.clientWidth + 1)));
  for (const one of document.querySelectorAll("main :is(.jp-RenderedSVG, .jp-RenderedImage)")) wide.observe(one);
  for (const word of document.querySelectorAll("main abbr[title]")) word.tabIndex = 0; // by key, and by touch

  // -- the same place in the other language: cells have the same names there
  byClass("book-language")?.addEventListener("click", (event) => {
    const below = byClass("book-head").getBoundingClientRect().bottom + 8;
    const cell = [...document.querySelectorAll("main [id^='cell-id=']")]
      .find((one) => one.getBoundingClientRect().bottom > below);
    if (cell && scrollY > 40) event.currentTarget.hash = cell.id;
  });

  // -- search, where there is more than one page
  const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  if (own.index) enableSearch();
  function enableSearch() {
    const input = byClass("book-search").querySelector("input"), found = byClass("book-found");
    let loading;
    const load = () => loading ??= new Promise((done) => {
      const script = document.createElement("script");
      script.src = own.index;
      script.onload = done;
      document.head.append(script);
    });
    const worth = ([, , , title, text], words) => {
      const inTitle = title.toLowerCase(), inText = text.toLowerCase();
      if (!words.every((word) => inTitle.includes(word) || inText.includes(word))) return 0;
      return words.reduce((sum, word) => sum + (inTitle.includes(word) ? 20 : 0) + inText.split(word).length - 1, 0);
    };
    const around = (text, words) => {
      const at = Math.max(0, Math.min(...words.map((word) => text.toLowerCase().indexOf(word)).filter((i) => i >= 0), 1e9));
      const cut = escaped(text.slice(Math.max(0, at === 1e9 ? 0 : at - 40), (at === 1e9 ? 0 : at) + 110));
      return words.reduce((html, word) => {
        const safe = escaped(word).replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
        return html.replace(new RegExp(`(${safe})(?![^<]*>)`, "gi"), "<mark>$1</mark>");
      }, cut);
    };
    async function search() {
      const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      found.hidden = words.length === 0;
      if (!words.length) return;
      await load();
      const rows = tflabIndex.map((row) => [worth(row, words), row]).filter(([sum]) => sum > 0);
      rows.sort(([a], [b]) => b - a);
      found.innerHTML = rows.slice(0, 12).map(([, [file, page, place, title, text]]) =>
        `<a href="${escaped(file)}#${encodeURIComponent(place)}"><b>${escaped(title)}</b> · ${escaped(page)}` +
        `<small>${around(text, words)}</small></a>`).join("") || escaped(own.nothing);
    }
    input.addEventListener("input", search);
    input.addEventListener("focus", load);
    byClass("book-search").addEventListener("keydown", (event) => {
      const links = [...found.querySelectorAll("a")], at = links.indexOf(document.activeElement);
      if (event.key === "Escape") { input.value = ""; found.hidden = true; input.focus(); }
      if (event.key === "Enter" && at < 0) links[0]?.click();
      if (event.key === "ArrowDown") { links[at + 1]?.focus(); event.preventDefault(); }
      if (event.key === "ArrowUp") { (links[at - 1] ?? input).focus(); event.preventDefault(); }
    });
    addEventListener("click", (event) => { if (!byClass("book-search").contains(event.target)) found.hidden = true; });
    addEventListener("keydown", (event) => {
      if (event.key === "/" && !/INPUT|TEXTAREA|SELECT/.test(document.activeElement.tagName)) {
        input.focus();
        event.preventDefault();
      }
    });
  }

  // -- on paper
  function forPaper() {
    const main = document.querySelector("main");
    for (const one of main.querySelectorAll(".tflab-section:not([open])")) one.open = one.dataset.printed = true;
    const folded = [...main.querySelectorAll("details:not([open], .tflab-code)")];
    const headings = [...main.querySelectorAll(":is(h1, h2, h3)[id]")];
    if (folded.length) {
      const answers = document.createElement("section");
      answers.className = "book-answers";
      answers.innerHTML = `<h2>${escaped(own.answers)}</h2>`;
      const list = document.createElement("dl");
      for (const one of folded) {
        const term = document.createElement("dt"), said = document.createElement("dd");
        const above = headings.findLast((each) => each.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING);
        const section = above?.textContent.replace("¶", ""), summary = one.querySelector("summary")?.textContent;
        term.textContent = [section, summary].filter(Boolean).join(" · ");
        for (const node of one.childNodes) if (node.nodeName !== "SUMMARY") said.append(node.cloneNode(true));
        list.append(term, said);
      }
      answers.append(list);
      main.append(answers);
    }
    for (const view of main.querySelectorAll(".tflab-live")) {
      const canvas = view.querySelector("canvas");
      if (!canvas?.width) continue;
      const picture = new Image();
      picture.className = "book-picture";
      picture.alt = canvas.getAttribute("aria-label") ?? "";
      picture.src = canvas.toDataURL();
      view.append(picture);
      view.classList.add("book-drawn");
    }
  }
  function afterPaper() {
    for (const one of document.querySelectorAll(".book-answers, .book-picture")) one.remove();
    for (const one of document.querySelectorAll("[data-printed]")) {
      one.open = false;
      delete one.dataset.printed;
    }
    for (const one of document.querySelectorAll(".book-drawn")) one.classList.remove("book-drawn");
  }
  addEventListener("beforeprint", forPaper);
  addEventListener("afterprint", afterPaper);
})();
