// How much is drawn while the room moves, so that it moves smoothly on a slow machine.

/// Fewer triangles between the same vertices: those in one cell of a grid become one (Rossignac and Borrel,
/// Multi-resolution 3D approximations for rendering complex scenes, 1993).
/// @param most  about how many are to remain
function coarseTriangles({vertices, triangles}, most) {
  if (triangles.length <= 3 * most) return triangles;
  const cell = Math.sqrt(3 * areaOf(vertices, triangles) / most);  // a surface has 1.5 vertices to a cell, and twice as many triangles
  const {low, high} = boundsOf([{vertices}]);
  const counts = [0, 1, 2].map(axis => Math.ceil((high[axis] - low[axis]) / cell) + 1);
  const first = new Map();  // vertex of each cell
  const chosen = new Uint32Array(vertices.length / 3);
  for (let vertex = 0; vertex < chosen.length; ++vertex) {
    let place = 0;
    for (let axis = 0; axis < 3; ++axis) place = place * counts[axis] + Math.floor((vertices[3 * vertex + axis] - low[axis]) / cell);
    if (!first.has(place)) first.set(place, vertex);
    chosen[vertex] = first.get(place);
  }
  const kept = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const a = chosen[triangles[i]], b = chosen[triangles[i + 1]], c = chosen[triangles[i + 2]];
    if (a !== b && b !== c && c !== a) kept.push(a, b, c);
  }
  return new Uint32Array(kept);
}

function areaOf(vertices, triangles) {
  let area = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map(corner => vertices.subarray(3 * triangles[i + corner], 3 * triangles[i + corner] + 3));
    area += 0.5 * Math.hypot(...cross(minus(b, a), minus(c, a)));
  }
  return area;
}

/// Chooses how much is drawn while something moves, by the time that pictures take.
class Pace {
  constructor() {
    this.level = 0;  // 0: everything; 1: few triangles; 2: at half the resolution, too
    this.begin();
  }

  begin() {
    this.mean = 0;  // ms a picture
    this.pictures = 0;
  }

  /// @param time  ms from one picture to the next
  note(time) {
    this.mean = this.pictures++ ? 0.7 * this.mean + 0.3 * time : time;
    if (this.pictures > 5 && this.mean > 1000 / 30 && this.level < 2) {
      ++this.level;
      this.begin();
    }
  }
}
Pace.triangles = 15000;  // of all bodies, from level 1 on
