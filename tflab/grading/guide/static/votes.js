// How does a deck count a vote?  Numbers are typed beside the options; shares, what to do and what to say follow.
//
// #tflab-votes holds the votes as Python wrote them (deck.py). Counts stay in this browser.

(() => {
  const { votes, words, bounds } = JSON.parse(document.getElementById("tflab-votes").textContent);
  const kept = (vote) => `tflab-vote:${vote.stem}:${vote.name}`;
  const states = new Map(votes.map((vote) => [vote, read(vote)]));

  function read(vote) { // a page from a disk may have nowhere to keep anything
    try { return JSON.parse(localStorage.getItem(kept(vote))) ?? { first: {}, again: null }; }
    catch { return { first: {}, again: null }; }
  }

  function keep(vote) {
    try { localStorage.setItem(kept(vote), JSON.stringify(states.get(vote))); } catch { /* then it lasts as long as the page */ }
  }

  const make = (kind, name, text = "") => Object.assign(document.createElement(kind), { className: name, textContent: text });
  const sum = (counts) => Object.values(counts).reduce((all, one) => all + one, 0);
  const shareOf = (counts, label) => (sum(counts) ? 100 * (counts[label] ?? 0) / sum(counts) : 0);

  function build(vote, place) {
    const rows = vote.options.map((option) => {
      const row = make("div", "row"), text = make("span", "text"), input = make("input", "count");
      const share = make("div", "share"), track = make("div", "track");
      text.innerHTML = option.html;
      Object.assign(input, { type: "number", min: 0, inputMode: "numeric" });
      input.setAttribute("aria-label", `${option.label}: ${words.voters}`);
      track.append(make("div", "bar"), make("div", "first"));
      share.append(track, make("span", "number"));
      row.append(make("span", "label", option.label), text, input, share);
      input.addEventListener("input", () => {
        const state = states.get(vote), counts = state.again ?? state.first;
        counts[option.label] = Math.max(0, Math.floor(Number(input.value) || 0));
        keep(vote);
        show();
      });
      input.addEventListener("keydown", (event) => {
        if (event.key !== "Enter") return;
        const inputs = [...place.querySelectorAll("input")];
        (inputs[inputs.indexOf(input) + 1] ?? input).focus();
      });
      place.append(row);
      return { row, input, share, option };
    });
    const below = make("div", "below"), advice = make("span", "do"), says = make("div", "says");
    const button = (text, act) => { const made = make("button", "", text); made.type = "button"; made.addEventListener("click", () => { act(); made.blur(); }); return made; };
    advice.setAttribute("aria-live", "polite");
    says.hidden = true;
    below.append(advice,
      button(words.again, () => { states.get(vote).again = {}; keep(vote); says.hidden = true; show(true); rows[0].input.focus(); }),
      button(words.say, () => { says.hidden = !says.hidden; show(); }),
      button(words.clear, () => { states.set(vote, { first: {}, again: null }); keep(vote); says.hidden = true; show(true); }));
    place.append(below, says);

    function show(fresh = false) {
      const state = states.get(vote), counts = state.again ?? state.first;
      for (const { row, input, share, option } of rows) {
        if (fresh || document.activeElement !== input) input.value = counts[option.label] ?? "";
        const percent = shareOf(counts, option.label), before = state.again ? shareOf(state.first, option.label) : 0;
        share.querySelector(".bar").style.width = `${percent}%`;
        share.querySelector(".first").style.width = `${before}%`;
        share.querySelector(".first").hidden = !before;
        share.querySelector(".number").textContent = sum(counts) ? `${Math.round(percent)} %` : "";
        row.classList.toggle("right", !says.hidden && option.right);
      }
      const right = rows.find(({ option }) => option.right), got = shareOf(counts, right.option.label);
      advice.textContent = sum(counts) ? words[vote.later ? "later" : got < bounds[0] ? "do0" : got <= bounds[1] ? "do1" : "do2"] : "";
      if (!says.hidden) tell(counts);
      dispatchEvent(new Event("resize")); // the deck fits the slide anew
    }

    function tell(counts) { // the wrong option that most have taken comes first
      const order = [...vote.options].sort((a, b) => Number(a.right) - Number(b.right)
        || shareOf(counts, b.label) - shareOf(counts, a.label) || b.expected - a.expected);
      says.replaceChildren(...order.map((option) => {
        const line = make("div", ""), head = make("div", ""), said = make("div", "");
        head.append(make("b", "", option.label), make("span", "", option.right ? ` ✓ ${words.right}` : ""),
          make("span", "expected", `${words.expected} ${option.expected} %`));
        said.innerHTML = option.say;
        line.append(head, said);
        return line;
      }));
    }

    show(true);
  }

  for (const vote of votes)
    for (const place of document.querySelectorAll(`.tflab-vote[data-vote="${vote.name}"]`)) build(vote, place);
})();
