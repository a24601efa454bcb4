#include "idiophone/study/bench/cut_side.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/bounding_box.hpp"

namespace idiophone::bench {

namespace {

constexpr double least_facing = 0.5;  // cosine of 60 degrees

/// A corner of a triangle: its place, and slopes of all modes there.
struct Corner {
  Vector3 place;
  Eigen::VectorXd slopes;  ///< [modes] cents/m3
};

using Corners = std::array<Corner, 3>;

Corner between(const Corner& a, const Corner& b) {
  return {(a.place + b.place) / 2, (a.slopes + b.slopes) / 2};
}

/// Adds a triangle to the strip of its middle, cut into triangles that are not longer than a strip.
void add_triangle(const Corners& corners, const Side& side, double low, Strips& strips) {
  const auto [shortest, longest] =
      std::minmax({corners[0].place[side.along], corners[1].place[side.along], corners[2].place[side.along]});
  if (longest - shortest > strips.width) {
    const Corner ab = between(corners[0], corners[1]);
    const Corner bc = between(corners[1], corners[2]);
    const Corner ca = between(corners[2], corners[0]);
    for (const Corners& part :
         {Corners{corners[0], ab, ca}, Corners{ab, corners[1], bc}, Corners{ca, bc, corners[2]}, Corners{ab, bc, ca}}) {
      add_triangle(part, side, low, strips);
    }
    return;
  }
  const Vector3 area =
      (corners[1].place - corners[0].place).cross(corners[2].place - corners[0].place) / 2;  // m2, outwards
  const double middle = (corners[0].place + corners[1].place + corners[2].place)[side.along] / 3;
  const auto strip =
      std::clamp<Eigen::Index>(static_cast<Eigen::Index>((middle - low) / strips.width), 0, strips.slopes.cols() - 1);
  strips.slopes.col(strip) +=
      side.sign * area[side.facing] / 3 * (corners[0].slopes + corners[1].slopes + corners[2].slopes);
}

[[noreturn]] void throw_uncuttable(const Side& side) {
  throw std::runtime_error(fmt::format("--side: nothing of the body can be cut at its side {}", name_of(side)));
}

}  // namespace

Side read_side(const std::string& name, const mesh::Mesh& mesh) {
  const Vector3 sizes = bounding_box(mesh.nodes).sizes();
  Side side;
  if (name.empty()) {
    sizes.minCoeff(&side.facing);
  } else if (name.size() == 2 && (name[0] == '+' || name[0] == '-') && name[1] >= 'x' && name[1] <= 'z') {
    side.facing = name[1] - 'x';
    side.sign = name[0] == '+' ? 1.0 : -1.0;
  } else {
    throw std::runtime_error(fmt::format("--side: '{}' is not a side: write -z, +z, -x, ...", name));
  }
  const int first = (side.facing + 1) % 3;
  const int second = (side.facing + 2) % 3;
  side.along = sizes[first] >= sizes[second] ? first : second;
  return side;
}

std::string name_of(const Side& side) {
  return fmt::format("{}{}", side.sign > 0 ? '+' : '-', "xyz"[side.facing]);
}

char axis_name(const Side& side) {
  return "xyz"[side.along];
}

std::array<double, 2> ends_along(const mesh::Mesh& mesh, const Side& side) {
  const Eigen::AlignedBox3d box = bounding_box(mesh.nodes);
  return {box.min()[side.along], box.max()[side.along]};
}

std::vector<mesh::Triangle> side_faces(const mesh::Mesh& mesh, const Side& side) {
  std::vector<mesh::Triangle> faces;
  std::ranges::copy_if(mesh.outer_surface(), std::back_inserter(faces), [&](const mesh::Triangle& triangle) {
    const Vector3 a = mesh.nodes[triangle[0]];
    const Vector3 normal = (mesh.nodes[triangle[1]] - a).cross(mesh.nodes[triangle[2]] - a).normalized();
    return side.sign * normal[side.facing] >= least_facing;
  });
  if (faces.empty()) {
    throw_uncuttable(side);
  }
  return faces;
}

Strips strips_of(const mesh::Mesh& mesh, const eigenmodes::RemovalSlopes& removal, const Side& side) {
  const Eigen::AlignedBox3d box = bounding_box(mesh.nodes);
  const double low = box.min()[side.along];
  Strips strips;
  strips.width = box.sizes()[side.along] / Strips::count;
  strips.thickness = box.sizes()[side.facing];
  for (int strip = 0; strip < Strips::count; ++strip) {
    strips.places.push_back(low + (strip + 0.5) * strips.width);
  }
  const auto modes = static_cast<Eigen::Index>(removal.slopes.size());
  strips.slopes = Eigen::MatrixXd::Zero(modes, Strips::count);
  std::vector<Index> place_of(mesh.nodes.size(), -1);  // of a node in the lists of `removal`
  for (std::size_t i = 0; i < removal.nodes.size(); ++i) {
    place_of[removal.nodes[i]] = static_cast<Index>(i);
  }
  bool has_faces = false;
  for (const mesh::Triangle& triangle : side_faces(mesh, side)) {
    if (std::ranges::any_of(triangle, [&](Index node) { return place_of[node] < 0; })) {
      continue;
    }
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners.at(k) = {mesh.nodes[triangle.at(k)], Eigen::VectorXd(modes)};
      for (Eigen::Index m = 0; m < modes; ++m) {
        corners.at(k).slopes[m] = removal.slopes[m][place_of[triangle.at(k)]];
      }
    }
    add_triangle(corners, side, low, strips);
    has_faces = true;
  }
  if (!has_faces) {
    throw_uncuttable(side);
  }
  return strips;
}

}  // namespace idiophone::bench
