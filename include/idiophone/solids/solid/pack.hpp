#pragma once
// Packs: as many elements as a register has lanes are computed at once, one in each lane. No lane sees another, so an
// element's numbers do not depend on the pack or the lane it is put in.

#include <algorithm>
#include <cstring>

namespace idiophone::solid {

#ifdef __AVX512F__
inline constexpr int lanes = 8;
#else
inline constexpr int lanes = 4;  // GCC 12 would go through memory for each operation on packs of eight
#endif

/// One number for each element of a pack.
using Pack = double __attribute__((vector_size(lanes * sizeof(double))));

/// A 3 x 3 matrix for each element of a pack, [row][column]. Not set at first.
struct PackMatrix {
  Pack at[3][3];
};

/// C = A B
[[nodiscard]] inline PackMatrix multiply(const PackMatrix& a, const PackMatrix& b) {
  PackMatrix c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c.at[i][j] = a.at[i][0] * b.at[0][j] + a.at[i][1] * b.at[1][j] + a.at[i][2] * b.at[2][j];
    }
  }
  return c;
}

/// C = A B^T
[[nodiscard]] inline PackMatrix multiply_transposed(const PackMatrix& a, const PackMatrix& b) {
  PackMatrix c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c.at[i][j] = a.at[i][0] * b.at[j][0] + a.at[i][1] * b.at[j][1] + a.at[i][2] * b.at[j][2];
    }
  }
  return c;
}

/// Six numbers that stand for a symmetric matrix: a_00, a_11, a_22, a_12, a_02, a_01. Not set at first.
struct PackSymmetric {
  Pack at[6];

  [[nodiscard]] const Pack& operator()(int i, int j) const { return at[i == j ? i : 6 - i - j]; }
};

/// Symmetric part of A + B^T C
[[nodiscard]] inline PackSymmetric symmetric_sum(const PackMatrix& a, const PackMatrix& b, const PackMatrix& c) {
  PackSymmetric sum;
  for (int i = 0; i < 3; ++i) {
    sum.at[i] = a.at[i][i] + b.at[0][i] * c.at[0][i] + b.at[1][i] * c.at[1][i] + b.at[2][i] * c.at[2][i];
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    Pack twice = a.at[j][k] + a.at[k][j];
    for (int l = 0; l < 3; ++l) {
      twice += b.at[l][j] * c.at[l][k] + b.at[l][k] * c.at[l][j];
    }
    sum.at[3 + i] = 0.5 * twice;
  }
  return sum;
}

/// Transposes as many packs as they have lanes, in place.
inline void transpose(Pack (&rows)[lanes]) {
#ifdef __AVX512F__
  Pack pairs[lanes];
  for (int i = 0; i < lanes; i += 2) {
    pairs[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pairs[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  Pack quads[lanes];
  for (int i = 0; i < lanes; i += 4) {
    for (int j = 0; j < 2; ++j) {
      quads[i + j] = __builtin_shufflevector(pairs[i + j], pairs[i + j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      quads[i + j + 2] = __builtin_shufflevector(pairs[i + j], pairs[i + j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int j = 0; j < 4; ++j) {
    rows[j] = __builtin_shufflevector(quads[j], quads[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    rows[j + 4] = __builtin_shufflevector(quads[j], quads[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
#else
  Pack pairs[lanes];
  for (int i = 0; i < lanes; i += 2) {
    pairs[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 4, 2, 6);
    pairs[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 5, 3, 7);
  }
  for (int j = 0; j < 2; ++j) {
    rows[j] = __builtin_shufflevector(pairs[j], pairs[j + 2], 0, 1, 4, 5);
    rows[j + 2] = __builtin_shufflevector(pairs[j], pairs[j + 2], 2, 3, 6, 7);
  }
#endif
}

/// Numbers in a cache line.
inline constexpr int line_length = 8;

/// Eight quantities of the elements of a pack, from a cache line of each.
/// @param line_of  line_of(lane) points to the line
template <class LineOf>
inline void read_lines(const LineOf& line_of, Pack (&quantities)[line_length]) {
  for (int first = 0; first < line_length; first += lanes) {
    Pack part[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      std::memcpy(&part[lane], line_of(lane) + first, sizeof(Pack));
    }
    transpose(part);
    std::copy(part, part + lanes, quantities + first);
  }
}

/// The other way.
template <class LineOf>
inline void write_lines(const Pack (&quantities)[line_length], const LineOf& line_of) {
  for (int first = 0; first < line_length; first += lanes) {
    Pack part[lanes];
    std::copy(quantities + first, quantities + first + lanes, part);
    transpose(part);
    for (int lane = 0; lane < lanes; ++lane) {
      std::memcpy(line_of(lane) + first, &part[lane], sizeof(Pack));
    }
  }
}

}  // namespace idiophone::solid
