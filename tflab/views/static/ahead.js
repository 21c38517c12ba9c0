// How does a scene follow a menu at once?  The kernel has said what each choice looks like before one is made.
//
//   a hand comes near the menu   --hand-->   the kernel draws every choice, and sends in what they differ
//   a choice is made                         drawn at once; the kernel hears of it, too, and what it
//                                            then draws is what counts

// Let a view show what the menu is at; `live.ahead` is what the kernel has sent, a list of commands for each choice.
function followMenu(view, model, live, el) {
  const undo = [];
  let menus = [];
  const show = () => {
    for (const menu of menus) view.take(live.ahead[placeOf(menu)] ?? []);
    view.drawNow();
  };
  controlsOf(model).then((found) => {
    menus = found;
    for (const menu of menus) {
      menu.on("change:index", show);
      undo.push(() => menu.off("change:index", show));
    }
  });
  undo.push(onHand(el, ".widget-box", () => menus, () => { if (!live.ahead.length) model.send({ type: "hand" }); }));
  return {
    // The kernel has drawn what the menus were `at`; somebody may be further already.
    mend(at) { if (menus.some((menu, i) => placeOf(menu) !== at[i])) show(); },
    stop() { for (const action of undo) action(); },
  };
}

