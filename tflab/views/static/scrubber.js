// How does one go through time without a kernel?  A button that plays, a slider, and what it stands at.
//
// A track says its name, where it ends, how fine its steps are, how long it plays, and what to call a place.

const nameIn = ([text]) => text.split(/ = |: /)[0]; // of "time = 2.00 s"

function makeScrubber(track, onMove) {
  const bar = document.createElement("div");
  bar.className = "tflab-scrubber";
  bar.innerHTML = `<button type="button"></button><input type="range" min="0"><output></output>`;
  const [button, slider, output] = bar.children;
  slider.setAttribute("aria-label", track.name);
  slider.max = track.end;
  slider.step = track.step;
  let playing = 0;
  const show = (t) => {
    slider.value = t;
    output.textContent = track.text(t);
    slider.setAttribute("aria-valuetext", track.text(t));
  };
  const pause = () => {
    cancelAnimationFrame(playing);
    playing = 0;
    button.textContent = "▶";
    button.setAttribute("aria-label", "play");
  };
  const play = () => {
    const from = Number(slider.value) >= track.end ? 0 : Number(slider.value);
    const began = performance.now();
    button.textContent = "❚❚";
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
  slider.onkeydown = (event) => { // else JupyterLab takes the arrows for itself, and the slider stands still
    if (/^(Arrow|Page|Home|End)/.test(event.key)) event.stopPropagation();
  };
  slider.oninput = () => { pause(); onMove(Number(slider.value)); };
  pause();
  show(track.start);
  return { bar, show, play, pause };
}

