// Which point of which body is meant by a place on the screen.

const pickingReach = 8;  // CSS pixels by which a pointer may miss a body: a string is thinner than a pixel

/// Body and point of its surface at a place of the canvas, in CSS pixels: what is seen there, or else the nearest surface
/// in reach, from either side; or null.
function pick(view, x, y) {
  const ray = view.ray(x, y);
  let seen = null;
  view.bodies.forEach((body, index) => {
    const point = hit(body, ...rayOn(view.poses[index], ray));
    if (point && (!seen || point.distance < seen.point.distance)) seen = {body: index, point};
  });
  if (seen) return seen;
  view.bodies.forEach((body, index) => {
    const point = nearestOnScreen(view, index, [x, y]);
    if (point && (!seen || isBefore(point, seen.point))) seen = {body: index, point};
  });
  return seen;
}

/// Origin and direction of a ray as a body has them that has moved by a pose (View).
function rayOn(pose, {origin, direction}) {
  if (!pose) return [origin, direction];
  const columns = [0, 4, 8].map(at => pose.subarray(at, at + 3)), back = v => columns.map(column => dot(column, v));
  return [back(minus(origin, pose.subarray(12, 15))), back(direction)];
}

/// The vertices of a body where it has moved.
function movedVertices({vertices}, pose) {
  return pose ? vertices.map((_, i) => {
    const first = i - i % 3, row = i % 3;
    return pose[12 + row] + [0, 1, 2].reduce((sum, axis) => sum + pose[4 * axis + row] * vertices[first + axis], 0);
  }) : vertices;
}

const isBefore = (a, b) => a.pixels < b.pixels || (a.pixels === b.pixels && a.distance < b.distance);

/// Triangle, weights of its corners, place, normal, distance from the eye, and pixels by which it is missed; or null.
function nearestOnScreen(view, index, at) {
  const body = view.bodies[index], vertices = view.onScreen(movedVertices(body, view.poses[index]));
  let nearest = null;
  for (let triangle = 0; 3 * triangle < body.triangles.length; ++triangle) {
    const corners = [0, 1, 2].map(corner => vertices.subarray(3 * body.triangles[3 * triangle + corner]));
    if (corners.some(([, , depth]) => depth <= 0) || isFar(corners, at)) continue;
    const flat = nearestInTriangle(corners, at);
    const deep = flat.weights.map((weight, corner) => weight / corners[corner][2]), sum = deep[0] + deep[1] + deep[2];
    const found = {triangle, pixels: flat.pixels, weights: deep.map(weight => weight / sum), distance: 1 / sum};
    if (found.pixels <= pickingReach && (!nearest || isBefore(found, nearest))) nearest = found;
  }
  return nearest && {...nearest, ...placeOf(body, nearest)};
}

function isFar(corners, at) {
  return [0, 1].some(axis => corners.every(corner => corner[axis] < at[axis] - pickingReach) ||
                             corners.every(corner => corner[axis] > at[axis] + pickingReach));
}

/// The nearest point of a flat triangle: weights of its corners, and how far away it is.
function nearestInTriangle(corners, at) {
  const [a, b, c] = corners;
  const area = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  const whole = area(a, b, c), inside = [area(at, b, c), area(at, c, a), area(at, a, b)].map(part => part / whole);
  if (inside.every(weight => weight >= 0)) return {pixels: 0, weights: inside};
  const sides = [[0, 1], [1, 2], [2, 0]].map(([from, to]) => {
    const [p, q] = [corners[from], corners[to]], way = [q[0] - p[0], q[1] - p[1]];
    const along = ((at[0] - p[0]) * way[0] + (at[1] - p[1]) * way[1]) / (way[0] ** 2 + way[1] ** 2 || 1);
    const share = Math.min(1, Math.max(0, along)), weights = [0, 0, 0];
    weights[from] = 1 - share;
    weights[to] = share;
    return {pixels: Math.hypot(p[0] + share * way[0] - at[0], p[1] + share * way[1] - at[1]), weights};
  });
  return sides.reduce((best, side) => side.pixels < best.pixels ? side : best);
}

/// Place (m) and normal of a point of the surface.
function placeOf(body, {triangle, weights}) {
  const [a, b, c] = [0, 1, 2].map(corner => vertexOf(body, triangle, corner));
  return {place: [0, 1, 2].map(axis => weights[0] * a[axis] + weights[1] * b[axis] + weights[2] * c[axis]),
          normal: unit(cross(minus(b, a), minus(c, a)))};
}
