#include "box.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::timbre {

namespace {

constexpr double touching = 1e-9;  // m, or part of a way: what only touches the box is outside

}  // namespace

std::optional<Box::Meeting> Box::crossing(const Vector3& from, const Vector3& to) const {
  const Vector3 begin = axes.transpose() * (from - centre), way = axes.transpose() * (to - from);
  double enters = 0.0, leaves = 1.0;  // parts of the way
  std::optional<Face> entry, exit;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0.0) {
      if (std::abs(begin[axis]) >= half[axis] - touching) {
        return {};
      }
      continue;
    }
    const double sign = way[axis] > 0.0 ? 1.0 : -1.0;
    const double in = (-sign * half[axis] - begin[axis]) / way[axis];
    const double out = (sign * half[axis] - begin[axis]) / way[axis];
    if (in > enters) {
      enters = in;
      entry = Face{axis, -sign};
    }
    if (out < leaves) {
      leaves = out;
      exit = Face{axis, sign};
    }
  }
  if (leaves - enters <= touching || (!entry && !exit)) {
    return {};
  }
  const Face face = entry ? *entry : *exit;
  return Meeting{.face = face,
                 .cosine = std::abs(way[face.axis]) / way.norm(),
                 .point = from + (entry ? enters : leaves) * (to - from)};
}

std::optional<Box::Meeting> Box::reflection(const Vector3& from, const Vector3& to) const {
  const Vector3 begin = axes.transpose() * (from - centre), end = axes.transpose() * (to - centre);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double sign = begin[axis] > 0.0 ? 1.0 : -1.0;
    const double before = sign * begin[axis] - half[axis], after = sign * end[axis] - half[axis];  // above the face
    if (before < -touching || after < -touching || before + after <= touching) {
      continue;
    }
    Vector3 local = (begin * after + end * before) / (before + after);
    local[axis] = sign * half[axis];
    bool is_on_face = true;
    for (Eigen::Index other = 0; other < 3; ++other) {
      is_on_face = is_on_face && (other == axis || std::abs(local[other]) <= half[other]);
    }
    if (is_on_face) {
      const Face face{axis, sign};
      return Meeting{.face = face,
                     .cosine = std::min(1.0, (before + after) / (mirrored(from, face) - to).norm()),
                     .point = centre + axes * local};
    }
  }
  return {};
}

Vector3 Box::mirrored(const Vector3& place, Face face) const {
  const Vector3 normal = axes.col(face.axis);
  return place + 2.0 * (face.sign * half[face.axis] - normal.dot(place - centre)) * normal;
}

Vector3 Box::mirrored_direction(const Vector3& direction, Face face) const {
  const Vector3 normal = axes.col(face.axis);
  return direction - 2.0 * normal.dot(direction) * normal;
}

}  // namespace idiophone::timbre
