// Bodies that the page makes (the demonstration of van den Doel and Pai 1996), computed in the browser.

const madeModes = 30;
const disc = Array.from({length: 60}, (_, n) => [0.5 * Math.cos(Math.PI * n / 30), 0.5 * Math.sin(Math.PI * n / 30)]);

/// The numbers of each kind of body: what it begins with.
const recipes = {
  string: {length: 0.65, width: 0.001, tension: 70, stiffness: 0, density: 0.004, friction: 0.002, ends: "supported"},
  bar: {length: 0.3, width: 0.03, tension: 0, stiffness: 60, density: 1.2, friction: 0.002, ends: "free"},
  membrane: {length: 0.3, tension: 2000, stiffness: 0, density: 0.26, friction: 0.01, outline: disc},
  plate: {length: 0.3, width: 0.2, tension: 0, stiffness: 150, density: 16, friction: 0.002},
};

/// A body as readBody() gives them, in the plane z = 0 of its position. It radiates as if in an infinite rigid wall.
/// @param recipe  see ideal.js
function madeBody(name, recipe) {
  const {frequency, heights, ...flat} = (recipe.kind === "membrane" ? membraneBody : formulaBody)(recipe, recipe.modes ?? madeModes);
  const vertices = flat.vertices.map((coordinate, i) => coordinate + recipe.position[i % 3]), surface = {...flat, vertices};
  const {areas, centres} = triangleParts(surface);
  const isLong = ["string", "bar"].includes(recipe.kind);  // its density is that of a length
  const {low, high} = boundsOf([surface]), extent = Math.hypot(...minus(high, low));
  const volumes = heights.map(shape => volumesOf(shape, surface.triangles, areas));
  return {
    ...surface, name, recipe,
    mass: recipe.density * (isLong ? recipe.length : areas.reduce((sum, area) => sum + area)),
    frequency: Float64Array.from(frequency),
    materialDecay: Float64Array.from(frequency, hertz => Math.PI * hertz * recipe.friction),
    radiationDecay: Float64Array.from(frequency, (hertz, mode) => radiationDecay(volumes[mode], centres, extent, hertz, page.air)),
    shape: Float32Array.from(heights.flatMap(shape => shape.flatMap(height => [0, 0, height]))),
    shapeScale: new Float64Array(frequency.length).fill(1),
    channels: page.listeners.map(position => ({position, ...heardAt(position, surface, frequency, volumes, centres, page.air)})),
    proxies: [],
    airDensity: page.air.density,
    level: null, size: 1, friction: 1, tension: 1,
  };
}
