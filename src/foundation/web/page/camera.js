// The camera that turns around the bodies.

function multiply(a, b) {  // columns of four
  const product = new Float32Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      for (let k = 0; k < 4; ++k) product[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return product;
}

/// The smallest and largest coordinates of bodies, m.
function boundsOf(bodies) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const {vertices} of bodies) {
    for (let i = 0; i < vertices.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], vertices[i]);
      high[i % 3] = Math.max(high[i % 3], vertices[i]);
    }
  }
  return {low, high};
}

class Camera {
  /// @param canvas  on which it draws
  constructor(canvas, bodies) {
    Object.assign(this, {canvas, bodies});
  }

  goHome() {
    const {low, high} = boundsOf(this.bodies);
    this.middle = [0, 1, 2].map(axis => (low[axis] + high[axis]) / 2);
    this.reach = 0.5 * Math.hypot(...minus(high, low));
    this.azimuth = -1.1;
    this.height = 0.45;
    this.distance = this.reach;
    this.distance = this.fittingDistance();
    this.atHome = true;  // until the user turns or zooms
    this.changed = true;
  }

  /// The distance from which every vertex is in the picture, m.
  fittingDistance() {
    const {right, up, forward} = this.axes(), margin = 0.92 * Camera.tangent, aspect = this.aspect();
    let distance = 0.2 * this.reach;
    for (const {vertices} of this.bodies) {
      for (let i = 0; i < vertices.length; i += 3) {
        const way = minus([vertices[i], vertices[i + 1], vertices[i + 2]], this.middle);
        const aside = Math.max(Math.abs(dot(way, right)) / aspect, Math.abs(dot(way, up)));
        distance = Math.max(distance, aside / margin - dot(way, forward));
      }
    }
    return distance;
  }

  /// Width over height of the canvas.
  aspect() {
    return this.canvas.clientWidth / this.canvas.clientHeight || 1;
  }

  turn(azimuth, height) {
    this.atHome = false;
    this.azimuth += azimuth;
    this.height = Math.min(1.55, Math.max(-1.2, this.height + height));
    this.changed = true;
  }

  zoom(factor) {
    this.atHome = false;
    this.distance = Math.min(20 * this.reach, Math.max(0.2 * this.reach, this.distance * factor));
    this.changed = true;
  }

  eye() {
    const flat = Math.cos(this.height);
    const way = [flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.height)];
    return [0, 1, 2].map(axis => this.middle[axis] + this.distance * way[axis]);
  }

  /// Unit vectors to the right, up, and forward.
  axes() {
    const forward = unit(minus(this.middle, this.eye()));
    const right = unit(cross(forward, [0, 0, 1]));
    return {right, up: cross(right, forward), forward};
  }

  camera() {
    const {right, up, forward} = this.axes(), eye = this.eye();
    const look = new Float32Array([right[0], up[0], -forward[0], 0, right[1], up[1], -forward[1], 0,
                                   right[2], up[2], -forward[2], 0, -dot(right, eye), -dot(up, eye), dot(forward, eye), 1]);
    const near = 0.05 * this.reach, far = 40 * this.reach, slope = 1 / Camera.tangent;
    const lens = new Float32Array([slope / this.aspect(), 0, 0, 0, 0, slope, 0, 0, 0, 0, (far + near) / (near - far), -1,
                                   0, 0, 2 * far * near / (near - far), 0]);
    return multiply(lens, look);
  }

  /// The ray through a place of the canvas, in CSS pixels.
  ray(x, y) {
    const {right, up, forward} = this.axes(), {clientWidth: width, clientHeight: height} = this.canvas;
    const across = Camera.tangent * (2 * x - width) / height, along = Camera.tangent * (height - 2 * y) / height;
    return {origin: this.eye(),
            direction: unit([0, 1, 2].map(axis => forward[axis] + across * right[axis] + along * up[axis]))};
  }

  /// Where points are seen: x and y on the canvas, CSS pixels, and depth before the eye, m; [3 x points].
  onScreen(points) {
    const {right, up, forward} = this.axes(), eye = this.eye(), seen = new Float32Array(points.length);
    const {clientWidth: width, clientHeight: height} = this.canvas, scale = height / (2 * Camera.tangent);
    for (let i = 0; i < points.length; i += 3) {
      const way = [points[i] - eye[0], points[i + 1] - eye[1], points[i + 2] - eye[2]], depth = dot(way, forward);
      seen[i] = width / 2 + scale * dot(way, right) / depth;
      seen[i + 1] = height / 2 - scale * dot(way, up) / depth;
      seen[i + 2] = depth;
    }
    return seen;
  }
}
Camera.tangent = Math.tan(0.35);  // of half the angle of view
