// Where does one look from?  From behind, from the right and from above, so far that all is in the picture.
//
// Read scrubber.js next.

const EYE = [-0.62, -1.15, 0.72]; // x to the right, y away, z up
const MARGIN = 1.15;              // room for names around what is drawn

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

