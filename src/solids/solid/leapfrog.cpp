#include "idiophone/solids/solid/leapfrog.hpp"

#include "node_lines.hpp"

namespace idiophone::solid {

namespace {

/// Half of a NodeState: the displacement and the velocity along x; the velocity along y and z and padding.
using Half = ForceLine;
static_assert(sizeof(NodeState) == 2 * sizeof(Half));

Half load(const double* numbers) {
  Half half;
  std::memcpy(&half, numbers, sizeof(half));
  return half;
}

/// Which of a half's numbers are taken.
using Mask = long long __attribute__((vector_size(sizeof(Half))));
constexpr Mask displacement = {-1, -1, -1, 0};
constexpr Mask velocity_x = {0, 0, 0, -1};
constexpr Mask velocity_yz = {-1, -1, 0, 0};

}  // namespace

void update_velocities(const Kick& kick, std::span<const double> inverse_mass, std::span<const NodeForce> force,
                       std::span<NodeState> state) {
  const Half gravity_x = {0, 0, 0, kick.gravity[0]};
  const Half gravity_yz = {kick.gravity[1], kick.gravity[2], 0, 0};
  for (std::size_t node = 0; node < state.size(); ++node) {
    double* numbers = state[node].displacement;
    const Half f = load(force[node].component);
    const auto update = [&](const Mask& taken, const Half& at_velocity, const Half& gravity, double* at) {
      const Half line = load(at);
      const Half acceleration = at_velocity * inverse_mass[node] + gravity;
      const Half next = kick.keep * line + kick.gain * acceleration;
      const Half result = taken ? next : line;
      std::memcpy(at, &result, sizeof(result));
    };
    update(velocity_x, __builtin_shufflevector(f, f, 0, 0, 0, 0), gravity_x, numbers);
    update(velocity_yz, __builtin_shufflevector(f, f, 1, 2, 0, 0), gravity_yz, numbers + 4);
  }
}

void update_displacements(double step, std::span<NodeState> state) {
  for (NodeState& node : state) {
    const Half line = load(node.displacement);
    const Half at_displacement = __builtin_shufflevector(line, load(node.displacement + 4), 3, 4, 5, 3);
    const Half next = line + step * at_displacement;
    const Half result = displacement ? next : line;
    std::memcpy(node.displacement, &result, sizeof(result));
  }
}

}  // namespace idiophone::solid
