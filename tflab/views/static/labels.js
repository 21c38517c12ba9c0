// Where do names stand?  On the copy of the picture, as text: sharp, in the page's colours, never hidden.
//
// Letters at the tips of axes stay where they are; names make way for them and for each other.
// Where many frames stand in one spot, seen from afar, one name stands for all: "base_link +7".

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
const PLACES = [16, 34, 52, 70, 90, 112, 136].flatMap((far) => [
  [0, far], [0, -far], [0.6, far], [-0.6, far], [0.6, -far], [-0.6, -far], [1, 0.25 * far], [-1, 0.25 * far],
].map(([side, down]) => [side, down, far]));

function placed(label, taken) {
  const boxes = PLACES.map(([side, down, far]) => ({
    x: label.x - label.w / 2 + side * (label.w / 2 + far), y: label.y + down - label.h / 2, w: label.w, h: label.h,
  }));
  return boxes.find((box) => !taken.some((other) => overlap(box, other))) ?? boxes[0];
}

// What is written at the middle of an arrow stands clear of its line: above it, or to its right where it is upright.
function clearOf(from, to, size) {
  const long = Math.hypot(to.x - from.x, to.y - from.y);
  const [x, y] = long > 1 ? [(to.y - from.y) / long, (from.x - to.x) / long] : [0, -1];
  const far = (Math.abs(x) * size.w + Math.abs(y) * size.h) / 2 + 4;
  const up = y < -0.01 || (y < 0.01 && x > 0) ? 1 : -1;
  return { x: up * far * x, y: up * far * y };
}

// It stays there if nothing else does, and else goes as far as it must.
function beside(own, taken) {
  const free = (box) => !taken.some((other) => overlap(box, other));
  if (free(own)) return own;
  const boxes = [1, 2, 3, 4].flatMap((far) => [[0, -far], [0, far], [1, 0], [-1, 0], [1, -far], [-1, -far]]
    .map(([side, down]) => ({ ...own, x: own.x + side * far * 0.6 * own.w, y: own.y + down * own.h })));
  return boxes.find(free) ?? own;
}

const CROWD_PX = 26;           // how near to each other frames must stand to be a crowd
const CROWD = 5;               // and how many they must be
const LETTERS_PX = 9;          // an axis that is shorter has no letter

// Of frames that stand in one spot, the one nearest to the root speaks for the others, which are left out;
// a frame that somebody has picked keeps its name.
function leftOut(names, picked) {
  const parents = new Map(names.map((label) => [label.frame, label.parent]));
  const upwards = ({ frame }) => {
    const way = [];
    for (let at = frame; parents.has(at) && way.length <= names.length; at = parents.get(at)) way.push(at);
    return way;
  };
  const out = new Set();
  for (const one of names.map((label) => [upwards(label).length, label]).sort((a, b) => a[0] - b[0]).map(([, label]) => label)) {
    if (out.has(one)) continue;
    const above = new Set(upwards(one)); // nobody speaks for those above
    const free = names.filter((other) => !above.has(other.frame) && !out.has(other) && other.frame !== picked);
    const closeTo = (member) => free.filter((other) => Math.hypot(other.x - member.x, other.y - member.y) < CROWD_PX);
    const near = closeTo(one);
    if (near.length + 1 < CROWD) continue;
    for (const member of near) near.push(...closeTo(member).filter((other) => !near.includes(other))); // and theirs
    one.text += ` +${near.length}`;
    for (const other of near) out.add(other);
  }
  return out;
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
  const everything = [];
  scene.updateMatrixWorld();
  scene.traverse((object) => {
    if (!object.labels || !isShown(object)) return;
    const written = [];
    for (const label of object.labels) {
      const seen = (at) => toPixels(object.localToWorld(new THREE.Vector3(...at)), camera, renderer.width, renderer.height);
      const pixels = seen(label.at);
      const line = label.along && [seen([0, 0, 0]), seen(label.along)];
      if (pixels) written.push({ ...label, ...pixels, line, frame: object.frame?.name, parent: object.frame?.parent, object });
    }
    const middle = written.find((label) => label.name);
    everything.push(...written.filter((label) => !middle || label.name
      || Math.hypot(label.x - middle.x, label.y - middle.y) >= LETTERS_PX));
  });
  const out = leftOut(everything.filter((label) => label.name && label.frame && !label.slanted), view.picked);
  const silent = new Set([...out].map((label) => label.object));
  const found = everything.filter((label) => !silent.has(label.object));
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
    if (label.line?.[0] && label.line[1]) {
      const { x, y } = clearOf(...label.line, label);
      label.x += x;
      label.y += y;
    }
    const own = { x: label.x - label.w / 2, y: label.y - label.h / 2, w: label.w, h: label.h };
    const spot = label.name ? placed(label, taken) : label.small ? own : beside(own, taken);
    taken.push(spot);
    const x = spot.x + spot.w / 2, y = spot.y + spot.h / 2;
    if (label.name) names.push({ frame: label.frame, spot, origin: { x: label.x, y: label.y } });
    if (label.name && label.frame && label.frame === view.picked) ring(context, label, spot);
    if (label.name || spot !== own) tie(context, label, x, y, ink);
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

