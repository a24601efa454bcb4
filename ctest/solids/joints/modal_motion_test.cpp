// Motion of modal bodies that joints tie together.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/solids/modal_bodies/modal_models.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/solids/motion/stable_step.hpp"
#include "modal_assemblies.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

/// What is attached where the only pulse acts evenly on a group of the first body.
motion::Attachments pushed_at(const Assembly& bodies, const std::string& group) {
  const auto& nodes = bodies.meshes[0].groups.at(group);
  scene::Scene joined = bodies.scene;
  joined.pulses.clear();
  motion::Attachments attachments = motion::attach(joined, bodies.meshes);
  attachments.pulses = {{nodes, std::vector(nodes.size(), 1.0 / static_cast<double>(nodes.size()))}};
  return attachments;
}

/// The bar, glued, which a push on its first end sets into motion.
struct PushedBar {
  /// @param modal  the bodies that move by their modes
  /// @param damping  of the joint, s
  explicit PushedBar(const std::vector<std::size_t>& modal, double damping = 0.0)
      : bar(cut_bar(scene::JointStiffness{4e13, 1.6e13}, damping)) {
    for (const std::size_t body : modal) {
      make_modal(bar, body, 6);
    }
    scene::ForcePulse pulse;
    pulse.force = {30, 20, 100};
    pulse.signal.duration = push;
    bar.scene.pulses = {pulse};
    bases = bases_of(bar);
    attachments = pushed_at(bar, "x0");
    part = mesh::distribute(bar.meshes, MPI_COMM_SELF);
    models = modal_bodies::modal_models(bar.scene, bases);
  }

  /// s
  [[nodiscard]] double stable_step() const { return eigenmodes::stable_step(bar, part, attachments, models); }

  /// @param step  s
  void begin(double step) {
    motion = std::make_unique<motion::Motion>(bar.scene, part, attachments, contact::ContactSurfaces{}, step, 16,
                                              MPI_COMM_SELF, models, 16);
    initial_state = motion::mass_properties(motion->dynamics(), part);
    motion->start(initial_state.centres, {});
  }

  /// Mean displacement of the second body's end, m.
  [[nodiscard]] Vector3 end() {
    motion->update_nodes();
    const auto& nodes = bar.meshes[1].groups.at("x1");
    Vector3 sum = Vector3::Zero();
    for (const Index node : nodes) {
      sum += Vector3(motion->state()[part.bodies[1].owned_begin + node].displacement);
    }
    return sum / static_cast<double>(nodes.size());
  }

  [[nodiscard]] std::vector<motion::BodyMotion> observe() {
    const auto sums = motion::measure(*motion, initial_state);
    return {motion::body_motion(sums[0], initial_state, 0), motion::body_motion(sums[1], initial_state, 1)};
  }

  /// Of joints, elastic and kinetic, J.
  [[nodiscard]] double energy() {
    ReproducibleSum sum;
    motion->dynamics().joints().add_energy(motion->state(), sum);
    double total = sum.value();
    for (const motion::BodyMotion& body : observe()) {
      total += body.kinetic + body.elastic;
    }
    return total;
  }

  static constexpr double push = 4e-4;  // s
  Assembly bar;
  modal_bodies::ModalBases bases;
  motion::Attachments attachments;
  mesh::Part part;
  motion::ModelMaker models;
  motion::InitialState initial_state;
  std::unique_ptr<motion::Motion> motion;
};

/// The motions of the bodies of an assembly that starts at its rest with velocities, as reported and as its nodes have
/// them. All bodies are modal.
void expect_motions_of_nodes(const Assembly& assembly) {
  const modal_bodies::ModalBases bases = bases_of(assembly);
  const motion::Attachments attachments = motion::attach(assembly.scene, assembly.meshes);
  const mesh::Part part = mesh::distribute(assembly.meshes, MPI_COMM_SELF);
  motion::Motion motion(assembly.scene, part, attachments, contact::ContactSurfaces{}, 1e-7, 16, MPI_COMM_SELF,
                        modal_bodies::modal_models(assembly.scene, bases), 16);
  const motion::InitialState initial_state = motion::mass_properties(motion.dynamics(), part);
  std::vector<double> rest;
  for (const auto& [body, basis] : bases) {
    rest.insert(rest.end(), basis.rest.begin(), basis.rest.end());
  }
  motion.start(initial_state.centres, rest);
  motion.update_nodes();
  const auto sums = motion::measure(motion, initial_state);
  for (const auto& [body, basis] : bases) {
    const motion::BodyMotion found = motion::body_motion(sums[body], initial_state, body);
    Vector3 centre = Vector3::Zero(), angular = Vector3::Zero();
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    const auto state_of = [&](std::size_t node) { return motion.state()[part.bodies[body].owned_begin + node]; };
    const auto place_of = [&](std::size_t node) -> Vector3 {
      return assembly.meshes[body].nodes[node] + Vector3(state_of(node).displacement);
    };
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      centre += basis.masses[node] / initial_state.masses[body] * place_of(node);
    }
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      const Vector3 arm = place_of(node) - centre;
      angular += basis.masses[node] * arm.cross(Vector3(state_of(node).velocity));
      moment += basis.masses[node] * arm * arm.transpose();
    }
    const Vector3 spin = inertia_tensor(moment).ldlt().solve(angular);
    EXPECT_LT((found.centre - centre).norm(), 1e-9);
    EXPECT_LT((found.angular_momentum - angular).norm(), 1e-9 * angular.norm());
    EXPECT_LT((found.angular_velocity - spin).norm(), 1e-8 * spin.norm());
  }
}

ON_RANKS(1);

TEST(JoinedModalBodies, AboutARestMoveAsTheirNodes) {
  Assembly strips = taut_strips(scene::JointStiffness{1e12, 4e11});
  for (const std::size_t body : {0, 1}) {
    make_modal(strips, body, 4);
    strips.scene.bodies[body].velocity = {0.3, 1, 2};
    strips.scene.bodies[body].spin = {5, 7, 3};
  }
  expect_motions_of_nodes(strips);
  strips.scene.bodies[1].fixed.clear();
  expect_motions_of_nodes(strips);
}

/// Where the end of the bar is at ten times in 1.5 ms, m.
std::vector<Vector3> path_of_end(const std::vector<std::size_t>& modal, double damping) {
  PushedBar bar(modal, damping);
  constexpr double interval = 1.5e-4;  // s
  const int steps = static_cast<int>(std::ceil(interval / (0.9 * bar.stable_step())));
  bar.begin(interval / steps);
  std::vector<Vector3> path;
  for (int place = 1; place <= 10; ++place) {
    bar.motion->advance_to(std::int64_t{place} * steps);
    path.push_back(bar.end());
  }
  return path;
}

TEST(JoinedModalBodies, MoveAsTheirFiniteElements) {
  constexpr double damping = 5e-8;  // s
  const std::vector<Vector3> expected = path_of_end({}, damping);
  const auto difference_of = [&](const std::vector<Vector3>& found) {
    double largest = 0.0, difference = 0.0;
    for (std::size_t place = 0; place < expected.size(); ++place) {
      largest = std::max(largest, expected[place].norm());
      difference = std::max(difference, (found[place] - expected[place]).norm());
    }
    return difference / largest;
  };
  for (const std::vector<std::size_t>& modal : {std::vector<std::size_t>{0, 1}, {0}, {1}}) {
    EXPECT_LT(difference_of(path_of_end(modal, damping)), 5e-4) << modal.size();
  }
}

/// The largest change of the energy in the 2000 steps after the push, in parts of it; infinity where the motion is not
/// finite.
double largest_drift(double steps) {
  PushedBar bar({0, 1});
  bar.begin(steps * bar.stable_step());
  while (bar.motion->time() <= PushedBar::push) {
    bar.motion->advance();
  }
  const double energy = bar.energy();
  double largest = 0.0;
  for (int i = 0; i < 20; ++i) {
    bar.motion->advance_to(bar.motion->step_number() + 100);
    const double drift = std::abs(bar.energy() / energy - 1);
    largest = std::isfinite(drift) ? std::max(largest, drift) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

TEST(JoinedModalBodies, AreStableUpToTheStepThatIsPredicted) {
  EXPECT_LT(largest_drift(0.98), 0.1);
  EXPECT_GT(largest_drift(4.0), 0.1);  // nor is it much too short
}

TEST(JoinedModalBodies, KeepMomentumAndEnergyAfterThePush) {
  PushedBar bar({0, 1});
  bar.begin(0.5 * bar.stable_step());
  const auto whole_momenta = [&] {
    std::pair momenta{Vector3(Vector3::Zero()), Vector3(Vector3::Zero())};  // linear, angular about the origin
    const auto bodies = bar.observe();
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      const Vector3 momentum = bar.initial_state.masses[body] * bodies[body].velocity;
      momenta.first += momentum;
      momenta.second += bodies[body].angular_momentum + bodies[body].centre.cross(momentum);
    }
    return momenta;
  };
  while (bar.motion->time() <= PushedBar::push) {
    bar.motion->advance();
  }
  const auto [linear, angular] = whole_momenta();
  const double energy = bar.energy();
  double drift = 0.0;
  for (int i = 0; i < 20; ++i) {
    bar.motion->advance_to(bar.motion->step_number() + 100);
    drift = std::max(drift, std::abs(bar.energy() / energy - 1));
  }
  const auto [linear_after, angular_after] = whole_momenta();
  EXPECT_LT((linear_after - linear).norm(), 1e-12 * linear.norm());
  EXPECT_LT((angular_after - angular).norm(), 1e-11 * angular.norm());
  EXPECT_LT(drift, 1e-5);
}

}  // namespace
}  // namespace idiophone::eigenmodes
