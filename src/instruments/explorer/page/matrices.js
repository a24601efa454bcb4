// Vectors, matrices and turns of rigid bodies. A matrix is a list of three rows.

const lengthOf = a => Math.sqrt(dot(a, a));  // much faster than Math.hypot()
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const applied = (rows, v) => [dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)];
const transposed = ([a, b, c]) => [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]];

/// The rows of a product, by the rows of the first matrix and the columns of the second.
const product = ([a, b, c], columns) => [applied(columns, a), applied(columns, b), applied(columns, c)];

/// Inverse of a symmetric matrix.
function inverted([a, b, c]) {
  const columns = [cross(b, c), cross(c, a), cross(a, b)];
  return transposed(columns.map(column => scaled(column, 1 / dot(a, columns[0]))));
}

/// Quaternion [x, y, z, w] as the rows of a matrix.
function rowsOf([x, y, z, w]) {
  return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
          [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
          [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]];
}

/// The quaternion of such rows: the largest of the four multiples of it that they give.
function turnOf([[a, b, c], [d, e, f], [g, h, i]]) {
  const multiples = [[1 + a - e - i, b + d, c + g, h - f], [b + d, 1 - a + e - i, f + h, c - g],
                     [c + g, f + h, 1 - a - e + i, d - b], [h - f, c - g, d - b, 1 + a + e + i]];
  const sizes = multiples.map(turn => Math.hypot(...turn)), largest = sizes.indexOf(Math.max(...sizes));
  return multiples[largest].map(part => part / sizes[largest]);
}

/// A quaternion turned on by an angle about an axis: the length of `by`, rad, and its direction, in the room.
function turnedOn([x, y, z, w], by) {
  const angle = lengthOf(by), part = angle > 1e-9 ? Math.sin(0.5 * angle) / angle : 0.5;
  const [a, b, c] = scaled(by, part), d = Math.cos(0.5 * angle);
  const turn = [d * x + a * w + b * z - c * y, d * y - a * z + b * w + c * x, d * z + a * y - b * x + c * w, d * w - a * x - b * y - c * z];
  const size = Math.hypot(...turn);
  return turn.map(part_ => part_ / size);
}
