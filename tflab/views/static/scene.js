// How does a scene get onto the page?  meshcat's viewer draws it, one WebGL context serves all views.
//
//   model.scene (snapshot)  \                       shared WebGL canvas
//                            >  viewer (three.js)  ------------------->  this view's 2D canvas, then names on top
//   messages (live)         /
//
// This is the last of the files that widget.py puts one after the other: near.js, renderer.js, labels.js,
// camera.js, scrubber.js, ahead.js, pointer.js and this one.  Hand-written; there is no build step.

const PICK_PX = 16;            // how near to a frame's origin a click must be
const LOWEST = Math.PI / 2;    // from below the floor, a room is its own mirror image
const SWEEP_SECONDS = 4;       // how long playing a sweep takes
const RVIZ_M = 5.5;             // how far from the origin a view like RViz begins at most; a double click shows all

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
    this.kept = [];             // what lets go of materials that made way for others
    this.turned = false;        // whether somebody chose where to look from
    this.visible = true;
    this.waiting = 0;
    this.onScrubber = onScrubber;
    this.renderer = new CopyingRenderer(this.THREE, (context, camera) => {
      this.names = writeLabels(context, this, camera);
    }, () => this.wake());
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
    const resize = viewer.set_3d_pane_size;
    viewer.set_3d_pane_size = () => {
      const { clientWidth, clientHeight } = this.pane;
      if (!clientWidth || !clientHeight) return;
      viewer.camera.fov = fieldOfView(clientWidth / clientHeight);
      resize.call(viewer, clientWidth, clientHeight);
    };
    const handle = viewer.handle_command;
    viewer.handle_command = (command) => {
      if (command.type === "look") this.look(command.eye, command.target);
      else if (command.type === "sweep") this.onScrubber(sweepTrack(this, command));
      else if (command.type === "set_animation") this.onScrubber(animationTrack(this, handle.bind(viewer), command));
      else {
        const names = command.path?.split("/").filter(Boolean) ?? [];
        if (command.type === "set_object") this.keepPrograms([...names, "<object>"]);
        if (command.type === "delete") this.keepPrograms(names);
        handle.call(viewer, command);
      }
      if (command.type === "set_object") this.grown = true;
    };
    this.look(EYE.map((value) => 5 * value), [0, 0, 0]); // until there is something to look at
    this.turned = false;
    for (const name of ["Background", "Axes"]) viewer.set_property([name], "visible", false);
    viewer.controls.addEventListener("start", () => { this.turned = true; });
    viewer.controls.maxPolarAngle = LOWEST;
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

  // What waits for the next frame is drawn in this one.
  drawNow() {
    if (!this.waiting) return;
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    this.draw();
  }

  draw() {
    if (!this.pane.clientWidth || !this.pane.clientHeight) return;
    if (this.grown) { this.grown = false; this.fit(); }
    this.viewer.render();
    if (!this.renderer.isQuick) for (const letGo of this.kept.splice(0)) letGo();
    const lost = this.before && this.seenFrames().size && [...this.before].some((frame) => this.isOut(frame));
    this.before = null;
    if (lost) this.fit(true);
  }

  // The frames that are in the picture; whether one was drawn outside of it.
  seenFrames() { return new Set(this.names.map(({ frame }) => frame).filter((frame) => frame && !this.isOut(frame))); }
  isOut(frame) {
    const { width, height } = this.renderer;
    return this.names.some(({ frame: name, origin: { x, y } }) => name === frame && (x < 0 || y < 0 || x > width || y > height));
  }

  // A shader's program goes with its last material, and to make it again takes longer than to draw: the materials
  // of what makes way for something else go when that is drawn by all, which by then share their programs.
  keepPrograms(names) {
    this.viewer.scene_tree.find(names).object.traverse(({ material }) => {
      for (const one of [material ?? []].flat()) {
        one.dispose = () => { this.kept.push(() => { delete one.dispose; one.dispose(); }); };
      }
    });
  }

  // Run commands that somebody waits to see; what then is out of the picture is looked for.
  take(commands) {
    this.before ??= this.seenFrames();
    for (const command of commands) this.run(command);
    this.wake();
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
    const origin = this.looksAtOrigin ? new this.THREE.Vector3() : null;
    const { middle, place } = bestPlace(this.THREE, corners, origin ?? sphere.center, eye, camera, this.looksAtOrigin);
    const far = place.distanceTo(middle), distance = origin && !again ? Math.min(far, RVIZ_M) : far;
    place.sub(middle).setLength(distance).add(middle);
    camera.near = distance / 100;
    camera.far = distance * 100;
    controls.target.copy(middle);
    camera.position.copy(place);
    this.turned = false;
    this.wake();
  }

  turn(right, up) { // by the arrow keys [rad]
    const { camera, controls } = this.viewer;
    const arm = camera.position.clone().sub(controls.target);
    const place = new this.THREE.Spherical().setFromVector3(arm);
    place.theta += right;
    place.phi = Math.min(LOWEST, Math.max(0.05, place.phi - up));
    camera.position.copy(controls.target).add(arm.setFromSpherical(place));
    this.turned = true;
    this.wake();
  }

  zoom(by) { // how far away, in parts of what it was
    const { camera, controls } = this.viewer;
    camera.position.sub(controls.target).multiplyScalar(by).add(controls.target);
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
    this.renderer.dispose();
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
    name: "time", text: (t) => `${t.toFixed(2)} s`,
    seek(t) {
      for (const action of animator.actions) { action.play(); action.enabled = true; action.paused = false; }
      animator.seek(t);
    },
  };
}

function sweepTrack(view, command) {
  return {
    end: command.steps.length - 1, step: 1, seconds: SWEEP_SECONDS, start: command.start, play: false,
    name: nameIn(command.texts), text: (i) => command.texts[Math.round(i)],
    seek(i) { for (const inner of command.steps[Math.round(i)]) view.runDecoded(inner); },
  };
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

function emptyBox(model) {
  const box = document.createElement("div"), pane = document.createElement("div");
  box.className = "tflab-scene";
  pane.className = "tflab-scene-pane";
  pane.style.height = `${model.get("height_px")}px`;
  pane.tabIndex = 0;
  pane.setAttribute("role", "img");
  pane.setAttribute("aria-keyshortcuts", "ArrowLeft ArrowRight ArrowUp ArrowDown + - Home");
  pane.title = "drag, arrow keys: turn; right drag, Shift and arrow keys: move; click, then wheel, + and -: zoom; double click, Home: see everything";
  box.append(pane);
  return { box, pane };
}

// What an animation or a sweep is scrubbed with; `seek` goes to a place of the newest of them.
function makePlayer(model, box) {
  const player = { track: null, quiet: false, stop() { player.scrubber?.pause(); } };
  player.seek = (t) => {
    if (!player.track) return;
    player.track.seek(t);
    player.scrubber.show(t);
  };
  player.take = (track) => {
    player.stop();
    player.scrubber?.bar.remove();
    player.track = track;
    player.scrubber = makeScrubber(track, (t) => { player.seek(t); model.set("position", t); model.save_changes(); });
    box.append(player.scrubber.bar);
    player.seek(track.start);
    const still = player.quiet || matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (track.play && !still) player.scrubber.play();
  };
  return player;
}

// Let a view show what the model has, and hears from now on.
function connect(view, player, model, live, on, ahead) {
  const replay = () => {
    player.quiet = true;
    for (const command of readSnapshot(model.get("scene")).commands) view.run(command);
    for (const command of live.log) view.run(command);
    player.quiet = false;
    view.seen = live.gap ? -1 : live.last;
    if (model.get("position")) player.seek(model.get("position"));
    view.wake();
  };
  const hear = (first, last, commands, at) => {
    view.take(commands); // another fixed frame may put them elsewhere
    if (first === view.seen) view.seen = last; // else something was missed: the next snapshot mends it
    ahead.mend(at);
  };
  const highlight = () => { view.picked = model.get("picked"); view.wake(); };
  on("change:position", () => { player.seek(model.get("position")); view.wake(); });
  on("change:picked", highlight);
  on("change:scene", () => {
    if (readSnapshot(model.get("scene")).count > view.seen) { view.clear(); replay(); }
  });
  listenToPointer(view, (frame) => { model.set("picked", frame); model.save_changes(); });
  live.views.add(hear);
  replay();
  highlight();
  return () => live.views.delete(hear);
}

function renderScene(model, el, live) {
  const { box, pane } = emptyBox(model);
  const undo = [];
  let gone = false;
  el.append(box);
  const on = (event, action) => { model.on(event, action); undo.push(() => model.off(event, action)); };
  const describe = () => pane.setAttribute("aria-label", model.get("description"));
  on("change:description", describe);
  describe();

  loadViewer(model).then((MeshCat) => {
    if (gone) return;
    const player = makePlayer(model, box);
    const view = new View(MeshCat, box, pane, player.take);
    view.looksAtOrigin = model.get("looks_at_origin");
    (globalThis.tflabViews ??= new Set()).add(view); // so that a test, or a curious reader, can look inside
    const ahead = followMenu(view, model, live, el);
    undo.push(connect(view, player, model, live, on, ahead), ahead.stop, player.stop, () => {
      globalThis.tflabViews.delete(view);
      view.dispose();
    });
  }).catch((error) => { // no kernel to ask for the viewer, or no WebGL
    console.error(error);
    note(box, model.get("description"));
  });
  return () => { gone = true; undo.forEach((action) => action()); };
}

// anywidget gives `initialize` and `render` different proxies of one model, so they share `live`.
export default () => {
  // What was said since the snapshot, and whether something said before we listened is missing from it.
  const live = { log: [], last: 0, gap: false, views: new Set(), ahead: [] };
  return {
    initialize({ model }) {
      const startFromSnapshot = () => {
        const { count } = readSnapshot(model.get("scene"));
        if (count >= live.last) Object.assign(live, { log: [], last: count, gap: false });
      };
      startFromSnapshot();
      const onMessage = (message, buffers) => {
        if (message.type === "ahead") live.ahead = buffers.map((step) => readSnapshot(step).commands);
        if (message.type !== "commands") return;
        const commands = buffers.map(bytesOf), first = message.last - commands.length;
        live.gap ||= first !== live.last;
        live.log.push(...commands);
        live.last = message.last;
        for (const hear of live.views) hear(first, message.last, commands, message.at);
      };
      model.on("msg:custom", onMessage);
      model.on("change:scene", startFromSnapshot);
      return () => { model.off("msg:custom", onMessage); model.off("change:scene", startFromSnapshot); };
    },
    render({ model, el }) { return renderScene(model, el, live); },
  };
};
