#include "idiophone/solids/modal_bodies/modal_models.hpp"

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/exchange.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "modal_body.hpp"

namespace idiophone::modal_bodies {

motion::ModelMaker modal_models(const scene::Solids& solids, const ModalBases& bases) {
  auto groups = std::make_shared<std::map<std::size_t, std::shared_ptr<CommonModes>>>();
  return [solids, &bases, groups](const mesh::Part& part, std::size_t body) -> std::unique_ptr<motion::BodyModel> {
    const auto basis = bases.find(body);
    if (basis == bases.end()) {
      return nullptr;
    }
    const std::size_t first = basis->second.common_with.value_or(body);
    std::shared_ptr<CommonModes>& group = (*groups)[first];
    if (first == body) {
      group = std::make_shared<CommonModes>(basis->second);
    }
    return std::make_unique<ModalBody>(solids.bodies[body].name, solids.gravity, part, body, basis->second, group);
  };
}

namespace {

void broadcast(ModalBasis& basis, MPI_Comm communicator) {
  constexpr std::size_t alone = -1;
  parallel::broadcast(basis.is_free, communicator);
  parallel::broadcast(basis.further, communicator);
  std::size_t common_with = basis.common_with.value_or(alone);
  parallel::broadcast(common_with, communicator);
  basis.common_with = common_with == alone ? std::nullopt : std::optional(common_with);
  Stretching& stretching = basis.stretching;
  for (auto* values :
       {&basis.frequencies, &basis.decay_rates, &basis.masses, &basis.residual, &basis.rest, &basis.rest_force,
        &basis.rest_stiffness, &stretching.linear, &stretching.quadratic, &stretching.rotation}) {
    parallel::broadcast(*values, communicator);
  }
  parallel::broadcast(basis.mass_damping, communicator);
  parallel::broadcast(basis.thickness, communicator);
}

}  // namespace

ModalBases broadcast(ModalBases bases, MPI_Comm communicator) {
  std::vector<std::size_t> bodies;
  for (const auto& [body, basis] : bases) {
    bodies.push_back(body);
  }
  parallel::broadcast(bodies, communicator);
  for (const std::size_t body : bodies) {
    broadcast(bases[body], communicator);
  }
  return bases;
}

void move_shapes(ModalBases& bases, const mesh::Part& part, MPI_Comm communicator) {
  for (auto& [body, basis] : bases) {
    const bool is_here = part.bodies[body].owned_begin < part.bodies[body].owned_end;
    const int owner = parallel::largest(is_here ? parallel::rank_of(communicator) : 0, communicator);
    if (owner == 0) {
      continue;
    }
    std::vector<int> counts(parallel::size_of(communicator));
    counts[owner] = parallel::is_root(communicator) ? static_cast<int>(basis.modes()) : 0;
    basis.shapes = parallel::exchange<double>(basis.shapes, counts, communicator, 3 * basis.nodes());
  }
}

}  // namespace idiophone::modal_bodies
