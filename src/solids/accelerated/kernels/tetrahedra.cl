// Tetrahedra: derivatives of the shape functions from a table, [points][nodes][3].

#pragma OPENCL EXTENSION cl_khr_fp64 : enable

/// d field/d xi_k at [k].
/// @param nodes  of the element
static void differentiate(int point, global const int* nodes, global const double4* field, double4 slope[3]) {
  slope[0] = slope[1] = slope[2] = 0.0;
  for (int a = 0; a < NODES; ++a) {
    constant const double* gradient = gradients + 3 * (point * NODES + a);
    const double4 vector = field[nodes[a]];
    for (int k = 0; k < 3; ++k) {
      slope[k] += gradient[k] * vector;
    }
  }
}

/// Component c of the force of an element on one of its nodes.
/// @param flux    of the element's points, [direction of xi][component], `points` apart
static double force_on(int node, int c, int points, global const double* flux) {
  double sum = 0.0;
  for (int point = 0; point < POINTS; ++point) {
    constant const double* gradient = gradients + 3 * (point * NODES + node);
    for (int k = 0; k < 3; ++k) {
      sum += gradient[k] * flux[(ulong)(3 * k + c) * points + point];
    }
  }
  return sum;
}
