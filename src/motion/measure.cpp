#include "idiophone/motion/measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone::motion {

namespace {

void add(std::array<ReproducibleSum, 3>& sums, const Vector3& terms) {
  for (std::size_t i = 0; i < 3; ++i) {
    sums[i].add(terms[static_cast<Eigen::Index>(i)]);
  }
}

}  // namespace

std::array<ReproducibleSum, BodySums::count> BodySums::all() const {
  std::array<ReproducibleSum, count> sums;
  std::size_t next = 0;
  for (const auto* vector : {&position, &momentum, &angular_momentum}) {
    for (const ReproducibleSum& sum : *vector) {
      sums[next++] = sum;
    }
  }
  sums[next++] = kinetic;
  sums[next] = elastic;
  return sums;
}

std::vector<BodySums> measure(Motion& motion, const mesh::Part& part) {
  std::vector<Vector3> velocity;
  motion.evaluate(velocity);
  std::vector<BodySums> bodies(part.bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const mesh::BodyPart& body = part.bodies[b];
    for (auto node = static_cast<std::size_t>(body.owned_begin); node < static_cast<std::size_t>(body.owned_end);
         ++node) {
      const double mass = motion.dynamics().mass()[node];
      const Vector3 position = part.reference[node] + Eigen::Map<const Vector3>(motion.state()[node].displacement);
      const Vector3 momentum = mass * velocity[node];
      add(bodies[b].position, mass * position);
      add(bodies[b].momentum, momentum);
      add(bodies[b].angular_momentum, position.cross(momentum));
      bodies[b].kinetic.add(momentum.dot(velocity[node]) / 2);
    }
    std::vector<double> energy(body.element_ids.size());
    motion.dynamics().solids()[b].elastic_energy(motion.state().data(), energy);
    for (std::size_t element = 0; element < energy.size(); ++element) {
      if (body.owned[element] != 0) {
        bodies[b].elastic.add(energy[element]);
      }
    }
  }
  return bodies;
}

}  // namespace idiophone::motion
