#include "idiophone/instruments/proxies/proxy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "surface_weights.hpp"
#include "vibration.hpp"

namespace idiophone::proxies {

namespace {

constexpr unsigned recent_memory = 0b11111;          // five intervals
constexpr unsigned intervals_to_rigid_motion = 256;  // after which what rounding added to it is taken away

}  // namespace

struct Proxy::State {
  std::shared_ptr<const Lattice> lattice;
  ProxyOptions options;
  Vibration vibration;
  Rows weights, facing_weights, next_facing_weights;  // [masses]
  int steps = 1;
  double step = 0.0;       // s
  unsigned memory = 0;     // one bit for each recent interval in which a mass moved significantly
  unsigned intervals = 0;  // since the proxy was stable
  bool stable = true;

  State(std::shared_ptr<const Lattice> of, const ProxyOptions& chosen)
      : lattice(std::move(of)), options(chosen), vibration(*lattice), weights(vibration.displacement().size()) {
    weigh_surface(
        lattice->mesh(), [](const Vector3& /*area*/) { return true; }, weights);
    facing_weights = next_facing_weights = weights;
    choose_steps(vibration.tension(), vibration.damping());
  }

  void choose_steps(double tension, const Damping& damping) {
    steps = stable_steps(options.integrator, std::sqrt(tension) * lattice->largest_angular_frequency(), damping,
                         1.0 / options.rate);
    step = 1.0 / (options.rate * steps);
  }

  void stop() {
    vibration.stop();
    memory = 0;
    intervals = 0;
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
  state.vibration.load(forces);
  for (int i = 0; i < state.steps; ++i) {
    state.vibration.step(state.options.integrator, state.step);
  }
  if (++state.intervals % intervals_to_rigid_motion == 0) {
    state.vibration.remove_rigid_motion();
  }
  state.stable = false;
  const bool moves = state.vibration.moves(state.options.significant_distance, 1.0 / state.options.rate);
  state.memory = ((state.memory << 1U) | (moves ? 1U : 0U)) & recent_memory;
  if (state.memory == 0 && forces.empty()) {
    state.stop();
  }
}

bool Proxy::is_stable() const {
  return state_->stable;
}

void Proxy::stop() {
  state_->stop();
}

double Proxy::deviation() const {
  return dot(state_->weights, state_->vibration.displacement());
}

double Proxy::facing_volume_velocity() const {
  return dot(state_->facing_weights, state_->vibration.velocity());
}

double Proxy::next_facing_volume_velocity() const {
  return dot(state_->next_facing_weights, state_->vibration.velocity());
}

void Proxy::face(const Vector3& direction) {
  static_cast<void>(turn_to(direction));
  end_turn();
}

void Proxy::end_turn() {
  std::ranges::copy(state_->next_facing_weights, state_->facing_weights.begin());
}

bool Proxy::turn_to(const Vector3& direction) {
  weigh_surface(
      state_->lattice->mesh(), [&](const Vector3& area) { return area.dot(direction) > 0.0; },
      state_->next_facing_weights);
  return !std::ranges::equal(state_->next_facing_weights, state_->facing_weights,
                             [](const Row& a, const Row& b) { return vector_of(a) == vector_of(b); });
}

void Proxy::tune(double tension, const Damping& damping) {
  if (!(tension > 0.0) || !std::isfinite(tension) || !(damping.mass >= 0.0) || !(damping.stiffness >= 0.0)) {
    throw std::invalid_argument("the tension must be above 0, damping must not be negative");
  }
  state_->choose_steps(tension, damping);
  state_->vibration.tune(tension, damping);
}

void Proxy::set_rate(double rate) {
  state_->options.rate = rate;
  state_->choose_steps(state_->vibration.tension(), state_->vibration.damping());
}

int Proxy::steps() const {
  return state_->steps;
}

double Proxy::springs_per_second() const {
  const double evaluations = state_->options.integrator == Integrator::improved_euler ? 2.0 : 1.0;
  const auto springs = static_cast<double>(state_->vibration.packs() * springs_in_pack);
  return evaluations * springs * state_->steps * state_->options.rate;
}

double Proxy::kinetic_energy() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < lattice().masses().size(); ++i) {
    sum += 0.5 * lattice().masses()[i] * vector_of(state_->vibration.velocity()[i]).squaredNorm();
  }
  return sum;
}

double Proxy::elastic_energy() const {
  const Rows& displacement = state_->vibration.displacement();
  Rows force(displacement.size());
  state_->vibration.springs().add_forces(displacement, force);
  return -0.5 * state_->vibration.tension() * dot(force, displacement);
}

Vector3 Proxy::momentum() const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < lattice().masses().size(); ++i) {
    sum += lattice().masses()[i] * vector_of(state_->vibration.velocity()[i]);
  }
  return sum;
}

Vector3 Proxy::angular_momentum() const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < lattice().masses().size(); ++i) {
    const Vector3 arm = lattice().mesh().nodes[i] - lattice().inertia().centre;
    sum += lattice().masses()[i] * arm.cross(vector_of(state_->vibration.velocity()[i]));
  }
  return sum;
}

Vector3 Proxy::displacement(Index mass) const {
  return vector_of(state_->vibration.displacement().at(mass));
}

Vector3 Proxy::velocity(Index mass) const {
  return vector_of(state_->vibration.velocity().at(mass));
}

void Proxy::set_state(std::span<const Vector3> displacement, std::span<const Vector3> velocity) {
  if (displacement.size() != lattice().masses().size() || velocity.size() != lattice().masses().size()) {
    throw std::invalid_argument("a state has one displacement and one velocity for each mass");
  }
  state_->vibration.set_state(displacement, velocity);
  state_->memory = recent_memory;
  state_->stable = false;
}

}  // namespace idiophone::proxies
