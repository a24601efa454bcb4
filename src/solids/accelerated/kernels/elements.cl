// From the motion of the nodes to the stress at the quadrature points of all elements. One call computes one point.
// The layout of `materials` is that of material_table(): MATERIAL numbers for each region.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable

/// d field_i/dX_j at [i][j].
/// @param slope    d field/d xi_k at [k]
/// @param inverse  dxi_k/dX_j at [k][j]
static void transform(const double4 slope[3], global const double* inverse, double gradient[3][3]) {
  for (int j = 0; j < 3; ++j) {
    const double4 column = slope[0] * inverse[j] + slope[1] * inverse[3 + j] + slope[2] * inverse[6 + j];
    gradient[0][j] = column.x;
    gradient[1][j] = column.y;
    gradient[2][j] = column.z;
  }
}

/// Symmetric part of A + B^T (C - D/2): 00, 11, 22, 12, 02, 01.
static void symmetric_sum(const double a[3][3], const double b[3][3], const double c[3][3], const double d[3][3],
                          double sum[6]) {
  double right[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      right[i][j] = c[i][j] - 0.5 * d[i][j];
    }
  }
  for (int i = 0; i < 3; ++i) {
    sum[i] = a[i][i] + b[0][i] * right[0][i] + b[1][i] * right[1][i] + b[2][i] * right[2][i];
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    double twice = a[j][k] + a[k][j];
    for (int l = 0; l < 3; ++l) {
      twice += b[l][j] * right[l][k] + b[l][k] * right[l][j];
    }
    sum[3 + i] = 0.5 * twice;
  }
}

/// The strain whose stress acts, from displacement gradients H and velocity gradients V. Green's strain is E of H.
/// @param material  of the region
/// @param memory    overstrains of the point: MECHANISMS x 6, `points` apart
static void effective_strain(global const double* material, double step, const double h[3][3], const double v[3][3],
                             int points, global double* memory, double strain[6]) {
#if RATES
  global const double* law = material + LAW;
  if (law[0] == 0.0) {  // Kelvin and Voigt: E + beta E'
    double delayed[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        delayed[i][j] = h[i][j] + law[1] * v[i][j];
      }
    }
    symmetric_sum(delayed, h, delayed, h, strain);
    return;
  }
  double change[3][3], rise[6];  // in the step that led here
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      change[i][j] = step * v[i][j];
    }
  }
  symmetric_sum(change, change, h, change, rise);
  symmetric_sum(h, h, h, h, strain);
  for (int c = 0; c < 6; ++c) {
    strain[c] = law[0] * strain[c] + law[1] * rise[c];
  }
  for (int m = 0; m < MECHANISMS; ++m) {
    for (int c = 0; c < 6; ++c) {
      global double* overstrain = memory + (ulong)(6 * m + c) * points;
      *overstrain = law[2 + 2 * m] * *overstrain + law[3 + 2 * m] * rise[c];
      strain[c] += *overstrain;
    }
  }
#else
  symmetric_sum(h, h, h, h, strain);
#endif
}

/// Second Piola-Kirchhoff stress, times `weight`. Its order is that of strains.
static void stress_of(global const double* material, const double strain[6], double weight, double stress[6]) {
  for (int i = 0; i < 6; ++i) {
    stress[i] = weight * material[36 + i];  // where the body rests
    for (int j = 0; j < 6; ++j) {
      stress[i] += material[6 * i + j] * (j < 3 ? weight * strain[j] : 2.0 * weight * strain[j]);
    }
  }
}

/// w P (dxi/dX)^T at all quadrature points, where P is the first Piola-Kirchhoff stress, with the sign of a force on
/// the body.
/// @param all       nodes with ghosts: [2][all] displacements and velocities are the motion
/// @param geometry  dxi_k/dX_j at [k][j], 1/m, and the determinant of the Jacobian: 10 numbers each
/// @param step      s
/// @param flux      [direction of xi][component][points]
kernel void stress_points(int points, int all, global const int* nodes, global const struct ElementEntry* entries,
                          global const double* geometry, global const double* materials, double step,
                          global const double4* motion, global double* memory, global double* flux) {
  const int number = get_global_id(0);
  if (number >= points) {
    return;
  }
  const int element = number / POINTS, point = number % POINTS;
  global const int* here = nodes + (ulong)element * NODES;
  const int first = entries[element].geometry;
  global const double* inverse = geometry + 10 * (ulong)(first < 0 ? -1 - first : first + point);
  double4 slope[3];
  double h[3][3], v[3][3];
  differentiate(point, here, motion, slope);
  transform(slope, inverse, h);
#if RATES
  differentiate(point, here, motion + all, slope);
  transform(slope, inverse, v);
#endif
  global const double* material = materials + entries[element].region * MATERIAL;
  double strain[6], stress[6];
  effective_strain(material, step, h, v, points, memory + number, strain);
  stress_of(material, strain, -weights[point] * inverse[9], stress);
  for (int i = 0; i < 3; ++i) {
    double pull[3];  // row i of P = S + H S
    for (int j = 0; j < 3; ++j) {
      const int of_row[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
      pull[j] = stress[of_row[i][j]];
      for (int l = 0; l < 3; ++l) {
        pull[j] += h[i][l] * stress[of_row[l][j]];
      }
    }
    for (int d = 0; d < 3; ++d) {
      flux[(ulong)(3 * d + i) * points + number] =
          pull[0] * inverse[3 * d] + pull[1] * inverse[3 * d + 1] + pull[2] * inverse[3 * d + 2];
    }
  }
}
