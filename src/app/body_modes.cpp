#include "idiophone/app/body_modes.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <span>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "idiophone/solids/mesh/refined.hpp"

namespace idiophone::app {

namespace {

/// Whether to estimate what the mesh does to the frequencies; says so where it takes too much for not being asked for.
bool is_to_estimate(std::optional<bool> wish, const mesh::Mesh& mesh) {
  constexpr double most_nodes = 150e3;  // some minutes and a gigabyte
  const double nodes = mesh::refined_node_count(mesh);
  if (!wish && nodes > most_nodes) {
    spdlog::info(
        "no estimate of the mesh's error: it takes a refined mesh of about {:.0f} nodes, on one rank. Ask for it "
        "with --estimate",
        nodes);
  }
  return wish.value_or(nodes <= most_nodes);
}

}  // namespace

std::vector<std::vector<double>> whole_shapes(const eigenmodes::Modes& found, const mesh::Part& part,
                                              MPI_Comm communicator) {
  const std::span<const Index> own = std::span(part.node_ids).first(static_cast<std::size_t>(part.owned_nodes));
  const std::vector<Index> numbers = parallel::gather_all(own, communicator).values;
  std::vector<std::vector<double>> shapes;
  for (const eigenmodes::Mode& mode : found.modes) {
    const std::vector<double> values = parallel::gather_all(std::span<const double>(mode.shape), communicator).values;
    if (parallel::is_root(communicator)) {
      auto& shape = shapes.emplace_back(values.size());
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        std::copy_n(&values[3 * n], 3, &shape[3 * static_cast<std::size_t>(numbers[n])]);
      }
    }
  }
  return shapes;
}

BodyModes find_body_modes(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                          const eigenmodes::Options& options, MPI_Comm communicator) {
  BodyModes modes;
  motion::Attachments attachments;
  parallel::on_root(communicator, [&] {
    modes.offsets = mesh::offsets(meshes);
    attachments = motion::attach(solids, meshes);
  });
  attachments = motion::broadcast(std::move(attachments), solids, communicator);
  for (auto* each : {&modes.offsets.nodes, &modes.offsets.elements, &modes.offsets.triangles}) {
    parallel::broadcast(*each, communicator);
  }
  modes.part = mesh::distribute(meshes, communicator);
  modes.found = eigenmodes::find_modes(solids, modes.part, attachments, options, communicator);
  modes.shapes = whole_shapes(modes.found, modes.part, communicator);
  return modes;
}

std::vector<double> estimated_mesh_errors(std::optional<bool> wish, eigenmodes::MassMatrix mass,
                                          const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                          const std::vector<std::vector<double>>& shapes, MPI_Comm communicator) {
  std::vector<double> errors;
  parallel::on_root(communicator, [&] {
    if (is_to_estimate(wish, meshes.front())) {
      errors = eigenmodes::mesh_errors(solids, meshes.front(), mass, shapes);
    }
  });
  parallel::broadcast(errors, communicator);
  return errors;
}

}  // namespace idiophone::app
