// The point of a surface that is nearest to a place.

/// Spheres around the triangles of a surface: their middles [3 x triangles] and radii [triangles], m.
function triangleSpheres(body) {
  const count = body.triangles.length / 3, middles = new Float64Array(3 * count), radii = new Float64Array(count);
  for (let triangle = 0; triangle < count; ++triangle) {
    const corners = [0, 1, 2].map(corner => vertexOf(body, triangle, corner)), middle = scaled(corners.reduce(plus), 1 / 3);
    middles.set(middle, 3 * triangle);
    radii[triangle] = Math.max(...corners.map(corner => lengthOf(minus(corner, middle))));
  }
  return {middles, radii};
}

/// Triangle, weights of its corners, and place.
function nearestOnSurface(body, place) {
  const {middles, radii} = body.spheres ??= triangleSpheres(body), [x, y, z] = place;
  const apart = radii.map((_, t) => Math.sqrt((middles[3 * t] - x) ** 2 + (middles[3 * t + 1] - y) ** 2 + (middles[3 * t + 2] - z) ** 2));
  const tried = triangle => {
    const corners = [0, 1, 2].map(corner => vertexOf(body, triangle, corner)), weights = nearestWeights(corners, place);
    const at = [0, 1, 2].map(axis => corners.reduce((sum, corner, i) => sum + weights[i] * corner[axis], 0));
    return {triangle, weights, place: at, distance: lengthOf(minus(at, place))};
  };
  let nearest = tried(apart.reduce((best, distance, t) => distance < apart[best] ? t : best, 0));
  apart.forEach((distance, t) => {
    if (distance - radii[t] >= nearest.distance) return;  // it can't be nearer
    const found = tried(t);
    if (found.distance < nearest.distance) nearest = found;
  });
  return nearest;
}

/// Weights of the corners of a triangle in its point that is nearest to a place.
function nearestWeights(corners, place) {
  const [a, b, c] = corners, normal = cross(minus(b, a), minus(c, a)), square = dot(normal, normal);
  const inside = [[b, c], [c, a], [a, b]].map(([from, to]) => dot(cross(minus(to, from), minus(place, from)), normal) / square);
  if (square > 0 && inside.every(weight => weight >= 0)) return inside;
  const sides = [[0, 1], [1, 2], [2, 0]].map(([from, to]) => {
    const way = minus(corners[to], corners[from]), along = dot(minus(place, corners[from]), way) / (dot(way, way) || 1);
    const share = Math.min(1, Math.max(0, along)), weights = [0, 0, 0];
    weights[from] = 1 - share;
    weights[to] = share;
    return {weights, apart: lengthOf(minus(plus(corners[from], scaled(way, share)), place))};
  });
  return sides.reduce((best, side) => side.apart < best.apart ? side : best).weights;
}
