// How does a scene get onto the page?  meshcat's viewer draws it, one WebGL context serves all views.
//
//   model.scene (snapshot)  \                       shared WebGL canvas
//                            >  viewer (three.js)  ------------------->  this view's 2D canvas, then names on top
//   messages (live)         /
//
// Browsers drop WebGL contexts after about sixteen, so every view draws with the same one and copies
// the result.  Names are written on the copy as text: sharp, in the page's colours, never hidden.
// The Python half is tflab/views/scene.py.  Hand-written; there is no build step.

const BLUR_PX = 4;             // a click may move this far and is still a click
const PICK_PX = 16;            // how near to a frame's origin a click must be
const SWEEP_SECONDS = 4;       // how long playing a sweep takes
const MARGIN = 1.15;           // room for names around what is drawn
const EYE = [-0.62, -1.15, 0.72]; // x to the right, y away, z up

// ---- loading meshcat's viewer: once per page -----------------------------------------------------

async function unzipped(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).text();
}

async function viewerFromKernel(model) {
  const id = model.get("asset").replace("IPY_MODEL_", "");
  const asset = await model.widget_manager.get_model(id);
  const module = { exports: {} };
  // Not a <script>: a page with require.js would take the bundle for one of its modules.
  new Function("exports", "module", "define", await unzipped(asset.get("viewer_gz")))(module.exports, module);
  return module.exports;
}

function loadViewer(model) {
  if (globalThis.MeshCat) return Promise.resolve(globalThis.MeshCat); // an exported page brings it along
  globalThis.tflabViewer ??= viewerFromKernel(model).catch((error) => {
    globalThis.tflabViewer = undefined; // so that the next view tries again
    throw error;
  });
  return globalThis.tflabViewer;
}

// ---- one WebGL context for all views -------------------------------------------------------------

function sharedRenderer(THREE) {
  if (!globalThis.tflabRenderer) {
    const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    renderer.setPixelRatio(1);
    renderer.setClearColor(0x000000, 0);
    renderer.setScissorTest(true);
    globalThis.tflabRenderer = renderer;
  }
  return globalThis.tflabRenderer;
}

// What meshcat's viewer takes for its renderer: draws with the shared one, keeps a copy.
class CopyingRenderer {
  constructor(THREE, afterwards) {
    this.shared = sharedRenderer(THREE);
    this.shadowMap = this.shared.shadowMap;
    this.domElement = document.createElement("canvas");
    this.context = this.domElement.getContext("2d");
    this.ratio = 1;
    this.afterwards = afterwards;
  }
  setPixelRatio(ratio) { this.ratio = ratio; }
  setSize(width, height) {
    this.width = width;
    this.height = height;
    this.domElement.width = Math.max(1, Math.round(width * this.ratio));
    this.domElement.height = Math.max(1, Math.round(height * this.ratio));
    this.domElement.style.width = `${width}px`;
    this.domElement.style.height = `${height}px`;
  }
  render(scene, camera) {
    const { width, height } = this.domElement;
    const big = this.shared.domElement;
    if (big.width < width || big.height < height) { // it only grows: a new size costs more than a frame
      this.shared.setSize(Math.max(big.width, width), Math.max(big.height, height), false);
    }
    this.shared.setViewport(0, 0, width, height);
    this.shared.setScissor(0, 0, width, height);
    this.shared.render(scene, camera);
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, width, height);
    this.context.drawImage(big, 0, big.height - height, width, height, 0, 0, width, height);
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.afterwards(this.context, camera);
  }
  dispose() {}
}

// ---- names ---------------------------------------------------------------------------------------

function isShown(object) {
  for (let o = object; o; o = o.parent) if (!o.visible) return false;
  return true;
}

function toPixels(point, camera, width, height) {
  const p = point.project(camera);
  return p.z < 1 ? { x: (p.x + 1) / 2 * width, y: (1 - p.y) / 2 * height, depth: p.z } : null;
}

function lighter(colour) { // a dark blue letter on a dark page
  const parts = [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
  return `rgb(${parts.map((c) => Math.round(c + 0.4 * (255 - c))).join(",")})`;
}

const overlap = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;

// Where a name may stand, seen from its frame's origin, nearest wish first: below, above, to the sides, farther.
const PLACES = [16, 34, 52, 70].flatMap((far) => [
  [0, far], [0, -far], [0.6, far], [-0.6, far], [0.6, -far], [-0.6, -far], [1, 0.25 * far], [-1, 0.25 * far],
].map(([side, down]) => [side, down, far]));

function placed(label, taken) {
  const boxes = PLACES.map(([side, down, far]) => ({
    x: label.x - label.w / 2 + side * (label.w / 2 + far), y: label.y + down - label.h / 2, w: label.w, h: label.h,
  }));
  return boxes.find((box) => !taken.some((other) => overlap(box, other))) ?? boxes[0];
}

// A name that had to go far away is tied to its origin.
function tie(context, label, x, y, colour) {
  const far = Math.hypot(x - label.x, y - label.y);
  if (far < 30) return;
  context.globalAlpha = 0.55;
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(label.x, label.y);
  context.lineTo(x, y);
  context.stroke();
  context.globalAlpha = 1;
}

// Write every label of the scene; return where the frames' names stand, for picking.
function writeLabels(context, view, camera) {
  const { THREE, scene, renderer, box } = view;
  const look = getComputedStyle(box);
  const ink = look.color, paper = look.backgroundColor;
  const dark = ink.match(/\d+/g).slice(0, 3).reduce((sum, c) => sum + Number(c), 0) > 384;
  const found = [];
  scene.updateMatrixWorld();
  scene.traverse((object) => {
    if (!object.labels || !isShown(object)) return;
    for (const label of object.labels) {
      const at = object.localToWorld(new THREE.Vector3(...label.at));
      const pixels = toPixels(at, camera, renderer.width, renderer.height);
      if (pixels) found.push({ ...label, ...pixels, frame: object.frame?.name });
    }
  });
  found.sort((a, b) => a.name - b.name || a.depth - b.depth); // letters first: they cannot move
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  const origins = found.filter((label) => label.name).map(({ x, y }) => ({ x: x - 5, y: y - 5, w: 10, h: 10 }));
  const taken = [...origins], names = [];
  for (const label of found) {
    const size = label.small ? 12 : 13;
    context.font = `${label.slanted ? "italic " : ""}${label.name || label.small ? "600 " : ""}${size}px ${look.fontFamily}`;
    label.w = context.measureText(label.text).width + 4;
    label.h = size + 4;
    const own = { x: label.x - label.w / 2, y: label.y - label.h / 2, w: label.w, h: label.h };
    const spot = label.name ? placed(label, taken) : own;
    taken.push(spot);
    const x = spot.x + spot.w / 2, y = spot.y + spot.h / 2;
    if (label.name) names.push({ frame: label.frame, spot, origin: { x: label.x, y: label.y } });
    if (label.name && label.frame && label.frame === view.picked) ring(context, label, spot);
    if (label.name) tie(context, label, x, y, ink);
    context.lineWidth = 3.5;
    context.strokeStyle = paper;
    context.strokeText(label.text, x, y);
    context.fillStyle = label.colour ? (dark ? lighter(label.colour) : label.colour) : ink;
    context.fillText(label.text, x, y);
  }
  return names;
}

function ring(context, label, spot) {
  context.strokeStyle = "#CC79A7";
  context.lineWidth = 2;
  context.strokeRect(spot.x - 3, spot.y - 1, spot.w + 6, spot.h + 2);
  context.beginPath();
  context.arc(label.x, label.y, 8, 0, 2 * Math.PI);
  context.stroke();
}

// ---- where to look from --------------------------------------------------------------------------

// The corners of the box around each thing below `root`.
function cornersOf(THREE, root) {
  const corners = [];
  root.updateWorldMatrix(true, true); // nothing may have been drawn yet
  root.traverse((object) => {
    if (!object.geometry || !isShown(object)) return;
    object.geometry.computeBoundingBox();
    const { min, max } = object.geometry.boundingBox;
    if (min.x > max.x) return; // nothing in it
    for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) {
      corners.push(new THREE.Vector3(x, y, z).applyMatrix4(object.matrixWorld));
    }
  });
  return corners;
}

// The middle of all corners as seen from the direction `eye`, and how far away all are in the picture.
function bestPlace(THREE, corners, center, eye, camera) {
  const right = new THREE.Vector3(0, 1, 0).cross(eye).normalize();
  const up = eye.clone().cross(right);
  const along = (axis) => corners.map((corner) => corner.clone().sub(center).dot(axis));
  const midway = (values) => (Math.min(...values) + Math.max(...values)) / 2;
  const [rights, ups, nears] = [along(right), along(up), along(eye)];
  const [midRight, midUp] = [midway(rights), midway(ups)];
  const tall = Math.tan(camera.fov / 2 * Math.PI / 180), wide = tall * camera.aspect;
  const needed = corners.map((_, i) => nears[i]
    + Math.max(Math.abs(rights[i] - midRight) / wide, Math.abs(ups[i] - midUp) / tall));
  const middle = center.clone().addScaledVector(right, midRight).addScaledVector(up, midUp);
  return { middle, distance: MARGIN * Math.max(0.5, ...needed) };
}

// ---- one view ------------------------------------------------------------------------------------

// Run `action`, and note in `noted` every listener it leaves on the window: the viewer never removes them.
function notingListeners(noted, action) {
  const add = window.addEventListener, onload = window.onload;
  window.addEventListener = function (...args) { noted.push(args); return add.apply(window, args); };
  try { return action(); } finally { window.addEventListener = add; window.onload = onload; }
}

class View {
  constructor(MeshCat, box, pane, onScrubber) {
    this.THREE = MeshCat.THREE;
    this.box = box;
    this.pane = pane;
    this.names = [];
    this.picked = "";
    this.listeners = [];
    this.turned = false;        // whether somebody chose where to look from
    this.visible = true;
    this.waiting = 0;
    this.onScrubber = onScrubber;
    this.renderer = new CopyingRenderer(this.THREE, (context, camera) => {
      this.names = writeLabels(context, this, camera);
    });
    pane.append(this.renderer.domElement);
    this.viewer = notingListeners(this.listeners, () => new MeshCat.Viewer(pane, false, this.renderer));
    this.adapt(this.viewer);
    this.watch();
  }

  get scene() { return this.viewer.scene; }

  // Make the stock viewer draw only when there is something new, in our size, and understand our commands.
  adapt(viewer) {
    viewer.gui.domElement.remove();
    viewer.animate = () => {};
    viewer.set_dirty = () => this.wake();
    viewer.camera.fov = 40;
    const resize = viewer.set_3d_pane_size;
    viewer.set_3d_pane_size = () => {
      const { clientWidth, clientHeight } = this.pane;
      if (clientWidth && clientHeight) resize.call(viewer, clientWidth, clientHeight);
    };
    const handle = viewer.handle_command;
    viewer.handle_command = (command) => {
      if (command.type === "look") this.look(command.eye, command.target);
      else if (command.type === "sweep") this.onScrubber(sweepTrack(this, command));
      else if (command.type === "set_animation") this.onScrubber(animationTrack(this, handle.bind(viewer), command));
      else handle.call(viewer, command);
      if (command.type === "set_object") this.grown = true;
    };
    this.look(EYE.map((value) => 5 * value), [0, 0, 0]); // until there is something to look at
    this.turned = false;
    for (const name of ["Background", "Axes"]) viewer.set_property([name], "visible", false);
    viewer.controls.addEventListener("start", () => { this.turned = true; });
    viewer.set_3d_pane_size();
  }

  watch() {
    this.observers = [
      new ResizeObserver(() => this.viewer.set_3d_pane_size()),
      new IntersectionObserver((entries) => {
        this.visible = entries[entries.length - 1].isIntersecting;
        if (this.visible) this.wake();
      }, { rootMargin: "1000px" }),
      new MutationObserver(() => this.wake()), // the page's theme
    ];
    this.observers[0].observe(this.pane);
    this.observers[1].observe(this.pane);
    this.observers[2].observe(document.body, { attributes: true });
    this.darkness = matchMedia("(prefers-color-scheme: dark)");
    this.onDarkness = () => this.wake();
    this.darkness.addEventListener("change", this.onDarkness);
  }

  wake() {
    if (this.waiting || !this.visible) return;
    this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.draw(); });
  }

  draw() {
    if (!this.pane.clientWidth || !this.pane.clientHeight) return;
    if (this.grown) { this.grown = false; this.fit(); }
    this.onFrame?.();
    this.viewer.render();
  }

  run(bytes) { notingListeners(this.listeners, () => this.viewer.handle_command_bytearray(bytes)); }
  runDecoded(command) { notingListeners(this.listeners, () => this.viewer.handle_command(command)); }
  clear() { this.viewer.delete_path(["meshcat"]); }

  look(eye, target) { // z up, as in ROS; three.js has y up
    this.turned = true;
    this.viewer.camera.position.set(eye[0], eye[2], -eye[1]);
    this.viewer.controls.target.set(target[0], target[2], -target[1]);
    this.wake();
  }

  // Look at everything, unless somebody has chosen where to look, or the view is good enough as it is.
  fit(again = false) {
    const root = this.scene.getObjectByName("meshcat");
    const corners = root && (again || !this.turned) ? cornersOf(this.THREE, root) : [];
    if (!corners.length) return;
    const sphere = new this.THREE.Sphere().setFromPoints(corners), before = this.fitted;
    if (!again && before && sphere.radius < 1.3 * before.radius && sphere.radius > 0.5 * before.radius
      && sphere.center.distanceTo(before.center) < 0.5 * before.radius) return;
    this.fitted = sphere;
    const { camera, controls } = this.viewer;
    const eye = new this.THREE.Vector3(EYE[0], EYE[2], -EYE[1]).normalize();
    const { middle, distance } = bestPlace(this.THREE, corners, sphere.center, eye, camera);
    camera.near = distance / 100;
    camera.far = distance * 100;
    controls.target.copy(middle);
    camera.position.copy(middle).addScaledVector(eye, distance);
    this.turned = false;
    this.wake();
  }

  turn(right, up) { // by the arrow keys [rad]
    const { camera, controls } = this.viewer;
    const arm = camera.position.clone().sub(controls.target);
    const place = new this.THREE.Spherical().setFromVector3(arm);
    place.theta += right;
    place.phi = Math.min(Math.PI - 0.05, Math.max(0.05, place.phi - up));
    camera.position.copy(controls.target).add(arm.setFromSpherical(place));
    this.turned = true;
    this.wake();
  }

  // The frame at a point of the pane: the nearest name or origin, else what the ray hits; "" for none.
  frameAt(x, y) {
    const inside = ({ spot }) => x >= spot.x && x <= spot.x + spot.w && y >= spot.y && y <= spot.y + spot.h;
    const far = ({ origin }) => Math.hypot(origin.x - x, origin.y - y);
    const named = this.names.filter((name) => name.frame);
    const near = named.filter((name) => far(name) < PICK_PX).sort((a, b) => far(a) - far(b));
    const hit = named.find(inside) ?? near[0];
    if (hit) return hit.frame;
    const ray = new this.THREE.Raycaster();
    const { width, height } = this.renderer;
    ray.setFromCamera(new this.THREE.Vector2(2 * x / width - 1, 1 - 2 * y / height), this.viewer.camera);
    const root = this.scene.getObjectByName("meshcat");
    let object = root && ray.intersectObject(root, true)[0]?.object;
    while (object && !object.frame) object = object.parent;
    return object?.frame.name ?? "";
  }

  dispose() {
    cancelAnimationFrame(this.waiting);
    this.visible = false;
    for (const observer of this.observers) observer.disconnect();
    this.darkness.removeEventListener("change", this.onDarkness);
    for (const args of this.listeners) window.removeEventListener(...args);
    this.viewer.controls.dispose();
    this.viewer.scene_tree.dispose_recursive();
    this.pane.replaceChildren();
  }
}

// ---- what a scrubber runs along ------------------------------------------------------------------

function animationTrack(view, handle, command) {
  handle({ ...command, options: { ...command.options, play: false } });
  const animator = view.viewer.animator;
  return {
    end: animator.duration, step: 0.001, seconds: animator.duration, start: 0, play: command.options.play,
    text: (t) => `${t.toFixed(2)} s`,
    seek(t) {
      for (const action of animator.actions) { action.play(); action.enabled = true; action.paused = false; }
      animator.seek(t);
    },
  };
}

function sweepTrack(view, command) {
  return {
    end: command.steps.length - 1, step: 1, seconds: SWEEP_SECONDS, start: command.start, play: false,
    text: (i) => command.texts[Math.round(i)],
    seek(i) { for (const inner of command.steps[Math.round(i)]) view.runDecoded(inner); },
  };
}

function makeScrubber(track, onMove) {
  const bar = document.createElement("div");
  bar.className = "tflab-scrubber";
  bar.innerHTML = `<button type="button"></button><input type="range" min="0" aria-label="scrubber"><output></output>`;
  const [button, slider, output] = bar.children;
  slider.max = track.end;
  slider.step = track.step;
  let playing = 0;
  const show = (t) => { slider.value = t; output.textContent = track.text(t); };
  const pause = () => {
    cancelAnimationFrame(playing);
    playing = 0;
    button.textContent = "▶";
    button.setAttribute("aria-label", "play");
  };
  const play = () => {
    const from = Number(slider.value) >= track.end ? 0 : Number(slider.value);
    const began = performance.now();
    button.textContent = "⏸";
    button.setAttribute("aria-label", "pause");
    const tick = (now) => {
      const t = Math.min(track.end, from + Math.max(0, now - began) / 1000 * track.end / track.seconds);
      playing = requestAnimationFrame(tick);
      onMove(t);
      if (t >= track.end) pause();
    };
    playing = requestAnimationFrame(tick);
  };
  button.onclick = () => (playing ? pause() : play());
  slider.oninput = () => { pause(); onMove(Number(slider.value)); };
  pause();
  show(track.start);
  return { bar, show, play, pause };
}

// ---- the widget ----------------------------------------------------------------------------------

const bytesOf = (data) => new Uint8Array(data.buffer, data.byteOffset, data.byteLength);

// A snapshot: how many commands it stands for, then each command after its length.
function readSnapshot(data) {
  if (!data || data.byteLength < 4) return { count: 0, commands: [] };
  const bytes = bytesOf(data), numbers = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const commands = [];
  for (let i = 4; i < bytes.length;) {
    const length = numbers.getUint32(i, true);
    commands.push(bytes.subarray(i + 4, i + 4 + length));
    i += 4 + length;
  }
  return { count: numbers.getUint32(0, true), commands };
}

function note(box, text) {
  const words = document.createElement("pre");
  words.className = "tflab-scene-note";
  words.textContent = text;
  box.style.height = "auto";
  box.replaceChildren(words);
}

function renderScene(model, el, live) {
  const box = document.createElement("div");
  const pane = document.createElement("div");
  box.className = "tflab-scene";
  pane.className = "tflab-scene-pane";
  pane.style.height = `${model.get("height_px")}px`;
  pane.tabIndex = 0;
  pane.setAttribute("role", "img");
  pane.title = "drag: turn; right drag: move; click, then wheel: zoom; double click: see everything";
  box.append(pane);
  el.append(box);
  const undo = [];
  const on = (event, action) => { model.on(event, action); undo.push(() => model.off(event, action)); };
  const describe = () => pane.setAttribute("aria-label", model.get("description"));
  on("change:description", describe);
  describe();

  loadViewer(model).then((MeshCat) => {
    if (!el.isConnected && undo.gone) return;
    let track = null, scrubber = null, replaying = false;
    const seek = (t) => { track.seek(t); scrubber.show(t); view.wake(); };
    const view = new View(MeshCat, box, pane, (newTrack) => {
      scrubber?.pause();
      scrubber?.bar.remove();
      track = newTrack;
      scrubber = makeScrubber(track, (t) => { seek(t); model.set("position", t); model.save_changes(); });
      box.append(scrubber.bar);
      seek(track.start);
      const still = replaying || matchMedia("(prefers-reduced-motion: reduce)").matches;
      if (track.play && !still) scrubber.play();
    });
    on("change:position", () => { if (track) seek(model.get("position")); });

    const replay = () => {
      replaying = true;
      for (const command of readSnapshot(model.get("scene")).commands) view.run(command);
      for (const command of live.log) view.run(command);
      view.seen = live.gap ? -1 : live.last;
      replaying = false;
      if (track && model.get("position")) seek(model.get("position"));
      view.wake();
    };
    replay();
    const hear = (first, last, commands) => {
      for (const command of commands) view.run(command);
      if (first === view.seen) view.seen = last; // else something was missed: the next snapshot mends it
      view.wake();
    };
    live.views.add(hear);
    on("change:scene", () => {
      if (readSnapshot(model.get("scene")).count > view.seen) { view.clear(); replay(); }
    });
    on("change:picked", () => { view.picked = model.get("picked"); view.wake(); });
    view.picked = model.get("picked");
    listenToPointer(view, (frame) => { model.set("picked", frame); model.save_changes(); });
    (globalThis.tflabViews ??= new Set()).add(view); // so that a test, or a curious reader, can look inside
    undo.push(() => { scrubber?.pause(); live.views.delete(hear); globalThis.tflabViews.delete(view); view.dispose(); });
    if (undo.gone) undo.forEach((action) => action());
  }, () => note(box, model.get("description")));

  return () => { undo.gone = true; undo.forEach((action) => action()); };
}

function listenToPointer(view, onPick) {
  const { pane, box } = view;
  let down = null;
  pane.addEventListener("pointerdown", (event) => { down = event; pane.focus({ preventScroll: true }); });
  pane.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > BLUR_PX) return;
    const corner = pane.getBoundingClientRect();
    onPick(view.frameAt(event.clientX - corner.left, event.clientY - corner.top));
  });
  pane.addEventListener("dblclick", () => view.fit(true));
  // Until the view is clicked on, the wheel scrolls the page.
  box.addEventListener("wheel", (event) => {
    if (document.activeElement !== pane && !event.ctrlKey) event.stopPropagation();
  }, { capture: true, passive: true });
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
  pane.addEventListener("keydown", (event) => {
    if (!turns[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    view.turn(...turns[event.key]);
  });
}

// anywidget gives `initialize` and `render` different proxies of one model, so they share `live`.
export default () => {
  // What was said since the snapshot, and whether something said before we listened is missing from it.
  const live = { log: [], last: 0, gap: false, views: new Set() };
  return {
    initialize({ model }) {
      const startFromSnapshot = () => {
        const { count } = readSnapshot(model.get("scene"));
        if (count >= live.last) Object.assign(live, { log: [], last: count, gap: false });
      };
      startFromSnapshot();
      const onMessage = (message, buffers) => {
        if (message.type !== "commands") return;
        const commands = buffers.map(bytesOf), first = message.last - commands.length;
        live.gap ||= first !== live.last;
        live.log.push(...commands);
        live.last = message.last;
        for (const hear of live.views) hear(first, message.last, commands);
      };
      model.on("msg:custom", onMessage);
      model.on("change:scene", startFromSnapshot);
      return () => { model.off("msg:custom", onMessage); model.off("change:scene", startFromSnapshot); };
    },
    render({ model, el }) { return renderScene(model, el, live); },
  };
};
