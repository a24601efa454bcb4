// Delaunay's triangulation of points in the plane, by adding one point after the other (Bowyer 1981, Watson 1981).

/// @param points  [[x, y], ...], no two alike
/// @return triangles [[a, b, c], ...] of indices, counter-clockwise
function triangulated(points) {
  const reach = 100 * Math.max(...points.flat().map(Math.abs), 1e-300);
  const all = [...points, [-reach, -reach], [reach, -reach], [0, reach]], first = points.length;
  let triangles = [withCircle(all, first, first + 1, first + 2)];
  points.forEach((point, index) => {
    const rim = new Map();  // sides of the triangles that go, by their corners; those between two of them go, too
    triangles = triangles.filter(triangle => {
      if ((point[0] - triangle.x) ** 2 + (point[1] - triangle.y) ** 2 > triangle.square) return true;
      const {a, b, c} = triangle;
      for (const [from, to] of [[a, b], [b, c], [c, a]]) {
        if (!rim.delete(`${to} ${from}`)) rim.set(`${from} ${to}`, [from, to]);
      }
      return false;
    });
    for (const [from, to] of rim.values()) triangles.push(withCircle(all, from, to, index));
  });
  return triangles.filter(({a, b, c}) => a < first && b < first && c < first).map(({a, b, c}) => [a, b, c]);
}

/// A triangle with the centre and the square of the radius of the circle around it.
function withCircle(points, a, b, c) {
  const [p, q, r] = [a, b, c].map(corner => points[corner]);
  const [bx, by, cx, cy] = [q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]], twice = 2 * (bx * cy - by * cx);
  const ofB = bx * bx + by * by, ofC = cx * cx + cy * cy;
  const x = (cy * ofB - by * ofC) / twice, y = (bx * ofC - cx * ofB) / twice;
  return {a, b, c, x: p[0] + x, y: p[1] + y, square: x * x + y * y};
}
