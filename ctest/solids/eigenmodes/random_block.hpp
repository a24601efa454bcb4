#pragma once
// Random bodies, their meshes and their elements.

#include <cmath>
#include <random>
#include <vector>

#include "mapped_block.hpp"

namespace idiophone::eigenmodes {

/// A body and the mesh whose errors are estimated.
struct RandomBlock {
  MappedBlock shape;
  element::Type type;
  std::array<int, 3> cells = {};
  MassMatrix mass = MassMatrix::lumped;
};

/// Draws bodies: the same ones everywhere.
class RandomBlocks {
 public:
  explicit RandomBlocks(unsigned seed) : generator_(seed) {}

  [[nodiscard]] RandomBlock draw() {
    RandomBlock block;
    const std::vector<element::Type> types = {element::tet4,      element::tet10,     element::hex(2, 2),
                                              element::hex(3, 2), element::hex(4, 2), element::hex(4, 4),
                                              element::hex(5, 3)};
    block.type = types[whole(0, static_cast<int>(types.size()) - 1)];
    block.mass = is(0.25) ? MassMatrix::consistent : MassMatrix::lumped;
    switch (whole(0, 2)) {
      case 0:
        draw_bar(block);
        break;
      case 1:
        draw_plate(block);
        break;
      default:
        draw_lump(block);
    }
    block.shape.is_clamped = is(0.5);
    block.shape.place = draw_place(block.shape.size);
    return block;
  }

 private:
  double between(double low, double high) { return low + (high - low) * std::ldexp(double(generator_()), -32); }
  int whole(int low, int high) { return std::min(high, static_cast<int>(between(low, high + 1))); }
  bool is(double probability) { return between(0, 1) < probability; }

  /// Of linear, quadratic elements and those of higher order.
  std::array<int, 3> cells(element::Type type, const std::array<int, 3>& linear, const std::array<int, 3>& quadratic,
                           const std::array<int, 3>& higher) {
    const int order = element::orders(type).plane;
    std::array<int, 3> chosen = order == 1 ? linear : order == 2 ? quadratic : higher;
    chosen[0] = std::max(1, static_cast<int>(std::lround(chosen[0] * between(0.8, 1.4))));
    return chosen;
  }

  void draw_bar(RandomBlock& block) {
    block.shape = {.name = "bar",
                   .size = {0.3, between(0.02, 0.04), between(0.006, 0.02)},
                   .exact_cells = {5, 1, 1},
                   .exact_type = element::hex(6, 4)};
    block.cells = cells(block.type, {24, 3, 2}, {12, 2, 1}, {3, 1, 1});
  }

  void draw_plate(RandomBlock& block) {
    block.shape = {.name = "plate",
                   .size = {0.2, between(0.1, 0.18), between(0.002, 0.012)},
                   .exact_cells = {3, 2, 1},
                   .exact_type = element::hex(7, 3)};
    block.cells = cells(block.type, {12, 8, 1}, {8, 6, 1}, {2, 2, 1});
  }

  void draw_lump(RandomBlock& block) {
    block.shape = {.name = "lump",
                   .size = {0.1, between(0.06, 0.1), between(0.04, 0.08)},
                   .exact_cells = {2, 2, 2},
                   .exact_type = element::hex(5, 5)};
    block.cells = cells(block.type, {6, 5, 4}, {4, 3, 3}, {2, 1, 1});
  }

  /// Tapers, undercuts, twists and bends, each or not.
  std::function<Vector3(const Vector3&)> draw_place(const Vector3& size) {
    const double taper = is(0.5) ? between(0, 0.5) : 0.0;     // of the width, along the length
    const double undercut = is(0.5) ? between(0, 0.5) : 0.0;  // of the thickness, in the middle
    const double twist = is(0.5) ? between(-0.6, 0.6) : 0.0;  // rad
    const double bend = is(0.5) ? between(0.1, 1.2) : 0.0;    // rad
    return [=](const Vector3& point) -> Vector3 {
      const double along = point[0] / size[0];
      const double y = (point[1] - size[1] / 2) * (1 - taper * along);
      const double z = (point[2] - size[2] / 2) * (1 - undercut * 4 * along * (1 - along));
      const double angle = twist * along;
      const double across = std::cos(angle) * y - std::sin(angle) * z;
      const double up = std::sin(angle) * y + std::cos(angle) * z;
      if (bend == 0.0) {
        return {point[0], across, up};
      }
      const double radius = size[0] / bend;
      return {(radius + up) * std::sin(bend * along), across, (radius + up) * std::cos(bend * along) - radius};
    };
  }

  std::mt19937 generator_;
};

}  // namespace idiophone::eigenmodes
