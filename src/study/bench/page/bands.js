// A surface in bands of colour: each band is drawn as a body of its own.

/// Blue where removed material lowers the partial, red where it raises it; then black for cuts, and grey for what is held.
const bandColours = [[0.13, 0.27, 0.55], [0.26, 0.47, 0.74], [0.48, 0.67, 0.87], [0.74, 0.85, 0.94], [0.95, 0.95, 0.93],
                     [0.97, 0.83, 0.74], [0.93, 0.62, 0.49], [0.83, 0.36, 0.29], [0.62, 0.12, 0.16], [0.12, 0.12, 0.12],
                     [0.6, 0.6, 0.6]];
const slopeBands = 9;
const cutBand = 9;
const heldBand = 10;

/// The band of a value between -largest and largest.
function bandOf(value, largest) {
  if (!Number.isFinite(value)) return heldBand;
  return Math.min(slopeBands - 1, Math.max(0, Math.floor((value / largest + 1) / 2 * slopeBands)));
}

class BandedView extends View {
  /// @param surface  {vertices, triangles}
  /// @param below    looks at it from below
  constructor(canvas, surface, below) {
    super(canvas, bandColours.map(() => ({vertices: surface.vertices, triangles: new Uint32Array(0)})));
    Object.assign(this, {surface, below});
    this.goHome();
  }

  goHome() {
    super.goHome();
    if (!this.below) return;
    this.height = -0.6;
    this.distance = this.fittingDistance();
  }

  /// Nothing hides the body from below.
  groundUnder() {
    return {vertices: new Float32Array(0), triangles: new Uint32Array(0)};
  }

  /// @param bands  [triangles] the band of each
  colour(bands) {
    const lists = bandColours.map(() => []);
    bands.forEach((band, triangle) => lists[band].push(...this.surface.triangles.subarray(3 * triangle, 3 * triangle + 3)));
    lists.forEach((list, band) => {
      this.bodies[band].triangles = Uint32Array.from(list);
      this.put(band);
    });
  }
}
View.colours = bandColours;
