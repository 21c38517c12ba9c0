// Who draws?  meshcat's viewer, loaded once per page, with one WebGL context for all views.
//
// Browsers drop WebGL contexts after about sixteen, so every view draws with the same one and keeps
// a copy on a 2D canvas of its own.  Read labels.js next.

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

