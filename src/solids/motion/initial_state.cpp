#include "idiophone/solids/motion/initial_state.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/solids/motion/prestress_balance.hpp"
#include "static_equilibrium.hpp"

namespace idiophone::motion {

double InitialState::stable_step() const {
  return std::ranges::min_element(steps, {}, &StableStep::step)->step;
}

double InitialState::highest_loss() const {
  return std::ranges::max_element(steps, {}, &StableStep::highest_loss)->highest_loss;
}

namespace {

/// The part of the surface that belongs to each node. [owned nodes] m2
std::vector<double> surface_areas(const mesh::Part& whole) {
  std::vector<Vector3> places;
  std::ranges::transform(whole.vertices, std::back_inserter(places), [&](Index node) { return whole.reference[node]; });
  const std::vector<double> of_vertices = mesh::nodal_areas(whole.surface, places);
  std::vector<double> areas(whole.owned_nodes);
  for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
    areas[whole.vertices[vertex]] = of_vertices[vertex];
  }
  return areas;
}

/// Of one body, see InitialState.
double surface_density(std::span<const double> masses, std::span<const double> areas) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node < masses.size(); ++node) {
    least = std::min(least, masses[node] / areas[node]);  // infinite inside the body
  }
  return least;
}

/// @param for_each_node  calls a visitor with the mass, kg, and the place, m, of each node
template <class Nodes>
Piece piece_of(std::size_t body, const Nodes& for_each_node) {
  double mass = 0.0;
  Vector3 first_moment = Vector3::Zero();
  for_each_node([&](double share, const Vector3& place) {
    mass += share;
    first_moment += share * place;
  });
  const Vector3 centre = first_moment / mass;
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
  for_each_node([&](double share, const Vector3& place) {
    second_moment += share * (place - centre) * (place - centre).transpose();
  });
  return {body, mass, centre, second_moment};
}

}  // namespace

InitialState mass_properties(const Dynamics& dynamics, const mesh::Part& whole) {
  InitialState initial_state;
  const std::vector<double> areas = surface_areas(whole);
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    const std::span<const double> masses = dynamics.model(b).masses();
    initial_state.surface_densities.push_back(
        surface_density(masses, std::span(areas).subspan(whole.bodies[b].owned_begin, masses.size())));
    const auto nodes_of = [&](auto is_part) {
      return [&masses, &whole, first = whole.bodies[b].owned_begin, is_part](auto visit) {
        for (std::size_t node = 0; node < masses.size(); ++node) {
          if (is_part(first + node)) {
            visit(masses[node], whole.reference[first + node]);
          }
        }
      };
    };
    const Piece all = piece_of(b, nodes_of([](std::size_t /*node*/) { return true; }));
    initial_state.masses.push_back(all.mass);
    initial_state.centres.push_back(all.centre);
    initial_state.moments.push_back(all.moments);
    for (Index piece = whole.first_piece[b]; piece < whole.first_piece[b + 1]; ++piece) {
      initial_state.pieces.push_back(
          piece_of(b, nodes_of([&](std::size_t node) { return whole.pieces[node] == piece; })));
    }
  }
  return initial_state;
}

namespace {

/// @param steps  stable steps with scaling
std::vector<ScalingEffect> scaling_effects(const scene::Solids& solids, const mesh::Part& whole,
                                           const Attachments& attachments, const FiniteElementDynamics& dynamics,
                                           const std::vector<StableStep>& steps) {
  std::vector<ScalingEffect> effects(steps.size());
  if (std::ranges::none_of(solids.bodies, [](const scene::Body& body) { return body.mass_scaling.has_value(); })) {
    return effects;
  }
  const std::vector<StableStep> without =
      find_stable_steps(whole, FiniteElementDynamics(solids, whole, attachments, MassScaling::none));
  for (std::size_t b = 0; b < steps.size(); ++b) {
    effects[b].gain = steps[b].is_limited() ? steps[b].step / without[b].step : 1.0;
    effects[b].shift = dynamics.predicted_shift(b);
  }
  return effects;
}

}  // namespace

InitialState find_initial_state(const scene::Solids& solids, std::optional<double> step,
                                const std::vector<mesh::Mesh>& meshes, const Attachments& attachments,
                                contact::ContactSurfaces& contact_surfaces, const ModelMaker& models) {
  const mesh::Part whole = mesh::distribute(meshes, MPI_COMM_SELF);
  const FiniteElementDynamics finite_elements(solids, whole, attachments);
  check_prestress(solids, whole, finite_elements, MPI_COMM_SELF);
  InitialState initial_state = mass_properties(finite_elements, whole);
  initial_state.steps = find_stable_steps(whole, finite_elements);
  initial_state.scaling = scaling_effects(solids, whole, attachments, finite_elements, initial_state.steps);
  const double largest =
      std::ranges::max_element(initial_state.steps, {}, &StableStep::largest_frequency)->largest_frequency;
  const Supports supports = supports_of(whole, finite_elements);
  InverseMasses inverse_masses;
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    const auto model = models(whole, b);
    if (model) {
      initial_state.steps[b] = model->stable_step(supports);
    }
    const std::vector<double> mesh = finite_elements.model(b).inverse_masses();
    inverse_masses.add(mesh, model ? model->inverse_masses() : mesh);
  }
  stiffen_by_contact(solids, step, inverse_masses, largest, contact_surfaces, initial_state.steps);
  initial_state.displacement = static_equilibrium(solids, whole, attachments, finite_elements);
  return initial_state;
}

InitialState broadcast(InitialState initial_state, MPI_Comm communicator) {
  parallel::broadcast(initial_state.steps, communicator);
  parallel::broadcast(initial_state.scaling, communicator);
  parallel::broadcast(initial_state.masses, communicator);
  parallel::broadcast(initial_state.centres, communicator);
  parallel::broadcast(initial_state.moments, communicator);
  parallel::broadcast(initial_state.pieces, communicator);
  parallel::broadcast(initial_state.surface_densities, communicator);
  parallel::broadcast(initial_state.displacement, communicator);
  return initial_state;
}

}  // namespace idiophone::motion
