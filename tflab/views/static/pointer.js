// How does a hand turn a scene, come closer, and click on a frame?  By the mouse, and by the keyboard alone.

const BLUR_PX = 4;             // a click may move this far and is still a click

// Move sidewards and up, in parts of how far away one stands.
function move(view, right, up) {
  const { camera, controls } = view.viewer, far = camera.position.distanceTo(controls.target);
  for (const [column, by] of [[0, right], [1, up]]) {
    const step = new view.THREE.Vector3().setFromMatrixColumn(camera.matrix, column).multiplyScalar(by * far);
    camera.position.add(step);
    controls.target.add(step);
  }
  view.turned = true;
  view.wake();
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
  const keys = {
    ...Object.fromEntries(Object.entries(turns).map(([key, by]) => [key, () => view.turn(...by)])),
    "+": () => view.zoom(1 / 1.2), "=": () => view.zoom(1 / 1.2), "-": () => view.zoom(1.2), Home: () => view.fit(true),
  };
  pane.addEventListener("keydown", (event) => {
    const act = event.shiftKey && turns[event.key] ? () => move(view, ...turns[event.key]) : keys[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  });
}

