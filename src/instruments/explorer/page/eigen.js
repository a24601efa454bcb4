// The lowest modes of K x = square M x for symmetric band matrices: subspace iteration (Bathe, Finite Element Procedures,
// section 11.6). It finds modes of equal frequency, too.

/// A symmetric matrix whose entries are zero farther than `width` from the diagonal.
class BandMatrix {
  constructor(size, width) {
    Object.assign(this, {size, width, values: new Float64Array(size * (width + 1))});
  }

  /// Place of an entry of the lower triangle.
  at(row, column) {
    return row * (this.width + 1) + column - row + this.width;
  }

  add(row, column, value) {
    if (row >= column) this.values[this.at(row, column)] += value;
  }

  times(x) {
    const y = new Float64Array(this.size);
    for (let i = 0; i < this.size; ++i) {
      for (let j = Math.max(0, i - this.width); j < i; ++j) {
        const value = this.values[this.at(i, j)];
        y[i] += value * x[j];
        y[j] += value * x[i];
      }
      y[i] += this.values[this.at(i, i)] * x[i];
    }
    return y;
  }

  /// Becomes its Cholesky factor. @throws Error where the matrix is not positive definite
  factorise() {
    const {size, width, values} = this;
    for (let i = 0; i < size; ++i) {
      for (let j = Math.max(0, i - width); j <= i; ++j) {
        let sum = values[this.at(i, j)];
        for (let k = Math.max(0, i - width, j - width); k < j; ++k) sum -= values[this.at(i, k)] * values[this.at(j, k)];
        if (i === j && !(sum > 0)) throw new Error("The triangles of the outline are degenerate. Draw another one.");
        values[this.at(i, j)] = i === j ? Math.sqrt(sum) : sum / values[this.at(j, j)];
      }
    }
    return this;
  }

  /// Solution of L x = b, or with `upper` of L' x = b, for a factor L.
  solve(b, upper = false) {
    const x = Float64Array.from(b), {size, width, values} = this;
    for (let n = 0; n < size; ++n) {
      const i = upper ? size - 1 - n : n;
      if (upper) {
        x[i] /= values[this.at(i, i)];
        for (let j = Math.max(0, i - width); j < i; ++j) x[j] -= values[this.at(i, j)] * x[i];
      } else {
        for (let j = Math.max(0, i - width); j < i; ++j) x[i] -= values[this.at(i, j)] * x[j];
        x[i] /= values[this.at(i, i)];
      }
    }
    return x;
  }
}

/// Eigenvalues and eigenvectors (rows) of a full symmetric matrix [[...], ...], which is lost: Jacobi's rotations.
function eigenOfSymmetric(a) {
  const size = a.length, vectors = a.map((row, i) => row.map((_, j) => Number(i === j)));
  const rotateRows = (p, q, c, s) => {
    for (let k = 0; k < size; ++k) {
      const x = p[k], y = q[k];
      p[k] = c * x - s * y;
      q[k] = s * x + c * y;
    }
  };
  const rotateColumns = (rows, p, q, c, s) => {
    for (const row of rows) {
      const x = row[p], y = row[q];
      row[p] = c * x - s * y;
      row[q] = s * x + c * y;
    }
  };
  for (let sweep = 0; sweep < 30; ++sweep) {
    let rest = 0;
    for (let p = 0; p < size; ++p) {
      for (let q = p + 1; q < size; ++q) {
        if (Math.abs(a[p][q]) <= 1e-14 * Math.sqrt(Math.abs(a[p][p] * a[q][q]))) continue;
        rest = 1;
        const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]), t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
        const c = 1 / Math.hypot(t, 1), s = t * c;
        rotateRows(a[p], a[q], c, s);
        rotateColumns(a, p, q, c, s);
        rotateRows(vectors[p], vectors[q], c, s);
      }
    }
    if (!rest) break;
  }
  return {values: a.map((row, i) => row[i]), vectors};
}

/// Any vectors that have a part of every mode.
function startingVectors(size, count) {
  const vectors = [];
  for (let n = 1; n <= count; ++n) vectors.push(Float64Array.from({length: size}, (_, i) => Math.sin(n * (i + 1.5) ** 1.1)));
  return vectors;
}

function innerProduct(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += a[i] * b[i];
  return sum;
}

/// Sum of rows, each times its share.
function mixture(rows, shares) {
  const sum = new Float64Array(rows[0].length);
  rows.forEach((row, n) => {
    for (let i = 0; i < sum.length; ++i) sum[i] += shares[n] * row[i];
  });
  return sum;
}

/// The lowest modes, ascending: squares, and vectors with x' M x = 1.
function lowestModes(stiffness, mass, count) {
  const size = mass.size, width = Math.min(size, count + 20);
  const factor = stiffness.factorise();
  let pushed = startingVectors(size, width);
  let squares = new Array(width).fill(0);
  for (let iteration = 0; iteration < 60; ++iteration) {
    const moved = pushed.map(force => factor.solve(factor.solve(force), true)), heavy = moved.map(x => mass.times(x));
    const small = new BandMatrix(width, width - 1);  // x' M x
    for (let i = 0; i < width; ++i) for (let j = 0; j <= i; ++j) small.add(i, j, innerProduct(moved[i], heavy[j]));
    small.factorise();
    const left = moved.map(x => small.solve(pushed.map(force => innerProduct(x, force))));  // L^-1 (x' K x), by rows
    const reduced = left.map((_, i) => small.solve(left.map(row => row[i])));
    const {values, vectors} = eigenOfSymmetric(reduced.map(row => Array.from(row)));
    const order = [...values.keys()].sort((i, j) => values[i] - values[j]);
    const shares = order.map(i => small.solve(vectors[i], true)), before = squares;
    squares = order.map(i => values[i]);
    pushed = shares.map(share => mixture(heavy, share));
    if (squares.slice(0, count).every((square, i) => Math.abs(square - before[i]) < 1e-6 * square)) {
      return {squares: squares.slice(0, count), vectors: shares.slice(0, count).map(share => mixture(moved, share))};
    }
  }
  throw new Error("The modes of the outline were not found. Draw another one.");
}
