// Between the sides of broken faces: cohesion while they open, and pressure where they close again.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "idiophone/solids/motion/body_fracture.hpp"

namespace idiophone::motion {

namespace {

Vector3 displacement_between(const std::array<Index, 2>& nodes, std::span<const NodeState> state) {
  return Vector3(state[nodes[1]].displacement) - Vector3(state[nodes[0]].displacement);
}

void change_velocity(NodeState& node, const Vector3& by) {
  for (int axis = 0; axis < 3; ++axis) {
    node.velocity[axis] += by[axis];
  }
}

}  // namespace

std::array<Index, 2> BodyFracture::pair_of(const Face& face, std::size_t place) const {
  const Joint& joint = joints_[face.joints[place]];
  return {joint.nodes[face.places[0][place]], joint.nodes[face.places[1][place]]};
}

template <class Visitor>
void BodyFracture::for_each_bearing(const Face& face, Visitor visit) const {
  for (std::size_t place = 0; place < face.joints.size(); ++place) {
    if (face.shares[place] > 0.0 && joints_[face.joints[place]].is_measured) {
      visit(place, face.shares[place] / face.weight);
    }
  }
}

double BodyFracture::last_opening(std::size_t face) const {
  return 2.0 * faces_[face].law.energy / cohesions_[face].stress.norm();
}

double BodyFracture::cohesion_left(std::size_t face) const {
  const Cohesion& cohesion = cohesions_[face];
  const double at_widest = 1.0 - cohesion.widest / last_opening(face);
  if (at_widest <= 0.0 || cohesion.opening < 0.0) {
    return 0.0;
  }
  return cohesion.opening < cohesion.widest ? at_widest * cohesion.opening / cohesion.widest : at_widest;
}

void BodyFracture::hold_together(std::size_t face, double gain, std::span<NodeState> state) {
  const Face& sides = faces_[face];
  Cohesion& cohesion = cohesions_[face];
  if (broken_[face] == 0 || !(sides.law.energy > 0.0) || cohesion.widest >= last_opening(face)) {
    return;
  }
  const Vector3 direction = cohesion.stress.normalized();
  cohesion.opening = 0.0;
  for_each_bearing(sides, [&](std::size_t place, double part) {
    cohesion.opening += part * displacement_between(pair_of(sides, place), state).dot(direction);
  });
  cohesion.widest = std::max(cohesion.widest, cohesion.opening);
  const double left = cohesion_left(face);
  for_each_bearing(sides, [&](std::size_t place, double part) {
    const Vector3 impulse = gain * part * sides.area * left * cohesion.stress;
    const Joint& joint = joints_[sides.joints[place]];
    const auto [near, far] = pair_of(sides, place);
    change_velocity(state[near], impulse / joint.masses[sides.places[0][place]]);
    change_velocity(state[far], -impulse / joint.masses[sides.places[1][place]]);
  });
}

double BodyFracture::taken_energy() const {
  double energy = 0.0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (broken_[f] == 0 || !(faces_[f].law.energy > 0.0)) {
      continue;
    }
    const auto& [stress, widest, opening] = cohesions_[f];
    const double last = last_opening(f), reached = std::min(widest, last);
    // Below the line down to the widest opening, less what would come back from there, plus what is stored now.
    const double spent = stress.norm() * (reached - reached * reached / (2.0 * last));
    const double at_widest = 0.5 * stress.norm() * (1.0 - reached / last) * reached;
    const double stored = 0.5 * stress.norm() * cohesion_left(f) * std::max(opening, 0.0);
    energy += faces_[f].area * (spent - at_widest + stored);
  }
  return energy;
}

void BodyFracture::press(std::span<NodeState> state) const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    if (broken_[f] == 0 || !face.law.contact) {
      continue;
    }
    const Vector3 normal = normal_of(face, state);
    const double reach = 0.5 * std::sqrt(face.area);  // m: sides that slid farther meet other nodes
    for (std::size_t k = 0; k < face.joints.size(); ++k) {
      const Joint& joint = joints_[face.joints[k]];
      const auto [near, far] = pair_of(face, k);
      const Vector3 between = displacement_between({near, far}, state);
      const double gap = between.dot(normal);
      const double opens = (Vector3(state[far].velocity) - Vector3(state[near].velocity)).dot(normal);
      if (!joint.is_measured || joint.leaders[1] == 0 || gap > 0.0 || opens >= 0.0 ||
          (between - gap * normal).norm() > reach) {
        continue;
      }
      const double near_mass = joint.masses[face.places[0][k]], far_mass = joint.masses[face.places[1][k]];
      const Vector3 impulse = -opens / (1.0 / near_mass + 1.0 / far_mass) * normal;
      change_velocity(state[near], -impulse / near_mass);
      change_velocity(state[far], impulse / far_mass);
    }
  }
}

}  // namespace idiophone::motion
