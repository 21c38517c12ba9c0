// One picture of many, and a scrubber to go through them.  The Python half is slider_frames.py.

function picturesIn(data) { // each after its length
  const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  const numbers = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const pictures = [];
  for (let i = 0; i < bytes.length;) {
    const length = numbers.getUint32(i, true);
    pictures.push(new Blob([bytes.subarray(i + 4, i + 4 + length)], { type: "image/png" }));
    i += 4 + length;
  }
  return pictures;
}

export default {
  render({ model, el }) {
    const addresses = picturesIn(model.get("pictures")).map((picture) => URL.createObjectURL(picture));
    const texts = model.get("texts"), words = model.get("words");
    const box = document.createElement("div");
    const image = document.createElement("img");
    box.className = "tflab-film";
    box.style.maxWidth = `${model.get("width")}px`;
    const show = (step) => { image.src = addresses[step]; image.alt = words[step]; };
    const track = {
      end: addresses.length - 1, step: 1, seconds: 4, start: model.get("position"), play: false,
      name: nameIn(texts), text: (t) => texts[Math.round(t)],
    };
    const scrubber = makeScrubber(track, (t) => {
      model.set("position", Math.round(t));
      model.save_changes();
    });
    const move = () => { show(model.get("position")); scrubber.show(model.get("position")); };
    model.on("change:position", move);
    show(track.start);
    box.append(image, scrubber.bar);
    el.append(box);
    return () => {
      scrubber.pause();
      model.off("change:position", move);
      addresses.forEach(URL.revokeObjectURL);
    };
  },
};
