// Spectral hexahedra: PLANE nodes along xi_1 and xi_2, THICKNESS along xi_3. Nodes and quadrature points are the same,
// so a derivative is a sum along a line of nodes.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable

/// d field/d xi_k at [k].
/// @param nodes  of the element
static void differentiate(int point, global const int* nodes, global const double4* field, double4 slope[3]) {
  const int i = point % PLANE, j = point / PLANE % PLANE, k = point / (PLANE * PLANE);
  slope[0] = slope[1] = slope[2] = 0.0;
  for (int l = 0; l < PLANE; ++l) {
    slope[0] += along_plane[i * PLANE + l] * field[nodes[l + PLANE * (j + PLANE * k)]];
  }
  for (int l = 0; l < PLANE; ++l) {
    slope[1] += along_plane[j * PLANE + l] * field[nodes[i + PLANE * (l + PLANE * k)]];
  }
  for (int l = 0; l < THICKNESS; ++l) {
    slope[2] += along_thickness[k * THICKNESS + l] * field[nodes[i + PLANE * (j + PLANE * l)]];
  }
}

/// Component c of the force of an element on one of its nodes.
/// @param flux    of the element's points, [direction of xi][component], `points` apart
static double force_on(int node, int c, int points, global const double* flux) {
  const int i = node % PLANE, j = node / PLANE % PLANE, k = node / (PLANE * PLANE);
  double sum = 0.0;
  global const double* along = flux + (ulong)c * points;
  for (int l = 0; l < PLANE; ++l) {
    sum += along_plane[l * PLANE + i] * along[l + PLANE * (j + PLANE * k)];
  }
  along += 3 * (ulong)points;
  for (int l = 0; l < PLANE; ++l) {
    sum += along_plane[l * PLANE + j] * along[i + PLANE * (l + PLANE * k)];
  }
  along += 3 * (ulong)points;
  for (int l = 0; l < THICKNESS; ++l) {
    sum += along_thickness[l * THICKNESS + k] * along[i + PLANE * (j + PLANE * l)];
  }
  return sum;
}
