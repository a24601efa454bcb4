// Bodies of the room: their sound maps out of the page's data, points on their surfaces, and what a slider changes.

function decoded(text, Type) {
  const bytes = Uint8Array.from(atob(text), character => character.charCodeAt(0));
  return new Type(bytes.buffer);
}

/// @param data  one body, as the program writes it (src/instruments/explorer/explorer_page.cpp)
function readBody(data) {
  return {
    ...data,
    frequency: decoded(data.frequency, Float64Array),            // Hz
    materialDecay: decoded(data.material_decay, Float64Array),   // 1/s
    radiationDecay: decoded(data.radiation_decay, Float64Array), // 1/s
    vertices: decoded(data.vertices, Float32Array),              // [3 x vertices] m
    triangles: decoded(data.triangles, Uint32Array),             // [3 x triangles]
    shape: decoded(data.shape, Int16Array),                      // [modes][3 x vertices] times shapeScale
    shapeScale: decoded(data.shape_scale, Float64Array),         // [modes] 1/sqrt(kg)
    channels: data.listeners.map(({name, delay, position, pressure}) =>
      ({name, delay, position, pressure: decoded(pressure, Float64Array)})),
    proxies: data.proxies.map(readLevel),
    stretching: data.stretching ? readStretching(data.stretching) : null,  // of large vibrations
    level: null,  // of the proxy that is struck; null: the modes are
    size: 1,      // times the lengths of the map
    friction: 1,  // times the decay by the material
    tension: 1,   // times the springs of the proxies
  };
}

/// How modes stretch their body (docs/method/large_amplitudes.md), as the program writes it.
function readStretching({linear, rotation, places, values}) {
  return {
    linear: decoded(linear, Float32Array),      // A [terms x modes]
    rotation: decoded(rotation, Float32Array),  // T [modes x modes]
    places: decoded(places, Uint32Array),       // [pairs] in H [terms x modes x modes], where it is not zero; each pair once
    values: decoded(values, Float32Array),      // [pairs] of H
  };
}

/// A proxy at one level of detail, as the program writes it (src/instruments/explorer/proxy_data.cpp).
function readLevel(data) {
  return {
    ...data,  // free, centre in m, inverseInertia in 1/(kg m2), damping, largest angular frequency in rad/s
    nodes: decoded(data.nodes, Float64Array),                // [3 x masses] m
    mass: decoded(data.mass, Float64Array),                  // [masses] kg
    inverseMass: decoded(data.inverse_mass, Float64Array),   // [masses] 1/kg, zero for pinned ones
    a: decoded(data.a, Uint32Array),                         // [springs] masses
    b: decoded(data.b, Uint32Array),
    stiffness: decoded(data.stiffness, Float64Array),        // [springs] N/m
    surface: decoded(data.surface, Uint32Array),             // [3 x triangles]
  };
}

// A body of the same material whose lengths are `size` times as long: frequencies and decay rates fall by that factor,
// the modal mass grows with its cube, the pressure for a modal velocity falls with its square root.
function frequencyOf(body, mode) {
  return body.frequency[mode] / body.size;
}

function decayOf(body, mode) {
  return (body.friction * body.materialDecay[mode] + body.radiationDecay[mode]) / body.size;
}

/// What the audio thread needs of a body: all modes, in every tuning.
function tuningOf(body) {
  const modes = [...body.frequency.keys()];
  return {
    frequency: Float64Array.from(modes, mode => frequencyOf(body, mode)),
    decay: Float64Array.from(modes, mode => decayOf(body, mode)),
    pressure: body.channels.map(({pressure}) => pressure.map(part => part / Math.sqrt(body.size))),
    delay: body.channels.map(({delay}) => delay),
    size: body.size,
  };
}

/// phi . direction of each mode at a point of the surface, 1/sqrt(kg).
/// @param point  triangle, and weights of its corners
function participationOf(body, {triangle, weights}, direction) {
  const length = body.vertices.length;
  return body.frequency.map((_, mode) => {
    let sum = 0;
    for (let corner = 0; corner < 3; ++corner) {
      const at = mode * length + 3 * body.triangles[3 * triangle + corner];
      for (let axis = 0; axis < 3; ++axis) sum += weights[corner] * body.shape[at + axis] * direction[axis];
    }
    return sum * body.shapeScale[mode] / body.size ** 1.5;
  });
}

function vertexOf(body, triangle, corner) {
  const at = 3 * body.triangles[3 * triangle + corner];
  return [body.vertices[at], body.vertices[at + 1], body.vertices[at + 2]];
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
const unit = a => scaled(a, 1 / Math.hypot(...a));

/// Where a ray first meets the surface: triangle, weights of its corners, place, outward normal and distance; or null.
function hit(body, origin, direction) {
  let nearest = null;
  for (let triangle = 0; 3 * triangle < body.triangles.length; ++triangle) {
    const a = vertexOf(body, triangle, 0), b = vertexOf(body, triangle, 1), c = vertexOf(body, triangle, 2);
    const first = minus(b, a), second = minus(c, a), normal = cross(first, second);
    const towards = -dot(direction, normal);
    if (towards <= 0) continue;  // seen from behind
    const distance = dot(minus(origin, a), normal) / towards;
    if (distance < 0 || (nearest && distance >= nearest.distance)) continue;
    const place = [0, 1, 2].map(axis => origin[axis] + distance * direction[axis]);
    const way = minus(place, a), square = dot(normal, normal);
    const v = dot(cross(way, second), normal) / square, w = dot(cross(first, way), normal) / square;
    if (v < 0 || w < 0 || v + w > 1) continue;
    nearest = {triangle, weights: [1 - v - w, v, w], place, normal: unit(normal), distance};
  }
  return nearest;
}
