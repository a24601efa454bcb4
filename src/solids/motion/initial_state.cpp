#include "idiophone/solids/motion/initial_state.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include "body_rows.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/motion/prestress_balance.hpp"
#include "static_equilibrium.hpp"

namespace idiophone::motion {

double InitialState::stable_step() const {
  return steps[limiting_body()].step;
}

std::size_t InitialState::limiting_body() const {
  return static_cast<std::size_t>(std::ranges::min_element(steps, {}, &StableStep::step) - steps.begin());
}

double InitialState::highest_loss() const {
  return std::ranges::max_element(steps, {}, &StableStep::highest_loss)->highest_loss;
}

namespace {

/// All of a body.
struct WholeBody {
  std::size_t number = 0;
  std::span<const double> masses;   ///< [nodes] kg
  std::span<const Vector3> places;  ///< [nodes] m
  std::span<const double> areas;    ///< [nodes] the part of the surface that belongs to each, m2
  std::span<const Index> pieces;    ///< [nodes] that they belong to; empty where there is only one
  Index first_piece = 0;            ///< the number of the first of them
  Index piece_count = 0;
};

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

void add_mass_properties(const WholeBody& body, InitialState& initial_state) {
  const auto nodes_of = [&body](auto is_part) {
    return [&body, is_part](auto visit) {
      for (std::size_t node = 0; node < body.masses.size(); ++node) {
        if (is_part(node)) {
          visit(body.masses[node], body.places[node]);
        }
      }
    };
  };
  initial_state.surface_densities.push_back(surface_density(body.masses, body.areas));
  const Piece all = piece_of(body.number, nodes_of([](std::size_t /*node*/) { return true; }));
  initial_state.masses.push_back(all.mass);
  initial_state.centres.push_back(all.centre);
  initial_state.moments.push_back(all.moments);
  for (Index piece = body.first_piece; piece < body.first_piece + body.piece_count; ++piece) {
    initial_state.pieces.push_back(
        piece_of(body.number, nodes_of([&](std::size_t node) { return body.pieces[node] == piece; })));
  }
}

}  // namespace

InitialState mass_properties(const Dynamics& dynamics, const mesh::Part& whole) {
  InitialState initial_state;
  const std::vector<double> areas = surface_areas(whole);
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    const std::span<const double> masses = dynamics.model(b).masses();
    const std::size_t first = whole.bodies[b].owned_begin;
    const auto of_body = [&](const auto& of_nodes) {
      return of_nodes.empty() ? std::span(of_nodes) : std::span(of_nodes).subspan(first, masses.size());
    };
    add_mass_properties({.number = b,
                         .masses = masses,
                         .places = of_body(whole.reference),
                         .areas = of_body(areas),
                         .pieces = of_body(whole.pieces),
                         .first_piece = whole.first_piece[b],
                         .piece_count = whole.piece_count(b)},
                        initial_state);
  }
  return initial_state;
}

namespace {

/// The part of a body's nodes, whole on rank 0 and empty elsewhere. Collective.
/// @param own  [owned nodes of the body]
std::vector<double> gathered(const mesh::Part& part, std::size_t body, std::span<const double> own,
                             MPI_Comm communicator) {
  const BodyRows rows(part, part.bodies[body], 1, communicator);
  std::vector<double> whole(rows.size());
  rows.gather(own, whole);
  return whole;
}

/// mass_properties() on rank 0. Collective.
InitialState gathered_mass_properties(const Dynamics& dynamics, const std::vector<mesh::Mesh>& meshes,
                                      const mesh::Part& part, MPI_Comm communicator) {
  InitialState initial_state;
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const std::vector<double> masses = gathered(part, b, dynamics.model(b).masses(), communicator);
    if (parallel::is_root(communicator)) {
      const mesh::Mesh& mesh = meshes[b];
      add_mass_properties({.number = b,
                           .masses = masses,
                           .places = mesh.nodes,
                           .areas = mesh::nodal_areas(mesh.surface, mesh.nodes),
                           .pieces = mesh.pieces,
                           .piece_count = mesh.piece_count()},
                          initial_state);
    }
  }
  return initial_state;
}

/// Calls `work()`, which has no collective call, on every rank. Collective: returns or throws on every rank. What it
/// throws on rank 0 keeps its type there.
template <class Work>
void everywhere(MPI_Comm communicator, const Work& work) {
  std::exception_ptr failure;
  std::string problem;
  try {
    work();
  } catch (const std::exception& error) {
    failure = std::current_exception();
    problem = error.what();
  }
  parallel::share_failure(communicator, failure);
  parallel::agree(communicator, problem);
}

/// Collective.
/// @param steps  stable steps with scaling
std::vector<ScalingEffect> scaling_effects(const scene::Solids& solids, const mesh::Part& part,
                                           const Attachments& attachments, const FiniteElementDynamics& dynamics,
                                           const std::vector<StableStep>& steps, MPI_Comm communicator) {
  std::vector<ScalingEffect> effects(steps.size());
  if (std::ranges::none_of(solids.bodies, [](const scene::Body& body) { return body.mass_scaling.has_value(); })) {
    return effects;
  }
  const std::vector<StableStep> without =
      find_stable_steps(part, FiniteElementDynamics(solids, part, attachments, MassScaling::none), communicator);
  for (std::size_t b = 0; b < steps.size(); ++b) {
    effects[b].gain = steps[b].is_limited() ? steps[b].step / without[b].step : 1.0;
    effects[b].shift = parallel::largest(dynamics.predicted_shift(b), communicator);
  }
  return effects;
}

/// The steps of the bodies as they move.
/// @param models  [bodies] null for those of finite elements, which have their `steps` already. Collective.
std::vector<StableStep> steps_of_models(const mesh::Part& part, const FiniteElementDynamics& finite_elements,
                                        const std::vector<std::unique_ptr<BodyModel>>& models,
                                        const std::vector<StableStep>& steps, MPI_Comm communicator) {
  if (std::ranges::none_of(models, [](const auto& model) { return model != nullptr; })) {
    return steps;
  }
  const Supports supports = supports_of(part, finite_elements);
  return find_stable_steps(
      part,
      [&](std::size_t body, const BodyRanks& ranks) {
        return models[body] ? models[body]->stable_step(supports, ranks) : steps[body];
      },
      communicator);
}

/// Rank 0 has all of it.
std::vector<double> preload(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                            const Attachments& attachments) {
  const mesh::Part whole = mesh::distribute(meshes, MPI_COMM_SELF);
  return static_equilibrium(solids, whole, attachments, FiniteElementDynamics(solids, whole, attachments));
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

}  // namespace

InitialState find_initial_state(const scene::Solids& solids, std::optional<double> step,
                                const std::vector<mesh::Mesh>& meshes, const mesh::Part& part,
                                const Attachments& attachments, contact::ContactSurfaces& contact_surfaces,
                                const ModelMaker& models, MPI_Comm communicator) {
  std::optional<FiniteElementDynamics> finite_elements;
  everywhere(communicator, [&] { finite_elements.emplace(solids, part, attachments); });
  const std::vector<char> deformed = deformed_by_prestress(solids, part, *finite_elements, communicator);
  InitialState initial_state = gathered_mass_properties(*finite_elements, meshes, part, communicator);
  initial_state.steps = find_stable_steps(part, *finite_elements, communicator);
  initial_state.scaling =
      scaling_effects(solids, part, attachments, *finite_elements, initial_state.steps, communicator);
  const double largest =
      std::ranges::max_element(initial_state.steps, {}, &StableStep::largest_frequency)->largest_frequency;
  std::vector<std::unique_ptr<BodyModel>> its_models;
  InverseMasses inverse_masses;
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const auto& model = its_models.emplace_back(models(part, b));
    const std::vector<double> mesh = finite_elements->model(b).inverse_masses();
    inverse_masses.add(gathered(part, b, mesh, communicator),
                       gathered(part, b, model ? model->inverse_masses() : mesh, communicator));
  }
  initial_state.steps = steps_of_models(part, *finite_elements, its_models, initial_state.steps, communicator);
  finite_elements.reset();  // rank 0 may need the memory
  parallel::on_root(communicator, [&] {
    stiffen_by_contact(solids, step, inverse_masses, largest, contact_surfaces, initial_state.steps);
    if (!solids.plucks.empty() || std::ranges::count(deformed, 1) > 0) {
      initial_state.displacement = preload(solids, meshes, attachments);
    }
  });
  return broadcast(std::move(initial_state), communicator);
}

}  // namespace idiophone::motion
