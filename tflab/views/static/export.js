// How does a view live in a page without a kernel?  It gets a model that nobody else listens to.
//
// The page holds the state of each view (#tflab-state) and, for each, an empty .tflab-live element;
// the views' own modules are in tflabModules.  What a scrubber sets stays in this page.

(() => {
  const bytesFrom = (text) => new DataView(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

  function modelFrom({ state, buffers }) {
    const values = { ...state }, listeners = {};
    for (const { path, data } of buffers) values[path[0]] = bytesFrom(data);
    return {
      get: (key) => values[key],
      set(key, value) {
        if (values[key] === value) return;
        values[key] = value;
        for (const action of listeners[`change:${key}`] ?? []) action();
      },
      on(event, action) { (listeners[event] ??= new Set()).add(action); },
      off(event, action) { listeners[event]?.delete(action); },
      save_changes() {},
      send() {},
    };
  }

  async function show(el, stored) {
    const code = URL.createObjectURL(new Blob([globalThis.tflabModules[stored.module]], { type: "text/javascript" }));
    const made = (await import(code)).default;
    URL.revokeObjectURL(code);
    const widget = typeof made === "function" ? await made() : made;
    const model = modelFrom(stored);
    await widget.initialize?.({ model });
    el.replaceChildren();
    await widget.render({ model, el });
  }

  const views = JSON.parse(document.getElementById("tflab-state").textContent);
  for (const el of document.querySelectorAll(".tflab-live")) show(el, views[el.dataset.view]);
})();
