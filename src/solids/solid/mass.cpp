#include "idiophone/solids/solid/mass.hpp"

#include <cmath>
#include <utility>

namespace idiophone::solid {

Mass::Mass(const mesh::BodyPart& body, std::span<const double> lumped, AddedMass added)
    : begin_(body.owned_begin),
      lumped_(lumped.begin() + body.owned_begin, lumped.begin() + body.owned_end),
      added_(std::move(added)) {
  for (const double mass : lumped_) {
    inverse_.push_back(1.0 / mass);
    inverse_root_.push_back(1.0 / std::sqrt(mass));
  }
}

void Mass::accelerate(const Kick& kick, double age, std::span<NodeForce> force, std::span<NodeState> state) const {
  added_.reduce_to_lumped(state, age, force);
  update_velocities(kick, inverse_, force.subspan(begin_, inverse_.size()), state.subspan(begin_, inverse_.size()));
}

void Mass::impose(std::span<const Index> components, std::span<const double> velocities, std::span<NodeState> state,
                  std::span<double> impulses) const {
  added_.impose(velocities, state, impulses);
  for (std::size_t c = 0; c < impulses.size(); ++c) {
    const Index node = components[c] / 3;
    const double change = velocities[c] - state[node].velocity[components[c] % 3];  // 0 where there is added mass
    impulses[c] += lumped(node) * change;
  }
  for (std::size_t c = 0; c < components.size(); ++c) {
    state[components[c] / 3].velocity[components[c] % 3] = velocities[c];
  }
}

void Mass::apply_inverse_factor(std::span<double> x) const {
  added_.apply_inverse_root(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] *= inverse_root_[i / 3];
  }
}

void Mass::apply_transposed_inverse_factor(std::span<double> x) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] *= inverse_root_[i / 3];
  }
  added_.apply_inverse_root(x);
}

}  // namespace idiophone::solid
