#include "idiophone/solids/solid/leapfrog.hpp"

#include "node_lines.hpp"

namespace idiophone::solid {

namespace {

static_assert(sizeof(NodeState) == sizeof(Pack));

/// Which of a NodeState's numbers are taken.
using Mask = long long __attribute__((vector_size(sizeof(Pack))));
constexpr Mask displacement = {-1, -1, -1, 0, 0, 0, 0, 0};
constexpr Mask velocity = {0, 0, 0, -1, -1, -1, 0, 0};

}  // namespace

void update_velocities(const Kick& kick, std::span<const double> inverse_mass, std::span<const NodeForce> force,
                       std::span<NodeState> state) {
  const Pack gravity = {0, 0, 0, kick.gravity[0], kick.gravity[1], kick.gravity[2], 0, 0};
  for (std::size_t node = 0; node < state.size(); ++node) {
    ForceLine f;
    Pack line;
    std::memcpy(&f, force[node].component, sizeof(f));
    std::memcpy(&line, &state[node], sizeof(line));
    const Pack at_velocity = __builtin_shufflevector(f, f, 0, 0, 0, 0, 1, 2, 0, 0);
    const Pack acceleration = at_velocity * inverse_mass[node] + gravity;
    const Pack next = kick.keep * line + kick.gain * acceleration;
    line = velocity ? next : line;
    std::memcpy(static_cast<void*>(&state[node]), &line, sizeof(line));
  }
}

void update_displacements(double step, std::span<NodeState> state) {
  for (NodeState& node : state) {
    Pack line;
    std::memcpy(&line, &node, sizeof(line));
    const Pack at_displacement = __builtin_shufflevector(line, line, 3, 4, 5, 3, 4, 5, 6, 7);
    const Pack next = line + step * at_displacement;
    line = displacement ? next : line;
    std::memcpy(static_cast<void*>(&node), &line, sizeof(line));
  }
}

}  // namespace idiophone::solid
