#include "idiophone/solids/eigenmodes/frequency_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/solids/motion/dynamics.hpp"
#include "stress_problem.hpp"

namespace idiophone::eigenmodes {

namespace {

void check(const scene::Body& body, const mesh::Mesh& mesh) {
  const auto refuse = [&](const std::string& what) {
    throw std::runtime_error("--bounds can't be had for body '" + body.name + "': " + what);
  };
  if (!element::has_choice_of_orders(mesh.element)) {
    refuse("it consists of tetrahedra. Use 'element: hex'");
  }
  const auto [plane, thickness] = element::orders(mesh.element);
  if (std::max(plane, thickness) >= element::highest_hex_order) {
    refuse("stresses need an order above the highest. Use hexahedra of lower order");
  }
  if (!body.supports.empty()) {
    refuse("it stands on springs");
  }
  if (!body.fracture.empty()) {
    refuse("it has fracture surfaces");
  }
  if (!body.regions.empty()) {
    refuse("it consists of several materials, at whose borders stresses are not continuous");
  }
  if (body.prestress) {
    refuse("it is under tension");
  }
}

/// [3 x nodes] components that are held.
std::vector<bool> held_components(const motion::FiniteElementDynamics& dynamics, const mesh::Mesh& mesh) {
  std::vector<bool> held(3 * mesh.nodes.size());
  for (const Index component : dynamics.constraints().held_components()) {
    held[component] = true;
  }
  return held;
}

/// The best approximations within the span of given shapes, by Rayleigh and Ritz, with all integrals at the points of a
/// rule.
ElasticModes best_modes(const mesh::Mesh& mesh, const dense::Matrix6& stiffness, double density,
                        std::span<const std::vector<double>> shapes, const CubeRule& rule) {
  const auto count = static_cast<Eigen::Index>(shapes.size());
  ElasticModes modes{mesh, stiffness, density, Eigen::MatrixXd(3 * mesh.nodes.size(), count), {}};
  for (Eigen::Index i = 0; i < count; ++i) {
    modes.shapes.col(i) = Eigen::Map<const Eigen::VectorXd>(shapes[i].data(), modes.shapes.rows());
  }
  const ShapesAtPoints displacements(mesh.element, rule.points);
  Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd mass = energy;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const ElementPoints points = displacements.points_of(mesh, element, rule.weights);
    const ModeFields fields(displacements.on(points), mesh.element_nodes(element), modes.shapes);
    add_integral(points.weights, fields.strain, combined(stiffness, fields.strain), energy);
    add_integral(density * points.weights, fields.displacement, fields.displacement, mass);
  }
  const Eigen::MatrixXd root = dense::inverse_root(mass);
  const Eigen::MatrixXd projected = root * energy * root;
  const auto pairs = dense::eigenpairs(projected);
  modes.values = pairs.values;
  modes.shapes *= root * pairs.vectors;
  return modes;
}

/// How many modes lie below the widest gap above the wanted ones, relative to its upper end.
Eigen::Index modes_below_gap(const Eigen::VectorXd& values, int wanted) {
  Eigen::Index best = 0;
  const Eigen::Index gaps = values.size() - wanted;
  const Eigen::ArrayXd above = values.tail(gaps);
  (1 - values.segment(wanted - 1, gaps).array() / above).maxCoeff(&best);
  return wanted + best;
}

std::vector<double> frequencies(const Eigen::VectorXd& values, int count) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < count; ++i) {
    result.push_back(std::sqrt(values[i]) / (2 * std::numbers::pi));
  }
  return result;
}

}  // namespace

int modes_for_bounds(int wanted) {
  return wanted + std::max(6, wanted / 2);
}

FrequencyBounds frequency_bounds(const scene::Solids& solids, const mesh::Mesh& mesh,
                                 std::span<const std::vector<double>> shapes, int wanted) {
  check(solids.bodies.front(), mesh);
  const mesh::Part part = mesh::distribute({mesh}, MPI_COMM_SELF);
  const motion::FiniteElementDynamics dynamics(solids, part, motion::attach(solids, {mesh}));
  const StressSpace space(mesh, held_components(dynamics, mesh));
  const double density = solids.materials[solids.bodies.front().material].density;
  ElasticModes modes = best_modes(mesh, solid::stiffness_matrix(dynamics.solid(0).elasticity()), density, shapes,
                                  CubeRule(space.type()));
  const Eigen::Index below = modes_below_gap(modes.values, wanted);
  constexpr double within_gap = 0.75;  // near the mode above, and further from it than any mesh of use errs
  const double separation = modes.values[below - 1] + within_gap * (modes.values[below] - modes.values[below - 1]);
  modes.shapes.conservativeResize(Eigen::NoChange, below);
  modes.values.conservativeResize(below);
  const Eigen::VectorXd lower = lower_bounds(modes.values, least_defects(modes, space, separation), separation);
  return {.modes_below = static_cast<int>(below),
          .separation = std::sqrt(separation) / (2 * std::numbers::pi),
          .lower = frequencies(lower, wanted),
          .upper = frequencies(modes.values, wanted)};
}

}  // namespace idiophone::eigenmodes
