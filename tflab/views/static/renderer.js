// Who draws?  meshcat's viewer, loaded once per page, with one WebGL context for all views, or two.
//
// Browsers drop WebGL contexts after about sixteen, so every view draws with the same one and keeps
// a copy on a 2D canvas of its own.  Without a graphics card, what moves is drawn by a second one
// that is quicker and less smooth.

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

// ---- WebGL contexts for all views together -------------------------------------------------------

// Where there is no graphics card, as in many a virtual machine, one of these draws.
const BY_PROCESSOR = /swiftshader|llvmpipe|softpipe|software|basic render/i;

function sharedRenderer(THREE) {
  globalThis.tflabRenderer ??= newRenderer(THREE, true);
  return globalThis.tflabRenderer;
}

// A processor needs twice as long for smooth edges: it draws what moves without them. Null beside a graphics card.
function quickRenderer(THREE) {
  if (globalThis.tflabQuickRenderer === undefined) {
    const isSlow = BY_PROCESSOR.test(whoDraws(sharedRenderer(THREE).getContext()));
    globalThis.tflabQuickRenderer = isSlow ? newRenderer(THREE, false) : null;
  }
  return globalThis.tflabQuickRenderer;
}

function newRenderer(THREE, antialias) {
  const renderer = new THREE.WebGLRenderer({ antialias, alpha: true });
  renderer.setPixelRatio(1);
  renderer.setClearColor(0x000000, 0);
  renderer.setScissorTest(true);
  return renderer;
}

// The name of what draws for WebGL; "" if the browser keeps it to itself.
function whoDraws(gl) {
  const named = gl.getExtension("WEBGL_debug_renderer_info");
  return String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER) ?? "");
}

const REST_MS = 200; // a picture that was drawn quickly is drawn smoothly when nothing has moved for so long

// What meshcat's viewer takes for its renderer: draws with the shared ones, keeps a copy.
// `afterwards(context, camera)` writes on the copy; `again()` asks for the same picture once more.
class CopyingRenderer {
  constructor(THREE, afterwards, again) {
    this.shared = sharedRenderer(THREE);
    this.quick = quickRenderer(THREE);
    this.shadowMap = this.shared.shadowMap;
    this.domElement = document.createElement("canvas");
    this.context = this.domElement.getContext("2d");
    this.ratio = 1;
    this.afterwards = afterwards;
    this.again = again;
    this.rests = false;    // whether the next picture was drawn quickly before, and is drawn smoothly now
    this.isQuick = false;  // whether the last one was drawn quickly
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
    clearTimeout(this.timer);
    this.isQuick = Boolean(this.quick) && !this.rests;
    this.copy(this.isQuick ? this.quick : this.shared, scene, camera);
    if (this.isQuick) this.timer = setTimeout(() => { this.rests = true; this.again(); }, REST_MS);
    this.rests = false;
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.afterwards(this.context, camera);
  }
  copy(renderer, scene, camera) {
    const { width, height } = this.domElement;
    const big = renderer.domElement;
    if (big.width < width || big.height < height) { // it only grows: a new size costs more than a frame
      renderer.setSize(Math.max(big.width, width), Math.max(big.height, height), false);
    }
    renderer.setViewport(0, 0, width, height);
    renderer.setScissor(0, 0, width, height);
    renderer.shadowMap.enabled = this.shadowMap.enabled;
    renderer.shadowMap.type = this.shadowMap.type;
    renderer.render(scene, camera);
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, width, height);
    this.context.drawImage(big, 0, big.height - height, width, height, 0, 0, width, height);
  }
  dispose() { clearTimeout(this.timer); }
}
