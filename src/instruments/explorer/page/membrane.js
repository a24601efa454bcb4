// Membranes of any outline, held at the rim: linear finite elements.

/// Wave numbers (1/m, ascending) and shapes with a mean square times area of 1 m2, of an outline in metres; its triangles.
/// Mass matrix: the mean of the consistent and the lumped one. On equal triangles the error of the wave numbers then falls with the
/// fourth power of their size.
function membraneModes(outline, count) {
  const {points, triangles, rim} = meshOfOutline(outline, Math.sqrt(areaOfOutline(outline) / Math.max(600, 20 * count)));
  const inner = [...points.keys()].slice(rim).sort((i, j) => points[i][0] - points[j][0]);  // a narrow band
  const place = new Map(inner.map((point, n) => [point, n]));
  if (inner.length < 2 * count) throw new Error("The outline is too thin. Draw a rounder one.");
  const unknowns = triangles.map(corners => corners.map(corner => place.get(corner) ?? -1));
  const width = Math.max(...unknowns.map(corners => Math.max(...corners) - Math.min(...corners.filter(n => n >= 0), Infinity)));
  const stiffness = new BandMatrix(inner.length, width), mass = new BandMatrix(inner.length, width);
  triangles.forEach((corners, t) => addTriangle(corners.map(corner => points[corner]), unknowns[t], stiffness, mass));
  const {squares, vectors} = lowestModes(stiffness, mass, count);
  return {
    waveNumbers: squares.map(Math.sqrt),
    heights: vectors.map(vector => points.map((_, point) => place.has(point) ? vector[place.get(point)] : 0)),
    points,
    triangles: Uint32Array.from(triangles.flat()),
  };
}

function addTriangle([a, b, c], unknowns, stiffness, mass) {
  const sides = [[c[0] - b[0], c[1] - b[1]], [a[0] - c[0], a[1] - c[1]], [b[0] - a[0], b[1] - a[1]]];
  const area = 0.5 * (sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0]);
  for (let i = 0; i < 3; ++i) {
    for (let j = 0; j < 3; ++j) {
      if (unknowns[i] < 0 || unknowns[j] < 0) continue;
      stiffness.add(unknowns[i], unknowns[j], (sides[i][0] * sides[j][0] + sides[i][1] * sides[j][1]) / (4 * area));
      mass.add(unknowns[i], unknowns[j], area / (i === j ? 4 : 24));
    }
  }
}

const knownModes = new WeakMap();  // of outlines of unit size

/// As formulaBody(), of a recipe with an outline that `length` multiplies.
function membraneBody(recipe, count) {
  const {outline, length, tension, density} = recipe;
  if (!knownModes.has(outline)) knownModes.set(outline, membraneModes(outline, count));
  const {waveNumbers, heights, points, triangles} = knownModes.get(outline), scale = 1 / (length * Math.sqrt(density));
  return {
    vertices: Float32Array.from(points.flatMap(([x, y]) => [length * x, length * y, 0])),
    triangles,
    frequency: waveNumbers.map(k => frequencyOfWave({tension, stiffness: 0, density}, k / length)),
    heights: heights.map(shape => shape.map(height => scale * height)),
  };
}
