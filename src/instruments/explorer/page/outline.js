// Outlines in the plane: polygons [[x, y], ...] without a repeated last corner.

/// Signed: positive where the corners go counter-clockwise.
function areaOfOutline(outline) {
  return outline.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = outline[(i + 1) % outline.length];
    return sum + 0.5 * (x * nextY - y * nextX);
  }, 0);
}

function isInside(outline, [x, y]) {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length];
    if (ay > y !== by > y && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
  });
  return inside;
}

function distanceToSide([x, y], [ax, ay], [bx, by]) {
  const [wx, wy] = [bx - ax, by - ay], along = ((x - ax) * wx + (y - ay) * wy) / (wx * wx + wy * wy || 1);
  const share = Math.min(1, Math.max(0, along));
  return Math.hypot(ax + share * wx - x, ay + share * wy - y);
}

const distanceToOutline = (outline, point) =>
  Math.min(...outline.map((corner, i) => distanceToSide(point, corner, outline[(i + 1) % outline.length])));

/// Whether two sides cross.
function crossesItself(outline) {
  const turn = (a, b, c) => Math.sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  const side = i => [outline[i], outline[(i + 1) % outline.length]];
  for (let i = 0; i < outline.length; ++i) {
    for (let j = i + 2; j < outline.length; ++j) {
      if (i === 0 && j === outline.length - 1) continue;  // neighbours
      const [[a, b], [c, d]] = [side(i), side(j)];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    }
  }
  return false;
}

/// A line with fewer points, none of the others farther away than the tolerance (Douglas and Peucker 1973).
function simplified(points, tolerance) {
  const last = points.length - 1;
  let farthest = 0, distance = 0;
  for (let i = 1; i < last; ++i) {
    const away = distanceToSide(points[i], points[0], points[last]);
    if (away > distance) [farthest, distance] = [i, away];
  }
  if (distance <= tolerance) return [points[0], points[last]];
  return [...simplified(points.slice(0, farthest + 1), tolerance).slice(0, -1), ...simplified(points.slice(farthest), tolerance)];
}

/// A drawn line, closed, as an outline about the origin whose longer extent is 1; counter-clockwise.
/// @throws Error where it encloses nothing or crosses itself
function outlineOfDrawing(points) {
  const extent = [0, 1].map(axis => [Math.min(...points.map(p => p[axis])), Math.max(...points.map(p => p[axis]))]);
  const size = Math.max(...extent.map(([low, high]) => high - low)), middle = extent.map(([low, high]) => (low + high) / 2);
  if (!(size > 0)) throw new Error("Draw a closed line: it becomes the rim of the membrane.");
  const unit = points.map(([x, y]) => [(x - middle[0]) / size, (y - middle[1]) / size]);
  const outline = simplified([...unit, unit[0]], 0.003).slice(0, -1);
  if (crossesItself(outline)) throw new Error("The outline crosses itself. Draw it again.");
  const area = areaOfOutline(outline);
  if (Math.abs(area) < 0.02) throw new Error("The outline is too thin. Draw a rounder one.");
  return area > 0 ? outline : outline.reverse();
}

/// Triangles inside an outline: points, triangles, and how many of the points, the first ones, are on the rim. Points are
/// shaken a little for the triangulation, so that no four are on a circle.
/// @param size  of the triangles, about
function meshOfOutline(outline, size) {
  const rim = outline.flatMap((corner, i) => {
    const [x, y] = corner, [toX, toY] = outline[(i + 1) % outline.length];
    const pieces = Math.ceil(Math.hypot(toX - x, toY - y) / size - 1e-9);
    return Array.from({length: pieces}, (_, n) => [x + n / pieces * (toX - x), y + n / pieces * (toY - y)]);
  });
  const points = [...rim], [xs, ys] = [0, 1].map(axis => outline.map(corner => corner[axis])), height = size * Math.sqrt(0.75);
  const rows = Math.ceil((Math.max(...ys) - Math.min(...ys)) / height), columns = Math.ceil((Math.max(...xs) - Math.min(...xs)) / size);
  for (let row = 0; row <= rows; ++row) {
    for (let column = 0; column <= columns; ++column) {  // a lattice of equal triangles
      const point = [Math.min(...xs) + (column + 0.5 * (row % 2)) * size, Math.min(...ys) + (row + 0.5) * height];
      if (isInside(outline, point) && distanceToOutline(outline, point) > 0.6 * size) points.push(point);
    }
  }
  const shaken = points.map((point, i) => point.map((part, axis) => part + 1e-5 * size * Math.sin(12.9898 * i + 78.233 * axis)));
  const triangles = triangulated(shaken).filter(corners =>
    isInside(outline, [0, 1].map(axis => corners.reduce((sum, corner) => sum + points[corner][axis] / 3, 0))));
  return {points, triangles, rim: rim.length};
}
