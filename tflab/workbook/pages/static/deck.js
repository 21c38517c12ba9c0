// How does a page become a deck?  Its cells, which are all there, are put into slides, and keys go through them.
//
// #tflab-deck holds what Python has grouped (slides.py): for each slide its cells, step by step, and the notes.
// Nothing is loaded: the views are those of the page, drawn when their slide is shown.

(() => {
  const { slides, words } = JSON.parse(document.getElementById("tflab-deck").textContent);
  const body = document.body, main = document.querySelector("main") ?? body;
  const sections = slides.map(laidOut);
  main.replaceChildren(...sections);
  const page = new DOMParser().parseFromString(`
    <div id="deck-notes"></div>
    <div id="deck-help"><dl>${words.keys.map(([key, does]) => `<dt>${key}</dt><dd>${does}</dd>`).join("")}</dl></div>
    <nav id="deck-bar"><button data-key="ArrowLeft" aria-label="${words.back}">‹</button>
      <button data-key=" " aria-label="${words.on}">›</button><span id="deck-place" aria-live="polite"></span>
      <span id="deck-more">↓</span><progress max="1" value="0"></progress>
      <button data-key="o">${words.overview}</button><button data-key="n">${words.notes}</button>
      <button data-key="t">${words.theme}</button><button data-key="?" aria-label="${words.help}">?</button></nav>`,
    "text/html");
  body.append(...page.body.children);
  const byId = (id) => document.getElementById(id);
  let index = 0, step = 0, speaker = null, began = Date.now();

  function laidOut(slide) {
    const section = document.createElement("section"), content = document.createElement("div");
    section.className = "deck-slide";
    section.setAttribute("aria-label", slide.title);
    content.className = "deck-content";
    for (const names of slide.steps) {
      const part = document.createElement("div");
      part.className = "deck-step";
      part.append(...names.map((name) => document.getElementById(`cell-id=${name}`)).filter(Boolean));
      content.append(part);
    }
    section.append(content);
    section.addEventListener("click", () => {
      if (!body.classList.contains("deck-overview")) return;
      body.classList.remove("deck-overview");
      go(sections.indexOf(section), 0);
    });
    section.addEventListener("scroll", sayMore);
    section.addEventListener("toggle", fit, true); // a fold was opened
    return section;
  }

  // ---- going through it

  function go(to, at) {
    index = Math.max(0, Math.min(slides.length - 1, to));
    step = Math.max(0, Math.min(slides[index].steps.length - 1, at));
    sections.forEach((section, i) => section.classList.toggle("deck-current", i === index));
    [...sections[index].querySelectorAll(".deck-step")].forEach((part, i) =>
      part.classList.toggle("deck-shown", i <= step));
    history.replaceState(null, "", `#${slides[index].name}`);
    fit();
    for (const wait_ms of [250, 1000]) setTimeout(fit, wait_ms); // a view grows when it has drawn itself
    say();
  }

  function on() {
    const section = sections[index];
    if (below(section) > 8) section.scrollBy({ top: 0.8 * section.clientHeight, behavior: "smooth" });
    else if (step + 1 < slides[index].steps.length) {
      go(index, step + 1);
      section.querySelectorAll(".deck-step")[step].scrollIntoView({ block: "nearest", behavior: "smooth" });
    }
    else if (index + 1 < slides.length) { go(index + 1, 0); sections[index].scrollTop = 0; }
  }

  function back() {
    const section = sections[index];
    if (section.scrollTop > 8) section.scrollBy({ top: -0.8 * section.clientHeight, behavior: "smooth" });
    else if (step > 0) go(index, step - 1);
    else if (index > 0) go(index - 1, slides[index - 1].steps.length - 1);
  }

  const below = (section) => section.scrollHeight - section.clientHeight - section.scrollTop;

  function fit() { // as large as the window allows, and a little smaller if that shows all steps of the slide
    const section = sections[index], content = section.firstChild;
    section.classList.add("deck-measured");
    inOneColumn(content);
    const largest = Math.max(0.7, Math.min(2.4, innerWidth / 1120, innerHeight / 640));
    content.style.zoom = largest;
    const room = (section.clientHeight - 40) / section.scrollHeight;
    if (room < 1) content.style.zoom = largest * (room > 0.75 ? room : 0.85);
    if (room <= 0.75 && innerWidth > 1000) setInColumns(section, content, largest, room);
    section.classList.remove("deck-measured");
    sayMore();
  }

  // A text beside its figure, where one below the other is too long; not if all of it would stand at the left.
  function setInColumns(section, content, largest, room) {
    let before = content.style.zoom;
    content.classList.add("deck-columns");
    for (const part of [0.95, 0.85, 0.75, 0.65]) {
      content.style.zoom = largest * part;
      content.style.height = `${(section.clientHeight - 44) / (largest * part)}px`;
      if (content.scrollWidth <= content.clientWidth + 4 && section.scrollHeight <= section.clientHeight + 4) {
        if (hasTwoColumns(content)) return;
        before = largest * Math.max(0.6, room);
        break;
      }
    }
    inOneColumn(content);
    content.style.zoom = before;
  }

  function hasTwoColumns(content) {
    const { left, width } = content.getBoundingClientRect();
    const boxes = [...content.querySelectorAll(".deck-step *")].flatMap((part) => [...part.getClientRects()]);
    return boxes.some((box) => box.width && box.left > left + width / 2);
  }

  function inOneColumn(content) {
    content.classList.remove("deck-columns");
    content.style.height = "";
  }

  function sayMore() { byId("deck-more")?.classList.toggle("deck-shown", below(sections[index]) > 8); }

  function say() {
    byId("deck-place").textContent = `${index + 1} / ${slides.length}`;
    document.querySelector("#deck-bar progress").value = slides.length > 1 ? index / (slides.length - 1) : 1;
    byId("deck-notes").innerHTML = slides[index].notes || `<p><em>${words.noNotes}</em></p>`;
    tellSpeaker();
  }

  // ---- the speaker's window

  function openSpeaker() {
    speaker = window.open("", "tflab-speaker", "width=820,height=640");
    if (!speaker) { body.classList.add("deck-with-notes"); return; } // the browser allows no windows
    speaker.document.title = words.notes;
    speaker.document.body.innerHTML = `<style>body { font: 20px/1.5 system-ui, sans-serif; margin: 20px; }
      #at { color: #555; display: flex; justify-content: space-between; } #next { color: #555; }</style>
      <div id="at"><span id="place"></span><span id="clock"></span></div><h2 id="title"></h2>
      <div id="notes"></div><p id="next"></p>`;
    speaker.document.onkeydown = onKey;
    began = Date.now();
    tellSpeaker();
  }

  function tellSpeaker() {
    if (!speaker || speaker.closed) return;
    const show = (id, text) => { speaker.document.getElementById(id).textContent = text; };
    show("place", `${index + 1} / ${slides.length}`);
    show("title", slides[index].title);
    show("next", index + 1 < slides.length ? `${words.next}: ${slides[index + 1].title}` : words.end);
    speaker.document.getElementById("notes").innerHTML = slides[index].notes;
    tick();
  }

  function tick() {
    if (!speaker || speaker.closed) return;
    const seconds = Math.round((Date.now() - began) / 1000), two = (n) => String(n).padStart(2, "0");
    speaker.document.getElementById("clock").textContent = `${two(Math.floor(seconds / 60))}:${two(seconds % 60)}`;
  }

  // ---- on paper

  async function print() { // a view draws itself when it is seen, so all are seen once
    body.classList.add("deck-printing");
    for (const section of sections) {
      section.scrollIntoView();
      if (section.querySelector(".tflab-live")) await new Promise((done) => setTimeout(done, 200));
    }
    window.print();
    body.classList.remove("deck-printing");
    go(index, step);
  }

  // ---- keys

  function setTheme(theme) {
    body.dataset.deck = theme;
    body.dataset.jpThemeLight = String(theme === "light");
  }

  const toggle = (name) => () => body.classList.toggle(name);
  const keys = {
    ArrowRight: on, PageDown: on, " ": on, Enter: on, ArrowLeft: back, PageUp: back, Backspace: back,
    Home: () => go(0, 0), End: () => go(slides.length - 1, 0),
    o: toggle("deck-overview"), n: toggle("deck-with-notes"), c: toggle("deck-without-code"), b: toggle("deck-black"), "?": toggle("deck-with-help"),
    t: () => setTheme(body.dataset.deck === "dark" ? "light" : "dark"),
    s: openSpeaker, p: print,
    f: () => (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen()),
    Escape: () => {
      const open = ["deck-with-help", "deck-black"].filter((name) => body.classList.contains(name));
      if (open.length) body.classList.remove(...open); else body.classList.toggle("deck-overview");
    },
  };

  function onKey(event) {
    const own = event.target.closest?.("input, textarea, select, summary, a, button");
    if (event.ctrlKey || event.metaKey || event.altKey || (own && event.key !== "Escape")) return;
    const action = event.key === " " && event.shiftKey ? back : keys[event.key];
    if (!action) return;
    event.preventDefault();
    if (body.classList.contains("deck-overview") && event.key === "Enter") keys.o();
    else action();
    if (!body.classList.contains("deck-overview")) fit();
  }

  document.addEventListener("keydown", onKey);
  byId("deck-bar").addEventListener("click", (event) => {
    const key = event.target.closest("button")?.dataset.key;
    if (key) { keys[key](); event.target.blur(); }
  });
  addEventListener("resize", fit);
  addEventListener("hashchange", () => go(named(), 0));
  addEventListener("load", fit);
  setInterval(tick, 1000);

  const named = () => Math.max(0, slides.findIndex((slide) => `#${slide.name}` === location.hash));
  setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
  go(named(), 0);
})();
