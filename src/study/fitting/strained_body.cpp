#include "strained_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "filled_errors.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/solids/accuracy/pitch_error.hpp"
#include "idiophone/solids/eigenmodes/spread_mesh_errors.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::fitting {

namespace {

constexpr double largest_error = 100.0;  // cents; beyond, a mesh says nothing about a mode

/// @throws deck::DeckError where it has several, or a prestress that its frequencies depend on besides
const scene::Body& of_one_material(const scene::Body& body) {
  if (body.prestress) {
    throw deck::DeckError(body.prestress->where,
                          fmt::format("the constants of a material are identified from bodies without stress, but body "
                                      "'{}' has a prestress",
                                      body.name));
  }
  if (!body.regions.empty()) {
    throw deck::DeckError(
        body.regions.front().where,
        fmt::format("the constants of one material can be identified, but body '{}' has {}: measure a "
                    "body of each material",
                    body.name, body.regions.size()));
  }
  return body;
}

}  // namespace

StrainedBody::StrainedBody(const scene::Solids& solids, eigenmodes::MassMatrix mass)
    : StrainedBody(of_one_material(solids.bodies.front()), solids.materials[solids.bodies.front().material],
                   solids.max_frequency, mass, mesh::read_mesh(solids.bodies.front())) {}

StrainedBody::StrainedBody(scene::Body body, scene::Material material, double max_frequency,
                           eigenmodes::MassMatrix mass, mesh::Mesh mesh)
    : body_(std::move(body)),
      grain_(body_.grain),
      material_(std::move(material)),
      max_frequency_(max_frequency),
      mass_(mass),
      statistics_(mesh::statistics(mesh)) {
  body_.material = 0;
  std::vector<mesh::Mesh> meshes = {std::move(mesh)};
  attachments_ = motion::attach(alone(), meshes);
  part_ = mesh::distribute(meshes, MPI_COMM_SELF);
  mesh_ = std::move(meshes.front());
}

StrainedBody StrainedBody::stretched(int side, double factor) const {
  const Vector3 axis = direction(side);
  const Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity() + (factor - 1) * axis * axis.transpose();
  scene::Body body = unturned();
  for (scene::Support& support : body.supports) {
    support.place.at = stretch * support.place.at;
  }
  mesh::Mesh mesh = mesh_;
  for (Vector3& node : mesh.nodes) {
    node = stretch * node;
  }
  mesh.hash.clear();  // it is another mesh
  StrainedBody result(std::move(body), material_, max_frequency_, mass_, std::move(mesh));
  result.is_stretched_ = true;
  return result;
}

std::optional<StrainedBody> StrainedBody::coarser() const {
  constexpr int least = 5;
  const auto [plane, thickness] = element::orders(body_.element);
  if (is_reduced_ || is_stretched_ || !element::has_choice_of_orders(body_.element) ||
      std::min(plane, thickness) < least) {
    return {};
  }
  scene::Body body = unturned();
  body.element = element::with_orders(body_.element, {plane - 1, thickness - 1});
  scene::Solids solids = alone();
  solids.bodies = {&body, 1};
  return std::optional<StrainedBody>(std::in_place, solids, mass_);
}

StrainedBody StrainedBody::reduced(int modes) const {
  StrainedBody result = *this;
  static_cast<void>(result.lowest(material_, modes));
  result.is_reduced_ = true;
  return result;
}

scene::Solids StrainedBody::alone() const {
  scene::Solids result;
  result.bodies = {&body_, 1};
  result.materials = {static_cast<const scene::Material*>(&material_), 1};
  result.max_frequency = max_frequency_;
  return result;
}

solid::StiffnessMatrix StrainedBody::stiffness_of(const TurnedMaterial& material) const {
  return solid::stiffness_matrix(solid::elasticity(material, axes() * material.turn()));
}

void StrainedBody::take(const TurnedMaterial& material) {
  material_ = material;
  body_.grain = grain_of(material);
}

scene::Body StrainedBody::unturned() const {
  scene::Body body = body_;
  body.grain = grain_;
  return body;
}

FrequencyModel StrainedBody::solve(const TurnedMaterial& material, const eigenmodes::Options& options) {
  if (is_reduced_) {
    return nearby(material);
  }
  take(material);
  stiffness_ = stiffness_of(material);
  std::vector<eigenmodes::Mode> found =
      eigenmodes::find_modes(alone(), part_, attachments_, options, MPI_COMM_SELF).modes;
  std::ranges::sort(found, {}, &eigenmodes::Mode::frequency);  // a loss factor shifts each a little
  shapes_.resize(static_cast<Eigen::Index>(found.front().shape.size()), static_cast<Eigen::Index>(found.size()));
  squares_.resize(shapes_.cols());
  for (std::size_t m = 0; m < found.size(); ++m) {
    const auto place = static_cast<Eigen::Index>(m);
    shapes_.col(place) = Eigen::VectorXd::Map(found[m].shape.data(), shapes_.rows());
    squares_[place] = std::pow(2 * std::numbers::pi * found[m].frequency, 2);
  }
  products_ = StrainProducts(part_, shapes_);
  return nearby(material);
}

/// Of the modes that were solved last. Supports are in the squares, so the change of the material is all that is added.
Eigen::MatrixXd StrainedBody::energies_of(const TurnedMaterial& material) const {
  Eigen::MatrixXd energies = products_.energies(stiffness_of(material) - stiffness_);
  energies.diagonal() += squares_;
  return energies;
}

Eigen::VectorXd StrainedBody::frequencies_nearby(const TurnedMaterial& material) const {
  const Eigen::VectorXd squares = dense::eigenpairs(energies_of(material)).values;
  return squares.cwiseMax(0).cwiseSqrt() / (2 * std::numbers::pi);
}

FrequencyModel StrainedBody::nearby(const TurnedMaterial& material) {
  take(material);
  auto [squares, factors] = dense::eigenpairs(energies_of(material));
  factors_ = std::move(factors);
  std::vector<StrainedMode> modes;
  for (Eigen::Index m = 0; m < squares.size(); ++m) {
    modes.push_back({std::sqrt(std::max(squares[m], 0.0)) / (2 * std::numbers::pi), products_.of(factors_.col(m))});
  }
  return {modes, material, axes()};
}

FrequencyModel StrainedBody::model(const TurnedMaterial& material, double up_to) {
  return solve(material, {.count = 1, .up_to = up_to, .mass = mass_});
}

FrequencyModel StrainedBody::lowest(const TurnedMaterial& material, int count) {
  const auto room = static_cast<int>(part_.node_ids.size());  // a third of the components
  return solve(material, {.count = std::clamp(count, 1, std::max(1, room)), .mass = mass_});
}

StrainedBody::Antinode StrainedBody::antinode(const Multiplet& multiplet) const {
  const Eigen::MatrixXd shapes = shapes_ * factors_.middleCols(multiplet.first, multiplet.count);
  const auto motions = [&](Index node) { return shapes.middleRows<3>(3 * static_cast<Eigen::Index>(node)); };
  double largest = 0.0;
  Index found = part_.vertices.front();
  for (const Index node : part_.vertices) {
    constexpr double more = 1e-6;  // of equal motions by symmetry, the first, whatever the solver's rounding
    if (motions(node).squaredNorm() > (1 + more) * largest) {
      largest = motions(node).squaredNorm();
      found = node;
    }
  }
  Eigen::Index mode = 0;
  motions(found).colwise().squaredNorm().maxCoeff(&mode);
  return {part_.reference[static_cast<std::size_t>(found)], motions(found).col(mode).normalized()};
}

std::vector<double> StrainedBody::mesh_errors(const FrequencyModel& model) const {
  if (is_reduced_) {
    return std::vector<double>(model.multiplets().size());
  }
  const Eigen::MatrixXd fields = shapes_ * factors_;
  std::vector<std::vector<double>> shapes;
  for (const auto& field : fields.colwise()) {
    shapes.emplace_back(field.begin(), field.end());
  }
  std::vector<double> estimates = eigenmodes::spread_mesh_errors(alone(), {mesh_}, mass_, shapes);
  std::ranges::transform(estimates, estimates.begin(), [](double cents) { return std::abs(cents); });
  estimates = filled_errors(std::move(estimates));
  const accuracy::Cells cells = accuracy::cells_of(statistics_, body_.element);
  const accuracy::Extents extents = accuracy::extents(statistics_);
  std::vector<double> errors;
  for (const Multiplet& multiplet : model.multiplets()) {
    const double estimate = Eigen::Map<const Eigen::VectorXd>(&estimates[multiplet.first], multiplet.count).mean();
    const double frequency = std::sqrt(multiplet.square) / (2 * std::numbers::pi);
    const double error = std::isnan(estimate) ? accuracy::pitch_error(cells, extents, material_, frequency) : estimate;
    errors.push_back(std::min(largest_error, error));
  }
  return errors;
}

}  // namespace idiophone::fitting
