#include "idiophone/run/bodies/preparation.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <numbers>
#include <ranges>

#include "idiophone/air/propagation/placement.hpp"
#include "idiophone/air/surface/sampling.hpp"
#include "idiophone/air/surface/spread_radii.hpp"
#include "idiophone/air/waves/plan.hpp"
#include "idiophone/air/waves/surface_sources.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/accuracy/pitch_error.hpp"
#include "idiophone/solids/contact/outline.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/solid/relaxation.hpp"

namespace idiophone::bodies {

namespace {

/// Of this rank's triangles; the meshes are on rank 0. Collective.
std::vector<double> find_radii(const Preparation& ready, const std::vector<mesh::Mesh>& meshes, MPI_Comm communicator) {
  std::vector<std::size_t> inside;
  for (const auto& body : ready.attachments.bodies) {
    inside.push_back(mesh::triangle_count(body.fracture));
  }
  return surface::spread_radii(
      ready.part.triangle_ids, ready.offsets.triangles,
      [&](std::size_t body) {
        std::vector<std::array<Vector3, 3>> surface;
        if (!meshes.empty()) {
          const auto& nodes = meshes[body].nodes;
          for (const auto& [i, j, k] : meshes[body].surface) {
            surface.push_back({nodes[i], nodes[j], nodes[k]});
          }
        }
        parallel::broadcast(surface, communicator);
        return surface;
      },
      inside);
}

/// Nodes of a body that loads, supports or contacts may act on, ascending, in the mesh's numbers.
std::vector<Index> loaded_nodes(const Preparation& ready, std::size_t body) {
  const motion::Attachments& attachments = ready.attachments;
  std::vector<Index> nodes;
  const auto add = [&](const mesh::Patch& patch) { nodes.insert(nodes.end(), patch.nodes.begin(), patch.nodes.end()); };
  for (std::size_t p = 0; p < attachments.pulses.size(); ++p) {
    if (ready.scene.pulses[p].body == body) {
      add(attachments.pulses[p]);
    }
  }
  for (const auto& triangles : attachments.winds) {
    for (const Index node : std::views::join(triangles)) {
      if (node >= ready.offsets.nodes[body] && node < ready.offsets.nodes[body + 1]) {
        nodes.push_back(node);
      }
    }
  }
  std::ranges::for_each(attachments.bodies[body].supports, add);
  const contact::Skin& skin = ready.contact_surfaces.skins[body];
  for (std::size_t node = 0; node < skin.nodes.size(); ++node) {
    if (skin.areas[node] > 0) {
      nodes.push_back(skin.nodes[node]);
    }
  }
  keep_each_once(nodes);
  for (Index& node : nodes) {
    node -= ready.offsets.nodes[body];
  }
  return nodes;
}

/// @throws deck::DeckError where the highest mode's waves have less than two nodes to a length: the mesh does not have
///         them. Whether it has them in tune is what `check` says.
void require_fine_mesh(const Preparation& ready, std::size_t b) {
  const scene::Body& body = ready.scene.bodies[b];
  if (!body.modal->up_to) {
    return;
  }
  const accuracy::Cells cells = accuracy::cells_of(ready.statistics[b], body.element);
  const int order = element::orders(body.element).plane;
  const double wave = accuracy::bending_wavelength(
      ready.scene.materials[body.material], accuracy::extents(ready.statistics[b]).thickness, *body.modal->up_to);
  if (wave < 2 * cells.size / order) {
    throw deck::DeckError(
        body.modal->where,
        fmt::format("bodies.{}.model.up_to: waves of {:.6g} Hz are {:.3g} m long, and the nodes of the mesh {:.3g} m "
                    "apart. Make the elements smaller, or lower up_to",
                    body.name, *body.modal->up_to, wave, cells.size / order));
  }
}

/// Call where the meshes are.
modal_bodies::ModalBases find_bases(const Preparation& ready, const std::vector<mesh::Mesh>& meshes) {
  modal_bodies::ModalBases bases;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    if (ready.scene.bodies[b].modal) {
      require_fine_mesh(ready, b);
      bases[b] = eigenmodes::modal_basis(ready.scene, b, meshes[b], loaded_nodes(ready, b));
    }
  }
  return bases;
}

void report_modes(const modal_bodies::ModalBasis& basis) {
  constexpr double turn = 2 * std::numbers::pi;
  spdlog::info("  {}, {} modes from {:.5g} to {:.5g} Hz", basis.is_free ? "rigid motion" : "held", basis.modes(),
               basis.frequencies.front() / turn, basis.frequencies.back() / turn);
}

/// Least mass of the bodies' surface nodes over their areas, kg/m2.
double lightest_surface(const Preparation& ready) {
  return std::ranges::min(ready.initial_state.surface_densities);
}

/// The largest stable step of bodies that feel the resistance of the air, s: dt/stable + r dt/(2 m) <= 1 suffices for
/// an oscillator with the stable step `stable` and one more dashpot r, since w^2 dt^2/4 + c dt/2 <= dt/stable.
double stable_step_in_air(const Preparation& ready) {
  const scene::AirProperties& air = ready.scene.radiation.air;
  const double resistance = air.impedance() * waves::largest_resistance(waves::courant_of(
                                                  air.speed, ready.scene.radiation.grid.cell, ready.scene.audio.rate));
  return 1.0 / (1.0 / ready.initial_state.stable_step() + resistance / (2.0 * lightest_surface(ready)));
}

void report(const Preparation& ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& body = ready.scene.bodies[b];
    const auto& mesh = ready.statistics[b];
    const auto& limit = ready.initial_state.steps[b];
    spdlog::info("body {}: {} nodes, {} {} elements, {} surface triangles, {:.6g} kg", body.name, mesh.nodes,
                 mesh.elements, element::name(body.element), mesh.triangles, ready.initial_state.masses[b]);
    if (const auto& loss = ready.scene.materials[body.material].damping.loss) {
      spdlog::info("  loss factor {:.4g} from {:.6g} to {:.6g} Hz by {} mechanisms", loss->value, loss->band[0],
                   loss->band[1], solid::fit_relaxation(*loss).mechanisms.size());
    }
    if (const auto basis = ready.modal_bases.find(b); basis != ready.modal_bases.end()) {
      report_modes(basis->second);
      continue;
    }
    if (!limit.is_limited()) {
      spdlog::info("  held everywhere: it keeps its shape and does not limit the step");
      continue;
    }
    spdlog::info(
        "  largest eigenfrequency {:.5g} Hz allows steps of {:.4g} s; element {} at ({:.4g}, {:.4g}, {:.4g}) limits it",
        limit.largest_frequency / (2 * std::numbers::pi), limit.step, limit.element - ready.offsets.elements[b],
        limit.centre[0], limit.centre[1], limit.centre[2]);
    if (!body.fracture.empty()) {
      spdlog::info("  can break along {} faces", ready.attachments.bodies[b].fracture.size());
    }
    if (body.mass_scaling) {
      const auto [gain, shift] = ready.initial_state.scaling[b];
      spdlog::info(
          "  mass scaling: steps {:.2f} times as long; it lowers no audible pitch by more than about {:.2g} cents",
          gain, shift);
    }
  }
  for (std::size_t c = 0; c < ready.scene.contacts.size(); ++c) {
    spdlog::info("contact {}: stiffness {:.4g} Pa/m", ready.scene.contacts[c].name,
                 ready.contact_surfaces.stiffness[c]);
  }
  if (ready.scene.radiation.grid.back) {
    spdlog::info("air acts on the bodies: their lightest surface, {:.3g} kg/m2, lowers the largest step to {:.4g} s",
                 lightest_surface(ready), stable_step_in_air(ready));
  }
  spdlog::info("step {:.4g} s: {} steps per audio sample, surface read every {}", ready.step(), ready.steps_per_sample,
               ready.steps_per_read);
}

/// The meshes with nodes of their own for all parts that may break off; empty where no body can break.
std::vector<mesh::Mesh> divide(const std::vector<scene::Body>& bodies, const std::vector<mesh::Mesh>& whole) {
  if (std::ranges::all_of(bodies, [](const scene::Body& body) { return body.fracture.empty(); })) {
    return {};
  }
  std::vector<mesh::Mesh> divided;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    divided.push_back(bodies[b].fracture.empty() ? whole[b] : mesh::divide(whole[b], bodies[b]));
  }
  return divided;
}

/// Of the meshes and the obstacles.
propagation::Surroundings surroundings(const Preparation& ready, const std::vector<mesh::Mesh>& meshes) {
  propagation::Surroundings around;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    around.add(ready.scene.bodies[b].name, meshes[b].nodes, meshes[b].outer_surface());
  }
  around.bodies = meshes.size();
  for (std::size_t o = 0; o < ready.scene.obstacles.size(); ++o) {
    around.add(ready.scene.obstacles[o].name, contact::outline(ready.contact_surfaces.shapes[o]));
  }
  return around;
}

/// @throws deck::DeckError where listeners or bodies are where they can't be
void check_placement(const Preparation& ready, const std::vector<mesh::Mesh>& meshes) {
  const auto hearing = propagation::hearing_of(ready.scene.radiation);
  for (const auto& warning : propagation::placement_warnings(ready.scene, surroundings(ready, meshes), hearing)) {
    spdlog::warn(warning);
  }
}

/// The step that the deck asks for, s.
std::optional<double> own_step(const scene::Scene& scene) {
  if (!scene.time.steps_per_sample) {
    return std::nullopt;
  }
  return 1.0 / (*scene.time.steps_per_sample * scene.audio.rate);
}

/// With fewer steps of the motion in one of the air, the air could give energy to the bodies (docs/method/waves.md).
constexpr int least_steps_in_one_of_air = 4;

/// m; see motion::choose_steps_per_sample.
int find_steps_per_sample(const Preparation& ready) {
  const scene::Scene& scene = ready.scene;
  if (!scene.radiation.grid.back) {
    return motion::choose_steps_per_sample(scene.time, scene.audio, ready.initial_state.stable_step(),
                                           ready.initial_state.highest_loss());
  }
  const int of_air = waves::steps_in_sample(scene.radiation.air.speed, scene.radiation.grid.cell, scene.audio.rate);
  const double longest = 1.0 / (static_cast<double>(least_steps_in_one_of_air) * of_air * scene.audio.rate);
  return motion::choose_steps_per_sample(scene.time, scene.audio, std::min(stable_step_in_air(ready), longest),
                                         ready.initial_state.highest_loss(), of_air);
}

}  // namespace

std::vector<mesh::Mesh> read_meshes(std::span<const scene::Body> bodies, MPI_Comm communicator) {
  std::vector<mesh::Mesh> meshes;
  parallel::on_root(communicator, [&] {
    meshes = mesh::read_meshes(bodies);
    for (std::size_t body = 0; body < meshes.size(); ++body) {
      for (const auto& note : meshes[body].notes) {
        spdlog::warn("body {}: {}", bodies[body].name, note);
      }
    }
  });
  return meshes;
}

Preparation prepare(scene::Scene scene, MPI_Comm communicator) {
  const std::vector<mesh::Mesh> meshes = read_meshes(scene.bodies, communicator);
  return prepare(std::move(scene), meshes, communicator);
}

Preparation prepare(scene::Scene scene, const std::vector<mesh::Mesh>& whole, MPI_Comm communicator) {
  Preparation ready;
  ready.scene = std::move(scene);
  std::vector<mesh::Mesh> divided;
  parallel::on_root(communicator, [&] { divided = divide(ready.scene.bodies, whole); });
  const std::vector<mesh::Mesh>& meshes = divided.empty() ? whole : divided;
  parallel::on_root(communicator, [&] {
    for (const mesh::Mesh& mesh : meshes) {
      ready.statistics.push_back(mesh::statistics(mesh));
      ready.mesh_hash += mesh.hash;
    }
    ready.offsets = mesh::offsets(meshes);
    ready.attachments = motion::attach(ready.scene, meshes);
    ready.contact_surfaces = contact::find_contact_surfaces(ready.scene, meshes);
    check_placement(ready, meshes);
    ready.modal_bases = find_bases(ready, meshes);
    ready.initial_state = motion::find_initial_state(ready.scene, own_step(ready.scene), meshes, ready.attachments,
                                                     ready.contact_surfaces, ready.models());
    ready.steps_per_sample = find_steps_per_sample(ready);
  });
  ready.attachments = motion::broadcast(std::move(ready.attachments), ready.scene, communicator);
  ready.contact_surfaces = contact::broadcast(std::move(ready.contact_surfaces), communicator);
  ready.modal_bases = modal_bodies::broadcast(std::move(ready.modal_bases), communicator);
  ready.initial_state = motion::broadcast(std::move(ready.initial_state), communicator);
  parallel::broadcast(ready.steps_per_sample, communicator);
  parallel::broadcast(ready.mesh_hash, communicator);
  for (auto* offsets : {&ready.offsets.nodes, &ready.offsets.elements, &ready.offsets.triangles}) {
    parallel::broadcast(*offsets, communicator);
  }
  ready.part = mesh::distribute(meshes, communicator);
  if (ready.scene.radiation.needs_radii()) {
    ready.radii = find_radii(ready, meshes, communicator);
  }
  // Modal bodies hardly move above their highest mode, so they are read half as often.
  const bool modal = ready.modal_bases.size() == ready.scene.bodies.size();
  ready.steps_per_read = surface::choose_steps_per_read(ready.steps_per_sample, ready.scene.audio.rate,
                                                        ready.scene.audio.max_frequency / (modal ? 2 : 1));
  if (parallel::is_root(communicator)) {
    report(ready);
  }
  return ready;
}

}  // namespace idiophone::bodies
