#include "idiophone/proxies/proxy.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "spring_packs.hpp"

namespace idiophone::proxies {

namespace {

constexpr std::int64_t recent_memory = 0b11111;  // five intervals

bool is_any(const IntegerLanes4& lanes) {
  return (lanes[0] | lanes[1] | lanes[2]) != 0;
}

Vector3 vector_of(const Row& row) {
  return {row.lanes[0], row.lanes[1], row.lanes[2]};
}

/// Sum of the products of two fields of vectors, in a fixed order.
double dot(std::span<const Row> a, std::span<const Row> b) {
  Lanes4 sum{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].lanes * b[i].lanes;
  }
  return sum[0] + sum[1] + sum[2];
}

/// What makes sum(weight . displacement) the sum of normal deviation times area over some triangles, [masses] m2.
void weigh_surface(const TetrahedralMesh& mesh, const auto& is_heard, std::span<Row> weights) {
  std::ranges::fill(weights, Row{});
  for (const auto& [a, b, c] : mesh.surface) {
    const Vector3 area = 0.5 * (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
    if (is_heard(area)) {
      const Lanes4 share = row_of(area / 3.0).lanes;
      weights[a].lanes += share;
      weights[b].lanes += share;
      weights[c].lanes += share;
    }
  }
}

}  // namespace

struct Proxy::State {
  /// For x, y and z of a mass, one bit for each interval with a significant movement.
  struct MemoryRow {
    IntegerLanes4 lanes{};
  };

  std::shared_ptr<const Lattice> lattice;
  ProxyOptions options;
  SpringPacks springs;
  Damping damping;
  double tension = 1.0;
  int steps = 1;
  double step = 0.0;                 // s
  Eigen::Matrix3d turning;           // from torque to angular acceleration, 1/(kg m2)
  std::vector<double> inverse_mass;  // [masses] zero for pinned masses, 1/kg
  std::vector<Row> displacement, velocity, load, force, effective, weights, facing_weights;  // [masses]
  std::vector<Row> first_velocity, first_acceleration;                                       // of an improved step
  std::vector<MemoryRow> memory;                                                             // [masses]
  bool is_loaded = false;  // forces act in the present interval
  bool stable = true;

  State(std::shared_ptr<const Lattice> of, const ProxyOptions& chosen)
      : lattice(std::move(of)), options(chosen), springs(*lattice), damping(lattice->damping()) {
    const std::size_t masses = lattice->masses().size();
    for (auto* field : {&displacement, &velocity, &load, &force, &effective, &weights, &facing_weights, &first_velocity,
                        &first_acceleration}) {
      field->resize(masses);
    }
    memory.resize(masses);
    for (std::size_t i = 0; i < masses; ++i) {
      inverse_mass.push_back(lattice->pinned()[i] ? 0.0 : 1.0 / lattice->masses()[i]);
    }
    const Eigen::Matrix3d& second = lattice->inertia().second;
    turning = (second.trace() * Eigen::Matrix3d::Identity() - second).inverse();
    weigh_surface(
        lattice->mesh(), [](const Vector3& /*area*/) { return true; }, weights);
    facing_weights = weights;
    choose_steps();
  }

  void choose_steps() {
    steps = stable_steps(options.integrator, std::sqrt(tension) * lattice->largest_angular_frequency(), damping,
                         1.0 / options.rate);
    step = 1.0 / (options.rate * steps);
  }

  /// Forces on the three masses of each contact. On a free body, less those that would move it as a rigid body.
  void apply(std::span<const PointForce> forces) {
    Vector3 sum = Vector3::Zero(), torque = Vector3::Zero();
    const Inertia& inertia = lattice->inertia();
    for (const PointForce& applied : forces) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 part = applied.contact.shares[i] * applied.force;
        const Index mass = applied.contact.masses[i];
        load[mass].lanes += row_of(part).lanes;
        sum += part;
        torque += (lattice->mesh().nodes[mass] - inertia.centre).cross(part);
      }
    }
    if (lattice->is_free()) {
      const Vector3 acceleration = sum / inertia.mass, angular = turning * torque;
      for (std::size_t i = 0; i < load.size(); ++i) {
        const Vector3 arm = lattice->mesh().nodes[i] - inertia.centre;
        load[i].lanes -= row_of(lattice->masses()[i] * (acceleration + angular.cross(arm))).lanes;
      }
    }
  }

  /// Displacement by which springs alone would pull as springs and dampers do, which are in proportion to each other.
  [[nodiscard]] Lanes4 effective_displacement(const Lanes4& u, const Lanes4& v) const {
    return tension * (u + damping.stiffness * v);
  }

  /// Adds load and springs to forces of zero.
  void find_forces() {
    for (std::size_t i = 0; is_loaded && i < force.size(); ++i) {
      force[i].lanes = load[i].lanes;
    }
    springs.add_forces(effective, force);
  }

  /// One step. The masses are left with forces of zero, ready for the next.
  void step_symplectic() {
    find_forces();
    const double keep = 1.0 - step * damping.mass;
    for (std::size_t i = 0; i < force.size(); ++i) {
      const Lanes4 v = keep * velocity[i].lanes + step * (inverse_mass[i] * force[i].lanes);
      const Lanes4 u = displacement[i].lanes + step * v;
      velocity[i].lanes = v;
      displacement[i].lanes = u;
      effective[i].lanes = effective_displacement(u, v);
      force[i] = {};
    }
  }

  void step_improved() {
    find_forces();
    for (std::size_t i = 0; i < force.size(); ++i) {
      const Lanes4 v = velocity[i].lanes;
      first_acceleration[i].lanes = inverse_mass[i] * force[i].lanes - damping.mass * v;
      first_velocity[i].lanes = v + step * first_acceleration[i].lanes;
      effective[i].lanes = effective_displacement(displacement[i].lanes + step * v, first_velocity[i].lanes);
      force[i] = {};
    }
    find_forces();
    for (std::size_t i = 0; i < force.size(); ++i) {
      const Lanes4 acceleration = inverse_mass[i] * force[i].lanes - damping.mass * first_velocity[i].lanes;
      displacement[i].lanes += 0.5 * step * (velocity[i].lanes + first_velocity[i].lanes);
      velocity[i].lanes += 0.5 * step * (first_acceleration[i].lanes + acceleration);
      effective[i].lanes = effective_displacement(displacement[i].lanes, velocity[i].lanes);
      force[i] = {};
    }
  }

  /// To be called when a state, a tension or a damping was given.
  void find_effective_displacement() {
    for (std::size_t i = 0; i < effective.size(); ++i) {
      effective[i].lanes = effective_displacement(displacement[i].lanes, velocity[i].lanes);
    }
  }

  /// Notes which masses moved significantly. Returns whether any did in the recent intervals.
  [[nodiscard]] bool remember() {
    const Lanes4 limit = Lanes4{} + options.significant_distance;
    const double interval = 1.0 / options.rate;
    IntegerLanes4 any{};
    for (std::size_t i = 0; i < memory.size(); ++i) {
      const Lanes4 u = displacement[i].lanes, moved = interval * velocity[i].lanes;
      const IntegerLanes4 significant = (u > limit) | (u < -limit) | (moved > limit) | (moved < -limit);
      memory[i].lanes = ((memory[i].lanes << 1) | (significant & 1)) & recent_memory;
      any |= memory[i].lanes;
    }
    return is_any(any);
  }

  void stop() {
    for (auto* field : {&displacement, &velocity, &effective}) {
      std::ranges::fill(*field, Row{});
    }
    std::ranges::fill(memory, MemoryRow{});
    stable = true;
  }
};

Proxy::Proxy(std::shared_ptr<const Lattice> lattice, const ProxyOptions& options)
    : state_(std::make_unique<State>(std::move(lattice), options)) {}
Proxy::~Proxy() = default;
Proxy::Proxy(Proxy&&) noexcept = default;
Proxy& Proxy::operator=(Proxy&&) noexcept = default;

const Lattice& Proxy::lattice() const {
  return *state_->lattice;
}

void Proxy::advance(std::span<const PointForce> forces) {
  State& state = *state_;
  if (forces.empty() && state.stable) {
    return;
  }
  state.is_loaded = !forces.empty();
  if (state.is_loaded) {
    state.apply(forces);
  }
  for (int i = 0; i < state.steps; ++i) {
    state.options.integrator == Integrator::symplectic_euler ? state.step_symplectic() : state.step_improved();
  }
  if (state.is_loaded) {
    std::ranges::fill(state.load, Row{});
  }
  state.stable = false;
  if (!state.remember() && !state.is_loaded) {
    state.stop();
  }
}

bool Proxy::is_stable() const {
  return state_->stable;
}

std::size_t Proxy::unstable_masses() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(state_->memory, [](const State::MemoryRow& bits) { return is_any(bits.lanes); }));
}

void Proxy::stop() {
  state_->stop();
}

double Proxy::deviation() const {
  return dot(state_->weights, state_->displacement);
}

double Proxy::facing_volume_velocity() const {
  return dot(state_->facing_weights, state_->velocity);
}

void Proxy::face(const Vector3& direction) {
  weigh_surface(
      state_->lattice->mesh(), [&](const Vector3& area) { return area.dot(direction) > 0.0; }, state_->facing_weights);
}

void Proxy::set_tension(double factor) {
  if (!(factor > 0.0)) {
    throw std::invalid_argument("the tension must be above 0");
  }
  state_->tension = factor;
  state_->choose_steps();
  state_->find_effective_displacement();
}

void Proxy::set_damping(const Damping& damping) {
  state_->damping = damping;
  state_->choose_steps();
  state_->find_effective_displacement();
}

void Proxy::set_rate(double rate) {
  state_->options.rate = rate;
  state_->choose_steps();
}

int Proxy::steps() const {
  return state_->steps;
}

double Proxy::springs_per_second() const {
  const double evaluations = state_->options.integrator == Integrator::improved_euler ? 2.0 : 1.0;
  return evaluations * static_cast<double>(state_->springs.packs() * pack_size) * state_->steps * state_->options.rate;
}

double Proxy::kinetic_energy() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < state_->velocity.size(); ++i) {
    sum += 0.5 * state_->lattice->masses()[i] * vector_of(state_->velocity[i]).squaredNorm();
  }
  return sum;
}

double Proxy::elastic_energy() const {
  std::vector<Row> force(state_->displacement.size());
  state_->springs.add_forces(state_->displacement, force);
  return -0.5 * state_->tension * dot(force, state_->displacement);
}

Vector3 Proxy::momentum() const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < state_->velocity.size(); ++i) {
    sum += state_->lattice->masses()[i] * vector_of(state_->velocity[i]);
  }
  return sum;
}

Vector3 Proxy::angular_momentum() const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < state_->velocity.size(); ++i) {
    const Vector3 arm = state_->lattice->mesh().nodes[i] - state_->lattice->inertia().centre;
    sum += state_->lattice->masses()[i] * arm.cross(vector_of(state_->velocity[i]));
  }
  return sum;
}

Vector3 Proxy::displacement(Index mass) const {
  return vector_of(state_->displacement.at(mass));
}

void Proxy::set_state(std::span<const Vector3> displacement, std::span<const Vector3> velocity) {
  State& state = *state_;
  if (displacement.size() != state.displacement.size() || velocity.size() != state.velocity.size()) {
    throw std::invalid_argument("a state has one displacement and one velocity for each mass");
  }
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const bool moves = !state.lattice->pinned()[i];
    state.displacement[i] = moves ? row_of(displacement[i]) : Row{};
    state.velocity[i] = moves ? row_of(velocity[i]) : Row{};
  }
  std::ranges::fill(state.memory, State::MemoryRow{IntegerLanes4{} + recent_memory});
  state.find_effective_displacement();
  state.stable = false;
}

}  // namespace idiophone::proxies
