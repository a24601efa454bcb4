#include "object_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/solids/mesh/line_crossing.hpp"

namespace idiophone::timbre {

namespace {

constexpr double touching = 1e-9;  // m, or part of a way: what only touches a solid is outside

/// Part of a way at which it goes through a triangle; none if it does not.
std::optional<double> part_at_triangle(const Vector3& begin, const Vector3& way,
                                       const ObjectShape::Triangle& triangle) {
  constexpr double margin = 1e-9;  // so that nothing slips between two triangles
  return mesh::line_crossing(triangle, begin, way, margin);
}

/// Signed solid angle of a triangle; 0 in its plane (van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 1983).
double solid_angle(const Vector3& place, const ObjectShape::Triangle& triangle) {
  const Vector3 a = triangle[0] - place, b = triangle[1] - place, c = triangle[2] - place;
  const double lengths = a.norm() * b.norm() * c.norm(), volume = a.dot(b.cross(c));
  if (std::abs(volume) <= touching * lengths) {
    return 0.0;
  }
  return 2.0 * std::atan2(volume, lengths + a.dot(b) * c.norm() + a.dot(c) * b.norm() + b.dot(c) * a.norm());
}

}  // namespace

ObjectShape::ObjectShape(const std::vector<Triangle>& triangles) {
  for (const Triangle& triangle : triangles) {
    for (const Vector3& corner : triangle) {
      middle_ += corner / (3.0 * static_cast<double>(triangles.size()));
    }
  }
  for (const Triangle& triangle : triangles) {
    for (const Vector3& corner : triangle) {
      radius_ = std::max(radius_, (corner - middle_).norm());
    }
  }
  for (const Triangle& triangle : triangles) {
    add(triangle);
  }
}

ObjectShape ObjectShape::box(const Vector3& size) {
  std::vector<Triangle> triangles;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const auto corner = [&](double b, double c) -> Vector3 {
        Vector3 unit = Vector3::Zero();
        unit[axis] = sign;
        unit[(axis + 1) % 3] = sign * b;
        unit[(axis + 2) % 3] = c;
        return 0.5 * size.cwiseProduct(unit);
      };
      triangles.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
      triangles.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
    }
  }
  return ObjectShape(triangles);
}

void ObjectShape::add(const Triangle& triangle) {
  constexpr double alike = 1e-6;  // normals, and heights over the radius
  const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
  const double height = normal.dot(triangle[0]);
  const auto face = std::ranges::find_if(faces_, [&](const Face& known) {
    return (known.normal - normal).norm() < alike && std::abs(known.height - height) < alike * radius_;
  });
  if (face != faces_.end()) {
    face->triangles.push_back(triangle);
  } else {
    faces_.push_back({.normal = normal, .height = height, .triangles = {triangle}});
  }
}

void ObjectShape::place(const Vector3& origin, const Eigen::Matrix3d& axes) {
  origin_ = origin;
  axes_ = axes;
}

bool ObjectShape::contains(const Vector3& place) const {
  return holds(own(place));
}

bool ObjectShape::holds(const Vector3& own_place) const {
  constexpr double inside = 3.9 * std::numbers::pi;  // less on the surface; all directions are 4 pi
  if ((own_place - middle_).norm() > radius_) {
    return false;
  }
  double sum = 0.0;
  for (const Face& face : faces_) {
    for (const Triangle& triangle : face.triangles) {
      sum += solid_angle(own_place, triangle);
    }
  }
  return sum > inside;
}

std::vector<ObjectShape::Hit> ObjectShape::hits(const Vector3& begin, const Vector3& end) const {
  const Vector3 way = end - begin;
  const double nearest = std::clamp((middle_ - begin).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
  if ((begin + nearest * way - middle_).norm() > radius_) {
    return {};
  }
  std::vector<Hit> found;
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    for (const Triangle& triangle : faces_[face].triangles) {
      const std::optional<double> part = part_at_triangle(begin, way, triangle);
      if (part && *part > touching && *part < 1.0 - touching) {
        found.push_back({*part, face});
      }
    }
  }
  std::ranges::stable_sort(found, {}, &Hit::part);
  return found;
}

std::optional<ObjectShape::Meeting> ObjectShape::crossing(const Vector3& from, const Vector3& to) const {
  const Vector3 begin = own(from), way = own(to) - begin;
  const std::vector<Hit> all = hits(begin, begin + way);
  for (std::size_t i = 0; i <= all.size() && !all.empty(); ++i) {
    const double enters = i == 0 ? 0.0 : all[i - 1].part, leaves = i == all.size() ? 1.0 : all[i].part;
    if (leaves - enters > touching && holds(begin + 0.5 * (enters + leaves) * way)) {
      const Hit& hit = all[i == 0 ? 0 : i - 1];
      return Meeting{.face = hit.face,
                     .cosine = std::abs(faces_[hit.face].normal.dot(way)) / way.norm(),
                     .point = from + hit.part * (to - from)};
    }
  }
  return {};
}

std::optional<ObjectShape::Meeting> ObjectShape::reflection(const Vector3& from, const Vector3& to) const {
  const Vector3 begin = own(from), end = own(to);
  std::optional<Meeting> shortest;
  double length = 0.0;  // m
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    const double before = face.normal.dot(begin) - face.height, after = face.normal.dot(end) - face.height;
    const double detour = (mirrored(from, f) - to).norm();
    if (before < -touching || after < -touching || before + after <= touching || (shortest && detour >= length)) {
      continue;
    }
    Vector3 point = (begin * after + end * before) / (before + after);
    point += (face.height - face.normal.dot(point)) * face.normal;
    const auto is_met = [&](const Triangle& triangle) {
      return part_at_triangle(point + face.normal, -2.0 * face.normal, triangle).has_value();
    };
    const Vector3 there = origin_ + axes_ * point;
    if (std::ranges::any_of(face.triangles, is_met) && !crossing(from, there) && !crossing(there, to)) {
      length = detour;
      shortest = Meeting{.face = f, .cosine = std::min(1.0, (before + after) / detour), .point = there};
    }
  }
  return shortest;
}

Vector3 ObjectShape::mirrored(const Vector3& place, std::size_t face) const {
  const double above = faces_[face].normal.dot(own(place)) - faces_[face].height;
  return place - 2.0 * above * (axes_ * faces_[face].normal);
}

Vector3 ObjectShape::mirrored_direction(const Vector3& direction, std::size_t face) const {
  const Vector3 normal = axes_ * faces_[face].normal;
  return direction - 2.0 * normal.dot(direction) * normal;
}

}  // namespace idiophone::timbre
