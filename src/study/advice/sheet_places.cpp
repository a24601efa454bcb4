#include "idiophone/study/advice/sheet_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::advice {

namespace {

constexpr double along_plane = 0.999;      // cosine of the angle between the normals
constexpr double same_plane = 1.0 / 64.0;  // cells
constexpr double smallest_face = 0.05;     // of the surface of the body
constexpr double thickest = 0.625;         // cells: what is thicker has one side in a cell
constexpr double eighth = 1.0 / 8.0;       // cells: the room that the thinnest sheet takes

/// The faces of a body that look one way along an axis.
struct Side {
  Index body;
  int axis;
  bool up;  ///< they look up the axis

  auto operator<=>(const Side&) const = default;
};

/// A part of them, with about the same coordinate along the axis.
struct Faces {
  Side side;
  std::int64_t plane;  ///< the coordinate in widths of same_plane
  double area;         ///< m2
  double moment;       ///< area times coordinate, m3
};

/// Faces in one plane as one.
std::vector<Faces> merged(const std::vector<Faces>& all) {
  std::map<std::pair<Side, std::int64_t>, Faces> planes;
  for (const Faces& part : all) {
    Faces& sum = planes.try_emplace({part.side, part.plane}, Faces{part.side, part.plane, 0.0, 0.0}).first->second;
    sum.area += part.area;
    sum.moment += part.moment;
  }
  std::vector<Faces> result;
  std::ranges::transform(planes, std::back_inserter(result), [](const auto& plane) { return plane.second; });
  return result;
}

/// All ranks' faces along the planes of the grid, and the area of each body.
struct FlatFaces {
  std::vector<Faces> faces;
  std::vector<double> areas;  ///< [bodies] m2
};

FlatFaces flat_faces(const propagation::AudibleSurface& surface, double cell, MPI_Comm communicator) {
  FlatFaces found{{}, std::vector<double>(surface.bodies.size())};
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vector3 &first = surface.reference[a], &second = surface.reference[b], &third = surface.reference[c];
    const Vector3 twice = (second - first).cross(third - first);
    const auto next = std::ranges::upper_bound(surface.first_triangle, surface.triangle_ids[t]);
    const auto body = static_cast<Index>(next - surface.first_triangle.begin() - 1);
    found.areas[body] += twice.norm() / 2;
    int axis = 0;
    if (twice.cwiseAbs().maxCoeff(&axis) > along_plane * twice.norm()) {
      const double coordinate = (first + second + third)[axis] / 3, area = twice.norm() / 2;
      found.faces.push_back(
          {{body, axis, twice[axis] > 0}, std::llround(coordinate / (same_plane * cell)), area, area * coordinate});
    }
  }
  found.faces = merged(parallel::gather_all(std::span<const Faces>(merged(found.faces)), communicator).values);
  parallel::reduce(found.areas, MPI_SUM, communicator);
  return found;
}

}  // namespace

std::vector<Sheet> sheets_along_planes(const propagation::AudibleSurface& surface, double cell, MPI_Comm communicator) {
  auto [faces, areas] = flat_faces(surface, cell, communicator);
  std::erase_if(faces, [&](const Faces& plane) { return plane.area < smallest_face * areas[plane.side.body]; });
  std::vector<Sheet> sheets;
  for (const Faces& upper : faces) {
    for (const Faces& lower : faces) {
      const double top = upper.moment / upper.area, bottom = lower.moment / lower.area;
      const bool is_pair = upper.side.up && lower.side == Side{upper.side.body, upper.side.axis, false};
      if (is_pair && top > bottom && top - bottom < thickest * cell) {
        sheets.push_back(
            {static_cast<std::size_t>(upper.side.body), upper.side.axis, (top + bottom) / 2, top - bottom});
      }
    }
  }
  return sheets;
}

double clearance(const Sheet& sheet, const waves::Grid& grid) {
  const double place = (sheet.middle - grid.corner[sheet.axis]) / grid.cell;
  const double to_plane = std::abs(place - std::round(place));
  return to_plane - std::max(0.0, (sheet.thickness / grid.cell - eighth) / 2);
}

}  // namespace idiophone::advice
