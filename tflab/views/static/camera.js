// Where does one look from?  From behind, from the right and from above, so far that all is in the picture.

const EYE = [-0.62, -1.15, 0.72]; // x to the right, y away, z up
const TALL_DEG = 40;              // from the bottom to the top of the picture
const WIDE = 1.8;                 // how much wider than tall a picture is at least that needs no more
const MARGIN = 1.15;              // room for names around what is drawn

// How tall the picture is [deg]; of a narrow one so much that as much is in it sidewards.
function fieldOfView(aspect) {
  const tall = Math.tan(TALL_DEG / 2 * Math.PI / 180) * Math.max(1, WIDE / aspect);
  return 2 * Math.atan(tall) * 180 / Math.PI;
}

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

// Where to stand, looking from the direction `eye`, so that all is in the picture, and what is then in its middle:
// `center`, if `isPinned`.
function bestPlace(THREE, corners, center, eye, camera, isPinned) {
  const right = new THREE.Vector3(0, 1, 0).cross(eye).normalize();
  const up = eye.clone().cross(right);
  const along = (axis) => corners.map((corner) => corner.clone().sub(center).dot(axis));
  const midway = (values) => (Math.min(...values) + Math.max(...values)) / 2;
  const nears = along(eye), tall = Math.tan(camera.fov / 2 * Math.PI / 180), wide = tall * camera.aspect;
  const sides = [[right, along(right), wide], [up, along(up), tall]].map(([axis, offs, half]) => ({ axis, offs, half, mid: 0 }));
  const needed = () => Math.max(0.5, ...sides.flatMap(
    ({ offs, half, mid }) => offs.map((off, i) => nears[i] + Math.abs(off - mid) / half)));
  for (let i = 0; i < 5 && !isPinned; i++) { // what is near reaches further out, so the middle depends on the distance
    const distance = needed();
    for (const side of sides) {
      side.mid += distance * midway(side.offs.map((off, j) => (off - side.mid) / (distance - nears[j])));
    }
  }
  const middle = center.clone();
  for (const { axis, mid } of sides) middle.addScaledVector(axis, mid);
  const place = middle.clone().addScaledVector(eye, MARGIN * needed());
  middle.addScaledVector(eye, (center.y - middle.y) / eye.y); // a hand turns it about what is there, not below it
  return { middle, place };
}
