#include "space_filling_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "idiophone/foundation/bounding_box.hpp"

namespace idiophone::mesh {

namespace {

constexpr int bits = 21;  // three times 21 bits fit a 64-bit key
using GridCell = std::array<std::uint32_t, 3>;

/// Place of a grid cell along the Hilbert curve, by J. Skilling, "Programming the Hilbert curve", AIP Conference
/// Proceedings 707 (2004).
std::uint64_t hilbert_key(GridCell cell) {
  constexpr std::uint32_t top = 1U << (bits - 1);
  // From the coarsest octants down, undo the reflections and exchanges of axes that each octant's curve went through.
  for (std::uint32_t bit = top; bit > 1; bit >>= 1U) {
    const std::uint32_t below = bit - 1;
    for (auto& axis : cell) {
      if ((axis & bit) != 0) {
        cell[0] ^= below;
      } else {
        const std::uint32_t differing = (cell[0] ^ axis) & below;
        cell[0] ^= differing;
        axis ^= differing;
      }
    }
  }
  // Gray code.
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t flips = 0;
  for (std::uint32_t bit = top; bit > 1; bit >>= 1U) {
    if ((cell[2] & bit) != 0) {
      flips ^= bit - 1;
    }
  }
  std::uint64_t key = 0;
  for (std::uint32_t bit = top; bit > 0; bit >>= 1U) {
    for (const auto axis : cell) {
      key = (key << 1U) | (((axis ^ flips) & bit) != 0 ? 1U : 0U);
    }
  }
  return key;
}

std::vector<std::uint64_t> keys_of(const std::vector<Vector3>& points) {
  const Eigen::AlignedBox3d box = bounding_box(points);
  const double side = box.sizes().maxCoeff();
  const double scale = side > 0.0 ? ((1U << bits) - 1) / side : 0.0;
  std::vector<std::uint64_t> keys(points.size());
  std::ranges::transform(points, keys.begin(), [&](const Vector3& point) {
    const auto cell = ((point - box.min()) * scale).cast<std::uint32_t>().eval();
    return hilbert_key({cell.x(), cell.y(), cell.z()});
  });
  return keys;
}

}  // namespace

std::vector<Index> curve_order(const std::vector<Vector3>& points) {
  std::vector<Index> order(points.size());
  if (points.empty()) {
    return order;
  }
  std::iota(order.begin(), order.end(), 0);
  const auto keys = keys_of(points);
  std::ranges::sort(order, {}, [&](Index number) {
    const auto place = static_cast<std::size_t>(number);
    const Vector3& point = points[place];
    return std::tuple(keys[place], point.x(), point.y(), point.z(), number);
  });
  return order;
}

}  // namespace idiophone::mesh
