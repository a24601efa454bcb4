#include "mode_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::app {

eigenmodes::FrequencyBounds take_bounds(BodyModes& known, int wanted, const scene::Solids& solids,
                                        const std::vector<mesh::Mesh>& meshes, MPI_Comm communicator) {
  eigenmodes::FrequencyBounds bounds;
  parallel::on_root(communicator,
                    [&] { bounds = eigenmodes::frequency_bounds(solids, meshes.front(), known.shapes, wanted); });
  parallel::broadcast(bounds.modes_below, communicator);
  parallel::broadcast(bounds.separation, communicator);
  parallel::broadcast(bounds.lower, communicator);
  parallel::broadcast(bounds.upper, communicator);
  known.found.modes.resize(wanted);
  known.shapes.resize(std::min<std::size_t>(wanted, known.shapes.size()));  // none where this is not rank 0
  return bounds;
}

std::string assumption(const eigenmodes::FrequencyBounds& bounds) {
  return fmt::format("the lower bounds assume that the solid has no more than {} modes below {:.6g} Hz",
                     bounds.modes_below, bounds.separation);
}

nlohmann::json bounds_facts(const eigenmodes::FrequencyBounds& bounds) {
  return {{"lower", bounds.lower},
          {"upper", bounds.upper},
          {"modes_below", bounds.modes_below},
          {"separation", bounds.separation}};
}

}  // namespace idiophone::app
