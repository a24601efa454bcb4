// The shape with which a body touches others: the half spaces that hold all of it, and points of its surface.

const mostFaces = 24;    // directions of its own, beside the 26 of a cube's faces, edges and corners
const mostPoints = 80;

class Hull {
  /// @param centre  of mass: all places are from there
  constructor(surface, centre) {
    const vertices = [];
    for (let i = 0; i < surface.vertices.length; i += 3) vertices.push(minus(surface.vertices.subarray(i, i + 3), centre));
    this.points = spreadPoints(vertices);                      // m
    this.planes = [...cubeDirections(), ...faceDirections(surface)].map(  // unit vector, and how far the body goes along it, m
      normal => ({normal, height: vertices.reduce((most, at) => Math.max(most, dot(normal, at)), -Infinity)}));
  }

  /// Where a point that moves in a straight line gets inside: the share of its way, and the direction of the plane; a share below 0
  /// is minus the depth (m) of a point that begins inside. Null if it stays outside.
  /// @param skin  by which the hull is larger, m
  enter([x, y, z], [right, up, on], skin) {
    let first = 0, last = 1, deepest = -Infinity, entered = null, nearest = null;
    for (const plane of this.planes) {
      const {normal: [a, b, c]} = plane, outside = a * x + b * y + c * z - plane.height - skin, rate = a * right + b * up + c * on;
      if (outside > 0) {
        if (outside > -rate * last) return null;
        if (outside >= -rate * first) [first, entered] = [-outside / rate, plane];
      } else if (rate > 0 && outside > -rate * last) {
        last = -outside / rate;
      }
      if (outside > deepest) [deepest, nearest] = [outside, plane];
    }
    if (first > last) return null;
    return entered ? {share: first, normal: entered.normal} : {share: deepest, normal: nearest.normal};
  }
}

function cubeDirections() {
  const directions = [];
  for (const x of [-1, 0, 1]) for (const y of [-1, 0, 1]) for (const z of [-1, 0, 1]) if (x || y || z) directions.push(unit([x, y, z]));
  return directions;
}

/// Of the flat parts of a surface, the largest first.
function faceDirections(surface) {
  const parts = new Map();
  let whole = 0;
  for (let triangle = 0; 3 * triangle < surface.triangles.length; ++triangle) {
    const [a, b, c] = [0, 1, 2].map(corner => vertexOf(surface, triangle, corner));
    const normal = cross(minus(b, a), minus(c, a)), area = Math.hypot(...normal);
    if (!(area > 0)) continue;
    const key = normal.map(part => Math.round(16 * part / area)).join();
    parts.set(key, plus(parts.get(key) ?? [0, 0, 0], normal));
    whole += area;
  }
  return [...parts.values()].filter(normal => Math.hypot(...normal) > 0.01 * whole)
    .sort((a, b) => Math.hypot(...b) - Math.hypot(...a)).slice(0, mostFaces).map(unit);
}

/// Each next point is the one that is farthest from all before.
function spreadPoints(vertices) {
  const apart = Float64Array.from(vertices, at => dot(at, at)), points = [];  // squares of distances, m^2
  while (points.length < mostPoints) {
    const next = apart.reduce((best, square, i) => square > apart[best] ? i : best, 0), [x, y, z] = vertices[next];
    if (!(apart[next] > 0)) break;
    for (let i = 0; i < apart.length; ++i) {
      const [a, b, c] = vertices[i], square = (a - x) ** 2 + (b - y) ** 2 + (c - z) ** 2;
      apart[i] = points.length ? Math.min(apart[i], square) : square;
    }
    points.push(vertices[next]);
  }
  return points;
}
