#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

#include <cmath>

#include "refined_problem.hpp"
#include "refined_values.hpp"

namespace idiophone::eigenmodes {

namespace {

double cents(double value, double reference) {
  return 600 * std::log2(value / reference);  // of eigenvalues, the squares of frequencies
}

/// Adds what the refined mesh still errs to what a mode lost on it. The factors are those of docs/method/modes.md.
/// @param lost    from the given mesh with its mass to the refined one, cents
/// @param gained  on the refined mesh alone, by its finer elements, cents
double extrapolated(element::Type type, double lost, double gained) {
  switch (type.kind) {
    case element::Kind::tet4:
      return lost;
    case element::Kind::tet10: {
      const double second_order = lost + gained / 3;
      const double first_order = lost + gained;
      return std::abs(second_order) > std::abs(first_order) ? second_order : first_order;
    }
    case element::Kind::hex:
      return 2 * lost;
  }
  element::unknown_kind();
}

}  // namespace

std::vector<double> mesh_errors(const scene::Solids& solids, const mesh::Mesh& mesh, MassMatrix mass,
                                std::span<const std::vector<double>> shapes) {
  if (shapes.empty()) {
    return {};
  }
  const RefinedProblem problem(solids, mesh, mass, shapes.front());
  const std::vector<RefinedValue> values = refined_values(problem, shapes);
  std::vector<double> errors;
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    const auto [interpolated, improved] = values[mode];
    errors.push_back(
        extrapolated(mesh.element, cents(problem.given_value(shapes[mode]), improved), cents(interpolated, improved)));
  }
  return errors;
}

}  // namespace idiophone::eigenmodes
