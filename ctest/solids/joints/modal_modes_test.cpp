// Modes of modal bodies that joints tie together, against those of their finite elements.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/foundation/dense/dense.hpp"
#include "modal_assemblies.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

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

}  // namespace
}  // namespace idiophone::eigenmodes
