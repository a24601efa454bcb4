// Which faces of a fracture surface are under too much stress, and break.

#include <algorithm>
#include <cmath>

#include "face_area.hpp"
#include "idiophone/solids/motion/body_fracture.hpp"

namespace idiophone::motion {

Vector3 BodyFracture::normal_of(const Face& face, std::span<const NodeState> state) const {
  return area_vector(face.corners,
                     [&](Index node) -> Vector3 { return part_.reference[node] + Vector3(state[node].displacement); })
      .normalized();
}

Vector3 BodyFracture::stress(const Face& face) const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < face.joints.size(); ++k) {
    const Joint& joint = joints_[face.joints[k]];
    if (joint.is_measured) {
      sum += (face.places[0][k] == 0 ? 1.0 : -1.0) / joint.area * joint.force;
    }
  }
  return sum / face.weight;
}

bool BodyFracture::is_too_weak(const Face& face, std::span<const NodeState> state) const {
  const Vector3 normal = normal_of(face, state), stress = this->stress(face);
  const double pull = stress.dot(normal), shear = (stress - pull * normal).norm();
  return std::hypot(std::max(pull, 0.0) / face.law.strength, shear / face.law.shear_strength) > 1.0;
}

std::vector<std::size_t> BodyFracture::break_faces(std::span<const NodeState> state) {
  std::vector<std::size_t> breaking;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (broken_[f] == 0 && faces_[f].weight > 0 && is_too_weak(faces_[f], state)) {
      breaking.push_back(f);
    }
  }
  for (const std::size_t face : breaking) {
    broken_[face] = 1;
    cohesions_[face].stress = stress(faces_[face]);
  }
  if (!breaking.empty()) {
    join_nodes();
  }
  return breaking;
}

}  // namespace idiophone::motion
