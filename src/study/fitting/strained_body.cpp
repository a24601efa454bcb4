#include "strained_body.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/foundation/element/type.hpp"
#include "idiophone/solids/accuracy/pitch_error.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "strain_products.hpp"

namespace idiophone::fitting {

namespace {

constexpr double largest_error = 100.0;  // cents; beyond, a mesh says nothing about a mode

/// Frequencies of all modes, Hz, with the mean for each mode of a multiplet.
std::vector<double> frequencies_by_mode(const FrequencyModel& model, const scene::Material& material) {
  const Eigen::VectorXd frequencies = model.frequencies(material);
  std::vector<double> all;
  for (std::size_t m = 0; m < model.multiplets().size(); ++m) {
    all.insert(all.end(), model.multiplets()[m].count, frequencies[static_cast<Eigen::Index>(m)]);
  }
  return all;
}

/// Of hexahedra one less along every direction that is above the lowest order.
element::Type one_order_less(element::Type type) {
  const auto [plane, thickness] = element::orders(type);
  return element::with_orders(type, {.plane = std::max(plane - 1, element::lowest_hex_order),
                                     .thickness = std::max(thickness - 1, element::lowest_hex_order)});
}

}  // namespace

StrainedBody::StrainedBody(const scene::Solids& solids, eigenmodes::MassMatrix mass)
    : body_(solids.bodies.front()),
      material_(solids.materials[body_.material]),
      max_frequency_(solids.max_frequency),
      mass_(mass) {
  body_.material = 0;
  const std::vector<mesh::Mesh> meshes = {mesh::read_mesh(body_)};
  statistics_ = mesh::statistics(meshes.front());
  attachments_ = motion::attach(alone(), meshes);
  part_ = mesh::distribute(meshes, MPI_COMM_SELF);
}

scene::Solids StrainedBody::alone() const {
  scene::Solids result;
  result.bodies = {&body_, 1};
  result.materials = {&material_, 1};
  result.max_frequency = max_frequency_;
  return result;
}

FrequencyModel StrainedBody::solve(const scene::Material& material, const eigenmodes::Options& options) {
  material_ = material;
  std::vector<StrainedMode> modes;
  for (const eigenmodes::Mode& mode :
       eigenmodes::find_modes(alone(), part_, attachments_, options, MPI_COMM_SELF).modes) {
    modes.push_back({mode.frequency, strain_products(part_, mode.shape)});
  }
  std::ranges::sort(modes, {}, &StrainedMode::frequency);  // a loss factor shifts each a little
  return {modes, material, body_.material_axes()};
}

FrequencyModel StrainedBody::model(const scene::Material& material, double up_to) {
  return solve(material, {.count = 1, .up_to = up_to, .mass = mass_});
}

FrequencyModel StrainedBody::lowest(const scene::Material& material, int count) {
  const auto room = static_cast<int>(part_.node_ids.size());  // a third of the components
  return solve(material, {.count = std::clamp(count, 1, std::max(1, room)), .mass = mass_});
}

std::vector<double> StrainedBody::mesh_errors(const FrequencyModel& model, const scene::Material& material) const {
  const element::Type coarser = one_order_less(body_.element);
  if (coarser == body_.element) {
    return errors_by_rule(model, material);
  }
  scene::Body body = body_;
  body.element = coarser;
  scene::Solids solids = alone();
  solids.bodies = {&body, 1};
  const std::vector<double> fine = frequencies_by_mode(model, material);
  StrainedBody less(solids, mass_);
  const std::vector<double> coarse =
      frequencies_by_mode(less.lowest(material, static_cast<int>(fine.size())), material);
  std::vector<double> errors;
  for (const Multiplet& multiplet : model.multiplets()) {
    constexpr double share = 0.15;
    const std::size_t mode = std::min(static_cast<std::size_t>(multiplet.first), coarse.size() - 1);
    errors.push_back(std::min(largest_error, share * std::abs(partials::cents(coarse[mode], fine[mode]))));
  }
  return errors;
}

std::vector<double> StrainedBody::errors_by_rule(const FrequencyModel& model, const scene::Material& material) const {
  const accuracy::Cells cells = accuracy::cells_of(statistics_, body_.element);
  const accuracy::Extents extents = accuracy::extents(statistics_);
  std::vector<double> errors;
  for (const double frequency : model.frequencies(material)) {
    errors.push_back(std::min(largest_error, accuracy::pitch_error(cells, extents, material, frequency)));
  }
  return errors;
}

}  // namespace idiophone::fitting
