#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/solids/eigenmodes/spread_mesh_errors.hpp"
#include "idiophone/solids/joints/held_parts.hpp"
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

/// About how many entries springs, hinges and shanks have in the stiffness matrix of the refined meshes.
double refined_entries_of_joints(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  const joints::HeldParts held = joints::held_parts(solids, meshes);
  double entries = 0.0;
  for (std::size_t j = 0; j < held.size(); ++j) {
    double components = 0.0;
    for (const std::size_t side : {0, 1}) {
      const mesh::Mesh& mesh = meshes[solids.joints[j].surfaces.at(side).body];
      components += 3 * mesh::refined_nodes(mesh.element) * static_cast<double>(held[j].at(side).nodes(mesh).size());
    }
    entries += components * components;
  }
  return entries;
}

/// How many modes a quick estimate may have.
std::size_t quick_modes(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  constexpr double most_entries = 4e8;  // about 2e-8 s for each entry of the matrix and each mode
  double entries = refined_entries_of_joints(solids, meshes);
  for (const mesh::Mesh& mesh : meshes) {
    entries += mesh::refined_entries(mesh);
  }
  return static_cast<std::size_t>(most_entries / entries);
}

std::vector<std::size_t> first_numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The lowest and the highest mode, and others between them, so many or all.
std::vector<std::size_t> spread_numbers(std::size_t modes, std::size_t count) {
  std::vector<std::size_t> numbers = first_numbers(std::min(modes, count));
  const std::size_t gaps = std::max<std::size_t>(1, numbers.size()) - 1;
  for (std::size_t& number : numbers) {
    number = gaps == 0 ? number : number * (modes - 1) / gaps;
  }
  return numbers;
}

/// @return [chosen] as mesh_errors()
std::vector<double> errors_of(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                              std::span<const std::vector<double>> shapes, const std::vector<std::size_t>& chosen,
                              const PartWatch& watch) {
  if (chosen.empty()) {
    return {};
  }
  const RefinedProblem problem(solids, meshes, mass, shapes.front());
  const std::vector<RefinedValue> values = refined_values(problem, shapes, chosen, watch);
  std::vector<double> errors;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [interpolated, improved] = values[i];
    errors.push_back(extrapolated(meshes.front().element, cents(problem.given_value(shapes[chosen[i]]), improved),
                                  cents(interpolated, improved)));
  }
  return errors;
}

constexpr std::string_view turns_inside_out = "a strongly curved element turns inside out where it is divided";
constexpr std::string_view avoided_by = "A finer mesh avoids that";

/// @param chosen  the modes whose errors are estimated, ascending
MeshErrors estimates_of(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                        std::span<const std::vector<double>> shapes, const std::vector<std::size_t>& chosen,
                        const PartWatch& watch) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  try {
    const std::vector<double> of_chosen = errors_of(solids, meshes, mass, shapes, chosen, watch);
    std::vector<double> errors(of_chosen.empty() ? 0 : shapes.size(), unknown);
    for (std::size_t i = 0; i < of_chosen.size(); ++i) {
      errors[chosen[i]] = of_chosen[i];
    }
    return {std::move(errors), {}};
  } catch (const solid::InvertedElement&) {
    return {std::vector<double>(shapes.size(), unknown), fmt::format("{}. {}", turns_inside_out, avoided_by)};
  } catch (const deck::DeckError& error) {  // of the refined bodies: an estimate must not cost the modes
    return {std::vector<double>(shapes.size(), unknown), fmt::format("on the refined elements, {}", error.what())};
  }
}

}  // namespace

std::vector<double> mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                                std::span<const std::vector<double>> shapes, const PartWatch& watch) {
  return errors_of(solids, meshes, mass, shapes, first_numbers(shapes.size()), watch);
}

MeshErrors mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                       std::span<const std::vector<double>> shapes, Estimates wanted, const PartWatch& watch) {
  if (wanted == Estimates::none) {
    return {};
  }
  const std::size_t count =
      wanted == Estimates::all ? shapes.size() : std::min(shapes.size(), quick_modes(solids, meshes));
  return estimates_of(solids, meshes, mass, shapes, first_numbers(count), watch);
}

std::vector<double> spread_mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                       MassMatrix mass, std::span<const std::vector<double>> shapes) {
  constexpr std::size_t fewest = 4;
  const std::size_t quick = quick_modes(solids, meshes);
  std::vector<std::size_t> chosen;
  if (quick > 0) {
    chosen = spread_numbers(shapes.size(), std::max(fewest, quick));
  }
  std::vector<double> errors = estimates_of(solids, meshes, mass, shapes, chosen, {}).cents;
  errors.resize(shapes.size(), std::numeric_limits<double>::quiet_NaN());
  return errors;
}

std::string why_no_estimates(const scene::Solids& solids) {
  for (const scene::Joint& joint : solids.joints) {
    if (joint.type == scene::JointType::bolt && !joint.shank) {
      return fmt::format(
          "joints.{} is a bolt without a shank, whose washer covers another area of finer elements: "
          "compare with the modes of a finer mesh, or glue a surface as large as the washer",
          joint.name);
    }
  }
  const scene::Body& first = solids.bodies.front();
  for (const scene::Body& body : solids.bodies) {
    if (element::name(body.element) != element::name(first.element)) {
      return fmt::format("the elements of '{}' are {}, and those of '{}' {}: give all bodies elements of one kind",
                         first.name, element::name(first.element), body.name, element::name(body.element));
    }
  }
  return {};
}

std::string left_out(std::span<const double> errors, std::size_t modes, Estimates wanted, const std::string& why_none) {
  if (!errors.empty() && std::ranges::all_of(errors, [](double error) { return std::isnan(error); })) {
    return "the error of the mesh is not estimated: " +
           (why_none.empty()
                ? fmt::format("{}, or the body finds no rest under its prestress. {}", turns_inside_out, avoided_by)
                : why_none);
  }
  const auto estimated = std::ranges::count_if(errors, [](double error) { return !std::isnan(error); });
  if (wanted != Estimates::quick || estimated == static_cast<std::ptrdiff_t>(modes)) {
    return {};
  }
  return fmt::format("the error of the mesh is estimated for {} of {} modes, as more take long. --estimate does all",
                     estimated == 0 ? "none" : fmt::format("the lowest {}", estimated), modes);
}

}  // namespace idiophone::eigenmodes
