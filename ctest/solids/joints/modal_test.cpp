// Modal bodies that joints tie together.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "assembly.hpp"
#include "block_mesh.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/modal_bodies/modal_models.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/solids/motion/stable_step.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

/// A bar of 200 x 20 x 10 mm, cut at 80 mm and joined; meshes that do not match.
Assembly cut_bar(std::optional<scene::JointStiffness> stiffness, double damping = 0.0) {
  Assembly bar;
  bar.add(support::block_mesh(element::hex(4, 2), {0.08, 0.02, 0.01}, {2, 1, 1}), Vector3::Zero());
  bar.add(support::block_mesh(element::hex(4, 2), {0.12, 0.02, 0.01}, {3, 2, 1}), {0.08, 0, 0});
  bar.join("x1", "x0", stiffness, damping);
  return bar;
}

/// A bar of 100 x 20 x 10 mm with a spring between its ends.
Assembly strung_bow() {
  Assembly bow;
  bow.add(support::block_mesh(element::hex(4, 2), {0.1, 0.02, 0.01}, {2, 1, 1}), Vector3::Zero());
  scene::Joint spring;
  spring.type = scene::JointType::spring;
  spring.surfaces = {scene::JoinedSurface{0, "x0", {}}, scene::JoinedSurface{0, "x1", {}}};
  spring.stiffness = {1e8, 1e7};
  bow.scene.joints = {spring};
  return bow;
}

/// This bar with a bolt from end to end.
Assembly bolted_bar() {
  Assembly bar = strung_bow();
  scene::Joint& bolt = bar.scene.joints.front();
  bolt.type = scene::JointType::bolt;
  bolt.axis = {{0.0, 0.01, 0.005}, {0.1, 0.01, 0.005}};
  bolt.shank = {.radius = 0.003, .washer = 0.01, .young = 2e11, .poisson = 0.3, .preload = 1e4};
  return bar;
}

/// Two strips of steel end to end, held at their outer ends; the second one is 100 K colder and pulls at the first one.
Assembly taut_strips(std::optional<scene::JointStiffness> stiffness) {
  Assembly strips;
  strips.scene.materials[0].expansion = 1.2e-5;
  strips.add(support::block_mesh(element::hex(4, 2), {0.12, 0.01, 0.001}, {4, 1, 1}), Vector3::Zero());
  strips.add(support::block_mesh(element::hex(4, 2), {0.16, 0.01, 0.001}, {5, 2, 1}), {0.12, 0, 0});
  strips.join("x1", "x0", stiffness);
  strips.scene.bodies[0].fixed.push_back({.group = "x0", .axes = {true, true, true}, .hinge = false, .where = {}});
  strips.scene.bodies[1].fixed.push_back({.group = "x1", .axes = {true, true, true}, .hinge = false, .where = {}});
  strips.scene.bodies[1].prestress.emplace().temperature = -100;
  return strips;
}

/// A strip of a material with a loss factor, colder than its ends, which are held. A soft spring ties it to a block
/// that its own cold deforms.
/// @param temperature  of the strip, K
Assembly taut_strip_beside_block(double temperature) {
  Assembly bodies;
  bodies.scene.materials[0].expansion = 1.2e-5;
  bodies.scene.materials[0].damping.loss.emplace().value = 0.05;
  bodies.add(support::block_mesh(element::hex(4, 2), {0.28, 0.01, 0.001}, {8, 1, 1}), Vector3::Zero());
  bodies.add(support::block_mesh(element::hex(2, 2), {0.02, 0.01, 0.01}, {2, 1, 1}), {0.14, 0.03, 0});
  bodies.join("rim", "x0", scene::JointStiffness{100, 100});
  bodies.scene.joints[0].type = scene::JointType::spring;
  for (const char* end : {"x0", "x1"}) {
    bodies.scene.bodies[0].fixed.push_back({.group = end, .axes = {true, true, true}, .hinge = false, .where = {}});
  }
  bodies.scene.bodies[1].fixed.push_back({.group = "x1", .axes = {true, true, true}, .hinge = false, .where = {}});
  bodies.scene.bodies[0].prestress.emplace().temperature = temperature;
  bodies.scene.bodies[1].prestress.emplace().temperature = -1;
  return bodies;
}

scene::ModalModel lowest(int count) {
  return {.up_to = {}, .count = count, .where = {"deck.yaml", 3, 5}};
}

void make_modal(Assembly& assembly, std::size_t body, int count) {
  assembly.scene.bodies[body].modal = lowest(count);
}

/// @param joined  whether the bodies get the further modes of joined bodies
modal_bodies::ModalBases bases_of(const Assembly& assembly, bool joined = true) {
  const auto motions = joined_motions(assembly.scene, assembly.meshes);
  modal_bodies::ModalBases bases;
  for (const auto& [body, motion] : motions) {
    bases[body] = modal_basis(assembly.scene, body, assembly.meshes[body], {}, joined ? &motion : nullptr);
  }
  return bases;
}

Eigen::Index rigid_motions_of(const modal_bodies::ModalBasis& basis) {
  return basis.is_free ? 6 : 0;
}

/// What the coordinates of a body do at its nodes, kg^-1/2: six rigid motions of unit mass where it is free, then the
/// modes. [3 x nodes, 6 + modes]
Eigen::MatrixXd all_shapes(const modal_bodies::ModalBasis& basis, const mesh::Mesh& mesh) {
  const auto rows = static_cast<Eigen::Index>(3 * basis.nodes());
  const auto modes = Eigen::MatrixXd::Map(basis.shapes.data(), rows, static_cast<Eigen::Index>(basis.modes()));
  if (!basis.is_free) {
    return modes;
  }
  Eigen::MatrixXd rigid(rows, 6);
  Eigen::VectorXd masses(rows);
  for (std::size_t node = 0; node < basis.nodes(); ++node) {
    const auto row = static_cast<Eigen::Index>(3 * node);
    masses.segment<3>(row).setConstant(basis.masses[node]);
    for (int axis = 0; axis < 3; ++axis) {
      rigid.block<3, 1>(row, axis) = Vector3::Unit(axis);
      rigid.block<3, 1>(row, 3 + axis) = Vector3::Unit(axis).cross(mesh.nodes[node]);
    }
  }
  const Eigen::MatrixXd gram = rigid.transpose() * masses.asDiagonal() * rigid;
  Eigen::MatrixXd shapes(rows, 6 + static_cast<Eigen::Index>(basis.modes()));
  shapes << rigid * dense::inverse_root(gram), modes;
  return shapes;
}

/// Modal bodies that joints tie together, in the coordinates of their rigid motions and modes.
struct ReducedAssembly {
  Eigen::MatrixXd stiffness;  ///< 1/s2, of unit mass
  Eigen::MatrixXd damping;    ///< 1/s
};

/// @param bases  of all bodies
ReducedAssembly reduced(const Assembly& assembly, const modal_bodies::ModalBases& bases) {
  const motion::Attachments attachments = motion::attach(assembly.scene, assembly.meshes);
  const mesh::Part part = mesh::distribute(assembly.meshes, MPI_COMM_SELF);
  Eigen::Index size = 0;
  for (const auto& [body, basis] : bases) {
    size += rigid_motions_of(basis) + static_cast<Eigen::Index>(basis.modes());
  }
  Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero(3 * std::ssize(part.node_ids), size);
  ReducedAssembly result{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size)};
  Eigen::Index column = 0;
  std::vector<solid::NodeState> rest(part.node_ids.size());
  const auto add_stress = [&](const modal_bodies::ModalBasis& basis, Eigen::Index first) {
    const auto modes = std::ssize(basis.rest_force);
    result.stiffness.block(first, first, modes, modes) +=
        Eigen::MatrixXd::Map(basis.rest_stiffness.data(), modes, modes);
  };
  for (const auto& [body, basis] : bases) {
    const Eigen::MatrixXd own = all_shapes(basis, assembly.meshes[body]);
    shapes.block(3 * Eigen::Index{part.bodies[body].owned_begin}, column, own.rows(), own.cols()) = own;
    for (std::size_t c = 0; c < basis.rest.size(); ++c) {
      rest[part.bodies[body].owned_begin + c / 3].displacement[c % 3] = basis.rest[c];
    }
    column += rigid_motions_of(basis);
    add_stress(basis, column);
    for (std::size_t mode = 0; mode < basis.modes(); ++mode, ++column) {
      result.stiffness(column, column) += basis.frequencies[mode] * basis.frequencies[mode];
      result.damping(column, column) = 2 * basis.decay_rates[mode];
    }
  }
  const joints::Joints joints(attachments.joints, part);
  const auto add = [&](std::span<const Index> nodes, const Eigen::MatrixXd& matrix) {
    Eigen::MatrixXd here(matrix.rows(), shapes.cols());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      here.middleRows<3>(3 * static_cast<Eigen::Index>(a)) = shapes.middleRows<3>(3 * Eigen::Index{nodes[a]});
    }
    const Eigen::MatrixXd added = here.transpose() * matrix * here;
    result.stiffness += added;
    result.damping += attachments.joints[0].damping * added;
  };
  for (std::size_t joint = 0; joint < attachments.joints.size(); ++joint) {
    joints.for_each_stiffness(joint, rest, add);
  }
  return result;
}

/// The largest difference of the five lowest modes of modal bodies from those of their finite elements.
struct LargestError {
  double cents = 0.0;
  double damping = 0.0;  ///< parts of the damping ratio, which must be small
};

/// @param model   of all bodies
/// @param joined  whether the bodies get the further modes of joined bodies
LargestError largest_error(Assembly assembly, const scene::ModalModel& model, bool joined = true) {
  for (scene::Body& body : assembly.scene.bodies) {
    body.modal = model;
  }
  const Modes expected = assembly.find(5);
  const modal_bodies::ModalBases bases = bases_of(assembly, joined);
  const auto [stiffness, damping] = reduced(assembly, bases);
  const auto [squares, vectors] = dense::eigenpairs(stiffness);
  LargestError largest;
  for (Eigen::Index mode = 0; mode < std::ssize(expected.modes); ++mode) {
    const Mode& right = expected.modes[mode];
    const double frequency = std::sqrt(squares[expected.rigid_motions + mode]);
    const double ratio = frequency / (2 * std::numbers::pi * right.frequency);
    largest.cents = std::max(largest.cents, std::abs(1200 * std::log2(ratio)));
    const Eigen::VectorXd shape = vectors.col(expected.rigid_motions + mode);
    const double zeta = shape.dot(damping * shape) / (2 * frequency);
    largest.damping = std::max(largest.damping, std::abs(zeta / right.damping_ratio - 1));
  }
  return largest;
}

ON_RANKS(1);

TEST(JoinedModalBodies, HaveTheFrequenciesOfTheirFiniteElements) {
  EXPECT_LT(largest_error(cut_bar(std::nullopt), lowest(4)).cents, 1e-3);
  EXPECT_LT(largest_error(cut_bar(scene::JointStiffness{1e13, 4e12}), lowest(4)).cents, 1e-3);
  EXPECT_GT(largest_error(cut_bar(std::nullopt), lowest(4), false).cents, 100.0);  // free modes alone are too stiff
}

TEST(JoinedModalBodies, HaveTheFrequenciesAboutTheRestUnderAPrestress) {
  Assembly slack = taut_strips(std::nullopt);
  slack.scene.bodies[1].prestress.reset();
  const Assembly taut = taut_strips(std::nullopt);
  EXPECT_GT(taut.find(1).modes[0].frequency, 1.5 * slack.find(1).modes[0].frequency);
  EXPECT_LT(largest_error(taut, lowest(4)).cents, 1e-2);
  EXPECT_LT(largest_error(taut_strips(scene::JointStiffness{1e12, 4e11}), lowest(4)).cents, 1e-2);
}

TEST(JoinedModalBodies, AboutARestAreDampedByALossFactorAsTheirFiniteElements) {
  const Assembly slack = taut_strip_beside_block(0);
  EXPECT_GT(taut_strip_beside_block(-100).find(1).modes[0].frequency, 4 * slack.find(1).modes[0].frequency);
  const LargestError error = largest_error(taut_strip_beside_block(-100), lowest(8));
  EXPECT_LT(error.cents, 2.0);
  EXPECT_LT(error.damping, 0.45);
}

TEST(JoinedModalBodies, HaveTheDampingOfTheirFiniteElements) {
  Assembly bar = cut_bar(scene::JointStiffness{1e13, 4e12}, 1e-6);
  bar.scene.materials[0].damping.stiffness = 1e-8;
  EXPECT_LT(largest_error(bar, lowest(4)).damping, 1e-4);
}

TEST(JoinedModalBodies, HaveAllModesUpToAFrequency) {
  const Assembly bar = cut_bar(scene::JointStiffness{1e13, 4e12});
  const double up_to = 9000.0;  // both halves have a mode below
  EXPECT_LT(bar.find(5).modes[4].frequency, up_to);
  EXPECT_LT(largest_error(bar, {.up_to = up_to, .count = {}, .where = {}}).cents, 1e-3);
}

TEST(JoinedModalBodies, KnowAJointWithinOneBody) {
  const Assembly bow = strung_bow();
  Assembly loose = bow;
  loose.scene.joints.clear();
  const double rise = bow.find(1).modes[0].frequency / loose.find(1).modes[0].frequency;
  EXPECT_GT(rise, 1.1);
  EXPECT_LT(largest_error(bow, lowest(5)).cents, 1e-3);
  EXPECT_LT(largest_error(bolted_bar(), lowest(5)).cents, 1e-3);
}

TEST(JoinedModalBodies, KeepTheResidualFrequencyOfTheirModel) {
  Assembly bar = cut_bar(scene::JointStiffness{4e13, 1.6e13});
  make_modal(bar, 0, 2);
  make_modal(bar, 1, 2);
  for (const auto& [body, basis] : bases_of(bar)) {
    EXPECT_EQ(basis.further + 2, basis.modes());
    EXPECT_GT(basis.further, 0U);
    EXPECT_EQ(residual_frequency(basis), 2 * std::max(basis.frequencies[1], 2 * std::numbers::pi * 20000.0));
  }
}

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
