#include "overlap.hpp"

#include <algorithm>

namespace idiophone::contact {

namespace {

constexpr int first_face_of_second = 4;  // numbers of the overlap's faces: the first cell's four, then the second's

/// Whether a plane has all corners on its outer side, and none nearer than `distance`.
bool separates(const Plane& plane, const Tetrahedron& tetrahedron, double distance) {
  return std::ranges::all_of(tetrahedron.corners, [&](const Vector3& x) { return plane.distance(x) >= distance; });
}

}  // namespace

bool separated(const Cell& first, const Cell& second, double distance) {
  const auto separates_first = [&](const Plane& plane) { return separates(plane, *first.tetrahedron, distance); };
  const auto separates_second = [&](const Plane& plane) { return separates(plane, *second.tetrahedron, distance); };
  return std::ranges::any_of(second.planes, separates_first) ||
         (second.tetrahedron != nullptr && std::ranges::any_of(first.planes, separates_second));
}

void Overlaps::clear() {
  cells_.clear();
  faces_.clear();
}

void Overlaps::append(std::span<const CellShare> cells, std::span<const FaceShare> faces) {
  cells_.insert(cells_.end(), cells.begin(), cells.end());
  faces_.insert(faces_.end(), faces.begin(), faces.end());
}

double Overlaps::volume() const {
  double volume = 0.0;
  for (const CellShare& share : cells_) {
    volume += share.side == 0 ? share.overlap : 0.0;  // both sides' cells have the same overlaps
  }
  return volume;
}

void Overlaps::add(const Cell& first, const Cell& second) {
  if (separated(first, second, 0.0)) {
    return;
  }
  common_.become(*first.tetrahedron);
  for (std::size_t p = 0; p < second.planes.size() && !common_.empty(); ++p) {
    common_.clip(second.planes[p], first_face_of_second + static_cast<int>(p));
  }
  const Polyhedron::Moments moments = common_.moments();
  if (!(moments.volume > 0)) {
    return;
  }
  add_cell(0, first, moments);
  if (second.tetrahedron != nullptr) {
    add_cell(1, second, moments);
  }
  for (std::size_t f = 0; f < common_.face_count(); ++f) {
    const auto [number, corners] = common_.face(f);
    const auto place = number % first_face_of_second;
    if (number >= first_face_of_second) {
      const auto plane = number - first_face_of_second;
      if (second.exterior[plane] != 0) {
        add_face(0, first, second, second.planes[plane].normal, corners);
      }
    } else if (second.tetrahedron != nullptr && first.exterior[place] != 0) {
      add_face(1, second, first, first.planes[place].normal, corners);
    }
  }
}

void Overlaps::add_cell(int side, const Cell& cell, const Polyhedron::Moments& moments) {
  const Vector3 centre = moments.first / moments.volume;
  cells_.push_back({side, cell.number, moments.volume, moments.volume * cell.tetrahedron->coordinates(centre),
                    cell.tetrahedron->gradients});
}

void Overlaps::add_face(int side, const Cell& own, const Cell& other, const Vector3& normal,
                        std::span<const Vector3> corners) {
  FaceShare share{side, own.number, other.number, normal, Eigen::Matrix4d::Zero(), Eigen::Matrix4d::Zero()};
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::array<Vector3, 3> triangle = {corners[0], corners[i - 1], corners[i]};
    const double area = normal.dot((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0])) / 2;
    // The middles of the edges integrate products of two linear functions exactly.
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const Vector3 middle = (triangle[edge] + triangle[(edge + 1) % 3]) / 2;
      const Eigen::Vector4d psi = own.tetrahedron->coordinates(middle);
      share.own += area / 3 * psi * psi.transpose();
      if (other.tetrahedron != nullptr) {
        share.other += area / 3 * psi * other.tetrahedron->coordinates(middle).transpose();
      }
    }
  }
  faces_.push_back(share);
}

}  // namespace idiophone::contact
