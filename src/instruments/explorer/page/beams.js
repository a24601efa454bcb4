// Modes of a bar with various ends, by the formulas of src/instruments/sound_maps/beam_modes.cpp.

/// Root of cos x = sign/cosh x near x.
function rootNear(x, sign) {
  for (let newton = 0; newton < 30; ++newton) {
    const rest = Math.cos(x) - sign / Math.cosh(x);
    x -= rest / (-Math.sin(x) + sign * Math.tanh(x) / Math.cosh(x));
  }
  return x;
}

/// Wave number times length of mode n, counted from 1.
/// @param ends  "supported", "free", "clamped" or "clamped_free"
function beamRoot(ends, n) {
  if (ends === "supported") return Math.PI * n;
  if (ends === "clamped_free") return rootNear(Math.PI * (n - 0.5) + (n === 1 ? 0.3 : 0), -1);
  return rootNear(Math.PI * (n + 0.5), 1);
}

/// Shape at x from 0 to 1, with a mean square of 1.
function beamShape(ends, root, x) {
  if (ends === "supported") return Math.SQRT2 * Math.sin(root * x);
  const decay = Math.exp(-root), cosine = Math.cos(root), sine = Math.sin(root);
  const other = ends === "clamped_free" ? 1 : -1, sign = ends === "free" ? 1 : -1;
  const divisor = 0.5 * (1 - decay * decay) + other * decay * sine;
  const sigma = (0.5 * (1 + decay * decay) + other * decay * cosine) / divisor;
  const rest = 0.5 * (other * (sine - cosine) - decay) / divisor;
  const hyperbolic = 0.5 * (1 + sigma) * Math.exp(-root * x) + rest * Math.exp(root * (x - 1));
  return hyperbolic + sign * (Math.cos(root * x) - sigma * Math.sin(root * x));
}
