// A body that moves as a whole: its mass, where it is, and how fast it goes.

/// Centre of mass, and moments of inertia about it over the mass (rows of a matrix, m^2). What a surface encloses has the same
/// density all over; what encloses nothing, as a membrane, is evenly thin.
/// A triangle or a tetrahedron of n corners has the second moments (sum of c c^T + s s^T)/(n (n + 1)) with s, the sum of its corners c.
function massParts({vertices, triangles}) {
  const {low, high} = boundsOf([{vertices}]), origin = scaled(plus(low, high), 0.5), sides = [];
  let turned = [0, 0, 0], area = 0;
  for (let triangle = 0; 3 * triangle < triangles.length; ++triangle) {
    const corners = [0, 1, 2].map(corner => minus(vertexOf({vertices, triangles}, triangle, corner), origin));
    const normal = scaled(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])), 0.5);
    turned = plus(turned, normal);
    area += lengthOf(normal);
    sides.push({corners, area: lengthOf(normal), volume: dot(normal, corners[0]) / 3});
  }
  const volume = sides.reduce((sum, side) => sum + side.volume, 0);
  const isClosed = lengthOf(turned) < 1e-3 * area && volume > 1e-6 * area ** 1.5, n = isClosed ? 4 : 3;
  let first = [0, 0, 0];
  const second = [[0, 0, 0], [0, 0, 0], [0, 0, 0]], whole = isClosed ? volume : area;
  for (const {corners, ...side} of sides) {
    const share = (isClosed ? side.volume : side.area) / whole, sum = corners.reduce(plus);
    first = plus(first, scaled(sum, share / n));
    for (const at of [...corners, sum]) at.forEach((x, i) => at.forEach((y, j) => second[i][j] += share * x * y / (n * (n + 1))));
  }
  first.forEach((x, i) => first.forEach((y, j) => second[i][j] -= x * y));
  const trace = second[0][0] + second[1][1] + second[2][2], least = 2e-3 * trace;  // a needle turns about its length no faster than steps can follow
  return {centre: plus(origin, first), inertia: second.map((row, i) => row.map((value, j) => (i === j ? trace + least : 0) - value))};
}

class RigidBody {
  /// At rest where its surface is.
  /// @param mass  kg
  constructor(surface, mass) {
    const {centre, inertia} = massParts(surface);
    Object.assign(this, {mass, origin: centre, position: centre, turn: [0, 0, 0, 1], velocity: [0, 0, 0], spin: [0, 0, 0]});
    this.inertia = inertia.map(row => scaled(row, mass));  // about the axes of the body, kg m^2
    this.inverse = inverted(this.inertia);
    this.hull = new Hull(surface, centre);
    this.reach = Math.max(...this.hull.points.map(point => lengthOf(point)));  // m, of its points from the centre
    this.face(this.turn);
  }

  toRoom(point) {
    return plus(this.position, applied(this.rows, point));
  }

  /// A direction of the room along the axes of the body.
  inBody(direction) {
    return applied(this.columns, direction);
  }

  /// From the room to the coordinates of its surface.
  toSurface(place) {
    return plus(this.origin, this.inBody(minus(place, this.position)));
  }

  /// m/s, of what is that far from the centre.
  velocityAt(arm) {
    return plus(this.velocity, cross(this.spin, arm));
  }

  /// By how fast an angular momentum turns it, rad/s.
  spinOf(momentum) {
    return applied(this.yields, momentum);
  }

  momentum() {
    return applied(this.rows, applied(this.inertia, this.inBody(this.spin)));
  }

  push(impulse, arm) {
    this.velocity = plus(this.velocity, scaled(impulse, 1 / this.mass));
    this.spin = plus(this.spin, this.spinOf(cross(arm, impulse)));
  }

  /// Moves on. The angular momentum stays; the spin is that in the middle of the step.
  advance(duration) {
    const momentum = this.momentum(), before = this.turn;
    this.face(turnedOn(before, scaled(this.spin, 0.5 * duration)));
    this.face(turnedOn(before, scaled(this.spinOf(momentum), duration)));
    this.spin = this.spinOf(momentum);
    this.position = plus(this.position, scaled(this.velocity, duration));
  }

  face(turn) {
    this.turn = turn;
    this.rows = rowsOf(turn);
    this.columns = transposed(this.rows);
    this.yields = product(product(this.rows, this.inverse), this.rows);  // the inverse of the inertia along the axes of the room
  }

  /// J
  kineticEnergy() {
    return 0.5 * (this.mass * dot(this.velocity, this.velocity) + dot(this.spin, this.momentum()));
  }

  /// The fastest that any of its points may go, m/s.
  speed() {
    return lengthOf(this.velocity) + this.reach * lengthOf(this.spin);
  }
}
