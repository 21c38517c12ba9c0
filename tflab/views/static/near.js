// When does a hand come near a control?  When the pointer is over it, or the keyboard reaches it: a moment before it
// moves, in which the kernel can get ready.

const isMenu = (control) => control.get("_options_labels") !== undefined;
const placeOf = (control) => control.get(isMenu(control) ? "index" : "value");

function controlsOf(model) {
  const names = model.widget_manager ? model.get("controls") : []; // an exported page has neither
  return Promise.all(names.map((name) => model.widget_manager.get_model(name.replace("IPY_MODEL_", ""))));
}

// Have `come(i)` called when a hand comes near the i-th of `controls()`, those in the box around `el`.
function onHand(el, around, controls, come) {
  let last = -1;
  const touch = ({ target }) => {
    const near = el.closest(around)?.contains(target)
      && target.closest?.(".widget-slider, .widget-dropdown, .widget-checkbox");
    const name = near && near.textContent;
    const i = near ? controls().findIndex((control) => name.startsWith(control.get("description"))) : -1;
    if (i >= 0 && i !== last) come(i);
    last = i;
  };
  const events = ["focusin", "pointerover"];
  for (const event of events) document.addEventListener(event, touch);
  return () => { for (const event of events) document.removeEventListener(event, touch); };
}

