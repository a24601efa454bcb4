// The room: bodies drawn with WebGL. Runs after camera.js.

const vertexShader = `#version 300 es
in vec3 place;
in vec3 shape;
uniform mat4 camera;
uniform mat4 pose;
uniform float swing;
out vec3 point;
void main() {
  point = (pose * vec4(place + swing * shape, 1.0)).xyz;
  gl_Position = camera * vec4(point, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec3 point;
uniform vec3 colour;
uniform vec3 eye;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(point), dFdy(point)));
  float light = abs(dot(normal, normalize(eye - point)));
  float above = 0.5 + 0.5 * abs(normal.z);
  pixel = vec4(colour * (0.25 + 0.55 * light + 0.2 * above), 1.0);
}`;

class View extends Camera {
  constructor(canvas, bodies) {
    super(canvas, bodies);
    this.gl = canvas.getContext("webgl2", {antialias: true});
    if (!this.gl) throw new Error("This browser has no WebGL 2.");
    this.program = this.link();
    this.uniforms = Object.fromEntries(["camera", "pose", "eye", "colour", "swing"].map(
      name => [name, this.gl.getUniformLocation(this.program, name)]));
    this.pace = new Pace();
    this.meshes = bodies.map(body => this.upload(body));
    this.ground = this.upload(this.groundUnder());
    this.shown = null;  // {body, mode}
    this.poses = [];    // [bodies] to where they have moved, as camera(); of those that have not: nothing
    this.frames = 0;
    this.drawn = {time: 0, level: 0, moved: false};  // the last picture
    this.goHome();
  }

  link() {
    const {gl} = this;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  upload({vertices, triangles}) {
    const {gl} = this;
    const mesh = {array: gl.createVertexArray(), vertices: gl.createBuffer(), shape: gl.createBuffer()};
    gl.bindVertexArray(mesh.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    const place = gl.getAttribLocation(this.program, "place");
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
    mesh.all = mesh.coarse = this.indices(triangles);
    return mesh;
  }

  /// Body number `index` of the bodies is new or has another surface.
  put(index) {
    const {gl} = this, old = this.meshes[index];
    if (old) {
      gl.deleteVertexArray(old.array);
      for (const buffer of [old.vertices, old.shape, old.all.buffer]) gl.deleteBuffer(buffer);
    }
    this.meshes[index] = this.upload(this.bodies[index]);
    this.poses[index] = undefined;
    this.ground = this.upload(this.groundUnder());
    this.coarse = this.sizes = null;
    this.changed = true;
    if (this.atHome) this.goHome();
  }

  indices(triangles) {
    const {gl} = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    return {buffer, count: triangles.length};
  }

  /// Makes the meshes that are drawn while the room moves.
  coarsen() {
    this.coarse = true;
    const total = this.bodies.reduce((sum, {triangles}) => sum + triangles.length / 3, 0);
    this.bodies.forEach((body, index) => {
      this.gl.bindVertexArray(this.meshes[index].array);
      this.meshes[index].coarse = this.indices(coarseTriangles(body, Pace.triangles * body.triangles.length / 3 / total));
    });
  }

  /// m
  groundHeight() {
    const {low, high} = boundsOf(this.bodies);
    return low[2] - 0.003 * Math.max(...minus(high, low));
  }

  groundUnder() {
    const {low, high} = boundsOf(this.bodies);
    const margin = 0.3 * Math.max(...minus(high, low)), z = this.groundHeight();
    const [x0, y0, x1, y1] = [low[0] - margin, low[1] - margin, high[0] + margin, high[1] + margin];
    return {vertices: new Float32Array([x0, y0, z, x1, y0, z, x1, y1, z, x0, y1, z]),
            triangles: new Uint32Array([0, 1, 2, 0, 2, 3])};
  }

  /// Shows a mode of a body as a slow swing; null shows none.
  show(shown) {
    this.shown = shown;
    this.changed = true;
    if (!shown) return;
    const {vertices, shape} = this.bodies[shown.body];
    const swing = Float32Array.from(shape.subarray(shown.mode * vertices.length, (shown.mode + 1) * vertices.length));
    let largest = 0;
    for (let i = 0; i < swing.length; i += 3) largest = Math.max(largest, Math.hypot(swing[i], swing[i + 1], swing[i + 2]));
    this.setShape(shown.body, swing.map(part => part / largest));
  }

  /// How the vertices of a body move, [3 x vertices], m for a swing of 1.
  setShape(body, shape) {
    const {gl} = this, mesh = this.meshes[body];
    gl.bindVertexArray(mesh.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.shape);
    gl.bufferData(gl.ARRAY_BUFFER, shape, gl.DYNAMIC_DRAW);
    const place = gl.getAttribLocation(this.program, "shape");
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
  }

  /// Draws what has changed; to be called for each picture of the screen. What moves is drawn with as much detail as the
  /// machine can, what rests with all.
  /// @param time    ms
  /// @param chosen  index of the body that is highlighted
  animate(time, chosen) {
    const {clientWidth, clientHeight} = this.canvas, size = `${clientWidth} x ${clientHeight}`;
    if (size !== this.drawn.size && this.atHome) this.goHome();
    const moves = this.changed || this.shown !== null || chosen !== this.drawn.chosen || size !== this.drawn.size;
    if (moves && this.drawn.moved) this.pace.note(time - this.drawn.time);
    const level = moves ? this.pace.level : 0;
    if (moves || (this.drawn.level > 0 && time - this.drawn.time > 150)) {
      this.draw(time / 1000, chosen, level);
      this.changed = false;
      this.drawn = {time, level, chosen, size};
    }
    this.drawn.moved = moves;
  }

  /// @param time    s
  /// @param chosen  index of the body that is highlighted
  /// @param level   of Pace
  draw(time, chosen, level = 0) {
    const {gl, canvas, program, uniforms} = this;
    if (level > 0 && !this.coarse) this.coarsen();
    const ratio = (window.devicePixelRatio || 1) * (level > 1 ? 0.5 : 1);
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0.93, 0.94, 0.95, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.camera, false, this.camera());
    gl.uniform3fv(uniforms.eye, this.eye());
    const one = (mesh, pose, colour, swing) => {
      const {buffer, count} = level > 0 ? mesh.coarse : mesh.all;
      gl.uniformMatrix4fv(uniforms.pose, false, pose ?? View.unmoved);
      gl.uniform3fv(uniforms.colour, colour);
      gl.uniform1f(uniforms.swing, swing);
      gl.bindVertexArray(mesh.array);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    };
    one(this.ground, null, [0.8, 0.82, 0.84], 0);
    this.meshes.forEach((mesh, body) => {
      const colour = View.colours[body % View.colours.length];
      one(mesh, this.poses[body], body === chosen ? colour.map(part => Math.min(1, 1.25 * part)) : colour,
          this.swingOf(body, time));
    });
    ++this.frames;
  }

  /// By how much the shape of a body is added to its vertices.
  swingOf(body, time) {
    const swings = this.shown && this.shown.body === body;
    return swings ? 0.04 * this.bodySize(body) * Math.sin(2 * Math.PI * time) : 0;
  }

  bodySize(index) {
    this.sizes ??= this.bodies.map(body => {
      const {low, high} = boundsOf([body]);
      return Math.hypot(...minus(high, low));
    });
    return this.sizes[index];
  }
}
View.unmoved = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
View.colours = [[0.80, 0.47, 0.22], [0.30, 0.52, 0.70], [0.55, 0.62, 0.32], [0.72, 0.30, 0.34], [0.50, 0.42, 0.66],
                [0.86, 0.68, 0.28], [0.35, 0.60, 0.56], [0.60, 0.60, 0.60]];
