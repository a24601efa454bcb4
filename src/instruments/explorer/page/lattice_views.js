// Views of the proxies from the top, the front and the side (O'Morain 2005, section 8.4): their masses, springs or surfaces.
// The colour is the level of detail, its strength the priority: the nearest body to the listener comes first.

const latticeSides = [{name: "top", right: [1, 0, 0], up: [0, 1, 0]}, {name: "front", right: [1, 0, 0], up: [0, 0, 1]},
                      {name: "side", right: [0, 1, 0], up: [0, 0, 1]}];
const levelColours = ["#1a7f37", "#b07d00", "#b33", "#639", "#246", "#0a7d7d"];
const modesColour = "#999";  // of a body whose modes sound

class LatticeViews {
  /// @param strike  is called with the number of a body and a point of its surface
  constructor(canvas, choice, legend, strike) {
    Object.assign(this, {canvas, choice, legend});
    this.pen = canvas.getContext("2d", {willReadFrequently: true});
    choice.onchange = () => this.draw();
    canvas.onclick = event => {
      const {left, top, width, height} = canvas.getBoundingClientRect();
      const seen = this.pick((event.clientX - left) * canvas.width / width, (event.clientY - top) * canvas.height / height);
      if (seen) strike(seen.body, seen.point);
    };
  }

  /// Bodies with proxies, the greatest priority first: number, level that is shown, its colour.
  shown() {
    const middle = [0, 1, 2].map(axis => page.listeners.reduce((sum, at) => sum + at[axis] / page.listeners.length, 0));
    return bodies.map((body, number) => ({body, number, level: body.proxies[body.level ?? 0]}))
      .filter(({level}) => level)
      .map(each => ({...each, distance: Math.hypot(...minus(each.level.centre, middle)),
                     colour: each.body.level === null ? modesColour : levelColours[each.body.level % levelColours.length]}))
      .sort((a, b) => a.distance - b.distance);
  }

  /// Pixels to a metre, and the middle of all that is shown.
  frame(shown) {
    const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
    for (const {level: {nodes}} of shown) {
      nodes.forEach((at, i) => {
        least[i % 3] = Math.min(least[i % 3], at);
        most[i % 3] = Math.max(most[i % 3], at);
      });
    }
    const extent = Math.max(...minus(most, least), 1e-9), {width, height} = this.canvas;
    return {scale: 0.9 * Math.min(width / 3, height) / extent, middle: least.map((at, axis) => 0.5 * (at + most[axis]))};
  }

  /// [x, y] of a place in a panel, pixels of the canvas.
  project(at, side, panel, {scale, middle}) {
    const way = minus(at, middle), {width, height} = this.canvas;
    return [(panel + 0.5) * width / 3 + scale * dot(way, side.right), 0.5 * height - scale * dot(way, side.up)];
  }

  draw() {
    const shown = this.shown(), {canvas, pen} = this;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    if (!shown.length) return;
    const frame = this.frame(shown);
    latticeSides.forEach((side, panel) => {
      [...shown].reverse().forEach((each, place) => {
        pen.globalAlpha = (place + 1) / shown.length * 0.75 + 0.25;
        pen.fillStyle = pen.strokeStyle = each.colour;
        this.drawLattice(pen, each.level, node => this.project(each.level.nodes.subarray(3 * node, 3 * node + 3), side, panel, frame));
      });
      pen.globalAlpha = 1;
      pen.fillStyle = "#555";
      pen.fillText(side.name, panel * canvas.width / 3 + 3, 10);
    });
    this.legend.textContent = shown.map(({body}, place) =>
      `${body.name}: ${body.level === null ? "modes" : `level ${body.level}`}, priority ${place + 1}`).join("; ");
  }

  drawLattice(pen, level, placeOfNode) {
    const places = Array.from(level.mass, (_, node) => placeOfNode(node));
    if (this.choice.value === "masses") {
      for (const [x, y] of places) pen.fillRect(x - 1, y - 1, 2, 2);
      return;
    }
    const isSurface = this.choice.value === "surface";
    pen.lineWidth = 0.5;
    pen.beginPath();
    for (const line of isSurface ? facing(level, places) : Array.from(level.a, (a, s) => [a, level.b[s]])) {
      pen.moveTo(...places[line[0]]);
      for (const node of line.slice(1)) pen.lineTo(...places[node]);
      if (isSurface) pen.closePath();
    }
    pen.stroke();
    pen.globalAlpha *= 0.4;
    if (isSurface) pen.fill();
  }

  /// Body and point of its surface at a place of the canvas, or null.
  pick(x, y) {
    const panel = Math.min(2, Math.floor(3 * x / this.canvas.width)), side = latticeSides[panel], shown = this.shown();
    if (!shown.length) return null;
    const {scale, middle} = this.frame(shown), away = cross(side.right, side.up), {width, height} = this.canvas;
    const across = (x - (panel + 0.5) * width / 3) / scale, upwards = (0.5 * height - y) / scale;
    const origin = middle.map((at, axis) => at + across * side.right[axis] + upwards * side.up[axis] + 1e3 * away[axis]);
    let seen = null;
    for (const {body, number} of shown) {
      const point = hit(body, origin, scaled(away, -1));
      if (point && (!seen || point.distance < seen.point.distance)) seen = {body: number, point};
    }
    return seen;
  }
}

/// The triangles of a level that are seen. @param places  [masses] [x, y] on the screen, y downwards
function facing(level, places) {
  const triangles = [];
  for (let t = 0; t < level.surface.length; t += 3) {
    const corners = [...level.surface.subarray(t, t + 3)], [a, b, c] = corners.map(node => places[node]);
    if ((b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0])) triangles.push(corners);
  }
  return triangles;
}
