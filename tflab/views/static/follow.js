// How does a picture follow a slider at once?  The kernel has drawn what comes next before it is asked for.
//
//   a control is touched   --want-->   the kernel draws each of its places, the nearest first
//   the control moves                  drawn already: shown in the next frame
//                                      not yet: as soon as the kernel, which hears of every move, has drawn it
//
// A drawing belongs to the places of all controls, and to the one that was moved.  The Python half is
// panels/drawn_ahead.py.

const KEPT = 600;      // drawings; some ten kilobytes each
const ASKED = 200;     // places at a time
const FAR = 12;        // places from where was asked last: what is near now should come first
const EVERY_MS = 60;   // how often at most the kernel is asked

const rounded = (place) => (typeof place === "number" ? Number(place.toFixed(6)) : place);
const keyOf = (places, moved) => JSON.stringify([moved, ...places.map(rounded)]);
const isMenu = (control) => control.get("_options_labels") !== undefined;
const placeOf = (control) => control.get(isMenu(control) ? "index" : "value");

// Every place that a control can be moved to.
function placesOf(control) {
  if (isMenu(control)) return control.get("_options_labels").map((_, i) => i);
  const low = control.get("min"), high = control.get("max"), step = control.get("step");
  if (step === undefined) return [false, true];
  const places = [];
  for (let i = 0; low + i * step <= high + 1e-9; i++) places.push(low + i * step);
  if (high - places[places.length - 1] > 1e-6) places.push(high);
  return places;
}

function controlsOf(model) {
  const names = model.widget_manager ? model.get("controls") : []; // an exported page has neither
  return Promise.all(names.map((name) => model.widget_manager.get_model(name.replace("IPY_MODEL_", ""))));
}

// An image element for each drawing, loaded as it comes: to show one is to put it into the page.
class Drawings {
  constructor(model) { this.model = model; this.known = new Map(); }
  has(key) { return this.known.has(key); }
  get(key) { return this.known.get(key); }
  add(key, png, words) {
    if (this.has(key)) return;
    const image = document.createElement("img");
    image.className = "tflab-picture";
    image.width = this.model.get("width");
    image.height = this.model.get("height");
    image.alt = words;
    image.src = URL.createObjectURL(new Blob([png], { type: "image/png" }));
    this.known.set(key, image);
    if (this.known.size > KEPT) this.forget(this.known.keys().next().value);
  }
  forget(key) {
    if (this.has(key)) URL.revokeObjectURL(this.get(key).src);
    this.known.delete(key);
  }
  clear() { for (const key of [...this.known.keys()]) this.forget(key); }
}

export default {
  render({ model, el }) {
    const drawings = new Drawings(model), undo = [];
    let controls = [], moved = 0, shown = null, asking = 0, asked = { line: "", here: 0, left: 0 };
    const places = () => controls.map(placeOf);
    const show = async (key) => {
      const image = shown = drawings.get(key);
      if (!image.complete) await image.decode().catch(() => {});
      if (image === shown && image.parentNode !== el) el.replaceChildren(image);
    };
    const take = () => { // what the kernel has drawn: shown, unless we are further already
      const { places: drawnAt, moved: drawnFor } = model.get("at");
      const key = keyOf(drawnAt, drawnFor), now = keyOf(places(), moved);
      drawings.add(key, model.get("png"), model.get("description"));
      show(drawings.has(now) ? now : key);
    };
    const ask = (along) => {
      const now = places(), all = placesOf(controls[along]);
      const key = (place) => keyOf(now.map((each, i) => (i === along ? place : each)), along);
      const line = key(null), here = all.filter((place) => place < now[along]).length;
      if (line === asked.line && asked.left > 0 && Math.abs(here - asked.here) < FAR) return; // it is on its way
      const missing = all.map((place, i) => [Math.abs(i - here), place]).filter(([, place]) => !drawings.has(key(place)))
        .sort(([a], [b]) => a - b).slice(0, ASKED).map(([, place]) => place);
      asked = { line, here, left: missing.length };
      model.send({ type: "want", places: now, moved: along, missing });
    };
    const want = (along) => {
      clearTimeout(asking);
      asking = setTimeout(() => ask(along), EVERY_MS);
    };
    const on = (source, event, action) => { source.on(event, action); undo.push(() => source.off(event, action)); };

    on(model, "change:at", take);
    on(model, "msg:custom", (message, [png]) => {
      if (message.type !== "drawn") return;
      const key = keyOf(message.places, message.moved);
      asked.left--;
      drawings.add(key, png, message.words);
      if (key === keyOf(places(), moved)) show(key);
    });
    controlsOf(model).then((found) => {
      controls = found;
      controls.forEach((control, i) => on(control, "change:value change:index", () => {
        moved = i;
        const key = keyOf(places(), i);
        if (drawings.has(key)) show(key);
        want(i);
      }));
    });
    const touch = ({ target }) => { // a hand comes near: by the mouse, by the keyboard
      const panel = el.closest(".tflab-panel");
      const near = panel?.contains(target) && target.closest?.(".widget-slider, .widget-dropdown, .widget-checkbox");
      const name = near && near.textContent;
      const i = near ? controls.findIndex((control) => name.startsWith(control.get("description"))) : -1;
      if (i >= 0 && i !== touch.last) want(i);
      touch.last = i;
    };
    for (const event of ["focusin", "pointerover"]) {
      document.addEventListener(event, touch);
      undo.push(() => document.removeEventListener(event, touch));
    }
    take();
    return () => {
      clearTimeout(asking);
      undo.forEach((action) => action());
      drawings.clear();
    };
  },
};
