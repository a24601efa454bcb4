// Modal bodies that joints tie together.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include "assembly.hpp"
#include "block_mesh.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/modal_bodies/modal_models.hpp"
#include "idiophone/solids/motion/body_motion.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/solids/motion/stable_step.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

/// A bar of 200 x 20 x 10 mm, cut at 80 mm and joined; meshes that do not match.
Assembly cut_bar(std::optional<scene::LayerStiffness> stiffness) {
  Assembly bar;
  bar.add(support::block_mesh(element::hex(4, 2), {0.08, 0.02, 0.01}, {2, 1, 1}), Vector3::Zero());
  bar.add(support::block_mesh(element::hex(4, 2), {0.12, 0.02, 0.01}, {3, 2, 1}), {0.08, 0, 0});
  bar.join("x1", "x0", stiffness);
  return bar;
}

void make_modal(Assembly& assembly, std::size_t body, int count) {
  assembly.scene.bodies[body].modal = scene::ModalModel{.up_to = {}, .count = count, .where = {"deck.yaml", 3, 5}};
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

/// What the coordinates of a free body do at its nodes, kg^-1/2: six rigid motions of unit mass, then the modes.
/// [3 x nodes, 6 + modes]
Eigen::MatrixXd all_shapes(const modal_bodies::ModalBasis& basis, const mesh::Mesh& mesh) {
  const auto rows = static_cast<Eigen::Index>(3 * basis.nodes());
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
  shapes << rigid * dense::inverse_root(gram),
      Eigen::MatrixXd::Map(basis.shapes.data(), rows, static_cast<Eigen::Index>(basis.modes()));
  return shapes;
}

/// The lowest frequencies of two free modal bodies with a joint between them, Hz.
Eigen::VectorXd frequencies_of(const Assembly& assembly, const modal_bodies::ModalBases& bases) {
  const motion::Attachments attachments = motion::attach(assembly.scene, assembly.meshes);
  const mesh::Part part = mesh::distribute(assembly.meshes, MPI_COMM_SELF);
  const Eigen::MatrixXd first = all_shapes(bases.at(0), assembly.meshes[0]);
  const Eigen::MatrixXd second = all_shapes(bases.at(1), assembly.meshes[1]);
  Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero(first.rows() + second.rows(), first.cols() + second.cols());
  shapes.topLeftCorner(first.rows(), first.cols()) = first;
  shapes.bottomRightCorner(second.rows(), second.cols()) = second;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(shapes.cols(), shapes.cols());
  Eigen::Index column = 0;
  for (const auto& [body, basis] : bases) {
    column += 6;
    for (const double frequency : basis.frequencies) {
      stiffness(column, column) = frequency * frequency;
      ++column;
    }
  }
  const joints::Joints joints(attachments.joints, part);
  joints.for_each_stiffness(0, [&](std::span<const Index> nodes, const Eigen::MatrixXd& matrix) {
    Eigen::MatrixXd here(matrix.rows(), shapes.cols());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      here.middleRows<3>(3 * static_cast<Eigen::Index>(a)) = shapes.middleRows<3>(3 * Eigen::Index{nodes[a]});
    }
    stiffness += here.transpose() * matrix * here;
  });
  const Eigen::VectorXd squares = dense::eigenpairs(stiffness).values;
  return squares.tail(squares.size() - 6).cwiseSqrt() / (2 * std::numbers::pi);
}

/// The largest difference of the five lowest frequencies of two modal halves from those of their finite elements,
/// cents.
double largest_error(std::optional<scene::LayerStiffness> stiffness, bool joined) {
  Assembly bar = cut_bar(stiffness);
  make_modal(bar, 0, 4);
  make_modal(bar, 1, 4);
  const Modes expected = bar.find(5);
  const Eigen::VectorXd found = frequencies_of(bar, bases_of(bar, joined));
  double largest = 0.0;
  for (std::size_t mode = 0; mode < expected.modes.size(); ++mode) {
    const double ratio = found[static_cast<Eigen::Index>(mode)] / expected.modes[mode].frequency;
    largest = std::max(largest, std::abs(1200 * std::log2(ratio)));
  }
  return largest;
}

ON_RANKS(1);

TEST(JoinedModalBodies, HaveTheFrequenciesOfTheirFiniteElements) {
  EXPECT_LT(largest_error(std::nullopt, true), 1e-3);
  EXPECT_LT(largest_error(scene::LayerStiffness{1e13, 4e12}, true), 1e-3);
  EXPECT_GT(largest_error(std::nullopt, false), 100.0);  // free modes alone are too stiff
}

/// The bar, glued, which a push on its first end sets into motion.
struct PushedBar {
  /// @param modal  the bodies that move by their modes
  explicit PushedBar(const std::vector<std::size_t>& modal) : bar(cut_bar(scene::LayerStiffness{4e13, 1.6e13})) {
    for (const std::size_t body : modal) {
      make_modal(bar, body, 6);
    }
    scene::ForcePulse pulse;
    pulse.force = {30, 20, 100};
    pulse.signal.duration = push;
    bar.scene.pulses = {pulse};
    bases = bases_of(bar);
    const auto& nodes = bar.meshes[0].groups.at("x0");
    scene::Scene joined = bar.scene;
    joined.pulses.clear();
    attachments = motion::attach(joined, bar.meshes);
    attachments.pulses = {{nodes, std::vector(nodes.size(), 1.0 / static_cast<double>(nodes.size()))}};
    part = mesh::distribute(bar.meshes, MPI_COMM_SELF);
    models = modal_bodies::modal_models(bar.scene, bases);
  }

  /// s
  [[nodiscard]] double stable_step() const {
    const motion::FiniteElementDynamics elements(bar.scene, part, attachments);
    const motion::Supports supports = motion::supports_of(part, elements);
    double step = 1.0;
    for (std::size_t body = 0; body < bar.scene.bodies.size(); ++body) {
      const auto model = models(part, body);
      step = std::min(step, (model ? *model : elements.model(body)).stable_step(supports).step);
    }
    return step;
  }

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

/// Where the end of the bar is at ten times in 1.5 ms, m.
std::vector<Vector3> path_of_end(const std::vector<std::size_t>& modal) {
  PushedBar bar(modal);
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
  const std::vector<Vector3> expected = path_of_end({});
  for (const std::vector<std::size_t>& modal : {std::vector<std::size_t>{0, 1}, {0}, {1}}) {
    const std::vector<Vector3> found = path_of_end(modal);
    double largest = 0.0, difference = 0.0;
    for (std::size_t place = 0; place < expected.size(); ++place) {
      largest = std::max(largest, expected[place].norm());
      difference = std::max(difference, (found[place] - expected[place]).norm());
    }
    EXPECT_LT(difference, 5e-4 * largest) << modal.size();
  }
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
