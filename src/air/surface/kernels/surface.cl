// Reads of a surface's motion and their low-pass (O'Brien 2001, section 3.2). The displacements of SLOTS reads are in a
// ring: [SLOTS][3 x vertices], m. A call computes all outputs of one number, so the bits do not depend on the run.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable

/// Displacements of some vertices, at the end of a read.
/// @param place  of the first vertex in the ring
kernel void copy_displacements(int count, global const int* node, global const double4* displacement, int place,
                               global double* ring) {
  const int i = get_global_id(0);
  if (i < count) {
    vstore3(displacement[node[i]].xyz, i, ring + place);
  }
}

/// Adds a few inputs of a number to its outputs.
/// @param first      number of the first input within the audio sample
/// @param oldest     place of the output that is completed first
/// @param completes  whether this output is complete now: another one begins in its place
/// @param taps       [reads][2 outputs] as LowPass has them
/// @param sums       of this number: [outputs], `numbers` apart
/// @return the oldest output
static double low_pass(int numbers, int count, const double* input, int first, int outputs, int oldest, int completes,
                       global const double* taps, global double* sums) {
  double complete = 0.0;
  for (int place = 0; place < outputs; ++place) {
    global const double* tap = taps + 2 * outputs * first + outputs - oldest + place;
    double sum = sums[(ulong)place * numbers];
    for (int i = 0; i < count; ++i) {
      sum += tap[2 * outputs * i] * input[i];
    }
    if (place == oldest) {
      complete = sum;
      sum = completes ? 0.0 : sum;
    }
    sums[(ulong)place * numbers] = sum;
  }
  return complete;
}

/// @param numbers    3 x vertices
/// @param reads      new ones
/// @param begin      place in the ring of the read before them
/// @param reference  [numbers] m
/// @param position   [numbers] m, of the complete output
kernel void filter_displacements(int numbers, int reads, int begin, int first, int outputs, int oldest, int completes,
                                 global const double* taps, global const double* ring, global const double* reference,
                                 global double* sums, global double* position) {
  const int i = get_global_id(0);
  if (i >= numbers) {
    return;
  }
  double input[SLOTS - 1];
  for (int read = 0; read < reads; ++read) {
    input[read] = ring[(ulong)((begin + 1 + read) % SLOTS) * numbers + i];
  }
  position[i] = reference[i] + low_pass(numbers, reads, input, first, outputs, oldest, completes, taps, sums + i);
}

/// The pressure over a read, by the mean velocity and the normal of the mean position (eqs. 2-5).
/// @param scale       impedance times reads per second, over 3
/// @param begin, end  displacements of all vertices
static double pressure_of(double scale, int3 corner, global const double* reference, global const double* begin,
                          global const double* end) {
  const double3 moved = (vload3(corner.x, end) + vload3(corner.y, end) + vload3(corner.z, end)) -
                        (vload3(corner.x, begin) + vload3(corner.y, begin) + vload3(corner.z, begin));
  double3 mean[3];
  const int corners[3] = {corner.x, corner.y, corner.z};
  for (int i = 0; i < 3; ++i) {
    mean[i] = 0.5 * (vload3(corners[i], begin) + vload3(corners[i], end));
  }
  const double3 first = vload3(corner.x, reference);
  const double3 edge12 = (vload3(corner.y, reference) - first) + (mean[1] - mean[0]);
  const double3 edge13 = (vload3(corner.z, reference) - first) + (mean[2] - mean[0]);
  const double3 normal = cross(edge12, edge13);
  return scale * dot(moved, normal) / sqrt(fmax(dot(normal, normal), 1e-200));
}

/// The first parameters are those of filter_displacements().
/// @param values    3 x vertices
/// @param corners   [3 x triangles]
/// @param pressure  [triangles] Pa, of the complete output
kernel void filter_pressures(int triangles, int reads, int begin, int first, int outputs, int oldest, int completes,
                             global const double* taps, global const double* ring, global const double* reference,
                             int values, double scale, global const int* corners, global double* sums,
                             global double* pressure) {
  const int i = get_global_id(0);
  if (i >= triangles) {
    return;
  }
  const int3 corner = vload3(i, corners);
  double input[SLOTS - 1];
  for (int read = 0; read < reads; ++read) {
    input[read] = pressure_of(scale, corner, reference, ring + (ulong)((begin + read) % SLOTS) * values,
                              ring + (ulong)((begin + 1 + read) % SLOTS) * values);
  }
  pressure[i] = low_pass(triangles, reads, input, first, outputs, oldest, completes, taps, sums + i);
}
