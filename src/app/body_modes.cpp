#include "idiophone/app/body_modes.hpp"

#include <spdlog/spdlog.h>

#include <string>
#include <utility>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/solids/eigenmodes/whole_shapes.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::app {

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
  modes.part = mesh::distribute(meshes, communicator, motion::coupled_nodes(attachments));
  modes.found = eigenmodes::find_modes(solids, modes.part, attachments, options, communicator);
  modes.shapes = eigenmodes::whole_shapes(modes.found, modes.part, communicator);
  return modes;
}

std::vector<double> estimated_mesh_errors(eigenmodes::Estimates wanted, eigenmodes::MassMatrix mass,
                                          const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                          const std::vector<std::vector<double>>& shapes, MPI_Comm communicator,
                                          const PartWatch& watch) {
  std::vector<double> errors;
  parallel::on_root(communicator, [&] {
    auto [cents, why_none] = eigenmodes::mesh_errors(solids, meshes, mass, shapes, wanted, watch);
    errors = std::move(cents);
    const std::string remark = eigenmodes::left_out(errors, shapes.size(), wanted, why_none);
    if (!remark.empty() && loop::noted_signal() == 0) {
      spdlog::info(remark);
    }
  });
  parallel::broadcast(errors, communicator);
  return errors;
}

}  // namespace idiophone::app
