// Modes of strings, bars and plates by formula, as in src/instruments/sound_maps/ideal_map.cpp (van den Doel and Pai 1996).
// A recipe has the kind and the numbers of a body that the page makes: length and width (m); tension (N, of plates N/m),
// stiffness (N m2, of plates N m), density (kg/m, of plates kg/m2), friction tan(phi); the ends of a bar; position (m).

const cellsOfHalfWave = 4;

/// Hz. @param k  wave number, 1/m
function frequencyOfWave({tension, stiffness, density}, k) {
  return Math.sqrt((tension * k ** 2 + stiffness * k ** 4) / density) / (2 * Math.PI);
}

/// The lowest modes: frequency, half waves along x and y, and shape(x, y) for unit modal mass, 1/sqrt(kg).
function lineModes(recipe, count) {
  const {ends, length, density} = recipe, scale = 1 / Math.sqrt(density * length);
  return Array.from({length: count}, (_, index) => {
    const root = beamRoot(ends, index + 1);
    return {frequency: frequencyOfWave(recipe, root / length), along: index + 1, across: 0,
            shape: x => scale * beamShape(ends, root, x / length)};
  });
}

/// Likewise, of a plate that is simply supported.
function plateModes(recipe, count) {
  const {length, width, density} = recipe, scale = 2 / Math.sqrt(density * length * width), modes = [];
  for (let m = 1; m <= count; ++m) {
    for (let n = 1; m * n <= count; ++n) {  // at least m n modes are as low as this one
      const kx = m * Math.PI / length, ky = n * Math.PI / width;
      modes.push({frequency: frequencyOfWave(recipe, Math.hypot(kx, ky)), along: m, across: n,
                  shape: (x, y) => scale * Math.sin(kx * x) * Math.sin(ky * y)});
    }
  }
  return modes.sort((a, b) => a.frequency - b.frequency).slice(0, count);
}

/// A rectangle in the plane z = 0 in cells of two triangles each: vertices [3 x vertices] m, and triangles.
/// @param low, high  its sides along y, m
function rectangle(length, low, high, columns, rows) {
  const vertices = [], triangles = [];
  for (let j = 0; j <= rows; ++j) {
    for (let i = 0; i <= columns; ++i) vertices.push(length * i / columns, low + (high - low) * j / rows, 0);
  }
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const corner = j * (columns + 1) + i;
      triangles.push(corner, corner + 1, corner + columns + 2, corner, corner + columns + 2, corner + columns + 1);
    }
  }
  return {vertices: Float32Array.from(vertices), triangles: Uint32Array.from(triangles)};
}

/// Surface, frequencies (Hz) and heights of the shapes, [modes][vertices] 1/sqrt(kg).
function formulaBody(recipe, count) {
  const isPlate = recipe.kind === "plate", modes = (isPlate ? plateModes : lineModes)(recipe, count);
  const along = Math.max(4, ...modes.map(mode => mode.along)), across = Math.max(...modes.map(mode => mode.across));
  const half = recipe.width / 2, [low, high] = isPlate ? [0, recipe.width] : [-half, half];
  const surface = rectangle(recipe.length, low, high, cellsOfHalfWave * along, Math.max(1, cellsOfHalfWave * across));
  const places = [...Array(surface.vertices.length / 3).keys()].map(i => [surface.vertices[3 * i], surface.vertices[3 * i + 1]]);
  return {...surface, frequency: modes.map(mode => mode.frequency), heights: modes.map(({shape}) => places.map(([x, y]) => shape(x, y)))};
}
