// How does a picture follow a slider at once?  The kernel has drawn what comes next before it is asked for.
//
//   a control is touched   --want-->   the kernel draws its places: its neighbours, some over the whole rail, the rest
//   the control moves                  drawn already: shown in the next frame
//                                      not yet: the nearest that is, and the right one as soon as the kernel, which
//                                      hears of every move, has drawn it
//
// A drawing belongs to the places of all controls, and to the one that was moved.  The Python half is
// panels/prefetch.py; near.js comes before this file.

const KEPT = 600;      // drawings; some ten kilobytes each
const ASKED = 200;     // places at a time
const FAR = 12;        // places from where was asked last: what is near now should come first
const NEIGHBOURS = 6;  // places to each side: a key moves by one
const OVER_ALL = 48;   // places over the whole rail: a mouse moves by many
const ALIKE = 1 / 16;  // of the rail: a drawing further away is another picture
const EVERY_MS = 60;   // how often at most the kernel is asked

const rounded = (place) => (typeof place === "number" ? Number(place.toFixed(6)) : place);
const keyOf = (places, moved) => JSON.stringify([moved, ...places.map(rounded)]);
const isTold = (control) => Boolean(control._state_lock); // the kernel moves it: it follows another one

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

// The places still to be drawn, in the order in which a hand may come to them; `here` is where it is now.
function inOrder(missing, here, count) {
  const stride = Math.max(1, Math.floor(count / OVER_ALL));
  const rank = ({ i, far }) => (far <= NEIGHBOURS ? 0 : i % stride === 0 ? 1 : 2);
  return missing.map((each) => ({ ...each, far: Math.abs(each.i - here) }))
    .sort((a, b) => rank(a) - rank(b) || a.far - b.far).slice(0, ASKED).map(({ place }) => place);
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
    let controls = [], moved = 0, anew = model.get("anew"), shown = null, asking = 0, asked = { line: "", here: 0, left: 0 };
    const places = () => controls.map(placeOf);
    const nearest = () => { // the key of the drawing that is most like what should be seen now, if there is one
      const now = places(), key = (place) => keyOf(now.map((each, i) => (i === moved ? place : each)), moved);
      if (drawings.has(key(now[moved])) || controls[moved].get("step") === undefined) return key(now[moved]);
      const all = placesOf(controls[moved]), here = all.filter((place) => place < now[moved]).length;
      for (let far = 1; far <= all.length * ALIKE; far++)
        for (const i of [here - far, here + far])
          if (i in all && drawings.has(key(all[i]))) return key(all[i]);
      return key(now[moved]);
    };
    const show = async (key) => {
      el.ariaBusy = controls.length > 0 && key !== keyOf(places(), moved); // a near one: the right one is on its way
      const image = shown = drawings.get(key);
      if (!image.complete) await image.decode().catch(() => {});
      if (image === shown && image.parentNode !== el) el.replaceChildren(image);
    };
    const take = () => { // what the kernel has drawn: shown, unless we are further already
      const { places: drawnAt, moved: drawnFor } = model.get("at");
      const key = keyOf(drawnAt, drawnFor);
      if (anew !== model.get("anew")) drawings.clear(); // of a time when there was something else to be seen
      anew = model.get("anew");
      drawings.add(key, model.get("png"), model.get("description"));
      const now = controls.length ? nearest() : key;
      show(drawings.has(now) ? now : key);
    };
    const ask = (along) => {
      const now = places(), all = placesOf(controls[along]);
      const key = (place) => keyOf(now.map((each, i) => (i === along ? place : each)), along);
      const line = key(null), here = all.filter((place) => place < now[along]).length;
      if (line === asked.line && asked.left > 0 && Math.abs(here - asked.here) < FAR) return; // it is on its way
      const missing = inOrder(
        all.map((place, i) => ({ place, i })).filter(({ place }) => !drawings.has(key(place))), here, all.length);
      asked = { line, here, left: missing.length };
      model.send({ type: "want", places: now, moved: along, missing });
    };
    const want = (along) => {
      clearTimeout(asking);
      asking = setTimeout(() => ask(along), EVERY_MS);
    };
    const on = (source, event, action) => { source.on(event, action); undo.push(() => source.off(event, action)); };

    on(model, "change:at change:anew", take);
    on(model, "msg:custom", (message, [png]) => {
      if (message.type !== "drawn") return;
      const key = keyOf(message.places, message.moved);
      asked.left--;
      drawings.add(key, png, message.words);
      if (key === nearest()) show(key);
    });
    controlsOf(model).then((found) => {
      controls = found;
      controls.forEach((control, i) => on(control, "change:value change:index", () => {
        if (!isTold(control)) moved = i;
        const key = nearest();
        if (drawings.has(key)) show(key);
        else el.ariaBusy = true;
        want(moved);
      }));
    });
    undo.push(onHand(el, ".tflab-panel", () => controls, want));
    take();
    return () => {
      clearTimeout(asking);
      undo.forEach((action) => action());
      drawings.clear();
    };
  },
};
