// A step of central differences of the nodes. Each sum of forces is added up by one call, element after element, so the
// bits do not depend on the run. Of the four components of a displacement or velocity, the last one means nothing.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable

/// A vector without its held components.
/// @param held  bits 1, 2, 4 for x, y, z
static double4 free_components(int held, double4 vector) {
  return (double4)((held & 1) != 0 ? 0.0 : vector.x, (held & 2) != 0 ? 0.0 : vector.y,
                   (held & 4) != 0 ? 0.0 : vector.z, 0.0);
}

/// v becomes keep v + gain (f/m + gravity) at the owned nodes, and 0 where they are held; u becomes u + step v.
/// @param points   quadrature points of all elements
/// @param first    [nodes + 1] of each node, in `places`
/// @param places   element times NODES plus the place of the node in it
/// @param step     s; 0: displacements stay
kernel void advance_nodes(int nodes, int points, global const int* first, global const int* places,
                          global const double* flux, global const double* inverse_mass, global const int* held,
                          double keep, double gain, double gravity_x, double gravity_y, double gravity_z, double step,
                          global double4* velocity, global double4* displacement) {
  const int node = get_global_id(0);
  if (node >= nodes) {
    return;
  }
  double force[3] = {0.0, 0.0, 0.0};
  for (int i = first[node]; i < first[node + 1]; ++i) {
    const int element = places[i] / NODES, place = places[i] % NODES;
    for (int c = 0; c < 3; ++c) {
      force[c] += force_on(place, c, points, flux + (ulong)element * POINTS);
    }
  }
  const double4 acceleration = (double4)(force[0], force[1], force[2], 0.0) * inverse_mass[node] +
                               (double4)(gravity_x, gravity_y, gravity_z, 0.0);
  const double4 next = free_components(held[node], keep * velocity[node] + gain * acceleration);
  velocity[node] = next;
  displacement[node] = fma(step, next, displacement[node]);
}

/// Adds gain f/m to the velocities of some nodes.
/// @param force  [3 x count] N
kernel void push_nodes(int count, global const int* nodes, global const double* force,
                       global const double* inverse_mass, global const int* held, double gain,
                       global double4* velocity) {
  const int i = get_global_id(0);
  if (i < count) {
    const int node = nodes[i];
    const double4 here = (double4)(force[3 * i], force[3 * i + 1], force[3 * i + 2], 0.0);
    velocity[node] += free_components(held[node], gain * inverse_mass[node] * here);
  }
}

/// u becomes u + step v.
kernel void displace_nodes(int nodes, double step, global const double4* velocity, global double4* displacement) {
  const int node = get_global_id(0);
  if (node < nodes) {
    displacement[node] = fma(step, velocity[node], displacement[node]);
  }
}

/// The motion of some nodes: displacement and velocity, 6 numbers each.
kernel void gather_motion(int count, global const int* nodes, global const double* displacement,
                          global const double* velocity, global double* motion) {
  const int i = get_global_id(0);
  if (i >= 6 * count) {
    return;
  }
  const ulong at = 4 * (ulong)nodes[i / 6] + i % 3;
  motion[i] = i % 6 < 3 ? displacement[at] : velocity[at];
}

/// The reverse.
kernel void scatter_motion(int count, global const int* nodes, global const double* motion,
                           global double* displacement, global double* velocity) {
  const int i = get_global_id(0);
  if (i >= 6 * count) {
    return;
  }
  const ulong at = 4 * (ulong)nodes[i / 6] + i % 3;
  if (i % 6 < 3) {
    displacement[at] = motion[i];
  } else {
    velocity[at] = motion[i];
  }
}
