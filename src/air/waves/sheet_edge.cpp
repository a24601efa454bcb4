#include "sheet_edge.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

namespace idiophone::waves {

namespace {

constexpr int columns = voxels * voxels;  // of a cell along an axis
constexpr int thickest_sheet = 5;         // sub-voxels; what is thicker is no sheet but a solid with edges of its own
constexpr int fewest_columns = 8;         // that a sheet must cover

/// Columns along an axis in which air of a part lies on both sides of a solid.
std::uint64_t folded_columns(const Mask& air, const Mask& solid) {
  std::uint64_t before = 0, crossed = 0, folded = 0;
  for (int k = 0; k < voxels; ++k) {
    folded |= crossed & air[k];
    crossed |= before & solid[k];
    before |= air[k];
  }
  return folded;
}

/// The sheet as a plane across the columns of an axis.
struct Plane {
  double height = 0.0, along_u = 0.0, along_v = 0.0;  // in the middle of the cell; slopes

  [[nodiscard]] double at(int column) const {
    constexpr double centre = (voxels - 1) / 2.0;
    const int u = column % voxels, v = column / voxels;
    return height + along_u * (u - centre) + along_v * (v - centre);
  }
};

/// Height of the solid in each of some columns, in layers, and how thick it is.
struct Profile {
  std::vector<Eigen::Vector3d> points;  // u, v, height
  int thickest = 0;                     // layers
  double thickness = 0.0;               // mean, over a cell
};

Profile profile_of(const Mask& solid, std::uint64_t among) {
  Profile profile;
  for (int column = 0; column < columns; ++column) {
    if ((among >> column & 1U) == 0) {
      continue;
    }
    int thickness = 0, sum = 0;
    for (int k = 0; k < voxels; ++k) {
      const int here = static_cast<int>(solid[k] >> column & 1U);
      thickness += here;
      sum += here * k;
    }
    profile.points.emplace_back(column % voxels, column / voxels, static_cast<double>(sum) / thickness);
    profile.thickest = std::max(profile.thickest, thickness);
    profile.thickness += static_cast<double>(thickness) / voxels;
  }
  profile.thickness /= std::max(1, std::popcount(among));
  return profile;
}

/// Least squares. Where the columns do not show a slope, it is 0.
Plane fit(const Profile& profile) {
  const auto count = static_cast<double>(profile.points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : profile.points) {
    mean += point / count;
  }
  Eigen::Matrix2d moments = 0.1 * count * Eigen::Matrix2d::Identity();
  Eigen::Vector2d rises = Eigen::Vector2d::Zero();
  for (const auto& point : profile.points) {
    const Eigen::Vector3d away = point - mean;
    moments += away.head<2>() * away.head<2>().transpose();
    rises += away[2] * away.head<2>();
  }
  const Eigen::Vector2d slope = moments.inverse() * rises;
  const Eigen::Vector2d to_middle = Eigen::Vector2d::Constant((voxels - 1) / 2.0) - mean.head<2>();
  return {mean[2] + slope.dot(to_middle), slope[0], slope[1]};
}

/// A cell divided by the plane of a sheet.
struct Cut {
  Mask above{};          // the layers above the plane
  double section = 0.0;  // columns that the plane passes through, over all
  double covered = 0.0;  // part of them with a solid in it
  double offset = 0.0;   // of the plane from the middle of the cell, over half a cell
};

Cut cut_by(const Plane& plane, const Mask& solid) {
  Cut cut;
  std::uint64_t closed = 0;
  for (const std::uint64_t layer : solid) {
    closed |= layer;
  }
  std::uint64_t section = 0;
  double height = 0.0;
  for (int column = 0; column < columns; ++column) {
    const double here = plane.at(column);
    const std::uint64_t bit = std::uint64_t{1} << column;
    if (here > -0.5 && here < voxels - 0.5) {
      section |= bit;
      height += here + 0.5;
    }
    for (int k = 0; k < voxels; ++k) {
      cut.above[k] |= k > here ? bit : 0;
    }
  }
  const double size = std::max(1, std::popcount(section));
  cut.section = size / columns;
  cut.covered = std::popcount(closed & section) / size;
  cut.offset = std::min(1.0, std::abs(2.0 * height / (size * voxels) - 1.0));
  return cut;
}

/// Open area between the two sides of a sheet that covers a part of a cell. On a square lattice, a slit acts as if it
/// ended `beyond` cells behind the last node with two sides, and the flow around its end meets the resistance
/// `resistance` between these sides; both are exact (Wiener and Hopf's method). An opening g shortens the slit by
/// g resistance/(1 + g resistance) cells.
/// A thick sheet has an edge with two corners, which act as if they were farther out. The lattice with its narrow cells
/// knows of this but for about a sixth of the thickness (fitted to discs).
/// @param covered    part of the cell's section
/// @param offset     of the sheet from the middle of the cell, over half a cell: 0, lattice points on the slit; 1, slit
///                   between lattice points
/// @param thickness  over a cell
/// @return none if the lattice ends the slit in the cell before
std::optional<double> opening_at(double covered, double offset, double thickness) {
  constexpr double most_shortened = 0.8;  // beyond that one node serves as well, without a narrow cell's volume
  const double root = std::numbers::sqrt2;
  const double beyond = std::lerp(1.0 - root / 4.0, 0.5 + root / 4.0, offset);
  const double resistance = std::lerp(4.0 * (root - 1.0), 1.0 + root, offset);
  const double shortened = std::max(0.0, beyond + 0.5 - covered - thickness / 6.0);
  if (shortened >= most_shortened) {
    return {};
  }
  return shortened / ((1.0 - shortened) * resistance);
}

}  // namespace

std::optional<DividedPart> divide_at_edge(const Mask& part, const Mask& solid) {
  std::size_t axis = 0;
  std::uint64_t folded = 0;
  for (std::size_t one = 0; one < 3; ++one) {
    const std::uint64_t found = folded_columns(layers_along(part, one), layers_along(solid, one));
    if (std::popcount(found) > std::popcount(folded)) {
      axis = one;
      folded = found;
    }
  }
  if (std::popcount(folded) < fewest_columns) {
    return {};
  }
  const Mask layers = layers_along(solid, axis);
  const Profile profile = profile_of(layers, folded);
  if (profile.thickest > thickest_sheet) {
    return {};
  }
  const Cut cut = cut_by(fit(profile), layers);
  const auto opening = opening_at(cut.covered, cut.offset, profile.thickness);
  if (!opening) {
    return {};
  }
  const Mask above = mask_of_layers(cut.above, axis);
  DividedPart divided{.opening = static_cast<float>(*opening * cut.section)};
  for (int z = 0; z < voxels; ++z) {
    divided.above[z] = part[z] & above[z];
    divided.below[z] = part[z] & ~above[z];
  }
  return count(divided.above) > 0 && count(divided.below) > 0 ? std::optional(divided) : std::nullopt;
}

}  // namespace idiophone::waves
