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
/// @param all      nodes with ghosts: [2][all] displacements and velocities are the motion
/// @param points   quadrature points of all elements
/// @param places   element times NODES plus the place of the node in it
/// @param step     s; 0: displacements stay
kernel void advance_nodes(int nodes, int all, int points, global const struct NodeEntry* entries,
                          global const int* places, global const double* flux, double keep, double gain,
                          double gravity_x, double gravity_y, double gravity_z, double step, global double4* motion) {
  const int node = get_global_id(0);
  if (node >= nodes) {
    return;
  }
  double force[3] = {0.0, 0.0, 0.0};
  for (int i = entries[node].places; i < entries[node + 1].places; ++i) {
    const int element = places[i] / NODES, place = places[i] % NODES;
    for (int c = 0; c < 3; ++c) {
      force[c] += force_on(place, c, points, flux + (ulong)element * POINTS);
    }
  }
  const double4 acceleration = (double4)(force[0], force[1], force[2], 0.0) * entries[node].inverse_mass +
                               (double4)(gravity_x, gravity_y, gravity_z, 0.0);
  const double4 next = free_components(entries[node].held, keep * motion[all + node] + gain * acceleration);
  motion[all + node] = next;
  motion[node] = fma(step, next, motion[node]);
}

/// Adds gain f/m to the velocities of some nodes.
/// @param force  [3 x count] N
kernel void push_nodes(int count, int all, global const int* nodes, global const double* force,
                       global const struct NodeEntry* entries, double gain, global double4* motion) {
  const int i = get_global_id(0);
  if (i < count) {
    const int node = nodes[i];
    const double4 here = (double4)(force[3 * i], force[3 * i + 1], force[3 * i + 2], 0.0);
    motion[all + node] += free_components(entries[node].held, gain * entries[node].inverse_mass * here);
  }
}

/// u becomes u + step v.
kernel void displace_nodes(int nodes, int all, double step, global double4* motion) {
  const int node = get_global_id(0);
  if (node < nodes) {
    motion[node] = fma(step, motion[all + node], motion[node]);
  }
}

/// Where one of the 6 numbers of each of some nodes, displacement and velocity, is in the motion of all.
static ulong place_in_motion(int i, int all, global const int* nodes) {
  const ulong node = (ulong)nodes[i / 6] + (i % 6 < 3 ? 0 : all);
  return 4 * node + i % 3;
}

/// The motion of some nodes.
kernel void gather_motion(int count, int all, global const int* nodes, global const double* motion,
                          global double* gathered) {
  const int i = get_global_id(0);
  if (i < 6 * count) {
    gathered[i] = motion[place_in_motion(i, all, nodes)];
  }
}

/// The reverse.
kernel void scatter_motion(int count, int all, global const int* nodes, global const double* gathered,
                           global double* motion) {
  const int i = get_global_id(0);
  if (i < 6 * count) {
    motion[place_in_motion(i, all, nodes)] = gathered[i];
  }
}
