#include "inner_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "sub_voxels.hpp"

namespace idiophone::waves {

namespace {

/// Where a line passes through a surface.
struct Crossing {
  Index line;
  float place;     // along the line, from the grid's corner, in sub-voxels
  int direction;   // 1: into the solid, -1: out of it
  Index triangle;  // of the surface
};

/// Twice the area of (a, b, point) seen along x. Exactly the opposite for (b, a, point), so that a line on an edge
/// passes through one of its two triangles.
double side(const Vector3& a, const Vector3& b, double y, double z) {
  const bool ordered = std::tie(a[1], a[2], a[0]) < std::tie(b[1], b[2], b[0]);
  const Vector3& first = ordered ? a : b;
  const Vector3& second = ordered ? b : a;
  const double value = (second[1] - first[1]) * (z - first[2]) - (second[2] - first[2]) * (y - first[1]);
  const double signed_value = value == 0.0 ? std::numeric_limits<double>::min() : value;
  return ordered ? signed_value : -signed_value;
}

/// Lines along an axis, which is x here: places are turned, so that the next axis is y and the one after it z.
class Lines {
 public:
  Lines(const Obstruction& obstruction, const Grid& grid, const CellBox& box, std::size_t axis)
      : obstruction_(obstruction), grid_(grid), box_(box), axis_(axis) {
    for (Index t = 0; t < static_cast<Index>(obstruction_.triangles.size()); ++t) {
      cross(t);
    }
    std::ranges::sort(crossings_, {}, [](const Crossing& c) { return std::tuple(c.line, c.place, -c.direction); });
  }

  [[nodiscard]] std::vector<InnerPiece> pieces() const {
    std::vector<InnerPiece> pieces;
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
      const Crossing& here = crossings_[i];
      const Crossing& next = crossings_[i + 1];
      if (i == 0 || here.line != crossings_[i - 1].line) {
        winding = 0;
      }
      winding += here.direction;
      if (winding > 0 && next.line == here.line) {
        const double cosine = normal(here.triangle).dot(normal(next.triangle));
        pieces.push_back({here.line, here.place, next.place, cosine < -0.5});
      }
    }
    return pieces;
  }

 private:
  /// In sub-voxels, turned.
  [[nodiscard]] std::array<Vector3, 3> corners(Index triangle) const {
    std::array<Vector3, 3> turned;
    for (int k = 0; k < 3; ++k) {
      const Vector3 corner = voxels * grid_.in_cells(obstruction_.corner(triangle, k));
      turned.at(k) = {corner[axis(0)], corner[axis(1)], corner[axis(2)]};
    }
    return turned;
  }
  [[nodiscard]] Index axis(std::size_t turned) const { return static_cast<Index>((axis_ + turned) % 3); }

  [[nodiscard]] Vector3 normal(Index triangle) const {
    const auto [a, b, c] = corners(triangle);
    return (b - a).cross(c - a).normalized();
  }

  /// The lines from one coordinate along an axis to another, within the box.
  [[nodiscard]] std::pair<int, int> lines(std::size_t turned, double low, double high) const {
    return centres(std::max<double>(voxels * box_.from.at(axis(turned)), low),
                   std::min<double>(voxels * box_.to.at(axis(turned)), high));
  }

  void cross(Index triangle) {
    const auto [a, b, c] = corners(triangle);
    const auto [y_low, y_high] = std::minmax({a[1], b[1], c[1]});
    const auto [z_low, z_high] = std::minmax({a[2], b[2], c[2]});
    const auto [y_from, y_to] = lines(1, y_low, y_high);
    const auto [z_from, z_to] = lines(2, z_low, z_high);
    for (int z = z_from; z < z_to; ++z) {
      for (int y = y_from; y < y_to; ++y) {
        const double at_a = side(b, c, y + 0.5, z + 0.5);
        const double at_b = side(c, a, y + 0.5, z + 0.5);
        const double at_c = side(a, b, y + 0.5, z + 0.5);
        const bool forwards = at_a > 0 && at_b > 0 && at_c > 0;
        if (forwards || (at_a < 0 && at_b < 0 && at_c < 0)) {
          const double x = (at_a * a[0] + at_b * b[0] + at_c * c[0]) / (at_a + at_b + at_c);
          crossings_.push_back({number(y, z), static_cast<float>(x), forwards ? -1 : 1, triangle});
        }
      }
    }
  }

  [[nodiscard]] Index number(int y, int z) const {
    const auto from = [this](std::size_t turned) { return voxels * box_.from.at(axis(turned)); };
    return (z - from(2)) * voxels * box_.width(axis(1)) + y - from(1);
  }

  const Obstruction& obstruction_;
  const Grid& grid_;
  CellBox box_;
  std::size_t axis_;
  std::vector<Crossing> crossings_;
};

}  // namespace

std::pair<int, int> centres(double from, double to) {
  return {static_cast<int>(std::ceil(from - 0.5)), static_cast<int>(std::ceil(to - 0.5))};
}

std::vector<InnerPiece> inner_pieces(const Obstruction& obstruction, const Grid& grid, const CellBox& box,
                                     std::size_t axis) {
  return Lines(obstruction, grid, box, axis).pieces();
}

}  // namespace idiophone::waves
