// What a flat body in an infinite rigid wall radiates: Rayleigh's integral over its triangles, as `idiophone map` has it for
// ideal bodies (src/instruments/sound_maps/sources.cpp).

/// Areas [triangles] m2 and centres [3 x triangles] m.
function triangleParts({vertices, triangles}) {
  const count = triangles.length / 3, areas = new Float64Array(count), centres = new Float64Array(3 * count);
  for (let t = 0; t < count; ++t) {
    const [a, b, c] = [0, 1, 2].map(corner => vertexOf({vertices, triangles}, t, corner));
    areas[t] = 0.5 * Math.hypot(...cross(minus(b, a), minus(c, a)));
    for (let axis = 0; axis < 3; ++axis) centres[3 * t + axis] = (a[axis] + b[axis] + c[axis]) / 3;
  }
  return {areas, centres};
}

/// Mean of a mode's heights over each triangle times its area.
function volumesOf(heights, triangles, areas) {
  return areas.map((area, t) => area / 3 * (heights[triangles[3 * t]] + heights[triangles[3 * t + 1]] + heights[triangles[3 * t + 2]]));
}

/// Half the directions of a half sphere; the others hear the same: [x, y, solid angle of both].
/// @param reach  half the extent of the body times the wave number: it is the more directional
function directionsOf(reach) {
  const parts = 1 + Math.floor(Math.min(reach, 40) / 4), azimuths = 3 + Math.ceil(Math.min(reach, 40));
  const found = [];
  for (let part = 0; part < parts; ++part) {
    for (const [point, weight] of gaussPoints) {
      const up = (part + 0.5 * (1 + point)) / parts, across = Math.sqrt(1 - up * up);
      for (let n = 0; n < azimuths; ++n) {
        const angle = Math.PI * (n + 0.5) / azimuths;
        found.push([across * Math.cos(angle), across * Math.sin(angle), weight * Math.PI / (parts * azimuths)]);
      }
    }
  }
  return found;
}

/// Loss of a mode by radiation, 1/s: the power for a modal velocity of 1, whose energy is 1/2 J.
/// @param extent  of the body, m
function radiationDecay(volumes, centres, extent, frequency, air) {
  const angular = 2 * Math.PI * frequency, k = angular / air.speed, pressure = air.density * angular / (2 * Math.PI);
  let power = 0;
  for (const [x, y, solidAngle] of directionsOf(k * extent / 2)) {
    let real = 0, imaginary = 0;
    for (let t = 0; t < volumes.length; ++t) {
      const phase = k * (x * centres[3 * t] + y * centres[3 * t + 1]);
      real += volumes[t] * Math.cos(phase);
      imaginary += volumes[t] * Math.sin(phase);
    }
    power += solidAngle * pressure ** 2 * (real ** 2 + imaginary ** 2) / (2 * air.density * air.speed);
  }
  return power;
}

/// Pressure of each mode for a modal velocity of 1 at a place, [2 x modes] Pa, and the delay (s) by which it is turned.
function heardAt(position, surface, frequency, volumes, centres, air) {
  const distances = Float64Array.from(volumes[0], (_, t) => Math.hypot(...minus(position, centres.subarray(3 * t, 3 * t + 3))));
  let nearest = Infinity;
  for (let i = 0; i < surface.vertices.length; i += 3) {
    nearest = Math.min(nearest, Math.hypot(...minus(position, surface.vertices.subarray(i, i + 3))));
  }
  const isBefore = position[2] > surface.vertices[2];  // behind the wall it is silent
  const pressure = frequency.flatMap((hertz, mode) => {
    const angular = 2 * Math.PI * hertz, scale = isBefore ? air.density * angular / (2 * Math.PI) : 0;
    let real = 0, imaginary = 0;  // of i exp(-i k (r - nearest))
    distances.forEach((distance, t) => {
      const phase = angular / air.speed * (distance - nearest), share = scale * volumes[mode][t] / distance;
      real += share * Math.sin(phase);
      imaginary += share * Math.cos(phase);
    });
    return [real, imaginary];
  });
  return {delay: nearest / air.speed, pressure: Float64Array.from(pressure)};
}
