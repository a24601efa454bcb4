#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/solid/inverted_element.hpp"
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

/// How many modes a quick estimate may have.
std::size_t quick_modes(const std::vector<mesh::Mesh>& meshes) {
  constexpr double most_entries = 4e8;  // about 2e-8 s for each entry of the matrix and each mode
  double entries = 0.0;
  for (const mesh::Mesh& mesh : meshes) {
    entries += mesh::refined_entries(mesh);
  }
  return static_cast<std::size_t>(most_entries / entries);
}

}  // namespace

std::vector<double> mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                                std::span<const std::vector<double>> shapes, const PartWatch& watch) {
  if (shapes.empty()) {
    return {};
  }
  const RefinedProblem problem(solids, meshes, mass, shapes.front());
  const std::vector<RefinedValue> values = refined_values(problem, shapes, watch);
  std::vector<double> errors;
  for (std::size_t mode = 0; mode < values.size(); ++mode) {
    const auto [interpolated, improved] = values[mode];
    errors.push_back(extrapolated(meshes.front().element, cents(problem.given_value(shapes[mode]), improved),
                                  cents(interpolated, improved)));
  }
  return errors;
}

std::vector<double> mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                                std::span<const std::vector<double>> shapes, Estimates wanted, const PartWatch& watch) {
  if (wanted == Estimates::none) {
    return {};
  }
  const std::size_t count = wanted == Estimates::all ? shapes.size() : std::min(shapes.size(), quick_modes(meshes));
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> none(shapes.size(), unknown);
  try {
    std::vector<double> errors = mesh_errors(solids, meshes, mass, shapes.first(count), watch);
    if (!errors.empty()) {
      errors.resize(shapes.size(), unknown);
    }
    return errors;
  } catch (const solid::InvertedElement&) {
    return none;
  } catch (const deck::DeckError&) {  // of the refined bodies: an estimate must not cost the modes
    return none;
  }
}

bool can_estimate(const scene::Solids& solids) {
  const auto is_glue = [](const scene::Joint& joint) { return joint.type == scene::JointType::glue; };
  const auto has_elements_of_first = [&](const scene::Body& body) {
    return element::name(body.element) == element::name(solids.bodies.front().element);
  };
  return std::ranges::all_of(solids.joints, is_glue) && std::ranges::all_of(solids.bodies, has_elements_of_first);
}

std::string left_out(std::span<const double> errors, std::size_t modes, Estimates wanted) {
  if (!errors.empty() && std::ranges::all_of(errors, [](double error) { return std::isnan(error); })) {
    return "the error of the mesh is not estimated: a strongly curved element turns inside out where it is divided, or "
           "on the divided elements the joined surfaces do not meet, or the bodies find no rest under their prestress. "
           "A finer mesh avoids that";
  }
  const auto estimated = std::ranges::count_if(errors, [](double error) { return !std::isnan(error); });
  if (wanted != Estimates::quick || estimated == static_cast<std::ptrdiff_t>(modes)) {
    return {};
  }
  return fmt::format("the error of the mesh is estimated for {} of {} modes, as more take long. --estimate does all",
                     estimated == 0 ? "none" : fmt::format("the lowest {}", estimated), modes);
}

}  // namespace idiophone::eigenmodes
