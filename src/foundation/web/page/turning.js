// The pointer and the keys turn a view, and the wheel zooms it. Runs after view.js.

function turnByPointer(canvas, view) {
  let last = null;
  canvas.onpointerdown = event => {
    canvas.setPointerCapture(event.pointerId);
    last = event;
  };
  canvas.onpointermove = event => {
    if (last) view.turn(-0.008 * (event.clientX - last.clientX), 0.008 * (event.clientY - last.clientY));
    last = last && event;
  };
  canvas.onpointerup = canvas.onpointercancel = () => last = null;
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    view.zoom(Math.exp(0.001 * event.deltaY));
  }, {passive: false});
}

function turnByKeys(canvas, view) {
  const actions = {
    ArrowLeft: () => view.turn(0.1, 0), ArrowRight: () => view.turn(-0.1, 0),
    ArrowUp: () => view.turn(0, 0.1), ArrowDown: () => view.turn(0, -0.1),
    "+": () => view.zoom(0.9), "-": () => view.zoom(1.1), 0: () => view.goHome(),
  };
  canvas.onkeydown = event => {
    if (!actions[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    actions[event.key]();
  };
}
