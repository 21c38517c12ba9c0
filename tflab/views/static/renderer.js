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

const SLOW_MS = 24;    // a picture that takes longer is drawn by the processor: nothing of a drag is seen in time
const COARSE = 0.5;    // of the pixels in each direction, while such a picture moves
const REST_MS = 200;   // when it stands still for so long, it is drawn with all of them

// What meshcat's viewer takes for its renderer: draws with the shared one, keeps a copy.
// `afterwards(context, camera)` writes on the copy; `again()` asks for the same picture once more.
class CopyingRenderer {
  constructor(THREE, afterwards, again) {
    this.shared = sharedRenderer(THREE);
    this.shadowMap = this.shared.shadowMap;
    this.domElement = document.createElement("canvas");
    this.context = this.domElement.getContext("2d");
    this.ratio = 1;
    this.afterwards = afterwards;
    this.again = again;
    this.isSlow = false;  // when drawn with all pixels
    this.rests = false;   // whether it moves no more, and was drawn coarsely
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
    const part = this.isSlow && !this.rests ? COARSE : 1;
    const begun = performance.now();
    this.draw(scene, camera, Math.ceil(part * width), Math.ceil(part * height));
    if (part === 1) this.isSlow = performance.now() - begun > SLOW_MS;
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.afterwards(this.context, camera);
    this.rests = false;
    clearTimeout(this.timer);
    if (part < 1) this.timer = setTimeout(() => { this.rests = true; this.again(); }, REST_MS);
  }
  // Draw so many pixels with the shared renderer, and fill the copy with them.
  draw(scene, camera, width, height) {
    const { domElement: copy, context, shared } = this, big = shared.domElement;
    if (big.width < width || big.height < height) { // it only grows: a new size costs more than a frame
      shared.setSize(Math.max(big.width, width), Math.max(big.height, height), false);
    }
    shared.setViewport(0, 0, width, height);
    shared.setScissor(0, 0, width, height);
    shared.render(scene, camera);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, copy.width, copy.height);
    context.drawImage(big, 0, big.height - height, width, height, 0, 0, copy.width, copy.height);
  }
  dispose() { clearTimeout(this.timer); }
}
