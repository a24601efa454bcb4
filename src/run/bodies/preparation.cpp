#include "idiophone/run/bodies/preparation.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "idiophone/air/propagation/placement.hpp"
#include "idiophone/air/surface/sampling.hpp"
#include "idiophone/air/surface/spread_radii.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/bodies/reading_in_parts.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/contact/outline.hpp"
#include "modal_preparation.hpp"
#include "preparation_report.hpp"
#include "root_elements.hpp"
#include "steps.hpp"

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

/// Finds everything but the meshes. Collective.
/// @param ready       with the scene and the offsets, and the statistics where bodies move by their modes
/// @param meshes      on rank 0; with nodes_of_root_elements() alone where they are read in parts
/// @param distribute  gives this rank its part, and rank 0 the statistics if there are none yet. Collective.
template <class Distribute>
Preparation complete(Preparation ready, const std::vector<mesh::Mesh>& meshes, const Distribute& distribute,
                     MPI_Comm communicator) {
  parallel::on_root(communicator, [&] {
    for (const mesh::Mesh& mesh : meshes) {
      ready.mesh_hash += mesh.hash;
    }
    ready.attachments = motion::attach(ready.scene, meshes);
    ready.contact_surfaces = contact::find_contact_surfaces(ready.scene, meshes);
    check_placement(ready, meshes);
    ready.modal_bases = find_modal_bases(ready, meshes);
  });
  ready.attachments = motion::broadcast(std::move(ready.attachments), ready.scene, communicator);
  ready.modal_bases = modal_bodies::broadcast(std::move(ready.modal_bases), communicator);
  parallel::broadcast(ready.mesh_hash, communicator);
  distribute(ready);
  modal_bodies::move_shapes(ready.modal_bases, ready.part, communicator);
  ready.initial_state =
      motion::find_initial_state(ready.scene, own_step(ready.scene), meshes, ready.part, ready.attachments,
                                 ready.contact_surfaces, ready.models(), communicator);
  ready.contact_surfaces = contact::broadcast(std::move(ready.contact_surfaces), communicator);
  parallel::on_root(communicator, [&] { ready.steps_per_sample = find_steps_per_sample(ready); });
  parallel::broadcast(ready.steps_per_sample, communicator);
  if (ready.scene.radiation.needs_radii()) {
    ready.radii = find_radii(ready, meshes, communicator);
  }
  // Modal bodies hardly move above their highest mode, so they are read half as often. Those with joints have further
  // modes above it.
  const bool modal = ready.modal_bases.size() == ready.scene.bodies.size() && ready.scene.joints.empty();
  ready.steps_per_read = surface::choose_steps_per_read(ready.steps_per_sample, ready.scene.audio.rate,
                                                        ready.scene.audio.max_frequency / (modal ? 2 : 1));
  if (parallel::is_root(communicator)) {
    report(ready);
  }
  return ready;
}

/// One rank has all bodies of common modes.
void keep_together(const scene::Solids& solids, std::vector<mesh::Mesh>& meshes) {
  for (const std::vector<std::size_t>& bodies : scene::assemblies(solids)) {
    for (const std::size_t body : bodies) {
      if (body != bodies.front() && scene::has_common_modes(solids, body)) {
        meshes[body].beside = bodies.front();
      }
    }
  }
}

}  // namespace

std::vector<mesh::Mesh> read_meshes(const scene::Solids& solids, MPI_Comm communicator) {
  std::vector<mesh::Mesh> meshes;
  parallel::on_root(communicator, [&] {
    meshes = mesh::read_meshes(solids.bodies);
    keep_together(solids, meshes);
    for (std::size_t body = 0; body < meshes.size(); ++body) {
      for (const auto& note : meshes[body].notes) {
        spdlog::warn("body {}: {}", solids.bodies[body].name, note);
      }
    }
  });
  return meshes;
}

PreparedMeshes prepare_with_meshes(scene::Scene scene, MPI_Comm communicator, ReadRows rows) {
  if (!reads_in_parts(scene, communicator)) {
    std::vector<mesh::Mesh> meshes = read_meshes(scene, communicator);
    Preparation ready = prepare(std::move(scene), meshes, communicator);
    return {std::move(ready), std::move(meshes), {}};
  }
  if (parallel::is_root(communicator)) {
    spdlog::info("each rank reads its part of the meshes");
  }
  Preparation ready;
  ready.scene = std::move(scene);
  mesh::MeshShares shares = mesh::read_shares(ready.scene.bodies, communicator);
  ready.offsets = shares.offsets;
  std::vector<std::vector<Index>> nodes;
  parallel::on_root(communicator, [&] { nodes = nodes_of_root_elements(ready.scene, shares.outlines); });
  mesh::give_root_elements(ready.scene.bodies, shares, std::move(nodes), communicator);
  std::vector<mesh::ElementRows> kept = rows == ReadRows::keep ? shares.rows : std::vector<mesh::ElementRows>();
  const auto distribute = [&](Preparation& to) {
    mesh::ReadPart read = mesh::read_part(to.scene.bodies, shares, motion::coupled_nodes(to.attachments), communicator);
    to.part = std::move(read.part);
    to.statistics = std::move(read.statistics);
  };
  ready = complete(std::move(ready), shares.outlines, distribute, communicator);
  for (mesh::Mesh& outline : shares.outlines) {
    outline.elements = std::vector<Index>();  // frees its memory, which {} does not
    outline.regions = std::vector<Index>();
  }
  return {std::move(ready), std::move(shares.outlines), std::move(kept)};
}

Preparation prepare(scene::Scene scene, MPI_Comm communicator) {
  return prepare_with_meshes(std::move(scene), communicator).ready;
}

Preparation prepare(scene::Scene scene, const std::vector<mesh::Mesh>& whole, MPI_Comm communicator) {
  Preparation ready;
  ready.scene = std::move(scene);
  std::vector<mesh::Mesh> divided;
  parallel::on_root(communicator, [&] { divided = divide(ready.scene.bodies, whole); });
  const std::vector<mesh::Mesh>& meshes = divided.empty() ? whole : divided;
  parallel::on_root(communicator, [&] {
    std::ranges::transform(meshes, std::back_inserter(ready.statistics),
                           [](const mesh::Mesh& mesh) { return mesh::statistics(mesh); });
    ready.offsets = mesh::offsets(meshes);
  });
  for (auto* offsets : {&ready.offsets.nodes, &ready.offsets.elements, &ready.offsets.triangles}) {
    parallel::broadcast(*offsets, communicator);
  }
  const auto distribute = [&](Preparation& to) {
    to.part = mesh::distribute(meshes, communicator, motion::coupled_nodes(to.attachments));
  };
  return complete(std::move(ready), meshes, distribute, communicator);
}

}  // namespace idiophone::bodies
